"""Write the solvers' loops as LLVM IR: ``python tools/solvers_ir.py``; ``make solvers-ir`` runs it.

Needed after a change of the C in ``src/pydy/solvers/core``, or of the tuples and numbers that its
header is written from. What it writes to ``src/pydy/solvers/ir`` is committed, and compiled for the
processor at hand by users, who need no C compiler (see `pydy.solvers.run.shipped`).

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

SOLVERS = Path(__file__).resolve().parents[1] / "src" / "pydy" / "solvers"
if str(SOLVERS.parents[1]) not in sys.path:
    sys.path.insert(0, str(SOLVERS.parents[1]))

from pydy.solvers.core.declarations import FOLDER, included, layout_header  # noqa: E402

IR = SOLVERS / "ir"
ENTRIES = sorted(path.stem for path in FOLDER.glob("*.c"))
# What entries may call: of libm, where LLVM does not write it in line.
LIBRARY = {"hypot", "sqrt"}
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


def digest(name: str) -> str:
    """Return the digest of an entry's sources, which its IR begins with."""
    text = "\n".join(included(f"{name}.c").values())
    parts = (text, layout_header(text), Path(__file__).read_text(encoding="utf-8"))
    return hashlib.sha256("\n".join(parts).encode()).hexdigest()


def recorded(name: str) -> str | None:
    """Return the digest with which the shipped IR of an entry begins."""
    path = IR / f"{name}.ll"
    if not path.exists():
        return None
    return path.read_text(encoding="utf-8").split("\n", 1)[0].removeprefix("; sources ")


def compiled(source: Path, folder: Path) -> str:
    """Return the compiler's IR of a file in C; the header is written to a folder."""
    (folder / "layout.h").write_text(layout_header(), encoding="utf-8")
    command = [sys.executable, "-m", "ziglang", "clang", *TARGET, *FLAGS, "-S", "-emit-llvm"]
    command += [f"-I{FOLDER}", f"-I{folder}", str(source), "-o", "-"]
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
        text = neutral(compiled(FOLDER / f"{name}.c", Path(folder)))
    called = set(re.findall(r"^declare [^@]*@([\w.]+)", text, flags=re.MULTILINE))
    foreign = {f for f in called if not f.startswith("llvm.")} - LIBRARY
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
        (IR / f"{name}.ll").write_text(written(name), encoding="utf-8", newline="\n")


if __name__ == "__main__":
    main()
