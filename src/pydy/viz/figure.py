"""The scene in Matplotlib: pictures for papers, films for slides."""

from __future__ import annotations

from collections.abc import Iterable
from pathlib import Path
from typing import Any

import numpy as np

from pydy._files import replacing
from pydy._optional import require
from pydy.viz.animation import Animation, Item
from pydy.viz.framing import Framing, Look, frame
from pydy.viz.shapes import Circle, Line, Mesh, Plane, Trace
from pydy.viz.surfaces import Surface, surface
from pydy.viz.triangles import Part, make_triangles, normals

__all__ = ["draw", "save"]

_PICTURES = (".png", ".pdf", ".svg", ".jpg", ".jpeg")
_FILMS = (".mp4", ".gif")
_OPEN = (Circle, Mesh, Plane)  # both sides of these may be seen
_GRAZING = 0.25  # of normals, by how much they may point away from the viewer


def draw(animation: Animation, look: Look, t: float, axes: Any = None) -> Any:
    """Draw an animation at a time; return the axes."""
    require("matplotlib", "plot", "A picture or film of a scene")
    seen = frame(animation, look)
    if axes is None:
        from matplotlib.figure import Figure

        axes = _whole(Figure(figsize=(7, 5)))
    elif not hasattr(axes, "add_collection3d"):
        raise TypeError(
            "`axes` must be three-dimensional, made with subplot(projection='3d'), got the "
            f"{type(axes).__name__} {axes!r}."
        )
    _Drawing(animation, animation.at(t), seen, axes, look.title).draw(0)
    return axes


def save(
    animation: Animation,
    look: Look,
    speed: float,
    path: Path,
    fps: float,
    dpi: float,
    size: tuple[float, float],
    progress: bool,
) -> None:
    """Save a film or a picture, as the suffix of the path says."""
    suffix = path.suffix.lower()
    if suffix not in _PICTURES + _FILMS:
        raise ValueError(
            f"`path` is '{path}', but its suffix must be one of {', '.join(_FILMS + _PICTURES)}. "
            "For a page in the browser call `to_html`."
        )
    require("matplotlib", "plot", "A picture or film of a scene")
    from matplotlib.figure import Figure

    figure = Figure(figsize=size, dpi=dpi)
    seen, axes = frame(animation, look), _whole(figure)
    start, end = float(animation.times[0]), float(animation.times[-1])
    if suffix in _PICTURES:
        _Drawing(animation, animation.at(start), seen, axes, look.title).draw(0)
        with replacing(path) as (place,):
            figure.savefig(place, dpi=dpi)
        return
    from pydy.viz.films import save_gif, save_mp4

    count = max(1, round((end - start) / speed * fps)) + 1
    shown = animation.at(np.linspace(start, end, count))
    drawing = _Drawing(animation, shown, seen, axes, look.title, make_triangles(axes))
    rows: Iterable[int] = range(count)
    if progress:
        rows = require("tqdm.auto", "ensemble", "`progress=True`").tqdm(rows)
    with replacing(path) as (place,):
        (save_gif if suffix == ".gif" else save_mp4)(drawing, rows, place, fps)


def _whole(figure: Any) -> Any:
    """Return Axes that are as large as their figure: what is beyond them is beyond the picture."""
    return figure.add_axes((0.0, 0.0, 1.0, 1.0), projection="3d")


def _rgb(colour: str) -> np.ndarray:
    return np.array([int(colour[k : k + 2], 16) for k in (1, 3, 5)]) / 255


