"""How exercise 12 is judged: what it asks, what it says of each answer, and whether its heart goes on meanwhile."""

import random
import statistics
from bisect import bisect_left
from collections.abc import Sequence
from dataclasses import dataclass
from itertools import pairwise

from std_msgs.msg import String
from std_srvs.srv import Trigger

import workbook.criteria as see
from workbook.criteria import CallSeen, Recording, Verdict, criterion, program_runs, topic, watching

SERVICE = "/robot/self_test"
HEALTH = topic("/robot/health", String)
HEARTBEAT = topic("/robot/heartbeat", String, hz=5.0)
WORDS = {True: "ok", False: "faulty"}
NO_ANSWER = "no answer"

AT_ONCE, SLOW, NEVER = 0.0, 0.7, None
LEAST_CALLS = 4  # the fourth is the first one that may get no answer
WATCH_S = 12.5
JOINTS = ("left knee", "right knee", "left elbow", "right elbow", "left hip", "neck")


def drawn(rng: random.Random) -> list[see.Part]:
    """Draw twelve replies, for one call after another.

    First three answers: "ok", one of the two words, and "faulty", late. So a word comes twice in a row. No answer comes
    at once after a late one, nor late after a late "faulty". Then four calls get no answer, two of them in a row. After
    each of the other two comes an answer at once: a report that waits for the earlier call is late twice. After the two
    in a row comes a late one: nothing comes between the moments when they are given up. The last reply is for all calls
    after it, too.
    """
    after_three = [[NEVER, AT_ONCE], [NEVER, AT_ONCE, SLOW], [NEVER, NEVER, SLOW]]
    rng.shuffle(after_three)
    delay, success = rng.choice(((AT_ONCE, True), (AT_ONCE, False), (SLOW, True)))
    delays = [AT_ONCE, delay, SLOW, *(one for some in after_three for one in some), AT_ONCE]
    successes = [True, success, False, *(rng.random() < 0.5 for _ in delays[3:-1]), False]
    at_once = [place for place, one in enumerate(delays[:-1]) if one == AT_ONCE and place > 2]
    successes[rng.choice(at_once)] = False
    plain = [False, True, False, *(rng.random() < 0.5 for _ in delays[3:])]
    replies = [
        ({"success": success, "message": text_for(rng, success, is_plain)}, delay)
        for success, is_plain, delay in zip(successes, plain, delays, strict=True)
    ]
    return [see.serves(SERVICE, Trigger, replies)]


def text_for(rng: random.Random, success: bool, is_plain: bool) -> str:
    """Write a text for people. Only if it `is_plain`, one can see in it how the test went."""
    if success is is_plain:
        return "all joints move"
    return f"the {rng.choice(JOINTS)} is {'warm' if success else 'stiff'}"


WATCH = watching(wall_seconds=WATCH_S, script=drawn)

SHORTEST_PERIOD_S, LONGEST_PERIOD_S = 0.9, 1.1
LONGEST_PAUSE_S = 2.5  # after a call without an answer
PAUSE_S, PAUSES = 1.4, 1  # after other calls: as many may be longer
TOLD_WITHIN_S = 0.8
BELONGS_S = 1.6  # told later than that, it is taken for the report of another answer
MAY_TAKE_S = 0.8
GIVEN_UP_AT_ONCE_S = 1.3  # with the next question, or a moment later
GIVEN_UP_WITHIN_S = 2.0
SLACK_S = 0.1  # for a busy machine
NEARLY_S = 0.03  # the same, where each call is given up too early
LATE_ONES = 2  # calls given up equally late: of one it cannot be told
LONG_SLACK_S = 0.3  # the same, where an asking period and a patience add up
SOONEST_S, LATEST_S = MAY_TAKE_S - SLACK_S, GIVEN_UP_WITHIN_S + LONG_SLACK_S  # when a call is given up
MOST, A_LOT = 2000, 200  # calls, and reports, that are looked at, and for whose faults we look for the cause
MAY_COME_UNTIL_S = MAY_TAKE_S + 0.05
MOSTLY = 0.7
AT_ONCE_S = (
    0.05  # so soon after another call or an answer, a call was sent together with it, or because of it
)
WAITED_IN_VAIN_S = 0.3  # so long after the answer, the callback that reads the result had waited for it
LEAST_SHARE, MOST_SHARE = 0.9, 1.1  # of the beats that are due
LEAST_MEANWHILE = 0.6  # of the beats that are due while a call is open: one that waits loses all of them
LEAST_DUE = 1.0  # of fewer beats nothing can be told
SHORTEST_BEAT_S, LONGEST_BEAT_S = 0.18, 0.22
STOPPED_S = 0.9
EDGE_S = 0.05
FEW_CALLS = 2  # fewer calls after the last beat do not show that the rest goes on
AT_ONCE_S = 0.05  # from one report to the next
EARLY_S = 0.1  # what was asked before the watch began waited for it; how long, nobody knows
FIRST_SECONDS_S = 2.5  # a call from before the watch may be given up until then


@criterion(points=1, title="The program is still alive at the end", needs=[program_runs])
def alive_at_end(recording: Recording) -> Verdict:
    verdict = see.alive_at_end(recording)
    if "'NoneType' object has no attribute 'success'" not in verdict.saw:
        return verdict
    waited = [recording.simulated_s - call.t for call in asked(recording) if call.answered_t is None]
    if max(waited, default=0.0) > MAY_TAKE_S:
        return see.failed(
            "alive-at-end.result-of-none",
            verdict.saw,
            verdict.expected,
            "Without a response, there is no result: future.result() is None, and call() returns None after its "
            "timeout.",
            f'Publish "{NO_ANSWER}" if the response is None. Read its field success only if it isn\'t.',
        )
    last = max(asked(recording), key=lambda call: call.t, default=None)
    if last is not None and last.answered_t is not None:
        lag = recording.simulated_s - last.answered_t
        if lag > WAITED_IN_VAIN_S:
            return waited_in_vain(verdict, lag)
    return see.failed(
        "alive-at-end.result-too-early",
        verdict.saw,
        verdict.expected,
        "call_async() returns right away, before the response arrives. Until then, future.result() is None.",
        "Read the result in a done callback: future.add_done_callback(self.on_answer).",
    )


@criterion(points=1, title="Calls of /robot/self_test arrive, again and again", needs=[program_runs])
def calls_arrive(recording: Recording) -> Verdict:
    first = see.calls_service(recording, SERVICE, "std_srvs/srv/Trigger")
    if not first.ok:
        return first
    calls = asked(recording)
    if len(calls) >= LEAST_CALLS:
        return see.passed(f"{len(calls)} calls")
    return why_few_calls(recording, calls)


@criterion(
    points=1,
    title="It calls once a second, and continues after a call without a response",
    needs=[calls_arrive, alive_at_end],
)
def asks_every_second(recording: Recording) -> Verdict:
    calls = [call for call in asked(recording) if call.t >= EARLY_S]
    times = [call.t for call in calls]
    pauses = [
        (b - a, call) for (a, b), call in zip(pairwise([*times, recording.simulated_s]), calls, strict=True)
    ]
    long = [
        (pause, call)
        for pause, call in pauses
        if pause > (PAUSE_S if call.answered_t is not None else LONGEST_PAUSE_S)
    ]
    if any(pause > LONGEST_PAUSE_S for pause, _ in long):
        return why_a_pause(recording, *max(long, key=lambda one: one[0]))
    typical = (
        statistics.median(b - a for a, b in pairwise(times)) if len(times) > 1 else recording.simulated_s
    )
    if typical < SHORTEST_PERIOD_S:
        return why_too_often(recording, calls, typical)
    if typical > LONGEST_PERIOD_S or len(long) > PAUSES:
        return why_seldom(recording, typical, long)
    if len(times) - 1 > round((times[-1] - times[0]) / SHORTEST_PERIOD_S):
        return why_calls_between(calls)
    return see.passed(f"{len(times)} calls, typically {typical:.1f} s apart")


