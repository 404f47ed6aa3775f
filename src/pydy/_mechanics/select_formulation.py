"""Equations of motion from a `Multibody`: selection of the formulation, classes of constraints.

The formulation is selected by operation count. Articulated bodies are cheapest for chains and
trees, composite bodies for few speeds and for springs in a row. Equations that a method derived are
replaced by those formed from its bodies if both have the same values at random consistent states
and the same symbols. The reason is logged.

The row space of the velocity constraints distinguishes nonholonomic constraints from rates of
holonomic ones: its dimension beyond that of these rates is the number of nonholonomic constraints.
It does not depend on the axes of a contact velocity, whose components may mix both kinds. Ranks are
taken at generic points of the configuration manifold: a user may have simplified a rate by the
constraint itself, so that it is valid only there.
"""

from __future__ import annotations

import logging
from dataclasses import replace

import numpy as np
import sympy as sm

from pydy._collector import collector_paused
from pydy._graph import (
    Graph,
    LinearSystem,
    inputs_of,
    jacobian,
    lower,
    operation_count,
    rounding_bounds,
    simplify,
)
from pydy._mechanics.auxiliary import with_auxiliary
from pydy._mechanics.constraints import (
    ConstraintEquations,
    ImplicitResiduals,
)
from pydy._mechanics.equation_graph import DynamicEquations, EquationGraph
from pydy._mechanics.equations import (
    AuxiliaryEquations,
    Equations,
    MassAndForcing,
    Mechanism,
)
from pydy._mechanics.formulations import forms, in_order_of_states, useful_axes
from pydy._mechanics.frame_tree import FrameTree
from pydy._mechanics.generic import (
    AROUND,
    Block,
    GenericStates,
    column_units,
    evaluator_of,
    row_units,
)
from pydy._mechanics.kinematic_constraints import RedundantConstraints
from pydy._mechanics.multibody import Multibody, independent_first
from pydy._mechanics.tuning import CANCELLED, NEARLY_DEPENDENT
from pydy._rank import HALF, is_zero

_LOG = logging.getLogger("pydy")


def kinematics_of(body: Multibody) -> Equations:
    """Return the kinematics and constraints alone, without equations of motion."""
    own = body.constraints
    multibody = body if body.bodies or body.lagrangian is not None else None
    residuals = ImplicitResiduals(own.implicit, own.holonomic, body.coordinates, body.speeds)
    constraints = ConstraintEquations(own.holonomic, own.velocity, residuals)
    if multibody is not None:
        velocity = tuple(map(body.kinematics.in_states, own.redundant.velocity))
        redundant = RedundantConstraints(own.redundant.holonomic, velocity)
        constraints = replace(constraints, redundant=redundant)
    return Equations(
        time=body.time,
        coordinates=body.coordinates,
        speeds=body.speeds,
        kinematics=body.kinematics,
        matrices=MassAndForcing(positive_definite=not body.dependents.speeds),
        constraints=constraints,
        dependents=body.dependents,
        auxiliary=AuxiliaryEquations(body.auxiliary),
        multibody=multibody,
    )


def equations_of(body: Multibody) -> Equations:
    """Return the equations of motion, formed on a graph."""
    base = kinematics_of(body)
    formed = chosen(body)
    energy = formed.energy(body.time, body.coordinates, body.speeds)
    mechanism = Mechanism(body.frame, body.bodies, body.loads, energy)
    equations = classify(replace(base, formed=formed, mechanism=mechanism))
    return with_auxiliary(equations) if body.auxiliary else equations


# -- the form -------------------------------------------------------------------------------------


@collector_paused()
def chosen(body: Multibody) -> EquationGraph:
    """Return the equations of motion in the formulation with the fewest operations.

    The axes are selected by estimates, articulated or composite bodies by compiled counts. Beyond a
    dozen speeds one set of axes is tried, and estimates decide. Specifieds that cancel are removed
    if rates of specifieds occur, which the kinematics may introduce. Dependent speeds are last
    while equations are formed, and in their original positions afterwards.
    """
    return in_order_of_states(_fewest(independent_first(body)), body)


