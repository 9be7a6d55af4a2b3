"""Watching one program from its start to a verdict-ready recording, on robot time or on the wall clock."""

import math
import secrets
import statistics
import time
from collections.abc import Callable, Container, Mapping, Sequence
from dataclasses import dataclass, replace
from pathlib import Path

import rclpy
from rclpy.context import Context
from rclpy.node import Node

from workbook.observing.clock import SimulatedClock
from workbook.observing.confinement import Confinement
from workbook.observing.process import NodeProcess, ros_arguments
from workbook.observing.recorder import Recorder
from workbook.observing.recording import Clock, Phase, ProcessRecord, Recording
from workbook.observing.rest import Rest
from workbook.observing.sandbox import Cage
from workbook.observing.script import NOTHING_SAID, Script
from workbook.observing.speaker import Speaker
from workbook.observing.standstill import Standstill
from workbook.observing.tree import seconds_in_line
from workbook.ros.domains import DomainLease, NoDomainFree, lease_domain
from workbook.ros.environment import is_prepared, prepare

SPEEDS = (10.0, 20.0)
PERIODS_PER_SPEED = 3.5
WALL_PERIODS = 4.0
WALL_EXTRA_S = 0.5
LEAST_WALL_WATCH_S = 4.0
FIRST_SIGN_S = 12.0
STARVED_LONGEST_S = 30.0
STARVED_PROCESSOR_S = 2.0
ELSEWHERE_S = 2.0
SETTLE_S = 0.6
MATCH_S = 3.0
NO_PUBLISHER_S = 8.0
FOLLOW_S = 1.0
POLL_S = 0.01
TAKE_EVERY_S = 0.05
GONE_S = 6.0
GHOST_S = 20
HELD_STEPS = 5
LOOK_EVERY_S = 0.1
NOTE_EVERY_S = 0.2
UNMEASURED_STRIDE = 5
"""Steps of robot time at once while a program is only kept alive: half the shortest judged period."""
PATIENCE_S = 0.7
PATIENCE_WITH_THE_END_S = 4.0


@dataclass(frozen=True)
class Plan:
    """What is to be judged, so that the watch knows how finely and how long to look.

    `topics`: judged topic names. `shortest_period` and `longest_period`: of the judged rates, in seconds.
    `robot_seconds`: robot time to watch at each speed; None: three and a half of the longest period.
    `wall_seconds`: real time to watch on the wall clock; None: a little more than four of the longest period.
    `script`: what the bench says meanwhile. A program that only listens is then seen by its node.
    `to_the_end`: it is watched whether nodes stay on the graph. One that vanishes without a good-bye is then remembered
    for much longer than a good-bye takes on the busiest machine.
    """

    topics: tuple[str, ...]
    shortest_period: float
    longest_period: float
    robot_seconds: float | None = None
    wall_seconds: float | None = None
    script: Script = NOTHING_SAID
    to_the_end: bool = False

    @property
    def node_suffices(self) -> bool:
        """Whether a node alone is a sign of life: where nothing has to be published before something was said."""
        return bool(self.script) or not self.topics

    @property
    def step_s(self) -> float:
        """Step of robot time: a tenth of the shortest judged period."""
        return self.shortest_period / 10.0

    @property
    def robot_s_per_speed(self) -> float:
        return self.robot_seconds or PERIODS_PER_SPEED * self.longest_period

    @property
    def wall_s(self) -> float:
        return self.wall_seconds or max(LEAST_WALL_WATCH_S, WALL_PERIODS * self.longest_period + WALL_EXTRA_S)


