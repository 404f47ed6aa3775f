"""Robots from MJCF files, against MuJoCo's own accelerations."""

import numpy as np
import pytest

from optional import optional
from pydy.errors import PyDyUserWarning, RobotFileError
from pydy.robots import read

mujoco = optional("mujoco")


def off():
    """Flags of MuJoCo that leave out contacts and equalities."""
    return mujoco.mjtDisableBit.mjDSBL_CONTACT | mujoco.mjtDisableBit.mjDSBL_EQUALITY


BRANCHED = """<mujoco>
<compiler angle="radian"/>
<option gravity="0.3 -0.2 -9.81"/>
<default><geom density="700"/><joint damping="0.2"/></default>
<worldbody>
<body name="trunk" pos="0 0 1" quat="0.8 0.1 0.5 0.3"><freejoint name="base"/>
  <geom type="box" size="0.2 0.1 0.3" pos="0.05 0.02 0"/>
  <body name="arm" pos="0.2 0 0.3" euler="1.5707963 0 0.3">
    <joint name="swing" axis="1 2 3" pos="0.1 0 0.05" armature="0.05" ref="0.2"/>
    <joint name="reach" type="slide" axis="0 0.6 0.8" stiffness="5" springref="0.1"/>
    <geom type="capsule" size="0.03" fromto="0 0 0 0.3 0.1 0.4"/>
    <body name="hand" pos="0.3 0.1 0.4" gravcomp="0.4">
      <joint name="wrist" type="ball" pos="0.02 0 -0.1" damping="0.1" armature="0.01"/>
      <geom type="cylinder" size="0.05 0.2" euler="0.2 0.3 0"/>
      <geom type="sphere" size="0.04" pos="0 0 0.3"/>
    </body>
  </body>
  <body name="leg" pos="0 0.1 -0.3" gravcomp="1">
    <joint name="hip x" axis="1 0 0" armature="0.1"/><joint name="hip y" axis="0 1 0"/>
    <geom type="ellipsoid" size="0.05 0.06 0.2" pos="0 0 -0.2"/>
  </body>
</body>
<body name="beam" euler="0 0.4 0"><joint name="hinge" axis="0 1 0" stiffness="3" ref="0.3"/>
  <geom type="box" size="0.2 0.1 0.3" pos="0.5 0.02 0"/></body>
</worldbody>
<actuator>
<motor name="push" joint="reach" gear="2"/><position name="servo" joint="hip x" kp="20" kv="3"/>
<general name="odd" joint="hinge" gear="-1.5" gainprm="3" biastype="affine" biasprm="1 -2 -0.3"/>
</actuator>
</mujoco>"""


def written(tmp_path, text):
    path = tmp_path / "robot.xml"
    path.write_text(text)
    return path


def order_of(robot, model):
    """Coordinates and speeds in MuJoCo's order."""
    names = [mujoco.mj_id2name(model, mujoco.mjtObj.mjOBJ_JOINT, j) for j in range(model.njnt)]
    return [[s for n in names for s in robot.joints[n][k]] for k in (0, 1)]


def state(rng, model, data):
    q = model.qpos0 + 0.5 * rng.normal(size=model.nq)
    mujoco.mj_normalizeQuat(model, q)
    data.qpos[:], data.qvel[:] = q, rng.normal(size=model.nv)
    data.ctrl[:] = rng.normal(size=model.nu)


def test_quaternions_change_as_products_with_angular_velocities(tmp_path):
    """q' = ½ q ⊗ (0, ω), with ω along the axes of the body."""
    body = '<body name="b"><freejoint name="base"/><geom size="0.1"/></body>'
    robot = read(written(tmp_path, f"<mujoco><worldbody>{body}</worldbody></mujoco>"))
    system = robot.system()
    coordinates, speeds = robot.joints["base"].coordinates, robot.joints["base"].speeds
    rng = np.random.default_rng(1)
    e, w, place, velocity = rng.normal(size=4), *rng.normal(size=(3, 3))
    e /= np.linalg.norm(e)
    values = [*place, *e, *velocity, *w]
    x = dict(zip((*coordinates, *speeds), values, strict=True))
    rates = system.evaluate_ode(x=np.array([x[s] for s in system.states]))
    found = dict(zip(system.states, rates, strict=True))
    vector = e[0] * w + np.cross(e[1:], w)
    expected = [*velocity, -e[1:] @ w / 2, *(vector / 2)]
    np.testing.assert_allclose([found[q] for q in coordinates], expected, atol=1e-14)


