"""Trajectory: the result of a simulation, with named quantities."""

from __future__ import annotations

from collections.abc import Callable, Hashable, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from os import PathLike
from typing import TYPE_CHECKING, Any

import numpy as np

from pydy._checks import (
    check_mapping,
    checked_table,
    choice,
    descends,
    flag,
    listed,
    monotonic,
    number,
    shown,
)
from pydy._dataset import ENERGIES, KINDS, OUTPUTS, STATES, read_netcdf, to_dataset, write_netcdf
from pydy._html import table_of_columns
from pydy._interpolation import (
    Continued,
    Model,
    SensitivityModel,
    Sides,
    breaks,
    check_sensitivities,
    checked_times,
    reversed_rows,
    states_at_jumps,
    states_between,
    straight,
)
from pydy._names import (
    column_names,
    counted,
    latex_of,
    latex_of_rate,
    name_of,
    no_such_quantity,
    some,
    text_of,
    unique_names,
    written_out,
)
from pydy._optional import require

if TYPE_CHECKING:
    from xarray import Dataset

    from pydy._sympy_types import BySymbol, SymbolOrName

__all__ = ["EventRecord", "Model", "Sensitivity", "Trajectory"]
__dir__ = __all__.copy

# -- The quantities of a trajectory: symbols by kind, lookup by symbol or name --------------------


class Columns:
    """Symbols of the columns by kind, in the order of the columns, with unique names."""

    def __init__(self, symbols: Mapping[str, Sequence[SymbolOrName]]) -> None:
        symbols_by_kind = check_mapping("symbols", symbols)
        self.kinds = {
            kind: tuple(listed(f"symbols[{kind!r}]", symbols_by_kind.get(kind, ()), hashable=True))
            for kind in KINDS
        }
        self.symbols = list(self.of(*KINDS))
        # widths of the tables of states, outputs and specifieds
        self.widths = len(self.of(*STATES)), len(self.of(*OUTPUTS)), len(self.of("specified"))
        self.names = unique_names(self.symbols)
        self.latex_by_name: dict[str, str] = {}  # cache
        self._index = {s: k for k, s in reversed(list(enumerate(self.symbols)))}
        self._index_of_name = {n: k for k, n in enumerate(self.names)}

    def of(self, *kinds: str) -> tuple[SymbolOrName, ...]:
        """Return the symbols of some kinds, in the order in which the kinds are given."""
        return tuple(s for kind in kinds for s in self.kinds[kind])

    def names_of(self, *kinds: str) -> tuple[str, ...]:
        """Return the names of the quantities of some kinds, in the order of the columns."""
        for kind in kinds:
            choice(kind, KINDS, "`kinds`")
        all_kinds = [kind for kind in KINDS for _ in self.kinds[kind]]
        return tuple(n for n, k in zip(self.names, all_kinds, strict=True) if k in kinds)

    def latex(self, key: SymbolOrName, rate: bool = False) -> str:
        """Return the LaTeX of a quantity's symbol, or of its `rate`, the derivative by time."""
        k = self.find(key)
        name = self.names[k] + "'" * rate
        if name not in self.latex_by_name:
            self.latex_by_name[name] = (latex_of_rate if rate else latex_of)(self.symbols[k])
        return self.latex_by_name[name]

    def find(self, key: SymbolOrName) -> int:
        """Return the position of a quantity, given its symbol or its name."""
        names_one = isinstance(key, Hashable) and not isinstance(key, tuple)
        k: int | None = self._index.get(key) if names_one else None
        if k is None and names_one:
            k = self._index_of_name.get(name_of(key))
            if k is None and isinstance(key, str):  # as a symbol is printed: 'q1(t)'
                alike = [j for j, s in enumerate(self.symbols) if str(s) == key]
                k = alike[0] if len(alike) == 1 else None
            symbol = None if k is None else self.symbols[k]
            symbols = symbol is not None and str not in (type(symbol), type(key))
            if symbols and symbol != key and str(symbol) == text_of(key):
                raise KeyError(
                    f"`{written_out(key)}` is not one of the trajectory's quantities: "
                    f"`{written_out(symbol)}` is another symbol, because its assumptions differ. "
                    "Use that one, or its name."
                )
        if k is None:
            raise KeyError(no_such_quantity(key, self.names))
        return k

    def __contains__(self, key: object) -> bool:
        return key in self._index or name_of(key) in self._index_of_name


