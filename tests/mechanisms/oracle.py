"""What a mechanism does, in numbers of 80 bits: nothing here knows SymPy or the package.

Positions are power series in time along the motion; partial velocities are their first terms along
motions with one speed of size one, both without a rounding larger than 1e-19. Newton's and Euler's
laws of the bodies, projected on the partial velocities (virtual power), and the second derivatives
of the constraints are one linear system for the derivatives of the speeds and the multipliers.
"""

import numpy as np

from mechanisms.joints import JOINTS
from mechanisms.loads import LOADS
from mechanisms.loops import LOOPS
from mechanisms.taylor import (
    LONG,
    constant,
    cos_sin,
    multiply,
    pivots,
    rate,
    rotate,
    solved,
    turned,
)


def layout(data):
    """For each body the places of its coordinates and speeds, and which of them are quaternions."""
    places, nq, nu = [], 0, 0
    for body in data["bodies"]:
        elements = []
        for element in JOINTS[body["joint"]][1]:
            count = len(element.lengths)
            speeds = 3 if count == 4 else count
            elements.append((element, slice(nq, nq + count), slice(nu, nu + speeds)))
            nq, nu = nq + count, nu + speeds
        places.append(elements)
    return places, nq, nu


def mixing(data):
    """Of each combination of speeds: places of both speeds and of the coordinate, and its unit."""
    places = [p for elements in layout(data)[0] for p in elements if len(p[0].lengths) != 4]
    q = [k for _, of_q, _ in places for k in range(of_q.start, of_q.stop)]
    units = [data["units"][0] if length else 1 for e, _, _ in places for length in e.lengths]
    u = [k for _, _, of_u in places for k in range(of_u.start, of_u.stop)]
    for mixed in data["speeds"]:
        i, j, k = (mixed[name] % len(q) if q else 0 for name in ("of", "with", "turn"))
        if i > j:
            yield mixed, u[i], u[j], q[k], units[k]


def _each(numbers, f):
    """The same tree with f of every number."""
    if isinstance(numbers, dict):
        return {k: _each(v, f) for k, v in numbers.items()}
    if isinstance(numbers, (list, tuple)):
        return [_each(v, f) for v in numbers]
    return f(numbers) if isinstance(numbers, (float, np.floating)) else numbers


