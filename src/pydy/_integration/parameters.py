"""Parameters of a motion, selected by users: constants, initial conditions, specifieds."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np
import sympy as sm

from pydy._assembly import Definition
from pydy._checks import one_or_more, refuse_twice
from pydy._states import located, members
from pydy.codegen import SpecifiedsPlan
from pydy.inputs import SampledInput
from pydy.solvers import ParameterSize

if TYPE_CHECKING:
    from pydy._sympy_types import AnySymbol, SymbolOrName


@dataclass(frozen=True)
class Parameter:
    """A number, or the samples of an input, that a motion depends on."""

    symbol: AnySymbol  # a constant, a state for its initial condition, or a specified
    kind: str  # 'constants', 'states' or 'specifieds'
    index: int  # in p, x or r
    samples: SampledInput | None = None  # of this specified alone: each sample is a parameter

    @property
    def count(self) -> int:
        """The number of columns."""
        return 1 if self.samples is None else len(self.samples.times)

    @property
    def sized(self) -> ParameterSize:
        """The source of the parameter's size."""
        group = {"constants": "p", "states": "x", "specifieds": "r"}[self.kind]
        most = None if self.samples is None else float(np.abs(self.samples.values).max())
        return ParameterSize(group, self.index, self.count, most)


def read_parameters(
    definition: Definition,
    plan: SpecifiedsPlan,
    requested: SymbolOrName | Iterable[SymbolOrName],
    argument: str = "sensitivities",
    dependent: Sequence[AnySymbol] = (),
) -> tuple[Parameter, ...]:
    """Return the parameters that a user `requested`; a group's name selects its possible ones."""
    following = _following(definition, plan)
    symbols = members(
        definition,
        one_or_more(argument, requested),
        {"states": dependent, "specifieds": following},
    )
    if not symbols:
        raise ValueError(
            f"`{argument}` must name at least one constant, initial condition or specified."
        )
    for _, function in plan.inputs.functions:
        raise ValueError(
            f"`{argument}` needs the derivatives of the specifieds, but {function.label} is a "
            "Python function, which has none. Give it as a SymPy expression of states, time and "
            "constants, or as samples, pydy.inputs.SampledInput(times, values)."
        )
    parameters = [_parameter(definition, plan, following, symbol, argument) for symbol in symbols]
    refuse_twice([parameter.symbol for parameter in parameters], argument)
    return tuple(parameters)


def _following(definition: Definition, plan: SpecifiedsPlan) -> list[AnySymbol]:
    """Return the specifieds that are expressions, or derivatives of other specifieds."""
    return [
        symbol
        for symbol in definition.specifieds
        if symbol in plan.expressions
        or (isinstance(symbol, sm.Derivative) and symbol not in plan.given)
    ]


def _parameter(
    definition: Definition,
    plan: SpecifiedsPlan,
    following: list[AnySymbol],
    key: SymbolOrName,
    argument: str,
) -> Parameter:
    description = "constants, states (for their initial conditions) and specifieds of the system"
    kind, index = located(
        definition, key, argument, ("constants", "states", "specifieds"), description
    )
    symbol = definition.places[kind].symbols[index]
    if kind != "specifieds":
        return Parameter(symbol, kind, index)
    if symbol in plan.expressions:
        raise ValueError(
            f"`{argument}` has the specified `{symbol}`, which is given as the expression "
            f"`{plan.expressions[symbol]}`. Name the constants in it instead."
        )
    for columns, samples in plan.inputs.sampled:
        if index in columns:
            if samples.interpolation == "pchip":
                raise ValueError(
                    f"`{argument}` has `{symbol}`, whose samples are interpolated by 'pchip': its "
                    "slopes depend on the samples with kinks, such as wherever neighbours are "
                    "equal. Use the interpolation 'linear' or 'previous'."
                )
            return Parameter(symbol, kind, index, samples.of([columns.tolist().index(index)]))
    if symbol in following:
        raise ValueError(
            f"`{argument}` has `{symbol}`, which follows from `{symbol.expr}`. Name that "
            "instead, or the constants in its expression."
        )
    return Parameter(symbol, kind, index)


# -- Samples as parameters: their weights in time, and the steps that these need -------------------


def by_samples(parameter: Parameter) -> SampledInput:
    """Return the derivatives of a sampled input by each of its samples."""
    samples = parameter.samples
    assert samples is not None
    return SampledInput(samples.times, np.eye(parameter.count), samples.interpolation)


def sample_weights(
    parameters: Sequence[Parameter], definition: Definition
) -> list[tuple[np.ndarray, SampledInput]]:
    """Return the derivatives of sampled inputs by their samples, with their columns in r."""
    result, start = [], len(definition.specifieds)
    for parameter in parameters:
        if parameter.samples is not None:
            columns = np.arange(start, start + parameter.count)
            result.append((columns, by_samples(parameter)))
            start += parameter.count
    return result


def mean_spacing(parameters: Sequence[Parameter]) -> float | None:
    """Return the smallest mean sampling interval of the parameters, or None."""
    times = [p.samples.times for p in parameters if p.samples is not None and p.count > 1]
    return min((float(knots[-1] - knots[0]) / (len(knots) - 1) for knots in times), default=None)


def marker(parameters: Sequence[Parameter]) -> SampledInput | None:
    """Return an input with a kink or a jump at the time of every sample, or None.

    Collinear samples, such as zeros, leave no trace in the motion, but the derivatives by each of
    them have a kink or a jump. The integral of this input is an additional state under error
    control, so that the steps are short enough.
    """
    samples = [p.samples for p in parameters if p.samples is not None]
    if not samples:
        return None
    times = np.unique(np.concatenate([sampled.times for sampled in samples]))
    smooth = all(sampled.interpolation == "linear" for sampled in samples)
    values = np.where(np.arange(len(times)) % 2, -1.0, 1.0)[:, None]
    return SampledInput(times, values, "linear" if smooth else "previous")
