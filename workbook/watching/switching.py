"""Switch a running program to simulated time."""

import time

from workbook.watching.clock import SimulatedClock
from workbook.watching.parameter_services import ParameterServices
from workbook.watching.session import Session

ANSWERS_WITHIN_S = 5.0
"""How long (s) a node's parameter services may take to respond.

After that, we assume that the node isn't spinning and use the wall clock.
"""
FOLLOWS_WITHIN_S = 1.0
"""The longest wait (s) for the nodes' /clock subscriptions.

A node creates its subscription before it responds, but the graph shows the subscription later.
"""
START_NS = 1_000_000
"""The first clock time (ns) for a program that was started in simulated time. Its timers count from zero, so if the
clock began much later, all of them would be due right away."""
POLL_S = 0.001


class TimeSwitch:
    """Switches a session's program to simulated time.

    `services`: the parameter services of the program's nodes. `is_real`: whether the program is running in real time.
    `from_start`: whether the program was started in simulated time, as lessons start their own programs.
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
        """Set `use_sim_time` on every node in the graph. Return whether all of them follow /clock now.

        If a node refuses, or hasn't responded by the time `until` (`time.monotonic`, s), all nodes stay in real time or
        return to it.
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
        self._set(False, time.monotonic())  # a node that responds later is switched and then switched back
        self.is_real = True
        session.clock = None
        clock.close()
        return False

    def keep_time(self) -> bool:
        """Advance the clock if there is one and its next step is due. Return whether the program is running.

        Call this repeatedly after a switch, because the program may still follow the clock.
        """
        clock = self._session.clock
        if clock is not None and self._session.context.ok() and clock.until_due() == 0.0:
            clock.advance()
        return self._session.process.is_running()

    def close(self) -> None:
        """Destroy the parameter services' clients."""
        self.services.close()

    def _set(self, value: bool, until: float) -> bool:
        present = self._session.recorder.present()
        meanwhile = self._session.process.is_running if value else self.keep_time
        return self.services.set_sim_time(
            [name for name in self._nodes if name in present], value, until, meanwhile
        )

    def _is_followed(self, clock: SimulatedClock, nodes: int) -> bool:
        """Wait until /clock has `nodes` subscriptions. Return False if that takes too long or the program exits."""
        until = time.monotonic() + FOLLOWS_WITHIN_S
        while clock.followers() < nodes:
            if time.monotonic() > until or not self._session.process.is_running():
                return False
            time.sleep(POLL_S)
        return True
