"""The solvers of nonlinear programs.

===========  =====================================================================
``ipopt``    IPOPT out of the wheel of CasADi, by its C interface
``cyipopt``  an IPOPT that the user has built, such as one with HSL's linear solvers
``pounce``   POUNCE, which began as a port of IPOPT to Rust
===========  =====================================================================

The last two have the same Python interface, options and status codes.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from contextlib import suppress
from functools import partial
from typing import Any

import numpy as np

from pydy._checks import check_mapping, choice
from pydy._errors import MissingDependencyError
from pydy._interrupts import Interrupts
from pydy._optional import require
from pydy.control import ipopt
from pydy.control.ipopt import (
    Iteration,
    IterationRecorder,
    NlpSolution,
    option_values,
    program_bounds,
    solver_options,
    solving,
)
from pydy.control.nlp import Nlp


def solver_of(name: object, options: object) -> Callable[..., NlpSolution]:
    """Return the function ``solve(nlp, z, *, watch, warm)`` of a solver with its options."""
    chosen = SOLVERS[choice(name, tuple(SOLVERS), "`solver`")]
    return partial(chosen, options=check_mapping("options", options))


def fitting_solver_of(name: object, options: object) -> Callable[..., NlpSolution]:
    """Return the function of `solver_of`, with default options for a fit.

    A few unknowns, the parameters, occur in many equations. The elimination order 6 of MUMPS is an
    approximate minimum degree (AMD) that treats such dense rows separately.
    """
    chosen = choice(name, tuple(SOLVERS), "`solver`")
    defaults = {"mumps_pivot_order": 6} if chosen == "ipopt" else {}  # other builds may lack MUMPS
    return solver_of(chosen, {**defaults, **check_mapping("options", options)})


class _CyipoptProblem(IterationRecorder):
    """A program in the form that cyipopt and POUNCE expect; failed evaluations are NaN."""

    def _filled(self, name: str, *arguments: Any) -> np.ndarray:
        try:
            values, fine = self.nlp.native(name, *arguments)
        except BaseException as error:  # noqa: BLE001  raised after the solver has returned
            self.raised.append(error)
        else:
            if fine and not self.raised:
                return values
        size = {"cost": 1, "gradient": self.nlp.size, "rows": self.nlp.rows}
        entries = {"jacobian": self.nlp.jacobian_at, "hessian": self.nlp.hessian_at}
        return np.full(size[name] if name in size else len(entries[name][0]), np.nan)

    def objective(self, y: np.ndarray) -> float:
        return float(self._filled("cost", y)[0])

    def gradient(self, y: np.ndarray) -> np.ndarray:
        return self._filled("gradient", y)

    def constraints(self, y: np.ndarray) -> np.ndarray:
        return self._filled("rows", y)

    def jacobianstructure(self) -> tuple[np.ndarray, np.ndarray]:
        return self.nlp.jacobian_at

    def jacobian(self, y: np.ndarray) -> np.ndarray:
        return self._filled("jacobian", y)

    def hessianstructure(self) -> tuple[np.ndarray, np.ndarray]:
        return self.nlp.hessian_at

    def hessian(self, y: np.ndarray, multipliers: np.ndarray, weight: float) -> np.ndarray:
        return self._filled("hessian", y, weight, multipliers)

    def intermediate(
        self, alg_mod: int, iter_count: int, obj_value: float, inf_pr: float, inf_du: float,
        mu: float, *_: object, **_options: object,
    ) -> bool:  # fmt: skip
        return self.guarded(alg_mod, iter_count, obj_value, inf_pr, inf_du, mu)


def _by_package(
    module: str,
    extra: str,
    nlp: Nlp,
    z: np.ndarray,
    *,
    options: Mapping[str, object],
    watch: Callable[[Iteration], None] = lambda iteration: None,
    warm: NlpSolution | None = None,
) -> NlpSolution:
    try:
        package = require(module, extra, f"`solver={extra!r}`")
    except ImportError as error:
        raise MissingDependencyError(str(error)) from error
    interrupts = Interrupts()
    program = _CyipoptProblem(nlp, watch, interrupts)
    lower, upper, low, high = program_bounds(nlp)
    problem = package.Problem(
        n=nlp.size, m=nlp.rows, problem_obj=program, lb=lower, ub=upper, cl=low, cu=high
    )
    for name, value in {**solver_options(nlp, warm), **options}.items():
        _add_option(problem, module, name, value)
    start = (
        {} if warm is None else dict(zip(("lagrange", "zl", "zu"), warm.seeds(nlp), strict=True))
    )
    info: Any = None
    try:
        with solving(), interrupts:
            y, info = problem.solve(np.array(z / nlp.sizes), **start)
            if program.raised:
                raise program.raised[0]
    except (KeyboardInterrupt, MemoryError) as stop:
        if info is None:  # a second interrupt, inside the solver
            raise
        program.stopped = stop
    except RuntimeError as error:  # POUNCE checks options only when it solves
        if "OPTION" not in str(error):
            raise
        raise ValueError(f"`options` has what {module} does not take: {error}") from error
    of_bounds = info["mult_x_L"], info["mult_x_U"]
    return program.solution(
        y, info["mult_g"], *of_bounds, float(info["obj_val"]), int(info["status"])
    )


def _add_option(problem: Any, module: str, name: str, value: object) -> None:
    for form in option_values(name, value):
        with suppress(TypeError):
            problem.add_option(name, form)
            return
    raise ValueError(
        f"`options` has {name!r}: {value!r}, which {module} does not know as an option, or not "
        "as a value of it. See https://coin-or.github.io/Ipopt/OPTIONS.html."
    )


SOLVERS: dict[str, Callable[..., NlpSolution]] = {
    "ipopt": lambda *args, **named: ipopt.solve(*args, **named),
    "cyipopt": partial(_by_package, "cyipopt", "cyipopt"),
    "pounce": partial(_by_package, "pounce", "pounce"),
}
