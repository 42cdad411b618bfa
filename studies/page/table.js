// SPDX-License-Identifier: Apache-2.0
// Tables that can be taken along as CSV: engineering units on the page, SI values in the file.

import {tableRow} from './data.js';
import {el, save} from './dom.js';
import {engineering} from './units.js';
import {plain} from './words.js';

/** More rows than these are shown when asked for. */
const rowsShown = 12;

function csvCell(value) {
  if (value === null || value === undefined || Number.isNaN(value)) return '';
  const text = String(value);
  return /[",\n\r]/.test(text) ? '"' + text.replace(/"/g, '""') + '"' : text;
}

export function csvText(header, lines) {
  return [header, ...lines].map((line) => line.map(csvCell).join(',')).join('\n') + '\n';
}

export function saveButton(file, make) {
  return el('button', {class: 'save', type: 'button', onclick: () => save(file + '.csv', make())}, 'Save as CSV');
}

/** A cell of words. */
export function words(text, look) { return {text, value: text, words: true, look}; }
/** A cell with the name of a metric or parameter, which the file has as it is typed. */
export function named(name) { return {text: plain(name), value: name, words: true}; }
/** A cell with a value in an SI unit. */
export function quantity(value, unit, digits) { return {text: engineering(value, unit, digits), value, unit}; }

/** wordy: the column has no numbers */
function cell(c, wordy) {
  if (typeof c === 'string') return el('td', {}, c);
  const name = c.words && c.value !== c.text ? c.value : null;
  const attributes = {
    class: c.words ? (wordy ? 'words' : '') + (String(c.text).length > 18 ? ' long' : '') : null,
    'data-value': c.words ? null : c.value,
    'data-name': name,
    title: name === null ? null : describe(name)
  };
  return el('td', attributes, c.look ? el('span', {class: c.look}, c.text) : c.text);
}

/** What a name stands for, in one line. */
export function describe(name) {
  const known = tableRow(name);
  return name + (known ? ': ' + known.text : '');
}

/** Shows the first rows of a long table, and a button that shows all; on paper all are there. */
function folded(node, count) {
  if (count <= rowsShown) return null;
  node.classList.add('folded');
  const button = el('button', {class: 'save', type: 'button'}, 'Show all ' + count + ' rows');
  button.addEventListener('click', () => {
    node.classList.remove('folded');
    button.remove();
  });
  return button;
}

/** The markup of a table, its long part folded away. rows: elements */
export function tableFrame(file, head, rows) {
  const scroll =
      el('div', {class: 'scroll', tabindex: '0', role: 'region', 'aria-label': file},
         el('table', {'data-table': file}, el('thead', {}, head), el('tbody', {}, rows)));
  return {scroll, more: folded(scroll, rows.length)};
}

/** A table with its buttons. Each line begins with its name. csvHeader: heads of the saved file, where others */
export function table(file, header, lines, csvHeader) {
  const raw = (c) => (typeof c === 'string' ? c : c.value);
  return tableSaved(file, header, lines, () => csvText(csvHeader || header, lines.map((line) => line.map(raw))));
}

/** The same with a file that is made otherwise. */
export function tableSaved(file, header, lines, make) {
  const wordy = header.map((_, i) => i === 0 || lines.every((line) => line[i]?.words));
  const head = el('tr', {}, header.map((h, i) => el('th', {scope: 'col', class: i && wordy[i] ? 'words' : null}, h)));
  const rows = lines.map((line) => el('tr', {}, line.map((c, i) => cell(c, wordy[i]))));
  const {scroll, more} = tableFrame(file, head, rows);
  return el('div', {}, scroll, el('div', {class: 'table-tools'}, more, saveButton(file, make)));
}
