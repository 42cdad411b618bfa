// SPDX-License-Identifier: Apache-2.0
// Spread over tolerances: histograms with quantiles and limits, yield.

import {drawLabel} from './chart.js';
import {motorCurve} from './curve.js';
import {rows, summary, unitOf} from './data.js';
import {bold, bullets, card, colour, el} from './dom.js';
import {figure} from './figure.js';
import {capital} from './names.js';
import {tellSections} from './telling.js';
import {displayUnit, engineering, largest, percent, rounded, spreadText} from './units.js';
import {axisLabel, limitWords, plain} from './words.js';

/** Limits on a metric, with their value [SI]; one between two ends has none. */
function limitsOn(metric) { return (summary.limits || []).filter((l) => l.metric === metric && l.limit !== null); }

function keeps(limit, value) {
  if (limit.sense === 'between') return value >= limit.lower && value <= limit.upper;
  return limit.sense === 'at least' ? value >= limit.limit : value <= limit.limit;
}

/** Share of the motors on this page that keep every limit, one of them moved (null: none). */
function yieldWith(moved, limit) {
  const columns = summary.limits.map((l) => rows.columns.find((c) => c.name === l.metric));
  if (!rows.count || columns.some((c) => !c)) return null;
  let good = 0;
  for (let i = 0; i < rows.count; ++i)
    good += summary.limits.every((l, k) => keeps(l === moved ? {...l, limit} : l, columns[k].values[i])) ? 1 : 0;
  return good / rows.count;
}

/**
 * Each limit: what it costs, and what 1 % of it would bring. Where the page holds a part of the motors, the
 * difference in that part is added to the yield of all.
 */
function yieldList() {
  const list = [...summary.limits].sort((a, b) => a.kept.value - b.kept.value);
  const now = yieldWith(null, null);
  return bullets(list.map((l) => {
    const kept = [bold(limitWords(l.text)), ': kept by ' + percent(l.kept.value, 4) + ' of the motors'];
    if (l.metric === undefined || l.limit === null) return [...kept, '.'];
    const moved = l.limit + (l.sense === 'at least' ? -0.01 : 0.01) * Math.abs(l.limit);
    const then = yieldWith(l, moved);
    if (then === null) return [...kept, '.'];
    const here = rows.every > 1 ? ' for the motors on this page.' : '.';
    if (then === now) return [...kept, '; loosening it by 1 % changes nothing' + here];
    const loose = '; 1 % looser, at ' + engineering(moved, unitOf(l.metric)) + ', the yield is ';
    const all = Math.min(summary.yield.value + then - now, 1);
    return [...kept, loose + (rows.every > 1 ? 'about ' : ''), bold(percent(all, 4)), '.'];
  }));
}

/** The values between which the limits on a metric are kept; null where a side is open. */
function windowOf(limits) {
  const of = (sense, worst) => {
    const values = limits.filter((l) => l.sense === sense).map((l) => l.limit);
    return values.length ? worst(...values) : null;
  };
  return {least: of('at least', Math.max), most: of('at most', Math.min)};
}

/**
 * Bins over a column. Both ends of the window that the limits leave are edges of bins, so that no bar is on
 * both sides; unless it is so narrow that this took more bins than are seen.
 */
function binsOf(finite, limits) {
  let [low, high] = [Infinity, -Infinity];
  for (const v of finite) {
    low = Math.min(low, v);
    high = Math.max(high, v);
  }
  const count = Math.min(60, Math.max(8, Math.ceil(Math.sqrt(finite.length) / 1.5)));
  const {least, most} = windowOf(limits);
  const open = least !== null && most !== null ? Math.abs(most - least) : 0;
  const even = (high - low) / count;
  const width = open > (high - low) / 240 ? open / Math.max(Math.round(open / even), 1) : even;
  const anchor = least ?? most ?? low;
  const first = Math.floor((low - anchor) / width + 1e-9);
  const last = Math.max(Math.ceil((high - anchor) / width - 1e-9), first + 1);
  const edge = (i) => anchor + (first + i) * width;
  const ends = [{limit: least, above: (v) => v >= least}, {limit: most, above: (v) => v > most}]
                   .filter((e) => e.limit !== null)
                   .map((e) => ({...e, at: Math.round((e.limit - anchor) / width) - first}))
                   .filter((e) => Math.abs(edge(e.at) - e.limit) < 1e-6 * width);
  return {low, high, width, count: last - first, edge, ends};
}

