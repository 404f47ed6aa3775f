"""A mechanism's data as SymPy's bodies, joints and loads, for each front end."""

import warnings

import numpy as np
import sympy as sm
import sympy.physics.mechanics as me

from mechanisms.drawing import T, vector
from mechanisms.generate import physical, replaced
from mechanisms.joints import JOINTS
from mechanisms.loads import LOADS
from mechanisms.loops import LOOPS
from mechanisms.oracle import World, layout, mixing
from mechanisms.taylor import pivots
from pydy.mechanics import Definition


class Model:
    """Bodies, loads, coordinates and constraints in SymPy, and the numbers of their symbols."""

    def __init__(self, data, joints=False, rates=False, positive=None):
        self.data = data
        self.said = data["said"] or bool(data["auxiliary"])
        self.real = physical(data)
        self.constants, self.specifieds, self.path_of = {}, {}, {}
        self._names = {}
        self.tree = replaced(self.real, self._symbol)
        self.parents = [body["on"] for body in data["bodies"]]
        self.kinds = [body["joint"] for body in data["bodies"]]
        self.places, nq, nu = layout(data)
        self.q = [me.dynamicsymbols(f"q{k}") for k in range(nq)]
        rates = rates and nq == nu and not data["speeds"]
        self.u = (
            [q.diff(T) for q in self.q]
            if rates
            else [
                me.dynamicsymbols(f"u{k}", **({"positive": True} if k == positive else {}))
                for k in range(nu)
            ]
        )
        self.ground, self.origin = me.ReferenceFrame("N"), me.Point("O")
        self.origin.set_vel(self.ground, 0)
        self._elsewhere()
        self._kinematic()
        self.auxiliary, self.forces, self.noncontributing = [], [], []
        if joints:
            self._joints()
        else:
            self._tree()
        self.loads = self._gravity()
        for load in self.tree["loads"]:
            self.loads += LOADS[load["kind"]].symbols(self, load)
        self.loads += self.noncontributing
        self._rows()

    def _elsewhere(self):
        """Another mechanism on the same origin, as in a notebook: nothing may depend on it."""
        axes = me.ReferenceFrame("elsewhere")
        axes.orient_axis(self.ground, self.ground.y, me.dynamicsymbols("turn_elsewhere"))
        other = self.origin.locatenew("elsewhere", me.dynamicsymbols("way_elsewhere") * axes.x)
        other.locatenew("far", 1.5e11 * axes.y).locatenew("near", 1e-9 * axes.z)

    def name(self, prefix):
        self._names[prefix] = self._names.get(prefix, -1) + 1
        return f"{prefix}{self._names[prefix]}"

    def _symbol(self, path, value):
        value = float(value)
        if path in self.data["inputs"]:
            symbol = me.dynamicsymbols(path)
            self.specifieds[symbol] = value
            self.path_of[symbol] = path
        elif path in self.data["named"] and "drive" not in path:
            symbol = sm.Symbol(path)
            self.constants[symbol] = value
            self.path_of[symbol] = path
        elif "drive" in path:
            return (path, value)
        else:
            return (
                sm.Float(value, 17)
                if value != int(value) or abs(value) > 1e6
                else sm.Integer(int(value))
            )
        return symbol

    def prescribed(self, parts):
        """A specified, with the values of its derivatives."""
        path = parts[0][0]
        symbol = me.dynamicsymbols(path)
        for order, (own, value) in enumerate(parts):
            key = symbol.diff(T, order) if order else symbol
            self.specifieds[key] = value
            self.path_of[key] = own
        return symbol

    # -- kinematics -----------------------------------------------------------------------------

    def _kinematic(self):
        """q' of each coordinate, and kinematic equations."""
        self.kd, self.rates = [], {}
        rate = {}
        equations = {}
        for elements in self.places:
            for element, of_q, of_u in elements:
                q, u = self.q[of_q], self.u[of_u]
                if len(element.lengths) == 4:
                    half = sm.Rational(1, 2)
                    rows = [
                        -half * (q[1] * u[0] + q[2] * u[1] + q[3] * u[2]),
                        half * (q[0] * u[0] + q[2] * u[2] - q[3] * u[1]),
                        half * (q[0] * u[1] + q[3] * u[0] - q[1] * u[2]),
                        half * (q[0] * u[2] + q[1] * u[1] - q[2] * u[0]),
                    ]
                    self.kd += [a.diff(T) - b for a, b in zip(q, rows, strict=True)]
                    rate |= dict(zip(q, rows, strict=True))
                else:
                    for a, b in zip(q, u, strict=True):
                        equations[b] = a.diff(T)
        partner = dict(equations)
        for mixed, i, j, k, unit in mixing(self.real):
            scale = 1 if mixed["plain"] else sm.cos(self.q[k] / sm.nsimplify(unit))
            ui, uj = self.u[i], self.u[j]
            equations[ui] = equations[ui] + sm.Float(mixed["part"], 17) * scale * partner[uj]
            if mixed["swing"]:
                equations[ui] += sm.Float(mixed["size"], 17) * sm.sin(
                    sm.Float(mixed["frequency"], 17) * T
                )
        self.kd += [e - u for u, e in equations.items() if e != u]
        for u, e in equations.items():  # triangular
            q_rate = partner[u]
            rest = (e - q_rate).xreplace(self.rates) if e != q_rate else 0
            self.rates[q_rate] = u - rest
        self.rates |= {q.diff(T): r for q, r in rate.items()}

    def _tree(self):
        bodies = self.tree["bodies"]
        self.frames, self.centres, self.hinges, self.axes, self.bodies = [], [], [], [], []
        self.spots = {}
        for k, body in enumerate(bodies):
            frame, start = self.frame(body["on"]), self.centre(body["on"])
            point = self.moved(start, vector(body["at"], frame), 0, frame)
            if any(body["tilt"]):
                tilted = me.ReferenceFrame(f"T{k}")
                tilted.orient_body_fixed(frame, body["tilt"], "xyz")
                if self.said:
                    tilted.set_ang_vel(frame, 0)
                frame = tilted
            for item in self.data["auxiliary"]:
                if item["body"] == k:
                    frame, point = self._free(k, item, frame, point)
            base = frame
            self.hinges.append(point)
            self.axes.append(vector(body["axis"], frame).normalize() if "axis" in body else frame.x)
            for element, of_q, _ in self.places[k]:
                q = self.q[of_q]
                if len(q) == 4:
                    rates = self.u[self.places[k][-1][2]]
                else:
                    rates = [self.rates[a.diff(T)] for a in q]
                frame, point, _ = element.symbols(self, body, frame, point, q, rates)
            if frame in (self.frame(body["on"]), base):
                frame = self._own_frame(k, frame)
            self.frames.append(frame)
            self.centres.append(self.moved(point, vector(body["centre"], frame), 0, frame))
            self.bodies.append(self._body(k, body, frame, self.centres[k]))

    def _own_frame(self, k, parent):
        """A frame of the body's own where it does not turn, which tells whose torques act on it."""
        frame = me.ReferenceFrame(f"B{k}")
        frame.orient_axis(parent, parent.x, 0)
        if self.said:
            frame.set_ang_vel(parent, 0)
        return frame

    def _free(self, k, item, frame, point):
        """The frame and the point of a joint, which move by an auxiliary speed."""
        u, force = me.dynamicsymbols(f"ua{k} R{k}")
        axis = list(self.ground)[item["axis"]]
        if item["turn"]:
            before, frame = frame, me.ReferenceFrame(f"X{k}")
            frame.orient_axis(before, before.x, 0)
            frame.set_ang_vel(before, u * axis)
            both = before, frame
        else:
            before, point = point, point.locatenew(f"X{k}", 0 * axis)
            point.set_vel(self.ground, before.vel(self.ground) + u * axis)
            both = before, point
        self.auxiliary.append(u)
        self.forces.append(force)
        self.noncontributing += [(both[1], force * axis), (both[0], -force * axis)]
        return frame, point

    def moved(self, point, way, speed, frame):
        """A point at a place in a frame; where velocities are said, with its own."""
        new = point.locatenew(self.name("P"), way)
        if self.said:
            carried = frame.ang_vel_in(self.ground).cross(way)
            new.set_vel(self.ground, point.vel(self.ground) + carried + speed)
        return new

    def _body(self, k, body, frame, centre):
        if body["inertia"] is None:
            return me.Particle(f"b{k}", centre, body["mass"])
        inertia, point = me.inertia(frame, *body["inertia"]), centre
        if body["about"] == "hinge":
            arm = vector(body["centre"], frame)
            point = centre.locatenew(f"H{k}", -arm)
            inertia += me.inertia_of_point_mass(body["mass"], arm, frame)
        return me.RigidBody(f"b{k}", centre, frame, body["mass"], (inertia, point))

    def _joints(self):
        """The same of SymPy's joints."""
        wall = me.RigidBody("wall", self.origin, self.ground)
        self.system = me.System.from_newtonian(wall)
        self.frames, self.centres, self.hinges, self.axes, self.bodies = [], [], [], [], []
        self.spots = {}
        for k, body in enumerate(self.tree["bodies"]):
            parent = wall if body["on"] < 0 else self.bodies[body["on"]]
            frame = parent.frame
            own, centre = me.ReferenceFrame(f"F{k}"), me.Point(f"C{k}")
            self.bodies.append(self._body(k, body, own, centre))
            if any(body["tilt"]):
                tilted = me.ReferenceFrame(f"T{k}")
                tilted.orient_body_fixed(frame, body["tilt"], "xyz")
                frame = tilted
            q = [a for _, of_q, _ in self.places[k] for a in self.q[of_q]]
            u = [a for _, _, of_u in self.places[k] for a in self.u[of_u]]
            kind, options = JOINTS[body["joint"]][3], {}
            if kind is me.PlanarJoint:
                options = {
                    "rotation_coordinate": q[2], "planar_coordinates": q[:2],
                    "rotation_speed": u[2], "planar_speeds": u[:2],
                }  # fmt: skip
            elif kind is not me.WeldJoint:
                options = {"coordinates": q, "speeds": u}
                if kind is me.CylindricalJoint:
                    options = {
                        "rotation_coordinate": q[0], "translation_coordinate": q[1],
                        "rotation_speed": u[0], "translation_speed": u[1],
                    }  # fmt: skip
                elif kind is me.SphericalJoint:
                    options["rot_order"] = "123"
                else:
                    options = {"coordinates": q[0], "speeds": u[0]}
            axis = vector(body["axis"], frame) if "axis" in body else frame.x
            if "axis" in body and kind is not me.WeldJoint:
                options["joint_axis"] = axis
            if any(body["tilt"]):
                options["parent_interframe"] = frame
            back = vector([-c for c in body["centre"]], own)
            joint = kind(
                f"j{k}", parent, self.bodies[k],
                parent_point=vector(body["at"], parent.frame) if any(body["at"]) else None,
                child_point=back if any(body["centre"]) else None,
                **options,
            )  # fmt: skip
            self.system.add_joints(joint)
            self.frames.append(own)
            self.centres.append(centre)
            self.axes.append(axis.normalize())
            self.hinges.append(joint.parent_point)

    def frame(self, body):
        return self.ground if body < 0 else self.frames[body]

    def centre(self, body):
        return self.origin if body < 0 else self.centres[body]

    def spot(self, spot):
        body = spot["body"]
        if not any(spot["at"]):
            return self.centre(body)
        point = self.centre(body).locatenew(self.name("S"), vector(spot["at"], self.frame(body)))
        if self.said:
            point.v2pt_theory(self.centre(body), self.ground, self.frame(body))
        self.spots.setdefault(body, []).append(point)
        return point

    def velocity(self, point):
        if self.said:
            return point.vel(self.ground)
        return point.pos_from(self.origin).dt(self.ground)

    def joint_motion(self, body):
        q = self.q[self.places[body][0][1]][0]
        return q, self.rates[q.diff(T)]

    def _gravity(self):
        g = vector(self.tree["gravity"], self.ground)
        return [] if g == 0 else [(b.masscenter, b.mass * g) for b in self.bodies]

    def _rows(self):
        rows = []
        for loop in self.tree["loops"]:
            part = LOOPS[loop["kind"]]
            if loop["kind"] == "again":
                rows += part.combined(rows, loop, _added)
            else:
                rows += part.symbols(self, loop)
        # Where decimals cancel, rows of nothing but rounding are left, which contradict anything.
        rows = [
            (kind, sm.sympify(row) if some else sm.S.Zero)
            for (kind, row), some in zip(
                sorted(rows, key=lambda r: r[0]), self._hold(), strict=True
            )
        ]
        self.positions = [row for kind, row in rows if kind == "position"]
        self.speeds = [row.xreplace(self.rates) for kind, row in rows if kind == "speed"]

    def _hold(self):
        """Whether each row holds anything at this state or at others, the positions first."""
        q, u = np.array(self.real["q"]), self.real["u"]
        scales = np.random.default_rng(0).uniform(0.5, 1.5, (2, len(q)))
        worlds = [World(self.real, q * scale, u, rows=[]) for scale in (1.0, *scales)]
        return np.any([(np.abs(w.A) > 1e-13 * w.A_size).any(axis=1) for w in worlds], axis=0)


