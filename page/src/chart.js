// SPDX-License-Identifier: Apache-2.0
// One chart over time, drawn by uPlot: curves of one unit, and of a second one on the right where the reader adds some.

import uPlot from 'uplot';
import 'uplot/dist/uPlot.min.css';
import {LINES} from './colours.js';
import {axisText, reading, tickText, ticks} from './numbers.js';
import {save} from './save.js';

const HEIGHT = 170;
const SHOWN_AT_FIRST = LINES.length;  // curves of a chart; the others are a click away
const WIDEST_BAND = 3;                // a band of expected answers widens the axis by so much of the curves at most
const FONT = '11px system-ui, "DejaVu Sans", sans-serif';
const ruler = document.createElement('canvas').getContext('2d');

function textWidth(text) {
  ruler.font = FONT;
  return ruler.measureText(text).width;
}

const finiteRange = lists => {
  let low = Infinity, high = -Infinity;
  for (const values of lists) {
    for (const v of values) {
      if (Number.isFinite(v)) {
        low = Math.min(low, v);
        high = Math.max(high, v);
      }
    }
  }
  return [low, high];
};

const spread = values => {
  const [low, high] = finiteRange([values]);
  return high > low ? high - low : 0;
};

/** Bounds of an axis: those of the curves and of what is expected of them, with some air. */
function rangeOf(curves) {
  let [low, high] = finiteRange(curves.map(curve => curve.values));
  if (low > high) {
    return [0, 1];
  }
  const room = WIDEST_BAND * (high - low || Math.abs(high) || 1);
  for (const {low: from, high: to} of curves.flatMap(curve => curve.bands)) {
    for (const v of [from, to]) {
      if (Number.isFinite(v) && v > high - room && v < low + room) {
        [low, high] = [Math.min(low, v), Math.max(high, v)];
      }
    }
  }
  const pad = high > low ? 0.06 * (high - low) : Math.abs(high) || 1;
  return [low - pad, high + pad];
}

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

const stepOf = marks => marks.length > 1 ? marks[1] - marks[0] : Math.abs(marks[0]) || 1;

function element(tag, className, text = '') {
  const node = document.createElement(tag);
  node.className = className;
  node.textContent = text;
  return node;
}

