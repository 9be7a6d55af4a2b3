"""Judges answers on the wall clock, as many side by side as keep the processors at work.

Such an answer waits for nine tenths of its time. How many of them fit depends on the machine and on what else runs
there. So there is one for each processor at first, one more whenever the processors idle, and one fewer whenever they
are busy: a busy machine is what makes a judgement inconclusive.
"""

import os
import time
from collections.abc import Callable, Iterable, Iterator, Sequence
from concurrent.futures import FIRST_COMPLETED, Future, ThreadPoolExecutor, wait
from dataclasses import dataclass
from typing import TypeVar

from workbook.inside.proc import idle_and_all_s

CORES = os.cpu_count() or 1
LOOK_S = 1.0
"""So long it is watched how busy the processors are with one lane more or less."""
IDLE_SHARE = 0.25
BUSY_SHARE = 0.1
"""Of the processors' time that nothing uses: above the first one more fits, below the second not all of them do."""
TOGETHER = 4
"""Answers that a lane judges before it may end. To start what judges them takes as long as one of them."""
Item = TypeVar("Item")
Result = TypeVar("Result")


@dataclass
class Pace:
    """How many lanes there may be now. `fewest`: at the beginning, and however busy the processors are."""

    fewest: int = CORES
    most: int = 8 * CORES
    lanes: int = 0

    def __post_init__(self) -> None:
        self.lanes = self.fewest

    def follow(self, idle_share: float) -> None:
        """Add a lane where processors idled, take one away where they were busy."""
        if idle_share > IDLE_SHARE:
            self.lanes = min(self.most, self.lanes + 1)
        elif idle_share < BUSY_SHARE:
            self.lanes = max(self.fewest, self.lanes - 1)


class IdleShare:
    """Tells which share of the processors' time was unused since it was last asked."""

    def __init__(self) -> None:
        self._before = idle_and_all_s()

    def __call__(self) -> float:
        """The share; 0 where nothing can be told."""
        now = idle_and_all_s()
        idle, passed = (later - before for later, before in zip(now, self._before, strict=True))
        self._before = now
        return idle / passed if passed > 0 else 0.0


def paced(
    parts: Iterable[Sequence[Item]],
    judge: Callable[[Sequence[Item]], Iterable[Result]],
    pace: Pace,
    idle_share: Callable[[], float],
    look_s: float = LOOK_S,
) -> Iterator[Result]:
    """Judge all parts, each in a lane of its own, as many of them at once as the pace allows.

    A lane more begins while others are at work; a lane too many ends with its part.
    """
    waiting = iter(parts)
    part = next(waiting, None)
    running: set[Future[list[Result]]] = set()
    looked = time.monotonic()
    with ThreadPoolExecutor(pace.most) as threads:
        while running or part is not None:
            while part is not None and len(running) < pace.lanes:
                running.add(threads.submit(_judged, judge, part))
                part = next(waiting, None)
            done, running = wait(running, look_s, FIRST_COMPLETED)
            for one in done:
                yield from one.result()
            if time.monotonic() - looked >= look_s:
                pace.follow(idle_share())
                looked = time.monotonic()


def _judged(judge: Callable[[Sequence[Item]], Iterable[Result]], part: Sequence[Item]) -> list[Result]:
    return [*judge(part)]


def in_parts(items: Sequence[Item], together: int = TOGETHER) -> list[Sequence[Item]]:
    """The items in their order, so many in each part."""
    return [items[start : start + together] for start in range(0, len(items), together)]
