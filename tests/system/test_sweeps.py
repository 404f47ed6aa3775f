"""Eigenvalues along a parameter."""

import pickle

import numpy as np
import pytest
import sympy as sm
import sympy.physics.mechanics as me
from scipy.linalg import eigvals

import pydy.analysis.families
import pydy.analysis.sweeps
import zoo
from pydy import System
from pydy.errors import AnalysisInterrupted, EquilibriumError
from pydy.examples import whipple_bicycle
from pydy.mechanics import Definition
from pydy.models import multi_mass_spring_damper, n_link_pendulum_on_cart
from zoo import inertial_frame
from zoo.cases import system_of
from zoo.hoop import bead_on_a_hoop
from zoo.ziegler import zieglers_pendulum

MOVING = ["x", "theta_R", "theta_F"]


@pytest.fixture(scope="module")
def bicycle():
    made = whipple_bicycle.derive()
    return made, System(made.definition, constants=whipple_bicycle.benchmark_parameters(made))


@pytest.fixture(scope="module")
def over_speed(bicycle):
    return bicycle[1].eigenvalues({"u_x": np.linspace(0.0, 10.0, num=101)}, moving=MOVING)


def test_weave_and_capsize_speeds_are_the_published_ones(over_speed):
    weave, capsize = over_speed.crossings()
    assert weave.value == pytest.approx(4.292382536341, abs=5e-12)
    assert capsize.value == pytest.approx(6.024262015388, abs=5e-12)
    assert (weave.oscillatory, weave.stabilizing) == (True, True)
    assert (capsize.oscillatory, capsize.stabilizing) == (False, False)
    assert weave.eigenvalue.real == capsize.eigenvalue == 0.0
    between = (over_speed.values > weave.value) & (over_speed.values < capsize.value)
    np.testing.assert_array_equal(over_speed.stable, between)


def test_the_eigenvalues_are_meijaards_table(over_speed):
    for speed, published in whipple_bicycle.PUBLISHED_EIGENVALUES.items():
        (k,) = np.flatnonzero(np.isclose(over_speed.values, speed))
        for value in published:
            assert np.abs(over_speed.eigenvalues[k] - value).min() < 1e-9
    assert over_speed.neutral == ("x", "y", "psi", "theta_R", "theta_F", "omega_R")


def test_equilibria_are_found_along_the_way(bicycle, over_speed):
    made, system = bicycle
    for k in (0, 37, 100):
        row = whipple_bicycle.equilibrium(made, over_speed.values[k])
        expected = [row[s] for s in system.states]
        np.testing.assert_allclose(over_speed.equilibria[k], expected, atol=1e-12)


def test_states_may_be_given(bicycle, over_speed):
    made, system = bicycle
    values = np.array([3.0, 5.0, 7.0])
    rows = [whipple_bicycle.equilibrium(made, v) for v in values]
    at = np.array([[row[s] for s in system.states] for row in rows])
    sweep = system.eigenvalues({"u_x": values}, at=at)
    for k, place in enumerate((30, 50, 70)):
        found = np.sort_complex(sweep.eigenvalues[k].round(9))
        expected = np.sort_complex(over_speed.eigenvalues[place].round(9))
        np.testing.assert_allclose(found, expected, atol=1e-8)


def test_branches_that_cross_are_followed():
    """Two uncoupled pendulums whose frequencies pass each other."""
    values = np.linspace(0.0, 1.0, num=201)
    a, b = 1.0 + values, 2.0 - 1.5 * values
    A = np.zeros((201, 4, 4))
    A[:, 0, 1] = A[:, 2, 3] = 1.0
    A[:, 1, 0], A[:, 3, 2] = -(a**2), -(b**2)
    spectra, active, _ = pydy.analysis.sweeps.spectra_of(A)
    assert len(active) == 4
    ends = np.sort(np.abs(np.diff(np.abs(spectra), axis=0)).max(axis=0))
    np.testing.assert_allclose(ends, np.sort([0.005, 0.005, 0.0075, 0.0075]), rtol=1e-6)


