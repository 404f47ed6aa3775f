"""Pictures and films with Matplotlib."""

import shutil
import subprocess
import sys

import numpy as np
import pytest
from sympy.physics.mechanics import Point, ReferenceFrame, dynamicsymbols

from pydy.viz import (
    Arrow,
    Box,
    Capsule,
    Cone,
    Cylinder,
    Line,
    Scene,
    Sphere,
    Torus,
    Trace,
    Visual,
)
from pydy.viz.figure import draw

q = dynamicsymbols("q")
N, O = ReferenceFrame("N"), Point("O")
P = O.locatenew("P", q * N.x)


@pytest.fixture
def scene():
    visuals = [
        Visual(Box(0.2, 0.1, 0.1, opacity=0.5), P),
        Visual(Line([O, P])),
        Visual(Line([O, P], radius=0.02)),
        Visual(Arrow(q * N.y), P),
        Visual(Trace(duration=0.3), P),
        Visual(Sphere(0.1), O, trail=True),
    ]
    times = np.linspace(0, 1, 11)
    return Scene(N, O, *visuals, title="Slider").animate(times, times[:, None], symbols=[q])


def test_a_picture_at_a_time_shows_every_visual(scene):
    axes = scene.to_matplotlib(0.55)
    assert axes.get_title() == "Slider"
    assert len(axes.collections) == 4  # box, rod, arrow, sphere
    assert len(axes.lines) > 3  # line, trace, trail, and the grid


def test_axes_may_be_given_and_must_have_three_dimensions(scene):
    from matplotlib.figure import Figure

    axes = Figure().add_subplot(projection="3d")
    assert scene.to_matplotlib(axes=axes) is axes
    with pytest.raises(TypeError, match="`axes` must be three-dimensional"):
        scene.to_matplotlib(axes=Figure().add_subplot())


def test_up_in_the_scene_is_up_in_the_picture():
    up = Scene(N, O, Visual(Line([O, O.locatenew("T", N.x)])), up="x", ground=False)
    axes = up.animate([0.0], np.zeros((1, 0)), symbols=[]).to_matplotlib()
    _, _, z = axes.lines[0].get_data_3d()
    assert list(z) == pytest.approx([0, 1])


@pytest.mark.parametrize(("name", "start"), [("a.png", b"\x89PNG"), ("a.PDF", b"%PDF")])
def test_pictures_are_saved_by_their_suffix(scene, tmp_path, name, start):
    assert scene.save(tmp_path / name).read_bytes().startswith(start)


def test_a_gif_has_a_picture_for_each_instant(scene, tmp_path):
    from PIL import Image

    with Image.open(scene.save(tmp_path / "a.gif", fps=4, dpi=40)) as film:
        assert film.n_frames == 5


@pytest.mark.parametrize(("fps", "pictures", "rate"), [(7, 8, 7), (30, 31, 30), (60, 51, 50)])
def test_a_gif_keeps_the_speed_of_the_motion(scene, tmp_path, fps, pictures, rate):
    # Its delays are hundredths of a second; browsers slow down those below two.
    from PIL import Image

    delays = []
    with Image.open(scene.save(tmp_path / "a.gif", fps=fps, dpi=20)) as film:
        for k in range(film.n_frames):
            film.seek(k)
            delays.append(film.info["duration"])
    assert sum(delays) == pytest.approx(1000 * pictures / rate, abs=5.0)
    assert min(delays) >= 20


@pytest.mark.skipif(shutil.which("ffmpeg") is None, reason="ffmpeg is not installed")
def test_an_mp4_is_saved(scene, tmp_path):
    path = scene.save(tmp_path / "a.mp4", fps=3, dpi=41)
    assert path.read_bytes()[4:8] == b"ftyp"
    probe = shutil.which("ffprobe")
    asked = [probe, "-v", "error", "-count_frames", "-select_streams", "v:0", "-of", "csv=p=0"]
    asked += ["-show_entries", "stream=width,height,pix_fmt,nb_read_frames", str(path)]
    said = subprocess.run(asked, capture_output=True, text=True, check=True).stdout
    assert said.strip() == "288,206,yuv420p,4"  # 287 x 205 pixels, padded to even numbers


def test_a_missing_ffmpeg_is_named_with_the_remedy(scene, tmp_path, monkeypatch):
    monkeypatch.setenv("PATH", str(tmp_path))
    with pytest.raises(FileNotFoundError, match=r"ffmpeg, which was not found. Install it"):
        scene.save(tmp_path / "a.mp4")


