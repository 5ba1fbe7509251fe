// SPDX-License-Identifier: Apache-2.0
// What the page of a study makes of its runs, without a browser.

import assert from 'node:assert/strict';
import {test} from 'node:test';
import {axisText} from '../src/numbers.js';
import * as data from '../src/study_data.js';

const run = (set, more = {}) => ({name: 'run', set, status: 'finished', answers: [], columns: {}, ...more});
const twoKeys = ['10', '20', '25'].flatMap(angle => ['0.3', '0.6'].map(end =>
  run({'material.rock.friction_angle_deg': angle, end})));
const study = {runs: twoKeys, units: {'material.rock.friction_angle_deg': 'deg', end: 's'}};

test('keys are named by their end, with their unit, and values are in the order of their numbers', () => {
  const [angle, end] = data.keysOf(study);
  assert.deepEqual([angle.name, angle.unit, end.name, end.unit], ['friction angle', 'deg', 'end', 's']);
  assert.equal(data.differences([angle, end]), 'friction angle 10, 20, 25 deg; end 0.3, 0.6 s');
  const [many] = data.keysOf({runs: ['9', '10', '1e1', '2', '30', '4'].map(end => run({end})), units: {}});
  assert.equal(data.differences([many]), 'end 2 to 30');
  assert.deepEqual(data.keysOf({runs: [run({a: '"3 cm"'}), run({a: '"2 cm"'})]}).map(key => [key.unit, key.values.map(v => v.number)]), [['cm', [2, 3]]]);
  assert.equal(data.keysOf({runs: [run({a: '"3 cm"'}), run({a: '"2 mm"'})]})[0].areNumbers, false);
});

test('keys with one end are told apart', () => {
  const paths = ['body.a.velocity.0', 'body.b.velocity.0', 'fluid.density', 'material.rock.density', 'density'];
  assert.deepEqual(paths.map(path => data.nameOf(path, paths)), ['a.velocity.0', 'b.velocity.0', 'fluid.density', 'rock.density', 'density']);
});

test('of two keys one has colours and the other has charts, and an answer over each has a line for each value of the other', () => {
  const keys = data.keysOf(study), [angle, end] = keys;
  assert.equal(data.colouredKey(keys), angle);
  assert.deepEqual(data.facetsOf(twoKeys, keys).map(facet => [facet.label, facet.members.length]), [['end 0.3 s', 3], ['end 0.6 s', 3]]);
  assert.deepEqual(data.seriesOver(twoKeys, end, keys).map(series => [series.label, series.hasLine]),
                   [['friction angle 10 deg', true], ['friction angle 20 deg', true], ['friction angle 25 deg', true]]);
  assert.equal(data.seriesOver(twoKeys, angle, keys).length, 2);
});

test('a list of runs that share no values makes one cloud and no facets', () => {
  const runs = ['1', '2', '3'].map((v, k) => run({a: v, b: String(10 + k)})), keys = data.keysOf({runs});
  assert.deepEqual(data.seriesOver(runs, keys[0], keys).map(series => series.hasLine), [false]);
  assert.equal(data.facetsOf(runs, keys)[0].isWhole, true);
});

test('curves at other times lie on the straight lines between their own, and nowhere beyond their ends', () => {
  assert.deepEqual(data.resampled([1, 2, 4], [10, 20, 0], [0.5, 1, 1.5, 2, 3, 4, 4.5]), [null, 10, 15, 20, 10, 0, null]);
  assert.deepEqual(data.resampled([1, 2, 3], [10, null, 30], [1, 1.5, 2, 3]), [10, null, null, 30]);
  assert.deepEqual(data.resampled([], [], [1]), [null]);
  assert.deepEqual(data.commonTimes([[0, 1, 2], [0, 0.5, 2, null]]), [0, 0.5, 1, 2]);
  assert.equal(data.commonTimes([Array.from({length: 5000}, (_, k) => k)]).at(-1), 4999);
});

test('quantiles are those of definition 7', () => {
  const values = [5, NaN, 1, 2, 4, 3];
  assert.deepEqual([0, 0.1, 0.5, 0.9, 1].map(share => data.quantile(values, share)), [1, 1.4, 3, 4.6, 5]);
  assert.ok(Number.isNaN(data.quantile([], 0.5)));
});

test('more than eight values get the steps of a scale, each its own', () => {
  assert.equal(new Set(data.coloursOf(12)).size, 12);
  assert.equal(new Set([...data.coloursOf(3), ...data.coloursOf(2, 3)]).size, 5);
});

test('answers are compared where the case expects any, else one figure of each column', () => {
  const answer = (value, low) => ({name: 'slide', unit: 'm', value, low, high: 2, verdict: 'passed'});
  const [one] = data.measuresOf([run({}, {answers: [answer(1.5, 1)]}), run({})], 'last');
  assert.deepEqual([one.name, one.unit, data.rangeText(one.expected)], ['slide', 'm', '1 to 2']);
  assert.equal(data.measuresOf([run({}, {answers: [answer(1, 1)]}), run({}, {answers: [answer(1, 0)]})], 'last')[0].expected, undefined);
  const columns = {'b.x': {unit: 'm', last: 1, min: 0, max: 3}, 'b.y': {unit: 'm', last: 1e-16, min: 0, max: 1e-15}};
  assert.deepEqual(data.measuresOf([run({}, {columns})], 'max').map(measure => measure.name), ['b.x largest']);
});

test('marks of an axis have a power of ten only where that is shorter', () => {
  assert.deepEqual([[0.40005, 5e-5], [2e-5, 1e-5], [3e7, 1e7], [0, 1]].map(([value, step]) => axisText(value, step)), ['0.40005', '2e-5', '3e7', '0']);
});
