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
from pathlib import Path
from typing import Any
from xml.sax.saxutils import quoteattr

from pydy._errors import GeneratorError
from pydy._files import replacing
from pydy._processes import started
from pydy._version import __version__
from pydy.export.c import c_header, c_literal, c_model_source, c_string
from pydy.export.model import Model, Variable, resource
from pydy.solvers.core.declarations import included, layout_header
from pydy.solvers.run.layout import DEPTH
from pydy.solvers.run.methods import method_arrays

_METHOD = "dop853"
_TOLERANCE = 1e-10


def write_fmu(model: Model, path: Path, fmi: str, binary: bool) -> None:
    """Write the unit.

    Raises
    ------
    GeneratorError
        There is no C compiler, or it failed.
    """
    # Names of ours, which meet none in the hand-written sources.
    constants = [replace(v, identifier=f"p_{k}") for k, v in enumerate(model.constants)]
    sources = _sources(replace(model, name="pydy_model", constants=tuple(constants)), fmi)
    # Names of Windows' paths have 260 letters in all.
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
        entries[f"binaries/{folder}/{model.name}{suffix}"] = _library(sources, fmi, suffix)
    with (
        replacing(path) as (place,),
        zipfile.ZipFile(place, "w", zipfile.ZIP_DEFLATED) as archive,
    ):
        for name, data in entries.items():
            # The same model gives the same file.
            archive.writestr(zipfile.ZipInfo(name, (1980, 1, 1, 0, 0, 0)), data)


# -- sources --------------------------------------------------------------------------------------


def _sources(model: Model, fmi: str) -> dict[str, str]:
    interface, head = f"fmi{fmi[0]}.c", [f"{model.title}: exported by pydy {__version__}."]
    loop = {
        "fmu_core.c": resource("fmu_core.c"),
        "fmu_solver.c": resource("fmu_solver.c"),
        **included("advance.c", "scan_events.c"),
    }
    return {
        # The model's text must not meet the macros of the loop.
        "all.c": "".join(f'#include "{name}"\n' for name in ("config.h", "model.c", interface)),
        interface: resource(interface),
        **loop,
        "layout.h": layout_header("\n".join(loop.values()), plain=True),
        "config.h": "\n".join([c_header(model, head), *_config(model)]),
        "model.c": c_model_source(model, head),
    }


def _config(model: Model) -> Iterator[str]:
    yield "/* The model's sizes, and the method behind Co-Simulation. */\n"
    yield f"#define MODEL(what) {model.name}_##what"
    yield "#define TOKEN {{TOKEN}}"
    yield f"#define START_TIME {c_literal(model.start)}"
    sizes = {
        "NX": len(model.states),
        "NU": len(model.inputs),
        "NY": len(model.outputs),
        "NP": len(model.constants),
        "NE": len(model.events),
    }
    arrays = method_arrays(_METHOD, len(model.states))
    sizes["NVECTORS"], sizes["NPARTS"] = len(arrays.nodes), int(arrays.shape[DEPTH])
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
    yield ""


def _array(kind: str, name: str, values: Iterable[Any]) -> str:
    text = ", ".join(map(repr, values)) or "0"
    return f"static const {kind} {name}[] = {{{text}}};"


def _token(sources: dict[str, str]) -> str:
    sha = hashlib.sha256("\0".join(sources.values()).encode()).hexdigest()
    return f"{{{sha[:8]}-{sha[8:12]}-{sha[12:16]}-{sha[16:20]}-{sha[20:32]}}}"


# -- the library ----------------------------------------------------------------------------------


def compiler() -> list[str]:
    """Return the command of this machine's C compiler.

    Raises
    ------
    GeneratorError
        There is none.
    """
    named = os.environ.get("CC", "").strip()
    if named:
        return _words(named)
    built = shlex.split(sysconfig.get_config_var("CC") or "")[:1]
    for name in (*built, "cc", "gcc", "clang", "cl"):
        if found := shutil.which(name):
            return [found]
    raise GeneratorError(
        "The binary of an FMU needs a C compiler, and none was found: install gcc, clang or "
        "Visual C++, name one in the environment variable CC, or pass binary=False for an FMU of "
        "sources alone."
    )


