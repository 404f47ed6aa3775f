"""Films of a scene: frames that go to a GIF or to ffmpeg as they are drawn."""

from __future__ import annotations

import subprocess
import tempfile
from collections.abc import Callable, Iterable, Iterator
from pathlib import Path
from typing import Any

import numpy as np

from pydy._optional import require

__all__ = ["save_gif", "save_mp4"]

_BITS = 5  # of a channel, by which the nearest colour of a film's palette is chosen
_SHADES = 24  # of each colour of the scene that the palette can tell


def save_gif(drawing: Any, rows: Iterable[int], path: Path, fps: float) -> None:
    """Save a GIF whose frames share a palette.

    Pillow would choose the colours of each frame anew, which takes as long as drawing it.
    """
    require("PIL", "plot", "A GIF film of a scene")
    from PIL import Image

    paint, size = _painter(drawing)

    def frames() -> Iterator[Any]:
        palette, table = b"", np.zeros(0, np.uint8)
        for k in rows:
            pixels = paint(k)
            if not palette:
                palette, table = _palette(Image, pixels[:, :, :3], drawing.colours)
            words = np.bitwise_and(pixels.view("<u4")[:, :, 0], 0xFFFFFF)
            frame = Image.frombuffer("P", size, table.take(words).tobytes(), "raw", "P", 0, 1)
            frame.putpalette(palette)
            yield frame

    rest = frames()
    options = {"save_all": True, "append_images": rest, "duration": int(1000.0 / fps), "loop": 0}
    with open(path, "wb") as file:  # Pillow leaves its own open after a Ctrl-C
        next(rest).save(file, "GIF", **options)


def _palette(image: Any, pixels: np.ndarray, colours: list[np.ndarray]) -> tuple[bytes, np.ndarray]:
    """Return 256 colours, and for each 24-bit colour which of them is about nearest."""
    from scipy.spatial import cKDTree

    shades = np.linspace(0.4, 1.0, _SHADES)[:, None, None] * np.array(colours or [np.ones(3)])
    strip = np.tile((255 * shades).astype(np.uint8).reshape(1, -1, 3), (40, 1, 1))
    sample = np.concatenate([pixels.reshape(-1, 3), strip.reshape(-1, 3)])[None]
    chosen = image.frombuffer("RGB", sample.shape[1::-1], sample.tobytes(), "raw", "RGB", 0, 1)
    palette = chosen.quantize(method=image.Quantize.FASTOCTREE, dither=image.Dither.NONE)
    entries = np.array(palette.getpalette(), dtype=np.uint8).reshape(-1, 3)
    entries[entries.sum(1).argmax()] = 255  # the octree's white is a little grey
    levels = np.arange(2**_BITS)
    levels = (levels << (8 - _BITS)) | (levels >> (2 * _BITS - 8))  # black and white stay so
    blue, green, red = np.meshgrid(levels, levels, levels, indexing="ij")
    cells = np.stack([red, green, blue], -1).reshape(-1, 3)
    _, nearest = cKDTree(entries).query(cells)
    table = nearest.astype(np.uint8).reshape(3 * (2**_BITS,))
    for axis in range(3):  # a table for whole pixels is read five times as fast
        table = table.repeat(2 ** (8 - _BITS), axis)
    return entries.tobytes(), table.ravel()


def save_mp4(drawing: Any, rows: Iterable[int], path: Path, fps: float) -> None:
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
    with tempfile.TemporaryFile() as said:
        with subprocess.Popen(command, stdin=subprocess.PIPE, stderr=said) as process:
            assert process.stdin is not None
            try:
                for k in rows:
                    process.stdin.write(paint(k).data)
                process.stdin.close()
            except BrokenPipeError:
                pass  # it has said why
        if process.returncode:
            said.seek(0)
            message = said.read().decode(errors="replace").strip()
            raise OSError(f"ffmpeg could not write '{path}': {message}")


def _encoder(ffmpeg: str) -> tuple[str, ...]:
    """Return the options that choose the encoder.

    With its default preset, libx264 would take longer than the drawing of the frames; the faster
    one makes files of about the same size. Other encoders do not know presets.
    """
    said = subprocess.run(
        [ffmpeg, "-v", "quiet", "-h", "encoder=libx264"], capture_output=True, check=False
    )
    if b"preset" in said.stdout:
        return ("-vcodec", "libx264", "-preset", "veryfast")
    return ("-vcodec", "h264")


def _painter(drawing: Any) -> tuple[Callable[[int], np.ndarray], tuple[int, int]]:
    """Return ``paint(k) -> pixels``, shape (height, width, 4), and the width and height.

    The figure and its title are drawn once; each frame copies them and adds what moves. Axes3D
    would draw the text anew and sort its artists.
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
        axes.M = axes.get_proj()  # which lines read
        for artist in sorted([*axes.lines, drawing.triangles], key=lambda a: float(a.zorder)):
            artist.draw(renderer)
        return np.asarray(canvas.buffer_rgba())

    return paint, canvas.get_width_height()
