"""Motions of a scene: a trajectory, or arrays of times and states, as ordered arrays."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import dataclass, field
from itertools import islice, pairwise
from typing import TYPE_CHECKING, Any

import numpy as np
import sympy as sm
from sympy.core.function import AppliedUndef
from sympy.physics.mechanics import dynamicsymbols

from pydy._backends import compile_program
from pydy._checks import (
    SymbolIndex,
    check_mapping,
    descends,
    describe,
    listed,
    merged,
    monotonic,
    number,
    real_array,
    refuse_twice,
    typed,
)
from pydy._collector import collector_paused
from pydy._graph import Graph, SymPyReader, lower, simplify
from pydy._mechanics import dot, find_symbols
from pydy._names import name_of
from pydy._program import Program
from pydy._rank import DIGITS

if TYPE_CHECKING:
    from numpy.typing import ArrayLike
    from sympy.physics.mechanics import Point, ReferenceFrame, Vector

    from pydy._sympy_types import AnySymbol, BySymbol, SymbolOrName, TimeFunction
    from pydy.trajectory import Trajectory

# -- Placement: the poses of all visuals from one compiled Program ---------------------------------
# The position of each point and the orientation of each frame become nodes of one graph, in which
# a frame's orientation is built on that of the frame before it: a chain of n links costs n
# products of matrices, not n². The Program's outputs for all frames of an animation come from one
# sweep.


Matrix3 = list[list[int]]
Vector3 = list[int]


@dataclass(frozen=True)
class Names:
    """The symbols whose values a trajectory supplies."""

    # states, specifieds, constants: symbols; in the order of the arrays x, r and p
    states: tuple[SymbolOrName, ...]
    specifieds: tuple[SymbolOrName, ...] = ()
    constants: tuple[SymbolOrName, ...] = ()
    # mapping of further symbols to expressions: derivatives of the coordinates, auxiliary speeds
    definitions: Mapping[AnySymbol, sm.Expr | float] = field(default_factory=dict)
    time: sm.Symbol = dynamicsymbols._t


@dataclass(frozen=True)
class Geometry:
    """The distinct frames, points, vectors of arrows, and expressions to compute."""

    reference: ReferenceFrame  # the frame and the point that the scene is seen from
    origin: Point
    frames: tuple[ReferenceFrame, ...]
    points: tuple[Point, ...]
    vectors: tuple[Vector, ...] = ()
    series: tuple[tuple[str, sm.Expr | float], ...] = ()  # (label, expression)


@dataclass(frozen=True)
class Placement:
    """The numbers for a Geometry at m instants, all in the reference frame."""

    # (m, 3, 3): the columns are the frame's unit vectors
    rotations: dict[ReferenceFrame, np.ndarray]
    positions: dict[Point, np.ndarray]  # (m, 3)
    vectors: np.ndarray  # (m, k, 3)
    series: dict[str, np.ndarray]  # (m,)


def pose_program(geometry: Geometry, names: Names) -> Program:
    """Return the Program with blocks 'rotations', 'positions', 'vectors' and 'series'."""
    return _Poses(geometry, names).program()


def compute_placement(geometry: Geometry, motion: SceneMotion) -> Placement:
    """Evaluate the frames, points, vectors and series of a Geometry along a motion."""
    program = pose_program(geometry, motion.names)
    numbers = (motion.times, motion.states, motion.specifieds, motion.constants)
    out, _ = compile_program(program, "llvm", {}).evaluate(*numbers)
    blocks = program.signature.by_block(out)
    rotations, positions = blocks["rotations"], blocks["positions"]
    return Placement(
        {f: rotations[:, k] for k, f in enumerate(geometry.frames)},
        {p: positions[:, k] for k, p in enumerate(geometry.points)},
        blocks["vectors"],
        {label: blocks["series"][:, k] for k, (label, _) in enumerate(geometry.series)},
    )


class _Poses:
    """Builds the graph of a Geometry."""

    def __init__(self, geometry: Geometry, names: Names) -> None:
        self.geometry = geometry
        self.names = names
        self.graph = graph = Graph()
        self.read = SymPyReader.of_inputs(
            graph,
            "the scene",
            p=names.constants,
            r=names.specifieds,
            x=names.states,
            t=[names.time],
        )
        # A trajectory that was loaded from a file has names instead of symbols.
        self.by_name = {s: node for s, node in self.read.atoms.items() if isinstance(s, str)}
        unit = [[graph.one if i == j else graph.zero for j in range(3)] for i in range(3)]
        self.rotations: dict[ReferenceFrame, Matrix3] = {geometry.reference: unit}

    @collector_paused()
    def program(self) -> Program:
        geometry, graph, names = self.geometry, self.graph, self.names
        parts = {
            "rotations": [c for f in geometry.frames for row in self.rotation(f) for c in row],
            "positions": [c for p in geometry.points for c in self.position(p)],
            "vectors": [c for v in geometry.vectors for c in self._arrow(v)],
            "series": [self.nodes([e], f"the series `{k}`")[0] for k, e in geometry.series],
        }
        shapes = [
            (len(geometry.frames), 3, 3),
            (len(geometry.points), 3),
            (len(geometry.vectors), 3),
            (len(geometry.series),),
        ]
        simplified = iter(simplify(graph, [n for nodes in parts.values() for n in nodes]))
        blocks = [
            (name, shape, list(islice(simplified, len(nodes))))
            for shape, (name, nodes) in zip(shapes, parts.items(), strict=True)
        ]
        sizes = (len(names.states), len(names.specifieds), len(names.constants))
        return lower(graph, sizes, blocks)

    def rotation(self, frame: ReferenceFrame) -> Matrix3:
        """Return the matrix that transforms components from `frame` to the reference frame."""
        if frame not in self.rotations:
            path = self._path_to(frame)
            for before, after in pairwise(path):
                if after not in self.rotations:
                    step = self.nodes(
                        before.dcm(after), f"the orientation of frame `{after}` in `{before}`"
                    )
                    columns = [step[k::3] for k in range(3)]
                    self.rotations[after] = [
                        [dot(self.graph, column, row) for column in columns]
                        for row in self.rotations[before]
                    ]
        return self.rotations[frame]

    def _path_to(self, frame: ReferenceFrame) -> list[ReferenceFrame]:
        try:
            # SymPy's public `dcm` would multiply out the full chain for each frame.
            path: list[ReferenceFrame] = self.geometry.reference._dict_list(frame, 0)
        except ValueError:
            raise ValueError(
                f"The frame `{frame}` is not related to the scene's reference frame "
                f"`{self.geometry.reference}`. Orient it with `orient_axis` or the like, in that "
                "frame or in one that is oriented in it, or choose another `reference_frame`."
            ) from None
        return path

    def position(self, point: Point) -> Vector3:
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

    def _arrow(self, vector: Vector) -> Vector3:
        try:
            return self.components(vector, "the arrow")
        except (TypeError, ValueError):  # a message with its text, which for tires takes seconds
            return self.components(vector, f"the arrow `{vector}`")

    def components(self, vector: Vector, description: str) -> Vector3:
        """Return the components of a SymPy vector in the reference frame."""
        graph = self.graph
        terms: list[list[tuple[int, float]]] = [[], [], []]
        for components, frame in vector.args:
            nodes = self.nodes(components, description)
            for i, row in enumerate(self.rotation(frame)):
                terms[i] += [(graph.mul(a, b), 1.0) for a, b in zip(row, nodes, strict=True)]
        return [graph.sum(term) for term in terms]

    def nodes(self, expressions: Iterable[sm.Expr | float], description: str) -> list[int]:
        """Return the nodes of expressions; raise an error if a symbol has no value."""
        rows = [sm.sympify(e) for e in expressions]
        for symbol in find_symbols(rows):
            if symbol not in self.read.atoms:
                self._define(symbol, description)
        self.read.what = description
        return self.read.all(rows)

    def _define(self, symbol: AnySymbol, description: str) -> None:
        if name_of(symbol) in self.by_name:
            self.read.define(symbol, self.by_name[name_of(symbol)])
            return
        if symbol in self.names.definitions:
            (node,) = self.nodes([self.names.definitions[symbol]], description)
            self.read.define(symbol, node)
            return
        start = description[0].upper() + description[1:]
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


# -- Motion ----------------------------------------------------------------------------------------


@dataclass(frozen=True)
class SceneMotion:
    """Numbers at m instants, in the order of their names."""

    names: Names
    times: np.ndarray  # (m,)
    states: np.ndarray  # (m, n)
    specifieds: np.ndarray  # (m, s)
    constants: np.ndarray  # (k,)

    @property
    def values(self) -> dict[SymbolOrName, float]:
        """The constants' values by symbol."""
        return dict(zip(self.names.constants, self.constants.tolist(), strict=True))

    def at_rows(self, rows: np.ndarray) -> SceneMotion:
        """Return the SceneMotion at some of the instants."""
        return SceneMotion(
            self.names, self.times[rows], self.states[rows], self.specifieds[rows], self.constants
        )


