"""Make a `Definition` of a user's equations, outputs and specifieds; check their symbols."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
import sympy as sm
from sympy.core.function import AppliedUndef
from sympy.physics.mechanics import dynamicsymbols

from pydy._assembly import (
    Definition,
    Group,
    Outputs,
    auxiliary_groups,
    check_accelerations,
    lower_derivatives,
)
from pydy._checks import (
    SymbolIndex,
    check_mapping,
    describe,
    listed,
    merged,
    monotonic,
    real_array,
    resolved,
    shown,
    typed,
)
from pydy._errors import UnsupportedFunctionError
from pydy._mechanics import Equations, find_symbols, sort_symbols
from pydy._names import distinguished, name_of, unused_name
from pydy.codegen import checked_expression, one_format, symbolic_entries
from pydy.solvers import Event

_CANDIDATES = (sm.Basic, sm.MatrixBase, list, tuple, np.ndarray)


@dataclass(frozen=True)
class Given:
    """The symbols and expressions in a dictionary of specifieds. Nothing is checked."""

    expressions: dict[Any, Any]  # the SymPy expressions, by symbol or name
    keys: tuple[Any, ...]  # all symbols or names that have a value
    ordered: bool  # whether `keys` are the order of r: the dictionary is in the second format


def given_in(specifieds: Mapping[Any, Any]) -> Given:
    """Read the symbols of a dictionary of specifieds, in either format."""
    ordered = {"symbols", "values"} <= specifieds.keys()
    if ordered:
        specifieds, _ = one_format(specifieds, "specifieds")
    keys: list[Any] = []
    expressions: dict[Any, Any] = {}
    if len(specifieds) > 1:
        specifieds = merged(specifieds)
    for key, value in specifieds.items():
        names = key if isinstance(key, (tuple, list)) else (key,)
        keys += names
        if isinstance(value, _CANDIDATES):
            entries = zip(names, symbolic_entries(value) or (), strict=False)
            expressions.update(
                (n, e) for n, e in entries if isinstance(e, sm.Expr) and find_symbols([e])
            )
    return Given(expressions, tuple(keys), ordered)


class DefinitionBuilder:
    """Makes Definitions of the same equations with outputs and specifieds of the user."""

    def __init__(
        self, equations: Equations, constants_symbols: Any, specifieds_symbols: Any
    ) -> None:
        self._equations = equations
        self._base = base_symbols(equations, constants_symbols, specifieds_symbols)
        rows = (*equations.constraints.holonomic, *equations.constraints.nonholonomic)
        # The constraints as outputs.
        self._residuals = {sm.Dummy(f"c{k}"): row for k, row in enumerate(rows)}

    def __call__(
        self,
        outputs: Mapping[Any, Any],
        forces: Sequence[Any],
        given: Given,
        motions: Callable[[], Iterable[Any]],
    ) -> Definition:
        """Check outputs and sort symbols, including those of expressions for specifieds.

        The `forces` are the names of noncontributing forces. Further specifieds that may have a
        value are `motions`, which the equations need not hold.
        """
        equations, (constants, specifieds) = self._equations, self._base
        outputs = self.users(outputs, forces)
        own, labels = self._labelled(outputs, forces) if outputs else ({}, {})
        groups = output_groups({**own, **self._residuals})
        if forces:
            groups.append(Group(tuple(forces), equations.auxiliary.residuals))
        results = [n for group in groups for n in group.names]
        for k, name in enumerate(results):
            if name == equations.time:
                raise ValueError(
                    f"`outputs` has the name `{name}`, which is the time. Choose another name."
                )
            if name in results[:k]:
                raise ValueError(f"`outputs` gives `{labels.get(name, name)}` more than once.")
        more = sort_out(equations, [e for group in groups for e in group.expressions], results)
        integrated = auxiliary_groups(equations, groups)
        auxiliaries = tuple(
            sm.Symbol(f"∫ {name} dt")
            for group, flag in zip(groups, integrated, strict=True)
            if flag
            for name in group.names
        )
        for symbol, expression in given.expressions.items():
            try:
                found = sort_out(equations, [expression], auxiliaries)
            except (ValueError, UnsupportedFunctionError) as error:
                raise type(error)(f"`specifieds` for {symbol}: {error}") from None
            for mine, part in zip(more, found, strict=True):
                mine += part
                if held := [name for name in part if name in results]:
                    raise ValueError(
                        f"`specifieds` for {symbol} holds `{held[0]}`, the name of an output. "
                        "Outputs follow from the specifieds: write the output's expression instead."
                    )
        self._check_multipliers(more[0], constants)
        r = sort_symbols({*specifieds, *more[1]})
        return Definition(
            equations,
            Outputs(tuple(groups), tuple(self._residuals), tuple(forces), tuple(labels.items())),
            auxiliaries,
            tuple(sort_symbols({*constants, *more[0]} - {*auxiliaries})),
            _ordered(r, given, {*results}, motions),
        )

    def _labelled(
        self, outputs: Mapping[Any, Any], forces: Sequence[Any]
    ) -> tuple[dict[Any, Any], dict[Any, Any]]:
        """Return outputs whose names nothing else has, and the user's names by those labels.

        An output called like a state, constant or specified gets the label ``q_output``: within
        expressions, and for all that takes names, q is the state.
        """
        equations, (constants, specifieds) = self._equations, self._base
        known = (*equations.coordinates, *equations.speeds, *constants, *specifieds)
        taken = {name_of(s) for s in known}
        names = [n for key in outputs for n in (key if isinstance(key, (tuple, list)) else (key,))]
        valid = [n for n in dict.fromkeys(names) if _may_name_an_output(n)]
        clashing = [n for n in valid if n in known or name_of(n) in taken]
        if not clashing:
            return dict(outputs), {}
        taken |= {name_of(n) for n in (*names, *forces)}
        labels: dict[Any, Any] = {}
        for name in clashing:
            label = unused_name(f"{name_of(name)}_output", taken)
            taken.add(label)
            labels[name] = sm.Symbol(label)
        own = {
            tuple(labels.get(n, n) for n in key)
            if isinstance(key, (tuple, list))
            else labels.get(key, key): value
            for key, value in outputs.items()
        }
        return own, {label: name for name, label in labels.items()}

    def _check_multipliers(self, found: Iterable[Any], known: Iterable[Any]) -> None:
        """Refuse symbols that print like multipliers, which would be new constants, 1."""
        equations = self._equations
        if not equations.constraints.velocity or equations.multibody is None:
            return
        count = len(self._residuals) + len(equations.constraints.implied_velocity)
        names = {f"lambda{k}" for k in range(count)}
        for symbol in {*found} - {*known}:
            if name_of(symbol) in names:
                raise ValueError(
                    f"An output, specified or event holds the symbol `{symbol}`, which is not the "
                    f"multiplier of that name: write `system.constraint_forces['{symbol}']`, or "
                    "choose another name if a constant is meant."
                )

    def constants_of(self, definition: Definition, events: Any) -> list[Any]:
        """Return the symbols of events and their resets that nothing else is called."""
        events = events if isinstance(events, (list, tuple)) else [events]
        events = [event for event in events if isinstance(event, Event)]
        parts = [part for event in events for part in (event.expression, *event.reset.values())]
        outputs = definition.outputs
        symbols = (*definition.states, *definition.specifieds, *outputs.symbols)
        taken = {*map(name_of, (definition.equations.time, *symbols))}
        every = find_symbols(part for part in parts if isinstance(part, sm.Basic))
        equations = definition.equations
        unnamed = {*find_symbols(equations.auxiliary.residuals)} - {*symbols, *equations.symbols}
        for s in every:
            if s in unnamed and isinstance(s, AppliedUndef):
                raise ValueError(
                    f"`events` hold `{s}`, a noncontributing force that is not computed. Name it "
                    "in `noncontributing_forces`."
                )
            if s in outputs.symbols and s not in outputs.forces:
                raise ValueError(
                    f"`events` hold `{s}`, the name of an output. Write the output's expression "
                    "instead."
                )
        found = [s for s in every if isinstance(s, sm.Symbol) and s.name not in taken]
        self._check_multipliers(found, definition.constants)
        return found

    def users(self, outputs: Mapping[Any, Any] | None, forces: Sequence[Any]) -> dict[Any, Any]:
        """Return the user's own outputs among all."""
        named = named_outputs(check_mapping("outputs", outputs))
        mine = {*self._residuals, *([tuple(forces)] if forces else [])}
        return {key: value for key, value in named.items() if key not in mine}

    def merged(self, outputs: Mapping[Any, Any], forces: Sequence[Any]) -> dict[Any, Any]:
        """Return the user's outputs, then the residuals, then the noncontributing forces."""
        result = {**self.users(outputs, forces), **self._residuals}
        if forces:
            result[tuple(forces)] = list(self._equations.auxiliary.residuals)
        return result


