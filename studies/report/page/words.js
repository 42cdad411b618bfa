// SPDX-License-Identifier: Apache-2.0
'use strict';
// Names, limits, and what moving a limit is worth, as people say it.

/** "peak_power" and "torque_at(80 rpm)" as one reads them; what is ambiguous with the part of the motor. */
function plain(name) {
  const call = /^(\w+)_at\((.*)\)$/s.exec(name);
  if (call) return plain(call[1]) + ' at ' + call[2];
  const statistic = /^(mean|sd|quantile|probability)\((.*)\)$/s.exec(name);
  if (statistic) return statisticWords(statistic[1], statistic[2]);
  return (Object.hasOwn(data.parameters, name) && data.parameters[name].part === 'contact_layer' ? 'contact layer ' : '') + shortName(name);
}

/** "mean peak power", "5 % quantile of the stall torque" */
function statisticWords(kind, inside) {
  if (kind === 'probability') return 'probability of ' + limitWords(inside);
  if (kind !== 'quantile') return (kind === 'mean' ? 'mean ' : 'standard deviation of the ') + plain(inside);
  const comma = inside.lastIndexOf(',');
  return inside.slice(comma + 1).trim() + ' quantile of the ' + plain(inside.slice(0, comma).trim());
}

/** A sentence with the names in it as one reads them. */
function plainNames(text) { return text.replace(/\b[a-z]+(_[a-z]+)+\b/g, plain); }

function axisLabel(name, shown) { return plain(name) + (shown.text ? ' [' + shown.text + ']' : ''); }

/** "no_load_speed >= 100 rpm" as one reads it. */
function limitWords(text) {
  const signs = { '>=': '≥', '<=': '≤', '==': '=', '+-': '±' };
  return text.split(/(<=|>=|==|\+-)/).map((part) => signs[part] || plain(part.trim()).replace(/([\d.]) (?=\S+$)/, '$1' + noBreak)).join(' ');
}

function boundWords(b) { return plain(b.variable) + (b.side === 'upper' ? ' ≤ ' : ' ≥ ') + engineering(b.limit, unitOf(b.variable)) + ', the end of its range'; }

/** "+1.2 W"; "-" where there is none. */
function signed(value, unit) {
  if (value === null || value === undefined || !Number.isFinite(value)) return '-';
  return value === 0 ? 'nothing' : (value > 0 ? '+' : '') + engineering(value, unit, 3);
}

/** What a design has of a goal: a metric, a parameter, or a statistic of the motors built to it. */
function goalValue(report, goal) { return report.metrics[goal.metric] ?? report.design[goal.metric] ?? (report.statistics || {})[goal.metric] ?? null; }

