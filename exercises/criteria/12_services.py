"""How exercise 12 is judged: what it asks, what it says of each answer, and whether its heart goes on meanwhile."""

import statistics
from dataclasses import dataclass, replace
from itertools import pairwise

from std_msgs.msg import String
from std_srvs.srv import Trigger

import workbook.criteria as see
from workbook.criteria import CallSeen, Recording, Verdict, criterion, topic, watching

SERVICE = "/robot/self_test"
HEALTH = topic("/robot/health", String)
HEARTBEAT = topic("/robot/heartbeat", String, hz=5.0)
WORDS = {True: "ok", False: "faulty"}
NO_ANSWER = "no answer"

WELL, STIFF = (
    {"success": True, "message": "all joints move"},
    {"success": False, "message": "a knee is stiff"},
)
AT_ONCE, SLOW, NEVER = 0.0, 0.6, None
REPLIES = [
    (WELL, AT_ONCE),
    (STIFF, AT_ONCE),
    (WELL, SLOW),
    (WELL, NEVER),
    (STIFF, SLOW),
    (WELL, AT_ONCE),
    (STIFF, SLOW),
    (WELL, AT_ONCE),
]
UNANSWERED = [after for _, after in REPLIES].index(NEVER) + 1
WATCH = watching(wall_seconds=8.0, script=[see.serves(SERVICE, Trigger, REPLIES)])

ASKED_EVERY_S = 1.0
TOLD_WITHIN_S = 0.8
BELONGS_S = 1.6  # told later than that, it is taken for the report of another answer
GIVEN_UP_WITHIN_S = 2.0
SLACK_S = 0.3  # for a busy machine
MAY_COME_UNTIL_S = 0.85
LONGEST_PAUSE_S = 2.6
LEAST_SHARE = 0.4  # of the beats that are due while a call is open: one that waits loses all of them
EDGE_S = 0.05
EARLY_S = 0.1  # what was asked before the watch began waited for it; how long, nobody knows
FIRST_SECONDS_S = 2.5  # a call from before the watch may be given up until then


def asked(recording: Recording) -> list[CallSeen]:
    """The calls of the program, in the order of their coming."""
    return [call for call in see.calls_of(recording, SERVICE) if call.by == "program"]


def told(recording: Recording, *words: str) -> list[tuple[float, str]]:
    """When one of these words was said on /robot/health."""
    return [
        (arrival.t, arrival.value["data"])
        for arrival in recording.topic(HEALTH.name).arrivals
        if arrival.value["data"] in words
    ]


@criterion(points=0, title="Your program runs and its node is on the graph")
def program_runs(recording: Recording) -> Verdict:
    return see.program_runs(recording)


@criterion(points=1, title="Calls of /robot/self_test arrive, again and again", needs=[program_runs])
def calls_arrive(recording: Recording) -> Verdict:
    first = see.calls_service(recording, SERVICE, "std_srvs/srv/Trigger")
    if not first.ok:
        return first
    calls = asked(recording)
    if len(calls) >= UNANSWERED:
        return see.passed(f"{len(calls)} calls")
    if recording.process.ended_by == "itself":
        return _ended(recording)
    last = calls[-1]
    expected = f"a call every second, so {UNANSWERED} or more in {recording.robot_s:.0f} s"
    how_many = "one single call" if len(calls) == 1 else f"{len(calls)} calls"
    if last.answered_t is not None and recording.robot_s - last.t > LONGEST_PAUSE_S and not alive(recording):
        return see.failed(
            f"{how_many}: the one at {last.t:.1f} s was answered at {last.answered_t:.1f} s, and then your node did "
            "nothing any more",
            expected,
            "The callback that asks waits for the answer, and the answer waits for that callback: it can only be taken "
            "in when the thread, and the callback group of the client, are free again. A deadlock.",
            "Do not wait in the callback: call_async(), then add_done_callback(), and return.",
        )
    if last.answered_t is not None and recording.robot_s - last.t > LONGEST_PAUSE_S:
        return see.failed(
            f"{how_many}, the last one at {last.t:.1f} s; it was answered at {last.answered_t:.1f} s",
            expected,
            "It asks only once and not from a timer; or the callback that asked is still waiting for its answer, "
            "because client and callback share a callback group.",
            "Let a timer ask, do not wait in it, and take the answer in a done callback.",
        )
    return see.failed(
        f"{how_many} in {recording.robot_s:.0f} s",
        expected,
        "The timer that asks is too slow, or something holds it up.",
        "create_timer(1.0, self.ask), and let ask() return at once.",
        about_time=True,
    )


