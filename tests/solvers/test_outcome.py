"""Codes of how an integration ended."""

import string

import numpy as np
import pytest

from pydy._errors import IntegrationError
from pydy.solvers import dop853, outcome, rk4
from pydy.solvers.outcome import OUTCOMES


def test_codes_and_names_are_different_from_each_other():
    codes = [getattr(outcome, name) for name in vars(outcome) if name.isupper()]
    codes = [code for code in codes if isinstance(code, int)]
    assert sorted(codes) == list(range(-1, len(OUTCOMES) - 1)) == sorted(OUTCOMES)
    assert len({o.name for o in OUTCOMES.values()}) == len(OUTCOMES)


@pytest.mark.parametrize("code", [c for c in OUTCOMES if OUTCOMES[c].text.startswith("met")])
def test_failures_have_a_remedy(code):
    assert OUTCOMES[code].remedy.endswith(".")


def test_names_are_flags_of_the_climate_and_forecast_conventions():
    allowed = set(string.ascii_lowercase + "_")
    assert all(set(o.name) <= allowed for o in OUTCOMES.values())


@pytest.mark.parametrize(
    ("f", "code"),
    [
        (lambda x, t: x, outcome.FINISHED),
        (lambda x, t: x * np.nan, outcome.NOT_FINITE),
        (lambda x, t: x**2, outcome.STEP_UNDERFLOW),
    ],
)
def test_info_holds_the_code_that_the_words_are_made_from(f, code):
    try:
        _, info = dop853(f, [1.0], [0.0, 2.0], full_output=True)
    except IntegrationError as error:
        info = error.info
    assert info["code"] == code
    assert info["status"].startswith(OUTCOMES[code].text.format(size=""))


def test_steps_of_fixed_size_that_are_too_many_have_their_code():
    with pytest.raises(IntegrationError, match="took 3 steps") as caught:
        rk4(lambda x, t: x, [1.0], [0.0, 1.0], step=0.01, max_steps=3)
    assert caught.value.info["code"] == outcome.TOO_MANY_STEPS
