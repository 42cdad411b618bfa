// SPDX-License-Identifier: Apache-2.0
// The page of `twum explore`.

import {el} from '../dom.js';

import {compiledCore, Core} from './core.js';
import {DesignerPanel} from './panel.js';

/** Says why the motor cannot be shown, and what can be done. */
function sayMissing(page, text) {
  page.append(
      el('header', {}, el('h1', {}, 'twum designer')),
      el('section', {class: 'card wide verdict bad'}, el('p', {}, text)));
}

async function openDesigner() {
  const page = document.getElementById('page');
  const explored = JSON.parse(document.getElementById('data').textContent);
  page.classList.add('designer');
  if (!explored.core) {
    sayMissing(
        page,
        'This page was written by a twum that was built without the core for pages, so the motor ' +
            'cannot be computed here. Build twum where Clang 14 for WebAssembly is installed ' +
            '(scripts/install-deps.sh installs it), then run "twum explore" again. "twum curve" and ' +
            'the other commands give the numbers of this motor without it.');
  } else {
    try {
      const core = new Core(await compiledCore(explored.core));
      Object.assign(page, {panel: new DesignerPanel(page, explored, core, explored.motor, true)});
    } catch (error) {
      if (error instanceof TypeError || error instanceof ReferenceError) throw error;
      sayMissing(
          page,
          'The core did not start in this browser: ' + error.message +
              '. It needs WebAssembly with exceptions: Chromium 95, Firefox 102, Safari 16, or later.');
    }
  }
  page.dataset.ready = 'yes';
}

openDesigner();
