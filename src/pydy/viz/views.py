"""Names used by scripts written for PyDy's viz package: visualization frames, cameras, lights."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from typing import TYPE_CHECKING, Any

import numpy as np
from sympy.physics.mechanics import Particle
from sympy.physics.vector import Point

from pydy._checks import listed, real_array, shown
from pydy.viz.arguments import check_range
from pydy.viz.shapes import Shape
from pydy.viz.visuals import Visual

if TYPE_CHECKING:
    from numpy.typing import ArrayLike
    from sympy.physics.vector import ReferenceFrame

    from pydy._sympy_types import SymbolOrName


def VisualizationFrame(*args: object) -> Visual:
    """Return a Visual, from the arguments in the order of PyDy's viz package.

    Parameters
    ----------
    *args
        An optional name; a ReferenceFrame and a Point or Particle, or a RigidBody; and a shape.

    Examples
    --------
    >>> from sympy.physics.mechanics import Point, ReferenceFrame
    >>> from pydy.viz import Cylinder, VisualizationFrame
    >>> VisualizationFrame("link", ReferenceFrame("B"), Point("P"), Cylinder(1.0, 0.1))
    Visual(link: Cylinder at P, turning with B)
    """
    name, arguments = _named(args)
    if not arguments or not isinstance(arguments[-1], Shape):
        raise TypeError(
            "A VisualizationFrame takes [name,] frame, point, shape; or [name,] body, shape; got "
            f"{', '.join(map(shown, args)) or 'nothing'}."
        )
    *attachment, shape = arguments
    if len(attachment) == 2:
        attachment = [item.point if isinstance(item, Particle) else item for item in attachment]
    return Visual(shape, *attachment, name=name)


class _Stationed:
    """A camera or a light at a point."""

    fov, near, far, color = 45.0, 1.0, 1000.0, "white"

    def __init__(self, *args: object, **options: object) -> None:
        self.name, attachment = _named(args)
        self.__dict__.update(options)
        points = [getattr(t, "masscenter", getattr(t, "point", t)) for t in attachment]
        points = [p for p in points if isinstance(p, Point)]
        if len(points) != 1:
            kind = type(self).__name__
            raise TypeError(
                f"A {kind} takes [name,] frame, point; or [name,] body; got "
                f"{', '.join(map(shown, args)) or 'nothing'}."
            )
        self.origin = points[0]


class PerspectiveCamera(_Stationed):
    """A camera of PyDy's viz package; it determines the direction of view at the start.

    Parameters
    ----------
    *args
        An optional name; a ReferenceFrame and a Point, or a body.
    **options
        Accepted and ignored: the page chooses the distance, and the reader can rotate the view.
    """


class OrthoGraphicCamera(PerspectiveCamera):
    """Like `PerspectiveCamera`; the page always uses a perspective projection."""


class PointLight(_Stationed):
    """A light of PyDy's viz package; accepted and ignored, since the page has its own lights.

    Parameters
    ----------
    *args
        An optional name; a ReferenceFrame and a Point, or a body.
    **options
        Accepted and ignored.
    """


def animate_states(
    scene: Any,
    dynamic_variables: Sequence[SymbolOrName],
    constant_variables: Sequence[SymbolOrName],
    dynamic_values: ArrayLike,
    constant_values: Sequence[float],
    fps: float = 30.0,
    outfile_prefix: object = None,
) -> None:
    """Animate states at `fps` instants a second, as in PyDy's viz package; writes no files.

    Parameters
    ----------
    dynamic_variables, constant_variables : sequence of symbols
    dynamic_values : array_like, shape (m, n)
    constant_values : sequence of numbers
    fps : float, optional
    outfile_prefix : str, optional
        Accepted and ignored: `display` and `to_html` need no other files.
    """
    rate = check_range(fps, "`fps`", 0.001, 1000.0)
    names = listed("constant_variables", constant_variables, "symbols", hashable=True)
    values = listed("constant_values", constant_values, "numbers")
    if len(names) != len(values):
        raise ValueError(
            f"`constant_values` must have {len(names)} numbers, one for each of "
            f"`constant_variables`, got {len(values)}."
        )
    states = real_array(dynamic_values, "`dynamic_values`")
    constants = dict(zip(names, values, strict=True))
    times = np.arange(len(np.atleast_1d(states))) / rate
    scene.animate(times, states, symbols=dynamic_variables, constants=constants)


def animate_system(scene: Any, system: object, **ignored: object) -> None:
    """Simulate and animate a System, as in PyDy's viz package; writes no files.

    Parameters
    ----------
    system : System
    **ignored
        `fps` and `outfile_prefix` are accepted and ignored.
    """
    if system is None:
        raise TypeError("`system` must be a System, got None.")
    scene.system, scene._states, scene._animation = system, None, None
    scene._moving()


def show_inline(
    scene: Any, window_size: object = None, axes_arrow_length: float | None = None
) -> Any:
    """Return the scene, animated, for a notebook to display.

    Parameters
    ----------
    window_size : (int, int), optional
        Accepted and ignored: the page is as wide as the notebook.
    axes_arrow_length : float, optional
        Length of the axes at the origin.
    """
    if axes_arrow_length is not None:
        length = check_range(axes_arrow_length, "`axes_arrow_length`", np.finfo(float).tiny, 1e300)
        scene._settings = replace(scene._settings, axes=length)
    scene._moving()
    return scene


def direction_of(
    camera: PerspectiveCamera, frame: ReferenceFrame, origin: Point
) -> np.ndarray | None:
    """Return the direction in which a camera is from the origin, or None where it moves."""
    try:
        position = camera.origin.pos_from(origin).to_matrix(frame)
        direction = np.array([float(c) for c in position])
    except (TypeError, ValueError):
        return None
    length = float(np.linalg.norm(direction))
    return direction / length if length > 0 else None


def _named(args: tuple[Any, ...]) -> tuple[str | None, list[Any]]:
    arguments = list(args)
    return (arguments.pop(0) if arguments and isinstance(arguments[0], str) else None), arguments
