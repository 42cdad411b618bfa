// SPDX-License-Identifier: Apache-2.0
// The efficiency of a drive that follows over speed and torque, computed when it is asked for.

import {bandLegend, drawBands} from '../bands.js';
import {chart, drawMarks} from '../chart.js';
import {el} from '../dom.js';
import {pointName} from '../names.js';
import {displayUnit} from '../units.js';

import {axisText} from './charts.js';
import {CoreError} from './core.js';

const mapSpeeds = 30;
const mapTorques = 20;
// points of one task: some milliseconds
const pointsAtOnce = 5;
const mapBands = 9;

export class HeldMap {
  /** @param {import('./hold.js').HoldView} hold */
  constructor(hold) {
    this.hold = hold;
    this.button =
        el('button', {type: 'button', onclick: () => this.begin(), 'data-map': 'draw'}, 'Map of the efficiency');
    this.word = el('p', {class: 'read'});
    this.key = el('div', {});
    this.place = el('div', {});
    this.node = el('div', {class: 'map'}, this.button, this.word, this.key, this.place);
    this.field = null;
    this.plot = null;
    this.ofMotor = '';
  }

  /** Shows the point that is held; the map of another motor, or of what followed before, is pale. */
  follow(key) {
    this.plot?.redraw(false);
    if (key === this.ofMotor) return;
    this.ofMotor = key;
    this.key.classList.add('old');
    this.place.classList.add('old');
    this.word.textContent = this.field ? 'This is the map of the motor before the last change.' : '';
  }

  begin() {
    const {panel} = this.hold;
    const metric = panel.now.modal ? 'overall_efficiency' : 'efficiency';
    const ends = {speed: this.hold.lastSpeed(), torque: panel.metrics.holding_torque.value};
    const values = [];
    const count = mapSpeeds * mapTorques;
    const add = (from) => () => {
      // a look at many motors takes one slice of each
      panel.core.motor(panel.state.motor, {radial_slices: 1});
      for (let k = from; k < Math.min(from + pointsAtOnce, count); ++k)
        values.push(this.valueAt(
            (ends.torque * Math.floor(k / mapSpeeds)) / (mapTorques - 1),
            (ends.speed * ((k % mapSpeeds) + 1)) / mapSpeeds, metric));
      panel.core.motor(panel.state.motor);
      this.word.textContent = 'Computing: ' + Math.round((100 * values.length) / count) + ' %';
    };
    for (let k = 0; k < count; k += pointsAtOnce) panel.tasks.push(add(k));
    panel.tasks.push(() => this.show(values, ends, metric));
    if (panel.waiting === null) panel.nextTask();
  }

  valueAt(torque, speed, metric) {
    try {
      const found = this.hold.at(torque, speed);
      return found.status === 'ok' ? found[metric] : NaN;
    } catch (error) {
      if (error instanceof CoreError) return NaN;
      throw error;
    }
  }

  show(values, ends, metric) {
    this.values = values;
    const most = Math.max(0, ...values.filter(Number.isFinite)) || 1;
    const letter = (v) => (
        Number.isFinite(v) ? String.fromCharCode(97 + Math.min(Math.floor((v / most) * mapBands), mapBands - 1)) : ' ');
    this.ends = ends;
    this.field = {
      x: [ends.speed / mapSpeeds, ends.speed],
      y: [0, ends.torque],
      rows: Array.from(
          {length: mapTorques},
          (_, j) => values.slice(j * mapSpeeds, (j + 1) * mapSpeeds).map((v) => letter(Math.max(v, 0))).join('')),
      levels: Array.from({length: mapBands + 1}, (_, i) => (most * i) / mapBands),
      name: pointName(metric),
      unit: '%'
    };
    this.key.replaceChildren(bandLegend(this.field));
    this.draw();
    for (const part of [this.key, this.place]) part.classList.remove('old');
    this.word.textContent =
        this.hold.panel.state.motor.values.radial_slices === 1 ? '' : 'With one slice of the contact.';
  }

  draw() {
    const [across, up] = [displayUnit(this.ends.speed, 'rad/s'), displayUnit(this.ends.torque, 'N.m')];
    const [x, y] = [this.ends.speed / across.divisor, this.ends.torque / up.divisor];
    this.place.replaceChildren();
    this.plot = chart(this.place, [0, x], [{name: '', y: [NaN, NaN], colour: 'c0'}], {
      name: 'held map',
      height: 300,
      x: {label: axisText('speed', across), range: [0, x]},
      y: {label: axisText('torque', up), range: [0, y]},
      ground: (u) => drawBands(u, this.field, {x: across.divisor, y: up.divisor}),
      front: (u) => {
        const {speed, torque} = this.hold.asked;
        drawMarks(u, [{x: speed / across.divisor, y: torque / up.divisor, colour: 'c1'}]);
      }
    });
  }
}
