"""Linear models on the constraints, with names."""

from functools import cache

import numpy as np
import pytest
import sympy as sm
import sympy.physics.mechanics as me
from scipy.optimize import brentq

import zoo
from pydy.errors import PyDyUserWarning
from pydy.examples import whipple_bicycle
from pydy.inputs import SampledInput
from pydy.linearize import constrained_eigenvalues
from pydy.mechanics import Definition
from pydy.models import multi_mass_spring_damper, n_link_pendulum_on_cart
from pydy.system import System
from zoo import inertial_frame
from zoo.cases import close, system_of
from zoo.circle import on_a_circle
from zoo.singular import slider_crank
from zoo.ziegler import zieglers_pendulum


@cache
def bicycle():
    made = whipple_bicycle.derive()
    constants = whipple_bicycle.benchmark_parameters(made)
    return made, System(made.definition, constants=constants)


def upright(made, system, speeds):
    """States of straight running, a row for each forward speed."""
    rows = [whipple_bicycle.equilibrium(made, v) for v in speeds]
    return np.array([[row.get(s, 0.0) for s in system.states] for row in rows])


def test_the_bicycle_has_the_published_eigenvalues():
    made, system = bicycle()
    for speed, published in whipple_bicycle.PUBLISHED_EIGENVALUES.items():
        model = system.linearize(upright(made, system, [speed])[0])
        for value in published:
            assert np.abs(model.eigenvalues - value).min() < 1e-9


def test_the_bicycles_weave_and_capsize_speeds_are_the_published_ones():
    made, system = bicycle()

    def lateral(speed):
        """Lean and steer, which move apart from the ignorable coordinates."""
        model = system.linearize(upright(made, system, [speed])[0])
        places = [model.states.index(name) for name in ("phi", "delta", "u_phi", "u_delta")]
        return model.A[np.ix_(places, places)]

    def weave(speed):
        values = np.linalg.eigvals(lateral(speed))
        return values[np.abs(values.imag) > 1e-3].real.max()

    def capsize(speed):  # a real eigenvalue is zero
        return np.linalg.det(lateral(speed))

    assert brentq(weave, 4.0, 4.6, xtol=1e-12) == pytest.approx(4.292382536341, abs=1e-9)
    assert brentq(capsize, 5.8, 6.2, xtol=1e-12) == pytest.approx(6.024262015388, abs=1e-9)


def test_many_states_give_a_stack_of_models():
    made, system = bicycle()
    speeds = np.linspace(2.0, 8.0, 13)
    x = upright(made, system, speeds)
    many = system.linearize(x, np.zeros(len(x)))
    assert many.A.shape == (13, len(many.states), len(many.states))
    for k in (0, 7, 12):
        one = system.linearize(x[k])
        close(many.A[k], one.A)
        np.testing.assert_allclose(many.eigenvalues[k], one.eigenvalues, atol=1e-6)
    with pytest.raises(ValueError, match="needs a single linear model"):
        many.to_state_space()


@pytest.mark.parametrize("name", ["fourbar", "disc", "gyro", "track"])
def test_a_model_has_the_eigenvalues_of_the_motions_that_keep_the_constraints(name):
    system = system_of(zoo.MODELS[name]())
    if name != "gyro":
        at_rest = system.find_equilibrium().initial_conditions if name == "fourbar" else {}
        system.initial_conditions = at_rest
    model = system.linearize({})
    n = len(system.coordinates) + len(system.speeds)
    rank = n - len(model.states)
    blocks = [
        system.evaluate_jacobian(of=kind)
        for kind, count in (
            ("holonomic", system.num_holonomic_constraints),
            ("velocity", system.num_velocity_constraints),
        )
        if count
    ]
    assert rank == np.linalg.matrix_rank(np.vstack(blocks)[:, :n], tol=1e-9)
    if name == "fourbar":
        A = system.evaluate_jacobian()[:n, :n]
        expected = constrained_eigenvalues(A, np.vstack(blocks)[:, :n])
        np.testing.assert_allclose(model.eigenvalues, expected, atol=1e-7)


def test_a_model_predicts_small_motions_on_the_constraints():
    system = system_of(zoo.fourbar())
    found = system.find_equilibrium()
    model = system.linearize(found.state)
    x = found.state.copy()
    names = [s.name for s in system.states]
    small = 1e-6
    place = names.index(model.states[0])
    system.initial_conditions = {**found.initial_conditions, system.states[place]: x[place] + small}
    system.set_dependent_initial_conditions(use_jac=True)
    rates = system.evaluate_ode()[[names.index(s) for s in model.states]]
    close(rates, small * model.A[:, 0], 1e-10)


