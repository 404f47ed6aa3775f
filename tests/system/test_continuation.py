"""Branches of equilibria, against closed forms."""

from types import SimpleNamespace

import numpy as np
import pytest
import sympy as sm
import sympy.physics.mechanics as me

import pydy.analysis.continuation
from pydy import System
from pydy.errors import AnalysisInterrupted, EquilibriumError, PyDyUserWarning
from pydy.mechanics import Definition
from pydy.models import multi_mass_spring_damper, n_link_pendulum_on_cart
from zoo import inertial_frame
from zoo.hoop import bead_on_a_hoop
from zoo.ziegler import zieglers_pendulum


def in_a_potential(force):
    """A damped unit mass under a force of x and p."""
    x, v = me.dynamicsymbols("x v")
    p = sm.Symbol("p")
    N, P, O = me.ReferenceFrame("N"), me.Point("P"), me.Point("O")
    O.set_vel(N, 0)
    P.set_vel(N, v * N.x)
    kane = me.KanesMethod(N, [x], [v], [x.diff() - v])
    kane.kanes_equations([me.Particle("b", P, sm.Integer(1))], [(P, (force(x, p) - v) * N.x)])
    return System(kane)


def test_a_branch_goes_around_its_folds():
    """x³ − x = p folds at x = ±1/√3, where p = ∓2/(3√3)."""
    system = in_a_potential(lambda x, p: p - x**3 + x)
    system.initial_conditions = {"x": -2.0}
    branch = system.follow_equilibria({"p": [-3.0, 3.0]})
    assert branch.ended == "bounds"
    assert [point.kind for point in branch.special] == ["fold", "fold"]
    first, second = branch.special
    assert first.value == pytest.approx(2.0 / (3.0 * np.sqrt(3.0)), rel=1e-10)
    assert second.value == pytest.approx(-2.0 / (3.0 * np.sqrt(3.0)), rel=1e-10)
    assert first.values["x"] == pytest.approx(-1.0 / np.sqrt(3.0), abs=1e-6)
    x = branch["x"]
    np.testing.assert_allclose(x**3 - x, branch.values, atol=1e-10)
    np.testing.assert_array_equal(branch.stable, 3.0 * x**2 > 1.0)
    assert (branch.values[0], branch.values[-1]) == (-3.0, 3.0)


@pytest.mark.parametrize("end", [1.0, 2.0, 10.0])
def test_steps_follow_the_sizes_of_the_unknowns(end):
    """x³ − p x = 0.1 grows from x = 0.05 to √p: the steps once stayed those of its start."""
    system = in_a_potential(lambda x, p: p * x - x**3 + sm.Rational(1, 10))
    system.initial_conditions = {"x": 0.05}
    branch = system.follow_equilibria({"p": [-2.0, end]})
    assert branch.ended == "bounds"
    roots = np.roots([1.0, 0.0, -end, -0.1])
    assert branch["x"][-1] == pytest.approx(roots.real.max(), rel=1e-9)
    with pytest.warns(PyDyUserWarning, match=r"within its range: it has `most` = 9 points"):
        assert system.follow_equilibria({"p": [-2.0, end]}, most=9).ended == "steps"


@pytest.mark.parametrize("sign", [1.0, -1.0])
def test_a_branch_may_begin_at_its_fold(sign):
    """p = x² has a fold at x = 0, where the branch leaves in the direction that is not stiff."""
    system = in_a_potential(lambda x, p: sign * p - x**2)
    branch = system.follow_equilibria({"p": [0.0, sign]})
    assert branch.ended == "bounds"
    assert len(branch.values) > 5
    np.testing.assert_allclose(branch["x"] ** 2, sign * branch.values, atol=1e-10)
    assert branch.values[-1] == sign
    np.testing.assert_array_equal(branch["p"], branch.values)


