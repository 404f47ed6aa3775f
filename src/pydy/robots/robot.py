"""Robots from files: URDF and MJCF."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from os import PathLike
from typing import TYPE_CHECKING, Any

from sympy.core.function import AppliedUndef

from pydy._checks import check_mapping, choice, flag, positive
from pydy._errors import RobotFileError
from pydy._files import path_of
from pydy._names import counted, few
from pydy._rank import ROUNDED
from pydy.mechanics import Definition
from pydy.robots.assemble import JointSymbols, Place, RobotAssembly, TendonSymbols
from pydy.robots.mjcf import read_mjcf
from pydy.robots.tree import Tree
from pydy.robots.urdf import read_urdf
from pydy.solvers import Event
from pydy.system import System

if TYPE_CHECKING:
    from sympy import Expr, Symbol

    from pydy._sympy_types import AnySymbol, Body, SymbolOrName, TimeFunction
    from pydy.viz import Scene


class Robot:
    """A robot that `read` has read: its mechanics, numbers and looks.

    Attributes
    ----------
    name : str
    definition : pydy.mechanics.Definition
        Bodies, loads, kinematics and constraints, in symbols.
    values : dict
        The constants' values as the file has them.
    start : dict
        The coordinates in the pose that the file shows.
    frames : dict
        By the name of a link, and ``'world'``: its `frame` and its `point`, SymPy's.
    joints : dict
        By name: `coordinates`, `speeds`, `limits` and `effort`.
    tendons : dict
        By the name of an MJCF file's fixed tendon: `length`, `rate` and `limits`.
    actuators : dict
        By name: the specified function of time that drives it; zero unless you give it a value.
    input_ranges : dict
        By the name of an actuator: the least and the largest input that the file allows.
    left_out : tuple of str
        Properties of the file that this robot does not have, and values that no real robot has.
    """

    def __init__(self, tree: Tree, assembly: RobotAssembly) -> None:
        self.name = tree.name
        self.definition: Definition = assembly.definition
        self.values: dict[Symbol, float] = assembly.values
        self.start: dict[TimeFunction, float] = assembly.start
        self.frames: dict[str, Place] = assembly.frames
        # The root of a URDF file is often called 'world', too.
        names = ["world", *(link.name for link in tree.links)]
        self._link_frames = list(zip(names, assembly.link_frames, strict=True))
        self.joints: dict[str, JointSymbols] = assembly.joints
        self.tendons: dict[str, TendonSymbols] = assembly.tendons
        self.actuators: dict[str, TimeFunction] = assembly.actuators
        self.input_ranges: dict[str, tuple[float, float]] = assembly.input_ranges
        self.left_out = tuple(dict.fromkeys([*tree.left_out, *self._out_of_range()]))
        self._visuals = [tree.visuals, *(link.visuals for link in tree.links)]

    def __repr__(self) -> str:
        definition = self.definition
        parts = (
            counted(len(self._link_frames) - 1, "link"),
            counted(len(self.joints), "joint"),
            counted(len(definition.coordinates), "coordinate"),
            counted(len(definition.speeds), "speed"),
            counted(len(self.actuators), "actuator"),
            counted(len(definition.holonomic_constraints), "constraint"),
        )
        omissions = f"; left out: {few(self.left_out)}" if self.left_out else ""
        return f"<Robot '{self.name}': {', '.join(parts)}{omissions}>"

    def system(self, **options: Any) -> System:
        """Return a System of this robot, with the file's values, in the pose that it shows.

        Parameters
        ----------
        **options
            Arguments of `pydy.system.System`. What `constants` and `initial_conditions` name
            replaces the file's values.

        Examples
        --------
        >>> from importlib.resources import files
        >>> from pydy.robots import read
        >>> robot = read(files('pydy.examples') / 'pendulum.urdf')
        >>> system = robot.system(initial_conditions={'q_hinge': 1.0})
        >>> float(system.evaluate_ode()[1].round(6))
        -8.25483
        """
        constants, start = (
            check_mapping(name, options.pop(name, None))
            for name in ("constants", "initial_conditions")
        )
        # Constants that cancel in the equations of motion occur in energies, positions and outputs.
        options.setdefault("constants_symbols", list(self.values) or None)
        system = System(self.definition, **options)
        values = {s: v for s, v in self.values.items() if s in system.constants_symbols}
        system.constants = _replaced(values, constants)
        system.initial_conditions = _replaced(self.start, start)
        return system

    @property
    def limits(self) -> list[Event]:
        """Events that end a simulation where a joint or tendon reaches the end of its range.

        It must begin within the range: outside of it, a motion that goes further out reaches no
        end. Where the file's pose is outside, `left_out` says so.
        """
        events = []
        for kind, name, length, limits in self._ranges():
            prefix = "tendon " * (kind == "tendon")
            for value, direction, end in zip(limits, (-1, 1), ("lower", "upper"), strict=True):
                label = f"{prefix}{name} at its {end} limit"
                events.append(Event(length - value, direction=direction, terminal=True, name=label))
        return events

    def _ranges(self) -> Iterator[tuple[str, str, Expr, tuple[float, float]]]:
        """Yield the joints and tendons with limits: kind, name, coordinate or length, limits."""
        for name, joint in self.joints.items():
            if joint.limits is not None:
                yield "joint", name, joint.coordinates[0], joint.limits
        for name, tendon in self.tendons.items():
            if tendon.limits is not None:
                yield "tendon", name, tendon.length, tendon.limits

    def _out_of_range(self) -> list[str]:
        """Return a line for each joint or tendon that the file's pose has outside of its range."""
        lines = []
        for kind, name, length, (low, high) in self._ranges():
            place, rounding = self._in_pose(length), ROUNDED * (high - low)
            if not low - rounding <= place <= high + rounding:
                what = "position" if kind == "joint" else "length"
                lines.append(
                    f"the limits of the {kind} '{name}', {low:g} to {high:g}, until it is between "
                    f"them: in the file's pose its {what} is {place:g}"
                )
        return lines

    def _in_pose(self, length: Expr) -> float:
        """Return a coordinate, or a length that depends on some, in the file's pose."""
        pose = {q: self.start.get(q, 0.0) for q in length.atoms(AppliedUndef)}
        return float(length.subs({**self.values, **pose}))

    def scene(self, **options: Any) -> Scene:
        """Return a scene of the robot's shapes, to be animated with a trajectory.

        Parameters
        ----------
        **options
            Of `pydy.viz.Scene`.

        Returns
        -------
        pydy.viz.Scene
            Without visuals in the file: the default shapes of its bodies.

        Raises
        ------
        RobotFileError
            A mesh that a URDF file names cannot be read. Files of meshes are read here, not before.
        """
        import sympy as sm
        from sympy.physics.mechanics import ReferenceFrame

        from pydy.viz import Scene, Visual

        _, world = self._link_frames[0]
        visuals: list[Visual | Body] = []
        for (name, link_frame), looks in zip(self._link_frames, self._visuals, strict=True):
            for k, shape in enumerate(looks):
                frame, point = link_frame
                if (shape.rotation != [[1, 0, 0], [0, 1, 0], [0, 0, 1]]).any():
                    frame = ReferenceFrame(f"look {k} of {name}")
                    frame.orient_explicit(link_frame.frame, sm.Matrix(shape.rotation.tolist()))
                if shape.origin.any():
                    x, y, z = shape.origin.tolist()
                    axes = link_frame.frame
                    point = point.locatenew(
                        f"look {k} of {name}", x * axes.x + y * axes.y + z * axes.z
                    )
                visuals.append(Visual(shape.read(), frame, point, name=name))
        if not visuals:
            visuals = [body for body in self.definition.bodies if "armature of" not in body.name]
        options.setdefault("up", "z")
        return Scene(world.frame, world.point, *visuals, **options)


