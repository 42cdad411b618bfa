// SPDX-License-Identifier: Apache-2.0
// The result, as it stands in the page: summary.json, curves, and the stored rows as typed arrays.

import {numbers} from './bytes.js';

export const data = JSON.parse(document.getElementById('data').textContent);
export const summary = data.summary;

/** The stored rows: columns by position, and which status each row has. Of very many, one of each `every`. */
export const rows = {
  count: data.rows.count,
  every: data.rows.every,
  offsets: data.rows.every > 1 ? numbers(data.rows.offsets, Uint16Array) : null,
  total: data.rows.total,
  columns: data.rows.columns.map((c, i) => ({...c, values: numbers(data.rows.values[i], Float64Array)})),
  densities: data.rows.densities,
  statuses: data.rows.statuses,
  status: numbers(data.rows.status, Uint16Array),
};

/** Number of a row that the page holds, counted from 1 among all that are stored. */
export function rowNumber(i) { return i * rows.every + (rows.offsets ? rows.offsets[i] : 0) + 1; }

const curveColumns = [
  'speed', 'torque', 'output_power', 'stator_power', 'friction_power', 'layer_loss', 'contact_efficiency',
  'wear_intensity', 'stick_fraction', 'efficiency', 'stator_loss'
];

/** What motors with modal data have besides. */
export const terminalColumns = [
  'amplitude', 'phase_lag', 'voltage', 'phase_current', 'power_factor', 'electrical_power', 'overall_efficiency',
  'dielectric_loss'
];

export function atTerminals(curve) { return Boolean(curve.electrical_power); }

export const curves = data.curves.map((c) => {
  if (!c) return null;
  const curve = {...c};
  for (const name of curveColumns)
    if (c[name]) curve[name] = numbers(c[name], Float64Array);
  if (c.one_slice_torque) curve.one_slice_torque = numbers(c.one_slice_torque, Float64Array);
  if (c.electrical_power)
    for (const name of terminalColumns) curve[name] = numbers(c[name], Float64Array);
  if (c.driver_loss) curve.driver_loss = numbers(c.driver_loss, Float64Array);
  return curve;
});

/** What a name stands for in the tables of the program: "torque_at" for "torque_at(100 rpm)". */
export function tableRow(name) {
  const own = data.names[name]?.metric ?? name;
  return data.parameters[own] ?? data.metrics[own] ?? null;
}

/** SI unit of a parameter, a metric or a metric at an argument, such as "torque_at(100 rpm)". */
export function unitOf(name) { return (summary.units || {})[name] ?? tableRow(name)?.unit ?? '1'; }