@criterion(points=1, title="/robot/health carries String, and only the three words", needs=[program_runs])
def health_topic(recording: Recording) -> Verdict:
    exists = see.publishes(recording, HEALTH)
    if not exists.ok or not recording.topic(HEALTH.name).arrivals:
        return exists
    return see.one_of(recording, HEALTH, {*WORDS.values(), NO_ANSWER})


@criterion(
    points=2,
    title="Each response is reported: correctly, in time, and once",
    needs=[calls_arrive, health_topic],
)
def results_told(recording: Recording) -> Verdict:
    fitting = told_answers(recording)
    if fitting is None:
        return why_results_do_not_fit(recording)
    late = told_late(fitting)
    if len(late) > 1:
        return why_late(recording, late, len(fitting))
    return see.passed(f"{len(fitting)} responses reported")


@criterion(
    points=2,
    title='"no answer" is reported in time, and only for calls that got no response',
    needs=[calls_arrive, health_topic, alive_at_end],
)
def unanswered_told(recording: Recording) -> Verdict:
    untold, in_vain = given_up_in_vain(recording)
    if untold:
        return why_not_given_up(recording, untold[0], [t for t in in_vain if t > untold[0].t])
    waited = given_up_after(recording)
    if len(waited) > 1 and max(waited) < MAY_TAKE_S - NEARLY_S:
        return why_always_early(waited)
    in_vain = [t for t in in_vain if t > FIRST_SECONDS_S]
    if len(in_vain) == 1 and any(given_up_a_moment_early(recording, one) for one in answers_in(recording)):
        in_vain = []  # a very busy machine
    if not in_vain:
        return see.passed(f'"{NO_ANSWER}" for each call without a response, and no false alarm')
    return why_given_up(recording, in_vain)


@criterion(points=2, title="The heartbeat comes at 5 Hz, whatever happens to a call", needs=[alive_at_end])
def heartbeat_steady(recording: Recording) -> Verdict:
    exists = see.all_of(
        see.publishes(recording, HEARTBEAT), see.no_message(recording, HEARTBEAT) or see.passed("it beats")
    )
    if not exists.ok:
        return exists
    wrong = comes_in_bursts(recording) or stops_for_good(recording) or stops_during_a_call(recording)
    if wrong is not None:
        return wrong
    beats = see.beats(recording, HEARTBEAT)
    typical = beats.typical_s
    if not SHORTEST_BEAT_S <= typical <= LONGEST_BEAT_S:
        return see.failed(
            "heartbeat-steady.other-period",
            "only one beat" if beats.count == 1 else f"typically a beat every {typical:.2g} s",
            FIVE_HERTZ,
            "The timer has a different period. Or a loop sleeps for a full period in addition to its work.",
            "5 Hz is a period of 0.2 s: create_timer(0.2, self.beat), with one publish() in it.",
            about_time=True,
        )
    if not LEAST_SHARE <= beats.share <= MOST_SHARE:
        return why_too_few_or_many(beats)
    return see.passed(f"{beats.count} beats, typically one every {typical:.1f} s")


def waited_in_vain(verdict: Verdict, lag: float) -> Verdict:
    """The program ended because a result was None, `lag` seconds after the answer to its last call had come."""
    return see.failed(
        "alive-at-end.waited-in-vain",
        f"{verdict.saw}; the response to the last call had arrived {lag:.1f} s earlier",
        verdict.expected,
        "A callback waited for this response, or spun the node itself, until its timeout. But rclpy can handle the "
        "response only after the callback has returned, so future.result() was still None.",
        "Send the request with call_async(), add a done callback, and return. Do not wait or spin in a callback.",
    )


# --- the calls ----------------------------------------------------------------------------------------------

ONCE_A_SECOND = (
    f"a call every second, typically {SHORTEST_PERIOD_S} to {LONGEST_PERIOD_S} s after the last one"
)


def asked(recording: Recording) -> list[CallSeen]:
    """The calls of the program, in the order of their coming."""
    return [call for call in see.calls_of(recording, SERVICE) if call.by == "program"][:MOST]


def why_few_calls(recording: Recording, calls: list[CallSeen]) -> Verdict:
    """Why so few calls came."""
    last = calls[-1]
    expected = f"a call every second, so {LEAST_CALLS} or more in {WATCH_S:.0f} s"
    how_many = "only one call" if len(calls) == 1 else f"{len(calls)} calls"
    if recording.process.ended_by == "itself":
        return see.failed(
            "calls-arrive.ended",
            f"{how_many} before the program ended",
            expected,
            "A program that has ended sends no more requests.",
            "First, find out why it ended.",
        )
    blamed = see.failed_by_error(recording, how_many, expected)
    if blamed is not None:
        return blamed
    if last.answered_t is not None and recording.simulated_s - last.t > LONGEST_PAUSE_S:
        return why_no_more(recording, last, how_many, expected)
    return see.failed(
        "calls-arrive.too-few",
        f"{how_many} in {recording.simulated_s:.0f} s",
        expected,
        "The timer that sends the requests is too slow, or something delays it.",
        "Use create_timer(1.0, self.ask), and let ask() return right away.",
        about_time=True,
    )


def why_no_more(recording: Recording, last: CallSeen, how_many: str, expected: str) -> Verdict:
    """Why a program that still runs asked no more after its `last` call, which was answered."""
    answered_t = last.answered_t or last.t
    reported = any(t >= answered_t for t, _ in told(recording, *WORDS.values(), NO_ANSWER))
    if reported and is_alive(recording) and last is not asked(recording)[0]:
        return see.failed(
            "calls-arrive.stops",
            f"{how_many}: the call at {last.t:.1f} s was answered at {answered_t:.1f} s and reported, but no other "
            "call followed",
            expected,
            "The response was handled, so nothing is still waiting for it. The requests are limited in number, or "
            "their timer is canceled, perhaps because of the response.",
            "Send a request on every tick of the timer, no matter what the responses contain.",
        )
    if is_alive(recording):
        return see.failed(
            "calls-arrive.asks-no-more",
            f"{how_many}, the last one at {last.t:.1f} s, answered at {answered_t:.1f} s",
            expected,
            "Your node sends a request only once and not from a timer. Or the callback is still waiting for the "
            "response, because the client and the callback share a callback group.",
            "Send the requests from a timer, don't wait in its callback, and read the response in a done callback.",
        )
    return why_nothing_more(last.t, answered_t, reported, (how_many, expected))


def why_nothing_more(asked_t: float, answered_t: float, reported: bool, words: tuple[str, str]) -> Verdict:
    """Why nothing at all came after the last call; `words`: how many calls there were, and what is expected."""
    how_many, expected = words
    if reported:
        return see.failed(
            "calls-arrive.lost-its-executor",
            f"{how_many}: the call at {asked_t:.1f} s was answered at {answered_t:.1f} s and reported, but then "
            "your node did nothing more",
            expected,
            "The callback received the response, so there was no deadlock. rclpy.spin_until_future_complete(node, "
            "future) in a callback takes the node away from its executor. After that, nothing spins the node.",
            "Don't spin in a callback. Use call_async(), then add_done_callback(), and return.",
        )
    return see.failed(
        "calls-arrive.deadlock",
        f"{how_many}: the call at {asked_t:.1f} s was answered at {answered_t:.1f} s, but then your node did "
        "nothing more",
        expected,
        "The callback that sends the request waits for the response. But rclpy can handle the response only when "
        "the client's callback group and a thread are free. That's a deadlock.",
        "Don't wait in the callback. Use call_async(), then add_done_callback(), and return.",
    )


