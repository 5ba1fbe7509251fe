// SPDX-License-Identifier: Apache-2.0
// Water: every particle a small ball, shaded as one, drawn from the numbers of the stream as they are.

import * as THREE from 'three';
import {MAPS, colourAt} from './colours.js';

const VERTEX = `
  uniform vec3 origin;
  uniform float step, ball, pixels, stretch;
  uniform bool bySpeed;
  attribute vec4 cell;
  varying float share;
  void main() {
    float pressure = floor(cell.w / 256.0);
    share = (bySpeed ? cell.w - 256.0 * pressure : pressure) / 255.0;
    vec4 place = modelViewMatrix * vec4(origin + step * cell.xyz, 1.0);
    gl_Position = projectionMatrix * place;
    gl_PointSize = max(1.5, stretch * ball * pixels * projectionMatrix[1][1] / gl_Position.w);
  }`;
const FRAGMENT = `
  uniform sampler2D map;
  uniform float stretch;
  varying float share;
  void main() {
    vec2 at = (2.0 * gl_PointCoord - 1.0) * vec2(stretch, 1.0);
    float r2 = dot(at, at);
    if (r2 > 1.0) discard;
    float facing = sqrt(1.0 - r2);
    vec3 colour = texture2D(map, vec2((share * 255.0 + 0.5) / 256.0, 0.5)).rgb;
    float light = 0.62 + 0.38 * (0.8 * facing - 0.35 * at.x - 0.45 * at.y);
    gl_FragColor = vec4(colour * light, 1.0);
  }`;

function mapTexture(map) {
  const bytes = new Uint8Array(4 * 256);
  for (let k = 0; k < 256; ++k) {
    bytes.set([...colourAt(map, k / 255), 255], 4 * k);
  }
  const texture = new THREE.DataTexture(bytes, 256, 1);
  texture.needsUpdate = true;
  return texture;
}

export class Particles {
  constructor(water) {
    this.water = water;
    this.by = 'pressure';
    this.geometry = new THREE.BufferGeometry();
    this.material = new THREE.ShaderMaterial({
      vertexShader: VERTEX, fragmentShader: FRAGMENT,
      uniforms: {
        origin: {value: new THREE.Vector3(...water.origin)}, step: {value: water.step},
        ball: {value: 1.05 * water.spacing}, pixels: {value: 1}, bySpeed: {value: false}, stretch: {value: 1},
        map: {value: mapTexture(MAPS.viridis)},
      }});
    this.points = new THREE.Points(this.geometry, this.material);
    this.points.frustumCulled = false;
  }

  show(frame) {
    const cells = frame.water ?? new Uint16Array(0);
    const known = this.geometry.getAttribute('cell');
    if (known && known.array.length === cells.length) {
      known.array = cells;
      known.needsUpdate = true;
    } else {
      this.geometry.dispose();
      this.geometry.setAttribute('cell', new THREE.BufferAttribute(cells, 4).setUsage(THREE.DynamicDrawUsage));
    }
    this.geometry.setDrawRange(0, cells.length / 4);
  }

  /** The places of some of the particles. */
  some(count) {
    const cells = this.geometry.getAttribute('cell')?.array ?? [], all = cells.length / 4, {origin, step} = this.water;
    return [...Array(Math.min(count, all)).keys()].map(i => {
      const at = 4 * Math.floor((i + 0.5) * all / Math.min(count, all));
      return new THREE.Vector3(...[0, 1, 2].map(k => origin[k] + step * cells[at + k]));
    });
  }

  /** Heights are drawn so many times. */
  setStretch(factor) {
    this.material.uniforms.stretch.value = factor;
  }

  colourBy(quantity) {
    this.by = quantity;
    this.points.visible = quantity === 'pressure' || quantity === 'speed';
    this.material.uniforms.bySpeed.value = quantity === 'speed';
  }

  range() {
    return this.by === 'speed' ? {label: 'speed of water', unit: 'm/s', low: 0, high: this.water.speed} :
                                 {label: 'pressure of water', unit: 'Pa', low: this.water.pressure[0],
                                  high: this.water.pressure[1]};
  }
}
