"""Files of the user's are replaced as a whole, or not at all."""

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

    A full disk, an error or Ctrl-C leaves what was there before. A folder of its own keeps the
    file's name and suffix, which writers read, and its usual permissions. Devices and pipes are
    written to as they are.
    """
    with contextlib.ExitStack() as folders:
        moves: list[tuple[Path, Path]] = []
        places = []
        for path in paths:
            if _is_special(path):
                places.append(path)
                continue
            target = Path(os.path.realpath(path))  # a link stays one
            places.append(Path(folders.enter_context(folder_beside(target)), target.name))
            moves.append((places[-1], target))
        yield places
        for aside, target in moves:
            with contextlib.suppress(FileNotFoundError):
                shutil.copymode(target, aside)
            with open(aside, "rb+") as file:
                os.fsync(file.fileno())  # some file systems say only now that they are full
        for aside, target in moves:
            os.replace(aside, target)


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
        # A full disk is told without a name.
        if error.errno is not None and str(start) in str(error.filename or start):
            raise type(error)(error.errno, error.strerror, str(target)) from error
        raise


def write_files(contents: dict[Path, Any]) -> None:
    """Write texts or bytes to files: all of them, or none where one cannot be written."""
    with replacing(*contents) as places:
        for place, content in zip(places, contents.values(), strict=True):
            data = (
                content.encode(errors="backslashreplace") if isinstance(content, str) else content
            )
            place.write_bytes(data)


def _is_special(path: Path) -> bool:
    try:
        return not stat.S_ISREG(path.stat().st_mode)
    except OSError:
        return False


def path_of(value: Any, what: str) -> Path:
    """Return a path, or raise an error that shows the value."""
    if not isinstance(value, (str, PathLike)) or "\0" in os.fsdecode(value):
        raise TypeError(f"{what} must be a path, got {shown(value)}.")
    try:
        os.fsencode(value)
    except UnicodeEncodeError:
        raise ValueError(
            f"{what} has a character that no file's name can have, got {value!a}."
        ) from None
    if "://" in os.fsdecode(value):
        raise ValueError(
            f"{what} must be a path on this computer, got the URL {value!r}. Copy what is there to "
            "a file or folder, or a file or folder there afterwards."
        )
    path = Path(os.fsdecode(value))
    if not path.is_absolute():
        try:
            os.getcwd()
        except FileNotFoundError:
            raise FileNotFoundError(
                f"{what} is {str(path)!r}, relative to the current folder, but that was removed. "
                "Give an absolute path, or go to another folder with `os.chdir`."
            ) from None
    return path


def file_of(value: Any, what: str) -> Path:
    """Return the path of a file to be written; its folder must exist."""
    path = path_of(value, what)
    with contextlib.suppress(FileNotFoundError, NotADirectoryError):
        path.lstat()  # a name that is too long is told before any work is done
    if not path.parent.is_dir():
        raise FileNotFoundError(
            f"{what} is {str(path)!r}, but there is no folder {str(path.parent)!r}: make it first, "
            "with `Path(...).mkdir(parents=True)`, or choose another."
        )
    if path.is_dir():
        raise IsADirectoryError(f"{what} must be a file, got the folder {str(path)!r}: add a name.")
    return path
