"""Scene: what is seen, from where; the one class that users of `pydy.viz` deal with."""

from __future__ import annotations

import tempfile
import webbrowser
from collections.abc import Iterable, Mapping
from dataclasses import replace
from pathlib import Path
from typing import Any, Literal, Self

import numpy as np
import sympy as sm
from sympy.physics.mechanics import Particle, RigidBody
from sympy.physics.vector import Point, ReferenceFrame

from pydy._checks import (
    check_mapping,
    choice,
    flag,
    number,
    path_of,
    real_array,
    shown,
    text,
    vector,
)
from pydy.viz.animation import Animation, animate
from pydy.viz.defaults import unit_vector
from pydy.viz.motion import Model, motion_of_arrays, motion_of_trajectory, sampled
from pydy.viz.page import Look, page
from pydy.viz.visuals import Visual

__all__ = ["Scene"]


class Scene:
    """Visuals in a reference frame.

    Parameters
    ----------
    reference_frame : ReferenceFrame
        What the scene is seen from.
    origin : Point
        Where its zero is.
    *visuals : Visual, RigidBody or Particle
        Bodies get a default shape.
    up : str or Vector, optional
        Which way is up on the screen: an axis of the reference frame such as ``'y'`` or ``'-z'``,
        or a constant vector.
    ground : bool or float, optional
        The height of the grid, counted upwards from the origin; by default, or True, below
        everything that moves. False: no grid.
    follow : bool, optional
        Whether the camera goes along with the visuals; by default where they travel far.
    view : sequence of 3 numbers, optional
        From which side the camera looks at the start, in the reference frame.
    series : mapping of str to expressions, or iterable of expressions, optional
        What to plot over time below the animation. What is in the trajectory, an output for
        instance, is taken from there by symbol or name; the rest is evaluated.
    title : str, optional

    Raises
    ------
    TypeError, ValueError
        An argument is of the wrong kind; the message names it.

    Examples
    --------
    A pendulum that swings by a formula of its own:

    >>> import numpy as np, sympy as sm
    >>> from sympy.physics.mechanics import Point, ReferenceFrame, dynamicsymbols
    >>> from pydy.viz import Line, Scene, Sphere, Visual
    >>> q, l = dynamicsymbols("q"), sm.Symbol("l")
    >>> N, O = ReferenceFrame("N"), Point("O")
    >>> P = O.locatenew("P", l*sm.sin(q)*N.x - l*sm.cos(q)*N.y)
    >>> scene = Scene(N, O, Visual(Line([O, P], radius=l/50)), Visual(Sphere(l/10), P))
    >>> times = np.linspace(0, 2, 121)
    >>> _ = scene.animate(times, np.sin(3*times)[:, None], symbols=[q], constants={l: 0.5})
    >>> scene.poses.shape
    (121, 2, 4, 4)
    >>> len(scene.html()) > 500_000
    True
    """

    def __init__(
        self,
        reference_frame: Any,
        origin: Any,
        *visuals: Any,
        up: Any = "y",
        ground: bool | float | None = None,
        follow: bool | None = None,
        view: Any = None,
        series: Any = (),
        title: str = "",
        model: Model | None = None,
    ) -> None:
        for argument, value, kind in (
            ("reference_frame", reference_frame, ReferenceFrame),
            ("origin", origin, Point),
        ):
            if not isinstance(value, kind):
                raise TypeError(
                    f"`{argument}` must be a {kind.__name__}, got the {type(value).__name__} "
                    f"{value!r}."
                )
        self.reference_frame = reference_frame
        self.origin = origin
        self.visuals = tuple(_visual(v) for v in visuals)
        if not self.visuals:
            raise ValueError(
                "A Scene needs at least one visual, such as Visual(Sphere(0.1), point), or a body."
            )
        self.series = _series(series)
        self._model = model
        self._look = Look(
            up=unit_vector(up, reference_frame, "up"),
            ground=_ground(ground),
            follow=None if follow is None else flag(follow, "`follow`"),
            view=None if view is None else unit_vector(view, reference_frame, "view"),
            title=text(title, "`title`"),
        )
        self._animation: Animation | None = None

    def __repr__(self) -> str:
        instants = f", {len(self._animation.times)} instants" if self._animation else ""
        return (
            f"Scene({self.reference_frame}, {self.origin}, {len(self.visuals)} visuals{instants})"
        )

    # -- motion -----------------------------------------------------------------------------------

    def animate(
        self,
        trajectory: Any = None,
        states: Any = None,
        *,
        symbols: Any = None,
        constants: Mapping[Any, Any] | None = None,
        specifieds: Mapping[Any, Any] | None = None,
        series: Mapping[str, Any] | None = None,
        fps: float | None = 60.0,
        speed: float | None = None,
    ) -> Self:
        """Set the scene in motion.

        Call it with a Trajectory, ``animate(trajectory)``, or with arrays, ``animate(times,
        states)``.

        Parameters
        ----------
        trajectory : Trajectory, or array_like, shape (m,)
            Or the times.
        states : array_like, shape (m, n), optional
        symbols : sequence of functions of time, optional
            What the columns of `states` are; a scene of ``system.scene()`` knows.
        constants : mapping of symbols to numbers, optional
            Those that neither trajectory nor system supplies, or others than theirs.
        specifieds : mapping of functions of time to numbers or arrays of shape (m,), optional
            With `symbols` only.
        series : mapping of str to array_like, shape (m,), optional
            More to plot over time, already evaluated, such as outputs.
        fps : float or None, optional
            How many instants to keep for each second shown, at most; None keeps all.
        speed : float, optional
            Seconds of the trajectory for each second shown; by default 1, unless that were too
            short or too long to watch.

        Returns
        -------
        Scene
            Itself, so that calls can be chained.

        Raises
        ------
        TypeError, ValueError
            The trajectory is one of another system, a frame or point is not related to the scene's,
            a symbol has no value; the message names the thing and the remedy.
        """
        model = self._model
        if states is None and model is not None and not hasattr(trajectory, "state_symbols"):
            # `animate(states)` at the times of the system.
            trajectory, states = (model.times() if model.times else None), trajectory
        if states is None:
            motion = motion_of_trajectory(trajectory, model, constants)
        elif symbols is None and model is not None and model.trajectory is not None:
            motion = motion_of_trajectory(model.trajectory(trajectory, states), model, constants)
        else:
            motion = motion_of_arrays(trajectory, states, symbols, constants, specifieds)
        if fps is not None:
            fps = number(fps, "`fps`")
            if not fps > 0:
                raise ValueError(f"`fps` must be positive, or None for all instants, got {fps}.")
        if speed is not None:
            speed = number(speed, "`speed`", finite=True)
            if not speed > 0:
                raise ValueError(f"`speed` must be a positive number, got {speed}.")
        self._speed = speed or _watchable(float(motion.times[-1] - motion.times[0]))
        rows = np.arange(len(motion.times))
        if fps is not None:
            rows = sampled(motion.times, self._speed / fps)
        columns = self._recorded(trajectory if states is None else None)
        columns.update(_columns(series, len(motion.times)))
        formulas = tuple((k, e) for k, e in self.series.items() if k not in columns)
        animation = animate(
            self.reference_frame, self.origin, self.visuals, formulas, motion.taken(rows)
        )
        values = {**animation.series, **{label: c[rows] for label, c in columns.items()}}
        order = dict.fromkeys((*self.series, *columns))
        self._animation = replace(animation, series={label: values[label] for label in order})
        return self

    def _recorded(self, trajectory: Any) -> dict[str, np.ndarray]:
        """Return those of the series that a trajectory holds."""
        columns = {}
        for label, expression in self.series.items():
            if hasattr(trajectory, "__contains__") and expression in trajectory:
                columns[label] = np.asarray(trajectory[expression], dtype=float)
            elif isinstance(expression, str):
                raise ValueError(
                    f"`series` has '{expression}', which is none of the trajectory's quantities. "
                    "Give an expression, or the name of a state, output or specified."
                )
        return columns

    @property
    def times(self) -> np.ndarray:
        """The instants that are shown, shape (m,)."""
        return self._moving().times

    @property
    def poses(self) -> np.ndarray:
        """The poses of all visuals at `times`, shape (m, v, 4, 4).

        ``poses[k, i] @ [x, y, z, 1]`` takes a point of visual i from the axes of its frame to those
        of the scene.
        """
        return self._moving().poses

    def _moving(self) -> Animation:
        if self._animation is None:
            raise ValueError(
                "The scene does not move yet: call `scene.animate(trajectory)`, or "
                "`scene.animate(times, states)`, first."
            )
        return self._animation

    # -- the page ---------------------------------------------------------------------------------

    def html(self, theme: Literal["auto", "light", "dark"] = "auto") -> str:
        """Return the page that shows the scene, complete in itself."""
        chosen = choice(theme, ("auto", "light", "dark"), "`theme`")
        return page(self._moving(), self._look, self._speed, chosen)

    def to_html(self, path: Any, theme: Literal["auto", "light", "dark"] = "auto") -> Path:
        """Write the page that shows the scene: one file, which needs no network.

        Parameters
        ----------
        path : path
            Conventionally with the suffix ``.html``.
        theme : {'auto', 'light', 'dark'}, optional
            By default that of the reader's system.

        Returns
        -------
        Path
        """
        target = path_of(path, "`path`")
        target.write_text(self.html(theme), encoding="utf-8")
        return target

    def show(self) -> Any:
        """Show the scene: inline in Jupyter, otherwise in the browser, from a temporary file."""
        if _in_notebook():
            from IPython.display import HTML, display  # where there is a notebook, there is IPython

            display(HTML(self._repr_html_()))
            return None
        path = Path(tempfile.mkdtemp(prefix="pydy-scene-")) / "scene.html"
        self.to_html(path)
        webbrowser.open(path.as_uri())
        return path

    def _repr_html_(self) -> str | None:
        from html import escape

        if self._animation is None:
            return None
        return (
            '<iframe title="Animation" sandbox="allow-scripts" allowfullscreen '
            'style="width: 100%; height: 520px; border: 0; border-radius: 8px" '
            f'srcdoc="{escape(self.html(), quote=True)}"></iframe>'
        )

    # -- figures and films ------------------------------------------------------------------------

    def to_matplotlib(self, t: float | None = None, axes: Any = None) -> Any:
        """Draw the scene at one instant with Matplotlib.

        Parameters
        ----------
        t : float, optional
            By default the first.
        axes : mpl_toolkits.mplot3d.Axes3D, optional
            By default those of a new figure.

        Returns
        -------
        Axes3D

        Raises
        ------
        ImportError
            Matplotlib is not installed.
        """
        from pydy.viz.figure import draw

        moving = self._moving()
        instant = float(moving.times[0]) if t is None else number(t, "`t`", finite=True)
        return draw(moving, self._look, instant, axes)

    def save(
        self,
        path: Any,
        *,
        fps: float = 30.0,
        dpi: int = 120,
        size: tuple[float, float] = (7, 5),
        progress: bool = False,
    ) -> Path:
        """Save a film (``.mp4``, ``.gif``) or a picture of the first instant (``.png``, ``.pdf``…).

        Parameters
        ----------
        path : path
            Its suffix decides.
        fps : float, optional
            Pictures for each second shown.
        dpi : int, optional
        size : (float, float), optional
            Width and height in inches.
        progress : bool, optional
            Whether a bar counts the pictures of a film; needs tqdm.

        Returns
        -------
        Path

        Raises
        ------
        ImportError
            Matplotlib, or Pillow for a GIF, is not installed.
        FileNotFoundError
            The program ffmpeg, for an MP4, is not installed.
        """
        from pydy.viz.figure import save

        target = path_of(path, "`path`")
        width, height = vector(size, 2, "`size`").tolist()
        save(
            self._moving(),
            self._look,
            self._speed,
            target,
            _within(fps, "`fps`", 1e-3, 1e3),
            _within(dpi, "`dpi`", 10.0, 1e4),
            (_within(width, "`size`", 0.5, 1e3), _within(height, "`size`", 0.5, 1e3)),
            flag(progress, "`progress`"),
        )
        return target


