// SPDX-License-Identifier: Apache-2.0
// The chosen designs of a sweep: limits typed by hand, and a sorted table.

import {rowNumber, rows} from './data.js';
import {el} from './dom.js';
import {csvText, saveButton, tableFrame} from './table.js';
import {displayUnit, engineering, largest, rounded} from './units.js';
import {axisLabel, plain} from './words.js';

/** Limits typed by hand: two boxes for each column. */
export function filterBoxes(filter) {
  const units = filter.columns.map((c) => displayUnit(largest([c.values]), c.unit));
  const inputs = [];
  const lines = filter.columns.map((c, k) => {
    const box = (side) => {
      const node = el(
          'input', {class: 'limit', inputmode: 'decimal', 'aria-label': side + ' ' + plain(c.name), placeholder: side});
      node.addEventListener('change', () => {
        const [low, high] = inputs[k].map((n) => {
          const v = n.value.trim() === '' ? null : Number(n.value.replace(',', '.'));
          return v === null || Number.isNaN(v) ? null : v * units[k].divisor;
        });
        filter.set(k, low, high);
      });
      return node;
    };
    inputs[k] = [box('least'), box('most')];
    return el(
        'tr', {}, el('td', {}, axisLabel(c.name, units[k])), el('td', {}, inputs[k][0]), el('td', {}, inputs[k][1]));
  });
  filter.onChange(() => inputs.forEach((pair, k) => {
    const interval = filter.intervals.get(k) || [-Infinity, Infinity];
    pair.forEach((n, s) => {
      if (document.activeElement !== n)
        n.value = Number.isFinite(interval[s]) ? rounded(interval[s] / units[k].divisor) : '';
    });
  }));
  const count = el('p', {class: 'read', 'aria-live': 'polite', 'data-count': ''});
  const tell = () => {
    count.replaceChildren(
        el('b', {}, String(filter.total)),
        ' of ' + filter.count + ' designs' + (rows.every > 1 ? ' on this page' : ''));
  };
  filter.onChange(tell);
  tell();
  return el(
      'div', {}, count, el('table', {}, el('tbody', {}, lines)),
      el('div', {class: 'tools'}, el('button', {type: 'button', onclick: () => filter.clear()}, 'Show all')));
}

/** The chosen designs, sorted by a column: 100 of them to read, all that the page holds in the file to save. */
export class DesignsTable {
  constructor(node, filter, view) {
    this.node = node;
    this.filter = filter;
    this.view = view;
    this.column = 0;
    this.down = false;
    let due = 0;
    filter.onChange(() => {
      clearTimeout(due);
      due = setTimeout(() => this.build(), 30);
    });
    this.build();
  }

  sorted() {
    const {filter, column, down} = this;
    const list = [];
    for (let i = 0; i < filter.count; ++i)
      if (filter.chosen[i]) list.push(i);
    const last = down ? -Infinity : Infinity;
    const keys = Float64Array.from(filter.columns[column].values, (v) => (Number.isFinite(v) ? v : last));
    return list.sort(down ? (a, b) => keys[b] - keys[a] || a - b : (a, b) => keys[a] - keys[b] || a - b);
  }

  headCell(c, k) {
    const on = k === this.column;
    const press = () => {
      this.down = on ? !this.down : false;
      this.column = k;
      this.build();
    };
    const arrow = on ? (this.down ? ' ▼' : ' ▲') : '';
    const order = on ? (this.down ? 'descending' : 'ascending') : 'none';
    const button = el('button', {type: 'button', onclick: press}, plain(c.name) + arrow);
    return el('th', {scope: 'col', 'aria-sort': order}, button);
  }

  line(i) {
    const values =
        this.filter.columns.map((c) => el('td', {'data-value': c.values[i]}, engineering(c.values[i], c.unit)));
    const status = el('td', {class: 'words'}, rows.statuses[rows.status[i]]);
    return el('tr', {onmouseenter: () => this.view.show(i)}, el('td', {}, String(rowNumber(i))), values, status);
  }

  csv() {
    const {columns} = this.filter;
    const cells = (i) => [rowNumber(i), ...columns.map((c) => c.values[i]), rows.statuses[rows.status[i]]];
    return csvText(['design', ...columns.map((c) => c.name + ' [' + c.unit + ']'), 'status'], this.sorted().map(cells));
  }

  note(count) {
    const part = rows.every > 1;
    const first = 'The first 100 of ' + count + (part ? ' on this page' : '') + '; the CSV file has all of them.';
    return (count > 100 ? first : count + ' designs.') + (part ? ' results.csv has every design.' : '');
  }

  build() {
    const list = this.sorted();
    const cells = this.filter.columns.map((c, k) => this.headCell(c, k));
    const head = el('tr', {}, el('th', {scope: 'col'}, 'design'), cells, el('th', {class: 'words'}, 'status'));
    const {scroll, more} = tableFrame('designs', head, list.slice(0, 100).map((i) => this.line(i)));
    const save = saveButton('designs', () => this.csv());
    this.node.replaceChildren(
        el('p', {class: 'soft'}, this.note(list.length)), scroll, el('div', {class: 'table-tools'}, more, save));
  }
}
