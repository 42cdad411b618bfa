// SPDX-License-Identifier: Apache-2.0
'use strict';
// All designs as points: axes and drag by uPlot, points drawn here, since there may be 100000 of them.

/** Ten colours from dark blue to yellow that keep their order in grey and for every colour vision. */
const ramp = [[0, 32, 77], [0, 52, 110], [54, 73, 108], [87, 92, 109], [112, 113, 115], [138, 134, 120], [166, 157, 117], [197, 180, 106], [228, 206, 87], [255, 234, 70]];

/** The end of the ramp that is near the ground of the page is left out. */
function rampColour(share) {
  const inside = Math.min(Math.max(share, 0), 1);
  const place = (isDark() ? 0.2 + 0.8 * inside : 0.93 * inside) * (ramp.length - 1);
  const i = Math.min(Math.floor(place), ramp.length - 2);
  return '#' + ramp[i].map((v, k) => Math.round(v + (ramp[i + 1][k] - v) * (place - i)).toString(16).padStart(2, '0')).join('');
}

/** Smallest and largest value, and a value's place between them. */
function extent(values) {
  let [low, high] = [Infinity, -Infinity];
  for (const v of values) if (Number.isFinite(v)) { if (v < low) low = v; if (v > high) high = v; }
  return { low, high, share: (v) => (high > low ? (v - low) / (high - low) : 0.5) };
}

/** What the colours of a column mean. */
function rampBar(column) {
  const { low, high } = extent(column.values);
  const strip = svg('svg', { width: 160, height: 12, 'aria-hidden': 'true' });
  const paint = () => strip.replaceChildren(...Array.from({ length: 40 }, (_, i) => svg('rect', { x: 4 * i, y: 0, width: 4.5, height: 12, fill: rampColour(i / 39) })));
  paint();
  onTheme(paint);
  return el('div', { class: 'legend' }, el('span', {}, plain(column.name)), el('span', {}, engineering(low, column.unit, 3)), strip, el('span', {}, engineering(high, column.unit, 3)));
}

/** The points of a scatter, kept as a picture: a hover then costs a copy, not 100000 squares. */
class PointLayer {
  /** shade: colour of a chosen row as one pixel, or null for one colour. */
  constructor(filter, x, y, rx, ry, shade) {
    this.filter = filter;
    this.x = x;
    this.y = y;
    this.rx = rx;
    this.ry = ry;
    this.shade = shade;
    this.canvas = el('canvas', {});
    this.stale = true;
  }

  show(u) {
    const { left, top, width, height } = u.bbox;
    if (this.stale || this.canvas.width !== Math.round(width) || this.canvas.height !== Math.round(height)) this.paint(Math.round(width), Math.round(height));
    u.ctx.drawImage(this.canvas, left, top);
  }

  paint(width, height) {
    this.canvas.width = width;
    this.canvas.height = height;
    const ctx = this.canvas.getContext('2d');
    const count = this.filter.count;
    const side = Math.round((count > 20000 ? 2 : count > 2000 ? 3 : count > 200 ? 5 : 8) * devicePixelRatio);
    const image = ctx.createImageData(width, height);
    const pixels = new Uint32Array(image.data.buffer);
    const kx = width / (this.rx[1] - this.rx[0]);
    const ky = height / (this.ry[1] - this.ry[0]);
    for (const pass of this.filter.intervals.size ? [0, 1] : [1]) {
      const plainPaint = packed(colour(pass ? 'c0' : 'faint'));
      const shade = pass && this.shade ? this.shade() : null;
      for (let i = 0; i < count; ++i) {
        if (this.filter.chosen[i] !== pass) continue;
        const px = Math.round((this.x[i] - this.rx[0]) * kx - side / 2);
        const py = Math.round(height - (this.y[i] - this.ry[0]) * ky - side / 2);
        if (!(px >= 0 && py >= 0 && px + side <= width && py + side <= height)) continue;
        const paint = shade ? shade(i) : plainPaint;
        for (let r = py; r < py + side; ++r) pixels.fill(paint, r * width + px, r * width + px + side);
      }
    }
    ctx.putImageData(image, 0, 0);
    this.stale = false;
  }
}

/** A colour such as #0072b2 as one pixel, little-endian RGBA. */
function packed(hex) {
  const value = parseInt(hex.slice(1), 16);
  return ((255 << 24) | ((value & 255) << 16) | (value & 0xff00) | (value >> 16)) >>> 0;
}

/** Colours of a column's values, 64 of them. */
function shadeOf(column) {
  const { share } = extent(column.values);
  return () => {
    const table = Uint32Array.from({ length: 64 }, (_, i) => packed(rampColour(i / 63)));
    const none = packed(colour('faint'));
    return (i) => (Number.isFinite(column.values[i]) ? table[Math.round(63 * share(column.values[i]))] : none);
  };
}

/** What a drag over the plot chooses: an interval of the column across, and one of the column up if it is tall enough. */
function dragged(u, ix, iy, ux, uy) {
  const s = u.select;
  const across = [ix, u.posToVal(s.left, 'x') * ux.divisor, u.posToVal(s.left + s.width, 'x') * ux.divisor];
  const up = [iy, u.posToVal(s.top + s.height, 'y') * uy.divisor, u.posToVal(s.top, 'y') * uy.divisor];
  return s.height > 2 && s.height < u.over.clientHeight - 2 ? [across, up] : [across];
}

