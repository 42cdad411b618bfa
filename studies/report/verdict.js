// SPDX-License-Identifier: Apache-2.0
'use strict';
// What came out, in words: the answer, what stops it, what moving that would give.

function bold(text) { return el('b', {}, text); }
function sentence(...parts) { return el('p', {}, ...parts); }

function designWords(design) {
  return Object.entries(design).map(([n, v]) => plain(n) + ' ' + engineering(v, unitOf(n), 3)).join(', ');
}

/** Limits and ends of ranges that hold a design back, the most valuable first. */
function holders(report, goalUnit) {
  const list = [...report.constraints.filter((c) => c.active).map((c) => ({ name: c.text, gain: c.one_percent_buys })),
    ...report.bounds.map((b) => ({ name: plain(b.variable) + (b.side === 'upper' ? ' at its largest, ' : ' at its smallest, ') + engineering(b.limit, unitOf(b.variable)), gain: b.one_percent_buys }))];
  return list.sort((a, b) => Math.abs(b.gain ?? 0) - Math.abs(a.gain ?? 0)).map((h) => ({ ...h, text: gain(h.gain, goalUnit) }));
}

/** Limits that no design satisfies, and the least that would do. */
function relaxationVerdict() {
  const conflict = summary.relaxation.conflict;
  const least = summary.relaxation.limits.filter((l) => l.alone).map((l) => l.text + ' by ' + engineering(l.alone, unitOf(metricOfLimit(l.text)), 3));
  const why = conflict.length === 1 ? conflict[0] + ' is out of reach.' : conflict.length ? 'These cannot hold together: ' + conflict.join('; ') + '.' : '';
  const cure = least.length === 0 ? 'No single limit that gives way is enough; see the table below.'
    : least.length === 1 ? 'It would be possible if this one gave way: ' + least[0] + '.' : 'It would be possible if one of these gave way: ' + least.join('; or ') + '.';
  return { look: 'bad', lines: [sentence(bold('No design keeps every limit. '), why), sentence(cure)] };
}

function searchVerdict() {
  const goal = summary.objective;
  const unit = unitOf(goal.metric);
  if (!summary.best) return { look: 'bad', lines: [sentence(bold('No design could be evaluated.'))] };
  if (summary.relaxation) return relaxationVerdict();
  const now = summary.best.metrics[goal.metric] ?? summary.best.design[goal.metric];
  const before = summary.before.metrics[goal.metric] ?? summary.before.design[goal.metric];
  const change = before ? ' (' + (now >= before ? '+' : '') + rounded(100 * (now / before - 1), 3) + ' %)' : '';
  const lines = [sentence('The best design has a ' + plain(goal.metric) + ' of ', bold(engineering(now, unit)), before === undefined || before === null ? '.' : ', against ' + engineering(before, unit) + ' before' + change + ': ' + designWords(summary.best.design) + '.')];
  const held = holders(summary.best, unit);
  if (held.length) {
    lines.push(sentence('What stops it: ', bold(held[0].name), held.length > 1 ? ', then ' + held.slice(1, 4).map((h) => h.name).join('; ') : '', '.'));
    if (held[0].text !== '-') lines.push(sentence('If that one gave way by 1 %, the ' + plain(goal.metric) + ' would change by ', bold(held[0].text), held.length > 1 && held[1].text !== '-' ? '; the next one would bring ' + held[1].text : '', '.'));
    else lines.push(sentence('Moving it a little gains nothing to first order.'));
  } else lines.push(sentence('No limit stops it: it is the best there is within the ranges.'));
  if (!summary.best.certificate.passed) lines.push(sentence(certificateText(summary.best.certificate)));
  return { look: summary.outcome === 'optimal' ? 'good' : 'bad', lines };
}

function paretoVerdict() {
  if (summary.relaxation) return relaxationVerdict();
  if (!summary.front.length) return { look: 'bad', lines: [sentence(bold('No point of the front was found.'))] };
  const values = (i) => summary.objectives.map((o) => plain(o.metric) + ' ' + engineering(summary.front[i].metrics[o.metric], unitOf(o.metric), 3)).join(' with ');
  const knee = summary.front[summary.knee];
  const held = holders(knee, '1');
  return { look: 'good', lines: [
    sentence(bold(String(summary.front.length)), ' best compromises. The knee, beyond which one gives much for little: ', bold(values(summary.knee)), '.'),
    ...summary.ends.map((i, k) => sentence((summary.objectives[k].sense === 'maximize' ? 'Largest ' : 'Smallest ') + plain(summary.objectives[k].metric) + ': ' + values(i) + '.')),
    sentence(held.length ? 'At the knee it is held back by ' + held.slice(0, 3).map((h) => h.name).join('; ') + '.' : 'At the knee no limit stops it.')] };
}

