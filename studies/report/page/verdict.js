// SPDX-License-Identifier: Apache-2.0
'use strict';
// What came out, in words: the answer, what stops it, what moving that would give.

function bold(text) { return el('b', {}, text); }
function sentence(...parts) { return el('p', {}, ...parts); }

/** A list of lines, each of words and nodes. */
function bullets(lines) { return el('ul', { class: 'holders' }, lines.map((line) => el('li', {}, line))); }

/** "preload ≤ 100 N": an end of a range, at its own place or at another. */
function rangeWords(end, limit) { return plain(end.variable) + (end.side === 'upper' ? ' ≤ ' : ' ≥ ') + engineering(limit, unitOf(end.variable)); }

/** A limit that cannot be kept even alone, its best value, and the ends of ranges where that is. */
function impossibleWords(limit) {
  const ends = limit.ends.map((i) => rangeWords(summary.relaxation.ranges[i], summary.relaxation.ranges[i].limit));
  return limitWords(limit.text) + ' cannot be reached: the ' + (limit.sense === 'at least' ? 'most' : 'least') + ' found within the ranges is ' + engineering(limit.best, limit.unit) + (ends.length ? ', at ' + ends.join(' and ') : '') + (limit.choice ? ', with ' + choiceWords(limit).slice(0, -2) : '') + '.';
}

/** What is at fault: limits impossible by themselves first, then those that exclude each other. */
function causeSentences(r) {
  const impossible = r.impossible || []; // results of earlier versions have none
  const group = r.conflict.filter((text) => !impossible.some((limit) => limit.text === text)).map(limitWords);
  const lines = impossible.map((limit) => sentence(impossibleWords(limit)));
  if (group.length === 1) lines.push(sentence(group[0] + ' is out of reach.'));
  if (group.length > 1) lines.push(sentence((impossible.length ? 'The others exclude each other as well: ' : 'These cannot hold together: ') + group.join('; ') + '.'));
  return lines;
}

/** Limits that no design satisfies, and the least that would do. */
function relaxationVerdict() {
  const r = summary.relaxation;
  const limits = r.limits.filter((l) => l.alone).map((l) => {
    const unit = l.unit;
    return limitWords(l.text) + ' by ' + engineering(l.alone, unit, 3) + ', to ' + engineering(l.limit + (l.sense === 'at least' ? -l.alone : l.alone), unit, 3);
  });
  const ranges = (r.ranges || []).filter((end) => end.alone !== null).map((end) => 'the range of ' + rangeWords(end, end.limit) + ', to ' + engineering(end.alone, unitOf(end.variable), 3));
  const least = [...limits, ...ranges];
  const cure = least.length === 0 ? 'Loosening a single limit is not enough; the table below says what would be.'
    : least.length === 1 ? 'It would be possible with this limit loosened: ' + least[0] + '.' : 'It would be possible with one of these limits loosened: ' + least.join('; or ') + '.';
  return { look: 'bad', lines: [sentence(bold('No design keeps every limit.')), ...causeSentences(r), ...(r.choice ? [sentence('No combination of the choices keeps all limits; ' + choiceWords(r).slice(0, -2) + ' comes nearest.')] : []), sentence(cure)] };
}

function changeWords(now, before) {
  return before ? ' (' + (now >= before ? '+' : '') + rounded(100 * (now / before - 1), 3) + ' %)' : '';
}

function searchVerdict() {
  const goal = summary.objective;
  if (!summary.best) return { look: 'bad', lines: [sentence(bold('No design could be evaluated.'))] };
  if (summary.relaxation) return relaxationVerdict();
  const now = goalValue(summary.best, goal);
  const before = goalValue(summary.before, goal);
  const lines = [sentence('The best design found has a ' + plain(goal.metric) + ' of ', bold(goalText(goal, now)), before === null ? '' : ', against ' + goalText(goal, before) + ' before' + changeWords(now, before), ': ' + choiceWords(summary.best) + designWords(summary.best.design) + '.')];
  if (summary.robust) lines.unshift(...robustSentences());
  const held = holders(summary.best, [goal]);
  if (held.length || wholeEnds(summary.best).length) lines.push(sentence(held.length === 1 ? 'What stops it:' : 'What stops it, the most valuable limit first:'), holderList(summary.best, [goal]));
  else lines.push(sentence('No limit stops it: it is the best there is within the ranges.'));
  lines.push(sentence(summary.best.certificate.passed && !summary.robust ? startsText() : certificateText(summary.best.certificate)));
  if (scanText()) lines.push(sentence(scanText()));
  return { look: summary.outcome === 'optimal' ? 'good' : 'bad', lines };
}

