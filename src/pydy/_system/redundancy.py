"""Whether constraints that were left out as redundant follow from the others at a state.

They were chosen at random states. A linkage may be assembled in other ways than in those, and a
constraint may contradict others in a length that was random there.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np

from pydy._assembly.assembly import Assembly
from pydy._assembly.definition import Definition
from pydy._assembly.model import CompiledModel
from pydy._graph.derivative import dense_jacobian
from pydy._system.tuning import DIGITS, INDEPENDENT

__all__ = ["check_redundant"]


def check_redundant(
    definition: Definition,
    model: CompiledModel,
    t: float,
    x: np.ndarray,
    r: np.ndarray,
    p: np.ndarray,
) -> None:
    """Refuse a state that keeps the constraints, where more of them are independent than were kept.

    Parameters
    ----------
    definition : Definition
    model : CompiledModel
        With all expressions compiled in.
    t, x, r, p

    Raises
    ------
    ValueError
        More constraints are independent, or one that was left out does not hold.
    """
    equations = definition.equations
    body = equations.multibody
    if body is None or not (body.redundant or body.closed):
        return
    n = len(equations.coordinates)
    parts = _LeftOut(body.closed, tuple(map(equations.in_states, body.redundant)))
    found = model.interpreted(parts, (np.array([t]), x[None], r[None], p))
    values = {name: part.reshape(-1, len(x)) for name, part in found.items() if name != "closed"}
    closed = found["closed"][0]
    size = np.maximum(np.abs(x[:n]), np.abs(x[:n]).max(initial=0.0) or 1.0)
    allowed = DIGITS * (np.abs(values["slopes"][:, :n]) @ size)
    if not (np.abs(closed) <= allowed).all():
        k = int(np.argmax(np.abs(closed) - allowed))
        raise ValueError(
            f"The holonomic constraint `{body.closed[k]}` was left out as redundant, but with "
            f"these numbers it contradicts the others: at t = {t!r} it is {closed[k]:.3g} where "
            "the others hold. Correct it, or the constants and initial conditions."
        )
    kept, more = (values[name][:, n:] for name in ("kept", "more"))
    needed = _rank(np.concatenate([kept, more]))
    if needed > len(kept):
        raise ValueError(
            f"At t = {t!r} there are {needed} independent velocity constraints, but only "
            f"{len(kept)} were kept: at the states that were tried, the others followed from them. "
            "The linkage can be assembled in another way, in which they do. Say which is meant: "
            "`pydy.mechanics.Definition(..., configuration=system.initial_conditions)`."
        )


@dataclass(frozen=True)
class _LeftOut:
    """What is looked at, as nodes."""

    closed: tuple[Any, ...]
    redundant: tuple[Any, ...]

    def __call__(self, assembly: Assembly) -> dict[str, list[int]]:
        graph = assembly.graph
        states = [graph.input("x", k) for k in range(assembly.sizes[0])]
        closed = assembly.read(self.closed, "the holonomic constraints")
        more = assembly.read(self.redundant, "the velocity constraints")
        return {
            "closed": closed,
            "slopes": dense_jacobian(graph, closed, states),
            "kept": dense_jacobian(graph, assembly.velocity, states),
            "more": dense_jacobian(graph, more, states),
        }


def _rank(rows: np.ndarray) -> int:
    sizes = np.linalg.norm(rows, axis=1, keepdims=True)
    rows = rows / np.where(sizes > 0.0, sizes, 1.0)
    return int((np.linalg.svd(rows, compute_uv=False) > INDEPENDENT).sum())
