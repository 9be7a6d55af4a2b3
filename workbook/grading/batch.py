"""Grade a folder of answers on several slots, which are processes that judge answers.

A run finds the answers, skips those that have already been judged, judges the others, and stores the results.
"""

import hashlib
import os
import time
from collections.abc import Callable, Container, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from pathlib import Path

from workbook.exercise.answers import LARGEST_NOTEBOOK_BYTES, Ungradable, read_answer
from workbook.exercise.definition import Exercise
from workbook.exercise.judgement import Judgement
from workbook.exercise.retries import judge_until_sure
from workbook.grading.gradebook import write_gradebook
from workbook.grading.hand_ins import HandIn, all_hand_ins
from workbook.grading.handed_in import note
from workbook.grading.judges import GradingBackend, Job
from workbook.grading.new_results import GradedBy, Submission, graded_result, ungradable_result
from workbook.grading.pages import PAGES
from workbook.grading.results import Result, StudentAndExercise
from workbook.grading.results_file import RESULTS, BrokenLine, Done, ResultsFile, done_before, last_results
from workbook.grading.roster import BadOption, Roster, about_unused
from workbook.grading.skipped import about_skipped, find_skipped
from workbook.grading.slots.pool import STOPPED_JUDGE

UNREADABLE = "unreadable"
"""Stored instead of the submission time if a timestamp.txt exists but can't be read."""
WRITTEN = tuple((name,) for name in ("recordings", PAGES, "gradescope"))
"""The folders that a run creates next to the results, each as the tuple of its path's parts."""


@dataclass(frozen=True)
class BatchProgress:
    """The progress of a run.

    `kept`: the number of answers that an earlier run had judged. `left_s`: the estimated time left, in seconds, or None
    until the first answer has been judged.
    """

    done: int
    total: int
    kept: int
    per_minute: float
    left_s: float | None
    latest: Result | None


@dataclass(frozen=True)
class BatchSummary:
    """The outcome of one run over a folder of answers.

    `results`: the results of the answers under this run's paths. `everything`: all current results in the folder, keyed
    by student and exercise. `judged`: the number of answers that this run judged, in `seconds`. `kept`: the number of
    answers that earlier runs had judged. `frozen`: the number of kept answers that were judged with criteria that have
    changed since. `broken`: lines of results.jsonl that aren't valid results. `remarks`: sentences about skipped files,
    unused aliases, and students without a hand-in.
    """

    results: tuple[Result, ...]
    everything: Mapping[StudentAndExercise, Result]
    broken: tuple[BrokenLine, ...]
    kept: int
    frozen: int
    judged: int
    seconds: float
    stopped: bool
    remarks: tuple[str, ...]


def _submitted_at(hand_in: HandIn) -> str | None:
    """Return the content of the outermost `timestamp.txt` above an answer, within the student's folder.

    Only the outermost file counts, because files with that name further down are the student's own. Return None if
    there is no such file, and UNREADABLE if the outermost one can't be read.
    """
    depth = max(1, len(Path(hand_in.label).parts) - 1)
    for folder in reversed([*hand_in.path.parents][:depth]):
        stamp = folder / "timestamp.txt"
        try:
            if not os.path.lexists(stamp):
                continue
            if stamp.is_file() and not stamp.is_symlink() and stamp.stat().st_size < 200:
                return stamp.read_text(errors="replace").strip() or UNREADABLE
        except OSError:
            pass
        return UNREADABLE
    return None


def _file_sha(path: Path) -> str:
    """Return the SHA-256 of a hand-in that couldn't be judged, or "" if it isn't a file or is too large."""
    try:
        if path.is_symlink() or not path.is_file() or path.stat().st_size > LARGEST_NOTEBOOK_BYTES:
            return ""
        with path.open("rb") as file:
            return hashlib.file_digest(file, "sha256").hexdigest()
    except OSError:
        return ""


