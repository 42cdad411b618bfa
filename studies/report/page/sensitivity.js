// SPDX-License-Identifier: Apache-2.0
'use strict';
// Which variable matters: sorted bars with intervals; a tornado for derivatives at one motor.

/** Rows of bars over one scale. entries: [{name, value, low, high, second, text}] */
function barRows(entries, low, high) {
  const node = el('div', { class: 'bars', 'data-chart': 'bars' });
  const x = (v) => 2 + (196 * (Math.min(Math.max(v, low), high) - low)) / (high - low);
  for (const e of entries) {
    const line = svg('svg', { viewBox: '0 0 200 24', preserveAspectRatio: 'none', role: 'img', 'aria-label': e.name + ' ' + e.text });
    const rect = (a, b, y, h, c, extra) => svg('rect', { x: Math.min(x(a), x(b)), y, width: Math.max(Math.abs(x(b) - x(a)), 0.4), height: h, style: 'fill:var(--' + c + ')', ...extra });
    if (Number.isFinite(e.value)) line.append(rect(0, e.value, 4, 16, e.value < 0 ? 'c1' : 'c0', e.second === undefined ? {} : { 'fill-opacity': 0.35 }));
    if (Number.isFinite(e.second)) line.append(rect(0, e.second, 8, 8, 'c0'));
    if (Number.isFinite(e.low) && Number.isFinite(e.high)) {
      line.append(svg('path', { d: 'M' + x(e.low) + ' 12H' + x(e.high) + 'M' + x(e.low) + ' 7V17M' + x(e.high) + ' 7V17', style: 'stroke:var(--ink);stroke-width:1.4;fill:none', 'vector-effect': 'non-scaling-stroke' }));
    }
    line.append(svg('path', { d: 'M' + x(0) + ' 0V24', style: 'stroke:var(--soft)', 'vector-effect': 'non-scaling-stroke' }));
    node.append(el('span', {}, plain(e.name)), line, el('span', { class: 'number' }, e.text));
  }
  return node;
}

function sortedNames(effects, size) {
  return Object.keys(effects).sort((a, b) => (size(effects[b]) ?? -1) - (size(effects[a]) ?? -1));
}

function sobolCard(metric, effects) {
  const node = card(capital(plain(metric)), 'Share of the variance: alone (dark), with all interactions (light), interval of the latter.', 'half');
  const names = sortedNames(effects, (e) => e.total.value);
  node.append(barRows(names.map((n) => ({ name: n, value: effects[n].total.value, second: effects[n].first.value, low: effects[n].total.low, high: effects[n].total.high, text: percent(effects[n].total.value) })), 0, Math.max(1, ...names.map((n) => effects[n].total.high ?? 0))));
  const three = (e) => [{ text: rounded(e.value, 3), value: e.value }, { text: rounded(e.low, 3), value: e.low }, { text: rounded(e.high, 3), value: e.high }];
  node.append(el('details', {}, el('summary', {}, 'Numbers'), table('indices-' + metric, ['variable', 'first', 'low', 'high', 'total', 'low', 'high'], names.map((n) => [named(n), ...three(effects[n].first), ...three(effects[n].total)]))));
}

function morrisCard(metric, effects) {
  const unit = unitOf(metric);
  const node = card(capital(plain(metric)), 'Mean size of the change across each range (mu*), with its interval. A large sigma tells of curvature or interaction.', 'half');
  const names = sortedNames(effects, (e) => e.mu_star);
  const interval = (e) => e.mu_star_interval || {};
  const end = (e) => (Array.isArray(interval(e)) ? interval(e) : [interval(e).low, interval(e).high]);
  const top = Math.max(...names.map((n) => Math.max(effects[n].mu_star ?? 0, end(effects[n])[1] ?? 0)), 1e-300);
  node.append(barRows(names.map((n) => ({ name: n, value: effects[n].mu_star, low: end(effects[n])[0], high: end(effects[n])[1], text: engineering(effects[n].mu_star, unit, 3) })), 0, top));
  node.append(el('details', {}, el('summary', {}, 'Numbers'), table('indices-' + metric, ['variable', 'mu*', 'sigma', 'mu'], names.map((n) => [named(n), quantity(effects[n].mu_star, unit), quantity(effects[n].sigma, unit), quantity(effects[n].mu, unit)]))));
}

const smoothnessWords = { flat: ' The value sits on a plateau: a zero here says nothing about larger steps.', 'one-sided': ' The value is at a kink: this is the slope on one side.', one_sided: ' The value is at a kink: this is the slope on one side.', undefined: ' Here it has no derivative.' };

function localCard(metric, effects) {
  const unit = unitOf(metric);
  const info = summary.metrics[metric];
  const node = card(capital(plain(metric)) + ': ' + engineering(info.value, unit), 'Change of the metric for 1 % more of the variable: bars to the right where it rises, to the left where it falls.' + (smoothnessWords[info.smoothness] || ''), 'half');
  const names = sortedNames(effects, (e) => (e.elasticity === null ? null : Math.abs(e.elasticity)));
  const top = Math.max(...names.map((n) => Math.abs(effects[n].elasticity ?? 0)), 1e-300);
  node.append(barRows(names.map((n) => ({ name: n, value: effects[n].elasticity, text: rounded(effects[n].elasticity, 3) + ' %' })), -top, top));
  node.append(el('details', {}, el('summary', {}, 'Numbers'), table('indices-' + metric, ['variable', 'at', 'elasticity', 'gradient'], names.map((n) => [named(n), quantity((summary.at || {})[n], unitOf(n)), { text: rounded(effects[n].elasticity), value: effects[n].elasticity }, { text: rounded(effects[n].gradient) + ' ' + ratioUnit(unit, unitOf(n)), value: effects[n].gradient }]))));
}

function sensitivityPage() {
  const draw = { sobol: sobolCard, morris: morrisCard, local: localCard }[summary.method];
  for (const [metric, effects] of Object.entries(summary.indices)) {
    if (effects) draw(metric, effects);
    else card(capital(plain(metric)), (summary.metrics[metric] || {}).note || 'No effects could be computed.', 'half');
  }
  motorCurve();
}

/** The curve of the study's motor, where the study itself has none. */
function motorCurve() {
  const list = curves.filter(Boolean);
  if (list.length) curveSection(list, [data.motor.name || 'motor'], 'The motor');
}
