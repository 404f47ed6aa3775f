"""The function that computes the derivatives, generated with the user's options."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Any

from pydy._assembly import CompiledModel, Definition
from pydy._checks import flag
from pydy._errors import warn_user
from pydy._problem import compile_definition
from pydy.codegen import RightHandSide, make_function

if TYPE_CHECKING:
    from types import FunctionType

_ARGUMENTS = ("constants_arg_type", "specifieds_arg_type", "time_first")
_REFUSED = {
    "right_hand_side", "coordinates", "speeds", "constants", "mass_matrix",
    "coordinate_derivatives", "outputs",
}  # fmt: skip


@dataclass(frozen=True, eq=False)
class GeneratedFunction:
    """The function generated for a definition, with its code."""

    definition: Definition
    code: CompiledModel
    arguments: Mapping[str, Any]  # how the function reads r and p, and in which order
    _functions: dict[bool, FunctionType] = field(default_factory=dict)

    def function(self, *, any_layout: bool) -> FunctionType:
        """Return the function that users call; it is built once for each array layout."""
        side = RightHandSide(self.code, any_layout=any_layout, **self.arguments)
        if side.refuse_strided not in self._functions:
            self._functions[side.refuse_strided] = make_function(side)
        return self._functions[side.refuse_strided]


def checked_options(options: dict[str, object]) -> dict[str, object]:
    """Check the options of `System.generate_ode_function`; those set by the System are refused."""
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
    return options


def generate(
    definition: Definition, eom_method: object, options: Mapping[str, object]
) -> GeneratedFunction:
    """Return a definition's code for options of `generate_ode_function`, not compiled yet."""
    arguments = {k: options[k] for k in _ARGUMENTS if k in options}
    generator_options = {k: v for k, v in options.items() if k not in _ARGUMENTS}
    code = compile_definition(definition, eom_method, generator_options)
    return GeneratedFunction(definition, code, arguments)
