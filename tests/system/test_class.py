"""What System is as a class: its errors, pickles and attributes."""

import inspect
import pickle

import pytest

from pydy.models import multi_mass_spring_damper
from pydy.system import System


def test_a_wrong_argument_is_reported_with_the_name_of_the_class():
    with pytest.raises(TypeError, match=r"^System\.__init__\(\) got an unexpected .* 'constant'"):
        System(None, constant={})
    with pytest.raises(TypeError, match=r"^System\.generate_ode_function\(\) takes 1 positional"):
        multi_mass_spring_damper().generate_ode_function("cython")


def test_each_method_is_found_by_its_name_in_a_pickle():
    methods = inspect.getmembers(System, inspect.isfunction)
    assert len(methods) > 30
    for name, method in methods:
        assert pickle.loads(pickle.dumps(method)) is getattr(System, name)


def test_a_misspelt_attribute_is_told_all_that_can_be_set():
    with pytest.raises(AttributeError, match=r"no attribute `constant`.*Did you mean `constants`"):
        multi_mass_spring_damper().constant = {}


def test_a_subclass_has_attributes_of_its_own():
    class Walker(System):
        pass

    walker = Walker(multi_mass_spring_damper().eom_method)
    walker.feet = 2
    assert walker.feet == 2
    assert len(walker.states) == 2
