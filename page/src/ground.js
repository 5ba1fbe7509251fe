// SPDX-License-Identifier: Apache-2.0
// Ground: an open surface of triangles, shaded smoothly, steep parts as rock, with lines of equal height.

import * as THREE from 'three';

const COLOURS = {light: {flat: 0xb9ae93, steep: 0x9b9285}, dark: {flat: 0x8d8572, steep: 0x6f695f}};
const LINES = 14;           // of equal height, about
const SAME_CORNER = 1e-5;   // of the size of the shape

/** Whether a shape is a surface with an edge: nothing closes it behind. */
export function isOpen(shape) {
  const count = new Map();
  for (const face of shape.faces) {
    face.forEach((a, k) => {
      const b = face[(k + 1) % face.length], key = a < b ? `${a} ${b}` : `${b} ${a}`;
      count.set(key, (count.get(key) ?? 0) + 1);
    });
  }
  return shape.faces.length > 1 && [...count.values()].some(n => n === 1);
}

/** Corners that lie in one place become one, so that light varies smoothly over edges and edges are known as shared. */
export function welded(shape) {
  let size = 0;
  shape.corners.forEach(x => { size = Math.max(size, Math.abs(x)); });
  const grain = SAME_CORNER * (size || 1), known = new Map(), corners = [], to = [];
  for (let i = 0; i < shape.corners.length; i += 3) {
    const x = shape.corners.slice(i, i + 3), key = x.map(v => Math.round(v / grain)).join(' ');
    if (!known.has(key)) {
      known.set(key, corners.length / 3);
      corners.push(...x);
    }
    to.push(known.get(key));
  }
  return {corners, faces: shape.faces.map(face => face.map(corner => to[corner]))};
}

export function groundGeometry(shape) {
  const geometry = new THREE.BufferGeometry();
  geometry.setAttribute('position', new THREE.Float32BufferAttribute(shape.corners, 3));
  geometry.setIndex(shape.faces.flatMap(face => face.slice(1, -1).flatMap((_, k) => [face[0], face[k + 1], face[k + 2]])));
  geometry.computeVertexNormals();
  return geometry;
}

/** The lines around the surface. */
export function rimOf(shape) {
  const seen = new Map();
  for (const face of shape.faces) {
    face.forEach((a, k) => {
      const b = face[(k + 1) % face.length], key = a < b ? `${a} ${b}` : `${b} ${a}`;
      seen.set(key, seen.has(key) ? null : [a, b]);
    });
  }
  return [...seen.values()].filter(Boolean).flatMap(edge => edge.flatMap(c => shape.corners.slice(3 * c, 3 * c + 3)));
}

/** A round number near a length. */
function roundStep(length) {
  const ten = 10 ** Math.floor(Math.log10(length));
  return [1, 2, 5, 10].find(k => k * ten >= length) * ten;
}

/** Material of ground; `up` in the axes of the run. */
export function groundMaterial(shape, up) {
  const heights = [];
  for (let i = 0; i < shape.corners.length; i += 3) {
    heights.push(up.x * shape.corners[i] + up.y * shape.corners[i + 1] + up.z * shape.corners[i + 2]);
  }
  const [low, high] = heights.reduce(([a, b], h) => [Math.min(a, h), Math.max(b, h)], [Infinity, -Infinity]);
  const uniforms = {up: {value: up}, every: {value: high > low ? roundStep((high - low) / LINES) : 1},
                    flatColour: {value: new THREE.Color()}, steepColour: {value: new THREE.Color()}};
  const material = new THREE.MeshLambertMaterial({side: THREE.DoubleSide});
  material.onBeforeCompile = shader => {
    Object.assign(shader.uniforms, uniforms);
    shader.vertexShader = shader.vertexShader
      .replace('#include <common>', '#include <common>\nuniform vec3 up;\nvarying float rise, level;')
      .replace('#include <begin_vertex>', `#include <begin_vertex>
        rise = dot(mat3(instanceMatrix) * normal, up);
        level = dot((instanceMatrix * vec4(position, 1.0)).xyz, up);`);
    shader.fragmentShader = shader.fragmentShader
      .replace('#include <common>', `#include <common>
        uniform vec3 flatColour, steepColour;
        uniform float every;
        varying float rise, level;`)
      .replace('#include <color_fragment>', `
        diffuseColor.rgb = mix(steepColour, flatColour, smoothstep(0.55, 0.98, abs(rise)));
        float at = level / every, width = fwidth(at);
        float line = 1.0 - smoothstep(0.4, 1.4, abs(fract(at + 0.5) - 0.5) / max(width, 1.0e-6));
        diffuseColor.rgb *= 1.0 - 0.28 * line * (1.0 - smoothstep(0.15, 0.5, width));`);
  };
  material.userData.setTheme = theme => {
    uniforms.flatColour.value.set(COLOURS[theme].flat);
    uniforms.steepColour.value.set(COLOURS[theme].steep);
  };
  material.userData.setTheme('light');
  return material;
}
