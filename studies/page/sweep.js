// SPDX-License-Identifier: Apache-2.0
// Designs by the thousand: scatter, heat map of two variables, parallel coordinates, filters, table.

import {data, rowNumber, rows, summary} from './data.js';
import {DesignView} from './design.js';
import {DesignsTable, filterBoxes} from './designs.js';
import {card, el} from './dom.js';
import {Filter} from './filter.js';
import {heatMap} from './heat.js';
import {parallelChart} from './parallel.js';
import {extent} from './ramp.js';
import {Scatter} from './scatter.js';
import {columnAt} from './telling.js';
import {plain} from './words.js';

/** none: a word for no column, whose number is -1. */
function chooser(names, at, label, change, none) {
  const node =
      el('select', {'aria-label': label, onchange: () => change(Number(node.value))},
         none ? el('option', {value: -1}, none) : null, names.map((name, i) => el('option', {value: i}, name)));
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
function scatterHook(node, chart, filter, view, side) {
  const [x, y] = [chart.series[0].x, chart.series[0].y].map(columnAt);
  const state = {x, y, colour: -1, log: {x: false, y: false}, near: false};
  const what = rows.densities ? 'The colours count designs. ' : 'Each point is a design. ';
  const note = what +
      'Drag to choose some; point at one, or step through them with the arrow keys, to see its curve. ' +
      'With two variables on the axes and a metric as colour it is a map.';
  const holder = el('div', {});
  const tools = el('div', {class: 'tools'});
  node.append(el('p', {}, note), el('div', {class: 'main-and-side'}, el('div', {}, tools, holder), side));
  const scatter = new Scatter(holder, filter, state, (i) => view.show(i));
  const choose = (key, label, none) => chooser(rows.columns.map((c) => plain(c.name)), state[key], label, (k) => {
    state[key] = k;
    scatter.build();
  }, none);
  tools.append(choose('x', 'across', null), choose('y', 'up', null), choose('colour', 'colour', 'none'));
  const first = firstDesign(Object.keys(summary.metrics)[0]);
  view.show(first.row, first.note);
}

/** A map at a time. */
function mapHook(node, charts, view) {
  const holder = el('div', {});
  const build = (k) => {
    holder.replaceChildren();
    heatMap(holder, charts[k], (i) => view.show(i));
  };
  node.append(
      el('div', {class: 'tools'}, chooser(charts.map((c) => c.colours.name), 0, 'metric', build, null)), holder);
  build(0);
}

/** The hooks of a sweep: pictures of the designs, and below what is said of them the table. */
export function sweepHooks() {
  if (!data.row_curves) return {};
  const filter = new Filter(rows.columns, rows.count);
  const side = el('div', {});
  const view = new DesignView(side, rows.columns);
  const draws = (hook) => Object.assign(hook, {draws: true});
  return {
    map: draws((node, {charts}) => mapHook(node, charts, view)),
    designs: draws((node, {charts}) => scatterHook(node, charts[0], filter, view, side)),
    parallel: (node, {parallel}) => {
      node.append(el(
          'p', {},
          'One line for each design. Drag along an axis to select an interval, click it to clear; Escape clears all.'));
      parallelChart(node, parallel, filter, null);
    },
    filters: () => {
      const limits = 'Select the designs within these limits, in the units shown; all views show the selection.';
      card('Filters', limits, 'half filters').append(filterBoxes(filter));
    },
    list: () => new DesignsTable(card('The designs', null, 'wide').appendChild(el('div', {})), filter, view)
  };
}
