"""The equations of two-wheelers: frames, wheels on the road, a steering axis and a rider."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Any

import numpy as np
import sympy as sm
import sympy.physics.mechanics as me

from pydy.mechanics import Definition
from pydy.system import System
from pydy.vehicles.cars import GRAVITY
from pydy.vehicles.two_wheeler_data import FrameBody, Rider, TwoWheeler, WheelBody
from pydy.vehicles.wheel import WheelContact

if TYPE_CHECKING:
    from pydy._sympy_types import Expression, Load, TimeFunction

_ENDS = ("f", "r")  # front, rear, as tires and their stiffnesses are given


@dataclass
class WheelContacts:
    """How the wheels touch the road: numbers and expressions, of the front and the rear wheel.

    `tires` is None for wheels that roll without slip; `relaxation` has the lengths, where zero is
    no lag, or is None.
    """

    tires: tuple[Any, Any] | None = None
    stiffness: tuple[float, float] = (0.0, 0.0)
    damping: tuple[float, float] = (0.0, 0.0)
    relaxation: tuple[float, float] | None = None


@dataclass
class _Assemblies:
    """What the bodies, wheels and hinges of a vehicle add to its Definition and its System."""

    coordinates: list[TimeFunction] = field(default_factory=list)
    speeds: list[TimeFunction] = field(default_factory=list)
    kinematics: list[Expression] = field(default_factory=list)
    bodies: list[me.RigidBody] = field(default_factory=list)
    loads: list[Load] = field(default_factory=list)
    constants: dict[sm.Symbol, float] = field(default_factory=dict)
    specifieds: dict[TimeFunction, float] = field(default_factory=dict)

    def constant(self, name: str, value: float) -> sm.Symbol:
        symbol = sm.Symbol(name)
        self.constants[symbol] = value
        return symbol

    def speed_of(self, coordinate: TimeFunction, name: str) -> TimeFunction:
        """Add a coordinate whose derivative is a speed with a name."""
        speed = me.dynamicsymbols(name)
        self.coordinates.append(coordinate)
        self.speeds.append(speed)
        self.kinematics.append(coordinate.diff() - speed)
        return speed

    def inertia(self, name: str, body: FrameBody, frame: me.ReferenceFrame) -> me.Dyadic:
        xx, yy, zz, xz = (
            self.constant(f"I_{name}{axes}", getattr(body, f"I{axes}"))
            for axes in ("xx", "yy", "zz", "xz")
        )
        return me.inertia(frame, xx, yy, zz, izx=xz)


class Vehicle:
    """A two-wheeler with the coordinates x, y, z of the rear wheel's centre and its angles.

    Every vector is written in the frame where it is shortest, and turned one axis at a time, which
    nests the sums in place of multiplying them out::

        N --psi, z--> A --phi, x--> E --theta, y--> B (rear frame)
                                    E --theta - lam, y--> S --delta, z--> K --lam, y--> H (front)
    """

    def __init__(self, data: TwoWheeler, rider: Rider | None) -> None:
        parts = self.parts = _Assemblies()
        self.g = parts.constant("g", GRAVITY)
        self.wheelbase = parts.constant("L", data.wheelbase)
        c, lam = parts.constant("c", data.trail), parts.constant("lam", data.steer_axis_tilt)
        self.radii = {
            "f": parts.constant("R_f", data.front_wheel.radius),
            "r": parts.constant("R_r", data.rear_wheel.radius),
        }
        self.moments: list[tuple[Expression, Expression]] = []  # masses and where they are, x
        x, y, z, psi, phi, theta, delta = me.dynamicsymbols("x y z psi phi theta delta")
        u, v, w = me.dynamicsymbols("u v w")
        parts.coordinates += [x, y, z]
        parts.speeds += [u, v, w]
        parts.kinematics += [
            x.diff() - u * sm.cos(psi) + v * sm.sin(psi),
            y.diff() - u * sm.sin(psi) - v * sm.cos(psi),
            z.diff() - w,
        ]
        r, p, q = (parts.speed_of(s, n) for s, n in ((psi, "r"), (phi, "p"), (theta, "q")))
        steering = parts.speed_of(delta, "delta_rate")
        spins = {"r": me.dynamicsymbols("omega_r"), "f": me.dynamicsymbols("omega_f")}

        N, A, E, B, S, K, H = (me.ReferenceFrame(name) for name in "NAEBSKH")
        self.N, self.A, self.E, self.B, self.S, self.K, self.H = N, A, E, B, S, K, H
        A.orient_axis(N, N.z, psi)
        E.orient_axis(A, A.x, phi)
        B.orient_axis(E, E.y, theta)
        S.orient_axis(E, E.y, theta - lam)
        K.orient_axis(S, S.z, delta)
        H.orient_axis(K, K.y, lam)
        self.w_E = p * E.x + r * A.z.express(E)
        w_B = self.w_B = self.w_E + q * E.y
        w_H = self._in_front(w_B) + steering * K.z
        for frame, turning in ((A, r * A.z), (E, self.w_E), (B, w_B), (S, w_B), (K, w_H), (H, w_H)):
            frame.set_ang_vel(N, turning)

        O = self.O = me.Point("O")
        O.set_vel(N, 0)
        # Seen along the steering axis: the arms from the wheel centres to it, and along it.
        R_f, R_r, L = self.radii["f"], self.radii["r"], self.wheelbase
        arm = ((L + c) * sm.cos(lam) - R_r * sm.sin(lam)) * S.x
        arm -= (L * sm.sin(lam) + (R_r - R_f) * sm.cos(lam)) * S.z
        offset = (R_f * sm.sin(lam) - c * sm.cos(lam)) * K.x
        rear = O.locatenew("rear", x * N.x + y * N.y + z * N.z)
        front = rear.locatenew("front", arm + offset)
        rear.set_vel(N, u * A.x + v * A.y + w * A.z)
        v_rear = self.v_rear = rear.vel(N).express(E)
        v_front = self._in_front(v_rear + w_B.cross(arm.express(E))) + w_H.cross(offset)
        front.set_vel(N, v_front)
        self.rear = rear

        self._frame_body("B", data.rear_frame, rear, v_rear, 0, R_r, B, E, w_B)
        self._frame_body("H", data.front_frame, front, v_front, L, R_f, H, K, w_H)
        if rider is not None:
            self._add_rider(rider)
        self.wheels = {
            "f": self._wheel("f", data.front_wheel, front, L, (K, H), w_H, spins["f"]),
            "r": self._wheel("r", data.rear_wheel, rear, 0, (E, B), w_B, spins["r"]),
        }
        parts.speeds += [spins["r"], spins["f"]]
        T = me.dynamicsymbols("T_delta")
        parts.specifieds[T] = 0.0
        parts.loads += [(H, T * S.z), (B, -T * S.z)]
        parts.loads += [(b.masscenter, -b.mass * self.g * N.z) for b in parts.bodies]
        self.steering = steering

    def _in_front(self, vector: me.Vector) -> me.Vector:
        # One axis at a time: SymPy's direct way from E to K multiplies the two rotations out.
        return vector.express(self.S).express(self.K)

    def _frame_body(
        self,
        name: str,
        data: FrameBody,
        centre: me.Point,
        velocity: me.Vector,
        x: Expression,
        radius: Expression,
        frame: me.ReferenceFrame,
        short: me.ReferenceFrame,
        turning: me.Vector,
    ) -> None:
        """Add a frame with its mass centre at a distance from a wheel's centre, at x upright."""
        parts = self.parts
        m, x_G, h = (
            parts.constant(f"{letter}_{name}", value)
            for letter, value in (("m", data.mass), ("x", data.x), ("z", data.height))
        )
        arm = (x_G - x) * frame.x + (h - radius) * frame.z
        G = centre.locatenew(f"G_{name}", arm)
        G.set_vel(self.N, velocity + turning.cross(arm.express(short)))
        inertia = parts.inertia(name, data, frame).express(short)
        label = {"B": "rear frame", "H": "front frame"}[name]
        parts.bodies.append(me.RigidBody(label, G, frame, m, (inertia, G)))
        self.moments.append((m, x_G))

    def _add_rider(self, rider: Rider) -> None:
        parts, B, N = self.parts, self.B, self.N
        lean = me.dynamicsymbols("phi_U")
        rate = parts.speed_of(lean, "p_U")
        U = me.ReferenceFrame("U")
        U.orient_axis(B, B.x, lean)
        U.set_ang_vel(B, rate * B.x)
        w_U = self.w_B.express(B) + rate * B.x
        U.set_ang_vel(N, w_U.express(U))
        m, x_G, h, z_h, k, d = (
            parts.constant(name, value)
            for name, value in (
                ("m_U", rider.mass),
                ("x_U", rider.x),
                ("z_U", rider.height),
                ("z_hinge", rider.hinge_height),
                ("k_U", rider.stiffness),
                ("d_U", rider.damping),
            )
        )
        hinge = self.rear.locatenew("hinge", (z_h - self.radii["r"]) * B.z)
        up = x_G * U.x + (h - z_h) * U.z
        G = hinge.locatenew("G_U", up)
        v_hinge = self.v_rear + self.w_B.cross((hinge.pos_from(self.rear)).express(self.E))
        G.set_vel(N, v_hinge.express(B).express(U) + U.ang_vel_in(N).cross(up))
        inertia = (parts.inertia("U", rider, U), G)
        parts.bodies.append(me.RigidBody("rider", G, U, m, inertia))
        self.moments.append((m, x_G))
        T = me.dynamicsymbols("T_U")
        parts.specifieds[T] = 0.0
        torque = (T - k * lean - d * rate) * B.x
        parts.loads += [(U, torque), (B, -torque)]

    def _wheel(
        self,
        end: str,
        data: WheelBody,
        centre: me.Point,
        x: Expression,
        frames: tuple[me.ReferenceFrame, me.ReferenceFrame],
        turning: me.Vector,
        spin: TimeFunction,
    ) -> me.RigidBody:
        """Add a wheel and the torque between it and its frame; nothing depends on its angle.

        The first one of the frames has the axle as its y axis, the second one holds the axle.
        """
        parts = self.parts
        carrier, holder = frames
        frame = me.ReferenceFrame(f"W_{end}")
        frame.orient_axis(carrier, carrier.y, 0)
        # The axes of E do not pitch with the rear frame.
        about = turning.dot(carrier.y) - carrier.ang_vel_in(self.N).dot(carrier.y) + spin
        frame.set_ang_vel(carrier, about * carrier.y)
        frame.set_ang_vel(self.N, turning + spin * carrier.y)
        m, J, I = (
            parts.constant(f"{name}_{end}", value)
            for name, value in (
                ("m", data.mass), ("J", data.axial_inertia), ("I", data.diametral_inertia)
            )
        )  # fmt: skip
        inertia = (me.inertia(carrier, I, J, I), centre)
        label = {"f": "front wheel", "r": "rear wheel"}[end]
        body = me.RigidBody(label, centre, frame, m, inertia)
        parts.bodies.append(body)
        self.moments.append((m, x))
        T = me.dynamicsymbols(f"T_{end}")
        parts.specifieds[T] = 0.0
        parts.loads += [(frame, T * carrier.y), (holder, -T * carrier.y)]
        return body

    def add_steering_damper(self, damping: float) -> None:
        """Add a damper between the frames."""
        torque = self.parts.constant("d_delta", damping) * self.steering * self.S.z
        self.parts.loads += [(self.H, -torque), (self.B, torque)]

    def loads(self) -> dict[str, Expression]:
        """Return the static loads of the wheels, of the constants."""
        front = self.g * sum(m * x for m, x in self.moments) / self.wheelbase
        return {"f": front, "r": self.g * sum(m for m, _ in self.moments) - front}


