"""Machine code on disk: whatever happens to it, results stay right and nobody sees an error.

What somebody else could have written there is never run.
"""

from __future__ import annotations

import os
import random
import signal
import stat
import subprocess
import sys
import tempfile
import time
from pathlib import Path
from types import SimpleNamespace

import pytest

from pydy import _cache_folder as cache
from pydy.errors import PyDyUserWarning

KEY, OTHER, OLD, USED = (letter * 64 for letter in "0123")

SCRIPT = """
import sys
import numpy as np
from pydy.models import multi_mass_spring_damper
for n in (1, 2):
    system = multi_mass_spring_damper(n)
    x = np.arange(1.0, 2 * n + 1)
    system.generate_ode_function()
    rates = system.evaluate_ode(x)
    np.testing.assert_array_equal(rates[:n], x[n:])
print("right")
"""


@pytest.fixture
def folder(tmp_path, monkeypatch):
    monkeypatch.setenv("PYDY_CACHE_DIR", str(tmp_path / "cache"))
    return tmp_path / "cache" / "pydy-cache"


def start():
    return subprocess.Popen(
        [sys.executable, "-c", SCRIPT], stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True
    )


def finishes_right(process):
    out, errors = process.communicate(timeout=600)
    assert out.strip() == "right", errors


def test_an_entry_comes_back_as_it_was(folder):
    cache.write(KEY, b"content")
    assert cache.read(KEY) == b"content"


def test_what_was_never_written_is_a_miss(folder):
    assert cache.read(KEY) is None


@pytest.mark.parametrize("length", [0, 5, 12, 30, 44, 50])
def test_a_truncated_entry_is_a_miss(folder, length):
    cache.write(KEY, b"content")
    path = folder / f"{KEY}.code"
    path.write_bytes(path.read_bytes()[:length])
    assert cache.read(KEY) is None


def test_an_entry_with_one_wrong_bit_is_a_miss(folder):
    cache.write(KEY, b"content")
    path = folder / f"{KEY}.code"
    data = bytearray(path.read_bytes())
    data[-1] ^= 1
    path.write_bytes(data)
    assert cache.read(KEY) is None


def test_the_least_recently_used_entry_goes_first(folder, monkeypatch):
    monkeypatch.setattr(cache, "LIMIT_BYTES", 300)  # three entries
    for age, key in enumerate([OLD, USED, KEY]):
        cache.write(key, b"x" * 50)
        os.utime(folder / f"{key}.code", (age, age))
    cache.read(OLD)  # used again: now the most recent
    cache.write(OTHER, b"x" * 50)
    assert cache.read(USED) is None
    assert cache.read(OLD) is not None
    assert cache.read(OTHER) is not None


def test_the_folder_is_looked_through_after_a_share_of_the_limit(folder, monkeypatch):
    looks = []
    monkeypatch.setattr(cache, "_evict", looks.append)
    monkeypatch.setattr(cache, "LIMIT_BYTES", 64 * 100)
    for k in range(30):
        cache.write(f"{k:064x}", b"x" * 10)
    assert len(looks) == 1 + 29 * 10 // 110


def test_what_a_killed_process_left_behind_is_swept_up(folder):
    folder.mkdir(parents=True)
    left = folder / f"{OTHER}.a_7bcdef.tmp"
    left.write_bytes(b"half")
    os.utime(left, (0, 0))
    cache.write(KEY, b"content")
    assert not left.exists()


def test_files_of_other_names_stay_where_they_are(folder, monkeypatch):
    cache.write(KEY, b"content")
    users = [folder.parent / "tmp-thesis", folder / "tmp-thesis", folder / "thesis.code"]
    users += [folder / "12.code", folder / f"{KEY}.tmp", folder / f"{KEY}x.code"]
    users += [folder.parent / f"{OTHER}.code"]
    for path in users:
        path.write_bytes(b"mine")
        os.utime(path, (0, 0))
    monkeypatch.setattr(cache, "LIMIT_BYTES", 0)
    cache.write(KEY, b"content")
    assert cache.read(KEY) is None  # beyond the limit
    assert all(path.read_bytes() == b"mine" for path in users)


def test_a_tilde_in_the_name_of_the_folder_is_the_home_directory(tmp_path, monkeypatch):
    monkeypatch.setenv("HOME", str(tmp_path))
    monkeypatch.setenv("USERPROFILE", str(tmp_path))
    monkeypatch.setenv("PYDY_CACHE_DIR", "~/mine")
    assert cache.folder() == (tmp_path / "mine" / "pydy-cache").resolve()


