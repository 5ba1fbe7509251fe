// SPDX-License-Identifier: Apache-2.0
// Water that stands still, as far as the scene reaches: a box up to the level of each frame.

import * as THREE from 'three';

const MARGIN = 0.15;     // of the size of the scene, beyond what it shows, as half-spaces are drawn
const HALF_DEPTH = 0.49;  // of a planar scene, whose bodies are one metre thick and hide what lies behind them
const WATER = new THREE.MeshBasicMaterial({color: 0x3f93c4, transparent: true, opacity: 0.45, depthWrite: false});
const EDGE = new THREE.LineBasicMaterial({color: 0x1f6fa8});

/** A box of the size 1 from the origin upwards, with the outline of its top. */
function unitBox(axis) {
  const box = new THREE.Mesh(new THREE.BoxGeometry().translate(0.5, 0.5, 0.5), WATER);
  const [s, t] = [0, 1, 2].filter(k => k !== axis);
  const corners = [[0, 0], [1, 0], [1, 1], [0, 1]].map(
      ([a, b]) => new THREE.Vector3().setComponent(axis, 1).setComponent(s, a).setComponent(t, b));
  box.add(new THREE.LineLoop(new THREE.BufferGeometry().setFromPoints(corners), EDGE));
  return box;
}

export class StillWater {
  constructor({basins, levels}, up, box, size) {
    this.levels = levels;
    this.colour = WATER.color.getHex();
    this.axis = [0, 1, 2].find(k => up.getComponent(k) !== 0);
    this.sign = up.getComponent(this.axis);
    this.group = new THREE.Group();
    const room = box.clone().expandByScalar(MARGIN * size);
    this.basins = basins.map(({box: six, level}) => {
      const low = new THREE.Vector3(...six.slice(0, 3)), high = new THREE.Vector3(...six.slice(3));
      if (low.z === high.z) {
        [low.z, high.z] = [-HALF_DEPTH, HALF_DEPTH];
      }
      const top = this.sign > 0 ? high.getComponent(this.axis) : -low.getComponent(this.axis);
      low.max(room.min);
      high.min(room.max);
      const mesh = unitBox(this.axis);
      this.group.add(mesh);
      return {mesh, low, high, top, level: level ?? top};
    });
  }

  show(index) {
    const {axis, sign} = this;
    for (const {mesh, low, high, top, level} of this.basins) {
      const surface = sign * Math.min(this.levels[index] ?? level, top);
      const from = low.clone(), to = high.clone();
      (sign > 0 ? to : from).setComponent(axis, surface);
      mesh.visible = from.x < to.x && from.y < to.y && from.z < to.z;
      mesh.position.copy(from);
      mesh.scale.subVectors(to, from);
      if (sign < 0) {  // the top of the box is where its axis begins
        mesh.position.setComponent(axis, to.getComponent(axis));
        mesh.scale.setComponent(axis, from.getComponent(axis) - to.getComponent(axis));
      }
    }
  }
}
