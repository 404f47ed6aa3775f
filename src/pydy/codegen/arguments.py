"""Convert users' arguments for constants and specifieds to ordered arrays."""

from __future__ import annotations

from abc import ABC, abstractmethod
from collections.abc import Callable, Container, Iterable, Iterator, Mapping, Sequence
from copy import copy
from dataclasses import dataclass, replace
from inspect import signature
from math import isfinite, prod
from numbers import Number
from types import CodeType, FunctionType
from typing import TYPE_CHECKING, Any, TypeAlias, TypeVar
from weakref import WeakSet

import numpy as np
import sympy as sm
from sympy.logic.boolalg import Boolean
from sympy.physics.mechanics import dynamicsymbols

from pydy._checks import (
    SymbolIndex,
    choice,
    describe,
    is_endless,
    listed,
    merged,
    number,
    real_array,
    shown,
    vector,
)
from pydy._errors import warn_user
from pydy._kernel import Inputs
from pydy._mechanics import find_symbols
from pydy.inputs import SampledInput

if TYPE_CHECKING:
    from pydy._sympy_types import AnySymbol

ARGUMENT_TYPES = ("array", "dictionary", "function")
_SPECIFIEDS = "specifieds of the system"
_USUAL = frozenset((float, FunctionType))
_UNCHANGING = frozenset((float, int, FunctionType, SampledInput))

# The symbols of a key of a dictionary, their positions, and whether the key is a tuple.
Group: TypeAlias = "tuple[tuple[AnySymbol, ...], np.ndarray, bool]"
# Values of specifieds as users give them, in either format.
Specifieds: TypeAlias = Mapping[Any, Any]
Part = TypeVar("Part", SampledInput, "_Checked")


class _Argument:
    """Reads an argument of generated functions; without `arg_type`, each value's type decides."""

    def __init__(self, symbol_index: SymbolIndex, arg_type: str | None) -> None:
        self.symbol_index, self.arg_type = symbol_index, arg_type

    def numeric_array(self, values: Specifieds) -> Any:
        """Convert a dictionary of numbers for all symbols to an array; return others unchanged."""
        if self.arg_type not in (None, "dictionary"):
            return values
        numbers = self.symbol_index.plain_numbers(values)
        return values if numbers is None else numbers


class ConstantsArgument(_Argument):
    """Reads the argument p: an array or a dictionary."""

    def __init__(self, symbols: Sequence[AnySymbol], arg_type: str | None = None) -> None:
        choice(arg_type, (None, "array", "dictionary"), "`constants_arg_type`")
        super().__init__(SymbolIndex(symbols, "constants of the equations"), arg_type)

    def __call__(self, p: object) -> np.ndarray:
        """Return p as an array of shape (k,)."""
        if self.arg_type == "dictionary" and not isinstance(p, Mapping):
            raise ValueError(
                f"`p` must be a dictionary, as `constants_arg_type` says, got {type(p).__name__}."
            )
        if self.arg_type == "array" or not isinstance(p, Mapping):
            return vector(p, len(self.symbol_index), "`p`, the constants,")
        return self.symbol_index.read("p", p)


