"""Live pages as far as Python makes them; `tests/browser/test_live.py` opens them."""

import json
import re

import numpy as np
import pytest
import sympy as sm
import sympy.physics.mechanics as me

import zoo
from pydy.inputs import SampledInput
from pydy.mechanics import Definition
from pydy.system import System
from pydy.viz import Box, Line, Live, Scene, Slider, Sphere, Visual
from pydy.viz.arguments import live_unknowns
from pydy.viz.defaults import default_shape, inertial_lengths
from zoo.cases import system_of
from zoo.exported_models import TIMES, ball, hostile, pendulum


def page(system, live, *visuals, **options):
    return system.scene(*visuals, **options).animate(system.simulate()).html(live=live)


def data_of(html):
    return json.loads(re.search(r'id="pydy-data">(.*?)</script>', html, re.DOTALL)[1])


def test_constants_states_and_inputs_have_sliders_by_symbol_or_name():
    system = pendulum()
    html = page(system, {sm.Symbol("l0"): (0.1, 2.0), "q1": (-3, 3), "F": (-5, 5, 1.5, "N")})
    rows = data_of(html)["live"]["sliders"]
    assert [(r["label"], r["group"], r["value"]) for r in rows] == [
        ("l0", "p", 0.7),
        ("q1", "x", 0.4),
        ("F", "r", 1.5),
    ]
    assert rows[2]["unit"] == "N"


def test_the_page_stays_below_a_megabyte_beside_three():
    from pydy.viz.page import _resource

    assert len(page(pendulum(), {"l0": (0.1, 2)})) - len(_resource("three.min.js")) < 1_000_000


def test_arrows_whose_scale_is_chosen_have_it_on_the_page():
    system = pendulum()
    animated = system.scene(loads=True).animate(system.simulate())
    chosen = [item for item in animated._animation.items if item.vectors is not None]
    arrows = data_of(animated.html(live={"l0": (0.1, 2)}))["live"]["arrows"]
    given = [pair[1] for pair in arrows if pair is not None]
    assert given == [item.shape.scale for item in chosen]
    assert len(given) >= 1
    assert min(given) > 0.0


def test_curves_are_computed_apart_from_the_poses():
    # A step between two pictures computes its curves alone. The angle itself is a state.
    system = pendulum()
    q1 = system.coordinates[1]
    sizes = []
    for series in ([], [q1, sm.sin(q1), sm.cos(q1)]):
        html = page(system, {"l0": (0.1, 2)}, series=series)
        sizes.append([int(re.search(rf"{k}_size: (\d+)", html)[1]) for k in ("poses", "formulas")])
    assert sizes[0][0] == sizes[1][0] > 0
    assert [formulas for _, formulas in sizes] == [0, 2]


def test_nothing_makes_code_of_text():
    from pydy.viz.page import _resource

    html = page(pendulum(), {"l0": (0.1, 2)}).replace(_resource("three.min.js"), "")
    assert not re.search(r"\beval\(|\bnew Function\b|\bimport\(|setTimeout\(\s*[\"'`]", html)
    assert "unsafe" not in re.search(r'Security-Policy" content="([^"]*)"', html)[1]


def test_hostile_names_are_data():
    system = hostile()
    sliders = {s: Slider(1, 5, unit="</script><b>", label="<img src=x>")
               for s in system.constants_symbols}  # fmt: skip
    html = page(system, sliders, title="</script>{{APP}}/*CODE*/")
    assert "<img src=x>" not in html
    assert html.count("</script>") == html.count("<script")
    assert data_of(html)["live"]["sliders"][0]["unit"] == "</script><b>"


def test_a_page_without_sliders_is_as_before():
    system = pendulum()
    assert "liveModel" not in system.scene().animate(system.simulate()).html()


