"""Bad values, and good ones in unusual clothes: what users hand to arguments by mistake.

Each is made afresh where it is used. An argument's kind says which groups it is given.
"""

from __future__ import annotations

import array
import datetime
import decimal
import fractions
import io
import pathlib
from collections.abc import Callable
from typing import Any

import numpy as np
import sympy as sm
from sympy.physics.mechanics import dynamicsymbols

__all__ = ["GROUPS", "HUGE", "BoomError", "PrintedError"]


class BoomError(Exception):
    """What callables of the user raise here."""


class PrintedError(Exception):
    """What the command line wrote to standard error before it gave up."""


def _raises(*_: Any, **__: Any) -> None:
    raise BoomError("raised by the user's function")


def _nothing(*_: Any, **__: Any) -> None:
    return None


def _closed() -> Any:
    file = io.StringIO()
    file.close()
    return file


def _itself() -> list[Any]:
    value: list[Any] = []
    value.append(value)
    return value


def _deep(wrap: Callable[[Any], Any]) -> Any:
    """Return a value that is wrapped 100,000 times: no recursion comes to its end."""
    value: Any = 1.0
    for _ in range(100_000):
        value = wrap(value)
    return value


class _Liar:
    """Says that it has a length and an array, and has neither."""

    def __len__(self) -> int:
        raise BoomError("raised by the user's object")

    def __array__(self, *_: Any, **__: Any) -> Any:
        raise BoomError("raised by the user's object")

    def __float__(self) -> float:
        raise BoomError("raised by the user's object")


class _Unspeakable:
    """Has no representation."""

    def __repr__(self) -> str:
        raise BoomError("raised by the user's object")


def _xarray() -> Any:
    import xarray

    return xarray


def _pandas() -> Any:
    import pandas

    return pandas


Makers = dict[str, Callable[[], Any]]

# What every argument gets.
COMMON: Makers = {
    "None": lambda: None,
    "True": lambda: True,
    "nan": lambda: float("nan"),
    "-1": lambda: -1,
    "10**400": lambda: 10**400,
    "''": lambda: "",
    "'abc'": lambda: "abc",
    "b'abc'": lambda: b"abc",
    "[]": lambda: [],
    "{}": lambda: {},
    "[None]": lambda: [None],
    "object()": object,
    "a class": lambda: dict,
    "lambda without arguments": lambda: lambda: 1.0,
    "generator": lambda: (k for k in range(2)),
    "other symbol": lambda: sm.Symbol("zzz"),
    "masked array": lambda: np.ma.masked_array([1.0, 2.0], [False, True]),
    "module": lambda: np,
}

NUMBERS: Makers = {
    "0": lambda: 0,
    "0.5": lambda: 0.5,
    "inf": lambda: float("inf"),
    "-inf": lambda: float("-inf"),
    "2**70": lambda: 2**70,
    "1j": lambda: 1j,
    "1+0j": lambda: 1 + 0j,
    "'1.0'": lambda: "1.0",
    "b'1'": lambda: b"1",
    "Fraction": lambda: fractions.Fraction(1, 3),
    "Decimal": lambda: decimal.Decimal("0.25"),
    "Decimal nan": lambda: decimal.Decimal("nan"),
    "Decimal huge": lambda: decimal.Decimal("1e400"),
    "float32": lambda: np.float32(0.1),
    "longdouble": lambda: np.longdouble(0.3),
    "uint8": lambda: np.uint8(3),
    "numpy bool": lambda: np.True_,
    "numpy str": lambda: np.str_("1.0"),
    "complex64": lambda: np.complex64(1),
    "datetime64": lambda: np.datetime64("2020-01-01"),
    "timedelta64": lambda: np.timedelta64(3, "s"),
    "timedelta": lambda: datetime.timedelta(seconds=1),
    "0-D array": lambda: np.array(2.0),
    "one entry": lambda: np.array([2.0]),
    "two entries": lambda: np.array([2.0, 3.0]),
    "0-D object": lambda: np.array(None, dtype=object),
    "masked": lambda: np.ma.masked,
    "one masked entry": lambda: np.ma.masked_array([1.0], [True]),
    "sympy 1/3": lambda: sm.Rational(1, 3),
    "sympy pi": lambda: sm.pi,
    "sympy I": lambda: sm.I,
    "sympy oo": lambda: sm.oo,
    "sympy nan": lambda: sm.nan,
    "sympy zoo": lambda: sm.zoo,
    "sympy huge": lambda: sm.Integer(10) ** 400,
    "sympy true": lambda: sm.true,
    "sympy relation": lambda: sm.Symbol("zzz") > 0,
    "Liar": _Liar,
    "Unspeakable": _Unspeakable,
}

