// SPDX-License-Identifier: Apache-2.0
// The tests of the site, where the packages that build it are; a line that says so where they are not.

import {spawnSync} from 'node:child_process';
import {existsSync} from 'node:fs';
import {fileURLToPath} from 'node:url';

const missing = ['marked', 'katex', 'playwright-core'].filter(name => !existsSync(new URL(`../node_modules/${name}`, import.meta.url)));
if (missing.length) {
  console.log(`skipped: page/node_modules lacks ${missing.join(', ')} (scripts/setup installs them)`);
} else {
  const {status} = spawnSync(process.execPath, ['--test', fileURLToPath(new URL('site.test.js', import.meta.url))], {stdio: 'inherit'});
  process.exit(status);
}
