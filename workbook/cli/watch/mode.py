"""`workbook check --watch`: judge an answer again after each save.

The answers are judged in a warm slot, which is a child process that has already loaded the judge.
"""

import os
import sys
import time
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path

from workbook.cli import terminal
from workbook.cli.hint import hints_of
from workbook.cli.paths import as_typed
from workbook.cli.verdict_text import FULL_MARKS, NOT_JUDGED, NOT_YET, verdict_text
from workbook.cli.watch.screen import WatchScreen
from workbook.exercise.answers import Answer, Ungradable, read_answer
from workbook.exercise.judgement import Judgement
from workbook.exercise.retries import until_sure
from workbook.exercise.source import ExerciseSource
from workbook.feedback import wording
from workbook.grading.judges import Job
from workbook.grading.slots.pool import Kind, judge_warm, warm_slots
from workbook.grading.slots.protocol import Progress
from workbook.inside.proc import pids, process_tree

LOOK_S = 0.1
"""The polling period (s). We assume that a file is complete if it hasn't changed between two polls."""
END_S = 5.0
"""The longest time (s) for which `_end_all` waits for our child processes to exit."""

Signature = tuple[int, ...] | None


def signature(file: Path) -> Signature:
    """Return a value that changes each time the file is saved.

    Return None if the file doesn't exist. While an editor replaces the file, that's true for a short time.
    """
    try:
        state = file.stat()
    except OSError:
        return None
    return state.st_mtime_ns, state.st_size, state.st_ino


class _SavedAgain(Exception):
    """Raised when the file was saved again before the answer's next try."""


@dataclass
class Watched:
    """The watched answer and the options for judging it.

    `soak`: whether to also start the program again and watch it for eight real seconds, as in grading. `note`: a
    function that stores each judgment in the student's progress. For `seed`, see `Judge.judge`.
    """

    source: ExerciseSource
    file: Path
    soak: bool
    note: Callable[[Judgement, Answer], None]
    seed: int | None = None


class WatchMode:
    """Judges the answer after each save until Ctrl-C or `q`."""

    def __init__(self, watched: Watched, screen: WatchScreen) -> None:
        self._watched = watched
        self._screen = screen
        warm_slots.warm_up(Kind())
        self._code = NOT_JUDGED
        self._seen: Signature = None
        self._points: float | None = None
        self._shown = ""
        self._doing = ""
        self._judged_text: str | None = None

    def run(self) -> int:
        """Judge the answer after each save until the user quits. Return the exit code of the last judgment.

        When this method returns, the processes that it started have been stopped.
        """
        try:
            with self._screen.keys():
                self._judge()
                while self._waited_for_save():
                    self._judge()
        except KeyboardInterrupt:
            pass
        finally:
            self._end_all()
        print("\nStopped watching.", file=sys.stderr)
        return self._code

    def _end_all(self) -> None:
        """Close the slot, even if it's judging, and wait up to `END_S` for our child processes to exit."""
        started = process_tree(os.getpid())[1:]
        warm_slots.close()
        deadline = time.monotonic() + END_S
        while set(started) & set(pids()) and time.monotonic() < deadline:
            time.sleep(LOOK_S / 10)

    # --- waiting ------------------------------------------------------------------------------------------------

    def _waited_for_save(self) -> bool:
        """Wait until the user saves the file or presses the `c` key, and return True.

        Return False if the user quits.
        """
        before = signature(self._watched.file)
        while True:
            key = self._screen.key(LOOK_S)
            if key == "q":
                return False
            if key == "c":
                return True
            if key == "h":
                self._hint()
            now = signature(self._watched.file)
            if now is not None and now != self._seen and now == before:
                if self._holds_another():
                    return True
                self._seen = now
            before = now

    def _holds_another(self) -> bool:
        """Return whether the program in the file differs from the last judged program.

        The file may have been saved without changing the program, as `%start` and `%check` do.
        """
        try:
            return read_answer(self._watched.file, self._watched.source.stem).text != self._judged_text
        except (Ungradable, OSError):
            return True

    def _hint(self) -> None:
        source = self._watched.source
        self._screen.show(hints_of(source.stem, source.hints, None), *self._keys())

    # --- judging ------------------------------------------------------------------------------------------------

    def _judge(self) -> None:
        watched, name = self._watched, as_typed(self._watched.file)
        self._seen = signature(watched.file)
        self._judged_text = None
        self._doing = f"Judging {name} ..."
        self._screen.show(self._shown, self._doing)
        try:
            answer = read_answer(watched.file, watched.source.stem)
            judgement = until_sure(lambda: self._judged(answer), self._report)
        except (Ungradable, OSError) as error:
            self._code = NOT_JUDGED
            self._show(terminal.wrapped(f"{watched.source.stem}: not judged: {error}"), *self._keys())
            return
        except _SavedAgain:
            return
        self._judged_text = answer.text
        watched.note(judgement, answer)
        self._code = NOT_YET if judgement.status == "graded" else NOT_JUDGED
        notes = [self._change(judgement)]
        if wording.all_shown_hold(judgement):
            self._code = FULL_MARKS
            notes.append(f"Hand in this file: {name}")
        self._show(self._text(judgement), *filter(None, notes), *self._keys())

    def _judged(self, answer: Answer) -> Judgement:
        """Judge the answer in the warm slot. Raises _SavedAgain if the file was saved again after judging had begun."""
        if signature(self._watched.file) not in (self._seen, None):
            raise _SavedAgain
        job = Job("", self._watched.source.stem, answer, seed=self._watched.seed)
        return judge_warm(
            warm_slots,
            Kind(),
            job,
            soak=self._watched.soak,
            report=self._report,
            progress=self._progress,
        )

    def _report(self, judgement: Judgement) -> None:
        """Show a provisional judgment while the program is still being watched."""
        self._doing = "Still watching your program ..."
        self._show(self._text(judgement), self._doing)

    def _progress(self, progress: Progress) -> None:
        """Show the slot's progress, but only on a terminal, where new output can replace the old."""
        if self._screen.is_terminal:
            self._screen.show(self._shown, f"{self._doing} {progress}")

    # --- showing ------------------------------------------------------------------------------------------------

    def _text(self, judgement: Judgement) -> str:
        return verdict_text(judgement, terminal.in_color(sys.stdout))

    def _show(self, text: str, *notes: str) -> None:
        self._shown = text
        self._screen.show(text, *notes)

    def _change(self, judgement: Judgement) -> str:
        """Return a sentence about the change in points since the last judged save, or "" if they haven't changed."""
        if judgement.status != "graded":
            return ""
        points, before = wording.shown_points(judgement)[0], self._points
        self._points = points
        if before is None or before == points:
            return ""
        more = "more" if points > before else "fewer"
        count = wording.points(abs(points - before))
        return f"{count} {'point' if count == '1' else 'points'} {more} than before this save."

    def _keys(self) -> tuple[str, ...]:
        saving = f"Watching {as_typed(self._watched.file)}. Save it to judge it again."
        if not self._screen.takes_keys:
            return (f"{saving} Press Ctrl-C to stop.",)
        return (saving, "Keys: h hint, c check again, q quit.")
