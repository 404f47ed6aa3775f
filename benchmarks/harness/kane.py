"""Mass matrix, forcing and kinematics out of a KanesMethod."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import sympy as sm
import sympy.physics.mechanics as me

from harness.model import Model


def from_kane(name: str, kane: Any, values: Callable[[str], float], **about: Any) -> Model:
    """Take M, F and q' out of a KanesMethod.

    Parameters
    ----------
    name : str
    kane : KanesMethod
    values : callable
        Gives the value of a constant by its name.
    **about
        What is to be remembered of the model.
    """
    t = me.dynamicsymbols._t
    rates = kane.kindiffdict()
    zero = dict.fromkeys((*kane._uaux, *(u.diff(t) for u in kane._uaux)), sm.S.Zero)
    replace = {**rates, **zero}

    def clean(expressions: Any) -> list[Any]:
        found = _symbols(expressions)
        if any(key in found for key in replace):
            return [e.xreplace(replace) for e in expressions]
        return list(expressions)

    matrix, forcing = clean(kane.mass_matrix), clean(kane.forcing)
    kinematics = clean([rates[q.diff(t)] for q in kane.q])
    found = _symbols([*matrix, *forcing, *kinematics])
    rest = [s for s in found if s not in {*kane.q, *kane.u, t}]
    constants = sorted((s for s in rest if s.is_Symbol), key=sm.default_sort_key)
    return Model(
        name=name,
        coordinates=list(kane.q),
        speeds=list(kane.u),
        specifieds=sorted((s for s in rest if not s.is_Symbol), key=sm.default_sort_key),
        constants=constants,
        mass_matrix=matrix,
        forcing=forcing,
        coordinate_derivatives=kinematics,
        positive_definite=not kane._udep,
        values=[float(values(s.name)) for s in constants],
        about={"sympy": sm.__version__, **about},
    )


def _symbols(expressions: Any) -> set[Any]:
    """Return symbols, functions of time and derivatives; every distinct object is seen once."""
    found, seen, stack = set(), set(), list(expressions)
    while stack:
        expr = stack.pop()
        if id(expr) in seen:
            continue
        seen.add(id(expr))
        if isinstance(expr, (sm.Symbol, sm.Derivative, sm.core.function.AppliedUndef)):
            found.add(expr)
        else:
            stack.extend(expr.args)
    return found
