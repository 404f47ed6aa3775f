"""The page: one self-contained HTML file; arrays are base64, poses are 32-bit floats.

Visuals that are rigidly connected share one *track*, the motion of the first of them, and keep a
constant offset from it: a body of a dozen parts costs no more than one part. Constant rows are
stored once.
"""

from __future__ import annotations

import json
import os
import re
import stat
import tempfile
import time
import webbrowser
from base64 import b64encode
from collections.abc import Sequence
from contextlib import suppress
from functools import cache
from hashlib import sha256
from html import escape
from importlib.resources import files
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from pydy._files import write_files
from pydy._names import label_parts
from pydy._rank import HALF
from pydy._rotations import to_quaternions
from pydy._version import __version__
from pydy.viz import shapes
from pydy.viz.animation import Animation, Item, ViewSettings, frame
from pydy.viz.colours import CYCLE, MODES
from pydy.viz.curves import BUCKETS, TimeSeries, thinned
from pydy.viz.live import LivePage, Witness
from pydy.viz.surfaces import TUBE, helix, surface

if TYPE_CHECKING:
    from numpy.typing import DTypeLike
    from sympy.physics.mechanics import Point, ReferenceFrame

# -- The page --------------------------------------------------------------------------------------


# The scripts of the page, in the order of their dependencies.
SCRIPTS = (
    *("data.js", "shapes.js", "stage.js", "trails.js", "curves.js", "strip.js", "player.js"),
    *("share.js", "controls.js"),
)


# Shapes whose triangles are computed here, not by the page.
_TRIANGLES = (
    shapes.Circle,
    shapes.Cube,
    shapes.Icosahedron,
    shapes.Octahedron,
    shapes.Tetrahedron,
    shapes.TorusKnot,
    shapes.Tube,
)


def page(
    animation: Animation, settings: ViewSettings, theme: str, live: LivePage | None = None
) -> str:
    """Return the HTML of an animation."""
    title = settings.title or "Animation"
    content = page_data(animation, settings, live)
    scripts = [_resource(name) for name in SCRIPTS]
    style = _resource("style.css")
    if live is not None:
        code = content["live"].pop("code")
        scripts += [_resource("samples.js"), f"const liveModel = {code};", _resource("live.js")]
        style += _resource("live.css")
    # A "<" could end the script element that holds the data.
    data = json.dumps(content, allow_nan=False, separators=(",", ":"))
    parts = {
        "TITLE": escape(title),
        "THEME": theme,
        "STYLE": style,
        "DATA": data.replace("<", "\\u003c"),
        "LICENCE": _resource("three.LICENSE").replace("*/", ""),
        "THREE": _resource("three.min.js"),
        "APP": "\n".join(scripts),
    }
    # In one pass, because inserted text may look like a placeholder.
    html = re.sub(r"\{\{([A-Z]+)\}\}", lambda m: parts.get(m[1], m[0]), _resource("page.html"))
    # Only the escaped title of the user precedes this placeholder, which is in the head.
    return html.replace("{{POLICY}}", _policy(html), 1)


def _policy(html: str) -> str:
    """Return a content security policy that allows only the present scripts and styles."""
    hashes = {
        kind: " ".join(
            f"'sha256-{b64encode(sha256(text.encode()).digest()).decode('ascii')}'"
            for text in re.findall(pattern, html, re.S)
        )
        for kind, pattern in (
            ("script", r"<script>(.*?)</script>"),
            ("style", r"<style>(.*?)</style>"),
        )
    }
    return (
        f"default-src 'none'; script-src {hashes['script']}; style-src {hashes['style']}; "
        "img-src data: blob:; media-src blob:; base-uri 'none'; form-action 'none'"
    )


@cache
def _resource(name: str) -> str:
    return (files("pydy.viz") / "assets" / name).read_text(encoding="utf-8")


def open_in_browser(html: str) -> Path:
    """Show a page in the browser from a temporary file; delete earlier files."""
    for old in Path(tempfile.gettempdir()).glob("pydy-scene-????????/scene.html"):
        with suppress(OSError):
            folder = os.lstat(old.parent)  # it must not be a link, nor belong to another user
            ours = getattr(os, "geteuid", int)() == folder.st_uid  # 0 on Windows
            age = time.time() - os.lstat(old).st_mtime
            # After an hour the browser has read the page.
            if ours and stat.S_ISDIR(folder.st_mode) and age > 3600.0:
                old.unlink()
                old.parent.rmdir()
    path = Path(tempfile.mkdtemp(prefix="pydy-scene-")) / "scene.html"
    write_files({path: html})
    webbrowser.open(path.as_uri())
    return path


def embedded(html: str) -> str:
    """Return the element that shows a page within a notebook."""
    return (
        '<iframe title="Animation" sandbox="allow-scripts allow-downloads" allowfullscreen '
        'style="width: 100%; height: 520px; border: 0; border-radius: 8px" '
        f'srcdoc="{escape(html, quote=True)}"></iframe>'
    )


_NO_UNIT = "", 1.0