class SpecifiedsArgument(_Argument):
    """Reads the argument r: an array, a function, or a dictionary of numbers and functions."""

    def __init__(
        self,
        symbols: Sequence[AnySymbol],
        arg_type: str | None = None,
        time_first: bool = False,
    ) -> None:
        choice(arg_type, (None, *ARGUMENT_TYPES), "`specifieds_arg_type`")
        super().__init__(SymbolIndex(symbols, _SPECIFIEDS), arg_type)
        self.time_first = time_first

    def __call__(self, r: object, x: np.ndarray, t: float) -> np.ndarray:
        """Return r at one state and time as an array of shape (s,)."""
        kind = self.arg_type
        symbols = self.symbol_index.symbols
        if isinstance(r, SampledInput):
            r = {symbols: r}
        if kind is None:
            kind = (
                "dictionary" if isinstance(r, Mapping) else "function" if callable(r) else "array"
            )
        if kind == "array":
            return vector(r, len(symbols), "`r`, the specifieds,")
        if kind == "function":
            if not callable(r):
                raise ValueError(
                    "`r` must be a function, as `specifieds_arg_type` says, got "
                    f"{type(r).__name__}."
                )
            return evaluate_function(r, symbols, x, t, self.time_first)
        if not isinstance(r, Mapping):
            raise ValueError(
                f"`r` must be a dictionary, as `specifieds_arg_type` says, got {type(r).__name__}."
            )
        if {*map(type, r.values())} <= _USUAL:
            try:
                groups = self.symbol_index.groups(r, "r")
            except ValueError:
                if (later := merged(r)) is r:
                    groups = _groups(self.symbol_index, r, "r")  # which raises with more words
                else:
                    return self(later, x, t)
            if sum(len(names) for names, *_ in groups) == len(symbols):
                return self._evaluated(groups, r.values(), x, t)
        plan = SpecifiedsPlan(r, self.symbol_index, time_first=self.time_first, complete=True)
        if plan.expressions:
            raise ValueError(
                f"`r` gives a SymPy expression for {describe(list(plan.expressions))}, but this "
                "function is compiled already and takes all specifieds as numbers. Set "
                "`system.specifieds` to have an expression compiled in, or give a function."
            )
        return plan.inputs(x, t)

    def _evaluated(
        self, groups: Iterable[Group], values: Iterable[Any], x: np.ndarray, t: float
    ) -> np.ndarray:
        """Return r from floats and functions; the same as a SpecifiedsPlan, at less cost."""
        result = np.empty(len(self.symbol_index))
        for (names, columns, _), value in zip(groups, values, strict=True):
            if type(value) is not float:
                value = evaluate_function(value, names, x, t, self.time_first)
            result[columns] = value
        return result


def _groups(symbol_index: SymbolIndex, values: Specifieds, argument: str) -> list[Group]:
    """Return `symbol_index.groups`; if that fails for the time, the error says to leave it out."""
    try:
        return symbol_index.groups(values, argument)
    except ValueError as error:
        time = dynamicsymbols._t
        keys = [k for key in values for k in (key if isinstance(key, (tuple, list)) else (key,))]
        time_keys = [k for k in keys if isinstance(k, (str, sm.Symbol)) and k in (time, str(time))]
        if not time_keys or symbol_index.get(time_keys[0], argument) is not None:
            raise
        raise ValueError(
            f"{error} `{time}` is the time, which is known wherever it occurs: leave it out."
        ) from None


def one_format(values: Specifieds, argument: str) -> tuple[Specifieds, bool]:
    """Return specifieds in the first format, and whether they had 'symbols' and 'values'."""
    if "symbols" not in values and "values" not in values:
        return values, False
    if set(values) != {"symbols", "values"}:
        raise ValueError(
            f"`{argument}` must have just the keys 'symbols' and 'values' in this format, got "
            f"{', '.join(map(repr, values))}."
        )
    symbols = listed(f"{argument}['symbols']", values["symbols"], "specifieds", hashable=True)
    return {tuple(symbols): values["values"]}, True


def checked_expression(value: object, label: str) -> sm.Expr | Boolean:
    """Return a number or an expression as SymPy's; refuse text, which SymPy would parse."""
    none = isinstance(value, sm.Expr) and value in (sm.oo, -sm.oo, sm.zoo, sm.nan)
    if isinstance(value, (sm.Expr, Boolean)) and not (none or getattr(value, "is_Matrix", False)):
        return value
    if none or isinstance(value, (Number, np.generic)):
        number(value, label, finite=True)
        return sm.sympify(value)
    raise ValueError(f"{label} must be SymPy expressions or numbers, got {shown(value)}.")


def symbolic_entries(value: object) -> list[object] | None:
    """Return the entries of a value when SymPy expressions are among them, else None."""
    if isinstance(value, (sm.MatrixBase, sm.Tuple, list, tuple)):
        entries = list(value)
    elif isinstance(value, np.ndarray) and value.dtype == object and not is_endless(value):
        entries = list(value.ravel())
    elif isinstance(value, sm.Basic):
        entries = [value]
    else:
        return None
    return entries if any(map(_is_symbolic, entries)) else None


