// SPDX-License-Identifier: Apache-2.0
// Two to nine runs side by side: each in a frame of its own, with this page's program, under one clock and one view.

import {reading} from './numbers.js';

const $ = id => document.getElementById(id);
const LENGTH = 8;  // seconds from the first time to the last, at pace 1
const STEPS = 1000;
const PAUSE = 300; // milliseconds between two changes of the address
const ALIKE = 4;   // sizes of runs up to which they are drawn to one scale

/** The page of one of the runs, from the parts of this one. */
function pageOf(run) {
  const scripts = [...document.querySelectorAll('script[type="application/x-riprap"]')].filter(s => s.id.startsWith(`run${run}.`));
  const text = scripts.map(s => `<script type="application/x-riprap" id="${s.id.slice(`run${run}.`.length)}">${s.textContent}</script>`);
  scripts.forEach(s => s.remove());
  return text.join('\n');
}

function shell() {
  const code = document.querySelector('script[type=module]');
  const body = [...document.body.children].filter(one => !one.matches('script')).map(one => one.outerHTML).join('');
  return scripts => `<!doctype html><html lang="en"><head>${document.head.innerHTML}</head><body>${body}` +
      `${scripts}<script type="module">${code.textContent}</script></body></html>`;
}

class Comparison {
  constructor(names) {
    this.names = names;
    this.isPlaying = false;
    document.title = $('title').textContent = names.join(', ');
    $('status').textContent = `${names.length} runs`;
  }

  async open() {
    const page = shell();
    document.querySelectorAll('header label, #warnings, #panel-button').forEach(one => { one.hidden = true; });
    const grid = document.createElement('main');
    grid.id = 'runs';
    grid.style.gridTemplateColumns = `repeat(${Math.ceil(Math.sqrt(this.names.length))}, minmax(0, 1fr))`;
    document.querySelector('main').replaceWith(grid);
    this.runs = await Promise.all(this.names.map((name, k) => this.#add(grid, name, page(pageOf(k)))));
    const times = this.runs.flatMap(run => run.times);
    [this.first, this.last] = [Math.min(...times), Math.max(...times)];
    this.#useOneScale();
    this.#wire();
    this.setTheme(matchMedia('(prefers-color-scheme: dark)').matches ? 'dark' : 'light');
    await this.#restore();
    this.isOpen = true;
  }

  /** Shows what the address says: time and view, as of the page of one run. */
  async #restore() {
    const said = new URLSearchParams(location.hash.slice(1)), time = Number(said.get('t') ?? 'none');
    const eye = (said.get('eye') ?? '').split(',').map(Number);
    if (eye.length === 7 && eye.every(Number.isFinite)) {
      this.runs.forEach(({riprap}) => riprap.scene && (riprap.scene.eye = eye));
    }
    await this.show(Number.isFinite(time) ? Math.min(Math.max(time, this.first), this.last) : this.first);
  }

  #note() {
    if (!this.isOpen || this.waits) {
      return;
    }
    this.waits = setTimeout(() => {
      this.waits = null;
      const rounded = value => String(Number(value.toPrecision(6))), scene = this.runs.map(({riprap}) => riprap.scene).find(Boolean);
      const said = new URLSearchParams({t: rounded(this.time)});
      if (scene && !scene.preset) {
        said.set('eye', scene.eye.map(rounded).join(','));
      }
      history.replaceState(null, '', '#' + said.toString().replaceAll('%2C', ','));
    }, PAUSE);
  }

