"""Validation of the arguments of a Scene."""

from __future__ import annotations

import contextlib
from collections.abc import Iterable, Mapping, Sequence
from functools import partial
from pathlib import PurePath
from typing import TYPE_CHECKING, Any

import numpy as np
import sympy as sm
from sympy.physics.mechanics import Particle, RigidBody

from pydy._checks import (
    SymbolIndex,
    check_mapping,
    listed,
    merged,
    monotonic,
    number,
    positive,
    real_array,
    refuse_twice,
    shown,
    typed,
    unit_and_factor,
)
from pydy._interpolation import detailed, filled
from pydy._mechanics import find_symbols, sort_symbols
from pydy._names import name_of, some
from pydy._rank import DIGITS, HALF
from pydy.viz.curves import TimeSeries, curve
from pydy.viz.shapes import Arrow, Line
from pydy.viz.visuals import Visual

if TYPE_CHECKING:
    from numpy.typing import ArrayLike
    from sympy.physics.mechanics import Point, ReferenceFrame

    from pydy._sympy_types import AnySymbol, BySymbol, ExpressionOrName, SymbolOrName


def as_visual(item: object) -> Visual:
    """Return a Visual; a body gets a default shape."""
    if isinstance(item, Visual):
        return item
    if isinstance(item, (RigidBody, Particle)):
        return Visual(None, item)
    remedy = (
        " To write a file, call `to_html(path)` of the animated scene, or `save(path)` for a film."
        if isinstance(item, (str, PurePath))
        else ""
    )
    raise TypeError(
        "A Scene takes Visuals, RigidBodies and Particles after its frame and origin, got "
        f"{typed(item)}.{remedy}"
    )


def series_of(series: object) -> dict[str, ExpressionOrName | float]:
    """Read the expressions to plot, by label."""
    if isinstance(series, Mapping):
        return {str(label): _entry(expression) for label, expression in series.items()}
    if not isinstance(series, Iterable) or isinstance(series, (str, bytes)):
        raise TypeError(
            "`series` must be a dictionary of labels and expressions, or a sequence of "
            f"expressions, got {shown(series)}."
        )
    # "q1(t)" says no more than "q1".
    entries = listed("series", series, "expressions")
    return {str(_entry(e)).removesuffix("(t)"): e for e in entries}


def _entry(value: object) -> ExpressionOrName | float:
    if isinstance(value, (str, sm.Expr, int, float)):
        return value
    raise TypeError(
        "`series` must hold expressions, or names of what is in the trajectory, got "
        f"{shown(value)}."
    )


def live_unknowns(
    set_states: set[int],
    dependents: tuple[list[int], list[int]],
    sizes: tuple[int, int],
    states: Sequence[AnySymbol],
) -> list[list[int]]:
    """Return the positions in x of the states for which a live page solves the constraints.

    Those are the dependent coordinates and speeds. If sliders set one of them, all coordinates, or
    speeds, without a slider are solved for. `sizes` counts both.
    """
    unknowns = []
    spans = (range(sizes[0]), range(sizes[0], sum(sizes)))
    for span, dependent, kind in zip(spans, dependents, ("coordinates", "speeds"), strict=True):
        if not set_states.intersection(dependent):
            unknowns.append(dependent)
            continue
        free = [k for k in span if k not in set_states]
        if len(free) < (1 if len(dependent) == len(span) else len(dependent)):
            names = some(f"`{states[k]}`" for k in span if k in set_states)
            raise ValueError(
                f"`live` sets the {kind} {names}, but the constraints determine "
                f"{len(dependent)} of {len(span)} from the others: leave sliders out."
            )
        unknowns.append(free)
    return unknowns


def check_range(value: object, argument: str, least: float, most: float) -> float:
    """Return a number within a range, or raise a ValueError."""
    checked = number(value, argument)
    if not least <= checked <= most:
        raise ValueError(f"{argument} must be from {least:g} to {most:g}, got {checked}.")
    return checked


def ground_height(value: object) -> bool | float | None:
    """Return the height of the ground, or whether there is one, or None to decide later."""
    if value is None or isinstance(value, (bool, np.bool_)):
        return None if value is None else bool(value)
    try:
        return number(value, "", finite=True)
    except ValueError:
        pass
    raise ValueError(f"`ground` must be a height, True or False, got {shown(value)}.")


