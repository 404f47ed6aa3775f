// A page that simulates: sliders, and the motion computed anew, in slices, when one is moved.
const live = data.live;
const sliders = live.sliders.map((one) => ({ ...one, now: one.value }));
const width = liveModel.states.length, count = times.length;
const motion = {
  states: new Float64Array(width * count), run: null, dirty: true, reached: 0, started: 0, cost: 0, simulated: 0,
  asked: start, given: NaN, // the moment that was shown before the run, and what is shown until the run is there
  status: "running", first: null, poses: new Float64Array(liveModel.poses_size), lengths: new Float64Array(liveModel.sizes_size),
  outputs: new Float64Array(liveModel.outputs.length), inputs: null, formulas: new Float64Array(liveModel.formulas_size),
};
const SLICE = 22; // milliseconds of each frame for the simulation

// -- from a state to what is drawn ------------------------------------------------------------------

const AT_POINTS = 9 * live.frames, AT_ARROWS = AT_POINTS + 3 * live.points;
const basis = new THREE.Matrix4(), turn = new THREE.Quaternion(), before = new THREE.Quaternion();
const spot = new THREE.Vector3(), middle = new THREE.Vector3();

const drawn = new Set(live.series.map(([group]) => group)), samples = [];

/** Add a sample to the curves: at the times of the rows, and after each step between them. */
function addSample(t, x) {
  const { outputs: y, inputs: r, formulas: f } = motion, sources = { x, r, y, f };
  if (drawn.has("y")) liveModel.evaluateOutputs(t, x, r, y);
  if (drawn.has("f")) liveModel.formulas(t, x, r, f);
  for (let i = 0; i < samples.length; i++) {
    const [group, index, factor] = live.series[i];
    samples[i].add(t, factor * sources[group][index]);
  }
}

function writeRow(k, t, x) {
  const { poses, states, inputs } = motion;
  states.set(x, k * width);
  liveModel.poses(t, x, inputs, poses);
  live.tracks.forEach(([frame, point], i) => {
    const { places, turns } = tracks[i];
    for (let j = 0; j < 3; j++) places.values[3 * k + j] = poses[AT_POINTS + 3 * point + j] / unit;
    if (frame < 0) turn.identity();
    else {
      const m = poses.subarray(9 * frame, 9 * frame + 9);
      basis.set(m[0], m[1], m[2], 0, m[3], m[4], m[5], 0, m[6], m[7], m[8], 0, 0, 0, 0, 1);
      turn.setFromRotationMatrix(basis);
      // On the same side of the sphere as the row before, so that blending takes the short way.
      if (k > 0 && turn.dot(before.fromArray(turns.values, 4 * k - 4)) < 0) turn.set(-turn.x, -turn.y, -turn.z, -turn.w);
    }
    turn.toArray(turns.values, 4 * k);
  });
  visuals.forEach((visual, i) => {
    const line = live.lines[i], arrow = live.arrows[i];
    if (line && !visual.trackOf) {
      const { values } = visual.object.column;
      line.forEach((point, n) => {
        for (let j = 0; j < 3; j++) values[3 * line.length * k + 3 * n + j] = poses[AT_POINTS + 3 * point + j] / unit;
      });
    }
    if (arrow) for (let j = 0; j < 3; j++)
      visual.object.column.values[3 * k + j] = (arrow[1] / unit) * poses[AT_ARROWS + 3 * arrow[0] + j];
  });
  addSample(t, x);
  if (path) {
    middle.set(0, 0, 0);
    for (const i of live.path) middle.add(whereabouts(visuals[i], k));
    middle.divideScalar(live.path.length || 1);
    if (!motion.first) motion.first = middle.clone();
    middle.sub(motion.first).addScaledVector(up, -middle.dot(up));
    middle.toArray(path.values, 3 * k);
  }
}

