// SPDX-License-Identifier: Apache-2.0
// Names as the program reads them out.

import {data} from './data.js';

/** "peak power", "torque at 80 rpm", "5 % quantile of the stall torque" */
export function plain(name) { return data.names[name]?.text ?? name; }

export function axisLabel(name, shown) { return plain(name) + (shown.text ? ' [' + shown.text + ']' : ''); }
