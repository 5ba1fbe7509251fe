// SPDX-License-Identifier: Apache-2.0
// What a study is made of, for its page: keys that differ, series of runs that share the values of all keys but one, curves
// at common times, quantiles. Nothing here draws.

import {colourAt, LINES, MAPS} from './colours.js';
import {reading} from './numbers.js';

const MOST_ROWS = 2000;   // common times of curves
const EVEN_ROWS = 800;    // where their own times are more
const MOST_FACETS = 6;
const MOST_NAMED = 4;     // values of a key that the title names

export const distinct = list => [...new Set(list)];
export const isFinished = run => run.status === 'finished';
const bare = text => String(text).replace(/^(["'])(.*)\1$/, '$2');

/** Key of a study: its name in few words, its unit, the values in their order, the number of each where all are numbers. */
export function keysOf(study) {
  const paths = distinct(study.runs.flatMap(run => Object.keys(run.set)));
  return paths.map(path => {
    const texts = distinct(study.runs.map(run => run.set[path]).filter(text => text !== undefined)).map(bare);
    const split = texts.map(text => text.match(/^([-+]?[\d.]+(?:e[-+]?\d+)?)\s*(.*)$/i));
    const areNumbers = split.every(one => one && Number.isFinite(Number(one[1])) && one[2] === split[0][2]);
    const unit = areNumbers ? split[0]?.[2] || study.units?.[path] || '' : '';
    const values = texts.map((text, k) => ({text: areNumbers ? split[k][1] : text, number: areNumbers ? Number(split[k][1]) : NaN, raw: text}));
    if (areNumbers) {
      values.sort((a, b) => a.number - b.number);
    }
    return {path, name: nameOf(path, paths, study.units?.[path]), unit, areNumbers, values};
  });
}

/** The shortest end of a path that no other path has, without the unit at its end. */
export function nameOf(path, paths, unit) {
  const steps = path.split('.');
  let first = steps.length - 1;
  const tail = from => steps.slice(from).join('.');
  while (first > 0 && (/^\d+$/.test(steps[first]) || paths.some(other => other !== path && (other === tail(first) || other.endsWith(`.${tail(first)}`))))) {
    --first;
  }
  const end = unit && path.endsWith(`_${unit}`) ? -unit.length - 1 : undefined;
  return tail(first).slice(0, end).replaceAll('_', ' ');
}

/** Index of the value that a run has of a key; -1 where it has none. */
export const placeOf = (key, run) => key.values.findIndex(({raw}) => run.set[key.path] !== undefined && raw === bare(run.set[key.path]));

export const saidOf = (key, run) => {
  const value = key.values[placeOf(key, run)];
  return value ? `${key.name} ${value.text}${key.unit ? ` ${key.unit}` : ''}` : '';
};

/** "friction angle 10, 20, 25 deg; end 0.5, 1 s". */
export function differences(keys) {
  return keys.map(({name, unit, values, areNumbers}) => {
    const texts = values.map(value => value.text), few = texts.length <= MOST_NAMED;
    const list = few ? texts.join(', ') : areNumbers ? `${texts[0]} to ${texts.at(-1)}` : `${texts.length} values`;
    return `${name} ${list}${unit ? ` ${unit}` : ''}`;
  }).join('; ');
}

/** Colours of so many values in their order: eight that are told apart, or steps of a scale where they are more. */
export function coloursOf(count, first = 0) {
  return Array.from({length: count}, (_, k) => count <= LINES.length ? LINES[(first + k) % LINES.length]
    : `rgb(${colourAt(MAPS.viridis, 0.9 * k / (count - 1)).join(' ')})`);
}

/** Key by which curves are coloured: the one of most values. */
export const colouredKey = keys => keys.reduce((best, key) => !best || key.values.length > best.values.length ? key : best, undefined);

/** Runs in groups that share the values of these keys, each with what they share in words. */
export function groupsOf(runs, keys) {
  const groups = new Map();
  for (const run of runs) {
    const label = keys.map(key => saidOf(key, run)).filter(Boolean).join(', ');
    groups.set(label, [...groups.get(label) ?? [], run]);
  }
  const order = ([, [a]], [, [b]]) => keys.reduce((sign, key) => sign || placeOf(key, a) - placeOf(key, b), 0);
  return [...groups.entries()].sort(order).map(([label, members]) => ({label, members}));
}

/** The charts of one quantity over time: one for each combination of the keys that have no colour, where those are few. */
export function facetsOf(runs, keys) {
  const others = keys.filter(key => key !== colouredKey(keys)), groups = others.length ? groupsOf(runs, others) : [];
  const areFacets = groups.length > 1 && groups.length <= MOST_FACETS && groups.some(({members}) => members.length > 1);
  return areFacets ? groups : [{label: '', members: runs, isWhole: true}];
}

/** Series of an answer over a key: runs that agree in all other keys make a line, where there are such. */
export function seriesOver(runs, key, keys) {
  const groups = groupsOf(runs, keys.filter(other => other !== key));
  const areLines = groups.length <= LINES.length && groups.every(({members}) => distinct(members.map(run => placeOf(key, run))).length === members.length) &&
      groups.some(({members}) => members.length > 1);
  return areLines ? groups.map(group => ({...group, hasLine: true})) : [{label: '', members: runs, hasLine: false}];
}

/** Times that curves have in common: all of theirs, or even ones where these are too many. */
export function commonTimes(lists) {
  const all = distinct(lists.flat().filter(Number.isFinite)).sort((a, b) => a - b);
  const [first, last] = [all[0], all.at(-1)];
  return all.length <= MOST_ROWS ? all : Array.from({length: EVEN_ROWS}, (_, k) => first + k / (EVEN_ROWS - 1) * (last - first));
}

/** Values of a curve at other times, by the straight line; null before its first time and after its last. */
export function resampled(times, values, wanted) {
  let k = 0;
  return wanted.map(t => {
    while (k + 1 < times.length && times[k + 1] < t) {
      ++k;
    }
    if (!times.length || t < times[0] || t > times.at(-1)) {
      return null;
    }
    const next = times[k] >= t ? k : k + 1, at = times[next] === t ? next : k, [a, b] = [values[at], values[next]];
    if (a === null || b === null || !Number.isFinite(a) || !Number.isFinite(b)) {
      return null;
    }
    return next === at ? a : a + (t - times[at]) / (times[next] - times[at]) * (b - a);
  });
}

/** Quantile between sorted values, as bands.csv has it: definition 7 of Hyndman and Fan. */
export function quantile(values, share) {
  const sorted = values.filter(Number.isFinite).sort((a, b) => a - b), place = share * (sorted.length - 1), k = Math.floor(place);
  return sorted.length === 0 ? NaN : sorted[k] + (place - k) * (sorted[Math.min(k + 1, sorted.length - 1)] - sorted[k]);
}

/** Columns of the runs but for components that are round-off beside the others of their vector. */
export function columnsOf(runs) {
  const names = distinct(runs.flatMap(run => Object.keys(run.columns))), vector = name => name.replace(/\.[xyz]$/, '');
  const size = name => Math.max(0, ...runs.map(run => run.columns[name]).filter(Boolean).map(({min, max}) => Math.max(Math.abs(min ?? 0), Math.abs(max ?? 0))));
  return names.filter(name => !names.some(other => other !== name && vector(other) === vector(name) && size(name) < 1e-9 * size(other)))
      .map(name => ({name, unit: runs.map(run => run.columns[name]?.unit).find(Boolean) ?? ''}));
}

export const FIGURES = {last: 'at the end', max: 'largest', min: 'least'};

/** What is compared: the answers of the case, or one figure of each column where the case expects nothing. */
export function measuresOf(runs, figure) {
  const names = distinct(runs.flatMap(run => run.answers.map(answer => answer.name)));
  if (names.length > 0) {
    return names.map(name => {
      const of = run => run.answers.find(answer => answer.name === name), all = runs.map(of).filter(Boolean);
      const isOne = all.every(({low, high}) => low === all[0].low && high === all[0].high);
      const expected = isOne && (Number.isFinite(all[0].low) || Number.isFinite(all[0].high)) ? {low: all[0].low, high: all[0].high} : undefined;
      return {name, unit: all[0].unit === '-' ? '' : all[0].unit, expected, valueOf: run => of(run)?.value ?? NaN, verdictOf: run => of(run)?.verdict ?? ''};
    });
  }
  return columnsOf(runs).map(({name, unit}) => ({
    name: `${name} ${FIGURES[figure]}`, unit: unit === '-' ? '' : unit, valueOf: run => run.columns[name]?.[figure] ?? NaN, verdictOf: () => ''}));
}

/** "0.1 to 0.2", "at least 3", "at most 5". */
export function rangeText({low, high}) {
  const [from, to] = [low, high].map(v => Number.isFinite(v) ? reading(v, 4) : '');
  return from && to ? `${from} to ${to}` : from ? `at least ${from}` : `at most ${to}`;
}
