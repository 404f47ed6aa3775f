"""The scene in Matplotlib: pictures for papers, films for slides."""

from __future__ import annotations

import subprocess
import tempfile
from collections.abc import Callable, Iterable, Iterator, Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np

from pydy._checks import typed
from pydy._files import replacing
from pydy._optional import bar_of, require
from pydy.viz.animation import Animation, Framing, Item, ViewSettings, frame, frame_still
from pydy.viz.shapes import Circle, Line, Mesh, Plane
from pydy.viz.surfaces import Surface, spoke, surface

if TYPE_CHECKING:
    from types import ModuleType

    from matplotlib.backend_bases import RendererBase
    from matplotlib.figure import Figure
    from mpl_toolkits.mplot3d import Axes3D
    from PIL.Image import Image as Picture

# -- An artist of Matplotlib that paints all triangles of a scene in one call ----------------------
# Axes3D draws a triangle as a path with an edge, and sorts within each surface only. Here all
# surfaces are sorted together.


class SurfacePart(NamedTuple):
    """A surface of one colour."""

    vertices: np.ndarray  # (n, 3): in Matplotlib's axes
    faces: np.ndarray  # int, (k, 3): counter-clockwise from outside
    rgba: np.ndarray  # (4,), or (k, 4): of each triangle
    closed: bool  # whether triangles that face away from the viewer are invisible


def make_triangles(axes: Axes3D) -> Any:
    """Add an artist to an Axes3D and return it.

    Before each frame its method `set_parts` takes the surfaces. Triangles of closed surfaces that
    face away are invisible, and are removed before sorting.
    """
    from matplotlib.artist import Artist
    from matplotlib.transforms import IdentityTransform

    class Triangles(Artist):
        def set_parts(self, parts: Sequence[SurfacePart], light: np.ndarray) -> None:
            """Set the surfaces of a frame and the direction of the light."""
            self.parts, self.light = parts, light

        def draw(self, renderer: RendererBase) -> None:
            """Project the triangles and paint them from far to near."""
            if not self.parts:
                return
            vertices, faces, rgba, closed = _concatenate(self.parts)
            projection = axes.get_proj()
            points = vertices @ projection[:, :3].T + projection[:, 3]
            points = points[:, :3] / points[:, 3:]
            flat = axes.transData.transform(points[:, :2])
            a, b, c = (flat[faces[:, k]] for k in range(3))
            area = (b - a)[:, 0] * (c - a)[:, 1] - (b - a)[:, 1] * (c - a)[:, 0]
            visible = np.flatnonzero((area > 0) | ~closed)
            depth = points[:, 2][faces[visible]].sum(1)
            visible = visible[np.argsort(-depth)]
            faces, colours = faces[visible], rgba[visible]
            bright = 0.7 + 0.3 * normals(vertices[faces]) @ self.light
            colours[:, :3] *= bright[:, None]
            context = renderer.new_gc()
            renderer.draw_gouraud_triangles(
                context, flat[faces], np.repeat(colours[:, None], 3, axis=1), IdentityTransform()
            )
            context.restore()

    triangles = Triangles()
    triangles.set_parts((), np.zeros(3))
    triangles.set_zorder(1.0)  # above the grid, below lines
    axes.add_artist(triangles)
    triangles.set_clip_on(False)
    return triangles


def normals(corners: np.ndarray) -> np.ndarray:
    """Return the unit normals of triangles, shape (k, 3)."""
    normal = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    lengths = np.sqrt((normal * normal).sum(1))[:, None]
    return normal / np.where(lengths > 0, lengths, 1.0)


def _concatenate(
    parts: Sequence[SurfacePart],
) -> tuple[np.ndarray, np.ndarray, np.ndarray, np.ndarray]:
    """Concatenate the parts: vertices, and the corners, colour and `closed` of each triangle."""
    counts = [len(part.faces) for part in parts]
    starts = np.cumsum([0] + [len(part.vertices) for part in parts[:-1]])
    faces = np.concatenate([part.faces for part in parts])
    faces = faces + np.repeat(starts, counts)[:, None]
    colours = [np.broadcast_to(part.rgba, (k, 4)) for part, k in zip(parts, counts, strict=True)]
    rgba = np.concatenate(colours)
    closed = np.repeat([part.closed for part in parts], counts)
    return np.concatenate([part.vertices for part in parts]), faces, rgba, closed


# -- Films of a scene: frames that go to a GIF or to ffmpeg as they are drawn ----------------------


