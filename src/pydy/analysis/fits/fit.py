"""A fit from trials to its result; `System.fit` documents the arguments."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence
from typing import TYPE_CHECKING, Any

import numpy as np

from pydy._checks import choice, flag, integer, listed, shown
from pydy._optional import progress_of
from pydy.analysis.fits.problem import FitProblem, FittedSystem
from pydy.analysis.fits.result import FitResult, result_of
from pydy.analysis.fits.shooting import ShootingFit
from pydy.analysis.fits.trial import Trial

if TYPE_CHECKING:
    from numpy.typing import ArrayLike

    from pydy._sympy_types import SymbolOrName


def fit(
    model: FittedSystem,
    parameters: SymbolOrName | Iterable[SymbolOrName],
    trials: object,
    *,
    bounds: Mapping[SymbolOrName, Sequence[float | None]] | None,
    priors: Mapping[SymbolOrName, Sequence[float]] | None,
    segments: int,
    method: str,
    mesh: int | ArrayLike | None,
    process_noise: Mapping[SymbolOrName, float] | None,
    solver: str | None,
    most: int,
    progress: bool,
    options: dict[str, Any],
) -> FitResult:
    """Return the parameters with which a model's motions are nearest to the trials."""
    trials = _listed(parameters, trials)
    segments, most = integer(segments, "`segments`"), integer(most, "`most`")
    collocation = choice(method, ("shooting", "collocation"), "`method`") == "collocation"
    only = {"mesh": mesh, "process_noise": process_noise, "solver": solver}
    _check_method(collocation, segments, only, options, model.problem.hybrid)
    if isinstance(options.get("events"), Iterator):
        options = {**options, "events": [*options["events"]]}
    problem = FitProblem(model, parameters, trials, options.get("events"))
    if collocation:
        from pydy.analysis.fits.collocation import collocated

        z = problem.read_known(problem.start, bounds, priors)
        progress = flag(progress, "`progress`")
        options = {"max_iter": min(most, 2**31 - 1), **options}
        solver_and_options = "ipopt" if solver is None else solver, options
        with progress_of(progress, " iterations") as report:
            report(0, part="first motions")
            minimum = collocated(problem, z, mesh, process_noise, solver_and_options, report)
        return result_of(problem, minimum)
    with progress_of(flag(progress, "`progress`"), " evaluations") as report:
        report(0, part="first motions")
        shooting = ShootingFit(problem, segments, options, report)
        z = problem.read_known(shooting.guess(), bounds, priors)
        minimum = shooting.minimum(z, most)
    return result_of(problem, minimum)


def _listed(parameters: Any, trials: object) -> list[object]:
    """Return the trials as a list; raise an error if they were passed as `parameters`."""
    several = isinstance(parameters, (list, tuple)) and len(parameters) > 0
    first = parameters[0] if several else parameters
    if isinstance(first, Trial):
        raise TypeError(
            f"`parameters` must be symbols or names, such as 'k', got {shown(parameters)}. Trials "
            "are the second argument: system.fit(['k'], trials)."
        )
    # These would be iterated over by entries or names; the check of each trial reports them.
    alone = isinstance(trials, (Trial, np.ndarray, Mapping, str)) or hasattr(trials, "times")
    entries: list[object] = [trials] if alone else listed("trials", trials, "pydy.analysis.Trial")
    if not entries:
        raise ValueError("`trials` must hold at least one pydy.analysis.Trial.")
    return entries


def _check_method(
    collocation: bool,
    segments: int,
    only: Mapping[str, object],
    options: Mapping[str, object],
    contacts: object,
) -> None:
    """Raise an error for arguments of the other method; `only` has those of collocation."""
    if collocation and segments > 1:
        raise ValueError(
            "`segments` belongs to method='shooting'. With collocation, `mesh` is the number of "
            "intervals."
        )
    if collocation and "events" in options:
        raise ValueError(
            "`events` need method='shooting': collocation takes the equations of motion alone."
        )
    if not collocation:
        for name, value in only.items():
            if value is not None:
                raise ValueError(f"`{name}` needs method='collocation'.")
    if contacts is not None and (collocation or segments > 1):
        raise ValueError(
            "`contacts` need method='shooting' with segments=1: collocation takes the "
            "equations of motion alone, and segments would begin in any modes."
        )
