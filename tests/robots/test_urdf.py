"""Robots from URDF files: their accelerations, and what is wrong with a file."""

from importlib.resources import files

import numpy as np
import pytest
import sympy.physics.mechanics as me

from pydy.errors import PyDyUserWarning, RobotFileError
from pydy.robots import read
from robots.random_robots import random_tree, torques, urdf

BALL = '<sphere radius="1"/>'
PENDULUM = files("pydy.examples") / "pendulum.urdf"


@pytest.mark.parametrize("seed", range(6))
def test_random_trees_need_the_torques_of_newton_and_euler(tmp_path, seed):
    rng = np.random.default_rng(seed)
    links = random_tree(rng, 2 + seed)
    path = tmp_path / "robot.urdf"
    path.write_text(urdf(links))
    robot = read(path, parameters="symbols" if seed % 2 else "numbers")
    system = robot.system()
    x = rng.normal(size=len(system.states))
    places = {s: k for k, s in enumerate(system.states)}
    own = {int(n[1:]): (s.coordinates[0], s.speeds[0]) for n, s in robot.joints.items()}
    given = {k: float(rng.normal()) for k in own}
    system.specifieds = {robot.actuators[f"j{k}"]: force for k, force in given.items()}
    rates = system.evaluate_ode(x)
    q, v = ({k: x[places[pair[i]]] for k, pair in own.items()} for i in (0, 1))
    needed = torques(links, q, v, {k: rates[places[u]] for k, (_, u) in own.items()})
    size = max(abs(n) for n in torques(links, q, v, {}).values()) + 1.0
    assert [needed[k] for k in own] == pytest.approx([given[k] for k in own], abs=1e-11 * size)
    n = len(system.coordinates)
    found = system.inverse_dynamics(x[:n], x[n:], rates[n:], r=dict.fromkeys(system.specifieds, 0))
    speeds = [system.speeds.index(u) for _, u in own.values()]
    assert found[speeds] == pytest.approx([given[k] for k in own], abs=1e-11 * size)


def test_no_path_is_searched_through_the_robot_when_it_is_read(tmp_path, monkeypatch):
    # SymPy's searches take longer than in proportion to the number of connected points or frames.
    connected = []

    def counted(kind, method, neighbours):
        search = getattr(kind, method)

        def searched(self, other, number):
            connected.append(len(neighbours(self)))
            return search(self, other, number)

        monkeypatch.setattr(kind, method, searched)

    counted(me.Point, "_pdict_list", lambda point: point._pos_dict)
    counted(me.ReferenceFrame, "_dict_list", lambda frame: frame._dcm_dict)
    read_text(tmp_path, urdf(random_tree(np.random.default_rng(3), 8)))
    assert connected
    assert not any(connected)


@pytest.mark.parametrize("order", [("k", "l"), ("l", "k")])
def test_a_joint_may_mimic_one_that_mimics_another(tmp_path, order):
    first = link(), joint("prismatic")
    k = link(name="b"), joint("prismatic", down="b", name="k", more='<mimic joint="j"/>')
    last = '<mimic joint="k" multiplier="3"/>'
    parts = {"k": k, "l": (link(name="c"), joint("prismatic", down="c", name="l", more=last))}
    robot = read_text(tmp_path, robot_of(*parts[order[0]], *first, *parts[order[1]]))
    # Masses of 1 kg that move once, once and three times as far.
    assert robot.system(specifieds={"f_j": 22.0}).evaluate_ode()[1] == pytest.approx(2.0)