def test_constants_and_inputs_are_parameters_too():
    system = multi_mass_spring_damper(2, apply_gravity=True, apply_external_forces=True)
    values = np.linspace(0.5, 4.0, num=8)
    sweep = system.eigenvalues({"m1": values})
    for m, row in zip(values, sweep.eigenvalues, strict=True):
        expected = eigvals(system_matrix(m))
        assert max(np.abs(row - e).min() for e in expected) < 1e-12
    forced = system.eigenvalues({"f0": [0.0, 1.0, 2.0]})
    # The force stretches the first spring, and changes nothing else.
    np.testing.assert_allclose(forced.equilibria[:, 0], [2.0, 3.0, 4.0], atol=1e-12)
    np.testing.assert_allclose(forced.eigenvalues[2], forced.eigenvalues[0], atol=1e-12)


def system_matrix(m1):
    system = multi_mass_spring_damper(2, apply_gravity=True, apply_external_forces=True)
    system.constants = {"m1": m1}
    return system.evaluate_jacobian(system.find_equilibrium().state)


def test_constrained_mechanisms_are_swept_and_followed():
    model = zoo.fourbar()
    system = system_of(model)
    system.initial_conditions = model.start
    system.set_dependent_initial_conditions()
    system.initial_conditions = system.find_equilibrium().initial_conditions
    (m2,) = [s for s in system.constants_symbols if s.name == "m2"]
    values = np.array([0.5, 1.0, 2.0])
    sweep = system.eigenvalues({m2: values})
    branch = system.follow_equilibria({m2: [0.5, 2.0]}, step=0.5)
    known = {**system.constants}
    for k, value in enumerate(values):
        system.constants = {**{s: v for s, v in known.items() if str(s) != "m2"}, m2: value}
        state = system.find_equilibrium().state
        np.testing.assert_allclose(sweep.equilibria[k], state, atol=1e-9)
        expected = np.sort_complex(system.linearize(state).eigenvalues)
        np.testing.assert_allclose(np.sort_complex(sweep.eigenvalues[k]), expected, atol=1e-7)
    np.testing.assert_allclose(branch.states[-1], state, atol=1e-9)


def test_equilibria_of_a_branch_are_kept():
    """Beyond the critical rate a bead leaves the bottom; the branch that it is on is followed."""
    system, angle, turn = bead_on_a_hoop()
    system.specifieds = {turn: 9.0}
    system.initial_conditions = {angle: 1.3}
    rates = np.linspace(9.0, 5.0, num=41)
    sweep = system.eigenvalues({turn: rates})
    np.testing.assert_allclose(np.cos(sweep.equilibria[:, 0]), 9.81 / (0.5 * rates**2), rtol=1e-10)
    assert (sweep.equilibria[:, 0] > 0.0).all()


def test_where_there_is_no_equilibrium_the_value_is_told():
    system, angle, turn = bead_on_a_hoop()
    system.outputs = {}
    with pytest.raises(EquilibriumError) as caught:
        system.eigenvalues({turn: [1.0, 2.0]}, unknowns=["omega"], given={angle: 0.5})
    assert "This was at Omega = 1." in caught.value.__notes__[0]


def test_results_go_into_xarray_and_pictures(over_speed):
    import matplotlib.pyplot as plt

    dataset = over_speed.to_xarray()
    assert dict(dataset["real"].sizes) == {"u_x": 101, "branch": 10}
    assert dataset["imag"].sel(u_x=4.0, method="nearest").max() > 3.0
    ax = over_speed.plot(unit="m/s")
    assert ax.get_xlabel() == "$u_{x}$ (m/s)"
    dotted = [line.get_xdata()[0] for line in ax.get_lines() if line.get_linestyle() == ":"]
    assert dotted == [crossing.value for crossing in over_speed.crossings()]
    assert over_speed.plot_root_locus().get_ylabel() == "imaginary part (1/s)"
    plt.close("all")
    with pytest.raises(TypeError, match="`ax` must be Matplotlib Axes"):
        over_speed.plot(ax=3)