# -- Sensitivities, with their names ---------------------------------------------------------------


class Sensitivity:
    """Partial derivatives of a trajectory's quantities with respect to parameters.

    `System.simulate` computes them if its argument `sensitivities` names the parameters; they are
    the trajectory's attribute `sensitivity`. ``sensitivity['q1', 'm1']`` is ∂q1/∂m1 at all times,
    shape (m,), and ``sensitivity['q1']`` the derivatives of q1 by all parameters, shape (m, k). The
    quantities are the states and the outputs. A parameter that is a state's symbol is its initial
    condition. A specified that is given by samples has a column for each sample:
    ``sensitivity['q1', 'F']`` has the shape (m, samples).

    Attributes
    ----------
    values : ndarray, shape (m, n, k)
        Derivatives of the states.
    counts : dict
        The parameters, with their numbers of columns.
    names : tuple of str
        Of the columns: those of the parameters; ``F[0]``, ``F[1]``, … for samples.
    """

    def __init__(
        self,
        values: np.ndarray,
        parameters: Mapping[SymbolOrName, int],
        states: Sequence[SymbolOrName],
        outputs: Sequence[SymbolOrName],
        evaluate: Callable[[], np.ndarray],
    ) -> None:
        self.values = values
        self.counts = dict(parameters)
        names = unique_names(list(self.counts))
        self.names = column_names(self.counts)
        self._columns: dict[SymbolOrName, slice | int] = {n: k for k, n in enumerate(self.names)}
        start = 0
        for name, (symbol, count) in zip(names, self.counts.items(), strict=True):
            self._columns[name] = start if count == 1 else slice(start, start + count)
            self._columns[symbol] = self._columns[name]
            start += count
        symbols = (*states, *outputs)
        self.quantities = unique_names(symbols)
        self._index_of: dict[SymbolOrName, int] = {str(s): k for k, s in enumerate(symbols)}
        self._index_of.update((name, k) for k, name in enumerate(self.quantities))
        self._index_of.update((symbol, k) for k, symbol in enumerate(symbols))
        self._evaluate = evaluate
        self._outputs: np.ndarray | None = None

    @property
    def parameters(self) -> tuple[SymbolOrName, ...]:
        """The parameters, in the order of the columns."""
        return tuple(self.counts)

    @property
    def outputs(self) -> np.ndarray:
        """Derivatives of the outputs, shape (m, o, k), evaluated on first use."""
        if self._outputs is None:
            self._outputs = self._evaluate()
        return self._outputs

    def __getitem__(self, key: SymbolOrName | tuple[SymbolOrName, SymbolOrName]) -> np.ndarray:
        """Return the derivatives of a quantity, by one parameter or by all."""
        quantity, *parameter = key if isinstance(key, tuple) else (key,)
        k = _lookup(self._index_of, quantity, "states and outputs", self.quantities)
        n = self.values.shape[1]
        table = self.values[:, k] if k < n else self.outputs[:, k - n]
        for name in parameter:
            table = table[:, _lookup(self._columns, name, "parameters", self.names)]
        return table

    def table(self) -> np.ndarray:
        """Return the derivatives of all states and outputs, shape (m, n + o, k)."""
        return np.concatenate([self.values, self.outputs], axis=1)

    def __repr__(self) -> str:
        m, n, _ = self.values.shape
        return f"Sensitivity of {n} states to {', '.join(self.names)} at {m} times"


def _lookup(index_of: Mapping[Any, Any], key: Any, description: str, names: Sequence[str]) -> Any:
    index = index_of.get(key) if isinstance(key, Hashable) else None
    if index is None:
        index = index_of.get(name_of(key))
    if index is None:
        raise KeyError(
            f"`{text_of(key)}` is not one of the {description} of the sensitivities: {some(names)}."
        )
    return index


@dataclass(frozen=True, eq=False)
class EventRecord:
    """An event that happened at one instant of a simulation.

    Attributes
    ----------
    time : float
    name : str
    index : int
        Its position in the sequence of events that the simulation monitored.
    before, after : ndarray, shape (n,)
        The states on both sides; the same without a reset.
    time_sensitivity : ndarray, shape (k,), or None
        Derivatives of the event's time by the parameters, of a simulation with sensitivities.
    sensitivity_before, sensitivity_after : ndarray, shape (n, k), or None
        Derivatives of the states on both sides, at a fixed time.
    """

    time: float
    name: str
    index: int
    before: np.ndarray
    after: np.ndarray
    time_sensitivity: np.ndarray | None = None
    sensitivity_before: np.ndarray | None = None
    sensitivity_after: np.ndarray | None = None

    def __repr__(self) -> str:
        """Return the event's name and time; the states are left out."""
        return f"EventRecord({self.name!r} at t = {self.time!r})"