def test_inputs_and_outputs_have_names():
    system = n_link_pendulum_on_cart(2, joint_torques=True)
    q0, q1, _ = system.coordinates
    system.outputs = {sm.Symbol("height"): sm.cos(q1), sm.Symbol("push"): 3 * q0}
    model = system.linearize(inputs=["T1", "F"], outputs=["push", "q2", "height"])
    assert model.inputs == ("T1", "F")
    assert model.outputs == ("push", "q2", "height")
    assert model.B.shape == (6, 2)
    close(model.C[0], [3, 0, 0, 0, 0, 0])
    close(model.C[1], [0, 0, 1, 0, 0, 0])
    close(model.C[2], np.zeros(6))
    by_input = system.evaluate_jacobian(wrt="specifieds")
    close(model.B, by_input[:, [1, 0]])


@pytest.mark.parametrize("speed", [1e-9, 1e9])
def test_a_model_has_the_same_states_in_any_unit_of_time(speed):
    """On a circle of one metre, y'' = -y v²/(1 - y²)."""
    model = on_a_circle(0.7, speed).linearize({})
    x, y = np.cos(0.7), np.sin(0.7)
    assert model.states == ("y", "v")
    close(model.A * [[1, 1], [1 / speed**2, 1 / speed]], [[0, 1], [-(1 + y**2) / x**2, -2 * y / x]])


def test_an_output_may_depend_on_an_input_at_once():
    system = multi_mass_spring_damper(apply_external_forces=True)
    force = next(iter(system.specifieds_symbols))
    v = system.speeds[0]
    system.outputs = {sm.Symbol("a"): v.diff()}
    model = system.linearize(outputs=["a"])
    assert model.D.tolist() == [[1.0]]
    assert model.C.tolist() == [[-1.0, -1.0]]
    assert model.inputs == (force.name if hasattr(force, "name") else str(force),)


def test_scipy_takes_the_model():
    from scipy.signal import StateSpace  # takes a second to load

    space = multi_mass_spring_damper().linearize(outputs=["x0"]).to_state_space()
    assert isinstance(space, StateSpace)
    close(space.C, [[1.0, 0.0]])


def test_python_control_takes_the_model_with_its_names():
    model = n_link_pendulum_on_cart().linearize(inputs=["F"], outputs=["q1"])
    space = model.to_control()
    assert space.state_labels == list(model.states)
    assert space.input_labels == ["F"]
    assert space.output_labels == ["q1"]
    close(np.sort(space.poles().real), np.sort(model.eigenvalues.real), 1e-9)


def test_prescribed_motions_of_constraints_are_no_inputs():
    system = system_of(zoo.lifted())
    system.set_dependent_initial_conditions()
    with pytest.raises(ValueError, match="holonomic constraint 0") as refused:
        system.linearize()
    told = str(refused.value)
    # The line's equation and its rate: both have s, or its rate.
    assert "The holonomic constraint 0: -slope*x(t)*sin(t) - s(t) + y(t) depends on" in told
    assert "`s`, which is an input because all are by default. It prescribes a motion" in told
    assert told.endswith("`inputs=['Derivative(s(t), (t, 2))']`.")
    assert system.linearize(inputs=["Derivative(s(t), (t, 2))"]).B.shape[1] == 1
    with pytest.raises(ValueError, match=r"velocity constraint 0: .*is one of `inputs`"):
        system.linearize(inputs=[me.dynamicsymbols("s", 1)])
    assert system.linearize(inputs=[]).B.shape[1] == 0


def test_where_the_configuration_is_singular_it_says_so():
    system = system_of(zoo.fourbar())
    start = system.find_equilibrium().state
    bad = np.array([start, np.zeros_like(start)])
    with pytest.raises(ValueError, match="state 1 of `at`"):
        system.linearize(bad, np.zeros(2))


# -- Jacobians by names ---------------------------------------------------------------------------


