"""Poses along a trajectory, beside SymPy's own direction cosines and positions."""

from types import SimpleNamespace

import numpy as np
import pytest
import sympy as sm
from sympy.physics.mechanics import (
    Particle,
    Point,
    ReferenceFrame,
    RigidBody,
    dynamicsymbols,
    inertia,
)

from pydy.viz import Arrow, Line, Scene, Sphere, Visual
from pydy.viz.motion import Geometry, Names, pose_program

q = dynamicsymbols("q:6")
l, m = sm.symbols("l, m")


@pytest.fixture
def chain():
    """Frames and points that hang from each other, turned in every way SymPy knows."""
    N, O = ReferenceFrame("N"), Point("O")
    A = N.orientnew("A", "Body", q[:3], "zxy")
    B, C = ReferenceFrame("B"), ReferenceFrame("C")
    B.orient_axis(A, A.x + 2 * A.z, q[3])
    C.orient_quaternion(
        B, (sm.cos(q[4] / 2), sm.sin(q[4] / 2) * sm.Rational(3, 5), 0, sm.sin(q[4] / 2) * 4 / 5)
    )
    P = O.locatenew("P", q[5] * N.y + l * A.x)
    Q = P.locatenew("Q", l / 2 * B.y - q[5] ** 2 * C.z)
    return SimpleNamespace(N=N, O=O, A=A, B=B, C=C, P=P, Q=Q)


def test_poses_agree_with_sympy(chain):
    rng = np.random.default_rng(5)
    states = rng.uniform(-3, 3, (4, 6))
    scene = Scene(
        chain.N,
        chain.O,
        Visual(Sphere(0.1), chain.C, chain.Q),
        Visual(Sphere(0.1), chain.A, chain.P),
        Visual(Sphere(0.1), chain.O),
    ).animate(np.arange(4.0), states, symbols=q, constants={l: 0.7}, fps=None)
    assert scene.poses.shape == (4, 3, 4, 4)
    for k, row in enumerate(states):
        values = {**dict(zip(q, row, strict=True)), l: 0.7}
        for i, (frame, point) in enumerate(((chain.C, chain.Q), (chain.A, chain.P))):
            turn = np.array(chain.N.dcm(frame).xreplace(values).evalf(), dtype=float)
            place = point.pos_from(chain.O).to_matrix(chain.N).xreplace(values).evalf()
            assert scene.poses[k, i, :3, :3] == pytest.approx(turn, abs=1e-14)
            assert scene.poses[k, i, :3, 3] == pytest.approx(
                np.array(place, float)[:, 0], abs=1e-13
            )
    assert scene.poses[:, 2] == pytest.approx(np.broadcast_to(np.eye(4), (4, 4, 4)))


def test_all_poses_are_one_program_whose_work_grows_as_the_chain():
    counts = []
    for n in (10, 20):
        N, O = ReferenceFrame("N"), Point("O")
        angles = dynamicsymbols(f"a:{n}")
        frames, points, frame, point = [], [], N, O
        for k, angle in enumerate(angles):
            frame = frame.orientnew(f"F{k}", "Axis", (angle, frame.y if k % 2 else frame.z))
            point = point.locatenew(f"P{k}", frame.x)
            frames.append(frame)
            points.append(point)
        program = pose_program(Geometry(N, O, tuple(frames), tuple(points)), Names(tuple(angles)))
        counts.append(sum(program.operation_count["run"].values()))
    # Twelve multiplications and six additions turn a frame about an axis; a position adds three.
    assert counts[0] <= 10 * 25
    assert counts[1] - counts[0] <= 10 * 27


def test_a_frame_that_is_not_related_is_named_with_the_remedy(chain):
    lost = ReferenceFrame("lost")
    scene = Scene(chain.N, chain.O, Visual(Sphere(1), lost, chain.P))
    with pytest.raises(ValueError, match=r"`lost` is not related .* `N`. Orient it"):
        scene.animate([0.0], np.zeros((1, 6)), symbols=q, constants={l: 1})


def test_a_point_that_is_not_related_is_named_with_the_remedy(chain):
    scene = Scene(chain.N, chain.O, Visual(Sphere(1), Point("far")))
    with pytest.raises(ValueError, match=r"`far` is not related .* `O`. Give its position"):
        scene.animate([0.0], np.zeros((1, 6)), symbols=q, constants={l: 1})


