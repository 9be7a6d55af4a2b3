"""How exercise 14 is judged: twelve noisy joints whose true angles are known, and what the filter makes of them."""

import math
import operator
import random
import statistics
from collections import Counter
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, replace
from functools import wraps
from itertools import pairwise
from typing import Any

from sensor_msgs.msg import JointState

import workbook.criteria as see
from workbook.criteria import Recording, Verdict, criterion, program_runs, topic, watching

RAW = topic("/encoders/joint_states", JointState)
FILTERED = topic("/robot/joint_states", JointState)
JOINTS = (
    "neck", "waist", "left_shoulder", "left_elbow", "right_shoulder", "right_elbow",
    "left_hip", "left_knee", "left_ankle", "right_hip", "right_knee", "right_ankle",
)  # fmt: skip

PERIOD_S = 0.05  # 20 messages a second
NOISE_RAD = 0.02
LARGEST_NOISE_RAD = 0.05
MOST_NOISE = 0.55  # of what came in, all joints together
MOST_NOISE_OF_ONE = 0.8  # of a single joint
LONGEST_DELAY_S = 0.27
LONGEST_DELAY_OF_ONE_S = 0.32  # of a single joint, whose noise blurs it
NEAR_RAD = 0.1  # so near is an angle to the joint at a start, and while NaN comes
AT_ONCE_S = 0.5
SHARE_AT_ONCE = 0.9  # of the messages: the others may have been kept waiting by a busy machine
TYPICALLY_S = 0.15
LEAST_CHANGE_RAD = 0.005  # root mean square, between what comes in and what goes out: less is no filter
SAME_RAD = 0.001  # root mean square: the same angle, but for rounding
NEARLY_ALL = 0.95  # of the noise: who leaves more takes nothing away
WIDE_GAP = 1.4  # from the noise left at one joint to that at the next: they are not filtered alike
RARELY = 0.6  # share of answers that are those before: a filter changes each of them
MORE_THAN_ALL = 1.2  # of the noise: no weak filter leaves so much, something else is added
FOLLOWS_RAD = 0.3  # so near is an angle to a joint that has moved on after NaN
FAR_BEHIND_S = 0.4  # a filter so late would be farther away than that by itself
STARTING = 8  # messages after a start that must be near
SETTLED = 20  # messages after a start or a movement until noise and delay are measured

# Where the joints stand first, how fast they move then (rad/s), and how far they are turned while the board is off,
# twice. The first time one joint is turned only a little, the second time all are: a restart is told by the stamp, not
# by a jump. Most joints stand between two multiples of 0.1 rad: on one of them, rounding would take out all the noise.
FIRST_POSE = (0.54, -0.65, 1.23, 0.94, -1.15, 0.86, -0.73, 1.05, -0.46, 0.64, -0.95, 0.77)
SPEEDS = (0.5, -0.4, 0.5, 0.4, -0.5, 0.5, -0.4, 0.4, -0.5, 0.5, -0.4, 0.5)
TURNED = (
    (-0.6, 0.5, -0.7, -0.8, 0.6, -0.2, 0.7, -0.6, 0.5, -0.8, 0.6, -0.5),
    (0.23, -0.24, 0.22, 0.24, -0.23, 0.24, -0.23, 0.22, -0.24, 0.24, -0.22, 0.23),
)
STANDS, MOVES, STANDS_AGAIN, MOVES_BACK, AFTER_RESTART, AFTER_SECOND = 46, 34, 44, 30, 36, 9  # messages
STILL_UNTIL = STANDS + MOVES + STANDS_AGAIN
RESTART = STILL_UNTIL + MOVES_BACK
RESTART_AGAIN = RESTART + AFTER_RESTART
MESSAGES = RESTART_AGAIN + AFTER_SECOND  # a prime number: who answers in groups leaves a rest
STARTS = (range(RESTART), range(RESTART, RESTART_AGAIN), range(RESTART_AGAIN, MESSAGES))
# The fraction of each stamp after a restart is above that of the last one before (47.65 s and 2.50 s).
START_STAMPS_MS = (40_000, 750, 560)
NAN_AT: Mapping[int, tuple[int, ...]] = {
    # message: joints whose encoder gives NaN
    STANDS + MOVES + 24: (3,),
    STANDS + MOVES + 30: (0, 7),
    STANDS + MOVES + 31: (0, 7),
    STANDS + MOVES + 32: (7,),
    STANDS + MOVES + 36: tuple(range(len(JOINTS))),
}


SECOND_IN_A_ROW = STANDS + MOVES + 31


@dataclass(frozen=True)
class Sample:
    """One message of the encoders: its stamp (s, ns), where the joints really are, and what is measured (rad)."""

    stamp: tuple[int, int]
    truth: tuple[float, ...]
    measured: tuple[float, ...]


