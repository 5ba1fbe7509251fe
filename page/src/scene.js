// SPDX-License-Identifier: Apache-2.0
// The scene: what is drawn, from where, and what lies under the pointer.

import * as THREE from 'three';
import {OrbitControls} from 'three/addons/controls/OrbitControls.js';
import {Blocks} from './blocks.js';
import {Forces} from './forces.js';
import {Particles} from './particles.js';
import {WaterSurface} from './surface.js';

const FIELD_OF_VIEW = 35;  // degrees
const MARGIN = 1.12;       // around the scene
const AROUND = 0.08;       // of the size of what moves, shown of what is fixed
const BACKGROUND = {light: 0xf4f5f6, dark: 0x16191d};

/** The axis nearest to "against gravity"; without gravity z, in a planar scene y. */
function upOf(contents) {
  const g = contents.gravity, k = [0, 1, 2].reduce((a, b) => Math.abs(g[b]) > Math.abs(g[a]) ? b : a);
  const up = new THREE.Vector3();
  if (g[k] === 0) {
    return contents.is_planar ? up.set(0, 1, 0) : up.set(0, 0, 1);
  }
  return up.setComponent(k, g[k] > 0 ? -1 : 1);
}

const boxOf = six => new THREE.Box3(new THREE.Vector3(...six.slice(0, 3)), new THREE.Vector3(...six.slice(3)));
const lengthOf = box => box.getSize(new THREE.Vector3()).length();

/**
 * The box that a reader wants to see: where free blocks and water were at the start, and went, if they did not fly away.
 * Of what is fixed it shows the part around them: a wall that is higher than the water may not fill the picture.
 */
function boundsOf(contents) {
  const {box, box_at_start: atStart, box_fixed: fixed} = contents;
  if (!atStart && !fixed) {
    return new THREE.Box3(new THREE.Vector3(-1, -1, -1), new THREE.Vector3(1, 1, 1));
  }
  if (!atStart) {
    return boxOf(fixed);
  }
  const start = boxOf(atStart), reach = start.clone().expandByScalar(lengthOf(start));
  const loose = start.union(boxOf(box).intersect(reach));
  return fixed ? loose.clone().union(boxOf(fixed).intersect(loose.clone().expandByScalar(AROUND * lengthOf(loose)))) : loose;
}

export class Scene {
  constructor(canvas, contents, shapes, first) {
    this.canvas = canvas;
    this.isPlanar = contents.is_planar;
    this.renderer = new THREE.WebGLRenderer({canvas, antialias: true});
    this.world = new THREE.Scene();
    this.up = upOf(contents);
    this.box = boundsOf(contents);
    this.size = this.box.getSize(new THREE.Vector3()).length() || 1;
    // Planar bodies are drawn one metre thick: with perspective their near faces would hide what is beside them.
    this.camera = contents.is_planar ? new THREE.OrthographicCamera(-1, 1, 1, -1, this.size / 200, this.size * 20) :
                                       new THREE.PerspectiveCamera(FIELD_OF_VIEW, 1, this.size / 200, this.size * 200);
    this.camera.up.copy(this.up);
    this.controls = new OrbitControls(this.camera, canvas);
    this.controls.addEventListener('change', () => this.redraw());
    this.controls.addEventListener('start', () => { this.preset = null; });
    this.#light();
    this.#fill(contents, shapes, first);
    this.preset = contents.is_planar ? 'front' : 'corner';
    this.resize();
    new ResizeObserver(() => this.resize()).observe(canvas.parentElement);
  }

