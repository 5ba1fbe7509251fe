// SPDX-License-Identifier: Apache-2.0
// The address of the page holds time and view: a link leads to what its sender saw.

const PAUSE = 300;  // milliseconds between two changes of the address
const $ = id => document.getElementById(id);
const rounded = value => String(Number(value.toPrecision(6)));

export class Address {
  constructor(page) {
    this.page = page;
    this.isKept = false;
  }

  /** Shows what the address says, or the first frame. */
  async restore() {
    const said = new URLSearchParams(location.hash.slice(1)), {page} = this;
    await page.show(0);
    const allowed = (id, value) => value !== null && [...$(id).options].some(option => option.value === value);
    for (const [name, id, act] of [['water', 'water-by', v => page.colourWater(v)], ['blocks', 'block-by', v => page.colourBlocks(v)],
                                   ['heights', 'stretch', v => page.setStretch(v)], ['camera', 'camera', v => page.setCamera(v)]]) {
      if (allowed(id, said.get(name))) {
        act(said.get(name));
      }
    }
    if (said.get('gravity') === 'turns') {
      page.setGravityDown(false);
    }
    const time = Number(said.get('t'));
    if (said.has('t') && Number.isFinite(time)) {
      await page.goToTime(time);
    }
    const eye = (said.get('eye') ?? '').split(',').map(Number);
    if (page.scene && eye.length === 7 && eye.every(Number.isFinite)) {
      page.scene.eye = eye;
    }
  }

  /** From now on the address follows what is shown. */
  keep() {
    this.isKept = true;
  }

  note() {
    if (this.isKept && !this.waits && window.parent === window) {
      this.waits = setTimeout(() => this.#write(), PAUSE);
    }
  }

  #write() {
    this.waits = null;
    const {page} = this, {scene} = page;
    const said = new URLSearchParams({t: rounded(page.recording.times[page.index])});
    if (scene) {
      said.set('water', $('water-by').value);
      said.set('blocks', $('block-by').value);
      if (scene.stretch !== 1) {
        said.set('heights', scene.stretch);
      }
      if (scene.gravityAt && !scene.keepsGravityDown) {
        said.set('gravity', 'turns');
      }
      if (scene.preset) {
        said.set('camera', scene.preset);
      } else {
        said.set('eye', scene.eye.map(rounded).join(','));
      }
    }
    history.replaceState(null, '', '#' + said.toString().replaceAll('%2C', ','));
  }
}
