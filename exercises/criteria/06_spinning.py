"""How exercise 06 is judged: a driver calls `pump` eight times, and everything that the nodes did is on the topics.

Which words and jobs the robots get is drawn for each run, and when the burst of words comes.
"""

import math
import re
from dataclasses import dataclass, replace
from itertools import pairwise
from random import Random
from statistics import median

from std_msgs.msg import Int32, Int32MultiArray, String

import workbook.criteria as see
from workbook.criteria import Recording, Verdict, criterion, topic, watching

HEARTBEAT = topic("/robot/heartbeat", Int32MultiArray, signed=True)
LOOK = topic("/robot/look", Int32MultiArray, signed=True)
HEARD = topic("/robot/heard", Int32MultiArray, signed=True)
JOB_BEGUN = topic("/robot/job_begun", Int32MultiArray, signed=True)
QUIET_HEARD = topic("/quiet/heard", Int32MultiArray, signed=True)
JOB_DONE = topic("/robot/job_done", Int32MultiArray, signed=True)
PUMP = topic("/driver/pump", String, signed=True)
CHANGED = topic("/driver/changed", String, signed=True)

# The calls of pump by their number, and for how many seconds each asks. Between two calls the robots report 0.
BETWEEN, BURST, AGAIN, SHORT, SHORT_TOO, SHORTEST, SLOW, QUIET, JOBS_ALONE = range(9)
ASKED_S = {
    BURST: 2.1,
    AGAIN: 1.2,
    SHORT: 0.08,
    SHORT_TOO: 0.08,
    SHORTEST: 0.05,
    SLOW: 0.8,
    QUIET: 1.6,
    JOBS_ALONE: 0.08,
}
ROBOT_CALLS = (BURST, AGAIN, SHORT, SHORT_TOO, SHORTEST)
SHORT_CALLS = (SHORT, SHORT_TOO, SHORTEST)
BURST_WORDS = 20
WAITING_WORDS = 5
JOBS = 7
JOBS_IN_A_ROW = 5  # for a robot without timers: two of them are two callbacks in a row
EARLY_QUIET_WORDS = 2  # long before the call ends
QUIET_WORDS = 4
NUMBERS = range(1, 1000)  # of words and jobs
JOB_S = 0.4  # as in the driver, like the next one
HEARTBEAT_PERIOD_S = 0.1

# The task names these.
EARLY_S, LATE_S = 0.05, 0.25
LEAST_SHARE = 0.8  # of the heartbeats that are due
LONGEST_SILENCE_S = 0.3
PROCESSOR_SHARE = 0.12
SHARE_WITH_TIMERS = 0.4  # right functions use up to a tenth, one that never waits uses all of it

DELAY_S = 1.5  # longer than a message needs to arrive, on however busy a machine
A_FEW_BEATS = 3  # fewer may be chance
AHEAD_S = 0.01  # nobody who waits for the end comes back so early


def ordered(at: float, order: str) -> list[tuple[float, str]]:
    """An order, given three times: the driver carries it out once."""
    return [(at + 0.1 * again, order) for again in range(3)]


def drawn(rng: Random) -> list[see.Part]:
    """What the driver is told to call, and what the robots hear meanwhile. No number comes twice."""
    words = rng.sample(NUMBERS, BURST_WORDS + WAITING_WORDS)
    jobs = rng.sample(NUMBERS, JOBS + JOBS_IN_A_ROW)
    quiet_words = rng.sample(NUMBERS, QUIET_WORDS)
    burst_at = 0.25 + rng.randint(0, 8) / 20
    return [
        see.publish(
            "/driver/go",
            String,
            [
                *ordered(0.2, "1 robot 2.1"),
                *ordered(2.75, "2 robot 1.2"),
                *ordered(4.15, "3 robot 0.08"),
                *ordered(4.15, "4 robot 0.08"),
                *ordered(4.15, "5 robot 0.05"),
                *ordered(5.3, "6 robot 0.8"),
                *ordered(6.65, "7 quiet_robot 1.6"),
                *ordered(8.4, "8 worker 0.08"),
            ],
        ),
        see.publish(
            "/robot/words",
            Int32,
            [
                # The 0 is not judged: a message may hang until the next one.
                *((burst_at, word) for word in words[:BURST_WORDS]),
                *((burst_at + after, 0) for after in (0.15, 0.35, 0.65)),
                *((2.5, word) for word in words[BURST_WORDS:]),
                *((at, 0) for at in (2.9, 3.1, 3.3)),
            ],
        ),
        see.publish("/robot/jobs", Int32, [(5.1, job) for job in jobs[:JOBS]]),
        see.publish("/worker/jobs", Int32, [(7.8, job) for job in jobs[JOBS:]]),
        # The last two late in the call, so that a wait that begins anew shows, even when the call itself began half a
        # second late.
        see.publish("/quiet/words", Int32, [*zip((7.4, 7.47, 8.0, 8.07), quiet_words, strict=True)]),
    ]


WATCH = watching(wall_seconds=9.8, script=drawn)