def test_a_missing_matplotlib_is_named_with_the_remedy(scene, tmp_path, monkeypatch):
    monkeypatch.setitem(sys.modules, "matplotlib", None)
    with pytest.raises(ImportError, match=r"needs matplotlib.*pip install 'pydy\[plot\]'"):
        scene.to_matplotlib()
    with pytest.raises(ImportError, match=r"pip install 'pydy\[plot\]'"):
        scene.save(tmp_path / "a.png")


def test_a_missing_pillow_is_named_with_the_remedy(scene, tmp_path, monkeypatch):
    import matplotlib.pyplot  # noqa: F401 # it needs Pillow itself, and a part of it would remain

    monkeypatch.setitem(sys.modules, "PIL", None)
    with pytest.raises(ImportError, match=r"GIF film .* needs PIL.*pip install 'pydy\[plot\]'"):
        scene.save(tmp_path / "a.gif")


@pytest.mark.parametrize(("name", "options"), [("a.xyz", {}), ("a", {}), ("a.html", {})])
def test_an_unknown_suffix_is_refused(scene, tmp_path, name, options):
    with pytest.raises(ValueError, match=r"its suffix must be one of \.mp4, \.gif, \.png"):
        scene.save(tmp_path / name, **options)


def test_pictures_show_whole_bodies(tmp_path):
    # The spheres fill the box that is to be seen, and its corners lie within the picture.
    from matplotlib.image import imread

    ends = [O.locatenew("A", x * N.x + y * N.y) for x in (-1, 1) for y in (-2, 2)]
    balls = [Visual(Sphere(0.5, colour="red"), end) for end in ends]
    scene = Scene(N, O, *balls, ground=False, title="Balls")
    scene.animate([0.0], np.zeros((1, 0)), symbols=[])
    picture = imread(scene.save(tmp_path / "a.png"))[:, :, :3]
    coloured = np.ptp(picture, axis=2) > 0.3
    edge = np.concatenate([coloured[0], coloured[-1], coloured[:, 0], coloured[:, -1]])
    assert coloured.sum() > 5_000
    assert not edge.any()


def coloured(path):
    """The lowest and highest rows and columns of a picture with a colour, as parts of it."""
    from matplotlib.image import imread

    shown = np.ptp(imread(path)[:, :, :3], axis=2) > 0.3
    ends = [np.flatnonzero(shown.any(axis=1 - k))[[0, -1]] / shown.shape[k] for k in (0, 1)]
    return np.array(ends)


@pytest.mark.parametrize("unit", [1e-9, 1.0, 1e9])
def test_an_image_is_centred_on_what_is_drawn_in_it(tmp_path, unit):
    # A ball that travels ten diameters is as large as the picture, at both ends of its way.
    times = np.linspace(0, 1, 11)
    travel = unit * (10 * times[:, None] - 10)
    visuals = [Visual(Sphere(unit / 2, colour="red"), P)]
    for ground in (False, True):
        scene = Scene(N, O, *visuals, ground=ground, follow=False)
        scene.animate(times, travel, symbols=[q])
        start = scene.save(tmp_path / "a.png")
        end = tmp_path / "b.png"
        draw(scene._animation, scene._settings, 1.0, single=True).figure.savefig(end)
        for path in (start, end):
            rows, columns = coloured(path)
            assert columns.mean() == pytest.approx(0.5, abs=0.02)
            assert rows.mean() == pytest.approx(0.5, abs=0.1)
            assert np.ptp(rows) > 0.5


def test_the_trail_of_a_visual_lies_in_its_picture(tmp_path):
    times = np.linspace(0, 1, 101)
    ball = Visual(Sphere(0.1, colour="red"), P, trail=True)
    scene = Scene(N, O, ball, ground=False).animate(times, 5 * times[:, None], symbols=[q])
    path = tmp_path / "a.png"
    draw(scene._animation, scene._settings, 0.8, single=True).figure.savefig(path)
    columns = coloured(path)[1]
    assert columns.mean() == pytest.approx(0.5, abs=0.05)
    assert 0.0 < columns[0] < 0.2
    assert 0.8 < columns[1] < 0.99


def test_nothing_is_cut_at_the_rectangle_of_the_axes(scene):
    axes = scene.to_matplotlib(0.55)
    assert not any(artist.get_clip_on() for artist in (*axes.collections, *axes.lines[-3:]))


