// SPDX-License-Identifier: Apache-2.0
// Pressure, traction with its bounds, and surface velocities along the contact at one speed.

import {numbers} from './bytes.js';
import {paddedRange, scaled} from './chart.js';
import {el} from './dom.js';
import {figure} from './figure.js';
import {degree, zoneNames} from './names.js';
import {trackMaps} from './track.js';
import {displayUnit, engineering, largest} from './units.js';
import {axisLabel} from './words.js';
import {contactKey, contactLines, nameZones, paintZones} from './zones.js';

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

/** Three charts of one motor that show the speed nearest to the one asked for. */
class FieldsViewer {
  /** told: the charts without numbers */
  constructor(nodes, told, fields, title) {
    this.told = told;
    this.fields = fields;
    this.title = title;
    this.frame = null;
    this.degrees = Float64Array.from(fields.phase, (p) => p / degree);
    const size = [
      largest([fields.pressure]), fields.static * largest([fields.pressure]),
      largest([fields.stator, ...fields.frames.map((f) => f.layer)])
    ];
    this.units = told.map((chart, k) => displayUnit(size[k], chart.y.unit));
    this.plots = nodes.map((node, k) => this.chart(node, k, ...this.values(k)));
  }

  /** Of a chart the values of its lines, and those that its axis holds. */
  values(k) {
    const {fields} = this;
    const shown = (values) => scaled(values, this.units[k].divisor);
    if (k === 0) return [[shown(fields.pressure)], [shown(fields.pressure)]];
    if (k === 2)
      return [
        [shown(fields.stator), shown(fields.frames[0].layer)],
        [fields.stator, ...fields.frames.map((f) => f.layer)].map(shown)
      ];
    const bound = shown(fields.pressure.map((p) => p * fields.static));
    const below = bound.map((v) => -v);
    return [[bound, below, shown(fields.frames[0].traction)], [bound, below]];
  }

  chart(node, k, lines, ends) {
    const {degrees} = this;
    const {name, x, y} = this.told[k];
    return figure(node, degrees, contactLines(this.told[k], lines), {
      name,
      x: {label: x.name + ' [deg]', range: [degrees[0], degrees[degrees.length - 1]]},
      y: {label: axisLabel(y.name, this.units[k]), range: paddedRange(ends, y.zero)},
      height: 210,
      ground: (u) => paintZones(u, this.frame?.zones ?? []),
      front: (u) => nameZones(u, this.frame?.zones ?? [])
    });
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
    traction.setData([...traction.data.slice(0, 3), list(best.traction, this.units[1])]);
    velocity.setData([...velocity.data.slice(0, 2), list(best.layer, this.units[2])]);
  }
}

/** The card of the fields; of several curves one is chosen, at a speed of the slider. */
class FieldsCard {
  constructor(node, charts, list, all) {
    this.charts = charts;
    this.list = list;
    this.all = all;
    this.speed = null;
    this.title = el('div', {class: 'read', 'aria-live': 'polite', 'data-fields': 'title'});
    this.slider = el('input', {type: 'range', min: 0, max: 1000, value: 700, 'aria-label': 'speed'});
    this.choice = el('select', {'aria-label': 'curve'}, list.map((c, i) => el('option', {value: i}, c.label)));
    this.body = el('div', {});
    this.slider.addEventListener('input', () => this.showAt((this.lastSpeed() * this.slider.value) / 1000));
    this.choice.addEventListener('change', () => this.build(Number(this.choice.value)));
    const curve = list.length > 1 ? el('label', {}, 'curve ', this.choice) : null;
    const tools = el('div', {class: 'tools'}, curve, el('label', {}, 'speed ', this.slider));
    node.append(tools, this.title, contactKey(charts), this.body);
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
    this.viewer = new FieldsViewer(panels, this.charts, this.all[k], this.title);
    this.maps = trackMaps(over, this.list[k], this.charts[0].x.name);
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

/** The fields of several curves, those of the last one first; null where no curve has fields. */
export function fieldsCard(node, charts, list) {
  const all = list.map(readFields);
  if (!all.some(Boolean)) return null;
  const fields = new FieldsCard(node, charts, list, all);
  const last = all.length - 1;
  fields.build(all[last] ? last : all.findIndex(Boolean));
  return fields;
}