@pytest.mark.parametrize(("metre", "second"), [(1.0, 1.0), (1e6, 1e5), (1e-3, 1e-9)])
def test_folds_are_found_in_any_units(metre, second):
    """A micromachined beam that snaps through: in SI units its fold was stepped over."""
    system = in_a_potential(lambda x, p: p - x**3 + x)
    system.initial_conditions = {"x": -2.0}
    own = system.follow_equilibria({"p": [-3.0, 3.0]})
    scale = metre / second**2
    v = me.dynamicsymbols("v")
    system = in_a_potential(
        lambda x, p: p + (-((x / metre) ** 3) + x / metre - v * second / metre) * scale + v
    )
    system.initial_conditions = {"x": -2.0 * metre}
    branch = system.follow_equilibria({"p": [-3.0 * scale, 3.0 * scale]})
    assert [point.kind for point in branch.special] == ["fold", "fold"]
    np.testing.assert_allclose(branch.values / scale, own.values, rtol=0.0, atol=1e-9)
    np.testing.assert_allclose(branch["x"] / metre, own["x"], rtol=0.0, atol=1e-9)
    np.testing.assert_array_equal(branch.stable, own.stable)


def test_a_bead_on_a_hoop_meets_a_branch_point_at_the_critical_rate():
    system, _, turn = bead_on_a_hoop()
    branch = system.follow_equilibria({turn: [1.0, 8.0]})
    (point,) = branch.special
    assert point.kind == "branch point"
    assert point.value == pytest.approx(np.sqrt(9.81 / 0.5), rel=1e-9)
    np.testing.assert_allclose(branch["theta"], 0.0, atol=1e-9)
    np.testing.assert_array_equal(branch.stable, branch.values < point.value)


def test_the_bent_branch_is_followed_from_above():
    system, angle, turn = bead_on_a_hoop()
    system.initial_conditions = {angle: 1.3}
    branch = system.follow_equilibria({turn: [9.0, 4.5]})
    np.testing.assert_allclose(np.cos(branch["theta"]), 9.81 / (0.5 * branch.values**2), rtol=1e-9)
    assert branch.stable.all()


def test_where_damping_turns_negative_an_oscillation_begins():
    system = multi_mass_spring_damper()
    system.constants = {"m0": 2.0, "k0": 8.0}
    (point,) = system.follow_equilibria({"c0": [1.0, -0.7]}).special
    assert point.kind == "Hopf"
    assert point.value == pytest.approx(0.0, abs=1e-9)
    assert point.frequency == pytest.approx(2.0, rel=1e-9)


@pytest.mark.parametrize(
    ("damping", "force", "accuracy"),
    [
        (0.0, 3.5 - np.sqrt(2.0), 1e-12),
        (1e-3, 41.0 / 28.0 + 1e-6 / 2.0, 1e-9),
        (0.3, 41.0 / 28.0 + 0.09 / 2.0, 1e-12),
    ],
)
def test_zieglers_pendulum_flutters_at_the_published_force(damping, force, accuracy):
    (point,) = zieglers_pendulum(damping).follow_equilibria({"P": [0.0, 2.5]}).special
    assert point.kind == "Hopf"
    assert point.value == pytest.approx(force, rel=accuracy)


def test_an_oscillation_begins_beside_one_that_is_not_damped():
    x, y, u, v = me.dynamicsymbols("x y u v")
    c = sm.Symbol("c")
    N, O = inertial_frame()
    P = O.locatenew("P", x * N.x + y * N.y)
    loads = [(P, -(4 * x + c * u) * N.x - 9 * y * N.y)]
    system = System(Definition(N, [x, y], [u, v], bodies=[me.Particle("p", P, 1)], loads=loads))
    (point,) = system.follow_equilibria({"c": [1.0, -0.7]}).special
    assert point.value == pytest.approx(0.0, abs=1e-12)
    assert point.frequency == pytest.approx(2.0, rel=1e-9)


def test_what_is_free_is_held():
    system = n_link_pendulum_on_cart(1)
    system.initial_conditions = {"q0": 0.3, "q1": 3.0}
    branch = system.follow_equilibria({"m1": [1.0, 2.0]}, step=0.2)
    np.testing.assert_allclose(branch["q0"], 0.3, atol=1e-9)
    np.testing.assert_allclose(branch["q1"], np.pi, atol=1e-9)


