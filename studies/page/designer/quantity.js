// SPDX-License-Identifier: Apache-2.0
// Numbers with units, as one types them. The units come with the page (units_json()).

import {displayUnit, engineering, noBreak} from '../units.js';

/** A unit in letters that every keyboard has: "µm" and "N·m" as "um" and "N.m". */
export function plainUnit(text) {
  return text.trim()
      .replace(/[µμ]/g, 'u')
      .replace(/[·⋅*]/g, '.')
      .replace(/²/g, '^2')
      .replace(/³/g, '^3')
      .replace(/Ω/g, 'ohm');
}

/** A decimal number times a factor; of a power of ten only the point moves, so that nothing is rounded twice. */
function scaledNumber(text, factor) {
  const power = Math.round(Math.log10(factor));
  const [mantissa, exponent] = text.toLowerCase().split('e');
  return Number('1e' + power) === factor ? Number(mantissa + 'e' + (Number(exponent ?? 0) + power)) :
                                           Number(text) * factor;
}

/** The factors of the units that will do where this SI unit is right. */
export function unitFactors(tables, unit) {
  return unit === '1' ? {'%': 0.01} : {...(tables.units[unit] ?? {[unit]: 1})};
}

const prefixes = {
  p: -12,
  n: -9,
  u: -6,
  m: -3,
  c: -2,
  d: -1,
  da: 1,
  h: 2,
  k: 3,
  M: 6,
  G: 9
};

/** The factor of a typed unit; a product may be typed without its points, and the SI unit with any prefix. */
function factorOf(factors, unit, typed) {
  const joined = (text) => text.replace(/[. ]/g, '');
  const known = Object.keys(factors).find((name) => name === typed || joined(name) === joined(typed));
  if (known !== undefined) return factors[known];
  const prefix = Object.keys(prefixes).find((p) => p + joined(unit) === joined(typed));
  return prefix && Number('1e' + prefixes[prefix]);
}

/**
 * Reads "1.6 um", or a bare number in the unit shown beside the field. An absolute temperature may stand in degC.
 * @returns {{value: number, error: string}} SI; the error is empty, or says what would be right
 */
export function readQuantity(tables, text, unit, bare, absolute = false) {
  const found = /^\s*([+-]?(?:\d+(?:[.,]\d*)?|[.,]\d+)(?:[eE][+-]?\d+)?)\s*(.*)$/s.exec(text);
  const factors = unitFactors(tables, unit);
  if (!found)
    return {value: NaN, error: 'is not a number; expected one such as ' + (unit === '1' ? '0.3' : '1.5 ' + unit)};
  const typed = plainUnit(found[2]);
  if (absolute && (typed === 'degC' || typed === '°C'))
    return {value: Number(found[1].replace(',', '.')) + 273.15, error: ''};
  const factor = typed === '' ? bare : typed === '1' && unit === '1' ? 1 : factorOf(factors, unit, typed);
  if (factor === undefined)
    return {
      value: NaN,
      error: 'has the unit ' + found[2].slice(0, 20) + ' that this page does not know here; expected one of ' +
          (unit === '1' ? 'no unit, %' : Object.keys(factors).join(', '))
    };
  return {value: scaledNumber(found[1].replace(',', '.'), factor), error: ''};
}

// of a number in a box that is not being typed in
const boxDigits = 8;

/**
 * A number as it fits into its box: one that takes more digits shows the first ones, and all when the box is chosen.
 */
export function boxNumber(text) {
  const short = String(Number(Number(text).toPrecision(boxDigits)));
  return Number.isFinite(Number(text)) && short.length < text.length ? short : text;
}

/** A quantity as it fits into its box: "657.432 mN·m". */
export function boxQuantity(value, unit) { return engineering(value, unit, boxDigits).replace(noBreak, ' '); }

/** The value in a unit, with as many digits as it takes to read the same number again. */
export function typedNumber(value, factor) {
  const power = Math.round(Math.log10(factor));
  if (Number('1e' + power) !== factor) return String(value / factor);
  const [mantissa, exponent] = value.toExponential().split('e');
  const shifted = Number(mantissa + 'e' + (Number(exponent) - power));
  return String(shifted);
}

/** "1.6 um": reads back as the same number. Speeds and other units that are no power of ten stay in SI. */
export function typedQuantity(value, unit) {
  if (unit === '1') return String(value);
  const shown = unit === 'rad/s' ? {typed: unit, divisor: 1} : displayUnit(value, unit);
  const text = typedNumber(value, shown.divisor);
  return scaledNumber(text, shown.divisor) === value ? text + ' ' + shown.typed : String(value) + ' ' + unit;
}
