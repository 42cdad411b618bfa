// SPDX-License-Identifier: Apache-2.0
'use strict';
// The result, as it stands in the page: summary.json, curves, and the stored rows as typed arrays.

const data = JSON.parse(document.getElementById('data').textContent);
const summary = data.summary;

/** The stored rows: columns by position, and which status each row has. Of very many, one of each `every`. */
const rows = {
  count: data.rows.count,
  every: data.rows.every,
  offsets: data.rows.every > 1 ? numbers(data.rows.offsets, Uint16Array) : null,
  total: data.rows.total,
  columns: data.rows.columns.map((c, i) => ({ ...c, values: numbers(data.rows.values[i], Float64Array) })),
  statuses: data.rows.statuses,
  status: numbers(data.rows.status, Uint16Array),
};

/** Number of a row that the page holds, counted from 1 among all that are stored. */
function rowNumber(i) { return i * rows.every + (rows.offsets ? rows.offsets[i] : 0) + 1; }

const curveColumns = ['speed', 'torque', 'output_power', 'stator_power', 'friction_power', 'layer_loss',
  'contact_efficiency', 'wear_intensity', 'stick_fraction', 'efficiency', 'stator_loss'];

/** What motors with modal data have besides. */
const terminalColumns = ['amplitude', 'phase_lag', 'voltage', 'phase_current', 'power_factor', 'electrical_power', 'overall_efficiency', 'dielectric_loss'];

function atTerminals(curve) { return Boolean(curve.electrical_power); }

const curves = data.curves.map((c) => {
  if (!c) return null;
  const curve = { ...c };
  for (const name of curveColumns) curve[name] = numbers(c[name], Float64Array);
  if (c.electrical_power) for (const name of terminalColumns) curve[name] = numbers(c[name], Float64Array);
  return curve;
});

/** SI unit of a parameter, a metric or a metric at an argument, such as "torque_at(100 rpm)". */
function unitOf(name) {
  const units = summary.units || {};
  if (Object.hasOwn(units, name)) return units[name];
  const plain = name.replace(/\(.*$/s, '').trim();
  const known = Object.hasOwn(data.parameters, plain) ? data.parameters[plain]
    : Object.hasOwn(data.metrics, plain) ? data.metrics[plain] : null;
  return known ? known.unit : '1';
}