def save_gif(drawing: _Drawing, rows: Iterable[int], path: Path, fps: float) -> None:
    """Save a GIF whose frames share a palette.

    Pillow would choose the colours of each frame anew, which takes as long as drawing it.
    """
    require("PIL", "plot", "A GIF film of a scene")
    from PIL import Image

    paint, _ = _painter(drawing)

    def frames() -> Iterator[Picture]:
        palette = None
        for k in rows:
            frame = Image.fromarray(paint(k)).convert("RGB")
            palette = palette or _palette(Image, frame, drawing.colours)
            yield frame.quantize(palette=palette, dither=Image.Dither.NONE)

    remaining = frames()
    options = {
        "save_all": True,
        "append_images": remaining,
        "duration": _delays(len(drawing.instants.times), fps),
        "loop": 0,
    }
    with open(path, "wb") as file:  # Pillow would not close its own after a Ctrl-C
        next(remaining).save(file, "GIF", **options)


def _delays(count: int, fps: float) -> list[int]:
    """Return how long a GIF shows each of its frames, in ms.

    The format counts hundredths of a second. Each frame ends at the hundredth nearest to its time,
    so that the film keeps its speed: with the same delay of 3 for each, 30 frames would last 0.9 s.
    """
    ends = np.round(100.0 / fps * np.arange(count + 1))
    delays: list[int] = (10 * np.diff(ends)).astype(int).tolist()
    return delays


def _palette(image: ModuleType, frame: Picture, colours: list[np.ndarray]) -> Picture:
    """Return a palette of 256 colours: those of a picture, and shades of the scene's."""
    # The number of shades of each colour that the palette can distinguish.
    shades = np.linspace(0.4, 1.0, 24)[:, None, None] * np.array(colours or [np.ones(3)])
    strip = np.tile((255 * shades).astype(np.uint8).reshape(1, -1, 3), (40, 1, 1))
    sample = np.concatenate([np.asarray(frame).reshape(-1, 3), strip.reshape(-1, 3)])[None]
    chosen = image.fromarray(sample)
    palette: Picture = chosen.quantize(method=image.Quantize.FASTOCTREE, dither=image.Dither.NONE)
    entries = np.array(palette.getpalette(), dtype=np.uint8).reshape(-1, 3)
    entries[entries.sum(1).argmax()] = 255  # the octree's white is a little grey
    palette.putpalette(entries.tobytes())
    return palette


def save_mp4(drawing: _Drawing, rows: Iterable[int], path: Path, fps: float) -> None:
    """Save an MP4 with the program ffmpeg."""
    from matplotlib.animation import FFMpegWriter

    if not FFMpegWriter.isAvailable():
        raise FileNotFoundError(
            "MP4 films need the program ffmpeg, which was not found. Install it (Debian and "
            "Ubuntu: apt install ffmpeg; macOS: brew install ffmpeg; Windows: winget install "
            "ffmpeg), or save a '.gif', or call `to_html`."
        )
    paint, (width, height) = _painter(drawing)
    command = [
        *(FFMpegWriter.bin_path(), "-y", "-loglevel", "error"),
        *("-f", "rawvideo", "-pix_fmt", "rgba", "-s", f"{width}x{height}"),
        *("-framerate", str(fps), "-i", "-", *_encoder(FFMpegWriter.bin_path())),
        # The pixel format that every player reads wants even numbers of pixels.
        *("-vf", "pad=ceil(iw/2)*2:ceil(ih/2)*2", "-pix_fmt", "yuv420p", str(path)),
    ]
    with tempfile.TemporaryFile() as errors:
        with subprocess.Popen(command, stdin=subprocess.PIPE, stderr=errors) as process:
            assert process.stdin is not None
            try:
                for k in rows:
                    process.stdin.write(paint(k).data)
                process.stdin.close()
            except BrokenPipeError:
                pass  # ffmpeg has reported the reason
        if process.returncode:
            errors.seek(0)
            message = errors.read().decode(errors="replace").strip()
            raise OSError(f"ffmpeg could not write '{path}': {message}")


def _encoder(ffmpeg: str) -> tuple[str, ...]:
    """Return the options that choose the encoder.

    With its default preset, libx264 would take longer than the drawing of the frames; the faster
    one makes files of about the same size. Other encoders do not know presets.
    """
    help_output = subprocess.run(
        [ffmpeg, "-v", "quiet", "-h", "encoder=libx264"], capture_output=True, check=False
    )
    if b"preset" in help_output.stdout:
        return ("-vcodec", "libx264", "-preset", "veryfast")
    return ("-vcodec", "h264")


