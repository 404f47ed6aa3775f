"""Tires in exported models compute what the published equations say: C, JavaScript, NumPy, FMU."""

import ctypes
import json
import shutil
import subprocess
import sys
from types import SimpleNamespace

import mpmath as mp
import numpy as np
import pytest
import sympy as sm
import sympy.physics.mechanics as me

from optional import optional
from pydy.mechanics import Definition
from pydy.system import System
from pydy.vehicles import MagicFormula
from zoo import inertial_frame, tires
from zoo.tires import NAMES, TIRES, slip_states

fmpy = optional("fmpy")
INPUTS = ("Fz", "kappa", "alpha", "gamma", "speed", "pressure")
OUTPUTS = [f"{name} of {tire}" for tire in TIRES for name in NAMES]
IN_JAVASCRIPT = """
import(process.argv[1]).then(({ default: model }) => {
  const given = JSON.parse(process.argv[2]);
  console.log(JSON.stringify(given.map((r) => {
    const out = new Float64Array(model.outputs.length);
    model.evaluateOutputs(0, new Float64Array(2), Float64Array.from(r), out);
    return Array.from(out);
  })));
});
"""
IN_NUMPY = """
import json, sys
sys.path.insert(0, sys.argv[1])
import numpy as np
import tires_in_numpy as model
rows = json.loads(sys.argv[2])
print(json.dumps([model.outputs(0.0, np.zeros(2), r, None).tolist() for r in rows]))
"""


@pytest.fixture(scope="module")
def case():
    """A System with the forces of five tires as outputs, its inputs, and what it should give."""
    inputs = me.dynamicsymbols(" ".join(INPUTS))
    N, O = inertial_frame()
    q, u = me.dynamicsymbols("q u")
    P = O.locatenew("P", q * N.x)
    P.set_vel(N, u * N.x)
    system = System(Definition(N, [q], [u], bodies=[me.Particle("P", P, sm.Symbol("m"))]))
    forces = []
    for version, equations, values in TIRES.values():
        tire = MagicFormula(values, version, equations=equations)
        forces += tire.forces(*inputs[:4], speed=inputs[4], pressure=inputs[5])
    system.outputs = {sm.Symbol(n): f for n, f in zip(OUTPUTS, forces, strict=True)}
    order = [INPUTS.index(str(s.func)) for s in system.specifieds_symbols]
    with mp.workdps(30):
        expected = np.array(
            [
                [float(v) for tire in TIRES for v in tires.magic_formula(tire, *state)]
                for state in slip_states()
            ]
        )
    return SimpleNamespace(system=system, inputs=slip_states()[:, order], expected=expected)


def assert_within_range(found, case):
    spans = np.where(np.ptp(case.expected, axis=0) > 0.0, np.ptp(case.expected, axis=0), 1.0)
    errors = np.abs(np.asarray(found) - case.expected).max(axis=0) / spans
    assert errors.max() <= 1e-10, OUTPUTS[int(errors.argmax())]


def test_numpy(case, tmp_path):
    case.system.export(tmp_path / "tires_in_numpy.py")
    rows = json.dumps(case.inputs.tolist())
    command = [sys.executable, "-I", "-c", IN_NUMPY, str(tmp_path), rows]
    done = subprocess.run(command, capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stderr
    assert_within_range(json.loads(done.stdout), case)


@pytest.mark.skipif(shutil.which("node") is None, reason="needs Node.js")
def test_javascript(case, tmp_path):
    path = case.system.export(tmp_path / "tires.js").path.rename(tmp_path / "tires.mjs")
    command = ["node", "-e", IN_JAVASCRIPT, path.as_uri(), json.dumps(case.inputs.tolist())]
    done = subprocess.run(command, capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stderr
    assert_within_range(json.loads(done.stdout), case)


@pytest.mark.skipif(shutil.which("gcc") is None, reason="needs a C compiler")
def test_c(case, tmp_path):
    source = case.system.export(tmp_path / "tires.c").path
    library = tmp_path / "tires.so"
    command = ["gcc", "-O1", "-fPIC", "-shared", "-o", library, source, "-lm"]
    subprocess.run(command, check=True)
    model = ctypes.CDLL(str(library))

    def pointer(array):
        return array.ctypes.data_as(ctypes.c_void_p)

    prepared, x, p = np.zeros(10_000), np.zeros(2), np.ones(1)
    model.tires_prepare(pointer(p), pointer(prepared))
    found = []
    for row in case.inputs:
        out, r = np.zeros(len(OUTPUTS)), np.array(row)
        states, inputs = pointer(x), pointer(r)
        model.tires_outputs(ctypes.c_double(0.0), states, inputs, pointer(prepared), pointer(out))
        found.append(out)
    assert_within_range(found, case)


def test_fmu(case, tmp_path):
    folder = fmpy.extract(str(case.system.export(tmp_path / "tires.fmu").path))
    names = [str(s.func) for s in case.system.specifieds_symbols]
    found = []
    for row in case.inputs:
        result = fmpy.simulate_fmu(
            folder, fmi_type="CoSimulation", stop_time=1e-3, output_interval=1e-3, output=OUTPUTS,
            start_values=dict(zip(names, row, strict=True)), record_events=False,
        )  # fmt: skip
        found.append([result[name][-1] for name in OUTPUTS])
    assert_within_range(found, case)
