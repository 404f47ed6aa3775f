// An adaptive explicit Runge–Kutta method with dense output, events and projection: the loop of
// pydy's native solvers, with the same first step, error norm, controller and interpolant.

// What is noted of events, besides 0 and 1: located, though it has the sign again that it began with; and
// on its way to its side of zero, where it has not been since it was handled.
const BACK = 2, DEPARTS = -1;
const NOWHERE = 2; // a θ beyond the step
const UNDECIDED = 16 * ROUNDING; // of a time: closer to a switch, rounding decides on which side it is

/**
 * Return rows of the times at which rates switch by time alone, ascending, as `find_switches` of
 * fmu_core.c: each with the last time before it and the first one after it that are clearly so.
 */
function switchRows(system, start, end) {
  const rows = [];
  if (!system.switches) return rows;
  const found = new Float64Array(system.switchCount);
  system.switches(found);
  for (const time of found.sort()) {
    const width = UNDECIDED * Math.max(Math.abs(time), Math.abs(start), Math.abs(end)), last = rows[rows.length - 1];
    if (!Number.isFinite(time)) continue;
    if (last && time - width <= last[2]) last[2] = time + width;
    else rows.push([time, time - width, time + width]);
  }
  // Else the first or last step may be as short as rounding.
  for (const row of rows) for (const one of [start, end]) if (row[1] < one && one < row[2]) row[0] = one;
  return rows;
}

/** y = x + h · (row · stages). */
function combine(y, x, h, row, stages) {
  const [places, weights] = row;
  for (let i = 0; i < y.length; i++) {
    let total = 0;
    for (let k = 0; k < places.length; k++) total += weights[k] * stages[places[k]][i];
    y[i] = (x === null ? 0 : x[i]) + h * total;
  }
}

const above = (least) => (value) => typeof value === "number" && value >= least;
const tolerance = [(value) => Number.isFinite(value) && value >= 0, "finite and not negative"];
const OPTIONS = {
  rtol: tolerance,
  atol: tolerance,
  maxStep: [above(Number.MIN_VALUE), "a positive number"],
  maxSteps: [above(1), "at least 1"],
};

/** Refuse times and options that no integration ends with, or that it would ignore. */
function check(times, options) {
  const shown = (value) => Object.prototype.toString.call(value) === "[object Array]" ? `[${value}]` : String(value);
  if (!(Array.isArray(times) || ArrayBuffer.isView(times)) || !(times.length > 0))
    throw new TypeError(`times must be an array of at least one number, got ${shown(times)}`);
  for (let k = 0; k < times.length; k++) {
    if (!Number.isFinite(times[k])) throw new RangeError(`times must be finite numbers, got ${shown(times[k])} at ${k}`);
    if (k > 0 && times[k] < times[k - 1]) throw new RangeError(`times must ascend, got ${times[k]} after ${times[k - 1]} at ${k}`);
  }
  for (const [name, value] of Object.entries(options)) {
    if (!Object.keys(OPTIONS).includes(name)) throw new TypeError(`there is no option ${name}; there are ${Object.keys(OPTIONS).join(", ")}`);
    const [sound, what] = OPTIONS[name];
    if (value !== undefined && !sound(value)) throw new RangeError(`${name} must be ${what}, got ${shown(value)}`);
  }
}

