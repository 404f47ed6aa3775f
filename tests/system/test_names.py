"""Names in place of symbols, and symbols of one name that differ in their assumptions."""

import itertools
import warnings

import numpy as np
import pytest
import sympy as sm
import sympy.physics.mechanics as me

import zoo
from pydy.analysis import Trial
from pydy.codegen.ode_function_generators import generate_ode_function
from pydy.errors import PyDyUserWarning, UnsupportedFunctionError
from pydy.inputs import SampledInput
from pydy.models import multi_mass_spring_damper, n_link_pendulum_on_cart
from pydy.plot import plot_coordinates
from pydy.solvers import Event
from pydy.system import System
from zoo.cases import close

M, HEAVY = sm.Symbol("m"), sm.Symbol("m", positive=True)
M0, K0, F0 = sm.Symbol("m0"), sm.Symbol("k0"), me.dynamicsymbols("f0")
X, V = me.dynamicsymbols("x v")


def two_masses(first=M, second=HEAVY, **options):
    """A mass on a spring, of which `first` is the mass and `second` the stiffness."""
    frame, point = me.ReferenceFrame("N"), me.Point("P")
    point.set_vel(frame, V * frame.x)
    kane = me.KanesMethod(frame, [X], [V], [X.diff() - V])
    kane.kanes_equations([me.Particle("B", point, first)], [(point, -second * X * frame.x)])
    return System(kane, **options)


@pytest.fixture
def system():
    return multi_mass_spring_damper(apply_external_forces=True)


# names


def test_names_stand_for_symbols_everywhere(system):
    x0, v0 = system.states
    m0, k0, c0 = sm.symbols("m0 k0 c0")
    (f0,) = system.specifieds_symbols
    system.times = [0.0, 0.5, 1.0]
    system.constants = {m0: 2.0, k0: 3.0, c0: 0.5}
    system.initial_conditions = {x0: 0.5, v0: -0.25}
    system.specifieds = {f0: 1.5}
    expected = system.integrate()
    system.constants = {"m0": 2.0, "k0": 3.0, c0: 0.5}
    system.initial_conditions = {"x0": 0.5, "v0(t)": -0.25}
    for specifieds in ({"f0": 1.5}, {"f0(t)": 1.5}, {("f0",): [1.5]}, {"f0": sm.Float(1.5)}):
        system.specifieds = specifieds
        close(system.integrate(), expected, 1e-14)
    system.specifieds = {"symbols": ["f0"], "values": [1.5]}
    close(system.integrate(), expected, 1e-14)
    close(system.evaluate_ode(p={"k0": 4.0}, r={"f0": 0.0}), [-0.25, (-4 * 0.5 + 0.5 * 0.25) / 2])


def test_an_expression_is_given_by_name(system):
    system.specifieds = {"f0": sm.Symbol("gain") * system.states[0]}
    system.constants = {"gain": 3.0}
    close(system.evaluate_ode([1.0, 0.0]), [0.0, 2.0])


def test_a_name_edited_in_place_counts(system):
    system.constants["k0"] = 7.0
    close(system.evaluate_ode([1.0, 0.0]), [0.0, -7.0])
    system.constants["nope"] = 1.0
    with pytest.raises(ValueError, match="`nope`, which is not one of the constants"):
        system.evaluate_ode()


@pytest.mark.parametrize(
    ("argument", "values", "expected"),
    [
        ("constants", {M0: 9.0, "m0": 4.0}, 0.0),
        ("constants", {"m0": 9.0, M0: 4.0}, 0.0),
        ("initial_conditions", {"x0": 9.0, "x0(t)": 2.0}, -2.0),
        ("initial_conditions", {me.dynamicsymbols("x0"): 9.0, "x0": 2.0}, -2.0),
        ("specifieds", {F0: 9.0, "f0": 3.0}, 3.0),
        ("specifieds", {F0: lambda x, t: 9.0, "f0": 3.0}, 3.0),
        ("specifieds", {F0: 9.0, "f0": lambda x, t: 3.0}, 3.0),
        ("specifieds", {F0: sm.Symbol("gain"), "f0": 3.0}, 3.0),
        ("specifieds", {"f0": SampledInput([0.0, 1.0], [9.0, 9.0]), F0: 3.0}, 3.0),
    ],
)
def test_of_a_symbol_and_its_name_the_later_value_stands(system, argument, values, expected):
    setattr(system, argument, values)
    close(system.evaluate_ode()[1], expected)
    assert sm.Symbol("gain") not in system.constants_symbols
    known = getattr(system, argument)
    assert len({str(known[key]) for key in values}) == 1  # by the symbol and by the name
    known[next(iter(values))] = 0.5
    assert all(known[key] == 0.5 for key in values)


