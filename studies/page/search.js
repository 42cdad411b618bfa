// SPDX-License-Identifier: Apache-2.0
// optimize and size: before against after, limits, how the search went.

import {paddedRange} from './chart.js';
import {CurveSection} from './curve.js';
import {curves, data, rowNumber, rows, summary, unitOf} from './data.js';
import {designerButton} from './designer/inside.js';
import {card, sentence} from './dom.js';
import {figure} from './figure.js';
import {savedMotor} from './motor.js';
import {movesCard} from './moves.js';
import {csvText, named, parameterCell, quantity, table, tableSaved, valuesTable, words} from './table.js';
import {tellSections} from './telling.js';
import {between, displayUnit, engineering, printed} from './units.js';
import {axisLabel, goalText, goalValue, holderList, keepsLimits, limitWords, plain, rateWords} from './words.js';
import {ratioUnit, signed, slopeText, standingName, standingState, wholeEnds} from './words.js';

const none = {
  text: '-',
  value: null
};

/** The cells of a limit that binds: 1 % of it, what that changes, and with one goal what a unit of it is worth. */
function worthCells(s, goals) {
  const one = goals.length === 1;
  if (s.state !== 'binds') return Array(1 + goals.length + (one ? 2 : 0)).fill(none);
  const changes = goals.map((g, k) => ({text: signed(s.changes[k], unitOf(g.metric)), value: s.changes[k]}));
  if (!one) return [quantity(s.moved, s.unit), ...changes];
  const slope = {text: slopeText(s.multiplier, unitOf(goals[0].metric), s.unit), value: s.multiplier};
  return [quantity(s.moved, s.unit), ...changes, {text: rateWords(s, goals[0]), value: s.multiplier}, slope];
}

/** What each limit is doing, and what moving it by 1 % changes; with one goal also its multiplier. */
export function limitsTable(standings, goals) {
  const one = goals.length === 1;
  const change = (name, unit) => 'changes ' + name + ' by' + unit;
  const header = [
    'limit', 'state', 'value', 'to spare', '1 % looser is', ...goals.map((g) => change(plain(g.metric), '')),
    ...(one ? ['worth', 'multiplier'] : [])
  ];
  const csvHeader = [
    'limit', 'state', 'value [SI]', 'to spare [SI]', '1 % looser is [SI]',
    ...goals.map((g) => change(g.metric, ' [' + unitOf(g.metric) + ']')),
    ...(one ? ['multiplier [SI]', 'multiplier in'] : [])
  ];
  const key = (s) => s.variable ?? s.text;
  const lines = standings.map(
      (s) =>
          [{text: standingName(s), value: key(s), words: true},
           words(standingState(s), s.state === 'holds' ? 'good-word' : 'bad-word'), quantity(s.value, s.unit),
           s.slack === 0 ? {text: '0', value: 0} : quantity(s.slack, s.unit, 3), ...worthCells(s, goals)]);
  const saved = standings.map(
      (s, i) =>
          [key(s), standingState(s), ...lines[i].slice(2, 5 + goals.length).map((c) => c.value),
           ...(one ? [s.multiplier, ratioUnit(unitOf(goals[0].metric), s.unit)] : [])]);
  return tableSaved('limits', header, lines, () => csvText(csvHeader, saved));
}

/** Every evaluation's value of the goal, by whether it keeps the limits, and the best so far. */
function searchTrace(goal, values) {
  const keeps = keepsLimits(data.standings.best);
  const better = goal.sense === 'maximize' ? (a, b) => a > b : (a, b) => a < b;
  const empty = () => new Float64Array(rows.count).fill(NaN);
  const trace = {inside: empty(), outside: empty(), best: empty()};
  let record = NaN;
  values.forEach((v, i) => {
    if (Number.isFinite(v) && keeps(i)) {
      trace.inside[i] = v;
      if (!(record === record) || better(v, record)) record = v;
    } else if (Number.isFinite(v))
      trace.outside[i] = v;
    trace.best[i] = record;
  });
  return trace;
}

/**
 * The range in which the search went on: that of the motors that keep the limits, the worst tenth of them aside, or
 * else of the middle half of all. What lies beyond is drawn at the edge, so that it flattens nothing.
 */
