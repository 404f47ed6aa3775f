"""An artist of Matplotlib that paints all triangles of a scene in one call.

Axes3D draws a triangle as a path with an edge, and sorts within each surface only. Here all
surfaces are sorted together.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any, NamedTuple

import numpy as np

__all__ = ["Part", "make_triangles", "normals"]


class Part(NamedTuple):
    """A surface of one colour.

    Attributes
    ----------
    vertices : ndarray, shape (n, 3)
        In Matplotlib's axes.
    faces : ndarray of int, shape (k, 3)
        Counter-clockwise from outside.
    rgba : ndarray, shape (4,)
    closed : bool
        Whether what faces away from the viewer is never seen.
    """

    vertices: np.ndarray
    faces: np.ndarray
    rgba: np.ndarray
    closed: bool


def make_triangles(axes: Any) -> Any:
    """Add an artist to an Axes3D and return it.

    Before each frame its method `set_parts` takes what is to be painted. A closed surface hides
    its own triangles that face away; those are left out before they are sorted.
    """
    from matplotlib.artist import Artist
    from matplotlib.transforms import IdentityTransform

    class Triangles(Artist):
        def set_parts(self, parts: Sequence[Part], light: np.ndarray) -> None:
            """Set the surfaces of a frame and the direction of the light."""
            self.parts, self.light = parts, light

        def draw(self, renderer: Any) -> None:
            """Project the triangles and paint them from far to near."""
            if not self.parts:
                return
            vertices, faces, rgba, closed = _joined(self.parts)
            projection = axes.get_proj()
            points = vertices @ projection[:, :3].T + projection[:, 3]
            points = points[:, :3] / points[:, 3:]
            flat = axes.transData.transform(points[:, :2])
            a, b, c = (flat[faces[:, k]] for k in range(3))
            area = (b - a)[:, 0] * (c - a)[:, 1] - (b - a)[:, 1] * (c - a)[:, 0]
            seen = np.flatnonzero((area > 0) | ~closed)
            depth = points[:, 2][faces[seen]].sum(1)
            seen = seen[np.argsort(-depth)]
            faces, colours = faces[seen], rgba[seen]
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
    unit: np.ndarray = normal / np.where(lengths > 0, lengths, 1.0)
    return unit


def _joined(parts: Sequence[Part]) -> tuple[np.ndarray, np.ndarray, np.ndarray, np.ndarray]:
    """Return the parts as one: vertices, and of each triangle the corners, colour and `closed`."""
    counts = [len(part.faces) for part in parts]
    starts = np.cumsum([0] + [len(part.vertices) for part in parts[:-1]])
    faces = np.concatenate([part.faces for part in parts])
    faces = faces + np.repeat(starts, counts)[:, None]
    rgba = np.repeat([part.rgba for part in parts], counts, axis=0)
    closed = np.repeat([part.closed for part in parts], counts)
    return np.concatenate([part.vertices for part in parts]), faces, rgba, closed