@pytest.mark.parametrize(
    ("over", "message"),
    [
        ({}, "`over` must give the values of one"),
        ({"m0": [1.0, 2.0], "k0": [1.0, 2.0]}, "one state, constant or specified, got 2"),
        ({"m9": [1.0, 2.0]}, "m9"),
        ({"m0": 1.0}, "at least two finite values"),
        ({"m0": [1.0, np.nan]}, "must be finite, got .*nan"),
        ({"m0": [1.0, 1.0]}, "must ascend or descend"),
    ],
)
def test_what_does_not_fit_is_named(over, message):
    with pytest.raises(ValueError, match=message):
        n_link_pendulum_on_cart().eigenvalues(over)
    with pytest.raises(ValueError, match="one for each of the 2 values"):
        n_link_pendulum_on_cart().eigenvalues({"m0": [1.0, 2.0]}, at=np.zeros((3, 4)))


def test_a_prescribed_stiffness_drives_an_oscillator_over_the_edge():
    x, v, k = me.dynamicsymbols("x v k")
    N, P, O = me.ReferenceFrame("N"), me.Point("P"), me.Point("O")
    O.set_vel(N, 0)
    P.set_vel(N, v * N.x)
    kane = me.KanesMethod(N, [x], [v], [x.diff() - v])
    kane.kanes_equations([me.Particle("b", P, sm.Integer(1))], [(P, -(k * x + v / 2) * N.x)])
    (crossing,) = System(kane).eigenvalues({k: [1.0, -2.0, -4.0]}).crossings()[:1]
    assert crossing.value == pytest.approx(0.0, abs=1e-9)
    assert not crossing.oscillatory


def test_eigenvalues_of_a_constrained_bead_at_the_bottom_of_a_turning_hoop():
    """The hoop's force leaves a few rounding errors in rows that vanish there."""
    q, u = me.dynamicsymbols("x z"), me.dynamicsymbols("v w")
    m, l, g, c, turn = sm.symbols("m l g c Omega")
    N, H, O = me.ReferenceFrame("N"), me.ReferenceFrame("H"), me.Point("O")
    H.orient_axis(N, N.z, turn * zoo.T)
    O.set_vel(N, 0)
    P = O.locatenew("P", q[0] * H.x + q[1] * H.z)
    bead = Definition(
        N,
        q,
        u,
        bodies=[me.Particle("bead", P, m)],
        loads=[(P, -m * g * N.z - c * (u[0] * H.x + u[1] * H.z))],
        holonomic_constraints=[q[0] ** 2 + q[1] ** 2 - l**2],
    )
    values = {m: 0.3, l: 0.7, g: 9.81, c: 0.05}
    system = System(bead, values, initial_conditions={q[0]: 0.02, q[1]: -0.7})
    system.set_dependent_initial_conditions([q[1], u[1]])
    turns = np.linspace(0.5, 3.5, num=13)
    sweep = system.eigenvalues({turn: turns})
    for rate, values in zip(turns, sweep.eigenvalues, strict=True):
        expected = np.roots([1.0, 0.05 / 0.3, 9.81 / 0.7 - rate**2])
        np.testing.assert_allclose(np.sort_complex(values), np.sort_complex(expected), rtol=1e-9)


def hoop_and_rates():
    system, angle, turn = bead_on_a_hoop()
    system.specifieds, system.initial_conditions = {turn: 9.0}, {angle: 1.3}
    return system, {turn: np.linspace(9.0, 5.0, num=41)}


def test_ctrl_c_hands_over_the_first_values(monkeypatch):
    system, over = hoop_and_rates()
    whole, calls = system.eigenvalues(over), []
    family, solve_from = pydy.analysis.families.Family, pydy.analysis.families.Family.solve_from

    def interrupted(self, z):
        calls.append(z)
        if len(calls) > 20:
            raise KeyboardInterrupt
        return solve_from(self, z)

    monkeypatch.setattr(family, "_near", lambda self, z, other: False)
    monkeypatch.setattr(family, "solve_from", interrupted)
    with pytest.raises(AnalysisInterrupted, match="20 of 41 values of Omega") as caught:
        system.eigenvalues(over)
    sweep = caught.value.results
    np.testing.assert_array_equal(sweep.values, whole.values[:20])
    np.testing.assert_allclose(sweep.eigenvalues, whole.eigenvalues[:20], atol=1e-9)
    np.testing.assert_allclose(sweep.equilibria, whole.equilibria[:20], atol=1e-12)


