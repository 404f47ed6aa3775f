"""Trajectory: the result of a simulation, with its names."""

from __future__ import annotations

from collections.abc import Callable, Hashable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from os import PathLike
from typing import Any, Protocol

import numpy as np

from pydy._checks import check_mapping, choice, flag, listed, number, real_array, shown
from pydy._dataset import (
    ENERGIES,
    KINDS,
    OUTPUTS,
    STATES,
    read_netcdf,
    to_dataset,
    write_netcdf,
)
from pydy._html import table_of_columns
from pydy._names import latex_of, latex_of_rate, name_of, nearest, unique_names, written_out
from pydy._optional import require
from pydy._sensitivity import Sensitivity, SensitivityModel

__all__ = ["EventRecord", "Model", "Sensitivity", "Trajectory"]


@dataclass(frozen=True, eq=False)
class EventRecord:
    """An event that happened at one instant of a simulation.

    Attributes
    ----------
    time : float
    name : str
    index : int
        Its place among the events that were watched.
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
        """Return what happened and when; the states are left out."""
        return f"EventRecord({self.name!r} at t = {self.time!r})"


class Model(Protocol):
    """What a trajectory may ask of the model it comes from, at times (m,) and states (m, n)."""

    def derivatives(self, times: np.ndarray, states: np.ndarray) -> np.ndarray:
        """Return x', shape (m, n)."""

    def outputs(self, times: np.ndarray, states: np.ndarray) -> np.ndarray:
        """Return the outputs, shape (m, o)."""

    def specifieds(self, times: np.ndarray, states: np.ndarray) -> np.ndarray:
        """Return the specifieds, shape (m, s)."""

    def energy(self, times: np.ndarray, states: np.ndarray) -> np.ndarray:
        """Return kinetic, potential and total energy, shape (m, 3)."""

    def scene(self, *visuals: Any, **options: Any) -> Any:
        """Return a scene that shows the model."""


