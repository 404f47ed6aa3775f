"""Floors and walls of contacts: planes at rest in the scene, found from the gaps."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING, Any

import numpy as np
import sympy as sm
from sympy.physics.mechanics import ReferenceFrame

from pydy._rank import HALF
from pydy.viz.animation import Animation, Item
from pydy.viz.motion import Geometry, SceneMotion, compute_placement
from pydy.viz.shapes import Plane, Sphere, Support, Trace
from pydy.viz.surfaces import surface
from pydy.viz.visuals import Visual

if TYPE_CHECKING:
    from sympy.physics.mechanics import Point

_SAMPLES = 64  # random states; an affine function of position and orientation has 13 coefficients
_MARGIN = 0.15  # of a plane around the places above it, relative to the size of the scene
_COLOUR, _OPACITY = "#7d8796", 0.4


def floors_of(
    gaps: Mapping[str, sm.Expr],
    animation: Animation,
    motion: SceneMotion,
    seen_from: tuple[ReferenceFrame, Point],
    up_axis: np.ndarray,
) -> tuple[list[Visual], float | None]:
    """Return visuals of the planes that the visuals of an animation touch, and the ground's height.

    A gap belongs to a plane at rest with the unit normal n if it is n · (p + R d) + c for a visual
    at the position p with the rotation R, at any state. That is fitted at random states. With an
    offset d the plane goes through the point p + R d of the body. Without one, the gap is that of a
    ball about p or of something whose turning does not count, and the plane touches the shape.

    Horizontal planes below a body have no visual: the lowest is the ground.
    """
    sampled = _random_states(motion)
    items = [item for item in animation.items if _is_solid(item)]
    frames = dict.fromkeys(i.visual.frame for i in items if i.visual.frame is not None)
    points = dict.fromkeys(i.visual.point for i in items)
    geometry = Geometry(*seen_from, tuple(frames), tuple(points), (), tuple(gaps.items()))
    try:
        placed = compute_placement(geometry, sampled)
    except ValueError:  # a symbol without a value
        return [], None
    size = float(np.linalg.norm(np.subtract(*animation.box)))
    visuals, heights = [], []
    for name, gap in placed.series.items():
        planes = []
        for item in items:
            point, frame = placed.positions[item.visual.point], item.visual.frame
            turning = None if frame is None else placed.rotations[frame]
            if np.isfinite(gap).all() and (fitted := _fit(gap, point, turning)) is not None:
                normal, offset, constant = fitted
                arms = item.positions + item.rotations @ offset
                depth = 0.0 if offset.any() else _depth(item, normal, arms @ normal)
                planes.append((-constant - depth, normal, arms))
        if not planes:
            continue
        height, normal, feet = min(planes, key=lambda plane: plane[0])  # touches all visuals
        if np.abs(normal - up_axis).max() <= HALF:
            heights.append(height)
        else:
            visuals.append(
                _visual(name, seen_from, (height, normal, up_axis), feet, _MARGIN * size)
            )
    return visuals, min(heights, default=None)


def _random_states(motion: SceneMotion) -> SceneMotion:
    rng = np.random.default_rng(0)
    return SceneMotion(
        motion.names,
        rng.uniform(motion.times[0], motion.times[-1], _SAMPLES),
        rng.uniform(-1.0, 1.0, (_SAMPLES, motion.states.shape[1])),
        rng.uniform(-1.0, 1.0, (_SAMPLES, motion.specifieds.shape[1])),
        motion.constants,
    )


def _is_solid(item: Item) -> bool:
    return item.rigid and not isinstance(item.shape, (Plane, Support, Trace))


def _fit(
    gap: np.ndarray, positions: np.ndarray, rotations: np.ndarray | None
) -> tuple[np.ndarray, np.ndarray, float] | None:
    """Return n, d and c of the gap n · (p + R d) + c with a unit vector n, or None."""
    columns = positions if rotations is None else np.hstack([positions, rotations.reshape(-1, 9)])
    normal = _coefficients(columns, gap)[:3]
    scale = float(np.abs(positions).max() + np.abs(gap).max())
    normal[np.abs(normal) <= HALF] = 0.0
    # A body that turns about a fixed point has no unique normal; its least one is shorter.
    if abs(float(normal @ normal) - 1.0) > HALF:
        return None
    rest, offset = gap - positions @ normal, np.zeros(3)
    if rotations is not None and np.ptp(rest) > HALF * scale:
        levers = np.einsum("mij,i->mj", rotations, normal)
        offset = _coefficients(levers, rest)
        rest = rest - levers @ offset
    if np.ptp(rest) > HALF * scale:
        return None
    return normal, offset, float(rest.mean())


def _coefficients(columns: np.ndarray, values: np.ndarray) -> np.ndarray:
    """Return the least coefficients of columns, whose sum follows values up to a constant."""
    centred = columns - columns.mean(axis=0)
    result: np.ndarray = np.linalg.lstsq(centred, values - values.mean(), rcond=HALF)[0]
    return result


def _depth(item: Item, normal: np.ndarray, heights: np.ndarray) -> float:
    """Return how far a shape reaches below its point where it is lowest; a particle does not."""
    if item.visual.shape is None and item.visual.frame is None:
        return 0.0
    if isinstance(item.shape, Sphere):
        return float(item.shape.radius)
    vertices = surface(item.shape)[0] @ item.rotations[int(np.argmin(heights))].T
    return float(-(vertices @ normal).min())


def _visual(
    name: str,
    seen_from: tuple[ReferenceFrame, Point],
    plane: tuple[float, np.ndarray, np.ndarray],
    feet: np.ndarray,
    margin: float,
) -> Visual:
    """Return a rectangle in a plane, below the places where something moved."""
    (reference, origin), (height, normal, up_axis) = seen_from, plane
    steepest = up_axis - (up_axis @ normal) * normal
    if np.abs(steepest).max() <= HALF:  # a ceiling
        steepest = np.eye(3)[int(np.abs(normal).argmin())]
        steepest = steepest - (steepest @ normal) * normal
    steepest = steepest / np.linalg.norm(steepest)
    axes = np.array([steepest, np.cross(normal, steepest), normal])
    across = feet @ axes[:2].T
    low, high = across.min(axis=0), across.max(axis=0)
    center = np.array([*(low + high) / 2, height]) @ axes
    frame = ReferenceFrame(name)
    frame.orient_explicit(reference, sm.Matrix(axes.T.tolist()))
    point = origin.locatenew(name, _vector(reference, center))
    length, width = (high - low + 2 * margin).tolist()
    return Visual(Plane(length, width, colour=_COLOUR, opacity=_OPACITY), frame, point, name=name)


def _vector(frame: ReferenceFrame, components: Sequence[float] | np.ndarray) -> Any:
    x, y, z = map(float, components)
    return x * frame.x + y * frame.y + z * frame.z
