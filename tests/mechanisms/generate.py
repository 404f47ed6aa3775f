"""Random mechanisms as plain data: a seed gives bodies, joints, loads, loops, a state."""

import copy

import numpy as np

from mechanisms.drawing import DIMENSIONS, decimal, decimals
from mechanisms.joints import JOINTS
from mechanisms.loads import LOADS
from mechanisms.loops import LOOPS
from mechanisms.oracle import World, layout, mixing
from mechanisms.taylor import LONG, pivots, solved

MOST_SPEEDS = 10
HINGES = ("pin", "slide", "cylinder", "screw")  # joints along an axis
# Numbers that no constraint holds.
MATERIAL = {"mass", "inertia", "gravity", "push", "moment", "stiffness", "damping", "drag"}
# From this seed on hinges are nearly parallel to those before them, by twists of their own.
TWISTED = 3000
QUARTER = 1.57079632679  # as it is typed: half of pi to twelve digits
# The most bodies of a seed, in turn: large mechanisms take most of the time.
BODIES = (2, 2, 3, 2, 3, 4, 8)


def draw(seed):
    """The data of one mechanism, in units of about one; `physical` puts them in units."""
    most = BODIES[seed % len(BODIES)]
    rng = np.random.default_rng([27, seed])
    plane = list(np.eye(3)[rng.integers(3)]) if rng.random() < 0.25 else None
    if plane is not None and rng.random() < 0.3:
        plane = decimals(rng, 3, 1, 2)
    data = {
        "seed": seed,
        "units": [1.0, 1.0, 1.0],
        "time": decimal(rng, 0, 2),
        "gravity": decimals(rng, 3, 9, 1),
        "said": bool(rng.random() < 0.5),
        "bodies": [],
        "speeds": [],
        "loads": [],
        "loops": [],
        "auxiliary": [],
        "plane": plane,
    }
    near = 10.0 ** -rng.integers(1, 5) if rng.random() < 0.2 else 1.0
    for k in range(int(rng.choice(np.arange(1, most + 1), p=_shares(most)))):
        data["bodies"].append(_body(rng, k, plane, near))
    own = np.random.default_rng([28, seed])  # what it draws changes no other seeds
    if seed >= TWISTED:
        _hinge(own, data)
    while layout(data)[2] > MOST_SPEEDS or not layout(data)[2]:
        if not layout(data)[2]:
            data["bodies"].append(_body(rng, len(data["bodies"]), plane, near))
        else:
            data["bodies"].pop()
    _, nq, nu = layout(data)
    data["q"] = [float(v) for v in np.round(near * rng.uniform(-1, 1, nq), 6)]
    data["u"] = decimals(rng, nu, 1, 2)
    if rng.random() < 0.4:
        names = ("of", "with", "turn")
        for _ in range(int(rng.integers(1, 4))):
            mixed = dict(zip(names, map(int, rng.integers(0, 99, 3)), strict=True))
            mixed |= {"plain": bool(rng.integers(2)), "swing": bool(rng.random() < 0.2)}
            mixed |= {"part": decimal(rng, -0.9, 0.9), "frequency": decimal(rng, 0.5, 2)}
            data["speeds"].append(mixed | {"size": mixed["part"]})
    for _ in range(int(rng.integers(0, 5))):
        kind = str(rng.choice(list(LOADS)))
        load = LOADS[kind].draw(rng, data)
        if load is not None:
            data["loads"].append({"kind": kind} | load)
    if rng.random() < (0.8 if plane else 0.4):
        kinds = ["meet", "hinge"] if plane and rng.random() < 0.7 else list(LOOPS)
        for _ in range(int(rng.integers(1, 3))):
            kind = str(rng.choice(kinds))
            data["loops"].append({"kind": kind} | LOOPS[kind].draw(rng, data))
    if rng.random() < 0.15 and data["bodies"][0]["joint"] == "pin":
        data["auxiliary"].append({"body": 0, "axis": int(rng.integers(3)), "turn": False})
    inside = np.random.default_rng([29, seed])  # what it draws changes no other seeds
    if data["loops"] and inside.random() < 0.4:
        item = {"body": int(inside.integers(len(data["bodies"]))), "axis": int(inside.integers(3))}
        data["auxiliary"] = [item | {"turn": bool(inside.integers(2))}]
    if rng.random() < 0.4:
        data["units"] = [float(f"1e{rng.integers(-9, 10)}") for _ in range(3)]
        if any(loop["kind"] == "again" for loop in data["loops"]):
            data["units"][0] = 1.0  # sums of rows of different kinds
    everything = [path for path, _ in leaves(data)]
    share = rng.random() * min(1.0, 15 / len(everything))
    data["named"] = [p for p in everything if rng.random() < share]
    if data["loops"]:  # what is redundant is so with the mechanism's own lengths and directions
        data["named"] = [p for p in data["named"] if _last(p) in MATERIAL]
    loads = [p for p in everything if p.startswith("loads") and ("push" in p or "moment" in p)]
    data["inputs"] = [p for p in loads if rng.random() < 0.2]
    data["fixed_inputs"] = [p for p in everything if p.split("_")[-1] == "drive"]
    if seed >= TWISTED:
        _twist(own, data)
    settle(data)
    for load in data["loads"]:
        if load["kind"] == "stop":  # away from the kink, where derivatives have two values
            angle = data["q"][layout(data)[0][load["body"]][0][1].start]
            if abs(load["rest"] - angle) < 0.1:
                load["rest"] = round(angle, 2) - 0.2
    return data


