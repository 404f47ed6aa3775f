"""Curves below a scene: what is drawn on the canvas is the exact peak, jump and gap."""

import numpy as np
import pytest
from sympy.physics.mechanics import Point, ReferenceFrame, dynamicsymbols

from pydy.viz import Live, Scene, Sphere, Visual, curves as thinning
from pydy.viz.page import _resource
from zoo.exported_models import ball

q = dynamicsymbols("q")
N, O = ReferenceFrame("N"), Point("O")
P = O.locatenew("P", q * N.x)
COLUMN = """
  ([x, width]) => {
    const canvas = document.getElementById("strip-curves");
    const ratio = canvas.width / canvas.clientWidth, columns = Math.round(2 * ratio * width);
    const g = canvas.getContext("2d");
    const { data } = g.getImageData(Math.round(ratio * (x - width)), 0, columns, canvas.height);
    const key = document.querySelectorAll("#strip-labels i")[NUMBER];
    const colour = getComputedStyle(key).backgroundColor.match(/[0-9]+/g).map(Number);
    const rows = new Set();
    for (let k = 0; k < data.length; k += 4)
      if (data[k + 3] > 99 && [0, 1, 2].every((j) => Math.abs(data[k + j] - colour[j]) < 40))
        rows.add(Math.floor(k / 4 / columns) / ratio);
    return [...rows].sort((a, b) => a - b);
  }
"""


def shown(open_page, folder, times, values):
    scene = Scene(N, O, Visual(Sphere(1), P), series={"q": q})
    scene.animate(times, np.zeros((len(times), 1)), symbols=[q], series={"f": values})
    return open_page(scene.to_html(folder / "curves.html"))


def curve(page, label="f"):
    return next(one for one in page.evaluate("pydy.curves()") if one["label"] == label)


def drawn(page, x, width=2.0):
    """The heights at which something of a curve's colour is, in CSS pixels."""
    labels = [one["label"] for one in page.evaluate("pydy.curves()")]
    return np.array(page.evaluate(COLUMN.replace("NUMBER", str(labels.index("f"))), [x, width]))


@pytest.mark.parametrize("size", [129.6, 1e-9, 1e9])
def test_the_extremes_of_the_strip_are_a_pulse_between_two_frames(tmp_path, open_page, size):
    times = np.linspace(0.0, 1.0, 100_001)
    values = np.zeros(len(times))
    values[61_616] = size
    page = shown(open_page, tmp_path, times, values)
    found = curve(page)
    assert (found["low"], found["high"]) == (0.0, size)
    k = int(np.argmax(found["values"]))
    assert (found["times"][k], found["values"][k]) == (times[61_616], size)
    heights = [y for _, y in found["places"]]
    assert heights[k] == min(heights) < max(heights) - 40


def test_a_jump_is_vertical_and_the_cursor_has_its_sides(tmp_path, open_page):
    times = np.array([0.0, 0.25, 0.5, 0.5, 0.75, 1.0])
    page = shown(open_page, tmp_path, times, np.array([1.0, 1.0, 1.0, 5.0, 5.0, 5.0]))
    found = curve(page)
    before, after = (found["places"][found["values"].index(v) - b] for v, b in ((5.0, 1), (5.0, 0)))
    assert before[0] == after[0]
    assert before[1] > after[1] + 40
    for time, value in ((0.5 - 1e-9, 1.0), (0.5, 5.0), (0.5 + 1e-9, 5.0)):
        page.evaluate(f"pydy.seek({time!r})")
        assert curve(page)["now"] == value


def test_one_value_between_gaps_is_a_dot(tmp_path, open_page):
    nan = np.nan
    times, values = np.linspace(0.0, 1.0, 7), np.array([1.0, 1.0, nan, 2.0, nan, 3.0, 3.0])
    page = shown(open_page, tmp_path, times, values)
    found = curve(page)
    x, y = found["places"][found["values"].index(2.0)]
    assert np.min(np.abs(drawn(page, x) - y)) < 2.0


def test_a_simulation_in_the_page_keeps_both_sides_of_resets_and_the_peaks(tmp_path, open_page):
    system, bounce = ball()
    scene = system.scene(series=list(system.states)).animate(system.simulate(), fps=None)
    page = open_page(
        scene.to_html(tmp_path / "live.html", live=Live({"y": (0.2, 2)}, events=bounce))
    )
    page.evaluate("pydy.live.set('y', 1.5)")
    height, speed = page.evaluate("pydy.curves()")
    # y = 1.5 - g t² / 2, until the ground: then 4/5 of the speed upwards.
    fall, hit = np.sqrt(3.0 / 9.81), np.sqrt(3.0 * 9.81)
    times, values = np.array(speed["times"]), np.array(speed["values"])
    sides = np.flatnonzero(np.abs(times - fall) < 1e-6)[-2:]
    assert times[sides] == pytest.approx([fall, fall], abs=1e-6)
    assert times[sides[0]] == times[sides[1]]
    assert values[sides] == pytest.approx([-hit, 0.8 * hit], rel=1e-6)
    assert speed["low"] == pytest.approx(-hit, rel=1e-6)
    assert min(height["values"]) == pytest.approx(0.0, abs=1e-9)
    x = {speed["places"][k][0] for k in sides}
    assert len(x) == 1


# -- The recorder of a live page -------------------------------------------------------------------

