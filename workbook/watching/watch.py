"""Watches one program from its start to a recording, on simulated time or on the wall clock."""

import time
from collections.abc import Callable
from contextlib import closing
from dataclasses import replace

from workbook.programs.process import NodeProcess
from workbook.programs.spec import ProgramSpec
from workbook.recording.plan import Plan
from workbook.recording.recording import Clock, Phase, ProcessRecord, Recording
from workbook.watching.clock import SimulatedClock
from workbook.watching.parameter_services import USE_SIM_TIME
from workbook.watching.robot_time import RobotTime
from workbook.watching.session import Place, open_session
from workbook.watching.switching import ANSWERS_WITHIN_S, TimeSwitch
from workbook.watching.waiting import let_it_match_us, wait_for_first_sign, wait_for_matches
from workbook.watching.wall_time import left_to_watch, run_wall_time

GONE_S = 6.0
KEPT_LOOK_S = 0.25
"""How often (s) the watch asks whether a program has been kept alive for long enough. Its end is noticed right away."""
PATIENCE_S = 0.7
PATIENCE_WITH_THE_END_S = 4.0


class Watch:
    """One program under watch. `observe` makes the recording; the program then goes on until the watch is left.

    A program is started as its author starts it. With the "simulated" clock it is switched to simulated time once its
    nodes spin; where that cannot be done, it is watched on the wall clock from then on. `keep_watching` extends its
    life in real time after it was observed.
    """

    def __init__(
        self, place: Place, spec: ProgramSpec, plan: Plan, clock: Clock, process: NodeProcess | None = None
    ) -> None:
        self._session = open_session(place, spec, plan, process)
        self._plan = plan
        from_start = bool(spec.parameters.get(USE_SIM_TIME))
        self._switch = TimeSwitch(self._session, from_start=from_start) if clock == "simulated" else None
        self._process = self._session.process
        self._recorder = self._session.recorder
        self._phases: tuple[Phase, ...] = ()
        self._following: dict[str, bool] = {}
        self._in_lockstep = False
        self._simulated = False
        self._outpaced = False
        self._own_clock: tuple[str, ...] = ()
        self._judged_until: float | None = None
        self._real_since: float | None = None
        self._matched_wall: float | None = None

    def observe(self) -> Recording:
        """Watch the program as planned and return the recording. Does not end the program."""
        if wait_for_first_sign(self._session):
            until = time.monotonic() + ANSWERS_WITHIN_S
            wait_for_matches(self._session, None if self._switch is None else self._switch.services)
            self._matched_wall = time.monotonic()
            if self._switch is None or not self._switch.from_start:
                self._own_clock = self._recorder.nodes_on_clock()
            if self._switch is not None and not self._own_clock:
                self._simulated = self._switch.to_simulated_time(until)
            self._begin_watch()
            if self._session.clock is not None:
                self._run_robot_time(self._session.clock)
            else:
                run_wall_time(self._session, self._plan.wall_s)
                if self._process.is_running():
                    run_wall_time(self._session, left_to_watch(self._session))
        if not self._recorder.any_publisher() or not all(map(self._recorder.matched, self._plan.topics)):
            self._process.domains_used()
        return self.recording()

    def _run_robot_time(self, clock: SimulatedClock) -> None:
        with closing(RobotTime(self._session, clock)) as robot_time:
            self._judged_until = robot_time.run_as_planned()
            self._phases = tuple(robot_time.phases)
            self._in_lockstep = robot_time.in_lockstep
            robot_time.run_longer()
            self._outpaced = robot_time.outpaced
            self._following = {} if self._outpaced else robot_time.following()

    def _begin_watch(self) -> None:
        clock = self._session.clock
        if clock is not None or self._plan.script:
            let_it_match_us(self._session)
        if clock is not None and self._plan.script and not self._plan.paced:
            self._recorder.take()  # nothing may come before the script begins
        else:
            self._recorder.discard()
        if clock is not None:
            clock.publish()
        else:
            self._session.began = time.monotonic()
        self._recorder.start_windows(0.0)

    def keep_watching(self, wall_s_after_match: float, enough: Callable[[], bool] = lambda: False) -> bool:
        """Let the program live in real time until so many seconds after it was matched. Returns whether it did.

        Returns early when the program ends by itself, and False when `enough` says so, or when the program does not
        return to real time. What it publishes in real time is in `in_real_time`.
        """
        if self._switch is not None and self._simulated:
            if not self._switch.to_real_time():
                return False
            self._real_since = self._session.robot_time(time.monotonic())
        until = (self._matched_wall or time.monotonic()) + wall_s_after_match
        while (left := until - time.monotonic()) > 0 and self._process.is_running():
            if enough():
                return False
            self._process.wait(min(left, KEPT_LOOK_S))
        if self._process.is_running():
            self._recorder.look()
        self._recorder.take()
        return True

    @property
    def is_back(self) -> bool:
        """Whether what the program does now is recorded in real time, as after its return from simulated time."""
        return self._real_since is not None

    def with_its_life(self, recording: Recording) -> Recording:
        """The recording, with what came while the program was kept alive, as far as that can be judged.

        Nodes count at any time. Messages do where nothing but an answer to what was published is to be published.
        """
        recording = replace(recording, nodes=self._recorder.nodes())
        if not self._simulated or self._plan.paced or not self._plan.script:
            return recording
        return replace(recording, topics=self._recorder.topics(self._session.robot_time(time.monotonic())))

    def in_real_time(self, recording: Recording) -> Recording | None:
        """What the program has done since `is_back`, as a recording of its own; None if that is not so."""
        if self._real_since is None:
            return None
        end = self._session.robot_time(time.monotonic())
        return replace(
            self.recording(),
            clock="wall",
            phases=(),
            follows_clock=None,
            following={},
            in_lockstep=False,
            step_s=None,
            robot_s=round(end - self._real_since, 6),
            topics=self._recorder.topics(end, self._real_since),
            findings=recording.findings,
        )

    def begin_in_real_time(self) -> None:
        """Instead of `observe`: wait for the program's publishers, and record in real time from then on."""
        if wait_for_first_sign(self._session):
            wait_for_matches(self._session)
            self._matched_wall = time.monotonic()
            self._begin_watch()
            self._real_since = 0.0

    def process_record(self) -> ProcessRecord:
        """What the program's process did so far."""
        return self._process.record()

    def recording(self) -> Recording:
        """Everything seen up to now."""
        end = self._end()
        if self._process.is_running():
            self._recorder.look_at_services()
        delays = self._session.delays
        asked = self._switch is not None and self._matched_wall is not None
        follows = self._simulated and not self._outpaced if asked else None
        return Recording(
            clock="simulated" if self._simulated else "wall",
            domain_id=self._session.place.domain_id,
            phases=self._phases,
            robot_s=round(end, 6),
            wall_s=round(time.monotonic() - self._process.started_at, 4),
            topics=self._recorder.topics(end),
            nodes=self._recorder.nodes(),
            process=self._process.record(),
            follows_clock=follows,
            following=self._following,
            in_lockstep=self._in_lockstep,
            step_s=self._plan.step_s if self._simulated else None,
            said=self._session.speaker.said(),
            unsaid=self._session.speaker.unsaid(),
            calls=tuple(call for call in self._session.speaker.calls() if call.t <= end),
            services=self._recorder.services(),
            clients=self._recorder.clients(),
            held_up_s=round(delays.held_up, 4),
            stood_still_s=round(delays.longest_steal, 2),
            taken_s=round(delays.stolen, 2),
            in_line_s=round(delays.run_queue, 4),
            wanted=(*self._plan.topics, *self._plan.script.names),
            own_clock=self._own_clock,
            seed=self._plan.seed,
        )

    def _end(self) -> float:
        """Until when (s of robot time) what was seen is judged."""
        if self._matched_wall is None:
            return 0.0
        if self._judged_until is not None:
            return self._judged_until
        return self._session.robot_time(time.monotonic())

    def finish(
        self, recording: Recording, patience_s: float = PATIENCE_S, *, look_who_stays: bool = False
    ) -> Recording:
        """End the program with SIGINT and return `recording` with how it ended.

        After `patience_s` (s) it is killed. With `look_who_stays` the graph is watched afterwards: a program that ends
        well takes its nodes along.
        """
        self._end_process(patience_s)
        if not look_who_stays:
            return replace(recording, process=self._process.record())
        if self._session.context.ok():
            self._recorder.look_who_stays(GONE_S)
            nodes = self._recorder.nodes()
            if any(node.stayed for node in nodes):  # the next program must not meet what is left of this one
                self._session.close()
                self._session.place.move()
        else:
            nodes = tuple(replace(node, stayed=True) for node in recording.nodes)
        return replace(recording, process=self._process.record(), nodes=nodes)

    def _end_process(self, patience_s: float = PATIENCE_S) -> None:
        self._session.quiescence.close()
        was_killed = self._process.killed
        if self._switch is None or self._switch.is_real:
            self._process.stop(patience_s)
        else:
            # It is not switched back, which may crash it. If it waits for its next timer, it hears of Ctrl-C only then.
            if self._session.clock is not None:
                self._session.clock.run_at(1.0)
            self._process.stop(patience_s, self._switch.keep_time)
        if self._process.killed and not was_killed:
            self._session.close()
            self._session.place.move()

    def __enter__(self) -> "Watch":
        return self

    def __exit__(self, *_: object) -> None:
        self._end_process()
        if self._switch is not None and self._session.context.ok():
            self._switch.close()
        self._session.close()
