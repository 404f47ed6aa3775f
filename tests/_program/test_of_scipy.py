"""Functions that only SciPy computes: values, derivatives, and who takes them."""

import pickle
import subprocess
import sys

import mpmath
import numpy as np
import pytest
import sympy as sm
import sympy.physics.mechanics as me

from pydy.codegen.ode_function_generators import generate_ode_function
from pydy.errors import UnsupportedFunctionError
from pydy.models import multi_mass_spring_damper
from pydy.solvers import Event
from pydy.system import System

X, V = me.dynamicsymbols("x v")
A, K = sm.symbols("a k")
Z, N = sm.symbols("z n")

FUNCTIONS = {
    "gamma": sm.gamma(1 + X**2),
    "loggamma": sm.loggamma(2 + X),
    "polygamma": sm.polygamma(1, 1 + X),
    "besselj": sm.besselj(0, A * X),
    "besseli": sm.besseli(1, X),
    "LambertW": sm.LambertW(X),
    "Si": sm.Si(X),
    "fresnels": sm.fresnels(X),
    "airyai": sm.airyai(X),
    "uppergamma": sm.uppergamma(2, X),
    "beta": sm.beta(1 + X, A),
    "elliptic_k": sm.elliptic_k(X / 3),
    "elliptic_f": sm.elliptic_f(A, X / 3),
    "elliptic_e": sm.elliptic_e(X / 3),
    "elliptic_e, incomplete": sm.elliptic_e(X, A / 2),
    "Sum": sm.Sum(X**N / (N + A), (N, 0, 5)),
    "Integral": sm.Integral(sm.exp(-A * Z**2) * sm.cos(X * Z), (Z, 0, 2)),
    "Integral to a state": sm.Integral(sm.sin(Z**2), (Z, 0, X)),
    "Integral over a half line": sm.Integral(sm.exp(-Z * X), (Z, 0, sm.oo)),
}


def exact(expression, x, a):
    with mpmath.workdps(30):
        if isinstance(expression, sm.Integral):
            z, low, high = expression.limits[0]
            f = sm.lambdify([z, X, A], expression.function, "mpmath")
            low, high = (sm.lambdify([X], e, "mpmath")(mpmath.mpf(x)) for e in (low, high))
            return float(mpmath.quad(lambda z: f(z, mpmath.mpf(x), mpmath.mpf(a)), [low, high]))
        numbers = {X: sm.Float(x, 30), A: sm.Float(a, 30)}
        return float(expression.doit().xreplace(numbers).evalf(20))


@pytest.mark.parametrize("name", FUNCTIONS)
def test_values_are_those_of_mpmath(name):
    f = generate_ode_function(
        [V, FUNCTIONS[name] - 2 * X], [X], [V], [A], generator="lambdify", time_first=True
    )
    for x, a in ((0.7, 1.3), (1.9, 0.4)):
        found = f(0.0, np.array([x, 0.0]), np.array([a]))[1] + 2 * x
        assert found == pytest.approx(exact(FUNCTIONS[name], x, a), rel=1e-12)


def test_zeta_has_values_and_no_derivative():
    rates = [V, A * sm.zeta(1 + X)]
    f = generate_ode_function(rates, [X], [V], [A], generator="lambdify", time_first=True)
    assert f(0.0, np.array([0.7, 0.0]), np.array([1.0]))[1] == pytest.approx(
        float(mpmath.zeta(1.7)), rel=1e-14
    )
    system = particle(sm.zeta(1 + X))
    system.generate_ode_function(generator="lambdify")
    with pytest.raises(UnsupportedFunctionError, match="zeta"):
        system.evaluate_jacobian()


@pytest.mark.parametrize("generator", ["lambdify", "llvm"])
def test_a_finite_product_is_written_out(generator):
    product = sm.Product(X + N / A, (N, 1, 3))
    f = generate_ode_function([V, product], [X], [V], [A], generator=generator, time_first=True)
    found = f(0.0, np.array([0.7, 0.0]), np.array([2.0]))[1]
    assert found == pytest.approx((0.7 + 0.5) * (0.7 + 1.0) * (0.7 + 1.5), rel=1e-14)


def particle(load):
    ground, origin = me.ReferenceFrame("N"), me.Point("O")
    origin.set_vel(ground, 0)
    point = origin.locatenew("P", X * ground.x)
    point.set_vel(ground, V * ground.x)
    kane = me.KanesMethod(ground, [X], [V], [X.diff() - V])
    kane.kanes_equations([me.Particle("p", point, 1)], [(point, A * load * ground.x)])
    system = System(kane, constants={A: 1.3}, initial_conditions={X: 0.7})
    system.times = np.linspace(0.0, 0.5, num=6)
    return system


