"""URDF files: links, joints and visual shapes, read from their XML.

The format is that of the ROS package ``urdf``. MuJoCo's reader rejects a third of the published
robots (inertias that violate the triangle inequality, moving links without mass, missing meshes).
They have well-defined equations of motion, and this module reads them.
"""

from __future__ import annotations

import re
from collections import Counter
from functools import cached_property, partial
from pathlib import Path
from typing import TYPE_CHECKING, Any
from xml.etree import ElementTree
from xml.parsers import expat

import numpy as np

from pydy._errors import RobotFileError, warn_user
from pydy._names import counted, unused_name
from pydy._rank import ROUNDED
from pydy._rotations import to_quaternions
from pydy.robots.tree import (
    Link,
    Motor,
    RobotJoint,
    Tree,
    VisualShape,
    of_roll_pitch_yaw,
    rotated_inertia,
)
from pydy.viz import Box, Cylinder, Mesh, Sphere, read_mesh

if TYPE_CHECKING:
    from collections.abc import Sequence

    from pydy.viz import Shape

_MOVING = {
    "revolute": "hinge",
    "continuous": "hinge",
    "prismatic": "slide",
    "floating": "free",
    "spherical": "ball",  # not in the format's description; written by some exporters
}
_MESH_SUFFIXES = (".stl", ".obj")
_SIZES: dict[str, list[tuple[str, None, int]]] = {  # arguments of `_UrdfReader.numbers`
    "box": [("size", None, 3)],
    "sphere": [("radius", None, 1)],
    "cylinder": [("length", None, 1), ("radius", None, 1)],
}


_CHILDREN = {  # of the format; others are extensions of programs
    "robot": {"link", "joint", "material", "transmission", "gazebo"},
    "link": {"inertial", "visual", "collision"},
    "joint": {
        *("origin", "parent", "child", "axis", "calibration"),
        *("dynamics", "limit", "mimic", "safety_controller"),
    },
}
_NO_DYNAMICS = {  # extensions of Gazebo for contacts, ends of ranges, looks and measurements
    *("collision", "fdir1", "fudgeFactor", "kd", "kp", "laserRetro", "material", "maxContacts"),
    *("maxVel", "minDepth", "mu1", "mu2", "provideFeedback", "selfCollide", "self_collide"),
    *("sensor", "stopCfm", "stopErp", "stopKd", "stopKp", "visual"),
}


