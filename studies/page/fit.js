// SPDX-License-Identifier: Apache-2.0
// Measured and fitted numbers of every kind with the band of the fit, and the profiles of the estimates.

import {numbers} from './bytes.js';
import {paddedRange, scaled} from './chart.js';
import {data, summary, unitOf} from './data.js';
import {card, colour, el, seriesColours, seriesDash} from './dom.js';
import {figure} from './figure.js';
import {pointName} from './names.js';
import {displayUnit, engineering, largest, percent} from './units.js';
import {axisLabel, plain} from './words.js';

/** What a quantity is called: "torque" for torque_at. */
export function quantityName(quantity) { return pointName(quantity || 'torque_at'); }

/** Parameters that the bench had set. */
export function settings(set) {
  return Object.entries(set || {}).map(([n, v]) => plain(n) + ' ' + engineering(v, unitOf(n), 4));
}

/** What tells a curve from the others of its kind. */
function curveName(curve) {
  const parts = settings(curve.set);
  return (curve.file ? [curve.file, ...parts] : parts).join(', ') || 'fit';
}

/** Curves of the page, by what they show. */
function fittedCurves() {
  const kinds = new Map();
  for (const c of data.fit || []) {
    const [at, value, half] = ['at', 'value', 'half'].map((name) => numbers(c[name], Float64Array));
    const kind = c.quantity + ' over ' + c.over.name;
    kinds.set(kind, [...(kinds.get(kind) || []), {...c, at, value, half}]);
  }
  return [...kinds.values()];
}

/** Values on a grid: linear between the places of a curve, nothing beyond them. */
function onGrid(at, values, grid) {
  let i = 0;
  return Float64Array.from(grid, (x) => {
    if (x < at[0] || x > at[at.length - 1]) return NaN;
    while (i < at.length - 2 && at[i + 1] < x) ++i;
    const share = at[i + 1] > at[i] ? (x - at[i]) / (at[i + 1] - at[i]) : 0;
    return share === 0 ? values[i] : values[i] + share * (values[i + 1] - values[i]);
  });
}

/** Where a measured number stands on its curve. */
function placeOf(point, over) {
  if (over === 'speed' || over === 'torque') return point[over];
  return point.set[over];
}

function measuredValue(point) { return point.quantity ? point.value : point.torque; }

/** The curves of one kind, each with its band and its measured points. */
function kindChart(node, curves, title) {
  const [{quantity, over}] = curves;
  const grid = curves.length === 1 ? curves[0].at : Float64Array.from(new Set(curves.flatMap((c) => [...c.at]))).sort();
  const across = displayUnit(largest([grid]), over.unit);
  const points = curves.map((c) => c.points.map((i) => summary.data[i]));
  const unit = displayUnit(largest([...curves.map((c) => c.value), points.flat().map(measuredValue)]), curves[0].unit);
  const many = curves.length > 1;
  const look = curves.map((_, i) => (many ? seriesColours[i % 7] : 'c0'));
  const lines = curves.map((c) => onGrid(c.at, c.value, grid));
  const halves = curves.map((c) => onGrid(c.at, c.half, grid));
  const edge = (i, sign) => lines[i].map((y, k) => (y + sign * halves[i][k]) / unit.divisor);
  const edges = curves.flatMap((_, i) => [edge(i, -1), edge(i, 1)]);
  const fits = curves.map((c, i) => ({
                            name: curveName(c),
                            y: scaled(lines[i], unit.divisor),
                            colour: look[i],
                            dash: many ? seriesDash(i) : undefined
                          }));
  const banded = edges.some((e) => e.some(Number.isFinite));
  const shade = (i) => (many ? look[i] : 'band');
  const marks = curves.flatMap((_, i) => points[i].map((p) => ({
                                                         x: placeOf(p, over.name) / across.divisor,
                                                         y: measuredValue(p) / unit.divisor,
                                                         small: true,
                                                         colour: many ? look[i] : null
                                                       })));
  const places = marks.map((m) => m.x);
  const value = (i, k) => engineering(lines[i][k], curves[i].unit) +
      (Number.isFinite(halves[i][k]) ? ' ± ' + engineering(halves[i][k], curves[i].unit, 2) : '');
  figure(
      node, scaled(grid, across.divisor),
      [...fits, ...edges.map((y, k) => ({name: 'band', y, colour: shade(Math.floor(k / 2)), hidden: many}))], {
        name: quantity === 'torque_at' ? 'fit' : 'fit ' + quantity,
        title,
        legend: [
          {name: 'measured', colour: 'ink', kind: 'dot'}, ...fits.map(({name, colour: c}) => ({name, colour: c})),
          ...(banded ? [{name: percent(summary.confidence) + ' band of the fit', colour: 'band', kind: 'area'}] : [])
        ],
        x: {
          label: axisLabel(plain(over.name), across),
          range: over.name === 'speed' || over.name === 'torque' ?
              [Math.min(0, 1.04 * Math.min(...places)), 1.04 * Math.max(0, ...places) || 1] :
              paddedRange([scaled(grid, across.divisor)])
        },
        y: {
          label: axisLabel(quantityName(quantity), unit),
          range: paddedRange([...edges, ...fits.map((f) => f.y), marks.map((m) => m.y)])
        },
        height: 320,
        bands: curves.map(
            (_, i) =>
                ({series: [fits.length + 2 * i + 2, fits.length + 2 * i + 1], fill: () => colour(shade(i)) + '55'})),
        marks,
        tell: (k) => [
            ['at', engineering(grid[k], over.unit)],
            ...curves.flatMap((c, i) => (Number.isFinite(lines[i][k]) ? [[curveName(c), value(i, k)]] : []))]
      });
}

