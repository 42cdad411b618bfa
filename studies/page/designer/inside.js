// SPDX-License-Identifier: Apache-2.0
// The designer inside a report: opened on the motor that one chooses, and made when it is first asked for.

import {data} from '../data.js';
import {card, el} from '../dom.js';

import {compiledCore, Core} from './core.js';
import {DesignerPanel} from './panel.js';
import {DesignState} from './state.js';

const insideReport = {
  node: null,
  panel: null
};

/** The motor of the study with the values of a design. */
function statedMotor(design, name) {
  const state = new DesignState({...data.designer.motor, name});
  const names = Object.keys(design).filter((n) => Object.hasOwn(data.parameters, n) && Number.isFinite(design[n]));
  names.sort(
      // its ratio to mu is replaced last
      (a, b) => Number(a === 'static_friction') - Number(b === 'static_friction'));
  for (const n of names) state.set(n, design[n], data.parameters[n].alternative);
  return state.motor;
}

async function openInReport(design, name) {
  insideReport.node ??= card(null, null, 'wide designer');
  const {node} = insideReport;
  try {
    const motor = statedMotor(design, name);
    if (insideReport.panel)
      insideReport.panel.openMotor(motor);
    else
      insideReport.panel = new DesignerPanel(
          node, {
            ...data.designer,
            parameters: data.parameters,
            metrics: data.metrics,
            reasons: data.reasons,
            contact: data.contact
          },
          new Core(await compiledCore(document.getElementById('core').textContent)), motor);
  } catch (error) {
    if (error instanceof TypeError || error instanceof ReferenceError) throw error;
    node.replaceChildren(el('p', {}, 'The core did not start in this browser: ' + error.message + '.'));
  }
  node.scrollIntoView({block: 'start'});
}

/** A button that opens a design in the designer; null where the report was written without the core for pages. */
export function designerButton(design, name, text = 'Explore this motor') {
  if (!document.getElementById('core').textContent) return null;
  return el('p', {class: 'explore'}, el('button', {type: 'button', onclick: () => openInReport(design, name)}, text));
}