class _UrdfReader:
    """The XML elements of a file, with their line numbers."""

    def __init__(self, path: Path) -> None:
        self.path = path
        self.lines: dict[int, int] = {}
        self.root = self._parsed(path.read_bytes())

    @cached_property
    def joint_names(self) -> set[str]:
        return {joint.get("name", "") for joint in self.root.findall("joint")}

    @cached_property
    def colours(self) -> dict[str | None, ElementTree.Element | None]:
        """The colours of the robot's materials, by name."""
        materials = self.root.findall("material")
        return {material.get("name"): material.find("color") for material in materials}

    def _parsed(self, data: bytes) -> ElementTree.Element:
        """Parse the file like other URDF readers, which are less strict than XML.

        NUL characters may follow the last element, and blank lines and comments may precede the XML
        declaration.
        """
        if b"\0" not in data[:4]:  # in UTF-16, every other byte is NUL
            data = data.rstrip(b"\0 \t\r\n")
        try:
            return self._parsed_strictly(data, None)
        except expat.ExpatError as error:
            declaration = re.compile(rb"<\?xml\s[^>]*\?>").search(data)
            misplaced = expat.errors.codes[expat.errors.XML_ERROR_MISPLACED_XML_PI]
            if error.code != misplaced or self.lines or declaration is None:
                raise self._not_well_formed(error) from None
        encoding = re.search(rb"encoding\s*=\s*[\"']([\w.-]+)", declaration[0])
        blank = re.sub(rb"[^\r\n]", b" ", declaration[0])  # lines keep their numbers
        data = data[: declaration.start()] + blank + data[declaration.end() :]
        try:
            return self._parsed_strictly(data, encoding and encoding[1].decode("ascii"))
        except expat.ExpatError as error:
            raise self._not_well_formed(error) from None

    def _not_well_formed(self, error: expat.ExpatError) -> RobotFileError:
        return RobotFileError(f"{self.path}:{error.lineno}: not well-formed XML: {error}.")

    def _parsed_strictly(self, data: bytes, encoding: str | None) -> ElementTree.Element:
        builder, parser = ElementTree.TreeBuilder(), expat.ParserCreate(encoding)

        def start(tag: str, attributes: dict[str, str]) -> None:
            element = builder.start(tag, attributes)
            self.lines[id(element)] = parser.CurrentLineNumber
            if tag.startswith("xacro:"):
                raise RobotFileError(
                    f"{self.location(element)}: <{tag}> is a macro. Expand them first, with ROS's "
                    "command `xacro`."
                )

        parser.StartElementHandler = start
        parser.EndElementHandler = builder.end
        parser.CharacterDataHandler = builder.data
        try:
            parser.Parse(data, True)
        except (expat.ExpatError, RobotFileError):
            raise
        except (LookupError, ValueError) as error:
            raise RobotFileError(
                f"{self.path}:1: the encoding that the file declares cannot be read: {error}. Save "
                "it as UTF-8."
            ) from None
        return builder.close()

    def location(self, element: ElementTree.Element) -> str:
        return f"{self.path}:{self.lines.get(id(element), 1)}"

    def text(self, element: ElementTree.Element, attribute: str) -> str:
        value = element.get(attribute)
        if not value:
            raise RobotFileError(
                f"{self.location(element)}: <{element.tag}> must have the attribute '{attribute}'."
            )
        return value

    def unique_child(self, element: ElementTree.Element, tag: str) -> ElementTree.Element | None:
        """Return the child with this tag, or None; raise an error if there are different ones."""
        children = element.findall(tag)
        if any(_content(child) != _content(children[0]) for child in children[1:]):
            raise RobotFileError(
                f"{self.location(children[1])}: <{element.tag}> holds more than one <{tag}>, and "
                "they differ. Keep one of them."
            )
        return children[0] if children else None

    def child(self, element: ElementTree.Element, tag: str) -> ElementTree.Element:
        child = self.unique_child(element, tag)
        if child is None:
            name = element.get("name")
            of_name = f" of '{name}'" if name else ""
            raise RobotFileError(
                f"{self.location(element)}: <{element.tag}>{of_name} must hold a <{tag}>."
            )
        return child

    def numbers(
        self,
        element: ElementTree.Element | None,
        attribute: str,
        default: float | Sequence[float] | None,
        count: int,
    ) -> np.ndarray:
        text = None if element is None else element.get(attribute)
        if element is None or text is None:
            if default is None:
                assert element is not None
                self.text(element, attribute)
            return np.full(count, default, float) if np.isscalar(default) else np.array(default)
        try:
            values = np.array([float(part) for part in text.split()])
        except ValueError:
            values = np.empty(0)
        if "_" in text or not text.isascii():  # numbers in Python, but not in URDF
            values = np.empty(0)
        for part, number in zip(text.split(), values, strict=False):
            if not number and re.search("[1-9]", part.lower().partition("e")[0]):
                raise RobotFileError(
                    f"{self.location(element)}: '{attribute}' of <{element.tag}> has the number "
                    f"{part}, which is smaller than any floating-point number. Write 0 for it."
                )
        if len(values) != count or not np.isfinite(values).all():
            requirement = "a finite number" if count == 1 else f"{count} finite numbers"
            raise RobotFileError(
                f"{self.location(element)}: '{attribute}' of <{element.tag}> must be "
                f"{requirement}, got {text!r}."
            )
        return values

    def number(
        self, element: ElementTree.Element | None, attribute: str, default: float | None
    ) -> float:
        return float(self.numbers(element, attribute, default, 1)[0])

    def pose(self, element: ElementTree.Element) -> tuple[np.ndarray, np.ndarray]:
        origin = self.unique_child(element, "origin")
        position = self.numbers(origin, "xyz", 0.0, 3)
        return position, of_roll_pitch_yaw(self.numbers(origin, "rpy", 0.0, 3))


