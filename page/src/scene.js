// SPDX-License-Identifier: Apache-2.0
// The scene: what is drawn, from where, and what lies under the pointer.

import * as THREE from 'three';
import {OrbitControls} from 'three/addons/controls/OrbitControls.js';
import {Blocks} from './blocks.js';
import {Effects} from './effects.js';
import {Forces} from './forces.js';
import {FIELD_OF_VIEW, boundsOf, cornersOf, directionOf, fit, lengthOf, upOf} from './framing.js';
import {Gauges} from './gauges.js';
import {Particles} from './particles.js';
import {PorousZones} from './porous.js';
import {StillWater} from './still_water.js';
import {WaterSurface} from './surface.js';

const BACKGROUND = {light: 0xf4f5f6, dark: 0x16191d};
const OUTLINE = {light: '#d8400b', dark: '#ff8a5c'};
const LOOKS = 24;      // at the water, to see what stands before it
const LONG = 5;        // lengths over heights from which heights can be exaggerated
const NEAR_CLICK = 6;  // pixels around a click within which a free block is preferred to what stands still

export class Scene {
  constructor(canvas, labels, contents, shapes, first) {
    this.canvas = canvas;
    this.isPlanar = contents.is_planar;
    this.renderer = new THREE.WebGLRenderer({canvas, antialias: true});
    this.world = new THREE.Scene();
    this.root = new THREE.Group();  // the run, turned so that gravity points down, and stretched
    this.root.matrixAutoUpdate = false;
    this.world.add(this.root);
    this.up = upOf(contents);
    this.box = boundsOf(contents);
    this.size = lengthOf(this.box) || 1;
    this.gravity = contents.gravity;
    this.gravityAt = contents.gravity_at ?? null;
    this.keepsGravityDown = this.gravityAt !== null;
    this.stretch = 1;
    // Planar bodies are drawn one metre thick: with perspective their near faces would hide what is beside them.
    this.camera = contents.is_planar ? new THREE.OrthographicCamera(-1, 1, 1, -1, this.size / 200, this.size * 20) :
                                       new THREE.PerspectiveCamera(FIELD_OF_VIEW, 1, this.size / 200, this.size * 200);
    this.camera.up.copy(this.up);
    this.controls = new OrbitControls(this.camera, canvas);
    this.controls.addEventListener('change', () => this.redraw());
    this.controls.addEventListener('start', () => { this.preset = null; });
    this.#light();
    this.#fill(contents, labels, shapes, first);
    this.turn(0);
    this.preset = contents.is_planar ? 'front' : 'corner';
    this.resize();
    new ResizeObserver(() => this.resize()).observe(canvas.parentElement);
  }