def forward(motion: SceneMotion) -> SceneMotion:
    """Return a SceneMotion with ascending times: animations play forward in time."""
    return motion.at_rows(np.arange(len(motion.times))[::-1]) if descends(motion.times) else motion


@dataclass(frozen=True)
class SceneModel:
    """The interface between a System and a Scene."""

    states: tuple[TimeFunction, ...]
    # mapping of symbols to expressions: derivatives of the coordinates, auxiliary speeds
    definitions: Mapping[AnySymbol, sm.Expr | float] = field(default_factory=dict)
    # ``times() -> ndarray``, the times of the System
    times: Callable[[], np.ndarray] | None = None
    # ``trajectory(times, states)`` returns a Trajectory, of checked arrays
    trajectory: Callable[[np.ndarray, np.ndarray], Trajectory] | None = None
    # returns a `pydy.viz.live.LiveSystem` for a live page, given events and constraints
    live: Callable[..., Any] | None = None


def checked_samples(times: object, states: object, width: int) -> tuple[np.ndarray, np.ndarray]:
    """Check times (m,) and states (m, width), and return them as arrays."""
    t, x = monotonic(times, "`times`"), real_array(states, "`states`")
    if not len(t):
        raise ValueError("`times` must be a sequence of one time or more, got none.")
    if x.shape != (len(t), width):
        raise ValueError(
            f"`states` must have the shape ({len(t)}, {width}), a row for each of the times and a "
            f"column for each state, got {x.shape}."
        )
    return np.ascontiguousarray(t), np.ascontiguousarray(x)


