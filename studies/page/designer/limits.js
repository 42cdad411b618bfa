// SPDX-License-Identifier: Apache-2.0
// The load, limits, and a metric that is kept constant by adjusting one parameter.

import {el, save} from '../dom.js';
import {capital, pointName, shortName} from '../names.js';
import {engineering, noBreak, rpm} from '../units.js';

import {sliderSteps} from './controls.js';
import {CoreError} from './core.js';
import {studyYaml} from './motor.js';
import {readQuantity, typedQuantity} from './quantity.js';

const bandPlaces = 24;
// [ms]
const longTask = 200;

/** Where motor and load meet, at the highest speed: there the motor runs. Null if they do not. */
export function meetingPoint(core, curve, load) {
  if (!(load.rest || load.rise)) return null;
  const excess = (speed, torque) => torque - load.rest - load.rise * speed;
  for (let i = curve.speed.length - 1; i > 0; --i) {
    const [left, right] = [i - 1, i].map((k) => excess(curve.speed[k], curve.torque[k]));
    if (left >= 0 && right < 0) return meetingBetween(core, load, curve.speed[i - 1], curve.speed[i]);
  }
  return null;
}

/** Halves the stretch in which the torque falls below the load. */
function meetingBetween(core, load, low, high) {
  let torque = NaN;
  for (let i = 0; i < 40; ++i) {
    const speed = 0.5 * (low + high);
    torque = core.metrics([{metric: 'torque_at', argument: 'speed', at: speed}])[0].value;
    if (torque >= load.rest + load.rise * speed)
      low = speed;
    else
      high = speed;
  }
  return {speed: low, torque};
}

function isBroken(limit, {value, status}) {
  return status !== 'ok' || (limit.sense === '>=' ? value < limit.value : value > limit.value);
}

function limitRequest(limit) { return {metric: limit.metric, argument: limit.argument, at: limit.at}; }

/** Whether a limit is broken, or no motor exists, where this parameter has another value. */
function breaksLimit(panel, name, value) {
  const {limits} = panel.state.view;
  try {
    panel.core.motor(panel.state.motor, {...oneSlice(panel), ...panel.state.changes(name, value)});
    return panel.core.metrics(limits.map(limitRequest)).some((found, k) => isBroken(limits[k], found));
  } catch (error) {
    if (error instanceof CoreError) return true;
    throw error;
  }
}

/**
 * Paints along a slider where a limit is broken; nothing where a look takes so long that the page would stop for it.
 */
export function showBroken(panel, row) {
  const broken = [];
  const begin = performance.now();
  while (panel.state.view.limits.length && broken.length < bandPlaces && performance.now() - begin < longTask)
    broken.push(breaksLimit(panel, row.name, row.fromSlider((sliderSteps * (broken.length + 0.5)) / bandPlaces)));
  row.showBands(broken.length === bandPlaces ? broken : []);
  // the motor that is shown is asked next
  if (broken.length) panel.core.motor(panel.state.motor);
}

/** A look at many motors takes one slice of each. */
function oneSlice(panel) { return panel.state.motor.values.radial_slices === 1 ? {} : {radial_slices: 1}; }

/** Moves the parameter that gives way until the locked metric has its value again. */
export function solveLock(panel, slices) {
  const {lock} = panel.state.view;
  const {values} = panel.state.motor;
  const start = values[lock.parameter];
  const place = panel.core.places[lock.parameter];
  let value = start;
  for (let i = 0; i < 40; ++i) {
    panel.core.motor(panel.state.motor, {...slices, ...panel.state.changes(lock.parameter, value)});
    const [found] = panel.core.gradients([{metric: lock.metric}]);
    if (found.status !== 'ok') break;
    if (Math.abs(found.value - lock.value) <= 1e-9 * Math.abs(lock.value)) {
      Object.assign(values, panel.state.changes(lock.parameter, value));
      return;
    }
    const step = (lock.value - found.value) / found.gradient[place];
    if (!Number.isFinite(step)) break;
    value += Math.sign(step) * Math.min(Math.abs(step), 0.3 * Math.abs(value) || Math.abs(step));
  }
  throw new CoreError(
      'no ' + shortName(lock.parameter) + ' near this one gives ' + shortName(lock.metric) + ' = ' +
      engineering(lock.value, panel.tables.metrics[lock.metric].unit) + '; go back, or release the metric');
}

export class LimitsEditor {
  constructor(panel) {
    this.panel = panel;
    this.error = el('p', {class: 'wrong', role: 'alert'});
    this.list = el('ul', {class: 'limits'});
    this.node = el('div', {}, this.loadRow(), this.limitRow(), this.list, this.lockRow(), this.studyRow(), this.error);
  }