def is_alive(recording: Recording) -> bool:
    """Whether anything at all was published in the last second of the watch."""
    ends = [topic.arrivals[-1].t for topic in recording.with_publishers() if topic.arrivals]
    return max(ends, default=0.0) > recording.simulated_s - 1.0


def why_a_pause(recording: Recording, longest: float, before: CallSeen) -> Verdict:
    """Why no call came for `longest` seconds, after the call `before`."""
    saw = f"after the call at {before.t:.1f} s, there was no call for {longest:.1f} s"
    blamed = see.failed_by_error(recording, saw, ONCE_A_SECOND)
    if blamed is not None:
        return blamed
    earlier = next((call for call in asked(recording) if call.response is None), before)
    to_the_end = before.t + longest >= recording.simulated_s - EDGE_S
    if before.response is None and to_the_end and earlier is not before:
        return see.failed(
            "asks-every-second.stops-at-a-later-one",
            f"there were no more calls after the one at {before.t:.1f} s, which got no response. But the calls "
            f"continued after the one at {earlier.t:.1f} s, which got no response either",
            ONCE_A_SECOND,
            "The requests stop after some number of calls, or after some number of calls without a response.",
            "Send a request on every tick of the timer, without end.",
            about_time=True,
        )
    if before.response is None:
        return see.failed(
            "asks-every-second.waits-for-unanswered",
            f"after the call at {before.t:.1f} s, which got no response, there was no call for {longest:.1f} s",
            ONCE_A_SECOND,
            "After a call without a response, your node sends no more requests, or skips more than one. It's still "
            "waiting for a response that will never arrive, or it pauses.",
            "Give up an open call when the next one is due: remove_pending_request(future), then send the next "
            "request.",
            about_time=True,
        )
    return why_a_pause_after_an_answer(recording, longest, before, saw)


def why_a_pause_after_an_answer(recording: Recording, longest: float, before: CallSeen, saw: str) -> Verdict:
    """The same, where the call `before` was answered."""
    gave_up = [t for t, _ in told(recording, NO_ANSWER) if -EARLY_S <= t - before.t <= 1.0]
    if gave_up:
        return see.failed(
            "asks-every-second.stops-after-no-answer",
            f'{saw}; your node had published "{NO_ANSWER}" at {gave_up[0]:.1f} s',
            ONCE_A_SECOND,
            "After giving up on a call, your node sends no more requests, or skips more than one. Or the requests "
            "are limited in number, and this was the last one.",
            "Forget the abandoned call, and send the next request when it's due.",
            about_time=True,
        )
    if before.t + longest >= recording.simulated_s - EDGE_S:
        return see.failed(
            "asks-every-second.stops",
            f"{len(asked(recording))} calls, the last one at {before.t:.1f} s, then none until "
            f"{recording.simulated_s:.1f} s",
            ONCE_A_SECOND,
            "The requests stop, although the last call was answered. They are limited in number, the timer is "
            "canceled, or the callback that sends them doesn't return.",
            "Send a request on every tick of the timer, without end.",
            about_time=True,
        )
    return see.failed(
        "asks-every-second.pause",
        saw,
        ONCE_A_SECOND,
        "Something delays the timer that sends the requests.",
        "Let the method that sends the request return right away.",
        about_time=True,
    )


def why_seldom(recording: Recording, typical: float, long: list[tuple[float, CallSeen]]) -> Verdict:
    """Why a program that goes on asking asks less than once a second."""
    after_slow = [
        call for _, call in long if call.answered_t is not None and call.answered_t - call.t > SLOW / 2
    ]
    saw = f"typically {typical:.2g} s from one call to the next"
    if stops_during_a_call(recording) is not None:
        return see.failed(
            "asks-every-second.waits-in-callback",
            f"{saw}; while a call is open, the heartbeat stops, too",
            ONCE_A_SECOND,
            "The callback that sends the request waits for the response for longer than its timer's period. While "
            "it waits, no other callback runs: neither the heartbeat's nor the one that handles the response.",
            "Send the request with call_async(), add a done callback, and return. Do not spin or sleep in a callback.",
            about_time=True,
        )
    if after_slow and len(after_slow) == len(long):
        return see.failed(
            "asks-every-second.waits-for-answer",
            f"{saw}; {long[0][0]:.1f} s after the call at {long[0][1].t:.1f} s, whose response was slow",
            ONCE_A_SECOND,
            "The next request waits for the response to the last one, and then for one more second.",
            "Use create_timer(1.0, self.ask), and let ask() return right away.",
            about_time=True,
        )
    return see.failed(
        "asks-every-second.too-seldom",
        saw
        if typical > LONGEST_PERIOD_S
        else f"{len(long)} pauses of {min(p for p, _ in long):.1f} s or longer",
        ONCE_A_SECOND,
        "The timer that sends the requests has too long a period, or something delays it again and again.",
        "Use create_timer(1.0, self.ask), and let ask() return right away.",
        about_time=True,
    )


def why_too_often(recording: Recording, calls: list[CallSeen], typical: float) -> Verdict:
    """Why calls come typically sooner than they should: several at once, after an answer, or by a short period."""
    how_many = f"{len(asked(recording))} calls in {recording.simulated_s:.0f} s"
    groups = sizes_of_groups(calls)
    together = statistics.mode(groups)
    if together > 1 and groups.count(together) > MOSTLY * len(groups):
        return see.failed(
            "asks-every-second.several-at-once",
            f"{how_many}, {together} at a time",
            ONCE_A_SECOND,
            "Several requests are sent at the same moment: by two timers, by two clients, or twice in one callback.",
            "Keep one client, one 1.0 s timer, and one call_async() in its callback.",
        )
    saw = f"{how_many}, typically {typical:.2g} s apart"
    short = [(a, b) for a, b in pairwise(calls) if b.t - a.t < SHORTEST_PERIOD_S]
    after_answers = [
        b for a, b in short if a.answered_t is not None and 0.0 <= b.t - a.answered_t < AT_ONCE_S
    ]
    if len(after_answers) > MOSTLY * len(short):
        return see.failed(
            "asks-every-second.asks-after-an-answer",
            f"{saw}; {len(after_answers)} of them followed a response immediately",
            ONCE_A_SECOND,
            "Each response triggers another call: the code that handles the response sends a request, too.",
            "Send requests only from a 1.0 s timer, no matter what a response contains.",
        )
    return why_a_short_period(calls, typical, saw)


def sizes_of_groups(calls: list[CallSeen]) -> list[int]:
    """How many calls came together each time."""
    sizes = [1]
    for before, after in pairwise(calls):
        if after.t - before.t < AT_ONCE_S:
            sizes[-1] += 1
        else:
            sizes.append(1)
    return sizes