class Integration {
  /**
   * `system` has `n`, `rates(t, x, out)`, which returns whether it failed, `events` or null,
   * `projection` or null, and `switches(out)` or null. `onRow(k, t, x)` is called for each of the times.
   */
  constructor(system, method, times, x0, onRow, options = {}) {
    const { n } = system;
    check(times, options);
    Object.assign(this, { system, method, times, onRow, n });
    const { rtol = 1.49012e-8, atol = 1.49012e-8, maxStep = Infinity, maxSteps = 1e7 } = options;
    Object.assign(this, { rtol, atol, maxStep, maxSteps });
    if (atol === 0 && Array.from(x0).some((value) => value * rtol === 0))
      throw new RangeError(`atol must be above 0 where a state begins at 0 or rtol is 0, got rtol ${rtol} and atol 0`);
    this.count = method.stages.length;
    this.control = method.control;
    const vector = () => new Float64Array(n);
    this.x = Float64Array.from(x0);
    this.fresh = vector();
    this.trial = vector();
    this.stages = Array.from({ length: this.count + 1 + method.dense.length }, vector);
    this.errors = method.errors.map(vector);
    this.interpolant = Array.from({ length: 3 + method.interpolant.length }, vector);
    this.t = times[0];
    this.switches = switchRows(system, times[0], times[times.length - 1]);
    this.until = Infinity; // rates are evaluated at this time at the latest
    this.h = 0;
    this.next = 0;
    this.steps = this.rejected = this.evaluations = 0;
    this.records = [];
    /** "running", "finished", "stopped" by a terminal event, or why it failed. */
    this.status = "running";
    this.started = false;
    this.onStep = null; // `onStep(t, x)`, if any, is called after each step, and on both sides of an event that acts
    if (system.projection) this.status = system.projection.begin(this.t, this.x) || this.status;
    if (system.events) {
      this.sides = new Int8Array(system.events.count);
      [this.values, this.probe, this.divided, ...this.ends] = Array.from({ length: PARTS + 4 }, () => new Float64Array(system.events.count));
      this.fired = new Int8Array(system.events.count);
      this.startEvents();
    }
  }

  rates(t, x, out) {
    this.evaluations += 1;
    return this.system.rates(this.settled(t), x, out);
  }

  /** Return the first switch after t, or none. */
  switchAfter(t) {
    return this.switches.find((row) => row[0] > t);
  }

  /** Return a time on the side of a switch on which the step is, where rounding does not decide. */
  settled(time) {
    if (this.switches.length === 0) return time;
    const t = Math.min(time, this.until), next = this.switchAfter(t);
    for (const row of this.switches) if (row[0] <= t && t < row[2]) return row[2];
    return next && t > next[1] ? next[1] : t;
  }

  norm(a, b) {
    let total = 0;
    for (let i = 0; i < this.n; i++) {
      const e = (a[i] - (b === null ? 0 : b[i])) / (this.atol + this.rtol * Math.abs(this.x[i]));
      total += e * e;
    }
    return Math.sqrt(total / this.n);
  }

  // E. Hairer, S. P. Nørsett, G. Wanner, Solving Ordinary Differential Equations I, II.4.
  firstSize() {
    const { x, stages, trial, t } = this, d0 = this.norm(x, null), d1 = this.norm(stages[0], null);
    let h0 = d0 < NEGLIGIBLE || d1 < NEGLIGIBLE ? TRIAL_SIZE : TRIAL_PART * d0 / d1;
    h0 = Math.min(h0, this.maxStep);
    for (let i = 0; i < this.n; i++) trial[i] = x[i] + h0 * stages[0][i];
    if (this.rates(t + h0, trial, stages[1])) return h0 * SLIVER;
    const d2 = this.norm(stages[1], stages[0]) / h0, steepest = Math.max(d1, d2);
    const h1 = steepest > NEGLIGIBLE_SLOPE ? (TRIAL_PART / steepest) ** this.control[EXPONENT] : Math.max(TRIAL_SIZE, h0 * SLIVER);
    return Math.min(Math.max(Math.min(100 * h0, h1), SHORTEST * Math.abs(t)), this.maxStep);
  }

  errorOfStep() {
    const { x, fresh, errors, method, n } = this;
    method.errors.forEach((row, k) => combine(errors[k], null, this.size, row, this.stages));
    let first = 0, second = 0;
    for (let i = 0; i < n; i++) {
      const weight = 1 / (this.atol + this.rtol * Math.max(Math.abs(x[i]), Math.abs(fresh[i])));
      const e = errors[0][i] * weight, d = errors.length > 1 ? errors[1][i] * weight : 0;
      first += e * e;
      second += d * d;
    }
    if (errors.length > 1) return first === 0 ? 0 : first / Math.sqrt((first + 0.01 * second) * n);
    return Math.sqrt(first / n);
  }

