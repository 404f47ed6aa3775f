"""Numbers of linear solves, the same in all back ends and languages."""

from __future__ import annotations

import re

from pydy._rank import ROUNDING

# A matrix of n rows is singular where a pivot is not above n times this of its scale: what
# rounding leaves of a pivot that is zero (Higham, Accuracy and Stability, 2nd ed., §9.3). Every
# solve uses it.
SINGULAR = ROUNDING

# Marks on the diagonal of constraints in a system of `pydy._program.interpret.constrained`. No
# user's matrix has such an entry, and both are exact in single precision.
INDEPENDENT, REDUNDANT = -(2.0**120), -(2.0**121)


def numbered(text: str) -> str:
    """Write the numbers of solves into code, C, JavaScript or Python, in place of their names."""
    return re.sub(
        r"\b(INDEPENDENT|REDUNDANT|SINGULAR)\b", lambda name: repr(globals()[name[0]]), text
    )
