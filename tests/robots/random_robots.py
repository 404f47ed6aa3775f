"""Random robots as URDF files, and their forces by the recursive Newton–Euler method."""

from __future__ import annotations

import numpy as np

# Right angles as files have them: with all digits, with twelve, with five.
RIGHT = (0.0, 0.0, np.pi / 2, 1.57079632679, 3.14159265359, -1.5708)


def random_tree(rng, count):
    """Links by dictionaries, each on one before it."""
    links = []
    for k in range(count):
        size = rng.normal(size=(3, 3))
        size = size @ size.T + np.eye(3)
        turn = rng.choice(RIGHT, size=3) if rng.uniform() < 0.7 else rng.uniform(-2, 2, 3).round(2)
        axis = np.eye(3)[rng.integers(3)] if rng.uniform() < 0.7 else rng.normal(size=3).round(1)
        kinds = ["revolute", "continuous", "prismatic", "fixed"] if k else ["revolute"]
        links.append(
            {
                "parent": int(rng.integers(-1, k)) if rng.uniform() < 0.4 else k - 1,
                "kind": str(rng.choice(kinds)),
                "place": rng.uniform(-0.5, 0.5, 3).round(2),
                "turn": turn,
                "axis": axis if axis.any() else np.array([0.0, 0.0, 1.0]),
                "mass": round(float(rng.uniform(0.5, 3.0)), 2),
                "centre": rng.uniform(-0.2, 0.2, 3).round(2),
                "inertia": (0.1 * (np.trace(size) * np.eye(3) - size)).round(3),
                "damping": float(rng.choice([0.0, 0.3])),
            }
        )
    return links


def numbers(values):
    return " ".join(repr(float(v)) for v in values)


def urdf(links):
    """The text of a URDF file."""
    lines = ['<robot name="random">', '<link name="world"/>']
    for k, link in enumerate(links):
        (xx, xy, xz), (_, yy, yz), (_, _, zz) = link["inertia"]
        lines.append(
            f'<link name="l{k}"><inertial><origin xyz="{numbers(link["centre"])}"/>'
            f'<mass value="{link["mass"]}"/><inertia ixx="{xx}" ixy="{xy}" ixz="{xz}" iyy="{yy}" '
            f'iyz="{yz}" izz="{zz}"/></inertial></link>'
        )
        above = "world" if link["parent"] < 0 else f"l{link['parent']}"
        lines.append(
            f'<joint name="j{k}" type="{link["kind"]}"><parent link="{above}"/>'
            f'<child link="l{k}"/><origin xyz="{numbers(link["place"])}" '
            f'rpy="{numbers(link["turn"])}"/><axis xyz="{numbers(link["axis"])}"/>'
            f'<limit lower="-1" upper="1" effort="5" velocity="1"/>'
            f'<dynamics damping="{link["damping"]}"/></joint>'
        )
    return "\n".join([*lines, "</robot>"])


def about(axis, angle):
    """Rodrigues' formula."""
    x, y, z = axis / np.linalg.norm(axis)
    k = np.array([[0, -z, y], [z, 0, -x], [-y, x, 0]])
    return np.eye(3) + np.sin(angle) * k + (1 - np.cos(angle)) * k @ k


def torques(links, q, v, a):
    """Forces along the joints, with all vectors in the world's axes.

    q, v and a are dictionaries by number of link; those of fixed links are missing.
    """
    ground = np.eye(3), np.zeros(3), np.zeros(3), np.zeros(3), np.array([0.0, 0.0, 9.81])
    states, axes = [], []
    for k, link in enumerate(links):
        turn, place, w, dw, pull = states[link["parent"]] if link["parent"] >= 0 else ground
        x, y, z = np.eye(3)
        roll, pitch, yaw = link["turn"]
        offset = turn @ link["place"]
        turn = turn @ about(z, yaw) @ about(y, pitch) @ about(x, roll)
        axis = turn @ (link["axis"] / np.linalg.norm(link["axis"]))
        angle, rate, second = q.get(k, 0.0), v.get(k, 0.0), a.get(k, 0.0)
        slides = link["kind"] == "prismatic"
        if slides:
            offset = offset + axis * angle
        pull = pull + np.cross(dw, offset) + np.cross(w, np.cross(w, offset))
        if slides:
            pull = pull + 2 * np.cross(w, axis) * rate + axis * second
        elif k in v:
            turn = about(axis, angle) @ turn
            dw = dw + axis * second + np.cross(w, axis) * rate
            w = w + axis * rate
        states.append((turn, place + offset, w, dw, pull))
        axes.append(axis)
    force, moment = [np.zeros(3) for _ in links], [np.zeros(3) for _ in links]
    found = {}
    for k in range(len(links) - 1, -1, -1):
        link, (turn, place, w, dw, pull) = links[k], states[k]
        c, inertia = turn @ link["centre"], turn @ link["inertia"] @ turn.T
        own = link["mass"] * (pull + np.cross(dw, c) + np.cross(w, np.cross(w, c)))
        force[k] += own
        moment[k] += np.cross(c, own) + inertia @ dw + np.cross(w, inertia @ w)
        if k in v:
            along = force[k] if link["kind"] == "prismatic" else moment[k]
            found[k] = float(axes[k] @ along) + link["damping"] * v[k]
        j = link["parent"]
        if j >= 0:
            force[j] += force[k]
            moment[j] += moment[k] + np.cross(place - states[j][1], force[k])
    return found
