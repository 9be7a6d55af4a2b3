"""Watching one program from its start to a recording, on robot time or on the wall clock."""

import time
from collections.abc import Callable
from contextlib import closing
from dataclasses import replace

from workbook.programs.process import NodeProcess
from workbook.programs.spec import ProgramSpec
from workbook.recording.plan import Plan
from workbook.recording.recording import Clock, Phase, ProcessRecord, Recording
from workbook.watching.clock import SimulatedClock
from workbook.watching.robot_time import RobotTime
from workbook.watching.session import Place, open_session
from workbook.watching.waiting import let_it_match_us, wait_for_first_sign, wait_for_matches
from workbook.watching.wall_time import left_to_watch, run_wall_time

GONE_S = 6.0
UNMEASURED_STRIDE = 10
"""Steps of robot time at once while a program is only kept alive: mostly the shortest judged period."""
KEPT_LOOK_S = 0.25
"""How often it is asked meanwhile whether that is enough (s). Its end is noticed at once."""
PATIENCE_S = 0.7
PATIENCE_WITH_THE_END_S = 4.0


class Watch:
    """One program under watch. `observe` makes the recording; the program then goes on until the watch is left.

    `keep_watching` extends the life of a program on the wall clock after it was observed.
    """

    def __init__(
        self, place: Place, spec: ProgramSpec, plan: Plan, clock: Clock, process: NodeProcess | None = None
    ) -> None:
        self._session = open_session(place, spec, plan, clock, process)
        self._plan = plan
        self._clock_kind: Clock = clock
        self._clock = self._session.clock
        self._process = self._session.process
        self._recorder = self._session.recorder
        self._phases: tuple[Phase, ...] = ()
        self._following: dict[str, bool] = {}
        self._in_lockstep = False
        self._judged_until: float | None = None
        self._follows: bool | None = None
        self._matched_wall: float | None = None

    def observe(self) -> Recording:
        """Watch the program as planned and return the recording. Does not end the program."""
        if wait_for_first_sign(self._session):
            ready = wait_for_matches(self._session)
            self._matched_wall = time.monotonic()
            if self._clock is not None:
                self._follows = ready and self._clock.followers() > 0
            if self._clock is None or self._follows:
                self._begin_watch()
                if self._clock is not None:
                    self._run_robot_time(self._clock)
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
            self._following = robot_time.following()

    def _begin_watch(self) -> None:
        if self._clock is not None or self._plan.script:
            let_it_match_us(self._session)
        self._recorder.discard()
        if self._clock is not None:
            self._clock.publish()
        else:
            self._session.began = time.monotonic()
        self._recorder.start_windows(0.0)

    def keep_watching(
        self, wall_s_after_match: float, enough: Callable[[], bool] = lambda: False, *, speed: float = 1.0
    ) -> bool:
        """Let the program live until so many real seconds after it was matched, a simulated clock running at `speed`.

        The clock moves by about the shortest judged period at once: nobody measures the program now; but what it has
        made and said meanwhile is noted at the end, see `with_its_life`. Returns early when it ends by itself, or when
        `enough` says so. Returns whether it was watched to the end.
        """
        until = (self._matched_wall or time.monotonic()) + wall_s_after_match
        if self._clock is not None:
            self._clock.run_at(speed, UNMEASURED_STRIDE)
        while (left := until - time.monotonic()) > 0 and self._process.is_running():
            if enough():
                return False
            due = KEPT_LOOK_S if self._clock is None else self._clock.until_due()
            self._process.wait(min(left, due, KEPT_LOOK_S))
            if self._clock is not None and self._clock.until_due() == 0.0:
                self._clock.advance()
        if self._process.is_running():
            self._recorder.look_at_nodes()
            self._recorder.take()
        return True

    def with_its_life(self, recording: Recording) -> Recording:
        """The recording, with what came while the program was kept alive, as far as that can be judged.

        Nodes count at any time. Messages do where nothing but an answer to what was said is to be published: nothing
        was said to it any more, and a pace would not be that of its robot time.
        """
        recording = replace(recording, nodes=self._recorder.nodes())
        if self._clock is None or self._plan.paced or not self._plan.script:
            return recording
        return replace(recording, topics=self._recorder.topics(self._clock.now))

    def wait_until_seen(self) -> None:
        """Wait for the program's first publisher, without recording anything."""
        if wait_for_first_sign(self._session):
            self._matched_wall = time.monotonic()

    def process_record(self) -> ProcessRecord:
        """What the program's process did so far."""
        return self._process.record()

    def recording(self) -> Recording:
        """Everything seen up to now."""
        end = self._end()
        if self._process.is_running():
            self._recorder.look_at_services()
        delays = self._session.delays
        return Recording(
            clock=self._clock_kind,
            domain_id=self._session.place.domain_id,
            phases=self._phases,
            robot_s=round(end, 6),
            wall_s=round(time.monotonic() - self._process.started_at, 4),
            topics=self._recorder.topics(end),
            nodes=self._recorder.nodes(),
            process=self._process.record(),
            follows_clock=self._follows,
            following=self._following,
            in_lockstep=self._in_lockstep,
            step_s=self._plan.step_s if self._clock is not None else None,
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
            seed=self._plan.seed,
        )

    def _end(self) -> float:
        """Until when (s of robot time) what was seen is judged."""
        if self._matched_wall is None:
            return 0.0
        if self._judged_until is not None:
            return self._judged_until
        return self._clock.now if self._clock is not None else self._session.robot_time(time.monotonic())

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
        if self._clock is not None:
            self._clock.run_at(1.0)
        self._process.stop(patience_s, self._keep_time)
        if self._process.killed and not was_killed:
            self._session.close()
            self._session.place.move()

    def _keep_time(self) -> None:
        """Let robot time go on while the program ends: one that waits for its next timer hears of Ctrl-C only then."""
        if self._clock is not None and self._session.context.ok() and self._clock.until_due() == 0.0:
            self._clock.advance()

    def __enter__(self) -> "Watch":
        return self

    def __exit__(self, *_: object) -> None:
        self._end_process()
        self._session.close()
