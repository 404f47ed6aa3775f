"""The page: one HTML file with everything in it, the numbers as base64: poses of 32-bit floats.

Visuals that are rigidly connected share one *track*, the motion of the first of them, and keep a
constant offset from it: a body of a dozen parts costs no more than one part. What never moves is
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
from typing import Any

import numpy as np
import scipy

from pydy._files import write_files
from pydy._names import label_parts
from pydy._rank import HALF
from pydy._version import __version__
from pydy.viz import shapes
from pydy.viz.animation import Animation, Item, Look, frame
from pydy.viz.colours import CYCLE, MODES
from pydy.viz.curves import BUCKETS, thinned
from pydy.viz.live import LivePage, Witness
from pydy.viz.surfaces import TUBE, helix, surface

# -- The page --------------------------------------------------------------------------------------


# The scripts of the page, in the order in which they build on each other.
SCRIPTS = (
    *("data.js", "shapes.js", "stage.js", "trails.js", "curves.js", "strip.js", "player.js"),
    *("share.js", "controls.js"),
)


# What the page draws as triangles from here.
_TRIANGLES = (
    shapes.Circle,
    shapes.Cube,
    shapes.Icosahedron,
    shapes.Octahedron,
    shapes.Tetrahedron,
    shapes.TorusKnot,
    shapes.Tube,
)


def page(animation: Animation, look: Look, theme: str, live: LivePage | None = None) -> str:
    """Return the HTML of an animation."""
    title = look.title or "Animation"
    content = page_data(animation, look, live)
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
    # In one pass: what is put in may itself look like a place to put something.
    html = re.sub(r"\{\{([A-Z]+)\}\}", lambda m: parts.get(m[1], m[0]), _resource("page.html"))
    # The page's own head comes before anything of the user's but the title, which is escaped.
    return html.replace("{{POLICY}}", _policy(html), 1)


def _policy(html: str) -> str:
    """Allow a browser the scripts and styles of this page as they are now, and no others."""
    own = {
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
        f"default-src 'none'; script-src {own['script']}; style-src {own['style']}; "
        "img-src data: blob:; media-src blob:; base-uri 'none'; form-action 'none'"
    )


@cache
def _resource(name: str) -> str:
    return (files("pydy.viz") / "assets" / name).read_text(encoding="utf-8")


def opened(html: str) -> Path:
    """Show a page in the browser from a temporary file; delete earlier files."""
    for old in Path(tempfile.gettempdir()).glob("pydy-scene-????????/scene.html"):
        with suppress(OSError):
            folder = os.lstat(old.parent)  # neither a link nor somebody else's
            ours = getattr(os, "geteuid", int)() == folder.st_uid  # 0 on Windows
            age = time.time() - os.lstat(old).st_mtime
            if ours and stat.S_ISDIR(folder.st_mode) and age > 3600.0:  # long read by browsers
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


def page_data(animation: Animation, look: Look, live: LivePage | None = None) -> dict[str, Any]:
    """Return the data for the page's scripts, as JSON types.

    Lengths are in units of about half the scene's diagonal, a power of two: browsers draw with
    32-bit floats, whose range a scene of planets or of atoms leaves in squares and products.
    """
    seen = frame(animation, look)
    unit = 2.0 ** float(np.clip(np.round(np.log2(seen.radius)), -1022, 1022))
    tracks = _Tracks(animation, unit, None if live is None else live.witness)
    visuals = [_visual(item, tracks) for item in animation.items]
    more: dict[str, Any] = {}
    if live is not None:
        code, data = live.code(tracks.places)
        more["live"] = {"code": code, **data, "buckets": BUCKETS}
    clocks = _Clocks()
    series = [
        {
            "label": label,
            "parts": label_parts(label),
            "unit": look.units.get(label, ""),
            "colour": CYCLE[(k + 1) % len(CYCLE)],
            "clock": clocks.find(drawn.times),
            "values": _packed(drawn.values, np.float64),
        }
        for k, (label, whole) in enumerate(animation.series.items())
        for drawn in [thinned(whole)]
    ]
    return {
        **more,
        "version": __version__,
        "title": look.title,
        "times": _packed(animation.times, np.float64),
        "speed": animation.speed,
        "tracks": tracks.entries,
        "visuals": visuals,
        "clocks": clocks.entries,
        "series": series,
        "events": [{"time": t, "name": name} for t, name in animation.events],
        "modes": [
            {
                "name": name,
                "spans": [
                    {"from": first, "to": last, "mode": mode, "colour": MODES.get(mode)}
                    for first, last, mode in spans
                ],
            }
            for name, spans in animation.modes.items()
        ],
        "view": {
            "unit": unit,
            "up": seen.up.tolist(),
            "right": seen.right.tolist(),
            "direction": seen.direction.tolist(),
            "target": (seen.target / unit).tolist(),
            "radius": seen.radius / unit,
            "extent": (seen.extent / unit).tolist(),
            "ground": None if seen.ground is None else seen.ground / unit,
            "cell": seen.cell / unit,
            "axes": None if look.axes is None else look.axes / unit,
            "path": None if seen.path is None else _column(seen.path / unit, live is not None),
        },
    }


def _packed(array: np.ndarray, dtype: Any = np.float32) -> str:
    little = np.ascontiguousarray(array, dtype=np.dtype(dtype).newbyteorder("<"))
    return b64encode(little.tobytes()).decode("ascii")


def _column(array: np.ndarray, changing: bool = False) -> dict[str, Any]:
    """Return an array of shape (m, …) for the page: once if it is constant and never changes."""
    rows = array.reshape(len(array), -1)
    scale = float(np.abs(rows).max(initial=0.0))
    if not changing and np.ptp(rows, axis=0).max(initial=0.0) <= HALF * scale:
        return {"width": rows.shape[1], "fixed": rows[0].tolist()}
    return {"width": rows.shape[1], "rows": _packed(rows)}


class _Clocks:
    """Times of curves; those that several share are stored once."""

    def __init__(self) -> None:
        self.entries: list[str] = []

    def find(self, times: np.ndarray) -> int:
        """Return the number of the entry that holds some times."""
        # 64 bits, as of the values: a clock far from zero, or small changes of a large value.
        entry = _packed(times, np.float64)
        if entry not in self.entries:
            self.entries.append(entry)
        return self.entries.index(entry)


class _Tracks:
    """Motions that visuals share, written in the page's unit.

    On a live page those share one that move rigidly with each other whatever the sliders say, of
    which a witness knows.
    """

    def __init__(self, animation: Animation, unit: float, witness: Witness | None = None) -> None:
        low, high = animation.box
        self.unit = unit
        self.entries: list[dict[str, Any]] = []
        self.places: list[tuple[Any, Any]] = []
        self.witness = witness
        self._bases: list[tuple[Any, np.ndarray, np.ndarray]] = []
        self._frames = {item.visual.frame: item.rotations for item in animation.items}
        self._frames.setdefault(None, np.broadcast_to(np.eye(3), (len(animation.times), 3, 3)))
        # The page has 32-bit floats, which tell no more apart at that distance.
        self._tolerance = HALF * float(np.abs([low, high]).max(initial=0.0))

    def find(self, frame: Any, point: Any, positions: np.ndarray) -> tuple[int, list[float]]:
        """Return the number of the track that moves with a frame, and a point's offset from it."""
        for k, (other, rotations, base) in enumerate(self._bases):
            offset = self._seen_from(rotations, positions - base)
            if other is not frame or not self._constant(offset):
                continue
            if self.witness is None or self.witness.rigid(frame, self.places[k][1], point):
                return k, (offset[0] / self.unit).tolist()
        rotations = self._frames[frame]
        self.places.append((frame, point))
        self._bases.append((frame, rotations, positions))
        # A copy: old versions of SciPy refuse what is read-only.
        quaternions = scipy.spatial.transform.Rotation.from_matrix(np.array(rotations)).as_quat()
        # Neighbours on the same side of the sphere, so that interpolation takes the short way.
        flips = np.sign(np.einsum("mi,mi->m", quaternions[1:], quaternions[:-1]))
        quaternions[1:] *= np.cumprod(np.where(flips == 0, 1.0, flips))[:, None]
        changing = self.witness is not None
        entry = {"p": _column(positions / self.unit, changing), "q": _column(quaternions, changing)}
        self.entries.append(entry)
        return len(self._bases) - 1, [0.0, 0.0, 0.0]

    def carrier(self, symbols: Sequence[Any], points: np.ndarray) -> tuple[Any, np.ndarray] | None:
        """Return a frame in which points, shape (m, k, 3), rest, and their offsets from the first.

        None where they move relative to each other.
        """
        witness = self.witness
        away = points - points[:, :1]
        for carrier, rotations in self._frames.items():
            offset = self._seen_from(rotations, away)
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


