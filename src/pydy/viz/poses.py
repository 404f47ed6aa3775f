"""Where everything is: the poses of all visuals from one compiled Program.

The position of each point and the orientation of each frame become nodes of one graph, in which a
frame's orientation is built on that of the frame before it: a chain of n links costs n products of
matrices, not n². The Program's outputs for all frames of an animation come from one sweep.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from itertools import pairwise
from typing import Any

import numpy as np
import sympy as sm
from sympy.core.function import AppliedUndef
from sympy.physics.mechanics import dynamicsymbols

from pydy._backends.registry import compile_program
from pydy._graph.collector import collector_paused
from pydy._graph.from_sympy import SymPyReader
from pydy._graph.lower import lower
from pydy._graph.node import Graph
from pydy._graph.program import Program
from pydy._graph.simplify import simplify
from pydy._graph.symbols import input_nodes
from pydy._mechanics.symbols import find_symbols
from pydy._names import name_of

__all__ = ["Geometry", "Names", "Placement", "place", "pose_program"]

Matrix3 = list[list[int]]
Vector3 = list[int]


@dataclass(frozen=True)
class Names:
    """The symbols whose values a trajectory supplies.

    Attributes
    ----------
    states, specifieds, constants : tuple of symbols
        In the order of the arrays x, r and p.
    definitions : mapping of symbols to expressions
        What else may occur: derivatives of the coordinates, auxiliary speeds.
    time : Symbol
    """

    states: tuple[Any, ...]
    specifieds: tuple[Any, ...] = ()
    constants: tuple[Any, ...] = ()
    definitions: Mapping[Any, Any] = field(default_factory=dict)
    time: Any = dynamicsymbols._t


@dataclass(frozen=True)
class Geometry:
    """What is to be computed: distinct frames and points, arrows' vectors, expressions.

    Attributes
    ----------
    reference, origin : ReferenceFrame, Point
        What the scene is seen from.
    frames, points : tuple of ReferenceFrame, of Point
    vectors : tuple of Vector
    series : tuple of (label, expression)
    """

    reference: Any
    origin: Any
    frames: tuple[Any, ...]
    points: tuple[Any, ...]
    vectors: tuple[Any, ...] = ()
    series: tuple[tuple[str, Any], ...] = ()


@dataclass(frozen=True)
class Placement:
    """The numbers for a Geometry at m instants, all in the reference frame.

    Attributes
    ----------
    rotations : dict of ReferenceFrame to ndarray, shape (m, 3, 3)
        The columns are the frame's unit vectors.
    positions : dict of Point to ndarray, shape (m, 3)
    vectors : ndarray, shape (m, k, 3)
    series : dict of str to ndarray, shape (m,)
    """

    rotations: dict[Any, np.ndarray]
    positions: dict[Any, np.ndarray]
    vectors: np.ndarray
    series: dict[str, np.ndarray]


def pose_program(geometry: Geometry, names: Names) -> Program:
    """Return the Program of everything in a Geometry.

    Its blocks are 'rotations', 'positions', 'vectors' and 'series', in the order of the Geometry.

    Raises
    ------
    ValueError
        A frame or a point is not related to the scene's, or a symbol has no value; the message
        names it and says what to do.
    """
    return _Poses(geometry, names).program()


def place(geometry: Geometry, names: Names) -> Callable[..., Placement]:
    """Return ``evaluate(t, x, r, p) -> Placement``, compiled."""
    program = pose_program(geometry, names)
    kernel = compile_program(program, "llvm", {})

    def evaluate(t: np.ndarray, x: np.ndarray, r: np.ndarray, p: np.ndarray) -> Placement:
        out, _ = kernel.evaluate(t, x, r, p)
        blocks = program.by_block(out)
        rotations, positions = blocks["rotations"], blocks["positions"]
        return Placement(
            {f: rotations[:, k] for k, f in enumerate(geometry.frames)},
            {p: positions[:, k] for k, p in enumerate(geometry.points)},
            blocks["vectors"],
            {label: blocks["series"][:, k] for k, (label, _) in enumerate(geometry.series)},
        )

    return evaluate


class _Poses:
    """Builds the graph of a Geometry."""

    def __init__(self, geometry: Geometry, names: Names) -> None:
        self.geometry = geometry
        self.names = names
        self.graph = graph = Graph()
        atoms = input_nodes(
            graph, p=names.constants, r=names.specifieds, x=names.states, t=[names.time]
        )
        # A trajectory from a file has names in the place of symbols.
        self.by_name = {s: node for s, node in atoms.items() if isinstance(s, str)}
        self.read = SymPyReader(graph, atoms, "the scene")
        one, zero = graph.one, graph.zero
        self.rotations: dict[Any, Matrix3] = {
            geometry.reference: [[one, zero, zero], [zero, one, zero], [zero, zero, one]]
        }

    @collector_paused()
    def program(self) -> Program:
        geometry, graph, names = self.geometry, self.graph, self.names
        rotations = [c for f in geometry.frames for row in self.rotation(f) for c in row]
        positions = [c for p in geometry.points for c in self.position(p)]
        vectors = [c for v in geometry.vectors for c in self.components(v, f"the arrow `{v}`")]
        series = [self.nodes([e], f"the series `{label}`")[0] for label, e in geometry.series]
        parts = [rotations, positions, vectors, series]
        shapes = [
            (len(geometry.frames), 3, 3),
            (len(geometry.points), 3),
            (len(geometry.vectors), 3),
            (len(geometry.series),),
        ]
        flat = simplify(graph, [n for part in parts for n in part])
        blocks, start = [], 0
        for name, shape, part in zip(
            ("rotations", "positions", "vectors", "series"), shapes, parts, strict=True
        ):
            blocks.append((name, shape, flat[start : start + len(part)]))
            start += len(part)
        return lower(
            graph, (len(names.states), len(names.specifieds), len(names.constants)), blocks
        )

    def rotation(self, frame: Any) -> Matrix3:
        """Return the direction cosines that turn components in `frame` into the reference's."""
        if frame not in self.rotations:
            path = self._path_to(frame)
            for before, after in pairwise(path):
                if after not in self.rotations:
                    step = self.nodes(
                        before.dcm(after), f"the orientation of frame `{after}` in `{before}`"
                    )
                    self.rotations[after] = self._product(self.rotations[before], step)
        return self.rotations[frame]

    def _path_to(self, frame: Any) -> list[Any]:
        try:
            # SymPy's public `dcm` would multiply the whole chain out for each frame anew.
            path: list[Any] = self.geometry.reference._dict_list(frame, 0)
        except ValueError:
            raise ValueError(
                f"The frame `{frame}` is not related to the scene's reference frame "
                f"`{self.geometry.reference}`. Orient it with `orient_axis` or the like, in that "
                "frame or in one that is oriented in it, or choose another `reference_frame`."
            ) from None
        return path

    def position(self, point: Any) -> Vector3:
        """Return the components of a point's position in the reference frame."""
        try:
            vector = point.pos_from(self.geometry.origin)
        except ValueError:
            raise ValueError(
                f"The point `{point}` is not related to the scene's origin "
                f"`{self.geometry.origin}`. Give its position with `set_pos` or `locatenew`, from "
                "that point or from one that is located from it, or choose another `origin`."
            ) from None
        return self.components(vector, f"the position of point `{point}`")

    def components(self, vector: Any, what: str) -> Vector3:
        """Return the components of a SymPy vector in the reference frame."""
        graph = self.graph
        terms: list[list[tuple[int, float]]] = [[], [], []]
        for components, frame in vector.args:
            nodes = self.nodes(components, what)
            for i, row in enumerate(self.rotation(frame)):
                terms[i] += [(graph.mul(a, b), 1.0) for a, b in zip(row, nodes, strict=True)]
        return [graph.sum(term) for term in terms]

    def nodes(self, expressions: Any, what: str) -> list[int]:
        """Return the nodes of expressions, having checked that each symbol has a value."""
        rows = [sm.sympify(e) for e in expressions]
        for symbol in find_symbols(rows):
            if symbol not in self.read.atoms:
                self._define(symbol, what)
        self.read.what = what
        return self.read.all(rows)

    def _define(self, symbol: Any, what: str) -> None:
        if name_of(symbol) in self.by_name:
            self.read.define(symbol, self.by_name[name_of(symbol)])
            return
        if symbol in self.names.definitions:
            (node,) = self.nodes([self.names.definitions[symbol]], what)
            self.read.define(symbol, node)
            return
        start = what[0].upper() + what[1:]
        if isinstance(symbol, sm.Derivative):
            remedy = "Write it with the speeds instead."
        elif isinstance(symbol, AppliedUndef):
            remedy = "Is the trajectory of another system? Or give its values in `specifieds`."
        else:
            remedy = "Give its value in `constants`."
        raise ValueError(
            f"{start} holds `{symbol}`, for which the trajectory has no value: it is not one "
            f"of its states, specifieds and constants. {remedy}"
        )

    def _product(self, a: Matrix3, b: list[int]) -> Matrix3:
        graph = self.graph
        return [
            [
                graph.sum([(graph.mul(row[k], b[3 * k + j]), 1.0) for k in range(3)])
                for j in range(3)
            ]
            for row in a
        ]
