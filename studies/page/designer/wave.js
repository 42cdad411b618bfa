// SPDX-License-Identifier: Apache-2.0
// One contact in slow motion: the wave that runs under the rotor, where the layer sticks and slips, and the fields of
// that moment.

import {chart, paddedRange} from '../chart.js';
import {colour, el, onTheme} from '../dom.js';
import {degree, zoneColours} from '../names.js';
import {displayUnit, largest} from '../units.js';
import {contactLines, nameZones, paintZones} from '../zones.js';

import {axisText} from './charts.js';

/** A canvas as sharp as the screen; its context, width and height in CSS pixels. */
export function surface(canvas) {
  const ratio = devicePixelRatio || 1;
  const [width, height] = [canvas.clientWidth, canvas.clientHeight];
  if (canvas.width !== Math.round(width * ratio) || canvas.height !== Math.round(height * ratio)) {
    canvas.width = Math.round(width * ratio);
    canvas.height = Math.round(height * ratio);
  }
  const ctx = canvas.getContext('2d');
  ctx.setTransform(ratio, 0, 0, ratio, 0, 0);
  ctx.clearRect(0, 0, width, height);
  return {ctx, width, height};
}

/** Colours are looked up once for a theme: a picture has hundreds of strokes. */
function waveColours() {
  return Object.fromEntries([
    'ink', 'soft', 'grid', 'line', 'card', 'c1', 'slip-plus', 'stick', 'slip-minus', 'body', 'rotor'
  ].map((name) => [name, colour(name)]));
}

export class WaveView {
  constructor(node) {
    this.canvas = el('canvas', {
      class: 'wave',
      role: 'img',
      'aria-label': 'The travelling wave under the rotor, slowed down; the amplitude is enlarged'
    });
    node.append(this.canvas);
    this.phase = 0;
    this.shift = 0;
    this.colours = waveColours();
    onTheme(() => {
      this.colours = waveColours();
    });
  }

  /** @param {{zones: number[][], half: number, slip: number}} contact  slip: rotor speed over crest speed */
  show(contact) { this.contact = contact; }

  /** Moves the wave on by some seconds and draws it. */
  draw(seconds) {
    if (!this.contact) return;
    const {ctx, width, height} = surface(this.canvas);
    if (!width) return;
    const waves = width < 520 ? 1.5 : 2.5;
    this.phase += 1.3 * seconds;
    const place = {ctx, width, height, k: (2 * Math.PI * waves) / width, middle: 0.6 * height, rise: 0.19 * height};
    // Where the crest at x = 0 moves to the right, a point of the contact at phase theta = omega t - kappa x is
    // mirrored.
    this.drawLayer(place);
    this.drawStator(place);
    this.drawPoints(place, waves);
    this.drawRotor(place, seconds);
  }

  phaseAt(place, x) {
    const angle = this.phase - place.k * x;
    return angle - 2 * Math.PI * Math.round(angle / (2 * Math.PI));
  }

  surfaceAt(place, x) { return place.middle - place.rise * Math.cos(place.k * x - this.phase); }

  stateAt(angle) {
    for (const [state, from, to] of this.contact.zones)
      if (angle >= from && angle <= to) return state;
    return null;
  }

  /** The layer hangs under the rotor and is pressed where the wave reaches it. */
  drawLayer(place) {
    const {ctx, width} = place;
    const free = place.middle - place.rise * Math.cos(this.contact.half);
    for (let x = 0; x < width; x += 2) {
      const angle = this.phaseAt(place, x + 1);
      const state = Math.abs(angle) < this.contact.half ? this.stateAt(angle) : null;
      ctx.fillStyle = this.colours[state === null ? 'grid' : zoneColours[state]];
      const low = Math.abs(angle) < this.contact.half ? this.surfaceAt(place, x + 1) : free;
      ctx.fillRect(x, 26, 2, low - 26);
    }
  }

