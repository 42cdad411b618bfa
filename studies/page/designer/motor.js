// SPDX-License-Identifier: Apache-2.0
// Motors and studies as files: motor.yaml read and written, study.yaml written.

import {slicesText} from '../units.js';

import {plainUnit, readQuantity, typedQuantity, unitFactors} from './quantity.js';

/** Lines of a nested mapping; values are texts that YAML reads as they stand. */
function yamlLines(tree, indent) {
  return Object.entries(tree).flatMap(
      ([key, value]) =>
          (typeof value === 'object' ? [indent + key + ':', ...yamlLines(value, indent + '  ')] :
                                       [indent + key + ': ' + value]));
}

/** A text between double quotes, as YAML and JSON both read it. */
function quotedText(text) { return JSON.stringify(text); }

function putEntry(tree, path, value) {
  const steps = path.split('.');
  let node = tree;
  for (const step of steps.slice(0, -1)) node = node[step] ??= {};
  node[steps[steps.length - 1]] = value;
}

/** The value of `auto` or `auto N`; null for other texts. */
export function automaticSlices(text) {
  const found = /^auto(?: +([1-9]\d*))?$/.exec(String(text).trim());
  return found && (found[1] ? -Number(found[1]) : 0);
}

/** What stands below `motor:`, every value with its unit. */
function motorTree(motor, tables) {
  const tree = motor.name ? {name: quotedText(motor.name)} : {};
  for (const [name, row] of Object.entries(tables.parameters)) {
    if (motor.values[name] === undefined) continue;
    const value = motor.values[name];
    putEntry(tree, row.entry, name === 'radial_slices' ? slicesText(value) : typedQuantity(value, row.unit));
  }
  if (motor.values.voltage !== undefined && motor.branch === 'dead') putEntry(tree, 'stator.branch', 'dead');
  if (motor.inner_edge) putEntry(tree, 'stator.geometry.support.inner_edge', motor.inner_edge);
  if (motor.table.length && !motor.inner_edge)
    putEntry(
        tree, 'stator.radial_shape.table',
        '[' + motor.table.map(([radius, shape]) => '[' + typedQuantity(radius, 'm') + ', ' + shape + ']').join(', ') +
            ']');
  for (const [path, text] of Object.entries(motor.besides)) putEntry(tree, path, text);
  return tree;
}

/**
 * What the page keeps of a file without reading it: temperatures, wear, axial and radial motion, the circuit of a
 * driver, a drive that follows.
 */
const keptEntries = new RegExp(
    '^(thermal\\.|wear\\.|rotor\\.axial_damping$|driver\\.(inductance|resistance)$|operation$|' +
    'stator\\.(control|frequency_range|radial_motion)$)');

/** A value of a file in one line of YAML. */
function flowText(value) {
  if (Array.isArray(value)) return '[' + value.map(flowText).join(', ') + ']';
  if (value !== null && typeof value === 'object')
    return '{' + Object.entries(value).map(([key, one]) => key + ': ' + flowText(one)).join(', ') + '}';
  return /^[\w.+-][\w ./^()+*%<>=-]*$/.test(value) ? String(value) : quotedText(String(value));
}

export function motorYaml(motor, tables) {
  return yamlLines({twum: '1', motor: motorTree(motor, tables)}, '').join('\n') + '\n';
}

/** "torque_at(100 rpm) >= 0.5 N.m" */
function limitText(limit, tables) {
  const unit = limit.argument === 'speed' ? 'rad/s' : 'N.m';
  const at = limit.argument === 'none' ? '' : '(' + typedQuantity(limit.at, unit) + ')';
  return limit.metric + at + ' ' + limit.sense + ' ' + typedQuantity(limit.value, tables.metrics[limit.metric].unit);
}

/** A study that searches from this motor: what is free between the ends of its slider, the goal, and the limits. */
export function studyYaml(motor, tables, free, goal, limits) {
  const variables = Object.fromEntries(free.map(
      ({name, min, max}) =>
          [name,
           '{min: ' + typedQuantity(min, tables.parameters[name].unit) +
               ', max: ' + typedQuantity(max, tables.parameters[name].unit) + '}']));
  const head = {
    twum: '1',
    motor: motorTree(motor, tables),
    study: {kind: 'optimize', variables, [goal.sense]: goal.metric}
  };
  const lines = yamlLines(head, '');
  if (limits.length) lines.push('  constraints:', ...limits.map((l) => '    - ' + limitText(l, tables)));
  return lines.join('\n') + '\n';
}

