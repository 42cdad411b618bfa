// SPDX-License-Identifier: Apache-2.0
// Limits at points of a chart: a bar where the limit is, hatched on the side that breaks it.

import {drawLabel, drawnPlaces, isInside} from './chart.js';
import {colour} from './dom.js';

/** Draws limits {x, y, upright, least, broken, text}; taken: boxes of labels. */
export function drawLimits(u, limits, taken) {
  const ratio = devicePixelRatio;
  const {ctx} = u;
  const points = limits.length ? drawnPlaces(u) : [];
  const half = 17 * ratio;
  for (const limit of limits) {
    const x = u.valToPos(limit.x, 'x', true);
    const y = u.valToPos(limit.y, 'y', true);
    if (!isInside(u, limit.x, limit.y)) continue;
    const from = x - half < u.bbox.left && !limit.upright ? 0 : -half;  // beside the axis, not on its numbers
    // A bar across the direction of the quantity, teeth on the side of worse values.
    const [ux, uy] = limit.upright ? [0, 1] : [1, 0];
    const worse = (limit.least ? 1 : -1) * 6 * ratio;
    const [tx, ty] = limit.upright ? [-worse, 0] : [-Math.abs(worse) / 2, worse];
    ctx.save();
    ctx.setLineDash([]);
    ctx.strokeStyle = colour(limit.broken ? 'bad' : 'ink');
    ctx.lineWidth = 2 * ratio;
    ctx.beginPath();
    ctx.moveTo(x + ux * from, y + uy * from);
    ctx.lineTo(x + ux * half, y + uy * half);
    for (let at = from; at <= half; at += half / 2) {
      ctx.moveTo(x + ux * at, y + uy * at);
      ctx.lineTo(x + ux * at + tx, y + uy * at + ty);
    }
    ctx.stroke();
    ctx.restore();
    drawLabel(u, limit.text, x, y, taken, points);
  }
}