  drawStator(place) {
    const {ctx, width, height} = place;
    ctx.fillStyle = this.colours.body;
    ctx.strokeStyle = this.colours.ink;
    ctx.lineWidth = 1.5;
    ctx.beginPath();
    for (let x = 0; x <= width; x += 2) ctx.lineTo(x, this.surfaceAt(place, x));
    ctx.stroke();
    ctx.lineTo(width, height);
    ctx.lineTo(0, height);
    ctx.fill();
  }

  /** Points of the stator's surface on their ellipses: at a crest they move against the wave. */
  drawPoints(place, waves) {
    const {ctx, width} = place;
    const count = Math.round(8 * waves);
    ctx.fillStyle = this.colours.c1;
    for (let i = 0; i <= count; ++i) {
      const x = (i * width) / count;
      const angle = place.k * x - this.phase;
      ctx.beginPath();
      ctx.arc(x + 0.35 * place.rise * Math.sin(angle), this.surfaceAt(place, x) + 5, 3, 0, 2 * Math.PI);
      ctx.fill();
    }
  }

  drawRotor(place, seconds) {
    const {ctx, width, height} = place;
    ctx.fillStyle = this.colours.rotor;
    ctx.fillRect(0, 4, width, 22);
    const gap = 42;
    this.shift = (this.shift - 1.3 * seconds * this.contact.slip * 0.35 * place.rise) % gap;
    ctx.strokeStyle = this.colours.soft;
    ctx.beginPath();
    for (let x = this.shift + gap; x < width; x += gap) {
      ctx.moveTo(x, 6);
      ctx.lineTo(x, 24);
    }
    ctx.stroke();
    ctx.fillStyle = this.colours.ink;
    ctx.font = '12px system-ui, "Liberation Sans", Arial, sans-serif';
    ctx.textAlign = 'left';
    ctx.fillText('rotor \u2190', 8, 19);
    ctx.fillText('wave \u2192', 8, height - 8);
  }
}

/** Traction within its bounds, and the two surface velocities, over the phase of the wave. */
export class FieldsView {
  /** told: the charts of the contact without numbers */
  constructor(nodes, told) {
    this.zones = [];
    this.told = told;
    const [, traction, velocity] = told;
    const common = {
      x: {label: traction.x.name + ' [deg]', range: () => this.xRange ?? [-180, 180]},
      height: 200,
      ground: (u) => paintZones(u, this.zones),
      front: (u) => nameZones(u, this.zones)
    };
    const drawn = (node, of, empty, range) =>
        chart(node, [], contactLines(of, empty), {...common, name: of.name, y: {label: of.y.name, range}});
    this.traction = drawn(nodes[0], traction, [[], [], []], () => this.tractionRange ?? [-1, 1]);
    this.velocity = drawn(nodes[1], velocity, [[], []], () => this.velocityRange ?? [-1, 1]);
  }

  show(fields, half, friction) {
    this.zones = fields.zones;
    const reach = Math.min(Math.PI, 1.25 * half);
    const kept = [];
    fields.phase.forEach((p, i) => {
      if (Math.abs(p) <= reach) kept.push(i);
    });
    const list = (values, divisor) => kept.map((i) => values[i] / divisor);
    const phase = list(fields.phase, degree);
    const bound = displayUnit(friction * largest([fields.pressure]), 'Pa');
    const speed = displayUnit(largest([fields.stator, fields.layer]), 'm/s');
    this.xRange = [-reach / degree, reach / degree];
    const limit = list(fields.pressure, bound.divisor / friction);
    const top = 1.1 * Math.max(...limit, 1e-12);
    this.tractionRange = [-top, top];
    const [stator, layer] = [list(fields.stator, speed.divisor), list(fields.layer, speed.divisor)];
    this.velocityRange = paddedRange([stator, layer], true);
    this.traction.axes[1].label = axisText(this.told[1].y.name, bound);
    this.velocity.axes[1].label = axisText(this.told[2].y.name, speed);
    this.traction.setData([phase, limit, limit.map((v) => -v), list(fields.traction, bound.divisor)]);
    this.velocity.setData([phase, stator, layer]);
  }
}
