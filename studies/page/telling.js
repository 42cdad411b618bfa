// SPDX-License-Identifier: Apache-2.0
// Draws what the program says about an answer: sections of sentences, tables and charts. It decides nothing.

import {bandLegend, drawBands} from './bands.js';
import {drawSqueals, logRange, paddedRange, scaled} from './chart.js';
import {curves, data, rows, summary} from './data.js';
import {bold, bullets, card, colour, el, sentence, svg} from './dom.js';
import {figure, keepFocus} from './figure.js';
import {drawDotted, drawGuides, drawLevel, drawPath, drawShaded, hatch, nameLevels} from './guides.js';
import {drawLimits} from './limits.js';
import {table} from './table.js';
import {displayUnit, engineering, largest, percent} from './units.js';

/** A text, or texts and {b: text} for what stands out, as children of an element. */
function phrase(parts) {
  return typeof parts === 'string' ? [parts] : parts.map((p) => (typeof p === 'string' ? p : bold(p.b)));
}

/** The sentences and remarks of a headline or of a section. */
export function saidNodes({sentences, remarks}) {
  const lines = sentences.map((s) => sentence(...phrase(s)));
  return remarks.length ? [...lines, bullets(remarks.map(phrase))] : lines;
}

/** What stands at a path of keys, on which * stands for each of a list. */
function valueAt(value, keys) {
  if (!keys.length) return value;
  const further = (one) => valueAt(one, keys.slice(1));
  return keys[0] === '*' ? value.map(further) : further(value[keys[0]]);
}

/** The number of the column of the rows that numbers of a chart are; -1 if they are none. */
export function columnAt(where) { return rows.columns.findIndex((c) => where === 'rows/' + c.name); }

/** Numbers of a chart: a list, a column of the rows, or a path into summary.json or into the curves. */
export function numbersAt(where) {
  const column = columnAt(where);
  if (column >= 0) return rows.columns[column].values;
  const list = !where           ? [] :
      typeof where === 'string' ? valueAt({...summary, motors: curves}, where.split('/')) :
                                  where;
  return Float64Array.from(list, (v) => v ?? NaN);
}

/** The unit in which an axis is shown. */
function unitOfAxis(axis, lists) {
  return axis.unit === '%' ? {text: '%', divisor: 0.01} : displayUnit(largest(lists), axis.unit);
}

function rangeOf({low, high, zero}, unit, lists, log) {
  const [least, most] = log ? logRange(lists) : paddedRange(lists, zero);
  return [low === undefined ? least : low / unit.divisor, high === undefined ? most : high / unit.divisor];
}

/** How many points of a series stand at each place. */
function counted(x) {
  const counts = new Map();
  for (const v of x) counts.set(v, (counts.get(v) ?? 0) + 1);
  return counts;
}

/** The places of all series from left to right; one with several dots of a series is there as often. */
function gridOf(list) {
  const most = new Map();
  for (const {stroke, x} of list)
    for (const [v, n] of counted(x)) most.set(v, Math.max(most.get(v) ?? 0, stroke === 'dots' ? n : 1));
  const places = [...most.keys()].filter(Number.isFinite).sort((a, b) => a - b);
  return Float64Array.from(places.flatMap((v) => Array(most.get(v)).fill(v)));
}

function dotsOn(grid, {x, y}) {
  const at = new Map();
  x.forEach((v, i) => at.set(v, [...(at.get(v) ?? []), y[i]]));
  return Float64Array.from(grid, (v) => at.get(v)?.shift() ?? NaN);
}

/** Values between the points of a line, nothing beyond them: straight, or those of the last point. */
function lineOn(grid, {stroke, x, y}) {
  const order = [...x.keys()].sort((i, j) => x[i] - x[j]);
  const [from, to] = [x, y].map((values) => order.map((i) => values[i]));
  let i = 0;
  return Float64Array.from(grid, (v) => {
    if (!(v >= from[0] && v <= from[from.length - 1])) return NaN;
    while (i < from.length - 2 && from[i + 1] <= v) ++i;
    if (v === from[i + 1]) return to[i + 1];
    if (stroke === 'steps' || v === from[i]) return to[i];
    return to[i] + ((v - from[i]) / (from[i + 1] - from[i])) * (to[i + 1] - to[i]);
  });
}

