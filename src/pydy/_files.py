"""Replace users' files atomically."""

from __future__ import annotations

import contextlib
import os
import secrets
import shutil
import stat
from collections.abc import Iterator
from os import PathLike
from pathlib import Path
from typing import Any

from pydy._checks import shown


@contextlib.contextmanager
def replacing(*paths: Path) -> Iterator[list[Path]]:
    """Yield temporary paths for files, which replace the files together at the end.

    After a full disk, an error or Ctrl-C, the previous files remain. Each temporary file is in a
    separate folder, so that it has the final name and suffix, which writers may inspect, and the
    usual permissions. Devices and pipes are written to directly.
    """
    with contextlib.ExitStack() as folders:
        replacements: list[tuple[Path, Path]] = []
        writable = []
        for path in paths:
            if _is_special(path):
                writable.append(path)
                continue
            target = Path(os.path.realpath(path))  # symbolic links are preserved
            writable.append(Path(folders.enter_context(folder_beside(target)), target.name))
            replacements.append((writable[-1], target))
        yield writable
        for temporary, target in replacements:
            with contextlib.suppress(FileNotFoundError):
                shutil.copymode(target, temporary)
            with open(temporary, "rb+") as file:
                os.fsync(file.fileno())  # some file systems report only here that they are full
        for temporary, target in replacements:
            os.replace(temporary, target)


@contextlib.contextmanager
def temporary_folder(start: Path) -> Iterator[Path]:
    """Yield a new folder whose path has the given prefix, and remove it at the end.

    Its name is chosen before it exists, and interrupts are delayed while it is removed:
    `tempfile.TemporaryDirectory` leaves it behind in both cases.
    """
    folder = start.with_name(f"{start.name}{secrets.token_hex(8)}")
    try:
        folder.mkdir(mode=0o700)
        yield folder
    finally:
        try:
            shutil.rmtree(folder, ignore_errors=True)
        except BaseException:
            shutil.rmtree(folder, ignore_errors=True)
            raise


@contextlib.contextmanager
def folder_beside(target: Path) -> Iterator[Path]:
    """Yield a temporary folder beside a file; errors about the folder name the file instead."""
    start = target.parent / ".pydy-"
    try:
        with temporary_folder(start) as folder:
            yield folder
    except OSError as error:
        # The error of a full disk has no file name.
        if error.errno is not None and str(start) in str(error.filename or start):
            raise type(error)(error.errno, error.strerror, str(target)) from error
        raise


def write_files(contents: dict[Path, Any]) -> None:
    """Write texts or bytes to files: all of them, or none if one cannot be written."""
    with replacing(*contents) as paths:
        for path, content in zip(paths, contents.values(), strict=True):
            data = (
                content.encode(errors="backslashreplace") if isinstance(content, str) else content
            )
            path.write_bytes(data)


def _is_special(path: Path) -> bool:
    try:
        return not stat.S_ISREG(path.stat().st_mode)
    except OSError:
        return False


def path_of(value: Any, label: str) -> Path:
    """Return a path, or raise an error that shows the value."""
    if not isinstance(value, (str, PathLike)) or "\0" in os.fsdecode(value):
        raise TypeError(f"{label} must be a path, got {shown(value)}.")
    try:
        os.fsencode(value)
    except UnicodeEncodeError:
        raise ValueError(
            f"{label} has a character that no file's name can have, got {value!a}."
        ) from None
    if "://" in os.fsdecode(value):
        raise ValueError(
            f"{label} must be a path on this computer, got the URL {value!r}. Copy what is there "
            "to a file or folder, or a file or folder there afterwards."
        )
    path = Path(os.fsdecode(value))
    if not path.is_absolute():
        try:
            os.getcwd()
        except FileNotFoundError:
            raise FileNotFoundError(
                f"{label} is {str(path)!r}, relative to the current folder, but that was removed. "
                "Give an absolute path, or go to another folder with `os.chdir`."
            ) from None
    return path


def file_of(value: Any, label: str) -> Path:
    """Return the path of a file to be written; its folder must exist."""
    path = path_of(value, label)
    with contextlib.suppress(FileNotFoundError, NotADirectoryError):
        path.lstat()  # raises early if the name is too long
    if not path.parent.is_dir():
        raise FileNotFoundError(
            f"{label} is {str(path)!r}, but there is no folder {str(path.parent)!r}: make it "
            "first, with `Path(...).mkdir(parents=True)`, or choose another."
        )
    if path.is_dir():
        raise IsADirectoryError(
            f"{label} must be a file, got the folder {str(path)!r}: add a name."
        )
    return path