def _replaced(
    defaults: Mapping[AnySymbol, float], replacements: Mapping[SymbolOrName, float]
) -> dict[SymbolOrName, float]:
    """Return the defaults, updated with replacements, whose keys may be symbols or names."""
    replaced = {key for s in defaults for key in (s, s.name) if key in replacements}
    return {s: v for s, v in defaults.items() if not replaced & {s, s.name}} | dict(replacements)


def read(
    path: str | PathLike[str],
    *,
    parameters: str = "symbols",
    friction_speed: float | None = None,
    floating: bool = False,
) -> Robot:
    """Read a robot from a URDF or MJCF file.

    Joints, masses, inertias, damping, springs, armatures, gravity, actuators, fixed tendons, loops
    (MJCF's ``connect``, ``weld``, ``joint`` and ``tendon`` equalities) and joints that mimic others
    (URDF) become bodies, loads and constraints. Contacts, spatial tendons and sensors do not: other
    properties of a file are listed in `Robot.left_out`.

    Parameters
    ----------
    path : path
        A file with the suffix ``.urdf``; any other is read as MJCF by the ``mujoco`` package
        (``pip install 'pydy[robots]'``), which resolves defaults, includes and meshes.
    parameters : {'symbols', 'numbers'}
        Whether masses (``m_link``), mass centres (``cx_link``), inertias (``Ixx_link``), places of
        joints (``px_link``), damping and so on become constants of the system, with the file's
        values in `Robot.values`, or stay numbers, for shorter code.
    friction_speed : float, optional
        The speed (rad/s or m/s) at which dry friction f, acting as ``-f tanh(u / friction_speed)``,
        has three quarters of its size. Without it dry friction is left out.
    floating : bool
        Whether the root link of a URDF file moves freely, as that of a walking or flying robot,
        instead of resting in the world: by a joint named ``root``. MJCF files have a ``freejoint``
        for it.

    Returns
    -------
    Robot

    Raises
    ------
    RobotFileError
        The file cannot be read; the message has the file, the line or element, and what is wrong.
    FileNotFoundError

    Notes
    -----
    The coordinates of a joint are ``q_joint``, its speeds ``u_joint``; see `Robot.joints` for those
    with several. Armatures are particles and balls in the world that move as their joints do, and
    have the same kinetic energy.

    Examples
    --------
    >>> from importlib.resources import files
    >>> from pydy.robots import read
    >>> read(files('pydy.examples') / 'pendulum.urdf')
    <Robot 'pendulum': 2 links, 1 joint, 1 coordinate, 1 speed, 1 actuator, 0 constraints>
    """
    choice(parameters, ("symbols", "numbers"), "`parameters`")
    if friction_speed is not None:
        friction_speed = positive(friction_speed, "`friction_speed`", finite=True)
    file = path_of(path, "`path`")
    if not file.is_file():
        raise FileNotFoundError(f"`path` must be a file that exists, got '{path}'.")
    urdf = file.suffix.lower() == ".urdf"
    if flag(floating, "`floating`") and not urdf:
        raise ValueError(
            f"`floating` is for URDF files, got '{file.name}': in MJCF files, <freejoint/> in the "
            "robot's first body sets it free."
        )
    tree = read_urdf(file, floating) if urdf else read_mjcf(file)
    tree.check()
    if not any(link.joints for link in tree.links):
        remedy = " `floating=True` lets it move as a whole." if urdf else ""
        raise RobotFileError(f"{file}: the robot has no joint that moves.{remedy}")
    return Robot(tree, RobotAssembly(tree, parameters == "symbols", friction_speed))