def without(
    values: Mapping[AnySymbol | tuple[AnySymbol, ...], object], symbols: Container[AnySymbol]
) -> dict[AnySymbol | tuple[AnySymbol, ...], object]:
    """Return specifieds without those of some symbols; the others of a tuple retain their values.

    Values that do not fit their tuple are not changed: `SpecifiedsPlan` refuses them.
    """
    remaining: dict[AnySymbol | tuple[AnySymbol, ...], object] = {}
    for key, value in values.items():
        if not isinstance(key, tuple):
            if key not in symbols:
                remaining[key] = value
            continue
        retained = [k for k, symbol in enumerate(key) if symbol not in symbols]
        if len(retained) == len(key):
            remaining[key] = value
        elif retained:
            remaining[tuple(key[k] for k in retained)] = _part_of(value, key, retained)
    return remaining


def _part_of(value: Any, names: tuple[AnySymbol, ...], positions: list[int]) -> object:
    """Return the value of some of the specifieds that have one value together."""
    if isinstance(value, SampledInput):
        return value.of(positions) if value.size == len(names) else value
    if callable(value) and not isinstance(value, sm.Basic):
        return _Checked(value, names, False, tuple(range(len(names)))).of(positions)
    entries = symbolic_entries(value)
    if entries is None:
        if np.ndim(value) == 0:  # one number applies to each
            return value
        entries = list(np.ravel(value))
    return [entries[k] for k in positions] if len(entries) == len(names) else value


def _is_symbolic(value: object) -> bool:
    # A SymPy expression without symbols is a number: changing it needs no new code.
    if not isinstance(value, sm.Basic) or isinstance(value, sm.Number):
        return False
    return bool(find_symbols([value]))


class OfTime(ABC):
    """A function of x and t that the package provides, and that depends on the time only."""

    def __call__(self, x: np.ndarray, t: float) -> np.ndarray:
        """Return the values at a time."""
        values: np.ndarray = self.values_at(np.array([t]))[0]
        return values

    @abstractmethod
    def values_at(self, times: np.ndarray) -> np.ndarray:
        """Return the values at m times, shape (m, values)."""


@dataclass(frozen=True)
class _Checked:
    """A user's function g(x, t) for some specifieds, whose results are checked."""

    function: Callable[..., object]
    names: tuple[AnySymbol, ...]
    time_first: bool
    retained: tuple[int, ...]

    @property
    def label(self) -> str:
        """The names of the specifieds."""
        return describe(self.names)

    @property
    def identity(self) -> tuple[object, ...]:
        """The data that determine the values together with the function, except positions in r."""
        return self.time_first, self.retained

    @property
    def values_at(self) -> Callable[[np.ndarray], np.ndarray] | None:
        """A function of many times at once; None for functions of users."""
        function = self.function
        if not isinstance(function, OfTime):
            return None
        return lambda times: function.values_at(times)[:, list(self.retained)]

    def of(self, positions: Iterable[int]) -> _Checked:
        """Return the function restricted to some of its retained specifieds."""
        return replace(self, retained=tuple(self.retained[j] for j in positions))

    def __call__(self, x: np.ndarray, t: float) -> np.ndarray:
        value = evaluate_function(self.function, self.names, x, t, self.time_first)
        return value if len(self.retained) == len(self.names) else value[list(self.retained)]


