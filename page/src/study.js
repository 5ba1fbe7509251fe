// SPDX-License-Identifier: Apache-2.0
// The page of a study or an ensemble: a table of all runs, the answers over each key, the curves of all runs over time. The
// charts are those of the page of a run.

import {Chart, withUnit} from './chart.js';
import {LINES} from './colours.js';
import {note} from './marks.js';
import {reading} from './numbers.js';
import * as data from './study_data.js';

const $ = id => document.getElementById(id);
const DIGITS = 4;
const OPEN_AT_FIRST = 12;   // charts over time
const MOST_THIN = 40;       // members of an ensemble that are drawn behind its bands
const FAINT = '#88888870';

function make(tag, text = '', name = '') {
  const node = document.createElement(tag);
  node.textContent = text;
  node.className = name;
  return node;
}

const shown = value => Number.isFinite(value ?? NaN) ? reading(value, DIGITS) : '';

class StudyPage {
  constructor(study) {
    Object.assign(this, {study, runs: study.runs, bands: study.bands, keys: data.keysOf(study), figure: 'last', charts: []});
    this.coloured = data.colouredKey(this.keys);
    this.colours = data.coloursOf(this.coloured?.values.length ?? 0);
  }

  open() {
    const {study, runs, bands} = this, name = study.title || study.case;
    const what = bands ? `Ensemble of ${name}: ${this.keys.map(key => key.name).join(', ')}` : `Study of ${name}: ${data.differences(this.keys)}`;
    document.title = $('title').textContent = what;
    const failed = runs.filter(run => !data.isFinished(run));
    $('status').textContent = `${runs.length} ${bands ? 'members' : 'runs'}, ${runs.length - failed.length} finished`;
    $('status').classList.toggle('failed', failed.length > 0);
    document.body.classList.add('study');
    document.querySelectorAll('header label, #warnings, #panel-button, #help-button, footer').forEach(one => { one.hidden = true; });
    const main = make('main');
    main.append($('trouble'));
    document.querySelector('main').replaceWith(main);
    this.over = make('section');
    this.table = make('section');
    main.append(this.#about(), ...(failed.length ? [this.#failures(failed)] : []), this.table, this.over, this.#overTime(), this.#hint());
    this.#wire();
    this.#compare();
  }

  #about() {
    const text = this.study.set.length ? `All with ${this.study.set.join(', ')}.` : '';
    return make('p', text, 'hint');
  }

