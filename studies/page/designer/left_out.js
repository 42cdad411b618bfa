// SPDX-License-Identifier: Apache-2.0
// What the page does not compute: the radial motion, the circuit of the driver, and numbers of the motor in the
// file that come with the page.

import {el} from '../dom.js';

export class LeftOut {
  /** @param {{name: string, text: string, shown: string}[]} list */
  constructor(motor, list = []) {
    this.motor = JSON.stringify(motor);
    this.without = el('p', {class: 'left-out'});
    this.facts =
        el('div', {class: 'facts fixed'}, list.length ? 'of the motor in the file:' : '',
           list.map(({name, text, shown}) => el('div', {title: text}, el('span', {}, name), el('strong', {}, shown))));
  }

  show(motor) {
    this.facts.classList.toggle('old', JSON.stringify(motor) !== this.motor);
    const kept = motor.besides;
    const told = [];
    if (kept['stator.radial_motion'] === 'true')
      told.push('This page computes without the radial motion of this motor.');
    if (parseFloat(kept['driver.inductance']) || parseFloat(kept['driver.resistance']))
      told.push('This page computes without the circuit of the driver.');
    this.without.hidden = !told.length;
    this.without.textContent = told.join(' ');
  }
}