def _words(command: str) -> list[str]:
    """Split a command, unless it is the path of a program, in whose folders there may be blanks."""
    if shutil.which(command):
        return [command]
    if sys.platform != "win32":
        return shlex.split(command)
    return [word.strip('"') for word in shlex.split(command, posix=False)]  # keeps backslashes


def _library(sources: dict[str, str], fmi: str, suffix: str) -> bytes:
    command = compiler()
    with tempfile.TemporaryDirectory(prefix="pydy_fmu_") as folder:
        for name, text in sources.items():
            Path(folder, name).write_text(text, encoding="utf-8")
        result = f"model{suffix}"
        if Path(command[0]).stem.lower() in ("cl", "clang-cl"):
            command += ["/nologo", "/O2", "/LD", "all.c", f"/Fe{result}"]
        else:
            # All code of Windows can be moved, and its C library has the mathematical functions.
            unix = suffix != ".dll"
            command += ["-std=c99", "-O2", "-ffp-contract=off", "-fvisibility=hidden"]
            command += ["-shared", "-o", result, "all.c"]
            command += ["-fPIC", "-lm"] if unix else []
        try:
            with started(command, cwd=folder) as process:
                assert process.stdout is not None
                said = process.stdout.read()
        except OSError as error:
            raise GeneratorError(f"The C compiler {command[0]!r} cannot be run: {error}.") from None
        if process.returncode:
            tail = said[-2000:]
            raise GeneratorError(f"The C compiler {command[0]!r} failed on the FMU:\n{tail}")
        return Path(folder, result).read_bytes()


def _platform(fmi: str) -> tuple[str, str]:
    """Name this platform as FMI does, with its suffix of libraries."""
    system = {"win32": "windows", "darwin": "darwin"}.get(sys.platform, "linux")
    suffix = {"windows": ".dll", "darwin": ".dylib", "linux": ".so"}[system]
    machine = platform.machine().lower()
    machine = {"amd64": "x86_64", "arm64": "aarch64"}.get(machine, machine)
    if fmi == "3.0":
        return f"{machine}-{system}", suffix
    return {"windows": "win", "darwin": "darwin", "linux": "linux"}[system] + "64", suffix


# -- the description ------------------------------------------------------------------------------


def model_description(model: Model, fmi: str, token: str) -> str:
    """Return modelDescription.xml."""
    lines = _description_3(model, token) if fmi == "3.0" else _description_2(model, token)
    return "\n".join(['<?xml version="1.0" encoding="UTF-8"?>', *lines, ""])


class _Names:
    """Names for the variables of the description, none twice."""

    def __init__(self) -> None:
        self.taken: set[str] = set()

    def __call__(self, name: str) -> str:
        plain = _plain(name)
        chosen, number = plain, 2
        while chosen in self.taken:
            chosen = f"{plain} {number}"
            number += 1
        self.taken.add(chosen)
        return chosen


def _plain(name: str) -> str:
    """Return a name without the characters that XML or UTF-8 forbid."""
    return "".join(c if c.isprintable() else " " for c in name)


def _attributes(**values: Any) -> str:
    """Return attributes of an element; those that are None are left out."""
    return "".join(f" {k}={quoteattr(str(v))}" for k, v in values.items() if v is not None)


def _rows(model: Model) -> Iterator[tuple[str, str, Variable, dict[str, Any]]]:
    """Yield (kind, name, variable, attributes) in the order of the value references."""
    names = _Names()
    names("time")
    states = [names(v.name) for v in model.states]
    start = {"initial": "exact", "variability": "continuous"}
    calculated = {"initial": "calculated", "variability": "continuous"}
    for name, v in zip(states, model.states, strict=True):
        yield "state", name, v, {"causality": "output", **start, "start": repr(v.value)}
    for k, (name, v) in enumerate(zip(states, model.states, strict=True)):
        attributes = {"causality": "local", **calculated, "derivative": k + 1}
        yield "rate", names(f"der({name})"), v, attributes
    for v in model.inputs:
        attributes = {"causality": "input", "variability": "continuous", "start": repr(v.value)}
        yield "input", names(v.name), v, attributes
    for v in model.outputs:
        yield "output", names(v.name), v, {"causality": "output", **calculated}
    for v in model.constants:
        attributes = {"causality": "parameter", "variability": "tunable", "initial": "exact"}
        yield "constant", names(v.name), v, {**attributes, "start": repr(v.value)}
    for name in model.events.names:
        known = names(f"event: {name}")
        yield "event", known, Variable(known, known), {"causality": "local", **calculated}


