"""The released pydy 0.9.4: its Cython generator, and odeint, as its users have them."""

from __future__ import annotations

import warnings
from collections.abc import Callable

import numpy as np
import sympy as sm
from harness.odeint import odeint_solver
from harness.solving import SolverPeer, serve_solver

from pydy.codegen.ode_function_generators import generate_ode_function


class ReleasedSolver(SolverPeer):
    def build(self) -> None:
        model = self.model
        n = len(model.speeds)
        self.rhs = generate_ode_function(
            sm.Matrix(model.forcing),
            model.coordinates,
            model.speeds,
            model.constants,
            mass_matrix=sm.Matrix(n, n, model.mass_matrix),
            coordinate_derivatives=sm.Matrix(model.coordinate_derivatives),
            specifieds=model.specifieds or None,
            generator="cython",
            constants_arg_type="array",
            **({"specifieds_arg_type": "array"} if model.specifieds else {}),
        )

    def methods(self) -> list[str]:
        return ["odeint"]

    def solver(self, method: str, tolerance: float) -> Callable[[], np.ndarray]:
        inputs = (self.scenario.inputs,) if self.model.specifieds else ()
        return odeint_solver(self.rhs, self, (*inputs, self.values), tolerance)


if __name__ == "__main__":
    warnings.simplefilter("ignore")
    serve_solver(ReleasedSolver())