def test_links_are_known_by_their_names(tmp_path):
    path = tmp_path / "robot.urdf"
    path.write_text(urdf(random_tree(np.random.default_rng(4), 5)))
    robot = read(path)
    system = robot.system()
    q = np.random.default_rng(5).normal(size=len(system.coordinates))
    numbers = {**dict(zip(system.coordinates, q, strict=True)), **robot.values}
    world = robot.frames["world"]
    for name, (frame, point) in robot.frames.items():
        place = point.pos_from(world.point).to_matrix(world.frame).subs(numbers)
        turn = frame.dcm(world.frame).T.subs(numbers)
        assert system.frame_position(name, q) == pytest.approx(
            np.array(place, dtype=float)[:, 0], abs=1e-13
        )
        assert system.frame_rotation(name, q) == pytest.approx(
            np.array(turn, dtype=float), abs=1e-13
        )
        slopes = system.frame_position(name, q, wrt="coordinates")
        assert system.frame_jacobian(name, q)[:3] == pytest.approx(slopes, abs=1e-13)


def test_symbols_have_the_values_of_the_file(tmp_path):
    path = tmp_path / "robot.urdf"
    path.write_text(urdf(random_tree(np.random.default_rng(9), 4)))
    one, other = (read(path, parameters=p).system() for p in ("symbols", "numbers"))
    x = np.random.default_rng(1).normal(size=len(one.states))
    assert one.evaluate_ode(x) == pytest.approx(other.evaluate_ode(x), rel=1e-11)
    assert {s.name for s in one.constants_symbols} >= {"g", "m_l1"}
    assert not other.constants_symbols


LIFTED = """<robot name="lifted">
<link name="base"/>
<link name="arm"><inertial><origin xyz="0.5 0 0"/><mass value="2"/></inertial></link>
<link name="tool"/>
<joint name="shoulder" type="continuous"><parent link="base"/><child link="arm"/>
<origin xyz="0 0 3"/><axis xyz="0 1 0"/></joint>
<joint name="hand" type="fixed"><parent link="arm"/><child link="tool"/>
<origin xyz="0.7 0 0"/></joint>
</robot>"""


def test_places_that_cancel_from_the_equations_have_the_values_of_the_file(tmp_path):
    # The height of the shoulder moves nothing, and the tool has no mass.
    path = tmp_path / "robot.urdf"
    path.write_text(LIFTED)
    robot = read(path)
    system = robot.system(initial_conditions={"q_shoulder": -np.pi / 6})
    world = robot.frames["world"]
    height = robot.frames["tool"].point.pos_from(world.point).dot(world.frame.z)
    system.outputs = {"height": height}
    assert system.evaluate_outputs() == pytest.approx([3.35])
    assert system.evaluate_energy().potential == pytest.approx(2 * 9.81 * 3.25)
    assert system.frame_position("tool", [-np.pi / 6])[2] == pytest.approx(3.35)
    system.constants["pz_arm"] = 4.0
    assert system.evaluate_outputs() == pytest.approx([4.35])


MIMIC = """<robot name="gripper">
<link name="base"/>
<link name="one"><inertial><mass value="0.3"/></inertial></link>
<link name="two"><inertial><mass value="0.2"/></inertial></link>
<joint name="left" type="prismatic"><parent link="base"/><child link="one"/><axis xyz="0 0 1"/>
<dynamics friction="0.5"/></joint>
<joint name="right" type="prismatic"><parent link="base"/><child link="two"/><axis xyz="0 0 1"/>
<mimic joint="left" multiplier="-2" offset="0.1"/></joint>
</robot>"""


def test_joints_that_mimic_others_move_with_them(tmp_path):
    (tmp_path / "gripper.urdf").write_text(MIMIC)
    robot = read(tmp_path / "gripper.urdf", parameters="numbers")
    system = robot.system()
    assert [str(s) for s in system.states] == ["q_left(t)", "u_left(t)"]
    # The one's mass and four times the other's, whose weight acts twice and upwards.
    system.specifieds = {robot.actuators["left"]: 1.0}
    expected = (1.0 - 9.81 * (0.3 - 2 * 0.2)) / (0.3 + 4 * 0.2)
    assert system.evaluate_ode([0.2, 0.3])[1] == pytest.approx(expected, rel=1e-14)
    frame, origin = robot.frames["world"]
    height = robot.frames["two"].point.pos_from(origin).dot(frame.z)
    assert height == 0.1 - 2 * robot.joints["left"].coordinates[0]


