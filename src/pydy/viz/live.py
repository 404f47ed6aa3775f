"""Live pages, which run the simulation in the browser: sliders, and the data for the scripts.

`LivePage.code` writes the model and further Programs in JavaScript: poses of frames and points,
formulas of curves, sizes of shapes, and initial conditions that sliders set. After a slider moves,
``assets/live.js`` calls these: ``writeRow`` moves visuals on their tracks and the points of lines,
``resize3`` changes sizes, and ``frameMotion`` the ground, if its height was not given, and what a
reset of the view shows. Everything else of the page is as for the first motion: the colours, for
instance.
"""

from __future__ import annotations

from collections import ChainMap
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, field, replace
from itertools import chain
from typing import TYPE_CHECKING, Any, TypeAlias

import numpy as np
import sympy as sm

from pydy._checks import SymbolIndex, choice, number, positive, refuse_twice, shown, text
from pydy._graph import Graph, SymPyReader, lower, simplify
from pydy._names import label_parts, name_of, nearest, some
from pydy._program import Program, run
from pydy._rank import ROUNDED, or_one
from pydy.export import Model, Variable, javascript_object
from pydy.viz.animation import Animation, Item, followed
from pydy.viz.arguments import live_unknowns
from pydy.viz.defaults import inertial_lengths
from pydy.viz.motion import Geometry, Names, SceneMotion, pose_program
from pydy.viz.shapes import Arrow, Line

if TYPE_CHECKING:
    from sympy.physics.mechanics import Point, ReferenceFrame, Vector

    from pydy._sympy_types import AnySymbol, BySymbol, ExpressionOrName, SymbolOrName, TimeFunction
    from pydy.solvers import Event
    from pydy.viz.motion import SceneModel
    from pydy.viz.visuals import Visual

_SAMPLES = 6
# A symbol of the user, its value at the start, and the initial conditions that it sets.
UserSlider: TypeAlias = "tuple[sm.Symbol, float, BySymbol[sm.Expr | float]]"


@dataclass(frozen=True)
class Slider:
    """A value that the reader of a live page can change.

    Parameters
    ----------
    low, high : float
        Range of the slider. The box next to it also accepts numbers outside the range.
    value : float, optional
        Value at the start; by default that of the system.
    unit, label : str, optional
        Unit and label; by default no unit, and the name of the symbol.
    sets : mapping of states to expressions, optional
        For a symbol of your own, which requires a `value`: the initial conditions that it sets, as
        expressions of this symbol and of constants.

    Examples
    --------
    >>> from pydy.viz import Slider
    >>> Slider(0.1, 2.0, unit="m").high
    2.0
    """

    low: float
    high: float
    value: float | None = None
    unit: str = ""
    label: str = ""
    sets: BySymbol[sm.Expr | float] = field(default_factory=dict)

    def __post_init__(self) -> None:
        for name in ("low", "high"):
            checked = number(getattr(self, name), f"`{name}` of Slider", finite=True)
            object.__setattr__(self, name, checked)
        if not self.low < self.high:
            raise ValueError(
                f"`low` of Slider must be less than `high`, got {self.low} and {self.high}."
            )
        if self.value is not None:
            checked = number(self.value, "`value` of Slider", finite=True)
            if not self.low <= checked <= self.high:
                raise ValueError(
                    f"`value` of Slider must be from `low` to `high`, {self.low} to {self.high}, "
                    f"got {checked}: widen the range."
                )
            object.__setattr__(self, "value", checked)
        text(self.unit, "`unit` of Slider")
        text(self.label, "`label` of Slider")
        if not isinstance(self.sets, dict):
            raise TypeError(
                f"`sets` of Slider must map states to expressions, got {shown(self.sets)}."
            )


