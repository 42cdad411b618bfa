// SPDX-License-Identifier: Apache-2.0
// Names, limits, and what moving a limit is worth, as people say it.

import {data, isShare, rows, summary, unitOf} from './data.js';
import {bold, el} from './dom.js';
import {shortName} from './names.js';
import {displayUnit, engineering, largest, noBreak, percent, rounded, siUnitText} from './units.js';

const signs = {
  'at least': ' ≥ ',
  'at most': ' ≤ '
};
const counted = {
  efficiency: ' (stator loss counted)',
  max_efficiency: ' (stator loss counted)'
};

/** A parameter or metric by its own name; what is ambiguous comes with the part of the motor. */
function ownName(name) {
  const file = summary.estimates?.[name]?.file;  // a value of one table of measurements: "amplitude (b.csv)"
  if (file) return ownName(name.slice(0, -` (${file})`.length)) + ` (${file})`;
  const parameter = data.parameters[name];
  if (!parameter && !Object.hasOwn(data.metrics, name)) return name;  // a formula or a choice, as typed
  return (parameter?.part === 'contact_layer' ? 'contact layer ' : '') + shortName(name) + (counted[name] ?? '');
}

/** "peak power", "torque at 80 rpm", "5 % quantile of the stall torque" */
export function plain(name) {
  const known = data.names[name];
  if (!known) return ownName(name);
  if (known.statistic) return statisticWords(known);
  if (known.argument === 'both')
    return `${shortName(known.metric)} ${engineering(known.torque, 'N.m')}, ${engineering(known.at, 'rad/s')}`;
  if (known.metric) return shortName(known.metric) + ' ' + engineering(known.at, argumentUnits[known.argument]);
  return limitWords(name);
}

/** The same behind its article: "a peak power", "an output power". */
function withArticle(name) {
  const words = plain(name);
  return (/^[aeio]/i.test(words) ? 'an ' : 'a ') + words;
}

const argumentUnits = {
  speed: 'rad/s',
  torque: 'N.m'
};

/** "mean peak power", "5 % quantile of the stall torque" */
function statisticWords({statistic, of, probability}) {
  if (statistic === 'yield') return 'yield';
  if (statistic === 'probability') return 'probability of ' + limitWords(of);
  if (statistic === 'quantile') return percent(probability) + ' quantile of the ' + plain(of);
  return (statistic === 'mean' ? 'mean ' : 'standard deviation of the ') + plain(of);
}

export function axisLabel(name, shown) { return plain(name) + (shown.text ? ' [' + shown.text + ']' : ''); }

/** "no-load speed ≥ 100 rpm": a limit as it stands in the study. */
export function limitWords(text) {
  const known = data.names[text];
  if (!known || known.of === undefined) return plain(text);
  if (known.sides) return known.sides.map(plain).join(known.lower === null ? signs['at most'] : signs['at least']);
  const share = isShare(known.of);
  const say = (value) => (share ? percent(value, 4) : engineering(value, known.unit));
  if (known.lower === null) return plain(known.of) + signs['at most'] + say(known.upper);
  if (known.upper === null) return plain(known.of) + signs['at least'] + say(known.lower);
  return say(known.lower) + signs['at most'] + plain(known.of) + signs['at most'] + say(known.upper);
}

/** "preload ≤ 100 N": an end of a range, at its own place or at another. */
function rangeWords(variable, side, limit) {
  return plain(variable) + signs[side] + engineering(limit, unitOf(variable));
}

/** Value of the family's parameter, all members in one unit. */
export function memberText(member) {
  const {parameter, unit} = summary.family;
  const shown = displayUnit(largest([(summary.curves || summary.responses).map((m) => m[parameter])]), unit);
  return rounded(member[parameter] / shown.divisor) + (shown.text ? noBreak + shown.text : '');
}

/** "+1.2 W"; "-" where there is none. */
export function signed(value, unit) {
  if (value === null || value === undefined || !Number.isFinite(value)) return '-';
  return value === 0 ? 'nothing' : (value > 0 ? '+' : '') + engineering(value, unit, 3);
}

/** What a design has of a goal: a metric, a parameter, or a statistic of the motors built to it. */
export function goalValue(report, goal) {
  const {metric} = goal;
  return report.metrics[metric] ?? report.design[metric] ?? (report.statistics || {})[metric] ?? null;
}

/** The value of a goal with its unit. */
export function goalText(goal, value, digits = 4) {
  return isShare(goal.metric) ? percent(value, digits) : engineering(value, unitOf(goal.metric), digits);
}

/** "lining peek.yaml, ": what was chosen for a design, before its numbers; empty where nothing was. */
export function choiceWords(report) {
  return Object.entries(report.choice || {}).map(([name, set]) => shortName(name) + ' ' + set + ', ').join('');
}

/** A limit, or the end of a range, of the page's data: "contact radius ≤ 30 mm, the end of its range". */
export function standingName(s) {
  if (s.variable) return rangeWords(s.variable, s.side, s.limit) + ', the end of its range';
  if (data.names[s.text]) return limitWords(s.text);
  return rangeWords(s.metric, s.side, s.limit) + ', which the others imply';  // no text of the study
}

export function standingState(s) {
  if (s.state === 'broken') return 'broken by ' + engineering(s.violation, s.unit, 3);
  return s.state === 'unreachable' ? 'cannot be reached' : s.state;
}

