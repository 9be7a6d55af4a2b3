"""Judge mutants like students' answers. An outcome is cached until the program or the judge changes."""

import hashlib
import json
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from dataclasses import asdict, dataclass
from functools import cache
from pathlib import Path

from workbook.exercise.answers import Answer
from workbook.exercise.judgement import Judgement
from workbook.exercise.retries import counting, judge_until_sure
from workbook.grading.judges import Job

JUDGES_WITH = (
    "criteria", "exercise", "inside", "isolation", "programs", "recording", "ros", "typechecking", "watching",
)  # fmt: skip
"""The subpackages of `workbook` that a judgment depends on."""
JudgeAll = Callable[[Sequence[Job[str]]], Iterator[tuple[Job[str], Judgement]]]


@dataclass(frozen=True)
class Marks:
    """The outcome for one program: the criteria that it didn't pass (`lost`), and the first lost one's cause ID."""

    lost: tuple[str, ...]
    cause: str = ""

    @property
    def full_marks(self) -> bool:
        """Whether the program lost no criterion."""
        return not self.lost


class Cache:
    """Stores outcomes in a file, one per line. Each outcome is written right away, so an interrupted run can continue.

    `judge_sha256` must cover everything that affects an outcome, except the program itself.
    """

    def __init__(self, path: Path, judge_sha256: str) -> None:
        self._path, self._judge = path, judge_sha256
        self._known: dict[str, Marks] = dict(_stored(path))

    def get(self, answer: Answer) -> Marks | None:
        """Return a program's stored outcome, or None if there is none."""
        return self._known.get(self._key(answer))

    def put(self, answer: Answer, outcome: Marks) -> None:
        """Store a program's outcome."""
        key = self._key(answer)
        self._known[key] = outcome
        self._path.parent.mkdir(parents=True, exist_ok=True)
        with self._path.open("a", encoding="utf-8") as file:
            file.write(json.dumps({"key": key, **asdict(outcome)}) + "\n")

    def _key(self, answer: Answer) -> str:
        return hashlib.sha256(f"{self._judge} {answer.sha256}".encode()).hexdigest()


def _stored(path: Path) -> Iterator[tuple[str, Marks]]:
    """Yield the keys and outcomes in a file. Skip incomplete lines. If there is no file, yield nothing."""
    if not path.is_file():
        return
    for line in path.read_text(encoding="utf-8").splitlines():
        try:
            read = json.loads(line)
            yield read["key"], Marks(tuple(read["lost"]), read["cause"])
        except (ValueError, KeyError, TypeError):
            continue


@cache
def judge_sha256() -> str:
    """Return a hash of the packages that run, record, and judge answers."""
    package = Path(__file__).resolve().parents[2]
    digest = hashlib.sha256()
    for name in JUDGES_WITH:
        for path in sorted((package / name).rglob("*.py")):
            digest.update(f"{path.relative_to(package).as_posix()}\n".encode())
            digest.update(path.read_bytes())
    return digest.hexdigest()


def judge_programs(
    stem: str,
    programs: Mapping[str, Answer],
    cache: Cache,
    judge: JudgeAll,
    say: Callable[[str, Marks], None] = lambda name, outcome: None,
    keep: Callable[[Marks], bool] = lambda outcome: True,
) -> dict[str, Marks]:
    """Judge programs, and return the outcomes, keyed by program name. Programs that couldn't be judged are left out.

    Programs with a cached outcome aren't judged again. New outcomes are passed to `say`, and cached if `keep` returns
    true for them.
    """
    known = {name: cache.get(answer) for name, answer in programs.items()}
    found = {name: outcome for name, outcome in known.items() if outcome is not None}
    jobs = [Job(name, stem, answer) for name, answer in programs.items() if name not in found]
    for job, tries in judge_until_sure(jobs, judge):
        outcome = outcome_of(tries)
        if outcome is not None:
            if keep(outcome):
                cache.put(job.answer, outcome)
            found[job.key] = outcome
            say(job.key, outcome)
    return found


def outcome_of(tries: Iterable[Judgement]) -> Marks | None:
    """Return the outcome of the judgment that counts among the tries.

    Return None if the answer couldn't be judged, or if that judgment was inconclusive.
    """
    judgement = counting([*tries])
    if judgement.status != "graded" or judgement.inconclusive_reason:
        return None
    lost = [one for one in judgement.criteria if one.status != "passed"]
    return Marks(tuple(one.id for one in lost), lost[0].cause if lost else "")