@dataclass(frozen=True)
class Live:
    """Sliders of a live page, and options of its integration.

    Parameters
    ----------
    sliders : mapping
        Keys are constants, states (for their initial conditions), specifieds that are numbers
        (inputs), names of these, or a symbol of your own. Values are a `Slider` or a tuple of its
        first arguments.
    events : Event or sequence of Event, optional
    constraints : {'auto', 'project', None}, optional
        By default the state is projected onto the constraints, if there are any, after each step.
    rtol, atol : float, optional
        The error allowed in a step is ``atol + rtol * abs(x)``.
    max_step : float, optional
        Largest step; limit it if an input is shorter than a step and not by conditions that are
        linear in time, as ``t > t0``.
    """

    sliders: BySymbol[Slider | tuple[float | str | None, ...]] = field(default_factory=dict)
    events: Event | Sequence[Event] | None = None
    constraints: str | None = "auto"
    rtol: float = 1e-8
    atol: float = 1e-8
    max_step: float | None = None

    def __post_init__(self) -> None:
        if not isinstance(self.sliders, Mapping):
            raise TypeError(
                "`live` must map constants, states or inputs to their ranges, such as "
                f"{{l: (0.1, 2.0)}}, got {shown(self.sliders)}."
            )
        choice(self.constraints, ("auto", "project", None), "`constraints` of Live")
        for name in ("rtol", "atol", *(() if self.max_step is None else ("max_step",))):
            checked = positive(getattr(self, name), f"`{name}` of Live", finite=True)
            object.__setattr__(self, name, checked)


@dataclass(frozen=True, eq=False)
class LiveSystem:
    """The parts of a System that a live page needs."""

    model: Model
    # states, inputs, constants, outputs: symbols; in the order of the model's variables
    states: tuple[TimeFunction, ...]
    inputs: tuple[TimeFunction, ...]
    constants: tuple[sm.Symbol, ...]
    outputs: tuple[SymbolOrName, ...]
    # mapping of symbols to expressions: specifieds that are expressions
    definitions: Mapping[AnySymbol, sm.Expr | float]
    # (list of int, list of int): indices in x of the dependent coordinates and speeds
    dependents: tuple[list[int], list[int]]
    coordinates: int  # numbers of coordinates and of speeds
    speeds: int


# -- Rigidly connected points ----------------------------------------------------------------------


class Witness:
    """Frames and points in generic states, for various values of the constants with sliders.

    A quantity that is constant in all of these is treated as constant.
    """

    def __init__(
        self, geometry: Geometry, program: Program, motion: SceneMotion, varied: Sequence[int]
    ) -> None:
        generator = np.random.default_rng(20)
        rotations, positions = [], []
        sizes = or_one(np.abs(motion.states).max(axis=0))
        for _ in range(_SAMPLES):
            x = motion.states[0] + sizes * generator.uniform(-1, 1, len(sizes))
            r = generator.uniform(-1, 1, (1, program.signature.num_specifieds))
            p = motion.constants.copy()
            p[varied] = np.where(p[varied], p[varied], 1.0) * generator.uniform(
                0.7, 1.3, len(varied)
            )
            out, _ = run(program, generator.uniform(0, 1, 1), x[None], r, p)
            blocks = program.signature.by_block(out[0])
            rotations.append(blocks["rotations"])
            positions.append(blocks["positions"])
        self._rotations = {f: np.stack([a[k] for a in rotations])
                           for k, f in enumerate(geometry.frames)}  # fmt: skip
        self._rotations[None] = np.broadcast_to(np.eye(3), (_SAMPLES, 3, 3))
        self._positions = {p: np.stack([a[k] for a in positions])
                           for k, p in enumerate(geometry.points)}  # fmt: skip

    def rigid(self, frame: ReferenceFrame | None, base: Point, point: Point) -> bool:
        """Return whether the vector between two points is constant in a frame."""
        positions = self._positions[point], self._positions[base]
        offset = np.einsum("mji,mj->mi", self._rotations[frame], positions[0] - positions[1])
        return bool(np.ptp(offset, axis=0).max() <= ROUNDED * np.abs(positions).max())


# -- the page -------------------------------------------------------------------------------------


