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

/** Three charts of one motor that show the speed nearest to the one asked for. */
class FieldsViewer {
  constructor(nodes, fields, title) {
    this.fields = fields;
    this.title = title;
    this.frame = null;
    const degrees = Float64Array.from(fields.phase, (p) => p / degree);
    const common = {
      x: {label: 'phase of the wave, crest at 0 [deg]', range: [degrees[0], degrees[degrees.length - 1]]},
      height: 210,
      ground: (u) => paintZones(u, this.frame?.zones ?? []),
      front: (u) => nameZones(u, this.frame?.zones ?? [])
    };
    const pressureUnit = displayUnit(largest([fields.pressure]), 'Pa');
    this.tractionUnit = displayUnit(Math.max(fields.static * largest([fields.pressure])), 'Pa');
    this.velocityUnit = displayUnit(largest([fields.stator, ...fields.frames.map((f) => f.layer)]), 'm/s');
    const pressure = scaled(fields.pressure, pressureUnit.divisor);
    const bound = scaled(fields.pressure, this.tractionUnit.divisor / fields.static);
    const first = fields.frames[0];
    const stator = scaled(fields.stator, this.velocityUnit.divisor);
    this.plots = [
      figure(nodes[0], degrees, [{name: 'pressure', y: pressure, colour: 'c0'}], {
        ...common,
        name: 'pressure',
        y: {label: axisLabel('pressure', pressureUnit), range: paddedRange([pressure], true)}
      }),
      figure(
          nodes[1], degrees,
          [
            {name: 'bound', y: bound, colour: 'soft', dash: [5, 4]},
            {name: '-bound', y: bound.map((v) => -v), colour: 'soft', dash: [5, 4]},
            {name: 'traction', y: scaled(first.traction, this.tractionUnit.divisor), colour: 'c1'}
          ],
          {
            ...common,
            name: 'traction',
            y: {label: axisLabel('traction', this.tractionUnit), range: paddedRange([bound, bound.map((v) => -v)])}
          }),
      figure(
          nodes[2], degrees,
          [
            {name: 'stator', y: stator, colour: 'c0'},
            {name: 'layer', y: scaled(first.layer, this.velocityUnit.divisor), colour: 'c1', dash: [7, 4]}
          ],
          {
            ...common,
            name: 'velocity',
            y: {
              label: axisLabel('surface velocity', this.velocityUnit),
              range: paddedRange([stator, ...fields.frames.map((f) => scaled(f.layer, this.velocityUnit.divisor))])
            }
          }),
    ];
  }

  /** Shows the stored speed nearest to this one. */
  show(speed) {
    const frames = this.fields.frames;
    let best = frames[0];
    for (const frame of frames)
      if (Math.abs(frame.speed - speed) < Math.abs(best.speed - speed)) best = frame;
    if (best === this.frame) return;
    this.frame = best;
    const zones = best.zones.map(([state]) => zoneNames[state]).join(' / ');
    this.title.replaceChildren('at ', el('b', {}, engineering(best.speed, 'rad/s')), ': ' + zones);
    const list = (values, unit) => Array.from(values, (v) => v / unit.divisor);
    this.plots[0].redraw(false);
    this.plots[1].setData(
        [this.plots[1].data[0], this.plots[1].data[1], this.plots[1].data[2], list(best.traction, this.tractionUnit)]);
    this.plots[2].setData([this.plots[2].data[0], this.plots[2].data[1], list(best.layer, this.velocityUnit)]);
  }
}

/** The card of the fields; of several curves one is chosen. */
export function fieldsSection(list, names, chosen) {
  const all = list.map(readFields);
  if (!all.some(Boolean)) return null;
  const node = card(
      'In the contact',
      'One contact of the wave at one speed: where the layer sticks to the stator, where it slips, and what that ' +
          'does. The colour of the ground names the zone.',
      'wide');
  const title = el('div', {class: 'read', 'aria-live': 'polite', 'data-fields': 'title'});
  const slider = el('input', {type: 'range', min: 0, max: 1000, value: 700, 'aria-label': 'speed'});
  const choice = el('select', {'aria-label': 'curve'}, names.map((name, i) => el('option', {value: i}, name)));
  const body = el('div', {});
  let viewer = null;
  let maps = null;
  let speed = null;
  const showAt = (s) => {
    viewer.show(s);
    maps?.show(s);
  };
  const at = () => {
    const f = viewer.fields.frames;
    return (f[f.length - 1].speed * slider.value) / 1000;
  };
  // At peak power a contact does everything it can.
  const start = (k) => {
    const peak = list[k].metrics.speed_at_peak_power;
    const last = viewer.fields.frames[viewer.fields.frames.length - 1].speed;
    if (!(peak > 0 && peak < last)) return at();
    slider.value = Math.round((1000 * peak) / last);
    return peak;
  };
  const build = (k) => {
    if (!all[k]) return;
    const panels = [el('div', {}), el('div', {}), el('div', {})];
    body.replaceChildren(el('div', {class: 'triple'}, panels[0], panels[1], panels[2]));
    viewer = new FieldsViewer(panels, all[k], title);
    const over = el('div', {});
    body.append(over);
    maps = trackMaps(over, list[k]);
    showAt(speed === null ? start(k) : speed);
  };
  slider.addEventListener('input', () => {
    speed = at();
    showAt(speed);
  });
  choice.addEventListener('change', () => build(Number(choice.value)));
  node.append(
      el('div', {class: 'tools'}, list.length > 1 ? el('label', {}, 'curve ', choice) : null,
         el('label', {}, 'speed ', slider)),
      title, legend([
        {name: 'slip+: the stator drives', colour: 'slip-plus', kind: 'area'},
        {name: 'stick', colour: 'stick', kind: 'area'},
        {name: 'slip-: the stator brakes', colour: 'slip-minus', kind: 'area'},
        {name: 'friction bound', colour: 'soft', kind: 'dash'}, {name: 'stator', colour: 'c0'},
        {name: 'layer', colour: 'c1', kind: 'dash'}
      ]),
      body);
  choice.value = chosen;
  build(all[chosen] ? chosen : all.findIndex(Boolean));
  return {
    show(s) {
      speed = s;
      const f = viewer.fields.frames;
      slider.value = Math.round((1000 * s) / f[f.length - 1].speed);
      showAt(s);
    },
  };
}
