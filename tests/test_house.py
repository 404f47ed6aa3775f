"""The rules of docs/design.md: contracts of imports in pyproject.toml, and what they cannot say."""

from __future__ import annotations

import ast
import graphlib
import importlib
import os
import re
import subprocess
import sys
import tomllib
from collections.abc import Iterator
from functools import cache
from pathlib import Path
from typing import NamedTuple

import nouns
import pytest
from doors import door_of, rooms

ROOT = Path(__file__).parents[1]
SRC = ROOT / "src"

# What `pydy` hands out when it is asked for; nothing is loaded before.
HANDED_OUT = {"pydy.system"}

# Imported inside the function that needs them, never when a module loads.
LATE = {
    "matplotlib",
    "pandas",
    "xarray",
    "dask",
    "distributed",
    "zarr",
    "tqdm",
    "Cython",
    "setuptools",
    "IPython",
    "mpl_toolkits",
    "PIL",
    "playwright",
    "casadi",
    "mujoco",
    "jax",
    "torch",
}

KANE_MODULE = "pydy._mechanics.kane"
# KanesMethod's underscore attributes, but for `_q`, `_u`, `_km` and their like, which any class of
# ours may have as well.
KANE_PRIVATE = {
    *("_f_h", "_f_nh", "_k_nh", "_f_dnh", "_k_dnh", "_f_d", "_k_d", "_f_k", "_k_ku", "_k_kqdot"),
    *("_f_k_implicit", "_k_ku_implicit", "_k_kqdot_implicit", "_qdot_u_map", "_Ars"),
    *("_qdep", "_udep", "_uaux", "_aux_eq", "_fr", "_frstar", "_form_fr", "_form_frstar"),
    *("_bodylist", "_forcelist", "_inertial", "_constraint_solver"),
}


VECTOR_MODULE = "pydy._mechanics.frame_tree"
VECTOR_PRIVATE = {
    *("_dcm_dict", "_ang_vel_dict", "_ang_acc_dict", "_pos_dict", "_vel_dict", "_acc_dict"),
}


class Import(NamedTuple):
    """One imported module, absolute, and whether loading the file runs the import."""

    target: str
    line: int
    at_load: bool


def module_name(path: Path) -> str:
    parts = path.relative_to(SRC).with_suffix("").parts
    return ".".join(parts[:-1] if parts[-1] == "__init__" else parts)


MODULES = {module_name(path): path for path in sorted((SRC / "pydy").rglob("*.py"))}


def within(module: str, packages: tuple[str, ...]) -> bool:
    return any(module == package or module.startswith(package + ".") for package in packages)


@cache
def tree(module: str) -> ast.Module:
    return ast.parse(MODULES[module].read_text(encoding="utf-8"))


@cache
def imports(module: str) -> tuple[Import, ...]:
    is_package = MODULES[module].name == "__init__.py"
    package = module if is_package else module.rpartition(".")[0]
    found = find_imports(tree(module), package, at_load=True)
    return tuple(i for i in found if module != "pydy" or i.at_load or i.target not in HANDED_OUT)


def find_imports(node: ast.AST, package: str, *, at_load: bool) -> Iterator[Import]:
    if isinstance(node, ast.Import):
        for alias in node.names:
            yield Import(alias.name, node.lineno, at_load)
    elif isinstance(node, ast.ImportFrom):
        base = absolute(node, package)
        for alias in node.names:
            # `from package import name` meets either a module or something inside `package`.
            full = f"{base}.{alias.name}"
            target = full if full in MODULES or not within(base, ("pydy",)) else base
            target = door_of(base).get(alias.name, target)
            yield Import(target, node.lineno, at_load)
    elif isinstance(node, ast.Call) and (name := dynamic_import(node)):
        yield Import(name, node.lineno, at_load)
    if isinstance(node, ast.If) and "TYPE_CHECKING" in ast.unparse(node.test):
        for child in node.body:
            yield from find_imports(child, package, at_load=False)
        for child in node.orelse:
            yield from find_imports(child, package, at_load=at_load)
        return
    if isinstance(node, ast.FunctionDef | ast.AsyncFunctionDef | ast.Lambda):
        at_load = False
    for child in ast.iter_child_nodes(node):
        yield from find_imports(child, package, at_load=at_load)


