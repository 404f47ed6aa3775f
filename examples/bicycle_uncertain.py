"""
A bicycle whose parameters are not quite known
==============================================

The benchmark bicycle rides itself at 4.4 m/s, just above its weave speed.  How sure is that, when
trail, tilt, masses and the front wheel's inertia are known to ten percent only?  A Latin hypercube
of bicycles gets a small kick; what has become of their lean after some seconds tells stable ones
from others, and the exact linear models of some of them say the same.
"""

import sys

import matplotlib.pyplot as plt
import numpy as np
import xarray as xr
from scipy.stats import qmc

from pydy.examples import whipple_bicycle
from pydy.inputs import SampledInput
from pydy.linearize import constrained_eigenvalues
from pydy.system import System

SPEED, SPREAD = 4.4, 0.1  # m/s; relative, to either side
NAMES = ("I_Fyy", "c", "lam", "m_F", "m_H")


def varied(bicycle, values, count):
    """Return values of the constants that are not known well, one for each bicycle."""
    known = [s for s in values if s.name in NAMES]
    unit = qmc.LatinHypercube(d=len(known), seed=1).random(count)
    return {
        s: values[s] * (1.0 + SPREAD * (2.0 * u - 1.0)) for s, u in zip(known, unit.T, strict=True)
    }


def growth(system, constants, start):
    """Return the largest real part of lean and steer's four eigenvalues."""
    system.constants, system.initial_conditions = constants, start
    A = system.evaluate_jacobian()
    C = np.vstack([system.evaluate_jacobian(of=kind) for kind in ("holonomic", "velocity")])
    values = constrained_eigenvalues(A, C)
    return values[np.argsort(-np.abs(values))[:4]].real.max()


def main(small=False):
    """Kick the bicycles, look at their lean, compare with the linear model, draw."""
    count, compared = (24, 3) if small else (2000, 25)
    bicycle = whipple_bicycle.derive()
    values = whipple_bicycle.benchmark_parameters(bicycle)
    start = whipple_bicycle.equilibrium(bicycle, SPEED)
    kick = SampledInput([0.0, 0.1, 0.2, 12.0], [0.0, 4.0, 0.0, 0.0])
    system = System(
        bicycle.kane,
        constants=values,
        specifieds={bicycle.push: kick},
        initial_conditions=start,
        times=np.linspace(0.0, 12.0, num=241),
    )
    constants = varied(bicycle, values, count)
    lean = bicycle["phi"]

    def early_and_late(dataset):
        """Keep how much each bicycle leans at first and in the end."""
        size = abs(dataset[lean.name])
        early, late = size.sel(time=slice(1.0, 4.0)), size.sel(time=slice(9.0, 12.0))
        return xr.Dataset({"early": early.max("time"), "late": late.max("time")})

    found = system.integrate_ensemble(
        constants=constants, reduce=early_and_late, rtol=1e-8, atol=1e-10, max_step=0.05
    )
    assert (found.status == 0).all()
    rate = np.log(found.late / found.early).values / 8.0
    print(
        f"{(rate < 0).mean():.1%} of {count} bicycles within {SPREAD:.0%} are stable at {SPEED} m/s"
    )

    exact = []
    for k in range(compared):
        own = {**values, **{s: v[k] for s, v in constants.items()}}
        exact.append(growth(system, own, start))
    clear = np.abs(exact) > 0.15
    agree = (np.array(exact) < 0) == (rate[:compared] < 0)
    print(f"the linear models of {compared} agree in {agree.sum()}; of {clear.sum()} clear ones in "
          f"{agree[clear].sum()}")  # fmt: skip
    assert agree[clear].all()
    draw(constants, rate)


def draw(constants, rate):
    """The rate of growth over every parameter, and how it is distributed."""
    _, axes = plt.subplots(2, 3, figsize=(9, 5.4), layout="constrained", sharey=True)
    for plot, (symbol, values) in zip(axes.flat, constants.items(), strict=False):
        stable = rate < 0
        plot.plot(values[stable], rate[stable], ".", markersize=3, label="stable")
        plot.plot(values[~stable], rate[~stable], ".", markersize=3, label="not stable")
        plot.set_xlabel(symbol.name)
        plot.axhline(0.0, color="0.5", linewidth=0.8)
    axes[0, 0].legend(fontsize=9)
    axes[1, 2].hist(rate, bins=40, orientation="horizontal", color="0.6")
    axes[1, 2].set_xlabel("bicycles")
    for plot in axes[:, 0]:
        plot.set_ylabel("growth of the lean [1/s]")


if __name__ == "__main__":
    main(small="--small" in sys.argv)
    plt.show()
