// SPDX-License-Identifier: Apache-2.0
// Pressure and slip over the track of a motor with width: phase across, radius up, zones of stick outlined.

import {numbers} from './bytes.js';
import {colour, el} from './dom.js';
import {figure} from './figure.js';
import {degree} from './names.js';
import {rampColour, rampLegend} from './ramp.js';
import {displayUnit, engineering, largest} from './units.js';

/** Frames of a curve with a track, as typed arrays; null for one slice. */
function readTrack({track}) {
  if (!track) return null;
  const floats = (text) => numbers(text, Float32Array);
  const frames = track.frames.map((f) => ({...f, slip: floats(f.slip)}));
  return {phase: floats(track.phase), radius: floats(track.radius), pressure: floats(track.pressure), frames};
}

/** Edges of cells about these places. */
function edgesOf(places) {
  const n = places.length;
  const half = (places[n - 1] - places[0]) / (n - 1) / 2;
  return Float64Array.from({length: n + 1}, (_, i) => (i < n ? places[i] - half : places[n - 1] + half));
}

/** Parts of the phase in which just one of two rows sticks: where an outline runs between them. */
function apart(a, b) {
  const ends = [...a, ...b].flat().sort((p, q) => p - q);
  const inside = (list, v) => list.some(([from, to]) => v > from && v < to);
  const middle = (i) => (ends[i] + ends[i + 1]) / 2;
  return ends.slice(1)
      .map((end, i) => [ends[i], end, i])
      .filter(([from, to, i]) => to > from && inside(a, middle(i)) !== inside(b, middle(i)));
}

/** Outlines the zones of stick. rows: zones of each radius */
function outline(u, rows, edges) {
  const {ctx} = u;
  const x = (phase) => u.valToPos(phase / degree, 'x', true);
  const y = (radius) => u.valToPos(radius * 1e3, 'y', true);
  const sticking = rows.map((zones) => zones.filter(([state]) => state === 0).map(([, from, to]) => [from, to]));
  const path = (draw) => {
    ctx.beginPath();
    draw();
    for (const [name, width] of Object.entries({card: 3.5, ink: 1.5})) {
      ctx.lineWidth = width * devicePixelRatio;
      ctx.strokeStyle = colour(name);
      ctx.stroke();
    }
  };
  path(() => {
    const line = (x0, y0, x1, y1) => {
      ctx.moveTo(x0, y0);
      ctx.lineTo(x1, y1);
    };
    [...sticking, []].forEach((row, i) => {
      for (const end of row.flat()) line(x(end), y(edges[i]), x(end), y(edges[i + 1]));
      for (const [from, to] of apart(sticking[i - 1] ?? [], row)) line(x(from), y(edges[i]), x(to), y(edges[i]));
    });
  });
}

/** One quantity over the track. */
class TrackMap {
  /** values(frame): of each radius after the other; largest: of all frames */
  constructor(node, track, phase, {name, unit, most, values}) {
    this.track = track;
    this.frame = track.frames[0];
    this.values = values;
    this.most = most || 1;
    const shown = displayUnit(most, unit);
    this.x = edgesOf(track.phase);
    this.y = edgesOf(track.radius);
    const range = (edges, scale) => [edges[0] * scale, edges[edges.length - 1] * scale];
    const [rx, ry] = [range(this.x, 1 / degree), range(this.y, 1e3)];
    node.append(rampLegend(name, '0', engineering(most, unit, 3)));
    this.plot = figure(node, rx, [{name, y: ry, colour: 'c0', hidden: true}], {
      name: 'track ' + name,
      title: name + ' over the track' + (shown.text ? ' [' + shown.text + ']' : ''),
      x: {label: phase + ' [deg]', range: rx},
      y: {label: 'radius [mm]', range: ry},
      height: 240,
      points: false,
      front: (u) => this.paint(u)
    });
  }

  paint(u) {
    const {ctx} = u;
    const n = this.track.phase.length;
    const values = this.values(this.frame);
    const px = Array.from(this.x, (v) => u.valToPos(v / degree, 'x', true));
    const py = Array.from(this.y, (v) => u.valToPos(v * 1e3, 'y', true));
    ctx.save();
    ctx.beginPath();
    ctx.rect(u.bbox.left, u.bbox.top, u.bbox.width, u.bbox.height);
    ctx.clip();
    values.forEach((v, k) => {
      if (!Number.isFinite(v)) return;
      const [i, j] = [k % n, Math.floor(k / n)];
      ctx.fillStyle = rampColour(v / this.most);
      ctx.fillRect(px[i], py[j + 1], px[i + 1] - px[i] + 0.7, py[j] - py[j + 1] + 0.7);
    });
    outline(u, this.frame.zones, this.y);
    ctx.restore();
  }

  show(frame) {
    if (frame === this.frame) return;
    this.frame = frame;
    this.plot.redraw(false);
  }
}

/**
 * The maps of a curve with a track, phase: what is across; null for one slice. show(speed) shows the stored speed
 * nearest to it.
 */
export function trackMaps(node, curve, phase) {
  const track = readTrack(curve);
  if (!track) return null;
  const note =
      'The contact at every radius of the track, zones of stick outlined; the charts above are at the contact radius.';
  const [left, right] = [el('div', {}), el('div', {})];
  node.append(el('h3', {}, 'Over the track'), el('p', {class: 'soft'}, note), el('div', {class: 'pair'}, left, right));
  const maps = [
    new TrackMap(
        left, track, phase,
        {name: 'pressure', unit: 'Pa', most: largest([track.pressure]), values: () => track.pressure}),
    new TrackMap(
        right, track, phase,
        {name: 'slip speed', unit: 'm/s', most: largest(track.frames.map((f) => f.slip)), values: (f) => f.slip})
  ];
  return {
    show(speed) {
      const nearer = (a, b) => (Math.abs(b.speed - speed) < Math.abs(a.speed - speed) ? b : a);
      const frame = track.frames.reduce(nearer);
      for (const map of maps) map.show(frame);
    }
  };
}
