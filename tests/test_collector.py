"""Python's cycle collector while graphs are built."""

import gc
import weakref

import pytest

from pydy._collector import collector_paused


def test_what_was_built_is_not_walked_through_at_once():
    with collector_paused():
        made = [[k] for k in range(100)]
    assert not any(item is made for item in gc.get_objects(generation=0))
    assert any(item is made for item in gc.get_objects())


def test_what_others_froze_stays_frozen():
    gc.freeze()
    try:
        count = gc.get_freeze_count()
        with collector_paused():
            pass
        # Single frozen objects may die meanwhile; thawed, there are none.
        assert gc.get_freeze_count() > count / 2 > 0
    finally:
        gc.unfreeze()


class Cycle(list):
    """A list that can be referred to weakly."""


@pytest.fixture
def thresholds():
    before = gc.get_threshold()
    yield gc.set_threshold
    gc.set_threshold(*before)


def a_cycle_is_left_of_many_pauses():
    first = Cycle()
    first.append(first)
    known = weakref.ref(first)
    gc.collect()
    assert known() is not None  # `first` holds it
    del first
    for _ in range(10 * (1 + len(gc.get_objects()) // 20_000)):
        with collector_paused():
            for _ in range(20_000):
                garbage = []
                garbage.append(garbage)
        if known() is None:
            return False
    return True


def test_garbage_of_many_pauses_is_collected(thresholds):
    thresholds(700, 10, 10)
    assert not a_cycle_is_left_of_many_pauses()


@pytest.mark.parametrize("own", [(0, 10, 10), (10_000, 1000, 1000)], ids=["never", "seldom"])
def test_nothing_is_collected_before_the_thresholds_would_have_it(thresholds, own):
    thresholds(*own)
    assert a_cycle_is_left_of_many_pauses()
