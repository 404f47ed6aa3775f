"""A System prints itself."""

import re

import numpy as np
import pytest
import sympy as sm
import sympy.physics.mechanics as me

import zoo
from pydy.mechanics import Definition
from pydy.models import n_link_pendulum_on_cart
from pydy.system import System


@pytest.fixture
def system():
    return n_link_pendulum_on_cart(2, joint_torques=True)


def lines(system):
    return dict(re.findall(r"^  (\S+) +(.*)$", repr(system), re.MULTILINE))


def test_a_system_shows_values_and_marks_defaults(system):
    system.constants = {next(iter(system.constants_symbols)): 9.81}
    system.initial_conditions = {system.states[1]: 0.5}
    system.times = np.linspace(0.0, 2.0, 5)
    system.ode_solver = "dop853"
    shown = lines(system)
    assert shown["constants"].startswith("g = 9.81, l0 = (1.0)")
    assert shown["states"].startswith("q0 = (0.0), q1 = 0.5")
    assert shown["times"] == "0 to 2, 5 of them"
    assert shown["solver"] == "dop853"
    assert "constraints" not in shown


def test_specifieds_of_every_kind_are_shown(system):
    force, first, second = sorted(system.specifieds_symbols, key=str)

    def push(x, t):
        return [1.0, 2.0]

    system.specifieds = {(force, first): push, second: sm.sin(system.states[0])}
    assert lines(system)["specifieds"] == "F = push(x, t), T1 = push(x, t), T2 = sin(q0(t))"
    system.specifieds = {"symbols": (second, first, force), "values": [1.0, 2.0, 3.0]}
    assert lines(system)["specifieds"] == "T2 = 1, T1 = 2, F = 3"


def test_derivatives_of_a_prescribed_motion_are_shown_as_those_of_its_expression():
    q, u, lift = me.dynamicsymbols("q, u, lift")
    m = sm.Symbol("m")
    N, O, P = me.ReferenceFrame("N"), me.Point("O"), me.Point("P")
    O.set_vel(N, 0)
    P.set_pos(O, (q + lift) * N.x)
    system = System(Definition(N, [q], [u], bodies=[me.Particle("bead", P, m)]))
    assert lines(system)["specifieds"].count("(0.0)") == len(system.specifieds_symbols)
    system.specifieds = {lift: sm.sin(me.dynamicsymbols._t)}
    assert "(t, 2)) = (from the expression for lift)" in lines(system)["specifieds"]
    system.specifieds = {lift: 0.5}
    assert "(t, 2)) = (0.0)" in lines(system)["specifieds"]


def test_constraints_are_counted():
    shown = lines(System(zoo.track().kane))
    assert shown["constraints"] == "1 holonomic, 1 nonholonomic"


def test_a_system_prints_even_when_its_dictionaries_are_wrong(system):
    system.specifieds["nonsense"] = 3.0
    system.outputs[sm.Symbol("k")] = sm.Symbol("unknown")
    system.times.setflags(write=True)
    assert repr(system).startswith("System")


def test_jupyter_gets_a_table_in_which_nothing_is_markup(system):
    system.specifieds = {"symbols": tuple(system.specifieds_symbols), "values": lambda x, t: 0}
    html = system._repr_html_()
    assert html.startswith("<table>")
    assert "<lambda>" not in html
    assert "&lt;lambda&gt;" in html


def test_a_trajectory_is_a_table_of_its_states_in_jupyter(system):
    system.initial_conditions = {system.states[1]: 0.5}
    system.times = [0.0, 0.5, 1.0]
    html = system.simulate()._repr_html_()
    assert html.count("<tr>") == 1 + system.num_states
    assert re.search(">q1</th><td[^>]*>0.5</td>", html)
