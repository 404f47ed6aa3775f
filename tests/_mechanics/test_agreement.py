"""When the equations that a method derived are replaced by those formed from its bodies."""

from pydy.system import System
from rolling import ball_on_a_turntable


def test_entries_that_cancel_but_for_rounding_are_no_difference(caplog):
    with caplog.at_level("INFO", logger="pydy"):
        system = System(ball_on_a_turntable().kane)
    assert "other numbers" not in caplog.text
    assert system._equations.formed is not None
