"""The largest acceleration in a direction, as a nonlinear program over quasi-steady states."""

from __future__ import annotations

from itertools import product

import numpy as np
from scipy.optimize import lsq_linear, minimize

from pydy._rank import HALF, ROUNDED, equilibrated, least_step, or_one
from pydy.vehicles.quasi_steady import QuasiSteadyStates
from pydy.vehicles.tuning import FLAT_OBJECTIVE

_ITERATIONS = 100
_NEWTON = 8  # largest number of steps to the equalities
_SAMPLES = 192  # starts of samples: of each ten, three to six end within the limits
_SAMPLED = 20  # largest number of steps from a start to the sample, which may be far away
_TRACED = 80  # largest number of points on the way from straight ahead
_FIRST, _GROWTH = 1 / 4, 1.5  # step of the acceleration, relative to its scale, and its growth
_SHORTEST = 1 / 64  # of a step, relative to the acceleration; shorter ones end a trace
_WIDTH, _BOXES = 1 / 4, 8  # of a box, relative to the way of a trace; the largest number of boxes
_QUARTER = float(np.sqrt(HALF))

Box = tuple[np.ndarray, np.ndarray]  # the lowest and the highest values of scaled unknowns


def _moved(
    y: np.ndarray, values: np.ndarray, slopes: np.ndarray, box: Box, movable: np.ndarray
) -> np.ndarray:
    """Return unknowns after the least step to zero values within a box."""
    low, high = box
    step, free = np.zeros(len(y)), movable.copy()
    for _ in range(len(y)):
        rest = -values - slopes @ np.where(free, 0.0, step)
        step[free] = least_step(slopes[:, free], rest)
        outside = free & ((y + step < low) | (y + step > high))
        if not outside.any():
            break
        step[outside] = np.clip(y + step, low, high)[outside] - y[outside]
        free &= ~outside
    moved: np.ndarray = np.clip(y + step, low, high)
    return moved


def _spread(count: int, dimension: int) -> np.ndarray:
    """Return points of [-1, 1]^d that fill it evenly: a Kronecker sequence.

    Its steps are powers of 1/φ, where φ is the root of φ^(d + 1) = φ + 1: M. Roberts, The
    unreasonable effectiveness of quasirandom sequences, 2018.
    """
    root = 2.0
    for _ in range(64):
        root = (1.0 + root) ** (1.0 / (dimension + 1))
    steps = root ** -np.arange(1.0, dimension + 1)
    points: np.ndarray = 2.0 * np.mod(0.5 + np.outer(np.arange(1, count + 1), steps), 1.0) - 1.0
    return points


