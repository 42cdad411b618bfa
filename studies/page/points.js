// SPDX-License-Identifier: Apache-2.0
// What a scatter shows inside its axes: points, or of very many designs how many lie where. Kept as a picture: a hover
// then costs a copy, not 100000 squares.

import {numbers} from './bytes.js';
import {rows} from './data.js';
import {colour, el} from './dom.js';
import {extent, packed, rampColour} from './ramp.js';

/** A function of a value on a side that is even along its axis. */
export function along({log}) { return log ? Math.log : (v) => v; }

/** Pixel of a value on a side of so many pixels. */
function pixelOf(side, size) {
  const f = along(side);
  const [low, high] = side.range.map(f);
  return (v) => ((f(v) - low) / (high - low)) * size;
}

/** The ramp in 64 steps. */
function rampSteps() { return Array.from({length: 64}, (_, i) => rampColour(i / 63)); }

/** Colours of a column's values. */
export function shadeOf(column) {
  const {share} = extent(column.values);
  return () => {
    const steps = rampSteps().map(packed);
    const none = packed(colour('faint'));
    return (i) => (Number.isFinite(column.values[i]) ? steps[Math.round(63 * share(column.values[i]))] : none);
  };
}

/** A picture of the plotting area that is painted when it is stale, by the layers made of it. */
class Layer {
  constructor() {
    this.canvas = el('canvas', {});
    this.stale = true;
  }

  /** @param {any[]} _ctx, width, height [canvas pixels] */
  paint(..._ctx) {}

  show(u) {
    const [width, height] = [u.bbox.width, u.bbox.height].map(Math.round);
    if (this.stale || this.canvas.width !== width || this.canvas.height !== height) {
      Object.assign(this.canvas, {width, height});
      this.paint(this.canvas.getContext('2d'), width, height);
      this.stale = false;
    }
    u.ctx.drawImage(this.canvas, u.bbox.left, u.bbox.top);
  }
}

export class PointLayer extends Layer {
  /**
   * x, y: {values, range, log}; shade: colour of a chosen row as one pixel, or null for one colour;
   * overlaid: of densities, which show what is not chosen
   */
  constructor(filter, x, y, shade, overlaid) {
    super();
    this.filter = filter;
    this.x = x;
    this.y = y;
    this.shade = shade;
    this.overlaid = overlaid;
  }

  /** Which rows are painted, in order: those that are not chosen below. */
  passes() {
    if (!this.filter.intervals.size) return this.overlaid ? [] : [1];
    return this.overlaid ? [1] : [0, 1];
  }

  paint(ctx, width, height) {
    const {count, chosen} = this.filter;
    const side = Math.round((count > 20000 ? 2 : count > 2000 ? 3 : count > 200 ? 5 : 8) * devicePixelRatio);
    const image = ctx.createImageData(width, height);
    const pixels = new Uint32Array(image.data.buffer);
    const [px, py] = [pixelOf(this.x, width), pixelOf(this.y, height)];
    for (const pass of this.passes()) {
      const onePaint = packed(colour(pass ? (this.overlaid ? 'c1' : 'c0') : 'faint'));
      const shade = pass && this.shade ? this.shade() : null;
      for (let i = 0; i < count; ++i) {
        if (chosen[i] !== pass) continue;
        const left = Math.round(px(this.x.values[i]) - side / 2);
        const top = Math.round(height - py(this.y.values[i]) - side / 2);
        if (!(left >= 0 && top >= 0 && left + side <= width && top + side <= height)) continue;
        const paint = shade ? shade(i) : onePaint;
        for (let r = top; r < top + side; ++r) pixels.fill(paint, r * width + left, r * width + left + side);
      }
    }
    ctx.putImageData(image, 0, 0);
  }
}

/**
 * How many of all designs lie in each cell of two columns, for sweeps of more designs than the page holds; else null.
 * x and y are the edges of the cells, SI.
 */
export function countsOf(ix, iy) {
  const {densities} = rows;
  if (!densities || ix === iy) return null;
  const text = densities.counts[Math.min(ix, iy) + ',' + Math.max(ix, iy)];
  if (!text) return null;
  const cells = numbers(text, Uint32Array);
  const n = densities.cells;
  const edges = ([low, high]) => Float64Array.from({length: n + 1}, (_, i) => low + ((high - low) * i) / n);
  return {
    n,
    at: ix < iy ? (i, j) => cells[i * n + j] : (i, j) => cells[j * n + i],
    x: edges(densities.ranges[ix]),
    y: edges(densities.ranges[iy]),
    most: cells.reduce((a, b) => Math.max(a, b), 0)
  };
}

export class DensityLayer extends Layer {
  constructor(counts, x, y) {
    super();
    this.counts = counts;
    this.x = x;
    this.y = y;
  }

  paint(ctx, width, height) {
    const {n, at, most, x, y} = this.counts;
    const places = (side, edges, size) => Array.from(edges, (v) => pixelOf(side, size)(v / side.unit.divisor));
    const [px, py] = [places(this.x, x, width), places(this.y, y, height)];
    const steps = rampSteps();
    for (let i = 0; i < n; ++i)
      for (let j = 0; j < n; ++j) {
        if (!at(i, j)) continue;
        // Counts over several powers of ten are distinguished by their logarithm.
        ctx.fillStyle = steps[Math.round((63 * Math.log(at(i, j))) / Math.max(Math.log(most), 1e-9))];
        const [left, right] = [Math.floor(px[i]), Math.ceil(px[i + 1])];
        const [top, bottom] = [Math.floor(height - py[j + 1]), Math.ceil(height - py[j])];
        ctx.fillRect(left, top, right - left, bottom - top);
      }
  }
}
