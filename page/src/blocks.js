// SPDX-License-Identifier: Apache-2.0
// Blocks: one instanced mesh per shape, with its edges drawn as lines over the same matrices. Fixed bodies are solid
// behind the water, and glass where they would hide it.

import * as THREE from 'three';
import {FIXED, MAPS, colourAt, materialColour} from './colours.js';
import {upOf} from './framing.js';
import {groundGeometry, groundMaterial, isOpen, rimOf, welded} from './ground.js';
import {planesOf} from './planes.js';
import {MOTION_VALUES as MOTION, POSE_VALUES as POSE} from './recording.js';
import {Stresses} from './stresses.js';

const FAINT = 0.16;       // opacity of fixed bodies before water
const WALL = 0.12;        // of upright half-spaces
const FLOOR = 0.35;       // of others
const HIDING = 0.3;       // share of sight lines to the water that a body must block to become glass
const MOST_ALONE = 40;    // fixed bodies of one shape that are drawn one by one
const FLAT = 1 - 1e-6;      // cosine between the normals of two faces of one plane
const MANY_FACES = 60;      // from here on a shape is round, and
const ROUND = 0.94;         // faces within 20 degrees are one to the eye
const MOST_TRIANGLES = 60_000;  // that sight lines are tried against

const EDGE_VERTEX = `
  attribute mat4 block;
  void main() {
    vec4 place = modelViewMatrix * block * vec4(position, 1.0);
    // Towards the eye, so that a face does not hide its own edges; without perspective that is along z.
    place.xyz *= projectionMatrix[3][3] == 0.0 ? vec3(0.9995) : vec3(1.0, 1.0, 0.9995);
    gl_Position = projectionMatrix * place;
  }`;
const EDGE_FRAGMENT = `
  uniform vec3 colour;
  uniform float opacity;
  void main() { gl_FragColor = vec4(colour, opacity); }`;

function trianglesOf(shape) {
  const positions = [];
  for (const face of shape.faces) {
    for (let k = 1; k + 1 < face.length; ++k) {
      for (const corner of [face[0], face[k], face[k + 1]]) {
        positions.push(...shape.corners.slice(3 * corner, 3 * corner + 3));
      }
    }
  }
  const geometry = new THREE.BufferGeometry();
  geometry.setAttribute('position', new THREE.Float32BufferAttribute(positions, 3));
  geometry.computeVertexNormals();  // no corner is shared, so every face keeps its own
  return geometry;
}

/** Newell's normal of a face, of length 1. */
function normalOf(shape, face) {
  const at = corner => new THREE.Vector3().fromArray(shape.corners, 3 * corner), normal = new THREE.Vector3();
  for (let k = 1; k + 1 < face.length; ++k) {
    normal.add(at(face[k]).sub(at(face[0])).cross(at(face[k + 1]).sub(at(face[0]))));
  }
  return normal.normalize();
}

/** Lines along which a shape bends. Seams between its convex parts, flat on both sides, are none of them. */
export function edgesOf(shape) {
  const whole = welded(shape), edges = new Map(), times = new Map();
  const flat = whole.faces.length > MANY_FACES ? ROUND : FLAT;
  const nameOf = corners => [...corners].sort((a, b) => a - b).join(' ');
  for (const face of whole.faces) {
    times.set(nameOf(face), (times.get(nameOf(face)) ?? 0) + 1);
  }
  for (const face of whole.faces.filter(face => times.get(nameOf(face)) === 1)) {  // the others lie between two parts
    const normal = normalOf(whole, face);
    face.forEach((a, k) => {
      const b = face[(k + 1) % face.length], key = nameOf([a, b]), other = edges.get(key);
      edges.set(key, {a, b, normal, isSeam: other !== undefined && other.normal.dot(normal) > flat});
    });
  }
  const lines = [...edges.values()].filter(({a, b, isSeam}) => a !== b && !isSeam);
  return lines.flatMap(({a, b}) => [a, b].flatMap(corner => whole.corners.slice(3 * corner, 3 * corner + 3)));
}

export const wordsOf = name => name.replaceAll('_', ' ');

