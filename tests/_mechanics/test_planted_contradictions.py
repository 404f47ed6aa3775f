"""Random trees and loops with one planted contradiction, which is told if it changes motions."""

import random
import warnings
from itertools import count

import numpy as np
import pytest
import sympy as sm
import sympy.physics.mechanics as me

from pydy import System
from pydy.errors import PyDyUserWarning

KINDS = ["base", "sign", "term", "axis", "inertia", "acceleration"]
m, g, span = sm.symbols("m g span")


def altered(kind, velocity, base, choose):
    """Return a velocity that lacks the base's, or a term, or has one component's sign changed."""
    if kind == "base":
        return velocity - base if base else velocity / 2
    components, frame = choose.choice(velocity.args)
    axes = [(n, e) for n, e in zip(components, (frame.x, frame.y, frame.z), strict=True) if n != 0]
    size, axis = choose.choice(axes)
    if kind == "sign":
        return velocity - 2 * size * axis
    return velocity - choose.choice(sm.Add.make_args(sm.expand(size))) * axis


def mechanism(seed, kind=None):
    """Return a KanesMethod of two or three bodies on joints, some of which close a loop."""
    draw, choose = random.Random(seed), random.Random(seed + 1000)
    bodies_count = draw.choice([2, 3])
    closed = bodies_count == 3 and draw.random() < 0.4
    planar = closed or draw.random() < 0.3
    wrong = draw.randrange(bodies_count)
    N, O = me.ReferenceFrame("N"), me.Point("O")
    O.set_vel(N, 0)
    q, u, numbers = [], [], count(1)

    def degree_of_freedom():
        k = next(numbers)
        q.append(me.dynamicsymbols(f"q{k}"))
        u.append(me.dynamicsymbols(f"u{k}"))
        return q[-1], u[-1]

    frame, point, bodies, loads = N, O, [], []
    for i in range(bodies_count):
        is_wrong = i == wrong
        axes = [frame.x, frame.y, frame.z]
        axis = frame.z if planar else draw.choice(axes)
        angle, speed = degree_of_freedom()
        A = frame.orientnew(f"A{i}", "Axis", (angle, axis))
        spin = speed * axis
        if kind == "axis" and is_wrong:
            spin = 2 * spin if planar else speed * choose.choice([a for a in axes if a != axis])
        A.set_ang_vel(frame, spin)
        length, height, width = sm.symbols(f"l{i} h{i} e{i}")
        offset = length * draw.choice([A.x, A.y]) + (0 if planar else height * A.z)
        half = offset / 2 + draw.choice([0, 1]) * width * A.y
        slides = not closed and draw.random() < 0.3
        if slides:
            travel, rate = degree_of_freedom()
            G = point.locatenew(f"G{i}", half + travel * A.x)
            G.set_vel(A, rate * A.x)
            point.set_vel(A, 0)
            G.v1pt_theory(point, N, A)
        else:
            G = point.locatenew(f"G{i}", half)
            G.v2pt_theory(point, N, A)
        if kind in ("base", "sign", "term") and is_wrong:
            base = None if point is O else point.vel(N)
            G.set_vel(N, altered(kind, G.vel(N), base, choose))
        end = point.locatenew(f"E{i}", offset)
        end.v2pt_theory(point, N, A)
        if kind == "acceleration" and not slides:
            G.a2pt_theory(point, N, frame if is_wrong else A)
        along = frame if kind == "inertia" and is_wrong else A
        inertia = me.inertia(along, *sm.symbols(f"I{i}_:3"))
        bodies.append(me.RigidBody(f"B{i}", G, A, m, (inertia, G)))
        loads.append((G, -m * g * N.y))
        frame, point = A, end
    rates = {a.diff(): b for a, b in zip(q, u, strict=True)}
    kinematic = [a - b for a, b in rates.items()]
    if closed:
        loop = point.pos_from(O) - span * N.x
        holonomic = [loop.dot(N.x), loop.dot(N.y)]
        kane = me.KanesMethod(
            N,
            q[:1],
            u[:1],
            kinematic,
            q_dependent=q[1:],
            configuration_constraints=holonomic,
            u_dependent=u[1:],
            velocity_constraints=[c.diff(me.dynamicsymbols._t).xreplace(rates) for c in holonomic],
        )
    else:
        kane = me.KanesMethod(N, q, u, kinematic)
    kane.kanes_equations(bodies, loads)
    return kane


def derivatives(kane, seed):
    """Return the derivatives of a random state, by name, and whether a warning came before."""
    with warnings.catch_warnings(record=True) as caught:
        warnings.simplefilter("always", PyDyUserWarning)
        system = System(kane)
    told = any(issubclass(w.category, PyDyUserWarning) for w in caught)
    draw = random.Random(seed)
    symbols = sorted(system.constants_symbols, key=str)
    system.constants = {s: draw.uniform(0.5, 1.5) for s in symbols}
    values = {str(s): draw.uniform(0.2, 1.0) for s in sorted(system.states, key=str)}
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")  # a loop is not closed there
        x = system.evaluate_ode(np.array([values[str(s)] for s in system.states]), 0.0)
    return dict(zip(map(str, system.states), x, strict=True)), told


@pytest.mark.parametrize("seed", range(8))
def test_a_planted_contradiction_is_told_if_it_changes_motions(seed):
    right, told = derivatives(mechanism(seed), seed)
    assert not told
    for kind in KINDS:
        try:
            found, told = derivatives(mechanism(seed, kind), seed)
        except ValueError:  # a speed that moves no mass is refused
            continue
        same = all(np.isclose(found[name], right[name], rtol=1e-9) for name in right)
        assert told or same, kind
