// SPDX-License-Identifier: Apache-2.0
'use strict';
// Torque, power and efficiency against speed, one curve or several over each other, and the fields under the cursor.

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
  return Float64Array.from({ length: count }, (_, i) => (last * i) / (count - 1));
}

/** Marks of the metrics on the curve named. */
function curveMarks(curve, name, speedUnit, unit, full) {
  const m = curve.metrics;
  const marks = [];
  const at = (speed, value, text) => {
    if (speed !== null && value !== null && Number.isFinite(value)) marks.push({ x: speed / speedUnit.divisor, y: value / unit.divisor, text: full ? text : '', small: !full });
  };
  if (name === 'torque') {
    at(0, m.stall_torque, 'stall ' + engineering(m.stall_torque, 'N.m', 3));
    const begin = curve.torque.findIndex(Number.isFinite);
    if (begin > 0 && m.pull_out_torque) at(curve.speed[begin], curve.torque[begin], 'pull-out ' + engineering(m.pull_out_torque, 'N.m', 3));
    if (m.plateau_speed > 0) at(m.plateau_speed, resampled(curve, 'torque', [m.plateau_speed])[0], 'plateau to ' + engineering(m.plateau_speed, 'rad/s', 3));
    if (m.peak_power > 0) at(m.speed_at_peak_power, m.torque_at_peak_power, full ? 'peak power' : '');
    if (m.no_load_speed > 0) at(m.no_load_speed, 0, 'no load ' + engineering(m.no_load_speed, 'rad/s', 3));
  }
  if (name === 'output_power' && m.peak_power > 0) at(m.speed_at_peak_power, m.peak_power, 'peak ' + engineering(m.peak_power, 'W', 3) + ' at ' + engineering(m.speed_at_peak_power, 'rad/s', 3));
  return marks;
}

function readout(node, parts) {
  node.replaceChildren(...parts.filter(([, value]) => value).flatMap(([name, value], i) => [(i ? ', ' : '') + name + ' ', el('b', {}, value)]));
}

/** One quantity of several curves over speed. */
function curvesChart(node, list, names, name, label, options = {}) {
  const speeds = commonSpeeds(list);
  const speedUnit = displayUnit(1, 'rad/s');
  const unit = options.unit || displayUnit(largest(list.map((c) => c[name])), unitOfCurve(name));
  const series = list.map((c, i) => ({ name: names[i], y: scaled(resampled(c, name, speeds), unit.divisor), colour: seriesColours[i % 7], dash: seriesDash(i) }));
  const marks = list.flatMap((c, i) => curveMarks(c, name, speedUnit, unit, list.length <= 2 && (list.length === 1 || i === 1)).map((m) => ({ ...m, colour: list.length > 1 ? seriesColours[i % 7] : null })));
  const read = el('div', { class: 'read', 'aria-live': 'polite' });
  const plot = chart(node, scaled(speeds, speedUnit.divisor), series, {
    name: label, x: { label: 'speed [rpm]', range: [0, speeds[speeds.length - 1] / speedUnit.divisor] }, y: { label: axisLabel(label, unit), range: options.range || paddedRange(series.map((s) => s.y), true) },
    marks, height: options.height || 300,
    onMove: (i) => {
      if (i === null) { read.replaceChildren(); return; }
      readout(read, [['at', engineering(speeds[i], 'rad/s')], ...series.filter((s) => Number.isFinite(s.y[i])).map((s) => [s.name, rounded(s.y[i]) + ' ' + unit.text])]);
      if (options.onSpeed) options.onSpeed(speeds[i]);
    },
  });
  node.append(read);
  return plot;
}

function unitOfCurve(name) {
  return { torque: 'N.m', amplitude: 'm', phase_lag: 'rad', voltage: 'V', phase_current: 'A', power_factor: '1', overall_efficiency: '1', wear_intensity: 'W/m^2', contact_efficiency: '1', efficiency: '1', stick_fraction: '1', speed: 'rad/s' }[name] || 'W';
}

const percentUnit = { text: '%', divisor: 0.01 };