@criterion(points=0, title="Your file loads, and pump can be called")
def program_runs(recording: Recording) -> Verdict:
    loaded = see.program_runs(recording)
    if not loaded.ok:
        return loaded
    first = calls(recording).get(BURST)
    if first is not None and first.raised is not None:
        return first_call_raised(recording, first.raised)
    if "missing" in see.driver_reports(recording, PUMP):
        return see.failed(
            "pump.missing",
            "your file has no function named pump",
            "def pump(node, seconds), at the left margin of the file",
            "The name is spelled differently, or the function is defined inside another function.",
            "Write def pump(node: Node, seconds: float) -> None: at the left margin.",
        )
    return loaded


@criterion(points=1, title="pump comes back", needs=[program_runs])
def returns(recording: Recording) -> Verdict:
    lost = not_made(recording, BURST)
    if lost is not None:
        return lost
    call = calls(recording)[BURST]
    if call.end is not None:
        return see.passed("it returned")
    expected = f"pump(node, {ASKED_S[BURST]}) returns"
    return see.program_ended(recording, "the first call never returned", expected) or see.failed(
        "returns.never",
        f"no return {recording.wall_s - call.begin - ASKED_S[BURST]:.1f} s after its time was up",
        expected,
        "rclpy.spin and executor.spin return only when ROS is shut down. Or your loop never reaches its end time: "
        "`seconds` is in seconds, and time.process_time() doesn't advance while your function waits.",
        "Use rclpy.spin_once(node, timeout_sec=...) in a loop that checks the clock.",
        about_time=True,
    )


@criterion(points=1, title="It returns when the time is up: not earlier, not later", needs=[returns])
def returns_in_time(recording: Recording) -> Verdict:
    lost = not_made(recording, BURST)
    if lost is not None:
        return lost
    took = {
        n: call.took for n, call in calls(recording).items() if n in ROBOT_CALLS and call.took is not None
    }
    early = ended_early(recording, took)
    if early is not None:
        return early
    same = [
        seconds for n, seconds in took.items() if n != BURST and abs(seconds - took.get(BURST, 0.0)) < LATE_S
    ]
    if len(same) > 1 and len(same) == len(took) - 1:
        return see.failed(
            "in-time.first-time-kept",
            f"the first call took {took[BURST]:.2f} s, and so did the others, although they requested less",
            IN_TIME,
            "The end time of the first call is also used for the others.",
            "Compute the end time in each call, from that call's seconds.",
            about_time=True,
        )
    made = calls(recording)
    typical = median(seconds - ASKED_S[n] - made[n].kept_waiting_s for n, seconds in took.items())
    if typical > LATE_S:
        worst = max(took, key=lambda n: took[n] - ASKED_S[n])
        return see.failed(
            "in-time.too-late",
            f"called with {ASKED_S[worst]:g} s, returned after {took[worst]:.2f} s; the median delay of "
            f"{see.count(len(took), 'call')} was {typical:.2f} s",
            IN_TIME,
            "Your function doesn't use the requested time: it rounds up, or it enforces a minimum. Or its last "
            "wait is longer than the remaining time.",
            TIME_THAT_IS_LEFT,
            about_time=True,
        )
    return see.passed(
        f"called with {ASKED_S[BURST]:g} s, took {took[BURST]:.2f} s; the median delay of "
        f"{see.count(len(took), 'call')} was {max(0.0, typical):.2f} s"
    )


@criterion(points=2, title="Every word of a burst is handled during the call", needs=[program_runs])
def words_handled(recording: Recording) -> Verdict:
    burst = numbers_for(recording, "/robot/words")[:BURST_WORDS]
    got = [word for word in done_in(recording, HEARD.name, BURST) if word in burst]
    words = len(burst)
    if sorted(got) == sorted(burst):
        return see.passed(f"{words} of {words} words handled")
    if len(got) > words:
        return see.failed(
            "words-handled.more-than-once",
            f"{len(got)} words handled, but only {words} were sent",
            f"each of the {words} words once",
            "Your function created a second subscription on the node, or it calls the callback itself.",
            "Don't change the node, and let spin_once call the callbacks.",
        )
    saw = f"{len(got)} of {words} words handled during the call"
    expected = f"all {words} words that arrived during the call"
    hint = (
        "Call rclpy.spin_once(node, timeout_sec=...) again and again until the time is up, without a sleep."
    )
    if got:
        return see.failed(
            "words-handled.one-a-round",
            saw,
            expected,
            "One spin_once runs one callback, and a sleep runs none. All other ready callbacks wait for the next "
            "spin_once.",
            hint,
            about_time=True,
        )
    return see.failed(
        "words-handled.none",
        saw,
        expected,
        "Nothing spins this node during the call. Callbacks don't run during a sleep, or while another node is "
        "spun.",
        hint,
        about_time=True,
    )