def _references(model: Model, *kinds: str) -> list[int]:
    return [k for k, row in enumerate(_rows(model), start=1) if row[0] in kinds]


def _description_3(model: Model, token: str) -> Iterator[str]:
    yield (
        "<fmiModelDescription"
        + _attributes(
            fmiVersion="3.0",
            modelName=_plain(model.title),
            instantiationToken=token,
            generationTool=f"pydy {__version__}",
            variableNamingConvention="flat",
        )
        + ">"
    )
    abilities = {
        "modelIdentifier": model.name,
        "canGetAndSetFMUState": "true",
        "canSerializeFMUState": "true",
        "providesDirectionalDerivatives": "true",
        "providesAdjointDerivatives": "true",
    }
    yield f"  <ModelExchange{_attributes(**abilities)}/>"
    steps = {"canHandleVariableCommunicationStepSize": "true"}
    yield f"  <CoSimulation{_attributes(**abilities, **steps)}/>"
    yield f"  <DefaultExperiment{_experiment(model)}/>"
    yield "  <ModelVariables>"
    time = _attributes(
        name="time", valueReference=0, causality="independent", variability="continuous"
    )
    yield f"    <Float64{time}/>"
    for k, (_, name, _, attributes) in enumerate(_rows(model), start=1):
        yield f"    <Float64{_attributes(name=name, valueReference=k, **attributes)}/>"
    yield "  </ModelVariables>"
    yield "  <ModelStructure>"
    for element, kinds in (
        ("Output", ("state", "output")),
        ("ContinuousStateDerivative", ("rate",)),
        ("InitialUnknown", ("rate", "output")),
        ("EventIndicator", ("event",)),
    ):
        for k in _references(model, *kinds):
            yield f'    <{element} valueReference="{k}"/>'
    yield "  </ModelStructure>"
    yield "</fmiModelDescription>"


def _description_2(model: Model, token: str) -> Iterator[str]:
    yield (
        "<fmiModelDescription"
        + _attributes(
            fmiVersion="2.0",
            modelName=_plain(model.title),
            guid=token,
            generationTool=f"pydy {__version__}",
            variableNamingConvention="flat",
            numberOfEventIndicators=len(model.events),
        )
        + ">"
    )
    abilities = {
        "modelIdentifier": model.name,
        "canGetAndSetFMUstate": "true",
        "canSerializeFMUstate": "true",
        "providesDirectionalDerivative": "true",
    }
    files = '<SourceFiles><File name="all.c"/></SourceFiles>'
    yield f"  <ModelExchange{_attributes(**abilities)}>{files}</ModelExchange>"
    steps = {"canHandleVariableCommunicationStepSize": "true"}
    yield f"  <CoSimulation{_attributes(**abilities, **steps)}>{files}</CoSimulation>"
    yield f"  <DefaultExperiment{_experiment(model)}/>"
    yield "  <ModelVariables>"
    for k, (kind, name, _, attributes) in enumerate(_rows(model), start=1):
        if kind == "event":
            continue
        own = {n: attributes.pop(n, None) for n in ("start", "derivative")}
        scalar = _attributes(name=name, valueReference=k, **attributes)
        yield f"    <ScalarVariable{scalar}><Real{_attributes(**own)}/></ScalarVariable>"
    yield "  </ModelVariables>"
    yield "  <ModelStructure>"
    for element, kinds in (
        ("Outputs", ("state", "output")),
        ("Derivatives", ("rate",)),
        ("InitialUnknowns", ("rate", "output")),
    ):
        places = _references(model, *kinds)
        if places:
            unknowns = "".join(f'<Unknown index="{k}"/>' for k in places)
            yield f"    <{element}>{unknowns}</{element}>"
    yield "  </ModelStructure>"
    yield "</fmiModelDescription>"


def _experiment(model: Model) -> str:
    return _attributes(
        startTime=repr(model.start), stopTime=repr(model.stop), tolerance=repr(_TOLERANCE)
    )


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
