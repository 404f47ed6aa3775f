"""A model as a functional mock-up unit: FMI 3.0 or 2.0, Model Exchange and Co-Simulation.

The unit contains the model's C code, an interface in C, and the library compiled from both for this
platform. No Python is needed to use it.
"""

from __future__ import annotations

import hashlib
import os
import platform
import shlex
import shutil
import sys
import sysconfig
import tempfile
import zipfile
from collections.abc import Iterable, Iterator
from dataclasses import replace
from io import BytesIO
from pathlib import Path
from typing import NamedTuple
from xml.sax.saxutils import quoteattr

from pydy._backends import HELPERS
from pydy._errors import GeneratorError
from pydy._files import temporary_folder
from pydy._names import unused_name
from pydy._processes import output_of, started
from pydy._version import __version__
from pydy.export.c import c_header, c_literal, c_model_source, c_string
from pydy.export.model import Model, plain_text, resource
from pydy.solvers import method_arrays, portable_sources

_METHOD = "dop853"


def fmu_archive(model: Model, fmi: str = "3.0", binary: bool = True) -> bytes:
    """Return the unit; raise a GeneratorError if there is no C compiler, or if it fails."""
    # Generated names, which do not conflict with the hand-written sources.
    constants = [replace(v, identifier=f"p_{k}") for k, v in enumerate(model.constants)]
    sources = _sources(replace(model, name="pydy_model", constants=tuple(constants)), fmi)
    # A path of Windows has 260 characters at most.
    model = replace(model, name=model.name[:100])
    token = _token(sources)
    sources["config.h"] = sources["config.h"].replace("{{TOKEN}}", c_string(token))
    entries: dict[str, bytes] = {
        "modelDescription.xml": model_description(model, fmi, token).encode()
    }
    entries.update((f"sources/{name}", text.encode()) for name, text in sources.items())
    if fmi == "3.0":
        entries["sources/buildDescription.xml"] = _build_description(model).encode()
    if binary:
        folder, suffix = _platform(fmi)
        model.told(0, part="C compiler")
        entries[f"binaries/{folder}/{model.name}{suffix}"] = _library(sources, suffix)
        model.told(1)
    file = BytesIO()
    with zipfile.ZipFile(file, "w", zipfile.ZIP_DEFLATED) as archive:
        for name, data in entries.items():
            # The same model gives the same file.
            archive.writestr(zipfile.ZipInfo(name, (1980, 1, 1, 0, 0, 0)), data)
    return file.getvalue()


# -- sources --------------------------------------------------------------------------------------


def _sources(model: Model, fmi: str) -> dict[str, str]:
    head = [f"{model.title}: exported by pydy {__version__}."]
    ours = {name: resource(name) for name in ("fmu_core.c", "fmu_solver.c", "fmi.c")}
    return {
        "all.c": _unit(),
        **portable_sources("advance.c", "scan_events.c", "departure.h", texts=ours),
        "config.h": "\n".join([c_header(model, head), *_config(model, fmi)]),
        "model.c": c_model_source(model, head),
    }


def _unit() -> str:
    """Return the single compilation unit.

    The model comes before the macros of the integration loop, and its helper functions are renamed:
    the loop has helpers of the same names.
    """
    ours = [f"#define {name}(...) model_{name}(__VA_ARGS__)" for name in HELPERS]
    theirs = [f"#undef {name}" for name in HELPERS]
    parts = ['#include "config.h"', *ours, '#include "model.c"', *theirs, '#include "fmi.c"']
    return "\n".join([*parts, ""])


def _config(model: Model, fmi: str) -> Iterator[str]:
    yield "/* The model's sizes, and the method behind Co-Simulation. */\n"
    yield f"#define MODEL(what) {model.name}_##what"
    yield "#define TOKEN {{TOKEN}}"
    yield f"#define FMI {fmi[0]}"
    yield f"#define START_TIME {c_literal(model.start)}"
    yield f"#define STOP_TIME {c_literal(model.stop)}"
    yield f"#define TOLERANCE {_TOLERANCE}"
    sizes = {
        "NX": len(model.states),
        "NU": len(model.inputs),
        "NY": len(model.outputs),
        "NP": len(model.constants),
        "NE": len(model.events),
        "NS": model.switches,
        "NC": len(model.constraint_names),
    }
    arrays = method_arrays(_METHOD, len(model.states))
    sizes["NVECTORS"], sizes["NPARTS"] = len(arrays.nodes), arrays.depth
    for name, size in sizes.items():
        yield f"#define {name} {size}"
    yield f"#define NPREPARED {model.name.upper()}_PREPARED"
    for name, array in arrays._asdict().items():
        kind = "double" if array.dtype == float else "int64_t"
        yield _array(kind, f"METHOD_{name.upper()}", array.tolist())
    events = model.events
    yield _array("int64_t", "EVENT_DIRECTIONS", events.directions)
    yield _array("int64_t", "EVENT_TERMINAL", map(int, events.terminal))
    yield _array("int64_t", "EVENT_ACTING", map(int, events.acting))
    yield _array("int64_t", "EVENT_REDIRECTS", map(int, events.redirects))
    yield ""