def _ended(recording: Recording) -> Verdict:
    """Why a program that has ended asked no more."""
    verdict = see.alive_at_end(recording)
    if "'NoneType' object has no attribute" not in verdict.saw:
        return verdict
    return replace(
        verdict,
        because="call_async() returns at once, before the answer is there. Until then future.result() is None.",
        try_this="Look at the result in a done callback: future.add_done_callback(self.on_answer).",
    )


def alive(recording: Recording) -> bool:
    """Whether anything at all was published in the last second of the watch."""
    ends = [topic.arrivals[-1].t for topic in recording.published() if topic.arrivals]
    return max(ends, default=0.0) > recording.robot_s - 1.0


@criterion(
    points=1, title="It asks once a second, and goes on after the unanswered call", needs=[calls_arrive]
)
def asks_every_second(recording: Recording) -> Verdict:
    calls = [call for call in asked(recording) if call.t >= EARLY_S]
    times = [call.t for call in calls]
    expected = "one call a second, from the first to the last"
    pauses = [b - a for a, b in pairwise([*times, recording.robot_s])]
    longest = max(pauses, default=recording.robot_s)
    if longest > LONGEST_PAUSE_S:
        before = calls[pauses.index(longest)] if calls else None
        if before is not None and before.response is None:
            return see.failed(
                f"after the call at {before.t:.1f} s, which nobody answered, no call came for {longest:.1f} s",
                expected,
                "It waits for the old answer before it asks again, and that answer will never come.",
                "Give an open call up when the next one is due: remove_pending_request(future), and ask again.",
                about_time=True,
            )
        return see.failed(
            f"a pause of {longest:.1f} s"
            + ("" if before is None else f" after the call at {before.t:.1f} s"),
            expected,
            "Something holds up the timer that asks, or it has stopped.",
            "Let the method that asks return at once, and look into the log for an error.",
            about_time=True,
        )
    typical = statistics.median(b - a for a, b in pairwise(times)) if len(times) > 1 else recording.robot_s
    if typical < 0.8:
        return see.failed(
            f"{len(asked(recording))} calls in {recording.robot_s:.0f} s, typically {typical:.2g} s apart",
            expected,
            "The wrong timer asks, or a call that waits is repeated. Asked too often, a robot does nothing else.",
            "One timer of 1.0 s for the questions, another one for the heartbeat.",
        )
    if typical > 1.25:
        return see.failed(
            f"typically {typical:.2g} s from one call to the next",
            expected,
            "The next question waits for the answer to the last one, and then for a second on top; or the period is "
            "too long.",
            "create_timer(1.0, self.ask), and let ask() return at once.",
            about_time=True,
        )
    return see.passed(f"{len(times)} calls, typically {typical:.1f} s apart")


@criterion(points=1, title="/robot/health carries String and says only the three words", needs=[program_runs])
def health_topic(recording: Recording) -> Verdict:
    exists = see.publishes(recording, HEALTH)
    if not exists.ok or not recording.topic(HEALTH.name).arrivals:
        return exists
    return see.one_of(recording, HEALTH, {*WORDS.values(), NO_ANSWER})


@dataclass(frozen=True)
class Answer:
    """One answer that the program got: when, to which call, and the word that it means.

    `may_be_missing`: nobody can ask for it, because the call or the answer lies at the edge of the watch.
    """

    call: CallSeen
    at: float
    word: str
    may_be_missing: bool

    @property
    def was_slow(self) -> bool:
        return self.at - self.call.t > SLOW / 2


