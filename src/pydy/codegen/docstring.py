"""The docstring of a generated function: which numbers, in which order."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import sympy as sm
from sympy.core.function import AppliedUndef

from pydy._names import told_apart

__all__ = ["rhs_docstring"]

_HEAD = """\
Returns the derivatives of the states, i.e. numerically evaluates the right
hand side of the first order differential equation.

x' = f({arguments})

Parameters
==========
"""

_STATES = """\
x : ndarray, shape({n},)
    The state vector is ordered as such:
{states}
"""

_TIME = """\
t : float
    The current time.
"""

_SPECIFIEDS = {
    None: """\
r : dictionary; ndarray, shape({s},); function

    There are three options for this argument. (1) is more flexible but
    (2) and (3) are much more efficient.

    (1) A dictionary that maps the specified functions of time to floats,
    ndarrays, or functions that produce ndarrays. The keys can be a single
    specified symbolic function of time or a tuple of symbols. The total
    number of symbols must be equal to {s}. If the value is a
    function it must be of the form {g}, where x is the current state
    vector ndarray and t is the current time float and it must return an
    ndarray of the correct shape. For example::

      r = {{a: 1.0,
           (d, b) : np.array([1.0, 2.0]),
           (e, f) : lambda {xt}: np.array(x[0], x[1]),
           c: lambda {xt}: np.array(x[2])}}

    (2) A ndarray with the specified values in the correct order and of the
    correct shape.

    (3) A function that must be of the form {g}, where x is the current
    state vector and t is the current time and it must return an ndarray of
    the correct shape.

    The specified inputs are, in order:
{specifieds}
""",
    "dictionary": """\
r : dictionary
    Maps the specified functions of time, or tuples of them, to floats,
    ndarrays or functions of the form {g} that return them. The total
    number of symbols must be equal to {s}:
{specifieds}
""",
    "array": """\
r : ndarray, shape({s},)
    The values of the specified inputs, in order:
{specifieds}
""",
    "function": """\
r : function
    A function of the form {g} that returns an ndarray, shape({s},), of
    the specified inputs, in order:
{specifieds}
""",
}

_CONSTANTS = {
    None: """\
p : dictionary len({k}) or ndarray shape({k},)
    Either a dictionary that maps the constants symbols to their numerical
    values or an array with the constants in the following order:
{constants}
""",
    "dictionary": """\
p : dictionary len({k})
    Maps the constants symbols to their numerical values:
{constants}
""",
    "array": """\
p : ndarray shape({k},)
    The numerical values of the constants, in order:
{constants}
""",
}

_RETURNS = """
Returns
=======
dx : ndarray, shape({n},)
    The derivative of the state vector.
"""

_OUTPUTS = """\
y : ndarray, shape({o},)
    Values of the provided outputs.
{outputs}
"""


def _items(names: Sequence[Any]) -> str:
    told = told_apart(names, [_name(name) for name in names])
    return "\n".join(f"        - {name}" for name in told)


def _name(symbol: Any) -> str:
    """Return a symbol's name; SymPy's printer takes a hundred times as long for the same."""
    if isinstance(symbol, sm.Symbol):
        return str(symbol.name)
    if isinstance(symbol, AppliedUndef):
        return f"{symbol.func.__name__}({', '.join(map(_name, symbol.args))})"
    return str(symbol)


def rhs_docstring(
    states: Sequence[Any],
    specifieds: Sequence[Any],
    constants: Sequence[Any],
    num_outputs: int,
    *,
    specifieds_arg_type: str | None,
    constants_arg_type: str | None,
    time_first: bool,
) -> str:
    """Return the docstring of a generated right-hand side.

    Parameters
    ----------
    states, specifieds, constants : sequence of symbols
        In the order of the arrays.
    num_outputs : int
    specifieds_arg_type, constants_arg_type : str or None
    time_first : bool
    """
    xt = "t, x" if time_first else "x, t"
    arguments = ", ".join([xt, *(["r"] if specifieds else []), "p"])
    values = {
        "arguments": arguments,
        "xt": xt,
        "g": f"g({xt})",
        "n": len(states),
        "s": len(specifieds),
        "k": len(constants),
        "o": num_outputs,
        "states": _items(states),
        "specifieds": _items(specifieds),
        "constants": _items(constants),
        "outputs": _items([f"y{i}(t)" for i in range(num_outputs)]),
    }
    parts = [_HEAD, *((_TIME, _STATES) if time_first else (_STATES, _TIME))]
    if specifieds:
        parts.append(_SPECIFIEDS[specifieds_arg_type])
    parts += [_CONSTANTS[constants_arg_type], _RETURNS]
    if num_outputs:
        parts.append(_OUTPUTS)
    return "".join(part.format(**values) for part in parts)