  text(label, wide) {
    return el('input', {type: 'text', class: wide ? 'exact wide' : 'exact', 'aria-label': label, autocomplete: 'off'});
  }

  /** A quantity that was typed, or null after saying what is wrong with it. */
  quantity(field, unit, bare) {
    const found = readQuantity(this.panel.tables, field.value, unit, bare);
    this.error.textContent =
        found.error ? field.getAttribute('aria-label') + ': ' + field.value.slice(0, 30) + ' ' + found.error : '';
    return found.error ? null : found.value;
  }

  act(change) {
    this.panel.state.remember();
    change(this.panel.state.view);
    this.show(this.panel.state.view);
    this.panel.changed = true;
  }

  loadRow() {
    this.atRest = this.text('load torque at rest');
    this.at100 = this.text('load torque at 100 rpm');
    const take = () => {
      const [rest, fast] = [this.quantity(this.atRest, 'N.m', 1), this.quantity(this.at100, 'N.m', 1)];
      if (rest !== null && fast !== null)
        this.act((view) => {
          view.load = {rest, rise: (fast - rest) / (100 * rpm)};
        });
    };
    for (const field of [this.atRest, this.at100]) field.addEventListener('change', take);
    return el(
        'div', {class: 'tools'}, el('label', {}, 'Load at rest ', this.atRest),
        el('label', {}, 'at 100 rpm ', this.at100), this.meets = el('span', {class: 'read'}));
  }

  limitRow() {
    const {metrics} = this.panel.tables;
    this.metric =
        el('select', {'aria-label': 'metric of a new limit'},
           Object.keys(metrics)
               .filter((name) => metrics[name].argument !== 'both' && !metrics[name].absent)
               .map((name) => el('option', {value: name}, shortName(name))));
    this.at = this.text('speed or torque at which the limit holds');
    this.sense =
        el('select', {'aria-label': 'sense of a new limit'}, el('option', {value: '>='}, 'at least'),
           el('option', {value: '<='}, 'at most'));
    this.value = this.text('value of a new limit');
    const where = el('label', {}, 'at ', this.at);
    const follow = () => {
      where.hidden = metrics[this.metric.value].argument === 'none';
      this.value.placeholder = typedQuantity(1, metrics[this.metric.value].unit);
    };
    this.metric.addEventListener('change', follow);
    this.metric.value = 'stall_torque';
    follow();
    this.at.placeholder = '100 rpm';
    return el(
        'div', {class: 'tools'}, el('label', {}, 'Limit ', this.metric), where, this.sense, this.value,
        el('button', {type: 'button', onclick: () => this.addLimit()}, 'Add limit'));
  }

  addLimit() {
    const metric = this.metric.value;
    const {unit, argument} = this.panel.tables.metrics[metric];
    const where = this.argument(argument);
    const value = where && this.quantity(this.value, unit, unit === '1' ? 1 : undefined);
    if (!where || value === null) return;
    this.act((view) => view.limits.push({metric, ...where, sense: this.sense.value, value}));
    this.value.value = '';
  }

  /** The speed or torque of a point metric; null after saying what is wrong. */
  argument(kind) {
    if (kind === 'none') return {argument: 'none', at: 0};
    const isTorque = kind === 'torque' ||
        (kind === 'speed or torque' && !readQuantity(this.panel.tables, this.at.value, 'N.m', undefined).error);
    const at = this.quantity(this.at, isTorque ? 'N.m' : 'rad/s', undefined);
    return at === null ? null : {argument: isTorque ? 'torque' : 'speed', at};
  }

  lockRow() {
    this.kept = el('select', {'aria-label': 'metric to keep constant'});
    this.giving = el('select', {'aria-label': 'parameter to adjust'});
    this.lock = el('button', {type: 'button', onclick: () => this.toggleLock()}, 'Keep');
    return el(
        'div', {class: 'tools'}, el('label', {}, 'Keep ', this.kept), el('label', {}, 'by adjusting ', this.giving),
        this.lock);
  }

  toggleLock() {
    const [metric, parameter] = [this.kept.value, this.giving.value];
    const value = this.panel.metrics[metric]?.value;
    if (!this.panel.state.view.lock && !Number.isFinite(value)) {
      this.error.textContent = capital(shortName(metric)) + ' has no value now, so it cannot be kept.';
      return;
    }
    this.error.textContent = '';
    this.act((view) => {
      view.lock = view.lock ? null : {metric, parameter, value};
    });
  }

