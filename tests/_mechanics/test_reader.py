"""What bad input gets: an error that names the object and the remedy."""

import pytest
import sympy as sm
import sympy.physics.mechanics as me

from graphs import form
from pydy._mechanics.kane import multibody_of_kane
from pydy._mechanics.reader import check_bodies, read_loads
from pydy.system import System
from zoo import inertial_frame

T = me.dynamicsymbols._t


def formed(bodies, loads=None, frame=None):
    q, u = me.dynamicsymbols("q u")
    frame = me.ReferenceFrame("N") if frame is None else frame
    kane = me.KanesMethod(frame, [q], [u], kd_eqs=[q.diff(T) - u], bodies=bodies, forcelist=loads)
    return form(multibody_of_kane(kane), in_bodies=True, articulated=True)


def test_a_body_whose_mass_centre_moves_nobody_knows_how_is_named():
    body = me.Particle("p", me.Point("P"), sm.Symbol("m"))
    with pytest.raises(
        ValueError,
        match=r"The point P, the mass centre of the body p, has no velocity .* N.*set_vel\(N",
    ):
        formed([body])


def test_a_load_at_a_point_that_nothing_positions_is_named():
    frame, point, other = me.ReferenceFrame("N"), me.Point("P"), me.Point("Q")
    point.set_vel(frame, me.dynamicsymbols("u") * frame.x)
    with pytest.raises(ValueError, match=r"The point Q, which a load acts at, has no velocity"):
        formed([me.Particle("p", point, 1)], [(other, frame.x)], frame)


def test_a_frame_without_orientation_to_the_inertial_one_is_named():
    frame, own, point = me.ReferenceFrame("N"), me.ReferenceFrame("B"), me.Point("P")
    point.set_vel(frame, 0)
    body = me.RigidBody("b", point, own, 1, (me.inertia(own, 1, 2, 3), point))
    with pytest.raises(ValueError, match=r"The frame B has no orientation in .* N.*orient_axis"):
        formed([body], frame=frame)


def test_a_place_in_a_frame_without_orientation_is_named():
    frame, own, origin = me.ReferenceFrame("N"), me.ReferenceFrame("B"), me.Point("O")
    origin.set_vel(frame, 0)
    point = origin.locatenew("P", me.dynamicsymbols("q") * own.x)
    with pytest.raises(ValueError, match=r"The frame B has no orientation"):
        formed([me.Particle("p", point, 1)], frame=frame)


def test_a_load_that_is_none_is_refused():
    with pytest.raises(TypeError, match=r"load 3 is not one of the loads .* `to_loads\(\)`"):
        read_loads([3])


def test_a_load_on_something_else_than_a_point_or_a_frame_is_refused():
    frame = me.ReferenceFrame("N")
    with pytest.raises(ValueError, match=r"must begin with the Point .* got a Symbol"):
        read_loads([(sm.Symbol("P"), frame.x)])


def test_a_force_without_a_direction_is_refused():
    point, k = me.Point("P"), sm.Symbol("k")
    with pytest.raises(TypeError, match=r"load at P must be a Vector, such as .* got the Mul -k"):
        read_loads([(point, -k)])
    assert read_loads([(point, 0)]) == ()


def test_loads_come_out_of_actuators():
    frame, first, second = me.ReferenceFrame("N"), me.Point("P"), me.Point("Q")
    second.set_pos(first, me.dynamicsymbols("q") * frame.x)
    spring = me.LinearSpring(sm.Symbol("k"), me.LinearPathway(first, second))
    assert [where for where, _ in read_loads([spring])] == [first, second]


def test_a_body_that_is_none_is_refused():
    with pytest.raises(TypeError, match="must hold Particle and RigidBody objects, got 3 of type"):
        check_bodies([3])


