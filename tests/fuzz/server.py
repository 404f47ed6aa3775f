"""Tries values on arguments, each in a forked process of its own; run by `test_arguments`.

What is tried may write files: it is started in a folder of its own.
Reads lines ``family part parts`` from standard input, and answers each with a line of JSON: for
every input its target, its value, what became of it, details, and seconds.

What may become of an input:

``named``     an error of ours that names the argument
``right``     accepted, with the result that the plain value gives
``cryptic``   another error
``silent``    accepted, but the value makes no sense, or the result is another
``hang``      no answer in time
``crash``     the process died
"""

from __future__ import annotations

import gc
import json
import os
import select
import signal
import sys
import tempfile
import time
import traceback
import warnings
from pathlib import Path
from typing import Any

import numpy as np

import pydy
from fuzz.kinds import RefusedError
from fuzz.table import FAMILIES, TARGETS, load, module_name
from fuzz.values import GROUPS, BoomError, PrintedError
from fuzz.world import world
from pydy.errors import IntegrationError, PyDyUserWarning, SingularMatrixError

OUR_OWN = (IntegrationError, SingularMatrixError)
SECONDS = 120.0  # the slowest call that ends takes 8 s of processor time: a loaded machine's wait
OURS = str(Path(pydy.__file__).parent) + os.sep
HERE = str(Path(__file__).parent) + os.sep


def main() -> None:
    for family in FAMILIES:
        load(family)
    world()
    gc.collect()
    gc.freeze()  # a child that collects would copy every page
    answers = os.fdopen(os.dup(1), "w")
    os.dup2(2, 1)  # what is tried may print
    for line in sys.stdin:
        family, part, parts = line.split()
        results, number = [], 0
        for target in TARGETS:
            if target.call.__module__ != module_name(family):
                continue
            chosen = []
            for name, make in values_for(target).items():
                number += 1
                if number % int(parts) == int(part):
                    chosen.append((name, make))
            results.extend((target.name, *result) for result in attempt(target, chosen))
        answers.write(json.dumps(results) + "\n")
        answers.flush()


def values_for(target: Any) -> dict[str, Any]:
    """Return the values that an argument is given: those of its groups, and its own."""
    return {
        **{n: make for group in target.kind.groups for n, make in GROUPS[group].items()},
        **target.own,
    }


def attempt(target: Any, values: list[Any]) -> list[tuple[str, str, str, float]]:
    """Try values in a child, and go on in another one where a value ends or stops it.

    Returns
    -------
    list of (value, what became of it, details, seconds)
    """
    results: list[tuple[str, str, str, float]] = []
    while len(results) < len(values):
        reader, writer = os.pipe()
        child = os.fork()
        if child == 0:
            os.close(reader)
            try:
                os.dup2(os.open(os.devnull, os.O_WRONLY), 2)
                _own_folder()
                with os.fdopen(writer, "w") as lines:
                    for name, make in values[len(results) :]:
                        start = time.monotonic()
                        try:
                            outcome = judge(target, make)
                        except BaseException:
                            outcome = ("crash", traceback.format_exc(limit=-3))
                        lines.write(json.dumps((name, *outcome, time.monotonic() - start)) + "\n")
                        lines.flush()
            finally:
                os._exit(1)
        os.close(writer)
        lines, hangs = b"", False
        while True:
            hangs = not select.select([reader], [], [], SECONDS)[0]
            piece = b"" if hangs else os.read(reader, 65_536)
            if not piece:
                break
            lines += piece
        if hangs:
            os.kill(child, signal.SIGKILL)
        os.close(reader)
        status = os.waitpid(child, 0)[1]
        results.extend(tuple(json.loads(line)) for line in lines.splitlines())
        if hangs:
            name = values[len(results)][0]
            results.append((name, "hang", f"no answer within {SECONDS:g} s", SECONDS))
        elif len(results) < len(values):
            name = values[len(results)][0]
            results.append((name, "crash", f"the process ended with status {status}", 0.0))
    return results


def _own_folder() -> None:
    """Go to a folder of this child's own, with the files that values name."""
    files = {name: Path(name).read_bytes() for name in ("damaged.nc", "empty.nc")}
    os.chdir(tempfile.mkdtemp(dir="."))
    for name, content in files.items():
        Path(name).write_bytes(content)


def judge(target: Any, make: Any) -> tuple[str, str]:
    """Hand a value to an argument; return what became of it, and the details."""
    warnings.simplefilter("error")
    warnings.simplefilter("ignore", PyDyUserWarning)
    try:
        plain, expected = target.kind.read(make()), True
    except RefusedError:
        expected = False
    want: Any = None
    if expected and target.kind.compare:
        try:
            want = target.call(plain)
        except Exception as error:  # then the value must be refused as well
            want, expected = error, False
    try:
        got = target.call(make())
    except Exception as error:
        if isinstance(want, OUR_OWN) and (type(want), str(want)) == (type(error), str(error)):
            return "right", ""  # the plain value comes to the same end
        return explain(target, error)
    if not expected:
        return "silent", f"accepted, gives {show(got)}"
    if target.kind.compare and not same(got, want):
        return "silent", f"gives {show(got)} instead of {show(want)}"
    return "right", ""


def show(value: Any) -> str:
    try:
        return repr(value)[:200]
    except Exception:
        return f"a {type(value).__name__}"


def same(a: Any, b: Any) -> bool:
    """Whether two results are alike, to the last bit."""
    if isinstance(a, np.ndarray) or isinstance(b, np.ndarray):
        a, b = np.asarray(a), np.asarray(b)
        if a.dtype.kind in "fc" and b.dtype.kind in "fc":
            return np.array_equal(a, b, equal_nan=True)
        return a.shape == b.shape and bool((a == b).all())
    if isinstance(a, (tuple, list)) and isinstance(b, (tuple, list)):
        return len(a) == len(b) and all(map(same, a, b))
    if isinstance(a, dict) and isinstance(b, dict):
        return list(a) == list(b) and all(same(a[k], b[k]) for k in a)
    if isinstance(a, float) and isinstance(b, float):
        return a == b or (a != a and b != b)
    return bool(a == b)


def explain(target: Any, error: BaseException) -> tuple[str, str]:
    """Say whether an error is one of ours that names the argument."""
    frames = [f.filename for f in traceback.extract_tb(error.__traceback__)]
    text = str(error.args[0]) if isinstance(error, KeyError) and error.args else str(error)
    notes = " ".join(getattr(error, "__notes__", ()))
    said = f"{type(error).__name__}: {text} {notes}"
    where = frames[-1]
    if isinstance(error, BoomError) and where.startswith(HERE):
        return "named", said  # a user's own exception keeps its type
    if isinstance(error, OSError) and error.filename is not None:
        return "named", said  # the path is said
    if any(m in notes for m in target.mentions):
        return "named", said  # so does any other, with a note of ours
    named = any(m in f"{text} {notes}" for m in target.mentions)
    if named and (where.startswith(OURS) or isinstance(error, PrintedError)):
        return "named", said
    depth = (
        where
        if where.startswith(OURS)
        else next(
            (f"{f} → …/{Path(where).name}" for f in reversed(frames) if f.startswith(OURS)), where
        )
    )
    return "cryptic", f"{said[:400]}  [{depth.removeprefix(OURS)}]"


if __name__ == "__main__":
    main()