def absolute(node: ast.ImportFrom, package: str) -> str:
    if not node.level:
        return node.module or ""
    above = package.split(".")[: len(package.split(".")) - node.level + 1]
    return ".".join([*above, *([node.module] if node.module else [])])


def dynamic_import(node: ast.Call) -> str | None:
    """Return the module named in ``import_module("...")`` or ``__import__("...")``."""
    name = node.args[0] if node.args else None
    if isinstance(name, ast.Constant) and isinstance(name.value, str):
        function = ast.unparse(node.func).rpartition(".")[2]
        return name.value if function in {"import_module", "__import__"} else None
    return None


def everywhere() -> Iterator[tuple[str, Import]]:
    for module in MODULES:
        for imported in imports(module):
            yield module, imported


def no_offences(offences: list[str]) -> None:
    assert not offences, "\n" + "\n".join(offences)


@cache
def names_imported():
    """Return (importing module, module, name) for all names that modules import from others."""
    return [
        (module, node.module, alias.name)
        for module in MODULES
        for node in ast.walk(tree(module))
        if isinstance(node, ast.ImportFrom)
        for alias in node.names
    ]


@pytest.mark.parametrize("room", rooms())
def test_a_door_lists_what_is_public_or_taken_by_other_rooms(room):
    taken = {
        name
        for module, source, name in names_imported()
        if source == room and not within(module, (room,))
    }
    module = importlib.import_module(room)
    public = set() if room.startswith("pydy._") else set(module.__all__)
    assert dir(module) == sorted(module.__all__)
    submodules = {name for name in door_of(room) if f"{room}.{name}" in MODULES}
    unused = set(door_of(room)) - taken - public - submodules
    assert not unused, f"{room}/__init__.pyi: no other room takes {sorted(unused)}"
    missing = public - set(door_of(room))
    assert not missing, f"{room}/__init__.pyi lacks the public names {sorted(missing)}"


def test_the_contracts_of_imports_are_kept():
    # The layers, circles of packages, and who knows neither SymPy nor graphs: `lint-imports`.
    code = "from importlinter.cli import lint_imports_command; lint_imports_command()"
    done = subprocess.run(
        [sys.executable, "-P", "-c", code, "--no-cache"],
        cwd=ROOT,
        env={**os.environ, "PYTHONPATH": str(SRC), "COLUMNS": "100"},
        capture_output=True,
        text=True,
        check=False,
    )
    assert done.returncode == 0, done.stdout + done.stderr


def test_no_module_of_ours_is_imported_by_a_text_that_no_contract_sees():
    no_offences(
        [
            f"{module}:{node.lineno} imports {name} by its name"
            for module in MODULES
            for node in ast.walk(tree(module))
            if isinstance(node, ast.Call) and (name := dynamic_import(node))
            if within(name, ("pydy",)) and (module, name) != ("pydy", "pydy.system")
        ]
    )


# Those of packages are found by a contract, but not those of a package with its own modules.
def test_there_are_no_circles_of_modules():
    no_circles({m: {i.target for i in imports(m)} & MODULES.keys() - {m} for m in MODULES})


def test_there_are_no_circles_in_the_benchmarks_harness():
    folder = ROOT / "benchmarks" / "harness"
    names = {f"harness.{path.stem}" for path in folder.glob("*.py")}
    graph: dict[str, set[str]] = {}
    for path in folder.glob("*.py"):
        found = graph.setdefault(f"harness.{path.stem}", set())
        for node in ast.walk(ast.parse(path.read_text(encoding="utf-8"))):
            if isinstance(node, ast.ImportFrom) and node.module:
                found |= {node.module, *(f"{node.module}.{a.name}" for a in node.names)} & names
    no_circles(graph)