class _Drawing:
    """Draws the instants `shown` of an animation into one Axes3D, whose artists it makes once.

    A film passes `triangles`, one artist for all surfaces.
    """

    def __init__(
        self,
        animation: Animation,
        shown: Animation,
        seen: Framing,
        axes: Any,
        title: str,
        triangles: Any = None,
    ) -> None:
        self.animation = animation
        self.shown = shown
        self.triangles = triangles
        self.solids: dict[int, Surface] = {}
        self.seen = seen
        self.axes = axes
        self.title = title
        # Matplotlib's z is up; rows are its axes in the scene's frame.
        depth = np.cross(seen.right, seen.up)
        self.turn = np.stack([seen.right, -depth, seen.up])
        self.light = self.turn @ (0.9 * depth + 0.7 * seen.right + 2.2 * seen.up)
        self.light /= np.linalg.norm(self.light)
        self.view = self.turn @ seen.direction
        self.artists: dict[tuple[int, str], Any] = {}
        self.grid: Any = None
        self.target: np.ndarray | None = None  # what the camera looks at
        self.zoom = 1.0

    @property
    def colours(self) -> list[np.ndarray]:
        """The colours of the visuals."""
        return [_rgb(colour) for colour in sorted({i.shape.colour for i in self.shown.items})]

    def draw(self, k: int) -> None:
        """Draw instant k of those to be shown."""
        seen, t = self.seen, float(self.shown.times[k])
        target = seen.target.copy()
        if seen.path is not None:
            row = [np.interp(t, self.animation.times, seen.path[:, i]) for i in range(3)]
            target += np.array(row)
        if self.target is None or not np.array_equal(target, self.target):
            self._frame(target)
        self.target = target
        parts = []
        for number, (item, whole) in enumerate(
            zip(self.shown.items, self.animation.items, strict=True)
        ):
            colour, shape = item.shape.colour, item.shape
            if isinstance(shape, Trace) or item.visual.trail:
                past = self.animation.times <= t
                if isinstance(shape, Trace) and shape.duration is not None:
                    past &= self.animation.times >= t - shape.duration
                path = np.concatenate([whole.positions[past], item.positions[k : k + 1]])
                self._line((number, "path"), path, color=colour, linewidth=1.2, alpha=0.8)
            if isinstance(shape, Line) and shape.radius is None and item.points is not None:
                self._line((number, "line"), item.points[k], color=colour, linewidth=1.5)
            solid = self._solid(number, item, k)
            if solid is None:
                continue
            vertices, faces = solid
            closed = shape.opacity == 1.0 and not isinstance(shape, _OPEN)
            if self.triangles is None:
                self._surface((number, "surface"), vertices[faces], colour, shape.opacity, closed)
            else:
                rgba = np.append(_rgb(colour), shape.opacity)
                parts.append(Part(vertices, faces, rgba, closed))
        if self.triangles is not None:
            self.triangles.set_parts(parts, self.light)

    def _solid(self, number: int, item: Item, k: int) -> Surface | None:
        """Return an item's triangles in Matplotlib's axes."""
        if item.rigid:  # its triangles only turn and move
            if number not in self.solids:
                self.solids[number] = surface(item.shape)
            vertices, faces = self.solids[number]
            turn = (self.turn @ item.rotations[k]).T
            return vertices @ turn + self.turn @ item.positions[k], faces
        triangles = item.surface(k)
        if triangles is None:
            return None
        vertices, faces = triangles
        return vertices @ self.turn.T, faces

    def _line(self, key: tuple[int, str], points: np.ndarray, **style: Any) -> None:
        columns = self.turn @ points.T
        if key in self.artists:
            self.artists[key].set_data_3d(*columns)
        else:
            (self.artists[key],) = self.axes.plot(*columns, clip_on=False, **style)

    def _surface(
        self,
        key: tuple[int, str],
        corners: np.ndarray,
        colour: str,
        opacity: float,
        closed: bool,
    ) -> None:
        from mpl_toolkits.mplot3d.art3d import Poly3DCollection

        normal = normals(corners)
        if closed:
            # Half of a closed surface is behind the other half; less, for the perspective.
            seen = normal @ self.view > -_GRAZING
            corners, normal = corners[seen], normal[seen]
        bright = 0.7 + 0.3 * normal @ self.light
        rgba = np.column_stack([bright[:, None] * _rgb(colour), np.full(len(bright), opacity)])
        if key not in self.artists:
            self.artists[key] = Poly3DCollection(
                corners, facecolors=rgba, edgecolors=rgba, linewidths=0.3, clip_on=False
            )
            self.axes.add_collection3d(self.artists[key])
            return
        self.artists[key].set_verts(corners)
        # Without edges the seams between triangles shine through.
        self.artists[key].set_facecolor(rgba)
        self.artists[key].set_edgecolor(rgba)

    def _fit(self, middle: np.ndarray, edges: np.ndarray) -> None:
        """Choose the zoom with which the box to be seen just fits into the picture."""
        from mpl_toolkits.mplot3d.proj3d import proj_transform

        axes, half = self.axes, np.abs(self.turn) @ self.seen.extent / 2
        signs = np.stack(np.meshgrid(*[[-1.0, 1.0]] * 3), -1).reshape(-1, 3)
        corners = (middle + signs * half).T
        whole, titled = axes.figure.bbox, 30.0 if self.title else 0.0
        low, high = np.array([whole.x0, whole.y0]), np.array([whole.x1, whole.y1 - titled])
        if axes.get_position(original=True).size[0] < 1.0:  # one of several
            low, high = axes.bbox.min, axes.bbox.max
        for _ in range(4):  # the perspective grows with the zoom
            axes.set_box_aspect(edges, zoom=self.zoom)
            axes.apply_aspect()
            x, y, _ = proj_transform(*corners, axes.get_proj())
            seen = axes.transData.transform(np.stack([x, y], -1))
            centre = (axes.bbox.min + axes.bbox.max) / 2
            room = np.where(seen > centre, high - centre, centre - low)
            self.zoom *= 0.96 / float((np.abs(seen - centre) / room).max())
        axes.set_box_aspect(edges, zoom=self.zoom)

    def _frame(self, target: np.ndarray) -> None:
        """Set limits, direction of view, and draw the ground's grid."""
        axes, seen = self.axes, self.seen
        middle, half = self.turn @ target, np.abs(self.turn) @ seen.extent / 2
        half = np.maximum(half, 0.25 * half.max())
        limits = np.stack([middle - half, middle + half], 1)
        if seen.ground is not None:
            limits[2, 0] = min(limits[2, 0], seen.ground)
        axes.set(xlim=limits[0], ylim=limits[1], zlim=limits[2])
        edges = limits[:, 1] - limits[:, 0]
        axes.set_box_aspect(edges, zoom=self.zoom)
        x, y, z = self.turn @ seen.direction
        axes.view_init(
            elev=float(np.degrees(np.arcsin(np.clip(z, -1, 1)))),
            azim=float(np.degrees(np.arctan2(y, x))),
        )
        axes.set_axis_off()
        if self.target is None:
            if self.title:
                axes.set_title(self.title, y=1.0, pad=0.0)
            self._fit(middle, edges)
        if seen.ground is None:
            return
        (x0, x1), (y0, y1) = limits[:2]
        across, along = (
            seen.cell * np.arange(np.ceil(low / seen.cell), np.floor(high / seen.cell) + 1)
            for low, high in ((x0, x1), (y0, y1))
        )
        # One artist for all lines, with gaps between them.
        lines = [[[x, x, np.nan], [y0, y1, np.nan]] for x in across]
        lines += [[[x0, x1, np.nan], [y, y, np.nan]] for y in along]
        level = np.concatenate(lines, axis=1)
        columns = (*level, np.full(level.shape[1], seen.ground))
        if self.grid is not None:
            self.grid.set_data_3d(*columns)
            return
        style = {"color": "0.8", "linewidth": 0.5, "zorder": -1}
        (self.grid,) = axes.plot(*columns, **style)
