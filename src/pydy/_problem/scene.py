"""Make a `pydy.viz.Scene` from a System's equations and numbers."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from typing import Any

import numpy as np
import sympy as sm
from sympy.physics.mechanics import Point, ReferenceFrame, Vector, dynamicsymbols

from pydy._assembly import Assembly, Definition
from pydy._checks import check_mapping, flag, instance
from pydy._errors import warn_user
from pydy._graph import NodeExpression
from pydy._mechanics import Equations, FrameTree, Mechanism, find_symbols
from pydy._names import name_of, some
from pydy._rank import HALF
from pydy.viz import (
    Geometry,
    Names,
    Outline,
    Scene,
    SceneModel,
    SceneMotion,
    compute_placement,
    gravities,
    guess_up,
    load_arrows,
    outline,
    visuals_of,
)


def make_scene(
    definition: Definition,
    constants: Mapping[Any, float],
    assembly: Callable[[], Assembly],
    visuals: Sequence[Any],
    options: dict[str, Any],
    moving: tuple[Any, ...] = (),
) -> Scene:
    """Return a scene with defaults from the bodies and loads.

    The `assembly` is made where u' is shown; `moving` has the arguments of a
    `pydy.viz.motion.SceneModel` after the definitions.
    """
    equations = definition.equations
    options = dict(options)
    given = (options.pop(k, None) for k in ("reference_frame", "origin"))
    loads = flag(options.pop("loads", False), "`loads`")
    mechanism = equations.mechanism
    bodies = mechanism.bodies if mechanism is not None else ()
    if equations.multibody is not None:
        equations.multibody.check_unchanged()
    if not visuals and not bodies:
        raise ValueError(
            "`scene` needs visuals, such as Visual(Sphere(0.1), point): the System's `eom_method` "
            "was given no bodies that could be shown."
        )
    reference_frame, origin = _seen_from(equations, *given)
    if "up" not in options and mechanism is not None:
        up = guess_up(reference_frame, bodies, mechanism.loads, constants)
        if up is None and mechanism.lagrangian is not None and reference_frame is mechanism.frame:
            names = Names(definition.states, definition.specifieds)
            up = up_in_lagrangian(mechanism, origin, names, constants)
        # Without gravity z is up and there is no ground to fall on.
        options = {"up": "z", "ground": False, **options} if up is None else {**options, "up": up}
    kinematics = equations.kinematics
    rates = zip(kinematics.coordinate_rates, kinematics.coordinate_derivatives, strict=True)
    definitions = _Definitions(equations, assembly)
    definitions.update({**dict(rates), **dict.fromkeys(kinematics.zeros, 0)})
    model = SceneModel(definition.states, definitions, *moving)
    if not visuals:
        assert mechanism is not None
        names = Names(definition.states, definition.specifieds, definitions=dict(definitions))
        resting = _resting(mechanism, reference_frame, origin)
        places = mechanism, resting or origin, equations.coordinates
        found = _outline(*places, names, constants, bool(equations.constraints.holonomic))
        if resting is None:  # what is fixed to a moving point does not rest
            found.supports, found.resting = [], []
        known = {"t", *map(name_of, (*constants, *definition.states, *definition.specifieds))}
        known |= {*map(name_of, check_mapping("constants", options.get("constants")))}
        _leave_out_unknown(found, origin, [body.masscenter for body in bodies], known)
        turned = reference_frame is not mechanism.frame
        visuals = visuals_of(bodies, found, mechanism.frame if turned else None)
    if loads and mechanism is not None:
        # Gravity on the ground's own body moves nothing: the equations do not hold its mass.
        shown = [
            (where, vector)
            for where, vector in mechanism.loads
            if not (_rests(where, mechanism.frame) and _constants_of(vector) - constants.keys())
        ]
        visuals = [*visuals, *load_arrows(mechanism.bodies, shown)]
    return Scene(reference_frame, origin, *visuals, model=model, **options)


def _outline(
    mechanism: Mechanism,
    origin: Any,
    coordinates: Sequence[Any],
    names: Names,
    constants: Mapping[Any, float],
    closed: bool,
) -> Outline:
    """Return what the points of a mechanism show."""
    potential = None
    if mechanism.lagrangian is not None:
        lagrangian = sm.sympify(mechanism.lagrangian)
        potential = -lagrangian.xreplace(dict.fromkeys(lagrangian.atoms(sm.Derivative), 0))
    return outline(
        mechanism.frame, origin, mechanism.bodies, mechanism.loads, coordinates, names, constants,
        potential, closed,
    )  # fmt: skip


def _leave_out_unknown(
    found: Outline, origin: Point, centres: Sequence[Point], known: set[str]
) -> None:
    """Take lines from an Outline whose points depend on symbols without values, and warn of it.

    Such points are marks that the equations do not need. Without the mass centres of the bodies
    there is no picture.
    """
    missing: dict[Point, set[str]] = {}  # the names on the way from the origin
    for point, before in FrameTree.points_from([origin]).items():
        missing[point] = set()
        if before is not None:
            parts = [m for m, _ in FrameTree.positions(point)[before].args]
            names = {name_of(s) for s in find_symbols(parts) if isinstance(s, sm.Symbol)}
            missing[point] = missing[before] | (names - known)
    hidden: dict[Point, None] = {}

    def is_drawn(*points: Point) -> bool:
        lacking = [point for point in points if missing.get(point)]
        hidden.update(dict.fromkeys(lacking))
        return not lacking

    if not is_drawn(*centres):
        return  # `animate` names what a body lacks
    found.bars = [(body, pair) for body, pair in found.bars if is_drawn(*pair)]
    for lines in (found.ropes, found.springs, found.dampers):
        lines[:] = [pair for pair in lines if is_drawn(*pair)]
    found.supports = [point for point in found.supports if is_drawn(point)]
    if hidden:
        unknown = sorted(set().union(*(missing[point] for point in hidden)))
        example = ", ".join(f"'{name}': 1.0" for name in unknown[:2])
        warn_user(
            f"Lines to {some(map(str, hidden))} are not drawn: the equations have no value for "
            f"{some(unknown)}. Pass `animate(constants={{{example}}})`, with your numbers."
        )


def _resting(mechanism: Mechanism, frame: Any, origin: Any) -> Any:
    """Return a point at rest in the inertial frame, or None: a scene's origin may move.

    If the user set no velocity of the origin, zero was assumed, unless a body is there.
    """
    velocity = FrameTree(mechanism.frame).velocity(origin)
    centres = [body.masscenter for body in mechanism.bodies]
    chosen = velocity is None and frame is mechanism.frame and origin not in centres
    if chosen or velocity == Vector(0):
        return origin
    return FrameTree.point_at_rest(mechanism.frame, [origin, *centres])


def _seen_from(equations: Equations, frame: Any, origin: Any) -> tuple[Any, Any]:
    """Return the reference frame and the origin of a scene, by default those of the mechanism."""
    mechanism, multibody = equations.mechanism, equations.multibody
    if frame is None:
        if mechanism is None:
            raise ValueError("`reference_frame` must be given: the System knows of no frame.")
        frame = mechanism.frame
    instance(frame, ReferenceFrame, "`reference_frame`")
    if origin is None and multibody is not None and frame is multibody.frame:
        origin = multibody.origin  # that of `frame_position`
    if origin is None:
        bodies = mechanism.bodies if mechanism is not None else ()
        origin = FrameTree.point_at_rest(frame, [body.masscenter for body in bodies])
        if origin is None:
            raise ValueError(
                f"`origin` is required: the bodies are connected to no point at rest in `{frame}`. "
                "Pass `origin=O` with the point that is the zero of the scene, or call "
                f"`O.set_vel({frame}, 0)` when you derive the equations."
            )
    instance(origin, Point, "`origin`")
    return frame, origin


def _rests(where: Any, frame: Any) -> bool:
    """Return whether a load's point or frame was said to rest in the inertial frame."""
    if isinstance(where, Point):
        return bool(FrameTree(frame).velocity(where) == Vector(0))
    return where is frame


