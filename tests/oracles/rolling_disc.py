"""A thin disc that rolls without slip, by the equations of textbooks, without pydy.

With the yaw ψ, the lean φ and the roll, the frame e₁ (the heading), e₂ (the axle), e₃ leans with
the disc and does not roll. Euler's equations in this frame, with the force at the lowest point
eliminated by v = r (ω₂ e₁ − ω₁ e₂), the axial moment of inertia C, and A about a diameter: ::

    (A + m r²) ω₁' = (C + m r²) ω₂ ω₃ − A ω₃² tan φ + m g r sin φ
    (C + m r²) ω₂' = −m r² ω₁ ω₃
    A ω₃' = A ω₁ ω₃ tan φ − C ω₁ ω₂

O. M. O'Reilly, The dynamics of rolling disks and sliding disks, Nonlinear Dynamics 10, 1996.
"""

from __future__ import annotations

import numpy as np
from scipy.integrate import solve_ivp


def disc_motion(
    times: np.ndarray,
    lean: float,
    rates: tuple[float, float, float],
    mass: float,
    radius: float,
    gravity: float,
) -> np.ndarray:
    """Return x, y, z of the centre, yaw and lean, and ω₁, ω₂, ω₃ at ascending times from 0.

    The disc begins with yaw 0 and its lowest point at the origin.
    """
    K = mass * radius**2
    A, C = K / 4, K / 2

    def derivative(_: float, state: np.ndarray) -> list[float]:
        yaw, phi, _, _, w1, w2, w3 = state
        roll = w2 - w3 * np.tan(phi)
        return [
            w3 / np.cos(phi),
            w1,
            radius * roll * np.cos(yaw),
            radius * roll * np.sin(yaw),
            ((C + K) * w2 * w3 - A * w3**2 * np.tan(phi) + mass * gravity * radius * np.sin(phi))
            / (A + K),
            -K * w1 * w3 / (C + K),
            w1 * w3 * np.tan(phi) - C / A * w1 * w2,
        ]

    start = [0.0, lean, 0.0, 0.0, *rates]
    options = {"method": "DOP853", "rtol": 1e-13, "atol": 1e-14, "t_eval": times}
    yaw, phi, x, y, *omega = solve_ivp(derivative, (0.0, times[-1]), start, **options).y
    centre = [
        x + radius * np.sin(yaw) * np.sin(phi),
        y - radius * np.cos(yaw) * np.sin(phi),
        radius * np.cos(phi),
    ]
    return np.stack([*centre, yaw, phi, *omega], axis=1)