def live_page(
    live: Live | BySymbol[Slider | tuple[float | str | None, ...]] | None,
    model: SceneModel | None,
    title: str,
    scene: tuple[ReferenceFrame, Point, Sequence[Visual], Mapping[str, ExpressionOrName | float]],
    animation: Animation,
    motion: SceneMotion,
) -> LivePage | None:
    """Return the additional content of a live page; None for an animation.

    `live` is the user's argument, `scene` the reference frame, origin, visuals and series.
    """
    if live is None:
        return None
    settings = live if isinstance(live, Live) else Live(live)
    if model is None or model.live is None:
        raise ValueError(
            "`live` needs the equations of motion: make the scene with `system.scene(...)`."
        )
    reference, origin, visuals, series = scene
    if len(animation.items) > len(visuals):
        raise ValueError(
            "A live page computes the motion anew and shows no other runs beside it: call "
            "`animate` without `compare`."
        )
    system = model.live(
        name=title or "model",
        events=settings.events,
        constraints=settings.constraints,
        max_step=settings.max_step,
    )
    return LivePage(settings, system, (reference, origin, series), animation, motion)


class LivePage:
    """The data of a live page; a Witness finds points that are always rigidly connected."""

    def __init__(
        self,
        live: Live,
        system: LiveSystem,
        scene: tuple[ReferenceFrame, Point, Mapping[str, ExpressionOrName | float]],
        animation: Animation,
        motion: SceneMotion,
    ) -> None:
        self.live, self.system, self.items = live, system, animation.items
        self.reference, self.origin, series = scene
        self.sliders, self.user_sliders = _sliders(live, system)
        constants = dict(zip(motion.names.constants, motion.constants.tolist(), strict=True))
        by_name = {name_of(s): v for s, v in constants.items()}
        model_names = {name_of(s) for s in system.constants}
        extras = {s: sm.Float(v) for s, v in constants.items() if name_of(s) not in model_names}
        lazy: Any = motion.names.definitions  # evaluated lazily
        self.names = Names(
            system.states,
            system.inputs,
            system.constants,
            ChainMap({**extras, **system.definitions}, lazy),
            motion.names.time,
        )
        visuals = [item.visual for item in self.items]
        geometry = self._geometry([v.frame for v in visuals], [v.point for v in visuals])
        p = np.array([by_name.get(name_of(s), 1.0) for s in system.constants])
        self.numbers = dict(zip(system.constants, p.tolist(), strict=True))
        generic = SceneMotion(self.names, motion.times, motion.states, motion.specifieds, p)
        count = len(system.constants)
        varied = [r["place"] for r in self.sliders if r["group"] == "p" and r["place"] < count]
        self.witness = Witness(geometry, pose_program(geometry, self.names), generic, varied)
        plotted, self.formulas = _series(series, animation, system)
        self.plotted: list[list[str | int]] = plotted
        self.start, self.starts = _start(system, self.user_sliders)
        set_states = {row["place"] for row in self.sliders if row["group"] == "x"} | set(
            self.starts
        )
        counts = (system.coordinates, system.speeds)
        self.unknowns = live_unknowns(set_states, system.dependents, counts, system.states)

    def _geometry(
        self,
        frames: Iterable[ReferenceFrame | None],
        points: Iterable[Point],
        *blocks: tuple[Vector, ...],
    ) -> Geometry:
        """Return some frames and points, and those of lines."""
        lines = (i.shape.points for i in self.items if isinstance(i.shape, Line))
        return Geometry(
            self.reference,
            self.origin,
            tuple(dict.fromkeys(f for f in frames if f is not None)),
            tuple(dict.fromkeys([*points, *chain.from_iterable(lines)])),
            *blocks,
        )

    def code(
        self, tracks: Sequence[tuple[ReferenceFrame | None, Point]]
    ) -> tuple[str, dict[str, object]]:
        """Return the model's object in JavaScript and the data of the page's scripts.

        The tracks of the page are pairs of a frame, or None, and a point.
        """
        live, system, items = self.live, self.system, self.items
        arrows = [i for i in items if isinstance(i.shape, Arrow)]
        vectors = tuple(i.shape.vector for i in arrows if isinstance(i.shape, Arrow))
        frames, placed = ([track[k] for track in tracks] for k in (0, 1))
        geometry = self._geometry(frames, placed, vectors)
        # Separate from the poses: curves have a sample at each step, poses at few of them.
        curves = Geometry(self.reference, self.origin, (), (), (), self.formulas)
        sizes, size_targets = _sizes(items, system, self.names.definitions, self.numbers)
        builders = {
            **system.model.builders,
            "poses": lambda: pose_program(geometry, self.names),
            "formulas": lambda: pose_program(curves, self.names),
            "sizes": lambda: sizes,
            "start": lambda: self.start,
        }
        added = tuple(Variable(s.name, s.name, v) for s, v, _ in self.user_sliders)
        model = replace(
            system.model, builders=builders, constants=(*system.model.constants, *added)
        )
        frame_of = {None: -1, **{f: k for k, f in enumerate(geometry.frames)}}
        point_of = {point: k for k, point in enumerate(geometry.points)}
        data = {
            "sliders": self.sliders,
            "options": {
                "rtol": live.rtol,
                "atol": live.atol,
                **({} if live.max_step is None else {"maxStep": live.max_step}),
            },
            "frames": len(geometry.frames),
            "points": len(geometry.points),
            "tracks": [[frame_of[f], point_of[q]] for f, q in tracks],
            "lines": [
                [point_of[q] for q in i.shape.points] if isinstance(i.shape, Line) else None
                for i in items
            ],
            "arrows": [
                [arrows.index(i), float(sm.Float(i.shape.scale))]
                if isinstance(i.shape, Arrow)
                else None
                for i in items
            ],
            "sizes": size_targets,
            "series": self.plotted,
            "starts": self.starts,
            "dependents": self.unknowns if model.constraints else None,
            "path": followed(items),
        }
        return javascript_object(model, ("poses", "formulas", "sizes", "start")), data


