"""Check and convert arguments: numbers, arrays, dictionaries and symbols."""

from __future__ import annotations

from collections import UserDict
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from functools import cached_property, wraps
from math import inf, isfinite
from operator import itemgetter
from typing import TYPE_CHECKING, Any, TypeVar, cast

import numpy as np

from pydy._names import distinguished, name_of, nearest, some, text_of, written_out

if TYPE_CHECKING:
    from pydy._sympy_types import AnySymbol, Expression, Matrix, SymbolOrName

K = TypeVar("K")
V = TypeVar("V")

_FLOAT = np.dtype(float)
_NUMBER_TYPES = frozenset((float, int, np.float64))
_HUGE = "a number beyond the range of floats"
_SHOWN_NUMBERS = 8  # numbers of an array that a message shows
_MOST = 2**27  # numbers of an array that may be copied although it is broadcast: a gibibyte
_MOST_DIMENSIONS = 64  # of NumPy's arrays
_INTEGER_LIMIT = 2**63  # integers of compiled code


def describe(symbols: Sequence[object]) -> str:
    """Return symbols as a list for a message, shortened when there are many."""
    return some(distinguished(symbols, [*map(text_of, symbols)])) or "none"


def listed(
    argument: str, value: object, entries_name: str = "symbols", *, hashable: bool = False
) -> list[Any]:
    """Check that an argument is a sequence of symbols and return it as a list.

    A SymPy matrix of one column or row is one, such as ``KanesMethod.q``.
    """
    if getattr(value, "is_Matrix", False) and not isinstance(value, type):
        value = _entries(value)
    if isinstance(value, np.ndarray) and value.size > _MOST:
        raise TypeError(f"`{argument}` must be a sequence of {entries_name}, got {_sized(value)}.")
    if isinstance(value, range) and is_endless(value):
        raise TypeError(f"`{argument}` must be a sequence of {entries_name}, got {value!r}.")
    if isinstance(value, Iterable) and not isinstance(value, (str, bytes, Mapping)):
        try:
            entries = list(value)
            if hashable:
                set(entries)
            return entries
        except (TypeError, RecursionError):  # an array without dimensions, or a list in it
            pass
    raise TypeError(f"`{argument}` must be a sequence of {entries_name}, got {shown(value)}.")


def _entries(matrix: Matrix) -> Matrix | list[Expression]:
    """Return the entries of a SymPy matrix of one column or row; other matrices unchanged."""
    shape = matrix.shape
    if not (all(isinstance(n, int) or n.is_Integer for n in shape) and {0, 1} & {*shape}):
        return matrix
    if not hasattr(matrix, "tolist"):  # an expression, such as a BlockMatrix
        matrix = matrix.as_explicit()
    return [entry for row in matrix.tolist() for entry in row]


def one_or_more(argument: str, value: object, *, hashable: bool = False) -> list[Any]:
    """Return one symbol, expression or name, or a sequence of them, as a list."""
    matrix = getattr(value, "is_Matrix", False)
    single = isinstance(value, str) or (hasattr(value, "free_symbols") and not matrix)
    return listed(argument, [value] if single else value, hashable=hashable)


def resolved(
    argument: str, keys: Iterable[object], symbols: Iterable[AnySymbol], description: str
) -> list[Any]:
    """Replace each name in a list by the symbol that has it."""
    keys = list(keys)
    if not any(isinstance(key, str) for key in keys):
        return keys
    index = SymbolIndex(list(symbols), description)
    return [index.symbols[index.find(k, argument)] if isinstance(k, str) else k for k in keys]


