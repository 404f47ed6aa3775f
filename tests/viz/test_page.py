"""The page: complete in itself, small, and safe whatever the names are."""

import html
import json
import re
import shutil
import subprocess
from base64 import b64decode, b64encode
from hashlib import sha256
from importlib.resources import files
from types import SimpleNamespace

import numpy as np
import pytest
import sympy as sm
from sympy.physics.mechanics import Point, ReferenceFrame, dynamicsymbols

from pydy.contact import Contacts
from pydy.trajectory import EventRecord, Trajectory
from pydy.viz import Arrow, Box, Line, Mesh, Scene, Sphere, Trace, Visual
from pydy.viz.arguments import mode_intervals
from pydy.viz.page import page_data
from zoo.touching import ball, y

q = dynamicsymbols("q")
N, O = ReferenceFrame("N"), Point("O")
B = N.orientnew("B", "Axis", (q, N.z))
P = O.locatenew("P", 2 * B.x)
TIMES = np.linspace(0, 60, 3601)
EVIL = '</script><script>alert(1)</script><!-- {{APP}} "&\u2028'


def scene(*visuals, states=None, **options):
    states = np.sin(TIMES)[:, None] if states is None else states
    return Scene(N, O, *visuals, **options).animate(TIMES, states, symbols=[q])


def data_of(scene):
    return page_data(scene._animation, scene._settings)


def floats(text, dtype="<f4"):
    return np.frombuffer(b64decode(text), dtype)


def test_a_folder_that_is_not_there_is_named(tmp_path):
    scene = Scene(N, O, Visual(Sphere(1.0), O)).animate([0.0], np.zeros((1, 0)), symbols=[])
    for write in (scene.to_html, scene.save):
        with pytest.raises(FileNotFoundError, match=r"there is no folder .*nowhere"):
            write(tmp_path / "nowhere" / "page.html")


def test_the_page_is_one_file_that_asks_for_nothing(tmp_path):
    path = scene(Visual(Sphere(1), P)).to_html(tmp_path / "out.html")
    text = path.read_text(encoding="utf-8")
    assert "default-src 'none'" in text
    assert "{{" not in re.sub(r"<script>.*?</script>", "", text, flags=re.DOTALL)
    own = text.replace((files("pydy.viz") / "assets/three.min.js").read_text(encoding="utf-8"), "")
    assert not re.search(r"\b(src|href)=(?![\"']data:)", own)
    assert not re.search(r"fetch\(|XMLHttpRequest|import\(|url\(", own)


def test_a_browser_runs_the_pages_own_scripts_only():
    text = scene(Visual(Sphere(1), P), title="{{POLICY}}").html()
    policy = re.search(r'Security-Policy" content="([^"]*)"', text)[1]
    assert "unsafe" not in policy
    for kind in ("script", "style"):
        allowed = re.search(rf"{kind}-src ([^;]*)", policy)[1].split()
        own = re.findall(rf"<{kind}>(.*?)</{kind}>", text, re.DOTALL)
        hashes = [b64encode(sha256(part.encode()).digest()).decode() for part in own]
        assert allowed == [f"'sha256-{value}'" for value in hashes]


def test_the_licence_of_three_comes_along():
    assert "Copyright © 2010-2026 three.js authors" in scene(Visual(Sphere(1), P)).html()


def test_text_from_users_cannot_leave_its_place():
    made = scene(Visual(Sphere(1), P, name=EVIL), title=EVIL, series={EVIL: q})
    text = made.html()
    assert EVIL not in text
    assert "alert(1)</script" not in text
    assert f"<title>{html.escape(EVIL)}</title>" in text
    raw = re.search(r'id="pydy-data">(.*?)</script>', text, re.DOTALL)[1]
    data = json.loads(raw)
    assert data["title"] == data["visuals"][0]["name"] == data["series"][0]["label"] == EVIL
    assert "<" not in raw


def test_in_a_notebook_it_is_an_iframe_with_the_same_page():
    made = scene(Visual(Sphere(1), P, name=EVIL))
    text = made._repr_html_()
    assert text.startswith("<iframe")
    source = re.search(r'srcdoc="([^"]*)"', text)[1]
    assert html.unescape(source) == made.html()


def test_the_theme_can_be_fixed():
    assert 'data-theme="dark"' in scene(Visual(Sphere(1), P)).html(theme="dark")
    with pytest.raises(ValueError, match="`theme` must be one of 'auto', 'light', 'dark'"):
        scene(Visual(Sphere(1), P)).html(theme="pink")