class Trajectory:
    """States over time with their names, and what was evaluated along them.

    `System.simulate` makes one, `Trajectory.load` reads one from a file. Quantities are found by
    symbol or by name: ``trajectory[q1]``, ``trajectory['q1']``, ``trajectory['q1(t)']``; a list of
    them gives the columns of an array, ``trajectory[['q1', 'u1']]``. As an array, a trajectory is
    its `states`: ``np.asarray(trajectory)``.

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
        What the solver says about its work.
    model : Model, optional
        Evaluates derivatives, outputs and energy at other times.
    dense : callable, optional
        The solver's own interpolant: times (k,) to states (k, n).
    sensitivities : (parameters, values), optional
        Parameters, mapped to their numbers of columns, and the derivatives of the states by them,
        shape (m, n, k).
    sensitivity_model : SensitivityModel, optional
        Evaluates the derivatives of outputs, and those of sensitivities by time.

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
        The shapes do not fit each other.

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
        times: Any,
        states: Any,
        symbols: Mapping[str, Sequence[Any]],
        *,
        outputs: Any = None,
        specifieds: Any = None,
        constants: Mapping[Any, float] | None = None,
        events: Any = (),
        statistics: dict[str, Any] | None = None,
        model: Model | None = None,
        dense: Callable[[np.ndarray], np.ndarray] | None = None,
        sensitivities: tuple[Mapping[Any, int], np.ndarray] | None = None,
        sensitivity_model: SensitivityModel | None = None,
    ) -> None:
        self.times = np.array(real_array(times, "`times`"))
        if self.times.ndim != 1 or not (np.diff(self.times) >= 0.0).all():
            raise ValueError(f"`times` must be one-dimensional and ascending, got {shown(times)}.")
        m = len(self.times)
        kinds = check_mapping("symbols", symbols)
        self._symbols = {
            kind: tuple(listed(f"symbols[{kind!r}]", kinds.get(kind, ()), hashable=True))
            for kind in KINDS
        }
        self.states = _table("states", states, m, len(self.state_symbols))
        self.outputs = _table("outputs", outputs, m, len(self.outputs_symbols))
        self.specifieds = _table("specifieds", specifieds, m, len(self.specifieds_symbols))
        self.constants = {
            symbol: number(value, f"`constants[{symbol}]`")
            for symbol, value in check_mapping("constants", constants).items()
        }
        self.events = tuple(listed("events", events, "EventRecord"))
        if not all(isinstance(event, EventRecord) for event in self.events):
            raise TypeError(f"`events` must hold objects of EventRecord, got {shown(events)}.")
        self.statistics = statistics
        self._model = model
        self._dense = dense
        self._sensitivity_model = sensitivity_model
        self._sensitivities = sensitivities
        self._known_sensitivity: Sensitivity | None = None
        self._derivatives: np.ndarray | None = None
        self._energy: np.ndarray | None = None
        self._latex: dict[str, str] = {}
        self._columns = [s for kind in KINDS for s in self._symbols[kind]]
        self._names = unique_names(self._columns)
        self._place = {s: k for k, s in reversed(list(enumerate(self._columns)))}
        self._place_of_name = {n: k for k, n in enumerate(self._names)}

    # -- names ------------------------------------------------------------------------------------

    @property
    def coordinates_symbols(self) -> tuple[Any, ...]:
        """The coordinates, in the order of the first columns of `states`."""
        return self._symbols["coordinate"]

    @property
    def speeds_symbols(self) -> tuple[Any, ...]:
        """The speeds, in the order of the columns of `states` after the coordinates."""
        return self._symbols["speed"]

    @property
    def state_symbols(self) -> tuple[Any, ...]:
        """The states, in the order of the columns of `states`."""
        return tuple(s for kind in STATES for s in self._symbols[kind])

    @property
    def outputs_symbols(self) -> tuple[Any, ...]:
        """The outputs, in the order of the columns of `outputs`."""
        return tuple(s for kind in OUTPUTS for s in self._symbols[kind])

    @property
    def constraints_symbols(self) -> tuple[Any, ...]:
        """The residuals of the constraints, in the order of the columns of `constraints`."""
        return self._symbols["constraint"]

    @property
    def specifieds_symbols(self) -> tuple[Any, ...]:
        """The specifieds, in the order of the columns of `specifieds`."""
        return self._symbols["specified"]

    @property
    def names(self) -> tuple[str, ...]:
        """Names of all quantities: states, outputs, residuals, specifieds."""
        return self._names

    def names_of(self, *kinds: str) -> tuple[str, ...]:
        """Return the names of the quantities of some kinds.

        Parameters
        ----------
        *kinds : {'coordinate', 'speed', 'auxiliary', 'output', 'constraint', 'force', 'specified'}
        """
        for kind in kinds:
            choice(kind, KINDS, "`kinds`")
        all_kinds = [kind for kind in KINDS for _ in self._symbols[kind]]
        return tuple(n for n, k in zip(self._names, all_kinds, strict=True) if k in kinds)

    def name(self, key: Any) -> str:
        """Return the name of a quantity, given its symbol or its name."""
        return self._names[self._find(key)]

    def latex(self, key: Any) -> str:
        """Return the LaTeX of a quantity's symbol, without dollar signs."""
        k = self._find(key)
        if self._names[k] not in self._latex:
            self._latex[self._names[k]] = latex_of(self._columns[k])
        return self._latex[self._names[k]]

    def latex_of_rate(self, key: Any) -> str:
        """Return the LaTeX of a quantity's derivative by time, without dollar signs."""
        k = self._find(key)
        name = f"{self._names[k]}'"
        if name not in self._latex:
            self._latex[name] = latex_of_rate(self._columns[k])
        return self._latex[name]

    def _find(self, key: Any) -> int:
        k = self._place.get(key) if isinstance(key, Hashable) else None
        if k is None:
            k = self._place_of_name.get(name_of(key))
            if k is None and isinstance(key, str):  # as a symbol is printed: 'q1(t)'
                alike = [j for j, s in enumerate(self._columns) if str(s) == key]
                k = alike[0] if len(alike) == 1 else None
            own = None if k is None else self._columns[k]
            symbols = own is not None and str not in (type(own), type(key))
            if symbols and own != key and str(own) == str(key):
                raise KeyError(
                    f"`{written_out(key)}` is none of the trajectory's quantities: "
                    f"`{written_out(own)}` is another symbol, because its assumptions differ. "
                    "Use that one, or its name."
                )
        if k is None:
            raise KeyError(
                f"`{key}` is none of the trajectory's quantities: {', '.join(self._names)}. "
                f"{nearest(str(key), self._names, or_all=False)}".rstrip()
            )
        return k

    def __getitem__(self, key: Any) -> np.ndarray:
        """Return the values of one quantity, shape (m,), or of a list of k of them, (m, k)."""
        if isinstance(key, list):
            return np.array([self._one(k) for k in key]).reshape(len(key), len(self.times)).T
        return self._one(key)

    def _one(self, key: Any) -> np.ndarray:
        k = self._find(key)
        for table in (self.states, self.outputs, self.specifieds):
            if k < table.shape[1]:
                return table[:, k]
            k -= table.shape[1]
        raise AssertionError("more names than columns")

    def __contains__(self, key: Any) -> bool:
        return key in self._place or name_of(key) in self._place_of_name

    def __array__(self, dtype: Any = None, copy: bool | None = None) -> np.ndarray:
        """Return `states`, for ``np.asarray(trajectory)``."""
        as_is = dtype is None or np.dtype(dtype) == self.states.dtype
        if copy is False and not as_is:
            raise ValueError(f"The states are floats: as {np.dtype(dtype)} they must be copied.")
        return self.states if as_is and not copy else self.states.astype(dtype or float)

    def __iter__(self) -> Iterator[str]:
        return iter(self._names)

    def __repr__(self) -> str:
        shown = ", ".join(self._names[:6]) + (", ..." if len(self._names) > 6 else "")
        span = f" from {self.times[0]} to {self.times[-1]}" if len(self.times) else ""
        return f"Trajectory of {shown} at {len(self.times)} times{span}"

    def _repr_html_(self) -> str:
        return table_of_columns(repr(self), self._names[: self.states.shape[1]], self.states)

    # -- what follows from the states -------------------------------------------------------------

    @property
    def constraints(self) -> np.ndarray:
        """Residuals of the holonomic, then the nonholonomic constraints, shape (m, c)."""
        start = len(self._symbols["output"])
        return self.outputs[:, start : start + len(self._symbols["constraint"])]

    @property
    def derivatives(self) -> np.ndarray:
        """Derivatives of the states, shape (m, n), evaluated when first asked for."""
        if self._derivatives is None:
            self._derivatives = self._need_model("derivatives").derivatives(self.times, self.states)
        return self._derivatives

    @property
    def energy(self) -> np.ndarray:
        """Kinetic, potential and total energy, shape (m, 3), evaluated when first asked for.

        See `System.evaluate_energy`.
        """
        if self._energy is None:
            self._energy = self._need_model("energy").energy(self.times, self.states)
        return self._energy

    @property
    def sensitivity(self) -> Sensitivity:
        """Derivatives of states and outputs by parameters: ``trajectory.sensitivity['q1', m1]``.

        Raises
        ------
        ValueError
            The trajectory was simulated without.
        """
        found = self._sensitivity
        if found is None:
            raise ValueError(
                "The trajectory holds no sensitivities. Name the parameters when you simulate: "
                "system.simulate(sensitivities=[…])."
            )
        return found

    @property
    def _sensitivity(self) -> Sensitivity | None:
        """The same, or None; its names are found when it is first asked for."""
        if self._known_sensitivity is None and self._sensitivities is not None:
            parameters, values = self._sensitivities
            symbols = (self.state_symbols, self.outputs_symbols)
            evaluate = self._sensitivity_of_outputs
            self._known_sensitivity = Sensitivity(values, parameters, *symbols, evaluate)
        return self._known_sensitivity

    def _take_sensitivity(self, names: Sequence[str], table: np.ndarray) -> None:
        """Take sensitivities of states and outputs from a file."""
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
                "The trajectory has no model that could give the sensitivities of outputs at "
                "other times than those that were saved. Take what `System.simulate` returned."
            )
        return model.outputs(self.times, self.states, values)

    def _need_model(self, what: str) -> Model:
        if self._model is None:
            raise ValueError(
                f"The trajectory holds no {what} and has no model that could give them: it was "
                "made or saved without. Take the trajectory that `System.simulate` returned."
            )
        return self._model

    def at(self, times: Any) -> Trajectory:
        """Return the trajectory at other times.

        The states come from the solver's dense output where it gave one. Otherwise they are cubic
        Hermite interpolants of the states and their exact derivatives, with an error of fourth
        order in the distance of `times` (doubling the number of times makes it 16 times smaller);
        resets at events are nodes on both sides. Outputs and specifieds are evaluated anew; without
        a model, as after `load`, they are interpolated linearly.

        Parameters
        ----------
        times : array_like, shape (k,)
            Ascending, within the simulated time.

        Returns
        -------
        Trajectory

        Raises
        ------
        ValueError
            The times descend, or one is before the first or after the last.

        Examples
        --------
        >>> from pydy.models import multi_mass_spring_damper
        >>> system = multi_mass_spring_damper()
        >>> system.initial_conditions = {system.coordinates[0]: 1.0}
        >>> system.times = [0.0, 0.1, 0.2]
        >>> system.simulate().at([0.05, 0.15])['x0'].round(6)
        array([0.998771, 0.989312])
        """
        times = np.atleast_1d(real_array(times, "`times`"))
        if times.ndim != 1 or not (np.diff(times) >= 0.0).all():
            raise ValueError(f"`times` must be one-dimensional and ascending, got {times!r}.")
        outside = times[~((times >= self.times[0]) & (times <= self.times[-1]))]
        if outside.size:
            raise ValueError(
                f"`times` must be within the simulated time, {self.times[0]} to "
                f"{self.times[-1]}, got {outside[0]}."
            )
        states, sensitivities = self._between(times)
        if self._model is not None:
            outputs = self._model.outputs(times, states)
            specifieds = self._model.specifieds(times, states)
        else:
            outputs, specifieds = (
                np.array([np.interp(times, self.times, column) for column in table.T]).T
                for table in (self.outputs, self.specifieds)
            )
        return Trajectory(
            times,
            states,
            self._symbols,
            outputs=outputs.reshape(len(times), len(self.outputs_symbols)),
            specifieds=specifieds.reshape(len(times), len(self.specifieds_symbols)),
            constants=self.constants,
            events=self.events,
            statistics=self.statistics,
            model=self._model,
            dense=self._dense,
            sensitivities=sensitivities,
            sensitivity_model=self._sensitivity_model,
        )

    def _between(
        self, times: np.ndarray
    ) -> tuple[np.ndarray, tuple[Mapping[Any, int], np.ndarray] | None]:
        """Return the states at other times, and the sensitivities if there are any."""
        if self._sensitivity is None:
            return (self._dense or self._hermite)(times), None
        n, values, m = self.states.shape[1], self._sensitivity.values, len(self.times)
        whole = self._hermite(times)
        if self._sensitivity_model is None:  # no derivatives by time: straight lines
            columns = [np.interp(times, self.times, v) for v in values.reshape(m, -1).T]
            whole = np.column_stack([whole, *columns])
        states = whole[:, :n] if self._dense is None else self._dense(times)
        return states, (self._sensitivity.counts, whole[:, n:].reshape(len(times), n, -1))

    def _hermite(self, times: np.ndarray) -> np.ndarray:
        """Return the states, and after them the sensitivities if their derivatives are known."""
        values = None if self._sensitivity is None else self._sensitivity.values
        nodes = self.times
        x, rates = self._beside(nodes, self.states, self.derivatives, values)
        if self.events and self._model is not None:
            nodes, x, rates = self._with_events(self._model, x, rates)
        # The last of equal times, so that an interval has a length wherever there is one.
        k = np.clip(np.searchsorted(nodes, times, side="right") - 1, 0, len(nodes) - 1)
        after = np.minimum(k + 1, len(nodes) - 1)
        h = (nodes[after] - nodes[k])[:, None]
        s = np.divide((times - nodes[k])[:, None], h, out=np.zeros_like(h), where=h > 0.0)
        value = x[k] + (3.0 - 2.0 * s) * s**2 * (x[after] - x[k])
        slope = h * s * (1.0 - s) * ((1.0 - s) * rates[k] - s * rates[after])
        result: np.ndarray = value + slope
        return result

    def _beside(
        self, times: np.ndarray, states: np.ndarray, rates: np.ndarray, values: np.ndarray | None
    ) -> tuple[np.ndarray, np.ndarray]:
        """Return states and their derivatives by time with those of the sensitivities after."""
        model, m = self._sensitivity_model, len(times)
        if model is None or values is None:
            return states, rates
        slopes = model.rates(times, states, values)
        return (
            np.concatenate([states, values.reshape(m, -1)], axis=1),
            np.concatenate([rates, slopes.reshape(m, -1)], axis=1),
        )

    def _with_events(
        self, model: Model, x: np.ndarray, rates: np.ndarray
    ) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
        moments = np.repeat([e.time for e in self.events], 2)
        sides = np.array([side for e in self.events for side in (e.before, e.after)])
        values = None
        if self._sensitivity is not None:
            values = np.array(
                [v for e in self.events for v in (e.sensitivity_before, e.sensitivity_after)]
            )
        own, slopes = self._beside(moments, sides, model.derivatives(moments, sides), values)
        other = ~np.isin(self.times, moments)  # on which side such a node is, nobody tells
        nodes = np.concatenate([moments, self.times[other]])
        order = np.argsort(nodes, kind="stable")
        return (
            nodes[order],
            np.concatenate([own, x[other]])[order],
            np.concatenate([slopes, rates[other]])[order],
        )

    # -- pictures ---------------------------------------------------------------------------------

    def plot(self, names: Sequence[Any] | None = None, **options: Any) -> Any:
        """Plot the states over time, or some quantities.

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
            A name is none of the trajectory's quantities.
        """
        from pydy.plot import plot_quantities, plot_states

        if names is None:
            return plot_states(self, **options)
        return plot_quantities(self, names, **options)

    def animate(self, *visuals: Any, **options: Any) -> Any:
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
            The trajectory has no model that could be shown, as after `load`.
        """
        return self._need_model("bodies").scene(*visuals, **options).animate(self)

    # -- to and from other forms ------------------------------------------------------------------

    def to_xarray(self, derivatives: bool = False, energy: bool = False) -> Any:
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
        columns = {
            name: (kind, self.latex(name), self[name])
            for kind in KINDS
            for name in self.names_of(kind)
        }
        if derivatives:
            for k, name in enumerate(self.names_of(*STATES)):
                latex = self.latex_of_rate(name)
                columns[f"{name}'"] = ("derivative", latex, self.derivatives[:, k])
        if energy:
            for k, name in enumerate(ENERGIES):
                columns[name] = ("energy", rf"\text{{{name.replace('_', ' ')}}}", self.energy[:, k])
        names = unique_names(list(self.constants))
        constants = {
            name: (latex_of(s), float(v))
            for name, (s, v) in zip(names, self.constants.items(), strict=True)
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
        return pandas.DataFrame({name: self[name] for name in self._names}, index=index)

    def save(self, path: str | PathLike[str]) -> None:
        """Write the trajectory to a NetCDF file.

        The format is NetCDF 3, which every NetCDF library reads. Derivatives are written too, and
        energies where they are known, so that what was loaded can be interpolated and plotted.

        Parameters
        ----------
        path : path

        Raises
        ------
        ImportError
            xarray is not installed.
        TypeError
            `path` is no path.
        """
        dataset = self.to_xarray(
            derivatives=self._model is not None or self._derivatives is not None,
            energy=self._energy is not None,
        )
        write_netcdf(dataset, path, self.statistics, [vars(event) for event in self.events])

    @classmethod
    def load(cls, path: str | PathLike[str]) -> Trajectory:
        """Read a trajectory from a file that `save` wrote.

        Names stand in the place of symbols; look quantities up by either. No model is needed.

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
            The file is damaged, or holds no trajectory.
        """
        parts, statistics, events = read_netcdf(
            require("xarray", "labels", "Trajectory.load"), path, EventRecord
        )
        m = len(parts.times)
        table = {
            kind: np.array(list(columns.values())).reshape(len(columns), m).T
            for kind, columns in parts.columns.items()
        }
        empty = np.empty((m, 0))

        def together(*kinds: str) -> np.ndarray:
            return np.concatenate([table.get(kind, empty) for kind in kinds], axis=1)

        loaded = cls(
            parts.times,
            together(*STATES),
            {kind: tuple(parts.columns.get(kind, ())) for kind in KINDS},
            outputs=together(*OUTPUTS),
            specifieds=together("specified"),
            constants=parts.constants,
            events=events,
            statistics=statistics,
        )
        if parts.sensitivity is not None:
            loaded._take_sensitivity(*parts.sensitivity)
        loaded._latex = parts.latex
        loaded._derivatives = table.get("derivative")
        loaded._energy = table.get("energy")
        return loaded


def _table(argument: str, values: Any, m: int, width: int) -> np.ndarray:
    """Return an own copy with one row for each time and one column for each symbol."""
    table = np.empty((m, 0)) if values is None else np.array(real_array(values, f"`{argument}`"))
    if table.shape != (m, width):
        raise ValueError(
            f"`{argument}` must have the shape ({m}, {width}), one row for each time and one "
            f"column for each symbol, got {table.shape}."
        )
    return table
