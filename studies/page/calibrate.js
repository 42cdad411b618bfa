// SPDX-License-Identifier: Apache-2.0
// A calibration: estimates, residuals, correlation, the next measurements.

import {paddedRange, scaled} from './chart.js';
import {curveSection} from './curve.js';
import {curves, summary, unitOf} from './data.js';
import {designerButton} from './designer/inside.js';
import {card, colour} from './dom.js';
import {figure} from './figure.js';
import {fitCharts, profileCharts, quantityName, settings} from './fit.js';
import {movesCard} from './moves.js';
import {named, quantity, table, words} from './table.js';
import {displayUnit, engineering, intervalDigits, largest, percent, printed, rounded} from './units.js';
import {axisLabel, plain} from './words.js';

/** What a measured number is, and where it was read. */
function readingText(p) {
  const at = p.speed !== undefined         ? ' at ' + engineering(p.speed, 'rad/s', 4) :
      p.quantity && p.torque !== undefined ? ' at ' + engineering(p.torque, 'N.m', 4) :
                                             '';
  return [quantityName(p.quantity) + at, ...settings(p.set)].join(', ') + (p.file ? ' (' + p.file + ')' : '');
}

/** Where a number was read, SI: its speed, its load, its frequency, or else its place in the data. */
function readAt(p, index) {
  if (p.speed !== undefined) return {name: 'speed', unit: 'rad/s', x: p.speed};
  if (p.quantity && p.torque !== undefined) return {name: 'torque', unit: 'N.m', x: p.torque};
  const frequency = (p.set || {}).frequency;
  return frequency === undefined ? {name: 'number in the data', unit: '1', x: index + 1} :
                                   {name: 'frequency', unit: 'Hz', x: frequency};
}

/** Residuals of one kind of data. */
function residualChart(node, quantity, points) {
  const places = points.map(({p, index}) => ({p, ...readAt(p, index)})).sort((a, b) => a.x - b.x);
  const unit = displayUnit(largest([places.map(({p}) => p.residual)]), points[0].p.unit || 'N.m');
  const y = places.map(({p}) => (p.residual === null ? NaN : p.residual / unit.divisor));
  const top = 1.15 * largest([y]) || 1;
  const across = displayUnit(largest([places.map(({x}) => x)]), places[0].unit);
  const x = scaled(places.map((p) => p.x), across.divisor);
  figure(node, x, [{name: 'residual', y, colour: 'c0', scatter: true}], {
    name: 'residuals' + (quantity ? ' ' + quantity : ''),
    x: {label: axisLabel(places[0].name, across), range: paddedRange([x])},
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
            'Residuals' + (kinds.size > 1 ? ' of the ' + quantityName(name) : ''),
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
  const lines = names.map(
      (a) => [named(a), ...names.map((b) => {
        const v = a === b ? 1 : (summary.correlation[a] || {})[b];
        return {text: v === null || v === undefined ? '-' : v.toFixed(2).replace(/^-(0\.0+)$/, '$1'), value: v};
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
      outliers.size ? [outliers.has(i) ? words('outlier, p = ' + printed(outliers.get(i).p, 2), 'bad-word') : ''] : []);
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
  fitCharts();
  const list = Object.entries(summary.estimates);
  const held = list.some(([, e]) => e.remark);
  const shown = (n, e) => [e.value, e.low, e.high].map((v) => quantity(v, unitOf(n), intervalDigits(e.low, e.high)));
  const line = ([n, e]) => [named(n), ...shown(n, e), ...(held ? [words(e.remark, 'bad-word')] : [])];
  // Remarks, and the correlations of many parameters, need the whole width of the page.
  const width = held || list.length > 4 ? 'wide' : 'half';
  card('Estimates', 'With intervals of ' + percent(summary.confidence) + '.', width)
      .append(table('estimates', ['parameter', 'value', 'low', 'high', ...(held ? ['remark'] : [])], list.map(line)));
  const near = 'Near 1 or -1 the data hardly tell the two parameters apart.';
  const dash = summary.moves_missing ? ' A dash stands for one that is unknown: ' + summary.moves_missing + '.' : '';
  card('Correlation of the estimates', near + dash, width).append(correlationTable());
  profileCharts();
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
