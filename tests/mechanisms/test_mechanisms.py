"""Random mechanisms do by every front end what the oracle says."""

import sys

import numpy as np
import pytest

from mechanisms import contacts
from mechanisms.build import permuted
from mechanisms.check import MOST_STEPS, Check, DisagreementError, check
from mechanisms.generate import BODIES, QUARTER, TWISTED, draw, leaves, physical
from mechanisms.oracle import World
from mechanisms.run import checked
from mechanisms.shrink import kind_of
from pydy.system import System

# Small ones: most of the time of large ones is SymPy's and the compiler's, as with these two.
SLOW = {79, 3007}
SEEDS = [s for s in range(88) if BODIES[s % len(BODIES)] < 4 and s not in SLOW][:60]
SEEDS += [s for s in range(TWISTED, TWISTED + 15) if BODIES[s % len(BODIES)] < 4 and s not in SLOW]


@pytest.mark.parametrize("seed", SEEDS)
def test_a_mechanism_does_what_the_oracle_says(seed):
    _, _, failure = checked(seed)
    assert failure is None, failure


def test_rolling_that_implies_a_height_shares_its_forces_with_it():
    """Of three rows for two, that of the height is first, and each has a multiplier of its own."""
    body = {
        "on": -1, "joint": "ball", "at": [0.0, 0.0, 0.0], "tilt": [1.0, 0.0, 0.0],
        "centre": [1.0, 1.0, 0.0], "mass": 2.69, "about": "hinge",
        "inertia": [0.0, 1.0, 1.0, 0.0, 0.0, 0.0],
    }  # fmt: skip
    roll = {"kind": "roll", "body": 0, "radius": 0.23, "height": -0.6602037852093628}
    data = {
        "seed": 179, "units": [1.0, 1.0, 1.0], "time": 0.56, "gravity": [0.0, 0.0, 0.0],
        "said": False, "bodies": [body], "speeds": [], "loads": [], "loops": [roll],
        "auxiliary": [], "plane": None, "q": [-0.754183, 0.40065, -0.52896],
        "u": [0.5120447809919315, 0.0981005597726956, -0.26627365775764317], "named": [],
        "inputs": [], "fixed_inputs": [],
    }  # fmt: skip
    check(data, ["joints"], ["outputs"])


@pytest.mark.parametrize(
    "seed",
    [2359, 2400, 2405, 2453, 2724],
    ids=["twice nothing", "rounding", "hinge", "height", "nanometres"],
)
def test_rows_that_hold_nothing_are_none(seed):
    assert checked(seed)[2] is None


def test_nanometres_between_bodies_that_are_metres_apart_join_nothing():
    """The difference of two far places is rounding: it gave a false warning of a further joint."""
    assert checked(181)[2] is None


@pytest.mark.parametrize("seed", [144, 353, 404, 832, 1843, 2454])
def test_columns_of_rounding_are_no_unknowns_and_small_ones_are(seed):
    assert checked(seed)[2] is None


def test_a_push_that_only_auxiliary_equations_hold_is_a_load():
    assert checked(2306)[2] is None


def test_the_oracle_takes_as_many_steps_as_a_motion_needs():
    data = draw(2050)  # drag that changes quickly: one step errs by 4 times what is allowed
    one = Check(data | {"loops": []}, "definition")
    assert one._steps > 1
    back = Check(draw(1361), "definition")  # drag that turns back: its derivatives have a kink
    assert back._steps == MOST_STEPS
    still = Check(draw(0), "definition")
    assert still._steps == 1


def test_what_fails_is_shrunk_to_what_matters_and_printed_as_a_script(monkeypatch):
    def wrong(data, *_):
        masses = [body["mass"] for body in data["bodies"]]
        if data["loads"] and len(masses) > 1:
            raise DisagreementError(f"kane: rates[{len(masses)}] is {masses[0]}, not 0")

    seed = next(s for s in range(100) if len(draw(s)["bodies"]) > 3 and len(draw(s)["loads"]) > 1)
    monkeypatch.setattr("mechanisms.run.check", wrong)
    monkeypatch.setattr("mechanisms.shrink.check", wrong)
    _, ratios, text = checked(seed)
    assert ratios == {}
    assert text.startswith(f'"""Found by seed {seed}: kane: rates[')
    found = []
    monkeypatch.setattr("mechanisms.check.check", lambda data, *_: found.append(data))
    monkeypatch.setattr(sys, "path", sys.path[:])
    exec(compile(text, "script", "exec"), {})
    (least,) = found
    assert len(least["bodies"]) == 2
    assert len(least["loads"]) == 1
    assert least["loops"] == least["auxiliary"] == least["inputs"] == []


