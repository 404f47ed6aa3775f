"""Wheels on a plane: contact point, slips and loads, against geometry and closed forms."""

import cProfile
import pstats
from functools import cache

import numpy as np
import pytest
import sympy as sm
import sympy.physics.mechanics as me

from pydy.contact import kelvin_voigt
from pydy.mechanics import Definition
from pydy.system import System
from pydy.vehicles import BrushTire, LinearTire, MagicFormula, RoadSurface, WheelContact
from pydy.vehicles.relaxation import SlidingSpeeds, transient_slips
from zoo import inertial_frame, wheels
from zoo.tires import TABLE_A31
from zoo.wheels import free_wheel

R, CROWN = 0.3, 0.06
STATE = {"x": 0.1, "y": -0.2, "z": 0.27, "yaw": 0.4, "lean": 0.3, "spin": 1.2}
RATES = {"vx": 8.0, "vy": 1.0, "vz": -0.3, "w1": 0.5, "w2": 20.0, "w3": -0.4}


@cache
def wheel(crown):
    """A free wheel and its contact."""
    w = free_wheel()
    w.contact = WheelContact(
        w.body, w.B.y, R, w.O, w.N.z, w.N, lambda gap, rate: -2e5 * gap, crown_radius=crown
    )
    return w


def values(w, expression):
    """Return an expression, or the components of a vector in N, at the state above."""
    return wheels.values(w, expression, {**STATE, **RATES})


@pytest.mark.parametrize("crown", [0.0, CROWN])
def test_the_gap_is_the_distance_of_the_lowest_point(crown):
    w = wheel(crown)
    u, v = np.meshgrid(np.linspace(0, 2 * np.pi, 721), np.linspace(-np.pi / 2, np.pi / 2, 361))
    local = (R - crown + crown * np.cos(v)) * np.array([np.cos(u), 0 * u, np.sin(u)])
    local[1] = crown * np.sin(v)
    axes = np.array([values(w, axis) for axis in w.W])
    heights = STATE["z"] + np.tensordot(axes[:, 2], local, 1)
    assert values(w, w.contact.gap) == pytest.approx(heights.min(), abs=2e-5)


@pytest.mark.parametrize("crown", [0.0, CROWN])
def test_the_contact_point_lies_on_the_plane_below_the_axle(crown):
    w = wheel(crown)
    offset, axle = values(w, w.contact.contact), values(w, w.B.y)
    assert STATE["z"] + offset[2] == pytest.approx(0.0, abs=1e-15)
    forward = values(w, w.contact.forward)
    assert forward @ offset == pytest.approx(0.0, abs=1e-15)
    assert (forward @ axle, forward[2]) == pytest.approx((0.0, 0.0), abs=1e-15)
    if not crown:
        assert axle @ offset == pytest.approx(0.0, abs=1e-15)
        assert np.linalg.norm(offset) == pytest.approx(values(w, w.contact.loaded_radius))
    assert values(w, w.contact.gamma) == pytest.approx(STATE["lean"])


def test_the_rate_is_the_derivative_of_the_gap():
    w = wheel(CROWN)
    rate = wheels.derivative(w, w.contact.gap, {**STATE, **RATES})
    assert values(w, w.contact.rate) == pytest.approx(rate, rel=1e-6)


def test_slips_are_those_of_the_material_at_the_contact_point():
    w = wheel(0.0)
    velocity = np.array([RATES["vx"], RATES["vy"], RATES["vz"]])
    axes = np.array([values(w, axis) for axis in w.B])
    rotation = np.array([RATES["w1"], RATES["w2"], RATES["w3"]]) @ axes
    sliding = velocity + np.cross(rotation, values(w, w.contact.contact))
    forward, left = values(w, w.contact.forward), values(w, w.contact.left)
    speed = velocity @ forward
    assert values(w, w.contact.speed) == pytest.approx(speed)
    assert values(w, w.contact.kappa) == pytest.approx(-sliding @ forward / speed)
    assert np.tan(values(w, w.contact.alpha)) == pytest.approx(sliding @ left / speed)


def test_loads_have_the_moment_of_the_contact_point_once():
    w = wheel(CROWN)
    tire = MagicFormula(TABLE_A31)
    (point, force), (frame, torque) = w.contact.loads(tire)
    assert (point, frame) == (w.G, w.W)
    found = [values(w, f) for f in w.contact.forces(tire)]
    assert found == pytest.approx(
        tire.forces(
            *(
                values(w, getattr(w.contact, n))
                for n in ("normal_force", "kappa", "alpha", "gamma")
            ),
            speed=values(w, w.contact.speed),
        )
    )
    axes = np.array([values(w, v) for v in (w.contact.forward, w.contact.left, w.N.z)])
    load = values(w, w.contact.normal_force)
    expected = np.array([found[0], found[1], load]) @ axes
    np.testing.assert_allclose(values(w, force), expected)
    moment = np.array(found[2:]) @ axes + np.cross(values(w, w.contact.contact), expected)
    np.testing.assert_allclose(values(w, torque), moment)