def _array(kind: str, name: str, values: Iterable[object]) -> str:
    text = ", ".join(map(repr, values)) or "0"
    return f"static const {kind} {name}[] = {{{text}}};"


def _token(sources: dict[str, str]) -> str:
    sha = hashlib.sha256("\0".join(sources.values()).encode()).hexdigest()
    return f"{{{sha[:8]}-{sha[8:12]}-{sha[12:16]}-{sha[16:20]}-{sha[20:32]}}}"


# -- the library ----------------------------------------------------------------------------------


def compiler() -> list[str]:
    """Return the command of this machine's C compiler, or raise a GeneratorError."""
    named = os.environ.get("CC", "").strip()
    if named:
        return _words(named)
    built = shlex.split(sysconfig.get_config_var("CC") or "")[:1]
    for name in (*built, "cc", "gcc", "clang", "cl"):
        if path := shutil.which(name):
            return [path]
    raise GeneratorError(
        "The binary of an FMU needs a C compiler, and none was found: install gcc, clang or "
        "Visual C++, name one in the environment variable CC, or pass binary=False for an FMU of "
        "sources alone."
    )


def _words(command: str) -> list[str]:
    """Split a command into words, unless it is the path of a program, which may contain blanks."""
    if shutil.which(command):
        return [command]
    posix = sys.platform != "win32"
    try:
        words = shlex.split(command, posix=posix)
    except ValueError:
        raise GeneratorError(
            f"The environment variable CC is {command!r}, in which a quotation has no end. Close "
            "it, or unset CC."
        ) from None
    return words if posix else [word.strip('"') for word in words]  # keeps backslashes


def _library(sources: dict[str, str], suffix: str) -> bytes:
    command = compiler()
    with temporary_folder(Path(tempfile.gettempdir(), "pydy_fmu_")) as folder:
        for name, text in sources.items():
            (folder / name).write_text(text, encoding="utf-8")
        result = f"model{suffix}"
        if Path(command[0]).stem.lower() in ("cl", "clang-cl"):
            command += ["/nologo", "/O2", "/LD", "all.c", f"/Fe{result}"]
        else:
            # Windows needs neither -fPIC nor a separate mathematical library.
            unix = suffix != ".dll"
            command += ["-std=c99", "-O2", "-ffp-contract=off", "-fvisibility=hidden"]
            command += ["-shared", "-o", result, "all.c"]
            command += ["-fPIC", "-lm"] if unix else []
        try:
            with started(command, cwd=folder) as process:
                output = output_of(process)
        except OSError as error:
            raise GeneratorError(f"The C compiler {command[0]!r} cannot be run: {error}.") from None
        if process.returncode:
            tail = output[-2000:]
            raise GeneratorError(f"The C compiler {command[0]!r} failed on the FMU:\n{tail}")
        return (folder / result).read_bytes()


def _platform(fmi: str) -> tuple[str, str]:
    """Return FMI's name of this platform, and the suffix of its shared libraries."""
    system = {"win32": "windows", "darwin": "darwin"}.get(sys.platform, "linux")
    suffix = {"windows": ".dll", "darwin": ".dylib", "linux": ".so"}[system]
    machine = platform.machine().lower()
    machine = {"amd64": "x86_64", "arm64": "aarch64"}.get(machine, machine)
    if fmi == "3.0":
        return f"{machine}-{system}", suffix
    return {"windows": "win", "darwin": "darwin", "linux": "linux"}[system] + "64", suffix


# -- the description ------------------------------------------------------------------------------


def _attributes(**values: object) -> str:
    """Return the XML attributes of an element, without those that are None."""
    return "".join(f" {k}={quoteattr(str(v))}" for k, v in values.items() if v is not None)


def _rows(model: Model) -> Iterator[tuple[str, str, dict[str, object]]]:
    """Yield (kind, name, attributes) in the order of the value references; no name twice."""
    used = {"time"}

    def unique(name: str) -> str:
        chosen = unused_name(plain_text(name), used, " ")
        used.add(chosen)
        return chosen

    exact = {"initial": "exact", "variability": "continuous"}
    calculated = {"initial": "calculated", "variability": "continuous"}
    states = [unique(v.name) for v in model.states]
    for name, v in zip(states, model.states, strict=True):
        yield "state", name, {"causality": "output", **exact, "start": repr(v.value)}
    for k, name in enumerate(states):
        yield (
            "rate",
            unique(f"der({name})"),
            {"causality": "local", **calculated, "derivative": k + 1},
        )
    for v in model.inputs:
        attributes: dict[str, object] = {
            "causality": "input",
            "variability": "continuous",
            "start": repr(v.value),
        }
        yield "input", unique(v.name), attributes
    for v in model.outputs:
        yield "output", unique(v.name), {"causality": "output", **calculated}
    for v in model.constants:
        attributes = {"causality": "parameter", "variability": "tunable", "initial": "exact"}
        yield "constant", unique(v.name), {**attributes, "start": repr(v.value)}
    for name in model.events.names:
        yield "event", unique(f"event: {name}"), {"causality": "local", **calculated}