/** The values of a series at the places of its chart. */
function onGrid(grid, series) {
  const {stroke, y} = series;
  if (stroke === 'bars') return Float64Array.from(grid, (_, i) => (y[i] > 0 ? y[i] : NaN));
  if (stroke === 'outline') return Float64Array.from(grid, (_, i) => y[i] ?? 0);
  return stroke === 'dots' ? dotsOn(grid, series) : lineOn(grid, series);
}

const looks = {
  dashes: {dash: [3, 4]},
  dots: {scatter: true},
  steps: {steps: true},
  outline: {steps: true, dash: [5, 4]},
  bars: {bars: true}
};
const signs = {
  dashes: 'dash',
  dots: 'dot',
  outline: 'dash',
  bars: 'area',
  stack: 'area'
};

/** Entries of the key, each name once. */
function legendOf(series, {guides, shaded}) {
  const list = series.flatMap(
      (s) =>
          [{name: s.name, colour: s.colour, kind: signs[s.stroke] ?? ''},
           ...(s.low ? [{name: s.band, colour: s.colour, kind: 'area'}] : [])]);
  const of = series.length > 1 ? 'soft' : 'c0';
  list.push(...series.map((s) => ({name: s.state, colour: of, kind: 'broad'})));
  if (guides.some((g) => g.kind === 'limit')) list.push({name: 'limit', colour: 'c1', kind: ''});
  if (guides.some((g) => g.kind === 'quantile' && g.text)) list.push({name: 'quantile', colour: 'ink', kind: 'dash'});
  list.push(...shaded.map(({name}) => ({name, colour: 'faint', kind: 'area'})));
  return list.filter((e, i) => e.name && list.findIndex((o) => o.name === e.name) === i);
}

/** Two ranges about their middles, as long as the longer one. */
function alike(ranges) {
  const half = Math.max(...ranges.map(([low, high]) => (high - low) / 2));
  return ranges.map(([low, high]) => [(low + high) / 2 - half, (low + high) / 2 + half]);
}

/** The numbers of a chart, SI. */
export function seriesOfChart(chart) {
  return chart.series.map((s) => ({
                            ...s,
                            x: numbersAt(s.x),
                            y: numbersAt(s.y),
                            low: s.low && numbersAt(s.low),
                            high: s.high && numbersAt(s.high)
                          }));
}

/** Parts of a whole on top of each other, each up to its upper edge; nothing where one is negative. */
function stackedUp(list) {
  const sums = new Float64Array(list.length ? list[0].y.length : 0);
  return list.map((s) => {
    if (s.stroke !== 'stack') return s;
    s.y.forEach((v, i) => {
      sums[i] += v >= 0 ? v : NaN;
    });
    return {...s, part: s.y, y: sums.slice()};
  });
}

/** Lines with the edges of their bands behind all of them, in the units shown. */
function drawnSeries(list, grid, divisor) {
  const isFirst = (s, k) => s.stroke === 'stack' && list[k - 1]?.stroke !== 'stack';
  const lines = list.map(
      (s, k) => ({name: s.name, colour: s.colour, ...looks[s.stroke], area: isFirst(s, k), y: onGrid(grid, s)}));
  const banded = list.filter((s) => s.low);
  const edges = banded.flatMap(
      (s) => [s.low, s.high].map((y) => ({name: s.band, colour: s.colour, hidden: true, y: onGrid(grid, {...s, y})})));
  const fill = (s) => () => colour(s.colour) + '40';
  const bands = banded.map((s, i) => ({series: [lines.length + 2 * i + 2, lines.length + 2 * i + 1], fill: fill(s)}));
  list.forEach((s, k) => {
    if (s.stroke === 'stack' && !isFirst(s, k)) bands.push({series: [k + 1, k], fill: () => colour(s.colour) + 'aa'});
  });
  return {series: [...lines, ...edges].map((s) => ({...s, y: scaled(s.y, divisor)})), lines: lines.length, bands};
}

function shownValue(value, unit) { return unit === '%' ? percent(value, 4) : engineering(value, unit); }