class Batch:
    """Grades one exercise's hand-ins, and writes the results to the folder `out`.

    A run can be killed and started again at any time. `retry_stopped`: whether to judge an unchanged answer again if it
    made the judge fail in an earlier run. `seed`: the seed of the random values that the judge sends to answers, or
    None for a new seed in each try.
    """

    def __init__(
        self,
        exercise: Exercise,
        out: Path,
        judges: GradingBackend,
        roster: Roster | None = None,
        *,
        retry_stopped: bool = False,
        seed: int | None = None,
    ) -> None:
        self._retry_stopped = retry_stopped
        self._seed = seed
        self._exercise = exercise
        self._out = out
        self._judges = judges
        self._roster = roster or Roster()

    def hand_ins(self, paths: Sequence[Path]) -> list[HandIn]:
        """Return the hand-ins under `paths`, with the students' names from the roster."""
        return self._roster.hand_ins(self._found(paths))

    def check_paths(self, paths: Sequence[Path]) -> None:
        """Raise BadOption if there is no hand-in under `paths`."""
        if not self._found(paths):
            places = ", ".join(map(str, paths))
            remarks = about_skipped(find_skipped(paths))
            raise BadOption(f"there is no answer below {places}" + (f". {remarks}" if remarks else ""))

    def _found(self, paths: Sequence[Path]) -> list[HandIn]:
        found = all_hand_ins(paths, self._exercise.stem, self._roster.assignment)
        return [one for one in found if not self._is_ours(one.path)]

    def _is_ours(self, path: Path) -> bool:
        """Return whether this file or folder was written by a run.

        The search for answers finds such files if the folder `out` is inside the folder with the answers.
        """
        path, out = path.resolve(), self._out.resolve()
        if path.is_dir() and (path == out or (path / RESULTS).is_file()):
            return True
        return path.is_relative_to(out) and path.relative_to(out).parts[:1] in WRITTEN

    def _remarks(self, paths: Sequence[Path], found: Sequence[HandIn]) -> tuple[str, ...]:
        """Return sentences about skipped files and unused aliases."""
        return tuple(
            filter(None, (about_skipped(find_skipped(paths)), about_unused(self._roster.unused(found))))
        )

    def _correct_times(self, hand_ins: Sequence[HandIn], file: ResultsFile) -> None:
        """Store the changed submission times of answers that have already been judged, without judging them again."""
        known = last_results(self._out / RESULTS)
        for hand_in in hand_ins:
            result = known.get((hand_in.student, self._exercise.stem))
            if result is not None and result.submitted_at != (moment := _submitted_at(hand_in)):
                file.append(replace(result, submitted_at=moment))

    def _note(self, paths: Sequence[Path], hand_ins: Sequence[HandIn]) -> None:
        """Store which students have handed in an answer. The list counts as complete only if all paths are folders."""
        students = [one.student for one in hand_ins]
        note(self._out, self._exercise.stem, students, whole=all(path.is_dir() for path in paths))

    def _left_over(
        self,
        paths: Sequence[Path],
        everything: Iterable[StudentAndExercise],
        mine: Container[StudentAndExercise],
    ) -> Iterator[str]:
        """Yield a sentence about the students who have a result but no hand-in, if all `paths` are folders."""
        left = sorted(key[0] for key in everything if key[1] == self._exercise.stem and key not in mine)
        if left and all(path.is_dir() for path in paths):
            what = "1 earlier result has" if len(left) == 1 else f"{len(left)} earlier results have"
            yield (
                f"{what} no hand-in in this run: {', '.join(left)}. Exports leave them out. If they belong to the "
                "class, name all folders with answers in one command"
            )

    def run(
        self,
        paths: Sequence[Path],
        progress: Callable[[BatchProgress], None] = lambda _: None,
        stop: Callable[[], bool] = lambda: False,
    ) -> BatchSummary:
        """Grade all hand-ins under `paths` that are new or have changed.

        Call `progress` after each answer, and `stop` before each new one. If `stop` returns True, stop early. Raises
        FileNotFoundError if a path doesn't exist, and FolderInUse if another run is writing to the same folder.
        """
        found = self._found(paths)
        hand_ins = self._roster.hand_ins(found)
        broken: list[BrokenLine] = []
        file = ResultsFile(self._out / RESULTS)
        by = GradedBy(self._exercise, self._judges.isolation, self._out)
        run = _BatchRun(by, file, progress, self._retry_stopped)
        try:
            jobs = [replace(job, seed=self._seed) for job in run.refuse_or_keep(hand_ins)]

            def judge(some: Sequence[Job[HandIn]]) -> Iterator[tuple[Job[HandIn], Judgement]]:
                return self._judges.judge_all(some, stop=stop)

            for job, tries in judge_until_sure(jobs, judge):
                run.judged(job, tries)
            self._correct_times(hand_ins, file)
        finally:
            file.close()
            self._note(paths, hand_ins)
            everything = last_results(self._out / RESULTS, broken.append)
            write_gradebook(self._out, self._exercise, everything)
        mine = {(hand_in.student, self._exercise.stem) for hand_in in hand_ins}
        return BatchSummary(
            results=tuple(everything[key] for key in sorted(mine & everything.keys())),
            everything=everything,
            broken=tuple(broken),
            kept=run.kept,
            frozen=run.frozen,
            judged=run.done,
            seconds=run.seconds,
            stopped=run.done < run.total,
            remarks=(*self._remarks(paths, found), *self._left_over(paths, everything, mine)),
        )


