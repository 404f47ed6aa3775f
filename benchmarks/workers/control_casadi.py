"""CasADi: a Function of an interval, mapped over all, and IPOPT with ``expand``."""

from __future__ import annotations

import time
from typing import Any

import casadi as ca
import numpy as np
from harness.convert import translate
from harness.optimal import TASKS, model_of, point
from harness.serve import Repeated, module_at, serve

Algebra = module_at(__file__.replace("control_casadi", "casadi_")).CasADi


class CasADi:
    def load(self, task: str, nodes: int, method: str) -> Any:
        """Build; return the seconds from the equations to the solver."""
        self.task = own = TASKS[task]
        self.nodes, M = nodes, nodes - 1
        model = model_of(own)
        start = time.perf_counter()
        n, k = len(own.start), len(model.coordinates)
        x0, x1, u, h = (ca.SX.sym(name, size) for name, size in zip("abuh", (n, n, 1, 1)))  # noqa: B905
        x = x1 if method == "backward-euler" else (x0 + x1) / 2
        matrix, forcing, rates = translate(model, Algebra(), x, u, ca.DM(model.values))
        slope = (x1 - x0) / h
        rows = [slope[i] - rate for i, rate in enumerate(rates)]
        m = n - k
        for i in range(m):
            pairs = zip(matrix[i * m : (i + 1) * m], ca.vertsplit(slope[k:]), strict=True)
            rows.append(sum(a * s for a, s in pairs if a is not None) - forcing[i])
        cost = {"effort": h * u**2, "time": h, "quadratic": h * (x[-1] ** 2 + u**2) / 2}
        interval = ca.Function("f", [x0, x1, u, h], [ca.vertcat(*rows), cost[own.objective]])
        X, U = ca.MX.sym("X", n, nodes), ca.MX.sym("U", 1, M)
        T = ca.MX.sym("T") if own.free else ca.MX(own.duration)
        g, costs = interval.map(M)(X[:, :-1], X[:, 1:], U, ca.repmat(T / M, 1, M))
        w = ca.vertcat(ca.vec(X), ca.vec(U), *([T] if own.free else []))
        self.problem = {"x": w, "f": T if own.free else ca.sum2(costs), "g": ca.vec(g)}
        quiet = {"expand": True, "print_time": False, "ipopt.print_level": 0, "ipopt.sb": "yes"}
        self.quiet = quiet
        self.solver = ca.nlpsol("s", "ipopt", self.problem, {**quiet, "ipopt.tol": 1e-8})
        seconds = time.perf_counter() - start
        lines = np.linspace(own.start, own.end, nodes)
        self.guess = np.concatenate([lines.ravel(), np.zeros(M), [own.duration] * own.free])
        low, high = np.full(len(self.guess), -np.inf), np.full(len(self.guess), np.inf)
        for side in (low, high):
            side[:n], side[n * M : n * nodes] = own.start, own.end
        if own.limit is not None:
            low[n * nodes : n * nodes + M], high[n * nodes : n * nodes + M] = -own.limit, own.limit
        if own.free:
            low[-1], high[-1] = 0.1, 10.0
        self.bounds = low, high
        return {"seconds": seconds}

    def evaluations(self) -> Any:
        """Return rows, J d and dᵀ H d at a point, and prepare to time."""
        z, d, given = point(self.task, self.nodes)
        n, M = len(self.task.start), self.nodes - 1
        z, d = (self._own(v) for v in (z, d))
        multipliers = given.reshape(n, M).T.ravel()
        f = {name: self.solver.get_function(f"nlp_{name}") for name in ("g", "jac_g", "hess_l")}
        rows = np.array(f["g"](z, [])).ravel()
        _, J = f["jac_g"](z, [])
        H = f["hess_l"](z, [], 1.0, multipliers)
        J, H = J.sparse(), H.sparse()
        buffers = [
            self._buffer(f["g"], (z, np.zeros(0)), {0: len(rows)}),
            self._buffer(f["jac_g"], (z, np.zeros(0)), {1: J.nnz}),
            self._buffer(f["hess_l"], (z, np.zeros(0), np.ones(1), multipliers), {0: H.nnz}),
        ]
        names = ("rows", "jacobian", "hessian")
        self.runs = {k: Repeated(call) for k, call in zip(names, buffers, strict=True)}
        by_rows = lambda v: np.asarray(v).reshape(M, n).T.ravel()  # noqa: E731
        upper = H.tocoo()
        twice = np.where(upper.row == upper.col, 1.0, 2.0)
        curved = upper.data * d[upper.row] * d[upper.col] * twice
        return {"rows": by_rows(rows).tolist(), "slopes": by_rows(J @ d).tolist(),
                "curvature": float(curved.sum())}  # fmt: skip

    def _buffer(self, function: Any, given: Any, sizes: dict[int, int]) -> Any:
        """Return a call without conversions; see "Buffer" in CasADi's guide."""
        buffer, trigger = function.buffer()
        keep = [np.ascontiguousarray(value, float) for value in given]
        for k, value in enumerate(keep):
            if len(value):
                buffer.set_arg(k, memoryview(value))
        for k, size in sizes.items():
            keep.append(np.zeros(size))
            buffer.set_res(k, memoryview(keep[-1]))
        trigger.keep = (buffer, keep) if hasattr(trigger, "__dict__") else None
        self.kept = [*getattr(self, "kept", ()), buffer, keep]
        return trigger

    def _own(self, z: np.ndarray) -> np.ndarray:
        """Return unknowns in the order of nodes."""
        n, N = len(self.task.start), self.nodes
        return np.concatenate([z[: n * N].reshape(n, N).T.ravel(), z[n * N :]])

    def run(self, kind: str) -> float:
        """Return the seconds of an evaluation."""
        return self.runs[kind]()

    def solve(self, options: dict[str, Any]) -> Any:
        """Solve from the guess."""
        start = time.perf_counter()
        found = self.solver(x0=self.guess, lbx=self.bounds[0], ubx=self.bounds[1], lbg=0.0, ubg=0.0)
        seconds = time.perf_counter() - start
        stats = self.solver.stats()
        if not stats["success"]:
            raise RuntimeError(stats["return_status"])
        return {"seconds": seconds, "objective": float(found["f"]),
                "iterations": int(stats["iter_count"])}  # fmt: skip


if __name__ == "__main__":
    casadi = CasADi()
    serve({n: getattr(casadi, n) for n in ("load", "evaluations", "run", "solve")})
