// SPDX-License-Identifier: Apache-2.0
// A load that is held at a speed: the drive follows with its frequency or its voltage, the amplitude where it is given.

import {el} from '../dom.js';
import {capital, pointName} from '../names.js';
import {engineering, percent, rpm} from '../units.js';

import {sliderSteps} from './controls.js';
import {CoreError} from './core.js';
import {HeldMap} from './held_map.js';
import {boxQuantity, readQuantity} from './quantity.js';

// the slider reaches to so many times the speed without load of the fixed drive
const sliderReach = 2;
// metrics of a held point and their columns
const heldColumns = {
  drive_frequency_at: 'frequency',
  drive_voltage_at: 'voltage',
  amplitude_at: 'amplitude',
  phase_current_at: 'phase_current',
  electrical_power_at: 'electrical_power',
  output_power_at: 'output_power',
  overall_efficiency_at: 'overall_efficiency',
  contact_efficiency_at: 'contact_efficiency'
};
const neededUnits = {
  'torque-out-of-reach': 'N.m',
  'voltage-too-low': 'V',
  'amplitude-too-low': 'm',
  'outside-frequency-range': 'Hz'
};

export class HoldView {
  /** @param {import('./panel.js').DesignerPanel} panel */
  constructor(panel) {
    this.panel = panel;
    this.torque = this.box('held torque');
    this.speed = this.box('held speed');
    this.slider = el('input', {
      type: 'range',
      min: 1,
      max: sliderSteps,
      'aria-label': 'held speed, slider',
      oninput: () => this.set('speed', (this.lastSpeed() * Number(this.slider.value)) / sliderSteps, 'hold')
    });
    this.control =
        el('select', {'aria-label': 'adjusted quantity', onchange: () => this.set('control', this.control.value)},
           ['frequency', 'voltage'].map((value) => el('option', {value}, value)));
    this.follows = el('label', {}, 'adjusting the ', this.control);
    this.word = el('p', {class: 'wrong', role: 'status'});
    this.facts = el('div', {class: 'facts'});
    this.map = new HeldMap(this);
    this.asked = {torque: 0, speed: 0};
    this.node =
        el('div', {class: 'hold'},
           el('div', {class: 'tools'}, el('label', {}, 'Torque ', this.torque), el('label', {}, 'at ', this.speed),
              el('label', {class: 'grows'}, this.slider), this.follows),
           this.word, this.facts, this.map.node);
  }

  box(name) {
    const unit = name.endsWith('speed') ? 'rad/s' : 'N.m';
    const box = el('input', {type: 'text', class: 'exact', autocomplete: 'off', 'aria-label': name});
    box.addEventListener('change', () => {
      const found = readQuantity(this.panel.tables, box.value, unit, unit === 'N.m' ? 1 : rpm);
      if (found.error)
        this.say(capital(name) + ': ' + box.value.slice(0, 30) + ' ' + found.error + '.');
      else
        this.set(unit === 'N.m' ? 'torque' : 'speed', found.value);
    });
    return box;
  }

  set(name, value, moving = null) {
    const {panel} = this;
    panel.state.remember(moving);
    panel.state.view.hold[name] = value;
    panel.changed = true;
  }

  say(text) { this.word.textContent = text; }

  /** What follows, as the motor's file says or as it was chosen. */
  chosen() {
    const {motor, view} = this.panel.state;
    return view.hold.control ?? motor.besides['stator.control'] ?? 'frequency';
  }

  /** The ends of the frequency in the motor's file. */
  frequencyRange() {
    const text = this.panel.state.motor.besides['stator.frequency_range'] ?? '';
    const ends =
        text.replace(/[[\]]/g, '').split(',').map((end) => readQuantity(this.panel.tables, end, 'Hz', undefined).value);
    return ends.length === 2 ? ends : [NaN, NaN];
  }

  /** The largest speed of slider and map. */
  lastSpeed() { return sliderReach * this.panel.now.last_speed; }

  /** The drive that holds a torque at a speed. */
  at(torque, speed) { return this.panel.core.held(torque, speed, this.chosen() === 'voltage', this.frequencyRange()); }

  show() {
    const {metrics, state} = this.panel;
    const torque = state.view.hold.torque ?? (metrics.torque_at_peak_power?.value || 0);
    const speed = state.view.hold.speed ?? this.panel.usualSpeed();
    this.asked = {torque, speed};
    this.map.follow(JSON.stringify([state.motor, this.chosen()]));
    this.follows.hidden = state.motor.values.voltage === undefined;
    this.control.value = this.chosen();
    if (document.activeElement !== this.torque) this.torque.value = boxQuantity(torque, 'N.m');
    if (document.activeElement !== this.speed) this.speed.value = boxQuantity(speed, 'rad/s');
    this.slider.value = String(Math.round((sliderSteps * speed) / this.lastSpeed()));
    this.slider.setAttribute('aria-valuetext', this.speed.value);
    try {
      this.showFound(this.at(torque, speed));
    } catch (error) {
      if (!(error instanceof CoreError)) throw error;
      this.found = null;
      this.facts.replaceChildren();
      this.say(capital(error.message) + '.');
    }
  }

  showFound(found) {
    const {tables} = this.panel;
    this.found = found;
    const {status, needed} = found;
    const unit = neededUnits[status];
    this.say(
        status !== 'ok' ? 'Not held: ' + (tables.reasons[status] ?? status) +
                (unit && Number.isFinite(needed) ? ' (' + engineering(needed, unit) + ')' : '') + '.' :
            found.byControlOnly ? 'Held only with speed control; with a constant drive this point is unstable.' :
                                  '');
    const shown = Object.entries(heldColumns).filter(([, column]) => status === 'ok' && Number.isFinite(found[column]));
    this.facts.replaceChildren(...shown.map(
        ([metric, column]) =>
            el('div', {'data-held': metric, title: tables.metrics[metric]?.text}, el('span', {}, pointName(metric)),
               el('strong', {}, this.text(metric, found[column])))));
  }

  text(metric, value) {
    const {unit, share} = this.panel.tables.metrics[metric];
    return share ? percent(value, 4) : engineering(value, unit);
  }
}
