"""What a digest tells apart, and what it refuses."""

import numpy as np
import pytest

from pydy.ensemble.content import digest
from pydy.solvers.sensitivities import ParameterSize


@pytest.mark.parametrize(
    "value",
    [
        None,
        "θ",
        [1, 2.5, "a"],
        {"a": (1, 2)},
        np.arange(6.0).reshape(2, 3),
        np.array(["a", "bc"]),
        np.array(["2020-01-01"], "M8[D]"),
        np.zeros((0, 3)),
        np.array(1.0),
        np.float64(1.0),
        ParameterSize("x", 3),
    ],
    ids=repr,
)
def test_equal_content_is_equal_whatever_object_holds_it(value):
    again = value.copy(order="F") if isinstance(value, np.ndarray) else eval(
        repr(value), {"np": np, "ParameterSize": ParameterSize}
    )  # fmt: skip
    assert digest(again) == digest(value)


def test_equal_texts_are_the_same_whether_or_not_they_are_one_object():
    assert digest(["ab", "ab"]) == digest(["ab", "".join(["a", "b"])])


@pytest.mark.parametrize(
    ("one", "other"),
    [
        (1, 1.0),
        (0.0, -0.0),
        (1, True),
        ("1", 1),
        ([1], (1,)),
        ("", None),
        ({"a": 1, "b": 2}, {"b": 2, "a": 1}),
        (np.zeros(2), np.zeros(2, dtype=np.float32)),
        (np.zeros((2, 3)), np.zeros((3, 2))),
        (np.array([0.0]), np.array([-0.0])),
        (np.array(1.0), np.array([1.0])),
        (np.array([1.0, 2.0]), np.array([1.0, np.nextafter(2.0, 3.0)])),
        ([[1], 2], [[1, 2]]),
    ],
    ids=repr,
)
def test_other_content_is_another(one, other):
    assert digest(one) != digest(other)


@pytest.mark.parametrize(
    "thing", [len, lambda: 0, object(), {1, 2}, np.array([None]), np.zeros(1, [("a", float)])]
)
def test_what_would_be_known_by_its_name_or_address_alone_is_refused(thing):
    with pytest.raises(TypeError, match="no digest of an object of the type"):
        digest([thing])
