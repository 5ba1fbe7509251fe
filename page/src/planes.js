// SPDX-License-Identifier: Apache-2.0
// Half-spaces are drawn as far as the scene reaches, water included. Where several meet, as the walls of a tank do, each
// is cut where the others begin.

import * as THREE from 'three';
import {POSE_VALUES as POSE} from './recording.js';

const MARGIN = 0.15;     // of the size of the scene, beyond what it shows
const TOLERANCE = 1e-6;  // of the size of the scene

const isPlane = shape => shape.faces.length === 1;

function poseOf(pose, body) {
  const p = pose.subarray(POSE * body, POSE * (body + 1));
  return new THREE.Matrix4().compose(new THREE.Vector3(p[0], p[1], p[2]), new THREE.Quaternion(p[4], p[5], p[6], p[3]),
                                     new THREE.Vector3(1, 1, 1));
}

/** A square of a plane around the foot of `center` on it, wound as seen from its positive side. */
function squareOf(plane, center, half) {
  const n = plane.normal, aside = new THREE.Vector3(Math.abs(n.z) < 0.9 ? 0 : 1, 0, Math.abs(n.z) < 0.9 ? 1 : 0);
  const s = aside.clone().cross(n).normalize(), t = n.clone().cross(s);
  const foot = plane.projectPoint(center, new THREE.Vector3());
  return [[-1, -1], [1, -1], [1, 1], [-1, 1]].map(
      ([a, b]) => foot.clone().addScaledVector(s, a * half).addScaledVector(t, b * half));
}

/** The part of a polygon on the positive side of a plane. */
function cut(polygon, plane, tolerance) {
  const kept = [];
  polygon.forEach((a, k) => {
    const b = polygon[(k + 1) % polygon.length];
    const da = plane.distanceToPoint(a), db = plane.distanceToPoint(b);
    if (da >= -tolerance) {
      kept.push(a);
    }
    if ((da > tolerance && db < -tolerance) || (da < -tolerance && db > tolerance)) {
      kept.push(a.clone().lerp(b, da / (da - db)));
    }
  });
  return kept;
}

/** A shape for every body that is a half-space, by body, in the frame of the body; `pose` is that of the first frame. */
export function planesOf(bodies, shapes, pose, box) {
  const size = box.getSize(new THREE.Vector3()).length(), room = box.clone().expandByScalar(MARGIN * size);
  const sides = [0, 1, 2].flatMap(axis => [1, -1].map(sign => {
    const normal = new THREE.Vector3().setComponent(axis, sign);
    return new THREE.Plane().setFromNormalAndCoplanarPoint(normal, sign > 0 ? room.min : room.max);
  }));
  const planes = new Map();
  bodies.shape.forEach((s, body) => {
    if (isPlane(shapes[s])) {
      const matrix = poseOf(pose, body);
      const corners = shapes[s].faces[0].slice(0, 3).map(
          corner => new THREE.Vector3().fromArray(shapes[s].corners, 3 * corner).applyMatrix4(matrix));
      const plane = new THREE.Plane().setFromCoplanarPoints(...corners);
      planes.set(body, {matrix, plane, polygon: squareOf(plane, box.getCenter(new THREE.Vector3()), 2 * size)});
    }
  });
  const cutShapes = new Map();
  for (const [body, {matrix, polygon}] of planes) {
    const others = [...planes].filter(([other]) => other !== body).map(([, {plane}]) => plane);
    let kept = polygon;
    for (const plane of [...others, ...sides]) {
      const next = cut(kept, plane, TOLERANCE * size);
      kept = next.length >= 3 ? next : kept;  // a wall outside of another one stays as it is
    }
    const toBody = matrix.clone().invert();
    cutShapes.set(body, {corners: kept.flatMap(x => x.clone().applyMatrix4(toBody).toArray()), faces: [kept.map((_, k) => k)]});
  }
  return cutShapes;
}
