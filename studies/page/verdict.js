// SPDX-License-Identifier: Apache-2.0
// What came out, in two sentences: the answer, and what stops it or what to make of it. The colour means the same:
// good: answered, and shown to be so; bad: no answer, or none that can be relied on; plain: nothing to judge.

import {data, summary, unitOf} from './data.js';
import {bold, bullets, sentence} from './dom.js';
import {capital} from './names.js';
import {yieldSentence, yieldWords} from './robust.js';
import {sortedNames} from './sensitivity.js';
import {engineering, intervalDigits, percent, rounded} from './units.js';
import {
  choiceWords,
  designWords,
  goalText,
  goalValue,
  holderLines,
  limitWords,
  memberText,
  plain,
  rangeWords,
  withArticle
} from './words.js';

function endWords(end, limit) { return rangeWords(end.variable, end.side === 'upper' ? 'at most' : 'at least', limit); }

/** A limit that cannot be kept even alone, its best value, and the ends of ranges where that is. */
function impossibleWords(limit) {
  const ranges = limit.ends.map((i) => summary.relaxation.ranges[i]);
  const ends = ranges.map((end) => endWords(end, end.limit));
  return limitWords(limit.text) + ' cannot be reached: the ' + (limit.sense === 'at least' ? 'most' : 'least') +
      ' found within the ranges is ' + engineering(limit.best, limit.unit) +
      (ends.length ? ', at ' + ends.join(' and ') : '') +
      (limit.choice ? ', with ' + choiceWords(limit).slice(0, -2) : '') + '.';
}

/** What is at fault: limits impossible by themselves first, then those that exclude each other. */
function causeText({impossible, conflict}) {
  const group = conflict.filter((text) => !impossible.some((limit) => limit.text === text)).map(limitWords);
  const lines = impossible.map(impossibleWords);
  const begin = impossible.length ? 'The others exclude each other as well: ' : 'These cannot hold together: ';
  if (group.length === 1) lines.push(group[0] + ' cannot be reached.');
  if (group.length > 1) lines.push(begin + group.join('; ') + '.');
  return lines.join(' ');
}

/** The least that would make it possible. */
function cureText({limits, ranges}) {
  const loosened = (l) => l.limit + (l.sense === 'at least' ? -l.amount_alone : l.amount_alone);
  const one = limits.filter((l) => l.amount_alone)
                  .map(
                      (l) => limitWords(l.text) + ' by ' + engineering(l.amount_alone, l.unit, 3) + ', to ' +
                          engineering(loosened(l), l.unit, 3));
  const ends = ranges.filter((end) => end.limit_alone !== null)
                   .map(
                       (end) => 'the range of ' + endWords(end, end.limit) + ', to ' +
                           engineering(end.limit_alone, unitOf(end.variable), 3));
  const least = [...one, ...ends];
  if (!least.length) return 'Loosening a single limit is not enough; the table below says what would be.';
  const begin = least.length === 1 ? 'It would be possible with this limit loosened: ' :
                                     'It would be possible with one of these limits loosened: ';
  return begin + least.join('; or ') + '.';
}

/** Limits that no design satisfies, and the smallest sufficient changes. */
function relaxationVerdict() {
  const r = summary.relaxation;
  const choice = r.choice ?
      ' No combination of the choices keeps all limits; ' + choiceWords(r).slice(0, -2) + ' comes nearest.' :
      '';
  return {
    look: 'bad',
    lines: [sentence(bold('No design keeps every limit.'), ' ' + causeText(r) + choice), sentence(cureText(r))]
  };
}

function changeWords(now, before) {
  return before ? ' (' + (now >= before ? '+' : '') + rounded(100 * (now / before - 1), 3) + ' %)' : '';
}

function searchVerdict() {
  const goal = summary.objective;
  if (!summary.best) return {look: 'bad', lines: [sentence(bold('No design could be evaluated.'))]};
  if (summary.relaxation) return relaxationVerdict();
  const now = goalValue(summary.best, goal);
  const before = goalValue(summary.before, goal);
  const change = before === null ? '' : ', against ' + goalText(goal, before) + ' before' + changeWords(now, before);
  const answer = sentence(
      'The best design found has ' + withArticle(goal.metric) + ' of ', bold(goalText(goal, now)), change, '.');
  const stops = holderLines(summary.best, data.standings.best, [goal])[0];
  const second = summary.robust ? yieldSentence() :
      stops                     ? sentence('What stops it most: ', ...stops) :
                                  sentence('No limit stops it: it is the best design within the ranges.');
  return {look: summary.outcome === 'optimal' ? 'good' : 'bad', lines: [answer, second]};
}

