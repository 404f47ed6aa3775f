"""Products of vectors against those of SymPy."""

import sympy as sm
import sympy.physics.mechanics as me

from pydy.vehicles.vectors import cross, dot

q, w, v = me.dynamicsymbols("q w v")
N = me.ReferenceFrame("N")
A = N.orientnew("A", "Axis", (q, N.z))
B = A.orientnew("B", "Axis", (w, A.y))
FIRST = v * N.x + 2 * A.y - B.z
SECOND = N.z + sm.sin(q) * B.x + 3 * A.x


def test_products_are_the_same_expressions_as_those_of_sympy():
    for a, b in ((FIRST, SECOND), (SECOND, FIRST), (A.x, B.x), (FIRST, FIRST), (N.x, N.y)):
        assert dot(a, b) == a.dot(b)
        ours, theirs = cross(a, b), a.cross(b)
        assert (ours - theirs).to_matrix(N).applyfunc(sm.simplify) == sm.zeros(3, 1)
        assert {frame for _, frame in ours.args} == {frame for _, frame in theirs.args}


def test_products_with_the_zero_vector_are_zero():
    zero = me.Vector(0)
    assert dot(FIRST, zero) == dot(zero, FIRST) == 0
    assert cross(FIRST, zero) == cross(zero, FIRST) == zero
