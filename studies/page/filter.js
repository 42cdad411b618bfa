// SPDX-License-Identifier: Apache-2.0
// Which rows are chosen: an interval for some columns, shared by all views of the same rows.

export class Filter {
  constructor(columns, count) {
    this.columns = columns;
    this.count = count;
    this.intervals = new Map();
    this.listeners = [];
    this.chosen = new Uint8Array(count).fill(1);
    this.total = count;
  }

  onChange(listener) { this.listeners.push(listener); }

  /** Keeps rows whose value lies between; null on a side leaves it open. */
  set(index, low, high) {
    if ((low === null || low === -Infinity) && (high === null || high === Infinity))
      this.intervals.delete(index);
    else
      this.intervals.set(index, [low ?? -Infinity, high ?? Infinity]);
    this.apply();
  }

  /** Several intervals at once: [[index, low, high], ...] */
  setAll(list) {
    for (const [index, low, high] of list) this.intervals.set(index, [low, high]);
    this.apply();
  }

  clear() {
    this.intervals.clear();
    this.apply();
  }

  apply() {
    this.chosen.fill(1);
    for (const [index, [low, high]] of this.intervals) {
      const values = this.columns[index].values;
      for (let i = 0; i < this.count; ++i)
        if (!(values[i] >= low && values[i] <= high)) this.chosen[i] = 0;
    }
    this.total = 0;
    for (let i = 0; i < this.count; ++i) this.total += this.chosen[i];
    for (const listener of this.listeners) listener();
  }
}
