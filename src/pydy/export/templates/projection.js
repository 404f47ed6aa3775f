// Constraints held: the state is moved back onto them by the least motion, in the norm of the mass
// matrix. E. Hairer, C. Lubich, G. Wanner, Geometric Numerical Integration, section IV.4.

// What the factorisation is written with, of one lane.
const root = Math.sqrt, item = (a, i) => a[i], where = (f, x, y) => (f ? x : y), bits = Number, flags = Boolean;
const put = (a, i, value) => { a[i] = value; };
const EVERY = 1;
/*ALGEBRA*/
/**
 * Return the least y with rows · y = right; `right` keeps what no y can reach. There may be more rows
 * than their rank: the last ones take the place of others that are nearly dependent, and
 * `y.redundant` has those that were not needed.
 */
function minimumNorm(m, n, rows, right, rank) {
  const y = new Float64Array(n), scale = new Float64Array(m).fill(1), left = new Set();
  const square = (i) => {
    let total = 0;
    for (let k = 0; k < n; k++) total += rows[i * n + k] ** 2;
    return total;
  };
  for (let i = 0; i < m; i++) {
    left.add(i);
    const norm = square(i);
    if (norm > 0) {
      scale[i] = 1 / Math.sqrt(norm);
      right[i] *= scale[i];
      for (let k = 0; k < n; k++) rows[i * n + k] *= scale[i];
    }
  }
  let count = 0;
  for (; count < rank; count++) {
    let pivot = -1, longest = DEPENDENT ** 2;
    for (const i of left) { // in ascending order
      if (i >= rank && pivot >= 0 && pivot < rank && longest > SOUND ** 2) break;
      if (square(i) > longest) {
        pivot = i;
        longest = square(i);
      }
    }
    if (pivot < 0) break;
    left.delete(pivot);
    const length = Math.sqrt(longest), z = right[pivot] / length;
    right[pivot] = 0;
    for (let k = 0; k < n; k++) {
      rows[pivot * n + k] /= length;
      y[k] += z * rows[pivot * n + k];
    }
    for (const i of left) {
      let along = 0;
      for (let k = 0; k < n; k++) along += rows[i * n + k] * rows[pivot * n + k];
      right[i] -= along * z;
      for (let k = 0; k < n; k++) rows[i * n + k] -= along * rows[pivot * n + k];
    }
  }
  for (let i = 0; i < m; i++) right[i] = count === rank && rank < m ? 0 : right[i] / scale[i];
  y.redundant = rank < m ? left : new Set();
  return y;
}

/**
 * Return `project(t, x)`, which moves x onto the constraints and tells whether it could. The blocks
 * that `evaluate(t, x, out)` writes: residuals of positions and velocities, gradient, kinematics,
 * gradient by speeds, mass matrix, and what rounding may make of the first.
 */