def shown(value: object) -> str:
    """Return the repr of a value for a message, on one line, shortened to 200 characters.

    Arrays with more than a few numbers, and tables, are described by their shapes.
    """
    if isinstance(value, np.ndarray) and value.size > _SHOWN_NUMBERS:
        return _shaped(value)
    try:
        with np.printoptions(
            threshold=_SHOWN_NUMBERS, edgeitems=2
        ):  # of arrays in dictionaries and lists
            text = repr(value)
        table = isinstance(getattr(value, "shape", None), tuple) and not hasattr(value, "is_Matrix")
        if "\n" in text and table:
            return _shaped(value)
        text = " ".join(line.strip() for line in text.splitlines())
    except (TypeError, ValueError):  # an integer of more than 4300 digits, NaN times a vector
        text = f"a {type(value).__name__}"
    except RecursionError:
        text = f"a {type(value).__name__} that is nested too deeply"
    return text if len(text) <= 200 else f"{text[:200]} …"


def typed(value: object) -> str:
    """Return a value with its type for a message: "the str 'q1'". The type is not repeated."""
    kind, content = type(value).__name__, shown(value)
    first = content.partition("(")[0].partition(" ")[0]
    return f"the {content}" if first == kind else f"the {kind} {content}"


def _shaped(value: Any) -> str:
    """Describe an array or a table."""
    kind = "an array" if type(value) is np.ndarray else f"a {type(value).__name__}"
    dtype = getattr(value, "dtype", _FLOAT)
    dtype_text = "" if dtype == _FLOAT else f" and the dtype {dtype}"
    return f"{kind} of the shape {tuple(value.shape)}{dtype_text}"


def check_mapping(
    argument: str, value: object, remedy: str = "", *, always: bool = False
) -> dict[Any, Any]:
    """Return a dictionary without copying it, so that its later changes are seen; None is empty.

    The `remedy` says what to do with a sequence of values, or `always`, with anything else.
    """
    if value is None:
        return {}
    if isinstance(value, dict):
        return value
    if isinstance(value, SymbolDict):
        return value.data
    if isinstance(value, Mapping):
        return dict(value)
    sequence = isinstance(value, (list, tuple, np.ndarray))
    remedy = f" {remedy}" if remedy and (sequence or always) else ""
    raise TypeError(f"`{argument}` must be a dictionary, got {type(value).__name__}.{remedy}")


def number(value: object, label: str, *, finite: bool = False) -> float:
    """Return a value as a float, or raise an error that shows it; `label` is its name there."""
    if type(value) not in _NUMBER_TYPES:
        _refuse_unreadable(value, label)
    try:
        array = np.asarray(value)
        if array.dtype == object or array.size != 1 or array.dtype.kind not in "biuf":
            result = _as_float(value)
        else:
            result = float(array.reshape(()))
    except OverflowError:
        raise ValueError(f"{label} must be a real number, got {_HUGE}.") from None
    except (TypeError, ValueError):
        raise ValueError(f"{label} must be a real number, got {shown(value)}.") from None
    if finite and not np.isfinite(result):
        raise ValueError(f"{label} must be finite, got {result!r}.")
    return result


def real_array(value: object, label: str, *, columns: bool = False) -> np.ndarray:
    """Return a value as a C-contiguous float array; text, None, masks and units are refused.

    With `columns`, an array is returned as it is if its columns are contiguous.
    """
    if type(value) is not np.ndarray:
        _refuse_unreadable(value, label)
    elif value.size > _MOST:
        check_copied(value, label)
    try:
        array = np.asarray(value)
        if array.dtype.kind == "O":
            numbers = np.array([_as_float(v) for v in array.ravel()])
            return numbers.reshape(array.shape)
    except OverflowError:
        raise ValueError(f"{label} must hold real numbers, got {_HUGE}.") from None
    except (TypeError, ValueError):
        raise ValueError(f"{label} must hold real numbers, got {shown(value)}.") from None
    if array.dtype.kind not in "biuf":
        raise ValueError(f"{label} must hold real numbers, got {shown(value)}.")
    if array.dtype == np.float64 and (
        array.flags.c_contiguous or (columns and array.flags.f_contiguous)
    ):
        return array
    return array.astype(float, order="C")


