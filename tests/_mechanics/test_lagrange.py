"""Lagrange's equations formed on the graph, against SymPy's and against Kane's."""

import numpy as np
import pytest
import sympy as sm
import sympy.physics.mechanics as me

from pydy.system import System
from zoo import inertial_frame
from zoo.cases import close

T = me.dynamicsymbols._t


def links(n):
    """A chain of pendulums."""
    q = me.dynamicsymbols(f"q0:{n}")
    m, l, g = sm.symbols(f"m0:{n}"), sm.symbols(f"l0:{n}"), sm.Symbol("g")
    x = y = energy = sm.S.Zero
    for k in range(n):
        x, y = x + l[k] * sm.sin(q[k]), y - l[k] * sm.cos(q[k])
        energy += m[k] * (x.diff(T) ** 2 + y.diff(T) ** 2) / 2 - m[k] * g * y
    return me.LagrangesMethod(energy, q)


def pushed_cart():
    """A pendulum on a cart with a driver's force, friction and a torque on the rod."""
    x, angle, push = me.dynamicsymbols("x theta P")
    m, M, l, g, c, k = sm.symbols("m M l g c k")
    ground, rod = me.ReferenceFrame("N"), me.ReferenceFrame("R")
    rod.orient_axis(ground, ground.z, angle)
    origin = me.Point("O")
    origin.set_vel(ground, 0)
    cart = origin.locatenew("C", x * ground.x)
    cart.set_vel(ground, x.diff(T) * ground.x)
    bob = cart.locatenew("B", -l * rod.y)
    bob.v2pt_theory(cart, ground, rod)
    bodies = [me.Particle("cart", cart, M), me.Particle("bob", bob, m)]
    bodies[0].potential_energy = k * x**2 / 2
    bodies[1].potential_energy = m * g * bob.pos_from(origin).dot(ground.y)
    loads = [
        (cart, (push - c * x.diff(T)) * ground.x),
        (rod, -c * angle.diff(T) * ground.z),
        (bob, push * sm.sin(T) * rod.x),
    ]
    lagrangian = me.Lagrangian(ground, *bodies)
    return me.LagrangesMethod(lagrangian, [x, angle], forcelist=loads, frame=ground)


def shaken_pendulum():
    """A pendulum whose pivot moves as prescribed, with a length that depends on time."""
    angle, height = me.dynamicsymbols("theta h")
    m, l, g = sm.symbols("m l g")
    reach = l * (1 + sm.cos(T) / 5)
    x, y = reach * sm.sin(angle), height - reach * sm.cos(angle)
    energy = m * (x.diff(T) ** 2 + y.diff(T) ** 2) / 2 - m * g * y
    return me.LagrangesMethod(energy, [angle])


def spherical_pendulum():
    theta, phi = me.dynamicsymbols("theta phi")
    m, l, g = sm.symbols("m l g")
    kinetic = m * l**2 * (theta.diff(T) ** 2 + sm.sin(theta) ** 2 * phi.diff(T) ** 2) / 2
    return me.LagrangesMethod(kinetic + m * g * l * sm.cos(theta), [theta, phi])


def charge_in_a_field():
    """L is linear in the velocity too, with a force that depends on the acceleration."""
    x, y = me.dynamicsymbols("x y")
    m, b, a = sm.symbols("m b a")
    ground, point = me.ReferenceFrame("N"), me.Point("P")
    point.set_vel(ground, x.diff(T) * ground.x + y.diff(T) * ground.y)
    kinetic = m * (x.diff(T) ** 2 + y.diff(T) ** 2) / 2
    magnetic = b * (x * y.diff(T) - y * x.diff(T)) * (x**2 + 1)
    loads = [(point, -a * x.diff(T, 2) * ground.x)]
    return me.LagrangesMethod(kinetic + magnetic, [x, y], forcelist=loads, frame=ground)


MODELS = [lambda: links(1), lambda: links(3), pushed_cart, shaken_pendulum, spherical_pendulum]
MODELS += [charge_in_a_field]


def random_numbers(system, seed):
    rng = np.random.default_rng(seed)
    constants = {s: rng.uniform(0.5, 2.0) for s in system.constants_symbols}
    return constants, rng.uniform(-1.0, 1.0, system.num_states), rng