def _painter(drawing: _Drawing) -> tuple[Callable[[int], np.ndarray], tuple[int, int]]:
    """Return ``paint(k) -> pixels``, shape (height, width, 4), and the width and height.

    The figure and its title are drawn once; each frame copies them and adds the moving artists.
    Axes3D would redraw the text and sort its artists.
    """
    from matplotlib.backends.backend_agg import FigureCanvasAgg

    axes, figure = drawing.axes, drawing.axes.figure
    canvas = FigureCanvasAgg(figure)
    renderer = canvas.get_renderer()
    background: Any = None

    def paint(k: int) -> np.ndarray:
        nonlocal background
        drawing.draw(k)
        if background is None:
            figure.patch.draw(renderer)
            axes.title.draw(renderer)
            background = canvas.copy_from_bbox(figure.bbox)
        else:
            canvas.restore_region(background)
        axes.apply_aspect()
        axes.M = axes.get_proj()  # lines read it
        for artist in sorted([*axes.lines, drawing.triangles], key=lambda a: float(a.zorder)):
            artist.draw(renderer)
        return np.asarray(canvas.buffer_rgba())

    return paint, canvas.get_width_height()


# -- Pictures --------------------------------------------------------------------------------------


_PICTURES = (".png", ".pdf", ".svg", ".jpg", ".jpeg")
_FILMS = (".mp4", ".gif")
_FASTEST_GIF = 50.0  # frames per second: browsers show a frame of less than 0.02 s for 0.1 s
_OPEN = (Circle, Mesh, Plane)  # both sides of these may be visible
_SPOKE = 0.45  # brightness of a radius of a disc, which shows how it turns
_DOT = 5.0  # diameter of the mark of a solid that would be smaller, in points
_GRAZING = 0.25  # tolerance for normals that point away from the viewer


def draw(
    animation: Animation,
    settings: ViewSettings,
    t: float,
    axes: Axes3D | None = None,
    single: bool = False,
) -> Axes3D:
    """Draw an animation at a time; return the axes.

    The limits are those of the full motion, so that pictures of several times fit together; with
    `single`, those of this time.
    """
    require("matplotlib", "plot", "A picture or film of a scene")
    if axes is None:
        from matplotlib.figure import Figure

        axes = _full_axes(Figure(figsize=(7, 5)))
    elif not hasattr(axes, "add_collection3d"):
        raise TypeError(
            "`axes` must be three-dimensional, made with subplot(projection='3d'), got "
            f"{typed(axes)}."
        )
    framing = frame_still(animation, settings, t) if single else frame(animation, settings)
    _Drawing(animation, animation.at(t), framing, axes, settings.title).draw(0)
    return axes


def save(
    animation: Animation,
    settings: ViewSettings,
    path: Path,
    fps: float,
    dpi: float,
    size: tuple[float, float],
    progress: bool,
) -> None:
    """Save a film or a picture, depending on the suffix of the path."""
    suffix = path.suffix.lower()
    if suffix not in _PICTURES + _FILMS:
        raise ValueError(
            f"`path` is '{path}', but its suffix must be one of {', '.join(_FILMS + _PICTURES)}. "
            "For a page in the browser call `to_html`."
        )
    require("matplotlib", "plot", "A picture or film of a scene")
    from matplotlib.figure import Figure

    figure = Figure(figsize=size, dpi=dpi)
    axes = _full_axes(figure)
    start, end = float(animation.times[0]), float(animation.times[-1])
    if suffix in _PICTURES:
        framing = frame_still(animation, settings, start)
        _Drawing(animation, animation.at(start), framing, axes, settings.title).draw(0)
        with replacing(path) as (target,):
            figure.savefig(target, dpi=dpi)
        return

    if suffix == ".gif":
        fps = min(fps, _FASTEST_GIF)
    count = max(1, round((end - start) / animation.speed * fps)) + 1
    instants = animation.at(np.linspace(start, end, count))
    framing = frame(animation, settings)
    drawing = _Drawing(animation, instants, framing, axes, settings.title, make_triangles(axes))
    rows: Iterable[int] = range(count)
    if progress:
        rows = bar_of(rows)
    with replacing(path) as (target,):
        (save_gif if suffix == ".gif" else save_mp4)(drawing, rows, target, fps)


def _full_axes(figure: Figure) -> Axes3D:
    """Return Axes that fill their figure, so that the picture clips everything beyond."""
    return figure.add_axes((0.0, 0.0, 1.0, 1.0), projection="3d")


def _rgb(colour: str) -> np.ndarray:
    return np.array([int(colour[k : k + 2], 16) for k in (1, 3, 5)]) / 255