BUCKETS = 50
MOST = 14 * BUCKETS  # the number of points above which the recorder thins
RECORD = """
  ([buckets, times, values]) => {
    const data = { live: { buckets } }, start = times[0], end = times.at(-1);
    SAMPLES
    const samples = new Samples(), first = samples.times;
    let longest = 0;
    times.forEach((time, k) => {
      samples.add(time, values[k]);
      longest = Math.max(longest, samples.times.length, samples.values.length);
    });
    return [samples.times, samples.values, longest, samples.times === first];
  }
"""


@pytest.fixture
def recorded(browser):
    """What the recorder stores of samples: times, values, and its greatest number of points."""
    page = browser.new_page()

    def recorded(times, values):
        script = RECORD.replace("SAMPLES", _resource("samples.js"))
        *stored, longest, same = page.evaluate(script, [BUCKETS, times.tolist(), values.tolist()])
        assert same  # a curve of the page reads these arrays
        return *map(np.array, stored), longest

    yield recorded
    page.close()


def extremes(times, values, span):
    """First, last, lowest and highest value of each part of the time."""
    part = np.floor(BUCKETS * (times - span[0]) / (span[1] - span[0]))
    parts = np.minimum(part, BUCKETS - 1)
    first = np.flatnonzero(np.diff(parts, prepend=-1))
    last = np.append(first[1:], len(times)) - 1
    lowest, highest = np.fmin.reduceat(values, first), np.fmax.reduceat(values, first)
    return np.column_stack([parts[first], values[first], values[last], lowest, highest])


def jumping(count, seed=0):
    """Samples at uneven steps: one jump in each of the parts, gaps, and noise between them."""
    random = np.random.default_rng(seed)
    times = np.sort(random.uniform(0.0, BUCKETS, count)) ** 1.5
    values = random.normal(size=count)
    edges = np.linspace(times[0], times[-1], BUCKETS + 1)
    rows = np.searchsorted(times, edges[:-1] + random.uniform(0.2, 0.8, BUCKETS) * np.diff(edges))
    times[rows + 1] = times[rows]
    values[rows + 1] = values[rows] + 20.0 * random.choice([-1.0, 1.0], BUCKETS)
    values[rows[::5] + 5] = np.nan
    return times, values, rows


def test_a_curve_that_is_recorded_while_it_is_thinned_has_all_peaks_and_jumps(recorded):
    times, values, rows = jumping(40 * MOST)
    own, drawn, longest = recorded(times, values)
    assert longest <= MOST + 1 < len(times)
    assert (np.diff(own) >= 0.0).all()
    assert (own[-1], drawn[-1]) == (times[-1], values[-1])
    # All points are samples.
    finite, every = np.isfinite(drawn), np.isfinite(values)
    samples = {*zip(times[every], values[every], strict=True)}
    assert {*zip(own[finite], drawn[finite], strict=True)} <= samples
    assert {*own[~finite]} <= {*times[~every]}
    span = times[0], times[-1]
    np.testing.assert_array_equal(extremes(own, drawn, span), extremes(times, values, span))
    # Both sides of each jump are neighbours.
    sides = {*zip(own[:-1], drawn[:-1], own[1:], drawn[1:], strict=True)}
    assert sides >= {(times[k], values[k], times[k + 1], values[k + 1]) for k in rows}
    gaps = np.flatnonzero(~every)
    parts = np.floor(BUCKETS * (times[gaps] - span[0]) / (span[1] - span[0]))
    stored = np.floor(BUCKETS * (own[~finite] - span[0]) / (span[1] - span[0]))
    assert {*stored} == {*parts}


@pytest.mark.parametrize("start", [0.0, 1e9])
@pytest.mark.parametrize("scale", [1e-300, 1.0, 1e300])
def test_a_recorder_thins_like_a_page_that_python_writes(recorded, monkeypatch, start, scale):
    times, values, _ = jumping(MOST + 1, 1)
    times, values = start + times, scale * values
    monkeypatch.setattr(thinning, "BUCKETS", BUCKETS)
    monkeypatch.setattr(thinning, "UNTHINNED", 0)
    expected = thinning.thinned(thinning.TimeSeries(times, values))
    own, drawn, _ = recorded(times, values)
    np.testing.assert_array_equal((own, drawn), expected)


def test_a_jump_counts_where_both_of_its_sides_are_numbers(recorded, monkeypatch):
    times, values = np.linspace(0.0, 1.0, MOST + 1), np.zeros(MOST + 1)
    times[5], values[5:] = times[4], 1.0
    times[9], values[8] = times[8], np.inf
    own, drawn, _ = recorded(times, values)
    (k,) = np.flatnonzero((own[:-1] == times[4]) & (own[1:] == times[4]))
    assert drawn[k : k + 2].tolist() == [0.0, 1.0]
    monkeypatch.setattr(thinning, "BUCKETS", BUCKETS)
    monkeypatch.setattr(thinning, "UNTHINNED", 0)
    np.testing.assert_array_equal(
        (own, drawn), thinning.thinned(thinning.TimeSeries(times, values))
    )


def test_a_recorder_stores_repeated_samples_once_and_both_values_of_one_moment(recorded):
    times, values = np.array([0.0, 0.0, 1.0, 1.0, 1.0, 2.0]), np.array([3.0, 3, 4, 4, 5, 5])
    own, drawn, _ = recorded(times, values)
    assert own.tolist() == [0.0, 1.0, 1.0, 2.0]
    assert drawn.tolist() == [3.0, 4.0, 5.0, 5.0]
