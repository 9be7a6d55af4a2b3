"""Save the last recording of each exercise next to the answers, for a report to a remote helper."""

import json
from dataclasses import dataclass
from pathlib import Path

from workbook.exercise.answer_files import answers_folder
from workbook.exercise.judgement import Judgement
from workbook.recording.codec import decode, encode
from workbook.recording.recording import Recording

KEPT_IN = ".recordings"


@dataclass(frozen=True)
class LastRecording:
    """A recording, and the SHA-256 hash of the answer that was recorded."""

    answer_sha256: str
    recording: Recording


def keep_recording(judgement: Judgement, folder: Path | None = None) -> None:
    """Replace an exercise's saved recording with the one from this check.

    If the disk is full, only the recording is lost.
    """
    if judgement.recording is None:
        return
    path = _file(judgement.stem, folder)
    partial = path.with_suffix(".part")
    kept = encode(LastRecording(judgement.answer_sha256, judgement.recording))
    try:
        path.parent.mkdir(parents=True, exist_ok=True)
        partial.write_text(json.dumps(kept, allow_nan=False, separators=(",", ":")), encoding="utf-8")
        partial.replace(path)
    except (OSError, ValueError):
        partial.unlink(missing_ok=True)


def last_recording(stem: str, folder: Path | None = None) -> LastRecording | None:
    """Return the last check's recording, or None if there is none or if it can't be read."""
    try:
        return decode(LastRecording, json.loads(_file(stem, folder).read_text(encoding="utf-8")))
    except (OSError, ValueError, RecursionError):
        return None


def _file(stem: str, folder: Path | None) -> Path:
    return (folder or answers_folder()) / KEPT_IN / f"{stem}.json"
