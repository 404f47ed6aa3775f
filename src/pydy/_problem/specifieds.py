"""How the specifieds of a System, or those of one call, give the array r."""

from __future__ import annotations

from typing import Any

from pydy._assembly import Definition
from pydy._errors import warn_user
from pydy._problem.entries import check_specifieds
from pydy.codegen import SpecifiedsPlan


def checked_plan(
    definition: Definition,
    specifieds: dict[Any, Any],
    already_warned: set[Any],
    contradicted: set[str] | None,
) -> SpecifiedsPlan:
    """Return how a System's dictionary of specifieds, in either format, gives r."""
    symbols = definition.places["specifieds"]
    plan = SpecifiedsPlan(specifieds, symbols, argument="specifieds")
    check_specifieds(definition, plan, contradicted)
    return warn_of_derivatives(definition, plan, already_warned)


def warn_of_derivatives(
    definition: Definition, plan: SpecifiedsPlan, already_warned: set[Any]
) -> SpecifiedsPlan:
    """Warn once of derivatives that are zero for want of a value although their function moves.

    Numbers and expressions have derivatives that follow; samples and functions have not.
    """
    if plan.inputs.constant or not definition.lower_derivatives:
        return plan
    moving = {plan.symbols[k] for k in plan.inputs.changing}
    for rate, lower in definition.lower_derivatives.items():
        function = next((s for s in reversed(lower) if s in plan.given), None)
        if rate not in plan.given and function in moving and rate not in already_warned:
            already_warned.add(rate)
            warn_user(
                f"`specifieds` gives `{function}` as a function or as samples, but the "
                f"equations also hold `{rate}`, which stays zero: the motion contradicts "
                f"itself. Give `{function}` as a SymPy expression of time, from which its "
                f"derivatives follow, or give `{rate}` a function too."
            )
    return plan


def warn_of_activations(
    definition: Definition, plan: SpecifiedsPlan, already_warned: set[Any]
) -> None:
    """Warn once of states of muscles that are specifieds without a value: activations."""
    body = definition.equations.multibody
    for state in () if body is None else body.activations:
        if (
            state in definition.specifieds
            and state not in plan.given
            and state not in already_warned
        ):
            already_warned.add(state)
            warn_user(
                f"`{state}` is a state of a musculotendon, but the equations do not hold its "
                "derivative, `rhs()`: it is a specified without a value, and stays zero. Add it to "
                "the coordinates and its derivative to the kinematic equations of a "
                f"pydy.mechanics.Definition, or give `{state}` in `specifieds`."
            )
