// Constraints held: the state is moved back onto them by the least motion, in the norm of the mass
// matrix. E. Hairer, C. Lubich, G. Wanner, Geometric Numerical Integration, section IV.4.

/** Replace a symmetric matrix by its Cholesky factor; by the identity where it has none. */
function choleskyFactor(n, a) {
  for (let j = 0; j < n; j++) {
    let pivot = a[j * n + j];
    for (let k = 0; k < j; k++) pivot -= a[j * n + k] ** 2;
    if (!(pivot > 4 * n * EPS * a[j * n + j])) {
      a.fill(0);
      for (let i = 0; i < n; i++) a[i * n + i] = 1;
      return;
    }
    a[j * n + j] = Math.sqrt(pivot);
    for (let i = j + 1; i < n; i++) {
      let value = a[i * n + j];
      for (let k = 0; k < j; k++) value -= a[i * n + k] * a[j * n + k];
      a[i * n + j] = value / a[j * n + j];
    }
  }
}

/** Replace each of m rows a by a L⁻ᵀ. */
function divideRows(m, n, rows, factor) {
  for (let row = 0; row < m; row++) for (let i = 0; i < n; i++) {
    let value = rows[row * n + i];
    for (let k = 0; k < i; k++) value -= factor[i * n + k] * rows[row * n + k];
    rows[row * n + i] = value / factor[i * n + i];
  }
}

/** Replace y by L⁻ᵀ y. */
function divideTransposed(n, factor, y) {
  for (let i = n - 1; i >= 0; i--) {
    let value = y[i];
    for (let k = i + 1; k < n; k++) value -= factor[k * n + i] * y[k];
    y[i] = value / factor[i * n + i];
  }
}

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
    let pivot = -1, longest = 1e-20;
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
    choleskyFactor(u, factor);
    return factor;
  };
  /** Tell how far positions are from the constraints, in roundings, and whether that is good enough. */
  const judge = (before, redundant) => {
    let worst = 0;
    for (let i = 0; i < h; i++) {
      if (Number.isNaN(values[i])) return { worst: NaN, done: false };
      if (values[i] !== 0 && !redundant.has(i)) worst = Math.max(worst, Math.abs(values[i]) / (EPS * values[starts[6] + i]));
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
        rows[i * u + k] = Math.abs(total) <= 4 * q * EPS * size ? 0 : total; // nothing but rounding
      }
      divideRows(h, u, rows, factor);
      const right = part(0).map((value) => -value), step = minimumNorm(h, u, rows, right, positions);
      divideTransposed(u, factor, step);
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
      divideRows(v, u, rows, factor);
      const step = minimumNorm(v, u, rows, right, motions);
      divideTransposed(u, factor, step);
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
    const fast = Math.max({{HALF}} * far, ...[before, x].map((values) => largest(values.subarray(q, q + u))));
    const unit = (most) => Math.max(Math.min(1, most), {{HALF}} * most);
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
const SOUND = {{SOUND}}; // rows that are this much shorter without others make room for redundant ones
const STARTING_MOVE = {{STARTING_MOVE}}; // how far a state is moved onto the constraints unasked, in units of itself and the largest of its kind