def _fewest(body: Multibody) -> EquationGraph:
    # Compiled counts would take as long as everything else (twice the time for a tree of 29 joints,
    # four times for 20 links).
    is_large = len(body.speeds) > 12
    first, *other_axes = useful_axes(body)[-1:] if is_large else useful_axes(body)
    candidates = [forms(body, in_bodies=first)]
    differing = candidates[0].honoured
    unneeded = FrameTree(body.frame).located_beside_speeds(body.bodies)
    if differing or unneeded:
        from pydy._mechanics.set_velocities import warn_of_velocities

        warn_of_velocities(body, differing, unneeded)
    for in_bodies in other_axes if not candidates[0].in_one_frame else ():
        candidates.append(forms(body, in_bodies=in_bodies, honoured=candidates[0].honoured))
    kinds: list[EquationGraph] = [
        min(same, key=_estimated) for same in zip(*(c.equations for c in candidates), strict=True)
    ]
    if is_large or len(kinds) == 1:
        best = min(kinds, key=_estimated)
    else:
        best = min((replace(f, simplified=_simplified(f)) for f in kinds), key=_counted)
    rates = any(isinstance(s, sm.Derivative) for s in best.specifieds)
    return _without_cancelled(best) if rates else best


def _without_cancelled(formed: EquationGraph) -> EquationGraph:
    """Return the equations without specifieds that cancel, or unchanged.

    The rate of a prescribed direction occurs in the acceleration of a particle that moves along it,
    but does no work.
    """
    graph, before = formed.graph.copy(), formed.dynamics
    parts = [formed.rates, *before.matrix, before.forcing, before.start, before.residual_forcing]
    parts += [[*formed.measures], before.accelerations or []]
    nodes = iter(simplify(graph, [node for part in parts for node in part]))
    rates, *rows, measures, solved = [[next(nodes) for _ in part] for part in parts]
    matrix, (forcing, start, residual) = rows[:-3], rows[-3:]
    kinetic = simplify(graph, [formed.kinetic])
    accelerations = None if before.accelerations is None else solved
    reduced = replace(
        formed,
        graph=graph,
        rates=rates,
        dynamics=DynamicEquations(matrix, forcing, start, residual, accelerations),
        kinetic=kinetic[0],
        measures=tuple(measures),
    )
    removed = formed.inputs() - reduced.inputs()
    inputs = {*inputs_of(graph, kinetic).values()}
    return reduced if any(g == "r" and (g, k) not in inputs for g, k in removed) else formed