@pytest.mark.parametrize("make", MODELS)
def test_the_equations_are_those_of_sympy(make):
    method = make()
    system = System(method)
    constants, x, rng = random_numbers(system, 3)
    r = rng.normal(size=system.num_specifieds)
    p = list(constants.values())
    found = [system.evaluate_ode(x, 0.7, r=r, p=p), system.evaluate_jacobian(x, 0.7, r=r, p=p)]
    method.form_lagranges_equations()
    other = System(method, equations="method")
    assert list(other.constants_symbols) == list(system.constants_symbols)
    assert list(other.specifieds_symbols) == list(system.specifieds_symbols)
    expected = other.evaluate_ode(x, 0.7, r=r, p=p)
    close(found[0], expected, 1e-12)
    close(found[1], other.evaluate_jacobian(x, 0.7, r=r, p=p), 1e-11)


def test_speeds_are_the_rates_of_the_coordinates():
    system = System(spherical_pendulum())
    theta, phi = system.coordinates
    assert system.speeds == [theta.diff(T), phi.diff(T)]
    system.initial_conditions = {theta: 1.0, phi.diff(T): 0.5}
    system.times = np.linspace(0.0, 1.0, num=21)
    system.ode_solver = "dop853"
    trajectory = system.simulate(rtol=1e-11, atol=1e-11)
    turning = np.sin(trajectory[theta]) ** 2 * trajectory[phi.diff(T)]  # angular momentum
    close(turning, np.full(21, 0.5 * np.sin(1.0) ** 2), 1e-9)


def test_the_same_motion_as_with_kanes_equations():
    method = pushed_cart()
    lagrange = System(method)
    x, angle = lagrange.coordinates
    v, w = me.dynamicsymbols("v omega")
    ground = method.inertial
    (cart, push), (rod, friction), (bob, tip) = method.loads
    m, M, g, k = sm.symbols("m M g k")
    rates = {x.diff(T): v, angle.diff(T): w}

    def written(vector):
        return vector.subs(rates)

    kane = me.KanesMethod(
        ground,
        [x, angle],
        [v, w],
        kd_eqs=[x.diff(T) - v, angle.diff(T) - w],
        bodies=[me.Particle("cart", cart, M), me.Particle("bob", bob, m)],
        forcelist=[
            (cart, written(push) - k * x * ground.x),
            (rod, written(friction)),
            (bob, written(tip) - m * g * ground.y),
        ],
    )
    other = System(kane)
    constants, state, _ = random_numbers(lagrange, 5)
    drive = {next(iter(lagrange.specifieds_symbols)): 0.8}
    close(
        lagrange.evaluate_ode(state, 0.4, r=drive, p=constants),
        other.evaluate_ode(state, 0.4, r=drive, p=constants),
        1e-12,
    )


def test_twenty_links_cost_no_more_operations_than_they_did():
    # From bodies 1,009: a Lagrangian gives the mass matrix alone.
    system = System(links(20))
    program = system.model.compiled("rates").program
    assert sum(program.operation_count["run"].values()) <= 4785


def hung_in_the_plane():
    """Two masses on rods, in Cartesian coordinates: two holonomic constraints."""
    x, y, a, b = me.dynamicsymbols("x y a b")
    m, n, l, g = sm.symbols("m n l g")
    kinetic = m * (x.diff(T) ** 2 + y.diff(T) ** 2) + n * (a.diff(T) ** 2 + b.diff(T) ** 2)
    rods = [x**2 + y**2 - l**2, (a - x) ** 2 + (b - y) ** 2 - l**2]
    return me.LagrangesMethod(kinetic / 2 - g * (m * y + n * b), [x, y, a, b], hol_coneqs=rods)


def skate():
    """A blade on a slope, which cannot slip sideways, with a driving force along it."""
    x, y, turn, drive = me.dynamicsymbols("x y theta P")
    m, size, g = sm.symbols("m I g")
    ground, blade, point = me.ReferenceFrame("N"), me.ReferenceFrame("B"), me.Point("C")
    blade.orient_axis(ground, ground.z, turn)
    point.set_vel(ground, x.diff(T) * ground.x + y.diff(T) * ground.y)
    kinetic = m * (x.diff(T) ** 2 + y.diff(T) ** 2) / 2 + size * turn.diff(T) ** 2 / 2
    return me.LagrangesMethod(
        kinetic - m * g * y,
        [x, y, turn],
        forcelist=[(point, drive * blade.x)],
        frame=ground,
        nonhol_coneqs=[y.diff(T) * sm.cos(turn) - x.diff(T) * sm.sin(turn)],
    )


