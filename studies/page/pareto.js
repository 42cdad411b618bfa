// SPDX-License-Identifier: Apache-2.0
// The front: goals against each other, the design along it, and the motor of the point chosen.

import {logRange, paddedRange, scaled} from './chart.js';
import {curvesChart} from './curve.js';
import {curves, data, summary, unitOf} from './data.js';
import {designerButton} from './designer/inside.js';
import {card, colour, el, sentence} from './dom.js';
import {figure, keepFocus, logButtons} from './figure.js';
import {Filter} from './filter.js';
import {savedMotor} from './motor.js';
import {shortName} from './names.js';
import {parallelChart} from './parallel.js';
import {certificateText, designTable, limitsTable, metricsNote, relaxationCard} from './search.js';
import {quantity, table, valuesTable, words} from './table.js';
import {displayUnit, largest} from './units.js';
import {axisLabel, choiceWords, goalText, goalValue, holderList, holders, plain, wholeEnds} from './words.js';

function goalWords(goal) { return (goal.sense === 'maximize' ? 'largest ' : 'smallest ') + plain(goal.metric); }

function frontRole(i) {
  const roles = summary.objectives.map((o, k) => (summary.ends[k] === i ? goalWords(o) : null));
  if (summary.knee === i) roles.push('knee');
  return roles.filter(Boolean).join(', ');
}

/**
 * The limits at a point of the front, and the goals that they hold back. At an end of the front only its own goal
 * counts; elsewhere each goal counts, with the others held where they are.
 */
function pointLimits(i) {
  const {front, single_goal_ends: single} = data.standings;
  const ends = summary.objectives.flatMap(
      (goal, k) => (summary.ends[k] === i && single[k] ? [{goals: [goal], standings: single[k]}] : []));
  return ends.length ? ends : [{goals: summary.objectives, standings: front[i]}];
}

function othersWords() {
  return summary.objectives.length === 2 ? 'with the other goal where it is' : 'with the other goals where they are';
}

/** The same as sentences and lists, of so many lines each. */
function pointHolders(i, most) {
  const point = summary.front[i];
  if (!point.certificate.weights.length)
    return [sentence('This front was found without derivatives: what its limits are worth is not known.')];
  return pointLimits(i).flatMap(({goals, standings}) => {
    const of = goals.length > 1 ? 'this point' : 'the ' + goalWords(goals[0]);
    if (!holders(standings).length && !wholeEnds(point).length) return [sentence('No limit stops ' + of + '.')];
    const each = goals.length > 1 ? ' (each gain ' + othersWords() + '):' : ':';
    return [sentence('What stops ' + of + each), holderList(point, standings, goals, most)];
  });
}

/** A goal may be a parameter. */
function frontValue(i, name) { return goalValue(summary.front[i], {metric: name}); }

/** A ring about the point chosen. */
function ringAbout(u, x, y) {
  u.ctx.save();
  u.ctx.beginPath();
  u.ctx.arc(u.valToPos(x, 'x', true), u.valToPos(y, 'y', true), 9 * devicePixelRatio, 0, 2 * Math.PI);
  u.ctx.lineWidth = 2.5 * devicePixelRatio;
  u.ctx.strokeStyle = colour('c1');
  u.ctx.stroke();
  u.ctx.restore();
}

const chosen = {
  point: null
};

/** Goals k and l of the front; a click, or Enter, chooses the point under the cursor. */
class FrontChart {
  constructor(node, k, l, choose) {
    const goals = [summary.objectives[k], summary.objectives[l]];
    const values = goals.map((g) => summary.front.map((_, i) => goalValue(summary.front[i], g)));
    this.order = [...values[0].keys()].sort((i, j) => values[0][i] - values[0][j]);
    this.units = goals.map((g, n) => displayUnit(largest([values[n]]), unitOf(g.metric)));
    const [x, y] = values.map((list, n) => scaled(this.order.map((i) => list[i]), this.units[n].divisor));
    this.x = x;
    this.y = y;
    this.goals = goals;
    this.choose = choose;
    this.name = 'front ' + k + ' ' + l;
    this.log = {x: false, y: false};
    this.under = null;
    this.holder = el('div', {});
    node.append(this.holder);
    this.build();
  }

  axisOf(key, n, values) {
    const log = this.log[key];
    return {
      label: axisLabel(this.goals[n].metric, this.units[n]),
      log,
      range: (log ? logRange : paddedRange)([values])
    };
  }

  build() {
    const {x, y, order, goals} = this;
    const marks = order.map((i, at) => ({x: x[at], y: y[at], text: frontRole(i), colour: 'c0'})).filter((m) => m.text);
    const positive = Math.min(...x, ...y) > 0;
    const toggle = (key, log) => {
      this.log[key] = log;
      keepFocus(this.holder, 'log ' + key, () => this.build());
    };
    const told = (i) => goals.map((g) => [plain(g.metric), goalText(g, goalValue(summary.front[i], g))]);
    this.holder.replaceChildren();
    this.plot = figure(this.holder, x, [{name: 'front', y, colour: 'c0', scatter: true}], {
      name: this.name,
      title: goals.map((g) => plain(g.metric)).join(' against '),
      x: this.axisOf('x', 0, x),
      y: this.axisOf('y', 1, y),
      height: 380,
      marks,
      buttons: positive ? logButtons(this.log, toggle) : [],
      front: (u) => {
        const at = order.indexOf(chosen.point);
        if (at >= 0) ringAbout(u, x[at], y[at]);
      },
      onMove: (i) => {
        this.under = i;
      },
      tell: (i) => [['point', String(order[i] + 1)], ...told(order[i]), ['', frontRole(order[i])]]
    });
    const pick = () => {
      if (this.under !== null) this.choose(order[this.under]);
    };
    this.plot.over.addEventListener('click', pick);
    this.plot.root.parentNode.addEventListener('keydown', (e) => {
      if (e.key === 'Enter') pick();
    });
  }
}

