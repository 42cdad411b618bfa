// SPDX-License-Identifier: Apache-2.0
// Values as engineers write them. The units come with the page; here one is chosen and the number rounded.

/**
 * The units in which values of an SI unit are shown, largest first; display_units() of the program.
 * @type {Record<string, {text: string, typed: string, divisor: number}[]>}  as one reads it, as one types it, and the
 *     SI value of one
 */
const shownUnits = JSON.parse(document.getElementById('units').textContent);

/** SI value of a revolution per minute [rad/s]. */
export const rpm = shownUnits['rad/s'][0].divisor;

/** Between a number and its unit: they stay on one line. */
export const noBreak = '\u00a0';

function unitsOf(unit) {
  const units = shownUnits[unit || '1'];
  if (!units) console.error('no units in which to show ' + unit);
  return units ?? [{text: unit, typed: unit, divisor: 1}];
}

/** Unit in which a value of this size has one to three digits before the point, where the unit takes a prefix. */
export function displayUnit(size, unit) {
  const units = unitsOf(unit);
  const magnitude = Math.abs(size);
  const fits = (u) => Number.isFinite(magnitude) && magnitude >= u.divisor * (1 - 1e-9);
  return units.find(fits) ?? units.find((u) => u.divisor === 1) ?? units[0];
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

/** "0.8 to 2.2 µm" */
export function between(low, high, unit) {
  const shown = displayUnit(Math.max(Math.abs(low), Math.abs(high)), unit);
  return rounded(low / shown.divisor) + ' to ' + rounded(high / shown.divisor) +
      (shown.text ? noBreak + shown.text : '');
}

/** A share in per cent. Of one near 1, what is missing has two digits: 99.9985 %. */
export function percent(share, digits = 3) {
  if (share === null || !Number.isFinite(share)) return '-';
  const near = share > 0.9 && share < 1 ? 2 + Math.floor(-Math.log10(1 - share)) : 0;
  return rounded(100 * share, Math.min(Math.max(digits, near), 12)) + noBreak + '%';
}

/** radial_slices as a file has it: 0 is auto, -N auto with N slices a panel. */
export function slicesText(value) {
  if (value > 0) return String(value);
  return value === 0 ? 'auto' : 'auto ' + -value;
}
