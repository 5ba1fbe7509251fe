// SPDX-License-Identifier: Apache-2.0
// Where the gauges of the run are: a pole for a level, a line for a surface, a cross for what is measured at a point.

import * as THREE from 'three';

const CROSS = 0.012;      // of the size of the scene, half of it
const MOST_LABELS = 16;

/** Ends of the lines of one gauge. */
function linesOf({kind, point, end}, up, box, size) {
  const a = new THREE.Vector3(...point);
  if (kind === 'volume') {
    return [];
  }
  if (end) {
    return [a, new THREE.Vector3(...end)];
  }
  if (kind === 'level') {
    const along = (corner, by) => a.clone().addScaledVector(up, corner.dot(up) - a.dot(up) + by);
    const [low, high] = [box.min, box.max].sort((p, q) => p.dot(up) - q.dot(up));
    return [along(low, 0), along(high, 0.02 * size)];
  }
  return [0, 1, 2].flatMap(axis => [-1, 1].map(sign => a.clone().add(new THREE.Vector3().setComponent(axis, sign * CROSS * size))));
}

export class Gauges {
  constructor(contents, labels, up, box, size) {
    this.labels = labels;
    this.group = new THREE.Group();
    this.tops = [];
    const points = [];
    for (const gauge of contents.gauges ?? []) {
      const lines = linesOf(gauge, up, box, size);
      if (lines.length > 0) {
        points.push(...lines);
        this.tops.push([gauge.name, lines.reduce((a, b) => b.dot(up) > a.dot(up) ? b : a)]);
      }
    }
    this.material = new THREE.LineBasicMaterial({color: 0xb8410f, transparent: true, opacity: 0.85, depthTest: false});
    const lines = new THREE.LineSegments(new THREE.BufferGeometry().setFromPoints(points), this.material);
    lines.frustumCulled = false;
    lines.renderOrder = 3;
    this.group.add(lines);
    labels.replaceChildren(...this.tops.slice(0, MOST_LABELS).map(([name]) => {
      const label = document.createElement('span');
      label.textContent = name;
      return label;
    }));
  }

  get count() {
    return this.tops.length;
  }

  setTheme(theme) {
    this.material.color.set(theme === 'dark' ? 0xff8a5c : 0xb8410f);
  }

  /** Puts the names beside their gauges; of names that would lie on each other only the first is shown. */
  place(toPixel) {
    this.labels.hidden = !this.group.visible;
    if (this.labels.hidden) {
      return;
    }
    const taken = [], {clientWidth: width, clientHeight: height} = this.labels;
    [...this.labels.children].forEach((label, k) => {
      const [x, y] = toPixel(this.tops[k][1]), right = x + 7 * label.textContent.length;
      const left = Math.min(x + 3, width - 7 * label.textContent.length), top = Math.max(y - 14, 0);
      const isFree = x > 0 && x < width && y > -20 && y < height &&
          !taken.some(([a, b, t]) => left < b && right > a && Math.abs(t - top) < 13);
      label.hidden = !isFree;
      if (isFree) {
        taken.push([left, right, top]);
        label.style.transform = `translate(${left}px, ${top}px)`;
      }
    });
  }
}
