"""Switches a running program to simulated time."""

import time

from workbook.watching.clock import SimulatedClock
from workbook.watching.parameter_services import ParameterServices
from workbook.watching.session import Session

ANSWERS_WITHIN_S = 5.0
"""A node that has not answered its parameter services for so long (s) does not spin: the wall clock judges it."""
FOLLOWS_WITHIN_S = 1.0
"""A node that has accepted the switch subscribes to /clock before it answers; the graph tells of it a moment later."""
START_NS = 1_000_000
"""Timers of a program that was started on simulated time count from zero. If the clock began late, all of them would be
due right away."""
POLL_S = 0.001


class TimeSwitch:
    """Switches the program of one session. `services`: the parameter services of its nodes.

    `is_real`: whether it is not on simulated time. One that was started there (`from_start`), as a lesson does with its
    own programs, is.
    """

    def __init__(self, session: Session, *, from_start: bool = False) -> None:
        self._session = session
        self._nodes: tuple[str, ...] = ()
        self.from_start = from_start
        self.is_real = not from_start
        self.services = ParameterServices(session.node)
        if from_start:
            session.clock = SimulatedClock(session.node, session.plan.step_s, START_NS)

    def to_simulated_time(self, until: float) -> bool:
        """Set `use_sim_time` on every node that is on the graph. Returns whether each of them follows /clock now.

        Where one of them refuses, or has not answered at the moment `until` (`time.monotonic`, s), all of them stay on
        real time or return to it.
        """
        session = self._session
        present = session.recorder.present()
        if not present:
            return False
        if session.clock is not None:
            return self._is_followed(session.clock, present.total())
        self._nodes = tuple(present)
        clock = session.clock = SimulatedClock(session.node, session.plan.step_s)
        self.is_real = False
        if self._set(True, until) and self._is_followed(clock, present.total()):
            return True
        self._set(False, time.monotonic())  # one that answers later is switched and switched back then
        self.is_real = True
        session.clock = None
        clock.close()
        return False

    def keep_time(self) -> bool:
        """Let a clock that the program may still follow go on with real time. Returns whether the program runs."""
        clock = self._session.clock
        if clock is not None and self._session.context.ok() and clock.until_due() == 0.0:
            clock.advance()
        return self._session.process.is_running()

    def close(self) -> None:
        """Destroy the clients of parameter services."""
        self.services.close()

    def _set(self, value: bool, until: float) -> bool:
        present = self._session.recorder.present()
        meanwhile = self._session.process.is_running if value else self.keep_time
        return self.services.set_sim_time(
            [name for name in self._nodes if name in present], value, until, meanwhile
        )

    def _is_followed(self, clock: SimulatedClock, nodes: int) -> bool:
        """Wait until each node is seen to subscribe to /clock; one process may be there long before another."""
        until = time.monotonic() + FOLLOWS_WITHIN_S
        while clock.followers() < nodes:
            if time.monotonic() > until or not self._session.process.is_running():
                return False
            time.sleep(POLL_S)
        return True