def test_tracks_hold_the_poses():
    data = data_of(scene(Visual(Sphere(1), B, P)))
    (track,) = data["tracks"]
    places = data["view"]["unit"] * floats(track["p"]["rows"]).reshape(-1, 3)
    assert places[:, 0] == pytest.approx(2 * np.cos(np.sin(TIMES)), abs=1e-6)
    turns = floats(track["q"]["rows"]).reshape(-1, 4)
    assert turns[:, 2] == pytest.approx(np.sin(np.sin(TIMES) / 2), abs=1e-6)
    assert floats(data["times"], "<f8") == pytest.approx(TIMES)


def test_quaternions_never_jump_to_the_other_side():
    data = data_of(scene(Visual(Sphere(1), B, P), states=3 * TIMES[:, None]))
    turns = floats(data["tracks"][0]["q"]["rows"]).reshape(-1, 4)
    assert (np.einsum("ij,ij->i", turns[1:], turns[:-1]) > 0.9).all()


def test_parts_of_one_body_share_a_track():
    fixed = [P.locatenew(f"p{k}", k * B.x + B.z) for k in range(4)]
    data = data_of(
        scene(
            *(Visual(Box(1, 1, 1), B, p) for p in fixed),
            Visual(Line(fixed)),
            Visual(Trace(), B, fixed[1]),
        )
    )
    assert len(data["tracks"]) == 1
    unit = data["view"]["unit"]
    assert unit * np.array(data["visuals"][3]["offset"]) == pytest.approx([3, 0, 0])
    assert unit * np.array(data["visuals"][4]["points"]["fixed"]) == pytest.approx(
        [0, 0, 0, 1, 0, 0, 2, 0, 0, 3, 0, 0]
    )


def test_what_moves_relative_to_a_body_does_not_share_its_track():
    slider = P.locatenew("slider", q * B.x)
    data = data_of(scene(Visual(Box(1, 1, 1), B, P), Visual(Box(1, 1, 1), B, slider)))
    assert len(data["tracks"]) == 2
    loose = data_of(scene(Visual(Line([P, slider])), Visual(Box(1, 1, 1), O)))
    assert floats(loose["visuals"][0]["points"]["rows"]).size == 6 * 3601


def test_what_never_moves_is_stored_once():
    data = data_of(scene(Visual(Box(1, 1, 1), O), Visual(Arrow(N.x), O)))
    assert data["tracks"] == [
        {"p": {"width": 3, "fixed": [0, 0, 0]}, "q": {"width": 4, "fixed": [0, 0, 0, 1]}}
    ]
    assert data["visuals"][1]["vectors"]["fixed"] == [1 / data["view"]["unit"], 0, 0]


def test_meshes_are_scaled_and_stored_as_arrays():
    mesh = Mesh(([[0, 0, 0], [1, 0, 0], [0, 1, 0]], [[0, 1, 2]]), scale=2 * sm.Integer(1))
    data = data_of(scene(Visual(mesh, P)))
    (visual,) = data["visuals"]
    assert data["view"]["unit"] * floats(visual["vertices"]).max() == 2
    assert floats(visual["faces"], "<u4").tolist() == [0, 1, 2]


def test_a_gap_in_a_series_is_no_error():
    made = Scene(N, O, Visual(Sphere(1), P)).animate(
        TIMES, TIMES[:, None], symbols=[q], series={"gap": np.where(TIMES < 1, np.nan, TIMES)}
    )
    assert np.isnan(floats(data_of(made)["series"][0]["values"], "<f8")[:60]).all()
    assert "NaN" not in made.html().split('id="pydy-data">')[1].split("</script>")[0]


def test_a_minute_of_the_bicycle_stays_under_three_megabytes():
    from pydy.examples import bicycle_scene, whipple_bicycle

    bicycle = whipple_bicycle.derive()
    state = whipple_bicycle.equilibrium(bicycle, 5.0)
    symbols = [*bicycle.coordinates, *bicycle.speeds]
    states = np.array([state[s] for s in symbols]) * np.ones((3601, 1))
    for name, motion in {
        "x": 5 * TIMES, "theta_R": -5 / 0.3 * TIMES, "theta_F": -5 / 0.35 * TIMES,
        "delta": 0.1 * np.sin(TIMES), "phi": 0.1 * np.cos(TIMES), "psi": np.sin(TIMES / 9),
    }.items():  # fmt: skip
        states[:, symbols.index(bicycle[name])] = motion
    made = Scene(
        bicycle.frames["N"],
        bicycle.points["O"],
        *bicycle_scene.visuals(bicycle),
        up="-z",
        series=[bicycle["phi"], bicycle["delta"]],
    ).animate(
        TIMES,
        states,
        symbols=symbols,
        constants=whipple_bicycle.benchmark_parameters(bicycle),
        specifieds={bicycle.push: 0.0},
    )
    assert len(made.times) == 3601
    three = len((files("pydy.viz") / "assets/three.min.js").read_bytes())
    assert len(made.html().encode()) - three < 3e6