@pytest.mark.skipif(os.name == "nt", reason="a working directory cannot be removed there")
def test_a_working_directory_that_is_gone_costs_only_the_cache(tmp_path, monkeypatch):
    monkeypatch.setenv("PYDY_CACHE_DIR", "beside")
    gone = tmp_path / "gone"
    gone.mkdir()
    monkeypatch.chdir(gone)
    gone.rmdir()
    cache.write(KEY, b"content")
    assert cache.read(KEY) is None


def test_a_folder_that_is_a_file_costs_only_the_cache(tmp_path, monkeypatch):
    (tmp_path / "cache").write_text("not a folder")
    monkeypatch.setenv("PYDY_CACHE_DIR", str(tmp_path / "cache"))
    cache.write(KEY, b"content")
    assert cache.read(KEY) is None


def test_the_cache_can_be_turned_off(tmp_path, monkeypatch):
    monkeypatch.setenv("PYDY_CACHE_DIR", "off")
    monkeypatch.chdir(tmp_path)
    cache.write(KEY, b"content")
    assert cache.folder() is None
    assert cache.read(KEY) is None
    assert list(tmp_path.iterdir()) == []


def test_entries_under_each_others_names_are_compiled_anew(folder):
    finishes_right(start())
    paths = sorted(folder.glob("*.code"))
    contents = [path.read_bytes() for path in paths]
    for path, data in zip(paths, contents[1:] + contents[:1], strict=True):
        path.write_bytes(data)
    finishes_right(start())


def test_killed_processes_truncated_entries_and_four_at_once_give_right_results(folder):
    rng = random.Random(0)
    for _ in range(3):
        process = start()
        time.sleep(rng.uniform(0.5, 2.5))
        process.send_signal(signal.SIGKILL)
        process.communicate()
    for path in folder.glob("*.code"):
        if rng.random() < 0.5:
            path.write_bytes(path.read_bytes()[: rng.randrange(200)])
    processes = [start() for _ in range(4)]
    for process in processes:
        finishes_right(process)
    assert list(folder.glob("*.code"))


# -- nobody else's code ---------------------------------------------------------------------------

owned = pytest.mark.skipif(not hasattr(os, "geteuid"), reason="files have no owners here")
second_user = pytest.mark.skipif(
    not hasattr(os, "geteuid") or os.geteuid() != 0,
    reason="only root can start a process of another user",
)
NOBODY = 65534


@pytest.fixture(autouse=True)
def nothing_said_yet(monkeypatch):
    monkeypatch.setattr(cache, "_warned", set())


@owned
@pytest.mark.parametrize("umask", [0o000, 0o002, 0o022])
def test_folders_and_entries_are_made_for_the_user_alone(tmp_path, monkeypatch, umask):
    monkeypatch.setenv("PYDY_CACHE_DIR", str(tmp_path / "new" / "cache"))
    before = os.umask(umask)
    try:
        cache.write(KEY, b"content")
    finally:
        os.umask(before)
    made = [tmp_path / "new", tmp_path / "new/cache", tmp_path / "new/cache/pydy-cache"]
    assert [stat.S_IMODE(path.stat().st_mode) for path in made] == [0o700] * 3
    assert stat.S_IMODE((made[-1] / f"{KEY}.code").stat().st_mode) == 0o600
    assert cache.read(KEY) == b"content"


@owned
@pytest.mark.parametrize("mode", [0o720, 0o770, 0o702, 0o777, 0o1777])
def test_a_folder_that_others_can_write_to_is_not_used(folder, mode):
    cache.write(KEY, b"content")
    folder.chmod(mode)
    with pytest.warns(
        PyDyUserWarning, match=f"pydy-cache' can be written by others .mode {mode:04o}"
    ):
        assert cache.read(KEY) is None
    cache.write(OTHER, b"content")  # it is said once
    assert not (folder / f"{OTHER}.code").exists()
    folder.chmod(0o700)
    assert cache.read(KEY) == b"content"


@owned
def test_the_warning_names_the_remedy(folder):
    folder.mkdir(parents=True)
    folder.chmod(0o777)
    with pytest.warns(PyDyUserWarning, match="chmod go-w.*PYDY_CACHE_DIR"):
        cache.read(KEY)


@owned
@pytest.mark.parametrize("mode", [0o620, 0o602, 0o666])
def test_an_entry_that_others_can_write_to_is_not_used(folder, mode):
    cache.write(KEY, b"content")
    (folder / f"{KEY}.code").chmod(mode)
    with pytest.warns(PyDyUserWarning, match="code' can be written by others"):
        assert cache.read(KEY) is None
    cache.write(KEY, b"content")
    assert cache.read(KEY) == b"content"