  /** Get the interpolant of the step just taken ready; return whether it failed. */
  prepareInterpolant() {
    const { x, fresh, stages, interpolant: f, method, trial, size: h } = this;
    for (let k = 0; k < method.dense.length; k++) {
      const stage = this.count + 1 + k;
      combine(trial, x, h, method.dense[k], stages);
      if (this.rates(this.t + method.nodes[stage] * h, trial, stages[stage])) return true;
    }
    for (let i = 0; i < this.n; i++) {
      const increment = fresh[i] - x[i], first = h * stages[0][i] - increment;
      f[0][i] = increment;
      f[1][i] = first;
      f[2][i] = increment - first - h * stages[this.count][i];
    }
    method.interpolant.forEach((row, k) => combine(f[3 + k], null, h, row, stages));
    return false;
  }

  /** x + θ (F0 + (1 − θ)(F1 + θ (F2 + (1 − θ)(F3 + …)))). */
  interpolate(theta, out) {
    const { x, interpolant: f } = this;
    for (let i = 0; i < this.n; i++) {
      let value = 0;
      for (let k = f.length - 1; k >= 0; k--) value = (value + f[k][i]) * (k % 2 ? 1 - theta : theta);
      out[i] = x[i] + value;
    }
  }

  /** Take up to `most` steps, or until `until()` is true; return whether there is more to do. */
  advance(most = Infinity, until = null) {
    while (this.status === "running" && most-- > 0) {
      this.step();
      if (until && until()) break;
    }
    return this.status === "running";
  }

  reached(x) {
    while (this.next < this.times.length && this.times[this.next] <= this.t) this.onRow(this.next, this.times[this.next++], x);
    if (this.next === this.times.length) this.status = "finished";
  }

  step() {
    const { method, control, stages, fresh, trial, x, times, count, system } = this;
    const last = times[times.length - 1];
    if (!this.started) {
      if (this.rates(this.t, x, stages[0])) return this.fail("the mass matrix is singular");
      this.started = true;
      this.lastError = FIRST_ERROR;
      this.growth = control[GROW];
      this.reached(x);
      if (this.status !== "running") return;
      if (this.h === 0) this.h = this.firstSize();
      if (!(this.h > 0 && this.h < Infinity)) return this.fail("the rates are not finite");
    }
    if (this.steps + this.rejected >= this.maxSteps) return this.fail("too many steps");
    const t = this.t;
    const wanted = Math.min(this.h, this.maxStep), end = t + wanted, jump = this.switchAfter(t);
    this.until = jump ? jump[1] : Infinity;
    const goal = jump ? Math.min(last, jump[0]) : last, after = end > goal - SLIVER * wanted ? goal : end;
    const size = after - t; // what the rounded times are apart: far from zero a clock would drift
    if (!(t + RESOLVED * size > t || after === goal)) return this.fail("the steps became too small");
    this.size = size;
    let failed = false;
    for (let stage = 1; stage < count && !failed; stage++) {
      combine(trial, x, size, method.stages[stage], stages);
      failed = this.rates(t + method.nodes[stage] * size, trial, stages[stage]);
    }
    if (!failed) {
      combine(fresh, x, size, method.weights, stages);
      if (method.endInEstimate) failed = this.rates(after, fresh, stages[count]);
    }
    let error = 0;
    if (!failed) {
      error = this.errorOfStep();
      if (error < 1 && (system.projection || !method.endInEstimate)) {
        if (system.projection && !system.projection(after, fresh)) return this.fail("the constraints could not be met");
        failed = this.rates(after, fresh, stages[count]);
      }
    }
    if (failed || !(error < 1)) {
      this.rejected += 1;
      if (failed || !Number.isFinite(error)) this.h = AFTER_FAILURE * size;
      else this.h = size * Math.max(control[SHRINK], control[SAFETY] * error ** -control[EXPONENT]);
      this.growth = 1;
      return;
    }
    this.steps += 1;
    if (times[this.next] === after && !system.events && !system.projection) {
      this.t = after;
      this.reached(fresh);
    } else if (system.events || times[this.next] <= after) {
      if (this.prepareInterpolant()) return this.fail("the mass matrix is singular");
      const theta = system.events ? this.scan(t, size) : 1, end = theta === 1 ? after : t + theta * size;
      if (this.status !== "running") return;
      while (this.next < times.length && times[this.next] <= end) {
        this.interpolate((times[this.next] - t) / size, trial);
        if (system.projection) system.projection(times[this.next], trial);
        this.onRow(this.next, times[this.next], trial);
        this.next += 1;
      }
      if (this.acting) {
        if (theta < 1) {
          this.interpolate(theta, trial);
          fresh.set(trial);
          if (system.projection) system.projection(end, fresh);
        }
        x.set(fresh);
        this.t = end;
        this.until = Infinity;
        this.h = 0;
        this.started = false;
        if (this.onStep) this.onStep(end, x);
        this.act();
        if (this.onStep) this.onStep(end, x);
        if (this.next === times.length && this.status === "running") this.status = "finished";
        return;
      }
      if (this.next === times.length) this.status = "finished";
    }
    error = Math.max(error, LEAST_ERROR);
    let factor = control[SAFETY] * error ** -control[ALPHA];
    if (control[BETA] !== 0) factor *= this.lastError ** control[BETA];
    this.h = size * Math.min(this.growth, Math.max(control[SHRINK], factor));
    if (after === goal) this.h = Math.max(this.h, wanted); // it was shortened to end there
    this.lastError = Math.max(error, FIRST_ERROR);
    this.growth = control[GROW];
    this.t = after;
    x.set(fresh);
    stages[0].set(stages[count]);
    if (jump && after === jump[0]) {
      this.until = Infinity;
      if (this.rates(after, x, stages[0])) return this.fail("the mass matrix is singular");
    }
    if (this.onStep) this.onStep(after, x);
  }

