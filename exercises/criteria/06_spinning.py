"""Judge exercise 06: a driver calls `pump` eight times, and the nodes publish everything that they do.

Each run draws the words and jobs that the robots receive, and the time of a burst of words.
"""

import math
import re
from itertools import pairwise
from random import Random
from statistics import median

from std_msgs.msg import Int32, Int32MultiArray, String

import workbook.criteria as see
from workbook.criteria import Recording, Verdict, criterion, topic, watching

WORDS = see.Words(__file__)

HEARTBEAT = topic("/robot/heartbeat", Int32MultiArray, signed=True)
LOOK = topic("/robot/look", Int32MultiArray, signed=True)
HEARD = topic("/robot/heard", Int32MultiArray, signed=True)
JOB_BEGUN = topic("/robot/job_begun", Int32MultiArray, signed=True)
QUIET_HEARD = topic("/quiet/heard", Int32MultiArray, signed=True)
JOB_DONE = topic("/robot/job_done", Int32MultiArray, signed=True)
PUMP = topic("/driver/pump", String, signed=True)
CHANGED = topic("/driver/changed", String, signed=True)
Report = tuple[float, int, int]  # the time (wall time, s), the call, and a number
ROBOT_TOPICS = (HEARTBEAT, LOOK, HEARD, JOB_BEGUN, QUIET_HEARD, JOB_DONE)
# Matches the driver's announcements on /driver/pump, which contain the call's number. Other nodes may publish there,
# too.
ANNOUNCEMENT = re.compile(
    r"begin \d{1,9}|raised \d{1,9} (?P<raised>.*)|end \d{1,9}(?P<end>( \d{1,9}(\.\d{1,9})?){1,4})", re.DOTALL
)

# The numbers of the calls of pump, and the duration (s) that each call requests. Between two calls, the robots report
# 0.
BETWEEN, BURST, AGAIN, SHORT, SHORT_TOO, SHORTEST, SLOW, QUIET, JOBS_ALONE = range(9)
ASKED_S = (0.0, 2.1, 1.2, 0.08, 0.08, 0.05, 0.8, 1.6, 0.08)
ROBOT_CALLS = (BURST, AGAIN, SHORT, SHORT_TOO, SHORTEST)
SHORT_CALLS = (SHORT, SHORT_TOO, SHORTEST)
NEVER = math.inf  # the start of a call that isn't made, and the end of a call that doesn't return
BURST_WORDS, WAITING_WORDS = 20, 5
JOBS = 7
JOBS_IN_A_ROW = 5  # for a robot without timers: two such jobs are two callbacks in a row
QUIET_WORDS, EARLY_QUIET_WORDS = 4, 2  # the early words come long before the call's time is up
NUMBERS = range(1, 1000)  # the numbers of words and jobs
JOB_S, HEARTBEAT_PERIOD_S = 0.4, 0.1  # as in the driver

# The task states these.
EARLY_S, LATE_S = 0.05, 0.25
LEAST_SHARE = 0.8  # of the heartbeats that are due
LEAST_BEATS = LEAST_SHARE * ASKED_S[BURST] / HEARTBEAT_PERIOD_S
LONGEST_SILENCE_S = 0.3
PROCESSOR_SHARE = 0.12
SHARE_WITH_TIMERS = 0.4  # of a processor: a correct function uses up to 0.1, one that never waits 1.0

DELAY_S = 1.5  # longer than a message takes to arrive, even on a busy machine
A_FEW_BEATS = 3  # fewer heartbeats may be chance
AHEAD_S = 0.01  # a function that waits until its time is up never returns so early