DRIVEN = """<robot name="gripper"><link name="base"/><link name="one"/>
<link name="two"><inertial><mass value="{mass}"/></inertial></link>
<joint name="left" type="prismatic"><parent link="base"/><child link="one"/><axis xyz="0 1 0"/>
<dynamics damping="0.2"/></joint>
<joint name="right" type="prismatic"><parent link="base"/><child link="two"/><axis xyz="0 -1 0"/>
<mimic joint="left" multiplier="{ratio}"/><dynamics damping="0.3"/></joint>
</robot>"""


def test_a_joint_may_move_the_mass_of_those_that_mimic_it_alone(tmp_path):
    system = read_text(tmp_path, DRIVEN.format(mass=0.1, ratio=2)).system(specifieds={"f_left": 1})
    expected = (1.0 - (0.2 + 2**2 * 0.3) * 0.5) / (2**2 * 0.1)
    assert system.evaluate_ode([0.01, 0.5])[1] == pytest.approx(expected, rel=1e-14)


@pytest.mark.parametrize(("mass", "ratio"), [(0, 2), (0.1, 0)])
def test_a_joint_is_refused_if_those_that_mimic_it_move_no_mass_either(tmp_path, mass, ratio):
    with pytest.raises(
        RobotFileError, match=r"joint 'left' moves has mass.* or one whose joint mim"
    ):
        read_text(tmp_path, DRIVEN.format(mass=mass, ratio=ratio))


def test_a_ball_joint_is_read_with_a_warning(tmp_path):
    spherical = joint("spherical", more='<dynamics damping="0.5"/><limit effort="1"/>')
    with pytest.warns(PyDyUserWarning, match="'j' .*urdf:4.* 'spherical', which the URDF format"):
        robot = read_text(tmp_path, robot_of(link(), spherical))
    assert robot.left_out == ("the <limit> of the spherical joint 'j'",)
    # Euler's equations of a body with equal moments of inertia, 1 kg m²: damping alone.
    spin = {"u_j_wx": 0.1, "u_j_wy": 0.2, "u_j_wz": 0.3}
    system = robot.system(initial_conditions=spin)
    rates = dict(zip([s.name for s in system.states], system.evaluate_ode(), strict=True))
    assert [rates[u] for u in spin] == pytest.approx([-0.05, -0.1, -0.15], rel=1e-14)
    assert [rates[f"q_j_e{k}"] for k in range(4)] == pytest.approx([0, 0.05, 0.1, 0.15], rel=1e-14)


@pytest.mark.parametrize(
    "changed",
    [
        lambda text: b"\r\n\n" + text,
        lambda text: b"\xef\xbb\xbf\n" + text,
        lambda text: b"<!-- made by hand -->\n" + text,
        lambda text: text + b"\r\n\0",
        lambda text: text + b"\0\0\n",
        lambda text: text.decode().encode("utf-16"),
        lambda text: text.replace(
            b'<axis xyz="0 1 0"/>', b'<axis xyz="0 1 0"/><axis xyz="0 1  0"/>'
        ),
    ],
)
def test_a_file_may_be_as_other_readers_of_urdf_take_it(tmp_path, changed):
    text = b'<?xml version="1.0"?>\n' + DRIVEN.format(mass=0.1, ratio=2).encode()
    path = tmp_path / "robot.urdf"
    path.write_bytes(changed(text))
    assert list(read(path).joints) == ["left", "right"]


def test_a_declaration_that_is_not_first_still_names_the_encoding(tmp_path):
    text = '\n<?xml version="1.0" encoding="latin-1"?>' + robot_of(link(), joint(name="é"))
    (tmp_path / "robot.urdf").write_bytes(text.encode("latin-1"))
    assert list(read(tmp_path / "robot.urdf").joints) == ["é"]


