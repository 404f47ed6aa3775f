// What Python wrote: numbers as base64 of little-endian floats, `fixed` where nothing changes.
const data = JSON.parse(document.getElementById("pydy-data").textContent);

function unpacked(text, Kind) {
  const raw = atob(text);
  const bytes = new Uint8Array(raw.length);
  for (let i = 0; i < raw.length; i++) bytes[i] = raw.charCodeAt(i);
  return new Kind(bytes.buffer);
}

const times = unpacked(data.times, Float64Array);
const start = times[0], end = times[times.length - 1];

/** Rows of `width` numbers, one for each of the times or one for all. */
class Column {
  constructor(entry) {
    this.width = entry.width;
    this.fixed = entry.fixed !== undefined;
    this.values = this.fixed ? Float32Array.from(entry.fixed) : unpacked(entry.rows, Float32Array);
  }
  offset(k) { return this.fixed ? 0 : k * this.width; }
  /** Write the row between frames k and k + 1 into `out`. */
  blend(k, part, out) {
    const v = this.values, w = this.width, o = this.offset(k);
    if (this.fixed || part === 0) for (let i = 0; i < w; i++) out[i] = v[o + i];
    else for (let i = 0; i < w; i++) out[i] = v[o + i] + part * (v[o + w + i] - v[o + i]);
    return out;
  }
}

/** Where a time lies: `k`, the frame before it, and `part`, how far on the way to the next. */
const now = { time: start, k: 0, part: 0 };

function locate(time) {
  let k = now.k;
  if (!(times[k] <= time && (k + 1 >= times.length || time < times[k + 1]))) {
    let low = 0, high = times.length - 1;
    while (low < high) {
      const middle = (low + high + 1) >> 1;
      if (times[middle] <= time) low = middle; else high = middle - 1;
    }
    k = low;
  }
  now.time = time;
  now.k = k;
  now.part = k + 1 < times.length ? (time - times[k]) / (times[k + 1] - times[k]) : 0;
}
