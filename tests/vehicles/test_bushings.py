"""Bushings and anti-roll bars: their laws, and the balances of momenta and energy."""

import numpy as np
import pytest
import sympy as sm
import sympy.physics.mechanics as me

from pydy import System
from pydy.mechanics import Definition
from pydy.vehicles.machines import anti_roll_bar_loads, bushing_loads, torsion_bar_stiffness
from zoo import inertial_frame

K, KAPPA = (4e3, 5e3, 3e3), (60.0, 90.0, 40.0)
C, GAMMA = (30.0, 20.0, 25.0), (0.5, 0.8, 0.4)


def two_free_bodies(**law):
    """Return a System of two bodies in a bushing, and its momenta and energy as outputs."""
    N, O = inertial_frame()
    q, u = me.dynamicsymbols("q:12"), me.dynamicsymbols("u:12")
    bodies, places = [], []
    for k, (mass, inertia) in enumerate(((2.0, (0.03, 0.05, 0.04)), (3.0, (0.09, 0.05, 0.07)))):
        a, v = q[6 * k : 6 * k + 6], u[6 * k : 6 * k + 6]
        B = me.ReferenceFrame(f"B{k}")
        B.orient_body_fixed(N, a[3:], "123")
        B.set_ang_vel(N, B.ang_vel_in(N).subs({c.diff(): w for c, w in zip(a, v, strict=True)}))
        G = O.locatenew(f"G{k}", sum((c * e for c, e in zip(a, N, strict=False)), me.Vector(0)))
        G.set_vel(N, sum((c * e for c, e in zip(v, N, strict=False)), me.Vector(0)))
        offset = (-1) ** k * (0.2 * B.x + 0.05 * B.y - 0.03 * B.z)
        P = G.locatenew(f"P{k}", offset)
        P.v2pt_theory(G, N, B)
        bodies.append(me.RigidBody(f"body{k}", G, B, mass, (me.inertia(B, *inertia), G)))
        places.append((B, P))
    loads = bushing_loads(*places, N, **law)
    momentum = me.linear_momentum(N, *bodies), me.angular_momentum(O, N, *bodies)
    outputs = {
        f"{n}{k}": m.dot(e) for n, m in zip("pL", momentum, strict=True) for k, e in enumerate(N)
    }
    (A, P), (B, Q) = places
    outputs["kinetic"] = me.kinetic_energy(N, *bodies)
    outputs |= {f"d{k}": Q.pos_from(P).dot(e) for k, e in enumerate(A)}
    outputs |= {f"R{i}{j}": a.dot(b) for i, a in enumerate(A) for j, b in enumerate(B)}
    start = dict(zip(q, [0, 0, 0, 0.3, -0.2, 0.4, 0.45, 0.1, 0, 0.5, -0.6, 0.7], strict=True))
    start |= dict(zip(u, np.linspace(-0.6, 0.7, 12), strict=True))
    system = System(
        Definition(N, q, u, bodies=bodies, loads=loads), ode_solver="dop853",
        initial_conditions=start, times=np.linspace(0.0, 0.5, 26), outputs=outputs,
    )  # fmt: skip
    return system


def potential(motion):
    """Return the energy of the bushing, with Cardan angles from the rotation matrix."""
    R = {
        name: np.asarray(motion[name]) for name in (f"R{i}{j}" for i in range(3) for j in range(3))
    }
    angles = (
        np.arctan2(-R["R12"], R["R22"]),
        np.arcsin(R["R02"]),
        np.arctan2(-R["R01"], R["R00"]),
    )
    springs = sum(k * motion[f"d{i}"] ** 2 for i, k in enumerate(K))
    return (springs + sum(k * a**2 for k, a in zip(KAPPA, angles, strict=True))) / 2


def test_without_damping_a_bushing_conserves_momenta_and_energy_at_large_angles():
    motion = two_free_bodies(stiffness=K, torsional_stiffness=KAPPA).simulate(
        rtol=1e-11, atol=1e-11
    )
    for name in ("p0", "p1", "p2", "L0", "L1", "L2"):
        assert np.ptp(motion[name]) < 1e-8
    stored = potential(motion)
    assert np.ptp(stored) > 1.0
    energy = motion["kinetic"] + stored
    assert np.ptp(energy) < 1e-8 * energy[0]


def test_damping_takes_energy_and_no_momentum():
    system = two_free_bodies(
        stiffness=K, damping=C, torsional_stiffness=KAPPA, torsional_damping=GAMMA
    )
    motion = system.simulate(rtol=1e-10, atol=1e-10)
    for name in ("p0", "p1", "p2", "L0", "L1", "L2"):
        assert np.ptp(motion[name]) < 1e-8
    energy = motion["kinetic"] + potential(motion)
    assert (np.diff(energy) < 0.0).all()
    assert energy[-1] < 0.7 * energy[0]


