// SPDX-License-Identifier: Apache-2.0
// Legends of the colours and bars in the scene.

import {MAPS, css, gradient} from './colours.js';
import {short} from './numbers.js';

function bar(label, map, low, high) {
  return `<figure><figcaption>${label}</figcaption><div style="background:${gradient(map)}"></div>` +
      `<span>${low}</span><span>${high}</span></figure>`;
}

/** Names of colours below a heading. */
function namesFigure(heading, names) {
  const figure = document.createElement('figure');
  figure.className = 'names';
  figure.innerHTML = `<figcaption>${heading}</figcaption>`;
  for (const [name, colour, style] of names) {
    const entry = document.createElement('span');
    const fill = style === 'hatched' ? `repeating-linear-gradient(135deg, ${css(colour)} 0 1px, transparent 1px 4px)` : css(colour);
    entry.innerHTML = `<i style="background:${fill}"></i>`;
    entry.append(name);  // of the case: a text, not markup
    figure.append(entry);
  }
  return figure;
}

export function showLegends(parent, {particles, surface, stillWater, porous, blocks, forces, isPlanar}) {
  parent.replaceChildren();
  const water = surface?.isOn ? surface.colour : stillWater ? stillWater.colour : undefined;
  const names = water === undefined ? [] : [[surface?.isOn ? 'surface' : 'still water', water]];
  if (porous) {
    names.push([porous.name, porous.colour, 'hatched']);
  }
  if (names.length > 0) {
    parent.append(namesFigure('water', names));
  }
  if (particles?.points.visible) {
    const {label, unit, low, high} = particles.range();
    parent.insertAdjacentHTML('beforeend', bar(`${label} [${unit}]`, MAPS.viridis, short(low), short(high)));
  }
  const range = blocks?.range();
  if (range) {
    parent.insertAdjacentHTML('beforeend', bar(`${range.label} [${range.unit}]`, MAPS.cividis, short(range.low ?? 0), short(range.high)));
  } else if (blocks) {
    parent.append(namesFigure('blocks', blocks.names()));
  }
  if (blocks?.stresses.group.visible) {
    parent.insertAdjacentHTML('beforeend', '<figure><figcaption>principal stresses [Pa]</figcaption>' +
        `<span>${short(blocks.stresses.most)} as wide as the block; orange pressure, blue tension</span></figure>`);
  }
  if (forces?.group.visible) {
    parent.insertAdjacentHTML('beforeend', `<figure><figcaption>contact force [${isPlanar ? 'N/m' : 'N'}]</figcaption><span class="bar"></span>` +
        `<span>longest bar ${short(forces.most)}</span></figure>`);
  }
}