def equal_names(definition: Definition) -> list[tuple[Any, ...]]:
    """Return groups of symbols that differ in their assumptions alone, time included."""
    groups: dict[tuple[object, ...], list[Any]] = {}
    orders = definition.layout
    known = (*orders.states, *orders.constants, *orders.specifieds, *orders.outputs)
    for symbol in dict.fromkeys((definition.equations.time, *known)):
        if not isinstance(symbol, sm.Dummy):
            order = getattr(symbol, "derivative_count", None)
            function = symbol if order is None else symbol.expr
            kind = function.is_Symbol, order
            groups.setdefault((name_of(function), kind), []).append(symbol)
    return [tuple(group) for group in groups.values() if len(group) > 1]


def _ordered(
    found: list[Any], given: Given, outputs: set[Any], more: Callable[[], Iterable[Any]]
) -> tuple[Any, ...]:
    """Return the specifieds in the order of r, with motions that occur by derivatives only."""
    lower = {s for d in found if isinstance(d, sm.Derivative) for s in lower_derivatives(d)}
    others = sort_symbols(lower - {*found} - outputs)
    places = SymbolIndex([*found, *others], "specifieds of the system")
    keys = [places.get(key, "specifieds") for key in given.keys]
    if None in keys and (extra := {*more()} - {*found} - outputs):
        others = sort_symbols({*others, *extra})
        places = SymbolIndex([*found, *others], "specifieds of the system")
        keys = [places.get(key, "specifieds") for key in given.keys]
    if None in keys and (higher := _higher([*found, *others]) - outputs):
        # Of a motion and its derivatives that are given together the highest may cancel.
        wider = SymbolIndex([*places.symbols, *sort_symbols(higher)], "specifieds of the system")
        keys = [wider.get(key, "specifieds") for key in given.keys]
        asked = {wider.symbols[k] for k in keys if k is not None}
        others, places = sort_symbols({*others, *(higher & asked)}), wider
    chosen = [places.symbols[k] for k in keys if k is not None]
    if given.ordered:
        return tuple(dict.fromkeys([*chosen, *found]))
    moving = {s for s in chosen if s in given.expressions or name_of(s) in given.expressions}
    motions = [
        s
        for s in others
        if s in chosen or (s.is_Derivative and not moving.isdisjoint(lower_derivatives(s)))
    ]
    return tuple(sort_symbols([*found, *motions]) if motions else found)


