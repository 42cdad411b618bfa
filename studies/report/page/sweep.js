// SPDX-License-Identifier: Apache-2.0
'use strict';
// Designs by the thousand: scatter, heat map of two variables, parallel coordinates, filters, table.

function smallCurves() {
  const c = data.row_curves;
  return { every: c.every, points: c.points, speed: numbers(c.speed, Float32Array), torque: numbers(c.torque, Float32Array), shape: numbers(c.shape, Uint16Array) };
}

/** What one design is, with its curve. */
class DesignView {
  constructor(node, columns) {
    this.columns = columns;
    this.curves = smallCurves();
    this.body = el('div', { 'data-design': '' }, el('p', {}, 'Point at a design.'));
    this.plotNode = el('div', {});
    node.append(this.body, this.plotNode);
  }

  /** note: what else to say of it. */
  show(i, note = '') {
    if (i < 0) return;
    const lines = this.columns.map((c) => el('tr', {}, el('td', { title: describe(c.name) }, plain(c.name)), el('td', {}, engineering(c.values[i], c.unit))));
    const status = rows.statuses[rows.status[i]];
    this.body.replaceChildren(el('p', {}, 'Design ' + rowNumber(i) + (status === 'ok' ? '' : ': ' + status) + note), el('table', {}, el('tbody', {}, lines)));
    const explore = designerButton(Object.fromEntries(this.columns.map((c) => [c.name, c.values[i]])), 'design ' + rowNumber(i));
    if (explore) this.body.append(explore);
    this.curve(i);
  }

  curve(i) {
    const c = this.curves;
    const at = Math.floor(i / c.every);
    const near = i % c.every === 0;
    this.plotNode.replaceChildren();
    if (!near) { this.plotNode.append(el('p', { class: 'read' }, 'The page has curves of one design in ' + c.every * rows.every + '.')); return; }
    if (!Number.isFinite(c.speed[at])) { this.plotNode.append(el('p', { class: 'read' }, 'This design has no torque-speed curve.')); return; }
    const unit = displayUnit(c.torque[at], 'N.m');
    const x = Float64Array.from({ length: c.points }, (_, k) => (c.speed[at] * k) / (c.points - 1) / (Math.PI / 30));
    const y = Float64Array.from({ length: c.points }, (_, k) => ((c.shape[at * c.points + k] / 65535) * c.torque[at]) / unit.divisor);
    const width = Math.max(this.plotNode.clientWidth, 200);
    const pad = 46;
    const h = 170;
    const px = (v) => pad + (v / x[x.length - 1]) * (width - pad - 14);
    const top = 1.08 * Math.max(...y);
    const py = (v) => h - 36 - (v / top) * (h - 50);
    const path = Array.from(x, (v, k) => (k ? 'L' : 'M') + px(v).toFixed(1) + ' ' + py(y[k]).toFixed(1)).join('');
    const word = (text, attributes) => { const t = svg('text', { 'font-size': 12, fill: 'currentColor', ...attributes }); t.append(text); return t; };
    this.plotNode.append(svg('svg', { width, height: h, role: 'img', 'aria-label': 'torque-speed curve of this design' },
      svg('path', { d: 'M' + pad + ' 8V' + py(0) + 'H' + (width - 14), fill: 'none', stroke: 'currentColor', 'stroke-opacity': 0.4 }),
      svg('path', { d: path, fill: 'none', stroke: colour('c0'), 'stroke-width': 2 }),
      word(rounded(y[0], 3) + ' ' + unit.text, { x: pad + 6, y: py(y[0]) - 6 }),
      word('torque [' + unit.text + ']', { transform: 'rotate(-90)', x: -(h - 36) / 2, y: 14, 'text-anchor': 'middle' }),
      word(rounded(x[x.length - 1], 4) + ' rpm', { x: width - 14, y: h - 22, 'text-anchor': 'end' }),
      word('speed [rpm]', { x: (pad + width) / 2, y: h - 4, 'text-anchor': 'middle' })));
  }
}