def test_a_second_derivative_in_a_load_is_refused():
    frame, point = me.ReferenceFrame("N"), me.Point("P")
    point.set_vel(frame, me.dynamicsymbols("u") * frame.x)
    load = me.dynamicsymbols("q").diff(T, 2) * frame.x
    with pytest.raises(ValueError, match=r"only the first derivatives .* terms of the speeds"):
        formed([me.Particle("p", point, 1)], [(point, load)], frame)


def test_a_speed_that_moves_no_mass_is_named():
    frame, point, fixed = me.ReferenceFrame("N"), me.Point("P"), me.Point("O")
    point.set_vel(frame, me.dynamicsymbols("u") * frame.x)
    fixed.set_vel(frame, 0)
    bodies = [me.Particle("p", point, 0), me.Particle("q", fixed, 1)]
    with pytest.raises(ValueError, match=r"The speed `u\(t\)` moves no mass .* mass or an inertia"):
        formed(bodies, frame=frame)


def test_a_speed_of_the_same_name_with_other_assumptions_is_named():
    frame, point = me.ReferenceFrame("N"), me.Point("P")
    point.set_vel(frame, me.dynamicsymbols("u", real=True) * frame.x)
    with pytest.raises(ValueError, match=r"The speed `u\(t\)` .* another `u\(t\)`, with other"):
        formed([me.Particle("p", point, 1)], frame=frame)


def test_a_method_without_kinematic_equations_is_refused():
    frame, point = me.ReferenceFrame("N"), me.Point("P")
    q, u = me.dynamicsymbols("q u")
    point.set_vel(frame, u * frame.x)
    kane = me.KanesMethod(frame, [q], [u], bodies=[me.Particle("p", point, 1)])
    with pytest.raises(ValueError, match=r"no kinematic differential equations.*`kd_eqs=`"):
        System(kane)


def test_where_nothing_rests_the_point_that_may_rest_is_named():
    frame, origin = me.ReferenceFrame("N"), me.Point("O")
    hinge = origin.locatenew("H", me.dynamicsymbols("q") * frame.x)
    point = hinge.locatenew("P", frame.y)
    with pytest.raises(ValueError, match=r"point P.* no velocity .* If O.*`O\.set_vel\(N, 0\)`"):
        formed([me.Particle("p", point, 1)], frame=frame)


def test_a_load_that_is_not_a_number_is_named():
    frame, point = me.ReferenceFrame("N"), me.Point("P")
    with pytest.raises(ValueError, match=r"The load at P is NaN times a vector\."):
        read_loads([(point, sm.nan * frame.x)])


@pytest.mark.parametrize("equations", ["graph", "method"])
def test_an_inertia_that_is_not_symmetric_is_named(equations):
    frame, point = me.ReferenceFrame("N"), me.Point("P")
    q, u, m = *me.dynamicsymbols("q u"), sm.Symbol("m")
    axes = frame.orientnew("A", "Axis", (q, frame.x + frame.y))
    axes.set_ang_vel(frame, u * (frame.x + frame.y).normalize())
    point.set_vel(frame, 0)
    inertia = me.inertia(axes, m, 2, 3) + m * me.outer(axes.x, axes.y)
    body = me.RigidBody("plate", point, axes, m, (inertia, point))
    kane = me.KanesMethod(frame, [q], [u], kd_eqs=[q.diff(T) - u], bodies=[body])
    kane.kanes_equations([body])
    with pytest.raises(ValueError, match=r"body plate is not symmetric: it has m at \(A.x\|A.y\)"):
        System(kane, equations=equations)


def test_a_body_that_is_given_twice_is_named():
    q = me.dynamicsymbols("q")
    frame, origin = inertial_frame()
    point = origin.locatenew("P", q * frame.x)
    point.set_vel(frame, q.diff(T) * frame.x)
    body, other = (me.Particle("p", point, sm.Symbol("m")) for _ in range(2))
    with pytest.raises(ValueError, match="`bodies` has p more than once: its mass would count"):
        formed([body, body], frame=frame)
    assert check_bodies([body, other]) == (body, other)
