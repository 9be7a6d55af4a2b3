"""Advance simulated time: in lockstep with a program that comes to rest after each step, or else at a fixed speed.

Fast and slow blocks alternate, so that we can detect a program that runs on the wall clock, even if it stops early (see
`following`). Once a slow block has proved that every topic follows the clock, the rest of that block is fast.
"""

import math
import time
from collections.abc import Sequence

from workbook.recording.plan import PERIODS_PER_BLOCK, SPEEDS
from workbook.recording.recording import Stretch
from workbook.watching.clock import SimulatedClock
from workbook.watching.following import follows
from workbook.watching.session import Session

LOOK_EVERY_S = 0.1
SLOWER = 2.2
"""The factor by which a slow block's step takes longer than the slowest step of the fast blocks so far.

It exceeds the required 2, because the next fast block may be a little slower.
"""
SETTLE_S = 0.005
LATE_MATCH_S = 0.3
"""The longest total pause (s) of the clock for a topic's late publishers.

Because of this limit, a publisher that can't be connected doesn't delay the clock again and again.
"""
MOST_REAL_S = 40.0
"""The most real time (s) that a watch in simulated time may take. After that, the wall clock judges the program."""
CLEARLY_FASTER = 2.0
"""If CPU time and sleep together exceed simulated time divided by this, the program may be too slow in real time."""
LEAST_TAKEN_S = 0.5
"""`CLEARLY_FASTER` is applied only once a program has worked and slept for this long (s)."""
LONGEST_NAP_PERIODS = 0.5
"""The longest acceptable sleep of a callback, as a fraction of the shortest judged period.

Lockstep waits for a sleeping callback, but real time doesn't.
"""
MOST_EXTRA_S = 60.0
"""The most simulated time (s) added for topics with too few messages to tell whether they follow the clock."""