def _sliders(live: Live, system: LiveSystem) -> tuple[list[dict[str, Any]], list[UserSlider]]:
    """Return the sliders of the page, and the user's own ones with the inputs they set."""
    groups = (
        ("p", SymbolIndex(system.constants, "constants of the system"), system.model.constants),
        ("x", SymbolIndex(system.states, "states of the system"), system.model.states),
        ("r", SymbolIndex(system.inputs, "inputs of the system"), system.model.inputs),
    )
    refuse_twice(
        [next((s for _, lookup, _ in groups if (s := lookup.meaning(key, "live")) != key), key)
         for key in live.sliders], "live",
    )  # fmt: skip
    rows: list[dict[str, Any]] = []
    user_sliders: list[UserSlider] = []
    for key, argument in live.sliders.items():
        slider = _slider(key, argument)
        matches = [(g, k, v[k]) for g, lookup, v in groups
                 if (k := lookup.get(key, "live")) is not None]  # fmt: skip
        label = slider.label or name_of(key)
        row = {
            "label": label,
            "parts": label_parts(label),
            "unit": slider.unit,
            "low": slider.low,
            "high": slider.high,
        }
        if matches and not slider.sets:
            group, column, variable = matches[0]
            start = variable.value if slider.value is None else slider.value
            if not slider.low <= start <= slider.high:  # Slider has checked its `value`
                raise ValueError(
                    f"`live[{name_of(key)}]` must include the system's own value, {start}, got the "
                    f"range {slider.low} to {slider.high}: widen the range, or give a `value`."
                )
            rows.append({**row, "group": group, "place": column, "value": start})
            continue
        if matches or not isinstance(key, sm.Symbol) or not slider.sets:
            every = [
                name_of(symbol) for symbol in (*system.constants, *system.states, *system.inputs)
            ]
            hint = nearest(str(key), every, or_all=False)
            raise ValueError(
                f"`live` has `{key}`, which is not one of the system's constants, states and "
                f"inputs: {some(every)}. {f'{hint} ' if hint else ''}A slider of your own needs a "
                "Symbol that the system does not have, and `sets`, the initial conditions that "
                "follow from it."
                if not matches
                else f"`sets` of the slider for `{key}` is for symbols of your own, but the system "
                "has this one."
            )
        if slider.value is None:
            raise ValueError(f"The slider for `{key}`, a symbol of your own, needs a `value`.")
        column = len(system.constants) + len(user_sliders)
        user_sliders.append((key, slider.value, slider.sets))
        rows.append({**row, "group": "p", "place": column, "value": slider.value})
    return rows, user_sliders


