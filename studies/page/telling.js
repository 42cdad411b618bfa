// SPDX-License-Identifier: Apache-2.0
// Draws what the program says about an answer: sections of sentences, tables and charts. It decides nothing.

import {drawLabel, paddedRange, scaled} from './chart.js';
import {data, summary} from './data.js';
import {bold, bullets, card, el, sentence, svg} from './dom.js';
import {figure} from './figure.js';
import {capital} from './names.js';
import {table} from './table.js';
import {upright} from './uncertainty.js';
import {displayUnit, largest} from './units.js';

/** A text, or texts and {b: text} for what stands out, as children of an element. */
function phrase(parts) {
  return typeof parts === 'string' ? [parts] : parts.map((p) => (typeof p === 'string' ? p : bold(p.b)));
}

/** The sentences and remarks of a headline. */
export function headlineNodes({sentences, remarks}) {
  const lines = sentences.map((s) => sentence(...phrase(s)));
  return remarks.length ? [...lines, bullets(remarks.map(phrase))] : lines;
}

/** What stands at a path of keys, on which * stands for each of a list. */
function valueAt(value, keys) {
  if (!keys.length) return value;
  const further = (one) => valueAt(one, keys.slice(1));
  return keys[0] === '*' ? value.map(further) : further(value[keys[0]]);
}

/** Numbers of a chart: a list, or a path into summary.json. */
function numbersAt(where) {
  return Float64Array.from(typeof where === 'string' ? valueAt(summary, where.split('/')) : where);
}

/** The unit in which an axis is shown. */
function unitOfAxis(axis, lists) {
  return axis.unit === '%' ? {text: '%', divisor: 0.01} : displayUnit(largest(lists), axis.unit);
}

function rangeOf({low, high, zero}, unit, lists) {
  const [least, most] = paddedRange(lists, zero);
  return [low === null ? least : low / unit.divisor, high === null ? most : high / unit.divisor];
}

/** Bars that keep the limit of the chart, and those that break it, as two series. */
function barSeries(chart, name, x, y) {
  const fails = (i) => {
    const middle = (x[i] + x[i + 1]) / 2;
    return (chart.least !== null && middle < chart.least) || (chart.most !== null && middle > chart.most);
  };
  const pick = (wanted) => Float64Array.from(x, (_, i) => (y[i] > 0 && fails(i) === wanted ? y[i] : NaN));
  const both = [{name, y: pick(false), colour: 'c0', bars: true, kind: 'area'}];
  if (chart.least !== null || chart.most !== null)
    both.push({name: 'breaks it', y: pick(true), colour: 'c1', bars: true, kind: 'area'});
  return both;
}

/** A series of the program as series of a chart, not yet in units. */
function strokesOf(chart, {name, stroke, x, y}) {
  const [across, up] = [numbersAt(x), numbersAt(y)];
  if (stroke === 'bars') return barSeries(chart, name, across, up);
  if (stroke === 'outline')
    return [
      {name, y: Float64Array.from(across, (_, i) => up[i] ?? 0), colour: 'ink', steps: true, dash: [5, 4], kind: 'dash'}
    ];
  return [{name, y: up, colour: 'c0'}, {name: '', y: up, colour: 'c0', scatter: true}];
}

function drawGuides(u, guides, divisor, taken) {
  u.ctx.save();
  for (const {at} of guides) upright(u, at / divisor, 'c1', false);
  u.ctx.restore();
  const places = guides.flatMap(
      ({at}) => Array.from(
          {length: 12}, (_, i) => [u.valToPos(at / divisor, 'x', true), u.bbox.top + 6 * i * devicePixelRatio]));
  for (const {at, text} of guides)
    drawLabel(u, text, u.valToPos(at / divisor, 'x', true), u.bbox.top + 14 * devicePixelRatio, taken, places);
}