/** What binds, the most valuable first. */
export function holders(standings) { return standings.filter((s) => s.state === 'binds'); }

/** Whole numbers at an end of their range: they have no slope, but the search has seen the number before. */
export function wholeEnds(report) {
  const whole =
      Object.entries(data.ranges || {}).filter(([n]) => data.parameters[n].integer && report.design[n] !== undefined);
  return whole.flatMap(([name, range]) => {
    const value = report.design[name];
    if (range.min === range.max || (value !== range.min && value !== range.max)) return [];
    const side = value === range.max ? 'at most' : 'at least';
    const words = plain(name) + signs[side] + value + ', the end of its range';
    return [{name, value, inner: value === range.max ? value - 1 : value + 1, words}];
  });
}

function wholeLine(end, goal, standings) {
  const best = goal ? bestWith(end.name, end.inner, goal, standings) : null;
  const seen = rows.every > 1 ? 'The best on this page with ' : 'The best that the search saw with ';
  const told = best === null ? 'Try a wider range.' :
                               seen + end.inner + ' has ' + withArticle(goal.metric) + ' of ' + goalText(goal, best) +
          '; try a wider range to see whether this continues.';
  return [bold(end.words), ': whole numbers have no slope. ' + told];
}

/** Which stored motors keep every limit of a search. */
export function keepsLimits(standings) {
  const limits = standings.filter((s) => s.metric !== undefined)
                     .map((s) => ({...s, column: rows.columns.find((r) => r.name === s.metric)}))
                     .filter((s) => s.column);
  return (i) => limits.every(({column, lower, upper, allowance}) => {
    const v = column.values[i];
    return (lower === null || v >= lower - allowance) && (upper === null || v <= upper + allowance);
  });
}

/** The best value of a goal among stored motors that keep the limits and have this value of a parameter. */
function bestWith(name, value, goal, standings) {
  const column = rows.columns.find((c) => c.name === goal.metric);
  const parameter = rows.columns.find((c) => c.name === name);
  if (!column || !parameter) return null;
  const keeps = keepsLimits(standings);
  let best = null;
  for (let i = 0; i < rows.count; ++i) {
    const v = column.values[i];
    if (parameter.values[i] !== value || !Number.isFinite(v) || !keeps(i)) continue;
    if (best === null || (goal.sense === 'maximize' ? v > best : v < best)) best = v;
  }
  return best;
}

/** What moving a limit by 1 % brings, as words and nodes. */
function holderLine(s, goals, report) {
  const name = bold(standingName(s));
  if (s.changes.every((v) => v === null || v === 0))
    return [name, ': it is met, but moving it by 1 % changes nothing to first order.'];
  const change = (g, value) => {
    const now = goalValue(report, g);
    const share = now ? ' (' + signed((100 * value) / Math.abs(now), '%') + ')' : '';
    return [plain(g.metric) + ' by ', bold(signed(value, unitOf(g.metric))), share];
  };
  const changes = goals.flatMap((g, k) => (s.changes[k] === null ? [] : [change(g, s.changes[k])]));
  // One per cent of nothing is nothing: a limit at 0 is moved by as much as its scale says.
  const moved = (s.limit === 0 ? ': moved to ' : ': 1 % looser, at ') + engineering(s.moved, s.unit) + ', changes ';
  return [name, moved, ...changes.flatMap((c, k) => (k ? [' or ', ...c] : c)), '.'];
}

/** What stops a design, a line each; most: how many lines at most, the rest is counted. */
function holderLines(report, standings, goals) {
  const goal = goals.length === 1 ? goals[0] : null;
  return [
    ...holders(standings).map((s) => holderLine(s, goals, report)),
    ...wholeEnds(report).map((e) => wholeLine(e, goal, standings))
  ];
}

export function holderList(report, standings, goals, most = Infinity) {
  const lines = holderLines(report, standings, goals);
  const more = lines.length - most;
  const rest = more > 0 ? el('li', {}, more + ' more: choose the point in the picture above.') : null;
  return el('ul', {class: 'holders'}, lines.slice(0, most).map((line) => el('li', {}, ...line)), rest);
}

/** "2.4 W per MPa": what a unit of a limit is worth, in units of engineers. */
export function rateWords(s, goal) {
  if (!(s.multiplier > 0)) return '-';
  const shown = s.unit === '1' || !s.unit ? {text: '0.01', divisor: 0.01} : displayUnit(s.limit, s.unit);
  return engineering(s.multiplier * shown.divisor, unitOf(goal.metric), 3) + ' per ' + shown.text;
}

/** "W/(rad/s)": SI on both sides, as one types it. */
export function ratioUnit(above, below) {
  if (below === '1' || !below) return above === '1' ? '' : above;
  return above + '/' + (['/', '.', '·'].some((sign) => below.includes(sign)) ? '(' + below + ')' : below);
}

/** A slope with its unit, with a prefix where the unit above takes one. */
export function slopeText(value, above, below, digits = 4) {
  const shown = displayUnit(value, above);
  const unit = ratioUnit(shown.text || '1', siUnitText(below || '1') || '1');
  return rounded(value / shown.divisor, digits) + (unit ? noBreak + unit : '');
}