class SpecifiedsPlan:
    """A dictionary of specifieds, checked once: `inputs`, which determine r, and `expressions`.

    The `inputs` are numbers, samples and functions, and need no SymPy. The `expressions` must be
    compiled into the code of a model; their entries of r are zero.

    Its `values` map a symbol or name, or a tuple of them, to a number, an array, a function, a
    SampledInput, a SymPy expression, or a sequence of numbers and expressions; or they are in the
    second format. Messages call them `argument`. If they are `complete`, as those of the second
    format are, every symbol must have a value; missing ones are zero otherwise. With `time_first`,
    functions are called as g(t, x).

    No entry of r belongs to two of samples, functions and expressions. Reading an attribute never
    calls a user's function.
    """

    def __init__(
        self,
        values: Specifieds,
        symbols: SymbolIndex | Sequence[AnySymbol],
        *,
        time_first: bool = False,
        complete: bool = False,
        argument: str = "r",
    ) -> None:
        symbol_index = (
            symbols if isinstance(symbols, SymbolIndex) else SymbolIndex(symbols, _SPECIFIEDS)
        )
        self.symbol_index = symbol_index
        self.symbols = symbol_index.symbols
        numbers = np.zeros(len(self.symbols))
        self.expressions: dict[AnySymbol, sm.Expr] = {}
        sampled: list[tuple[np.ndarray, SampledInput]] = []
        functions: list[tuple[np.ndarray, _Checked]] = []
        self._entries = [*values], [*values.values()]
        values, together = one_format(values, argument)
        if len(values) > 1 and (later := merged(values)) is not values:
            values = later
            self._entries = [*values], [*values.values()]
        groups = _groups(symbol_index, values, argument) if values else []
        self._columns = [columns for _, columns, _ in groups]
        for (names, columns, several), value in zip(groups, values.values(), strict=True):
            if type(value) is float:
                numbers[columns] = value  # the common case: no label is needed
            elif isinstance(value, SampledInput) and value.size == len(names):
                sampled.append((columns, value))
            elif callable(value) and not isinstance(value, (SampledInput, sm.Basic)):
                all_positions = tuple(range(len(names)))
                if _is_swapped(value, time_first) and value.__code__ not in _WARNED:
                    _WARNED.add(value.__code__)
                    warn_user(_swapped(value, names, time_first))
                functions.append((columns, _Checked(value, names, time_first, all_positions)))
            else:
                label = f"`{argument}['values']`" if together else f"`{argument}` for "
                label += "" if together else describe(names)
                self._take(value, names, columns, label, several, numbers)
        if argument == "specifieds" and not np.isfinite(numbers).all():
            k = int(np.flatnonzero(~np.isfinite(numbers))[0])
            raise ValueError(
                f"`specifieds` for {self.symbols[k]} must be finite, got {numbers[k]}."
            )
        # All symbols that have a value of any kind.
        self.given = frozenset(name for names, _, _ in groups for name in names)
        if (complete or together) and len(self.given) < len(self.symbols):
            missing = [s for s in self.symbols if s not in self.given]
            raise ValueError(f"`{argument}` has no value for {describe(missing)}.")
        self.inputs = Inputs(numbers, tuple(sampled), tuple(functions))

    def _take(
        self,
        value: object,
        names: Sequence[AnySymbol],
        columns: np.ndarray,
        label: str,
        several: bool,
        numbers: np.ndarray,
    ) -> None:
        """Store numbers in `numbers`, and expressions; refuse anything else with its name."""
        if isinstance(value, SampledInput):
            raise ValueError(
                f"{label} must be a SampledInput of {len(names)} values at each time, one for each "
                f"specified, got values of the shape {value.values.shape}."
            )
        _refuse_mixtures(value, label)
        entries = symbolic_entries(value)
        if entries is None:
            if not several and prod(shape := _shape(value)) > 1:
                raise ValueError(
                    f"{label} must be a real number, got an array of the shape {shape}. "
                    "For values over time pass pydy.inputs.SampledInput(times, values)."
                )
            try:  # one number applies to each of several symbols
                checked = real_array(value, label) if several else number(value, label)
            except ValueError as error:
                raise ValueError(
                    f"{error} Other than numbers, values may be functions g(x, t), SymPy "
                    "expressions and SampledInputs."
                ) from None
            is_scalar = not several or np.ndim(checked) == 0
            numbers[columns] = checked if is_scalar else vector(checked, len(names), label)
            return
        if len(entries) != len(names):
            raise ValueError(
                f"{label} must be {len(names)} expressions, one for each specified, got "
                f"{len(entries)}."
            )
        for entry, name, column in zip(entries, names, columns, strict=True):
            if not _is_symbolic(entry):
                numbers[column] = number(entry, label)
            elif isinstance(entry, sm.Expr):
                self.expressions[name] = entry
            else:
                raise ValueError(
                    f"{label} must be a real-valued expression, got the truth value `{entry}`. "
                    "Choose between two values with a Piecewise."
                )

    @property
    def changing(self) -> set[int]:
        """The indices in r that are not constant: of samples, functions and expressions."""
        of_expressions = {k for k, s in enumerate(self.symbols) if s in self.expressions}
        return self.inputs.changing | of_expressions

    def with_changed_floats(self, values: Specifieds) -> SpecifiedsPlan | None:
        """Return the plan of a dictionary that differs from this plan's in floats only, or None."""
        keys, before = self._entries
        entries, moved = [*values.values()], []
        if [*values] != keys:
            return None
        for k, (value, old) in enumerate(zip(entries, before, strict=True)):
            if value is old and _is_unchanging(value):
                continue
            if type(value) is not float or type(old) is not float or not isfinite(value):
                return None
            moved.append(k)
        result = self
        if moved:
            result = copy(self)
            numbers = self.inputs.values.copy()
            for k in moved:
                numbers[self._columns[k]] = entries[k]
            result._entries, result.inputs = (keys, entries), replace(self.inputs, values=numbers)
        return result

    def updated(self, other: SpecifiedsPlan) -> SpecifiedsPlan:
        """Return this plan, updated with the values of another one."""
        result = SpecifiedsPlan({}, self.symbol_index)
        unchanged = [s not in other.given for s in self.symbols]
        mine, other_inputs = self.inputs, other.inputs
        expressions = {s: e for s, e in self.expressions.items() if s not in other.given}
        result.expressions = {**expressions, **other.expressions}
        result.given = self.given | other.given

        def left_of(parts: Iterable[tuple[np.ndarray, Part]]) -> Iterator[tuple[np.ndarray, Part]]:
            for columns, part in parts:
                if unchanged_positions := [j for j, c in enumerate(columns) if unchanged[c]]:
                    yield columns[unchanged_positions], part.of(unchanged_positions)

        result.inputs = Inputs(
            np.where(unchanged, mine.values, other_inputs.values),
            (*left_of(mine.sampled), *other_inputs.sampled),
            (*left_of(mine.functions), *other_inputs.functions),
        )
        return result

    def with_zeros(self, columns: Sequence[int]) -> SpecifiedsPlan:
        """Return the plan with zeros for some entries of r, which a call replaces."""
        zeros = dict.fromkeys((self.symbols[k] for k in columns), 0.0)
        return self.updated(SpecifiedsPlan(zeros, self.symbol_index)) if zeros else self

    def check_times(self, t: np.ndarray, argument: str) -> None:
        """Refuse times outside the samples."""
        for columns, samples in self.inputs.sampled:
            if not samples.covers(t):
                names = describe([self.symbols[c] for c in columns])
                raise ValueError(
                    f"`{argument}` must lie within the times of the SampledInput for the "
                    f"specifieds {names}, {samples.breaks[0]} to {samples.breaks[-1]}, got "
                    f"{np.min(t)} to {np.max(t)}. Ask for times within the data, or add samples."
                )