@criterion(points=1, title="The timers keep their rate during the call", needs=[returns])
def timers_tick(recording: Recording) -> Verdict:
    asked = ASKED_S[BURST]
    wanted = round(asked / HEARTBEAT_PERIOD_S)
    beats, looks = (done_in(recording, one.name, BURST) for one in (HEARTBEAT, LOOK))
    expected = (
        f"at least {LEAST_SHARE:.0%} of {wanted} heartbeats, at least one look around, and no silence over "
        f"{LONGEST_SILENCE_S} s"
    )
    if len(beats) < LEAST_SHARE * wanted or not looks:
        return see.failed(
            "timers-tick.too-few",
            f"{len(beats)} heartbeats and {see.count(len(looks), 'look')} around in {asked} s",
            expected,
            "A timer fires only while the node is spun, and one spin_once runs one callback.",
            "Spin until the time is up, and never sleep in between.",
            about_time=True,
        )
    silence = longest_silence(recording)
    if silence > LONGEST_SILENCE_S + kept_waiting(recording, BURST):
        return see.failed(
            "timers-tick.silence",
            f"no heartbeat for {silence:.2f} s during the call",
            expected,
            "For part of the time, nothing spins the node. Your function sleeps, or it has stopped spinning and "
            "waits for the end.",
            "Spin until the time is up, and never sleep in between.",
            about_time=True,
        )
    return see.passed(f"{len(beats)} heartbeats in {asked} s, and it looked around")


@criterion(points=1, title="A second call works, too", needs=[returns, words_handled])
def again(recording: Recording) -> Verdict:
    lost = not_made(recording, AGAIN)
    if lost is not None:
        return lost
    took = calls(recording)[AGAIN].took
    if took is not None and took < ASKED_S[AGAIN] - EARLY_S:
        return see.failed(
            "again.ends-early",
            f"the second call returned after {took:.2f} s",
            f"return after {ASKED_S[AGAIN]} s",
            "Something left over from the first call ends the second one: a timer, a flag, or a future. Or your "
            "function gives later calls less time than they request.",
            "Destroy what you created on the node (node.destroy_timer), and create it again in each call.",
        )
    late = took is not None and took > ASKED_S[AGAIN] + 2 * LATE_S + kept_waiting(recording, AGAIN)
    first = calls(recording)[BURST].took
    if late and took is not None and first is not None and abs(took - first) < EARLY_S:
        return see.failed(
            "again.same-time-as-first",
            f"the first call took {first:.2f} s, and so did the second one: {took:.2f} s",
            f"return after {ASKED_S[AGAIN]} s",
            "The end time of the first call is also used for the others.",
            "Compute the end time in each call, from that call's seconds.",
        )
    return nothing_handled(recording) or why_less_again(recording)


@criterion(points=1, title="Slow callbacks delay the return by about one callback at most", needs=[returns])
def slow_callbacks(recording: Recording) -> Verdict:
    verdict = in_time(recording, SLOW, extra=JOB_S)
    if not verdict.ok:
        return verdict
    begun = done_in(recording, JOB_BEGUN.name, SLOW)
    if begun:
        return (
            too_many_jobs(recording)
            or late_after_job(recording)
            or see.passed(f"{verdict.saw}, with {len(begun)} slow jobs started")
        )
    return see.failed(
        "slow-callbacks.none-begun",
        "none of the slow jobs was started",
        "the jobs start one after another until the time is up",
        "Nothing took a message from the queue of /robot/jobs.",
        "Let rclpy.spin_once(node, timeout_sec=...) choose what to run.",
        about_time=True,
    )


def too_many_jobs(recording: Recording) -> Verdict | None:
    """More than one job was begun in a call for less than one; None if not, or if short calls are late anyway."""
    begun = done_in(recording, JOB_BEGUN.name, JOBS_ALONE)
    if len(begun) < 2 or short_calls_late(recording):
        return None
    asked, took = ASKED_S[JOBS_ALONE], calls(recording)[JOBS_ALONE].took
    back = f", which returned after {took:.2f} s" if took is not None else ""
    return see.failed(
        "slow-callbacks.several",
        f"{len(begun)} jobs of {JOB_S} s started in a call for {asked:g} s{back}",
        "at most one callback after the time is up: the second job waits for the next call",
        "Several callbacks run between two checks of the clock, for example in a nested loop. Or your function "
        "starts to measure time only after a first callback.",
        TIME_THAT_IS_LEFT,
    )


def late_after_job(recording: Recording) -> Verdict | None:
    """The last call began one job, and came back long after it; None if not, or if short calls are late anyway."""
    call = calls(recording).get(JOBS_ALONE)
    if call is None or call.raised is not None or short_calls_late(recording):
        return None
    asked = ASKED_S[JOBS_ALONE]
    spent = call.took if call.took is not None else recording.wall_s - call.begin
    if spent <= asked + JOB_S + LATE_S + kept_waiting(recording, JOBS_ALONE):
        return None
    back = f"returned after {spent:.2f} s" if call.took is not None else f"no return after {spent:.2f} s"
    return see.failed(
        "slow-callbacks.late-after-job",
        f"called with {asked:g} s, {back}, although one job takes {JOB_S} s",
        f"return at most one job ({JOB_S} s) and {LATE_S} s after the time is up",
        "After a slow callback, your function waits or sleeps although its time is up.",
        TIME_THAT_IS_LEFT,
        about_time=True,
    )


