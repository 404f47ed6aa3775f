"""Equations of motion to read: equal to those that are computed, and as short as a textbook's."""

import numpy as np
import pytest
import sympy as sm
import sympy.physics.mechanics as me

import zoo
from pydy import System
from pydy.mechanics import Definition
from pydy.models import multi_mass_spring_damper, n_link_pendulum_on_cart
from zoo import inertial_frame
from zoo.by_hand import MECHANISMS
from zoo.cases import system_of

T = me.dynamicsymbols._t
MODELS = {**zoo.MODELS, **{n: MECHANISMS[n] for n in ("camera", "gimbals", "coupler", "wheel")}}


def arm(count, axes="zzzzzz", prefix="l"):
    """An arm of links with lengths l, mass centres at lc and inertias I about them."""
    frame, point = inertial_frame()
    base = frame
    q, u = me.dynamicsymbols(f"q1:{count + 1}"), me.dynamicsymbols(f"u1:{count + 1}")
    m, g, inertias = sm.symbols(f"m1:{count + 1}"), sm.Symbol("g"), sm.symbols(f"I1:{count + 1}")
    lengths, centres = sm.symbols(f"{prefix}1:{count + 1}"), sm.symbols(f"lc1:{count + 1}")
    bodies, loads = [], []
    for k in range(count):
        own = frame.orientnew(f"A{k}", "Axis", (q[k], getattr(frame, axes[k])))
        centre = point.locatenew(f"C{k}", centres[k] * own.x)
        inertia = me.inertia(own, 0, inertias[k], inertias[k])
        bodies.append(me.RigidBody(f"b{k}", centre, own, m[k], (inertia, centre)))
        loads.append((centre, -m[k] * g * base.y))
        point, frame = point.locatenew(f"P{k}", lengths[k] * own.x), own
    return System(Definition(base, q, u, bodies=bodies, loads=loads))


def test_a_two_link_arm_is_that_of_the_textbook():
    """Spong, Hutchinson, Vidyasagar, Robot Modeling and Control, 2006, section 7.3.2."""
    system = arm(2)
    made = system.equations_of_motion()
    m1, m2, l1, lc1, lc2, i1, i2, g, c1, c2, s2, c12 = sm.symbols(
        "m1 m2 l1 lc1 lc2 I1 I2 g c1 c2 s2 c12"
    )
    u1, u2 = system.speeds
    coupled = m2 * (lc2**2 + l1 * lc2 * c2) + i2
    matrix = sm.Matrix(
        [
            [m1 * lc1**2 + m2 * (l1**2 + lc2**2 + 2 * l1 * lc2 * c2) + i1 + i2, coupled],
            [coupled, m2 * lc2**2 + i2],
        ]
    )
    h = -m2 * l1 * lc2 * s2
    forces = sm.Matrix(
        [
            -h * (2 * u1 * u2 + u2**2) - (m1 * lc1 + m2 * l1) * g * c1 - m2 * lc2 * g * c12,
            h * u1**2 - m2 * lc2 * g * c12,
        ]
    )
    assert made.mass_matrix == matrix  # printed alike
    assert (made.forcing - forces).expand() == sm.zeros(2, 1)
    assert sm.count_ops(made.forcing) <= sm.count_ops(forces)
    q1, q2 = system.coordinates
    assert made.names == {c1: sm.cos(q1), c12: sm.cos(q1 + q2), c2: sm.cos(q2), s2: sm.sin(q2)}


def numbers_of(system, made, x):
    """The short equations' M, F and q' in numbers, names put in one after the other."""
    known = {**dict(zip(system.states, x, strict=True)), **system.constants, T: 0.0}
    known.update({s: 1.0 for s in system.constants_symbols if s not in known})
    known.update(dict.fromkeys(system.specifieds_symbols, 0.0))
    found = []
    for matrix in (made.mass_matrix, made.forcing, made.kinematics):
        symbols, values = list(known), list(known.values())
        for symbol, meaning in made.names.items():
            if symbol not in known:
                values.append(sm.lambdify(symbols, meaning)(*values))
                symbols.append(symbol)
        found.append(np.array(sm.lambdify(symbols, matrix)(*values), dtype=float))
    return found


def is_what_is_computed(system, x):
    """The short equations are those that are computed, at a state."""
    n = len(system.coordinates)
    matrix, forcing, rates = numbers_of(system, system.equations_of_motion(), x)
    computed = system.mass_matrix(x[:n])
    assert np.abs(matrix - computed).max() <= 1e-12 * np.abs(computed).max()
    bias = system.bias(x[:n], x[n : n + len(system.speeds)])
    size = np.abs(bias).max() + np.abs(computed).max()
    assert np.abs(forcing[:, 0] + bias).max() <= 1e-12 * size
    moved = system.evaluate_ode(x)[:n]
    assert np.abs(rates[:, 0] - moved).max() <= 1e-12 * np.abs(moved).max()


