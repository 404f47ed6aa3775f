"""opty, as its documentation says; objectives and gradients are written in NumPy, by hand."""

from __future__ import annotations

import time
from typing import Any

import numpy as np
import sympy as sm
import sympy.physics.mechanics as me
from harness.optimal import TASKS, model_of, point, residuals
from harness.serve import Repeated, serve
from opty import Problem

INTERVAL = sm.Symbol("h", real=True)


class Opty:
    def load(self, task: str, nodes: int, method: str, folder: str | None = None) -> Any:
        """Build; return the seconds from the equations to the compiled functions.

        What is compiled already is taken from a folder, if one is given.
        """
        self.task = own = TASKS[task]
        self.nodes, self.method = nodes, method.replace("-", " ")
        model = model_of(own)
        equations = residuals(model)
        states = [*model.coordinates, *model.speeds]
        t = me.dynamicsymbols._t
        h = INTERVAL if own.free else own.duration / (nodes - 1)
        last = (nodes - 1) * INTERVAL if own.free else own.duration
        ends = []
        for time_, values in ((0 * INTERVAL if own.free else 0.0, own.start), (last, own.end)):
            pairs = zip(states, values, strict=True)
            ends += [s.func(time_) - value for s, value in pairs]
        (F,) = model.specifieds
        bounds = {} if own.limit is None else {F: (-own.limit, own.limit)}
        if own.free:
            bounds[INTERVAL] = (0.1 / (nodes - 1), 10.0 / (nodes - 1))
        start = time.perf_counter()
        self.problem = Problem(
            lambda free: self._objective(free),  # a function of two arguments gets the Problem too
            lambda free: self._gradient(free),
            equations,
            states,
            nodes,
            h,
            known_parameter_map=dict(zip(model.constants, model.values, strict=True)),
            instance_constraints=ends,
            time_symbol=t,
            bounds=bounds or None,
            integration_method=self.method,
            tmp_dir=folder,
        )
        seconds = time.perf_counter() - start
        lines = np.linspace(own.start, own.end, nodes).T.ravel()
        self.guess = np.concatenate(
            [lines, np.zeros(nodes), [own.duration / (nodes - 1)] * own.free]
        )
        return {"seconds": seconds}

    def _parts(self, free: np.ndarray) -> tuple[np.ndarray, np.ndarray, float]:
        """Return the last state and the control at the points, and the interval."""
        n, N = len(self.task.start), self.nodes
        x, F = free[(n - 1) * N : n * N], free[n * N : (n + 1) * N]
        if self.method == "midpoint":
            x, F = (x[1:] + x[:-1]) / 2, (F[1:] + F[:-1]) / 2
        else:
            x, F = x[1:], F[1:]
        return x, F, self.task.duration / (N - 1)

    def _objective(self, free: np.ndarray) -> float:
        if self.task.free:
            return float((self.nodes - 1) * free[-1])
        x, F, h = self._parts(free)
        if self.task.objective == "effort":
            return float(h * (F @ F))
        return float(h * (F @ F + x @ x) / 2)

    def _gradient(self, free: np.ndarray) -> np.ndarray:
        slopes = np.zeros(len(free))
        n, N = len(self.task.start), self.nodes
        if self.task.free:
            slopes[-1] = N - 1
            return slopes
        x, F, h = self._parts(free)
        effort = self.task.objective == "effort"
        parts = [(n * N, 2 * h * F)] if effort else [(n * N, h * F), ((n - 1) * N, h * x)]
        for first, slope in parts:
            if self.method == "midpoint":
                slopes[first : first + N - 1] += slope / 2
                slopes[first + 1 : first + N] += slope / 2
            else:
                slopes[first + 1 : first + N] += slope
        return slopes

    def evaluations(self) -> Any:
        """Return rows and J d at a point, and prepare to time."""
        z, d, given = point(self.task, self.nodes)
        free, direction = (self._own(v) for v in (z, d))
        rows, J = self.problem.con(free), self.problem.con_jac(free)
        i, j = self.problem.jacobianstructure()
        slopes = np.bincount(i, J * direction[j], len(rows))
        calls = {"rows": lambda: self.problem.con(free),
                 "jacobian": lambda: self.problem.con_jac(free)}  # fmt: skip
        self.runs = {name: Repeated(call) for name, call in calls.items()}
        count = len(given)
        return {"rows": rows[:count].tolist(), "slopes": slopes[:count].tolist()}

    def _own(self, z: np.ndarray) -> np.ndarray:
        """Return unknowns in opty's order: it has a control at the first node too."""
        own = len(self.task.start) * self.nodes
        last = z[-1:] / (self.nodes - 1) if self.task.free else z[:0]
        return np.concatenate([z[:own], [0.0], z[own : own + self.nodes - 1], last])

    def run(self, kind: str) -> float:
        """Return the seconds of an evaluation."""
        return self.runs[kind]()

    def solve(self, options: dict[str, Any]) -> Any:
        """Solve from the guess."""
        for name, value in {"print_level": 0, "sb": "yes", **options}.items():
            self.problem.add_option(name, value)
        start = time.perf_counter()
        _, info = self.problem.solve(self.guess)
        seconds = time.perf_counter() - start
        if info["status"] not in (0, 1):
            raise RuntimeError(str(info["status_msg"]))
        return {"seconds": seconds, "objective": float(info["obj_val"]), "iterations": None}


if __name__ == "__main__":
    opty = Opty()
    serve({n: getattr(opty, n) for n in ("load", "evaluations", "run", "solve")})