def samples() -> tuple[Sample, ...]:
    """All messages, in order: the board is switched on, works, and is switched off and on again twice."""
    dice = random.Random(14)
    made = []
    for place in range(MESSAGES):
        forth, back = min(max(place - STANDS + 1, 0), MOVES), min(max(place - STILL_UNTIL + 1, 0), MOVES_BACK)
        moving_s = PERIOD_S * (forth - back)
        since = next(number for number, start in enumerate(STARTS) if place in start)
        truth = tuple(
            start + speed * moving_s + sum(turned)
            for start, speed, *turned in zip(FIRST_POSE, SPEEDS, *TURNED[:since], strict=True)
        )
        noise = [dice.gauss(0.0, NOISE_RAD) for _ in JOINTS]
        measured = [
            angle + min(max(one, -LARGEST_NOISE_RAD), LARGEST_NOISE_RAD)
            for angle, one in zip(truth, noise, strict=True)
        ]
        for joint in NAN_AT.get(place, ()):
            measured[joint] = math.nan
        in_ms = START_STAMPS_MS[since] + (place - STARTS[since][0]) * round(PERIOD_S * 1e3)
        made.append(Sample((in_ms // 1000, in_ms % 1000 * 10**6), truth, tuple(measured)))
    return tuple(made)


SAMPLES = samples()
PLACE_OF = {sample.stamp: place for place, sample in enumerate(SAMPLES)}
STEADY_FIRST, STEADY_LAST = range(SETTLED, STANDS), range(RESTART + SETTLED, RESTART_AGAIN - 4)
STEADY = (*STEADY_FIRST, *STEADY_LAST)
WITH_NAN = range(min(NAN_AT), STILL_UNTIL)
MOVED_ON = RESTART - 5  # the answers just before the restart may be mixed with what came after it
MOVING, MOVING_BACK = range(STANDS + SETTLED, STANDS + MOVES), range(STILL_UNTIL + SETTLED, MOVED_ON + 1)

BEGIN_S = 0.5
SAID_AT = tuple(round(BEGIN_S + place * PERIOD_S, 2) for place in range(len(SAMPLES)))
WATCH_S = SAID_AT[-1] + 1.0
WATCH = watching(
    simulated_seconds=WATCH_S,
    wall_seconds=WATCH_S,
    script=[
        see.publish(
            RAW.name,
            JointState,
            [
                (
                    at,
                    {
                        "header": {"stamp": {"sec": sample.stamp[0], "nanosec": sample.stamp[1]}},
                        "name": list(JOINTS),
                        "position": list(sample.measured),
                    },
                )
                for at, sample in zip(SAID_AT, SAMPLES, strict=True)
            ],
        )
    ],
)


@criterion(points=1, title="It subscribes to /encoders/joint_states, type JointState", needs=[program_runs])
def listens(recording: Recording) -> Verdict:
    return see.listens(recording, RAW)


@criterion(points=1, title="/robot/joint_states carries JointState", needs=[program_runs])
def output_topic(recording: Recording) -> Verdict:
    verdict = see.publishes(recording, FILTERED)
    if not verdict.ok and recording.topic(RAW.name).publishers:
        return see.failed(
            "output-topic.publishes-where-it-listens",
            f"your node publishes {RAW.name}, but nothing on {FILTERED.name}",
            verdict.expected,
            "It publishes to the topic that it subscribes to. So every message that it publishes triggers another "
            "one, endlessly.",
            f"Write the name as {FILTERED.name!r}.",
        )
    return verdict


@criterion(points=0, title="It answers", needs=[listens, output_topic])
def answers_come(recording: Recording) -> Verdict:
    if recording.topic(FILTERED.name).arrivals:
        return see.passed("answers come")
    nothing = f"{len(SAMPLES)} messages were sent to {RAW.name}, but nothing arrived on {FILTERED.name}"
    return see.ended_or_error(recording, nothing, ONE_EACH) or see.failed(
        "answers-come.nothing",
        nothing,
        ONE_EACH,
        "Either nothing spins the node, so the callback never runs, or the callback doesn't publish. Or you spin "
        "it with rclpy.experimental.EventsExecutor, whose spin() runs no callbacks in this build of rclpy.",
        "Spin the node with rclpy.spin(node), and publish inside the callback.",
        about_time=True,
    )


Judges = Callable[[Recording], Verdict]


def needs_messages_known(judge: Judges) -> Judges:
    """Judge only where each answer has an angle for each joint, and it can be told which message it is for."""

    @wraps(judge)
    def judge_if_known(recording: Recording) -> Verdict:
        given = answers(recording)
        if any(len(answer.angles) != len(JOINTS) for answer in given):
            return see.not_judged("some answers do not have an angle for each joint")
        if any(answer.place is None for answer in given):
            return see.not_judged("it cannot be told which message each answer is for")
        return judge(recording)

    return judge_if_known


@criterion(
    points=1, title="Each answer has the stamp, the names, and an angle for each joint", needs=[answers_come]
)
def labels_kept(recording: Recording) -> Verdict:
    given = answers_as_they_came(recording)
    strange = [answer for answer in given if answer.place is None]
    if strange:
        return why_strange_stamps(strange, len(given))
    if len(given) > STARTING and len({answer.stamp_s for answer in given}) == 1:
        return see.failed(
            "labels-kept.one-stamp",
            f"all {see.count(len(given), 'answer')} have the same stamp, {given[0].stamp_s:.2f} s",
            BOARD_STAMPS,
            "The header of one message is kept, and used for all answers.",
            "Copy the header of the message that you answer, in each call: answer.header = message.header.",
        )
    others = [answer for answer in given if answer.names != JOINTS]
    if others:
        return why_other_names(others, len(given))
    lengths = sorted({len(answer.angles) for answer in given} - {len(JOINTS)})
    if lengths:
        return see.failed(
            "labels-kept.other-length",
            f"{lengths[0]} angles for {len(JOINTS)} names",
            f"an angle for each of the {len(JOINTS)} names",
            "The angles go through an array of another shape, or only some joints are filtered and kept.",
            "Print filtered.shape; publish one angle for each joint: position = filtered.tolist().",
        )
    return see.passed(f"{see.count(len(given), 'answer')} with stamp, names and {len(JOINTS)} angles")


@criterion(points=2, title="Every message is answered once, right away, in order", needs=[answers_come])
@needs_messages_known
def every_one_answered(recording: Recording) -> Verdict:
    places = [answer.place for answer in answers(recording) if answer.place is not None]
    times = Counter(places)
    twice = [place for place, number in times.items() if number > 1]
    if twice:
        return why_repeated(twice, times) or see.failed(
            "every-one-answered.repeated",
            f"{see.count(len(twice), 'message')} answered more than once, {shown(twice[0])} {times[twice[0]]} times",
            ONE_EACH,
            "A timer or a loop publishes an answer again, or two subscriptions use the same topic.",
            "One subscription, and one publish for each call of the callback.",
        )
    missing = [place for place in range(len(SAMPLES)) if place not in times]
    if missing:
        return why_missing(recording, missing)
    if places != sorted(places):
        at = next(n for n, place in enumerate(places) if place != n)
        return see.failed(
            "every-one-answered.other-order",
            f"answer {at + 1} was for {shown(places[at])}",
            ONE_EACH,
            "Your node collects messages and answers them in another order, or from several threads at the same "
            "time.",
            "Publish inside the callback: it is called in the right order.",
        )
    return at_once(recording)


def why_repeated(twice: Sequence[int], times: Mapping[int, int]) -> Verdict | None:
    """Why just these messages were answered more than once; None if they have nothing in common."""
    saw = f"{see.count(len(twice), 'message')} answered more than once, {shown(twice[0])} {times[twice[0]]} times"
    if set(twice) <= {start[0] for start in STARTS[1:]}:
        return see.failed(
            "every-one-answered.repeated-at-restart",
            f"{saw}: the first message after a restart",
            ONE_EACH,
            "At a restart, two lines publish: the one that begins again, and the one that publishes every answer.",
            "When you begin again, only fill the state, and let one line publish all answers.",
        )
    if all(place + 1 in NAN_AT and place + 1 not in times for place in twice):
        return see.failed(
            "every-one-answered.repeated-for-nan",
            f"{saw}. Each of them is followed by a message with a NaN, which has no answer",
            ONE_EACH,
            "For a message with a NaN, the answer before is published again, with its old stamp.",
            "Replace the NaN in the angles alone. The answer has the stamp of its own message.",
        )
    return None


@criterion(points=0, title="It filters", needs=[answers_come])
@needs_messages_known
def filters(recording: Recording) -> Verdict:
    beside = why_beside(recording)
    if beside is not None:
        return beside
    if len(not_filtered(recording, LEAST_CHANGE_RAD)) < len(JOINTS):
        return see.passed("what comes out is not what went in")
    left = noise_left(recording, STEADY)
    if len(not_filtered(recording, SAME_RAD)) < len(JOINTS) and left is not None and left[0] < NEARLY_ALL:
        return see.failed(
            "filters.too-weak",
            f"the angles come out nearly as they went in: {left[0]:.0%} of the noise is left",
            f"{LITTLE_LEFT}; angles within {LEAST_CHANGE_RAD} rad (root mean square) of those received count as "
            "passed on",
            "The filter gives new measurements too much weight: the weight is near 1, or the cutoff frequency is high.",
            "Let the filter use more past messages, or give new measurements a smaller weight, such as 0.3.",
        )
    return see.failed(
        "filters.passes-through",
        "the angles come out as they went in",
        LITTLE_LEFT,
        "The filter isn't used, or its state is reset in every call. Or you run filtfilt, which needs samples on "
        "both sides, but the newest message has none after it.",
        "Keep the filter's state in an attribute of the node, and give it back to the filter in each call.",
    )


@criterion(points=1, title="At most 55 % of the noise is left", needs=[filters])
def noise_reduced(recording: Recording) -> Verdict:
    found = noise_left(recording, STEADY)
    if found is None:
        return too_few("noise-reduced.too-few-answers", recording)
    whole, left = found
    if not all(math.isfinite(one) for one in left):
        return no_numbers("noise-reduced.no-number")
    joint, off = farthest(recording, STEADY_LAST)
    if off > LARGEST_NOISE_RAD:
        return see.failed(
            "noise-reduced.beside-after-restart",
            f"a second after the restart, the answers for {JOINTS[joint]} are still typically {off:.2f} rad away "
            "from its true angle",
            LITTLE_LEFT,
            "The filter has not reached the joint. It still remembers where the joint was before, it began with "
            "zeros, or its result is no longer used.",
            "At a restart, fill the filter's state with the first message, and go on as before.",
        )
    if whole > MOST_NOISE or max(left) > MOST_NOISE_OF_ONE:
        return why_noisy(recording, whole, left)
    return see.passed(f"{whole:.0%} of the noise is left")


@criterion(points=1, title="The angles are at most 0.27 s behind", needs=[filters])
def delay_bounded(recording: Recording) -> Verdict:
    behind = delays_of(recording, MOVING, 1.0)
    if behind is None:
        return too_few("delay-bounded.too-few-answers", recording)
    if not all(map(math.isfinite, behind)):
        return no_numbers("delay-bounded.no-number")
    whole_s = of_all(behind)
    if whole_s > LONGEST_DELAY_S:
        return see.failed(
            "delay-bounded.too-late",
            f"while the joints move, the angles are {whole_s:.3f} s behind",
            f"at most {LONGEST_DELAY_S} s, where a message comes every {PERIOD_S} s",
            "The filter looks back too far: its window is too long, or its cutoff frequency too low. Or it limits how "
            "far an angle may go with each message, or an answer is the result of an earlier message.",
            "A moving average of N messages is (N - 1) / 2 messages behind. Let it look back less, and look at the "
            "noise again.",
        )
    if max(behind) > LONGEST_DELAY_OF_ONE_S:
        return why_one_late(behind)
    return why_late_back(recording, whole_s) or see.passed(f"{max(whole_s, 0.0):.2f} s behind")


@criterion(points=1, title="It begins where the joints are", needs=[filters])
def begins_near(recording: Recording) -> Verdict:
    return near_at_start(recording, 0, None)


@criterion(points=1, title="It notices the restart and begins again", needs=[filters])
def restart_noticed(recording: Recording) -> Verdict:
    for number, start in enumerate(STARTS[1:]):
        verdict = near_at_start(recording, start[0], SAMPLES[start[0] - 1].truth)
        if not verdict.ok:
            return why_not_noticed(recording, verdict, number)
    return verdict


def why_not_noticed(recording: Recording, verdict: Verdict, number: int) -> Verdict:
    """Why the filter did not begin anew at a restart; `number` counts the restarts from 0."""
    if verdict.cause == TOO_FEW:
        return verdict
    old = some_begin_anew(recording, STARTS[1 + number][0])
    if old:
        return see.failed(
            "restart-noticed.some-joints",
            f"{verdict.saw}. At the restart, other joints began again, but not {see.listing(old)}",
            verdict.expected,
            "Only joints whose angle jumped far begin again, or your code fills the state of only some joints "
            "again. A joint may also have been turned only a little.",
            "Detect the restart by the stamp alone, and begin again with all joints.",
        )
    late = why_one_late_start(recording, verdict) if number == 0 else None
    if late is not None:
        return late
    if number > 0 and verdict.cause == REMEMBERS[0]:
        return see.failed(
            "restart-noticed.first-only",
            f"{verdict.saw}. After the first restart, the filter had begun again",
            verdict.expected,
            "The second restart goes unnoticed: a flag is never cleared, the step back must be large, or the joints "
            "must have jumped far. This time they were turned only a little. The stamp "
            f"went back from {stamp_of(RESTART_AGAIN - 1):.2f} s to {stamp_of(RESTART_AGAIN):.2f} s.",
            "Compare each stamp with the one before it, and begin again whenever it's smaller.",
        )
    if not begins_anew_each_second(recording):
        return verdict
    return see.failed(
        "restart-noticed.nanosec-alone",
        f"{verdict.saw}. But at each full second the filter began again",
        verdict.expected,
        "The stamps are compared by their nanosec alone, which begins again with each second. The restart went "
        "unnoticed, because nanosec happened to increase at that moment.",
        "Compare both parts together: (sec, nanosec) as a pair, or sec * 10**9 + nanosec.",
    )


def why_one_late_start(recording: Recording, verdict: Verdict) -> Verdict | None:
    """A failed verdict if of the answers after the first restart only one is far from the joints; None if not."""
    by_place = first_answers(recording)
    known = [place for place in range(RESTART, RESTART + STARTING) if place in by_place]
    if len(known) < STARTING or verdict.cause != REMEMBERS[0] or first_far(by_place, known[1:]) is not None:
        return None
    return see.failed(
        "restart-noticed.one-late",
        f"{verdict.saw}. The answers after that are where the joints are",
        verdict.expected,
        "The filter begins again one message too late. The first answer after the restart is computed from the "
        "old state, or it's the previous message's result.",
        "Compare the stamps first, fill the state again with this message, and then filter and publish.",
    )


NAN_OUT = (
    "Before the filter, replace each NaN with the last good angle of that joint: np.isfinite(position) is False "
    "there."
)


@criterion(points=1, title="A NaN does no harm", needs=[filters])
def survives_nan(recording: Recording) -> Verdict:
    by_place = first_answers(recording)
    bad = [
        place
        for place in range(min(NAN_AT), RESTART)
        if place in by_place and not all(math.isfinite(angle) for angle in by_place[place].angles)
    ]
    nan_out = why_nan_out(bad, max((place for place in by_place if place < RESTART), default=0))
    if nan_out is not None:
        return nan_out
    lost = lost_after_nan(recording)
    if lost is not None:
        return lost
    return near(recording, WITH_NAN, OTHER_THAN_NAN)


def why_nan_out(bad: Sequence[int], last: int) -> Verdict | None:
    """Why the answers to these messages have a NaN; None if none has. `last`: the last one before a restart."""
    if bad and bad[0] == SECOND_IN_A_ROW:
        return why_second_nan(bad)
    if bad and bad[-1] == last:
        return see.failed(
            "survives-nan.never-leaves",
            f"a NaN came in with {shown(min(NAN_AT))}; {see.count(len(bad), 'answer')} since then say NaN, the last "
            f"of them for {shown(bad[-1])}",
            FINITE,
            "A NaN got into the filter's state. Every later result is computed from that state, so every later "
            "result is NaN.",
            NAN_OUT,
        )
    if not set(bad) <= set(NAN_AT):
        return see.failed(
            "survives-nan.in-the-window",
            f"{see.count(len(bad), 'answer')} went out with a NaN, the first of them for {shown(bad[0])}. Only "
            f"{see.count(len(NAN_AT), 'message')} came in with one",
            FINITE,
            "A NaN got into the filter's state, and stays there until it leaves the window. A comparison such as "
            "angle == math.nan never finds it: NaN isn't equal to itself.",
            NAN_OUT,
        )
    if bad:
        return see.failed(
            "survives-nan.passed-on",
            f"{see.count(len(bad), 'answer')} with NaN, the first of them for {shown(bad[0])}",
            FINITE,
            "The NaN is passed through to the answer.",
            NAN_OUT,
        )
    return None


def why_second_nan(bad: Sequence[int]) -> Verdict:
    """A failed verdict for NaN that gets in only where the same joint has given NaN in the message before."""
    return see.failed(
        "survives-nan.second-in-a-row",
        f"{see.count(len(bad), 'answer')} with NaN, the first of them for {shown(bad[0])}: the second message with NaN "
        "in a row from the same joint. A single NaN did no harm",
        FINITE,
        "Your code replaces NaN with the previous message's value, which may be NaN itself. Or only one NaN in a "
        "row is replaced.",
        "Store each joint's last good angle after you've replaced NaN, so that the stored angle is never NaN.",
    )


# --- what came back -----------------------------------------------------------------------------------------

ONE_EACH = f"exactly one answer on {FILTERED.name} for each of the {len(SAMPLES)} messages, in their order"
LITTLE_LEFT = (
    f"at most {MOST_NOISE:.0%} of the noise where the joints stand still, and at most {MOST_NOISE_OF_ONE:.0%} of it "
    "at each joint"
)
FINITE = f"{len(JOINTS)} finite angles in each answer"
BOARD_STAMPS = "the unchanged stamp of the message that it answers"


@dataclass(frozen=True)
class Answered:
    """One answer: which message its stamp belongs to (None: to none), its stamp (s), its names and angles (rad)."""

    place: int | None
    stamp_s: float
    names: tuple[str, ...]
    angles: tuple[float, ...]
    t: float


def answers(recording: Recording) -> list[Answered]:
    """What arrived, in order. Where stamps do not tell which message an answer is for, the order of the answers does.

    That takes one answer for each message. Until a program ends, there is one for each message as well.
    """
    given = answers_as_they_came(recording)
    known = all(answer.place is not None for answer in given)
    if known and len({answer.place for answer in given}) > 1:
        return given
    heard = len(see.published(recording, RAW.name))
    ended = recording.process.ended_by == "itself"
    if len(given) != heard and not (ended and len(given) < heard):
        return given
    return [replace(answer, place=place) for place, answer in enumerate(given)]


def answers_as_they_came(recording: Recording) -> list[Answered]:
    """What arrived on the topic of the answers, in order, with the place that its stamp tells."""
    found = []
    for arrival in recording.topic(FILTERED.name).arrivals:
        if not isinstance(arrival.value, dict):
            continue
        stamp = arrival.value["header"]["stamp"]
        key = (stamp["sec"], stamp["nanosec"])
        found.append(
            Answered(
                PLACE_OF.get(key),
                stamp["sec"] + stamp["nanosec"] / 1e9,
                sequence(arrival.value["name"]),
                sequence(arrival.value["position"]),
                arrival.t,
            )
        )
    return found


def sequence(field: Any) -> tuple[Any, ...]:
    """An array of a message; of a very long one, the first elements."""
    return tuple(field["first"] if isinstance(field, dict) else field)


def first_answers(recording: Recording) -> dict[int, Answered]:
    """For each message that was answered, by its place: its first answer."""
    found: dict[int, Answered] = {}
    for answer in answers(recording):
        if answer.place is not None:
            found.setdefault(answer.place, answer)
    return found


def errors_at(recording: Recording, places: Sequence[int]) -> list[list[float]] | None:
    """For each joint, answer minus truth (rad) at these messages; None if fewer than half of them were answered."""
    by_place = first_answers(recording)
    known = [place for place in places if place in by_place]
    if 2 * len(known) < len(places):
        return None
    return [
        [by_place[place].angles[joint] - SAMPLES[place].truth[joint] for place in known]
        for joint in range(len(JOINTS))
    ]


def noise_left(recording: Recording, places: Sequence[int]) -> tuple[float, list[float]] | None:
    """What is left of the noise (1.0: all of it): of all joints together and of each; None if too few answers came."""
    errors = errors_at(recording, places)
    if errors is None:
        return None
    came = [
        root_mean_square([SAMPLES[at].measured[joint] - SAMPLES[at].truth[joint] for at in places])
        for joint in range(len(JOINTS))
    ]
    left = [root_mean_square(row) for row in errors]
    return root_mean_square(left) / root_mean_square(came), [
        one / other for one, other in zip(left, came, strict=True)
    ]


def farthest(recording: Recording, places: Sequence[int]) -> tuple[int, float]:
    """The joint whose answers to these messages are on average farthest beside it, and how far (rad)."""
    errors = errors_at(recording, places)
    if errors is None:
        return 0, 0.0
    off = [abs(statistics.fmean(row)) for row in errors]
    worst = max(range(len(JOINTS)), key=off.__getitem__)
    return worst, off[worst]


def delays_of(recording: Recording, places: Sequence[int], way: float) -> list[float] | None:
    """How late the angles of each joint are (s) while they move, forth (`way` 1) or back (-1); None if too few came."""
    errors = errors_at(recording, places)
    if errors is None:
        return None
    return [-statistics.fmean(row) / (way * speed) for speed, row in zip(SPEEDS, errors, strict=True)]


def of_all(delays: Sequence[float]) -> float:
    """The delay of all joints together (s). A quick joint tells it better than a slow one, so it counts more."""
    weights = [speed * speed for speed in SPEEDS]
    return float(sum(map(operator.mul, weights, delays)) / sum(weights))


def why_one_late(behind: Sequence[float]) -> Verdict:
    """A failed verdict for a joint that is much later than all joints together; `behind` in s."""
    worst = max(range(len(JOINTS)), key=behind.__getitem__)
    return see.failed(
        "delay-bounded.one-joint",
        f"{JOINTS[worst]} is {behind[worst]:.2f} s behind; all joints together are {of_all(behind):.2f} s behind",
        f"at most {LONGEST_DELAY_OF_ONE_S} s at each joint, and {LONGEST_DELAY_S} s at all together",
        "Not all joints go through the same filter, or it follows an angle more slowly in one direction than in the "
        "other.",
        "Filter all joints alike, whichever way they move.",
    )


def why_late_back(recording: Recording, forth_s: float) -> Verdict | None:
    """A failed verdict for angles that are late only in the second movement; None if they are not.

    A joint that is lost since a NaN is none of this: `survives_nan` judges it.
    """
    back = delays_of(recording, MOVING_BACK, -1.0)
    if back is None or not all(map(math.isfinite, back)):
        return None
    if of_all(back) <= LONGEST_DELAY_S and max(back) <= LONGEST_DELAY_OF_ONE_S:
        return None
    if held_joints(recording, MOVING_BACK):
        return None
    worst = max(range(len(JOINTS)), key=back.__getitem__)
    return see.failed(
        "delay-bounded.later-on",
        f"in the second movement, the angles are {of_all(back):.2f} s behind, {JOINTS[worst]} {back[worst]:.2f} s. In "
        f"the first one, all together were {forth_s:.2f} s behind",
        f"at most {LONGEST_DELAY_S} s in each movement, and at most {LONGEST_DELAY_OF_ONE_S} s at each joint",
        "The filter changes on the way: its window grows, or it follows more slowly after a NaN.",
        "Keep the filter's weights unchanged, even after a NaN.",
    )


def off_at(answer: Answered, place: int) -> list[float]:
    """How far each angle of the answer to this message is from where the joint is (rad)."""
    return [abs(angle - at) for angle, at in zip(answer.angles, SAMPLES[place].truth, strict=True)]


def root_mean_square(numbers: Sequence[float]) -> float:
    return math.sqrt(statistics.fmean(number * number for number in numbers))


def stamp_of(place: int) -> float:
    """The stamp of a message (s)."""
    sec, nanosec = SAMPLES[place].stamp
    return sec + nanosec / 1e9


def shown(place: int) -> str:
    """A message by its number and stamp."""
    return f"message {place + 1} (stamp {stamp_of(place):.2f} s)"


TOO_FEW = "near.too-few-answers"
Words = tuple[str, str, str]
"""A cause, the likely reason, and one thing to try."""
OTHER_THAN_NAN: Words = (
    "survives-nan.other-angle",
    "Instead of NaN, the filter gets a number that is unrelated to the joint, such as 0. Or joints without NaN "
    "are changed as well.",
    "Replace it with the same joint's last good angle, and leave the other joints alone.",
)

ZEROS_AT_START: Words = (
    "begins-near.swings-in",
    "The filter's state begins with zeros, and it takes a while to move away from them.",
    "Fill the state with the first message: for sosfilt, zi = sosfilt_zi(sos) times the first angle.",
)
ELSEWHERE_AT_START: Words = (
    "begins-near.elsewhere",
    "At the start, the filter's state doesn't contain the first message's angles.",
    "Fill the state with the first message, for each joint by itself.",
)
REMEMBERS: Words = (
    "restart-noticed.remembers",
    "The joints were turned while the board was off. The filter's state still contains the earlier angles.",
    "When a stamp is earlier than the previous one, fill the filter's state again, as at the start.",
)
ZEROS_AGAIN: Words = (
    "restart-noticed.zeros",
    "After the restart, there are zeros in the filter's state or in its answers.",
    "Fill the state with the first message after the restart, by the same lines as at the start.",
)
ELSEWHERE_AGAIN: Words = (
    "restart-noticed.elsewhere",
    "After the restart, the filter's state doesn't contain the angles of the first message since then.",
    "When a stamp is earlier than the previous one, fill the filter's state again, as at the start.",
)


def near(recording: Recording, places: Sequence[int], words: Words) -> Verdict:
    """Whether the answers to these messages are near the joints."""
    by_place = first_answers(recording)
    known = [place for place in places if place in by_place]
    if 2 * len(known) < len(places):
        return too_few(TOO_FEW, recording)
    bad = first_far(by_place, known)
    if bad is None:
        return see.passed(f"within {NEAR_RAD} rad at every joint")
    place, joint = bad
    cause, because, try_this = words
    return see.failed(
        cause,
        f"{shown(place)}: {JOINTS[joint]} is at {SAMPLES[place].truth[joint]:.2f} rad, and the answer "
        f"says {by_place[place].angles[joint]:.2f}",
        f"an angle within {NEAR_RAD} rad of the joint, for each joint, from {shown(places[0])} on",
        because,
        try_this,
    )


def first_far(by_place: Mapping[int, Answered], places: Sequence[int]) -> tuple[int, int] | None:
    """The first of these messages whose answer is not near, and the joint; None if all are near."""
    for place in places:
        for joint, angle in enumerate(by_place[place].angles):
            if not abs(angle - SAMPLES[place].truth[joint]) <= NEAR_RAD:
                return place, joint
    return None


def near_at_start(recording: Recording, start: int, before: Sequence[float] | None) -> Verdict:
    """Whether the first answers after a start are near. `before`: where the joints (rad) were last, if anywhere."""
    by_place = first_answers(recording)
    known = [place for place in range(start, start + SETTLED) if place in by_place][:STARTING]
    if 2 * len(known) < STARTING:
        return near(recording, range(start, start + STARTING), REMEMBERS)
    bad = first_far(by_place, known)
    if bad is None:
        return near(recording, known, REMEMBERS)
    truth, angles = SAMPLES[bad[0]].truth, by_place[bad[0]].angles
    zeros = pulled(angles, truth, [0.0] * len(JOINTS))
    if before is None:
        return near(recording, known, ZEROS_AT_START if zeros <= NEAR_RAD else ELSEWHERE_AT_START)
    back = pulled(angles, truth, before)
    if min(zeros, back) > NEAR_RAD:
        return near(recording, known, ELSEWHERE_AGAIN)
    return near(recording, known, ZEROS_AGAIN if zeros < back else REMEMBERS)


def some_begin_anew(recording: Recording, start: int) -> list[str]:
    """The joints that do not begin anew at a restart, where others do; none if all do, or none does."""
    answer = first_answers(recording).get(start)
    if answer is None:
        return []
    came = SAMPLES[start].measured
    old = [
        name
        for name, angle, at in zip(JOINTS, answer.angles, came, strict=True)
        if not abs(angle - at) <= SAME_RAD
    ]
    return old if len(old) < len(JOINTS) else []


def pulled(angles: Sequence[float], truth: Sequence[float], to: Sequence[float]) -> float:
    """How badly (rad, root mean square) the angles fit a part of the way from where the joints are to `to`."""
    way = [end - begin for begin, end in zip(truth, to, strict=True)]
    off = [angle - at for angle, at in zip(angles, truth, strict=True)]
    if not all(map(math.isfinite, off)):
        return math.inf
    part = sum(one * other for one, other in zip(off, way, strict=True)) / sum(one * one for one in way)
    if part <= 0.0:
        return math.inf
    return root_mean_square([one - part * other for one, other in zip(off, way, strict=True)])


def begins_anew_each_second(recording: Recording) -> bool:
    """Whether the filter begins anew whenever nanosec begins again, and at no other message that is judged."""
    by_place = first_answers(recording)

    def as_it_came(place: int) -> bool:
        return all(
            abs(angle - came) <= SAME_RAD
            for angle, came in zip(by_place[place].angles, SAMPLES[place].measured, strict=True)
        )

    known = [place for place in range(1, STILL_UNTIL) if place in by_place and place not in NAN_AT]
    anew = [place for place in known if as_it_came(place)]
    return bool(anew) and anew == [place for place in known if SAMPLES[place].stamp[1] == 0]


def lost_after_nan(recording: Recording) -> Verdict | None:
    """A failed verdict for a joint that is not followed any more when it moves after NaN; None if all are."""
    answer, behind = first_answers(recording).get(MOVED_ON), delays_of(recording, MOVING, 1.0)
    if answer is None or behind is None or not of_all(behind) <= FAR_BEHIND_S:
        return None
    truth, off = SAMPLES[MOVED_ON].truth, off_at(answer, MOVED_ON)
    worst = max(range(len(JOINTS)), key=off.__getitem__)
    if off[worst] <= FOLLOWS_RAD:
        return None
    saw = (
        f"after the NaN, {JOINTS[worst]} has moved to {truth[worst]:.2f} rad, and the answer says "
        f"{answer.angles[worst]:.2f}"
    )
    if not held_joints(recording, MOVING_BACK):
        return see.failed(
            "survives-nan.follows-slowly",
            f"{saw}. In the first movement the answers were {of_all(behind):.2f} s behind",
            f"an angle within {FOLLOWS_RAD} rad of the joint when it moves again",
            "After the NaN, the filter follows more slowly than before.",
            "Keep the filter's weights unchanged, even after a NaN.",
        )
    return see.failed(
        "survives-nan.not-followed",
        saw,
        f"an angle within {FOLLOWS_RAD} rad of the joint when it moves again",
        "A NaN got into the filter's state, and it stays there. The value that you publish instead, such as 0 or "
        "the last answer, only hides it. Or a joint that gave NaN once is held from then on.",
        "Replace each NaN before the filter, not after it: put in the last good angle of that joint. "
        "np.isfinite is False for a NaN.",
    )


def at_once(recording: Recording) -> Verdict:
    """All messages were answered, in order; whether at once.

    Simulated time waits for a callback that sleeps or computes. So there the real time from each message to its answer
    counts, and who takes longer than a period is judged in real time.
    """
    said_at = [word.t for word in see.published(recording, RAW.name)]
    took_s = real_seconds(recording)
    if recording.clock == "simulated" and took_s > PERIOD_S:
        return see.failed(
            "every-one-answered.too-slow",
            f"an answer takes {took_s:.2f} s on average, and a message comes every {PERIOD_S} s",
            f"typically within {TYPICALLY_S} s, and {SHARE_AT_ONCE:.0%} of them within {AT_ONCE_S} s",
            "The callback sleeps or takes long to compute.",
            "Remove the sleep from the callback, so that each call answers its message right away.",
            about_time=True,
        )
    waited = [answer.t - at for at, answer in zip(said_at, answers(recording), strict=False)]
    late = [one for one in waited if one > AT_ONCE_S]
    typical = statistics.median(waited)
    if typical <= TYPICALLY_S and len(late) <= (1.0 - SHARE_AT_ONCE) * len(waited):
        return see.passed(f"{len(SAMPLES)} messages, {len(SAMPLES)} answers")
    return see.failed(
        "every-one-answered.late",
        f"an answer came typically {typical:.2f} s after its message, and {len(late)} of {len(waited)} more than "
        f"{AT_ONCE_S} s after it",
        f"typically within {TYPICALLY_S} s, and {SHARE_AT_ONCE:.0%} of them within {AT_ONCE_S} s",
        "Messages are collected and answered later, by a timer or in groups. Or the callback sleeps, or takes long to "
        "compute.",
        "Publish each answer in the callback, right away, and don't sleep there.",
        about_time=True,
    )


def real_seconds(recording: Recording) -> float:
    """How long (s of real time) an answer takes on average; all messages were answered, in order."""
    arrivals = recording.topic(FILTERED.name).arrivals
    pairs = zip(see.published(recording, RAW.name), arrivals, strict=False)
    return statistics.fmean(arrival.published - word.wall for word, arrival in pairs)


# --- why it is not as it should be --------------------------------------------------------------------------


def why_strange_stamps(strange: list[Answered], given: int) -> Verdict:
    """Why stamps are not those of messages."""
    saw = f"{len(strange)} of {see.count(given, 'answer')} with a stamp that no message had, the first {{}}"
    stamps = {answer.stamp_s for answer in strange}
    if stamps == {0.0} and len(strange) == given:
        return see.failed(
            "labels-kept.no-stamp",
            saw.format("0 s"),
            BOARD_STAMPS,
            "Your code publishes a new message without filling in its header.",
            "Copy the header: answer.header = message.header.",
        )
    if len(strange) <= 3 and given > len(SAMPLES) // 2:
        return see.failed(
            "labels-kept.extra-message",
            saw.format(f"{strange[0].stamp_s:g} s"),
            f"on {FILTERED.name} only answers, each with {BOARD_STAMPS}",
            "In addition to its answers, the node publishes a message that answers none, such as an empty one at "
            "the start.",
            "Publish in the callback of the subscription only.",
        )
    if all(any(int(one) == sec for sec, _ in PLACE_OF) for one in stamps) and len(stamps) < given:
        return see.failed(
            "labels-kept.rounded-stamp",
            saw.format(f"{strange[0].stamp_s:g} s"),
            BOARD_STAMPS,
            "A part of the stamp got lost: it has seconds (sec) and billionths of a second (nanosec).",
            "Copy the whole header: answer.header = message.header.",
        )
    return see.failed(
        "labels-kept.own-stamp",
        saw.format(f"{strange[0].stamp_s:.2f} s"),
        BOARD_STAMPS,
        "The node stamps its answers with its own clock. But the stamp must tell when an angle was measured, not "
        "when it was published.",
        "Copy the header: answer.header = message.header.",
    )


def why_other_names(others: list[Answered], given: int) -> Verdict:
    """Why names are not those of the messages."""
    names = others[0].names
    expected = f"the {len(JOINTS)} names of the message, in the same order"
    if not names:
        return see.failed(
            "labels-kept.no-names",
            f"no names in {len(others)} of {see.count(given, 'answer')}",
            expected,
            "Your code publishes a new message without filling in the names. So a subscriber can't know which "
            "angle belongs to which joint.",
            "Copy them: answer.name = message.name.",
        )
    if sorted(names) == sorted(JOINTS):
        return see.failed(
            "labels-kept.other-order",
            f"the first name is {names[0]}, but in the message it was {JOINTS[0]}",
            expected,
            "Your code sorts the names, or takes them from a set. An angle belongs to the name at the same "
            "position.",
            "Copy them unchanged: answer.name = message.name.",
        )
    return see.failed(
        "labels-kept.other-names",
        f"{see.count(len(names), 'name')}, the first is {names[0]}",
        expected,
        "The names are the node's own, or only some of them.",
        "Copy them unchanged: answer.name = message.name.",
    )


def why_missing(recording: Recording, missing: list[int]) -> Verdict:
    """Why these messages, by their places, were not answered."""
    saw = (
        f"{len(SAMPLES) - len(missing)} of {len(SAMPLES)} messages were answered; the first that was not is "
        f"{shown(missing[0])}"
    )
    error = see.last_error(recording)
    if recording.process.ended_by == "itself" and error is not None:
        return see.failed(
            error.cause,
            f"{saw}. Your program had ended by then: {error.where}{error.error}",
            ONE_EACH,
            error.because,
            error.try_this,
        )
    if missing[-1] == len(SAMPLES) - 1 and (ended := see.program_ended(recording, saw, ONE_EACH)) is not None:
        return ended
    by_place, words = first_answers(recording), see.published(recording, RAW.name)
    waited = [by_place[place].t - word.t for place, word in enumerate(words) if place in by_place]
    typical = statistics.median(waited) if waited else 0.0
    if typical > AT_ONCE_S:
        return see.failed(
            "every-one-answered.falls-behind",
            f"{saw}. Those that came were typically {typical:.1f} s after their messages",
            ONE_EACH,
            "The callback sleeps or computes longer than the time between two messages, so they pile up.",
            "Remove the sleep from the callback, so that each call answers its message right away.",
            about_time=True,
        )
    return missing_for_a_reason(saw, missing) or see.failed(
        "every-one-answered.missing",
        saw,
        ONE_EACH,
        "The node was busy or its queue too short while they came, or a timer answers only the newest. Or there are "
        "messages that the callback does not answer.",
        "Publish inside the callback, in every call of it, keep it short, and give the subscription a depth of 10 or "
        "more.",
        about_time=True,
    )


def missing_for_a_reason(saw: str, missing: list[int]) -> Verdict | None:
    """Why just these messages were not answered; None if they have nothing in common."""
    if set(missing) <= set(NAN_AT):
        return see.failed(
            "every-one-answered.nan-left-out",
            saw,
            ONE_EACH,
            "Messages with a NaN are left out. But the other joints were measured, and the controller of the robot "
            "waits for an answer.",
            "Replace the NaN with the last good angle, and answer.",
            about_time=True,
        )
    if missing == [*range(missing[0], len(SAMPLES))] and missing[0] > RESTART:
        return see.failed(
            "every-one-answered.held-back",
            f"{saw}, and so were all messages after it",
            ONE_EACH,
            "The filter looks ahead: it answers a message only when later ones have come, and after the last one none "
            "comes.",
            "Use only this message and those before it, and publish in each call of the callback.",
            about_time=True,
        )
    return missing_after_a_start(saw, missing)


def missing_after_a_start(saw: str, missing: list[int]) -> Verdict | None:
    """Why just messages after a start were not answered; None if there are others."""
    if missing == [*range(RESTART, len(SAMPLES))]:
        return see.failed(
            "every-one-answered.none-after-restart",
            f"{saw}, and it was the first after the restart: none of those after it was answered",
            ONE_EACH,
            "Messages whose stamp is not after the last one are dropped. But after a restart, all stamps are small.",
            "When a stamp is earlier than the previous one, begin again, and answer.",
            about_time=True,
        )
    if all(are_first(start, missing) for start in STARTS):
        return see.failed(
            "every-one-answered.first-left-out",
            f"{saw}; after a start, the answers begin late",
            ONE_EACH,
            "The filter waits until its state is full, or the first messages only fill it.",
            "Fill the whole state with the first message, and answer from the first message on.",
            about_time=True,
        )
    return None


def are_first(start: range, missing: list[int]) -> bool:
    """Whether no message after a start is missing but the first ones."""
    here = [place for place in missing if place in start]
    return here == [*start[: len(here)]] and len(here) < len(start)


def not_filtered(recording: Recording, change_rad: float) -> list[int]:
    """The joints whose angles change by at most so much (root mean square), where they stand still and no NaN comes."""
    by_place = first_answers(recording)
    known = [place for place in STEADY if place in by_place]
    return [
        joint
        for joint in range(len(JOINTS))
        if known
        and root_mean_square(
            [by_place[place].angles[joint] - SAMPLES[place].measured[joint] for place in known]
        )
        <= change_rad
    ]


def why_beside(recording: Recording) -> Verdict | None:
    """Why what comes out is beside the joints where they stood first, a second after the start; None if it is not."""
    joint, off = farthest(recording, STEADY_FIRST)
    if not off > LARGEST_NOISE_RAD:
        return None
    by_place = first_answers(recording)
    rows = [by_place[place].angles for place in STEADY_FIRST if place in by_place]
    means = [statistics.fmean(column) for column in zip(*rows, strict=True)]
    saw = f"{JOINTS[joint]} stands at {FIRST_POSE[joint]:.2f} rad, and the answers say {means[joint]:.2f} on average"
    expected = f"the angle of each joint, without its noise: at most {MOST_NOISE:.0%} of that is left"
    if rounded(rows) and not whole_numbers(rows):
        return why_rounded(saw, expected)
    if whole_numbers(rows):
        return see.failed(
            "filters.whole-numbers",
            f"{saw}; every angle is a whole number",
            expected,
            "The angles go through an array of whole numbers, such as np.zeros(12, dtype=int), or through int().",
            "Make the array with np.zeros(12), which holds floats.",
        )
    return why_all_beside(means, saw, expected) or see.failed(
        "filters.mixes-joints",
        saw,
        expected,
        "The answer for one joint is made of the angles of others. All joints share one state, or the filter runs "
        "along the joints and not along time, or angles and names are in another order.",
        "Give each joint its own state. In an array of messages, time is axis 0, and the joints are axis 1.",
    )


def why_all_beside(means: Sequence[float], saw: str, expected: str) -> Verdict | None:
    """A failed verdict for answers, on average `means`, that are beside all joints alike; None if they are not."""
    beside = [one - at for one, at in zip(means, FIRST_POSE, strict=True)]
    if max(beside) - min(beside) <= NOISE_RAD:
        return see.failed(
            "filters.offset",
            f"{saw}; the answers for all joints are off by about {statistics.fmean(beside):+.2f} rad",
            expected,
            "The same number is added to every angle, or subtracted from it.",
            "Publish the filter's result unchanged.",
        )
    gain = sum(one * at for one, at in zip(means, FIRST_POSE, strict=True)) / sum(
        at * at for at in FIRST_POSE
    )
    allowed = LARGEST_NOISE_RAD * max(1.0, abs(gain))
    if max(abs(one - gain * at) for one, at in zip(means, FIRST_POSE, strict=True)) <= allowed:
        return why_scaled(saw, expected, gain)
    return None


def why_scaled(saw: str, expected: str, gain: float) -> Verdict:
    """A failed verdict for answers that are `gain` times the angle at every joint."""
    advice = "Give it the same angle again and again: just that angle must come out."
    if abs(gain) < NEAR_RAD:
        return see.failed(
            "filters.nothing-left",
            f"{saw}; all answers are about 0",
            expected,
            "The filter removes the constant part along with the noise, for example because it subtracts a mean. "
            "Or the array that is published was never filled.",
            advice,
        )
    return see.failed(
        "filters.gain",
        f"{saw}; all answers are about {gain:.2g} times the angle",
        expected,
        "The weights of the filter do not add up to 1, or the angles are in another unit. Or the filter began at "
        "zero and still hasn't arrived a second later.",
        advice,
    )


def why_noisy(recording: Recording, whole: float, left: Sequence[float]) -> Verdict:
    """Why so much of the noise is left."""
    raw = [joint for joint in not_filtered(recording, SAME_RAD) if left[joint] >= NEARLY_ALL]
    worst = max(range(len(JOINTS)), key=left.__getitem__)
    saw = f"{whole:.1%} of the noise is left, at {JOINTS[worst]} {left[worst]:.1%}"
    if raw:
        return see.failed(
            "noise-reduced.some-joints",
            f"{saw}: {as_they_went_in(raw)}",
            LITTLE_LEFT,
            "Only some of the joints go through the filter.",
            "Filter the whole array, or make one filter for each name.",
        )
    for why in why_held, why_begun_anew, why_no_filter, why_to_one_side:
        of_its_own_kind = why(recording, saw)
        if of_its_own_kind is not None:
            return of_its_own_kind
    if whole > NEARLY_ALL or max(left) > MORE_THAN_ALL:
        return see.failed(
            "noise-reduced.none",
            saw,
            LITTLE_LEFT,
            "The filter's state isn't kept between calls, so each call begins with the initial state. Or "
            "something after the filter adds as much noise as the filter removes.",
            "In each call, pass the filter the state that it returned in the last one, and publish its result "
            "unchanged.",
        )
    return why_unlike(saw, left) or see.failed(
        "noise-reduced.too-little",
        saw,
        LITTLE_LEFT,
        "The filter lets too much through: its window is too short, its cutoff frequency too high, or its weight for "
        "new measurements too large.",
        "A moving average of N messages leaves 1/sqrt(N) of the noise. Use more past messages, and then check the "
        "delay again.",
    )


def why_unlike(saw: str, left: Sequence[float]) -> Verdict | None:
    """A failed verdict for joints that are filtered enough beside others that are not; None without such a gap."""
    order = sorted(left)
    factor, enough = max((more / less, place + 1) for place, (less, more) in enumerate(pairwise(order)))
    if factor < WIDE_GAP or order[enough - 1] > MOST_NOISE_OF_ONE or order[enough] <= MOST_NOISE:
        return None
    return see.failed(
        "noise-reduced.unlike-joints",
        f"{saw}. At {see.count(enough, 'joint')} of {len(JOINTS)}, at most {order[enough - 1]:.0%} is left, at the "
        f"others {order[enough]:.0%} or more",
        LITTLE_LEFT,
        "Not all joints are filtered alike: for some, new measurements get more weight.",
        "Filter the whole array with the same weights.",
    )


def why_begun_anew(recording: Recording, saw: str) -> Verdict | None:
    """A failed verdict for a filter that begins anew where it must not; None if that is not seen."""
    first, last = noise_left(recording, STEADY_FIRST), noise_left(recording, STEADY_LAST)
    if first is not None and last is not None and first[0] <= MOST_NOISE:
        if NEARLY_ALL <= last[0] <= MORE_THAN_ALL:
            return see.failed(
                "noise-reduced.not-after-restart",
                f"before the restart, {first[0]:.0%} of the noise is left, and after it {last[0]:.0%}",
                LITTLE_LEFT,
                "After the restart nothing is filtered: each message looks like a restart, because the last stamp "
                "is not updated. Or the state is discarded at the restart, and not kept from then on.",
                "Store the stamp of every message. Begin again at a stamp that's smaller than the previous one, "
                "and filter as usual after that.",
            )
    if not begins_anew_each_second(recording):
        return None
    return see.failed(
        "noise-reduced.begins-anew",
        f"{saw}; at each full second the filter begins again, and an unfiltered angle comes out",
        LITTLE_LEFT,
        "The stamps are compared by their nanosec alone, which begins again with each second.",
        "Compare both parts together: (sec, nanosec) as a pair, or sec * 10**9 + nanosec.",
    )


def why_no_filter(recording: Recording, saw: str) -> Verdict | None:
    """A failed verdict for what makes an angle calm, and is no filter: rounding, a dead band; None if it is neither."""
    by_place = first_answers(recording)
    rows = [by_place[place].angles for place in STEADY if place in by_place]
    if rounded(rows):
        return why_rounded(saw, LITTLE_LEFT)
    if not stands_still(recording):
        return None
    return see.failed(
        "noise-reduced.stands-still",
        f"{saw}; most answers are the same as those before",
        LITTLE_LEFT,
        "The answer keeps an old value until a new one is far from it (a dead band). It is calm, but as wrong "
        "as that old value was.",
        "Let each measurement count a little: take a mean of the last ones, or go a part of the way to each.",
    )


Rows = Sequence[Sequence[float]]


def rounded(rows: Rows) -> bool:
    """Whether every angle is a multiple of 0.1 rad."""
    return all(
        math.isfinite(angle) and abs(10.0 * angle - round(10.0 * angle)) < 10.0 * SAME_RAD
        for row in rows
        for angle in row
    )


def whole_numbers(rows: Rows) -> bool:
    return all(float(angle).is_integer() for row in rows for angle in row)


def why_rounded(saw: str, expected: str) -> Verdict:
    """A failed verdict for angles that are rounded to tenths."""
    return see.failed(
        "noise-reduced.rounded",
        f"{saw}; every angle is a multiple of 0.1 rad",
        expected,
        "The angles are rounded. They look calm, but each of them may be off by up to 0.05 rad.",
        "Publish the filter's result unchanged.",
    )


def held_joints(recording: Recording, places: Sequence[int]) -> list[str]:
    """The joints whose answers keep one value there."""
    by_place = first_answers(recording)
    rows = [by_place[place].angles for place in places if place in by_place]
    return [
        name
        for name, column in zip(JOINTS, zip(*rows, strict=True), strict=False)
        if max(column) - min(column) <= SAME_RAD
    ]


def stands_still(recording: Recording) -> bool:
    """Whether the answers for most joints keep one value where the joints stand first, or change rarely."""
    by_place = first_answers(recording)
    rows = [by_place[place].angles for place in STEADY_FIRST if place in by_place]
    same = [
        one == other for before, after in pairwise(rows) for one, other in zip(before, after, strict=True)
    ]
    rarely = bool(same) and sum(same) > RARELY * len(same)
    return rarely or len(held_joints(recording, STEADY_FIRST)) > len(JOINTS) // 2


def why_held(recording: Recording, saw: str) -> Verdict | None:
    """A failed verdict for joints whose answers keep one value after the restart, and did not before."""
    held = held_joints(recording, STEADY_LAST)
    if not held or held_joints(recording, STEADY_FIRST):
        return None
    return see.failed(
        "noise-reduced.held-after-restart",
        f"{saw}; after the restart, the answers for {see.count(len(held), 'joint')} of {len(JOINTS)} no longer "
        f"change, {held[0]} first",
        LITTLE_LEFT,
        "These joints are no longer filtered: a joint that gave NaN is held from then on, or new measurements no "
        "longer count after the restart.",
        "Hold an angle only for a message with NaN. The next good measurement of that joint counts again.",
    )


def why_to_one_side(recording: Recording, saw: str) -> Verdict | None:
    """A failed verdict for answers that are calm enough, and on average beside the joints; None if they are not."""
    errors = errors_at(recording, STEADY_FIRST)
    if errors is None:
        return None
    means = [statistics.fmean(row) for row in errors]
    if abs(statistics.median(means)) < NOISE_RAD / 4 or min(means) * max(means) < 0.0:
        return None
    return see.failed(
        "noise-reduced.to-one-side",
        f"{saw}; the answers for all joints lie on the same side of them, typically {statistics.median(means):+.3f} "
        "rad",
        LITTLE_LEFT,
        "The filter follows an angle faster in one direction than in the other, or takes the largest or smallest of "
        "several measurements. Or a number is added to each angle.",
        "Give measurements above and below the same weight.",
    )


def as_they_went_in(raw: Sequence[int]) -> str:
    """Which joints are not filtered, in words."""
    if len(raw) == 1:
        return f"1 joint of {len(JOINTS)} comes out as it went in, {JOINTS[raw[0]]}"
    return f"{len(raw)} joints of {len(JOINTS)} come out as they went in, {JOINTS[raw[0]]} first"


def too_few(cause: str, recording: Recording) -> Verdict:
    """Nothing can be said, because most answers are missing."""
    saw = "fewer than half of the messages that count for this criterion were answered"
    return see.program_ended(recording, saw, "an answer to each") or see.failed(
        cause,
        saw,
        "an answer to each",
        "Without answers, the filter cannot be judged.",
        "First make sure that every message is answered.",
        about_time=True,
    )


def no_numbers(cause: str) -> Verdict:
    """The answers hold NaN or infinity where nothing of the kind was sent."""
    return see.failed(
        cause,
        "NaN or infinity in answers to messages without any",
        FINITE,
        "The filter's state contains NaN, or the filter divides by zero.",
        "Look at the first answer that is not finite, and at the filter's state at that moment.",
    )
