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

/** A scatter of two columns, coloured by a third (-1: none); drag chooses, hover and arrow keys tell. */
function scatterChart(node, filter, ix, iy, ic, hover) {
  const [cx, cy] = [filter.columns[ix], filter.columns[iy]];
  const ux = displayUnit(largest([cx.values]), cx.unit);
  const uy = displayUnit(largest([cy.values]), cy.unit);
  const x = scaled(cx.values, ux.divisor);
  const y = scaled(cy.values, uy.divisor);
  const rx = paddedRange([x]);
  const ry = paddedRange([y]);
  let near = -1;
  const layer = new PointLayer(filter, x, y, rx, ry, ic >= 0 ? shadeOf(filter.columns[ic]) : null);
  if (ic >= 0) node.append(rampBar(filter.columns[ic]));
  const point = (i, u) => { near = i; u.redraw(false); hover(near); };
  filter.onChange(() => { layer.stale = true; });
  onTheme(() => { layer.stale = true; });
  const paint = (u) => {
    layer.show(u);
    if (near >= 0) drawMarks(u, [{ x: x[near], y: y[near], colour: 'c1' }]);
  };
  const plot = chart(node, rx, [{ name: cy.name, y: ry, colour: 'c0', hidden: true }], {
    name: 'scatter', x: { label: axisLabel(cx.name, ux), range: rx }, y: { label: axisLabel(cy.name, uy), range: ry }, height: 380, front: paint, points: false,
    onSelect: (u) => {
      const s = u.select;
      const low = u.posToVal(s.left, 'x') * ux.divisor;
      const high = u.posToVal(s.left + s.width, 'x') * ux.divisor;
      const tall = s.height > 2 && s.height < u.over.clientHeight - 2;
      const upright = [iy, u.posToVal(s.top + s.height, 'y') * uy.divisor, u.posToVal(s.top, 'y') * uy.divisor];
      u.setSelect({ left: 0, top: 0, width: 0, height: 0 }, false);
      filter.setAll(tall ? [[ix, low, high], upright] : [[ix, low, high]]);
    },
    onMove: (_, u) => {
      if (u.cursor.left < 0) return;
      const found = nearest(u, x, y, filter);
      if (found !== near) point(found, u);
    },
    onKey: (u, event) => {
      const order = byValue(x, filter, y);
      const at = order.indexOf(near);
      const next = keyStep(event, at, order.length);
      if (next !== null) point(order[next], u);
      if (event.key === 'Escape') filter.clear();
    },
  });
  return plot;
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

/** Colour map of a column over a grid of two others. */
function heatMap(node, cx, cy, cz, hover) {
  const distinct = (values) => [...new Set(values)].sort((a, b) => a - b);
  const [xs, ys] = [distinct(cx.values), distinct(cy.values)];
  const [ux, uy] = [cx, cy].map((c) => displayUnit(largest([c.values]), c.unit));
  const { share } = extent(cz.values);
  const edges = (list) => [list[0] - (list[1] - list[0]) / 2, ...list.slice(1).map((v, i) => (v + list[i]) / 2), list[list.length - 1] + (list[list.length - 1] - list[list.length - 2]) / 2];
  const [ex, ey] = [edges(xs), edges(ys)];
  const where = (list, v) => list.indexOf(v);
  const cells = new Map();
  for (let i = 0; i < cz.values.length; ++i) cells.set(where(xs, cx.values[i]) * ys.length + where(ys, cy.values[i]), i);
  const rx = [ex[0] / ux.divisor, ex[ex.length - 1] / ux.divisor];
  const ry = [ey[0] / uy.divisor, ey[ey.length - 1] / uy.divisor];
  const inside = (list, v) => { let i = 0; while (i < list.length - 2 && list[i + 1] <= v) ++i; return i; };
  node.append(rampBar(cz));
  let place = [0, 0];
  let marked = false;
  const read = el('div', { class: 'read', 'aria-live': 'polite' });
  const show = (a, b) => {
    const found = cells.get(a * ys.length + b);
    if (found === undefined) return;
    place = [a, b];
    readout(read, [cx, cy, cz].map((c) => [plain(c.name), engineering(c.values[found], c.unit)]));
    hover(found);
  };
  const plot = chart(node, rx, [{ name: cz.name, y: ry, colour: 'c0', hidden: true }], {
    name: 'heat', x: { label: axisLabel(cx.name, ux), range: rx }, y: { label: axisLabel(cy.name, uy), range: ry }, height: 380, points: false,
    front: (u) => {
      for (const [key, i] of cells) {
        const a = Math.floor(key / ys.length);
        const b = key % ys.length;
        const [x0, x1] = [u.valToPos(ex[a] / ux.divisor, 'x', true), u.valToPos(ex[a + 1] / ux.divisor, 'x', true)];
        const [y0, y1] = [u.valToPos(ey[b] / uy.divisor, 'y', true), u.valToPos(ey[b + 1] / uy.divisor, 'y', true)];
        u.ctx.fillStyle = Number.isFinite(cz.values[i]) ? rampColour(share(cz.values[i])) : colour('faint');
        u.ctx.fillRect(x0, y1, Math.ceil(x1 - x0) + 0.5, Math.ceil(y0 - y1) + 0.5);
      }
      if (!marked) return;
      const [x0, x1, y0, y1] = [u.valToPos(ex[place[0]] / ux.divisor, 'x', true), u.valToPos(ex[place[0] + 1] / ux.divisor, 'x', true), u.valToPos(ey[place[1]] / uy.divisor, 'y', true), u.valToPos(ey[place[1] + 1] / uy.divisor, 'y', true)];
      u.ctx.strokeStyle = colour('c1');
      u.ctx.lineWidth = 3 * devicePixelRatio;
      u.ctx.strokeRect(x0, y1, x1 - x0, y0 - y1);
    },
    onMove: (_, u) => {
      if (u.cursor.left < 0) return;
      const a = inside(ex, u.posToVal(u.cursor.left, 'x') * ux.divisor);
      const b = inside(ey, u.posToVal(u.cursor.top, 'y') * uy.divisor);
      if (!marked || a !== place[0] || b !== place[1]) { marked = true; show(a, b); u.redraw(false); }
    },
    onKey: (u, event) => {
      const [dx, dy] = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowDown: [0, -1], ArrowUp: [0, 1] }[event.key] || [0, 0];
      if (!dx && !dy) return;
      event.preventDefault();
      if (marked) show(Math.min(Math.max(place[0] + dx, 0), xs.length - 1), Math.min(Math.max(place[1] + dy, 0), ys.length - 1));
      else show(...place);
      marked = true;
      u.redraw(false);
    },
  });
  node.append(read);
  return plot;
}