def short_calls_late(recording: Recording) -> bool:
    """Whether short calls come back late even without slow jobs, or never came back."""
    short = [call.took for n, call in calls(recording).items() if n in SHORT_CALLS and call.took is not None]
    return not short or min(short) > LATE_S


@criterion(points=1, title="It returns on time for a node that has almost nothing to do", needs=[returns])
def quiet_node(recording: Recording) -> Verdict:
    verdict = in_time(recording, QUIET)
    heard = done_in(recording, QUIET_HEARD.name, QUIET)
    took = calls(recording)[QUIET].took if verdict.ok else None
    early = numbers_for(recording, "/quiet/words")[:EARLY_QUIET_WORDS]
    if took is None or set(heard) >= set(early) or kept_waiting(recording, QUIET) > LATE_S:
        return verdict
    return see.failed(
        "quiet-node.words-wait",
        f"{see.count(len(heard), 'word')} handled during the call",
        f"the first {EARLY_QUIET_WORDS} words are handled: they arrived long before the call ended",
        "For part of the call, nothing spun this node. Your function sleeps when nothing is ready, or it spins "
        "another node.",
        "Spin until the time is up, and let spin_once do the waiting.",
        about_time=True,
    )


@criterion(points=1, title="It uses hardly any CPU time while it waits", needs=[returns])
def easy_on_the_processor(recording: Recording) -> Verdict:
    made = {number: call for number, call in calls(recording).items() if call.end is not None}
    # The quiet robot has nothing to do. What the callbacks of the other cost depends on the executor and the machine.
    idle = [QUIET] if QUIET in made else [number for number in (BURST, AGAIN) if number in made]
    share = max((made[number].processor_share for number in idle), default=0.0)
    if share < PROCESSOR_SHARE:
        return polls_with_timers(recording, share) or see.passed(f"{share:.0%} of one processor")
    return see.failed(
        "easy-on-the-processor.never-waits",
        f"{share:.0%} of one processor, mostly for waiting",
        f"less than {PROCESSOR_SHARE:.0%}",
        "A loop with timeout_sec=0, or with a very short timeout, hardly waits: it polls for work again and again.",
        "Let spin_once wait, for example 0.05 s, but no longer than the remaining time. It returns earlier if a "
        "callback is ready.",
    )


def polls_with_timers(recording: Recording, quiet: float) -> Verdict | None:
    """Polling for work with the robot that has timers, though not with the quiet one; None if it waits there, too."""
    made = calls(recording)
    long = [made[n] for n in (BURST, AGAIN) if n in made and (made[n].took or 0.0) > ASKED_S[n] / 2.0]
    share = max((call.processor_share for call in long), default=0.0)
    if share < SHARE_WITH_TIMERS:
        return None
    return see.failed(
        "easy-on-the-processor.polls-with-timers",
        f"{share:.0%} of one processor with the robot that has timers, {quiet:.0%} with the quiet one",
        f"less than {SHARE_WITH_TIMERS:.0%} with timers, and less than {PROCESSOR_SHARE:.0%} with the quiet robot",
        "Between two callbacks, your loop polls for work again and again. It waits only if the node has no timers.",
        "Give each spin_once the same timeout, for example 0.05 s, with or without timers.",
    )


@criterion(
    points=1, title="After it has returned, no callback runs, and the node is unchanged", needs=[returns]
)
def nothing_left_running(recording: Recording) -> Verdict:
    running = spins_on(recording)
    if running is not None:
        return running
    begun = {number: call for call, number in reports(recording, JOB_BEGUN.name)}
    cut_off = [
        number for call, number in reports(recording, JOB_DONE.name) if begun.get(number, call) != call
    ]
    if cut_off:
        return see.failed(
            "nothing-left-running.still-works",
            f"job {cut_off[0]} started in a call, and was still running after the call had returned",
            "no callback runs outside of calls to pump",
            "Callbacks run in other threads, and pump returns without waiting for them to finish.",
            "Run the callbacks in the thread that called pump, as rclpy.spin_once(node, timeout_sec=...) does.",
        )
    changed = see.driver_reports(recording, CHANGED)
    return (
        why_changed(changed)
        if changed
        else see.passed("no callback ran between the calls, and the node is unchanged")
    )


def spins_on(recording: Recording) -> Verdict | None:
    """The robot's callbacks ran between two calls, or in a call with another robot."""
    beats = heartbeats(recording, BETWEEN)
    if len(beats) < A_FEW_BEATS:
        return None
    others = [call for number, call in calls(recording).items() if number in (QUIET, JOBS_ALONE)]
    spans = [(call.begin, call.end if call.end is not None else recording.wall_s) for call in others]
    if all(any(begin - EARLY_S < beat < end + EARLY_S for begin, end in spans) for beat in beats):
        return see.failed(
            "nothing-left-running.another-node",
            f"{len(beats)} heartbeats of the first robot while pump was called with another one",
            "pump runs only the callbacks of the node that was passed to it",
            "Your function reuses the executor or the node of an earlier call, so the earlier node is spun as well.",
            "Use the node that was passed to pump. If you add it to an executor, remove it before you return.",
        )
    return see.failed(
        "nothing-left-running.spins-on",
        f"{len(beats)} heartbeats between the calls",
        "no callback runs outside of calls to pump",
        "Your function left a spinning thread behind. It runs callbacks at unexpected times, and may abort the "
        "process when the program ends.",
        "Spin in the thread that called pump. If you need another thread, end it: executor.shutdown(), then join().",
    )