def _shares(most):
    shares = np.array([2, 4, 4, 3, 2, 1, 1, 1][:most], float)
    return shares / shares.sum()


def _body(rng, k, plane, near):
    if plane is not None:
        kind = "pin" if rng.random() < 0.85 else "weld"
        joint = {"axis": list(plane)}
    else:
        weights = np.array([row[0] for row in JOINTS.values()], float)
        kind = str(rng.choice(list(JOINTS), p=weights / weights.sum()))
        joint = JOINTS[kind][2](rng)
    digits = int(rng.integers(1, 4))
    straight = near < 1 and plane is not None
    at, centre = decimals(rng, 3, 1.5, digits), decimals(rng, 3, 1.5, digits)
    if straight:  # a chain that is nearly stretched
        along = np.cross(plane, [0.3, 0.5, 0.7]).round(3)
        at, centre = [list(map(float, s * along)) for s in rng.uniform(0.5, 1.5, 2).round(2)]
    half = rng.uniform(-0.5, 0.5, (3, 3)).round(2)
    size = (half @ half.T + np.diag([0.3, 0.4, 0.35])).round(4)
    particle = rng.random() < 0.15
    return {
        "on": int(rng.integers(max(k - 3, -1), k)) if k else -1,
        "joint": kind,
        **joint,
        "at": at,
        "tilt": [0.0] * 3 if plane is not None or rng.random() < 0.6 else decimals(rng, 3, 1, 2),
        "centre": centre,
        "mass": decimal(rng, 0.2, 3),
        "about": "hinge" if rng.random() < 0.2 else "centre",  # what the inertia is referred to
        "inertia": None if particle and kind in ("slide", "track", "weld") else
        [float(v) for v in (*np.diag(size), size[0, 1], size[1, 2], size[2, 0])],
    }  # fmt: skip


def _hinge(rng, data):
    """Make most joints hinges, most of a chain."""
    for k, body in enumerate(data["bodies"]):
        if k and rng.random() < 0.7:
            body["on"] = k - 1
        if data["plane"] is None and body["inertia"] is not None and rng.random() < 0.7:
            kept = {name: body[name] for name in ("on", "at", "tilt", "centre", "mass", "about")}
            made = {**kept, "inertia": body["inertia"], "joint": "pin"} | JOINTS["pin"][2](rng)
            data["bodies"][k] = made


def _twist(rng, data):
    """Make hinges nearly parallel to those before them: by a quarter turn, a tiny one, or none.

    One of none is a constant that is zero, in mechanisms without loops.
    """
    bodies, zeros = data["bodies"], []
    free = [k for k, b in enumerate(bodies) if b["joint"] in HINGES]
    for k in free:
        body, before = bodies[k], bodies[k]["on"]
        about, onto = (int(i) for i in rng.permutation(3)[:2])
        kind = str(rng.choice(["quarter", "tiny", "none", "as it was"], p=[0.4, 0.3, 0.2, 0.1]))
        tilt, sign = [0.0] * 3, float(rng.choice([-1, 1]))
        size = float(rng.choice([1e-12, 1e-11, 1e-9, 1e-7]))
        if kind == "as it was":
            continue
        if kind == "none":
            if not data["loops"]:
                zeros.append(f"bodies_{k}_tilt_{about}")
        elif data["plane"] is None:
            tilt[about] = sign * (QUARTER if kind == "quarter" else size)
        if data["plane"] is None and before in free:
            axis = [0.0] * 3
            axis[onto] = 1.0
            # In a frame that is turned about another axis, it is the third one.
            body["axis"] = axis
            if kind == "quarter":
                body["axis"] = [float(i not in (about, onto)) for i in range(3)]
            if all(b["on"] != before or b is body for b in bodies):
                bodies[before]["axis"] = axis
            elif kind != "quarter":
                body["axis"] = list(bodies[before]["axis"])
        body["tilt"] = tilt
    known = {path for path, _ in leaves(data)}
    data["named"] = [p for p in data["named"] if p in known] + zeros


