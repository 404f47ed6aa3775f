"""Inertias that do not turn with their bodies are warned of if the equations depend on it."""

import pytest
import sympy as sm
import sympy.physics.mechanics as me

from pydy import System
from pydy.errors import PyDyUserWarning
from pydy.mechanics import Definition

q = me.dynamicsymbols("q1:4")
u = me.dynamicsymbols("u1:4")
a, b, c = sm.symbols("a b c")


def gimbals(axes, moments=(a, b, c), about=None, planar=False):
    """A plate B in a gimbal A, about the point where all axes meet; `axes` is N, A or B."""
    N, O = me.ReferenceFrame("N"), me.Point("O")
    O.set_vel(N, 0)
    A = N.orientnew("A", "Axis", (q[0], N.z))
    B = A.orientnew("B", "Axis", (q[1], A.z if planar else A.x))
    C = O.locatenew("C", about(B) if about else 0 * N.x)
    inertia = me.inertia({"N": N, "A": A, "B": B}[axes], *moments)
    plate = me.RigidBody("plate", O, B, 1, (inertia, C))
    return Definition(N, q[:2], u[:2], bodies=[plate])


@pytest.mark.parametrize("axes", ["N", "A"])
def test_axes_of_other_frames_are_told(axes):
    with pytest.warns(PyDyUserWarning, match=rf"plate changes .* B: .* axes of {axes} about"):
        System(gimbals(axes))


def test_axes_of_the_body_are_not_told():
    System(gimbals("B"))
    System(gimbals("B", about=lambda B: a * B.x + b * B.z))


def test_rotors_and_planar_motions_are_not_told():
    System(gimbals("A", (a, b, b)))
    System(gimbals("N", planar=True))
    System(gimbals("N", (0, 0, c), planar=True))


def test_components_that_change_are_the_users():
    System(gimbals("A", (q[1] ** 2 + a, b, c)))


def test_axes_that_a_prescribed_turn_alone_reveals_are_told():
    """The energy has Ω² (b sin² q1 + c cos² q1) / 2 if b and c turn with B, else c Ω² / 2."""
    N, O = me.ReferenceFrame("N"), me.Point("O")
    O.set_vel(N, 0)
    A = N.orientnew("A", "Axis", (sm.Symbol("Omega") * me.dynamicsymbols._t, N.z))
    B = A.orientnew("B", "Axis", (q[0], A.x))
    plate = me.RigidBody("plate", O, B, 1, (me.inertia(A, a, b, c), O))
    with pytest.warns(PyDyUserWarning, match="axes of A about O"):
        System(Definition(N, q[:1], u[:1], bodies=[plate]))


def test_a_point_of_another_body_is_told():
    """The central inertia is that about C minus the mass times the squares of distances to it."""
    N, O = me.ReferenceFrame("N"), me.Point("O")
    O.set_vel(N, 0)
    C = O.locatenew("C", a * N.x)
    B = N.orientnew("B", "Axis", (q[0], N.x))
    D = B.orientnew("D", "Axis", (q[1], B.y))
    plate = me.RigidBody("plate", O, D, 1, (me.inertia(D, b, b, c), C))
    with pytest.warns(PyDyUserWarning, match="axes of D about C, which do not all move"):
        System(Definition(N, q[:2], u[:2], bodies=[plate]))


def test_a_kanes_method_and_a_lagrangian_are_told():
    N, O = me.ReferenceFrame("N"), me.Point("O")
    O.set_vel(N, 0)
    A = N.orientnew("A", "Axis", (q[0], N.z))
    B = A.orientnew("B", "Axis", (q[1], A.x))
    plate = me.RigidBody("plate", O, B, 1, (me.inertia(N, a, b, c), O))
    method = me.LagrangesMethod(me.Lagrangian(N, plate), q[:2], bodies=[plate], frame=N)
    method.form_lagranges_equations()
    with pytest.warns(PyDyUserWarning, match="axes of N"):
        System(method)
    kane = me.KanesMethod(N, q[:2], u[:2], [x.diff() - y for x, y in zip(q[:2], u, strict=False)])
    kane.kanes_equations([plate], [])
    with pytest.warns(PyDyUserWarning, match="axes of N"):
        System(kane)
