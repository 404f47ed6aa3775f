"""Functions of a system in JAX and PyTorch: values, derivatives both ways, and many at a time."""

import pickle

import numpy as np
import pytest
import sympy as sm
import sympy.physics.mechanics as me

from layers.libraries import Jax, Torch
from pydy.contact import Contacts
from pydy.errors import IntegrationError, PyDyUserWarning
from pydy.inputs import SampledInput
from pydy.layers import motions
from pydy.layers.layer import ArgumentPart
from pydy.mechanics import Definition, Implicit
from pydy.models import multi_mass_spring_damper, n_link_pendulum_on_cart
from pydy.solvers import Event
from pydy.system import System
from zoo import inertial_frame
from zoo.touching import ball, e, y

TIGHT = {"rtol": 1e-10, "atol": 1e-10}
X = np.array([0.1, 0.4, -0.3, 0.2, 1.0, 0.5])


@pytest.fixture(params=[Jax, Torch], ids=["jax", "torch"])
def library(request):
    return request.param()


def pendulum(links=2):
    system = n_link_pendulum_on_cart(links)
    system.constants = {"g": 9.81, "m1": 0.5}
    system.initial_conditions = {"q1": 0.3, "q0": 0.1}
    system.times = np.linspace(0.0, 1.0, num=11)
    system.ode_solver = "dop853"
    return system


def close(found, expected, tolerance=1e-12):
    np.testing.assert_allclose(np.asarray(found), expected, rtol=tolerance, atol=tolerance)


def test_values_are_those_of_the_system(library):
    system = pendulum()
    system.outputs = {sm.Symbol("twice"): 2 * system.coordinates[1]}
    layer, x = library.layer(system), library.array(X)
    assert (np.asarray(layer.ode(x)) == system.evaluate_ode(X)).all()
    assert (np.asarray(layer.ode()) == system.evaluate_ode()).all()
    assert (np.asarray(layer.outputs(x)) == system.evaluate_outputs(X)).all()
    found = layer.ode(x, r={"F": 2.0}, p={"m1": 0.7, "l0": 1.5})
    expected = system.evaluate_ode(X, r={"F": 2.0}, p={"m1": 0.7, "l0": 1.5})
    assert (np.asarray(found) == expected).all()
    many = np.stack([X, 2 * X, 3 * X])
    found = layer.ode(library.array(many), p={"m1": library.array([0.5, 0.6, 0.7])})
    expected = [
        system.evaluate_ode(x, p={"m1": m}) for x, m in zip(many, (0.5, 0.6, 0.7), strict=True)
    ]
    close(found, expected)


def test_a_layer_comes_back_from_a_pickle_before_and_after_it_is_called(library):
    layer = library.layer(pendulum())
    again = pickle.loads(pickle.dumps(layer))
    found = np.asarray(layer.final(p={"m1": 0.7}))
    later = pickle.loads(pickle.dumps(layer))
    for other in (again, later):
        assert (np.asarray(other.final(p={"m1": 0.7})) == found).all()


def test_derivatives_of_the_equations_are_the_compiled_ones(library):
    system = pendulum()
    layer, w, v = library.layer(system), np.arange(6.0), np.linspace(1.0, 2.0, 6)
    p = np.array([system.constants.get(s.name, 1.0) for s in system.model.layout.constants])
    weights = library.array(w)

    found = library.grad(lambda x: (weights * layer.ode(x)).sum(), library.array(X))
    close(found, system.evaluate_vector_jacobian(w, X))
    found = library.grad(lambda p: (weights * layer.ode(library.array(X), p=p)).sum(),
                         library.array(p))  # fmt: skip
    close(found, system.evaluate_vector_jacobian(w, X, wrt="constants"))
    found = library.jvp(lambda x: layer.ode(x), library.array(X), library.array(v))
    close(found, system.evaluate_jacobian_vector(v, X))
    found = library.jvp(lambda f: layer.ode(library.array(X), r={"F": f, }),
                        library.array(0.0), library.array(1.0))  # fmt: skip
    close(found, system.evaluate_jacobian(X, wrt=["F"])[:, 0])


