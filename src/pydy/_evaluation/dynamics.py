"""Inverse dynamics, terms of the equations of motion, and frames, as needed to control robots.

Each is a `Quantity` of the equations, which `evaluate` evaluates for a Problem.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping, Sequence
from math import prod
from typing import TYPE_CHECKING, NamedTuple

import numpy as np
from sympy.physics.mechanics import Particle, Point, ReferenceFrame, RigidBody

from pydy._assembly import Assembly, CompiledModel, Definition, lower_nodes
from pydy._checks import SymbolIndex, describe, merged, one_or_more, real_array, shown
from pydy._errors import SingularMatrixError, warn_user
from pydy._evaluation.evaluation import variables
from pydy._evaluation.function import Evaluator
from pydy._graph import SymPyReader, derivative_program, simplify, substitute
from pydy._judges import first_violation, warn_of_missing_derivatives
from pydy._kernel import Kernel
from pydy._mechanics import (
    BodyDynamics,
    Equations,
    FrameTree,
    Multibody,
    checked_vector,
)
from pydy._names import item_of_name, name_of
from pydy._problem import Problem, StateSamples
from pydy._program import Program

if TYPE_CHECKING:
    from sympy.physics.mechanics import Vector

    from pydy._mechanics import SymbolicNodes
    from pydy._sympy_types import AnySymbol, TimeFunction


def _states(
    problem: Problem, q: object, v: object, a: np.ndarray, t: object
) -> tuple[np.ndarray, np.ndarray, tuple[Iterable[int], Iterable[int]]]:
    """Return x with a appended, the times, and the indices of q and v that are defaults.

    The shapes are those of one state or of m states.
    """
    equations, n = problem.definition.equations, len(problem.definition.states)
    nq, nu = len(equations.coordinates), len(equations.speeds)
    of_q, default_q = _columns("q", q, equations.coordinates, lambda: problem.x[:nq])
    of_v, default_v = _columns("v", v, equations.speeds, lambda: problem.x[nq : nq + nu])
    instants = np.array(problem.t) if t is None else real_array(t, "`t`")
    if instants.ndim > 1:
        raise ValueError(f"`t` must be a number or have the shape (m,), got {instants.shape}.")
    auxiliary = (problem.x[nq + nu :],) if n > nq + nu else ()
    parts = of_q, of_v, *auxiliary, a
    rows = {len(part) for part in (*parts, instants[..., None]) if part.ndim > 1}
    if not rows:
        return np.concatenate(parts), instants, (default_q, default_v)
    if len(rows) > 1:
        arrays = {"q": of_q, "v": of_v, "a": a, "t": instants[..., None]}
        counts = {name: len(part) for name, part in arrays.items() if part.ndim > 1}
        listing = ", ".join(f"`{name}` has {count}" for name, count in counts.items())
        raise ValueError(f"All must have as many rows, or be one for all: {listing}.")
    m = rows.pop()
    return _concatenated_rows(parts, m), np.full(m, instants), (default_q, default_v)


def _concatenated_rows(parts: Sequence[np.ndarray], m: int) -> np.ndarray:
    """Concatenate arrays of m rows. A row is copied as one NumPy item, in half the time."""
    parts = [part for part in parts if part.shape[-1]]
    kinds = [(f"{k}", f"V{8 * part.shape[-1]}") for k, part in enumerate(parts)]
    rows = np.empty(m, kinds)
    for (name, kind), part in zip(kinds, parts, strict=True):
        rows[name] = part.view(kind)[..., 0]
    return rows.view(float).reshape(m, rows.itemsize // 8)


def _columns(
    argument: str, value: object, symbols: Sequence[TimeFunction], default: Callable[[], np.ndarray]
) -> tuple[np.ndarray, Iterable[int]]:
    """Return numbers for all symbols, (n,) or (m, n), and the indices of those with defaults."""
    n = len(symbols)
    if value is None:
        return default(), range(n)
    if not isinstance(value, np.ndarray):
        kind = "coordinates" if argument == "q" else "speeds"
        index = SymbolIndex(symbols, f"{kind} of the system")
        if isinstance(value, Mapping):
            value = merged(value)
            numbers = index.read(argument, value, default())
            return numbers, {*range(n)}.difference(index.columns(value, argument).tolist())
        index.check_order(value, argument)
    array = real_array(value, f"`{argument}`")
    if array.ndim not in (1, 2) or array.shape[-1] != n:
        raise ValueError(f"`{argument}` must have the shape ({n},) or (m, {n}), got {array.shape}.")
    return array, ()


def accelerations_of(value: object, equations: Equations) -> tuple[np.ndarray, Sequence[int]]:
    """Return accelerations and their speeds: all of them, or the independent ones."""
    n = len(equations.speeds)
    independent = equations.dependents.independent_columns
    free = len(independent)
    if value is None:
        return np.zeros(free), independent
    if not isinstance(value, np.ndarray) and isinstance(value, Mapping):
        speeds = SymbolIndex(equations.speeds, "speeds of the system")
        accelerations: np.ndarray = speeds.read("a", value, 0.0)
        named = sorted(speeds.find(key, "a") for key in value)
        if all(k in independent for k in named):
            return accelerations[list(independent)], independent
        if len(named) not in (free, n):
            raise ValueError(
                f"`a` must have the accelerations of {free} of the {n} speeds, which those of the "
                f"others follow from by the constraints, or of all {n}, got {len(named)}: "
                f"{describe([equations.speeds[k] for k in named])}. Of independent speeds alone, "
                f"{describe([equations.speeds[k] for k in independent])}, those that are not given "
                "are zero."
            )
        return accelerations[named], named
    array = real_array(value, "`a`")
    if array.ndim not in (1, 2) or array.shape[-1] not in (n, free):
        several = f" or, for the independent speeds alone, ({free},) or (m, {free})"
        raise ValueError(
            f"`a` must have the shape ({n},) or (m, {n}){several if free < n else ''}, got "
            f"{array.shape}."
        )
    return array, range(n) if array.shape[-1] == n else independent


def all_accelerations(value: object, equations: Equations) -> np.ndarray:
    """Return the accelerations of all speeds, none of which may be missing; None means zeros."""
    n = len(equations.speeds)
    array = np.zeros(n) if value is None else accelerations_of(value, equations)[0]
    if array.shape[-1] != n:
        raise ValueError(f"`a` must have the accelerations of all {n} speeds, got {array.shape}.")
    return array


class Quantity(NamedTuple):
    """A quantity to evaluate."""

    name: str
    key: tuple[object, ...]  # identifies the expressions, together with the name
    shape: tuple[int, ...]
    # Returns the expressions, or the name of a block of the Assembly.
    expressions: Callable[[BodyDynamics], SymbolicNodes | str]
    rows: Iterable[str] = ()  # names for messages, read at most once; by default entry numbers
    accelerations: Sequence[int] = ()  # speeds whose accelerations are inputs; others are zero

    def variables(self, definition: Definition, wrt: object) -> tuple[tuple[str, int], ...]:
        """Return the inputs that the user's `wrt` means."""
        equations = definition.equations
        nq, nu = len(equations.coordinates), len(equations.speeds)
        groups = {
            "coordinates": [("x", k) for k in range(nq)],
            "speeds": [("x", nq + k) for k in range(nu)],
        }
        if self.accelerations:
            n = len(definition.states)
            groups["accelerations"] = [("x", n + k) for k in range(len(self.accelerations))]
        inputs: list[tuple[str, int]] = []
        for entry in one_or_more("wrt", wrt):
            named = isinstance(entry, str) and entry in groups
            inputs += groups[entry] if named else variables(definition, entry)
        if not inputs:
            raise ValueError("`wrt` must name at least one variable.")
        return tuple(inputs)

    def program(
        self,
        definition: Definition,
        model: CompiledModel,
        wrt: tuple[tuple[str, int], ...],
        silent: Mapping[AnySymbol, float],
    ) -> Program:
        """Return the Program of the values, or of their derivatives."""
        equations, assembly = definition.equations, model.assembly.fork()
        g, (n, s, c) = assembly.graph, assembly.sizes
        atoms, count = dict(assembly.atoms), len(self.accelerations)
        atoms.update(dict.fromkeys(equations.kinematics.speed_rates, g.zero))
        for k, column in enumerate(self.accelerations):
            atoms[equations.kinematics.speed_rates[column]] = g.input("x", n + k)
        terms = self.expressions(BodyDynamics(atoms, definition.outputs.forces, silent))
        if isinstance(terms, str):
            rates = [atoms[rate] for rate in equations.kinematics.speed_rates]
            nodes = _of_method(assembly, rates, terms)
        else:
            read = SymPyReader(g, atoms, f"the {self.name}")
            nodes = substitute(g, terms.read(read), assembly.given)
        sizes = n + count, s, c
        if not wrt:
            return lower_nodes(assembly, {self.name: nodes}, sizes=sizes)
        nodes = simplify(g, nodes)
        return derivative_program(g, nodes, wrt, "jacobian", sizes)


