// SPDX-License-Identifier: Apache-2.0
// Measured points with the fit and its band, residuals, correlation of the estimates.

import {numbers} from './bytes.js';
import {paddedRange, scaled} from './chart.js';
import {curveSection} from './curve.js';
import {curves, data, summary, unitOf} from './data.js';
import {designerButton} from './designer/inside.js';
import {card, colour} from './dom.js';
import {figure} from './figure.js';
import {movesCard} from './moves.js';
import {named, quantity, table, words} from './table.js';
import {displayUnit, engineering, largest, percent, rounded} from './units.js';
import {axisLabel, plain} from './words.js';

/**
 * Half width of the band of the fitted torque: the factor of the estimates' own intervals, carried to the torque; NaN
 * where they have none.
 */
function fitBand() {
  const names = Object.keys(summary.estimates)
                    .filter((n) => Number.isFinite(summary.estimates[n].sd) && summary.estimates[n].sd > 0);
  const speeds = numbers(data.fit.speed, Float64Array);
  const gradients = names.map((n) => numbers(data.fit.gradients[n], Float64Array));
  const factor = names.length ? summary.student_t : NaN;
  return Float64Array.from(speeds, (_, s) => {
    let variance = 0;
    names.forEach((a, i) => names.forEach((b, j) => {
      variance += gradients[i][s] * gradients[j][s] * summary.estimates[a].sd * summary.estimates[b].sd *
          (i === j ? 1 : (summary.correlation[a] || {})[b] ?? 0);
    }));
    return factor * Math.sqrt(Math.max(variance, 0));
  });
}

/** The measured numbers that stand on the curve of the fitted motor: torques at speeds, with the motor as it is. */
function torquePoints() { return summary.data.filter((p) => !p.quantity && !p.set); }

/** What a measured number is, and where it was read. */
function readingText(p) {
  const at = p.speed !== undefined         ? ' at ' + engineering(p.speed, 'rad/s', 4) :
      p.quantity && p.torque !== undefined ? ' at ' + engineering(p.torque, 'N.m', 4) :
                                             '';
  return plain((p.quantity || 'torque_at').replace(/_at$/, '')) + at +
      Object.entries(p.set || {}).map(([n, v]) => ', ' + plain(n) + ' ' + engineering(v, unitOf(n), 4)).join('');
}

function fitChart(node) {
  const speeds = scaled(numbers(data.fit.speed, Float64Array), Math.PI / 30);
  const torque = numbers(data.fit.torque, Float64Array);
  const band = fitBand();
  const points = torquePoints();
  const measuredSpeeds = points.map((p) => (p.speed * 30) / Math.PI);
  const unit = displayUnit(largest([torque, points.map((p) => p.torque)]), 'N.m');
  const low = torque.map((t, i) => (t - band[i]) / unit.divisor);
  const high = torque.map((t, i) => (t + band[i]) / unit.divisor);
  const measured = points.map((p) => p.torque / unit.divisor);
  const bandEntry = {name: percent(summary.confidence) + ' band of the fit', colour: 'band', kind: 'area'};
  figure(
      node, speeds,
      [
        {name: 'fit', y: scaled(torque, unit.divisor), colour: 'c0'}, {name: 'low', y: low, colour: 'band'},
        {name: 'high', y: high, colour: 'band'}
      ],
      {
        name: 'fit',
        title: 'Measured and fitted',
        legend: [
          {name: 'measured', colour: 'ink', kind: 'dot'}, {name: 'fit', colour: 'c0'},
          ...(low.some(Number.isFinite) ? [bandEntry] : [])
        ],
        x: {
          label: 'speed [rpm]',
          range: [Math.min(0, 1.04 * Math.min(...measuredSpeeds)), 1.04 * Math.max(0, ...measuredSpeeds) || 1]
        },
        y: {label: axisLabel('torque', unit), range: paddedRange([low, high, scaled(torque, unit.divisor), measured])},
        height: 320,
        bands: [{series: [3, 2], fill: () => colour('band') + '55'}],
        marks: points.map((_, i) => ({x: measuredSpeeds[i], y: measured[i], small: true})),
      });
}

/** Where a number was read: its speed, its load, its frequency, or else its place in the data. */
function readAt(p, index) {
  if (p.speed !== undefined) return {label: 'speed [rpm]', x: (p.speed * 30) / Math.PI};
  if (p.quantity && p.torque !== undefined) return {label: 'torque [N.m]', x: p.torque};
  const frequency = (p.set || {}).frequency;
  return frequency === undefined ? {label: 'number in the data', x: index + 1} :
                                   {label: 'frequency [kHz]', x: frequency / 1000};
}

/** Residuals of one kind of data. */
function residualChart(node, quantityName, points) {
  const places = points.map(({p, index}) => ({p, ...readAt(p, index)})).sort((a, b) => a.x - b.x);
  const unit = displayUnit(largest([places.map(({p}) => p.residual)]), points[0].p.unit || 'N.m');
  const y = places.map(({p}) => (p.residual === null ? NaN : p.residual / unit.divisor));
  const top = 1.15 * largest([y]) || 1;
  figure(node, places.map(({x}) => x), [{name: 'residual', y, colour: 'c0', scatter: true}], {
    name: 'residuals' + (quantityName ? ' ' + quantityName : ''),
    x: {label: places[0].label, range: paddedRange([places.map(({x}) => x)])},
    y: {label: axisLabel('measured - fitted', unit), range: [-top, top]},
    height: 240,
    ground: (u) => {
      const at = u.valToPos(0, 'y', true);
      u.ctx.fillStyle = colour('soft');
      u.ctx.fillRect(u.bbox.left, at, u.bbox.width, devicePixelRatio);
    },
  });
}

