"""Python's cycle collector while graphs are built."""

import gc
import weakref

from pydy._graph.collector import collector_paused


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
        assert gc.get_freeze_count() == count > 0
    finally:
        gc.unfreeze()


class Cycle(list):
    """A list that can be referred to weakly."""


def test_garbage_of_many_pauses_is_collected():
    first = Cycle()
    first.append(first)
    known = weakref.ref(first)
    del first
    for _ in range(10 * (1 + len(gc.get_objects()) // 20_000)):
        with collector_paused():
            for _ in range(20_000):
                garbage = []
                garbage.append(garbage)
        if known() is None:
            break
    assert known() is None


def test_nothing_is_collected_where_a_threshold_of_zero_forbids_it():
    before = gc.get_threshold()
    first = Cycle()
    first.append(first)
    known = weakref.ref(first)
    gc.collect()
    del first
    gc.set_threshold(0)
    try:
        for _ in range(3 * (1 + len(gc.get_objects()) // 20_000)):
            with collector_paused():
                kept = [[k] for k in range(20_000)]
        assert known() is not None
        assert len(kept) == 20_000
    finally:
        gc.set_threshold(*before)