def test_a_jacobian_takes_states_constants_and_specifieds_together():
    system = n_link_pendulum_on_cart(2, joint_torques=True)
    x = [0.1, 0.4, -0.3, 0.2, 0.5, 0.7]
    mixed = system.evaluate_jacobian(x, wrt=["u2", sm.Symbol("g"), "T1", system.states[1]])
    kinds = ("states", "constants", "specifieds")
    whole = np.hstack([system.evaluate_jacobian(x, wrt=kind) for kind in kinds])
    names = [s.name for s in system.states]
    names += [s.name for s in system.constants_symbols]
    names += [str(s.func) for s in system.specifieds_symbols]
    close(mixed, whole[:, [names.index(name) for name in ("u2", "g", "T1", "q1")]])
    close(system.evaluate_jacobian(x, wrt="g"), mixed[:, [1]])
    close(system.evaluate_jacobian([x, x], np.zeros(2), wrt=["g"])[1], mixed[:, [1]])


def test_a_jacobian_goes_through_an_expression_by_states_and_beside_it_by_the_input():
    system = n_link_pendulum_on_cart()
    force = next(iter(system.specifieds_symbols))
    gain = sm.Symbol("gain")
    system.specifieds = {force: -gain * system.speeds[0]}
    both = system.evaluate_jacobian({"q1": 0.3, "u0": 2.0}, wrt=["u0", "gain", force])
    by_input = both[:, 2]
    close(both[:, 1], -2.0 * by_input)
    assert by_input[2] > 0.0


def test_a_dictionary_gives_some_of_the_states_of_an_evaluation():
    system = n_link_pendulum_on_cart()
    system.initial_conditions = {"q1": 0.5, "u0": 1.0}
    close(system.evaluate_ode({"u0": 3.0}), system.evaluate_ode([0.0, 0.5, 3.0, 0.0]))
    with pytest.raises(ValueError, match="`x` has the key `z`"):
        system.evaluate_ode({"z": 1.0})


# -- states and inputs that need care -------------------------------------------------------------


def test_rounding_errors_are_no_rank_in_a_singular_configuration():
    # Both columns of the row along y are some 1e-17 there, and their ratio anything.
    system = slider_crank(1.0).system
    upright = [np.pi / 2, -np.pi / 2, 0.0, 0.0, 0.0, 0.0]
    with pytest.raises(ValueError, match="singular there"):
        system.linearize(upright)
    beside = [np.pi / 2 - 1e-3, -np.pi / 2 + 1e-3, 2 * np.sin(1e-3), 0.0, 0.0, 0.0]
    assert np.isfinite(system.linearize(beside).A).all()


def test_feedback_of_a_python_function_is_part_of_the_model():
    system = n_link_pendulum_on_cart()
    force = next(iter(system.specifieds_symbols))
    q0, q1 = system.coordinates
    system.specifieds = {force: -3 * q0 + 5 * q1}
    by_expression = system.linearize()
    system.specifieds = {force: lambda x, t: -3 * x[0] + 5 * x[1]}
    by_function = system.linearize()
    close(by_function.A, by_expression.A, 1e-8)
    close(by_function.B, by_expression.B)


def test_a_model_off_the_constraints_warns():
    system = system_of(zoo.fourbar())
    start = system.find_equilibrium().state + 0.1
    with pytest.warns(PyDyUserWarning, match="the state does not satisfy them"):
        system.linearize(start)


def test_a_model_that_is_not_finite_is_refused():
    system = n_link_pendulum_on_cart()
    with pytest.raises(ValueError, match="state 1 of `at`: there is no linear model"):
        system.linearize([[0.0] * 4, [np.nan] * 4], [0.0, 0.0])


def test_a_model_is_taken_at_a_dictionary_of_states():
    system = n_link_pendulum_on_cart()
    close(system.linearize({"q1": np.pi}).A, system.linearize([0.0, np.pi, 0.0, 0.0]).A)


@pytest.mark.parametrize("gap", [2.0, 2e-6, 3e-9])
def test_python_functions_of_micrometres_are_differentiated(gap):
    """An electrostatic force: a step of a micrometre would cross the gap."""
    system = multi_mass_spring_damper(apply_external_forces=True)
    (force,) = system.specifieds_symbols
    volts = 0.1 * gap**3
    system.specifieds = {force: lambda x, t: volts / (gap - x[0]) ** 2}
    model = system.linearize({"x0": 0.2 * gap})
    assert model.A[1, 0] == pytest.approx(-1.0 + 0.2 / 0.8**3, rel=1e-8)