export class MotorFileError extends Error {}

/** Every value of a mapping with the path to it. */
function leaves(tree, path = '') {
  return Object.entries(tree).flatMap(([key, value]) => {
    const here = path + key;
    return value !== null && typeof value === 'object' && !Array.isArray(value) ? leaves(value, here + '.') :
                                                                                  [[here, value]];
  });
}

/** The values of a material that an entry of the geometry names. */
function setMaterial(values, block, material, tables) {
  if (!Object.hasOwn(tables.materials, material))
    throw new MotorFileError(
        block + '.material: ' + String(material).slice(0, 40) + ' is not in the catalogue; expected one of ' +
        Object.keys(tables.materials).join(', '));
  for (const [property, value] of Object.entries(tables.materials[material])) {
    const name = block + '_' + property;
    if (Object.hasOwn(tables.parameters, name)) values[name] ??= value;
  }
}

/** Rows of a radial shape: a radius with its unit, and the amplitude there. */
function shapeTable(rows, tables) {
  const read = (text, unit) => readQuantity(tables, String(text), unit, unit === '1' ? 1 : undefined);
  const table = (Array.isArray(rows) ? rows : []).map((row) => [read(row[0], 'm').value, read(row[1], '1').value]);
  if (!table.length || !table.flat().every(Number.isFinite))
    throw new MotorFileError('stator.radial_shape.table: expected rows such as [24 mm, 0.9]');
  return table;
}

const circuitUnits = {
  motional_resistance: 'ohm',
  motional_inductance: 'H',
  motional_capacitance: 'F',
  blocked_capacitance: 'F',
  force_factor: 'N/V'
};
const circuitPath = 'stator.equivalent_circuit.';

/** One number of a motor file in SI. */
function entryNumber(path, value, unit, tables, absolute = false) {
  const found = readQuantity(tables, String(value), unit, unit === '1' ? 1 : undefined, absolute);
  if (found.error) throw new MotorFileError(path + ': ' + String(value).slice(0, 40) + ' ' + found.error);
  return found.value;
}

/** The modal data behind an equivalent circuit take its place. */
function takeCircuit(motor, entries, tables, core) {
  const circuit = Object.entries(circuitUnits).map(([name, unit]) => {
    const path = circuitPath + name;
    if (entries[path] === undefined) throw new MotorFileError(path + ': missing');
    const value = entryNumber(path, entries[path], unit, tables);
    if (!(value > 0)) throw new MotorFileError(path + ': ' + entries[path] + ' must be above 0');
    return value;
  });
  const data = core.modalData(circuit);
  for (const name of [...Object.keys(data), 'modal_damping']) {
    if (motor.values[name] !== undefined)
      throw new MotorFileError('stator.' + name + ': also follows from equivalent_circuit; leave one of the two out');
  }
  Object.assign(motor.values, data);
}

/** Enters one value of a motor file. */
function takeEntry(motor, path, value, tables, byEntry) {
  if (path === 'name') {
    motor.name = String(value);
    return;
  }
  if (path === 'stator.branch') {
    motor.branch = value === 'dead' ? 'dead' : 'running';
    return;
  }
  if (path === 'stator.geometry.support.inner_edge') {
    motor.inner_edge = String(value);
    return;
  }
  if (path === 'stator.radial_shape.table') {
    motor.table = shapeTable(value, tables);
    return;
  }
  const material = /^stator\.geometry\.(\w+)\.material$/.exec(path);
  if (material) {
    setMaterial(motor.values, material[1], value, tables);
    return;
  }
  if (keptEntries.test(path)) {
    motor.besides[path] = flowText(value);
    return;
  }
  const name = byEntry[path];
  if (name === undefined)
    throw new MotorFileError(
        path.slice(0, 60) +
        ': this page does not read that entry; run "twum explore" with the file, which reads all of them');
  if (name === 'radial_slices' && automaticSlices(value) !== null) {
    motor.values[name] = automaticSlices(value);
    return;
  }
  motor.values[name] = entryNumber(path, value, tables.parameters[name].unit, tables, tables.parameters[name].absolute);
}

