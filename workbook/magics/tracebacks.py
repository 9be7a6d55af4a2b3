"""Fold tracebacks in a notebook: show the student's own frames, and hide library frames until a click."""

import re
import sys
import sysconfig
from collections.abc import Callable, Sequence
from pathlib import Path
from typing import Any

from IPython.display import display

from workbook.lesson.predictions import unattended
from workbook.templating import render

_ANSI = re.compile(r"\x1b\[[0-9;]*m")
_FRAME_IN_FILE = re.compile(r"File (?P<path>[^\n]+?):\d+(?:, in |\n|$)")
_WORKBOOK = Path(__file__).resolve().parents[1]
_INSTALLED = ("site-packages", "dist-packages")
_STANDARD = (Path(sysconfig.get_path("stdlib")).resolve(), Path(sys.base_prefix).resolve() / "lib")


def library_of(frame: str) -> str | None:
    """Return the library that a traceback's frame belongs to, such as rclpy, or None if it isn't in a library."""
    found = _FRAME_IN_FILE.match(_ANSI.sub("", frame).lstrip())
    if found is None:
        return None
    path = Path(found["path"]).expanduser()
    for folder in _INSTALLED:
        if folder in path.parts[:-1]:
            return Path(path.parts[path.parts.index(folder) + 1]).stem
    if path.is_relative_to(_WORKBOOK):
        return "workbook"
    for standard in _STANDARD:
        if path.is_relative_to(standard):
            inside = path.relative_to(standard).parts
            return Path(next((one for one in inside if not one.startswith("python3")), path.name)).stem
    return None


def split(traceback: Sequence[str]) -> tuple[list[str], list[str], list[str]]:
    """Split a traceback into the parts to show, the library frames, and the libraries' names, in order.

    If the traceback has only library frames, don't fold any of them.
    """
    libraries = [library_of(part) for part in traceback]
    own = [part for part, name in zip(traceback, libraries, strict=True) if name is None]
    frames = [
        _ANSI.sub("", part) for part, name in zip(traceback, libraries, strict=True) if name is not None
    ]
    if not any(_ANSI.sub("", part).lstrip().startswith(("Cell ", "File ")) for part in own):
        return list(traceback), [], []
    return own, frames, list(dict.fromkeys(name for name in libraries if name is not None))


class FoldedFrames:
    """Library frames, which appear after a click on their title."""

    def __init__(self, frames: Sequence[str], libraries: Sequence[str]) -> None:
        self.frames = tuple(frames)
        self.libraries = tuple(libraries)

    @property
    def title(self) -> str:
        """The number of frames and the libraries' names, as text."""
        count = "1 more frame" if len(self.frames) == 1 else f"{len(self.frames)} more frames"
        return f"{count}, inside {', '.join(self.libraries)}"

    def __repr__(self) -> str:
        return "\n".join([self.title, *self.frames])

    def _repr_html_(self) -> str:
        return render("magics/folded_frames", title=self.title, frames=self.frames)


def install(shell: Any) -> None:
    """Fold this kernel's tracebacks from now on."""
    send: Callable[[object, object, list[str]], None] = shell._showtraceback

    def show(kind: object, error: object, traceback: list[str]) -> None:
        if unattended():
            send(kind, error, traceback)
            return
        own, frames, libraries = split(traceback)
        send(kind, error, own)
        if frames:
            display(FoldedFrames(frames, libraries))

    shell._showtraceback = show
