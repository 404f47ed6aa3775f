"""An artist of Matplotlib that paints all triangles of a scene in one call.

Axes3D draws a triangle as a path with an edge, and sorts within each surface only. Here all
surfaces are sorted together.
"""

from __future__ import annotations

from typing import Any

import numpy as np

__all__ = ["make_triangles"]


def make_triangles(axes: Any) -> Any:
    """Add an artist to an Axes3D and return it.

    Its `corners`, shape (n, 3, 3), and `colours`, shape (n, 4), are set before each frame.
    """
    from matplotlib.artist import Artist
    from matplotlib.transforms import IdentityTransform

    class Triangles(Artist):
        corners = np.zeros((0, 3, 3))
        colours = np.zeros((0, 4))

        def draw(self, renderer: Any) -> None:
            """Project the triangles and paint them from far to near."""
            if not len(self.corners):
                return
            projection = axes.get_proj()
            points = self.corners.reshape(-1, 3) @ projection[:, :3].T + projection[:, 3]
            points = points[:, :3] / points[:, 3:]
            order = np.argsort(-points[:, 2].reshape(-1, 3).sum(1))
            flat = axes.transData.transform(points[:, :2]).reshape(-1, 3, 2)[order]
            colours = np.repeat(self.colours[order, None], 3, axis=1)
            context = renderer.new_gc()
            renderer.draw_gouraud_triangles(context, flat, colours, IdentityTransform())
            context.restore()

    triangles = Triangles()
    triangles.set_zorder(1.0)  # above the grid, below lines
    axes.add_artist(triangles)
    triangles.set_clip_on(False)
    return triangles