export class Chart {
  /** `others`: columns of the same table that the reader may add; `onTime` is told of a click. */
  constructor(parent, heading, time, curves, others, isOpen, onTime) {
    Object.assign(this, {heading, time, curves, others, onTime});
    const order = [...curves].sort((a, b) => spread(b.values) - spread(a.values));
    curves.forEach((curve, k) => this.#dress(curve, k, order.indexOf(curve) < SHOWN_AT_FIRST));
    this.details = element('details', '');
    this.details.open = isOpen;
    this.details.append(element('summary', '', heading));
    this.place = element('div', 'plot');
    this.place.setAttribute('role', 'img');
    this.place.setAttribute('aria-label', `${heading} over time`);
    this.list = element('ul', 'curves');
    this.hint = element('p', 'hint', 'Unticked curves are not drawn; a click draws them.');
    this.details.append(this.place, this.list, this.#tools(), this.hint);
    curves.forEach(curve => this.#addEntry(curve));
    this.#tellHidden();
    parent.append(this.details);
    this.details.addEventListener('toggle', () => this.draw());
  }

  #dress(curve, k, isShown) {
    Object.assign(curve, {isShown, colour: LINES[k % LINES.length],
                          dash: k < LINES.length ? [] : k < 2 * LINES.length ? [5, 3] : [2, 2]});
  }

  #tools() {
    const bar = element('div', 'tools');
    const add = element('select', 'add');
    add.title = 'draw another quantity; one of another unit has its axis on the right';
    add.setAttribute('aria-label', `add a curve to ${this.heading}`);
    const fill = () => {
      const right = this.curves.find(curve => curve.isRight)?.unit;
      const free = this.others.filter(o => !this.curves.some(c => c.name === o.name) &&
          (!right || o.unit === right || o.unit === this.curves[0].unit));
      add.replaceChildren(new Option('add a curve', ''), ...free.map(o => new Option(`${o.name} [${o.unit}]`, o.name)));
      add.hidden = free.length === 0;
    };
    fill();
    add.addEventListener('change', () => {
      const column = this.others.find(o => o.name === add.value);
      if (column) {
        const curve = {...column, isRight: column.unit !== this.curves[0].unit};
        this.#dress(curve, this.curves.length, true);
        this.curves.push(curve);
        this.#addEntry(curve);
        fill();
        this.draw();
      }
    });
    const table = element('button', '', 'CSV');
    table.title = 'save the curves that are drawn as a table';
    table.addEventListener('click', () => this.#saveTable());
    this.whole = element('button', '', 'whole time');
    this.whole.title = 'undo the zoom; a double click in the chart does the same';
    this.whole.hidden = true;
    this.whole.addEventListener('click', () => this.plot.setScale('x', {min: this.time[0], max: this.time.at(-1)}));
    bar.append(add, table, this.whole);
    return bar;
  }

  #saveTable() {
    const shown = this.curves.filter(curve => curve.isShown);
    const quoted = text => /[",\n]/.test(text) ? `"${text.replaceAll('"', '""')}"` : text;
    const rows = [['time [s]', ...shown.map(c => quoted(`${c.name} [${c.unit}]`))].join(',')];
    this.time.forEach((t, i) => rows.push([t, ...shown.map(c => c.values[i])].join(',')));
    save(`${this.heading.replace(/ \[.*\]$/, '').replaceAll(' ', '_')}.csv`, new Blob([rows.join('\n') + '\n'], {type: 'text/csv'}));
  }

  #addEntry(curve) {
    const entry = element('li', ''), button = element('button', '');
    button.innerHTML = '<i></i><span></span><b></b>';
    button.querySelector('i').style.borderTop = `2px ${curve.dash.length ? 'dashed' : 'solid'} ${curve.colour}`;
    button.querySelector('span').textContent = curve.isRight ? `${curve.name} [${curve.unit}], right` : curve.name;
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
    if (!this.plot || !this.details.open) {
      return;
    }
    const {min, max} = this.plot.scales.x, isIn = now >= min - 1e-9 * (max - min) && now <= max + 1e-9 * (max - min);
    this.mark.hidden = !isIn;
    this.mark.style.transform = `translateX(${this.plot.valToPos(Math.min(Math.max(now, min), max), 'x')}px)`;
    this.#read();
  }

  /** The readings beside the names: under the pointer, else at the time of the scene. */
  #read() {
    const row = this.plot.cursor.idx ?? rowAt(this.time, this.now + 1e-9 * Math.abs(this.now));
    for (const curve of this.curves) {
      curve.value.textContent = curve.isShown ? reading(curve.values[row], 4) : '';
    }
  }

  draw() {
    const width = this.place.clientWidth;
    if (!this.details.open || width === 0) {
      return;
    }
    const zoom = this.plot?.scales.x;
    this.plot?.destroy();
    const shown = this.curves.filter(curve => curve.isShown);
    this.plot = new uPlot(this.#options(width, shown), [this.time, ...shown.map(curve => curve.values)], this.place);
    this.mark = element('div', 'now');
    this.plot.over.append(this.mark);
    if (zoom && (zoom.min > this.time[0] || zoom.max < this.time.at(-1))) {
      this.plot.setScale('x', {min: zoom.min, max: zoom.max});
    }
    this.#listen();
    this.at(this.now ?? this.time[0]);
  }

  #listen() {
    let down = null;
    const {over} = this.plot;
    over.addEventListener('pointerdown', event => { down = event.clientX; });
    over.addEventListener('click', event => {
      if (down !== null && Math.abs(event.clientX - down) < 4) {  // a drag zooms
        this.onTime(this.plot.posToVal(event.clientX - over.getBoundingClientRect().left, 'x'));
      }
    });
  }