def tolerance(value: object, label: str) -> float | np.ndarray:
    """Check a tolerance: a number or an array (n,), finite and not negative."""
    if type(value) is float and 0.0 <= value < inf:  # ten times as fast
        return value
    array = real_array(value, label)
    if not (np.isfinite(array).all() and (array >= 0.0).all()):
        raise ValueError(f"{label} must be finite and not negative, got {array}.")
    if array.ndim > 1:
        raise ValueError(f"{label} must be one-dimensional, got the shape {array.shape}.")
    return array if array.ndim else float(array)


def vector(value: object, size: int, label: str) -> np.ndarray:
    """Return a value as a float array of shape (size,)."""
    array = real_array(value, label)
    if array.ndim == 0 and size == 1:
        return array.reshape(1)
    if array.shape != (size,):
        raise ValueError(f"{label} must have the shape ({size},), got {array.shape}.")
    return array


def ascending(value: object, label: str, *, strict: bool = False, remedy: str = "") -> np.ndarray:
    """Return finite ascending numbers, or raise an error that names the first one that descends."""
    array = real_array(value, label)
    if array.ndim != 1:
        raise ValueError(f"{label} must be one-dimensional, got the shape {array.shape}.")
    if not np.isfinite(array).all():
        k = int(np.isfinite(array).argmin())
        raise ValueError(f"{label} must be finite, got {array[k]} at index {k}.")
    steps = np.diff(array)
    if (wrong := steps <= 0.0 if strict else steps < 0.0).any():
        k = int(wrong.argmax())
        raise ValueError(
            f"{label} must be {'strictly ' * strict}ascending, got {array[k + 1]} after {array[k]} "
            f"at index {k + 1}.{remedy}"
        )
    return array


def checked_table(argument: str, values: object, m: int, width: int) -> np.ndarray:
    """Return a copy with one row for each time and one column for each symbol."""
    table = np.empty((m, 0)) if values is None else np.array(real_array(values, f"`{argument}`"))
    if table.shape != (m, width):
        raise ValueError(
            f"`{argument}` must have the shape ({m}, {width}), one row for each time and one "
            f"column for each symbol, got {table.shape}."
        )
    return table


def descends(times: np.ndarray) -> bool:
    """Return whether monotonic times descend."""
    return len(times) > 1 and bool(times[-1] < times[0])


def monotonic(value: object, label: str) -> np.ndarray:
    """Return finite monotonic numbers, or raise an error that names the first reversal."""
    array = real_array(value, label)
    if array.ndim != 1 or not np.isfinite(array).all():
        return ascending(array, label)  # raises
    steps = np.diff(array)
    sign = -1.0 if array.size and array[-1] < array[0] else 1.0
    if (wrong := sign * steps < 0.0).any():
        k = int(wrong.argmax())
        raise ValueError(
            f"{label} must be ascending or descending, got {array[k + 1]} after {array[k]} at "
            f"index {k + 1}{' of descending ones' if sign < 0.0 else ''}."
        )
    return array


def _as_float(value: Any) -> float:
    no_number = (str, bytes, bytearray, np.datetime64, np.timedelta64, np.complexfloating)
    if isinstance(value, no_number) or getattr(value, "dtype", _FLOAT).kind == "c":
        raise TypeError  # float() would read '1.5', and drop an imaginary part
    result = float(value)
    if np.isinf(result) and getattr(value, "is_finite", False) is True:  # SymPy's
        raise OverflowError
    return result


def check_copied(value: object, label: str) -> None:
    """Refuse values that cannot be copied: nested too deeply, or broadcast to gigabytes."""
    if isinstance(value, np.ndarray) and is_endless(value):
        raise ValueError(f"{label} must hold numbers that fit in memory, got {_sized(value)}.")
    _refuse_unreadable(value, label)