  fail(why) { this.status = why; }

  // -- events -----------------------------------------------------------------------------------------

  /** Set the sign that each event has just after now; where one is zero or has fired, its rate tells. */
  takeSides() {
    const { events } = this.system, values = this.values, rates = new Float64Array(values.length);
    events.values(this.t, this.x, values);
    events.rates(this.t, this.x, rates);
    for (let k = 0; k < values.length; k++)
      this.sides[k] = Math.sign(this.fired[k] || values[k] === 0 ? rates[k] : values[k]) || 0;
  }

  rateOf(k, x) {
    const rates = new Float64Array(this.fired.length);
    this.system.events.rates(this.t, x, rates);
    return rates[k];
  }

  /** Whether the rate of an event is zero, as far as states are known. */
  isStationary(k) {
    const rate = this.rateOf(k, this.x);
    let total = 0;
    for (let i = 0; i < this.n && rate !== 0; i++) {
      const beside = Float64Array.from(this.x);
      beside[i] += ROUNDINGS * ROUNDING * this.x[i];
      total += Math.abs(this.rateOf(k, beside) - rate);
    }
    return Math.abs(rate) <= total;
  }

  /** The sign that an event has just after now, as `departure` of pydy/solvers/run/departure.py. */
  departure(k) {
    return this.isStationary(k) ? this.resolvedSide(k) : Math.sign(this.rateOf(k, this.x)) || 0;
  }

  /** The sign of an event where it first exceeds its roundings, as `resolved_side` there. */
  resolvedSide(k) {
    const { x, t, n, times, system } = this, { events } = system;
    const vector = () => new Float64Array(n), values = new Float64Array(this.fired.length), bounds = values.slice();
    const slopes = [vector(), vector(), vector(), vector()], after = vector();
    let side = 0, size = times[times.length - 1] - times[0];
    for (let halved = 0; halved < HALVINGS; halved++) {
      size *= 0.5;
      system.rates(t, x, slopes[0]);
      [0.5, 0.5, 1].forEach((node, stage) => {
        for (let i = 0; i < n; i++) after[i] = x[i] + node * size * slopes[stage][i];
        system.rates(t + node * size, after, slopes[stage + 1]);
      });
      const [a, b, c, d] = slopes;
      for (let i = 0; i < n; i++) after[i] = x[i] + size / 6 * (a[i] + 2 * b[i] + 2 * c[i] + d[i]);
      events.values(t + size, after, values);
      events.bounds(t + size, after, bounds);
      if (Math.abs(values[k]) > ROUNDINGS * ROUNDING * bounds[k]) side = Math.sign(values[k]);
    }
    return side;
  }