def _higher(symbols: Iterable[Any]) -> set[Any]:
    """Return first and second derivatives of functions of time that are not there.

    Positions, velocities and accelerations hold no others.
    """
    known, t = {*symbols}, dynamicsymbols._t
    functions = {s.expr if isinstance(s, sm.Derivative) else s for s in known}
    return {f.diff(t, k) for f in functions for k in (1, 2)} - known


# -- What users hand over, as plain data ----------------------------------------------------------


class SymbolSet(set[Any]):
    """A set of symbols that iterates and prints in sorted order."""

    def __iter__(self) -> Iterator[Any]:
        return iter(sort_symbols(set.__iter__(self)))

    def __repr__(self) -> str:
        symbols = list(self)
        return (
            "{" + ", ".join(distinguished(symbols, [str(s) for s in symbols])) + "}"
            if self
            else "set()"
        )

    __str__ = __repr__


def check_times(times: Any) -> np.ndarray:
    """Return times as a float array, shape (n,)."""
    if times is None:
        return np.empty(0)
    array = np.array(real_array(times, "`times`")) if hasattr(times, "__len__") else np.empty(())
    if array.ndim == 0:
        remedy = " Pass its attribute `times`." if hasattr(times, "times") else ""
        raise TypeError(f"`times` must be a sequence of time values, got {typed(times)}.{remedy}")
    monotonic(array, "`times`")
    return array


def check_symbols(argument: str, symbols: Any, kind: str, equations: Equations) -> list[Any]:
    """Return a user's own list of constants or specifieds, sorted."""
    given = listed(argument, symbols, hashable=True)
    unique = dict.fromkeys(
        resolved(argument, given, equations.symbols, "symbols of the equations")
        if any(isinstance(s, str) for s in given)
        else given
    )
    for symbol in unique:
        constant = isinstance(symbol, sm.Symbol)
        if symbol == equations.time:
            raise ValueError(f"`{argument}` has `{symbol}`, which is time in the equations.")
        function = isinstance(symbol, (AppliedUndef, sm.Derivative))
        if not (constant if kind == "constant" else function):
            expected = "symbols" if kind == "constant" else "functions of time"
            raise ValueError(f"`{argument}` must hold {expected}, got `{symbol}`.")
    return sort_symbols(unique)


