"""Defaults of a scene: shapes of bodies, the origin, the upward direction."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from typing import TYPE_CHECKING, Any

import numpy as np
import sympy as sm
from sympy.core.function import Application, AppliedUndef
from sympy.physics.mechanics import RigidBody
from sympy.physics.vector import ReferenceFrame, Vector

from pydy._checks import listed, real_array, shown
from pydy._expressions import parts_of
from pydy._mechanics import find_symbols, replace_symbols
from pydy._rank import DIGITS, HALF, rank
from pydy.viz.outlines import Outline
from pydy.viz.shapes import (
    Arrow,
    Bar,
    Box,
    Cylinder,
    Damper,
    Line,
    Shape,
    Sphere,
    Spring,
    Support,
)
from pydy.viz.surfaces import surface
from pydy.viz.visuals import Visual

if TYPE_CHECKING:
    from pydy._sympy_types import AnySymbol, Body, Load, SymbolOrName

# Minimum thickness of a plate, relative to its longest edge.
_THINNEST = 0.03
# Default radii relative to the size of the scene: a bar, a ball, a body in a plane.
BAR, BALL, PLATE = 0.011, 0.04, 0.08
# A solid must not exceed this fraction of the distance to its body's points, or it hides them.
_COMPACT = 0.5


def default_shape(
    body: Body,
    values: Mapping[SymbolOrName, float],
    size: float,
    arms: Sequence[np.ndarray] = (),
    alone: bool = True,
) -> Shape:
    """Return the simplest solid with a body's inertia, or a ball for a particle.

    Where all three moments are equal that is a sphere, where two are a cylinder or disc about the
    third axis, else a box.

    Parameters
    ----------
    body : RigidBody or Particle
    values : mapping of symbols to float
        Those of all symbols at the first instant, for an inertia may be written in a frame in which
        the body turns.
    size : float
        That of the scene.
    arms : sequence of ndarray, shape (3,), optional
        From the mass centre to the ends of the bars that are drawn of the body. A solid that is
        not small beside the longest one is not drawn, or it would hide the mechanism; but where
        the arms span space, as those of a satellite do, it is drawn smaller.
    alone : bool, optional
        Whether no distance between points of the scene is known.
    """
    reach = max((float(np.linalg.norm(arm)) for arm in arms), default=0.0)
    ball = Sphere(BALL * size)
    if not isinstance(body, RigidBody):
        return ball
    # On the bars, of which it must not hide a short one, such as a link of a long chain.
    joint = Sphere(min(2 * BAR * size, reach / 2) if reach else 2 * BAR * size)
    numbers = {k: sm.Float(v) for k, v in values.items()}
    inertia = body.central_inertia.to_matrix(body.frame)
    try:
        moments = [float(sm.sympify(inertia[k, k]).xreplace(numbers)) for k in range(3)]
    except TypeError:  # a symbol without a value
        return joint if reach else ball
    try:
        mass = float(sm.sympify(body.mass).xreplace(numbers))
    except TypeError:  # the mass is not in the equations: choose a size, with correct proportions
        mass = 12 * max(moments) / (0.4 * size) ** 2
    if not mass > 0 or not max(moments) > 0 or not np.isfinite(moments).all():
        return joint if reach else ball
    if sum(moments) - 2 * max(moments) < -DIGITS * max(moments):
        # No solid has such an inertia: it is one for motion in a plane, without a size.
        if reach:
            return joint
        axis = int(np.argmax(moments))
        radius = float(np.sqrt(2 * moments[axis] / mass))
        if not alone:
            radius = min(radius, PLATE * size)
        return Cylinder(2 * _THINNEST * radius, radius, "xyz"[axis])
    solid, radius = _solid(moments, mass)
    if not reach or radius <= _COMPACT * reach:
        return solid
    if rank(np.array(arms)) < 3:
        return joint
    smaller = (_COMPACT * reach / radius) ** 2
    return _solid([smaller * moment for moment in moments], mass)[0]


def inertial_lengths(
    body: Body, shape: Shape, numbers: Mapping[AnySymbol, float]
) -> dict[str, sm.Expr]:
    """Return the lengths of a body's default shape as expressions of mass and inertia.

    The formulas are those of the default shape above: live pages change it with the constants.

    Empty if the inertia depends on more than constants, or if the size of the shape at the
    `numbers` of the constants does not follow from the inertia.
    """
    if not isinstance(body, RigidBody):
        return {}
    inertia, m = body.central_inertia.to_matrix(body.frame), sm.sympify(body.mass)
    moments = [sm.sympify(inertia[k, k]) for k in range(3)]
    if sm.Tuple(m, *moments).atoms(AppliedUndef):
        return {}

    def root(square: sm.Expr) -> sm.Expr:
        return sm.sqrt(sm.Max(square, 0))

    ix, iy, iz = moments
    lengths: dict[str, sm.Expr] = {}
    if isinstance(shape, Sphere):
        lengths = {"radius": root(sm.Rational(5, 2) * ix / m)}
    elif isinstance(shape, Cylinder):
        axial, transverse = moments["xyz".index(shape.axis)], moments["yzx".index(shape.axis)]
        radius = root(2 * axial / m)
        length = root((12 * transverse - 6 * axial) / m)
        solid = sm.Max(length, 2 * _THINNEST * radius)
        in_plane = {"radius": radius, "length": 2 * _THINNEST * radius}
        lengths = {"radius": sm.Max(radius, _THINNEST * length / 2), "length": solid}
        if not _are(lengths, shape, numbers):
            lengths = in_plane
    elif isinstance(shape, Box):
        edges = [root(6 * s / m) for s in (iy + iz - ix, iz + ix - iy, ix + iy - iz)]
        least = _THINNEST * sm.Max(*edges)
        lengths = {axis: sm.Max(edge, least) for axis, edge in zip("xyz", edges, strict=True)}
    return lengths if _are(lengths, shape, numbers) else {}


def _are(lengths: Mapping[str, sm.Expr], shape: Shape, numbers: Mapping[AnySymbol, float]) -> bool:
    """Return whether expressions are the lengths of a shape."""
    values_by_symbol = {symbol: sm.Float(value) for symbol, value in numbers.items()}
    try:
        values = {name: float(e.xreplace(values_by_symbol)) for name, e in lengths.items()}
    except TypeError:  # a symbol without a value, or a root of a negative number
        return False
    return all(abs(v - getattr(shape, n)) <= DIGITS * abs(v) for n, v in values.items())


def _solid(moments: Sequence[float], mass: float) -> tuple[Shape, float]:
    """Return the solid of uniform density with these moments, and the radius that it fills."""
    solid = _round_shape(moments, mass)
    if solid is None:
        # I_x = m (y² + z²) / 12 and so on: I_y + I_z − I_x = m x² / 6.
        edges = np.sqrt(np.maximum(6 * (sum(moments) - 2 * np.array(moments)) / mass, 0.0))
        solid = Box(*np.maximum(edges, _THINNEST * edges.max()).tolist())
    return solid, float(np.linalg.norm(surface(solid)[0], axis=1).max())


def _round_shape(moments: Sequence[float], mass: float) -> Shape | None:
    """Return the sphere or cylinder of uniform density with these moments, or None for a box."""
    greatest = max(moments)
    if np.ptp(moments) <= DIGITS * greatest:
        return Sphere(float(np.sqrt(2.5 * greatest / mass)))
    for k, axis in enumerate("xyz"):
        axial, (first, second) = moments[k], np.delete(moments, k)
        if abs(first - second) > DIGITS * greatest:
            continue
        # I = m r² / 2 about the axis, m (3 r² + l²) / 12 across it.
        radius = np.sqrt(2 * max(axial, 0.0) / mass)
        length = np.sqrt(max(12 * first / mass - 3 * radius**2, 0.0))
        size = max(2 * radius, length)
        thick = max(length, _THINNEST * size)
        return Cylinder(float(thick), float(max(radius, _THINNEST * size / 2)), axis)
    return None


_GREY = "#7d8796"  # visible on white and on nearly black
_SPOKE = 0.12  # width of a wheel's spoke and of its rim, as parts of the radius


def visuals_of(
    bodies: Iterable[Body], parts: Outline, inertial: ReferenceFrame | None = None
) -> list[Visual]:
    """Return visuals of bodies and of the parts of an Outline.

    A scene that is shown in another frame needs the `inertial` one for the supports.
    """
    visuals = []
    turning = () if inertial is None else (inertial,)
    for body in bodies:
        if body in parts.resting:
            visuals.append(Visual(Support(colour=_GREY), body))
        elif body in parts.wheels:
            visuals += _wheel(body, *parts.wheels[body])
        else:
            visuals.append(Visual(None, body))
    for body, pair in parts.bars:
        if body is None:
            visuals.append(Visual(Bar(pair, colour=_GREY), name="rods"))
        else:
            visuals.append(Visual(Bar(pair), body))
    visuals += [Visual(Line(pair, colour=_GREY), name="ropes") for pair in parts.ropes]
    visuals += [Visual(Spring(pair, colour=_GREY), name="springs") for pair in parts.springs]
    visuals += [Visual(Damper(pair, colour=_GREY), name="dampers") for pair in parts.dampers]
    for point in parts.supports:
        visuals.append(Visual(Support(colour=_GREY), *turning, point, name="ground"))
    return visuals


def _wheel(body: Body, radius: sm.Expr | float, axis: str | None) -> list[Visual]:
    """Return a ball, or a wheel about an axis with a spoke that shows how it turns."""
    if axis is None:
        return [Visual(Sphere(radius), body)]
    edges: dict[str, Any] = dict.fromkeys("xyz", _SPOKE * radius)
    edges["x" if axis != "x" else "y"] = 1.8 * radius
    edges[axis] = 1.3 * _SPOKE * radius
    wheel = Visual(Cylinder(_SPOKE * radius, radius, axis), body)
    return [wheel, Visual(Box(**edges, colour=_GREY), body)]


def load_arrows(bodies: Iterable[Body], loads: Iterable[Load]) -> list[Visual]:
    """Return arrows for forces at their points and torques at the mass centres of their bodies."""
    centres = {getattr(body, "frame", None): body.masscenter for body in bodies}
    arrows = []
    for target, vector in loads:
        point, name, colour = target, "forces", "#c93a3a"
        if isinstance(target, ReferenceFrame):
            point, name, colour = centres.get(target), "torques", "#7d4cc4"
        if point is not None and vector != Vector(0):
            arrow = Arrow(vector, scale=None, colour=colour)
            arrows.append(Visual(arrow, point, name=name))
    return arrows


def gravities(expression: sm.Expr) -> list[sm.Symbol]:
    """Return the symbols of an expression that are named like the acceleration of gravity."""
    return [s for s in find_symbols([expression]) if str(s) in ("g", "G", "gravity")]


def _constant_parts(weights: Sequence[sm.Expr], values: Mapping[AnySymbol, float]) -> np.ndarray:
    """Return the numbers of a weight's components, zero for those that depend on the state.

    A weight written in the axes of a body has sines and cosines that cancel. SymPy does not
    simplify them, so the components are compared at a few states.
    """
    symbols = find_symbols(weights)
    moving = sorted((s for s in symbols if not s.is_Symbol), key=str)
    numbers = {s: sm.Float(values.get(s, 1.0)) for s in symbols if s.is_Symbol}
    samples = []
    for state in np.random.default_rng(0).uniform(-1.0, 1.0, (3 if moving else 1, len(moving))):
        at = {**numbers, **dict(zip(moving, map(sm.Float, state), strict=True))}
        components = [replace_symbols(weight, at) for weight in weights]
        samples.append([float(n) if n.is_number and n.is_real else np.nan for n in components])
    rows = np.array(samples)
    steady = np.ptp(rows, axis=0) <= HALF * np.abs(np.nan_to_num(rows)).max()
    return np.where(steady, rows[0], 0.0)


def _weight_in(force: Vector) -> Vector:
    """Return the terms of a force that may be weights: with `g`, in axes that may turn."""

    def is_weight(term: sm.Expr) -> bool:
        turns = (sm.sin, sm.cos, AppliedUndef)
        others = (p for p in parts_of(term) if isinstance(p, Application))
        return bool(gravities(term)) and all(isinstance(p, turns) for p in others)

    parts = []
    for entries, frame in force.args:
        terms = [[*filter(is_weight, sm.Add.make_args(entry))] for entry in entries]
        if any(terms):
            parts.append((sm.Matrix([sm.Add(*of_entry) for of_entry in terms]), frame))
    return Vector(parts)


def guess_up(
    frame: ReferenceFrame,
    bodies: Iterable[Body],
    loads: Sequence[Load],
    values: Mapping[AnySymbol, float],
) -> str | None:
    """Return the axis of `frame` against which the weights pull, or None.

    A weight is the part of a force that is proportional to a symbol `g`, or a force at a mass
    centre that depends on the mass alone.
    """
    masses = {body.masscenter: sm.sympify(body.mass) for body in bodies}
    pull = np.zeros(3)
    for target, vector in loads:
        inside = [entry for part, _ in vector.args for entry in part]
        of_mass = find_symbols([masses[target]]) if target in masses else None
        is_weight = of_mass is not None and find_symbols(inside).keys() <= of_mass.keys()
        # SymPy takes minutes for the components of a tire's force in this frame, and for their
        # derivatives.
        weight = vector if is_weight else _weight_in(vector)
        if not weight.args:
            continue
        try:
            components = weight.to_matrix(frame)
        except ValueError:
            continue
        weights = []
        for component in map(sm.sympify, components):
            symbols = gravities(component)
            if len(symbols) == 1:
                weights.append(component.diff(symbols[0]))
            elif of_mass is not None and find_symbols([component]).keys() <= of_mass.keys():
                weights.append(component)
            else:
                weights.append(sm.S.Zero)
        pull += _constant_parts(weights, values)
    k = int(np.abs(pull).argmax())
    if not np.abs(pull[k]) > 10 * np.abs(np.delete(pull, k)).max():
        return None
    return ("-" if pull[k] > 0 else "") + "xyz"[k]


def unit_vector(value: object, frame: ReferenceFrame, argument: str) -> np.ndarray:
    """Return an axis such as '-z', a constant vector or three numbers as a unit array."""
    direction = np.zeros(3)
    if isinstance(value, (str, bytes)):
        if isinstance(value, str) and value.lstrip("+-") in ("x", "y", "z") and len(value) <= 2:
            direction["xyz".index(value[-1])] = -1.0 if value[0] == "-" else 1.0
    else:
        try:
            numbers = value.to_matrix(frame) if isinstance(value, Vector) else value
            if not isinstance(numbers, np.ndarray):
                numbers = listed(argument, numbers, "numbers")
            direction = real_array(numbers, "")
        except (TypeError, ValueError):
            pass
    length = float(np.linalg.norm(direction)) if direction.shape == (3,) else 0.0
    if not 0 < length < np.inf:
        raise ValueError(
            f"`{argument}` must be an axis of the scene's frame such as 'z' or '-y', a constant "
            f"vector, or three numbers that are not all zero, got {shown(value)}."
        )
    return direction / length