def _content(element: ElementTree.Element) -> tuple[str, dict[str, list[str]], list[object]]:
    """Return the content of an element, to recognise an element that was written twice."""
    attributes = {key: value.split() for key, value in element.attrib.items()}
    return element.tag, attributes, [_content(child) for child in element]


def read_urdf(path: Path, floating: bool = False) -> Tree:
    """Read a URDF file into a Tree; the root link is fixed in the world, or floats."""
    reader = _UrdfReader(path)
    root = reader.root
    if root.tag != "robot":
        raise RobotFileError(
            f"{reader.location(root)}: the outermost element of a URDF file must be <robot>, got "
            f"<{root.tag}>."
        )
    for element in root:
        if element.tag.endswith((":joint", ":link")):  # Drake's, of types that URDF does not have
            raise RobotFileError(
                f"{reader.location(element)}: <{element.tag}> is an extension of the URDF format, "
                "which is not read here. Write the robot with the joints that URDF has, or as an "
                "MJCF file."
            )
    links = {reader.text(e, "name"): e for e in root.findall("link")}
    joints = root.findall("joint")
    for kind, elements in (("link", root.findall("link")), ("joint", joints)):
        _check_once(reader, kind, elements)
    if not links:
        raise RobotFileError(f"{reader.location(root)}: <robot> holds no <link>.")
    above = _joints_above(reader, links, joints)
    left_out: list[str] = []
    tree_links: list[Link] = []
    numbers: dict[str | None, int] = {}
    for name in _in_order(reader, links, above):
        numbers[name] = len(tree_links)
        tree_links.append(_link(reader, name, links[name], above.get(name), numbers, left_out))
    _warn_of_inertias(reader, links)
    _warn_of_ball_joints(tree_links)
    if floating:
        name = unused_name("root", [joint.get("name", "") for joint in joints])
        tree_links[0].joints = [RobotJoint(name, "free", location=tree_links[0].location)]
    if root.find("transmission") is not None:
        left_out.append("transmissions: each joint has a force of its own")
    left_out += _extensions(root)
    motors = [
        Motor(
            joint.name,
            joint.name,
            input_range=None if joint.effort is None else (-joint.effort, joint.effort),
        )
        for link in tree_links
        for joint in link.joints
        if joint.kind in ("hinge", "slide") and joint.mimics is None
    ]
    _check_mimics(tree_links)
    tree = Tree(root.get("name") or path.stem, tree_links, motors, left_out=left_out)
    _place_floating_links(tree)
    return tree


def _place_floating_links(tree: Tree) -> None:
    """Set the start of floating links to the file's pose."""
    for link in tree.links:
        if [joint.kind for joint in link.joints] != ["free"]:
            continue
        position, rotation, above = link.origin, link.rotation, link.parent
        while above >= 0:
            parent = tree.links[above]
            if parent.joints:
                raise RobotFileError(
                    f"{link.joints[0].location}: the floating joint '{link.joints[0].name}' hangs "
                    f"on the link '{parent.name}', which moves; it must hang on one that rests."
                )
            position, rotation = (
                parent.origin + parent.rotation @ position,
                parent.rotation @ rotation,
            )
            above = parent.parent
        quaternion = np.roll(to_quaternions(rotation), 1)  # the scalar part first
        tree.start[link.joints[0].name] = np.concatenate([position, quaternion])


def _check_once(reader: _UrdfReader, kind: str, elements: list[ElementTree.Element]) -> None:
    counts = Counter(reader.text(e, "name") for e in elements)
    for element in reversed(elements):
        if counts[element.get("name", "")] > 1:
            raise RobotFileError(
                f"{reader.location(element)}: there is more than one {kind} "
                f"'{element.get('name')}'."
            )


