"""Driving simulated time: in lock-step with the program where it comes to rest, at a fixed pace where it does not.

Fast and slow blocks alternate, so that a program that lives on the wall clock shows it, also when it stops early: see
`following`. A slow block is cut short once it has shown that every topic follows, and what is left of it is fast.
"""

import math
import time
from collections.abc import Sequence

from workbook.recording.plan import PERIODS_PER_BLOCK, SPEEDS
from workbook.recording.recording import Phase
from workbook.watching.clock import SimulatedClock
from workbook.watching.following import follows
from workbook.watching.lockstep import LockStep
from workbook.watching.session import Session

LOOK_EVERY_S = 0.1
SLOWER = 2.2
"""How many times longer a step of a slow block takes than one of the fast blocks before: more than the 2 that are
needed, because the next fast block may come out a little slower."""
SETTLE_S = 0.005
LATE_MATCH_S = 0.3
"""How long (s) the clock stands still for publishers of a topic that are made late. In all, because one that cannot be
connected must not hold it up again and again."""
MOST_REAL_S = 40.0
"""Real time (s) that simulated time may take in all. After that the wall clock judges."""
CLEARLY_FASTER = 2.0
"""How many times less than simulated time a program must work and sleep, so that real time would not be too short."""
LEAST_TAKEN_S = 0.5
"""Time that a program has worked and slept (s) from which on that is decided."""
LONGEST_NAP_PERIODS = 0.5
"""Of the shortest judged period: lockstep would wait for a callback that sleeps so long, and real time would not."""
MOST_EXTRA_S = 60.0
"""Simulated time that is added at most for topics that came too rarely to tell whether they follow the clock."""


