// SPDX-License-Identifier: Apache-2.0
// One chart, drawn by uPlot: curves of one unit, and of a second one on the right where the reader adds some. It is over the
// time of a run, or over what `look` says: the pages of a run and of a study have this one code.

import uPlot from 'uplot';
import 'uplot/dist/uPlot.min.css';
import {LINES} from './colours.js';
import {axisText, reading, tickText, ticks} from './numbers.js';
import {save} from './save.js';

const HEIGHT = 170;
const SHOWN_AT_FIRST = LINES.length;  // curves of a chart; the others are a click away
const MET = '#1f8a5b';
const WIDEST_BAND = 3;                // a band of expected answers widens the axis by so much of the curves at most
const ROUND_OFF = 1e-9;               // a curve that changes by less of its size is drawn as constant
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
  const changes = () => high - low > ROUND_OFF * Math.max(Math.abs(low), Math.abs(high));
  const room = WIDEST_BAND * (changes() ? high - low : Math.abs(high) || 1);
  for (const {low: from, high: to} of curves.flatMap(curve => curve.bands)) {
    for (const v of [from, to]) {
      if (Number.isFinite(v) && v > high - room && v < low + room) {
        [low, high] = [Math.min(low, v), Math.max(high, v)];
      }
    }
  }
  const pad = changes() ? 0.06 * (high - low) : Math.abs(high) || 1;
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

export const withUnit = ({name, unit}) => unit ? `${name} [${unit}]` : name;

const stepOf = marks => marks.length > 1 ? marks[1] - marks[0] : Math.abs(marks[0]) || 1;

function element(tag, className, text = '') {
  const node = document.createElement(tag);
  node.className = className;
  node.textContent = text;
  return node;
}

const OVER_TIME = {x: {name: 'time', unit: 's'}, hasClock: true, areas: []};