def _joints_above(
    reader: _UrdfReader,
    links: dict[str, ElementTree.Element],
    joints: list[ElementTree.Element],
) -> dict[str, ElementTree.Element]:
    """Return the joint between each link and its parent."""
    above: dict[str, ElementTree.Element] = {}
    for joint in joints:
        for end in ("parent", "child"):
            element = reader.child(joint, end)
            if reader.text(element, "link") not in links:
                raise RobotFileError(
                    f"{reader.location(element)}: there is no link '{element.get('link')}', which "
                    f"the joint '{joint.get('name')}' has as its {end}."
                )
        name = reader.child(joint, "child").get("link", "")
        if name in above:
            raise RobotFileError(
                f"{reader.location(joint)}: the link '{name}' is the child of two joints, "
                f"'{above[name].get('name')}' and '{joint.get('name')}'; URDF knows trees alone. "
                "Close a loop with a constraint of the System, or use an MJCF file."
            )
        above[name] = joint
    return above


def _in_order(
    reader: _UrdfReader,
    links: dict[str, ElementTree.Element],
    above: dict[str, ElementTree.Element],
) -> list[str]:
    """Return the names of the links in depth-first order, each after its parent."""
    roots = [name for name in links if name not in above]
    if len(roots) != 1:
        if not roots:
            first = next(iter(links.values()))
            raise RobotFileError(
                f"{reader.location(first)}: there is no root: each link is the child of a joint, "
                "so that they form a ring."
            )
        raise RobotFileError(
            f"{reader.location(links[roots[1]])}: there is more than one root: no joint has "
            f"{' or '.join(map(repr, roots[:3]))} as its child."
        )
    below: dict[str, list[str]] = {}
    for name, joint in above.items():
        below.setdefault(reader.child(joint, "parent").get("link", ""), []).append(name)
    order, waiting = [], [roots[0]]
    while waiting:
        order.append(waiting.pop())
        waiting += reversed(below.get(order[-1], []))
    reached = set(order)
    unreachable = [name for name in links if name not in reached]
    if unreachable:
        raise RobotFileError(
            f"{reader.location(above[unreachable[0]])}: the links "
            f"{', '.join(map(repr, unreachable[:3]))} form a ring that hangs on nothing."
        )
    return order


def _link(
    reader: _UrdfReader,
    name: str,
    element: ElementTree.Element,
    above: ElementTree.Element | None,
    numbers: dict[str | None, int],
    left_out: list[str],
) -> Link:
    link = Link(name, -1, np.zeros(3), np.eye(3), location=reader.location(element))
    if above is not None:
        link.parent = numbers[reader.child(above, "parent").get("link")]
        link.origin, link.rotation = reader.pose(above)
        link.joints = _joints(reader, above, left_out)
    inertial = reader.unique_child(element, "inertial")
    if inertial is not None:
        link.mass = reader.number(reader.child(inertial, "mass"), "value", None)
        link.centre, rotation = reader.pose(inertial)
        inertia_element = reader.unique_child(inertial, "inertia")
        xx, yy, zz, xy, xz, yz = (
            reader.number(inertia_element, f"i{axes}", 0.0)
            for axes in ("xx", "yy", "zz", "xy", "xz", "yz")
        )
        inertia = np.array([[xx, xy, xz], [xy, yy, yz], [xz, yz, zz]])
        link.inertia = rotated_inertia(inertia, rotation)
    for visual in element.findall("visual"):
        shape = _visual_shape(reader, visual, left_out)
        if shape is not None:
            link.visuals.append(shape)
    return link


