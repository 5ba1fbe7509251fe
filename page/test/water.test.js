// SPDX-License-Identifier: Apache-2.0
// A page with water, and pictures drawn by the program.

import assert from 'node:assert/strict';
import {readFileSync, writeFileSync} from 'node:fs';
import {join} from 'node:path';
import {pathToFileURL} from 'node:url';
import {after, before, test} from 'node:test';
import {inflateSync} from 'node:zlib';
import {WaterGroup} from '../src/water.js';
import {Stage, differs, lookAt, riprap} from './stage.js';

let stage, run, page;

before(async () => {
  stage = await Stage.open();
  run = stage.run('water', 'cases/floating_box', ['fluid.spacing=0.04', 'end=0.3', 'output.interval=0.01']);
  page = await stage.visit(run);
});
after(() => stage?.close());

/** An array of a VTP file, read independently of the program. */
function vtpArray(xml, name, Type) {
  const text = xml.match(new RegExp(`<DataArray[^>]*Name="${name}"[^>]*>([^<]*)<`))[1];
  const blocks = Number(Buffer.from(text.slice(0, 12), 'base64').readBigUInt64LE(0));
  const headCharacters = Math.ceil(8 * (3 + blocks) / 3) * 4;
  const head = Buffer.from(text.slice(0, headCharacters), 'base64');
  const packed = Buffer.from(text.slice(headCharacters), 'base64');
  const parts = [];
  for (let k = 0, at = 0; k < blocks; ++k) {
    const size = Number(head.readBigUInt64LE(8 * (3 + k)));
    parts.push(inflateSync(packed.subarray(at, at + size)));
    at += size;
  }
  return new Type(new Uint8Array(Buffer.concat(parts)).buffer);
}

test('every particle is where its frame says, within half a step', async () => {
  await page.waitForFunction(() => document.documentElement.dataset.loaded);
  for (const index of [0, 13, 29]) {
    const xml = readFileSync(join(run, 'frames', `water_${String(index).padStart(6, '0')}.vtp`), 'utf8');
    const ids = vtpArray(xml, 'id', Int32Array), points = vtpArray(xml, 'Points', Float64Array);
    await page.evaluate(k => window.riprap.show(k), index);
    const {places, step} = await page.evaluate(() => {
      const {geometry, water} = window.riprap.scene.particles, cells = geometry.getAttribute('cell').array;
      const places = [];
      for (let k = 0; k < cells.length; k += 4) {
        places.push([0, 1, 2].map(axis => water.origin[axis] + water.step * cells[k + axis]));
      }
      return {places, step: water.step};
    });
    assert.equal(places.length, ids.length);
    [...ids.keys()].sort((a, b) => ids[a] - ids[b]).forEach((row, k) => {
      for (let axis = 0; axis < 3; ++axis) {
        const error = Math.abs(places[k][axis] - points[3 * row + axis]);
        assert.ok(error <= 0.5001 * step, `frame ${index}, particle ${ids[row]}: ${error} m`);
      }
    });
  }
});

test('a page need not unpack a group of frames to show the first, and gives all of them in any order', async () => {
  const html = readFileSync(join(run, 'index.html'), 'utf8');
  const packed = Buffer.from(html.match(/id="water-0">([^<]*)</)[1], 'base64');
  const inOrder = new WaterGroup(inflateSync(packed)), atOnce = new WaterGroup(inflateSync(packed));
  await inOrder.frame(0);
  assert.equal(inOrder.frames.length, 1);
  const indices = [24, 3, 0, 11], frames = await Promise.all(indices.map(k => atOnce.frame(k)));
  for (let k = 1; k < 25; ++k) {
    await inOrder.frame(k);
  }
  indices.forEach((index, k) => assert.deepEqual(frames[k], inOrder.frames[index]));
  assert.notDeepEqual(frames[0], frames[2]);
});