/** Where a visual's point is in row k. */
function whereabouts(visual, k) {
  if (!visual.trackOf) return spot.fromArray(visual.object.column.values, visual.object.column.width * k);
  const { places, turns } = visual.trackOf;
  spot.fromArray(visual.offset).applyQuaternion(turn.fromArray(turns.values, 4 * k));
  for (const [j, axis] of ["x", "y", "z"].entries()) spot[axis] += places.values[3 * k + j];
  return spot;
}

/** Rows that a simulation did not reach show the last that it did. */
function fillRest(from) {
  const copy = (values, size) => {
    for (let k = from; k < count; k++) values.copyWithin(k * size, (from - 1) * size, from * size);
  };
  copy(motion.states, width);
  for (const { places, turns } of tracks) {
    copy(places.values, 3);
    copy(turns.values, 4);
  }
  for (const { object } of visuals) if (object.column && !object.column.fixed) copy(object.column.values, object.column.width);
  for (const one of samples) one.add(end, one.values[one.values.length - 1]);
  if (path) copy(path.values, 3);
}

/** Shapes whose lengths depend on constants get them anew. */
function resize3() {
  if (!live.sizes.length) return;
  liveModel.sizes(start, new Float64Array(width), motion.inputs, motion.lengths);
  live.sizes.forEach(([place, name], i) => {
    const visual = visuals[place], length = motion.lengths[i] / (name === "duration" ? 1 : unit);
    if (!(length > 0)) return;
    if (visual.size) {
      visual.size = { ...visual.size, [name]: length };
      if (visual.object.isMesh) visual.object.geometry = geometryOf(visual);
    } else if ("radius" in visual.object && name === "radius") {
      visual.object.radius = length;
      if (visual.object.update && visual.trackOf && visual.points) visual.object.update();
    }
  });
}

// -- ground and view --------------------------------------------------------------------------------

const firstGround = view.ground, ORIGIN = [0, 0, 0], upward = new THREE.Vector3();
const firstLow = view.target.map((middle, i) => middle - view.extent[i] / 2);
const firstHigh = view.target.map((middle, i) => middle + view.extent[i] / 2);

/** The lowest height along `up` in any row, of a visual's corners, points or ends; at most `low`. */
function lowestOf({ trackOf: track, offset, points, vectors, object }, up, low) {
  const lower = (height) => { if (height < low) low = height; };
  if (!track) {
    const { values } = object.column;
    for (let i = 0; i < values.length; i += 3) lower(up.dot(spot.fromArray(values, i)));
    return low;
  }
  const { places, turns } = track;
  const surface = !points && !vectors && object.geometry; // a Trace has none, a thin line is no surface
  const corners = surface ? surface.attributes.position.array : points ? object.column.values : ORIGIN;
  if (surface) surface.computeBoundingSphere();
  const ball = surface && surface.boundingSphere; // lines have few points, and need none
  // The height of a corner c is base + upward · c, where `upward` is `up` as the body sees it.
  const baseOf = (k) => {
    upward.copy(up).applyQuaternion(turn.fromArray(turns.values, turns.offset(k)).conjugate());
    return up.dot(spot.fromArray(places.values, places.offset(k))) + upward.dot(spot.fromArray(offset));
  };
  const rows = [];
  for (let k = 0; k < count; k++) {
    const base = baseOf(k), bottom = ball ? base + upward.dot(ball.center) - ball.radius : -Infinity;
    if (vectors) lower(base + up.dot(spot.fromArray(object.column.values, object.column.offset(k))));
    if (bottom < low) rows.push([bottom, k]);
  }
  // From the lowest sphere up: few rows are left to be looked at corner by corner.
  rows.sort((a, b) => a[0] - b[0]);
  for (const [bottom, k] of rows) {
    if (bottom >= low) break;
    const base = baseOf(k);
    for (let i = 0; i < corners.length; i += 3) lower(base + upward.dot(spot.fromArray(corners, i)));
  }
  return low;
}