def test_a_wheel_in_the_air_has_no_loads():
    w = wheel(0.0)
    tire = LinearTire(4000, 1e5, 1e5)
    contact = WheelContact(
        w.body, w.B.y, R, w.O, w.N.z, w.N, lambda gap, rate: kelvin_voigt(gap, rate, 1e5, 10.0)
    )
    high = {me.dynamicsymbols(k): v for k, v in {**STATE, **RATES, "z": 0.4}.items()}
    for _, vector in contact.loads(tire):
        assert not any(map(float, vector.to_matrix(w.N).subs(high)))


def test_a_sliding_wheel_comes_to_roll_with_its_angular_momentum():
    w = wheel(0.0)
    N, O = w.N, w.O
    x, z, q, vx, vz, spin = me.dynamicsymbols("x z q vx vz w")
    W = me.ReferenceFrame("W")
    W.orient_axis(N, N.y, q)
    W.set_ang_vel(N, spin * N.y)
    G = O.locatenew("G", x * N.x + z * N.z)
    G.set_vel(N, vx * N.x + vz * N.z)
    m, inertia, g, k = 10.0, 0.4, 9.81, 1e5
    rim = me.RigidBody("rim", G, W, m, (me.inertia(W, 0, inertia, 0), G))
    contact = WheelContact(rim, N.y, R, O, N.z, N, lambda gap, rate: -k * gap - 2e3 * rate)
    loads = contact.loads(BrushTire(m * g, stiffness=1000, friction=0.8))
    definition = Definition(
        N, [x, z, q], [vx, vz, spin], bodies=[rim], loads=[(G, -m * g * N.z), *loads]
    )
    height = R - m * g / k
    system = System(
        definition,
        ode_solver="dop853",
        initial_conditions={z: height, vx: 10.0},
        times=np.linspace(0.0, 3.0, 7),
    )
    end = system.simulate(rtol=1e-9, atol=1e-9).states[-1]
    speed = 10.0 / (1 + inertia / (m * height**2))
    assert end[[1, 3, 5]] == pytest.approx([height, speed, speed / height], rel=1e-6)


LENGTHS = (0.3, 0.5)


@pytest.mark.parametrize(
    "rates",
    [{"w2": 26.0}, {"w2": 20.0}, {"w2": 0.0}, {"vx": -8.0, "w2": -28.0}, {"vy": 6.0}],
    ids=["rolling", "braking", "locked", "backwards", "sideways"],
)
def test_slips_with_relaxation_are_the_usual_ones_in_steady_motion(rates):
    w = wheel(0.0)
    u, v = me.dynamicsymbols("u v")
    relaxed = w.contact.with_relaxation(LENGTHS, (u, v))
    assert relaxed.deflections == (u, v)
    given = {me.dynamicsymbols(k): x for k, x in {**STATE, **RATES, **rates}.items()}
    t = me.dynamicsymbols._t
    steady = {}
    for deflection, equation in zip((u, v), relaxed.kinematic_equations, strict=True):
        equation = equation.subs(deflection.diff(t), 0).subs(given)
        (steady[deflection],) = sm.solve(equation, deflection)
    for name in ("kappa", "alpha"):
        found = float(getattr(relaxed, name).subs({**given, **steady}))
        assert found == pytest.approx(float(getattr(w.contact, name).subs(given)), rel=1e-12)


@pytest.mark.parametrize("scale", [1e-9, 1e9])
def test_slips_with_relaxation_are_the_same_for_wheels_of_any_size(scale):
    u, v = me.dynamicsymbols("u v")
    t, load = me.dynamicsymbols._t, sm.Symbol("load")

    def slips(k):
        # It hardly slides, and a length that depends on the load is shorter than any.
        speeds = [sm.Float(k * x) for x in (0.02, 1e-10, -2e-10)]
        found = transient_slips(
            SlidingSpeeds(k * 0.3, *speeds), (k * 0.4 * load, k * 0.5), (u, v),
            {"damping": 0.05, "low_speed": k, "sliding_slip": 0.2},
        )  # fmt: skip
        given = {u: k * 0.01, v: -k * 0.02, load: 0.0}
        rates = [e.subs({u.diff(t): 0, v.diff(t): 0}).subs(given) / k for e in found.equations]
        return [float(x) for x in (found.kappa.subs(given), found.alpha.subs(given), *rates)]

    assert slips(scale) == pytest.approx(slips(1.0), rel=1e-12)


