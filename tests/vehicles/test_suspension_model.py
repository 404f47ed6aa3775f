"""Quarter cars on suspensions: constraints, virtual work, natural frequencies and energy."""

from functools import cache

import numpy as np
import pytest
import sympy as sm
import sympy.physics.mechanics as me

from pydy import System
from pydy.contact import kelvin_voigt
from pydy.mechanics import Definition
from pydy.vehicles import WheelContact
from pydy.vehicles.suspensions import DoubleWishbone
from zoo import inertial_frame
from zoo.suspended import SPATIAL, WISHBONE

G, TIRE = 9.81, 2e5
BODY, UPRIGHT, WHEEL = 350.0, 22.0, 14.0
UNSPRUNG = UPRIGHT + WHEEL
# Level parallel arms: at the hard points the wheel moves straight up, without camber.
LEVEL = DoubleWishbone(
    lower_front=(0.2, 0.35, 0.2), lower_rear=(-0.2, 0.35, 0.2), lower_outer=(0, 0.75, 0.2),
    upper_front=(0.2, 0.35, 0.45), upper_rear=(-0.2, 0.35, 0.45), upper_outer=(0, 0.75, 0.45),
    tie_rod_inner=(-0.12, 0.35, 0.25), tie_rod_outer=(-0.12, 0.75, 0.25),
    wheel_center=(0, 0.8, 0.32), spring_inner=(0, 0.45, 0.6), spring_outer=(0, 0.6, 0.2),
)  # fmt: skip


def quarter_car(suspension, force, *, arms=(0.0, 0.0), spring_at_center=False, free=True):
    """Return a System of a body that moves vertically on a wheel, and the suspension."""
    N, O = inertial_frame()
    z, w = me.dynamicsymbols("z w")
    P = O.locatenew("P", z * N.z if free else me.Vector(0))
    P.set_vel(N, w * N.z if free else me.Vector(0))
    model = suspension.build(
        N, P, N, name="fl", upright_mass=UPRIGHT, upright_inertia=(0.4, 0.5, 0.3),
        wheel_mass=WHEEL, wheel_inertia=(1.1, 0.6), force=force, arm_masses=arms,
    )  # fmt: skip
    static = (BODY + UNSPRUNG + sum(arms)) * G / TIRE
    radius = suspension.wheel_center[2] + static
    contact = WheelContact(
        model.wheel,
        model.axis,
        radius,
        O,
        N.z,
        N,
        lambda gap, rate: kelvin_voigt(gap, rate, TIRE, 0.0),
    )
    center = model.points["wheel_center"]
    deflection = radius - center.pos_from(O).dot(N.z)
    # A spring at the wheel's center is conservative, whatever the camber.
    road = [(center, TIRE * deflection * N.z)] if spring_at_center else contact.loads()
    bodies = [*model.bodies, me.Particle("body", P, BODY)][: None if free else -1]
    weights = [(getattr(b, "masscenter", P), -b.mass * G * N.z) for b in bodies]
    extra = ([z], [w]) if free else ([], [])
    system = System(
        Definition(
            N, [*extra[0], *model.coordinates], [*extra[1], *model.speeds], bodies=bodies,
            loads=[*weights, *model.loads, *road],
            holonomic_constraints=model.holonomic_constraints, configuration=model.configuration,
        ),
        ode_solver="dop853",
        outputs={
            "travel": model.travel,
            "camber": -sm.asin(model.axis.dot(N.z)),
            "length": model.spring_length,
            "kinetic": me.kinetic_energy(N, *bodies),
            "height": sum(
                b.mass * p.pos_from(O).dot(N.z) for b, (p, _) in zip(bodies, weights, strict=True)
            ),
            "gap": -deflection if spring_at_center else contact.gap,
        },
    )  # fmt: skip
    return system, model


@cache
def spatial(kind, arms=(0.0, 0.0)):
    return quarter_car(SPATIAL[kind], lambda x, v: 5000.0 + 25e3 * x + 900.0 * v, arms=arms)[0]


