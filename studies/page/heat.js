// SPDX-License-Identifier: Apache-2.0
// A colour map of a metric over a grid of two variables.

import {colour} from './dom.js';
import {figure} from './figure.js';
import {extent, rampColour} from './ramp.js';
import {numbersAt} from './telling.js';
import {displayUnit, engineering, largest} from './units.js';
import {axisLabel, rampBar} from './words.js';

/** One side of a grid: the values of a column in order, and the edges of their cells in the unit shown. */
class GridAxis {
  constructor(column) {
    this.unit = displayUnit(largest([column.values]), column.unit);
    this.values = [...new Set(column.values)].sort((a, b) => a - b);
    const v = this.values;
    const last = v.length - 1;
    this.edges = [
      v[0] - (v[1] - v[0]) / 2, ...v.slice(1).map((w, i) => (w + v[i]) / 2), v[last] + (v[last] - v[last - 1]) / 2
    ].map((e) => e / this.unit.divisor);
    this.range = [this.edges[0], this.edges[last + 1]];
    this.label = axisLabel(column.name, this.unit);
  }

  /** The cell at a place in the unit shown; the nearest beyond the ends. */
  at(place) {
    let i = 0;
    while (i < this.values.length - 1 && this.edges[i + 1] <= place) ++i;
    return i;
  }

  inside(i) { return Math.min(Math.max(i, 0), this.values.length - 1); }
}

/** Cells of a grid of two columns, each with the row that is there. */
class Grid {
  constructor(cx, cy) {
    this.x = new GridAxis(cx);
    this.y = new GridAxis(cy);
    const places = [this.x, this.y].map((side) => new Map(side.values.map((v, i) => [v, i])));
    this.cells =
        new Map(Array.from(cx.values, (v, row) => [this.key(places[0].get(v), places[1].get(cy.values[row])), row]));
  }

  key(a, b) { return a * this.y.values.length + b; }
  row(a, b) { return this.cells.get(this.key(a, b)); }

  /** Left, top, width and height of a cell on the canvas. */
  box(u, a, b) {
    const [x0, x1] = [0, 1].map((k) => u.valToPos(this.x.edges[a + k], 'x', true));
    const [y0, y1] = [0, 1].map((k) => u.valToPos(this.y.edges[b + k], 'y', true));
    return [x0, y1, x1 - x0, y0 - y1];
  }

  paint(u, colourOf) {
    for (const [key, row] of this.cells) {
      const [left, top, width, height] =
          this.box(u, Math.floor(key / this.y.values.length), key % this.y.values.length);
      u.ctx.fillStyle = colourOf(row);
      u.ctx.fillRect(left, top, Math.ceil(width) + 0.5, Math.ceil(height) + 0.5);
    }
  }

  mark(u, a, b) {
    u.ctx.strokeStyle = colour('c1');
    u.ctx.lineWidth = 3 * devicePixelRatio;
    u.ctx.strokeRect(...this.box(u, a, b));
  }
}

const arrows = {
  ArrowLeft: [-1, 0],
  ArrowRight: [1, 0],
  ArrowDown: [0, -1],
  ArrowUp: [0, 1]
};

/** The map of a chart of cells; the cell that is pointed at or stepped to is marked and read out. */
export function heatMap(node, chart, hover) {
  const [{x, y, z}] = chart.series;
  const [cx, cy, cz] = [[chart.x, x], [chart.y, y], [chart.colours, z]].map(
      ([{name, unit}, where]) => ({name, unit, values: numbersAt(where)}));
  const grid = new Grid(cx, cy);
  const {share} = extent(cz.values);
  const shade = (row) => (Number.isFinite(cz.values[row]) ? rampColour(share(cz.values[row])) : colour('faint'));
  let place = null;
  const show = (a, b, u) => {
    const row = grid.row(a, b);
    if (row === undefined) return;
    place = [a, b];
    hover(row);
    u.redraw(false);
  };
  const told = (row) => [cx, cy, cz].map((c) => [c.name, engineering(c.values[row], c.unit)]);
  const onMove = (_, u) => {
    if (u.cursor.left < 0) return;
    const [a, b] = [grid.x.at(u.posToVal(u.cursor.left, 'x')), grid.y.at(u.posToVal(u.cursor.top, 'y'))];
    if (!place || a !== place[0] || b !== place[1]) show(a, b, u);
  };
  const onKey = (u, event) => {
    const step = arrows[event.key];
    if (!step) return;
    event.preventDefault();
    if (place)
      show(grid.x.inside(place[0] + step[0]), grid.y.inside(place[1] + step[1]), u);
    else
      show(0, 0, u);
  };
  node.append(rampBar(cz));
  return figure(node, grid.x.range, [{name: cz.name, y: grid.y.range, colour: 'c0', hidden: true}], {
    name: 'heat',
    title: chart.title,
    x: {label: grid.x.label, range: grid.x.range},
    y: {label: grid.y.label, range: grid.y.range},
    height: 400,
    points: false,
    front: (u) => {
      grid.paint(u, shade);
      if (place) grid.mark(u, ...place);
    },
    tellAlways: () => (place ? told(grid.row(...place)) : []),
    onMove,
    onKey
  });
}