def _warn_of_defaults(
    at: StateSamples, program: Program, defaults: tuple[Iterable[int], Iterable[int]]
) -> None:
    """Warn if a partly given state, as far as the Program reads it, violates the constraints."""
    read = {args[1] for op, args in zip(program.ops, program.args, strict=True)
            if op == "input" and args[0] == "x"}  # fmt: skip
    first = len(at.definition.equations.coordinates)
    q, v = read.intersection(defaults[0]), read.intersection(first + k for k in defaults[1])
    moving = any(first <= k < first + len(at.definition.equations.speeds) for k in read)
    if (q or v) and (violation := first_violation(at, (bool(q), moving))):
        states = describe([at.definition.states[k] for k in sorted(q | v)])
        warn_user(
            f"The state does not satisfy the constraints, with the initial conditions for what `q` "
            f"and `v` do not give: {states}. {violation[1]} Give these too, or set consistent "
            "initial conditions: `system.set_dependent_initial_conditions()`."
        )


def _of_method(assembly: Assembly, rates: Sequence[int], kind: str) -> list[int]:
    """Return M, or M u' − F, of equations that a method derived, without constraints."""
    if kind == "matrix":
        return assembly.blocks.mass_matrix
    g, n = assembly.graph, len(rates)
    rows = [assembly.blocks.mass_matrix[i * n : (i + 1) * n] for i in range(n)]
    return [
        g.sum([*((g.mul(m, a), 1.0) for m, a in zip(row, rates, strict=True)), (f, -1.0)])
        for row, f in zip(rows, assembly.blocks.forcing, strict=True)
    ]