def thread_left(saw: str) -> Verdict:
    """A thread goes on, although no callback runs."""
    if saw.endswith("still runs"):
        return see.failed(
            "nothing-left-running.thread-runs",
            saw,
            "nothing that pump started keeps running",
            "Your function starts a thread that keeps running after pump has returned. Each call may leave one "
            "more.",
            "Avoid the thread, or end it and join() it before you return.",
        )
    return see.failed(
        "nothing-left-running.thread-left",
        saw,
        "nothing that pump started keeps running",
        "Your function left a thread behind in spin(). Removing its node doesn't end it. Each call leaves one "
        "more, and such a thread may abort the process when the program ends.",
        "Spin in the thread that called pump. If you need another thread, end it: executor.shutdown(), then join().",
    )


def why_changed(changed: list[str]) -> Verdict:
    """What a call has changed that is not its own."""
    call, _, first = changed[0].partition(" ")
    expected = "the node, the ROS context, and the other nodes are unchanged"
    saw = f"after call {call}: {first}"
    if "left" in first:
        return see.failed(
            "nothing-left-running.left-behind",
            saw,
            expected,
            "Objects that you create on the node stay there after pump has returned, and still exist in the next "
            "call.",
            "Don't create them, or remove them before you return. For a timer, call node.destroy_timer(timer).",
        )
    if first.startswith("job"):
        return see.failed(
            "nothing-left-running.cut-off",
            saw,
            "a callback that has started finishes before pump returns",
            "Something ended the callback halfway: a signal, or an exception from another thread.",
            "Check the clock between two callbacks, and let a running callback finish.",
        )
    if "thread" in first:
        return thread_left(saw)
    if first in ("rclpy.init called", "node made"):
        return see.failed(
            "nothing-left-running.not-its-own",
            f"in call {call}: {first}",
            "pump creates no node and doesn't call rclpy.init",
            "The program that calls pump has already done both.",
            "Use the node that was passed to pump.",
        )
    return see.failed(
        "nothing-left-running.changed",
        saw,
        expected,
        "The timers and subscriptions belong to the node. Don't cancel, restart, change, or destroy them.",
        "Only spin the node: rclpy.spin_once(node, timeout_sec=...).",
    )


# --- the calls, and what was done in each -------------------------------------------------------------------


@dataclass(frozen=True)
class Call:
    """One call of `pump`: when it began and came back (s of wall time), how long it took (s), what it raised.

    `processor_s`: for how long the program used a processor; `in_line_s`: for how long the thread that called `pump`
    was ready to run and got none; `taken_s`: for how long the host of a virtual machine took a processor away.
    """

    begin: float
    end: float | None = None
    took: float | None = None
    raised: str | None = None
    processor_s: float = 0.0
    in_line_s: float = 0.0
    taken_s: float = 0.0

    @property
    def kept_waiting_s(self) -> float:
        """How long (s) the machine kept the program waiting in this call."""
        return self.in_line_s + self.taken_s

    @property
    def processor_share(self) -> float:
        """Share of one processor (1.0: all of it) that was used while there was one: on a busy machine, too."""
        had_one = max((self.took or 0.0) - self.in_line_s, self.processor_s)
        return self.processor_s / had_one if had_one > 0.0 else 0.0


ANNOUNCEMENT = re.compile(
    r"(begin (?P<begun>\d{1,9})|raised (?P<failed>\d{1,9}) (?P<raised>.*)"
    r"|end (?P<ended>\d{1,9})(?P<end>( \d{1,9}(\.\d{1,9})?){1,4}))",
    re.DOTALL,
)
"""What the driver announces. Others may publish there, too."""


def calls(recording: Recording) -> dict[int, Call]:
    """The calls of `pump` by their number, as the driver announced them."""
    found: dict[int, Call] = {}
    for arrival in recording.topic(PUMP.name).arrivals:
        said = ANNOUNCEMENT.fullmatch(str(arrival.value.get("data")))
        if said is None:
            continue
        number = int(said["begun"] or said["failed"] or said["ended"])
        call = found.setdefault(number, Call(arrival.published))
        if said["raised"] is not None:
            found[number] = replace(call, raised=said["raised"])
        elif said["end"] is not None and call.end is None:
            took, used, in_line, taken = (*map(float, said["end"].split()), 0.0, 0.0, 0.0)[:4]
            ended = finished(call, arrival.published, took)
            found[number] = replace(ended, processor_s=used, in_line_s=in_line, taken_s=taken)
    return found