@pytest.mark.parametrize("parameters", ["symbols", "numbers"])
def test_accelerations_are_those_of_mujoco(tmp_path, parameters):
    path = written(tmp_path, BRANCHED)
    model = mujoco.MjModel.from_xml_path(str(path))
    model.opt.disableflags |= off()
    data = mujoco.MjData(model)
    robot = read(path, parameters=parameters)
    assert robot.left_out == ("the look of a geom of the kind 'ellipsoid'", "contacts")
    system = robot.system()
    coordinates, speeds = order_of(robot, model)
    rng = np.random.default_rng(4)
    for _ in range(3):
        state(rng, model, data)
        mujoco.mj_forward(model, data)
        values = [*data.qpos, *data.qvel]
        system.initial_conditions = dict(zip([*coordinates, *speeds], values, strict=True))
        inputs = (robot.actuators[name] for name in ("push", "servo", "odd"))
        system.specifieds = dict(zip(inputs, data.ctrl, strict=True))
        rates = dict(zip(system.states, system.evaluate_ode(), strict=True))
        size = abs(data.qacc).max()
        assert [rates[u] for u in speeds] == pytest.approx(data.qacc, abs=1e-11 * size)


SPRUNG = """<mujoco>
<compiler angle="radian"/>
<option gravity="0.3 -0.2 -9.81"><flag energy="enable" contact="disable"/></option>
<worldbody>
<body name="crane" quat="0.8 0.1 0.5 0.3"><joint name="turn" axis="1 2 3" stiffness="4" ref=".2"/>
  <geom type="box" size="0.2 0.1 0.3" pos="0.05 0.02 0"/>
  <body name="jib" pos="0.1 0 0.3" quat="0.5 -0.4 0.2 0.7">
    <joint name="lift" axis="0.3 0 1" pos="0.1 0.2 0" stiffness="3" springref="0.5"/>
    <joint name="reach" type="slide" axis="3 -1 2" stiffness="5" springref="0.1"/>
    <geom type="capsule" size="0.03" fromto="0 0 0 0.3 0.1 0.4"/>
    <body name="hook" pos="0.2 0 0.4"><joint name="drop" type="slide" axis="1 -0.2 0.7"/>
      <geom size="0.1"/></body>
  </body>
</body></worldbody>
<tendon><fixed name="rope" stiffness="30" springlength="-0.3 0.4">
  <joint joint="lift" coef="0.3"/><joint joint="drop" coef="-1.7"/></fixed></tendon>
<actuator><position name="servo" joint="drop" kp="20" gear="0.7"/>
<general name="odd" tendon="rope" gear="-1.5" gainprm="3" biastype="affine" biasprm="1 -2 0"/>
</actuator></mujoco>"""


@pytest.mark.parametrize("parameters", ["symbols", "numbers"])
def test_the_energy_of_springs_along_oblique_axes_is_that_of_mujoco(tmp_path, parameters):
    """MuJoCo's energy, and that of the actuators: ½ 20 l² and ½ 2 l² - l, by their lengths l."""
    path = written(tmp_path, SPRUNG)
    model = mujoco.MjModel.from_xml_path(str(path))
    data, robot = mujoco.MjData(model), read(path, parameters=parameters)
    system, rng, differences = robot.system(), np.random.default_rng(3), []
    coordinates, speeds = order_of(robot, model)
    for _ in range(4):
        state(rng, model, data)
        mujoco.mj_forward(model, data)
        servo, odd = data.actuator_length
        expected = [data.energy[1], data.energy[0] + 10.0 * servo**2 + odd**2 - odd]
        x = dict(zip([*coordinates, *speeds], [*data.qpos, *data.qvel], strict=True))
        energies = system.evaluate_energy([x[s] for s in system.states])
        differences.append([energies.kinetic - expected[0], energies.potential - expected[1]])
    assert np.ptp(differences, axis=0) == pytest.approx(0.0, abs=1e-12 * max(expected))
    assert differences[0][0] == pytest.approx(0.0, abs=1e-13 * expected[0])


