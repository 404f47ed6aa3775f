"""The benchmark set, derived with SymPy. Results are frozen; see `freeze.py`."""

from __future__ import annotations

from collections.abc import Callable
from functools import partial
from typing import Any

import sympy as sm
import sympy.physics.mechanics as me
from sympy.physics.mechanics.models import n_link_pendulum_on_cart

from harness import variants
from harness.kane import from_kane
from harness.model import Model
from harness.problems import BICYCLE
from harness.serve import module_at
from harness.written_down import arm_written_down, pendulum_written_down, rods_written_down


def pendulum(n: int) -> Model:
    """Return a planar pendulum of n links on a cart that a force pushes."""
    kane = n_link_pendulum_on_cart(n, cart_force=True, joint_torques=False)
    return from_kane(
        f"pendulum-{n}",
        kane,
        lambda name: 9.81 if name == "g" else 1.0 / n,
        source="sympy.physics.mechanics.models.n_link_pendulum_on_cart",
    )


def bicycle() -> Model:
    """Return the Carvallo–Whipple bicycle of the project's own examples."""
    module = module_at(BICYCLE)
    model = module.derive()
    model.kane.kanes_equations(model.bodies, model.kane.loads)  # which others need
    return from_kane(
        "bicycle",
        model.kane,
        lambda name: module.BENCHMARK[name],
        source="pydy.examples.whipple_bicycle",
    )


def spring_chain(n: int, *, absolute: bool) -> Model:
    """Return n masses in a row, each joined to the one before by a spring and a damper.

    Coordinates are the stretches of the springs, as in `pydy.models.multi_mass_spring_damper`,
    whose mass matrix is full of constants; or the places of the masses, with a diagonal one.
    """
    m, k, c = (sm.symbols(f"{name}0:{n}") for name in "mkc")
    g = sm.Symbol("g")
    x, v, f = (me.dynamicsymbols(f"{name}0:{n}") for name in "xvf")
    pull = [-k[i] * _stretch(x, i, absolute) - c[i] * _stretch(v, i, absolute) for i in range(n)]
    # The force on each mass: its own spring, the next one, weight, and a specified force.
    force = [pull[i] - (pull[i + 1] if i + 1 < n else 0) + m[i] * g + f[i] for i in range(n)]
    if absolute:
        matrix = [m[i] if i == j else sm.S.Zero for i in range(n) for j in range(n)]
    else:
        # Mass i moves with every stretch up to its own.
        below = [sm.Add(*m[i:]) for i in range(n)]
        matrix = [below[max(i, j)] for i in range(n) for j in range(n)]
        force = [pull[i] + sm.Add(*(m[j] * g + f[j] for j in range(i, n))) for i in range(n)]
    values = {"m": 1.0, "k": 100.0, "c": 0.5, "g": 9.81}
    return Model(
        name=f"springs-{n}-{'absolute' if absolute else 'stretch'}",
        coordinates=list(x),
        speeds=list(v),
        specifieds=list(f),
        constants=[*c, g, *k, *m],
        mass_matrix=matrix,
        forcing=force,
        coordinate_derivatives=list(v),
        positive_definite=True,
        values=[values[s.name[0]] for s in (*c, g, *k, *m)],
        about={"sympy": sm.__version__, "source": "masses in a row, written down by hand"},
    )


def _stretch(x: Any, i: int, absolute: bool) -> Any:
    return x[i] - x[i - 1] if absolute and i else x[i]


def rider_bicycle() -> Model:
    """Return the rider-bicycle of the `symbrim` package, if it is installed."""
    from harness.rider import derive

    kane, values = derive()
    return from_kane("rider-bicycle", kane, values, source="symbrim")


MODELS: dict[str, Callable[[], Model]] = {
    **{f"pendulum-{n}": lambda n=n: pendulum(n) for n in (1, 5, 10, 20)},
    "rods-3": lambda: variants.rods(3),
    "bicycle": bicycle,
    "springs-100-absolute": lambda: spring_chain(100, absolute=True),
    "springs-100-stretch": lambda: spring_chain(100, absolute=False),
    "rider-bicycle": rider_bicycle,
    # Not frozen: large, and quickly written down.
    "pendulum-50": lambda: pendulum_written_down(50),
    "rods-10": lambda: rods_written_down(10),
}
STANDARD = tuple(MODELS)[:-2]

# Not in the benchmark set, but as fast: the same mechanisms derived otherwise, and some others.
VARIANTS: dict[str, Callable[[], Model]] = {
    "pendulum-relative-5": lambda: variants.pendulum_relative(5),
    **{
        f"rods{'-universal' * universal}{'-absolute' * absolute}-{n}": partial(
            variants.rods, n, universal=universal, absolute=absolute
        )
        for n, universal, absolute in (
            *((3, True, False), (3, False, True), (3, True, True)),
            *((5, False, True), (5, True, True)),
        )
    },
    "bicycle-from-contact": variants.bicycle_from_contact,
    "rider-adduction": variants.rider_adduction,
    "quadrotor": variants.quadrotor,
    # Not frozen: written down.
    "rods-5": lambda: rods_written_down(5),
    "rods-universal-5": lambda: rods_written_down(5, universal=True),
    "arm-7": lambda: arm_written_down(7),
}
MODELS |= VARIANTS
