// SPDX-License-Identifier: Apache-2.0
// Charts by uPlot: engineering axes, marks, cursor by mouse, touch and arrow keys, zoom.

import {colour, el, onTheme, seriesColours} from './dom.js';
import {rounded, rpm} from './units.js';

const letters = 'px system-ui, "Liberation Sans", Arial, sans-serif';

/** 1, 2 and 5 times a power of ten come first, what is no whole multiple of one not at all. */
function logRank(value) {
  const leading = value / 10 ** Math.floor(Math.log10(value) + 1e-9);
  const whole = Math.round(leading);
  if (Math.abs(leading - whole) > 1e-6) return null;
  return [1, 10].includes(whole) ? 0 : [2, 5].includes(whole) ? 1 : 2;
}

/** The places of a logarithmic axis that have room for their numbers. */
function logLabels(u, splits, index) {
  const [key, room] = index === 0 ? ['x', 34] : ['y', 22];
  const ranked = splits.filter((v) => v > 0 && logRank(v) !== null).sort((a, b) => logRank(a) - logRank(b) || a - b);
  const kept = new Map();
  for (const v of ranked) {
    const at = u.valToPos(v, key);
    if ([...kept.values()].every((p) => Math.abs(p - at) >= room)) kept.set(v, at);
  }
  return splits.map((v) => (kept.has(v) ? v : null));
}

/** Room for the numbers of an upright axis: letters are some 7.5 px wide, and 8 px lie between them and the plot. */
function roomFor(texts, least) { return Math.max(least, 8 + 7.5 * Math.max(0, ...(texts ?? []).map((s) => s.length))); }

/** "name [unit]" as it fits along an axis: of a name that is too long the beginning. */
function fittedLabel(u, text, side) {
  const room = (side === 2 ? u.bbox.width : u.bbox.height) + 20 * devicePixelRatio;
  const [, name, unit] = /^(.*?)( \[[^\]]*\])?$/.exec(text);
  let length = name.length;
  const short = () => (length < name.length ? name.slice(0, length).trim() + '\u2026' : name) + (unit ?? '');
  while (length > 4 && u.ctx.measureText(short()).width > room) length--;
  return short();
}

function axis({label, log}, side, size) {
  return {
    label: label && ((u) => fittedLabel(u, label, side)),
    side,
    size: side === 3 ? (_, texts) => roomFor(texts, size) : size,
    labelSize: 20,
    gap: 4,
    labelGap: 0,
    font: '12' + letters,
    labelFont: '13' + letters,
    stroke: () => colour('soft'),
    grid: {stroke: () => colour('grid'), width: 1},
    ticks: {stroke: () => colour('line'), width: 1, size: 4},
    values: (_, splits) => splits.map((v) => (v === null ? '' : rounded(v, 6))),
    space: side === 2 ? 60 : 34,
    filter: log ? logLabels : undefined,
  };
}

/** Where a label may stand about its mark, the nearest first [CSS pixels]; -1: it ends there. */
const places = [1, -1]
                   .flatMap((side) => [-11, 12, -26, 27, -42, 43].map((dy) => ({side, dy})))
                   .sort((a, b) => Math.abs(a.dy) - Math.abs(b.dy) || b.side - a.side);

/**
 * The box for a label beside a mark: inside the plot, off other labels, and over as few of the points as may be.
 * @param {{left: number, right: number, y: number}[]} taken
 * @param {number[][]} points  what is drawn [canvas pixels]
 */
function labelPlace(u, width, x, y, taken, points) {
  const ratio = devicePixelRatio;
  const half = 8 * ratio;
  const end = u.bbox.left + u.bbox.width;
  let best = null;
  for (const {side, dy} of places) {
    const wished = side > 0 ? x + 8 * ratio : x - 8 * ratio - width;
    const left = Math.max(Math.min(wished, end - width - 2), u.bbox.left + 2);
    const at = y + dy * ratio;
    const over = (b) => left < b.right && left + width > b.left && Math.abs(at - b.y) < 14 * ratio;
    const hidden = points.filter(([px, py]) => px > left - 4 && px < left + width + 4 && Math.abs(py - at) < half);
    const outside = at < u.bbox.top - 8 * ratio || at > u.bbox.top + u.bbox.height - half;
    const cost = 1000 * taken.filter(over).length + (outside ? 500 : 0) + 10 * hidden.length +
        Math.abs(wished - left) / ratio + Math.abs(dy) / 4;
    if (best === null || cost < best.cost) best = {left, y: at, cost, far: Math.abs(dy) > 20};
  }
  return best;
}