def finished(call: Call, end: float, took: float) -> Call:
    """The call with its end. What the driver measured is more exact than when its words arrived, and must fit them."""
    if abs(end - call.begin - took) > DELAY_S:
        took = end - call.begin
    return replace(call, begin=min(call.begin, end - took), end=end, took=took)


def numbers_for(recording: Recording, name: str) -> list[int]:
    """The numbers that the judge has for a robot on a topic, in order, without those that are not judged."""
    return [one.value["data"] for one in see.script(recording, name) if one.value["data"]]


def waiting_words(recording: Recording) -> set[int]:
    """The words that come between the first call and the second."""
    return {*numbers_for(recording, "/robot/words")[BURST_WORDS:]}


def done_in(recording: Recording, name: str, call: int) -> list[int]:
    """The numbers that a robot reported on a topic for a call, in the order of their arrival."""
    return [number for told, number in reports(recording, name) if told == call]


def reports(recording: Recording, name: str) -> list[tuple[int, int]]:
    """What a robot reported on a topic, in the order of arrival: the call, and a number."""
    return [(call, number) for _, call, number in reported(recording, name)]


def reported(recording: Recording, name: str) -> list[tuple[float, int, int]]:
    """The same, each with when it was published (s of wall time). What no robot says there is left out."""
    found = []
    for arrival in recording.topic(name).arrivals:
        match arrival.value:
            case {"data": [int(call), int(number)]}:
                found.append((arrival.published, call, number))
    return found


def heartbeats(recording: Recording, call: int) -> list[float]:
    """When the robot published a heartbeat in a call (s of wall time)."""
    return [at for at, told, _ in reported(recording, HEARTBEAT.name) if told == call]


def longest_silence(recording: Recording) -> float:
    """The longest time (s) without a heartbeat in the first call, from its begin to its end."""
    call = calls(recording)[BURST]
    beats = heartbeats(recording, BURST)
    end = call.end if call.end is not None else recording.wall_s
    return max((after - before for before, after in pairwise(sorted([call.begin, *beats, end]))), default=0.0)


def kept_waiting(recording: Recording, number: int) -> float:
    """How long (s) the machine kept program or judge waiting in a call: no answer is late for that."""
    call = calls(recording).get(number)
    in_call = call.kept_waiting_s if call is not None else 0.0
    return in_call + max(recording.held_up_s, recording.stood_still_s)


# --- what may be wrong with a call --------------------------------------------------------------------------


def first_call_raised(recording: Recording, raised: str) -> Verdict:
    """The first call raised an error."""
    expected = f"pump(node, {ASKED_S[BURST]}) runs without an error"
    saw = f"pump raised {raised}"
    return see.failed_in_call(recording, saw, expected) or see.failed(
        "pump.raises",
        saw,
        expected,
        "Your function raised an exception and didn't catch it.",
        "Read the last lines of the log from the bottom up.",
    )


def not_made(recording: Recording, number: int) -> Verdict | None:
    """Why a call was not made, or could not do its work; None if it could."""
    expected = f"pump(node, {ASKED_S[number]}) returns when the time is up"
    call = calls(recording).get(number)
    if call is None:
        return see.program_ended(recording, "this call was never made", expected) or see.failed(
            "call.never-begun",
            "the previous call never returned",
            expected,
            "Something waits forever.",
            "Give every wait the same short timeout_sec, for example 0.05 s.",
        )
    if call.raised is not None:
        return see.failed(
            "call.raises-later",
            f"call 1 raised no exception, but call {number} raised {call.raised}",
            expected,
            "Something no longer existed when pump was called again: the node or a part of it, its executor, or the "
            "ROS context.",
            "Leave the node and the context unchanged. Don't destroy the node or a part of it, and don't shut down "
            "the context.",
        )
    return None


def in_time(recording: Recording, number: int, extra: float = 0.0) -> Verdict:
    """The call took as long as asked; `extra` seconds more are granted on top of what is granted anyway."""
    lost = not_made(recording, number)
    if lost is not None:
        return lost
    call, asked = calls(recording)[number], ASKED_S[number]
    if call.took is None:
        open_s = recording.wall_s - call.begin
        if open_s < asked + extra + LATE_S:
            return see.passed("the judge stopped watching before its time was up")
        return still_open(recording, asked, open_s)
    if call.took < asked - EARLY_S:
        return (
            ended_by_what_was_left(recording, number, call.took)
            or ended_by_silence(recording, number, call.took)
            or ended_by_job(recording, number, call.took)
            or too_early(number, call.took)
        )
    if call.took > asked + extra + LATE_S + kept_waiting(recording, number):
        return too_late(number, call.took)
    return see.passed(f"called with {asked} s, took {call.took:.2f} s")