export class Chart {
  /**
   * `others`: columns of the same table that the reader may add; `onTime` is told of a click. `look`, where it is not the
   * time of one run: `x` {name, unit, words of places 0, 1, ...}, `areas` [{low, high, colour}] behind the curves, `expected` {low,
   * high}, `hasClock`. A curve may bring its `colour` and `dash`, points `hasDots` without `hasLine`, and be `isQuiet`: not in the list.
   */
  constructor(parent, heading, time, curves, others, isOpen, onTime, look = {}) {
    Object.assign(this, {heading, time, curves, others, onTime, look: {...OVER_TIME, ...look}});
    const order = [...curves].sort((a, b) => spread(b.values) - spread(a.values));
    curves.forEach((curve, k) => this.#dress(curve, k, order.indexOf(curve) < SHOWN_AT_FIRST));
    this.details = element('details', '');
    this.details.open = isOpen;
    this.details.append(element('summary', '', heading));
    this.place = element('div', 'plot');
    this.place.setAttribute('role', 'img');
    this.place.setAttribute('aria-label', `${heading} over ${this.look.x.name}`);
    this.list = element('ul', 'curves');
    this.hint = element('p', 'hint', 'Unticked curves are not drawn; a click draws them.');
    this.details.append(this.place, this.list, this.#tools(), this.hint);
    curves.filter(curve => !curve.isQuiet).forEach(curve => this.#addEntry(curve));
    this.#tellHidden();
    parent.append(this.details);
    this.details.addEventListener('toggle', () => this.draw());
  }

  #dress(curve, k, isShown) {
    Object.assign(curve, {isShown: curve.isShown ?? isShown, bands: curve.bands ?? [], colour: curve.colour ?? LINES[k % LINES.length],
                          dash: curve.dash ?? (k < LINES.length ? [] : k < 2 * LINES.length ? [5, 3] : [2, 2])});
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
    const rows = [[quoted(withUnit(this.look.x)), ...shown.map(c => quoted(withUnit(c)))].join(',')];
    const {words} = this.look.x;
    this.time.forEach((t, i) => rows.push([words ? quoted(words[t]) : t, ...shown.map(c => c.values[i])].join(',')));
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
    this.mark.hidden = !isIn || !this.look.hasClock;
    this.mark.style.transform = `translateX(${this.plot.valToPos(Math.min(Math.max(now, min), max), 'x')}px)`;
    this.#read();
  }

  /** The readings beside the names: under the pointer, else at the time of the scene. */
  #read() {
    const row = this.plot.cursor.idx ?? (!this.look.hasClock ? -1 : rowAt(this.time, this.now + 1e-9 * Math.abs(this.now)));
    for (const curve of this.curves) {
      if (curve.value) {
        curve.value.textContent = curve.isShown && Number.isFinite(curve.values[row] ?? NaN) ? reading(curve.values[row], 4)
          : curve.isShown && this.look.hasClock ? 'not known' : '';
      }
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
        this.onTime?.(this.plot.posToVal(event.clientX - over.getBoundingClientRect().left, 'x'));
      }
    });
  }

  #options(width, shown) {
    const style = getComputedStyle(document.documentElement), colour = name => style.getPropertyValue(name).trim();
    const scales = {x: {time: false, range: this.#xRange()}};
    const axes = [this.#xAxis(colour, width)];
    const isRight = curve => curve.isRight === true;
    for (const [name, side, list] of [['y', 3, shown.filter(c => !isRight(c))], ['right', 1, shown.filter(isRight)]]) {
      if (name === 'right' && list.length === 0) {
        continue;
      }
      const more = name === 'y' ? this.#behind() : [];
      const range = rangeOf([...list, ...more]), marks = ticks(...range, 4);
      scales[name] = {range};
      axes.push({
        ...this.#axis(colour), scale: name, side, splits: () => marks,
        values: () => marks.map(v => axisText(v, stepOf(marks))), grid: {show: name === 'y', stroke: colour('--grid'), width: 1},
        size: Math.max(44, 14 + Math.ceil(Math.max(...marks.map(v => textWidth(axisText(v, stepOf(marks)))))))});
    }
    const hasRight = 'right' in scales;
    return {
      width, height: HEIGHT, scales, axes, legend: {show: false}, padding: [8, hasRight ? 0 : 18, 0, 0],
      cursor: {y: false, sync: {key: this.look.x.name}, points: {size: 6}, drag: {x: true, y: false, dist: 4}},
      series: [{}, ...shown.map(curve => ({
        label: curve.name, scale: isRight(curve) ? 'right' : 'y', stroke: curve.colour, dash: curve.dash, width: curve.width ?? 1.5,
        pxAlign: 0, points: curve.hasDots ? {show: true, size: 7, fill: curve.isHollow ? colour('--ground') : curve.colour} : {show: false},
        ...(curve.hasLine === false ? {paths: () => null} : {}), spanGaps: curve.hasDots === true}))],
      hooks: {
        drawClear: [u => this.#drawAreas(u), u => this.#drawBands(u, shown)], setCursor: [() => this.plot && this.#read()],
        setScale: [(u, key) => key === 'x' && this.#zoomed(u)]},
    };
  }

  #xRange() {
    const last = this.time.length > 1 ? this.time.at(-1) : this.time[0] + (this.look.x.words ? 0 : 1);
    if (this.look.hasClock || !this.curves.some(curve => curve.hasDots)) {
      return (u, min, max) => [Math.max(min, this.time[0]), Math.min(max, last)];
    }
    const pad = this.look.x.words ? 0.5 : 0.06 * (last - this.time[0]);  // dots and words at the ends are seen whole
    return (u, min, max) => [Math.max(min - pad, this.time[0] - pad), Math.min(max + pad, last + pad)];
  }

  #xAxis(colour, width) {
    const {name, unit, words} = this.look.x, title = {label: withUnit(this.look.x), labelSize: 20, labelFont: FONT, labelGap: 0};
    const axis = {...this.#axis(colour), size: 24, ...(this.look.hasClock ? {} : title)};
    if (words) {
      return {...axis, splits: () => words.map((_, k) => k), values: () => words.map(word => word.replaceAll('_', ' '))};
    }
    const marksOf = ({min, max}) => {  // tables begin and end a step beside round times
      const near = this.look.hasClock ? 0.01 * (max - min) : 0;
      return ticks(min - near, max + near, Math.max(2, width / 90));
    };
    const last = name === 'time' && this.look.hasClock ? ` ${unit}` : '';
    return {...axis, splits: u => marksOf(u.scales.x).map(t => Math.min(Math.max(t, u.scales.x.min), u.scales.x.max)),
            values: u => marksOf(u.scales.x).map((t, k, marks) => tickText(t, stepOf(marks)) + (k === marks.length - 1 ? last : ''))};
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

  /** What the axis has to hold beside the curves. */
  #behind() {
    const {areas, expected} = this.look;
    return [...areas.flatMap(({low, high}) => [low, high]).map(values => ({values, bands: []})),
            ...(expected ? [{values: [], bands: [expected]}] : [])];
  }

  /** Ranges behind the curves: those of the members of an ensemble, and what is expected. */
  #drawAreas(u) {
    const {ctx, bbox} = u, {areas, expected} = this.look, {min, max} = u.scales.y;
    const height = v => u.valToPos(Math.min(Math.max(v, min), max), 'y', true);
    ctx.save();
    ctx.beginPath();
    ctx.rect(bbox.left, bbox.top, bbox.width, bbox.height);
    ctx.clip();
    ctx.globalAlpha = 0.18;
    for (const {low, high, colour} of areas) {
      const rows = [...this.time.keys()].filter(k => Number.isFinite(low[k]) && Number.isFinite(high[k]));
      ctx.fillStyle = colour;
      ctx.beginPath();
      rows.forEach(k => ctx.lineTo(u.valToPos(this.time[k], 'x', true), height(high[k])));
      rows.reverse().forEach(k => ctx.lineTo(u.valToPos(this.time[k], 'x', true), height(low[k])));
      ctx.fill();
    }
    if (expected) {
      const top = height(expected.high ?? Infinity), bottom = height(expected.low ?? -Infinity);
      ctx.fillStyle = MET;
      ctx.fillRect(bbox.left, top, bbox.width, Math.max(bottom - top, devicePixelRatio));
    }
    ctx.restore();
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