def is_endless(value: object) -> bool:
    """Return whether a value, a range or a broadcast array, has more entries than fit in memory."""
    if isinstance(value, np.ndarray):
        return value.size > _MOST and 0 in value.strides
    # len() fails beyond 2⁶³.
    return isinstance(value, range) and (value.stop - value.start) // value.step > _MOST


def _sized(array: np.ndarray) -> str:
    """Describe an array that is too large, possibly by broadcasting."""
    size = f"{array.size:,} numbers, of the shape {array.shape}"
    if 0 in array.strides:
        return f"an array that is broadcast to {size}"
    return f"an array of {size}"


def _refuse_unreadable(value: object, label: str, depth: int = 0) -> None:
    """Refuse what NumPy drops from arrays, masks and units, and what no array can hold.

    That is deep nesting, and in a list endless ranges or arrays that are broadcast to gigabytes.
    """
    kind = type(value)
    if isinstance(value, (list, tuple)):
        if depth > _MOST_DIMENSIONS:
            raise ValueError(
                f"{label} must hold real numbers, got a {kind.__name__} that is nested more than "
                f"{_MOST_DIMENSIONS} deep."
            )
        if not {*map(type, value)} <= _NUMBER_TYPES:
            for entry in value:
                if entry is not value:  # a list may be in itself
                    _refuse_unreadable(entry, label, depth + 1)
    elif depth and isinstance(value, np.ndarray) and is_endless(value):
        raise ValueError(f"{label} must hold numbers that fit in memory, got {_sized(value)}.")
    elif kind in _NUMBER_TYPES or kind is np.ndarray:
        return
    elif kind is range and is_endless(value):
        raise ValueError(f"{label} must hold numbers that fit in memory, got {value!r}.")
    elif hasattr(kind, "magnitude") or isinstance(value, np.ndarray):
        # "units" of pint, quantities and unyt, "unit" of astropy
        _refuse_units(value, getattr(value, "units", getattr(value, "unit", "")), label)
    if isinstance(value, np.ma.MaskedArray) and np.ma.getmaskarray(value).any():
        raise ValueError(
            f"{label} must not have masked entries, got {shown(value)}. Leave them out, or fill "
            "them with numbers: `array.filled(...)`."
        )


def _refuse_units(value: object, units: object, label: str) -> None:
    if str(units) not in ("", "dimensionless", "1 dimensionless"):
        raise ValueError(
            f"{label} must be without units, got {shown(value)}. Convert all quantities to one "
            "system of units, and give the numbers alone: with pint, "
            "`value.to_base_units().magnitude`."
        )


def integer(value: object, label: str, least: int = 1) -> int:
    """Return a whole number not below a minimum, or raise an error that shows the value."""
    result = np.nan if isinstance(value, (bool, np.bool_)) else number(value, label)
    if not result >= least or result != np.floor(result) or np.isinf(result):
        raise ValueError(f"{label} must be a whole number from {least} on, got {shown(value)}.")
    if result >= _INTEGER_LIMIT:
        raise ValueError(f"{label} must be a whole number below 2⁶³, got {shown(value)}.")
    return int(result)


def flag(value: object, label: str) -> bool:
    """Return True or False, also given as 0, 1 or NumPy's booleans, or raise an error."""
    if isinstance(value, (bool, np.bool_)) or (type(value) is int and value in (0, 1)):
        return bool(value)
    raise TypeError(f"{label} must be True or False, got {shown(value)}.")


def choice(value: object, options: Iterable[V], label: str) -> V:
    """Check that a value is one of some options, or raise an error that lists them."""
    options = tuple(options)
    for option in options:
        alike = isinstance(value, type(option)) and not isinstance(value, bool)
        if value is option or (alike and value == option):
            return option
    raise ValueError(f"{label} must be one of {', '.join(map(repr, options))}, got {shown(value)}.")


def text(value: object, label: str, *, empty: bool = True) -> str:
    """Return a string, which may be `empty` or not, or raise an error that shows the value."""
    if not isinstance(value, str) or not (value or empty):
        kind = "a string" if empty else "a string that is not empty"
        raise TypeError(f"{label} must be {kind}, got {shown(value)}.")
    return value