def base_symbols(
    equations: Equations, constants: Any, specifieds: Any
) -> tuple[list[Any], list[Any]]:
    """Return the constants and specifieds of the equations, searched for where not given."""
    found: tuple[list[Any], list[Any]] = ([], [])
    if constants is None or specifieds is None:
        found = sort_out(equations)
        check_accelerations(equations, *found)
    if constants is not None:
        constants = check_symbols("constants_symbols", constants, "constant", equations)
    if specifieds is not None:
        specifieds = check_symbols("specifieds_symbols", specifieds, "specified", equations)
    return (
        found[0] if constants is None else constants,
        found[1] if specifieds is None else specifieds,
    )


def sort_out(
    equations: Equations, expressions: Iterable[Any] | None = None, known: Iterable[Any] = ()
) -> tuple[list[Any], list[Any]]:
    """Return constants and specifieds in expressions, by default the equations'."""
    t = equations.time
    states = {*equations.coordinates, *equations.speeds}
    kinematics = equations.kinematics
    skip = {*states, *kinematics.zeros, *known, t}
    skip.update((*kinematics.coordinate_rates, *kinematics.speed_rates))
    constants, specifieds = [], []
    if expressions is None:
        expressions, found = equations.expressions, equations.symbols
    else:
        expressions = list(expressions)
        found = find_symbols(expressions)
    for symbol in found:
        if symbol in skip:
            continue
        if isinstance(symbol, sm.Symbol):
            constants.append(symbol)
            continue
        function = symbol.expr if isinstance(symbol, sm.Derivative) else symbol
        if function in states or function in equations.auxiliary.speeds:
            raise _too_often(symbol, function, _term_with(symbol, expressions), equations)
        variables = symbol.variables if isinstance(symbol, sm.Derivative) else ()
        if (
            not isinstance(function, AppliedUndef)
            or function.args != (t,)
            or any(v != t for v in variables)
        ):
            other = [v for v in (*function.args, *variables) if str(v) == str(t) and v != t]
            raise UnsupportedFunctionError(
                f"The expressions hold `{symbol}`, which is not a function of time `{t}` alone. "
                + (
                    f"Its `{t}` has other assumptions than `dynamicsymbols._t`, so that SymPy "
                    "takes it for another symbol. Make functions of time with `dynamicsymbols`."
                    if other
                    else f"A delay of `{function.func}` needs its past, which no state holds: "
                    "approximate it by a state with an equation of its own "
                    "(docs/howto/inputs.md#delays)."
                    if any(function.func == state.func for state in states)
                    else "Make it a function of time and give its values as a specified, or write "
                    "it with elementary functions."
                )
            )
        specifieds.append(symbol)
    return sort_symbols(constants), sort_symbols(specifieds)


def _too_often(symbol: Any, function: Any, term: Any, equations: Equations) -> ValueError:
    """Return an error for a second derivative of a coordinate or speed, with what to write."""
    derivatives = equations.kinematics.coordinate_derivatives
    rates = dict(zip(equations.coordinates, derivatives, strict=True))
    speed: Any = rates.get(function)
    t = equations.time
    remedy = "Rewrite it in terms of the speeds and their first derivatives."
    if speed in equations.speeds and symbol == function.diff(t, 2):
        remedy = f"`{function.diff(t)}` is the speed `{speed}`: write `{speed.diff(t)}`."
    return ValueError(
        f"The term `{term}` holds the derivative `{symbol}`. Of the coordinates and speeds only "
        f"the first derivatives are available. {remedy}"
    )


def _term_with(symbol: Any, expressions: Iterable[Any]) -> Any:
    for expression in expressions:
        if symbol in find_symbols([expression]):
            for term in sm.Add.make_args(expression):
                if symbol in find_symbols([term]):
                    return term
    return symbol


def named_outputs(outputs: Mapping[Any, Any]) -> dict[Any, Any]:
    """Return an outputs dictionary with symbols in place of names."""
    result: dict[Any, Any] = {}
    for key, value in outputs.items():
        several = isinstance(key, (tuple, list))
        names = key if several else (key,)
        if any(isinstance(name, str) for name in names):
            if "" in names:
                raise ValueError("`outputs` has an empty name.")
            entries = value if isinstance(value, (tuple, list, sm.MatrixBase)) else (value,)
            own = SymbolIndex(
                list(find_symbols([e for e in entries if isinstance(e, sm.Basic)])), "symbols"
            )
            found = [own.get(n, "outputs") if isinstance(n, str) else None for n in names]
            names = tuple(
                own.symbols[k] if k is not None else sm.Symbol(n) if isinstance(n, str) else n
                for n, k in zip(names, found, strict=True)
            )
            key = names if several else names[0]
        if key in result:
            raise ValueError(f"`outputs` gives `{key}` more than once.")
        result[key] = value
    return result