def answers_in(recording: Recording) -> list[Answer]:
    """What the program was answered, in the order of the answers."""
    found = [
        Answer(
            call,
            call.answered_t,
            WORDS[call.response["success"]],
            call.t < EARLY_S
            or call.answered_t - call.t > MAY_COME_UNTIL_S
            or call.answered_t > recording.robot_s - TOLD_WITHIN_S - SLACK_S,
        )
        for call in asked(recording)
        if call.answered_t is not None
    ]
    return sorted(found, key=lambda answer: answer.at)


def given_up_in_vain(recording: Recording) -> tuple[list[CallSeen], list[float]]:
    """Calls without an answer of which nobody was told, and when "no answer" was said where there was no such call.

    Calls that may still be given up when the watch ends are none of the first, and what is said of them is none of the
    second.
    """
    left = [t for t, _ in told(recording, NO_ANSWER)]
    silent = [call for call in asked(recording) if call.response is None]
    may_come_later = [call for call in silent if call.t >= recording.robot_s - GIVEN_UP_WITHIN_S - SLACK_S]
    untold = []
    for call in silent[: len(silent) - len(may_come_later)]:
        in_time = [t for t in left if call.t < t <= call.t + GIVEN_UP_WITHIN_S + SLACK_S]
        if in_time:
            left.remove(in_time[0])
        else:
            untold.append(call)
    return untold, [
        t for t in left if not any(0.0 < t - call.t < GIVEN_UP_WITHIN_S + SLACK_S for call in may_come_later)
    ]


def given_up(recording: Recording, call: CallSeen) -> bool:
    """Whether "no answer" was said for this call."""
    return any(call.t < t < call.t + GIVEN_UP_WITHIN_S + SLACK_S for t, _ in told(recording, NO_ANSWER))


def delays(recording: Recording) -> list[tuple[Answer, float]] | None:
    """Each answer and how much later it was told, when the words fit the answers one by one; else None.

    On a very busy machine one slow answer may be given up a moment too early.
    """
    answers, words = answers_in(recording), told(recording, *WORDS.values())
    last = recording.robot_s - TOLD_WITHIN_S - SLACK_S

    def fit(i: int, j: int, excused: bool) -> list[tuple[Answer, float]] | None:
        if i == len(answers):
            return [] if all(t > last or t < EARLY_S for t, _ in words[j:]) else None
        answer = answers[i]
        if j < len(words) and words[j][1] == answer.word and -EARLY_S <= words[j][0] - answer.at <= BELONGS_S:
            rest = fit(i + 1, j + 1, excused)
            if rest is not None:
                return [(answer, words[j][0] - answer.at), *rest]
        if answer.may_be_missing:
            return fit(i + 1, j, excused)
        if answer.was_slow and not excused and given_up(recording, answer.call):
            return fit(i + 1, j, True)
        return None

    return fit(0, 0, False)


@criterion(points=2, title="Each answer is told: right, in time and once", needs=[calls_arrive, health_topic])
def results_told(recording: Recording) -> Verdict:
    expected = f'"ok" or "faulty", as the response says, once, at most {TOLD_WITHIN_S} s after each answer'
    fitting = delays(recording)
    if fitting is None:
        return _explain_misfit(recording, expected)
    late = [(answer, delay) for answer, delay in fitting if delay > TOLD_WITHIN_S + SLACK_S / 2]
    if len(late) > 1:
        answer, delay = late[0]
        return see.failed(
            f"{len(late)} of {len(fitting)} answers were told late: the one that came at {answer.at:.1f} s "
            f"{delay:.1f} s later",
            expected,
            "The result is picked up when the next question is asked, so each report is the one of an earlier call.",
            "Take the answer in a done callback: future.add_done_callback(self.on_answer).",
            about_time=True,
        )
    return see.passed(f"{len(fitting)} answers told")


