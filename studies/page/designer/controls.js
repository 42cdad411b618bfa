// SPDX-License-Identifier: Apache-2.0
// Sliders with exact numbers, the numbers of the motor, and the editor of limits.

import {colour, el} from '../dom.js';
import {capital, shortName} from '../names.js';
import {displayUnit, engineering, percent, slicesText} from '../units.js';

import {automaticSlices} from './motor.js';
import {boxNumber, readQuantity, typedNumber} from './quantity.js';
import {surface} from './wave.js';

export const partTitles = {
  stator: 'Stator',
  rotor: 'Rotor',
  contact_layer: 'Contact layer',
  friction: 'Friction',
  preload: 'Preload',
  load: 'Load',
  driver: 'Driver'
};
export const sliderSteps = 1000;

/** Where a slider reaches: about the value and what is usual, within what is admissible. */
function sliderRange(row, value, modal) {
  const typical = row.typical || value || 1;
  const clip = (low, high) => ({low: Math.max(low, row.min), high: Math.min(high, row.max)});
  if (row.integer) return {...clip(Math.max(row.min, 0), Math.max(2 * typical, 2 * value)), log: false};
  // a resonance is narrow
  if (modal && row.unit === 'Hz') return {...clip(0.94 * value, 1.06 * value), log: false};
  if (row.unit === '1' && row.max - row.min <= 2) return {low: row.min, high: row.max, log: false};
  if (row.min < 0) {
    const size = 3 * Math.max(Math.abs(value), Math.abs(typical));
    return {...clip(value > 0 ? -size : Math.min(-size, value), value < 0 && typical < 0 ? 0 : size), log: false};
  }
  if (row.min === 0) return {...clip(0, 3 * Math.max(value, typical)), log: false};
  return {...clip(Math.min(value, typical) / 6, 6 * Math.max(value, typical)), log: true};
}

/** One parameter: name, number with unit, slider, what moving it does to the goal. */
export class ParameterRow {
  constructor(name, row, panel) {
    this.name = name;
    this.row = row;
    this.panel = panel;
    const id = 'p-' + panel.id + '-' + name;
    this.slider = el('input', {
      type: 'range',
      min: 0,
      max: sliderSteps,
      step: 1,
      id,
      oninput: () => this.slid(),
      onchange: () => panel.settled()
    });
    this.number = el('input', {
      type: 'text',
      inputmode: 'decimal',
      class: 'exact',
      autocomplete: 'off',
      'aria-label': this.title() + ', exact value',
      onchange: () => this.typed(),
      onfocus: () => this.chosen(),
      onblur: () => this.error.textContent || this.showNumber()
    });
    this.unit = el('span', {class: 'unit', 'aria-hidden': 'true'});
    this.effect = el('span', {class: 'effect'});
    this.strip = el('canvas', {class: 'strip', 'aria-hidden': 'true'});
    this.swap = row.alternative ? el('button', {
      type: 'button',
      class: 'swap',
      title: 'Give ' + shortName(row.alternative) + ' instead',
      'aria-label': 'Give ' + shortName(row.alternative) + ' in place of ' + shortName(name),
      onclick: () => panel.swapAlternative(name, row.alternative)
    },
                                     '\u21c4') :
                                  null;
    const label = el('label', { for: id, title: row.text
    }, shortName(name) + (row.symbol ? ' ' : ''), row.symbol ? el('i', {}, row.symbol) : null);
    this.error = el('span', {class: 'wrong', role: 'alert'});
    this.node =
        el('div', {class: 'row', 'data-parameter': name}, label, this.number, this.unit, this.swap ?? el('span', {}),
           el('span', {class: 'track'}, this.slider, this.strip), this.effect, this.error);
  }

  title() { return capital(shortName(this.name)) + (this.row.symbol ? ' ' + this.row.symbol : ''); }

  toSlider(value) {
    const {low, high, log} = this.range;
    const share = log ? Math.log(value / low) / Math.log(high / low) : (value - low) / (high - low);
    return Math.round(sliderSteps * Math.min(Math.max(share, 0), 1));
  }

  /** The value of a place of the slider, as round as the slider is fine. */
  fromSlider(place) {
    const {low, high, log} = this.range;
    const share = place / sliderSteps;
    const value = log ? low * (high / low) ** share : low + (high - low) * share;
    if (this.row.integer) return Math.round(value);
    const fine = log ? Math.abs(value) : high - low;
    const digits = Math.max(0, Math.ceil(Math.log10(Math.abs(value || 1) / fine))) + 4;
    return Number(value.toPrecision(Math.min(digits, 15)));
  }