def test_time_moves_expressions_and_samples(library):
    system = pendulum(1)
    (force,) = system.specifieds_symbols
    t, x = 0.37, np.array([0.1, 0.2, 0.3, 0.4])
    by_force = system.evaluate_jacobian(x, wrt=[force])[:, 0]
    for given, slope in (
        (sm.sin(3 * sm.Symbol("t")), 3 * np.cos(3 * t)),
        (SampledInput([0.0, 0.2, 0.6, 1.0], [0.0, 1.0, 0.0, 2.0]), -2.5),
    ):
        system.specifieds = {force: given}
        layer = library.layer(system)

        def f(t, layer=layer):
            return layer.ode(library.array(x), t)

        close(library.jvp(f, library.array(t), library.array(1.0)), by_force * slope)
        found = library.grad(lambda t, f=f: f(t)[3], library.array(t))
        close(found, by_force[3] * slope)
    # A number in place of the samples does not move.
    found = library.grad(
        lambda t: layer.ode(library.array(x), t, r={"F": 1.0})[3], library.array(t)
    )
    assert found == 0.0


def test_the_gradient_of_the_last_state_is_the_adjoint_one(library):
    system = pendulum()
    layer = library.layer(system, **TIGHT)
    names = ("g", "l0", "l1", "m0", "m1", "m2")
    p = library.array([9.81, 1.0, 1.0, 1.0, 0.5, 1.0])
    expected = system.adjoint_gradient([*names], final="q2", **TIGHT)
    found = library.grad(lambda p: layer.final(p=dict(zip(names, p, strict=True)))[2], p)
    close(found, [expected[name] for name in names])
    close(layer.final()[2], expected.value)
    x = library.array([0.1, 0.3, 0.0, 0.0, 0.0, 0.0])
    close(library.grad(lambda x: layer.final(x)[2], x), expected.by_state)


def test_the_gradient_along_the_motion_is_that_of_the_sensitivities(library):
    system = pendulum()
    layer = library.layer(system, **TIGHT)
    trajectory = system.simulate(sensitivities=["m1", "q1"], **TIGHT)
    # Columns may shorten a few steps, those of one parameter others than those of two.
    close(layer.simulate(), trajectory.states, 1e-9)
    weights = np.random.default_rng(1).normal(size=trajectory.states.shape)
    expected = np.einsum("tnk,tn->k", trajectory.sensitivity.values[:, :6], weights)

    def cost(values):
        m1, q1 = values
        return (library.array(weights) * layer.simulate(x={"q1": q1}, p={"m1": m1})).sum()

    close(library.grad(cost, library.array([0.5, 0.3])), expected)
    found = library.jvp(lambda m: layer.simulate(p={"m1": m}), library.array(0.5),
                        library.array(2.0))  # fmt: skip
    close(found, 2.0 * trajectory.sensitivity.values[:, :6, 0], 1e-8)
    found = library.jvp(lambda m: layer.final(p={"m1": m}), library.array(0.5), library.array(1.0))
    close(found, trajectory.sensitivity.values[-1, :6, 0], 1e-8)


def test_many_samples_are_one_ensemble(library, monkeypatch):
    system, calls = pendulum(), []
    layer = library.layer(system, **TIGHT)
    ensemble = motions.integrate_ensemble
    monkeypatch.setattr(
        motions, "integrate_ensemble", lambda *a, **k: calls.append(k) or ensemble(*a, **k)
    )
    masses = np.array([0.5, 0.7, 0.9])

    def cost(m):
        return layer.simulate(p={"m1": m})[-1, 2]

    found = library.vmap(cost)(library.array(masses))
    assert len(calls) == 1
    gradients = library.vmapped_grad(cost)(library.array(masses))
    for k, mass in enumerate(masses):
        system.constants["m1"] = mass
        one = system.simulate(sensitivities=["m1"], **TIGHT)
        close(found[k], one["q2"][-1])
        close(gradients[k], one.sensitivity["q2", "m1"][-1], 1e-11)
        by_adjoint = library.vmapped_grad(lambda m: layer.final(p={"m1": m})[2])
        close(by_adjoint(library.array(masses[k : k + 1])), [float(gradients[k])], 1e-11)


