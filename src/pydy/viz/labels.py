"""Labels as they are typeset: Greek letters by their names, indices lowered."""

from __future__ import annotations

import re

__all__ = ["typeset"]

_LETTERS = [
    "alpha",
    "beta",
    "gamma",
    "delta",
    "epsilon",
    "zeta",
    "eta",
    "theta",
    "iota",
    "kappa",
    "lambda",
    "mu",
    "nu",
    "xi",
    "omicron",
    "pi",
    "rho",
    "varsigma",
    "sigma",
    "tau",
    "upsilon",
    "phi",
    "chi",
    "psi",
    "omega",
]
GREEK = {name: chr(0x3B1 + k) for k, name in enumerate(_LETTERS)}
GREEK |= {name.capitalize(): chr(0x391 + k) for k, name in enumerate(_LETTERS) if k != 17}
_SYMBOL = re.compile(r"(?P<base>[A-Za-z]+?)_?(?P<index>\d+|(?<=_)[A-Za-z0-9]+)?(?P<rate>'*)")


def typeset(label: str) -> list[str]:
    """Return a label's base and index; the index of what is no symbol's name is empty.

    Examples
    --------
    >>> from pydy.viz.labels import typeset
    >>> typeset('theta_1'), typeset("q2'"), typeset('x_foot'), typeset('kinetic energy')
    (['θ', '1'], ["q'", '2'], ['x', 'foot'], ['kinetic energy', ''])
    """
    found = _SYMBOL.fullmatch(label)
    if found is None:
        return [label, ""]
    base, index, rate = found["base"], found["index"] or "", found["rate"]
    if base not in GREEK and len(base) > 2 and not index.isdigit():
        return [label, ""]  # a word
    return [GREEK.get(base, base) + rate, GREEK.get(index, index)]
