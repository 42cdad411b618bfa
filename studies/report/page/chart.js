// SPDX-License-Identifier: Apache-2.0
'use strict';
// Line charts by uPlot: engineering axes, marks, cursor by mouse, touch and arrow keys.

const charts = [];

function axis(label, side, size) {
  return {
    label, side, size, labelSize: 20, gap: 4, labelGap: 0,
    font: '12px system-ui, "Liberation Sans", Arial, sans-serif', labelFont: '13px system-ui, "Liberation Sans", Arial, sans-serif',
    stroke: () => colour('soft'), grid: { stroke: () => colour('grid'), width: 1 }, ticks: { stroke: () => colour('line'), width: 1, size: 4 },
    values: (_, splits) => splits.map((v) => (v === null ? '' : rounded(v, 6))),
    space: side === 2 ? 60 : 34,
  };
}

/** Label beside a mark, kept inside the plot; below the mark where another label stands above it. */
function drawLabel(u, text, x, y, taken = []) {
  const ratio = devicePixelRatio;
  const ctx = u.ctx;
  ctx.font = 12 * ratio + 'px system-ui, "Liberation Sans", Arial, sans-serif';
  const width = ctx.measureText(text).width;
  const right = u.bbox.left + u.bbox.width;
  let left = x + 8 * ratio;
  if (left + width > right) left = x - width - 8 * ratio;
  left = Math.max(left, u.bbox.left + 2);
  const free = (at) => !taken.some((b) => left < b.right && left + width > b.left && Math.abs(at - b.y) < 14 * ratio);
  const at = [y - 11 * ratio, y + 12 * ratio, y + 26 * ratio].find(free) ?? y - 11 * ratio;
  taken.push({ left: left - 4 * ratio, right: left + width + 4 * ratio, y: at });
  ctx.textAlign = 'left';
  ctx.textBaseline = 'middle';
  ctx.lineWidth = 3 * ratio;
  ctx.strokeStyle = colour('card');
  ctx.strokeText(text, left, at);
  ctx.fillStyle = colour('ink');
  ctx.fillText(text, left, at);
}

function drawMarks(u, marks) {
  const ratio = devicePixelRatio;
  const ctx = u.ctx;
  ctx.save();
  ctx.beginPath();
  ctx.rect(u.bbox.left - 6 * ratio, u.bbox.top - 24 * ratio, u.bbox.width + 12 * ratio, u.bbox.height + 30 * ratio);
  ctx.clip();
  const taken = [];
  for (const mark of marks) {
    if (!Number.isFinite(mark.x) || !Number.isFinite(mark.y)) continue;
    const x = u.valToPos(mark.x, 'x', true);
    const y = u.valToPos(mark.y, 'y', true);
    ctx.beginPath();
    ctx.arc(x, y, (mark.small ? 3 : 4) * ratio, 0, 2 * Math.PI);
    ctx.fillStyle = mark.colour ? colour(mark.colour) : colour('ink');
    ctx.fill();
    ctx.lineWidth = 1.5 * ratio;
    ctx.strokeStyle = colour('card');
    ctx.stroke();
    if (mark.text) drawLabel(u, mark.text, x, y, taken);
  }
  ctx.restore();
}

/**
 * Draws a chart into a node.
 * series: [{name, y, colour, dash, points, area}] over a common x; an area reaches down to 0; NaN leaves a gap.
 * options: {x: {label, range}, y: {label, range}, height, marks, ground(u), front(u), onMove(index), onSelect, name}
 */
function chart(node, x, series, options) {
  const holder = el('div', { class: 'chart', tabindex: '0', role: 'img', 'aria-label': options.name || options.y.label });
  if (options.name) holder.dataset.chart = options.name;
  node.append(holder);
  const gaps = (values) => Array.from(values, (v) => (Number.isFinite(v) ? v : null));
  const height = options.height || 280;
  const config = {
    width: Math.max(holder.clientWidth, 200), height: height,
    padding: [14, 14, 0, 0],
    scales: { x: { time: false, range: options.x.range || undefined }, y: { range: options.y.range || undefined } },
    axes: [axis(options.x.label, 2, 26), axis(options.y.label, 3, 46)],
    legend: { show: false },
    cursor: { drag: { x: Boolean(options.onSelect), y: Boolean(options.onSelect), setScale: false, uni: 20 }, points: { show: options.points !== false }, y: Boolean(options.onSelect) },
    series: [{}, ...series.map((s) => ({
      label: s.name, stroke: s.hidden ? 'transparent' : () => colour(s.colour), width: s.hidden || s.scatter ? 0 : 2, dash: s.dash, spanGaps: false, pxAlign: 0,
      points: { show: Boolean(s.scatter), size: 7, fill: () => colour(s.colour), stroke: () => colour(s.colour) },
      paths: s.bars ? uPlot.paths.bars({ size: [1, 100], align: 1 }) : s.steps ? uPlot.paths.stepped({ align: 1 }) : undefined,
      fill: s.area ? () => colour(s.colour) + 'aa' : s.bars ? () => colour(s.colour) + '99' : undefined,
    }))],
    bands: options.bands || [],
    hooks: {
      drawClear: [(u) => options.ground && options.ground(u)],
      draw: [(u) => { if (options.front) options.front(u); drawMarks(u, options.marks || []); }],
      setCursor: [(u) => options.onMove && options.onMove(u.cursor.idx === undefined ? null : u.cursor.idx, u)],
      setSelect: [(u) => options.onSelect && u.select.width > 2 && options.onSelect(u)],
    },
  };
  const plot = new uPlot(config, [gaps(x), ...series.map((s) => gaps(s.y))], holder);
  plot.options = options;
  holder.plot = plot;
  charts.push(plot);
  new ResizeObserver(() => {
    if (holder.clientWidth > 0 && Math.abs(holder.clientWidth - plot.width) > 1) plot.setSize({ width: holder.clientWidth, height: height });
  }).observe(holder);
  holder.addEventListener('keydown', (event) => (options.onKey ? options.onKey(plot, event) : moveCursor(plot, event)));
  onTheme(() => plot.redraw(false));
  return plot;
}

/** Where an arrow key, Home or End leads among so many places; null for other keys. */
function keyStep(event, now, count) {
  const step = event.shiftKey ? 10 : 1;
  const next = { ArrowRight: now + step, ArrowLeft: now - step, Home: 0, End: count - 1 }[event.key];
  if (next === undefined || !count) return null;
  event.preventDefault();
  return Math.min(Math.max(next, 0), count - 1);
}

/** Arrow keys, Home and End move the cursor along the data. */
function moveCursor(plot, event) {
  const index = keyStep(event, plot.cursor.idx ?? -1, plot.data[0].length);
  if (index === null) return;
  plot.setCursor({ left: plot.valToPos(plot.data[0][index], 'x'), top: plot.bbox.height / devicePixelRatio / 2 });
}

/** A range a little wider than the values, with zero in it if asked. */
function paddedRange(arrays, withZero) {
  let low = withZero ? 0 : Infinity;
  let high = withZero ? 0 : -Infinity;
  for (const array of arrays) for (const v of array) if (Number.isFinite(v)) { if (v < low) low = v; if (v > high) high = v; }
  if (!(low <= high)) return [0, 1];
  const size = Math.max(Math.abs(low), Math.abs(high));
  const pad = (high - low > 1e-9 * size ? high - low : size || 1) * 0.09; // what differs by rounding is the same
  return [withZero && low === 0 ? 0 : low - pad, high + pad];
}

function scaled(values, divisor) { return Float64Array.from(values, (v) => v / divisor); }
