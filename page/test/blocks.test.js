// SPDX-License-Identifier: Apache-2.0
// A page of blocks, driven as a reader drives it.

import assert from 'node:assert/strict';
import {readFileSync, truncateSync, statSync} from 'node:fs';
import {join} from 'node:path';
import {after, before, test} from 'node:test';
import {pathToFileURL} from 'node:url';
import {Stage, differs, lookAt, riprap, table} from './stage.js';

const DIGITS = 7;
let stage, run, page;

before(async () => {
  stage = await Stage.open();
  run = stage.run('blocks', 'cases/hello_block', ['end=0.3', 'output.interval=0.01']);
  page = await stage.visit(run);
});
after(() => stage?.close());

const goTo = index => page.evaluate(k => window.riprap.show(k), index);
const shown = field => page.textContent(`#tab-body [data-field="${field}"]`);

test('the page opens and asks nobody for anything', async t => {
  const milliseconds = await page.evaluate(() => Number(document.documentElement.dataset.opened));
  t.diagnostic(`opened in ${milliseconds} ms (3000 wanted; drawn by the processor, beside whatever else runs here)`);
  await page.evaluate(() => new Promise(resolve => setTimeout(resolve, 500)));
  assert.deepEqual(page.requests, [page.address]);
  assert.deepEqual(page.errors, []);
});

test('no frame is empty', async () => {
  for (let k = 0; k < await page.evaluate(() => window.riprap.frameCount); k += 6) {
    await goTo(k);
    const {share} = await lookAt(page);
    assert.ok(share > 0.05, `frame ${k}: ${share} of the scene is drawn`);
  }
});

test('the slider moves the scene to the time that it shows', async () => {
  const slider = page.locator('#time');
  for (const index of [7, 0, 20]) {
    await slider.fill(String(index));
    await page.waitForFunction(k => window.riprap.index === k, index);
    const time = await page.evaluate(k => window.riprap.times[k], index);
    assert.match(await page.textContent('#clock'), new RegExp(`t = ${Number(time.toPrecision(5))} s`));
  }
});

test('play runs on to the last frame and stops there', async () => {
  await goTo(0);
  await page.selectOption('#pace', '4');
  await page.click('#play');
  await page.waitForFunction(() => window.riprap.index > 0);
  assert.equal(await page.getAttribute('#play', 'aria-label'), 'pause');
  await page.waitForFunction(() => window.riprap.index === window.riprap.frameCount - 1);
  await page.waitForFunction(() => document.getElementById('play').getAttribute('aria-label') === 'play');
});

test('a block that is clicked shows the position and the velocity that the table has, to the printed digits', async () => {
  const last = await page.evaluate(() => window.riprap.frameCount - 1);
  await goTo(last);
  const body = table(readFileSync(join(run, 'bodies.csv'), 'utf8')).find(row => row.name === 'block');
  const place = ['x', 'y', 'z'].map(axis => Number(body[`position.${axis}`]));
  const [x, y] = await page.evaluate(p => window.riprap.scene.pixelOf(p), place);
  await page.mouse.click(x, y);
  assert.equal(await shown('name'), 'block');
  const printed = text => Number(Number(text).toPrecision(DIGITS));
  const read = text => Number(text.replace('\u2212', '-'));
  for (const quantity of ['position', 'velocity']) {
    for (const axis of ['x', 'y', 'z']) {
      // Positions are doubles all the way. Velocities are stored as singles, which have the printed digits but for the last.
      const wanted = printed(body[`${quantity}.${axis}`]), got = read(await shown(`${quantity}.${axis}`));
      const slack = quantity === 'position' ? 0 : Math.abs(wanted) * 1e-6;
      assert.ok(Math.abs(got - wanted) <= slack, `${quantity}.${axis}: ${got} is shown for ${wanted}`);
    }
  }
  await page.mouse.click(x, 60);  // the sky
  assert.match(await page.textContent('#tab-body'), /Click a block/);
});

