// SPDX-License-Identifier: Apache-2.0
// Water as a surface, made on the screen: the depths of the particles are smoothed and shaded as one face, and how much
// water lies behind says how much shows through. In a planar scene the sum of soft dots is water where it is above a
// level, with a line along its edge.

import * as THREE from 'three';

const BALL = 2.2;      // diameter of what a particle covers, in spacings
const DOT = 3.0;       // the same in a planar scene: rows of soft dots overlap, their sum is 1.6 inside and half of it at the edge
const COARSE = 0.5;   // of the pixels of the picture, for the amount of water
const ROUNDS = 2;      // times that depths are smoothed
const COLOURS = {
  light: {deep: 0x0f4c81, shallow: 0x58b6d8, sky: 0xe8f2f8}, dark: {deep: 0x0d3f6e, shallow: 0x3f9cc4, sky: 0xb9d3e4}};
const PASS = `
  varying vec2 at;
  void main() { at = 0.5 * position.xy + 0.5; gl_Position = vec4(position.xy, 0.0, 1.0); }`;
const PLACE = `
  uniform vec3 origin;
  uniform float step, ball, pixels, stretch;
  attribute vec4 cell;
  varying float depth;
  void main() {
    vec4 place = modelViewMatrix * vec4(origin + step * cell.xyz, 1.0);
    depth = -place.z;
    gl_Position = projectionMatrix * place;
    gl_PointSize = max(2.0, stretch * ball * pixels * projectionMatrix[1][1] / gl_Position.w);
  }`;
const DEPTH = `
  uniform float ball, stretch;
  varying float depth;
  void main() {
    vec2 d = (2.0 * gl_PointCoord - 1.0) * vec2(stretch, 1.0);
    float r2 = dot(d, d);
    if (r2 > 1.0) discard;
    float here = depth - 0.5 * ball * sqrt(1.0 - r2);
    gl_FragColor = vec4(here, 0.0, 0.0, 1.0);
    gl_FragDepth = clamp(here / (here + 1.0e3 * ball), 0.0, 1.0);
  }`;
const AMOUNT = `
  uniform float ball, stretch;
  void main() {
    vec2 d = (2.0 * gl_PointCoord - 1.0) * vec2(stretch, 1.0);
    float r2 = dot(d, d);
    if (r2 > 1.0) discard;
    gl_FragColor = vec4(exp(-4.0 * r2) - 0.018, 0.0, 0.0, 1.0);
  }`;
const SMOOTH = `
  uniform sampler2D depths;
  uniform vec2 along;
  uniform float ball, reach, isFlat;
  varying vec2 at;
  void main() {
    float here = texture2D(depths, at).r;
    if (here <= 0.0) { gl_FragColor = vec4(0.0); return; }
    float radius = clamp(reach / (isFlat > 0.5 ? 1.0 : here), 1.0, 40.0);
    float sum = 0.0, weight = 0.0;
    for (int k = -12; k <= 12; ++k) {
      float t = float(k) / 12.0;
      float there = texture2D(depths, at + along * radius * t).r;
      if (there <= 0.0) continue;
      // Depths that differ by more belong to another face of the water.
      float far = (there - here) / (1.5 * ball);
      float w = exp(-3.0 * t * t) * exp(-far * far);
      sum += w * there;
      weight += w;
    }
    gl_FragColor = vec4(sum / weight, 0.0, 0.0, 1.0);
  }`;