def test_a_wrong_scale_or_colour_stops_no_mechanics(tmp_path):
    (tmp_path / "m.stl").touch()
    shapes = "<mesh filename='m.stl' scale='1 1 1 1'/>"
    material = "</geometry><material><color rgba='1 0 0'/></material>"
    red = link(looks=BALL, name="b").replace("</geometry>", material)
    parts = link(looks=shapes), joint(), red, joint(name="k", up="a", down="b")
    robot = read_text(tmp_path, robot_of(*parts))
    path = tmp_path / "robot.urdf"
    assert robot.left_out == (
        f"the mesh m.stl: {path}:3: 'scale' of <mesh> must be 3 finite numbers, got '1 1 1 1'.",
        f"a colour: {path}:5: 'rgba' of <color> must be 4 finite numbers, got '1 0 0'.",
    )


def test_dry_friction_is_smooth_or_left_out(tmp_path):
    (tmp_path / "gripper.urdf").write_text(MIMIC)
    robot = read(tmp_path / "gripper.urdf")
    assert "dry friction of the joint 'left'" in robot.left_out[0]
    rough = read(tmp_path / "gripper.urdf", friction_speed=0.01)
    assert not rough.left_out
    less = robot.system().evaluate_ode([0, 1])[1] - rough.system().evaluate_ode([0, 1])[1]
    assert less == pytest.approx(0.5 / (0.3 + 4 * 0.2), rel=1e-14)


def test_a_floating_base_falls_from_where_the_file_has_it(tmp_path):
    text = urdf(random_tree(np.random.default_rng(2), 1)).replace("revolute", "floating")
    (tmp_path / "robot.urdf").write_text(text)
    robot = read(tmp_path / "robot.urdf")
    system = robot.system()
    start = [robot.start[q] for q in robot.joints["j0"].coordinates]
    assert np.linalg.norm(start[3:]) == pytest.approx(1.0, rel=1e-15)
    with pytest.warns(PyDyUserWarning, match="do not satisfy the constraints"):
        robot.system(initial_conditions={"q_j0_e1": 2.0}, times=[0.0, 1e-3]).integrate()
    frame, origin = robot.frames["world"]
    place = robot.frames["l0"].point.pos_from(origin)
    assert start[:3] == [float(place.dot(e).subs(robot.start)) for e in frame]
    # The mass centre falls freely, whatever the spin.
    centre = next(b.masscenter for b in robot.definition.bodies if b.name == "l0")
    height = centre.pos_from(origin).dot(frame.z)
    system.outputs = {"height": height}
    system.initial_conditions = {**system.initial_conditions, "u_j0_wx": 1.0, "u_j0_wz": -2.0}
    system.times, system.ode_solver = np.linspace(0.0, 1.0, 5), "vern9"
    motion = system.simulate(rtol=1e-12, atol=1e-12)
    rise = np.polyfit(motion.times, motion["height"], 2)
    assert rise[0] == pytest.approx(-9.81 / 2, rel=1e-9)


def test_the_root_floats_as_by_a_joint_of_the_file(tmp_path):
    trunk = (
        '<link name="world"><inertial><origin xyz="0.1 0 0.2"/><mass value="2"/>'
        '<inertia ixx="1" iyy="1.5" izz="2"/></inertial></link>'
    )
    text = urdf(random_tree(np.random.default_rng(4), 2)).replace('<link name="world"/>', trunk)
    (tmp_path / "free.urdf").write_text(text)
    joint = (
        '<link name="ground"/><joint name="root" type="floating"><parent link="ground"/>'
        '<child link="world"/></joint></robot>'
    )
    (tmp_path / "joint.urdf").write_text(text.replace("</robot>", joint))
    rates = []
    for name, floating in (("free", True), ("joint", False)):
        robot = read(tmp_path / f"{name}.urdf", floating=floating)
        where = [robot.start[q] for q in robot.joints["root"].coordinates]
        assert where == [0, 0, 0, 1, 0, 0, 0]
        system = robot.system()
        rng = np.random.default_rng(0)
        start = {x.name: rng.uniform(-1, 1) for x in sorted(system.states, key=str)}
        turn = [f"q_root_e{k}" for k in range(4)]
        size = np.linalg.norm([start[e] for e in turn])
        start.update((e, start[e] / size) for e in turn)
        found = system.evaluate_ode([start[x.name] for x in system.states])
        rates.append({x.name: rate for x, rate in zip(system.states, found, strict=True)})
    assert rates[0] == pytest.approx(rates[1], rel=1e-12, abs=1e-12)
    # A root that hangs on nothing and has no joint is one free body.
    alone = f'<robot name="r">{link()}</robot>'
    (tmp_path / "alone.urdf").write_text(alone)
    with pytest.raises(RobotFileError, match="`floating=True` lets it move"):
        read(tmp_path / "alone.urdf")
    system = read(tmp_path / "alone.urdf", floating=True).system()
    accelerations = dict(zip(system.states, system.evaluate_ode(), strict=True))
    assert [accelerations[u] for u in system.speeds] == pytest.approx([0, 0, -9.81, 0, 0, 0])


