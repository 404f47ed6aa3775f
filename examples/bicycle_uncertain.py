"""
A bicycle whose parameters are uncertain
========================================

The benchmark bicycle is stable at 4.4 m/s, just above its weave speed.  How certain is that when
trail, tilt, masses and the front wheel's inertia are known to ten percent only?

We simulate a Latin hypercube of 2000 bicycles after a small push as one ensemble, and tell stable
ones from unstable ones by how their lean develops.  The exact linear models of some of them must
agree.
"""

import matplotlib.pyplot as plt
import numpy as np
import xarray as xr
from scipy.stats import qmc

from pydy import System
from pydy.examples import bicycle_scene, whipple_bicycle
from pydy.inputs import SampledInput
from pydy.linearize import constrained_eigenvalues

SPEED, SPREAD = 4.4, 0.1  # m/s; relative, to either side
count, compared = 2000, 25

# %%
# The push
# --------
# The input is given by samples, so that the compiled solver evaluates it without calling Python.

bicycle = whipple_bicycle.derive()
values = whipple_bicycle.benchmark_parameters(bicycle)
start = whipple_bicycle.equilibrium(bicycle, SPEED)
system = System(
    bicycle.definition,
    constants=values,
    specifieds={bicycle.push: SampledInput([0.0, 0.1, 0.2, 12.0], [0.0, 4.0, 0.0, 0.0])},
    initial_conditions=start,
    times=np.linspace(0.0, 12.0, num=241),
    ode_solver="dop853",
)

# %%
# The samples
# -----------
# Five parameters vary independently.  Each array has one value for each bicycle.

uncertain = [s for s in values if s.name in ("I_Fyy", "c", "lam", "m_F", "m_H")]
unit = qmc.LatinHypercube(d=len(uncertain), seed=1).random(count)
samples = {
    s: values[s] * (1.0 + SPREAD * (2.0 * u - 1.0)) for s, u in zip(uncertain, unit.T, strict=True)
}

# %%
# Four of the bicycles beside the one of the benchmark, which is drawn solid.  They ride apart by
# the push alone.

accuracy = {"rtol": 1e-8, "atol": 1e-10, "max_step": 0.05}
motion = system.simulate(**accuracy)
others = {}
for k in range(4):
    system.constants = {**values, **{s: v[k] for s, v in samples.items()}}
    others[f"bicycle {k + 1}"] = system.simulate(**accuracy)
system.constants = values
scene = bicycle_scene.scene(system, bicycle, f"Uncertain bicycles at {SPEED} m/s")
scene.animate(motion, compare=others)

# %%
# The ensemble
# ------------
# Of each bicycle we keep two numbers: the largest lean early and late in the ride.  `reduce`
# computes them in chunks, so that all trajectories are never in memory at the same time.

lean = bicycle["phi"]


def early_and_late(dataset):
    """Return the largest lean in the first and in the last seconds."""
    size = abs(dataset[lean.name])
    early, late = size.sel(time=slice(1.0, 4.0)), size.sel(time=slice(9.0, 12.0))
    return xr.Dataset({"early": early.max("time"), "late": late.max("time")})


found = system.integrate_ensemble(constants=samples, reduce=early_and_late, **accuracy)
assert (found.status == 0).all()
rate = np.log(found.late / found.early).values / 8.0
stable = rate < 0
print(f"{stable.mean():.1%} of {count} bicycles within {SPREAD:.0%} are stable at {SPEED} m/s")

# %%
# The rate of growth over each parameter.  The tilt of the steering axis and the front wheel's
# inertia have the largest effect, the masses a small one.

figure, panels = plt.subplots(2, 3, figsize=(9, 5.4), layout="constrained", sharey=True)
for axes, (symbol, drawn) in zip(panels.flat, samples.items(), strict=False):
    axes.plot(drawn[stable], rate[stable], ".", markersize=3, label="stable")
    axes.plot(drawn[~stable], rate[~stable], ".", markersize=3, label="unstable")
    axes.set_xlabel(symbol.name)
    axes.axhline(0.0, color="0.5", linewidth=0.8)
panels[0, 0].legend(fontsize=9)
panels[1, 2].hist(rate, bins=40, orientation="horizontal", color="0.6")
panels[1, 2].set_xlabel("bicycles")
for axes in panels[:, 0]:
    axes.set_ylabel("growth of the lean [1/s]")

# %%
# Check against the linear models
# -------------------------------
# The largest real part of the eigenvalues of lean and steer tells exactly whether a bicycle is
# stable.  Near the limit twelve seconds are too short to tell; where the eigenvalue is clearly
# positive or negative, both must agree.


def growth(constants):
    """Return the largest real part of lean and steer's four eigenvalues."""
    system.constants = constants
    A = system.evaluate_jacobian()
    C = np.vstack([system.evaluate_jacobian(of=kind) for kind in ("holonomic", "velocity")])
    eigenvalues = constrained_eigenvalues(A, C)
    return eigenvalues[np.argsort(-np.abs(eigenvalues))[:4]].real.max()


exact = np.array(
    [growth({**values, **{s: v[k] for s, v in samples.items()}}) for k in range(compared)]
)
clear = np.abs(exact) > 0.15
agree = (exact < 0) == stable[:compared]
print(f"the linear models of {compared} agree in {agree.sum()}; of {clear.sum()} clear ones in "
      f"{agree[clear].sum()}")  # fmt: skip
assert agree[clear].all()

plt.show()