  /** Whether the rate of an event does not tell where a reset leads, as `is_unresolved` of pydy/solvers/run/departure.py. */
  isUnresolved(k) {
    if (this.isStationary(k)) return true;
    const bounds = new Float64Array(this.fired.length), last = this.records.filter((one) => one.index === k).slice(-2, -1);
    this.system.events.bounds(this.t, this.x, bounds);
    if (!last.length || !(Math.abs(this.rateOf(k, this.x)) * (this.t - last[0].time) <= LOW * ROUNDINGS * ROUNDING * bounds[k])) return false;
    return this.resolvedSide(k) * this.sides[k] < 0;
  }

  /** Record the events on whose surfaces the motion starts, and let them act. */
  startEvents() {
    const { events } = this.system, { sides, fired, values } = this, bounds = new Float64Array(fired.length);
    this.takeSides();
    events.bounds(this.t, this.x, bounds);
    for (let k = 0; k < fired.length; k++) {
      if (!(values[k] === 0 || Math.abs(values[k]) <= ROUNDINGS * ROUNDING * bounds[k])) continue;
      const side = sides[k] = this.departure(k), direction = events.directions[k];
      if (!side || ![0, side].includes(direction)) continue;
      if (events.acting[k] && (direction || this.isStationary(k))) fired[k] = 1;
      else this.records.push({ time: this.t, index: k });
    }
    if (!fired.includes(1)) return;
    this.reached(this.x); // outputs at the time of an event are those before it
    if (this.status === "finished") this.status = "running";
    for (let k = 0; k < fired.length; k++) if (fired[k]) sides[k] = 0; // where the motion came from is not known
    this.act();
    if (this.next === this.times.length && this.status === "running") this.status = "finished";
  }

  /** Note the events from whose surfaces a reset has led, by more than rounding. */
  leave(was, off) {
    const { events } = this.system, values = new Float64Array(was.length), bounds = new Float64Array(was.length);
    events.values(this.t, this.x, values);
    events.bounds(this.t, this.x, bounds);
    for (let k = 0; k < was.length; k++)
      if (values[k] !== was[k] && Math.abs(values[k]) > ROUNDINGS * ROUNDING * bounds[k]) off.add(k);
  }

  crossed(k, value) {
    const side = this.sides[k], direction = this.system.events.directions[k];
    return (side < 0 && value > 0 && direction >= 0) || (side > 0 && value < 0 && direction <= 0);
  }

  probed(t, h, theta, out) {
    this.interpolate(theta, this.trial);
    this.system.events.values(t + theta * h, this.trial, out);
  }

  resolution(t, h) {
    return ROUNDING * Math.max(Math.abs(t), Math.abs(t + h)) / h;
  }

  /** Return an interval from a place where an event is on its side, as `comes_to_side` of scan_events.c, or null. */
  comesToSide(t, h, low, high, k) {
    const side = this.sides[k], out = this.probe;
    this.probed(t, h, low, out);
    if (!(out[k] * side <= 0)) return [low, high];
    for (let middle = high; ; high = middle) {
      middle = low + 0.5 * (middle - low);
      if (middle - low < this.resolution(t, h)) return null;
      this.probed(t, h, middle, out);
      if (out[k] * side > 0) return [middle, high];
    }
  }

  /** Whether an event moves away from zero, to its side, by its rate at t + θ h. */
  movesOff(t, h, theta, k) {
    const rates = new Float64Array(this.fired.length);
    this.interpolate(theta, this.trial);
    this.system.events.rates(t + theta * h, this.trial, rates);
    return rates[k] * this.sides[k] > 0;
  }

  /** Whether a crossing is one of roundings, as `is_rounded` of scan_events.c. */
  isRounded(t, h, theta, value, k) {
    if (!this.movesOff(t, h, theta, k)) return false;
    const bounds = new Float64Array(this.fired.length);
    this.system.events.bounds(t + theta * h, this.trial, bounds);
    return value === 0 || Math.abs(value) <= ROUNDINGS * ROUNDING * bounds[k];
  }