export class Blocks {
  constructor(contents, shapes, first, box) {
    this.contents = contents;
    this.first = first.pose;
    this.group = new THREE.Group();
    this.meshes = [];
    this.lines = [];
    this.colourBy = 'material';
    this.selected = -1;
    this.edgeColour = new THREE.Color(0x000000);
    this.wallColour = new THREE.Color(0x000000);
    this.up = upOf(contents);
    const bodies = contents.bodies;
    const isFixed = body => first.motion[MOTION * body + 9] === 0;
    this.dry = new Set(bodies.dry ?? []);  // bodies that the water goes through
    shapes.forEach((shape, s) => {
      if (shape.faces.length > 1) {
        const members = bodies.shape.flatMap((of, body) => of === s ? [body] : []);
        for (const isDry of [true, false]) {
          this.#add(shape, members.filter(body => !isFixed(body) && this.dry.has(body) === isDry));
        }
        const whole = contents.is_planar ? shape : welded(shape);
        if (!contents.is_planar && isOpen(whole)) {
          this.#addGround(whole, members.filter(isFixed));
        } else {
          const still = members.filter(isFixed);  // one hides the water, another does not
          (still.length > MOST_ALONE ? [still] : still.map(body => [body])).forEach(some => this.#add(shape, some));
        }
      }
    });
    planesOf(bodies, shapes, first.pose, box).forEach((shape, body) => this.#add(shape, [body]));
    this.stresses = new Stresses(contents, shapes);
    this.group.add(this.stresses.group);
  }

  #add(shape, members) {
    if (members.length === 0) {
      return;
    }
    const isPlane = shape.faces.length === 1;
    const material = new THREE.MeshLambertMaterial({side: THREE.FrontSide, flatShading: true});
    if (isPlane) {  // a wall is seen from the side of the blocks only, and lets edges behind it through
      Object.assign(material, {transparent: true, depthWrite: false, opacity: this.#isUpright(shape, members[0]) ? WALL : FLOOR});
    }
    this.#addMesh(trianglesOf(shape), material, members, edgesOf(shape), {isPlane});
  }

  #isUpright(shape, body) {
    const [a, b, c] = shape.faces[0].map(k => new THREE.Vector3().fromArray(shape.corners, 3 * k)), p = this.first;
    const normal = b.sub(a).cross(c.sub(a)).normalize().applyQuaternion(
        new THREE.Quaternion(p[POSE * body + 4], p[POSE * body + 5], p[POSE * body + 6], p[POSE * body + 3]));
    return Math.abs(normal.dot(this.up)) < 0.5;
  }

  #addGround(shape, members) {
    if (members.length > 0) {
      this.#addMesh(groundGeometry(shape), groundMaterial(shape, this.up), members, rimOf(shape), {isPlane: false});
    }
  }

  #addMesh(geometry, material, members, edgePlaces, {isPlane}) {
    const mesh = new THREE.InstancedMesh(geometry, material, members.length);
    mesh.frustumCulled = false;
    mesh.renderOrder = isPlane ? -1 : 0;
    mesh.userData = {members, isPlane, isFaint: false};
    mesh.castShadow = !isPlane;
    mesh.receiveShadow = true;
    mesh.instanceColor = new THREE.InstancedBufferAttribute(new Float32Array(3 * members.length), 3);
    const lines = new THREE.InstancedBufferGeometry();
    lines.setAttribute('position', new THREE.Float32BufferAttribute(edgePlaces, 3));
    lines.setAttribute('block', mesh.instanceMatrix);
    lines.instanceCount = members.length;
    const edges = new THREE.LineSegments(lines, new THREE.ShaderMaterial({
      vertexShader: EDGE_VERTEX, fragmentShader: EDGE_FRAGMENT, transparent: true,
      uniforms: {colour: {value: isPlane ? this.wallColour : this.edgeColour}, opacity: {value: isPlane ? 0.3 : 0.8}}}));
    edges.frustumCulled = false;
    edges.visible = !isPlane || this.contents.is_planar;  // there a wall is seen from its edge
    this.group.add(mesh, edges);
    this.meshes.push(mesh);
    this.lines.push(edges);
  }

