// SPDX-License-Identifier: Apache-2.0
// Curves over time from the tables of the run, all under the time that the scene shows. A chart has one unit and holds
// quantities of one kind: positions do not flatten levels, nor water the blocks.

import {Chart} from './chart.js';

const OPEN_AT_FIRST = 5;  // charts

export class Plots {
  /**
   * `expects`: expected answers of the run, drawn as bands behind the quantities that they are about. `gauges`: those of the
   * case; a level and a way along a slope, both in metres, have charts of their own.
   */
  constructor(parent, tables, expects, gauges, onTime) {
    this.charts = [];
    const kinds = new Map(gauges.map(({name, kind}) => [name, kind.replaceAll('_', ' ')]));
    for (const table of tables) {
      const drawn = table.columns.filter(
          column => column.name !== 'step' && column.values.some(v => v !== 0 && Number.isFinite(v)));
      const dressed = drawn.map(column => ({...sinceStart(column), kind: kinds.has(column.name) ? `gauges of ${kinds.get(column.name)}` : kindOf(column), bands: bandsOf(column, expects)}));
      const groups = groupBy(dressed, column => `${column.kind} [${column.unit}]`);
      for (const heading of [...groups.keys()].sort((a, b) => rank(groups.get(a)[0].unit) - rank(groups.get(b)[0].unit))) {
        const curves = groups.get(heading).map(column => ({...column}));
        this.charts.push(new Chart(parent, heading, table.time, curves, dressed, this.charts.length < OPEN_AT_FIRST, onTime));
      }
    }
    if (this.charts.length === 0) {
      parent.textContent = 'The run has no tables, or nothing in them but zeros.';
    }
    let width = 0;
    new ResizeObserver(() => {
      if (parent.clientWidth !== width) {
        width = parent.clientWidth;
        this.draw();
      }
    }).observe(parent);
  }

  draw() {
    this.charts.forEach(chart => chart.draw());
  }

  at(time) {
    this.charts.forEach(chart => chart.at(time));
  }
}

/** Expected answers about a column; of an energy its change is drawn, which no answer is about. */
function bandsOf({name, unit}, expects) {
  return isEnergy(unit) ? [] : expects.filter(e => e.quantity === name).map(({low, high}) => ({low, high}));
}

/** Columns of the whole scene, which no gauge has measured. */
const SCENE = new Set(['max_speed', 'max_displacement', 'tilt', 'max_overlap', 'momentum', 'impulse', 'mass', 'angular_momentum',
                       'angular_impulse', 'coupling_gap', 'max_water_speed', 'momentum_residual']);

/** Of joules, in planar scenes per metre of width. */
const isEnergy = unit => unit === 'J' || unit === 'J/m';

/** What a column is of: "position" for B1.position.x, "energy of the fluid" for its accounts in the ledger. */
function kindOf({name, unit}) {
  const parts = name.split('.'), last = parts.length > 1 && 'xyz'.includes(parts.at(-1)) ? -1 : undefined;
  const quantity = parts.slice(parts.length > 2 ? 1 : 0, last).join(' ').replaceAll('_', ' ');
  if (isEnergy(unit)) {
    return parts[0] === 'fluid' ? 'energy of the fluid since the start'
      : parts[0] === 'solid' ? 'energy of the solids since the start' : 'balance of energy';
  }
  if (parts[0] === 'fluid' && parts[1].startsWith('volume_')) {
    return 'volume of the fluid by cause since the start';
  }
  return parts.length > 1 ? quantity : name.startsWith('water_') ? 'water' : unit === '-' ? 'counts and ratios' :
      SCENE.has(name) ? 'scene' : 'gauges';
}

/** An energy is drawn as its change: a large one that is constant would flatten all others. */
function sinceStart(column) {
  const start = column.values.find(v => Number.isFinite(v)) ?? 0;
  return isEnergy(column.unit) ? {...column, values: column.values.map(v => v - start)} : column;
}

/** What is looked at first: energies, then quantities with a unit, then counts and ratios. */
function rank(unit) {
  return isEnergy(unit) ? 0 : unit === '-' ? 2 : 1;
}

function groupBy(list, key) {
  const groups = new Map();
  for (const item of list) {
    groups.set(key(item), [...groups.get(key(item)) ?? [], item]);
  }
  return groups;
}
