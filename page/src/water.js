// SPDX-License-Identifier: Apache-2.0
// Groups of frames of water, as src/riprap/view/water_stream.hpp defines them.

const CHANNELS = 5;
const LONGEST_WORK = 12;  // milliseconds between two breaths

/** Lets the page breathe: long work is cut where this is awaited. */
const breathe = () => new Promise(resolve => setTimeout(resolve, 0));

/** One channel of a frame from its residuals; `last` and `before` are the same channel of the frames before. */
function restoreChannel(code, low, high, last, before) {
  const past = code >> 1, usesNeighbour = (code & 1) !== 0;
  const numbers = new Uint16Array(low.length);
  let neighbour = 0;
  for (let i = 0; i < numbers.length; ++i) {
    const zigzag = low[i] | high[i] << 8;
    let difference = zigzag >> 1 ^ -(zigzag & 1);
    if (usesNeighbour) {
      difference += neighbour;
    }
    neighbour = difference & 0xffff;
    numbers[i] = difference + (past === 0 ? 0 : past === 1 ? last[i] : 2 * last[i] - before[i]);
  }
  return numbers;
}

/** Four numbers a particle, as the graphics card takes them: x, y, z, and pressure times 256 plus speed. */
function interleave([x, y, z, pressure, speed]) {
  const cells = new Uint16Array(4 * x.length);
  for (let i = 0, to = 0; i < x.length; ++i, to += 4) {
    cells[to] = x[i];
    cells[to + 1] = y[i];
    cells[to + 2] = z[i];
    cells[to + 3] = pressure[i] << 8 | speed[i];
  }
  return cells;
}

/** The frames of a group. Each is guessed from those before it, so they are unpacked in order, as far as is asked. */
export class WaterGroup {
  constructor(bytes) {
    const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
    const frameCount = view.getUint32(0, true);
    this.bytes = bytes;
    this.begins = [0];  // of the particles of each frame among those of all
    for (let f = 0; f < frameCount; ++f) {
      this.begins.push(this.begins[f] + view.getUint32(4 + 5 * f, true));
    }
    this.begin = 4 + 5 * frameCount;  // of the first channel
    this.frames = [];
    this.last = this.before = [];
  }

  /** x, y, z in steps from the origin, and pressure times 256 plus speed, both 0 to 255, of every particle. */
  async frame(index) {
    while (this.frames.length <= index) {
      this.next ??= this.#unpackNext().finally(() => { this.next = null; });
      await this.next;
    }
    return this.frames[index];
  }

  async #unpackNext() {
    const f = this.frames.length, frameCount = this.begins.length - 1, all = this.begins[frameCount];
    const [from, to] = [this.begins[f], this.begins[f + 1]];
    const channels = [];
    let since = performance.now();
    for (let c = 0; c < CHANNELS; ++c) {
      const guesses = this.begin + c * (frameCount + 2 * all), low = guesses + frameCount, high = low + all;
      channels.push(restoreChannel(this.bytes[guesses + f], this.bytes.subarray(low + from, low + to),
                                   this.bytes.subarray(high + from, high + to), this.last[c], this.before[c]));
      if (performance.now() - since > LONGEST_WORK) {
        await breathe();
        since = performance.now();
      }
    }
    this.frames.push(interleave(channels));
    [this.before, this.last] = [this.last, channels];
    if (this.frames.length === frameCount) {
      this.bytes = this.last = this.before = null;
    }
  }
}