def instance(value: object, kind: type, label: str, expected: str = "") -> None:
    """Refuse a value that is not an instance of a class; errors may describe it as `expected`."""
    if not isinstance(value, kind):
        kind_of, value_text = type(value).__name__, shown(value)
        if not value_text.startswith((kind_of, "a ", "an ")):
            value_text = f"the {kind_of} {value_text}"
        raise TypeError(f"{label} must be {expected or f'a {kind.__name__}'}, got {value_text}.")


def positive(value: object, label: str, *, zero: bool = False, finite: bool = False) -> float:
    """Return a positive number, or zero where that is allowed, or raise an error."""
    result = number(value, label, finite=finite)
    if not (result > 0.0 or (zero and result == 0.0)):
        raise ValueError(f"{label} must be {'zero or ' * zero}positive, got {result!r}.")
    return result


_DEGREES = ("deg", "°", "degree", "degrees", "deg/s", "°/s", "degrees/s")


def unit_and_factor(value: object, argument: str, state: str = "") -> tuple[str, float]:
    """Return a unit and the factor to it, of a unit or a pair of both.

    Degrees of a `state`, by its name, need a factor.
    """
    if isinstance(value, tuple) and len(value) == 2:
        return text(value[0], f"`{argument}[0]`"), number(value[1], f"`{argument}[1]`")
    unit = text(value, f"`{argument}`")
    if state and unit in _DEGREES:
        raise ValueError(
            f"`{argument}` is {unit!r}, a label for values that are in radians: `{state}` is a "
            "state, and sines and cosines of states take radians. To convert, pass "
            f"`({unit!r}, 180/np.pi)`, the unit and the factor that the values are multiplied by. "
            f"If the equations are written in degrees, pass `({unit!r}, 1)`."
        )
    return unit, 1.0


def unit_of_unconverted(value: object, argument: str, state: str = "") -> str:
    """Return a unit of values that are not converted; degrees of a `state` need the factor 1."""
    unit, factor = unit_and_factor(value, argument)
    if factor != 1.0 or (state and unit in _DEGREES and isinstance(value, str)):
        radians = f" `{state}` is a state, which is in radians." if state else ""
        raise ValueError(
            f"`{argument}` is {shown(value)}, but an ensemble's values are not converted: they, "
            f"and what `reduce` makes of them, have the units of the model.{radians} Multiply the "
            f"results, and set their `attrs['units']`. If the equations are written in {unit}, "
            f"pass `({unit!r}, 1)`."
        )
    return unit


class SymbolDict(UserDict[Any, Any]):
    """A view of a user's dictionary, in which a symbol and its name are the same key.

    A merged dictionary, ``{**constants, 'l': 0.7}``, may have both: the view shows only the later
    one.
    """

    def __init__(self, data: dict[Any, Any]) -> None:
        self.data = data

    def _equivalent(self, key: object) -> list[object]:
        """Return the keys of the dictionary that are equivalent to this one, in order."""
        if key in self.data and not any(isinstance(k, str) for k in self.data):
            return [key]
        spelled = _spellings(key)
        alike = [
            k
            for k in self.data
            if k == key
            or ((isinstance(k, str) or isinstance(key, str)) and spelled & _spellings(k))
        ]
        symbols = [k for k in alike if not isinstance(k, str)]
        return alike if alike and len(symbols) < 2 else [key]

    def _current_key(self, key: object) -> object:
        """Return the latest equivalent key, whose value is valid, or this key."""
        return self._equivalent(key)[-1]

    def __iter__(self) -> Iterator[Any]:
        return iter(merged(self.data))

    def __len__(self) -> int:
        return len(merged(self.data))

    def __repr__(self) -> str:
        return repr(merged(self.data))

    def __contains__(self, key: object) -> bool:
        return self._current_key(key) in self.data

    def __getitem__(self, key: object) -> Any:
        return self.data[self._current_key(key)]

    def __setitem__(self, key: object, value: object) -> None:
        self.data[self._current_key(key)] = value

    def __delitem__(self, key: object) -> None:
        for equivalent in self._equivalent(key):  # a replaced value must not reappear
            del self.data[equivalent]

    def __ior__(self, values: Any) -> SymbolDict:
        self.update(values)
        return self

    def __or__(self, values: Any) -> SymbolDict:
        result = SymbolDict(dict(self.data))
        result.update(values)
        return result