/** Output and losses of one curve. */
function powerChart(node, curve, onSpeed) {
  /** @type {any[][]} */
  const parts = [['output_power', 'output', 'c0'], ['friction_power', 'friction loss', 'c1', [7, 4]], ['layer_loss', 'layer loss', 'c2', [2, 3]]];
  if (largest([curve.stator_loss]) > 0) parts.push(['stator_loss', 'stator loss', 'c3', [10, 3, 2, 3]]);
  const unit = displayUnit(largest(parts.map(([name]) => curve[name])), 'W');
  const series = parts.map(([name, label, c, dash]) => ({ name: label, y: scaled(curve[name], unit.divisor), colour: c, dash }));
  const speeds = scaled(curve.speed, Math.PI / 30);
  const read = el('div', { class: 'read', 'aria-live': 'polite' });
  node.append(legend(series.map((s) => ({ name: s.name, colour: s.colour, kind: s.dash ? 'dash' : '' }))));
  chart(node, speeds, series, {
    name: 'power', x: { label: 'speed [rpm]', range: [0, speeds[speeds.length - 1]] }, y: { label: axisLabel('power', unit), range: paddedRange(series.map((s) => s.y), true) },
    marks: curveMarks(curve, 'output_power', { divisor: Math.PI / 30 }, unit, true), height: 300,
    onMove: (i) => {
      if (i === null) { read.replaceChildren(); return; }
      readout(read, [['at', rounded(speeds[i]) + ' rpm'], ...series.map((s) => [s.name, rounded(s.y[i]) + ' ' + unit.text])]);
      if (onSpeed) onSpeed(curve.speed[i]);
    },
  });
  node.append(read);
}

/** Where the electrical power of one curve goes: output and losses stacked, up to no-load. */
function terminalsChart(node, curve, onSpeed) {
  const parts = [['output_power', 'output', 'c0'], ['friction_power', 'friction', 'c1'], ['layer_loss', 'layer', 'c2'], ['stator_loss', 'stator', 'c3'], ['dielectric_loss', 'ceramic', 'c6']];
  const unit = displayUnit(largest([curve.electrical_power]), 'W');
  const sums = new Float64Array(curve.speed.length);
  const series = parts.map(([name, label, c], k) => {
    for (let i = 0; i < sums.length; ++i) sums[i] += curve.output_power[i] >= 0 ? curve[name][i] : NaN;
    return { name: label, y: scaled(sums, unit.divisor), colour: c, area: k === 0, part: curve[name] };
  });
  const bands = series.slice(1).map((s, k) => ({ series: [k + 2, k + 1], fill: () => colour(s.colour) + 'aa' }));
  const speeds = scaled(curve.speed, Math.PI / 30);
  const read = el('div', { class: 'read', 'aria-live': 'polite' });
  node.append(legend(series.map((s) => ({ name: s.name, colour: s.colour, kind: 'area' }))));
  chart(node, speeds, series, {
    name: 'electrical power', x: { label: 'speed [rpm]', range: [0, speeds[speeds.length - 1]] }, y: { label: axisLabel('electrical power', unit), range: paddedRange(series.map((s) => s.y), true) }, bands, height: 300,
    onMove: (i) => {
      if (i === null) { read.replaceChildren(); return; }
      readout(read, [['at', rounded(speeds[i]) + ' rpm'], ...series.map((s) => [s.name, engineering(s.part[i], 'W')])]);
      if (onSpeed) onSpeed(curve.speed[i]);
    },
  });
  node.append(read);
}

function efficiencyChart(node, list, names, onSpeed) {
  if (list.every(atTerminals)) { curvesChart(node, list, names, 'overall_efficiency', 'overall efficiency', { unit: percentUnit, range: [0, 100], onSpeed }); return; }
  const damped = list.some((c) => largest([c.stator_loss]) > 0);
  const name = damped ? 'efficiency' : 'contact_efficiency';
  // Where the rotor is driven from outside nothing comes out: 0, as the overall efficiency has it, so that the line ends there.
  const shown = list.map((c) => ({ ...c, [name]: Array.from(c[name], (value, i) => (c.output_power[i] <= 0 ? 0 : value)) }));
  curvesChart(node, shown, names, name, damped ? 'efficiency' : 'contact efficiency', { unit: percentUnit, range: [0, 100], onSpeed });
}

