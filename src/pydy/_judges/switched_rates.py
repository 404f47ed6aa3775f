"""The switches of the rates, and the rates on both sides of each, as blocks to be interpreted."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

from pydy._assembly import Assembly, kinetic_hessian
from pydy._graph import Branches, inputs_of, substitute
from pydy._problem import StateSamples


def has_any(at: StateSamples, parts: Any, block: str = "switches") -> bool:
    """Return whether a block has any numbers. The answer is cached in the model."""
    cache = at.model.latest
    if parts not in cache:
        cache[parts] = bool(at.interpret(parts)[block].size)
    return bool(cache[parts])


def switched_blocks(
    assembly: Assembly,
    nodes: Sequence[int],
    searched: Sequence[int],
    inputs: str,
    other_inputs: str = "",
    bends: bool = False,
) -> tuple[list[int], dict[str, list[int]]]:
    """Return the switches in `searched` that depend on `inputs`, also as named blocks.

    They may depend on `other_inputs` in addition. With `bends`, those count too at which the nodes
    only have kinks.
    """
    graph = assembly.graph
    switches: list[int] = []
    steps: list[int] = []
    for switch in Branches(graph, searched).switches(whole=True):
        above, below = Branches(graph, nodes).sides(switch, bends)
        inputs_of_switch = inputs_of(graph, [switch]).groups
        relevant = inputs_of_switch & {*inputs} and inputs_of_switch <= {*inputs, *other_inputs}
        if above != below and relevant:
            switches.append(switch)
            steps += map(graph.sub, above, below)
    return switches, {"nodes": [*nodes] if switches else [], "switches": switches, "steps": steps}


def loads_and_rates(assembly: Assembly, coordinates: int) -> tuple[list[int], list[int]]:
    """Return the rates, with loads for u' where these suffice, and the nodes to search."""
    graph, blocks = assembly.graph, assembly.blocks
    nodes = [*blocks.rates]
    if len(blocks.forcing) != len(assembly.speeds):
        return nodes, nodes
    # The pivots by which constraints reduce the mass matrix contain switches; exclude them.
    matrix = (blocks.velocity and kinetic_hessian(assembly)) or blocks.mass_matrix
    if Branches(graph, matrix).switches(whole=True):
        return nodes, nodes
    speed_rows = slice(coordinates, coordinates + len(assembly.speeds))
    # Other rates may contain u', such as those of implicit speeds: search them with u' replaced by
    # the loads.
    pairs = zip(nodes[speed_rows], blocks.forcing, strict=True)
    loads = {u: load for u, load in pairs if graph.operands(u)}
    nodes[speed_rows] = blocks.forcing
    return nodes, substitute(graph, nodes, loads)


def inputs_of_groups(assembly: Assembly, groups: str) -> list[int]:
    sizes = dict(zip("xrp", assembly.sizes, strict=True))
    return [assembly.graph.input(group, k) for group in groups for k in range(sizes[group])]