function curveVerdict() {
  const list = summary.curves;
  const m = list[0].metrics;
  if (!summary.family && !(m.peak_power > 0)) return { look: 'bad', lines: [sentence(bold('This motor drives no load: '), 'its torque at stall is ' + engineering(m.stall_torque, 'N.m') + '.')] };
  if (!summary.family) return { look: 'good', lines: [sentence('This motor holds ', bold(engineering(m.stall_torque, 'N.m')), ' at stall, runs up to ', bold(engineering(m.no_load_speed, 'rad/s')), ' without load, and gives at most ', bold(engineering(m.peak_power, 'W')), ' (at ' + engineering(m.speed_at_peak_power, 'rad/s') + ', ' + engineering(m.torque_at_peak_power, 'N.m') + ').')] };
  const name = summary.family.parameter;
  const value = memberValue;
  const top = (metric) => list.filter((c) => c.metrics[metric] !== null).sort((a, b) => b.metrics[metric] - a.metrics[metric])[0];
  const same = (metric) => list.every((c) => Math.abs(c.metrics[metric] - list[0].metrics[metric]) <= 1e-9 * Math.abs(list[0].metrics[metric]));
  const words = [['peak_power', 'W', 'Most power'], ['stall_torque', 'N.m', 'Most stall torque'], ['no_load_speed', 'rad/s', 'Highest no-load speed']].filter(([metric]) => top(metric));
  return { look: 'good', lines: [sentence(bold(list.length + ' motors'), ' that differ in ' + plain(name) + ', from ' + value(list[0]) + ' to ' + value(list[list.length - 1]) + '.'),
    ...words.map(([metric, unit, text]) => (same(metric) ? sentence(text.replace(/^\w+ /, (w) => ({ 'Most ': 'The ', 'Highest ': 'The ' })[w]), ' is the same for all: ', bold(engineering(list[0].metrics[metric], unit)), '.') : sentence(text + ': ', bold(engineering(top(metric).metrics[metric], unit)), ' with ' + plain(name) + ' ' + value(top(metric)) + '.')))] };
}

function sweepVerdict() {
  const parts = Object.entries(summary.metrics).filter(([, m]) => m.count > 0).slice(0, 4);
  return { look: 'good', lines: [sentence(bold(summary.stored + ' designs'), summary.failed ? ', ' + summary.failed + ' of them without a full answer.' : '.'),
    ...parts.map(([n, m]) => sentence(plain(n) + ' from ' + engineering(m.min, unitOf(n)) + ' to ', bold(engineering(m.max, unitOf(n))), m.highest ? ', the most with ' + designWords(m.highest.design) + '.' : '.'))] };
}

function sensitivityVerdict() {
  const size = { sobol: (e) => e.total.value, morris: (e) => e.mu_star, local: (e) => (e.elasticity === null ? null : Math.abs(e.elasticity)) }[summary.method];
  const lines = [];
  for (const [metric, effects] of Object.entries(summary.indices)) {
    if (!effects) continue;
    const names = sortedNames(effects, size);
    const first = effects[names[0]];
    const text = summary.method === 'sobol' ? percent(first.total.value) + ' of its variance' : summary.method === 'morris' ? engineering(first.mu_star, unitOf(metric), 3) + ' across its range' : rounded(first.elasticity, 3) + ' % for 1 % more';
    lines.push(sentence(plain(metric) + ': ', bold(plain(names[0])), ' matters most (' + text + ')', names.length > 1 ? ', then ' + names.slice(1, 3).map(plain).join(' and ') : '', '.'));
  }
  return { look: 'good', lines };
}

function uncertaintyVerdict() {
  const lines = [];
  if (summary.yield) {
    lines.push(sentence(bold(percent(summary.yield.value, 4)), ' of the motors keep every limit (between ' + percent(summary.yield.low, 4) + ' and ' + percent(summary.yield.high, 4) + ' with ' + percent(summary.confidence) + ' confidence).'));
    const worst = [...summary.limits].sort((a, b) => a.kept.value - b.kept.value)[0];
    if (worst) lines.push(sentence('The limit that costs most motors: ', bold(worst.text), ', kept by ' + percent(worst.kept.value, 4) + '.'));
  }
  for (const [n, m] of Object.entries(summary.metrics).slice(0, 4)) lines.push(sentence(plain(n) + ': ' + engineering(m.mean, unitOf(n)) + ' on average, standard deviation ' + engineering(m.sd, unitOf(n), 3) + '.'));
  return { look: 'good', lines };
}

function calibrateVerdict() {
  const entries = Object.entries(summary.estimates);
  if (!entries.length) return { look: 'bad', lines: [sentence(bold('No fit was found.'))] };
  const lines = [sentence('The data say: ', bold(entries.map(([n, e]) => plain(n) + ' ' + engineering(e.value, unitOf(n)) + (Number.isFinite(e.low) && e.low !== null ? ' (' + engineering(e.low, unitOf(n), 3) + ' to ' + engineering(e.high, unitOf(n), 3) + ')' : '')).join(', ')), '.'),
    sentence('What is left between motor and points: ' + engineering(summary.residual_rms, 'N.m', 3) + ' (root mean square).')];
  for (const u of summary.undetermined) lines.push(sentence('The data do not tell ' + u.parameters.map(plain).join(' and ') + ' apart.'));
  if (summary.fit.poor) lines.push(sentence(bold('The motor does not follow these points: '), 'the residuals have a pattern.'));
  return { look: summary.fit.poor || summary.undetermined.length ? 'bad' : 'good', lines };
}

const verdicts = { curve: curveVerdict, sweep: sweepVerdict, sensitivity: sensitivityVerdict, optimize: searchVerdict, size: searchVerdict, pareto: paretoVerdict, uncertainty: uncertaintyVerdict, calibrate: calibrateVerdict };
