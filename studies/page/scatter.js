// SPDX-License-Identifier: Apache-2.0
// Designs as points, or of very many as densities: axes and drag by uPlot, the rest drawn here.

import {drawMarks, keyStep, logRange, paddedRange, scaled} from './chart.js';
import {rows} from './data.js';
import {el, onTheme} from './dom.js';
import {figure, keepFocus, logButtons} from './figure.js';
import {along, countsOf, DensityLayer, PointLayer, shadeOf} from './points.js';
import {rampLegend} from './ramp.js';
import {displayUnit, largest} from './units.js';
import {axisLabel, plain, rampBar} from './words.js';

/**
 * What a drag over the plot chooses: an interval of the column across, and one of the column up if it is tall enough.
 */
function dragged(u, ix, iy, ux, uy) {
  const s = u.select;
  const across = [ix, u.posToVal(s.left, 'x') * ux.divisor, u.posToVal(s.left + s.width, 'x') * ux.divisor];
  const up = [iy, u.posToVal(s.top + s.height, 'y') * uy.divisor, u.posToVal(s.top, 'y') * uy.divisor];
  return s.height > 2 && s.height < u.over.clientHeight - 2 ? [across, up] : [across];
}

/** A scatter of two columns, coloured by a third (-1: none); drag chooses, hover and arrow keys tell. */
export class Scatter {
  /** state: {x, y, colour: columns, log: {x, y}, near: whether only what is chosen is in range} */
  constructor(node, filter, state, hover) {
    this.node = node;
    this.filter = filter;
    this.state = state;
    this.hover = hover;
    this.row = -1;
    const stale = () => {
      for (const layer of this.layers) layer.stale = true;
    };
    filter.onChange(() => {
      stale();
      this.plot.redraw(false);
    });
    onTheme(stale);
    this.build();
  }

  /** Column, values and range of an axis, in the unit shown. */
  side(key) {
    const {state, filter} = this;
    const column = filter.columns[state[key]];
    const unit = displayUnit(largest([column.values]), column.unit);
    const values = scaled(column.values, unit.divisor);
    const log = state.log[key];
    const kept = state.near ? values.filter((_, i) => filter.chosen[i]) : values;
    const counts = this.counts && !state.near ? this.counts[key].map((v) => v / unit.divisor) : [];
    const range = (log ? logRange : paddedRange)([kept, counts]);
    return {column, unit, values, log, label: axisLabel(column.name, unit), range};
  }

  /** Counts of all designs, where there are more of them than the page holds and nothing else is asked. */
  build() {
    const {state, filter, node} = this;
    this.counts = state.colour < 0 && !state.log.x && !state.log.y ? countsOf(state.x, state.y) : null;
    const [x, y] = [this.side('x'), this.side('y')];
    const shade = state.colour >= 0 ? shadeOf(filter.columns[state.colour]) : null;
    const points = new PointLayer(filter, x, y, shade, Boolean(this.counts));
    this.layers = this.counts ? [new DensityLayer(this.counts, x, y), points] : [points];
    node.replaceChildren();
    if (shade) node.append(rampBar(filter.columns[state.colour]));
    if (this.counts) node.append(rampLegend('designs', '1', String(this.counts.most)));
    this.plot = this.figure(x, y);
    if (rows.every > 1) node.append(el('p', {class: 'read'}, this.honest()));
  }

  /** What a picture of a part shows, and what it does not. */
  honest() {
    const held = 'the ' + rows.count + ' designs on this page, one in ' + rows.every + ' drawn at random';
    if (!this.counts) return 'Points: ' + held + '.';
    return 'The colours count all ' + rows.total + ' designs; selecting and pointing use ' + held + '.';
  }

  buttons(x, y) {
    const {state} = this;
    const change = (key, log) => {
      state.log[key] = log;
      keepFocus(this.node, 'log ' + key, () => this.build());
    };
    const near = () => {
      state.near = !state.near;
      keepFocus(this.node, 'Zoom to choice', () => this.build());
    };
    const zoom = el('button', {type: 'button', 'aria-pressed': String(state.near), onclick: near}, 'Zoom to choice');
    const positive = [x, y].every(({values}) => values.every((v) => !(v <= 0)));
    return [...(positive ? logButtons(state.log, change) : []), zoom];
  }

  figure(x, y) {
    const {state, filter} = this;
    return figure(this.node, x.range, [{name: y.column.name, y: y.range, colour: 'c0', hidden: true}], {
      name: 'scatter',
      title: plain(y.column.name) + ' over ' + plain(x.column.name),
      x,
      y,
      height: 400,
      points: false,
      buttons: this.buttons(x, y),
      front: (u) => {
        for (const layer of this.layers) layer.show(u);
        if (this.row >= 0) drawMarks(u, [{x: x.values[this.row], y: y.values[this.row], colour: 'c1'}]);
      },
      onSelect: (u) => {
        const intervals = dragged(u, state.x, state.y, x.unit, y.unit);
        u.setSelect({left: 0, top: 0, width: 0, height: 0}, false);
        filter.setAll(intervals);
      },
      onMove: (_, u) => {
        if (u.cursor.left < 0) return;
        const found = nearest(u, x, y, filter);
        if (found !== this.row) this.point(found, u);
      },
      onKey: (u, event) => this.key(u, event, x, y),
    });
  }

  point(i, u) {
    this.row = i;
    u.redraw(false);
    this.hover(i);
  }

  key(u, event, x, y) {
    const order = byValue(x.values, this.filter, y.values);
    const next = keyStep(event, order.indexOf(this.row), order.length);
    if (next !== null) this.point(order[next], u);
    if (event.key === 'Escape') this.filter.clear();
  }
}

/** Chosen rows that have a point, from left to right. */
function byValue(x, filter, y) {
  const list = [];
  for (let i = 0; i < filter.count; ++i)
    if (filter.chosen[i] && Number.isFinite(x[i]) && Number.isFinite(y[i])) list.push(i);
  return list.sort((a, b) => x[a] - x[b] || a - b);
}

/** The chosen row whose point is nearest to the cursor, within 24 pixels. */
function nearest(u, x, y, filter) {
  const [fx, fy] = [along(x), along(y)];
  const pixels = (f, {range}, size) => size / (f(range[1]) - f(range[0]));
  const [kx, ky] = [pixels(fx, x, u.over.clientWidth), pixels(fy, y, u.over.clientHeight)];
  const [cx, cy] = [fx(u.posToVal(u.cursor.left, 'x')), fy(u.posToVal(u.cursor.top, 'y'))];
  let best = 24 * 24;
  let found = -1;
  for (let i = 0; i < filter.count; ++i) {
    if (!filter.chosen[i]) continue;
    const d = ((fx(x.values[i]) - cx) * kx) ** 2 + ((fy(y.values[i]) - cy) * ky) ** 2;
    if (d < best) [best, found] = [d, i];
  }
  return found;
}
