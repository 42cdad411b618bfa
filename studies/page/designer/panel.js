// SPDX-License-Identifier: Apache-2.0
// The panel: what a person moves goes to the core, and what the core says is drawn, once a frame.

import {keyStep} from '../chart.js';
import {el} from '../dom.js';
import {capital, shortName} from '../names.js';
import {engineering, percent} from '../units.js';
import {contactKey} from '../zones.js';

import {ParameterRow, partTitles, Tiles} from './controls.js';
import {CoreError} from './core.js';
import {HoldView} from './hold.js';
import {LeftOut} from './left_out.js';
import {LimitsEditor, meetingPoint, showBroken, solveLock} from './limits.js';
import {motorCharts} from './motor_charts.js';
import {SectionView} from './section.js';
import {StartStop} from './start_stop.js';
import {DesignState} from './state.js';
import {designerTools, stepKeys} from './tools.js';
import {FieldsView, WaveView} from './wave.js';

const curvePoints = 161;
const quickPoints = 61;  // of a motor that takes longer than a frame, until there is time for more
// [ms] a curve of all slices that takes longer comes with fewer points first
const slowCurve = 50;
let panels = 0;
// [ms] that a slider which is held stands still before the rest is computed
const restDelay = 40;

export class DesignerPanel {
  /**
   * @param {HTMLElement} node
   * @param {any} tables  parameters, metrics, reasons, units, materials, charts of the contact
   * @param {import('./core.js').Core} core
   * @param {import('./state.js').StatedMotor} motor
   */
  // the address is the whole page's, which a report shares
  constructor(node, tables, core, motor, inAddress = false) {
    this.id = String(++panels);
    this.tables = tables;
    this.core = core;
    this.inAddress = inAddress;
    this.state = new DesignState(motor);
    this.rows = {};
    this.tasks = [];
    /** @type {{speed: number, torque: number}[] | null} */
    this.measured = null;
    this.changed = true;
    this.moved = true;
    this.playing = !matchMedia('(prefers-reduced-motion: reduce)').matches;
    this.times = {compute: 0, frame: 0, whole: 0};
    if (inAddress) this.state.fromHash(location.hash, core, tables);
    this.build(node);
    requestAnimationFrame((now) => this.frame(now));
  }

  build(node) {
    this.node = node;
    this.say = el('p', {class: 'say', role: 'status'});
    this.title = el(this.inAddress ? 'h1' : 'h2', {});
    this.sliders = el('div', {});
    const [tiles, torque, power, efficiency, wave, traction, velocity, section] =
        Array.from({length: 8}, () => el('div', {}));
    this.tiles = new Tiles(el('div', {class: 'facts'}), this);
    this.fieldsTitle = el('p', {class: 'read', 'data-fields': 'title'});
    this.leftOut = new LeftOut(this.state.opened, this.tables.left_out);
    tiles.append(this.leftOut.without, this.tiles.node, this.leftOut.facts);
    this.limits = new LimitsEditor(this);
    this.startStop = new StartStop(this);
    this.hold = new HoldView(this);
    const level = this.inAddress ? 'h2' : 'h3';
    const panelCard = (title, width, ...children) =>
        el('section', {class: 'card ' + width}, title ? el(level, {}, title) : null, ...children);
    node.append(
        el('header', {}, this.title, designerTools(this), this.say),
        el('div', {class: 'left'}, panelCard('Motor', '', this.goalChoice(), this.sliders)),
        el('div', {class: 'right'}, panelCard(null, 'numbers', tiles), panelCard(null, 'chief', torque),
           el('div', {class: 'pair'}, panelCard(null, '', power), panelCard(null, '', efficiency)),
           panelCard(
               'In the contact', '', this.fieldsTitle, wave, contactKey(this.tables.contact.slice(1)),
               el('div', {class: 'pair'}, traction, velocity)),
           panelCard('Load, limits and a constant metric', '', this.limits.node),
           panelCard('Drive adjusted to a load', '', this.hold.node),
           panelCard('Start and stop', '', this.startStop.node), panelCard('Cross-section', '', section)));
    this.buildCharts(torque, power, efficiency, wave, traction, velocity, section);
    node.addEventListener('keydown', (event) => stepKeys(this, event));
  }

