// SPDX-License-Identifier: Apache-2.0
// Pressure, traction with its bounds, and surface velocities along the contact at one speed.

import {numbers} from './bytes.js';
import {paddedRange, scaled} from './chart.js';
import {card, el, legend} from './dom.js';
import {figure} from './figure.js';
import {degree, zoneNames} from './names.js';
import {trackMaps} from './track.js';
import {displayUnit, engineering, largest} from './units.js';
import {axisLabel} from './words.js';
import {nameZones, paintZones} from './zones.js';

function readFields(curve) {
  const f = curve.fields;
  if (!f) return null;
  const floats = (text) => numbers(text, Float32Array);
  return {
    phase: floats(f.phase),
    pressure: floats(f.pressure),
    stator: floats(f.stator_velocity),
    kinetic: f.kinetic,
    static: f.static,
    frames: f.frames.map((frame) => ({
                           speed: frame.speed,
                           traction: floats(frame.traction),
                           layer: floats(frame.layer_velocity),
                           zones: frame.zones
                         }))
  };
}

const phaseLabel = 'phase of the wave, crest at 0 [deg]';

/** Three charts of one motor that show the speed nearest to the one asked for. */
class FieldsViewer {
  constructor(nodes, fields, title) {
    this.fields = fields;
    this.title = title;
    this.frame = null;
    this.degrees = Float64Array.from(fields.phase, (p) => p / degree);
    this.tractionUnit = displayUnit(fields.static * largest([fields.pressure]), 'Pa');
    this.velocityUnit = displayUnit(largest([fields.stator, ...fields.frames.map((f) => f.layer)]), 'm/s');
    this.plots = [this.pressure(nodes[0]), this.traction(nodes[1]), this.velocity(nodes[2])];
  }

  chart(node, name, series, label, unit, range) {
    const {degrees} = this;
    return figure(node, degrees, series, {
      name,
      x: {label: phaseLabel, range: [degrees[0], degrees[degrees.length - 1]]},
      y: {label: axisLabel(label, unit), range},
      height: 210,
      ground: (u) => paintZones(u, this.frame?.zones ?? []),
      front: (u) => nameZones(u, this.frame?.zones ?? [])
    });
  }

  pressure(node) {
    const unit = displayUnit(largest([this.fields.pressure]), 'Pa');
    const y = scaled(this.fields.pressure, unit.divisor);
    return this.chart(
        node, 'pressure', [{name: 'pressure', y, colour: 'c0'}], 'pressure', unit, paddedRange([y], true));
  }

  /** Traction within its friction bounds. */
  traction(node) {
    const {fields, tractionUnit: unit} = this;
    const bound = scaled(fields.pressure, unit.divisor / fields.static);
    const below = bound.map((v) => -v);
    const dashed = {colour: 'soft', dash: [5, 4]};
    const series = [
      {name: 'bound', y: bound, ...dashed}, {name: '-bound', y: below, ...dashed},
      {name: 'traction', y: scaled(fields.frames[0].traction, unit.divisor), colour: 'c1'}
    ];
    return this.chart(node, 'traction', series, 'traction', unit, paddedRange([bound, below]));
  }

  velocity(node) {
    const {fields, velocityUnit: unit} = this;
    const stator = scaled(fields.stator, unit.divisor);
    const layers = fields.frames.map((f) => scaled(f.layer, unit.divisor));
    const series =
        [{name: 'stator', y: stator, colour: 'c0'}, {name: 'layer', y: layers[0], colour: 'c1', dash: [7, 4]}];
    return this.chart(node, 'velocity', series, 'surface velocity', unit, paddedRange([stator, ...layers]));
  }

