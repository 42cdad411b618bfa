// SPDX-License-Identifier: Apache-2.0
// The front: the point that one chooses, and where it stands in every picture.

import {data, summary} from './data.js';
import {designerButton} from './designer/inside.js';
import {card, colour, el} from './dom.js';
import {keepFocus, logButtons} from './figure.js';
import {Filter} from './filter.js';
import {savedMotor} from './motor.js';
import {parallelChart} from './parallel.js';
import {draw, numbersAt, saidNodes, seriesOfChart, toldTable} from './telling.js';

/** A ring about the point chosen. */
function ringAbout(u, x, y) {
  u.ctx.save();
  u.ctx.beginPath();
  u.ctx.arc(u.valToPos(x, 'x', true), u.valToPos(y, 'y', true), 9 * devicePixelRatio, 0, 2 * Math.PI);
  u.ctx.lineWidth = 2.5 * devicePixelRatio;
  u.ctx.strokeStyle = colour('c1');
  u.ctx.stroke();
  u.ctx.restore();
}

/** Two goals of the front; a click, or Enter, chooses the point under the cursor. */
class FrontChart {
  constructor(node, chart, front) {
    const [{x, y}] = seriesOfChart(chart);
    this.order = [...x.keys()].sort((i, j) => x[i] - x[j]);
    this.positive = Math.min(...x, ...y) > 0;
    this.chart = chart;
    this.front = front;
    this.log = {x: false, y: false};
    this.under = null;
    this.holder = el('div', {});
    node.append(this.holder);
    this.build();
  }

  build() {
    const {order, front, holder} = this;
    const toggle = (key, log) => {
      this.log[key] = log;
      keepFocus(holder, 'log ' + key, () => this.build());
    };
    holder.replaceChildren();
    this.plot = draw(holder, this.chart, {
      log: this.log,
      height: 380,
      buttons: this.positive ? logButtons(this.log, toggle) : [],
      front: (u) => {
        const at = order.indexOf(front.point);
        if (at >= 0) ringAbout(u, u.data[0][at], u.data[1][at]);
      },
      onMove: (i) => {
        this.under = i;
      }
    });
    const pick = () => {
      if (this.under !== null) front.choose(order[this.under]);
    };
    this.plot.over.addEventListener('click', pick);
    this.plot.root.parentNode.addEventListener('keydown', (e) => {
      if (e.key === 'Enter') pick();
    });
  }
}

/** What a page adds to the sections of a front. */
class Front {
  constructor() {
    this.point = null;
    this.charts = [];
    this.node = null;
  }

  trade(node, section) {
    node.append(el('p', {}, 'Click a point, or press Enter on it, to see its motor; drag to zoom.'));
    for (const chart of section.charts) this.charts.push(new FrontChart(node, chart, this));
  }

  place() {
    this.node = card('Chosen point', null, 'wide');
    this.node.id = 'chosen';
  }

  along(node, {parallel}) {
    node.append(el('p', {}, 'Drag along an axis to select points; Escape shows all.'));
    const columns = parallel.axes.map(({values}) => ({values: numbersAt(values)}));
    this.lines = parallelChart(node, parallel, new Filter(columns, summary.front.length), (i) => this.choose(i));
    this.choose(summary.knee ?? 0);
  }

  choose(i) {
    this.point = i;
    for (const c of this.charts) c.plot.redraw(false);
    this.show(i);
    this.lines.choose(i);
  }

  /** What is said of the point, its curve and its motor file. */
  show(i) {
    const {sections: [head, metrics, ...limits]} = data.points[i];
    const [left, right] = [el('div', {}), el('div', {})];
    this.node.replaceChildren(
        el('h2', {}, head.heading), ...saidNodes(head),
        savedMotor(data.files[i], designerButton(summary.front[i].design, 'point ' + (i + 1))),
        el('div', {class: 'pair'}, left, right));
    for (const chart of head.charts) draw(left, chart, {height: 300});
    left.append(...head.tables.map(toldTable));
    right.append(...metrics.tables.map(toldTable), el('p', {class: 'soft'}, metrics.note));
    for (const part of limits)
      this.node.append(el('h3', {}, part.heading), el('p', {}, part.note), ...part.tables.map(toldTable));
  }
}

/** The hooks of a front. */
export function frontHooks() {
  const front = new Front();
  const choose = Object.assign((node, section) => front.trade(node, section), {draws: true});
  return {choose, chosen: () => front.place(), along: (node, section) => front.along(node, section)};
}