test('the block is drawn where it is, and nothing where it is not', async () => {
  await page.evaluate(() => { window.riprap.camera('front'); window.riprap.select(-1); });
  for (const index of [0, 30]) {
    await goTo(index);
    // The front view looks along y: 1 m wide, 0.5 m high about its centre. Measured on its front face.
    const [center, inside, left, above] = await page.evaluate(() => {
      const {scene} = window.riprap, [x, y, z] = scene.blocks.frame.pose.subarray(7, 10);
      return [[x, y - 0.5, z], [x + 0.4, y - 0.5, z + 0.2], [x - 0.6, y - 0.5, z + 0.2], [x, y - 0.5, z + 0.4]]
          .map(p => scene.pixelOf(p));
    });
    const {colours, background} = await lookAt(page, [center, inside, left, above]);
    assert.ok(differs(colours[0], background), `frame ${index}: the centre is empty`);
    assert.ok(!differs(colours[0], colours[1]), `frame ${index}: the face has two colours`);
    assert.ok(differs(colours[2], colours[0]), `frame ${index}: the block reaches too far left`);
    assert.ok(differs(colours[3], colours[0]), `frame ${index}: the block reaches too high`);
  }
  await page.evaluate(() => window.riprap.camera('corner'));
});

test('the keyboard plays, steps, turns, selects and changes the light', async () => {
  await goTo(5);
  const press = async (key, wanted) => {
    await page.keyboard.press(key);
    await page.waitForFunction(wanted);
  };
  await page.focus('#scene');
  await press('ArrowRight', () => window.riprap.index === 6);
  await press('Shift+ArrowRight', () => window.riprap.index === 16);
  await press('Home', () => window.riprap.index === 0);
  await press('End', () => window.riprap.index === window.riprap.frameCount - 1);
  await press('ArrowLeft', () => window.riprap.index === window.riprap.frameCount - 2);
  await press('4', () => document.getElementById('camera').value === 'top');
  await press('1', () => document.getElementById('camera').value === 'corner');
  await press(']', () => document.querySelector('#tab-body [data-field=name]')?.textContent === 'block');  // the free one
  await press(']', () => document.querySelector('#tab-body [data-field=name]')?.textContent === 'plane');
  await press('Escape', () => !document.querySelector('#tab-body [data-field=name]'));
  await press('c', () => document.getElementById('contacts').checked);
  await press('c', () => !document.getElementById('contacts').checked);
  await press('b', () => document.getElementById('block-by').value === 'speed');
  const theme = await page.evaluate(() => document.documentElement.dataset.theme);
  await page.keyboard.press('d');
  await page.waitForFunction(was => document.documentElement.dataset.theme !== was, theme);
  await page.keyboard.press('d');
  await page.selectOption('#pace', '0.25');  // so that it does not end before it is seen to play
  await page.focus('#scene');
  await press('Home', () => window.riprap.index === 0);
  await page.keyboard.press(' ');
  await page.waitForFunction(() => document.getElementById('play').getAttribute('aria-label') === 'pause');
  await page.keyboard.press(' ');
  await page.waitForFunction(() => document.getElementById('play').getAttribute('aria-label') === 'play');
});

test('everything fits on the screen of a small laptop', async () => {
  for (const [width, height] of [[1280, 720], [1024, 600]]) {
    await page.setViewportSize({width, height});
    const over = await page.evaluate(() => [document.documentElement.scrollWidth - window.innerWidth,
                                            document.documentElement.scrollHeight - window.innerHeight,
                                            document.getElementById('view').clientHeight]);
    assert.ok(over[0] <= 0 && over[1] <= 0, `${width} x ${height}: the page is larger by ${over}`);
    assert.ok(over[2] > 0.6 * height, `${width} x ${height}: the scene has ${over[2]} pixels of height`);
  }
  await page.setViewportSize({width: 1280, height: 720});
});

test('nothing reaches beyond the screen of a telephone', async () => {
  await page.setViewportSize({width: 390, height: 800});
  assert.ok(await page.evaluate(() => document.documentElement.scrollWidth) <= 390);
  const rows = await page.evaluate(() => ['theme', 'panel-button', 'help-button'].map(id => document.getElementById(id).getBoundingClientRect().top));
  assert.equal(new Set(rows).size, 1, `the buttons stand in rows at ${rows}`);
  await page.setViewportSize({width: 1280, height: 720});
});

test('after a click on a button or a box the space bar plays', async () => {
  await page.selectOption('#pace', '0.25');
  for (const id of ['#theme', '#contacts']) {
    await page.click(id);
    await page.evaluate(() => window.riprap.show(0));
    await page.keyboard.press(' ');
    await page.waitForFunction(() => document.getElementById('play').getAttribute('aria-label') === 'pause');
    await page.keyboard.press(' ');
    await page.waitForFunction(() => document.getElementById('play').getAttribute('aria-label') === 'play');
    await page.click(id);
  }
});