def test_a_vector_in_a_frame_that_is_not_related_is_refused(chain):
    arrow = Visual(Arrow(ReferenceFrame("lost").x), chain.P)
    with pytest.raises(ValueError, match="frame `lost` is not related"):
        Scene(chain.N, chain.O, arrow).animate([0.0], np.zeros((1, 6)), symbols=q, constants={l: 1})


def test_an_unknown_constant_is_named_with_where_and_the_remedy(chain):
    scene = Scene(chain.N, chain.O, Visual(Sphere(1), chain.P))
    with pytest.raises(ValueError, match=r"position of point `P` holds `l`.*`constants`"):
        scene.animate([0.0], np.zeros((1, 6)), symbols=q)


def test_an_unknown_function_of_time_is_named_with_the_remedy(chain):
    scene = Scene(chain.N, chain.O, Visual(Sphere(1), chain.A, chain.O))
    with pytest.raises(ValueError, match=r"orientation of frame `A` in `N` holds `q2\(t\)`"):
        scene.animate([0.0], np.zeros((1, 2)), symbols=q[:2])


def test_an_unknown_derivative_is_named_with_the_remedy(chain):
    scene = Scene(chain.N, chain.O, Visual(Arrow(q[5].diff() * chain.N.x), chain.O))
    with pytest.raises(ValueError, match=r"Derivative\(q5.*Write it with the speeds"):
        scene.animate([0.0], np.zeros((1, 6)), symbols=q)


def test_an_unknown_symbol_in_a_series_is_named(chain):
    scene = Scene(chain.N, chain.O, Visual(Sphere(1), chain.O), series={"height": 3 * m})
    with pytest.raises(ValueError, match=r"The series `height` holds `m`"):
        scene.animate([0.0], np.zeros((1, 6)), symbols=q)


def test_a_pose_that_is_not_finite_is_named_with_its_time():
    N, O = ReferenceFrame("N"), Point("O")
    P = O.locatenew("P", N.x / q[0])
    with pytest.raises(ValueError, match="position of `P` is not finite at t = 1:"):
        Scene(N, O, Visual(Sphere(1), P)).animate([0, 1], [[1.0], [0.0]], symbols=q[:1])


def test_specifieds_and_time_move_things_too():
    N, O, t = ReferenceFrame("N"), Point("O"), dynamicsymbols._t
    P = O.locatenew("P", q[1] * N.x + t**2 * N.y)
    scene = Scene(N, O, Visual(Sphere(1), P), Visual(Arrow(q[2] * N.z), P))
    scene.animate([0, 1, 2], np.zeros((3, 1)), symbols=q[:1], specifieds={q[1]: [5, 6, 7], q[2]: 4})
    assert scene.poses[:, 0, :3, 3].tolist() == [[5, 0, 0], [6, 1, 0], [7, 4, 0]]


def test_bodies_give_their_own_frame_and_point():
    N, O = ReferenceFrame("N"), Point("O")
    B = N.orientnew("B", "Axis", (q[0], N.z))
    P = O.locatenew("P", 2 * B.x)
    body = RigidBody("body", P, B, 1, (inertia(B, 1, 1, 1), P))
    scene = Scene(N, O, Visual(Sphere(1), body), Visual(Sphere(1), Particle("bob", P, 1)))
    scene.animate([0.0], [[np.pi / 2]], symbols=q[:1])
    assert scene.poses[0, :, :3, 3] == pytest.approx(np.array([[0, 2, 0], [0, 2, 0]]), abs=1e-15)
    assert scene.poses[0, 0, 0, 1] == pytest.approx(-1)
    assert scene.poses[0, 1, :3, :3] == pytest.approx(np.eye(3))


def test_lines_follow_their_points(chain):
    line = Visual(Line([chain.O, chain.P]))
    scene = Scene(chain.N, chain.O, line)
    scene.animate([0.0], [[0, 0, 0, 0, 0, 2.0]], symbols=q, constants={l: 0.5})
    assert scene._animation.items[0].points[0] == pytest.approx(np.array([[0, 0, 0], [0.5, 2, 0]]))