class SimulatedRun:
    """Drives the clock of one watch. `phases`: what was driven, at which measured pace."""

    def __init__(self, session: Session, clock: SimulatedClock) -> None:
        self._session = session
        self._clock = clock
        self._lock = LockStep(session.process.pid)
        self._slowest_step_s = {True: 0.0, False: 0.0}
        self._next_look = 0.0
        self._late_match_s = dict.fromkeys(session.plan.topics, LATE_MATCH_S)
        self._until = time.monotonic() + MOST_REAL_S
        self._used_before_s = self._used_s = session.process.processor_seconds() or 0.0
        self.phases: list[Phase] = []

    def run_as_planned(self) -> float:
        """Let the planned simulated time pass, as long as the program runs. Returns its end (s of simulated time)."""
        plan = self._session.plan
        pairs = max(1, math.floor(plan.simulated_s / (2 * PERIODS_PER_BLOCK * plan.longest_period)))
        self._run(plan.simulated_s, pairs)
        return self._clock.now

    def run_longer(self) -> None:
        """Let more simulated time pass where that can show whether a topic follows the clock. It is not judged."""
        unsure = [times for name in self._session.plan.paced if (times := self._unsure(name))]
        if unsure and self._lock.works and self._session.process.is_running() and not self.outpaced:
            interval = max(self._clock.now / len(times) for times in unsure)
            self._run(min(MOST_EXTRA_S, 2 * PERIODS_PER_BLOCK * interval), 1)

    def _unsure(self, topic: str) -> list[float]:
        """When messages of a topic came of which nothing is proved yet (s of simulated time)."""
        times = self._session.recorder.times(topic)
        return times if follows(self.phases, times, self._session.plan.step_s) is None else []

    def following(self) -> dict[str, bool]:
        """The judged topics of which it is proved that they follow the clock, or that they do not."""
        found = {}
        for name in self._session.plan.paced:
            proved = follows(self.phases, self._session.recorder.times(name), self._session.plan.step_s)
            if proved is not None:
                found[name] = proved
        return found

    @property
    def in_lockstep(self) -> bool:
        """Whether no step was taken before the program had come to rest."""
        return self._lock.works and self._lock.never_in_vain

    @property
    def outpaced(self) -> bool:
        """Whether simulated time proves nothing, because the program keeps it from passing much faster than real time.

        Lockstep waits for a callback that works or sleeps; a person who runs the program sees that it comes late. What
        counts is processor time and sleep, because a busy machine says nothing about the program. A flood of messages
        needs no long look: what else the program does, the wall clock shows sooner.
        """
        taken_s = self._used_s - self._used_before_s + self._lock.slept_s
        slow = taken_s > max(LEAST_TAKEN_S, self._clock.now / CLEARLY_FASTER)
        naps = self._lock.longest_nap_s > LONGEST_NAP_PERIODS * self._session.plan.shortest_period
        flooded = any(map(self._session.recorder.is_flooded, self._session.plan.paced))
        return slow or naps or flooded or time.monotonic() > self._until

    def close(self) -> None:
        """Close the files that tell of threads."""
        self._lock.close()

    def _run(self, simulated_s: float, pairs: int) -> None:
        begin = self._clock.now
        for number in range(pairs):
            if self.outpaced:
                return
            middle, end = (begin + simulated_s * (number + half) / pairs for half in (0.5, 1.0))
            earlier = len(self.phases)
            self._run_block(middle, fast=True)
            self._run_block(end, fast=False, earlier=earlier)
            self._run_block(end, fast=True)

    def _run_block(self, end: float, *, fast: bool, earlier: int = 0) -> None:
        """Drive the clock to `end`; if slowly, only until all is proved together with the phases since `earlier`."""
        while self._clock.now < end and self._session.process.is_running() and not self.outpaced:
            self._run_phase(end, fast=fast, earlier=earlier)
            if not fast and self._is_proved(self.phases[earlier:]):
                return

    def _run_phase(self, end: float, *, fast: bool, earlier: int) -> None:
        """Drive the clock at one pace to `end`, until all is proved, or until the program turns out not to rest."""
        session, clock, locked = self._session, self._clock, self._lock.works
        begin, began, steps, proved = clock.now, time.monotonic(), 0, False
        clock.run_at(self._speed(fast=fast, locked=locked))
        while (
            clock.now < end
            and session.process.is_running()
            and locked == self._lock.works
            and not (proved or self.outpaced)
        ):
            time.sleep(clock.until_due())
            self._wait(locked=locked)
            session.recorder.take()
            self._match_late_publishers()
            clock.advance()
            session.script_player.play(clock.now)
            steps += 1
            if not fast and steps % session.plan.steps_per_period == 0:
                proved = self._is_proved([*self.phases[earlier:], _phase(begin, clock.now, began)])
            if time.monotonic() > self._next_look:
                session.recorder.look()
                self._used_s = session.process.processor_seconds() or self._used_s
                self._next_look = time.monotonic() + LOOK_EVERY_S
        time.sleep(max(0.0 if locked else SETTLE_S, clock.until_due()))
        self._wait(locked=locked)
        session.recorder.take()
        if steps:
            self.phases.append(_phase(begin, clock.now, began))
        if steps and fast:
            spent = time.monotonic() - began
            self._slowest_step_s[locked] = max(self._slowest_step_s[locked], spent / steps)

    def _is_proved(self, phases: Sequence[Phase]) -> bool:
        """Whether these phases alone prove that every topic follows the clock."""
        recorder, plan = self._session.recorder, self._session.plan
        return bool(plan.paced) and all(
            follows(phases, recorder.times(name), plan.step_s) for name in plan.paced
        )

    def _match_late_publishers(self) -> None:
        """Let the clock stand still while a publisher that was made late is connected.

        What it publishes before that is lost, in real time as well; but simulated time must not make more of it.
        """
        recorder = self._session.recorder
        for topic, left in self._late_match_s.items():
            while left > 0.0 and recorder.has_unmatched_publisher(topic):
                began = time.monotonic()
                recorder.look()
                time.sleep(SETTLE_S)
                left -= time.monotonic() - began
                self._late_match_s[topic] = left

    def _wait(self, *, locked: bool) -> None:
        """Let what the last step set in motion come to an end, and arrive."""
        if locked:
            self._lock.wait()
        else:
            self._session.quiescence.wait()

    def _speed(self, *, fast: bool, locked: bool) -> float:
        """Robot seconds per real second at which the clock is driven; infinite: as fast as the program can follow.

        A slow block is slow beside the fast ones as they came out, which a busy machine makes slower than intended.
        """
        if fast:
            return math.inf if locked else SPEEDS[1]
        measured = self._slowest_step_s[locked]
        slow = self._session.plan.step_s / (SLOWER * measured) if measured else math.inf
        return slow if locked else min(SPEEDS[0], slow)


def _phase(begin: float, now: float, began: float) -> Phase:
    """Simulated time (s) from `begin` to `now`, driven since the moment `began`."""
    return Phase(round((now - begin) / (time.monotonic() - began), 3), begin, now)