def test_equations_at_many_states_are_one_call(library):
    system = pendulum()
    system.times = []
    layer, many = library.layer(system), np.stack([X, 2 * X, 3 * X])
    close(library.vmap(layer.ode)(library.array(many)), system.evaluate_ode(many))
    w = library.array([0.0, 0.0, 0.0, 0.0, 0.0, 1.0])
    found = library.vmapped_grad(lambda x: (w * layer.ode(x)).sum())(library.array(many))
    close(found, system.evaluate_jacobian(many)[:, 5])
    masses = library.array([0.5, 0.6, 0.6])
    found = library.vmapped_grad(lambda m: layer.ode(library.array(X), p={"m1": m})[5])(masses)
    expected = [system.evaluate_jacobian(X, wrt=["m1"], p={"m1": m})[5, 0] for m in (0.5, 0.6, 0.6)]
    close(found, expected)


@pytest.mark.parametrize("interpolation", ["linear", "previous"])
def test_samples_of_an_input_are_parameters(library, interpolation):
    system = pendulum(1)
    (force,) = system.specifieds_symbols
    samples = np.array([0.0, 1.0, -1.0, 0.5])
    times = [0.0, 0.3, 0.6, 1.0]
    system.specifieds = {force: SampledInput(times, 0 * samples, interpolation)}
    layer = library.layer(system, **TIGHT)
    system.specifieds = {force: SampledInput(times, samples, interpolation)}
    expected = system.adjoint_gradient([force], final="q1", **TIGHT)
    found = library.grad(lambda f: layer.final(r={"F": f})[1], library.array(samples))
    close(found, expected.values)
    with pytest.raises(ValueError, match=r"`r\[F\]` must have the shape \(…, 4\), .* got \(3,\)"):
        layer.final(r={"F": library.array(samples[:3])})
    system.specifieds = {force: 0.5}
    close(layer.final(r=library.array([0.5])), system.integrate(**TIGHT)[-1])


def test_dependent_initial_conditions_follow_the_constants(library):
    import zoo
    from zoo.cases import system_of

    system = system_of(zoo.MODELS["track"](), times=np.linspace(0.0, 0.5, num=3))
    system.ode_solver = "dop853"
    system.set_dependent_initial_conditions()
    layer = library.layer(system, **TIGHT)
    expected = system.adjoint_gradient("constants", final=system.states[0], **TIGHT)
    names = [*expected.names]
    known = {str(symbol): value for symbol, value in system.constants.items()}
    values = [float(known[name]) for name in names]
    found = library.grad(
        lambda p: layer.final(p=dict(zip(names, p, strict=True)))[0], library.array(values)
    )
    close(found, expected.values)


def test_a_layer_is_of_the_system_as_it_was(library):
    system = pendulum()
    layer = library.layer(system, **TIGHT)
    before = np.asarray(layer.final())
    rates = np.asarray(layer.ode())
    system.constants["m1"] = 3.0
    system.initial_conditions.update({"q1": 1.0, "q0": 0.0})
    system.times = [0.0, 5.0]
    assert (np.asarray(layer.final()) == before).all()
    assert (np.asarray(layer.ode()) == rates).all()
    layer.simulate(p={"m1": library.array(2.0)})
    assert system.constants["m1"] == 3.0


