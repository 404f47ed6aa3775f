"""Optimal control problems that everybody solves: equations from one place, ends, limits, guess.

The unknowns that are compared are ordered as states by nodes, then the control by intervals, then
the duration if it is free. The rows are q' − G and M u' − F, by equations, then by intervals.
"""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field

import numpy as np
import sympy as sm
import sympy.physics.mechanics as me

from harness import frozen
from harness.model import Model

__all__ = ["TASKS", "Task", "model_of", "point", "residuals"]


@dataclass(frozen=True)
class Task:
    """An optimal control problem with one control.

    Attributes
    ----------
    model : str
        A frozen model, 'mass' or 'hypersensitive'.
    start, end : sequence of float
        All states. The guess lies on straight lines between them, with a control of zero.
    duration : float
        A guess where the duration itself is the objective.
    objective : {'effort', 'time', 'quadratic'}
        ∫ F² dt, the duration, or ½ ∫ x² + F² dt of the last state x.
    limit : float or None
        The largest magnitude of the control.
    values : mapping of str to float
        Of constants, where they are not the frozen model's.
    optimum : float or None
    """

    model: str
    start: Sequence[float]
    end: Sequence[float]
    duration: float
    objective: str = "effort"
    limit: float | None = None
    values: Mapping[str, float] = field(default_factory=dict)
    optimum: float | None = None

    @property
    def free(self) -> bool:
        """Whether the duration is unknown."""
        return self.objective == "time"


def _crane(links: int) -> Task:
    """Links that hang from a cart, moved one metre from rest to rest."""
    hanging = [math.pi] * links
    still = [0.0] * (links + 1)
    return Task(f"pendulum-{links}", [0.0, *hanging, *still], [1.0, *hanging, *still], 2.0)


TASKS = {
    **{f"crane-{n}": _crane(n) for n in (1, 5, 10)},
    # M. Kelly, An introduction to trajectory optimization, SIAM Rev. 59 (2017) 849–904, section 6;
    # the optimum to ten digits is that of Dymos' benchmark of the same problem.
    "swing-up": Task(
        "pendulum-1",
        [0.0, math.pi, 0.0, 0.0],
        [1.0, 2 * math.pi, 0.0, 0.0],  # up by the shorter way; 0 is another optimum
        2.0,
        limit=20.0,
        values={"m0": 1.0, "m1": 0.3, "l0": 0.5, "g": 9.81},
        optimum=58.80766746,
    ),
    # Full thrust to the middle, then back: 2 √(m d / F).
    "sliding": Task("mass", [0.0, 0.0], [1.0, 0.0], 1.0, "time", limit=50.0, optimum=0.4),
    # J. T. Betts, Practical Methods for Optimal Control Using Nonlinear Programming, example 10.7,
    # whose objective is twice as large.
    "betts-10.7": Task("hypersensitive", [1.0], [1.5], 10_000.0, "quadratic", optimum=6.72412 / 2),
}


def model_of(task: Task) -> Model:
    """Return the equations, with the values of the constants of the task."""
    if task.model == "mass":
        x, v, F = me.dynamicsymbols("x v F")
        m = sm.Symbol("m")
        return Model("mass", [x], [v], [F], [m], [m], [F], [v], True, [2.0], {})
    if task.model == "hypersensitive":
        x, u = me.dynamicsymbols("x u")
        return Model("betts", [], [x], [u], [], [sm.S.One], [-(x**3) + u], [], True, [], {})
    model = frozen.read(task.model)
    given = zip(model.constants, model.values, strict=True)
    model.values = [task.values.get(s.name, value) for s, value in given]
    return model


def residuals(model: Model) -> sm.Matrix:
    """Return q' − G and M u' − F."""
    t, n = me.dynamicsymbols._t, len(model.speeds)
    pairs = zip(model.coordinates, model.coordinate_derivatives, strict=True)
    rows = [q.diff(t) - rate for q, rate in pairs]
    for i in range(n):
        row = zip(model.mass_matrix[i * n : (i + 1) * n], model.speeds, strict=True)
        rows.append(sum(m * u.diff(t) for m, u in row) - model.forcing[i])
    return sm.Matrix(rows)


def point(task: Task, nodes: int) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Return unknowns at which all are compared, a direction, and multipliers of the rows."""
    rng = np.random.default_rng(5)
    n = len(task.start)
    lines = np.linspace(task.start, task.end, nodes).T
    z = np.concatenate([lines.ravel(), np.zeros(nodes - 1), [task.duration] * task.free])
    z += 0.05 * rng.normal(size=len(z))
    return z, rng.normal(size=len(z)), rng.normal(size=n * (nodes - 1))
