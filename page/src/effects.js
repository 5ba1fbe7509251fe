// SPDX-License-Identifier: Apache-2.0
// What is drawn over the picture of the blocks: ambient occlusion, made on the screen from their depths, and an outline
// around what is picked.

import * as THREE from 'three';

const REACH = 0.035;   // of the size of the scene: how far a surface shades its neighbours
const STRENGTH = 1.1;
const LINE = 2.5;      // pixels of the page
const COARSE = 0.5;    // of the pixels of the picture, for depths
const PASS = `
  varying vec2 at;
  void main() { at = 0.5 * position.xy + 0.5; gl_Position = vec4(position.xy, 0.0, 1.0); }`;
// Share of a half ball above the surface that nearby surfaces fill: samples on a spiral, turned from pixel to pixel.
const SHADE = `
  uniform sampler2D depths;
  uniform vec2 pixel;
  uniform mat4 back, projection;
  uniform float reach, strength;
  varying vec2 at;
  vec3 placeOf(vec2 p) {
    vec4 place = back * vec4(2.0 * vec3(p, texture2D(depths, p).r) - 1.0, 1.0);
    return place.xyz / place.w;
  }
  void main() {
    if (texture2D(depths, at).r >= 1.0) discard;
    vec3 here = placeOf(at);
    vec3 right = placeOf(at + vec2(pixel.x, 0.0)) - here, left = here - placeOf(at - vec2(pixel.x, 0.0));
    vec3 above = placeOf(at + vec2(0.0, pixel.y)) - here, below = here - placeOf(at - vec2(0.0, pixel.y));
    vec3 normal = normalize(cross(abs(right.z) < abs(left.z) ? right : left, abs(above.z) < abs(below.z) ? above : below));
    vec4 edge = projection * vec4(here + vec3(reach, 0.0, 0.0), 1.0), middle = projection * vec4(here, 1.0);
    float radius = clamp(0.5 * (edge.x / edge.w - middle.x / middle.w), 4.0 * pixel.x, 0.12);
    float turn = 6.2831853 * fract(52.9829189 * fract(dot(floor(at / pixel), vec2(0.06711056, 0.00583715))));
    float sum = 0.0;
    for (int k = 0; k < 12; ++k) {
      float far = (float(k) + 0.5) / 12.0, angle = turn + 2.3999632 * float(k);
      vec3 way = placeOf(at + radius * far * vec2(cos(angle), sin(angle) * pixel.y / pixel.x)) - here;
      float d2 = dot(way, way);
      sum += max(0.0, dot(way, normal) - 0.04 * reach) / (d2 + 0.01 * reach * reach) * reach * max(0.0, 1.0 - d2 / (reach * reach));
    }
    gl_FragColor = vec4(vec3(max(0.35, 1.0 - strength * sum / 12.0)), 1.0);
  }`;
const BLEND = `
  uniform sampler2D shades;
  uniform vec2 pixel;
  varying vec2 at;
  void main() {
    float sum = 0.0;
    for (int i = -2; i < 2; ++i) for (int j = -2; j < 2; ++j) sum += texture2D(shades, at + (vec2(i, j) + 0.5) * pixel).r;
    gl_FragColor = vec4(vec3(sum / 16.0), 1.0);
  }`;
const OUTLINE = `
  uniform sampler2D mask;
  uniform vec2 pixel;
  uniform vec3 colour;
  uniform float width;
  varying vec2 at;
  void main() {
    if (texture2D(mask, at).r > 0.5) discard;
    float near = 0.0;
    for (int k = 0; k < 16; ++k) {
      float angle = 0.3926991 * float(k);
      near = max(near, texture2D(mask, at + width * pixel * vec2(cos(angle), sin(angle))).r);
      near = max(near, texture2D(mask, at + 0.5 * width * pixel * vec2(cos(angle), sin(angle))).r);
    }
    if (near < 0.5) discard;
    gl_FragColor = vec4(colour, 1.0);
  }`;

function pass(fragmentShader, uniforms, blending = {}) {
  return new THREE.ShaderMaterial({vertexShader: PASS, fragmentShader, depthTest: false, depthWrite: false, uniforms, ...blending});
}

