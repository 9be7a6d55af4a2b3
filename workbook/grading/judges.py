"""Who judges many answers, and what they are given: the slots of this machine, or a farm, look the same."""

from collections.abc import Callable, Iterable, Iterator
from dataclasses import dataclass
from typing import Generic, Protocol, TypeVar

from workbook.exercise.answers import Answer
from workbook.exercise.judgement import Judgement
from workbook.isolation.tiers import Isolation

Key = TypeVar("Key")


@dataclass(frozen=True)
class Job(Generic[Key]):
    """One answer to judge; `key` is handed back with the judgement. `seed`: see `Judge.judge`."""

    key: Key
    stem: str
    answer: Answer
    seed: int | None = None


class NoJudges(RuntimeError):
    """No worker or slot can judge, or all of them were lost. The message says why and what to do."""


class GradingBackend(Protocol):
    """Judges many answers: on the slots of this machine, or on a farm."""

    @property
    def isolation(self) -> Isolation:
        """The tier of isolation that programs run in."""

    def judge_all(
        self, jobs: Iterable[Job[Key]], *, soak: bool = True, stop: Callable[[], bool] = lambda: False
    ) -> Iterator[tuple[Job[Key], Judgement]]:
        """Judge many answers; yields each judgement as it is ready, each job once.

        `stop` is asked before each new answer, so that an interrupted run ends after those under way. Raises NoJudges.
        """
