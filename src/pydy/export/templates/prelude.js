const { sqrt, exp, log, sin, cos, tan, asin, acos, atan, sinh, cosh, tanh, asinh, acosh, atanh,
  floor, ceil, pow, atan2, sign } = Math;
const fabs = Math.abs, minimum = Math.min, maximum = Math.max, NAN = NaN, INFINITY = Infinity;

// Factorise the n by n matrix a in place by LU with partial pivoting, rows and columns scaled;
// return whether it is singular, its last pivot then being NaN and so every solution.
function luFactor(n, a, pivots, scales) {
  const tolerance = n * SINGULAR;
  let singular = false;
  for (let i = 0; i < n; i++) {
    let top = 0;
    for (let j = 0; j < n; j++) if (fabs(a[i * n + j]) > top) top = fabs(a[i * n + j]);
    scales[i] = 1 / (top > 0 ? top : 1);
  }
  for (let j = 0; j < n; j++) {
    let top = 0;
    for (let i = 0; i < n; i++) {
      const size = fabs(a[i * n + j]) * scales[i];
      if (size > top) top = size;
    }
    scales[n + j] = 1 / (top > 0 ? top : 1);
  }
  for (let k = 0; k < n; k++) {
    let pivot = k, best = fabs(a[k * n + k]) * scales[k];
    for (let i = k + 1; i < n; i++) {
      const size = fabs(a[i * n + k]) * scales[i];
      if (size > best) {
        best = size;
        pivot = i;
      }
    }
    if (best * scales[n + k] <= tolerance) singular = true;
    pivots[k] = pivot;
    if (pivot !== k) {
      for (let j = 0; j < n; j++) {
        const swapped = a[k * n + j];
        a[k * n + j] = a[pivot * n + j];
        a[pivot * n + j] = swapped;
      }
      const swapped = scales[k];
      scales[k] = scales[pivot];
      scales[pivot] = swapped;
    }
    const inverse = 1 / a[k * n + k];
    for (let i = k + 1; i < n; i++) {
      const factor = a[i * n + k] * inverse;
      a[i * n + k] = factor;
      for (let j = k + 1; j < n; j++) a[i * n + j] -= factor * a[k * n + j];
    }
  }
  if (singular) a[n * n - 1] = NaN;
  return singular;
}

// Solve in place of the right-hand side b, with the factors from luFactor.
function luSolve(n, a, pivots, b) {
  for (let k = 0; k < n; k++) {
    const swapped = b[k];
    b[k] = b[pivots[k]];
    b[pivots[k]] = swapped;
  }
  for (let i = 0; i < n; i++) for (let k = 0; k < i; k++) b[i] -= a[i * n + k] * b[k];
  for (let i = n - 1; i >= 0; i--) {
    for (let k = i + 1; k < n; k++) b[i] -= a[i * n + k] * b[k];
    b[i] /= a[i * n + i];
  }
}

// Solve M x - A^T l = f, A x = b in place of right-hand sides, so many numbers in all, by Gauss and
// Jordan's elimination, whatever the rank of A. The last rows, marked on the diagonal, are those of A in units of their
// rounding errors; so many are independent as are marked so. Pivots are the largest entries of A,
// then of the diagonal of M. Return whether M is singular.
function constrained(n, a, pivots, scales, many, b) {
  let first = n, left = 0, singular = false, rest = 0, any = 0;
  for (let i = 0; i < many; i++) any += 0 * b[i];
  for (let i = 0; i < n; i++) {
    pivots[i] = -1;
    for (let j = 0; j < n; j++) rest += 0 * a[i * n + j];
  }
  for (; first; first--) {
    const mark = a[first * n - n + first - 1];
    if (mark !== INDEPENDENT && mark !== REDUNDANT) break;
    if (mark === INDEPENDENT) left++;
    a[first * n - n + first - 1] = 0;
  }
  for (let j = 0; j < first; j++) {
    let top = 0;
    for (let i = first; i < n; i++) if (fabs(a[i * n + j]) > top) top = fabs(a[i * n + j]);
    scales[j] = a[j * n + j] > 0 ? 1 / sqrt(a[j * n + j]) : 1 / (SINGULAR * (top > 0 ? top : 1));
  }
  for (let k = 0; k < first; k++) {
    let best = n, row = -1, column = -1;
    for (let i = first; left && i < n; i++) {
      for (let j = 0; j < first && pivots[i] < 0; j++) {
        const size = fabs(a[i * n + j]) * scales[j];
        if (pivots[j] < 0 && size > best) {
          best = size;
          row = i;
          column = j;
        }
      }
    }
    if (row >= 0) left--;
    else {
      left = 0;
      best = n * SINGULAR;
      for (let j = 0; j < first; j++) {
        const size = fabs(a[j * n + j]) * scales[j] * scales[j];
        if (pivots[j] < 0 && size > best) {
          best = size;
          row = column = j;
        }
      }
    }
    if (row < 0) {
      singular = rest + any === 0;
      rest = NaN;
      break;
    }
    for (const [p, q] of row === column ? [[row, row]] : [[row, column], [column, row]]) {
      const inverse = 1 / a[p * n + q];
      for (let i = 0; i < n; i++) {
        const factor = a[i * n + q] * inverse;
        if (i === p || factor === 0) continue;
        for (let j = 0; j < n; j++) a[i * n + j] -= factor * a[p * n + j];
        for (let k = 0; k < many; k += n) b[k + i] -= factor * b[k + p];
      }
      pivots[p] = q;
    }
  }
  for (let k = 0; k < many; k += n) {
    let added = rest;
    for (let i = k; i < k + n; i++) added += 0 * b[i];
    scales.fill(0, n);
    for (let i = 0; i < n; i++) {
      if (pivots[i] >= 0) scales[n + pivots[i]] = b[k + i] / a[i * n + pivots[i]];
    }
    for (let i = 0; i < n; i++) b[k + i] = scales[n + i] + added;
  }
  return singular;
}