/** What a step along the front costs, to the next points on both sides of the knee. */
function tradeWords(i) {
  if (summary.objectives.length !== 2) return null;
  const [a, b] = summary.objectives;
  const at = (k, goal) => goalValue(summary.front[k], goal);
  const better = (goal) => (goal.sense === 'maximize' ? 'more' : 'less');
  const worse = (goal) => (goal.sense === 'maximize' ? 'less' : 'more');
  const unit = displayUnit(at(i, a), unitOf(a.metric));
  const amount = '1 ' + unit.text;
  const rate = (k) => engineering(Math.abs((at(k, b) - at(i, b)) / (at(k, a) - at(i, a))) * unit.divisor, unitOf(b.metric), 3);
  const parts = [];
  if (i > 0) parts.push(amount + ' ' + better(a) + ' ' + plain(a.metric) + ' is paid with ' + rate(i - 1) + ' ' + worse(b) + ' ' + plain(b.metric));
  if (i + 1 < summary.front.length) parts.push(amount + ' ' + worse(a) + ' brings ' + rate(i + 1) + ' ' + better(b));
  return 'There ' + parts.join('; ') + '.';
}

function paretoVerdict() {
  if (summary.relaxation) return relaxationVerdict();
  if (!summary.front.length) return { look: 'bad', lines: [sentence(bold(summary.largest_yield ? 'The wanted yield cannot be had.' : 'No point of the front was found.')), ...(summary.largest_yield ? [sentence('At the design of the largest one ' + yieldWords(summary.largest_yield))] : [])] };
  const goals = summary.objectives;
  const values = (i) => goals.map((o) => plain(o.metric) + ' ' + goalText(o, goalValue(summary.front[i], o), isShare(o) ? 4 : 3)).join(' with ');
  const hasKnee = summary.knee !== null;
  const lines = [sentence(bold(String(summary.front.length)), ' best compromises: none of them can be improved in one goal without loss in another. ', hasKnee ? '' : 'The front has no knee: it bends the other way.')];
  if (hasKnee) {
    lines.push(sentence('The knee has ', bold(values(summary.knee)), '. ' + (tradeWords(summary.knee) || 'On either side of it one gives much for little.')));
    lines.push(...pointHolders(summary.knee));
  }
  [...new Set(summary.ends)].forEach((i) => {
    lines.push(sentence('The ' + frontRole(i) + ': ', bold(values(i)), '.'), ...pointHolders(i, 2));
  });
  return { look: 'good', lines };
}

/** Of a motor without a peak power: what else there is. */
function knownWords(m) {
  const known = ['stall_torque', 'no_load_speed'].filter((name) => m[name] !== null).map((name) => 'its ' + plain(name) + ' is ' + engineering(m[name], unitOf(name)));
  return known.length ? capital(known.join(', ')) + '.' : '';
}

function curveVerdict() {
  const list = summary.curves;
  const m = list[0].metrics;
  if (!summary.family && m.peak_power === null) return { look: 'bad', lines: [sentence(bold('This motor has no peak power that could be computed. '), knownWords(m))] };
  if (!summary.family && !(m.peak_power > 0)) return { look: 'bad', lines: [sentence(bold('This motor drives no load: '), 'its torque at stall is ' + engineering(m.stall_torque, 'N.m') + '.')] };
  if (!summary.family) return { look: 'good', lines: [sentence('This motor holds ', bold(engineering(m.stall_torque, 'N.m')), ' at stall, runs up to ', bold(engineering(m.no_load_speed, 'rad/s')), ' without load, and gives at most ', bold(engineering(m.peak_power, 'W')), ' (at ' + engineering(m.speed_at_peak_power, 'rad/s') + ', ' + engineering(m.torque_at_peak_power, 'N.m') + ').')] };
  const name = summary.family.parameter;
  const value = memberValue;
  const top = (metric) => list.filter((c) => c.metrics[metric] !== null).sort((a, b) => b.metrics[metric] - a.metrics[metric])[0];
  const same = (metric) => list.every((c) => Math.abs(c.metrics[metric] - list[0].metrics[metric]) <= 1e-9 * Math.abs(list[0].metrics[metric]));
  const tops = [['peak_power', 'W', 'Most power'], ['stall_torque', 'N.m', 'Most stall torque'], ['no_load_speed', 'rad/s', 'Highest no-load speed']].filter(([metric]) => top(metric));
  return { look: 'good', lines: [sentence(bold(list.length + ' motors'), ' that differ in ' + plain(name) + ', from ' + value(list[0]) + ' to ' + value(list[list.length - 1]) + '.'),
    ...tops.map(([metric, unit, text]) => (same(metric) ? sentence(text.replace(/^\w+ /, (w) => ({ 'Most ': 'The ', 'Highest ': 'The ' })[w]), ' is the same for all: ', bold(engineering(list[0].metrics[metric], unit)), '.') : sentence(text + ': ', bold(engineering(top(metric).metrics[metric], unit)), ' with ' + plain(name) + ' ' + value(top(metric)) + '.')))] };
}