/** A chart of residuals for each kind of data with more than one number. */
function residualCards() {
  const kinds = new Map();
  summary.data.forEach((p, index) => {
    const name = p.quantity || '';
    kinds.set(name, [...(kinds.get(name) || []), {p, index}]);
  });
  for (const [name, points] of kinds) {
    if (name && points.length < 2) continue;
    residualChart(
        card(
            'Residuals' + (kinds.size > 1 ? ' of the ' + plain((name || 'torque_at').replace(/_at$/, '')) : ''),
            'They should scatter about zero without a pattern.', 'half'),
        name, points);
  }
}

function correlationTable() {
  const names = Object.keys(summary.estimates);
  const shade = (v) =>
      (v === null || v === undefined ? '' :
                                       'background:color-mix(in srgb, var(--' + (v < 0 ? 'c1' : 'c0') + ') ' +
               Math.round(60 * Math.abs(v)) + '%, transparent)');
  const lines = names.map((a) => [named(a), ...names.map((b) => {
                            const v = a === b ? 1 : (summary.correlation[a] || {})[b];
                            return {text: v === null || v === undefined ? '-' : v.toFixed(2), value: v};
                          })]);
  const node = table('correlation', ['parameter', ...names.map(plain)], lines);
  node.querySelectorAll('td[data-value]').forEach((td) => {
    td.style.cssText = shade(Number(td.dataset.value));
  });
  return node;
}

/** What to measure next, and the widths of the intervals after it, relative to the present widths. */
function planTable() {
  const names = Object.keys(summary.estimates).filter((n) => n in summary.plan[0].widths);
  const lines =
      summary.plan.map((p) => [words(readingText(p)), percent(p.mean), ...names.map((n) => percent(p.widths[n]))]);
  return table('plan', ['measure next', 'all', ...names.map(plain)], lines);
}

/** The measured numbers beside the fitted ones, and which of them are outliers. */
function pointsCard(torques) {
  const outliers = new Map((summary.outliers || []).map((o) => [o.point, o]));
  const remark = (i) => (
      outliers.size ? [outliers.has(i) ? words('outlier, p = ' + rounded(outliers.get(i).p, 2), 'bad-word') : ''] : []);
  const heads = outliers.size ? [''] : [];
  if (torques) {
    const lines = summary.data.map(
        (p, i) =>
            [quantity(p.speed, 'rad/s'), quantity(p.torque, 'N.m'), quantity(p.fitted, 'N.m'),
             quantity(p.residual, 'N.m', 3), ...remark(i)]);
    card('The points', null, 'half')
        .append(table(
            'points', ['speed', 'measured', 'fitted', 'residual', ...heads], lines,
            ['speed [rad/s]', 'measured [N.m]', 'fitted [N.m]', 'residual [N.m]', ...heads]));
    return;
  }
  const lines = summary.data.map((p, i) => {
    const unit = p.unit || 'N.m';
    return [
      readingText(p), quantity(p.quantity ? p.value : p.torque, unit), quantity(p.fitted, unit),
      quantity(p.residual, unit, 3), p.sd ? rounded(p.residual / p.sd, 2) : '-', ...remark(i)
    ];
  });
  card('The numbers', null, 'wide')
      .append(table('points', ['what', 'measured', 'fitted', 'residual', 'in standard deviations', ...heads], lines));
}

function planCard() {
  if (!(summary.plan || []).length) return;
  const first = !summary.data.length;
  const text = 'The measurement that narrows the intervals most comes first; widths are those after it, relative to ' +
      (first ? 'the ranges.' : 'the present widths.');
  card(first ? 'The first measurements' : 'The next measurements', text, 'wide').append(planTable());
}

export function calibratePage() {
  if (!summary.data.length) {
    planCard();
    if (curves.filter(Boolean).length) curveSection(curves.filter(Boolean), ['motor planned for'], 'The motor');
    return;
  }
  const torques = summary.data.every((p) => !p.quantity && !p.set);
  if (data.fit && torquePoints().length) fitChart(card('Measured and fitted', null, 'wide'));
  const list = Object.entries(summary.estimates);
  const held = list.some(([, e]) => e.remark);
  const line = ([n, e]) =>
      [named(n), quantity(e.value, unitOf(n)), quantity(e.low, unitOf(n)), quantity(e.high, unitOf(n)),
       ...(held ? [words(e.remark, 'bad-word')] : [])];
  card('Estimates', percent(summary.confidence) + ' intervals.', 'half')
      .append(table('estimates', ['parameter', 'value', 'low', 'high', ...(held ? ['remark'] : [])], list.map(line)));
  card('Correlation of the estimates', 'Near 1 or -1: the data tell only a combination.', 'half')
      .append(correlationTable());
  residualCards();
  pointsCard(torques);
  movesCard((n) => summary.estimates[n].value);
  planCard();
  const fitted = curves.filter(Boolean);
  const names = fitted.length > 1 ? fitted.map((c) => c.label) : ['fitted motor'];
  if (fitted.length) curveSection(fitted, names, fitted.length > 1 ? 'The fitted motors' : 'The fitted motor');
  const explore = fitted.length ? designerButton(fitted[0].design, 'fitted motor', 'Explore the fitted motor') : null;
  if (explore) card('The fitted motor as a page', null, 'wide').append(explore);
}