def _constants_of(vector: Any) -> set[Any]:
    """Return the symbols of a vector that are no functions and not the time."""
    return {s for m, _ in vector.args for s in m.free_symbols} - {dynamicsymbols._t}


class _Definitions(dict[Any, Any]):
    """Definitions of further symbols in a scene; rates of speeds, as in forces, on demand."""

    def __init__(self, equations: Equations, assembly: Callable[[], Assembly]) -> None:
        super().__init__()
        self._rates, self._assembly = equations.kinematics.speed_rates, assembly

    def __contains__(self, symbol: object) -> bool:
        return super().__contains__(symbol) or (
            symbol in self._rates and symbol in self._assembly().atoms
        )

    def __missing__(self, symbol: Any) -> Any:
        assembly = self._assembly()
        graph = assembly.graph
        symbols = {
            node: s
            for s, node in assembly.atoms.items()
            if graph.ops[node] == "input" and s not in self._rates
        }
        for rate in self._rates:
            self[rate] = NodeExpression.of(graph, assembly.atoms[rate], symbols, str(rate))
        return self[symbol]


# -- Which way gravity pulls where no load tells it: only a Lagrangian does ------------------------


def up_in_lagrangian(
    mechanism: Mechanism, origin: Any, names: Names, values: Mapping[Any, float]
) -> str | None:
    """Return the axis along which a Lagrangian's energy of weights grows, or None."""
    lagrangian = sm.sympify(mechanism.lagrangian)
    potential = -lagrangian.xreplace(dict.fromkeys(lagrangian.atoms(sm.Derivative), 0))
    masses = {body.masscenter: sm.sympify(body.mass) for body in mechanism.bodies}
    known = gravities(potential)
    if len(known) == 1:
        weights = known[0] * potential.diff(known[0])
    elif any(mass.is_Symbol for mass in masses.values()):
        masses = {point: mass for point, mass in masses.items() if mass.is_Symbol}
        weights = sm.Add(*(mass * potential.diff(mass) for mass in {*masses.values()}))
    else:
        weights = potential
    series = (("energy", weights), *((str(k), mass) for k, mass in enumerate(masses.values())))
    found = find_symbols([expression for _, expression in series])
    symbols = {s for s in found if isinstance(s, sm.Symbol) and s != names.time}
    constants = tuple(dict.fromkeys((*values, *symbols)))
    geometry = Geometry(mechanism.frame, origin, (), tuple(masses), (), series)
    rng, m = np.random.default_rng(0), 8  # states: more than a straight line has freedoms
    try:
        drawn = SceneMotion(
            Names(names.states, names.specifieds, constants),
            np.zeros(m),
            rng.uniform(0.1, 1.0, (m, len(names.states))),
            rng.uniform(0.1, 1.0, (m, len(names.specifieds))),
            np.array([values.get(s, 1.0) for s in constants]),
        )
        placed = compute_placement(geometry, drawn)
    except ValueError:  # a symbol without a value, or a point that hangs in the air
        return None
    energy = placed.series["energy"]
    moments = sum(
        placed.series[str(k)][:, None] * placed.positions[point] for k, point in enumerate(masses)
    )
    return _axis(energy, np.asarray(moments))


def _axis(energy: np.ndarray, moments: np.ndarray) -> str | None:
    """Return the one axis whose moments an energy is a multiple of, with its sign."""
    fits = []
    rise = energy - energy.mean()
    for name, moment in zip("xyz", moments.T, strict=True):
        away = moment - moment.mean()
        slope = float(rise @ away / (away @ away)) if away.any() else 0.0
        size = np.abs(energy).max() + np.abs(slope * moment).max()
        left, part = np.abs(rise - slope * away).max(), np.abs(slope * away).max()
        if left <= HALF * size < part:
            fits.append(("-" if slope < 0 else "") + name)
    return fits[0] if len(fits) == 1 else None