def test_a_slider_of_ones_own_sets_initial_conditions():
    system = pendulum()
    v = sm.Symbol("v")
    live = {v: Slider(0, 3, 1.0, "m/s", sets={"u0": v, system.speeds[1]: -2 * v})}
    data = data_of(page(system, live))["live"]
    assert data["starts"] == [3, 4]
    assert data["sliders"][0]["place"] == len(system.constants_symbols)


@pytest.mark.parametrize(
    ("live", "words"),
    [
        ({"l9": (0, 1)}, "`live` has `l9`, which is not one of the system's constants, states"),
        ({"l00": (0, 1)}, r"Did you mean `l0`\? A slider of your own"),
        ({"l0": 3}, r"`live\[l0\]` must be a Slider or a range such as \(0.1, 2.0\), got 3"),
        ({"l0": (2, 1)}, "`low` of Slider must be less than `high`, got 2.0 and 1.0"),
        ({"l0": (0, 1, 3)}, "`value` of Slider must be from `low` to `high`, 0.0 to 1.0, got 3.0"),
        ({"l0": (0.8, 1)}, r"`live\[l0\]` must include the system's own value, 0.7, got the range"),
        ({"q1": Slider(0.5, 1)}, r"`live\[q1\]` .* 0.4, got the range 0.5 to 1.0: widen"),
        ({sm.Symbol("v"): Slider(0, 1, sets={"u0": 1})}, "symbol of your own, needs a `value`"),
        ({"l0": Slider(0, 1, sets={"u0": 1})}, "`sets` of the slider for `l0` is for symbols"),
        ({sm.Symbol("v"): Slider(0, 1, 0.5, sets={"z": 1})}, "has `z`, which is no state"),
        ({"l0": (0, 1), sm.Symbol("l0"): (0, 2)}, "`live` gives `l0` more than once"),
        (
            {sm.Symbol("v"): Slider(0, 1, 0.5, sets={"u0": 1, me.dynamicsymbols("u0"): 2})},
            r"`sets` gives `u0\(t\)` more than once",
        ),
    ],
)
def test_what_cannot_have_a_slider_is_named(live, words):
    with pytest.raises(ValueError, match=words):
        page(pendulum(), live)


@pytest.mark.parametrize("value", [lambda x, t: t, SampledInput([0.0, 2.0], [0.0, 1.0])])
def test_a_specified_that_only_python_can_compute_is_named(value):
    system = pendulum()
    system.specifieds = {"F": value}
    with pytest.raises(
        ValueError, match=r"`specifieds` gives `F\(t\)` by .* run in a live page.*slider"
    ):
        page(system, {"l0": (0.1, 2)})


def test_a_scene_without_a_system_cannot_simulate():
    system = pendulum()
    other = system.scene()
    scene = Scene(other.reference_frame, other.origin, *other.visuals)
    scene.animate(system.simulate())
    with pytest.raises(ValueError, match=r"make the scene with `system.scene\(...\)`"):
        scene.html(live={"l0": (0.1, 2)})


def test_series_that_are_only_numbers_are_named():
    system = pendulum()
    scene = system.scene().animate(system.simulate(), series={"noise": np.zeros(len(TIMES))})
    with pytest.raises(ValueError, match="The series 'noise' was given to `animate` as numbers"):
        scene.html(live={"l0": (0.1, 2)})


def test_other_runs_are_not_simulated():
    system = pendulum()
    run = system.simulate()
    other = pendulum()
    other.initial_conditions = {"q1": 1.0}
    scene = system.scene().animate(run, compare=other.simulate())
    with pytest.raises(ValueError, match="shows no other runs beside it"):
        scene.html(live={"l0": (0.1, 2)})


def test_what_a_slider_moves_apart_shares_no_track():
    system = pendulum()
    point = system.scene().visuals[1].point
    visuals = [Visual(Sphere(0.1), point), Visual(Box(1, 1, 1), point)]
    tip = point.locatenew("tip", sm.Symbol("l0") * system.scene().reference_frame.x)
    visuals.append(Visual(Sphere(0.1), tip))
    fixed = data_of(page(system, {"m1": (0.5, 2)}, *visuals))
    moved = data_of(page(system, {"l0": (0.5, 2)}, *visuals))
    assert len(fixed["tracks"]) == 1
    assert len(moved["tracks"]) == 2


