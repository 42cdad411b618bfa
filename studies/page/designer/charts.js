// SPDX-License-Identifier: Apache-2.0
// Torque, powers and efficiency over speed, drawn anew with every move.

import {chart, drawMarks} from '../chart.js';
import {colour, el} from '../dom.js';
import {displayUnit, engineering, largest, noBreak, rounded, rpm} from '../units.js';

/** Numbers as uPlot takes them: in the unit shown, gaps where there is no answer. */
function drawn(values, divisor, shown = null) {
  return Array.from(values, (v, i) => (Number.isFinite(v) && (shown === null || shown[i] >= 0) ? v / divisor : null));
}

/** Range of an axis from 0 to a little above what is drawn. */
function fromZero(lists) {
  let high = 0;
  let low = 0;
  for (const list of lists)
    for (const v of list) {
      if (v !== null && v > high) high = v;
      if (v !== null && v < low) low = v;
    }
  return [low < 0 ? low * 1.05 : 0, high > 0 ? high * 1.12 : 1];
}

/** Values of a curve at a speed: linear between its points. */
function curveAt(curve, name, speed) {
  const last = curve.speed.length - 1;
  const place = (speed / curve.speed[last]) * last;
  if (!(place >= 0 && place <= last)) return NaN;
  const i = Math.min(Math.floor(place), last - 1);
  return curve[name][i] + (place - i) * (curve[name][i + 1] - curve[name][i]);
}

/** A chart whose lines follow the motor, and the pinned motor dashed beside it. */
export class LiveChart {
  /**
   * @param {{name: string, unit: string, lines: {column: string, name: string, colour: string}[], top?: number, height:
   *     number, ground?: Function, front?: Function}} shape
   * @param {import('./panel.js').DesignerPanel} panel
   */
  constructor(node, shape, panel) {
    this.shape = shape;
    this.panel = panel;
    this.unit = {text: '', divisor: 1};
    const lines = shape.lines.flatMap(
        (line) =>
            [{name: line.name, y: [], colour: line.colour},
             {name: line.name + ', pinned', y: [], colour: line.colour, dash: [3, 5]}]);
    this.read = el('div', {class: 'read'});
    this.plot = chart(node, [], lines, {
      name: shape.name,
      height: shape.height,
      x: {label: 'speed [rpm]', range: () => this.xRange ?? [0, 1]},
      y: {label: shape.name, range: () => this.yRange ?? [0, 1]},
      ground: (u) => this.ground(u),
      front: (u) => this.front(u),
      onMove: (i) => this.readAt(i),
      onKey: (_, event) => panel.speedKey(event),
    });
    node.append(this.read);
    this.follow();
  }

  /** A press or a drag on the chart chooses the speed of the fields. */
  follow() {
    const over = this.plot.over;
    const go = (event) => {
      if (event.buttons || event.type === 'pointerdown')
        this.panel.setSpeed(this.plot.posToVal(event.clientX - over.getBoundingClientRect().left, 'x') * rpm);
    };
    over.addEventListener('pointerdown', go);
    over.addEventListener('pointermove', go);
  }

  show(curve, pinned) {
    const {lines, unit, top} = this.shape;
    this.curve = curve;
    this.unit = unit === '%' ?
        percentShown :
        displayUnit(
            largest([...lines.map((l) => curve[l.column]), ...(pinned ? lines.map((l) => pinned[l.column]) : [])]),
            unit);
    const of = (c, line) => drawn(c[line.column], this.unit.divisor, unit === '%' ? c.output_power : null);
    const other = pinned ? resampledCurve(pinned, lines.map((l) => l.column), curve.speed) : null;
    const columns = lines.flatMap(
        (line) =>
            [of(curve, line),
             other                  ? of(other, line) :
                 curve.speed.length ? new Array(curve.speed.length).fill(null) :
                                      []]);
    const speeds = Array.from(curve.speed, (v) => v / rpm);
    this.xRange = [0, speeds[speeds.length - 1] || 1];
    this.yRange = top ? [0, top] : fromZero(columns);
    if (this.plot.axes[1].label !== axisText(this.shape.name, this.unit))
      this.plot.axes[1].label = axisText(this.shape.name, this.unit);
    this.plot.setData([speeds, ...columns]);
  }

  readAt(i) {
    if (i === null || i === undefined || !this.curve) {
      this.read.replaceChildren();
      return;
    }
    const parts =
        this.shape.lines.map((line, k) => [line.name, this.plot.data[1 + 2 * k][i]]).filter(([, v]) => v !== null);
    this.read.replaceChildren(
        'at ', el('b', {}, rounded(this.plot.data[0][i]) + noBreak + 'rpm'),
        ...parts.flatMap(([name, v]) => [', ' + name + ' ', el('b', {}, rounded(v) + noBreak + this.unit.text)]));
  }

  ground(u) {
    if (this.shape.ground) this.shape.ground(u, this);
  }

  front(u) {
    drawUpright(u, this.panel.state.view.speed / rpm);
    if (this.shape.front) this.shape.front(u, this);
  }
}

const percentShown = {
  text: '%',
  divisor: 0.01
};
export function axisText(name, unit) { return name + (unit.text ? ' [' + unit.text + ']' : ''); }