/** Limits typed by hand: two boxes for each column. */
function filterBoxes(filter) {
  const units = filter.columns.map((c) => displayUnit(largest([c.values]), c.unit));
  const inputs = [];
  const lines = filter.columns.map((c, k) => {
    const box = (side) => {
      const node = el('input', { class: 'limit', inputmode: 'decimal', 'aria-label': side + ' ' + plain(c.name), placeholder: side });
      node.addEventListener('change', () => {
        const [low, high] = inputs[k].map((n) => { const v = n.value.trim() === '' ? null : Number(n.value.replace(',', '.')); return v === null || Number.isNaN(v) ? null : v * units[k].divisor; });
        filter.set(k, low, high);
      });
      return node;
    };
    inputs[k] = [box('least'), box('most')];
    return el('tr', {}, el('td', {}, axisLabel(c.name, units[k])), el('td', {}, inputs[k][0]), el('td', {}, inputs[k][1]));
  });
  filter.onChange(() => inputs.forEach((pair, k) => {
    const interval = filter.intervals.get(k) || [-Infinity, Infinity];
    pair.forEach((n, s) => { if (document.activeElement !== n) n.value = Number.isFinite(interval[s]) ? rounded(interval[s] / units[k].divisor) : ''; });
  }));
  const count = el('p', { class: 'read', 'aria-live': 'polite', 'data-count': '' });
  const tell = () => { count.replaceChildren(el('b', {}, String(filter.total)), ' of ' + filter.count + ' designs' + (rows.every > 1 ? ' on this page' : '')); };
  filter.onChange(tell);
  tell();
  return el('div', {}, count, el('table', {}, el('tbody', {}, lines)), el('div', { class: 'tools' }, el('button', { type: 'button', onclick: () => filter.clear() }, 'Show all')));
}

/** The chosen designs, sorted by a column: 100 of them to read, all that the page holds in the file to save. */
function designsTable(filter, view) {
  const node = el('div', {});
  const order = { column: 0, down: false };
  const sorted = () => {
    const list = [];
    for (let i = 0; i < filter.count; ++i) if (filter.chosen[i]) list.push(i);
    const values = filter.columns[order.column].values;
    const last = order.down ? -Infinity : Infinity;
    const keys = Float64Array.from(values, (v) => (Number.isFinite(v) ? v : last));
    return list.sort(order.down ? (a, b) => keys[b] - keys[a] || a - b : (a, b) => keys[a] - keys[b] || a - b);
  };
  const build = () => {
    const list = sorted();
    const head = filter.columns.map((c, k) => el('th', { scope: 'col', 'aria-sort': k === order.column ? (order.down ? 'descending' : 'ascending') : 'none' },
      el('button', { type: 'button', onclick: () => { order.down = order.column === k ? !order.down : false; order.column = k; build(); } }, plain(c.name) + (k === order.column ? (order.down ? ' ▼' : ' ▲') : ''))));
    const body = list.slice(0, 100).map((i) => el('tr', { onmouseenter: () => view.show(i) }, el('td', {}, String(rowNumber(i))), filter.columns.map((c) => el('td', { 'data-value': c.values[i] }, engineering(c.values[i], c.unit))), el('td', { class: 'words' }, rows.statuses[rows.status[i]])));
    node.replaceChildren(el('p', { class: 'read' }, (list.length > 100 ? 'The first 100 of ' + list.length + (rows.every > 1 ? ' on this page' : '') + '; saved as CSV, all of these.' : list.length + ' designs.') + (rows.every > 1 ? ' results.csv has every design.' : '')),
      el('div', { class: 'scroll', tabindex: '0', role: 'region', 'aria-label': 'designs' }, el('table', { 'data-table': 'designs' }, el('thead', {}, el('tr', {}, el('th', { scope: 'col' }, 'design'), head, el('th', { class: 'words' }, 'status'))), el('tbody', {}, body))),
      saveButton('designs', () => csvText(['design', ...filter.columns.map((c) => c.name + ' [' + c.unit + ']'), 'status'], sorted().map((i) => [rowNumber(i), ...filter.columns.map((c) => c.values[i]), rows.statuses[rows.status[i]]]))));
  };
  let due = 0;
  filter.onChange(() => { clearTimeout(due); due = setTimeout(build, 30); });
  build();
  return node;
}

/** none: a word for no column, whose number is -1. */
function chooser(columns, at, label, change, none) {
  const node = el('select', { 'aria-label': label, onchange: () => change(Number(node.value)) }, none ? el('option', { value: -1 }, none) : null, columns.map((c, i) => el('option', { value: i }, plain(c.name))));
  node.value = at;
  return el('label', {}, label + ' ', node);
}