@owned
def test_what_belongs_to_another_user_is_not_used(folder, monkeypatch):
    cache.write(KEY, b"content")
    owner = os.getuid()
    monkeypatch.setattr(os, "geteuid", lambda: owner + 1)
    with pytest.warns(PyDyUserWarning, match=f"belongs to another user .uid {owner}"):
        assert cache.read(KEY) is None


@owned
@pytest.mark.parametrize("mode", [0o777, 0o770])
def test_a_folder_that_others_could_exchange_is_not_used(tmp_path, monkeypatch, mode):
    shared = tmp_path / "shared"
    monkeypatch.setenv("PYDY_CACHE_DIR", str(shared / "cache"))
    cache.write(KEY, b"content")
    shared.chmod(mode)
    monkeypatch.setattr(cache, "_is_private", lambda *_: False)
    with pytest.warns(PyDyUserWarning, match="shared' can be written by others"):
        assert cache.read(KEY) is None


@owned
def test_a_parent_that_the_users_own_group_may_write_to_is_safe(tmp_path, monkeypatch):
    monkeypatch.setenv("PYDY_CACHE_DIR", str(tmp_path / "home" / "cache"))
    cache.write(KEY, b"content")
    (tmp_path / "home").chmod(0o775)
    monkeypatch.setattr(cache, "_is_private", lambda *_: True)
    assert cache.read(KEY) == b"content"
    (tmp_path / "home" / "cache" / "pydy-cache").chmod(0o770)
    with pytest.warns(PyDyUserWarning, match="pydy-cache' can be written by others"):
        assert cache.read(KEY) is None


@owned
@pytest.mark.parametrize(
    ("first", "name", "members", "private"),
    [
        (700, "ann", [], True),
        (700, "ann", ["ann"], True),
        (700, "ann", ["ann", "bob"], False),
        (700, "staff", [], False),
        (100, "ann", [], False),
    ],
)
def test_a_group_is_private_if_it_is_the_users_first_and_nobody_else_is_in_it(
    monkeypatch, first, name, members, private
):
    import grp
    import pwd

    user = SimpleNamespace(pw_name="ann", pw_gid=first)
    group = SimpleNamespace(gr_name=name, gr_mem=members)
    monkeypatch.setattr(pwd, "getpwuid", lambda _: user)
    monkeypatch.setattr(grp, "getgrgid", lambda _: group)
    assert cache._is_private.__wrapped__(700, 700) is private


@owned
def test_a_folder_of_ones_own_where_everybody_may_have_one_is_used(tmp_path, monkeypatch):
    (tmp_path / "tmp").mkdir()
    (tmp_path / "tmp").chmod(0o1777)
    monkeypatch.setenv("PYDY_CACHE_DIR", str(tmp_path / "tmp" / "cache"))
    cache.write(KEY, b"content")
    assert cache.read(KEY) == b"content"


@owned
def test_a_link_is_judged_by_where_it_leads(tmp_path, monkeypatch):
    (tmp_path / "open").mkdir()
    (tmp_path / "open").chmod(0o777)
    (tmp_path / "link").symlink_to(tmp_path / "open", target_is_directory=True)
    monkeypatch.setenv("PYDY_CACHE_DIR", str(tmp_path / "link"))
    with pytest.warns(PyDyUserWarning, match="open' can be written by others"):
        assert cache.folder() is None


@owned
@pytest.mark.parametrize("kind", ["link", "pipe", "folder"])
def test_an_entry_is_a_file(folder, kind, tmp_path):
    cache.write(OTHER, b"content")
    cache.write(KEY, b"content")
    path = folder / f"{KEY}.code"
    path.rename(tmp_path / "elsewhere")
    if kind == "link":
        path.symlink_to(tmp_path / "elsewhere")
    elif kind == "pipe":
        os.mkfifo(path)
    else:
        path.mkdir()
    assert cache.read(KEY) is None


@owned
def test_an_entry_is_checked_when_it_is_open(folder, monkeypatch):
    # Another one may lie there by the time it is looked at by name.
    cache.write(KEY, b"content")
    seen = []
    fstat = os.fstat
    monkeypatch.setattr(os, "fstat", lambda number: seen.append(number) or fstat(number))
    assert cache.read(KEY) == b"content"
    assert seen


def test_where_files_have_no_owners_the_cache_works(folder, monkeypatch):
    monkeypatch.delattr(os, "geteuid", raising=False)
    cache.write(KEY, b"content")
    assert cache.read(KEY) == b"content"


@pytest.fixture
def shared():
    """A folder that any user can reach and write to."""
    with tempfile.TemporaryDirectory(prefix="pydy-shared-") as place:
        os.chmod(place, 0o777)
        yield Path(place)