def why_a_short_period(calls: list[CallSeen], typical: float, saw: str) -> Verdict:
    """Calls come one by one, not because of an answer, and typically too soon."""
    alike = [one for one in pairwise(calls) if abs(one[1].t - one[0].t - typical) < 0.1 * typical]
    if typical > 1.5 * HEARTBEAT.period and len(alike) > MOSTLY * (len(calls) - 1):
        return see.failed(
            "asks-every-second.short-period",
            saw,
            ONCE_A_SECOND,
            "The calls are evenly spaced but too frequent: the timer that sends the requests has too short a "
            "period.",
            "Give it a period of one second: create_timer(1.0, self.ask).",
        )
    return see.failed(
        "asks-every-second.too-often",
        saw,
        ONCE_A_SECOND,
        "The wrong timer sends the requests, or a call that's still waiting is repeated. A robot that is called "
        "too often does nothing else.",
        "Use a 1.0 s timer for the requests, and another timer for the heartbeat.",
    )


def why_calls_between(calls: list[CallSeen]) -> Verdict:
    """Why there are too many calls, though most of them come a second after the last one."""
    pause, before = min(((b.t - a.t, a) for a, b in pairwise(calls)), key=lambda one: one[0])
    return see.failed(
        "asks-every-second.calls-between",
        f"{len(calls)} calls from {calls[0].t:.1f} s to {calls[-1].t:.1f} s: for example, one at {before.t:.1f} s and "
        f"the next {1000.0 * pause:.0f} ms later",
        ONCE_A_SECOND,
        "There are extra calls in addition to one per second. Your node repeats a call that got no response, sends "
        "several at the start, or sends requests from two places.",
        "Send requests in one place only, from a 1.0 s timer. After a call without a response, wait for the next "
        "tick.",
    )


# --- the answers, and what the program said of them ---------------------------------------------------------

EACH_ANSWER_ONCE = (
    f'"ok" or "faulty", according to the response, once, at most {TOLD_WITHIN_S} s after each response'
)
Report = tuple[float, str]


def told(recording: Recording, *words: str) -> list[Report]:
    """When one of these words was said on /robot/health."""
    return [
        (arrival.t, arrival.value["data"])
        for arrival in recording.topic(HEALTH.name).arrivals
        if arrival.value["data"] in words
    ][:MOST]


@dataclass(frozen=True)
class Answer:
    """One answer that the program got: when, to which call, and the word that it means.

    `may_be_missing`: its report cannot be expected, because the call or the answer lies at the edge of the watch.
    """

    call: CallSeen
    at: float
    word: str
    may_be_missing: bool

    @property
    def was_slow(self) -> bool:
        return self.at - self.call.t > SLOW / 2

    @property
    def response(self) -> str:
        return f"success={self.word == 'ok'}"

    def told_by(self, report: Report) -> bool:
        return report[1] == self.word and self.near(report)

    def near(self, report: Report) -> bool:
        return -EARLY_S <= report[0] - self.at <= TOLD_WITHIN_S + SLACK_S


def answers_in(recording: Recording) -> list[Answer]:
    """What the program was answered, in the order of the answers."""
    found = [
        Answer(
            call,
            call.answered_t,
            WORDS[call.response["success"]],
            call.t < EARLY_S
            or call.answered_t - call.t > MAY_COME_UNTIL_S
            or call.answered_t > recording.simulated_s - TOLD_WITHIN_S - LONG_SLACK_S,
        )
        for call in asked(recording)
        if call.answered_t is not None
    ]
    return sorted(found, key=lambda answer: answer.at)


def told_answers(recording: Recording, edge_s: float = 0.0) -> list[tuple[Answer, Report]] | None:
    """Each answer with the word that tells it, when the words fit the answers one by one; else None.

    On a very busy machine one slow answer may be given up a moment too early. Answers in the last `edge_s` of the watch
    may be without a report.
    """
    last = recording.simulated_s - TOLD_WITHIN_S - LONG_SLACK_S
    return see.pair_in_order(
        answers_in(recording),
        told(recording, *WORDS.values()),
        belongs=lambda answer, said: said[1] == answer.word and -EARLY_S <= said[0] - answer.at <= BELONGS_S,
        may_be_missing=lambda answer: answer.may_be_missing or answer.at > recording.simulated_s - edge_s,
        may_be_extra=lambda said: said[0] > last or said[0] < EARLY_S,
        excusable=lambda answer: given_up_a_moment_early(recording, answer),
    )


def told_late(fitting: list[tuple[Answer, Report]]) -> list[tuple[Answer, float]]:
    """The answers that were reported late, and by how much (s)."""
    delays = [(answer, t - answer.at) for answer, (t, _) in fitting]
    return [(answer, delay) for answer, delay in delays if delay > TOLD_WITHIN_S + SLACK_S]


def why_late(recording: Recording, late: list[tuple[Answer, float]], told_in_all: int) -> Verdict:
    """Why answers were reported late, each by so much (s)."""
    answer, delay = late[0]
    saw = (
        f"{len(late)} of {told_in_all} responses were reported late: for example, the response at {answer.at:.1f} s "
        f"was reported {delay:.1f} s later"
    )
    given_up_at = [t for t, _ in told(recording, NO_ANSWER)]
    if all(any(abs(one.at + wait - t) <= EARLY_S for t in given_up_at) for one, wait in late):
        return see.failed(
            "results-told.waits-for-earlier-call",
            f'{saw}, just when "{NO_ANSWER}" was reported for an earlier call',
            EACH_ANSWER_ONCE,
            "Your node reports in the order of the calls, so a response waits until all earlier calls are settled.",
            "Report each response when it arrives, whatever happens to other calls.",
            about_time=True,
        )
    moments = [call.t for call in asked(recording)]
    if not all(any(abs(one.at + wait - t) <= SLACK_S for t in moments) for one, wait in late):
        return see.failed(
            "results-told.delayed",
            f"{saw}, and not at the moment of a request",
            EACH_ANSWER_ONCE,
            "Something waits between the response and its report: a timer, a sleep, or a check that runs too "
            "rarely.",
            "Publish right away in a done callback: future.add_done_callback(self.on_answer).",
            about_time=True,
        )
    return see.failed(
        "results-told.late",
        saw,
        EACH_ANSWER_ONCE,
        "The result is read only when the next request is sent, so each report belongs to an earlier call.",
        "Read the response in a done callback: future.add_done_callback(self.on_answer).",
        about_time=True,
    )


def why_results_do_not_fit(recording: Recording) -> Verdict:
    """Which answers were told wrongly, or not at all, or too often."""
    answers, words = answers_in(recording), told(recording, *WORDS.values())
    fitting = told_answers(recording, BELONGS_S + EDGE_S) or []
    if len(told_late(fitting)) > 1:
        return why_late(recording, told_late(fitting), len(fitting))
    if max(len(asked(recording)), len(words)) > A_LOT:  # comparing all with all would take too long
        return why_too_many(answers, words) or other_order(answers, words)
    return (
        why_collected(answers, words)
        or why_early_for_an_answer(recording, answers)
        or why_no_more_told(recording, answers, words)
        or why_changes_only(recording, answers, words)
        or why_one_left_out_after_no_answer(recording, answers, words)
        or why_a_result_without_an_answer(recording, answers, words)
        or why_extra(answers, words)
        or why_too_many(answers, words)
        or why_always_the_same(answers, words)
        or next(filter(None, (why_wrongly_told(recording, one, words) for one in answers)), None)
        or other_order(answers, words)
    )


def other_order(answers: list[Answer], words: list[Report]) -> Verdict:
    """The results do not match the answers, and none of the causes that we know explains it."""
    return see.failed(
        "results-told.other-order",
        f"there were {len(answers)} responses, but the {len(words)} results on {HEALTH.name} don't match them, or "
        "are in another order",
        EACH_ANSWER_ONCE,
        "The reported result belongs to another call.",
        "In the done callback, use only the future that is passed to it.",
    )