def test_branches_go_into_xarray_and_pictures():
    import matplotlib.pyplot as plt

    system, angle, turn = bead_on_a_hoop()
    branch = system.follow_equilibria({turn: [1.0, 8.0]}, step=0.1)
    assert branch.to_xarray()["theta"].dims == ("point",)
    ax = branch.plot("theta")
    assert (ax.get_xlabel(), ax.get_ylabel()) == (r"$\Omega$", r"$\theta$")
    ax = branch.plot("theta", units={angle: ("deg", 180 / np.pi), "Omega": "rad/s"})
    assert (ax.get_xlabel(), ax.get_ylabel()) == (r"$\Omega$ (rad/s)", r"$\theta$ (deg)")
    assert ax.lines[0].get_ydata()[0] == branch["theta"][0] * 180 / np.pi
    with pytest.raises(ValueError, match="a label for values that are in radians"):
        branch.plot("theta", units={"theta": "deg"})
    system.initial_conditions = {angle: 1.0}
    raised = system.follow_equilibria({turn: [8.0, 1.0]})
    np.testing.assert_allclose(
        np.abs(raised[angle]),
        np.arccos(np.minimum(9.81 / (0.5 * raised[turn] ** 2), 1.0)),
        atol=1e-6,
    )
    labels = [text.get_text() for text in raised.plot(angle).texts]
    assert labels == ["fold, branch point"]
    plt.close("all")
    assert str(branch).startswith(
        f"{len(branch.values)} equilibria, Omega from 1 to 8: branch point"
    )
    with pytest.raises(KeyError, match="`bogus` is not one of the unknowns"):
        branch["bogus"]


def test_what_does_not_fit_is_named():
    system = multi_mass_spring_damper()
    with pytest.raises(ValueError, match="`most` must be"):
        system.follow_equilibria({"c0": [1.0, 2.0]}, most=1)
    with pytest.raises(ValueError, match="`step`"):
        system.follow_equilibria({"c0": [1.0, 2.0]}, step="short")
    with pytest.raises(EquilibriumError, match="No equilibrium was found"):
        in_a_potential(lambda x, p: p + x**2 + 1).follow_equilibria({"p": [0.0, 1.0]})


@pytest.mark.parametrize("stop", [KeyboardInterrupt, MemoryError])
def test_what_stops_a_branch_hands_over_what_there_is(monkeypatch, stop):
    system = in_a_potential(lambda x, p: p - x**3 + x)
    system.initial_conditions = {"x": -2.0}
    whole = system.follow_equilibria({"p": [-3.0, 3.0]})
    points = []
    point = pydy.analysis.continuation._BranchCurve.point

    def interrupted(self, z, before):
        points.append(z)
        if len(points) > 120:  # beyond the first fold, which is bisected
            raise stop
        return point(self, z, before)

    monkeypatch.setattr(pydy.analysis.continuation._BranchCurve, "point", interrupted)
    told = MemoryError if stop is MemoryError else AnalysisInterrupted
    with pytest.raises(told) as caught:
        system.follow_equilibria({"p": [-3.0, 3.0]})
    assert isinstance(caught.value, Exception) == (stop is MemoryError)
    assert "equilibria" in str(caught.value) + "".join(getattr(caught.value, "__notes__", []))
    branch = caught.value.results
    assert branch.ended == "interrupted"
    count = len(branch.values)
    assert 10 < count < len(whole.values)
    np.testing.assert_array_equal(branch.states, whole.states[:count])
    np.testing.assert_array_equal(branch.stable, whole.stable[:count])
    assert branch.special == tuple(p for p in whole.special if p.place < count - 1)
    assert branch.special


def test_a_bar_counts_points(capsys):
    branch = multi_mass_spring_damper().follow_equilibria({"c0": [1.0, 0.5]}, progress=True)
    shown = capsys.readouterr().err
    assert f"{len(branch.values) - 2} points" in shown  # but for the first and the last
    assert "c0=" in shown