  show(frame) {
    this.frame = frame;
    const matrix = new THREE.Matrix4(), place = new THREE.Vector3(), turn = new THREE.Quaternion();
    const one = new THREE.Vector3(1, 1, 1);
    for (const mesh of this.meshes) {
      mesh.userData.members.forEach((body, i) => {
        const p = frame.pose, at = POSE * body;
        place.set(p[at], p[at + 1], p[at + 2]);
        turn.set(p[at + 4], p[at + 5], p[at + 6], p[at + 3]);
        mesh.setMatrixAt(i, matrix.compose(place, turn, one));
      });
      mesh.instanceMatrix.needsUpdate = true;
      mesh.boundingSphere = null;  // of the picking ray; the blocks have moved
    }
    this.paint();
  }

  /** The range of what the blocks are coloured by: {label, unit, low (0 if not given), high}, or null for materials. */
  range() {
    const bodies = this.contents.bodies;
    switch (this.colourBy) {
      case 'speed': return {label: 'speed of blocks', unit: 'm/s', high: bodies.most_speed};
      case 'displacement': return {label: 'displacement of blocks', unit: 'm', high: bodies.most_displacement};
      case 'force': return {label: 'contact force on blocks', unit: this.contents.is_planar ? 'N/m' : 'N', high: bodies.most_force};
      default: {
        const field = this.#field();
        return field ? {label: `${wordsOf(field.name)} of blocks`, unit: field.unit, low: field.low, high: field.high} : null;
      }
    }
  }