def why_collected(answers: list[Answer], words: list[Report]) -> Verdict | None:
    """Most reports come several at a moment, though the answers had come one by one."""
    groups: list[list[Report]] = []
    for report in words:
        if groups and report[0] - groups[-1][-1][0] < AT_ONCE_S:
            groups[-1].append(report)
        else:
            groups.append([report])
    together = [group for group in groups if len(group) > 1]
    if len(words) > len(answers) or len(together) < 2 or sum(map(len, together)) < len(words) / 2:
        return None
    if any(after.at - before.at < AT_ONCE_S for before, after in pairwise(answers)):
        return None
    return see.failed(
        "results-told.collected",
        f"{len(together[0])} results at {together[0][0][0]:.1f} s, and {len(together[1])} at "
        f"{together[1][0][0]:.1f} s. The responses had arrived one by one",
        EACH_ANSWER_ONCE,
        "Your node collects responses and reports them together later: from a timer, or when there are enough of "
        "them.",
        "Publish right away in a done callback: future.add_done_callback(self.on_answer).",
        about_time=True,
    )


def why_early_for_an_answer(recording: Recording, answers: list[Answer]) -> Verdict | None:
    """ "no answer" was said while an answer was still to come."""
    _, in_vain = given_up_in_vain(recording)
    reports = told(recording, *WORDS.values())
    untold = [one for one in answers if not any(one.told_by(report) for report in reports)]
    for answer in answers:
        about_others = [t for t in in_vain if any(is_about(one.call, t) for one in untold if one != answer)]
        too_soon = [t for t in in_vain if answer.call.t < t < answer.at and t not in about_others]
        if too_soon and not answer.may_be_missing:
            return see.failed(
                "results-told.given-up-early",
                f"the call at {answer.call.t:.1f} s got the response {answer.response} after "
                f'{answer.at - answer.call.t:.1f} s, but your node had published "{NO_ANSWER}" after '
                f"{too_soon[0] - answer.call.t:.1f} s",
                EACH_ANSWER_ONCE,
                f"Your node gave up too early: a response may take {MAY_TAKE_S} s.",
                "Give up on a call when the next one is due, not earlier.",
                about_time=True,
            )
    return None


def why_no_more_told(recording: Recording, answers: list[Answer], words: list[Report]) -> Verdict | None:
    """Results were reported, and then none any more, while answers went on."""
    missing = [
        one for one in answers if not one.may_be_missing and not any(one.told_by(report) for report in words)
    ]
    before = [t for t, _ in words if missing and t < missing[0].at]
    if not before or len(before) < len(words) or given_up(recording, missing[0].call):
        return None
    saw = (
        f"the last report of a response was at {before[-1]:.1f} s; the response at {missing[0].at:.1f} s was "
        "not reported"
    )
    return see.failed_by_error(recording, saw, EACH_ANSWER_ONCE) or see.failed(
        "results-told.stops",
        f"{saw}, nor was any later one",
        EACH_ANSWER_ONCE,
        "The reports stop although responses still arrive. They are limited in number, or the code that handles "
        "the responses has stopped.",
        "Report every response until Ctrl-C.",
    )


def why_changes_only(recording: Recording, answers: list[Answer], words: list[Report]) -> Verdict | None:
    """Every answer that was not told says the same as the one before it, and the others were told."""
    missing = [
        (one, before)
        for before, one in zip([None, *answers], answers, strict=False)
        if not one.may_be_missing and not any(one.told_by(report) for report in words)
    ]
    repeated = [
        (one, before)
        for one, before in missing
        if before is not None and before.word == one.word and not given_up(recording, one.call)
    ]
    if not repeated or len(repeated) < len(missing) or any(one.near(r) for one, _ in missing for r in words):
        return None
    silent = [call.t for call in asked(recording) if call.response is None]
    for last, one in pairwise(answers):
        between = any(last.call.t < t < one.call.t for t in silent)
        if one.word == last.word and not between and any(one.told_by(report) for report in words):
            return None  # it differed from nothing, and was told
    one, before = repeated[0]
    return see.failed(
        "results-told.changes-only",
        f'the response at {one.at:.1f} s meant "{one.word}", like the one at {before.at:.1f} s, and was not '
        "reported. All responses that differed from the previous one were reported",
        EACH_ANSWER_ONCE,
        "Your node reports a result only when it differs from the last one. So the control room can't see whether "
        "the robot is still being tested.",
        "Publish for each response, even if the result is the same as before.",
    )


def why_one_left_out_after_no_answer(
    recording: Recording, answers: list[Answer], words: list[Report]
) -> Verdict | None:
    """The first answer after each "no answer" was not told, and all others were."""
    gave_up = [t for t, _ in told(recording, NO_ANSWER)]
    judged = [
        (one, any(last < t <= one.at for t in gave_up))
        for last, one in zip([0.0, *(one.at for one in answers)], answers, strict=False)
        if not one.may_be_missing
    ]
    missing = [one for one, is_first in judged if is_first]
    fits = all(any(one.told_by(report) for report in words) is not is_first for one, is_first in judged)
    if not fits or len(missing) < 2 or any(given_up(recording, one.call) for one in missing):
        return None
    return see.failed(
        "results-told.none-after-no-answer",
        f'{len(missing)} responses were not reported, each the first one after a "{NO_ANSWER}": for example, the '
        f"one at {missing[0].at:.1f} s. All others were reported",
        EACH_ANSWER_ONCE,
        "After giving up on a call, your code skips the next response, as if it belonged to that call.",
        "Forget the abandoned call with remove_pending_request(future). Then report each response that arrives.",
    )


def why_a_result_without_an_answer(
    recording: Recording, answers: list[Answer], words: list[Report]
) -> Verdict | None:
    """A result was reported for each call without an answer, instead of "no answer"."""
    silent = [call for call in asked(recording) if call.response is None]
    strange, _ = left_over(answers, words)
    about = [(call, report) for call in silent for report in strange if is_about(call, report[0])]
    if not about or told(recording, NO_ANSWER) or len(strange) > len(silent):
        return None
    call, (t, word) = about[0]
    return see.failed(
        "results-told.no-answer-came",
        f'the call at {call.t:.1f} s got no response, but your node published "{word}" at {t:.1f} s',
        f'"{NO_ANSWER}" for a call that got no response; "ok" and "faulty" only for responses',
        "Your node reports a result for a call that got no response. But without a response, the robot's health is "
        "unknown.",
        f'When you give up on a call, publish "{NO_ANSWER}".',
    )


def is_about(call: CallSeen, t: float) -> bool:
    """Whether a report at `t` may be about this call, which got no answer."""
    return SOONEST_S <= t - call.t <= LATEST_S


def is_about_one_of(calls: Sequence[CallSeen], t: float) -> bool:
    """Whether a report at `t` may be about one of these calls, which are in the order of their coming."""
    first = bisect_left(calls, -LATEST_S, key=lambda call: call.t - t)
    return first < len(calls) and is_about(calls[first], t)


def left_over(answers: list[Answer], words: list[Report]) -> tuple[list[Report], bool]:
    """The reports that remain when each answer has taken one that tells it, and whether each answer found one."""
    left, all_told = list(words), True
    for answer in answers:
        own = next((report for report in left if answer.told_by(report)), None)
        if own is not None:
            left.remove(own)
        elif not answer.may_be_missing:
            all_told = False
    return left, all_told


