// SPDX-License-Identifier: Apache-2.0
// Where the motor squeals, found while nothing moves: a speed costs as much as a point of the curve for each slice.

// as many as in a report
const squealSpeeds = 51;

export class Squeals {
  /** @param {HTMLElement} entry  of the key, which a motor that does not squeal hides */
  constructor(panel, chart, entry) {
    this.panel = panel;
    this.chart = chart;
    this.entry = entry;
    this.forget();
  }

  /** The motor has changed. */
  forget() {
    this.ranges = [];
    this.entry.hidden = true;
  }

  /** Tasks that find the speeds, from rest on, and then draw them. */
  tasks() {
    /** @type {number[][]} */
    const found = [];
    let before = false;
    const hear = (i) => {
      const speed = (this.panel.now.last_speed * i) / (squealSpeeds - 1);
      const now = this.panel.core.squeals(speed);
      if (now && !before) found.push([speed, speed]);
      if (now) found[found.length - 1][1] = speed;
      before = now;
    };
    return [...Array.from({length: squealSpeeds}, (_, i) => () => hear(i)), () => this.show(found)];
  }

  show(ranges) {
    this.ranges = ranges;
    this.entry.hidden = !ranges.length;
    this.chart.plot.redraw(false);
  }
}
