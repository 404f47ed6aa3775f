"""Integrate a Problem with many different numbers; see `System.integrate_ensemble`."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import replace
from typing import TYPE_CHECKING, Any

import numpy as np

from pydy._assembly import CompiledModel, Definition, lower_nodes
from pydy._checks import flag, integer, shown
from pydy._dataset import SENSITIVITY
from pydy._integration import (
    AugmentedSystem,
    InitialSensitivities,
    are_controlled,
    changed_by,
    parameter_sizes,
    program_of_event,
    sample_weights,
    with_all_constraints,
    with_step_limit,
    written_out,
)
from pydy._judges import (
    check_sample_orientations,
    check_samples,
    drift_programs,
    watched,
)
from pydy._motion import ConstraintNames, PreparedIntegration, with_residuals_projected
from pydy._names import column_names
from pydy._problem import (
    AssumptionChecks,
    Problem,
    StateSamples,
    check_times,
    read_times,
)
from pydy._version import __version__
from pydy.codegen import SpecifiedsPlan
from pydy.ensemble.engine import Ensemble
from pydy.ensemble.model import ConstraintChecks, EnsembleModel, EnsembleSensitivities
from pydy.ensemble.names import ResultNames
from pydy.ensemble.samples import PARAMETER, QUANTITY
from pydy.ensemble.variations import read_samples, split_specifieds
from pydy.ensemble.work import Work, read_reductions
from pydy.solvers import SOLVERS, Options, Solver, read_options

if TYPE_CHECKING:
    from os import PathLike

    from numpy.typing import ArrayLike
    from xarray import Dataset

    from pydy._sympy_types import SymbolOrName

_ABOUT_MODES = frozenset(("events", "constraints", "gain"))


def integrate_ensemble(
    problem: Problem,
    *,
    initial_conditions: Mapping[SymbolOrName, ArrayLike] | None = None,
    constants: Mapping[SymbolOrName, ArrayLike] | None = None,
    specifieds: Mapping[SymbolOrName | tuple[SymbolOrName, ...], object] | None = None,
    times: ArrayLike | None = None,
    solver: object,
    product: bool = False,
    sensitivities: SymbolOrName | Iterable[SymbolOrName] | None = None,
    control_sensitivities: bool = False,
    reduce: object = None,
    chunks: int | str | Mapping[str, int] | None = None,
    store: str | PathLike[str] | None = None,
    resume: bool | str = False,
    workers: int | None = None,
    progress: bool = False,
    units: Mapping[SymbolOrName, str | tuple[str, float]] | None = None,
    options: dict[str, object],
) -> Dataset:
    """Integrate a Problem with many different numbers; see `System.integrate_ensemble`.

    Values that are not varied are those of the Problem. Its constants already include the symbols
    of `events`.
    """
    product, progress = flag(product, "`product`"), flag(progress, "`progress`")
    control = flag(control_sensitivities, "`control_sensitivities`")
    if not (isinstance(resume, str) and resume):
        resume = flag(resume, "`resume`, unless it is a name for functions,")
    varied, common = split_specifieds(specifieds)
    plan = _plan_of(problem, varied, common)
    times = _checked_times(problem, plan, times)
    solver = _native(solver)
    workers = None if workers is None else integer(workers, "`workers`")
    definition, motions = problem.definition, None
    if problem.hybrid is not None:
        columns = definition.places["specifieds"].columns(varied, "specifieds").tolist()
        sensitivity_options = {"sensitivities": sensitivities, "control_sensitivities": control}
        motions = problem.hybrid.motions(
            problem, solver, common, columns, {**options, **sensitivity_options}
        )
        reserved = (SENSITIVITY, QUANTITY, PARAMETER) if motions.columns else ()
        names = ResultNames(definition, reserved, motions.outputs)
    else:
        names = ResultNames.latest(problem, sensitivities is not None)
    samples = read_samples(problem, plan, names, product, initial_conditions, constants, varied)
    if definition.equations.constraints.residuals.implicit is not None:
        options = with_residuals_projected(definition, solver, options)
    constraints, code = None, problem.model.code
    if definition.equations.constraints.are_present or sensitivities is not None:
        code = problem.model.with_compiled_inputs(plan)

    def at(t: np.ndarray, x: np.ndarray) -> StateSamples:
        return StateSamples(definition, code, t, x, plan.inputs.rows(x, t), problem.p)

    violated = False
    if definition.equations.constraints.are_present:
        corrected = options.get("constraints") is not None
        violated = check_samples(
            at, float(times[0]), (samples.x, samples.r, samples.p), samples.shape, corrected
        )
        if motions is None:
            constraints = _constraint_checks(problem, code, plan, options)
    if motions is not None:  # it handles events and constraints itself
        options = {k: v for k, v in options.items() if k not in _ABOUT_MODES}
    ready: PreparedIntegration | None = problem.model.code.latest.get("ensemble")
    if ready is None or not ready.is_compatible(plan, solver, options):
        ready = PreparedIntegration(problem.model, plan, solver, options)
    compiled, derivatives = ready.options, None
    if sensitivities is not None and motions is None:
        augmented = AugmentedSystem.for_parameters(problem, ready.code, plan, sensitivities)
        controlled = are_controlled(augmented.parameters, control)
        compiled = with_step_limit(augmented, solver, compiled, problem.x, times, controlled)
        initial = InitialSensitivities(augmented, problem.dependent)
        derivatives = ensemble_sensitivities(
            at(times[:1], problem.x[None]), initial, compiled, controlled
        )
    if not violated and definition.equations.unit_quaternions:
        check_sample_orientations(at, float(times[0]), samples.x, samples.shape)
    read = ready.read
    if read is None or derivatives is not None:
        read = _read(definition, solver, compiled)
    if derivatives is None:
        ready.read, problem.model.code.latest["ensemble"] = read, ready
    source = motions or derivatives
    model = EnsembleModel(
        rates=ready.code.programs.of("rates"),
        outputs=ready.code.programs.of("outputs") if definition.outputs.symbols else None,
        states=names.states,
        output_names=names.outputs,
        method=solver.name,
        options=read,
        times=times,
        sampled=plan.inputs.sampled,
        functions=plan.inputs.functions,
        jacobian=ready.code.programs.jacobian_in_parts("rates", "x")
        if solver.name == "radau"
        else None,
        sensitivities=derivatives,
        constraint_checks=constraints,
        motions=motions,
        columns=source.columns if source else (),
    )
    work = Work(
        model,
        read_reductions(reduce, model, names.name),
        names.attributes if units is None else names.described(units),
        assumed=definition.assumptions.get("states"),
        contradicted=problem.settings.contradicted,
    )
    ensemble = Ensemble(work, samples, chunks, _attributes(model), workers, progress)
    if store is not None:
        return ensemble.into(store, resume)
    if resume:
        raise ValueError("`resume=True` needs `store`, the Zarr store to resume.")
    return ensemble.run() if chunks is None else ensemble.lazy()


def _plan_of(
    problem: Problem,
    varied: Iterable[SymbolOrName],
    common: Mapping[SymbolOrName | tuple[SymbolOrName, ...], object],
) -> SpecifiedsPlan:
    """Return the plan of r with the specifieds that all samples share; varied ones are zero."""
    plan = problem.plan
    for values in filter(None, (common, dict.fromkeys(varied, 0.0))):
        specifieds = problem.definition.places["specifieds"]
        update = SpecifiedsPlan(values, specifieds, argument="specifieds")
        if values is common:
            AssumptionChecks(problem).inputs(update)
        plan = plan.updated(update)
    return plan


def _checked_times(problem: Problem, plan: SpecifiedsPlan, times: ArrayLike | None) -> np.ndarray:
    """Return the times, by default those of the Problem."""
    requested = problem.settings.times if times is None else check_times(times)
    checked = read_times(problem, requested, "ensembles integrate forward only")
    if len(checked) < 2:
        raise ValueError(
            f"`times` must have at least two values, got {len(checked)}. Pass `times` or set "
            "`system.times`."
        )
    plan.check_times(checked, "times")
    return checked


def _native(solver: object) -> Solver:
    """Return a native solver, from itself or its name."""
    native = SOLVERS.get(solver) if isinstance(solver, str) else solver
    if not isinstance(native, Solver) or native.name not in SOLVERS:
        raise ValueError(
            f"`ode_solver` must be a native solver, one of {', '.join(map(repr, SOLVERS))}, got "
            f"{shown(solver)}. For another one, integrate in a loop."
        )
    return native


def _constraint_checks(
    problem: Problem, code: CompiledModel, plan: SpecifiedsPlan, options: Mapping[str, object]
) -> ConstraintChecks:
    """Return the checks of the constraints and of the energy."""
    equations = problem.definition.equations
    return ConstraintChecks(
        drift_programs(problem, code, plan),
        any(equations.constraints.redundant),
        equations.constraints.has_unprojected_rows,
        options.get("constraints") is not None,
        ConstraintNames(equations) if "events" in options else (),
    )


def _read(definition: Definition, solver: Solver, options: Mapping[str, Any]) -> Options:
    """Return the checked options of a solver; events and constraints are compiled already."""
    numbers = {k: v for k, v in options.items() if k not in ("events", "constraints")}
    read = vars(read_options(solver.name, solver.adaptive, numbers))
    compiled = {k: v for k, v in options.items() if k not in numbers}
    if "events" in compiled:  # without SymPy expressions, for the workers
        compiled["events"] = replace(compiled["events"], sources=())
    result = Options(**{**read, **compiled, "full_output": True})
    n, least = len(definition.states), 10.0 * np.finfo(float).eps
    for name in ("rtol", "atol"):
        if np.shape(getattr(result, name)) not in ((), (n,)):
            raise ValueError(
                f"`{name}` must be a number or have the shape ({n},), got "
                f"{np.shape(getattr(result, name))}."
            )
    if result.step is None and (np.maximum(result.rtol, result.atol) < least).any():
        raise ValueError(
            f"`rtol` or `atol` must be at least {least:.1e}, ten times the rounding unit, got "
            f"rtol = {result.rtol} and atol = {result.atol}."
        )
    return result


def _attributes(model: EnsembleModel) -> dict[str, object]:
    """Return the attributes of the Dataset, which document the solver."""
    from pydy.solvers import LaneSolver

    return {
        "ode_solver": model.method,
        "lanes": LaneSolver.LANES if model.in_lanes else 1,
        "rtol": np.asarray(model.options.rtol).tolist(),
        "atol": np.asarray(model.options.atol).tolist(),
        "pydy_version": __version__,
    }


def ensemble_sensitivities(
    at: StateSamples, initial: InitialSensitivities, options: Mapping[str, Any], controlled: bool
) -> EnsembleSensitivities:
    """Return the sensitivities of an ensemble as Programs and numbers."""
    augmented = initial.augmented
    watch = watched(at, augmented)
    if watch is not None:
        assembly = at.model.assembly.fork()
        watch = replace(watch, nodes=lower_nodes(assembly, watch.nodes(assembly), as_is=True))
    model, definition = augmented.model, augmented.definition
    blocks, inputs = initial.blocks, augmented.columns.wanted
    events = options.get("events")
    return EnsembleSensitivities(
        columns=column_names({p.symbol: p.count for p in augmented.parameters}),
        rates=augmented.tangent(),
        outputs=written_out(augmented, "outputs") if definition.outputs.symbols else None,
        start=initial.independent(),
        dependent=initial.dependent,
        gradients=tuple(model.programs.jacobian(block, "x") for block in blocks),
        unknowns=tuple(initial.unknowns),
        residuals=augmented.tangent("holonomic", "velocity") if blocks else None,
        projected_residuals=with_all_constraints(augmented).tangent("holonomic", "velocity")
        if blocks
        else None,
        unsolved=initial.refusal,
        sampled=tuple(sample_weights(augmented.parameters, definition)),
        sized=parameter_sizes(augmented, options),
        controlled=controlled,
        sources=augmented.columns.sources,
        jumps=tuple(
            (program_of_event(model, event, inputs), changed_by(event, definition.states))
            for event in (() if events is None else events.sources)
        ),
        watched=watch,
    )
