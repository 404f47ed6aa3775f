"""MJCF files, compiled by the `mujoco` package: defaults, includes, meshes and inertias resolved.

The fields of the compiled model are described in MuJoCo's documentation ("Computation", "XML
reference"). Properties without a counterpart in pydy are listed in `Tree.left_out`.
"""

from __future__ import annotations

import re
from collections.abc import Iterator
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from pydy._errors import RobotFileError
from pydy._names import unused_name
from pydy._optional import require
from pydy.robots.tree import (
    EqualityConstraint,
    Link,
    Motor,
    RobotJoint,
    Tendon,
    Tree,
    VisualShape,
    of_quaternion,
    rotated_inertia,
)
from pydy.viz import Box, Capsule, Cylinder, Mesh, Sphere

if TYPE_CHECKING:
    from types import ModuleType

    from pydy.viz import Shape

_KINDS = {
    "mjJNT_HINGE": "hinge",
    "mjJNT_SLIDE": "slide",
    "mjJNT_BALL": "ball",
    "mjJNT_FREE": "free",
}
_NUMBERS = [
    "body_pos",
    "body_ipos",
    "body_mass",
    "body_inertia",
    "body_gravcomp",
    "jnt_pos",
    "jnt_axis",
    "jnt_stiffness",
    "dof_damping",
    "dof_armature",
    "dof_frictionloss",
    "qpos0",
    "qpos_spring",
    "actuator_gear",
    "actuator_gainprm",
    "actuator_biasprm",
    "tendon_stiffness",
    "tendon_damping",
    "tendon_armature",
    "tendon_frictionloss",
    "tendon_lengthspring",
    "wrap_prm",
    "eq_data",
]
_CONSTRAINTS = {"CONTACT", "EQUALITY", "FRICTIONLOSS", "LIMIT"}
"""MuJoCo's kinds of constraints, which a file can disable together."""


def read_mjcf(path: Path) -> Tree:
    """Read an MJCF file into a Tree."""
    mujoco = require("mujoco", "robots", "Reading MJCF files")
    messages: list[str] = []
    before = mujoco.get_mju_user_warning()
    mujoco.set_mju_user_warning(messages.append)  # instead of writing them to a log file
    try:
        model = mujoco.MjModel.from_xml_path(str(path))
    except ValueError as error:
        reason = " ".join(str(error).split())
        # MuJoCo reports no line for a missing file.
        name = re.search(r"Error opening file '(.*)'$", reason)
        location = _line(path, rf"file\s*=\s*[\"']{re.escape(name[1])}[\"']") if name else path
        raise RobotFileError(f"{location}: MuJoCo does not read this file: {reason}") from None
    finally:
        mujoco.set_mju_user_warning(before)
    tree = _MjcfReader(mujoco, model, path).tree()
    tree.left_out += [f"MuJoCo says: {' '.join(text.split())}" for text in messages]
    return tree


def _line(path: Path, pattern: str) -> str:
    """Return the path with the number of the first line that matches, if there is one."""
    lines = path.read_text("utf-8", "replace").splitlines()
    line_numbers = (k for k, line in enumerate(lines, 1) if re.search(pattern, line, re.IGNORECASE))
    line = next(line_numbers, None)
    return f"{path}" if line is None else f"{path}:{line}"


