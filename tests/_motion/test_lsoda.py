"""LSODA behind `odeint`, called without SciPy's package, and by it."""

import subprocess
import sys

import numpy as np
import pytest
import sympy as sm
from scipy.integrate import odeint

import pydy._motion.lsoda as ours
from pydy.errors import IntegrationError

TIMES = np.linspace(0.0, 10.0, num=41)
START = np.array([1.0, 0.5, -0.2])
MATRIX = np.array([[-1.0, 2.0, 0.0], [-2.0, -1.0, 0.5], [0.0, -0.5, -300.0]])


def rates(x, t, gain):
    return MATRIX @ x + gain * np.sin([t, x[0], 3.0 * t])


def gradient(x, t, gain):
    jacobian = MATRIX.copy()
    jacobian[1, 0] += gain * np.cos(x[0])
    return jacobian


OPTIONS = {
    "none": {},
    "tolerances": {"rtol": 1e-9, "atol": [1e-10, 1e-6, 1e-12]},
    "critical times": {"tcrit": np.array([1.0, 7.3]), "rtol": 1e-6},
    "steps": {"h0": 1e-5, "hmax": 0.1, "hmin": 1e-12, "mxstep": 5000, "mxhnil": 3, "ixpr": False},
    "orders": {"mxordn": 4, "mxords": 2},
    "gradient": {"Dfun": gradient},
    "columns of the gradient": {
        "Dfun": lambda x, t, gain: gradient(x, t, gain).T.copy(),
        "col_deriv": True,
    },
    "band": {"ml": 1, "mu": 1},
    "no band": {"ml": None, "mu": None, "rtol": None},
    "few steps": {"mxstep": 2},
    "no tolerance": {"rtol": 0.0, "atol": 1e-300},
}


@pytest.fixture
def compiled():
    module = ours._compiled_module()
    if module is None:
        pytest.skip("this release of SciPy was not compared")
    return module.odeint


@pytest.mark.parametrize("times", [TIMES, -TIMES, np.zeros(3)], ids=["forward", "back", "none"])
@pytest.mark.parametrize("name", OPTIONS)
@pytest.mark.filterwarnings("ignore::scipy.integrate.ODEintWarning")
def test_the_compiled_function_returns_the_bits_of_odeint(compiled, name, times):
    options = {**OPTIONS[name], "full_output": True}
    start = START.copy()
    states, info = ours._run_compiled(compiled, rates, start, times, (0.3,), **options)
    expected, statistics = odeint(rates, START, times, args=(0.3,), **options)
    assert info.keys() == statistics.keys()
    assert info["message"] == statistics["message"]
    assert (start == START).all()
    # Rows behind the end of what fails are not initialised.
    rows = slice(None if info["message"].startswith("Integration") else 1)
    np.testing.assert_array_equal(states[rows], expected[rows])
    for key in ("nst", "nfe", "nje", "tcur") if times.any() else ():  # else they are not, either
        np.testing.assert_array_equal(info[key][rows], statistics[key][rows])


SCRIPT = """
import sys
import numpy as np
from pydy.models import multi_mass_spring_damper
from pydy._motion.lsoda import COMPARED_UP_TO
if sys.argv[1] == "package":
    import scipy.integrate
system = multi_mass_spring_damper(2)
system.initial_conditions = {"x0": 1.0, "v1": 0.3}
system.times = np.linspace(0.0, 20.0, num=21)
print(system.integrate().tobytes().hex(), system.simulate(rtol=1e-9).states.tobytes().hex())
try:
    system.integrate(mxstep=2)
except Exception as error:
    print(type(error), error, error.states.tobytes().hex(), sorted(error.info))
try:
    system.integrate(hmx=1.0)
except TypeError as error:
    print(error)
system.specifieds = {}
other = multi_mass_spring_damper(1, apply_external_forces=True)
def force(x, t):
    system.integrate()
    return 0.0
other.specifieds, other.times = {"f0": force}, [0.0, 1.0]
try:
    other.integrate()
except RuntimeError as error:
    print(error)
import scipy
release = tuple(map(int, scipy.__version__.split(".")[:2]))
loaded = "scipy.integrate" in sys.modules
assert loaded == (sys.argv[1] == "package" or release > COMPARED_UP_TO), loaded
import scipy.integrate
assert system.ode_solver is scipy.integrate.odeint
print(system.integrate().tobytes().hex())
"""


def test_results_and_errors_are_the_same_with_and_without_the_package():
    results = [
        subprocess.run([sys.executable, "-c", SCRIPT, kind], capture_output=True, text=True)
        for kind in ("alone", "package")
    ]
    assert [result.returncode for result in results] == [0, 0], results[0].stderr
    alone, package = (result.stdout.splitlines() for result in results)
    assert alone == package
    assert len(alone) >= 5
    assert any("cannot be started by a function that `odeint` calls" in line for line in alone)


@pytest.mark.parametrize("sign", [1.0, -1.0], ids=["forward", "back"])
@pytest.mark.parametrize("public", [False, True])
@pytest.mark.filterwarnings("ignore::scipy.integrate.ODEintWarning")
def test_what_was_reached_is_returned_with_the_error_in_both_directions(sign, public):
    """x' = ±x² with x(0) = 1 is 1/(1 - |t|): LSODA gives up before the pole at |t| = 1."""
    times = sign * np.array([0.0, 0.5, 0.9, 1.1, 2.0, 3.0])
    options = {"rtol": 1e-10, "atol": 1e-10, "mxstep": 200}
    if public:
        options["printmessg"] = False
    with pytest.raises(IntegrationError) as told:
        ours.call_odeint(lambda x, t: sign * x**2, np.ones(1), times, (), [sm.Symbol("x")], options)
    error = told.value
    np.testing.assert_array_equal(error.times, times[:3])
    np.testing.assert_allclose(error.states[:, 0], [1.0, 2.0, 10.0], rtol=1e-7)
    assert error.info["reached"] == 3
    # The time at which it gave up, with its state.
    assert 0.9 < sign * error.time < 1.0
    assert error.state[0] == pytest.approx(1.0 / (1.0 - abs(error.time)), rel=1e-2)


def test_a_release_that_was_not_compared_is_called_by_its_public_name(monkeypatch):
    ours._compiled_module.cache_clear()
    monkeypatch.setattr("scipy.__version__", "2.0.0.dev0+git")
    try:
        assert ours._compiled_module() is None
    finally:
        ours._compiled_module.cache_clear()
