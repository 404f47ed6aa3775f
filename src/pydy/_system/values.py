"""Values of a System and their exact derivatives: Kernels at one state or several."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, replace
from functools import partial
from typing import Any

import numpy as np
import sympy as sm

from pydy._assembly.assembly import Assembly, every_input
from pydy._assembly.definition import Definition
from pydy._assembly.model import CompiledModel
from pydy._checks import flag, listed, one_or_more, real_array, shown
from pydy._errors import SingularMatrixError
from pydy._graph.node import Graph
from pydy._graph.products import derivative_program
from pydy._graph.program import Program
from pydy._graph.simplify import simplify
from pydy._kernel import Kernel
from pydy._mechanics.symbols import find_symbols
from pydy._simulation.constraint_drift import warn_of_left_out
from pydy._simulation.diagnostics import explain, warn_not_finite
from pydy._simulation.energy import Energy
from pydy._simulation.missing_derivatives import warn_of_missing_derivatives
from pydy._simulation.problem import At, Problem, samples
from pydy._simulation.states import GROUPS, located, members
from pydy._simulation.tuning import TOGETHER
from pydy._system.setup import Setup

BLOCKS = {"ode": "rates", "outputs": "outputs", "holonomic": "holonomic", "velocity": "velocity"}
"""What the user calls the blocks of an Assembly that can be differentiated."""


@dataclass(frozen=True)
class Target:
    """A quantity to differentiate."""

    block: str  # of the Assembly; empty for a choice of outputs and expressions
    chosen: tuple[Any, ...]  # places of outputs, and expressions
    names: tuple[str, ...]

    def nodes(self, assembly: Assembly) -> tuple[Graph, list[int]]:
        """Return the quantities as simplified nodes of a graph that grows on its own."""
        if self.block:
            return assembly.simplified(self.block)
        own = assembly.fork()
        nodes = [
            own.outputs[one] if isinstance(one, int) else own.read([one], "`of`")[0]
            for one in self.chosen
        ]
        return own.graph, simplify(own.graph, nodes)


def target_of(definition: Definition, of: Any, *, scalar: bool = False) -> Target:
    """Return the block, outputs or expressions that a user's `of` means; one if `scalar`."""
    if isinstance(of, str) and of in BLOCKS and not scalar:
        names = definition.row_names(BLOCKS[of])
        if not names:
            raise ValueError(f"`of` is {of!r}, but the system has nothing of this kind.")
        return Target(BLOCKS[of], (), tuple(names))
    single = isinstance(of, (str, sm.Basic))
    entries = [of] if single else listed("of", of)
    if not entries or (scalar and len(entries) > 1):
        count = "one output or expression" if scalar else "at least one output or expression"
        raise ValueError(f"`of` must be {count}, got {shown(of)}.")
    outputs, states = definition.places["outputs"], definition.places["states"]
    chosen: list[Any] = []
    time = definition.equations.time
    for entry in entries:
        place = outputs.get(entry, "of")
        if place is not None:
            chosen.append(place)
        elif isinstance(entry, str) and (k := states.get(entry, "of")) is not None:
            chosen.append(states.symbols[k])
        elif isinstance(entry, sm.Expr) and set(find_symbols([entry])) - {time}:
            chosen.append(entry)
        else:
            kinds = "" if scalar else f"one of {', '.join(map(repr, BLOCKS))}, or "
            raise ValueError(
                f"`of` must be {kinds}outputs of the system, by symbol or name, or expressions of "
                f"its states, specifieds and constants, got {shown(entry)}."
            )
    return Target("", tuple(chosen), tuple(f"the derivative of {e}" for e in entries))