def test_failures_of_a_kind_differ_in_numbers_and_names_only():
    text = "The constraints contradict each other: row {0} is left at {0}."
    first, second = (ValueError(text.format(k)) for k in (1, 2))
    assert kind_of(first) == kind_of(second)
    assert kind_of(first) != kind_of(ValueError("The body b1 has no mass."))
    assert kind_of(first) != kind_of(TypeError(str(first)))
    texts = [f"kane: rates[{k}] is {k}, the oracle says 0" for k in (1, 2)]
    assert len({kind_of(DisagreementError(text)) for text in texts}) == 1


def test_prescribed_motions_that_constraints_hold_are_no_inputs_of_linear_models():
    check(draw(980), ["definition"], ["linear_models"])


def test_motions_that_cannot_keep_a_driven_loop_are_not_compared():
    """A drive is a number with rates here: along a motion the loop that holds it would open."""
    assert not Check(draw(33), "definition")._moves
    assert Check(draw(0), "definition")._moves
    assert checked(33)[2] is None


def test_places_that_are_told_twice_are_told_by_doubles():
    """The square of 3e-5 beside offsets of one has 6 digits, and is off the other place by them."""
    assert draw(898)["loops"] == []
    assert checked(898)[2] is None


def test_what_kane_calls_dependent_is_solved_for_beside_a_quaternion():
    """Its four coordinates have three speeds, so that the others' places differ by one."""
    model = Check(draw(881), "kane").model
    assert model.positions[1].has(model.method.q[-1])


def test_speeds_that_constraints_hold_at_zero_are_zero():
    assert draw(2530)["u"][1:] == [0.0, 0.0]


def test_speeds_are_fitted_before_numbers_get_units():
    """With speeds that hold the cosine of a length, in units of that."""
    data = physical(draw(2360))
    world = World(data, data["q"], data["u"])
    assert np.all(np.abs(world.residual) <= 1e-12 * world.A_size @ world.natural)


def test_a_configuration_in_large_units_is_near():
    """A quaternion was searched for at a distance of 22, beside lengths of 740, in vain."""
    assert Check(draw(1570), "definition").system.states


def test_hinges_are_nearly_parallel_or_their_twists_are_constants_of_zero():
    drawn = [draw(seed) for seed in range(TWISTED, TWISTED + 60)]
    tilts = [{abs(v) for body in data["bodies"] for v in body["tilt"]} for data in drawn]
    assert sum(QUARTER in found for found in tilts) > 10
    assert sum(any(0 < v < 1e-6 for v in found) for found in tilts) > 10
    still = [data for data in drawn if set(data["named"]) - {p for p, _ in leaves(data)}]
    assert len(still) > 5
    model = Check(still[0], "definition").model
    assert 0.0 in model.constants.values()


def test_energies_are_compared_at_states_that_are_some():
    """Quaternions of another length are none, and a spring's energy is written for length one."""
    assert checked(2707)[2] is None


def test_an_order_of_states_that_is_not_the_users_is_found(monkeypatch):
    def reordered(data):
        model = permuted(data)
        model.order = model.order[::-1]
        return model

    monkeypatch.setattr("mechanisms.check.permuted", reordered)
    with pytest.raises(DisagreementError, match="permuted: order of states"):
        check(draw(34), ["definition"], ["orders"])


def test_a_way_back_that_leads_elsewhere_is_found(monkeypatch):
    simulate = System.simulate

    def forwards(system, **options):
        system.times = np.sort(system.times)
        return simulate(system, **options)

    check(draw(4), ["definition"], ["returns"])
    monkeypatch.setattr(System, "simulate", forwards)
    with pytest.raises(DisagreementError, match="definition: return"):
        check(draw(4), ["definition"], ["returns"])


def test_an_assumption_that_a_motion_leaves_without_a_word_is_found(monkeypatch):
    check(draw(4), ["definition"], ["assumptions"])
    monkeypatch.setattr("pydy._assembly.assumptions.Assumptions.tell", lambda *_, **__: None)
    with pytest.raises(DisagreementError, match="warnings of an assumption"):
        check(draw(4), ["definition"], ["assumptions"])


@pytest.mark.parametrize("seed", range(12))
def test_a_block_on_a_slope_follows_its_parabolas(seed):
    contacts.check(contacts.draw(seed))


def test_a_wrong_contact_is_found_and_shrunk(monkeypatch):
    made = contacts.contacts

    def slippery(data, times):
        return made(data | {"friction": 0.9 * data["friction"]}, times)

    monkeypatch.setattr(contacts, "contacts", slippery)
    block = contacts.draw(1)
    with pytest.raises(contacts.DisagreementError, match="the parabolas say") as found:
        contacts.check(block)
    least = contacts.shrunk(block)
    assert least["units"] == [1.0, 1.0, 1.0]
    assert sum(least[name] == value for name, value in contacts.SIMPLER.items()) >= 6
    assert "Found by seed 1: block: " in contacts.script(least, found.value)
