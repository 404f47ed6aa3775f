"""Specifieds that are given as SymPy expressions: their nodes take the place of the inputs."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any, Protocol

import sympy as sm

from pydy._assembly.assembly import Assembly
from pydy._assembly.definition import Definition
from pydy._assembly.model import CompiledModel
from pydy._checks import describe
from pydy._graph import Graph, SymPyReader, jacobian, substitute
from pydy._mechanics import find_symbols


class Plan(Protocol):
    """How specifieds are given, as far as it matters here."""

    symbols: tuple[Any, ...]  # all specifieds
    given: frozenset[Any]  # those that have a value of any kind
    expressions: dict[Any, Any]


@dataclass(frozen=True)
class _SpecifiedExpression:
    """A specified given as an expression."""

    symbol: Any
    source: Any
    order: int = 0  # how often `source` is differentiated; an expression never is


def with_compiled_inputs(
    model: CompiledModel,
    definition: Definition,
    plan: Plan,
    *,
    perturbed: bool = False,
) -> CompiledModel:
    """Return the model with the expressions of `plan` compiled into it.

    If `perturbed`, each expression becomes expression + its entry of r, which is zero: derivatives
    by r are then those by a small change of each specified's value.
    """
    if not plan.expressions:
        return model
    formulas = _formulas(definition, plan)

    def change(assembly: Assembly) -> Assembly:
        kinematics = assembly.blocks.rates[: len(definition.equations.coordinates)]
        return assembly.substituted(
            _resolve(assembly.graph, definition, formulas, kinematics, perturbed)
        )

    return model.variant((formulas, perturbed), change)


def followed(definition: Definition, plan: Plan) -> set[Any]:
    """Return the specifieds that expressions give, and derivatives that follow from them."""
    return {formula.symbol for formula in _formulas(definition, plan)}


def differentiated(
    assembly: Assembly, definition: Definition, plan: Plan
) -> dict[int, tuple[Any, list[int]]]:
    """Return the nodes of `assembly` that are differentiated by time.

    Each has the specified whose expression it is, or is a derivative of, and the places in r of the
    derivatives beyond it.
    """
    formulas, graph = _formulas(definition, plan), assembly.graph
    kinematics = assembly.blocks.rates[: len(definition.equations.coordinates)]
    given = _resolve(graph, definition, formulas, kinematics, False)
    found: dict[int, tuple[Any, list[int]]] = {}
    places = {symbol: k for k, symbol in enumerate(definition.layout.specifieds)}
    for f in (f for f in formulas if f.order):
        node = given[graph.input("r", places[f.source])]
        for _ in range(f.order):
            found.setdefault(node, (f.source, []))[1].append(places[f.symbol])
            node = jacobian(graph, [node], [graph.input("t", 0)])[0].get(0, graph.zero)
    return found


def check_expressions(definition: Definition, plan: Plan) -> None:
    """Raise the errors of `with_compiled_inputs` without building equations."""
    formulas = _formulas(definition, plan)
    if formulas:
        _resolve(Graph(), definition, formulas, None, False)


def _formulas(definition: Definition, plan: Plan) -> tuple[_SpecifiedExpression, ...]:
    """Return the expressions, and the derivatives that follow from them."""
    if not plan.expressions:
        return ()
    formulas = []
    for symbol in plan.symbols:
        if symbol in plan.expressions:
            formulas.append(_SpecifiedExpression(symbol, plan.expressions[symbol]))
        elif isinstance(symbol, sm.Derivative) and symbol not in plan.given:
            for order in range(1, symbol.derivative_count + 1):
                lower = symbol.derivative_count - order
                source = symbol.expr.diff(definition.equations.time, lower)
                if source in plan.expressions:
                    formulas.append(_SpecifiedExpression(symbol, source, order))
                if source in plan.given:
                    break
    return tuple(formulas)


def _resolve(
    graph: Graph,
    definition: Definition,
    formulas: Sequence[_SpecifiedExpression],
    kinematics: Sequence[int] | None,
    perturbed: bool,
) -> dict[int, int]:
    """Return the node that replaces each specified's input node."""
    layout, equations = definition.layout, definition.equations
    read = SymPyReader.of_inputs(
        graph,
        "the expressions",
        p=layout.constants,
        t=[equations.time],
        r=layout.specifieds,
        x=layout.states,
    )
    inputs = {s: read.atoms[s] for s in layout.specifieds}
    read.atoms.update((z, graph.zero) for z in equations.kinematics.zeros)
    for formula in formulas:
        if not formula.order:
            found = find_symbols([formula.source])
            has_rates = any(s in found for s in equations.kinematics.coordinate_rates)
            if kinematics is None and has_rates:
                kinematics = read.all(equations.kinematics.coordinate_derivatives)
            _refuse_unknown(formula, found, definition)
    for rate, node in zip(equations.kinematics.coordinate_rates, kinematics or (), strict=False):
        read.define(rate, node)
    own = {inputs[f.symbol]: f for f in formulas}
    nodes: dict[Any, int] = {}
    needs: dict[Any, set[Any]] = {}
    for f in formulas:
        if f.order:
            needs[f.symbol] = {f.source}
            continue
        read.what = f"`specifieds` for {f.symbol}"
        nodes[f.symbol] = read(f.source)
        needs[f.symbol] = {own[n].symbol for n in graph.reachable([nodes[f.symbol]]) if n in own}
    result: dict[int, int] = {}
    waiting = list(formulas)
    while waiting:
        left = {f.symbol for f in waiting}
        ready = [f for f in waiting if not needs[f.symbol] & left]
        if not ready:
            _refuse_circle(waiting[0].symbol, needs, left)
        for f in ready:
            place = inputs[f.symbol]
            if f.order:
                node = _derivative(graph, f, result[inputs[f.source]], own, definition)
            else:
                node = substitute(graph, [nodes[f.symbol]], result)[0]
            result[place] = graph.add(node, place) if perturbed else node
            waiting.remove(f)
    return result


