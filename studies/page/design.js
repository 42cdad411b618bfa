// SPDX-License-Identifier: Apache-2.0
// One design of a sweep: its numbers and its small torque-speed curve.

import {numbers} from './bytes.js';
import {data, rowNumber, rows} from './data.js';
import {designerButton} from './designer/inside.js';
import {colour, el, svg} from './dom.js';
import {describe} from './table.js';
import {displayUnit, engineering, rounded} from './units.js';
import {plain} from './words.js';

function smallCurves() {
  const c = data.row_curves;
  return {
    every: c.every,
    points: c.points,
    speed: numbers(c.speed, Float32Array),
    torque: numbers(c.torque, Float32Array),
    shape: numbers(c.shape, Uint16Array)
  };
}

/** What one design is, with its curve. */
export class DesignView {
  constructor(node, columns) {
    this.columns = columns;
    this.curves = smallCurves();
    this.body = el('div', {'data-design': ''}, el('p', {}, 'Point at a design.'));
    this.plotNode = el('div', {});
    node.append(this.body, this.plotNode);
  }

  /** note: what else to say of it. */
  show(i, note = '') {
    if (i < 0) return;
    const lines = this.columns.map(
        (c) =>
            el('tr', {}, el('td', {title: describe(c.name)}, plain(c.name)),
               el('td', {}, engineering(c.values[i], c.unit))));
    const status = rows.statuses[rows.status[i]];
    this.body.replaceChildren(
        el('p', {}, 'Design ' + rowNumber(i) + (status === 'ok' ? '' : ': ' + status) + note),
        el('table', {}, el('tbody', {}, lines)));
    const explore =
        designerButton(Object.fromEntries(this.columns.map((c) => [c.name, c.values[i]])), 'design ' + rowNumber(i));
    if (explore) this.body.append(explore);
    this.curve(i);
  }

  curve(i) {
    const c = this.curves;
    const at = Math.floor(i / c.every);
    const say = (text) => this.plotNode.replaceChildren(el('p', {class: 'read'}, text));
    if (i % c.every !== 0) return say('The page has curves of one design in ' + c.every * rows.every + '.');
    if (!Number.isFinite(c.speed[at])) return say('This design has no torque-speed curve.');
    const shape = c.shape.slice(at * c.points, (at + 1) * c.points);
    const width = Math.max(this.plotNode.clientWidth, 200);
    return this.plotNode.replaceChildren(smallPlot(shape, c.speed[at], c.torque[at], width));
  }
}

/** A curve from its shape (65535: the largest torque [N m]) over equal steps up to the last speed [rad/s]. */
function smallPlot(shape, lastSpeed, torque, width) {
  const [pad, height] = [46, 170];
  const unit = displayUnit(torque, 'N.m');
  const across = (k) => pad + (k / (shape.length - 1)) * (width - pad - 14);
  const up = (share) => height - 36 - (share / 1.08) * (height - 50);
  const step = (s, k) => (k ? 'L' : 'M') + across(k).toFixed(1) + ' ' + up(s / 65535).toFixed(1);
  const word = (text, attributes) => {
    const node = svg('text', {'font-size': 12, fill: 'currentColor', ...attributes});
    node.append(text);
    return node;
  };
  const first = shape[0] / 65535;
  const frame =
      {d: 'M' + pad + ' 8V' + up(0) + 'H' + (width - 14), fill: 'none', stroke: 'currentColor', 'stroke-opacity': 0.4};
  return svg(
      'svg', {
        width,
        height,
        viewBox: '0 0 ' + width + ' ' + height,
        style: 'max-width: 100%',
        role: 'img',
        'aria-label': 'torque-speed curve of this design'
      },
      svg('path', frame),
      svg('path', {d: Array.from(shape, step).join(''), fill: 'none', stroke: colour('c0'), 'stroke-width': 2}),
      word(rounded((first * torque) / unit.divisor, 3) + ' ' + unit.text, {x: pad + 6, y: up(first) - 6}),
      word(
          'torque [' + unit.text + ']',
          {transform: 'rotate(-90)', x: -(height - 36) / 2, y: 14, 'text-anchor': 'middle'}),
      word(engineering(lastSpeed, 'rad/s'), {x: width - 14, y: height - 22, 'text-anchor': 'end'}),
      word('speed [rpm]', {x: (pad + width) / 2, y: height - 4, 'text-anchor': 'middle'}));
}