  #light() {
    const sky = new THREE.HemisphereLight(0xffffff, 0x888f99, 1.6);
    sky.position.copy(this.up);
    this.lamp = new THREE.DirectionalLight(0xffffff, 1.9);
    this.world.add(sky, this.lamp, this.lamp.target);
    if (this.isPlanar) {
      return;
    }
    this.renderer.shadowMap.enabled = true;
    this.renderer.shadowMap.type = THREE.PCFSoftShadowMap;
    const {lamp, size} = this, center = this.box.getCenter(new THREE.Vector3()), half = 0.62 * size;
    lamp.target.position.copy(center);
    lamp.position.copy(center).addScaledVector(this.up, 1.1 * size)
        .addScaledVector(directionOf('front', this.up), 0.55 * size).addScaledVector(directionOf('side', this.up), -0.35 * size);
    lamp.castShadow = true;
    lamp.shadow.mapSize.set(2048, 2048);
    lamp.shadow.radius = 3;
    lamp.shadow.bias = -0.0006;
    lamp.shadow.normalBias = 0.0015 * size;
    Object.assign(lamp.shadow.camera, {left: -half, right: half, top: half, bottom: -half, near: 0.2 * size, far: 2.6 * size});
  }

  #fill(contents, labels, shapes, first) {
    if (contents.bodies) {
      this.blocks = new Blocks(contents, shapes, first, this.box);
      this.forces = new Forces(contents, this.size);
      this.root.add(this.blocks.group, this.forces.group);
    }
    if (contents.water) {
      this.particles = new Particles(contents.water);
      this.root.add(this.particles.points);
      this.surface = new WaterSurface(this.particles, contents.is_planar);
    }
    if (contents.porous?.length > 0) {
      this.porous = new PorousZones(contents.porous, this.size);
      this.root.add(this.porous.lines);
    }
    if (contents.still_water) {
      this.stillWater = new StillWater(contents.still_water, this.up, this.box, this.size);
      this.root.add(this.stillWater.group);
    }
    this.gauges = new Gauges(contents, labels, this.up, this.box, this.size);
    this.root.add(this.gauges.group);
    this.effects = new Effects(this.renderer, this.size);
  }

  /** Heights may be stretched where the scene is long and low. */
  get isLong() {
    const extent = this.box.getSize(new THREE.Vector3()), high = Math.abs(extent.dot(this.up));
    return Math.max(extent.x, extent.y, extent.z) > LONG * high;
  }

  /** Gravity of a frame, as the run has it. */
  gravityOf(index) {
    return this.gravityAt ? this.gravityAt.slice(3 * index, 3 * index + 3) : this.gravity;
  }

  /** How the run is turned so that gravity of the frame points down. */
  turnOf(index) {
    const turn = new THREE.Quaternion();
    const g = new THREE.Vector3(...this.gravityOf(index)), start = new THREE.Vector3(...this.gravity);
    return this.keepsGravityDown && g.length() > 0 && start.length() > 0 ?
        turn.setFromUnitVectors(g.normalize(), start.normalize()) : turn;
  }

  /** The run as it is drawn: turned about its middle, and stretched along the vertical. */
  matrixOf(index) {
    const center = this.box.getCenter(new THREE.Vector3());
    const along = [0, 1, 2].map(k => this.up.getComponent(k) !== 0 ? this.stretch : 1);
    return new THREE.Matrix4().makeTranslation(center)
        .multiply(new THREE.Matrix4().makeScale(...along))
        .multiply(new THREE.Matrix4().makeRotationFromQuaternion(this.turnOf(index)))
        .multiply(new THREE.Matrix4().makeTranslation(center.clone().negate()));
  }

  turn(index) {
    this.index = index;
    this.root.matrix.copy(this.matrixOf(index));
    this.root.updateMatrixWorld(true);
    this.surface?.follow(this.root.matrix);
    this.axes = this.turnOf(index);
  }

  show(frame, index = 0) {
    if (frame.pose) {
      this.blocks?.show(frame);
    }
    this.forces?.show(frame);
    this.particles?.show(frame);
    this.stillWater?.show(index);
    this.turn(index);
    this.#follow(frame);
    this.isShown = true;
    this.draw();
  }

  /** Moves with the picked body, or with the middle of the free ones, where the reader has asked for it. */
  #follow(frame) {
    const place = this.isFollowing ? this.blocks?.middleOf(frame)?.applyMatrix4(this.root.matrix) : null;
    if (place) {
      const by = place.clone().sub(this.followed ?? place);
      this.camera.position.add(by);
      this.controls.target.add(by);
      this.controls.update();
    }
    this.followed = place;
  }

  setFollowing(isOn, frame) {
    this.isFollowing = isOn;
    this.followed = null;
    this.#follow(frame);
  }

  setGravityDown(isOn) {
    this.keepsGravityDown = isOn && this.gravityAt !== null;
    this.turn(this.index);
    this.refit();
  }

  setStretch(factor) {
    this.stretch = factor;
    this.turn(this.index);
    this.refit();
  }

  /** Draws once before the screen is next shown, however often it was asked. */
  redraw() {
    if (this.isShown && !this.isStale) {
      this.isStale = true;
      requestAnimationFrame(() => this.isStale && this.draw());
    }
  }

  draw() {
    const {camera, renderer} = this, looseOnes = [this.particles?.points, this.forces?.group, this.gauges.group].filter(Boolean);
    this.isStale = false;
    this.#setDepths();
    if (this.isPlanar) {
      this.lamp.position.copy(camera.position).addScaledVector(this.up, 0.6 * this.size)
          .addScaledVector(new THREE.Vector3(1, 0, 0).applyQuaternion(camera.quaternion), 0.4 * this.size);
      this.lamp.target.position.copy(this.controls.target);
    }
    this.#setSeenStretch();
    this.#clearSight();
    const shown = looseOnes.map(one => one.visible);
    looseOnes.forEach(one => { one.visible = false; });
    renderer.render(this.world, camera);
    if (!this.isPlanar && this.blocks && !this.blocks.isGlass) {
      this.effects.darken(this.world, camera, this.blocks.withoutDepth());
    }
    looseOnes.forEach((one, k) => { one.visible = shown[k]; });
    if (shown.some(Boolean)) {
      this.#drawOnly(looseOnes);
    }
    this.surface?.draw(renderer, camera, this.up);
    if (this.isPlanar && this.surface?.isOn && !this.blocks?.isGlass) {
      this.#drawBeforeWater(looseOnes);
    }
    const picked = this.blocks?.pickedMesh();
    if (picked) {
      picked.applyMatrix4(this.root.matrix);
      this.effects.ring(picked, camera, OUTLINE[this.theme ?? 'light']);
    }
    this.gauges.place(point => this.#pixelWithin(point));
    this.onView?.(camera, this.#pixelsPerMetre(), this.axes, this.gravityOf(this.index));
  }

  /** Lets nothing that stands still hide the water: some of its particles are looked at from the eye. */
  #clearSight() {
    const eyeKey = [...this.camera.matrixWorld.elements, this.index].join(' ');
    if (this.isPlanar || !this.blocks?.frame || !this.particles || this.blocks.isGlass || this.sightOf === eyeKey) {
      return;
    }
    this.sightOf = eyeKey;
    const places = this.particles.some(LOOKS).map(place => place.applyMatrix4(this.root.matrix));
    this.blocks.clearSight(places.map(() => this.camera.position), places);
  }

  /** Puts the nearest and the farthest depth close around the scene: depths are known the better. */
  #setDepths() {
    const {camera} = this, away = camera.position.distanceTo(this.box.getCenter(new THREE.Vector3()));
    if (!camera.isOrthographicCamera) {
      const reach = 2 * this.size * this.stretch;
      Object.assign(camera, {near: Math.max(away - reach, 0.02 * away, 0.002 * this.size), far: away + 4 * reach});
      camera.updateProjectionMatrix();
    }
  }

  /** Draws some things over the picture, behind what is nearer. */
  #drawOnly(things) {
    const {renderer, blocks} = this, shadows = renderer.shadowMap.autoUpdate;
    if (blocks) {
      blocks.group.visible = false;
    }
    renderer.autoClear = renderer.shadowMap.autoUpdate = false;
    renderer.render(this.world, this.camera);
    renderer.autoClear = true;
    renderer.shadowMap.autoUpdate = shadows;
    if (blocks) {
      blocks.group.visible = true;
    }
  }

  /** In a planar scene bodies lie before the water, but for those that it goes through. */
  #drawBeforeWater(looseOnes) {
    const {renderer, blocks} = this, others = [...looseOnes, this.stillWater?.group].filter(one => one?.visible);
    others.forEach(one => { one.visible = false; });
    renderer.autoClear = renderer.shadowMap.autoUpdate = false;
    const draw = () => renderer.render(this.world, this.camera);
    blocks ? blocks.drawnAlone(draw) : draw();
    renderer.autoClear = renderer.shadowMap.autoUpdate = true;
    others.forEach(one => { one.visible = true; });
  }

  /** Balls of water become tall where heights are stretched; from above they stay round. */
  #setSeenStretch() {
    const away = this.camera.getWorldDirection(new THREE.Vector3()).dot(this.up);
    const seen = 1 + (this.stretch - 1) * Math.sqrt(Math.max(0, 1 - away * away));
    this.particles?.setStretch(seen);
    this.surface?.setStretch(seen);
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
    this.refit();
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

  /** Water as a "surface", as particles coloured by their "pressure" or "speed", or as "none". */
  showWater(by) {
    if (this.particles) {
      this.particles.colourBy(by);
      this.surface.isOn = by === 'surface';
      this.redraw();
    }
  }

  setTheme(theme) {
    this.theme = theme;
    this.renderer.setClearColor(BACKGROUND[theme]);
    this.blocks?.setTheme(theme);
    this.surface?.setTheme(theme);
    this.gauges.setTheme(theme);
    this.porous?.setTheme(theme);
    this.redraw();
  }

  /** Corners of what is to be seen over the run, as gravity turns it. */
  #corners() {
    const frames = this.gravityAt && this.keepsGravityDown ? this.gravityAt.length / 3 : 1;
    return [...new Set([0, Math.floor(frames / 2), frames - 1])].flatMap(
        index => cornersOf(this.box).map(corner => corner.applyMatrix4(this.matrixOf(index))));
  }

  /** Looks at the whole scene from a corner, the front, a side or above. */
  setPreset(name) {
    this.#look(name, directionOf(name, this.up));
  }

  /** Moves the eye of the reader until the whole scene is seen, in the direction that it has. */
  fit() {
    const from = this.camera.position.clone().sub(this.controls.target).normalize();
    this.#look(this.preset, from);
  }

  /** Takes another box for the one that views show whole, of several runs, say. */
  frameOn(box) {
    this.box = box;
    this.size = lengthOf(box) || 1;
    this.turn(this.index);
    this.refit();
  }

  refit() {
    if (this.preset) {
      this.setPreset(this.preset);
    } else {
      this.redraw();
    }
  }

  #look(preset, from) {
    const {center, distance, half} = fit(this.camera, this.aspect, from, this.#corners());
    if (this.camera.isOrthographicCamera) {
      Object.assign(this.camera, {top: half, bottom: -half, zoom: 1});
      this.#setAspect(this.aspect);
    }
    this.controls.target.copy(center);
    this.camera.position.copy(center).addScaledVector(from, this.camera.isOrthographicCamera ? 2 * this.size : distance);
    this.controls.update();
    this.preset = preset;
    this.followed = null;
    this.redraw();
  }

  /** The place of the eye as numbers: its position, what it looks at, its zoom. */
  get eye() {
    return [...this.camera.position.toArray(), ...this.controls.target.toArray(), this.camera.zoom];
  }

  set eye(numbers) {
    this.camera.position.fromArray(numbers);
    this.controls.target.fromArray(numbers, 3);
    this.camera.zoom = numbers[6] || 1;
    this.camera.updateProjectionMatrix();
    this.controls.update();
    this.preset = null;
    this.redraw();
  }

  /** Brings the eye to a share of its way through several places of it: around what it looks at, not through it. */
  travel(stops, share) {
    const at = Math.min(Math.max(share, 0), 1) * (stops.length - 1), k = Math.min(Math.floor(at), Math.max(stops.length - 2, 0));
    const [a, b] = [stops[k], stops[Math.min(k + 1, stops.length - 1)]], t = at - k, part = t * t * (3 - 2 * t);
    const mix = (x, y) => x + part * (y - x);
    const [fromA, fromB] = [a, b].map(eye => new THREE.Vector3(...eye.slice(0, 3)).sub(new THREE.Vector3(...eye.slice(3, 6))));
    const turn = new THREE.Quaternion().slerp(
        new THREE.Quaternion().setFromUnitVectors(fromA.clone().normalize(), fromB.clone().normalize()), part);
    const target = [3, 4, 5].map(i => mix(a[i], b[i]));
    const from = fromA.clone().normalize().applyQuaternion(turn).multiplyScalar(mix(fromA.length(), fromB.length()));
    this.eye = [...from.add(new THREE.Vector3(...target)).toArray(), ...target, mix(a[6], b[6])];
    this.draw();
  }

  /** The body at a place of the canvas, in pixels of the page; -1 where there is none. A free one close by comes first. */
  bodyAt(x, y) {
    if (!this.blocks) {
      return -1;
    }
    const around = [...Array(8).keys()].map(k => [NEAR_CLICK * Math.cos(k * Math.PI / 4), NEAR_CLICK * Math.sin(k * Math.PI / 4)]);
    const hit = this.#bodyUnder(x, y);
    return hit >= 0 && this.blocks.isFree(hit) ? hit :
        around.map(([dx, dy]) => this.#bodyUnder(x + dx, y + dy)).find(body => body >= 0 && this.blocks.isFree(body)) ?? hit;
  }

  #bodyUnder(x, y) {
    const place = this.canvas.getBoundingClientRect(), caster = new THREE.Raycaster();
    caster.setFromCamera(new THREE.Vector2(2 * (x - place.left) / place.width - 1, 1 - 2 * (y - place.top) / place.height),
                         this.camera);
    return this.blocks.pick(caster);
  }

  #pixelWithin(point) {
    const seen = point.clone().applyMatrix4(this.root.matrix).project(this.camera);
    return [(seen.x + 1) / 2 * this.canvas.clientWidth, (1 - seen.y) / 2 * this.canvas.clientHeight];
  }

  /** Where a point of the run is on the page, in pixels. */
  pixelOf(point) {
    const place = this.canvas.getBoundingClientRect(), [x, y] = this.#pixelWithin(new THREE.Vector3(...point));
    return [place.left + x, place.top + y];
  }
}
