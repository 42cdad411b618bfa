// SPDX-License-Identifier: Apache-2.0
'use strict';
// Spread over tolerances: histograms with quantiles and limits, yield.

function limitOn(metric) {
  return (summary.limits || []).map((l) => l.text).filter((t) => metricOfLimit(t) === metric);
}

function histogram(node, column, info) {
  const finite = column.values.filter(Number.isFinite);
  if (!finite.length) { node.append(el('p', {}, 'No motor has a value.')); return; }
  const unit = displayUnit(largest([finite]), column.unit);
  let [low, high] = [Infinity, -Infinity];
  for (const v of finite) { low = Math.min(low, v); high = Math.max(high, v); }
  if (low === high) { node.append(el('p', {}, 'The same in every motor: ' + engineering(low, column.unit) + '.')); return; }
  const bins = Math.min(60, Math.max(8, Math.ceil(Math.sqrt(finite.length) / 1.5)));
  const width = (high - low) / bins;
  const counts = new Float64Array(bins + 1);
  for (const v of finite) counts[Math.min(bins - 1, Math.floor((v - low) / width))] += 1;
  counts[bins] = NaN;
  const edges = Float64Array.from({ length: bins + 1 }, (_, i) => (low + i * width) / unit.divisor);
  const lines = Object.entries(info.quantiles || {}).map(([p, v]) => ({ value: v / unit.divisor, name: rounded(100 * Number(p)) + ' %' }));
  const read = el('div', { class: 'read' });
  chart(node, edges, [{ name: 'motors', y: counts, colour: 'c0', bars: true }], {
    name: 'histogram ' + column.name, x: { label: axisLabel(column.name, unit), range: [edges[0], edges[bins]] }, y: { label: 'motors', range: [0, 1.12 * Math.max(...counts.slice(0, bins))] }, height: 240,
    front: (u) => {
      const ctx = u.ctx;
      ctx.save();
      for (const l of lines) {
        const x = u.valToPos(l.value, 'x', true);
        ctx.strokeStyle = colour('c1'); ctx.lineWidth = 1.5 * devicePixelRatio; ctx.setLineDash([5 * devicePixelRatio, 4 * devicePixelRatio]);
        ctx.beginPath(); ctx.moveTo(x, u.bbox.top); ctx.lineTo(x, u.bbox.top + u.bbox.height); ctx.stroke();
      }
      ctx.restore();
      const taken = [];
      for (const l of lines) drawLabel(u, l.name, u.valToPos(l.value, 'x', true) - 4 * devicePixelRatio, u.bbox.top + 20 * devicePixelRatio, taken);
    },
    onMove: (i) => { if (i === null || i >= bins) { read.replaceChildren(); return; } readout(read, [['between', rounded(edges[i]) + ' and ' + rounded(edges[i + 1]) + ' ' + unit.text], ['motors', String(counts[i])]]); },
  });
  node.append(read);
}

function uncertaintyPage() {
  const quantiles = Object.keys(Object.values(summary.metrics)[0]?.quantiles || {});
  for (const [name, info] of Object.entries(summary.metrics)) {
    const column = rows.columns.find((c) => c.name === name);
    const limits = limitOn(name);
    const node = card(plain(name), 'Mean ' + engineering(info.mean, unitOf(name)) + ', standard deviation ' + engineering(info.sd, unitOf(name), 3) + (limits.length ? '; limit ' + limits.join(', ') : '') + '. Dashed: quantiles.', 'half');
    if (column) histogram(node, column, info);
  }
  const lines = Object.entries(summary.metrics).map(([n, m]) => [words(n), quantity(m.mean, unitOf(n)), quantity(m.sd, unitOf(n)), ...quantiles.map((q) => quantity(m.quantiles[q], unitOf(n))), { text: String(m.missing), value: m.missing }]);
  card('Spread', null, 'wide').append(table('spread', ['metric', 'mean', 'standard deviation', ...quantiles.map((q) => rounded(100 * Number(q)) + ' %'), 'without value'], lines));
  if (summary.limits) card('Limits', null, 'half').append(table('limits', ['limit', 'kept by', 'at least', 'at most'], summary.limits.map((l) => [words(l.text), { text: percent(l.kept.value, 4), value: l.kept.value }, { text: percent(l.kept.low, 4), value: l.kept.low }, { text: percent(l.kept.high, 4), value: l.kept.high }])));
  motorCurve();
}
