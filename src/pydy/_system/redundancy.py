"""Whether constraints that were left out as redundant follow from the others at a state.

They were chosen at random states. A linkage may be assembled in other ways than in those, and a
constraint may contradict others in a length that was random there.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any, Literal

import numpy as np

from pydy._assembly.assembly import Assembly
from pydy._assembly.definition import Definition
from pydy._assembly.model import CompiledModel
from pydy._graph.derivative import dense_jacobian
from pydy._graph.node import Graph
from pydy._graph.rounding import rounding_bounds
from pydy._mechanics.tuning import ROUNDED
from pydy._rank import DIGITS, ROUNDING, rank

__all__ = ["check_redundant", "evaluated_rows"]


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
    equations, at = definition.equations, (np.array([t]), x[None], r[None], p)
    left_out = equations.left_out
    if not any(left_out):
        return
    n = len(equations.coordinates)
    places = slice(len(equations.holonomic), len(equations.holonomic) + len(left_out[0]))
    found = evaluated_rows(definition, model, "bounds", at)
    closed, bounds = (part[0, places] for part in found)
    if (far := ~(np.abs(closed) <= DIGITS * bounds)).any():
        k = int(np.argmax(far))
        raise ValueError(
            f"The holonomic constraint `{left_out[0][k]}` was left out as redundant, but with "
            f"these numbers it contradicts the others: at t = {t!r} it is {closed[k]:.3g} where "
            "the others hold. Correct it, or the constants and initial conditions."
        )
    slopes = model.interpreted(_Rows(*equations.left_out, "slopes"), at)
    values = {name: part.reshape(-1, len(x)) for name, part in slopes.items()}
    kept, more = (values[name][:, n:] for name in ("kept", "more"))
    # The state is known to six digits: what is singular there leaves half of them.
    needed = rank(np.concatenate([kept, more]), least=DIGITS**0.5)
    if needed > len(kept):
        raise ValueError(
            f"At t = {t!r} there are {needed} independent velocity constraints, but only "
            f"{len(kept)} were kept: at the states that were tried, the others followed from them. "
            "The linkage can be assembled in another way, in which they do. Say which is meant: "
            "`pydy.mechanics.Definition(..., configuration=system.initial_conditions)`."
        )


def evaluated_rows(
    definition: Definition,
    model: CompiledModel,
    what: Literal["sizes", "bounds"],
    at: tuple[np.ndarray, np.ndarray, np.ndarray, np.ndarray],
) -> tuple[np.ndarray, np.ndarray]:
    """Return the residuals of all constraints at m states, and what rounding is in proportion to.

    What a search leaves of states that are zero is a rounding of one unit: smaller ones count as
    that.

    Parameters
    ----------
    definition : Definition
    model : CompiledModel
        With all expressions compiled in.
    what : {'sizes', 'bounds'}
        The terms of the last sum, which are quickly found, or the bounds on rounding errors.
    at : (t, x, r, p)

    Returns
    -------
    residuals, sizes : ndarray, shape (m, rows)
        Holonomic constraints, those left out behind the others, then velocity constraints.
    """
    rows, (t, x, r, p) = _Rows(*definition.equations.left_out, what), at
    m, least = len(t), ROUNDING / DIGITS
    small = np.abs(x) < least
    if small.any():  # the sizes are those of other states, which follow the first ones
        moved = np.where(small, np.copysign(least, x), x)
        r = np.concatenate([r, r]) if len(r) == m > 1 else r
        at = np.concatenate([t, t]), np.concatenate([x, moved]), r, p
    found = model.interpreted(rows, at)
    return found["rows"][:m], found["sizes"][-m:]


@dataclass(frozen=True)
class _Rows:
    """All constraints, those that were left out too, and what is asked of them."""

    closed: tuple[Any, ...]
    redundant: tuple[Any, ...]
    what: str

    def __call__(self, assembly: Assembly) -> dict[str, list[int]]:
        graph = assembly.graph
        closed = assembly.read(self.closed, "the holonomic constraints")
        more = assembly.read(self.redundant, "the velocity constraints")
        if self.what == "slopes":
            states = [graph.input("x", k) for k in range(assembly.sizes[0])]
            return {
                "kept": dense_jacobian(graph, assembly.velocity, states),
                "more": dense_jacobian(graph, more, states),
            }
        rows = [*assembly.holonomic, *closed, *assembly.velocity, *more]
        parts = (assembly.holonomic, closed), (assembly.velocity, more)
        sizes = [size for part in parts for size in self._sizes(graph, *part)]
        return {"rows": rows, "sizes": sizes}

    def _sizes(self, graph: Graph, kept: list[int], left_out: list[int]) -> list[int]:
        """Return what rounding is in proportion to.

        SymPy adds up numbers beforehand. A row that is a number is what it left of those of the
        other rows, or of cosines between directions; so is one that was left out whose terms are
        no larger than roundings of the rows that were kept.
        """
        g, rows, inherited = graph, [*kept, *left_out], self.what == "bounds"
        of_constants = [n for n in rows if g.constant[n]]
        sizes = dict(zip(rows, rounding_bounds(g, rows, inherited), strict=True))
        more = rounding_bounds(g, of_constants, inherited, constants=True)
        sizes.update(zip(of_constants, more, strict=True))
        numbers = [n for n in of_constants if g.ops[n] == "const" and n != g.zero]
        others = [(size, ROUNDED / DIGITS) for n, size in sizes.items() if n not in numbers]
        sizes.update(dict.fromkeys(numbers, g.sum(others, ROUNDED / DIGITS)))
        if kept:
            least = sizes[kept[0]]
            for n in kept[1:]:
                least = g.call("min", least, sizes[n])
            roundings = g.sum([(least, ROUNDED)])
            for n in {*left_out} - {*numbers}:
                tiny = g.call("le", sizes[n], roundings)
                sizes[n] = g.call("select", tiny, g.sum([(least, ROUNDED / DIGITS)]), sizes[n])
        return [sizes[n] for n in rows]