def test_merged_dictionaries_are_taken_wherever_values_are(system):
    m0, both = sm.Symbol("m0"), {sm.Symbol("m0"): 9.0, "m0": 2.0}
    system.specifieds = {"f0": 3.0}
    system.times, system.ode_solver = [0.0, 1.0], "dop853"
    close(system.evaluate_ode(p=both), [0.0, 1.5])
    close(system.evaluate_ode({"v0": 9.0, "v0(t)": 2.0}), [2.0, 1.0])
    close(system.evaluate_ode(r={F0: 9.0, "f0": 4.0}), [0.0, 4.0])
    results = system.integrate_ensemble(constants={m0: [9.0, 9.0], "m0": [1.0, 2.0]})
    close(results.m0, [1.0, 2.0])
    system.constants = both
    assert "m0 = 2" in str(system)
    close(system.simulate().constants[m0], 2.0)


@pytest.mark.parametrize("merge", [dict, lambda view: {**view}, lambda view: view.copy()])
def test_the_last_of_several_merges_stands(system, merge):
    system.specifieds = {"f0": 3.0}
    for first, *keys in itertools.product([M0, "m0"], repeat=3):
        system.constants = {M0: 9.0, "m0": 8.0} if first == M0 else {"m0": 9.0, M0: 8.0}
        for key, mass in zip(keys, (1.0, 2.0), strict=True):
            values = merge(system.constants)
            values[key] = mass
            system.constants = values
            close(system.evaluate_ode()[1], 3.0 / mass)


def test_a_view_of_a_merged_dictionary_has_one_key_for_a_symbol_and_its_name(system):
    system.constants = {M0: 9.0, "m0": 2.0, "k0": 5.0}
    assert system.constants == {"m0": 2.0, "k0": 5.0}
    assert (len(system.constants), repr(system.constants)) == (2, "{'m0': 2.0, 'k0': 5.0}")
    del system.constants[M0]
    assert system.constants == {"k0": 5.0}  # the 9 does not come back
    system.initial_conditions = {"x0": 9.0, "x0(t)": 2.0}
    assert system.initial_conditions.pop("x0") == 2.0
    close(system.evaluate_ode(), [0.0, 0.0])


def test_a_specified_in_two_tuples_is_refused(system):
    for values in ({(F0,): [1.0], ("f0",): [2.0]}, {(F0,): [1.0], "f0": 2.0}):
        with pytest.raises(ValueError, match=r"`specifieds` gives `f0\(t\)` more than once"):
            system.specifieds = values


def test_a_symbol_and_its_name_are_one_key(system):
    x0, v0 = system.states
    m0 = sm.Symbol("m0")
    (f0,) = system.specifieds_symbols
    own = {x0: 0.5}
    system.initial_conditions = own
    system.initial_conditions["x0"] = 0.3
    assert own == system.initial_conditions == {x0: 0.3}
    assert system.initial_conditions["x0(t)"] == 0.3
    assert "x0" in system.initial_conditions
    assert v0 not in system.initial_conditions
    system.constants["m0"] = 2.0
    system.constants[m0] = 4.0
    assert system.constants == {"m0": 4.0}
    system.specifieds = {f0: 1.0}
    system.specifieds["f0"] = 2.0
    close(system.evaluate_ode(), [0.0, (2.0 - 0.3) / 4.0])
    both = system.constants | {m0: 5.0, "k0": 2.0}
    assert both == {"m0": 5.0, "k0": 2.0}
    assert system.constants == {"m0": 4.0}
    system.constants |= {m0: 6.0}
    assert system.constants == {"m0": 6.0}
    del system.specifieds["f0(t)"], system.constants[m0]
    close(system.evaluate_ode(), [0.0, -0.3])
    system.outputs = {"twice": 2 * x0}
    system.outputs["twice"] = 4 * x0
    close(system.evaluate_outputs(), [1.2])


def test_an_assignment_that_drops_constants_is_told_once():
    system = multi_mass_spring_damper(1)
    system.constants = {M0: 3.0, "k0": 2.0}
    text = "`constants` was assigned without m0 = 3: .* 1.0 again.*system.constants.update"
    with pytest.warns(PyDyUserWarning, match=text):
        system.constants = {"k0": 4.0}
    system.constants = {"k0": 5.0}  # nothing is lost
    system.constants = {}  # deliberately
    system.constants = {M0: 3.0}


