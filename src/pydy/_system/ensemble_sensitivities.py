"""Sensitivities of ensembles: the Programs and numbers that travel with them."""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import Any

from pydy._assembly.model import CompiledModel
from pydy._checks import flag
from pydy._names import unique_names
from pydy._system.dependents import latest_dependents
from pydy._system.parameters import read_parameters
from pydy._system.samples import mean_spacing
from pydy._system.sensitivities import Sensitive
from pydy._system.snapshot import Snapshot
from pydy.codegen.arguments import SpecifiedsPlan
from pydy.ensemble.columns import EnsembleSensitivities
from pydy.solvers.solver import Solver

__all__ = ["Differentiated", "differentiated"]


@dataclass(frozen=True, eq=False)
class Differentiated:
    """What an ensemble with sensitivities integrates.

    Attributes
    ----------
    model : EnsembleSensitivities
    options : dict
        For the solver.
    """

    model: EnsembleSensitivities
    options: dict[str, Any]


def differentiated(
    now: Snapshot,
    integrated: CompiledModel,
    plan: SpecifiedsPlan,
    solver: Solver,
    options: dict[str, Any],
    wanted: tuple[Any, Any, Any],
) -> Differentiated | None:
    """Return the sensitivities of an ensemble, or None where none are asked for.

    Parameters
    ----------
    now : Snapshot
    integrated : CompiledModel
        Of the states alone.
    plan : SpecifiedsPlan
        Of the ensemble.
    solver : Solver
    options : dict
        For the solver, events and constraints compiled.
    wanted : (parameters, control, dependent)
        As for `simulation.simulate`.
    """
    chosen, control, dependent = wanted
    control = flag(control, "`control_sensitivities`")
    if chosen is None:
        return None
    definition = now.definition
    following = latest_dependents(definition, dependent)
    parameters = read_parameters(definition, plan, chosen, dependent=following)
    sensitive = Sensitive(definition, integrated, plan, parameters, now.p, apart=True)
    places = tuple(definition.states.index(symbol) for symbol in following)
    spacing = mean_spacing(parameters)
    if spacing is not None and solver.adaptive:
        options = {"max_step": spacing, **options}
    assembly, tied = integrated.assembly, sensitive.tied
    events = options.get("events")
    residuals = None
    if tied:
        residuals = sensitive.program("holonomic", "velocity")
    controlled = control or spacing is not None
    names = unique_names([parameter.symbol for parameter in parameters])
    columns = [
        name if parameter.count == 1 else f"{name}[{j}]"
        for name, parameter in zip(names, parameters, strict=True)
        for j in range(parameter.count)
    ]
    model = EnsembleSensitivities(
        names=tuple(columns),
        rates=sensitive.split_program(),
        outputs=sensitive.program("outputs") if definition.outputs_symbols else None,
        start=sensitive.independent(places),
        dependent=places,
        gradients=tuple(assembly.jacobian_program(block, "x") for block in tied),
        residuals=residuals,
        unsolved=sensitive.unsolved(places),
        sampled=tuple(sensitive.weights()),
        sized=tuple(p.sized for p in parameters) if controlled else None,
        jumps=() if events is None else tuple(map(sensitive.jump_program, events.sources)),
    )
    if events is not None:  # workers need no SymPy
        options = {**options, "events": replace(events, sources=())}
    return Differentiated(model, options)