def _derivative(
    graph: Graph,
    formula: _SpecifiedExpression,
    node: int,
    own: Mapping[int, Any],
    definition: Definition,
) -> int:
    """Differentiate by time an expression of time and constants."""
    layout = definition.layout
    names = {"x": layout.states, "r": layout.specifieds}
    held = [
        names[graph.args[n][0]][graph.args[n][1]]
        for n in graph.reachable([node])
        if graph.ops[n] == "input" and graph.args[n][0] in names and n not in own
    ]
    if held:
        raise ValueError(
            f"`specifieds` has no value for `{formula.symbol}`, and it does not follow from the "
            f"expression for `{formula.source}`, which depends on {describe(held)}: only "
            "expressions of time and constants are differentiated. Give "
            f"`{formula.symbol}` a value too."
        )
    for _ in range(formula.order):
        node = jacobian(graph, [node], [graph.input("t", 0)])[0].get(0, graph.zero)
    return node


def _refuse_unknown(
    formula: _SpecifiedExpression, found: Mapping[Any, Any], definition: Definition
) -> None:
    layout, equations = definition.layout, definition.equations
    known = {*layout.states, *layout.specifieds, *layout.constants, *equations.kinematics.zeros}
    known.update((equations.time, *equations.kinematics.coordinate_rates))
    for symbol in found:
        if symbol in equations.kinematics.speed_rates:
            raise ValueError(
                f"`specifieds` for {formula.symbol} holds `{symbol}`, for which the equations are "
                "solved. Write loads that depend on accelerations into the loads of the "
                "KanesMethod."
            )
        if symbol not in known:
            raise ValueError(
                f"`specifieds` for {formula.symbol} holds `{symbol}`, which is not one of the "
                "system's states, specifieds, constants or time. In `system.specifieds`, rather "
                "than in `r`, it would become a constant or specified of the system."
            )


def _refuse_circle(start: Any, needs: Mapping[Any, set[Any]], waiting: set[Any]) -> None:
    path = [start]
    while path.count(path[-1]) == 1:
        path.append(min(needs[path[-1]] & waiting, key=sm.default_sort_key))
    circle = path[path.index(path[-1]) :]
    raise ValueError(
        f"Circular definition in `specifieds`: {' needs '.join(map(str, circle))}. Replace one of "
        "them with a number or a function."
    )