ROTORS = """<mujoco>
<default><geom density="700"/><joint armature="0.3"/></default>
<worldbody><body name="cart"><joint name="rail" type="slide" axis="0.6 0 0.8"/>
<geom type="box" size="0.2 0.1 0.3" pos="0.05 0.02 0"/>
<body name="pole" pos="0 0.1 0.2"><joint name="hinge" axis="1 2 0"/>
<geom type="capsule" size="0.03" fromto="0 0 0 0.3 0.1 0.4"/></body></body>
<body name="buoy" pos="3 0 0"><joint name="sea" type="free"/>
<geom size="0.1" pos="0 0.1 0.2"/></body>
</worldbody></mujoco>"""


def test_armatures_have_no_part_in_gravity(tmp_path):
    path = written(tmp_path, ROTORS)
    model = mujoco.MjModel.from_xml_path(str(path))
    model.opt.disableflags |= off()
    data, robot, rng = mujoco.MjData(model), read(path), np.random.default_rng(2)
    system = robot.system()
    coordinates, speeds = order_of(robot, model)
    state(rng, model, data)
    data.qvel[:] = 0.0
    mujoco.mj_forward(model, data)
    values = dict(zip([*coordinates, *speeds], [*data.qpos, *data.qvel], strict=True))
    q, v = ({s: values[s] for s in symbols} for symbols in (coordinates, speeds))
    forces = dict(zip(system.speeds, system.gravity(q), strict=True))
    size = abs(data.qfrc_bias).max()
    assert [forces[u] for u in speeds] == pytest.approx(data.qfrc_bias, abs=1e-13 * size)

    a = rng.normal(size=len(speeds))
    columns = system.regressor(q, v, a)
    found = columns @ list(system.inertial_parameters().values())
    assert found == pytest.approx(system.inverse_dynamics(q, v, a), abs=1e-13 * size)
    free = len([name for name in system.inertial_parameters() if "armature of sea" in name])
    assert free == 3 + 10  # along x, y and z, and turning


def test_the_start_is_the_pose_of_the_file(tmp_path):
    path = written(tmp_path, BRANCHED)
    model = mujoco.MjModel.from_xml_path(str(path))
    robot = read(path)
    coordinates, _ = order_of(robot, model)
    assert [robot.start[q] for q in coordinates] == pytest.approx(model.qpos0)


LOOPS = """<mujoco>
<compiler angle="radian"/>
<default><geom type="capsule" size="0.02"/></default>
<worldbody>
<body name="crank" pos="0 0 0"><joint name="a" axis="0 1 0"/><geom fromto="0 0 0 0 0 0.3"/>
  <body name="coupler" pos="0 0 0.3"><joint name="b" axis="0 1 0"/><geom fromto="0 0 0 1 0 0.2"/>
  </body></body>
<body name="rocker" pos="1 0 0"><joint name="c" axis="0 1 0"/><geom fromto="0 0 0 0 0 0.5"/></body>
<body name="wheel" pos="0 0.5 0"><joint name="d" axis="0 1 0" ref="0.1"/>
  <geom type="cylinder" size="0.1 0.02" euler="1.57 0 0" pos="0.01 0 0"/></body>
<body name="plate" pos="0 0 0.5"><joint name="e" axis="0 1 0"/>
  <geom fromto="0 0 0 0.2 0.1 0.3"/></body>
</worldbody>
<equality>
{}
</equality>
</mujoco>"""
TIES = {
    "connect": '<connect body1="coupler" body2="rocker" anchor="1 0 0.2"/>',
    "to the world": '<connect body1="rocker" anchor="0 0 0.5"/>',
    "weld": '<weld body1="plate" body2="crank"/>',
    "joint": '<joint joint1="d" joint2="a" polycoef="0 -2 0.5 0 0"/>',
}