class _MjcfReader:
    """Reads a compiled model; elements are identified by names instead of indices."""

    def __init__(self, mujoco: ModuleType, model: Any, path: Path) -> None:
        self.mujoco, self.model, self.path = mujoco, model, path
        self.off = model.opt.disableflags
        self.left_out: list[str] = []
        self._names: dict[str, list[str]] = {}
        for field, values in {
            "gravity": model.opt.gravity,
            **{n: getattr(model, n) for n in _NUMBERS},
        }.items():
            if not np.isfinite(values).all():
                location = _line(path, r"[\"'\s][+-]?(nan|inf|infinity)[\"'\s]")
                raise RobotFileError(
                    f"{location}: a number that is not finite became part of MuJoCo's `{field}`. "
                    "Look for 'nan' and 'inf' in the file."
                )

    def name(self, kind: str, k: int) -> str:
        """Return the name of the k-th element of a kind, or a new unique name if it has none."""
        if kind not in self._names:
            count = {
                "BODY": "nbody",
                "JOINT": "njnt",
                "ACTUATOR": "nactuator",
                "EQUALITY": "neq",
                "TENDON": "ntendon",
            }[kind]
            of_kind = getattr(self.mujoco.mjtObj, f"mjOBJ_{kind}")
            indices = range(getattr(self.model, count))
            try:
                names = [self.mujoco.mj_id2name(self.model, of_kind, i) for i in indices]
            except UnicodeDecodeError as error:
                name = bytes(error.object).decode("utf-8", "backslashreplace")
                raise RobotFileError(
                    f"{self.path}: the {kind.lower()} named '{name}' has a name that is not UTF-8. "
                    "Save the file as UTF-8, or rename it."
                ) from None
            self._names[kind] = names
            for i in indices:
                names[i] = names[i] or unused_name(self.without_name(kind, i), names)
        return self._names[kind][k]

    def disabled(self, feature: str) -> bool:
        if feature in _CONSTRAINTS and self.disabled("CONSTRAINT"):
            return True
        return bool(self.off & getattr(self.mujoco.mjtDisableBit, f"mjDSBL_{feature}"))

    def tree(self) -> Tree:
        model = self.model
        links = [self.link(k) for k in range(1, model.nbody)]
        joints = {joint.name: joint for link in links for joint in link.joints}
        tree = Tree(self.path.stem, links, gravity=np.array(model.opt.gravity))
        tree.tendons = [self.tendon(k) for k in range(model.ntendon) if self.is_fixed(k)]
        tree.motors = [m for k in range(model.nactuator) if (m := self.motor(k)) is not None]
        tree.equalities = [
            equality for k in range(model.neq) if (equality := self.equality(k)) is not None
        ]
        tree.start = {
            self.joint_name(j): self.start(j)
            for j in range(model.njnt)
            if self.joint_name(j) in joints and self.start(j).any()
        }
        if self.disabled("GRAVITY"):
            tree.gravity = np.zeros(3)
        self.note_omissions()
        tree.left_out = self.left_out
        tree.visuals = list(self.visuals(0))
        return tree

    def location(self, element: str) -> str:
        return f"{self.path}, {element}"

    def link(self, k: int) -> Link:
        model, location = self.model, self.location(f"body '{self.name('BODY', k)}'")
        if model.body_mocapid[k] >= 0:
            self.left_out.append(f"the body '{self.name('BODY', k)}' is moved by data: it rests")
        rotation = of_quaternion(model.body_iquat[k])
        link = Link(
            name=self.name("BODY", k),
            parent=int(model.body_parentid[k]) - 1,
            origin=np.array(model.body_pos[k]),
            rotation=of_quaternion(model.body_quat[k]),
            mass=float(model.body_mass[k]),
            centre=np.array(model.body_ipos[k]),
            inertia=rotated_inertia(np.diag(model.body_inertia[k]), rotation),
            # MuJoCo leaves out this passive force without springs and dampers, and negative ones in
            # a model that has no positive one.
            gravity_compensation=float(model.body_gravcomp[k])
            if model.ngravcomp and not (self.disabled("SPRING") and self.disabled("DAMPER"))
            else 0.0,
            visuals=list(self.visuals(k)),
            location=location,
        )
        first = int(model.body_jntadr[k])
        link.joints = [self.joint(j) for j in range(first, first + int(model.body_jntnum[k]))]
        return link

    def without_name(self, kind: str, k: int) -> str:
        """Return a name for the k-th element of a kind; joints are named after their body."""
        model = self.model
        if kind != "JOINT":
            return f"{kind.lower()}{k}"
        body = int(model.jnt_bodyid[k])
        alone = model.body_jntnum[body] == 1
        return self.name("BODY", body) + ("" if alone else f"_{k - int(model.body_jntadr[body])}")

    def joint_name(self, j: int) -> str:
        return self.name("JOINT", j)

    def start(self, j: int) -> np.ndarray:
        model = self.model
        first = int(model.jnt_qposadr[j])
        kind = _KINDS[self.mujoco.mjtJoint(model.jnt_type[j]).name]
        return np.array(model.qpos0[first : first + {"free": 7, "ball": 4}.get(kind, 1)])

    def joint(self, j: int) -> RobotJoint:
        model, name = self.model, self.joint_name(j)
        kind = _KINDS[self.mujoco.mjtJoint(model.jnt_type[j]).name]
        first, position_index = int(model.jnt_dofadr[j]), int(model.jnt_qposadr[j])
        count = {"free": 6, "ball": 3}.get(kind, 1)
        dofs = slice(first, first + count)
        joint = RobotJoint(name, kind, location=self.location(f"joint '{name}'"))
        joint.axis, joint.anchor = np.array(model.jnt_axis[j]), np.array(model.jnt_pos[j])
        joint.armature = self.common_value(model.dof_armature[dofs], name, "armature")
        joint.damping = self.common_value(model.dof_damping[dofs], name, "damping")
        joint.friction = self.common_value(model.dof_frictionloss[dofs], name, "frictionloss")
        joint.stiffness = float(model.jnt_stiffness[j])
        if self.disabled("SPRING"):
            joint.stiffness = 0.0
        if self.disabled("DAMPER"):
            joint.damping = 0.0
        if self.disabled("FRICTIONLOSS"):
            joint.friction = 0.0
        if kind in ("hinge", "slide"):
            joint.reference = float(model.qpos0[position_index])
            joint.relaxed = float(model.qpos_spring[position_index])
            if model.jnt_limited[j] and not self.disabled("LIMIT"):
                low, high = model.jnt_range[j]
                joint.limits = (float(low), float(high))
        self.note_of_joint(j, joint, dofs)
        return joint

    def note_of_joint(self, j: int, joint: RobotJoint, dofs: slice) -> None:
        """List properties of a joint that have no counterpart here."""
        model, name, kind = self.model, joint.name, joint.kind
        sprung = not self.disabled("SPRING")
        damped = not self.disabled("DAMPER")
        driven = not self.disabled("ACTUATION") and model.nactuator > 0
        if joint.stiffness and kind not in ("hinge", "slide"):
            self.left_out.append(f"the spring of the {kind} joint '{name}'")
            joint.stiffness = 0.0
        elif sprung and model.jnt_stiffness[j] and model.jnt_springyield[j]:
            self.left_out.append(f"the yield of the spring of the joint '{name}'")
        if (sprung and model.jnt_stiffnesspoly[j].any()) or (
            damped and model.dof_dampingpoly[dofs].any()
        ):
            self.left_out.append(f"the polynomial stiffness or damping of the joint '{name}'")
        if kind == "ball" and model.jnt_limited[j] and not self.disabled("LIMIT"):
            self.left_out.append(f"the range of the ball joint '{name}'")
        if driven and model.jnt_actfrclimited[j]:
            self.left_out.append(f"the limits of the actuators' force on the joint '{name}'")
        if not driven and model.jnt_actgravcomp[j] and model.ngravcomp:
            self.left_out.append(
                f"that no actuator compensates the weight at the joint '{name}': it is compensated"
            )

    def is_fixed(self, tendon: int) -> bool:
        """Return whether the length of a tendon is a linear sum of coordinates."""
        first = int(self.model.tendon_adr[tendon])
        return bool(self.model.wrap_type[first] == self.mujoco.mjtWrap.mjWRAP_JOINT)

    def tendon(self, k: int) -> Tendon:
        model, name = self.model, self.name("TENDON", k)
        first = int(model.tendon_adr[k])
        parts = range(first, first + int(model.tendon_num[k]))
        tendon = Tendon(
            name,
            [(self.joint_name(model.wrap_objid[w]), float(model.wrap_prm[w])) for w in parts],
            location=self.location(f"tendon '{name}'"),
        )
        tendon.armature = float(model.tendon_armature[k])
        if not self.disabled("SPRING"):
            tendon.stiffness = float(model.tendon_stiffness[k])
            low, high = model.tendon_lengthspring[k]
            tendon.relaxed = (float(low), float(high))
        if not self.disabled("DAMPER"):
            tendon.damping = float(model.tendon_damping[k])
        if not self.disabled("FRICTIONLOSS"):
            tendon.friction = float(model.tendon_frictionloss[k])
        if model.tendon_limited[k] and not self.disabled("LIMIT"):
            low, high = model.tendon_range[k]
            tendon.limits = (float(low), float(high))
        self.note_of_tendon(k, tendon)
        return tendon

    def note_of_tendon(self, k: int, tendon: Tendon) -> None:
        """List properties of a tendon that have no counterpart here."""
        model, name = self.model, tendon.name
        if tendon.stiffness and model.tendon_springyield[k]:
            self.left_out.append(f"the yield of the spring of the tendon '{name}'")
        if (not self.disabled("SPRING") and model.tendon_stiffnesspoly[k].any()) or (
            not self.disabled("DAMPER") and model.tendon_dampingpoly[k].any()
        ):
            self.left_out.append(f"the polynomial stiffness or damping of the tendon '{name}'")
        if not self.disabled("ACTUATION") and model.nactuator > 0 and model.tendon_actfrclimited[k]:
            self.left_out.append(f"the limits of the actuators' force on the tendon '{name}'")

    def common_value(self, values: np.ndarray, joint: str, quantity: str) -> float:
        """Return the value that all axes of a joint share; note values that differ."""
        if (values != values[0]).any():
            self.left_out.append(f"different {quantity} along the axes of the joint '{joint}'")
        return float(values[0])

    def reason_to_omit(self, k: int, kinds: tuple[str, ...]) -> str | None:
        """Return the reason why an actuator has no counterpart here, None if it has one."""
        model, mujoco = self.model, self.mujoco
        # These act at its joint even if the actuator is disabled.
        if (
            model.actuator_damping[k]
            or model.actuator_dampingpoly[k].any()
            or model.actuator_armature[k]
        ):
            return "which has a damping or an armature of its own"
        group = int(model.actuator_group[k])
        # MuJoCo's bits are those of the groups 0 to 30; others cannot be turned off.
        if self.disabled("ACTUATION") or (
            0 <= group <= 30 and model.opt.disableactuator & (1 << group)
        ):
            return "which the file turns off"
        if model.actuator_plugin[k] >= 0:
            return "whose force a plugin computes"
        transmission = mujoco.mjtTrn(model.actuator_trntype[k]).name.removeprefix("mjTRN_").lower()
        if transmission not in ("joint", "jointinparent", "tendon"):
            return f"which acts by '{transmission}'"
        j = int(model.actuator_trnid[k][0])
        if transmission == "tendon":
            if not self.is_fixed(j):
                return f"which acts by the spatial tendon '{self.name('TENDON', j)}'"
        elif _KINDS[mujoco.mjtJoint(model.jnt_type[j]).name] not in ("hinge", "slide"):
            return "which acts on a joint of several axes"
        if kinds[:2] != ("none", "fixed") or kinds[2] not in ("none", "affine"):
            return f"whose dynamics are {', '.join(kinds)}"
        if model.actuator_delay[k]:
            return "which acts with a delay"
        return None

    def motor(self, k: int) -> Motor | None:
        model, mujoco, name = self.model, self.mujoco, self.name("ACTUATOR", k)
        dynamics, gain, bias = (
            mujoco.mjtDyn(model.actuator_dyntype[k]),
            mujoco.mjtGain(model.actuator_gaintype[k]),
            mujoco.mjtBias(model.actuator_biastype[k]),
        )
        kinds = tuple(kind.name.partition("_")[2].lower() for kind in (dynamics, gain, bias))
        reason = self.reason_to_omit(k, kinds)
        if reason is not None:
            self.left_out.append(f"the actuator '{name}', {reason}")
            return None
        if model.actuator_forcelimited[k]:
            self.left_out.append(f"the limits of the force of the actuator '{name}'")
        # Actuators of other kinds may have several inputs and forces.
        gear = float(model.actuator_gear[model.actuator_outadr[k]][0])
        signal = int(model.actuator_ctrladr[k])
        bounded = model.actuator_ctrllimited[signal] and not self.disabled("CLAMPCTRL")
        constant, length, rate = (
            model.actuator_biasprm[k][:3] if kinds[2] == "affine" else (0.0, 0.0, 0.0)
        )
        low, high = model.actuator_ctrlrange[signal]
        end = int(model.actuator_trnid[k][0])
        by_tendon = mujoco.mjtTrn(model.actuator_trntype[k]) == mujoco.mjtTrn.mjTRN_TENDON
        return Motor(
            name,
            None if by_tendon else self.joint_name(end),
            tendon=self.name("TENDON", end) if by_tendon else None,
            gain=gear * float(model.actuator_gainprm[k][0]),
            constant=gear * float(constant),
            stiffness=-gear * gear * float(length),
            damping=-gear * gear * float(rate),
            input_range=(float(low), float(high)) if bounded else None,
        )

    def equality(self, k: int) -> EqualityConstraint | None:
        model, mujoco, name = self.model, self.mujoco, self.name("EQUALITY", k)
        kind = mujoco.mjtEq(model.eq_type[k]).name.removeprefix("mjEQ_").lower()
        if self.disabled("EQUALITY") or not model.eq_active0[k]:
            self.left_out.append(f"the equality '{name}', which is not active")
            return None
        first, second = int(model.eq_obj1id[k]), int(model.eq_obj2id[k])
        data = np.array(model.eq_data[k])
        if kind == "joint":
            names = [self.joint_name(j) if j >= 0 else None for j in (first, second)]
            return EqualityConstraint(
                "joint", names[0], names[1], polynomial=tuple(data[:5].tolist())
            )
        if kind == "tendon" and all(self.is_fixed(t) for t in (first, second) if t >= 0):
            names = [self.name("TENDON", t) if t >= 0 else None for t in (first, second)]
            return EqualityConstraint(
                "tendon", names[0], names[1], polynomial=tuple(data[:5].tolist())
            )
        if kind == "tendon":
            self.left_out.append(f"the equality '{name}', of spatial tendons")
            return None
        if kind not in ("connect", "weld"):
            self.left_out.append(f"the equality '{name}', of the kind '{kind}'")
            return None
        if model.eq_objtype[k] == mujoco.mjtObj.mjOBJ_SITE:
            ends = [
                (int(model.site_bodyid[s]) - 1, np.array(model.site_pos[s]))
                for s in (first, second)
            ]
            rotations = [of_quaternion(model.site_quat[s]) for s in (first, second)]
            rotation = rotations[0] @ rotations[1].T
        else:
            points = (data[0:3], data[3:6]) if kind == "connect" else (data[3:6], data[0:3])
            ends = [(first - 1, points[0]), (second - 1, points[1])]
            rotation = of_quaternion(data[6:10]) if kind == "weld" else np.eye(3)
        constraint_kind = (
            kind if data[10] else "connect"
        )  # a weld without a scale of torques lets bodies turn
        return EqualityConstraint(
            constraint_kind, ends[0][0], ends[1][0], (ends[0][1], ends[1][1]), rotation
        )

    def visuals(self, body: int) -> Iterator[VisualShape]:
        model, mujoco = self.model, self.mujoco
        first = int(model.body_geomadr[body])
        for g in range(first, first + int(model.body_geomnum[body])):
            rgba = np.array(model.geom_rgba[g])
            if (material := int(model.geom_matid[g])) >= 0:
                rgba = np.array(model.mat_rgba[material])
            # Groups from 3 on are collision geometry, as in MuJoCo's viewer.
            if model.geom_group[g] >= 3 or not rgba[3] > 0.0:
                continue
            kind = mujoco.mjtGeom(model.geom_type[g]).name.removeprefix("mjGEOM_").lower()
            options = {"colour": tuple(rgba[:3].tolist()), "opacity": float(min(rgba[3], 1.0))}
            shape = self.shape(kind, g, model.geom_size[g].tolist(), options)
            if shape is None:
                continue
            yield VisualShape(shape, np.array(model.geom_pos[g]), of_quaternion(model.geom_quat[g]))

    def shape(self, kind: str, g: int, size: list[float], options: dict[str, Any]) -> Shape | None:
        model = self.model
        if kind == "sphere":
            return Sphere(size[0], **options)
        if kind == "capsule":
            return Capsule(2 * size[1], size[0], axis="z", **options)
        if kind == "cylinder":
            return Cylinder(2 * size[1], size[0], axis="z", **options)
        if kind == "box":
            return Box(*(2 * s for s in size), **options)
        if kind == "mesh":
            k = int(model.geom_dataid[g])
            first, count = int(model.mesh_vertadr[k]), int(model.mesh_vertnum[k])
            vertices = np.array(model.mesh_vert[first : first + count], dtype=float)
            first, count = int(model.mesh_faceadr[k]), int(model.mesh_facenum[k])
            return Mesh((vertices, np.array(model.mesh_face[first : first + count])), **options)
        if kind == "plane":  # the ground, which the viewer draws itself
            return None
        self.left_out.append(f"the look of a geom of the kind '{kind}'")
        return None

    def note_omissions(self) -> None:
        model = self.model
        if model.ngeom and not self.disabled("CONTACT"):
            touching = np.flatnonzero(model.geom_contype | model.geom_conaffinity)
            if len(touching) > 1 or model.npair:
                self.left_out.append("contacts")
        self.left_out += [
            f"the spatial tendon '{self.name('TENDON', k)}'"
            for k in range(model.ntendon)
            if not self.is_fixed(k)
        ]
        for count, element in (
            (model.nsensor, "sensors"),
            (model.nflex, "flexible bodies"),
            (model.nplugin, "plugins"),
            (model.nkey, "keyframes"),
        ):
            if count:
                self.left_out.append(element)
        if model.opt.density or model.opt.viscosity:
            self.left_out.append("the forces of the fluid around")