def test_an_equilibrium_brings_its_constants_and_specifieds():
    system = multi_mass_spring_damper(2, apply_gravity=True, apply_external_forces=True)
    given = {"x0": 0.5, "x1": 2.0, "g": 9.81, "m1": 4.0}
    found = system.find_equilibrium(["f0", "k1"], given=given)
    model = system.linearize(found)
    # By hand: k1 x1 = m1 g, and the rate of the second spring's stretch is v1 alone.
    stiff = 4.0 * 9.81 / 2.0
    assert found["k1"] == pytest.approx(stiff, rel=1e-12)
    np.testing.assert_allclose(model.rates, 0.0, atol=1e-12)
    # Masses 1 and 4: v0' = -k0 x0 + k1 x1 and v0' + v1' = -k1 x1 / 4, damping 1.
    expected = [[-1.0, stiff, -1.0, 1.0], [1.0, -stiff * 1.25, 1.0, -1.25]]
    np.testing.assert_allclose(model.A[2:], expected, atol=1e-12)
    with pytest.raises(AssertionError):
        np.testing.assert_allclose(system.linearize(found.state).A[2:], expected, atol=1e-12)


def test_a_linear_model_and_an_equilibrium_print_what_a_person_reads():
    system = multi_mass_spring_damper(apply_external_forces=True)
    assert repr(system.linearize()) == (
        "LinearModel with states: x0, v0; inputs: f0; outputs: x0, v0; "
        "eigenvalues (1/s): -0.5 +- 0.866j"
    )
    states = np.zeros((3, 2))
    assert repr(system.linearize(states, np.arange(3.0))).endswith("outputs: x0, v0; 3 models")
    assert repr(system.find_equilibrium()).startswith("Equilibrium at x0 = 0, v0 = 0; largest")
    long = multi_mass_spring_damper(20).linearize()
    assert "and 28 more; inputs: none" in repr(long)


def test_a_frequency_without_a_steady_response_is_named():
    """An undamped oscillator of 1 rad/s has none there; beside it, it has 1/(1 - w²)."""
    x, f = me.dynamicsymbols("x f")
    frame, origin = inertial_frame()
    place = origin.locatenew("P", x * frame.x)
    oscillator = Definition(
        frame, [x], bodies=[me.Particle("mass", place, 1)], loads=[(place, (f - x) * frame.x)]
    )
    model = System(oscillator).linearize(inputs=["f"], outputs=["x"])
    with pytest.raises(np.linalg.LinAlgError, match=r"has 1 rad/s at index 1, .*Leave this freq"):
        model.frequency_response([0.5, 1.0, 2.0])
    np.testing.assert_allclose(
        model.frequency_response([0.5, 2.0])[:, 0, 0], [4.0 / 3.0, -1.0 / 3.0], rtol=1e-14
    )


def test_the_frequency_response_is_that_of_a_spring_and_a_damper():
    import matplotlib.pyplot as plt

    system = multi_mass_spring_damper(apply_external_forces=True)
    system.constants = {"m0": 2.0, "c0": 0.3, "k0": 5.0}
    model = system.linearize(outputs=["x0"])
    omega = np.array([0.1, 1.5, 20.0])
    expected = 1.0 / (5.0 - 2.0 * omega**2 + 0.3j * omega)
    found = model.frequency_response(omega)
    np.testing.assert_allclose(found[:, 0, 0], expected, rtol=1e-12)
    magnitude, phase = model.plot_bode("f0", "x0")
    assert magnitude.get_ylabel() == "magnitude (dB)"
    assert phase.get_xlabel() == "frequency (rad/s)"
    assert phase.lines[0].get_ydata()[-1] == pytest.approx(-180.0, abs=2.0)
    assert all(line.get_visible() for ax in (magnitude, phase) for line in ax.get_xgridlines())
    assert magnitude.get_legend().get_texts()[0].get_text() == "$f_{0}$ → $x_{0}$"
    _, turns = model.plot_bode("f0", "x0", omega, unit="Hz")
    assert turns.get_xlabel() == "frequency (Hz)"
    np.testing.assert_allclose(turns.lines[0].get_xdata(), omega / (2.0 * np.pi), rtol=1e-15)
    plt.close("all")
    with pytest.raises(ValueError, match="`output` must be"):
        model.plot_bode("f0", "v0")
    with pytest.raises(ValueError, match="`unit` must be one of 'rad/s', 'Hz', got 'rpm'"):
        model.plot_bode("f0", "x0", unit="rpm")
    with pytest.raises(TypeError, match="`axes` must be Matplotlib Axes, got None among them"):
        model.plot_bode("f0", "x0", axes=[None, None])


