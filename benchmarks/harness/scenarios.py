"""Where the frozen models start when solvers are compared, and how long they run.

Every motion is smooth and not chaotic: a change at the start grows less than about a
thousandfold, so that an error of 1e-10 at the end is the solver's own.
"""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np

from harness.model import Model


@dataclass
class Scenario:
    """A start and an end.

    Attributes
    ----------
    start : ndarray, shape (n,)
    inputs : ndarray, shape (s,)
        The specifieds, constant.
    horizon : float
        Seconds from time zero.
    """

    start: np.ndarray
    inputs: np.ndarray
    horizon: float


_FORWARD = 4.6  # m/s, at which the benchmark bicycle is stable
_RODS = (0.3, -0.2, 0.1, 0.2, 0.3, -0.1, -0.3, 0.2, 0.2)
_TURNING = (0.5, -0.3, 0.8, -0.4, 0.6, 0.3, 0.2, -0.5, 1.0)


def scenario(model: Model) -> Scenario:
    """Return what a model does in `solvers.py`."""
    q, u = len(model.coordinates), len(model.speeds)
    horizon = 1.0
    match model.name.split("-"):
        case ["pendulum", _]:  # links in one line, half a radian from hanging
            start = [0.0, *[math.pi - 0.5] * (q - 1), *[0.0] * u]
        case ["rods", "3"]:
            start, horizon = [*_RODS, *_TURNING], 1.5
        case ["bicycle"]:  # leaning, steering a little, falling to one side
            names = [str(s.func) for s in (*model.coordinates, *model.speeds)]
            radius = {s.name: v for s, v in zip(model.constants, model.values, strict=True)}
            moving = {
                **{"phi": 0.05, "delta": 0.02, "u_phi": 0.5, "u_x": _FORWARD},
                "omega_R": -_FORWARD / radius["r_R"],
                "omega_F": -_FORWARD / radius["r_F"],
            }
            start, horizon = [moving.get(name, 0.0) for name in names], 1.5
        case ["springs", _, "absolute"]:  # a wave along the row, and weight
            start = [*(0.1 * math.sin(0.3 * k) for k in range(q)), *[0.0] * u]
        case ["rider", "bicycle"]:  # let go with every angle at 0.1 rad
            start = [0.1] * q + [0.0] * u
        case _:
            raise ValueError(f"there is no scenario for {model.name}")
    return Scenario(np.array(start), np.zeros(len(model.specifieds)), horizon)