def leaves(data, path=""):
    """Names of all numbers that may become symbols, and the numbers; zeros stay numbers."""
    if not path:
        for part in ("gravity", "bodies", "loads", "loops"):
            yield from leaves(data[part], part)
        return
    if isinstance(data, dict):
        for key, value in data.items():
            yield from leaves(value, f"{path}_{key}")
    elif isinstance(data, (list, tuple)):
        for k, value in enumerate(data):
            yield from leaves(value, f"{path}_{k}")
    elif isinstance(data, (float, np.floating)) and data != 0:
        yield path, data


def numbers_of(data):
    return dict.fromkeys(data["named"], 0.0) | dict(leaves(data))


def replaced(data, f, path="", named=()):
    """The same data with f(path, number) in place of each of the numbers in `leaves`.

    Of zeros those that are named count.
    """
    if not path:
        named = {*data["named"]}
        parts = {
            part: replaced(data[part], f, part, named)
            for part in ("gravity", "bodies", "loads", "loops")
        }
        return {**data, **parts}
    if isinstance(data, dict):
        return {key: replaced(value, f, f"{path}_{key}", named) for key, value in data.items()}
    if isinstance(data, (list, tuple)):
        return [replaced(value, f, f"{path}_{k}", named) for k, value in enumerate(data)]
    if isinstance(data, (float, np.floating)) and (data != 0 or path in named):
        return f(path, data)
    return data


def settle(data):
    """Close the loops at the state, drop those that would leave no motion, and fit the speeds.

    The numbers are of size one; `physical` puts them in units.
    """
    units, data["units"] = data["units"], [1.0, 1.0, 1.0]
    q = np.array(data["q"], LONG)
    for elements in layout(data)[0]:
        for _, of_q, _ in elements:
            if of_q.stop - of_q.start == 4:
                e = q[of_q] + np.array([2, 0, 0, 0], LONG)
                q[of_q] = e / np.sqrt(e @ e)
    data["q"] = [float(v) for v in q]
    loops, data["loops"] = data["loops"], []
    world = World(data, data["q"], data["u"])
    for loop in loops:
        if loop["kind"] != "again":
            LOOPS[loop["kind"]].settle(world, loop)
        data["loops"].append(loop)
        before = data["u"]
        # Neither a mechanism that cannot move nor one whose prescribed motion it cannot follow.
        if not _fit_speeds(data):
            data["loops"].pop()
            data["u"] = before
    _fit_speeds(data)
    data["units"] = units


def _fit_speeds(data):
    """Move the speeds onto the constraints; return whether that was possible, with some left."""
    world = World(data, data["q"], data["u"], rows=[])
    rows = pivots(world.A, world.A_size)[0]
    if rows:
        A = world.A[rows]
        step = A.T @ solved(A @ A.T, world.residual[rows])
        # What rounding leaves of a speed that is held is none: in units it would be a motion.
        data["u"] = [float(v) if abs(v) > 1e-15 else 0.0 for v in world.u - step]
        world = World(data, data["q"], data["u"], rows=rows)
    kept = len(rows) < world.nu and not np.any(np.abs(world.residual) > 1e-9)
    return kept and _agree(world, [k for k in range(len(world.position)) if k not in rows])


def _agree(world, rows):
    """Whether places that others imply are told by doubles: some hold the square of what is small.

    Rounding of the terms that cancel there, beside what is left of them, is what they contradict
    the others by.
    """
    held = np.abs(world.by_coordinates(rows)[0]) @ np.abs(world.q)
    size = world.A_size[rows].max(axis=1, initial=0)
    some = np.abs(world.A[rows]).max(axis=1, initial=0) > 1e-13 * size
    return not np.any(some & (2.0**-52 * size > 1e-9 * held))


def lengths(data):
    """For coordinates, and for speeds, whether they are lengths."""
    q, u = [], []
    for elements in layout(data)[0]:
        for element, _, _ in elements:
            q += element.lengths
            u += (0, 0, 0) if len(element.lengths) == 4 else element.lengths
    return q, u


def physical(data):
    """The data in its units, as doubles."""
    length, _, second = data["units"]

    def sized(path, value):
        powers = DIMENSIONS.get(_last(path), (0, 0, 0))
        return value * float(np.prod([u**d for u, d in zip(data["units"], powers, strict=True)]))

    found = replaced(copy.deepcopy(data), sized)
    of_q, of_u = lengths(data)
    for mixed, i, j, *_ in mixing(found):
        mixed["part"] *= length ** (of_u[i] - of_u[j])
        mixed["size"] *= length ** of_u[i] / second
        mixed["frequency"] /= second
    found["time"] = data["time"] * second
    found["q"] = [v * length**k for v, k in zip(data["q"], of_q, strict=True)]
    found["u"] = [v * length**k / second for v, k in zip(data["u"], of_u, strict=True)]
    return found


def _last(path):
    """The key of a path that says what the number is."""
    words = [w for w in path.split("_") if not w.isdigit()]
    return "_".join(words[-2:]) if words[-2:-1] == ["drive"] else words[-1]
