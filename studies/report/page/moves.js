// SPDX-License-Identifier: Apache-2.0
// How an answer moves with the parameters that it holds fixed.

import {summary, unitOf} from './data.js';
import {card} from './dom.js';
import {named, quantity, table} from './table.js';
import {plain} from './words.js';

/**
 * What the answer would be, were a parameter that is held fixed 1 % larger. `value` gives the numbers of the answer by
 * their names.
 */
export function movesCard(value) {
  const moves = Object.entries(summary.moves || {});
  if (!moves.length) {
    if (summary.moves_missing)
      card(
          'With other values of what is held fixed',
          'How the optimum moves cannot be said: ' + summary.moves_missing + '.', 'wide');
    return;
  }
  const names = Object.keys(moves[0][1].slopes);
  const line = ([held, {value: at, unit, slopes}]) =>
      [named(held), quantity(1.01 * at, unit),
       ...names.map((n) => quantity(value(n) + 0.01 * at * slopes[n], unitOf(n)))];
  card(
      'With other values of what is held fixed',
      'Each row has one parameter 1 % larger, the rest as it is, and the answer found anew.', 'wide')
      .append(table('moves', ['held fixed', 'if it were', ...names.map(plain)], moves.map(line)));
}
