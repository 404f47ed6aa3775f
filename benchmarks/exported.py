"""The exported JAX source against NumPy's, in an environment that has JAX and no pydy.

    python benchmarks/exported.py --peer-python .venv-peers/bin/python

JAX is no dependency of the tests; `make bench-peers` runs this. It fails where the two differ.
"""

from __future__ import annotations

import argparse
import subprocess
import tempfile
from pathlib import Path

from pydy.examples import whipple_bicycle
from pydy.models import n_link_pendulum_on_cart
from pydy.system import System

CHECK = """
import sys, time
sys.modules["pydy"] = None
sys.path.insert(0, sys.argv[1])
import jax, numpy as np
jax.config.update("jax_enable_x64", True)
import model_jax, model_numpy

x = np.random.default_rng(3).uniform(-0.3, 0.3, len(model_numpy.STATES))
begin = time.perf_counter()
rates = np.asarray(jax.jit(model_jax.rates)(0.3, x))
compiled = time.perf_counter() - begin
jacobian = np.asarray(jax.jacfwd(model_jax.rates, 1)(0.3, x))
n = len(x)
for found, expected in ((rates, model_numpy.rates(0.3, x)),
                        (jacobian, model_numpy.jacobian(0.3, x)[:n, :n])):
    np.testing.assert_allclose(found, expected, rtol=1e-10, atol=1e-10 * abs(expected).max())
rows = jax.vmap(model_jax.rates, (None, 0))(0.3, np.stack([x, 2 * x]))
np.testing.assert_allclose(rows[0], rates, rtol=1e-12)
print(f"{sys.argv[2]:<10s} rates, Jacobian and batches agree; JAX compiled for {compiled:.1f} s")
"""


def pendulum() -> System:
    return n_link_pendulum_on_cart(5)


def bicycle() -> System:
    model = whipple_bicycle.derive()
    return System(model.definition, constants=whipple_bicycle.benchmark_parameters(model))


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--peer-python", required=True)
    options = parser.parse_args()
    for make in (pendulum, bicycle):
        system = make()
        with tempfile.TemporaryDirectory() as folder:
            for target in ("numpy", "jax"):
                system.export(Path(folder) / f"model_{target}.py", target=target)
            command = [options.peer_python, "-c", CHECK, folder, make.__name__]
            subprocess.run(command, check=True, cwd=folder)


if __name__ == "__main__":
    main()
