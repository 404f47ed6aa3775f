"""Values of a Problem and their exact derivatives, selected by the names that users pass."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from functools import partial

import numpy as np
import sympy as sm

from pydy._assembly import Assembly, CompiledModel, Definition, every_input
from pydy._checks import listed, one_or_more, real_array, shown
from pydy._evaluation.function import Evaluator
from pydy._graph import Graph, derivative_program, simplify
from pydy._judges import warn_of_missing_derivatives, warn_of_redundant
from pydy._kernel import Kernel
from pydy._mechanics import find_symbols
from pydy._problem import Problem
from pydy._program import Program
from pydy._states import GROUPS, located, members

BLOCKS = {"ode": "rates", "outputs": "outputs", "holonomic": "holonomic", "velocity": "velocity"}
"""The blocks of an Assembly that can be differentiated, by their names for users."""


@dataclass(frozen=True)
class DerivativeTarget:
    """A quantity to differentiate."""

    block: str  # of the Assembly; empty for selected outputs and expressions
    chosen: tuple[int | sm.Expr, ...]  # indices of outputs, and expressions
    names: tuple[str, ...]

    def nodes(self, assembly: Assembly) -> tuple[Graph, list[int]]:
        """Return the quantities as simplified nodes of a forked graph."""
        if self.block:
            return assembly.simplified(self.block)
        fork = assembly.fork()
        nodes = [
            fork.blocks.outputs[entry] if isinstance(entry, int) else fork.read([entry], "`of`")[0]
            for entry in self.chosen
        ]
        return fork.graph, simplify(fork.graph, nodes)


def target_of(
    definition: Definition, quantities: object, *, scalar: bool = False
) -> DerivativeTarget:
    """Return the block, outputs or expressions that a user passed as `of`; one if `scalar`."""
    if isinstance(quantities, str) and quantities in BLOCKS and not scalar:
        names = definition.row_names(BLOCKS[quantities])
        if not names:
            raise ValueError(f"`of` is {quantities!r}, but the system has nothing of this kind.")
        return DerivativeTarget(BLOCKS[quantities], (), tuple(names))
    single = isinstance(quantities, (str, sm.Basic))
    entries = [quantities] if single else listed("of", quantities)
    if not entries or (scalar and len(entries) > 1):
        count = "one output or expression" if scalar else "at least one output or expression"
        raise ValueError(f"`of` must be {count}, got {shown(quantities)}.")
    outputs, states = definition.places["outputs"], definition.places["states"]
    chosen: list[int | sm.Expr] = []
    time = definition.equations.time
    for entry in entries:
        index = outputs.get(entry, "of")
        if index is not None:
            chosen.append(index)
        elif isinstance(entry, str) and (k := states.get(entry, "of")) is not None:
            chosen.append(states.symbols[k])
        elif isinstance(entry, sm.Expr) and set(find_symbols([entry])) - {time}:
            chosen.append(entry)
        else:
            kinds = "" if scalar else f"one of {', '.join(map(repr, BLOCKS))}, or "
            raise ValueError(
                f"`of` must be {kinds}outputs of the system, by symbol or name, or expressions of "
                f"its states, specifieds and constants, got {shown(entry)}."
            )
    return DerivativeTarget("", tuple(chosen), tuple(f"the derivative of {e}" for e in entries))


def variables(definition: Definition, wrt: object) -> tuple[tuple[str, int], ...]:
    """Return the inputs that a user's `wrt` selects: a group, or single symbols."""
    if isinstance(wrt, str):
        if wrt in GROUPS:
            return every_input(GROUPS[wrt], len(definition.places[wrt]))
        kinds = ", ".join(map(repr, GROUPS))
        if all(definition.places[kind].get(wrt, "wrt") is None for kind in GROUPS):
            raise ValueError(
                f"`wrt` must be one of {kinds}, or states, constants and specifieds of the system, "
                f"got {wrt!r}."
            )
    symbols = members(definition, one_or_more("wrt", wrt))
    if not symbols:
        raise ValueError("`wrt` must name at least one state, constant or specified.")
    inputs = (located(definition, symbol, "wrt") for symbol in symbols)
    return tuple((GROUPS[kind], index) for kind, index in inputs)


