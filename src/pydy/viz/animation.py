"""A scene in motion: poses at the instants shown, shapes with numbers, and the camera."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field, replace
from typing import TYPE_CHECKING, Any

import numpy as np
import scipy

from pydy._interpolation import evenly
from pydy.viz.arguments import round_number
from pydy.viz.colours import CYCLE
from pydy.viz.curves import TimeSeries
from pydy.viz.defaults import BAR, default_shape
from pydy.viz.motion import Geometry, Placement, SceneMotion, compute_placement
from pydy.viz.shapes import Arrow, Bar, Cube, Damper, Line, Plane, Shape, Spring, Support, Trace
from pydy.viz.surfaces import arrow, coil, piston, rods, surface
from pydy.viz.visuals import Visual

if TYPE_CHECKING:
    from numpy.typing import ArrayLike
    from sympy.physics.mechanics import Point, ReferenceFrame

# -- View of a scene: the camera, the ground, and the path that the camera follows -----------------


@dataclass(frozen=True)
class ViewSettings:
    """The user's settings of the view."""

    up_axis: np.ndarray  # (3,): a unit vector, as `view`
    ground: bool | float | None = None
    follow: bool | None = None
    view: np.ndarray | None = None  # (3,): from the scene to the camera
    title: str = ""
    axes: float | None = None  # length of the axes at the origin
    # units of the series, and factors that their values are multiplied by
    units: Mapping[str, tuple[str, float]] = field(default_factory=dict)


@dataclass(frozen=True, eq=False)
class Framing:
    """Camera, ground and visible box of a scene."""

    # up_axis, right, direction: (3,); unit vectors; `right` is level, `direction` points from the
    # scene to the camera
    up_axis: np.ndarray
    right: np.ndarray
    direction: np.ndarray
    target: np.ndarray  # (3,): what the camera looks at, at the first instant
    extent: np.ndarray  # (3,): edges of the box about the target that is to be seen
    ground: float | None  # height of the grid along `up_axis`
    cell: float  # of the grid: 1, 2 or 5 times a power of ten
    path: np.ndarray | None  # (m, 3): displacement of the target

    @property
    def radius(self) -> float:
        """Half the diagonal of the box."""
        return float(np.linalg.norm(self.extent)) / 2


def frame(animation: Animation, settings: ViewSettings) -> Framing:
    """Return the framing of an animation, with defaults for missing settings."""
    up_axis = settings.up_axis
    low, high = animation.box
    path = _path(animation, up_axis)
    # The box relative to a camera that follows at constant height: the ground stays in view.
    rows = np.linspace(0, len(path) - 1, len(animation.bounds)).astype(int)
    relative_bounds = animation.bounds - path[rows, None]
    near, far = relative_bounds[:, 0].min(0), relative_bounds[:, 1].max(0)
    follow = settings.follow
    if follow is None:
        follow = np.linalg.norm(high - low) > 3 * np.linalg.norm(far - near)
    if follow:  # what travels is framed, however far away things at rest are
        moving = [animation.items[k].reach(rows) for k in followed(animation.items)]
        if moving:
            relative = np.stack(moving) - path[rows, None]
            near, far = relative[:, :, 0].min((0, 1)), relative[:, :, 1].max((0, 1))
        low, high = near, far
    extent = high - low
    if not extent.any():
        extent = np.ones(3)
    right, depth = _level_axes(up_axis, extent)
    direction = settings.view
    if direction is None:
        cloud = np.concatenate([item.positions for item in animation.items])
        flat = np.ptp(cloud @ depth) < 0.02 * np.ptp(cloud @ right)
        is_level = np.ptp(cloud @ up_axis) < 0.02 * np.ptp(cloud @ right)
        if is_level and settings.ground is False:  # a plan: nothing says that it lies on a floor
            direction = up_axis + 0.35 * depth
        else:
            direction = depth + (
                0.25 * right + 0.2 * up_axis if flat else 0.55 * right + 0.45 * up_axis
            )
        direction = direction / np.linalg.norm(direction)
    height = None
    if settings.ground is None and animation.ground is not None:
        height = animation.ground
    elif settings.ground is None or settings.ground is True:
        low_ends, high_ends = animation.bounds[:, 0] * up_axis, animation.bounds[:, 1] * up_axis
        height = float(np.minimum(low_ends, high_ends).sum(1).min())
    elif settings.ground is not False:
        height = float(settings.ground)
    return Framing(
        up_axis=up_axis,
        right=right,
        direction=direction,
        target=(low + high) / 2,
        extent=extent,
        ground=height,
        cell=round_number(float(np.linalg.norm(extent)) / 8),
        path=path if follow else None,
    )


