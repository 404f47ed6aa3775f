"""Diagnose from the numbers at a state why derivatives are not finite, or hard to integrate.

Loads are suspected last. In sound mechanisms, divisions by zero come from constraints that cannot
be solved for the dependent speeds, from zero pivots of SymPy, or from gimbal lock.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import replace
from typing import TYPE_CHECKING, Any

import numpy as np

from pydy import _errors
from pydy._assembly import Assembly
from pydy._checks import describe
from pydy._errors import IntegrationError, SingularMatrixError
from pydy._graph import jacobian
from pydy._names import numbers_of, unique_names
from pydy._problem import Problem, StateSamples, first_undefined
from pydy._rank import DEPENDENT, DIGITS, equilibrated, independent_columns
from pydy.solvers import Outcome
from pydy.trajectory import Trajectory

if TYPE_CHECKING:
    from pydy._mechanics import Equations
    from pydy._sympy_types import TimeFunction

# What a solver squares over tolerances, which are seldom below the precision of floats.
_LARGEST = float(np.sqrt(np.finfo(float).max) * np.finfo(float).eps)


_DIAGNOSED = (
    *(Outcome.NOT_FINITE, Outcome.SINGULAR),
    *(Outcome.STEP_UNDERFLOW, Outcome.CONSTRAINTS_NOT_MET),
)
"""Failures that a singularity of the equations may have caused."""


def explain(
    error: IntegrationError | SingularMatrixError,
    at: Callable[[np.ndarray, np.ndarray], StateSamples],
) -> None:
    """Replace the general advice in an error's message by the cause."""
    code: int | None = Outcome.SINGULAR
    if isinstance(error, IntegrationError):
        code = error.info.get("code")
    if code in _DIAGNOSED:
        cause = diagnosis_of(at(np.array([error.time]), np.array([error.state])))
        if cause:
            error.args = (str(error).removesuffix(Outcome(code).remedy) + cause,)


def explain_columns(error: BaseException, columns: np.ndarray) -> None:
    """Add to an error's message that sensitivities left the range of floats, if they did."""
    largest = np.abs(columns).max(initial=0.0)
    code: Any = getattr(error, "info", {}).get("code")
    if not largest <= _LARGEST and code in [*Outcome]:
        error.args = (
            f"{str(error).removesuffix(Outcome(code).remedy)}The sensitivities grow to "
            f"{largest:.3g} there, whose squares are out of the range of floats: the motion is "
            "unstable. Let `times` end earlier, or simulate without `sensitivities`.",
        )


def diagnosis_of(at: StateSamples, outputs: bool = False) -> str | None:
    """Describe the singularity at a state, or return None if it is of no known kind.

    With `outputs`, singularities of the outputs are searched too.
    """
    definition, model = at.definition, at.model
    for symbol, value in zip(definition.specifieds, at.r[0], strict=False):
        if not np.isfinite(value):
            return f"The specified `{symbol}` is {value} there."
    rates = at.interpret(_rates)["rates"][0]
    if np.isfinite(rates).all() and np.abs(rates).max(initial=0.0) > _LARGEST:
        fastest = int(np.abs(rates).argmax())
        return (
            f"The derivative of `{definition.states[fastest]}` is {rates[fastest]:.3g} there: "
            "squares of such numbers over `atol` are out of the range of floats. Choose units in "
            "which they are smaller, or raise `atol`."
        )
    equations = definition.equations
    massless = _speeds_without_mass(model.assembly, equations.speeds)
    if massless:
        return (
            f"The mass matrix has rows that are identically zero, of {describe(massless)}: no mass "
            "or inertia takes part in them, or it has cancelled. Check that velocities of points "
            "and angular velocities of frames hold these speeds, and that bodies have mass and "
            "inertia."
        )
    values = {name: part[0] for name, part in at.interpret(_parts).items()}
    rows = values["slopes"].reshape(len(equations.constraints.velocity), len(equations.speeds))
    return (
        _in_kinematics(at, values["kinematics"])
        or (_in_constraints(equations, rows, values["matrix"]) if len(rows) else None)
        or (None if len(rows) else _in_masses(at, values["matrix"]))
        or first_undefined(at, outputs)
    )