/** Label beside a mark; taken: boxes of labels, to which its own is added. */
export function drawLabel(u, text, x, y, taken = [], points = []) {
  const ratio = devicePixelRatio;
  const ctx = u.ctx;
  ctx.font = 12 * ratio + letters;
  const width = ctx.measureText(text).width;
  const place = labelPlace(u, width, x, y, taken, points);
  taken.push({left: place.left - 4 * ratio, right: place.left + width + 4 * ratio, y: place.y});
  if (place.far) {
    ctx.beginPath();
    ctx.moveTo(x, y);
    ctx.lineTo(Math.min(Math.max(x, place.left), place.left + width), place.y + (place.y < y ? 7 : -7) * ratio);
    ctx.lineWidth = ratio;
    ctx.strokeStyle = colour('soft');
    ctx.stroke();
  }
  ctx.textAlign = 'left';
  ctx.textBaseline = 'middle';
  ctx.lineWidth = 3 * ratio;
  ctx.strokeStyle = colour('card');
  ctx.strokeText(text, place.left, place.y);
  ctx.fillStyle = colour('ink');
  ctx.fillText(text, place.left, place.y);
}

/** A text in the middle of a line, where there is room; the line is left out behind it. */
function drawOnLine(u, text, x, y, taken) {
  const ratio = devicePixelRatio;
  const ctx = u.ctx;
  ctx.font = 11 * ratio + letters;
  const half = ctx.measureText(text).width / 2 + 2 * ratio;
  const middle = Math.min(Math.max(x, u.bbox.left + half), u.bbox.left + u.bbox.width - half);
  if (taken.some((b) => middle - half < b.right && middle + half > b.left && Math.abs(y - b.y) < 14 * ratio)) return;
  taken.push({left: middle - half, right: middle + half, y});
  ctx.fillStyle = colour('card');
  ctx.fillRect(middle - half, y - 7 * ratio, 2 * half, 14 * ratio);
  ctx.textAlign = 'center';
  ctx.textBaseline = 'middle';
  ctx.fillStyle = colour('ink');
  ctx.fillText(text, middle, y);
}

/** What the lines and points of a plot cover, at most some thousand places of it [canvas pixels]. */
export function drawnPlaces(u) {
  const [x, ...series] = u.data;
  const every = Math.max(1, Math.floor((x.length * series.length) / 3000));
  const list = [];
  series.forEach((y, k) => {
    if (u.series[k + 1].hidden) return;
    for (let i = 0; i < x.length; i += every)
      if (Number.isFinite(y[i]) && Number.isFinite(x[i]))
        list.push([u.valToPos(x[i], 'x', true), u.valToPos(y[i], 'y', true)]);
  });
  return list;
}

/** Whether a point is on the part of a plot that is shown, or on its edge. */
export function isInside(u, x, y) {
  const {x: across, y: up} = u.scales;
  const within = (v, {min, max}) => v >= min - 1e-9 * (max - min) && v <= max + 1e-9 * (max - min);
  return within(x, across) && within(y, up);
}

/**
 * Dots with their texts.
 * @param {{left: number, right: number, y: number}[]} taken  boxes of labels that are there
 * @param {number[][]} others  what is drawn besides the series, which labels keep off likewise [canvas pixels]
 */
export function drawMarks(u, marks, taken = [], others = []) {
  const ratio = devicePixelRatio;
  const ctx = u.ctx;
  const inside = marks.filter((m) => isInside(u, m.x, m.y));
  const there = [...inside.filter((m) => m.dot !== false), ...inside.filter((m) => m.dot === false)];
  const points = there.some((m) => m.text) ? [...drawnPlaces(u), ...others] : [];
  ctx.save();
  ctx.beginPath();
  ctx.rect(u.bbox.left - 6 * ratio, u.bbox.top - 24 * ratio, u.bbox.width + 12 * ratio, u.bbox.height + 30 * ratio);
  ctx.clip();
  ctx.setLineDash([]);
  for (const mark of there) {
    const x = u.valToPos(mark.x, 'x', true);
    const y = u.valToPos(mark.y, 'y', true);
    if (mark.dot === false) {
      drawOnLine(u, mark.text, x, y, taken);
      continue;
    }
    ctx.beginPath();
    ctx.arc(x, y, (mark.small ? 3 : 4) * ratio, 0, 2 * Math.PI);
    ctx.fillStyle = mark.colour ? colour(mark.colour) : colour('ink');
    ctx.fill();
    ctx.lineWidth = 1.5 * ratio;
    ctx.strokeStyle = colour('card');
    ctx.stroke();
    if (mark.text) drawLabel(u, mark.text, x, y, taken, points);
  }
  ctx.restore();
}