@pytest.mark.parametrize("kind", TIES)
def test_ties_are_constraints(tmp_path, kind):
    # The multipliers of the rows, with MuJoCo's mass matrix and forces.
    path = written(tmp_path, LOOPS.format(TIES[kind]))
    model = mujoco.MjModel.from_xml_path(str(path))
    model.opt.disableflags |= off()
    data = mujoco.MjData(model)
    robot = read(path)
    system = robot.system()
    coordinates, speeds = order_of(robot, model)
    assembled = robot.definition.configuration.keys() & {*coordinates}
    assert len(assembled) == {"connect": 3, "to the world": 1, "weld": 2, "joint": 2}[kind]  # zeros
    rows = system.evaluate_holonomic_constraints()
    assert rows == pytest.approx(0.0, abs=1e-12)
    rng = np.random.default_rng(1)
    u = rng.normal(size=model.nv)

    def residuals(q):
        values = dict(zip(coordinates, q, strict=True))
        x = [values.get(s, 0.0) for s in system.states]
        return system.evaluate_holonomic_constraints(x)

    q0 = np.array(model.qpos0)
    if kind == "joint":  # elsewhere than at its start
        q0[0] = 0.4
        q0[3] = 0.1 - 2 * 0.4 + 0.5 * 0.4**2
    step = 1e-5

    def jacobian(q):
        steps = step * np.eye(model.nv)
        return np.stack([(residuals(q + s) - residuals(q - s)) / (2 * step) for s in steps], 1)

    full = jacobian(q0)
    u -= np.linalg.pinv(full, rcond=1e-6) @ (full @ u)
    data.qpos[:], data.qvel[:] = q0, u
    mujoco.mj_forward(model, data)
    mass = np.zeros((model.nv, model.nv))
    mujoco.mj_fullM(model, data, mass)
    bent = (jacobian(q0 + step * u) - jacobian(q0 - step * u)) @ u / (2 * step)
    free = np.linalg.solve(mass, data.qfrc_passive - data.qfrc_bias)
    way = np.linalg.solve(mass, full.T)
    force = np.linalg.lstsq(full @ way, -bent - full @ free, rcond=1e-6)[0]
    expected = free + way @ force
    values = dict(zip([*coordinates, *speeds], [*q0, *u], strict=True))
    rates = system.evaluate_ode([values[s] for s in system.states])
    found = dict(zip(system.states, rates, strict=True))
    assert [found[s] for s in speeds] == pytest.approx(expected, abs=1e-4 * abs(expected).max())


@pytest.mark.parametrize(("scale", "held"), [(0, 3), (0.5, 6)])
def test_a_weld_without_a_scale_of_torques_lets_bodies_turn(tmp_path, scale, held):
    weld = f'<equality><weld body1="b" torquescale="{scale}"/></equality>'
    body = '<body name="b"><freejoint/><geom size="0.1"/></body>'
    path = written(tmp_path, f"<mujoco><worldbody>{body}</worldbody>{weld}</mujoco>")
    rows = read(path).system().evaluate_holonomic_constraints()
    assert len(rows) == held + 1  # the length of the quaternion


def test_a_weld_of_sites_holds_a_body_where_their_frames_coincide(tmp_path):
    """The pose R = S₁ S₂ᵀ, p = p₁ − R p₂ by MuJoCo's products of quaternions."""
    fixed = '<site name="fixed" pos="0.3 0 1" euler="40 0 0"/>'
    own = '<site name="own" pos="0 0.2 0.1" euler="0 0 70"/>'
    body = f'<body name="b"><freejoint name="base"/><geom size="0.1"/>{own}</body>'
    weld = '<equality><weld site1="fixed" site2="own"/></equality>'
    path = written(tmp_path, f"<mujoco><worldbody>{fixed}{body}</worldbody>{weld}</mujoco>")
    model = mujoco.MjModel.from_xml_path(str(path))
    data, back, turn, arm = mujoco.MjData(model), np.zeros(4), np.zeros(4), np.zeros(3)
    mujoco.mju_negQuat(back, model.site_quat[1])
    mujoco.mju_mulQuat(turn, model.site_quat[0], back)
    mujoco.mju_rotVecQuat(arm, model.site_pos[1], turn)
    data.qpos[:] = [*(model.site_pos[0] - arm), *turn]
    mujoco.mj_forward(model, data)
    assert data.efc_pos[:6] == pytest.approx(0.0, abs=1e-14)
    robot = read(path)
    system, pose = (
        robot.system(),
        dict(zip(robot.joints["base"].coordinates, data.qpos, strict=True)),
    )
    rows = system.evaluate_holonomic_constraints([pose.get(s, 0.0) for s in system.states])
    assert rows == pytest.approx(0.0, abs=1e-14)


