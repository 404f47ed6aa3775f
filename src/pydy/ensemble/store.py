"""The Zarr store of an ensemble: one chunk for each block, so that processes write independently.

A block is complete if all its chunks exist and match their checksums, which are written last. A
checksum includes the ensemble, variable and block of its chunk: a chunk that was exchanged with
another counts as damaged. Incomplete blocks are written again. The metadata of the arrays have
checksums as well, in the attributes of the store.
"""

from __future__ import annotations

import json
import os
import re
import sys
import zlib
from collections.abc import Iterable, Mapping, Sequence
from pathlib import Path
from threading import Lock
from typing import TYPE_CHECKING, Any

import numpy as np

from pydy._files import folder_beside
from pydy._names import few
from pydy._optional import require
from pydy._version import __version__
from pydy.ensemble.content import digest
from pydy.ensemble.samples import ArrayForm, Block, LabelledArray, Samples, check_forms
from pydy.ensemble.work import Work
from pydy.solvers import Outcome

if TYPE_CHECKING:
    from xarray import Dataset, Variable
    from zarr import Group

# -- Directory names for variables: each array of a store is a directory ---------------------------
# Zarr reads ``\`` as ``/`` and creates a directory for each part. Windows allows neither some
# characters nor files called ``aux``; there and on macOS, ``q`` and ``Q`` are the same file. The
# names of arrays avoid all of this on every system, so that a store can be written anywhere and
# copied anywhere.


# Characters that some system forbids in file names, and blanks, which separate the names in the
# attribute `coordinates`.
_REFUSED = re.compile(r'[\x00-\x1f<>:"/\\|?*\s]')
_DEVICE = re.compile(r"(aux|con|nul|prn|com\d|lpt\d)(\..*)?")
_OF_ZARR = "zarr.json"


def file_names(names: Iterable[str]) -> dict[str, str]:
    """Return a file name for each name; the same one if it is valid everywhere."""
    unique = list(dict.fromkeys(names))
    valid = {name for name in unique if _is_valid_everywhere(name)}
    files: dict[str, str] = {}
    used: set[str] = set()
    # Valid names first, so that they are not changed.
    for name in sorted(unique, key=lambda name: name not in valid):
        stem = name if name in valid else _REFUSED.sub("_", name).strip(".")
        if not _is_valid_everywhere(stem):
            stem = "_" + stem.lstrip("_")
        chosen, number = stem, 2
        while chosen.casefold() in used:
            chosen = f"{stem}_{number}"
            number += 1
        used.add(chosen.casefold())
        files[name] = chosen
    for file in files.values():
        try:
            os.fsencode(file)
        except UnicodeEncodeError:
            raise ValueError(
                f"`store` needs a file of the name {file!a}, which the encoding "
                f"{sys.getfilesystemencoding()!r} of this locale has no letters for. Start Python "
                "with the environment variable PYTHONUTF8=1, or give the output another name."
            ) from None
    return {name: files[name] for name in unique}


def _is_valid_everywhere(name: str) -> bool:
    """Whether a name is the name of a directory on every system, and unused by Zarr and pydy."""
    folded = name.casefold()
    return not (
        _REFUSED.search(name)
        or name.endswith(".")
        or name.startswith((".", "__"))
        or folded in (_OF_ZARR, _CHUNKS[0])
        or _DEVICE.fullmatch(folded)
        or not name
    )


# -- The store -------------------------------------------------------------------------------------


_TOKEN = "pydy_ensemble"
_PARTS = "pydy_ensemble_parts"  # the digests from which the token is computed
_VARIABLES, _COORDINATES = "pydy_variables", "pydy_coordinates"
_FILES = "pydy_names"  # file names of variables and dimensions, where they differ
_LABELS = "pydy_labels"
_CHECKSUMS = "pydy_checksums"  # of each array's metadata, by its path in the store
_CHUNKS = "pydy_chunks", "checksums"  # group and array of the chunks' checksums, a row per block
_SETTING = Lock()  # all threads share zarr's configuration


def _zarr() -> Any:
    """Return the package zarr, patched so that it can read groups under ``python -O``, too.

    Zarr 3.1 removes a key of a group's metadata within an `assert`: without asserts, no group of
    version 3 can be opened.
    """
    zarr = require("zarr", "ensemble", "`store`")
    if __debug__:
        return zarr
    kind = require("zarr.core.group", "ensemble", "`store`").GroupMetadata
    with _SETTING:
        try:
            kind.from_dict({"attributes": {}, "zarr_format": 3, "node_type": "group"})
        except TypeError:
            read = kind.from_dict

            def from_dict(data: dict[str, object]) -> object:
                return read({key: value for key, value in data.items() if key != "node_type"})

            kind.from_dict = from_dict
    return zarr