def why_extra(answers: list[Answer], words: list[Report]) -> Verdict | None:
    """Every answer was reported, and there is a report more."""
    left, all_told = left_over(answers, words)
    if not all_told:
        return None
    strange = [report for report in left if not any(one.told_by(report) for one in answers)]
    if strange and len(strange) == len(left):
        t, word = strange[0]
        return see.failed(
            "results-told.without-an-answer",
            f'your node published "{word}" at {t:.1f} s, but no response in the {TOLD_WITHIN_S} s before meant '
            "that. Each response was also reported",
            EACH_ANSWER_ONCE,
            "Your node publishes a result without a response: at the start, from a timer, or as a first guess.",
            'Publish "ok" and "faulty" in one place only: where you handle a response.',
        )
    if len(left) != 1:
        return None
    t, word = left[0]
    return see.failed(
        "results-told.one-twice",
        f'your node published an extra "{word}" at {t:.1f} s, for a response that it had already reported',
        EACH_ANSWER_ONCE,
        "One response is reported twice: two places publish it, or it is stored and reported again.",
        "Publish in one place only: where you handle the response.",
    )


def why_too_many(answers: list[Answer], words: list[Report]) -> Verdict | None:
    """More results than answers."""
    if len(words) <= len(answers) + 1:
        return None
    return see.failed(
        "results-told.more-than-once",
        f"there were {len(answers)} responses, but your node reported {len(words)} results",
        EACH_ANSWER_ONCE,
        "A response is reported more than once: by two methods, or again and again until the next one arrives.",
        "Publish in one place only: where you handle the response.",
    )


def why_always_the_same(answers: list[Answer], words: list[Report]) -> Verdict | None:
    """Each answer has a report, and these do not depend on what the answers say."""
    nearest = [
        (one, next((word for t, word in words if one.near((t, word))), None))
        for one in answers
        if not one.may_be_missing
    ]
    said = {word for _, word in nearest}
    wrong = [(one, word) for one, word in nearest if word != one.word]
    if not wrong or None in said:
        return None
    one, word = wrong[0]
    saw = f'the call at {one.call.t:.1f} s got the response {one.response}, but your node published "{word}"'
    if len(said) == 2 and len(wrong) == len(nearest):
        return see.failed(
            "results-told.inverted",
            saw,
            EACH_ANSWER_ONCE,
            'Every report is the opposite of its response: "ok" and "faulty" are swapped.',
            '"ok" if future.result().success else "faulty".',
        )
    if len(said) == 1:
        return why_one_word(f"{saw}, as for every response", word)
    first = next((place for place, (_, word) in enumerate(nearest) if word == wrong[0][1]), 0)
    if all(word == wrong[0][1] for _, word in nearest[first:]):
        return see.failed(
            "results-told.stays",
            f'{saw}, as for every response after the first "{word}"',
            EACH_ANSWER_ONCE,
            f'After the first "{word}", your node publishes "{word}" for every response, because an attribute keeps '
            "the old result.",
            "Take each result from its own response: future.result().success.",
        )
    return None


def why_one_word(saw: str, word: str | None) -> Verdict:
    """Why every answer is reported with the same word."""
    if word == WORDS[False]:
        return see.failed(
            "results-told.always-faulty",
            saw,
            EACH_ANSWER_ONCE,
            'Your program never publishes "ok". It doesn\'t use the field success, but something else, such as the '
            "response's text, which is for people.",
            'Read the field: "ok" if future.result().success else "faulty".',
        )
    return see.failed(
        "results-told.always-the-same",
        saw,
        EACH_ANSWER_ONCE,
        "Your program doesn't check the response's field success. The response object itself always counts as "
        "true, and its text is for people.",
        'Read the field: "ok" if future.result().success else "faulty".',
    )


def why_wrongly_told(recording: Recording, answer: Answer, words: list[Report]) -> Verdict | None:
    """What is wrong with the report of one answer; None when nothing is."""
    in_time = [report[1] for report in words if answer.near(report)]
    if answer.may_be_missing or answer.word in in_time:
        return None
    came = f"the call at {answer.call.t:.1f} s got the response {answer.response}"
    if in_time:
        return see.failed(
            "results-told.other-result",
            f'{came}, but your node published "{in_time[0]}"',
            EACH_ANSWER_ONCE,
            "This is the result of another call, or it isn't based on the field success. The text in message is "
            "for people, and the same text may go with either result.",
            "In the done callback, use the future that is passed to it: future.result().success.",
        )
    gave_up = given_up(recording, answer.call)
    said = f'your node published "{NO_ANSWER}"' if gave_up else f'"{answer.word}" was not published'
    saw = f"{came} at {answer.at:.1f} s, but {said}"
    others = [
        one
        for one in answers_in(recording)
        if one != answer and not one.may_be_missing and (answer.was_slow or not one.was_slow)
    ]
    is_told = [any(one.told_by(report) for report in words) for one in others]
    slow_told = any(one.was_slow and fits for one, fits in zip(others, is_told, strict=True))
    if not gave_up and all(is_told) and (slow_told or not answer.was_slow):
        return see.failed(
            "results-told.one-left-out",
            f"{saw}. All other {'responses, even slow ones,' if answer.was_slow else 'fast responses'} were reported",
            EACH_ANSWER_ONCE,
            "Your code handles responses but skips this one, because of a counter, a flag, or a comparison with an "
            "earlier response.",
            "Report each response, including the first one.",
        )
    return why_not_taken_in(recording, answer, saw, gave_up)


def why_not_taken_in(recording: Recording, answer: Answer, saw: str, gave_up: bool) -> Verdict:
    """Why an answer was not reported, or as if it had not come."""
    blamed = see.failed_by_error(recording, saw, EACH_ANSWER_ONCE)
    if blamed is not None:
        return blamed
    if stops_during_a_call(recording) is not None:
        return see.failed(
            "results-told.waits-in-callback",
            f"{saw}; while a call is open, the heartbeat stops, too",
            EACH_ANSWER_ONCE,
            "The callback that sent the request waits for the response. It occupies the thread or the client's "
            "callback group, so rclpy can't handle the response that has arrived.",
            "Return from the callback that sends the request, and publish in a done callback of the future.",
            about_time=True,
        )
    judged = [one for one in answers_in(recording) if not one.may_be_missing and not one.was_slow]
    words = told(recording, *WORDS.values())
    if answer.was_slow and (not gave_up or all(any(one.told_by(r) for r in words) for one in judged)):
        return see.failed(
            "results-told.slow-dropped",
            f"{saw}; it had taken {answer.at - answer.call.t:.1f} s",
            EACH_ANSWER_ONCE,
            "A slow response is dropped, or its call is forgotten before the response arrives. A response may take "
            f"{MAY_TAKE_S} s.",
            "Report the response in a done callback, however long it took. Forget a call after a second, not "
            "earlier.",
            about_time=True,
        )
    return see.failed(
        "results-told.not-taken-in",
        saw,
        EACH_ANSWER_ONCE,
        "The response has reached the process, but nothing handles it. The callback that sent the request still "
        "occupies the client's callback group, or nothing checks the future.",
        "Return from the callback that sends the request, and publish in a done callback of the future.",
        about_time=True,
    )


# --- the calls without an answer ----------------------------------------------------------------------------

ONE_NO_ANSWER = (
    f'"{NO_ANSWER}" once for a call without a response, {MAY_TAKE_S} to {GIVEN_UP_WITHIN_S:.0f} s after the '
    "call"
)


