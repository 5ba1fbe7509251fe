// SPDX-License-Identifier: Apache-2.0
// One run on a page: one time for the scene, the plots and the block that is selected.

import {Address} from './address.js';
import {wordsOf} from './blocks.js';
import {drawCompass} from './compass.js';
import {wire} from './controls.js';
import {showLegends} from './legends.js';
import {giveUp, note} from './marks.js';
import {reading} from './numbers.js';
import {showBody, showCase, showRun, showWarningCount} from './panel.js';
import {Plots} from './plots.js';
import {MOTION_VALUES as MOTION, Recording} from './recording.js';
import {save} from './save.js';
import {Scene} from './scene.js';

const $ = id => document.getElementById(id);
const FRAMES_PER_SECOND = 30;
const LONGEST_PLAY = 12, SHORTEST_PLAY = 4;  // seconds from the first frame to the last at pace 1

export class Page {
  constructor(contents) {
    this.contents = contents;
    this.recording = new Recording(contents);
    this.index = 0;
    this.wanted = 0;
    this.selected = -1;
    this.isPlaying = false;
    this.address = new Address(this);
    document.title = $('title').textContent = contents.title || 'Riprap';
    $('title').title = contents.source ?? '';
    $('status').textContent = contents.status;
    $('status').className = contents.status.replace(' ', '-');
  }

  async open() {
    const {contents, recording} = this;
    const lost = contents.chunks.filter(name => !document.getElementById(name));
    if (lost.length > 0) {
      contents.notices.unshift(`This file was cut: ${lost.length} of ${contents.chunks.length} pieces are missing.`);
    }
    showCase($('tab-case'), contents);
    showRun($('tab-run'), contents);
    showWarningCount($('warnings'), contents);
    showBody($('tab-body'), contents, null, -1);
    wire(this);
    this.openTab(contents.notices.length > 0 || recording.frameCount === 0 ? 'run' : 'plots');
    this.setTheme(matchMedia('(prefers-color-scheme: dark)').matches ? 'dark' : 'light');
    if (contents.notices.length > 0) {
      $('trouble').textContent = contents.notices[0];
    }
    if (recording.frameCount > 0) {
      await this.#openScene();
      await this.address.restore();
      this.#legends();
    } else {
      $('trouble').textContent = 'The run has no frames to show. ' + (contents.notices[0] ?? '');
    }
    const tables = await Promise.all(contents.tables.map(t => recording.table(t)));
    this.plots = new Plots($('tab-plots'), tables, contents.summary?.expects ?? [], contents.gauges ?? [], time => this.goToTime(time));
    this.plots.at(recording.times[this.index] ?? 0);
    this.address.keep();
    recording.loadAll().then(() => note('loaded'), error => {
      $('trouble').textContent ||= `Not every frame can be shown: ${error.message}`;
    });
  }