def _added(rows, weights):
    return (sum(w * row[1] for row, w in zip(rows, weights, strict=False)),)


# -- front ends: a model, or None where a front end has no such mechanisms ------------------------


def definition(data, orders=None, positive=None):
    """A Definition; `orders` of its coordinates and speeds, by default those of the bodies."""
    model = Model(data, positive=positive)
    start = dict(zip(model.q, model.real["q"], strict=True))
    q, u = orders or (range(len(model.q)), range(len(model.u)))
    model.method = Definition(
        model.ground,
        [model.q[k] for k in q],
        [model.u[k] for k in u],
        bodies=model.bodies,
        loads=model.loads,
        kinematic_equations=model.kd,
        holonomic_constraints=model.positions,
        nonholonomic_constraints=model.speeds,
        auxiliary_speeds=model.auxiliary,
        configuration=start if model.positions else None,
    )
    return model


def _kane(data):
    model = Model(data)
    world = World(model.real, model.real["q"], model.real["u"])
    rates = [sm.sympify(c).diff(T).xreplace(model.rates) for c in model.positions]
    options = {}
    if len(world.A):
        kept = sorted(world.kept)
        count = len(model.positions)
        _, columns = pivots(world.A[kept], world.A_size[kept])
        whole = kept
        holonomic = [k for k in whole if k < count]
        rows = [rates[k] if k < count else model.speeds[k - count] for k in whole]
        dependent = pivots(*world.by_coordinates(holonomic))[1]
        model.rows = whole
        options = {
            "q_dependent": [model.q[k] for k in sorted(dependent)],
            "configuration_constraints": [model.positions[k] for k in holonomic],
            "u_dependent": [model.u[k] for k in sorted(columns)],
            "velocity_constraints": rows,
        }
        if not holonomic:
            options = {k: v for k, v in options.items() if k.startswith(("u_", "vel"))}
    q = [s for s in model.q if s not in options.get("q_dependent", ())]
    u = [s for s in model.u if s not in options.get("u_dependent", ())]
    if model.auxiliary:
        options["u_auxiliary"] = model.auxiliary
    model.method = me.KanesMethod(
        model.ground, q, u, kd_eqs=model.kd, bodies=model.bodies, forcelist=model.loads or None,
        kd_eqs_solver="CRAMER" if len(model.q) < 5 else "LU", **options,
    )  # fmt: skip
    return model