def no_circles(graph: dict[str, set[str]]) -> None:
    try:
        graphlib.TopologicalSorter(graph).prepare()
    except graphlib.CycleError as error:
        pytest.fail("imports go in a circle: " + " <- ".join(error.args[1]))


def test_only_expressions_become_a_graph_and_no_mechanics():
    # For contracts, a package of others is one module.
    no_offences(
        [
            f"pydy._graph.from_sympy:{line} imports {target}"
            for target, line, _ in imports("pydy._graph.from_sympy")
            if within(target, ("sympy.physics",))
        ]
    )


def test_optional_and_slow_libraries_are_imported_inside_functions():
    no_offences(
        [
            f"{module}:{line} imports {target} when the module loads"
            for module, (target, line, at_load) in everywhere()
            if at_load and target.split(".")[0] in LATE
        ]
    )


@pytest.mark.parametrize(
    ("owner", "private"), [(KANE_MODULE, KANE_PRIVATE), (VECTOR_MODULE, VECTOR_PRIVATE)]
)
def test_only_its_reader_touches_the_underscore_attributes_of_a_class_of_sympy(owner, private):
    offences = []
    for module in MODULES.keys() - {owner}:
        for node in ast.walk(tree(module)):
            # A string is `getattr(kane, "_f_h")`.
            name = getattr(node, "attr", None) or getattr(node, "value", None)
            if isinstance(node, ast.Attribute | ast.Constant) and name in private:
                offences.append(f"{module}:{node.lineno} touches {name}")
    no_offences(sorted(offences))


def modules_loaded_by(statement: str) -> set[str]:
    """Return `sys.modules` of a fresh interpreter after `statement`."""
    code = f"{statement}; import sys; print(*sys.modules)"
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stderr
    return set(done.stdout.split())


def test_importing_pydy_and_its_packages_loads_neither_sympy_nor_numpy():
    heavy = {"sympy", "numpy", "scipy", "llvmlite", *LATE}
    assert not modules_loaded_by(f"import {', '.join(['pydy', *rooms()])}") & heavy


def test_system_is_handed_out_when_it_is_asked_for():
    assert "pydy.system" not in modules_loaded_by("import pydy; dir(pydy)")
    assert "pydy.system" in modules_loaded_by("from pydy import System")


def test_public_modules_show_what_they_list():
    for name, path in MODULES.items():
        if "\n__all__ = " in path.read_text("utf-8") and "._" not in name and name != "pydy":
            module = importlib.import_module(name)
            hidden = [n for n in dir(module) if n[0] != "_" and n not in module.__all__]
            assert not hidden, f"dir({name}) shows {hidden}: `__dir__ = __all__.copy`"


def test_pydy_has_no_other_attributes():
    import pydy
    import pydy.system

    assert pydy.System is pydy.system.System
    assert {"System", "__version__"} <= set(dir(pydy))
    with pytest.raises(AttributeError, match="module 'pydy' has no attribute 'Sistem'"):
        _ = pydy.Sistem


def test_a_worker_that_receives_a_kernel_never_loads_sympy():
    loaded = modules_loaded_by("import pydy._kernel, pydy.inputs, pydy.ensemble.engine")
    assert "sympy" not in loaded


@pytest.mark.skipif("pydy.solvers" not in MODULES, reason="there are no native solvers yet")
def test_importing_the_solvers_never_loads_sympy():
    assert "sympy" not in modules_loaded_by("import pydy.solvers")


def test_importing_system_loads_no_optional_library():
    # SciPy and SymPy load Cython's shadow module and its version; the compiler is what costs.
    late = (LATE - {"Cython"}) | {"Cython.Compiler.Main"}
    assert not modules_loaded_by("import pydy.system") & late