def test_equilibria_that_the_slopes_predict_are_not_solved_for_again(monkeypatch):
    """Far apart as they are, those of a linear spring, x = F/k, lie on its tangent."""
    solve_from, calls = pydy.analysis.families.Family.solve_from, []

    def counted(self, z):
        calls.append(z)
        return solve_from(self, z)

    monkeypatch.setattr(pydy.analysis.families.Family, "solve_from", counted)
    system = multi_mass_spring_damper(apply_external_forces=True)
    system.constants = {"k0": 4.0}
    sweep = system.eigenvalues({"f0": [1.0, 20.0, 300.0]})
    np.testing.assert_allclose(sweep.equilibria[:, 0], [0.25, 5.0, 75.0], rtol=1e-12)
    assert len(calls) == 1  # the first


def test_values_in_several_parts_lead_to_the_same_branches(monkeypatch, capsys):
    system, over = hoop_and_rates()
    whole = system.eigenvalues(over)
    monkeypatch.setattr(pydy.analysis.families, "VALUES_PER_PART", 7)
    monkeypatch.setattr(pydy.analysis.sweeps, "VALUES_PER_PART", 5)
    parts = system.eigenvalues(over, progress=True)
    assert "41/41" in capsys.readouterr().err
    np.testing.assert_allclose(parts.eigenvalues, whole.eigenvalues, atol=1e-9)
    np.testing.assert_allclose(parts.equilibria, whole.equilibria, atol=1e-12)
    equilibria, calls = pydy.analysis.families.Family.equilibria, []

    def interrupted(self, values, start=None):
        calls.append(values)
        if len(calls) > 3:
            raise KeyboardInterrupt
        return equilibria(self, values, start)

    monkeypatch.setattr(pydy.analysis.families.Family, "equilibria", interrupted)
    with pytest.raises(AnalysisInterrupted) as caught:
        system.eigenvalues(over)
    np.testing.assert_array_equal(caught.value.results.A, parts.A[:21])


def test_ctrl_c_among_the_matrices_at_given_states_hands_over_those_that_are_there(monkeypatch):
    system = multi_mass_spring_damper()
    stiffness = np.linspace(1.0, 9.0, num=40)
    matrices, calls = pydy.analysis.families.Family.matrices, []

    def interrupted(self, z):
        calls.append(z)
        if len(calls) > 2:
            raise KeyboardInterrupt
        return matrices(self, z)

    monkeypatch.setattr(pydy.analysis.families, "VALUES_PER_PART", 7)
    monkeypatch.setattr(pydy.analysis.families.Family, "matrices", interrupted)
    with pytest.raises(AnalysisInterrupted, match="after 14 of 40 values") as caught:
        system.eigenvalues({"k0": stiffness}, at=np.zeros(2))
    sweep = caught.value.results
    # m = c = 1: s^2 + s + k = 0.
    expected = -0.5 + 1j * np.sqrt(stiffness[:14] - 0.25)
    assert sweep.eigenvalues.max(axis=1) == pytest.approx(expected, rel=1e-12)


def test_ctrl_c_is_not_kept_waiting_by_the_eigenvalues_of_what_is_done(monkeypatch):
    system, over = hoop_and_rates()
    whole, spectra_of, calls = system.eigenvalues(over), pydy.analysis.sweeps.spectra_of, []

    def interrupted(A):
        calls.append(len(A))
        if len(calls) == 1:
            raise KeyboardInterrupt
        return spectra_of(A)

    monkeypatch.setattr(pydy.analysis.sweeps, "spectra_of", interrupted)
    with pytest.raises(AnalysisInterrupted, match="after 41 of 41 values") as caught:
        system.eigenvalues(over)  # among the spectra, at the end
    assert calls == [41]
    np.testing.assert_array_equal(caught.value.results.eigenvalues, whole.eigenvalues)
    monkeypatch.setattr(pydy.analysis.families, "VALUES_PER_PART", 7)
    matrices = pydy.analysis.families.Family.matrices

    def stopped(self, z):
        if z[-1, -1] < 8.0:
            raise KeyboardInterrupt
        return matrices(self, z)

    monkeypatch.setattr(pydy.analysis.families.Family, "matrices", stopped)
    with pytest.raises(AnalysisInterrupted, match="after 7 of 41 values") as caught:
        system.eigenvalues(over)
    assert calls == [41, 41]  # none until they are asked for
    sweep = pickle.loads(pickle.dumps(caught.value)).results
    assert str(sweep).startswith("2 eigenvalues at 7 values")
    np.testing.assert_allclose(sweep.eigenvalues, whole.eigenvalues[:7], atol=1e-9)
    assert calls == [41, 41, 7]