def _may_name_an_output(name: Any) -> bool:
    of_time = isinstance(name, AppliedUndef) and name.args == (dynamicsymbols._t,)
    return of_time or isinstance(name, sm.Symbol)


def output_groups(outputs: Mapping[Any, Any]) -> list[Group]:
    """Return the entries of an outputs dictionary as groups of names and expressions."""
    groups = []
    for key, value in outputs.items():
        several = isinstance(key, (tuple, list))
        names = tuple(key) if several else (key,)
        for name in names:
            if not _may_name_an_output(name):
                raise ValueError(
                    f"`outputs` has the key `{key!r}`, but keys must be a symbol or a function of "
                    "time, or a tuple of them."
                )
        if isinstance(value, (tuple, list, sm.MatrixBase)):
            expressions = tuple(_expression(names, e) for e in value)
        else:
            expressions = (_expression(names, value),)
        if len(expressions) != len(names):
            raise ValueError(
                f"`outputs` for {describe(names)} must be {len(names)} expressions, one for each "
                f"name, got {len(expressions)}."
            )
        groups.append(Group(names, expressions))
    return groups


def _expression(names: Sequence[Any], value: Any) -> Any:
    return checked_expression(value, f"`outputs` for {describe(names)}")


def check_forces(equations: Equations, forces: Any) -> list[Any]:
    """Return the symbols of noncontributing forces that a user gave by themselves or by name."""
    if forces is None:
        return []
    if equations.auxiliary.unresolved_loop is not None and forces != [] and forces != ():
        raise ValueError(
            "`noncontributing_forces` cannot be computed: the velocity constraint "
            f"`{shown(equations.auxiliary.unresolved_loop)}` = 0 closes a loop, holds no auxiliary "
            "speed, and is the rate of no distance, component or angle between points and frames "
            "of the mechanism, so that the loop's share in these forces is unknown. Pass "
            "`velocity_constraints` that are made of velocities of points, such as "
            "`(Q.vel(N) - D.vel(N)).dot(N.x)`, which hold the auxiliary speeds."
        )
    several = isinstance(forces, Iterable) and not isinstance(forces, str)
    names = resolved(
        "noncontributing_forces",
        listed("noncontributing_forces", forces) if several else [forces],
        find_symbols(equations.auxiliary.residuals),
        "symbols of the auxiliary equations",
    )
    if not names:
        return names
    wanted = len(equations.auxiliary.residuals)
    if not wanted:
        raise RuntimeError(
            f"`noncontributing_forces` are {describe(names)}, but the KanesMethod has no auxiliary "
            "equations that could give them: pass `u_auxiliary` to KanesMethod."
        )
    if len(names) != wanted:
        raise ValueError(
            f"`noncontributing_forces` must have {wanted} names, one for each auxiliary speed, got "
            f"{len(names)}: {describe(names)}."
        )
    for name in names:
        if not isinstance(name, sm.Basic):
            raise TypeError(f"`noncontributing_forces` must be symbols, got {shown(name)}.")
    if len(set(names)) != len(names):
        raise ValueError(f"`noncontributing_forces` repeat a name: {describe(names)}.")
    present = find_symbols(equations.auxiliary.residuals)
    for name in names:
        if name not in present:
            raise ValueError(
                f"`noncontributing_forces` has `{name}`, which does not occur in the auxiliary "
                "equations of the KanesMethod."
            )
        if name in equations.symbols:
            raise ValueError(
                f"`noncontributing_forces` has `{name}`, which still occurs in the equations of "
                "motion: it contributes, and must be a specified."
            )
    return names


def read_term(definition: Definition, term: Any, argument: str) -> Any:
    """Return the place of an output, or an expression."""
    place = definition.places["outputs"].get(term, argument)
    if place is not None:
        return place
    if isinstance(term, str):
        k = definition.places["states"].get(term, argument)
        term = term if k is None else definition.states[k]
    if isinstance(term, (int, float)) and not isinstance(term, bool):
        term = sm.Float(term)
    scalar = isinstance(term, sm.Expr) and term.is_commutative and not term.is_Matrix
    if not scalar:
        raise ValueError(
            f"`{argument}` must be an output of the system, by symbol or name, or an expression of "
            f"its states, specifieds, constants and time, got {shown(term)}."
        )
    return term
