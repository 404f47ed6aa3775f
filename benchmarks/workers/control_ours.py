"""This project's optimal control; the first argument is the folder for its machine code."""

from __future__ import annotations

import os
import re
import sys
import tempfile
import time
from ctypes import CFUNCTYPE, c_bool, c_double, c_int, c_void_p
from pathlib import Path
from typing import Any

os.environ["PYDY_CACHE_DIR"] = sys.argv[1]

import numpy as np
import sympy as sm
import sympy.physics.mechanics as me
from harness.optimal import TASKS, Task, model_of, point
from harness.serve import Repeated, serve

from pydy import System, models
from pydy._array_layout import address
from pydy._backends.llvm import jit
from pydy._backends.llvm.compiling import Source
from pydy.control import OptimalControl
from pydy.control.ipopt import library, solve as search
from pydy.control.nlp import SIGNATURES
from pydy.control.transcription import Transcription
from pydy.mechanics import Definition

library()  # IPOPT is loaded once
KINDS = {c_int: "i32", c_void_p: "ptr", c_bool: "i1 zeroext", c_double: "double"}
TIMES = 100
T, TF = me.dynamicsymbols._t, sm.Symbol("tf")


def system_of(task: Task) -> Any:
    """Return the System, and its control."""
    if task.model.startswith("pendulum"):
        made = models.n_link_pendulum_on_cart(int(task.model.split("-")[1]))
        model = model_of(task)
        made.constants = dict(zip(model.constants, model.values, strict=True))
        return made
    frame, point_, rest = me.ReferenceFrame("N"), me.Point("P"), me.Point("O")
    rest.set_vel(frame, 0)
    x, v, F = me.dynamicsymbols("x v F")
    point_.set_vel(frame, v * frame.x)
    mass, force = (sm.Symbol("m"), F) if task.model == "mass" else (1, F - v**3)
    body = me.Particle("mass", point_, mass)
    definition = Definition(frame, [x], [v], bodies=[body], loads=[(point_, force * frame.x)])
    return System(definition, {mass: 2.0} if task.model == "mass" else {})