/** Height at which a chart as wide as .round is square inside its axes [CSS pixels]. */
const roundHeight = 380;

/** Two ranges about their middles, as long as the longer one. */
function alike(...ranges) {
  const half = Math.max(...ranges.map(([low, high]) => (high - low) / 2));
  return ranges.map(([low, high]) => [(low + high) / 2 - half, (low + high) / 2 + half]);
}

/** The admittance of the free stator in its plane, where both of its parts were measured. */
function circleChart(kinds) {
  const part = (quantity) => kinds.flat().filter((c) => c.quantity === quantity && c.over.name === 'frequency');
  const [along, up] = [part('conductance'), part('susceptance')].map((list) => list[0]);
  if (!along || !up) return;
  const measured = along.points.map((i) => summary.data[i])
                       .map((p) => [p, up.points.map((i) => summary.data[i]).find((q) => q.where === p.where)])
                       .filter(([, q]) => q)
                       .map(([p, q]) => [p.value, q.value])
                       .sort((a, b) => a[0] - b[0]);
  if (!measured.length) return;
  const [g, b] = [0, 1].map((k) => measured.map((m) => m[k]));
  const unit = displayUnit(largest([along.value, up.value, g, b]), 'S');
  const [x, y, fitX, fitY] = [g, b, along.value, up.value].map((v) => scaled(v, unit.divisor));
  const text = 'Admittance of a phase of the free stator over frequency. Both axes have one scale.';
  const node = el('div', {class: 'round'});
  card('Impedance circle', text, 'half').append(node);
  const [across, upwards] = alike(paddedRange([x, fitX]), paddedRange([y, fitY]));
  figure(node, x, [{name: 'measured', y, colour: 'ink', scatter: true}], {
    name: 'circle',
    legend: [{name: 'measured', colour: 'ink', kind: 'dot'}, {name: 'fit', colour: 'c0'}],
    x: {label: axisLabel('conductance', unit), range: across},
    y: {label: axisLabel('susceptance', unit), range: upwards},
    height: roundHeight,
    ground: (u) => {
      u.ctx.strokeStyle = colour('c0');
      u.ctx.lineWidth = 2 * devicePixelRatio;
      u.ctx.beginPath();
      fitX.forEach((v, k) => u.ctx.lineTo(u.valToPos(v, 'x', true), u.valToPos(fitY[k], 'y', true)));
      u.ctx.stroke();
    }
  });
}

/** A chart for each kind of data that was read along something. */
export function fitCharts() {
  const kinds = fittedCurves();
  for (const curves of kinds) {
    const title = 'Measured and fitted' + (kinds.length > 1 ? ': ' + quantityName(curves[0].quantity) : '');
    kindChart(card(title, null, kinds.length > 1 ? 'half' : 'wide'), curves, title);
  }
  circleChart(kinds);
}