def test_after_a_terminal_event_states_are_nan_and_the_last_is_that_of_the_event(library):
    system = multi_mass_spring_damper()
    x0, v0 = system.states
    system.constants = {"c0": 0.0}
    system.initial_conditions = {x0: 1.0}
    system.times = np.linspace(0.0, 3.0, num=7)
    system.ode_solver = "dop853"
    event = Event(x0, terminal=True)
    layer = library.layer(system, events=[event], **TIGHT)
    states = np.asarray(layer.simulate())
    assert np.isfinite(states[:4]).all()
    assert np.isnan(states[4:]).all()
    expected = system.adjoint_gradient(["k0"], final=v0, events=[event], **TIGHT)
    close(layer.final()[1], -1.0, 1e-8)
    found = library.grad(lambda k: layer.final(p={"k0": k})[1], library.array(1.0))
    close(found, expected["k0"])
    close(found, -0.5, 1e-8)  # the speed at the end is √k
    many = layer.final(p={"k0": library.array([1.0, 4.0, 0.01])})  # the last meets no event
    close(many[:2, 1], [-1.0, -2.0], 1e-8)
    close(many[2, 0], np.cos(0.3), 1e-8)
    with pytest.raises(Exception, match="a terminal event ended the motion"):
        library.jvp(lambda k: layer.final(p={"k0": k}), library.array(1.0), library.array(1.0))
    several = library.array([1.0, 0.01])  # the first ends at π/2, the second goes on
    with pytest.raises(Exception, match="a terminal event ended the motion"):
        library.jvp(lambda k: layer.final(p={"k0": k}), several, several)
    rows = library.grad(lambda k: layer.simulate(p={"k0": k})[:, 2, 0].sum(), several)
    close(rows, [-0.5 * np.sin(1.0), -5.0 * np.sin(0.1)], 1e-8)


@pytest.mark.filterwarnings("ignore:.*accumulate")
def test_where_events_accumulate_the_last_state_is_that_of_one_alone(library):
    y, v = me.dynamicsymbols("y v")
    frame, origin = inertial_frame()
    ball = origin.locatenew("P", y * frame.y)
    definition = Definition(frame, [y], [v], bodies=[me.Particle("b", ball, 1)],
                            loads=[(ball, -sm.Symbol("g") * frame.y)])  # fmt: skip
    system = System(definition, initial_conditions={y: 1.0}, times=[0.0, 6.0],
                    ode_solver="dop853")  # fmt: skip
    bounce = Event(y, direction=-1, reset={v: -v / 2})
    layer = library.layer(system, events=[bounce], **TIGHT)
    found = np.asarray(layer.final(p={"g": library.array([9.81, 9.81])}))
    np.testing.assert_allclose(found, 0.0, atol=1e-9)


def test_a_sample_that_fails_is_nan_among_others(library):
    system = multi_mass_spring_damper()
    system.initial_conditions = {"x0": 1.0}
    system.times = [0.0, 100.0]
    system.ode_solver = "dop853"
    layer = library.layer(system, max_steps=100)
    found = np.asarray(layer.final(p={"k0": library.array([1e-4, 1e8])}))
    assert np.isfinite(found[0]).all()
    assert np.isnan(found[1]).all()