/** The bin of a value; at an end of the window the limit itself decides, since the edges are rounded. */
function binOf(v, bins) {
  const at = Math.min(Math.max(Math.floor((v - bins.edge(0)) / bins.width), 0), bins.count - 1);
  return bins.ends.reduce((i, end) => (end.above(v) ? Math.max(i, end.at) : Math.min(i, end.at - 1)), at);
}

/** How many motors of each bin keep the limits on this metric, and how many do not. */
function countBins(finite, bins, limits) {
  const kept = new Float64Array(bins.count + 1);
  const failed = new Float64Array(bins.count + 1);
  for (const v of finite) (limits.every((l) => keeps(l, v)) ? kept : failed)[binOf(v, bins)] += 1;
  // A bar of no height would still draw its foot.
  const bars = (counts) => counts.map((n, i) => (n > 0 && i < bins.count ? n : NaN));
  const all = kept.map((n, i) => n + failed[i]);
  return {kept: bars(kept), failed: bars(failed), all};
}

export function upright(u, value, name, dash) {
  const x = u.valToPos(value, 'x', true);
  u.ctx.strokeStyle = colour(name);
  u.ctx.lineWidth = (dash ? 1.5 : 2.5) * devicePixelRatio;
  u.ctx.setLineDash(dash ? [5 * devicePixelRatio, 4 * devicePixelRatio] : []);
  u.ctx.beginPath();
  u.ctx.moveTo(x, u.bbox.top);
  u.ctx.lineTo(x, u.bbox.top + u.bbox.height);
  u.ctx.stroke();
}

/** The side of a limit on which motors fail, hatched. */
function hatch(u, from, to) {
  const {left, top, width, height} = u.bbox;
  const a = Math.min(Math.max(u.valToPos(from, 'x', true), left), left + width);
  const b = Math.min(Math.max(u.valToPos(to, 'x', true), left), left + width);
  if (!(b > a)) return;
  u.ctx.save();
  u.ctx.beginPath();
  u.ctx.rect(a, top, b - a, height);
  u.ctx.clip();
  u.ctx.globalAlpha = 0.35;
  u.ctx.strokeStyle = colour('c1');
  u.ctx.lineWidth = devicePixelRatio;
  u.ctx.beginPath();
  for (let x = a - height; x < b; x += 9 * devicePixelRatio) {
    u.ctx.moveTo(x, top + height);
    u.ctx.lineTo(x + height, top);
  }
  u.ctx.stroke();
  u.ctx.restore();
}

/** Range of the axis: the motors, and a limit unless it is far from all of them. */
function histogramRange(bins, limits) {
  const span = bins.high - bins.low;
  const near = limits.map((l) => l.limit).filter((v) => v > bins.low - span && v < bins.high + span);
  const pad = 0.04 * span;
  return [
    Math.min(bins.edge(0), ...near.map((v) => v - pad)), Math.max(bins.edge(bins.count), ...near.map((v) => v + pad))
  ];
}

/** Hatches, quantiles and limits of a histogram. */
function histogramMarks(u, {unit, range, limits, quantiles}, siUnit) {
  const {ctx, bbox} = u;
  const ratio = devicePixelRatio;
  const place = (l) => l.limit / unit.divisor;
  ctx.save();
  for (const q of quantiles) upright(u, q.value, 'ink', true);
  for (const l of limits) upright(u, place(l), 'c1', false);
  ctx.restore();
  const taken = [];
  const lines = [...quantiles.map((q) => q.value), ...limits.map(place)].map((v) => u.valToPos(v, 'x', true));
  const places = lines.flatMap((x) => Array.from({length: 12}, (_, i) => [x, bbox.top + 6 * i * ratio]));
  const label = (text, value, line) =>
      drawLabel(u, text, u.valToPos(value, 'x', true), bbox.top + (14 + line) * ratio, taken, places);
  for (const l of limits)
    if (place(l) > range[0] && place(l) < range[1])
      label((l.sense === 'at least' ? '≥ ' : '≤ ') + engineering(l.limit, siUnit), place(l), 0);
  for (const q of quantiles) label(q.name, q.value, 18);
}

