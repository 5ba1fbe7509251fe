// SPDX-License-Identifier: Apache-2.0
// The texts of the panel: one block, the case, where the run comes from.

import {wordsOf} from './blocks.js';
import {bodyOf, contactsOf} from './recording.js';
import {reading} from './numbers.js';

function element(tag, text = '', attributes = {}) {
  const node = document.createElement(tag);
  node.textContent = text;
  for (const [key, value] of Object.entries(attributes)) {
    node.setAttribute(key, value);
  }
  return node;
}

function rows(list) {
  const table = element('table');
  for (const [label, values, unit, field] of list) {
    const row = table.insertRow();
    row.append(element('th', label));
    for (const [k, value] of [values].flat().entries()) {
      row.append(element('td', value, field ? {'data-field': field + (Array.isArray(values) ? '.' + 'xyzw'[k] : '')} : {}));
    }
    row.append(element('td', unit ?? '', {class: 'unit'}));
  }
  return table;
}

/** A table that is too wide scrolls: no number is broken. */
function scrolling(table) {
  const box = element('div', '', {class: 'table'});
  box.append(table);
  return box;
}

const readings = values => [...values].map(v => reading(v));

export function showBody(parent, contents, frame, body) {
  parent.replaceChildren();
  if (body < 0 || !frame?.pose) {
    parent.append(element('p', contents.bodies ? 'Click a block, or walk through them with [ and ].' :
                                                 'The run shows no blocks.', {class: 'hint'}));
    return;
  }
  const b = bodyOf(contents, frame, body);
  const perWidth = unit => contents.is_planar ? unit + '/m' : unit;
  const [w, x, y, z] = b.orientation;
  const angle = 2 * Math.atan2(Math.hypot(x, y, z), Math.abs(w)) * 180 / Math.PI;
  parent.append(element('h2', b.name, {'data-field': 'name'}));
  parent.append(element('p', `body ${b.id}, ${b.isFree ? 'free' : 'fixed or driven'}`, {class: 'hint'}));
  const list = [
    ['position', readings(b.position), 'm', 'position'],
    ['velocity', readings(b.velocity), 'm/s', 'velocity'],
    ['angular velocity', readings(b.angularVelocity), 'rad/s', 'angular_velocity'],
    ['contact force', readings(b.contactForce), perWidth('N'), 'contact_force'],
  ];
  parent.append(scrolling(rows(list)));
  parent.append(rows([
    ['speed', reading(Math.hypot(...b.velocity)), 'm/s', 'speed'],
    ['turned by', reading(angle, 4), 'deg', 'angle'],
    ['mass', b.isFree || b.mass > 0 ? reading(b.mass) : 'fixed', b.mass > 0 ? perWidth('kg') : '', 'mass'],
  ]));
  if (b.shown.length > 0) {
    parent.append(scrolling(rows(b.shown.map(field => [wordsOf(field.name), reading(field.value), field.unit, field.name]))));
  }
  const contacts = contactsOf(frame, body);
  parent.append(element('h3', `${contacts.length} contact${contacts.length === 1 ? '' : 's'}`));
  if (contacts.length > 0) {
    const table = element('table');
    table.innerHTML = `<tr><th>with</th><th>force [${perWidth('N')}]</th><th>overlap [m]</th><th></th></tr>`;
    for (const contact of contacts.slice(0, 20)) {
      const row = table.insertRow();
      row.append(element('td', contents.bodies.names?.[contact.other] ?? `body ${contact.other}`),
                 element('td', reading(contact.force, 4)), element('td', reading(contact.overlap, 3)),
                 element('td', contact.isSliding ? 'slides' : 'sticks'));
    }
    parent.append(scrolling(table));
  }
}

const plural = (count, word) => `${count} ${word}${count === 1 ? '' : 's'}`;

export function showCase(parent, contents) {
  const set = contents.ticket?.set ?? [];
  if (set.length > 0) {
    const banner = element('div', '', {class: 'banner', role: 'note'}), list = element('ul');
    banner.append(element('strong', `${plural(set.length, 'key')} set by hand: the run used ${set.length === 1 ? 'this' : 'these'}, not what the file says`), list);
    for (const one of set) {
      const item = element('li');
      item.append(element('code', one.replace('=', ' = ')));
      list.append(item);
    }
    parent.append(banner);
  }
  for (const [name, text] of [['case.toml, as it was given', contents.case],
                              ['resolved.toml, with every default', contents.resolved]]) {
    const details = element('details');
    details.open = text === contents.case;
    details.append(element('summary', name), element('pre', text || 'not found in the run folder'));
    parent.append(details);
  }
}

const VERDICTS = {passed: 'met', failed: 'missed', not_judged: 'not judged'};

/** With the digits that tell its bounds apart. */
function bandText(low, high) {
  const text = digits => [low, high].map(v => typeof v === 'number' ? reading(v, digits) : 'none');
  const digits = [4, 6, 8, 10, 12, 15].find(n => low === high || text(n)[0] !== text(n)[1]) ?? 15;
  return text(digits).join(' to ');
}