  #light() {
    const sky = new THREE.HemisphereLight(0xffffff, 0x888f99, 1.6);
    sky.position.copy(this.up);
    this.lamp = new THREE.DirectionalLight(0xffffff, 1.9);
    this.world.add(sky, this.lamp, this.lamp.target);
  }

  #fill(contents, shapes, first) {
    if (contents.bodies) {
      this.blocks = new Blocks(contents, shapes, first, this.box);
      this.forces = new Forces(contents, this.size);
      this.world.add(this.blocks.group, this.forces.group);
    }
    if (contents.water) {
      this.particles = new Particles(contents.water);
      this.world.add(this.particles.points);
      this.surface = new WaterSurface(this.particles, contents.is_planar);
    }
  }

  show(frame) {
    if (frame.pose) {
      this.blocks?.show(frame);
    }
    this.forces?.show(frame);
    this.particles?.show(frame);
    this.isShown = true;
    this.draw();
  }

  /** Draws once before the screen is next shown, however often it was asked. */
  redraw() {
    if (this.isShown && !this.isStale) {
      this.isStale = true;
      requestAnimationFrame(() => this.isStale && this.draw());
    }
  }

  draw() {
    const {camera} = this;
    this.isStale = false;
    this.lamp.position.copy(camera.position).addScaledVector(this.up, 0.6 * this.size)
        .addScaledVector(new THREE.Vector3(1, 0, 0).applyQuaternion(camera.quaternion), 0.4 * this.size);
    this.lamp.target.position.copy(this.controls.target);
    this.renderer.render(this.world, camera);
    this.surface?.draw(this.renderer, camera, this.up);
    this.onView?.(camera, this.#pixelsPerMetre());
  }

  /** Of the page, at the middle of the scene. */
  #pixelsPerMetre() {
    const height = this.canvas.clientHeight;
    return this.camera.isOrthographicCamera ?
        height * this.camera.zoom / (this.camera.top - this.camera.bottom) :
        height / (2 * Math.tan(FIELD_OF_VIEW * Math.PI / 360) * this.camera.position.distanceTo(this.controls.target));
  }

  resize() {
    const {clientWidth: width, clientHeight: height} = this.canvas.parentElement;
    const ratio = Math.min(window.devicePixelRatio, 2);
    const size = [width, height, ratio].join(' ');
    if (width === 0 || height === 0 || size === this.canvasSize) {
      return;
    }
    this.canvasSize = size;
    this.renderer.setPixelRatio(ratio);
    this.renderer.setSize(width, height, false);
    this.#setAspect(width / height);
    if (this.particles) {
      this.particles.material.uniforms.pixels.value = height * ratio / 2;
    }
    if (this.preset) {
      this.setPreset(this.preset);
    }
    if (this.isShown) {  // at once: the canvas is empty now
      this.draw();
    }
  }

  #setAspect(aspect) {
    const {camera} = this;
    this.aspect = aspect;
    camera.aspect = aspect;
    [camera.left, camera.right] = [-camera.top * aspect, camera.top * aspect];  // of one with perspective, not looked at
    camera.updateProjectionMatrix();
  }

  /** Water as "surface", as particles coloured by their "pressure" or "speed", or as "none". */
  showWater(by) {
    if (this.particles) {
      this.particles.colourBy(by);
      this.surface.isOn = by === 'surface';
      this.redraw();
    }
  }

  setTheme(theme) {
    this.renderer.setClearColor(BACKGROUND[theme]);
    this.blocks?.setTheme(theme);
    this.redraw();
  }

  /** Looks at the whole scene from a corner, the front, a side or above. */
  setPreset(name) {
    this.preset = name;
    const right = new THREE.Vector3(1, 0, 0);
    if (Math.abs(this.up.x) > 0.5) {
      right.set(0, 1, 0);
    }
    const forward = new THREE.Vector3().crossVectors(this.up, right);  // into the picture of the front view
    const from = {
      front: forward.clone().negate(),
      side: right.clone(),
      top: this.up.clone().addScaledVector(forward, -1e-3),
      corner: forward.clone().multiplyScalar(-1).addScaledVector(right, 0.55).addScaledVector(this.up, 0.5),
    }[name].normalize();
    const center = this.box.getCenter(new THREE.Vector3());
    this.controls.target.copy(center);
    this.camera.position.copy(center).addScaledVector(from, this.#fit(from, center));
    this.controls.update();
    this.preset = name;
    this.redraw();
  }

  /** How far away the eye must be to see every corner of the box; without perspective, how wide it must see. */
  #fit(from, center) {
    const camera = this.camera.clone();
    camera.position.copy(center).add(from);
    camera.lookAt(center);
    const toCamera = camera.quaternion.clone().invert(), tan = Math.tan(FIELD_OF_VIEW * Math.PI / 360);
    let distance = 0, half = 0;
    for (let k = 0; k < 8; ++k) {
      const corner = new THREE.Vector3(k & 1 ? this.box.max.x : this.box.min.x, k & 2 ? this.box.max.y : this.box.min.y,
                                       k & 4 ? this.box.max.z : this.box.min.z).sub(center).applyQuaternion(toCamera);
      const needed = Math.max(Math.abs(corner.y), Math.abs(corner.x) / this.aspect);
      half = Math.max(half, needed);
      distance = Math.max(distance, corner.z + needed / tan);
    }
    if (!this.camera.isOrthographicCamera) {
      return MARGIN * distance;
    }
    Object.assign(this.camera, {top: MARGIN * half, bottom: -MARGIN * half, zoom: 1});
    this.#setAspect(this.aspect);
    return 2 * this.size;
  }

  /** The body at a place of the canvas, in pixels of the page; -1 where there is none. */
  bodyAt(x, y) {
    const place = this.canvas.getBoundingClientRect();
    const caster = new THREE.Raycaster();
    caster.setFromCamera(new THREE.Vector2(2 * (x - place.left) / place.width - 1, 1 - 2 * (y - place.top) / place.height),
                         this.camera);
    return this.blocks ? this.blocks.pick(caster) : -1;
  }

  /** Where a point of the scene is on the page, in pixels. */
  pixelOf(point) {
    const place = this.canvas.getBoundingClientRect();
    const seen = new THREE.Vector3(...point).project(this.camera);
    return [place.left + (seen.x + 1) / 2 * place.width, place.top + (1 - seen.y) / 2 * place.height];
  }
}
