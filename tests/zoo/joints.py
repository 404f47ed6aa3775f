"""Systems of SymPy made of joints; most are examples of sympy.physics.mechanics itself."""

import warnings

import sympy as sm
import sympy.physics.mechanics as me

T = me.dynamicsymbols._t


def cart_pendulum(speeds="u", *, tied=False):
    """A bob pinned to a cart, with a torque actuator; SymPy's example. It may keep above a line."""
    g, l, mc, mp, k = sm.symbols("g l mc mp k")
    force, qp, qc = me.dynamicsymbols("F qp qc")
    up, uc = me.dynamicsymbols("up uc") if speeds == "u" else (qp.diff(T), qc.diff(T))
    rail, cart = me.RigidBody("rail"), me.RigidBody("cart", mass=mc)
    bob, frame = me.Particle("bob", mass=mp), me.ReferenceFrame("bob_frame")
    system = me.System.from_newtonian(rail)
    slider = me.PrismaticJoint("slider", rail, cart, qc, uc, joint_axis=rail.x)
    pin = me.PinJoint(
        "pin",
        cart,
        bob,
        qp,
        up,
        joint_axis=cart.z,
        child_interframe=frame,
        child_point=l * frame.y,
    )
    system.add_joints(slider, pin)
    if speeds == "u":
        system.apply_uniform_gravity(-g * system.y)
    else:
        for body in system.bodies:
            height = body.masscenter.pos_from(system.fixed_point).dot(system.y)
            body.potential_energy = body.mass * g * height
    system.add_loads((cart.masscenter, force * rail.x))
    system.add_actuators(me.TorqueActuator(k * qp, cart.z, frame, cart))
    if tied:
        system.add_holonomic_constraints(
            sm.sympify(bob.masscenter.pos_from(rail.masscenter).dot(system.x))
        )
        if speeds == "u":
            system.q_ind, system.q_dep = qp, qc
            system.u_ind, system.u_dep = up, uc
    return system


def tied_cart_pendulum():
    return cart_pendulum(tied=True)


def box_on_ground():
    """SymPy's example of an auxiliary speed; the normal force is a specified here."""
    g, m, mu = sm.symbols("g m mu")
    q, u, ua = me.dynamicsymbols("q u ua")
    normal, force = me.dynamicsymbols("N F")
    box, system = me.Particle("P", mass=m), me.System()
    system.add_bodies(box)
    box.masscenter.set_pos(system.fixed_point, q * system.x)
    box.masscenter.set_vel(system.frame, u * system.x + ua * system.y)
    system.q_ind, system.u_ind, system.u_aux = [q], [u], [ua]
    system.kdes = [q.diff(T) - u]
    system.apply_uniform_gravity(-g * system.y)
    system.add_loads(
        me.Force(box, normal * system.y), me.Force(box, (force - mu * normal) * system.x)
    )
    return system


def _hung(joint, *, about="z", **options):
    """A rigid body with a general inertia on one joint, offset on both sides."""
    g, m, a, b = sm.symbols("g m a b")
    wall, body = me.RigidBody("wall"), me.RigidBody("body", mass=m)
    body.central_inertia = me.inertia(body.frame, *sm.symbols("Ixx Iyy Izz Ixy Iyz Izx"))
    system = me.System.from_newtonian(wall)
    made = joint(
        "J",
        wall,
        body,
        parent_point=a * wall.x + b * wall.z,
        child_point=-b * body.frame.y + a * body.frame.z,
        **options,
    )
    system.add_joints(made)
    system.apply_uniform_gravity(-g * system.y + 2 * g * system.x)
    return system


def pin():
    return _hung(me.PinJoint)


def prismatic():
    return _hung(me.PrismaticJoint)


def cylindrical():
    return _hung(me.CylindricalJoint)


def planar():
    return _hung(me.PlanarJoint)


def spherical():
    return _hung(me.SphericalJoint)


def space_fixed():
    return _hung(me.SphericalJoint, rot_type="space", rot_order="zxy")


def welded():
    """A rod pinned to a wall, with a disc welded to its end and a damper beside."""
    g, l, m, n, c = sm.symbols("g l m n c")
    wall, rod, disc = (
        me.RigidBody("wall"),
        me.RigidBody("rod", mass=m),
        me.RigidBody("disc", mass=n),
    )
    tilt = me.ReferenceFrame("tilt")
    tilt.orient_axis(rod.frame, rod.frame.x, sm.pi / 5)
    system = me.System.from_newtonian(wall)
    q, u = me.dynamicsymbols("q u")
    system.add_joints(
        me.PinJoint("pin", wall, rod, q, u, joint_axis=wall.z, child_point=l * rod.y),
        me.WeldJoint("weld", rod, disc, parent_point=-l * rod.y, parent_interframe=tilt),
    )
    system.apply_uniform_gravity(-g * wall.y)
    spring = me.LinearPathway(disc.masscenter, wall.masscenter)
    system.add_actuators(me.LinearSpring(c, spring, 2), me.LinearDamper(c / 3, spring))
    return system


def chain():
    """Three bodies on joints of different kinds, one behind the other."""
    g, a = sm.symbols("g a")
    wall = me.RigidBody("wall")
    system = me.System.from_newtonian(wall)
    before = wall
    for k, kind in enumerate((me.SphericalJoint, me.PinJoint, me.CylindricalJoint)):
        body = me.RigidBody(f"b{k}", mass=sm.Symbol(f"m{k}"))
        axis = {} if kind is me.SphericalJoint else {"joint_axis": before.frame.y}
        joint = kind(f"j{k}", before, body, child_point=a * body.frame.x, **axis)
        system.add_joints(joint)
        before = body
    system.apply_uniform_gravity(-g * wall.z)
    return system