class _Words(NamedTuple):
    """The terms of a version of FMI."""

    token: str
    abilities: tuple[str, ...]
    files: str  # the element that lists the sources; FMI 3.0 has a separate file
    structure: dict[str, tuple[str, ...]]


_WORDS = {
    "3.0": _Words(
        "instantiationToken",
        (
            *("canGetAndSetFMUState", "canSerializeFMUState"),
            *("providesDirectionalDerivatives", "providesAdjointDerivatives"),
        ),
        "",
        {
            "Output": ("state", "output"),
            "ContinuousStateDerivative": ("rate",),
            "InitialUnknown": ("rate", "output"),
            "EventIndicator": ("event",),
        },
    ),
    "2.0": _Words(
        "guid",
        ("canGetAndSetFMUstate", "canSerializeFMUstate", "providesDirectionalDerivative"),
        '<SourceFiles><File name="all.c"/></SourceFiles>',
        {
            "Outputs": ("state", "output"),
            "Derivatives": ("rate",),
            "InitialUnknowns": ("rate", "output"),
        },
    ),
}


# The default tolerance, which importers pass to their solver in Model Exchange. 1e-6 is the default
# `experiment(Tolerance)` of OpenModelica. At 1e-10 CVODE failed at jumps of inputs, where FMPy does
# not restart it.
_TOLERANCE = "1e-6"


def model_description(model: Model, fmi: str, token: str) -> str:
    """Return modelDescription.xml."""
    words, new = _WORDS[fmi], fmi == "3.0"
    head = {
        "fmiVersion": fmi,
        "modelName": plain_text(model.title),
        words.token: token,
        "generationTool": f"pydy {__version__}",
        "variableNamingConvention": "flat",
        "numberOfEventIndicators": None if new else len(model.events),
    }
    abilities = {"modelIdentifier": model.name, **dict.fromkeys(words.abilities, "true")}
    steps = {"canHandleVariableCommunicationStepSize": "true"}
    span = {"startTime": repr(model.start), "stopTime": repr(model.stop)}
    # FMI 2.0 calls the function unless the unit declines it.
    checked = {"needsCompletedIntegratorStep": "true"} if new and model.events.names else {}
    lines = [
        '<?xml version="1.0" encoding="UTF-8"?>',
        f"<fmiModelDescription{_attributes(**head)}>",
        f"  <ModelExchange{_attributes(**abilities, **checked)}>{words.files}</ModelExchange>",
        f"  <CoSimulation{_attributes(**abilities, **steps)}>{words.files}</CoSimulation>",
        f"  <DefaultExperiment{_attributes(**span, tolerance=_TOLERANCE)}/>",
        "  <ModelVariables>",
    ]
    if new:
        time = {"causality": "independent", "variability": "continuous"}
        lines.append(f"    <Float64{_attributes(name='time', valueReference=0, **time)}/>")
    references: dict[str, list[int]] = {}
    for k, (kind, name, attributes) in enumerate(_rows(model), start=1):
        references.setdefault(kind, []).append(k)
        identity = {"name": name, "valueReference": k}
        if new:
            lines.append(f"    <Float64{_attributes(**identity, **attributes)}/>")
        elif kind != "event":
            real_attributes = {n: attributes.pop(n, None) for n in ("start", "derivative")}
            scalar = f"ScalarVariable{_attributes(**identity, **attributes)}"
            lines.append(f"    <{scalar}><Real{_attributes(**real_attributes)}/></ScalarVariable>")
    lines += ["  </ModelVariables>", "  <ModelStructure>"]
    for element, kinds in words.structure.items():
        element_references = [k for kind in kinds for k in references.get(kind, ())]
        if new:
            lines += [f'    <{element} valueReference="{k}"/>' for k in element_references]
        elif element_references:
            unknowns = "".join(f'<Unknown index="{k}"/>' for k in element_references)
            lines.append(f"    <{element}>{unknowns}</{element}>")
    return "\n".join([*lines, "  </ModelStructure>", "</fmiModelDescription>", ""])


def _build_description(model: Model) -> str:
    return "\n".join(
        [
            '<?xml version="1.0" encoding="UTF-8"?>',
            '<fmiBuildDescription fmiVersion="3.0">',
            f"  <BuildConfiguration{_attributes(modelIdentifier=model.name)}>",
            '    <SourceFileSet language="C99"><SourceFile name="all.c"/></SourceFileSet>',
            '    <Library name="m"/>',
            "  </BuildConfiguration>",
            "</fmiBuildDescription>",
            "",
        ]
    )
