"""Models that are derived once in a session of tests, by whichever process needs them first.

The derivation is stored as a pickle in the cache folder of the session, which `conftest.py` makes
and all workers share; the folder belongs to this user alone, as `pydy._cache_folder` checks. The
key holds what the model was derived from: the sources of the module and of the helpers it imports,
the arguments, and the versions of SymPy and Python. Nothing is derived when a test module loads.
"""

from __future__ import annotations

import ast
import hashlib
import pickle
import sys
from collections.abc import Callable
from functools import cache, wraps
from pathlib import Path
from typing import Any

import sympy as sm

from pydy import _cache_folder

TESTS = Path(__file__).parent


@cache
def sources(path: Path) -> bytes:
    """Return the text of a module and of the modules in `tests` that it imports."""
    text = path.read_bytes()
    names = set()
    for node in ast.walk(ast.parse(text)):
        if isinstance(node, ast.Import):
            names |= {alias.name for alias in node.names}
        elif isinstance(node, ast.ImportFrom) and node.module:
            names |= {node.module, *(f"{node.module}.{alias.name}" for alias in node.names)}
    modules = [TESTS.joinpath(*name.split(".")) for name in sorted(names)]
    helpers = [file for m in modules for file in (m.with_suffix(".py"), m / "__init__.py")]
    return text + b"".join(
        sources(helper) for helper in helpers if helper.exists() and helper != path
    )


def derived_once(derive: Callable[..., Any]) -> Callable[..., Any]:
    """Cache a function that derives a model: in this process, and for the session's others.

    Its arguments need a `repr` that tells them apart. `function.__wrapped__()` gives a fresh copy,
    which a test may change.
    """

    @cache
    @wraps(derive)
    def model(*arguments: Any) -> Any:
        file = Path(sys.modules[derive.__module__].__file__ or "")
        made_of = (derive.__module__, derive.__qualname__, arguments, sm.__version__, sys.version)
        key = hashlib.sha256(repr(made_of).encode() + sources(file)).hexdigest()
        stored = _cache_folder.read(key)
        if stored is not None:
            return pickle.loads(stored)
        made = derive(*arguments)
        _cache_folder.write(key, pickle.dumps(made))
        return made

    return model
