// SPDX-License-Identifier: Apache-2.0
// The core of twum, compiled for pages: numbers in, numbers out. All values are SI.

import {bytesOfLetters} from '../bytes.js';

/** Thrown where the core has no answer for a motor; the message says why. */
export class CoreError extends Error {}

export const coreArguments = {
  none: 0,
  speed: 1,
  torque: 2
};
const edgeNumbers = {
  free: 0,
  clamped: 1,
  supported: 2
};

/** The compiled module from its letters. */
export async function compiledCore(text) {
  const unpacked = new Blob([bytesOfLetters(text)]).stream().pipeThrough(new DecompressionStream('gzip'));
  return WebAssembly.compile(await new Response(unpacked).arrayBuffer());
}

export class Core {
  /** @param {WebAssembly.Module} module */
  constructor(module) {
    this.module = module;
    this.restart();
    this.parameters = this.names(0);
    this.metricNames = this.names(1);
    this.metricStatuses = this.names(2);
    this.pointStatuses = this.names(3);
    this.motorNumbers = this.names(4);
    this.columns = this.names(5);
    this.heldStatuses = this.names(6);
    this.places = Object.fromEntries(this.parameters.map((name, i) => [name, i]));
  }

  /** A fresh instance. It asks the system for nothing that a page could give. */
  restart() {
    /** @type {any} */
    const imports = {};
    // what WASI answers to a call that does not exist
    const notHere = () => 52;
    for (const {module, name} of WebAssembly.Module.imports(this.module)) (imports[module] ??= {})[name] = notHere;
    this.exports = /** @type {any} */ (new WebAssembly.Instance(this.module, imports).exports);
    this.exports._initialize();
  }

  names(kind) {
    this.exports.names(kind);
    return this.text().split(' ');
  }

  text() {
    return new TextDecoder().decode(
        new Uint8Array(this.exports.memory.buffer, this.exports.text(), this.exports.text_size()).slice());
  }

  /** The memory may have moved with the last call, so a view is made for each look. */
  output(count) { return new Float64Array(this.exports.memory.buffer, this.exports.output(), count); }

  write(values) {
    const at = this.exports.input(values.length);
    new Float64Array(this.exports.memory.buffer, at, values.length).set(values);
  }

  /** Calls the core; how many things it wrote. */
  call(name, ...given) {
    let count = 0;
    try {
      count = this.exports[name](...given);
    } catch (error) {
      // after a trap nothing in the instance can be relied on
      this.restart();
      throw new CoreError('internal error, please report it with this motor: ' + error.message);
    }
    if (count < 0) throw new CoreError(this.text());
    return count;
  }

  /**
   * @returns {any} Takes a motor as the state keeps it; its numbers, the values of all parameters, and which are in
   *     use.
   */
  motor(stated, changes = {}) {
    const values = {...stated.values, ...changes};
    const list = this.parameters.map((name) => values[name] ?? NaN);
    this.write([
      ...list, stated.branch === 'dead' ? 1 : 0, edgeNumbers[stated.inner_edge] ?? 0, stated.table.length,
      ...stated.table.flat()
    ]);
    this.call('motor');
    const own = this.motorNumbers.length;
    const count = this.parameters.length;
    const found = this.output(own + 2 * count);
    return {
      ...Object.fromEntries(this.motorNumbers.map((name, i) => [name, found[i]])),
      values: Object.fromEntries(this.parameters.map((name, i) => [name, found[own + i]])),
      used: Object.fromEntries(this.parameters.map((name, i) => [name, found[own + count + i] === 1])),
    };
  }

  /**
   * The modal data that an equivalent circuit stands for; R_m, L_m, C_m, C_0 and Theta in. @returns {Object<string,
   * number>}
   */
  modalData(circuit) {
    this.write(circuit);
    const count = this.call('circuit');
    const found = this.output(2 * count);
    return Object.fromEntries(Array.from({length: count}, (_, i) => [this.parameters[found[2 * i]], found[2 * i + 1]]));
  }

  /** Columns of the curve from rest to a speed; a point without an answer has a status. */
  curve(points, last) {
    this.call('curve', points, last);
    const width = this.columns.length;
    const found = this.output(points * width);
    return Object.fromEntries(
        this.columns.map((name, k) => [name, Float64Array.from({length: points}, (_, i) => found[i * width + k])]));
  }

  /** Whether the motor squeals at a speed; no also where that is not known. */
  squeals(speed) { return this.call('squeals', speed) === 1; }

  /** @param {{metric: string, argument?: string, at?: number}[]} asked */
  ask(asked) {
    this.write(asked.flatMap(
        (one) => [this.metricNames.indexOf(one.metric), coreArguments[one.argument ?? 'none'], one.at ?? 0]));
  }

  metrics(asked) {
    this.ask(asked);
    this.call('metrics', asked.length);
    const found = this.output(2 * asked.length);
    return asked.map((_, i) => ({value: found[2 * i], status: this.metricStatuses[found[2 * i + 1]]}));
  }

  /** Values with their derivatives in every parameter. */
  gradients(asked) {
    this.ask(asked);
    this.call('gradients', asked.length);
    const width = 3 + this.parameters.length;
    const found = this.output(asked.length * width);
    return asked.map((_, i) => ({
                       value: found[i * width],
                       status: this.metricStatuses[found[i * width + 1]],
                       gradient: found.slice(i * width + 3, (i + 1) * width)
                     }));
  }

  /**
   * @returns {any} The contact at a speed: numbers of the point, zones [state, from, to], and samples along one wave.
   */
  fields(speed, samples) {
    const count = this.call('fields', speed, samples);
    const width = this.columns.length;
    const head = this.output(width + 1);
    const point = Object.fromEntries(this.columns.map((name, i) => [name, head[i]]));
    const zones = head[width];
    const rest = this.output(width + 1 + 3 * zones + 5 * count).subarray(width + 1);
    const sample = (k) => Float64Array.from({length: count}, (_, i) => rest[3 * zones + 5 * i + k]);
    return {
      point: {...point, status: this.pointStatuses[point.status]},
      zones: Array.from({length: zones}, (_, i) => Array.from(rest.subarray(3 * i, 3 * i + 3))),
      phase: sample(0),
      pressure: sample(1),
      traction: sample(2),
      stator: sample(3),
      layer: sample(4),
    };
  }

  /** A torque held at a speed by frequency or voltage: the drive, why it cannot, what would do, and the point. */
  held(torque, speed, byVoltage, [low, high]) {
    this.call('held', torque, speed, byVoltage ? 1 : 0, low, high);
    const [status, frequency, voltage, amplitude, needed, only, ...columns] = this.output(6 + this.columns.length);
    return {
      ...Object.fromEntries(this.columns.map((name, i) => [name, columns[i]])),
      status: this.heldStatuses[status],
      frequency,
      voltage,
      amplitude,
      needed,
      byControlOnly: only === 1
    };
  }

  /** Puts the motor at rest, to be followed in time; the longest step [s]. */
  atRest() {
    this.call('rest');
    return this.output(1)[0];
  }

  /** Follows it under a load torque with the drive on or off: speed, angle, amplitude, held of each row. */
  follow(torque, on, duration, rows) {
    this.call('follow', torque, on ? 1 : 0, duration, rows);
    return this.output(4 * rows);
  }

  /** What `twum check` notes on the motor. */
  notes(atLength) { return this.call('notes', atLength ? 1 : 0) ? this.text().split('\n') : []; }
}
