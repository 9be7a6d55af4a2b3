"""Format feedback as text for a terminal."""

import re
import textwrap
from collections.abc import Sequence

from workbook.criteria.runner import CriterionResult
from workbook.exercise.judgement import Judgement
from workbook.exercise.museum import Exhibit
from workbook.feedback import wording
from workbook.recording.plain_text import without_commands

WIDTH = 80
_SCRATCH = re.compile(r'"/[^"]*/rclpy-workbook-[^/"]+/')
_ANSI = {"passed": "32", "failed": "31", "partial": "33", "skipped": "90"}


def _paint(text: str, status: str, color: bool) -> str:
    return f"\x1b[{_ANSI[status]}m{text}\x1b[0m" if color else text


def _wrapped(text: str, width: int, first: str, rest: str) -> list[str]:
    text = without_commands(text)
    return textwrap.wrap(text, width, initial_indent=first, subsequent_indent=rest, break_long_words=False)


def _block(label: str, text: str, width: int) -> list[str]:
    return _wrapped(text, width, f"      {label:<9}", " " * 15) if text else []


def _criterion(result: CriterionResult, color: bool, in_full: bool, width: int) -> list[str]:
    earned = (
        f"{wording.points(result.points)}/{wording.points(result.max_points)}" if result.max_points else ""
    )
    sign = wording.SIGNS[result.status]
    title, *rest = _wrapped(result.title, width, f"  {sign} {earned:>5}  ", " " * 11)
    lines = [title.replace(sign, _paint(sign, result.status, color), 1), *rest]
    if in_full:
        lines += _block("saw", result.saw, width)
        lines += _block("expected", result.expected, width)
        lines += _block("because", result.because, width)
        lines += _block("try", result.try_this, width)
    elif result.status in ("failed", "partial"):
        lines += _block("saw", result.saw, width)
    return lines


def _program_lines(lines: Sequence[str], width: int) -> list[str]:
    """Return a program's output lines, without the path of its temporary folder. Long lines are split."""
    room = max(20, width - 4)
    short = [_SCRATCH.sub('"', without_commands(line)) for line in lines]
    return [f"    {line[at : at + room]}" for line in short for at in range(0, max(1, len(line)), room)]


def as_text(
    judgement: Judgement,
    color: bool = False,
    log_lines: int = 12,
    exhibit: Exhibit | None = None,
    width: int = WIDTH,
) -> str:
    """Return the judgment for a terminal: the headline, every visible criterion, and details on the first one to fix.

    `exhibit`: the matching entry in the error museum.
    """
    lines = _wrapped(f"{judgement.stem}: {wording.headline(judgement)}", width, "", "  ")
    first = wording.first_to_mend(judgement)
    for result in wording.visible(judgement):
        lines += _criterion(result, color, in_full=result is first, width=width)
        if result is first and exhibit is not None:
            symptom = f"{exhibit.symptom} (notebooks/error_museum.md, lesson {exhibit.lesson})"
            lines += _block("more", symptom, width)
    for line in (
        wording.provisional_line(judgement),
        wording.inconclusive_line(judgement),
        wording.hidden_line(judgement),
        wording.clock_line(judgement),
    ):
        lines += _wrapped(line, width, "  ", "  ")
    log = wording.printed(judgement)
    if first is not None and "Traceback" in log:
        tail = log.rstrip().splitlines()[-log_lines:]
        lines += ["  Last lines of your program's log:", *_program_lines(tail, width)]
    return "\n".join(lines)