/** "peak power 20 W with wear intensity at 80 rpm 6.4 kW/m²" */
export function pointWords(i) {
  const say = (o) => plain(o.metric) + ' ' + goalText(o, goalValue(summary.front[i], o), 3);
  return summary.objectives.map(say).join(' with ');
}

/** What a step along the front costs, to the next points on both sides of the knee. */
function tradeWords(i) {
  if (summary.objectives.length !== 2) return 'Away from it, a small gain in one goal costs much of the other.';
  const [a, b] = summary.objectives;
  const at = (k, goal) => goalValue(summary.front[k], goal);
  const better = (goal) => (goal.sense === 'maximize' ? 'more' : 'less');
  const worse = (goal) => (goal.sense === 'maximize' ? 'less' : 'more');
  const step = 0.1 * Math.abs(at(i, a));
  const rate = (k) => goalText(b, Math.abs((at(k, b) - at(i, b)) / (at(k, a) - at(i, a))) * step, 3);
  const parts = [];
  const amount = goalText(a, step, 3) + ' ';
  if (i > 0)
    parts.push(
        amount + better(a) + ' ' + plain(a.metric) + ' is paid with ' + rate(i - 1) + ' ' + worse(b) + ' ' +
        plain(b.metric));
  if (i + 1 < summary.front.length) parts.push(amount + worse(a) + ' brings ' + rate(i + 1) + ' ' + better(b));
  return 'There ' + parts.join('; ') + ', to first order.';
}

function noFrontVerdict() {
  const {largest_yield: largest} = summary;
  const first = sentence(bold(largest ? 'The wanted yield cannot be reached.' : 'No point of the front was found.'));
  return {
    look: 'bad',
    lines: largest ? [first, sentence('At the design of the largest one ' + yieldWords(largest))] : [first]
  };
}

function paretoVerdict() {
  if (summary.relaxation) return relaxationVerdict();
  if (!summary.front.length) return noFrontVerdict();
  const first = sentence(
      bold(String(summary.front.length)),
      ' best compromises: none of them can be improved in one goal without loss in another.');
  const second = summary.knee === null ?
      sentence(
          'The front has no knee, because it bends the other way. It runs from ', bold(pointWords(summary.ends[0])),
          ' to ', bold(pointWords(summary.ends.at(-1))), '.') :
      sentence('The knee has ', bold(pointWords(summary.knee)), '. ' + tradeWords(summary.knee));
  return {look: summary.outcome === 'optimal' ? 'good' : 'plain', lines: [first, second]};
}

/** Of a motor without a peak power: what else there is. */
function knownWords(m) {
  const known = ['stall_torque', 'no_load_speed'].filter((name) => m[name] !== null);
  const said = known.map((name) => 'its ' + plain(name) + ' is ' + engineering(m[name], unitOf(name)));
  return known.length ? capital(said.join(', ')) + '.' : '';
}

function motorVerdict(m) {
  if (m.peak_power === null) {
    const first = bold('This motor has no peak power that could be computed. ');
    return {look: 'bad', lines: [sentence(first, knownWords(m))]};
  }
  if (!(m.peak_power > 0)) {
    const torque = 'its torque at stall is ' + engineering(m.stall_torque, 'N.m') + '.';
    return {look: 'bad', lines: [sentence(bold('This motor drives no load: '), torque)]};
  }
  const peak =
      ' (at ' + engineering(m.speed_at_peak_power, 'rad/s') + ', ' + engineering(m.torque_at_peak_power, 'N.m') + ').';
  return {
    look: 'plain',
    lines: [
      sentence(
          'This motor holds ', bold(engineering(m.stall_torque, 'N.m')), ' at stall and runs up to ',
          bold(engineering(m.no_load_speed, 'rad/s')), ' without load.'),
      sentence('It gives at most ', bold(engineering(m.peak_power, 'W')), peak)
    ]
  };
}

