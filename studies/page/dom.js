// SPDX-License-Identifier: Apache-2.0
// Elements of the page. Text from files enters as text nodes only, never as markup.

/** An element with attributes and children; strings become text. */
export function el(tag, attributes = {}, ...children) {
  const node = document.createElement(tag);
  for (const [name, value] of Object.entries(attributes)) {
    if (name.startsWith('on'))
      node.addEventListener(name.slice(2), value);
    else if (value !== null && value !== undefined)
      node.setAttribute(name, value);
  }
  node.append(...children.flat().filter((c) => c !== null && c !== undefined));
  return node;
}

export function svg(tag, attributes, ...children) {
  const node = document.createElementNS('http://www.w3.org/2000/svg', tag);
  for (const [name, value] of Object.entries(attributes)) {
    if (name === 'style')
      node.style.cssText = value;  // as an attribute the page's policy refuses it
    else
      node.setAttribute(name, value);
  }
  node.append(...children);
  return node;
}

export function bold(text) { return el('b', {}, text); }
export function sentence(...parts) { return el('p', {}, ...parts); }

/** A list of lines, each of words and nodes. */
export function bullets(lines) { return el('ul', {class: 'holders'}, lines.map((line) => el('li', {}, line))); }

/** A card of the page. */
export function card(title, note, width, ...children) {
  const node =
      el('section', {class: 'card ' + width}, title ? el('h2', {}, title) : null, note ? el('p', {}, note) : null,
         ...children);
  document.getElementById('page').append(node);
  return node;
}

/** A style's colour, as the theme of the moment has it. */
export function colour(name) { return getComputedStyle(document.documentElement).getPropertyValue('--' + name).trim(); }

export function isDark() {
  return matchMedia('(prefers-color-scheme: dark)').matches && !document.documentElement.dataset.print;
}

export const seriesColours = ['c0', 'c1', 'c2', 'c3', 'c4', 'c5', 'c6'];

/** The first five colours are apart for every eye; what follows is dashed besides. */
export function seriesDash(i) { return i >= 5 ? [7, 4] : undefined; }
/** Offers bytes as a file. */
export function saveBlob(name, blob) {
  const url = URL.createObjectURL(blob);
  el('a', {href: url, download: name}).click();
  setTimeout(() => URL.revokeObjectURL(url), 1000);
}

/** Offers a text as a file. */
export function save(name, text, type = 'text/csv') { saveBlob(name, new Blob([text], {type})); }

/** entries: [{name, colour, kind: 'dot', 'area', 'dash' or a line}] */
export function legend(entries) {
  return el('div', {class: 'legend'}, entries.map((e) => {
    const mark = el('i', {class: e.kind || ''});
    const filled = e.kind === 'dot' || e.kind === 'area';
    mark.style[filled ? 'background' : 'borderTopColor'] = 'var(--' + e.colour + ')';
    return el('span', {}, mark, e.name);
  }));
}

const themeListeners = [];
/** Calls back when colours change: light, dark, print. */
export function onTheme(listener) { themeListeners.push(listener); }
function themeChanged() {
  for (const listener of themeListeners) listener();
}
matchMedia('(prefers-color-scheme: dark)').addEventListener('change', themeChanged);
function printColours(on) {
  if (on)
    document.documentElement.dataset.print = 'yes';
  else
    delete document.documentElement.dataset.print;
  themeChanged();
}
addEventListener('beforeprint', () => printColours(true));
addEventListener('afterprint', () => printColours(false));

/** Does something while the page is drawn in light colours. */
export async function inLightColours(work) {
  const dark = isDark();
  if (dark) printColours(true);
  await Promise.resolve();  // charts draw when what is under way is done
  work();
  if (dark) printColours(false);
}
