"""What the documentation makes when it is built: animations, benchmark tables, a figure."""

from __future__ import annotations

import json
from html import escape
from operator import truediv
from pathlib import Path
from statistics import median
from typing import Any

HERE = Path(__file__).parent
DATA, STATIC = HERE / "data", HERE / "static"
NAMES = {
    "pendulum-1": "pendulum, 1 link",
    "pendulum-5": "pendulum, 5 links",
    "pendulum-10": "pendulum, 10 links",
    "pendulum-20": "pendulum, 20 links",
    "rods-3": "3 rods in space",
    "bicycle": "bicycle",
    "rider-bicycle": "rider on a bicycle",
}

PEERS = {"heyoka": ("heyoka", "#2f6fd0"), "casadi-c": ("CasADi, compiled C", "#9aa7b8")}
WIDTHS = ("avx512", "avx2", "avx")
# Measured while matrices whose rows separate were solved in their own way, see decision 6.
OUTDATED = {"pendulum-10", "pendulum-20"}
MOMENT = 0.4  # of the motion, which the index of the gallery shows
MOMENTS = {"rolling_disc": 0.2}  # where that moment hides the mechanism
# From simple to rich: free bodies, loops and rolling, events and contact, stability and control,
# ensembles, fits, optimal control.
GALLERY = (
    *("n_link_pendulum", "dzhanibekov", "spring_chain_waves", "kapitza_pendulum", "live_page"),
    *("gyroscope_from_joints", "gyroscope_in_gimbals", "four_bar", "engine_forces", "andrews"),
    *("rolling_disc", "ball_on_a_dome", "rattleback", "bouncing_ball", "stick_slip", "walker"),
    *("relief_valve", "four_bar_with_play", "woodpecker", "bicycle", "bicycle_root_locus"),
    *("car_lane_change", "car_to_steer", "trailer_trim", "trailer_backing_up"),
    *("quadrotor_trim", "quadrotor_slung_load"),
    *("furuta_pendulum", "bicycle_brakes", "double_pendulum_flips", "bicycle_uncertain"),
    *("double_pendulum_fit", "standing_person", "brachistochrone", "arm_least_time"),
    *("cart_pole_swing_up", "bicycle_lane_change", "race_car_lap", "standing_jump"),
)


def make(app: Any) -> None:
    """Write the generated parts of pages into `static`, before pages are read."""
    STATIC.mkdir(exist_ok=True)
    results = json.loads((DATA / "operations.json").read_text(encoding="utf-8"))
    counts = {r["model"]: (r["cse"], sum(r["run"].values())) for r in results["results"]}
    write_table(counts, STATIC / "operations.md")
    draw_counts(counts, STATIC / "operations.svg")
    draw_speeds(sorted(DATA.glob("peers*.json")), STATIC / "speeds.svg")
    write_landing(STATIC / "landing.html")
    watch_scenes()


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


def draw_speeds(files: list[Path], path: Path) -> None:
    """Draw how many times ours the peers take for one state, a panel for each processor."""
    from matplotlib.figure import Figure

    found = [json.loads(file.read_text(encoding="utf-8")) for file in files]
    figure = Figure(figsize=(7.0, 2.9 * len(found)), layout="constrained")
    panels = figure.subplots(len(found), squeeze=False)[:, 0]
    for axes, data in zip(panels, found, strict=True):
        lines = {r["model"]: r["seconds"] for r in data["results"] if r["kind"] == "scalar"}
        models = [m for m in NAMES if m not in OUTDATED and "ours" in lines.get(m, {})]
        for place, (peer, (label, colour)) in enumerate(PEERS.items()):
            ratios = {
                row: median(map(truediv, lines[model][peer], lines[model]["ours"]))
                for row, model in enumerate(models)
                if peer in lines[model]
            }
            rows = [row + 0.38 * (place - 0.5) for row in ratios]
            bars = axes.barh(rows, list(ratios.values()), height=0.36, color=colour, label=label)
            axes.bar_label(bars, fmt=" %.1f", fontsize=9, color="#1f2733")
        axes.axvline(1.0, color="#1f2733", linewidth=1)
        axes.set_yticks(range(len(models)), [NAMES[model] for model in models])
        axes.invert_yaxis()
        axes.spines[["top", "right", "left"]].set_visible(False)
        axes.tick_params(left=False)
        axes.margins(x=0.1)
        processor = data["about"]["processor"]
        widest = next(
            (f for f in WIDTHS if any(x.startswith(f) for x in processor["features"])), ""
        )
        where = f"{processor['name']}, {widest.upper()}, {data['about']['taken'][:10]}"
        axes.set_xlabel(f"time for one state, pydy = 1 ({where})")
        axes.legend(frameon=False, loc="lower right")
    figure.savefig(path)