@pytest.mark.parametrize("name", FUNCTIONS)
def test_derivatives_are_those_of_mpmath(name):
    system = particle(FUNCTIONS[name])
    system.generate_ode_function(generator="lambdify")
    found = system.evaluate_jacobian()[1, 0]
    step = 1e-5
    values = [exact(FUNCTIONS[name], 0.7 + h, 1.3) for h in (-step, step)]
    assert found == pytest.approx(1.3 * (values[1] - values[0]) / (2 * step), rel=1e-6)


@pytest.mark.parametrize("solver", ["odeint", "RK45", "dop853", "radau"])
def test_motions_have_the_exact_period(solver):
    """x'' = −a J1(x) has the energy v²/2 − a J0(x)."""
    system = particle(-sm.besselj(1, X))
    system.generate_ode_function(generator="lambdify")
    system.ode_solver = solver
    x, v = system.integrate(rtol=1e-9, atol=1e-9).T
    energies = v**2 / 2 - 1.3 * np.array([float(mpmath.besselj(0, one)) for one in x])
    np.testing.assert_allclose(energies, energies[0], atol=1e-8)


def test_events_and_outputs_hold_them_too():
    system = particle(-1)
    system.outputs = {sm.Symbol("y"): sm.gamma(X + 2)}
    system.generate_ode_function(generator="lambdify")
    system.ode_solver = "dop853"
    run = system.simulate(events=Event(sm.gamma(X + 2) - sm.gamma(2.65)), rtol=1e-9, atol=1e-9)
    assert run["y"][0] == pytest.approx(float(mpmath.gamma(2.7)))
    assert run.events[0].time == pytest.approx(np.sqrt(2 * 0.05 / 1.3), rel=1e-6)


@pytest.mark.parametrize("generator", ["llvm", "cython"])
def test_other_generators_refuse_them_by_name(generator):
    with pytest.raises(
        UnsupportedFunctionError, match=r"the function `besselj` in `besselj\(0, .*'lambdify' takes"
    ):
        generate_ode_function([V, sm.besselj(0, X)], [X], [V], generator=generator)


@pytest.mark.parametrize(
    "use",
    [
        lambda s: s.integrate(),
        lambda s: s.evaluate_ode(),
        lambda s: s.integrate_ensemble(initial_conditions={X: [0.1, 0.2]}),
        lambda s: s.linearize(),
    ],
)
def test_a_system_says_which_generator_takes_them(use):
    system = particle(-sm.gamma(X + 2))
    with pytest.raises(UnsupportedFunctionError, match=r"the function `gamma` in .*'lambdify'"):
        use(system)


def test_ensembles_and_exports_refuse_them_where_the_system_takes_them(tmp_path):
    system = particle(-sm.gamma(X + 2))
    system.generate_ode_function(generator="lambdify")
    assert np.isfinite(system.evaluate_ode()).all()
    for use in (
        lambda: system.integrate_ensemble(initial_conditions={X: [0.1, 0.2]}),
        lambda: system.export(tmp_path / "own.c"),
    ):
        with pytest.raises(UnsupportedFunctionError, match="`gamma` in"):
            use()


def test_numbers_are_computed_once_and_compiled():
    f = generate_ode_function([V, sm.gamma(sm.Rational(1, 3)) * X], [X], [V])
    assert f([1.0, 0.0], 0.0, [])[1] == pytest.approx(float(mpmath.gamma(mpmath.mpf(1) / 3)))


def test_values_beyond_the_real_ones_are_nan():
    f = generate_ode_function([V, sm.LambertW(X)], [X], [V], generator="lambdify")
    assert np.isnan(f([-1.0, 0.0], 0.0, [])[1])
    assert f([-0.3, 0.0], 0.0, [])[1] == pytest.approx(float(mpmath.lambertw(-0.3).real))


def test_functions_are_made_again_in_another_process():
    f = generate_ode_function([V, sm.gamma(X + 2)], [X], [V], generator="lambdify")
    call = "import pickle, sys; print(pickle.load(sys.stdin.buffer)([0.7, 0.0], 0.0, [])[1])"
    done = subprocess.run(
        [sys.executable, "-c", call], input=pickle.dumps(f), capture_output=True, check=True
    )
    assert float(done.stdout) == f([0.7, 0.0], 0.0, [])[1]


def test_other_systems_are_cached_as_before():
    from pydy._assembly.program_cache import _as_shipped

    generate_ode_function([V, sm.gamma(X + 2)], [X], [V], generator="lambdify")
    assert _as_shipped()
    assert np.isfinite(multi_mass_spring_damper().evaluate_ode()).all()
