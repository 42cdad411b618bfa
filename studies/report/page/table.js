// SPDX-License-Identifier: Apache-2.0
'use strict';
// Tables that can be taken along as CSV: engineering units on the page, SI values in the file.

function csvCell(value) {
  if (value === null || value === undefined || Number.isNaN(value)) return '';
  const text = String(value);
  return /[",\n\r]/.test(text) ? '"' + text.replace(/"/g, '""') + '"' : text;
}

function csvText(header, lines) {
  return [header, ...lines].map((line) => line.map(csvCell).join(',')).join('\n') + '\n';
}

function saveButton(file, make) {
  return el('button', { class: 'save', type: 'button', onclick: () => save(file + '.csv', make()) }, 'Save as CSV');
}

/** A cell of words. */
function words(text, look) { return { text, value: text, words: true, look }; }
/** A cell with the name of a metric or parameter, which the file has as it is typed. */
function named(name) { return { text: plain(name), value: name, words: true }; }
/** A cell with a value in an SI unit. */
function quantity(value, unit, digits) { return { text: engineering(value, unit, digits), value, unit }; }

function cell(tag, c) {
  if (typeof c === 'string') return el(tag, {}, c);
  const node = el(tag, { class: c.words ? 'words' : null, 'data-value': c.words ? null : c.value, 'data-name': c.words && c.value !== c.text ? c.value : null, title: c.words && c.value !== c.text ? describe(c.value) : null }, c.look ? el('span', { class: c.look }, c.text) : c.text);
  return node;
}

/** What a name stands for, in one line. */
function describe(name) {
  const known = data.parameters[name] || data.metrics[name.replace(/\(.*$/s, '')];
  return name + (known ? ': ' + known.text : '');
}

/** A table with its button. Each line begins with its name. */
function table(file, header, lines, csvHeader) {
  const head = el('tr', {}, header.map((h, i) => el('th', { scope: 'col', class: i > 0 && lines[0] && lines[0][i] && lines[0][i].words ? 'words' : null }, h)));
  const body = lines.map((line) => el('tr', {}, line.map((c) => cell('td', c))));
  const raw = (c) => (typeof c === 'string' ? c : c.value);
  return el('div', {},
    el('div', { class: 'scroll', tabindex: '0', role: 'region', 'aria-label': file }, el('table', { 'data-table': file }, el('thead', {}, head), el('tbody', {}, body))),
    saveButton(file, () => csvText(csvHeader || header, lines.map((line) => line.map(raw)))));
}

/** Names with values in SI units, side by side: before and after, or several designs. */
function valuesTable(file, first, names, columns) {
  const lines = names.map((name) => [named(name), ...columns.map((c) => quantity(c.values[name], unitOf(name)))]);
  const csvLines = names.map((name) => [name, unitOf(name), ...columns.map((c) => c.values[name])]);
  const node = table(file, [first, ...columns.map((c) => c.name)], lines);
  node.lastChild.replaceWith(saveButton(file, () => csvText([first, 'SI unit', ...columns.map((c) => c.name)], csvLines)));
  return node;
}