def curves_of(
    series: Mapping[str, ArrayLike] | None, motion_times: object
) -> dict[str, TimeSeries]:
    """Return the curves of evaluated series, with a value for each time of the motion."""
    values_by_label = check_mapping("series", series)
    if not values_by_label:
        return {}
    curves, times = {}, monotonic(motion_times, "`times`")
    count = len(times)
    for label, values in values_by_label.items():
        column = real_array(values, f"`series[{label!r}]`")
        if column.shape != (count,):
            raise ValueError(
                f"`series[{label!r}]` must have the shape ({count},), a value for each time, got "
                f"{column.shape}."
            )
        curves[str(label)] = curve(times, column)
    return curves


def recorded(
    series: Mapping[str, ExpressionOrName | float], trajectory: Any
) -> dict[str, TimeSeries]:
    """Return the series that are quantities of a trajectory."""
    curves = {}
    for label, expression in series.items():
        if hasattr(trajectory, "__contains__") and expression in trajectory:
            values = np.asarray(trajectory[expression], dtype=float)
            curves[label] = curve(np.asarray(trajectory.times, dtype=float), values)
        elif isinstance(expression, str):
            raise ValueError(
                f"`series` has '{expression}', which is not one of the trajectory's quantities. "
                "Give an expression, or the name of a state, output or specified."
            )
    return curves


def symbols_of(
    visuals: Iterable[Visual], series: Mapping[str, ExpressionOrName | float]
) -> set[AnySymbol]:
    """Return the symbols and derivatives in arrows and series."""
    expressions = [sm.sympify(e) for e in series.values() if not isinstance(e, str)]
    for visual in visuals:
        if isinstance(visual.shape, Arrow):
            expressions += [c for components, _ in visual.shape.vector.args for c in components]
    return set(find_symbols(expressions))


def named_constants(
    constants: BySymbol[float] | None,
    defaults: Mapping[SymbolOrName, float],
    scene: tuple[ReferenceFrame, Point, Sequence[Visual]],
    series: Mapping[str, ExpressionOrName | float],
) -> dict[SymbolOrName, float]:
    """Return the user's constants, keyed by the symbols of the trajectory's constants.

    Another key must be a symbol in the scene (a reference frame, an origin and visuals) or in its
    series.
    """
    values = merged(check_mapping("constants", constants))
    if not defaults:  # a trajectory without constants
        return dict(values)
    # A trajectory from a file has names instead of symbols.
    values = {name_of(key) if name_of(key) in defaults else key: v for key, v in values.items()}
    lookup = SymbolIndex([*defaults], "constants of the trajectory")
    if lookup.unknown(values, "constants"):
        with contextlib.suppress(ValueError):  # unrelated frames and points raise an error later
            lookup = SymbolIndex(
                [
                    *defaults,
                    *sort_symbols(_symbols_of_scene(*scene, series) - {*defaults}),
                ],
                "constants of the trajectory and of the scene",
            )
    return lookup.by_symbol(values, "constants")


def _symbols_of_scene(
    reference: ReferenceFrame,
    origin: Point,
    visuals: Sequence[Visual],
    series: Mapping[str, ExpressionOrName | float],
) -> set[sm.Symbol]:
    """Return the symbols that `constants` may give values for, besides those of a trajectory.

    They are in the positions, orientations, shapes and bodies of visuals, in arrows and series.
    """
    frames: set[ReferenceFrame] = set()
    expressions: list[object] = []
    for visual in visuals:
        shape, body = visual.shape, visual.body
        frames |= {visual.frame} - {None}
        expressions += [] if shape is None else [getattr(shape, name) for name in shape.lengths]
        expressions += [] if body is None else [body.mass]
        if isinstance(body, RigidBody):
            expressions += [*body.central_inertia.to_matrix(body.frame)]
        for point in (visual.point, *(shape.points if isinstance(shape, Line) else ())):
            for components, frame in point.pos_from(origin).args:
                frames.add(frame)
                expressions += [*components]
    for frame in frames:
        expressions += [*reference.dcm(frame)]
    expressions = [e for e in expressions if isinstance(e, sm.Expr)]
    return {s for s in (*find_symbols(expressions), *symbols_of(visuals, series)) if s.is_Symbol}