def _slider(key: SymbolOrName, argument: object) -> Slider:
    if isinstance(argument, Slider):
        return argument
    if isinstance(argument, (tuple, list)) and 2 <= len(argument) <= 5:
        return Slider(*argument)
    raise ValueError(
        f"`live[{name_of(key)}]` must be a Slider or a range such as (0.1, 2.0), got "
        f"{shown(argument)}."
    )


def _start(system: LiveSystem, user_sliders: Sequence[UserSlider]) -> tuple[Program, list[int]]:
    """Return the Program of the initial conditions that user-defined sliders set."""
    graph = Graph()
    constants = [*system.constants, *(symbol for symbol, _, _ in user_sliders)]
    lookup = SymbolIndex(system.states, "states of the system")
    reader = SymPyReader.of_inputs(graph, "`sets` of a slider", p=constants, x=system.states)
    nodes, targets = [], []
    for key, _, sets in user_sliders:
        for state, expression in sets.items():
            column = lookup.get(state, "sets")
            if column is None:
                raise ValueError(
                    f"`sets` of the slider for `{key}` has `{state}`, which is no state of the "
                    f"system: {some(map(name_of, system.states))}."
                )
            targets.append(column)
            refuse_twice([system.states[k] for k in targets], "sets")
            nodes += reader.all([sm.sympify(expression)])
    sizes = (len(system.states), 0, len(constants))
    return lower(graph, sizes, [("start", (len(nodes),), simplify(graph, nodes))]), targets


def _sizes(
    items: Sequence[Item],
    system: LiveSystem,
    definitions: Mapping[AnySymbol, sm.Expr | float],
    numbers: Mapping[AnySymbol, float],
) -> tuple[Program, list[list[object]]]:
    """Return the Program of lengths that depend on constants, and their visuals.

    The constants have these `numbers` at the start.
    """
    graph = Graph()
    reader = SymPyReader.of_inputs(graph, "the shapes", p=system.constants)
    nodes, size_targets = [], []
    for k, item in enumerate(items):
        shape = item.visual.shape
        if shape is None:  # a default one
            lengths = inertial_lengths(item.visual.body, item.shape, numbers)
        else:
            lengths = {attribute: getattr(shape, attribute) for attribute in shape.lengths}
        for attribute, expression in lengths.items():
            if isinstance(expression, sm.Expr) and expression.free_symbols:
                values = {
                    s: definitions[s] for s in expression.free_symbols if s not in reader.atoms
                }
                nodes += reader.all([expression.xreplace(values)])
                size_targets.append([k, attribute])
    counts = (len(system.states), len(system.inputs), len(system.constants))
    return lower(graph, counts, [("sizes", (len(nodes),), simplify(graph, nodes))]), size_targets


def _series(
    series: Mapping[str, ExpressionOrName | float], animation: Animation, system: LiveSystem
) -> tuple[list[list[str | int]], tuple[tuple[str, sm.Expr | float], ...]]:
    """Return the source of each curve on the page, and expressions to compute with the poses."""
    plotted: list[list[str | int]] = []
    formulas: list[tuple[str, sm.Expr | float]] = []
    for label in animation.series:
        if label not in series:
            raise ValueError(
                f"The series {label!r} was given to `animate` as numbers, which a live page cannot "
                "compute anew. Give it to `scene` as an expression, or leave it out."
            )
        quantity = series[label]
        for group, symbols in (("x", system.states), ("r", system.inputs), ("y", system.outputs)):
            matches = [k for k, s in enumerate(symbols) if quantity in (s, str(s), name_of(s))]
            if matches:
                plotted.append([group, matches[0]])
                break
        else:
            if isinstance(quantity, str):
                raise ValueError(
                    f"The series {quantity!r} is not one of the system's states, inputs and "
                    "outputs: a live page cannot compute it. Give an expression."
                )
            plotted.append(["f", len(formulas)])
            formulas.append((label, quantity))
    return plotted, tuple(formulas)
