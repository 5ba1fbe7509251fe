// SPDX-License-Identifier: Apache-2.0
// Curves over time from the tables of the run, all under the time that the scene shows. A chart has one unit and holds
// quantities of one kind: positions do not flatten levels, nor water the blocks.

import {LINES} from './colours.js';
import {axisText, reading, tickText, ticks} from './numbers.js';

const MARGIN = {left: 58, right: 10, top: 8, bottom: 24};  // pixels
const HEIGHT = 150;
const SHOWN_AT_FIRST = LINES.length;  // curves of a chart; the others are a click away
const OPEN_AT_FIRST = 5;              // charts

function rangeOf(curves) {
  let low = Infinity, high = -Infinity;
  for (const curve of curves) {
    for (const v of curve.values) {
      if (Number.isFinite(v)) {
        low = Math.min(low, v);
        high = Math.max(high, v);
      }
    }
  }
  if (low > high) {
    return [0, 1];
  }
  const pad = high > low ? 0.06 * (high - low) : Math.abs(high) || 1;
  return [low - pad, high + pad];
}

const spread = values => {
  const [low, high] = rangeOf([{values}]);
  return high - low;
};

/** Index of the last row at or before a time. */
function rowAt(times, time) {
  let low = 0, high = times.length - 1;
  while (low < high) {
    const middle = (low + high + 1) >> 1;
    if (times[middle] <= time) {
      low = middle;
    } else {
      high = middle - 1;
    }
  }
  return low;
}

class Chart {
  constructor(parent, heading, time, curves, isOpen, onTime) {
    this.time = time;
    this.curves = curves;
    const order = [...curves].sort((a, b) => spread(b.values) - spread(a.values));
    curves.forEach((curve, k) => {
      curve.isShown = order.indexOf(curve) < SHOWN_AT_FIRST;
      curve.colour = LINES[k % LINES.length];
      curve.dash = k < LINES.length ? [] : k < 2 * LINES.length ? [5, 3] : [2, 2];
    });
    this.details = document.createElement('details');
    this.details.open = isOpen;
    this.details.innerHTML = '<summary></summary><canvas role="img"></canvas><ul class="curves"></ul>';
    this.details.firstChild.textContent = heading;
    this.hint = document.createElement('p');
    this.hint.className = 'hint';
    this.hint.textContent = 'Unticked curves are not drawn; a click draws them.';
    this.details.append(this.hint);
    this.#tellHidden();
    this.canvas = this.details.querySelector('canvas');
    this.canvas.setAttribute('aria-label', `${heading} over time`);
    this.list = this.details.querySelector('ul');
    for (const curve of curves) {
      this.#addEntry(curve);
    }
    parent.append(this.details);
    this.details.addEventListener('toggle', () => this.draw());
    const point = event => {
      if (event.buttons === 1) {
        const share = (event.offsetX - (this.left ?? MARGIN.left)) /
            (this.canvas.clientWidth - (this.left ?? MARGIN.left) - MARGIN.right);
        onTime(this.time[0] + Math.min(Math.max(share, 0), 1) * (this.time.at(-1) - this.time[0]));
      }
    };
    this.canvas.addEventListener('pointerdown', point);
    this.canvas.addEventListener('pointermove', point);
  }

