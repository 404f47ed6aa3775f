"""Frames and points as the user related them: bases of points, velocities of neighbours."""

import sympy.physics.mechanics as me

from pydy._mechanics.frame_tree import FrameTree, velocity_in
from zoo import by_hand, inertial_frame

T = me.dynamicsymbols._t


def test_a_velocity_whose_components_are_speeds_is_not_replaced_by_the_rate_of_its_place():
    model = by_hand.satellite()
    centre, tip = (body.masscenter for body in model.kane.bodies)
    ways = FrameTree(model.kane._inertial).paths([centre, tip], {})
    assert ways[centre] == (None, ())
    assert ways[tip][0] is centre


def test_velocities_along_a_chain_are_those_that_sympy_makes_up():
    q = me.dynamicsymbols("q:3")
    made = []
    for velocity in (velocity_in, lambda point, frame: point.vel(frame)):
        frame, origin = inertial_frame()
        arm = frame.orientnew("A", "Axis", (q[0], frame.z))
        one = origin.locatenew("one", q[1] * arm.x)
        two = one.locatenew("two", q[2] * frame.y)
        velocities = [velocity(point, frame) for point in (one, two)]
        made.append([v.to_matrix(frame) for v in velocities])
    assert made[0] == made[1]


def test_a_neighbour_that_moves_in_a_frame_of_its_own_tells_no_velocity():
    frame, origin = inertial_frame()
    stranger, elsewhere = me.Point("S"), me.ReferenceFrame("E")
    stranger.set_vel(frame, 7 * frame.x)
    point = me.Point("P")
    point.set_pos(stranger, elsewhere.x)
    point.set_pos(origin, 2 * me.dynamicsymbols._t * frame.x)
    assert velocity_in(point, frame) == 2 * frame.x