def drawn(rng: Random) -> list[see.Part]:
    """Draw the script: the driver's orders, and the words and jobs for the robots.

    Except for 0, no number occurs twice on a topic.
    """
    words = rng.sample(NUMBERS, BURST_WORDS + WAITING_WORDS)
    jobs = rng.sample(NUMBERS, JOBS + JOBS_IN_A_ROW)
    quiet_words = rng.sample(NUMBERS, QUIET_WORDS)
    burst_at = 0.25 + rng.randint(0, 8) / 20
    starts = (0.2, 2.75, 4.15, 4.15, 4.15, 5.3, 6.65, 8.4)
    robots = (*["robot"] * 6, "quiet_robot", "worker")
    orders = [f"{number} {robot} {ASKED_S[number]}" for number, robot in enumerate(robots, start=1)]
    # The driver receives each order three times and carries it out once.
    go = [(at + 0.1 * n, order) for at, order in zip(starts, orders, strict=True) for n in range(3)]
    # A 0 isn't judged. Zeros follow the words because a lost message may arrive only with the next one.
    heard = [(burst_at, word) for word in words[:BURST_WORDS]]
    heard += [(burst_at + after, 0) for after in (0.15, 0.35, 0.65)]
    heard += [(2.5, word) for word in words[BURST_WORDS:]]
    heard += [(at, 0) for at in (2.9, 3.1, 3.3)]
    # The last two words come so late that a restarted wait shows, even if the call itself began half a second late.
    quiet = [*zip((7.4, 7.47, 8.0, 8.07), quiet_words, strict=True)]
    return [
        see.publish("/driver/go", String, go),
        see.publish("/robot/words", Int32, heard),
        see.publish("/robot/jobs", Int32, [(5.1, job) for job in jobs[:JOBS]]),
        see.publish("/worker/jobs", Int32, [(7.8, job) for job in jobs[JOBS:]]),
        see.publish("/quiet/words", Int32, quiet),
    ]


WATCH = watching(wall_seconds=9.8, script=drawn)


class Call:
    """One call of `pump`: its start and end (wall time, s), its duration (s), and the error that it raised."""

    def __init__(self, run: "Run", number: int) -> None:
        self.run, self.number, self.asked, self.recording = run, number, ASKED_S[number], run.recording
        told = [(at, one) for of_call, at, one in run.announced if of_call == number]
        self.begin = told[0][0] if told else NEVER
        self.raised = [None, *(one["raised"] for _, one in told if one["raised"] is not None)][-1]
        ends = [(at, one["end"]) for at, one in told if one["end"]]
        self.end, self.took, used, in_line, taken = NEVER, NEVER, 0.0, 0.0, 0.0
        if ends:
            self.end, measured = ends[0]
            took, used, in_line, taken = [*map(float, measured.split()), 0.0, 0.0, 0.0][:4]
            # The driver's measurement is more exact than its report's arrival, but the two must agree.
            arrived = self.end - self.begin
            self.took = took if abs(arrived - took) <= DELAY_S else arrived
            self.begin = min(self.begin, self.end - self.took)
        self.waited = in_line + taken  # the time (s) for which the machine kept the program waiting
        # the used fraction of one processor (1.0: all of it), not counting the wait for a processor on a busy machine
        self.processor = used / (max(self.took - in_line, used) or 1.0)
        self.is_back = self.end < NEVER
        until = self.end if self.is_back else run.recording.wall_s
        self.spent = self.took if self.is_back else until - self.begin
        self.late = self.spent - self.asked  # negative if the call returned before its time was up
        self.ahead = -self.late
        self.is_early = self.is_back and self.late < -EARLY_S
        self.extra = JOB_S if number in (SLOW, JOBS_ALONE) else 0.0  # for a job that runs when the time is up
        self.kept_waiting = self.waited + run.machine_s  # the answer isn't to blame for this
        self.is_late = self.late > self.extra + LATE_S + self.kept_waiting

        self.beats = [at for at, call, _ in run.reports[HEARTBEAT] if call == number]
        self.looks, self.heard, self.begun, self.quiet_heard = (
            [reported for _, call, reported in run.reports[name] if call == number]
            for name in (LOOK, HEARD, JOB_BEGUN, QUIET_HEARD)
        )
        moments = sorted([self.begin, *self.beats, until])
        self.silence = max(after - before for before, after in pairwise(moments))

    @property
    def early_unlike_first(self) -> bool:
        return self.is_early and not self.run.first.is_early


