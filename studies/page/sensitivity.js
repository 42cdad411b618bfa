// SPDX-License-Identifier: Apache-2.0
// Which variable matters: sorted bars with intervals; a tornado for derivatives at one motor.

import {curveSection} from './curve.js';
import {curves, data, summary, unitOf} from './data.js';
import {card, el, svg} from './dom.js';
import {capital} from './names.js';
import {named, quantity, table} from './table.js';
import {engineering, noBreak, percent, rounded, spreadText} from './units.js';
import {plain, slopeText} from './words.js';

/** Rows of bars over one scale. entries: [{name, value, low, high, second, text}] */
export function barRows(entries, low, high) {
  const node = el('div', {class: 'bars', 'data-chart': 'bars'});
  const x = (v) => 2 + (196 * (Math.min(Math.max(v, low), high) - low)) / (high - low);
  for (const e of entries) {
    const line = svg(
        'svg', {viewBox: '0 0 200 24', preserveAspectRatio: 'none', role: 'img', 'aria-label': e.name + ' ' + e.text});
    const rect = (a, b, y, h, c, extra) => svg('rect', {
      x: Math.min(x(a), x(b)),
      y,
      width: Math.max(Math.abs(x(b) - x(a)), 0.4),
      height: h,
      style: 'fill:var(--' + c + ')',
      ...extra
    });
    if (Number.isFinite(e.value))
      line.append(
          rect(0, e.value, 4, 16, e.value < 0 ? 'c1' : 'c0', e.second === undefined ? {} : {'fill-opacity': 0.35}));
    if (Number.isFinite(e.second)) line.append(rect(0, e.second, 8, 8, 'c0'));
    if (Number.isFinite(e.low) && Number.isFinite(e.high)) {
      line.append(svg('path', {
        d: 'M' + x(e.low) + ' 12H' + x(e.high) + 'M' + x(e.low) + ' 7V17M' + x(e.high) + ' 7V17',
        style: 'stroke:var(--ink);stroke-width:1.4;fill:none',
        'vector-effect': 'non-scaling-stroke'
      }));
    }
    line.append(
        svg('path', {d: 'M' + x(0) + ' 0V24', style: 'stroke:var(--soft)', 'vector-effect': 'non-scaling-stroke'}));
    node.append(el('span', {}, plain(e.name)), line, el('span', {class: 'number'}, e.text));
  }
  return node;
}

export function sortedNames(effects, size) {
  return Object.keys(effects).sort((a, b) => (size(effects[b]) ?? -1) - (size(effects[a]) ?? -1));
}

/** A card of bars with the numbers folded below. */
function effectsCard(title, note, bars, [low, high], numbers) {
  card(title, note, 'half').append(barRows(bars, low, high), el('details', {}, el('summary', {}, 'Numbers'), numbers));
}

function sobolCard(metric, effects) {
  const note = 'Share of the variance: alone (dark), with all interactions (light), interval of the latter.';
  const names = sortedNames(effects, (e) => e.total.value);
  const bars = names.map((n) => {
    const {total, first} = effects[n];
    const {low, high, value} = total;
    return {name: n, value, second: first.value, low, high, text: percent(value)};
  });
  const three = (e) => [e.value, e.low, e.high].map((value) => ({text: rounded(value, 3), value}));
  const lines = names.map((n) => [named(n), ...three(effects[n].first), ...three(effects[n].total)]);
  const header = ['variable', 'first', 'low', 'high', 'total', 'low', 'high'];
  const top = Math.max(1, ...names.map((n) => effects[n].total.high ?? 0));
  effectsCard(capital(plain(metric)), note, bars, [0, top], table('indices-' + metric, header, lines));
}

function morrisCard(metric, effects) {
  const unit = unitOf(metric);
  const note =
      'Mean size of the change across each range (µ*), with its interval. A large σ means curvature or interaction.';
  const names = sortedNames(effects, (e) => e.mu_star);
  const ends = ({mu_star_interval: interval}) => (interval ? [interval.low, interval.high] : [null, null]);
  const top = Math.max(...names.map((n) => Math.max(effects[n].mu_star ?? 0, ends(effects[n])[1] ?? 0)), 1e-300);
  const bars = names.map((n) => {
    const [low, high] = ends(effects[n]);
    return {name: n, value: effects[n].mu_star, low, high, text: spreadText(effects[n].mu_star, unit, top)};
  });
  const cell = (value) => ({text: spreadText(value, unit, top, 4), value});
  const lines = names.map((n) => [named(n), ...['mu_star', 'sigma', 'mu'].map((key) => cell(effects[n][key]))]);
  const file = 'indices-' + metric;
  effectsCard(capital(plain(metric)), note, bars, [0, top], table(file, ['variable', 'µ*', 'σ', 'µ'], lines));
}

const smoothnessWords = {
  flat: ' The value sits on a plateau: a zero here says nothing about larger steps.',
  'one-sided': ' The value is at a kink: this is the slope on one side.',
  undefined: ' Here it has no derivative.'
};

function localCard(metric, effects) {
  const unit = unitOf(metric);
  const info = summary.metrics[metric];
  const note =
      'Change of the metric for 1 % more of the variable: bars to the right where it rises, to the left where ' +
      'it falls.' + (smoothnessWords[info.smoothness] || '');
  const names = sortedNames(effects, (e) => (e.elasticity === null ? null : Math.abs(e.elasticity)));
  const top = Math.max(...names.map((n) => Math.abs(effects[n].elasticity ?? 0)), 1e-300);
  const share = (n) => (Math.abs(effects[n].elasticity) <= 1e-9 * top ? 0 : effects[n].elasticity);
  const bars = names.map((n) => ({name: n, value: effects[n].elasticity, text: rounded(share(n), 3) + noBreak + '%'}));
  const lines = names.map((n) => {
    const {elasticity, gradient} = effects[n];
    return [
      named(n), quantity((summary.at || {})[n], unitOf(n)), {text: rounded(share(n)), value: elasticity},
      {text: slopeText(share(n) === 0 ? 0 : gradient, unit, unitOf(n)), value: gradient}
    ];
  });
  const title = capital(plain(metric)) + ': ' + engineering(info.value, unit);
  effectsCard(
      title, note, bars, [-top, top], table('indices-' + metric, ['variable', 'at', 'elasticity', 'gradient'], lines));
}

/** The page of a sensitivity study, from top to bottom. */
export function sensitivitySections() {
  const draw = {sobol: sobolCard, morris: morrisCard, local: localCard}[summary.method];
  const none = (metric) =>
      card(capital(plain(metric)), (summary.metrics[metric] || {}).note || 'No effects could be computed.', 'half');
  const cards =
      Object.entries(summary.indices).map(([metric,
                                            effects]) => () => (effects ? draw(metric, effects) : none(metric)));
  return [...cards, motorCurve];
}

/** The curve of the study's motor, where the study itself has none. */
export function motorCurve() {
  const list = curves.filter(Boolean);
  if (list.length) curveSection(list, [data.motor.name || 'motor'], 'The motor');
}
