// SPDX-License-Identifier: Apache-2.0
// The run that the page carries: its contents, and its frames, unpacked group by group when they are asked for.

import {joinPlanes, restoreRows, takeChunk} from './chunk.js';
import {WaterGroup} from './water.js';

const FORMAT = 1;
const POSE = 7;     // values per body: position, orientation (w, x, y, z)
const MOTION = 10;  // velocity, angular velocity, contact force, is free
const CONTACT = 10; // point, force on body a, overlap, body a, body b, is sliding

export function readContents() {
  const element = document.getElementById('contents');
  if (!element) {
    throw new Error('This page carries no run. `riprap view RUN` makes one that does.');
  }
  const contents = JSON.parse(element.textContent);
  if (contents.format !== FORMAT) {
    throw new Error(`This page cannot show a run packed in format ${contents.format}.`);
  }
  return contents;
}

export class Recording {
  constructor(contents) {
    this.contents = contents;
    this.times = contents.times;
    this.groups = new Map();
    this.waterGroups = new Map();
    this.bodyCount = contents.bodies ? contents.bodies.shape.length : 0;
  }

  get frameCount() {
    return this.times.length;
  }

  async shapes() {
    const bytes = await takeChunk('shapes');
    return bytes ? JSON.parse(new TextDecoder().decode(bytes)) : [];
  }

  /** Everything of one frame: {time, pose, motion, shown, contacts, water}. */
  async frame(index) {
    const group = Math.floor(index / this.contents.group), within = index % this.contents.group;
    if (!this.groups.has(group)) {
      this.groups.set(group, this.#load(group));
    }
    const [frames, water] = await Promise.all([this.groups.get(group), this.#waterOf(index)]);
    return {...frames[within], water};
  }

  /** Particles of one frame. Their groups are shorter where there are many: a group is unpacked whole. */
  async #waterOf(index) {
    if (!this.contents.water) {
      return undefined;
    }
    const size = this.contents.water.group, group = Math.floor(index / size);
    if (!this.waterGroups.has(group)) {
      this.waterGroups.set(group, takeChunk(`water-${group}`).then(bytes => {
        if (!bytes) {
          throw new Error('the file does not hold it');
        }
        return new WaterGroup(bytes);
      }));
    }
    return (await this.waterGroups.get(group)).frame(index % size);
  }

  /** Unpacks everything, one frame after another. */
  async loadAll() {
    for (let index = 0; index < this.frameCount; ++index) {
      await this.frame(index);
    }
  }

  async #load(group) {
    const first = group * this.contents.group;
    const count = Math.min(this.contents.group, this.frameCount - first);
    const shownCount = this.contents.bodies?.shown?.length ?? 0;
    const [pose, motion, shown, contacts] = await Promise.all([
      this.#rows(`poses-${group}`, Float64Array, POSE), this.#rows(`motion-${group}`, Float32Array, MOTION),
      shownCount ? this.#rows(`shown-${group}`, Float32Array, shownCount) : null,
      takeChunk(`contacts-${group}`)]);
    if (this.contents.bodies && !pose) {
      throw new Error('the file does not hold it');
    }
    const contactRows = contacts ? new Float32Array(joinPlanes(contacts, 4).buffer) : null;
    const frames = [];
    let contactsBefore = 0;
    for (let k = 0; k < count; ++k) {
      const contactCount = this.contents.contacts[first + k] ?? 0;
      frames.push({
        time: this.times[first + k],
        pose: pose?.subarray(k * POSE * this.bodyCount, (k + 1) * POSE * this.bodyCount),
        motion: motion?.subarray(k * MOTION * this.bodyCount, (k + 1) * MOTION * this.bodyCount),
        shown: shown?.subarray(k * shownCount * this.bodyCount, (k + 1) * shownCount * this.bodyCount),
        contacts: contactRows?.subarray(CONTACT * contactsBefore, CONTACT * (contactsBefore + contactCount)),
      });
      contactsBefore += contactCount;
    }
    return frames;
  }

  async #rows(name, Type, perBody) {
    const planes = await takeChunk(name);
    if (!planes) {
      return null;
    }
    const width = Type.BYTES_PER_ELEMENT;
    return new Type(restoreRows(joinPlanes(planes, width), width * perBody * this.bodyCount).buffer);
  }

  async table(description) {
    const planes = await takeChunk(description.chunk) ?? new Uint8Array();
    const values = new Float64Array(joinPlanes(planes, 8).buffer);
    const columns = description.columns.map((column, k) => (
      {...column, values: values.subarray(k * description.rows, (k + 1) * description.rows)}));
    return {name: description.name, time: columns[0].values, columns: columns.slice(1)};
  }
}

/** What is known of one body in one frame, in SI units. */
export function bodyOf(contents, frame, body) {
  const p = frame.pose.subarray(POSE * body, POSE * (body + 1));
  const m = frame.motion.subarray(MOTION * body, MOTION * (body + 1));
  return {
    id: body,
    name: contents.bodies.names?.[body] ?? `body ${body}`,
    mass: contents.bodies.mass?.[body],
    position: p.subarray(0, 3),
    orientation: p.subarray(3, 7),
    velocity: m.subarray(0, 3),
    angularVelocity: m.subarray(3, 6),
    contactForce: m.subarray(6, 9),
    isFree: m[9] > 0,
    shown: (contents.bodies.shown ?? []).map((field, f, all) => ({...field, value: frame.shown?.[all.length * body + f]})),
  };
}

/** Contacts of a frame that touch `body`. */
export function contactsOf(frame, body) {
  const rows = [];
  for (let at = 0; at < (frame.contacts?.length ?? 0); at += CONTACT) {
    const row = frame.contacts.subarray(at, at + CONTACT);
    if (row[7] === body || row[8] === body) {
      rows.push({other: row[7] === body ? row[8] : row[7], force: Math.hypot(row[3], row[4], row[5]), overlap: row[6],
                 isSliding: row[9] > 0});
    }
  }
  return rows.sort((a, b) => b.force - a.force);
}

export const POSE_VALUES = POSE, MOTION_VALUES = MOTION, CONTACT_VALUES = CONTACT;