@pytest.mark.filterwarnings("ignore:The holonomic constraints did not converge")
def test_a_sample_whose_dependent_conditions_fail_is_nan_among_others(library):
    x, y, v, w = me.dynamicsymbols("x y v w")
    g, length = sm.symbols("g l")
    frame, origin = inertial_frame()
    bob = origin.locatenew("P", x * frame.x + y * frame.y)
    definition = Definition(
        frame, [x, y], [v, w], bodies=[me.Particle("b", bob, 1)], loads=[(bob, -g * frame.y)],
        holonomic_constraints=[x**2 + y**2 - length**2],
    )  # fmt: skip
    system = System(definition, times=[0.0, 0.2], ode_solver="dop853")
    system.initial_conditions = {x: 0.6, y: -0.8}
    system.set_dependent_initial_conditions([x, v])
    layer, lengths = library.layer(system, constraints="project"), library.array([1.0, 0.1])

    def last(size):
        return layer.final(p={"l": size})[0]

    found, slopes = library.vmap(last)(lengths), library.vmapped_grad(last)(lengths)
    for values in (found, slopes, library.vmap(lambda s: layer.simulate(p={"l": s}))(lengths)):
        finite = np.isfinite(np.asarray(values).reshape(2, -1))
        assert finite[0].all()
        assert not finite[1].any()
    with pytest.raises(Exception, match="do not satisfy the constraints"):
        np.asarray(last(0.1))


def test_initial_conditions_that_follow_from_others_are_not_replaced_without_a_word(library):
    x, y, v, w = me.dynamicsymbols("x y v w")
    frame, origin = inertial_frame()
    bob = origin.locatenew("P", x * frame.x + y * frame.y)
    definition = Definition(
        frame, [x, y], [v, w], bodies=[me.Particle("b", bob, 1)],
        holonomic_constraints=[x**2 + y**2 - 1],
    )  # fmt: skip
    system = System(definition, times=[0.0, 0.2], ode_solver="dop853")
    system.initial_conditions = {x: 0.6, y: -0.8}
    system.set_dependent_initial_conditions([y, w])
    layer = library.layer(system, constraints="project")
    for function in (layer.simulate, layer.final):
        with pytest.raises(ValueError, match=r"initial condition of w\(t\).* solved for y\(t\), w"):
            function({v: library.array(1.0), w: library.array(0.75)})
    # Without loads the bob goes along the circle with its initial speed: from (0, -1) by 0.2 rad.
    start = {x: 0.0, y: -1.0, v: 1.0, w: 0.0}
    found = layer.final({symbol: library.array(value) for symbol, value in start.items()})
    close(found, [np.sin(0.2), -np.cos(0.2), np.cos(0.2), np.sin(0.2)], 1e-6)


def test_a_list_of_numbers_keeps_the_derivatives_of_those_in_it(library):
    system = multi_mass_spring_damper()  # x' = v, m v' = −k x − c v
    layer = library.layer(system)

    def rate(k):
        return layer.ode([2.0, 3.0], 0.0, p=[0.5, k, k])[1] + k

    close(library.grad(rate, library.array(0.8)), 1.0 + 0.5 * 3.0 / 0.8**2)
    rows = layer.ode([[2.0, 3.0]], 0.0, p=[[0.5, library.array(0.8), 0.8]])
    close(rows, [[3.0, -2.0 - 0.5 * 3.0 / 0.8]])


def test_an_input_that_was_a_function_may_be_given(library):
    system = multi_mass_spring_damper(2, apply_external_forces=True)
    system.times = [0.0, 0.5]
    first, second = system.specifieds_symbols
    system.specifieds = {(first, second): lambda x, t: np.array([t, 3.0])}
    layer = library.layer(system)
    system.specifieds = {first: 2.0, second: 3.0}
    expected = system.simulate().states
    close(layer.final(r={first: 2.0}), expected[-1], 1e-6)
    close(layer.simulate(r={first: 2.0}), expected, 1e-6)
    close(layer.final(r=library.array([2.0, 3.0])), expected[-1], 1e-6)


def test_a_number_replaces_an_expression_with_constants_of_its_own(library):
    system, stiffness = pendulum(), sm.Symbol("stiffness")
    (force,) = system.specifieds_symbols
    system.specifieds = {force: -stiffness * system.coordinates[0]}
    system.constants["stiffness"] = 3.0
    layer = library.layer(system, **TIGHT)
    p = {"stiffness": library.array(2.0)}  # an argument still, without an effect
    states = [np.asarray(layer.simulate(r={"F": 0.5}, p=p)),
              np.asarray(layer.simulate(r=library.array([0.5])))]  # fmt: skip
    sum_of_last = library.grad(lambda p: layer.final(r={"F": 0.5}, p={"stiffness": p}).sum(),
                               library.array(2.0))  # fmt: skip
    assert sum_of_last == 0.0
    del system.constants["stiffness"]
    system.specifieds = {force: 0.5}
    expected = system.simulate(**TIGHT).states
    for found in states:
        close(found, expected, 1e-9)


