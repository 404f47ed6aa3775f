"""A rider with arms on a bicycle, assembled from the `symbrim` package, to be frozen."""

from __future__ import annotations

from typing import Any
from zlib import crc32

import symbrim as bm
import sympy as sm


def derive(shoulder: str = "FlexRot") -> tuple[Any, Any]:
    """Return the KanesMethod, and a function that gives constants some values.

    A Carvallo-Whipple bicycle; a pelvis that leans on the saddle and carries the torso; shoulders
    of two angles and elbows of one, so that each hand's grip fixes its arm.
    """
    bicycle = bm.WhippleBicycle("bicycle")
    bicycle.ground = bm.FlatGround("ground")
    bicycle.rear_frame = bm.RigidRearFrame("rear_frame")
    bicycle.front_frame = bm.RigidFrontFrame("front_frame")
    bicycle.rear_wheel = bm.KnifeEdgeWheel("rear_wheel")
    bicycle.front_wheel = bm.KnifeEdgeWheel("front_wheel")
    bicycle.rear_tire = bm.NonHolonomicTire("rear_tire")
    bicycle.front_tire = bm.NonHolonomicTire("front_tire")

    rider = bm.Rider("rider")
    rider.pelvis = bm.PlanarPelvis("pelvis")
    rider.torso = bm.PlanarTorso("torso")
    rider.sacrum = bm.FixedSacrum("sacrum")
    rider.left_arm = bm.PinElbowStickLeftArm("left_arm")
    rider.right_arm = bm.PinElbowStickRightArm("right_arm")
    rider.left_shoulder = getattr(bm, f"{shoulder}LeftShoulder")("left_shoulder")
    rider.right_shoulder = getattr(bm, f"{shoulder}RightShoulder")("right_shoulder")

    both = bm.BicycleRider("both")
    both.bicycle, both.rider = bicycle, rider
    both.seat = bm.SideLeanSeat("seat")
    both.hand_grips = bm.HolonomicHandGrips("hand_grips")
    both.define_all()

    system = both.to_system()
    ground = bicycle.ground
    system.apply_uniform_gravity(-sm.Symbol("g") * ground.get_normal(ground.origin))
    # The arms follow the handlebar; of the bicycle pitch depends, and all but three speeds.
    arms = (rider.left_shoulder, rider.right_shoulder, rider.left_arm, rider.right_arm)
    q_dep = [bicycle.q[4], *(q for part in arms for q in part.q)]
    u_dep = [*bicycle.u[:3], bicycle.u[4], bicycle.u[7], *(u for part in arms for u in part.u)]
    system.q_ind, system.q_dep = [q for q in system.q if q not in q_dep], q_dep
    system.u_ind, system.u_dep = [u for u in system.u if u not in u_dep], u_dep
    system.form_eoms()
    return system.eom_method, _value


def _value(name: str) -> float:
    """Return a number near one for a name; what it is matters little for how long a call takes."""
    return 9.81 if name == "g" else 0.8 + 0.4 * crc32(name.encode()) / 2**32
