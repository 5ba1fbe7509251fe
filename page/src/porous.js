// SPDX-License-Identifier: Apache-2.0
// Stones that water flows through, in a planar scene: hatched, as on drawings.

import * as THREE from 'three';

const PITCH = 0.012;  // of the size of the scene, between hatches
const COLOUR = {light: 0x5a4a32, dark: 0xd8c6a0};

/** Where the line x - y = c meets the sides of a polygon, in order along it. */
function crossings(corners, c) {
  const value = ([x, y]) => x - y - c;
  return corners.flatMap((a, k) => {
    const b = corners[(k + 1) % corners.length], at = value(a), to = value(b);
    if ((at < 0) === (to < 0)) {
      return [];
    }
    const t = at / (at - to);
    return [[a[0] + t * (b[0] - a[0]), a[1] + t * (b[1] - a[1])]];
  }).sort((p, q) => p[0] - q[0]);
}

/** Ends of hatches at 45 degrees inside of a polygon, two by two. */
export function hatch(corners, pitch) {
  const shares = corners.map(([x, y]) => x - y), step = pitch * Math.SQRT2, ends = [];
  for (let k = Math.ceil(Math.min(...shares) / step); k * step < Math.max(...shares); ++k) {
    const met = crossings(corners, k * step);
    ends.push(...met.slice(0, met.length - met.length % 2));
  }
  return ends;
}

export class PorousZones {
  constructor(zones, size) {
    const places = zones.flatMap(({corners}) => {
      const sides = corners.flatMap((corner, k) => [corner, corners[(k + 1) % corners.length]]);
      return [...sides, ...hatch(corners, PITCH * size)];
    });
    this.material = new THREE.LineBasicMaterial({transparent: true, opacity: 0.55, depthTest: false});
    this.lines = new THREE.LineSegments(
        new THREE.BufferGeometry().setFromPoints(places.map(([x, y]) => new THREE.Vector3(x, y, 0))), this.material);
    this.lines.frustumCulled = false;
    this.lines.renderOrder = 2;
    this.setTheme('light');
    const shares = [...new Set(zones.map(({porosity}) => porosity))];
    this.name = `porous, ${shares.map(share => `${Math.round(100 * share)} %`).join(', ')} voids`;
  }

  setTheme(theme) {
    this.colour = COLOUR[theme];
    this.material.color.set(this.colour);
  }
}
