"""Write the compiled loops of the solvers as LLVM IR: ``python tools/solvers_ir.py``.

Needed after a change of the modules that numba compiles (`sources`); ``make solvers-ir`` runs it.
What it writes to ``src/pydy/solvers/ir`` is committed, and compiled for the processor at hand by
users, who need no numba (see `pydy.solvers.run.shipped`).

The IR is for no processor in particular: numba leaves it unoptimised, and the passes here only
remove what numba's way of working leaves behind, so that less is shipped and compiled. The same
sources and versions give the same text.
"""

from __future__ import annotations

import argparse
import ast
import hashlib
import os
import re
import sys
from collections import Counter
from concurrent.futures import ProcessPoolExecutor
from importlib import import_module
from multiprocessing import get_context
from pathlib import Path
from typing import Any

SRC = Path(__file__).resolve().parents[1] / "src"
IR = SRC / "pydy" / "solvers" / "ir"
ENTRIES = {
    "advance": "loop.explicit",
    "advance_implicit": "loop.implicit",
    "step_lanes": "lanes.stepper",
    "evaluate_lanes": "lanes.kernels",
    "project": "loop.projection",
    "project_columns": "loop.projection",
    "scan_events": "loop.event_detection",
    "extend": "loop.extension",
    "step_back": "adjoint.stepper",
}
# What entries may call: of libm, where LLVM does not write it in line; nothing of Python or numba.
LIBRARY = {"hypot", "sqrt"}
CLEANING = ("sroa", "simplify_cfg", "instruction_combine", "new_gvn", "simplify_cfg", "sroa")
PASSES = (
    *("always_inliner", *CLEANING, "instruction_combine", "dead_arg_elimination"),
    *("global_opt", "aggressive_dce", "simplify_cfg"),
    *("merge_functions", "global_dead_code_eliminate", "strip_dead_prototype"),
)
# Functions of so many instructions become parts of their callers, and longer ones of an only one.
SHORT = 40
# How an exception begins, which numba keeps as a pickle.
PICKLE = re.compile(r'c"\\80\\0\d\\95')
# LLVM finds out all others by itself, and their names change from version to version.
KEPT_ATTRIBUTES = {"noinline", "nounwind", "willreturn", "memory(none)", "memory(read)"}


# -- what the IR is made from ---------------------------------------------------------------------


def _path(module: str) -> Path | None:
    path = SRC / (module.replace(".", "/") + ".py")
    return path if path.exists() else None


def sources(name: str) -> list[Path]:
    """Return the files that an entry's code depends on: its module and what that imports."""
    found, left = {Path(__file__).resolve()}, [_path(f"pydy.solvers.{ENTRIES[name]}")]
    while left:
        path = left.pop()
        if path is None or path in found:
            continue
        found.add(path)
        nodes = ast.walk(ast.parse(path.read_text(encoding="utf-8")))
        names = [str(node.module) for node in nodes if isinstance(node, ast.ImportFrom)]
        left += [_path(module) for module in names if module.startswith("pydy.")]
    return sorted(found)


def digest(name: str) -> str:
    """Return the digest of an entry's sources, which its IR begins with."""
    sha = hashlib.sha256()
    for path in sources(name):
        sha.update(path.relative_to(SRC.parent).as_posix().encode())
        sha.update(path.read_bytes().replace(b"\r\n", b"\n"))
    return sha.hexdigest()


def recorded(name: str) -> str | None:
    """Return the digest with which the shipped IR of an entry begins."""
    path = IR / f"{name}.ll"
    if not path.exists():
        return None
    return path.read_text(encoding="utf-8").split("\n", 1)[0].removeprefix("; sources ")


# -- numba's part ---------------------------------------------------------------------------------


def unoptimised(name: str) -> tuple[str, str, str]:
    """Return numba's IR of an entry, the name of its function there, and its signature."""
    # numba reads these when it is first imported.
    os.environ.update(
        NUMBA_OPT="0", NUMBA_CPU_NAME="generic", NUMBA_CPU_FEATURES="", NUMBA_LOOP_VECTORIZE="0"
    )
    from numba.core import compiler, registry, sigutils
    from numba.core.compiler_lock import global_compiler_lock
    from numba.core.dispatcher import _FunctionCompiler

    from pydy.solvers.loop.compiled import OPTIONS

    class Plain(_FunctionCompiler):  # type: ignore[misc]
        """Compiles a function without a way in from Python."""

        def _customize_flags(self, flags: Any) -> Any:
            flags.no_cpython_wrapper = flags.no_cfunc_wrapper = True
            flags.enable_pyobject = False
            return flags

    entry = getattr(import_module(f"pydy.solvers.{ENTRIES[name]}"), name)
    arguments, result = sigutils.normalize_signature(entry.signature)
    plain = Plain(entry.function, registry.cpu_target, dict(OPTIONS), {}, compiler.Compiler)
    with global_compiler_lock:
        done = plain.compile(arguments, result)
    kinds = re.findall(r"int64|float64", entry.signature)[1:]
    parameters = ["i64" if kind == "int64" else "double" for kind in kinds]
    return done.library.get_llvm_str(), done.fndesc.llvm_func_name, ", ".join(parameters)