def units_of(units: object) -> dict[str, object]:
    """Return units, and pairs of these and factors, by the label of a series."""
    units_by_key = check_mapping("units", units)
    labels = [str(key).removesuffix("(t)") for key in units_by_key]
    refuse_twice(labels, "units")
    for key, unit in units_by_key.items():
        unit_and_factor(unit, f"units[{key}]")
    return dict(zip(labels, units_by_key.values(), strict=True))


def check_units(
    units: Mapping[str, object],
    series: Mapping[str, ExpressionOrName | float],
    states: Iterable[SymbolOrName],
) -> None:
    """Refuse degrees, without a factor, of a series that is a state."""
    names = {name_of(state) for state in states}
    for label, unit in units.items():
        state = name_of(series.get(label, ""))
        unit_and_factor(unit, f"units[{label}]", state if state in names else "")


def events_of(trajectory: object, times: np.ndarray) -> tuple[tuple[float, str], ...]:
    """Return times and names of the events that are shown; at most a hundred."""
    events = [(float(e.time), str(e.name)) for e in getattr(trajectory, "events", ())]
    visible = [event for event in events if times[0] <= event[0] <= times[-1]]
    return tuple(visible[:: max(1, -(-len(visible) // 100))])


def mode_intervals(
    trajectory: object, times: np.ndarray
) -> dict[str, list[tuple[float, float, str]]]:
    """Return the intervals of each contact's modes within the times that are shown.

    Intervals narrower than a pixel of a wide screen are shown as the mode before them.
    """
    begin, end = float(times[0]), float(times[-1])
    spans_by_contact: dict[str, list[tuple[float, float, str]]] = {}
    for first, last, modes in getattr(trajectory, "modes", ()):
        first, last = max(float(first), begin), min(float(last), end)
        if first >= last:
            continue
        for name, mode in modes.items():
            spans = spans_by_contact.setdefault(name, [])
            if spans and (spans[-1][2] == mode or (last - first) * 2000 < end - begin):
                spans[-1] = spans[-1][0], last, spans[-1][2]
            else:
                spans.append((first, last, mode))
    return spans_by_contact


def playback(fps: float | None, speed: float | None, duration: float) -> tuple[float, float | None]:
    """Return the speed of a film and the time between its instants; None keeps all instants."""
    if fps is not None:
        fps = number(fps, "`fps`")
        if not fps > 0:
            raise ValueError(f"`fps` must be positive, or None for all instants, got {fps}.")
    if speed is not None:
        speed = positive(speed, "`speed`", finite=True)
    chosen = speed or watchable_speed(duration)
    return chosen, None if fps is None else chosen / fps


def filmed(trajectory: Any, fps: float | None, speed: float | None) -> Any:
    """Return a trajectory with an instant for each picture of a film, if it can be interpolated."""
    return filled(trajectory, partial(_step_of, fps, speed))


def plotted(trajectory: Any, fps: float | None, speed: float | None) -> Any:
    """Return a trajectory for the curves of a film, also with details between its pictures."""
    return detailed(trajectory, partial(_step_of, fps, speed))


def _step_of(fps: float | None, speed: float | None, duration: float) -> float:
    step = playback(fps, speed, duration)[1]
    # At most as many pictures as two minutes at 60 pictures a second.
    return np.inf if step is None else max(step * (1.0 - DIGITS), duration / 7200)


def watchable_speed(duration: float) -> float:
    """Return a comfortable speed of a film, a round number.

    Between one second and two minutes the film runs in real time.
    """
    if 1 <= duration <= 120 or duration <= 0:
        return 1.0
    target = duration / (10.0 if duration < 1 else 60.0)
    return round_number(target)


def round_number(most: float) -> float:
    """Return the largest number of the form 1, 2 or 5 times a power of ten up to a limit."""
    power = 10.0 ** np.floor(np.log10(most))
    return float(power * max(k for k in (1, 2, 5, 10) if k * power <= most * (1.0 + HALF)))


def in_notebook() -> bool:
    """Tell whether output goes to a notebook."""
    import sys

    # Only a kernel displays; `get_ipython` exists on IPython's terminal too.
    ipython = sys.modules.get("IPython")
    shell = ipython.get_ipython() if ipython is not None else None
    return shell is not None and hasattr(shell, "kernel")
