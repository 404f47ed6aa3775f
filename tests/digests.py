"""Print digests of Programs and bits of results: ``python tests/digests.py complete backward 1``.

The first argument says which machine code runs, 'short' (its fallbacks are compiled where they are
needed) or 'complete'; the second in which order models are tried; the third how many steps compiled
loops take between two looks from Python. What is printed is the same for all of them, in every
process.
"""

import hashlib
import sys
import warnings

import numpy as np

import zoo
from parts import drawn
from pydy._backends.llvm import functions
from pydy.solvers.run import integration
from pydy.system import System
from zoo import joints, loops
from zoo.cases import system_of
from zoo.singular import defined_windows


def choose(fallbacks, steps):
    """Have machine code with or without fallbacks run first, and slices of so many steps."""
    if fallbacks == "complete":
        functions.leaves_out_fallbacks = lambda program: False
    integration.first_budget = lambda *_: steps
    integration.SLICE = 0.0 if steps == 1 else integration.SLICE


def systems():
    """Yield names and systems; those of `loops` have redundant rows."""
    for name, model in zoo.MODELS.items():
        yield name, system_of(model())
    for name in ("tied_cart_pendulum", "four_bar", "chaos_pendulum"):
        yield name, System(getattr(joints, name)())
    for name in ("parallelogram", "sarrus"):
        definition, start, *_ = getattr(loops, name)()
        yield name, System(definition, initial_conditions=start)
    # All rods lie on one line after 0.07 s, where the constraints lose rank.
    windows = defined_windows(2)
    start = {q: 0.2 for q in windows.coordinates if q.name[0] == "a"}
    start |= {u: -3.0 for u in windows.speeds if u.name[:2] == "ua"}
    yield "windows", System(windows, initial_conditions=start)


def digest(values):
    return hashlib.sha256(np.ascontiguousarray(values, dtype=float).tobytes()).hexdigest()[:16]


def said_of(name, system):
    """Yield lines."""
    random = np.random.default_rng(1)
    x = random.uniform(0.2, 0.9, (11, len(system.states)))  # eight lanes and a rest
    t = np.sort(random.uniform(0.3, 2.0, 11))
    yield "symbols", system.constants_symbols, system.specifieds_symbols, system.states
    yield "rates", digest(system.evaluate_ode(x, t)), digest(system.evaluate_ode(x[0], t[0]))
    yield "Jacobian", digest(system.evaluate_jacobian(x, t))
    system.times = [0.0, 0.1, 0.3]
    if system.initial_conditions or not system.constraints:
        system.initial_conditions = system.initial_conditions or dict(
            zip(system.states, x[0], strict=True)
        )
        for solver in ("vern9", "radau"):
            system.ode_solver = solver
            for option in (None, "project") if system.constraints else (None,):
                yield solver, option, digest(system.integrate(constraints=option))
    for key, kernel in system._now().model.code._kernels.items():
        yield "Program", str(key), kernel.program.digest


def main(fallbacks, order, steps):
    choose(fallbacks, int(steps))
    warnings.simplefilter("ignore")
    models = [pair for place, pair in enumerate(systems()) if drawn(place, 6)]
    lines = []
    for name, system in models if order == "forward" else models[::-1]:
        lines += [f"{name}: {' '.join(map(str, line))}" for line in said_of(name, system)]
    sys.stdout.write("\n".join(sorted(lines)) + "\n")


if __name__ == "__main__":
    main(*sys.argv[1:])