def merged(values: Mapping[K, V]) -> Mapping[K, V]:
    """Return a dictionary in which a symbol and its name are one key: the later value is valid.

    This gives ``{**system.constants, 'l': 0.7}`` its intended meaning. Tuples of symbols, and names
    that several keys share, are not changed.
    """
    groups: dict[str, list[K]] = {}
    named = False  # a loop, because hashing and comparing keys that are functions is slow
    for key in values:
        named |= isinstance(key, str)
    if not named or len(values) < 2:
        return values
    for key in values:
        if not (isinstance(key, (tuple, list)) or hasattr(key, "dummy_index")):
            groups.setdefault(name_of(key).removesuffix("(t)"), []).append(key)
    former: set[K] = set()
    for group in groups.values():
        if len(group) > 1 and sum(not isinstance(key, str) for key in group) < 2:
            former.update(group[:-1])
    return {k: v for k, v in values.items() if k not in former} if former else values


def _spellings(key: object) -> set[str]:
    """Return the names of a key: ``q`` and ``q(t)`` for either of them; a Dummy has none."""
    if hasattr(key, "dummy_index"):
        return set()
    return {name_of(key), str(key), str(key).removesuffix("(t)")}


def refuse_twice(symbols: Iterable[object], argument: str) -> None:
    """Refuse entries, or keys of a dictionary, of which two denote the same symbol."""
    previous: set[object] = set()
    for symbol in symbols:
        if symbol in previous:
            raise ValueError(
                f"`{argument}` gives `{symbol}` more than once, by the symbol or by its name. Keep "
                "one of them."
            )
        previous.add(symbol)


