"""This project's sensitivities: columns beside the state, called from Python as System calls them.

The method "dop853 plain" integrates the state alone.
"""

from __future__ import annotations

from collections.abc import Callable
from types import SimpleNamespace
from typing import Any

import numpy as np
from harness.program import compiled_model_of, solver_function
from harness.sensitive import joined, parameters
from harness.solving import SolverPeer, serve_solver

from pydy._integration.parameters import Parameter
from pydy._integration.sensitivities import AugmentedSystem, columns_of
from pydy._integration.sensitivity_request import augmented_rates_function
from pydy._integration.step_control import compiled_sensitivities
from pydy.codegen.arguments import SpecifiedsPlan
from pydy.solvers import dop853, tsit5, vern9

NATIVE = {"dop853": dop853, "tsit5": tsit5, "vern9": vern9}


class OurSensitivities(SolverPeer):
    def warm_up(self) -> None:
        for method in NATIVE.values():
            method(lambda x, t: -x, [1.0], [0.0, 1e-3])

    def build(self) -> None:
        model = self.model
        compiled = compiled_model_of(model)
        symbols = tuple(model.specifieds)
        plan = SpecifiedsPlan(dict(zip(symbols, self.scenario.inputs, strict=True)), symbols)
        states = (*model.coordinates, *model.speeds)
        definition: Any = SimpleNamespace(states=states, specifieds=symbols)
        wanted = tuple(Parameter(model.constants[k], "constants", k) for k in parameters(model))
        columns = columns_of(wanted, definition)
        self.sensitive = AugmentedSystem(
            definition, compiled, plan.inputs, self.values, wanted, columns
        )
        self.sensitive.kernel().link()
        self.function = augmented_rates_function(self.sensitive)
        self.plain = solver_function(model, self.scenario.inputs)

    def methods(self) -> list[str]:
        return list(NATIVE)

    def solver(self, method: str, tolerance: float) -> Callable[[], np.ndarray]:
        start, times = self.scenario.start, [0.0, self.scenario.horizon]
        name, _, plain = method.partition(" ")
        options: dict[str, Any] = {"rtol": tolerance, "atol": tolerance}
        if plain:
            f, args = self.plain
            alone = NATIVE[name].prepare(f, start, times, args, **options)
            return lambda: alone(start)[-1]
        sensitive = self.sensitive
        columns = sensitive.columns
        whole = columns.together(start, np.zeros((len(start), columns.count)))
        options["sensitivities"] = compiled_sensitivities(sensitive, np.asarray(start), options)
        run = NATIVE[name].prepare(self.function, whole, times, (), **options)

        def solve() -> np.ndarray:
            state, values = columns.split(run(whole)[-1])
            return joined(state, values[:, : columns.count])

        return solve


if __name__ == "__main__":
    serve_solver(OurSensitivities())