def guided_skate():
    """Both kinds of constraints; the rail moves with time."""
    x, y, turn = me.dynamicsymbols("x y theta")
    m, size, c = sm.symbols("m I c")
    kinetic = m * (x.diff(T) ** 2 + y.diff(T) ** 2) / 2 + size * turn.diff(T) ** 2 / 2
    return me.LagrangesMethod(
        kinetic,
        [x, y, turn],
        hol_coneqs=[y - sm.sin(c * x) - c * T],
        nonhol_coneqs=[y.diff(T) * sm.cos(turn) - x.diff(T) * sm.sin(turn)],
    )


CONSTRAINED = [hung_in_the_plane, skate, guided_skate]


def augmented(method, values):
    """u' and multipliers, from the equations of SymPy with both as unknowns."""
    n = len(method.q)
    inner = {s: sm.Dummy() for s in values}

    def number(matrix):
        plain = matrix.xreplace(inner).subs(T, 0).doit()
        return np.array(plain.xreplace({d: values[s] for s, d in inner.items()}), dtype=float)

    whole = number(method.mass_matrix_full[n:, n:])
    found = np.linalg.solve(whole, number(method.forcing_full[n:, :])).ravel()
    return found[:n], found[n:]


@pytest.mark.parametrize("make", CONSTRAINED)
def test_constrained_equations_are_those_of_sympy(make):
    method = make()
    system = System(method)
    rng = np.random.default_rng(8)
    system.constants = {s: rng.uniform(0.5, 2.0) for s in system.constants_symbols}
    system.specifieds = {s: rng.uniform(0.5, 2.0) for s in system.specifieds_symbols}
    system.initial_conditions = {s: rng.uniform(0.3, 0.9) for s in system.states}
    system.set_dependent_initial_conditions()
    x = system.initial_conditions
    multipliers = system.constraint_forces
    system.outputs = dict(multipliers)
    rates = dict(zip(system.states, system.evaluate_ode(), strict=True))
    method.form_lagranges_equations()
    values = {**system.constants, **system.specifieds, **x}
    accelerations, lam = augmented(method, values)
    close([rates[q.diff(T)] for q in method.q], accelerations, 1e-11)
    n = len(system.outputs_symbols) - system.num_constraints
    close(system.evaluate_outputs()[:n], lam, 1e-10)


def test_a_pendulum_in_cartesian_coordinates_swings_as_one_in_an_angle():
    x, y, angle = me.dynamicsymbols("x y theta")
    m, l, g = sm.symbols("m l g")
    kinetic = m * (x.diff(T) ** 2 + y.diff(T) ** 2) / 2
    rod = x**2 + y**2 - l**2
    system = System(me.LagrangesMethod(kinetic - m * g * y, [x, y], hol_coneqs=[rod]))
    turning = m * l**2 * angle.diff(T) ** 2 / 2 + m * g * l * sm.cos(angle)
    other = System(me.LagrangesMethod(turning, [angle]))
    numbers = {m: 0.7, l: 1.3, g: 9.81}
    for one, start in (
        (system, {x: 1.3 * np.sin(0.5), y: -1.3 * np.cos(0.5)}),
        (other, {angle: 0.5}),
    ):
        one.constants, one.initial_conditions = numbers, start
        one.times, one.ode_solver = np.linspace(0.0, 4.0, 41), "dop853"
    system.outputs = {"tension": -2 * l * system.constraint_forces["lambda0"]}
    swing = system.simulate(rtol=1e-11, atol=1e-11, constraints="project")
    true = other.simulate(rtol=1e-11, atol=1e-11)
    close(swing[x], 1.3 * np.sin(true[angle]), 1e-8)
    # The rod carries the weight along it, and turns the mass.
    pull = 0.7 * (9.81 * np.cos(true[angle]) + 1.3 * true[angle.diff(T)] ** 2)
    close(swing["tension"], pull, 1e-7)


