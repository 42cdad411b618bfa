// SPDX-License-Identifier: Apache-2.0
'use strict';
// optimize and size: before against after, limits, how the search went.

function metricOfLimit(text) { return text.split(/<=|>=|==|<|>/)[0].trim(); }
function isLowerLimit(text) { return text.includes('>'); }

/** "+1.2 W", or nothing. */
function gain(value, unit) {
  if (value === null || !Number.isFinite(value) || value === 0) return '-';
  return (value > 0 ? '+' : '') + engineering(value, unit, 3);
}

function limitState(c) {
  if (c.violation === null) return words('cannot be reached', 'bad-word');
  if (c.active) return words('binds', 'bad-word');
  if (c.violation > 1e-6 * Math.abs(c.limit)) return words('broken by ' + engineering(c.violation, unitOf(metricOfLimit(c.text)), 3), 'bad-word');
  return words('holds', 'good-word');
}

/** goalUnit null: several goals, so that there is no gain to name. */
function limitsTable(report, goalUnit) {
  const lines = report.constraints.map((c) => {
    const unit = unitOf(metricOfLimit(c.text));
    const slack = c.value === null ? null : isLowerLimit(c.text) ? c.value - c.limit : c.limit - c.value;
    return [words(c.text), quantity(c.value, unit), limitState(c), { text: c.active ? gain(c.one_percent_buys, goalUnit) : '-', value: c.one_percent_buys }, { text: slack !== null && Math.abs(slack) <= 1e-6 * Math.abs(c.limit) ? '0' : engineering(slack, unit, 3), value: slack }, { text: rounded(c.multiplier), value: c.multiplier }];
  });
  for (const b of report.bounds) {
    const unit = unitOf(b.variable);
    lines.push([words(plain(b.variable) + (b.side === 'upper' ? ' at its largest' : ' at its smallest')), quantity(b.limit, unit), words('binds', 'bad-word'), { text: gain(b.one_percent_buys, goalUnit), value: b.one_percent_buys }, { text: '0', value: 0 }, { text: rounded(b.multiplier), value: b.multiplier }]);
  }
  if (goalUnit === null) return table('limits', ['limit', 'value', 'state', 'slack'], lines.map((l) => [...l.slice(0, 3), l[4]]), ['limit', 'value [SI]', 'state', 'slack [SI]']);
  return table('limits', ['limit', 'value', 'state', '1 % looser buys', 'slack', 'multiplier (SI)'], lines, ['limit', 'value [SI]', 'state', 'one percent buys [SI]', 'slack [SI]', 'multiplier [SI]']);
}

/** Objective of every evaluation that keeps all limits, and the best so far. */
function convergence(node) {
  const goal = summary.objective;
  const column = rows.columns.find((c) => c.name === goal.metric);
  if (!column || rows.count < 2) return;
  const limits = summary.best.constraints.map((c) => ({ column: rows.columns.find((r) => r.name === metricOfLimit(c.text)), least: isLowerLimit(c.text), limit: c.limit })).filter((l) => l.column);
  const keeps = (i) => limits.every((l) => { const v = l.column.values[i]; const slack = 1e-6 * Math.abs(l.limit); return l.least ? v >= l.limit - slack : v <= l.limit + slack; });
  const unit = displayUnit(largest([column.values]), column.unit);
  const n = rows.count;
  const inside = new Float64Array(n).fill(NaN);
  const outside = new Float64Array(n).fill(NaN);
  const best = new Float64Array(n).fill(NaN);
  let record = NaN;
  for (let i = 0; i < n; ++i) {
    const v = column.values[i] / unit.divisor;
    if (!Number.isFinite(v)) { best[i] = record; continue; }
    if (keeps(i)) { inside[i] = v; if (!(goal.sense === 'maximize' ? v <= record : v >= record)) record = v; } else outside[i] = v;
    best[i] = record;
  }
  node.append(legend([{ name: 'best so far', colour: 'c0' }, { name: 'keeps every limit', colour: 'c2', kind: 'dot' }, { name: 'breaks a limit', colour: 'faint', kind: 'dot' }]));
  chart(node, Float64Array.from({ length: n }, (_, i) => i + 1), [{ name: 'breaks a limit', y: outside, colour: 'faint', scatter: true }, { name: 'keeps every limit', y: inside, colour: 'c2', scatter: true }, { name: 'best so far', y: best, colour: 'c0', steps: true }],
    { name: 'convergence', x: { label: 'evaluation' }, y: { label: axisLabel(goal.metric, unit), range: paddedRange([inside, outside, best]) }, height: 280 });
}

function stagesTable() {
  const unit = unitOf(summary.objective.metric);
  return table('starts', ['run', 'solver', 'it said', summary.objective.metric, 'keeps the limits', 'evaluations'],
    summary.stages.map((s) => [words(s.stage), words(s.solver), words(s.word), quantity(s.objective, unit), words(s.feasible ? 'yes' : 'no', s.feasible ? 'good-word' : 'bad-word'), { text: String(s.evaluations), value: s.evaluations }]));
}

function relaxationCard() {
  const r = summary.relaxation;
  if (!r) return;
  const node = card('What would make it possible', 'How far each limit has to give way: all together, and if it is the only one.', 'wide');
  const lines = r.limits.map((l) => { const unit = unitOf(metricOfLimit(l.text)); return [words(l.text), quantity(l.limit, unit), quantity(l.amount, unit), l.alone === null ? words('does not help alone') : quantity(l.alone, unit)]; });
  node.append(table('relaxation', ['limit', 'asked for', 'give way by, all together', 'by, this one alone'], lines));
}

function certificateText(certificate) {
  return certificate.passed ? 'Certified by an independent check: no feasible change improves it to first order (stationarity ' + rounded(certificate.stationarity, 2) + ').' : 'Not certified as an optimum: ' + certificate.reason;
}

function searchPage() {
  relaxationCard();
  if (!summary.best) return;
  const goalUnit = unitOf(summary.objective.metric);
  const names = Object.keys(summary.best.design);
  const limits = card('What stops it', 'Letting a limit that binds give way changes the goal; the others can be forgotten.', 'wide');
  limits.append(limitsTable(summary.best, goalUnit));
  const design = card('The design', 'What the search was free to change.', 'half');
  const columns = [{ name: 'before', values: summary.before.design }, { name: 'best', values: summary.best.design }];
  design.append(valuesTable('design', 'parameter', names, columns));
  const metrics = card('Metrics', null, 'half');
  metrics.append(valuesTable('metrics', 'metric', Object.keys(summary.best.metrics), [{ name: 'before', values: summary.before.metrics }, { name: 'best', values: summary.best.metrics }]));
  const labels = { before: 'before', best: 'best design' };
  const list = curves.filter(Boolean);
  if (list.length) curveSection(list, list.map((c) => labels[c.label]), 'Torque: before and after');
  convergence(card('How the search went', certificateText(summary.best.certificate), 'half'));
  card('The starts', 'Each run of a solver, and what it said of itself.', 'half').append(stagesTable());
}
