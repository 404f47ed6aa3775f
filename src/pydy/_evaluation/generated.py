"""The function that computes the derivatives, generated with the user's options."""

from __future__ import annotations

from collections.abc import Mapping
from functools import partial
from typing import TYPE_CHECKING, Any

import numpy as np

from pydy._assembly import CompiledModel
from pydy._checks import flag
from pydy._errors import warn_user
from pydy._judges import check_evaluated_orientations
from pydy._problem import StateSamples
from pydy.codegen import RightHandSide, make_function

if TYPE_CHECKING:
    from types import FunctionType

_ARGUMENTS = ("constants_arg_type", "specifieds_arg_type", "time_first")
_REFUSED = {
    "right_hand_side", "coordinates", "speeds", "constants", "mass_matrix",
    "coordinate_derivatives", "outputs",
}  # fmt: skip


def checked_options(options: dict[str, object]) -> tuple[dict[str, object], dict[str, object]]:
    """Check the options of `System.generate_ode_function`; those set by the System are refused.

    Return how the function reads r and p and in which order, and how its code is generated.
    """
    if "specifieds" in options:
        warn_user(
            "`specifieds` is ignored by System.generate_ode_function: the System takes care of "
            "them. Set `system.specifieds` for their values."
        )
        options = {k: v for k, v in options.items() if k != "specifieds"}
    refused = sorted(_REFUSED & set(options))
    if refused:
        raise TypeError(
            f"generate_ode_function() got `{refused[0]}`, which the System takes from its own "
            "equations. Options are linear_sys_solver, constants_arg_type, "
            "specifieds_arg_type, time_first, generator and those of the generator."
        )
    flag(options.get("time_first", False), "`time_first`")
    arguments = {k: options[k] for k in _ARGUMENTS if k in options}
    return arguments, {k: v for k, v in options.items() if k not in _ARGUMENTS}


def generated_function(
    code: CompiledModel, arguments: Mapping[str, Any], *, any_layout: bool
) -> FunctionType:
    """Return the function that users call; it is built once for each array layout.

    The `arguments` are how it reads r and p and in which order, which is the same for one code.
    """
    definition = code.definition
    oriented = definition is not None and definition.equations.unit_quaternions
    judge = partial(_judge_first_state, code) if oriented else None
    side = RightHandSide(code, any_layout=any_layout, judge=judge, **arguments)
    functions: dict[bool, FunctionType] = code.latest.setdefault("functions", {})
    if side.refuse_strided not in functions:
        functions[side.refuse_strided] = make_function(side)
    return functions[side.refuse_strided]


def _judge_first_state(code: CompiledModel, x: object) -> None:
    """Warn if the state of a generated function's first call has quaternions not of unit length."""
    definition = code.definition
    assert definition is not None
    state = np.asarray(x, dtype=float)[None]
    r, p = np.zeros((1, len(definition.specifieds))), np.ones(len(definition.constants))
    at = StateSamples(definition, code, np.zeros(1), state, r, p)  # no orientation depends on these
    check_evaluated_orientations(at, code.compiled("rates").program, set())
