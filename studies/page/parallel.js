// SPDX-License-Identifier: Apache-2.0
// Parallel coordinates on a canvas: one line for each design, an interval on any axis chooses.

import {colour, el, onTheme} from './dom.js';
import {savePicture} from './figure.js';
import {numbersAt} from './telling.js';
import {displayUnit, largest, rounded} from './units.js';
import {axisLabel} from './words.js';

/**
 * Which one of the k-th `count` lines is drawn: any, since always the first would show a part of a grid or of a Sobol
 * sequence only.
 */
function drawnOf(k, count) {
  const mixed = Math.imul(k + 1, 0x9e3779b1);
  return (Math.imul(mixed ^ (mixed >>> 15), 0x85ebca6b) >>> 8) % count;
}

class Parallel {
  constructor(node, {axes, most}, filter, choose) {
    const columns = axes.map((a) => ({...a, values: numbersAt(a.values)}));
    this.columns = columns;
    this.most = most;
    this.filter = filter;
    this.choose = choose;
    this.marked = -1;
    this.canvas = el('canvas', {});
    this.holder =
        el('div',
           {class: 'chart', tabindex: '0', role: 'img', 'aria-label': 'parallel coordinates', 'data-chart': 'parallel'},
           this.canvas);
    this.note = el('div', {class: 'read'});
    const save = el('button', {type: 'button', onclick: () => this.save(node)}, 'Save picture');
    node.append(el('div', {class: 'figure-head'}, el('div', {class: 'figure-tools'}, save)), this.holder, this.note);
    this.holder.parallel = this;
    this.ranges = columns.map((c) => Parallel.range(c.values));
    this.units = columns.map((c) => displayUnit(largest([c.values]), c.unit));
    new ResizeObserver(() => this.resize()).observe(this.holder);
    onTheme(() => this.draw());
    filter.onChange(() => this.draw());
    this.listen();
    this.resize();
  }

  /** The picture under the title of its card. */
  save(node) {
    const title = node.querySelector('h2')?.textContent ?? 'parallel coordinates';
    savePicture(this.canvas, title);
  }

  /** Ends of an axis; what differs by rounding only stands in the middle. */
  static range(values) {
    let [low, high] = [Infinity, -Infinity];
    for (const v of values)
      if (Number.isFinite(v)) {
        low = Math.min(low, v);
        high = Math.max(high, v);
      }
    if (!(low <= high)) return [0, 1];
    const size = Math.max(Math.abs(low), Math.abs(high)) || 1;
    return high - low > 1e-6 * size ? [low, high] : [low - 0.1 * size, high + 0.1 * size];
  }

  resize() {
    const ratio = devicePixelRatio;
    this.width = Math.max(this.holder.clientWidth, 200);
    this.upright = this.width < 110 * this.columns.length;  // axes lie across on narrow screens
    this.height = this.upright ? 60 * this.columns.length + 20 : 330;
    this.canvas.width = this.width * ratio;
    this.canvas.height = this.height * ratio;
    this.canvas.style.width = this.width + 'px';
    this.canvas.style.height = this.height + 'px';
    // A finger along an axis chooses; across it, it scrolls the page.
    this.canvas.style.touchAction = this.upright ? 'pan-y' : 'pan-x';
    this.draw();
  }

  /** Where a share of axis k lies [CSS pixels]. */
  place(k, share) {
    const n = this.columns.length;
    if (this.upright) return [14 + share * (this.width - 28), 40 + (n > 1 ? (k * (this.height - 66)) / (n - 1) : 0)];
    return [60 + (n > 1 ? (k * (this.width - 120)) / (n - 1) : 0), this.height - 30 - share * (this.height - 84)];
  }

  share(k, value) { return (value - this.ranges[k][0]) / (this.ranges[k][1] - this.ranges[k][0]); }

  line(ctx, i) {
    ctx.beginPath();
    let open = false;
    for (let k = 0; k < this.columns.length; ++k) {
      const v = this.columns[k].values[i];
      if (!Number.isFinite(v)) {
        open = false;
        continue;
      }
      const [x, y] = this.place(k, this.share(k, v));
      if (open)
        ctx.lineTo(x, y);
      else
        ctx.moveTo(x, y);
      open = true;
    }
    ctx.stroke();
  }

  lines(ctx, pass, name, alpha) {
    const total = pass ? this.filter.total : this.filter.count - this.filter.total;
    const every = Math.max(1, Math.ceil(total / this.most));
    ctx.strokeStyle = colour(name);
    ctx.globalAlpha = Math.min(alpha, Math.max(0.05, (alpha * 60) / Math.max(total / every, 1)));
    let seen = 0;
    for (let i = 0; i < this.filter.count; ++i)
      if (this.filter.chosen[i] === pass && seen % every === drawnOf(Math.floor(seen++ / every), every))
        this.line(ctx, i);
    ctx.globalAlpha = 1;
    return every;
  }

  draw() {
    const ctx = this.canvas.getContext('2d');
    ctx.setTransform(devicePixelRatio, 0, 0, devicePixelRatio, 0, 0);
    ctx.clearRect(0, 0, this.width, this.height);
    ctx.lineWidth = 1.2;
    if (this.filter.intervals.size && this.filter.count < 20000) this.lines(ctx, 0, 'faint', 0.4);
    const every = this.lines(ctx, 1, 'c0', 0.85);
    if (this.marked >= 0) {
      ctx.lineWidth = 2.5;
      ctx.strokeStyle = colour('c1');
      this.line(ctx, this.marked);
    }
    this.axes(ctx);
    this.note.textContent = this.filter.total + ' of ' + this.filter.count + ' chosen' +
        (every > 1 ? '; one in ' + every + ' of them is drawn' : '');
  }