def test_events_units_and_typeset_labels_are_on_the_page():
    theta = dynamicsymbols("theta_1")
    happened = [EventRecord(t, "hit", 0, np.zeros(1), np.zeros(1)) for t in (0.5, 0.6)]
    trajectory = Trajectory([0.0, 1.0], [[0.0], [1.0]], {"coordinate": [theta]}, events=happened)
    made = Scene(N, O, Visual(Sphere(1), O), series=[theta], units={theta: "rad"})
    data = data_of(made.animate(trajectory))
    assert data["events"] == [{"time": 0.5, "name": "hit"}, {"time": 0.6, "name": "hit"}]
    assert (data["series"][0]["parts"], data["series"][0]["unit"]) == (["θ", "1"], "rad")
    with pytest.raises(TypeError, match=r"`units\[q\(t\)\]` must be a string, got 5"):
        Scene(N, O, units={q: 5})


def test_a_unit_with_a_factor_converts_and_degrees_of_a_state_need_one():
    trajectory = Trajectory([0.0, 1.0], [[0.0], [1.0]], {"coordinate": [q]})
    made = Scene(N, O, Visual(Sphere(1), O), series={"angle": q}, units={"angle": "deg"})
    with pytest.raises(ValueError, match=r"`units\[angle\]` is 'deg', a label for .*180/np.pi\)`"):
        made.animate(trajectory)
    units = {"angle": ("deg", 180 / np.pi)}
    made = Scene(N, O, Visual(Sphere(1), O), series={"angle": q}, units=units)
    drawn = data_of(made.animate(trajectory))["series"][0]
    values = floats(drawn["values"], "<f8")
    assert drawn["unit"] == "deg"
    assert values == pytest.approx([0.0, 57.29577951308232], rel=1e-15)


@pytest.mark.skipif(shutil.which("node") is None, reason="needs Node.js")
def test_a_scale_of_the_strip_has_two_round_numbers_at_least():
    script = (files("pydy.viz") / "assets/strip.js").read_text(encoding="utf-8")
    function = re.search(r"^function ticks\(.*?^}", script, re.S | re.M)[0]
    rng = np.random.default_rng(5)
    spans = 10.0 ** rng.uniform(-12.0, 12.0, 400)
    lows = spans * rng.normal(size=400) * 10.0 ** rng.uniform(-3.0, 3.0, 400)
    cases = [[a, a + span, n] for a, span in zip(lows, spans, strict=True) for n in (2.0, 3.0, 7.4)]
    cases += [[0.1, 3.9, 3], [-1, 1, 3], [0, 1e-300, 4]]
    still = [[1e9, 1e9 + 1.2e-7, 4], [0, 5e-324, 3]]  # no numbers between, and no loop without end
    given = json.dumps(cases + still)
    code = f"{function}; console.log(JSON.stringify({given}.map((c) => ticks(...c))))"
    done = subprocess.run(
        ["node", "-e", code], capture_output=True, text=True, check=True, timeout=60
    )
    *found, _, _ = json.loads(done.stdout)
    for (low, high, count), ticks in zip(cases, found, strict=True):
        slack = 1e-8 * (high - low)
        assert 2 <= len(ticks) <= max(2 * count, 5) + 1
        assert low - slack <= ticks[0]
        assert ticks[-1] <= high + slack
        np.testing.assert_allclose(np.diff(ticks), ticks[1] - ticks[0], rtol=1e-3)


def test_modes_of_contacts_are_on_the_page():
    system, floor = ball(restitution=0.5)
    system.initial_conditions, system.times = {y: 1.0}, np.linspace(0.0, 2.0, 21)
    trajectory = Contacts(system, [floor]).simulate(rtol=1e-9, atol=1e-9)
    assert len(trajectory.impacts) > 10  # they follow each other ever faster
    made = system.scene().animate(trajectory, fps=60)
    assert len(made.times) > len(trajectory.times)
    (row,) = data_of(made)["modes"]
    rests = trajectory.modes[-1][0]
    assert row["name"] == "floor"
    spans = [(span["from"], span["to"], span["mode"]) for span in row["spans"]]
    assert spans == [(0.0, pytest.approx(rests), "open"), (pytest.approx(rests), 2.0, "closed")]
    assert [bool(span["colour"]) for span in row["spans"]] == [False, True]
    assert data_of(made.animate(TIMES, np.cos(TIMES)[:, None] * [1, 0]))["modes"] == []


def test_no_mode_is_narrower_than_a_pixel():
    times = np.arange(4001.0)
    modes = [(t, t + 1, {"floor": ["open", "closed"][k % 2]}) for k, t in enumerate(times[:-1])]
    trajectory = SimpleNamespace(modes=modes)
    assert [len(spans) for spans in mode_intervals(trajectory, times).values()] == [1]
    assert [len(spans) for spans in mode_intervals(trajectory, times[:1001]).values()] == [1000]