function curveVerdict() {
  const list = summary.curves;
  if (!summary.family) return motorVerdict(list[0].metrics);
  const name = plain(summary.family.parameter);
  const tops = ['peak_power', 'stall_torque', 'no_load_speed'].flatMap((metric) => {
    const known = list.filter((c) => c.metrics[metric] !== null);
    if (!known.length) return [];
    const top = known.reduce((a, b) => (b.metrics[metric] > a.metrics[metric] ? b : a));
    const value = bold(engineering(top.metrics[metric], unitOf(metric)));
    const least = Math.min(...known.map((c) => c.metrics[metric]));
    const same = top.metrics[metric] - least <= 1e-9 * Math.abs(top.metrics[metric]);
    return [[plain(metric) + ' ', value, same ? ' (the same for all)' : ' with ' + name + ' ' + memberText(top)]];
  });
  const ends =
      ' that differ in ' + name + ', from ' + memberText(list[0]) + ' to ' + memberText(list[list.length - 1]) + '.';
  const most = tops.flatMap((t, k) => (k ? ['; ', ...t] : t));
  return {
    look: 'plain',
    lines: [sentence(bold(list.length + ' motors'), ends), tops.length ? sentence('The most: ', ...most, '.') : null]
  };
}

function sweepVerdict() {
  const failed = summary.failed ? ', ' + summary.failed + ' of them failed or incomplete.' : '.';
  const first = sentence(bold(summary.stored + ' designs'), failed);
  const [name, m] = Object.entries(summary.metrics).find(([, m]) => m.count > 0) ?? [];
  if (!name) return {look: 'bad', lines: [first]};
  if (m.min === m.max)
    return {
      look: 'plain',
      lines: [
        first,
        sentence(bold(capital(plain(name))), ' is the same in all: ', bold(engineering(m.max, unitOf(name))), '.')
      ]
    };
  const where = m.highest ? ' with ' + designWords(m.highest.design) : '';
  return {
    look: 'plain',
    lines: [
      first,
      sentence(
          bold(capital(plain(name))), ' runs from ', bold(engineering(m.min, unitOf(name))), ' to ',
          bold(engineering(m.max, unitOf(name))), where + '.')
    ]
  };
}

/** The designs with the most and the least of each metric. */
export function extremeLines() {
  const parts = Object.entries(summary.metrics).filter(([, m]) => m.count > 0 && m.min !== m.max);
  const with_ = (end) => (end ? ' with ' + designWords(end.design) : '');
  return bullets(parts.map(
      ([n, m]) =>
          [bold(capital(plain(n))), ': at most ', bold(engineering(m.max, unitOf(n))), with_(m.highest) + '; at least ',
           bold(engineering(m.min, unitOf(n))), with_(m.lowest) + '.']));
}

function sensitivityVerdict() {
  const size = {
    sobol: (e) => e.total.value,
    morris: (e) => e.mu_star,
    local: (e) => (e.elasticity === null ? null : Math.abs(e.elasticity))
  }[summary.method];
  const told = {
    sobol: (e) => percent(e.total.value) + ' of its variance',
    morris: (e, metric) => engineering(e.mu_star, unitOf(metric), 3) + ' across its range',
    local: (e) => rounded(e.elasticity, 3) + ' % for 1 % more'
  }[summary.method];
  const known = Object.entries(summary.indices).filter(([, effects]) => effects).map(([metric, effects]) => {
    const names = sortedNames(effects, size);
    return {metric, effects, names, first: effects[names[0]]};
  });
  if (!known.length) return {look: 'bad', lines: [sentence(bold('No effects could be computed.'))]};
  const [{metric, effects, names, first}, ...rest] = known;
  const others = names.slice(1, 3).filter((n) => size(effects[n]) > 0.01 * size(first)).map(plain);
  const then = others.length ? ', then ' + others.join(' and ') : names.length > 1 ? '; the others hardly' : '';
  const answer = sentence(
      capital(plain(metric)) + ': ', bold(plain(names[0])), ' matters most (' + told(first, metric) + ')', then, '.');
  const also = rest.flatMap(
      (k, i) =>
          [(i ? '; ' : 'What matters most for the ') + plain(k.metric) + ': ', bold(plain(k.names[0])),
           ' (' + told(k.first, k.metric) + ')']);
  return {look: 'plain', lines: [answer, also.length ? sentence(...also, '.') : null]};
}