/** The ground, unless its height was given, is below the motion; resetting the view shows it and the first one. */
function frameMotion() {
  const solids = visuals.filter((visual) => visual.kind !== "Plane"), framed = solids.length ? solids : visuals;
  const lowest = (up, first) => {
    const low = framed.reduce((height, visual) => lowestOf(visual, up, height), first);
    return Number.isFinite(low) ? low : first;
  };
  if (live.lowers) view.ground = lowest(up, firstGround);
  if (path) return; // the box goes along with what travels
  firstLow.forEach((first, i) => {
    const axis = new THREE.Vector3().setComponent(i, 1);
    const low = lowest(axis, first), high = -lowest(axis.negate(), -firstHigh[i]);
    view.target[i] = (low + high) / 2;
    view.extent[i] = high - low;
  });
}

// -- simulating -------------------------------------------------------------------------------------

function restart() {
  motion.dirty = false;
  motion.started = performance.now();
  motion.cost = 0;
  motion.reached = 0;
  motion.status = "running";
  const defaults = (variables) => Float64Array.from(variables, (one) => one.value);
  const p = defaults(liveModel.constants), x = defaults(liveModel.states), r = defaults(liveModel.inputs);
  for (const one of sliders) ({ p, x, r })[one.group][one.place] = one.now;
  liveModel.bind(p);
  motion.inputs = r;
  if (live.starts.length) {
    const values = new Float64Array(live.starts.length);
    liveModel.start(start, x, r, values);
    live.starts.forEach((place, i) => { x[place] = values[i]; });
  }
  if (live.dependents && !liveModel.settle(start, x, r, ...live.dependents)) {
    stop("no state with these values satisfies the constraints");
    return;
  }
  resize3();
  series.forEach((one, i) => { Object.assign(one, samples[i] = new Samples()); });
  motion.run = liveModel.integration(times, x, r, (k, t, state) => {
    writeRow(k, t, state);
    motion.reached = k + 1;
  }, live.options);
  addSample(motion.run.t, motion.run.x); // after events that act at once
  if (samples.length) motion.run.onStep = addSample;
}

function stop(status) {
  data.events = (motion.run ? motion.run.records : []).map((one) => ({ time: one.time, name: liveModel.eventNames[one.index] }));
  motion.run = null;
  motion.status = status;
  if (motion.reached > 0 && motion.reached < count) fillRest(motion.reached);
  const failed = !["finished", "stopped"].includes(status);
  complaint.hidden = !failed;
  complaint.textContent = failed ? `The simulation ends at ${(motion.reached ? times[motion.reached - 1] : start).toFixed(2)} s: ${status}.` : "";
  for (const visual of [...trails.keys()]) {
    setTrail(visual, false);
    setTrail(visual, true);
  }
  frameMotion();
  fillEvents();
  scaleSeries();
  drawStrip();
  invalidate();
}

/** Show the last moment that is simulated until the one that was shown is, unless a reader goes elsewhere. */
function hold() {
  if (now.time !== motion.given) motion.asked = now.time;
  const last = motion.run && motion.reached ? times[motion.reached - 1] : Infinity;
  motion.given = Math.min(motion.asked, last);
  if (now.time !== motion.given) locate(motion.given);
}

/** Simulate for some milliseconds. */
function work(budget) {
  if (motion.dirty) restart();
  if (!motion.run) return;
  const begin = performance.now();
  motion.run.advance(Infinity, () => performance.now() - begin > budget);
  motion.cost += performance.now() - begin;
  if (motion.run.status !== "running") {
    motion.simulated = motion.run.t - start;
    stop(motion.run.status);
  }
  hold();
  invalidate();
}

function workAll() {
  do work(Infinity); while (motion.dirty || motion.run);
}

function liveTick() {
  requestAnimationFrame(liveTick);
  if (motion.dirty || motion.run) work(SLICE);
}