def test_constraints_and_tolerances_are_those_that_live_has():
    system, bounce = ball()
    with pytest.raises(ValueError, match="holds constraints, but the system has none"):
        page(system, Live({"y": (0, 2)}, constraints="project"))
    with pytest.raises(ValueError, match="`rtol` of Live must be positive"):
        Live({}, rtol=0.0)
    data = data_of(page(system, Live({"y": (0, 2)}, events=bounce, rtol=1e-6)))
    assert data["live"]["options"]["rtol"] == 1e-6


def test_a_page_solves_for_what_has_no_slider():
    # Two of three coordinates depend on the third, and two of the speeds.
    states = ("a", "b", "c", "u", "v", "w")
    determined = ([1, 2], [4, 5])
    assert live_unknowns(set(), determined, (3, 3), states) == [[1, 2], [4, 5]]
    assert live_unknowns({0}, determined, (3, 3), states) == [[1, 2], [4, 5]]
    assert live_unknowns({2, 4}, determined, (3, 3), states) == [[0, 1], [3, 5]]
    # Where it is not known which depend on which, all without a slider are solved for.
    assert live_unknowns({1}, ([0, 1, 2], [3]), (3, 1), states) == [[0, 2], [3]]
    with pytest.raises(ValueError, match=r"`live` sets the coordinates `a`, `b`, but .* 2 of 3"):
        live_unknowns({0, 1}, determined, (3, 3), states)


def test_a_page_solves_for_what_the_system_solved_for_last():
    system = system_of(zoo.fourbar(), times=[0.0, 0.1])
    frame, origin = me.ReferenceFrame("N"), me.Point("O")
    scene = system.scene(Visual(Sphere(0.1), origin), reference_frame=frame, origin=origin)
    assert system._live_system().dependents == ([1, 2], [4, 5])
    system.set_dependent_initial_conditions(dep_vars=["q1", "q2", "u1", "u2"])
    assert system._live_system().dependents == ([0, 1], [3, 4])
    scene.animate(system.simulate())
    with pytest.raises(ValueError, match=r"sets the speeds `u1.*`, `u2.*`.*leave sliders out"):
        scene.html(live={"u1": (-20.0, 20.0), "u2": (-20.0, 20.0)})


@pytest.mark.parametrize("length", [1e-9, 1.0, 1e9])
def test_what_a_slider_moves_is_no_part_of_a_rigid_body_at_any_size(length):
    q, u, l = *me.dynamicsymbols("q u"), sm.Symbol("l")
    N, O = me.ReferenceFrame("N"), me.Point("O")
    A = N.orientnew("A", "Axis", (q, N.z))
    A.set_ang_vel(N, u * N.z)
    P, R = O.locatenew("P", l * A.x), O.locatenew("R", length * A.x)
    for point in (O, P):
        point.set_vel(N, 0 if point is O else l * u * A.y)
    kane = me.KanesMethod(N, [q], [u], kd_eqs=[q.diff() - u])
    kane.kanes_equations([me.Particle("bob", P, 1)], [(P, -l * N.y)])
    system = System(kane, constants={l: length}, initial_conditions={q: 0.3, u: 0.0})
    system.times = np.linspace(0.0, 1.0, 11)
    visuals = [Visual(Sphere(length / 10), A, point) for point in (O, P, R)]
    scene = system.scene(*visuals, reference_frame=N, origin=O).animate(system.simulate())
    tracks = [v["track"] for v in data_of(scene.html(live={l: (length / 2, length)}))["visuals"]]
    assert tracks == [0, 1, 0]