def _extensions(root: ElementTree.Element) -> list[str]:
    """Return lines about elements and attributes that programs have added to the format.

    Some of them are springs, dampers, loops, or weights that are turned off.
    """
    lines = []
    for kind, elements in (
        ("robot", [root]),
        ("link", root.findall("link")),
        ("joint", root.findall("joint")),
    ):
        tags = dict.fromkeys(child.tag for element in elements for child in element)
        lines += [
            f"<{tag}> in <{kind}>, which the URDF format does not have"
            for tag in tags
            if tag not in _CHILDREN[kind]
        ]
    attributes = dict.fromkeys(a for e in root.findall("joint/dynamics") for a in e.attrib)
    lines += [
        f"'{attribute}' of <dynamics>, which the URDF format does not have"
        for attribute in attributes
        if attribute not in ("damping", "friction")
    ]
    gazebo = dict.fromkeys(
        f"<{element.tag}>"
        for element in root.findall("gazebo/*")
        if element.tag not in _NO_DYNAMICS and not _has_weight(element)
    )
    if gazebo:
        lines.append(f"{', '.join(gazebo)} in <gazebo>")
    return lines


def _has_weight(element: ElementTree.Element) -> bool:
    """Return whether Gazebo's element says that a link has its weight, as all links have here."""
    text = (element.text or element.get("value") or "").strip().lower()
    return (element.tag, text in ("true", "1")) in (("turnGravityOff", False), ("gravity", True))


def _warn_of_inertias(reader: _UrdfReader, links: dict[str, ElementTree.Element]) -> None:
    """Warn once of inertias that violate the triangle inequality by more than rounded digits.

    `Tree.check` warns of negative principal moments.
    """
    impossible_links = []
    for name, element in links.items():
        inertia_element = element.find("inertial/inertia")
        if inertia_element is None:
            continue
        texts = [
            inertia_element.get(f"i{axes}", "0") for axes in ("xx", "xy", "yy", "xz", "yz", "zz")
        ]
        matrix, unsure = np.zeros((2, 3, 3))
        for (i, j), text in zip(
            ((0, 0), (1, 0), (1, 1), (2, 0), (2, 1), (2, 2)), texts, strict=True
        ):
            matrix[i, j] = matrix[j, i] = float(text)
            if matrix[i, j]:
                unsure[i, j] = unsure[j, i] = 0.5 * _last_digit(text)
        a, b, c = np.linalg.eigvalsh(matrix)
        if a >= 0.0 and c - a - b > 3.0 * np.linalg.norm(unsure) + ROUNDED * c:
            impossible_links.append(
                f"'{name}' ({reader.location(inertia_element)}; {c:.6g} > {a:.6g} + {b:.6g})"
            )
    if impossible_links:
        warn_user(
            f"No body has the inertia of the link {impossible_links[0]}: a principal moment is "
            "larger than the other two together"
            + (
                f"; the same in {counted(len(impossible_links) - 1, 'other link')} of this file"
                if impossible_links[1:]
                else ""
            )
            + ". The file's values are used. Correct them in the file."
        )


def _warn_of_ball_joints(links: list[Link]) -> None:
    """Warn once of the joint type 'spherical', which other programs may not support."""
    ball_joints = [joint for link in links for joint in link.joints if joint.kind == "ball"]
    if ball_joints:
        further = len(ball_joints) - 1
        others_text = f" (and {counted(further, 'other joint')})" if further else ""
        warn_user(
            f"The joint '{ball_joints[0].name}' ({ball_joints[0].location}){others_text} is of the "
            "type 'spherical', which the URDF format does not have. It is read as a ball joint, "
            "with a quaternion and three components of the angular velocity."
        )


def _last_digit(text: str) -> float:
    """Return the value of a one in the last digit of a number that is not zero."""
    mantissa, _, exponent = text.strip().lower().partition("e")
    return float(10.0 ** (float(exponent or 0) - len(mantissa.partition(".")[2])))