/** What the cursor reads: the bin, or the values of all series there. */
function readingOf(chart, grid, list, shown, divisors, i) {
  const {x, y} = chart;
  const bars = list.filter((s) => s.stroke === 'bars');
  if (bars.length)
    return i + 1 >= grid.length ? [] : [
      ['between', shownValue(grid[i], x.unit) + ' and ' + shownValue(grid[i + 1], x.unit)],
      [y.name, shownValue(bars.reduce((sum, s) => sum + s.y[i], 0), y.unit)]
    ];
  const own = (s, k) => (s.part ? onGrid(grid, {...s, y: s.part})[i] : shown[k].y[i] * divisors.y);
  const values = list.map((s, k) => [s.name || y.name, own(s, k)]).filter(([, v]) => !Number.isNaN(v));
  return [[x.name, shownValue(grid[i], x.unit)], ...values.map(([name, v]) => [name, shownValue(v, y.unit)])];
}

/**
 * Draws a chart; its plot.
 * more: further options of figure(), and log: {x, y}, which axes are logarithmic
 */
export function draw(node, given, more = {}) {
  if (given.asked) return drawAsked(node, given, more);
  const chart = {guides: [], marks: [], bounds: [], shaded: [], ...given};
  const all = stackedUp(seriesOfChart(chart));
  const isPath = ({stroke}) => stroke === 'path' || stroke === 'contour';
  const [paths, list] = [all.filter(isPath), all.filter((s) => !isPath(s))];
  const grid = gridOf(list);
  const [across, up] = [unitOfAxis(chart.x, all.map((s) => s.x)), unitOfAxis(chart.y, all.map((s) => s.y))];
  const lines = paths.map((s) => ({...s, x: scaled(s.x, across.divisor), y: scaled(s.y, up.divisor)}));
  const {series, lines: count, bands} = drawnSeries(list, grid, up.divisor);
  const x = scaled(grid, across.divisor);
  const marks = chart.marks.map((m) => ({...m, x: m.x / across.divisor, y: m.y / up.divisor, small: !m.text}));
  const shaded = chart.shaded.map((s) => ({from: s.from / across.divisor, to: s.to / across.divisor}));
  const bounds = chart.bounds.map((b) => ({...b, x: b.x / across.divisor, y: b.y / up.divisor}));
  const log = more.log ?? {};
  let ranges = [
    rangeOf(chart.x, across, [x, ...lines.map((s) => s.x)], log.x),
    rangeOf(
        chart.y, up,
        [...series.map((s) => s.y), ...lines.map((s) => s.y), Float64Array.from([...marks, ...bounds].map((m) => m.y))],
        log.y)
  ];
  if (chart.round) ranges = alike(ranges);
  const label = (axis, unit) => axis.name + (unit.text ? ' [' + unit.text + ']' : '');
  const legend = legendOf(all, chart);
  const guides = chart.guides.filter((g) => g.kind !== 'level').map((g) => ({...g, at: g.at / across.divisor}));
  const levels = chart.guides.filter((g) => g.kind === 'level').map((g) => ({...g, at: g.at / up.divisor}));
  const divisors = {x: across.divisor, y: up.divisor};
  if (chart.field) node.append(bandLegend(chart.field));
  return figure(chart.round ? node.appendChild(el('div', {class: 'round'})) : node, x, series, {
    name: chart.name,
    title: chart.title,
    legend: legend.length ? legend : undefined,
    x: {label: label(chart.x, across), range: ranges[0], log: log.x},
    y: {label: label(chart.y, up), range: ranges[1], log: log.y},
    marks,
    bands,
    tell: (i) => readingOf(chart, grid, list, series.slice(0, count), divisors, i),
    ...more,
    height: chart.round ? 380 : more.height,
    ground: (u) => {
      if (chart.field) drawBands(u, chart.field, divisors);
      drawShaded(u, shaded);
      drawDotted(u, marks);
      levels.forEach((g) => drawLevel(u, g.at));
      if (chart.least !== undefined) hatch(u, ranges[0][0], chart.least / across.divisor);
      if (chart.most !== undefined) hatch(u, chart.most / across.divisor, ranges[0][1]);
      lines.forEach((s) => drawPath(u, s));
      drawSqueals(u, list.map((s) => s.broad ?? []));
    },
    front: (u, taken) => {
      drawGuides(u, guides, taken);
      nameLevels(u, levels, taken);
      drawLimits(u, bounds, taken);
      more.front?.(u, taken);
    }
  });
}

