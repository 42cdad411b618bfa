// SPDX-License-Identifier: Apache-2.0
// A chart with all that one does with it: legend, reading at the cursor, zoom, picture to save.

import {chart} from './chart.js';
import {colour, el, inLightColours, legend, saveBlob} from './dom.js';

/** "at 80 rpm, torque 1.2 N·m": names with values in bold; those without a value are left out. */
export function readout(node, parts) {
  const told = parts.filter(([, value]) => value);
  node.replaceChildren(...told.flatMap(([name, value], i) => [(i ? ', ' : '') + name + ' ', el('b', {}, value)]));
}

/** Words and signs of a legend on a canvas, from left to right; the width that they take. */
function drawLegend(ctx, entries, x, y, ratio) {
  let at = x;
  for (const entry of entries) {
    ctx.strokeStyle = ctx.fillStyle = colour(entry.colour);
    ctx.lineWidth = (entry.kind === 'broad' ? 10 : 3) * ratio;
    ctx.globalAlpha = entry.kind === 'broad' ? 0.35 : 1;
    ctx.setLineDash(entry.kind === 'dash' ? [5 * ratio, 3 * ratio] : []);
    if (entry.kind === 'area' || entry.kind === 'dot')
      ctx.fillRect(at, y - 5 * ratio, 12 * ratio, 10 * ratio);
    else {
      ctx.beginPath();
      ctx.moveTo(at, y);
      ctx.lineTo(at + 20 * ratio, y);
      ctx.stroke();
    }
    ctx.globalAlpha = 1;
    ctx.fillStyle = colour('ink');
    ctx.fillText(entry.name, at + 26 * ratio, y);
    at += ctx.measureText(entry.name).width + 42 * ratio;
  }
  ctx.setLineDash([]);
}

/** A canvas with its title and legend as a PNG file, in light colours. */
export async function savePicture(canvas, title, entries = []) {
  await inLightColours(() => {
    const ratio = devicePixelRatio;
    const head = (entries.length ? 50 : 30) * ratio;
    const picture = el('canvas', {width: canvas.width, height: canvas.height + head});
    const ctx = picture.getContext('2d');
    ctx.fillStyle = colour('card');
    ctx.fillRect(0, 0, picture.width, picture.height);
    ctx.textBaseline = 'middle';
    ctx.fillStyle = colour('ink');
    ctx.font = 'bold ' + 14 * ratio + 'px system-ui, "Liberation Sans", Arial, sans-serif';
    ctx.fillText(title, 12 * ratio, 16 * ratio);
    ctx.font = 12 * ratio + 'px system-ui, "Liberation Sans", Arial, sans-serif';
    drawLegend(ctx, entries, 12 * ratio, 38 * ratio, ratio);
    ctx.drawImage(canvas, 0, head);
    picture.toBlob((blob) => saveBlob(title + '.png', blob));
  });
}

/** Does what a button asks for, which draws the buttons of a node anew, and leaves the focus on the button. */
export function keepFocus(node, text, work) {
  work();
  [...node.querySelectorAll('button')].find((b) => b.textContent === text)?.focus();
}

/** Buttons that change an axis between linear and logarithmic; change(key, log) draws the figure anew. */
export function logButtons(state, change) {
  return ['x', 'y'].map((key) => {
    const press = () => change(key, !state[key]);
    return el('button', {type: 'button', 'aria-pressed': String(Boolean(state[key])), onclick: press}, 'log ' + key);
  });
}

/**
 * A chart in a node: like chart(), with
 * options: {legend: entries, tell(index): parts for readout(), tellAlways(): the same wherever the cursor is,
 *           buttons: elements, title: of the picture}
 */
export function figure(node, x, series, options) {
  const read = el('div', {class: 'read', 'aria-live': 'polite'});
  const whole = el('button', {type: 'button', hidden: '', onclick: () => plot.zoom.reset(plot)}, 'Whole range');
  const title = options.title ?? options.name;
  const picture = () => savePicture(plot.ctx.canvas, title, options.legend ?? []);
  const tools =
      el('div', {class: 'figure-tools'}, options.buttons ?? [], whole,
         el('button', {type: 'button', onclick: picture}, 'Save picture'));
  const body = el('div', {class: 'figure-body'});
  node.append(
      el('div', {class: 'figure'},
         el('div', {class: 'figure-head'}, options.legend ? legend(options.legend) : el('span', {}), tools), body));
  const onMove = (i, u) => {
    options.onMove?.(i, u);
    readout(read, options.tellAlways ? options.tellAlways() : i === null || !options.tell ? [] : options.tell(i));
    read.classList.toggle('left', u.cursor.left > u.over.clientWidth / 2);
  };
  const zoom = options.onSelect ? false : (u) => {
    whole.hidden = !u.zoom.on();
  };
  const onKey = options.onKey && ((u, event) => {
                  options.onKey(u, event);
                  if (options.tellAlways) readout(read, options.tellAlways());
                });
  const plot = chart(body, x, series, {...options, zoom, onMove, onKey});
  body.append(read);
  return plot;
}