@pytest.mark.parametrize("kind", SPATIAL)
@pytest.mark.parametrize("angle", [-0.12, 0.15])
def test_the_constraints_lead_along_the_kinematic_curves(kind, angle):
    system = spatial(kind)
    system.initial_conditions = {"fl_lower_arm": angle}
    others = [str(s).removesuffix("(t)") for s in system.coordinates[2:5]]
    speeds = [f"{name}_rate" for name in others]
    system.set_dependent_initial_conditions([*others, *speeds], tol=1e-14)
    outputs = dict(zip(map(str, system.outputs), system.evaluate_outputs(), strict=True))
    curves = SPATIAL[kind].curves([outputs["travel"]], 0.31)
    assert abs(outputs["travel"]) > 0.03
    assert outputs["camber"] == pytest.approx(curves.camber[0], abs=1e-11)
    assert outputs["length"] == pytest.approx(curves.spring_length[0], rel=1e-11)


def wheel_rate(suspension, force, rate):
    """Return k MR² + F dMR/dz for no travel."""
    h = 1e-5
    behind, middle, ahead = suspension.curves([-h, 0.0, h], 0.3).motion_ratio
    return rate * middle**2 + force * (ahead - behind) / (2 * h), middle


def test_the_natural_frequencies_of_a_quarter_car_are_those_of_two_masses():
    spring = 40e3
    _, ratio = wheel_rate(LEVEL, 0.0, spring)
    preload = BODY * G / ratio
    k, _ = wheel_rate(LEVEL, preload, spring)
    damper = 2500.0
    system, _model = quarter_car(LEVEL, lambda x, v: preload + spring * x + damper * v)
    values = system.linearize().eigenvalues
    # The motion ratio by hand: the arm of 0.4 m carries the spring at 0.25 m.
    along = np.array([0.15, -0.4]) / np.hypot(0.15, 0.4)
    assert ratio == pytest.approx(-along[1] * 0.25 / 0.4, rel=1e-12)
    c = damper * ratio**2
    mass = np.diag([BODY, UNSPRUNG])
    stiffness = np.array([[k, -k], [-k, k + TIRE]])
    damping = c * np.array([[1, -1], [-1, 1]])
    companion = np.block(
        [
            [np.zeros((2, 2)), np.eye(2)],
            [-np.linalg.solve(mass, stiffness), -np.linalg.solve(mass, damping)],
        ]
    )
    for expected in np.linalg.eigvals(companion):
        assert np.abs(values - expected).min() < 1e-7 * abs(expected)


@pytest.mark.parametrize("suspension", [WISHBONE, SPATIAL["strut"]], ids=["wishbone", "strut"])
def test_the_static_load_of_the_wheel_follows_from_virtual_work(suspension):
    # On a fixed body the wheel rests where F MR and the weights balance the tire's force.
    def law(x, v):
        return 3000.0 + 30e3 * x

    system, _ = quarter_car(suspension, law, free=False)
    balance = system.find_equilibrium(list(system.coordinates[:4]))
    system.initial_conditions = dict(zip(system.states, balance.state, strict=True))
    outputs = dict(zip(map(str, system.outputs), system.evaluate_outputs(), strict=True))
    curves = suspension.curves([outputs["travel"]], 0.3)
    start = suspension.curves([0.0], 0.3)
    compression = start.spring_length[0] - curves.spring_length[0]
    at_wheel = law(compression, 0.0) * curves.motion_ratio[0]
    assert abs(outputs["travel"]) > 1e-3
    rate = gap_rate(suspension, outputs["travel"])
    assert -TIRE * outputs["gap"] * rate == pytest.approx(at_wheel + UNSPRUNG * G, rel=1e-7)


def gap_rate(suspension, travel):
    """Return the power of the road's force at the contact point, by force and rate of travel.

    The contact point is aside of the wheel's center, by its height times the tangent of the camber.
    """
    h = 1e-5
    ahead, middle, behind = (suspension.curves(travel + s, 0.3).camber[0] for s in (h, 0.0, -h))
    height = suspension.wheel_center[2] + travel
    return 1 + height * np.tan(middle) * (ahead - behind) / (2 * h)