def test_limits_end_a_simulation():
    robot = read(PENDULUM)
    system = robot.system(ode_solver="dop853", times=np.linspace(0, 5, 11))
    system.initial_conditions = {"u_hinge": 7.0}
    motion = system.simulate(events=robot.limits)
    assert motion.events[-1].name == "hinge at its upper limit"
    assert motion.events[-1].before[0] == pytest.approx(3.0, abs=1e-12)


def test_what_it_looks_like_moves():
    robot = read(PENDULUM)
    system = robot.system(ode_solver="dop853", times=np.linspace(0, 1, 61))
    system.initial_conditions = {"q_hinge": 1.0}
    motion = system.simulate()
    scene = robot.scene().animate(motion, fps=None)
    angle = motion["q_hinge"]
    middle = np.stack([-0.5 * np.sin(angle), 0 * angle, -0.5 * np.cos(angle)], 1)
    assert scene.poses[:, 0, :3, 3] == pytest.approx(middle, abs=1e-6)


def robot_of(*parts):
    return "\n".join(['<robot name="r">', '<link name="base"/>', *parts, "</robot>"])


def link(mass=1, looks="", name="a"):
    shown = f"<visual><geometry>{looks}</geometry></visual>" if looks else ""
    inertia = '<inertia ixx="1" iyy="1" izz="1"/>'
    about = f'<inertial><mass value="{mass}"/>{inertia if mass == 1 else ""}</inertial>'
    return f'<link name="{name}">{about}{shown}</link>'


def joint(kind="revolute", up="base", down="a", more="", name="j"):
    ends = f'<parent link="{up}"/><child link="{down}"/>'
    return f'<joint name="{name}" type="{kind}">{ends}{more}</joint>'


