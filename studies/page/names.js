// SPDX-License-Identifier: Apache-2.0
// Names of parameters, metrics and zones as one reads them, and the colours of zones.

const nameWords = {
  youngs_modulus: 'Young\'s modulus',
  poisson_ratio: 'Poisson ratio',
  amplitude: 'wave amplitude',
  frequency: 'drive frequency',
  wavelengths: 'number of wavelengths',
  no_load_speed: 'no-load speed'
};

export function shortName(name) { return Object.hasOwn(nameWords, name) ? nameWords[name] : name.replaceAll('_', ' '); }

/** What a metric of a point measures: "electrical power" for electrical_power_at. */
export function pointName(metric) { return shortName(metric.endsWith('_at') ? metric.slice(0, -3) : metric); }

export function capital(text) { return text.charAt(0).toUpperCase() + text.slice(1); }

export const zoneColours = {
  1: 'slip-plus',
  0: 'stick',
  '-1': 'slip-minus'
};
export const zoneNames = {
  1: 'slip+',
  0: 'stick',
  '-1': 'slip-'
};
export const degree = Math.PI / 180;