test('water is drawn in every frame, in other colours by speed, and not at all when it is hidden', async () => {
  // The tank is 1 m wide, the water 0.4 m deep, and the box floats in the middle.
  const wet = [[0.1, 0.1], [0.5, 0.1], [0.9, 0.2]].map(([x, y]) => [x, y, 0]);
  const dry = [[0.1, 0.7], [0.9, 0.7]].map(([x, y]) => [x, y, 0]);
  const colours = async by => {
    await page.selectOption('#water-by', by);
    const places = await page.evaluate(points => points.map(p => window.riprap.scene.pixelOf(p)), [...wet, ...dry]);
    return (await lookAt(page, places)).colours;
  };
  for (const index of [0, 15, 29]) {
    await page.evaluate(k => window.riprap.show(k), index);
    const [pressure, hidden] = [await colours('pressure'), await colours('none')];
    wet.forEach((place, k) => assert.ok(differs(pressure[k], hidden[k]), `frame ${index}: no water at ${place}`));
    dry.forEach((place, k) => assert.ok(!differs(pressure[wet.length + k], hidden[wet.length + k]),
                                        `frame ${index}: water at ${place}`));
  }
  await colours('surface');
  assert.match(await page.textContent('#legends'), /watersurface/);
  const bySpeed = await colours('speed');
  assert.doesNotMatch(await page.textContent('#legends'), /watersurface/);
  assert.match(await page.textContent('#legends'), /speed of water \[m\/s\]/);
  const byPressure = await colours('pressure');
  assert.ok(wet.some((_, k) => differs(bySpeed[k], byPressure[k])));
  assert.match(await page.textContent('#legends'), /pressure of water \[Pa\]/);
});

test('a planar scene is seen from the front at first', async () => {
  assert.equal(await page.inputValue('#camera'), 'front');
});

test('a planar scene is drawn without perspective: no block hides the water beside it', async () => {
  await page.selectOption('#water-by', 'pressure');
  for (const index of [0, 29]) {
    const {faces, places} = await page.evaluate(async k => {
      await window.riprap.show(k);
      window.riprap.camera('front');
      const {scene} = window.riprap, {pose} = scene.blocks.frame, box = 7 * (pose.length / 7 - 1);
      const [x, y] = pose.subarray(box, box + 2);  // half a width of 0.14 m
      return {faces: [0.5, -0.5].map(z => scene.pixelOf([x + 0.14, y, z])),
              places: [x - 0.1, x + 0.1, x - 0.16, x + 0.16].map(at => scene.pixelOf([at, 0.34, 0]))};
    }, index);
    faces[0].forEach((pixel, axis) => assert.ok(Math.abs(pixel - faces[1][axis]) < 0.01));
    const {colours: [left, right, waterLeft, waterRight]} = await lookAt(page, places);
    assert.ok(!differs(left, right) && differs(left, waterLeft) && differs(right, waterRight),
              `frame ${index}: ${[left, waterLeft, waterRight, right]}`);
  }
});

test('the page of the water asks nobody for anything either', () => {
  assert.deepEqual(page.requests, [page.address]);
  assert.deepEqual(page.errors, []);
});

test('warnings of the run are counted beside the title and told in the tab Run', async () => {
  const told = await page.evaluate(() => JSON.parse(document.getElementById('contents').textContent).warnings);
  const summary = JSON.parse(readFileSync(join(run, 'summary.json'), 'utf8'));
  writeFileSync(join(run, 'summary.json'), JSON.stringify({...summary, warnings: [...told, 'the gate is thin']}));
  const warned = await stage.visit(run);
  assert.equal(await warned.textContent('#warnings'), `${told.length + 1} warning${told.length > 0 ? 's' : ''}`);
  await warned.click('#warnings');
  assert.ok((await warned.locator('#tab-run').innerText()).includes('the gate is thin'));
  await warned.close();
});

test('one chart has one unit, every gauge of the user is drawn at first, and energies are changes', async () => {
  const charts = await page.evaluate(() => [...document.querySelectorAll('#tab-plots details')].map(chart => ({
    heading: chart.querySelector('summary').textContent, names: [...chart.querySelectorAll('.curves span')].map(s => s.textContent),
    hidden: chart.querySelectorAll('[aria-pressed=false]').length})));
  const [heading] = readFileSync(join(run, 'probes.csv'), 'utf8').split('\n');
  const units = new Map(heading.split(',').map(text => text.match(/^(.*) \[(.*)\]$/).slice(1)));
  const gauges = charts.filter(chart => chart.names.every(name => units.has(name)));
  assert.ok(gauges.length > 0);
  for (const {heading: words, names, hidden} of gauges) {
    names.forEach(name => assert.ok(words.endsWith(`[${units.get(name)}]`), `${name} in ${words}`));
    assert.equal(hidden, 0, words);
  }
  assert.ok(charts.some(chart => chart.heading === 'energy of the fluid since the start [J/m]'));
});

