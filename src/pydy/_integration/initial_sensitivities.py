"""The sensitivities of the initial state.

An initial condition is a parameter of its own state. States that the constraints make dependent
follow by the implicit function theorem: from c(x, θ) = 0 follows c_d x_d' = −(c_i x_i' + c_θ) for
the dependent states d.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from pydy._checks import describe
from pydy._integration.sensitivities import AugmentedSystem
from pydy._states import follow


@dataclass(frozen=True, eq=False)
class InitialSensitivities:
    """The sensitivities of the initial state, in the columns of an AugmentedSystem."""

    augmented: AugmentedSystem
    dependent: tuple[int, ...]  # columns of the states that follow from the others
    argument: str = "sensitivities"  # the user's argument, for messages

    def values(self, x0: np.ndarray, t: float) -> np.ndarray:
        """Return the sensitivities of the initial state x0, shape (n, k); see `follow`."""
        values, augmented = self.independent(), self.augmented
        if self.blocks:
            n, instant, model = augmented.columns.states, np.array([t]), augmented.model
            args = (instant, x0[None], augmented.inputs.rows(x0[None], instant), augmented.p)
            rows = [model.evaluate(model.compiled_jacobian(b, "x"), *args) for b in self.blocks]
            moved = [
                augmented.evaluate((b,), instant, x0[None], values[None])[0] for b in self.blocks
            ]
            gradients = [row.reshape(-1, n) for row in rows]
            every = np.concatenate(moved)
            if not follow(values, gradients, every, self.unknowns, self.dependent):
                raise ValueError(self.refusal)
        return values

    @property
    def blocks(self) -> list[str]:
        """The blocks of constraints that initial conditions satisfy."""
        constraints = self.augmented.definition.equations.constraints
        return [block for block in ("holonomic", "velocity") if getattr(constraints, block)]

    @property
    def unknowns(self) -> list[range]:
        """The columns of the states for which each of these blocks is solved."""
        first = len(self.augmented.definition.equations.coordinates)
        every = {"holonomic": range(first), "velocity": range(first, self.augmented.columns.states)}
        return [every[block] for block in self.blocks]

    def independent(self) -> np.ndarray:
        """Return the sensitivities of the initial state, zero for the dependent ones."""
        columns = self.augmented.columns
        values = np.zeros((columns.states, columns.count))
        column = 0
        for parameter in self.augmented.parameters:
            if parameter.kind == "states":
                if parameter.index in self.dependent:
                    raise ValueError(
                        f"`{self.argument}` has the initial condition of `{parameter.symbol}`, "
                        "which follows from the others by the constraints, as do "
                        f"{self._following}. Name independent ones, or make it independent: "
                        "call set_dependent_initial_conditions(dep_vars=…) with other variables."
                    )
                values[parameter.index, column] = 1.0
            column += parameter.count
        return values

    @property
    def _following(self) -> str:
        return describe([self.augmented.definition.states[k] for k in self.dependent])

    @property
    def refusal(self) -> str:
        """The message for constraints that do not determine the dependent conditions."""
        target = "for any: none is named as dependent"
        if self.dependent:
            target = f"for {self._following}"
        return (
            f"`{self.argument}` needs to know how the dependent initial conditions follow from "
            f"the others, but the constraints cannot be solved {target}. Call "
            "set_dependent_initial_conditions(dep_vars=…) with variables for which they can."
        )
