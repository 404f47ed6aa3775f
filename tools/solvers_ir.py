"""Write the compiled loops as LLVM IR: ``python tools/solvers_ir.py``; ``make solvers-ir`` runs it.

Needed after a change of the C in ``src/pydy/solvers/core`` or ``src/pydy/_backends/core``, or
of the tuples and numbers that their headers are written from. What it writes to ``solvers/ir`` and
beside the latter is committed, and compiled for the processor at hand by users, who need no C
compiler (see `pydy._backends.llvm.compiling`).

The compiler is pinned, and not newer than the LLVM of the oldest llvmlite that is supported, which
has to read the text. It compiles for one processor everywhere, whose name and features are then
removed; it vectorises nothing, which is left to the LLVM that knows the processor.
"""

from __future__ import annotations

import argparse
import hashlib
import re
import subprocess
import sys
from importlib.metadata import version
from pathlib import Path
from tempfile import TemporaryDirectory

SRC = Path(__file__).resolve().parents[1] / "src"
if str(SRC) not in sys.path:
    sys.path.insert(0, str(SRC))

from pydy import _array_layout  # noqa: E402
from pydy._program import tuning as program  # noqa: E402
from pydy.solvers.core import declarations  # noqa: E402

SOLVERS, GATES = SRC / "pydy/solvers/ir", SRC / "pydy/_backends/core"


def sources() -> dict[str, Path]:
    """Return the C of each entry by its name."""
    folders = declarations.FOLDER, GATES
    return {path.stem: path for folder in folders for path in sorted(folder.glob("*.c"))}


ENTRIES = [*sources()]
# What entries may call: of libm, where LLVM does not write it in line, and gates of Python.
LIBRARY = {"sqrt"}
PYTHON = {
    *("PyErr_Occurred", "PyEval_RestoreThread", "PyEval_SaveThread", "PyLong_FromLongLong"),
    *("PyObject_CallNoArgs", "Py_DecRef", "memcmp"),
}
COMPILER = "0.14.1"  # of the wheel `ziglang`: clang 19
TARGET = ("-target", "x86_64-unknown-linux-gnu")
FLAGS = (
    *("-std=c11", "-ffreestanding", "-O1"),
    # No vector is an argument in the end, and not every function of a header is used.
    *("-Wall", "-Wextra", "-Werror", "-Wno-psabi", "-Wno-unused-function"),
    # The same bits everywhere: no product is fused with a sum but by name, complex numbers are
    # multiplied as they are written, and integers may be addresses.
    *("-ffp-contract=off", "-fcx-limited-range", "-fno-math-errno", "-fno-strict-aliasing"),
    *("-fno-vectorize", "-fno-slp-vectorize", "-fno-unroll-loops", "-fno-ident"),
)
# LLVM finds out all others by itself, and their names change from version to version.
KEPT_ATTRIBUTES = {"noinline", "nounwind", "willreturn", "memory(none)", "memory(read)"}


def ir(name: str) -> Path:
    """Return where the IR of an entry lies."""
    return (SOLVERS if sources()[name].parent == declarations.FOLDER else GATES) / f"{name}.ll"


def header(source: Path, text: str | None = None) -> str:
    """Return the text of ``layout.h`` for a file, of what a text of it uses."""
    if source.parent != GATES:
        return declarations.layout_header(text)
    offsets = [name for name in _array_layout.__all__ if name.isupper()]
    found = {name: getattr(_array_layout, name) for name in offsets}
    found |= {name: getattr(program, name) for name in ("SINGULAR", "INDEPENDENT", "REDUNDANT")}
    return "".join(
        f"#define {name} {float(x).hex() if isinstance(x, float) else x}\n"
        for name, x in found.items()
    )


def digest(name: str) -> str:
    """Return the digest of an entry's sources, which its IR begins with."""
    source = sources()[name]
    text = "\n".join(declarations.included(source.name, folder=source.parent).values())
    parts = (text, header(source, text), Path(__file__).read_text(encoding="utf-8"))
    return hashlib.sha256("\n".join(parts).encode()).hexdigest()


def recorded(name: str) -> str | None:
    """Return the digest with which the shipped IR of an entry begins."""
    path = ir(name)
    if not path.exists():
        return None
    return path.read_text(encoding="utf-8").split("\n", 1)[0].removeprefix("; sources ")


def compiled(source: Path, folder: Path) -> str:
    """Return the compiler's IR of a file in C; the header is written to a folder."""
    (folder / "layout.h").write_text(header(source), encoding="utf-8")
    command = [sys.executable, "-m", "ziglang", "clang", *TARGET, *FLAGS, "-S", "-emit-llvm"]
    command += [f"-I{declarations.FOLDER}", f"-I{folder}", str(source), "-o", "-"]
    done = subprocess.run(command, capture_output=True, text=True, check=False)
    if done.returncode:
        sys.exit(done.stderr)
    return done.stdout


def _attributes(match: re.Match[str]) -> str:
    words = re.findall(r"[\w-]+(?:\([^)]*\))?", match[2])
    kept = [word for word in words if word in KEPT_ATTRIBUTES]
    return f"{match[1]} = {{ {' '.join(kept or ['nounwind'])} }}"


def neutral(text: str) -> str:
    """Return IR without its target, its origin, and what only one version of LLVM knows."""
    dropped = (
        r"^(; ModuleID|; Function Attrs|source_filename|target |!llvm\.|.* @llvm\.lifetime\.).*\n"
    )
    text = re.sub(dropped, "", text, flags=re.MULTILINE)
    text = re.sub(r"^(attributes #\d+) = \{ (.*) \}$", _attributes, text, flags=re.MULTILINE)
    text = re.sub(r" (nocapture|local_unnamed_addr|dso_local)\b", "", text)
    return text.strip() + "\n"


def written(name: str) -> str:
    """Return the IR that is shipped for an entry."""
    if version("ziglang") != COMPILER:
        sys.exit(f"needs ziglang {COMPILER}, got {version('ziglang')}")
    with TemporaryDirectory() as folder:
        text = neutral(compiled(sources()[name], Path(folder)))
    called = set(re.findall(r"^declare [^@]*@([\w.]+)", text, flags=re.MULTILINE))
    known = LIBRARY if ir(name).parent == SOLVERS else PYTHON
    foreign = {f for f in called if not f.startswith("llvm.")} - known
    if foreign:
        sys.exit(f"{name} would need {sorted(foreign)}, which users have not got.")
    head = f"; sources {digest(name)}\n; Made by tools/solvers_ir.py with ziglang {COMPILER}.\n\n"
    return head + text


def main() -> None:
    """Write the entries that are named, or those whose sources have changed."""
    parser = argparse.ArgumentParser(description=__doc__.split("\n", 1)[0])
    parser.add_argument("entries", nargs="*", choices=[*ENTRIES, []], help="default: stale ones")
    names = parser.parse_args().entries or [n for n in ENTRIES if recorded(n) != digest(n)]
    for name in names:
        ir(name).write_text(written(name), encoding="utf-8", newline="\n")


if __name__ == "__main__":
    main()