  #addEntry(curve) {
    const entry = document.createElement('li');
    const button = document.createElement('button');
    button.innerHTML = '<i></i><span></span><b></b>';
    button.querySelector('i').style.borderTop = `2px ${curve.dash.length ? 'dashed' : 'solid'} ${curve.colour}`;
    button.querySelector('span').textContent = curve.name;
    curve.value = button.querySelector('b');
    button.setAttribute('aria-pressed', curve.isShown);
    button.addEventListener('click', () => {
      curve.isShown = !curve.isShown;
      button.setAttribute('aria-pressed', curve.isShown);
      this.#tellHidden();
      this.draw();
    });
    entry.append(button);
    this.list.append(entry);
  }

  #tellHidden() {
    this.hint.hidden = this.curves.every(curve => curve.isShown);
  }

  at(now) {
    this.now = now;
    if (!this.details.open || this.canvas.clientWidth === 0) {
      return;
    }
    const row = rowAt(this.time, now + 1e-9 * Math.abs(now));
    for (const curve of this.curves) {
      curve.value.textContent = curve.isShown ? reading(curve.values[row], 4) : '';
    }
    if (this.picture) {
      this.#drawCursor();
    }
  }

  draw() {
    if (!this.details.open || this.canvas.clientWidth === 0) {
      return;
    }
    const ratio = window.devicePixelRatio, width = this.canvas.clientWidth;
    this.canvas.width = width * ratio;
    this.canvas.height = HEIGHT * ratio;
    this.picture = document.createElement('canvas');
    this.picture.width = this.canvas.width;
    this.picture.height = this.canvas.height;
    const pen = this.picture.getContext('2d');
    pen.scale(ratio, ratio);
    this.#drawAxes(pen, width);
    pen.save();
    pen.beginPath();
    pen.rect(this.left, 0, width - this.left - MARGIN.right, HEIGHT - MARGIN.bottom);
    pen.clip();
    for (const curve of this.curves.filter(c => c.isShown)) {
      this.#drawCurve(pen, curve);
    }
    pen.restore();
    this.at(this.now ?? this.time[0]);
  }

  #drawAxes(pen, width) {
    const shown = this.curves.filter(c => c.isShown);
    const [low, high] = rangeOf(shown), first = this.time[0], last = this.time.at(-1);
    const right = width - MARGIN.right, bottom = HEIGHT - MARGIN.bottom;
    const style = getComputedStyle(document.documentElement);
    pen.font = '11px system-ui, sans-serif';
    const levels = ticks(low, high, 4), gap = marks => marks.length > 1 ? marks[1] - marks[0] : Math.abs(marks[0]) || 1;
    const widest = Math.max(...levels.map(v => pen.measureText(axisText(v, gap(levels))).width));
    this.left = Math.max(MARGIN.left, Math.ceil(widest) + 12);
    this.x = t => this.left + (last > first ? (t - first) / (last - first) : 0.5) * (right - this.left);
    this.y = v => bottom - (v - low) / (high - low) * (bottom - MARGIN.top);
    pen.fillStyle = style.getPropertyValue('--faint-text');
    pen.strokeStyle = style.getPropertyValue('--grid');
    pen.lineWidth = 1;
    pen.textAlign = 'right';
    pen.textBaseline = 'middle';
    for (const v of levels) {
      pen.beginPath();
      pen.moveTo(this.left, this.y(v));
      pen.lineTo(right, this.y(v));
      pen.stroke();
      pen.fillText(axisText(v, gap(levels)), this.left - 5, this.y(v));
    }
    pen.textAlign = 'center';
    pen.textBaseline = 'top';
    const near = 0.01 * (last - first);  // tables begin and end a step beside round times
    const marks = last > first ? ticks(first - near, last + near, Math.max(2, width / 90)) : [first];
    marks.forEach((t, k) => {
      pen.fillText(k === marks.length - 1 ? `${tickText(t, gap(marks))} s` : tickText(t, gap(marks)), Math.min(this.x(t), right - 10), bottom + 6);
    });
  }

  #drawCurve(pen, curve) {
    pen.strokeStyle = curve.colour;
    pen.lineWidth = 1.5;
    pen.setLineDash(curve.dash);
    pen.beginPath();
    let isDown = false;
    curve.values.forEach((v, i) => {
      if (!Number.isFinite(v)) {
        isDown = false;
        return;
      }
      if (isDown) {
        pen.lineTo(this.x(this.time[i]), this.y(v));
      } else {
        pen.moveTo(this.x(this.time[i]), this.y(v));
      }
      isDown = true;
    });
    pen.stroke();
  }

  #drawCursor() {
    const pen = this.canvas.getContext('2d'), ratio = window.devicePixelRatio;
    pen.setTransform(1, 0, 0, 1, 0, 0);
    pen.clearRect(0, 0, this.canvas.width, this.canvas.height);
    pen.drawImage(this.picture, 0, 0);
    pen.scale(ratio, ratio);
    pen.strokeStyle = getComputedStyle(document.documentElement).getPropertyValue('--accent');
    pen.lineWidth = 1.5;
    pen.beginPath();
    pen.moveTo(this.x(this.now), MARGIN.top);
    pen.lineTo(this.x(this.now), HEIGHT - MARGIN.bottom);
    pen.stroke();
  }
}

export class Plots {
  constructor(parent, tables, onTime) {
    this.charts = [];
    for (const table of tables) {
      const drawn = table.columns.filter(
          column => column.name !== 'step' && column.values.some(v => v !== 0 && Number.isFinite(v)));
      const groups = groupBy(drawn, column => `${kindOf(column)} [${column.unit}]`);
      for (const heading of [...groups.keys()].sort((a, b) => rank(groups.get(a)[0].unit) - rank(groups.get(b)[0].unit))) {
        const curves = groups.get(heading).map(sinceStart);
        this.charts.push(new Chart(parent, heading, table.time, curves, this.charts.length < OPEN_AT_FIRST, onTime));
      }
    }
    if (this.charts.length === 0) {
      parent.textContent = 'The run has no tables, or nothing in them but zeros.';
    }
    new ResizeObserver(() => this.draw()).observe(parent);
  }

  draw() {
    this.charts.forEach(chart => chart.draw());
  }

  at(time) {
    this.charts.forEach(chart => chart.at(time));
  }
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