  slid() {
    this.say('');
    this.panel.setValue(this.name, this.fromSlider(Number(this.slider.value)), 'slider ' + this.name);
  }

  typed() {
    const slices = this.row.entry === 'stator.radial_slices' ? automaticSlices(this.number.value) : null;
    if (slices !== null) {
      this.panel.setValue(this.name, slices);
      return;
    }
    const found =
        readQuantity(this.panel.tables, this.number.value, this.row.unit, this.shown.divisor, this.row.absolute);
    if (found.error) {
      this.say(this.number.value.slice(0, 30) + ' ' + found.error);
      return;
    }
    this.say('');
    this.panel.setValue(this.name, found.value);
  }

  /** All digits for a number that is chosen, else those that fit. */
  chosen() {
    this.number.value = this.text;
    this.number.select();
  }

  showNumber() {
    this.number.title = this.text;
    if (document.activeElement !== this.number) this.number.value = boxNumber(this.text);
  }

  say(text) {
    this.error.textContent = text;
    this.number.setAttribute('aria-invalid', String(text !== ''));
  }

  /** Shows a value; the range follows where the value leaves it. */
  show(value, modal) {
    if (!this.range || !(value >= this.range.low && value <= this.range.high)) {
      this.range = sliderRange(this.row, value, modal);
      this.bands = null;
    }
    this.shown = this.row.unit === 'rad/s' ? {text: 'rad/s', divisor: 1} : displayUnit(value, this.row.unit);
    const text = this.row.entry === 'stator.radial_slices' ? slicesText(value) : typedNumber(value, this.shown.divisor);
    this.text = text;
    this.showNumber();
    this.unit.textContent = this.shown.text;
    const place = String(this.toSlider(value));
    if (this.slider.value !== place) this.slider.value = place;
    this.slider.setAttribute('aria-valuetext', text + ' ' + this.shown.text);
  }

  /** Share of change of the goal for a change of 1 % in this parameter, in %. */
  showEffect(elasticity, goal) {
    const known = Number.isFinite(elasticity);
    const text = !known              ? '' :
        Math.abs(elasticity) < 0.005 ? '0' :
                                       (elasticity > 0 ? '+' : '\u2212') + Math.abs(elasticity).toFixed(2);
    this.effect.textContent = text === '' ? '' : text + ' %';
    this.effect.className = 'effect' + (elasticity > 0.005 ? ' up' : elasticity < -0.005 ? ' down' : '');
    this.effect.title =
        known ? '1 % more ' + shortName(this.name) + ' changes ' + shortName(goal) + ' by ' + text + ' %' : '';
  }

  /** Paints where along the slider a limit is broken or no motor exists. */
  showBands(broken) {
    const {ctx, width, height} = surface(this.strip);
    ctx.fillStyle = colour('bad');
    const step = width / broken.length;
    broken.forEach((bad, i) => {
      if (bad) ctx.fillRect(i * step, 0, step + 0.5, height);
    });
  }
}

/** The numbers of the motor, with their change since it was pinned. */
export class Tiles {
  constructor(node, panel) {
    this.node = node;
    this.panel = panel;
    this.tiles = {};
  }

  tile(name) {
    const [value, change] = [el('strong', {}), el('em', {})];
    const node =
        el('div', {'data-metric': name, title: this.panel.tables.metrics[name].text}, el('span', {}, shortName(name)),
           value, change);
    this.node.append(node);
    return {node, value, change};
  }

  show(metrics, pinned) {
    for (const [name, {value, status}] of Object.entries(metrics)) {
      const tile = (this.tiles[name] ??= this.tile(name));
      tile.node.hidden = false;
      const {unit, share} = this.panel.tables.metrics[name];
      const shown = () => share ? percent(value, 4) : engineering(value, unit);
      tile.value.textContent = status === 'ok' ? shown() : status.replaceAll('-', ' ');
      tile.node.title =
          status === 'ok' ? this.panel.tables.metrics[name].text : this.panel.tables.reasons[status] ?? status;
      tile.node.dataset.value = String(value);
      const before = pinned?.[name]?.value;
      const part = Number.isFinite(before) && before !== 0 ? 100 * (value / before - 1) : NaN;
      tile.change.textContent = Number.isFinite(part) && Math.abs(part) >= 0.05 ?
          (part > 0 ? '+' : '\u2212') + Math.abs(part).toFixed(1) + ' %' :
          '';
    }
    for (const [name, tile] of Object.entries(this.tiles))
      if (!(name in metrics)) tile.node.hidden = true;
  }
}
