"""Constants and inputs that the models of CommonRoad share, and the System that they make."""

from __future__ import annotations

from collections.abc import Iterable
from typing import Any

import numpy as np
import sympy as sm
import sympy.physics.mechanics as me

from pydy.mechanics import Definition
from pydy.system import System
from pydy.vehicles.cars import GRAVITY, STIFFNESS_PER_LOAD, values_of


class CarInputs:
    """The inputs of a car within their limits, and the values of its constants."""

    def __init__(self, name: str) -> None:
        self.values = {**values_of(name), "g": GRAVITY, "C": STIFFNESS_PER_LOAD}
        self.specifieds = me.dynamicsymbols("v_delta a_long")

    def steering_rate(self) -> sm.Expr:
        """Return the input within its limits."""
        largest = sm.Symbol("v_delta_max")
        return _between(-largest, self.specifieds[0], largest)

    def acceleration(self, speed: sm.Expr) -> sm.Expr:
        """Return the input within its limits."""
        largest, switch = sm.symbols("a_max v_switch")
        power = largest * switch / sm.Max(speed, switch, evaluate=False)
        return _between(-largest, self.specifieds[1], power)

    def torques(self, speed: sm.Expr, radius: sm.Expr) -> tuple[sm.Expr, sm.Expr]:
        """Return the torques of the drive and of the brakes, of all wheels together."""
        acceleration, mass = self.acceleration(speed), sm.Symbol("m")
        drive = mass * radius * sm.Max(acceleration, 0, evaluate=False)
        return drive, -mass * radius * sm.Min(acceleration, 0, evaluate=False)

    def system(
        self,
        definition: Definition,
        constants: Iterable[str],
        start: dict[sm.Expr, float],
        outputs: dict[str, sm.Expr],
    ) -> System:
        """Return a System with these constants that drives straight ahead."""
        return System(
            definition,
            {sm.Symbol(name): self.values[name] for name in constants},
            dict.fromkeys(self.specifieds, 0.0),
            "dop853",
            initial_conditions=start,
            times=np.linspace(0.0, 1.0, 101),
            outputs=outputs,
        )


def _between(least: Any, value: Any, most: Any) -> sm.Expr:
    return sm.Max(least, sm.Min(value, most, evaluate=False), evaluate=False)