def _vectors(v: object, length: int, states: object) -> tuple[np.ndarray, int, bool]:
    """Return vectors as rows of inputs, their number per sample, and whether `v` is one vector."""
    array = real_array(v, "`v`")
    is_array = states is not None and not isinstance(states, Mapping)
    table = real_array(states, "`x`") if is_array else np.zeros(0)
    is_table = table.ndim == 2
    m = len(table) if is_table else 1
    if array.shape == (length,):
        return array[None], 1, True
    if is_table and array.shape == (m, length):
        return array, 1, True
    if not is_table and array.ndim == 2 and len(array) == length and array.size:
        return array.reshape(1, -1), array.shape[1], False
    if is_table and array.ndim == 3 and array.shape[:2] == (m, length) and array.size:
        return array.reshape(m, -1), array.shape[2], False
    single_shape, multiple_shape = f"({length},)", f"({length}, d)"
    if is_table:
        single_shape, multiple_shape = f"{single_shape}, ({m}, {length})", f"({m}, {length}, d)"
    raise ValueError(
        f"`v` must have the shape {single_shape} or {multiple_shape}, for one vector or d of "
        f"them, got {array.shape}."
    )


def evaluate_block(
    problem: Problem,
    block: str,
    arguments: tuple[object, object, object, object],
    wrt: tuple[tuple[str, int], ...] | None = None,
) -> np.ndarray:
    """Evaluate a block of the equations, or its Jacobian by `wrt`, as `variables` returns it."""
    if block in ("rates", "outputs"):
        warn_of_missing_derivatives(problem)

    def kernel(model: CompiledModel) -> Kernel:
        return model.compiled(block) if wrt is None else model.compiled_jacobian(block, wrt)

    names = partial(problem.definition.row_names, block)
    blocks = block in ("constraints", "holonomic"), block in ("constraints", "velocity")
    check = None
    if wrt is None and any(blocks) and any(problem.definition.equations.constraints.redundant):
        check = partial(warn_of_redundant, blocks=blocks)
    x, t, r, p = arguments
    f = Evaluator(problem, kernel, names, wrt or (), check=check, of_constraints=any(blocks))
    return f(t, x, r, p)


def evaluate_product(
    problem: Problem,
    kind: str,
    quantities: object,
    wrt: object,
    v: object,
    arguments: tuple[object, object, object, object],
) -> np.ndarray:
    """Evaluate a product with derivatives; its kind is one of `pydy._graph.products.KINDS`."""
    definition = problem.definition
    groups = {"x": definition.states, "r": definition.specifieds, "p": definition.constants}
    target = target_of(definition, quantities, scalar=kind in ("gradient", "hessian-vector"))
    if target.block in ("", "rates", "outputs"):
        warn_of_missing_derivatives(problem)
    inputs = variables(definition, wrt)
    vectors, count, squeeze = None, 1, False
    if kind not in ("gradient", "jacobian"):
        length = len(target.names) if kind == "vector-jacobian" else len(inputs)
        vectors, count, squeeze = _vectors(v, length, arguments[0])

    def kernel(model: CompiledModel) -> Kernel:
        assembly = model.assembly

        def program() -> Program:
            graph, nodes = target.nodes(assembly)
            return derivative_program(graph, nodes, inputs, kind, assembly.sizes, count)

        return model.compiled_by(
            ("product", kind, target.block, target.chosen, inputs, count), program
        )

    def names() -> list[str]:
        if kind in ("jacobian", "jacobian-vector"):
            return [*target.names]
        slopes = [f"the derivative by {groups[group][index]}" for group, index in inputs]
        return [target.names[0], *slopes] if kind == "gradient" else slopes

    x, t, r, p = arguments
    out = Evaluator(problem, kernel, names, inputs, vectors)(t, x, r, p)
    return out[..., 0] if squeeze else out