def test_bad_arguments_are_named(library):
    system = pendulum()
    layer = library.layer(system)
    with pytest.raises(ValueError, match=r"`x` must have the shape \(…, 6\), .* got \(5,\)"):
        layer.ode(library.array(X[:5]))
    with pytest.raises(ValueError, match="`p` has the key `mass`, which is not one of the const"):
        layer.ode(p={"mass": 1.0})
    with pytest.raises(ValueError, match="`p` must have at least one entry"):
        layer.ode(p={})
    with pytest.raises(ValueError, match="The system has no outputs"):
        layer.outputs()
    system.times = []
    with pytest.raises(ValueError, match="`times` must have at least two values before `final`"):
        library.layer(system).final()


def test_functions_for_specifieds_have_values_but_no_derivatives(library):
    system = pendulum()
    (force,) = system.specifieds_symbols
    system.specifieds = {force: lambda x, t: -x[0]}
    layer = library.layer(system)
    close(layer.ode(library.array(X)), system.evaluate_ode(X))
    with pytest.raises(Exception, match=r"but F\(t\) is a Python function|function for F"):
        library.grad(lambda x: layer.ode(x).sum(), library.array(X))
    found = library.grad(lambda x: layer.ode(x, r={"F": 0.0}).sum(), library.array(X))
    system.specifieds = {}
    close(found, system.evaluate_vector_jacobian(np.ones(6), X))


def test_second_derivatives_are_refused(library):
    layer, x = library.layer(pendulum()), library.array(X)
    if library.name == "as_jax":
        second = library.jax.hessian(lambda x: layer.ode(x).sum())
    else:
        second = library.torch.func.grad(
            lambda x: library.torch.func.grad(lambda y: layer.ode(y).sum())(x).sum()
        )
    with pytest.raises(NotImplementedError, match="first derivatives only"):
        second(x)


def test_pytorch_s_own_derivatives_bind_no_signatures(monkeypatch):
    """To bind arguments to a signature takes longer than the equations of a small system."""
    import inspect

    library = Torch()
    layer, w = library.layer(pendulum()), library.array(np.arange(6.0))
    x = library.array(X).requires_grad_()
    bound, bind = [], inspect.Signature.bind
    monkeypatch.setattr(
        inspect.Signature, "bind", lambda *a, **k: (bound.append(a), bind(*a, **k))[1]
    )
    layer.ode(x).backward(w)
    assert not bound
    close(x.grad, pendulum().evaluate_vector_jacobian(np.arange(6.0), X))


def test_pytorch_s_own_second_and_mixed_derivatives_are_refused():
    library = Torch()
    torch, layer = library.torch, library.layer(pendulum())
    x = library.array(X).requires_grad_()
    (slope,) = torch.autograd.grad(layer.ode(x).sum(), x, create_graph=True)
    with pytest.raises(NotImplementedError, match="first derivatives only"):
        slope.sum().backward()
    weights = library.array(np.ones(6))
    with torch.autograd.forward_ad.dual_level():
        dual = torch.autograd.forward_ad.make_dual(weights, weights)
        with pytest.raises(Exception, match=r"jvp|forward mode"):
            torch.autograd.grad(layer.ode(x), x, dual)