def test_nothing_is_told_of_values_that_stay_or_are_the_defaults():
    system = multi_mass_spring_damper(1)
    system.constants = {"m0": 3.0, "k0": 1.0}
    system.constants = {sm.Symbol("m0"): 5.0, "c0": 1.0}
    system.constants = {**system.constants, "m0": 2.0}
    assert system.constants["m0"] == 2.0


def test_symbols_of_one_name_stay_two_keys():
    with pytest.warns(PyDyUserWarning, match="several symbols of one name"):
        system = two_masses()
    system.constants[M] = 2.0
    system.constants[HEAVY] = 6.0
    assert system.constants == {M: 2.0, HEAVY: 6.0}
    close(system.evaluate_ode([1.0, 0.0]), [0.0, -3.0])
    with pytest.raises(KeyError):
        system.constants["m"]


def test_an_output_may_be_called_like_a_residual():
    system = System(zoo.fourbar().kane)
    residuals = dict(system.outputs)
    system.outputs["c0"] = system.coordinates[0]
    assert residuals.items() <= dict(system.outputs).items()


def test_a_fit_takes_symbols_and_names_together(system):
    x0, v0 = system.states
    system.ode_solver, system.times = "dop853", np.linspace(0.0, 2.0, 11)
    samples = np.cos(np.sqrt(2.0) * system.times)
    system.constants = {sm.Symbol("m0"): 7.0, "c0": 0.0, sm.Symbol("k0"): 1.5}
    system.initial_conditions = {x0: 0.5, v0: 0.0}
    known = {"initial_conditions": {"x0": 1.0}, "constants": {"m0": 1.0}}
    trial = Trial(system.times, {"x0": samples}, noise={x0: 0.1}, **known)
    found = system.fit([sm.Symbol("k0")], trial, bounds={"k0": (1.0, 5.0)})
    close(found.estimates, [2.0], 1e-7)
    with pytest.raises(ValueError, match=r"gives `x0\(t\)` more than once, by the symbol"):
        system.fit("k0", Trial(system.times, {"x0": samples, x0: samples}))


@pytest.mark.parametrize(
    "call",
    [
        lambda s, both, trial: s.fit("k0", trial({}), bounds={"k0": (1, 2), K0: (1, 3)}),
        lambda s, both, trial: s.fit("k0", trial({}), priors={"k0": (1, 2), K0: (1, 3)}),
        lambda s, both, trial: s.fit("k0", trial({"noise": both})),
        lambda s, both, trial: s.fit("k0", trial({"unknown": [*both]})),
        lambda s, both, trial: s.fit(["k0", K0], trial({})),
        lambda s, both, trial: s.find_equilibrium(given=both),
        lambda s, both, trial: s.find_equilibrium(bounds=dict.fromkeys(both, (-1, 1))),
        lambda s, both, trial: s.find_equilibrium(moving=[*both]),
        lambda s, both, trial: s.find_periodic_orbit(1.0, moving=[*both]),
        lambda s, both, trial: s.linearize(inputs=["f0", F0]),
        lambda s, both, trial: s.linearize(outputs=[*both]),
        lambda s, both, trial: plot_coordinates(s.simulate(), units=dict.fromkeys(both, "")),
    ],
)
def test_nothing_takes_a_symbol_and_its_name_together(system, call):
    x0 = system.coordinates[0]
    system.ode_solver, system.times = "dop853", np.linspace(0.0, 2.0, 11)
    with pytest.raises(
        ValueError, match=r"gives `.*` more than once, by the symbol or by its name"
    ):
        call(
            system, {x0: 1.0, "x0": 2.0},
            lambda more: Trial(system.times, {"x0": np.cos(system.times)}, **more),
        )  # fmt: skip


def test_outputs_have_names(system):
    x0, v0 = system.states
    system.outputs = {"speed": v0, ("twice", "thrice"): (2 * x0, 3 * x0)}
    assert system.outputs_symbols == list(sm.symbols("speed twice thrice"))
    close(system.evaluate_outputs([1.0, 5.0]), [5.0, 2.0, 3.0])
    system.outputs["half"] = x0 / 2
    close(system.evaluate_outputs([1.0, 5.0]), [5.0, 2.0, 3.0, 0.5])


def test_an_outputs_name_is_that_of_the_symbol_in_its_own_equation(system):
    a = me.dynamicsymbols("a")
    system.outputs = {"a": a - system.speeds[0].diff()}
    assert system.outputs_symbols == [a]