test('keys that were set by hand stand above the case, and their paces have a unit', async () => {
  assert.match(await page.textContent('#tab-case .banner'), /2 keys set by hand.*end = 0\.3.*output\.interval = 0\.01/s);
  assert.match(await page.textContent('#pace option[value="1"]'), /^[0-9.]+ s of the run per second$/);
});

test('axes, gravity and a length are shown below the scene, which nothing covers', async () => {
  const compass = await page.textContent('#compass');
  for (const word of ['x', 'z', 'g = 9.81 m/s\u00b2', ' m']) {
    assert.ok(compass.includes(word), `${word} is not in '${compass}'`);
  }
  const [scene, key] = await Promise.all(['#scene', '#key'].map(id => page.locator(id).boundingBox()));
  assert.ok(key.y >= scene.y + scene.height - 0.5);
  await page.selectOption('#block-by', 'material');
  assert.match(await page.textContent('#legends'), /fixed or driven/);
});

test('a run whose last frame is half written shows the others and says so', async () => {
  const frame = join(run, 'frames', 'bodies_000030.vtp');
  truncateSync(frame, statSync(frame).size / 2);
  const damaged = await stage.visit(run);
  assert.equal(await damaged.evaluate(() => window.riprap.frameCount), 30);
  assert.match(await damaged.textContent('#trouble'), /bodies_000030\.vtp.*ends in the middle/);
  assert.ok((await lookAt(damaged)).share > 0.05);
});

