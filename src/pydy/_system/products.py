"""Derivatives of chosen quantities of a System, and their products with vectors."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

import numpy as np
import sympy as sm

from pydy._assembly.assembly import Assembly
from pydy._assembly.definition import Definition
from pydy._assembly.model import CompiledModel
from pydy._checks import Places, listed, real_array, shown
from pydy._graph.derivative import Guards
from pydy._graph.node import Graph
from pydy._graph.products import derivative_program
from pydy._graph.program import Program
from pydy._graph.simplify import simplify
from pydy._kernel import Kernel
from pydy._mechanics.symbols import find_symbols
from pydy._system.analysis import variables
from pydy._system.evaluation import row_names

__all__ = ["BLOCKS", "Derivative", "Target", "prepare_product", "target_of"]

BLOCKS = {"ode": "rates", "outputs": "outputs", "holonomic": "holonomic", "velocity": "velocity"}
"""What the user calls the blocks of an Assembly that can be differentiated."""


@dataclass(frozen=True)
class Target:
    """What is differentiated.

    Attributes
    ----------
    block : str
        Of the Assembly; empty for a choice of outputs and expressions.
    chosen : tuple
        Places of outputs, and expressions.
    names : tuple of str
    """

    block: str
    chosen: tuple[Any, ...]
    names: tuple[str, ...]

    def nodes(self, assembly: Assembly) -> tuple[Graph, list[int]]:
        """Return the quantities as simplified nodes of a graph that grows on its own."""
        if self.block:
            return assembly.simplified(self.block)
        own = assembly.fork()
        nodes = [
            own.outputs[one] if isinstance(one, int) else own.read([one], "`of`")[0]
            for one in self.chosen
        ]
        return own.graph, simplify(own.graph, nodes, assembly.passes)


def target_of(definition: Definition, of: Any, *, scalar: bool = False) -> Target:
    """Return what a user's `of` means: a block, or outputs and expressions.

    Raises
    ------
    ValueError
        It is not one of these, or several where one is needed.
    """
    if isinstance(of, str) and of in BLOCKS and not scalar:
        names = row_names(definition, BLOCKS[of])
        if not names:
            raise ValueError(f"`of` is {of!r}, but the system has nothing of this kind.")
        return Target(BLOCKS[of], (), tuple(names))
    single = isinstance(of, (str, sm.Basic))
    entries = [of] if single else listed("of", of)
    if not entries or (scalar and len(entries) > 1):
        count = "one output or expression" if scalar else "at least one output or expression"
        raise ValueError(f"`of` must be {count}, got {shown(of)}.")
    outputs = Places(definition.outputs_symbols, "outputs of the system")
    states = definition.places["states"]
    chosen: list[Any] = []
    time = definition.equations.time
    for entry in entries:
        place = outputs.get(entry, "of")
        if place is not None:
            chosen.append(place)
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
    return Target("", tuple(chosen), tuple(f"the derivative of {e}" for e in entries))


@dataclass(frozen=True, eq=False)
class Derivative:
    """A product to evaluate.

    Attributes
    ----------
    kernel : callable
        Returns the Kernel for a model.
    vectors : ndarray or None
        Inputs at the end of r, shape (1, k) for all samples or (m, k).
    names : list of str
        Of the rows of the result.
    squeeze : bool
        Whether there is one vector, and no axis for it.
    perturbed : bool
        Whether specifieds are differentiated by.
    """

    kernel: Callable[[CompiledModel], Kernel]
    vectors: np.ndarray | None
    names: list[str]
    squeeze: bool
    perturbed: bool


def prepare_product(
    definition: Definition, kind: str, of: Any, wrt: Any, v: Any, states: Any
) -> Derivative:
    """Return what `System`'s methods of this kind evaluate.

    Parameters
    ----------
    definition : Definition
    kind : str
        One of `pydy._graph.products.KINDS`.
    of, wrt, v : object
        As the user gave them.
    states : array_like or None
        As given: whether it is one state or several decides what the axes of `v` mean.
    """
    scalar = kind in ("gradient", "hessian-vector")
    target = target_of(definition, of, scalar=scalar)
    by = variables(definition, wrt)
    if isinstance(by, str):
        group = {"x": definition.states, "r": definition.specifieds, "p": definition.constants}[by]
        by = tuple((by, k) for k in range(len(group)))
    by_row = kind in ("jacobian", "jacobian-vector")
    names = (
        list(target.names) if by_row else [f"the derivative by {s}" for s in _named(definition, by)]
    )
    vectors, count, squeeze = None, 1, False
    if kind == "gradient":
        names = [target.names[0], *names]
    elif kind != "jacobian":
        length = len(target.names) if kind == "vector-jacobian" else len(by)
        vectors, count, squeeze = _vectors(v, length, states)

    def build(made: CompiledModel) -> Kernel:
        assembly = made.assembly
        key = ("product", kind, target.block, target.chosen, by, count)

        def program(guards: Guards) -> Program:
            graph, nodes = target.nodes(assembly)
            return derivative_program(
                graph, nodes, by, kind, assembly.sizes, assembly.passes, count, guards=guards
            )

        return made.compiled_derivative(key, program)

    perturbed = any(group == "r" for group, _ in by)
    return Derivative(build, vectors, names, squeeze, perturbed)


def _vectors(v: Any, length: int, states: Any) -> tuple[np.ndarray, int, bool]:
    """Return vectors as rows of inputs, how many there are a sample, and whether `v` is one."""
    array = real_array(v, "`v`")
    many = states is not None and np.ndim(states) == 2
    m = len(states) if many else 1
    if array.shape == (length,):
        return array[None], 1, True
    if many and array.shape == (m, length):
        return array, 1, True
    if not many and array.ndim == 2 and len(array) == length and array.size:
        return array.reshape(1, -1), array.shape[1], False
    if many and array.ndim == 3 and array.shape[:2] == (m, length) and array.size:
        return array.reshape(m, -1), array.shape[2], False
    one, more = f"({length},)", f"({length}, d)"
    if many:
        one, more = f"{one}, ({m}, {length})", f"({m}, {length}, d)"
    raise ValueError(
        f"`v` must have the shape {one} or {more}, for one vector or d of them, got {array.shape}."
    )


def _named(definition: Definition, by: tuple[tuple[str, int], ...]) -> list[Any]:
    groups = {"x": definition.states, "r": definition.specifieds, "p": definition.constants}
    return [groups[group][place] for group, place in by]
