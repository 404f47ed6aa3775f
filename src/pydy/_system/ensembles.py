"""Turn what a user varies into the samples and the model of an ensemble."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import replace
from typing import TYPE_CHECKING, Any

import numpy as np

from pydy._assembly.definition import Definition
from pydy._checks import (
    Places,
    check_mapping,
    flag,
    merged,
    number,
    real_array,
    refuse_twice,
    shown,
    text,
    whole,
)
from pydy._dataset import SENSITIVITY
from pydy._names import column_names, latex_of, name_of, some, unique_names
from pydy._simulation.constraint_drift import check_samples, drift_programs
from pydy._simulation.definition import check_times, refuse_descending
from pydy._simulation.discontinuities import watched
from pydy._simulation.events_and_constraints import (
    ConstraintNames,
    native_solver,
    with_residuals_held,
)
from pydy._simulation.preparation import PreparedIntegration
from pydy._simulation.problem import At, Problem, check_specifieds
from pydy._simulation.sensitivities import AugmentedSystem, changed_by, program_of_event
from pydy._system.setup import Setup
from pydy._version import __version__
from pydy.codegen.arguments import SpecifiedsPlan, symbolic_entries
from pydy.ensemble.engine import Ensemble
from pydy.ensemble.model import EnsembleSensitivities, Kept, Model
from pydy.ensemble.samples import PARAMETER, QUANTITY, Samples, Variable
from pydy.ensemble.work import COUNTS, Work, read_reductions
from pydy.inputs import SampledInput
from pydy.solvers.options import Options, read_options
from pydy.solvers.solver import SOLVERS, Solver
from pydy.solvers.tuning import LANES

if TYPE_CHECKING:
    from typing import Unpack

    from numpy.typing import ArrayLike

    from pydy._simulation.events_and_constraints import EnsembleOptions


def differentiated(
    at: At, sensitive: AugmentedSystem, options: Mapping[str, Any], control: bool
) -> EnsembleSensitivities:
    """Return the sensitivities of an ensemble as Programs and numbers."""
    watch = watched(at, sensitive)
    if watch is not None:
        own = at.model.assembly.fork()
        watch = replace(watch, nodes=own.lowered(watch.nodes(own), as_is=True))
    model, definition = sensitive.model, sensitive.definition
    tied, wanted = sensitive.tied, sensitive.columns.wanted
    events = options.get("events")
    return EnsembleSensitivities(
        columns=column_names({p.symbol: p.count for p in sensitive.parameters}),
        rates=sensitive.tangent(),
        outputs=sensitive.written_out("outputs") if definition.outputs_symbols else None,
        start=sensitive.independent(),
        dependent=sensitive.dependent,
        gradients=tuple(model.jacobian_program(block, "x") for block in tied),
        unknowns=tuple(sensitive.unknowns),
        residuals=sensitive.tangent("holonomic", "velocity") if tied else None,
        held=sensitive.whole.tangent("holonomic", "velocity") if tied else None,
        unsolved=sensitive.unsolved(),
        sampled=tuple(sensitive.weights()),
        sized=sensitive.sized(options),
        controlled=sensitive.controlled(control),
        sources=sensitive.columns.sources,
        jumps=tuple(
            (program_of_event(model, event, wanted), changed_by(event, definition.states))
            for event in (() if events is None else events.sources)
        ),
        watched=watch,
    )


class _Names:
    """What the quantities of a definition are called in results.

    A result holds some names beside states, outputs and `COUNTS`: `more`.
    """

    def __init__(
        self, definition: Definition, more: Iterable[str], outputs: Iterable[Any] | None = None
    ) -> None:
        equations, n = definition.equations, len(definition.states)
        outputs = definition.outputs_symbols if outputs is None else outputs
        variables = (*definition.states, *outputs)
        self.known = Places(variables, "states and outputs of the system")
        names = unique_names(variables)
        self.of = dict(zip(variables, names, strict=True))
        self.states, self.outputs = names[:n], names[n:]
        self.taken = {*names}  # that variables of the result have
        for name in ("time", "occurrence", *COUNTS, *more):
            if name in self.taken:
                raise ValueError(
                    f"The result of an ensemble has a variable or dimension `{name}` of its own, "
                    "but that is the name of a state or output too. Rename that."
                )
            self.taken.add(name)
        # The names of coordinates; of a constant, also their attributes.
        self.labels = {s: f"initial_{self.of[s]}" for s in definition.states}
        self.labels |= {s: f"{v} (state)" for s, v in self.labels.items() if v in self.taken}
        others = (*definition.constants, *definition.specifieds)
        for s, name in zip(others, unique_names(others), strict=True):
            self.labels[s] = f"{name} (constant)" if name in self.taken else name
        self.constants = tuple(
            (self.labels[s], {"role": "constant", "latex": latex_of(s)})
            for s in definition.constants
        )
        roles = {**dict.fromkeys(equations.coordinates, "coordinate")}
        roles |= dict.fromkeys(equations.speeds, "speed")
        roles |= dict.fromkeys(definition.auxiliaries, "auxiliary")
        self.attributes = {
            name: {"role": roles.get(s, "output"), "latex": latex_of(s)}
            for s, name in self.of.items()
        }

    @staticmethod
    def latest(problem: Problem, sensitive: bool) -> _Names:
        """Return those of a model, made once."""
        key = "names beside sensitivities" if sensitive else "names"
        more = (SENSITIVITY, QUANTITY, PARAMETER) if sensitive else ()
        names: _Names | None = problem.model.code.latest.get(key)
        if names is None:
            names = problem.model.code.latest[key] = _Names(problem.definition, more)
        return names

    def name(self, key: Any) -> str:
        """Return the name of a state or output, of which it may be the symbol."""
        symbol = self.known.meaning(key, "reduce")
        return self.of[symbol] if symbol in self.of else name_of(key)

    def described(self, units: Mapping[Any, str]) -> dict[str, dict[str, Any]]:
        """Return the attributes of variables, with their units."""
        result = {name: dict(attributes) for name, attributes in self.attributes.items()}
        given = check_mapping("units", units)
        names = [self.name(key) for key in given]
        refuse_twice(names, "units")
        for name, (key, unit) in zip(names, given.items(), strict=True):
            if name not in result:
                raise ValueError(
                    f"`units` has the key `{key}`, which is neither a state nor an output: "
                    f"{some(result)}."
                )
            result[name]["units"] = text(unit, f"`units[{key}]`")
        return result


class _Axes:
    """Collects dimensions and coordinates; with `product`, each array has its own dimension."""

    def __init__(self, product: bool, names: _Names) -> None:
        self.product, self.names = product, names
        self.dims: dict[str, int] = {}
        self.coordinates: dict[str, Variable] = {}
        self._from: dict[str, str] = {}
        self._index: dict[str, tuple[str, np.ndarray]] = {}

    def add(self, what: str, value: Any, name: str, attrs: dict[str, Any]) -> tuple[Any, Any]:
        """Return one value, called `what` in messages, as (dims, float array)."""
        dims: tuple[str, ...]
        if hasattr(value, "dims") and hasattr(value, "coords"):
            dims = tuple(map(str, value.dims))
            array = real_array(value, what)
            for d in dims:
                if d in value.coords and value.coords[d].ndim == 1:
                    own = value.coords[d]
                    self._label(what, d, Variable((d,), np.array(own), dict(own.attrs)))
        else:
            array = real_array(value, what)
            if array.ndim > 1:
                raise ValueError(
                    f"{what} must be a number, a one-dimensional array, or an xarray.DataArray "
                    f"that names its dimensions, got the shape {array.shape}."
                )
            dims = (name if self.product else "sample",) * array.ndim
            index = getattr(value, "index", None)  # of a pandas.Series; a list has a method
            if array.ndim and index is not None and not callable(index):
                self._match(what, dims[0], np.asarray(index))
        if not np.isfinite(array).all():
            where = tuple(int(k) for k in np.argwhere(~np.isfinite(array))[0])
            raise ValueError(f"{what} must be finite, got {array[where]} at index {where}.")
        for d, size in zip(dims, array.shape, strict=True):
            self._dimension(what, d, size)
        if dims:
            self._label(what, name, Variable(dims, np.array(array), attrs))
        return dims, array

    def _dimension(self, what: str, dim: str, size: int) -> None:
        if dim in self.names.taken:
            raise ValueError(
                f"{what} has the dimension `{dim}`, which is the name of a variable of the result. "
                "Choose another name."
            )
        if size == 0:
            raise ValueError(f"{what} must not be empty along `{dim}`.")
        if self.dims.setdefault(dim, size) != size:
            raise ValueError(
                f"{what} has {size} values along `{dim}`, but {self._from[dim]} has "
                f"{self.dims[dim]}. Make them equally long, give them different dimensions as "
                "xarray.DataArray, or pass product=True for all combinations."
            )
        self._from.setdefault(dim, what)

    def _label(self, what: str, name: str, coordinate: Variable) -> None:
        known = self.coordinates.get(name)
        if known is not None and not np.array_equal(known.values, coordinate.values):
            raise ValueError(
                f"{what} has other coordinates along `{name}` than {self._from.get(name, name)}: "
                "values are matched by position, so labels must agree."
            )
        if known is None or "role" in coordinate.attrs:
            self.coordinates[name] = coordinate

    def _match(self, what: str, dim: str, index: np.ndarray) -> None:
        other, known = self._index.setdefault(dim, (what, index))
        if len(known) == len(index) and not np.array_equal(known, index):
            raise ValueError(
                f"{what} has another index than {other}: values are matched by position, so "
                "indices must agree. Align the Series, or pass their `.to_numpy()`."
            )

    def check_names(self) -> None:
        """Raise if a dimension is called like a quantity that is not given along it."""
        for symbol, name in self.names.labels.items():
            own = self.coordinates.get(name)
            along = own is not None and own.dims == (name,) and "role" in own.attrs
            if name in self.dims and not along:
                raise ValueError(
                    f"{self._from[name]} has the dimension `{name}`, but that is the name of "
                    f"`{symbol}`, which is not given along it. Choose another name: "
                    "xarray.DataArray(values, dims='run')."
                )


def _split_specifieds(
    given: Mapping[Any, Any] | None,
) -> tuple[dict[Any, Any], dict[Any, Any]]:
    """Return the specifieds that vary from sample to sample, and those of all samples."""
    varied: dict[Any, Any] = {}
    common: dict[Any, Any] = {}
    given = check_mapping("specifieds", given)
    for key, value in (merged(given) if len(given) > 1 else given).items():
        together = isinstance(key, (tuple, list)) or key in ("symbols", "values")
        plain = not together and not callable(value)
        symbolic = isinstance(value, SampledInput) or symbolic_entries(value) is not None
        several = plain and not symbolic and not hasattr(value, "dims")
        if several:
            several = real_array(value, f"`specifieds[{key}]`").ndim > 0
        (varied if several or (plain and hasattr(value, "dims")) else common)[key] = value
    return varied, common


def _columns(
    argument: str,
    given: Mapping[Any, Any],
    places: Places,
    base: np.ndarray,
    axes: _Axes,
    role: str,
) -> list[tuple[Any, Any]]:
    """Return (dims, values) for each symbol; those that are not given are as in `base`."""
    columns: list[tuple[Any, Any]] = [((), np.asarray(value)) for value in base]
    if not given:
        return columns
    found = places.columns(given, argument).tolist()
    for place, value in zip(found, given.values(), strict=True):
        symbol = places.symbols[place]
        what = f"`{argument}[{symbol}]`"
        if not hasattr(value, "dims") and real_array(value, what).ndim == 0:
            columns[place] = ((), np.asarray(number(value, what, finite=True)))
        else:
            attrs = {"role": role, "latex": latex_of(symbol)}
            columns[place] = axes.add(what, value, axes.names.labels[symbol], attrs)
    return columns


def _check_assumptions(
    problem: Problem, columns: list[tuple[Any, Any]], kind: str, given: Mapping[Any, Any], what: str
) -> None:
    """Warn once of samples, (dims, values) for each symbol, that contradict assumptions."""
    assumed, told = problem.definition.assumptions.get(kind), problem.contradicted
    if not given or assumed is None or told is None:
        return
    for place in {
        problem.definition.places[kind].find(key, what) for key in given
    } & assumed.columns:
        values = np.ravel(columns[place][1])
        rows = np.full((len(values), len(columns)), np.nan)
        rows[:, place] = values
        assumed.tell(rows, told, f"`{what}` for ", where=lambda row: " in one sample or more")


def _aligned(columns: list[tuple[Any, Any]], dims: Mapping[str, int]) -> tuple[np.ndarray, ...]:
    """Return own arrays, which are computed with later, with one axis for each dimension."""
    result = []
    for own, values in columns:
        order = [own.index(d) for d in dims if d in own]
        shape = [dims[d] if d in own else 1 for d in dims]
        result.append(np.array(np.transpose(values, order).reshape(shape)))
    return tuple(result)


def _native(ode_solver: Any) -> Solver:
    solver = SOLVERS.get(ode_solver) if isinstance(ode_solver, str) else ode_solver
    if not isinstance(solver, Solver) or solver.name not in SOLVERS:
        raise ValueError(
            f"`ode_solver` must be a native solver, one of {', '.join(map(repr, SOLVERS))}, got "
            f"{shown(ode_solver)}. For another one, integrate in a loop."
        )
    return solver


def _read(definition: Definition, solver: Solver, given: Mapping[str, Any]) -> Options:
    """Return the options of a solver, of which some are compiled."""
    own = {k: v for k, v in given.items() if k not in ("events", "constraints")}
    read = vars(read_options(solver.name, solver.adaptive, own))
    rest = {k: v for k, v in given.items() if k not in own}
    options = Options(**{**read, **rest, "full_output": True})
    n, least = len(definition.states), 10.0 * np.finfo(float).eps
    for name in ("rtol", "atol"):
        if np.shape(getattr(options, name)) not in ((), (n,)):
            raise ValueError(
                f"`{name}` must be a number or have the shape ({n},), got "
                f"{np.shape(getattr(options, name))}."
            )
    if options.step is None and (np.maximum(options.rtol, options.atol) < least).any():
        raise ValueError(
            f"`rtol` or `atol` must be at least {least:.1e}, ten times the rounding unit, got "
            f"rtol = {options.rtol} and atol = {options.atol}."
        )
    return options


_ABOUT_MODES = frozenset(("events", "constraints", "gain"))


class Ensembles(Setup):
    """Many trajectories at a time."""

    def integrate_ensemble(
        self,
        *,
        initial_conditions: Mapping[Any, Any] | None = None,
        constants: Mapping[Any, Any] | None = None,
        specifieds: Mapping[Any, Any] | None = None,
        times: ArrayLike | None = None,
        ode_solver: Any = None,
        product: bool = False,
        sensitivities: Any = None,
        control_sensitivities: Any = False,
        reduce: Any = None,
        chunks: Any = None,
        store: Any = None,
        resume: bool | str = False,
        workers: int | None = None,
        progress: bool = False,
        units: Mapping[Any, str] | None = None,
        contacts: Any = None,
        **solver_kwargs: Unpack[EnsembleOptions],
    ) -> Any:
        """Integrate many trajectories of the system, each with different values.

        Values that are not passed are those of the System. Eight trajectories at a time share the
        processor's vector registers, and blocks of trajectories are distributed over its cores. The
        results are bitwise identical for any `chunks`, `workers` and scheduler.

        Parameters
        ----------
        initial_conditions, constants, specifieds : dict, optional
            Like the attributes of the same names, but a value may also be a one-dimensional array
            with one entry for each sample, or an `xarray.DataArray` along any dimensions, which are
            matched by name. Numbers, and specifieds that are functions, expressions or
            SampledInputs, are the same for all samples.
        times : array_like, shape (m,), optional
        ode_solver : {'dop853', 'tsit5', 'vern9', 'rk4', 'radau'} or Solver, optional
            By default the System's, or ``'dop853'`` if that is not native.
        product : bool, optional
            Whether each one-dimensional array gets its own dimension, named after its symbol
            (``initial_q1`` for an initial condition of ``q1``), so that the samples are all
            combinations.
        sensitivities : symbol, name, group, or iterable of these, optional
            Parameters with respect to which every trajectory is differentiated, as in `simulate`.
            The variable ``sensitivity`` has the dimensions ``quantity`` (states and outputs) and
            ``parameter``.
        control_sensitivities : bool, optional
            As in `simulate`.
        reduce : optional
            What to return instead of the values at all times: ``'final'``; ``('max', name)`` or
            ``('min', name)`` of a state or output; ``'events'`` or ``('events', number)`` for the
            first times of each event; a list of these; or a function that takes the Dataset of some
            samples and returns a Dataset that keeps the sample dimensions.
        chunks : int, 'auto' or dict of str to int, optional
            Sizes of blocks of samples. The Dataset is then lazy: it contains Dask arrays, computed
            by the scheduler that you choose. With `store`, this only sets the sizes.
        store : path, optional
            Path of a Zarr store, to which every finished block is written immediately, with
            checksums; so has what describes its arrays.
        resume : bool or str, optional
            Whether `store` may exist; only its missing, damaged or misplaced blocks are then
            computed. All that is data must be as in the first call, which is checked. Python
            functions in `reduce` and `specifieds` are not looked at: with them, `resume` must be
            your own name for them, a string, which you pass from the first call on and change when
            the functions change.
        workers : int, optional
            Number of threads; by default one for each processor.
        progress : bool, optional
            Whether to show a progress bar; requires tqdm.
        units : dict of symbols or names to str, optional
            Values of the attribute ``units`` of the variables.
        contacts : pydy.contact.Contacts, optional
            Contacts of this System: trajectories are those of `Contacts.simulate`, one by one, with
            its outputs. Samples share the compiled modes. `reduce='events'` has the transitions.
        **solver_kwargs
            Options of the solver, and `events`, `constraints` and `gain` as in `integrate`.

        Returns
        -------
        xarray.Dataset
            One variable for each state and output along the sample dimensions and ``time``; varied
            quantities as coordinates; ``steps``, ``rejected``, ``evaluations``, ``end_time``, and
            ``status``, whose attribute ``flag_meanings`` explains its values. A sample that fails
            is NaN from then on; the others are not affected.

        Raises
        ------
        ValueError
            A value, name or shape is not valid; raised before anything is computed.
        ImportError
            A package is missing: ``pip install 'pydy[ensemble]'``.
        EnsembleInterrupted
            The user interrupted the computation; without a store, the exception contains the
            finished samples.

        Warns
        -----
        PyDyUserWarning
            Outputs are not finite, or samples do not begin on the constraints: dependent initial
            conditions are not solved for again where others vary. Or a reset leaves them; or a load
            jumps on the way, which `sensitivities` do not know.

        Notes
        -----
        Trajectories are integrated one by one, by the same solvers, if specifieds are Python
        functions, with `control_sensitivities`, sensitivities with respect to samples, `events` or
        ``constraints='project'``, with `events` and ``constraints='project'`` together, with resets
        and SampledInputs together, and with 'radau'. Samples that fail are repeated in this way.

        Examples
        --------
        >>> import numpy as np
        >>> from pydy.models import multi_mass_spring_damper
        >>> system = multi_mass_spring_damper()
        >>> x0, v0 = system.states
        >>> results = system.integrate_ensemble(
        ...     initial_conditions={x0: [1.0, 2.0, 3.0]}, times=np.linspace(0.0, 1.0, num=11)
        ... )
        >>> dict(results.sizes)
        {'sample': 3, 'time': 11}
        >>> results.x0.isel(time=-1).values.round(4)
        array([0.6597, 1.3194, 1.9791])
        >>> (results.status == 0).all().item()
        True
        """
        product, progress = flag(product, "`product`"), flag(progress, "`progress`")
        control = flag(control_sensitivities, "`control_sensitivities`")
        if not (isinstance(resume, str) and resume):
            resume = flag(resume, "`resume`, unless it is a name for functions,")
        if contacts is not None:
            self._checked_contacts(contacts)
        problem = self._now(solver_kwargs.get("events"), constants, contacts)
        definition = problem.definition
        varied, common = _split_specifieds(specifieds)
        plan = problem.plan
        for values in filter(None, (common, dict.fromkeys(varied, 0.0))):
            new = SpecifiedsPlan(values, definition.places["specifieds"], argument="specifieds")
            if values is common:
                check_specifieds(definition, new, problem.contradicted)
            plan = plan.updated(new)
        times = problem.checked_times(problem.times) if times is None else check_times(times)
        if times.size and times[-1] < times[0]:
            refuse_descending(times, "ensembles integrate forward only")
        if len(times) < 2:
            raise ValueError(
                f"`times` must have at least two values, got {len(times)}. Pass `times` or set "
                "`system.times`."
            )
        plan.check_times(times, "times")
        solver = _native(native_solver(self._ode_solver) if ode_solver is None else ode_solver)
        workers = None if workers is None else whole(workers, "`workers`")
        motions = None
        if contacts is not None:
            columns = definition.places["specifieds"].columns(varied, "specifieds").tolist()
            wanted = {"sensitivities": sensitivities, "control_sensitivities": control}
            motions = contacts.motions(
                problem, solver, common, columns, {**solver_kwargs, **wanted}
            )
            more = (SENSITIVITY, QUANTITY, PARAMETER) if motions.columns else ()
            names = _Names(definition, more, motions.outputs)
        else:
            names = _Names.latest(problem, sensitivities is not None)
        axes = _Axes(product, names)
        initial = check_mapping("initial_conditions", initial_conditions)
        constants = check_mapping("constants", constants)
        if len(initial) > 1 or len(constants) > 1:
            initial, constants = dict(merged(initial)), dict(merged(constants))
        places = definition.places
        x = _columns("initial_conditions", initial, places["states"], problem.x, axes, "initial")
        p = _columns("constants", constants, places["constants"], problem.p, axes, "constant")
        r = _columns("specifieds", varied, places["specifieds"], plan.values, axes, "specified")
        if definition.assumptions:
            _check_assumptions(problem, x, "states", initial, "initial_conditions")
            _check_assumptions(problem, p, "constants", constants, "constants")
            _check_assumptions(problem, r, "specifieds", varied, "specifieds")
        axes.check_names()
        for (label, attrs), (dims, value) in zip(names.constants, p, strict=True):
            if not dims:
                axes.coordinates.setdefault(label, Variable((), value, dict(attrs)))
        aligned = [_aligned(c, axes.dims) for c in (x, r, p)]
        samples = Samples(axes.dims, aligned[0], aligned[1], aligned[2], axes.coordinates)

        given: dict[str, Any] = {**solver_kwargs}
        if definition.equations.implicit is not None:
            given = with_residuals_held(definition, solver, given)
        kept, moved = None, problem.model.code
        if definition.equations.constrained or sensitivities is not None:
            moved = problem.model.with_compiled_inputs(plan)

        def at(t: np.ndarray, x: np.ndarray) -> At:
            return At(definition, moved, t, x, plan.rows(x, t), problem.p)

        if definition.equations.constrained:
            start, shape = float(times[0]), tuple(axes.dims.values())
            columns = samples.x, samples.r, samples.p
            mended = given.get("constraints") is not None
            check_samples(at, start, columns, shape, mended)
            equations = definition.equations
            left_out, every = any(equations.left_out), equations.beyond_projection
            names_of = ConstraintNames(equations) if "events" in given else ()
            kept = Kept(drift_programs(problem, moved, plan), left_out, every, mended, names_of)
        ready: PreparedIntegration | None = problem.model.code.latest.get("ensemble")
        if motions is not None:  # it has the events, and holds the constraints
            given, kept = {k: v for k, v in given.items() if k not in _ABOUT_MODES}, None
        if ready is None or not ready.is_compatible(plan, solver, given):
            ready = PreparedIntegration(problem.model, plan, solver, given)
        integrated, options, beside = ready.code, ready.options, None
        if sensitivities is not None and motions is None:
            sensitive = AugmentedSystem.of(problem, integrated, plan, sensitivities)
            looked_at = sensitive.controlled(control)
            options = sensitive.stepped(solver, options, problem.x, times, looked_at)
            beside = differentiated(at(times[:1], problem.x[None]), sensitive, options, control)
            if "events" in options:  # workers need no SymPy
                options = {**options, "events": replace(options["events"], sources=())}
        read = ready.read
        if read is None or beside is not None:
            read = _read(definition, solver, options)
        if beside is None:
            ready.read, problem.model.code.latest["ensemble"] = read, ready
        model = Model(
            rates=integrated.program("rates"),
            outputs=integrated.program("outputs") if definition.outputs_symbols else None,
            states=names.states,
            output_names=names.outputs,
            method=solver.name,
            options=read,
            times=times,
            sampled=plan.sampled,
            functions=tuple((columns, function) for columns, function, _ in plan.functions),
            jacobian=integrated.jacobian_in_parts("rates", "x") if solver.name == "radau" else None,
            sensitivities=beside,
            kept=kept,
            motions=motions,
            columns=source.columns if (source := motions or beside) else (),
        )
        reductions = read_reductions(reduce, model, names.name)
        described = names.attributes if units is None else names.described(units)
        assumed = definition.assumptions.get("states")
        told = self._contradicted
        work = Work(model, reductions, described, assumed=assumed, contradicted=told)
        about = {
            "ode_solver": solver.name,
            "lanes": LANES if model.in_lanes else 1,
            "rtol": np.asarray(read.rtol).tolist(),
            "atol": np.asarray(read.atol).tolist(),
            "pydy_version": __version__,
        }
        ensemble = Ensemble(work, samples, chunks, about, workers, progress)
        if store is not None:
            return ensemble.into(store, resume)
        if resume:
            raise ValueError("`resume=True` needs `store`, the Zarr store to resume.")
        return ensemble.run() if chunks is None else ensemble.lazy()
