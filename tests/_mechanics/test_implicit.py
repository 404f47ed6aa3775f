"""What `Implicit` takes, and what it says of the rest."""

import pytest
import sympy as sm
import sympy.physics.mechanics as me

from pydy import System
from pydy._graph.from_sympy import SymPyReader
from pydy._graph.identities import signatures
from pydy._graph.node import Graph
from pydy.mechanics import Definition, Implicit
from zoo import inertial_frame

X, V, Z, Y = me.dynamicsymbols("x, v, z, y")
K = sm.Symbol("k")


def free():
    frame, origin = inertial_frame()
    place = origin.locatenew("P", X * frame.x)
    return Definition(frame, [X], [V], bodies=[me.Particle("P", place, 1)])


def same(one, other):
    """Compare expressions wherever they are defined."""
    graph = Graph()
    read = SymPyReader.of_inputs(graph, "the expressions", x=[X, Z, Y, V], p=[K])
    first, second = signatures(graph, read.all([one, other]))
    return first == second


@pytest.mark.parametrize(
    ("residuals", "start", "message"),
    [
        ({}, None, "at least one function of time"),
        ({K: K - X}, None, r"functions of time as keys, .* got k"),
        ({Z: "z"}, None, r"`residuals\[z\(t\)\]` must be an expression that is zero, got 'z'"),
        ({Z: X}, None, r"`residuals\[z\(t\)\]`, `x\(t\)`, holds none of z\(t\)"),
        ({Z: Z - X}, {Y: 1.0}, r"`start` has the key `y\(t\)`, which is not one of the"),
        ({Z: Z - X}, {Z: 1.0, "z": 2.0}, r"`start` gives `z\(t\)` more than once"),
        ({Z: Z - X}, {Z: "a"}, r"`start\[z\(t\)\]` must be a real number"),
    ],
)
def test_arguments_are_checked(residuals, start, message):
    with pytest.raises((TypeError, ValueError), match=message):
        Implicit(residuals, start)


@pytest.mark.parametrize(
    ("residuals", "message"),
    [
        ({X: X - 1}, r"`implicit` gives x\(t\), which the system has as a coordinate or speed"),
        ({Z: Z - V.diff()}, r"The residual of `z\(t\)`, .*, holds Derivative\(v\(t\), t\): it may"),
        ({Z: Z - X.diff(), Y: Y - Z.diff()}, r"holds Derivative\(z\(t\), t\)"),
        ({Z: Z + Y - X, Y: 2 * Z + 2 * Y}, "`implicit` cannot be solved for"),
    ],
)
def test_residuals_fit_the_system(residuals, message):
    with pytest.raises(ValueError, match=message):
        System(free(), implicit=Implicit(residuals))


def test_unknowns_are_the_dependent_coordinates():
    system = System(free(), implicit=Implicit({Z: Z**3 + Z - X}))
    assert system.coordinates == [X, Z]
    assert system.speeds == [V]
    body = free().multibody_with(Implicit({Z: Z**3 + Z - X}))
    assert body.dependents.coordinates == (Z,)
    assert same(body.kinematics.coordinate_derivatives[1], V / (3 * Z**2 + 1))


def test_what_follows_one_by_one_is_solved_in_that_order():
    residuals = {Z: Z + Y + K * Y**2 - X, Y: Y + Y**3 - X}
    z, y = free().multibody_with(Implicit(residuals)).kinematics.coordinate_derivatives[1:]
    assert same(y, V / (3 * Y**2 + 1))
    assert same(z, V - y * (1 + 2 * K * Y))


def test_names_are_taken_in_start():
    assert Implicit({Z: Z - X}, {"z": 2}).start == {Z: 2.0}
    assert repr(Implicit({Z: Z - X})) == "<Implicit z(t)>"


@pytest.mark.parametrize(("configuration", "rank"), [(-5.0, 1), (5.0, 2)])
def test_a_configuration_takes_the_place_of_where_the_search_starts(configuration, rank):
    """Of z² = 25 and (z + 5) y = 0 the second holds by itself where z is -5."""
    x, y, z = me.dynamicsymbols("x y z")
    frame, origin = inertial_frame()
    point = origin.locatenew("P", x * frame.x + y * frame.y)
    made = Definition(
        frame,
        [x, y],
        bodies=[me.Particle("mass", point, 1)],
        loads=[(point, z * frame.x)],
        holonomic_constraints=[(z + 5) * y],
        configuration={z: configuration},
    )
    body = made.multibody_with(Implicit({z: z**2 - 25}, start={z: -configuration}))
    assert len(body.constraints.holonomic) == rank
