"""Read answers as students hand them in: as a program, or as a notebook's answer cell."""

import ast
import hashlib
import re
import tokenize
from dataclasses import dataclass, field
from io import BytesIO
from pathlib import Path
from typing import Any

from workbook.exercise.file_kinds import binary_kind, exported_answer, kind_of
from workbook.exercise.notebook_cells import LARGEST_NOTEBOOK_BYTES as LARGEST_NOTEBOOK_BYTES
from workbook.exercise.notebook_cells import answer_cells
from workbook.exercise.notebook_cells import means as means
from workbook.exercise.notebook_cells import named_exercise as named_exercise
from workbook.recording.codec import NOT_STORED

LARGEST_ANSWER_BYTES = 1_000_000
"""A hundred times the size of a long answer, so no student writes a larger one by hand."""
ANSWER_MAGIC = "%%answer"
ZERO_BYTES = (
    "the file contains null bytes, so it is not a Python program. Delete them and save the file as UTF-8"
)
_CODING = re.compile(r"^([ \t\f]*#.*?coding[:=][ \t]*)[-\w.]+", re.ASCII)
_NUMBER = re.compile(r"(?<![\w.])\d{1,3}(?![\w.])")


class Ungradable(ValueError):
    """Raised when a file can't be judged. The message gives the reason and describes the file's actual content."""


@dataclass(frozen=True)
class Answer:
    """The program in one answer, and its SHA-256.

    `note`: a sentence on other cells of the notebook that the student may have meant as part of the answer.
    """

    text: str
    note: str = field(default="", compare=False, metadata=NOT_STORED)

    @property
    def sha256(self) -> str:
        """The hash that identifies this answer in results."""
        return hashlib.sha256(self.text.encode()).hexdigest()


@dataclass(frozen=True)
class SyntaxMistake:
    """A syntax error: its line and column (from 1), the line's text, and Python's message."""

    line: int
    column: int
    text: str
    message: str


def syntax_mistake(text: str, name: str = "answer.py") -> SyntaxMistake | None:
    """Return the first syntax error in a program, or None."""
    try:
        ast.parse(text, name)
    except SyntaxError as error:
        return SyntaxMistake(error.lineno or 1, error.offset or 1, (error.text or "").rstrip("\n"), error.msg)
    except (RecursionError, MemoryError):
        return SyntaxMistake(1, 1, "", "part of it is too deeply nested, or too long, for Python to read")
    except ValueError as error:
        return SyntaxMistake(1, 1, "", str(error))
    return None


def read_program(raw: bytes) -> str:
    """Decode a Python file as Python does (byte order mark, coding line). Raises Ungradable if that's impossible."""
    kind = binary_kind(raw)
    if kind is not None:
        raise Ungradable(f"the file is {kind} and not a program. Hand in the program itself, as plain text")
    if raw[:2] in (b"\xff\xfe", b"\xfe\xff"):
        raise Ungradable("the file is UTF-16 text; Python reads UTF-8. Save it again as UTF-8")
    if b"\0" in raw:
        raise Ungradable(ZERO_BYTES)
    try:
        encoding, _ = tokenize.detect_encoding(BytesIO(raw).readline)
        text = raw.decode(encoding)
    except (SyntaxError, ValueError, LookupError) as error:
        raise Ungradable(f"the file is not readable as text: {error}") from error
    return with_line_feeds(text.lstrip("\ufeff"))


def with_line_feeds(text: str) -> str:
    """Return the text with Linux line endings.

    Python also ends a line at a lone carriage return, but most tools don't.
    """
    return text.replace("\r\n", "\n").replace("\r", "\n")


def _as_utf8(text: str) -> str:
    """Return the program, ready to be saved as UTF-8: a coding line that names another encoding is changed.

    Raises Ungradable for a lone surrogate, which UTF-8 can't encode.
    """
    try:
        text.encode()
    except UnicodeEncodeError as error:
        raise Ungradable(
            f"the answer contains half of a character (a lone surrogate), which cannot be saved: {error.reason}"
        ) from error
    lines = text.split("\n")
    for index in range(min(2, len(lines))):
        lines[index] = _CODING.sub(r"\1utf-8", lines[index])
    return "\n".join(lines)