class Run:
    """The calls that the driver announced, and the robots' reports."""

    def __init__(self, recording: Recording) -> None:
        self.recording: Recording = recording
        self.machine_s: float = max(recording.held_up_s, recording.stood_still_s)
        self.reports: dict[see.Topic, list[Report]] = {one: reports(recording, one) for one in ROBOT_TOPICS}
        self.announced: list[tuple[int, float, re.Match[str]]] = [
            (int(told[0].split()[1]), one.published, told)
            for one in recording.topic(PUMP.name).arrivals
            if (told := ANNOUNCEMENT.fullmatch(str(one.value.get("data"))))
        ]
        self.calls = [Call(self, number) for number in range(len(ASKED_S))]
        self.between, self.first, self.second = self.calls[BETWEEN], self.calls[BURST], self.calls[AGAIN]
        self.slow, self.quiet, self.alone = self.calls[SLOW], self.calls[QUIET], self.calls[JOBS_ALONE]
        # The unwanted changes that calls made, such as "3: 1 timer left". Then the first change without its call's
        # number.
        self.changes = [one.replace(" ", ": ", 1) for one in see.driver_reports(recording, CHANGED)]
        self.changed_in, _, self.change = self.changes[0].partition(": ") if self.changes else ("", "", "")
        self.left = next((change for change in self.changes if change.endswith("left")), None)

        # the calls with the robot that returned
        self.returned = [self.calls[number] for number in ROBOT_CALLS if self.calls[number].is_back]
        self.typical = median([call.late - call.waited for call in self.returned] or [0.0])
        self.worst = max(self.returned, key=lambda call: call.late, default=self.first)
        self.early = [call.number for call in self.returned if call.is_early]
        self.like_first = [call for call in self.returned if abs(call.took - self.first.took) < LATE_S]
        self.shortest = min(self.calls[SHORT], self.calls[SHORT_TOO], key=lambda call: call.took)

        words = sent(recording, "/robot/words")
        self.burst, self.waiting = words[:BURST_WORDS], {*words[BURST_WORDS:]}
        self.handled = [word for word in self.first.heard if word in self.burst]
        self.waiting_handled = self.waiting & {*self.first.heard, *self.second.heard}
        self.rare_beats = len(self.second.beats) < A_FEW_BEATS
        self.does_less = self.rare_beats or len(self.waiting_handled) < WAITING_WORDS
        is_late = self.second.late > 2 * LATE_S + self.second.kept_waiting
        self.second_like_first = is_late and abs(self.second.took - self.first.took) < EARLY_S
        # Whether due timers don't fire in the short calls, although the machine didn't keep these calls waiting.
        short = [self.calls[number] for number in SHORT_CALLS]
        idle = all(call.is_back and not call.beats and not call.looks for call in short)
        waited = self.machine_s + sum(call.waited for call in short)
        self.short_calls_idle = idle and waited <= LATE_S and bool(self.second.beats)
        # Whether a short call without jobs returned in time, and the call with jobs was made.
        self.short_in_time = min(call.took for call in short) <= LATE_S and self.alone.begin < NEVER

        # The CPU time used by waiting. The CPU time used by callbacks depends on the executor and the machine.
        with_timers = (self.first, self.second)
        busiest = max(call.processor for call in with_timers)
        self.idle_share = self.quiet.processor if self.quiet.is_back else busiest
        long = [call.processor for call in with_timers if call.took > call.asked / 2.0]
        self.share_with_timers = max(long, default=0.0)

        spans = [(call.begin - EARLY_S, call.end + EARLY_S) for call in (self.quiet, self.alone)]
        others = [any(begin < at < end for begin, end in spans) for at in self.between.beats]
        self.works_between = len(others) >= A_FEW_BEATS
        self.in_others_calls = all(others)  # while `pump` was called with another robot
        begun = {job: call for _, call, job in self.reports[JOB_BEGUN]}
        self.outlasting = [job for _, call, job in self.reports[JOB_DONE] if begun.get(job, call) != call]


def reports(recording: Recording, one: see.Topic) -> list[Report]:
    """Return a robot's reports on a topic, in the order of arrival."""
    found = []
    for arrival in recording.topic(one.name).arrivals:
        match arrival.value:
            case {"data": [int(call), int(number)]}:
                found.append((arrival.published, call, number))
    return found


def sent(recording: Recording, name: str) -> list[int]:
    """Return the numbers that the script sends to a robot on a topic, in order, without zeros, which aren't judged."""
    return [one.value["data"] for one in see.script(recording, name) if one.value["data"]]


facts = see.once(Run)