function sweepVerdict() {
  const parts = Object.entries(summary.metrics).filter(([, m]) => m.count > 0);
  const words = ([n, m]) => {
    const name = bold(capital(plain(n)));
    if (m.min === m.max) return [name, ' is the same in all: ', bold(engineering(m.max, unitOf(n))), '.'];
    return [name, ': at most ', bold(engineering(m.max, unitOf(n))), m.highest ? ' with ' + designWords(m.highest.design) : '', '; at least ', bold(engineering(m.min, unitOf(n))), m.lowest && Object.keys(m.lowest.design).length < 3 ? ' with ' + designWords(m.lowest.design) : '', '.'];
  };
  return { look: 'good', lines: [sentence(bold(summary.stored + ' designs'), summary.failed ? ', ' + summary.failed + ' of them without a full answer: a number that was asked for does not exist there or could not be computed.' : '.'),
    bullets(parts.map(words))] };
}

function sensitivityVerdict() {
  const size = { sobol: (e) => e.total.value, morris: (e) => e.mu_star, local: (e) => (e.elasticity === null ? null : Math.abs(e.elasticity)) }[summary.method];
  const lines = [];
  for (const [metric, effects] of Object.entries(summary.indices)) {
    if (!effects) continue;
    const names = sortedNames(effects, size);
    const first = effects[names[0]];
    const others = names.slice(1, 3).filter((n) => size(effects[n]) > 0.01 * size(first));
    const text = summary.method === 'sobol' ? percent(first.total.value) + ' of its variance' : summary.method === 'morris' ? engineering(first.mu_star, unitOf(metric), 3) + ' across its range' : rounded(first.elasticity, 3) + ' % for 1 % more';
    lines.push(sentence(capital(plain(metric)) + ': ', bold(plain(names[0])), ' matters most (' + text + ')', others.length ? ', then ' + others.map(plain).join(' and ') : names.length > 1 ? '; the others hardly' : '', '.'));
  }
  return { look: 'good', lines };
}

/** A yield from here on is shown in green, a lower one in the colour of a warning. */
const GOOD_YIELD = 0.95;

function uncertaintyVerdict() {
  const lines = [];
  const look = !summary.yield ? 'plain' : summary.yield.low >= GOOD_YIELD ? 'good' : 'bad';
  if (summary.yield) {
    lines.push(sentence(bold(percent(summary.yield.value, 4)), ' of the motors keep every limit (between ' + percent(summary.yield.low, 4) + ' and ' + percent(summary.yield.high, 4) + ' with ' + percent(summary.confidence) + ' confidence). What costs the others, the limit that costs most first:'), yieldList());
  }
  lines.push(bullets(Object.entries(summary.metrics).map(([n, m]) => [bold(capital(plain(n))), ': ' + engineering(m.mean, unitOf(n)) + ' on average, standard deviation ' + engineering(m.sd, unitOf(n), 3) + '.'])));
  return { look, lines };
}

function calibrateVerdict() {
  const entries = Object.entries(summary.estimates);
  if (!entries.length) return { look: 'bad', lines: [sentence(bold('No fit was found.'))] };
  const known = (n, e) => (e.remark ? ' (' + e.remark + ')' : e.low === null ? '' : ' (' + engineering(e.low, unitOf(n), 4) + ' to ' + engineering(e.high, unitOf(n), 4) + ')');
  const begin = { fitted: 'The data say: ', poor: 'The motor does not follow these points; it comes nearest with ', several: 'Several motors fit equally well; one of them has ', undetermined: 'The points do not determine all of these; they are fitted best by ', 'at-bounds': 'Nothing was fitted: the search stopped at ' }[summary.outcome] || 'The search stopped short, at ';
  const lines = [sentence(begin, bold(entries.map(([n, e]) => plain(n) + ' ' + engineering(e.value, unitOf(n)) + known(n, e)).join(', ')), '.'),
    sentence('What is left between motor and points: ' + (unitOf('residual_rms') === '1' ? rounded(summary.residual_rms, 3) + ' standard deviations' : engineering(summary.residual_rms, unitOf('residual_rms'), 3)) + ' (root mean square).')];
  if ((summary.notes || []).length) lines.push(bullets(summary.notes.map(plainNames)));
  return { look: summary.outcome !== 'fitted' || entries.some(([, e]) => e.remark) ? 'bad' : 'good', lines };
}

const verdicts = { curve: curveVerdict, sweep: sweepVerdict, sensitivity: sensitivityVerdict, optimize: searchVerdict, size: searchVerdict, pareto: paretoVerdict, uncertainty: uncertaintyVerdict, calibrate: calibrateVerdict };