def test_an_output_and_its_name_together_are_refused(system):
    with pytest.raises(ValueError, match="`outputs` gives `speed` more than once"):
        system.outputs = {"speed": X, sm.Symbol("speed"): X}


def test_dependent_states_are_given_by_name():
    model = zoo.fourbar()
    dependent = [*model.kane._qdep, *model.kane._udep]
    free = {s: v for s, v in model.start.items() if s not in dependent}
    guess = {str(s): v for s, v in model.start.items()}
    system = System(model.kane, constants=model.constants, initial_conditions=guess)
    system.set_dependent_initial_conditions([str(s) for s in dependent])
    assert {str(s) for s in system.initial_conditions} == {str(s) for s in system.states}
    assert all(system.initial_conditions[str(s)] == v for s, v in free.items())
    assert np.abs(system.evaluate_constraints()).max() < 1e-8


@pytest.mark.parametrize("names", [["m0", "k0", "c0"], [sm.Symbol("m0"), "k0", "c0"]])
def test_constants_symbols_may_be_names(system, names):
    again = System(system.eom_method, constants_symbols=names, specifieds_symbols=["f0"])
    assert again.constants_symbols == set(sm.symbols("m0 k0 c0"))
    assert again.specifieds_symbols == set(system.specifieds_symbols)


def test_time_is_no_constant(system):
    with pytest.raises(ValueError, match="`constants_symbols` has `t`, which is time"):
        System(system.eom_method, constants_symbols=[me.dynamicsymbols._t])


def test_a_constant_whose_symbol_is_the_time_is_named():
    # It used to be told that it cancels.
    with pytest.raises(ValueError, match=r"`t` is the time, `dynamicsymbols\._t`"):
        two_masses(me.dynamicsymbols._t, constants={me.dynamicsymbols._t: 2.0})


def test_a_function_of_another_symbol_for_time_is_named():
    force = sm.Function("F")(sm.Symbol("t", real=True))
    with pytest.raises(
        UnsupportedFunctionError, match=r"other assumptions than `dynamicsymbols\._t`"
    ):
        two_masses(second=force)


def test_ensembles_take_names(system):
    times = np.linspace(0.0, 1.0, num=3)
    x0 = system.states[0]
    by_symbol = system.integrate_ensemble(initial_conditions={x0: [1.0, 2.0]}, times=times)
    by_name = system.integrate_ensemble(
        initial_conditions={"x0": [1.0, 2.0]}, constants={"k0": 1.0}, times=times
    )
    close(by_name.x0.values, by_symbol.x0.values, 1e-15)
    pushed = system.integrate_ensemble(specifieds={"f0": [0.0, 2.0]}, times=times)
    assert pushed.sizes["sample"] == 2
    with pytest.raises(ValueError, match="`initial_conditions` has the key `nope`"):
        system.integrate_ensemble(initial_conditions={"nope": [1.0, 2.0]}, times=times)


def test_generate_ode_function_takes_names_of_symbols_in_the_equations():
    k = sm.Symbol("k")
    rhs = generate_ode_function([V, -k * X / HEAVY], ["x"], [V], ["k", "m"])
    close(rhs([0.5, 1.0], 0.0, [4.0, 2.0]), [1.0, -1.0])
    with pytest.raises(ValueError, match="`constants` has the key `nope`"):
        generate_ode_function([V, -k * X], [X], [V], ["k", "nope"])


@pytest.mark.parametrize("argument", ["constants", "specifieds"])
def test_time_is_no_argument_of_a_generated_function(argument):
    t = sm.Symbol("t")
    with pytest.raises(ValueError, match=f"`{argument}` has `t`, which is time in the equations"):
        generate_ode_function([V, -t * X], [X], [V], **{argument: [t]})


# one name, different assumptions


def test_two_constants_of_one_name_are_named_with_what_differs():
    with pytest.warns(PyDyUserWarning, match=r"several symbols of one name: m, m \(positive\)"):
        system = two_masses()
    assert str(system.constants_symbols) == "{m, m (positive)}"
    system.constants = {M: 2.0, HEAVY: 6.0}
    close(system.evaluate_ode([1.0, 0.0]), [0.0, -3.0])
    assert "- m (positive)\n" in system.generate_ode_function().__doc__
    with pytest.raises(ValueError, match=r"'m', which several constants .*: m, m \(positive\)"):
        system.constants = {"m": 2.0}


def test_constants_of_one_name_are_in_the_order_of_their_assumptions():
    for first, second in ((M, HEAVY), (HEAVY, M)):
        with pytest.warns(PyDyUserWarning, match=r"m, m \(positive\)"):
            assert list(two_masses(first, second).constants_symbols) == [M, HEAVY]


