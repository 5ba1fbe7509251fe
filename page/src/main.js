// SPDX-License-Identifier: Apache-2.0
// Joins the parts: one time for the scene, the plots and the block that is selected.

import './style.css';
import {wordsOf} from './blocks.js';
import {compareRuns} from './compare.js';
import {drawCompass} from './compass.js';
import {showLegends} from './legends.js';
import {reading} from './numbers.js';
import {HELP, showBody, showCase, showRun, showWarningCount} from './panel.js';
import {Address} from './address.js';
import {Plots} from './plots.js';
import {MOTION_VALUES as MOTION, Recording, readContents} from './recording.js';
import {save} from './save.js';
import {Scene} from './scene.js';

const $ = id => document.getElementById(id);
const FRAMES_PER_SECOND = 30;
const LONGEST_PLAY = 12, SHORTEST_PLAY = 4;  // seconds from the first frame to the last at pace 1

/** What is done so far, for tests and for `riprap render`: a mark, and the milliseconds since the page was asked for. */
function note(name) {
  document.documentElement.dataset[name] = Math.round(performance.mark(name).startTime);
}

/** Says what cannot be shown, to the reader and to `riprap render`. */
function giveUp(why) {
  $('trouble').textContent = why;
  document.documentElement.dataset.failed = why;
}

class Page {
  constructor(contents) {
    this.contents = contents;
    this.recording = new Recording(contents);
    this.index = 0;
    this.wanted = 0;
    this.selected = -1;
    this.isPlaying = false;
    this.address = new Address(this);
    document.title = $('title').textContent = contents.title || 'Riprap';
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
    this.#wire();
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
    this.plots = new Plots($('tab-plots'), tables, contents.summary?.expects ?? [], time => this.goToTime(time));
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

  #wire() {
    const choose = (id, act) => $(id).addEventListener('change', event => act(event.target.value));
    choose('camera', value => this.setCamera(value));
    choose('stretch', value => this.setStretch(value));
    const tick = (id, act) => $(id).addEventListener('change', event => act(event.target.checked));
    tick('gravity-down', isOn => this.setGravityDown(isOn));
    tick('follow', isOn => this.setFollowing(isOn));
    tick('show-gauges', isOn => this.showGauges(isOn));
    $('fit').addEventListener('click', () => this.scene?.fit());
    $('save').addEventListener('click', () => this.savePicture());
    choose('water-by', value => this.colourWater(value));
    choose('block-by', value => this.colourBlocks(value));
    $('contacts').addEventListener('change', event => this.setContacts(event.target.checked));
    $('time').addEventListener('input', event => { this.play(false); this.show(Number(event.target.value)); });
    $('play').addEventListener('click', () => this.play());
    $('theme').addEventListener('click', () => this.setTheme(this.theme === 'dark' ? 'light' : 'dark'));
    $('panel-button').addEventListener('click', () => this.#togglePanel());
    $('help').innerHTML = HELP;
    $('help-button').addEventListener('click', () => $('help').showModal());
    $('tabs').addEventListener('click', event => event.target.dataset.tab && this.openTab(event.target.dataset.tab));
    let down = [0, 0];
    $('scene').addEventListener('pointerdown', event => { down = [event.clientX, event.clientY]; });
    $('scene').addEventListener('click', event => {
      if (Math.hypot(event.clientX - down[0], event.clientY - down[1]) < 4 && this.scene) {
        this.select(this.scene.bodyAt(event.clientX, event.clientY));
      }
    });
    $('warnings').addEventListener('click', () => this.openTab('run'));
    document.addEventListener('keydown', event => this.#key(event));
    // After a click the keys belong to the scene again: space plays. Who goes by the tab key keeps the place.
    let isPointed = false;
    document.addEventListener('pointerdown', () => { isPointed = true; });
    document.addEventListener('keydown', () => { isPointed = false; }, true);
    document.addEventListener('click', () => {
      const {activeElement} = document;
      if (isPointed && activeElement?.matches('button, summary, input') && !activeElement.closest('dialog')) {
        activeElement.blur();
      }
    });
  }

  #togglePanel() {
    document.body.classList.toggle('wide');
    this.scene?.resize();
  }

  #key(event) {
    const isControl = event.target.matches('select, dialog *') || event.ctrlKey || event.metaKey || event.altKey;
    if (isControl || (event.key === ' ' && event.target.matches('button, summary, input[type=checkbox]'))) {
      return;
    }
    const next = (id, act) => {
      const options = [...$(id).options].map(o => o.value);
      act(options[(options.indexOf($(id).value) + 1) % options.length]);
    };
    const far = event.shiftKey ? 10 : 1;
    const move = to => { this.play(false); this.show(to); };
    const actions = {
      ' ': () => this.play(), 'ArrowLeft': () => move(this.index - far), 'ArrowRight': () => move(this.index + far),
      'Home': () => move(0), 'End': () => move(this.recording.frameCount - 1),
      '1': () => this.setCamera('corner'), '2': () => this.setCamera('front'), '3': () => this.setCamera('side'),
      '4': () => this.setCamera('top'), '[': () => this.step(-1), ']': () => this.step(1),
      'Escape': () => this.select(-1), 'c': () => this.setContacts(!$('contacts').checked),
      'w': () => next('water-by', v => this.colourWater(v)), 'b': () => next('block-by', v => this.colourBlocks(v)),
      'd': () => $('theme').click(), 'f': () => this.#togglePanel(),
      'a': () => this.scene?.fit(), 't': () => this.setFollowing(!$('follow').checked), 'p': () => this.savePicture(),
      'g': () => this.setGravityDown(!$('gravity-down').checked), '?': () => $('help').showModal(),
    };
    const action = actions[event.key];
    if (action && (this.scene || !'ArrowLeft ArrowRight Home End'.includes(event.key))) {
      event.preventDefault();
      action();
    }
  }
}

