// SPDX-License-Identifier: Apache-2.0
'use strict';
// The front: goals against each other, the design along it, and the motor of the point chosen.

function frontRole(i) {
  const roles = summary.objectives.map((o, k) => (summary.ends[k] === i ? goalWords(o) : null));
  if (summary.knee === i) roles.push('knee');
  return roles.filter(Boolean).join(', ');
}

/**
 * What holds a point of the front, and for which goals: at an end its own goal alone, since there the
 * others have nothing to say; elsewhere each goal, with the others held where they are.
 */
function pointLimits(i) {
  const ends = summary.objectives.flatMap((goal, k) => (summary.ends[k] === i && summary.alone && summary.alone[k] ? [{ goals: [goal], report: { ...summary.front[i], ...summary.alone[k] } }] : []));
  return ends.length ? ends : [{ goals: summary.objectives, report: summary.front[i] }];
}

function othersWords() { return summary.objectives.length === 2 ? 'with the other goal where it is' : 'with the other goals where they are'; }

/** The same as sentences and lists, of so many lines each. */
function pointHolders(i, most) {
  if (!summary.front[i].certificate.weights.length) return [sentence('This front was found without derivatives: what its limits are worth is not known.')];
  return pointLimits(i).flatMap(({ goals, report }) => {
    const of = goals.length > 1 ? 'this point' : 'the ' + goalWords(goals[0]);
    if (!holders(report, goals).length && !wholeEnds(report).length) return [sentence('No limit stops ' + of + '.')];
    return [sentence('What stops ' + of + (goals.length > 1 ? ' (each gain ' + othersWords() + '):' : ':')), holderList(report, goals, most)];
  });
}

function goalWords(goal) { return (goal.sense === 'maximize' ? 'largest ' : 'smallest ') + plain(goal.metric); }

/** A goal may be a parameter. */
function frontValue(i, name) { return summary.front[i].metrics[name] ?? summary.front[i].design[name] ?? (summary.front[i].statistics || {})[name]; }

/** Goals k and l of the front; a click, or Enter, chooses the point under the cursor. */
function frontChart(node, k, l, choose) {
  const [a, b] = [summary.objectives[k].metric, summary.objectives[l].metric];
  const order = summary.front.map((_, i) => i).sort((i, j) => frontValue(i, a) - frontValue(j, a));
  const values = (name) => order.map((i) => frontValue(i, name));
  const ua = displayUnit(largest([values(a)]), unitOf(a));
  const ub = displayUnit(largest([values(b)]), unitOf(b));
  const x = scaled(values(a), ua.divisor);
  const y = scaled(values(b), ub.divisor);
  const read = el('div', { class: 'read', 'aria-live': 'polite' });
  let under = null;
  const marks = order.map((i, at) => ({ x: x[at], y: y[at], text: frontRole(i), colour: 'c0' })).filter((m) => m.text);
  const plot = chart(node, x, [{ name: 'front', y, colour: 'c0', scatter: true }], {
    name: 'front ' + k + ' ' + l, x: { label: axisLabel(a, ua), range: paddedRange([x]) }, y: { label: axisLabel(b, ub), range: paddedRange([y]) }, height: 340, marks,
    front: (u) => {
      const at = order.indexOf(front.chosen);
      if (at < 0) return;
      u.ctx.save();
      u.ctx.beginPath();
      u.ctx.arc(u.valToPos(x[at], 'x', true), u.valToPos(y[at], 'y', true), 9 * devicePixelRatio, 0, 2 * Math.PI);
      u.ctx.lineWidth = 2.5 * devicePixelRatio;
      u.ctx.strokeStyle = colour('c1');
      u.ctx.stroke();
      u.ctx.restore();
    },
    onMove: (i) => { under = i; if (i === null) { read.replaceChildren(); return; } readout(read, [[plain(a), rounded(x[i]) + ' ' + ua.text], [plain(b), rounded(y[i]) + ' ' + ub.text], ['', frontRole(order[i])]]); },
  });
  plot.over.addEventListener('click', () => under !== null && choose(order[under]));
  plot.root.parentNode.addEventListener('keydown', (e) => { if (e.key === 'Enter' && under !== null) choose(order[under]); });
  node.append(read);
  return plot;
}

