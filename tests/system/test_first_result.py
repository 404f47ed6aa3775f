"""What a new process loads for its first result: modules are counted, times are benchmarks."""

import subprocess
import sys

import pytest

from pydy._motion.lsoda import _compiled_module

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


def test_solvers_load_no_package_of_scipy(loaded):
    solver, modules = loaded
    if solver == "odeint" and _compiled_module() is None:
        pytest.skip("odeint is called by its public name in this release of SciPy")
    packages = {name.removeprefix("scipy.") for name in modules if name.count(".") == 1}
    assert not packages & {"integrate", "linalg", "optimize", "sparse", "special"}


ROBOT = """
import sys
from pydy.robots import read
system = read(sys.argv[1]).system()
system.times, system.ode_solver = [0.0, 1.0], "dop853"
system.integrate()
print(*(name for name in sys.modules if name.startswith("scipy.")))
"""
URDF = """<robot name='r'><link name='a'/><link name='b'><inertial>
<origin xyz='0 0 1' rpy='0.1 0 0'/><mass value='1'/>
<inertia ixx='1' iyy='1' izz='1' ixy='0' ixz='0' iyz='0'/></inertial></link>
<joint name='j' type='revolute'><parent link='a'/><child link='b'/><axis xyz='1 0 0'/>
<limit effort='1' velocity='1'/></joint></robot>"""


def test_a_robot_loads_no_package_of_scipy(tmp_path):
    (tmp_path / "r.urdf").write_text(URDF, "utf-8")
    script = [sys.executable, "-c", ROBOT, str(tmp_path / "r.urdf")]
    done = subprocess.run(script, capture_output=True, text=True, check=True)
    packages = {name.split(".")[1] for name in done.stdout.split()}
    assert not packages & {"integrate", "linalg", "optimize", "sparse", "spatial", "special"}


def test_few_modules_of_ours_are_loaded(loaded):
    solver, modules = loaded
    count = sum(name.startswith("pydy") for name in modules)
    assert count <= {"odeint": 205, "dop853": 216}[solver]


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