  buildCharts(torque, power, efficiency, wave, traction, velocity, section) {
    const {charts, squeals, ofTerminals} = motorCharts(this, torque, power, efficiency);
    this.charts = charts;
    this.squeals = squeals;
    this.ofTerminals = ofTerminals;
    this.wave = new WaveView(wave);
    this.fields = new FieldsView([traction, velocity], this.tables.contact);
    this.section = new SectionView(section);
    this.limits.show(this.state.view);
  }

  goalChoice() {
    this.goal = el('select', {
      'aria-label': 'metric of the effects',
      onchange: () => {
        this.state.remember();
        this.state.view.goal = this.goal.value;
        this.changed = true;
      }
    });
    return el('label', {class: 'goal'}, 'Effect of 1 % more on ', this.goal);
  }

  // What a person does.

  setValue(name, value, moving = null) {
    if (!Number.isFinite(value)) return;
    this.state.remember(moving);
    if (moving) this.dragging = true;
    this.state.set(name, value, this.tables.parameters[name].alternative);
    this.changed = true;
  }

  /** A slider has come to rest. */
  settled() {
    this.dragging = false;
    this.state.settle();
    this.changed = true;
  }

  /** Gives the other of two parameters of which a motor has one, with the value that it has now. */
  swapAlternative(name, alternative) {
    const value = this.now?.values[alternative];
    if (!Number.isFinite(value)) {
      this.tell(
          capital(shortName(alternative)) +
              ' has no value here: the motor file must give the modal data of the stator.',
          true);
      return;
    }
    this.setValue(alternative, value);
    delete this.state.motor.values[name];
  }

  setSpeed(speed) {
    this.state.view.speed = Math.min(Math.max(speed, 0), this.now ? this.now.last_speed : speed);
    this.moved = true;
  }

  /** Arrow keys, Home and End on a chart move the speed. */
  speedKey(event) {
    if (!this.now) return;
    const count = 201;
    const at = Math.round((this.state.view.speed / this.now.last_speed) * (count - 1));
    const next = keyStep(event, at, count);
    if (next !== null) this.setSpeed((next / (count - 1)) * this.now.last_speed);
  }

  stepTo(which) {
    if (!this.state[which]()) return;
    this.limits.show(this.state.view);
    this.changed = true;
  }

  openMotor(motor) {
    this.state.open(motor);
    for (const row of Object.values(this.rows)) row.range = null;
    this.changed = true;
  }

  pin() {
    this.pinned = this.pinned ? null : {curve: this.curve, metrics: this.metrics};
    this.changed = true;
    return Boolean(this.pinned);
  }

  tell(text, bad = false) {
    if (this.say.textContent !== text) this.say.textContent = text;
    this.say.classList.toggle('bad', bad);
  }

  // A frame.

  frame(now) {
    const begin = performance.now();
    const seconds = Math.min(0.05, (now - (this.last ?? now)) / 1000);
    this.last = now;
    const [changed, moved] = [this.changed, this.moved];
    this.changed = this.moved = false;
    if (changed) this.recompute();
    if (changed || moved) this.showFields();
    if (this.playing || changed || moved) this.wave.draw(this.playing ? seconds : 0);
    if (changed || moved) this.times.frame = performance.now() - begin;
    requestAnimationFrame((next) => this.frame(next));
  }

  /** Everything that follows from the motor at once; what takes longer waits until nothing moves. */
  recompute() {
    clearTimeout(this.waiting);
    this.tasks = [];
    this.startStop.forget();
    try {
      const begin = performance.now();
      this.compute(this.dragging || this.state.motor.values.radial_slices !== 1);
      this.times.compute = performance.now() - begin;
      this.node.classList.remove('stale');
    } catch (error) {
      if (!(error instanceof CoreError)) throw error;
      this.now = null;
      this.waiting = null;
      this.node.classList.add('stale');
      this.tell(error.message.replaceAll('\n', '; '), true);
      this.showControls();
      return;
    }
    this.showControls();
    this.waiting = setTimeout(() => this.rest(), this.dragging ? restDelay : 0);
  }

