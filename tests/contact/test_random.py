"""Random contacts of the mechanisms' generator: what every motion with contacts must satisfy."""

import numpy as np
import pytest
import sympy.physics.mechanics as me

from mechanisms.check import Check
from mechanisms.drawing import vector
from mechanisms.generate import draw
from pydy.contact import Contacts, Stick, Unilateral

# Chosen so that each has contacts that close: chains, trees and loops of one to four bodies, points
# that bounce up to seventy times, come to rest, slide and open again.
SEEDS = (2, 3, 22, 34, 42, 43, 48, 52, 147)


def mechanism(seed):
    """A mechanism without drives and loads but gravity."""
    data = draw(seed)
    still = [speed for speed in data["speeds"] if not speed["swing"]]
    given = {"loads": [], "auxiliary": [], "inputs": [], "units": [1.0, 1.0, 1.0], "speeds": still}
    if np.linalg.norm(data["gravity"]) < 2.0:
        given["gravity"] = [0.0, -9.8, 0.0]
    if {loop["kind"] for loop in data["loops"]} - {"meet", "hinge", "ball", "weld"}:
        given["loops"] = []
    return Check(data | given, "definition")


def with_contacts(check, seed):
    """Its System with up to three points of its bodies above a floor each, and the contacts."""
    random = np.random.default_rng([99, seed])
    model, system, data = check.model, check.system, check.data
    up = -np.array(data["gravity"]) / np.linalg.norm(data["gravity"])
    first = np.cross(up, [1.0, 0.0, 0.3])
    first /= np.linalg.norm(first)
    axes = tuple(vector(list(axis), model.ground) for axis in (up, first, np.cross(up, first)))
    numbers = dict(zip([*model.q, *model.u], [*data["q"], *data["u"]], strict=True))
    numbers |= {**model.constants, me.dynamicsymbols._t: check.t}
    number = int(random.integers(1, 4))
    mu, ratio = float(random.choice([0.0, 0.3, 0.8])), float(random.choice([0.0, 0.0, 0.5]))
    given = []
    for k in range(number):
        body = int(random.integers(len(data["bodies"])))
        offset = [float(v) for v in np.round(random.uniform(-0.5, 0.5, 3), 2)]
        point = model.centre(body).locatenew(f"tip{k}", vector(offset, model.frame(body)))
        place = point.pos_from(model.origin)
        height = place.dot(axes[0])
        floor = round(float(height.xreplace(numbers)) - float(random.uniform(0.01, 0.4)), 6)
        gap = height - floor
        if not gap.has(*model.q):
            continue
        point.set_vel(model.ground, place.dt(model.ground).xreplace(model.rates))
        contact = Unilateral(gap, restitution=ratio, name=f"c{k}")
        given.append(Stick(point, on=contact, mu=mu, along=axes[1:]) if mu else contact)
    system.times = np.linspace(check.t, check.t + 1.0, 41)
    known = system.constants_symbols
    occurring = set().union(*(getattr(c, "on", c).gap.free_symbols for c in given))
    further = {s: v for s, v in model.constants.items() if s in occurring and s not in known}
    # By Newton's hypothesis friction may contradict a rebound.
    contacts = Contacts(system, given, further, hypothesis="poisson" if ratio else "newton")
    check._know()
    return contacts, mu


@pytest.mark.parametrize("seed", SEEDS)
def test_random_contacts_are_complementary_and_give_no_energy(seed):
    contacts, mu = with_contacts(mechanism(seed), seed)
    motion = contacts.simulate(rtol=1e-10, atol=1e-11)
    assert motion.impacts
    size = 1.0 + max(np.abs(motion[f"{name}_normal"]).max() for name in contacts.names)
    for name in contacts.names:
        gap, normal = motion[f"{name}_gap"], motion[f"{name}_normal"]
        assert gap.min() >= -1e-10
        assert normal.min() >= -1e-8 * size
        assert np.abs(gap * normal).max() <= 1e-9 * size
        if mu:
            parts = [motion[f"{name}_friction_{k}"] for k in (1, 2)]
            assert (np.hypot(*parts) - mu * normal).max() <= 1e-7 * size
    energy = motion.energy[:, 2]
    most = 1.0 + np.abs(motion.energy).max()
    np.testing.assert_allclose(energy - energy[0], motion.contact_work, atol=1e-7 * most)
    assert np.diff(energy).max() <= 1e-7 * most
