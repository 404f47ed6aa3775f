"""Samples that left their constraints, or changed their energy without a cause, are lost alone."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np

from pydy._graph.interpret import run as interpret
from pydy._graph.program import Program
from pydy._kernel import Inputs
from pydy.ensemble.model import Model, Programs, Results, evaluate
from pydy.solvers.kept import Ran, beyond_digits, is_near, judge, looked_at
from pydy.solvers.outcome import FINISHED, TERMINATED
from pydy.solvers.tuning import NEAR_SINGULAR

_NUMBERS = 1_000_000  # of residuals and derivatives at a time


def refuse(
    model: Model,
    results: Results,
    r: np.ndarray,
    p: np.ndarray,
    times: np.ndarray,
    stopped: Callable[[], bool],
) -> None:
    """Let samples be NaN from where they were last seen to be sound; the others stay as they are.

    The model has constraints; `stopped` tells whether to give up.
    """
    kept = model.kept
    assert kept is not None
    projected = model.options.constraints is not None
    ended = np.isin(results.status, (FINISHED, TERMINATED))
    if projected:
        assert results.nearness is not None
        ended &= kept.redundant | (results.nearness < NEAR_SINGULAR)
    for k in _suspects(model, np.flatnonzero(ended), results.states, r, p, times, stopped):
        few = looked_at(results.states[:, k].T, projected)
        events = results.resets[k] if results.resets else []
        ran = Ran(
            times[few],
            np.ascontiguousarray(results.states[:, k, few].T),
            float(results.steps[k]) if model.options.step is None else None,
            model.options.rtol,
            model.options.atol,
            float(results.nearness[k]) if projected and results.nearness is not None else None,
            projected or kept.mended,
            events,
            kept.redundant,
        )
        inputs = Inputs(r[k], model.sampled, model.functions)
        verdict = judge(ran, _Parts(kept.programs, inputs, p[k]))
        if verdict is not None:
            _lose(results, k, times, int(few[max(0, verdict.place - 1)]) + 1, verdict.code)


class _Parts:
    """Gives `kept.Part` along one sample."""

    def __init__(self, programs: Programs, inputs: Inputs, p: np.ndarray) -> None:
        self._programs, self._inputs, self._p = programs, inputs, p

    def __call__(self, name: str, t: np.ndarray, x: np.ndarray) -> dict[str, np.ndarray]:
        program = self._programs[name]
        if program is None:
            return {}
        r = np.array([self._inputs(state, float(time)) for state, time in zip(x, t, strict=True)])

        return program.by_block(interpret(program, t, x, r, self._p)[0])


def _suspects(
    model: Model,
    ended: np.ndarray,
    states: np.ndarray,
    r: np.ndarray,
    p: np.ndarray,
    times: np.ndarray,
    stopped: Callable[[], bool],
) -> np.ndarray:
    """Return the samples that need a closer look, of some: many are looked at together."""
    projected = model.options.constraints is not None
    whole = ended[np.isfinite(states[:, ended, -1]).all(axis=0)]
    if not len(whole) or projected:
        return ended
    assert model.kept is not None
    program = model.kept.programs["screen"]
    assert program is not None
    few = looked_at(states[:, whole[0]].T, projected)
    number = max(1, _NUMBERS // (len(few) * max(1, len(program.outputs))))
    found = []
    for start in range(0, len(whole), number):
        part = whole[start : start + number]
        found.append(part[_suspect(model, program, part, states, r, p, times, few, stopped)])
    return np.union1d(np.setdiff1d(ended, whole), np.concatenate(found))


def _suspect(
    model: Model,
    program: Program,
    part: np.ndarray,
    states: np.ndarray,
    r: np.ndarray,
    p: np.ndarray,
    times: np.ndarray,
    few: np.ndarray,
    stopped: Callable[[], bool],
) -> np.ndarray:
    """Tell which samples have residuals beyond six digits, or come near to losing rank."""
    x = np.ascontiguousarray(states[:, part][:, :, few])
    out = evaluate(model, program, r[part], p[part], times[few], x, stopped)
    found = program.by_block(np.moveaxis(out, 0, -1))  # (m, times, values)
    suspect = beyond_digits(found["rows"], found["sizes"])
    if model.options.step is None:
        suspect |= is_near(found["products"])
    return suspect


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