function searchRange(goal, {inside, outside, best}) {
  const sorted = (list) => list.filter(Number.isFinite).sort();
  const kept = sorted(inside);
  if (kept.length < 10) {
    const all = sorted(Float64Array.from([...inside, ...outside]));
    return paddedRange([[all[Math.floor(all.length / 4)], all[Math.floor((3 * all.length) / 4)]], best, kept]);
  }
  const worst = goal.sense === 'maximize' ? kept[Math.floor(kept.length / 10)] : kept[Math.ceil(0.9 * kept.length) - 1];
  return paddedRange([[worst], best]);
}

function searchCard() {
  const goal = summary.objective;
  const column = rows.columns.find((c) => c.name === goal.metric);
  if (!summary.best || !column || rows.count < 2) return;
  const trace = searchTrace(goal, column.values);
  const ends = searchRange(goal, trace);
  const unit = displayUnit(Math.max(...ends.map(Math.abs)), column.unit);
  const range = ends.map((v) => v / unit.divisor);
  let beyond = 0;
  const shown = (list) => Float64Array.from(list, (v) => {
    const inRange = Math.min(Math.max(v / unit.divisor, range[0]), range[1]);
    if (Number.isFinite(v) && inRange !== v / unit.divisor) ++beyond;
    return inRange;
  });
  // Limits hold without tolerances here, so the best of these motors is not the best under tolerances.
  const kept = 'keeps every limit' + (summary.robust ? ' without tolerances' : '');
  const best = {name: 'best so far', y: shown(trace.best), colour: 'c0', steps: true};
  const series = [
    {name: 'breaks a limit', y: shown(trace.outside), colour: 'faint', scatter: true},
    {name: kept, y: shown(trace.inside), colour: 'c2', scatter: true}, ...(summary.robust ? [] : [best])
  ];
  const edge = beyond ? ' ' + beyond + ' of them lie beyond the axis and stand at its edge.' : '';
  const node = card('How the search went', 'The motors that were computed, in order.' + edge, 'wide');
  const x = Float64Array.from({length: rows.count}, (_, i) => rowNumber(i));
  figure(node, x, series, {
    name: 'convergence',
    title: 'How the search went',
    legend: [...series].reverse().map((s) => ({name: s.name, colour: s.colour, kind: s.scatter ? 'dot' : ''})),
    x: {label: 'evaluation', range: [x[0], x[x.length - 1]]},
    y: {label: axisLabel(goal.metric, unit), range},
    tell: (i) => [['motor', String(x[i])], [plain(goal.metric), engineering(column.values[i], column.unit)]],
    height: 280
  });
}

function startsCard() {
  const goal = summary.objective;
  const note = 'Each run of a solver, and the code that it returned. ' +
      (summary.relaxation || !summary.best ? '' : certificateText(summary.best.certificate));
  const sliced = summary.stages.some((s) => s.slices !== undefined);
  const header = [
    'run', 'solver', 'solver\'s return code', plain(goal.metric), 'keeps the limits', 'evaluations',
    ...(sliced ? ['radial_slices'] : [])
  ];
  const lines = summary.stages.map(
      (s) =>
          [words(s.stage), words(s.solver), words(s.word), {text: goalText(goal, s.objective), value: s.objective},
           words(s.feasible ? 'yes' : 'no', s.feasible ? 'good-word' : 'bad-word'),
           {text: String(s.evaluations), value: s.evaluations},
           ...(sliced ? [parameterCell('radial_slices', s.slices)] : [])]);
  if (lines.length) card('The runs of the solvers', note, 'wide').append(table('starts', header, lines));
}

