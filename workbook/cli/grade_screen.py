"""Print the output of `workbook grade`: its progress while it runs, and summaries at the end."""

import os
import sys
from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from workbook.grading.batch import BatchProgress, BatchSummary
    from workbook.grading.lateness import Lateness
    from workbook.grading.regrade import Regraded
    from workbook.grading.repeatability import Unsteady
    from workbook.grading.results import Result
    from workbook.grading.results_file import BrokenLine


def minutes(seconds: float) -> str:
    """Format a duration that is given in seconds, such as "42 s", or "4:05 min" for a minute or more."""
    whole = round(seconds)
    return f"{whole // 60}:{whole % 60:02d} min" if whole >= 60 else f"{whole} s"


def outcome(result: "Result") -> str:
    """Return the score and the maximum score, such as "8/10", or the status and the reason if there is no score."""
    if result.status != "graded":
        return f"{result.status}: {result.reason}"
    return f"{result.score:g}/{result.max_score:g}"


def printable(text: object) -> str:
    """Replace each line break, control character, or other unprintable character with a question mark."""
    return "".join(character if character.isprintable() else "?" for character in str(text))


class GradeScreen:
    """Shows the progress, in a terminal on a single line, and in a file with one line per answer."""

    def __init__(self) -> None:
        self._is_terminal = sys.stderr.isatty()

    def show(self, progress: "BatchProgress") -> None:
        """Print the number of finished answers, the number per minute, the time left, and the latest result."""
        left = "" if progress.left_s is None else f", {minutes(progress.left_s)} left"
        rate = f"{progress.per_minute:.0f} per minute{left}"
        latest = ""
        if progress.latest is not None:
            latest = printable(f"{progress.latest.student} {outcome(progress.latest)}")
        line = f"[{progress.done}/{progress.total}] {rate}  {latest}"
        if self._is_terminal:
            width = os.get_terminal_size(sys.stderr.fileno()).columns
            print(f"\r\x1b[K{line[: width - 1]}", end="", file=sys.stderr, flush=True)
        else:
            print(line, file=sys.stderr, flush=True)

    def say(self, text: str) -> None:
        """Print a sentence on a separate line."""
        start = "\r\x1b[K" if self._is_terminal else ""
        print(start + printable(text), file=sys.stderr, flush=True)

    def finish(self) -> None:
        """End the progress line on a terminal, so that the next output begins on a new line."""
        if self._is_terminal:
            print(file=sys.stderr)


class Stopping:
    """Handles Ctrl-C. After the first Ctrl-C, the run stops once the judgments in progress have finished.

    The second Ctrl-C exits right away. Finished judgments are kept in either case, because they've already been stored.
    """

    def __init__(self) -> None:
        self.wanted = False

    def __call__(self, *_: object) -> None:
        if self.wanted:
            os._exit(130)
        self.wanted = True
        print(
            "\nStopping once the current answers are judged. Ctrl-C again stops right away. To continue later, run "
            "the same command.",
            file=sys.stderr,
            flush=True,
        )


def say_broken(line: "BrokenLine") -> None:
    """Warn about an invalid line in results.jsonl."""
    print(f"workbook grade: {printable(line)}", file=sys.stderr)


