"""What the first native integration of a process costs, part by part."""

from __future__ import annotations

import os
from typing import Any

import numpy as np
from harness.problems import problem
from harness.serve import serve, time_of


def first_use(name: str, cache: str, method: str) -> dict[str, float]:
    """Integrate a pendulum by odeint, and then twice by a native solver.

    Parameters
    ----------
    name : str
        Of a problem.
    cache : str
        pydy's folder of machine code.
    method : str

    Returns
    -------
    dict
        Seconds: `solvers` of the imports, `first` of the first integration after them, `second`,
        and `added`, by which all this exceeds the second.
    """
    os.environ["PYDY_CACHE_DIR"] = cache
    from pydy.system import System

    p = problem(name)
    system = System(
        p.kane,
        constants=p.constants,
        initial_conditions=p.initial_conditions,
        times=np.linspace(0.0, 0.5, 51),
    )
    system.integrate()
    # The code of the equations is ready: its compilation is not the solver's.
    system.model.compiled("rates").link()
    times: dict[str, float] = {}

    def load(what: str) -> Any:
        return __import__(what, fromlist=["*"])

    times["solvers"] = time_of(lambda: load("pydy.solvers.run.integration"))
    system.ode_solver = method
    times["first"] = time_of(system.integrate)
    times["second"] = time_of(system.integrate)
    times["added"] = times["solvers"] + times["first"] - times["second"]
    return times


if __name__ == "__main__":
    serve({"first_use": first_use})