def test_first_values_and_native_motions_need_none_of_scipys_packages():
    loaded = modules_loaded_by(
        "import pydy.system, pydy.robots, pydy.viz, pydy.models; "
        "s = pydy.models.n_link_pendulum_on_cart(1); s.evaluate_ode([0.1, 0.2, 0.3, 0.4]); "
        "s.times, s.ode_solver = [0.0, 1.0], 'dop853'; s.integrate(); s.simulate()"
    )
    packages = ("integrate", "linalg", "optimize", "spatial", "stats")
    assert not loaded & {f"scipy.{name}" for name in packages}


def test_only_modules_of_the_reference_list_what_they_show():
    # What other modules may take is what has no underscore. `_array_layout` names the offsets that
    # `tools/solvers_ir.py` writes into C.
    pages = "\n".join(p.read_text("utf-8") for p in (ROOT / "docs/reference").glob("*.md"))
    shown = set(re.findall(r"automodule:: (pydy[a-z_.]*)", pages))
    listing = {m for m in MODULES if "\n__all__ = " in MODULES[m].read_text(encoding="utf-8")}
    for_scripts = {f"pydy.viz.{place}" for place in ("camera", "light", "visualization_frame")}
    offences = listing - shown - for_scripts - {"pydy", "pydy._array_layout"}
    no_offences([f"{m} has an `__all__`" for m in sorted(offences)])


def test_no_file_is_longer_than_800_lines():
    lengths = {m: len(p.read_text(encoding="utf-8").splitlines()) for m, p in MODULES.items()}
    del lengths["pydy.system"]  # documentation above all: see below
    offences = [f"{m} has {n} lines, 800 are allowed" for m, n in lengths.items() if n > 800]
    no_offences(offences)


def test_methods_of_system_document_and_call():
    """What a method does stands where its subject is; `System` has its documentation."""
    (system,) = (n for n in tree("pydy.system").body if isinstance(n, ast.ClassDef))
    offences = []
    for method in (n for n in ast.walk(system) if isinstance(n, ast.FunctionDef)):
        body = method.body[1:] if ast.get_docstring(method) else method.body
        lines = body[-1].end_lineno - body[0].lineno + 1 if body else 0
        if lines > 40:
            offences.append(f"System.{method.name} has {lines} lines of code, 40 are allowed")
    no_offences(offences)


# Where small numbers are data: coefficients, models, documented defaults.
DATA = (
    *("pydy._backends.llvm.sincos", "pydy.solvers.tableaus", "pydy.examples"),
    "pydy._backends.llvm.arctangent",
    *("pydy.vehicles.cars", "pydy.vehicles.commonroad.tires"),
)
DEFAULTS = ("pydy.solvers.options", "pydy.export.fmu")


def small_numbers(module: str) -> Iterator[ast.expr]:
    """Yield the numbers of an expression that can only be thresholds, but for defaults.

    A room of one file may name its own at its top.
    """
    top = tree(module)
    named: set[ast.AST] = set()
    for node in ast.walk(top):
        if isinstance(node, ast.arguments):
            named.update(n for d in (*node.defaults, *node.kw_defaults) if d for n in ast.walk(d))
        elif isinstance(node, ast.ClassDef):
            fields = [n.value for n in node.body if isinstance(n, ast.AnnAssign) and n.value]
            named.update(n for value in fields for n in ast.walk(value))
    if module.count(".") == 1:
        named.update(n.value for n in top.body if isinstance(n, ast.Assign))
    for node in ast.walk(top):
        power = isinstance(node, ast.BinOp) and isinstance(node.op, ast.Pow)
        if node in named or not (power or isinstance(node, ast.Constant)):
            continue
        try:
            value = ast.literal_eval(node) if not power else eval(ast.unparse(node), {})
        except (NameError, ValueError):
            continue
        if isinstance(value, float) and 0.0 < value < 1e-3:
            yield node