ARRAYS: Makers = {
    "0.5": lambda: 0.5,
    "1-D of one": lambda: [1.0],
    "1-D of two": lambda: [0.5, 1.0],
    "1-D of three": lambda: (0.5, 1.0, 1.5),
    "integers": lambda: np.array([1, 2]),
    "booleans": lambda: np.array([True, False]),
    "2-D": lambda: [[0.5, 1.0]],
    "2-D square": lambda: [[0.5, 1.0], [1.5, 2.0]],
    "2-D column": lambda: np.array([[0.5], [1.0]]),
    "3-D": lambda: np.zeros((2, 2, 2)),
    "ragged": lambda: [[1.0], [1.0, 2.0]],
    "empty 2-D": lambda: np.empty((0, 2)),
    "complex": lambda: np.array([1j, 2.0]),
    "complex, real": lambda: np.array([1.0 + 0j, 2.0]),
    "strings": lambda: ["1.0", "2.0"],
    "numpy strings": lambda: np.array(["a", "b"]),
    "bytes": lambda: np.array([b"1", b"2"]),
    "mixed": lambda: [1.0, "2.0"],
    "objects, numbers": lambda: np.array([0.5, 1], dtype=object),
    "objects, None": lambda: np.array([0.5, None], dtype=object),
    "with nan": lambda: [0.5, np.nan],
    "with inf": lambda: [0.5, np.inf],
    "descending": lambda: [2.0, 1.0],
    "huge integers": lambda: [0, 10**400],
    "2**70": lambda: [0, 2**70],
    "datetimes": lambda: np.array(["2020-01-01", "2020-01-02"], dtype="datetime64[D]"),
    "timedeltas": lambda: np.array([1, 2], dtype="timedelta64[s]"),
    "structured": lambda: np.zeros(2, dtype=[("a", float), ("b", float)]),
    "longdouble": lambda: np.array([0.5, 1.0], dtype=np.longdouble),
    "float32": lambda: np.array([0.5, 1.0], dtype=np.float32),
    "big-endian": lambda: np.array([0.5, 1.0], dtype=">f8"),
    "strided": lambda: np.array([0.5, 9.0, 1.0, 9.0])[::2],
    "read-only": lambda: np.broadcast_to(np.array(0.5), (2,)),
    "masked, none masked": lambda: np.ma.masked_array([0.5, 1.0], [False, False]),
    "range": lambda: range(2),
    "array.array": lambda: array.array("d", [0.5, 1.0]),
    "memoryview": lambda: memoryview(np.array([0.5, 1.0])),
    "set": lambda: {0.5, 1.0},
    "dict of numbers": lambda: {0: 0.5, 1: 1.0},
    "dict values": lambda: {0: 0.5, 1: 1.0}.values(),
    "sympy Matrix": lambda: sm.Matrix([0.5, 1.0]),
    "sympy numbers": lambda: [sm.Rational(1, 2), sm.pi],
    "sympy symbols": lambda: [sm.Symbol("zzz"), 1.0],
    "DataFrame": lambda: _pandas().DataFrame({"a": [0.5, 1.0]}),
    "Series": lambda: _pandas().Series([0.5, 1.0]),
    "Series, other index": lambda: _pandas().Series([0.5, 1.0], index=[7, 3]),
    "DataArray": lambda: _xarray().DataArray([0.5, 1.0], dims="a"),
    "Dataset": lambda: _xarray().Dataset({"a": ("b", [0.5, 1.0])}),
    "list in itself": _itself,
    "Liar": _Liar,
    "[Unspeakable]": lambda: [_Unspeakable()],
}

TEXTS: Makers = {
    "'all'": lambda: "all",
    "' '": lambda: " ",
    "'é\\0'": lambda: "é\0",
    "long": lambda: "x" * 10_000,
    "numpy str": lambda: np.str_("abc"),
    "0": lambda: 0,
    "1.5": lambda: 1.5,
    "('abc',)": lambda: ("abc",),
    "['abc', 'abc']": lambda: ["abc", "abc"],
    "{'abc'}": lambda: {"abc"},
    "array of str": lambda: np.array(["abc", "def"]),
    "2-D array": lambda: np.eye(2),
    "Unspeakable": _Unspeakable,
}

FLAGS: Makers = {
    "False": lambda: False,
    "0": lambda: 0,
    "2": lambda: 2,
    "'no'": lambda: "no",
    "'False'": lambda: "False",
    "numpy bool": lambda: np.False_,
    "array": lambda: np.array([True, False]),
    "sympy false": lambda: sm.false,
    "sympy relation": lambda: sm.Symbol("zzz") > 0,
}

PATHS: Makers = {
    "a folder": lambda: pathlib.Path(),
    "a folder's name": lambda: ".",
    "no such folder": lambda: pathlib.Path("no", "such", "folder", "file.nc"),
    "a damaged file": lambda: pathlib.Path("damaged.nc"),
    "an empty file": lambda: pathlib.Path("empty.nc"),
    "'a\\0b'": lambda: "a\0b",
    "long": lambda: "x" * 5_000,
    "0": lambda: 0,
    "1.5": lambda: 1.5,
    "closed file": _closed,
    "open file": io.BytesIO,
    "['abc']": lambda: ["abc"],
    "{'abc'}": lambda: {"abc"},
}