# -- The trajectory --------------------------------------------------------------------------------


class Trajectory(Continued):
    """States over time with their names, and the quantities evaluated along them.

    `System.simulate` returns a Trajectory, and `Trajectory.load` reads one from a file. Quantities
    are accessed by symbol or by name: ``trajectory[q1]``, ``trajectory['q1']``,
    ``trajectory['q1(t)']``; a list of them returns an array with one column for each,
    ``trajectory[['q1', 'u1']]``. Between the times they are ``trajectory.at(t)['q1']``, also in
    plots and animations. ``np.asarray(trajectory)`` returns its `states`.

    Parameters
    ----------
    times : array_like, shape (m,)
    states : array_like, shape (m, n)
    symbols : mapping of str to sequence of symbols
        Names of the columns by kind: 'coordinate', 'speed', 'auxiliary' (together the states),
        'output', 'constraint', 'force' (together the outputs), 'specified'. A string may stand for
        a symbol.
    outputs : array_like, shape (m, o), optional
    specifieds : array_like, shape (m, s), optional
    constants : mapping of symbols to floats, optional
    events : iterable of EventRecord, optional
    statistics : dict, optional
        The solver's own statistics.
    model : Model, optional
        Evaluates derivatives, outputs and energy at other times.
    dense : callable, optional
        The solver's own interpolant: times (k,) to states (k, n), then sensitivities if any.
    sensitivities : (parameters, values), optional
        Parameters, mapped to their numbers of columns, and the derivatives of the states with
        respect to them, shape (m, n, k).
    sensitivity_model : SensitivityModel, optional
        Evaluates the derivatives of outputs, and the time derivatives of sensitivities.

    Attributes
    ----------
    times : ndarray, shape (m,)
    states : ndarray, shape (m, n)
    outputs : ndarray, shape (m, o)
    constraints : ndarray, shape (m, c)
        Residuals of the holonomic, then the nonholonomic constraints.
    specifieds : ndarray, shape (m, s)
    constants : dict
    events : tuple of EventRecord
    statistics : dict or None

    Raises
    ------
    ValueError
        The shapes are not consistent.

    Examples
    --------
    >>> import numpy as np
    >>> from pydy.models import multi_mass_spring_damper
    >>> system = multi_mass_spring_damper()
    >>> system.initial_conditions = {system.coordinates[0]: 1.0}
    >>> system.times = np.linspace(0.0, 1.0, num=11)
    >>> trajectory = system.simulate()
    >>> trajectory
    Trajectory of x0, v0 at 11 times from 0.0 to 1.0
    >>> trajectory['x0'][::5].round(4)
    array([1.    , 0.8956, 0.6597])
    """

    def __init__(
        self,
        times: np.typing.ArrayLike,
        states: np.typing.ArrayLike,
        symbols: Mapping[str, Sequence[SymbolOrName]] | Columns,
        *,
        outputs: np.typing.ArrayLike | None = None,
        specifieds: np.typing.ArrayLike | None = None,
        constants: BySymbol[float] | None = None,
        events: Iterable[EventRecord] = (),
        statistics: Mapping[str, object] | None = None,
        model: Model | None = None,
        dense: Callable[[np.ndarray], np.ndarray] | None = None,
        sensitivities: tuple[Mapping[SymbolOrName, int], np.ndarray] | None = None,
        sensitivity_model: SensitivityModel | None = None,
    ) -> None:
        self.times = np.array(monotonic(times, "`times`"))
        m = len(self.times)
        self._columns = symbols if isinstance(symbols, Columns) else Columns(symbols)
        widths = self._columns.widths
        self.states = checked_table("states", states, m, widths[0])
        self.outputs = checked_table("outputs", outputs, m, widths[1])
        self.specifieds = checked_table("specifieds", specifieds, m, widths[2])
        self.constants = {
            # Names are printed lazily: printing can take longer than a short simulation.
            symbol: value if type(value) is float else number(value, f"`constants[{symbol}]`")
            for symbol, value in check_mapping("constants", constants).items()
        }
        self.events = tuple(listed("events", events, "EventRecord"))
        if not all(isinstance(event, EventRecord) for event in self.events):
            raise TypeError(f"`events` must hold objects of EventRecord, got {shown(events)}.")
        self.statistics = None if statistics is None else check_mapping("statistics", statistics)
        if model is not None and not hasattr(model, "derivatives"):
            raise TypeError(f"`model` must be what a System passes, got {shown(model)}.")
        if dense is not None and not callable(dense):
            raise TypeError(f"`dense` must be a function of times, got {shown(dense)}.")
        if sensitivities is not None:
            check_sensitivities(sensitivities, self.states.shape)
        if sensitivity_model is not None and not hasattr(sensitivity_model, "outputs"):
            raise TypeError(
                f"`sensitivity_model` must be what a System passes, got {shown(sensitivity_model)}."
            )
        self._model, self._dense = model, dense
        self._sensitivity_model, self._sensitivities = sensitivity_model, sensitivities
        self._known_sensitivity: Sensitivity | None = None
        self._derivatives: np.ndarray | None = None
        self._energy: np.ndarray | None = None
        self._jumps: tuple[EventRecord, ...] = ()  # states where inputs jump; see `_keep_jumps`
        self._sides: Sides | None = None  # read from a file; otherwise a model evaluates them

    # -- names ------------------------------------------------------------------------------------

    @property
    def coordinates_symbols(self) -> tuple[SymbolOrName, ...]:
        """The coordinates, in the order of the first columns of `states`."""
        return self._columns.of("coordinate")

    @property
    def speeds_symbols(self) -> tuple[SymbolOrName, ...]:
        """The speeds, in the order of the columns of `states` after the coordinates."""
        return self._columns.of("speed")

    @property
    def state_symbols(self) -> tuple[SymbolOrName, ...]:
        """The states, in the order of the columns of `states`."""
        return self._columns.of(*STATES)

    @property
    def outputs_symbols(self) -> tuple[SymbolOrName, ...]:
        """The outputs, in the order of the columns of `outputs`."""
        return self._columns.of(*OUTPUTS)

    @property
    def constraints_symbols(self) -> tuple[SymbolOrName, ...]:
        """The residuals of the constraints, in the order of the columns of `constraints`."""
        return self._columns.of("constraint")

    @property
    def specifieds_symbols(self) -> tuple[SymbolOrName, ...]:
        """The specifieds, in the order of the columns of `specifieds`."""
        return self._columns.of("specified")

    @property
    def names(self) -> tuple[str, ...]:
        """Names of all quantities: states, outputs, residuals, specifieds."""
        return self._columns.names

    def names_of(self, *kinds: str) -> tuple[str, ...]:
        """Return the names of the quantities of some kinds.

        Parameters
        ----------
        *kinds : {'coordinate', 'speed', 'auxiliary', 'output', 'constraint', 'force', 'specified'}
        """
        return self._columns.names_of(*kinds)

    def name(self, key: SymbolOrName) -> str:
        """Return the name of a quantity, given its symbol or its name."""
        return self._columns.names[self._columns.find(key)]

    def latex(self, key: SymbolOrName) -> str:
        """Return the LaTeX of a quantity's symbol, without dollar signs."""
        return self._columns.latex(key)

    def latex_of_rate(self, key: SymbolOrName) -> str:
        """Return the LaTeX of a quantity's time derivative, without dollar signs."""
        return self._columns.latex(key, rate=True)

    def __getitem__(self, key: SymbolOrName | list[Any]) -> np.ndarray:
        """Return the values of one quantity, shape (m,), or of a list of k of them, (m, k)."""
        if isinstance(key, list):
            return np.array([self._quantity(k) for k in key]).reshape(len(key), len(self.times)).T
        return self._quantity(key)

    def _quantity(self, key: SymbolOrName) -> np.ndarray:
        k = self._columns.find(key)
        for table in (self.states, self.outputs, self.specifieds):
            if k < table.shape[1]:
                return table[:, k]
            k -= table.shape[1]
        raise AssertionError("more names than columns")

    def __contains__(self, key: object) -> bool:
        return key in self._columns

    def __array__(self, dtype: np.dtype | None = None, copy: bool | None = None) -> np.ndarray:
        """Return `states`, for ``np.asarray(trajectory)``."""
        as_is = dtype is None or np.dtype(dtype) == self.states.dtype
        if copy is False and not as_is:
            raise ValueError(f"The states are floats: as {np.dtype(dtype)} they must be copied.")
        return self.states if as_is and not copy else self.states.astype(dtype or float)

    def __iter__(self) -> Iterator[str]:
        return iter(self.names)

    def __repr__(self) -> str:
        names = ", ".join(self.names[:6]) + (", ..." if len(self.names) > 6 else "")
        span = f" from {self.times[0]} to {self.times[-1]}" if len(self.times) else ""
        return f"Trajectory of {names} at {counted(len(self.times), 'time')}{span}"

    def _repr_html_(self) -> str:
        return table_of_columns(repr(self), self.names[: self.states.shape[1]], self.states)

    # -- quantities that follow from the states ---------------------------------------------------

    @property
    def constraints(self) -> np.ndarray:
        """Residuals of the holonomic, then the nonholonomic constraints, shape (m, c)."""
        start = len(self._columns.of("output"))
        return self.outputs[:, start : start + len(self.constraints_symbols)]

    @property
    def derivatives(self) -> np.ndarray:
        """Derivatives of the states, shape (m, n), evaluated on first use."""
        if self._derivatives is None:
            self._derivatives = self._need_model("derivatives").derivatives(self.times, self.states)
        return self._derivatives

    @property
    def energy(self) -> np.ndarray:
        """Kinetic, potential and total energy, shape (m, 3), evaluated on first use.

        See `System.evaluate_energy`.
        """
        if self._energy is None:
            self._energy = self._need_model("energy").energy(self.times, self.states)
        return self._energy

    @property
    def sensitivity(self) -> Sensitivity:
        """Derivatives with respect to parameters: ``trajectory.sensitivity['q1', m1]``.

        Raises
        ------
        ValueError
            The trajectory was simulated without sensitivities.
        """
        result = self._sensitivity
        if result is None:
            raise ValueError(
                "The trajectory contains no sensitivities. Name the parameters when you simulate: "
                "system.simulate(sensitivities=[…])."
            )
        return result

    @property
    def _sensitivity(self) -> Sensitivity | None:
        """Like `sensitivity`, or None; its names are created on first use."""
        if self._known_sensitivity is None and self._sensitivities is not None:
            parameters, values = self._sensitivities
            symbols = (self.state_symbols, self.outputs_symbols)
            evaluate = self._sensitivity_of_outputs
            self._known_sensitivity = Sensitivity(values, parameters, *symbols, evaluate)
        return self._known_sensitivity

    def _take_sensitivity(self, names: Sequence[str], table: np.ndarray) -> None:
        """Set the sensitivities of states and outputs, read from a file."""
        n = self.states.shape[1]
        columns = dict.fromkeys(names, 1)
        symbols = (self.state_symbols, self.outputs_symbols)
        self._known_sensitivity = Sensitivity(table[:, :n], columns, *symbols, lambda: table[:, n:])

    def _sensitivity_of_outputs(self) -> np.ndarray:
        model, values = self._sensitivity_model, self.sensitivity.values
        if not self.outputs_symbols:
            return np.empty((len(self.times), 0, values.shape[2]))
        if model is None:
            raise ValueError(
                "The trajectory has no model to compute the sensitivities of outputs at times that "
                "were not saved. Use the Trajectory that `System.simulate` returned."
            )
        outputs = np.array(model.outputs(self.times, self.states, values))
        # Outputs are NaN where no branch of a Piecewise applies; so are their sensitivities.
        outputs[np.isnan(self.outputs)] = np.nan
        return outputs

    def _need_model(self, description: str) -> Model:
        if self._model is None:
            raise ValueError(
                f"The trajectory contains no {description} and no model: it was loaded or "
                "created without one. Pass it to its System, as in `system.scene()."
                "animate(trajectory)` and `system.evaluate_energy(trajectory.states)`."
            )
        return self._model

    def at(self, times: np.typing.ArrayLike) -> Trajectory:
        """Return the trajectory at other times.

        The states come from the solver's dense output if there is one, as after `System.simulate`
        with a native solver. Otherwise, also after pickling and `load`, they are cubic Hermite
        interpolants of the states and their exact derivatives: twice as many times make their error
        16 times smaller. At the time of an event it is the state after it. Outputs and specifieds
        are evaluated again; without a model, as after `load`, they are interpolated linearly, from
        one event to the next.

        Parameters
        ----------
        times : array_like, shape (k,)
            Ascending or descending, within the simulated time, which ends at a terminal event.

        Returns
        -------
        Trajectory

        Raises
        ------
        ValueError
            The times are not monotonic, or one is outside the simulated time.

        Examples
        --------
        >>> from pydy.models import multi_mass_spring_damper
        >>> system = multi_mass_spring_damper()
        >>> system.initial_conditions = {system.coordinates[0]: 1.0}
        >>> system.times = [0.0, 0.1, 0.2]
        >>> system.simulate().at([0.05, 0.15])['x0'].round(6)
        array([0.998771, 0.989312])
        """
        times = checked_times(times, self)
        if descends(times):
            return reversed_rows(self.at(times[::-1]))
        if descends(self.times):
            return reversed_rows(self).at(times)
        source = self._sensitivity
        states, values = states_between(self, times)
        if self._model is not None:
            outputs = self._model.outputs(times, states)
            specifieds = self._model.specifieds(times, states)
        else:
            side_tables = (None, None) if self._sides is None else self._sides[1:]
            tables = zip((self.outputs, self.specifieds), side_tables, strict=True)
            outputs, specifieds = (straight(self, times, *pair) for pair in tables)
        result = Trajectory(
            times,
            states,
            self._columns.kinds,
            outputs=outputs.reshape(len(times), len(self.outputs_symbols)),
            specifieds=specifieds.reshape(len(times), len(self.specifieds_symbols)),
            constants=self.constants,
            events=self.events,
            statistics=self.statistics,
            model=self._model,
            dense=self._dense,
            sensitivities=None if source is None or values is None else (source.counts, values),
            sensitivity_model=self._sensitivity_model,
        )
        result._describe(self._facts)
        return result

    # -- pictures ---------------------------------------------------------------------------------

    def plot(self, names: Sequence[SymbolOrName] | None = None, **options: Any) -> Any:
        """Plot the states or selected quantities over time.

        Parameters
        ----------
        names : sequence of symbols or str, optional
            States, outputs or specifieds. By default all states are drawn, one plot for each kind.
        **options
            `ax`, `units` and `time_unit` of `pydy.plot.plot_coordinates`; without `names`, `axes`
            instead of `ax`, as for `pydy.plot.plot_states`.

        Returns
        -------
        matplotlib Axes, or ndarray of Axes

        Raises
        ------
        ImportError
            matplotlib is not installed.
        KeyError
            The trajectory has no quantity of that name.
        """
        from pydy.plot import plot_quantities, plot_states

        if names is None:
            if "ax" in options:
                raise TypeError(
                    "`ax` is for one plot, but without `names` there is one for each kind of "
                    "state: give `names`, or `axes`, a sequence of Matplotlib Axes."
                )
            return plot_states(self, **options)
        return plot_quantities(self, names, **options)

    def animate(self, *visuals: object, **options: object) -> Any:
        """Return a scene that shows this motion; a notebook displays it.

        Parameters
        ----------
        *visuals, **options
            Those of `System.scene`. By default all bodies are shown.

        Returns
        -------
        pydy.viz.Scene

        Raises
        ------
        ValueError
            The trajectory has no model to show, as after `load`.
        """
        return self._need_model("bodies").scene(*visuals, **options).animate(self)

    # -- conversion and files ---------------------------------------------------------------------

    def to_xarray(self, derivatives: bool = False, energy: bool = False) -> Dataset:
        """Return an `xarray.Dataset` with one variable for each quantity along ``time``.

        Each variable has the attributes ``role`` (its kind, such as 'coordinate' or 'output') and
        ``latex``; constants are scalar coordinates. Sensitivities are one variable, 'sensitivity',
        along ``time``, ``quantity`` and ``parameter``.

        Parameters
        ----------
        derivatives : bool, optional
            Whether derivatives of the states are added, named like ``q1'``.
        energy : bool, optional
            Whether 'kinetic_energy', 'potential_energy' and 'total_energy' are added.

        Raises
        ------
        ImportError
            xarray is not installed.
        """
        derivatives, energy = flag(derivatives, "`derivatives`"), flag(energy, "`energy`")
        columns = [
            (name, kind, self.latex(name), self[name])
            for kind in KINDS
            for name in self.names_of(kind)
        ]
        if derivatives:
            for k, name in enumerate(self.names_of(*STATES)):
                latex = self.latex_of_rate(name)
                columns.append((f"{name}'", "derivative", latex, self.derivatives[:, k]))
        if energy:
            for k, name in enumerate(ENERGIES):
                latex = rf"\text{{{name.replace('_', ' ')}}}"
                columns.append((name, "energy", latex, self.energy[:, k]))
        names = unique_names(list(self.constants))
        constants = {
            name: (latex_of(s), value)
            for name, (s, value) in zip(names, self.constants.items(), strict=True)
        }
        xarray = require("xarray", "labels", "Trajectory.to_xarray")
        return to_dataset(xarray, self.times, columns, constants, self._sensitivity)

    def to_dataframe(self) -> Any:
        """Return a `pandas.DataFrame` with one column for each quantity, indexed by ``time``.

        Raises
        ------
        ImportError
            pandas is not installed.
        """
        pandas = require("pandas", "labels", "Trajectory.to_dataframe")
        index = pandas.Index(self.times, name="time")
        return pandas.DataFrame({name: self[name] for name in self.names}, index=index)

    def _keep_jumps(self) -> None:
        """Store the states where inputs jump, for use without dense output."""
        self._jumps = self._jumps or tuple(
            EventRecord(t, "", -1, x, x, None, s, s) for t, x, s in states_at_jumps(self)
        )

    def __getstate__(self) -> dict[str, object]:
        self._keep_jumps()
        return {**self.__dict__, "_continuation": None}

    def save(self, path: str | PathLike[str]) -> None:
        """Write the trajectory to a NetCDF file.

        NetCDF 3, which every NetCDF library reads, with a checksum that `load` compares, with
        derivatives (also on both sides of events) and known energies, so that a loaded
        trajectory can be interpolated and plotted, but without the solver's dense output.

        Parameters
        ----------
        path : path

        Raises
        ------
        ImportError
            xarray is not installed.
        TypeError, ValueError
            `path` is no path, or has the suffix of another format, such as ``.csv``.
        """
        dataset = self.to_xarray(
            derivatives=self._model is not None or self._derivatives is not None,
            energy=self._energy is not None,
        )
        self._keep_jumps()
        events = [dict(vars(event)) for event in breaks(self)]
        if events and (self._model is not None or self._sides is not None):
            sides = Sides.of_trajectory(self)._asdict()
            for k, event in enumerate(events):
                event["beside"] = {name: t[2 * k : 2 * k + 2] for name, t in sides.items()}
        write_netcdf(dataset, path, self.statistics, events, self._facts)

    @classmethod
    def load(cls, path: str | PathLike[str]) -> Trajectory:
        """Read a trajectory from a file that `save` wrote.

        Quantities can be accessed by symbols or names, although only names are stored.

        Parameters
        ----------
        path : path

        Raises
        ------
        ImportError
            xarray is not installed.
        TypeError
            `path` is no path.
        ValueError
            The file is damaged, or contains no trajectory.
        """
        xarray = require("xarray", "labels", "Trajectory.load")
        sides: list[dict[str, np.ndarray] | None] = []

        def record(beside: dict[str, np.ndarray] | None = None, **attributes: Any) -> EventRecord:
            sides.append(beside)
            return EventRecord(**attributes)

        parts, statistics, events, facts = read_netcdf(xarray, path, record)
        loaded = Trajectory(  # multipliers, costates and the like are not in the file
            parts.times,
            parts.table(*STATES),
            {kind: tuple(parts.columns.get(kind, ())) for kind in KINDS},
            outputs=parts.table(*OUTPUTS),
            specifieds=parts.table("specified"),
            constants=parts.constants,
            events=[event for event in events if event.index >= 0],
            statistics=statistics,
        )
        loaded._jumps = tuple(event for event in events if event.index < 0)
        if parts.sensitivity is not None:
            loaded._take_sensitivity(*parts.sensitivity)
        loaded._columns.latex_by_name = parts.latex
        if "derivative" in parts.columns:
            loaded._derivatives = parts.table("derivative")
        if "energy" in parts.columns:
            loaded._energy = parts.table("energy")
        loaded._sides = Sides.concatenated(sides)
        loaded._describe(facts)
        return loaded