def _joints(
    reader: _UrdfReader, element: ElementTree.Element, left_out: list[str]
) -> list[RobotJoint]:
    name, kind = reader.text(element, "name"), reader.text(element, "type")
    location = reader.location(element)
    if kind == "fixed":
        return []
    if kind in ("planar", "floating", "spherical"):
        ignored = [tag for tag in ("limit", "dynamics", "mimic") if element.find(tag) is not None]
        if kind == "spherical":
            ignored = [tag for tag in ignored if tag != "dynamics"]
        left_out += [f"the <{tag}> of the {kind} joint '{name}'" for tag in ignored]
    if kind == "planar":
        normal = _axis(reader, element, [1.0, 0.0, 0.0])
        first_axis = np.cross(normal, np.eye(3)[np.argmin(np.abs(normal))])
        first_axis /= np.linalg.norm(first_axis)
        used_names = reader.joint_names
        x, y, turn = (unused_name(f"{name}_{end}", used_names) for end in ("x", "y", "turn"))
        return [
            RobotJoint(x, "slide", first_axis, location=location),
            RobotJoint(y, "slide", np.cross(normal, first_axis), location=location),
            RobotJoint(turn, "hinge", normal, location=location),
        ]
    if kind not in _MOVING:
        raise RobotFileError(
            f"{location}: the joint '{name}' is of the type {kind!r}; known are "
            f"{', '.join(map(repr, ('fixed', *_MOVING, 'planar')))}. Replace it in the file by the "
            "one that moves in the same way."
        )
    joint = RobotJoint(name, _MOVING[kind], location=location)
    if joint.kind == "free":
        return [joint]
    limit, dynamics = (reader.unique_child(element, tag) for tag in ("limit", "dynamics"))
    joint.damping = reader.number(dynamics, "damping", 0.0)
    joint.friction = reader.number(dynamics, "friction", 0.0)
    if joint.kind == "ball":
        return [joint]
    joint.axis = _axis(reader, element, [1.0, 0.0, 0.0])
    if limit is not None:
        joint.effort = reader.number(limit, "effort", 0.0) or None
        if joint.effort is not None and joint.effort < 0.0:
            raise RobotFileError(
                f"{reader.location(limit)}: the effort of the joint '{name}' must not be negative, "
                f"got {joint.effort:g}."
            )
        low, high = reader.number(limit, "lower", 0.0), reader.number(limit, "upper", 0.0)
        if kind != "continuous" and low < high:
            joint.limits = (low, high)
        elif kind != "continuous" and low > high:
            left_out.append(f"the limits of the joint '{name}', the lower of which is the upper")
        elif kind != "continuous" and low:
            left_out.append(f"the limits of the joint '{name}', which are equal, {low:g}")
    mimic = reader.unique_child(element, "mimic")
    if mimic is not None:
        joint.mimics = (
            reader.text(mimic, "joint"),
            reader.number(mimic, "multiplier", 1.0),
            reader.number(mimic, "offset", 0.0),
        )
    if element.find("safety_controller") is not None:
        line = "safety controllers of joints"
        if line not in left_out:
            left_out.append(line)
    return [joint]


def _axis(reader: _UrdfReader, element: ElementTree.Element, default: list[float]) -> np.ndarray:
    axis = reader.unique_child(element, "axis")
    components = reader.numbers(axis, "xyz", default, 3)
    components = components / (np.abs(components).max() or 1.0)  # avoids overflow of squares
    size = np.linalg.norm(components)
    if not size > 0.0:
        assert axis is not None
        raise RobotFileError(
            f"{reader.location(axis)}: the axis of the joint '{element.get('name')}' has no "
            f"direction, got {axis.get('xyz')!r}."
        )
    direction: np.ndarray = components / size
    return direction


def _check_mimics(links: list[Link]) -> None:
    joints = {joint.name: joint for link in links for joint in link.joints}
    checked: set[str] = set()
    for joint in joints.values():
        visited = {joint.name: None}  # in order
        while joint.mimics is not None and joint.name not in checked:
            name = joint.mimics[0]
            if name not in joints or joints[name].kind not in ("hinge", "slide"):
                raise RobotFileError(
                    f"{joint.location}: the joint '{joint.name}' mimics '{name}', which is no "
                    "revolute, continuous or prismatic joint of this robot."
                )
            if name in visited:
                raise RobotFileError(
                    f"{joint.location}: joints mimic each other in a ring: {', '.join(visited)}."
                )
            visited[name] = None
            joint = joints[name]
        checked.update(visited)