FUNCTIONS: Makers = {
    "raises": lambda: _raises,
    "returns None": lambda: _nothing,
    "one argument": lambda: lambda a: 0.5,
    "three arguments": lambda: lambda a, b, c: 0.5,
    "returns a string": lambda: lambda *a, **k: "abc",
    "returns '1.0'": lambda: lambda *a, **k: "1.0",
    "returns nan": lambda: lambda *a, **k: float("nan"),
    "returns complex": lambda: lambda *a, **k: 1j,
    "returns a list of None": lambda: lambda *a, **k: [None, None],
    "returns too much": lambda: lambda *a, **k: np.ones(99),
    "returns 2-D": lambda: lambda *a, **k: np.ones((7, 5)),
    "returns ragged": lambda: lambda *a, **k: [[1.0], [1.0, 2.0]],
    "returns 10**400": lambda: lambda *a, **k: 10**400,
    "returns masked": lambda: lambda *a, **k: np.ma.masked_array([1.0], [True]),
    "returns itself": lambda: _returns_itself,
    "a built-in": lambda: len,
    "an exception's class": lambda: ValueError,
    "a constant function": lambda: lambda *a, **k: 0.5,
    "partial": lambda: __import__("functools").partial(_raises, 1),
}


def _returns_itself(*_: Any, **__: Any) -> Any:
    return _returns_itself


SYMBOLS: Makers = {
    "5": lambda: 5,
    "1.5": lambda: 1.5,
    "a positive symbol": lambda: sm.Symbol("m0", positive=True),
    "a time": lambda: dynamicsymbols._t,
    "Symbol('t', real)": lambda: sm.Symbol("t", real=True),
    "function of time": lambda: dynamicsymbols("zzz"),
    "its derivative": lambda: dynamicsymbols("zzz", 1),
    "function of z": lambda: sm.Function("f")(sm.Symbol("z")),
    "undefined function": lambda: sm.Function("f"),
    "sum of symbols": lambda: sm.Symbol("a") + sm.Symbol("b"),
    "Dummy": lambda: sm.Dummy("m0"),
    "relation": lambda: sm.Symbol("zzz") > 0,
    "sympy true": lambda: sm.true,
    "sympy nan": lambda: sm.nan,
    "sympy I": lambda: sm.I,
    "sympy zoo": lambda: sm.zoo,
    "sympy oo": lambda: sm.oo,
    "MatrixSymbol": lambda: sm.MatrixSymbol("A", 2, 2),
    "Matrix": lambda: sm.Matrix([[1, 2], [3, 4]]),
    "Tuple": lambda: sm.Tuple(1, 2),
    "FiniteSet": lambda: sm.FiniteSet(1, 2),
    "[5]": lambda: [5],
    "['abc']": lambda: ["abc"],
    "[symbol, symbol]": lambda: [sm.Symbol("zzz"), sm.Symbol("zzz")],
    "[[symbol]]": lambda: [[sm.Symbol("zzz")]],
    "{symbol: 1}": lambda: {sm.Symbol("zzz"): 1},
    "{'symbols': 5}": lambda: {"symbols": 5},
    "{'symbols', 'values'}": lambda: {"symbols": None, "values": None},
    "{1: 2}": lambda: {1: 2},
    "{None: None}": lambda: {None: None},
    "{(): 1}": lambda: {(): 1},
    "numpy array": lambda: np.array([1.0, 2.0]),
    "unhashable": lambda: [[]],
    "Unspeakable": _Unspeakable,
}

# What no recursion comes through, and what no memory holds.
HUGE: Makers = {
    "nested 100,000 deep": lambda: _deep(lambda value: [value]),
    "tuples nested 100,000 deep": lambda: _deep(lambda value: (value,)),
    "dictionaries nested 100,000 deep": lambda: _deep(lambda value: {"a": value}),
    "broadcast to 10**9": lambda: np.broadcast_to(1.0, (10**9,)),
    "broadcast to 10**10, 2-D": lambda: np.broadcast_to(1.0, (10**5, 10**5)),
    "objects broadcast to 10**9": lambda: np.broadcast_to(np.array(None, object), (10**9,)),
    "texts broadcast to 10**9": lambda: np.broadcast_to(np.array("a"), (10**9,)),
    "range of 10**9": lambda: range(10**9),
}

GROUPS: dict[str, Makers] = {
    "common": COMMON,
    "numbers": NUMBERS,
    "arrays": ARRAYS,
    "texts": TEXTS,
    "flags": FLAGS,
    "paths": PATHS,
    "functions": FUNCTIONS,
    "symbols": SYMBOLS,
}
