// SPDX-License-Identifier: Apache-2.0
'use strict';
// All designs as points: axes and drag by uPlot, points drawn here, since there may be 100000 of them.

/** Ten colours from dark blue to yellow that keep their order in grey and for every colour vision. */
const ramp = [[0, 32, 77], [0, 52, 110], [54, 73, 108], [87, 92, 109], [112, 113, 115], [138, 134, 120], [166, 157, 117], [197, 180, 106], [228, 206, 87], [255, 234, 70]];

function rampColour(share) {
  const place = Math.min(Math.max(share, 0), 1) * (ramp.length - 1);
  const i = Math.min(Math.floor(place), ramp.length - 2);
  const mix = ramp[i].map((v, k) => Math.round(v + (ramp[i + 1][k] - v) * (place - i)));
  return 'rgb(' + mix.join(',') + ')';
}

/** The points of a scatter, kept as a picture: a hover then costs a copy, not 100000 squares. */
class PointLayer {
  constructor(filter, x, y, rx, ry) {
    Object.assign(this, { filter, x, y, rx, ry, canvas: el('canvas', {}), stale: true });
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
    const side = Math.round((count > 20000 ? 2 : count > 2000 ? 3 : 5) * devicePixelRatio);
    const image = ctx.createImageData(width, height);
    const pixels = new Uint32Array(image.data.buffer);
    const kx = width / (this.rx[1] - this.rx[0]);
    const ky = height / (this.ry[1] - this.ry[0]);
    for (const pass of this.filter.intervals.size ? [0, 1] : [1]) {
      const paint = packed(colour(pass ? 'c0' : 'faint'));
      for (let i = 0; i < count; ++i) {
        if (this.filter.chosen[i] !== pass) continue;
        const px = Math.round((this.x[i] - this.rx[0]) * kx - side / 2);
        const py = Math.round(height - (this.y[i] - this.ry[0]) * ky - side / 2);
        if (!(px >= 0 && py >= 0 && px + side <= width && py + side <= height)) continue;
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

/** A scatter of two columns; drag chooses, hover tells. */
function scatterChart(node, filter, ix, iy, hover) {
  const [cx, cy] = [filter.columns[ix], filter.columns[iy]];
  const ux = displayUnit(largest([cx.values]), cx.unit);
  const uy = displayUnit(largest([cy.values]), cy.unit);
  const x = scaled(cx.values, ux.divisor);
  const y = scaled(cy.values, uy.divisor);
  const rx = paddedRange([x]);
  const ry = paddedRange([y]);
  let near = -1;
  const layer = new PointLayer(filter, x, y, rx, ry);
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
      if (found !== near) { near = found; u.redraw(false); hover(near); }
    },
  });
  return plot;
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
  const [ux, uy, uz] = [cx, cy, cz].map((c) => displayUnit(largest([c.values]), c.unit));
  let [low, high] = [Infinity, -Infinity];
  for (const v of cz.values) if (Number.isFinite(v)) { low = Math.min(low, v); high = Math.max(high, v); }
  const edges = (list) => [list[0] - (list[1] - list[0]) / 2, ...list.slice(1).map((v, i) => (v + list[i]) / 2), list[list.length - 1] + (list[list.length - 1] - list[list.length - 2]) / 2];
  const [ex, ey] = [edges(xs), edges(ys)];
  const where = (list, v) => list.indexOf(v);
  const cells = new Map();
  for (let i = 0; i < cz.values.length; ++i) cells.set(where(xs, cx.values[i]) * ys.length + where(ys, cy.values[i]), i);
  const rx = [ex[0] / ux.divisor, ex[ex.length - 1] / ux.divisor];
  const ry = [ey[0] / uy.divisor, ey[ey.length - 1] / uy.divisor];
  const inside = (list, v) => { let i = 0; while (i < list.length - 2 && list[i + 1] <= v) ++i; return i; };
  const share = (v) => (high > low ? (v - low) / (high - low) : 0.5);
  const bar = el('div', { class: 'legend' }, el('span', {}, engineering(low, cz.unit, 3)));
  const strip = svg('svg', { width: 160, height: 12, 'aria-hidden': 'true' });
  for (let i = 0; i < 40; ++i) strip.append(svg('rect', { x: 4 * i, y: 0, width: 4.5, height: 12, fill: rampColour(i / 39) }));
  bar.append(strip, el('span', {}, engineering(high, cz.unit, 3)), el('span', {}, plain(cz.name)));
  node.append(bar);
  return chart(node, rx, [{ name: cz.name, y: ry, colour: 'c0', hidden: true }], {
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
    },
    onMove: (_, u) => {
      if (u.cursor.left < 0) return;
      const a = inside(ex, u.posToVal(u.cursor.left, 'x') * ux.divisor);
      const b = inside(ey, u.posToVal(u.cursor.top, 'y') * uy.divisor);
      const found = cells.get(a * ys.length + b);
      if (found !== undefined) hover(found);
    },
  });
}
