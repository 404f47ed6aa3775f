"""URDF files: links, joints and looks, read from their XML.

The format is that of the ROS package ``urdf``. MuJoCo's own reader refuses a third of the robots
that are in use (inertias that break the triangle inequality, moving links without mass, missing
meshes), all of which have well-defined equations of motion: these files are read here.
"""

from __future__ import annotations

import re
from collections import Counter
from functools import cached_property, partial
from pathlib import Path
from typing import Any
from xml.etree import ElementTree
from xml.parsers import expat

import numpy as np

from pydy._errors import RobotFileError, warn_user
from pydy._names import untaken
from pydy._rank import ROUNDED
from pydy.robots.tree import (
    Joint,
    Link,
    Look,
    Motor,
    Tree,
    of_roll_pitch_yaw,
    to_quaternion,
    turned,
)
from pydy.viz import Box, Cylinder, Mesh, Sphere, read_mesh

_MOVING = {
    "revolute": "hinge",
    "continuous": "hinge",
    "prismatic": "slide",
    "floating": "free",
    "spherical": "ball",  # not in the format's description; written by some exporters
}
_SHOWN = (".stl", ".obj")
_SIZES: dict[str, list[tuple[str, None, int]]] = {  # attributes, as `_Reader.numbers` takes them
    "box": [("size", None, 3)],
    "sphere": [("radius", None, 1)],
    "cylinder": [("length", None, 1), ("radius", None, 1)],
}


