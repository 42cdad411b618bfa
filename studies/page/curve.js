// SPDX-License-Identifier: Apache-2.0
// Torque, power and efficiency against speed, one curve or several over each other, and the fields under the cursor.

import {drawSqueals, paddedRange, scaled} from './chart.js';
import {atTerminals, terminalColumns} from './data.js';
import {card, colour, el, seriesColours, seriesDash} from './dom.js';
import {fieldsSection} from './fields.js';
import {figure, keepFocus} from './figure.js';
import {drawLimits, limitsOnCurve} from './limits.js';
import {shortName} from './names.js';
import {quantity, table, words} from './table.js';
import {displayUnit, engineering, largest, rounded, rpm} from './units.js';
import {axisLabel} from './words.js';

export const percentUnit = {
  text: '%',
  typed: '%',
  divisor: 0.01
};

/** Values of a curve at the speeds of a common axis: linear between its points, nothing beyond them. */
function resampled(curve, name, speeds) {
  const from = curve.speed;
  const last = from.length - 1;
  const step = from[last] / last;
  return Float64Array.from(speeds, (speed) => {
    const place = speed / step;
    const i = Math.min(Math.floor(place), last - 1);
    if (place > last + 1e-9 || i < 0) return NaN;
    const share = place - i;
    return curve[name][i] * (1 - share) + curve[name][i + 1] * share;
  });
}

function commonSpeeds(list) {
  const last = Math.max(...list.map((c) => c.speed[c.speed.length - 1]));
  const count = list.length === 1 ? list[0].speed.length : 301;
  return Float64Array.from({length: count}, (_, i) => (last * i) / (count - 1));
}

/** Places that a curve of torque is known by, with their names: [speed, torque, text] */
function torqueMarks(curve) {
  const m = curve.metrics;
  const places =
      m.stall_torque === undefined ? [] : [[0, m.stall_torque, 'stall ' + engineering(m.stall_torque, 'N.m', 3)]];
  const begin = curve.torque.findIndex(Number.isFinite);
  if (begin > 0 && m.pull_out_torque)
    places.push([curve.speed[begin], curve.torque[begin], 'pull-out ' + engineering(m.pull_out_torque, 'N.m', 3)]);
  if (m.plateau_speed > 0) {
    const [torque] = resampled(curve, 'torque', [m.plateau_speed]);
    places.push([m.plateau_speed, torque, 'plateau to ' + engineering(m.plateau_speed, 'rad/s', 3)]);
  }
  if (m.peak_power > 0) places.push([m.speed_at_peak_power, m.torque_at_peak_power, 'peak power']);
  if (m.no_load_speed > 0) places.push([m.no_load_speed, 0, 'no load ' + engineering(m.no_load_speed, 'rad/s', 3)]);
  return places;
}

function powerMarks({metrics: m}) {
  if (!(m.peak_power > 0)) return [];
  const at = engineering(m.peak_power, 'W', 3) + ' at ' + engineering(m.speed_at_peak_power, 'rad/s', 3);
  return [[m.speed_at_peak_power, m.peak_power, 'peak ' + at]];
}

/** Marks of the metrics on the curve of a column; full: with their names. */
function curveMarks(curve, name, unit, full) {
  const places = {torque: torqueMarks, output_power: powerMarks}[name]?.(curve) ?? [];
  return places.filter(([x, y]) => x !== null && y !== null)
      .map(([x, y, text]) => ({x: x / rpm, y: y / unit.divisor, text: full ? text : '', small: !full}));
}

/** Series of curves; one with a `tint` has the colour of the curve of that number, and is dashed. */
function seriesOf(list, names, name, speeds, unit) {
  return list.map((c, i) => ({
                    name: names[i],
                    y: scaled(resampled(c, name, speeds), unit.divisor),
                    colour: seriesColours[(c.tint ?? i) % 7],
                    dash: c.tint === undefined ? seriesDash(i) : [7, 4]
                  }));
}

/**
 * A chart over the speed.
 * options: as of figure(); unit: of the values; onSpeed(speed): called with the speed under the cursor
 */
function speedChart(node, speeds, series, options) {
  const x = scaled(speeds, rpm);
  const {name, unit, tell, onSpeed} = options;
  return figure(node, x, series, {
    x: {label: 'speed [rpm]', range: [0, x[x.length - 1]]},
    y: {label: axisLabel(name, unit), range: paddedRange(series.map((s) => s.y), true)},
    height: 300,
    ...options,
    tell: (i) => [['at', engineering(speeds[i], 'rad/s')], ...tell(i)],
    onMove: (i) => {
      if (i !== null && onSpeed) onSpeed(speeds[i]);
    }
  });
}

