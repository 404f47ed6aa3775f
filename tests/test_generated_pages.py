"""What the documentation makes when it is built."""

import doctest
import json
import re
import sys
from pathlib import Path

import numpy as np
import pytest

from gallery import EXAMPLES
from optional import optional
from pydy import __version__
from pydy.models import n_link_pendulum_on_cart
from pydy.viz import Scene

matplotlib, image = optional("matplotlib"), optional("matplotlib.image")
ROOT = Path(__file__).parents[1]


@pytest.fixture
def generated(monkeypatch, tmp_path):
    """The module beside the pages, which writes elsewhere and leaves classes as they were."""
    monkeypatch.syspath_prepend(str(ROOT / "docs"))
    monkeypatch.delitem(sys.modules, "generated", raising=False)
    import generated

    monkeypatch.setattr(generated, "STATIC", tmp_path)
    for name in ("animate", "to_html"):
        monkeypatch.setattr(Scene, name, getattr(Scene, name))
    yield generated
    sys.modules.pop("generated", None)


def test_pages_show_what_their_code_draws_and_animates(generated, monkeypatch):
    monkeypatch.delitem(sys.modules, "illustrate", raising=False)
    import illustrate

    page = "# Title\n\n```python\n>>> 1\n1\n```\n\nText\n\n```python\n>>> 2\n```\n"
    assert [(k, text[:5]) for k, text in illustrate.blocks(page)] == [(5, ">>> 1"), (11, ">>> 2")]
    shown = illustrate.with_pictures(page, "howto/a", [(5, "a.svg"), (5, "b.html")])
    first, rest = shown.split("Text")
    assert "```{image} /static/pages/a.svg" in first
    assert 'src="../_static/pages/b.html"' in first
    assert rest == page.split("Text")[1]
    drawing = {
        path.relative_to(ROOT / "docs").with_suffix("").as_posix()
        for path in (ROOT / "docs").rglob("*.md")
        for example in doctest.DocTestParser().get_examples(path.read_text(encoding="utf-8"))
        if "animate(" in example.source or "plot" in example.source
    }
    guides = {"animation", "ensembles", "results", "solvers", "system", "howto/live"}
    assert guides | {"howto/robots", "howto/optimal-control"} <= drawing
    assert drawing - {"tutorial"} == illustrate.PAGES  # that has pictures of its own
    monkeypatch.setattr(illustrate, "HERE", generated.STATIC)
    (generated.STATIC / "a.md").write_text(
        "```python\n>>> import matplotlib.pyplot as plt\n>>> _ = plt.plot([1, 2])\n```\n"
        "```python\n>>> import numpy as np\n>>> from sympy.physics.mechanics import Point\n"
        ">>> from sympy.physics.mechanics import ReferenceFrame\n>>> from pydy.viz import Scene\n"
        ">>> scene = Scene(ReferenceFrame('N'), Point('O'), 5)\n"
        "Traceback (most recent call last):\n"
        "TypeError: no\n>>> from pydy.viz import Sphere, Visual\n>>> O = Point('O')\n"
        ">>> scene = Scene(ReferenceFrame('N'), O, Visual(Sphere(1), O))\n"
        ">>> _ = scene.animate([0.0, 1.0], np.zeros((2, 0)), symbols=[])\n```\n",
        encoding="utf-8",
    )
    assert illustrate.draw("a", generated.STATIC) == [(3, "a-0.svg"), (16, "a-1.html")]
    assert (generated.STATIC / "a-0.svg").exists()
    assert "three" in (generated.STATIC / "a-1.html").read_text(encoding="utf-8")


def test_the_table_and_the_figure_show_the_benchmarks_counts(generated, tmp_path):
    results = json.loads((ROOT / "docs/data/operations.json").read_text(encoding="utf-8"))
    assert {r["model"] for r in results["results"]} >= set(generated.NAMES) - {"pendulum-1"}
    counts = {"bicycle": (1500, 1000), "pendulum-5": (400, 100)}
    generated.write_table(counts, tmp_path / "table.md")
    rows = (tmp_path / "table.md").read_text(encoding="utf-8").splitlines()
    assert rows[2:] == [
        "| bicycle | 1,500 | 1,000 | 1.5 |",
        "| pendulum, 5 links | 400 | 100 | 4.0 |",
    ]
    generated.draw_counts(counts, tmp_path / "figure.svg")
    assert "<svg" in (tmp_path / "figure.svg").read_text(encoding="utf-8")


