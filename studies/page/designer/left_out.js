// SPDX-License-Identifier: Apache-2.0
// What the page does not compute: the radial motion, and numbers of the motor in the file that come with the page.

import {el} from '../dom.js';

export class LeftOut {
  /** @param {{name: string, text: string, shown: string}[]} list */
  constructor(motor, list = []) {
    this.motor = JSON.stringify(motor);
    this.radial =
        el('p', {class: 'left-out'},
           'This page computes without the radial motion of the surface, which this motor has switched on.');
    this.facts =
        el('div', {class: 'facts fixed'}, list.length ? 'of the motor in the file:' : '',
           list.map(({name, text, shown}) => el('div', {title: text}, el('span', {}, name), el('strong', {}, shown))));
  }

  show(motor) {
    this.facts.classList.toggle('old', JSON.stringify(motor) !== this.motor);
    this.radial.hidden = motor.besides['stator.radial_motion'] !== 'true';
  }
}