def _motion(
    names: Names,
    times: np.ndarray,
    states: np.ndarray,
    rows: np.ndarray,
    values: Mapping[SymbolOrName, float],
) -> SceneMotion:
    """Return a SceneMotion of finite numbers."""
    for table, symbols in ((states, names.states), (rows, names.specifieds)):
        bad = np.argwhere(~np.isfinite(table))
        if len(bad):
            k, j = map(int, bad[0])
            raise ValueError(
                f"`{symbols[j]}` is {table[k, j]} at t = {times[k]:g}, index {k}: there is nothing "
                "to draw. Did the integration fail there? Pass the part before."
            )
    return SceneMotion(names, times, states, rows, np.array([float(v) for v in values.values()]))


def motion_of_trajectory(
    trajectory: Any,
    model: SceneModel | None,
    constants: BySymbol[float] | None = None,
    requested: Iterable[AnySymbol] = (),
) -> SceneMotion:
    """Return the SceneMotion of a Trajectory, or of anything with its attributes.

    `constants` take precedence over those of the trajectory. Outputs among the `requested` symbols
    are included.
    """
    missing = [a for a in ("times", "states", "state_symbols") if not hasattr(trajectory, a)]
    if missing:
        raise TypeError(
            f"`animate` takes a Trajectory, or times and states, got {typed(trajectory)}."
        )
    symbols = tuple(trajectory.state_symbols)
    # A trajectory that was loaded from a file has names instead of symbols.
    if model is not None and set(map(name_of, model.states)) != set(map(name_of, symbols)):
        raise ValueError(
            f"The trajectory is one of another system: it has the states {describe(symbols)}, the "
            f"scene's system has {describe(model.states)}. Animate a trajectory of this system, or "
            "make the scene from that one."
        )
    values = {**constants_of(trajectory), **_constants(constants)}
    specified = tuple(getattr(trajectory, "specifieds_symbols", None) or ())
    definitions = model.definitions if model is not None else {}
    outputs = tuple(getattr(trajectory, "outputs_symbols", ()))
    requested_outputs = {symbol: trajectory[symbol] for symbol in requested if symbol in outputs}
    names = Names(symbols, (*specified, *requested_outputs), tuple(values), definitions)
    times, states = checked_samples(trajectory.times, trajectory.states, len(symbols))
    rows = np.asarray(trajectory.specifieds, dtype=float) if specified else np.zeros((1, 0))
    rows = np.broadcast_to(rows, (len(times), len(specified)))
    rows = np.ascontiguousarray(np.column_stack([rows, *requested_outputs.values()]))
    return _motion(names, times, states, rows, values)


