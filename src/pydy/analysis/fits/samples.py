"""The samples of a Trial, checked and in order."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from pydy._checks import (
    check_mapping,
    describe,
    one_or_more,
    refuse_twice,
    shown,
    text,
)
from pydy._mechanics import find_symbols, function_of_time
from pydy._names import some, unique_names
from pydy._problem import Problem, sort_out
from pydy.analysis.fits.trial import Trial, checked_noise, checked_samples, instants
from pydy.analysis.tuning import LARGEST_RESIDUAL

if TYPE_CHECKING:
    from pydy._sympy_types import AnySymbol, Expression, ExpressionOrName


@dataclass(frozen=True, eq=False)
class TrialSamples:
    """The samples of a Trial."""

    trial: Trial
    label: str
    times: np.ndarray  # (m,)
    start: float
    keys: list[AnySymbol]  # the key of each measured quantity in a trajectory
    names: list[str]  # the user's name of each measured quantity
    values: np.ndarray  # (m, q)
    noise: np.ndarray  # (m, q)
    unknown: list[AnySymbol]  # states with unknown initial conditions


def checked_trial(
    k: int, trial: object, problem: Problem, outputs: dict[AnySymbol, Expression]
) -> TrialSamples:
    """Check a trial, the k-th; expressions that it measures get names in `outputs`."""
    states, variables = problem.definition.places["states"], problem.definition.variables
    label = f"trial {k}"
    if not isinstance(trial, Trial):
        raise TypeError(
            "`trials` must be pydy.analysis.Trial, or a list of them: Trial(times, "
            "{'q1': samples}) says when samples were taken, and of which state, output or "
            "expression. Got "
            f"{shown(trial)} at {k}."
        )
    label = text(trial.name, f"`name` of {label}") or label
    times, begin = instants(trial, label)
    values = checked_samples(trial, label, times)
    measured = check_mapping(f"measured of {label}", trial.measured)
    keys = [_key(key, label, problem, outputs) for key in measured]
    refuse_twice(keys, f"measured of {label}")
    unknown = states.chosen(one_or_more("unknown", trial.unknown), f"unknown of {label}")
    names = list(unique_names(list(measured)))
    noise_entries = trial.noise
    if isinstance(noise_entries, Mapping):
        meaning = variables.meaning
        key_of = {**dict(zip(names, keys, strict=True)), **dict(zip(measured, keys, strict=True))}
        noise_keys = [key_of.get(key, meaning(key, "noise")) for key in noise_entries]
        refuse_twice(noise_keys, f"noise of {label}")
        noise_entries = dict(zip(noise_keys, noise_entries.values(), strict=True))
    noise = _noise(noise_entries, keys, names, values.shape, label)
    sizes = np.fmax.reduce(np.abs(values) / noise)
    if (far := np.flatnonzero(sizes > LARGEST_RESIDUAL)).size:
        raise ValueError(
            f"`measured[{names[far[0]]}]` of {label} must be at most {LARGEST_RESIDUAL:.1e} in "
            f"units of `noise`, got {sizes[far[0]]:.3g}: powers of such residuals are beyond "
            "floats. Choose units in which they are smaller."
        )
    return TrialSamples(trial, label, times, begin, keys, names, values, noise, unknown)


def _key(
    key: ExpressionOrName, label: str, problem: Problem, outputs: dict[AnySymbol, Expression]
) -> AnySymbol:
    definition = problem.definition
    measurable = definition.variables
    index = measurable.get(key, "measured")
    if index is not None:
        return measurable.symbols[index]
    inside = find_symbols([key]) if hasattr(key, "free_symbols") else ()
    if isinstance(key, str) or not inside:
        measurable.find(key, f"measured of {label}")  # raises, with names that are alike
    symbols = (*measurable.symbols, *definition.constants, *definition.specifieds)
    unresolved = [s for part in sort_out(definition.equations, [key], symbols) for s in part]
    if unresolved:
        raise ValueError(
            f"`measured[{key}]` of {label} holds `{unresolved[0]}`, but no argument provides it: "
            "it is not one of the states, constants, specifieds and outputs of the system. Make "
            "the expression one of the `outputs`, and give the value there."
        )
    for name, expression in outputs.items():
        if expression == key:
            return name
    name = function_of_time(f"measured_{len(outputs)}")
    outputs[name] = key
    return name


def _noise(
    noise_entries: object,
    keys: list[AnySymbol],
    names: list[str],
    shape: tuple[int, ...],
    label: str,
) -> np.ndarray:
    noise = np.ones(shape)
    if noise_entries is None:
        return noise
    entries = [noise_entries] * len(keys)
    if isinstance(noise_entries, Mapping):
        if noise_entries.keys() != {*keys}:
            raise ValueError(
                f"`noise` of {label} must have an entry for each measured quantity, "
                f"{some(names)}, got {describe([*noise_entries])}."
            )
        entries = [noise_entries[key] for key in keys]
    for k, entry in enumerate(entries):
        noise[:, k] = checked_noise(entry, shape[0], label)
    return noise
