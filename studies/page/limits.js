// SPDX-License-Identifier: Apache-2.0
// Limits of a design and points of a duty on the curves: a bar where the limit is, hatched on the side that breaks it.

import {drawLabel, drawnPlaces, isInside} from './chart.js';
import {data} from './data.js';
import {colour} from './dom.js';
import {rpm} from './units.js';

/** Where a metric without argument lies on a curve of torque: at this speed or torque. */
const axisEnds = {
  stall_torque: {x: 0},
  no_load_speed: {y: 0}
};

/** The speed at which a curve carries a torque, linear between its points. */
function speedAt(curve, torque) {
  for (let i = curve.torque.length - 1; i > 0; --i) {
    const [a, b] = [curve.torque[i - 1], curve.torque[i]];
    if (a >= torque && b <= torque && a > b)
      return curve.speed[i - 1] + ((curve.speed[i] - curve.speed[i - 1]) * (a - torque)) / (a - b);
  }
  return NaN;
}

/** Place of a limit on the chart of a column: {x: rpm, y: unit shown, upright}; null where it is not on it. */
function placeOn(of, column, curve, unit) {
  const value = of.limit;
  const named = data.names[of.metric];
  if (!named) {
    const end = column === 'torque' ? axisEnds[of.metric] : undefined;
    if (!end) return null;
    return end.y === 0 ? {x: value / rpm, y: 0, upright: true} : {x: 0, y: value / unit.divisor, upright: false};
  }
  if (named.metric === 'speed_at' && column === 'torque')
    return {x: value / rpm, y: named.at / unit.divisor, upright: true};
  if (named.metric !== column + '_at' || named.argument === 'both') return null;
  const speed = named.argument === 'speed' ? named.at : speedAt(curve, named.at);
  return Number.isFinite(speed) ? {x: speed / rpm, y: value / unit.divisor, upright: false} : null;
}

/** Those limits of a design that lie on the chart of a column of its curve. */
export function limitsOnCurve(limits, column, curve, unit) {
  return limits.flatMap((limit) => {
    const place = placeOn(limit, column, curve, unit);
    return place ? [{...limit, ...place}] : [];
  });
}

/** Draws them; taken: boxes of labels. */
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