/** Whether a goal is a share of the motors. */
function isShare(goal) { return /^(yield$|probability\()/.test(goal.metric); }

/** The value of a goal with its unit. */
function goalText(goal, value, digits = 4) { return isShare(goal) ? percent(value, digits) : engineering(value, unitOf(goal.metric), digits); }

/** "lining peek.yaml, ": what was chosen for a design, before its numbers; empty where nothing was. */
function choiceWords(report) { return Object.entries(report.choice || {}).map(([name, set]) => shortName(name) + ' ' + set + ', ').join(''); }

/** Names with values, those of the contact layer together. */
function designWords(design) {
  const say = (n) => engineering(design[n], unitOf(n), 3);
  const layer = (n) => Object.hasOwn(data.parameters, n) && data.parameters[n].part === 'contact_layer';
  const names = Object.keys(design);
  const others = names.filter((n) => !layer(n)).map((n) => plain(n) + ' ' + say(n));
  const inside = names.filter(layer).map((n) => shortName(n) + ' ' + say(n));
  return [...others, inside.length ? 'contact layer ' + inside.join(' and ') : null].filter(Boolean).join(', ');
}

/**
 * A limit, or the end of a variable's range, at a design: 1 % of it, and what that changes in each goal.
 * Of several goals each changes by so much if the others stay as they are. c: its entry in summary.json.
 */
function standing(c, name, key, unit, direction, goals) {
  const known = c.multiplier > 0 && c.one_percent_buys;
  const step = known ? Math.abs(c.one_percent_buys / c.multiplier) : 0.01 * Math.abs(c.limit);
  const gains = goals.length > 1 ? goals.map((_, k) => (c.gains ? c.gains[k] : null)) : [c.multiplier];
  return {
    name, key, unit, step, moved: c.limit + direction * step, value: c.value ?? c.limit, limit: c.limit, direction, multiplier: c.multiplier, worth: known ? Math.abs(c.one_percent_buys) : 0,
    told: goals.length === 1 || c.gains !== undefined, // results of earlier versions say nothing of fronts
    changes: goals.map((g, k) => (gains[k] === null || gains[k] === undefined ? null : (g.sense === 'maximize' ? 1 : -1) * gains[k] * step)),
  };
}

/**
 * How far beyond a limit still keeps it: a millionth of it, which is nothing of a limit at 0; or as far as the
 * design goes, if all its limits together are met as closely as a solver is asked for.
 */
function allowance(c, report) {
  const { weights, infeasibility } = report.certificate; // without weights nothing was measured
  const met = weights.length > 0 && infeasibility !== null && infeasibility <= 1e-8;
  return Math.max(1e-6 * Math.abs(c.limit), met ? c.violation : 0);
}

function limitStanding(c, goals, report) {
  const s = standing(c, limitWords(c.text), c.text, c.unit, c.sense === 'at least' ? -1 : 1, goals);
  const broken = c.violation > allowance(c, report);
  const slack = c.value === null ? null : s.direction * (c.limit - c.value);
  return { ...s, value: c.value, active: c.active && !broken, slack: slack !== null && Math.abs(slack) <= allowance(c, report) ? 0 : slack,
    state: c.violation === null ? 'cannot be reached' : broken ? 'broken by ' + engineering(c.violation, s.unit, 3) : c.active ? 'binds' : 'holds' };
}

function boundStanding(b, goals) {
  return { ...standing(b, boundWords(b), b.variable, unitOf(b.variable), b.side === 'upper' ? 1 : -1, goals), active: true, slack: 0, state: 'binds' };
}

/** Every limit and every end of a range that is met, the most valuable first, then those with the least room. */
function standings(report, goals) {
  const room = (s) => (s.slack === null ? 0 : s.slack / (Math.abs(s.limit) || 1));
  return [...report.constraints.map((c) => limitStanding(c, goals, report)), ...report.bounds.map((b) => boundStanding(b, goals))]
    .sort((a, b) => Number(b.active) - Number(a.active) || b.worth - a.worth || room(a) - room(b));
}

/** Whole numbers at an end of their range: they have no slope, but the search has seen the number before. */
function wholeEnds(report) {
  return Object.entries(data.ranges || {}).filter(([n]) => data.parameters[n].integer && report.design[n] !== undefined).flatMap(([n, range]) => {
    const value = report.design[n];
    if (range.min === range.max || (value !== range.min && value !== range.max)) return [];
    return [{ name: n, value, inner: value === range.max ? value - 1 : value + 1, words: plain(n) + (value === range.max ? ' ≤ ' : ' ≥ ') + value + ', the end of its range' }];
  });
}

function wholeLine(end, report, goal) {
  const best = goal ? bestWith(end.name, end.inner, goal, report) : null;
  return el('li', {}, bold(end.words), ': whole numbers have no slope. ' + (best === null ? 'A wider range would tell.'
    : (rows.every > 1 ? 'The best on this page with ' : 'The best that the search saw with ') + end.inner + ' has a ' + plain(goal.metric) + ' of ' + engineering(best, unitOf(goal.metric)) + '; a wider range would tell whether this goes on.'));
}

/** Which stored motors keep every limit of a search. */
function keepsLimits(report) {
  const limits = report.constraints.map((c) => ({ column: rows.columns.find((r) => r.name === c.metric), lower: c.lower, upper: c.upper, slack: allowance(c, report) })).filter((l) => l.column);
  return (i) => limits.every((l) => { const v = l.column.values[i]; return (l.lower === null || v >= l.lower - l.slack) && (l.upper === null || v <= l.upper + l.slack); });
}

/** The best value of a goal among stored motors that keep the limits and have this value of a parameter. */
function bestWith(name, value, goal, report) {
  const column = rows.columns.find((c) => c.name === goal.metric);
  const parameter = rows.columns.find((c) => c.name === name);
  if (!column || !parameter) return null;
  const keeps = keepsLimits(report);
  let best = null;
  for (let i = 0; i < rows.count; ++i) {
    const v = column.values[i];
    if (parameter.values[i] !== value || !Number.isFinite(v) || !keeps(i)) continue;
    if (best === null || (goal.sense === 'maximize' ? v > best : v < best)) best = v;
  }
  return best;
}

function holders(report, goals) { return standings(report, goals).filter((s) => s.active); }

/** "to 99 rpm" */
function movedWords(s) { return engineering(s.moved, s.unit, 4); }

/** What moving a limit by 1 % brings, as a line of a list. */
function holderLine(s, goals, report) {
  if (!s.told) return el('li', {}, bold(s.name), '.');
  if (s.changes.every((v) => v === null || v === 0)) return el('li', {}, bold(s.name), ': it is met, but moving it by 1 % changes nothing to first order.');
  const changes = goals.map((g, k) => {
    if (s.changes[k] === null) return null;
    const now = goalValue(report, g);
    return [plain(g.metric) + ' by ', bold(signed(s.changes[k], unitOf(g.metric))), now ? ' (' + signed((100 * s.changes[k]) / Math.abs(now), '%') + ')' : ''];
  }).filter(Boolean);
  // One per cent of nothing is nothing: a limit at 0 is moved by as much as its scale says.
  return el('li', {}, bold(s.name), (s.limit === 0 ? ': moved to ' : ': 1 % looser, at ') + movedWords(s) + ', changes ', changes.flatMap((c, k) => (k ? [' or ', ...c] : c)), '.');
}

/** most: how many lines at most; the rest is counted. */
function holderList(report, goals, most = Infinity) {
  const lines = [...holders(report, goals).map((s) => holderLine(s, goals, report)), ...wholeEnds(report).map((e) => wholeLine(e, report, goals.length === 1 ? goals[0] : null))];
  const more = lines.length - most;
  return el('ul', { class: 'holders' }, lines.slice(0, most), more > 0 ? el('li', {}, more + ' more: choose the point in the picture below.') : null);
}

/** "2.4 W per MPa": what a unit of a limit is worth, in units of engineers. */
function rateWords(s, goal) {
  if (!(s.multiplier > 0)) return '-';
  const shown = s.unit === '1' || !s.unit ? { text: '0.01', divisor: 0.01 } : displayUnit(s.limit, s.unit);
  return engineering(s.multiplier * shown.divisor, unitOf(goal.metric), 3) + ' per ' + shown.text;
}

/** "W/(rad/s)": SI on both sides. */
function ratioUnit(above, below) {
  if (below === '1' || !below) return above === '1' ? '' : above;
  return above + '/' + (/[/.]/.test(below) ? '(' + below + ')' : below);
}

/** "speed_at(0.9 N.m): unreachable; ..." and what each of them means. */
function failureText(reason) {
  const codes = [...new Set(reason.split(';').map((one) => one.split(':').pop().trim()))];
  return codes.filter((code) => Object.hasOwn(data.reasons, code)).map((code) => plainNames(data.reasons[code])).join('; ');
}