def page_data(
    animation: Animation, settings: ViewSettings, live: LivePage | None = None
) -> dict[str, Any]:
    """Return the data for the page's scripts, as JSON types.

    Lengths are in units of about half the scene's diagonal, a power of two: browsers draw with
    32-bit floats, and squares of lengths of planets or atoms would exceed their range.
    """
    framing = frame(animation, settings)
    unit = 2.0 ** float(np.clip(np.round(np.log2(framing.radius)), -1022, 1022))
    tracks = _Tracks(animation, unit, None if live is None else live.witness)
    visuals = [_visual(item, tracks) for item in animation.items]
    live_data: dict[str, object] = {}
    if live is not None:
        code, data = live.code(tracks.anchors)
        factors = [settings.units.get(label, _NO_UNIT)[1] for label in animation.series]
        data["series"] = [
            [*source, factor] for source, factor in zip(live.plotted, factors, strict=True)
        ]
        # A height that nobody gave follows the motion: `frame` has the same defaults.
        given = settings.ground is not None and settings.ground is not True
        lowers = animation.ground is None and not given
        live_data["live"] = {"code": code, **data, "buckets": BUCKETS, "lowers": lowers}
    clocks = _Clocks()
    series = [
        _curve(label, curve, settings.units.get(label, _NO_UNIT), CYCLE[k % len(CYCLE)], clocks)
        for k, (label, curve) in enumerate(animation.series.items(), 1)
    ]
    return {
        **live_data,
        "version": __version__,
        "title": settings.title,
        "times": _packed(animation.times, np.float64),
        "speed": animation.speed,
        "tracks": tracks.entries,
        "visuals": visuals,
        "clocks": clocks.entries,
        "series": series,
        "events": [{"time": t, "name": name} for t, name in animation.events],
        "modes": [_mode_spans(name, spans) for name, spans in animation.modes.items()],
        "view": {
            "unit": unit,
            "up": framing.up_axis.tolist(),
            "right": framing.right.tolist(),
            "direction": framing.direction.tolist(),
            "target": (framing.target / unit).tolist(),
            "radius": framing.radius / unit,
            "extent": (framing.extent / unit).tolist(),
            "ground": None if framing.ground is None else framing.ground / unit,
            "cell": framing.cell / unit,
            "axes": None if settings.axes is None else settings.axes / unit,
            "path": None
            if framing.path is None
            else _column(framing.path / unit, live is not None),
        },
    }


def _curve(
    label: str, curve: TimeSeries, unit: tuple[str, float], colour: str, clocks: _Clocks
) -> dict[str, object]:
    """Return the data of a curve below the picture, in its unit (name, factor)."""
    unit_name, factor = unit
    drawn = thinned(curve._replace(values=factor * curve.values))
    return {
        "label": label,
        "parts": label_parts(label),
        "unit": unit_name,
        "colour": colour,
        "clock": clocks.find(drawn.times),
        "values": _packed(drawn.values, np.float64),
    }


def _mode_spans(name: str, spans: Sequence[tuple[float, float, str]]) -> dict[str, object]:
    """Return the time spans in which a contact has each of its modes."""
    return {
        "name": name,
        "spans": [
            {"from": first, "to": last, "mode": mode, "colour": MODES.get(mode)}
            for first, last, mode in spans
        ],
    }


def _packed(array: np.ndarray, dtype: DTypeLike = np.float32) -> str:
    little = np.ascontiguousarray(array, dtype=np.dtype(dtype).newbyteorder("<"))
    return b64encode(little.tobytes()).decode("ascii")


def _column(array: np.ndarray, changing: bool = False) -> dict[str, object]:
    """Return an array of shape (m, …) for the page: once if it is constant and never changes."""
    rows = array.reshape(len(array), -1)
    scale = float(np.abs(rows).max(initial=0.0))
    if not changing and np.ptp(rows, axis=0).max(initial=0.0) <= HALF * scale:
        return {"width": rows.shape[1], "fixed": rows[0].tolist()}
    return {"width": rows.shape[1], "rows": _packed(rows)}


class _Clocks:
    """Times of curves, stored once for all curves that share them."""

    def __init__(self) -> None:
        self.entries: list[str] = []

    def find(self, times: np.ndarray) -> int:
        """Return the index of the entry with these times, which is added if it is missing."""
        # 64 bits, as for values: times may start far from zero, and large values change little.
        entry = _packed(times, np.float64)
        if entry not in self.entries:
            self.entries.append(entry)
        return self.entries.index(entry)