# -- visual shapes ---------------------------------------------------------------------------------


def _visual_shape(
    reader: _UrdfReader, visual: ElementTree.Element, left_out: list[str]
) -> VisualShape | None:
    geometry = reader.child(visual, "geometry")
    try:
        shape = _shape(reader, visual, geometry, left_out)
    except RobotFileError:
        raise
    except (OSError, ValueError) as error:
        raise RobotFileError(f"{reader.location(geometry)}: {error}") from None
    return None if shape is None else VisualShape(shape, *reader.pose(visual))


def _shape(
    reader: _UrdfReader,
    visual: ElementTree.Element,
    geometry: ElementTree.Element,
    left_out: list[str],
) -> Shape | partial[Mesh] | None:
    options = _colours(reader, visual, left_out)
    shape: Shape | partial[Mesh] | None = None
    for element in geometry:
        if element.tag in _SIZES:
            size = np.concatenate([reader.numbers(element, *a) for a in _SIZES[element.tag]])
            if (size == 0.0).any():  # marks a point in some published files
                left_out.append(f"a <{element.tag}> without size, which is not shown")
            elif element.tag == "box":
                shape = Box(*size.tolist(), **options)
            elif element.tag == "sphere":
                shape = Sphere(float(size[0]), **options)
            else:
                shape = Cylinder(float(size[0]), float(size[1]), axis="z", **options)
        elif element.tag == "mesh":
            shape = _mesh(reader, element, options, left_out)
        else:
            left_out.append(f"the shape <{element.tag}>, which is not shown")
    return shape


def _colours(
    reader: _UrdfReader, visual: ElementTree.Element, left_out: list[str]
) -> dict[str, Any]:
    """Return the options of a shape: its material, or the robot's material of that name."""
    material = visual.find("material")
    if material is None:
        return {}
    colour = material.find("color")
    if colour is None:
        colour = reader.colours.get(material.get("name"))
    if colour is None:
        return {}
    try:
        rgba = reader.numbers(colour, "rgba", None, 4).clip(0.0, 1.0)
    except RobotFileError as error:  # the mechanics need no colour
        left_out.append(f"a colour: {error}")
        return {}
    return {"colour": tuple(rgba[:3].tolist()), "opacity": float(rgba[3])}


def _mesh(
    reader: _UrdfReader, element: ElementTree.Element, options: dict[str, Any], left_out: list[str]
) -> partial[Mesh] | None:
    name = reader.text(element, "filename")
    path = _file_of(reader.path, name)
    if path is None:
        left_out.append(f"the mesh {name}, which is not found ({reader.location(element)})")
        return None
    if path.suffix.lower() not in _MESH_SUFFIXES:
        left_out.append(f"the mesh {name}: STL and OBJ files are shown")
        return None
    try:
        scale = reader.numbers(element, "scale", 1.0, 3)
    except RobotFileError as error:  # the mechanics need no mesh
        left_out.append(f"the mesh {name}: {error}")
        return None
    return partial(_read_mesh, reader.location(element), path, scale, options)


def _read_mesh(location: str, path: Path, scale: np.ndarray, options: dict[str, Any]) -> Mesh:
    try:
        vertices, faces = read_mesh(path)
        return Mesh((vertices * scale, faces), **options)
    except (OSError, ValueError) as error:
        raise RobotFileError(f"{location}: {error}") from None


def _file_of(robot: Path, name: str) -> Path | None:
    """Return the file that a URDF file refers to, or None if it does not exist.

    ROS searches for packages among those installed. Here a package is a folder that contains the
    URDF file, or a sibling of such a folder.
    """
    scheme, _, location = name.rpartition("://")
    if scheme in ("", "file"):
        file = robot.parent / location
        return file if file.is_file() else None
    package, _, inside = location.partition("/")
    for folder in robot.resolve().parents:
        for start in (folder / package, folder if folder.name == package else None):
            if start is not None and (start / inside).is_file():
                return start / inside
    return None