function expectsTable(expects) {
  const table = element('table', '', {class: 'expects'});
  table.innerHTML = '<tr><th>expected</th><th>value</th><th>band</th><th></th></tr>';
  for (const e of expects) {
    const row = table.insertRow();
    const number = v => typeof v === 'number' ? reading(v, 4) : 'none';
    row.append(element('td', e.name, {title: e.citation ?? ''}), element('td', `${number(e.value)}\u00a0${e.unit ?? ''}`),
               element('td', bandText(e.low, e.high)),
               element('td', VERDICTS[e.verdict] ?? e.verdict, {class: `verdict ${e.verdict}`}));
  }
  return table;
}

export function showRun(parent, contents) {
  const summary = contents.summary ?? {}, ticket = contents.ticket ?? {};
  for (const [heading, texts] of [['What could not be shown', contents.notices],
                                  ['Warnings of the run', contents.warnings ?? []]]) {
    if (texts.length > 0) {
      const list = element('ul', '', {class: 'notices'});
      texts.forEach(text => list.append(element('li', text)));
      parent.append(element('h3', heading), list);
    }
  }
  if (summary.expects?.length > 0) {
    parent.append(element('h3', 'Expected answers'), scrolling(expectsTable(summary.expects)));
  }
  const build = summary.build ?? {}, machine = summary.machine ?? {};
  const known = [
    ['source', contents.source],
    ['status', [contents.status, summary.reason].filter(Boolean).join(': ')],
    ['simulated time', summary.time !== undefined ? reading(summary.time) : undefined, 's'],
    ['steps', summary.steps], ['last time step', summary.time_step && reading(summary.time_step, 4), 's'],
    ['wall time', summary.wall_seconds && reading(summary.wall_seconds, 4), 's'],
    ['iterations of the solver', summary.solver_iterations > 0 && summary.steps > 0 ?
        `${reading(summary.solver_iterations / summary.steps, 3)} a step, ${summary.solver_iterations_max} at most, ` +
        `residual ${reading(summary.solver_residual_max, 2)} at most` : undefined],
    ['bodies', summary.bodies], ['threads', summary.threads], ['times resumed', summary.resumes],
    ['hash of the final state', summary.state_hash], ['hash of the case', ticket.case_hash],
    ['keys set by hand', ticket.set?.join(', ')], ['Riprap', build.version ?? ticket.riprap],
    ['compiler', build.compiler && `${build.compiler}, ${build.build_type}, -march=${build.march}`],
    ['parallel', build.parallel], ['processor', machine.processor], ['system', machine.system],
    ['page made by', `Riprap ${contents.page_made_by}`],
  ].filter(([, value]) => value !== undefined && value !== '' && value !== null);
  parent.append(element('h3', 'Provenance'));
  const table = rows(known.map(([label, value, unit]) => [label, unit ? `${value}\u00a0${unit}` : String(value)]));
  table.className = 'wide';
  parent.append(table);
  if (contents.water) {
    const w = contents.water;
    parent.append(element('p', `${w.particles} particles of water${w.stride > 1 ? `, one in ${w.stride}` : ''}; ` +
        `each is drawn within ${reading(w.step / 2, 2)} m of where it was, along every axis. Blocks are exact.`,
        {class: 'hint'}));
  }
}

/** A button beside the title that leads to the warnings. */
export function showWarningCount(button, contents) {
  const count = contents.warnings?.length ?? 0;
  button.hidden = count === 0;
  button.textContent = plural(count, 'warning');
  button.title = 'what the run warned of, in the tab Run';
}

export const HELP = `
  <h2>Keys</h2>
  <table>
    <tr><th>space</th><td>play, pause</td></tr>
    <tr><th>&larr; &rarr;</th><td>one frame back, on; with shift ten</td></tr>
    <tr><th>home, end</th><td>first, last frame</td></tr>
    <tr><th>1 2 3 4</th><td>from a corner, the front, the side, above</td></tr>
    <tr><th>[ ]</th><td>select the block before, after, free ones first; escape lets go</td></tr>
    <tr><th>c</th><td>contact forces</td></tr>
    <tr><th>w</th><td>water: surface, pressure, speed, hidden</td></tr>
    <tr><th>b</th><td>blocks: material, speed, displacement, contact force</td></tr>
    <tr><th>a</th><td>see all that moves; t: go with it</td></tr>
    <tr><th>g</th><td>turn the scene with gravity, where gravity turns</td></tr>
    <tr><th>p</th><td>save the picture</td></tr>
    <tr><th>d</th><td>dark, light</td></tr>
    <tr><th>f</th><td>panel, or the whole width for the scene</td></tr>
    <tr><th>?</th><td>this list</td></tr>
  </table>
  <p>Drag turns the scene, the right button shifts it, the wheel comes closer. A click in a plot goes to that time, a drag in it zooms, a double click shows the whole time. The address holds time and view.</p>
  <form method="dialog"><button autofocus>close</button></form>`;