test('a click in a plot goes to its time', async () => {
  await page.click('[data-tab=plots]');
  const box = await page.locator('#tab-plots canvas').first().boundingBox();
  await page.mouse.click(box.x + box.width - 19, box.y + 60);
  await page.waitForFunction(() => window.riprap.index >= window.riprap.frameCount - 2);
});

test('render draws a picture of the asked size that is not empty', async () => {
  const out = join(stage.folder, 'picture.png');
  const {status, stderr} = riprap(['render', run, '--out', out, '--size', '640x360', '--frame', '10']);
  assert.equal(status, 0, stderr);
  const blank = await stage.browser.newPage();
  const seen = await blank.evaluate(async data => {
    const image = new Image();
    image.src = `data:image/png;base64,${data}`;
    await image.decode();
    const canvas = Object.assign(document.createElement('canvas'), {width: image.width, height: image.height});
    const pen = canvas.getContext('2d');
    pen.drawImage(image, 0, 0);
    const {data: pixels} = pen.getImageData(0, 0, image.width, image.height);
    let drawn = 0;
    for (let k = 0; k < pixels.length; k += 4) {
      drawn += Math.abs(pixels[k] - pixels[0]) + Math.abs(pixels[k + 2] - pixels[2]) > 12 ? 1 : 0;
    }
    return [image.width, image.height, drawn / (image.width * image.height)];
  }, readFileSync(out).toString('base64'));
  assert.deepEqual(seen.slice(0, 2), [640, 360]);
  assert.ok(seen[2] > 0.15, `${seen[2]} of the picture is drawn`);
});

test('a plot is a PNG of the asked size that tells its resolution, or a PDF of one sheet', () => {
  const out = name => join(stage.folder, name), plot = (...words) => riprap(['plot', run, '--column', 'fluid.kinetic', ...words]);
  assert.equal(plot('--size', '127x76.2', '--dpi', '144', '--out', out('plot.png')).status, 0);
  const png = readFileSync(out('plot.png')), at = png.indexOf('pHYs');
  assert.deepEqual([png.readUInt32BE(16), png.readUInt32BE(20)], [720, 432]);
  assert.deepEqual([png.readUInt32BE(at + 4), png.readUInt32BE(at + 8), png[at + 12]], [5669, 5669, 1]);
  assert.equal(plot('--size', '127x76.2', '--out', out('plot.pdf')).status, 0);
  const pdf = readFileSync(out('plot.pdf'), 'latin1');
  assert.match(pdf, /^%PDF-/);
  assert.match(pdf, /\/MediaBox \[0 0 360(\.\d+)? 216(\.\d+)?\]/);  // points: five inches by three
  assert.equal(plot('--size', '1000x1000', '--dpi', '1200', '--out', out('large.png')).status, 5);
});

