// SPDX-License-Identifier: Apache-2.0
// Colours for values and for counts, and what they mean.

import {el, isDark, onTheme, svg} from './dom.js';

/** Ten colours from dark blue to yellow that keep their order in grey and for every colour vision. */
const ramp = [
  [0, 32, 77], [0, 52, 110], [54, 73, 108], [87, 92, 109], [112, 113, 115], [138, 134, 120], [166, 157, 117],
  [197, 180, 106], [228, 206, 87], [255, 234, 70]
];

/** The end of the ramp that is near the ground of the page is left out. */
export function rampColour(share) {
  const inside = Math.min(Math.max(share, 0), 1);
  const place = (isDark() ? 0.2 + 0.8 * inside : 0.93 * inside) * (ramp.length - 1);
  const i = Math.min(Math.floor(place), ramp.length - 2);
  return '#' +
      ramp[i].map((v, k) => Math.round(v + (ramp[i + 1][k] - v) * (place - i)).toString(16).padStart(2, '0')).join('');
}

/** Smallest and largest value, and a value's place between them. */
export function extent(values) {
  let [low, high] = [Infinity, -Infinity];
  for (const v of values)
    if (Number.isFinite(v)) {
      if (v < low) low = v;
      if (v > high) high = v;
    }
  return {low, high, share: (v) => (high > low ? (v - low) / (high - low) : 0.5)};
}

/** A strip of the colours between the texts of both ends. */
export function rampLegend(name, low, high) {
  const strip = svg('svg', {width: 160, height: 12, 'aria-hidden': 'true'});
  const bar = (_, i) => svg('rect', {x: 4 * i, y: 0, width: 4.5, height: 12, fill: rampColour(i / 39)});
  const paint = () => strip.replaceChildren(...Array.from({length: 40}, bar));
  paint();
  onTheme(paint);
  return el('div', {class: 'legend'}, el('span', {}, name), el('span', {}, low, strip, high));
}

/** A colour such as #0072b2 as one pixel, little-endian RGBA. */
export function packed(hex) {
  const value = parseInt(hex.slice(1), 16);
  return ((255 << 24) | ((value & 255) << 16) | (value & 0xff00) | (value >> 16)) >>> 0;
}