def _explain_misfit(recording: Recording, expected: str) -> Verdict:
    """Which answer was told wrongly, or not at all, or too often."""
    answers, words = answers_in(recording), told(recording, *WORDS.values())
    _, in_vain = given_up_in_vain(recording)
    if len(words) > len(answers) + 1:
        return see.failed(
            f"{len(answers)} answers came, and your node reported {len(words)} results",
            expected,
            "An answer is reported twice: by two methods, or again and again until the next one comes.",
            "Publish in one place only: where the answer comes in.",
        )
    for answer in answers:
        if answer.may_be_missing:
            continue
        response = f"success={answer.word == 'ok'}"
        in_time = [word for t, word in words if -EARLY_S <= t - answer.at <= TOLD_WITHIN_S + SLACK_S / 2]
        too_soon = [t for t in in_vain if 0.0 < t - answer.call.t < ASKED_EVERY_S + SLACK_S]
        if too_soon and too_soon[0] < answer.at:
            return see.failed(
                f"the call at {answer.call.t:.1f} s was answered with {response} after "
                f'{answer.at - answer.call.t:.1f} s, and your node had said "{NO_ANSWER}" after '
                f"{too_soon[0] - answer.call.t:.1f} s",
                expected,
                "It has given up too early: an answer may take 0.8 s.",
                "Give a call up when the next one is due, and no earlier.",
                about_time=True,
            )
        if too_soon or not in_time:
            return see.failed(
                f"the call at {answer.call.t:.1f} s was answered with {response} at {answer.at:.1f} s, and "
                + (f'your node said "{NO_ANSWER}"' if too_soon else f'nothing said "{answer.word}"'),
                expected,
                "The answer is in the process, but nobody takes it in: the callback that asked still waits and holds "
                "the thread or the callback group of the client, or it has given up too early (an answer may take "
                "0.8 s), or nothing looks at the future.",
                "Return from the callback that asks, and publish in a done callback of the future.",
                about_time=True,
            )
        if answer.word not in in_time:
            return see.failed(
                f'the call at {answer.call.t:.1f} s was answered with {response}, and your node said "{in_time[0]}"',
                expected,
                "That is the result of another call, or the field success of the response was not looked at.",
                "In the done callback, look at the future that it got: future.result().success.",
            )
    return see.failed(
        f"{len(answers)} answers came, but the {len(words)} results on {HEALTH.name} are others, or in another order",
        expected,
        "A result is reported that belongs to another call.",
        "In the done callback, look at the future that it got, and at no other.",
    )


@criterion(
    points=2,
    title='"no answer" is told within 2 s, and only where there was none',
    needs=[calls_arrive, health_topic],
)
def unanswered_told(recording: Recording) -> Verdict:
    expected = f'"{NO_ANSWER}" once for a call without an answer, at most {GIVEN_UP_WITHIN_S:.0f} s after it'
    untold, false = given_up_in_vain(recording)
    if untold:
        call = untold[0]
        later = [t for t in false if t > call.t]
        return see.failed(
            f"the call at {call.t:.1f} s got no answer, and your node "
            + (f"said so {later[0] - call.t:.1f} s later" if later else "said nothing of it"),
            expected,
            "The call is given up too late: after more than two seconds, or only with the second question after it."
            if later
            else "A future without an answer calls nobody: no done callback, no error, for the rest of its life.",
            "Remember the open call. When a second has passed, report it, and forget it with "
            "remove_pending_request(future).",
            about_time=True,
        )
    false = [t for t in false if t > FIRST_SECONDS_S]
    slow = [answer for answer in answers_in(recording) if answer.was_slow]
    if len(false) == 1 and any(given_up(recording, answer.call) for answer in slow):
        false = []  # a very busy machine
    if not false:
        return see.passed(f'"{NO_ANSWER}" for each call without an answer, and no false alarm')
    before = [call for call in asked(recording) if call.t < false[0]]
    answered = before[-1].answered_t if before else None
    if answered is None:
        return see.failed(
            f'"{NO_ANSWER}" at {false[0]:.1f} s, for the second time',
            expected,
            "The call that was given up is still kept, and reported again.",
            "Forget a call when you have reported it.",
        )
    return see.failed(
        f'"{NO_ANSWER}" at {false[0]:.1f} s, but the call at {before[-1].t:.1f} s was answered after '
        f"{answered - before[-1].t:.1f} s",
        expected,
        "Either it gives up too early (an answer may take 0.8 s), or it waits in a callback, and so the answer that "
        "has come cannot be taken in.",
        "Give up no earlier than the next question, and do not wait in the callback.",
        about_time=True,
    )


