// SPDX-License-Identifier: Apache-2.0
// A start and a stop of the motor in time, by the stepper of its FMU. It is computed while nothing else moves.

import {chart} from '../chart.js';
import {el} from '../dom.js';
import {capital, shortName} from '../names.js';
import {displayUnit, engineering, noBreak, percent, rounded} from '../units.js';

import {axisText, drawUpright} from './charts.js';
import {CoreError} from './core.js';
import {boxQuantity, readQuantity} from './quantity.js';
import {longestMotion} from './state.js';

// parameters that one changes for a start and a stop, beside the load torque and the times
const parameterFields = ['voltage', 'frequency', 'rotor_inertia', 'load_inertia', 'off_resistance'];
const ownFields = {
  torque: {name: 'load torque', unit: 'N.m'},
  off: {name: 'switched off at', unit: 's'},
  end: {name: 'computed until', unit: 's'}
};
// steps of one task: some milliseconds
const stepsAtOnce = 300;
// of a motion
const mostRows = 20000;
const mostDrawn = 1200;
const millisecond = 1e-3;

/** The first time at which a rising share of a value is reached, linear between rows; NaN if it is not. */
function timeOf({time, speed}, value) {
  const i = speed.findIndex((v) => (value > 0 ? v >= value : v <= value));
  if (i <= 0 || value === 0) return NaN;
  return time[i - 1] + ((value - speed[i - 1]) / (speed[i] - speed[i - 1])) * (time[i] - time[i - 1]);
}

/** What one asks of a start and a stop. off: number of the row at which the drive is switched off. */
export function motionNumbers(rows, off) {
  const before = rows.speed[off];
  const largest = rows.speed.reduce((most, v) => (Math.abs(v) > Math.abs(most) ? v : most), 0);
  const rest = rows.held.indexOf(1, off);
  return {
    before,
    largest,
    share63: timeOf(rows, (1 - Math.exp(-1)) * before),
    share90: timeOf(rows, 0.9 * before),
    stopTime: rest < 0 ? NaN : rows.time[rest] - rows.time[off],
    stopAngle: rest < 0 ? NaN : rows.angle[rest] - rows.angle[off]
  };
}

export class StartStop {
  /** @param {import('./panel.js').DesignerPanel} panel */
  constructor(panel) {
    this.panel = panel;
    this.word = el('p', {class: 'read', role: 'status'});
    this.facts = el('div', {class: 'facts'});
    this.read = el('div', {class: 'read'});
    this.boxes = {};
    /** @type {any[] | null} */
    this.charts = null;
    this.form =
        el('div', {class: 'tools'}, parameterFields.map((name) => this.field(name, shortName(name))),
           Object.entries(ownFields).map(([name, {name: words}]) => this.field(name, words)));
    this.pair = el('div', {class: 'pair'});
    this.node = el('div', {class: 'motion'}, this.form, this.word, this.facts, this.pair, this.read);
    this.shown = '';
  }

  field(name, words) {
    const box =
        el('input',
           {type: 'text', class: 'exact', autocomplete: 'off', 'aria-label': words, onchange: () => this.typed(name)});
    this.boxes[name] = box;
    return el('label', {}, capital(words) + ' ', box);
  }

  typed(name) {
    const {tables, state} = this.panel;
    const unit = (ownFields[name] ?? tables.parameters[name]).unit;
    const found = readQuantity(tables, this.boxes[name].value, unit, 1);
    const outside = name in {end: 1, off: 1} && !(found.value > 0 && found.value <= longestMotion);
    if (found.error || outside) {
      this.say(
          capital(this.boxes[name].getAttribute('aria-label')) + ': ' + this.boxes[name].value.slice(0, 30) + ' ' +
          (found.error || 'must be above 0 s and at most ' + longestMotion + ' s') + '.');
      return;
    }
    if (!ownFields[name]) {
      this.panel.setValue(name, found.value);
      return;
    }
    state.remember();
    state.view.motion[name] = found.value;
    this.panel.changed = true;
  }

  say(text) { this.word.textContent = text; }

  /** The motor has changed: what is shown is that of the one before, until nothing moves. */
  forget() { this.node.classList.toggle('old', this.key() !== this.shown); }

  key() {
    const {motor, view} = this.panel.state;
    return JSON.stringify([motor, view.motion]);
  }

  showBoxes() {
    const {now, state} = this.panel;
    for (const [name, box] of Object.entries(this.boxes)) {
      const own = ownFields[name];
      const value = own ? state.view.motion[name] : now.values[name];
      const {unit} = own ?? this.panel.tables.parameters[name];
      if (document.activeElement !== box) box.value = Number.isFinite(value) ? boxQuantity(value, unit) : '';
    }
  }

  /** Tasks that follow the motor and then draw it; none if it is drawn already. */
  tasks() {
    const key = this.key();
    if (key === this.shown) return [];
    const {torque, off, end} = this.panel.state.view.motion;
    const run = {key, torque, end, off: Math.min(off, end), rows: null};
    return [() => this.begin(run), () => this.plan(run)];
  }

  begin(run) {
    this.showBoxes();
    this.form.hidden = !Number.isFinite(this.panel.now.values.voltage);
    try {
      const longest = this.panel.core.atRest();
      run.step = Math.max(longest, run.end / mostRows);
      run.rowsAtOnce = Math.ceil((stepsAtOnce * longest) / run.step);
      run.rows = {time: [0], speed: [0], angle: [0], amplitude: [0], held: [1]};
    } catch (error) { this.refuse(run, error); }
  }