def _estimated(formed: EquationGraph) -> int:
    """Estimate the operations of q' and u' as they are before simplification."""
    graph, dynamics = formed.graph, formed.dynamics
    if dynamics.accelerations is not None:
        roots, solving = list(dynamics.accelerations), 0
        guards = [k for k in graph.reachable(roots) if graph.ops[k] == "guard"]
        if guards:
            roots = list(graph.args[guards[0]][4])
    else:
        system, column = LinearSystem(graph, dynamics.matrix, "ldl"), dynamics.residual_forcing
        system, column = system.in_differences(column) or (system, column)
        n = len(column)
        lower = [system.matrix[i][j] for i in range(n) for j in range(i + 1)]
        filled = sum(node != graph.zero for node in lower) - n
        # The cost of LDLᵀ with so many entries; its structure saves half of it.
        solving = filled * (filled // n + 9) // 3
        roots = [*lower, *column]
    return operation_count(graph, [*formed.rates, *dynamics.start, *roots]) + solving


def _counted(formed: EquationGraph) -> int:
    """Count the operations of q' and u' as they are compiled."""
    assert formed.simplified is not None
    graph, nodes = formed.simplified
    sizes = (len(nodes), len(formed.specifieds), len(formed.constants))
    program = lower(graph.copy(), sizes, [("rates", (len(nodes),), nodes)])
    return sum(program.operation_count["run"].values())


def _simplified(formed: EquationGraph) -> tuple[Graph, list[int]]:
    """Simplify q' and u' in a graph of their own."""
    graph = formed.graph.copy()
    solved = formed.dynamics.solution(graph, "ldl")
    return graph, simplify(graph, [*formed.rates, *solved])


# -- a method's own equations ---------------------------------------------------------------------


@collector_paused()
def formed_alike(equations: Equations, body: Multibody) -> EquationGraph | None:
    """Return the equations formed from bodies, or None to use those of the method."""
    why = _unfit(equations, body)
    if not why:
        try:
            formed = chosen(body)
        except (ValueError, TypeError, NotImplementedError) as error:
            why = str(error)
        else:
            symbols = set(formed.symbols(equations.kinematics.speed_rates))
            if additional := [s for s in symbols if s not in equations.symbols]:
                why = f"they hold {additional[0]}, which the method's do not"
            elif not _agree(equations, formed):
                why = "they give other numbers: a velocity or a load differs"
    if not why:
        return formed
    _LOG.info("The equations of the method are used, not those formed from its bodies: %s.", why)
    return None


def _unfit(equations: Equations, body: Multibody) -> str:
    if not body.bodies:
        return "it holds no bodies"
    if any(rate in equations.symbols for rate in equations.kinematics.speed_rates):
        return "loads depend on accelerations"
    return ""


def _agree(equations: Equations, formed: EquationGraph) -> bool:
    """Return whether both have the same accelerations.

    With the u' of one, M u' − F of the other must vanish: comparing u' would be less accurate if M
    is nearly singular.
    """
    n = len(equations.speeds)
    written = [*equations.matrices.mass_matrix, *equations.matrices.forcing]
    symbols = [*formed.constants, *formed.specifieds]
    states = GenericStates(equations, [*written, *symbols], "the equations of motion")
    inputs = states.consistent(2)
    block = "equations", (n * (n + 1),), states.read.all(written)
    theirs = evaluator_of(states.graph, [block])(*inputs)["equations"]
    numbers = states.by_symbol(inputs)
    inputs_ = formed.input_symbols(equations.time, (*equations.coordinates, *equations.speeds))
    nodes = [*(e for row in formed.dynamics.matrix for e in row), *formed.dynamics.forcing]
    values_at = formed.graph.evaluator(nodes)
    ours = values_at({node: numbers[symbol] for node, symbol in inputs_.items()}, 2)
    finite = np.isfinite(theirs).all(axis=1) & np.isfinite(ours).all(axis=1)
    fit = states.closed(inputs, finite)
    pairs = zip(theirs[fit], ours[fit], strict=True)
    return bool(fit.any()) and all(_alike(*pair, n) for pair in pairs)


def _alike(written: np.ndarray, formed: np.ndarray, n: int) -> bool:
    matrix, forcing = written[: n * n].reshape(n, n), written[n * n :]
    try:
        rates = np.linalg.solve(formed[: n * n].reshape(n, n), formed[n * n :])
    except np.linalg.LinAlgError:
        return False
    size = _magnitudes(matrix) @ np.abs(rates) + np.abs(forcing)
    return bool((np.abs(matrix @ rates - forcing) <= HALF * size + np.finfo(float).tiny).all())


def _magnitudes(matrix: np.ndarray) -> np.ndarray:
    """Return the magnitudes of entries, with a lower bound for remainders of cancelling terms.

    Rows and columns are equilibrated to make the bound independent of units.
    """
    sizes = np.abs(matrix)
    scaled, scale = sizes, np.ones(matrix.shape)
    for axis in (0, 1, 0, 1):
        most = np.sqrt(scaled.max(axis=axis, keepdims=True))
        most[most == 0.0] = 1.0
        scaled, scale = scaled / most, scale * most
    sizes_: np.ndarray = np.maximum(sizes, CANCELLED * scale)
    return sizes_


# -- constraints -----------------------------------------------------------------------------------


def classify(equations: Equations) -> Equations:
    """Return the equations with their constraints classified."""
    return replace(equations, constraints=_classified(equations))


def _classified(equations: Equations) -> ConstraintEquations:
    """Return the constraints with nonholonomic, implied and undifferentiated ones identified."""
    constraints = equations.constraints
    redundant = constraints.redundant.velocity
    constraints = replace(constraints, implied_velocity=redundant)
    if not constraints.holonomic:
        return replace(constraints, nonholonomic=constraints.velocity)
    states = GenericStates(equations, redundant, "the constraints")
    moving, rates = (list(nodes) for nodes in zip(*states.moving, strict=True))
    blocks = [
        states.table("gradient", states.holonomic, moving),
        _rows(states, "kinematics", rates),
        _rows(states, "motion", states.velocity),
        _rows(states, "redundant", states.read.all(redundant)),
    ]
    cells = blocks[2][2]
    blocks.append(("terms", blocks[2][1], rounding_bounds(states.graph, cells)))
    values = _clearest(states, blocks)
    if values is None:  # nothing can be evaluated
        return replace(constraints, nonholonomic=constraints.velocity)
    rows, motion = values["gradient"] @ values["kinematics"], values["motion"]
    terms = np.abs(values["gradient"]) @ np.abs(values["kinematics"])
    sizes = np.linalg.norm(terms, axis=1)
    # What cancels is no row: the rate of a quaternion's norm.
    rows[np.linalg.norm(rows, axis=1) <= HALF * sizes] = 0.0
    motion_space = _Space(len(motion), motion.shape[1])
    for row in motion:
        motion_space.extend(row)
    unexplained = [bool(motion_space.outside(row).any()) for row in rows]
    implied = tuple(k for k, row in enumerate(rows) if row.any() and not unexplained[k])
    residuals = constraints.residuals.rows  # which are solved
    undifferentiated = tuple(
        k for k, is_unexplained in enumerate(unexplained) if is_unexplained and k not in residuals
    )
    chosen = _completing(rows, motion)
    # What was redundant may be the rate of a holonomic constraint, which stands for itself now, and
    # what was kept may be what is redundant beside it.
    dropped = [k for k in range(len(motion)) if redundant and k not in chosen]
    pool = [*zip(redundant, values["redundant"], strict=True)]
    pool += [(constraints.velocity[k], motion[k]) for k in dropped]
    implied_rows = rows[list(implied)]
    alike = [
        max((_likeness(row, candidate) for row in implied_rows), default=0) for _, candidate in pool
    ]
    implied_velocity = sorted(sorted(range(len(pool)), key=alike.__getitem__)[: len(redundant)])
    return replace(
        constraints,
        nonholonomic=tuple(constraints.velocity[k] for k in chosen),
        implied_holonomic=implied,
        undifferentiated_holonomic=undifferentiated,
        implied_velocity=tuple(pool[k][0] for k in implied_velocity),
    )


def _clearest(states: GenericStates, blocks: list[Block]) -> dict[str, np.ndarray] | None:
    """Return the values at the sample farthest from singular positions; None if there is none.

    If all samples are nearly singular, start angles from all around the circle.
    """
    every: list[dict[str, np.ndarray]] = []
    for trials, around in ((3, False), (AROUND, True)):
        every += states.samples(blocks, trials, around=around)
        if not every:
            continue
        motion, terms = (np.array([s[name] for s in every]) for name in ("motion", "terms"))
        if not motion.shape[1]:
            return every[0]
        motion[is_zero(motion, terms)] = 0.0
        scaled = motion * column_units(motion) / row_units(motion)[:, None]
        least = np.linalg.svd(scaled, compute_uv=False)[:, -1]
        if least.max() > NEARLY_DEPENDENT[1]:
            break
    return every[int(least.argmax())] if every else None


def _likeness(row: np.ndarray, reference: np.ndarray) -> int:
    """Return 2 for equal rows, 1 for parallel ones, as all are with one speed, 0 otherwise."""
    if np.linalg.norm(row - reference) <= HALF * np.linalg.norm(row):
        return 2
    return int(not _completing(row[None], reference[None]))


def _completing(rates: np.ndarray, motion: np.ndarray) -> list[int]:
    """Return the motion rows that extend the row space of the rates, in order."""
    space = _Space(len(rates) + len(motion), motion.shape[1])
    for row in rates:
        space.extend(row)
    return [k for k, row in enumerate(motion) if space.extend(row)]


class _Space:
    """A row space, with an orthonormal basis."""

    def __init__(self, most: int, width: int) -> None:
        self._basis, self._count = np.zeros((most, width)), 0

    def outside(self, row: np.ndarray) -> np.ndarray:
        """Return the component of a normalised row outside the space, or zero."""
        basis, size = self._basis[: self._count], np.linalg.norm(row)
        residual = row / size if size else row
        for _ in range(2):  # the second orthogonalization removes the rounding of the first
            residual = residual - (basis @ residual) @ basis
        return np.where(np.linalg.norm(residual) > HALF, residual, 0.0)

    def extend(self, row: np.ndarray) -> bool:
        """Add a row to the space; return whether it was not in it."""
        residual = self.outside(row)
        if residual.any():
            self._basis[self._count] = residual / np.linalg.norm(residual)
            self._count += 1
        return bool(residual.any())


def _rows(states: GenericStates, name: str, nodes: list[int]) -> Block:
    """Split linear equations in the speeds into coefficients and constant terms."""
    g, speeds = states.graph, states.speeds
    cells: list[int] = []
    rows = jacobian(g, nodes, speeds).dense()
    for node, slope in zip(nodes, rows, strict=True):
        terms = [(g.mul(c, s), -1.0) for c, s in zip(slope, speeds, strict=True)]
        cells += [*slope, g.sum([(node, 1.0), *terms])]
    return name, (len(nodes), len(speeds) + 1), cells