function histogram(node, column, info) {
  const finite = column.values.filter(Number.isFinite);
  if (!finite.length) return node.append(el('p', {}, 'No motor has a value.'));
  const unit = displayUnit(largest([finite]), column.unit);
  const limits = limitsOn(column.name);
  const bins = binsOf(finite, limits);
  if (bins.high - bins.low <= 1e-9 * Math.abs(bins.high))
    return node.append(el('p', {}, 'The same in every motor: ' + engineering(bins.low, column.unit) + '.'));
  const {kept, failed, all} = countBins(finite, bins, limits);
  const edges = Float64Array.from({length: bins.count + 1}, (_, i) => bins.edge(i) / unit.divisor);
  const range = histogramRange(bins, limits).map((v) => v / unit.divisor);
  const quantiles = Object.entries(info.quantiles || {})
                        .map(([p, v]) => ({value: v / unit.divisor, name: rounded(100 * Number(p)) + ' %'}));
  const broken = [{name: 'breaks it', colour: 'c1', kind: 'area'}, {name: 'limit', colour: 'c1'}];
  const hatched = (l) =>
      (l.sense === 'at least' ? [range[0], l.limit / unit.divisor] : [l.limit / unit.divisor, range[1]]);
  const series =
      [{name: 'keeps', y: kept, colour: 'c0', bars: true}, {name: 'breaks', y: failed, colour: 'c1', bars: true}];
  return figure(node, edges, series, {
    name: 'histogram ' + column.name,
    title: capital(plain(column.name)),
    legend: [
      {name: limits.length ? 'keeps the limit' : 'motors', colour: 'c0', kind: 'area'},
      ...(limits.length ? broken : []), {name: 'quantile', colour: 'ink', kind: 'dash'}
    ],
    x: {label: axisLabel(column.name, unit), range},
    y: {
      label: rows.every > 1 ? 'motors on this page' : 'motors',
      range: [0, 1.3 * Math.max(...all.slice(0, bins.count))]
    },
    height: 250,
    ground: (u) => limits.forEach((l) => hatch(u, ...hatched(l))),
    front: (u) => histogramMarks(u, {unit, range, limits, quantiles}, column.unit),
    tell: (i) =>
        (i >= bins.count ? [] :
                           [
                             ['between', rounded(edges[i]) + ' and ' + rounded(edges[i + 1]) + ' ' + unit.text],
                             ['motors', String(all[i])]
                           ])
  });
}

/** "Limit ≥ 750 mN·m is kept by 99.1 % of the motors." */
function histogramNote(name, {mean, sd}) {
  const unit = unitOf(name);
  const spread = 'Mean ' + engineering(mean, unit) + ', standard deviation ' + spreadText(sd, unit, mean) + '.';
  const kept = (l) => ' ' + capital(limitWords(l.text)) + ' is kept by ' + percent(l.kept.value, 4) +
      ' of the motors (' + percent(l.kept.low, 4) + ' to ' + percent(l.kept.high, 4) + ').';
  return spread + (summary.limits || []).filter((l) => l.metric === name).map(kept).join('');
}

/** The page of a study of tolerances, from top to bottom. */
export function uncertaintySections() {
  const histograms = Object.entries(summary.metrics).map(([name, info]) => () => {
    const column = rows.columns.find((c) => c.name === name);
    const node = card(capital(plain(name)), histogramNote(name, info), 'half');
    if (column) histogram(node, column, info);
  });
  return [...histograms, () => tellSections({looser: yieldList}), motorCurve];
}
