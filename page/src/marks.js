// SPDX-License-Identifier: Apache-2.0
// Marks the stages of loading the page.

/** Marks a stage as done, with the milliseconds since the page was asked for: for tests and `riprap render`. */
export function note(name) {
  document.documentElement.dataset[name] = Math.round(performance.mark(name).startTime);
}

/** Says what cannot be shown, to the reader and to `riprap render`. */
export function giveUp(why) {
  document.getElementById('trouble').textContent = why;
  document.documentElement.dataset.failed = why;
}