def as_nobody(*command):
    subprocess.run(command, check=True, user=NOBODY, group=NOBODY, extra_groups=[])


def put_by_somebody_else(prepared, place):
    """Copy a folder as another user, who may read it for the moment."""
    for path in (prepared, *prepared.rglob("*")):
        path.chmod(0o755)
    with tempfile.TemporaryDirectory() as way:
        os.chmod(way, 0o755)
        subprocess.run(["cp", "-r", str(prepared), f"{way}/prepared"], check=True)
        as_nobody("mkdir", "-p", str(place))
        as_nobody("cp", "-r", f"{way}/prepared/.", str(place))


EQUATIONS = """
import sys, warnings
import numpy as np
from pydy._backends.llvm import compiling
if sys.argv[1:] == ["wrong"]:
    right = compiling.binding.parse_assembly
    def wrong(text, *rest):
        return right(text.replace("fsub", "fadd").replace("fneg double", "fadd double 1.0,"), *rest)
    compiling.binding.parse_assembly = wrong
from pydy.models import multi_mass_spring_damper
with warnings.catch_warnings(record=True) as said:
    warnings.simplefilter("always")
    system = multi_mass_spring_damper(2)
    system.generate_ode_function()
    rates = system.evaluate_ode(np.arange(1.0, 5.0))
print(*(type(w.message).__name__ for w in said), *rates)
"""


def equations(place, *how):
    done = subprocess.run(
        [sys.executable, "-c", EQUATIONS, *how],
        env={**os.environ, "PYDY_CACHE_DIR": str(place)},
        capture_output=True,
        text=True,
        check=True,
    )
    return done.stdout.split()


# Open to all; open to all until just now; a place where everybody may have a folder.
places = pytest.mark.parametrize(
    ("within", "mode"), [(".", 0o777), (".", 0o755), ("cache", 0o777), ("cache", 0o1777)]
)


@pytest.fixture(scope="module")
def wrong_code(tmp_path_factory):
    """A folder with machine code of other equations, and what the right ones give."""
    place = tmp_path_factory.mktemp("code") / "prepared"
    right = equations("off")
    wrong = equations(place, "wrong")
    assert wrong != right
    assert equations(place) == wrong  # one's own code is believed
    return place, right


@second_user
@places
def test_another_users_machine_code_ends_in_a_warning_and_a_correct_number(
    shared, wrong_code, within, mode
):
    place, right = wrong_code
    put_by_somebody_else(place, shared / within)
    shared.chmod(mode)
    *said, first, second, third, fourth = equations(shared / within)
    assert set(said) == {"PyDyUserWarning"}
    assert [first, second, third, fourth] == right


# -- no home ---------------------------------------------------------------------------------------

HOMELESS = """
import os, platformdirs, sys, warnings
from pydy import _cache_folder as cache
key = "7" * 64
with warnings.catch_warnings(record=True) as told:
    warnings.simplefilter("always")
    cache.write(key, b"code")
    content = cache.read(key)
print(cache.folder(), content, [str(w.message)[:27] for w in told], sep="|")
"""


@pytest.mark.parametrize("chosen", [None, "~/own"])
@pytest.mark.skipif(not hasattr(os, "geteuid"), reason="Windows knows the home of every user")
def test_a_user_without_a_home_has_a_private_folder_and_one_warning(tmp_path, chosen):
    """As in ``docker run --user 54321``: neither HOME nor the user database tells a home."""
    lost = ("HOME", "USER", "LOGNAME", "XDG_CACHE_HOME", "PYDY_CACHE_DIR")
    env = {k: v for k, v in os.environ.items() if k not in lost} | {"TMPDIR": str(tmp_path)}
    if chosen is not None:
        env["PYDY_CACHE_DIR"] = chosen
    unknown = "import pwd\ndef unknown(*_): raise KeyError('getpwuid(): uid not found')\n"
    unknown += "pwd.getpwuid = pwd.getpwnam = unknown\n"
    tmp_path.chmod(0o700)
    done = subprocess.run(
        [sys.executable, "-c", unknown + HOMELESS],
        env=env, capture_output=True, text=True, check=True, cwd=tmp_path,
    )  # fmt: skip
    place, content, told = done.stdout.strip().split("|")
    assert Path(place) == tmp_path.resolve() / f"pydy-cache-{os.geteuid()}"
    assert stat.S_IMODE(os.stat(place).st_mode) == 0o700
    assert content == "b'code'"
    assert told == "['The user has no home folder']"
    assert [p.name for p in tmp_path.iterdir()] == [Path(place).name]  # none called ~
