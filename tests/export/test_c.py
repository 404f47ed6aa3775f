"""The C of a model: compiled with every warning on, it computes what the System does."""

import ctypes
import shutil
import subprocess
from dataclasses import replace

import numpy as np
import pytest

from pydy._evaluation.exporting import exported_model
from pydy.export import Variable, write
from pydy.export.c import c_string
from pydy.export.model import identifiers
from zoo.exported_models import (
    ball,
    hostile,
    kicked,
    kicked_at_an_input,
    pendulum,
    spring_of,
)

COMPILERS = [name for name in ("gcc", "clang") if shutil.which(name)]
STRICT = ["-std=c99", "-Wall", "-Wextra", "-Werror", "-pedantic"]


def test_there_is_a_compiler_to_test_with():
    assert COMPILERS


def built(compiler, path, folder):
    """Compile a source, strictly, and load it."""
    library = folder / f"{path.stem}-{compiler}.so"
    command = [compiler, *STRICT, "-O1", "-fPIC", "-shared", "-o", library, path, "-lm"]
    done = subprocess.run(command, capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stderr
    return ctypes.CDLL(str(library))


def pointer(array):
    return array.ctypes.data_as(ctypes.c_void_p)


def call(library, name, t, x, r, p, size):
    prepared, out = np.zeros(10_000), np.zeros(size)
    prefix, what = name
    getattr(library, f"{prefix}_prepare")(pointer(p), pointer(prepared))
    function = getattr(library, f"{prefix}_{what}")
    status = function(ctypes.c_double(t), pointer(x), pointer(r), pointer(prepared), pointer(out))
    return out, status


def test_progress_names_the_parts_and_nothing_is_shown_unasked(tmp_path, capsys):
    pytest.importorskip("tqdm")
    system = pendulum()
    system.export(tmp_path / "quiet.c")
    assert capsys.readouterr() == ("", "")
    system.export(tmp_path / "shown.c", progress=True)
    out, shown = capsys.readouterr()
    assert not out
    for part in ("equations", "rates", "outputs", "jacobian"):
        assert f"part={part}" in shown
    assert "4 parts" in shown.splitlines()[-1]
    same = (tmp_path / "quiet.c").read_text().replace("quiet", "shown").replace("QUIET", "SHOWN")
    assert same == (tmp_path / "shown.c").read_text()
    with pytest.raises(TypeError, match="`progress` must be True or False, got 'yes'"):
        system.export(tmp_path / "wrong.c", progress="yes")


@pytest.mark.parametrize("compiler", COMPILERS)
def test_rates_outputs_and_jacobian_are_those_of_the_system(tmp_path, compiler):
    system = pendulum()
    exported = system.export(tmp_path / "pendulum.c")
    assert [path.name for path in exported.files] == ["pendulum.c", "pendulum.h"]
    library = built(compiler, exported.path, tmp_path)
    x, r, p = np.linspace(0.2, 1.1, 6), np.array([0.7]), np.array([9.81, 0.7, 1.1, 0.9, 1.2, 0.8])
    p = p[: len(system.constants_symbols)]
    values = dict(zip(system.constants_symbols, p, strict=True))
    inputs = {"F": r[0]}
    rates, status = call(library, ("pendulum", "rates"), 0.3, x, r, p, 6)
    assert status == 0
    assert rates == pytest.approx(system.evaluate_ode(x, t=0.3, r=inputs, p=values), rel=1e-12)
    outputs, _ = call(library, ("pendulum", "outputs"), 0.3, x, r, p, system.num_outputs)
    expected = system.evaluate_outputs(x, t=0.3, r=inputs, p=values)
    assert outputs == pytest.approx(expected, rel=1e-12)
    rows = 6 + system.num_outputs
    jacobian, _ = call(library, ("pendulum", "jacobian"), 0.3, x, r, p, rows * 7)
    by_states = system.evaluate_jacobian(x, t=0.3, r=inputs, p=values)
    assert jacobian.reshape(rows, 7)[:6, :6] == pytest.approx(by_states, rel=1e-11, abs=1e-11)


@pytest.mark.parametrize("compiler", COMPILERS)
def test_a_program_of_a_user_compiles_against_the_header(tmp_path, compiler):
    pendulum().export(tmp_path / "pendulum.c")
    (tmp_path / "main.c").write_text(
        """
#include <stdio.h>
#include "pendulum.h"
int main(void)
{
    double prepared[PENDULUM_PREPARED], rates[PENDULUM_STATES];
    pendulum_constants constants = pendulum_defaults;
    constants.l0 = 1.5;
    pendulum_prepare(&constants, prepared);
    if (pendulum_rates(0.0, pendulum_initial, pendulum_inputs, prepared, rates))
        return 1;
    for (int k = 0; k < PENDULUM_STATES; k++)
        printf("%s %.17g\\n", pendulum_state_names[k], rates[k]);
    return 0;
}
"""
    )
    program = tmp_path / "main"
    sources = [tmp_path / "main.c", tmp_path / "pendulum.c"]
    subprocess.run([compiler, *STRICT, "-o", program, *sources, "-lm"], check=True)
    text = subprocess.run([program], capture_output=True, text=True, check=True).stdout
    found = {name: float(value) for name, value in map(str.split, text.splitlines())}
    system = pendulum()
    system.constants = {**system.constants, "l0": 1.5}
    expected = dict(zip(map(str, system.states), system.evaluate_ode(), strict=True))
    assert found == pytest.approx({k.removesuffix("(t)"): v for k, v in expected.items()})


@pytest.mark.parametrize("compiler", COMPILERS)
def test_names_end_neither_comments_nor_strings(tmp_path, compiler):
    system = hostile()
    exported = system.export(tmp_path / "mass.c", name='*/ "</x> mass')
    library = built(compiler, exported.path, tmp_path)
    x, p = np.array([0.5, 0.1]), np.array([3.0, 2.0])
    p = np.array([system.constants[s] for s in system.constants_symbols])
    rates, _ = call(library, ("x_mass", "rates"), 0.0, x, np.zeros(1), p, 2)
    assert rates == pytest.approx(system.evaluate_ode(x, t=0.0))
    names = (ctypes.c_char_p * 2).in_dll(library, "x_mass_constant_names")
    assert [name.decode() for name in names] == [str(s) if "\u2028" not in str(s) else
        str(s).replace("\u2028", " ") for s in system.constants_symbols]  # fmt: skip


@pytest.mark.parametrize("compiler", COMPILERS)
def test_events_and_their_resets_are_there(tmp_path, compiler):
    system, bounce = ball()
    library = built(compiler, system.export(tmp_path / "ball.c", events=bounce).path, tmp_path)
    x, p = np.array([0.0, -2.0]), np.array([9.81, 0.2])
    assert call(library, ("ball", "events"), 0.0, x, np.zeros(1), p, 1)[0] == 0.0
    assert call(library, ("ball", "event_rates"), 0.0, x, np.zeros(1), p, 1)[0] == -2.0
    after = call(library, ("ball", "resets"), 0.0, x, np.zeros(1), p, 2)[0]
    assert after == pytest.approx([0.0, 1.6])


def test_the_times_at_which_rates_switch_follow_the_constants(tmp_path):
    system = kicked()
    library = built(COMPILERS[0], system.export(tmp_path / "kicked.c").path, tmp_path)
    values = {"t0": 7.0, "w": 0.25, "a": 2.0, "b": 3.0}
    p = np.array([values[str(s)] for s in system.constants_symbols])
    times, _ = call(library, ("kicked", "switches"), 0.0, np.zeros(2), np.zeros(1), p, 3)
    assert sorted(times) == [1.5, 7.0, 7.25]


def test_the_times_at_which_rates_switch_follow_the_inputs(tmp_path):
    system = kicked_at_an_input()
    library = built(COMPILERS[0], system.export(tmp_path / "kicked.c").path, tmp_path)
    r, p = np.array([7.0]), np.array([0.25])
    times, _ = call(library, ("kicked", "switches"), 0.0, np.zeros(2), r, p, 2)
    assert sorted(times) == [7.0, 7.25]


def test_a_string_keeps_every_character(tmp_path):
    text = 'q"\\?/*θ'
    assert eval(f"b{c_string(text)}").decode() == text


HEADERS = (
    *("assert", "complex", "ctype", "errno", "fenv", "float", "inttypes", "iso646", "limits"),
    *("locale", "math", "setjmp", "signal", "stdalign", "stdarg", "stdbool", "stddef", "stdint"),
    *("stdio", "stdlib", "string", "time", "uchar", "wchar", "wctype", "unistd", "termios"),
    *("fcntl", "pthread", "sys/types", "sys/stat", "sys/socket", "sys/mman", "sys/wait"),
    *("netinet/in", "arpa/inet", "dlfcn", "poll", "semaphore", "sched", "netdb", "regex"),
)
KEYWORDS = (  # noqa: SIM905 - as a text it is read more easily
    "alignas alignof and and_eq asm auto bitand bitor bool break case catch char char8_t char16_t "
    "char32_t class compl complex concept const consteval constexpr constinit const_cast continue "
    "co_await co_return co_yield decltype default delete do double dynamic_cast else enum explicit "
    "export extern false float for friend goto if inline int long mutable namespace new noexcept "
    "not not_eq nullptr operator or or_eq private protected public register reinterpret_cast "
    "requires restrict return short signed sizeof static static_assert static_cast struct switch "
    "template this thread_local throw true try typedef typeid typename typeof typeof_unqual union "
    "unsigned using virtual void volatile wchar_t while xor xor_eq assert errno offsetof setjmp"
).split()


@pytest.mark.skipif("gcc" not in COMPILERS, reason="macros are read from gcc")
@pytest.mark.parametrize("language", ["c", "c++"])
def test_no_constant_is_called_like_a_keyword_or_a_macro_of_any_header(tmp_path, language):
    includes = "".join(f"#include <{name}.h>\n" for name in HEADERS)
    if language == "c++":
        includes = includes.replace("#include <complex.h>\n", "")
    listing = ["gcc", "-x", language, f"-std={language.replace('c', 'gnu', 1)}17", "-dM", "-E", "-"]
    defined = subprocess.run(listing, input=includes, capture_output=True, text=True, check=True)
    macros = {line.split()[1] for line in defined.stdout.splitlines()}
    macros = {name for name in macros if "(" not in name and name[0] != "_"}
    assert {"NULL", "EOF", "linux", "unix", "M_PI", "stdin", "B50"} <= macros
    names = sorted({*macros, *KEYWORDS, "I", "NX", "m", "K1", "length"})
    # A System with as many constants would take minutes.
    model = exported_model(spring_of("k")._now(), name="spring")
    constants = tuple(map(Variable, names, identifiers(names)))
    exported = write(replace(model, constants=constants), tmp_path / "spring.c")
    assert set(names) - exported.names.keys() == {"m", "K1", "length"}
    main = tmp_path / f"main.{language}"
    main.write_text(f'{includes}#include "spring.h"\n#include "spring.c"\n')
    std = ["-x", language, f"-std={language.replace('c', 'gnu', 1)}17"]
    command = ["gcc", *std, "-fsyntax-only", "-Wall", "-Werror", main]
    done = subprocess.run(command, capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stderr[:2000]


@pytest.mark.parametrize("name", ['a"b\\', "x\ny", "\udcff", "π" * 100])
def test_a_file_may_have_any_name(tmp_path, name):
    exported = spring_of("k").export(tmp_path / f"{name}.c")
    assert [path.name for path in exported.files] == [f"{name}.c", f"{name}.h"]
    shutil.copy(exported.path, tmp_path / "plain.c")
    built(COMPILERS[0], tmp_path / "plain.c", tmp_path)


def test_surrogates_in_names_are_written_out():
    assert eval(f"b{c_string(chr(0xD800))}") == rb"\ud800"
