"""Feedback as text for a terminal."""

import textwrap

from workbook.criteria.runner import CriterionResult
from workbook.exercise.judgement import Judgement
from workbook.exercise.museum import Exhibit
from workbook.feedback import wording

WIDTH = 100
_ANSI = {"passed": "32", "failed": "31", "partial": "33", "skipped": "90"}


def _paint(text: str, status: str, color: bool) -> str:
    return f"\x1b[{_ANSI[status]}m{text}\x1b[0m" if color else text


def _block(label: str, text: str) -> list[str]:
    if not text:
        return []
    return textwrap.wrap(
        text, WIDTH, initial_indent=f"      {label:<9}", subsequent_indent=" " * 15, break_long_words=False
    )


def _criterion(result: CriterionResult, color: bool, in_full: bool) -> list[str]:
    earned = (
        f"{wording.points(result.points)}/{wording.points(result.max_points)}" if result.max_points else ""
    )
    sign = _paint(wording.SIGNS[result.status], result.status, color)
    lines = [f"  {sign} {earned:>5}  {result.title}"]
    if in_full:
        lines += _block("saw", result.saw)
        lines += _block("expected", result.expected)
        lines += _block("because", result.because)
        lines += _block("try", result.try_this)
    elif result.status in ("failed", "partial"):
        lines += _block("saw", result.saw)
    return lines


def as_text(
    judgement: Judgement, color: bool = False, log_lines: int = 12, exhibit: Exhibit | None = None
) -> str:
    """The judgement for a terminal: the headline, every criterion, and the first one to fix in full.

    `exhibit`: the entry of the error museum that fits.
    """
    lines = [f"{judgement.stem}: {wording.headline(judgement)}"]
    first = wording.first_to_mend(judgement)
    for result in wording.visible(judgement):
        lines += _criterion(result, color, in_full=result is first)
        if result is first and exhibit is not None:
            lines += _block("more", f"{exhibit.symptom} (notebooks/error_museum.md, lesson {exhibit.lesson})")
    for line in (
        wording.provisional_line(judgement),
        wording.doubt_line(judgement),
        wording.hidden_line(judgement),
        wording.clock_line(judgement),
    ):
        if line:
            lines.append(f"  {line}")
    log = wording.printed(judgement)
    if first is not None and "Traceback" in log:
        tail = log.rstrip().splitlines()[-log_lines:]
        lines += ["  Last lines of your program's log:", *(f"    {line}" for line in tail)]
    return "\n".join(lines)
