"""Whatever the package offers is tested: a row that is missing somewhere fails here by name.

The public names, their arguments and the registries are walked; nothing is listed twice.
"""

from __future__ import annotations

import ast
import importlib
import inspect
import re
from collections.abc import Iterator
from functools import cache
from pathlib import Path
from typing import Any

import pytest

import registry
from fuzz import table
from pydy import solvers
from pydy.solvers import StepOptions
from test_reference import public_modules

TESTS = Path(__file__).parent
DOCS = TESTS.parent / "docs"
UNTRIED = TESTS / "fuzz" / "untried.txt"
VARIADIC = (inspect.Parameter.VAR_POSITIONAL, inspect.Parameter.VAR_KEYWORD)


def missing(names: Any, rows: Any) -> list[str]:
    return sorted(set(names) - set(rows))


# ---- Solvers ----


def test_every_explicit_solver_has_its_published_facts():
    lacking = missing(registry.EXPLICIT_NAMES, registry.SOLVER_FACTS)
    assert not lacking, f"add a row to SOLVER_FACTS in tests/registry.py for {lacking}"
    stale = missing(registry.SOLVER_FACTS, registry.EXPLICIT_NAMES)
    assert not stale, f"remove from SOLVER_FACTS in tests/registry.py: {stale}"


def test_every_solver_can_be_imported():
    lacking = [name for name in registry.SOLVER_NAMES if name not in solvers.__all__]
    assert not lacking, f"export in src/pydy/solvers/__init__.py, in `__all__` too: {lacking}"


def test_every_solver_is_in_the_reference_and_in_the_page_on_solvers():
    patterns = {
        "docs/solvers.md": "'{}'",
        "docs/howto/solvers.md": "'{}'",
        "docs/reference/solvers.md": "pydy.solvers.{}",
        "README.md": "'{}'",
        "src/pydy/solvers/__init__.py": "`{}`",
        "src/pydy/system.py": "'{}'",
    }
    lacking = [
        f"{page}: {pattern.format(name)}"
        for page, pattern in patterns.items()
        for name in registry.SOLVER_NAMES
        if pattern.format(name) not in (DOCS.parent / page).read_text(encoding="utf-8")
    ]
    assert not lacking, f"add to the tables and docstrings: {lacking}"


def test_every_option_of_a_solver_is_tried_with_bad_values_and_documented():
    lacking = [name for name in registry.SOLVER_OPTIONS if f"integrate.{name}" not in tried()]
    lacking = [name for name in lacking if f"rk4.{name}" not in tried()]
    assert not lacking, (
        f"add a target `integrate.{lacking[0]}` to the test file of the option (it imports "
        "fuzz.table), or to tests/fuzz/families/integration.py"
    )
    text = "\n".join(page.read_text(encoding="utf-8") for page in DOCS.rglob("*.md"))
    lacking = [n for n in registry.SOLVER_OPTIONS if not re.search(rf"`{n}\b|\b{n}=", text)]
    assert not lacking, f"no page of docs/ names the options {lacking}"
    lacking = missing(registry.SOLVER_OPTIONS, parameters_section(solvers.Solver.__call__))
    assert not lacking, f"the docstring of Solver.__call__ does not describe {lacking}"


def test_every_option_of_steps_is_read_by_ensembles():
    # They take the same options: one that only `run/integration.py` reads would have no effect.
    text = (TESTS.parent / "src/pydy/solvers/run/lanes.py").read_text(encoding="utf-8")
    lacking = [n for n in StepOptions.__annotations__ if not re.search(rf"\.{n}\b", text)]
    assert not lacking, (
        f"ensembles ignore the options {lacking}: read them in src/pydy/solvers/run/lanes.py, or "
        "refuse them in `_read` of src/pydy/ensemble/integration.py and keep them out of "
        "`StepOptions`"
    )


# ---- Laws, languages, formats ----


def test_every_law_is_compared_with_values_of_its_source():
    text = (TESTS / "contact/test_laws.py").read_text(encoding="utf-8")
    lacking = [law.__name__ for law in registry.LAWS if f"{law.__name__}(" not in text]
    assert not lacking, f"compare with its source's values in tests/contact/test_laws.py: {lacking}"


def test_every_contact_condition_is_simulated_in_a_test():
    text = "\n".join(p.read_text(encoding="utf-8") for p in (TESTS / "contact").glob("*.py"))
    lacking = [c.__name__ for c in registry.CONTACT_CONDITIONS if f"{c.__name__}(" not in text]
    assert not lacking, f"no test in tests/contact makes {lacking}"