@pytest.mark.parametrize(("metre", "second"), [(1.0, 1.0), (1e6, 1e-6), (1e-9, 1e-12)])
def test_rounding_across_a_plane_of_symmetry_does_not_end_a_branch(metre, second):
    """Two springs from (±1, 0) to a particle, which is loaded along y: the truss of von Mises.

    Nothing on the branch tells the size of x. With s the length of a spring, the load is
    2 k (L/s − 1) y; at the fold s³ = L.
    """
    x, y = me.dynamicsymbols("x y")
    force = sm.Symbol("F")
    frame, origin = inertial_frame()
    place = origin.locatenew("P", x * frame.x + y * frame.y)
    stiffness, free = 10.0 / second**2, 1.25 * metre
    loads = [(place, -force * frame.y - 0.3 / second * place.vel(frame))]
    for side in (-metre, metre):
        hook = origin.locatenew("H", side * frame.x)
        hook.set_vel(frame, 0)
        loads += me.LinearSpring(stiffness, me.LinearPathway(place, hook), free).to_loads()
    system = System(
        Definition(frame, [x, y], bodies=[me.Particle("P", place, 1)], loads=loads),
        initial_conditions={y: 0.9 * metre},
    )
    unit = metre / second**2
    branch = system.follow_equilibria({force: [-2.0 * unit, 2.0 * unit]})
    length = 1.25 ** (1 / 3)
    most = 20.0 * (1.25 / length - 1.0) * np.sqrt(length**2 - 1.0)
    assert branch.ended == "bounds"
    assert [point.kind for point in branch.special] == ["fold", "fold"]
    found = [point.value / unit for point in branch.special]
    assert found == pytest.approx([most, -most], rel=1e-9)


@pytest.mark.parametrize("metre", [1.0, 1e-6, 1e3])
@pytest.mark.parametrize("distance", [False, True])
def test_accelerations_that_follow_from_constraints_tell_no_size(metre, distance):
    """A bead at the bottom of a tilted circle: a spring across it moves it nowhere.

    What rounding left of the accelerations along the two constraints made steps along the branch
    of 1e12 m, and points that were on neither.
    """
    N, O = inertial_frame()
    m, R, l, g, k = sm.symbols("m R l g k")
    x, y, z, ux, uy, uz = me.dynamicsymbols("x y z ux uy uz")
    P = O.locatenew("P", x * N.x + y * N.y + z * N.z)
    square = x**2 + y**2 + z**2
    sphere = sm.sqrt(square) - l if distance else square - l**2
    system = System(
        Definition(
            N,
            [x, y, z],
            [ux, uy, uz],
            bodies=[me.Particle("p", P, m)],
            loads=[(P, -m * g * N.z - k * y * N.y)],
            holonomic_constraints=[sphere, z - x - R],
        ),
        {l: metre, R: 0.3 * metre, g: 9.81 * metre, k: 2.0},
        initial_conditions={x: -0.841 * metre, z: -0.541 * metre},
    )
    branch = system.follow_equilibria({"k": [0.0, 30.0]})
    assert (branch.special, branch.ended) == ((), "bounds")
    half = np.sqrt(0.5 - 0.15**2)
    right = [[-0.15 - half, 0.0, 0.15 - half]] * len(branch.values)
    found = np.transpose([branch[name] for name in "xyz"]) / metre
    np.testing.assert_allclose(found, right, rtol=0.0, atol=1e-10)


def test_a_branch_ends_where_its_equations_contradict_each_other():
    """The unknown is p and 2 p: the least square is neither."""
    slopes = np.array([[1.0, -1.0], [1.0, -2.0]])
    points, _, _, ended, _ = pydy.analysis.continuation.trace(
        (
            lambda z: slopes @ z,
            lambda z: slopes,
            lambda z: (np.array([-1.0]), np.array([0.0])),
            lambda slopes, z: SimpleNamespace(
                terms=np.ones(2), limit=np.zeros(2), units=np.ones(1)
            ),
        ),
        ("x", "p"),
        np.zeros(2),
        (0.0, 1.0),
        0.02,
        100,
        lambda value: None,
    )
    assert ended == "lost"
    assert all(np.abs(slopes @ z).max() <= 1e-9 for z in points)


def traced(F, J, start, ends):
    """Follow a curve of x and p from a start."""
    return pydy.analysis.continuation.trace(
        (
            lambda z: np.array([F(*z)]),
            lambda z: np.array([J(*z)]),
            lambda z: (np.array([-1.0]), np.array([0.0])),
            lambda slopes, z: SimpleNamespace(
                terms=np.ones(1), limit=np.zeros(1), units=np.ones(1)
            ),
        ),
        ("x", "p"), np.array(start), ends, 0.02, 2000, lambda value: None,
    )  # fmt: skip