/** Everything about several curves: charts, fields, metrics. The first name of a family of one is the motor's. */
function curveSection(list, names, title, note) {
  const shown = list.length - 1;
  const torque = card(title || 'Torque', note || 'Move along the curve with the mouse, a finger, or the arrow keys: the fields in the contact follow.', 'half');
  let viewer = null;
  const onSpeed = (speed) => viewer && viewer.show(speed);
  if (list.length > 1) torque.append(legend(names.map(seriesEntry)));
  curvesChart(torque, list, names, 'torque', 'torque', { onSpeed });
  const terminals = list.every(atTerminals);
  if (list.length === 1 && terminals) terminalsChart(card('Electrical power', 'What the terminals take and where it goes, between the beginning of the curve and no-load.', 'half'), list[0], onSpeed);
  else if (list.length === 1) powerChart(card('Power and losses', 'What the contact gives to the rotor, and where the rest goes.', 'half'), list[0], onSpeed);
  else {
    const power = card('Output power', 'Peak power is marked.', 'half');
    power.append(legend(names.map(seriesEntry)));
    curvesChart(power, list, names, 'output_power', 'output power', { onSpeed });
  }
  const damped = list.some((c) => largest([c.stator_loss]) > 0);
  const efficiency = terminals ? card('Overall efficiency', 'Output over electrical power, every loss counted but that of the driver.', 'half')
    : card(damped ? 'Efficiency' : 'Contact efficiency', damped ? 'Of the whole motor: power lost in the vibrating stator is counted.' : 'Of the contact alone: the motor names no modal damping, so that the stator loses nothing.', 'half');
  if (list.length > 1) efficiency.append(legend(names.map(seriesEntry)));
  efficiencyChart(efficiency, list, names, onSpeed);
  if (list.length > 1) {
    const losses = card('Friction loss', 'Power that wears the contact.', 'half');
    losses.append(legend(names.map(seriesEntry)));
    curvesChart(losses, list, names, 'friction_power', 'friction loss', { onSpeed });
  } else {
    const wear = card('Wear intensity', 'Friction power for each area of the track.', 'half');
    curvesChart(wear, list, names, 'wear_intensity', 'wear intensity', { onSpeed });
  }
  if (terminals) terminalCards(list, names, onSpeed);
  viewer = fieldsSection(list, names, shown);
  card('Points of the curves', null, 'wide').append(el('details', {}, el('summary', {}, 'All ' + list.length * list[0].speed.length + ' points'), pointsTable(list, names)));
}

/** The wave and the current, which follow from voltage and load. */
function terminalCards(list, names, onSpeed) {
  for (const [name, title, note] of [['amplitude', 'Wave amplitude', 'At the contact radius.'], ['phase_current', 'Current of a phase', 'Root mean square.'], ['phase_lag', 'Phase lag', 'Of the wave behind the voltage.'], ['power_factor', 'Power factor', 'Electrical over apparent power of a phase.']]) {
    const node = card(title, note, 'half');
    if (list.length > 1) node.append(legend(names.map(seriesEntry)));
    curvesChart(node, list, names, name, title.toLowerCase(), { onSpeed });
  }
}

function pointsTable(list, names) {
  const own = ['speed', 'torque', 'output_power', 'friction_power', 'layer_loss', 'stator_loss', 'contact_efficiency', 'wear_intensity', 'stick_fraction'];
  const shown = list.every(atTerminals) ? [...own, ...terminalColumns] : own;
  const lines = [];
  list.forEach((c, k) => c.speed.forEach((_, i) => lines.push([words(names[k]), ...shown.map((n) => quantity(c[n][i], unitOfCurve(n)))])));
  return table('curve', ['curve', ...shown.map(plain)], lines, ['curve', ...shown.map((n) => n + ' [' + unitOfCurve(n) + ']')]);
}
