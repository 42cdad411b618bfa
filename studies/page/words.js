// SPDX-License-Identifier: Apache-2.0
// Names as the program reads them out.

import {data} from './data.js';
import {extent, rampLegend} from './ramp.js';
import {engineering} from './units.js';

/** "peak power", "torque at 80 rpm", "5 % quantile of the stall torque" */
export function plain(name) { return data.names[name]?.text ?? name; }

export function axisLabel(name, shown) { return plain(name) + (shown.text ? ' [' + shown.text + ']' : ''); }

/** What the colours of a column mean. */
export function rampBar(column) {
  const {low, high} = extent(column.values);
  return rampLegend(plain(column.name), engineering(low, column.unit, 3), engineering(high, column.unit, 3));
}