@pytest.mark.parametrize("name", [n for n in MODELS if n not in ("added_mass", "timed")])
def test_what_is_read_is_what_is_computed(name):
    model = MODELS[name]()
    system = system_of(model, specifieds=None)
    x = np.random.default_rng(1).uniform(0.3, 0.9, len(system.states))
    quaternion = [system.states.index(s) for s in model.quaternion]
    x[quaternion] /= np.linalg.norm(x[quaternion]) or 1.0
    is_what_is_computed(system, x)


@pytest.mark.parametrize("seed", range(4))
def test_body_rates_of_euler_angles_are_what_is_computed(seed):
    """q' divides by a sine or cosine, which meets itself in velocities and in M."""
    rng = np.random.default_rng(seed)
    q, u = me.dynamicsymbols("q1:4"), me.dynamicsymbols("u1:4")
    m, g, l, i1, i2, i3 = sm.symbols("m g l i1 i2 i3")
    frame, origin = inertial_frame()
    order = str(rng.choice(["123", "132", "231", "312", "321", "121", "232", "313", "323"]))
    body = frame.orientnew("B", "Body", q, order)
    w = body.ang_vel_in(frame)
    sizes = [1, 1, l] if seed % 2 else [1, 1, 1]
    rows = [size * w.dot(e) - s for size, e, s in zip(sizes, body, u, strict=True)]
    if rng.random() < 0.5:
        w = sum((s / size * e for size, s, e in zip(sizes, u, body, strict=True)), me.Vector(0))
        body.set_ang_vel(frame, w)
    centre = origin.locatenew("C", l * rng.choice([body.x, body.z]))
    inertia = (me.inertia(body, i1, i2, i3), origin)
    top = me.RigidBody("top", centre, body, m, inertia)
    values = {m: 2.0, g: 9.81, l: 0.7, i1: 2.0, i2: 2.3, i3: 3.1}
    definition = Definition(
        frame, q, u, bodies=[top], loads=[(centre, -m * g * frame.z)], kinematic_equations=rows
    )
    is_what_is_computed(System(definition, values), rng.uniform(0.3, 0.9, 6))


@pytest.mark.parametrize("along", ["components", "rates"])
def test_spherical_coordinates_are_what_is_computed(along):
    """Velocities along the axes are those of the angles times r, and times r sin θ."""
    q, u = me.dynamicsymbols("r theta phi"), me.dynamicsymbols("v1:4")
    m, g, k = sm.symbols("m g k")
    r, theta, phi = q
    frame, origin = inertial_frame()
    across = sm.sin(theta) * (sm.cos(phi) * frame.x + sm.sin(phi) * frame.y)
    point = origin.locatenew("P", r * (across + sm.cos(theta) * frame.z))
    sizes = (1, r, r * sm.sin(theta)) if along == "components" else (1, 1 / sm.cos(theta), r**2)
    rows = [size * a.diff(T) - s for size, a, s in zip(sizes, q, u, strict=True)]
    loads = [(point, -m * g * frame.z - k * sm.tan(theta) * sm.cos(theta) ** 2 * frame.x)]
    definition = Definition(
        frame, q, u, bodies=[me.Particle("p", point, m)], loads=loads, kinematic_equations=rows
    )
    system = System(definition, {m: 2.0, g: 9.81, k: 1.3})
    is_what_is_computed(system, np.random.default_rng(3).uniform(0.3, 0.9, 6))


@pytest.mark.parametrize(("count", "axes"), [(3, "zzz"), (3, "zyy"), (3, "zxz"), (4, "zyyz")])
def test_arms_in_space_are_what_is_computed(count, axes):
    system = arm(count, axes)
    x = np.random.default_rng(2).uniform(0.3, 0.9, 2 * count)
    made = system.equations_of_motion()
    matrix, forcing, _ = numbers_of(system, made, x)
    assert matrix == pytest.approx(system.mass_matrix(x[:count]), rel=1e-12)
    assert forcing[:, 0] == pytest.approx(-system.bias(x[:count], x[count:]), rel=1e-11, abs=1e-11)
    assert all(s.name.startswith("z") for s in made.names if s.name[0] not in "cs")
    assert any(s.name.startswith("z") for s in made.names) == (count > 3)