@pytest.mark.parametrize(
    ("quaternion", "angle"), [("0 1 0 0", 180), ("1 1 1 1", 120), ("1 0 0 1", None)]
)
def test_a_weld_that_is_turned_over_in_the_file_is_warned_of(tmp_path, quaternion, angle):
    """Half a turn away, and a third of one, the constrained products of axes are zero, too."""
    weld = f'<equality><weld body1="b" relpose="0 0 0 {quaternion}"/></equality>'
    body = '<body name="b"><freejoint name="f"/><geom size="0.1"/></body>'
    path = written(tmp_path, f"<mujoco><worldbody>{body}</worldbody>{weld}</mujoco>")
    if angle is None:  # a right angle: the residuals say it
        rows = read(path).system().evaluate_holonomic_constraints()
        assert abs(rows).max() == pytest.approx(1.0)
    else:
        with pytest.warns(PyDyUserWarning, match=f"weld of 'b' and 'world' is {angle}° away"):
            read(path)


def test_a_loop_keeps_its_energy_and_its_constraints(tmp_path):
    robot = read(written(tmp_path, LOOPS.format(TIES["connect"])))
    system = robot.system(ode_solver="dop853", times=np.linspace(0.0, 2.0, 21))
    system.initial_conditions = {**robot.start, "u_a": 1.0}
    system.set_dependent_initial_conditions()
    motion = system.simulate(rtol=1e-10, atol=1e-10, constraints="project")
    assert abs(system.evaluate_holonomic_constraints(motion.states, motion.times)).max() < 1e-12
    assert np.ptp(motion["q_a"]) > 1.0
    whole = system.evaluate_energy(motion.states, motion.times).total
    assert np.ptp(whole) < 1e-8 * abs(whole).max()


@pytest.mark.parametrize(
    ("text", "said"),
    [
        ("<mujoco><worldbody/></mujoco>", "no joint that moves"),
        ("<mujoco>", "MuJoCo does not read this file"),
        (
            '<mujoco><worldbody><body><joint/><geom type="mesh" mesh="gone"/></body></worldbody>\n'
            '<asset><mesh name="gone" file="gone.stl"/></asset></mujoco>',
            r"xml:2: .*gone\.stl",
        ),
    ],
)
def test_what_is_wrong_with_a_file_is_said(tmp_path, text, said):
    with pytest.raises(RobotFileError, match=said):
        read(written(tmp_path, text))


def body(name, joints, inside=""):
    inertia = '<inertial pos="0 0 0" mass="1" diaginertia="1 1 1"/>'
    return f"<body {name}>{inertia}{joints}{inside}</body>"


def test_what_has_no_name_gets_one_that_nothing_else_has(tmp_path):
    inner = body('name="body1"', '<joint name="a" axis="1 0 0"/><joint/>')
    bodies = body("", '<joint name="b"/>', body('name="a"', "<joint/>", inner))
    motors = '<motor joint="b"/><motor name="actuator0" joint="b" gear="2"/>'
    text = f"<mujoco><worldbody>{bodies}</worldbody><actuator>{motors}</actuator></mujoco>"
    robot = read(written(tmp_path, text))
    assert list(robot.frames) == ["world", "body1_2", "a", "body1"]
    assert list(robot.joints) == ["b", "a_2", "a", "body1_1"]
    one, two = robot.actuators["actuator0_2"], robot.actuators["actuator0"]
    rates = [robot.system(specifieds={f: 1.0}).evaluate_ode() for f in (one, two)]
    assert rates[1] == pytest.approx(2 * rates[0])
    assert rates[0].any()


@pytest.mark.parametrize(
    ("of_joint", "of_motor", "said"),
    [('stiffness="inf"', "", "jnt_stiffness"), ("", 'gear="nan"', "actuator_gear")],
)
def test_numbers_that_are_not_finite_are_told(tmp_path, of_joint, of_motor, said):
    bodies = body("", f'<joint name="j" {of_joint}/>')
    motor = f'<actuator><motor joint="j" {of_motor}/></actuator>'
    with pytest.raises(RobotFileError, match=f"xml:2: .* not finite .* `{said}`"):
        read(written(tmp_path, f"<mujoco>\n<worldbody>{bodies}</worldbody>{motor}</mujoco>"))


@pytest.mark.parametrize(("of", "kind"), [("body", "body"), ("joint", "joint")])
def test_a_name_that_is_not_utf_8_is_told_with_the_file(tmp_path, of, kind):
    bodies = body('name="body-é"', '<joint name="joint-é"/>').replace(f"{of}-é", f"{of}-\xff")
    text = f"<mujoco><worldbody>{bodies}</worldbody></mujoco>".replace("-é", "")
    (tmp_path / "robot.xml").write_bytes(text.encode("latin-1"))
    with pytest.raises(
        RobotFileError, match=rf"robot\.xml: the {kind} named '{of}-\\xff' .* UTF-8"
    ):
        read(tmp_path / "robot.xml")