/** Goals, design, metrics, curve and limits of the point chosen, with its motor file. */
function chosenMotor(node, i) {
  const point = summary.front[i];
  const role = frontRole(i);
  const words = choiceWords(point) + data.points[i].name + '. ' + data.points[i].yields + ' ' +
      certificateText(point.certificate);
  const left = el('div', {});
  const right = el('div', {});
  node.replaceChildren(
      el('h2', {}, 'Point ' + (i + 1) + (role ? ': ' + role : '')), el('p', {}, words),
      savedMotor(data.files[i], designerButton(point.design, 'point ' + (i + 1))),
      el('div', {class: 'pair'}, left, right));
  const curve = curves[i];
  if (curve)
    curvesChart(
        left, [curve], ['torque'], 'torque', 'torque',
        {limits: data.standings.front[i], title: 'Torque of point ' + (i + 1)});
  const names = Object.keys(point.design);
  const columns = [{name: 'before', values: summary.before.design}, {name: 'this point', values: point.design}];
  left.append(designTable('point-' + (i + 1), names, columns));
  const metrics = Object.keys(point.metrics);
  right.append(valuesTable(
      'point-metrics-' + (i + 1), 'metric', metrics,
      [{name: 'before', values: summary.before.metrics}, {name: 'this point', values: point.metrics}]));
  const note = metricsNote(metrics);
  if (note) right.append(el('p', {class: 'soft'}, note));
  chosenLimits(node, i);
}

function chosenLimits(node, i) {
  for (const {goals, standings} of pointLimits(i)) {
    if (!standings.length) continue;
    const several = 'Loosened by 1 %, a limit that binds changes one goal or the other as said, to first order, ' +
        othersWords() + '.';
    const end = 'What would improve this end of the front further, regardless of the other goals, to first order.';
    node.append(
        el('h3', {}, goals.length > 1 ? 'What stops it' : 'What stops the ' + goalWords(goals[0])),
        el('p', {}, goals.length > 1 ? several : end), limitsTable(standings, goals));
  }
}

/** What stops the knee and the ends, in words. */
function stopsCard() {
  const node = card('What stops the front', 'At the knee and at its ends.', 'wide');
  const part = (i, most) =>
      node.append(el('h3', {}, 'The ' + frontRole(i) + ': ' + data.points[i].name), ...pointHolders(i, most));
  if (summary.knee !== null) part(summary.knee, Infinity);
  for (const i of new Set(summary.ends)) part(i, 2);
}

/** Goals, then the variables, as columns over the points. */
function frontColumns() {
  const goals = summary.objectives.map((o) => o.metric);
  const design = [...new Set(summary.front.flatMap((point) => Object.keys(point.design)))];
  const names = [...goals, ...design.filter((n) => !goals.includes(n))];
  const values = (name) => Float64Array.from(summary.front, (_, i) => frontValue(i, name) ?? NaN);
  return names.map((name) => ({name, unit: unitOf(name), values: values(name)}));
}

function frontTable(columns) {
  const choices = Object.keys(summary.front[0].choice || {});
  const label = (i) => String(i + 1) + (frontRole(i) ? ' (' + frontRole(i) + ')' : '');
  const lines = summary.front.map(
      (point, i) =>
          [words(label(i)), ...choices.map((n) => words(point.choice[n])),
           ...columns.map((c) => quantity(c.values[i], c.unit)), words(data.files[i]?.file ?? '')]);
  const header = ['point', ...choices.map(shortName), ...columns.map((c) => plain(c.name)), 'motor file'];
  const saved = ['point', ...choices, ...columns.map((c) => c.name + ' [' + c.unit + ']'), 'motor file'];
  return table('front', header, lines, saved);
}

/** The page of a front, from top to bottom. */
export function paretoSections() {
  if (!summary.front.length) return [relaxationCard];
  const goals = summary.objectives.length;
  const columns = frontColumns();
  const charts = [];
  let along = null;
  let node = null;
  const choose = (i) => {
    chosen.point = i;
    for (const c of charts) c.plot.redraw(false);
    chosenMotor(node, i);
    along.choose(i);
  };
  const trade = () => {
    const note = 'Each point is a best compromise. Click one, or press Enter on it, to see its motor; drag to zoom.';
    for (let k = 0; k < goals; ++k)
      for (let l = k + 1; l < goals; ++l)
        charts.push(new FrontChart(card('The trade', note, goals === 2 ? 'wide' : 'half'), k, l, choose));
  };
  const place = () => {
    node = card(null, null, 'wide');
    node.id = 'chosen';
  };
  const lines = () => {
    const note = 'One line for each point: goals, then what the design is made of. Drag along an axis to keep some ' +
        'points only; Escape shows all.';
    along = parallelChart(
        card('Along the front', note, 'wide'), columns, new Filter(columns, summary.front.length), choose);
    choose(summary.knee ?? 0);
  };
  return [
    relaxationCard, trade, place, lines, stopsCard,
    () => card('The front as a table', null, 'wide').append(frontTable(columns))
  ];
}