class _Drawing:
    """Draws `instants` of an animation into one Axes3D, whose artists it creates once.

    A film passes `triangles`, one artist for all surfaces.
    """

    def __init__(
        self,
        animation: Animation,
        instants: Animation,
        framing: Framing,
        axes: Axes3D,
        title: str,
        triangles: Any = None,
    ) -> None:
        self.animation = animation
        self.instants = instants
        self.triangles = triangles
        self.solids: dict[int, Surface] = {}
        self.spokes: dict[int, np.ndarray] = {}  # indices of the darker triangles of each solid
        self.framing = framing
        self.axes = axes
        self.title = title
        # Matplotlib's z is up; rows are its axes in the scene's frame.
        depth = np.cross(framing.right, framing.up_axis)
        self.turn = np.stack([framing.right, -depth, framing.up_axis])
        self.light = self.turn @ (0.9 * depth + 0.7 * framing.right + 2.2 * framing.up_axis)
        self.light /= np.linalg.norm(self.light)
        self.view = self.turn @ framing.direction
        self.artists: dict[tuple[int, str], Any] = {}
        self.grid: Any = None
        self.target: np.ndarray | None = None  # the point at the centre of the view
        self.zoom = 1.0

    @property
    def colours(self) -> list[np.ndarray]:
        """The colours of the visuals."""
        return [_rgb(colour) for colour in sorted({i.shape.colour for i in self.instants.items})]

    def draw(self, k: int) -> None:
        """Draw the k-th instant."""
        framing, t = self.framing, float(self.instants.times[k])
        target = framing.target.copy()
        if framing.path is not None:
            row = [np.interp(t, self.animation.times, framing.path[:, i]) for i in range(3)]
            target += np.array(row)
        if self.target is None or not np.array_equal(target, self.target):
            self._frame(target)
        self.target = target
        parts = []
        for number, item in enumerate(self.instants.items):
            colour, shape = item.shape.colour, item.shape
            path = self.animation.path(number, t)
            if path is not None:
                path = np.concatenate([path, item.positions[k : k + 1]])
                self._line((number, "path"), path, color=colour, linewidth=1.2, alpha=0.8)
            if isinstance(shape, Line) and shape.radius is None and item.points is not None:
                self._line((number, "line"), item.points[k], color=colour, linewidth=1.5)
            solid = self._solid(number, item, k)
            if solid is None:
                continue
            vertices, faces = solid
            if item.rigid and len(vertices):
                self._mark(number, vertices, colour)
            closed = shape.opacity == 1.0 and not isinstance(shape, _OPEN)
            rgba = np.tile(np.append(_rgb(colour), shape.opacity), (len(faces), 1))
            if number in self.spokes:
                rgba[self.spokes[number], :3] *= _SPOKE
            if self.triangles is None:
                self._surface((number, "surface"), vertices[faces], rgba, closed)
            else:
                parts.append(SurfacePart(vertices, faces, rgba, closed))
        if self.triangles is not None:
            self.triangles.set_parts(parts, self.light)

    def _solid(self, number: int, item: Item, k: int) -> Surface | None:
        """Return an item's triangles in Matplotlib's axes."""
        if item.rigid:  # its triangles only rotate and translate
            if number not in self.solids:
                self.solids[number] = surface(item.shape)
                self.spokes[number] = spoke(item.shape, *self.solids[number])
            vertices, faces = self.solids[number]
            turn = (self.turn @ item.rotations[k]).T
            return vertices @ turn + self.turn @ item.positions[k], faces
        triangles = item.surface(k)
        if triangles is None:
            return None
        vertices, faces = triangles
        return vertices @ self.turn.T, faces

    def _mark(self, number: int, vertices: np.ndarray, colour: str) -> None:
        """Draw a dot of fixed size where a solid would be smaller than it."""
        from mpl_toolkits.mplot3d.proj3d import proj_transform

        low, high = vertices.min(axis=0), vertices.max(axis=0)
        x, y, _ = proj_transform(*np.stack([low, high], axis=1), self.axes.get_proj())
        ends = self.axes.transData.transform(np.stack([x, y], -1))
        size = float(np.linalg.norm(ends[1] - ends[0])) * 72.0 / self.axes.figure.dpi
        key = number, "mark"
        if size < _DOT or key in self.artists:
            middle = self.turn.T @ ((low + high) / 2)
            self._line(key, middle[None], color=colour, marker="o", markersize=_DOT, ls="none")
            self.artists[key].set_visible(size < _DOT)

    def _line(self, key: tuple[int, str], points: np.ndarray, **style: object) -> None:
        columns = self.turn @ points.T
        if key in self.artists:
            self.artists[key].set_data_3d(*columns)
        else:
            (self.artists[key],) = self.axes.plot(*columns, clip_on=False, **style)

    def _surface(
        self,
        key: tuple[int, str],
        corners: np.ndarray,
        rgba: np.ndarray,
        closed: bool,
    ) -> None:
        from mpl_toolkits.mplot3d.art3d import Poly3DCollection

        normal = normals(corners)
        if closed:
            # Nearly half of a closed surface is hidden; the perspective reduces it.
            facing = normal @ self.view > -_GRAZING
            corners, normal, rgba = corners[facing], normal[facing], rgba[facing]
        bright = 0.7 + 0.3 * normal @ self.light
        rgba = np.column_stack([bright[:, None] * rgba[:, :3], rgba[:, 3]])
        if key not in self.artists:
            self.artists[key] = Poly3DCollection(
                corners, facecolors=rgba, edgecolors=rgba, linewidths=0.3, clip_on=False
            )
            self.axes.add_collection3d(self.artists[key])
            return
        self.artists[key].set_verts(corners)
        # Without edges, seams between triangles are visible.
        self.artists[key].set_facecolor(rgba)
        self.artists[key].set_edgecolor(rgba)

    def _fit(self, middle: np.ndarray, edges: np.ndarray) -> None:
        """Set the zoom with which the visible box just fits into the picture."""
        from mpl_toolkits.mplot3d.proj3d import proj_transform

        axes, half = self.axes, np.abs(self.turn) @ self.framing.extent / 2
        signs = np.stack(np.meshgrid(*[[-1.0, 1.0]] * 3), -1).reshape(-1, 3)
        corners = (middle + signs * half).T
        bounds, titled = axes.figure.bbox, 30.0 if self.title else 0.0
        low, high = np.array([bounds.x0, bounds.y0]), np.array([bounds.x1, bounds.y1 - titled])
        if axes.get_position(original=True).size[0] < 1.0:  # one of several
            low, high = axes.bbox.min, axes.bbox.max
        for _ in range(4):  # the perspective grows with the zoom
            axes.set_box_aspect(edges, zoom=self.zoom)
            axes.apply_aspect()
            x, y, _ = proj_transform(*corners, axes.get_proj())
            projected = axes.transData.transform(np.stack([x, y], -1))
            centre = (axes.bbox.min + axes.bbox.max) / 2
            room = np.where(projected > centre, high - centre, centre - low)
            self.zoom *= 0.96 / float((np.abs(projected - centre) / room).max())
        axes.set_box_aspect(edges, zoom=self.zoom)

    def _frame(self, target: np.ndarray) -> None:
        """Set limits, direction of view, and draw the ground's grid."""
        axes, framing = self.axes, self.framing
        middle, half = self.turn @ target, np.abs(self.turn) @ framing.extent / 2
        half = np.maximum(half, 0.25 * half.max())
        limits = np.stack([middle - half, middle + half], 1)
        if framing.ground is not None:
            limits[2, 0] = min(limits[2, 0], framing.ground)
        axes.set(xlim=limits[0], ylim=limits[1], zlim=limits[2])
        edges = limits[:, 1] - limits[:, 0]
        axes.set_box_aspect(edges, zoom=self.zoom)
        x, y, z = self.turn @ framing.direction
        axes.view_init(
            elev=float(np.degrees(np.arcsin(np.clip(z, -1, 1)))),
            azim=float(np.degrees(np.arctan2(y, x))),
        )
        axes.set_axis_off()
        if self.target is None:
            if self.title:
                axes.set_title(self.title, y=1.0, pad=0.0)
            self._fit(middle, edges)
        if framing.ground is None:
            return
        (x0, x1), (y0, y1) = limits[:2]
        across, lengthwise = (
            framing.cell * np.arange(np.ceil(low / framing.cell), np.floor(high / framing.cell) + 1)
            for low, high in ((x0, x1), (y0, y1))
        )
        # One artist for all lines, with gaps between them.
        lines = [[[x, x, np.nan], [y0, y1, np.nan]] for x in across]
        lines += [[[x0, x1, np.nan], [y, y, np.nan]] for y in lengthwise]
        level = np.concatenate(lines, axis=1)
        columns = (*level, np.full(level.shape[1], framing.ground))
        if self.grid is not None:
            self.grid.set_data_3d(*columns)
            return
        style = {"color": "0.8", "linewidth": 0.5, "zorder": -1}
        (self.grid,) = axes.plot(*columns, **style)