def _visual(item: Item, tracks: _Tracks) -> dict[str, Any]:
    shape, unit = item.shape, tracks.unit
    entry: dict[str, Any] = {
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
            # As long as it is at first, so that its wire is round then.
            length = float(np.linalg.norm(item.points[0, 1] - item.points[0, 0])) or shape.radius
            vertices, faces = helix(shape.radius, shape.coils, length)
            entry["vertices"], entry["faces"] = _packed(vertices / unit), _packed(faces, np.uint32)
            entry |= {"smooth": True, "first": length / unit}
        elif isinstance(shape, shapes.Damper):
            entry["tube"] = [TUBE * shape.radius / unit, item.tube / unit]  # radius and length
        carried = tracks.carrier(shape.points, item.points)
        changing = tracks.witness is not None
        if carried is None:
            entry["points"] = _column(item.points / unit, changing)
        else:
            # A rod of a rigid body.
            entry["points"] = _column(carried[1][None] / unit)
            entry["track"], entry["offset"] = tracks.find(
                carried[0], shape.points[0], item.points[:, 0]
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
    lengths = () if isinstance(shape, shapes.Trace) else shape.lengths  # a trace lasts
    size = {name: v / unit if name in lengths else v for name, v in shape.dimensions()}
    return {**entry, "size": size}
