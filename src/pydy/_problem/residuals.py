"""States some of which residuals give: those of an `Implicit`."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass, replace
from typing import Any, TypeVar

import numpy as np
import scipy

from pydy._assembly import Assembly
from pydy._checks import describe
from pydy._graph import jacobian, rounding_bounds
from pydy._problem.state_samples import StateSamples
from pydy._rank import within_rounding

_Samples = TypeVar("_Samples", bound=StateSamples)


@dataclass(frozen=True)
class _Residuals:
    """The equations of an `Implicit`: rows of the holonomic constraints, and their unknowns."""

    rows: tuple[int, ...]
    unknowns: tuple[int, ...]  # columns of x

    def __call__(self, assembly: Assembly) -> dict[str, list[int]]:
        graph = assembly.graph
        rows = [assembly.blocks.holonomic[k] for k in self.rows]
        unknowns = [graph.input("x", k) for k in self.unknowns]
        return {
            "residuals": rows,
            "slopes": jacobian(graph, rows, unknowns).flat(),
            "bounds": rounding_bounds(graph, rows),
        }


def with_unknowns(samples: _Samples, argument: Any, rows: Callable[..., np.ndarray]) -> _Samples:
    """Return samples with the unknowns of an Implicit solved for.

    Nothing is changed where the user's `argument` is an array: a whole state.
    """
    if samples.definition.equations.constraints.residuals.implicit is None:
        return samples
    if not (argument is None or isinstance(argument, Mapping)):
        return samples
    x = np.array([solved_residuals(samples.subset([k])) for k in range(len(samples.x))])
    return replace(samples, x=x, r=rows(x, samples.t))


def solved_residuals(sample: StateSamples) -> np.ndarray:
    """Solve an `Implicit` from a state and return the state with its unknowns."""
    x: np.ndarray = sample.x[0].copy()
    for rows, unknowns in sample.definition.equations.constraints.residuals.blocks:
        x[[*unknowns]] = _solved_block(replace(sample, x=x[None]), _Residuals(rows, unknowns))
    return x


def _solved_block(sample: StateSamples, residuals: _Residuals) -> np.ndarray:
    x: np.ndarray = sample.x[0].copy()
    columns, n = [*residuals.unknowns], len(residuals.unknowns)

    def values(z: np.ndarray) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
        x[columns] = z
        blocks = replace(sample, x=x[None]).interpret(residuals)
        return blocks["residuals"][0], blocks["slopes"][0].reshape(n, n), blocks["bounds"][0]

    z: np.ndarray = x[columns]
    violation, slopes, bounds = values(z)
    if not within_rounding(violation, bounds):
        z = scipy.optimize.root(lambda z: values(z)[0], z, jac=lambda z: values(z)[1]).x
        for _ in range(5):  # two suffice
            violation, slopes, bounds = values(z)
            if within_rounding(violation, bounds) or not np.isfinite(slopes).all():
                break
            z = z - np.linalg.lstsq(slopes, violation)[0]
    if not within_rounding(violation, bounds):
        k = int(np.argmax(np.where(np.isfinite(violation), np.abs(violation), np.inf)))
        equations = sample.definition.equations
        residual = equations.constraints.holonomic[residuals.rows[k]]
        symbols = [equations.coordinates[k] for k in columns]
        raise ValueError(
            f"`implicit` finds no {describe(symbols)} at t = "
            f"{float(sample.t[0])!r} with which the residuals are zero: `{residual}` "
            f"is left at {violation[k]:.3g}. Give a `start`, or initial conditions, nearer to a "
            "solution, or check that there is one."
        )
    return z