@pytest.mark.parametrize("what", ["damping", "armature", "frictionloss"])
def test_negative_numbers_of_joints_are_told(tmp_path, what):
    bodies = body("", f'<joint name="j" {what}="-1"/>')
    text = f"<mujoco><worldbody>{bodies}</worldbody></mujoco>"
    with pytest.raises(RobotFileError, match=f"{what[:8]} of the joint 'j' must be .*got -1.0"):
        read(written(tmp_path, text))


def test_what_has_no_counterpart_is_listed_and_nothing_is_written(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    text = BRANCHED.replace(
        "<compiler", '<option density="1.2"/><compiler settotalmass="20"'
    ).replace("</actuator>", '<muscle name="flexor" joint="hinge" lengthrange="0 1"/></actuator>')
    text = text.replace("</mujoco>", '<keyframe><key name="home" time="1"/></keyframe></mujoco>')
    robot = read(written(tmp_path, text))
    assert "the forces of the fluid around" in robot.left_out
    assert "the actuator 'flexor', whose dynamics are muscle, muscle, muscle" in robot.left_out
    assert any("settotalmass" in line for line in robot.left_out)
    assert "keyframes" in robot.left_out
    assert [file.name for file in tmp_path.iterdir()] == ["robot.xml"]
    assert "left out: " in repr(robot)
    assert " more" in repr(robot)


BARE = """<mujoco>{option}<worldbody>
<body name="b" pos="0.1 0 1" {body}><joint name="j" type="{kind}" axis="0 1 0" {joint}/>
  <geom type="box" size=".1 .07 .05" pos=".05 .02 .01" mass="1.2" contype="0" conaffinity="0"/>
  <body name="c" pos="0.3 0 0"><joint name="k" type="slide" axis="1 0 0"/>
    <geom type="box" size=".05 .04 .03" mass=".7" contype="0" conaffinity="0"/></body></body>
</worldbody><actuator>{motor}</actuator>{equality}</mujoco>"""
TIED = '<equality><joint joint1="k" joint2="j" polycoef="0 1 0 0 0"/></equality>'


def bare(tmp_path, option="", body="", kind="hinge", joint="", motor="", equality="", **options):
    """Return a robot with its accelerations and MuJoCo's, in motion away from its start."""
    text = BARE.format(
        option=option, body=body, kind=kind, joint=joint, motor=motor, equality=equality
    )
    path = written(tmp_path, text)
    model = mujoco.MjModel.from_xml_path(str(path))
    data = mujoco.MjData(model)
    data.qvel[:] = np.linspace(0.3, -0.4, model.nv)
    data.ctrl[:] = 0.7
    mujoco.mj_forward(model, data)
    robot = read(path, **options)
    system = robot.system(specifieds=dict.fromkeys(robot.actuators.values(), 0.7))
    coordinates, speeds = order_of(robot, model)
    values = dict(zip([*coordinates, *speeds], [*data.qpos, *data.qvel], strict=True))
    rates = system.evaluate_ode([values[s] for s in system.states])
    found = dict(zip(system.states, rates, strict=True))
    return robot, [found[s] for s in speeds], data.qacc


def flag(*what):
    return "<option><flag " + " ".join(f'{w}="disable"' for w in what) + "/></option>"


MOTOR = '<motor name="m" joint="j" gear="2" group="1"/><motor name="n" joint="k" group="2"/>'


@pytest.mark.parametrize(
    "case",
    [
        {"option": '<option actuatorgroupdisable="1"/>', "motor": MOTOR},
        {"option": flag("actuation"), "motor": MOTOR},
        {"option": flag("constraint"), "equality": TIED, "joint": 'frictionloss="0.3"'},
        {"option": flag("limit"), "joint": 'range="0.1 1"'},
        {"option": flag("constraint"), "joint": 'range="0.1 1"'},
        {"option": flag("spring", "damper"), "body": 'gravcomp="0.5"'},
        {"option": flag("spring"), "joint": 'stiffness="0 3"', "body": 'gravcomp="0.5"'},
        {"option": flag("damper"), "joint": 'damping="0 3"'},
        {
            "option": flag("clampctrl"),
            "motor": '<motor name="m" joint="j" ctrlrange="-.1 .1" ctrllimited="true"/>',
        },
    ],
)
def test_what_a_file_turns_off_is_off(tmp_path, case):
    robot, found, expected = bare(tmp_path, **case, friction_speed=1e-3)
    assert found == pytest.approx(expected, rel=1e-10)
    assert robot.limits == []
    assert robot.input_ranges == {}
    assert all("turns off" in line or "not active" in line for line in robot.left_out)


@pytest.mark.parametrize("fraction", ["-0.4", "0.3"])
def test_weight_is_added_only_beside_a_body_whose_weight_is_compensated(tmp_path, fraction):
    bodies = "".join(
        f'<body gravcomp="{compensated}"><joint type="slide"/><geom size="0.1"/></body>'
        for compensated in ("-0.5", fraction)
    )
    path = written(tmp_path, f"<mujoco><worldbody>{bodies}</worldbody></mujoco>")
    model = mujoco.MjModel.from_xml_path(str(path))
    model.opt.disableflags |= off()
    data = mujoco.MjData(model)
    mujoco.mj_forward(model, data)
    assert read(path).system().evaluate_ode()[2:] == pytest.approx(data.qacc, rel=1e-12)


@pytest.mark.parametrize("kind", ["ball", "free"])
def test_dry_friction_of_joints_with_several_axes(tmp_path, kind):
    rubs = 'frictionloss="0.3"'
    robot, *_ = bare(tmp_path, kind=kind, joint=rubs)
    assert robot.left_out == (
        "the dry friction of the joint 'j' (give `friction_speed` to have it)",
    )
    robot, found, _ = bare(tmp_path, kind=kind, joint=rubs, friction_speed=1e-3)
    assert robot.left_out == ()
    # The same as forces of that size against the motion, which MuJoCo has as applied ones.
    path = tmp_path / "robot.xml"
    model = mujoco.MjModel.from_xml_path(str(path))
    model.opt.disableflags |= mujoco.mjtDisableBit.mjDSBL_FRICTIONLOSS
    data = mujoco.MjData(model)
    data.qvel[:] = np.linspace(0.3, -0.4, model.nv)
    data.qfrc_applied[:] = -0.3 * np.tanh(data.qvel / 1e-3)
    data.qfrc_applied[-1] = 0.0  # the slide has none
    mujoco.mj_forward(model, data)
    assert found == pytest.approx(data.qacc, rel=1e-9)


@pytest.mark.parametrize(
    ("case", "said"),
    [
        (
            {"motor": '<motor name="m" joint="j" damping="0 0.4"/>'},
            "the actuator 'm', which has a damping or an armature of its own",
        ),
        (
            {"option": flag("actuation"), "motor": '<motor name="m" joint="j" armature="0.4"/>'},
            "the actuator 'm', which has a damping or an armature of its own",
        ),
        (
            {"motor": '<motor name="m" joint="j" delay="0.1" nsample="5"/>'},
            "the actuator 'm', which acts with a delay",
        ),
        (
            {"joint": 'stiffness="30" springref="0.3" springyield="0.02"'},
            "the yield of the spring of the joint 'j'",
        ),
        (
            {"joint": 'actuatorfrcrange="-.2 .2"', "motor": MOTOR},
            "the limits of the actuators' force on the joint 'j'",
        ),
        ({"kind": "ball", "joint": 'range="0 0.5"'}, "the range of the ball joint 'j'"),
        (
            {"body": 'gravcomp="0.5"', "joint": 'actuatorgravcomp="true"'},
            "that no actuator compensates the weight at the joint 'j': it is compensated",
        ),
    ],
)
def test_what_a_joint_or_actuator_has_beyond_is_listed(tmp_path, case, said):
    robot, *_ = bare(tmp_path, **case)
    assert robot.left_out == (said,)


def test_a_plugin_is_no_motor(tmp_path):
    """Its force is no multiple of its input."""
    plugin = '<plugin plugin="mujoco.pid"><instance name="p"/>'
    servo = '<plugin name="m" joint="j" plugin="mujoco.pid" instance="p"/>'
    robot, *_ = bare(tmp_path, option=f"<extension>{plugin}</plugin></extension>", motor=servo)
    assert not robot.actuators
    assert robot.left_out == ("the actuator 'm', whose force a plugin computes", "plugins")