def variables(definition: Definition, wrt: Any) -> tuple[tuple[str, int], ...]:
    """Return the inputs that a user's `wrt` means: groups, or some of any."""
    if isinstance(wrt, str):
        if wrt in GROUPS:
            return every_input(GROUPS[wrt], len(definition.places[wrt]))
        kinds = ", ".join(map(repr, GROUPS))
        if all(definition.places[kind].get(wrt, "wrt") is None for kind in GROUPS):
            raise ValueError(
                f"`wrt` must be one of {kinds}, or states, constants and specifieds of the system, "
                f"got {wrt!r}."
            )
    symbols = members(definition, one_or_more("wrt", wrt))
    if not symbols:
        raise ValueError("`wrt` must name at least one state, constant or specified.")
    found = (located(definition, symbol, "wrt") for symbol in symbols)
    return tuple((GROUPS[kind], place) for kind, place in found)


def _vectors(v: Any, length: int, states: Any) -> tuple[np.ndarray, int, bool]:
    """Return vectors as rows of inputs, how many there are a sample, and whether `v` is one."""
    array = real_array(v, "`v`")
    given = states is not None and not isinstance(states, Mapping)
    table = real_array(states, "`x`") if given else np.zeros(0)
    many = table.ndim == 2
    m = len(table) if many else 1
    if array.shape == (length,):
        return array[None], 1, True
    if many and array.shape == (m, length):
        return array, 1, True
    if not many and array.ndim == 2 and len(array) == length and array.size:
        return array.reshape(1, -1), array.shape[1], False
    if many and array.ndim == 3 and array.shape[:2] == (m, length) and array.size:
        return array.reshape(m, -1), array.shape[2], False
    one, more = f"({length},)", f"({length}, d)"
    if many:
        one, more = f"{one}, ({m}, {length})", f"({m}, {length}, d)"
    raise ValueError(
        f"`v` must have the shape {one} or {more}, for one vector or d of them, got {array.shape}."
    )


def evaluate_block(
    problem: Problem, block: str, given: tuple[Any, Any, Any, Any], wrt: Any = None
) -> np.ndarray:
    """Evaluate a block of the equations, or its Jacobian by `wrt`, as `variables` returns it."""
    if block in ("rates", "outputs"):
        warn_of_missing_derivatives(problem)

    def kernel(model: CompiledModel) -> Kernel:
        return model.compiled(block) if wrt is None else model.compiled_jacobian(block, wrt)

    names = partial(problem.definition.row_names, block)
    blocks = block in ("constraints", "holonomic"), block in ("constraints", "velocity")
    look = None
    if wrt is None and any(blocks) and any(problem.definition.equations.left_out):
        look = partial(warn_of_left_out, blocks=blocks)
    return Sweep(kernel, names, wrt or (), look=look).at(problem, *given)


def evaluate_product(
    problem: Problem, kind: str, of: Any, wrt: Any, v: Any, given: tuple[Any, Any, Any, Any]
) -> np.ndarray:
    """Evaluate a product with derivatives, of one of `pydy._graph.products.KINDS`."""
    definition = problem.definition
    groups = {"x": definition.states, "r": definition.specifieds, "p": definition.constants}
    target = target_of(definition, of, scalar=kind in ("gradient", "hessian-vector"))
    if target.block in ("", "rates", "outputs"):
        warn_of_missing_derivatives(problem)
    by = variables(definition, wrt)
    vectors, count, squeeze = None, 1, False
    if kind not in ("gradient", "jacobian"):
        length = len(target.names) if kind == "vector-jacobian" else len(by)
        vectors, count, squeeze = _vectors(v, length, given[0])

    def kernel(model: CompiledModel) -> Kernel:
        assembly = model.assembly

        def program() -> Program:
            graph, nodes = target.nodes(assembly)
            return derivative_program(graph, nodes, by, kind, assembly.sizes, count)

        return model.compiled_by(("product", kind, target.block, target.chosen, by, count), program)

    def names() -> list[str]:
        if kind in ("jacobian", "jacobian-vector"):
            return [*target.names]
        slopes = [f"the derivative by {groups[group][place]}" for group, place in by]
        return [target.names[0], *slopes] if kind == "gradient" else slopes

    out = Sweep(kernel, names, by, vectors).at(problem, *given)
    return out[..., 0] if squeeze else out


