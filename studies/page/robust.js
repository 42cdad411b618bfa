// SPDX-License-Identifier: Apache-2.0
// optimize and size under tolerances: the yield, where the risk goes, what each tolerance costs.

import {paddedRange} from './chart.js';
import {percentUnit} from './curve.js';
import {isShare, summary, unitOf} from './data.js';
import {bold, card, el, sentence} from './dom.js';
import {figure} from './figure.js';
import {capital} from './names.js';
import {barRows} from './sensitivity.js';
import {named, table} from './table.js';
import {upright} from './uncertainty.js';
import {displayUnit, engineering, largest, percent, rounded} from './units.js';
import {axisLabel, goalText, goalValue, limitWords, plain, withArticle} from './words.js';

/** "99.16 % of the motors keep all limits (99.06 % to 99.24 % by 40000 new random motors)" */
export function yieldWords(y) {
  const what = y.text === 'yield' ? 'all limits' : limitWords(y.text);
  const sure = {
    holds: 'This reaches the wanted share',
    'not-distinguishable': 'The sample cannot distinguish this from the wanted share',
    broken: 'This is below the wanted share'
  }[y.verdict];
  return percent(y.value, 4) + ' of the motors keep ' + what + ' (' + percent(y.low, 4) + ' to ' + percent(y.high, 4) +
      ' by ' + y.samples + ' motors that the search has not seen' +
      (y.weighted ? ', drawn about the worst points and weighted' : '') + '). ' +
      (y.target === null ? '' : sure + ', ' + percent(y.target, 4) + '.');
}

/** The second sentence of the verdict: how many of the motors keep the limits. */
export function yieldSentence() {
  const r = summary.robust;
  if (r.largest_yield === null) return sentence(yieldWords(r.yields[0]));
  const largest = '; the largest found is ' + percent(r.largest_yield, 4) + '. The design shown has it.';
  return sentence(bold('The wanted yield cannot be reached'), largest);
}

/** The other yields, and what the tolerances cost against the optimum without them. */
function robustCard() {
  const r = summary.robust;
  const goal = summary.objective;
  const lines = (r.largest_yield === null ? r.yields.slice(1) : r.yields).map(yieldWords);
  if (r.nominal.objective !== null) {
    const share = percent(r.price / Math.abs(r.nominal.objective), 2);
    const pass =
        r.nominal.yield === null ? '' : ', but only ' + percent(r.nominal.yield, 2) + ' of its motors would pass';
    lines.push(
        'Without tolerances the optimum has ' + withArticle(goal.metric) + ' of ' +
        goalText(goal, r.nominal.objective) + pass + '. The tolerances cost ' + goalText(goal, r.price, 3) + ' (' +
        share + ').');
  }
  if (lines.length)
    card('Against the optimum without tolerances', null, 'wide', ...lines.map((line) => sentence(line)));
}

/**
 * One metric: shares of the motors in bins, those beyond the limit in another colour, the optimum without tolerances
 * as an outline.
 */
function densityChart(d) {
  const other = summary.robust.nominal.objective === null ? 'motor as it was' : 'optimum without tolerances';
  const node = card(
      capital(plain(d.metric)), 'Share of the motors of the robust design; the outline is the ' + other + '.', 'half');
  const count = d.motors.length;
  const edge = (i) => d.first + i * d.width;
  const unit = displayUnit(Math.max(Math.abs(edge(0)), Math.abs(edge(count))), d.unit);
  const fails = (i) => {
    const v = edge(i) + d.width / 2;
    return (d.lower !== null && v < d.lower) || (d.upper !== null && v > d.upper);
  };
  const pick = (wanted) => [...d.motors, 0].map((v, i) => (v > 0 && i < count && fails(i) === wanted ? 100 * v : NaN));
  const edges = Float64Array.from({length: count + 1}, (_, i) => edge(i) / unit.divisor);
  const outline = [...d.nominal, 0].map((v) => 100 * v);
  const top = 100 * Math.max(...d.motors, ...d.nominal);
  const ends = [d.lower, d.upper].filter((v) => v !== null).map((v) => v / unit.divisor);
  const series = [
    {name: 'keeps', y: pick(false), colour: 'c0', bars: true},
    {name: 'breaks', y: pick(true), colour: 'c1', bars: true},
    {name: other, y: outline, colour: 'ink', steps: true, dash: [5, 4]}
  ];
  figure(node, edges, series, {
    name: 'density ' + d.metric,
    title: capital(plain(d.metric)),
    legend: [
      {name: 'keeps the limit', colour: 'c0', kind: 'area'}, {name: 'breaks it', colour: 'c1', kind: 'area'},
      {name: 'limit', colour: 'c1'}, {name: other, colour: 'ink', kind: 'dash'}
    ],
    x: {label: axisLabel(d.metric, unit), range: [edges[0], edges[count]]},
    y: {label: 'motors [% per bin]', range: [0, 1.15 * top]},
    height: 230,
    front: (u) => {
      u.ctx.save();
      for (const v of ends) upright(u, v, 'c1', false);
      u.ctx.restore();
    }
  });
}

