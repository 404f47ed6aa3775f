"""Clutches, brakes and differentials that lock: closed forms of flywheels, and their balances."""

import numpy as np
import pytest
import sympy as sm
import sympy.physics.mechanics as me

from pydy import System
from pydy.contact import Contacts
from pydy.mechanics import Definition
from pydy.vehicles.machines import brake, clutch, clutch_capacity, differential_torques
from zoo import inertial_frame

TIME = me.dynamicsymbols._t
J = (0.3, 1.4)


def flywheels(torques, speeds, times, inertias=J):
    """Return a System of shafts about one axis with a torque on each, and their speeds."""
    q = me.dynamicsymbols(f"q:{len(inertias)}")
    w = me.dynamicsymbols(f"w:{len(inertias)}")
    N, O = inertial_frame()
    bodies = []
    for k, inertia in enumerate(inertias):
        W = me.ReferenceFrame(f"W{k}")
        W.orient_axis(N, N.x, q[k])
        W.set_ang_vel(N, w[k] * N.x)
        bodies.append(me.RigidBody(f"shaft{k}", O, W, 1, (me.inertia(W, inertia, 1, 1), O)))
    loads = [(b.frame, torque * N.x) for b, torque in zip(bodies, torques(*w), strict=True)]
    system = System(
        Definition(N, q, w, bodies=bodies, loads=loads),
        ode_solver="dop853",
        initial_conditions=dict(zip(w, speeds, strict=True)),
        times=times,
    )
    return system, w


def test_a_clutch_locks_where_the_momenta_agree_and_loses_half_the_reduced_energy():
    system, (w1, w2) = flywheels(lambda *w: (0, 0), (90.0, 10.0), np.linspace(0.0, 2.0, 21))
    motion = Contacts(system, [clutch(w1, w2, 25.0)]).simulate(rtol=1e-11, atol=1e-11)
    (locked,) = motion.events
    assert locked.name == "clutch stops"
    assert locked.time == pytest.approx(80.0 / (25.0 * (1 / J[0] + 1 / J[1])), rel=1e-9)
    common = (J[0] * 90.0 + J[1] * 10.0) / sum(J)
    assert motion.states[-1, 2:] == pytest.approx([common, common], rel=1e-10)
    energy = (np.array(J) * motion.states[:, 2:] ** 2).sum(axis=1) / 2
    reduced = J[0] * J[1] / sum(J)
    assert energy[0] - energy[-1] == pytest.approx(reduced * 80.0**2 / 2, rel=1e-9)


def test_a_locked_clutch_transmits_what_accelerates_both_and_slips_beyond_its_capacity():
    # Locked, the second shaft needs M J_2/(J_1 + J_2), which exceeds 30 N m at M = 36.43 N m.
    system, (w1, w2) = flywheels(lambda *w: (10 * TIME, 0), (5.0, 5.0), np.linspace(0.0, 5.0, 51))
    motion = Contacts(system, [clutch(w1, w2, 30.0)]).simulate(rtol=1e-11, atol=1e-11)
    (slips,) = motion.events
    assert slips.name == "clutch slips"
    assert slips.time == pytest.approx(3.0 * sum(J) / J[1], rel=1e-8)
    locked = motion.times < slips.time
    share = -10 * motion.times[locked] * J[1] / sum(J)
    assert motion["clutch_friction"][locked] == pytest.approx(share, rel=1e-9, abs=1e-9)
    # No jitter: the speeds are equal by rounding.
    apart = motion.states[locked, 2] - motion.states[locked, 3]
    assert np.abs(apart).max() <= 1e-13
    slipping = motion.times > slips.time
    after = motion.states[slipping, 3] - 30.0 / J[1] * motion.times[slipping]
    assert np.ptp(after) < 1e-7


