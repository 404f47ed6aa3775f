"""Fast simulation of multibody systems described with SymPy.

Start at `System`: ``from pydy import System``. It is imported when it is first asked for, so that a
worker process that receives compiled code never pays for SymPy.
"""

from importlib import import_module
from types import ModuleType
from typing import TYPE_CHECKING, Any

from pydy._version import __version__

if TYPE_CHECKING:
    from pydy.system import System

__all__ = ["System", "__version__"]


def __getattr__(name: str) -> Any:
    if name == "System":
        from pydy._collector import collector_paused

        # It may load SymPy and NumPy, too; collections would visit their objects again and again.
        with collector_paused():
            system = import_module("pydy.system").System
        return globals().setdefault(name, system)
    raise AttributeError(f"module {__name__!r} has no attribute {name!r}")


def __dir__() -> list[str]:
    # And the modules that were imported.
    modules = [n for n, value in globals().items() if isinstance(value, ModuleType)]
    return sorted({*__all__, *(n for n in modules if n[0] != "_")})
