// The plot strip: all series over time, drawn once, and a cursor that moves over them.
const strip = document.getElementById("strip");
const curves = document.getElementById("strip-curves"), cursor = document.getElementById("strip-cursor");
const MARGIN = { left: 46, right: 8, top: 6, bottom: 20 };
strip.hidden = series.length === 0;

/** A label with its index lowered, and its unit. */
function typeset({ parts, unit }) {
  const [base, index] = parts, nodes = [base];
  if (index) {
    const sub = document.createElement("sub");
    sub.textContent = index;
    nodes.push(sub);
  }
  if (unit) nodes.push(` (${unit})`);
  return nodes;
}

for (const one of series) {
  const item = document.createElement("li"), key = document.createElement("i"), value = document.createElement("b");
  key.style.background = one.colour;
  item.append(key, ...typeset(one), value);
  document.getElementById("strip-labels").append(item);
  one.output = value;
}

let shared = false, lanes = 1;

/** One scale for all where all can be read on it, otherwise each has a lane of its own. */
function scaleSeries() {
  for (const one of series) {
    let low = Infinity, high = -Infinity;
    for (const v of one.values) if (Number.isFinite(v)) { low = Math.min(low, v); high = Math.max(high, v); }
    one.low = low;
    one.high = high;
  }
  const spans = series.map((s) => s.high - s.low).filter((span) => span > 0);
  const units = new Set(series.map((s) => s.unit));
  shared = spans.length > 0 && Math.max(...spans) <= 12 * Math.min(...spans) && units.size < 2;
  lanes = shared ? 1 : series.length;
  document.getElementById("strip-canvases").style.height = lanes > 1 ? `${26 + 62 * Math.min(lanes, 4)}px` : "";
  if (shared) {
    const low = Math.min(...series.map((s) => s.low)), high = Math.max(...series.map((s) => s.high));
    for (const one of series) Object.assign(one, { low, high });
  }
  for (const one of series) if (!(one.high > one.low)) {
    const middle = Number.isFinite(one.low) ? one.low : 0;
    Object.assign(one, { low: middle - 1, high: middle + 1 });
  }
}
scaleSeries();

/** About `count` round numbers from `low` to `high`, at least two: one alone says nothing of the scale. */
function ticks(low, high, count) {
  const rough = (high - low) / count, power = 10 ** Math.floor(Math.log10(rough));
  // Steps from the next larger one down. One of at most half the span has two multiples in it.
  const steps = [10, 5, 2, 1, 0.5, 0.2].filter((m, k, all) => !(all[k + 1] >= rough / power)).map((m) => m * power);
  let found = [];
  for (const step of steps) {
    const first = Math.ceil(low / step - 1e-9), last = Math.floor(high / step + 1e-9);
    // Beyond 2^53 there are no neighbouring whole numbers: `low` and `high` are the same to the eye.
    if (!(step > 0) || !(Math.max(Math.abs(first), Math.abs(last)) < 2 ** 53)) break;
    found = Array.from({ length: last - first + 1 }, (_, k) => (first + k) * step);
    if (found.length > 1) break;
  }
  return found;
}

function written(value) {
  if (value === 0) return "0";
  const size = Math.abs(value);
  return size >= 1e5 || size < 1e-3 ? value.toExponential(1) : String(Number(value.toPrecision(4)));
}

const duration = end - start || 1;
const plot = { width: 0, height: 0 };
const atTime = (t) => MARGIN.left + (plot.width - MARGIN.left - MARGIN.right) * (t - start) / duration;
const laneHeight = () => (plot.height - MARGIN.top - MARGIN.bottom) / lanes;
const laneFoot = (s) => MARGIN.top + ((shared ? 0 : series.indexOf(s)) + 1) * laneHeight() - (lanes > 1 ? 4 : 0);
const atValue = (s, v) => laneFoot(s) - (laneHeight() - (lanes > 1 ? 8 : 0)) * (v - s.low) / (s.high - s.low);

function prepared(element) {
  const ratio = Math.min(devicePixelRatio, 2);
  element.width = Math.round(plot.width * ratio);
  element.height = Math.round(plot.height * ratio);
  const g = element.getContext("2d");
  g.scale(ratio, ratio);
  return g;
}

