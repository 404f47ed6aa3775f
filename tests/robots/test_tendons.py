"""Fixed tendons of MJCF files, against MuJoCo's own accelerations."""

import numpy as np
import pytest

from optional import optional
from pydy.errors import RobotFileError
from pydy.robots import read

mujoco = optional("mujoco")


def off():
    """Flags of MuJoCo that leave out contacts and equalities."""
    return mujoco.mjtDisableBit.mjDSBL_CONTACT | mujoco.mjtDisableBit.mjDSBL_EQUALITY


COEFFICIENTS = {
    "both": {"a": 0.5, "c": -1.5},
    "one": {"b": 1.0},
    "three": {"a": -1, "b": 2, "s": 3},
}

HAND = """<mujoco>
<compiler angle="radian" autolimits="true"/>
<default><geom type="capsule" size="0.02" contype="0" conaffinity="0"/></default>
<worldbody>
<body name="palm" quat="0.8 0.1 0.5 0.3"><joint name="a" axis="0 1 0" ref="0.2" damping="0.1"/>
  <geom fromto="0 0 0 0.1 0 0.3"/>
  <body name="finger" pos="0.1 0 0.3"><joint name="b" axis="0.6 0 0.8"/>
    <geom fromto="0 0 0 0.2 0.1 0"/>
    <body name="tip" pos="0.2 0 0"><joint name="s" type="slide" axis="1 2 0" ref="-0.1"/>
    <geom fromto="0 0 0 0 0.1 0.1"/></body></body></body>
<body name="thumb" pos="1 0 0"><joint name="c" axis="1 0 0" springref="0.3"/>
  <geom fromto="0 0 0 0 0.3 0.1"/></body>
</worldbody>
<tendon>
<fixed name="both" {both}><joint joint="a" coef="0.5"/><joint joint="c" coef="-1.5"/></fixed>
<fixed name="one" {one}><joint joint="b" coef="1"/></fixed>
<fixed name="three" {three}><joint joint="a" coef="-1"/><joint joint="b" coef="2"/>
  <joint joint="s" coef="3"/></fixed>
<spatial name="string"><site site="p"/><site site="w"/></spatial>
</tendon>
<equality>{equality}</equality>
<actuator>{motor}</actuator>
</mujoco>"""
HAND = HAND.replace('<body name="thumb"', '<site name="w"/><body name="thumb"').replace(
    '<geom fromto="0 0 0 0 0.3 0.1"/>', '<geom fromto="0 0 0 0 0.3 0.1"/><site name="p"/>'
)


def written(tmp_path, both="", one="", three="", equality="", motor=""):
    path = tmp_path / "hand.xml"
    text = HAND.format(both=both, one=one, three=three, equality=equality, motor=motor)
    path.write_text(text)
    return path


def moving(path):
    """MuJoCo's model in motion, away from its start, with an input of 0.7."""
    model = mujoco.MjModel.from_xml_path(str(path))
    model.opt.disableflags |= off()
    data = mujoco.MjData(model)
    data.qpos[:] = model.qpos0
    data.qpos += [0.4, -0.3, 0.2, 0.5]
    data.qvel[:] = [0.3, -0.4, 0.8, 1.1]
    data.ctrl[:] = 0.7
    return model, data


def accelerations(robot, data, system=None):
    system = system or robot.system(specifieds=dict.fromkeys(robot.actuators.values(), 0.7))
    symbols = [[robot.joints[name][k][0] for name in "absc"] for k in (0, 1)]
    values = [*data.qpos, *data.qvel]
    x = dict(zip([*symbols[0], *symbols[1]], values, strict=True))
    rates = system.evaluate_ode([x[s] for s in system.states])
    found = dict(zip(system.states, rates, strict=True))
    return [found[u] for u in symbols[1]]


MOTOR = '<motor name="m" tendon="both" gear="-2.5"/>'
SERVO = '<position name="m" tendon="three" kp="20" kv="3" gear="1.5"/>'
RANGES = {"limited": "true", "range": "-.4 .6"}
SLACK = 'stiffness="30" springlength="{}"'