  #options(width, shown) {
    const style = getComputedStyle(document.documentElement), colour = name => style.getPropertyValue(name).trim();
    const last = this.time.length > 1 ? this.time.at(-1) : this.time[0] + 1;
    const scales = {x: {time: false, range: (u, min, max) => [Math.max(min, this.time[0]), Math.min(max, last)]}};
    const marksOf = ({min, max}) => {  // tables begin and end a step beside round times
      const near = 0.01 * (max - min);
      return ticks(min - near, max + near, Math.max(2, width / 90));
    };
    const axes = [{...this.#axis(colour), size: 24, splits: u => marksOf(u.scales.x).map(t =>
        Math.min(Math.max(t, u.scales.x.min), u.scales.x.max)), values: u => marksOf(u.scales.x).map((t, k, marks) =>
        tickText(t, stepOf(marks)) + (k === marks.length - 1 ? ' s' : ''))}];
    const isRight = curve => curve.isRight === true;
    for (const [name, side, list] of [['y', 3, shown.filter(c => !isRight(c))], ['right', 1, shown.filter(isRight)]]) {
      if (name === 'right' && list.length === 0) {
        continue;
      }
      const range = rangeOf(list), marks = ticks(...range, 4);
      scales[name] = {range};
      axes.push({
        ...this.#axis(colour), scale: name, side, splits: () => marks,
        values: () => marks.map(v => axisText(v, stepOf(marks))), grid: {show: name === 'y', stroke: colour('--grid'), width: 1},
        size: Math.max(44, 14 + Math.ceil(Math.max(...marks.map(v => textWidth(axisText(v, stepOf(marks)))))))});
    }
    const hasRight = 'right' in scales;
    return {
      width, height: HEIGHT, scales, axes, legend: {show: false}, padding: [8, hasRight ? 0 : 18, 0, 0],
      cursor: {y: false, sync: {key: 'time'}, points: {size: 6}, drag: {x: true, y: false, dist: 4}},
      series: [{}, ...shown.map(curve => ({
        label: curve.name, scale: isRight(curve) ? 'right' : 'y', stroke: curve.colour, dash: curve.dash, width: 1.5,
        points: {show: false}, spanGaps: false}))],
      hooks: {
        drawClear: [u => this.#drawBands(u, shown)], setCursor: [() => this.plot && this.#read()],
        setScale: [(u, key) => key === 'x' && this.#zoomed(u)]},
    };
  }

  #axis(colour) {
    return {stroke: colour('--faint-text'), font: FONT, grid: {show: false}, ticks: {show: true, stroke: colour('--grid'), size: 4}, gap: 4};
  }

  #zoomed(u) {
    const {min, max} = u.scales.x;
    this.whole.hidden = !(min > this.time[0] || max < this.time.at(-1));
    if (this.mark) {
      this.at(this.now ?? this.time[0]);
    }
  }

  /** Where an expected answer may lie. */
  #drawBands(u, shown) {
    const {ctx, bbox} = u;
    ctx.save();
    ctx.beginPath();
    ctx.rect(bbox.left, bbox.top, bbox.width, bbox.height);
    ctx.clip();
    for (const curve of shown) {
      const scale = curve.isRight ? 'right' : 'y', {min, max} = u.scales[scale];
      for (const band of curve.bands) {
        const [low, high] = [band.low ?? -Infinity, band.high ?? Infinity].map(v => Math.min(Math.max(v, min), max));
        const [top, bottom] = [high, low].map(v => u.valToPos(v, scale, true));
        ctx.globalAlpha = 0.16;
        ctx.fillStyle = curve.colour;
        ctx.fillRect(bbox.left, top, bbox.width, Math.max(bottom - top, devicePixelRatio));
      }
    }
    ctx.restore();
  }
}