@pytest.mark.parametrize("side", [1, -1])
def test_a_tire_at_rest_is_a_spring_beside_a_damper(side):
    """Its slips grow with the rates of the deflections: a swing to any side dies out."""
    u, v = me.dynamicsymbols("u v")
    t, T = me.dynamicsymbols._t, 0.05
    sliding = SlidingSpeeds(0.3, sm.S.Zero, sm.Float(0.02 * side), sm.Float(-0.03 * side))
    values = {"damping": T, "low_speed": 1.0, "sliding_slip": 0.2}
    slips = transient_slips(sliding, (0.4, 0.5), (u, v), values)
    at_zero = [e.subs({u.diff(t): 0, v.diff(t): 0}).subs({u: 0, v: 0}) for e in slips.equations]
    u_rate, v_rate = (-float(e) for e in at_zero)
    assert float(slips.kappa.subs(u, 0)) == pytest.approx(T * u_rate / 0.4, rel=1e-12)
    assert float(slips.alpha.subs(v, 0)) == pytest.approx(np.arctan(T * v_rate / 0.5), rel=1e-12)


def rolling(tire=None, *, slope=0.0, across=False, lengths=LENGTHS, **options):
    """A wheel that rolls along x, with a lateral speed, and the deflections of its tire."""
    x, y, z, q, vx, vy, vz, spin, u, v = me.dynamicsymbols("x y z q vx vy vz w u v")
    N, O = inertial_frame()
    W = me.ReferenceFrame("W")
    W.orient_axis(N, N.y, q)
    W.set_ang_vel(N, spin * N.y)
    G = O.locatenew("G", x * N.x + y * N.y + z * N.z)
    G.set_vel(N, vx * N.x + vy * N.y + vz * N.z)
    m, g, k = 400.0, 9.81, 2e5
    body = me.RigidBody("wheel", G, W, m, (me.inertia(W, 0, 1.2, 0), G))
    rigid = WheelContact(body, N.y, R, O, N.z, N, lambda gap, rate: kelvin_voigt(gap, rate, k, 2e3))
    contact = rigid.with_relaxation(lengths(rigid) if callable(lengths) else lengths, (u, v))
    angle = np.arctan(slope)
    downhill = N.y if across else N.x
    weight = m * g * (np.sin(angle) * downhill - np.cos(angle) * N.z)
    coordinates, speeds = [x, y, z, q], [vx, vy, vz, spin]
    definition = Definition(
        N,
        [*coordinates, *contact.deflections],
        speeds,
        bodies=[body],
        loads=[(G, weight), *contact.loads(tire)] if tire else [],
        kinematic_equations=[
            *(a.diff() - b for a, b in zip(coordinates, speeds, strict=True)),
            *contact.kinematic_equations,
        ],
        nonholonomic_constraints=options.pop("nonholonomic_constraints", []),
    )
    system = System(definition, ode_solver="radau", **options)
    system.outputs = {"alpha": contact.alpha, "kappa": contact.kappa}
    return system


def test_side_slip_follows_over_the_relaxation_length():
    vx, vy, spin, z = me.dynamicsymbols("vx vy w z")
    distances = np.linspace(0.0, 2.0, 9) * LENGTHS[1]
    system = rolling(
        initial_conditions={z: R, vx: 10.0, vy: 0.2, spin: 10.0 / R}, times=distances / 10.0
    )
    alpha = system.simulate(rtol=1e-10, atol=1e-12)["alpha"]
    expected = 0.02 * (1 - np.exp(-distances / LENGTHS[1]))
    np.testing.assert_allclose(np.tan(alpha), expected, atol=1e-9)
    assert np.tan(alpha[4]) == pytest.approx(0.632 * 0.02, rel=1e-3)


@pytest.mark.parametrize("across", [False, True], ids=["along", "across"])
@pytest.mark.parametrize("speed", [0.0, 3.0])
def test_a_locked_wheel_stands_still_on_a_slope(speed, across):
    x, y, z, vx, vy, spin = me.dynamicsymbols("x y z vx vy w")
    position, velocity = (y, vy) if across else (x, vx)
    times = np.concatenate([np.linspace(0.0, 5.0, 51), np.linspace(5.1, 65.0, 600)])
    motion = rolling(
        BrushTire(4000, stiffness=80e3, friction=0.9),
        slope=0.1,
        across=across,
        nonholonomic_constraints=[spin],
        initial_conditions={z: R - 400 * 9.81 / 2e5, velocity: speed},
        times=times,
    ).simulate()
    minute = times > 5.0
    assert np.abs(motion[velocity][minute]).max() < 1e-8
    assert np.ptp(motion[position][minute]) < 1e-8
    assert motion.statistics["steps"] < 1000