/** A scatter of two columns, coloured by a third (-1: none); drag chooses, hover and arrow keys tell. */
function scatterChart(node, filter, ix, iy, ic, hover) {
  const [cx, cy] = [filter.columns[ix], filter.columns[iy]];
  const [ux, uy] = [cx, cy].map((c) => displayUnit(largest([c.values]), c.unit));
  const x = scaled(cx.values, ux.divisor);
  const y = scaled(cy.values, uy.divisor);
  const [rx, ry] = [paddedRange([x]), paddedRange([y])];
  const layer = new PointLayer(filter, x, y, rx, ry, ic >= 0 ? shadeOf(filter.columns[ic]) : null);
  const repaint = () => { layer.stale = true; };
  filter.onChange(repaint);
  onTheme(repaint);
  if (ic >= 0) node.append(rampBar(filter.columns[ic]));
  let near = -1;
  const point = (i, u) => { near = i; u.redraw(false); hover(near); };
  return chart(node, rx, [{ name: cy.name, y: ry, colour: 'c0', hidden: true }], {
    name: 'scatter', x: { label: axisLabel(cx.name, ux), range: rx }, y: { label: axisLabel(cy.name, uy), range: ry }, height: 380, points: false,
    front: (u) => {
      layer.show(u);
      if (near >= 0) drawMarks(u, [{ x: x[near], y: y[near], colour: 'c1' }]);
    },
    onSelect: (u) => {
      const intervals = dragged(u, ix, iy, ux, uy);
      u.setSelect({ left: 0, top: 0, width: 0, height: 0 }, false);
      filter.setAll(intervals);
    },
    onMove: (_, u) => {
      if (u.cursor.left < 0) return;
      const found = nearest(u, x, y, filter);
      if (found !== near) point(found, u);
    },
    onKey: (u, event) => {
      const order = byValue(x, filter, y);
      const next = keyStep(event, order.indexOf(near), order.length);
      if (next !== null) point(order[next], u);
      if (event.key === 'Escape') filter.clear();
    },
  });
}

/** Chosen rows that have a point, from left to right. */
function byValue(x, filter, y) {
  const list = [];
  for (let i = 0; i < filter.count; ++i) if (filter.chosen[i] && Number.isFinite(x[i]) && Number.isFinite(y[i])) list.push(i);
  return list.sort((a, b) => x[a] - x[b] || a - b);
}

/** The chosen row whose point is nearest to the cursor, within 24 pixels. */
function nearest(u, x, y, filter) {
  const cx = u.posToVal(u.cursor.left, 'x');
  const cy = u.posToVal(u.cursor.top, 'y');
  const kx = u.over.clientWidth / (u.scales.x.max - u.scales.x.min);
  const ky = u.over.clientHeight / (u.scales.y.max - u.scales.y.min);
  let best = 24 * 24;
  let found = -1;
  for (let i = 0; i < filter.count; ++i) {
    if (!filter.chosen[i]) continue;
    const d = ((x[i] - cx) * kx) ** 2 + ((y[i] - cy) * ky) ** 2;
    if (d < best) { best = d; found = i; }
  }
  return found;
}

/** One side of a grid: the values of a column in order, and the edges of their cells in the unit shown. */
class GridAxis {
  constructor(column) {
    this.column = column;
    this.unit = displayUnit(largest([column.values]), column.unit);
    this.values = [...new Set(column.values)].sort((a, b) => a - b);
    const v = this.values;
    const last = v.length - 1;
    this.edges = [v[0] - (v[1] - v[0]) / 2, ...v.slice(1).map((w, i) => (w + v[i]) / 2), v[last] + (v[last] - v[last - 1]) / 2].map((e) => e / this.unit.divisor);
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
    this.cells = new Map(Array.from(cx.values, (v, row) => [this.key(places[0].get(v), places[1].get(cy.values[row])), row]));
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
      const [left, top, width, height] = this.box(u, Math.floor(key / this.y.values.length), key % this.y.values.length);
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

const arrows = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowDown: [0, -1], ArrowUp: [0, 1] };

/** Colour map of a column over a grid of two others; the cell that is pointed at or stepped to is marked and read out. */
function heatMap(node, cx, cy, cz, hover) {
  const grid = new Grid(cx, cy);
  const { share } = extent(cz.values);
  const shade = (row) => (Number.isFinite(cz.values[row]) ? rampColour(share(cz.values[row])) : colour('faint'));
  const read = el('div', { class: 'read', 'aria-live': 'polite' });
  let place = null;
  const show = (a, b, u) => {
    const row = grid.row(a, b);
    if (row === undefined) return;
    place = [a, b];
    readout(read, [cx, cy, cz].map((c) => [plain(c.name), engineering(c.values[row], c.unit)]));
    hover(row);
    u.redraw(false);
  };
  node.append(rampBar(cz));
  const plot = chart(node, grid.x.range, [{ name: cz.name, y: grid.y.range, colour: 'c0', hidden: true }], {
    name: 'heat', x: { label: grid.x.label, range: grid.x.range }, y: { label: grid.y.label, range: grid.y.range }, height: 380, points: false,
    front: (u) => { grid.paint(u, shade); if (place) grid.mark(u, ...place); },
    onMove: (_, u) => {
      if (u.cursor.left < 0) return;
      const [a, b] = [grid.x.at(u.posToVal(u.cursor.left, 'x')), grid.y.at(u.posToVal(u.cursor.top, 'y'))];
      if (!place || a !== place[0] || b !== place[1]) show(a, b, u);
    },
    onKey: (u, event) => {
      const step = arrows[event.key];
      if (!step) return;
      event.preventDefault();
      if (place) show(grid.x.inside(place[0] + step[0]), grid.y.inside(place[1] + step[1]), u);
      else show(0, 0, u);
    },
  });
  node.append(read);
  return plot;
}
