"""The scene in Matplotlib: pictures for papers, films for slides."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np

from pydy._optional import require
from pydy.viz.animation import Animation
from pydy.viz.framing import Framing, Look, frame
from pydy.viz.shapes import Line, Trace

__all__ = ["draw", "save"]

_PICTURES = (".png", ".pdf", ".svg", ".jpg", ".jpeg")
_FILMS = (".mp4", ".gif")


def draw(animation: Animation, look: Look, t: float, axes: Any = None) -> Any:
    """Draw an animation at a time; return the axes."""
    require("matplotlib", "plot", "A picture or film of a scene")
    seen = frame(animation, look)
    if axes is None:
        from matplotlib.figure import Figure

        figure = Figure(figsize=(7, 5), layout="tight")
        axes = figure.add_subplot(projection="3d")
    elif not hasattr(axes, "add_collection3d"):
        raise TypeError(
            "`axes` must be three-dimensional, made with subplot(projection='3d'), got the "
            f"{type(axes).__name__} {axes!r}."
        )
    _Drawing(animation, seen, axes, look.title).draw(t)
    return axes


def save(
    animation: Animation,
    look: Look,
    speed: float,
    path: Path,
    fps: float,
    dpi: int,
    size: tuple[float, float],
) -> None:
    """Save a film or a picture, as the suffix of the path says."""
    suffix = path.suffix.lower()
    if suffix not in _PICTURES + _FILMS:
        raise ValueError(
            f"`path` is '{path}', but its suffix must be one of {', '.join(_FILMS + _PICTURES)}. "
            "For a page in the browser call `to_html`."
        )
    if not fps > 0:
        raise ValueError(f"`fps` must be positive, got {fps!r}.")
    require("matplotlib", "plot", "A picture or film of a scene")
    from matplotlib.figure import Figure

    figure = Figure(figsize=size, layout="tight")
    axes = figure.add_subplot(projection="3d")
    drawing = _Drawing(animation, frame(animation, look), axes, look.title)
    if suffix in _PICTURES:
        drawing.draw(float(animation.times[0]))
        figure.savefig(path, dpi=dpi)
        return
    writer = _writer(suffix, fps)
    start, end = float(animation.times[0]), float(animation.times[-1])
    count = max(1, round((end - start) / speed * fps)) + 1
    with writer.saving(figure, str(path), dpi):
        for t in np.linspace(start, end, count):
            axes.clear()
            drawing.draw(float(t))
            writer.grab_frame()


def _writer(suffix: str, fps: Any) -> Any:
    from matplotlib.animation import FFMpegWriter, PillowWriter

    if suffix == ".gif":
        require("PIL", "plot", "A GIF film of a scene")
        return PillowWriter(fps=fps)
    if not FFMpegWriter.isAvailable():
        raise FileNotFoundError(
            "MP4 films need the program ffmpeg, which was not found. Install it (Debian and "
            "Ubuntu: apt install ffmpeg; macOS: brew install ffmpeg; Windows: winget install "
            "ffmpeg), or save a '.gif', or call `to_html`."
        )
    # The pixel format that every player reads wants even numbers of pixels.
    even = ["-vf", "pad=ceil(iw/2)*2:ceil(ih/2)*2", "-pix_fmt", "yuv420p"]
    return FFMpegWriter(fps=fps, extra_args=even)


class _Drawing:
    """Draws instants of an animation into one Axes3D."""

    def __init__(self, animation: Animation, seen: Framing, axes: Any, title: str) -> None:
        self.animation = animation
        self.seen = seen
        self.axes = axes
        self.title = title
        # Matplotlib's z is up; rows are its axes in the scene's frame.
        depth = np.cross(seen.right, seen.up)
        self.turn = np.stack([seen.right, -depth, seen.up])
        self.light = self.turn @ (0.9 * depth + 0.7 * seen.right + 2.2 * seen.up)
        self.light /= np.linalg.norm(self.light)

    def draw(self, t: float) -> None:
        from mpl_toolkits.mplot3d.art3d import Poly3DCollection

        axes, seen = self.axes, self.seen
        instant = self.animation.at(t)
        target = seen.target.copy()
        if seen.path is not None:
            row = [np.interp(t, self.animation.times, seen.path[:, k]) for k in range(3)]
            target += np.array(row)
        self._frame(target)
        for item, whole in zip(instant.items, self.animation.items, strict=True):
            colour, shape = item.shape.colour, item.shape
            if isinstance(shape, Trace) or item.visual.trail:
                past = self.animation.times <= t
                if isinstance(shape, Trace) and shape.duration is not None:
                    past &= self.animation.times >= t - shape.duration
                path = np.concatenate([whole.positions[past], item.positions])
                axes.plot(*(self.turn @ path.T), color=colour, linewidth=1.2, alpha=0.8)
            if isinstance(shape, Line) and shape.radius is None and item.points is not None:
                axes.plot(*(self.turn @ item.points[0].T), color=colour, linewidth=1.5)
            triangles = item.surface()
            if triangles is None:
                continue
            vertices, faces = triangles
            corners = (vertices @ self.turn.T)[faces]
            colours = self._shaded(corners, colour, shape.opacity)
            # Without edges the seams between triangles shine through.
            axes.add_collection3d(
                Poly3DCollection(corners, facecolors=colours, edgecolors=colours, linewidths=0.3)
            )
        if self.title:
            axes.set_title(self.title)

    def _shaded(self, corners: np.ndarray, colour: str, opacity: float) -> np.ndarray:
        normals = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
        lengths = np.linalg.norm(normals, axis=1, keepdims=True)
        normals /= np.where(lengths > 0, lengths, 1.0)
        bright = 0.7 + 0.3 * normals @ self.light
        base = np.array([int(colour[k : k + 2], 16) for k in (1, 3, 5)]) / 255
        return np.column_stack([bright[:, None] * base, np.full(len(corners), opacity)])

    def _frame(self, target: np.ndarray) -> None:
        """Set limits, direction of view, and draw the ground's grid."""
        axes, seen = self.axes, self.seen
        middle, half = self.turn @ target, np.abs(self.turn) @ seen.extent / 2
        half = np.maximum(half, 0.25 * half.max())
        limits = np.stack([middle - half, middle + half], 1)
        if seen.ground is not None:
            limits[2, 0] = min(limits[2, 0], seen.ground)
        axes.set(xlim=limits[0], ylim=limits[1], zlim=limits[2])
        axes.set_box_aspect(limits[:, 1] - limits[:, 0], zoom=1.25)
        x, y, z = self.turn @ seen.direction
        axes.view_init(
            elev=float(np.degrees(np.arcsin(np.clip(z, -1, 1)))),
            azim=float(np.degrees(np.arctan2(y, x))),
        )
        axes.set_axis_off()
        if seen.ground is None:
            return
        (x0, x1), (y0, y1) = limits[:2]
        style = {"color": "0.8", "linewidth": 0.5, "zorder": -1}
        for x in seen.cell * np.arange(np.ceil(x0 / seen.cell), np.floor(x1 / seen.cell) + 1):
            axes.plot([x, x], [y0, y1], [seen.ground] * 2, **style)
        for y in seen.cell * np.arange(np.ceil(y0 / seen.cell), np.floor(y1 / seen.cell) + 1):
            axes.plot([x0, x1], [y, y], [seen.ground] * 2, **style)
