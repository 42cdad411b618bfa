// SPDX-License-Identifier: Apache-2.0
'use strict';
// The front: goals against each other, the design along it, and the motor of the point chosen.

function frontRole(i) {
  const roles = summary.objectives.map((o, k) => (summary.ends[k] === i ? (o.sense === 'maximize' ? 'largest ' : 'smallest ') + plain(o.metric) : null));
  if (summary.knee === i) roles.push('knee');
  return roles.filter(Boolean).join(', ');
}

/** Goals k and l of the front; a click, or Enter, chooses the point under the cursor. */
function frontChart(node, k, l, choose) {
  const [a, b] = [summary.objectives[k].metric, summary.objectives[l].metric];
  const order = summary.front.map((_, i) => i).sort((i, j) => summary.front[i].metrics[a] - summary.front[j].metrics[a]);
  const values = (name) => order.map((i) => summary.front[i].metrics[name]);
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
  const goals = summary.objectives.map((o) => plain(o.metric) + ' ' + engineering(point.metrics[o.metric], unitOf(o.metric))).join(', ');
  node.replaceChildren(el('h2', {}, 'Point ' + (i + 1) + (frontRole(i) ? ': ' + frontRole(i) : '')), el('p', {}, goals + '. ' + certificateText(point.certificate)));
  const left = el('div', {});
  const right = el('div', {});
  node.append(el('div', { class: 'pair' }, left, right));
  const curve = curves[i];
  if (curve) curvesChart(left, [curve], ['torque'], 'torque', 'torque', {});
  right.append(valuesTable('point-' + (i + 1), 'parameter', Object.keys(point.design), [{ name: 'before', values: summary.before.design }, { name: 'this point', values: point.design }]));
  if (point.constraints.length || point.bounds.length) right.append(el('h3', {}, 'Limits'), limitsTable(point, null));
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
  const designNames = Object.keys(summary.front[0].design);
  const names = [...summary.objectives.map((o) => o.metric), ...designNames.filter((n) => !summary.objectives.some((o) => o.metric === n))];
  const columns = names.map((name) => ({ name, unit: unitOf(name), values: Float64Array.from(summary.front, (p) => p.design[name] ?? p.metrics[name] ?? NaN) }));
  const node = card('Along the front', 'One line for each point: goals, then what the design is made of. Drag along an axis to keep some points only; Escape shows all.', 'wide');
  const along = parallelChart(node, columns, new Filter(columns, summary.front.length), choose);
  const lines = summary.front.map((p, i) => [words(String(i + 1) + (frontRole(i) ? ' (' + frontRole(i) + ')' : '')), ...columns.map((c) => quantity(c.values[i], c.unit))]);
  card('The front as a table', null, 'wide').append(table('front', ['point', ...names.map(plain)], lines, ['point', ...columns.map((c) => c.name + ' [' + c.unit + ']')]));
  choose(summary.knee ?? 0);
}
