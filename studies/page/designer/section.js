// SPDX-License-Identifier: Apache-2.0
// The motor cut along its axis, to scale: one side of the ring, the inner edge at the left.

import {el, legend, svg} from '../dom.js';
import {engineering} from '../units.js';

/**
 * Rectangles of a motor: inner and outer radius, lower and upper height [m], colour, name. Height 0 is the stator's
 * surface.
 */
function sectionParts(motor) {
  const v = motor.values;
  const [inner, outer] = [v.contact_radius - 0.5 * v.contact_width, v.contact_radius + 0.5 * v.contact_width];
  const rotor = [{inner, outer, low: 0, high: v.thickness, colour: 'stick', name: 'contact layer'}];
  if (v.substrate_thickness === undefined) {
    const a = v.neutral_plane_distance;
    return [
      ...rotor, {inner, outer, low: -2 * a, high: 0, colour: 'body', name: 'stator, as deep as twice the neutral plane'}
    ];
  }
  const teeth = v.teeth_height ?? 0;
  const plate = -teeth - v.substrate_thickness;
  const glue = v.glue_thickness ?? 0;
  const parts = [
    ...rotor, {
      inner: v.substrate_inner_radius,
      outer: v.substrate_outer_radius,
      low: plate,
      high: -teeth,
      colour: 'body',
      name: 'metal'
    },
    {
      inner: v.ceramic_inner_radius,
      outer: v.ceramic_outer_radius,
      low: plate - glue - v.ceramic_thickness,
      high: plate - glue,
      colour: 'c2',
      name: 'ceramic'
    }
  ];
  if (teeth)
    parts.push({
      inner: v.teeth_inner_radius,
      outer: v.teeth_outer_radius,
      low: -teeth,
      high: 0,
      colour: 'faint',
      name: 'teeth'
    });
  if (glue)
    parts.push({
      inner: v.ceramic_inner_radius,
      outer: v.ceramic_outer_radius,
      low: plate - glue,
      high: plate,
      colour: 'c1',
      name: 'glue'
    });
  if (v.web_thickness !== undefined)
    parts.push({
      inner: v.web_inner_radius,
      outer: v.web_outer_radius,
      low: plate + 0.5 * (v.substrate_thickness - v.web_thickness),
      high: plate + 0.5 * (v.substrate_thickness + v.web_thickness),
      colour: 'c6',
      name: 'web'
    });
  return parts;
}

export class SectionView {
  constructor(node) {
    this.picture = svg('svg', {class: 'section', role: 'img', 'aria-label': 'Cross-section'});
    this.legend = el('div', {class: 'legend'});
    node.append(this.picture, this.legend);
  }

  show(motor) {
    const parts = sectionParts(motor);
    if (!parts.every((p) => [p.inner, p.outer, p.low, p.high].every(Number.isFinite))) return;
    const [inner, outer] = [Math.min(...parts.map((p) => p.inner)), Math.max(...parts.map((p) => p.outer))];
    const [low, high] = [Math.min(...parts.map((p) => p.low)), Math.max(...parts.map((p) => p.high))];
    // the picture is 104 units wide
    const unit = (outer - inner) / 100;
    const depth = (high - low) / unit;
    // letters of 11 px, whichever of width and height limits the picture
    const letters = 11 / Math.min((this.picture.clientWidth || 600) / 104, 250 / (depth + 10));
    this.picture.setAttribute('viewBox', `-2 -2 104 ${depth + 8 + letters}`);
    const box = (p) => svg('rect', {
      x: (p.inner - inner) / unit,
      y: (high - p.high) / unit,
      width: (p.outer - p.inner) / unit,
      height: Math.max((p.high - p.low) / unit, 0.25),
      class: 'fill-' + p.colour
    });
    this.picture.replaceChildren(...parts.map(box), ...this.scale(unit, depth, letters));
    const names = parts.map((p) => p.name).join();
    if (names === this.names) return;
    this.names = names;
    this.legend.replaceChildren(legend(parts.map((p) => ({name: p.name, colour: p.colour, kind: 'area'}))));
  }

  /** A bar of a round length. */
  scale(unit, depth, letters) {
    const size = 10 ** Math.floor(Math.log10(40 * unit));
    const length = [5, 2, 1].map((n) => n * size).find((l) => l <= 40 * unit);
    const bar = svg('line', {x1: 0, x2: length / unit, y1: depth + 4, y2: depth + 4, class: 'bar'});
    const text =
        svg('text', {x: 1.5 + length / unit, y: depth + 4 + 0.35 * letters, 'font-size': letters},
            engineering(length, 'm'));
    return [bar, text];
  }
}
