"""Measured motions as a user gives them, checked and normalised."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

import numpy as np
import sympy.physics.mechanics as me

from pydy._assembly.definition import Definition
from pydy._checks import (
    Places,
    ascending,
    check_mapping,
    describe,
    number,
    one_or_more,
    real_array,
    refuse_twice,
    shown,
    text,
)
from pydy._mechanics.symbols import find_symbols
from pydy._names import some, unique_names
from pydy._system.definition import sort_out
from pydy.analysis.fit import Trial


@dataclass(frozen=True, eq=False)
class Data:
    """A trial as it was checked."""

    trial: Trial
    label: str
    times: np.ndarray  # (m,)
    start: float
    keys: list[Any]  # what each measured quantity is in a trajectory
    names: list[str]  # what the user called it
    values: np.ndarray  # (m, q)
    noise: np.ndarray  # (m, q)
    unknown: list[Any]  # symbols of states


def _instants(trial: Trial, label: str) -> tuple[np.ndarray, float]:
    """Return the times of a trial, and when it starts."""
    times = real_array(trial.times, f"`times` of {label}")
    if times.ndim != 1 or not len(times):
        raise ValueError(f"`times` of {label} must have the shape (m,), got {times.shape}.")
    ascending(times, f"`times` of {label}", strict=True)
    begin = float(times[0])
    if trial.start is not None:
        begin = number(trial.start, f"`start` of {label}", finite=True)
        if begin > times[0]:
            raise ValueError(
                f"`start` of {label} must not lie after the first of the `times`, "
                f"{float(times[0])!r}, got {begin!r}."
            )
    return times, begin


def checked_trial(k: int, trial: Any, definition: Definition, expressions: dict[Any, Any]) -> Data:
    """Check a trial, the k-th; expressions that it measures get names in `expressions`."""
    states = definition.places["states"]
    measurable = Places([*definition.states, *definition.outputs_symbols],
                        "states and outputs of the system")  # fmt: skip
    label = f"trial {k}"
    if not isinstance(trial, Trial):
        raise TypeError(
            "`trials` must be pydy.analysis.Trial, or a list of them: Trial(times, "
            "{'q1': samples}) says when samples were taken, and of which state, output or "
            "expression. Got "
            f"{shown(trial)} at {k}."
        )
    label = text(trial.name, f"`name` of {label}") or label
    times, begin = _instants(trial, label)
    measured = check_mapping(f"measured of {label}", trial.measured)
    if not measured:
        raise ValueError(f"`measured` of {label} must hold at least one quantity.")
    keys, columns = [], []
    for key, samples in measured.items():
        keys.append(_key(key, label, definition, measurable, expressions))
        column = real_array(samples, f"`measured[{key}]` of {label}")
        if column.shape != times.shape:
            raise ValueError(
                f"`measured[{key}]` of {label} must have the shape {times.shape}, a sample for "
                f"each of the `times`, got {column.shape}."
            )
        if np.isinf(column).any():
            raise ValueError(
                f"`measured[{key}]` of {label} must be finite, or NaN where a sample is missing."
            )
        columns.append(column)
    refuse_twice(keys, f"measured of {label}")
    values = np.stack(columns, axis=1)
    if np.isnan(values).all():
        raise ValueError(
            f"`measured` of {label} must hold at least one sample that is not NaN, but all "
            f"{values.size} are. Leave the trial out."
        )
    unknown = states.chosen(one_or_more("unknown", trial.unknown), f"unknown of {label}")
    names = list(unique_names(list(measured)))
    given = trial.noise
    if isinstance(given, Mapping):
        known = {**dict(zip(names, keys, strict=True)), **dict(zip(measured, keys, strict=True))}
        meant = [known.get(key, measurable.meaning(key, "noise")) for key in given]
        refuse_twice(meant, f"noise of {label}")
        given = dict(zip(meant, given.values(), strict=True))
    noise = _noise(given, keys, names, values.shape, label)
    sizes = np.fmax.reduce(np.abs(values) / noise)
    largest = 2.0**255  # SciPy's search forms the third power of residuals, and sums
    if (far := np.flatnonzero(sizes > largest)).size:
        raise ValueError(
            f"`measured[{names[far[0]]}]` of {label} must be at most {largest:.1e} in units "
            f"of `noise`, got {sizes[far[0]]:.3g}: powers of such residuals are out of the range "
            "of floats. Choose units in which they are smaller."
        )
    return Data(trial, label, times, begin, keys, names, values, noise, unknown)


def _key(
    key: Any, label: str, definition: Definition, measurable: Places, expressions: dict[Any, Any]
) -> Any:
    place = measurable.get(key, "measured")
    if place is not None:
        return measurable.symbols[place]
    inside = find_symbols([key]) if hasattr(key, "free_symbols") else ()
    if isinstance(key, str) or not inside:
        measurable.find(key, f"measured of {label}")  # raises, with names that are alike
    known = (*measurable.symbols, *definition.constants, *definition.specifieds)
    held = [s for part in sort_out(definition.equations, [key], known) for s in part]
    if held:
        raise ValueError(
            f"`measured[{key}]` of {label} holds `{held[0]}`, but no argument provides it: it is "
            "not one of the states, constants, specifieds and outputs of the system. Make the "
            "expression one of the `outputs`, and give the value there."
        )
    if key not in expressions:
        expressions[key] = me.dynamicsymbols(f"measured_{len(expressions)}")
    return expressions[key]


def _noise(
    given: Any,
    keys: list[Any],
    names: list[str],
    shape: tuple[int, ...],
    label: str,
) -> np.ndarray:
    noise = np.ones(shape)
    if given is None:
        return noise
    entries = [given] * len(keys)
    if isinstance(given, Mapping):
        if given.keys() != {*keys}:
            raise ValueError(
                f"`noise` of {label} must have an entry for each measured quantity, "
                f"{some(names)}, got {describe([*given])}."
            )
        entries = [given[key] for key in keys]
    for k, entry in enumerate(entries):
        column = real_array(entry, f"`noise` of {label}")
        sound = ((column > 0.0) & (column < np.inf)).all()
        if column.shape not in ((), shape[:1]) or not sound:
            raise ValueError(
                f"`noise` of {label} must be positive standard deviations, a finite number or "
                f"{shape[0]} of them for each measured quantity, got {shown(entry)}. What is not "
                "known at a time is NaN in `measured`."
            )
        noise[:, k] = column
    return noise