def answer_in_notebook(path: Path, stem: str) -> Answer:
    """Return the program in the last cell whose first non-blank line is `%%answer STEM`.

    Raises Ungradable if there is no such cell or it can't be judged, and OSError if the file is unreadable.
    """
    found = answer_cells(path, stem)
    if "problem" in found:
        raise Ungradable(found["problem"])
    if found["text"] is not None:
        if not str(found["text"]).strip() and len(found["answers"]) > 1:
            *others, last = found["answers"]
            raise Ungradable(
                f"the last cell with `{ANSWER_MAGIC} {stem}`, cell {last}, is empty, but only the last one counts. An "
                f"earlier one is cell {others[-1]}: delete cell {last}"
            )
        return Answer(str(found["text"]), _note(found, stem))
    if found["named"]:
        raise Ungradable(
            f"the notebook answers {', '.join(sorted(found['named']))}, not {stem}: no cell begins with "
            f"`{ANSWER_MAGIC} {stem}`" + "".join(f". But {miss}" for miss in found["near"][:1])
        )
    near = "".join(f". But {miss}" for miss in found["near"][:1]) + "".join(
        f". And {miss}" for miss in found["near"][1:]
    )
    raise Ungradable(f"the notebook has no cell that begins with `{ANSWER_MAGIC} {stem}`{near}")


def _note(found: dict[str, Any], stem: str) -> str:
    """Return a note on other cells that look like part of the answer, or "" if there are none."""
    *others, last = found["answers"]
    if others:
        cells = " and ".join(map(str, found["answers"]))
        return f"Cells {cells} begin with `{ANSWER_MAGIC} {stem}`. Cell {last} was judged, because the last one counts."
    if found["after"] is not None:
        return (
            f"Cell {found['after']}, right after the answer, contains code that was not judged. If it belongs to the "
            "answer, put everything into one cell."
        )
    return ""


def exercises_named(path: Path) -> list[str]:
    """Return the exercises named in a notebook's or program's `%%answer` lines, in order, or [] if there are none."""
    try:
        if path.is_symlink() or not path.is_file() or path.stat().st_size > LARGEST_NOTEBOOK_BYTES:
            return []
        if path.suffix == ".ipynb":
            return [str(stem) for stem in answer_cells(path).get("named", [])]
        with path.open("rb") as file:
            first = file.read(2000).decode("utf-8", "replace").lstrip().split("\n")[0]
    except OSError:
        return []
    return [stem for stem in [named_exercise(first)] if stem]


def _program_in(path: Path, stem: str) -> str:
    """Return the program in a .py file.

    If the file is a renamed notebook, or was exported from a notebook, return that notebook's answer.
    """
    text = read_program(path.read_bytes())
    if text.lstrip().startswith("{") and re.search(r'"(cells|worksheets)"\s*:', text):
        return with_line_feeds(answer_in_notebook(path, stem).text)
    exported = exported_answer(text, stem)
    return text if exported is None else with_line_feeds(exported)


def read_answer(path: Path, stem: str) -> Answer:
    """Read an answer to exercise `stem` from a .py or .ipynb file.

    Raises Ungradable, with a sentence for the student, if the file can't be an answer, and OSError if the file is
    unreadable.
    """
    if not path.exists() and not path.is_symlink():
        raise Ungradable(f"there is no file {path}")
    if path.is_symlink() or not path.is_file():
        raise Ungradable("this is not a regular file")
    largest = LARGEST_NOTEBOOK_BYTES if path.suffix == ".ipynb" else LARGEST_ANSWER_BYTES
    if path.stat().st_size > largest:
        advice = ". Clear the outputs of the notebook and save it again" if path.suffix == ".ipynb" else ""
        raise Ungradable(f"the file is larger than {largest // 1_000_000} MB{advice}")
    note = ""
    if path.suffix == ".ipynb":
        found = answer_in_notebook(path, stem)
        text, note = with_line_feeds(found.text), found.note
    elif path.suffix == ".py":
        text = _program_in(path, stem)
        lines = text.lstrip().split("\n")
        named = named_exercise(lines[0]) if lines else None
        if named is not None:
            if not means(named, stem):
                raise Ungradable(f"the file answers {named}, not {stem}")
            text = "\n".join(lines[1:])
    else:
        raise Ungradable(
            f"an answer is a .py or .ipynb file, not {path.suffix or 'a file without an extension'}"
        )
    if not text.strip():
        raise Ungradable("the answer is empty")
    if "\0" in text:
        raise Ungradable(ZERO_BYTES)
    if len(text) > LARGEST_ANSWER_BYTES:
        raise Ungradable(f"the answer is larger than {LARGEST_ANSWER_BYTES // 1_000_000} MB")
    text = _as_utf8(text)
    kind = kind_of(text) if syntax_mistake(text) else None
    if kind is not None:
        raise Ungradable(kind)
    return Answer(text if text.endswith("\n") else text + "\n", note)


def domains_named(text: str) -> frozenset[int]:
    """Return the numbers in all lines that contain "domain". The program may use any of them as its ROS domain."""
    lines = (line for line in text.splitlines() if "domain" in line.lower())
    return frozenset(int(number) for line in lines for number in _NUMBER.findall(line))