function seriesConfig(s) {
  const {paths} = uPlot;
  return {
    label: s.name,
    hidden: s.hidden,
    stroke: s.hidden ? 'transparent' : () => colour(s.colour),
    width: s.hidden || s.scatter ? 0 : 2,
    dash: s.dash,
    spanGaps: false,
    pxAlign: 0,
    points: {show: Boolean(s.scatter), size: 7, fill: () => colour(s.colour), stroke: () => colour(s.colour)},
    paths: s.bars ? paths.bars({size: [1, 100], align: 1}) :
        s.steps   ? paths.stepped({align: 1}) :
                    undefined,
    fill: s.area || s.bars ? () => colour(s.colour) + (s.area ? 'aa' : '99') : undefined,
  };
}

/** A scale that shows the range of its axis, or the part of it that was zoomed to. */
function scaleConfig(key, {range, log}, zoomed) {
  const whole = typeof range === 'function' || !range ? range : () => range;
  return {time: false, distr: log ? 3 : 1, range: whole && ((u, ...ends) => zoomed[key] ?? whole(u, ...ends))};
}

/** Zooms a plot by its selection, by + and -, and back by a double click or Escape. */
class Zoom {
  constructor(changed) {
    this.x = null;
    this.y = null;
    this.changed = changed;
  }

  on() { return this.x !== null || this.y !== null; }

  show(u) {
    for (const key of ['x', 'y']) u.setScale(key, {min: u.scales[key].min, max: u.scales[key].max});
    this.changed?.(u);
  }

  toSelection(u) {
    const {left, top, width, height} = u.select;
    const [high, low] = [top, top + height].map((p) => u.posToVal(p, 'y'));
    if (width > 2 && width < u.over.clientWidth - 1) this.x = [left, left + width].map((p) => u.posToVal(p, 'x'));
    if (height > 2 && height < u.over.clientHeight - 1) this.y = [low, high];
    u.setSelect({left: 0, top: 0, width: 0, height: 0}, false);
    this.show(u);
  }

  /** Half or twice the width about the cursor. */
  by(u, factor) {
    const {left} = u.cursor;
    const centre = left >= 0 ? left : u.over.clientWidth / 2;
    this.x = [0, u.over.clientWidth].map((p) => u.posToVal(centre + (p - centre) * factor, 'x'));
    this.show(u);
  }

  reset(u) {
    if (!this.on()) return;
    [this.x, this.y] = [null, null];
    this.show(u);
  }

  key(u, key) {
    if (key === '+') this.by(u, 0.5);
    if (key === '-' && this.on()) this.by(u, 2);
    if (key === 'Escape') this.reset(u);
  }
}

/** Follows the width of its holder and the keyboard. */
function follow(plot, holder, height, options) {
  new ResizeObserver(() => {
    if (holder.clientWidth > 0 && Math.abs(holder.clientWidth - plot.width) > 1)
      plot.setSize({width: holder.clientWidth, height});
  }).observe(holder);
  holder.addEventListener('keydown', (event) => {
    (options.onKey ?? moveCursor)(plot, event);
    plot.zoom?.key(plot, event.key);
  });
  if (plot.zoom) plot.over.addEventListener('dblclick', () => plot.zoom.reset(plot));
}

/** Charts that are on the page; those that were replaced are let go. */
onTheme(() => {
  for (const holder of document.querySelectorAll('.chart')) Object(holder).plot?.redraw(false);
});

/** What is drawn below and above the series, and what a cursor and a selection do. */
function hooksOf(options, zoom) {
  return {
    drawClear: [(u) => options.ground && options.ground(u)],
    draw: [(u) => {
      const taken = [];
      if (options.front) options.front(u, taken);
      drawMarks(u, options.marks || [], taken);
    }],
    setCursor: [(u) => options.onMove && options.onMove(u.cursor.idx === undefined ? null : u.cursor.idx, u)],
    setSelect: [(u) => {
      if (u.select.width <= 2 && u.select.height <= 2) return;
      if (options.onSelect)
        options.onSelect(u);
      else if (zoom)
        zoom.toSelection(u);
    }],
  };
}

/**
 * Draws a chart into a node.
 * series: [{name, y, colour, dash, points, area}] over a common x; an area reaches down to 0; NaN leaves a gap.
 * options: {x: {label, range, log}, y: {label, range, log}, height, marks, ground(u), front(u, taken), onMove(index),
 *           onSelect, name, zoom: true, or called with the plot when its zoom changes}; a selection zooms unless
 *           onSelect takes it.
 */