def bodies_of(equations: Equations) -> Multibody:
    """Return the bodies and loads, or an error where the method has none."""
    body = equations.multibody
    if body is None:
        raise ValueError(
            "This follows from bodies and loads, but `eom_method` holds no bodies: construct a "
            "KanesMethod with `bodies=` and `forcelist=`, or call its `kanes_equations(bodies, "
            "loads)`."
        )
    body.check_unchanged()
    return body


def without_bodies(equations: Equations) -> bool:
    """Return whether only the method's own equations are known, without velocity constraints."""
    return equations.formed is None and not equations.constraints.velocity


def required_forces(
    equations: Equations,
    accelerated: Sequence[int],
    at: tuple[int, ...] | None,
    *,
    zero: bool = False,
) -> Quantity:
    """Return the forces for accelerations of some speeds.

    The other accelerations follow from the constraints, or are zero.
    """
    n = len(equations.speeds)
    speeds = [equations.speeds[k] for k in at] if at is not None else equations.speeds
    bound = tuple(k for k in range(n) if k not in accelerated) if not zero else ()

    def expressions(dynamics: BodyDynamics) -> SymbolicNodes | str:
        if without_bodies(equations):
            return "forces"
        return dynamics.inverse_dynamics(bodies_of(equations), at, bound=bound)

    rows = (f"the force at {speed}" for speed in speeds)
    name = "bias forces" if zero else "inverse dynamics"
    return Quantity(name, (at, bound), (len(speeds),), expressions, rows, accelerated)


