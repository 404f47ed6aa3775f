"""A block that is thrown onto a slope, bounces, slides and stops, against parabolas.

Between impacts the motion is a parabola; an impact with the restitution e turns the normal speed w
to −e w and takes at most μ (1 + e) |w| of the sliding speed; a block that stays slides with the
acceleration of gravity less that of friction, until it stops, and stays there or slides down.
"""

import json

import numpy as np
import sympy as sm
import sympy.physics.mechanics as me

from mechanisms.drawing import decimal
from pydy.contact import Contacts, Stick, Unilateral
from pydy.mechanics import Definition
from pydy.system import System

MOST_IMPACTS = 3  # after which the motion is not compared: impacts would accumulate
CLEAR = 1e-2  # relative margin of whatever decides between sticking and sliding
SCRIPT = '''"""Found by seed {seed}: {message}"""

import json
import sys

sys.path.insert(0, "tests")  # in the project's folder

from mechanisms.contacts import check

check(json.loads("""{data}"""))
'''


class DisagreementError(AssertionError):
    """What was found, and what the parabolas say."""


def draw(seed):
    """A block in units of about one, whose decisions are clear."""
    rng = np.random.default_rng([31, seed])
    while True:
        data = {
            "seed": seed,
            "units": [float(f"1e{rng.integers(-9, 10)}") for _ in range(3)],
            "mass": decimal(rng, 0.2, 3),
            "gravity": decimal(rng, 1, 9),
            "slope": decimal(rng, -0.9, 0.9),
            "friction": decimal(rng, 0.05, 0.9),
            "restitution": float(rng.choice([0.0, decimal(rng, 0.2, 0.9)])),
            "height": decimal(rng, 0.05, 1),
            "along": decimal(rng, -2, 2),
            "normal": decimal(rng, -1, 1),
            "ends": decimal(rng, 0.3, 3),
            "last first": bool(rng.integers(2)),
        }
        if rng.random() < 0.6:
            data["units"] = [1.0, 1.0, 1.0]
        if Parabolas(data).clear:
            return data


class Parabolas:
    """The motion in units of about one: pieces of constant acceleration."""

    def __init__(self, data):
        self.pieces, self.clear = [], True
        g, e, mu = data["gravity"], data["restitution"], data["friction"]
        down, pressed = g * np.sin(data["slope"]), g * np.cos(data["slope"])
        t, s, n, v, w = 0.0, 0.0, data["height"], data["along"], data["normal"]
        for _ in range(1 if e == 0 else MOST_IMPACTS):
            flight = (w + np.sqrt(w * w + 2 * pressed * n)) / pressed
            self.pieces.append((t, s, n, v, w, down, -pressed))
            t, s = t + flight, s + v * flight + down * flight**2 / 2
            v, w, n = v + down * flight, w - pressed * flight, 0.0
            held = mu * (1 + e) * abs(w)
            self._decide(abs(v), held)
            v, w = np.sign(v) * max(abs(v) - held, 0.0), -e * w
        self.end = t
        if e > 0:
            return
        if v != 0:
            rate = down - np.sign(v) * mu * pressed
            self.pieces.append((t, s, 0.0, v, 0.0, rate, 0.0))
            if rate * v >= 0:
                self.end = np.inf
                return
            t, s = t - v / rate, s - v * v / (2 * rate)
        self._decide(abs(down), mu * pressed)
        rate = np.sign(down) * max(abs(down) - mu * pressed, 0.0)
        self.pieces.append((t, s, 0.0, 0.0, 0.0, rate, 0.0))
        self.end = np.inf

    def _decide(self, size, limit):
        self.clear &= bool(abs(size - limit) > CLEAR * limit)

    def __call__(self, times):
        """Rows of s, n, s', n'; before the first impact that is not followed."""
        found = []
        for time in times:
            t, s, n, v, w, a, b = [p for p in self.pieces if p[0] <= time][-1]
            h = time - t
            found.append(
                [s + v * h + a * h * h / 2, n + w * h + b * h * h / 2, v + a * h, w + b * h]
            )
        return np.array(found)


def contacts(data, times):
    """The block as Contacts of a System, with the sizes of its states."""
    s, n, v, w = me.dynamicsymbols("s n v w")
    m, g, slope, mu, e = sm.symbols("m g slope mu e")
    length, mass, second = data["units"]
    frame, origin = me.ReferenceFrame("N"), me.Point("O")
    origin.set_vel(frame, 0)
    block = origin.locatenew("P", s * frame.x + n * frame.y)
    block.set_vel(frame, v * frame.x + w * frame.y)
    pull = m * g * (sm.sin(slope) * frame.x - sm.cos(slope) * frame.y)
    order = (1, 0) if data["last first"] else (0, 1)
    definition = Definition(
        frame, [(s, n)[k] for k in order], [(v, w)[k] for k in order],
        bodies=[me.Particle("block", block, m)], loads=[(block, pull)],
    )  # fmt: skip
    values = {m: data["mass"] * mass, g: data["gravity"] * length / second**2}
    system = System(definition, values | {slope: data["slope"]}, ode_solver="dop853")
    sizes = {s: length, n: length, v: length / second, w: length / second}
    start = {n: data["height"], v: data["along"], w: data["normal"]}
    system.initial_conditions = {q: value * sizes[q] for q, value in start.items()}
    system.times = times * second
    ground = Unilateral(n, restitution=e, name="ground")
    stick = Stick(block, on=ground, mu=mu, along=frame.x)
    numbers = {mu: data["friction"], e: data["restitution"]}
    return Contacts(system, [ground, stick], numbers), sizes


def check(data):
    """Raise where the motion is not that of the parabolas; return the largest difference."""
    exact = Parabolas(data)
    times = np.linspace(0.0, min(data["ends"], 0.999 * exact.end), 12)
    made, sizes = contacts(data, times)
    motion = made.simulate(rtol=1e-11, atol=1e-12 * min(sizes.values()))
    found = np.array([motion[q.func.__name__] / size for q, size in sizes.items()]).T
    expected = exact(times)
    off = np.abs(found - expected) / (1e-8 * (1 + np.abs(expected).max(axis=0)))
    if not off.max() <= 1:
        row, column = np.unravel_index(np.nanargmax(off), off.shape)
        raise DisagreementError(
            f"block: {'snvw'[column]}[{row}] is {found[row, column]!r}, the parabolas say "
            f"{expected[row, column]!r} at {times[row]!r}"
        )
    return float(off.max())


SIMPLER = {
    "units": [1.0, 1.0, 1.0], "last first": False, "mass": 1.0, "gravity": 1.0, "slope": 0.0,
    "normal": 0.0, "along": 0.0, "height": 1.0, "restitution": 0.0, "friction": 0.5,
}  # fmt: skip


def shrunk(data):
    """The simplest block found that fails with the same type of error."""
    kind = _failure(data)
    for name, value in SIMPLER.items():
        simpler = data | {name: value}
        if data[name] != value and Parabolas(simpler).clear and _failure(simpler) is kind:
            data = simpler
    return data


def _failure(data):
    try:
        check(data)
    except Exception as error:  # noqa: BLE001 (a failure of any kind is shrunk and shown)
        return type(error)
    return None


def script(data, error):
    message = str(error).replace('"""', "'''").splitlines()[0]
    return SCRIPT.format(seed=data["seed"], message=message, data=json.dumps(data))