def test_a_film_makes_its_artists_and_its_background_once(tmp_path, monkeypatch):
    from matplotlib.lines import Line2D
    from matplotlib.text import Text
    from mpl_toolkits.mplot3d.art3d import Line3D

    counts = {"texts": 0, "lines": 0, "made": 0}

    def counted(kind, method):
        def call(*args, **options):
            counts[kind] += 1
            return method(*args, **options)

        return call

    times = np.linspace(0, 1, 11)
    moving = Scene(N, O, Visual(Box(0.2, 0.1, 0.1), P), Visual(Trace(), P), title="Far away")
    moving.animate(times, 30 * times[:, None], symbols=[q])  # the grid comes along
    monkeypatch.setattr(Text, "draw", counted("texts", Text.draw))
    monkeypatch.setattr(Line3D, "draw", counted("lines", Line3D.draw))
    monkeypatch.setattr(Line2D, "__init__", counted("made", Line2D.__init__))
    made = []
    for fps in (5, 10):
        counts.update(made=0, texts=0, lines=0)
        moving.save(tmp_path / "a.gif", fps=fps, dpi=40)
        assert counts["texts"] == 1
        assert counts["lines"] == 2 * (fps + 1)  # the trace and the grid
        made.append(counts["made"])
    assert made[0] == made[1]


def test_frames_of_a_film_that_is_followed_are_the_pictures_at_their_times(tmp_path):
    from matplotlib.backends.backend_agg import FigureCanvasAgg
    from PIL import Image

    times = np.linspace(0, 1, 11)
    visuals = [
        Visual(Line([O.locatenew("A", q * N.x + N.y), P], radius=0.1, colour="red"), name="rod"),
        Visual(Sphere(0.5, colour="green"), P, name="ball"),
        Visual(Trace(), P, name="trace"),
    ]
    scene = Scene(N, O, *visuals, title="Rolls")
    scene.animate(times, 31.3 * times[:, None] ** 1.7, symbols=[q])
    with Image.open(scene.save(tmp_path / "a.gif", fps=2, dpi=100)) as film:
        for k, t in enumerate((0.0, 0.5, 1.0)):
            film.seek(k)
            frame = np.asarray(film.convert("RGB")).astype(int)
            canvas = FigureCanvasAgg(scene.to_matplotlib(t).figure)
            canvas.draw()
            picture = np.asarray(canvas.buffer_rgba())[:, :, :3].astype(int)
            apart = np.abs(frame - picture).max(axis=2)
            assert np.ptp(picture, axis=2).max() > 100
            assert (apart > 60).mean() < 5e-3


def test_a_film_begins_with_the_picture(scene, tmp_path):
    from matplotlib.image import imread
    from PIL import Image

    scene.to_matplotlib().figure.savefig(tmp_path / "a.png", dpi=60)
    picture = imread(tmp_path / "a.png")[:, :, :3]
    with Image.open(scene.save(tmp_path / "a.gif", fps=2, dpi=60)) as film:
        frame = np.asarray(film.convert("RGB")) / 255
    assert np.abs(frame - picture).mean() < 0.01
    assert (np.abs(frame - picture).max(axis=2) > 0.25).mean() < 0.01
    assert frame.min() < 0.1  # black stays black
    assert frame.max() == 1.0


def test_frames_must_follow_each_other(scene, tmp_path):
    with pytest.raises(ValueError, match=r"`fps` must be from 0\.001 to 1000"):
        scene.save(tmp_path / "a.gif", fps=0)


def test_what_ffmpeg_says_is_in_the_message(scene, tmp_path, monkeypatch):
    from matplotlib.animation import FFMpegWriter

    program = tmp_path / "ffmpeg"
    program.write_text("#!/bin/sh\necho 'no such codec' >&2\nexit 1\n", encoding="utf-8")
    program.chmod(0o755)
    monkeypatch.setattr(FFMpegWriter, "isAvailable", lambda: True)
    monkeypatch.setattr(FFMpegWriter, "bin_path", lambda: str(program))
    with pytest.raises(OSError, match=r"ffmpeg could not write '.*a\.mp4': no such codec"):
        scene.save(tmp_path / "a.mp4", fps=2, dpi=40)