def chosen_speeds(equations: Equations, at: object) -> tuple[int, ...] | None:
    """Return the columns of the speeds that a user's `at` selects."""
    if at is None:
        return None
    speeds, constraint_count = equations.speeds, len(equations.constraints.velocity)
    free = len(speeds) - constraint_count
    if isinstance(at, str) and at == "independent":
        return equations.dependents.independent_columns
    index = SymbolIndex(speeds, "speeds of the system")
    columns = tuple(index.find(speed, "at") for speed in one_or_more("at", at))
    if len({*columns}) != len(columns) or len(columns) != free:
        raise ValueError(
            f"`at` must be 'independent' or {free} different speeds, as many as "
            f"{constraint_count} constraints leave free of {len(speeds)}, got "
            f"{describe([speeds[k] for k in columns])}."
        )
    return columns


# -- Frames and points -----------------------------------------------------------------------------


def _frame_and_point(
    equations: Equations, eom_method: object, target: object
) -> tuple[ReferenceFrame | None, Point | None]:
    """Return the frame and the point that a user's `where` means; either may be None."""
    bodies, named_frames = bodies_of(equations).bodies, getattr(eom_method, "frames", None) or {}
    if isinstance(target, str) and target in named_frames:
        return (*named_frames[target],)
    body = item_of_name(bodies, target)
    if isinstance(body, RigidBody):
        return body.frame, body.masscenter
    if isinstance(body, Particle):
        return None, body.masscenter
    if isinstance(target, Point):
        return None, target
    if isinstance(target, ReferenceFrame):
        return target, None
    if isinstance(target, tuple) and len(target) == 2:
        frame, point = target
        if isinstance(frame, ReferenceFrame) and isinstance(point, Point):
            return frame, point
    names = dict.fromkeys([*named_frames, *(str(name_of(body)) for body in bodies)])
    raise ValueError(
        "`where` must be a body, Point, ReferenceFrame, or pair of a ReferenceFrame and a Point, "
        f"or a name: {describe(list(names))}; got {shown(target)}."
    )


def _origin(body: Multibody, point: Point) -> Point:
    """Return the point that positions are measured from."""
    origin = body.origin
    if origin is None:
        raise ValueError(
            f"No point at rest in `{body.frame}` is connected with the bodies, so that positions "
            f"have no origin. Say `O.set_vel({body.frame}, 0)` of one."
        )
    if point not in FrameTree.points_from([origin]):
        raise ValueError(
            f"`where` is the point {point}, whose place beside {origin} is not known. Locate it "
            f"with `{point}.set_pos(...)` from a point of the bodies."
        )
    return origin


def evaluate(
    problem: Problem,
    quantity: Quantity,
    at: tuple[object, object, np.ndarray, object],
    r: object = None,
    p: object = None,
    wrt: object = None,
    values: Mapping[AnySymbol, float] | None = None,
) -> np.ndarray:
    """Evaluate a quantity at the user's q, v, a and t.

    The method may have `values` of constants that the motion does not depend on.
    """
    warn_of_missing_derivatives(problem)
    definition, silent = problem.definition, values or {}
    equations = definition.equations
    x, t, defaults = _states(problem, *at)
    inputs = () if wrt is None else quantity.variables(definition, wrt)
    size = prod(quantity.shape)
    key = quantity.name, quantity.key, tuple(quantity.accelerations), inputs

    def kernel(model: CompiledModel) -> Kernel:
        return model.compiled_by(key, lambda: quantity.program(definition, model, inputs, silent))

    def check(state: StateSamples) -> None:
        _warn_of_defaults(state, kernel(state.model).program, defaults)

    f = Evaluator(
        problem,
        kernel,
        lambda: [*quantity.rows] or [f"entry {k} of the {quantity.name}" for k in range(size)],
        inputs,
        extra_columns=at[2].shape[-1],
        check=check if equations.constraints.are_present else None,
        skips_unread_inputs=True,
        solve=all(
            {*columns} <= {*defaults[0]} for _, columns in equations.constraints.residuals.blocks
        ),
    )
    shape = (*quantity.shape, len(inputs)) if inputs else quantity.shape
    return f(t, x, r, p).reshape(*x.shape[:-1], *shape)