/** Columns of a curve at the speeds of another. */
function resampledCurve(curve, names, speeds) {
  const all = [...new Set([...names, 'output_power'])];
  return Object.fromEntries(
      all.map((name) => [name, Float64Array.from(speeds, (speed) => curveAt(curve, name, speed))]));
}

/** A dashed line across a plot. */
export function drawUpright(u, place) {
  if (!Number.isFinite(place)) return;
  const x = u.valToPos(place, 'x', true);
  if (x < u.bbox.left || x > u.bbox.left + u.bbox.width) return;
  const ctx = u.ctx;
  ctx.save();
  ctx.strokeStyle = colour('ink');
  ctx.lineWidth = 1.5 * devicePixelRatio;
  ctx.setLineDash([4 * devicePixelRatio, 4 * devicePixelRatio]);
  ctx.beginPath();
  ctx.moveTo(x, u.bbox.top);
  ctx.lineTo(x, u.bbox.top + u.bbox.height);
  ctx.stroke();
  ctx.restore();
}

/** A forbidden region: hatched, in the colour of warnings. */
function drawForbidden(u, left, right, low, high) {
  const [x0, x1] =
      [left, right].map((v) => Math.min(Math.max(u.valToPos(v, 'x', true), u.bbox.left), u.bbox.left + u.bbox.width));
  const [y0, y1] =
      [high, low].map((v) => Math.min(Math.max(u.valToPos(v, 'y', true), u.bbox.top), u.bbox.top + u.bbox.height));
  if (!(x1 > x0 && y1 > y0)) return;
  const ctx = u.ctx;
  const step = 9 * devicePixelRatio;
  ctx.save();
  ctx.beginPath();
  ctx.rect(x0, y0, x1 - x0, y1 - y0);
  ctx.clip();
  ctx.setLineDash([]);
  ctx.strokeStyle = colour('bad');
  ctx.globalAlpha = 0.45;
  ctx.lineWidth = 1.2 * devicePixelRatio;
  ctx.strokeRect(x0, y0, x1 - x0, y1 - y0);
  ctx.beginPath();
  for (let x = x0 - (y1 - y0); x < x1; x += step) {
    ctx.moveTo(x, y1);
    ctx.lineTo(x + (y1 - y0), y0);
  }
  ctx.stroke();
  ctx.restore();
}

/** Regions that limits forbid, in a chart of torque over speed: the curve has to pass outside. */
function forbiddenRegions(limits, curve) {
  const last = curve.speed[curve.speed.length - 1];
  const thin = 0.012;
  return limits.flatMap((l) => {
    const least = l.sense === '>=';
    if (l.metric === 'torque_at' && l.argument === 'speed')
      return [least ? [0, l.at, 0, l.value] : [l.at, last, l.value, Infinity]];
    if (l.metric === 'speed_at' && l.argument === 'torque')
      return [least ? [0, l.value, 0, l.at] : [l.value, last, l.at, Infinity]];
    if (l.metric === 'stall_torque' || l.metric === 'max_torque')
      return [least ? [0, thin * last, 0, l.value] : [0, last, l.value, Infinity]];
    if (l.metric === 'no_load_speed') return [least ? [0, l.value, 0, null] : [l.value, last, 0, Infinity]];
    return [];
  });
}

export function drawRegions(u, shown, limits) {
  const [, top] = u.scales.y ? [u.scales.y.min, u.scales.y.max] : [0, 1];
  for (const [left, right, low, high] of forbiddenRegions(limits, shown.curve)) {
    const up = high === null ? 0.025 * top : high === Infinity ? top : high / shown.unit.divisor;
    drawForbidden(u, left / rpm, right / rpm, low / shown.unit.divisor, up);
  }
}

/** Places of the load across the plot, near enough to each other that no label falls between them [canvas pixels]. */
function loadLine(u, shown, load) {
  const {min, max} = u.scales.x;
  return Array.from({length: 101}, (_, i) => {
    const speed = min + ((max - min) * i) / 100;
    const torque = load.rest + load.rise * speed * rpm;
    return [u.valToPos(speed, 'x', true), u.valToPos(torque / shown.unit.divisor, 'y', true)];
  });
}

/** The load and the point at which motor and load meet. */
export function drawLoad(u, shown, load, point) {
  if (!(load.rest || load.rise)) return;
  const ctx = u.ctx;
  const line = loadLine(u, shown, load);
  ctx.save();
  ctx.beginPath();
  ctx.rect(u.bbox.left, u.bbox.top, u.bbox.width, u.bbox.height);
  ctx.clip();
  ctx.strokeStyle = colour('c6');
  ctx.lineWidth = 2 * devicePixelRatio;
  ctx.setLineDash([8 * devicePixelRatio, 4 * devicePixelRatio]);
  ctx.beginPath();
  for (const [x, y] of line) ctx.lineTo(x, y);
  ctx.stroke();
  ctx.restore();
  if (!point) return;
  const text = engineering(point.torque, 'N.m', 3) + ' at ' + engineering(point.speed, 'rad/s', 3);
  drawMarks(u, [{x: point.speed / rpm, y: point.torque / shown.unit.divisor, colour: 'c6', text}], [], line);
}