class Observer:
    """Stands on one leased domain and watches programs, one after another. With a `cage` or a `confinement` they are
    shut in.

    Keep one per slot: a warm observer saves the start of a context. After a program had to be killed it moves to
    another domain, because the ghost of the dead would stay on the graph for a while.
    """

    def __init__(
        self,
        lease: DomainLease | None = None,
        cage: Cage | None = None,
        confinement: Confinement | None = None,
    ) -> None:
        self.cage = cage
        self.confinement = confinement
        self._lease: DomainLease | None = None
        self._stand(lease)

    def _stand(self, lease: DomainLease | None = None) -> None:
        self._lease = lease or lease_domain()
        if not is_prepared():
            prepare(domain_id=self._lease.domain_id)

    @property
    def domain_id(self) -> int:
        assert self._lease is not None, "this observer is closed"
        return self._lease.domain_id

    def close(self) -> None:
        if self._lease is not None:
            self._lease.release()
            self._lease = None

    def move(self) -> None:
        """Leave this domain to rest and lease another one."""
        if self._lease is not None:
            self._lease.release(killed=True)
        self._stand()

    def keep_off(self, domains: Container[int]) -> None:
        """Move to another domain, if there is a free one, when this is one of `domains`."""
        if self.domain_id in domains:
            try:
                lease = lease_domain(avoid=domains)
            except NoDomainFree:
                return
            self.close()
            self._stand(lease)

    def __enter__(self) -> "Observer":
        return self

    def __exit__(self, *_: object) -> None:
        self.close()

    def watch(
        self,
        program: Path,
        plan: Plan,
        clock: Clock,
        *,
        parameters: Mapping[str, object] | None = None,
        check_fields: bool = False,
        limits: dict[str, int] | None = None,
        process: NodeProcess | None = None,
        driver: Path | None = None,
    ) -> "Watch":
        """Start `program` and return the running watch; use it as a context manager.

        `parameters`: ROS parameters for its nodes, by name. `process`: the program, if it runs on this domain already.
        `driver`: a program that imports `program` as the module `answer` and is run in its place.
        """
        return Watch(
            self,
            program,
            plan,
            clock,
            parameters=parameters or {},
            check_fields=check_fields,
            limits=limits,
            process=process,
            driver=driver,
        )


