// SPDX-License-Identifier: Apache-2.0
// How an answer changes with the parameters that it holds fixed.

import {summary, unitOf} from './data.js';
import {card} from './dom.js';
import {named, quantity, table, words} from './table.js';
import {engineering, noBreak, rounded} from './units.js';
import {plain} from './words.js';

const title = 'How the answer changes if a fixed parameter is 1 % larger';

/** "-1 %", to hundredths of a percent; the change itself of a number that is 0. */
function change(by, from, unit) {
  if (by === null) return words('-');
  const percent = Math.round(1e4 * by / from) / 100;
  const text = from === 0 ? engineering(by, unit, 3) : rounded(percent, 6) + noBreak + '%';
  return {text: (by > 0 && percent !== 0 ? '+' : '') + text, value: by, unit};
}

/** The changes to first order; `value` gives the numbers of the answer by their names. */
export function movesCard(value) {
  const moves = Object.entries(summary.moves || {});
  if (summary.moves_missing)
    card(title, 'How the answer changes with a fixed parameter is unknown: ' + summary.moves_missing + '.', 'wide');
  if (!moves.length || summary.moves_missing) return;
  const names = Object.keys(moves[0][1].slopes);
  const line = ([held, {value: at, unit, slopes}]) =>
      [named(held), quantity(at, unit),
       ...names.map((n) => change(slopes[n] === null ? null : 0.01 * at * slopes[n], value(n), unitOf(n)))];
  const now = [words('(answer now)'), '', ...names.map((n) => quantity(value(n), unitOf(n)))];
  card(title, 'Each row has one parameter 1 % larger, the others as they are, and the answer found again.', 'wide')
      .append(table('moves', ['fixed parameter', 'value', ...names.map(plain)], [now, ...moves.map(line)]));
}
