// SPDX-License-Identifier: Apache-2.0
'use strict';
// The page, from top to bottom.

const kindWords = { curve: 'torque-speed curves', sweep: 'sweep of designs', sensitivity: 'sensitivity', optimize: 'optimization', size: 'sizing for a duty', pareto: 'trade-off front', uncertainty: 'spread under tolerances', calibrate: 'calibration', frequency: 'sweep of the frequency' };

/** Value of the family's parameter, all members in one unit. */
function memberValue(c) {
  const { parameter, unit } = summary.family;
  const shown = displayUnit(largest([(summary.curves || summary.responses).map((m) => m[parameter])]), unit);
  return rounded(c[parameter] / shown.divisor) + (shown.text ? noBreak + shown.text : '');
}

function curvePage() {
  const shown = summary.curves.map((c, i) => [c, curves[i]]).filter(([, c]) => c);
  const names = shown.map(([c]) => (summary.family ? plain(summary.family.parameter) + ' ' + memberValue(c) : data.motor.name || 'motor'));
  curveSection(shown.map(([, c]) => c), names);
  card('Metrics', metricsNote(Object.keys(summary.curves[0].metrics)), 'wide').append(valuesTable('metrics', 'metric', Object.keys(summary.curves[0].metrics), summary.curves.map((c, i) => ({ name: names[i] || String(i + 1), values: c.metrics }))));
}

const pages = { curve: curvePage, sweep: sweepPage, sensitivity: sensitivityPage, optimize: searchPage, size: searchPage, pareto: paretoPage, uncertainty: uncertaintyPage, calibrate: calibratePage, frequency: frequencyPage };

const outcomeWords = { feasible: 'keeps the limits, not shown to be best', infeasible: 'no design keeps the limits', budget: 'stopped by its budget', failed: 'nothing could be computed', done: 'complete', fitted: 'the motor follows the points', poor: 'the motor does not follow the points', several: 'several motors fit equally well', undetermined: 'the points do not determine every parameter', 'at-bounds': 'every parameter at an end of its range', interrupted: 'interrupted' };

function outcomeText() {
  if (summary.outcome === 'optimal') return summary.kind === 'pareto' ? 'every point certified' : 'certified local optimum';
  if (summary.outcome === 'done' && summary.yield) return percent(summary.yield.value, 4) + ' keep the limits';
  return outcomeWords[summary.outcome] || summary.outcome;
}

/** Of a kind that has no verdict of its own. */
function plainVerdict() { return { look: summary.outcome === 'failed' ? 'bad' : 'good', lines: [sentence(bold(capital(outcomeText())), '.')] }; }

/** What a row of the results is: a motor, or a point of a motor's curve. */
function rowWord() { return summary.kind === 'curve' || summary.kind === 'frequency' ? 'points' : 'motors'; }

/** Said where the results are too many for a page. */
function partNote() {
  if (rows.every === 1) return null;
  return sentence('This page holds one in ' + rows.every + ' of the ' + rows.total + ' ' + rowWord() + ' that were computed; results.csv has all of them.');
}

function facts() {
  const failed = Object.values(summary.failures).reduce((a, b) => a + b, 0);
  const list = [['outcome', outcomeText()], [rowWord() + ' computed', String(summary.evaluations)], ['of these without a full answer', String(failed)]];
  return el('div', { class: 'facts' }, list.map(([name, value]) => el('div', {}, el('span', {}, name), el('strong', {}, value))));
}

function failuresCard() {
  if (!summary.failure_regions.length) return;
  const where = (r) => Object.entries(r.where).filter(([, v]) => v.low !== null).map(([n, v]) => plain(n) + ' ' + (v.high > v.low ? between(v.low, v.high, unitOf(n)) : engineering(v.low, unitOf(n)))).join(', ');
  card(capital(rowWord()) + ' without a full answer', 'A number that was asked for does not exist for these ' + rowWord() + ', or could not be computed. They are counted here and enter nothing else.', 'wide').append(table('failures', ['reason', 'meaning', 'count', 'where'], summary.failure_regions.map((r) => [words(r.reason), words(failureText(r.reason)), { text: String(r.count), value: r.count }, words(where(r))])));
}

/** What the names on this page stand for. */
function glossaryCard() {
  const names = [...new Set([...rows.columns.map((c) => c.name), ...curves.filter(Boolean).flatMap((c) => Object.keys(c.metrics))].map((n) => n.replace(/\(.*$/s, '')))];
  const lines = names.map((n) => [n, data.metrics[n] || data.parameters[n]]).filter(([, known]) => known).map(([n, known]) => [named(n), words(known.text), words(n)]);
  if (!lines.length) return;
  card('What the names mean', null, 'wide').append(el('details', {}, el('summary', {}, lines.length + ' names'), el('p', {}, efficiencyNote), table('names', ['name', 'what it is', 'as typed'], lines)));
}

function motorCard() {
  const names = Object.keys(data.motor.design);
  const lines = names.map((n) => [named(n), words(data.parameters[n].symbol), quantity(data.motor.design[n], data.parameters[n].unit), words(data.parameters[n].text)]);
  card('The motor of the study', data.motor.name, 'wide', designerButton({}, data.motor.name)).append(table('motor', ['parameter', 'symbol', 'value', 'what it is'], lines));
}

function provenanceCard() {
  const build = summary.build || {};
  const lines = [['twum', summary.version], ['started', summary.started], ['time', rounded(summary.seconds, 3) + ' s'], ['seed', String(summary.seed)], ['hash of the study', summary.hash], ['compiler', build.compiler], ...Object.entries(build.libraries || {})]
    .filter(([, v]) => v !== undefined && v !== null && v !== '').map(([n, v]) => [words(n), words(String(v))]);
  card('Where this comes from', null, 'half').append(table('provenance', ['what', 'value'], lines));
  card('The study', 'As it was run, every default written out.', 'half').append(el('pre', { tabindex: '0' }, data.study));
}

function build() {
  document.title = summary.study + ' - twum';
  const page = document.getElementById('page');
  page.append(el('header', {}, el('h1', {}, summary.study), el('p', { class: 'of' }, (kindWords[summary.kind] || summary.kind) + (summary.motor ? ' of ' + summary.motor : ''))));
  const verdict = summary.outcome === 'interrupted' ? { look: 'bad', lines: [sentence(bold('This study was interrupted'), '; what is here is not all of it.')] } : (verdicts[summary.kind] || plainVerdict)();
  (summary.model_notes || []).forEach((note) => verdict.lines.push(sentence(bold('Mind the model: '), plainNames(note), '.')));
  const top = card(null, null, 'wide', ...verdict.lines, facts(), partNote());
  top.classList.add('verdict', verdict.look);
  pages[summary.kind]();
  failuresCard();
  motorCard();
  glossaryCard();
  provenanceCard();
  page.dataset.ready = 'yes';
}

build();