@pytest.mark.parametrize(
    ("interpolation", "stiffness"), [("previous", [3.0, 5.0, 5.0]), ("linear", [4.0, 5.0, 2.0])]
)
def test_a_model_has_the_samples_of_its_time(interpolation, stiffness):
    """A spring with k = 3, 5, -1 N/m at 0, 1, 2 s: x'' = -k x, between, at and after a sample."""
    x, k = me.dynamicsymbols("x k")
    frame, origin = inertial_frame()
    place = origin.locatenew("P", x * frame.x)
    spring = [(place, -k * x * frame.x)]
    oscillator = Definition(frame, [x], bodies=[me.Particle("mass", place, 1)], loads=spring)
    samples = SampledInput([0.0, 1.0, 2.0], [3.0, 5.0, -1.0], interpolation)
    system = System(oscillator, specifieds={k: samples})
    times = [0.5, 1.0, 1.5]
    model = system.linearize(np.zeros((3, 2)), times, inputs=[])
    np.testing.assert_allclose(model.A[:, 1, 0], np.negative(stiffness), rtol=1e-15)
    one = system.linearize([0.0, 0.0], 1.5, inputs=[])
    assert one.A[1, 0] == pytest.approx(-stiffness[2], rel=1e-15)


@pytest.mark.parametrize("force", [0.0, 1.0, -2.5])
def test_a_force_that_turns_with_a_bar_has_its_part_of_the_stiffness(force):
    """Ziegler's column: M = [[3, 1], [1, 1]], and a stiffness that is not symmetric under P."""
    damping = 0.2
    system = zieglers_pendulum(damping)
    system.constants = {**system.constants, "P": force}
    model = system.linearize()
    mass = np.array([[3.0, 1.0], [1.0, 1.0]])
    springs = np.array([[2.0, -1.0], [-1.0, 1.0]])
    stiffness = springs + force * np.array([[-1.0, 1.0], [0.0, 0.0]])
    np.testing.assert_allclose(mass @ model.A[2:, :2], -stiffness, atol=1e-14)
    np.testing.assert_allclose(mass @ model.A[2:, 2:], -damping * springs, atol=1e-14)


def test_poles_are_plotted():
    plt = pytest.importorskip("matplotlib.pyplot")
    model = multi_mass_spring_damper().linearize()
    axes = model.plot_poles()
    drawn = axes.collections[0].get_offsets()
    np.testing.assert_allclose(drawn, [[-0.5, 0.75**0.5], [-0.5, -(0.75**0.5)]], atol=1e-14)
    system = multi_mass_spring_damper()
    several = system.linearize(np.zeros((3, 2)), np.arange(3.0))
    assert len(several.plot_poles(axes).collections[1].get_offsets()) == 6
    plt.close("all")


@pytest.mark.parametrize("metre", [1e9, 1.0, 1e-7, 1e-12])
def test_a_constraint_of_squares_keeps_its_rank_in_any_units(metre):
    """A pendulum by its bob's place, hanging aside of a force along x: sqrt(hypot(3, 4) / l)."""
    x, y, v, w = me.dynamicsymbols("x y v w")
    ground, bob = me.ReferenceFrame("N"), me.Point("P")
    bob.set_vel(ground, v * ground.x + w * ground.y)
    kane = me.KanesMethod(
        ground, [x], [v],
        kd_eqs=[x.diff(zoo.T) - v, y.diff(zoo.T) - w],
        q_dependent=[y], configuration_constraints=[x**2 + y**2 - sm.Float(metre) ** 2],
        u_dependent=[w], velocity_constraints=[x * v + y * w],
        bodies=[me.Particle("P", bob, 1)],
        forcelist=[(bob, 3 * metre * ground.x - 4 * metre * ground.y)],
    )  # fmt: skip
    system = System(kane)
    system.initial_conditions = {x: 0.6 * metre, y: -0.8 * metre}
    values = np.sort_complex(system.linearize().eigenvalues)
    assert values == pytest.approx(np.array([-1j, 1j]) * np.sqrt(5.0), rel=1e-6, abs=1e-6)


def test_angles_and_lengths_are_chosen_alike_in_any_units():
    """Where the named angle cannot be solved for, a length was taken in SI, else an angle."""
    chosen = set()
    for metre in (1e-6, 1.0, 1e9):
        a, b, x, u, w, v = me.dynamicsymbols("a b x u w v")
        l, m = sm.symbols("l m")
        frame, origin = inertial_frame()
        ends = [origin.locatenew("A", l * sm.cos(a) * frame.x + l * sm.sin(a) * frame.y)]
        ends.append(ends[0].locatenew("B", l * sm.cos(b) * frame.x + l * sm.sin(b) * frame.y))
        ends.append(origin.locatenew("C", x * frame.y))
        linkage = Definition(
            frame, [a, b, x], [u, w, v],
            bodies=[me.Particle(end.name, end, m) for end in ends],
            holonomic_constraints=[l * sm.sin(a) + l * sm.sin(b) - x],
            dependent_coordinates=[a], dependent_speeds=[u],
        )  # fmt: skip
        system = System(linkage, constants={l: 0.5 * metre})
        start = {a: np.pi / 2, b: 0.3, x: 0.5 * metre * (1.0 + np.sin(0.3))}
        system.initial_conditions = start
        chosen.add(system.linearize().states)
    assert len(chosen) == 1


