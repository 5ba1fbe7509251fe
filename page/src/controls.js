// SPDX-License-Identifier: Apache-2.0
// Hands what the reader does, by pointer or key, to the page.

import {HELP} from './panel.js';

const $ = id => document.getElementById(id);

/** Joins every control of the page to what it does. */
export function wire(page) {
  const choose = (id, act) => $(id).addEventListener('change', event => act(event.target.value));
  choose('camera', value => page.setCamera(value));
  choose('stretch', value => page.setStretch(value));
  const tick = (id, act) => $(id).addEventListener('change', event => act(event.target.checked));
  tick('gravity-down', isOn => page.setGravityDown(isOn));
  tick('follow', isOn => page.setFollowing(isOn));
  tick('show-gauges', isOn => page.showGauges(isOn));
  $('fit').addEventListener('click', () => page.scene?.fit());
  $('save').addEventListener('click', () => page.savePicture());
  choose('water-by', value => page.colourWater(value));
  choose('block-by', value => page.colourBlocks(value));
  $('contacts').addEventListener('change', event => page.setContacts(event.target.checked));
  $('time').addEventListener('input', event => { page.play(false); page.show(Number(event.target.value)); });
  $('play').addEventListener('click', () => page.play());
  $('theme').addEventListener('click', () => page.setTheme(page.theme === 'dark' ? 'light' : 'dark'));
  $('panel-button').addEventListener('click', () => page.togglePanel());
  $('help').innerHTML = HELP;
  $('help-button').addEventListener('click', () => $('help').showModal());
  $('tabs').addEventListener('click', event => event.target.dataset.tab && page.openTab(event.target.dataset.tab));
  let down = [0, 0];
  $('scene').addEventListener('pointerdown', event => { down = [event.clientX, event.clientY]; });
  $('scene').addEventListener('click', event => {
    if (Math.hypot(event.clientX - down[0], event.clientY - down[1]) < 4 && page.scene) {
      page.select(page.scene.bodyAt(event.clientX, event.clientY));
    }
  });
  $('warnings').addEventListener('click', () => page.openTab('run'));
  document.addEventListener('keydown', event => onKey(page, event));
  // After a click the keys belong to the scene again: space plays. A reader who moves by the tab key keeps the place.
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

/** Does what a key stands for, outside of controls that take it themselves. */
function onKey(page, event) {
  const isControl = event.target.matches('select, dialog *') || event.ctrlKey || event.metaKey || event.altKey;
  if (isControl || (event.key === ' ' && event.target.matches('button, summary, input[type=checkbox]'))) {
    return;
  }
  const next = (id, act) => {
    const options = [...$(id).options].map(o => o.value);
    act(options[(options.indexOf($(id).value) + 1) % options.length]);
  };
  const far = event.shiftKey ? 10 : 1;
  const move = to => { page.play(false); page.show(to); };
  const actions = {
    ' ': () => page.play(), 'ArrowLeft': () => move(page.index - far), 'ArrowRight': () => move(page.index + far),
    'Home': () => move(0), 'End': () => move(page.recording.frameCount - 1),
    '1': () => page.setCamera('corner'), '2': () => page.setCamera('front'), '3': () => page.setCamera('side'),
    '4': () => page.setCamera('top'), '[': () => page.step(-1), ']': () => page.step(1),
    'Escape': () => page.select(-1), 'c': () => page.setContacts(!$('contacts').checked),
    'w': () => next('water-by', v => page.colourWater(v)), 'b': () => next('block-by', v => page.colourBlocks(v)),
    'd': () => $('theme').click(), 'f': () => page.togglePanel(),
    'a': () => page.scene?.fit(), 't': () => page.setFollowing(!$('follow').checked), 'p': () => page.savePicture(),
    'g': () => page.setGravityDown(!$('gravity-down').checked), '?': () => $('help').showModal(),
  };
  const action = actions[event.key];
  if (action && (page.scene || !'ArrowLeft ArrowRight Home End'.includes(event.key))) {
    event.preventDefault();
    action();
  }
}
