"""Every documented way of calling: which arguments, which form, which method of System.

Written for any pydy with the documented interface; the released one is called as it is.
"""

from __future__ import annotations

import re
from collections.abc import Callable
from typing import Any

import numpy as np

from harness.problems import Problem

__all__ = ["WAYS", "order_of_constants", "way_of"]

FORMS = ("[1]", "[2]", "[3]")
WAYS = (
    *("rhs, arrays", "rhs, p a dictionary", "rhs, r a dictionary", "rhs, r a function"),
    *("rhs, both dictionaries", "rhs, r a dictionary of functions"),
    *(f"rhs of form {form}" for form in FORMS),
    *("evaluate_ode of one state", "evaluate_constraints of one state"),
    *("evaluate_outputs of one state", "constants set", "integrate, three times"),
)


def way_of(
    name: str, problem: Problem, system: Any, generator: str
) -> tuple[Callable[[], Any], Callable[[], Any]]:
    """Return what is measured, and what gives numbers to compare.

    Parameters
    ----------
    name : str
        One of WAYS.
    problem : Problem
    system : System
        A new one.
    generator : str
    """
    specifieds = list(system.specifieds_symbols)
    named = {s.name: v for s, v in problem.constants.items()}
    r = np.zeros(len(specifieds))
    x = np.array([0.1 + 0.02 * k for k in range(len(system.states))])
    if name.startswith("rhs of form"):
        rhs = _formed(name.split()[-1], problem, specifieds, generator)
        every = np.array(list(problem.constants.values()))
        return _both(lambda: rhs(x, 0.0, r, every))
    if name == "constants set":
        values = dict(problem.constants)

        def assign() -> None:
            system.constants = values

        return assign, lambda: [0.0]
    if name.startswith("evaluate_outputs"):
        from sympy import Symbol

        system.outputs = {Symbol("twice"): 2 * system.states[0]}
    rhs = system.generate_ode_function(generator=generator)
    p = np.array([named[n] for n in order_of_constants(rhs)])
    if name.startswith("evaluate_"):
        evaluate = getattr(system, name.split()[0])
        return _both(evaluate)  # at the initial conditions
    if name.startswith("integrate"):
        system.times = np.linspace(0.0, 0.02, 3)
        return _both(system.integrate)
    with_functions = {s: lambda x, t: 0.0 for s in specifieds}
    ways: dict[str, tuple[Any, Any]] = {
        "rhs, arrays": (r, p),
        "rhs, p a dictionary": (r, dict(problem.constants)),
        "rhs, r a dictionary": (dict.fromkeys(specifieds, 0.0), p),
        "rhs, r a function": (lambda x, t: np.zeros(len(r)), p),
        "rhs, both dictionaries": (dict.fromkeys(specifieds, 0.0), dict(problem.constants)),
        "rhs, r a dictionary of functions": (with_functions, p),
    }
    a, b = ways[name]
    return _both(lambda: rhs(x, 0.0, a, b))


def _both(function: Callable[[], Any]) -> tuple[Callable[[], Any], Callable[[], Any]]:
    return function, function


def order_of_constants(rhs: Any) -> list[str]:
    """Return the constants' names as the generated function's docstring lists them."""
    _, _, after = rhs.__doc__.partition("array with the constants in the following order:")
    listed, _, _ = after.partition("Returns")
    return re.findall(r"- (\w+)", listed)


def _formed(form: str, problem: Problem, specifieds: list[Any], generator: str) -> Any:
    """Return a generated function of one of the three forms."""
    from pydy.codegen.ode_function_generators import generate_ode_function

    kane, constants = problem.kane, list(problem.constants)
    options: dict[str, Any] = {"specifieds": specifieds, "generator": generator}
    if form == "[1]":
        force = kane.rhs()
    elif form == "[2]":
        force, options["mass_matrix"] = kane.forcing_full, kane.mass_matrix_full
    else:
        rates = kane.kindiffdict()
        force, options["mass_matrix"] = kane.forcing, kane.mass_matrix
        options["coordinate_derivatives"] = type(force)([rates[q.diff()] for q in kane.q])
    return generate_ode_function(force, list(kane.q), list(kane.u), constants, **options)