  /** Return where an event happens that has not come to its side, as `turning_place` of scan_events.c. */
  turningPlace(t, h, low, high, k) {
    let turned = NOWHERE;
    for (let place = high; ; place = low + 0.5 * (place - low)) {
      const off = this.movesOff(t, h, place, k);
      if (!off) turned = place;
      if (0.5 * (place - low) < this.resolution(t, h)) return off || this.movesOff(t, h, low, k) ? turned : low;
    }
  }

  /** Whether an event with a value at `high` is not on its side, but moves there from where rounding has left it. */
  departs(t, h, low, high, value, k) {
    return value * this.sides[k] < 0 && this.locate(t, h, low, high, k) === NOWHERE;
  }

  locate(t, h, low, high, k) {
    const side = this.sides[k], out = this.probe, resolution = this.resolution(t, h), last = high;
    const places = this.comesToSide(t, h, low, high, k);
    if (places === null) return this.turningPlace(t, h, low, high, k);
    [low, high] = places;
    while (high - low > resolution) {
      const middle = low + 0.5 * (high - low);
      if (middle === low || middle === high) break;
      this.probed(t, h, middle, out);
      if (out[k] * side > 0) low = middle; else high = middle;
    }
    this.probed(t, h, high, out);
    return this.isRounded(t, h, high, out[k], k) ? this.turningPlace(t, h, high, last, k) : high;
  }

  /**
   * Return a place around the i-th, in a part or beside it, at which an event has another sign than at the
   * ends of parts there, or 2: its least value is sought by parabolas, as `least_place` of scan_events.c does.
   */
  leastPlace(t, h, k, i, part) {
    const side = this.sides[k], { divided } = this;
    let [a, b, c] = SCAN_POINTS.slice(i - 1, i + 2), [za, zb, zc] = this.ends.slice(i - 1, i + 2).map((z) => side * z[k]), error = Infinity;
    const rounding = ROUNDINGS * ROUNDING * Math.max(za, zb, zc);
    if (!(za > 0 && zb > 0 && zc > 0)) return 2;
    for (let tries = 0; tries < 20; tries++) {
      const low = (zb - za) / (b - a), bend = ((zc - zb) / (c - b) - low) / (c - a), slope = low + bend * (b - a);
      let place = b - 0.5 * slope / bend;
      if (!(bend > 0 && zb + 0.5 * slope * (place - b) <= 2 * error)) return 2;
      const first = part > 1 ? SCAN_POINTS[part - 1] : -SCAN_POINTS[1], last = part < PARTS ? SCAN_POINTS[part] : 2 - SCAN_POINTS[PARTS - 1];
      if (tries === 0 && !(place >= first && place <= last)) return 2;
      if (place <= a || place >= c) place = 0.5 * (b + (place <= a ? a : c));
      if (!(place > a && place < c) || place === b) return 2;
      this.probed(t, h, place, divided);
      const z = side * divided[k];
      if (z < 0) return z < -rounding ? place : 2;
      error = Math.abs(z - zb - (slope + bend * (place - b)) * (place - b));
      if (z <= zb) {
        if (place < b) [c, zc] = [b, zb]; else [a, za] = [b, zb];
        [b, zb] = [place, z];
      } else if (place < b) [a, za] = [place, z];
      else [c, zc] = [place, z];
    }
    return 2;
  }

  /** Return the first place beyond `left` in a part where an event has another sign than at both ends, or 2. */
  findDip(t, h, left, part) {
    const { count } = this.system.events;
    let first = 2;
    for (let k = 0; k < count; k++) for (let i = Math.max(1, part - 1); i <= part && i < PARTS; i++) {
      const found = this.leastPlace(t, h, k, i, part);
      if (found > left && found < Math.min(first, SCAN_POINTS[part])) first = found;
    }
    return first;
  }

