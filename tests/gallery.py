"""The examples of the gallery: scripts in cells."""

import re
from pathlib import Path
from types import SimpleNamespace

EXAMPLES = sorted(Path(__file__).parents[1].glob("examples/*.py"))

# What is replaced in an example for a short run: fewer samples, a shorter motion.
SMALLER: dict[str, dict[str, str]] = {
    "andrews": {"times=np.linspace(0.0, END, num=601)": "times=np.linspace(0.0, END, num=61)"},
    "arm_least_time": {"np.linspace(1.0, 2.0, num=6)": "np.linspace(1.0, 2.0, num=2)"},
    "ball_on_a_dome": {
        "assert abs(found - leaves) < 0.01": "assert abs(found - leaves) < 0.5",
        "times=np.linspace(0.0, 3.1, num=1551)": "times=np.linspace(0.0, 3.1, num=156)",
    },
    "bicycle": {
        "np.linspace(0.0, 6.0, num=601)": "np.linspace(0.0, 1.5, num=151)",
        "np.linspace(0.5, 10.0, num=191)": "np.linspace(0.5, 10.0, num=8)",
    },
    "bicycle_brakes": {"np.linspace(60.0, 480.0, num=43)": "np.linspace(60.0, 480.0, num=22)"},
    "bicycle_lane_change": {"np.linspace(3.0, 2.0, num=6)": "np.linspace(3.0, 2.0, num=2)"},
    "bicycle_root_locus": {
        "np.linspace(0.0, 8.0, num=481)": "np.linspace(0.0, 2.0, num=121)",
        "np.linspace(0.0, 10.0, num=1001)": "np.linspace(0.0, 10.0, num=101)",
    },
    "bicycle_uncertain": {"count, compared = 2000, 25": "count, compared = 24, 3"},
    "bouncing_ball": {
        "times=np.linspace(0.0, 0.97 * end, num=1001)": "times=np.linspace(0.0, 0.5 * end, num=101)"
    },
    "brachistochrone": {
        "below = np.linspace(6.0, 1.0, num=11)": "below = np.linspace(6.0, 1.0, num=3)"
    },
    "cart_pole_swing_up": {
        "masses = np.linspace(0.3, 0.4, num=11)": "masses = np.linspace(0.3, 0.4, num=3)"
    },
    "double_pendulum_fit": {
        "times = np.linspace(0.0, 2.0, num=101)": "times = np.linspace(0.0, 1.0, num=51)"
    },
    "double_pendulum_flips": {"n, coarse = 200, 40": "n, coarse = 21, 7"},
    "dzhanibekov": {
        "times=np.linspace(0.0, 10.0, num=2001)": "times=np.linspace(0.0, 1.0, num=101)"
    },
    "engine_forces": {
        "times=np.linspace(0.0, 0.1, num=10001)": "times=np.linspace(0.0, 0.01, num=1001)"
    },
    "four_bar": {"times=np.linspace(0.0, 2.0, num=1001)": "times=np.linspace(0.0, 0.2, num=101)"},
    "four_bar_with_play": {
        "end = 0.5": "end = 0.06",
        "times=np.linspace(0.0, end, num=1001)": "times=np.linspace(0.0, end, num=121)",
    },
    "gyroscope_from_joints": {
        "times=np.linspace(0.0, 2.0, num=2001)": "times=np.linspace(0.0, 0.2, num=201)"
    },
    "gyroscope_in_gimbals": {
        "np.linspace(0.0, 4.0, num=1001)": "np.linspace(0.0, 0.5, num=1001)",
        "np.linspace(0.0, 0.5, num=2001)": "np.linspace(0.0, 0.2, num=2001)",
    },
    "kapitza_pendulum": {
        "times=np.linspace(0.0, 3.0, num=3001)": "times=np.linspace(0.0, 1.0, num=401)"
    },
    "live_page": {"times=np.linspace(0.0, 20.0, num=601)": "times=np.linspace(0.0, 4.0, num=121)"},
    "n_link_pendulum": {
        "n = 10": "n = 3",
        "times=np.linspace(0.0, 5.0, num=1001)": "times=np.linspace(0.0, 0.5, num=61)",
    },
    "quadrotor_slung_load": {
        "np.linspace(0.0, 10.0, num=601)": "np.linspace(0.0, 2.0, num=601)",
        "assert final < 0.02": "assert final < 0.3",
    },
    "quadrotor_trim": {"np.linspace(0.0, 8.0, num=801)": "np.linspace(0.0, 8.0, num=201)"},
    "rattleback": {
        "times=np.linspace(0.0, 60.0, num=6001)": "times=np.linspace(0.0, 5.0, num=501)"
    },
    "relief_valve": {"flows = np.linspace(0.6, 10.0, 400)": "flows = np.linspace(0.6, 10.0, 40)"},
    "rolling_disc": {
        "times=np.linspace(0.0, 8.0, num=1601)": "times=np.linspace(0.0, 1.0, num=101)",
        "np.linspace(0.0, 2.0, num=81) * CRITICAL": "np.linspace(0.0, 2.0, num=9) * CRITICAL",
    },
    "spring_chain_waves": {"n = 50": "n = 12"},
    "standing_jump": {"[1.3, 1.4, 1.5, 1.6, 1.7, 1.8, 1.9, 2.0]": "[1.6, 1.8]"},
    "standing_person": {"times = np.arange(0.0, 20.0, 0.01)": "times = np.arange(0.0, 8.0, 0.01)"},
    "stick_slip": {
        "times=np.linspace(0.0, 20.0, num=2001)": "times=np.linspace(0.0, 8.0, num=401)"
    },
    "trailer_backing_up": {
        "np.linspace(0.0, 50.0, num=1501)": "np.linspace(0.0, 15.0, num=1501)",
        'assert abs(parking["offset"][-1]) < 0.01': 'assert abs(parking["offset"][-1]) < 4.0',
    },
    "trailer_trim": {"np.linspace(0.0, 6.0, num=301)": "np.linspace(0.0, 6.0, num=61)"},
    "walker": {"steps = 12": "steps = 5"},
    "woodpecker": {"times=np.linspace(0.0, 3.0, num=3001)": "times=np.linspace(0.0, 0.5, num=501)"},
}


def cells(path: Path) -> list[str]:
    """Return the parts of a script between its lines ``# %%``."""
    return re.split(r"^# %%.*\n", path.read_text(encoding="utf-8"), flags=re.MULTILINE)


def smaller(path: Path) -> str:
    """Return the source of an example with the numbers of a short run."""
    source = path.read_text(encoding="utf-8")
    for full, small in SMALLER.get(path.stem, {}).items():
        if source.count(full) != 1:
            raise LookupError(f"{path.name} has `{full}` {source.count(full)} times, not once")
        source = source.replace(full, small)
    return source


def definitions(name: str, before: str) -> SimpleNamespace:
    """Return what an example defines before the cell that holds a text."""
    (path,) = (path for path in EXAMPLES if path.stem == name)
    first = []
    for cell in cells(path):
        if before in cell:
            break
        first.append(cell)
    # Plots are drawn below: the import would cost every collection of tests half a second.
    source = "".join(first).replace("import matplotlib.pyplot as plt\n", "")
    names = {"__name__": name}
    exec(source, names)
    return SimpleNamespace(**names)