def test_the_figure_of_speeds_has_the_ratios_and_the_processor(generated, tmp_path):
    times = {"ours": [1.0, 2.0, 1.0], "heyoka": [3.0, 6.0, 4.0], "casadi-c": [2.5, 5.0, 2.5]}
    lines = [{"model": "bicycle", "kind": "scalar", "seconds": times, "failed": {}}]
    processor = {"name": "Some Processor", "features": ["avx", "avx2"]}
    about = {"processor": processor, "taken": "2026-11-22T06:36:25+00:00"}
    source = tmp_path / "peers.json"
    source.write_text(json.dumps({"about": about, "results": lines}), encoding="utf-8")
    with matplotlib.rc_context({"svg.fonttype": "none"}):
        generated.draw_speeds([source], tmp_path / "speeds.svg")
    svg = (tmp_path / "speeds.svg").read_text(encoding="utf-8")
    for word in (" 3.0<", " 2.5<", "bicycle", "Some Processor, AVX2, 2026-11-22", "heyoka"):
        assert word in svg


def test_the_gallery_shows_each_example_once_and_simple_ones_first(generated):
    assert sorted(generated.GALLERY) == [path.stem for path in EXAMPLES]
    order = generated.SimpleToRich("examples")
    assert order("n_link_pendulum.py") == 0
    assert order("four_bar.py") < order("woodpecker.py") < order("standing_jump.py")


def test_what_a_cell_animates_is_shown_below_it(generated, tmp_path, monkeypatch):
    generated.watch_scenes()
    names = {"src_file": "examples/carts.py"}
    system = n_link_pendulum_on_cart(1)
    system.times = np.linspace(0.0, 1.0, num=31)
    assert generated.scrape_animation(("code", "", 10), names, {}) == ""
    system.scene(title="First").animate(system.simulate())
    text = generated.scrape_animation(("code", "", 20), names, {})
    assert 'src="../_static/animations/carts.html"' in text
    assert generated.scrape_animation(("code", "", 30), names, {}) == ""
    scene = system.scene(title="Second").animate(system.simulate())
    scene.to_html(tmp_path / "live.html", live={"g": (1.0, 20.0)})
    text = generated.scrape_animation(("code", "", 40), names, {})
    assert 'src="../_static/animations/carts-2.html"' in text
    pages = [tmp_path / "animations" / name for name in ("carts.html", "carts-2.html")]
    first, second = (page.read_text(encoding="utf-8") for page in pages)
    assert "<title>First</title>" in first
    assert "<title>Second</title>" in second
    assert len(second) > len(first) + 10_000  # it simulates
    # The index of the gallery shows the first.
    picture = image.imread(tmp_path / "animations" / "carts.png")
    assert picture.shape[:2] == (280, 400)
    assert (np.ptp(picture[:, :, :3], axis=2) > 0.3).sum() > 100  # coloured bodies
    assert not picture[[0, 0, -1, -1], [0, -1, 0, -1], 3].any()  # before any paper
    assert not (tmp_path / "animations" / "carts-2.png").exists()
    thumbs = tmp_path / "gallery" / "images" / "thumb"
    thumbs.mkdir(parents=True)
    (thumbs / "sphx_glr_carts_thumb.png").write_bytes(b"a figure")
    monkeypatch.setattr(generated, "HERE", tmp_path)
    generated.show_thumbnails(None)
    assert (thumbs / "sphx_glr_carts_thumb.png").stat().st_size > 2_000
    # Building anew writes the same pages.
    system.scene(title="Again").animate(system.simulate())
    assert "carts.html" in generated.scrape_animation(("code", "", 20), names, {})


def test_the_citation_has_the_version():
    text = (ROOT / "CITATION.cff").read_text(encoding="utf-8")
    assert re.search(r"^version: (.*)$", text, re.MULTILINE)[1] == __version__