/** A chart with a button that adds the series that are drawn when asked for. */
function drawAsked(node, chart, more) {
  const holder = node.appendChild(el('div', {}));
  const {asked: text, more: further, ...plain} = chart;
  const show = (on) => {
    const press = () => keepFocus(holder, text, () => show(!on));
    const button = el('button', {type: 'button', 'aria-pressed': String(on), onclick: press}, text);
    holder.replaceChildren();
    const series = on ? [...chart.series, ...further] : chart.series;
    return draw(holder, {...plain, series}, {...more, buttons: [...(more.buttons ?? []), button]});
  };
  return show(false);
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
  const number = (row, column) => (column ? row[column][1] ?? NaN : undefined);
  const entries = rows.map((row) => ({
                             name: typeof row[0] === 'string' ? row[0] : row[0][0],
                             text: row[of][0],
                             value: signed ? number(row, of) : Math.abs(number(row, of)),
                             second: number(row, inner),
                             low: number(row, low),
                             high: number(row, high)
                           }));
  const longest = full || Math.max(...entries.map((e) => Math.abs(e.value) || 0), 1e-300);
  node.append(barRows(entries, signed ? -longest : 0, longest));
}

/** A cell of the program: words, [words, name], [number as text, number], or [words, words, tone]. */
function toldCell(cell) {
  if (typeof cell === 'string') return {text: cell, value: cell, words: true};
  const [text, value, tone] = cell;
  return {text, value, words: typeof value === 'string', look: tone && tone + '-word'};
}

/** Cells that are the darker, the nearer their numbers are to 1 or -1. */
function shade(node) {
  for (const cell of node.querySelectorAll('td[data-value]')) {
    const value = Number(cell.dataset.value);
    cell.style.background = 'color-mix(in srgb, var(--' + (value < 0 ? 'c1' : 'c0') + ') ' +
        Math.round(60 * Math.abs(value)) + '%, transparent)';
  }
}

/** A table with its file in SI units. */
export function toldTable({name, heads, rows, units, shaded}) {
  const saved = heads.map((head, i) => head + (units[i] ? ' [' + units[i] + ']' : ''));
  const node = table(name, heads, rows.map((row) => row.map(toldCell)), saved);
  if (shaded) shade(node);
  return node;
}

/** Tables, folded away below bars where these say as much. */
function drawTables(node, {tables, folded}) {
  const drawn = tables.map(toldTable);
  if (drawn.length) node.append(...(folded ? [el('details', {}, el('summary', {}, 'Numbers'), ...drawn)] : drawn));
}

/** The charts of a section; several stand beside each other. */
function drawCharts(node, {charts, columns, wide}) {
  const several = charts.length > 1;
  const holder = several ? node.appendChild(el('div', {class: 'charts'})) : node;
  if (columns) {
    // On a narrow screen a matrix moves under its frame.
    holder.style.gridTemplateColumns = 'repeat(' + columns + ', minmax(190px, 1fr))';
    holder.style.overflowX = 'auto';
  }
  const height = columns ? 170 : wide && !several ? 300 : 240;
  for (const chart of charts) {
    const place = several ? holder.appendChild(el('div', {})) : node;
    if (chart) draw(place, chart, {height});
  }
}

/** Makes the card of a section of the page; what fills it. */
function tell(section, hooks) {
  const hook = hooks[section.hook];
  if (!section.heading) {
    hook();
    return () => {};
  }
  const node = card(section.heading, section.note.length ? phrase(section.note) : null, section.wide ? 'wide' : 'half');
  return () => {
    if (!hook?.draws) drawCharts(node, section);
    if (section.bars) drawBars(node, section.bars, section.tables[0]);
    node.append(...saidNodes(section));
    drawTables(node, section);
    hook?.(node, section);
  };
}

/** When what is there can be seen. */
function seen() {
  return new Promise((done) => (document.hidden ? setTimeout(done) : requestAnimationFrame(() => setTimeout(done))));
}

/**
 * Every section that the program has for this answer: at once their cards, and what is in them up to the first picture;
 * the others once this can be seen. hooks: by name, what a section has besides
 */
export async function tellSections(hooks) {
  const fill = data.sections.map((section) => tell(section, hooks));
  const first = data.sections.findIndex(({charts, bars}) => charts.length || bars);
  for (const work of fill.splice(0, first + 1)) work();
  await seen();
  for (const work of fill) work();
}