def two_wheeler(
    vehicle: Vehicle, data: TwoWheeler, contacts: WheelContacts, speed: float
) -> System:
    """Return the System of a vehicle whose wheels roll, or slip on tires."""
    parts, N = vehicle.parts, vehicle.N
    loads = vehicle.loads()
    touching = {}
    for k, end in enumerate(_ENDS):
        wheel = data.front_wheel if end == "f" else data.rear_wheel
        axis = vehicle.K.y if end == "f" else vehicle.E.y
        radius: Expression = vehicle.radii[end]
        crown: Any = 0.0
        if wheel.crown_radius:
            crown = parts.constant(f"crown_{end}", wheel.crown_radius)
        law = None
        if contacts.tires is not None:
            stiffness = parts.constant(f"k_{end}", contacts.stiffness[k])
            damping = parts.constant(f"d_{end}", contacts.damping[k])
            # Without a load the wheel is larger by the deflection.
            radius += loads[end] / stiffness
            law = _spring(stiffness, damping)
        contact = WheelContact(
            vehicle.wheels[end], axis, radius, vehicle.O, vehicle.A.z, N, law,
            crown_radius=crown, name=f"touch_{end}",
        )  # fmt: skip
        if contacts.relaxation is not None and contacts.relaxation[k]:
            states = me.dynamicsymbols(f"e_x_{end} e_y_{end} gamma_lag_{end}")
            length = parts.constant(f"sigma_{end}", contacts.relaxation[k])
            contact = contact.with_relaxation((length, length), states[:2], camber=states[2])
            parts.coordinates += states
            parts.kinematics += contact.kinematic_equations
        touching[end] = contact
    outputs: dict[str, Any] = {}
    for k, end in enumerate(_ENDS):
        contact = touching[end]
        outputs[f"gamma_{end}"] = contact.gamma
        if contacts.tires is not None:
            tire = contacts.tires[k]
            parts.loads += contact.loads(tire)
            forces = contact.forces(tire)
            outputs[f"kappa_{end}"], outputs[f"alpha_{end}"] = contact.kappa, contact.alpha
            outputs[f"Fx_{end}"], outputs[f"Fy_{end}"] = forces.Fx, forces.Fy
            outputs[f"Fz_{end}"] = contact.normal_force
    definition = Definition(
        N,
        parts.coordinates,
        parts.speeds,
        bodies=parts.bodies,
        loads=parts.loads,
        kinematic_equations=parts.kinematics,
        **(_rolling(touching) if contacts.tires is None else {}),
    )
    start = {"u": speed, "z": data.rear_wheel.radius}
    start["omega_f"] = speed / data.front_wheel.radius
    start["omega_r"] = speed / data.rear_wheel.radius
    system = System(
        definition,
        parts.constants,
        parts.specifieds,
        "dop853",
        initial_conditions=start,
        times=np.linspace(0.0, 5.0, 501),
    )
    if contacts.tires is None:
        names = ("Fz_r", "Fz_f", "Fy_f", "Fx_f", "Fx_r", "Fy_r")  # of the rows of `_rolling`
        outputs |= zip(names, system.constraint_forces.values(), strict=True)
    system.outputs = outputs
    return system


def _spring(stiffness: sm.Symbol, damping: sm.Symbol) -> Any:
    return lambda gap, rate: -stiffness * gap - damping * rate


def _rolling(touching: dict[str, WheelContact]) -> dict[str, Any]:
    """Return the constraints of wheels that roll, and what they give: all but p, δ' and ω_r."""
    front, rear = touching["f"], touching["r"]
    return {
        "holonomic_constraints": [rear.gap, front.gap],
        "velocity_constraints": [
            rear.rate,
            front.rate,
            *front.nonholonomic_constraints[::-1],
            *rear.nonholonomic_constraints,
        ],
        "dependent_coordinates": me.dynamicsymbols("z theta"),
        "dependent_speeds": me.dynamicsymbols("w q r omega_f u v"),
    }
