const { sqrt, exp, log, sin, cos, tan, asin, acos, atan, sinh, cosh, tanh, asinh, acosh, atanh,
  floor, ceil, pow, atan2, sign } = Math;
const fabs = Math.abs, minimum = Math.min, maximum = Math.max, NAN = NaN, INFINITY = Infinity;

const SINGULAR = {{SINGULAR}}; // the least pivot, in units of its row and column and of n

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