/**
 * The root of the rise along a profile: a cubic between its points with their slopes, straight beyond them. Slopes
 * beyond three times that of the chord are limited to it, so that the cubic does not overshoot (Fritsch and Carlson
 * 1980).
 */
export function alongProfile(profile, value) {
  const last = profile.length - 1;
  if (value <= profile[0].value) return profile[0].z + profile[0].slope * (value - profile[0].value);
  if (value >= profile[last].value) return profile[last].z + profile[last].slope * (value - profile[last].value);
  const k = profile.findIndex((p, i) => value >= p.value && value < profile[i + 1].value);
  const [p, q] = [profile[k], profile[k + 1]];
  const step = q.value - p.value;
  const t = (value - p.value) / step;
  const chord = (q.z - p.z) / step;
  const limited = (slope) => Math.sign(chord) * Math.min(Math.max(Math.sign(chord) * slope, 0), 3 * Math.abs(chord));
  return (1 + 2 * t) * (1 - t) ** 2 * p.z + t * (1 - t) ** 2 * step * limited(p.slope) + t * t * (3 - 2 * t) * q.z +
      t * t * (t - 1) * step * limited(q.slope);
}

/** Values from a little beyond both ends of a profile, within the range of the parameter. */
function profileGrid(name, profile) {
  const [low, high] = [profile[0].value, profile[profile.length - 1].value];
  const room = 0.25 * (high - low);
  const range = data.ranges[name.split(' (')[0]];
  const from = Math.max(low - room, range.min);
  const to = Math.min(high + room, range.max);
  return Float64Array.from({length: 121}, (_, i) => from + ((to - from) * i) / 120);
}

function profileChart(name, estimate) {
  const {profile, value, low, high} = estimate;
  const grid = profileGrid(name, profile);
  const unit = displayUnit(value, unitOf(name));
  const slope = profile.find((p) => p.z === 0).slope;
  const rise = grid.map((b) => alongProfile(profile, b) ** 2);
  const linear = grid.map((b) => (slope * (b - value)) ** 2);
  // Where the Jacobian lacks rank there is no linearised interval.
  const lines = [{name: 'profile', y: rise, colour: 'c0'}];
  const legend = [{name: 'profile', colour: 'c0'}];
  if (estimate.sd !== null) {
    lines.push({name: 'linearised', y: linear, colour: 'soft', dash: [5, 4]});
    legend.push({name: 'linearised', colour: 'soft', kind: 'dash'});
  }
  const x = scaled(grid, unit.divisor);
  const beyond = low < grid[0] || high > grid[grid.length - 1];
  const note = 'How much the smallest sum of squares rises if this parameter is fixed at a value. ' +
      'It is 1 at the ends of the interval. ' +
      (beyond ? 'The interval is wider than the profile: beyond it other motors fit the data.' : '');
  const node = card('Profile of ' + plain(name), note, 'half');
  figure(node, x, lines, {
    name: 'profile ' + name,
    title: 'Profile of ' + plain(name),
    legend: [...legend, {name: percent(summary.confidence) + ' interval', colour: 'band', kind: 'area'}],
    x: {label: axisLabel(plain(name), unit), range: [x[0], x[x.length - 1]]},
    y: {label: 'rise of the squares', range: [0, 2.2]},
    height: 240,
    ground: (u) => {
      const [from, to, level, foot] = [
        ...[Math.max(low, grid[0]), Math.min(high, grid[grid.length - 1])].map(
            (v) => u.valToPos(v / unit.divisor, 'x', true)),
        ...[1, 0].map((v) => u.valToPos(v, 'y', true))
      ];
      u.ctx.fillStyle = colour('band') + '55';
      u.ctx.fillRect(from, level, to - from, foot - level);
    },
    tell: (i) => [['at', engineering(grid[i], unitOf(name))], ['rise', rise[i].toPrecision(3)]]
  });
}

/** For each estimate with an interval what holding it elsewhere costs; 1 is where the interval ends. */
export function profileCharts() {
  for (const [name, estimate] of Object.entries(summary.estimates))
    if (estimate.profile && estimate.profile.length > 1) profileChart(name, estimate);
}
