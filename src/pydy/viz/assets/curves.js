// Curves over time, at times of their own: a jump is two points at one time, a gap is NaN.
const clocks = data.clocks.map((text) => unpacked(text, Float64Array));
const series = data.series.map((entry) => ({ ...entry, times: clocks[entry.clock], values: unpacked(entry.values, Float64Array) }));

/** A curve's value at a time, between two points on the line; at a jump, the value after it. */
function valueAt({ times: own, values }, time) {
  let low = 0, high = own.length - 1;
  if (high < 0) return NaN;
  while (low < high) {
    const middle = (low + high + 1) >> 1;
    if (own[middle] <= time) low = middle; else high = middle - 1;
  }
  const gap = low + 1 < own.length ? own[low + 1] - own[low] : 0;
  const part = gap > 0 ? Math.max(0, (time - own[low]) / gap) : 0;
  return part > 0 ? values[low] + part * (values[low + 1] - values[low]) : values[low];
}
