"""Watch a program from its start to a recording, in simulated time or on the wall clock."""

import time
from collections.abc import Callable
from dataclasses import replace

from workbook.programs.process import NodeProcess
from workbook.programs.spec import ProgramSpec
from workbook.recording.plan import Plan
from workbook.recording.recording import Clock, Recording, Stretch
from workbook.watching.clock import SimulatedClock
from workbook.watching.observer import Observer
from workbook.watching.parameter_services import USE_SIM_TIME
from workbook.watching.session import open_session
from workbook.watching.simulated_time import SimulatedRun
from workbook.watching.switching import ANSWERS_WITHIN_S, TimeSwitch
from workbook.watching.waiting import let_it_match_us, wait_for_first_sign, wait_for_matches
from workbook.watching.wall_time import is_lost, left_to_watch, run_wall_time

GONE_S = 6.0
KEPT_LOOK_S = 0.25
"""How often (s) `keep_watching` checks for cancellation. It returns right away when the program exits."""
MOST_DELAYED_S = 60.0
"""The most time (s) by which a watch on the wall clock is extended because its script is late."""
PATIENCE_S = 0.7
PATIENCE_WITH_THE_END_S = 4.0


class Watch:
    """The watch of one program.

    `observe` makes the recording; after that, the program keeps running until the `with` block is left.

    The program is started as its author would start it. With the "simulated" clock, the program is switched to
    simulated time once its nodes are spinning, or watched on the wall clock if that's impossible. `keep_watching`
    extends the watch of a program that was observed on the wall clock.

    `process`: the program's process, if it's already running on the observer's domain. Raises OSError if the program
    can't be started.
    """

    def __init__(
        self,
        observer: Observer,
        spec: ProgramSpec,
        plan: Plan,
        clock: Clock,
        process: NodeProcess | None = None,
    ) -> None:
        self._session = open_session(observer, spec, plan, process)
        self._plan = plan
        from_start = bool(spec.parameters.get(USE_SIM_TIME))
        self._switch = TimeSwitch(self._session, from_start=from_start) if clock == "simulated" else None
        self._process = self._session.process
        self._recorder = self._session.recorder
        self._stretches: tuple[Stretch, ...] = ()
        self._following: dict[str, bool] = {}
        self._in_lockstep = False
        self._simulated = False
        self._outpaced = False
        self._own_clock: tuple[str, ...] = ()
        self._judged_until: float | None = None
        self._matched_wall: float | None = None

    def observe(self, cancel_soak: Callable[[], bool] = lambda: False) -> Recording:
        """Watch the program as planned, and return the recording. The program keeps running.

        On the wall clock, call `cancel_soak` repeatedly, and return early if it returns True.
        """
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
                self._run_simulated_time(self._session.clock)
            else:
                run_wall_time(self._session, self._plan.wall_s, cancel_soak)
                self._run_until_script_ends(cancel_soak)
        if not self._recorder.any_publisher() or not all(map(self._recorder.matched, self._plan.topics)):
            self._process.domains_used()
        return self._with_what_is_kept(self.recording())

    def _with_what_is_kept(self, recording: Recording) -> Recording:
        """Return the recording with the number of messages that a late subscription receives from each topic.

        Counting them takes a moment, so call this after the watch.
        """
        kept = self._recorder.kept_until_now() if self._process.is_running() else {}
        late = {name: replace(recording.topic(name), kept=count) for name, count in kept.items()}
        return replace(recording, topics={**recording.topics, **late})

    def _run_until_script_ends(self, cancel_soak: Callable[[], bool]) -> None:
        until = time.monotonic() + MOST_DELAYED_S
        while self._process.is_running() and (left := left_to_watch(self._session)) > 0:
            allowed = until - time.monotonic()
            if allowed <= 0 or cancel_soak() or is_lost(self._session):
                return
            run_wall_time(self._session, min(left, allowed), cancel_soak)

    def _run_simulated_time(self, clock: SimulatedClock) -> None:
        simulated_time = SimulatedRun(self._session, clock)
        self._judged_until = simulated_time.run_as_planned()
        self._stretches = tuple(simulated_time.stretches)
        self._in_lockstep = simulated_time.in_lockstep
        simulated_time.run_longer()
        self._outpaced = simulated_time.outpaced
        self._following = {} if self._outpaced else simulated_time.following()

    def _begin_watch(self) -> None:
        clock = self._session.clock
        if clock is not None or self._plan.script:
            let_it_match_us(self._session)
        if clock is not None and self._plan.script and not self._plan.paced:
            self._recorder.take()  # no message may arrive before the script begins
        else:
            self._recorder.discard()
        if clock is not None:
            clock.publish()
        else:
            self._session.began = time.monotonic()
        self._recorder.start_windows(0.0)

    def keep_watching(
        self, wall_s_after_match: float, cancel_soak: Callable[[], bool] = lambda: False
    ) -> bool:
        """Keep a program on the wall clock running until `wall_s_after_match` (s) after its topics were matched.

        Return True after that time, or as soon as the program exits by itself. Return False if `cancel_soak` returns
        True.
        """
        until = (self._matched_wall or time.monotonic()) + wall_s_after_match
        while (left := until - time.monotonic()) > 0 and self._process.is_running():
            if cancel_soak():
                return False
            self._process.wait(min(left, KEPT_LOOK_S))
        if self._process.is_running():
            self._recorder.look()
        return True

    def with_its_nodes(self, recording: Recording) -> Recording:
        """Return the recording with all nodes seen so far."""
        return replace(recording, nodes=self._recorder.nodes())

    def recording(self) -> Recording:
        """Return a recording of everything seen so far."""
        end = self._end()
        if self._process.is_running():
            self._recorder.look_at_services()
            if not self._simulated:
                self._own_clock = tuple(sorted({*self._own_clock, *self._recorder.nodes_on_clock()}))
        delays = self._session.delays
        asked = self._switch is not None and self._matched_wall is not None
        follows = self._simulated and not self._outpaced if asked else None
        return Recording(
            clock="simulated" if self._simulated else "wall",
            domain_id=self._session.observer.domain_id,
            stretches=self._stretches,
            watched_s=round(end, 6),
            wall_s=round(time.monotonic() - self._process.started_at, 4),
            topics=self._recorder.topics(end),
            nodes=self._recorder.nodes(),
            process=self._process.record(),
            follows_clock=follows,
            following=self._following,
            in_lockstep=self._in_lockstep,
            step_s=self._plan.step_s if self._simulated else None,
            published=self._session.script_player.published(),
            unpublished=self._session.script_player.unpublished(),
            calls=tuple(call for call in self._session.script_player.calls() if call.t <= end),
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
        """Return the simulated time (s) up to which the recording is judged."""
        if self._matched_wall is None:
            return 0.0
        if self._judged_until is not None:
            return self._judged_until
        return self._session.simulated_time(time.monotonic())

    def finish(
        self, recording: Recording, patience_s: float = PATIENCE_S, *, look_who_stays: bool = False
    ) -> Recording:
        """Stop the program with SIGINT, and add its exit to `recording`.

        If the program doesn't exit within `patience_s` (s), kill it. With `look_who_stays`, watch the graph afterward,
        because a program that exits properly removes its nodes from the graph.
        """
        self._end_process(patience_s)
        if not look_who_stays:
            return replace(recording, process=self._process.record())
        if self._session.context.ok():
            self._recorder.look_who_stays(GONE_S)
            nodes = self._recorder.nodes()
            if any(node.stayed for node in nodes):  # the next program must not discover these nodes
                self._session.close()
                self._session.observer.move()
        else:
            nodes = tuple(replace(node, stayed=True) for node in recording.nodes)
        return replace(recording, process=self._process.record(), nodes=nodes)

    def _end_process(self, patience_s: float = PATIENCE_S) -> None:
        self._session.rest.close()
        was_killed = self._process.killed
        if self._switch is None or self._switch.is_real:
            self._process.stop(patience_s)
        else:
            # If the program waits for a timer, it handles Ctrl-C only when /clock makes the timer due.
            if self._session.clock is not None:
                self._session.clock.run_at(1.0)
            self._process.stop(patience_s, self._switch.keep_time)
        if self._process.killed and not was_killed:
            self._session.close()
            self._session.observer.move()

    def __enter__(self) -> "Watch":
        return self

    def __exit__(self, *_: object) -> None:
        self._end_process()
        if self._switch is not None and self._session.context.ok():
            self._switch.close()
        self._session.close()
