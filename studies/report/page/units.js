// SPDX-License-Identifier: Apache-2.0
// Values as engineers write them: the prefix that leaves one to three digits before the point, speeds in rpm.

/** @type {[string, number][]} */
const prefixes =
    [['T', 1e12], ['G', 1e9], ['M', 1e6], ['k', 1e3], ['', 1], ['m', 1e-3], ['µ', 1e-6], ['n', 1e-9], ['p', 1e-12]];

/** SI value of a revolution per minute [rad/s]. */
export const rpm = Math.PI / 30;

/** Between a number and its unit: they stay on one line. */
export const noBreak = '\u00a0';

/** A unit as one reads it: "N·m" and "W/m²" for N.m and W/m^2. */
export function unitText(unit) { return unit.replaceAll('.', '·').replaceAll('^2', '²').replaceAll('^3', '³'); }

/** A prefix before a bare kg, a 1 or a power would be wrong: mm² is a millionth of m². */
function takesPrefix(unit) {
  if (unit.startsWith('kg') || unit.startsWith('%') || unit.startsWith('1')) return false;
  const end = unit.search(/[./^(]/);
  return end < 0 || (unit[end] !== '^' && unit[end] !== '(');
}

/**
 * Unit in which a value of this size is shown.
 * @returns {{text: string, typed: string, divisor: number}} as one reads it, as one types it, and the SI value of one
 */
export function displayUnit(size, unit) {
  if (unit === '1' || !unit) return {text: '', typed: '', divisor: 1};
  if (unit === 'rad/s') return {text: 'rpm', typed: 'rpm', divisor: rpm};
  const magnitude = Math.abs(size);
  if (!takesPrefix(unit) || !(magnitude >= 1e-12) || !Number.isFinite(magnitude))
    return {text: unitText(unit), typed: unit, divisor: 1};
  const [prefix, divisor] = prefixes.find(([, value]) => magnitude >= value * (1 - 1e-9)) || ['', 1];
  return {text: prefix + unitText(unit), typed: (prefix === 'µ' ? 'u' : prefix) + unit, divisor};
}

export function largest(arrays) {
  let size = 0;
  for (const array of arrays)
    for (const v of array)
      if (Number.isFinite(v) && Math.abs(v) > size) size = Math.abs(v);
  return size;
}

/** A number to some digits, without trailing zeros. */
export function rounded(value, digits = 4) {
  if (value === null || value === undefined || !Number.isFinite(value)) return '-';
  const text = Number(value.toPrecision(digits));
  const size = Math.abs(text);
  return size !== 0 && (size < 1e-4 || size >= 1e7) ? text.toExponential() : String(text);
}

/** An SI value as people say it: "1.6 µm", "141.6 rpm". */
export function engineering(value, unit, digits = 4) {
  if (value === null || value === undefined || !Number.isFinite(value)) return '-';
  const shown = displayUnit(value, unit);
  return rounded(value / shown.divisor, digits) + (shown.text ? noBreak + shown.text : '');
}

/** The same of a difference or a spread: what is rounding of values of the scale is 0. */
export function spreadText(value, unit, scale, digits = 3) {
  return Math.abs(value) <= 1e-9 * Math.abs(scale) ? '0' : engineering(value, unit, digits);
}

/** "0.8 to 2.2 µm" */
export function between(low, high, unit) {
  const shown = displayUnit(Math.max(Math.abs(low), Math.abs(high)), unit);
  return rounded(low / shown.divisor) + ' to ' + rounded(high / shown.divisor) +
      (shown.text ? noBreak + shown.text : '');
}

export function percent(share, digits = 3) {
  return share === null || !Number.isFinite(share) ? '-' : rounded(100 * share, digits) + noBreak + '%';
}

/** radial_slices as a file has it: 0 is auto, -N auto with N slices a panel. */
export function slicesText(value) {
  if (value > 0) return String(value);
  return value === 0 ? 'auto' : 'auto ' + -value;
}