  async #openScene() {
    const {contents, recording} = this;
    const last = recording.frameCount - 1;
    const [shapes, first] = [await recording.shapes(), await recording.frame(0)];
    $('time').max = last;
    if (last > 0) {
      this.#namePaces();
    }
    $('water-choice').hidden = !contents.water;
    $('block-choice').hidden = !contents.bodies;
    for (const {name} of contents.bodies?.shown ?? []) {
      $('block-by').add(new Option(wordsOf(name), name));
    }
    $('contact-choice').hidden = !contents.contacts.some(count => count > 0);
    try {
      this.scene = new Scene($('scene'), $('gauges'), contents, shapes, first);
    } catch (error) {  // no WebGL, say; plots and readings work without
      giveUp(`The scene cannot be drawn: ${error.message}`);
      return;
    }
    this.scene.onView = (camera, scale, axes, gravity) => {
      drawCompass($('compass'), camera, axes, contents.gravity, gravity, scale);
      this.address.note();
      this.onView?.();
    };
    $('gravity-choice').hidden = !contents.gravity_at;
    $('stretch-choice').hidden = !this.scene.isLong;
    $('gauges-choice').hidden = this.scene.gauges.count === 0;
    this.scene.setTheme(this.theme);
    this.scene.showWater($('water-by').value);
    $('camera').value = this.scene.preset;
    requestAnimationFrame(() => requestAnimationFrame(() => note('drawn')));  // the second one follows the picture
  }

  /** Shows one frame; of several asked for in a hurry the last one wins. */
  async show(index) {
    const {recording} = this;
    this.wanted = Math.min(Math.max(Math.round(index), 0), recording.frameCount - 1);
    const wanted = this.wanted;
    let frame;
    try {
      frame = await recording.frame(wanted);
    } catch (error) {
      $('trouble').textContent = `Frame ${wanted + 1} cannot be shown: ${error.message}`;
      return;
    }
    if (wanted !== this.wanted) {
      return;
    }
    this.index = wanted;
    this.frame = frame;
    this.scene?.show(frame, wanted);
    $('time').value = wanted;
    const time = reading(frame.time, 5), clock = `t = ${time} s`;
    $('clock').textContent = `${clock}  (${wanted + 1} of ${recording.frameCount})`;
    $('caption').textContent = `${this.contents.title}   ${clock}`;
    $('time').setAttribute('aria-valuetext', clock);
    this.plots?.at(frame.time);
    this.address.note();
    this.onTime?.(frame.time);
    if (this.selected >= 0) {
      showBody($('tab-body'), this.contents, frame, this.selected);
    }
  }

  goToTime(time) {
    const {times} = this.recording;
    let best = 0;
    times.forEach((t, k) => { best = Math.abs(t - time) < Math.abs(times[best] - time) ? k : best; });
    return this.show(best);
  }

  play(isPlaying = !this.isPlaying) {
    if (isPlaying === this.isPlaying || this.recording.frameCount < 2) {
      return;
    }
    this.isPlaying = isPlaying;
    $('play').innerHTML = isPlaying ? '&#10074;&#10074;' : '&#9654;';
    $('play').setAttribute('aria-label', isPlaying ? 'pause' : 'play');
    if (isPlaying) {
      this.#run(this.index === this.recording.frameCount - 1 ? 0 : this.index);
    }
  }

  #run(from) {
    const {frameCount} = this.recording;
    const seconds = this.#length;
    let at = from, before = performance.now();
    const tick = async now => {
      if (!this.isPlaying) {
        return;
      }
      // A page in the background, or a group that is still being unpacked, may not make the play jump.
      at += Math.min(now - before, 200) / 1000 * (frameCount - 1) / seconds * Number($('pace').value);
      before = now;
      const index = Math.min(Math.floor(at), frameCount - 1);
      if (index !== this.index) {
        await this.show(index);
        before = Math.max(before, performance.now() - 40);
      }
      if (index === frameCount - 1) {
        this.play(false);
      } else {
        requestAnimationFrame(tick);
      }
    };
    requestAnimationFrame(tick);
  }

  select(body) {
    this.selected = body;
    if (this.scene?.blocks) {
      this.scene.blocks.selected = body;
      this.scene.blocks.paint();
      this.scene.redraw();
    }
    showBody($('tab-body'), this.contents, this.frame, body);
    if (body >= 0) {
      this.openTab('body');
    }
  }

  step(by) {
    const bodies = [...Array(this.recording.bodyCount).keys()];
    const isFree = body => this.frame?.motion[MOTION * body + 9] > 0;
    const order = [...bodies.filter(isFree), ...bodies.filter(body => !isFree(body))], count = order.length;
    if (count > 0) {
      const at = order.indexOf(this.selected);
      this.select(order[((at < 0 ? (by > 0 ? -1 : 0) : at) + by + count) % count]);
    }
  }

  /** Seconds from the first frame to the last, at pace 1. */
  get #length() {
    return Math.min(Math.max(this.recording.frameCount / FRAMES_PER_SECOND, SHORTEST_PLAY), LONGEST_PLAY);
  }

  /** Paces as seconds of the run that pass in one second. */
  #namePaces() {
    const {times} = this.recording, span = times.at(-1) - times[0];
    for (const option of $('pace').options) {
      option.textContent = `${reading(option.value * span / this.#length, 2)} s of the run per second`;
    }
  }

  openTab(name) {
    for (const button of $('tabs').children) {
      const isOpen = button.dataset.tab === name;
      button.setAttribute('aria-selected', isOpen);
      $(`tab-${button.dataset.tab}`).hidden = !isOpen;
    }
    if (name === 'plots') {
      this.plots?.draw();
    }
  }

  setTheme(theme) {
    this.theme = document.documentElement.dataset.theme = theme;
    this.scene?.setTheme(theme);
    this.plots?.draw();
  }

  setContacts(isOn) {
    if (this.scene?.forces) {
      $('contacts').checked = isOn;
      this.scene.forces.group.visible = isOn;
      this.scene.blocks.setGlass(isOn);
      this.#legends();
      this.scene.redraw();
    }
  }

  colourWater(by) {
    if (this.scene?.particles) {
      $('water-by').value = by;
      this.scene.showWater(by);
      this.#legends();
    }
  }

  colourBlocks(by) {
    if (this.scene?.blocks) {
      $('block-by').value = by;
      this.scene.blocks.colourBy = by;
      this.scene.blocks.paint();
      this.#legends();
      this.scene.redraw();
    }
  }

  setCamera(name) {
    $('camera').value = name;
    this.scene?.setPreset(name);
  }

  setGravityDown(isOn) {
    $('gravity-down').checked = isOn;
    this.scene?.setGravityDown(isOn);
  }

  setStretch(factor) {
    $('stretch').value = String(factor);
    this.scene?.setStretch(Number(factor));
  }

  setFollowing(isOn) {
    $('follow').checked = isOn;
    this.scene?.setFollowing(isOn, this.frame);
  }

  showGauges(isOn) {
    $('show-gauges').checked = isOn;
    if (this.scene) {
      this.scene.gauges.group.visible = isOn;
      this.scene.redraw();
    }
  }

  /** The scene as a picture of the reader's own. */
  savePicture() {
    this.scene?.draw();  // read before the browser gives the buffer away
    const time = reading(this.recording.times[this.index], 4);
    $('scene').toBlob(blob => blob && save(`${(this.contents.title || 'riprap').replace(/[^\w]+/g, '_')}_${time}s.png`, blob));
  }

  #legends() {
    if (this.scene && this.frame) {
      showLegends($('legends'), this.scene);
    }
  }

  togglePanel() {
    document.body.classList.toggle('wide');
    this.scene?.resize();
  }
}