@see.once
def given_up_in_vain(recording: Recording) -> tuple[list[CallSeen], list[float]]:
    """Calls without an answer that were not given up, and when "no answer" was said where there was no such call.

    Calls that may still be given up when the watch ends are none of the first, and what is said of them is none of the
    second.
    """
    left = sorted(t for t, _ in told(recording, NO_ANSWER))
    silent = [call for call in asked(recording) if call.response is None]
    may_come_later = [
        call for call in silent if call.t >= recording.simulated_s - GIVEN_UP_WITHIN_S - LONG_SLACK_S
    ]
    untold = []
    for call in silent[: len(silent) - len(may_come_later)]:
        first = bisect_left(left, SOONEST_S, key=lambda t: t - call.t)
        if first < len(left) and is_about(call, left[first]):
            del left[first]
        else:
            untold.append(call)
    return untold, [t for t in left if not is_about_one_of(may_come_later, t)]


def given_up_after(recording: Recording) -> list[float]:
    """How long (s) each call without an answer waited until it was given up, without those that were not."""
    said = [t for t, _ in told(recording, NO_ANSWER)]
    waited = [
        [t - call.t for t in said if is_about(call, t)] for call in asked(recording) if call.response is None
    ]
    return [min(one) for one in waited if one]


def given_up(recording: Recording, call: CallSeen) -> bool:
    """Whether "no answer" was said for this call."""
    untold, in_vain = given_up_in_vain(recording)
    if call.response is None:
        return call not in untold
    return any(call.t < t < call.t + GIVEN_UP_WITHIN_S + LONG_SLACK_S for t in in_vain)


def given_up_a_moment_early(recording: Recording, answer: Answer) -> bool:
    """Whether a slow answer was given up when it could hardly come any more, and not reported."""
    if not answer.was_slow:
        return False
    _, in_vain = given_up_in_vain(recording)
    if any(answer.told_by(report) for report in told(recording, answer.word)):
        return False
    return any(is_about(answer.call, t) and t - answer.call.t <= GIVEN_UP_AT_ONCE_S for t in in_vain)


def why_early(call: CallSeen, at: float) -> Verdict:
    """A call got no answer, and "no answer" was said too early."""
    return see.failed(
        "unanswered-told.early",
        f'the call at {call.t:.1f} s got no response, and your node published "{NO_ANSWER}" after {at - call.t:.1f} '
        "s",
        ONE_NO_ANSWER,
        f"Your node gave up too early: a response may take {MAY_TAKE_S} s.",
        "Give up on a call when the next one is due, not earlier.",
    )


def why_always_early(waited: list[float]) -> Verdict:
    """Each call without an answer was given up a little too early, after so long (s)."""
    return see.failed(
        "unanswered-told.always-early",
        f'{len(waited)} calls got no response, and your node published "{NO_ANSWER}" at most {max(waited):.2f} s '
        "after each of them",
        ONE_NO_ANSWER,
        f"The time limit is a little too short. A response may take {MAY_TAKE_S} s, and your node would miss it.",
        "Give up on a call when the next one is due, not earlier.",
        about_time=True,
    )


def why_not_given_up(recording: Recording, call: CallSeen, later: list[float]) -> Verdict:
    """A call got no answer, and "no answer" was said too late, at the first of `later`, or never."""
    saw = f"the call at {call.t:.1f} s got no response, and your node "
    try_this = (
        "Store the open call. After a second, report it, and forget it with remove_pending_request(future)."
    )
    if later and later[0] - call.t < MAY_TAKE_S - SLACK_S:
        return why_early(call, later[0])
    late = each_late_s(recording)
    if late is not None:
        return why_always_late(recording, late)
    if later and later[0] - call.t < 2 * GIVEN_UP_WITHIN_S:
        return see.failed(
            "unanswered-told.late",
            f"{saw}reported that {later[0] - call.t:.1f} s later",
            ONE_NO_ANSWER,
            "Your node gives up on the call too late: after more than two seconds, or only with the second request "
            "after it.",
            try_this,
            about_time=True,
        )
    return why_never_given_up(recording, call, saw, try_this)


def each_late_s(recording: Recording) -> float | None:
    """How late (s) each call without an answer was given up, where all are equally late, and too late."""
    said = [t for t, _ in told(recording, NO_ANSWER) if t > FIRST_SECONDS_S]
    silent = [call.t for call in asked(recording) if call.response is None]
    late = [at - t for t, at in zip(silent, said, strict=False)]
    if len(late) < LATE_ONES or max(late) - min(late) > LONG_SLACK_S:
        return None
    return min(late) if min(late) > GIVEN_UP_WITHIN_S else None


def why_always_late(recording: Recording, late: float) -> Verdict:
    """Each call without an answer was given up, and equally late (s)."""
    first = next(call for call in asked(recording) if call.response is None)
    return see.failed(
        "unanswered-told.always-late",
        f'the call at {first.t:.1f} s got no response, and your node published "{NO_ANSWER}" {late:.1f} s later; '
        "the next such calls were equally late",
        ONE_NO_ANSWER,
        "The time limit is too long: your node gives up on calls without a response, but always too late.",
        "Give up on a call after about one second, when the next one is due.",
        about_time=True,
    )


def why_forgotten(recording: Recording, call: CallSeen, saw: str) -> Verdict | None:
    """Others were given up, and only while this one waited was another call answered; None otherwise."""
    silent = [one for one in asked(recording) if one.response is None and one != call]
    given = [one for one in silent if given_up(recording, one)]
    patience = min(given_up_after(recording), default=0.0)

    def answered_meanwhile(one: CallSeen, within: float) -> float | None:
        ends = [other.answered_t for other in asked(recording) if other.answered_t is not None]
        return next((end for end in ends if one.t < end < one.t + within), None)

    end = answered_meanwhile(call, patience - SLACK_S)  # clearly before it would have been given up
    if end is None or not given or any(answered_meanwhile(one, patience) for one in given):
        return None
    return see.failed(
        "unanswered-told.forgotten",
        f"{saw}published nothing about it; another call was answered at {end:.1f} s, while this one was open. For "
        f'the call at {given[0].t:.1f} s, your node published "{NO_ANSWER}"',
        ONE_NO_ANSWER,
        "The response to another call makes your node forget this one, for example by clearing all open calls.",
        "When a response arrives, forget only the call that it belongs to.",
    )


def why_never_given_up(recording: Recording, call: CallSeen, saw: str, try_this: str) -> Verdict:
    """A call got no answer, and nothing was said about it."""
    other = why_once_in_a_row(recording, call, saw) or why_forgotten(recording, call, saw)
    if other is not None:
        return other
    first = next(one for one in asked(recording) if one.response is None)
    if call is not first and given_up(recording, first):
        return see.failed(
            "unanswered-told.first-only",
            f'{saw}published nothing about it. For the call at {first.t:.1f} s, it had published "{NO_ANSWER}"',
            ONE_NO_ANSWER,
            "Your node gives up on one call but not on the next. The check for a missing response works only once, "
            f'or a repeated "{NO_ANSWER}" is treated as nothing new.',
            "Store the time of each call, and report each call that you give up on.",
        )
    return see.failed(
        "unanswered-told.never",
        f"{saw}published nothing about it",
        ONE_NO_ANSWER,
        "Without a response, a future runs no done callback and raises no error. Something else must check each "
        "open call before the next call replaces it.",
        try_this,
    )


def why_once_in_a_row(recording: Recording, call: CallSeen, saw: str) -> Verdict | None:
    """The call before had been given up as well, and so had another one; None otherwise."""
    silent = [one for one in asked(recording) if one.response is None]
    before = next((a for a, b in pairwise(asked(recording)) if b == call), call)
    given = [one for one in silent if one != call and given_up(recording, one)]
    if before not in given or len(given) < 2:
        return None
    return see.failed(
        "unanswered-told.once-in-a-row",
        f"{saw}published nothing about it. For the previous call, at {before.t:.1f} s, it had published "
        f'"{NO_ANSWER}"',
        ONE_NO_ANSWER,
        f'Of several calls in a row without a response, only the first is reported: a repeated "{NO_ANSWER}" is '
        "treated as nothing new.",
        "Report each call that you give up on, even if you also gave up on the previous one.",
    )