class World:
    """A mechanism at one state; q, u and all numbers of the data may be of 80 bits.

    With `freed`, an auxiliary speed, it takes the place of the first speed; there are rows alone.
    """

    def __init__(self, data, q, u, rows=None, freed=None):
        self.data = data = _each(data, LONG)
        self.parents = [body["on"] for body in data["bodies"]]
        self.kinds = [body["joint"] for body in data["bodies"]]
        self.places, self.nq, self.nu = layout(data)
        self.q, self.u, self.time = np.array(q, LONG), np.array(u, LONG), data["time"]
        self.freed = freed
        self._kinematics()
        if freed is not None:
            self._rows()
            return
        self._forces = np.zeros((len(self.parents) + 1, 6), LONG)  # about the origin
        self._sizes = np.zeros((len(self.parents) + 1, 2), LONG)
        self.force, self.force_size = np.zeros(self.nu, LONG), np.zeros(self.nu, LONG)
        for k, body in enumerate(data["bodies"]):
            self.push({"body": k, "at": [0, 0, 0]}, body["mass"] * np.array(data["gravity"], LONG))
        for load in data["loads"]:
            LOADS[load["kind"]].numbers(self, load)
        self._rows()
        self._motion(rows)

    # -- kinematics -----------------------------------------------------------------------------

    def _rates(self, q):
        """G and b of q' = G u + b as series, for a series of one motion of the coordinates."""
        G, b = np.zeros((3, self.nq, self.nu), LONG), np.zeros((3, self.nq), LONG)
        Y, y = np.zeros((3, self.nu, self.nu), LONG), np.zeros((3, self.nu), LONG)
        simple, theirs = [], []  # coordinates and speeds without quaternions
        for elements in self.places:
            for _, of_q, of_u in elements:
                if of_q.stop - of_q.start != 4:
                    simple += range(of_q.start, of_q.stop)
                    theirs += range(of_u.start, of_u.stop)
                    continue
                e = q[:, of_q] / 2
                rows = [(-e[:, 1], -e[:, 2], -e[:, 3]), (e[:, 0], -e[:, 3], e[:, 2])]
                rows += [(e[:, 3], e[:, 0], -e[:, 1]), (-e[:, 2], e[:, 1], e[:, 0])]
                G[:, of_q, of_u] = np.moveaxis(np.array(rows), 2, 0)
        Y[0] = np.eye(self.nu)
        for mixed, i, j, k, unit in mixing(self.data):
            turn = cos_sin(q[:, None, k] / unit)[0][:, 0]
            Y[:, i, j] += mixed["part"] * (turn if not mixed["plain"] else np.array([1, 0, 0]))
            if mixed["swing"]:  # and something that depends on time alone
                t = np.array([[self.time], [1], [0]], LONG)
                y[:, i] += mixed["size"] * cos_sin(mixed["frequency"] * t)[1][:, 0]
        inverse = np.zeros_like(Y)
        inverse[0] = solved(Y[0], np.eye(self.nu, dtype=LONG)) if self.nu else Y[0]
        inverse[1] = -inverse[0] @ Y[1] @ inverse[0]
        for i, j in zip(simple, theirs, strict=True):
            G[:, i] = inverse[:, j]
            b[0, i], b[1, i] = -inverse[0, j] @ y[0], -inverse[0, j] @ y[1] - inverse[1, j] @ y[0]
        return G, b

    @property
    def lengths(self):
        return [l for elements in self.places for e, _, _ in elements for l in e.lengths]

    @property
    def natural(self):
        """Speeds of the size of the units."""
        length, _, second = self.data["units"]
        found = []
        for elements in self.places:
            for element, _, _ in elements:
                own = element.lengths if len(element.lengths) < 4 else (0, 0, 0)
                found += [length**k / second for k in own]
        return np.array(found, LONG)

    def _kinematics(self):
        q, u = self.q, self.u
        G, b = self._rates(np.stack([q, 0 * q, 0 * q]))
        self.velocity = G[0] @ u + b[0]
        moving, drift = self._rates(np.stack([q, self.velocity, 0 * q]))
        self.G, self.drift = G[0], moving[1] @ u + drift[1]  # q'' = G u' + drift
        motions = self.nu + 1
        series = np.zeros((3, motions, self.nq), LONG)
        series[0] = q
        series[1, 0], series[2, 0] = self.velocity, self.drift / 2
        series[1, 1:] = G[0].T
        if self.freed is not None:
            series[1, 1] = 0
        time = np.zeros((3, motions), LONG)
        time[0], time[1, 0] = self.time, 1
        self._turns, self._places, self._axes, self._joints = [], [], [], []
        for k, body in enumerate(self.data["bodies"]):
            turn, place = self.turns(self.parents[k]), self.centres(self.parents[k])
            place = place + rotate(turn, np.array(body["at"], LONG))
            if any(body["tilt"]):
                for axis, angle in zip(np.eye(3), body["tilt"], strict=True):
                    a = constant(angle, 1)
                    turn = turn @ turned(axis, a)[0, 0]
            if self.freed is not None and self.freed["body"] == k:
                place, turn = self._free(place.copy(), turn.copy())
            self._joints.append(place)
            axis = np.array(body.get("axis", [1, 0, 0]), LONG)
            self._axes.append(turn[0, 0] @ (axis / np.sqrt(axis @ axis)))
            for element, of_q, _ in self.places[k]:
                own = np.moveaxis(series[:, :, of_q], 2, 0)
                own_turn, way = element.numbers(body, own, time)
                if way is not None:
                    place = place + rotate(turn, way)
                if own_turn is not None:
                    turn = multiply(turn, own_turn, np.matmul)
            self._turns.append(turn)
            self._places.append(place + rotate(turn, np.array(body["centre"], LONG)))

    def _free(self, place, turn):
        axis = np.eye(3, dtype=LONG)[self.freed["axis"]]
        if self.freed["turn"]:
            turn[1, 1] += np.cross(axis, turn[0, 0].T).T
        else:
            place[1, 1] += axis
        return place, turn

    def turns(self, body):
        return constant(np.eye(3), self.nu + 1) if body < 0 else self._turns[body]

    def centres(self, body):
        return constant(np.zeros(3), self.nu + 1) if body < 0 else self._places[body]

    def turn(self, body):
        return self.turns(body)[0, 0]

    def spins(self, body):
        """The angular velocity as a series of the first degree."""
        turn = self.turns(body)
        both = multiply(rate(turn), np.swapaxes(turn, -1, -2), np.matmul)
        return np.stack([both[..., 2, 1], both[..., 0, 2], both[..., 1, 0]], axis=-1)

    def series(self, spot):
        """The place of a point of a body."""
        return self.centres(spot["body"]) + rotate(
            self.turns(spot["body"]), np.array(spot["at"], LONG)
        )

    def motion(self, spot):
        """Place and velocity of a point, as numbers."""
        series = self.series(spot)
        return series[0, 0], series[1, 0]

    def offset(self, body, spot):
        """Where in a body a point of another one is."""
        return self.turn(body).T @ (self.series(spot)[0, 0] - self.centres(body)[0, 0])

    def axis(self, body):
        return self._axes[body]

    def joint_motion(self, body):
        place = self.places[body][0][1].start
        return self.q[place], self.velocity[place]

    # -- loads ----------------------------------------------------------------------------------

    def push(self, spot, force):
        if spot["body"] < 0:
            return
        series = self.series(spot)
        partial = series[1, 1:]
        self.force += partial @ force
        self.force_size += np.abs(partial).sum(-1) * np.abs(force).max()
        self._wrench(spot["body"], force, np.cross(series[0, 0], force))

    def twist(self, body, torque):
        if body < 0:
            return
        partial = self.spins(body)[0, 1:]
        self.force += partial @ torque
        self.force_size += np.abs(partial).sum(-1) * np.abs(torque).max()
        self._wrench(body, 0 * torque, torque)

    def _wrench(self, body, force, torque):
        self._forces[body] += np.concatenate([force, torque])
        self._sizes[body] += np.abs(force).sum(), np.abs(torque).sum()

    # -- constraints ----------------------------------------------------------------------------

    def _rows(self):
        rows = []
        for loop in self.data["loops"]:
            part = LOOPS[loop["kind"]]
            if loop["kind"] == "again":
                rows += part.combined(rows, loop, _added)
            else:
                rows += part.numbers(self, loop)
        rows = sorted(rows, key=lambda row: row[0])  # positions first, each in their order
        nu = self.nu
        self.kinds_of_rows = [kind for kind, _, _ in rows]
        self.A, self.A_size = np.zeros((len(rows), nu), LONG), np.zeros((len(rows), nu), LONG)
        self.bias, self.residual = np.zeros(len(rows), LONG), np.zeros(len(rows), LONG)
        # By the coordinates, of the rows that are positions; what quaternions need is left out.
        self.position = np.array([s[0, 0] for kind, s, _ in rows if kind == "position"], LONG)
        for k, (kind, series, size) in enumerate(rows):
            first = 1 if kind == "position" else 0
            self.A[k], self.A_size[k] = (
                series[first, 1:],
                np.maximum(size, np.abs(series[first, 1:])),
            )
            self.residual[k] = series[first, 0]
            self.bias[k] = 2 * series[2, 0] if first else series[1, 0]

    # -- accelerations --------------------------------------------------------------------------

    def _motion(self, rows):
        """Solve for u' and the multipliers of the rows that are kept, and bound their rounding."""
        nu, data = self.nu, self.data
        M, size, right = np.zeros((nu, nu), LONG), np.zeros((nu, nu), LONG), self.force.copy()
        right_size = self.force_size.copy()
        self.kinetic = LONG(0)
        self._inertial = []
        for k, body in enumerate(data["bodies"]):
            place, m = self._places[k], body["mass"]
            v, a = place[1, 1:], 2 * place[2, 0]
            M += m * v @ v.T
            size += m * np.abs(v) @ np.abs(v).T
            right -= m * v @ a
            right_size += m * np.abs(v) @ np.abs(a)
            self.kinetic += m * place[1, 0] @ place[1, 0] / 2
            spin, momentum = self.spins(k), None
            if body["inertia"] is not None:
                xx, yy, zz, xy, yz, zx = body["inertia"]
                own = np.array([[xx, xy, zx], [xy, yy, yz], [zx, yz, zz]], LONG)
                turn = self._turns[k]
                inertia = multiply(turn @ own, np.swapaxes(turn, -1, -2), np.matmul)
                momentum = rotate(inertia, spin)
                w, now = spin[0, 1:], inertia[0, 0]
                M += w @ now @ w.T
                size += np.abs(w) @ np.abs(now) @ np.abs(w).T
                right -= w @ momentum[1, 0]
                right_size += np.abs(w) @ np.abs(momentum[1, 0])
                self.kinetic += spin[0, 0] @ momentum[0, 0] / 2
            self._inertial.append((m, momentum))
        self.kept = pivots(self.A, self.A_size)[0] if rows is None else rows
        A, A_size = self.A[self.kept], self.A_size[self.kept]
        r = len(self.kept)
        K = np.block([[M, -A.T], [A, np.zeros((r, r), LONG)]])
        K_size = np.block([[size, A_size.T], [A_size, np.zeros((r, r), LONG)]])
        b = np.concatenate([right, -self.bias[self.kept]])
        natural = self.natural / data["units"][2]
        b_size = np.concatenate(
            [right_size + size @ natural, np.abs(self.bias[self.kept]) + A_size @ natural]
        )
        x = solved(K, b) if len(b) else b
        inverse = np.abs(solved(K, np.eye(len(b), dtype=LONG))) if len(b) else K
        speeds = np.abs(self.u)
        self.kinetic_bound = speeds @ size @ speeds + self.kinetic
        self.a, self.multipliers = x[:nu], x[nu:]
        bound = inverse @ (K_size @ np.abs(x) + b_size)
        self.a_bound, self.multipliers_bound = bound[:nu], bound[nu:]
        scaled = inverse @ K_size
        self.condition = float(np.max(np.abs(np.linalg.eigvals(scaled.astype(float))), initial=1.0))
        self.generalised = self.A.T[:, self.kept] @ self.multipliers
        self.generalised_bound = self.A_size.T[:, self.kept] @ self.multipliers_bound

    # -- answers --------------------------------------------------------------------------------

    @property
    def rates(self):
        return np.concatenate([self.velocity, self.a])

    @property
    def rates_bound(self):
        return np.concatenate(
            [np.abs(self.G) @ (np.abs(self.u) + self.natural) + np.abs(self.velocity), self.a_bound]
        )

    @property
    def accelerations(self):
        """Of the coordinates."""
        return self.G @ self.a + self.drift

    def by_coordinates(self, rows):
        """Derivatives of rows by the coordinates, and their sizes: there are 4 for 3 speeds."""
        of_q = np.array([self.data["units"][0] ** k for k in self.lengths], LONG)
        of_u = self.natural * self.data["units"][2]
        G = self.G / of_q[:, None] * of_u
        inverse = solved(G.T @ G, G.T) * of_u[:, None] / of_q
        return self.A[rows] @ inverse, self.A_size[rows] @ np.abs(inverse)

    def norms(self):
        """The squared lengths of quaternions, along which nothing is differentiated."""
        parts = [p for elements in self.places for e, p, _ in elements if len(e.lengths) == 4]
        return np.array([self.q[p] @ self.q[p] for p in parts], LONG)

    def potential(self):
        """That of gravity and springs, or None if another load depends on the place."""
        total = LONG(0)
        for k, body in enumerate(self.data["bodies"]):
            total -= body["mass"] * np.array(self.data["gravity"], LONG) @ self._places[k][0, 0]
        for load in self.data["loads"]:
            potential = LOADS[load["kind"]].potential
            if potential is None:
                return None
            total += potential(self, load)
        return total

    def potential_size(self):
        """What is added up in the potential of gravity, for bounds."""
        g = np.abs(np.array(self.data["gravity"], LONG)).sum()
        total = sum(body["mass"] for body in self.data["bodies"]) * g * self.reach()
        return total + sum(
            abs(LOADS[load["kind"]].potential(self, load)) for load in self.data["loads"]
        )

    def reach(self):
        """The sum of all lengths."""
        found = LONG(0)
        for body in self.data["bodies"]:
            found += np.abs(body["at"]).sum() + np.abs(body["centre"]).sum()
        return found + np.abs(self.q[[k for k, l in enumerate(self.lengths) if l]]).sum()

    def beyond(self, body):
        """The bodies that a joint holds."""
        found = [body]
        for k, parent in enumerate(self.parents):
            if parent in found:
                found.append(k)
        return found

    def reaction(self, body):
        """Force and torque about the joint's point on what lies beyond it, and their bounds."""
        pivot = self._joints[body][0, 0]
        force, torque = np.zeros(3, LONG), np.zeros(3, LONG)
        size = turn_size = LONG(0)
        for k in self.beyond(body):
            m, momentum = self._inertial[k]
            place = self._places[k]
            change = m * (2 * place[2, 0] + self.a @ place[1, 1:])
            arm = place[0, 0] - pivot
            force += change - self._forces[k, :3]
            torque += np.cross(arm, change)
            torque -= self._forces[k, 3:] - np.cross(pivot, self._forces[k, :3])
            own = m * (np.abs(2 * place[2, 0]).sum() + self.a_bound @ np.abs(place[1, 1:]).sum(-1))
            reach = np.abs(arm).sum() + np.abs(pivot).sum() + np.abs(place[0, 0]).sum()
            size += own + self._sizes[k, 0]
            turn_size += (own + self._sizes[k, 0]) * reach + self._sizes[k, 1]
            if momentum is not None:
                turn = momentum[1, 0] + self.a @ momentum[0, 1:]
                torque += turn
                turn_size += np.abs(momentum[1, 0]).sum() + self.a_bound @ np.abs(
                    momentum[0, 1:]
                ).sum(-1)
        bound = np.concatenate([np.full(3, size), np.full(3, turn_size)])
        return np.concatenate([force, torque]), bound

    def joint_force(self, item):
        """What a joint alone carries along an auxiliary speed, and its bound.

        That is the reaction without the forces of loops; None where redundant rows share them.
        """
        place = item["axis"] + 3 * item["turn"]
        force, bound = (part[place] for part in self.reaction(item["body"]))
        freed = World(self.data, self.q, self.u, freed=item)
        shares, sizes = freed.A[:, 0], freed.A_size[:, 0]
        kept = list(self.kept)
        A = self.A[kept]
        for k in (k for k in range(len(self.A)) if k not in kept):
            factors = solved(A @ A.T, A @ self.A[k]) if kept else np.zeros(0, LONG)
            size = np.abs(factors) @ sizes[kept] + sizes[k]
            if abs(shares[k] - factors @ shares[kept]) > 1e-10 * size:
                return None
        force -= self.multipliers @ shares[kept]
        return force, bound + self.multipliers_bound @ sizes[kept]


def _added(rows, weights):
    series = sum(LONG(w) * row[1] for row, w in zip(rows, weights, strict=False))
    size = sum(abs(LONG(w)) * row[2] for row, w in zip(rows, weights, strict=False))
    return series, size