def test_constraints_go_with_the_equations_of_the_lagrangian_alone():
    method = hung_in_the_plane()
    method.form_lagranges_equations()
    with pytest.raises(ValueError, match=r"`equations='method'` is not possible .* constraints"):
        System(method, equations="method")


def test_constraints_that_contradict_each_other_are_named():
    x, y = me.dynamicsymbols("x y")
    energy = x.diff(T) ** 2 + y.diff(T) ** 2
    with pytest.raises(ValueError, match=r"contradict each other: .*holonomic constraint"):
        System(me.LagrangesMethod(energy, [x, y], hol_coneqs=[x - y, x - y + 1]))


def test_constraints_that_are_not_linear_in_the_velocities_are_named():
    x, y = me.dynamicsymbols("x y")
    energy, row = x.diff(T) ** 2 + y.diff(T) ** 2, x.diff(T) ** 2 - y.diff(T)
    with pytest.raises(ValueError, match=r"velocity constraint 0, .* is not linear in the speeds"):
        System(me.LagrangesMethod(energy, [x, y], nonhol_coneqs=[row]))


def test_what_cannot_be_formed_is_named():
    x = me.dynamicsymbols("x")
    ground, point = me.ReferenceFrame("N"), me.Point("P")
    point.set_vel(ground, x.diff(T) * ground.x)
    method = me.LagrangesMethod(x.diff(T) ** 2, [x], forcelist=[(point, ground.x)])
    with pytest.raises(ValueError, match="no `frame`"):
        System(method)
    with pytest.raises(ValueError, match="form_lagranges_equations"):
        System(me.LagrangesMethod(x.diff(T) ** 2, [x]), equations="method")
    with pytest.raises(ValueError, match="second derivatives"):
        System(me.LagrangesMethod(x.diff(T) ** 2 + x * x.diff(T, 2), [x]))
    with pytest.raises(TypeError, match="a KanesMethod, LagrangesMethod or System"):
        System(x)


@pytest.mark.parametrize("load", ["torque", "force", "bead"])
@pytest.mark.parametrize("rate", [True, False])
def test_loads_that_move_with_speeds_of_kanes_are_not_lost(load, rate):
    """They do no work in q', so that a damper vanished without a word."""
    q, u = me.dynamicsymbols("q u")
    m, l, c = sm.symbols("m l c")
    if rate:
        u = q.diff(T)
    ground, rod, pivot = me.ReferenceFrame("N"), me.ReferenceFrame("A"), me.Point("O")
    pivot.set_vel(ground, 0)
    rod.orient_axis(ground, ground.z, q)
    rod.set_ang_vel(ground, u * ground.z)
    bob = pivot.locatenew("P", l * rod.x)
    bob.v2pt_theory(pivot, ground, rod)
    bead = pivot.locatenew("Q", l * q * ground.x)
    bead.set_vel(ground, l * u * ground.x)
    damper = {
        "torque": (rod, -c * l**2 * q.diff(T) * ground.z),
        "force": (bob, -c * l * q.diff(T) * rod.y),
        "bead": (bead, -c * l * q.diff(T) * ground.x),
    }[load]
    method = me.LagrangesMethod(
        m * l**2 * q.diff(T) ** 2 / 2, [q], forcelist=[damper], frame=ground
    )
    if rate:
        system = System(method, {m: 2.0, l: 0.3, c: 0.5})
        close(system.evaluate_ode([0.3, 1.2]), [1.2, -0.25 * 1.2], 1e-14)
        return
    with pytest.raises(ValueError, match=r"`q\(t\)`, but .* moves with `u\(t\)`\."):
        System(method, {m: 2.0, l: 0.3, c: 0.5})


def test_a_force_on_a_base_whose_speed_is_given_does_no_work():
    q, v, push = me.dynamicsymbols("q v F")
    ground, rod, base = me.ReferenceFrame("N"), me.ReferenceFrame("A"), me.Point("O")
    base.set_vel(ground, v * ground.x)
    rod.orient_axis(ground, ground.z, q)
    bob = base.locatenew("P", rod.x)
    bob.v2pt_theory(base, ground, rod)
    energy = bob.vel(ground).dot(bob.vel(ground)) / 2
    loads = [(base, push * ground.x), (bob, -3 * ground.y)]
    system = System(me.LagrangesMethod(energy, [q], loads, frame=ground))
    system.specifieds = {v: sm.sin(T)}
    # q'' = v' sin q - 3 cos q
    expected = [1.2, np.cos(0.4) * np.sin(0.3) - 3 * np.cos(0.3)]
    close(system.evaluate_ode([0.3, 1.2], 0.4), expected, 1e-14)