/** One quantity of several curves over speed; limits: those of a design, drawn where they lie on this chart. */
export function curvesChart(node, list, names, name, label, options = {}) {
  const speeds = commonSpeeds(list);
  const unit = options.unit || displayUnit(largest(list.map((c) => c[name])), unitOfCurve(name));
  const series = seriesOf(list, names, name, speeds, unit);
  const own = list.filter((c) => c.tint === undefined);
  const last = own.length - 1;
  const tinted = list.length > 1;
  const marksOf = (c, i) => curveMarks(c, name, unit, last < 2 && i === last);
  const marks = own.flatMap((c, i) => marksOf(c, i).map((m) => ({...m, colour: tinted ? seriesColours[i % 7] : null})));
  const limits = limitsOnCurve(options.limits ?? [], name, list[last], unit);
  const range = options.range ?? paddedRange([...series.map((s) => s.y), limits.map((l) => l.y)], true);
  const squeals = name === 'torque' && own.some((c) => c.squeals.length);
  const lines = tinted ? series.map((s) => ({name: s.name, colour: s.colour, kind: s.dash ? 'dash' : ''})) : [];
  const entries = squeals ? [...lines, {name: 'squeals', colour: tinted ? 'soft' : 'c0', kind: 'broad'}] : lines;
  const told = (i) =>
      series.filter((s) => Number.isFinite(s.y[i])).map((s) => [s.name, rounded(s.y[i]) + ' ' + unit.text]);
  return speedChart(node, speeds, series, {
    name: label,
    unit,
    marks,
    title: options.title,
    legend: entries.length ? entries : null,
    height: options.height ?? 300,
    y: {label: axisLabel(label, unit), range},
    ground: (u) => squeals && drawSqueals(u, own.map((c) => c.squeals)),
    front: (u, taken) => drawLimits(u, limits, taken),
    tell: told,
    buttons: options.buttons,
    onSpeed: options.onSpeed
  });
}

const curveUnits = {
  torque: 'N.m',
  amplitude: 'm',
  phase_lag: 'rad',
  voltage: 'V',
  phase_current: 'A',
  wear_intensity: 'W/m^2',
  speed: 'rad/s'
};
const shares = ['power_factor', 'overall_efficiency', 'contact_efficiency', 'efficiency', 'stick_fraction'];

/** SI unit of a column of a curve. */
function unitOfCurve(name) { return curveUnits[name] ?? (shares.includes(name) ? '1' : 'W'); }

/** Output and losses of one curve. */
function powerChart(node, curve, onSpeed) {
  /** @type {any[][]} */
  const parts = [
    ['output_power', 'output', 'c0'], ['friction_power', 'friction loss', 'c1', [7, 4]],
    ['layer_loss', 'layer loss', 'c2', [2, 3]]
  ];
  if (largest([curve.stator_loss]) > 0) parts.push(['stator_loss', 'stator loss', 'c3', [10, 3, 2, 3]]);
  const unit = displayUnit(largest(parts.map(([name]) => curve[name])), 'W');
  const series =
      parts.map(([name, label, c, dash]) => ({name: label, y: scaled(curve[name], unit.divisor), colour: c, dash}));
  speedChart(node, curve.speed, series, {
    name: 'power',
    unit,
    legend: series.map((s) => ({name: s.name, colour: s.colour, kind: s.dash ? 'dash' : ''})),
    marks: curveMarks(curve, 'output_power', unit, true),
    tell: (i) => series.map((s) => [s.name, rounded(s.y[i]) + ' ' + unit.text]),
    onSpeed
  });
}

/** Where the electrical power of one curve goes: output and losses stacked, up to no-load. */
function terminalsChart(node, curve, onSpeed) {
  const parts = [
    ['output_power', 'output', 'c0'], ['friction_power', 'friction', 'c1'], ['layer_loss', 'layer', 'c2'],
    ['stator_loss', 'stator', 'c3'], ['dielectric_loss', 'ceramic', 'c6']
  ];
  if (curve.driver_loss) parts.push(['driver_loss', 'driver', 'c5']);
  const unit = displayUnit(largest([curve.electrical_power]), 'W');
  const sums = new Float64Array(curve.speed.length);
  const series = parts.map(([name, label, c], k) => {
    for (let i = 0; i < sums.length; ++i) sums[i] += curve.output_power[i] >= 0 ? curve[name][i] : NaN;
    return {name: label, y: scaled(sums, unit.divisor), colour: c, area: k === 0, part: curve[name]};
  });
  speedChart(node, curve.speed, series, {
    name: 'electrical power',
    unit,
    legend: series.map((s) => ({name: s.name, colour: s.colour, kind: 'area'})),
    bands: series.slice(1).map((s, k) => ({series: [k + 2, k + 1], fill: () => colour(s.colour) + 'aa'})),
    tell: (i) => series.map((s) => [s.name, engineering(s.part[i], 'W')]),
    onSpeed
  });
}

const terminalCharts = [
  ['amplitude', 'Wave amplitude', 'At the contact radius.'],
  ['phase_current', 'Current of a phase', 'Root mean square.'],
  ['phase_lag', 'Phase lag', 'Lag of the wave behind the voltage.'],
  ['power_factor', 'Power factor', 'Electrical power over apparent power of a phase.']
];

