"""Named columns over time as an xarray.Dataset, and as a NetCDF file.

The caller passes the module xarray, which is an optional dependency.
"""

from __future__ import annotations

import json
import os
import re
import zlib
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Any, TypeVar

import numpy as np

from pydy._checks import shown
from pydy._files import file_of, replacing

if TYPE_CHECKING:
    from types import ModuleType

    from xarray import Dataset

# Kinds of quantities, in the order of their names.
STATES = ("coordinate", "speed", "auxiliary")
OUTPUTS = ("output", "constraint", "force")
KINDS = (*STATES, *OUTPUTS, "specified")
ENERGIES = ("kinetic_energy", "potential_energy", "total_energy")


@dataclass
class DatasetParts:
    """The columns, labels and events of a dataset."""

    times: np.ndarray  # (m,)
    # names and values, by role
    columns: dict[str, dict[str, np.ndarray]] = field(default_factory=dict)
    constants: dict[str, float] = field(default_factory=dict)
    latex: dict[str, str] = field(default_factory=dict)
    # (names, (m, q, k)): names of the parameters, and derivatives of the states and outputs
    sensitivity: tuple[list[str], np.ndarray] | None = None

    def table(self, *roles: str) -> np.ndarray:
        """Return the columns of some roles, shape (m, columns)."""
        columns = [values for role in roles for values in self.columns.get(role, {}).values()]
        return np.array(columns).reshape(len(columns), len(self.times)).T


Event = TypeVar("Event")
SENSITIVITY = "sensitivity"
_CONSTANT = " (constant)"
_CHECKSUM = "pydy_checksum"
# Suffixes of other formats than NetCDF, and the calls that write these.
_OTHER_FORMATS = {
    **{
        suffix: f"`trajectory.to_dataframe().{method}(path)`"
        for suffix, method in {
            ".csv": "to_csv", ".txt": "to_csv", ".tsv": "to_csv", ".json": "to_json",
            ".xlsx": "to_excel", ".parquet": "to_parquet", ".feather": "to_feather",
        }.items()
    },
    ".zarr": "`trajectory.to_xarray().to_zarr(path)`",
    ".h5": "`trajectory.to_dataframe().to_hdf(path, key='run')`",
    ".hdf5": "`trajectory.to_dataframe().to_hdf(path, key='run')`",
    ".npy": "`numpy.save(path, trajectory.states)`",
    ".npz": "`numpy.savez(path, times=trajectory.times, states=trajectory.states)`",
    ".mat": "`scipy.io.savemat(path, {'times': trajectory.times, 'states': trajectory.states})`",
    ".pkl": "`pickle.dump(trajectory, file)`",
    ".pickle": "`pickle.dump(trajectory, file)`",
}  # fmt: skip


def to_dataset(
    xarray: ModuleType,
    times: np.ndarray,
    columns: Sequence[tuple[str, str, str, np.ndarray]],
    constants: Mapping[str, tuple[str, float]],
    sensitivity: Any = None,
) -> Dataset:
    """Return a Dataset of columns (name, role, latex, values) along ``time``.

    A `pydy.trajectory.Sensitivity` becomes a variable along ``quantity`` and ``parameter`` too. If
    a name is already used, its role is appended, and the attribute ``label`` has the name.
    """
    variables: dict[str, tuple[object, ...]] = {}
    coords: dict[str, tuple[object, ...]] = {"time": ("time", times)}
    if sensitivity is not None:
        dimensions = ("time", "quantity", "parameter")
        variables[SENSITIVITY] = (dimensions, sensitivity.table(), {"role": SENSITIVITY})
        coords["quantity"] = ("quantity", list(sensitivity.quantities), {})
        coords["parameter"] = ("parameter", list(sensitivity.names), {})

    def labelled(name: str, role: str, latex: str) -> tuple[str, dict[str, str]]:
        free = name
        while free in variables or free in coords:
            free += f" ({role})"
        attrs = {"role": role, "latex": latex}
        has_own_name = free == name and not name.endswith(_CONSTANT)
        return free, attrs if has_own_name else {**attrs, "label": name}

    for name, role, latex, values in columns:
        free, attrs = labelled(name, role, latex)
        variables[free] = ("time", values, attrs)
    if sensitivity is not None:
        variables[SENSITIVITY] = variables.pop(SENSITIVITY)  # the last one
    for name, (latex, value) in constants.items():
        free, attrs = labelled(name, "constant", latex)
        coords[free] = ((), value, attrs)
    dataset: Dataset = xarray.Dataset(variables, coords)
    return dataset


def from_dataset(dataset: Any) -> DatasetParts:
    """Split a Dataset of `to_dataset` into its parts; older files have no labels."""
    if "time" not in dataset.variables:  # xarray would count the rows
        raise ValueError("it holds no 'time'")
    parts = DatasetParts(np.array(dataset["time"]))
    for name, variable in dataset.variables.items():
        if name in dataset.dims:
            continue
        role = variable.attrs["role"]
        label = variable.attrs.get("label", name.removesuffix(_CONSTANT))
        if role == SENSITIVITY:
            names = [str(parameter) for parameter in dataset["parameter"].values]
            parts.sensitivity = (names, np.array(variable))
            continue
        if role == "constant":
            parts.constants[label] = float(variable)
        else:
            if variable.shape != parts.times.shape:
                raise ValueError(f"'{name}' has the shape {variable.shape}")
            parts.columns.setdefault(role, {})[label] = np.array(variable)
        parts.latex[label] = variable.attrs["latex"]
    return parts