def test_a_branch_that_returns_to_its_start_is_closed():
    """The circle x² + p² = 1, from its fold at p = −1."""
    points, _, special, ended, _ = traced(
        lambda x, p: x**2 + p**2 - 1.0, lambda x, p: (2.0 * x, 2.0 * p), (0.0, -1.0), (-1.0, 1.0)
    )
    assert ended == "closed"
    np.testing.assert_allclose((points**2).sum(axis=1), 1.0, atol=1e-10)
    turned = np.unwrap(np.arctan2(points[:, 1], points[:, 0]))
    assert abs(turned[-1] - turned[0]) == pytest.approx(2.0 * np.pi, abs=0.1)
    assert any(point.value == pytest.approx(1.0) for point in special)


@pytest.mark.parametrize("far", [5.0, 50.0, 500.0])
def test_a_branch_that_grew_does_not_close_beside_its_start(far):
    """x = 0.275 + far p ∓ 0.225 √(1 − p) leaves p = 0 at x = 0.05, and returns to it at 0.5."""
    points, _, special, ended, _ = traced(
        lambda x, p: (x - 0.275 - far * p) ** 2 - 0.225**2 * (1.0 - p),
        lambda x, p: (2 * (x - 0.275 - far * p), -2 * far * (x - 0.275 - far * p) + 0.225**2),
        (0.05, 0.0), (0.0, 2.0),
    )  # fmt: skip
    assert [point.kind for point in special] == ["fold"]
    assert ended == "bounds"
    np.testing.assert_allclose(points[-1], [0.5, 0.0], atol=1e-9)


def test_a_branch_may_begin_at_a_fold_with_a_free_unknown():
    """p + s − s³ = 0 with s = x + y folds at s = −1/√3; x − y is free, and stays as at first."""
    (x, y), speeds = me.dynamicsymbols("x y"), me.dynamicsymbols("u v")
    frame, origin = inertial_frame()
    place = origin.locatenew("P", x * frame.x + y * frame.y)
    p, s = sm.Symbol("p"), x + y
    force = (p + s - s**3) * (frame.x + frame.y) - speeds[0] * frame.x - speeds[1] * frame.y
    mass = me.Particle("P", place, 1)
    system = System(Definition(frame, [x, y], speeds, bodies=[mass], loads=[(place, force)]))
    fold = 2.0 / (3.0 * np.sqrt(3.0))
    at = {"x": -1.0 / np.sqrt(3.0) - 0.2, "y": 0.2}
    system.initial_conditions = at
    branch = system.follow_equilibria({"p": [fold, -2.0]})
    assert branch.ended == "bounds"
    s = branch["x"] + branch["y"]
    np.testing.assert_allclose(s**3 - s, branch.values, atol=1e-9)
    np.testing.assert_allclose(branch["x"] - branch["y"], at["x"] - at["y"], atol=1e-6)


def test_a_curve_with_the_sizes_of_a_fold_holds_what_was_free():
    """Of s and d, d is free; F = p − s² folds at 0."""
    functions = (
        lambda z: np.array([z[2] - (z[0] + z[1]) ** 2, 0.0]),
        lambda z: np.array([[-2 * (z[0] + z[1]), -2 * (z[0] + z[1]), 1.0], [0.0, 0.0, 0.0]]),
        lambda z: (np.array([-1.0]), np.array([0.0])),
        lambda slopes, z: SimpleNamespace(terms=np.ones(2), limit=np.zeros(2), units=np.ones(2)),
    )
    made = pydy.analysis.continuation._BranchCurve
    curve = made(functions, np.array([0.5, 0.5, 1.0]), 1.0, ("x", "y", "p"))
    fold = curve.point(np.array([0.2, -0.2, 0.0]), np.array([-1.0, -1.0, 0.0]))
    renewed, point = curve.scaled_anew(fold)
    free, tangent = renewed.free_directions * renewed.scale[:2], point.tangent * renewed.scale
    assert free.shape == (1, 2)
    np.testing.assert_allclose(free[0, 0], -free[0, 1], rtol=1e-9)
    np.testing.assert_allclose(tangent, [tangent[0], tangent[0], 0.0], atol=1e-9)
