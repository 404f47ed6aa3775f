"""Quasi-steady states of a planar vehicle: its acceleration, and what is zero, as outputs."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence
from copy import copy
from typing import Any

import numpy as np
import sympy as sm
import sympy.physics.mechanics as me
from sympy.core.function import AppliedUndef
from sympy.core.relational import Relational

from pydy._checks import check_mapping, instance, one_or_more, real_array, shown
from pydy._names import some
from pydy._rank import equilibrated, independent_columns
from pydy.system import System
from pydy.vehicles.manoeuvres import check_name, names_of, three_names
from pydy.vehicles.planar import Position, check_symmetry, check_unconstrained, fixed_inputs

_SPREAD = 0.1  # of a random state, where the speeds that make up the velocity are found

Limits = tuple[np.ndarray, np.ndarray]  # the lowest and the highest values of the unknowns


class QuasiSteadyStates:
    """The states in which a vehicle accelerates while nothing else of it changes.

    The unknowns z are all states but the position, then the controls. `values` are the speed V of
    the point, its acceleration a_t along the path and V ψ' across it, then rates that are zero in
    these states, and last the limits, which must not be negative.

    A vehicle with k speeds has k rates of change: V', that of the sideslip angle, whose zero makes
    a_n = V ψ', ψ'', and those of other speeds or of the rates of coordinates.
    """

    def __init__(
        self,
        system: System,
        bounds: Mapping[Any, Any],
        inputs: Sequence[str] | None,
        position: Sequence[str],
        sideslip: float,
        slip: float,
        exclusive: Sequence[Sequence[str]],
        path: Iterable[sm.Basic] | None,
    ) -> None:
        instance(system, System, "`system`", "a System, such as double_track returns")
        coordinates = names_of(system.coordinates)
        for k, name in enumerate(three_names(position)):
            check_name(name, f"position[{k}]", coordinates)
        if len({*position}) != 3:
            raise ValueError(f"`position` must be three coordinates, got {shown(position)}.")
        x, y, psi = (system.coordinates[coordinates.index(name)] for name in position)
        self.position: Position = (x, y, psi)
        by_name = dict(
            zip(names_of(system.specifieds_symbols), system.specifieds_symbols, strict=True)
        )
        self.controls = sorted(by_name) if inputs is None else one_or_more("inputs", inputs)
        for name in self.controls:
            check_name(name, "inputs", list(by_name))
        self.vehicle = copy(system)
        self.states = list(system.states)
        self.names = names_of(self.states)
        planar_states = [self.states.index(q) for q in self.position]
        count = len(self.states) + len(self.controls)
        low, high = self._read_bounds(bounds, planar_states)
        self.pairs = self._read_exclusive(exclusive, low, high)
        seconds = [j for _, j in self.pairs]
        self.columns = np.setdiff1d(np.arange(count), [*planar_states, *seconds])
        for i, j in self.pairs:
            low[i] = -high[j]
        self.low, self.high = low[self.columns], high[self.columns]
        self.signed = [int(np.flatnonzero(self.columns == i)[0]) for i, _ in self.pairs]
        check_symmetry(system, self.position)
        self.free_inputs = [by_name[name] for name in self.controls]
        fixed = fixed_inputs(system, self.controls, self.position)
        self.vehicle.specifieds = {**fixed, **dict.fromkeys(self.free_inputs, 0.0)}
        self.start = np.zeros(count)
        for key, value in system.initial_conditions.items():
            self.start[self.names.index(str(key).removesuffix("(t)"))] = float(value)
        self.start[planar_states] = 0.0
        self.slip = slip
        equalities, ahead, aside = self._equalities(system)
        self.equalities = len(equalities)
        limits = [] if aside == 0 else [sm.tan(sideslip) * ahead + k * aside for k in (1, -1)]
        self.limit_names = ["sideslip"] * len(limits)
        further = self._read_path(path, system)
        self.limit_names += [f"path[{k}]" for k in range(len(further))]
        limits += further
        self.limits = len(limits)
        rows = [*equalities, *limits]
        self.vehicle.outputs = {sm.Symbol(f"row_{k}"): row for k, row in enumerate(rows)}
        self._variables = [*self.states, *self.free_inputs]

    def values(self, z: np.ndarray) -> np.ndarray:
        """Return the rows at unknowns z, shape (k,)."""
        result: np.ndarray = self.vehicle.evaluate_outputs(self._state(z), 0.0)
        return result

    def slopes(self, z: np.ndarray, sides: Sequence[float] = ()) -> np.ndarray:
        """Return the derivatives of the rows by the unknowns, shape (k, len(z)).

        Where an input that is one of two is zero, its derivative is that of a side: 1 or −1.
        """
        jacobian = self.vehicle.evaluate_jacobian(
            self._state(z), 0.0, wrt=self._variables, of="outputs"
        )
        result: np.ndarray = jacobian[:, self.columns]
        for k, (at, (_, second)) in enumerate(zip(self.signed, self.pairs, strict=True)):
            side = z[at] if z[at] != 0.0 or not len(sides) else sides[k]
            if side < 0.0:
                result[:, at] = -jacobian[:, second]
        return result

    def full(self, z: np.ndarray) -> np.ndarray:
        """Return all states, then the controls."""
        result = np.zeros(len(self.start))
        result[self.columns] = z
        for first, second in self.pairs:
            result[[first, second]] = max(result[first], 0.0), max(-result[first], 0.0)
        return result

    def rolling(self, speed: float) -> np.ndarray:
        """Return the unknowns of the initial state at another speed: wheels roll."""
        z = self.start.copy()
        velocity = self.values(z[self.columns])[0]
        moving = [self.names.index(name) for name in names_of(self.vehicle.speeds)]
        z[moving] *= speed / velocity
        rolling: np.ndarray = z[self.columns]
        return rolling

    def bounds(self, rolling: np.ndarray) -> Limits:
        """Return bounds of the unknowns at the speed of a rolling state.

        Spins stay near those of rolling: with some laws of tires, a wheel that spins up without
        end has the largest force.
        """
        low, high, full = self.low.copy(), self.high.copy(), self.full(rolling)
        for k, column in enumerate(self.columns):
            if column in self._spins and full[column] != 0.0:
                ends = np.sort([full[column] * (1 + side * self.slip) for side in (-1, 1)])
                low[k], high[k] = max(low[k], ends[0]), min(high[k], ends[1])
        return low, high

    def _state(self, z: np.ndarray) -> np.ndarray:
        full, n = self.full(z), len(self.states)
        self.vehicle.specifieds.update(zip(self.free_inputs, full[n:].tolist(), strict=True))
        return full[:n]

    def _equalities(self, system: System) -> tuple[list[sm.Expr], sm.Expr, sm.Expr]:
        """Return V, a_t, V ψ' and the rates that are zero, and the velocity ahead and aside."""
        equations = system.equations_of_motion()
        check_unconstrained(system, equations.constraint_jacobian)
        kinematics = dict(zip(equations.coordinates, equations.kinematics, strict=True))
        ahead, aside, yaw_rate = (
            equations.written_out(kinematics[q]).xreplace({self.position[2]: sm.S.Zero})
            for q in self.position
        )
        for e in (ahead, aside):
            if given := [str(s) for s in system.specifieds_symbols if e.has(s)]:
                raise ValueError(
                    f"`system` has a velocity that depends on {some(sorted(given))}. Make it a "
                    "state whose rate is the input."
                )
        internal, speeds = [q for q in kinematics if q not in self.position], system.speeds
        t = me.dynamicsymbols._t
        # Derivatives in outputs are evaluated with the equations, which are never written out.
        rates = {q: q.diff(t) for q in (*internal, *speeds)}

        def derivative(e: sm.Expr) -> sm.Expr:
            return sm.Add(*(e.diff(q) * rate for q, rate in rates.items() if e.has(q)))

        velocity = [u for u in speeds if any(e.has(u) for e in (ahead, aside, yaw_rate))]

        def candidates() -> Iterator[sm.Expr]:
            yield from (ahead, aside, yaw_rate)
            yield from (u for u in speeds if u not in velocity)
            for q in internal:
                yield equations.written_out(kinematics[q])
            yield from velocity

        named = {kinematics[q] for q in internal}
        self._spins = [self.states.index(u) for u in speeds if u not in {*velocity, *named}]
        square = ahead**2 + aside**2
        speed = sm.sqrt(square)
        forward, sideways = derivative(ahead), derivative(aside)
        zero = [rates[q] for q in internal]
        for e in self._independent(candidates(), speeds):
            if e is aside:
                zero.append((ahead * sideways - aside * forward) / square)
            elif e is not ahead:
                zero.append(derivative(e))
        along = (ahead * forward + aside * sideways) / speed
        return [speed, along, speed * yaw_rate, *zero], ahead, aside

    def _independent(self, candidates: Iterator[sm.Expr], speeds: Sequence[Any]) -> list[sm.Expr]:
        """Return the first candidates that are independent functions of all speeds."""
        random = np.random.default_rng(0)
        values = self.start + _SPREAD * (np.abs(self.start) + 1.0) * random.uniform(
            -1.0, 1.0, len(self.start)
        )
        numbers = dict(zip((*self.states, *self.free_inputs), values.tolist(), strict=True))
        constants = {str(key): value for key, value in self.vehicle.constants.items()}
        numbers |= {c: float(constants.get(str(c), 1.0)) for c in self.vehicle.constants_symbols}
        numbers |= {s: 0.0 for s in self.vehicle.specifieds_symbols if s not in numbers}
        chosen: list[sm.Expr] = []
        rows: list[np.ndarray] = []
        for e in candidates:
            slopes = [sm.N(e.diff(u).xreplace(numbers)) if e.has(u) else 0 for u in speeds]
            trial = np.array([*rows, slopes], dtype=float)
            if len(independent_columns(equilibrated(trial, exact=True)[0])) > len(rows):
                chosen.append(e)
                rows = list(trial)
            if len(rows) == len(speeds):
                break
        return chosen

    def _read_path(self, path: Any, system: System) -> list[sm.Expr]:
        """Return the relations of `path` as expressions that must not be negative."""
        if isinstance(path, (Relational, str, bytes)) or not (
            path is None or isinstance(path, Iterable)
        ):
            raise TypeError(f"`path` must be a sequence of relations, got {shown(path)}.")
        outputs = {
            sm.Symbol(k) if isinstance(k, str) else k: sm.sympify(e)
            for k, e in system.outputs.items()
            if not isinstance(k, tuple)
        }
        allowed = {*self.states, *system.constants_symbols, *system.specifieds_symbols}
        allowed = (allowed | {me.dynamicsymbols._t}) - {*self.position}
        limits = []
        for relation in () if path is None else path:
            if not isinstance(relation, (sm.Le, sm.Ge, sm.Lt, sm.Gt)):
                raise TypeError(
                    f"`path` must be relations, such as F <= 1000, got {shown(relation)}."
                )
            limit = (relation.gts - relation.lts).xreplace(outputs)
            unknown = ({*limit.free_symbols} | limit.atoms(AppliedUndef)) - allowed
            if unknown:
                raise ValueError(
                    f"`path` has {some(sorted(map(str, unknown)))}; it must have states, "
                    "specifieds, constants and outputs that are independent of the position."
                )
            limits.append(limit)
        return limits

    def _read_bounds(self, bounds: Any, planar_states: list[int]) -> Limits:
        """Return bounds of states and controls; those of controls are finite."""
        names = [*self.names, *self.controls]
        low, high = np.full(len(names), -np.inf), np.full(len(names), np.inf)
        possible = [name for k, name in enumerate(names) if k not in planar_states]
        for key, pair in check_mapping("bounds", bounds).items():
            name = str(key).removesuffix("(t)")
            if name in names_of(self.vehicle.specifieds_symbols) and name not in possible:
                raise ValueError(f"`inputs` must have {name!r}, which has bounds.")
            if name not in possible:
                raise ValueError(f"`bounds` must have keys of {some(possible)}, got {shown(key)}.")
            ends = pair
            if isinstance(pair, (tuple, list)) and len(pair) == 2:
                sides = zip(pair, (-np.inf, np.inf), strict=True)
                ends = [side if end is None else end for end, side in sides]
            numbers = real_array(ends, f"`bounds[{name}]`")
            if numbers.shape != (2,) or not numbers[0] < numbers[1]:
                raise ValueError(
                    f"`bounds[{name}]` must be a pair of the lowest and the highest value, got "
                    f"{shown(pair)}."
                )
            low[names.index(name)], high[names.index(name)] = numbers
        for k, name in enumerate(self.controls, len(self.names)):
            if not np.isfinite([low[k], high[k]]).all():
                raise ValueError(
                    f"`bounds` must have two finite values for each input, got none for {name!r}: "
                    f"pass `bounds={{{name!r}: (lowest, highest), …}}`, or keep its value by "
                    "naming the others in `inputs`."
                )
        return low, high

    def _read_exclusive(
        self, exclusive: Any, low: np.ndarray, high: np.ndarray
    ) -> list[tuple[int, int]]:
        """Return pairs of places of inputs, of which one is zero."""
        if not isinstance(exclusive, (list, tuple)):
            raise TypeError(
                f"`exclusive` must be a list of pairs of inputs, got {shown(exclusive)}."
            )
        pairs: list[tuple[int, int]] = []
        for k, pair in enumerate(exclusive):
            label = f"exclusive[{k}]"
            if not isinstance(pair, (tuple, list)) or len(pair) != 2:
                raise TypeError(f"`{label}` must be a pair of inputs, got {shown(pair)}.")
            for name in pair:
                check_name(name, label, self.controls)
            one, other = (len(self.names) + self.controls.index(name) for name in pair)
            if one == other or {one, other} & {place for p in pairs for place in p}:
                raise ValueError(
                    f"`{label}` must have two inputs that no other pair has, got {shown(pair)}."
                )
            if low[one] != 0.0 or low[other] != 0.0:
                raise ValueError(
                    f"`bounds` of {pair[0]} and {pair[1]} must begin at 0, because one of them is "
                    f"zero by `{label}`."
                )
            pairs.append((one, other))
        return pairs