def _is_unchanging(value: object) -> bool:
    if type(value) is tuple:
        return all(isinstance(entry, sm.Basic) for entry in value)
    return type(value) in _UNCHANGING or isinstance(value, sm.Basic)


def _shape(value: Any) -> tuple[int, ...]:
    """Return the shape of a value that any library's array protocol supports; else ()."""
    try:
        return np.shape(value) if hasattr(value, "__array__") else ()
    except Exception:  # noqa: BLE001 - an xarray.Dataset has the method, and refuses
        return ()


def _refuse_mixtures(value: object, label: str) -> None:
    """Refuse a sequence of other things than numbers, and name the remedy."""
    if not isinstance(value, (list, tuple)):
        return
    if any(callable(v) for v in value):
        raise ValueError(
            f"{label} must be numbers or expressions, one function, or one SampledInput, got a "
            f"{type(value).__name__} with functions or SampledInputs in it. Give each of them a "
            "key of its own."
        )
    if len(value) == 2 and all(hasattr(v, "__len__") for v in value):
        raise ValueError(
            f"{label} must be numbers, got a {type(value).__name__} of two sequences. Give sampled "
            "data as pydy.inputs.SampledInput(times, values)."
        )


def evaluate_function(
    function: Callable[..., object],
    symbols: Sequence[AnySymbol],
    x: np.ndarray,
    t: float,
    time_first: bool = False,
) -> np.ndarray:
    """Call a user's function for some specifieds; exceptions in it retain their type."""
    state_copy = np.array(x)  # the function may write into it
    try:
        value = function(t, state_copy) if time_first else function(state_copy, t)
    except Exception as error:
        if isinstance(error, TypeError):
            _check_arity(function, symbols, "t, x" if time_first else "x, t")
        if isinstance(error, (TypeError, IndexError)) and _is_swapped(function, time_first):
            raise TypeError(_swapped(function, symbols, time_first)) from error
        if isinstance(error, RecursionError) and _reenters(error, function):
            # A new error at each level has the traceback of one level, not of hundreds.
            raise RecursionError(
                f"The function given for the specifieds {describe(symbols)} evaluates its own "
                "System, which calls the function again. Let it evaluate a second System, without "
                "this input, or pass `r` to the call."
            ) from None
        error.add_note(
            f"This came from the function given for the specifieds {describe(symbols)}, "
            f"called as {'g(t, x)' if time_first else 'g(x, t)'} at t = {t!r}."
        )
        raise
    size = len(symbols)
    if type(value) is np.ndarray and value.dtype == np.float64 and value.shape == (size,):
        return value  # the common cases: no label is needed
    if type(value) is float and size == 1:
        return np.array([value])
    label = f"The function given for the specifieds {describe(symbols)}, called at t = {t!r},"
    array = real_array(value, label)
    if array.shape == (size,) or (size == 1 and array.shape == ()):
        return np.ascontiguousarray(array.reshape(size))
    shapes = "a float or the shape (1,)" if size == 1 else f"the shape ({size},)"
    hint = f" {_swapped(function, symbols, time_first)}" * _is_swapped(function, time_first)
    raise ValueError(f"{label} must return {shapes}, got the shape {array.shape}.{hint}")


