// The curve of a simulation in the page: every sample of it, thinned like `thinned` of pydy/viz/curves.py.
const BUCKETS = data.live.buckets, MOST = 14 * BUCKETS; // twice what a thinned curve can have

/** A curve that grows. Its two arrays stay the same ones, so that what draws the curve needs no update. */
class Samples {
  constructor() {
    this.times = [];
    this.values = [];
  }
  add(time, value) {
    const { times: own, values } = this, last = own.length - 1;
    if (last >= 0 && own[last] === time && Object.is(values[last], value)) return;
    own.push(time);
    values.push(value);
    if (own.length > MOST) this.thin();
  }
  /** Of each part of the time keep the first, lowest, highest and last point, the largest jump, and one point of a gap. */
  thin() {
    const { times: own, values } = this, kept = [];
    const part = (k) => Math.min(Math.floor(BUCKETS * ((own[k] - start) / (end - start || 1))), BUCKETS - 1);
    for (let from = 0, to = 0; from < own.length; from = to) {
      const rows = new Set([from]), here = part(from);
      let low = -1, high = -1, gap = -1, jump = -1, size = 0;
      for (to = from; to < own.length && part(to) === here; to++) {
        const value = values[to];
        if (!Number.isFinite(value)) {
          if (gap < 0) gap = to;
          continue;
        }
        if (low < 0 || value < values[low]) low = to;
        if (high < 0 || value > values[high]) high = to;
        const change = to > from && own[to] === own[to - 1] ? Math.abs(value - values[to - 1]) : 0;
        if (change > size && Number.isFinite(values[to - 1])) [size, jump] = [change, to];
      }
      for (const k of [low, high, gap, jump, jump - 1, to - 1]) if (k >= 0) rows.add(k);
      kept.push(...[...rows].sort((a, b) => a - b));
    }
    kept.forEach((k, n) => { // n is at most k: nothing is overwritten before it is read
      own[n] = own[k];
      values[n] = values[k];
    });
    own.length = values.length = kept.length;
  }
}
