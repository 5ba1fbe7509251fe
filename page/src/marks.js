// SPDX-License-Identifier: Apache-2.0
// Tells how far the page is.

/** What is done so far, for tests and for `riprap render`: a mark, and the milliseconds since the page was asked for. */
export function note(name) {
  document.documentElement.dataset[name] = Math.round(performance.mark(name).startTime);
}

/** Says what cannot be shown, to the reader and to `riprap render`. */
export function giveUp(why) {
  document.getElementById('trouble').textContent = why;
  document.documentElement.dataset.failed = why;
}
