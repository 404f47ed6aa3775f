"""Which way gravity pulls where no load tells it: only a Lagrangian does."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import numpy as np
import sympy as sm

from pydy._mechanics.equations import Mechanism
from pydy._mechanics.symbols import find_symbols
from pydy._rank import HALF
from pydy.viz.defaults import gravities
from pydy.viz.motion import Geometry, Names, place

__all__ = ["up_in_lagrangian"]

_STATES = 8  # more than a straight line through them has freedoms


def up_in_lagrangian(
    mechanism: Mechanism, origin: Any, names: Names, values: Mapping[Any, float]
) -> str | None:
    """Return the axis along which a Lagrangian's energy of weights grows, or None.

    That energy is what the potential one has of a symbol `g`, or of the masses, or all of it where
    these are numbers. At random states it must be a multiple of the masses' first moment about one
    of the axes, apart from a constant. The `names` are those of states and specifieds; constants
    without one of the `values` are 1.
    """
    lagrangian = sm.sympify(mechanism.lagrangian)
    potential = -lagrangian.xreplace(dict.fromkeys(lagrangian.atoms(sm.Derivative), 0))
    masses = {body.masscenter: sm.sympify(body.mass) for body in mechanism.bodies}
    known = gravities(potential)
    if len(known) == 1:
        weights = known[0] * potential.diff(known[0])
    elif any(mass.is_Symbol for mass in masses.values()):
        masses = {point: mass for point, mass in masses.items() if mass.is_Symbol}
        weights = sm.Add(*(mass * potential.diff(mass) for mass in {*masses.values()}))
    else:
        weights = potential
    series = (("energy", weights), *((str(k), mass) for k, mass in enumerate(masses.values())))
    found = find_symbols([expression for _, expression in series])
    symbols = {s for s in found if isinstance(s, sm.Symbol) and s != names.time}
    constants = tuple(dict.fromkeys((*values, *symbols)))
    geometry = Geometry(mechanism.frame, origin, (), tuple(masses), (), series)
    rng = np.random.default_rng(0)
    try:
        placed = place(geometry, Names(names.states, names.specifieds, constants))(
            np.zeros(_STATES),
            rng.uniform(0.1, 1.0, (_STATES, len(names.states))),
            rng.uniform(0.1, 1.0, (_STATES, len(names.specifieds))),
            np.array([values.get(s, 1.0) for s in constants]),
        )
    except ValueError:  # a symbol without a value, or a point that hangs in the air
        return None
    energy = placed.series["energy"]
    moments = sum(
        placed.series[str(k)][:, None] * placed.positions[point] for k, point in enumerate(masses)
    )
    return _axis(energy, np.asarray(moments))


def _axis(energy: np.ndarray, moments: np.ndarray) -> str | None:
    """Return the one axis whose moments an energy is a multiple of, with its sign."""
    fits = []
    rise = energy - energy.mean()
    for name, moment in zip("xyz", moments.T, strict=True):
        away = moment - moment.mean()
        slope = float(rise @ away / (away @ away)) if away.any() else 0.0
        size = np.abs(energy).max() + np.abs(slope * moment).max()
        left, part = np.abs(rise - slope * away).max(), np.abs(slope * away).max()
        if left <= HALF * size < part:
            fits.append(("-" if slope < 0 else "") + name)
    return fits[0] if len(fits) == 1 else None
