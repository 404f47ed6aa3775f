"""What there is to test, by the package's own registries: tests of a kind run over these lists.

Whoever adds a solver, a law or a format adds it to the package alone. Where a test needs a fact
that cannot be computed (a published order), the fact stands in a table here or in the test file,
and `test_registry.py` says by name which row is missing.
"""

from __future__ import annotations

import inspect
from dataclasses import dataclass
from typing import Any

from pydy import contact
from pydy._backends import registry as back_ends
from pydy._motion import scipy_solvers
from pydy.control import schemes, solvers as optimizers
from pydy.export import writing
from pydy.solvers.options import Options
from pydy.solvers.solver import SOLVERS as _BY_NAME

# ---- Native solvers ----

SOLVERS = tuple(_BY_NAME.values())
ADAPTIVE = tuple(solver for solver in SOLVERS if solver.adaptive)
FIXED_STEP = tuple(solver for solver in SOLVERS if not solver.adaptive)
IMPLICIT = tuple(solver for solver in SOLVERS if solver.name == "radau")
EXPLICIT = tuple(solver for solver in SOLVERS if solver not in IMPLICIT)
SOLVER_NAMES = tuple(_BY_NAME)
ADAPTIVE_NAMES = tuple(solver.name for solver in ADAPTIVE)
EXPLICIT_NAMES = tuple(solver.name for solver in EXPLICIT)
# Options of a solver that users give; the others are set by `System`.
INTERNAL_OPTIONS = {"continuation", "constraints", "recorded", "sensitivities"}
SOLVER_OPTIONS = tuple(sorted(set(Options.__dataclass_fields__) - INTERNAL_OPTIONS))


def has_fixed_step(solver: Any) -> bool:
    """Whether a solver, or the one of this name, takes a step in place of tolerances."""
    return solver in FIXED_STEP or solver in {fixed.name for fixed in FIXED_STEP}


def step_options(solver: Any, tolerance: float = 1e-9, step: float = 1e-3) -> dict[str, float]:
    """Return tolerances for a solver that controls its error, a step for one that does not."""
    return {"step": step} if has_fixed_step(solver) else {"rtol": tolerance, "atol": tolerance}


@dataclass(frozen=True)
class SolverFacts:
    """What is published of an explicit method, and steps at which its order shows.

    Attributes
    ----------
    interpolant : int
        Order of the states between steps.
    estimates : tuple of int
        Order of each row of the tableau's errors: it vanishes up to this order and not beyond.
    steps, interpolant_steps : tuple of float
        A large and a small step for the Euler equations of a free rigid body: both with errors well
        above rounding, and small enough for the order to show.
    """

    interpolant: int
    estimates: tuple[int, ...]
    steps: tuple[float, float]
    interpolant_steps: tuple[float, float] | None


SOLVER_FACTS = {
    # The orders of both estimates of DOP853 are those of its name, 8(5,3).
    "dop853": SolverFacts(7, (5, 3), (0.5, 0.2), (0.5, 0.2)),
    "tsit5": SolverFacts(4, (4,), (0.1, 0.025), (0.1, 0.025)),
    "vern9": SolverFacts(8, (8,), (0.5, 0.4), (1.0, 0.5)),
    "rk4": SolverFacts(3, (), (0.05, 0.0125), None),
}

# ---- Everything else ----

SCIPY_SOLVERS = scipy_solvers.METHODS
BACK_ENDS = tuple(back_ends.names())
LANGUAGES = tuple(writing.DIALECTS)
FORMATS = tuple(writing.FORMATS)
COLLOCATION_METHODS = schemes.METHODS
OPTIMIZERS = tuple(optimizers.SOLVERS)
LAWS = tuple(f for name in contact.__all__ if inspect.isfunction(f := getattr(contact, name)))
CONTACT_CONDITIONS = (contact.Unilateral, contact.Stick, contact.Roll, contact.Clearance)