test('a frame that is not there, a browser that is not there, a run that is none: each is told', () => {
  const there = riprap(['render', run, '--frame', '99']);
  assert.equal(there.status, 5);
  assert.match(there.stderr, /there is no frame 99: the run has 31, from 0 to 30/);
  const late = riprap(['render', run, '--time', '99']);
  assert.equal(late.status, 5);
  assert.match(late.stderr, /there is no frame at 99 s: the run has them from 0 s to 0.3 s/);
  const ended = riprap(['render', run], {env: {...process.env, RIPRAP_CHROMIUM: '/bin/false'}, timeout: 30_000});
  assert.equal(ended.status, 5);
  assert.match(ended.stderr, /ended with exit code 1, saying nothing/);
  for (const args of [['render', '--out', 'x.jpg'], ['render', '--movie', '--out', 'x.gif'], ['plot', '--out', 'x.jpg']]) {
    const {status, stderr} = riprap([args[0], run, ...args.slice(1)]);
    assert.equal(status, 2);
    assert.match(stderr, /must end in \.(png|mp4|svg)/);
  }
  const without = riprap(['render', run], {env: {...process.env, PATH: '/nonexistent', RIPRAP_CHROMIUM: ''}});
  assert.equal(without.status, 5);
  assert.match(without.stderr, /there is no Chromium.*install Debian's package chromium/);
  const none = riprap(['view', stage.folder]);
  assert.equal(none.status, 5);
  assert.match(none.stderr, /holds no run/);
});

test('of a page that was cut, what is there is shown and what is not is told', async () => {
  const html = readFileSync(join(run, 'index.html'), 'utf8'), cut = join(run, 'cut.html');
  const whole = {trouble: /^$/, late: 30}, before = {trouble: /was cut: 1 of/, late: 3};
  const within = {trouble: /^$|every frame.*a piece of the file is damaged$/, late: 3};
  for (const [end, wanted] of [[html.length, whole], [html.indexOf('id="water-1"') + 500, within],
                               [html.indexOf('id="water-1"') - 20, before]]) {
    writeFileSync(cut, html.slice(0, end));
    await page.goto(pathToFileURL(cut).href);
    await page.waitForFunction(() => document.documentElement.dataset.opened);
    await page.evaluate(() => window.riprap.show(3));
    assert.equal(await page.evaluate(() => window.riprap.index), 3);
    assert.ok((await lookAt(page)).share > 0.1);
    assert.match(await page.textContent('#trouble'), wanted.trouble);
    await page.evaluate(() => window.riprap.show(30));
    assert.equal(await page.evaluate(() => window.riprap.index), wanted.late);
    if (wanted.late === 3) {
      assert.match(await page.textContent('#trouble'), /Frame 31 cannot be shown/);
    }
  }
});

test('in a planar scene bodies lie before the water, stones that it goes through behind it, hatched', async () => {
  // A tank of 4 m x 2 m, full to 1.5 m: a porous heap at the right, and a block at the left whose cells are half cut.
  const text = `dimension = 2
gravity = [0.0, -9.81]
end = 0.02
[material.stone]
density = 2400.0
normal_stiffness = 1e7
[fluid]
method = "grid"
spacing = 0.2
domain = { low = [0.0, 0.0], high = [4.0, 2.0] }
[[fluid.region]]
level = 1.5
[[fluid.porous]]
shape = { polygon = [[2.0, 0.0], [4.0, 0.0], [4.0, 1.2], [2.0, 1.2]] }
porosity = 0.4
grain_size = 0.1
linear = 50.0
quadratic = 2.0
[[body]]
name = "heap"
shape = { polygon = [[2.0, 0.0], [4.0, 0.0], [4.0, 1.2], [2.0, 1.2]] }
material = "stone"
fixed = true
wet = false
[[body]]
name = "block"
shape = { polygon = [[0.7, 0.35], [1.28, 0.35], [1.28, 0.93], [0.7, 0.93]] }
material = "stone"
fixed = true
`;
  const file = join(stage.folder, 'porous.toml');
  writeFileSync(file, text);
  const flat = await stage.visit(stage.run('porous', file, []));
  const places = [[0.72, 0.64], [1.0, 0.64], [0.66, 0.64], [0.4, 0.64], [3.0, 0.6]];
  const pixels = await flat.evaluate(all => all.map(([x, y]) => window.riprap.scene.pixelOf([x, y, 0])), places);
  const {colours: [edge, middle, beside, water, heap], background} = await lookAt(flat, pixels);
  assert.ok(!differs(edge, middle), `the block is one colour up to its edge: ${edge}, ${middle}`);
  assert.ok(!differs(beside, water), `beside it there is water: ${beside}, ${water}`);
  assert.ok(differs(water, background) && differs(heap, middle), 'water lies over the heap');
  assert.match(await flat.textContent('#legends'), /porous, 40 % voids/);
  assert.ok(await flat.evaluate(() => window.riprap.scene.porous.lines.geometry.getAttribute('position').count > 40));
  await flat.close();
});
