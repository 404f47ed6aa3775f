"""Linear lateral motion of two-wheelers, written down from Newton's and Euler's equations.

States are those of straight running at a constant speed, in ISO axes: x forward, y to the left.
"""

import numpy as np

G = 9.81

# The benchmark bicycle, Meijaard et al. 2007, section 5: M q'' + v C1 q' + (g K0 + v² K2) q = 0.
M = np.array([[80.81722, 2.31941332208709], [2.31941332208709, 0.29784188199686]])
C1 = np.array([[0.0, 33.86641391492494], [-0.85035641456978, 1.68540397397560]])
K0 = np.array([[-80.95, -2.59951685249872], [-2.59951685249872, -0.80329488458618]])
K2 = np.array([[0.0, 76.59734589573222], [0.0, 2.65431523794604]])


def benchmark_eigenvalues(v):
    """Return the four eigenvalues of the published matrices at a speed."""
    rates = np.hstack([-np.linalg.solve(M, G * K0 + v**2 * K2), -np.linalg.solve(M, v * C1)])
    return np.linalg.eigvals(np.vstack([np.eye(2, 4, 2), rates]))


def sharp_eigenvalues(machine, u):
    """Return the eigenvalues of the equations of Sharp 1971 for a `Motorcycle`.

    Coordinates are the lateral position y of the rear contact point, yaw, lean to the right and
    steering to the left; states v, r, p, δ', φ, δ and the side forces, which follow with a lag
    where the tires have relaxation.
    """
    L, c, tilt = machine.wheelbase, machine.trail, machine.steer_axis_tilt
    cos, sin = np.cos(tilt), np.sin(tilt)
    rear, front = machine.rear_frame, machine.front_frame
    R, F = machine.rear_wheel, machine.front_wheel

    def by_steering(x, h):
        # Lateral motion of a point of the front frame by a unit of steering.
        return cos * (x - L - c) + sin * h

    bodies = [
        (rear.mass, rear.x, rear.height, rear.Ixx, rear.Izz, rear.Ixz, 0.0),
        (R.mass, 0.0, R.radius, R.diametral_inertia, R.diametral_inertia, 0.0, 0.0),
        (front.mass, front.x, front.height, front.Ixx, front.Izz, front.Ixz, 1.0),
        (F.mass, L, F.radius, F.diametral_inertia, F.diametral_inertia, 0.0, 1.0),
    ]
    mass = np.zeros((4, 4))
    for m, x, h, Ixx, Izz, Ixz, steered in bodies:
        lateral = np.array([1.0, x, -h, steered * by_steering(x, h)])
        turning = np.array([[0, 0, 1, -steered * sin], [0, 1, 0, steered * cos]])
        mass += m * np.outer(lateral, lateral)
        mass += turning.T @ np.array([[Ixx, Ixz], [Ixz, Izz]]) @ turning
    gyroscopic = np.zeros((4, 4))
    for wheel, steered in ((R, 0.0), (F, 1.0)):
        momentum = wheel.axial_inertia * u / wheel.radius
        about_x, about_z = np.array([0, 0, 1, -steered * sin]), np.array([0, 1, 0, steered * cos])
        gyroscopic += momentum * (np.outer(about_z, about_x) - np.outer(about_x, about_z))
    moment = sum(b[0] * b[1] for b in bodies)
    steered = sum(b[0] * by_steering(b[1], b[2]) for b in bodies if b[6])
    static = steered + c * cos / L * moment
    gravity = np.zeros((4, 4))
    gravity[2, 2] = -G * sum(b[0] * b[2] for b in bodies)
    gravity[2, 3] = gravity[3, 2] = G * static
    gravity[3, 3] = -G * static * sin

    sideways = np.array([[1.0, L, 0.0, -c * cos], [1.0, 0.0, 0.0, 0.0]])  # of the contact points
    headings = np.array([[0.0, 0.0, 0.0, cos], [0.0, 0.0, 0.0, 0.0]])
    leans = np.array([[0.0, 0.0, 1.0, -sin], [0.0, 0.0, 1.0, 0.0]])
    C = np.array([machine.front_stiffness, machine.rear_stiffness])[:, None]
    C_gamma = np.array([machine.front_camber_stiffness, machine.rear_camber_stiffness])[:, None]
    by_rate = -C * sideways / u
    by_angle = C * headings - C_gamma * leans
    damping = gyroscopic.copy()
    damping[:, 1] += mass[:, 0] * u  # v' + u r is the acceleration to the side
    damping[3, 3] += machine.steering_damping
    angles = np.eye(4)[:, 2:]
    lengths = np.array([machine.front_relaxation, machine.rear_relaxation])
    if not lengths.any():
        rates = np.hstack(
            [sideways.T @ by_rate - damping, (sideways.T @ by_angle - gravity)[:, 2:]]
        )
        return np.linalg.eigvals(
            np.vstack([np.linalg.solve(mass, rates), np.hstack([angles.T, np.zeros((2, 2))])])
        )
    rates = np.hstack([-damping, -gravity[:, 2:], sideways.T])
    lag = (u / lengths)[:, None]
    return np.linalg.eigvals(
        np.vstack(
            [
                np.linalg.solve(mass, rates),
                np.hstack([angles.T, np.zeros((2, 4))]),
                lag * np.hstack([by_rate, by_angle[:, 2:], -np.eye(2)]),
            ]
        )
    )