def _elsewhere(at: StateSamples, part: str, constants: np.ndarray) -> np.ndarray:
    """Return a part of the equations at a generic state."""
    x = np.random.default_rng(0).uniform(0.3, 1.3, at.x.shape)
    return np.asarray(replace(at, x=x, p=constants).interpret(_parts)[part][0])


def _in_kinematics(at: StateSamples, kinematics: np.ndarray) -> str | None:
    equations = at.definition.equations
    kinematics = kinematics.reshape(len(equations.coordinates), -1)
    wild = _wild(kinematics, _elsewhere(at, "kinematics", at.p).reshape(kinematics.shape))
    if not wild.any():
        return None
    names = [q for q, bad in zip(equations.coordinates, wild, strict=True) if bad]
    quantities = equations.constraints.residuals.implicit
    residuals = {} if quantities is None else quantities.residuals
    if implicit := [z for z in names if z in residuals]:
        return (
            f"The residuals of `implicit` cannot be solved for {describe(implicit)} there: their "
            f"derivatives by {describe(implicit)} are singular, as where two solutions meet. In "
            f"`{residuals[implicit[0]]}`, check whether the motion may come there, as to a centre "
            "of curvature."
        )
    return (
        f"The kinematic equations `kd_eqs` are singular there, as angles are in gimbal lock: "
        f"the derivatives of {describe(names)} divide by zero. Choose other angles, another "
        "order of rotations or a quaternion."
    )


def _in_constraints(equations: Equations, rows: np.ndarray, matrix: np.ndarray) -> str | None:
    if not np.isfinite(rows).all():
        return "The velocity constraints divide by zero there. Write them without the quotient."
    if not equations.dependents.speeds:
        return None
    cause = _bad_dependents(equations, rows)
    if not cause and not np.isfinite(matrix).all():
        return (
            "The mass matrix is not finite there, although the constraints can be solved for "
            "the dependent speeds: SymPy divides by a pivot that is zero. Pass "
            "`constraint_solver='CRAMER'` to KanesMethod in place of its default, 'LU', or "
            "name the dependent speeds in another order."
        )
    return cause


def _in_masses(at: StateSamples, matrix: np.ndarray) -> str | None:
    definition, p = at.definition, at.p
    generic = _elsewhere(at, "matrix", p)
    cause = _without_inertia(definition.equations.speeds, matrix, generic)
    if cause and _weightless(generic).size:
        for k in np.flatnonzero(p == 0.0):
            changed = p.copy()
            changed[k] = 1.0
            if not _weightless(_elsewhere(at, "matrix", changed)).size:
                name = definition.constants[k]
                return f"{cause} The cause is the constant `{name}`, which is zero."
    return cause


def _without_inertia(
    speeds: Sequence[TimeFunction], matrix: np.ndarray, generic: np.ndarray
) -> str | None:
    """Describe the speeds that can change without moving any inertia, or return None.

    The mass matrix at the state is compared with one at a generic state.
    """
    free = _weightless(matrix)
    if not free.size:
        return None
    change = f"{describe([speeds[k] for k in free])} can change{' together' * (free.size > 1)}"
    if _weightless(generic).size:
        return (
            f"The mass matrix is singular in every configuration: {change} so that no "
            "mass and no inertia moves, and nothing determines them. Give the bodies "
            "between them a mass or an inertia, leave out a coordinate, or add a constraint."
        )
    return (
        f"The mass matrix is singular in this configuration: {change} so that "
        "no mass and no inertia moves, as angles in gimbal lock can. Start elsewhere, choose other "
        "coordinates, or give the bodies between them a mass or an inertia."
    )


def _weightless(cells: np.ndarray) -> np.ndarray:
    """Return the indices of the speeds in a direction in which a mass matrix is zero."""
    n = int(np.sqrt(cells.size))
    matrix = cells.reshape(n, n)
    if not n or not np.isfinite(matrix).all():
        return np.empty(0, dtype=int)
    size = np.sqrt(np.maximum(np.diag(matrix), 0.0))
    size[size == 0.0] = 1.0
    least, directions = np.linalg.eigh(matrix / size[:, None] / size)
    if least[0] > DEPENDENT:
        return np.empty(0, dtype=int)
    direction = np.abs(directions[:, 0])
    return np.flatnonzero(direction > DIGITS * direction.max())