def test_static_friction_holds_a_clutch_up_to_a_larger_torque():
    system, (w1, w2) = flywheels(lambda *w: (10 * TIME, 0), (5.0, 5.0), [0.0, 5.0])
    coupling = clutch(w1, w2, 30.0, static_ratio=1.25, name="coupling")
    (slips,) = Contacts(system, [coupling]).simulate(rtol=1e-11, atol=1e-11).events
    assert slips.time == pytest.approx(1.25 * 3.0 * sum(J) / J[1], rel=1e-8)


def test_a_brake_stops_a_shaft_and_keeps_it_at_rest_under_a_torque():
    system, (w,) = flywheels(lambda w: (6.0,), (40.0,), np.linspace(0.0, 60.0, 121), J[:1])
    motion = Contacts(system, [brake(w, 10.0)]).simulate(rtol=1e-11, atol=1e-11)
    (stops,) = motion.events
    assert stops.time == pytest.approx(40.0 * J[0] / 4.0, rel=1e-9)
    at_rest = motion.times > stops.time
    assert np.abs(motion["w0"][at_rest]).max() < 1e-13
    assert motion["brake_friction"][at_rest] == pytest.approx(-6.0, rel=1e-12)


def test_a_differential_with_plates_locks_up_to_its_torque_bias():
    # The right shaft has little grip: a load of 10 N m; the left one what keeps both together.
    def torques(left, right):
        shafts = differential_torques(200, left, right)
        return shafts[0] - 10 * TIME, shafts[1] - 10.0

    system, (left, right) = flywheels(torques, (5.0, 5.0), np.linspace(0.0, 20.0, 81), (1.0, 1.0))
    bias, preload = 0.4, 30.0
    plates = clutch(left, right, (preload + bias * 200) / 2, name="plates")
    motion = Contacts(system, [plates]).simulate(rtol=1e-11, atol=1e-11)
    (slips,) = motion.events
    # Locked, half of the difference of the loads is transferred: 5 t − 5 = (T_0 + b T)/2 = 55.
    assert slips.time == pytest.approx(12.0, rel=1e-8)
    locked = motion.times < slips.time
    assert motion["w0"][locked] == pytest.approx(motion["w1"][locked], abs=1e-12)
    # Slipping, the slower shaft has (T + T_s)/2 = 155 N m, as the smooth law says far from Δ = 0.
    slow, fast = 155.0, 45.0
    assert differential_torques(200.0, 5.0, 9.0, bias=bias, preload=preload) == (slow, fast)
    t = motion.times[~locked]
    w0 = motion["w0"][~locked] + 5 * t**2 - slow * t
    assert np.ptp(w0) < 1e-6
    assert slow / fast > (1 + bias) / (1 - bias)  # the preload adds to the torque bias ratio


def test_the_capacity_of_a_disc_clutch_is_the_integral_over_its_lining():
    F, mu, r_i, r_o = 4000.0, 0.3, 0.07, 0.11
    r = np.linspace(r_i, r_o, 100_001)
    pressure = F / (np.pi * (r_o**2 - r_i**2))
    new = np.trapezoid(mu * pressure * r * 2 * np.pi * r, r)
    wear = F / (2 * np.pi * (r_o - r_i)) / r
    worn = np.trapezoid(mu * wear * r * 2 * np.pi * r, r)
    assert clutch_capacity(F, mu, r_i, r_o, faces=1, worn=False) == pytest.approx(new, rel=1e-9)
    assert clutch_capacity(F, mu, r_i, r_o, faces=3) == pytest.approx(3 * worn, rel=1e-9)
    force = sm.Symbol("F")
    assert clutch_capacity(force, mu, r_i, r_o).coeff(force) == pytest.approx(0.054)


def test_bad_values_are_named():
    w = me.dynamicsymbols("w")
    with pytest.raises(ValueError, match=r"`static_ratio` must be at least 1, got 0\.5"):
        clutch(w, 0, 10.0, static_ratio=0.5)
    with pytest.raises(ValueError, match="`capacity` must not be negative"):
        brake(w, -1.0)
    with pytest.raises(
        ValueError, match=r"`inner` must be smaller than `outer`, got 0\.2 and 0\.1"
    ):
        clutch_capacity(1.0, 0.3, 0.2, 0.1)
