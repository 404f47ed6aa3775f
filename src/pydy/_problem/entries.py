"""Warn once of numbers in dictionaries that contradict the assumptions of their symbols."""

from __future__ import annotations

from collections.abc import Iterable
from typing import Any

import numpy as np

from pydy._assembly import Assumptions, Definition
from pydy._checks import SymbolIndex
from pydy.codegen import SpecifiedsPlan


def warn_of_entries(
    assumed: Assumptions,
    symbols: SymbolIndex,
    argument: str,
    rows: np.ndarray,
    keys: Iterable[Any],
    contradicted: set[str],
) -> None:
    """Warn of numbers (m, k) under those of a user's keys that contradict an assumption."""
    if (new := [c for c in assumed.contradictions(rows) if c.name not in contradicted]) and (
        columns := {symbols.get(key, argument) for key in keys}
    ):
        new = [c for c in new if c.column in columns]
        contradicted.update(c.name for c in new)
        for first in new[:1]:
            first.warn(f"`{argument}` for ", "", new[1:])


def check_specifieds(
    definition: Definition,
    plan: SpecifiedsPlan,
    contradicted: set[str] | None,
    argument: str = "specifieds",
) -> None:
    """Warn of numbers and samples for specifieds.

    Samples are interpolated monotonically: nothing between them is beyond them.
    """
    assumed = definition.assumptions.get("specifieds")
    if assumed is None or contradicted is None:
        return
    symbols, source = definition.places["specifieds"], f"`{argument}` for "
    numbers = plan.given - {plan.symbols[k] for k in plan.changing}
    warn_of_entries(assumed, symbols, argument, plan.inputs.values[None], numbers, contradicted)
    for columns, samples in plan.inputs.sampled:
        rows = np.full((len(samples.times), len(plan.symbols)), np.nan)
        rows[:, columns] = samples.values.reshape(len(rows), -1)
        times = samples.times

        def where(row: int, times: np.ndarray = times) -> str:
            return f" at t = {times[row]:g}"

        assumed.tell(rows, contradicted, source, where=where)