def _beside(at: At, kernel: Kernel, vectors: np.ndarray) -> np.ndarray:
    """Evaluate a Kernel with further inputs after r."""
    m, split, width = len(at.x), at.r.shape[1], at.r.shape[1] + vectors.shape[1]
    out = np.empty((m, len(kernel.program.outputs)))
    for first in range(0, m, TOGETHER):
        rows = slice(first, first + TOGETHER)
        some = at.some(rows)
        r = np.empty((len(some.x), width))
        r[:, :split], r[:, split:] = some.r, vectors[rows] if len(vectors) > 1 else vectors
        out[rows] = replace(some, r=r).evaluate(kernel)
    return out


def specified_rows(r: Any, t: np.ndarray, size: int) -> np.ndarray:
    """Return an array of all specifieds for m samples: shape (1, s) for all alike, or (m, s)."""
    array = real_array(r, "`r`")
    if array.shape == (size,) or array.shape == (len(t), size):
        return np.atleast_2d(array)
    raise ValueError(f"`r` must have the shape ({size},) or ({len(t)}, {size}), got {array.shape}.")


@dataclass(frozen=True, eq=False)
class Sweep:
    """A Kernel to evaluate, with the defaults of the evaluations."""

    kernel: Callable[[CompiledModel], Kernel]
    names: Callable[[], Sequence[str]]  # of its outputs, for messages
    by: Sequence[tuple[str, int]] = ()  # the inputs that it differentiates by
    vectors: np.ndarray | None = None  # further inputs after r
    more: int = 0  # further columns of x, after the states
    look: Callable[[At], None] | None = None  # at the states first
    solve: bool = False  # whether implicit coordinates are solved for, although x is given

    def at(self, problem: Problem, x: Any, t: Any, r: Any, p: Any) -> np.ndarray:
        """Evaluate it at a user's x, t, r and p."""
        code, definition = problem.model.code, problem.definition
        n = len(definition.states)
        wide, instants, single = samples(
            problem.x_with(x), t, lambda: problem.x, problem.times, n + self.more
        )
        states = wide[:, :n]
        if r is None or callable(r) or isinstance(r, Mapping):
            plan = problem.plan_with(r)
            plan.check_times(instants, "times" if t is None else "t")
            rows = plan.rows
            perturbed = any(group == "r" for group, _ in self.by)
            code = problem.model.with_compiled_inputs(plan, perturbed=perturbed)
        else:
            numbers = specified_rows(r, instants, len(definition.specifieds))

            def rows(x: np.ndarray, t: np.ndarray) -> np.ndarray:
                return numbers

        at = At(definition, code, instants, states, rows(states, instants), problem.p_with(p))
        at = at.with_unknowns(None if self.solve else x, rows)
        if at.x is not states:
            wide = np.hstack([at.x, wide[:, n:]])
        if self.look is not None:
            self.look(at)
        made, vectors = self.kernel(code), self.vectors
        try:
            if definition.assumptions:
                problem.check_states(at, x is not None, r)
            out = at.evaluate(made, wide) if vectors is None else _beside(at, made, vectors)
        except SingularMatrixError as error:
            k = int((at.x == error.state).all(axis=1).argmax())
            explain(error, lambda t, x: at.some([k]))
            raise
        out = out.reshape(len(out), *made.program.blocks[0].shape)
        if not np.isfinite(out).all():
            warn_not_finite(out, at, self.names())
        return out[0] if single else out


