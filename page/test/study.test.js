// SPDX-License-Identifier: Apache-2.0
// The page of a study in a browser: the charts of the page of a run, two keys told apart, runs that failed with their reason.

import assert from 'node:assert/strict';
import {writeFileSync} from 'node:fs';
import {join} from 'node:path';
import {pathToFileURL} from 'node:url';
import {after, before, test} from 'node:test';
import {riprap, Stage} from './stage.js';

const FLYING = `title = "A stone that flies"
gravity = [0.0, 0.0, -10.0]
end = 0.02
seed = 7
[material.rock]
density = 2500.0
normal_stiffness = 1.0e5
[[body]]
name = "stone"
shape = { cube = 0.1 }
position = [0.0, 0.0, 1.0]
velocity = [1.0, 0.0, 0.0]
material = "rock"
[output]
probe_interval = 0.002
vtk = false
[[output.probe]]
body = "stone"
quantity = "position"
`;
const SPREAD = '[[spread]]\nkey = "body.stone.velocity.0"\nlow = 1.0\nhigh = 2.0\n';

let stage;

before(async () => { stage = await Stage.open(); });
after(async () => { await stage.close(); });

/** Makes a study with these words, and opens its page. */
async function study(name, text, words, width = 1400) {
  const file = join(stage.folder, `${name}.toml`), out = join(stage.folder, name);
  writeFileSync(file, text);
  riprap([words[0] === '--ensemble' ? 'run' : 'sweep', file, '--out', out, '--quiet', ...words]);
  const page = await stage.browser.newPage({viewport: {width, height: 900}});
  Object.assign(page, {errors: [], requests: []});
  page.on('pageerror', error => page.errors.push(error.message));
  page.on('request', request => page.requests.push(request.url()));
  await page.goto(pathToFileURL(join(out, 'index.html')).href);
  await page.waitForFunction(() => document.documentElement.dataset.opened);
  return page;
}

/** Pixels of the first chart under a heading that have a colour, give or take what smoothing leaves. */
const pixelsOf = (page, heading, colour) => page.evaluate(([text, [r, g, b]]) => {
  const section = [...document.querySelectorAll('h2')].find(h => h.textContent.startsWith(text)).nextElementSibling;
  const canvas = section.querySelector('canvas'), {data} = canvas.getContext('2d').getImageData(0, 0, canvas.width, canvas.height);
  let count = 0;
  for (let k = 0; k < data.length; k += 4) {
    count += data[k + 3] > 200 && Math.abs(data[k] - r) + Math.abs(data[k + 1] - g) + Math.abs(data[k + 2] - b) < 12 ? 1 : 0;
  }
  return count;
}, [heading, colour]);

test('two keys are told apart, and a run that was refused stands there with its whole reason', async () => {
  const page = await study('two', FLYING, ['--jobs', '1', '--vary', 'body.stone.velocity.0=1,2', '--vary', 'material.rock.density=1000,2000,-5']);
  assert.match(await page.title(), /^Study of A stone that flies: velocity\.0 1, 2 m\/s; density -5, 1000, 2000 kg\/m\^3$/);
  assert.equal(await page.locator('#status').textContent(), '6 runs, 4 finished');
  assert.match(await page.locator('.banner').textContent(), /2 of 6 did not finish.*run_003.*density.*-5/s);
  assert.match(await page.locator('.banner li').first().textContent(), /nothing was run/);
  assert.equal(await page.locator('tr.failed').count(), 2);
  assert.deepEqual((await page.locator('table.runs thead th').allTextContents()).slice(0, 3), ['run', 'velocity.0 [m/s]', 'density [kg/m^3]']);
  const over = await page.locator('summary').allTextContents();
  assert.equal(over.filter(text => text === 'stone.position.x at the end [m]').length, 2, over.join('\n'));
  // Two values of the key without colours: two charts of each quantity.
  assert.deepEqual(over.filter(text => text.startsWith('stone.position.x [m]')), ['stone.position.x [m], velocity.0 1 m/s', 'stone.position.x [m], velocity.0 2 m/s']);
  assert.ok(await pixelsOf(page, 'Over velocity.0', [0xe6, 0x9f, 0]) > 20, 'the line of a density, in its colour');
  await page.locator('#figure').selectOption('max');
  assert.ok((await page.locator('summary').allTextContents()).includes('stone.position.x largest [m]'));
  assert.deepEqual(page.errors, []);
  assert.ok(page.requests.every(url => url.startsWith('file:') || url.startsWith('data:')), page.requests.join('\n'));
});

test('an ensemble shows bands, quantiles and the drawn values, on a phone without a line that sticks out', async () => {
  const page = await study('many', FLYING + SPREAD, ['--ensemble', '5'], 390);
  assert.match(await page.title(), /^Ensemble of A stone that flies: velocity\.0$/);
  assert.deepEqual(await page.locator('tfoot th').allTextContents(), ['least', '10 %', 'median', '90 %', 'largest']);
  const shown = await page.evaluate(() => window.riprap.charts.find(chart => chart.heading === 'stone.position.x [m]').look.areas.map(area => [area.low.at(-1), area.high.at(-1)]));
  const [[least, largest], [tenth, ninetieth]] = shown;
  assert.ok(least < tenth && tenth < ninetieth && ninetieth < largest, JSON.stringify(shown));
  assert.ok(await pixelsOf(page, 'Over time', [0, 0x72, 0xb2]) > 100, 'the median');
  assert.ok(await page.evaluate(() => document.documentElement.scrollWidth) <= 390);
  assert.deepEqual(page.errors, []);
});

test('answers that differ by rounding alone are drawn as one level', async () => {
  const page = await study('level', `${FLYING}[[expect]]\nname = "end"\nquantity = "stone.position.z"\nreduce = "last"\nvalue = 0.998\ntolerance = 1e-3\ncitation = "g t^2 / 2"\n`,
                           ['--jobs', '1', '--vary', 'solid.method=explicit_dda,distance_potential_dem']);
  assert.deepEqual(page.errors, []);
  assert.match((await page.locator('table.runs thead th').allTextContents())[2], /^end \[m\], expected 0\.997 to 0\.999$/);
  assert.equal(await page.locator('td.verdict.passed').count(), 2);
});
