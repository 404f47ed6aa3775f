"""Functions of a Layer: how they read arguments, whatever the library of the arrays."""

from __future__ import annotations

from functools import cache
from itertools import product
from typing import Any

import numpy as np

from fuzz.kinds import array
from fuzz.table import hashable, key, target
from fuzz.world import driven, world
from pydy._checks import real_array
from pydy.layers import Layer


class _NumPyArrays:
    """Arrays of NumPy, for a Layer without derivatives: a library takes seconds to import."""

    def array(self, value: Any, argument: str) -> np.ndarray:
        return real_array(value, argument)

    def concatenate(self, columns: list[np.ndarray]) -> np.ndarray:
        return np.concatenate(self.broadcast(columns), axis=-1)

    def broadcast(self, arrays: list[np.ndarray]) -> list[np.ndarray]:
        lead = np.broadcast_shapes(*(a.shape[:-1] for a in arrays))
        return [np.broadcast_to(a, (*lead, a.shape[-1])) for a in arrays]

    def call(self, function: Any, given: list[np.ndarray]) -> np.ndarray:
        return np.asarray(function.value(*given))


@cache
def _layer() -> Layer:
    system = driven(world().o, ode_solver="dop853", outputs={"twice": 2 * world().o.x})
    return Layer(system._layer_functions(None, {}), _NumPyArrays(), "NumPy")


_shapes = ((2,), (None, 2), (None, None, 2))
_finite = array(*_shapes, check=lambda a: np.isfinite(a).all()).or_none()
_any = array(*_shapes).or_none()
_instants = array((), *((None,) * k for k in (1, 2, 3))).or_none()
_whose = {"x": "`initial_conditions", "r": "specified", "p": "`constants"}
for _function, _name in product(("ode", "outputs", "simulate", "final"), ("x", "t", "r", "p")):
    _moves = _function in ("simulate", "final")
    if _moves and _name == "t":
        continue
    _kind = _instants if _name == "t" else _finite if _moves else _any

    @target(f"Layer.{_function}.{_name}", _kind, f"`{_name}", _whose.get(_name, "`t"))
    def _(v, function=_function, name=_name):
        return getattr(_layer(), function)(**{name: v})

    if _name != "t":

        @target(f"Layer.{_function}.{_name}[key]", key, f"`{_name}")
        def _(v, function=_function, name=_name):
            return getattr(_layer(), function)(**{name: {hashable(v): 1.0}})