def _visual(thing: Any) -> Visual:
    if isinstance(thing, Visual):
        return thing
    if isinstance(thing, (RigidBody, Particle)):
        return Visual(None, thing)
    raise TypeError(
        "A Scene takes Visuals, RigidBodies and Particles after its frame and origin, got the "
        f"{type(thing).__name__} {thing!r}."
    )


def _series(series: Any) -> dict[str, Any]:
    if isinstance(series, Mapping):
        return {str(label): _entry(expression) for label, expression in series.items()}
    if not isinstance(series, Iterable) or isinstance(series, (str, bytes)):
        raise TypeError(
            "`series` must be a dictionary of labels and expressions, or a sequence of "
            f"expressions, got {shown(series)}."
        )
    # "q1(t)" says no more than "q1".
    return {str(_entry(e)).removesuffix("(t)"): e for e in series}


def _entry(value: Any) -> Any:
    if isinstance(value, (str, sm.Expr, int, float)):
        return value
    raise TypeError(
        "`series` must hold expressions, or names of what is in the trajectory, got "
        f"{shown(value)}."
    )


def _within(value: Any, what: str, least: float, most: float) -> float:
    """Return a number of a picture that can be drawn."""
    checked = number(value, what)
    if not least <= checked <= most:
        raise ValueError(f"{what} must be from {least:g} to {most:g}, got {checked}.")
    return checked