  /** The field of the solid method that blocks are coloured by, if any. */
  #field() {
    return this.contents.bodies.shown?.find(field => field.name === this.colourBy);
  }

  /** What the colours of materials mean: [[name, colour]]. */
  names() {
    const {material, material_names: names} = this.contents.bodies;
    const isFree = body => this.frame.motion[MOTION * body + 9] > 0, bodies = material.map((_, body) => body);
    const used = [...new Set(bodies.filter(isFree).map(body => material[body]))].sort((a, b) => a - b);
    const list = used.map(m => [names?.[m] ?? `material ${m + 1}`, materialColour(m)]);
    return bodies.every(isFree) ? list : [...list, ['fixed or driven', FIXED]];
  }

  #valueOf(body) {
    const m = this.frame.motion, p = this.frame.pose, first = this.first;
    switch (this.colourBy) {
      case 'speed': return Math.hypot(...m.subarray(MOTION * body, MOTION * body + 3));
      case 'force': return Math.hypot(...m.subarray(MOTION * body + 6, MOTION * body + 9));
      case 'displacement': return Math.hypot(...[0, 1, 2].map(k => p[POSE * body + k] - first[POSE * body + k]));
      default: {
        const fields = this.contents.bodies.shown;
        return this.frame.shown[fields.length * body + fields.indexOf(this.#field())];
      }
    }
  }

  paint() {
    this.#colourEdges();
    this.stresses.show(this.frame, this.colourBy);
    const range = this.range(), colour = new THREE.Color();
    for (const mesh of this.meshes) {
      mesh.userData.members.forEach((body, i) => {
        const isFixed = this.frame.motion[MOTION * body + 9] === 0;
        if (range && !isFixed) {
          const low = range.low ?? 0, share = (this.#valueOf(body) - low) / (range.high - low || 1);
          colour.setRGB(...colourAt(MAPS.cividis, share).map(c => c / 255),
                        THREE.SRGBColorSpace);
        } else {
          colour.setHex(mesh.userData.isPlane ? 0xc9ccd0 : isFixed ? FIXED : materialColour(this.contents.bodies.material[body]));
        }
        mesh.setColorAt(i, colour);
      });
      mesh.instanceColor.needsUpdate = true;
    }
  }

  setTheme(theme) {
    this.isDark = theme === 'dark';
    this.meshes.forEach(mesh => mesh.material.userData.setTheme?.(theme));
    this.#colourEdges();
  }

  /** Edges stand out from the faces, those of glass from what is behind it, walls seen from their edge from the background. */
  #colourEdges() {
    const isByValue = this.colourBy !== 'material';  // whose lowest colours are dark
    this.edgeColour.setHex(!this.isDark ? 0x222222 : this.isGlass ? 0xaab2ba : isByValue ? 0x8b949e : 0x0c0d0f);
    this.wallColour.setHex(this.isDark ? 0xffffff : 0x222222);
  }

  /** See-through blocks, so that what lies between them can be seen. */
  setGlass(isGlass) {
    this.isGlass = isGlass;
    this.#colourEdges();
    for (const mesh of this.meshes.filter(m => !m.userData.isPlane && !m.userData.isFaint)) {
      Object.assign(mesh.material, {transparent: isGlass, opacity: isGlass ? 0.3 : 1, depthWrite: !isGlass});
      mesh.material.needsUpdate = true;
    }
  }

  /** Makes glass of fixed bodies that stand between an eye and places of the water, and solid of the others. */
  clearSight(eyes, places) {
    const caster = new THREE.Raycaster();
    this.meshes.forEach((mesh, k) => {
      const {geometry, userData} = mesh, triangles = (geometry.index ?? geometry.getAttribute('position')).count / 3;
      const isFixed = !userData.isPlane && this.frame.motion[MOTION * userData.members[0] + 9] === 0;
      if (!isFixed || triangles * userData.members.length > MOST_TRIANGLES) {
        return;
      }
      const stopped = places.filter((place, i) => {
        const way = place.clone().sub(eyes[i]), far = way.length();
        caster.set(eyes[i], way.normalize());
        caster.far = 0.995 * far;
        return caster.intersectObject(mesh, false).length > 0;
      });
      this.#setFaint(mesh, this.lines[k], stopped.length > HIDING * places.length);
    });
  }

  #setFaint(mesh, edges, isFaint) {
    if (mesh.userData.isFaint !== isFaint) {
      mesh.userData.isFaint = isFaint;
      mesh.castShadow = mesh.receiveShadow = !isFaint;
      Object.assign(mesh.material, {transparent: isFaint, opacity: isFaint ? FAINT : 1, depthWrite: !isFaint});
      mesh.material.needsUpdate = true;
      edges.material.uniforms.opacity.value = isFaint ? 0.3 : 0.8;
    }
  }

  /** Draws what water does not go through by itself. */
  drawnAlone(draw) {
    const hidden = [];
    this.meshes.forEach((mesh, k) => {
      if (mesh.userData.isPlane || this.dry.has(mesh.userData.members[0])) {
        hidden.push(...[mesh, this.lines[k]].filter(one => one.visible));
      }
    });
    hidden.forEach(one => { one.visible = false; });
    draw();
    hidden.forEach(one => { one.visible = true; });
  }

  /** The body under a ray, or -1. */
  pick(raycaster) {
    const hits = raycaster.intersectObjects(this.meshes.filter(m => !m.userData.isPlane), false);
    const hit = hits.find(h => !h.object.userData.isFaint) ?? hits[0];  // one sees through faint ones
    return hit ? hit.object.userData.members[hit.instanceId] : -1;
  }

  isFree(body) {
    return this.frame.motion[MOTION * body + 9] > 0;
  }

  /** Where the selected body is, else the middle of the free ones; null where there are none. */
  middleOf(frame) {
    const all = [...Array(frame.pose ? frame.pose.length / POSE : 0).keys()];
    const bodies = this.selected >= 0 ? [this.selected] : all.filter(body => frame.motion[MOTION * body + 9] > 0);
    const sum = new THREE.Vector3();
    bodies.forEach(body => sum.add(new THREE.Vector3().fromArray(frame.pose, POSE * body)));
    return bodies.length > 0 ? sum.divideScalar(bodies.length) : null;
  }

  /** What is drawn without hiding what is behind it. */
  withoutDepth() {
    return [...this.meshes.filter(mesh => mesh.userData.isFaint), ...this.lines];
  }

  /** The selected body alone, for its outline; null where none is selected. */
  pickedMesh() {
    const of = this.selected < 0 ? null : this.meshes.find(mesh => mesh.userData.members.includes(this.selected));
    if (!of) {
      return null;
    }
    const mesh = new THREE.Mesh(of.geometry);
    of.getMatrixAt(of.userData.members.indexOf(this.selected), mesh.matrix);
    mesh.matrix.decompose(mesh.position, mesh.quaternion, mesh.scale);
    mesh.matrixAutoUpdate = false;
    mesh.matrixWorldNeedsUpdate = true;
    mesh.frustumCulled = false;
    return mesh;
  }
}
