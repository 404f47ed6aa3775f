"""Options of solvers and formats: their names, and the check that each value has to pass."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping
from typing import Any, NoReturn

from pydy._checks import choice, shown
from pydy._names import nearest

# Called with a value and its name for messages; returns the converted value.
Check = Callable[[Any, str], Any]


def checked(table: Mapping[str, Check], options: Mapping[str, Any]) -> dict[str, Any]:
    """Apply each option's check; options without a check are returned unchanged."""
    return {
        name: table[name](value, f"`{name}`") if name in table else value
        for name, value in options.items()
    }


def one_of(*options: Any) -> Check:
    """Return a check for `choice` among these options."""
    return lambda value, label: choice(value, options, label)


def optional(check: Check) -> Check:
    """Return a check that lets None pass."""
    return lambda value, label: None if value is None else check(value, label)


# Pairs of names for one option: native solvers and `solve_ivp`, then `odeint`.
_SAME = (
    *(("max_step", "hmax"), ("first_step", "h0"), ("min_step", "hmin"), ("max_steps", "mxstep")),
    *(("jac", "Dfun"), ("lband", "ml"), ("uband", "mu")),
    # The largest step of methods with fixed step size.
    *(("max_step", "step"), ("hmax", "step")),
)

# What other libraries call the argument that selects a solver.
_CHOOSE_A_SOLVER = ("method", "solver", "integrator", "ode_solver")
# What other libraries call the times of the results.
_TIMES = ("t_eval", "t_span", "t", "tspan", "saveat", "times")


def _how_to_choose(solver: object) -> str:
    return f"Choose a solver by `system.ode_solver = {shown(solver)}`."


def refuse_solver(solver: object) -> NoReturn:
    """Refuse an option `solver`, which no solver has."""
    raise TypeError(f"There is no option `solver`. {_how_to_choose(solver)}")


def check_option_names(solver: str, names: Iterable[str], options: Mapping[str, object]) -> None:
    """Refuse an option that a solver does not have, and suggest the nearest one."""
    names = sorted({*names} - {"continuation"} if "continuation" not in options else names)
    unknown = [name for name in options if name not in names]
    if unknown:
        alike = [name for pair in _SAME if unknown[0] in pair for name in pair if name in names]
        hint = f"It is called `{alike[0]}` there." if alike else ""
        if unknown[0] in _CHOOSE_A_SOLVER:
            hint = _how_to_choose(options[unknown[0]])
        if unknown[0] in _TIMES:
            hint = "Give the times of the results by `system.times = ...`."
        raise TypeError(
            f"`{solver}` has no option `{unknown[0]}`; its options are {', '.join(names)}. "
            f"{hint or nearest(unknown[0], names, or_all=False)}".rstrip()
        )