def four_bar():
    """SymPy's example: three links on pins, the loop closed by constraints."""
    q, u = me.dynamicsymbols("q1:4"), me.dynamicsymbols("u1:4")
    l, rho, g = sm.symbols("l1:5"), sm.Symbol("rho"), sm.Symbol("g")
    links = [me.RigidBody(f"link{k}", mass=rho * l[k]) for k in range(4)]
    for k, link in enumerate(links):
        size = rho * l[k] ** 3 / 12
        link.central_inertia = me.inertia(link.frame, 0, 0, size)
    system = me.System.from_newtonian(links[0])
    ends = [k.frame.x * size / 2 for k, size in zip(links, l, strict=True)]
    system.add_joints(
        *(
            me.PinJoint(
                f"pin{k}",
                links[k - 1],
                links[k],
                q[k - 1],
                u[k - 1],
                parent_point=ends[k - 1],
                child_point=-ends[k],
                joint_axis=links[k - 1].frame.z,
            )
            for k in (1, 2, 3)
        )
    )
    first = links[0].masscenter.locatenew("A", -ends[0])
    last = links[3].masscenter.locatenew("B", ends[3])
    gap = last.pos_from(first)
    system.add_holonomic_constraints(*(sm.sympify(gap.dot(e)) for e in (system.x, system.y)))
    system.apply_uniform_gravity(-g * system.y)
    system.q_ind, system.q_dep = q[0], q[1:]
    system.u_ind, system.u_dep = u[0], u[1:]
    return system


def sleigh():
    """A planar joint whose body cannot slip sideways: a nonholonomic constraint."""
    m, size, c = sm.symbols("m I c")
    drive = me.dynamicsymbols("P")
    ice, body = me.RigidBody("ice"), me.RigidBody("sleigh", mass=m)
    body.central_inertia = me.inertia(body.frame, 0, 0, size)
    system = me.System.from_newtonian(ice)
    joint = me.PlanarJoint("glide", ice, body, rotation_coordinate=None)
    system.add_joints(joint)
    edge = body.masscenter.locatenew("edge", -c * body.frame.z)
    edge.v2pt_theory(body.masscenter, ice.frame, body.frame)
    slip = edge.vel(ice.frame).dot(body.frame.y)
    system.add_nonholonomic_constraints(slip)
    system.add_loads((body.masscenter, drive * body.frame.z))
    system.u_ind, system.u_dep = system.u[:2], system.u[2:]
    return system


def _silently(function):
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")  # the deprecated classes of SymPy warn of themselves
        return function()


def double_pendulum():
    """SymPy's example of the deprecated JointsMethod, with bodies of the deprecated class."""

    def make():
        q, u = me.dynamicsymbols("q1 q2"), me.dynamicsymbols("u1 u2")
        m, l, g = sm.symbols("m l g")
        ceiling = me.Body("C")
        first, second = me.Body("P1", mass=m), me.Body("P2", mass=m)
        joints = [
            me.PinJoint(
                f"J{k + 1}",
                above,
                below,
                q[k],
                u[k],
                child_point=-l * below.x,
                joint_axis=ceiling.z,
            )
            for k, (above, below) in enumerate(((ceiling, first), (first, second)))
        ]
        first.apply_force(m * g * ceiling.x)
        second.apply_force(m * g * ceiling.x)
        return me.JointsMethod(ceiling, *joints)

    return _silently(make)


def chaos_pendulum():
    """SymPy's example of JointsMethod with rigid bodies and frames between."""

    def make():
        rod_m, plate_m, rod_l, height, width, g = sm.symbols("mA mB lA h w g")
        theta, phi, omega, alpha = me.dynamicsymbols("theta phi omega alpha")
        ground = me.ReferenceFrame("N")
        rod_frame, plate_frame = me.ReferenceFrame("A"), me.ReferenceFrame("B")
        rod = me.Body(
            "rod",
            mass=rod_m,
            frame=rod_frame,
            central_inertia=me.inertia(rod_frame, rod_l**2 * rod_m / 12, 0, 0),
        )
        size = plate_m / 12
        plate = me.Body(
            "plate",
            mass=plate_m,
            frame=plate_frame,
            central_inertia=me.inertia(
                plate_frame, size * height**2, size * width**2, size * (height**2 + width**2)
            ),
        )
        ceiling = me.Body("C", frame=ground)
        hinge = me.PinJoint(
            "J1",
            ceiling,
            rod,
            coordinates=theta,
            speeds=omega,
            child_point=-rod_l / 2 * rod.z,
            joint_axis=ceiling.y,
        )
        turn = me.PinJoint(
            "J2",
            rod,
            plate,
            coordinates=phi,
            speeds=alpha,
            parent_point=rod_l / 2 * rod.z,
            joint_axis=rod.z,
        )
        rod.apply_force(rod_m * g * ground.z)
        plate.apply_force(plate_m * g * ground.z)
        return me.JointsMethod(ceiling, hinge, turn)

    return _silently(make)


SYSTEMS = {
    make.__name__: make
    for make in (
        cart_pendulum, tied_cart_pendulum, box_on_ground, pin, prismatic, cylindrical, planar,
        spherical, space_fixed, welded, chain, four_bar, sleigh, double_pendulum, chaos_pendulum,
    )
}  # fmt: skip
