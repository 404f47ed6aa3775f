"""Runs the cells of a notebook in the browser's Python, and sends the page what they show."""

from __future__ import annotations

import ast
import io
import json
import linecache
import os
import sys
import traceback
import warnings
from importlib import import_module
from rlcompleter import Completer
from typing import Any

NAMES = sys.modules["__main__"].__dict__
FORMATS = {"html": "text/html", "latex": "text/latex", "svg": "image/svg+xml"}
_cells = 0


def prepare() -> None:
    """Import what cells will, while the notebook is drawn and read."""
    for name in ("sympy.physics.mechanics", "pydy.system"):
        import_module(name)
    os.chdir(os.environ["HOME"])
    # `plt.show()` may be left out here, and does no harm.
    warnings.filterwarnings("ignore", "FigureCanvasAgg is non-interactive")


def run(code: str) -> None:
    """Run a cell; what its last expression gives is shown, or where it failed."""
    global _cells
    _cells += 1
    name = f"<cell {_cells}>"
    linecache.cache[name] = (len(code), None, code.splitlines(keepends=True), name)
    try:
        tree = ast.parse(code, name)
        last = tree.body.pop() if tree.body and isinstance(tree.body[-1], ast.Expr) else None
        exec(compile(tree, name, "exec"), NAMES)
        if last is not None:
            show(eval(compile(ast.Expression(last.value), name, "eval"), NAMES))
        show_figures()
    except BaseException as error:  # noqa: BLE001 - whatever a cell raises is shown, `exit()` too
        trace = error.__traceback__
        while trace and trace.tb_frame.f_code.co_filename == __file__:
            trace = trace.tb_next
        lines = "".join(traceback.format_exception(error.with_traceback(trace))).splitlines()
        send(error={"ename": type(error).__name__, "evalue": str(error), "traceback": lines})
    send(answer=True)


def complete(code: str) -> None:
    """Send what the end of some code may go on as, and how long that end is."""
    begin = len(code)
    while begin and (code[begin - 1].isidentifier() or code[begin - 1] in "._0123456789"):
        begin -= 1
    completer, word, found = Completer(NAMES), code[begin:], []
    while word and (match := completer.complete(word, len(found))) is not None:
        found.append(match.rstrip("()"))
    send(answer=[found, len(word)])


def send(**message: Any) -> None:
    """Send a message to the page, after what was printed before."""
    sys.stdout.flush()
    sys.stderr.flush()
    with open("/show", "w", encoding="utf-8") as page:
        page.write(json.dumps(message) + "\n")


def show(value: Any) -> None:
    """Show a value as notebooks do, in each format that it knows."""
    if value is None:
        return
    NAMES["_"] = value
    found = {"text/plain": repr(value)}
    for name, kind in FORMATS.items():
        method = getattr(value, f"_repr_{name}_", None)
        written = method() if callable(method) and not isinstance(value, type) else None
        if written:
            found[kind] = written
    send(result=found)


def show_figures() -> None:
    """Show Matplotlib's figures, and close them."""
    plt = sys.modules.get("matplotlib.pyplot")
    for number in plt.get_fignums() if plt else ():
        figure, text = plt.figure(number), io.StringIO()
        plt.close(figure)
        figure.savefig(text, format="svg")
        send(show={"image/svg+xml": text.getvalue()})