def kane(data):
    return _kane(data)


def called(data):
    """KanesMethod with its own equations."""
    if len(layout(data)[0]) > 2 or layout(data)[2] > 3:
        return None
    model = _kane(data)
    loads = []
    for load in model.loads:
        loads += load.to_loads() if hasattr(load, "to_loads") else [load]
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", UserWarning)  # SymPy's, of points that hang on several
        model.method.kanes_equations(model.bodies, loads or None)
    return model


def lagrange(data):
    if data["speeds"] or data["auxiliary"] or layout(data)[2] > 5 or len(data["bodies"]) > 4:
        return None
    if any(len(e.lengths) == 4 for elements in layout(data)[0] for e, _, _ in elements):
        return None
    model = Model(data, rates=True)
    loads = []
    for load in model.loads:
        loads += load.to_loads() if hasattr(load, "to_loads") else [load]
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", UserWarning)
        lagrangian = me.Lagrangian(model.ground, *model.bodies)
    model.method = me.LagrangesMethod(
        lagrangian, model.q, frame=model.ground, bodies=model.bodies, forcelist=loads or None,
        hol_coneqs=model.positions or None, nonhol_coneqs=model.speeds or None,
    )  # fmt: skip
    return model


def joints(data):
    if (
        data["speeds"]
        or data["auxiliary"]
        or any(JOINTS[b["joint"]][3] is None for b in data["bodies"])
    ):
        return None
    if any(b["inertia"] is None for b in data["bodies"]):
        return None
    model = Model(data | {"said": False}, joints=True)
    system = model.system
    if positions := [e for e in model.positions if e != 0]:
        system.add_holonomic_constraints(*positions)
    if speeds := [e for e in model.speeds if e != 0]:
        system.add_nonholonomic_constraints(*speeds)
    for load in model.loads:
        if hasattr(load, "to_loads"):
            system.add_actuators(load)
        else:
            system.add_loads(load)
    model.method = system
    return model


def permuted(data):
    """A Definition with coordinates and speeds in another order, which is that of its states."""
    rng = np.random.default_rng([30, data["seed"]])
    orders = [rng.permutation(n).tolist() for n in layout(data)[1:]]
    model = definition(data, orders)
    model.order = [model.q[k] for k in orders[0]] + [model.u[k] for k in orders[1]]
    return model


FRONT_ENDS = {f.__name__: f for f in (definition, kane, called, lagrange, joints)}
