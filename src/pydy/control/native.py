"""A nonlinear program as compiled functions with their data, for solvers and for Python.

The functions are those of ``_backends/core/nlp.c``, with the signatures of IPOPT's C interface;
here its structs are filled in. No Python runs when a solver calls them.
"""

from __future__ import annotations

import ctypes
from ctypes import c_bool, c_double, c_int, c_void_p
from typing import Any

import numpy as np

from pydy._backends.llvm.native import nlp_functions

SIGNATURES: dict[str, tuple[Any, ...]] = {
    "cost": (c_int, c_void_p, c_bool, c_void_p, c_void_p),
    "rows": (c_int, c_void_p, c_bool, c_int, c_void_p, c_void_p),
    "gradient": (c_int, c_void_p, c_bool, c_void_p, c_void_p),
    "jacobian": (c_int, c_void_p, c_bool, c_int, c_int, *[c_void_p] * 4),
    "hessian": (
        *(c_int, c_void_p, c_bool, c_double, c_int, c_void_p, c_bool, c_int),
        *[c_void_p] * 4,
    ),
}


class Native:
    """The compiled functions of an Nlp: `addresses` by the keys of `SIGNATURES`.

    They take the `handle` as their last argument; it is valid as long as this object lives.
    """

    def __init__(self, nlp: Any) -> None:
        code = nlp_functions()
        self.addresses = {name: code.addresses[f"nlp_{name}"] for name in SIGNATURES}
        self._call = {
            name: ctypes.CFUNCTYPE(c_bool, *kinds)(self.addresses[name])
            for name, kinds in SIGNATURES.items()
        }
        self._sizes = nlp.size, nlp.rows, len(nlp.jacobian_at[0]), len(nlp.hessian_at[0])
        self._kept: list[Any] = [code]
        tables = [
            np.array([self._part(nlp, k, name) for k, piece in enumerate(nlp.pieces)
                      if name in piece.functions.kernels], np.int64)
            for name in SIGNATURES
        ]  # fmt: skip
        units = [nlp.row_sizes, nlp.sizes / nlp.cost_size, *nlp.derivative_units]
        words = np.zeros(24, np.int64)
        words[:17] = [
            *(nlp.size, nlp.rows),
            *(len(table) for table in tables),
            *(self._kept_at(table) for table in tables),
            *(self._kept_at(np.ascontiguousarray(unit)) for unit in units),
            self._kept_at(np.empty(nlp.size)),
        ]
        words[17:18].view(float)[0] = nlp.cost_size
        words[18:22] = [self._kept_at(a) for a in (*nlp.jacobian_at, *nlp.hessian_at)]
        words[22:] = self._sizes[2:]
        self.handle = self._kept_at(words)

    def _kept_at(self, array: np.ndarray) -> int:
        """Keep an array, and return where its numbers are."""
        self._kept.append(array)
        return int(array.ctypes.data)

    def _part(self, nlp: Any, k: int, name: str) -> list[int]:
        """Return the words of one function of a piece."""
        piece = nlp.pieces[k]
        functions, points = piece.functions, piece.points
        words, scratch, code = functions.sweep(name)
        self._kept.append(code)
        rows, costs = functions.outputs if name == "hessian" else (0, 0)
        data = np.concatenate([piece.data, np.zeros((rows + costs, points))])
        words[9:11] = points, len(data) if points > 1 else 0
        results = len(functions.kernels[name].program.outputs) * points
        to = piece.at[functions.gradient_at] if name == "gradient" else np.empty(0)
        arrays = (
            np.ascontiguousarray(piece.at, np.int64),
            np.ascontiguousarray(nlp.sizes[piece.at]),
            data,
            np.ascontiguousarray(piece.constants, float),
            np.empty(piece.at.size),
            np.empty(results if name in ("cost", "gradient") else 0),
            np.empty(scratch),
            np.empty(points, np.uint8),
            np.ascontiguousarray(to, np.int64),
        )
        return [*words.tolist(), *(self._kept_at(a) for a in arrays), rows, costs]

    # -- from Python ------------------------------------------------------------------------------

    def cost(self, y: np.ndarray, out: np.ndarray) -> bool:
        """Write the objective; return whether it is finite."""
        n = self._sizes[0]
        return bool(self._call["cost"](n, _at(y), True, _at(out), self.handle))

    def gradient(self, y: np.ndarray, out: np.ndarray) -> bool:
        """Write the gradient of the objective; return whether it could be computed."""
        n = self._sizes[0]
        return bool(self._call["gradient"](n, _at(y), True, _at(out), self.handle))

    def rows(self, y: np.ndarray, out: np.ndarray) -> bool:
        """Write the rows; return whether they are finite."""
        n, m = self._sizes[:2]
        return bool(self._call["rows"](n, _at(y), True, m, _at(out), self.handle))

    def jacobian(self, y: np.ndarray, out: np.ndarray) -> bool:
        """Write the entries of the rows' Jacobian; return whether they could be computed."""
        n, m, entries, _ = self._sizes
        arguments = (n, _at(y), True, m, entries, None, None, _at(out), self.handle)
        return bool(self._call["jacobian"](*arguments))

    def hessian(
        self, y: np.ndarray, weight: float, multipliers: np.ndarray, out: np.ndarray
    ) -> bool:
        """Write the entries of the Hessian of the Lagrangian."""
        n, m, _, entries = self._sizes
        arguments = (n, _at(y), True, weight, m, _at(multipliers), True, entries, None, None)
        return bool(self._call["hessian"](*arguments, _at(out), self.handle))


def _at(array: np.ndarray) -> int:
    assert array.dtype == float and array.flags.c_contiguous  # noqa: PT018
    return int(array.ctypes.data)