def write_landing(path: Path) -> None:
    """Write the animation of the landing page: a bicycle that is pushed."""
    from pydy.examples.bicycle_ride import ride

    ride().scene.to_html(path)


# -- the gallery: what a cell of an example animates is shown below it -----------------------------

_ANIMATED: dict[str, Any] = {}
_PAGES: dict[str, list[int]] = {}  # for each example the lines at which its animating cells begin


def watch_scenes() -> None:
    """Remember the Scene that was animated last, and the sliders of its page."""
    from pydy.viz.scene import Scene

    animate, to_html = Scene.animate, Scene.to_html

    def animated(self: Any, *arguments: Any, **options: Any) -> Any:
        animate(self, *arguments, **options)
        _ANIMATED.update(scene=self, live=None)
        return self

    def written(self: Any, *arguments: Any, **options: Any) -> Any:
        _ANIMATED.update(scene=self, live=options.get("live"))
        return to_html(self, *arguments, **options)

    Scene.animate, Scene.to_html = animated, written


def take_scene() -> tuple[Any, Any] | None:
    """Return the Scene that was animated since the last call and its sliders, or None."""
    scene, live = _ANIMATED.get("scene"), _ANIMATED.get("live")
    _ANIMATED.clear()
    return None if scene is None else (scene, live)


class SimpleToRich:
    """The order of the examples in the gallery, as sphinx-gallery asks for it."""

    def __init__(self, folder: Any) -> None:
        pass

    def __call__(self, filename: Any) -> int:
        """Return the position of an example; a new one must be given one."""
        return GALLERY.index(Path(filename).stem)


def draw_thumbnail(scene: Any, path: Path) -> None:
    """Draw the scene at a moment of its motion, for the index of the gallery."""
    from matplotlib.figure import Figure

    from pydy.viz.figure import draw

    figure = Figure(figsize=(4.0, 2.8), dpi=100)
    axes = figure.add_axes((0.0, 0.0, 1.0, 1.0), projection="3d")
    first, last = scene.times[[0, -1]]
    share = MOMENTS.get(path.stem, MOMENT)
    instant = first + share * (last - first)
    draw(scene._moving(), scene._settings, instant, axes, single=True).set_title("")
    figure.savefig(path, transparent=True)  # on light and on dark paper


def show_thumbnails(app: Any) -> None:
    """Put pictures of the mechanisms in place of those of figures, once the gallery is made."""
    thumbs = HERE / "gallery" / "images" / "thumb"
    for picture in sorted((STATIC / "animations").glob("*.png")):
        thumb = thumbs / f"sphx_glr_{picture.stem}_thumb.png"
        if thumb.exists():
            thumb.write_bytes(picture.read_bytes())


def scrape_animation(block: Any, block_vars: dict[str, Any], gallery_conf: Any) -> str:
    """Return reStructuredText that shows what a cell of an example animated last, if anything."""
    taken = take_scene()
    if taken is None:
        return ""
    scene, live = taken
    name = Path(block_vars["src_file"]).stem
    title = escape(name.replace("_", " "))
    pages = _PAGES.setdefault(name, [])
    if block[2] not in pages:
        pages.append(block[2])
    number = pages.index(block[2])
    page = f"{name}-{number + 1}.html" if number else f"{name}.html"
    folder = STATIC / "animations"
    folder.mkdir(exist_ok=True)
    scene.to_html(folder / page, live=live)
    if not number:
        draw_thumbnail(scene, folder / f"{name}.png")
    _ANIMATED.clear()
    return (
        "\n.. raw:: html\n\n"
        f'    <iframe class="animation" loading="lazy" title="Animation: {title}" '
        f'src="../_static/animations/{page}"></iframe>\n\n'
    )
