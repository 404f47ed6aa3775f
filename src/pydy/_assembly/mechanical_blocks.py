"""Blocks of a mechanical system that are formed from its equations when they are needed."""

from __future__ import annotations

from pydy._assembly.assembly import Assembly
from pydy._graph import hessian, substitute


def kinetic_hessian(assembly: Assembly) -> list[int]:
    """Return the mass matrix of all speeds before any constraint reduces it, row by row.

    It is read into the graph of the Assembly, and empty where there are no bodies.
    """
    mechanism = None if assembly.equations is None else assembly.equations.mechanism
    if mechanism is None or not mechanism.bodies:
        return []
    energy = mechanism.energy
    node = assembly.reader("the kinetic energy", [energy])(energy)
    cells = [c for row in hessian(assembly.graph, node, assembly.speeds)[1] for c in row]
    return substitute(assembly.graph, cells, assembly.given)


def constraints_with_redundant(assembly: Assembly) -> tuple[list[int], list[int]]:
    """Return the holonomic and velocity constraints, each with its redundant ones last."""
    assert assembly.equations is not None
    blocks, redundant = assembly.blocks, assembly.equations.constraints.redundant
    return (
        [*blocks.holonomic, *assembly.read(redundant.holonomic, "the holonomic constraints")],
        [*blocks.velocity, *assembly.read(redundant.velocity, "the velocity constraints")],
    )
