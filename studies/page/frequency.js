// SPDX-License-Identifier: Apache-2.0
// Responses over the frequency of the drive: stable waves solid, unstable ones dashed, jumps in a table.

import {paddedRange, scaled} from './chart.js';
import {percentUnit} from './curve.js';
import {data, summary, unitOf} from './data.js';
import {card, seriesColours} from './dom.js';
import {figure} from './figure.js';
import {capital} from './names.js';
import {quantity, table, words} from './table.js';
import {displayUnit, engineering, largest, rounded} from './units.js';
import {axisLabel, memberText, plain} from './words.js';

/** Values of a branch on a common grid of frequencies: linear between its points, nothing beyond them. */
function onFrequencies(branch, name, grid) {
  const rises = branch.frequency[branch.frequency.length - 1] > branch.frequency[0];
  const x = rises ? branch.frequency : [...branch.frequency].reverse();
  const y = rises ? branch[name] : [...branch[name]].reverse();
  let i = 0;
  return Float64Array.from(grid, (f) => {
    if (f < x[0] || f > x[x.length - 1]) return NaN;
    while (i < x.length - 2 && x[i + 1] < f) ++i;
    const share = (f - x[i]) / (x[i + 1] - x[i]);
    return y[i] + share * (y[i + 1] - y[i]);
  });
}

/** Marks of the wave at the drive's own frequency and of its pull-out. */
function responseMarks(response, name, unit, colour) {
  if (!response.running || response.running[name] === null) return [];
  const marks = [{x: response.drive_frequency / 1e3, y: response.running[name] / unit.divisor, text: 'drive', colour}];
  const branch = response.branches.find((b) => b.stable && b.frequency.includes(response.pull_out_below));
  if (branch)
    marks.push({
      x: response.pull_out_below / 1e3,
      y: branch[name][branch.frequency.indexOf(response.pull_out_below)] / unit.divisor,
      text: 'pull-out',
      colour
    });
  return marks;
}

/** One quantity of several responses. */
function responseChart(title, name, names, grid) {
  const members = summary.responses;
  const values = members.flatMap((m) => m.branches.map((b) => b[name].filter((v) => v !== null)));
  const unit = unitOf(name) === '1' ? percentUnit : displayUnit(largest(values), unitOf(name));
  const series = members.flatMap((m, i) => m.branches.map((b) => ({
                                                            name: names[i],
                                                            y: scaled(onFrequencies(b, name, grid), unit.divisor),
                                                            colour: seriesColours[i % 7],
                                                            dash: b.stable ? undefined : [3, 4]
                                                          })));
  const marks = members.length === 1 ?
      responseMarks(members[0], name, unit, null) :
      members.flatMap(
          (m, i) =>
              responseMarks(m, name, unit, seriesColours[i % 7]).map((mark) => ({...mark, text: '', small: true})));
  const many = members.length > 1;
  const value = (s, i) => rounded(s.y[i]) + ' ' + unit.text + (s.dash ? ' (unstable)' : '');
  figure(card(capital(title), null, 'half'), scaled(grid, 1e3), series, {
    name: title,
    x: {label: 'frequency [kHz]', range: [summary.from / 1e3, summary.to / 1e3]},
    y: {label: axisLabel(title, unit), range: paddedRange(series.map((s) => s.y), true)},
    legend: many ? names.map((n, i) => ({name: n, colour: seriesColours[i % 7]})) : null,
    marks,
    height: 300,
    tell: (i) => [
        ['at', engineering(grid[i], 'Hz')],
        ...series.filter((s) => Number.isFinite(s.y[i])).map((s) => [many ? s.name : title, value(s, i)])]
  });
}

function jumpsTable(names) {
  const wave = (p) => (p ? engineering(p.amplitude, 'm') + ', ' + engineering(p.speed, 'rad/s') : 'no steady wave');
  const lines = summary.responses.flatMap(
      (m, i) => m.jumps.map(
          (j) =>
              [words(names[i]), words(j.sweep), quantity(j.from.frequency, 'Hz'), words(wave(j.from)),
               words(wave(j.to))]));
  return table(
      'jumps', ['motor', 'sweep', 'frequency', 'from', 'to'], lines,
      ['motor', 'sweep', 'frequency [Hz]', 'from', 'to']);
}

function marginsTable(names) {
  const lines = summary.responses.map((m, i) => {
    const ends = m.pull_out_below !== null;
    const rate = m.running ? m.running.squeal_rate : null;
    const squeals = rate === null ? 'not known' : rate > 0 ? 'yes, ' + engineering(rate, '1/s') : 'no';
    return [
      words(names[i]), quantity(m.drive_frequency, 'Hz'),
      words(ends ? engineering(m.pull_out_below, 'Hz') : 'does not pull out in the range'),
      words(ends ? engineering(m.drive_frequency - m.pull_out_below, 'Hz') : ''), words(squeals)
    ];
  });
  return table('margins', ['motor', 'frequency of the drive', 'pulls out below', 'margin', 'squeals'], lines);
}

const responses = [
  ['amplitude', 'amplitude'], ['speed', 'speed'], ['torque', 'torque'], ['electrical power', 'electrical_power'],
  ['output power', 'output_power'], ['phase current', 'phase_current']
];

/** The page of a sweep of the frequency, from top to bottom. */
export function frequencySections() {
  const {family, load} = summary;
  const names = summary.responses.map(
      (m) => (family ? plain(family.parameter) + ' ' + memberText(m) : data.motor.name || 'motor'));
  const grid = Float64Array.from({length: 801}, (_, i) => summary.from + ((summary.to - summary.from) * i) / 800);
  const given = load.torque === undefined ? 'speed' : 'torque';
  const far = 'How far the frequency of the drive, a dot in the charts, is from the one at which its wave ends.';
  const jumps = 'Where slow sweeps leave a branch, and where they go on.';
  return [
    ...responses.filter(([, name]) => name !== given).map(([title,
                                                            name]) => () => responseChart(title, name, names, grid)),
    () => card('Margin', far, 'wide').append(marginsTable(names)),
    () => card('Jumps', jumps, 'wide').append(jumpsTable(names))
  ];
}