@pytest.mark.parametrize(
    ("kind", "names", "folder"),
    [
        ("back end", registry.BACK_ENDS, "_backends"),
        ("format", registry.FORMATS, "export"),
        ("language", registry.LANGUAGES, "export"),
        ("collocation method", registry.COLLOCATION_METHODS, "control"),
        ("optimizer", registry.OPTIMIZERS, "control"),
        ("solver of SciPy", registry.SCIPY_SOLVERS, "system"),
    ],
)
def test_every_name_of_a_registry_is_tried_by_the_tests_of_its_room(kind, names, folder):
    text = "\n".join(p.read_text(encoding="utf-8") for p in (TESTS / folder).rglob("*.py"))
    lacking = [name for name in names if f'"{name}"' not in text and f"{name}'" not in text]
    by_suffix = [n for n in lacking if n.startswith(".") and f'{n}"' in text]
    lacking = [name for name in lacking if name not in by_suffix]
    assert not lacking, f"no test in tests/{folder} names the {kind} {lacking}"


# ---- Lists by hand ----


@pytest.mark.parametrize(
    ("names", "instead"),
    [
        (registry.SOLVER_NAMES, "SOLVERS or SOLVER_NAMES"),
        (registry.ADAPTIVE_NAMES, "ADAPTIVE or ADAPTIVE_NAMES"),
        (registry.EXPLICIT_NAMES, "EXPLICIT or EXPLICIT_NAMES"),
    ],
)
def test_no_test_lists_all_solvers_by_hand(names, instead):
    offences = []
    for path in sorted(TESTS.rglob("*.py")):
        text = path.read_text(encoding="utf-8")
        if path.name in ("registry.py", "test_registry.py") or any(n not in text for n in names):
            continue
        for node in ast.walk(ast.parse(text)):
            if isinstance(node, ast.List | ast.Tuple | ast.Set | ast.Dict):
                entries = node.keys if isinstance(node, ast.Dict) else node.elts
                words = {getattr(e, "id", getattr(e, "value", None)) for e in entries}
                if set(names) == words & set(registry.SOLVER_NAMES):
                    offences.append(f"{path.relative_to(TESTS)}:{node.lineno}")
    assert not offences, f"use {instead} of tests/registry.py: {offences}"


# ---- Arguments ----


@cache
def tried() -> frozenset[str]:
    """Return the arguments that the fuzz tables have, as ``callable.argument``."""
    for family in table.FAMILIES:
        table.load(family)
    # `Contacts.constants[value]` and `System.times=` are values of an argument.
    return frozenset(re.sub(r"\[[^.]*$|=$|\)$", "", target.name) for target in table.TARGETS)


def parameters_section(thing: Any) -> set[str]:
    """Return the names under "Parameters" of a numpydoc docstring."""
    text = inspect.getdoc(thing) or ""
    section = re.search(
        r"^Parameters\n-+\n(.*?)(?=^\S[^\n]*\n-+\n|\Z)", text, re.DOTALL | re.MULTILINE
    )
    lines = section[1].splitlines() if section else []
    heads = [line.partition(" : ")[0] for line in lines if line and not line[0].isspace()]
    return {name.strip() for head in heads for name in head.split(",")}


def callables() -> Iterator[tuple[str, Any]]:
    """Yield the public functions, classes and methods with the names that users call them by."""
    for module_name in public_modules():
        if module_name.startswith("pydy.examples"):
            continue  # scripts to read and to copy: they hand on what the package checks
        module = importlib.import_module(module_name)
        for name in getattr(module, "__all__", ()):
            thing = getattr(module, name)
            if inspect.isclass(thing) and issubclass(thing, BaseException):
                continue
            if callable(thing):
                yield name, thing
            if inspect.isclass(thing):
                for member, function in inspect.getmembers(thing, callable):
                    if not member.startswith("_") and inspect.isroutine(function):
                        yield f"{name}.{member}", function


def arguments() -> dict[str, list[str]]:
    """Return ``callable.argument`` for each documented argument, and its names in subclasses."""
    names: dict[Any, list[str]] = {}
    for name, thing in callables():
        names.setdefault(inspect.unwrap(thing), []).append(name)
    found = {}
    for thing, aliases in names.items():
        try:
            signature = inspect.signature(thing)
        except ValueError:
            continue
        documented = parameters_section(thing)
        first, *others = sorted(aliases, key=len)
        for parameter in signature.parameters.values():
            if parameter.kind not in VARIADIC and parameter.name in documented:
                also = [f"{name}.{parameter.name}" for name in others]
                found[f"{first}.{parameter.name}"] = also
    return found


def test_every_documented_argument_is_tried_with_bad_values():
    # An entry may name the method without its class, or that of a subclass.
    lacking = {
        argument
        for argument, also in arguments().items()
        if not {argument, argument.split(".", 1)[-1], *also} & tried()
    }
    known = set(UNTRIED.read_text(encoding="utf-8").split())
    new = sorted(lacking - known)
    assert not new, (
        'add `@target("<callable>.<argument>", <kind>)` to a file of tests/fuzz/families, or to '
        f"the test file of the new code (it imports fuzz.table), for {new}"
    )
    done = sorted(known - lacking)
    assert not done, f"remove from tests/fuzz/untried.txt what is tried by now, or gone: {done}"