/** Values that a file may leave out and the page needs to name. */
function fillDefaults(motor) {
  const {values} = motor;
  if (values.static_friction === undefined) values.static_friction = values.kinetic_friction;
  if (values.modal_damping === undefined && values.quality_factor === undefined) values.modal_damping = 0;
  values.radial_slices ??= 1;
  if (values.substrate_thickness !== undefined) motor.inner_edge ??= 'free';
}

/** What has to be in a motor file and is not. */
function missingEntries(motor, tables) {
  // gives the neutral plane
  const drawn = motor.values.substrate_thickness !== undefined;
  return Object.entries(tables.parameters)
      .filter(
          ([name, row]) => row.required && motor.values[name] === undefined &&
              (!row.alternative || motor.values[row.alternative] === undefined) &&
              !(drawn && name === 'neutral_plane_distance'))
      .map(([, row]) => row.entry);
}

/** Reads a motor file. @param {import('./core.js').Core} core  @returns {StatedMotor} */
export function readMotorYaml(text, tables, core) {
  let file;
  try {
    file = jsyaml.load(text);
  } catch (error) { throw new MotorFileError(String(error.message).split('\n')[0]); }
  if (file === null || typeof file !== 'object' || file.twum !== 1)
    throw new MotorFileError('twum: expected a motor file, which begins with "twum: 1"');
  if (file.study !== undefined) throw new MotorFileError('study: this is a study file; expected a motor file');
  if (file.motor === null || typeof file.motor !== 'object')
    throw new MotorFileError('motor: expected the motor with its entries');
  const motor = {name: '', values: {}, branch: 'running', inner_edge: null, table: [], besides: {}};
  const byEntry = Object.fromEntries(Object.entries(tables.parameters).map(([name, row]) => [row.entry, name]));
  const entries = Object.fromEntries(leaves(file.motor));
  const ofCircuit = (path) =>
      path.startsWith(circuitPath) && Object.hasOwn(circuitUnits, path.slice(circuitPath.length));
  for (const [path, value] of Object.entries(entries))
    if (!ofCircuit(path)) takeEntry(motor, path, value, tables, byEntry);
  if (Object.keys(entries).some(ofCircuit)) takeCircuit(motor, entries, tables, core);
  const missing = missingEntries(motor, tables);
  if (missing.length) throw new MotorFileError('motor: missing ' + missing.join(', '));
  fillDefaults(motor);
  return motor;
}

/** Reads measured points: a table with the columns speed and torque, units in brackets. */
export function readPoints(text, tables) {
  const rows = text.split(/\r?\n/)
                   .map((line) => line.trim())
                   .filter((line) => line !== '' && !line.startsWith('#'))
                   .map((line) => line.split(/[,;\t]/).map((cell) => cell.trim().replace(/^"|"$/g, '')));
  const column = (name, unit) => {
    const place = (rows[0] ?? []).findIndex((cell) => cell.replace(/\s*\[.*$/, '') === name);
    if (place < 0)
      throw new MotorFileError('no column ' + name + '; expected a first line such as: speed [rpm], torque [N.m]');
    const typed = /\[(.*)\]/.exec(rows[0][place])?.[1] ?? unit;
    const factor = unitFactors(tables, unit)[plainUnit(typed)];
    if (factor === undefined)
      throw new MotorFileError('column ' + name + ': this page does not know the unit ' + typed.slice(0, 20) + ' here');
    return {place, factor};
  };
  const [speed, torque] = [column('speed', 'rad/s'), column('torque', 'N.m')];
  const points = rows.slice(1).map(
      (row) => (
          {speed: parseFloat(row[speed.place]) * speed.factor, torque: parseFloat(row[torque.place]) * torque.factor}));
  const good = points.filter((p) => Number.isFinite(p.speed) && Number.isFinite(p.torque));
  if (!good.length) throw new MotorFileError('no row has a number for both speed and torque');
  return good;
}
