(() => {
"use strict";
/*PRELUDE*/
/*CODE*/
/*BUFFERS*/
/*CONSTANTS*/
/*INTEGRATOR*/
/*PROJECTION*/
const method = /*METHOD*/;
const info = /*INFO*/;
const eventNames = /*EVENTS*/;
const allResets = new Float64Array(eventNames.names.length * info.states.length);
const defaults = (variables) => Float64Array.from(variables, (one) => one.value);

function numeric(value, key, what) {
  if (!Number.isFinite(value)) throw new TypeError(`${what}: ${key} must be a finite number, got ${value}`);
}

/** Take an array, an object or Map of values by identifier or name, or nothing for the defaults. */
function ordered(given, variables, what) {
  const values = defaults(variables);
  if (given === undefined || given === null) return values;
  if (Array.isArray(given) || ArrayBuffer.isView(given)) { // an object may have a constant `length`
    if (given.length !== values.length) throw new RangeError(`${what}: expected ${values.length} numbers, got ${given.length}`);
    for (let k = 0; k < given.length; k++) numeric(given[k], variables[k].id, what);
    return Float64Array.from(given);
  }
  const kind = Object.prototype.toString.call(given).slice(8, -1); // others would show no entries
  if (!["Object", "Map"].includes(kind)) throw new TypeError(`${what} must be an array, an object or a Map, got ${String(given)}`);
  for (const [key, value] of kind === "Map" ? given : Object.entries(given)) {
    const k = variables.findIndex((one) => one.id === key || one.name === key);
    if (k < 0) throw new RangeError(`${what}: no ${key}; there are ${variables.map((one) => one.id).join(", ")}`);
    numeric(value, key, what);
    values[k] = value;
  }
  return values;
}

/** Take the constants with which everything is computed from now on. */
function bind(given) {
  const p = ordered(given, info.constants, "constants");
/*BOUND*/
  return p;
}
bind();

/**
 * Describe the constraint that a start violates most, by how often its residual exceeds what typed digits
 * and rounding allow, or return "": the rule of `violations` in pydy/_judges/constraint_drift.py.
 */
const constraintNames = /*CONSTRAINT_NAMES*/;
function violation(t, x, r) {
  const count = constraintNames.length, values = new Float64Array(3 * count);
  let text = "", largest = 1;
  if (/*START_RESIDUALS*/) return "";
  for (let k = 0; k < count; k++) {
    const rounded = values[2 * count + k], size = Math.abs(values[k]);
    const allowed = values[count + k] + (Number.isFinite(rounded) ? rounded : 0);
    if (size <= allowed) continue;
    const share = Number.isNaN(size) || allowed === 0 ? Infinity : size / allowed;
    if (text && !(share > largest)) continue;
    largest = share;
    text = `the residual at t = ${t} is ${values[k].toPrecision(3)} in the ${constraintNames[k]}`;
  }
  return text;
}

const self = {
  ...info,
  bind,
  /** Write the derivatives of the states to `out`; return whether the mass matrix was singular. */
  rates: (t, x, r, out) => rates(t, x, r, rates_c, out),
  /** Write the outputs. */
  evaluateOutputs: (t, x, r, out) => outputs(t, x, r, outputs_c, out),/*EXTRAS*/
  eventNames: eventNames.names,
  /** Solve the constraints for the states at the places `q` and `u`; return whether that worked. */
  settle(t, x, r, q, u) {
    const held = /*SYSTEM_PROJECTION*/;
    return held === null || held.settle(t, x, q, u);
  },
  /** Return an integration that is stepped by hand; `onRow(k, t, x)` gets the states at `times`. */
  integration(times, x0, r, onRow, options) {
    const system = {
      n: info.states.length,
      rates: (t, x, out) => rates(t, x, r, rates_c, out),
      events: /*SYSTEM_EVENTS*/,
      projection: /*SYSTEM_PROJECTION*/,
      switches: /*SYSTEM_SWITCHES*/,
    };
    return new Integration(system, method, times, x0, onRow, options);
  },
  /**
   * Integrate from times[0]; initial conditions, inputs and constants are arrays or objects, and
   * default to what they were in Python. Returns `times`, `states` (a row for each time, NaN after a
   * terminal event), `status`, `events` and counts.
   */
  simulate({ times, initial, inputs, constants, ...options } = {}) {
    const n = info.states.length, states = [];
    for (const k of info.unknowns) { // residuals give them where other values are given: Python solves these
      const { id } = info.states[k], known = ordered(initial, info.states.map((one, i) => ({ ...one, value: i === k ? NaN : 0 })), "initial");
      if ((initial || inputs || constants) && Number.isNaN(known[k])) throw new RangeError(`initial must give ${id} too, with which the residuals of \`implicit\` are zero: what is given may change it`);
    }
    bind(constants);
    const x0 = ordered(initial, info.states, "initial"), r = ordered(inputs, info.inputs, "inputs");
    const run = self.integration(times, x0, r, (k, t, x) => { states[k] = Float64Array.from(x); }, options);
    const off = violation(run.t, x0, r); // before the run moves them
    if (off) console.warn(`The initial conditions do not satisfy the constraints, and nothing will bring the motion back onto them: ${off}. Give \`initial\` values that satisfy them at times[0] with these constants, or export the model with \`times\` that begin there, with these constants and after set_dependent_initial_conditions()`);
    run.advance();
    for (let k = 0; k < times.length; k++) states[k] ??= new Float64Array(n).fill(NaN);
    const { status, steps, rejected, evaluations } = run;
    const events = run.records.map((one) => ({ time: one.time, name: eventNames.names[one.index] }));
    return { times, states, status, events, steps, rejected, evaluations };
  },
};
return self;
})()