@pytest.mark.parametrize("where", ["_near", "matrices", "spectra_of"])
def test_values_are_handed_over_where_memory_ends(monkeypatch, where):
    system, over = hoop_and_rates()
    whole = system.eigenvalues(over)
    place = pydy.analysis.sweeps if where == "spectra_of" else pydy.analysis.families.Family
    usual, calls = getattr(place, where), []

    def without_memory(*args):
        calls.append(args)
        if len(calls) > {"_near": 9, "matrices": 2, "spectra_of": 0}[where]:
            raise MemoryError("no more")
        return usual(*args)

    monkeypatch.setattr(pydy.analysis.families, "VALUES_PER_PART", 7)
    monkeypatch.setattr(place, where, without_memory)
    with pytest.raises(MemoryError, match="no more") as caught:
        system.eigenvalues(over)
    done = {"_near": 11, "matrices": 14, "spectra_of": 41}[where]
    told = f"The first {done} of 41 values of Omega are in the attributes of this error: results."
    assert caught.value.__notes__ == [told]
    monkeypatch.setattr(place, where, usual)
    np.testing.assert_allclose(
        caught.value.results.eigenvalues, whole.eigenvalues[:done], atol=1e-9
    )


@pytest.mark.parametrize("rate", [1.0, 1e-4, 1e10])
def test_eigenvalues_do_not_depend_on_units(rate):
    """A film of gigahertz was taken for two states that nothing depends on."""
    system = multi_mass_spring_damper()
    m = 1e-13
    system.constants = {"m0": m, "k0": m * rate**2, "c0": 0.0}
    sweep = system.eigenvalues({"c0": np.linspace(-3e-3, 2e-3, num=4) * m * rate})
    assert sweep.neutral == ()
    expected = np.roots([1.0, -3e-3, 1.0])
    np.testing.assert_allclose(np.sort(sweep.eigenvalues[0] / rate), np.sort(expected), rtol=1e-9)
    (crossing,) = sweep.crossings()
    assert crossing.value == pytest.approx(0.0, abs=1e-12 * m * rate)
    assert crossing.eigenvalue.imag == pytest.approx(rate, rel=1e-9)


@pytest.mark.parametrize("forces", [np.linspace(0.0, 2.5, 7), np.linspace(2.5, 0.0, 50)])
def test_flutter_without_damping_begins_at_the_published_force(forces):
    sweep = zieglers_pendulum(0.0).eigenvalues({"P": forces})
    (crossing,) = sweep.crossings()
    assert crossing.value == pytest.approx(3.5 - np.sqrt(2.0), rel=1e-12)
    assert crossing.oscillatory
    assert crossing.stabilizing == (forces[-1] < forces[0])


def test_a_bead_without_damping_leaves_the_bottom_of_its_hoop_at_the_critical_rate():
    system, _, turn = bead_on_a_hoop()
    rates = np.linspace(1.0, 8.0, 23)
    (crossing,) = system.eigenvalues({turn: rates}, at=[0.0, 0.0]).crossings()
    assert crossing.value == pytest.approx(np.sqrt(9.81 / 0.5), rel=1e-12)
    assert not crossing.oscillatory
    assert not crossing.stabilizing


