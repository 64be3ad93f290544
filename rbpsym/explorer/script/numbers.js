// Numerical mathematics: linear equations, a step of Dormand and Prince, Newton's method for conditions.

/** The solution of matrix · x = right, by elimination with pivots; rows beyond those needed must agree. */
function solve(matrix, right) {
  const n = matrix[0].length, rows = matrix.map((row, k) => [...row, right[k]]), found = new Array(n);
  for (let k = 0; k < n; k++) {
    let best = k;
    for (let i = k + 1; i < rows.length; i++) if (Math.abs(rows[i][k]) > Math.abs(rows[best][k])) best = i;
    [rows[k], rows[best]] = [rows[best], rows[k]];
    for (let i = k + 1; i < rows.length; i++) {
      const share = rows[i][k] / rows[k][k];
      if (share) for (let j = k; j <= n; j++) rows[i][j] -= share * rows[k][j];
    }
  }
  for (let k = n - 1; k >= 0; k--) {
    let rest = rows[k][n];
    for (let j = k + 1; j < n; j++) rest -= rows[k][j] * found[j];
    found[k] = rest / rows[k][k];
  }
  return found;
}

// Hairer, Nørsett, Wanner, Solving Ordinary Differential Equations I, table II.5.2.
const NODES = [0, 1 / 5, 3 / 10, 4 / 5, 8 / 9, 1, 1];
const STAGES = [
  [], [1 / 5], [3 / 40, 9 / 40], [44 / 45, -56 / 15, 32 / 9],
  [19372 / 6561, -25360 / 2187, 64448 / 6561, -212 / 729],
  [9017 / 3168, -355 / 33, 46732 / 5247, 49 / 176, -5103 / 18656],
  [35 / 384, 0, 500 / 1113, 125 / 192, -2187 / 6784, 11 / 84],
];
const DIFFERENCE = [71 / 57600, 0, -71 / 16695, 71 / 1920, -17253 / 339200, 22 / 525, -1 / 40];
const RELATIVE = 1e-10, ABSOLUTE = 1e-12, MOST_STEPS = 4000;

/** y(from + span), for dy/dt = rate(y, t), with steps that keep the error below the tolerances; null if it fails. */
function advance(rate, y, from, span) {
  let done = 0, step = span, tries = 0;
  while (done < span) {
    if (++tries > MOST_STEPS) return null;
    step = Math.min(step, span - done);
    const [next, error] = oneStep(rate, y, from + done, step);
    if (!(error <= 1)) {
      step *= Number.isFinite(error) ? Math.max(0.2, 0.9 * Math.pow(error, -0.2)) : 0.2;
      if (step < 1e-13 * Math.max(1, from)) return null;
      continue;
    }
    done += step;
    y = next;
    step *= Math.min(5, 0.9 * Math.pow(Math.max(error, 1e-8), -0.2));
  }
  return y;
}

/** [the state after a step, its error over the tolerance]. */
function oneStep(rate, y, t, h) {
  const slopes = [], size = y.length;
  let state = y;
  for (let k = 0; k < 7; k++) {
    if (k) {
      state = new Array(size);
      for (let i = 0; i < size; i++) {
        let sum = y[i];
        for (let j = 0; j < k; j++) sum += h * STAGES[k][j] * slopes[j][i];
        state[i] = sum;
      }
    }
    slopes.push(rate(state, t + NODES[k] * h));
  }
  let worst = 0;
  for (let i = 0; i < size; i++) {
    let gap = 0;
    for (let k = 0; k < 7; k++) gap += h * DIFFERENCE[k] * slopes[k][i];
    const share = Math.abs(gap) / (ABSOLUTE + RELATIVE * Math.max(Math.abs(y[i]), Math.abs(state[i])));
    worst = Number.isNaN(share) ? NaN : Math.max(worst, share);
  }
  return [state, worst];
}

/** The state whose coordinates keep the conditions, the nearest one; `free` are the places that may change. */
function kept(conditions, state, free) {
  for (let round = 0; round < 40; round++) {
    const rows = conditions(state);
    const size = Math.max(...rows.map(([gap]) => Math.abs(gap)));
    if (!(size > 1e-13)) return state;
    const slopes = rows.map(([, all]) => free.map((k) => all[k]));
    const square = slopes.map((a, r) => slopes.map((b, q) => a.reduce((sum, value, k) => sum + value * b[k], r === q ? 1e-12 : 0)));  // also of conditions that say the same
    const share = solve(square, rows.map(([gap]) => gap));
    state = state.slice();
    free.forEach((place, k) => { state[place] -= slopes.reduce((sum, row, r) => sum + row[k] * share[r], 0); });
  }
  return state;
}