/** Which limits fail, and through which tolerance. */
function riskCard() {
  const node = card(
      'Where the risk goes',
      'Share of the failing motors that violate each limit, and the part of it that each tolerance causes. The index ' +
          'is the number of standard deviations between the design and the limit.',
      'wide');
  const limits = summary.robust.limits;
  const names = Object.keys(limits[0].importance);
  node.append(
      barRows(limits.map((l) => ({name: limitWords(l.text), value: l.share, text: percent(l.share, 3)})), 0, 1));
  node.append(table(
      'risk', ['limit', 'motors that violate it', 'of the failures', 'index', ...names.map(plain)],
      limits.map(
          (l) =>
              [{text: limitWords(l.text), value: l.text, words: true},
               {text: percent(l.probability, 3), value: l.probability}, {text: percent(l.share, 3), value: l.share},
               {text: rounded(l.beta, 3), value: l.beta},
               ...names.map((n) => ({text: percent(l.importance[n], 2), value: l.importance[n]}))])));
}

/** "0.0047 % (0.003 % to 0.0064 %)": counted from the failing motors, without any derivative. */
function sampledCell(s) {
  return {
    text: s.value === null ? '-' : percent(s.value, 2) + ' (' + percent(s.low, 2) + ' to ' + percent(s.high, 2) + ')',
    value: s.value
  };
}

/** What to tighten, and what may be loosened; the list is in order of the gain. */
function looseWords(list) {
  const gain = (t) => Math.abs(t.gain_per_percent_tighter);
  const cheap = list.filter((t) => gain(t) < 0.05 * gain(list[0])).map((t) => plain(t.name));
  return gain(list[0]) > 0 ? 'Tighten the ' + plain(list[0].name) + ' first.' +
          (cheap.length ? ' ' + capital(cheap.join(', ')) + (cheap.length > 1 ? ' each cost' : ' costs') +
                   ' less than 5 % of it: try twice the spread and solve again.' :
                          '') :
                             '';
}

/** What each tolerance costs. */
function tolerancesCard() {
  const r = summary.robust;
  const goal = summary.objective;
  const node = card(
      'What the tolerances cost',
      'Gain in ' + plain(summary.objective.metric) +
          ' if a tolerance is 1 % tighter (3 % becomes 2.97 %), to first order. For a large change solve again.' +
          (r.price_of_yield > 0 ? ' 0.1 % more yield costs ' + goalText(goal, 0.001 * r.price_of_yield, 3) + '.' : ''),
      'wide');
  const list =
      [...r.tolerances].sort((a, b) => Math.abs(b.gain_per_percent_tighter) - Math.abs(a.gain_per_percent_tighter));
  const most = Math.max(...list.map((t) => Math.abs(t.gain_per_percent_tighter)), 1e-300);
  const spread = (t) => (t.unit === '1' ? percent(t.sd, 4) : engineering(t.sd, t.unit));
  node.append(barRows(
      list.map((t) => ({
                 name: t.name,
                 value: Math.abs(t.gain_per_percent_tighter),
                 text: goalText(goal, t.gain_per_percent_tighter, 3)
               })),
      0, most));
  node.append(el('p', {}, looseWords(list)));
  node.append(table(
      'tolerances', ['tolerance', 'spread', '1 % tighter gains', 'yield gains, same design', 'by the failing motors'],
      list.map(
          (t) =>
              [named(t.name), {text: spread(t), value: t.sd},
               {text: goalText(goal, t.gain_per_percent_tighter, 3), value: t.gain_per_percent_tighter},
               {text: percent(t.yield_per_percent, 2), value: t.yield_per_percent},
               sampledCell(t.yield_per_percent_sampled)])));
}

/** The goal over the yield; it ends at 99.9 % or at the largest yield. */
function yieldPriceCard() {
  const r = summary.robust;
  const goal = summary.objective;
  const list = r.price_over_yield;
  if (list.length < 2) return;
  const last = list[list.length - 1];
  const ends =
      last.yield < 0.999 ? ' It ends at the largest yield within the ranges, ' + percent(last.yield, 4) + '.' : '';
  const node = card(
      'What the yield costs',
      'The best ' + plain(goal.metric) +
          ' over the share of motors that keep all limits, with everything else chosen anew.' + ends,
      'wide');
  const unit =
      isShare(goal.metric) ? percentUnit : displayUnit(largest([list.map((p) => p.objective)]), unitOf(goal.metric));
  const y = Float64Array.from(list.map((p) => p.objective / unit.divisor));
  const x = Float64Array.from(list.map((p) => 100 * p.yield));
  const now = goalValue(summary.best, goal);
  const marks = r.largest_yield === null && now !== null ?
      [{x: 100 * r.target, y: now / unit.divisor, text: 'this design', colour: 'c1'}] :
      [];
  figure(node, x, [{name: plain(goal.metric), y, colour: 'c0'}, {name: 'computed', y, colour: 'c0', scatter: true}], {
    name: 'price over yield',
    x: {label: 'yield [%]', range: [89.5, 100]},
    y: {label: axisLabel(goal.metric, unit), range: paddedRange([y, Float64Array.from(marks.map((m) => m.y))])},
    height: 230,
    marks
  });
  node.append(table(
      'yield-price', ['yield', plain(goal.metric)],
      list.map(
          (p) =>
              [{text: percent(p.yield, 4), value: p.yield}, {text: goalText(goal, p.objective), value: p.objective}])));
}

export function robustCards() {
  if (!summary.robust) return;
  robustCard();
  summary.robust.densities.forEach(densityChart);
  if (summary.robust.limits.length) riskCard();
  tolerancesCard();
  yieldPriceCard();
}