def test_pytorch_s_forward_mode_needs_no_torch_func():
    library = Torch()
    forward, system = library.torch.autograd.forward_ad, pendulum()
    v = np.linspace(1.0, 2.0, 6)
    with forward.dual_level():
        value = library.layer(system).ode(forward.make_dual(library.array(X), library.array(v)))
        found = forward.unpack_dual(value).tangent.numpy()
    close(found, system.evaluate_jacobian_vector(v, X))


def test_single_precision_is_refused():
    library = Jax()
    layer, jax = library.layer(pendulum()), library.jax
    with pytest.raises(TypeError, match="`x` must be of float64, got float32"):
        layer.ode(jax.numpy.asarray(X, dtype="float32"))
    with jax.enable_x64(False), pytest.raises(TypeError, match=r"update\('jax_enable_x64', True\)"):
        pendulum().as_jax()


def test_tensors_of_single_precision_are_refused():
    library = Torch()
    layer = library.layer(pendulum())
    with pytest.raises(TypeError, match=r"`p\[m1\]` must be of float64, got torch.float32"):
        layer.ode(p={"m1": library.torch.tensor(0.5)})


def test_a_missing_library_is_named(monkeypatch):
    import sys

    for name in ("jax", "torch"):
        monkeypatch.setitem(sys.modules, name, None)
        with pytest.raises(ImportError, match=rf"`as_{name}` needs {name}, .* 'pydy\[{name}\]'"):
            getattr(pendulum(), f"as_{name}")()


def test_what_residuals_give_is_no_longer_that_of_before(library):
    x, v, z = me.dynamicsymbols("x v z")
    k, c = sm.symbols("k c")
    frame, origin = inertial_frame()
    place = origin.locatenew("P", x * frame.x)
    definition = Definition(frame, [x], [v], bodies=[me.Particle("b", place, 1)],
                            loads=[(place, -k * z * frame.x)])  # fmt: skip
    system = System(definition, times=[0.0, 1.0], ode_solver="dop853", initial_conditions={x: 1.0},
                    implicit=Implicit({z: z + z**3 - x - c}))  # fmt: skip
    layer = library.layer(system)
    two = library.array(2.0)
    for given in ({"x": {"x": two}}, {"p": {"c": two}}):
        with pytest.raises(ValueError, match="`x` must be an array of whole states"):
            layer.ode(**given)
    close(layer.ode(p={"k": two}), [0.0, 0.0, -2.0])  # z = 1 depends on x and c
    close(layer.ode(library.array([8.0, 2.0, 0.0]), p={"c": two})[2], -2.0)
    several = {"c": library.array([1.1, 1.155, 1.21])}
    before = np.asarray(layer.final(p=several))
    layer.final(p={"c": library.array(1.1)})  # leaves no unknowns that another call begins with
    assert (np.asarray(layer.final(p=several)) == before).all()


def test_the_way_back_tells_of_jumps_that_derivatives_miss():
    x, force = me.dynamicsymbols("x"), sm.Symbol("F")
    frame, point = me.ReferenceFrame("N"), me.Point("P")
    point.set_vel(frame, x.diff() * frame.x)
    loads = [(point, -force * sm.sign(x) * frame.x)]
    definition = Definition(frame, [x], bodies=[me.Particle("b", point, 1)], loads=loads)
    system = System(definition, {force: 1.0}, initial_conditions={x: 1.0}, times=[0.0, 2.0])
    functions = system._layer_functions(None, {})
    function = functions.function("final", (ArgumentPart("p", (0,), (1,), False),))
    with pytest.warns(PyDyUserWarning, match="the load on .* jumps by 2,"):
        function.backward((0,), (np.ones(1),), np.ones(2))


