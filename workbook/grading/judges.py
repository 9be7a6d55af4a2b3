"""Define the interface for judging many answers, which both a machine's slots and a farm implement."""

from collections.abc import Callable, Iterable, Iterator
from dataclasses import dataclass
from typing import Generic, Protocol, TypeVar

from workbook.exercise.answers import Answer
from workbook.exercise.judgement import Judgement
from workbook.isolation.tiers import Isolation

Key = TypeVar("Key")


@dataclass(frozen=True)
class Job(Generic[Key]):
    """One answer to judge. `key` identifies the answer when its judgment is returned. `seed`: see `Judge.judge`."""

    key: Key
    stem: str
    answer: Answer
    seed: int | None = None


class NoJudges(RuntimeError):
    """Raised when no worker or slot can judge, or all of them were lost. The message says why and what to do."""


class GradingBackend(Protocol):
    """Judges many answers, on this machine's slots or on a farm's workers."""

    @property
    def isolation(self) -> Isolation:
        """The isolation tier in which programs run."""

    def judge_all(
        self, jobs: Iterable[Job[Key]], *, soak: bool = True, stop: Callable[[], bool] = lambda: False
    ) -> Iterator[tuple[Job[Key], Judgement]]:
        """Judge many answers. Yield each job once, with its judgment, as soon as the judgment is ready.

        `stop` is called before each new answer. Once it returns True, no new answer is started, and this method returns
        after the judgments in progress. `soak`: see `Judge.judge`. Raises NoJudges.
        """