@pytest.mark.parametrize(
    ("kind", "arms"), [("wishbone", (0.0, 0.0)), ("wishbone", (4.0, 3.0)), ("strut", (4.0, 0.0))]
)
def test_without_damping_a_quarter_car_conserves_its_energy(kind, arms):
    preload, spring = 5000.0, 25e3
    system, _ = quarter_car(
        SPATIAL[kind], lambda x, v: preload + spring * x, arms=arms, spring_at_center=True
    )
    system.initial_conditions = {"z": 0.01, "w": 0.4}
    system.times = np.linspace(0.0, 0.5, 26)
    motion = system.simulate(rtol=1e-10, atol=1e-10)
    assert np.ptp(motion["travel"]) > 0.03
    compression = motion["length"][0] - motion["length"]
    rest = float(SPATIAL[kind].curves(0.0, 0.3).spring_length[0]) - motion["length"]
    stored = preload * rest + spring * rest**2 / 2 + TIRE * motion["gap"] ** 2 / 2
    energy = motion["kinetic"] + G * motion["height"] + stored
    assert np.ptp(compression) > 0.01
    assert np.ptp(energy) < 1e-6 * np.ptp(stored)


def test_an_arm_with_a_mass_has_the_inertia_of_a_plate():
    # By many particles that are spread over the triangle.
    N, O = inertial_frame()
    model = SPATIAL["wishbone"].build(
        N, O, N, name="fl", upright_mass=0, upright_inertia=(0, 0, 0), wheel_mass=1.0,
        wheel_inertia=(1, 1), arm_masses=(3.0, 0.0),
    )  # fmt: skip
    arm = model.bodies[0]
    corners = [SPATIAL["wishbone"].lower_front, SPATIAL["wishbone"].lower_rear]
    corners.append(SPATIAL["wishbone"].lower_outer)
    n = 200
    shares = [(i + 1 / 3, j + 1 / 3) for i in range(n) for j in range(n - i)]
    shares += [(i + 2 / 3, j + 2 / 3) for i in range(n) for j in range(n - i - 1)]
    a, b = np.array(shares).T[:, :, None] / n
    places = corners[0] + a * (corners[1] - corners[0]) + b * (corners[2] - corners[0])
    centre = places.mean(axis=0)
    zero = dict.fromkeys(model.coordinates, 0.0)
    at = np.array(arm.masscenter.pos_from(O).to_matrix(N).subs(zero), float).ravel()
    assert at == pytest.approx(centre, abs=1e-5)
    apart = places - centre
    square = (apart**2).sum(axis=1)
    expected = 3.0 * (np.eye(3) * square.mean() - apart.T @ apart / len(apart))
    matrix = np.array(arm.central_inertia.to_matrix(N).subs(zero), float)
    assert matrix == pytest.approx(expected, abs=1e-4)


def test_arguments_of_a_model_are_checked():
    N, O = inertial_frame()
    usual = {
        "name": "fl", "upright_mass": 1.0, "upright_inertia": (1, 1, 1), "wheel_mass": 1.0,
        "wheel_inertia": (1, 1),
    }  # fmt: skip
    with pytest.raises(ValueError, match=r"`arm_masses\[1\]` must be 0, because a McPherson strut"):
        SPATIAL["strut"].build(N, O, N, **usual, arm_masses=(1.0, 1.0))
    with pytest.raises(TypeError, match="`upright_inertia` must be 3 numbers or expressions"):
        LEVEL.build(N, O, N, **{**usual, "upright_inertia": 1.0})
    with pytest.raises(ValueError, match="`wheel_mass` must not be negative"):
        LEVEL.build(N, O, N, **{**usual, "wheel_mass": -1.0})
    with pytest.raises(TypeError, match="`force` must be a function or None"):
        LEVEL.build(N, O, N, **usual, force=3.0)