def conclude(summary: "BatchSummary", out: Path, written: "Sequence[Path]") -> int:
    """Print a run's summary. Return the exit code: 130 if the run was stopped, 1 if the judge failed, else 0."""
    counts = {"graded": 0, "ungradable": 0, "infra_error": 0}
    full = 0
    for result in summary.results:
        counts[result.status] += 1
        full += result.score is not None and result.score == result.max_score
    print(
        f"{len(summary.results)} answers: {counts['graded']} graded ({full} with full marks), "
        f"{counts['ungradable']} ungradable, {counts['infra_error']} not judged because of an error in the judge."
    )
    for result in summary.results:
        if result.status != "graded":
            print(f"  {printable(result.student)}: {printable(outcome(result))}")
    for result in summary.results:
        if result.status == "graded" and result.reason:
            print(f"  {printable(result.student)}: {printable(result.reason)}")
    for line in _about_tries(summary.results):
        print(line)
    for remark in summary.remarks:
        print(f"{printable(remark)}.")
    print(f"{summary.judged} judged in {minutes(summary.seconds)}, {summary.kept} kept from an earlier run.")
    if summary.frozen:
        print(
            f"{summary.frozen} of these kept their marks although the criteria have changed since. To judge them "
            "again and list every difference, use --regrade."
        )
    print(f"All results: {out / 'results.jsonl'}   Created from them: {', '.join(map(str, written))}")
    if summary.stopped:
        print("Stopped early. To continue, run the same command again.")
        return 130
    return 1 if counts["infra_error"] else 0


def conclude_regrading(found: "Sequence[Regraded]", exercise: str) -> int:
    """Print whose marks changed and whose results couldn't be judged again.

    Return the exit code: 1 if a result couldn't be judged again, else 0.
    """
    changed = [one for one in found if one.changed]
    troubled = [one for one in found if one.problem]
    print(f"{len(found)} recordings of {exercise} judged again; the marks of {len(changed)} changed.")
    for one in changed:
        print(f"  {printable(one.student)}: {_points(one.before)} → {_points(one.after)}")
        for change in one.criteria:
            print(f"    {change.id}: {_points(change.before)} → {_points(change.after)}")
    for one in troubled:
        print(f"  {printable(one.student)}: not judged again: {printable(one.problem)}")
    return 1 if troubled else 0


def _points(points: float | None) -> str:
    return "no score" if points is None else f"{points:g}"


def conclude_repetition(found: "Sequence[Unsteady]", answers: int, times: int) -> int:
    """Print whose verdict changed from run to run. Return the exit code: 1 if a verdict changed, else 0."""
    print(f"{answers} answers, each judged {times} times: {len(found)} with changing verdicts.")
    for one in found:
        print(f"  {printable(one.student)}:")
        for verdict, count in one.verdicts:
            print(f"    {count} × {printable(verdict)}")
    return 1 if found else 0


def _about_tries(results: "Sequence[Result]") -> list[str]:
    """Return lines about the answers that were tried again: their number, and the students whose tries differ."""
    twice = [result for result in results if result.tries]
    if not twice:
        return []
    differ = [result for result in twice if result.tries_differ]
    what = "answer was" if len(twice) == 1 else "answers were"
    lines = [
        f"{len(twice)} {what} tried again, because the first try was inconclusive; {len(differ)} differ. "
        "All tries are kept."
    ]
    return lines + [f"  {printable(one.student)}: {printable(one.tried_twice())}" for one in differ]


def about_lateness(results: "Sequence[Result]", lateness: "Lateness | None") -> list[str]:
    """Return sentences about the deadlines and about hand-ins whose time is missing or unreadable."""
    from workbook.grading.deadlines import about_unknown, in_words

    if lateness is None:
        return []
    said = [f"Deadline: {in_words(lateness.deadline)}."]
    for one in results:
        if (own := lateness.deadline_of(one.student)) != lateness.deadline:
            said.append(f"Deadline of {printable(one.student)}: {in_words(own)}.")
    said.append(f"{printable(about_unknown(lateness.extensions, [one.student for one in results]))}.")
    unknown = lateness.unknown(results)
    for group, why in (
        ([one for one in unknown if one.submitted_at], "because the time in timestamp.txt cannot be read"),
        ([one for one in unknown if not one.submitted_at], "because there is no timestamp.txt with a time"),
    ):
        if group:
            names = ", ".join(printable(one.student) for one in group[:5]) + (", …" if len(group) > 5 else "")
            said.append(
                f"Nothing was subtracted for lateness, {why}: {len(group)} of {len(results)} ({names})."
            )
    return [sentence for sentence in said if sentence != "."]