  /** Puts the parts of the motion before the tasks that are left. */
  plan(run) {
    if (!run.rows) return;
    const {rowsAtOnce} = run;
    const parts = [];
    const add = (from, to, on) => {
      const count = Math.ceil((to - from) / run.step - 1e-9);
      for (let i = 0; i < count; i += rowsAtOnce) {
        const [first, last] = [i, Math.min(i + rowsAtOnce, count)].map((k) => from + ((to - from) * k) / count);
        parts.push(() => this.follow(run, first, last, on, Math.min(rowsAtOnce, count - i)));
      }
    };
    add(0, run.off, true);
    parts.push(() => {
      run.last = run.rows?.time.length - 1;
    });
    add(run.off, run.end, false);
    this.panel.tasks.unshift(...parts, () => this.show(run));
  }

  follow(run, from, to, on, count) {
    const {rows} = run;
    if (!rows) return;
    try {
      const found = this.panel.core.follow(run.torque, on, to - from, count);
      for (let i = 0; i < count; ++i) {
        rows.time.push(from + ((to - from) * (i + 1)) / count);
        ['speed', 'angle', 'amplitude', 'held'].forEach((name, k) => rows[name].push(found[4 * i + k]));
      }
    } catch (error) { this.refuse(run, error); }
  }

  /** Says why there is no motion, in place of one. */
  refuse(run, error) {
    if (!(error instanceof CoreError)) throw error;
    run.rows = null;
    this.say('No motion: ' + error.message + '.');
    this.facts.replaceChildren();
    this.pair.hidden = true;
    this.finish(run);
  }

  finish(run) {
    this.read.replaceChildren();
    this.shown = run.key;
    this.node.classList.remove('old');
  }

  show(run) {
    if (!run.rows) return;
    this.rows = run.rows;
    this.numbers = motionNumbers(run.rows, run.last);
    this.off = run.off;
    this.say('');
    this.showNumbers();
    this.pair.hidden = false;
    this.draw();
    this.finish(run);
  }

  showNumbers() {
    const n = this.numbers;
    const turned = n.before !== 0;
    const fact = (name, words, text) => el('div', {'data-motion': name}, el('span', {}, words), el('strong', {}, text));
    const time = (name, words, none) => fact(name, words, Number.isFinite(n[name]) ? engineering(n[name], 's') : none);
    const beyond = n.largest / n.before - 1;
    this.facts.replaceChildren(
        fact('before', 'speed reached', engineering(n.before, 'rad/s')), time('share63', 'to 63 % of it', '-'),
        time('share90', 'to 90 %', '-'),
        fact(
            'largest', 'largest speed',
            engineering(n.largest, 'rad/s') + (turned && beyond > 1e-4 ? ' (+' + percent(beyond) + ')' : '')),
        time('stopTime', 'time of the stop', 'not yet at rest'),
        fact('stopAngle', 'angle of the stop', Number.isFinite(n.stopAngle) ? engineering(n.stopAngle, 'rad') : '-'));
  }

  /** Two charts over time, made when there is something to draw. */
  draw() {
    const {rows} = this;
    // more points than places across the chart would be drawn as stairs
    this.every = Math.ceil(rows.time.length / mostDrawn);
    const [time, speed, amplitude] =
        [rows.time, rows.speed, rows.amplitude].map((values) => values.filter((_, i) => i % this.every === 0));
    const of = (name, values, unit) => {
      const shown = displayUnit(values.reduce((most, v) => Math.max(most, Math.abs(v)), 0), unit);
      return {name, values: values.map((v) => v / shown.divisor), label: axisText(name, shown), unit: shown.text};
    };
    this.lines = [of('speed', speed, 'rad/s'), of('amplitude', amplitude, 'm')];
    this.charts ??= this.lines.map((line, k) => this.chart(line, k));
    this.lines.forEach((line, k) => {
      const plot = this.charts[k];
      plot.axes[1].label = line.label;
      plot.setData([time.map((t) => t / millisecond), line.values]);
    });
  }

  chart(line, k) {
    const node = el('div', {});
    this.pair.append(node);
    const range = () => {
      const values = this.lines[k].values;
      const [low, high] = values.reduce(([a, b], v) => [Math.min(a, v), Math.max(b, v)], [0, 0]);
      return [1.05 * low, 1.1 * high || 1];
    };
    return chart(node, [], [{name: line.name, y: [], colour: k ? 'c1' : 'c0'}], {
      name: 'motion ' + line.name,
      height: 220,
      x: {label: 'time [ms]', range: () => [0, this.rows.time[this.rows.time.length - 1] / millisecond]},
      y: {label: line.label, range},
      front: (u) => drawUpright(u, this.off / millisecond),
      onMove: (i) => this.readAt(i)
    });
  }

  readAt(i) {
    if (i === null || i === undefined || !this.rows) return;
    const row = i * this.every;
    this.read.replaceChildren(
        'after ', el('b', {}, engineering(this.rows.time[row], 's')),
        ...this.lines.flatMap(
            (line) => [', ' + line.name + ' ', el('b', {}, rounded(line.values[i]) + noBreak + line.unit)]),
        ', angle ', el('b', {}, engineering(this.rows.angle[row], 'rad')));
  }
}
