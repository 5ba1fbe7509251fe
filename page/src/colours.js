// SPDX-License-Identifier: Apache-2.0
// Colours that stay apart for colour-blind eyes and in grey: viridis and cividis at ten stops, and the eight colours of
// Okabe and Ito for lines.

const VIRIDIS = [
  0x440154, 0x482878, 0x3e4989, 0x31688e, 0x26828e, 0x1f9e89, 0x35b779, 0x6ece58, 0xb5de2b, 0xfde725];
const CIVIDIS = [
  0x00224e, 0x123570, 0x3b496c, 0x575d6d, 0x707173, 0x8a8678, 0xa59c74, 0xc3b369, 0xe1cc55, 0xfee838];

export const MAPS = {viridis: VIRIDIS, cividis: CIVIDIS};

export const LINES = ['#0072b2', '#e69f00', '#009e73', '#d55e00', '#cc79a7', '#56b4e9', '#b3a125', '#888888'];

/** Stone, wood, and what else blocks are made of; materials beyond the last begin again. */
const MATERIALS = [0xb9a98c, 0x8fa6b8, 0xc48f6a, 0x93a878, 0xa88fb0, 0xc9b75e];

export const materialColour = material => MATERIALS[material % MATERIALS.length];

/** Of bodies that are fixed or driven. */
export const FIXED = 0x9a9a96;

export const css = colour => '#' + colour.toString(16).padStart(6, '0');

/** Red, green, blue, 0 to 255, of a share between 0 and 1. */
export function colourAt(map, share) {
  const at = Math.min(Math.max(share, 0), 1) * (map.length - 1);
  const k = Math.min(Math.floor(at), map.length - 2), part = at - k;
  return [16, 8, 0].map(shift => {
    const a = map[k] >> shift & 255, b = map[k + 1] >> shift & 255;
    return Math.round(a + part * (b - a));
  });
}

export function gradient(map) {
  return `linear-gradient(to right, ${map.map(css).join(', ')})`;
}
