// SPDX-License-Identifier: Apache-2.0
// Directions of the axes and of gravity as the camera sees them, and a scale bar, drawn beside the legends.

import * as THREE from 'three';
import {short} from './numbers.js';

const ARM = 20;                   // pixels of an axis that lies in the picture
const MIDDLE = [30, 34];          // of the axes, in pixels
const BAR = {x: 100, y: 46};      // where the bar of the length begins
const LONGEST = 80;               // pixels of that bar
const AXES = [['x', '#c0392b'], ['y', '#2e8b57'], ['z', '#2f6fb3']];

/** The largest 1, 2 or 5 times a power of ten that is not above `value`. */
export function roundBelow(value) {
  const power = 10 ** Math.floor(Math.log10(value));
  return [5, 2, 1].map(k => k * power).find(v => v <= value * (1 + 1e-9)) ?? power;
}

function arrow([x, y], colour, label, [a, b] = MIDDLE) {
  const length = Math.hypot(x, y);
  if (length < 3) {  // it points at the eye or away from it
    return '';
  }
  const far = (length + 8) / length;
  return `<line x1="${a}" y1="${b}" x2="${a + x}" y2="${b + y}" stroke="${colour}" stroke-width="2" marker-end="url(#tip)"/>` +
      `<text x="${a + far * x}" y="${b + far * y}" fill="currentColor" text-anchor="middle" dominant-baseline="central">${label}</text>`;
}

/**
 * `pixelsPerMetre` holds at the middle of the scene; with perspective only there. `turn` is how the run is turned, `start` and
 * `gravity` are of the first and of this frame.
 */
export function drawCompass(svg, camera, turn, start, gravity, pixelsPerMetre) {
  if (!(pixelsPerMetre > 0)) {  // the page has no height yet
    return;
  }
  const toCamera = camera.quaternion.clone().invert().multiply(turn);
  const seen = vector => {
    const v = new THREE.Vector3(...vector).normalize().applyQuaternion(toCamera);
    return [ARM * v.x, -ARM * v.y];
  };
  const g = Math.hypot(...gravity), angle = new THREE.Vector3(...gravity).angleTo(new THREE.Vector3(...start)) * 180 / Math.PI;
  const turned = g > 0 && angle > 0.05 ? `, ${angle.toFixed(1)}\u00b0` : '';
  const length = roundBelow(LONGEST / pixelsPerMetre), pixels = length * pixelsPerMetre;
  const {x, y} = BAR;
  svg.innerHTML = '<defs><marker id="tip" viewBox="0 0 6 6" refX="3" refY="3" markerWidth="4" markerHeight="4" orient="auto">' +
      '<path d="M0 0L6 3L0 6Z" fill="context-stroke"/></marker></defs>' +
      AXES.map(([name, colour], k) => arrow(seen([0, 1, 2].map(i => i === k ? 1 : 0)), colour, name)).join('') +
      (g > 0 ? arrow(seen(gravity), 'currentColor', '', [76, 24]) +
               `<text x="88" y="20" fill="currentColor">g = ${short(g)} m/s\u00b2${turned}</text>` : '') +
      `<path d="M${x} ${y - 4}V${y + 4}M${x} ${y}H${x + pixels}M${x + pixels} ${y - 4}V${y + 4}" stroke="currentColor" fill="none"/>` +
      `<text x="${x + pixels / 2}" y="${y - 5}" fill="currentColor" text-anchor="middle">${short(length)} m</text>`;
}