def ended_early(recording: Recording, took: dict[int, float]) -> Verdict | None:
    """The first call came back too early, each of them did, or the shortest ones alone; None if none did."""
    ahead = {n: ASKED_S[n] - seconds for n, seconds in took.items()}
    early = next((n for n, seconds in ahead.items() if seconds > EARLY_S), None)
    if early is None:
        return None
    if subtracted(ahead):
        return see.failed(
            "in-time.subtracted",
            f"called with {ASKED_S[BURST]:g} s and {ASKED_S[AGAIN]:g} s, returned {ahead[BURST]:.2f} s and "
            f"{ahead[AGAIN]:.2f} s too early",
            IN_TIME,
            "Both calls are shorter by about the same time. Your function subtracts a constant, or it doesn't "
            "start a wait that would exceed the end time.",
            "Store time.monotonic() + seconds at the start, and continue until that time.",
        )
    if ahead.get(BURST, math.inf) > EARLY_S or all(seconds > AHEAD_S for seconds in ahead.values()):
        return too_early(early, took[early])
    others = [seconds for n, seconds in ahead.items() if n not in SHORT_CALLS]
    shorts = [ahead.get(n, 0.0) for n in (SHORT, SHORT_TOO)]
    left = any(one.endswith("left") for one in see.driver_reports(recording, CHANGED))
    if left or max(others) > EARLY_S or max(shorts) <= EARLY_S:
        return None
    return see.failed(
        "in-time.short-calls",
        f"called with {ASKED_S[SHORT]:g} s, returned after {ASKED_S[SHORT] - max(shorts):.2f} s; longer calls took "
        "their full time",
        IN_TIME,
        "Your function handles short times differently, or it divides the time into whole steps and rounds down.",
        "Store time.monotonic() + seconds at the start, and continue until that time.",
    )


def nothing_handled(recording: Recording) -> Verdict | None:
    """The calls after the second did nothing, though a timer was due; None if they did, or could not."""
    made = [call for n, call in calls(recording).items() if n in SHORT_CALLS and call.end is not None]
    waited = max(recording.held_up_s, recording.stood_still_s) + sum(call.kept_waiting_s for call in made)
    if len(made) < len(SHORT_CALLS) or waited > LATE_S:
        return None
    if any(done_in(recording, one.name, n) for one in (HEARTBEAT, LOOK) for n in SHORT_CALLS):
        return None
    if not done_in(recording, HEARTBEAT.name, AGAIN):
        return None
    if any("timer reset" in one for one in see.driver_reports(recording, CHANGED)):
        return see.failed(
            "again.timers-reset",
            f"no callback ran in {len(SHORT_CALLS)} calls of {ASKED_S[SHORTEST]:g} to {ASKED_S[SHORT]:g} s, and timers "
            "were reset",
            "every ready callback runs, even in a short call",
            "Each call resets the timers, so none of them is due before a short call is over.",
            "Don't reset the node's timers. They keep their schedule between calls.",
        )
    return see.failed(
        "again.short-calls-do-nothing",
        f"no callback ran in {len(SHORT_CALLS)} calls of {ASKED_S[SHORTEST]:g} to {ASKED_S[SHORT]:g} s, although a "
        "heartbeat was due",
        "every ready callback runs, even in a short call",
        "Your function handles short times differently: it only sleeps, or it runs out of time before it spins.",
        "Spin first, and then check the clock, no matter how short the call is.",
        about_time=True,
    )


def why_less_again(recording: Recording) -> Verdict:
    """Whether the second call handled what waited, and let the timers tick; if not, why."""
    told = [*done_in(recording, HEARD.name, BURST), *done_in(recording, HEARD.name, AGAIN)]
    got = set(told) & waiting_words(recording)
    beats = done_in(recording, HEARTBEAT.name, AGAIN)
    saw = f"{len(got)} of {WAITING_WORDS} waiting words and {len(beats)} heartbeats in the second call"
    if len(got) == WAITING_WORDS and len(beats) >= A_FEW_BEATS:
        return see.passed(saw)
    return why_not_again(recording, len(beats), saw)


def why_not_again(recording: Recording, beats: int, saw: str) -> Verdict:
    """Why the second call did less than the first one; `beats`: how many heartbeats there were in it."""
    expected = "the words waiting in the queue are handled, and the timers fire again"
    if waiting_words(recording) & set(done_in(recording, HEARD.name, BETWEEN)):
        return see.failed(
            "again.handled-before",
            f"{saw}; words were handled between the calls",
            expected,
            "The first call left a thread behind that takes the callbacks.",
            "End every thread before you return, or spin in the thread that called pump.",
        )
    if beats < A_FEW_BEATS and any("canceled" in one for one in see.driver_reports(recording, CHANGED)):
        return see.failed(
            "again.timers-canceled",
            f"{saw}; the first call canceled timers",
            expected,
            "A canceled timer doesn't fire in the next call.",
            "The timers belong to the node. Don't cancel, restart, or destroy them.",
        )
    if beats >= A_FEW_BEATS:
        return see.failed(
            "again.words-lost",
            saw,
            expected,
            "The words waited in the queue but were dropped: your function takes messages itself, or it re-creates "
            "subscriptions. Or it handles too few callbacks.",
            "Don't change the subscriptions, and let spin_once call their callbacks.",
            about_time=True,
        )
    return see.failed(
        "again.does-nothing",
        saw,
        expected,
        "The first call destroyed the node or the executor, shut down ROS, or left a thread behind that takes the "
        "callbacks. Or a future or a flag from the first call is still marked as done.",
        "Don't destroy or shut down anything that you didn't create. Create new executors and futures in each "
        "call, and shut your executor down in the same call.",
        about_time=True,
    )


