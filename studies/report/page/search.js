// SPDX-License-Identifier: Apache-2.0
'use strict';
// optimize and size: before against after, limits, how the search went.

/** What each limit is doing, and what moving it by 1 % changes; with one goal also its multiplier. */
function limitsTable(report, goals) {
  const one = goals.length === 1;
  const header = ['limit', 'state', 'value', 'to spare', '1 % looser is', ...goals.map((g) => 'changes ' + plain(g.metric) + ' by'), ...(one ? ['worth', 'multiplier'] : [])];
  const csvHeader = ['limit', 'state', 'value [SI]', 'to spare [SI]', '1 % looser is [SI]', ...goals.map((g) => 'changes ' + g.metric + ' by [' + unitOf(g.metric) + ']'), ...(one ? ['multiplier [SI]', 'multiplier in'] : [])];
  const list = standings(report, goals);
  const lines = list.map((s) => [{ text: s.name, value: s.key, words: true }, words(s.state, s.state === 'holds' ? 'good-word' : 'bad-word'), quantity(s.value, s.unit), s.slack === 0 ? { text: '0', value: 0 } : quantity(s.slack, s.unit, 3),
    ...(s.active ? [quantity(s.moved, s.unit), ...goals.map((g, k) => ({ text: signed(s.changes[k], unitOf(g.metric)), value: s.changes[k] }))] : [{ text: '-', value: null }, ...goals.map(() => ({ text: '-', value: null }))]),
    ...(one ? [{ text: s.active ? rateWords(s, goals[0]) : '-', value: s.multiplier }, { text: s.active ? rounded(s.multiplier) + ' ' + ratioUnit(unitOf(goals[0].metric), s.unit) : '-', value: s.multiplier }] : [])]);
  const node = table('limits', header, lines);
  const plainLine = (s, l) => [s.key, s.state, ...l.slice(2, 5 + goals.length).map((c) => c.value), ...(one ? [s.multiplier, ratioUnit(unitOf(goals[0].metric), s.unit)] : [])];
  node.lastChild.replaceWith(saveButton('limits', () => csvText(csvHeader, list.map((s, i) => plainLine(s, lines[i])))));
  return node;
}

/** Objective of every evaluation that keeps all limits, and the best so far. */
function convergence(node) {
  const goal = summary.objective;
  const column = rows.columns.find((c) => c.name === goal.metric);
  if (!column || rows.count < 2) return;
  const keeps = keepsLimits(summary.best);
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
  chart(node, Float64Array.from({ length: n }, (_, i) => rowNumber(i)), [{ name: 'breaks a limit', y: outside, colour: 'faint', scatter: true }, { name: 'keeps every limit', y: inside, colour: 'c2', scatter: true }, { name: 'best so far', y: best, colour: 'c0', steps: true }],
    { name: 'convergence', x: { label: 'evaluation' }, y: { label: axisLabel(goal.metric, unit), range: paddedRange([inside, outside, best]) }, height: 280 });
}

function stagesTable() {
  return table('starts', ['run', 'solver', 'it said', plain(summary.objective.metric), 'keeps the limits', 'evaluations'],
    summary.stages.map((s) => [words(s.stage), words(s.solver), words(s.word), { text: goalText(summary.objective, s.objective), value: s.objective }, words(s.feasible ? 'yes' : 'no', s.feasible ? 'good-word' : 'bad-word'), { text: String(s.evaluations), value: s.evaluations }]));
}

function relaxationCard() {
  const r = summary.relaxation;
  if (!r) return;
  const node = card('What would make it possible', 'How far each limit has to give way: all together, and if it is the only one.', 'wide');
  const lines = r.limits.map((l) => { const unit = l.unit; return [{ text: limitWords(l.text), value: l.text, words: true }, quantity(l.limit, unit), quantity(l.amount, unit), l.alone === null ? words('does not help alone') : quantity(l.alone, unit)]; });
  node.append(table('relaxation', ['limit', 'asked for', 'to loosen, all together', 'to loosen, this one alone'], lines));
  const ends = (r.ranges || []).map((end) => { const unit = unitOf(end.variable); return [named(end.variable), words(end.side === 'upper' ? 'largest' : 'smallest'), quantity(end.limit, unit), end.alone === null ? words('none found') : quantity(end.alone, unit)]; });
  if (ends.length) node.append(table('range-ends', ['parameter', 'end of its range', 'asked for', 'to move to, this one alone'], ends));
}

const globalSolver = /nlopt:(isres|crs2|esch|.*direct|.*mlsl|stogo|ags)/;

/** What the word "optimal" rests on. */
function certificateText(certificate) {
  if (certificate.passed) return 'Certified by exact derivatives, whatever the solver said: no small change within the limits improves it (what is left of the slope, relative to the slope: ' + rounded(certificate.stationarity, 2) + ').';
  return 'Not certified as an optimum' + (certificate.reason ? ': ' + certificate.reason : '') + '.';
}

