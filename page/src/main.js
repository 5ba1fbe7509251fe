// SPDX-License-Identifier: Apache-2.0
// Opens the page: one run, several side by side, or a study.

import './style.css';
import {compareRuns} from './compare.js';
import {giveUp, note} from './marks.js';
import {Page} from './page.js';
import {readContents} from './recording.js';
import {remote} from './remote.js';
import {openStudy} from './study.js';

async function openRun() {
  const page = new Page(readContents());
  const opened = page.open();
  window.riprap = remote(page, opened);
  await opened;
  note('opened');
}

try {
  await (document.getElementById('study') ? openStudy() : document.getElementById('compared') ? compareRuns() : openRun());
} catch (error) {
  giveUp(`This page cannot be shown: ${error.message}`);
  throw error;
}