const SHADE = `
  uniform sampler2D depths, amounts;
  uniform vec2 pixel, view;
  uniform vec3 up, deep, shallow, sky;
  uniform mat4 projection;
  uniform float isFlat, isPlane, ball;
  varying vec2 at;
  vec3 placeOf(vec2 p) {
    float depth = texture2D(depths, p).r;
    vec2 seen = (2.0 * p - 1.0) * view * (isFlat > 0.5 ? 1.0 : depth);
    return vec3(seen, -depth);
  }
  vec3 slope(vec2 by, vec3 here) {
    vec3 a = placeOf(at + by) - here, b = here - placeOf(at - by);
    bool hasA = texture2D(depths, at + by).r > 0.0, hasB = texture2D(depths, at - by).r > 0.0;
    return !hasA ? b : !hasB ? a : abs(a.z) < abs(b.z) ? a : b;
  }
  void main() {
    float amount = texture2D(amounts, at).r;
    if (isPlane > 0.5) {
      float level = 0.75, soft = max(fwidth(amount), 1.0e-4);
      float inside = smoothstep(level - soft, level + soft, amount);
      if (inside <= 0.0) discard;
      float line = 1.0 - smoothstep(0.0, 2.5, abs(amount - level) / soft);
      gl_FragColor = vec4(mix(shallow, deep, max(line, 0.25)), 0.82 * inside);
      gl_FragDepth = 1.0;
      return;
    }
    vec3 here = placeOf(at);
    float edge = smoothstep(0.25, 0.6, amount);  // the rim of the outermost balls is no water
    if (here.z >= 0.0 || edge <= 0.0) discard;
    vec3 normal = normalize(cross(slope(vec2(pixel.x, 0.0), here), slope(vec2(0.0, pixel.y), here)));
    vec3 eye = isFlat > 0.5 ? vec3(0.0, 0.0, 1.0) : normalize(-here);
    float facing = clamp(dot(normal, eye), 0.0, 1.0);
    float mirror = 0.04 + 0.6 * pow(1.0 - facing, 4.0);
    vec3 lamp = normalize(up + 0.55 * eye + vec3(-0.45, 0.15, 0.0));
    float light = 0.55 + 0.45 * clamp(dot(normal, lamp), 0.0, 1.0);
    float shine = pow(clamp(dot(reflect(-lamp, normal), eye), 0.0, 1.0), 60.0);
    float thick = 1.0 - exp(-0.22 * amount);
    vec3 colour = mix(mix(shallow, deep, thick) * light, sky, mirror) + 0.3 * shine;
    gl_FragColor = vec4(colour, edge * mix(0.45, 0.96, thick));
    vec4 clip = projection * vec4(here, 1.0);
    gl_FragDepth = clamp(0.5 * clip.z / clip.w + 0.5, 0.0, 1.0);
  }`;

const target = type => new THREE.WebGLRenderTarget(1, 1, {
  type, format: THREE.RGBAFormat, minFilter: THREE.NearestFilter, magFilter: THREE.NearestFilter});

export class WaterSurface {
  /** `particles` gives the geometry; its own picture is hidden while the surface is drawn. */
  constructor(particles, isPlanar) {
    this.particles = particles;
    this.isPlanar = isPlanar;
    this.isOn = false;
    const {water} = particles;
    this.spacing = water.spacing;
    const shared = {origin: {value: new THREE.Vector3(...water.origin)}, step: {value: water.step},
                    ball: {value: (isPlanar ? DOT : BALL) * water.spacing}, pixels: {value: 1},
                    stretch: {value: 1}};
    this.shared = shared;
    this.depthMaterial = new THREE.ShaderMaterial({vertexShader: PLACE, fragmentShader: DEPTH, uniforms: shared});
    this.amountMaterial = new THREE.ShaderMaterial({
      vertexShader: PLACE, fragmentShader: AMOUNT, uniforms: shared, depthTest: false, depthWrite: false,
      blending: THREE.CustomBlending, blendSrc: THREE.OneFactor, blendDst: THREE.OneFactor});
    this.smooth = new THREE.ShaderMaterial({
      vertexShader: PASS, fragmentShader: SMOOTH, depthTest: false, depthWrite: false,
      uniforms: {depths: {value: null}, along: {value: new THREE.Vector2()}, ball: shared.ball, reach: {value: 1},
                 isFlat: {value: 0}}});
    this.shade = new THREE.ShaderMaterial({
      vertexShader: PASS, fragmentShader: SHADE, transparent: true, depthWrite: !isPlanar,
      depthFunc: isPlanar ? THREE.AlwaysDepth : THREE.LessEqualDepth,
      uniforms: {depths: {value: null}, amounts: {value: null}, pixel: {value: new THREE.Vector2()},
                 view: {value: new THREE.Vector2()}, up: {value: new THREE.Vector3()},
                 projection: {value: new THREE.Matrix4()}, isFlat: {value: 0}, isPlane: {value: isPlanar ? 1 : 0},
                 ball: shared.ball, deep: {value: new THREE.Color()}, shallow: {value: new THREE.Color()},
                 sky: {value: new THREE.Color()}}});
    this.dots = new THREE.Points(particles.geometry, this.depthMaterial);
    this.dots.frustumCulled = false;
    this.dots.matrixAutoUpdate = false;
    this.quad = new THREE.Mesh(new THREE.PlaneGeometry(2, 2), this.smooth);
    this.quad.frustumCulled = false;
    this.camera = new THREE.Camera();
    this.setTheme('light');
    this.depths = target(THREE.FloatType);
    this.other = target(THREE.FloatType);
    this.amounts = target(THREE.HalfFloatType);
    this.amounts.texture.minFilter = this.amounts.texture.magFilter = THREE.LinearFilter;
  }