@pytest.mark.parametrize("parameters", ["symbols", "numbers"])
@pytest.mark.parametrize(
    "case",
    [
        {"motor": MOTOR},
        {"motor": SERVO + MOTOR.replace('"m"', '"n"')},
        {"both": 'stiffness="30"', "three": 'stiffness="7" springlength="0.1"'},
        {"both": 'damping="3"', "one": 'damping="2"', "three": 'damping="0.4"'},
        {"one": 'armature="0.3"', "three": 'armature="0.02"', "motor": SERVO},
        *({"both": SLACK.format(lengths)} for lengths in ("-1 1", "0 1", "-2 -0.9")),
    ],
)
def test_accelerations_are_those_of_mujoco(tmp_path, case, parameters):
    path = written(tmp_path, **case)
    model, data = moving(path)
    mujoco.mj_forward(model, data)
    robot = read(path, parameters=parameters)
    assert robot.left_out == ("the spatial tendon 'string'",)
    expected = pytest.approx(data.qacc, abs=1e-12 * abs(data.qacc).max())
    assert accelerations(robot, data) == expected
    slack = SLACK.format("-1 1") in case.values()
    assert (accelerations(read(written(tmp_path)), data) == expected) == slack


def test_an_armature_couples_joints_of_different_branches(tmp_path):
    # MuJoCo's mass matrix has no entries between these: it leaves out those of the armature.
    model, data = moving(written(tmp_path))
    mujoco.mj_forward(model, data)
    mass = np.zeros((4, 4))
    mujoco.mj_fullM(model, data, mass)
    shares = np.array([COEFFICIENTS["both"].get(name, 0.0) for name in "absc"])
    expected = np.linalg.solve(mass + 0.3 * np.outer(shares, shares), mass @ data.qacc)
    found = accelerations(read(written(tmp_path, both='armature="0.3"')), data)
    assert found == pytest.approx(expected, abs=1e-12 * abs(expected).max())


def test_lengths_and_rates_are_those_of_mujoco(tmp_path):
    path = written(tmp_path, three='range="0 1"')
    model, data = moving(path)
    mujoco.mj_forward(model, data)
    robot = read(path)
    assert list(robot.tendons) == list(COEFFICIENTS)
    system = robot.system()
    system.outputs = {f"{n} {k}": t[k] for n, t in robot.tendons.items() for k in (0, 1)}
    symbols = [robot.joints[name][k][0] for k in (0, 1) for name in "absc"]
    x = dict(zip(symbols, [*data.qpos, *data.qvel], strict=True))
    found = system.evaluate_outputs([x[s] for s in system.states])
    expected = np.stack([data.ten_length, data.ten_velocity], 1)[:3].ravel()
    assert found == pytest.approx(expected, rel=1e-14)
    assert [event.name for event in robot.limits] == [
        "tendon three at its lower limit",
        "tendon three at its upper limit",
    ]


def test_a_range_of_a_tendon_ends_a_simulation(tmp_path):
    robot = read(written(tmp_path, both='range="-10 0.5"', motor=MOTOR))
    system = robot.system(ode_solver="dop853", times=[0.0, 10.0], specifieds={"m": -1.0})
    motion = system.simulate(events=robot.limits)
    event = motion.events[-1]
    assert event.name == "tendon both at its upper limit"
    at = dict(zip(system.states, event.before, strict=True))
    length = sum(c * at[robot.joints[j].coordinates[0]] for j, c in COEFFICIENTS["both"].items())
    assert length == pytest.approx(0.5, abs=1e-12)


def test_a_tendon_outside_of_its_range_in_the_files_pose_is_listed(tmp_path):
    path = written(tmp_path, three='range="0.5 1"')
    model, _ = moving(path)
    data = mujoco.MjData(model)  # in the file's pose
    mujoco.mj_forward(model, data)
    length = data.ten_length[list(COEFFICIENTS).index("three")]
    assert read(path).left_out[-1] == (
        "the limits of the tendon 'three', 0.5 to 1, until it is between them: in the file's pose "
        f"its length is {length:g}"
    )


def test_dry_friction_of_a_tendon(tmp_path):
    path = written(tmp_path, three='frictionloss="0.3"')
    assert "the dry friction of the tendon 'three'" in read(path).left_out[1]
    model, data = moving(path)
    model.opt.disableflags |= mujoco.mjtDisableBit.mjDSBL_FRICTIONLOSS
    mujoco.mj_forward(model, data)
    shares = np.array([COEFFICIENTS["three"].get(name, 0.0) for name in "absc"])
    # The same as forces against the motion, which MuJoCo has as applied ones.
    data.qfrc_applied[:] = -0.3 * np.tanh(shares @ data.qvel / 2.0) * shares
    mujoco.mj_forward(model, data)
    found = accelerations(read(path, friction_speed=2.0), data)
    assert found == pytest.approx(data.qacc, abs=1e-12 * abs(data.qacc).max())


