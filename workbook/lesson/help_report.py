"""Write and read reports for a remote helper: an answer, its last recording, and the doctor's findings.

A report is a JSON file, so a student can read it before sending it. `read_report` treats it as untrusted input.
"""

import getpass
import json
import platform
import re
from collections.abc import Callable, Collection, Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Any, Literal

from workbook.grading.new_results import versions
from workbook.grading.results import Versions
from workbook.lesson.last_recordings import LastRecording
from workbook.recording.codec import decode, encode
from workbook.recording.recording import Recording

LARGEST_BYTES = 20_000_000
"""The largest file, in bytes, that is read. A recording usually takes some kilobytes; a camera's takes some megabytes.
"""
_HOMES = re.compile(r"/(?:home|Users)/[^/\s\"'<>:;,()]+")
_PROGRAMS_WORDS = ("process", "notes", "findings")
"""The parts of a recording in which names are replaced, because they contain text from the system. Messages come from
the student's answer, so names in them are kept.
"""


@dataclass(frozen=True)
class HelpReport:
    """A student's report. `recording` is None before the first check. `doctor`: the lines of the doctor's report.

    `is_of_this_answer`: whether the recording shows this version of the answer, not an earlier one.
    """

    kind: Literal["rclpy-workbook report"]
    exercise: str
    answer: str
    recording: Recording | None
    is_of_this_answer: bool
    doctor: tuple[str, ...]
    made_by: Versions


class NoReport(ValueError):
    """Raised when a file isn't a readable report. The message says why."""


def help_report(
    exercise: str, answer: str, sha256: str, last: LastRecording | None, doctor: tuple[str, ...]
) -> str:
    """Return the report as JSON, with home paths, the user name, and the host name replaced."""
    report = HelpReport(
        "rclpy-workbook report",
        exercise,
        answer,
        None if last is None else last.recording,
        last is not None and last.answer_sha256 == sha256,
        doctor,
        versions(""),
    )
    data = encode(report)
    data["doctor"] = _everywhere(data["doctor"], without_names)
    if data["recording"] is not None:
        for part in _PROGRAMS_WORDS:
            if part in data["recording"]:
                data["recording"][part] = _everywhere(data["recording"][part], without_names)
    return json.dumps(_everywhere(data, _without_paths), allow_nan=False, ensure_ascii=False, indent=1) + "\n"


def _everywhere(data: Any, change: Callable[[str], str]) -> Any:
    if isinstance(data, str):
        return change(data)
    if isinstance(data, Mapping):
        return {change(key): _everywhere(value, change) for key, value in data.items()}
    return [_everywhere(one, change) for one in data] if isinstance(data, (list, tuple)) else data


def _without_paths(text: str) -> str:
    for home in sorted({str(Path.home()), str(Path.home().resolve())}, key=len, reverse=True):
        if home != "/":
            text = re.sub(rf"{re.escape(home)}(?![\w.-])", "~", text)
    return _HOMES.sub("~", text)


def without_names(text: str) -> str:
    """Replace home folders, the user name, and the host name in a string."""
    text = _without_paths(text)
    host = platform.node()
    names = [(host, "HOST"), (host.split(".")[0], "HOST"), (_user(), "USER")]
    for name, instead in names:
        if name:
            text = re.sub(rf"(?<![^\W_]){re.escape(name)}(?![^\W_])", instead, text, flags=re.IGNORECASE)
    return text


def _user() -> str:
    try:
        return getpass.getuser()
    except (OSError, KeyError):
        return ""


def read_report(path: Path, exercises: Collection[str]) -> HelpReport:
    """Read a student's report. Raise NoReport if it can't be read, or if it isn't about one of the `exercises`."""
    try:
        if not path.is_file():
            raise NoReport(f"there is no file {path}")
        with path.open("rb") as file:
            raw = file.read(LARGEST_BYTES + 1)
    except OSError as error:
        raise NoReport(f"{path} cannot be read: {error.strerror}") from error
    if len(raw) > LARGEST_BYTES:
        raise NoReport(f"{path} is larger than {LARGEST_BYTES // 1_000_000} MB, so it is not read")
    try:
        report: HelpReport = decode(HelpReport, json.loads(raw.decode("utf-8"), parse_constant=_no_number))
    except (ValueError, RecursionError) as error:
        raise NoReport(
            f"{path} is damaged, or wasn't written by `workbook report`. Ask for a new one"
        ) from error
    if report.exercise not in exercises:
        raise NoReport(f"{path} is about an exercise that this course doesn't have")
    return report


def _no_number(name: str) -> float:
    raise ValueError(f"{name} is not a number")