  studyRow() {
    this.free = el('div', {class: 'free'});
    this.goalSense =
        el('select', {'aria-label': 'sense of the goal'}, el('option', {value: 'maximize'}, 'maximize'),
           el('option', {value: 'minimize'}, 'minimize'));
    return el(
        'details', {class: 'study'}, el('summary', {}, 'Optimize from here'),
        el('p', {},
           'Writes a study for "twum run": the present motor, with the chosen parameters varied between the ' +
               'ends of their sliders, under the limits above.'),
        el('div', {class: 'tools'}, this.goalSense, this.goalName = el('b', {}),
           el('button', {type: 'button', onclick: () => this.saveStudy()}, 'Save study.yaml')),
        this.free);
  }

  saveStudy() {
    const free = [...this.free.querySelectorAll('input:checked')].map(
        (box) =>
            ({name: box.value, min: this.panel.rows[box.value].range.low, max: this.panel.rows[box.value].range.high}));
    if (!free.length) {
      this.error.textContent = 'Choose at least one parameter to vary.';
      return;
    }
    const {motor, view} = this.panel.state;
    save(
        'study.yaml',
        studyYaml(motor, this.panel.tables, free, {sense: this.goalSense.value, metric: view.goal}, view.limits),
        'application/yaml');
  }

  /** Parameters that may be free, the usual ones chosen. */
  offerParameters() {
    const names = Object.keys(this.panel.tables.parameters)
                      .filter((name) => this.panel.state.motor.values[name] !== undefined && name !== 'radial_slices');
    if (names.join() === this.offered) return;
    this.offered = names.join();
    const usual = ['amplitude', 'voltage', 'preload', 'thickness', 'youngs_modulus'];
    this.giving.replaceChildren(...names.map((name) => el('option', {value: name}, shortName(name))));
    this.giving.value = 'preload';
    this.free.replaceChildren(...names.map(
        (name) => el(
            'label', {}, el('input', {type: 'checkbox', value: name, ...(usual.includes(name) ? {checked: ''} : {})}),
            ' ' + shortName(name))));
  }

  offerMetrics() {
    const names = Object.keys(this.panel.metrics);
    if (names.join() === this.metricsOffered) return;
    this.metricsOffered = names.join();
    this.kept.replaceChildren(...names.map((name) => el('option', {value: name}, shortName(name))));
    this.kept.value = 'no_load_speed';
  }

  show(view) {
    if (this.panel.metrics) {
      this.offerParameters();
      this.offerMetrics();
    }
    if (document.activeElement !== this.atRest) this.atRest.value = typedQuantity(view.load.rest, 'N.m');
    if (document.activeElement !== this.at100)
      this.at100.value = engineering(view.load.rest + view.load.rise * 100 * rpm, 'N.m', 6).replace(noBreak, ' ');
    this.lock.textContent = view.lock ? 'Release' : 'Keep';
    this.lock.setAttribute('aria-pressed', String(Boolean(view.lock)));
    if (view.lock) {
      this.kept.value = view.lock.metric;
      this.giving.value = view.lock.parameter;
    }
    this.goalName.textContent = shortName(view.goal);
    this.list.replaceChildren(...view.limits.map(
        (limit, i) =>
            el('li', {}, el('span', {}, limitWordsOf(limit, this.panel.tables)), el('b', {class: 'state'}),
               el('button', {
                 type: 'button',
                 class: 'small',
                 'aria-label': 'Remove the limit ' + (i + 1),
                 onclick: () => this.act((v) => v.limits.splice(i, 1))
               },
                  '\u00d7'))));
  }

  /** Says of each limit whether it holds, and where the load is met. */
  judge() {
    const {view} = this.panel.state;
    this.show(view);
    const found = view.limits.length ? this.panel.core.metrics(view.limits.map(limitRequest)) : [];
    [...this.list.children].forEach((item, i) => {
      const state = item.querySelector('.state');
      const bad = isBroken(view.limits[i], found[i]);
      const {unit} = this.panel.tables.metrics[view.limits[i].metric];
      state.textContent = (bad ? 'violated: ' : 'holds: ') +
          (found[i].status === 'ok' ? engineering(found[i].value, unit) : found[i].status);
      state.className = 'state ' + (bad ? 'bad-word' : 'good-word');
    });
    const {meeting} = this.panel;
    this.meets.textContent = !(view.load.rest || view.load.rise) ?
        '' :
        meeting ?
        'Runs at ' + engineering(meeting.speed, 'rad/s') + ' with ' + engineering(meeting.torque, 'N.m') + '.' :
        'The motor does not carry this load.';
  }
}

/** "no-load speed at least 100 rpm" */
function limitWordsOf(limit, tables) {
  const at =
      limit.argument === 'none' ? '' : ' at ' + engineering(limit.at, limit.argument === 'speed' ? 'rad/s' : 'N.m');
  return pointName(limit.metric) + at + (limit.sense === '>=' ? ' at least ' : ' at most ') +
      engineering(limit.value, tables.metrics[limit.metric].unit);
}
