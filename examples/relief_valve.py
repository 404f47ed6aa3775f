"""
Pressure relief valve
=====================

A pump feeds a vessel at a constant rate; a spring-loaded poppet lets out what is too much.  With
less flow the open valve becomes unstable, and soon the poppet hits its seat in every cycle: it
chatters.

In dimensionless form [1]_ the lift y, its speed v and the pressure p follow y' = v,
v' = −κ v − (y + δ) + p, p' = β (q − y √p), with the impact v⁺ = −r v⁻ at y = 0.  The numbers are
those of the second tutorial of MPGOS [2]_.

.. [1] C. Hős and A. R. Champneys, Grazing bifurcations and chatter in a pressure relief valve
   model, Physica D 241 (2012), pp. 2068–2076.
.. [2] F. Hegedűs, Massively Parallel GPU-ODE Solver, tutorial T2, impact dynamics.
"""

import matplotlib.pyplot as plt
import numpy as np
import sympy as sm
import sympy.physics.mechanics as me

from pydy import System
from pydy.contact import Contacts, Unilateral
from pydy.mechanics import Definition
from pydy.solvers import Event
from pydy.viz import Line, Sphere, Visual

KAPPA, DELTA, BETA, RESTITUTION = 1.25, 10.0, 20.0, 0.8

# %%
# Equations
# ---------
# The poppet is a particle.  The pressure has no inertia: it is a coordinate whose rate is given by
# a kinematic equation, as other states of first order can be.

q, kappa, delta, beta = sm.symbols("q, kappa, delta, beta")
y, p, v = me.dynamicsymbols("y, p, v")
N, origin = me.ReferenceFrame("N"), me.Point("O")
origin.set_vel(N, 0)
place = origin.locatenew("P", y * N.x)
place.set_vel(N, v * N.x)
valve = Definition(
    N, [y, p], [v],
    bodies=[me.Particle("poppet", place, 1)],
    loads=[(place, (p - y - delta - kappa * v) * N.x)],
    kinematic_equations=[y.diff() - v, p.diff() - beta * (q - y * sm.sqrt(p))],
)  # fmt: skip
system = System(
    valve,
    constants={q: 5.0, kappa: KAPPA, delta: DELTA, beta: BETA},
    initial_conditions={y: 0.2, p: 0.0, v: 0.0},
    ode_solver="tsit5",
)

# %%
# Where the open valve becomes unstable
# -------------------------------------
# With c = β y/(2 √p) its characteristic polynomial is λ³ + (κ + c) λ² + (1 + κ c) λ + c + β √p.
# Routh's condition (κ + c) (1 + κ c) = c + β √p, where p = y + δ and q = y √p, has one root.  The
# eigenvalues of the linear model cross the imaginary axis at the same flow rate.

lift = sm.Symbol("lift")
pressure = lift + DELTA
c = BETA * lift / (2 * sm.sqrt(pressure))
routh = (KAPPA + c) * (1 + KAPPA * c) - c - BETA * sm.sqrt(pressure)
hopf_lift = float(sm.nsolve(routh, lift, 2.0))
hopf = hopf_lift * np.sqrt(hopf_lift + DELTA)
growths = []
for share in (0.999, 1.0, 1.001):
    system.constants[q] = share * hopf
    system.initial_conditions = {y: hopf_lift, p: hopf_lift + DELTA}
    system.initial_conditions = system.find_equilibrium().initial_conditions
    growths.append(system.linearize().eigenvalues.real.max())
print(f"Hopf bifurcation at q = {hopf:.6f}, growth rate there {growths[1]:.1e}")
assert growths[0] > 0 > growths[2]
assert abs(growths[1]) < 1e-9

# %%
# Bifurcation diagram
# -------------------
# An ensemble over the flow rate, with the impact as an event: what is left of the lift after a
# transient.

impact = Event(y, direction=-1, reset={v: -RESTITUTION * v}, name="impact")
top = Event(v, direction=-1, name="top")
flows = np.linspace(0.6, 10.0, 400)
options = {"constants": {q: flows}, "rtol": 1e-8, "atol": 1e-8}
system.initial_conditions = {y: 0.2, p: 0.0, v: 0.0}
settled = system.integrate_ensemble(events=[impact], times=[0.0, 300.0], reduce="final", **options)
later = system.integrate_ensemble(
    initial_conditions={s: settled[s.name].values for s in (y, p, v)},
    events=[impact, top], times=np.linspace(0.0, 30.0, 1501),
    reduce=[("max", "y"), ("min", "y"), "events"], **options,
)  # fmt: skip
hits = later.impact_count.values > 0
grazing = 0.5 * (flows[hits].max() + flows[~hits].min())
print(f"the poppet hits its seat below q = {grazing:.3f} (in steps of {flows[1] - flows[0]:.3f})")

# %%
# SciPy's solver, without impacts, has a cycle that touches y = 0 at q = 7.557211.

assert abs(grazing - 7.557211) <= flows[1] - flows[0]
assert np.all(np.diff(hits.astype(int)) <= 0)  # no flow above that, and every one below

# %%
# The chatter that ends
# ---------------------
# With little flow the impacts accumulate: the poppet stays on its seat until the pressure lifts it.
# `Contacts` goes through that, where an event with a reset would be repeated without an end.

system.constants[q] = 0.25
system.times = np.linspace(0.0, 20.0, 2001)
seat = Contacts(system, [Unilateral(y, restitution=RESTITUTION, name="seat")])
chatter = seat.simulate(rtol=1e-9, atol=1e-9)
rests = [(start, end) for start, end, modes in chatter.modes if modes["seat"] == "closed"]
for start, end in rests[:3]:
    first, last = chatter.at([start, end])["p"]
    print(f"on its seat from t = {start:.4f}, p = {first:.6f}, to {end:.4f}, p = {last:.6f}")

# %%
# It opens where the pressure has the spring's force, after p' = β q at rest.

assert rests
assert rests[-1][1] < system.times[-1]
for start, end in rests:
    first, last = chatter.at([start, end])["p"]
    assert abs(last - DELTA) < 1e-7
    assert abs(first + BETA * 0.25 * (end - start) - DELTA) < 1e-7

# %%
# The poppet above its seat
# -------------------------

above = origin.locatenew("A", 6 * N.x)
edges = [origin.locatenew(f"E{k}", k * N.y) for k in (-1.5, -0.3, 0.3, 1.5)]
scene = system.scene(
    Visual(Sphere(0.4, color="steelblue"), place, name="poppet"),
    Visual(Line([place, above], 0.08, color="darkorange"), name="spring"),
    Visual(Line(edges[:2], 0.1, color="dimgray"), name="seat, left"),
    Visual(Line(edges[2:], 0.1, color="dimgray"), name="seat, right"),
    origin=origin, up="x", ground=False,
)  # fmt: skip
scene.animate(chatter)

# %%
# Figures
# -------

figure, (above, below) = plt.subplots(2, figsize=(7, 7))
above.plot(flows, later["y_max"], ".", ms=2, label="highest lift")
above.plot(flows, later["y_min"], ".", ms=2, label="lowest lift")
above.axvline(hopf, lw=0.8, color="k")
above.axvline(grazing, lw=0.8, ls=":", color="k")
above.set(xlabel="flow rate q", ylabel="y")
above.legend()
below.plot(chatter.times, chatter["y"])
below.set(xlabel="t", ylabel="y", title="q = 0.25")
figure.tight_layout()
plt.show()