@pytest.mark.parametrize("metre", [1e-6, 1.0, 1e9])
def test_feedback_of_a_function_is_differentiated_alike_in_any_units(metre):
    """In nanometres the step was so short that a weight's rounding was taken for the slope."""
    system = multi_mass_spring_damper(apply_external_forces=True)
    system.specifieds = {"f0": lambda x, t: 3e6 * metre - 100.0 * x[0]}
    assert system.linearize().A[1, 0] == pytest.approx(-101.0, rel=1e-7)


@pytest.mark.parametrize("start", [1e-17, 5e-324])
def test_feedback_is_differentiated_where_a_state_is_zero_but_for_rounding(start):
    system = multi_mass_spring_damper(apply_external_forces=True)
    system.specifieds = {"f0": lambda x, t: 3.0 - 100.0 * x[0]}
    assert system.linearize({"x0": start}).A[1, 0] == pytest.approx(-101.0, rel=1e-7)


@pytest.mark.parametrize(
    "constraints",
    [
        {},
        {"holonomic_constraints": lambda p, q: p - sm.sqrt(q)},
        {"velocity_constraints": lambda p, q: p.diff() - q.diff() / p},
    ],
)
@pytest.mark.parametrize("function", [False, True])
def test_what_is_not_finite_is_an_error_and_no_warning_of_numpy(constraints, function):
    p, q, force = me.dynamicsymbols("p q F")
    N, O = inertial_frame()
    P = O.locatenew("P", p * N.x + q * N.y)
    row = {kind: [of(p, q)] for kind, of in constraints.items()}
    load = (P, (force + 1 / p) * N.x + N.y / q)
    system = System(Definition(N, [p, q], bodies=[me.Particle("b", P, 1)], loads=[load], **row))
    system.outputs = {"y": 1 / p}
    if function:
        system.specifieds = {force: lambda x, t: -x[0]}
    for outputs in (None, ["y"]):
        with pytest.raises(ValueError, match=r"not finite|cannot be solved"):
            system.linearize(outputs=outputs)
    if not function:
        with pytest.raises(ValueError, match=r"not finite|cannot be solved"):
            system.eigenvalues({force: [0.0, 1.0]}, at=np.zeros(4))


def on_a_line(force, at):
    """A particle that a force pushes, at x, with the input F and the constant k."""
    x, push = me.dynamicsymbols("x F")
    k = sm.Symbol("k")
    frame, place = me.ReferenceFrame("N"), me.Point("P")
    place.set_vel(frame, x.diff() * frame.x)
    bodies, loads = [me.Particle("b", place, 1)], [(place, force(x, push, k) * frame.x)]
    system = System(Definition(frame, [x], bodies=bodies, loads=loads))
    system.constants = dict.fromkeys(system.constants_symbols, 1.0)
    system.initial_conditions = {x: at}
    return system


@pytest.mark.parametrize(
    ("force", "at", "what"),
    [
        (
            lambda x, F, k: -k * sm.Abs(x),
            0.0,
            r"x\(t\) = 0: .* slope -1 on one side .* 1 on",
        ),
        (
            lambda x, F, k: -k * sm.Max(k, x),
            1.0,
            r"x\(t\) = 1: .* slope -?[01] .* and -?[01] on the",
        ),
        (
            lambda x, F, k: sm.Piecewise((-x, x < 0), (-3 * k * x, True)),
            0.0,
            "slope -[13] .* -[13]",
        ),
        (lambda x, F, k: -k * x - sm.sign(x.diff()), 0.0, r"\(x\(t\), t\) = 0: .* jumps by 2"),
        (lambda x, F, k: -k * x + sm.Max(F, 0), 0.5, r"F\(t\) = 0: .* slope [01] .* and [01] on"),
    ],
)
def test_a_kink_is_told_with_its_place_and_both_slopes(force, at, what):
    system = on_a_line(force, at)
    with pytest.warns(PyDyUserWarning, match=what) as told:
        system.linearize(at={})  # not about the motion from there
    assert len(told) == 1
    system.linearize({"x": at + 0.1, system.speeds[0]: 0.1}, inputs=[])