export function relaxationCard() {
  const r = summary.relaxation;
  if (!r) return;
  const note = 'How far each limit has to be loosened: together with the others, or alone.';
  const node = card('What would make it possible', note, 'wide');
  const lines = r.limits.map(
      (l) =>
          [{text: limitWords(l.text), value: l.text, words: true}, quantity(l.limit, l.unit),
           quantity(l.amount, l.unit),
           l.amount_alone === null ? words('does not help alone') : quantity(l.amount_alone, l.unit)]);
  const header = ['limit', 'asked for', 'loosened with the others', 'loosened alone'];
  node.append(table('relaxation', header, lines));
  const ends = r.ranges.map((end) => {
    const unit = unitOf(end.variable);
    return [
      named(end.variable), words(end.side === 'upper' ? 'largest' : 'smallest'), quantity(end.limit, unit),
      end.limit_alone === null ? words('none found') : quantity(end.limit_alone, unit)
    ];
  });
  const endHeader = ['parameter', 'end of its range', 'given', 'moved alone'];
  if (ends.length) node.append(table('range-ends', endHeader, ends));
}

/** What the word "optimal" rests on. */
export function certificateText(certificate) {
  if (!certificate.passed)
    return 'Not certified as an optimum' + (certificate.reason ? ': ' + certificate.reason : '') + '.';
  const rounding = certificate.stationarity < 1e-10;  // of the slope itself
  const left = rounding ? 'nothing but rounding is left of the slope' :
                          'what is left of the slope, relative to the slope: ' + printed(certificate.stationarity, 2);
  return 'Certified by exact derivatives, independent of the solver: no small change within the limits improves it (' +
      left + ').';
}

/**
 * The runs with as many slices as the last one, which found the answer; values of others differ by their slices'
 * error.
 */
function comparableRuns() {
  const runs = summary.stages.filter((s) => s.solver);
  const last = runs[runs.length - 1];
  return {runs: runs.filter((s) => s.slices === last.slices), before: runs.filter((s) => s.slices !== last.slices)};
}

/** Where the answer's runs began, if runs with another number of slices came first. */
function coarseText(before) {
  if (!before.length) return '';
  const slices = before[before.length - 1].slices;
  const few = slices < 0 ? 'auto ' + -slices : slices;
  const count = before.length === 1 ? 'one run' : before.length + ' runs';
  return '; ' + count + ' from different starts with radial_slices ' + few +
      ' came first to find where to begin, and their values are not comparable with it';
}

/** How many runs came to the best value. */
function runsText(runs, best, choosing) {
  const alike = summary.stages.length > 1 ? ' with the slices of the answer' : '';
  if (runs.length === 1) return 'the one run of a solver' + alike + ' ended there';
  const same = runs.filter((s) => s.feasible && Math.abs(s.objective - best) <= 1e-6 * Math.abs(best)).length;
  const wide = runs.filter((s) => data.global_solvers.includes(s.solver)).length;
  return same + ' of ' + runs.length + ' runs of solvers from different starts' + choosing +
      ' ended at this value, none within the limits at a better one' +
      (wide ? ', ' + (wide === 1 ? 'one' : wide) + ' of them a global search' : '');
}

/** How far "local" can be trusted. */
function startsText() {
  const {best} = summary;
  const value = goalValue(best, summary.objective);
  if (value === null || !summary.stages.some((s) => s.solver)) return '';
  const {runs, before} = comparableRuns();
  const whole = Object.keys(best.design).filter((n) => data.parameters[n]?.integer);
  const held = [...Object.keys(best.choice || {}), ...whole];
  const choosing = held.length ? ' and ' + (best.choice ? 'choices' : 'whole numbers') : '';
  const tail = held.length ? ' Held in each run: ' + held.map(plain).join(', ') +
          '; the limits above are worth so much at what was found for ' + (held.length > 1 ? 'them' : 'it') + '.' :
                             '';
  return 'It is a local optimum: ' + runsText(runs, value, choosing) + coarseText(before) +
      '. A better design far from all of them cannot be ruled out.' + tail;
}

/** What a sample of the whole range said of it. */
function scanText() {
  const {scan} = summary;
  if (!scan || !scan.designs) return '';
  const sample = scan.designs + ' designs sampled over the whole range';
  const keep = summary.best.constraints.length ? ' (' + scan.feasible + ' of them keep the limits)' : '';
  if (!scan.better) return 'None of ' + sample + ' is better' + keep + '.';
  const before = goalText(summary.objective, scan.before);
  const found = ' were better than the ' + before +
      ' that the searches had ended at; a search from the best of them found this design.';
  const missed = ' are better, but the search from the best of them found no answer: raise max_evaluations.';
  return scan.better + ' of ' + sample + (scan.replaced ? found : missed);
}