test('where nothing can be drawn, plots, readings and the slider work all the same', async () => {
  const blind = await stage.browser.newPage({viewport: {width: 1280, height: 720}});
  await blind.addInitScript(() => {
    const {getContext} = HTMLCanvasElement.prototype;
    HTMLCanvasElement.prototype.getContext = function(kind, ...more) {
      return kind === '2d' ? getContext.call(this, kind, ...more) : null;
    };
  });
  await blind.goto(page.address);
  await blind.waitForFunction(() => document.documentElement.dataset.opened);
  assert.match(await blind.textContent('#trouble'), /The scene cannot be drawn/);
  await blind.evaluate(() => window.riprap.show(7));
  assert.match(await blind.textContent('#clock'), /\(8 of /);
  await blind.keyboard.press(']');
  assert.equal(await blind.textContent('#tab-body [data-field=name]'), 'block');
  await blind.click('[data-tab=plots]');
  assert.ok(await blind.locator('#tab-plots canvas').count() > 0);
});

test('a drag in a chart zooms into it, and its curves are saved as a table', async () => {
  await page.click('[data-tab=plots]');
  const over = page.locator('#tab-plots .u-over').first(), box = await over.boundingBox();
  await page.mouse.move(box.x + 0.3 * box.width, box.y + 40);
  await page.mouse.down();
  await page.mouse.move(box.x + 0.6 * box.width, box.y + 40, {steps: 4});
  await page.mouse.up();
  const button = page.locator('#tab-plots .tools button', {hasText: 'whole time'}).first();
  await button.waitFor({state: 'visible'});
  await button.click();
  await button.waitFor({state: 'hidden'});
  const [download] = await Promise.all([page.waitForEvent('download'), page.locator('#tab-plots .tools button', {hasText: 'CSV'}).first().click()]);
  const rows = table(readFileSync(await download.path(), 'utf8')), [, column] = Object.keys(rows[0]);
  const whole = ['probes.csv', 'ledger.csv'].map(name => table(readFileSync(join(run, name), 'utf8'))).find(t => t[0][column] !== undefined);
  assert.equal(rows.length, whole.length);
  assert.deepEqual(rows.map(row => Number(row.time)), whole.map(row => Number(row.time)));
});

test('the address leads to the time, the colours and the view that it was taken from', async () => {
  await page.evaluate(() => { window.riprap.choose({blocks: 'speed', contacts: false}); window.riprap.camera('side'); });
  await goTo(12);
  await page.waitForFunction(() => /t=0\.12.*blocks=speed.*camera=side/.test(location.hash));
  await page.evaluate(() => { const {eye} = window.riprap.scene; window.riprap.scene.eye = eye.map((v, k) => k < 3 ? 1.5 * v : v); });
  await page.waitForFunction(() => location.hash.includes('eye='));
  const [address, eye] = await page.evaluate(() => [location.href, window.riprap.scene.eye]);
  const other = await stage.browser.newPage({viewport: {width: 1280, height: 720}});
  await other.goto(address);
  await other.waitForFunction(() => document.documentElement.dataset.opened);
  const seen = await other.evaluate(() => [window.riprap.index, document.getElementById('block-by').value, window.riprap.scene.eye]);
  assert.deepEqual(seen.slice(0, 2), [12, 'speed']);
  seen[2].forEach((v, k) => assert.ok(Math.abs(v - eye[k]) < 1e-4 * (1 + Math.abs(eye[k])), `${seen[2]} for ${eye}`));
  await other.close();
});

test('two runs stand side by side under one clock', async () => {
  const short = stage.run('short', 'cases/hello_block', ['end=0.2', 'output.interval=0.01']), out = join(stage.folder, 'compare.html');
  assert.equal(riprap(['view', run, short, '--out', out]).status, 0);
  const both = await stage.browser.newPage({viewport: {width: 1280, height: 720}});
  const requests = [];
  both.on('request', request => requests.push(request.url()));
  await both.goto(pathToFileURL(out).href);
  await both.waitForFunction(() => document.documentElement.dataset.opened);
  await both.evaluate(() => window.riprap.show(0.25));
  assert.deepEqual(await both.evaluate(() => window.riprap.runs.map(({riprap}) => riprap.times[riprap.index])).then(t => t.map(v => v.toFixed(2))),
                   ['0.25', '0.20']);
  assert.match(await both.textContent('#runs figure:last-child'), /short.*ended at 0\.2/);
  await both.waitForFunction(() => location.hash.includes('t=0.25'));
  const again = await stage.browser.newPage({viewport: {width: 1280, height: 720}});
  await again.goto(both.url());
  await again.waitForFunction(() => document.documentElement.dataset.opened);
  assert.equal(await again.evaluate(() => window.riprap.time), 0.25);
  await again.close();
  assert.deepEqual(requests.filter(url => !url.startsWith('about:')), [pathToFileURL(out).href]);
  await both.close();
});

test('a block that is not convex shows its outline, not the seams of its convex parts', async () => {
  const section = await stage.visit(stage.run('section', 'cases/slope_section', ['end=0.02']));
  const drawn = await section.evaluate(() => {
    const {blocks} = window.riprap.scene, rock = blocks.meshes.findIndex(mesh => blocks.contents.bodies.names[mesh.userData.members[0]] === 'rock[0]');
    const x = blocks.lines[rock].geometry.attributes.position.array;
    let length = 0;
    for (let k = 0; k < x.length; k += 6) {
      length += Math.hypot(x[k + 3] - x[k], x[k + 4] - x[k + 1], x[k + 5] - x[k + 2]);
    }
    return length;
  });
  const outline = [[0, 0], [40, 0], [40, 20], [26, 20], [26, 17.803], [12, 8], [10, 5], [0, 5]];  // slope.geo below its sliding plane
  const around = outline.reduce((sum, [x, y], k) => sum + Math.hypot(x - outline.at(k - 1)[0], y - outline.at(k - 1)[1]), 0);
  const wanted = 2 * around + outline.length;  // before and behind, and the lines across, 1 m each
  assert.ok(Math.abs(drawn - wanted) < 0.1, `${drawn} m of lines for ${wanted}`);
  await section.close();
});

test('where gravity turns, it points down the picture all the time', async () => {
  const tilted = await stage.visit(stage.run('tilted', 'cases/tilting_slope', ['end=2.2', 'output.interval=0.2']));
  const downs = await tilted.evaluate(async () => {
    const {scene, frameCount} = window.riprap, list = [];
    for (const index of [0, frameCount - 1]) {
      await window.riprap.show(index);
      const g = scene.gravityOf(index), middle = [0, 1, 2].map(k => (scene.box.min.toArray()[k] + scene.box.max.toArray()[k]) / 2);
      const [a, b] = [middle, middle.map((v, k) => v + 0.01 * g[k])].map(p => scene.pixelOf(p));
      list.push([b[0] - a[0], b[1] - a[1], g[0]]);
    }
    return list;
  });
  assert.ok(Math.abs(downs[1][2] - downs[0][2]) > 1, 'gravity has turned');
  downs.forEach(([x, y]) => assert.ok(y > 10 * Math.abs(x), `down is ${[x, y]}`));
  await tilted.close();
});