def test_a_sweep_goes_on_where_its_second_block_begins():
    """A bicycle's wheels turn at another speed there than at the equilibrium before."""
    bicycle = whipple_bicycle.derive()
    system = System(bicycle.definition, constants=whipple_bicycle.benchmark_parameters(bicycle))
    speeds = np.linspace(0.0, 2.57, num=258)
    sweep = system.eigenvalues({"u_x": speeds}, moving=["x", "theta_R", "theta_F"])
    assert np.isfinite(sweep.eigenvalues).all()


@pytest.mark.parametrize("count", [3, 4, 9, 10, 30, 41])
def test_a_branch_that_rests_on_the_axis_is_left_where_it_becomes_unstable(count):
    """A particle on a rotating saddle: stable between the two curvatures that make it so.

    On either side it is unstable, in different ways; eigenvalues are on the axis in between.
    """
    x, y = me.dynamicsymbols("x y")
    p = sm.Symbol("p")
    frame, origin = inertial_frame()
    place = origin.locatenew("P", x * frame.x + y * frame.y)
    force = ((1 - p) * x + 2 * y.diff()) * frame.x + (y - 2 * x.diff()) * frame.y
    system = System(
        Definition(frame, [x, y], bodies=[me.Particle("P", place, 1)], loads=[(place, force)])
    )
    gained, lost = system.eigenvalues({p: np.linspace(-0.5, 1.5, count)}).crossings()
    assert (gained.value, lost.value) == pytest.approx((0.0, 1.0), abs=1e-11)
    assert (gained.oscillatory, gained.stabilizing) == (True, True)
    assert (lost.oscillatory, lost.stabilizing) == (False, False)


def rolling_disc(radius, second):
    """A uniform disc that rolls without slip, upright; and its rate of spin, and the critical one.

    It is stable from m g r A = C (C + m r²) Ω² on, A = C/2 = m r²/4: Ω² = g/(3 r).
    """
    x, y, yaw, lean, spin = me.dynamicsymbols("x y yaw lean spin")
    frame, origin = inertial_frame()
    heading = frame.orientnew("Y", "Axis", (yaw, frame.z))
    leaning = heading.orientnew("L", "Axis", (lean, heading.x))
    disc = leaning.orientnew("D", "Axis", (spin, leaning.y))
    centre = origin.locatenew("G", x * frame.x + y * frame.y + radius * leaning.z)
    centre.set_vel(frame, centre.pos_from(origin).dt(frame))
    contact = centre.vel(frame) - me.cross(disc.ang_vel_in(frame), radius * leaning.z)
    g = 9.81 / second**2
    quarter = radius**2 / 4
    body = me.RigidBody(
        "disc", centre, disc, 1.0, (me.inertia(leaning, quarter, 2 * quarter, quarter), centre)
    )
    definition = Definition(
        frame,
        [x, y, yaw, lean, spin],
        bodies=[body],
        loads=[(centre, -g * frame.z)],
        nonholonomic_constraints=[contact.dot(heading.x), contact.dot(heading.y)],
    )
    return System(definition), [x, y, spin], spin.diff(), np.sqrt(g / (3.0 * radius))


@pytest.mark.parametrize("count", [31, 32])  # with the critical rate among them, and without
@pytest.mark.parametrize(("radius", "second"), [(0.3, 1.0), (3e-9, 1e-6), (3e8, 3.15e7)])
def test_a_rolling_disc_is_stable_from_the_rate_of_spin_that_is_known(radius, second, count):
    """What is conserved is an eigenvalue of zero, which the disc's was taken for: 1.3 % off."""
    system, moving, rate, critical = rolling_disc(radius, second)
    rates = critical * np.linspace(0.5, 2.0, count)
    (crossing,) = system.eigenvalues({rate: rates}, moving=moving).crossings()
    assert crossing.value == pytest.approx(critical, rel=1e-8)
    assert (crossing.oscillatory, crossing.stabilizing) == (False, True)


def pushed_cart(damping, extra, push, more):
    """A cart with a push, and coordinates with equations of their own."""
    x, v = me.dynamicsymbols("x v")
    frame, origin = inertial_frame()
    place = origin.locatenew("P", x * frame.x)
    return System(
        Definition(
            frame,
            [x, *extra],
            [v],
            bodies=[me.Particle("cart", place, 1)],
            loads=[(place, (damping * v + push(x, v)) * frame.x)],
            kinematic_equations=[x.diff() - v, *more(v)],
        )
    )


