// SPDX-License-Identifier: Apache-2.0
// The page, from top to bottom: what came out, what is said of it in the order of the program, background.

import {curveHooks} from './curve.js';
import {curves, data, rows, summary, tableRow, unitOf} from './data.js';
import {designerButton} from './designer/inside.js';
import {bullets, card, el, sentence} from './dom.js';
import {savedMotor} from './motor.js';
import {capital} from './names.js';
import {frontHooks} from './pareto.js';
import {sweepHooks} from './sweep.js';
import {named, quantity, table, words} from './table.js';
import {saidNodes, tellSections} from './telling.js';
import {between, engineering, rounded} from './units.js';
import {plain} from './words.js';

/** The motors of the answer, which are those of the last curves. */
function motorFiles(node) {
  const shown = curves.slice(-data.files.length || undefined);
  data.files.forEach((file, i) => {
    const of = shown[i];
    node.append(savedMotor(file, of && designerButton(of.design, of.label)));
  });
}

/** What sections have besides, for a reader who points at it or chooses. */
const hooks = {
  ...curveHooks(),
  ...frontHooks(),
  ...sweepHooks(),
  'motor file': motorFiles
};

/** What every page ends with. */
const background = [notesCard, failuresCard, motorCard, glossaryCard, provenanceCard];

/** What a row of the results is: a motor, or a point of a motor's curve. */
function rowWord() { return data.headline.rows; }

/** Said where the results are too many for a page. */
function partNote() {
  if (rows.every === 1) return null;
  return sentence(
      'This page holds one in ' + rows.every + ' of the ' + rows.total + ' ' + rowWord() +
      ' that were computed; results.csv has all of them.');
}

function facts() {
  const failed = Object.values(summary.failures).reduce((a, b) => a + b, 0);
  const notes = (summary.model_notes || []).length;
  const list = [[rowWord() + ' computed', String(summary.evaluations)]];
  if (failed) list.push(['of these ' + data.headline.unanswered, String(failed)]);
  const fact = ([name, value]) => el('div', {}, el('span', {}, name), el('strong', {}, value));
  const limits = el('a', {href: '#notes'}, notes + (notes === 1 ? ' note' : ' notes') + ' on the validity');
  return el('div', {class: 'facts'}, list.map(fact), notes ? limits : null);
}

function verdictCard() {
  const told = data.headline;
  const pill = el('p', {class: 'pill'}, capital(told.badge));
  card(null, null, 'wide verdict ' + told.look, pill, ...saidNodes(told), facts(), partNote());
}

/** Reasons to doubt the model for these motors; names in them are as one types them. */
function notesCard() {
  const notes = summary.model_notes || [];
  if (!notes.length) return;
  card('Validity', null, 'wide', bullets(notes.map((note) => capital(note) + '.'))).id = 'notes';
}

function failuresCard() {
  if (!summary.failure_regions.length) return;
  const range = (n, v) => (v.high > v.low ? between(v.low, v.high, unitOf(n)) : engineering(v.low, unitOf(n)));
  const end = (n, v) => (typeof v.low === 'string' ? v.low : range(n, v));
  const where = (r) =>
      Object.entries(r.where).filter(([, v]) => v.low !== null).map(([n, v]) => plain(n) + ' ' + end(n, v));
  const note = 'A requested number does not exist for these ' + rowWord() + ', or could not be computed. They ' +
      'are counted here and left out of everything else.';
  const lines = summary.failure_regions.map(
      (r) =>
          [words(r.reason), words(data.failures[r.reason]), {text: String(r.count), value: r.count},
           words(where(r).join(', '))]);
  card(capital(rowWord()) + ': ' + data.headline.unanswered, note, 'wide')
      .append(table('failures', ['reason', 'meaning', 'count', 'where'], lines));
}

/** A card of which only the title shows until it is opened. */
function foldedCard(title, note, width, ...children) {
  const head = el('summary', {}, el('h2', {}, title), note ? el('span', {}, note) : null);
  return card(null, null, width, el('details', {}, head, ...children));
}

function motorCard() {
  const lines = Object.entries(data.motor.design).map(([n, value]) => {
    const {symbol, unit, text} = data.parameters[n];
    return [named(n), words(symbol), quantity(value, unit), words(text)];
  });
  foldedCard(
      'The motor of the study', data.motor.name, 'wide', designerButton({}, data.motor.name),
      table('motor', ['parameter', 'symbol', 'value', 'meaning'], lines));
}

/** What the names on this page stand for. */
function glossaryCard() {
  const all = [...rows.columns.map((c) => c.name), ...curves.filter(Boolean).flatMap((c) => Object.keys(c.metrics))];
  const names = [...new Set(all.map((n) => data.names[n]?.metric ?? n))].filter(tableRow);
  const lines = [
    ...names.map((n) => [named(n), words(tableRow(n).text), words(n)]),
    ...Object.entries(data.efficiencies).map(([n, text]) => [words(n.replaceAll('_', ' ')), words(text), words(n)])
  ];
  foldedCard('Names', lines.length + ' names', 'wide', table('names', ['name', 'meaning', 'as typed'], lines));
}

function provenanceCard() {
  const build = summary.build || {};
  const lines =
      [
        ['twum', summary.version], ['started', summary.started], ['time', rounded(summary.seconds, 3) + ' s'],
        ['seed', String(summary.seed)], ['hash of the study', summary.hash], ['compiler', build.compiler],
        ...Object.entries(build.libraries || {})
      ].filter(([, v]) => v !== undefined && v !== null && v !== '')
          .map(([n, v]) => [words(n), words(String(v))]);
  foldedCard('Provenance', 'version, date, libraries', 'half', table('provenance', ['item', 'value'], lines));
  foldedCard('The study', 'as run, with all defaults', 'half', el('pre', {tabindex: '0'}, data.study));
}

/** The last of an odd number of cards of half a row takes the whole row, so that no hole is left beside it. */
function evenHalves() {
  let run = [];
  for (const node of [...document.querySelectorAll('#page > .card'), null]) {
    if (node?.classList.contains('half'))
      run.push(node);
    else {
      if (run.length % 2) run[run.length - 1].classList.replace('half', 'wide');
      run = [];
    }
  }
}

/** Links to the cards with a title, once they are there. */
function contents() {
  const links = [...document.querySelectorAll('.card h2')].map((title, i) => {
    const node = title.closest('.card');
    node.id ||= 'part-' + (i + 1);
    const open = () => node.querySelector(':scope > details')?.setAttribute('open', '');
    return el('a', {href: '#' + node.id, onclick: open}, title.textContent);
  });
  return el('nav', {'aria-label': 'contents'}, links);
}

async function build() {
  document.title = summary.study + ' - twum';
  const page = document.getElementById('page');
  page.append(el('header', {}, el('h1', {}, summary.study), el('p', {class: 'of'}, data.headline.title)));
  verdictCard();
  const told = tellSections(hooks);
  for (const section of background) section();
  evenHalves();
  page.querySelector('.verdict').after(contents());
  await told;
  page.dataset.ready = 'yes';
}

build();
