// SPDX-License-Identifier: Apache-2.0
// Principal stresses: a cross of bars in the middle of each block, along the principal directions. The longest bars are as
// long as the block; pressure and tension have colours of their own. Shown while blocks are coloured by their stress.

import * as THREE from 'three';
import {MOTION_VALUES as MOTION, POSE_VALUES as POSE} from './recording.js';

export const PRESSURE = 0xd55e00, TENSION = 0x56b4e9;
const NAMES = ['stress_xx', 'stress_yy', 'stress_zz', 'stress_xy', 'stress_yz', 'stress_zx'];
const LEAST = 0.02;  // of the largest stress: shorter bars are not drawn

/** Eigenvalues and eigenvectors of a symmetric matrix [xx, yy, zz, xy, yz, zx], by Jacobi's rotations: [[value, [x, y, z]]]. */
export function principalOf([xx, yy, zz, xy, yz, zx]) {
  const a = [[xx, xy, zx], [xy, yy, yz], [zx, yz, zz]], v = [[1, 0, 0], [0, 1, 0], [0, 0, 1]];
  for (let sweep = 0; sweep < 12; ++sweep) {
    for (const [p, q] of [[0, 1], [0, 2], [1, 2]]) {
      if (Math.abs(a[p][q]) < 1e-300) {
        continue;
      }
      const half = (a[q][q] - a[p][p]) / (2 * a[p][q]);
      const t = (half < 0 ? -1 : 1) / (Math.abs(half) + Math.sqrt(half * half + 1)), c = 1 / Math.sqrt(t * t + 1), s = t * c;
      for (let k = 0; k < 3; ++k) {
        [a[k][p], a[k][q]] = [c * a[k][p] - s * a[k][q], s * a[k][p] + c * a[k][q]];
      }
      for (let k = 0; k < 3; ++k) {
        [a[p][k], a[q][k]] = [c * a[p][k] - s * a[q][k], s * a[p][k] + c * a[q][k]];
        [v[k][p], v[k][q]] = [c * v[k][p] - s * v[k][q], s * v[k][p] + c * v[k][q]];
      }
    }
  }
  return [0, 1, 2].map(k => [a[k][k], [v[0][k], v[1][k], v[2][k]]]);
}

/** Room for a bar in a shape: twice the distance of its middle from the nearest face, or from inner faces of a shape of parts a share of that from the nearest corner. */
function widthOf(shape, isPlanar) {
  const corner = k => new THREE.Vector3().fromArray(shape.corners, 3 * k), size = isPlanar ? 2 : 3;
  let face = Infinity, reach = Infinity;
  for (const [a, b, c] of shape.faces) {
    const normal = corner(b).sub(corner(a)).cross(corner(c).sub(corner(a))).normalize();
    face = isPlanar && Math.abs(normal.z) > 0.5 ? face : Math.min(face, Math.abs(normal.dot(corner(a))));
  }
  for (let k = 0; k + 2 < shape.corners.length; k += 3) {
    reach = Math.min(reach, Math.hypot(...shape.corners.slice(k, k + size)));
  }
  return 2 * Math.max(face, 0.3 * reach);
}

export class Stresses {
  constructor(contents, shapes) {
    const fields = contents.bodies.shown ?? [];
    this.count = fields.length;
    this.places = NAMES.map(name => fields.findIndex(field => field.name === name));
    this.most = Math.max(1e-300, ...fields.filter(({name}) => NAMES.includes(name)).flatMap(({low, high}) => [Math.abs(low), Math.abs(high)]));
    this.bodies = contents.bodies.shape.flatMap((shape, body) => shapes[shape].faces.length > 1 ? [body] : []);
    this.width = contents.bodies.shape.map(shape => widthOf(shapes[shape], contents.is_planar));
    this.group = new THREE.Group();
    this.group.visible = false;
    if (this.places[0] >= 0) {
      const material = new THREE.MeshBasicMaterial({depthTest: false, transparent: true});
      this.mesh = new THREE.InstancedMesh(new THREE.BoxGeometry(1, 1, 1), material, 3 * this.bodies.length);
      this.mesh.frustumCulled = false;
      this.mesh.renderOrder = 2;
      this.group.add(this.mesh);
    }
  }

  /** @param by  what the blocks are coloured by */
  show(frame, by) {
    this.group.visible = Boolean(this.mesh && frame.shown) && (by === 'von_mises' || NAMES.includes(by));
    if (!this.group.visible) {
      return;
    }
    const matrix = new THREE.Matrix4(), place = new THREE.Vector3(), turn = new THREE.Quaternion();
    const scale = new THREE.Vector3(), x = new THREE.Vector3(1, 0, 0), along = new THREE.Vector3(), colour = new THREE.Color();
    let used = 0;
    for (const body of this.bodies) {
      if (frame.motion[MOTION * body + 9] === 0) {
        continue;  // what is held has no stress of its own
      }
      const stress = this.places.map(k => k < 0 ? 0 : frame.shown[this.count * body + k]);
      for (const [value, axis] of principalOf(stress)) {
        const share = Math.min(Math.abs(value) / this.most, 1), width = this.width[body];
        if (share > LEAST) {
          turn.setFromUnitVectors(x, along.set(...axis).normalize());
          scale.set(share * width, 0.04 * width, 0.04 * width);
          place.fromArray(frame.pose, POSE * body);
          this.mesh.setMatrixAt(used, matrix.compose(place, turn, scale));
          this.mesh.setColorAt(used++, colour.set(value < 0 ? PRESSURE : TENSION));
        }
      }
    }
    this.mesh.count = used;
    this.mesh.instanceMatrix.needsUpdate = true;
    if (this.mesh.instanceColor) {
      this.mesh.instanceColor.needsUpdate = true;
    }
  }
}