@pytest.mark.parametrize("count", [2, 3, 5, 11, 41])
@pytest.mark.parametrize(
    ("damping", "root"),
    [
        (lambda p: sm.exp(5 * p) - 2, np.log(2.0) / 5.0),
        (lambda p: p**3 - sm.Rational(1, 27), 1.0 / 3.0),
        (lambda p: 4 * p**2 - 1, 0.5),
        (lambda p: sm.exp(-9 * p) - sm.Rational(1, 50), np.log(50.0) / 9.0),
    ],
)
def test_a_crossing_beside_an_eigenvalue_that_is_always_zero_is_exact(damping, root, count):
    p, held = sm.Symbol("p"), me.dynamicsymbols("held")
    system = pushed_cart(damping(p), [held], lambda x, v: held, lambda v: [held.diff()])
    over = {p: np.linspace(0.0, 1.0, count)}
    (crossing,) = system.eigenvalues(over, at=[0.0, 0.0, 0.0]).crossings()
    assert crossing.value == pytest.approx(root, abs=1e-12)


def test_branches_that_are_mixed_up_between_far_values_make_no_crossing():
    """One decays to zero past a constant one; where it crosses is found by counting."""
    values = np.linspace(0.0, 1.0, 3)

    def models(at, _=None):
        return np.array([np.diag([np.exp(-9.0 * p) - 0.02, -0.03]) for p in at])

    sweep = pydy.analysis.sweeps.EigenvalueSweep(
        "p", values, models(values), ("a", "b"), np.zeros((3, 2)), models
    )
    assert [c.value for c in sweep.crossings()] == pytest.approx([np.log(50.0) / 9.0], abs=1e-10)


@pytest.mark.parametrize("fast", [1e2, 1e5, 1e7])
def test_slow_instability_is_seen_beside_fast_motions(fast):
    """An oscillator with negative damping drives a motor with a resistance: s² − p s + 1 becomes

    (s + R) (s² − p s + 1) + K² s, on the axis where R p² − (1 + K² + R²) p + R K² = 0 (Routh). All
    was stable that grew more slowly than a millionth of the current decays.
    """
    p, current = sm.Symbol("p"), me.dynamicsymbols("current")
    torque = np.sqrt(0.3 * fast)
    system = pushed_cart(
        p,
        [current],
        lambda x, v: torque * current - x,
        lambda v: [current.diff() + fast * current + torque * v],
    )
    b = 1.0 + torque**2 + fast**2
    root = 2.0 * fast * torque**2 / (b + np.sqrt(b**2 - 4.0 * fast**2 * torque**2))
    values = np.linspace(0.0, 1.0, 12)
    sweep = system.eigenvalues({p: values}, at=[0.0, 0.0, 0.0])
    (crossing,) = sweep.crossings()
    assert crossing.value == pytest.approx(root, rel=1e-15 * fast + 1e-12)
    assert (crossing.oscillatory, crossing.stabilizing) == (True, False)
    assert crossing.eigenvalue.imag == pytest.approx(1.0, rel=2.0 / fast)
    np.testing.assert_array_equal(sweep.stable, values < root)
    branch = system.follow_equilibria({p: [0.0, 1.0]})
    (point,) = branch.special
    assert point.kind == "Hopf"
    assert point.value == pytest.approx(root, abs=1e-11 * fast)
    np.testing.assert_array_equal(branch.stable, branch.values < root)


@pytest.mark.parametrize("analysis", ["eigenvalues", "follow_equilibria"])
def test_a_parameter_apart_from_its_values_is_told_to_join_them(analysis):
    system = multi_mass_spring_damper()
    arguments = ("k0", [1.0, 2.0]) if analysis == "eigenvalues" else ("k0",)
    with pytest.raises(TypeError, match=r"`over` must be a dictionary, got str\. .*over=\{"):
        getattr(system, analysis)(*arguments)