def parts_of(work: Work, samples: Samples, sizes: Sequence[int], name: str = "") -> dict[str, str]:
    """Return digests of all that determines an ensemble, by the names used in messages.

    The content of functions is not read: the user's `name` identifies them.
    """
    for label, coordinate in samples.coordinates.items():
        if coordinate.values.dtype.hasobject:
            raise ValueError(
                f"`store` needs labels that Zarr has a type for, but those of `{label}` are "
                "objects of Python. Give numbers, dates, or text of NumPy: `labels.astype(str)`."
            )
    model = work.model
    events, constraints = model.options.events, model.options.constraints
    kernels = [None if constraints is None else constraints.kernel]
    event_traits = None
    if events is not None:
        kernels += [events.values, events.resets]
        names = ("name", "direction", "terminal", "resets")
        event_traits = tuple(tuple(getattr(e, n) for e in events.traits) for n in names)
    sensitivities, motions = model.sensitivities, model.motions
    programs = [model.rates, model.outputs, model.jacobian]
    programs += [] if sensitivities is None else sensitivities.programs
    programs += [None if k is None else k.program for k in kernels]
    functions = [(columns, getattr(f, "identity", None)) for columns, f in model.functions]
    parts = {
        "the version of pydy": (__version__, _CHUNKS),
        "equations": (
            [None if program is None else program.digest for program in programs],
            (model.states, model.output_names, event_traits),
            None if sensitivities is None else sensitivities.identity,
        ),
        "contacts": None if motions is None else motions.identity,
        "options": (
            model.method,
            [
                (key, None if value is None else np.asarray(value, dtype=float))
                for key, value in vars(model.options).items()
                if key not in ("events", "constraints")
            ],
        ),
        "`times`": model.times,
        "numbers": (
            (samples.x, samples.r, samples.p),
            [(n, c.dims, c.values) for n, c in samples.coordinates.items()],
            [(c, s.breaks, s.values, s.interpolation) for c, s in model.sampled],
        ),
        "`reduce`": [None if callable(r) else repr(r) for r in work.reductions],
        "`chunks`": (samples.dims, tuple(sizes)),
        "which specifieds are functions": functions,
        "the name of its functions (`resume`)": name,
    }
    return {part_name: digest(part) for part_name, part in parts.items()}


def check(path: str, parts: Mapping[str, str], resume: bool) -> bool:
    """Return whether there is a store to resume; raise an error if the path has other content."""
    if not Path(path).exists():
        target = Path(os.path.realpath(path))
        nearest = next(folder for folder in target.parents if folder.exists())
        if target.is_symlink() or not nearest.is_dir():
            reason = "is a link that leads to itself" if target.is_symlink() else "is below a file"
            raise ValueError(f"`store` must be a new path, got '{path}', which {reason}.")
        return False
    if not resume:
        raise ValueError(
            f"`store` must be a new path, got '{path}'. Pass resume=True to "
            "compute only what is missing there, or remove it."
        )
    zarr = _zarr()
    try:
        attrs = dict(zarr.open_group(path, mode="r").attrs)
    except Exception:  # noqa: BLE001 - a path that Zarr cannot read
        attrs = {}
    if attrs.get(_TOKEN) != digest(parts):
        stored_parts = attrs.get(_PARTS)
        if not isinstance(stored_parts, dict):
            raise ValueError(
                f"`store` '{path}' is not the store of an ensemble, or its `{_OF_ZARR}` is "
                "damaged. Pass another path."
            )
        differing = [
            part_name for part_name in parts if stored_parts.get(part_name) != parts[part_name]
        ]
        raise ValueError(
            f"`store` '{path}' was written by another ensemble, or its `{_OF_ZARR}` is damaged. "
            f"What differs: {', '.join(differing) or 'nothing but its mark'}. Pass another path."
        )
    stored, actual = attrs.get(_CHECKSUMS, {}), _checksums(path)
    if wrong := [name for name in (*stored, *actual) if stored.get(name) != actual.get(name)]:
        part_name = f"has lost its array `{wrong[0]}`, or " if wrong[0] else ""
        raise ValueError(
            f"`store` '{path}' {part_name}has another `{Path(wrong[0], _OF_ZARR)}` than was "
            "written: it is damaged, or was edited. Restore it, or remove the store and compute "
            "all again."
        )
    _check_consolidated(path, actual)
    return True


