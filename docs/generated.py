"""What the documentation makes when it is built: animations, benchmark tables, a figure."""

from __future__ import annotations

import json
from html import escape
from pathlib import Path
from typing import Any

HERE = Path(__file__).parent
DATA, STATIC = HERE / "data", HERE / "static"
NAMES = {
    "pendulum-5": "pendulum, 5 links",
    "pendulum-10": "pendulum, 10 links",
    "pendulum-20": "pendulum, 20 links",
    "rods-3": "3 rods in space",
    "bicycle": "bicycle",
    "rider-bicycle": "rider on a bicycle",
}


def make(app: Any) -> None:
    """Write the generated parts of pages into `static`, before pages are read."""
    STATIC.mkdir(exist_ok=True)
    results = json.loads((DATA / "operations.json").read_text(encoding="utf-8"))
    counts = {r["model"]: (r["cse"], sum(r["run"].values())) for r in results["results"]}
    write_table(counts, STATIC / "operations.md")
    draw_counts(counts, STATIC / "operations.svg")
    write_landing(STATIC / "landing.html")
    watch_systems()


def write_table(counts: dict[str, tuple[int, int]], path: Path) -> None:
    """Write operation counts as a Markdown table."""
    rows = [
        f"| {NAMES.get(model, model)} | {cse:,} | {ours:,} | {cse / ours:.1f} |"
        for model, (cse, ours) in counts.items()
    ]
    head = "| model | SymPy's `cse` | pydy | ratio |\n|---|---|---|---|\n"
    path.write_text(head + "\n".join(rows) + "\n", encoding="utf-8")


def draw_counts(counts: dict[str, tuple[int, int]], path: Path) -> None:
    """Draw how many operations one evaluation of M and F takes, relative to SymPy's `cse`."""
    from matplotlib.figure import Figure

    shown = {name: counts[model] for model, name in NAMES.items() if model in counts}
    figure = Figure(figsize=(7.0, 2.6), layout="constrained")
    axes = figure.add_subplot()
    shares = [100 * ours / cse for cse, ours in shown.values()]
    axes.barh(list(shown), [100] * len(shown), color="#d5dae1", height=0.66)
    bars = axes.barh(list(shown), shares, color="#2f6fd0", height=0.66)
    labels = [f" {ours:,} of {cse:,}" for cse, ours in shown.values()]
    axes.bar_label(bars, labels, fontsize=9, color="#1f2733")
    axes.invert_yaxis()
    axes.set(xlim=(0, 100), xlabel="operations per evaluation, in % of SymPy's cse")
    axes.spines[["top", "right", "left"]].set_visible(False)
    axes.tick_params(left=False)
    figure.savefig(path)


def write_landing(path: Path) -> None:
    """Write the animation of the landing page: a bicycle that is pushed."""
    from pydy.examples.bicycle_ride import ride

    ride().scene.to_html(path)


# -- the gallery: what an example simulated last is animated below it ------------------------------

_LAST: dict[str, Any] = {}


def watch_systems() -> None:
    """Remember the System that simulated last, and its motion."""
    from pydy.system import System
    from pydy.viz.scene import Scene

    simulate, integrate, animate = System.simulate, System.integrate, Scene.animate
    to_html = Scene.to_html

    def simulated(self: Any, **options: Any) -> Any:
        trajectory = simulate(self, **options)
        _LAST["scene"] = lambda: self.scene().animate(trajectory)
        return trajectory

    def integrated(self: Any, **options: Any) -> Any:
        result = integrate(self, **options)
        states = result[0] if isinstance(result, tuple) else result
        times = self.times.copy()
        _LAST["scene"] = lambda: self.scene().animate(times, states)
        return result

    def animated(self: Any, *arguments: Any, **options: Any) -> Any:
        animate(self, *arguments, **options)
        _LAST["own"] = self  # an example that animates says itself what is to be seen
        return self

    def written(self: Any, *arguments: Any, **options: Any) -> Any:
        _LAST["live"] = options.get("live")  # sliders of an example are those of its page here
        return to_html(self, *arguments, **options)

    System.simulate, System.integrate, Scene.animate = simulated, integrated, animated
    Scene.to_html = written


def scrape_animation(block: Any, block_vars: dict[str, Any], gallery_conf: Any) -> str:
    """Return reStructuredText that shows the motion simulated in a block of an example."""
    found, own = _LAST.pop("scene", None), _LAST.pop("own", None)
    live = _LAST.pop("live", None)
    if found is None and own is None:
        return ""
    name = Path(block_vars["src_file"]).stem
    try:
        scene = own if own is not None else found()
    except ValueError:  # no bodies, or no point at rest: there is nothing to be seen
        return ""
    folder = STATIC / "animations"
    folder.mkdir(exist_ok=True)
    scene.to_html(folder / f"{name}.html", live=live)
    _LAST.clear()
    title = escape(name.replace("_", " "))
    return (
        "\n.. raw:: html\n\n"
        f'    <iframe class="animation" loading="lazy" title="Animation: {title}" '
        f'src="../_static/animations/{name}.html"></iframe>\n\n'
    )