  /** Shows the stored speed nearest to this one. */
  show(speed) {
    const nearer = (a, b) => (Math.abs(b.speed - speed) < Math.abs(a.speed - speed) ? b : a);
    const best = this.fields.frames.reduce(nearer);
    if (best === this.frame) return;
    this.frame = best;
    const zones = best.zones.map(([state]) => zoneNames[state]).join(' / ');
    this.title.replaceChildren('at ', el('b', {}, engineering(best.speed, 'rad/s')), ': ' + zones);
    const [pressure, traction, velocity] = this.plots;
    const list = (values, unit) => Array.from(values, (v) => v / unit.divisor);
    pressure.redraw(false);
    traction.setData([...traction.data.slice(0, 3), list(best.traction, this.tractionUnit)]);
    velocity.setData([...velocity.data.slice(0, 2), list(best.layer, this.velocityUnit)]);
  }
}

const fieldsLegend = [
  {name: 'slip+: the stator drives', colour: 'slip-plus', kind: 'area'}, {name: 'stick', colour: 'stick', kind: 'area'},
  {name: 'slip-: the stator brakes', colour: 'slip-minus', kind: 'area'},
  {name: 'friction bound', colour: 'soft', kind: 'dash'}, {name: 'stator', colour: 'c0'},
  {name: 'layer', colour: 'c1', kind: 'dash'}
];

/** The card of the fields; of several curves one is chosen, at a speed of the slider. */
class FieldsCard {
  constructor(list, names, all) {
    this.list = list;
    this.all = all;
    this.speed = null;
    this.title = el('div', {class: 'read', 'aria-live': 'polite', 'data-fields': 'title'});
    this.slider = el('input', {type: 'range', min: 0, max: 1000, value: 700, 'aria-label': 'speed'});
    this.choice = el('select', {'aria-label': 'curve'}, names.map((name, i) => el('option', {value: i}, name)));
    this.body = el('div', {});
    this.slider.addEventListener('input', () => this.showAt((this.lastSpeed() * this.slider.value) / 1000));
    this.choice.addEventListener('change', () => this.build(Number(this.choice.value)));
    const note = 'One contact zone of the wave at one speed: where the layer sticks to the stator, where it slips, ' +
        'and the resulting stresses and velocities. The background colour shows the zone.';
    const curve = list.length > 1 ? el('label', {}, 'curve ', this.choice) : null;
    const tools = el('div', {class: 'tools'}, curve, el('label', {}, 'speed ', this.slider));
    card('In the contact', note, 'wide', tools, this.title, legend(fieldsLegend), this.body);
  }

  lastSpeed() {
    const {frames} = this.viewer.fields;
    return frames[frames.length - 1].speed;
  }

  /** At peak power a contact does everything it can. */
  firstSpeed(k) {
    const peak = this.list[k].metrics.speed_at_peak_power;
    return peak > 0 && peak < this.lastSpeed() ? peak : 0.7 * this.lastSpeed();
  }

  /** Shows the curve of this number, at the speed shown before. */
  build(k) {
    if (!this.all[k]) return;
    this.choice.value = k;
    const panels = [el('div', {}), el('div', {}), el('div', {})];
    const over = el('div', {});
    this.body.replaceChildren(el('div', {class: 'triple'}, panels), over);
    this.viewer = new FieldsViewer(panels, this.all[k], this.title);
    this.maps = trackMaps(over, this.list[k]);
    const asked = this.speed;
    this.show(asked ?? this.firstSpeed(k));
    this.speed = asked;  // until someone asks for one, each curve begins at its own
  }

  showAt(speed) {
    this.speed = speed;
    this.viewer.show(speed);
    this.maps?.show(speed);
  }

  /** The same, with the slider at that speed. */
  show(speed) {
    this.slider.value = Math.round((1000 * speed) / this.lastSpeed());
    this.showAt(speed);
  }
}

/** The fields of several curves, that of the number chosen first; null where no curve has fields. */
export function fieldsSection(list, names, chosen) {
  const all = list.map(readFields);
  if (!all.some(Boolean)) return null;
  const fields = new FieldsCard(list, names, all);
  fields.build(all[chosen] ? chosen : all.findIndex(Boolean));
  return fields;
}