export class Effects {
  constructor(renderer, size) {
    this.renderer = renderer;
    this.depths = new THREE.WebGLRenderTarget(1, 1, {
      depthTexture: new THREE.DepthTexture(1, 1, THREE.UnsignedIntType), minFilter: THREE.NearestFilter, magFilter: THREE.NearestFilter});
    this.shades = new THREE.WebGLRenderTarget(1, 1, {depthBuffer: false});
    this.mask = new THREE.WebGLRenderTarget(1, 1, {depthBuffer: false});
    this.shade = pass(SHADE, {depths: {value: this.depths.depthTexture}, pixel: {value: new THREE.Vector2()},
                              back: {value: new THREE.Matrix4()}, projection: {value: new THREE.Matrix4()},
                              reach: {value: REACH * size}, strength: {value: STRENGTH}});
    this.blend = pass(BLEND, {shades: {value: this.shades.texture}, pixel: {value: new THREE.Vector2()}},
                      {transparent: true, blending: THREE.MultiplyBlending, premultipliedAlpha: true});
    this.outline = pass(OUTLINE, {mask: {value: this.mask.texture}, pixel: {value: new THREE.Vector2()},
                                  colour: {value: new THREE.Color()}, width: {value: LINE}});
    this.white = new THREE.MeshBasicMaterial({color: 0xffffff, side: THREE.DoubleSide});
    this.plain = new THREE.MeshBasicMaterial({colorWrite: false});
    this.quad = new THREE.Mesh(new THREE.PlaneGeometry(2, 2), this.blend);
    this.quad.frustumCulled = false;
    this.flat = new THREE.Camera();
    this.picked = new THREE.Scene();
  }

  #size(target, share) {
    const size = this.renderer.getDrawingBufferSize(new THREE.Vector2());
    target.setSize(Math.max(1, Math.round(share * size.x)), Math.max(1, Math.round(share * size.y)));
    return new THREE.Vector2(1 / target.width, 1 / target.height);
  }

  #onto(target, draw) {
    const {renderer} = this, colour = renderer.getClearColor(new THREE.Color()), alpha = renderer.getClearAlpha();
    renderer.setClearColor(0, 0);
    renderer.setRenderTarget(target);
    renderer.clear();
    draw();
    renderer.setRenderTarget(null);
    renderer.setClearColor(colour, alpha);
  }

  #overlay(material) {
    const {renderer, quad} = this, clears = renderer.autoClear;
    quad.material = material;
    renderer.autoClear = false;
    renderer.render(quad, this.flat);
    renderer.autoClear = clears;
  }

  /** Darkens what lies close together. `world` shows the solids only; `without` are left out of the depths. */
  darken(world, camera, without) {
    const {shade} = this, wasShown = without.map(one => one.visible), shadows = this.renderer.shadowMap.autoUpdate;
    without.forEach(one => { one.visible = false; });
    shade.uniforms.pixel.value.copy(this.#size(this.depths, COARSE));
    this.renderer.shadowMap.autoUpdate = false;
    world.overrideMaterial = this.plain;
    this.#onto(this.depths, () => this.renderer.render(world, camera));
    world.overrideMaterial = null;
    this.renderer.shadowMap.autoUpdate = shadows;
    without.forEach((one, k) => { one.visible = wasShown[k]; });
    shade.uniforms.back.value.copy(camera.projectionMatrixInverse);
    shade.uniforms.projection.value.copy(camera.projectionMatrix);
    this.blend.uniforms.pixel.value.copy(this.#size(this.shades, COARSE));
    this.quad.material = shade;
    const {renderer} = this, colour = renderer.getClearColor(new THREE.Color()), alpha = renderer.getClearAlpha();
    renderer.setClearColor(0xffffff, 1);
    renderer.setRenderTarget(this.shades);
    renderer.clear();
    renderer.render(this.quad, this.flat);
    renderer.setRenderTarget(null);
    renderer.setClearColor(colour, alpha);
    this.#overlay(this.blend);
  }

  /** Draws a line around `mesh`, wherever it is hidden too. */
  ring(mesh, camera, colour) {
    this.outline.uniforms.pixel.value.copy(this.#size(this.mask, 1));
    this.outline.uniforms.width.value = LINE * this.renderer.getPixelRatio();
    this.outline.uniforms.colour.value.set(colour).convertLinearToSRGB();
    mesh.material = this.white;
    this.picked.clear();
    this.picked.add(mesh);
    this.#onto(this.mask, () => this.renderer.render(this.picked, camera));
    this.#overlay(this.outline);
  }
}