class Ours:
    def load(self, task: str, nodes: int, method: str, order: int = 1, mesh: Any = None) -> Any:
        """Build everything; return the seconds from the bodies to the compiled functions."""
        start = time.perf_counter()
        self.task = own = TASKS[task]
        system = system_of(own)
        (F,) = system.specifieds_symbols
        states = system.states
        ends = [dict(zip(states[-len(e) :], e, strict=True)) for e in (own.start, own.end)]
        objective = {
            "effort": sm.Integral(F**2, T),
            "time": TF,
            "quadratic": sm.Integral(states[-1] ** 2 + F**2, T) / 2,
        }[own.objective]
        bounds = {} if own.limit is None else {F: (-own.limit, own.limit)}
        if own.free:
            bounds[TF] = (0.1, 10.0)
        self.guess = {TF: own.duration} if own.free else {}
        self.problem = OptimalControl(
            system,
            objective,
            TF if own.free else own.duration,
            start=ends[0],
            end=ends[1],
            bounds=bounds,
            mesh=nodes - 1 if mesh is None else mesh,
            method=method,
            order=order,
        )
        self.problem.check(self.guess)
        self.nodes = nodes
        return {"seconds": time.perf_counter() - start}

    def evaluations(self) -> Any:
        """Return rows, J d and dᵀ H d at a point, and prepare to time."""
        p = self.problem
        made = Transcription(p._problem, p._scheme, p._mesh)
        z, d, given = point(self.task, self.nodes)
        none = np.full(len(z), np.inf)
        nlp = made.nlp(-none, none, np.ones(len(z)))
        native, (i, j), (k, l) = nlp.native, nlp.jacobian_at, nlp.hessian_at
        rows, J, H = np.empty(nlp.rows), np.empty(len(i)), np.empty(len(k))
        n, count, m = len(z), len(given), nlp.rows
        multipliers = np.zeros(m)
        multipliers[:count] = given
        self.kept = [nlp, z, multipliers, rows, J, H]  # of which the calls have addresses
        curved = 1.0, m, address(multipliers), True, len(k), None, None

        def called(name: str, out: np.ndarray, *more: Any) -> Any:
            """Return some calls as IPOPT makes them: ctypes alone would take as long as one."""
            kinds = [KINDS[kind] for kind in SIGNATURES[name]]
            values = []
            for kind, v in zip(kinds, [n, address(z), True, *more, address(out), native.handle],
                               strict=True):  # fmt: skip
                values.append(f"inttoptr (i64 {v or 0} to ptr)" if kind == "ptr" else v)
                values[-1] = int(v) if kind == KINDS[c_bool] else values[-1]
            arguments = ", ".join(f"{k} {v}" for k, v in zip(kinds, values, strict=True))
            call = f"call i1 inttoptr (i64 {native.addresses[name]} to ptr)({arguments})"
            text = f"""define void @calls() {{
entry:
  br label %again
again:
  %k = phi i64 [ 0, %entry ], [ %next, %again ]
  %fine = {call}
  %next = add i64 %k, 1
  %more = icmp slt i64 %next, {TIMES}
  br i1 %more, label %again, label %done
done:
  ret void
}}"""
            code = jit.load(Source(text, lambda brief: text, ("calls",)))
            self.kept.append(code)
            return CFUNCTYPE(None)(code.addresses["calls"])

        calls = {
            "rows": called("rows", rows, m),
            "jacobian": called("jacobian", J, m, len(i), None, None),
            "hessian": called("hessian", H, *curved),
        }
        for call in calls.values():
            call()
        self.runs = {name: Repeated(call) for name, call in calls.items()}
        slopes = np.bincount(i, J * d[j], nlp.rows)
        curved = H * d[k] * d[l] * np.where(k == l, 1.0, 2.0)
        return {"rows": rows[:count].tolist(), "slopes": slopes[:count].tolist(),
                "curvature": float(curved.sum())}  # fmt: skip

    def run(self, kind: str) -> float:
        """Return the seconds of an evaluation."""
        return self.runs[kind]() / TIMES

    def solve(self, options: dict[str, Any]) -> Any:
        """Solve from the guess."""
        start = time.perf_counter()
        found = self.problem.solve(self.guess, options=options)
        return {"seconds": time.perf_counter() - start, "objective": found.objective,
                "iterations": len(found.history) - 1}  # fmt: skip

    def search(self, options: dict[str, Any]) -> Any:
        """Time IPOPT alone, as CasADi's solver does: no bounds, guess, errors or trajectory."""
        nlp, z, _ = self.problem._combined_program([self.problem._mesh], [self.guess])
        start = time.perf_counter()
        search(nlp, z, options=options)
        return {"seconds": time.perf_counter() - start}

    def shares(self) -> Any:
        """Return IPOPT's own account of a search: its processor time and what it is spent on."""
        with tempfile.TemporaryDirectory() as folder:
            file = str(Path(folder, "ipopt.txt"))
            told = {"output_file": file, "file_print_level": 3, "print_timing_statistics": "yes"}
            self.problem.solve(self.guess, options={"tol": 1e-8, **told})
            text = Path(file).read_text()
        names = {
            "seconds": "OverallAlgorithm",
            "linear algebra": "StdAugSystemSolverMultiSolve",
            "evaluations": "Function Evaluations",
        }
        pattern = r"^ *{}\.*: *([0-9.]+)"
        return {
            key: float(re.search(pattern.format(name), text, re.MULTILINE)[1])  # type: ignore[index]
            for key, name in names.items()
        }


if __name__ == "__main__":
    ours = Ours()
    serve(
        {n: getattr(ours, n) for n in ("load", "evaluations", "run", "solve", "search", "shares")}
    )
