"""Grading a folder: find the answers, skip what is done, judge the rest on several slots, keep the books."""

import hashlib
import time
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from pathlib import Path

from workbook.exercise.answers import LARGEST_NOTEBOOK_BYTES, Ungradable, read_answer
from workbook.exercise.definition import Exercise
from workbook.exercise.judging import Judgement
from workbook.grading.books import write_books
from workbook.grading.hand_ins import HandIn, find_hand_ins
from workbook.grading.pool import Isolation, Job, Judges, LocalSlots
from workbook.grading.results import (
    RESULTS,
    Done,
    Result,
    ResultsFile,
    done_before,
    graded_result,
    last_results,
    ungradable_result,
)
from workbook.grading.tries import counting, judge_until_sure


@dataclass(frozen=True)
class Progress:
    """How far a batch is. `left_s` is None until the first answer is done."""

    done: int
    total: int
    kept: int
    per_minute: float
    left_s: float | None
    latest: Result | None


@dataclass(frozen=True)
class BatchSummary:
    """What a batch did: the results of its answers, counts of those judged now and those kept from an earlier run, and
    seconds. `everything`: all results of the folder that count, by student and exercise."""

    results: tuple[Result, ...]
    everything: Mapping[tuple[str, str], Result]
    kept: int
    judged: int
    seconds: float
    stopped: bool


def _submitted_at(hand_in: HandIn) -> str | None:
    """What the `timestamp.txt` beside an answer says, or one further up in what its student handed in."""
    depth = max(1, len(Path(hand_in.label).parts) - 1)
    for folder in [*hand_in.path.parents][:depth]:
        stamp = folder / "timestamp.txt"
        try:
            if stamp.is_file() and not stamp.is_symlink() and stamp.stat().st_size < 200:
                return stamp.read_text(errors="replace").strip() or None
        except OSError:
            continue  # nobody knows then
    return None


def _file_sha(path: Path) -> str:
    """SHA-256 of a file that could not be judged; empty for what is no file, or too large to read."""
    try:
        if path.is_symlink() or not path.is_file() or path.stat().st_size > LARGEST_NOTEBOOK_BYTES:
            return ""
        return hashlib.sha256(path.read_bytes()).hexdigest()
    except OSError:
        return ""


class Batch:
    """Grades hand-ins of one exercise into the folder `out`; can be killed and started again at any time.

    `judges`: who judges the answers, in place of `slots` slots of this machine.
    """

    def __init__(
        self,
        exercise: Exercise,
        out: Path,
        slots: int = 1,
        isolation: Isolation = "limits",
        aliases: Mapping[str, str] | None = None,
        assignment: str | None = None,
        judges: Judges | None = None,
    ) -> None:
        self._assignment = assignment
        self._aliases = dict(aliases or {})
        self._exercise = exercise
        self._out = out
        self._judges = LocalSlots(slots, isolation) if judges is None else judges
        self._earlier: dict[str, Done] = {}

    def _is_done(self, hand_in: HandIn, sha256: str) -> bool:
        known = self._earlier.get(hand_in.student)
        return (
            known is not None
            and known.status != "infra_error"
            and known.answer_sha256 == sha256
            and known.criteria_sha256 == self._exercise.criteria_sha256
        )

    def _attempt(self, student: str) -> int:
        known = self._earlier.get(student)
        return 1 if known is None else known.attempt + 1

    def _refuse(self, hand_in: HandIn, reason: str, sha256: str) -> Result:
        return ungradable_result(
            student=hand_in.student,
            answer=hand_in.label,
            answer_sha256=sha256,
            submitted_at=_submitted_at(hand_in),
            exercise=self._exercise.stem,
            attempt=self._attempt(hand_in.student),
            reason=reason,
            isolation=self._judges.isolation,
            criteria_sha256=self._exercise.criteria_sha256,
            max_score=self._exercise.max_points,
        )

    def hand_ins(self, paths: Sequence[Path]) -> list[HandIn]:
        """What is handed in below `paths`, under the names that the alias file gives."""
        found = find_hand_ins(paths, self._exercise.stem, self._assignment)
        return [replace(one, student=self._name_of(one)) for one in found]

    def _name_of(self, hand_in: HandIn) -> str:
        for name in (hand_in.label, Path(hand_in.label).name, hand_in.student):
            if name in self._aliases:
                return self._aliases[name]
        return hand_in.student

    def run(
        self,
        paths: Sequence[Path],
        progress: Callable[[Progress], None] = lambda _: None,
        stop: Callable[[], bool] = lambda: False,
    ) -> BatchSummary:
        """Grade everything below `paths` that is new or changed.

        `progress` is called after each answer; `stop` is asked before each new one. Raises FileNotFoundError for a
        path that is not there, FolderInUse when another grader writes to the same folder.
        """
        began = time.monotonic()
        hand_ins = self.hand_ins(paths)
        book = ResultsFile(self._out / RESULTS)
        self._earlier = done_before(self._out / RESULTS, self._exercise.stem)
        jobs: list[Job[HandIn]] = []
        kept = done = 0
        try:
            for hand_in in hand_ins:
                try:
                    if hand_in.problem is not None:
                        raise Ungradable(hand_in.problem)
                    answer = read_answer(hand_in.path, self._exercise.stem)
                except (Ungradable, OSError) as error:
                    sha256 = _file_sha(hand_in.path)
                    if self._is_done(hand_in, sha256):
                        kept += 1
                        continue
                    result = self._refuse(hand_in, str(error), sha256)
                    book.append(result)
                    done += 1
                    progress(self._progress(done, len(hand_ins) - kept, kept, began, done, result))
                    continue
                if self._is_done(hand_in, answer.sha256):
                    kept += 1
                else:
                    jobs.append(Job(hand_in, self._exercise.stem, answer))
            total = done + len(jobs)
            refused = done

            def judge(some: Sequence[Job[HandIn]]) -> Iterator[tuple[Job[HandIn], Judgement]]:
                return self._judges.judge_all(some, stop=stop)

            for job, tries in judge_until_sure(jobs, judge):
                result = graded_result(
                    self._out,
                    counting(tries),
                    student=job.key.student,
                    answer=job.key.label,
                    submitted_at=_submitted_at(job.key),
                    attempt=self._attempt(job.key.student),
                    isolation=self._judges.isolation,
                    criteria_sha256=self._exercise.criteria_sha256,
                    max_score=self._exercise.max_points,
                    tries=tries,
                )
                book.append(result)
                done += 1
                progress(self._progress(done, total, kept, began, refused, result))
        finally:
            book.close()
            everything = last_results(self._out / RESULTS)
            write_books(self._out, self._exercise, everything)
        mine = {(hand_in.student, self._exercise.stem) for hand_in in hand_ins}
        return BatchSummary(
            results=tuple(everything[key] for key in sorted(mine & everything.keys())),
            everything=everything,
            kept=kept,
            judged=done,
            seconds=time.monotonic() - began,
            stopped=done < total,
        )

    @staticmethod
    def _progress(done: int, total: int, kept: int, began: float, refused: int, latest: Result) -> Progress:
        seconds = max(time.monotonic() - began, 1e-6)
        ran = done - refused
        per_minute = 60 * ran / seconds
        left = (total - done) * seconds / ran if ran else None
        return Progress(done, total, kept, per_minute, left, latest)