/** What `riprap render` and the tests drive the page by. */
function remote(page, opened) {
  return {
    opened,
    get frameCount() { return page.recording.frameCount; },
    get times() { return page.recording.times; },
    get index() { return page.index; },
    get blockColours() { return [...$('block-by').options].map(option => option.value); },
    get scene() { return page.scene; },
    get contents() { return page.contents; },
    set onView(act) { page.onView = act; },
    stretch: factor => page.setStretch(factor),
    gauges: isOn => page.showGauges(isOn),
    get recording() { return page.recording; },
    show: index => page.show(index),
    showTime: time => page.goToTime(time),
    select: body => page.select(body),
    camera: name => page.setCamera(name),
    theme: theme => page.setTheme(theme),
    /** Stops of a camera: names of views or addresses of the page; returns what is wrong with one of them. */
    stops: list => {
      page.stops = [];
      for (const stop of list) {
        const said = new URLSearchParams(stop.replace(/^.*#/, '')), eye = (said.get('eye') ?? '').split(',').map(Number);
        const name = stop === '' ? $('camera').value : said.get('camera') ?? stop;
        if (eye.length === 7 && eye.every(Number.isFinite)) {
          page.stops.push(eye);
        } else if ([...$('camera').options].some(option => option.value === name)) {
          page.setCamera(name);
          page.stops.push(page.scene?.eye);
        } else {
          return `there is no view '${stop}'; allowed: ${[...$('camera').options].map(o => o.value).join(', ')}, or an address of the page`;
        }
      }
      return null;
    },
    travel: share => page.stops.length > 0 && page.scene?.travel(page.stops, share),
    /** What is drawn and coloured how; an empty choice leaves what is. */
    choose: ({water, blocks, contacts}) => {
      if (water) {
        page.colourWater(water);
      }
      if (blocks) {
        page.colourBlocks(blocks);
      }
      page.setContacts(contacts);
    },
    /** Only the scene, its caption and its legends. */
    picture: async (theme, isPart = false) => {
      document.body.classList.add(isPart ? 'part' : 'picture');
      page.setTheme(theme);
      page.scene?.resize();
    },
  };
}

async function openRun() {
  const page = new Page(readContents());
  const opened = page.open();
  window.riprap = remote(page, opened);
  await opened;
  note('opened');
}

try {
  await ($('compared') ? compareRuns() : openRun());
} catch (error) {
  giveUp(`This page cannot be shown: ${error.message}`);
  throw error;
}
