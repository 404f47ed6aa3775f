"""The equations that an adjoint gradient is computed with, and their derivatives."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass, replace
from functools import partial
from typing import TYPE_CHECKING

import numpy as np

from pydy._assembly import Assembly, CompiledModel
from pydy._forks import cached_property
from pydy._graph import derivative_program, simplify
from pydy._integration.initial_sensitivities import InitialSensitivities
from pydy._integration.parameters import Parameter, marker
from pydy._integration.sensitivities import AugmentedSystem
from pydy._judges import node_of
from pydy._kernel import Inputs, Kernel, KernelCall
from pydy._problem import Problem
from pydy._program import Program
from pydy.inputs import SampledInput

if TYPE_CHECKING:
    from pydy._sympy_types import Expression, SymbolOrName

InputSlot = tuple[str, int]


@dataclass(frozen=True, eq=False)
class GradientEquations:
    """The equations, objective and parameters of one gradient.

    The objective is the sum of the term `final` at the end and of an integral.
    """

    augmented: AugmentedSystem  # its model has the system's states only
    final: int | Expression | None  # the position of an output, an expression, or None
    integral: int | Expression | None

    @staticmethod
    def for_parameters(
        problem: Problem,
        model: CompiledModel,
        wrt: SymbolOrName | Iterable[SymbolOrName],
        final: int | Expression | None = None,
        integral: int | Expression | None = None,
    ) -> GradientEquations:
        """Return the equations of a Problem's gradient by the parameters `wrt` of the user."""
        augmented = AugmentedSystem.for_parameters(problem, model, problem.plan, wrt, "wrt")
        return GradientEquations(augmented, final, integral)

    @cached_property
    def full_model(self) -> CompiledModel:
        """The equations with the integral and the sample marker appended to the states."""
        marked = self.marker is not None
        model = self.augmented.model
        if self.integral is None and not marked:
            return model
        return model.variant(
            ("integral", self.integral, marked),
            partial(with_integral_and_marker, self.integral, marked),
        )

    @cached_property
    def marker(self) -> SampledInput | None:
        """See `parameters.marker`."""
        return marker(self.augmented.parameters)

    @cached_property
    def unsampled(self) -> list[Parameter]:
        """The parameters that are single numbers, without initial conditions."""
        return [p for p in self.augmented.parameters if p.kind != "states" and p.samples is None]

    @cached_property
    def sampled(self) -> list[Parameter]:
        """The parameters that are samples."""
        return [p for p in self.augmented.parameters if p.samples is not None]

    @cached_property
    def wrt(self) -> tuple[InputSlot, ...]:
        """The inputs to differentiate with respect to; sampled specifieds come last."""
        groups = {"constants": "p", "specifieds": "r"}
        return tuple((groups[p.kind], p.index) for p in (*self.unsampled, *self.sampled))

    def call_full(self, kernel: Kernel, further: int = 0) -> KernelCall:
        """Return the call of a Kernel of `full_model`, with `further` inputs after r."""
        if self.marker is None:
            return self.call(kernel, further)
        call = self.call(kernel, further + 1)
        marker_index = np.array([len(self.augmented.inputs.values)])
        sampled = (*call.inputs.sampled, (marker_index, self.marker))
        return replace(call, inputs=replace(call.inputs, sampled=sampled))

    def call(self, kernel: Kernel, further: int = 0) -> KernelCall:
        """Return the call of a Kernel, with `further` inputs after r."""
        inputs, states = self.augmented.inputs, self.augmented.definition.states
        r = np.concatenate([inputs.values, np.zeros(further)])

        def names() -> tuple[str, ...]:
            return (*map(str, states), "the integral")

        return KernelCall(kernel, self.augmented.p, Inputs(r, inputs.sampled), names)

    def rates_vjp(self) -> KernelCall:
        """Return the vector-Jacobian product Σ weight · rate; see `DiscreteAdjoint`."""
        model = self.full_model
        n = model.assembly.sizes[0]
        inputs = [*(("x", k) for k in range(n)), *self.wrt]
        make = partial(model.programs.product, "rates", inputs, "vector-jacobian")
        key = ("adjoint of the rates", self.wrt)
        return self.call_full(model.compiled_by(key, make), n)

    def objective(self) -> KernelCall:
        """Return `final` and its gradient by states, time, specifieds and parameters."""
        model = self.augmented.model
        assembly = model.assembly
        n, s, _ = assembly.sizes
        nonstate_inputs = [("t", 0), *(("r", k) for k in range(s)), *self.wrt]
        inputs = [*(("x", k) for k in range(n)), *nonstate_inputs]

        def make() -> Program:
            fork = assembly.fork()
            nodes = simplify(fork.graph, [node_of(fork, self.final, "`final`")])
            return derivative_program(fork.graph, nodes, inputs, "gradient", fork.sizes)

        key = ("gradient at the end", self.final, self.wrt)
        return self.call(model.compiled_by(key, make))

    def initial(self, problem: Problem, t: float) -> np.ndarray:
        """Return the sensitivities (n, k) of a Problem's state by all parameters, at a time."""
        initial = InitialSensitivities(self.augmented, problem.dependent, "wrt")
        return initial.values(problem.x, t)


def with_integral_and_marker(
    term: int | Expression | None, marked: bool, assembly: Assembly
) -> Assembly:
    """Return the equations with the integral and the sample marker appended to the states."""
    n, s, c = assembly.sizes
    extra_rates = [] if term is None else [node_of(assembly, term, "`integral`")]
    if marked:
        extra_rates.append(assembly.graph.input("r", s))
    blocks = replace(assembly.blocks, rates=[*assembly.blocks.rates, *extra_rates])
    return replace(assembly, sizes=(n + len(extra_rates), s + marked, c), blocks=blocks)