def frame_still(animation: Animation, settings: ViewSettings, t: float) -> Framing:
    """Return the framing of one instant; ground and direction of view are those of the motion."""
    framing, instant = frame(animation, settings), animation.at(t)
    items = [item for item in instant.items if not isinstance(item.shape, Plane)] or instant.items
    boxes = [item.reach(np.zeros(1, dtype=int))[0] for item in items]
    boxes += [path for k in range(len(instant.items)) if (path := animation.path(k, t)) is not None]
    cloud = np.concatenate(boxes)
    low, high = cloud.min(0), cloud.max(0)
    if framing.ground is not None and (settings.ground is None or settings.ground is True):
        middle = (low + high) / 2
        foot = middle - (middle @ framing.up_axis - framing.ground) * framing.up_axis
        low, high = np.minimum(low, foot), np.maximum(high, foot)
    extent = high - low
    if not extent.any():
        return replace(framing, target=low, path=None)
    cell = round_number(float(np.linalg.norm(extent)) / 8)
    return replace(framing, target=(low + high) / 2, extent=extent, cell=cell, path=None)


def _level_axes(up_axis: np.ndarray, extent: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Return the level axis along which the scene is longer, and the other, towards the viewer."""
    level = np.eye(3) - np.outer(up_axis, up_axis)
    # For an oblique up axis, the two axes that are closest to level.
    axes = sorted(np.eye(3), key=lambda e: abs(float(e @ up_axis)))[:2]
    # Edges of equal length up to rounding are sorted by axis.
    unit = float(np.linalg.norm(extent))
    axes.sort(key=lambda e: (-round(float(e @ extent) / unit, 9), int(e.argmax())))
    right = level @ axes[0]
    right /= np.linalg.norm(right)
    return right, np.cross(right, up_axis)


def followed(items: Sequence[Item]) -> list[int]:
    """Return the indices of the moving visuals, whose centre the camera follows."""
    moving = (np.ptp(i.positions, axis=0).any() and not isinstance(i.shape, Plane) for i in items)
    return [k for k, is_moving in enumerate(moving) if is_moving]


def _path(animation: Animation, up_axis: np.ndarray) -> np.ndarray:
    """Return the smoothed path of the centre of the moving visuals."""
    moving = followed(animation.items) or [0]
    path = np.mean([animation.items[k].positions for k in moving], axis=0)
    path -= path[0]
    level: np.ndarray = path - np.outer(path @ up_axis, up_axis)
    return level


# -- The animation ---------------------------------------------------------------------------------


@dataclass(frozen=True, eq=False)
class Item:
    """A visual with its numbers at m instants."""

    visual: Visual
    shape: Shape  # with numbers for lengths, and a colour
    rotations: np.ndarray  # (m, 3, 3)
    positions: np.ndarray  # (m, 3)
    vectors: np.ndarray | None = None  # (m, 3): of an Arrow, scaled
    points: np.ndarray | None = None  # (m, k, 3): of a Line

    @property
    def rigid(self) -> bool:
        """Whether it is a rigid body: its triangles only rotate and translate."""
        return self.vectors is None and self.points is None and not isinstance(self.shape, Trace)

    def surface(self, k: int = 0) -> tuple[np.ndarray, np.ndarray] | None:
        """Return the triangles at instant k in the scene's frame, or None for thin lines."""
        if self.vectors is not None:
            assert isinstance(self.shape, Arrow)
            return arrow(self.positions[k], self.vectors[k], self.shape.radius)
        if self.points is not None:
            assert isinstance(self.shape, Line)
            if self.shape.radius is None:
                return None
            if isinstance(self.shape, Spring):
                return coil(self.points[k], self.shape.radius, self.shape.coils)
            if isinstance(self.shape, Damper):
                return piston(self.points[k], self.shape.radius, self.tube)
            return rods(self.points[k], self.shape.radius)
        if isinstance(self.shape, Trace):
            return None
        vertices, faces = surface(self.shape)
        return vertices @ self.rotations[k].T + self.positions[k], faces

    @property
    def tube(self) -> float:
        """Length of a damper's tube: most of the shortest distance between its ends."""
        assert self.points is not None
        lengths = np.linalg.norm(self.points[:, 1] - self.points[:, 0], axis=1)
        return 0.6 * float(lengths.min())

    def reach(self, rows: np.ndarray) -> np.ndarray:
        """Return the lowest and highest coordinates at some instants, shape (len(rows), 2, 3)."""
        if self.points is not None:
            cloud = self.points[rows]
        elif self.vectors is not None:
            cloud = np.stack([self.positions[rows], (self.positions + self.vectors)[rows]], 1)
        elif isinstance(self.shape, Trace):
            cloud = self.positions[rows][:, None]
        else:
            vertices = surface(self.shape)[0]
            if len(vertices) > 600:  # for a mesh the corners of its box suffice
                ends = np.stack([vertices.min(0), vertices.max(0)])
                vertices = np.array(np.meshgrid(*ends.T)).reshape(3, -1).T
            cloud = np.einsum("mij,nj->mni", self.rotations[rows], vertices)
            cloud += self.positions[rows][:, None]
        return np.stack([cloud.min(1), cloud.max(1)], 1)


@dataclass(frozen=True, eq=False)
class Animation:
    """A scene's motion, ready to be drawn."""

    times: np.ndarray  # (m,)
    items: tuple[Item, ...]
    bounds: np.ndarray  # (m', 2, 3): the box around everything but planes at some of the instants
    series: Mapping[str, TimeSeries] = field(default_factory=dict)  # each with its own times
    speed: float = 1.0  # seconds of motion for each second shown
    events: tuple[tuple[float, str], ...] = ()  # (time, name)
    # Of each contact: (from, to, mode)
    modes: Mapping[str, Sequence[tuple[float, float, str]]] = field(default_factory=dict)
    ground: float | None = None  # height of a horizontal floor of contacts

    @property
    def poses(self) -> np.ndarray:
        """Poses of all visuals, shape (m, v, 4, 4)."""
        result = np.zeros((len(self.times), len(self.items), 4, 4))
        for k, item in enumerate(self.items):
            result[:, k, :3, :3] = item.rotations
            result[:, k, :3, 3] = item.positions
        result[..., 3, 3] = 1.0
        return result

    @property
    def box(self) -> tuple[np.ndarray, np.ndarray]:
        """The lowest and the highest coordinates of the motion."""
        return self.bounds[:, 0].min(0), self.bounds[:, 1].max(0)

    def path(self, k: int, t: float) -> np.ndarray | None:
        """Return the path, (m', 3), that visual k has travelled until a time, or None."""
        item, past = self.items[k], self.times <= t
        if not (isinstance(item.shape, Trace) or item.visual.trail):
            return None
        if isinstance(item.shape, Trace) and item.shape.duration is not None:
            past &= self.times >= t - item.shape.duration
        positions: np.ndarray = item.positions[past]
        return positions

    def at(self, t: ArrayLike) -> Animation:
        """Return the animation at one time or several, interpolated between the instants shown."""
        times, last = self.times, len(self.times) - 1
        instants = np.clip(np.atleast_1d(np.asarray(t, dtype=float)), times[0], times[-1])
        k = np.clip(np.searchsorted(times, instants, side="right") - 1, 0, max(last - 1, 0))
        after = np.minimum(k + 1, last)
        gap = times[after] - times[k]
        part = np.where(gap > 0, (instants - times[k]) / np.where(gap > 0, gap, 1.0), 0.0)
        interpolated = np.flatnonzero(part)
        done: dict[int, np.ndarray] = {}  # rotations that several visuals share

        def blend(a: np.ndarray) -> np.ndarray:
            share = part.reshape(-1, *[1] * (a.ndim - 1))
            mixed: np.ndarray = (1 - share) * a[k] + share * a[after]
            return mixed

        def interpolate_rotations(r: np.ndarray) -> np.ndarray:
            if id(r) not in done:
                rows = np.array(r[k])
                if interpolated.size:
                    Rotation = scipy.spatial.transform.Rotation
                    first = Rotation.from_matrix(rows[interpolated])
                    second = Rotation.from_matrix(np.array(r[after[interpolated]]))
                    rotation_vector = (first.inv() * second).as_rotvec() * part[interpolated, None]
                    rows[interpolated] = (first * Rotation.from_rotvec(rotation_vector)).as_matrix()
                done[id(r)] = rows
            return done[id(r)]

        items = []
        for item in self.items:
            arrays = {k: getattr(item, k) for k in ("positions", "vectors", "points")}
            moved: dict[str, Any] = {k: blend(a) for k, a in arrays.items() if a is not None}
            items.append(replace(item, rotations=interpolate_rotations(item.rotations), **moved))
        return Animation(instants, tuple(items), self.bounds)


def animate(
    reference: ReferenceFrame,
    origin: Point,
    visuals: Sequence[Visual],
    motion: SceneMotion,
) -> Animation:
    """Return the Animation of a motion at the instants to show."""
    frames = dict.fromkeys(v.frame for v in visuals if v.frame is not None)
    points = dict.fromkeys(v.point for v in visuals)
    for visual in visuals:
        if isinstance(visual.shape, Line):
            points.update(dict.fromkeys(visual.shape.points))
    arrows = [v for v in visuals if isinstance(v.shape, Arrow)]
    vectors = tuple(v.shape.vector for v in arrows if isinstance(v.shape, Arrow))
    geometry = Geometry(reference, origin, tuple(frames), tuple(points), vectors)
    placed = compute_placement(geometry, motion)
    _check(placed, geometry, motion.times)
    return _assemble(visuals, placed, motion)


def _check(placed: Placement, geometry: Geometry, times: np.ndarray) -> None:
    """Refuse numbers that are not finite, naming the visual that has them."""
    named = [(f"The orientation of `{f}`", a) for f, a in placed.rotations.items()]
    named += [(f"The position of `{p}`", a) for p, a in placed.positions.items()]
    for k, vector in enumerate(geometry.vectors):
        named.append((f"The arrow `{vector}`", placed.vectors[:, k]))
    for description, array in named:
        bad = np.flatnonzero(~np.isfinite(array.reshape(len(times), -1)).all(axis=1))
        if bad.size:
            raise ValueError(
                f"{description} is not finite at t = {times[bad[0]]:g}: its expression has no "
                "value for this state and these constants. Does a constant lack its value?"
            )


def _assemble(visuals: Sequence[Visual], placed: Placement, motion: SceneMotion) -> Animation:
    m = len(motion.times)
    identity = np.broadcast_to(np.eye(3), (m, 3, 3))
    size, alone = _size(placed)
    # A default shape may depend on the state, too; all others depend on constants only.
    constants = motion.values
    first = {motion.names.time: float(motion.times[0]), **constants}
    first.update(zip(motion.names.states, motion.states[0].tolist(), strict=True))
    first.update(zip(motion.names.specifieds, motion.specifieds[0].tolist(), strict=True))
    colours: dict[str, str] = {}
    scales = _scales(visuals, placed, size)
    items, arrows = [], 0
    arms = _arms(visuals, placed)
    for visual in visuals:
        own_arms = arms.get(id(visual.body), ())
        shape = visual.shape or default_shape(visual.body, first, size, own_arms, alone)
        shape = _suited(shape.measured(constants), size)
        if shape.colour is None:
            colour = colours.setdefault(visual.name, CYCLE[len(colours) % len(CYCLE)])
            shape = replace(shape, colour=colour)
        vector = line = None
        if isinstance(shape, Arrow):
            shape = replace(shape, scale=scales[visual.name, shape.scale])
            vector = placed.vectors[:, arrows] * shape.scale
            arrows += 1
            if shape.radius is None:
                shape = replace(shape, radius=0.01 * size)
        if isinstance(shape, Line):
            line = np.stack([placed.positions[p] for p in shape.points], 1)
        rotations = identity if visual.frame is None else placed.rotations[visual.frame]
        items.append(Item(visual, shape, rotations, placed.positions[visual.point], vector, line))
    rows = evenly(m, 150)
    framed = [i for i in items if not isinstance(i.shape, Plane)] or items
    reach = np.stack([item.reach(rows) for item in framed])
    bounds = np.stack([reach[:, :, 0].min(0), reach[:, :, 1].max(0)], 1)
    return Animation(motion.times, tuple(items), bounds)


def _scales(
    visuals: Sequence[Visual], placed: Placement, size: float
) -> dict[tuple[str, float | None], float]:
    """Return lengths of arrows per unit of their vectors, by name, with the user's own scales."""
    longest: dict[str, np.ndarray] = {}
    arrows = [v for v in visuals if isinstance(v.shape, Arrow)]
    for k, visual in enumerate(arrows):
        lengths = np.linalg.norm(placed.vectors[:, k], axis=1)
        longest[visual.name] = np.maximum(longest.get(visual.name, 0.0), lengths)
    scales: dict[tuple[str, float | None], float] = {}
    for visual in arrows:
        assert isinstance(visual.shape, Arrow)
        user_scale = visual.shape.scale
        scales[visual.name, user_scale] = (
            size * _arrow_scale(longest[visual.name]) if user_scale is None else float(user_scale)
        )
    return scales


def _arrow_scale(longest: np.ndarray) -> float:
    """Return the scale for a scene of size 1 and the longest of some arrows at each instant.

    The longest arrow is a third of the scene. If that is a short peak, which would make all other
    arrows too small to see, the peak may be as long as the scene.
    """
    peak = float(longest.max())
    usual = float(np.quantile(longest, 0.9))
    return 1.0 / max(3.0 * usual, peak) if peak else 1.0


def _suited(shape: Shape, size: float) -> Shape:
    """Return a shape with missing sizes chosen to suit the scene."""
    if isinstance(shape, Support):
        return Cube(4 * BAR * size, colour=shape.colour, opacity=shape.opacity)
    if isinstance(shape, Bar) and shape.radius is None:
        thick = {Spring: 2.5 * BAR, Damper: 0.8 * BAR}.get(type(shape), BAR)
        return replace(shape, radius=thick * size)
    return shape


def _arms(visuals: Sequence[Visual], placed: Placement) -> dict[int, list[np.ndarray]]:
    """Return the vectors from the mass centres of bodies to the ends of their bars."""
    arms: dict[int, list[np.ndarray]] = {}
    for visual in visuals:
        if visual.body is not None and isinstance(visual.shape, Bar):
            centre = placed.positions[visual.point][0]
            ends = [placed.positions[p][0] - centre for p in visual.shape.points]
            arms.setdefault(id(visual.body), []).extend(ends)
    return arms


def _size(placed: Placement) -> tuple[float, bool]:
    """Return the size of the scene, and whether all its points coincide."""
    cloud = np.stack(list(placed.positions.values()))
    extent = float(np.linalg.norm(np.ptp(cloud, axis=0), axis=-1).max())
    travel = float(np.linalg.norm(np.ptp(cloud, axis=(0, 1))))
    return extent or travel or 1.0, not extent