@pytest.mark.parametrize("axis", [0, 1, 2])
def test_about_each_axis_a_body_swings_by_its_closed_form(axis):
    # Linear at any angle: φ = φ_0 exp(−γ t/2J) (cos ω t + γ/(2 J ω) sin ω t).
    N, O = inertial_frame()
    q, u = me.dynamicsymbols("q u")
    B = me.ReferenceFrame("B")
    B.orient_axis(N, list(N)[axis], q)
    B.set_ang_vel(N, u * list(N)[axis])
    inertia, stiff, damp = 0.02, KAPPA[axis], GAMMA[axis] / 10
    body = me.RigidBody("body", O, B, 1, (me.inertia(B, inertia, inertia, inertia), O))
    loads = bushing_loads(
        (N, O), (B, O), N, torsional_stiffness=KAPPA, torsional_damping=[g / 10 for g in GAMMA]
    )
    system = System(
        Definition(N, [q], [u], bodies=[body], loads=loads), ode_solver="dop853",
        initial_conditions={q: 1.2}, times=np.linspace(0.0, 0.3, 31),
    )  # fmt: skip
    motion = system.simulate(rtol=1e-11, atol=1e-11)
    decay = damp / (2 * inertia)
    omega = np.sqrt(stiff / inertia - decay**2)
    t = motion.times
    expected = np.exp(-decay * t) * (np.cos(omega * t) + decay / omega * np.sin(omega * t))
    assert motion["q"] == pytest.approx(1.2 * expected, abs=1e-8)


def resultant(loads, origin, frame, at):
    """Return the sums of the forces and of their moments about a point, with numbers."""
    force, moment = me.Vector(0), me.Vector(0)
    for where, load in loads:
        if isinstance(where, me.Point):
            force += load
            moment += where.pos_from(origin).cross(load)
        else:
            moment += load
    return [np.array(v.to_matrix(frame).subs(at), float).ravel() for v in (force, moment)]


def test_the_loads_of_a_bar_are_in_equilibrium_and_have_its_power():
    N, O = inertial_frame()
    z = me.dynamicsymbols("z_l z_r")
    w = [c.diff() for c in z]
    B = N.orientnew("B", "Axis", (0.2, N.x))
    left = O.locatenew("L", 0.6 * B.y + 0.1 * B.x + z[0] * B.z)
    right = O.locatenew("R", -0.7 * B.y + z[1] * B.z)
    left.set_vel(N, w[0] * B.z)
    right.set_vel(N, w[1] * B.z)
    loads = anti_roll_bar_loads(left, right, B.z, B, stiffness=3e4)
    at = {z[0]: 0.03, z[1]: -0.01}
    force, moment = resultant(loads, O, N, at)
    assert force == pytest.approx(np.zeros(3), abs=1e-10)
    assert moment == pytest.approx(np.zeros(3), abs=1e-10)
    power = sum(load.dot(p.vel(N)) for p, load in loads if isinstance(p, me.Point))
    stored = 3e4 * (z[0] - z[1]) ** 2 / 2
    assert sm.simplify(power + stored.diff(me.dynamicsymbols._t)) == 0


def test_a_bar_does_not_resist_heave_and_resists_roll_by_its_track():
    N, O = inertial_frame()
    phi, heave = sm.symbols("phi heave")
    track, k = 1.4, 2.5e4
    ends = [O.locatenew(n, s * track / 2 * N.y + (heave + s * track / 2 * phi) * N.z)
            for n, s in (("L", 1), ("R", -1))]  # fmt: skip
    loads = dict(anti_roll_bar_loads(*ends, N.z, N, stiffness=k))
    moment = loads[N].dot(N.x)
    assert float(moment.subs({phi: 0.01, heave: 0.3})) == pytest.approx(k * track**2 * 0.01)


def test_a_torsion_bar_twists_by_its_area_moment():
    d, L, a, G = 0.022, 1.05, 0.24, 80e9
    ends = torsion_bar_stiffness(d, L, a, shear_modulus=G)
    r = np.linspace(0.0, d / 2, 20_001)
    area_moment = np.trapezoid(2 * np.pi * r**3, r)
    # Each end has the force k z: the moment k z a twists the bar by z/a.
    assert ends * a == pytest.approx(G * area_moment / L / a, rel=1e-7)
    tube = torsion_bar_stiffness(d, L, a, shear_modulus=G, inner_diameter=d / 2)
    assert tube / ends == pytest.approx(15 / 16)
    with pytest.raises(ValueError, match="`inner_diameter` must be smaller than `diameter`"):
        torsion_bar_stiffness(0.02, 1.0, 0.2, inner_diameter=0.03)


def test_bad_frames_and_numbers_are_named():
    N, O = inertial_frame()
    with pytest.raises(TypeError, match="`first` must be a pair of a ReferenceFrame and a Point"):
        bushing_loads((O, N), (N, O), N)
    with pytest.raises(TypeError, match="`stiffness` must be three numbers or expressions"):
        bushing_loads((N, O), (N, O), N, stiffness=1.0)
    with pytest.raises(ValueError, match=r"`damping\[1\]` must not be negative"):
        bushing_loads((N, O), (N, O), N, damping=[1, -1, 1])
