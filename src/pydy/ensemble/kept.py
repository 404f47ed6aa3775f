"""Samples that left their constraints, or changed their energy without a cause, are lost alone."""

from __future__ import annotations

from typing import Any

import numpy as np

from pydy._graph.interpret import run as interpret
from pydy._kernel import Inputs
from pydy.ensemble.model import Batch, Programs, Results
from pydy.solvers.kept import Part, Ran, beyond_digits, is_near, judge, looked_at
from pydy.solvers.outcome import FINISHED, TERMINATED
from pydy.solvers.tuning import NEAR_SINGULAR

_NUMBERS = 1_000_000  # of residuals and derivatives at a time


def refuse(batch: Batch, results: Results, times: np.ndarray) -> None:
    """Let samples be NaN from where they were last seen to be sound; the others stay as they are.

    The model has constraints.
    """
    model, kept = batch.model, batch.model.kept
    assert kept is not None
    projected = model.options.constraints is not None
    ended = np.isin(results.status, (FINISHED, TERMINATED))
    if projected:
        assert results.nearness is not None
        ended &= kept.redundant | (results.nearness < NEAR_SINGULAR)
    suspects = np.flatnonzero(ended)
    if not projected:
        suspects = _suspects(batch, kept.programs, suspects, results.states, times)
    for k in suspects.tolist():
        few = looked_at(results.states[:, k].T, projected)
        ran = Ran(
            times[few],
            np.ascontiguousarray(results.states[:, k, few].T),
            float(results.steps[k]) if model.options.step is None else None,
            model.options.rtol,
            model.options.atol,
            float(results.nearness[k]) if projected and results.nearness is not None else None,
            projected or kept.mended,
            results.resets[k] if results.resets else [],
            kept.redundant,
        )
        verdict = judge(ran, _part_of(batch, kept.programs, k))
        if verdict is not None:
            _lose(results, k, times, int(few[max(0, verdict.place - 1)]) + 1, verdict.code)


def _part_of(batch: Batch, programs: Programs, k: int) -> Part:
    """Return what gives `kept.Part` along sample k."""
    inputs = Inputs(batch.r[k], batch.model.sampled, batch.model.functions)

    def part(name: str, t: np.ndarray, x: np.ndarray) -> dict[str, np.ndarray]:
        program = programs[name]
        if program is None:
            return {}
        r = np.array([inputs(state, float(time)) for state, time in zip(x, t, strict=True)])
        return program.by_block(interpret(program, t, x, r, batch.p[k])[0])

    return part


def _suspects(
    batch: Batch, programs: Programs, ended: np.ndarray, states: np.ndarray, times: np.ndarray
) -> np.ndarray:
    """Return the samples that need a closer look, of some: many are looked at together.

    Those have residuals beyond six digits, or come near to losing rank.
    """
    whole = ended[np.isfinite(states[:, ended, -1]).all(axis=0)]
    if not len(whole):
        return ended
    program = programs["screen"]
    assert program is not None
    few = looked_at(states[:, whole[0]].T, projected=False)
    number = max(1, _NUMBERS // (len(few) * max(1, len(program.outputs))))
    suspects = [np.setdiff1d(ended, whole)]
    for start in range(0, len(whole), number):
        places = whole[start : start + number]
        x = np.ascontiguousarray(states[:, places][:, :, few])
        out = batch.some(places).evaluate(program, times[few], x)
        found = program.by_block(np.moveaxis(out, 0, -1))  # (m, times, values)
        suspect = beyond_digits(found["rows"], found["sizes"])
        if batch.model.options.step is None:
            suspect |= is_near(found["products"])
        suspects.append(places[suspect])
    return np.unique(np.concatenate(suspects))


def _lose(results: Results, k: int, times: np.ndarray, reached: int, code: int) -> None:
    """Let a sample end before a time."""
    results.states[:, k, reached:] = np.nan
    if results.columns is not None:
        results.columns[:, :, k, reached:] = np.nan
    results.status[k], results.end_time[k] = code, times[reached - 1]
    if results.events:
        kept = [j for j, (_, t) in enumerate(results.events[k]) if t <= results.end_time[k]]
        for table in (results.events, results.moments):
            rows: list[Any] = table[k]
            table[k] = [rows[j] for j in kept if j < len(rows)]