  async #add(grid, name, html) {
    const figure = document.createElement('figure'), caption = document.createElement('figcaption');
    const heading = document.createElement('b'), about = document.createElement('span'), frame = document.createElement('iframe');
    heading.textContent = name;
    caption.append(heading, about);
    frame.title = name;
    frame.srcdoc = html;
    figure.append(caption, frame);
    grid.append(figure);
    await new Promise(resolve => frame.addEventListener('load', resolve, {once: true}));
    const page = frame.contentWindow;
    while (!page.riprap) {
      if (page.document.documentElement.dataset.failed) {
        throw new Error(`${name}: ${page.document.documentElement.dataset.failed}`);
      }
      await new Promise(resolve => setTimeout(resolve, 20));
    }
    await page.riprap.opened;
    const missed = (page.riprap.contents.summary?.expects ?? []).filter(e => e.verdict === 'failed').length;
    about.title = page.riprap.contents.title;
    about.dataset.status = [page.riprap.contents.status, missed > 0 ? `${missed} missed` : ''].filter(Boolean).join(', ');
    page.riprap.onView = () => this.#turned(page.riprap);
    return {riprap: page.riprap, times: page.riprap.times, about};
  }

  /** Shows the same part of space in every run, unless they are of very different sizes. */
  #useOneScale() {
    const scenes = this.runs.map(({riprap}) => riprap.scene).filter(Boolean), sizes = scenes.map(scene => scene.size);
    if (scenes.length > 1 && Math.max(...sizes) < ALIKE * Math.min(...sizes)) {
      const all = scenes.reduce((box, scene) => box.union(scene.box), scenes[0].box.clone());
      scenes.forEach(scene => scene.frameOn(all.clone()));
    }
  }

  /** One eye for all: who turns one scene turns the others. Runs of other sizes keep their distances. */
  #turned(who) {
    if (this.isTurning || !who.scene || who.scene.preset) {
      return;
    }
    this.isTurning = true;
    for (const {riprap} of this.runs ?? []) {
      if (riprap !== who && riprap.scene) {
        riprap.scene.eye = who.scene.eye;
      }
    }
    requestAnimationFrame(() => { this.isTurning = false; });
    this.#note();
  }

  async show(time) {
    this.time = time;
    $('time').value = this.last > this.first ? (time - this.first) / (this.last - this.first) * STEPS : 0;
    $('clock').textContent = `t = ${reading(time, 4)} s`;
    await Promise.all(this.runs.map(async ({riprap, times, about}) => {
      await riprap.showTime(time);
      const isOver = time > times.at(-1) * (1 + 1e-9);
      about.textContent = [about.dataset.status, isOver ? `ended at ${reading(times.at(-1), 4)} s` : ''].filter(Boolean).join(', ');
    }));
    this.#note();
  }

  setTheme(theme) {
    this.theme = document.documentElement.dataset.theme = theme;
    this.runs.forEach(({riprap}) => riprap.picture(theme, true));
  }

  play(isPlaying = !this.isPlaying) {
    this.isPlaying = isPlaying;
    $('play').innerHTML = isPlaying ? '&#10074;&#10074;' : '&#9654;';
    $('play').setAttribute('aria-label', isPlaying ? 'pause' : 'play');
    if (!isPlaying) {
      return;
    }
    let at = this.time >= this.last ? this.first : this.time, before = performance.now();
    const tick = async now => {
      if (!this.isPlaying) {
        return;
      }
      at = Math.min(at + Math.min(now - before, 200) / 1000 * (this.last - this.first) / LENGTH * Number($('pace').value), this.last);
      before = now;
      await this.show(at);
      before = Math.max(before, performance.now() - 40);
      if (at >= this.last) {
        this.play(false);
      } else {
        requestAnimationFrame(tick);
      }
    };
    requestAnimationFrame(tick);
  }

  #wire() {
    $('time').max = STEPS;
    $('time').addEventListener('input', event => {
      this.play(false);
      this.show(this.first + event.target.value / STEPS * (this.last - this.first));
    });
    $('play').addEventListener('click', () => this.play());
    $('theme').addEventListener('click', () => this.setTheme(this.theme === 'dark' ? 'light' : 'dark'));
    $('help').innerHTML = '<p>Drag turns all scenes, space plays. Each run is shown at the frame nearest to the clock.</p>' +
        '<form method="dialog"><button autofocus>close</button></form>';
    $('help-button').addEventListener('click', () => $('help').showModal());
    for (const [id, act] of [['camera', v => r => r.camera(v)], ['water-by', v => r => r.choose({water: v, contacts: false})],
                             ['block-by', v => r => r.choose({blocks: v, contacts: false})]]) {
      $(id).closest('label').hidden = false;
      $(id).addEventListener('change', event => this.runs.forEach(({riprap}) => act(event.target.value)(riprap)));
    }
    $('camera').value = this.runs[0].riprap.scene?.preset ?? 'corner';
    document.querySelector('footer label').hidden = false;
    document.addEventListener('keydown', event => {
      if (event.key === ' ' && !event.target.matches('select, button, input, dialog *')) {
        event.preventDefault();
        this.play();
      }
    });
    for (const option of $('pace').options) {
      option.textContent = `${reading(option.value * (this.last - this.first) / LENGTH, 2)} s of the runs per second`;
    }
  }
}

export async function compareRuns() {
  const page = new Comparison(JSON.parse($('compared').textContent));
  await page.open();
  window.riprap = {compared: page.names, runs: page.runs, show: time => page.show(time), theme: theme => page.setTheme(theme),
                   get time() { return page.time; }};
  document.documentElement.dataset.opened = Math.round(performance.now());
}