def _speeds_without_mass(assembly: Assembly, speeds: Sequence[TimeFunction]) -> list[TimeFunction]:
    """Return the speeds whose rows of the mass matrix are structurally zero."""
    n, cells = len(speeds), assembly.blocks.mass_matrix
    if len(cells) != n * n:
        return []
    zero = assembly.graph.zero
    return [u for k, u in enumerate(speeds) if all(c == zero for c in cells[k * n : k * n + n])]


def _parts(assembly: Assembly) -> dict[str, list[int]]:
    """Return the parts of the equations that are examined, as nodes."""
    graph, speeds = assembly.graph, assembly.speeds
    first = graph.args[speeds[0]][1]
    return {
        "kinematics": jacobian(graph, assembly.blocks.rates[:first], speeds).flat(),
        "slopes": jacobian(graph, assembly.blocks.velocity, speeds).flat(),
        "matrix": assembly.blocks.mass_matrix,
    }


def _rates(assembly: Assembly) -> dict[str, list[int]]:
    """Return the derivatives of the states, as nodes."""
    return {"rates": [*assembly.blocks.rates]}


def _wild(kinematics: np.ndarray, elsewhere: np.ndarray) -> np.ndarray:
    """Return a mask of the rows of N, in q' = N u, that are not finite or close to overflow."""
    sizes = np.abs(kinematics).max(axis=1, initial=0.0)
    usual = np.nan_to_num(np.abs(elsewhere)).max(axis=1, initial=0.0)
    wild: np.ndarray = ~np.isfinite(sizes) | ((sizes * DIGITS > usual) & (usual > 0.0))
    return wild


def _bad_dependents(equations: Equations, rows: np.ndarray) -> str | None:
    """Suggest other dependent speeds where the constraints cannot be solved for these."""
    speeds, chosen = equations.speeds, equations.dependents.speeds
    scaled = equilibrated(rows, exact=True)[0]
    sizes = np.linalg.svd(scaled[:, [speeds.index(u) for u in chosen]], compute_uv=False)
    if len(chosen) == len(rows) and sizes[-1] > DIGITS * sizes[0]:
        return None
    if np.linalg.svd(scaled, compute_uv=False)[-1] < DIGITS:
        return (
            "The velocity constraints are not independent there: the configuration is a singular "
            "one, or a constraint is redundant."
        )
    alternatives = [speeds[k] for k in sorted(independent_columns(scaled))]
    return (
        f"The velocity constraints cannot be solved there for the dependent speeds "
        f"{describe(chosen)}: their matrix is singular in this configuration. Choose others, such "
        f"as {describe(alternatives)}, as `u_dependent` of KanesMethod, with `q_dependent` to "
        "match."
    )


def warn_not_finite(out: np.ndarray, at: StateSamples, names: Sequence[str]) -> None:
    """Warn of named values (m, o, …) that are not finite although their inputs are."""
    sound = np.isfinite(at.t) & np.isfinite(at.x).all(axis=1) & np.isfinite(at.r).all(axis=1)
    wrong = ~np.isfinite(out.reshape(*out.shape[:2], -1)).all(axis=2)
    wrong &= (sound & np.isfinite(at.p).all())[:, None]

    def describe_state(k: int) -> tuple[str, str | None]:
        state = numbers_of(at.definition.states, at.x[k])
        return f"t = {float(at.t[k])!r} in the state {state}", diagnosis_of(
            at.subset([k]), outputs=True
        )

    _errors.warn_not_finite(wrong, names, describe_state)


def warn_of_outputs(trajectory: Trajectory, problem: Problem) -> None:
    """Warn of outputs along a motion that are not finite where its states are."""
    at = problem.at(trajectory.times, trajectory.states)
    warn_not_finite(trajectory.outputs, at, unique_names(trajectory.outputs_symbols))