const front = { chosen: null };

function chosenMotor(node, i) {
  const point = summary.front[i];
  const goals = summary.objectives.map((o) => plain(o.metric) + ' ' + goalText(o, goalValue(point, o))).join(', ');
  node.replaceChildren(el('h2', {}, 'Point ' + (i + 1) + (frontRole(i) ? ': ' + frontRole(i) : '')), el('p', {}, choiceWords(point) + goals + '. ' + (point.yields || []).map(yieldWords).join(' ') + ' ' + certificateText(point.certificate)));
  const left = el('div', {});
  const right = el('div', {});
  node.append(el('div', { class: 'pair' }, left, right));
  const curve = curves[i];
  if (curve) curvesChart(left, [curve], ['torque'], 'torque', 'torque', {});
  const explore = designerButton(point.design, 'point ' + (i + 1));
  if (explore) left.append(explore);
  right.append(valuesTable('point-' + (i + 1), 'parameter', Object.keys(point.design), [{ name: 'before', values: summary.before.design }, { name: 'this point', values: point.design }]));
  for (const { goals, report } of pointLimits(i)) {
    if (!report.constraints.length && !report.bounds.length) continue;
    const note = goals.length > 1 ? 'Loosened by 1 %, a limit that binds changes one goal or the other as said, to first order, ' + othersWords() + '.'
      : 'What would raise this end of the front further, whatever becomes of the other goals, to first order.';
    node.append(el('h3', {}, goals.length > 1 ? 'What stops it' : 'What stops the ' + goalWords(goals[0])), el('p', {}, note), limitsTable(report, goals));
  }
}

function paretoPage() {
  relaxationCard();
  if (!summary.front.length) return;
  const goals = summary.objectives.length;
  const plots = [];
  const motor = () => document.getElementById('chosen');
  const choose = (i) => { front.chosen = i; for (const p of plots) p.redraw(false); chosenMotor(motor(), i); along.choose(i); };
  for (let k = 0; k < goals; ++k) for (let l = k + 1; l < goals; ++l) {
    const node = card('The trade', 'Each point is a best compromise. Click one, or press Enter on it, to see its motor.', goals === 2 ? 'wide' : 'half');
    plots.push(frontChart(node, k, l, choose));
  }
  card(null, null, 'wide').id = 'chosen';
  const designNames = [...new Set(summary.front.flatMap((point) => Object.keys(point.design)))];
  const choices = Object.keys(summary.front[0].choice || {});
  const names = [...summary.objectives.map((o) => o.metric), ...designNames.filter((n) => !summary.objectives.some((o) => o.metric === n))];
  const columns = names.map((name) => ({ name, unit: unitOf(name), values: Float64Array.from(summary.front.map((_, i) => frontValue(i, name) ?? NaN)) }));
  const node = card('Along the front', 'One line for each point: goals, then what the design is made of. Drag along an axis to keep some points only; Escape shows all.', 'wide');
  const along = parallelChart(node, columns, new Filter(columns, summary.front.length), choose);
  const lines = summary.front.map((point, i) => [words(String(i + 1) + (frontRole(i) ? ' (' + frontRole(i) + ')' : '')), ...choices.map((n) => words(point.choice[n])), ...columns.map((c) => quantity(c.values[i], c.unit))]);
  card('The front as a table', null, 'wide').append(table('front', ['point', ...choices.map(shortName), ...names.map(plain)], lines, ['point', ...choices, ...columns.map((c) => c.name + ' [' + c.unit + ']')]));
  choose(summary.knee ?? 0);
}