def test_an_ffmpeg_without_libx264_gets_no_preset(scene, tmp_path, monkeypatch):
    from matplotlib.animation import FFMpegWriter

    program, said = tmp_path / "ffmpeg", tmp_path / "said"
    program.write_text(
        f'#!/bin/sh\necho "$@" >> {said}\nfor film; do :; done\n'
        'case "$film" in *.mp4) cat > "$film";; esac\n',
        encoding="utf-8",
    )
    program.chmod(0o755)
    monkeypatch.setattr(FFMpegWriter, "isAvailable", lambda: True)
    monkeypatch.setattr(FFMpegWriter, "bin_path", lambda: str(program))
    scene.save(tmp_path / "a.mp4", fps=2, dpi=40)
    command = said.read_text(encoding="utf-8").splitlines()[-1]
    assert "-vcodec h264 " in command
    assert "-preset" not in command


def test_a_bar_counts_the_frames(scene, tmp_path, capsys):
    pytest.importorskip("tqdm")
    scene.save(tmp_path / "a.gif", fps=4, dpi=40, progress=True)
    assert "5/5" in capsys.readouterr().err
    with pytest.raises(TypeError, match="`progress` must be True or False, got 'yes'"):
        scene.save(tmp_path / "a.gif", progress="yes")


def test_triangles_that_face_away_are_not_drawn_and_are_not_missed(monkeypatch):
    from matplotlib.backends.backend_agg import FigureCanvasAgg

    import pydy.viz.figure as drawing

    solids = [Sphere(1), Cylinder(2, 0.4), Torus(1, 0.2), Capsule(1, 0.3), Cone(1, 0.5)]
    visuals = [
        Visual(s, N, O.locatenew("s", 3 * k * N.x), name=str(k)) for k, s in enumerate(solids)
    ]
    scene = Scene(N, O, *visuals).animate([0.0], np.zeros((1, 0)), symbols=[])
    pictures, counts = [], []
    for grazing in (2.0, drawing._GRAZING):
        monkeypatch.setattr(drawing, "_GRAZING", grazing)
        axes = scene.to_matplotlib()
        canvas = FigureCanvasAgg(axes.figure)
        canvas.draw()
        pictures.append(np.asarray(canvas.buffer_rgba()).astype(int))
        counts.append(sum(len(c.get_facecolor()) for c in axes.collections))
    assert counts[1] < 0.7 * counts[0]
    assert (np.abs(pictures[0] - pictures[1]).max(axis=2) > 40).mean() < 2e-3


@pytest.mark.parametrize("axis", ["x", "y", "z"])
def test_a_disc_shows_a_radius_that_turns_with_it(axis, monkeypatch):
    wheel = N.orientnew("wheel", "Axis", (q, getattr(N, axis)))
    disc = Visual(Cylinder(0.05, 0.3, axis), wheel, O)
    log = Visual(Cylinder(0.5, 0.3, axis), wheel, O)  # no wheel
    scene = Scene(N, O, disc, log, up=getattr(N, axis))
    times = np.array([0.0, 1.0])
    scene.animate(times, 0.7 * times[:, None], symbols=[q])
    drawn = []
    monkeypatch.setattr("pydy.viz.figure._Drawing._surface", lambda _, *given: drawn.append(given))

    def radius(t):
        drawn.clear()
        scene.to_matplotlib(t)
        (_, corners, rgba, _), (_, _, others, _) = drawn
        assert len(np.unique(others, axis=0)) == 1
        dark = rgba[:, 0] < rgba[:, 0].max()
        sectors = corners[dark].mean(axis=1)
        assert np.sort(sectors[:, 2]) == pytest.approx([-0.025, 0.025])  # both ends
        assert sectors[0, :2] == pytest.approx(sectors[1, :2])
        return sectors[0, :2]

    before, after = radius(0.0), radius(1.0)
    angle = np.arctan2(before[0] * after[1] - before[1] * after[0], before @ after)
    assert angle == pytest.approx(0.7, abs=1e-9)


def test_a_body_smaller_than_a_dot_is_marked_by_one():
    """A ball of 0.1 m that flies over a kilometre, and one as large as the picture."""
    times, ball = np.linspace(0.0, 10.0, num=11), O.locatenew("ball", (q - 500.0) * N.x)

    def dots(radius):
        scene = Scene(N, O, Visual(Sphere(radius), ball), follow=False)
        scene.animate(times, 100.0 * times[:, None], symbols=[q])
        lines = scene.to_matplotlib(7.0).lines
        return [line for line in lines if line.get_marker() == "o" and line.get_visible()]

    (dot,) = dots(0.05)
    assert np.linalg.norm(np.array(dot.get_data_3d())) == pytest.approx(200.0)
    assert dot.get_markersize() > 3.0
    assert dots(50.0) == []
