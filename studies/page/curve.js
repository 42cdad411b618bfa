// SPDX-License-Identifier: Apache-2.0
// What a reader does with curves: the fields in the contact follow the cursor, and the points are a table.

import {curves} from './data.js';
import {el} from './dom.js';
import {fieldsCard} from './fields.js';
import {shortName} from './names.js';
import {quantity, table, words} from './table.js';
import {draw} from './telling.js';
import {rpm} from './units.js';

/** Every point, with the columns that all curves have. */
function pointsTable(node) {
  const list = curves.filter(Boolean);
  const shown = list[0].columns.filter(({name}) => list.every((c) => c[name]));
  const line = (c, i) => [words(c.label), ...shown.map(({name, unit}) => quantity(c[name][i], unit))];
  const lines = list.flatMap((c) => Array.from(c.speed, (_, i) => line(c, i)));
  const header = ['curve', ...shown.map(({name, unit}) => name + ' [' + unit + ']')];
  node.append(
      el('details', {}, el('summary', {}, 'All ' + lines.length + ' points'),
         table('curve', ['curve', ...shown.map(({name}) => shortName(name))], lines, header)));
}

/** The hooks of charts over the speed. */
export function curveHooks() {
  let viewer = null;
  const overSpeed = (node, {charts, wide}) => {
    const follow = 'Point at the curve or use the arrow keys to see the fields in the contact; drag to zoom.';
    if (wide && curves.some((c) => c?.fields)) node.append(el('p', {}, follow));
    const onMove = (i, u) => {
      if (i !== null) viewer?.show(u.data[0][i] * rpm);
    };
    for (const chart of charts) draw(node, chart, {height: wide ? 360 : 300, onMove});
  };
  return {
    speed: Object.assign(overSpeed, {draws: true}),
    fields: Object.assign(
        (node, {charts}) => {
          viewer = fieldsCard(node, charts, curves.filter(Boolean));
        },
        {draws: true}),
    points: pointsTable
  };
}
