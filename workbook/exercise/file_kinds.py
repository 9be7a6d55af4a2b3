"""Recognize files that are named like a program but aren't one: name their kind, or find the program inside."""

import ast
import re

from workbook.exercise.notebook_cells import means

_BINARY = {
    b"%PDF-": "a PDF document",
    b"PK\x03\x04": "a ZIP archive or an office document",
    b"\x1f\x8b": "a compressed archive",
    b"7z\xbc\xaf": "a compressed archive",
    b"Rar!": "a compressed archive",
    b"\x89PNG": "a picture",
    b"\xff\xd8\xff": "a picture",
    b"\x7fELF": "a compiled program",
    b"\xd0\xcf\x11\xe0": "an office document",
    b"{\\rtf": "a text document (RTF)",
}
_HAND_IN_TEXT = "Hand in the program itself, as plain text"
_HAS_A_CELL_MAGIC = "run_cell_magic"
_TEXTS = (
    (
        r"\A\s*version https://git-lfs\.github\.com/",
        "a Git LFS pointer. Hand in the file that it points to",
    ),
    (r"(?i)\A\s*(<!doctype html|<html|<\?xml|<head|<body)", f"a web page, not a program. {_HAND_IN_TEXT}"),
    (r"\A\s*\{\\rtf", f"a text document (RTF). {_HAND_IN_TEXT}"),
    (r"\A\s*Traceback \(most recent call last\):", f"an error message, not a program. {_HAND_IN_TEXT}"),
    (
        r"(?m)\A\s*(\S+@\S+[:~].*)?[$#>] ?(python3?|cd|source|ls|pip|ros2|cat|workbook) ",
        f"a copy of a terminal. {_HAND_IN_TEXT}",
    ),
    (r"\A\s*>>> ", f"a copy of an interactive session (`>>>`). {_HAND_IN_TEXT}"),
    (r"\A\s*(From|To|Subject|Date|Received|Return-Path): .+\n", f"an e-mail. {_HAND_IN_TEXT}"),
)
_CONFLICT = re.compile(r"(<<<<<<<|>>>>>>>) ")
_COMMAND = re.compile(r"\s*(!\s*[\w./]|%{1,2}[a-z]\w*(\s|$))")


def binary_kind(raw: bytes) -> str | None:
    """Return the kind of a file, judging by its first bytes, or None if the file may be a program."""
    return next((kind for start, kind in _BINARY.items() if raw.startswith(start)), None)


def kind_of(text: str) -> str | None:
    """Return the kind of a string that Python can't parse, as the end of a sentence.

    The result is None if the string is a program with a mistake.
    """
    lines = text.split("\n")
    conflict = next((n for n, line in enumerate(lines, 1) if _CONFLICT.match(line)), None)
    if conflict is not None:
        return (
            f"Git left a conflict in line {conflict}. Choose one version, and delete the lines with the marks"
        )
    for pattern, kind in _TEXTS:
        if re.search(pattern, text[:2000]):
            return f"the file is {kind}"
    for number, line in enumerate(lines, 1):
        if _COMMAND.match(line) and _reads_without(lines, number):
            return f"line {number} is a notebook command, not Python: `{line.strip()[:60]}`. Delete it"
    return None


def _reads_without(lines: list[str], number: int) -> bool:
    """Return whether the lines before this line are valid Python, which makes this line the problem."""
    try:
        ast.parse("\n".join([*lines[: number - 1], "pass"]))
    except (SyntaxError, ValueError, RecursionError, MemoryError):
        return False
    return True


def exported_answer(text: str, stem: str) -> str | None:
    """Return the last answer to `stem` in a notebook that was exported as a script, or None if there is none."""
    if _HAS_A_CELL_MAGIC not in text:
        return None
    try:
        tree = ast.parse(text)
    except (SyntaxError, ValueError, RecursionError, MemoryError):
        return None
    found = None
    for statement in tree.body:
        match statement:
            case ast.Expr(
                value=ast.Call(
                    func=ast.Attribute(attr="run_cell_magic"),
                    args=[
                        ast.Constant(value="answer"),
                        ast.Constant(value=str(line)),
                        ast.Constant(value=str(cell)),
                    ],
                )
            ) if means((line.split() or [""])[0], stem):
                found = cell
    return found
