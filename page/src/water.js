// SPDX-License-Identifier: Apache-2.0
// Groups of frames of water, as src/riprap/view/water_stream.hpp defines them.

const CHANNELS = 5;

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

/**
 * The frames of a group, each four numbers a particle: x, y, z in steps from the origin, and pressure times 256 plus
 * speed, both 0 to 255.
 */
export async function decodeGroup(bytes) {
  const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
  const frameCount = view.getUint32(0, true);
  const counts = [];
  let at = 4, all = 0;
  for (let f = 0; f < frameCount; ++f, at += 5) {
    counts.push(view.getUint32(at, true));
    all += counts[f];
  }
  const frames = counts.map(count => new Uint16Array(4 * count));
  let since = performance.now();
  for (let c = 0; c < CHANNELS; ++c) {
    const guesses = at, low = at + frameCount, high = low + all;
    let last = null, before = null;
    for (let f = 0, from = 0; f < frameCount; from += counts[f], ++f) {
      const numbers = restoreChannel(bytes[guesses + f], bytes.subarray(low + from, low + from + counts[f]),
                                     bytes.subarray(high + from, high + from + counts[f]), last, before);
      const packed = frames[f];
      if (c < 3) {
        numbers.forEach((number, i) => { packed[4 * i + c] = number; });
      } else {
        const shift = c === 3 ? 8 : 0;
        numbers.forEach((number, i) => { packed[4 * i + 3] |= number << shift; });
      }
      [before, last] = [last, numbers];
      if (performance.now() - since > 12) {
        await breathe();
        since = performance.now();
      }
    }
    at = high + all;
  }
  return frames;
}