class LargestAcceleration:
    """The largest a with a_t = a cos θ, V ψ' = a sin θ at one speed, within bounds.

    The unknowns y are those of the states, and a as the last, divided by `scale`. Unknowns and rows
    are scaled by the slopes straight ahead, so that nothing depends on units.
    """

    def __init__(self, states: QuasiSteadyStates, speed: float) -> None:
        self.states = states
        rolling = states.rolling(speed)
        low, high = states.bounds(rolling)
        rolling = np.clip(rolling, low, high)
        n = states.equalities
        slopes = states.slopes(rolling)
        last = np.zeros((n, 1))
        last[1:3] = 1.0  # a, in any direction
        _, rows, columns = equilibrated(np.hstack([slopes[:n], last]), exact=True)
        self.scale = columns[0]
        span = high - low
        flat = ~slopes[:n].any(axis=0) & np.isfinite(span)
        self.scale[:-1][flat] = or_one(span)[flat]
        limits = np.abs(slopes[n:] * self.scale[:-1]).max(axis=1, initial=0.0)
        limits = np.maximum(limits, np.abs(states.values(rolling)[n:]))
        self.rows = np.append(rows[:, 0], or_one(limits))
        self.target = np.zeros(len(self.rows))
        self.target[0] = speed
        self.low = np.append(low, 0.0) / self.scale
        self.high = np.append(high, np.inf) / self.scale
        self.rolling = np.append(rolling, 0.0) / self.scale

    def samples(self) -> tuple[np.ndarray, np.ndarray]:
        """Return directions (rad), shape (s,), and unknowns y of states within the limits.

        The starts are spread over the inputs and sideslip angles; of each second start also the
        states that have bounds, such as spins, are spread. From a start, least steps lead to where
        the speed is right and nothing else changes. The acceleration there has some direction: with
        all, samples cover what a path from straight ahead cannot reach, such as an axle that has
        slid over its peak.
        """
        states = self.states
        n, inputs = states.equalities, states.columns >= len(states.names)
        spread = np.isfinite(self.low[:-1]) & np.isfinite(self.high[:-1])
        low, high = np.where(spread, (self.low[:-1], self.high[:-1]), 0.0)
        middle, half = (low + high) / 2.0, (high - low) / 2.0
        balance = np.eye(len(self.rows))[[0, *range(3, n)]]
        found: list[np.ndarray] = []
        angles: list[float] = []
        for k, shares in enumerate(_spread(_SAMPLES, len(half) + 1)):
            placed = spread & (inputs | bool(k % 2))
            start = np.where(placed, middle + half * shares[:-1], self.rolling[:-1])
            moving = self._balanced(start, self._at_sideslip(shares[-1]))
            y = None if moving is None else self._balanced(moving, balance)
            if y is None:
                continue
            values = states.values(y * self.scale[:-1])
            if (values[n:] / self.rows[n:] >= -_QUARTER).all():
                angles.append(float(np.arctan2(values[2], values[1])))
                size = float(np.hypot(values[1], values[2]))
                found.append(np.append(y, size / self.scale[-1]))
        return np.array(angles), np.array(found).reshape(len(found), len(self.scale))

    def _at_sideslip(self, share: float) -> np.ndarray:
        """Return combinations of rows that vanish at V and a share of the largest sideslip."""
        n, size = self.states.equalities, len(self.rows)
        wanted = np.eye(1, size)
        if self.states.limit_names[:2] != ["sideslip"] * 2:
            return wanted
        # The limits are tan(limit) u ± v, which are (1 ± share) tan(limit) u there.
        row = np.zeros(size)
        row[n : n + 2] = np.array([1.0 - share, -1.0 - share]) / 2.0
        return np.array([*wanted, row * self.rows / self.rows[n]])

    def _balanced(self, y: np.ndarray, wanted: np.ndarray) -> np.ndarray | None:
        """Return states within bounds where combinations of rows vanish to a quarter of digits."""
        box, movable = (self.low[:-1], self.high[:-1]), np.ones(len(y), dtype=bool)
        for _ in range(_SAMPLED):
            z = y * self.scale[:-1]
            values = wanted @ ((self.states.values(z) - self.target) / self.rows)
            slopes = wanted @ (self.states.slopes(z) * self.scale[:-1] / self.rows[:, None])
            if not (np.isfinite(values).all() and np.isfinite(slopes).all()):
                return None
            if (np.abs(values) <= _QUARTER).all():
                return y
            y = _moved(y, values, slopes, box, movable)
        return None

    def active(self, y: np.ndarray) -> tuple[str, ...]:
        """Return the names of unknowns at their bounds, and of limits that are reached."""
        states = self.states
        names = [[*states.names, *states.controls][k] for k in states.columns]
        for at, (_, second) in zip(states.signed, states.pairs, strict=True):
            if y[at] < 0.0:
                names[at] = states.controls[second - len(states.names)]
        size = HALF * np.maximum(1.0, np.abs(y))
        at_bounds = ((y - self.low <= size) | (self.high - y <= size))[:-1]
        values = states.values(y[:-1] * self.scale[:-1])[states.equalities :]
        reached = values / self.rows[states.equalities :] <= _QUARTER
        found = [name for name, there in zip(names, at_bounds, strict=True) if there]
        found += [n for n, there in zip(states.limit_names, reached, strict=True) if there]
        return tuple(dict.fromkeys(found))

    def direction(self, angle: float) -> Direction:
        """Return the program in one direction."""
        return Direction(self, angle)


