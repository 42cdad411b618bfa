// SPDX-License-Identifier: Apache-2.0
// The buttons of the panel.

import {el, save} from '../dom.js';

import {MotorFileError, motorYaml, readMotorYaml, readPoints} from './motor.js';

function button(text, action, attributes = {}) {
  return el('button', {type: 'button', onclick: action, ...attributes}, text);
}

/** A button that opens a file; what is wrong with it is said in the panel. */
function openButton(text, accept, panel, take) {
  const input = el('input', {type: 'file', accept, class: 'hidden', tabindex: '-1', 'aria-hidden': 'true'});
  input.addEventListener('change', async () => {
    const file = /** @type {HTMLInputElement} */ (input).files[0];
    if (!file) return;
    try {
      take(await file.text(), file.name);
    } catch (error) {
      if (!(error instanceof MotorFileError)) throw error;
      panel.tell(file.name + ': ' + error.message, true);
    }
    /** @type {HTMLInputElement} */ (input).value = '';
  });
  return [button(text, () => input.click()), input];
}

function copyLink(panel) {
  history.replaceState(null, '', panel.state.toHash());
  const said =
      navigator.clipboard ? navigator.clipboard.writeText(location.href) : Promise.reject(new Error('no clipboard'));
  said.then(
      () => panel.tell('The link is copied; it opens this page with this motor.'),
      () => panel.tell('The link is in the address bar.'));
}

export function designerTools(panel) {
  const pin = button('Pin this motor', () => {
    const on = panel.pin();
    pin.textContent = on ? 'Unpin' : 'Pin this motor';
    pin.setAttribute('aria-pressed', String(on));
  }, {'aria-pressed': 'false'});
  const play = button('', () => {
    panel.playing = !panel.playing;
    name();
  });
  const name = () => {
    play.textContent = panel.playing ? 'Pause the wave' : 'Move the wave';
  };
  name();
  return el(
      'div', {class: 'tools'}, button('Undo', () => panel.stepTo('back'), {title: 'Ctrl+Z'}),
      button('Redo', () => panel.stepTo('forth'), {title: 'Ctrl+Shift+Z'}), pin, play,
      button(
          'As opened',
          () => {
            panel.state.remember();
            panel.state.motor = structuredClone(panel.state.opened);
            panel.changed = true;
          }),
      button(
          'Save motor.yaml', () => save('motor.yaml', motorYaml(panel.state.motor, panel.tables), 'application/yaml')),
      typeof jsyaml === 'undefined' ? null :
                                      openButton(
                                          'Open motor.yaml', '.yaml,.yml', panel,
                                          (text) => panel.openMotor(readMotorYaml(text, panel.tables, panel.core))),
      openButton('Measured points', '.csv,.txt', panel, (text) => {
        panel.measured = readPoints(text, panel.tables);
        panel.changed = true;
      }), panel.inAddress ? button('Copy link', () => copyLink(panel)) : null);
}

/** Undo and redo by the keyboard. */
export function stepKeys(panel, event) {
  if (!(event.ctrlKey || event.metaKey) || event.target instanceof HTMLInputElement && event.target.type === 'text')
    return;
  if (event.key === 'z' || event.key === 'y') {
    event.preventDefault();
    panel.stepTo(event.key === 'y' || event.shiftKey ? 'forth' : 'back');
  }
}
