"""What derivatives answer: where a system balances, and how it moves near there.

`System.find_equilibrium` and `System.linearize` return these.
"""

from __future__ import annotations

from pydy.analysis.equilibria import Equilibrium
from pydy.analysis.linear import LinearModel

__all__ = ["Equilibrium", "LinearModel"]