/** How many runs came to the best value, and so how far "local" can be trusted. */
function startsText() {
  const best = goalValue(summary.best, summary.objective);
  const runs = summary.stages.filter((s) => s.solver);
  if (best === null || !runs.length) return '';
  const same = runs.filter((s) => s.feasible && Math.abs(s.objective - best) <= 1e-6 * Math.abs(best)).length;
  const wide = runs.filter((s) => globalSolver.test(s.solver)).length;
  const whole = [...Object.keys(summary.best.choice || {}), ...Object.keys(summary.best.design).filter((n) => (data.parameters[n] || {}).integer)];
  return 'It is a local optimum: ' + (runs.length === 1 ? 'the one run of a solver ended there' : same + ' of ' + runs.length + ' runs of solvers from different starts' + (whole.length ? ' and ' + (summary.best.choice ? 'choices' : 'whole numbers') : '') + ' ended at this value, none within the limits at a better one')
    + (wide ? ', ' + (wide === 1 ? 'one' : wide) + ' of them a global search' : '') + '. A better design far from all of them cannot be ruled out.'
    + (whole.length ? ' Held in each run: ' + whole.map(plain).join(', ') + '; the limits above are worth so much at what was found for ' + (whole.length > 1 ? 'them' : 'it') + '.' : '');
}

/** What a sample of the whole range said of it. */
function scanText() {
  const scan = summary.scan; // results of earlier versions have none
  if (!scan || !scan.designs) return '';
  const sample = scan.designs + ' designs sampled over the whole range';
  if (!scan.better) return 'None of ' + sample + ' is better' + (summary.best.constraints.length ? ' (' + scan.feasible + ' of them keep the limits)' : '') + '.';
  const before = engineering(scan.before, unitOf(summary.objective.metric));
  return scan.better + ' of ' + sample + (scan.replaced ? ' were better than the ' + before + ' that the searches had ended at; a search from the best of them found this design.' : ' are better, but the search from the best of them found no answer: raise max_evaluations.');
}

const efficiencyNote = 'Contact efficiency is the rotor\'s output over the power that the stator gives to the contact; efficiency counts the power lost in the vibrating stator as well, so it is the smaller one.';

/** Why the contact efficiency is above the efficiency, where both are shown. */
function metricsNote(names) {
  return names.some((n) => n.startsWith('contact_efficiency')) && names.some((n) => /^(max_)?efficiency/.test(n)) ? efficiencyNote : null;
}

/** Before and after, what was chosen, and the range that the search had. */
function designTable(names, columns, choice = {}) {
  const range = (n) => (Object.hasOwn(data.ranges || {}, n) ? data.ranges[n] : null);
  const ends = (n) => { const r = range(n); return r === null ? words('') : words(between(r.min, r.max, unitOf(n))); };
  const chosen = Object.entries(choice);
  const lines = [...names.map((n) => [named(n), ...columns.map((c) => quantity(c.values[n], unitOf(n))), ends(n)]),
    ...chosen.map(([n, set]) => [named(n), ...columns.map((c) => words(c.name === 'before' ? '' : set)), words('chosen')])];
  const node = table('design', ['parameter', ...columns.map((c) => c.name), 'range'], lines);
  node.lastChild.replaceWith(saveButton('design', () => csvText(['parameter', 'SI unit', ...columns.map((c) => c.name), 'smallest', 'largest'], [...names.map((n) => [n, unitOf(n), ...columns.map((c) => c.values[n]), range(n)?.min, range(n)?.max]), ...chosen.map(([n, set]) => [n, '', ...columns.map((c) => (c.name === 'before' ? '' : set)), '', ''])])));
  return node;
}

function searchPage() {
  relaxationCard();
  if (!summary.best) return;
  const names = Object.keys(summary.best.design);
  const limits = card('What stops it', 'A limit that binds holds the design back; loosened by 1 % it changes the ' + plain(summary.objective.metric) + ' as said, to first order, with everything else chosen anew. The others have room.', 'wide');
  limits.append(limitsTable(summary.best, [summary.objective]));
  robustCards();
  const design = card('The design', 'What the search was free to change.', 'half');
  const columns = [{ name: 'before', values: summary.before.design }, { name: 'best', values: summary.best.design }];
  design.append(designTable(names, columns, summary.best.choice));
  const explore = designerButton(summary.best.design, 'best design');
  if (explore) design.append(explore);
  const metricNames = Object.keys(summary.best.metrics);
  const metrics = card('Metrics', metricsNote(metricNames), 'half');
  metrics.append(valuesTable('metrics', 'metric', metricNames, [{ name: 'before', values: summary.before.metrics }, { name: 'best', values: summary.best.metrics }]));
  const labels = { before: 'before', best: 'best design' };
  const list = curves.filter(Boolean);
  if (list.length) curveSection(list, list.map((c) => labels[c.label]), 'Torque: before and after');
  if (rows.columns.some((c) => c.name === summary.objective.metric)) convergence(card('How the search went', 'The motors that were computed, in order.', 'half'));
  card('The starts', 'Each run of a solver, and what it said of itself. ' + (summary.relaxation ? '' : certificateText(summary.best.certificate)), 'half short').append(stagesTable());
}