def two_links(*, lagrangian=None, spring=False):
    """A pendulum of a particle and a rod, with its bodies, and by hand its energies."""
    q = me.dynamicsymbols("q1:3")
    u = [a.diff(T) for a in q]
    m, length, g, k = sm.symbols("m l g k")
    ground, origin = inertial_frame()
    first, second = (
        ground.orientnew(n, "Axis", (a, ground.z)) for n, a in zip("AB", q, strict=True)
    )
    bob, centre = origin.locatenew("P", length * first.x), me.Point("Q")
    centre.set_pos(bob, length * second.x)
    bob.v2pt_theory(origin, ground, first)
    centre.v2pt_theory(bob, ground, second)
    inertia = me.inertia(second, 0, 0, m * length**2 / 12), centre
    bodies = [me.Particle("bob", bob, m), me.RigidBody("rod", centre, second, m, inertia)]
    for body in bodies:
        body.potential_energy = m * g * body.masscenter.pos_from(origin).dot(ground.y)
    made = me.Lagrangian(ground, *bodies) if lagrangian is None else lagrangian(q, u, m, length, g)
    loads = [(first, -k * q[0] * ground.z)] if spring else []
    method = me.LagrangesMethod(made, q, bodies=bodies, frame=ground, forcelist=loads)
    return System(method, {m: 2.0, length: 0.5, g: 9.81, **({k: 3.0} if spring else {})})


@pytest.mark.parametrize("spring", [False, True])
def test_the_energy_is_that_of_the_bodies_that_were_given(spring):
    system = two_links(spring=spring)
    a, b, u, v = state = [0.3, -0.4, 0.7, 1.1]
    m, length, g = 2.0, 0.5, 9.81
    kinetic = m * length**2 * (u**2 + v**2 * (1 + 1 / 12) / 2 + u * v * np.cos(a - b))
    potential = m * g * length * (2 * np.sin(a) + np.sin(b)) + (1.5 * a**2 if spring else 0.0)
    found = system.evaluate_energy(state)
    assert found == pytest.approx([kinetic, potential, kinetic + potential], rel=1e-13)


def test_energy_is_kept_by_a_lagrangian_with_bodies():
    system = two_links()
    system.times = np.linspace(0.0, 3.0, 31)
    system.initial_conditions = dict(zip(system.states, [0.3, -0.4, 0.7, 1.1], strict=True))
    total = system.simulate(rtol=1e-11, atol=1e-11).energy[:, 2]
    assert np.ptp(total) < 1e-8


def test_bodies_that_are_not_those_of_the_lagrangian_have_no_known_potential():
    system = two_links(
        lagrangian=lambda q, u, m, l, g: m * l**2 * (u[0] ** 2 + 3 * u[1] ** 2) - m * g * l * q[0]
    )
    assert system.evaluate_ode([0.3, -0.4, 0.7, 1.1])[2:] == pytest.approx([-9.81, 0.0])
    with pytest.raises(ValueError, match="in another way than the kinetic energy of the `bodies`"):
        system.evaluate_energy([0.3, -0.4, 0.7, 1.1])


@pytest.mark.parametrize("formed", [False, True])
def test_a_constant_that_cancels_from_a_lagrangian_without_bodies_is_a_constant(formed):
    q = me.dynamicsymbols("q")
    m, l, g, height = sm.symbols("m l g h")
    energy = m * l**2 * q.diff(T) ** 2 / 2 - m * g * (l * sm.sin(q) + height)
    method = me.LagrangesMethod(energy, [q])
    if formed:
        method.form_lagranges_equations()
    system = System(method, {m: 2.0, l: 0.5, g: 9.81, height: 3.0})
    assert height in system.constants_symbols
    assert system.evaluate_ode([0.3, 0.0])[1] == pytest.approx(-9.81 / 0.5 * np.cos(0.3))
    with pytest.raises(ValueError, match="which is not one of the constants"):
        system.constants = {sm.Symbol("other"): 1.0}