class _Tracks:
    """Motions that visuals share, written in the page's unit.

    On a live page, visuals share a track only if the `witness` finds them rigidly connected for all
    values of the sliders.
    """

    def __init__(self, animation: Animation, unit: float, witness: Witness | None = None) -> None:
        low, high = animation.box
        self.unit = unit
        self.entries: list[dict[str, object]] = []
        self.anchors: list[tuple[ReferenceFrame | None, Point]] = []
        self.witness = witness
        self._bases: list[tuple[ReferenceFrame | None, np.ndarray, np.ndarray]] = []
        self._frames = {item.visual.frame: item.rotations for item in animation.items}
        self._frames.setdefault(None, np.broadcast_to(np.eye(3), (len(animation.times), 3, 3)))
        # The page has 32-bit floats, which do not resolve smaller differences.
        self._tolerance = HALF * float(np.abs([low, high]).max(initial=0.0))

    def find(
        self, frame: ReferenceFrame | None, point: Point, positions: np.ndarray
    ) -> tuple[int, list[float]]:
        """Return the number of the track that moves with a frame, and a point's offset from it."""
        for k, (base_frame, rotations, base) in enumerate(self._bases):
            offset = self._seen_from(rotations, positions - base)
            if base_frame is not frame or not self._constant(offset):
                continue
            if self.witness is None or self.witness.rigid(frame, self.anchors[k][1], point):
                return k, (offset[0] / self.unit).tolist()
        rotations = self._frames[frame]
        self.anchors.append((frame, point))
        self._bases.append((frame, rotations, positions))
        quaternions = to_quaternions(rotations)
        # q and −q are the same rotation: choose signs so that interpolation takes the shorter way.
        flips = np.sign(np.einsum("mi,mi->m", quaternions[1:], quaternions[:-1]))
        quaternions[1:] *= np.cumprod(np.where(flips == 0, 1.0, flips))[:, None]
        changing = self.witness is not None
        entry: dict[str, object] = {
            "p": _column(positions / self.unit, changing),
            "q": _column(quaternions, changing),
        }
        self.entries.append(entry)
        return len(self._bases) - 1, [0.0, 0.0, 0.0]

    def carrier(
        self, symbols: Sequence[Point], points: np.ndarray
    ) -> tuple[ReferenceFrame | None, np.ndarray] | None:
        """Return a frame in which points (m, k, 3) are fixed, and their offsets from the first.

        None if they move relative to each other.
        """
        witness = self.witness
        relative = points - points[:, :1]
        for carrier, rotations in self._frames.items():
            offset = self._seen_from(rotations, relative)
            if self._constant(offset) and (
                witness is None
                or all(witness.rigid(carrier, symbols[0], symbol) for symbol in symbols)
            ):
                return carrier, offset[0]
        return None

    @staticmethod
    def _seen_from(rotations: np.ndarray, vectors: np.ndarray) -> np.ndarray:
        result: np.ndarray = np.einsum("mji,m...j->m...i", rotations, vectors)
        return result

    def _constant(self, values: np.ndarray) -> bool:
        return bool(np.ptp(values, axis=0).max() <= self._tolerance)


def _visual(item: Item, tracks: _Tracks) -> dict[str, object]:
    shape, unit = item.shape, tracks.unit
    entry: dict[str, object] = {
        "name": item.visual.name,
        "kind": type(shape).__name__,
        "colour": shape.colour,
        "opacity": float(shape.opacity),
        "trail": bool(item.visual.trail or isinstance(shape, shapes.Trace)),
    }
    if item.points is not None:
        assert isinstance(shape, shapes.Line)
        entry["radius"] = shape.radius and shape.radius / unit
        if isinstance(shape, shapes.Spring):
            # Its initial length, at which the wire is round.
            length = float(np.linalg.norm(item.points[0, 1] - item.points[0, 0])) or shape.radius
            vertices, faces = helix(shape.radius, shape.coils, length)
            entry["vertices"], entry["faces"] = _packed(vertices / unit), _packed(faces, np.uint32)
            entry |= {"smooth": True, "first": length / unit}
        elif isinstance(shape, shapes.Damper):
            entry["tube"] = [TUBE * shape.radius / unit, item.tube / unit]  # radius and length
        carrier = tracks.carrier(shape.points, item.points)
        changing = tracks.witness is not None
        if carrier is None:
            entry["points"] = _column(item.points / unit, changing)
        else:
            # A rod of a rigid body.
            entry["points"] = _column(carrier[1][None] / unit)
            entry["track"], entry["offset"] = tracks.find(
                carrier[0], shape.points[0], item.points[:, 0]
            )
        return entry
    entry["track"], entry["offset"] = tracks.find(
        item.visual.frame, item.visual.point, item.positions
    )
    if item.vectors is not None:
        assert isinstance(shape, shapes.Arrow)
        vectors = _column(item.vectors / unit, tracks.witness is not None)
        return {**entry, "radius": shape.radius / unit, "vectors": vectors}
    if isinstance(shape, (shapes.Mesh, *_TRIANGLES)):
        vertices, faces = surface(shape)
        entry["vertices"], entry["faces"] = _packed(vertices / unit), _packed(faces, np.uint32)
        return {
            **entry,
            "kind": "Mesh",
            "smooth": isinstance(shape, (shapes.TorusKnot, shapes.Tube)),
        }
    # The size of a trace is a duration.
    lengths = () if isinstance(shape, shapes.Trace) else shape.lengths
    size = {name: v / unit if name in lengths else v for name, v in shape.dimensions()}
    return {**entry, "size": size}