MISSING = WORDS.cause("pump.missing", ())
RAISES = WORDS.cause("pump.raises", Call)
NOT_MADE = WORDS.rules(
    Call,
    "call",
    ("never-made", lambda call: call.begin == NEVER, see.program_ended),
    ("never-begun", lambda call: call.begin == NEVER),
    ("raises-later", lambda call: call.raised is not None),
)
NEVER_RETURNS = WORDS.rules(
    Call,
    "returns",
    ("program-ended", see.otherwise, see.program_ended),
    ("never", see.otherwise),
    about_time=True,
)
SUBTRACTED = WORDS.cause("in-time.subtracted", Run)
TOO_EARLY = WORDS.cause("in-time.too-early", Call)
ALL_IN_TIME = WORDS.rules(
    Run,
    "in-time",
    ("short-calls", lambda run: not run.left and run.shortest.is_early and {*run.early} <= {*SHORT_CALLS}),
    ("first-time-kept", lambda run: len(run.like_first) > 2 and run.like_first == run.returned),
    ("too-late", lambda run: run.typical > LATE_S),
    about_time=["first-time-kept", "too-late"],
)
IN_TIME = WORDS.rules(
    Call,
    "in-time",
    ("program-ended", lambda call: not call.is_back, see.program_ended),
    ("not-back", lambda call: not call.is_back),
    ("ended-by-what-was-left", lambda call: call.is_early and call.run.left),
    (
        "ended-by-silence",
        lambda call: call.early_unlike_first and call.number == QUIET and not call.quiet_heard,
    ),
    ("ended-by-job", lambda call: call.early_unlike_first and call.number == SLOW and call.begun),
    ("too-early", lambda call: call.is_early),
    ("wait-begins-anew", lambda call: call.is_late and call.number == QUIET),
    ("callbacks-not-counted", lambda call: call.is_late),
    about_time=["not-back", "wait-begins-anew", "callbacks-not-counted"],
)
BURST_HANDLED = WORDS.rules(
    Run,
    "words-handled",
    ("more-than-once", lambda run: len(run.handled) > BURST_WORDS),
    ("one-a-round", lambda run: run.handled),
    ("none", see.otherwise),
    about_time=["one-a-round", "none"],
)
TIMERS = WORDS.rules(
    Call,
    "timers-tick",
    ("too-few", lambda call: len(call.beats) < LEAST_BEATS or not call.looks),
    ("silence", lambda call: call.silence > LONGEST_SILENCE_S + call.kept_waiting),
    about_time=True,
)
WORKS_AGAIN = WORDS.rules(
    Run,
    "again",
    ("ends-early", lambda run: run.second.is_early),
    ("same-time-as-first", lambda run: run.second_like_first),
    ("timers-reset", lambda run: run.short_calls_idle and any("timer reset" in one for one in run.changes)),
    ("short-calls-do-nothing", lambda run: run.short_calls_idle),
    ("handled-before", lambda run: run.does_less and run.waiting & {*run.between.heard}),
    ("timers-canceled", lambda run: run.rare_beats and any("canceled" in one for one in run.changes)),
    ("does-nothing", lambda run: run.rare_beats),
    ("words-lost", lambda run: run.does_less),
    about_time=["short-calls-do-nothing", "words-lost", "does-nothing"],
)
SLOW_JOBS = WORDS.rules(
    Run,
    "slow-callbacks",
    ("none-begun", lambda run: not run.slow.begun),
    ("several", lambda run: run.short_in_time and len(run.alone.begun) > 1),
    ("late-after-job", lambda run: run.short_in_time and run.alone.is_late and run.alone.raised is None),
    about_time=["none-begun", "late-after-job"],
)
WORDS_WAIT = WORDS.cause("quiet-node.words-wait", Call, about_time=True)
BUSY = WORDS.rules(
    Run,
    "easy-on-the-processor",
    ("never-waits", lambda run: run.idle_share >= PROCESSOR_SHARE),
    ("polls-with-timers", lambda run: run.share_with_timers >= SHARE_WITH_TIMERS),
)
LEFT_RUNNING = WORDS.rules(
    Run,
    "nothing-left-running",
    ("another-node", lambda run: run.works_between and run.in_others_calls),
    ("spins-on", lambda run: run.works_between),
    ("still-works", lambda run: run.outlasting),
    ("left-behind", lambda run: "left" in run.change),
    ("cut-off", lambda run: run.change.startswith("job")),
    ("thread-runs", lambda run: run.change.endswith("thread still runs")),
    ("thread-left", lambda run: "thread" in run.change),
    ("not-its-own", lambda run: run.change in ("rclpy.init called", "node made")),
    ("changed", lambda run: run.changes),
)