@criterion(points=1, title="The program is still alive at the end", needs=[program_runs])
def alive_at_end(recording: Recording) -> Verdict:
    return see.alive_at_end(recording)


def open_for_long(recording: Recording) -> list[tuple[float, float]]:
    """From when to when a call of the program waited for its answer, where that took long."""
    spans = [
        (call.t, call.t + MAY_COME_UNTIL_S if call.answered_t is None else call.answered_t)
        for call in asked(recording)
        if EARLY_S <= call.t < recording.robot_s - 1.0
    ]
    return [(begin + EDGE_S, end - EDGE_S) for begin, end in spans if end - begin > SLOW / 2]


@criterion(points=2, title="The heart beats at 5 Hz, whatever happens to a call", needs=[alive_at_end])
def heartbeat_steady(recording: Recording) -> Verdict:
    exists = see.all_of(
        see.publishes(recording, HEARTBEAT), see.no_message(recording, HEARTBEAT) or see.passed("it beats")
    )
    if not exists.ok:
        return exists
    expected = "5 Hz: a beat every 0.2 s, also while a call waits for its answer"
    beats = [arrival.t for arrival in recording.topic(HEARTBEAT.name).arrivals]
    spans = open_for_long(recording)
    due = sum(end - begin for begin, end in spans) * 5.0
    came = sum(begin <= t <= end for begin, end in spans for t in beats)
    if due > 1.0 and came < LEAST_SHARE * due:
        silent = [begin for begin, end in spans if not any(begin <= t <= end for t in beats)] or [spans[0][0]]
        return see.failed(
            f"while a call was waiting for its answer, {came} beats came, and {due:.0f} were due: for example, none "
            f"after the call at {silent[0] - EDGE_S:.1f} s",
            expected,
            "The callback that asks waits for the answer. While it waits, it keeps the thread, or the callback group "
            "that the heartbeat is in, and no other callback runs.",
            "Send the request with call_async() and return. Or give heartbeat and waiting callback different callback "
            "groups and a MultiThreadedExecutor.",
            about_time=True,
        )
    if recording.robot_s - beats[-1] > LONGEST_PAUSE_S:
        last = max((call.t for call in asked(recording) if call.t <= beats[-1] + 0.3), default=None)
        after = "" if last is None else f", just after the call at {last:.1f} s"
        return see.failed(
            f"the last beat came at {beats[-1]:.1f} s{after}, then none until {recording.robot_s:.1f} s",
            expected,
            "A callback has not returned: it waits for an answer that cannot come in while it waits, and keeps the "
            "thread, or the callback group that the heartbeat is in.",
            "Send the request with call_async(), add a done callback, and return.",
            about_time=True,
        )
    pace = see.topic_pace(recording, HEARTBEAT)
    typical = pace.typical_interval
    if typical is None or not 0.16 <= typical <= 0.25:
        return see.failed(
            "one single beat" if typical is None else f"typically a beat every {typical:.2g} s",
            expected,
            "The period of the timer is another one, or something holds it up again and again.",
            "5 Hz is a period of 0.2 s: create_timer(0.2, self.beat), and no callback that waits.",
            about_time=True,
        )
    return see.passed(f"{pace.count} beats, typically one every {typical:.1f} s")