def test_squares_stay_where_double_angles_are_longer():
    made = arm(2, "yz").equations_of_motion()
    c2 = sm.Symbol("c2")
    assert made.names[c2] == sm.cos(me.dynamicsymbols("q2"))
    assert made.mass_matrix[0, 0].has(c2**2)


def test_names_are_not_those_of_constants():
    system = arm(2, prefix="c")  # lengths c1, c2
    made = system.equations_of_motion()
    symbols = {s.name for s in made.names}
    assert "cos_1" in symbols
    assert "c1" not in symbols
    assert sm.Symbol("c1") in made.mass_matrix.free_symbols


def test_one_name_is_of_one_angle():
    """Those of z − n and m + n + z are spelled alike."""
    z, m, n = q = me.dynamicsymbols("z m n")
    frame, origin = inertial_frame()
    point = origin.locatenew("P", z * frame.x + m * frame.y + n * frame.z)
    loads = [(point, sm.cos(z - n) * frame.x + sm.cos(m + n + z) * frame.y)]
    definition = Definition(frame, q, bodies=[me.Particle("bob", point, 2)], loads=loads)
    is_what_is_computed(System(definition), np.random.default_rng(4).uniform(0.3, 0.9, 6))


def test_written_out_nothing_is_named():
    system = n_link_pendulum_on_cart(1, cart_force=False)
    made = system.equations_of_motion(short=False)
    q1, l0, m1 = system.coordinates[1], *sm.symbols("l0 m1")
    assert made.names == {}
    assert made.mass_matrix[0, 1] == -l0 * m1 * sm.cos(q1)
    short = system.equations_of_motion()
    assert short.written_out(short.mass_matrix) == made.mass_matrix
    with pytest.raises(TypeError, match="`short`"):
        system.equations_of_motion(short="no")


def test_differences_of_angles_and_other_coordinates_have_names():
    x, y = me.dynamicsymbols("alpha beta")
    frame, origin = inertial_frame()
    one = frame.orientnew("A", "Axis", (x, frame.z))
    two = frame.orientnew("B", "Axis", (y, frame.z))
    elbow = origin.locatenew("E", 2 * one.x)
    bobs = [
        me.Particle("bob", elbow, sm.Symbol("m")),
        me.Particle("tip", elbow.locatenew("P", two.x), sm.Rational(1, 12)),
    ]
    made = System(Definition(frame, [x, y], bodies=bobs)).equations_of_motion()
    assert made.mass_matrix[0, 1] == sm.Symbol("calpham_beta") / 6 or "m" in str(made.names)
    assert [m for m in made.names.values() if m == sm.cos(x - y)]


def test_constraints_bring_multipliers():
    system = system_of(zoo.MODELS["fourbar"]())
    made = system.equations_of_motion()
    x = np.random.default_rng(1).uniform(0.3, 0.9, len(system.states))
    known = {**dict(zip(system.states, x, strict=True)), **system.constants}
    jacobian = np.array(made.written_out(made.constraint_jacobian).subs(known), dtype=float)
    slopes = system.evaluate_jacobian(x, wrt=system.speeds, of="velocity")
    assert jacobian == pytest.approx(slopes, rel=1e-12, abs=1e-13)
    assert "J.T λ" in str(made)
    assert r"^T \lambda" in made._repr_latex_()


def test_notebooks_show_latex_and_fold_many_names():
    small = multi_mass_spring_damper().equations_of_motion()
    assert small._repr_latex_().startswith(r"$\displaystyle \begin{aligned}")
    assert small._repr_html_() is None
    html = arm(4).equations_of_motion()._repr_html_()
    assert "<details><summary>" in html
    assert "intermediate quantities" in html


def test_functions_of_other_kinds_stand_for_themselves():
    x, v = me.dynamicsymbols("x v")
    k, m, a = sm.symbols("k m a")
    frame, origin = inertial_frame()
    point = origin.locatenew("P", x * frame.x)
    force = -k * x / sm.sqrt(x**2 + a**2) - sm.Max(x, 0) + sm.Piecewise((1, x < a), (k, True))
    made = System(
        Definition(frame, [x], [v], bodies=[me.Particle("b", point, m)],
                   loads=[(point, force * frame.x), (point, -sm.exp(-v) * frame.x)])
    ).equations_of_motion()  # fmt: skip
    numbers = {x: 0.7, v: 0.3, k: 2.1, m: 1.3, a: 0.4}
    expected = (force - sm.exp(-v)).subs(numbers)
    assert float(made.forcing[0].subs(numbers)) == pytest.approx(float(expected), rel=1e-14)