class SymbolIndex:
    """Positions of symbols in an array, by symbol or unambiguous name.

    The `description` of the symbols is used in messages.
    """

    def __init__(self, symbols: Sequence[AnySymbol], description: str) -> None:
        self.symbols = tuple(symbols)
        self.description = description
        self._position = {s: k for k, s in enumerate(self.symbols)}
        # Two caches: the latest keys of a complete dictionary, with the function that reorders its
        # values; and the latest keys of a partial one, with their positions. The same keys are
        # passed repeatedly, and comparing them takes a tenth of the time of hashing.
        self._full_order: tuple[list[SymbolOrName], Callable[[list[object]], object] | None] = (
            [*self.symbols],
            None,
        )

        self._partial_order: tuple[list[SymbolOrName], np.ndarray] = (
            [],
            np.empty(0, dtype=np.int64),
        )
        self._groups: tuple[list[object], list[tuple[tuple[AnySymbol, ...], np.ndarray, bool]]] = (
            [],
            [],
        )

    def __len__(self) -> int:
        return len(self.symbols)

    @cached_property
    def _named(self) -> dict[str, list[int]]:
        named: dict[str, list[int]] = {}
        for k, symbol in enumerate(self.symbols):
            for name in {name_of(symbol), str(symbol)}:
                named.setdefault(name, []).append(k)
        return named

    def get(self, key: object, argument: str) -> int | None:
        """Return the position of a symbol or name, or None; refuse an ambiguous name."""
        try:
            position = self._position.get(key)
        # A list, an array, a memoryview, or a tuple nested too deeply
        except (TypeError, ValueError, RecursionError):
            return None
        if position is None and isinstance(key, str):
            alike = self._named.get(key, ())
            if len(alike) > 1:
                raise ValueError(
                    f"`{argument}` has the name {key!r}, which several {self.description} have: "
                    f"{', '.join(written_out(self.symbols[k]) for k in alike)}. Give the symbol "
                    "itself."
                )
            return alike[0] if alike else None
        return position

    def unknown(self, values: Mapping[SymbolOrName, object], argument: str) -> list[SymbolOrName]:
        """Return the keys of a dictionary that denote none of the symbols."""
        if [*values] in (
            self._full_order[0],
            self._partial_order[0],
        ) or values.keys() <= self._position.keys():
            return []
        # A copy: another thread may add to the dictionary.
        return [key for key in [*values] if self.get(key, argument) is None]

    def meaning(self, key: object, argument: str) -> Any:
        """Return the symbol or tuple of symbols that a key denotes; other keys unchanged."""
        if isinstance(key, (tuple, list)):
            return tuple(self.meaning(k, argument) for k in key)
        position = self.get(key, argument)
        return key if position is None else self.symbols[position]

    def find(self, key: object, argument: str) -> int:
        """Return the position of a symbol or name; errors tell apart symbols of one name."""
        position = self.get(key, argument)
        if position is None:
            label = shown(key) if isinstance(key, (tuple, list)) else text_of(key)
            raise ValueError(
                f"`{argument}` has the key `{label}`, which is not one of the {self.description}: "
                f"{describe(self.symbols)}.{self.suggestion(key)}"
            )
        return position

    def suggestion(self, key: object) -> str:
        """Return a sentence, after a space, that suggests symbols similar to a key, or ''."""
        if isinstance(key, str):
            close = nearest(key, sorted(map(name_of, self.symbols)), or_all=False)
            return f" {key!r} is a str, the name of a symbol. {close}" if close else ""
        alike = [self.symbols[k] for k in self._named.get(name_of(key), ())]
        if not alike:
            return ""
        return (
            f" Symbols of one name are different symbols where their assumptions differ: got "
            f"{written_out(key)}, known is {', '.join(map(written_out, alike))}. Use the same "
            f"symbol everywhere, or its name {name_of(key)!r}."
        )

    def columns(self, keys: Iterable[object], argument: str) -> np.ndarray:
        """Return the positions of symbols or names, which must be different."""
        positions = [self.find(key, argument) for key in keys]
        if len({*positions}) < len(positions):
            refuse_twice(map(self.symbols.__getitem__, positions), argument)
        return np.array(positions, dtype=np.int64)

    def chosen(self, keys: Iterable[object], argument: str) -> list[AnySymbol]:
        """Return the symbols that keys denote, which must be different."""
        return [self.symbols[k] for k in self.columns(keys, argument)]

    def by_symbol(
        self, values: Mapping[SymbolOrName, V], argument: str, *, allow_others: bool = False
    ) -> dict[AnySymbol, V]:
        """Return a dictionary keyed by symbols; with `allow_others`, other keys are unchanged."""
        if not allow_others:
            return dict(zip(self.chosen(values, argument), values.values(), strict=True))
        keys = [self.meaning(key, argument) for key in values]
        refuse_twice([s for k in keys for s in (k if isinstance(k, tuple) else (k,))], argument)
        return dict(zip(keys, values.values(), strict=True))

    def check_order(self, table: object, argument: str) -> None:
        """Refuse a table, which is read by position, with labels in another order."""
        if isinstance(table, (np.ndarray, list, tuple)):
            return
        if dims := getattr(table, "dims", None):  # of xarray
            labels = getattr(table, "indexes", {}).get(dims[-1], ())
        else:
            labels = getattr(table, "columns" if getattr(table, "ndim", 1) == 2 else "index", ())
        positions = [] if callable(labels) else [self.get(key, argument) for key in labels]
        valid = [position for position in positions if position is not None]
        if len(valid) < len(positions) or valid == sorted(valid):
            return
        raise ValueError(
            f"`{argument}` has the labels {describe(labels)}, and the {self.description} are in "
            f"the order {describe(self.symbols)}. A table is read by place: reorder it."
        )

    def groups(
        self, values: Mapping[SymbolOrName | tuple[SymbolOrName, ...], object], argument: str
    ) -> list[tuple[tuple[AnySymbol, ...], np.ndarray, bool]]:
        """Return (symbols, positions, whether the key is a tuple) for each key of a dictionary."""
        keys = [*values]
        stored_keys, groups = self._groups
        if keys != stored_keys:
            groups = []
            for key in keys:
                several = isinstance(key, (tuple, list))
                if several and not key:
                    raise ValueError(f"`{argument}` has an empty tuple for a key.")
                positions = np.array(
                    [self.find(k, argument) for k in (key if several else (key,))], dtype=np.int64
                )
                groups.append((tuple(self.symbols[k] for k in positions), positions, several))
            refuse_twice([symbol for symbols, _, _ in groups for symbol in symbols], argument)
            self._groups = (keys, groups)
        return groups

    def read(
        self,
        argument: str,
        values: Mapping[SymbolOrName, Any],
        base: np.ndarray | float | None = None,
    ) -> np.ndarray:
        """Return a dictionary's numbers in the symbols' order; missing ones are those of `base`."""
        keys = [*values]
        stored_keys, columns = self._partial_order
        if keys != stored_keys:
            array = self.plain_numbers(values, finite=base is not None)
            if array is not None:
                return array
            values = merged(values)
            keys = [*values]
            columns = self.columns(keys, argument)
            self._partial_order = (keys, columns)
        if base is None and len(columns) < len(self.symbols):
            present = set(columns.tolist())
            missing = [s for k, s in enumerate(self.symbols) if k not in present]
            raise ValueError(
                f"`{argument}` has no value for the {self.description} {describe(missing)}: a "
                "dictionary must give all of them."
            )
        result = np.full(len(self.symbols), 0.0 if base is None else base)
        finite = base is not None
        for key, column, value in zip(keys, columns.tolist(), values.values(), strict=True):
            # Printing a name with SymPy can take longer than an integration, so avoid it.
            usual = type(value) is float and isfinite(value)
            result[column] = (
                value if usual else number(value, f"`{argument}[{key}]`", finite=finite)
            )
        return result

    def plain_numbers(
        self, values: Mapping[SymbolOrName, Any], *, finite: bool = False
    ) -> np.ndarray | None:
        """Return the numbers if a dictionary has a Python number for every symbol, else None."""
        keys, numbers = [*values], [*values.values()]
        stored_keys, reorder = self._full_order
        if keys != stored_keys:
            try:
                columns = self.columns(keys, "")
            except ValueError:
                return None
            if len(columns) < len(self.symbols):
                return None
            reorder = None if (np.diff(columns) == 1).all() else itemgetter(*np.argsort(columns))
            self._full_order = (keys, reorder)
        if not _NUMBER_TYPES.issuperset(
            map(type, numbers)
        ):  # an array of gigabytes would be summed
            return None
        try:
            if not finite or isfinite(sum(numbers)):
                return np.array(numbers if reorder is None else reorder(numbers), dtype=float)
        except (TypeError, ValueError, OverflowError):
            pass  # `read` reports which one it is
        return None


C = TypeVar("C", bound=Callable[..., object])


def suggest_arguments(function_name: str, suggestions: Mapping[str, str]) -> Callable[[C], C]:
    """Raise a TypeError with a suggestion if an argument has another library's name."""

    def named(call: C) -> C:
        @wraps(call)
        def checked(*args: object, **options: object) -> object:
            for name in options:
                if name in suggestions:
                    raise TypeError(
                        f"{function_name} has no argument `{name}`: {suggestions[name]}."
                    )
            return call(*args, **options)

        return cast(C, checked)

    return named