def _check_consolidated(path: str, arrays: Iterable[str]) -> None:
    """Raise an error if arrays are missing in consolidated metadata, which Zarr reads first."""
    metadata = json.loads(Path(path, _OF_ZARR).read_bytes()).get("consolidated_metadata")
    if not metadata:
        return
    if lacking := [name for name in arrays if name and name not in metadata["metadata"]]:
        raise ValueError(
            f"`store` '{path}' has consolidated metadata without {few(lacking)}, in its "
            f"`{_OF_ZARR}`: Zarr finds no other arrays. Write them again by "
            f"`zarr.consolidate_metadata({path!r})`."
        )


def create(
    path: str,
    parts: Mapping[str, str],
    example: Any,
    samples: Samples,
    sizes: Sequence[int],
    labels: Mapping[str, Sequence[str]],
) -> None:
    """Create a store with all coordinates and no results; an interrupted call leaves no files.

    The `example` is a Dataset of one sample with all attributes and coordinates; its sizes are
    ignored. The `labels` of further dimensions are stored as attributes: Zarr has no stable format
    for arrays of text.
    """
    zarr = _zarr()
    files = file_names(map(str, (*example.variables, *example.dims)))
    attributes = {
        _TOKEN: digest(parts),
        _PARTS: dict(parts),
        _VARIABLES: list(map(str, example.data_vars)),
        _COORDINATES: list(map(str, example.coords)),
        _FILES: {name: file for name, file in files.items() if name != file},
        _LABELS: {d: list(names) for d, names in labels.items() if d in example.dims},
    }
    dims = tuple(samples.dims)
    target = Path(os.path.realpath(path))
    target.parent.mkdir(parents=True, exist_ok=True)
    with folder_beside(target) as folder:
        temporary = folder / target.name
        group = zarr.open_group(str(temporary), mode="w", attributes=attributes)
        for name, variable in example.variables.items():
            file, file_dims = files[str(name)], [files[str(d)] for d in variable.dims]
            if name in example.coords:
                shape = tuple(samples.dims.get(d, variable.sizes[d]) for d in variable.dims)
                _array(group, file, shape, shape, file_dims, variable)
                continue
            further_sizes = tuple(variable.sizes[d] for d in variable.dims if d not in dims)
            shape, chunks = (*samples.shape, *further_sizes), (*sizes, *further_sizes)
            _array(group, file, shape, chunks, file_dims, variable)
        blocks = [
            -(-length // max(1, size)) for length, size in zip(samples.shape, sizes, strict=True)
        ]
        row, inner = len(attributes[_VARIABLES]), group.create_group(_CHUNKS[0])
        shape, chunks = (*blocks, row), (*(1 for _ in blocks), row)
        checksums = LabelledArray(dims, np.zeros(0, np.uint32), {})
        _array(inner, _CHUNKS[1], shape, chunks, [*map(files.get, dims), "variable"], checksums)
        coordinates = " ".join(files[name] for name in samples.coordinates)
        group.attrs.update({**example.attrs, "coordinates": coordinates})
        write_coordinates(str(temporary), samples, example.coords.get("time"))
        group.attrs[_CHECKSUMS] = _checksums(str(temporary))
        try:
            os.rename(temporary, target)
        except OSError:
            if not target.exists():
                raise
            raise ValueError(
                f"`store` must be a new path, but another process has made '{path}' meanwhile. "
                "Call again with resume=True, or pass another path."
            ) from None


def _checksums(path: str) -> dict[str, int]:
    """Return the checksums of the metadata of a store's arrays, and of its other attributes."""
    attributes = json.loads(Path(path, _OF_ZARR).read_bytes())["attributes"]
    attributes.pop(_CHECKSUMS, None)
    parts = {"": json.dumps(attributes, sort_keys=True).encode()}
    for depth in ("*", "*/*"):
        for file in Path(path).glob(f"{depth}/{_OF_ZARR}"):
            parts[file.parent.relative_to(path).as_posix()] = file.read_bytes()
    return {name: zlib.crc32(part) for name, part in sorted(parts.items())}


def open_dataset(path: str, chunks: Mapping[str, int] | None) -> Dataset:
    """Return a store as a Dataset, with the original names of its variables."""
    xarray = require("xarray", "ensemble", "System.integrate_ensemble")
    dataset = xarray.open_zarr(path, consolidated=False, chunks=chunks)
    labels = dataset.attrs.pop(_LABELS, {})
    dataset = dataset.rename({file: name for name, file in dataset.attrs.get(_FILES, {}).items()})
    labelled: Dataset = dataset.assign_coords(labels)
    return labelled


def _stored(group: Any, name: str) -> Any:
    """Return the array of a variable."""
    return group[group.attrs.get(_FILES, {}).get(name, name)]


def _array(
    group: Any,
    name: str,
    shape: tuple[int, ...],
    chunks: tuple[int, ...],
    dims: Iterable[str | None],
    variable: LabelledArray | Variable,
) -> object:
    """Create an array with the type and attributes of a variable."""
    dtype = np.dtype(variable.values.dtype)
    fill = int(Outcome.NOT_COMPUTED) if name == "status" else np.nan if dtype.kind == "f" else 0
    # The checksum detects damage that decompression does not: a flipped bit may yield numbers.
    codecs = require("zarr.codecs", "ensemble", "`store`")
    return group.create_array(
        name,
        shape=shape,
        chunks=tuple(max(1, c) for c in chunks) if shape else "auto",
        dtype=dtype,
        dimension_names=tuple(dims),
        attributes=dict(variable.attrs),
        compressors=(codecs.ZstdCodec(), codecs.Crc32cCodec()),
        fill_value=fill,
    )


def write_coordinates(path: str, samples: Samples, times: object) -> None:
    """Write the coordinates that are missing or differ."""
    group = _zarr().open_group(path, mode="r+")
    for name in group.attrs[_COORDINATES]:
        values = np.asarray(
            samples.coordinates[name].values if name in samples.coordinates else times
        )
        try:
            is_written = np.array_equal(np.asarray(_stored(group, name)[...]), values)
        except Exception:  # noqa: BLE001 - a chunk that does not decode
            is_written = False
        if not is_written:
            _stored(group, name)[...] = values


def missing(path: str, blocks: Sequence[Block]) -> list[Block]:
    """Return the blocks that are missing from the store or damaged."""
    zarr = _zarr()
    group = zarr.open_group(path, mode="r")
    arrays, stored = _arrays(group), group["/".join(_CHUNKS)]

    def complete(block: Block) -> bool:
        try:
            position, checksums = _checksums_of(path, group, arrays, block)
            return np.array_equal(np.asarray(stored[position]), checksums)
        except Exception:  # noqa: BLE001 - a missing or truncated chunk
            return False

    return [block for block in blocks if not complete(block)]


def _arrays(group: Any) -> dict[str, Any]:
    """Return the arrays of the results by name of the variable."""
    return {name: _stored(group, name) for name in group.attrs[_VARIABLES]}


def _checksums_of(
    path: str, group: Group, arrays: Mapping[str, Any], block: Block
) -> tuple[tuple[int, ...], np.ndarray]:
    """Return a block's position, and the checksums of its chunks including their identity."""
    sizes = arrays["status"].chunks
    position = tuple(s.start // size for s, size in zip(block, sizes, strict=True))
    checksums = []
    for name, array in arrays.items():
        cell = *position, *(0 for _ in array.chunks[len(position) :])
        file = Path(path, array.basename, array.metadata.encode_chunk_key(cell))
        identity = zlib.crc32(repr((group.attrs[_TOKEN], name, position)).encode())
        checksums.append(zlib.crc32(file.read_bytes(), identity))
    return position, np.array(checksums, dtype=np.uint32)


def write(path: str, block: Block, results: Mapping[str, LabelledArray]) -> None:
    """Write the results of a block."""
    zarr = _zarr()
    # Zarr would omit a chunk that contains fill values only, which would count as missing.
    with _SETTING, zarr.config.set({"array.write_empty_chunks": True}):
        group = zarr.open_group(path, mode="r+")
        arrays, checksums = _arrays(group), group["/".join(_CHUNKS)]
    names = {file: name for name, file in group.attrs.get(_FILES, {}).items()}

    def form(a: Any) -> ArrayForm:
        dims = [names.get(d, d) for d in a.metadata.dimension_names]
        return ArrayForm.from_array(dims, a.shape, a.dtype, len(block))

    forms = {name: form(a) for name, a in arrays.items()}
    check_forms(results, forms, block)
    remaining = [(name, v) for name, v in results.items() if name != "status"]
    try:
        for name, variable in (*remaining, ("status", results["status"])):
            arrays[name][block] = variable.values
        position, block_checksums = _checksums_of(path, group, arrays, block)
        checksums[position] = block_checksums
    except OSError as error:
        if error.filename is None and error.errno is not None:  # a full disk: the error has no path
            raise type(error)(error.errno, error.strerror, path) from error
        raise
