// SPDX-License-Identifier: Apache-2.0
// Which part of the scene a picture shows, and from how far away.

import * as THREE from 'three';

export const FIELD_OF_VIEW = 35;  // degrees
const MARGIN = 1.12;              // around the scene
const AROUND = 0.08;              // of the size of what moves, shown of what stands still

const boxOf = six => new THREE.Box3(new THREE.Vector3(...six.slice(0, 3)), new THREE.Vector3(...six.slice(3)));
export const lengthOf = box => box.getSize(new THREE.Vector3()).length();

/** The axis nearest to "against gravity"; without gravity z, in a planar scene y. */
export function upOf(contents) {
  const g = contents.gravity, k = [0, 1, 2].reduce((a, b) => Math.abs(g[b]) > Math.abs(g[a]) ? b : a);
  const up = new THREE.Vector3();
  if (g[k] === 0) {
    return contents.is_planar ? up.set(0, 1, 0) : up.set(0, 0, 1);
  }
  return up.setComponent(k, g[k] > 0 ? -1 : 1);
}

/**
 * The box that a reader wants to see: where what moves is over the run, pieces that flew off left out by the program.
 * Of what stands still it shows the part around: a wall that is higher than the water may not fill the picture.
 */
export function boundsOf(contents) {
  const {box, box_fixed: fixed} = contents;
  if (!box && !fixed) {
    return new THREE.Box3(new THREE.Vector3(-1, -1, -1), new THREE.Vector3(1, 1, 1));
  }
  if (!box) {
    return boxOf(fixed);
  }
  const loose = boxOf(box);
  return fixed ? loose.clone().union(boxOf(fixed).intersect(loose.clone().expandByScalar(AROUND * lengthOf(loose)))) : loose;
}

/** The eight corners of a box. */
export function cornersOf({min, max}) {
  return [...Array(8).keys()].map(k => new THREE.Vector3(k & 1 ? max.x : min.x, k & 2 ? max.y : min.y, k & 4 ? max.z : min.z));
}

/** Unit vector from the scene to the eye. */
export function directionOf(name, up) {
  const right = new THREE.Vector3(1, 0, 0);
  if (Math.abs(up.x) > 0.5) {
    right.set(0, 1, 0);
  }
  const forward = new THREE.Vector3().crossVectors(up, right);  // into the picture of the front view
  return {
    front: forward.clone().negate(),
    side: right.clone(),
    top: up.clone().addScaledVector(forward, -1e-3),
    corner: forward.clone().multiplyScalar(-1).addScaledVector(right, 0.55).addScaledVector(up, 0.5),
  }[name].normalize();
}

/** The point that an eye looks at and how far from it it must be to see all `points`; without perspective, half the height that it must see. */
export function fit(camera, aspect, from, points) {
  const eye = camera.clone(), center = new THREE.Box3().setFromPoints(points).getCenter(new THREE.Vector3());
  eye.position.copy(center).add(from);
  eye.lookAt(center);
  const toEye = eye.quaternion.clone().invert(), tan = Math.tan(FIELD_OF_VIEW * Math.PI / 360);
  const seen = points.map(point => point.clone().sub(center).applyQuaternion(toEye));
  // The middle of what is seen, which the middle of the box need not be.
  const shift = new THREE.Vector3();
  const distanceAt = (dx, dy) => seen.reduce((most, p) =>
    Math.max(most, p.z + Math.max(Math.abs(p.y - dy), Math.abs(p.x - dx) / aspect) / tan), 0);
  if (!camera.isOrthographicCamera) {
    let step = distanceAt(0, 0) / 8;
    for (let round = 0; round < 24; ++round) {
      const ways = [[0, 0], [step, 0], [-step, 0], [0, step], [0, -step]];
      const [dx, dy] = ways.reduce((a, b) => distanceAt(shift.x + b[0], shift.y + b[1]) <
                                             distanceAt(shift.x + a[0], shift.y + a[1]) - 1e-12 ? b : a);
      if (dx === 0 && dy === 0) {
        step /= 2;
      }
      shift.x += dx;
      shift.y += dy;
    }
  }
  const half = seen.reduce((most, p) => Math.max(most, Math.abs(p.y), Math.abs(p.x) / aspect), 0);
  const distance = MARGIN * distanceAt(shift.x, shift.y);
  return {center: center.add(shift.applyQuaternion(eye.quaternion)), distance, half: MARGIN * half};
}