def _reenters(error: BaseException, function: Callable[..., object]) -> bool:
    """Return whether a user's function was called again before it returned."""
    below = error.__traceback__.tb_next if error.__traceback__ else None
    while below is not None:
        frame, below = below.tb_frame, below.tb_next
        if frame.f_code is evaluate_function.__code__ and frame.f_locals["function"] is function:
            return True
    return False


def _argument_names(function: Callable[..., object]) -> tuple[str, ...]:
    """Return the names of the arguments of a function written in Python, without `self`."""
    code = getattr(function, "__code__", None)
    names = () if code is None else code.co_varnames[: code.co_argcount]
    return names[1:] if hasattr(function, "__self__") else names


_WARNED: WeakSet[CodeType] = WeakSet()  # code of functions whose users have been warned


def _is_swapped(function: Callable[..., object], time_first: bool) -> bool:
    """Return whether a function's argument names suggest the opposite order."""
    timelike = [name in ("t", "time") for name in _argument_names(function)[:2]]
    return timelike == ([False, True] if time_first else [True, False])


def _swapped(
    function: Callable[..., object], symbols: Sequence[AnySymbol], time_first: bool
) -> str:
    names = ", ".join(_argument_names(function))
    order = "g(t, x), with the time" if time_first else "g(x, t), with the state"
    return (
        f"The function given for the specifieds {describe(symbols)} has the arguments ({names}), "
        f"but it is called as {order} first."
    )


def _check_arity(
    function: Callable[..., object], symbols: Sequence[AnySymbol], arguments: str
) -> None:
    """Raise a TypeError where a user's function does not take two arguments."""
    try:
        parameters = signature(function)
    except (TypeError, ValueError):  # a function not written in Python may have none
        return
    try:
        parameters.bind(0.0, 0.0)
    except TypeError:
        raise TypeError(
            f"The function given for the specifieds {describe(symbols)} must take the state and "
            f"the time, g({arguments}), got a function of {parameters}."
        ) from None
