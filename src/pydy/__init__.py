"""Fast simulation of multibody systems whose equations SymPy derives.

Start at `pydy.system.System`. This file imports nothing heavy, so that a worker process that
receives compiled code never pays for SymPy.
"""

from pydy._version import __version__

__all__ = ["__version__"]