class _BatchRun:
    """Tracks the finished and remaining answers of one run, and writes each result to `file` right away."""

    def __init__(
        self,
        by: GradedBy,
        file: ResultsFile,
        progress: Callable[[BatchProgress], None],
        retry_stopped: bool,
    ) -> None:
        self._retry_stopped = retry_stopped
        self._began = time.monotonic()
        self._by = by
        self._file = file
        self._progress = progress
        self._earlier: Mapping[str, Done] = done_before(by.out / RESULTS, by.exercise.stem)
        self.kept = 0
        self.frozen = 0
        self.refused = 0
        self.done = 0
        self.total = 0

    @property
    def seconds(self) -> float:
        return time.monotonic() - self._began

    def refuse_or_keep(self, hand_ins: Sequence[HandIn]) -> list[Job[HandIn]]:
        """Record the answers that can't be judged, and skip those that an earlier run judged.

        Return the answers to judge now.
        """
        jobs: list[Job[HandIn]] = []
        self.total = len(hand_ins)
        for hand_in in hand_ins:
            try:
                if hand_in.problem is not None:
                    raise Ungradable(hand_in.problem)
                answer = read_answer(hand_in.path, self._by.exercise.stem)
            except (Ungradable, OSError) as error:
                sha256 = _file_sha(hand_in.path)
                if not self._keep(hand_in.student, sha256):
                    self.refused += 1
                    self._add(ungradable_result(self._submission(hand_in, sha256), str(error), self._by))
                continue
            if not self._keep(hand_in.student, answer.sha256):
                jobs.append(Job(hand_in, self._by.exercise.stem, answer))
        self.total = self.refused + len(jobs)
        return jobs

    def judged(self, job: Job[HandIn], tries: Sequence[Judgement]) -> None:
        """Record the result of an answer that has just been judged."""
        self._add(
            graded_result(self._submission(job.key, job.answer.sha256, job.answer.note), tries, self._by)
        )

    def _submission(self, hand_in: HandIn, sha256: str, note: str = "") -> Submission:
        known = self._earlier.get(hand_in.student)
        attempt = 1 if known is None else known.attempt + 1
        return Submission(hand_in.student, hand_in.label, sha256, _submitted_at(hand_in), attempt, note)

    def _keep(self, student: str, sha256: str) -> bool:
        """Return whether an earlier run judged this exact answer, and if so, count it as kept.

        It's kept even if the criteria have changed since then, because marks change only on request (`--regrade`).
        """
        known = self._earlier.get(student)
        kept = (
            known is not None
            and known.status != "infra_error"
            and not (self._retry_stopped and (known.reason or "").startswith(STOPPED_JUDGE))
            and known.answer_sha256 == sha256
        )
        if known is not None and kept:
            self.kept += 1
            self.frozen += known.criteria_sha256 != self._by.exercise.criteria_sha256
            self.total -= 1
        return kept

    def _add(self, result: Result) -> None:
        self._file.append(result)
        self.done += 1
        seconds = max(self.seconds, 1e-6)
        ran = self.done - self.refused
        left_s = (self.total - self.done) * seconds / ran if ran else None
        self._progress(BatchProgress(self.done, self.total, self.kept, 60 * ran / seconds, left_s, result))