@pytest.mark.parametrize(
    ("text", "line", "said"),
    [
        ("<robot", 1, "not well-formed XML"),
        ("<model/>", 1, "must be <robot>, got <model>"),
        ("<robot/>", 1, "holds no <link>"),
        (robot_of(link()), 3, "more than one root: .*'base' or 'a'"),
        (robot_of(link(-1), joint()), 3, "mass of the link 'a' .*not negative, got -1"),
        (robot_of(link("x"), joint()), 3, "must be a finite number, got 'x'"),
        (robot_of(link("1e999"), joint()), 3, "must be a finite number"),
        (robot_of(link(0), joint()), 4, "nothing that the joint 'j' moves has mass"),
        (robot_of(link(), joint("helical")), 4, "of the type 'helical'; known are 'fixed'"),
        (robot_of(link(), joint(down="b")), 4, "no link 'b', which the joint 'j' has as its child"),
        (robot_of(link(), joint(up="a")), 4, "'a' form a ring that hangs on nothing"),
        (robot_of(link(), joint(), joint(name="k")), 5, "the child of two joints, 'j' and 'k'"),
        (robot_of(link(), joint(), joint()), 5, "more than one joint 'j'"),
        (robot_of(link(), joint(more='<mimic joint="z"/>')), 4, "mimics 'z', which is no"),
        (robot_of(link(), joint(more='<axis xyz="0 0 0"/>')), 4, "the axis .* has no direction"),
        (robot_of(link(), joint(more='<axis xyz="1 0"/>')), 4, "must be 3 finite numbers"),
        (robot_of(link(), joint("fixed")), None, "no joint that moves"),
        (robot_of(link("1_0"), joint()), 3, "must be a finite number, got '1_0'"),
        (robot_of(link("٣"), joint()), 3, "must be a finite number"),
        ("<robot>\n<xacro:arm/></robot>", 2, "<xacro:arm> is a macro. Expand them first"),
        ('<?xml version="1.0" encoding="gbk"?><robot/>', 1, "encoding .* UTF-8"),
        ('<?xml version="1.0" encoding="klingon"?><robot/>', 1, "klingon. Save it as UTF-8"),
        (robot_of(link(), joint(more='<limit effort="-1"/>')), 4, "effort .* not be negative"),
        (robot_of(link(), joint(more='<dynamics damping="-1"/>')), 4, "damping .* 'j' .* got -1"),
        (robot_of(link(), joint(more='<dynamics friction="-1"/>')), 4, "friction .* 'j' .* got -1"),
        (robot_of(link(looks="<sphere radius='-1'/>"), joint()), 3, "`radius` of Sphere must be"),
        (robot_of(link(), joint(more="<axis xyz='1 0 0'/>\n<axis/>")), 5, "more than one <axis>"),
        (robot_of(link(), joint(more='<parent link="a"/>')), 4, "more than one <parent>.* differ"),
        (
            robot_of(link().replace('ixx="1"', 'ixx="1e-999999999"'), joint()),
            3,
            "'ixx' of <inertia> has the number 1e-999999999, which is smaller than .* Write 0",
        ),
        ("\n<?xml version='1.0'?>\n<robot>\n<a></robot>", 4, "not well-formed XML: mismatched tag"),
        ("<robot>\n<?xml version='1.0'?>\n</robot>", 2, "declaration not at start"),
        (
            robot_of(link().replace("</link>", "\n<inertial/></link>"), joint()),
            4,
            "more than one <inertial>",
        ),
        (robot_of(link(looks=f"<mesh filename='{'x' * 300}.obj'/>"), joint()), 3, "too long"),
    ],
)
def test_what_is_wrong_with_a_file_is_said_with_its_line(tmp_path, text, line, said):
    path = tmp_path / "bad.urdf"
    path.write_text(text, encoding="utf-8")
    with pytest.raises(RobotFileError, match=said) as raised:
        read(path)
    assert str(raised.value).startswith(f"{path}:{line}:" if line else str(path))


def point_mass(moment):
    """A link whose mass centre is off its origin: its moment of inertia there may be rounding."""
    return (
        '<link name="a"><inertial><mass value="0.526"/><origin xyz="0 0 0.03045"/>'
        f'<inertia ixx="{moment}" ixy="0" ixz="0" iyy="{moment}" iyz="0" izz="0"/></inertial>'
        "</link>"
    )


def test_meshes_are_read_when_they_are_shown(tmp_path):
    (tmp_path / "bad.obj").write_text("v 1 2")
    path = tmp_path / "r.urdf"
    path.write_text(robot_of(link(looks="<mesh filename='bad.obj'/>"), joint()))
    robot = read(path)
    for _ in range(2):
        with pytest.raises(RobotFileError, match=r"r\.urdf:3: .*not a valid OBJ file"):
            robot.scene()
    (tmp_path / "bad.obj").write_text("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3")
    first, second = (robot.scene().visuals[0].shape for _ in range(2))
    assert first.vertices.shape == (3, 3)
    assert first is second


def test_a_moment_of_inertia_may_be_negative_by_rounding(tmp_path):
    hinge = joint(more='<axis xyz="1 0 0"/>')
    robot = read_text(tmp_path, robot_of(point_mass("-5.42101e-20"), hinge))
    assert not any(str(symbol).startswith("I") for symbol in robot.values)
    with pytest.raises(RobotFileError, match=r"moments of inertia .* 'a' .*, not negative"):
        read_text(tmp_path, robot_of(point_mass("-5.42101e-18"), hinge))