class _Reader:
    """Elements with the lines where they stand."""

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
        """Parse the file as other readers of URDF do, which are less strict than XML.

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
                    f"{self.where(element)}: <{tag}> is a macro. Expand them first, with ROS's "
                    "command `xacro`."
                )

        parser.StartElementHandler = start
        parser.EndElementHandler = builder.end
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

    def where(self, element: ElementTree.Element) -> str:
        return f"{self.path}:{self.lines.get(id(element), 1)}"

    def text(self, element: ElementTree.Element, attribute: str) -> str:
        found = element.get(attribute)
        if not found:
            raise RobotFileError(
                f"{self.where(element)}: <{element.tag}> must have the attribute '{attribute}'."
            )
        return found

    def only(self, element: ElementTree.Element, tag: str) -> ElementTree.Element | None:
        """Return the child of this kind, or None; of two that differ, none is to be preferred."""
        found = element.findall(tag)
        if any(_content(other) != _content(found[0]) for other in found[1:]):
            raise RobotFileError(
                f"{self.where(found[1])}: <{element.tag}> holds more than one <{tag}>, and they "
                "differ. Keep one of them."
            )
        return found[0] if found else None

    def child(self, element: ElementTree.Element, tag: str) -> ElementTree.Element:
        found = self.only(element, tag)
        if found is None:
            name = element.get("name")
            of_name = f" of '{name}'" if name else ""
            raise RobotFileError(
                f"{self.where(element)}: <{element.tag}>{of_name} must hold a <{tag}>."
            )
        return found

    def numbers(
        self, element: ElementTree.Element | None, attribute: str, default: Any, count: int
    ) -> np.ndarray:
        text = None if element is None else element.get(attribute)
        if element is None or text is None:
            if default is None:
                assert element is not None
                self.text(element, attribute)
            return np.full(count, default, float) if np.isscalar(default) else np.array(default)
        try:
            found = np.array([float(part) for part in text.split()])
        except ValueError:
            found = np.empty(0)
        if "_" in text or not text.isascii():  # numbers in Python alone
            found = np.empty(0)
        for part, value in zip(text.split(), found, strict=False):
            if not value and re.search("[1-9]", part.lower().partition("e")[0]):
                raise RobotFileError(
                    f"{self.where(element)}: '{attribute}' of <{element.tag}> has the number "
                    f"{part}, which is smaller than any floating-point number. Write 0 for it."
                )
        if len(found) != count or not np.isfinite(found).all():
            what = "a finite number" if count == 1 else f"{count} finite numbers"
            raise RobotFileError(
                f"{self.where(element)}: '{attribute}' of <{element.tag}> must be {what}, got "
                f"{text!r}."
            )
        return found

    def number(self, element: ElementTree.Element | None, attribute: str, default: Any) -> float:
        return float(self.numbers(element, attribute, default, 1)[0])

    def pose(self, element: ElementTree.Element) -> tuple[np.ndarray, np.ndarray]:
        origin = self.only(element, "origin")
        place = self.numbers(origin, "xyz", 0.0, 3)
        return place, of_roll_pitch_yaw(self.numbers(origin, "rpy", 0.0, 3))


def _content(element: ElementTree.Element) -> Any:
    """Return what an element says: two of equal content are one that was written twice."""
    attributes = {key: value.split() for key, value in element.attrib.items()}
    return element.tag, attributes, [_content(child) for child in element]


def read_urdf(path: Path, floating: bool = False) -> Tree:
    """Read a URDF file into a Tree; the root link is fixed in the world, or floats."""
    reader = _Reader(path)
    root = reader.root
    if root.tag != "robot":
        raise RobotFileError(
            f"{reader.where(root)}: the outermost element of a URDF file must be <robot>, got "
            f"<{root.tag}>."
        )
    links = {reader.text(e, "name"): e for e in root.findall("link")}
    joints = root.findall("joint")
    for kind, elements in (("link", root.findall("link")), ("joint", joints)):
        _check_once(reader, kind, elements)
    if not links:
        raise RobotFileError(f"{reader.where(root)}: <robot> holds no <link>.")
    above = _joints_above(reader, links, joints)
    left_out: list[str] = []
    found: list[Link] = []
    numbers: dict[str | None, int] = {}
    for name in _in_order(reader, links, above):
        numbers[name] = len(found)
        found.append(_link(reader, name, links[name], above.get(name), numbers, left_out))
    _warn_of_inertias(reader, links)
    _warn_of_ball_joints(found)
    if floating:
        name = untaken("root", [joint.get("name", "") for joint in joints])
        found[0].joints = [Joint(name, "free", where=found[0].where)]
    if root.find("transmission") is not None:
        left_out.append("transmissions: each joint has a force of its own")
    motors = [
        Motor(
            joint.name,
            joint.name,
            input_range=None if joint.effort is None else (-joint.effort, joint.effort),
        )
        for link in found
        for joint in link.joints
        if joint.kind in ("hinge", "slide") and joint.mimics is None
    ]
    _check_mimics(found)
    tree = Tree(root.get("name") or path.stem, found, motors, left_out=left_out)
    _set_free(tree)
    return tree


def _set_free(tree: Tree) -> None:
    """Let floating links start where the file shows them."""
    for link in tree.links:
        if [joint.kind for joint in link.joints] != ["free"]:
            continue
        place, turn, above = link.place, link.turn, link.parent
        while above >= 0:
            parent = tree.links[above]
            if parent.joints:
                raise RobotFileError(
                    f"{link.joints[0].where}: the floating joint '{link.joints[0].name}' hangs on "
                    f"the link '{parent.name}', which moves; it must hang on one that rests."
                )
            place, turn = parent.place + parent.turn @ place, parent.turn @ turn
            above = parent.parent
        tree.start[link.joints[0].name] = np.concatenate([place, to_quaternion(turn)])


def _check_once(reader: _Reader, kind: str, elements: list[ElementTree.Element]) -> None:
    counts = Counter(reader.text(e, "name") for e in elements)
    for element in reversed(elements):
        if counts[element.get("name", "")] > 1:
            raise RobotFileError(
                f"{reader.where(element)}: there is more than one {kind} '{element.get('name')}'."
            )


def _joints_above(
    reader: _Reader,
    links: dict[str, ElementTree.Element],
    joints: list[ElementTree.Element],
) -> dict[str, ElementTree.Element]:
    """Return the joint that each link hangs on."""
    above: dict[str, ElementTree.Element] = {}
    for joint in joints:
        for end in ("parent", "child"):
            element = reader.child(joint, end)
            if reader.text(element, "link") not in links:
                raise RobotFileError(
                    f"{reader.where(element)}: there is no link '{element.get('link')}', which "
                    f"the joint '{joint.get('name')}' has as its {end}."
                )
        name = reader.child(joint, "child").get("link", "")
        if name in above:
            raise RobotFileError(
                f"{reader.where(joint)}: the link '{name}' is the child of two joints, "
                f"'{above[name].get('name')}' and '{joint.get('name')}'; URDF knows trees alone. "
                "Close a loop with a constraint of the System, or use an MJCF file."
            )
        above[name] = joint
    return above


def _in_order(
    reader: _Reader,
    links: dict[str, ElementTree.Element],
    above: dict[str, ElementTree.Element],
) -> list[str]:
    """Return the names of the links, each after its parent, in the file's order otherwise."""
    roots = [name for name in links if name not in above]
    if len(roots) != 1:
        if not roots:
            first = next(iter(links.values()))
            raise RobotFileError(
                f"{reader.where(first)}: there is no root: each link is the child of a joint, so "
                "that they form a ring."
            )
        raise RobotFileError(
            f"{reader.where(links[roots[1]])}: there is more than one root: no joint has "
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
    lost = [name for name in links if name not in reached]
    if lost:
        raise RobotFileError(
            f"{reader.where(above[lost[0]])}: the links {', '.join(map(repr, lost[:3]))} form a "
            "ring that hangs on nothing."
        )
    return order


def _link(
    reader: _Reader,
    name: str,
    element: ElementTree.Element,
    above: ElementTree.Element | None,
    numbers: dict[str | None, int],
    left_out: list[str],
) -> Link:
    link = Link(name, -1, np.zeros(3), np.eye(3), where=reader.where(element))
    if above is not None:
        link.parent = numbers[reader.child(above, "parent").get("link")]
        link.place, link.turn = reader.pose(above)
        link.joints = _joints(reader, above, left_out)
    inertial = reader.only(element, "inertial")
    if inertial is not None:
        link.mass = reader.number(reader.child(inertial, "mass"), "value", None)
        link.centre, turn = reader.pose(inertial)
        about = reader.only(inertial, "inertia")
        xx, yy, zz, xy, xz, yz = (
            reader.number(about, f"i{axes}", 0.0) for axes in ("xx", "yy", "zz", "xy", "xz", "yz")
        )
        inertia = np.array([[xx, xy, xz], [xy, yy, yz], [xz, yz, zz]])
        link.inertia = turned(inertia, turn)
    for visual in element.findall("visual"):
        look = _look(reader, visual, left_out)
        if look is not None:
            link.looks.append(look)
    return link


def _warn_of_inertias(reader: _Reader, links: dict[str, ElementTree.Element]) -> None:
    """Warn, once, of inertias that no body has, by more than the digits that are not written.

    Negative principal moments are told elsewhere.
    """
    found = []
    for name, element in links.items():
        about = element.find("inertial/inertia")
        if about is None:
            continue
        texts = [about.get(f"i{axes}", "0") for axes in ("xx", "xy", "yy", "xz", "yz", "zz")]
        matrix, unsure = np.zeros((2, 3, 3))
        for (i, j), text in zip(
            ((0, 0), (1, 0), (1, 1), (2, 0), (2, 1), (2, 2)), texts, strict=True
        ):
            matrix[i, j] = matrix[j, i] = float(text)
            if matrix[i, j]:
                unsure[i, j] = unsure[j, i] = 0.5 * _last_digit(text)
        a, b, c = np.linalg.eigvalsh(matrix)
        if a >= 0.0 and c - a - b > 3.0 * np.linalg.norm(unsure) + ROUNDED * c:
            found.append(f"'{name}' ({reader.where(about)}; {c:.6g} > {a:.6g} + {b:.6g})")
    if found:
        warn_user(
            f"No body has the inertia of the link {found[0]}: a principal moment is larger than "
            "the other two together"
            + (f"; nor those of {len(found) - 1} other links of this file" if found[1:] else "")
            + ". They are taken as they are. Correct them in the file."
        )


def _warn_of_ball_joints(links: list[Link]) -> None:
    """Warn, once, of joints that move otherwise in programs that do not know their type."""
    found = [joint for link in links for joint in link.joints if joint.kind == "ball"]
    if found:
        others = f", as are {len(found) - 1} others" if found[1:] else ""
        warn_user(
            f"The joint '{found[0].name}' ({found[0].where}){others} is of the type 'spherical', "
            "which the URDF format does not have. It is read as a ball joint, with a quaternion "
            "and three components of the angular velocity."
        )


def _last_digit(text: str) -> float:
    """Return the value of a one in the last digit of a number that is not zero."""
    mantissa, _, exponent = text.strip().lower().partition("e")
    return float(10.0 ** (float(exponent or 0) - len(mantissa.partition(".")[2])))


def _joints(reader: _Reader, element: ElementTree.Element, left_out: list[str]) -> list[Joint]:
    name, kind = reader.text(element, "name"), reader.text(element, "type")
    where = reader.where(element)
    if kind == "fixed":
        return []
    if kind in ("planar", "floating", "spherical"):
        more = [tag for tag in ("limit", "dynamics", "mimic") if element.find(tag) is not None]
        if kind == "spherical":
            more = [tag for tag in more if tag != "dynamics"]
        left_out += [f"the <{tag}> of the {kind} joint '{name}'" for tag in more]
    if kind == "planar":
        normal = _axis(reader, element, [1.0, 0.0, 0.0])
        along = np.cross(normal, np.eye(3)[np.argmin(np.abs(normal))])
        along /= np.linalg.norm(along)
        taken = reader.joint_names
        x, y, turn = (untaken(f"{name}_{end}", taken) for end in ("x", "y", "turn"))
        return [
            Joint(x, "slide", along, where=where),
            Joint(y, "slide", np.cross(normal, along), where=where),
            Joint(turn, "hinge", normal, where=where),
        ]
    if kind not in _MOVING:
        raise RobotFileError(
            f"{where}: the joint '{name}' is of the type {kind!r}; known are "
            f"{', '.join(map(repr, ('fixed', *_MOVING, 'planar')))}. Replace it in the file by the "
            "one that moves in the same way."
        )
    joint = Joint(name, _MOVING[kind], where=where)
    if joint.kind == "free":
        return [joint]
    limit, dynamics = (reader.only(element, tag) for tag in ("limit", "dynamics"))
    joint.damping = reader.number(dynamics, "damping", 0.0)
    joint.friction = reader.number(dynamics, "friction", 0.0)
    if joint.kind == "ball":
        return [joint]
    joint.axis = _axis(reader, element, [1.0, 0.0, 0.0])
    if limit is not None:
        joint.effort = reader.number(limit, "effort", 0.0) or None
        if joint.effort is not None and joint.effort < 0.0:
            raise RobotFileError(
                f"{reader.where(limit)}: the effort of the joint '{name}' must not be negative, "
                f"got {joint.effort:g}."
            )
        low, high = reader.number(limit, "lower", 0.0), reader.number(limit, "upper", 0.0)
        if kind != "continuous" and low < high:
            joint.limits = (low, high)
        elif kind != "continuous" and low > high:
            left_out.append(f"the limits of the joint '{name}', the lower of which is the upper")
        elif kind != "continuous" and low:
            left_out.append(f"the limits of the joint '{name}', which are equal, {low:g}")
    mimic = reader.only(element, "mimic")
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


def _axis(reader: _Reader, element: ElementTree.Element, default: list[float]) -> np.ndarray:
    axis = reader.only(element, "axis")
    found = reader.numbers(axis, "xyz", default, 3)
    found = found / (np.abs(found).max() or 1.0)  # squares of tiny and huge ones are no floats
    size = np.linalg.norm(found)
    if not size > 0.0:
        assert axis is not None
        raise RobotFileError(
            f"{reader.where(axis)}: the axis of the joint '{element.get('name')}' has no "
            f"direction, got {axis.get('xyz')!r}."
        )
    direction: np.ndarray = found / size
    return direction


def _check_mimics(links: list[Link]) -> None:
    joints = {joint.name: joint for link in links for joint in link.joints}
    checked: set[str] = set()
    for joint in joints.values():
        seen = {joint.name: None}  # in order
        while joint.mimics is not None and joint.name not in checked:
            name = joint.mimics[0]
            if name not in joints or joints[name].kind not in ("hinge", "slide"):
                raise RobotFileError(
                    f"{joint.where}: the joint '{joint.name}' mimics '{name}', which is no "
                    "revolute, continuous or prismatic joint of this robot."
                )
            if name in seen:
                raise RobotFileError(
                    f"{joint.where}: joints mimic each other in a ring: {', '.join(seen)}."
                )
            seen[name] = None
            joint = joints[name]
        checked.update(seen)


# -- looks -----------------------------------------------------------------------------------------


def _look(reader: _Reader, visual: ElementTree.Element, left_out: list[str]) -> Look | None:
    geometry = reader.child(visual, "geometry")
    try:
        shape = _shape(reader, visual, geometry, left_out)
    except RobotFileError:
        raise
    except (OSError, ValueError) as error:
        raise RobotFileError(f"{reader.where(geometry)}: {error}") from None
    return None if shape is None else Look(shape, *reader.pose(visual))


def _shape(
    reader: _Reader,
    visual: ElementTree.Element,
    geometry: ElementTree.Element,
    left_out: list[str],
) -> Any:
    options = _colours(reader, visual, left_out)
    shape: Any = None
    for element in geometry:
        if element.tag in _SIZES:
            size = np.concatenate([reader.numbers(element, *a) for a in _SIZES[element.tag]])
            if (size == 0.0).any():  # a mark for a point, in files that are in use
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


def _colours(reader: _Reader, visual: ElementTree.Element, left_out: list[str]) -> dict[str, Any]:
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
    reader: _Reader, element: ElementTree.Element, options: dict[str, Any], left_out: list[str]
) -> partial[Mesh] | None:
    name = reader.text(element, "filename")
    path = _file_of(reader.path, name)
    if path is None:
        left_out.append(f"the mesh {name}, which is not found ({reader.where(element)})")
        return None
    if path.suffix.lower() not in _SHOWN:
        left_out.append(f"the mesh {name}: STL and OBJ files are shown")
        return None
    try:
        scale = reader.numbers(element, "scale", 1.0, 3)
    except RobotFileError as error:  # the mechanics need no mesh
        left_out.append(f"the mesh {name}: {error}")
        return None
    return partial(_read_mesh, reader.where(element), path, scale, options)


def _read_mesh(where: str, path: Path, scale: np.ndarray, options: dict[str, Any]) -> Mesh:
    try:
        vertices, faces = read_mesh(path)
        return Mesh((vertices * scale, faces), **options)
    except (OSError, ValueError) as error:
        raise RobotFileError(f"{where}: {error}") from None


def _file_of(robot: Path, name: str) -> Path | None:
    """Return the file that a URDF file names, or None where there is none.

    ROS looks packages up among those installed; here they are looked for around the file: a package
    is a folder above it, or beside one above it.
    """
    scheme, _, rest = name.rpartition("://")
    if scheme in ("", "file"):
        found = robot.parent / rest
        return found if found.is_file() else None
    package, _, inside = rest.partition("/")
    for folder in robot.resolve().parents:
        for start in (folder / package, folder if folder.name == package else None):
            if start is not None and (start / inside).is_file():
                return start / inside
    return None
