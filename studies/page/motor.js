// SPDX-License-Identifier: Apache-2.0
// Motors of the answer as files: their names in the result directory, and buttons that save them from the page.

import {el, save} from './dom.js';

/** {file, text} of a motor file with the button of the designer beside it; what there is none of is left out. */
export function savedMotor(found, explore) {
  if (!found && !explore) return '';
  const name = (file) => file.split('/').pop();
  const button = found ?
      el('button', {type: 'button', onclick: () => save(name(found.file), found.text, 'text/yaml')}, 'Save motor') :
      null;
  return el('div', {class: 'motor-file'}, found ? el('code', {}, found.file) : null, button, explore);
}
