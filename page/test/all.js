// SPDX-License-Identifier: Apache-2.0
// All end-to-end tests, where there is a browser to run them in; a line that says so where there is none.

import {spawnSync} from 'node:child_process';
import {fileURLToPath} from 'node:url';
import {browserProgram} from './stage.js';

if (!browserProgram()) {
  console.log('skipped: there is no Chromium on this machine (Debian\'s package chromium)');
} else {
  const files = ['blocks', 'water', 'study', 'study_data'].map(name => fileURLToPath(new URL(`${name}.test.js`, import.meta.url)));
  process.exit(spawnSync(process.execPath, ['--test', '--test-concurrency=1', ...files], {stdio: 'inherit'}).status);
}