def test_motions_with_contacts_and_their_derivatives(library):
    system, floor = ball(restitution=e)
    system.initial_conditions, system.times = {y: 1.0}, np.linspace(0.0, 0.7, num=8)
    contacts = Contacts(system, [floor], {e: 0.8})
    layer = library.layer(system, contacts=contacts, **TIGHT)
    fall, v = np.sqrt(2.0 / 9.81), np.sqrt(2.0 * 9.81)
    s = 0.7 - fall  # after the impact: y = e v s − g s²/2
    close(layer.final(p={"e": 0.8}), [0.8 * v * s - 9.81 * s**2 / 2, 0.8 * v - 9.81 * s], 1e-8)
    close(layer.simulate(), contacts.simulate(**TIGHT).states, 0.0)

    def height(e):
        return layer.final(p={"e": e})[0]

    def from_above(y):
        return layer.simulate(x={"y": y})[-1, 0]

    values = library.array([0.6, 0.8])
    close(library.grad(height, library.array(0.8)), v * s, 1e-8)
    close(library.vmapped_grad(height)(values), [v * s, v * s], 1e-8)
    close(library.jvp(height, library.array(0.8), library.array(2.0)), 2.0 * v * s, 1e-8)
    by_height = 0.8 * (9.81 * s / v - 1.0) + 9.81 * s / v  # v' = g/v, s' = −1/v
    close(library.grad(from_above, library.array(1.0)), by_height, 1e-8)
    above, below = (float(from_above(library.array(h))) for h in (1.0 + 1e-4, 1.0 - 1e-4))
    close(by_height, (above - below) / 2e-4, 1e-6)


def test_a_layer_with_contacts_is_of_the_system_as_it_was(library):
    system, floor = ball(restitution=e)
    system.initial_conditions, system.times = {y: 1.0}, np.linspace(0.0, 0.7, num=8)
    contacts = Contacts(system, [floor], {e: 0.8})
    layer = library.layer(system, contacts=contacts, **TIGHT)
    before = contacts.simulate(**TIGHT).states
    system.outputs = {"twice": 2 * y}
    system.constants[e] = 0.5
    system.initial_conditions = {y: 2.0}
    close(layer.simulate(), before, 0.0)
    several = layer.simulate(p={"e": library.array([0.8, 0.8])})
    close(several, [before, before], 0.0)
    assert contacts.simulate(**TIGHT)["twice"][0] == 4.0


def test_contacts_of_a_layer_are_those_of_its_system(library):
    (system, floor), (other, _) = ball(), ball()
    with pytest.raises(TypeError, match="`contacts` must be Contacts of this System"):
        library.layer(other, contacts=Contacts(system, [floor]))


@pytest.mark.parametrize("value", [["1.0"] * 6, "abc", [[1.0], [1.0, 2.0]], 1j])
def test_what_is_no_array_of_numbers_is_refused_by_the_name_of_the_argument(library, value):
    layer = library.layer(pendulum())
    with pytest.raises(ValueError, match="`p` must hold real numbers"):
        layer.ode(X, p=value)


def test_no_samples_give_no_derivatives(library):
    layer = library.layer(pendulum())
    assert np.asarray(layer.ode(library.array(np.empty((0, 6))))).shape == (0, 6)


def test_an_error_of_a_simulation_is_raised_as_it_is(library):
    system = pendulum(1)
    layer, zero = library.layer(system), library.array(0.0)
    message = r"^`dop853` met a singular mass matrix .* constant `m1`, which is zero"
    with pytest.raises(IntegrationError, match=message):
        layer.final(p={"m0": zero, "m1": zero})
    with pytest.raises(IntegrationError, match=message):
        layer.simulate(p={"m0": zero, "m1": zero})


def test_a_compiled_function_ends_its_message_with_the_error_of_the_simulation():
    library = Jax()
    layer, jax = library.layer(pendulum(1)), library.jax
    with pytest.raises(jax.errors.JaxRuntimeError) as caught:
        jax.block_until_ready(jax.jit(lambda m: layer.final(p={"m0": m, "m1": m}))(0.0))
    assert "\nIntegrationError: `dop853` met a singular mass matrix" in str(caught.value)
    assert "motions.py" not in str(caught.value)  # the frames of this package are left out