// -- sliders ----------------------------------------------------------------------------------------

const panel = document.createElement("section"), complaint = document.createElement("p");
panel.id = "live";
panel.setAttribute("aria-label", "Parameters");
complaint.setAttribute("role", "status");
complaint.hidden = true;

function change(one, value) {
  if (!Number.isFinite(value)) return;
  one.now = value;
  one.range.value = value;
  if (document.activeElement !== one.box) one.box.value = Number(value.toPrecision(6));
  motion.dirty = true;
}

function fillPanel() {
  const head = document.createElement("div"), toggle = document.createElement("button"), rows = document.createElement("ul");
  toggle.type = "button";
  toggle.textContent = "Parameters";
  toggle.className = "toggle";
  const open = (on) => {
    toggle.setAttribute("aria-expanded", String(on));
    rows.hidden = !on;
    resize();
    invalidate();
  };
  toggle.addEventListener("click", () => open(rows.hidden));
  head.append(toggle);
  button(head, "Reset all parameters", "M4 9V4h5M4.5 9a8 8 0 1 1-.5 5", () => sliders.forEach((one) => {
    one.box.blur();
    change(one, one.value);
  }));
  for (const one of sliders) {
    const row = document.createElement("li"), label = document.createElement("label"), its = document.createElement("span");
    one.range = document.createElement("input");
    one.box = document.createElement("input");
    one.range.type = "range";
    one.box.type = "number";
    one.range.step = one.box.step = "any";
    one.range.min = one.low;
    one.range.max = one.high;
    label.append(...typeset({ parts: one.parts }));
    label.title = one.label;
    its.textContent = one.unit;
    its.className = "unit";
    one.range.setAttribute("aria-label", one.label);
    one.box.setAttribute("aria-label", `${one.label}, number`);
    one.range.addEventListener("input", () => change(one, Number(one.range.value)));
    one.box.addEventListener("input", () => { if (one.box.value !== "") change(one, Number(one.box.value)); });
    row.append(label, one.box, its);
    button(row, `Reset ${one.label}`, "M4 9V4h5M4.5 9a8 8 0 1 1-.5 5", () => {
      one.box.blur();
      change(one, one.value);
    });
    row.append(one.range);
    rows.append(row);
    change(one, one.value);
  }
  panel.append(head, rows, complaint);
  const stage = document.getElementById("view"), narrow = matchMedia("(max-width: 640px)");
  const settle = () => (narrow.matches ? stage.after(panel) : stage.append(panel));
  narrow.addEventListener("change", settle);
  settle();
  coveredWidth = () => (narrow.matches || rows.hidden ? 0 : panel.offsetLeft + panel.offsetWidth);
  open(innerWidth > 640);
}

button(switchBox, "One frame on (→)", "M6 5l9 7-9 7zM18 5v14", () => {
  pause();
  seek(times[Math.min(now.k + 1, count - 1)]);
});
fillPanel();
workAll();
lookFrom();
goToMoment(location.hash);
show();
requestAnimationFrame(liveTick);

Object.assign(window.pydy, {
  live: {
    sliders: sliders.map((one) => one.label),
    get values() { return sliders.map((one) => one.now); },
    /** Move a slider, and simulate to the end before returning; `milliseconds` is what that took. */
    set(label, value) {
      change(sliders.find((one) => one.label === label), value);
      workAll();
      show();
    },
    get status() { return motion.status; },
    /** Whether anything is still to be simulated or drawn. */
    get busy() { return motion.dirty || motion.run !== null || player.stale; },
    /** How many seconds of motion one second computes. */
    get speed() { return (1000 * motion.simulated) / motion.cost; },
    get milliseconds() { return motion.cost; },
    states() { return Array.from({ length: count }, (_, k) => Array.from(motion.states.subarray(k * width, (k + 1) * width))); },
    series() { return series.map((one) => Array.from(times, (time) => valueAt(one, time))); },
  },
});