@pytest.mark.parametrize(
    "force",
    [
        lambda x, F, k: -k * x * sm.Abs(x),
        lambda x, F, k: -k * sm.Max(0, x) ** sm.Rational(3, 2),
        lambda x, F, k: -k * sm.sin(sm.atan2(x, -1)),
        lambda x, F, k: sm.Piecewise((-k * x, x < 0), (-k * sm.sin(x), True)),
        lambda x, F, k: sm.Piecewise((-x, k < 1), (-2 * x, True)),
        lambda x, F, k: -x * sm.Abs(k - 1),
    ],
)
def test_what_is_smooth_is_not_told_of(force):
    on_a_line(force, 0.0).linearize()  # a warning would be an error


def test_a_model_away_from_equilibrium_is_warned_of():
    """The eigenvalues of a pendulum at an angle of 1.2 are not those at rest."""
    system = n_link_pendulum_on_cart(1, cart_force=False)
    rest = np.sort_complex(system.linearize().eigenvalues)
    system.initial_conditions = {"q1": 1.2}
    with pytest.warns(UserWarning, match=r"no equilibrium: .* Pass the result of .* `at=\{\}` if"):
        tilted = system.linearize()
    assert np.abs(np.sort_complex(tilted.eigenvalues) - rest).max() > 0.1
    close(system.linearize({}).A, tilted.A)
    close(system.linearize(t=0.0).A, tilted.A)
    system.initial_conditions = {"q1": 3.14159, "u0": 2.0}  # typed digits; a cart that rolls
    system.linearize()


def test_a_body_that_falls_has_one_model_all_along():
    x, v = me.dynamicsymbols("x v")
    frame, origin = inertial_frame()
    place = origin.locatenew("P", x * frame.y)
    ball = me.Particle("ball", place, 2)
    system = System(Definition(frame, [x], [v], bodies=[ball], loads=[(place, -20 * frame.y)]))
    close(system.linearize().A, [[0.0, 1.0], [0.0, 0.0]])


@pytest.mark.parametrize("speed", [0.0, 4.6])
def test_a_bicycle_that_rolls_steadily_is_not_warned_of(speed):
    made, compiled = bicycle()
    system = System(made.definition, constants=compiled.constants)
    x = upright(made, system, [speed])[0]
    system.initial_conditions = dict(zip(system.states, x, strict=True))
    close(system.linearize().A, system.linearize(x).A)


def car_on_a_road():
    x, u, z = me.dynamicsymbols("x, u, z")
    m, k, c = sm.symbols("m, k, c")
    frame, wheel = me.ReferenceFrame("N"), me.Point("W")
    wheel.set_vel(frame, u * frame.x)
    loads = [(wheel, (k * (z - x) + c * (z.diff() - u)) * frame.x)]
    bodies = [me.Particle("car", wheel, m)]
    kane = me.KanesMethod(frame, [x], [u], [x.diff() - u], bodies=bodies, forcelist=loads)
    return System(kane, {m: 2.0, k: 100.0, c: 5.0}), x, z


def test_the_response_to_a_motion_is_the_sum_of_those_to_its_derivatives():
    system, x, z = car_on_a_road()
    omega = np.array([1.0, 7.0, 30.0])
    model = system.linearize(inputs=[z, z.diff()], outputs=x)
    by_height, by_velocity = model.frequency_response(omega)[:, 0].T
    exact = (100.0 + 5.0j * omega) / (100.0 - 2.0 * omega**2 + 5.0j * omega)
    np.testing.assert_allclose(by_height + 1j * omega * by_velocity, exact, rtol=1e-13)


def test_a_motion_without_its_derivative_as_input_is_warned_of():
    system, _, z = car_on_a_road()
    message = r"without its derivative `Derivative\(z\(t\), t\)`.* up to 2.5 per unit: the response"
    with pytest.warns(PyDyUserWarning, match=message):
        system.linearize(inputs=z)
    with pytest.warns(PyDyUserWarning, match=message):
        system.linearize(inputs="z", outputs="x")
    system.linearize()  # all specifieds are inputs by default; a warning would be an error
    system.linearize(inputs=z.diff())
    system.constants["c"] = 0.0  # the derivative has no effect
    system.linearize(inputs=z)