class SimulatedRun:
    """Advances one watch's clock. `stretches`: the stretches of simulated time so far, with their measured speeds."""

    def __init__(self, session: Session, clock: SimulatedClock) -> None:
        self._session = session
        self._clock = clock
        self._rest = session.rest
        self._slowest_step_s = {True: 0.0, False: 0.0}
        self._next_look = 0.0
        self._late_match_s = dict.fromkeys(session.plan.topics, LATE_MATCH_S)
        self._until = time.monotonic() + MOST_REAL_S
        self._used_before_s = self._used_s = session.process.processor_seconds() or 0.0
        self.stretches: list[Stretch] = []

    def run_as_planned(self) -> float:
        """Advance the clock until the planned time has passed or the program exits. Return the simulated time (s)."""
        plan = self._session.plan
        pairs = max(1, math.floor(plan.simulated_s / (2 * PERIODS_PER_BLOCK * plan.longest_period)))
        self._run(plan.simulated_s, pairs)
        return self._clock.now

    def run_longer(self) -> None:
        """Advance the clock further if that may show whether a topic follows it.

        Messages that arrive in this extra time aren't judged.
        """
        unsure = [times for name in self._session.plan.paced if (times := self._unsure(name))]
        if unsure and self._rest.works and self._session.process.is_running() and not self.outpaced:
            interval = max(self._clock.now / len(times) for times in unsure)
            self._run(min(MOST_EXTRA_S, 2 * PERIODS_PER_BLOCK * interval), 1)

    def _unsure(self, topic: str) -> list[float]:
        """Return a topic's arrival times (simulated time, s), or [] if they prove whether it follows the clock."""
        times = self._session.recorder.times(topic)
        return times if follows(self.stretches, times, self._session.plan.step_s) is None else []

    def following(self) -> dict[str, bool]:
        """Return, by topic, whether it follows the clock. Topics for which neither is proved are left out."""
        found = {}
        for name in self._session.plan.paced:
            proved = follows(self.stretches, self._session.recorder.times(name), self._session.plan.step_s)
            if proved is not None:
                found[name] = proved
        return found

    @property
    def in_lockstep(self) -> bool:
        """Whether the program had come to rest before each step."""
        return self._rest.works and self._rest.never_in_vain

    @property
    def outpaced(self) -> bool:
        """Whether the program must be judged on the wall clock, because it slows down simulated time too much.

        Lockstep waits for callbacks that work or sleep, but in real time, such callbacks make the program late. We
        count CPU time and sleep, but not other delays, because a busy machine isn't the program's fault. A program that
        floods a topic is also judged on the wall clock, which shows sooner what else the program does.
        """
        taken_s = self._used_s - self._used_before_s + self._rest.slept_s
        slow = taken_s > max(LEAST_TAKEN_S, self._clock.now / CLEARLY_FASTER)
        naps = self._rest.longest_nap_s > LONGEST_NAP_PERIODS * self._session.plan.shortest_period
        flooded = any(map(self._session.recorder.is_flooded, self._session.plan.paced))
        return slow or naps or flooded or time.monotonic() > self._until

    def _run(self, simulated_s: float, pairs: int) -> None:
        begin = self._clock.now
        for number in range(pairs):
            if self.outpaced:
                return
            middle, end = (begin + simulated_s * (number + half) / pairs for half in (0.5, 1.0))
            earlier = len(self.stretches)
            self._run_block(middle, fast=True)
            self._run_block(end, fast=False, earlier=earlier)
            self._run_block(end, fast=True)

    def _run_block(self, end: float, *, fast: bool, earlier: int = 0) -> None:
        """Advance the clock to `end`.

        A slow block ends once the stretches from index `earlier` on prove that topics follow.
        """
        while self._clock.now < end and self._session.process.is_running() and not self.outpaced:
            self._run_phase(end, fast=fast, earlier=earlier)
            if not fast and self._is_proved(self.stretches[earlier:]):
                return

    def _run_phase(self, end: float, *, fast: bool, earlier: int) -> None:
        """Advance the clock at one speed until `end`.

        Return earlier if everything is proved (see `_is_proved`), if the program exits or is `outpaced`, or if
        `RestDetector.works` changes.
        """
        session, clock, locked = self._session, self._clock, self._rest.works
        begin, began, steps, proved = clock.now, time.monotonic(), 0, False
        clock.run_at(self._speed(fast=fast, locked=locked))
        while (
            clock.now < end
            and session.process.is_running()
            and locked == self._rest.works
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
                proved = self._is_proved([*self.stretches[earlier:], _stretch(begin, clock.now, began)])
            if time.monotonic() > self._next_look:
                session.recorder.look()
                self._used_s = session.process.processor_seconds() or self._used_s
                self._next_look = time.monotonic() + LOOK_EVERY_S
        time.sleep(max(0.0 if locked else SETTLE_S, clock.until_due()))
        self._wait(locked=locked)
        session.recorder.take()
        if steps:
            self.stretches.append(_stretch(begin, clock.now, began))
        if steps and fast:
            spent = time.monotonic() - began
            self._slowest_step_s[locked] = max(self._slowest_step_s[locked], spent / steps)

    def _is_proved(self, stretches: Sequence[Stretch]) -> bool:
        """Return whether these stretches alone prove that every topic follows the clock."""
        recorder, plan = self._session.recorder, self._session.plan
        return bool(plan.paced) and all(
            follows(stretches, recorder.times(name), plan.step_s) for name in plan.paced
        )

    def _match_late_publishers(self) -> None:
        """Pause the clock until late publishers are connected, but at most `LATE_MATCH_S` per topic.

        Messages published before the connection are lost. That also happens in real time, but simulated time is faster,
        so without a pause, more messages would be lost.
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
        """Wait until the program has handled the last step and its messages have arrived."""
        if locked:
            self._rest.wait_for_rest()
        else:
            self._rest.wait_until_quiet()

    def _speed(self, *, fast: bool, locked: bool) -> float:
        """Return the speed at which to advance the clock, in simulated seconds per real second.

        Infinite means as fast as the program can follow. A slow block's speed depends on the measured speed of the fast
        blocks, which are slower than intended on a busy machine.
        """
        if fast:
            return math.inf if locked else SPEEDS[1]
        measured = self._slowest_step_s[locked]
        slow = self._session.plan.step_s / (SLOWER * measured) if measured else math.inf
        return slow if locked else min(SPEEDS[0], slow)


def _stretch(begin: float, now: float, began: float) -> Stretch:
    """Return the stretch from `begin` to `now` (simulated time, s), which began at the real time `began`."""
    return Stretch(round((now - begin) / (time.monotonic() - began), 3), begin, now)
