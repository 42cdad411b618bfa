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

/** The columns of a curve by name, beside what else there is of it. */
function readCurve(curve) {
  const columns = curve.columns.map(({name, values}) => [name, numbers(values, Float64Array)]);
  if (curve.one_slice_torque) columns.push(['one_slice_torque', numbers(curve.one_slice_torque, Float64Array)]);
  const even = (_, i, all) => (curve.last_speed * i) / (all.length - 1);
  if (curve.last_speed !== undefined) columns.push(['speed', columns[0][1].map(even)]);
  return {...curve, ...Object.fromEntries(columns)};
}

/** The motors of the answer, of a front one for each point; null where a design makes no motor. */
export const curves = data.curves.map((c) => c && readCurve(c));

/** What a name stands for in the tables of the program: "torque_at" for "torque_at(100 rpm)". */
export function tableRow(name) {
  const own = data.names[name]?.metric ?? name;
  return data.parameters[own] ?? data.metrics[own] ?? null;
}

/** SI unit of a parameter, a metric or a metric at an argument, such as "torque_at(100 rpm)". */
export function unitOf(name) { return (summary.units || {})[name] ?? tableRow(name)?.unit ?? '1'; }