def _ground(value: Any) -> bool | float | None:
    if value is None or isinstance(value, (bool, np.bool_)):
        return None if value is None else bool(value)
    try:
        return number(value, "", finite=True)
    except ValueError:
        pass
    raise ValueError(f"`ground` must be a height, True or False, got {shown(value)}.")


def _columns(series: Mapping[str, Any] | None, count: int) -> dict[str, np.ndarray]:
    columns = {}
    for label, values in check_mapping("series", series).items():
        column = real_array(values, f"`series[{label!r}]`")
        if column.shape != (count,):
            raise ValueError(
                f"`series[{label!r}]` must have the shape ({count},), a value for each time, got "
                f"{column.shape}."
            )
        columns[str(label)] = column
    return columns


def _watchable(duration: float) -> float:
    """Return the speed, 1 or 2 or 5 times a power of ten, at which a film is watched in peace.

    Between one second and two minutes the film runs in real time.
    """
    if 1 <= duration <= 120 or duration <= 0:
        return 1.0
    wanted = duration / (10.0 if duration < 1 else 60.0)
    power = 10.0 ** np.floor(np.log10(wanted))
    return float(power * max(k for k in (1, 2, 5) if k * power <= wanted))


def _in_notebook() -> bool:
    import sys

    # Only a kernel displays; `get_ipython` exists on IPython's terminal too.
    ipython = sys.modules.get("IPython")
    shell = ipython.get_ipython() if ipython is not None else None
    return shell is not None and hasattr(shell, "kernel")