def test_a_contact_that_is_open_has_no_damping():
    """Its penetration Max(−x, 0) is zero wherever it is open, so that no side is to be chosen."""
    x, v = me.dynamicsymbols("x v")
    stiffness, damping = sm.symbols("k c")
    frame, origin = me.ReferenceFrame("N"), me.Point("O")
    origin.set_vel(frame, 0)
    place = origin.locatenew("P", x * frame.x)
    deep = sm.Max(-x, 0)
    push = sm.Piecewise((stiffness * deep - damping * v, deep > 0), (0, True)) - 4 * (x - 2)
    ball = me.Particle("ball", place, 1)
    system = System(
        Definition(frame, [x], [v], bodies=[ball], loads=[(place, push * frame.x)]),
        constants={stiffness: 50.0, damping: 3.0}, initial_conditions={x: 2.5},
        times=np.linspace(0.0, 2.0, num=5), ode_solver="dop853",
    )  # fmt: skip
    np.testing.assert_array_equal(system.linearize({x: 2.0}).A, [[0, 1], [-4, 0]])
    np.testing.assert_array_equal(system.linearize({x: -0.1}).A, [[0, 1], [-54, -3]])
    motion = system.simulate(sensitivities=[damping], rtol=1e-10, atol=1e-10)
    np.testing.assert_allclose(motion["x"], 2 + np.cos(2 * system.times) / 2, atol=1e-8)
    np.testing.assert_array_equal(motion.sensitivity["x", damping], np.zeros(5))


def test_a_string_that_pulls_or_not_is_no_kink_of_what_depends_on_its_pull():
    """Above its support a heavy bob at low speed presses on a rod, and would leave a string."""
    x, y, u, v = me.dynamicsymbols("x y u v")
    drag = sm.Symbol("c")
    frame, support = me.ReferenceFrame("N"), me.Point("O")
    support.set_vel(frame, 0)
    bob = support.locatenew("P", x * frame.x + y * frame.y)
    kane = me.KanesMethod(
        frame, [x], [u], kd_eqs=[x.diff() - u, y.diff() - v], q_dependent=[y], u_dependent=[v],
        configuration_constraints=[sm.sqrt(x**2 + y**2) - 2], velocity_constraints=[x * u + y * v],
        bodies=[me.Particle("bob", bob, 3)],
        forcelist=[(bob, -30 * frame.y - drag * (u * frame.x + v * frame.y))],
    )  # fmt: skip
    system = System(kane, constants={drag: 0.5}, times=np.linspace(0.0, 0.4, num=5))
    pull = -system.constraint_forces["lambda0"]
    height = np.sqrt(4.0 - 0.6**2)
    for side, (by_x, by_u) in ((1.0, (3.0, 1.8)), (-1.0, (0.0, 2.0))):
        # The pull is −side 30 cos(angle) + 3·u²/(2 cos²), of which the second is below 2.
        state = np.array([0.6, side * height, 1.0, -side * 0.6 / height])
        for condition in (sm.Max(pull, 0) > 0, pull + sm.Abs(pull) > 0):
            system.outputs = {"wear": sm.Piecewise((u**2, condition), (3 * x * u, True))}
            jacobian = system.evaluate_jacobian(state, of="outputs")[0]
            np.testing.assert_allclose(jacobian, [by_x, 0.0, by_u, 0.0], atol=1e-14)
            gradient = system.evaluate_gradient("wear", state)
            np.testing.assert_allclose(gradient, [by_x, 0.0, by_u, 0.0], atol=1e-14)
            C = system.linearize(state, outputs="wear").C
            np.testing.assert_allclose(C, [[by_x, by_u]], atol=1e-14)
        system.initial_conditions = dict(zip(system.states, state, strict=True))
        system.ode_solver = "dop853"
        motion = system.simulate(sensitivities=[drag], rtol=1e-11, atol=1e-11)
        x_of, u_of = motion["x"], motion["u"]
        by_drag = {name: motion.sensitivity[name, drag] for name in ("x", "u", "wear")}
        expected = {
            1.0: 3.0 * (by_drag["x"] * u_of + x_of * by_drag["u"]),
            -1.0: 2.0 * u_of * by_drag["u"],
        }[side]
        np.testing.assert_allclose(by_drag["wear"], expected, rtol=1e-12, atol=1e-15)
        gradient = system.adjoint_gradient([drag], final="wear", rtol=1e-11, atol=1e-11)
        np.testing.assert_allclose(gradient[drag], expected[-1], rtol=1e-7)