function spreadTable() {
  const names = Object.keys(summary.metrics);
  return table('spread', ['metric', 'lowest', 'median', 'highest', 'designs'], names.map((n) => { const m = summary.metrics[n]; const u = unitOf(n); return [named(n), quantity(m.min, u), quantity(m.median, u), quantity(m.max, u), { text: String(m.count), value: m.count }]; }), ['metric', 'lowest [SI]', 'median [SI]', 'highest [SI]', 'designs']);
}

/** The design with the most of a metric, or with the most on this page where that one is not here, and a word on it. */
function firstDesign(name) {
  const top = summary.metrics[name]?.highest;
  if (!top) return { row: 0, note: '' };
  const near = Math.floor(top.row / rows.every);
  if (rowNumber(near) === top.row + 1) return { row: near, note: '' };
  const { values } = rows.columns.find((c) => c.name === name);
  return { row: values.indexOf(extent(values).high), note: ': the highest ' + plain(name) + ' on this page; that of all is design ' + (top.row + 1) };
}

function sweepPage() {
  if (!rows.count) return;
  const filter = new Filter(rows.columns, rows.count);
  const metricNames = Object.keys(summary.metrics);
  const firstMetric = rows.columns.findIndex((c) => c.name === metricNames[0]);
  const secondMetric = rows.columns.findIndex((c) => c.name === metricNames[1]);
  const state = { x: secondMetric >= 0 ? firstMetric : 0, y: secondMetric >= 0 ? secondMetric : firstMetric, colour: -1 };
  const scatterCard = card('Designs', 'Each point is a design. Drag to choose some; point at one, or step through them with the arrow keys, to see its curve. Two variables and the colour of a metric make a map.', 'wide');
  const left = el('div', {});
  const right = el('div', {});
  const tools = el('div', { class: 'tools' });
  const holder = el('div', {});
  left.append(tools, holder);
  scatterCard.append(el('div', { class: 'pair' }, left, right));
  const view = new DesignView(right, rows.columns);
  const build = () => {
    holder.replaceChildren();
    state.plot = scatterChart(holder, filter, state.x, state.y, state.colour, (i) => view.show(i));
  };
  const first = firstDesign(metricNames[0]);
  view.show(first.row, first.note);
  filter.onChange(() => state.plot.redraw(false));
  tools.append(chooser(rows.columns, state.x, 'across', (k) => { state.x = k; build(); }), chooser(rows.columns, state.y, 'up', (k) => { state.y = k; build(); }), chooser(rows.columns, -1, 'colour', (k) => { state.colour = k; build(); }, 'none'));
  build();
  heatCard(view);
  const parallelCard = card('Every quantity at once', 'One line for each design. Drag along an axis to keep an interval; click the axis to free it; Escape frees all.', 'wide');
  parallelChart(parallelCard, rows.columns, filter, null);
  card('Filters', 'Keep the designs within these limits, in the units shown; every view follows.', 'half filters').append(filterBoxes(filter));
  card('Spread of the metrics', null, 'half').append(spreadTable());
  card('The designs', null, 'wide').append(designsTable(filter, view));
}

/** True if the metric changes where this variable is held. */
function changesAt(held, metric) {
  const seen = new Map();
  for (let i = 0; i < rows.count; ++i) {
    const before = seen.get(held.values[i]);
    if (before !== undefined && Math.abs(metric.values[i] - before) > 1e-9 * Math.abs(before)) return true;
    seen.set(held.values[i], metric.values[i]);
  }
  return false;
}

function heatCard(view) {
  const metricNames = Object.keys(summary.metrics);
  const variables = rows.columns.filter((c) => !metricNames.includes(c.name));
  if (summary.sampling !== 'grid' || variables.length !== 2) return;
  const levels = variables.map((c) => new Set(c.values).size);
  if (Math.min(...levels) < 2 || levels[0] * levels[1] !== rows.count) return;
  const node = card('Map', 'The metric over the two variables.', 'wide');
  const holder = el('div', {});
  const metrics = rows.columns.filter((c) => metricNames.includes(c.name));
  const build = (k) => { holder.replaceChildren(); heatMap(holder, variables[0], variables[1], metrics[k], (i) => view.show(i)); };
  const first = Math.max(0, metrics.findIndex((m) => variables.every((v) => changesAt(v, m))));
  node.append(el('div', { class: 'tools' }, chooser(metrics, first, 'metric', build)), holder);
  build(first);
}
