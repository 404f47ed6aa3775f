"""Functions of t, x, r and p: blocks of the equations or derivatives, at one state or many."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING

import numpy as np

from pydy._assembly import CompiledModel, constraints_with_redundant
from pydy._checks import real_array
from pydy._errors import SingularMatrixError
from pydy._graph import inputs_of
from pydy._judges import check_evaluated_orientations, explain, warn_not_finite
from pydy._kernel import Kernel
from pydy._problem import (
    TOGETHER,
    AssumptionChecks,
    CallArguments,
    Problem,
    StateSamples,
    with_unknowns,
)
from pydy._program import Program
from pydy.codegen import SpecifiedsPlan

if TYPE_CHECKING:
    from pydy._program import Tangent


def _evaluate_with_vectors(
    at: StateSamples, kernel: Kernel, vectors: np.ndarray
) -> tuple[np.ndarray, bool]:
    """Evaluate a Kernel with further inputs after r, and say whether all results are finite."""
    m, split, width = len(at.x), at.r.shape[1], at.r.shape[1] + vectors.shape[1]
    out, finite = np.empty((m, kernel.program.signature.num_outputs)), True
    for first in range(0, m, TOGETHER):
        rows = slice(first, first + TOGETHER)
        batch = at.subset(rows)
        r = np.empty((len(batch.x), width))
        r[:, :split], r[:, split:] = batch.r, vectors[rows] if len(vectors) > 1 else vectors
        out[rows], part_finite = replace(batch, r=r).evaluate_checked(kernel)
        finite &= part_finite
    return out, finite


def specified_rows(r: object, t: np.ndarray, size: int) -> np.ndarray:
    """Return an array of all specifieds for m samples: shape (1, s) for all alike, or (m, s)."""
    array = real_array(r, "`r`")
    if array.shape == (size,) or array.shape == (len(t), size):
        return np.atleast_2d(array)
    raise ValueError(f"`r` must have the shape ({size},) or ({len(t)}, {size}), got {array.shape}.")


@dataclass(frozen=True, eq=False)
class Evaluator:
    """A quantity of a Problem as a function f(t, x, r, p), at one state or at m of them.

    Each argument may be None, which selects the Problem's value. States are (n,) or (m, n) with t
    a number or (m,), or a dictionary that replaces some of the initial conditions; r has the
    formats of `System.specifieds`; p is (k,), or a dictionary. The result has the shape of one
    value, or of m values.
    """

    problem: Problem
    kernel: Callable[[CompiledModel], Kernel]
    names: Callable[[], Sequence[str]]  # of its outputs, for messages
    wrt: Sequence[tuple[str, int]] = ()  # the inputs that it differentiates by
    vectors: np.ndarray | None = None  # further inputs after r
    extra_columns: int = 0  # further columns of x, after the states
    # Called with the states before the evaluation.
    check: Callable[[StateSamples], None] | None = None
    solve: bool = False  # whether implicit coordinates are solved for, although x is given
    # Whether the user's functions of specifieds are called only where the Kernel reads specifieds.
    skips_unread_inputs: bool = False
    of_constraints: bool = False  # whether what it returns are residuals of constraints

    def __call__(
        self, t: object = None, x: object = None, r: object = None, p: object = None
    ) -> np.ndarray:
        """Evaluate it."""
        problem = self.problem
        code, definition = problem.model.code, problem.definition
        n = len(definition.states)
        arguments = CallArguments(problem)
        wide, instants, single = arguments.samples(
            x, t, extra_columns=self.extra_columns, columns=True
        )
        plan: SpecifiedsPlan | None = None
        if r is None or callable(r) or isinstance(r, Mapping):
            plan = arguments.plan(r)
            plan.check_times(instants, "times" if t is None else "t")
            numbers: np.ndarray | None = None
            perturbed = any(group == "r" for group, _ in self.wrt)
            code = problem.model.with_compiled_inputs(plan, perturbed=perturbed)
            # Inputs that are passed to the call are always evaluated, and thereby checked.
            skips = r is None and self.skips_unread_inputs and bool(plan.changing)
            if skips and not self._reads_inputs(code):
                numbers = np.zeros((1, len(definition.specifieds)))
        else:
            numbers = specified_rows(r, instants, len(definition.specifieds))
        if plan is not None and plan.inputs.functions:  # which may add along rows
            wide = np.ascontiguousarray(wide)
        states = wide[:, :n]

        def rows(x: np.ndarray, t: np.ndarray) -> np.ndarray:
            if numbers is None:
                assert plan is not None
                return plan.inputs.rows(x, t)
            return numbers

        at = StateSamples(
            definition, code, instants, states, rows(states, instants), arguments.constants(p)
        )
        at = with_unknowns(at, None if self.solve else x, rows)
        if at.x is not states:
            wide = np.hstack([at.x, wide[:, n:]])
        if self.check is not None:
            self.check(at)
        kernel, vectors = self.kernel(code), self.vectors
        if definition.equations.unit_quaternions and problem.settings.contradicted is not None:
            known, held = problem.settings.contradicted, not self.of_constraints
            check_evaluated_orientations(at, kernel.program, known, held=held)
        try:
            if definition.assumptions:
                AssumptionChecks(problem).samples(at, plan, x is not None)
            if vectors is None:
                out, finite = at.evaluate_checked(kernel, wide)
            else:
                out, finite = _evaluate_with_vectors(at, kernel, vectors)
        except SingularMatrixError as error:
            k = int((at.x == error.state).all(axis=1).argmax())
            explain(error, lambda t, x: at.subset([k]))
            raise
        out = out.reshape(len(out), *kernel.program.signature.blocks[0].shape)
        if not finite:
            warn_not_finite(out, at, self.names())
        return out[0] if single else out

    def _reads_inputs(self, code: CompiledModel) -> bool:
        """Return whether the values, or the check of the states, may depend on specifieds."""
        # A property of the code: its Program and constraints are searched once.
        cache = code.latest.setdefault("reads inputs", {})
        key = self.kernel(code), self.check is None
        if key not in cache:
            cache[key] = self._depends_on_inputs(code, key[0].program)
        result: bool = cache[key]
        return result

    def _depends_on_inputs(self, code: CompiledModel, program: Program | Tangent) -> bool:
        definition = self.problem.definition
        implicit = definition.equations.constraints.residuals.implicit
        if implicit is not None or "specifieds" in definition.assumptions:
            return True
        if not isinstance(program, Program) or any(
            op == "input" and args[0] == "r"
            for op, args in zip(program.ops, program.args, strict=True)
        ):
            return True
        if self.check is None:
            return False
        assembly = code.assembly.fork()
        rows = [row for part in constraints_with_redundant(assembly) for row in part]
        return "r" in inputs_of(assembly.graph, rows).groups
