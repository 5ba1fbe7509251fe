// SPDX-License-Identifier: Apache-2.0

/** Digits that a reading shows; the end-to-end tests compare as many with the tables of the run. */
export const DIGITS = 7;

export function reading(value, digits = DIGITS) {
  if (typeof value !== 'number' || Number.isNaN(value)) {  // JSON has null for what is no number
    return 'not known';
  }
  return value === 0 ? '0' : Number(value.toPrecision(digits)).toString().replace('-', '\u2212');
}

/** Short, for axes and legends. */
export function short(value) {
  return reading(value, 3);
}

/** A mark of an axis, with the digits that tell it from its neighbours. */
export function tickText(value, step) {
  const largest = Math.max(Math.abs(value), step);
  return reading(Math.abs(value) < 1e-9 * step ? 0 : value, Math.min(Math.max(1, Math.ceil(Math.log10(largest / step) + 1e-9) + 1), 17));
}

/** The same with a power of ten from a million on and below a thousandth: short enough to stand beside an axis. */
export function axisText(value, step) {
  const largest = Math.max(Math.abs(value), step);
  if (value === 0 || Math.abs(value) < 1e-9 * step || (largest < 1e6 && (step >= 1e-4 || largest >= 0.1))) {
    return tickText(value, step);
  }
  const power = Math.floor(Math.log10(Math.abs(value)));
  return `${tickText(value / 10 ** power, step / 10 ** power)}e${power}`;
}

/** Round numbers that cut an interval into about `count` parts. */
export function ticks(low, high, count) {
  const rough = (high - low) / Math.max(count, 1);
  const power = 10 ** Math.floor(Math.log10(rough));
  const step = [1, 2, 5, 10].map(k => k * power).find(s => s >= rough * 0.999);
  const marks = [];
  for (let k = Math.ceil(low / step - 1e-9); k * step <= high + 1e-9 * step; ++k) {
    marks.push(Number((k * step).toPrecision(12)));
  }
  return marks;
}
