"""What a new process loads for its first result: modules are counted, times are benchmarks."""

import subprocess
import sys

import pytest

# Users load SymPy first; the modules that the first result adds are counted.
SCRIPT = """
import sys
import sympy as sm
import sympy.physics.mechanics as me
before = set(sys.modules)
from pydy.system import System
q, u = me.dynamicsymbols("q u")
m, g, l = sm.symbols("m g l")
N, O = me.ReferenceFrame("N"), me.Point("O")
A = N.orientnew("A", "Axis", (q, N.z))
A.set_ang_vel(N, u * N.z)
O.set_vel(N, 0)
P = O.locatenew("P", -l * A.y)
P.v2pt_theory(O, N, A)
kane = me.KanesMethod(N, [q], [u], kd_eqs=[q.diff() - u])
kane.kanes_equations([me.Particle("P", P, m)], [(P, -m * g * N.y)])
system = System(kane, {m: 1.0, g: 9.81, l: 0.7}, initial_conditions={q: 0.5}, times=[0.0, 1.0])
system.ode_solver = sys.argv[1]
system.integrate()
print(*(set(sys.modules) - before))
"""


@pytest.fixture(scope="module", params=["odeint", "dop853"])
def loaded(request):
    """The solver, and the modules that the first result of a process loads."""
    done = subprocess.run(
        [sys.executable, "-c", SCRIPT, request.param], capture_output=True, text=True, check=True
    )
    return request.param, done.stdout.split()


def test_only_what_integrates_is_loaded(loaded):
    modules = loaded[1]
    rooms = {".".join(name.split(".")[:2]) for name in modules}
    others = {
        f"pydy.{room}"
        for room in (
            *("analysis", "contact", "control", "ensemble", "examples", "export", "layers"),
            *("models", "plot", "robots", "viz"),
        )
    }
    assert not rooms & others
    packages = {name.split(".")[0] for name in modules}
    assert not packages & {"matplotlib", "xarray", "pandas", "PIL", "dask", "jsonschema"}


def test_native_solvers_load_no_package_of_scipy(loaded):
    solver, modules = loaded
    packages = {name for name in modules if name.count(".") == 1 and name.startswith("scipy.")}
    assert ("scipy.integrate" in packages) == (solver == "odeint")
    if solver != "odeint":
        assert not packages & {"scipy.linalg", "scipy.optimize", "scipy.sparse", "scipy.special"}


def test_few_modules_of_ours_are_loaded(loaded):
    solver, modules = loaded
    count = sum(name.startswith("pydy") for name in modules)
    assert count <= {"odeint": 204, "dop853": 215}[solver]


def test_the_collector_does_not_visit_all_objects_while_scipy_is_imported():
    # The last lines of the script make the first use of odeint.
    counted = (
        SCRIPT.replace("system.integrate()", "")
        + """
import gc
started = []
gc.callbacks.append(lambda phase, info: started.append(info["generation"]))
solver = system.ode_solver
assert "scipy.integrate" in sys.modules and gc.isenabled() and not started, started
"""
    )
    subprocess.run([sys.executable, "-c", counted, "odeint"], check=True)


def test_no_collection_runs_while_the_system_is_imported():
    counted = """
import gc
import pydy._collector
started = []
gc.callbacks.append(lambda phase, info: started.append(info["generation"]))
pydy.System
assert gc.isenabled() and not started, started
"""
    subprocess.run([sys.executable, "-c", counted], check=True)
