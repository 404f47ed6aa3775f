"""
Root locus of a bicycle over its speed
======================================

A bicycle that nobody steers falls over at low speed, rights itself between two speeds, and slowly
falls again beyond.  Which speeds these are follows from the eigenvalues of its linear model, here
of the Carvallo–Whipple bicycle with the parameters of Meijaard, Papadopoulos, Ruina and Schwab
(Proc. R. Soc. A 463, 2007).
"""

import sys

import matplotlib.pyplot as plt
import numpy as np

from pydy.examples import whipple_bicycle
from pydy.system import System

PUBLISHED = (4.292382536341, 6.024262015388)  # weave and capsize speed, m/s


def derive():
    """Return the KanesMethod, values of its constants, and the published eigenvalues."""
    bicycle = whipple_bicycle.derive()
    constants = whipple_bicycle.benchmark_parameters(bicycle)
    return bicycle.kane, constants, whipple_bicycle.PUBLISHED_EIGENVALUES


# %%
# Linear models over the speed
# ----------------------------
# At each speed the bicycle rides straight ahead: its place and its wheels' angles move steadily.


def main(small=False):
    """Sweep the speed, compare the crossings and eigenvalues with the published ones, draw."""
    kane, constants, table = derive()
    system = System(kane, constants=constants)
    speeds = np.linspace(0.0, 10.0, num=101 if small else 1001)
    sweep = system.eigenvalues({"u_x": speeds}, moving=["x", "theta_R", "theta_F"])
    weave, capsize = sweep.crossings()
    print(f"weave speed {weave.value:.12f} m/s, at {weave.eigenvalue.imag:.6f} rad/s")
    print(f"capsize speed {capsize.value:.12f} m/s")
    assert np.allclose((weave.value, capsize.value), PUBLISHED, rtol=0, atol=5e-12)
    worst = 0.0
    for speed, published in table.items():
        row = sweep.eigenvalues[np.abs(speeds - speed).argmin()]
        worst = max(worst, *(np.abs(row - value).min() for value in published))
    print(f"largest difference from the published eigenvalues: {worst:.1e} 1/s")
    assert worst < 1e-9

    _, (left, right) = plt.subplots(1, 2, figsize=(10, 4.2), layout="constrained")
    sweep.plot(left, "m/s")
    left.set_ylim(-10, 10)
    for crossing in (weave, capsize):
        left.axvline(crossing.value, color="0.6", linestyle=":")
    sweep.plot_root_locus(right, "m/s")
    right.set_xlim(-15, 7)


if __name__ == "__main__":
    main(small="--small" in sys.argv)
    plt.show()
