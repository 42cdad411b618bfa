// SPDX-License-Identifier: Apache-2.0
// The charts of the panel and what their colours mean.

import {drawMarks, drawSqueals} from '../chart.js';
import {legend} from '../dom.js';
import {rpm} from '../units.js';

import {drawLoad, drawRegions, LiveChart} from './charts.js';
import {Squeals} from './squeals.js';

/** Where the motor squeals, and what limits forbid, below the torque. */
function drawBelowTorque(panel, u, shown) {
  drawSqueals(u, [panel.squeals.ranges]);
  drawRegions(u, shown, panel.state.view.limits);
}

/** The load and what was measured, over the torque. */
function drawOnTorque(panel, u, shown) {
  drawLoad(u, shown, panel.state.view.load, panel.meeting);
  if (!panel.measured) return;
  const points =
      panel.measured.map((p) => ({x: p.speed / rpm, y: p.torque / shown.unit.divisor, colour: 'c1', small: true}));
  drawMarks(u, points);
}

function torqueChart(panel, node) {
  const chart = new LiveChart(
      node, {
        name: 'torque',
        unit: 'N.m',
        height: 300,
        lines: [{column: 'torque', name: 'torque', colour: 'c0'}],
        ground: (u, shown) => shown.curve && drawBelowTorque(panel, u, shown),
        front: (u, shown) => drawOnTorque(panel, u, shown)
      },
      panel);
  const key = legend([
    {name: 'torque', colour: 'c0'}, {name: 'load', colour: 'c6', kind: 'dash'},
    {name: 'pinned motor: thin dashes', colour: 'soft', kind: 'dash'}, {name: 'squeals', colour: 'c0', kind: 'broad'}
  ]);
  node.prepend(key);
  const squeals = new Squeals(panel, chart, /** @type {HTMLElement} */ (key.lastElementChild));
  return {chart, squeals};
}

function powerChartOf(panel, node) {
  const lines = [
    {column: 'output_power', name: 'output', colour: 'c0'},
    {column: 'friction_power', name: 'friction loss', colour: 'c1'},
    {column: 'layer_loss', name: 'layer loss', colour: 'c2'},
    {column: 'stator_loss', name: 'stator loss', colour: 'c3'},
    {column: 'electrical_power', name: 'input', colour: 'c6'}
  ];
  const chart = new LiveChart(node, {name: 'power', unit: 'W', height: 240, lines}, panel);
  const key = legend(lines);
  node.prepend(key);
  return {chart, ofTerminals: key.lastElementChild};
}

function efficiencyChart(panel, node) {
  const lines = [
    {column: 'efficiency', name: 'motor', colour: 'c0'},
    {column: 'contact_efficiency', name: 'contact alone', colour: 'c1'},
    {column: 'overall_efficiency', name: 'at the terminals', colour: 'c3'}
  ];
  const chart = new LiveChart(node, {name: 'efficiency', unit: '%', top: 100, height: 240, lines}, panel);
  const key = legend(lines);
  node.prepend(key);
  return {chart, ofTerminals: key.lastElementChild};
}

/** Torque, power and efficiency over speed; ofTerminals: entries of the keys that a motor without terminals hides. */
export function motorCharts(panel, torque, power, efficiency) {
  const {chart, squeals} = torqueChart(panel, torque);
  const others = [powerChartOf(panel, power), efficiencyChart(panel, efficiency)];
  return {
    charts: [chart, ...others.map((one) => one.chart)],
    squeals,
    ofTerminals: others.map((one) => /** @type {HTMLElement} */ (one.ofTerminals))
  };
}