function draw(node, chart) {
  const x = numbersAt(chart.series[0].x);
  const series = chart.series.flatMap((one) => strokesOf(chart, one));
  const ys = series.map((s) => s.y);
  const [across, up] = [unitOfAxis(chart.x, [x]), unitOfAxis(chart.y, ys)];
  const shown = series.map((s) => ({...s, y: scaled(s.y, up.divisor)}));
  const marks = chart.marks.map((m) => ({x: m.x / across.divisor, y: m.y / up.divisor, text: m.text, colour: 'c1'}));
  const label = (axis, unit) => axis.name + (unit.text ? ' [' + unit.text + ']' : '');
  const legend = series.filter((s) => s.name).map(({name, colour: c, kind}) => ({name, colour: c, kind}));
  if (chart.guides.length) legend.push({name: 'limit', colour: 'c1', kind: undefined});
  const heights = [...shown.map((s) => s.y), Float64Array.from(marks.map((m) => m.y))];
  figure(node, scaled(x, across.divisor), shown, {
    name: chart.name,
    title: capital(chart.title),
    legend: legend.length ? legend : undefined,
    x: {label: label(chart.x, across), range: rangeOf(chart.x, across, [scaled(x, across.divisor)])},
    y: {label: label(chart.y, up), range: rangeOf(chart.y, up, heights)},
    height: 230,
    marks,
    front: (u, taken) => drawGuides(u, chart.guides, across.divisor, taken)
  });
}

/** Rows of bars over one scale. entries: [{name, value, low, high, second, text}] */
function barRows(entries, low, high) {
  const node = el('div', {class: 'bars', 'data-chart': 'bars'});
  const x = (v) => 2 + (196 * (Math.min(Math.max(v, low), high) - low)) / (high - low);
  for (const e of entries) {
    const line = svg(
        'svg', {viewBox: '0 0 200 24', preserveAspectRatio: 'none', role: 'img', 'aria-label': e.name + ' ' + e.text});
    const rect = (a, b, y, h, c, extra) => svg('rect', {
      x: Math.min(x(a), x(b)),
      y,
      width: Math.max(Math.abs(x(b) - x(a)), 0.4),
      height: h,
      style: 'fill:var(--' + c + ')',
      ...extra
    });
    if (Number.isFinite(e.value))
      line.append(
          rect(0, e.value, 4, 16, e.value < 0 ? 'c1' : 'c0', e.second === undefined ? {} : {'fill-opacity': 0.35}));
    if (Number.isFinite(e.second)) line.append(rect(0, e.second, 8, 8, 'c0'));
    if (Number.isFinite(e.low) && Number.isFinite(e.high)) {
      line.append(svg('path', {
        d: 'M' + x(e.low) + ' 12H' + x(e.high) + 'M' + x(e.low) + ' 7V17M' + x(e.high) + ' 7V17',
        style: 'stroke:var(--ink);stroke-width:1.4;fill:none',
        'vector-effect': 'non-scaling-stroke'
      }));
    }
    line.append(
        svg('path', {d: 'M' + x(0) + ' 0V24', style: 'stroke:var(--soft)', 'vector-effect': 'non-scaling-stroke'}));
    node.append(el('span', {}, e.name), line, el('span', {class: 'number'}, e.text));
  }
  return node;
}

/** A bar for each row of a table, as long as the number in one of its columns. */
function drawBars(node, {of, inner, low, high, both_ways: signed, full}, {rows}) {
  const number = (row, column) => (column ? row[column].value ?? NaN : undefined);
  const entries = rows.map((row) => ({
                             name: row[0].text,
                             text: row[of].text,
                             value: signed ? number(row, of) : Math.abs(number(row, of)),
                             second: number(row, inner),
                             low: number(row, low),
                             high: number(row, high)
                           }));
  const longest = full || Math.max(...entries.map((e) => Math.abs(e.value) || 0), 1e-300);
  node.append(barRows(entries, signed ? -longest : 0, longest));
}

/** Tables, folded away below bars where these say as much. */
function drawTables(node, {tables, folded}) {
  const drawn = tables.map(({name, heads, rows}) => table(name, heads, rows));
  if (drawn.length) node.append(...(folded ? [el('details', {}, el('summary', {}, 'Numbers'), ...drawn)] : drawn));
}

/** A section of the page. */
function tell(section, hooks) {
  const node = card(capital(section.heading), section.note || null, section.wide ? 'wide' : 'half');
  for (const chart of section.charts) draw(node, chart);
  if (section.bars) drawBars(node, section.bars, section.tables[0]);
  for (const s of section.sentences) node.append(el('p', {}, ...phrase(s)));
  if (section.hook) node.append(hooks[section.hook]());
  drawTables(node, section);
}

/** Every section that the program has for this answer. hooks: by name, what a section has besides, as elements */
export function tellSections(hooks = {}) {
  for (const section of data.sections) tell(section, hooks);
}