class Evaluation(Setup):
    """Values and exact derivatives of the equations at one state or several."""

    def evaluate_ode(
        self, x: Any = None, t: Any = None, *, r: Any = None, p: Any = None
    ) -> np.ndarray:
        """Return the derivatives of the states.

        Parameters
        ----------
        x : array_like, shape (n,) or (m, n), or dict, optional
            States, in the order of `states`; the initial conditions by default. A dictionary gives
            some of them instead, by symbol or name.
        t : float or array_like, shape (m,), optional
            Time; by default the first of `times` (all of them for m states), or zero if `times` is
            empty.
        r : dict, array_like, shape (s,) or (m, s), or callable, optional
            Specifieds for this call instead of the System's.
        p : dict or array_like, shape (k,), optional
            Constants for this call instead of the System's.

        Returns
        -------
        ndarray, shape (n,) or (m, n)

        Raises
        ------
        ValueError
            A shape is not valid.
        SingularMatrixError
            The mass matrix is singular; a subclass of `numpy.linalg.LinAlgError`.

        Examples
        --------
        >>> from pydy.models import multi_mass_spring_damper
        >>> system = multi_mass_spring_damper()
        >>> system.evaluate_ode([1.0, 0.0])
        array([ 0., -1.])
        """
        return evaluate_block(self._now(), "rates", (x, t, r, p))

    def evaluate_outputs(
        self, x: Any = None, t: Any = None, *, r: Any = None, p: Any = None
    ) -> np.ndarray:
        """Return the outputs, in the order of `outputs_symbols`.

        The parameters are those of `evaluate_ode`.

        Returns
        -------
        ndarray, shape (o,) or (m, o)

        Examples
        --------
        >>> import sympy as sm
        >>> from pydy.models import multi_mass_spring_damper
        >>> system = multi_mass_spring_damper()
        >>> x0, v0 = system.states
        >>> system.outputs = {sm.Symbol('speed'): v0, sm.Symbol('twice'): 2*x0}
        >>> system.evaluate_outputs([1.0, 3.0])
        array([3., 2.])
        """
        return evaluate_block(self._now(), "outputs", (x, t, r, p))

    def evaluate_energy(
        self, x: Any = None, t: Any = None, *, r: Any = None, p: Any = None
    ) -> Energy:
        """Return the kinetic, the potential and the total energy.

        Parameters
        ----------
        x, t, r, p
            As in `evaluate_ode`.

        Returns
        -------
        kinetic, potential, total : float or ndarray, shape (m,)
            A named tuple.

        Raises
        ------
        ValueError
            The method has no bodies, or the potential energy cannot be determined; see
            `potential_energy`.

        Examples
        --------
        >>> from pydy.models import multi_mass_spring_damper
        >>> system = multi_mass_spring_damper()
        >>> system.evaluate_energy([1.0, 3.0])
        Energy(kinetic=4.5, potential=0.5, total=5.0)
        >>> system.evaluate_energy([[1.0, 3.0], [2.0, 0.0]]).total
        array([5., 2.])
        """
        problem = self._now(constants=p)
        names = partial(problem.definition.row_names, "energy")
        values = Sweep(problem.model.energies.kernel, names).at(problem, x, t, r, p)
        return Energy(*(values.tolist() if values.ndim == 1 else values.T.copy()))

    def evaluate_constraints(
        self, x: Any = None, t: Any = None, *, r: Any = None, p: Any = None
    ) -> np.ndarray:
        """Return the residuals of the holonomic, then the nonholonomic constraints.

        The parameters are those of `evaluate_ode`.

        Returns
        -------
        ndarray, shape (o,) or (m, o)
            o is `num_constraints`.

        Raises
        ------
        ValueError
            The system has no constraints.

        Warns
        -----
        PyDyUserWarning
            All of them hold, but one that was left out as redundant does not.
        """
        self._need(self.num_constraints, "constraints")
        return evaluate_block(self._now(), "constraints", (x, t, r, p))

    def evaluate_holonomic_constraints(
        self, x: Any = None, t: Any = None, *, r: Any = None, p: Any = None
    ) -> np.ndarray:
        """Return the residuals of the holonomic constraints.

        The parameters are those of `evaluate_ode`.

        Returns
        -------
        ndarray, shape (o,) or (m, o)
            o is `num_holonomic_constraints`.

        Raises
        ------
        ValueError
            The system has no holonomic constraints.
        """
        self._need(self.num_holonomic_constraints, "holonomic constraints")
        return evaluate_block(self._now(), "holonomic", (x, t, r, p))

    def evaluate_velocity_constraints(
        self, x: Any = None, t: Any = None, *, r: Any = None, p: Any = None
    ) -> np.ndarray:
        """Return the residuals of all velocity constraints.

        The parameters are those of `evaluate_ode`.

        Returns
        -------
        ndarray, shape (o,) or (m, o)
            o is `num_velocity_constraints`.

        Raises
        ------
        ValueError
            The system has no velocity constraints.
        """
        self._need(self.num_velocity_constraints, "velocity constraints")
        return evaluate_block(self._now(), "velocity", (x, t, r, p))

    @staticmethod
    def _need(count: int, what: str) -> None:
        if not count:
            raise ValueError(f"The system has no {what} to evaluate.")

    def evaluate_jacobian(
        self,
        x: Any = None,
        t: Any = None,
        wrt: Any = "states",
        *,
        of: Any = "ode",
        r: Any = None,
        p: Any = None,
    ) -> np.ndarray:
        """Return exact partial derivatives, computed by differentiating the expression graph.

        If a specified is given as an expression, derivatives with respect to states and constants
        include it; those with respect to the specified are for an addition to its value. Specifieds
        given as functions, samples or numbers, or all specifieds if `r` is passed, are held
        constant.

        Parameters
        ----------
        x, t, r, p
            As in `evaluate_ode`.
        wrt : {'states', 'specifieds', 'constants'}, symbol or name, or a list, optional
            The variables, in the order of the arrays x, r and p; a list may contain states,
            specifieds, constants and groups of these.
        of : {'ode', 'outputs', 'holonomic', 'velocity'}, output, expression, or list, optional
            What is differentiated: the state derivatives, all outputs, residuals of constraints, or
            any outputs and expressions of states, specifieds and constants.

        Returns
        -------
        ndarray, shape (o, k) or (m, o, k)
            One column for each variable, even if there is only one.

        Raises
        ------
        ValueError
            An option is not one of the above, or the system has no variable of that name.

        Examples
        --------
        >>> from pydy.models import multi_mass_spring_damper
        >>> system = multi_mass_spring_damper()
        >>> system.evaluate_jacobian()
        array([[ 0.,  1.],
               [-1., -1.]])
        >>> system.evaluate_jacobian({'x0': 2.0}, wrt=['k0', 'v0'])
        array([[ 0.,  1.],
               [-2., -1.]])
        """
        if isinstance(of, str) and of in BLOCKS:
            by = variables(self._definition, wrt)
            return evaluate_block(self._now(), BLOCKS[of], (x, t, r, p), by)
        return evaluate_product(self._now(), "jacobian", of, wrt, None, (x, t, r, p))

    def evaluate_gradient(
        self,
        of: Any,
        x: Any = None,
        t: Any = None,
        wrt: Any = "states",
        *,
        r: Any = None,
        p: Any = None,
        value: bool = False,
    ) -> Any:
        """Return the exact gradient of one quantity, by reverse accumulation.

        It costs a small multiple of evaluating the quantity itself, regardless of the number of
        variables.

        Parameters
        ----------
        of : output or expression
            An output, by symbol or name, or an expression of states, specifieds and constants.
        x, t, wrt, r, p
            As in `evaluate_jacobian`.
        value : bool, optional
            Also return the quantity, which is computed anyway.

        Returns
        -------
        ndarray, shape (k,) or (m, k)
            With `value`, a tuple of the quantity, a float or of shape (m,), and its gradient.

        Raises
        ------
        ValueError
            The system has no such name or symbol.

        Examples
        --------
        >>> from pydy.models import multi_mass_spring_damper
        >>> system = multi_mass_spring_damper()
        >>> x0, v0 = system.states
        >>> system.evaluate_gradient(system.kinetic_energy + 3*x0**2, {'x0': 0.5, 'v0': 2.0})
        array([3., 2.])
        """
        out = evaluate_product(self._now(), "gradient", of, wrt, None, (x, t, r, p))
        if not flag(value, "`value`"):
            return out[..., 1:]
        return (float(out[0]) if out.ndim == 1 else out[:, 0]), out[..., 1:]

    def evaluate_jacobian_vector(
        self,
        v: Any,
        x: Any = None,
        t: Any = None,
        wrt: Any = "states",
        *,
        of: Any = "ode",
        r: Any = None,
        p: Any = None,
    ) -> np.ndarray:
        """Return exact directional derivatives: the Jacobian times vectors, without the Jacobian.

        Parameters
        ----------
        v : array_like, shape (k,) or (k, d)
            A direction with one component for each variable of `wrt`, or d of them as columns. For
            several states, (m, k) or (m, k, d) is also possible.
        x, t, wrt, of, r, p
            As in `evaluate_jacobian`.

        Returns
        -------
        ndarray, shape (o,), (o, d), (m, o) or (m, o, d)

        Examples
        --------
        >>> from pydy.models import multi_mass_spring_damper
        >>> multi_mass_spring_damper().evaluate_jacobian_vector([1.0, 2.0])
        array([ 2., -3.])
        """
        return evaluate_product(self._now(), "jacobian-vector", of, wrt, v, (x, t, r, p))

    def evaluate_vector_jacobian(
        self,
        v: Any,
        x: Any = None,
        t: Any = None,
        wrt: Any = "states",
        *,
        of: Any = "ode",
        r: Any = None,
        p: Any = None,
    ) -> np.ndarray:
        """Return vectors times the exact Jacobian, by reverse accumulation.

        Parameters
        ----------
        v : array_like, shape (o,) or (o, d)
            A weight for each row of `of`, or d sets of weights as columns. For several states, (m,
            o) or (m, o, d) is also possible.
        x, t, wrt, of, r, p
            As in `evaluate_jacobian`.

        Returns
        -------
        ndarray, shape (k,), (k, d), (m, k) or (m, k, d)

        Examples
        --------
        >>> from pydy.models import multi_mass_spring_damper
        >>> multi_mass_spring_damper().evaluate_vector_jacobian([0.0, 1.0], wrt=['v0', 'x0'])
        array([-1., -1.])
        """
        return evaluate_product(self._now(), "vector-jacobian", of, wrt, v, (x, t, r, p))

    def evaluate_hessian_vector(
        self,
        v: Any,
        of: Any,
        x: Any = None,
        t: Any = None,
        wrt: Any = "states",
        *,
        r: Any = None,
        p: Any = None,
    ) -> np.ndarray:
        """Return exact second derivatives of one quantity times vectors.

        These are directional derivatives of its gradient. The identity as `v` gives the Hessian.

        Parameters
        ----------
        v : array_like, shape (k,) or (k, d)
            As in `evaluate_jacobian_vector`.
        of : output or expression
            As in `evaluate_gradient`.
        x, t, wrt, r, p
            As in `evaluate_jacobian`.

        Returns
        -------
        ndarray, shape (k,), (k, d), (m, k) or (m, k, d)

        Examples
        --------
        >>> import numpy as np
        >>> from pydy.models import multi_mass_spring_damper
        >>> system = multi_mass_spring_damper()
        >>> x0, v0 = system.states
        >>> system.evaluate_hessian_vector(np.eye(2), x0**2*v0, [1.0, 5.0])
        array([[10.,  2.],
               [ 2.,  0.]])
        """
        return evaluate_product(self._now(), "hessian-vector", of, wrt, v, (x, t, r, p))
