// SPDX-License-Identifier: Apache-2.0
// Contact forces: a bar along each force, through its point; its length and its thickness grow with the force.

import * as THREE from 'three';
import {CONTACT_VALUES as CONTACT} from './recording.js';

const LONGEST = 0.12;  // of the size of the scene

export class Forces {
  constructor(contents, size) {
    this.most = contents.bodies?.most_contact_force || 1;
    this.length = LONGEST * size;
    this.geometry = new THREE.CylinderGeometry(0.5, 0.5, 1, 8, 1);
    this.material = new THREE.MeshBasicMaterial({color: 0xd55e00, depthTest: false, transparent: true, opacity: 0.9});
    this.group = new THREE.Group();
    this.group.visible = false;
  }

  show(frame) {
    const count = (frame.contacts?.length ?? 0) / CONTACT;
    if (!this.mesh || this.mesh.instanceMatrix.count < count) {
      this.mesh?.dispose();
      this.group.clear();
      this.mesh = new THREE.InstancedMesh(this.geometry, this.material, Math.max(16, 2 * count));
      this.mesh.frustumCulled = false;
      this.mesh.renderOrder = 2;
      this.group.add(this.mesh);
    }
    this.mesh.count = count;
    const matrix = new THREE.Matrix4(), place = new THREE.Vector3(), turn = new THREE.Quaternion();
    const along = new THREE.Vector3(), scale = new THREE.Vector3(), y = new THREE.Vector3(0, 1, 0);
    for (let i = 0; i < count; ++i) {
      const row = frame.contacts.subarray(CONTACT * i, CONTACT * (i + 1));
      along.set(row[3], row[4], row[5]);
      const force = along.length(), share = Math.min(force / this.most, 1);
      if (force > 0) {
        turn.setFromUnitVectors(y, along.divideScalar(force));
      }
      const thick = this.length * (0.008 + 0.06 * Math.sqrt(share));
      scale.set(thick, this.length * share, thick);
      this.mesh.setMatrixAt(i, matrix.compose(place.set(row[0], row[1], row[2]), turn, scale));
    }
    this.mesh.instanceMatrix.needsUpdate = true;
  }
}