  /** Lies where the run is drawn. */
  follow(matrix) {
    this.dots.matrix.copy(matrix);
    this.dots.matrixWorldNeedsUpdate = true;
  }

  /** Heights are drawn so many times. */
  setStretch(factor) {
    this.shared.stretch.value = factor;
  }

  setTheme(theme) {
    const {deep, shallow, sky} = this.shade.uniforms;
    this.colour = COLOURS[theme].shallow;
    [[deep, 'deep'], [shallow, 'shallow'], [sky, 'sky']].forEach(([uniform, name]) => uniform.value.set(COLOURS[theme][name]).convertLinearToSRGB());
  }

  /** Draws over what is on the canvas, before and behind it. */
  draw(renderer, camera, up) {
    if (!this.isOn || !this.particles.geometry.getAttribute('cell')) {
      return;
    }
    const size = renderer.getDrawingBufferSize(new THREE.Vector2()), isFlat = camera.isOrthographicCamera === true;
    for (const one of [this.depths, this.other]) {
      one.setSize(size.x, size.y);
    }
    // The thickness of the water varies slowly, so coarse pixels do; in planar scenes it draws the surface itself.
    const coarse = this.isPlanar ? 1 : COARSE;
    this.amounts.setSize(Math.ceil(coarse * size.x), Math.ceil(coarse * size.y));
    const tan = isFlat ? (camera.top - camera.bottom) / (2 * camera.zoom) : Math.tan(camera.fov * Math.PI / 360);
    const clearColour = renderer.getClearColor(new THREE.Color()), clearAlpha = renderer.getClearAlpha();
    renderer.setClearColor(0, 0);
    const render = (what, onto, material) => {
      what.material = material;
      renderer.setRenderTarget(onto);
      renderer.clear();
      renderer.render(what, what === this.dots ? camera : this.camera);
    };
    this.shared.pixels.value = coarse * size.y / 2;
    render(this.dots, this.amounts, this.amountMaterial);
    this.shared.pixels.value = size.y / 2;
    if (!this.isPlanar) {
      render(this.dots, this.depths, this.depthMaterial);
      const {uniforms} = this.smooth;
      uniforms.reach.value = 1.6 * this.spacing * size.y / (2 * tan);
      uniforms.isFlat.value = isFlat ? 1 : 0;
      for (let round = 0; round < ROUNDS; ++round) {
        for (const along of [[1 / size.x, 0], [0, 1 / size.y]]) {
          uniforms.depths.value = this.depths.texture;
          uniforms.along.value.set(...along);
          render(this.quad, this.other, this.smooth);
          [this.depths, this.other] = [this.other, this.depths];
        }
      }
    }
    renderer.setRenderTarget(null);
    renderer.setClearColor(clearColour, clearAlpha);
    const {uniforms} = this.shade;
    uniforms.depths.value = this.depths.texture;
    uniforms.amounts.value = this.amounts.texture;
    uniforms.pixel.value.set(1 / size.x, 1 / size.y);
    uniforms.view.value.set(tan * size.x / size.y, tan);
    uniforms.up.value.copy(up).transformDirection(camera.matrixWorldInverse);
    uniforms.projection.value.copy(camera.projectionMatrix);
    uniforms.isFlat.value = isFlat ? 1 : 0;
    this.quad.material = this.shade;
    const clears = renderer.autoClear;
    renderer.autoClear = false;
    renderer.render(this.quad, this.camera);
    renderer.autoClear = clears;
  }
}