def test_a_wheel_with_lengths_of_its_load_starts_from_rest_and_from_the_air():
    z, spin = me.dynamicsymbols("z w")
    tire = MagicFormula({**TABLE_A31, "LONGITUDINAL_STIFFNESS": 3e5, "LATERAL_STIFFNESS": 1e5})
    for start in ({z: R}, {z: R + 0.02}, {z: R, spin: 10.0}):
        system = rolling(
            tire,
            slope=0.1,
            lengths=lambda contact: tire.relaxation_lengths(contact.normal_force, contact.gamma),
            initial_conditions=start,
            times=np.linspace(0.0, 2.0, 21),
        )
        assert np.isfinite(system.evaluate_jacobian()).all()
        motion = system.simulate()
        assert motion["vx"][-1] == pytest.approx(motion["w"][-1] * motion["z"][-1], rel=0.01)
        assert motion["vx"][-1] > 1.0


def test_arguments_of_relaxation_are_checked():
    contact = wheel(0.0).contact
    u, v = me.dynamicsymbols("u v")
    with pytest.raises(TypeError, match="`lengths` must be a pair"):
        contact.with_relaxation(0.3, (u, v))
    with pytest.raises(ValueError, match=r"`lengths\[1\]` must be positive"):
        contact.with_relaxation((0.3, 0.0), (u, v))
    with pytest.raises(TypeError, match="`deflections` must be two functions of time"):
        contact.with_relaxation(LENGTHS, (u, u))
    with pytest.raises(ValueError, match="`sliding_slip` must be positive"):
        contact.with_relaxation(LENGTHS, (u, v), sliding_slip=0.0)


def test_arguments_are_checked():
    w = wheel(0.0)
    usual = (w.body, w.B.y, R, w.O, w.N.z, w.N, lambda gap, rate: -gap)
    with pytest.raises(ValueError, match="`axis` must be of unit length"):
        WheelContact(w.body, 2 * w.B.y, *usual[2:])
    with pytest.raises(ValueError, match="`crown_radius` must be smaller than `radius`"):
        WheelContact(*usual, crown_radius=0.4)
    with pytest.raises(TypeError, match="`force` must be a function"):
        WheelContact(*usual[:-1], 5.0)
    with pytest.raises(TypeError, match="`tire` must be a tire"):
        w.contact.loads(1e5)


def test_camber_follows_over_the_relaxation_length():
    w = wheel(0.0)
    e_x, e_y, lag = me.dynamicsymbols("e_x e_y gamma_lag")
    relaxed = w.contact.with_relaxation((0.3, 0.5), (e_x, e_y), camber=lag)
    assert relaxed.gamma == lag
    assert relaxed.deflections == (e_x, e_y, lag)
    rate = sm.solve(relaxed.kinematic_equations[2], lag.diff())[0].subs(lag, 0.1)
    camber, speed = values(w, w.contact.gamma), values(w, w.contact.speed)
    assert values(w, rate) == pytest.approx(abs(speed) / 0.5 * (camber - 0.1), rel=1e-12)


@pytest.mark.parametrize("camber", [0.1, "gamma", sm.Symbol("gamma"), me.dynamicsymbols("e_x")])
def test_camber_that_follows_is_a_further_function_of_time(camber):
    with pytest.raises(TypeError, match="`camber` must be a further function of time"):
        wheel(0.0).contact.with_relaxation((0.3, 0.5), me.dynamicsymbols("e_x e_y"), camber=camber)


def test_a_wheel_at_the_end_of_a_chain_takes_few_calls():
    N, O = inertial_frame()
    frame, hub = N, O
    for k, axis in enumerate("zyxyyy"):
        q, u = me.dynamicsymbols(f"q{k} u{k}")
        turned = frame.orientnew(f"A{k}", "Axis", (q, getattr(frame, axis)))
        turned.set_ang_vel(frame, u * getattr(frame, axis))
        end = hub.locatenew(f"P{k}", turned.x - turned.z)
        end.v2pt_theory(hub, N, turned)
        frame, hub = turned, end
    body = me.RigidBody("wheel", hub, frame, 20, (me.inertia(frame, 1, 2, 1), hub))
    place = me.dynamicsymbols("X Y")
    road = RoadSurface(0.1 * sm.sin(place[0]) * sm.cos(place[1]), place, O, N)
    with cProfile.Profile() as profile:
        contact = WheelContact(body, frame.y, R, road.point, road.normal, N, lambda gap, rate: -gap)
        contact.loads(BrushTire(1000, stiffness=1e4, friction=0.8))
    # 1.7 million; 14 million where SymPy looks for signs and symbols in all of each expression.
    assert pstats.Stats(profile).total_calls < 3e6
