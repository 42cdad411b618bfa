// SPDX-License-Identifier: Apache-2.0
// What a person has set: the motor, the speed that is looked at, load, limits, goal, lock. With steps back, and as an
// address.

import {coreArguments} from './core.js';

// [s] a second of the motor takes two of the page
export const longestMotion = 5;

/**
 * @typedef {{metric: string, argument: string, at: number, sense: string, value: number}} Limit
 * @typedef {{name: string, values: Object<string, number>, branch: string, inner_edge: string | null, table:
 * number[][], besides: Object<string, string>}} StatedMotor
 */

export class DesignState {
  /** @param {StatedMotor} motor */
  constructor(motor) {
    this.opened = structuredClone(motor);
    this.motor = structuredClone(motor);
    this.view = {
      speed: NaN,
      goal: 'peak_power',
      load: {rest: 0, rise: 0},
      /** @type {Limit[]} */
      limits: [],
      lock: null,
      // of a start and a stop, as "twum move" has them: load torque [N m], when the drive is switched off, and the end
      // [s]
      motion: {torque: 0, off: 0.02, end: 0.03},
      // a load that is held; what is not given is that of the peak power, and the control that of the motor's file
      hold: {torque: null, speed: null, control: null}
    };
    this.steps = [];
    this.undone = [];
  }

  snapshot() { return JSON.stringify({motor: this.motor, view: this.view}); }
  restore(text) {
    Object.assign(this, JSON.parse(text));
    this.view.speed ??= NaN;
  }

  /** Remembers what is, before it changes; moves of one slider in one go are one step. */
  remember(what = null) {
    if (what !== null && what === this.moving) return;
    this.moving = what;
    this.steps.push(this.snapshot());
    if (this.steps.length > 200) this.steps.shift();
    this.undone = [];
  }

  /** The next move is a step of its own. */
  settle() { this.moving = null; }

  back() { return this.step(this.steps, this.undone); }
  forth() { return this.step(this.undone, this.steps); }
  step(from, to) {
    if (!from.length) return false;
    to.push(this.snapshot());
    this.restore(from.pop());
    this.settle();
    return true;
  }

  /** What another value of a parameter changes: mu_0 keeps its ratio to mu. */
  changes(name, value) {
    const {kinetic_friction: kinetic, static_friction: static_} = this.motor.values;
    return name === 'kinetic_friction' ?
        {kinetic_friction: value, static_friction: kinetic > 0 ? Math.max((static_ / kinetic) * value, value) : value} :
        {[name]: value};
  }

  /** Sets the value of a parameter, and removes its alternative. */
  set(name, value, alternative) {
    if (alternative) delete this.motor.values[alternative];
    Object.assign(this.motor.values, this.changes(name, value));
  }

  /** A motor from a file. */
  open(motor) {
    this.remember();
    this.motor = motor;
    this.opened = structuredClone(motor);
  }

  /** What differs from the motor that was opened, and what is looked at, for the address. */
  toHash() {
    const query = new URLSearchParams();
    const {values} = this.motor;
    for (const name of Object.keys(values))
      if (values[name] !== this.opened.values[name]) query.set(name, String(values[name]));
    const {speed, goal, load, limits, lock} = this.view;
    if (Number.isFinite(speed)) query.set('speed', String(Number(speed.toPrecision(6))));
    query.set('goal', goal);
    if (load.rest || load.rise) query.set('load', load.rest + ',' + load.rise);
    for (const l of limits) query.append('limit', [l.metric, l.argument, l.at, l.sense, l.value].join(','));
    const {torque, off, end} = this.view.motion;
    if (torque || off !== 0.02 || end !== 0.03) query.set('motion', [torque, off, end].join(','));
    const hold = Object.values(this.view.hold);
    if (hold.some((value) => value !== null)) query.set('hold', hold.map((value) => value ?? '').join(','));
    if (lock) query.set('lock', [lock.metric, lock.parameter, lock.value].join(','));
    return '#' + query.toString();
  }

  /** Takes from an address what it knows; the rest of an address is left alone. */
  fromHash(hash, core, tables) {
    const query = new URLSearchParams(hash.replace(/^#/, ''));
    for (const [name, text] of query) {
      if (core.places[name] !== undefined && text !== '' && Number.isFinite(Number(text)))
        this.set(name, Number(text), tables.parameters[name]?.alternative);
    }
    if (query.has('static_friction') && Number.isFinite(Number(query.get('static_friction'))))
      this.motor.values.static_friction = Number(query.get('static_friction'));
    const list = (text) => (text ?? '').split(',');
    const known = (metric) => Object.hasOwn(tables.metrics, metric);
    if (query.has('speed') && Number.isFinite(Number(query.get('speed')))) this.view.speed = Number(query.get('speed'));
    if (known(query.get('goal')) && tables.metrics[query.get('goal')].argument === 'none')
      this.view.goal = query.get('goal');
    const [rest, rise] = list(query.get('load')).map(Number);
    if (Number.isFinite(rest) && Number.isFinite(rise)) this.view.load = {rest, rise};
    const [torque, off, end] = list(query.get('motion')).map(Number);
    if (Number.isFinite(torque) && off > 0 && end > 0 && end <= longestMotion) this.view.motion = {torque, off, end};
    const [held, at, control] = list(query.get('hold'));
    this.view.hold = {
      torque: held && Number.isFinite(Number(held)) ? Number(held) : null,
      speed: Number(at) > 0 ? Number(at) : null,
      control: ['frequency', 'voltage'].includes(control) ? control : null
    };
    const limits = query.getAll('limit').map(list).map(
        ([metric, argument, at, sense, value]) => ({metric, argument, at: Number(at), sense, value: Number(value)}));
    this.view.limits = limits.filter(
        (l) => known(l.metric) && Object.hasOwn(coreArguments, l.argument) && ['>=', '<='].includes(l.sense) &&
            Number.isFinite(l.at) && Number.isFinite(l.value));
    const [metric, parameter, value] = list(query.get('lock'));
    this.view.lock = known(metric) && core.places[parameter] !== undefined && Number.isFinite(Number(value)) ?
        {metric, parameter, value: Number(value)} :
        null;
  }
}