def read_text(tmp_path, text):
    path = tmp_path / "robot.urdf"
    path.write_text(text)
    return read(path)


def test_a_link_may_be_called_world(tmp_path):
    hinge = joint(up="world")
    robot = read_text(tmp_path, f'<robot><link name="world"/>{link(looks=BALL)}{hinge}</robot>')
    assert "<Robot 'robot': 2 links" in repr(robot)
    assert robot.frames["world"].point.pos_from(robot.frames["a"].point) == 0
    assert [visual.name for visual in robot.scene().visuals] == ["a"]


def test_a_planar_joint_stands_beside_joints_of_the_names_of_its_parts(tmp_path):
    parts = link(), joint("planar", name="p"), link(name="b"), joint(up="a", down="b", name="p_x")
    assert set(read_text(tmp_path, robot_of(*parts)).joints) == {"p_x_2", "p_y", "p_turn", "p_x"}


def test_what_cannot_be_taken_over_is_listed(tmp_path):
    limits = '<limit lower="1" upper="-1"/>'
    robot = read_text(tmp_path, robot_of(link(looks="<cone/>"), joint(more=limits)))
    assert robot.left_out == (
        "the limits of the joint 'j', the lower of which is the upper",
        "the shape <cone>, which is not shown",
    )


def test_a_pose_outside_of_a_range_is_listed(tmp_path):
    # The second follows the first, which is at 0: −2·0 + 1.
    limits = '<limit lower="-3.1" upper="-0.1"/>'
    follower = '<mimic joint="j" multiplier="-2" offset="1"/><limit lower="0" upper="0.5"/>'
    robot = read_text(
        tmp_path,
        robot_of(
            link(), joint(more=limits), link(name="b"), joint(down="b", name="k", more=follower)
        ),
    )
    assert robot.left_out == (
        "the limits of the joint 'j', -3.1 to -0.1, until it is between them: in the file's pose "
        "its position is 0",
        "the limits of the joint 'k', 0 to 0.5, until it is between them: in the file's pose its "
        "position is 1",
    )
    at_its_end = '<limit lower="0" upper="1"/>'
    assert not read_text(tmp_path, robot_of(link(), joint(more=at_its_end))).left_out


def test_what_is_odd_is_listed_with_its_line(tmp_path):
    """Files that are in use hold such inertias."""
    odd = link(looks="<mesh filename='gone.stl'/>").replace('izz="1"', 'izz="1" ixy="5"')
    more = '<limit lower="1" upper="1"/>'
    moved = joint("planar", more=f"{more}<dynamics damping='1'/>", name="p", down="b")
    with pytest.warns(PyDyUserWarning, match="'a' has a negative principal moment, -4: no body"):
        robot = read_text(tmp_path, robot_of(odd, joint(more=more), link(name="b"), moved))
    path = tmp_path / "robot.urdf"
    assert set(robot.left_out) == {
        f"the mesh gone.stl, which is not found ({path}:3)",
        "the limits of the joint 'j', which are equal, 1",
        "the <limit> of the planar joint 'p'",
        "the <dynamics> of the planar joint 'p'",
        "the inertia of the link 'a' has a negative principal moment, -4: no body has it; it is "
        f"taken as it is ({path}:3)",
    }