/** A yield from here on is shown in green, a lower one in the colour of a warning. */
const GOOD_YIELD = 0.95;

function uncertaintyVerdict() {
  const spread =
      Object.entries(summary.metrics)
          .map(([n, m]) => plain(n) + ' ' + engineering(m.mean, unitOf(n)) + ' ± ' + engineering(m.sd, unitOf(n), 2));
  const last = sentence('Mean and standard deviation: ' + spread.join('; ') + '.');
  if (!summary.yield) return {look: 'plain', lines: [last]};
  const first = sentence(
      bold(percent(summary.yield.value, 4)),
      ' of the motors keep every limit (between ' + percent(summary.yield.low, 4) + ' and ' +
          percent(summary.yield.high, 4) + ' with ' + percent(summary.confidence) + ' confidence).');
  const worst = summary.limits.reduce((a, b) => (b.kept.value < a.kept.value ? b : a));
  const cost = sentence(
      'The limit that costs most is ', bold(limitWords(worst.text)), ': ' + percent(worst.kept.value, 4) + ' keep it.');
  return {look: summary.yield.low >= GOOD_YIELD ? 'good' : 'bad', lines: [first, worst.kept.value < 1 ? cost : last]};
}

const fitWords = {
  fitted: 'The data say: ',
  poor: 'The motor does not follow these points; it comes nearest with ',
  several: 'Several motors fit equally well; one of them has ',
  undetermined: 'The points do not determine all of these; they are fitted best by ',
  'at-bounds': 'Nothing was fitted: the search stopped at '
};

function calibrateVerdict() {
  if (!summary.data.length)
    return {look: 'plain', lines: [sentence('Nothing is measured yet. The table says what to measure first.')]};
  const entries = Object.entries(summary.estimates);
  if (!entries.length) return {look: 'bad', lines: [sentence(bold('No fit was found.'))]};
  const told = (n, e, v) => engineering(v, unitOf(n), intervalDigits(e.low, e.high));
  const range = (n, e) => ' (' + told(n, e, e.low) + ' to ' + told(n, e, e.high) + ')';
  const known = (n, e) => (e.remark ? ' (' + e.remark + ')' : e.low === null ? '' : range(n, e));
  const said = entries.map(([n, e]) => plain(n) + ' ' + told(n, e, e.value) + known(n, e)).join(', ');
  const left = unitOf('residual_rms') === '1' ? rounded(summary.residual_rms, 3) + ' standard deviations' :
                                                engineering(summary.residual_rms, unitOf('residual_rms'), 3);
  const lines = [
    sentence(fitWords[summary.outcome] || 'The search stopped short, at ', bold(said), '.'),
    sentence('The residuals between motor and points are ' + left + ' (root mean square).')
  ];
  if ((summary.notes || []).length) lines.push(bullets(summary.notes));
  const doubtful = summary.outcome !== 'fitted' || entries.some(([, e]) => e.remark);
  return {look: doubtful ? 'bad' : 'good', lines};
}

function frequencyVerdict() {
  const [m] = summary.responses;
  if (!m?.running)
    return {look: 'bad', lines: [sentence(bold('The wave does not run'), ' at the frequency of the drive.')]};
  const at = 'At its drive frequency of ' + engineering(m.drive_frequency, 'Hz', 5) + ' ';
  const first = sentence(
      at + (summary.responses.length > 1 ? 'the first motor' : 'the motor') + ' runs at ',
      bold(engineering(m.running.speed, 'rad/s')), ' with a wave of ', bold(engineering(m.running.amplitude, 'm')),
      '.');
  const margin = engineering(m.drive_frequency - m.pull_out_below, 'Hz', 3);
  const second = m.pull_out_below === null ?
      sentence('Its wave does not pull out in the range.') :
      sentence(
          'The wave pulls out below ' + engineering(m.pull_out_below, 'Hz', 5) + ', a margin of ', bold(margin), '.');
  return {look: 'plain', lines: [first, second]};
}

export const verdicts = {
  curve: curveVerdict,
  sweep: sweepVerdict,
  sensitivity: sensitivityVerdict,
  optimize: searchVerdict,
  size: searchVerdict,
  pareto: paretoVerdict,
  uncertainty: uncertaintyVerdict,
  calibrate: calibrateVerdict,
  frequency: frequencyVerdict
};