def test_the_warning_of_one_name_comes_once():
    with pytest.warns(PyDyUserWarning, match="several symbols of one name"):
        system = two_masses()
    system.outputs = {"e": M * V**2 / 2}
    system.evaluate_outputs()


def test_a_constant_of_other_assumptions_in_an_output_warns():
    system = two_masses(sm.Symbol("b"), HEAVY)
    with pytest.warns(PyDyUserWarning, match=r"several symbols of one name: m, m \(positive\)"):
        system.outputs = {"e": M * V**2 / 2}


def test_another_symbol_for_time_in_an_expression_warns():
    system = multi_mass_spring_damper(apply_external_forces=True)
    with pytest.warns(PyDyUserWarning, match=r"of one name: t, t \(real\)"):
        system.specifieds = {"f0": sm.sin(sm.Symbol("t", real=True))}


def test_a_constant_of_other_assumptions_as_a_key_is_named():
    system = two_masses(sm.Symbol("b"), HEAVY)
    with pytest.raises(ValueError, match=r"got m, known is m \(positive\).*its name 'm'"):
        system.constants = {M: 2.0}


def test_a_coordinate_of_other_assumptions_as_a_key_is_named():
    system = two_masses(sm.Symbol("b"), HEAVY)
    with pytest.raises(ValueError, match=r"got x\(t\) \(real\), known is x\(t\)"):
        system.initial_conditions = {me.dynamicsymbols("x", real=True): 1.0}


def test_nothing_of_one_name_is_dropped_from_a_trajectory():
    with pytest.warns(PyDyUserWarning, match="several symbols of one name"):
        system = two_masses(constants={M: 2.0, HEAVY: 6.0}, times=[0.0, 1.0])
    data = system.simulate().to_xarray()
    assert (float(data["m"]), float(data["m (positive)"])) == (2.0, 6.0)


def test_nothing_of_one_name_is_dropped_from_an_ensemble():
    with pytest.warns(PyDyUserWarning, match="several symbols of one name"):
        system = two_masses(constants={M: 2.0})
    data = system.integrate_ensemble(constants={HEAVY: [3.0, 6.0]}, times=[0.0, 1.0])
    assert float(data["m"]) == 2.0
    assert data["m (positive)"].values.tolist() == [3.0, 6.0]


def test_outputs_of_one_name_keep_their_columns():
    system = n_link_pendulum_on_cart(1, cart_force=False)
    first, second = sm.Symbol("e"), sm.Symbol("e", real=True)
    system.times = [0.0, 1.0]
    with pytest.warns(PyDyUserWarning, match=r"several symbols of one name: e, e \(real\)"):
        system.outputs = {first: sm.Integer(1), second: sm.Integer(2)}
    trajectory = system.simulate()
    assert set(trajectory.to_xarray()) >= {"e", "e (real)"}
    assert (trajectory[first][0], trajectory[second][0]) == (1.0, 2.0)


def test_a_trajectory_does_not_mix_up_symbols():
    system = two_masses(sm.Symbol("b"), HEAVY, times=[0.0, 1.0])
    trajectory = system.simulate()
    with pytest.raises(KeyError, match=r"x\(t\) \(real\)` is not one .* assumptions differ"):
        trajectory[me.dynamicsymbols("x", real=True)]
    assert trajectory["x"].shape == (2,)


def test_symbols_of_different_kinds_may_share_a_name():
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        system = two_masses(sm.Symbol("x"), HEAVY, times=[0.0, 1.0])
    with pytest.raises(ValueError, match="not one of the states"):
        system.initial_conditions = {sm.Symbol("x"): 1.0}


def test_a_name_that_is_nearly_one_is_answered_with_it(system):
    with pytest.raises(ValueError, match=r"'k00' is a str, .* Did you mean `k0`"):
        system.constants = {"k00": 1.0}


def test_a_reset_of_another_symbol_of_the_same_name_says_what_is_meant(system):
    system.ode_solver, system.times = "dop853", [0.0, 1.0]
    other = me.dynamicsymbols("v0", real=True)
    with pytest.raises(ValueError, match=r"got v0\(t\) \(real\), known is v0\(t\)"):
        system.integrate(events=Event(system.states[0] - 1, reset={other: 0.0}))
    with pytest.raises(ValueError, match=r"'v01' is a str, .* Did you mean `v0`"):
        system.integrate(events=Event(system.states[0] - 1, reset={"v01": 0.0}))