export function chart(node, x, series, options) {
  const label = options.name || options.y.label;
  const holder = el('div', {class: 'chart', tabindex: '0', role: 'img', 'aria-label': label});
  if (options.name) holder.dataset.chart = options.name;
  node.append(holder);
  const gaps = (values) => Array.from(values, (v) => (Number.isFinite(v) ? v : null));
  const height = options.height || 280;
  const zoom = options.zoom ? new Zoom(typeof options.zoom === 'function' ? options.zoom : null) : null;
  const drags = Boolean(options.onSelect || zoom);
  const config = {
    width: Math.max(holder.clientWidth, 200),
    height,
    padding: [14, 14, 0, 0],
    scales: {x: scaleConfig('x', options.x, zoom ?? {}), y: scaleConfig('y', options.y, zoom ?? {})},
    axes: [axis(options.x, 2, 26), axis(options.y, 3, 46)],
    legend: {show: false},
    cursor: {
      drag: {x: drags, y: drags, setScale: false, uni: 20},
      points: {show: options.points !== false},
      y: Boolean(options.onSelect)
    },
    series: [{}, ...series.map(seriesConfig)],
    bands: options.bands || [],
    hooks: hooksOf(options, zoom),
  };
  const plot = new uPlot(config, [gaps(x), ...series.map((s) => gaps(s.y))], holder);
  Object.assign(plot, {options, zoom});
  Object.assign(holder, {plot});
  follow(plot, holder, height, options);
  return plot;
}

/** Where an arrow key, Home or End leads among so many places; null for other keys. */
export function keyStep(event, now, count) {
  const step = event.shiftKey ? 10 : 1;
  const next = {ArrowRight: now + step, ArrowLeft: now - step, Home: 0, End: count - 1}[event.key];
  if (next === undefined || !count) return null;
  event.preventDefault();
  return Math.min(Math.max(next, 0), count - 1);
}

/** Arrow keys, Home and End move the cursor along the data. */
export function moveCursor(plot, event) {
  const index = keyStep(event, plot.cursor.idx ?? -1, plot.data[0].length);
  if (index === null) return;
  plot.setCursor({left: plot.valToPos(plot.data[0][index], 'x'), top: plot.bbox.height / devicePixelRatio / 2});
}

/** Smallest and largest of what is finite, or what `keep` says. */
function ends(arrays, keep = Number.isFinite) {
  let [low, high] = [Infinity, -Infinity];
  for (const array of arrays)
    for (const v of array)
      if (keep(v)) [low, high] = [Math.min(low, v), Math.max(high, v)];
  return [low, high];
}

/** A range a little wider than the values, with zero in it if asked. */
export function paddedRange(arrays, withZero) {
  const [low, high] = ends(withZero ? [...arrays, [0]] : arrays);
  if (!(low <= high)) return [0, 1];
  const size = Math.max(Math.abs(low), Math.abs(high));
  const pad = (high - low > 1e-9 * size ? high - low : size || 1) * 0.09;  // what differs by rounding is the same
  return [withZero && low === 0 ? 0 : low - pad, high + pad];
}

/** The same for a logarithmic axis, which knows positive values only. */
export function logRange(arrays) {
  const [low, high] = ends(arrays, (v) => Number.isFinite(v) && v > 0);
  if (!(low <= high)) return [1, 10];
  const pad = Math.max((high / low) ** 0.07, 1.05);
  return [low / pad, high * pad];
}

export function scaled(values, divisor) { return Float64Array.from(values, (v) => v / divisor); }

/**
 * The parts of curves on which a motor squeals, as broad strokes below the lines.
 * @param {number[][][]} list  of each of the first lines of the plot: [[first, last], ...], speeds [rad/s]
 */
export function drawSqueals(u, list) {
  const {ctx, bbox} = u;
  const ratio = devicePixelRatio;
  ctx.save();
  ctx.beginPath();
  ctx.rect(bbox.left, bbox.top, bbox.width, bbox.height);
  ctx.clip();
  ctx.lineWidth = 10 * ratio;
  ctx.setLineDash([]);
  list.forEach((ranges, k) => ranges.forEach(([from, to]) => {
    ctx.strokeStyle = colour(seriesColours[k % 7]) + '50';
    ctx.beginPath();
    u.data[0].forEach((x, i) => {
      const y = u.data[k + 1][i];
      if (y === null || x * rpm < from || x * rpm > to) return;
      ctx.lineTo(u.valToPos(x, 'x', true), u.valToPos(y, 'y', true));
    });
    ctx.stroke();
  }));
  ctx.restore();
}
