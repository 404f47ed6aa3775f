"""From where a scene is seen: the camera, the ground, and what they follow."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field, replace

import numpy as np

from pydy.viz.animation import Animation
from pydy.viz.shapes import Plane
from pydy.viz.tuning import ROUND

__all__ = ["Framing", "Look", "frame"]


@dataclass(frozen=True)
class Look:
    """What the user said about how the scene is to be seen.

    Attributes
    ----------
    up : ndarray, shape (3,)
        A unit vector, as `view`.
    ground : bool, float or None
    follow : bool or None
    view : ndarray, shape (3,), or None
        From the scene to the camera.
    title : str
    axes : float or None
        Length of the axes at the origin.
    units : mapping of str to str
        Of the series.
    """

    up: np.ndarray
    ground: bool | float | None = None
    follow: bool | None = None
    view: np.ndarray | None = None
    title: str = ""
    axes: float | None = None
    units: Mapping[str, str] = field(default_factory=dict)


@dataclass(frozen=True, eq=False)
class Framing:
    """How the scene is seen.

    Attributes
    ----------
    up, right, direction : ndarray, shape (3,)
        Unit vectors; `right` is level, `direction` points from the scene to the camera.
    target : ndarray, shape (3,)
        What the camera looks at, at the first instant.
    extent : ndarray, shape (3,)
        Edges of the box about the target that is to be seen.
    ground : float or None
        Height of the grid along `up`.
    cell : float
        Of the grid: 1, 2 or 5 times a power of ten.
    path : ndarray, shape (m, 3), or None
        By how much the target moves along.
    """

    up: np.ndarray
    right: np.ndarray
    direction: np.ndarray
    target: np.ndarray
    extent: np.ndarray
    ground: float | None
    cell: float
    path: np.ndarray | None

    @property
    def radius(self) -> float:
        """Half the diagonal of the box."""
        return float(np.linalg.norm(self.extent)) / 2

    def scaled(self, factor: float) -> Framing:
        """Return the same view of a scene whose lengths are multiplied by a number."""
        return replace(
            self,
            target=factor * self.target,
            extent=factor * self.extent,
            ground=None if self.ground is None else factor * self.ground,
            cell=factor * self.cell,
            path=None if self.path is None else factor * self.path,
        )


def frame(animation: Animation, look: Look) -> Framing:
    """Return how an animation is best seen."""
    up = look.up
    low, high = animation.box
    path = _path(animation, up)
    # What is seen by a camera that goes along, but keeps its height: the ground stays in view.
    rows = np.linspace(0, len(path) - 1, len(animation.bounds)).astype(int)
    seen = animation.bounds - path[rows, None]
    near, far = seen[:, 0].min(0), seen[:, 1].max(0)
    follow = look.follow
    if follow is None:
        follow = np.linalg.norm(high - low) > 3 * np.linalg.norm(far - near)
    if follow:
        low, high = near, far
    extent = high - low
    if not extent.any():
        extent = np.ones(3)
    right, depth = _level_axes(up, extent)
    direction = look.view
    if direction is None:
        cloud = np.concatenate([item.positions for item in animation.items])
        flat = np.ptp(cloud @ depth) < 0.02 * np.ptp(cloud @ right)
        direction = depth + (0.25 * right + 0.2 * up if flat else 0.55 * right + 0.45 * up)
        direction = direction / np.linalg.norm(direction)
    height = None
    if look.ground is None or look.ground is True:
        height = float(np.minimum(animation.bounds[:, 0] * up, animation.bounds[:, 1] * up).sum(1)
                       .min())  # fmt: skip
    elif look.ground is not False:
        height = float(look.ground)
    return Framing(
        up=up,
        right=right,
        direction=direction,
        target=(low + high) / 2,
        extent=extent,
        ground=height,
        cell=_nice(float(np.linalg.norm(extent)) / 8),
        path=path if follow else None,
    )


def _level_axes(up: np.ndarray, extent: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Return the level axis along which the scene is longer, and the other, towards the viewer."""
    level = np.eye(3) - np.outer(up, up)
    # Of a slanting `up`, the two axes that are closest to level.
    axes = sorted(np.eye(3), key=lambda e: abs(float(e @ up)))[:2]
    # Edges that are as long but for rounding are in their usual order.
    unit = float(np.linalg.norm(extent))
    axes.sort(key=lambda e: (-round(float(e @ extent) / unit, 9), int(e.argmax())))
    right = level @ axes[0]
    right /= np.linalg.norm(right)
    return right, np.cross(right, up)


def _path(animation: Animation, up: np.ndarray) -> np.ndarray:
    """Return how the middle of what moves moves, levelled."""
    moving = [
        item.positions
        for item in animation.items
        if np.ptp(item.positions, axis=0).any() and not isinstance(item.shape, Plane)
    ] or [animation.items[0].positions]
    path = np.mean(moving, axis=0)
    path -= path[0]
    level: np.ndarray = path - np.outer(path @ up, up)
    return level


def _nice(value: float) -> float:
    power = 10.0 ** np.floor(np.log10(value))
    return float(power * max(k for k in (1, 2, 5) if k * power <= value * (1 + ROUND)))
