// SPDX-License-Identifier: Apache-2.0
'use strict';
// Elements of the page. Text from files enters as text nodes only, never as markup.

/** An element with attributes and children; strings become text. */
function el(tag, attributes = {}, ...children) {
  const node = document.createElement(tag);
  for (const [name, value] of Object.entries(attributes)) {
    if (name.startsWith('on')) node.addEventListener(name.slice(2), value);
    else if (value !== null && value !== undefined) node.setAttribute(name, value);
  }
  node.append(...children.flat().filter((c) => c !== null && c !== undefined));
  return node;
}

function svg(tag, attributes, ...children) {
  const node = document.createElementNS('http://www.w3.org/2000/svg', tag);
  for (const [name, value] of Object.entries(attributes)) {
    if (name === 'style') node.style.cssText = value; // as an attribute the page's policy refuses it
    else node.setAttribute(name, value);
  }
  node.append(...children);
  return node;
}

/** A card of the page. */
function card(title, note, width, ...children) {
  const node = el('section', { class: 'card ' + width }, title ? el('h2', {}, title) : null, note ? el('p', {}, note) : null, ...children);
  document.getElementById('page').append(node);
  return node;
}

/** A style's colour, as the theme of the moment has it. */
function colour(name) {
  return getComputedStyle(document.documentElement).getPropertyValue('--' + name).trim();
}

function isDark() { return matchMedia('(prefers-color-scheme: dark)').matches && !document.documentElement.dataset.print; }

const seriesColours = ['c0', 'c1', 'c2', 'c3', 'c4', 'c5', 'c6'];

/** The first five colours are apart for every eye; what follows is dashed besides. */
function seriesDash(i) { return i >= 5 ? [7, 4] : undefined; }
function seriesEntry(name, i) { return { name, colour: seriesColours[i % 7], kind: i >= 5 ? 'dash' : '' }; }

/** Offers a text as a file. */
function save(name, text, type = 'text/csv') {
  const url = URL.createObjectURL(new Blob([text], { type }));
  el('a', { href: url, download: name }).click();
  setTimeout(() => URL.revokeObjectURL(url), 1000);
}

function legend(entries) {
  return el('div', { class: 'legend' }, entries.map((e) => {
    const mark = el('i', { class: e.kind || '' });
    const paint = () => {
      const c = colour(e.colour);
      if (e.kind === 'dot' || e.kind === 'area') mark.style.background = c; else mark.style.borderTopColor = c;
    };
    paint();
    onTheme(paint);
    return el('span', {}, mark, e.name);
  }));
}

const themeListeners = [];
/** Calls back when colours change: light, dark, print. */
function onTheme(listener) { themeListeners.push(listener); }
function themeChanged() { for (const listener of themeListeners) listener(); }
matchMedia('(prefers-color-scheme: dark)').addEventListener('change', themeChanged);
addEventListener('beforeprint', () => { document.documentElement.dataset.print = 'yes'; themeChanged(); });
addEventListener('afterprint', () => { delete document.documentElement.dataset.print; themeChanged(); });