def _plain(name: str, inner: str, parameters: str) -> str:
    """Return the function of C's calling convention around numba's.

    No exception is raised in there: `written` looks at it.
    """
    kinds = parameters.split(", ")
    declared = ", ".join(f"{kind} %a{k}" for k, kind in enumerate(kinds))
    return f"""
define i64 @"{name}"({declared}) nounwind {{
  %result = alloca i64
  %raised = alloca ptr
  store i64 0, ptr %result
  call i32 @"{inner}"(ptr %result, ptr %raised, {declared})
  %value = load i64, ptr %result
  ret i64 %value
}}
declare i32 @"{inner}"(ptr, ptr, {parameters})
"""


# -- LLVM's part ----------------------------------------------------------------------------------


def _short(name: str) -> str:
    """Return a function's own name of what numba made of it: ``_ZN`` and parts with lengths."""
    own, rest = name, name.removeprefix("_ZN")
    while rest != name and (digits := re.match(r"\d+", rest)):
        end = digits.end() + int(digits[0])
        own, rest = rest[digits.end() : end], rest[end:]
    return own


def _unique(names: list[str]) -> list[str]:
    return [n if names.index(n) == k else f"{n}.{k}" for k, n in enumerate(names)]


def reduced(name: str, text: str, inner: str, parameters: str) -> str:
    """Return a module with one function to be called from outside, without what nobody needs."""
    from llvmlite import binding

    from pydy.solvers.loop.compiled import APART

    binding.initialize_native_target()
    module = binding.parse_assembly(text)
    module.link_in(binding.parse_assembly(_plain(name, inner, parameters)))
    for function in module.functions:
        if not function.is_declaration and function.name != name:
            function.linkage = "internal"
            if _short(function.name) in APART:
                function.add_function_attribute("noinline")
        if function.name == inner:
            function.add_function_attribute("alwaysinline")
    for variable in module.global_variables:
        if not variable.is_declaration:
            variable.linkage = "internal"
    machine = binding.Target.from_default_triple().create_target_machine(cpu="generic", features="")
    builder = binding.create_pass_builder(machine, binding.create_pipeline_tuning_options(0))

    def run(*passes: str) -> None:
        manager = binding.create_new_module_pass_manager()
        for step in passes:
            getattr(manager, f"add_{step}_pass")()
        manager.run(module, builder)

    run(*PASSES)
    calls = Counter(re.findall(r'call [^@\n]*@"?([\w.$]+)', str(module)))
    for function in module.functions:
        size = sum(1 for block in function.blocks for _ in block.instructions)
        ours = size and function.name != name and b"noinline" not in b" ".join(function.attributes)
        if ours and (size <= SHORT or calls[function.name] == 1):
            function.add_function_attribute("alwaysinline")
    run(*PASSES)
    functions = list(module.functions)
    names = _unique([_short(function.name) for function in functions])
    run("strip_symbols")  # of values above all
    for function, short in zip(functions, names, strict=True):
        function.name = short
    module.verify()
    return str(module)


def _attributes(match: re.Match[str]) -> str:
    words = re.findall(r"[\w-]+(?:\([^)]*\))?", match[2])
    return f"{match[1]} = {{ {' '.join(word for word in words if word in KEPT_ATTRIBUTES)} }}"


def neutral(text: str) -> str:
    """Return IR without its target, its origin, and what only one version of LLVM knows."""
    dropped = r"^(; ModuleID|; Function Attrs|source_filename|target |.* @llvm\.lifetime\.).*\n"
    text = re.sub(dropped, "", text, flags=re.MULTILINE)
    text = re.sub(r"^(attributes #\d+) = \{ (.*) \}$", _attributes, text, flags=re.MULTILINE)
    text = re.sub(r" captures\(none\)", "", text)
    # Names of scopes, which are numba's for functions with the types of all their arguments.
    text = re.sub(r'(!\d+ = distinct !\{!\d+(?:, !\d+)?), !"[^"]*"\}', r"\1}", text)
    return text.strip() + "\n"


def written(name: str) -> str:
    """Return the IR that is shipped for an entry."""
    import llvmlite
    import numba

    text = neutral(reduced(name, *unoptimised(name)))
    called = set(re.findall(r'^declare [^@]*@"?([\w.$]+)', text, flags=re.MULTILINE))
    foreign = {f for f in called if not f.startswith("llvm.")} - LIBRARY
    if foreign:
        sys.exit(f"{name} would need {sorted(foreign)}, which users have not got.")
    if PICKLE.search(text):
        sys.exit(f"{name} would raise exceptions, which C has not got.")
    versions = f"numba {numba.__version__}, llvmlite {llvmlite.__version__}"
    head = f"; sources {digest(name)}\n; Made by tools/solvers_ir.py with {versions}.\n\n"
    return head + text


def _write(name: str) -> None:
    sys.path.insert(0, str(SRC))
    (IR / f"{name}.ll").write_text(written(name), encoding="utf-8", newline="\n")


def main() -> None:
    """Write the entries that are named, or those whose sources have changed."""
    parser = argparse.ArgumentParser(description=__doc__.split("\n", 1)[0])
    parser.add_argument("entries", nargs="*", choices=[*ENTRIES, []], help="default: stale ones")
    names = parser.parse_args().entries or [n for n in ENTRIES if recorded(n) != digest(n)]
    IR.mkdir(exist_ok=True)
    # Each in a process of its own: what numba compiled before decides on names.
    with ProcessPoolExecutor(2, get_context("spawn"), max_tasks_per_child=1) as pool:
        list(pool.map(_write, names))


if __name__ == "__main__":
    main()