def ended_by_what_was_left(recording: Recording, number: int, took: float) -> Verdict | None:
    """The call came back too early, and an earlier one has left something on the node; None if it has not."""
    left = next((one for one in see.driver_reports(recording, CHANGED) if one.endswith("left")), None)
    if left is None:
        return None
    call, _, what = left.partition(" ")
    return see.failed(
        "in-time.ended-by-what-was-left",
        f"called with {ASKED_S[number]:g} s, returned after {took:.2f} s; after call {call}: {what}",
        IN_TIME,
        "An object that an earlier call left on the node is still active, and it ends this call.",
        "Destroy what you created on the node before you return: node.destroy_timer(timer).",
    )


def ended_by_silence(recording: Recording, number: int, took: float) -> Verdict | None:
    """Only the call with the quiet robot came back too early, and before a callback ran; None if it is otherwise."""
    first = calls(recording)[BURST].took
    if number != QUIET or done_in(recording, QUIET_HEARD.name, QUIET):
        return None
    if first is None or first < ASKED_S[BURST] - EARLY_S:
        return None
    return see.failed(
        "in-time.ended-by-silence",
        f"called with {ASKED_S[number]:g} s, returned after {took:.2f} s; no callback had been ready until then",
        IN_TIME,
        "Your function returns if no callback is ready for a while. But a callback may be ready later.",
        "Continue until the time is up, even if nothing is ready.",
    )


def ended_by_job(recording: Recording, number: int, took: float) -> Verdict | None:
    """Only the call with slow jobs came back too early, after one of them; None if it is otherwise."""
    first = calls(recording)[BURST].took
    begun = done_in(recording, JOB_BEGUN.name, SLOW)
    if number != SLOW or not begun or first is None or first < ASKED_S[BURST] - EARLY_S:
        return None
    return see.failed(
        "in-time.ended-by-job",
        f"called with {ASKED_S[number]:g} s, returned after {took:.2f} s and {see.count(len(begun), 'job')} of "
        f"{JOB_S} s; the first call, without slow jobs, took its full time",
        IN_TIME,
        "After a slow callback, your function returns early. It assumes that a long spin_once call means that "
        "nothing was ready, or it counts the callback's time twice.",
        "Store time.monotonic() + seconds at the start, and continue until that time.",
    )


def subtracted(ahead: dict[int, float]) -> bool:
    """Whether the longer calls came back too early by the same time, whatever they were asked for."""
    long = [seconds for n, seconds in ahead.items() if n in (BURST, AGAIN)]
    return len(long) > 1 and min(long) > EARLY_S and max(long) - min(long) < EARLY_S / 2.0


def too_early(number: int, took: float) -> Verdict:
    """The call came back too early."""
    return see.failed(
        "in-time.too-early",
        f"called with {ASKED_S[number]:g} s, returned after {took:.2f} s",
        IN_TIME,
        "Your function counts callbacks instead of time: spin_once returns as soon as one callback has run. Or it "
        "shortens the time by a factor, a limit, or a wrong unit.",
        "Store time.monotonic() + seconds at the start, and continue until that time.",
    )


IN_TIME = f"return when the time is up: at most {EARLY_S} s earlier, at most {LATE_S} s later"
TIME_THAT_IS_LEFT = (
    "Compute the end once, and check the clock before each spin_once. "
    "Give it a short timeout_sec, for example 0.05 s."
)


def still_open(recording: Recording, asked: float, open_s: float) -> Verdict:
    """The call was not back when the watch ended, `open_s` seconds after its begin."""
    expected = f"return after {asked} s"
    return see.program_ended(recording, "this call never returned", expected) or see.failed(
        "in-time.not-back",
        f"no return {open_s - asked:.1f} s after its time was up",
        expected,
        "Without a timeout, spin_once waits until a callback is ready, possibly forever. Or a timeout that "
        "restarts after each callback adds up.",
        TIME_THAT_IS_LEFT,
        about_time=True,
    )


def too_late(number: int, took: float) -> Verdict:
    """The call took too long."""
    saw, expected = f"returned after {took:.2f} s", f"back after {ASKED_S[number]} s"
    if number == QUIET:
        return see.failed(
            "in-time.wait-begins-anew",
            saw,
            expected,
            "A wait continued beyond the end time. It restarted with its full length after a callback, your "
            "function sleeps, or it postpones the end time.",
            TIME_THAT_IS_LEFT,
            about_time=True,
        )
    return see.failed(
        "in-time.callbacks-not-counted",
        saw,
        expected,
        "Your function doesn't count the time that callbacks take, or it handles everything before it checks the "
        "clock.",
        TIME_THAT_IS_LEFT,
        about_time=True,
    )