function projector(sizes, evaluate) {
  const { holonomic: h, velocity: v, positions, motions, coordinates: q, speeds: u, weighted, following } = sizes;
  const starts = [0];
  for (const size of [h, v, h * q, q * u, v * u, weighted ? u * u : 0, h]) starts.push(starts[starts.length - 1] + size);
  const values = new Float64Array(starts[7]);
  const part = (k) => Float64Array.from(values.subarray(starts[k], starts[k + 1]));
  const identity = new Float64Array(u * u);
  for (let i = 0; i < u; i++) identity[i * u + i] = 1;
  const massFactor = () => {
    if (!weighted) return identity;
    const factor = part(5);
    factorise(factor, u);
    return factor;
  };
  /** Tell how far positions are from the constraints, in roundings, and whether that is good enough. */
  const judge = (before, redundant) => {
    let worst = 0;
    for (let i = 0; i < h; i++) {
      if (Number.isNaN(values[i])) return { worst: NaN, done: false };
      if (values[i] !== 0 && !redundant.has(i)) worst = Math.max(worst, Math.abs(values[i]) / (ROUNDING * values[starts[6] + i]));
    }
    return { worst, done: worst <= 1 || (worst >= 0.5 * before && worst <= ROUNDINGS) };
  };
  const project = (t, x) => {
    let before = Infinity, redundant = new Set();
    for (let iteration = 0; iteration < 10; iteration++) {
      evaluate(t, x, values);
      const { worst, done } = judge(before, redundant);
      if (done) break;
      if (iteration === 9 || Number.isNaN(worst)) return false;
      before = worst;
      const factor = massFactor(), gradient = part(2), kinematics = part(3), rows = new Float64Array(h * u);
      for (let i = 0; i < h; i++) for (let k = 0; k < u; k++) {
        let total = 0, size = 0;
        for (let j = 0; j < q; j++) {
          const term = gradient[i * q + j] * kinematics[j * u + k];
          total += term;
          size += Math.abs(term);
        }
        rows[i * u + k] = Math.abs(total) <= 4 * q * ROUNDING * size ? 0 : total; // nothing but rounding
      }
      divide_rows(rows, h, factor, u);
      const right = part(0).map((value) => -value), step = minimumNorm(h, u, rows, right, positions);
      divide_transposed(factor, u, step);
      for (let j = 0; j < q; j++) for (let k = 0; k < u; k++) x[j] += kinematics[j * u + k] * step[k];
      redundant = step.redundant;
      if (right.some((rest) => rest !== 0)) {
        const rest = minimumNorm(h, q, gradient, right, positions);
        rest.forEach((move, j) => { x[j] += move; });
        redundant = rest.redundant;
      }
    }
    if (v > 0) {
      const factor = massFactor(), rows = part(4), right = part(1).map((value) => -value);
      divide_rows(rows, v, factor, u);
      const step = minimumNorm(v, u, rows, right, motions);
      divide_transposed(factor, u, step);
      for (let k = 0; k < u; k++) x[q + k] += step[k];
    }
    return true;
  };
  /** Move a state that begins a motion; return why not, as where it is far from the constraints. */
  project.begin = (t, x) => {
    const before = Float64Array.from(x);
    if (!project(t, x)) return "the constraints could not be met";
    const largest = (values) => values.reduce((most, one) => Math.max(most, Math.abs(one)), 0);
    const far = largest(before.subarray(0, q)) || 1; // in any unit
    const fast = Math.max(HALF * far, ...[before, x].map((values) => largest(values.subarray(q, q + u))));
    const unit = (most) => Math.max(Math.min(1, most), HALF * most);
    const off = (one, k) => !following.includes(k) && Math.abs(x[k] - one) > STARTING_MOVE * (unit(k < q ? far : fast) + Math.abs(one));
    return before.some(off) ? "the initial conditions do not satisfy the constraints" : "";
  };
  /** Solve for some coordinates and speeds, the others held. */
  project.settle = (t, x, dependentQ, dependentU) => {
    const move = (rows, width, right, places, first, rank) => {
      const few = new Float64Array(right.length * places.length);
      right.forEach((_, i) => places.forEach((place, k) => { few[i * places.length + k] = rows[i * width + place - first]; }));
      const step = minimumNorm(right.length, places.length, few, right, rank);
      places.forEach((place, k) => { x[place] += step[k]; });
      return step.redundant;
    };
    let before = Infinity, redundant = new Set();
    for (let iteration = 0; h > 0; iteration++) {
      evaluate(t, x, values);
      const { worst, done } = judge(before, redundant);
      if (done) break;
      if (iteration === 50 || Number.isNaN(worst)) return false;
      before = worst;
      redundant = move(part(2), q, part(0).map((value) => -value), dependentQ, 0, positions);
    }
    evaluate(t, x, values);
    if (v > 0) move(part(4), u, part(1).map((value) => -value), dependentU, q, motions);
    return x.every(Number.isFinite);
  };
  return project;
}
