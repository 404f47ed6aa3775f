"""What users write is replaced as a whole: a full disk or an error leaves the file before."""

from __future__ import annotations

import io
import os
import shutil
import stat
from pathlib import Path

import numpy as np
import pytest

from pydy._files import folder_beside, write_files
from pydy.models import n_link_pendulum_on_cart
from pydy.robots import read

resource = pytest.importorskip("resource")


@pytest.fixture(scope="module")
def system():
    system = n_link_pendulum_on_cart(2)
    system.initial_conditions = {"q1": 0.5}
    system.times = np.linspace(0.0, 1.0, num=5)
    return system


@pytest.fixture(scope="module")
def trajectory(system):
    return system.simulate()


@pytest.fixture(scope="module")
def scene(system, trajectory):
    return system.scene().animate(trajectory)


@pytest.fixture
def full_disk():
    """Let no file grow beyond a kilobyte."""
    before = resource.getrlimit(resource.RLIMIT_FSIZE)
    resource.setrlimit(resource.RLIMIT_FSIZE, (1000, before[1]))
    yield
    resource.setrlimit(resource.RLIMIT_FSIZE, before)


WRITERS = {
    "motion.nc": lambda run, scene, system, path: run.save(path),
    "page.html": lambda run, scene, system, path: scene.to_html(path),
    "start.png": lambda run, scene, system, path: scene.save(path),
    "start.svg": lambda run, scene, system, path: scene.save(path),
    "film.gif": lambda run, scene, system, path: scene.save(path, fps=2, dpi=30),
    "model.c": lambda run, scene, system, path: system.export(path),
    "model.js": lambda run, scene, system, path: system.export(path),
    "model.py": lambda run, scene, system, path: system.export(path),
    "model.fmu": lambda run, scene, system, path: system.export(path, binary=False),
}


@pytest.mark.parametrize("name", WRITERS)
def test_a_full_disk_leaves_the_file_that_was_there(
    name, tmp_path, system, trajectory, scene, request
):
    path = tmp_path / name
    WRITERS[name](trajectory, scene, system, path)
    before = {file: file.read_bytes() for file in tmp_path.iterdir()}
    assert max(map(len, before.values())) > 1000
    request.getfixturevalue("full_disk")
    with pytest.raises(OSError, match=r"File too large|write") as told:
        WRITERS[name](trajectory, scene, system, path)
    if told.value.errno is not None:  # a format's own library may tell less
        assert told.value.filename.startswith(str(path.with_suffix("")))
    assert {file: file.read_bytes() for file in tmp_path.iterdir()} == before


@pytest.mark.parametrize("name", WRITERS)
def test_an_open_file_is_no_path(name, system, trajectory, scene):
    with pytest.raises(TypeError, match=r"`path` must be .*path, got <_io\.StringIO"):
        WRITERS[name](trajectory, scene, system, io.StringIO("text"))


def test_an_open_file_is_no_robot():
    with pytest.raises(TypeError, match=r"`path` must be a path, got <_io\.StringIO"):
        read(io.StringIO("<robot/>"))


def test_the_header_of_a_model_is_not_replaced_without_its_source(tmp_path, full_disk):
    old = {tmp_path / "model.h": "old header", tmp_path / "model.c": "old source"}
    for path, text in old.items():
        path.write_text(text)
    with pytest.raises(OSError, match="too large"):
        write_files({tmp_path / "model.h": "new header", tmp_path / "model.c": "x" * 2000})
    assert {path: path.read_text() for path in tmp_path.iterdir()} == old


def test_an_interrupted_film_leaves_the_one_before(tmp_path, scene, monkeypatch):
    path = tmp_path / "film.gif"
    path.write_bytes(b"the film before")
    asked = []

    def stopped(drawing, k):
        asked.append(k)
        if len(asked) == 3:
            raise KeyboardInterrupt

    monkeypatch.setattr("pydy.viz.figure._Drawing.draw", stopped)
    with pytest.raises(KeyboardInterrupt):
        scene.save(path, fps=5, dpi=30)
    assert path.read_bytes() == b"the film before"
    assert list(tmp_path.iterdir()) == [path]


def test_a_link_stays_and_the_file_that_it_names_is_replaced(tmp_path):
    (tmp_path / "folder").mkdir()
    (tmp_path / "folder" / "file").write_text("old")
    (tmp_path / "link").symlink_to("folder/file")
    write_files({tmp_path / "link": "new"})
    assert (tmp_path / "link").is_symlink()
    assert (tmp_path / "folder" / "file").read_text() == "new"
    assert sorted(path.name for path in (tmp_path / "folder").iterdir()) == ["file"]


def test_permissions_stay_and_are_the_usual_ones_for_a_new_file(tmp_path):
    (tmp_path / "old").write_text("old")
    (tmp_path / "old").chmod(0o640)
    before = os.umask(0o027)
    try:
        write_files({tmp_path / "old": "new", tmp_path / "new": "new"})
    finally:
        os.umask(before)
    modes = {path.name: stat.S_IMODE(path.stat().st_mode) for path in tmp_path.iterdir()}
    assert modes == {"old": 0o640, "new": 0o640}


def test_devices_are_written_to_as_they_are():
    write_files({Path("/dev/null"): "text"})
    assert stat.S_ISCHR(os.stat("/dev/null").st_mode)


def test_the_longest_name_that_a_disk_takes_can_be_replaced(tmp_path):
    path = tmp_path / ("x" * 251 + ".txt")
    write_files({path: "new"})
    assert path.read_text() == "new"


def test_a_folder_that_cannot_be_written_is_named_by_the_file_of_the_user(tmp_path, monkeypatch):
    def refused(folder, *_, **more):
        raise PermissionError(13, "Permission denied", str(folder))

    monkeypatch.setattr(Path, "mkdir", refused)
    with pytest.raises(PermissionError, match=r"Permission denied: '.*/page\.html'$"):
        write_files({tmp_path / "page.html": "text"})


@pytest.mark.parametrize("place", ["mkdir", "rmtree"])
def test_an_interrupt_leaves_no_folder(place, tmp_path, monkeypatch):
    owner = Path if place == "mkdir" else shutil
    done = getattr(owner, place)

    def interrupted(*given, **more):
        monkeypatch.undo()
        if place == "mkdir":
            done(*given, **more)
        raise KeyboardInterrupt

    monkeypatch.setattr(owner, place, interrupted)
    with pytest.raises(KeyboardInterrupt), folder_beside(tmp_path / "page.html"):
        pass
    assert list(tmp_path.iterdir()) == []
