// SPDX-License-Identifier: Apache-2.0
// Bands of values over the plane of a chart: filled contours.

import {el, onTheme, svg} from './dom.js';
import {rampColour} from './ramp.js';
import {engineering, percent} from './units.js';

const countOf = ({levels}) => levels.length - 1;

/** The colour of band i, that of its middle. */
function bandColour(field, i) { return rampColour((i + 0.5) / countOf(field)); }

/** Paints the cells, each row in runs of one band. */
export function drawBands(u, field, divisors) {
  const {x: [left, right], y: [bottom, top], rows} = field;
  const columns = rows[0].length;
  const at = (from, to, i, count, axis) =>
      u.valToPos((from + ((to - from) * (i - 0.5)) / (count - 1)) / divisors[axis], axis, true);
  const x = Array.from({length: columns + 1}, (_, i) => at(left, right, i, columns, 'x'));
  const y = Array.from({length: rows.length + 1}, (_, j) => at(bottom, top, j, rows.length, 'y'));
  u.ctx.save();
  u.ctx.beginPath();
  u.ctx.rect(u.bbox.left, u.bbox.top, u.bbox.width, u.bbox.height);
  u.ctx.clip();
  rows.forEach((row, j) => {
    for (let from = 0, to = 0; from < columns; from = to) {
      while (to < columns && row[to] === row[from]) ++to;
      if (row[from] === ' ') continue;
      u.ctx.fillStyle = bandColour(field, row.charCodeAt(from) - 97);
      u.ctx.fillRect(x[from], y[j + 1], x[to] - x[from] + 0.5, y[j] - y[j + 1] + 0.5);
    }
  });
  u.ctx.restore();
}

/** A strip of the bands between the lowest and the highest level. */
export function bandLegend(field) {
  const {levels, name, unit} = field;
  const shown = (value) => (unit === '%' ? percent(value, 3) : engineering(value, unit, 3));
  const width = 200 / countOf(field);
  const strip = svg('svg', {width: 200, height: 12, 'aria-hidden': 'true'});
  const bar = (_, i) => svg('rect', {x: width * i, y: 0, width: width + 0.5, height: 12, fill: bandColour(field, i)});
  const paint = () => strip.replaceChildren(...Array.from({length: countOf(field)}, bar));
  paint();
  onTheme(paint);
  return el(
      'div', {class: 'legend'}, el('span', {}, name),
      el('span', {}, shown(levels[0]), strip, shown(levels[levels.length - 1])));
}
