// SPDX-License-Identifier: Apache-2.0
// Zones of stick and slip under a chart over the phase of the wave.

import {colour, legend} from './dom.js';
import {degree, zoneColours, zoneNames} from './names.js';

/** Both ends of a zone on the canvas, within the plot. */
function zoneEnds(u, from, to) {
  const {min, max} = u.scales.x;
  return [from, to].map((v) => u.valToPos(Math.min(Math.max(v / degree, min), max), 'x', true));
}

/** Paints the ground. zones: [[state, from, to], ...] with phases [rad] */
export function paintZones(u, zones) {
  for (const [state, from, to] of zones) {
    const [a, b] = zoneEnds(u, from, to);
    u.ctx.fillStyle = colour(zoneColours[state]);
    u.ctx.fillRect(a, u.bbox.top, b - a, u.bbox.height);
  }
}

/** Names the zones that are wide enough for it: colours alone would not do for every eye. */
export function nameZones(u, zones) {
  const {ctx} = u;
  ctx.save();
  ctx.font = 11 * devicePixelRatio + 'px system-ui, "Liberation Sans", Arial, sans-serif';
  ctx.textAlign = 'center';
  ctx.textBaseline = 'top';
  ctx.fillStyle = colour('ink');
  for (const [state, from, to] of zones) {
    const [a, b] = zoneEnds(u, from, to);
    if (b - a > ctx.measureText(zoneNames[state]).width + 4)
      ctx.fillText(zoneNames[state], (a + b) / 2, u.bbox.top + 3 * devicePixelRatio);
  }
  ctx.restore();
}

/** What the zones of charts over the phase are, and the lines that are not named by their axis. */
export function contactKey(charts) {
  const zones = [
    {name: 'slip+: the stator drives', colour: 'slip-plus', kind: 'area'},
    {name: 'stick', colour: 'stick', kind: 'area'},
    {name: 'slip-: the stator brakes', colour: 'slip-minus', kind: 'area'}
  ];
  const lines = charts.flatMap(({y, series}) => series.filter((s) => s.name !== y.name));
  return legend([
    ...zones, ...lines.map(({name, colour: c, stroke}) => ({name, colour: c, kind: stroke === 'dashes' ? 'dash' : ''}))
  ]);
}

/** The lines of a chart over the phase, with their values; a bound has two lines, above and below. */
export function contactLines({series}, values) {
  const spare = values.length - series.length;
  return values.map((y, i) => {
    const {name, colour: c, stroke} = series[Math.max(0, i - spare)];
    return {name, colour: c, y, dash: stroke === 'dashes' ? [5, 4] : undefined};
  });
}
