// SPDX-License-Identifier: Apache-2.0
'use strict';
// Values as engineers write them: the prefix that leaves one to three digits before the point, speeds in rpm.

/** @type {[string, number][]} */
const prefixes = [['T', 1e12], ['G', 1e9], ['M', 1e6], ['k', 1e3], ['', 1], ['m', 1e-3], ['u', 1e-6], ['n', 1e-9], ['p', 1e-12]];

/** Between a number and its unit: they stay on one line. */
const noBreak = '\u00a0';

/** Unit in which a value of this size is shown, and the SI value of one of it. */
function displayUnit(size, unit) {
  if (unit === '1' || !unit) return { text: '', divisor: 1 };
  if (unit === 'rad/s') return { text: 'rpm', divisor: Math.PI / 30 };
  const magnitude = Math.abs(size);
  if (unit.startsWith('kg') || unit.startsWith('%') || !(magnitude >= 1e-12) || !Number.isFinite(magnitude)) return { text: unit, divisor: 1 };
  const [prefix, divisor] = prefixes.find(([, value]) => magnitude >= value * (1 - 1e-9)) || ['', 1];
  return { text: prefix + unit, divisor };
}

function largest(arrays) {
  let size = 0;
  for (const array of arrays) for (const v of array) if (Number.isFinite(v) && Math.abs(v) > size) size = Math.abs(v);
  return size;
}

/** A number to some digits, without trailing zeros. */
function rounded(value, digits = 4) {
  if (value === null || value === undefined || !Number.isFinite(value)) return '-';
  const text = Number(value.toPrecision(digits));
  const size = Math.abs(text);
  return size !== 0 && (size < 1e-4 || size >= 1e7) ? text.toExponential() : String(text);
}

/** An SI value as people say it: "1.6 um", "141.6 rpm". */
function engineering(value, unit, digits = 4) {
  if (value === null || value === undefined || !Number.isFinite(value)) return '-';
  const shown = displayUnit(value, unit);
  return rounded(value / shown.divisor, digits) + (shown.text ? noBreak + shown.text : '');
}

/** "0.8 to 2.2 um" */
function between(low, high, unit) {
  const shown = displayUnit(Math.max(Math.abs(low), Math.abs(high)), unit);
  return rounded(low / shown.divisor) + ' to ' + rounded(high / shown.divisor) + (shown.text ? noBreak + shown.text : '');
}

function percent(share, digits = 3) {
  return share === null || !Number.isFinite(share) ? '-' : rounded(100 * share, digits) + noBreak + '%';
}
