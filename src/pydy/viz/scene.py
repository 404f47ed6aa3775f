"""Scene: visuals, view and motion; the main class of `pydy.viz`."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from copy import copy
from dataclasses import replace
from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING, Any, Literal, NoReturn, Self, TypeAlias

import numpy as np
from sympy.physics.vector import Point, ReferenceFrame

from pydy._checks import (
    SymbolDict,
    choice,
    flag,
    instance,
    listed,
    number,
    shown,
    text,
    unit_and_factor,
    vector,
)
from pydy._dataset import STATES
from pydy._files import file_of, write_files
from pydy._interpolation import evenly
from pydy._names import nearest
from pydy._rank import ROUNDED
from pydy.trajectory import Trajectory
from pydy.viz.animation import Animation, Item, ViewSettings, animate
from pydy.viz.arguments import (
    as_visual,
    check_range,
    check_units,
    curves_of,
    events_of,
    filmed,
    ground_height,
    in_notebook,
    mode_intervals,
    named_constants,
    playback,
    plotted,
    recorded,
    series_of,
    symbols_of,
    units_of,
)
from pydy.viz.curves import TimeSeries, evaluated
from pydy.viz.defaults import unit_vector
from pydy.viz.floors import floors_of
from pydy.viz.live import live_page
from pydy.viz.motion import (
    SceneModel,
    SceneMotion,
    checked_samples,
    constants_of,
    forward,
    motion_of_arrays,
    motion_of_trajectory,
    sampled,
)
from pydy.viz.page import embedded, open_in_browser, page
from pydy.viz.shapes import Arrow, Plane, Trace
from pydy.viz.views import (
    PerspectiveCamera,
    animate_states,
    animate_system,
    direction_of,
    show_inline,
)
from pydy.viz.visuals import Visual, no_attribute

if TYPE_CHECKING:
    from os import PathLike

    from mpl_toolkits.mplot3d import Axes3D
    from numpy.typing import ArrayLike
    from sympy.physics.vector import Vector
    from xarray import Dataset

    from pydy._sympy_types import Body, BySymbol, ExpressionOrName, SymbolOrName
    from pydy.viz.live import Live, Slider

Run: TypeAlias = "Trajectory | Dataset"
Runs: TypeAlias = "Run | Sequence[Run] | Mapping[str, Run]"

# -- Comparison with other runs: semi-transparent copies of moving visuals -------------------------


def runs_of(compare: object) -> list[tuple[str, Trajectory]]:
    """Return labels and trajectories of `compare`; of an ensemble, evenly spaced members."""
    if compare is None:
        return []
    dataset = hasattr(compare, "data_vars")
    if isinstance(compare, Mapping) and not dataset:
        named = [(text(label, "a label in `compare`"), run) for label, run in compare.items()]
    elif isinstance(compare, (list, tuple)):
        named = [(f"run {k}", run) for k, run in enumerate(compare, 2)]
    else:
        named = [("compared", compare)]
    return [part for label, run in named for part in _members(label, run)]


def _members(label: str, run: Any) -> Iterator[tuple[str, Trajectory]]:
    if not hasattr(run, "data_vars"):
        if not (hasattr(run, "state_symbols") and hasattr(run, "at")):
            raise TypeError(
                "`compare` must be a Trajectory, an xarray.Dataset with the dimension 'time', or a "
                f"list or dictionary of these, got {shown(run)}."
            )
        yield label, run
        return
    states = [
        name
        for name, v in run.data_vars.items()
        if v.attrs.get("role") in ("coordinate", "speed", "auxiliary") and "time" in v.dims
    ]
    if not states:
        raise ValueError(
            "`compare` is a Dataset without states over `time`: keep them, with `reduce=None`."
        )
    samples = [d for d in run[states[0]].dims if d != "time"]
    flat = run.stack(member=samples) if samples else run.expand_dims("member")
    for k in evenly(flat.sizes["member"], 12).tolist():
        member = flat.isel(member=k)
        table = np.stack([np.asarray(member[name], dtype=float) for name in states], 1)
        if np.isfinite(table).all():  # samples that failed are not shown
            roles = member.coords.items()
            constants = {n: float(v) for n, v in roles if v.attrs.get("role") == "constant"}
            times = np.asarray(member["time"], dtype=float)
            lines = partial(_lines, times, table)
            kinds = {"coordinate": states}
            yield label, Trajectory(times, table, kinds, constants=constants, dense=lines)


def _lines(sample_times: np.ndarray, table: np.ndarray, times: np.ndarray) -> np.ndarray:
    """Interpolate a table of states linearly."""
    return np.stack([np.interp(times, sample_times, column) for column in table.T], 1)


def compared(
    animation: Animation, compare: Runs | None, animated: Callable[[Trajectory], Animation]
) -> Animation:
    """Return an animation with the moving visuals of other runs, fainter."""
    other_runs = []
    for label, run in runs_of(compare):  # before and after its times it is at rest
        times = np.clip(animation.times, run.times[0], run.times[-1])
        other_runs.append((label, animated(run.at(times))))
    if not other_runs:
        return animation
    items, bounds = list(animation.items), [animation.bounds]
    for label, animated_run in other_runs:
        frames: dict[ReferenceFrame | None, object] = {
            None: None
        }  # frames rotate differently in another run
        bounds.append(animated_run.bounds)
        shown_items = animation.items[: len(animated_run.items)]  # floors of contacts are last
        for item, shown_item in zip(animated_run.items, shown_items, strict=True):
            if not isinstance(item.shape, (Plane, Trace)) and _is_moving(item):
                items.append(_ghost(item, shown_item, label, frames))
    low = np.min([b[:, 0] for b in bounds], axis=0)
    high = np.max([b[:, 1] for b in bounds], axis=0)
    return replace(animation, items=tuple(items), bounds=np.stack([low, high], 1))


def _is_moving(item: Item) -> bool:
    arrays = (item.positions, item.rotations, item.vectors, item.points)
    return any(a is not None and np.ptp(a, axis=0).any() for a in arrays)


def _ghost(
    item: Item, shown_item: Item, label: str, frames: dict[ReferenceFrame | None, object]
) -> Item:
    visual = copy(item.visual)
    frame = frames.setdefault(visual.frame, object())
    for attribute, value in (("frame", frame), ("name", label), ("trail", False)):
        object.__setattr__(visual, attribute, value)  # bypasses the checks of __setattr__
    shape = replace(item.shape, colour=shown_item.shape.colour, opacity=0.3 * item.shape.opacity)
    if (
        item.vectors is not None
        and isinstance(shape, Arrow)
        and isinstance(shown_item.shape, Arrow)
    ):
        # One scale for all runs, so that lengths can be compared.
        scale, run_scale = shown_item.shape.scale, shape.scale
        assert scale is not None
        assert run_scale is not None
        item = replace(item, vectors=item.vectors * (scale / run_scale))
        shape = replace(shape, scale=scale)
    return replace(item, visual=visual, shape=shape)


# -- The scene -------------------------------------------------------------------------------------


_ARGUMENTS = ("up", "ground", "follow", "view", "series", "title", "units", "system", "cameras")
_MOTION = ("states_symbols", "states_trajectories", "constants", "times", "frames_per_second")
_IGNORED = ("lights", "width", "height", "name", "fov")


class Scene:
    """Visuals in a reference frame.

    Parameters
    ----------
    reference_frame : ReferenceFrame
        Frame in which the scene is shown.
    origin : Point
        Origin of the scene.
    *visuals : Visual, RigidBody or Particle
        Bodies get a default shape. Can also be set later, as `visualization_frames`.
    up : str or Vector, optional
        Upward direction on the screen: an axis of the reference frame such as ``'y'`` or ``'-z'``,
        or a constant vector.
    ground : bool or float, optional
        Height of the grid above the origin. If True, it is below everything that moves. If False,
        there is no grid. By default it is at the height of a horizontal floor of the trajectory's
        contacts, whose other planes are drawn as well; without contacts as if True.
    follow : bool, optional
        Whether the camera follows the visuals; by default it does if they travel far.
    view : sequence of 3 numbers, optional
        Direction from the scene to the camera at the start, in the reference frame.
    series : mapping of str to expressions, or iterable of expressions, optional
        Quantities to plot over time below the animation. Quantities in the trajectory, such as
        outputs, are looked up by symbol or name; others are evaluated.
    title : str, optional
    units : mapping of str or symbols to str or (str, float), optional
        Units of the series, shown with their labels. With a factor, as in ``{'q': ('deg',
        180/np.pi)}``, the values are multiplied by it.
    system : System, optional
        Provides the motion if the scene is displayed without a call of `animate`.
    cameras : sequence of PerspectiveCamera, optional
        The first determines the `view`. Lights and window sizes are accepted and ignored.

    Raises
    ------
    TypeError, ValueError
        An argument is invalid; the message names it.

    Notes
    -----
    Instead of calling `animate`, you can set the attributes `states_symbols`,
    `states_trajectories`, `constants` and `times`, or pass them as arguments; `display` then
    animates the scene and shows it. Shapes and visuals can be changed at any time.

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
        reference_frame: ReferenceFrame,
        origin: Point,
        *visuals: Visual | Body,
        up: Vector | ArrayLike = "y",
        ground: bool | float | None = None,
        follow: bool | None = None,
        view: Vector | ArrayLike | None = None,
        series: Mapping[str, ExpressionOrName | float] | Iterable[ExpressionOrName | float] = (),
        title: str = "",
        units: BySymbol[str | tuple[str, float]] | None = None,
        model: SceneModel | None = None,
        system: Any = None,
        cameras: Iterable[PerspectiveCamera] = (),
        **legacy: object,
    ) -> None:
        unknown = [name for name in legacy if name not in (*_MOTION, *_IGNORED)]
        if unknown:
            names = (*_ARGUMENTS, *_MOTION, *_IGNORED)
            raise TypeError(f"Scene has no argument `{unknown[0]}`. {nearest(unknown[0], names)}")
        instance(reference_frame, ReferenceFrame, "`reference_frame`")
        instance(origin, Point, "`origin`")
        self.reference_frame = reference_frame
        self.origin = origin
        self.visuals = tuple(as_visual(v) for v in visuals)
        self.system = system
        self.constants: BySymbol[float] = {}
        self.states_symbols: Sequence[SymbolOrName] | None = None
        self._states: Any = None
        self._times: ArrayLike | None = None
        self.frames_per_second = 30.0
        self.series = series_of(series)
        self._model = model
        self._units = units_of(units)
        self._settings = ViewSettings(
            up_axis=unit_vector(up, reference_frame, "up"),
            ground=ground_height(ground),
            follow=None if follow is None else flag(follow, "`follow`"),
            view=None if view is None else unit_vector(view, reference_frame, "view"),
            title=text(title, "`title`"),
            units={k: unit_and_factor(unit, "units") for k, unit in self._units.items()},
        )
        self._animation: Animation | None = None
        self._last_call: Any = (
            None  # arguments of the last call of `animate`, and versions of the visuals
        )
        self.cameras = cameras
        for name in _MOTION:
            if name in legacy:
                setattr(self, name, legacy[name])

    def __repr__(self) -> str:
        instants = f", {len(self._animation.times)} instants" if self._animation else ""
        return (
            f"Scene({self.reference_frame}, {self.origin}, {len(self.visuals)} visuals{instants})"
        )

    # -- motion -----------------------------------------------------------------------------------

    def animate(
        self,
        trajectory: Trajectory | ArrayLike | None = None,
        states: ArrayLike | None = None,
        *,
        symbols: Sequence[SymbolOrName] | None = None,
        constants: BySymbol[float] | None = None,
        specifieds: BySymbol[ArrayLike] | None = None,
        series: Mapping[str, ArrayLike] | None = None,
        compare: Runs | None = None,
        fps: float | None = 60.0,
        speed: float | None = None,
    ) -> Self:
        """Set the motion of the scene.

        Call it with a Trajectory, ``animate(trajectory)``, or with arrays, ``animate(times,
        states)``.

        Parameters
        ----------
        trajectory : Trajectory, or array_like, shape (m,)
            A trajectory, or the times.
        states : array_like, shape (m, n), optional
        symbols : sequence of functions of time, optional
            Symbols of the columns of `states`; known if the scene was made by ``system.scene()``.
        constants : mapping of symbols or names to numbers, optional
            Values that are missing in, or override, those of the trajectory and the system; by
            default the scene's `constants`.
        specifieds : mapping of functions of time to numbers or arrays of shape (m,), optional
            Only together with `symbols`.
        series : mapping of str to array_like, shape (m,), optional
            Further quantities to plot over time, already evaluated.
        compare : Trajectory, xarray.Dataset, or a list or dictionary of these, optional
            Other runs, drawn semi-transparently at the same times, with their labels. Of an
            ensemble's Dataset up to a dozen members are shown.
        fps : float or None, optional
            Number of instants for each second shown: of closer ones some are left out, and between
            distant ones those are added that a native solver knows. None keeps its own alone.
        speed : float, optional
            Seconds of the trajectory for each second shown; by default 1, unless the animation
            would be too short or too long.

        Returns
        -------
        Scene
            The scene itself, so that calls can be chained.

        Raises
        ------
        TypeError, ValueError
            The trajectory belongs to another system, a frame or point is not connected to the
            scene's, or a symbol has no value. The message names it and the remedy.
        """
        if not self.visuals:
            raise ValueError(
                "A Scene needs at least one visual, such as Visual(Sphere(0.1), point), or a body: "
                "pass them to Scene, or set `scene.visualization_frames`."
            )
        model = self._model
        if states is None and model is not None and not hasattr(trajectory, "state_symbols"):
            # `animate(states)` at the times of the system.
            trajectory, states = (model.times() if model.times else None), trajectory
        motion_times = trajectory if states is not None else getattr(trajectory, "times", None)
        curves = {} if motion_times is None else curves_of(series, motion_times)
        film = detail = trajectory
        if states is None:
            film = detail = filmed(trajectory, fps, speed)
            if self.series:
                detail = plotted(trajectory, fps, speed)
        if constants is None:
            constants = self.constants
        options = (symbols, constants, specifieds, compare, fps, speed)
        self._set_motion(film, detail, states, curves, options)
        return self

    def _set_motion(
        self,
        film: Any,
        detail: Any,
        states: ArrayLike | None,
        curves: dict[str, TimeSeries],
        options: tuple[Any, ...],
    ) -> None:
        """Set the motion from a film with its instants, and from details for the curves."""
        *_, compare, fps, speed = options
        motion = forward(self._motion_of(film, states, options[:3]))
        rate, step = playback(fps, speed, float(motion.times[-1] - motion.times[0]))
        names_of = getattr(film, "names_of", None)
        states_of = () if options[0] is None else options[0]
        check_units(self._units, self.series, states_of if names_of is None else names_of(*STATES))
        scene = (self.reference_frame, self.origin, self.visuals)
        film_motion = motion.at_rows(sampled(motion.times, step))
        animation = animate(*scene, film_motion)
        if (gaps := getattr(film, "gaps", None)) and self._settings.ground is None:
            place, up_axis = scene[:2], self._settings.up_axis
            floors, height = floors_of(gaps, animation, film_motion, place, up_axis)
            if floors:
                animation = animate(*place, (*self.visuals, *floors), film_motion)
            animation = replace(animation, ground=height)

        def moved(run: Trajectory) -> Animation:
            values = (SymbolDict(motion.values) | dict(run.constants)).data
            symbols = symbols_of(self.visuals, self.series)
            return animate(*scene, motion_of_trajectory(run, self._model, values, symbols))

        curves_by_label = recorded(self.series, detail if states is None else None) | curves
        formulas = [(label, e) for label, e in self.series.items() if label not in curves_by_label]
        if formulas:
            fine = motion if detail is film else self._motion_of(detail, states, options[:3])
            curves_by_label |= evaluated(self.reference_frame, self.origin, formulas, fine)
        self._animation = replace(
            compared(animation, compare, moved),
            speed=rate,
            series={
                label: curves_by_label[label] for label in dict.fromkeys((*self.series, *curves))
            },
            events=events_of(film if states is None else None, motion.times),
            modes=mode_intervals(film if states is None else None, motion.times),
        )
        self._motion = film_motion
        # Stored with its instants: a pickle cannot evaluate others.
        self._last_call = (film, detail, states, curves, options), [v.version for v in self.visuals]

    def _motion_of(
        self, trajectory: Any, states: ArrayLike | None, options: tuple[Any, ...]
    ) -> SceneMotion:
        """Return the SceneMotion of the arguments of `animate`.

        `options` are symbols, constants and specifieds.
        """
        model, (symbols, constants, specifieds) = self._model, options
        requested = symbols_of(self.visuals, self.series)
        if states is not None:
            if symbols is not None or model is None or model.trajectory is None:
                return motion_of_arrays(trajectory, states, symbols, constants, specifieds)
            checked = checked_samples(trajectory, states, len(model.states))
            trajectory = model.trajectory(*checked)
        if specifieds is not None:
            raise ValueError(
                "`specifieds` are those of plain arrays, for which `symbols` says what the columns "
                f"are, got {shown(specifieds)} without `symbols`. A trajectory has its own: leave "
                "them out, or simulate with others."
            )
        scene = (self.reference_frame, self.origin, self.visuals)
        constants = named_constants(constants, constants_of(trajectory), scene, self.series)
        return motion_of_trajectory(trajectory, model, constants, requested)

    @property
    def times(self) -> np.ndarray:
        """Times that are shown, shape (m,).

        Can be set, with `states_trajectories`; otherwise `frames_per_second`, 30, sets their step.
        """
        return self._moving().times

    @times.setter
    def times(self, times: ArrayLike) -> None:
        self._times, self._animation = times, None

    @property
    def states_trajectories(self) -> Any:
        """States to show, shape (m, n), with `states_symbols` for their columns, at `times`."""
        return self._states

    @states_trajectories.setter
    def states_trajectories(self, states: ArrayLike) -> None:
        self._states, self._animation = states, None

    @property
    def visualization_frames(self) -> list[Visual]:
        """Visuals of the scene. After setting them, call `animate` again."""
        return list(self.visuals)

    @visualization_frames.setter
    def visualization_frames(self, visuals: Iterable[Visual | Body]) -> None:
        self.visuals = tuple(
            as_visual(v) for v in listed("visualization_frames", visuals, "Visuals")
        )
        self._animation = None

    @property
    def system(self) -> Any:
        """The System that provides the motion if `animate` was not called, or None."""
        return self._system

    @system.setter
    def system(self, system: Any) -> None:
        if system is not None and not hasattr(system, "simulate"):
            raise TypeError(f"`system` must be a System, got {shown(system)}.")
        self._system = system

    @property
    def cameras(self) -> list[PerspectiveCamera]:
        """Cameras; the first determines the direction of view at the start."""
        return self._cameras

    @cameras.setter
    def cameras(self, cameras: Iterable[PerspectiveCamera]) -> None:
        self._cameras = listed("cameras", cameras, "PerspectiveCamera")
        for camera in self._cameras:
            if not isinstance(camera, PerspectiveCamera):
                raise TypeError(
                    f"`cameras` must hold PerspectiveCameras, got {shown(camera)}. Lights are "
                    "accepted as `lights`."
                )
        for camera in self._cameras[:1]:
            view = direction_of(camera, self.reference_frame, self.origin)
            self._settings = self._settings if view is None else replace(self._settings, view=view)

    @property
    def poses(self) -> np.ndarray:
        """Poses of all visuals at `times`, shape (m, v, 4, 4).

        ``poses[k, i] @ [x, y, z, 1]`` transforms a point of visual i from the axes of its frame to
        those of the scene.
        """
        return self._moving().poses

    def _moving(self) -> Animation:
        if self._animation and self._last_call[1] != [v.version for v in self.visuals]:
            self._set_motion(*self._last_call[0])  # a shape or visual was changed
        if self._animation is None and self._states is not None:
            times = self._times
            if times is None:
                times = np.arange(len(self._states)) / self.frames_per_second
            self.animate(times, self._states, symbols=self.states_symbols)
        elif self._animation is None and self.system is not None:
            scene = self.system.scene(
                *self.visuals, reference_frame=self.reference_frame, origin=self.origin
            )
            self._model, self.visuals = scene._model, scene.visuals
            self.animate(self.system.simulate())
        if self._animation is None:
            raise ValueError(
                "The scene does not move yet: call `scene.animate(trajectory)`, or "
                "`scene.animate(times, states)`, first."
            )
        return self._animation

    # -- the page ---------------------------------------------------------------------------------

    def html(
        self,
        theme: Literal["auto", "light", "dark"] = "auto",
        live: Live | BySymbol[Slider | tuple[float | str | None, ...]] | None = None,
    ) -> str:
        """Return the HTML page of the animation; see `to_html`."""
        chosen = choice(theme, ("auto", "light", "dark"), "`theme`")
        moving = self._moving()
        scene = (self.reference_frame, self.origin, self.visuals, self.series)
        live_content = live_page(
            live, self._model, self._settings.title, scene, moving, self._motion
        )
        return page(moving, self._settings, chosen, live_content)

    def to_html(
        self,
        path: str | PathLike[str],
        theme: Literal["auto", "light", "dark"] = "auto",
        live: Live | BySymbol[Slider | tuple[float | str | None, ...]] | None = None,
    ) -> Path:
        """Write the animation to a self-contained HTML file.

        Parameters
        ----------
        path : path
            Conventionally with the suffix ``.html``.
        theme : {'auto', 'light', 'dark'}, optional
            Colour theme; by default that of the reader's system.
        live : Live or mapping, optional
            Makes the page run the simulation, with sliders. Keys are constants, states (for
            initial conditions) and inputs, or their names; values are ranges, such as ``{l: (0.1,
            2.0)}``. See `Live`.

        Returns
        -------
        Path

        Raises
        ------
        ValueError
            `path` has the suffix of an image or a video, `live` has an unknown key, the scene was
            not made by `system.scene`, or a specified is given by a Python function or by samples.
        """
        target = file_of(path, "`path`")
        if target.suffix.lower() in (".png", ".pdf", ".svg", ".jpg", ".jpeg", ".gif", ".mp4"):
            raise ValueError(
                f"`path` must be the name of an HTML file, such as 'run.html', got "
                f"{str(target)!r}. For an image or a video, call `scene.save(path)`."
            )
        write_files({target: self.html(theme, live)})
        return target

    def show(self) -> Path | None:
        """Show the scene: inline in Jupyter, otherwise in the browser, from a temporary file.

        Pages that were shown more than an hour ago are deleted from the disk.
        """
        if in_notebook():
            from IPython.display import display  # a notebook has IPython

            self._moving()
            display(self)  # as an object, because IPython's HTML warns about iframes
            return None
        return open_in_browser(self.html())

    display = show

    generate_visualization_json = animate_states
    generate_visualization_json_system = animate_system

    if not TYPE_CHECKING:

        def __getattr__(self, name: str) -> NoReturn:
            no_attribute(self, name)

    display_jupyter = display_ipython = show_inline

    def _repr_html_(self) -> str | None:
        return None if self._animation is None else embedded(self.html())

    # -- figures and films ------------------------------------------------------------------------

    def to_matplotlib(self, t: float | None = None, axes: Axes3D | None = None) -> Axes3D:
        """Draw the scene at one time with Matplotlib.

        Parameters
        ----------
        t : float, optional
            From the first to the last time of the motion; by default the first.
        axes : mpl_toolkits.mplot3d.Axes3D, optional
            By default those of a new figure. The whole motion has room in them, so that pictures
            of several times fit together.

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
        first, last = float(moving.times[0]), float(moving.times[-1])
        slack = ROUNDED * max(abs(first), abs(last))
        instant = first if t is None else number(t, "`t`")
        if not first - slack <= instant <= last + slack:
            raise ValueError(
                f"`t` must be a time of the motion, from {first:g} to {last:g}, got {instant:g}."
            )
        return draw(moving, self._settings, instant, axes)

    def save(
        self,
        path: str | PathLike[str],
        *,
        fps: float = 30.0,
        dpi: int = 120,
        size: tuple[float, float] = (7, 5),
        progress: bool = False,
    ) -> Path:
        """Save a video (``.mp4``, ``.gif``) or an image of the start (``.png``, ``.pdf``, …).

        An image is centred on what is drawn in it; a video has room for the whole motion.

        Parameters
        ----------
        path : path
            The suffix selects the format.
        fps : float, optional
            Frames per second of the video; at most 50 in a GIF, as browsers slow down faster ones.
        dpi : int, optional
        size : (float, float), optional
            Width and height in inches.
        progress : bool, optional
            Whether to show a progress bar; requires tqdm.

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

        target = file_of(path, "`path`")
        width, height = vector(size, 2, "`size`").tolist()
        save(
            self._moving(),
            self._settings,
            target,
            check_range(fps, "`fps`", 1e-3, 1e3),
            check_range(dpi, "`dpi`", 10.0, 1e4),
            (check_range(width, "`size`", 0.5, 1e3), check_range(height, "`size`", 0.5, 1e3)),
            flag(progress, "`progress`"),
        )
        return target
