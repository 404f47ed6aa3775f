"""Equilibria and linear models of a System: its equations as functions of chosen unknowns."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np

from pydy._assembly.definition import Definition
from pydy._assembly.model import CompiledModel
from pydy._assembly.specifieds import driven
from pydy._checks import Places, check_mapping, listed, number, real_array
from pydy._errors import warn_user
from pydy._kernel import Kernel
from pydy._names import unique_names
from pydy._system.evaluation import row_names
from pydy._system.start import TRIED, violations
from pydy.analysis.equilibria import Equilibrium, solve_equilibrium
from pydy.analysis.linear import LinearModel, independent_places, tangents
from pydy.codegen.arguments import SpecifiedsPlan

__all__ = ["Numbers", "find_equilibrium", "linearize", "variables"]

_GROUPS = {"states": "x", "specifieds": "r", "constants": "p"}
_EPS = float(np.finfo(float).eps)
_BESIDE = 1e-3


@dataclass(frozen=True, eq=False)
class Numbers:
    """A System's equations and numbers at one moment.

    Attributes
    ----------
    definition : Definition
    model : CompiledModel
        With its linear solve compiled in.
    plan : SpecifiedsPlan
    x, p : ndarray
        Initial conditions and constants.
    t : float
    """

    definition: Definition
    model: CompiledModel
    plan: SpecifiedsPlan
    x: np.ndarray
    p: np.ndarray
    t: float


def variables(definition: Definition, wrt: Any) -> str | tuple[tuple[str, int], ...]:
    """Return the inputs to differentiate by: a group, or some of any.

    Parameters
    ----------
    definition : Definition
    wrt : {'states', 'specifieds', 'constants'}, symbol, name, or a list
    """
    if isinstance(wrt, str) and wrt in _GROUPS:
        return _GROUPS[wrt]
    if isinstance(wrt, str):
        kinds = ", ".join(map(repr, _GROUPS))
        if all(definition.places[kind].get(wrt, "wrt") is None for kind in _GROUPS):
            raise ValueError(
                f"`wrt` must be one of {kinds}, or states, constants and specifieds of the system, "
                f"got {wrt!r}."
            )
    symbols = [wrt] if isinstance(wrt, str) or hasattr(wrt, "free_symbols") else listed("wrt", wrt)
    if not symbols:
        raise ValueError("`wrt` must name at least one state, constant or specified.")
    found = (located(definition, symbol, "wrt") for symbol in symbols)
    return tuple((_GROUPS[kind], place) for kind, place in found)


# -- equilibria -----------------------------------------------------------------------------------


class _Unknowns:
    """Symbols of all three kinds, and where they lie."""

    def __init__(self, definition: Definition, symbols: Sequence[Any]) -> None:
        self.symbols: list[Any] = []
        self.columns: dict[str, list[int]] = {kind: [] for kind in _GROUPS}
        self.order: list[tuple[str, int]] = []
        for symbol in symbols:
            kind, place = located(definition, symbol, "unknowns")
            if (kind, place) in self.order:
                raise ValueError(f"`unknowns` has `{symbol}` more than once.")
            self.order.append((kind, place))
            self.symbols.append(definition.places[kind].symbols[place])

    @property
    def names(self) -> tuple[str, ...]:
        return unique_names(self.symbols)

    def of(self, kind: str) -> tuple[list[int], list[int]]:
        """Return which of the unknowns are of a kind, and their places there."""
        found = [(k, place) for k, (what, place) in enumerate(self.order) if what == kind]
        return [k for k, _ in found], [place for _, place in found]


def located(definition: Definition, symbol: Any, argument: str) -> tuple[str, int]:
    """Return the kind of a symbol or name, and its place there.

    Raises
    ------
    ValueError
        It is no state, constant or specified.
    """
    for kind in _GROUPS:
        place = definition.places[kind].get(symbol, argument)
        if place is not None:
            return kind, place
    everything = [s for kind in _GROUPS for s in definition.places[kind].symbols]
    places = Places(everything, "states, constants and specifieds of the system")
    places.find(symbol, argument)  # raises, with names that are alike
    raise AssertionError(symbol)


def find_equilibrium(
    numbers: Numbers,
    unknowns: Iterable[Any] | None,
    given: Mapping[Any, Any] | None,
    moving: Iterable[Any],
    bounds: Mapping[Any, Any] | None,
) -> Equilibrium:
    """Return what `System.find_equilibrium` describes."""
    definition = numbers.definition
    equations = definition.equations
    states = definition.places["states"]
    q, n = len(equations.coordinates), len(equations.coordinates) + len(equations.speeds)
    steady = [states.find(s, "moving") for s in listed("moving", moving)]
    if any(place >= q for place in steady):
        names = [str(states.symbols[k]) for k in steady if k >= q]
        raise ValueError(f"`moving` must hold coordinates, got {', '.join(names)}.")
    x, p = numbers.x.copy(), numbers.p.copy()
    inputs: dict[Any, float] = {}
    given = check_mapping("given", given)
    for key, entry in given.items():
        kind, place = located(definition, key, "given")
        amount = number(entry, f"`given[{key}]`", finite=True)
        if kind == "specifieds":
            inputs[definition.specifieds[place]] = amount
        else:
            (x if kind == "states" else p)[place] = amount
    if unknowns is None:
        held = {located(definition, key, "given") for key in given}
        unknowns = [
            s
            for k, s in enumerate((*equations.coordinates, *equations.speeds))
            if k not in steady and ("states", k) not in held
        ]
    wanted = _Unknowns(definition, listed("unknowns", unknowns))
    if not wanted.symbols:
        raise ValueError("`unknowns` must name at least one state, constant or specified.")
    rows = [k for k in range(n) if k not in steady]
    by_specified, columns = wanted.of("specifieds")
    own = [definition.specifieds[k] for k in columns]
    plan = numbers.plan.updated(
        SpecifiedsPlan(
            {**inputs, **{s: _start(numbers, s) for s in own if s not in inputs}},
            definition.places["specifieds"],
            argument="given",
        )
    )
    made = driven(numbers.model, definition, plan, perturbed=bool(own or plan.functions))
    blocks = ["rates", *(b for b in ("holonomic", "velocity") if getattr(equations, b))]
    instant = np.array([numbers.t])
    r = plan.rows(x[None], instant).copy()
    by_state, at_state = wanted.of("states")
    by_constant, at_constant = wanted.of("constants")

    def put(z: np.ndarray) -> None:
        x[at_state], p[at_constant] = z[by_state], z[by_constant]
        if plan.constant:
            r[:, columns] = z[by_specified]
        else:
            r[:] = plan.rows(x[None], instant)
            r[:, columns] = z[by_specified]

    def value(kernel: Kernel) -> np.ndarray:
        out, failed = kernel.evaluate(instant, x[None], r, p)
        row: np.ndarray = np.full_like(out[0], np.nan) if failed[0] else out[0]
        return row  # a singular state on the way is none to end the search

    def residual(z: np.ndarray) -> np.ndarray:
        put(z)
        parts = [value(made.compiled(block)) for block in blocks]
        return np.concatenate([parts[0][rows], *parts[1:]])

    def jacobian(z: np.ndarray) -> np.ndarray:
        put(z)
        through = _feedback(plan, x[None], instant)[0]
        through[columns] = 0.0
        parts = []
        for block in blocks:
            part = np.zeros((len(getattr(made.assembly, block)), len(z)))
            if through.any():
                by_input = value(made.compiled_jacobian(block, "r")).reshape(len(part), -1)
                part[:, by_state] = (by_input @ through)[:, at_state]
            for kind, group in _GROUPS.items():
                places, found = wanted.of(kind)
                if places:
                    whole = value(made.compiled_jacobian(block, group))
                    part[:, places] += whole.reshape(len(part), -1)[:, found]
            parts.append(part)
        return np.vstack([parts[0][rows], *parts[1:]])

    start = np.concatenate([x[at_state], p[at_constant], r[0, columns]])
    start = start[np.argsort([*by_state, *by_constant, *by_specified])]
    names = row_names(definition, "rates")
    titles = [names[k] for k in rows] + [t for b in blocks[1:] for t in row_names(definition, b)]
    z, largest, free = solve_equilibrium(
        residual, jacobian, start, _bounds(definition, wanted, bounds), wanted.names, titles
    )
    put(z)
    values = dict(zip(wanted.symbols, z.tolist(), strict=True))
    return Equilibrium(
        values=values,
        initial_conditions=dict(zip(definition.states, x.tolist(), strict=True)),
        constants={wanted.symbols[k]: values[wanted.symbols[k]] for k in by_constant},
        specifieds={wanted.symbols[k]: values[wanted.symbols[k]] for k in by_specified},
        state=x.copy(),
        residual=largest,
        free=free,
    )


def _feedback(plan: SpecifiedsPlan, x: np.ndarray, t: np.ndarray) -> np.ndarray:
    """Return how the specifieds that are functions change with the states, shape (m, s, n).

    These are central differences; expressions are compiled into the equations instead.
    """
    m, n = x.shape
    slopes = np.zeros((m, len(plan.symbols), n))
    if plan.functions:
        for k in range(n):
            step = np.zeros_like(x)
            step[:, k] = np.cbrt(_EPS) * np.maximum(np.abs(x[:, k]), 1.0)
            ahead, behind = x + step, x - step
            change = plan.rows(ahead, t) - plan.rows(behind, t)
            slopes[:, :, k] = change / (ahead - behind)[:, k, None]
    return slopes


def _start(numbers: Numbers, symbol: Any) -> float:
    """Return the value of a specified from which to search."""
    place = numbers.definition.specifieds.index(symbol)
    row = numbers.plan.rows(numbers.x[None], np.array([numbers.t]))[0]
    return float(row[place])


def _bounds(
    definition: Definition, wanted: _Unknowns, bounds: Mapping[Any, Any] | None
) -> tuple[np.ndarray, np.ndarray]:
    low = np.full(len(wanted.symbols), -np.inf)
    high = -low
    for key, pair in check_mapping("bounds", bounds).items():
        place = located(definition, key, "bounds")
        if place not in wanted.order:
            raise ValueError(f"`bounds` has the key `{key}`, which is not one of `unknowns`.")
        limits = real_array(pair, f"`bounds[{key}]`")
        if limits.shape != (2,) or not limits[0] < limits[1]:
            raise ValueError(
                f"`bounds[{key}]` must be a pair of the lowest and the highest value, got {pair}."
            )
        k = wanted.order.index(place)
        low[k], high[k] = limits
    return low, high


# -- linear models --------------------------------------------------------------------------------


def linearize(
    numbers: Numbers,
    x: np.ndarray,
    t: np.ndarray,
    inputs: Iterable[Any] | None,
    outputs: Iterable[Any] | None,
    single: bool,
) -> LinearModel:
    """Return what `System.linearize` describes; x (m, n) and t (m,)."""
    definition = numbers.definition
    equations, places = definition.equations, definition.places
    names = unique_names(definition.states)
    plan = numbers.plan
    made = driven(numbers.model, definition, plan, perturbed=True)
    rows = plan.rows(x, t)

    def value(kernel: Kernel, width: int | None = None) -> np.ndarray:
        out = made.evaluate(kernel, t, x, rows, numbers.p)
        return out if width is None else out.reshape(len(x), -1, width)

    n, s = len(definition.states), len(definition.specifieds)
    through = _feedback(plan, x, t)

    def slopes(block: str) -> np.ndarray:
        direct = value(made.compiled_jacobian(block, "x"), n)
        if not through.any():
            return direct
        whole: np.ndarray = direct + value(made.compiled_jacobian(block, "r"), s) @ through
        return whole

    blocks = [b for b in ("holonomic", "velocity") if getattr(equations, b)]
    gradient = np.zeros((len(x), 0, n))
    if blocks:
        gradient = np.concatenate([slopes(b) for b in blocks], axis=1)
        beside = x + _BESIDE * np.maximum(np.abs(x), 1.0) * np.cos(np.arange(n))
        gradient /= _sizes(numbers, made, blocks, (t, beside, rows), gradient)
    chosen = [
        definition.states.index(state)
        for state in (*equations.dependent_coordinates, *equations.dependent_speeds)
    ]
    free, bound = independent_places(gradient[0], chosen)
    free = free[free < n - len(definition.auxiliaries)]  # integrals of outputs move nothing
    T = tangents(gradient, free, bound)
    if blocks:
        _warn_of_violations(numbers, made, t, x, rows)
    A = (slopes("rates") @ T)[:, free]
    symbols = definition.specifieds if inputs is None else listed("inputs", inputs)
    columns = [places["specifieds"].find(symbol, "inputs") for symbol in symbols]
    by_input = np.zeros((len(x), n, s))
    if columns:
        by_input = value(made.compiled_jacobian("rates", "r"), s)
        for block in blocks:
            moved = value(made.compiled_jacobian(block, "r"), s)[:, :, columns]
            if moved.any():
                raise ValueError(
                    f"The {block} constraints depend on an input of the linear model: the states "
                    "then do not follow from independent ones alone. Leave prescribed motions out "
                    "of `inputs`."
                )
    B = by_input[:, free][:, :, columns]
    C, D, titles = _outputs(numbers, outputs, value, made, slopes, T, columns)
    rates = value(made.compiled("rates"))[:, free]
    parts = [A, B, C, D, rates]
    sound = [np.isfinite(part.reshape(len(x), -1)).all(axis=1) for part in parts]
    if not np.all(sound):
        k = int(np.all(sound, axis=0).argmin())
        raise ValueError(
            f"The equations or their derivatives are not finite at {_which(k, x)}: there is no "
            "linear model. `evaluate_ode` and `evaluate_jacobian` say where they are not."
        )
    A, B, C, D, rates = (part[0] if single else part for part in parts)
    return LinearModel(
        A, B, C, D,
        tuple(names[k] for k in free),
        tuple(np.array(unique_names(definition.specifieds))[columns].tolist()),
        titles, rates,
    )  # fmt: skip


def _which(k: int, x: np.ndarray) -> str:
    return f"state {k} of `at`" if len(x) > 1 else "the state"


def _warn_of_violations(
    numbers: Numbers, made: CompiledModel, t: np.ndarray, x: np.ndarray, rows: np.ndarray
) -> None:
    """Warn of the first state that is off the constraints, of those that are tried."""
    for k in np.unique(np.linspace(0, len(x) - 1, min(len(x), TRIED)).astype(int)):
        row = rows[k if len(rows) > 1 else 0]
        told = violations(numbers.definition, made, lambda: made, float(t[k]), x[k], row, numbers.p)
        if told:
            warn_user(
                f"The linear model is one of motions that keep the constraints, but "
                f"{_which(k, x)} does not satisfy them. {told} Call "
                "`system.set_dependent_initial_conditions()` first, or take states of a motion "
                "that was integrated with `constraints='project'`."
            )
            return


def _sizes(
    numbers: Numbers,
    made: CompiledModel,
    blocks: Sequence[str],
    beside: tuple[np.ndarray, np.ndarray, np.ndarray],
    gradient: np.ndarray,
) -> np.ndarray:
    """Return how large the rows of the constraints' gradient are, shape (m, c, 1).

    A row that vanishes in a singular configuration is rounding errors there: its size is taken
    beside it.
    """
    n = gradient.shape[2]
    t, x, r = beside
    found = [made.evaluate(made.compiled_jacobian(b, "x"), t, x, r, numbers.p) for b in blocks]
    moved = np.concatenate([part.reshape(len(x), -1, n) for part in found], axis=1)
    both = np.stack([gradient, np.where(np.isfinite(moved), moved, 0.0)])
    sizes: np.ndarray = np.linalg.norm(both, axis=-1, keepdims=True).max(axis=0)
    return np.where(sizes > 0.0, sizes, 1.0)


def _outputs(
    numbers: Numbers,
    outputs: Iterable[Any] | None,
    value: Any,
    made: CompiledModel,
    slopes: Callable[[str], np.ndarray],
    T: np.ndarray,
    columns: list[int],
) -> tuple[np.ndarray, np.ndarray, tuple[str, ...]]:
    """Return C, D and the outputs' names: of states and of the System's outputs."""
    definition = numbers.definition
    m, n, s = len(T), len(definition.states), len(definition.specifieds)
    symbols = definition.states if outputs is None else listed("outputs", outputs)
    known = Places([*definition.states, *definition.outputs_symbols], "states and outputs")
    places = [known.find(symbol, "outputs") for symbol in symbols]
    by_state = np.broadcast_to(np.eye(n), (m, n, n))
    by_input = np.zeros((m, n, s))
    if any(place >= n for place in places):
        width = len(definition.outputs_symbols)
        by_state = np.concatenate([by_state, slopes("outputs")], axis=1)
        inputs = value(made.compiled_jacobian("outputs", "r"), s) if s else np.zeros((m, width, 0))
        by_input = np.concatenate([by_input, inputs], axis=1)
    C = by_state[:, places] @ T
    D = by_input[:, places][:, :, columns]
    titles = unique_names([*definition.states, *definition.outputs_symbols])
    return C, D, tuple(titles[place] for place in places)