  /** @param {boolean} moving  then one slice stands for all, and what takes a search is left out */
  compute(moving) {
    this.computeCurve(moving, moving && this.times.compute > 10 ? quickPoints : curvePoints);
    this.computeMetrics(moving);
  }

  computeCurve(moving, points) {
    const {motor, view} = this.state;
    this.sketch = moving && motor.values.radial_slices !== 1;
    const slices = this.sketch ? {radial_slices: 1} : {};
    if (view.lock) solveLock(this, slices);
    this.now = this.core.motor(motor, slices);
    this.squeals.forget();
    this.drawCurve(points);
  }

  drawCurve(points) {
    const {view} = this.state;
    this.curve = this.core.curve(points, this.now.last_speed);
    this.meeting = meetingPoint(this.core, this.curve, view.load);
    for (const one of this.charts) one.show(this.curve, this.pinned?.curve);
  }

  computeMetrics(moving) {
    const {view} = this.state;
    this.metrics = {...(moving ? this.metrics : {}), ...this.evaluate(this.metricList(moving))};
    if (!(view.speed <= this.now.last_speed)) view.speed = this.usualSpeed();
    this.tiles.show(this.metrics, this.pinned?.metrics);
    this.hold.show();
  }

  /** At peak power a contact does everything it can. */
  usualSpeed() {
    const peak = this.metrics.speed_at_peak_power?.value;
    return peak > 0 ? peak : 0.6 * this.now.last_speed;
  }

  /** The metrics that this motor has; while it moves those that take no search over voltages and frequencies. */
  metricList(moving) {
    const {values, inner_edge} = this.state.motor;
    return Object.entries(this.tables.metrics)
        .filter(
            ([name, m]) => m.argument === 'none' && (!m.modes || this.now.modal) && (!m.geometry || inner_edge) &&
                !m.absent &&
                (values.voltage !== undefined ||
                 !['pull_out_torque', 'start_frequency', 'pull_out_frequency'].includes(name)) &&
                !(moving && (m.modes || m.geometry)))
        .map(([name]) => name);
  }

  evaluate(names) {
    const found = this.core.metrics(names.map((metric) => ({metric})));
    return Object.fromEntries(names.map((name, i) => [name, found[i]]));
  }

  /**
   * Nothing moves: what was left out, derivatives, limits, notes, and where each slider breaks a limit; a move ends
   * it.
   */
  rest() {
    const whole = this.sketch || this.dragging;
    const rows = Object.values(this.rows).filter((row) => !row.node.hidden);
    // of the last time
    const slow = this.times.whole > slowCurve;
    this.tasks = [
      () => {
        if (whole) this.showWhole(slow ? quickPoints : curvePoints);
        // a pause between the two would be a frame
        this.showEffects();
      },
      ...(whole ? [() => this.computeMetrics(false), ...(slow ? [() => this.drawCurve(curvePoints)] : [])] : []),
      () => this.limits.judge(),
      () => this.showNotes(),
      ...this.squeals.tasks(),
      ...this.startStop.tasks(),
      ...rows.map((row) => () => showBroken(this, row)),
    ];
    if (this.inAddress) history.replaceState(null, '', this.state.toHash());
    this.nextTask();
  }

  /** The curve and the fields of all slices. */
  showWhole(points) {
    const begin = performance.now();
    this.computeCurve(false, points);
    this.times.whole = (performance.now() - begin) * (curvePoints / points);
    this.showControls();
    this.showFields();
  }

  /** Tasks for half a frame, then a pause in which a slider may be moved: a timer of its own for each takes 4 ms. */
  nextTask() {
    const begin = performance.now();
    this.waiting = null;
    try {
      while (this.tasks.length && performance.now() - begin < 8) this.tasks.shift()();
    } catch (error) {
      if (!(error instanceof CoreError)) throw error;
      this.tasks = [];
      this.tell(error.message, true);
    }
    if (this.tasks.length && !this.changed) this.waiting = setTimeout(() => this.nextTask(), 0);
  }