/**
 * Charts of several curves with the fields in the contact, which follow the cursor. The last curve is the one asked.
 */
export class CurveSection {
  constructor(list, names) {
    this.list = list;
    this.names = names;
    this.viewer = null;
    this.onSpeed = (speed) => this.viewer?.show(speed);
  }

  /** The torque alone; limits: those of the design of the last curve. */
  torque(node, title, limits) {
    const follow = 'Point at the curve or use the arrow keys to see the fields in the contact; drag to zoom.';
    const holder = el('div', {});
    node.append(el('p', {}, follow), holder);
    this.limits = limits ?? [];
    this.drawTorque(holder, title, false);
  }

  /** compare: also with one slice, of the motors whose track has width */
  drawTorque(holder, title, compare) {
    const wide = this.list.flatMap((c, tint) => (c.one_slice_torque ? [{...c, tint}] : []));
    const text = 'Compare with one slice';
    const press = () => keepFocus(holder, text, () => this.drawTorque(holder, title, !compare));
    const button = el('button', {type: 'button', 'aria-pressed': String(compare), onclick: press}, text);
    const slices = compare ? wide.map((c) => ({...c, torque: c.one_slice_torque})) : [];
    const names = slices.map((c) => this.names[c.tint] + ', one slice');
    holder.replaceChildren();
    curvesChart(
        holder, [...this.list, ...slices], [...this.names, ...names], 'torque', 'torque',
        {title, limits: this.limits, height: 360, onSpeed: this.onSpeed, buttons: wide.length ? [button] : []});
  }

  /** One quantity of all curves in half a row. */
  half(name, title, note, options = {}) {
    const shown = {title, limits: this.limits, onSpeed: this.onSpeed, ...options};
    curvesChart(card(title, note, 'half'), options.list ?? this.list, this.names, name, title.toLowerCase(), shown);
  }

  power() {
    if (this.list.length > 1) return this.half('output_power', 'Output power', 'Peak power is marked.');
    const [curve] = this.list;
    const losses = 'Output power of the rotor, and the losses.';
    const taken = 'Electrical power at the terminals: output and losses, up to no-load.';
    if (atTerminals(curve)) return terminalsChart(card('Electrical power', taken, 'half'), curve, this.onSpeed);
    return powerChart(card('Power and losses', losses, 'half'), curve, this.onSpeed);
  }

  /** What comes out over what goes in, with what is counted said. */
  efficiency() {
    const share = {unit: percentUnit, range: [0, 100]};
    if (this.list.every(atTerminals)) {
      const note = 'Output power over electrical power, with all losses except that of the driver.';
      return this.half('overall_efficiency', 'Overall efficiency', note, share);
    }
    const damped = this.list.some((c) => largest([c.stator_loss]) > 0);
    const name = damped ? 'efficiency' : 'contact_efficiency';
    // Where the rotor is driven from outside nothing comes out: 0, as the overall efficiency has it, so that the line
    // ends there.
    const ended = (c) => Array.from(c[name], (value, i) => (c.output_power[i] <= 0 ? 0 : value));
    const list = this.list.map((c) => ({...c, [name]: ended(c)}));
    const note = damped ? 'Output power over input power, with the losses of the contact and of the vibrating stator.' :
                          'Output power over the power to the contact; without modal damping the stator has no loss.';
    return this.half(name, damped ? 'Efficiency' : 'Contact efficiency', note, {...share, list});
  }

  /** Powers, losses, fields and the table of points. */
  others() {
    this.power();
    this.efficiency();
    if (this.list.length > 1) this.half('friction_power', 'Friction loss', 'Power that wears the contact.');
    this.half('wear_intensity', 'Wear intensity', 'Friction power per area of the track.');
    if (this.list.every(atTerminals))
      for (const [name, title, note] of terminalCharts) this.half(name, title, note);
    this.viewer = fieldsSection(this.list, this.names, this.list.length - 1);
    this.points();
  }

  /** Everything about the curve of the study's motor. */
  whole() {
    this.torque(card('The motor', null, 'wide'), 'The motor', []);
    this.others();
  }

  points() {
    const own = [
      'speed', 'torque', 'output_power', 'friction_power', 'layer_loss', 'stator_loss', 'contact_efficiency',
      'wear_intensity', 'stick_fraction'
    ];
    const shown = this.list.every(atTerminals) ? [...own, ...terminalColumns] : own;
    const line = (c, k, i) => [words(this.names[k]), ...shown.map((n) => quantity(c[n][i], unitOfCurve(n)))];
    const lines = this.list.flatMap((c, k) => Array.from(c.speed, (_, i) => line(c, k, i)));
    const header = ['curve', ...shown.map((n) => n + ' [' + unitOfCurve(n) + ']')];
    card('Points of the curves', null, 'wide')
        .append(
            el('details', {}, el('summary', {}, 'All ' + lines.length + ' points'),
               table('curve', ['curve', ...shown.map(shortName)], lines, header)));
  }
}
