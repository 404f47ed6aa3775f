"""Codes of how an integration ended."""

import string

import numpy as np
import pytest

from pydy._errors import IntegrationError
from pydy.solvers import dop853, rk4
from pydy.solvers.outcome import Outcome


def test_codes_and_names_are_different_from_each_other():
    members = Outcome.__members__  # with aliases, if there were any
    assert [*map(int, members.values())] == list(range(-1, len(members) - 1))
    assert len({outcome.flag for outcome in Outcome}) == len(members)


@pytest.mark.parametrize("outcome", [o for o in Outcome if o.text.startswith("met")])
def test_failures_have_a_remedy(outcome):
    assert outcome.remedy.endswith(".")


def test_names_are_flags_of_the_climate_and_forecast_conventions():
    allowed = set(string.ascii_lowercase + "_")
    assert all(set(outcome.flag) <= allowed for outcome in Outcome)


@pytest.mark.parametrize(
    ("f", "code"),
    [
        (lambda x, t: x, Outcome.FINISHED),
        (lambda x, t: x * np.nan, Outcome.NOT_FINITE),
        (lambda x, t: x**2, Outcome.STEP_UNDERFLOW),
    ],
)
def test_info_holds_the_code_that_the_words_are_made_from(f, code):
    try:
        _, info = dop853(f, [1.0], [0.0, 2.0], full_output=True)
    except IntegrationError as error:
        info = error.info
    assert info["code"] == code
    assert info["status"].startswith(Outcome(code).text.format(size=""))


def test_steps_of_fixed_size_that_are_too_many_have_their_code():
    with pytest.raises(IntegrationError, match="took 3 steps") as caught:
        rk4(lambda x, t: x, [1.0], [0.0, 1.0], step=0.01, max_steps=3)
    assert caught.value.info["code"] == Outcome.TOO_MANY_STEPS
