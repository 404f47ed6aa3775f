"""Words on the command line."""

from __future__ import annotations

import contextlib
import io
from collections.abc import Callable
from typing import Any

from fuzz.kinds import Kind, RefusedError, nothing
from fuzz.table import target
from fuzz.values import PrintedError
from pydy import cli

_ASKED = ("COMMAND", "MODEL")


def _command(*arguments: str) -> str:
    return _said(arguments)


def _said(arguments: Any) -> str:
    error, out = io.StringIO(), io.StringIO()
    with contextlib.redirect_stderr(error), contextlib.redirect_stdout(out):
        try:
            code = cli.main(arguments)
        except SystemExit as stop:
            code = stop.code
    if code:
        raise PrintedError(error.getvalue())
    return out.getvalue()


_written = (
    "", " ", "0", "-1", "1.5", "nan", "inf", "1e400", "abc", "²", "٣", "1_0", "0x10", "1,5",
    "None", "1e-320", "--", "-", "\x00", "é", "1 2", "+3", "3", "9" * 400,
)  # fmt: skip
_words: dict[str, Callable[[], Any]] = {word: (lambda word=word: word) for word in _written}


def _word(read: Callable[[str], Any]) -> Kind:
    def plain(value: Any) -> str:
        try:
            return str(read(value))
        except ValueError:
            raise RefusedError from None

    return Kind(plain, ())


def _count(least: int) -> Callable[[str], int]:
    def read(word: str) -> int:
        if not word.isdecimal() or not least <= int(word) < 1000:
            raise ValueError
        return int(word)

    return read


def _seconds(word: str) -> float:
    if not 0 < float(word) < float("inf"):
        raise ValueError
    return float(word)


for _option, _read in (("--links", _count(1)), ("--points", _count(2)), ("--duration", _seconds)):

    @target(f"cli.{_option}", _word(_read), _option, "run: `odeint`", own=_words)
    def _(v, option=_option):
        return _command("run", "pendulum", option, v)


# None stands for the words of this process.
@target("main.arguments", nothing("texts", allowed=lambda v: v is None), "`arguments", *_ASKED)
def _(v):
    return None if v is None else _said(v)


@target("cli.--masses", _word(_count(1)), "--masses", own=_words)
def _(v):
    return _command("run", "springs", "--masses", v)


@target("cli.command", _word(_count(1001)), "COMMAND", "MODEL", own=_words)
def _(v):
    return _command(v)


@target("cli.model", _word(_count(1001)), "MODEL", own=_words)
def _(v):
    return _command("run", v)