@criterion(points=0, title="Your file loads, and pump can be called")
def program_runs(recording: Recording) -> Verdict:
    loaded, first = see.program_runs(recording), facts(recording).first
    if loaded.ok and first.raised is not None:
        raises = RAISES.verdict(first)
        return see.failed_in_call(recording, raises.saw, raises.expected) or raises
    is_missing = loaded.ok and "missing" in see.driver_reports(recording, PUMP)
    return MISSING.verdict() if is_missing else loaded


@criterion(points=1, title="pump returns", needs=[program_runs])
def returns(recording: Recording) -> Verdict:
    first = facts(recording).first
    lost = NOT_MADE.first(first)
    if lost or first.is_back:
        return lost or see.passed("it returned")
    return NEVER_RETURNS.verdict(first)


@criterion(points=1, title="pump returns when the time is up, neither early nor late", needs=[returns])
def returns_in_time(recording: Recording) -> Verdict:
    run = facts(recording)
    first, second = run.first, run.second
    if first.is_early and second.is_early and abs(first.late - second.late) < EARLY_S / 2.0:
        return SUBTRACTED.verdict(run)
    if first.is_early or (run.early and all(call.late < -AHEAD_S for call in run.returned)):
        return TOO_EARLY.verdict(run.calls[run.early[0]])
    delay = f"the median delay of {see.count(len(run.returned), 'call')} was {max(0.0, run.typical):.2f} s"
    well = see.passed(f"called with {first.asked:g} s, took {first.took:.2f} s; {delay}")
    return ALL_IN_TIME.first(run) or well


@criterion(
    points=2, title="All words that arrive in a burst are handled during the call", needs=[program_runs]
)
def words_handled(recording: Recording) -> Verdict:
    run = facts(recording)
    if sorted(run.handled) == sorted(run.burst):
        return see.passed(f"{len(run.handled)} of {len(run.handled)} words handled")
    return BURST_HANDLED.verdict(run)


@criterion(points=1, title="The timers keep their rate during the call", needs=[returns])
def timers_tick(recording: Recording) -> Verdict:
    call = facts(recording).first
    told = f"{len(call.beats)} heartbeats in {call.asked} s, and it looked around"
    return TIMERS.first(call) or see.passed(told)


@criterion(points=1, title="Later calls work, too", needs=[returns, words_handled])
def again(recording: Recording) -> Verdict:
    run = facts(recording)
    words = f"{len(run.waiting_handled)} of {WAITING_WORDS} waiting words"
    well = see.passed(f"{words} and {len(run.second.beats)} heartbeats in the second call")
    return NOT_MADE.first(run.second) or WORKS_AGAIN.first(run) or well


@criterion(points=1, title="Slow callbacks delay the return by about one callback at most", needs=[returns])
def slow_callbacks(recording: Recording) -> Verdict:
    run = facts(recording)
    verdict = in_time(run.slow)
    well = see.passed(f"{verdict.saw}, with {len(run.slow.begun)} slow jobs started")
    return SLOW_JOBS.first(run) or well if verdict.ok else verdict


@criterion(points=1, title="With a quiet robot, pump also returns on time", needs=[returns])
def quiet_node(recording: Recording) -> Verdict:
    call = facts(recording).quiet
    verdict = in_time(call)
    waiting = {*sent(recording, "/quiet/words")[:EARLY_QUIET_WORDS]} - {*call.quiet_heard}
    words_wait = verdict.ok and call.is_back and waiting and call.kept_waiting <= LATE_S
    return WORDS_WAIT.verdict(call) if words_wait else verdict


@criterion(points=1, title="pump uses hardly any CPU time while it waits", needs=[returns])
def easy_on_the_processor(recording: Recording) -> Verdict:
    run = facts(recording)
    return BUSY.first(run) or see.passed(f"{run.idle_share:.0%} of a CPU core")


@criterion(points=1, title="Between calls, no callback runs, and the node is unchanged", needs=[returns])
def nothing_left_running(recording: Recording) -> Verdict:
    unchanged = see.passed("no callback ran between the calls, and the node is unchanged")
    return LEFT_RUNNING.first(facts(recording)) or unchanged


def in_time(call: Call) -> Verdict:
    """Check that the call took as long as requested."""
    lost = NOT_MADE.first(call)
    if lost is None and not call.is_back and call.late < call.extra + LATE_S:
        return see.passed("the judge stopped watching before the call's time was up")
    well = see.passed(f"called with {call.asked} s, took {call.took:.2f} s")
    return lost or IN_TIME.first(call) or well
