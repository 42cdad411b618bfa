// SPDX-License-Identifier: Apache-2.0
// The charts of the panel and what their colours mean.

import {drawMarks} from '../chart.js';
import {legend} from '../dom.js';
import {rpm} from '../units.js';

import {drawLoad, drawRegions, LiveChart} from './charts.js';

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
        ground: (u, shown) => shown.curve && drawRegions(u, shown, panel.state.view.limits),
        front: (u, shown) => drawOnTorque(panel, u, shown)
      },
      panel);
  node.prepend(legend([
    {name: 'torque', colour: 'c0'}, {name: 'load', colour: 'c6', kind: 'dash'},
    {name: 'pinned motor: thin dashes', colour: 'soft', kind: 'dash'}
  ]));
  return chart;
}

function powerChartOf(panel, node) {
  const lines = [
    {column: 'output_power', name: 'output', colour: 'c0'},
    {column: 'friction_power', name: 'friction loss', colour: 'c1'},
    {column: 'layer_loss', name: 'layer loss', colour: 'c2'}, {column: 'stator_loss', name: 'stator loss', colour: 'c3'}
  ];
  const chart = new LiveChart(node, {name: 'power', unit: 'W', height: 240, lines}, panel);
  node.prepend(legend(lines));
  return chart;
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

/** Torque, power and efficiency over speed; ofTerminals: the entry of the key that a motor without terminals hides. */
export function motorCharts(panel, torque, power, efficiency) {
  const last = efficiencyChart(panel, efficiency);
  return {charts: [torqueChart(panel, torque), powerChartOf(panel, power), last.chart], ofTerminals: last.ofTerminals};
}

export function zoneLegend() {
  return legend([
    {name: 'slip+: the stator drives', colour: 'slip-plus', kind: 'area'},
    {name: 'stick', colour: 'stick', kind: 'area'},
    {name: 'slip-: the stator brakes', colour: 'slip-minus', kind: 'area'},
    {name: 'friction bound', colour: 'soft', kind: 'dash'}, {name: 'stator', colour: 'c0'},
    {name: 'layer', colour: 'c1', kind: 'dash'}
  ]);
}
