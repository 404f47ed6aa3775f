"""Vehicles in the plane whose motion depends on neither position nor yaw angle: checks."""

from __future__ import annotations

from collections.abc import Sequence
from copy import copy
from typing import Any

import numpy as np
import sympy as sm
import sympy.physics.mechanics as me
from sympy.core.function import AppliedUndef

from pydy._checks import describe, real_array, shown
from pydy._rank import HALF
from pydy.system import System
from pydy.vehicles.manoeuvres import names_of

_TRIALS = 5  # random states at which a system's symmetry is tested

Position = tuple[Any, Any, Any]  # the coordinates x and y of a point, and the yaw angle


def check_unconstrained(system: System, constraint_jacobian: sm.MatrixBase) -> None:
    """Refuse a system with constraints or auxiliary states."""
    if constraint_jacobian.rows or system.auxiliaries:
        raise NotImplementedError(
            "`system` must have no constraints and no auxiliary states; use coordinates that are "
            "independent."
        )


def check_expressions(expressions: list[sm.Expr], position: Position) -> None:
    """Refuse equations that depend on the position, time, or derivatives of specifieds."""
    t = me.dynamicsymbols._t
    for expression in expressions:
        if derivatives := sorted(map(str, expression.atoms(sm.Derivative))):
            raise ValueError(
                f"`system` has the derivative {derivatives[0]} of a specified. Make that "
                "specified a state whose rate is the input."
            )
        functions = expression.atoms(AppliedUndef)
        if where := sorted(map(str, functions & {*position[:2]})):
            raise ValueError(
                f"`system` depends on {describe(where)}, the position in the plane, so that "
                "it has no equations along a track."
            )
        plain = expression.xreplace({f: sm.Dummy() for f in functions})
        if t in plain.free_symbols:
            raise ValueError(
                "`system` depends on time itself; along a track, time is a state. Use "
                "specifieds without values for inputs that change."
            )


def check_symmetry(system: System, position: Position) -> None:
    """Refuse equations that depend on position and yaw angle, but for the velocity's rotation."""
    names = {str(k).removesuffix("(t)"): v for k, v in system.initial_conditions.items()}
    system, random = copy(system), np.random.default_rng(0)
    system.specifieds = {}
    states, count = list(system.states), len(system.states)
    usual = np.array([float(names.get(name, 0.0)) for name in names_of(states)])
    ix, iy, turned = (states.index(q) for q in position)
    for _ in range(_TRIALS):
        sizes = np.abs(usual) + 1.0
        state = usual + 0.1 * sizes * random.uniform(-1.0, 1.0, count)
        inputs = 0.1 * random.uniform(-1.0, 1.0, len(system.specifieds_symbols))
        r = dict(zip(system.specifieds_symbols, inputs.tolist(), strict=True))
        angle, time = random.uniform(1.0, 2.0, 2).tolist()
        elsewhere = state.copy()
        elsewhere[[ix, iy]] += sizes[[ix, iy]]
        rates = []
        for at, turn, t in ((state, 0.0, 0.0), (state, angle, 0.0), (elsewhere, 0.0, time)):
            at[turned] = turn
            rates.append(system.evaluate_ode(at, t, r=r))
        if not np.isfinite(rates).all() or rates[0][ix] <= 0.0:
            raise ValueError(
                "`system.initial_conditions` must be those of a vehicle that moves forward, "
                f"got the derivative {rates[0][ix]:.4g} of {position[0]} near them at the yaw "
                "angle zero. Set the forward speed."
            )
        (straight, rotated, moved), c, s = rates, np.cos(angle), np.sin(angle)
        expected = straight.copy()
        expected[ix] = c * straight[ix] - s * straight[iy]
        expected[iy] = s * straight[ix] + c * straight[iy]
        scale = HALF * np.maximum(np.abs(straight).max(), 1.0)
        wrong = np.abs(moved - straight) > scale
        if wrong.any():
            raise ValueError(
                f"`system` must be the same everywhere and at all times, but the derivative of "
                f"{states[int(wrong.argmax())]} depends on {position[0]}, {position[1]} or time."
            )
        wrong = np.abs(rotated - expected) > scale
        if wrong.any():
            k = int(wrong.argmax())
            what = "does not turn with" if k in (ix, iy) else "depends on"
            raise ValueError(
                f"`system` must be the same in all directions of the plane, but the derivative "
                f"of {states[k]} {what} {position[2]}. `position` must be the coordinates of a "
                f"point and the yaw angle, got {shown([str(q) for q in position])}."
            )


def fixed_inputs(system: System, controls: Sequence[str], position: Position) -> dict[Any, Any]:
    """Return the values of the specifieds that are no controls."""
    values: dict[str, Any] = {}
    for key, value in system.specifieds.items():
        keys = key if isinstance(key, tuple) else (key,)
        entries = list(value) if np.ndim(value) else [value] * len(keys)
        values |= dict(zip(names_of(keys), entries, strict=False))
    fixed: dict[Any, Any] = {}
    for symbol in system.specifieds_symbols:
        (name,) = names_of([symbol])
        if name in controls:
            continue
        value = values.get(name, 0.0)
        if isinstance(value, sm.Expr):
            check_expressions([value], position)
            if value.has(position[2]):
                raise ValueError(
                    f"`system.specifieds[{name}]` depends on {position[2]}, which is no state "
                    "along a track."
                )
            fixed[symbol] = value
        elif callable(value) or real_array(value, f"`system.specifieds[{name}]`").ndim:
            raise ValueError(
                f"`system.specifieds[{name}]` must be a number or an expression of states, got "
                f"{shown(value)}; or name {name!r} in `inputs`."
            )
        else:
            fixed[symbol] = float(value)
    return fixed