  axes(ctx) {
    ctx.font = '12px system-ui, "Liberation Sans", Arial, sans-serif';
    this.columns.forEach((c, k) => {
      const [x0, y0] = this.place(k, 0);
      const [x1, y1] = this.place(k, 1);
      ctx.strokeStyle = colour('soft');
      ctx.lineWidth = 1.5;
      ctx.beginPath();
      ctx.moveTo(x0, y0);
      ctx.lineTo(x1, y1);
      ctx.stroke();
      const interval = this.filter.intervals.get(k);
      if (interval) {
        const [a, b] = interval.map((v) => this.place(k, Math.min(Math.max(this.share(k, v), 0), 1)));
        ctx.strokeStyle = colour('c1');
        ctx.lineWidth = 6;
        ctx.beginPath();
        ctx.moveTo(...a);
        ctx.lineTo(...b);
        ctx.stroke();
      }
      const ends = this.ranges[k].map((v) => rounded(v / this.units[k].divisor, 3));
      const title = axisLabel(c.name, this.units[k]);
      if (this.upright) {
        this.word(ctx, title, x0, y0 - 16, 'left', 'ink');
        this.word(ctx, ends[0], x0, y0 + 13, 'left', 'soft');
        this.word(ctx, ends[1], x1, y0 + 13, 'right', 'soft');
      } else {
        const room = k === 0 || k === this.columns.length - 1 ?
            116 :
            (this.width - 120) / Math.max(this.columns.length - 1, 1) - 8;
        const pieces = this.wrapped(ctx, title, room);
        pieces.forEach((piece, i) => this.word(ctx, piece, x0, 12 + 15 * i, 'center', 'ink'));
        this.word(ctx, ends[1], x0, y1 - 8, 'center', 'soft');
        this.word(ctx, ends[0], x0, y0 + 14, 'center', 'soft');
      }
    });
  }

  /** A title in at most two lines, the end left out where it does not fit. */
  wrapped(ctx, text, room) {
    const lines = [''];
    for (const w of text.split(' ')) {
      const longer = (lines[lines.length - 1] + ' ' + w).trim();
      if (ctx.measureText(longer).width <= room || !lines[lines.length - 1])
        lines[lines.length - 1] = longer;
      else
        lines.push(w);
    }
    if (lines.length > 2) lines.splice(1, lines.length - 1, lines.slice(1).join(' '));
    return lines.map((l) => {
      let s = l;
      while (s.length > 3 && ctx.measureText(s).width > room) s = s.slice(0, -2) + '…'.slice(0, 1);
      return s;
    });
  }

  word(ctx, text, x, y, align, name) {
    ctx.textAlign = align;
    ctx.textBaseline = 'middle';
    ctx.lineWidth = 5;
    ctx.strokeStyle = colour('card');
    ctx.strokeText(text, x, y);
    ctx.fillStyle = colour(name);
    ctx.fillText(text, x, y);
  }

  /** Axis and share under a pointer. */
  under(event) {
    const box = this.canvas.getBoundingClientRect();
    const [px, py] = [event.clientX - box.left, event.clientY - box.top];
    let best = [Infinity, 0, 0];
    for (let k = 0; k < this.columns.length; ++k) {
      const [x0, y0] = this.place(k, 0);
      const [x1, y1] = this.place(k, 1);
      const share = this.upright ? (px - x0) / (x1 - x0) : (py - y0) / (y1 - y0);
      const far = Math.abs(this.upright ? py - y0 : px - x0);
      if (far < best[0]) best = [far, k, Math.min(Math.max(share, 0), 1)];
    }
    return best;
  }

  listen() {
    let from = null;
    const value = (k, share) => this.ranges[k][0] + share * (this.ranges[k][1] - this.ranges[k][0]);
    this.canvas.addEventListener('pointercancel', () => {
      from = null;
    });
    this.canvas.addEventListener('pointerdown', (e) => {
      const [far, k, share] = this.under(e);
      if (far > 24) return;
      from = {k, share};
      this.canvas.setPointerCapture(e.pointerId);
    });
    this.canvas.addEventListener('pointerup', (e) => {
      if (!from) return;
      const {k, share} = from;
      from = null;
      const end = this.under(e);
      const last = end[1] === k ? end[2] : share;
      if (Math.abs(last - share) < 0.01)
        this.filter.set(k, null, null);
      else
        this.filter.set(k, value(k, Math.min(share, last)), value(k, Math.max(share, last)));
    });
    this.holder.addEventListener('keydown', (e) => {
      if (e.key === 'Escape') this.filter.clear();
      if (!this.choose || !['ArrowUp', 'ArrowDown'].includes(e.key)) return;
      e.preventDefault();
      const next = this.marked + (e.key === 'ArrowDown' ? 1 : -1);
      this.choose(Math.min(Math.max(next, 0), this.filter.count - 1));
    });
  }
}

/** Parallel coordinates of a section; choose(i) marks a line. */
export function parallelChart(node, told, filter, choose) {
  const parallel = new Parallel(node, told, filter, choose);
  return {
    choose(i) {
      parallel.marked = i;
      parallel.draw();
    }
  };
}