let over = null;

function drawStrip() {
  if (strip.hidden) return;
  plot.width = curves.clientWidth;
  plot.height = curves.clientHeight;
  if (!plot.width || !plot.height) return;
  over = prepared(cursor);
  const g = prepared(curves), quiet = cssColour("--quiet"), rule = cssColour("--rule");
  g.font = "11px system-ui, sans-serif";
  g.fillStyle = quiet;
  g.strokeStyle = rule;
  g.lineWidth = 1;
  const line = (x1, y1, x2, y2) => { g.beginPath(); g.moveTo(x1, y1); g.lineTo(x2, y2); g.stroke(); };
  g.textAlign = "center";
  g.textBaseline = "top";
  for (const t of ticks(start, end, Math.max(2, plot.width / 110))) {
    const x = Math.round(atTime(t)) + 0.5;
    line(x, MARGIN.top, x, plot.height - MARGIN.bottom);
    g.fillText(written(t) + " s", Math.min(x, plot.width - 16), plot.height - MARGIN.bottom + 4);
  }
  g.textAlign = "right";
  g.textBaseline = "middle";
  for (const one of shared ? series.slice(0, 1) : series) {
    g.fillStyle = lanes > 1 ? one.colour : quiet;
    for (const v of ticks(one.low, one.high, lanes > 1 ? 3 : 4)) {
      const y = Math.round(atValue(one, v)) + 0.5;
      line(MARGIN.left, y, plot.width - MARGIN.right, y);
      g.fillText(written(v), MARGIN.left - 6, y);
    }
  }
  g.strokeStyle = cssColour("--event");
  g.setLineDash([3, 3]);
  for (const event of data.events) {
    const x = Math.round(atTime(event.time)) + 0.5;
    line(x, MARGIN.top, x, plot.height - MARGIN.bottom);
  }
  g.setLineDash([]);
  g.lineWidth = 1.7;
  g.lineJoin = "round";
  for (const one of series) {
    g.strokeStyle = one.colour;
    g.beginPath();
    let pen = false;
    // More points than pixels are drawn as they are: a peak must not be lost.
    one.values.forEach((v, k) => {
      if (!Number.isFinite(v)) { pen = false; return; }
      const x = atTime(one.times[k]), y = atValue(one, v);
      if (pen) g.lineTo(x, y); else g.moveTo(x, y);
      pen = true;
    });
    g.stroke();
    g.fillStyle = one.colour;
    one.values.forEach((v, k) => {
      // A line needs two values: one alone between gaps is a dot.
      if (!Number.isFinite(v) || Number.isFinite(one.values[k - 1]) || Number.isFinite(one.values[k + 1])) return;
      g.beginPath();
      g.arc(atTime(one.times[k]), atValue(one, v), 1.7, 0, 2 * Math.PI);
      g.fill();
    });
  }
  drawCursor();
}

function drawCursor() {
  if (strip.hidden || !over) return;
  over.clearRect(0, 0, plot.width, plot.height);
  const x = atTime(now.time);
  over.strokeStyle = over.fillStyle = theme.accent;
  over.lineWidth = 1.5;
  over.beginPath();
  over.moveTo(x, MARGIN.top - 4);
  over.lineTo(x, plot.height - MARGIN.bottom + 2);
  over.stroke();
  for (const one of series) {
    const value = valueAt(one, now.time);
    const text = Number.isFinite(value) ? value.toPrecision(4) : "–";
    if (one.output.textContent !== text) one.output.textContent = text;
    if (!Number.isFinite(value)) continue;
    over.fillStyle = one.colour;
    over.beginPath();
    over.arc(x, atValue(one, value), 3.5, 0, 2 * Math.PI);
    over.fill();
  }
}

function scrub(event) {
  const share = (event.offsetX - MARGIN.left) / (plot.width - MARGIN.left - MARGIN.right);
  seek(start + Math.min(Math.max(share, 0), 1) * duration);
}
cursor.addEventListener("pointerdown", (event) => {
  pause();
  cursor.setPointerCapture(event.pointerId);
  scrub(event);
});
cursor.addEventListener("pointermove", (event) => { if (event.buttons & 1) scrub(event); });