class Watch:
    """One program under watch. `observe` makes the recording; the program then goes on until the watch is left.

    `keep_watching` extends the life of a program on the wall clock after it was observed.
    """

    def __init__(
        self,
        observer: Observer,
        program: Path,
        plan: Plan,
        clock: Clock,
        *,
        parameters: Mapping[str, object],
        check_fields: bool,
        limits: dict[str, int] | None,
        process: NodeProcess | None,
        driver: Path | None,
    ) -> None:
        self._observer = observer
        self._plan = plan
        self._clock_kind: Clock = clock
        self._context = Context()
        rclpy.init(
            context=self._context,
            args=["--ros-args", "--disable-external-lib-logs"],
            domain_id=observer.domain_id,
            signal_handler_options=rclpy.signals.SignalHandlerOptions.NO,
        )
        self._node = Node(
            f"bench_{secrets.token_hex(4)}",
            context=self._context,
            enable_rosout=False,
            start_parameter_services=False,
            use_global_arguments=False,
        )
        self._clock = SimulatedClock(self._node, plan.step_s) if clock == "simulated" else None
        sim_time = {"use_sim_time": True} if clock == "simulated" else {}
        arguments = ros_arguments({**sim_time, **parameters})
        self._began = time.monotonic()
        self._speaker = Speaker(self._node, plan.script, self._robot_time)
        try:
            self._process = process or NodeProcess(
                program,
                observer.domain_id,
                arguments,
                check_fields=check_fields,
                limits=limits,
                driver=driver,
                lease_s=GHOST_S if plan.to_the_end else None,
                cage=observer.cage,
                confinement=observer.confinement,
            )
        except OSError:
            self._shut()
            raise
        self._rest = Rest(self._process.pid)
        self._began = self._speaker.started_at = self._process.started_at
        self._recorder = Recorder(self._node, self._process.started_at, self._robot_time, judged=plan.topics)
        self._notes: list[str] = []
        self._phases: list[Phase] = []
        self._follows: bool | None = None
        self._matched_wall: float | None = None
        self._held_up_s = 0.0
        self._stood_still_s = 0.0
        self._taken_s = 0.0
        self._in_line_s = 0.0

    def _robot_time(self, moment: float) -> float:
        if self._clock is not None:
            return self._clock.robot_time(moment)
        return moment - self._began

    # --- the parts of a watch -------------------------------------------------------------------------------

    def _wait_for_first_sign(self) -> bool:
        """Wait until a publisher of the program is on the graph. Returns False if it never came."""
        deadline = time.monotonic() + FIRST_SIGN_S
        look_elsewhere = time.monotonic() + ELSEWHERE_S
        node_since: float | None = None
        while time.monotonic() < deadline or self._is_starved(deadline):
            if time.monotonic() > look_elsewhere:
                used = self._process.domains_used()
                if used and self._observer.domain_id not in used:
                    return False
                look_elsewhere += 1.0
            if self._recorder.look() and node_since is None and self._recorder.nodes():
                node_since = time.monotonic()
            if self._recorder.any_publisher() or (self._plan.node_suffices and self._recorder.nodes()):
                return True
            if not self._process.is_running():
                return False
            if node_since is not None and time.monotonic() - node_since > NO_PUBLISHER_S:
                return False
            self._pause(POLL_S)
        return False

    def _is_starved(self, deadline: float) -> bool:
        """Whether a program that has not come up by `deadline` has hardly had a processor, and wants one now."""
        if time.monotonic() > deadline + STARVED_LONGEST_S or self._rest.now():
            return False
        used = self._process.processor_seconds()
        return used is not None and used < STARVED_PROCESSOR_S

    def _wait_for_matches(self) -> None:
        """Wait until every judged topic is matched and a node has a name, or nothing new has come for a while.

        The names of nodes travel apart from their publishers, and on a busy machine come much later.
        """
        looked = time.monotonic()
        deadline = looked + MATCH_S
        quiet_s = (
            0.0  # a program that stands in line for a core is not quiet, nor are we while we stand in line
        )
        while (now := time.monotonic()) < deadline:
            if self._recorder.look():
                quiet_s = 0.0
            elif self._rest.now():
                quiet_s += min(now - looked, POLL_S)
            looked = now
            following = self._clock is None or self._clock.followers() > 0
            matched = self._plan.topics and all(map(self._recorder.matched, self._plan.topics))
            if following and matched and self._speaker.ready() and self._recorder.nodes():
                return
            if (
                quiet_s > (SETTLE_S if following else max(SETTLE_S, FOLLOW_S))
                or not self._process.is_running()
            ):
                return
            self._pause(POLL_S / 2)

    @staticmethod
    def _pause(seconds: float) -> None:
        time.sleep(seconds)

    def _run_robot_time(self) -> None:
        assert self._clock is not None
        for speed in SPEEDS:
            begin = self._clock.now
            end = begin + self._plan.robot_s_per_speed
            self._clock.run_at(speed)
            next_look = 0.0
            while self._clock.now < end and self._process.is_running():
                self._pause(self._clock.until_due())
                self._rest.wait()
                self._recorder.take()
                self._clock.advance()
                self._speaker.play(self._clock.now)
                if time.monotonic() > next_look:
                    self._recorder.look()
                    next_look = time.monotonic() + LOOK_EVERY_S
            self._settle_last_step()
            self._phases.append(Phase(speed, begin, self._clock.now))

    def _settle_last_step(self) -> None:
        """Let what the last step set in motion arrive before the phase is closed."""
        assert self._clock is not None
        self._pause(max(0.005, self._clock.until_due()))
        self._rest.wait()
        self._recorder.take()

    def _run_wall_time(self, seconds: float) -> None:
        end = time.monotonic() + seconds
        next_take = next_look = next_note = 0.0
        before = in_line = seconds_in_line(self._process.pid)
        standstill = Standstill()
        running = True
        while running and (left := end - time.monotonic()) > 0:
            paused = time.monotonic()
            turn = min(TAKE_EVERY_S, left, self._speaker.until_next(self._robot_time(paused)))
            self._pause(turn)
            self._held_up_s = max(self._held_up_s, time.monotonic() - paused - turn)
            self._speaker.play(self._robot_time(time.monotonic()), keep_pauses=True)
            if time.monotonic() > next_take:
                self._recorder.take()
                running = self._process.is_running()
                next_take = time.monotonic() + TAKE_EVERY_S
            if time.monotonic() > next_note:
                self._process.note_processor_time()
                next_note = time.monotonic() + NOTE_EVERY_S
            if time.monotonic() > next_look:
                self._recorder.look()
                in_line = max(in_line, seconds_in_line(self._process.pid))
                self._stood_still_s = max(self._stood_still_s, standstill.look())
                next_look = time.monotonic() + LOOK_EVERY_S
        self._in_line_s += in_line - before
        self._taken_s += standstill.in_all()
        self._recorder.take()

    def _left_to_watch(self) -> float:
        """On the wall clock: real seconds until also the topic that was matched last has had its full watch.

        What is said late because we were held up takes as much longer.
        """
        now = self._robot_time(time.monotonic())
        topics = self._recorder.topics(now)
        begins = [topics[name].window for name in self._plan.topics if name in topics]
        latest = max((window[0] for window in begins if window is not None), default=0.0)
        return max(latest, self._speaker.late_s) + self._plan.wall_s - now

    def observe(self) -> Recording:
        """Watch the program as planned and return the recording. Does not end the program."""
        if self._wait_for_first_sign():
            self._wait_for_matches()
            self._matched_wall = time.monotonic()
            if self._clock is not None:
                self._follows = self._clock.followers() > 0
            if self._clock is None or self._follows:
                self._begin_watch()
                if self._clock is not None:
                    self._run_robot_time()
                else:
                    self._run_wall_time(self._plan.wall_s)
                    if self._process.is_running():
                        self._run_wall_time(self._left_to_watch())
        if not self._recorder.any_publisher() or not all(map(self._recorder.matched, self._plan.topics)):
            self._process.domains_used()
        return self.recording()

    def _begin_watch(self) -> None:
        if self._clock is not None or self._plan.script:
            self._let_it_meet_us()
        self._recorder.discard()
        if self._clock is not None:
            self._clock.publish()
        else:
            self._began = time.monotonic()
        self._recorder.start_windows(0.0)

    def _let_it_meet_us(self) -> None:
        """Let the program do what our arrival gives it to do, and show it the start of robot time meanwhile.

        That we are matched with it does not mean that it is matched with us: what we publish now may pass it by, and
        what it publishes in return may pass us by.
        """
        for _ in range(HELD_STEPS):
            if self._clock is not None:
                self._clock.publish()
            self._pause(POLL_S)
            self._rest.wait()

    def keep_watching(
        self, wall_s_after_match: float, enough: Callable[[], bool] = lambda: False, *, speed: float = 1.0
    ) -> bool:
        """Let the program live until so many real seconds after it was matched, a simulated clock running at `speed`.

        The clock moves by half the shortest judged period at once: nobody measures the program now. Returns early when
        it ends by itself, or when `enough` says so. Returns whether it was watched to the end.
        """
        until = (self._matched_wall or time.monotonic()) + wall_s_after_match
        if self._clock is not None:
            self._clock.run_at(speed, UNMEASURED_STRIDE)
        while (left := until - time.monotonic()) > 0 and self._process.is_running():
            if enough():
                return False
            due = LOOK_EVERY_S if self._clock is None else self._clock.until_due()
            self._process.wait(min(left, due, LOOK_EVERY_S))
            if self._clock is not None and self._clock.until_due() == 0.0:
                self._clock.advance()
        return True

    def wait_until_seen(self) -> None:
        """Wait for the program's first publisher, without recording anything."""
        if self._wait_for_first_sign():
            self._matched_wall = time.monotonic()

    def process_record(self) -> ProcessRecord:
        return self._process.record()

    def recording(self) -> Recording:
        """Everything seen up to now."""
        end = self._clock.now if self._clock is not None else self._robot_time(time.monotonic())
        if self._matched_wall is None:
            end = 0.0
        if self._process.is_running():
            self._recorder.look_at_services()
        return Recording(
            clock=self._clock_kind,
            domain_id=self._observer.domain_id,
            phases=tuple(self._phases),
            robot_s=round(end, 6),
            wall_s=round(time.monotonic() - self._process.started_at, 4),
            topics=self._recorder.topics(end),
            nodes=self._recorder.nodes(),
            process=self._process.record(),
            follows_clock=self._follows,
            step_s=self._plan.step_s if self._clock is not None else None,
            notes=tuple(self._notes),
            said=self._speaker.said(),
            calls=self._speaker.calls(),
            services=self._recorder.services(),
            clients=self._recorder.clients(),
            held_up_s=round(self._held_up_s, 4),
            stood_still_s=round(self._stood_still_s, 2),
            taken_s=round(self._taken_s, 2),
            in_line_s=round(self._in_line_s, 4),
            wanted=(*self._plan.topics, *self._plan.script.names),
        )

    def finish(
        self, recording: Recording, patience_s: float = PATIENCE_S, *, look_who_stays: bool = False
    ) -> Recording:
        """End the program with SIGINT and return `recording` with how it ended; after `patience_s` it is killed.

        With `look_who_stays` the graph is watched afterwards: a program that ends well takes its nodes along.
        """
        self._end_process(patience_s)
        if not look_who_stays:
            return replace(recording, process=self._process.record())
        if self._context.ok():
            self._recorder.look_who_stays(GONE_S)
            nodes = self._recorder.nodes()
            if any(node.stayed for node in nodes):  # the next program must not meet the ghosts of this one
                self._shut()
                self._observer.move()
        else:
            nodes = tuple(replace(node, stayed=True) for node in recording.nodes)
        return replace(recording, process=self._process.record(), nodes=nodes)

    def _end_process(self, patience_s: float = PATIENCE_S) -> None:
        self._rest.close()
        was_killed = self._process.killed
        if self._clock is not None:
            self._clock.run_at(1.0)
        self._process.stop(patience_s, self._keep_time)
        if self._process.killed and not was_killed:
            self._shut()
            self._observer.move()

    def _keep_time(self) -> None:
        """Let robot time go on while the program ends: one that waits for its next timer hears of Ctrl-C only then."""
        if self._clock is not None and self._context.ok() and self._clock.until_due() == 0.0:
            self._clock.advance()

    def _shut(self) -> None:
        if self._context.ok():
            self._node.destroy_node()
            rclpy.shutdown(context=self._context)

    def __enter__(self) -> "Watch":
        return self

    def __exit__(self, *_: object) -> None:
        self._end_process()
        self._shut()


def speeds_agree(recording: Recording, topics: Sequence[str]) -> bool:
    """Whether a judged topic behaved alike at both speeds: counts within one, median intervals within a tenth.

    A program on its own clock shows other intervals in robot time when robot time runs faster.
    """
    if len(recording.phases) != len(SPEEDS):
        return False
    for name in topics:
        counts: list[int] = []
        medians: list[float] = []
        for phase in recording.phases:
            times = [
                arrival.t
                for arrival in recording.topic(name).arrivals
                if phase.start < arrival.t <= phase.end
            ]
            counts.append(len(times))
            if len(times) >= 3:
                medians.append(statistics.median(b - a for a, b in zip(times, times[1:], strict=False)))
        if max(counts) - min(counts) > 1:
            return False
        step = recording.step_s or 0.0
        if len(medians) == 2 and not math.isclose(medians[0], medians[1], rel_tol=0.1, abs_tol=1.5 * step):
            return False
    return True