def motion_of_arrays(
    times: ArrayLike,
    states: ArrayLike,
    symbols: Sequence[SymbolOrName] | None,
    constants: BySymbol[float] | None,
    specifieds: BySymbol[ArrayLike] | None,
) -> SceneMotion:
    """Return the SceneMotion of plain arrays, as `Scene.animate` describes them."""
    if symbols is None:
        raise TypeError(
            "`symbols` must say what the columns of `states` are, such as symbols=[q1, q2, u1, "
            "u2]; only a scene made by `system.scene()` knows."
        )
    symbols = tuple(listed("symbols", symbols, "functions of time", hashable=True))
    symbols = tuple(s.removesuffix("(t)") if isinstance(s, str) else s for s in symbols)
    refuse_twice(_symbols_of_names(symbols, "symbols"), "symbols")
    t, x = checked_samples(times, states, len(symbols))
    columns = []
    inputs = merged(check_mapping("specifieds", specifieds))
    for symbol, value in inputs.items():
        column = real_array(value, f"`specifieds[{symbol}]`")
        if column.shape not in ((), (len(t),)):
            raise ValueError(
                f"`specifieds[{symbol}]` must be a number or have the shape ({len(t)},), got "
                f"{column.shape}."
            )
        columns.append(np.broadcast_to(column, t.shape))
    rows = np.stack(columns, 1) if columns else np.zeros((len(t), 0))
    values = _constants(constants)
    names = Names(symbols, tuple(inputs), tuple(values))
    return _motion(names, t, x, rows, values)


def constants_of(trajectory: object) -> dict[SymbolOrName, float]:
    """Return the constants of a trajectory, or of an object with its attributes."""
    return dict(getattr(trajectory, "constants", None) or {})


def _constants(constants: BySymbol[float] | None) -> dict[SymbolOrName, float]:
    values = merged(check_mapping("constants", constants))
    return {symbol: number(value, f"`constants[{symbol}]`") for symbol, value in values.items()}


def _symbols_of_names(keys: Iterable[SymbolOrName], argument: str) -> list[SymbolOrName]:
    """Return keys, with each name replaced by the symbol of that name, if it is among them."""
    keys = [*keys]
    lookup = SymbolIndex([key for key in keys if not isinstance(key, str)], argument)
    return [lookup.meaning(key, argument) for key in keys]


def sampled(times: np.ndarray, step: float | None) -> np.ndarray:
    """Return the indices of samples at least `step` apart, except for the last one.

    A subset of the computed samples is selected, so that their poses are not interpolated. Without
    a step, all are selected.

    Examples
    --------
    >>> import numpy as np
    >>> from pydy.viz.motion import sampled
    >>> sampled(np.linspace(0, 1, 101), 1 / 30)[:4]
    array([ 0,  4,  8, 12])
    """
    last = len(times) - 1
    if step is None:
        return np.arange(last + 1)
    selected = [0]
    least = step * (1 - DIGITS)  # times one step apart may be rounded to slightly less
    while True:
        k = max(int(np.searchsorted(times, times[selected[-1]] + least)), selected[-1] + 1)
        if k > last:
            break
        selected.append(k)
    if selected[-1] != last and times[last] > times[selected[-1]]:
        if len(selected) > 1 and times[last] - times[selected[-2]] < 1.5 * step:
            selected.pop()
        selected.append(last)
    return np.array(selected)
