"""A person on a platform that is shaken: legs and trunk, held upright by feedback of all states.

S. Park, F. B. Horak and A. D. Kuo, Postural feedback responses scale with biomechanical constraints
in human standing, Exp. Brain Res. 154 (2004) 417–427. The platform's sines and the gains are those
of opty's gallery (`plot_park2004.py`); the segments are of a person of 70 kg and 1.75 m by D. A.
Winter, Biomechanics and Motor Control of Human Movement, table 4.1.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np
import sympy as sm
import sympy.physics.mechanics as me

__all__ = [
    "ACCELERATION", "GAINS", "NOISE", "SECONDS", "STATES", "accelerations", "equations", "gains",
    "person",
]  # fmt: skip

STATES = me.dynamicsymbols("ankle hip ankle_rate hip_rate")
ACCELERATION = me.dynamicsymbols("acceleration")
SECONDS, NOISE = 10.0, np.deg2rad(0.25)  # samples at 50 Hz
GAINS = np.array([[950.0, 175.0, 185.0, 50.0], [45.0, 290.0, 60.0, 26.0]])
gains = sm.symbols("k:2:4")
_SINES = (7, 11, 16, 25, 38, 61, 103, 131, 151, 181, 313, 523)
RATES = [2 * np.pi * n / 240 for n in _SINES]


def accelerations(t: Any, sin: Any) -> Any:
    """Return the platform's acceleration."""
    return sum(-0.02 * w**2 * sin(w * t) for w in RATES)


def person(torques: Sequence[Any]) -> tuple[Any, list[Any], list[Any]]:
    """Return the ground, the bodies and the loads, with the torques at ankle and hip."""
    ankle, hip, ankle_rate, hip_rate = STATES
    ground, leg, trunk = (me.ReferenceFrame(name) for name in "NLT")
    leg.orient_axis(ground, ankle, ground.z)
    leg.set_ang_vel(ground, ankle_rate * ground.z)
    trunk.orient_axis(leg, hip, leg.z)
    trunk.set_ang_vel(leg, hip_rate * leg.z)
    foot = me.Point("foot")  # in the frame of the platform
    foot.set_vel(ground, 0)
    joint = foot.locatenew("hip", 0.86 * leg.y)
    joint.v2pt_theory(foot, ground, leg)
    bodies, loads = [], []
    parts = [("leg", foot, leg, 22.5, 0.475, 0.28), ("trunk", joint, trunk, 47.5, 0.315, 0.25)]
    for name, start, frame, mass, distance, gyration in parts:
        centre = start.locatenew(name, distance * frame.y)
        centre.v2pt_theory(start, ground, frame)
        spin = me.inertia(frame, 0, 0, mass * gyration**2)
        bodies.append(me.RigidBody(name, centre, frame, mass, (spin, centre)))
        loads.append((centre, -mass * ACCELERATION * ground.x - 9.81 * mass * ground.y))
    loads += [(leg, (torques[0] - torques[1]) * ground.z), (trunk, torques[1] * ground.z)]
    return ground, bodies, loads


def equations() -> Any:
    """Return the KanesMethod, with the feedback and the gains in its loads."""
    ground, bodies, loads = person(-(sm.Matrix(2, 4, gains) * sm.Matrix(STATES)))
    t = me.dynamicsymbols._t
    kinematics = [u - q.diff(t) for q, u in zip(STATES[:2], STATES[2:], strict=True)]
    kane = me.KanesMethod(ground, STATES[:2], STATES[2:], kd_eqs=kinematics)
    kane.kanes_equations(bodies, loads)
    return kane