const efficiencyNote = 'Contact efficiency is the rotor\'s output over the power that the stator gives to the ' +
    'contact; efficiency counts the power lost in the vibrating stator as well, so it is the smaller one.';

/** Why the contact efficiency is above the efficiency, where both are shown. */
export function metricsNote(names) {
  const own = names.map((n) => data.names[n]?.metric ?? n);
  const of = (list) => own.some((n) => list.includes(n));
  const both =
      of(['contact_efficiency_at_peak_power', 'contact_efficiency_at']) && of(['max_efficiency', 'efficiency_at']);
  return both ? efficiencyNote : null;
}

/** Before and after, what was chosen, and the range that the search had. */
export function designTable(file, names, columns, choice = {}) {
  const range = (n) => (data.ranges || {})[n];
  const ends = (n) => words(range(n) ? between(range(n).min, range(n).max, unitOf(n)) : '');
  const sets = Object.entries(choice).map(([n, set]) => [n, columns.map((c) => (c.name === 'before' ? '' : set))]);
  const lines = [
    ...names.map((n) => [named(n), ...columns.map((c) => parameterCell(n, c.values[n])), ends(n)]),
    ...sets.map(([n, chosen]) => [named(n), ...chosen.map((set) => words(set)), words('chosen')])
  ];
  const saved = [
    ...names.map((n) => [n, unitOf(n), ...columns.map((c) => c.values[n]), range(n)?.min, range(n)?.max]),
    ...sets.map(([n, chosen]) => [n, '', ...chosen, '', ''])
  ];
  const titles = columns.map((c) => c.name);
  const header = ['parameter', 'SI unit', ...titles, 'smallest', 'largest'];
  return tableSaved(file, ['parameter', ...titles, 'range'], lines, () => csvText(header, saved));
}

/** What stops the best design: in words, then the table. */
function limitsCard() {
  if (!summary.best || !data.standings.best.length) return;
  const goals = [summary.objective];
  const note = 'A limit that binds holds the design back; loosened by 1 % it changes the ' +
      plain(summary.objective.metric) +
      ' as said, to first order, with everything else chosen anew. The others have room.';
  const node = card('What stops it', note, 'wide');
  const list = data.standings.best;
  if (list.some((s) => s.state === 'binds') || wholeEnds(summary.best).length)
    node.append(holderList(summary.best, list, goals));
  node.append(limitsTable(list, goals));
}

function designCards() {
  if (!summary.best) return;
  const names = Object.keys(summary.best.design);
  const columns = [{name: 'before', values: summary.before.design}, {name: 'best', values: summary.best.design}];
  const design = card('The design', 'What the search was free to change.', 'half');
  design.append(designTable('design', names, columns, summary.best.choice));
  design.append(savedMotor(data.files[0], designerButton(summary.best.design, 'best design')));
  const metricNames = Object.keys(summary.best.metrics);
  card('Metrics', metricsNote(metricNames), 'half').append(valuesTable('metrics', 'metric', metricNames, [
    {name: 'before', values: summary.before.metrics}, {name: 'best', values: summary.best.metrics}
  ]));
}

/** How sure it is that there is nothing better. */
function trustCard() {
  if (!summary.best || summary.relaxation) return;
  const {certificate} = summary.best;
  const lines = [certificate.passed && !summary.robust ? startsText() : certificateText(certificate), scanText()];
  card('How sure it is', null, 'wide', ...lines.filter(Boolean).map((line) => sentence(line)));
}

/** The page of a search, from top to bottom. */
export function searchSections() {
  const list = curves.filter(Boolean);
  const names = list.map((c) => ({before: 'before', best: 'best design'})[c.label]);
  const section = list.length ? new CurveSection(list, names) : null;
  const title = list.length > 1 ? 'Torque: before and after' : 'Torque of the motor as it was';
  return [
    () => section?.torque(title, data.standings.best), relaxationCard, limitsCard, () => tellSections(), designCards,
    trustCard, () => summary.best && movesCard((n) => summary.best.design[n] ?? summary.best.metrics[n]),
    () => section?.others(), searchCard, startsCard
  ];
}