@pytest.mark.parametrize("what", ["spring", "damper", "frictionloss", "limit", "actuation"])
def test_what_a_file_turns_off_is_off(tmp_path, what):
    path = written(
        tmp_path,
        both='stiffness="3" damping="4" range="-9 9" frictionloss="0.3"',
        motor='<motor name="m" tendon="both"/>',
    )
    off = f'<option><flag {what}="disable"/></option>'
    path.write_text(path.read_text().replace("<default>", f"{off}<default>"))
    model, data = moving(path)
    model.opt.disableflags |= mujoco.mjtDisableBit.mjDSBL_FRICTIONLOSS
    mujoco.mj_forward(model, data)
    robot = read(path)
    assert accelerations(robot, data) == pytest.approx(data.qacc, abs=1e-12 * abs(data.qacc).max())
    assert bool(robot.limits) == (what != "limit")
    assert any("dry friction" in line for line in robot.left_out) == (what != "frictionloss")


TIES = {
    "to another": '<tendon tendon1="both" tendon2="three" polycoef="0 0.5 0.2 0 0"/>',
    "of one joint": '<tendon tendon1="one" tendon2="both" polycoef="0 -2 0 0 0"/>',
    "to a length": '<tendon tendon1="three" polycoef="0 0 0 0 0"/>',
}


@pytest.mark.parametrize("parameters", ["symbols", "numbers"])
@pytest.mark.parametrize("kind", TIES)
def test_equalities_of_tendons_are_exact_constraints(tmp_path, kind, parameters):
    path = written(tmp_path, equality=TIES[kind], motor=MOTOR, both='stiffness="3"')
    model, data = moving(path)
    system = (robot := read(path, parameters=parameters)).system(specifieds={"m": 0.7})
    assert len(robot.definition.holonomic_constraints) == 1
    rows = {n: np.array([c.get(j, 0.0) for j in "absc"]) for n, c in COEFFICIENTS.items()}
    one, other, (slope, bend) = {
        "to another": (rows["both"], rows["three"], (0.5, 0.2)),
        "of one joint": (rows["one"], rows["both"], (-2.0, 0.0)),
        "to a length": (rows["three"], rows["one"], (0.0, 0.0)),
    }[kind]
    # l1 = slope l2 + bend l2² of the changes of the lengths: solved for the joint that only l1 has.
    moved = data.qpos - model.qpos0
    last = {"to another": 3, "of one joint": 1, "to a length": 2}[kind]
    moved[last] = 0.0
    second = other @ moved
    moved[last] = (slope * second + bend * second**2 - one @ moved) / one[last]
    row = one - (slope + 2 * bend * second) * other
    data.qpos[:] = model.qpos0 + moved
    data.qvel -= row * (row @ data.qvel) / (row @ row)
    mujoco.mj_forward(model, data)
    mass = np.zeros((4, 4))
    mujoco.mj_fullM(model, data, mass)
    # M a − rowᵀ λ = M a_free and row · a = 2 bend l2'²
    whole = np.block([[mass, -row[:, None]], [row[None, :], np.zeros((1, 1))]])
    right = [*mass @ data.qacc, 2 * bend * (other @ data.qvel) ** 2]
    expected = np.linalg.solve(whole, right)[:4]
    found = accelerations(robot, data, system)
    assert found == pytest.approx(expected, abs=1e-10 * abs(expected).max())


@pytest.mark.parametrize(
    ("case", "said"),
    [
        (
            {"motor": '<motor name="m" tendon="string"/>'},
            "the actuator 'm', which acts by the spatial tendon 'string'",
        ),
        (
            {"equality": '<tendon name="e" tendon1="one" tendon2="string"/>'},
            "the equality 'e', of spatial tendons",
        ),
        (
            {"one": 'actuatorfrcrange="-1 1"', "motor": MOTOR},
            "the limits of the actuators' force on the tendon 'one'",
        ),
        (
            {"one": 'stiffness="3" springyield="0.02"'},
            "the yield of the spring of the tendon 'one'",
        ),
        (
            {"one": 'stiffness="3 2"'},
            "the polynomial stiffness or damping of the tendon 'one'",
        ),
    ],
)
def test_what_has_no_counterpart_is_listed(tmp_path, case, said):
    robot = read(written(tmp_path, **case))
    assert set(robot.left_out) == {said, "the spatial tendon 'string'"}


@pytest.mark.parametrize(
    ("case", "said"),
    [
        ({"one": 'damping="-1"'}, "damping of the tendon 'one' must be .*got -1.0"),
        ({"one": 'armature="-1"'}, "tendon armature cannot be negative"),
        ({"one": 'stiffness="inf"'}, "not finite .* `tendon_stiffness`"),
        ({"equality": '<tendon tendon1="one" polycoef="nan"/>'}, "not finite .* `eq_data`"),
    ],
)
def test_numbers_that_no_tendon_has_are_told(tmp_path, case, said):
    with pytest.raises(RobotFileError, match=said):
        read(written(tmp_path, **case))