def inverse_dynamics(
    problem: Problem,
    at: tuple[object, object, object, object],
    speeds: object,
    r: object,
    p: object,
    wrt: object,
    values: Mapping[AnySymbol, float],
) -> np.ndarray:
    """Return the forces at some `speeds` for a motion; see `System.inverse_dynamics`."""
    equations, (q, v, a, t) = problem.definition.equations, at
    rates, accelerated = accelerations_of(a, equations)
    quantity = required_forces(equations, accelerated, chosen_speeds(equations, speeds))
    try:
        return evaluate(problem, quantity, (q, v, rates, t), r, p, wrt, values)
    except SingularMatrixError as error:
        raise SingularMatrixError(
            f"`at` and `a` leave what the constraints do open at t = {error.time!r}: there "
            "they have no full rank in the other speeds. Give other speeds as `at`, and the "
            "accelerations of all speeds.",
            error.time,
            error.state,
        ) from None


def mass_matrix(equations: Equations) -> Quantity:
    """Return the mass matrix of all speeds."""
    n = len(equations.speeds)

    def expressions(dynamics: BodyDynamics) -> SymbolicNodes | str:
        if not equations.constraints.velocity:
            return "matrix"
        return dynamics.mass_matrix(bodies_of(equations))

    return Quantity("mass matrix", (), (n, n), expressions)


def gravity(equations: Equations, acceleration: Vector | None) -> Quantity:
    """Return the weights at the speeds, with the loads' acceleration of gravity or another one."""
    if acceleration is not None:
        checked_vector(acceleration, "`acceleration`")
    body = bodies_of(equations)

    def expressions(dynamics: BodyDynamics) -> SymbolicNodes:
        forces = dynamics.holding_forces(body, acceleration)
        if forces is None:
            raise ValueError(
                "The loads at the mass centres do not tell which way gravity pulls: no "
                "acceleration times the mass is among them for all bodies. Give it: "
                f"`acceleration=-g*{body.frame}.z`."
            )
        return forces

    rows = (f"the weight at {speed}" for speed in equations.speeds)
    key = components_of(acceleration)
    return Quantity("gravity", key, (len(equations.speeds),), expressions, rows)


def components_of(acceleration: Vector | None) -> tuple[tuple[object, ...], ...]:
    """Return what distinguishes an acceleration: its components and their frames."""
    return () if acceleration is None else tuple((*m, f) for m, f in acceleration.args)


def frame_position(equations: Equations, method: object, target: object) -> Quantity:
    """Return the position of a point from a point at rest."""
    body = bodies_of(equations)
    _, point = _frame_and_point(equations, method, target)
    if point is None:
        raise ValueError(f"`where` must have a point, got the frame {target}.")
    origin = _origin(body, point)
    rows = (f"the {axis} of {point}" for axis in "xyz")

    def expressions(dynamics: BodyDynamics) -> SymbolicNodes:
        return dynamics.position(body, point, origin)

    return Quantity("position", (point,), (3,), expressions, rows)


def frame_rotation(equations: Equations, method: object, target: object) -> Quantity:
    """Return the rotation matrix of a frame to the inertial one."""
    body = bodies_of(equations)
    frame, _ = _frame_and_point(equations, method, target)
    if frame is None:
        raise ValueError(f"`where` must have a frame, got {target}, which does not turn.")
    return Quantity("rotation", (frame,), (3, 3), lambda dynamics: dynamics.rotation(body, frame))


def frame_jacobian(equations: Equations, method: object, target: object) -> Quantity:
    """Return the partial velocities of a point, above the partial angular ones of a frame."""
    body = bodies_of(equations)
    frame, point = _frame_and_point(equations, method, target)
    if point is not None:
        _origin(body, point)
    count = 3 * ((point is not None) + (frame is not None))

    def expressions(dynamics: BodyDynamics) -> SymbolicNodes:
        return dynamics.partial_velocities(body, point, frame)

    shape = count, len(equations.speeds)
    return Quantity("frame Jacobian", (point, frame), shape, expressions)