@pytest.mark.parametrize(
    ("moments", "lengths"),
    [
        ((0.02, 0.02, 0.02), ["radius"]),  # a sphere
        ((0.02, 0.02, 0.01), ["radius", "length"]),
        ((0.02, 0.02, 0.039), ["radius", "length"]),  # a disc, not thinner than is seen
        ((0.02, 0.01, 0.025), ["x", "y", "z"]),
        ((0.0, 0.0, 0.025), ["radius", "length"]),  # of motion in a plane
    ],
)
def test_default_shapes_follow_the_sliders_of_mass_and_inertia(moments, lengths):
    a, w = me.dynamicsymbols("a w")
    m, *inertias = sm.symbols("m I1:4")
    N, O = me.ReferenceFrame("N"), me.Point("O")
    B = N.orientnew("B", "Axis", (a, N.z))
    B.set_ang_vel(N, w * N.z)
    O.set_vel(N, 0)
    C = O.locatenew("C", 0.3 * B.x)
    C.set_vel(N, 0.3 * w * B.y)
    body = me.RigidBody("body", C, B, m, (me.inertia(B, *inertias), C))
    numbers = {m: 2.0, **dict(zip(inertias, moments, strict=True))}
    system = System(
        Definition(N, [a], [w], bodies=[body], loads=[(C, -m * N.y)]), numbers,
        constants_symbols=[*numbers], times=[0.0, 1.0], ode_solver="dop853",
    )  # fmt: skip
    scene = system.scene(Visual(None, body)).animate(system.simulate())
    data = data_of(scene.html(live={m: (0.5, 8.0)}))
    assert data["live"]["sizes"] == [[0, name] for name in lengths]
    shape = default_shape(body, numbers, 0.3)
    for change in ({m: 7.0}, {inertias[2]: 0.021}):
        expected = default_shape(body, {**numbers, **change}, 0.3)
        found = inertial_lengths(body, shape, numbers)
        if type(expected) is type(shape):  # a sphere has three equal moments
            for name, length in found.items():
                value = float(length.xreplace({**numbers, **change}))
                assert value == pytest.approx(getattr(expected, name), rel=1e-9)


def test_lines_go_through_the_points_of_their_ends_wherever_sliders_move_these():
    """A slider moves the far end of a line at rest: its points are those of the page's poses."""
    q, u, base, l = *me.dynamicsymbols("q u"), *sm.symbols("base l")
    N, O = me.ReferenceFrame("N"), me.Point("O")
    A = N.orientnew("A", "Axis", (q, N.z))
    A.set_ang_vel(N, u * N.z)
    P, Q = O.locatenew("P", l * A.x), O.locatenew("Q", base * N.x)
    O.set_vel(N, 0)
    P.set_vel(N, l * u * A.y)
    particle = me.Particle("bob", P, 1)
    model = Definition(N, [q], [u], bodies=[particle], loads=[(P, -N.y)])
    system = System(
        model, {l: 0.5, base: 2.0}, constants_symbols=[l, base], times=[0.0, 1.0],
        ode_solver="dop853",
    )  # fmt: skip
    ends = [Visual(Sphere(0.1), point, name=point.name) for point in (O, P, Q)]
    lines = [Visual(Line(points), name=name) for name, points in
             [("ground", (O, Q)), ("coupler", (Q, P, O))]]  # fmt: skip
    scene = system.scene(*lines, *ends, reference_frame=N, origin=O).animate(system.simulate())
    data = data_of(scene.html(live={base: (1.0, 3.0)}))
    visuals, live = data["visuals"], data["live"]
    places = {v["name"]: k for k, v in enumerate(visuals)}
    of_lines = {name: live["lines"][places[name]] for name in ("ground", "coupler")}
    # Points that a slider moves apart are on different tracks.
    point = {name: live["tracks"][visuals[places[name]]["track"]][1] for name in ("O", "P", "Q")}
    assert len({*point.values()}) == 3
    assert of_lines["ground"] == [point["O"], point["Q"]]
    assert of_lines["coupler"] == [point["Q"], point["P"], point["O"]]
    assert all(live["lines"][places[name]] is None for name in ("O", "P", "Q"))
