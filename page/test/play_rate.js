// SPDX-License-Identifier: Apache-2.0
// usage: node page/test/play_rate.js PAGE [TIMES]
// Measures the time to open a page and to unpack and draw its frames, in milliseconds, medians over TIMES visits. A
// browser without a window draws with the processor; a graphics card does what is called drawing here in a fraction.

import {pathToFileURL} from 'node:url';
import {openBrowser} from './stage.js';

const [file, times = '5'] = process.argv.slice(2);
const median = values => [...values].sort((a, b) => a - b)[values.length >> 1];

async function visit() {
  const browser = await openBrowser();
  const page = await browser.newPage({viewport: {width: 1280, height: 720}});
  page.setDefaultTimeout(300_000);
  await page.goto(pathToFileURL(file).href, {waitUntil: 'commit'});
  await page.waitForFunction(() => document.documentElement.dataset.loaded);
  const seen = await page.evaluate(async () => {
    const {scene, recording} = window.riprap, gl = scene.renderer.getContext(), pixel = new Uint8Array(4);
    const median = values => values.sort((a, b) => a - b)[values.length >> 1];
    const at = name => performance.getEntriesByName(name)[0].startTime;
    const prepare = [], draw = [];
    for (let k = 0; k < recording.frameCount; k += Math.ceil(recording.frameCount / 20)) {
      const frame = await recording.frame(k);
      const begin = performance.now();
      scene.show(frame);
      prepare.push(performance.now() - begin);
      gl.readPixels(0, 0, 1, 1, gl.RGBA, gl.UNSIGNED_BYTE, pixel);  // waits until all is drawn
      draw.push(performance.now() - begin);
    }
    return {'first frame drawn': at('drawn'), 'all frames unpacked': at('loaded'),
            'unpacking a frame': (at('loaded') - at('opened')) / recording.frameCount,
            'a frame, before the graphics card': median(prepare), 'a frame, drawn': median(draw)};
  });
  await browser.close();
  return seen;
}

const visits = [];
for (let k = 0; k < Number(times); ++k) {
  visits.push(await visit());
}
for (const name of Object.keys(visits[0])) {
  const values = visits.map(seen => seen[name]);
  console.log(`${name}: ${median(values).toFixed(1)} (${values.map(v => v.toFixed(1)).join(' ')})`);
}