def why_given_up(recording: Recording, in_vain: list[float]) -> Verdict:
    """ "no answer" was said at moments when no call was without one."""
    at = in_vain[0]
    calls = [call for call in asked(recording) if call.t < at]
    waiting = [call for t in in_vain for call in asked(recording) if call.t < t < (call.answered_t or 0.0)]
    if len(waiting) >= len(in_vain):
        call = waiting[0]
        return see.failed(
            "unanswered-told.still-open",
            f'your node published "{NO_ANSWER}" {at - call.t:.1f} s after the call at {call.t:.1f} s; the response '
            f"arrived {(call.answered_t or at) - call.t:.1f} s after the call",
            ONE_NO_ANSWER,
            f"Your node gives up too early: a response may take {MAY_TAKE_S} s.",
            "Don't give up before the next request.",
            about_time=True,
        )
    if any(call.response is None and given_up(recording, call) for call in calls):
        return see.failed(
            "unanswered-told.twice",
            f'another "{NO_ANSWER}" at {at:.1f} s, but no other call was without a response',
            ONE_NO_ANSWER,
            "The abandoned call is still stored and is reported again. Or your node reports a call that it skipped "
            "and never made.",
            "Report a call once, and forget it after you've reported it.",
        )
    return why_given_up_though_answered(recording, at)


def why_given_up_though_answered(recording: Recording, at: float) -> Verdict:
    """ "no answer" was said at a moment (s) when every call had been answered."""
    if told_answers(recording) is not None:
        return see.failed(
            "unanswered-told.besides-the-answer",
            f'"{NO_ANSWER}" at {at:.1f} s, although every call until then had been answered and reported',
            ONE_NO_ANSWER,
            f'Your node handles the responses. But it publishes "{NO_ANSWER}" with a request, before the response '
            "can arrive, or it still stores an answered call as open.",
            f'Publish "{NO_ANSWER}" only when you give up on a call, and forget a call when its response has '
            "arrived.",
            about_time=True,
        )
    return see.failed(
        "unanswered-told.was-answered",
        f'"{NO_ANSWER}" at {at:.1f} s, although every call until then had been answered',
        ONE_NO_ANSWER,
        "The response arrived but wasn't handled, because the callback that sent the request waits for it. Or an "
        "answered call is still stored as open.",
        "Don't wait in the callback, and forget a call when its response has arrived.",
        about_time=True,
    )


# --- the heartbeat ------------------------------------------------------------------------------------------

FIVE_HERTZ = (
    f"5 Hz, even while a call waits for its response: {LEAST_SHARE:.0%} to {MOST_SHARE:.0%} of the beats, typically "
    f"one every {SHORTEST_BEAT_S} to {LONGEST_BEAT_S} s"
)


def open_for_long(recording: Recording) -> list[tuple[float, float]]:
    """From when to when a call of the program waited for its answer, where that took long."""
    spans = [
        (call.t, call.t + MAY_COME_UNTIL_S if call.answered_t is None else call.answered_t)
        for call in asked(recording)
        if EARLY_S <= call.t < recording.simulated_s - 1.0
    ]
    return [(begin + EDGE_S, end - EDGE_S) for begin, end in spans if end - begin > SLOW / 2]


def stops_during_a_call(recording: Recording) -> Verdict | None:
    """A failed verdict when most beats are missing while calls wait for their answers; None otherwise."""
    spans = open_for_long(recording)
    beats = see.beats_meanwhile(recording, HEARTBEAT, spans)
    if beats.due <= LEAST_DUE or beats.came >= LEAST_MEANWHILE * beats.due:
        return None
    silent_from = beats.silent_from[0] if beats.silent_from else spans[0][0]
    return see.failed(
        "heartbeat-steady.stops-during-a-call",
        f"while calls were waiting for their responses, {beats.came} of {beats.due:.0f} beats arrived: for example, "
        f"too few after the call at {silent_from - EDGE_S:.1f} s",
        FIVE_HERTZ,
        "The callback that sends the request waits for the response. Until then, it occupies the thread or the "
        "heartbeat's callback group, so the heartbeat can't run. Or your code skips beats while a call is open.",
        "Publish a beat on every tick of its timer. Send the request with call_async() and return. Or give the "
        "heartbeat and the waiting callback different callback groups and a MultiThreadedExecutor.",
        about_time=True,
    )


def comes_in_bursts(recording: Recording) -> Verdict | None:
    """A failed verdict when several beats come at a time, and then none for a while; None otherwise."""
    pace = see.topic_pace(recording, HEARTBEAT)
    if not pace.in_bursts:
        return None
    return see.failed(
        "heartbeat-steady.in-bursts",
        f"{pace.count} beats, {pace.burst} at a time",
        FIVE_HERTZ,
        "Several beats are published at the same time, and then none for a while. In between, nothing shows that "
        "the program is still running.",
        "Publish one beat on every tick of a 0.2 s timer.",
    )


def stops_for_good(recording: Recording) -> Verdict | None:
    """A failed verdict when no beat comes any more towards the end; None otherwise."""
    end = recording.topic(HEARTBEAT.name).arrivals[-1].t
    typical = see.beats(recording, HEARTBEAT).typical_s
    if recording.simulated_s - end <= max(STOPPED_S, 1.5 * typical):
        return None
    saw = f"the last beat arrived at {end:.1f} s, then none until {recording.simulated_s:.1f} s"
    blamed = see.failed_by_error(recording, saw, FIVE_HERTZ)
    if blamed is not None:
        return blamed
    later = sum(call.t > end + EDGE_S for call in asked(recording))
    if later < FEW_CALLS:
        return see.failed(
            "heartbeat-steady.stops",
            f"{saw}; {'only one call followed' if later else 'no call followed either'}",
            FIVE_HERTZ,
            "Nothing spins the node any more. Either a callback waits for a response that rclpy can't handle in "
            "the meantime, or the loop that spins the node has ended.",
            "Send the request with call_async(), add a done callback, and return. Spin until Ctrl-C.",
            about_time=True,
        )
    return see.failed(
        "heartbeat-steady.stops-alone",
        f"{saw}; {later} calls followed",
        FIVE_HERTZ,
        "The rest of the program continues, but the heartbeat does not. Its timer is canceled or destroyed, it "
        "stops after some number of beats, or its thread has ended.",
        "Publish on every tick of its timer, without end.",
    )


def why_too_few_or_many(beats: see.Beats) -> Verdict:
    """The typical pause is right, and still there are too few beats, or too many."""
    saw = f"{beats.count} beats, but {beats.due} were due"
    if beats.share > 1.0:
        return see.failed(
            "heartbeat-steady.too-many",
            saw,
            FIVE_HERTZ,
            "More than one place publishes the heartbeat.",
            "Keep one 0.2 s timer for it, with one publish() in its callback.",
        )
    return see.failed(
        "heartbeat-steady.too-few",
        f"{saw}; the longest silence was {beats.silence.seconds:.1f} s, from {beats.silence.start:.1f} s on",
        FIVE_HERTZ,
        "Something sometimes delays the heartbeat: a callback in its thread or callback group waits, sleeps, or "
        "works.",
        "Let every callback return right away, or give the heartbeat its own callback group and thread.",
        about_time=True,
    )