def test_extensions_of_the_format_are_listed(tmp_path):
    """Springs of Drake and Gazebo, dampers of Bullet, and loops would be missed without a word."""
    more = '<dynamics damping="1" K="7000" friction="0"/><joint_properties damping="2"/>'
    contact = '</inertial><contact><stiffness value="1"/></contact>'
    parts = link().replace("</inertial>", contact), joint(more=more)
    spring = '<force_element name="s"><torsional_spring stiffness="9"/></force_element>'
    looks = '<gazebo reference="a"><material>Red</material><mu1>1</mu1></gazebo>'
    weight = "<gazebo><turnGravityOff>false</turnGravityOff><gravity>1</gravity></gazebo>"
    robot = read_text(tmp_path, robot_of(*parts, looks, weight, joint(name="k", up="a", down="b"),
                                         link(name="b"), "<gazebo/>", spring))  # fmt: skip
    assert robot.left_out == (
        "<force_element> in <robot>, which the URDF format does not have",
        "<contact> in <link>, which the URDF format does not have",
        "<joint_properties> in <joint>, which the URDF format does not have",
        "'K' of <dynamics>, which the URDF format does not have",
    )
    floating = "<gazebo reference='a'><turnGravityOff>true</turnGravityOff></gazebo>"
    loop = "<gazebo><joint name='c'/><gravity>0</gravity></gazebo>"
    robot = read_text(tmp_path, robot_of(link(), joint(), floating, loop))
    assert robot.left_out == ("<turnGravityOff>, <joint>, <gravity> in <gazebo>",)
    ball = '<drake:joint name="d" type="ball"><parent link="a"/><child link="b"/></drake:joint>'
    with pytest.raises(RobotFileError, match=r"6: <drake:joint> is an extension of the URDF"):
        read_text(tmp_path, robot_of(link(), joint(), link(name="b"), ball))


def test_marks_without_size_are_left_out(tmp_path):
    marks = '<sphere radius="0"/>', '<box size="1 0 1"/>', '<cylinder length="0" radius="1"/>'
    for mark in marks:
        robot = read_text(tmp_path, robot_of(link(looks=mark), joint()))
        kind = mark[1:].split()[0]
        assert robot.left_out == (f"a <{kind}> without size, which is not shown",)
    with pytest.raises(RobotFileError, match=r"`radius` of Sphere must be a positive number"):
        read_text(tmp_path, robot_of(link(looks='<sphere radius="-1"/>'), joint()))


@pytest.mark.parametrize("size", ["1e-200", "1e200"])
def test_an_axis_may_have_any_length(tmp_path, size):
    parts = link(), joint(more=f'<axis xyz="0 {size} 0"/>')
    rates = read_text(tmp_path, robot_of(*parts)).system(specifieds={"f_j": 2.0}).evaluate_ode()
    assert rates.tolist() == [0.0, 2.0]


def test_arguments_are_checked():
    with pytest.raises(FileNotFoundError, match=r"file that exists, got 'nowhere\.urdf'"):
        read("nowhere.urdf")
    with pytest.raises(ValueError, match="`parameters`"):
        read(PENDULUM, parameters="some")
    with pytest.raises(ValueError, match="`friction_speed` must be positive"):
        read(PENDULUM, friction_speed=0.0)
    with pytest.raises(TypeError, match="`floating` must be True or False, got 'base'"):
        read(PENDULUM, floating="base")
    with pytest.raises(ValueError, match=r"`floating` is for URDF files, got 'test_urdf\.py'"):
        read(__file__, floating=True)


PLATE = """<robot name="r"><link name="w"/><link name="plate"><inertial><mass value="1"/>
<inertia ixx="0.0417" iyy="0.0417" izz="{}"/></inertial></link>
<joint name="j" type="revolute"><parent link="w"/><child link="plate"/><axis xyz="0 0 1"/></joint>
</robot>"""


@pytest.mark.parametrize("izz", ["0.0834", "0.0835", "0.083", "8.34e-2"])
def test_an_inertia_that_a_body_may_have_to_its_digits_is_no_warning(tmp_path, izz):
    (tmp_path / "r.urdf").write_text(PLATE.format(izz))
    read(tmp_path / "r.urdf")


def test_an_inertia_that_no_body_has_is_warned_of_once(tmp_path):
    (tmp_path / "r.urdf").write_text(PLATE.format("0.0900"))
    with pytest.warns(PyDyUserWarning, match=r"link 'plate' \(.*r.urdf:2; 0.09 > 0.0417") as told:
        read(tmp_path / "r.urdf")
    assert len(told) == 1
