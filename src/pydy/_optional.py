"""Packages that only some features need, imported when the feature is used."""

from __future__ import annotations

from importlib import import_module
from typing import Any

__all__ = ["require"]


def require(module: str, extra: str, purpose: str) -> Any:
    """Import a module, or say what to install.

    Parameters
    ----------
    module : str
    extra : str
        Of this package: what brings the module.
    purpose : str
        What needs it, for the message.

    Raises
    ------
    ImportError
        The module is not installed.
    """
    try:
        return import_module(module)
    except ImportError as error:
        package = module.partition(".")[0]
        raise ImportError(
            f"{purpose} needs {package}, which is not installed: pip install 'pydy[{extra}]'."
        ) from error