def test_thresholds_stand_in_tuning_files_under_names():
    assert [n.lineno for n in small_numbers("pydy.solvers.tuning")]  # it finds them
    no_offences(
        [
            f"{module}, line {node.lineno}: {ast.unparse(node)} belongs to the room's tuning.py"
            for module in MODULES
            if not module.endswith(".tuning") and not within(module, (*DATA, *DEFAULTS))
            for node in small_numbers(module)
        ]
    )


def test_the_files_that_the_design_names_are_there():
    page = (ROOT / "docs/design.md").read_text()
    table = page[page.index("| layer, room |") : page.index("## Rules")].strip().splitlines()[2:]
    package, named, missing = SRC / "pydy", set(), []
    for row in table:
        rooms, files = (re.findall(r"`([a-z_0-9.*/]+)`", cell) for cell in row.split("|")[1:3])
        named |= {room.removesuffix(".py") for room in (*rooms, *files)}
        missing += [name for name in rooms if not any(package.glob(f"{name}*"))]
        missing += [
            name
            for name in files
            if not any(
                any(folder.glob(f"{place}{name}{end}"))
                for folder in (package, *(package / room for room in rooms))
                for place, end in (("", ""), ("", ".*"), ("*/", ".*"))
            )
        ]
    assert not missing
    layers = next(c["layers"] for c in contracts() if c["id"] == "layers")
    rooms = {room for layer in layers for room in layer.split(" : ")}
    assert len(rooms) > 30
    assert rooms - {"__main__"} <= named


def test_what_where_to_look_names_is_there():
    """A file without a folder lies in one that its row names, or directly in the package."""
    page = (ROOT / "docs/contributing/where.md").read_text(encoding="utf-8")
    rows = [row for row in page.splitlines() if row.startswith("| ") and "`" in row]
    assert len(rows) > 60
    kinds = (".py", ".c", ".h", ".js")
    sources = [p for p in (*SRC.rglob("*"), *(ROOT / "tests").glob("*")) if p.suffix in kinds]
    words = {*re.findall(r"\w+", " ".join(path.read_text(encoding="utf-8") for path in sources))}
    missing, roots = [], (ROOT, SRC / "pydy")
    for row in rows:
        names = {*re.findall(r"`([\w./]+)`", row)} - {"__init__.pyi"}
        inside = [root / name for root in roots for name in names if "/" in name]
        folders = [*roots, *(path if path.is_dir() else path.parent for path in inside)]
        for name in names:
            there = any((folder / name).exists() for folder in folders)
            is_word = not name.endswith(kinds) and {*re.split(r"[./]", name)} <= words
            if not (there or is_word):
                missing.append(name)
    assert not missing


def test_the_diagram_of_nouns_is_made_from_the_code():
    page = (ROOT / "docs/design.md").read_text()
    shown = page[page.index("## Nouns") : page.index("## Example")]
    lines = [line[4:] for line in shown.splitlines() if line.startswith("    ")]
    assert lines == nouns.diagram().splitlines(), "run tools/nouns.py"


def contracts() -> list[dict]:
    """Return the contracts of imports."""
    return tomllib.loads((ROOT / "pyproject.toml").read_text())["tool"]["importlinter"]["contracts"]


def test_scripts_of_benchmarks_are_not_named_like_helpers_of_tests_or_like_packages():
    # Some tests import the benchmarks' harness: what else lies there hides nothing.
    scripts = {p.stem for p in (ROOT / "benchmarks").glob("*.py")}
    assert not scripts & {p.stem for p in (ROOT / "tests").glob("*.py")}
    assert not scripts & {"control", *sys.stdlib_module_names}


def test_no_picture_lies_in_the_root():
    # Tests and examples draw into folders of their own.
    assert not [p.name for end in ("png", "html", "gif") for p in ROOT.glob(f"*.{end}")]