  /** Look for events in the step just taken; return the θ up to which it counts. */
  scan(t, h) {
    const { events } = this.system, { values, probe, fired, sides } = this;
    this.acting = false;
    SCAN_POINTS.forEach((place, k) => this.probed(t, h, place, this.ends[k]));
    let left = 0;
    for (let part = 1; part <= PARTS; part += left === SCAN_POINTS[part] ? 1 : 0) {
      const right = Math.min(SCAN_POINTS[part], this.findDip(t, h, left, part));
      this.probed(t, h, right, values);
      for (;;) {
        let first = NOWHERE, earliest = -1;
        for (let k = 0; k < values.length; k++) {
          fired[k] = 0;
          if (this.crossed(k, values[k])) {
            const theta = this.locate(t, h, left, right, k);
            fired[k] = theta === NOWHERE ? DEPARTS : theta <= left ? 1 : 0;
            if (theta < first) [first, earliest] = [theta, k];
          }
        }
        if (first > 1) break;
        this.probed(t, h, first, probe);
        for (let k = 0; k < values.length; k++) { // by then another may have crossed and be back, or not have come to its side
          if (k === earliest || fired[k] || !(probe[k] * sides[k] < 0)) continue;
          const crosses = this.crossed(k, probe[k]);
          if (this.departs(t, h, left, first, probe[k], k)) fired[k] = DEPARTS;
          else if (crosses && !this.crossed(k, values[k])) {
            const theta = this.locate(t, h, left, first, k);
            if (theta > left) [first, fired[k]] = [theta, BACK];
          }
          this.probed(t, h, first, probe);
        }
        for (let k = 0; k < values.length; k++) {
          if (fired[k] === DEPARTS) continue;
          const here = this.crossed(k, probe[k])
            || (this.crossed(k, values[k]) && (probe[k] === 0 || fired[k] === 1))
            || (fired[k] === BACK && probe[k] === 0);
          fired[k] = here ? 1 : 0;
          if (here && events.acting[k]) this.acting = true;
        }
        if (this.acting) return first;
        for (let k = 0; k < values.length; k++) if (fired[k] > 0) {
          this.records.push({ time: t + first * h, index: k });
          sides[k] = -sides[k];
        }
        left = first;
      }
      for (let k = 0; k < values.length; k++) {
        if (sides[k] && Number.isNaN(values[k])) return this.fail(`the event ${events.names[k]} is NaN`);
        if (values[k] && !this.departs(t, h, left, right, values[k], k)) sides[k] = Math.sign(values[k]);
      }
      left = right;
    }
    return 1;
  }

  /** Reset the states, or stop. */
  act() {
    const { events } = this.system, { fired, x, t, records } = this;
    let ends = false, crowded = false;
    const was = new Float64Array(fired.length), off = new Set();
    for (let k = 0; k < fired.length; k++) if (fired[k] > 0) {
      records.push({ time: t, index: k });
      if (events.acting[k]) {
        events.values(t, x, was);
        events.reset(k, t, x);
        this.leave(was, off);
      }
      ends = ends || events.terminal[k];
      if (!events.acting[k]) continue;
      const same = records.filter((one) => one.index === k).slice(-CROWD), span = this.times[this.times.length - 1] - this.times[0];
      if (same.length >= 2 && t - same[same.length - 2].time <= NO_LATER * ROUNDING * Math.max(Math.abs(t), span)) crowded = true;
      if (same.length === CROWD && t - same[0].time < CROWDED * span) crowded = true;
    }
    if (!x.every(Number.isFinite)) return this.fail("a reset gave no finite state");
    if (ends) this.status = "stopped";
    else {
      const origins = Int8Array.from(this.sides), acted = fired.slice();
      for (const k of off) fired[k] = 0;
      this.takeSides();
      for (let k = 0; k < fired.length; k++)
        if (origins[k] && !acted[k] && Number.isNaN(this.values[k])) return this.fail(`the event ${events.names[k]} is NaN`);
      if (crowded) this.status = "stopped";
      for (let k = 0; k < fired.length; k++) if (fired[k] > 0 && events.redirects[k] && this.isUnresolved(k)) {
        // At rest on the surface, as far as roundings tell, it happens again at once where its direction points to.
        const side = this.sides[k] = this.resolvedSide(k), direction = events.directions[k];
        if (side && (direction === side || (direction === 0 && origins[k] === 0))) this.status = "stopped";
      }
    }
    fired.fill(0);
    this.started = false;
    return undefined;
  }
}