  #failures(failed) {
    const box = make('section', '', 'banner'), list = make('ul');
    box.append(make('b', `${failed.length} of ${this.runs.length} did not finish`), list);
    for (const run of failed) {
      const item = make('li');
      item.append(make('b', run.name), ` (${this.keys.map(key => data.saidOf(key, run)).join(', ')}): ${run.status}${run.reason ? `: ${run.reason}` : ''}`);
      list.append(item);
    }
    return box;
  }

  #hint() {
    return make('p', this.bands ? 'Shaded: from the least to the largest member, darker from the 10th to the 90th percentile. Thin lines: members.'
      : this.runs.length > 1 ? `The scenes of two to nine runs side by side: riprap view ${this.runs.slice(0, 2).map(run => run.name).join(' ')}, in this folder.` : '', 'hint');
  }

  #wire() {
    const set = theme => {
      this.theme = document.documentElement.dataset.theme = theme;
      this.charts.forEach(chart => chart.draw());
    };
    set(matchMedia('(prefers-color-scheme: dark)').matches ? 'dark' : 'light');
    $('theme').addEventListener('click', () => set(this.theme === 'dark' ? 'light' : 'dark'));
    let width = 0;
    new ResizeObserver(() => {
      if (document.body.clientWidth !== width) {
        width = document.body.clientWidth;
        this.charts.forEach(chart => chart.draw());
      }
    }).observe(document.body);
  }

  /** Table and charts over keys, made anew where the reader chooses another figure of the columns. */
  #compare() {
    this.charts = this.charts.filter(chart => !this.over.contains(chart.details));
    const measures = data.measuresOf(this.runs, this.figure), finished = this.runs.filter(data.isFinished);
    this.table.replaceChildren(...this.#heading(), this.#tableOf(measures));
    this.over.replaceChildren();
    for (const key of this.keys.filter(one => one.values.length > 1)) {
      const series = this.bands ? [{label: '', members: finished, hasLine: false}] : data.seriesOver(finished, key, this.keys);
      this.#grid(this.over, `Over ${withUnit(key)}`, measures.map(measure => this.#overKey(key, measure, series)));
    }
    this.charts.forEach(chart => this.over.contains(chart.details) && chart.draw());
  }

  #heading() {
    const heading = make('h2', 'Answers');
    if (this.runs.some(run => run.answers.length)) {
      return [heading];
    }
    const choice = make('label', 'values '), select = make('select');
    select.id = 'figure';
    select.append(...Object.entries(data.FIGURES).map(([word, text]) => new Option(text, word, false, word === this.figure)));
    select.addEventListener('change', () => { this.figure = select.value; this.#compare(); });
    choice.append(select);
    return [heading, choice];
  }

  #tableOf(measures) {
    const box = make('div', '', 'table'), table = make('table', '', 'runs'), head = table.createTHead().insertRow(), body = table.createTBody();
    const title = (text, about = '') => {
      const cell = make('th', text);
      cell.title = about;
      head.append(cell);
    };
    title('run');
    this.keys.forEach(key => title(withUnit(key), key.path));
    measures.forEach(measure => title(withUnit(measure) + (measure.expected ? `, expected ${data.rangeText(measure.expected)}` : '')));
    ['status', 'took [s]'].forEach(text => title(text));
    this.runs.forEach(run => body.append(this.#rowOf(run, measures)));
    if (this.bands) {
      table.append(this.#quantiles(measures));
    }
    box.append(table);
    return box;
  }

  #rowOf(run, measures) {
    const row = make('tr', '', data.isFinished(run) ? '' : 'failed'), first = make('td'), link = make(run.page ? 'a' : 'span', run.name);
    const chip = make('i');
    chip.style.background = this.colourOf(run);
    if (run.page) {
      link.href = run.page;
    }
    first.append(...(this.bands ? [] : [chip]), link);
    row.append(first);
    for (const key of this.keys) {
      const value = key.values[data.placeOf(key, run)];
      row.append(make('td', !value ? '' : this.bands && key.areNumbers ? shown(value.number) : value.text));
    }
    for (const measure of measures) {
      const verdict = measure.verdictOf(run);
      row.append(make('td', shown(measure.valueOf(run)), verdict ? `verdict ${verdict}` : ''));
    }
    row.append(make('td', run.status, 'state'), make('td', data.isFinished(run) ? reading(run.wall_seconds, 3) : ''));
    return row;
  }

  /** Quantiles of an ensemble, below its members. */
  #quantiles(measures) {
    const foot = make('tfoot'), finished = this.runs.filter(data.isFinished);
    for (const [name, share] of [['least', 0], ['10 %', 0.1], ['median', 0.5], ['90 %', 0.9], ['largest', 1]]) {
      const row = make('tr'), add = values => row.append(make('td', shown(data.quantile(values, share))));
      row.append(make('th', name));
      this.keys.forEach(key => add(finished.map(run => key.values[data.placeOf(key, run)]?.number ?? NaN)));
      measures.forEach(measure => add(finished.map(measure.valueOf)));
      row.append(make('td'), make('td'));
      foot.append(row);
    }
    return foot;
  }

  colourOf(run) {
    return this.colours[data.placeOf(this.coloured, run)] ?? FAINT;
  }

  #grid(parent, heading, charts) {
    const list = charts.filter(Boolean);
    if (list.length > 0) {
      const grid = make('div', '', 'charts');
      parent.append(make('h2', heading), grid);
      list.forEach(build => this.charts.push(build(grid)));
    }
  }

  /** A chart of one answer over one key; nothing where no run has both. */
  #overKey(key, measure, series) {
    const used = key.values.map((_, k) => k).filter(k => series.some(({members}) => members.some(
        run => data.placeOf(key, run) === k && Number.isFinite(measure.valueOf(run)))));
    const places = used.map((k, n) => key.areNumbers ? key.values[k].number : n), first = series.length > 1 && key === this.coloured ? this.colours.length : 0;
    if (used.length === 0) {
      return null;
    }
    const palette = series.length > 1 && key !== this.coloured && this.keys.length === 2 ? this.colours : data.coloursOf(series.length, first);
    const curves = series.map(({label, members, hasLine}, k) => {
      const values = used.map(() => null);
      members.map(run => [used.indexOf(data.placeOf(key, run)), measure.valueOf(run)]).filter(([place, v]) => place >= 0 && Number.isFinite(v))
          .forEach(([place, v]) => { values[place] = v; });
      return {name: label || measure.name, unit: measure.unit, values, hasDots: true, hasLine, isShown: true, colour: palette[k]};
    });
    const look = {x: {name: key.name, unit: key.unit, ...(key.areNumbers ? {} : {words: used.map(k => key.values[k].text)})}, hasClock: false,
                  expected: measure.expected};
    return parent => new Chart(parent, withUnit(measure), places, curves, [], true, undefined, look);
  }

  #overTime() {
    const section = make('section'), facets = this.bands ? [{label: '', members: this.runs}] : data.facetsOf(this.runs, this.keys);
    let count = 0;
    const charts = data.columnsOf(this.runs).flatMap(column => facets.map(facet => this.#column(column, facet, () => count++ < OPEN_AT_FIRST)));
    this.#grid(section, 'Over time', charts);
    return section;
  }

  #column({name, unit}, {label, members, isWhole}, isOpen) {
    const drawn = members.filter(run => run.curves?.[name]?.length);
    if (drawn.length === 0) {
      return null;
    }
    const bands = this.bands?.[`${name}.p50`] ? this.bands : undefined, lists = drawn.map(run => run.curves.time);
    const times = data.commonTimes(bands ? [bands.time] : lists), part = word => data.resampled(bands.time, bands[`${name}.${word}`], times);
    const keys = isWhole ? this.keys : [this.coloured];
    const colours = isWhole && this.keys.length > 1 ? data.coloursOf(drawn.length) : undefined;
    const thin = bands && drawn.length > MOST_THIN ? [] : drawn;
    const curves = thin.map((run, k) => ({
      name: keys.map(key => data.saidOf(key, run)).join(', ') + (data.isFinished(run) ? '' : `, ${run.status}`), unit, isShown: true,
      values: data.resampled(run.curves.time, run.curves[name], times), colour: bands ? FAINT : colours ? colours[k] : this.colourOf(run),
      dash: data.isFinished(run) ? [] : [2, 4], isQuiet: Boolean(bands), width: bands ? 0.75 : 1.5}));
    const means = bands ? [['median', 'p50', []], ['mean', 'mean', [5, 3]]].map(([word, column, dash]) => ({
      name: word, unit, values: part(column), colour: LINES[0], dash, isShown: true, width: 2})) : [];
    const areas = bands ? [['low', 'high'], ['p10', 'p90']].map(([low, high]) => ({low: part(low), high: part(high), colour: LINES[0]})) : [];
    const look = {x: {name: 'time', unit: 's'}, hasClock: false, areas};
    const heading = withUnit({name, unit: unit === '-' ? '' : unit}) + (label ? `, ${label}` : '');
    return parent => new Chart(parent, heading, times, [...curves, ...means], [], isOpen(), undefined, look);
  }
}

export async function openStudy() {
  const page = new StudyPage(JSON.parse($('study').textContent));
  page.open();
  window.riprap = {study: page.study, keys: page.keys, get charts() { return page.charts; }};
  note('opened');
}
