// SPDX-License-Identifier: Apache-2.0
// Designs by the thousand: scatter, heat map of two variables, parallel coordinates, filters, table.

import {rowNumber, rows, summary} from './data.js';
import {DesignView} from './design.js';
import {DesignsTable, filterBoxes} from './designs.js';
import {card, el} from './dom.js';
import {Filter} from './filter.js';
import {heatMap} from './heat.js';
import {parallelChart} from './parallel.js';
import {extent} from './ramp.js';
import {Scatter} from './scatter.js';
import {plain} from './words.js';

/** none: a word for no column, whose number is -1. */
function chooser(columns, at, label, change, none) {
  const node =
      el('select', {'aria-label': label, onchange: () => change(Number(node.value))},
         none ? el('option', {value: -1}, none) : null, columns.map((c, i) => el('option', {value: i}, plain(c.name))));
  node.value = at;
  return el('label', {}, label + ' ', node);
}

/** The design with the most of a metric, or with the most on this page where that one is not here, and a word on it. */
function firstDesign(name) {
  const top = summary.metrics[name]?.highest;
  if (!top) return {row: 0, note: ''};
  const near = Math.floor(top.row / rows.every);
  if (rowNumber(near) === top.row + 1) return {row: near, note: ''};
  const {values} = rows.columns.find((c) => c.name === name);
  return {
    row: values.indexOf(extent(values).high),
    note: ': the highest ' + plain(name) + ' on this page; that of all is design ' + (top.row + 1)
  };
}

/** The scatter with what is chosen across, up and as a colour, and the design pointed at beside it. */
function scatterCard(filter, view, side) {
  const metrics = Object.keys(summary.metrics).map((name) => rows.columns.findIndex((c) => c.name === name));
  const [x, y] = metrics.length > 1 ? metrics : [0, metrics[0]];
  const state = {x, y, colour: -1, log: {x: false, y: false}, near: false};
  const what = rows.densities ? 'The colours count designs. ' : 'Each point is a design. ';
  const note = what +
      'Drag to choose some; point at one, or step through them with the arrow keys, to see its curve. ' +
      'With two variables on the axes and a metric as colour it is a map.';
  const holder = el('div', {});
  const tools = el('div', {class: 'tools'});
  card('Designs', note, 'wide').append(el('div', {class: 'main-and-side'}, el('div', {}, tools, holder), side));
  const scatter = new Scatter(holder, filter, state, (i) => view.show(i));
  const choose = (key, label, none) => chooser(rows.columns, state[key], label, (k) => {
    state[key] = k;
    scatter.build();
  }, none);
  tools.append(choose('x', 'across', null), choose('y', 'up', null), choose('colour', 'colour', 'none'));
  const first = firstDesign(Object.keys(summary.metrics)[0]);
  view.show(first.row, first.note);
}

/** The hooks of a sweep: pictures of the designs, and below what is said of them the table. */
export function sweepHooks() {
  if (!rows.count || !summary.sampling) return {};
  const filter = new Filter(rows.columns, rows.count);
  const side = el('div', {});
  const view = new DesignView(side, rows.columns);
  const lines =
      'One line for each design. Drag along an axis to select an interval, click it to clear; Escape clears all.';
  const limits = 'Select the designs within these limits, in the units shown; all views show the selection.';
  return {
    designs: () => {
      heatCard(view);
      scatterCard(filter, view, side);
      parallelChart(card('All quantities', lines, 'wide'), rows.columns, filter, null);
      card('Filters', limits, 'half filters').append(filterBoxes(filter));
    },
    list: () => new DesignsTable(card('The designs', null, 'wide').appendChild(el('div', {})), filter, view)
  };
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
  const build = (k) => {
    holder.replaceChildren();
    heatMap(holder, variables[0], variables[1], metrics[k], (i) => view.show(i));
  };
  const first = Math.max(0, metrics.findIndex((m) => variables.every((v) => changesAt(v, m))));
  node.append(el('div', {class: 'tools'}, chooser(metrics, first, 'metric', build)), holder);
  build(first);
}