class Direction:
    """The program in one direction; the rows at the last point are stored."""

    def __init__(self, problem: LargestAcceleration, angle: float) -> None:
        self.problem, self.n = problem, problem.states.equalities
        self.direction = np.zeros(len(problem.rows))
        self.direction[1:3] = np.cos(angle), np.sin(angle)
        self._at: tuple[np.ndarray, tuple[float, ...]] | None = None
        self._rows = np.zeros(0), np.zeros(0)

    def at(self, y: np.ndarray, sides: tuple[float, ...] = ()) -> tuple[np.ndarray, np.ndarray]:
        """Return the rows and their derivatives at scaled unknowns."""
        if self._at is None or self._at[1] != sides or not np.array_equal(y, self._at[0]):
            p = self.problem
            z, a = y[:-1] * p.scale[:-1], y[-1] * p.scale[-1]
            values = p.states.values(z) - p.target - self.direction * a
            slopes = np.column_stack([p.states.slopes(z, sides), -self.direction]) * p.scale
            self._at, self._rows = (y.copy(), sides), (values / p.rows, slopes / p.rows[:, None])
        return self._rows

    def trace(self) -> np.ndarray:
        """Return the last state on a path from straight ahead along which a grows.

        The path ends where no state nearby has a larger acceleration, or at limits.
        """
        y: np.ndarray = self.problem.rolling
        step, started = _FIRST, False
        for k in range(_TRACED):
            target = y[-1] + (step if k else 0.0)
            found = self._solved(np.append(y[:-1], target))
            if found is not None:
                y, started, step = found, True, step * _GROWTH
            elif started:
                step /= 2.0
                if step < _SHORTEST * max(y[-1], _FIRST):
                    break
            else:  # a speed that cannot be kept may be that of a vehicle that brakes
                y = np.append(y[:-1], target)
        return y

    def _solved(self, y: np.ndarray, box: Box | None = None) -> np.ndarray | None:
        """Return a point nearby that satisfies equalities and limits, or None.

        The acceleration remains unless a box is passed, at whose faces unknowns remain.
        """
        p = self.problem
        low, high = (p.low, p.high) if box is None else box
        y = np.clip(y, low, high)
        movable = np.ones(len(y), dtype=bool)
        movable[-1] = box is not None
        if box is not None:
            movable[:-1] = (y > low)[:-1] & (y < high)[:-1]
        for _ in range(_NEWTON):
            values, slopes = self.at(y)
            if not (np.isfinite(values).all() and np.isfinite(slopes).all()):
                return None
            bound = ROUNDED * (np.abs(slopes[: self.n]) @ np.maximum(np.abs(y), 1.0))
            if (np.abs(values[: self.n]) <= bound).all():
                return y if (values[self.n :] >= -HALF).all() else None
            y = _moved(y, values[: self.n], slopes[: self.n], (low, high), movable)
        return None

    def improved(self, y: np.ndarray) -> np.ndarray | None:
        """Return the best optimum that searches from a point reach, or None."""
        p = self.problem
        found: list[np.ndarray] = []
        choices = [(float(np.sign(y[k])),) if y[k] != 0.0 else (1.0, -1.0) for k in p.states.signed]
        tried: set[tuple[float, ...]] = set()
        todo = list(product(*choices))
        while todo:
            sides = todo.pop()
            tried.add(sides)
            best = self._within(y, sides)
            if best is None:
                continue
            found.append(best)
            for i, k in enumerate(p.states.signed):
                other = tuple(-s if j == i else s for j, s in enumerate(sides))
                if best[k] == 0.0 and other not in tried:
                    todo.append(other)
        return max(found, key=lambda one: float(one[-1]), default=None)

    def _within(self, y: np.ndarray, sides: tuple[float, ...]) -> np.ndarray | None:
        """Return an optimum in which inputs of pairs have given signs, or None.

        Searches are confined to boxes, so that none leaves for where forces no longer change.
        """
        p = self.problem
        low, high = p.low.copy(), p.high.copy()
        for k, side in zip(p.states.signed, sides, strict=True):
            low[k], high[k] = (0.0, high[k]) if side > 0.0 else (low[k], 0.0)
        width = _WIDTH * max(1.0, np.abs(y - p.rolling).max())
        for _ in range(_BOXES):
            box = np.maximum(low, y - width), np.minimum(high, y + width)
            found = self._searched(np.clip(y, low, high), box, sides)
            if found is None:
                return None
            confined = ((found <= box[0]) & (box[0] > low)) | ((found >= box[1]) & (box[1] < high))
            y = found
            if not confined.any():
                return y if self._is_optimum(y, (low, high), sides) else None
        return None

    def _searched(self, y: np.ndarray, box: Box, sides: tuple[float, ...]) -> np.ndarray | None:
        """Return where a search in a box ends, or None unless that satisfies the equalities."""
        gradient = np.append(np.zeros(len(y) - 1), -1.0)
        parts = [("eq", slice(self.n)), ("ineq", slice(self.n, None))]
        constraints = [
            {
                "type": kind,
                "fun": lambda y, part=part: self.at(y, sides)[0][part],
                "jac": lambda y, part=part: self.at(y, sides)[1][part],
            }
            for kind, part in parts[: 2 if self.problem.states.limits else 1]
        ]
        with np.errstate(all="ignore"):
            try:
                found = minimize(
                    lambda y: -y[-1],
                    y,
                    jac=lambda _: gradient,
                    method="SLSQP",
                    bounds=np.stack(box, axis=1),
                    constraints=constraints,
                    options={"maxiter": _ITERATIONS, "ftol": FLAT_OBJECTIVE},
                )
            except (ValueError, np.linalg.LinAlgError):  # values that are not finite
                return None
            return self._solved(found.x, box)

    def _is_optimum(self, y: np.ndarray, box: Box, sides: tuple[float, ...]) -> bool:
        """Return whether multipliers of the right sign balance the gradient of the acceleration.

        A gradient of ε that remains changes the objective by ε², so that a quarter of the digits
        is enough for half of the digits of the objective.
        """
        values, slopes = self.at(y, sides)
        unit, size = np.eye(len(y)), _QUARTER * np.maximum(1.0, np.abs(y))
        active = slopes[self.n :][values[self.n :] <= _QUARTER]
        edges = [*unit[y - box[0] <= size], *-unit[box[1] - y <= size]]
        normals = np.array([*slopes[: self.n], *active, *edges])
        least = np.append(np.full(self.n, -np.inf), np.zeros(len(normals) - self.n))
        most = np.full(len(least), np.inf)
        fit = lsq_linear(normals.T, -unit[-1], (least, most), tol=FLAT_OBJECTIVE)
        return bool(np.abs(fit.fun).max() <= _QUARTER)
