"""Python's cycle collector while graphs are built."""

import gc

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
