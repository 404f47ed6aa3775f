"""Code that the package ships as LLVM IR, compiled here for the processor at hand.

``tools/solvers_ir.py`` makes the IR from C, with a compiler that nobody needs who does not change
it. Machine code is kept with that of kernels.
"""

from __future__ import annotations

import hashlib
from collections.abc import Sequence
from functools import partial
from pathlib import Path

from pydy._backends.llvm.compiling import Source, target_lines


class Shipped:
    """The IR of a folder, read at once: the package may be replaced while this process runs."""

    def __init__(self, folder: Path) -> None:
        self._texts = {path.stem: path.read_text("utf-8") for path in folder.glob("*.ll")}

    def source(self, name: str, functions: Sequence[str] = ()) -> Source:
        """Return what a file is compiled as; its functions, by default the one of its name."""
        text = self._texts[name]
        what = f"shipped {hashlib.sha256(text.encode()).hexdigest()}"
        return Source(what, partial(_finished, text), tuple(functions) or (name,), loops=True)


CORE = Shipped(Path(__file__).parents[1] / "core")


def _finished(text: str, brief: bool) -> str:
    return target_lines() + text
