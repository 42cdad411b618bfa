// SPDX-License-Identifier: Apache-2.0
// What a chart has besides its series: limits and quantiles across it, levels, lines that are no function.

import {drawLabel} from './chart.js';
import {colour} from './dom.js';

/** A line across the chart at a place of its horizontal axis. */
function upright(u, value, name, dash) {
  const x = u.valToPos(value, 'x', true);
  u.ctx.strokeStyle = colour(name);
  u.ctx.lineWidth = (dash ? 1.5 : 2.5) * devicePixelRatio;
  u.ctx.setLineDash(dash ? [5 * devicePixelRatio, 4 * devicePixelRatio] : []);
  u.ctx.beginPath();
  u.ctx.moveTo(x, u.bbox.top);
  u.ctx.lineTo(x, u.bbox.top + u.bbox.height);
  u.ctx.stroke();
}

/** The side of a limit on which motors fail, hatched. */
export function hatch(u, from, to) {
  const {left, top, width, height} = u.bbox;
  const a = Math.min(Math.max(u.valToPos(from, 'x', true), left), left + width);
  const b = Math.min(Math.max(u.valToPos(to, 'x', true), left), left + width);
  if (!(b > a)) return;
  u.ctx.save();
  u.ctx.beginPath();
  u.ctx.rect(a, top, b - a, height);
  u.ctx.clip();
  u.ctx.globalAlpha = 0.35;
  u.ctx.strokeStyle = colour('c1');
  u.ctx.lineWidth = devicePixelRatio;
  u.ctx.beginPath();
  for (let x = a - height; x < b; x += 9 * devicePixelRatio) {
    u.ctx.moveTo(x, top + height);
    u.ctx.lineTo(x + height, top);
  }
  u.ctx.stroke();
  u.ctx.restore();
}

/** Lines through points that lie anywhere. */
export function drawPath(u, {x, y, colour: name, stroke}) {
  u.ctx.save();
  u.ctx.beginPath();
  u.ctx.rect(u.bbox.left, u.bbox.top, u.bbox.width, u.bbox.height);
  u.ctx.clip();
  u.ctx.strokeStyle = colour(name);
  u.ctx.lineWidth = (stroke === 'contour' ? 0.8 : 2) * devicePixelRatio;
  u.ctx.beginPath();
  x.forEach((v, k) => u.ctx.lineTo(u.valToPos(v, 'x', true), u.valToPos(y[k], 'y', true)));
  u.ctx.stroke();
  u.ctx.restore();
}

/** Ranges of the horizontal axis, shaded. */
export function drawShaded(u, stretches) {
  const {left, top, width, height} = u.bbox;
  const [from, to] =
      ['from', 'to'].map((end) => (s) => Math.min(Math.max(u.valToPos(s[end], 'x', true), left), left + width));
  u.ctx.save();
  u.ctx.globalAlpha = 0.25;
  u.ctx.fillStyle = colour('faint');
  for (const s of stretches) u.ctx.fillRect(from(s), top, to(s) - from(s), height);
  u.ctx.restore();
}

/** A dotted line across the chart at each of these marks. */
export function drawDotted(u, marks) {
  const {left, top, width, height} = u.bbox;
  u.ctx.save();
  u.ctx.setLineDash([devicePixelRatio, 3 * devicePixelRatio]);
  u.ctx.strokeStyle = colour('soft');
  u.ctx.lineWidth = devicePixelRatio;
  for (const mark of marks.filter((m) => m.line)) {
    const x = u.valToPos(mark.x, 'x', true);
    if (x < left || x > left + width) continue;
    u.ctx.beginPath();
    u.ctx.moveTo(x, top);
    u.ctx.lineTo(x, top + height);
    u.ctx.stroke();
  }
  u.ctx.restore();
}

/** A level across the chart. */
export function drawLevel(u, value) {
  u.ctx.fillStyle = colour('soft');
  u.ctx.fillRect(u.bbox.left, u.valToPos(value, 'y', true), u.bbox.width, devicePixelRatio);
}

/** The texts of levels, at the right. */
export function nameLevels(u, levels, taken) {
  for (const g of levels)
    if (g.text) drawLabel(u, g.text, u.bbox.left + u.bbox.width, u.valToPos(g.at, 'y', true), taken, []);
}

/** Lines across the chart, limits named above quantiles. */
export function drawGuides(u, guides, taken) {
  const ratio = devicePixelRatio;
  u.ctx.save();
  for (const g of guides) upright(u, g.at, g.kind === 'limit' ? 'c1' : 'ink', g.kind !== 'limit');
  u.ctx.restore();
  const inside = guides.filter((g) => g.text && g.at > u.scales.x.min && g.at < u.scales.x.max);
  const places = inside.flatMap(
      ({at}) => Array.from({length: 12}, (_, i) => [u.valToPos(at, 'x', true), u.bbox.top + 6 * i * ratio]));
  for (const g of inside)
    drawLabel(
        u, g.text, u.valToPos(g.at, 'x', true), u.bbox.top + (g.kind === 'limit' ? 14 : 32) * ratio, taken, places);
}