def write_netcdf(
    dataset: Any,
    path: str | os.PathLike[str],
    statistics: Mapping[str, object] | None,
    events: Sequence[Mapping[str, object]],
    facts: Mapping[str, object],
) -> None:
    """Write a Dataset to a NetCDF 3 file, which SciPy alone can read and write."""
    path = file_of(_checked(path), "`path`")
    suffix = os.path.splitext(path)[1].lower()
    if suffix in _OTHER_FORMATS:
        raise ValueError(
            f"`path` must be the name of a NetCDF file, such as 'run.nc', got {shown(path)}. "
            f"Write {suffix} with {_OTHER_FORMATS[suffix]}."
        )
    dataset = dataset.copy()
    ascii_names: dict[str, str] = {}
    for name, variable in dataset.variables.items():
        # SciPy writes Latin letters only in names, but any in attributes.
        variable.attrs["name"] = name
        short = re.sub(r"[^A-Za-z0-9_]+", "_", name)
        while short in ascii_names.values():
            short += "_"
        ascii_names[name] = short
    dataset = dataset.rename({n: p for n, p in ascii_names.items() if n != p})
    dataset.attrs["pydy_statistics"] = json.dumps(statistics, default=_json_value)
    dataset.attrs["pydy_events"] = json.dumps(list(events), default=_json_value)
    dataset.attrs["pydy_facts"] = json.dumps(dict(facts), default=_json_value)
    dataset.attrs[_CHECKSUM] = _checksum(dataset)
    with replacing(path) as (temporary,):
        dataset.to_netcdf(temporary, engine="scipy", format="NETCDF3_64BIT")


def _checksum(dataset: Any) -> str:
    """Return a checksum of a Dataset's variables and attributes: NetCDF 3 has none of its own."""
    parts: list[object] = [sorted(dataset.attrs.items())]
    for name, variable in sorted(dataset.variables.items()):
        values = np.asarray(variable)
        numbers = np.issubdtype(values.dtype, np.number)
        content = zlib.crc32(values.astype("<f8").tobytes()) if numbers else values.tolist()
        parts.append((name, variable.dims, sorted(variable.attrs.items()), content))
    return f"{zlib.crc32(json.dumps(parts).encode()):08x}"


def _json_value(value: object) -> object:
    if isinstance(value, np.ndarray | np.generic):
        return value.tolist()
    return str(value)


def _arrays(value: object) -> object:
    """Return a list as an array, also those of a dictionary."""
    if isinstance(value, dict):
        return {name: _arrays(entry) for name, entry in value.items()}
    return np.array(value) if isinstance(value, list) else value


def _tuples(value: object) -> object:
    """Return a list as a tuple, also those in it and those of a dictionary."""
    if isinstance(value, dict):
        return {name: _tuples(part) for name, part in value.items()}
    return tuple(map(_tuples, value)) if isinstance(value, list) else value


def _checked(path: str | os.PathLike[str]) -> str:
    """Return a path as a string; xarray takes None for "return the bytes"."""
    try:
        name = os.fsdecode(path)
    except TypeError:
        name = "\0"
    if "\0" in name:
        raise TypeError(f"`path` must be the name of a file or a path, got {shown(path)}.")
    return name


def read_netcdf(
    xarray: ModuleType, path: str | os.PathLike[str], record: Callable[..., Event]
) -> tuple[DatasetParts, dict[str, object] | None, list[Event], dict[str, list[object]]]:
    """Return the Parts, statistics, events and facts of a file of `write_netcdf`.

    `record` constructs an event from its attributes.
    """
    path = _checked(path)
    try:
        with xarray.open_dataset(path, engine="scipy") as file:
            dataset = file.load()
        written = dataset.attrs.pop(_CHECKSUM, None)  # older files have none
        sound = written in (None, _checksum(dataset))
        if "pydy_events" in dataset.attrs:
            names = {n: variable.attrs.pop("name", n) for n, variable in dataset.variables.items()}
            dataset = dataset.rename({n: name for n, name in names.items() if n != name})
            statistics = json.loads(dataset.attrs["pydy_statistics"])
            events = [
                record(**{k: _arrays(v) for k, v in event.items()})
                for event in json.loads(dataset.attrs["pydy_events"])
            ]
            facts = {  # older files have none
                name: [_tuples(row) for row in rows]
                for name, rows in json.loads(dataset.attrs.get("pydy_facts", "{}")).items()
            }
            parts = from_dataset(dataset)
            if not sound:
                raise ValueError("its content is not what its checksum tells")
            return parts, statistics, events, facts
    except OSError:
        raise  # no such file, no permission
    except Exception as error:  # SciPy, xarray and json raise of all kinds
        # SciPy's further lines advise to install netCDF4, which would not help.
        reason = str(error).partition("\n")[0]
        raise ValueError(
            f"`path` must be a file that Trajectory.save wrote, but '{path}' is damaged or of "
            f"another kind ({type(error).__name__}: {reason}). Save the trajectory again."
        ) from error
    raise ValueError(f"`path` must be a file that Trajectory.save wrote; '{path}' is not.")