  showNotes() { this.tell(this.core.notes(true).map((note) => 'Note: ' + note + '.').join(' ')); }

  showEffects() {
    const {goal} = this.state.view;
    const [found] = this.core.gradients([{metric: goal}]);
    for (const [name, row] of Object.entries(this.rows))
      row.showEffect((found.gradient[this.core.places[name]] * this.now.values[name]) / found.value, goal);
  }

  // What is shown besides the charts.

  showControls() {
    const {motor, view} = this.state;
    this.title.replaceChildren(motor.name || 'motor', el('small', {}, ' designer'));
    if (this.inAddress) document.title = (motor.name || 'motor') + ' - twum designer';
    for (const entry of this.ofTerminals) entry.hidden = !this.now?.modal;
    this.leftOut.show(motor);
    this.placeRows();
    for (const [name, row] of Object.entries(this.rows))
      if (!row.node.hidden) row.show(motor.values[name], Boolean(this.now?.modal));
    this.showGoals(view.goal);
    this.section.show(motor);
    this.node.dataset.sketch = this.sketch ? 'yes' : 'no';
  }

  /** One row for each parameter that the motor states. */
  placeRows() {
    const {values} = this.state.motor;
    // a load or a driver that is none needs no slider
    const none = (name) => values[name] === 0 && /^(load|driver)\./.test(this.tables.parameters[name].entry);
    const used = (name) => (name === 'radial_slices' || !this.now || this.now.used[name] || this.sketch) && !none(name);
    const wanted = Object.keys(this.tables.parameters).filter((name) => values[name] !== undefined && used(name));
    if (wanted.join() === this.placed) return;
    this.placed = wanted.join();
    for (const row of Object.values(this.rows)) row.node.hidden = true;
    const parts = {};
    for (const name of wanted) {
      const row = (this.rows[name] ??= new ParameterRow(name, this.tables.parameters[name], this));
      row.node.hidden = false;
      const {entry} = this.tables.parameters[name];
      (parts[entry.startsWith('stator.geometry') ? 'geometry' : entry.split('.')[0]] ??= []).push(row.node);
    }
    this.sliders.replaceChildren(...Object.entries(parts).map(
        ([part, nodes]) =>
            el('details', part === 'geometry' ? {} : {open: ''},
               el('summary', {}, partTitles[part] ?? 'Geometry of the stator'), ...nodes)));
  }

  showGoals(goal) {
    const names = this.now ? this.metricList(false) : [];
    if (names.length && names.join() !== this.goals) {
      this.goals = names.join();
      this.goal.replaceChildren(...names.map((name) => el('option', {value: name}, shortName(name))));
    }
    this.goal.value = goal;
  }

  showFields() {
    if (!this.now) return;
    const {speed} = this.state.view;
    const fields = this.core.fields(speed, 361);
    const half = fields.zones.length ?
        Math.max(...fields.zones.flatMap(([, from, to]) => [Math.abs(from), Math.abs(to)])) :
        this.now.half_angle;
    this.wave.show({zones: fields.zones, half, slip: speed / (this.now.crest_speed || 1)});
    this.fields.show(fields, half, this.now.values.static_friction || 1);
    const {point} = fields;
    const words = point.status === 'ok' ?
        [
          engineering(point.torque, 'N.m'), engineering(point.output_power, 'W'),
          'sticks over ' + percent(point.stick_fraction) + ' of its length'
        ] :
        [this.tables.reasons[point.status] ?? point.status];
    this.fieldsTitle.replaceChildren(
        'at ', el('b', {}, engineering(speed, 'rad/s')),
        ': ' + words.join(', ') + (this.sketch ? ' (one slice while the slider moves)' : ''));
    for (const one of this.charts) one.plot.redraw(false);
  }
}
