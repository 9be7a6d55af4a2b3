"""How exercise 14 is judged: twelve noisy joints whose true angles are known, and what the filter makes of them."""

import math
import random
import statistics
from collections import Counter
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
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
NEAR_RAD = 0.1  # so near is an angle to the joint at a start, and while NaN comes
AT_ONCE_S = 0.5
SHARE_AT_ONCE = 0.9  # of the messages: the others may have been kept waiting by a busy machine
TYPICALLY_S = 0.15
LEAST_CHANGE = 0.25  # of the noise: less is no filter
STARTING = 8  # messages after a start that must be near
SETTLED = 20  # messages after a start or a movement until noise and delay are measured

# Where the joints stand first, how fast they move then (rad/s), and how far they are turned while the board is off.
FIRST_POSE = (0.5, -0.6, 1.2, 0.9, -1.1, 0.8, -0.7, 1.0, -0.5, 0.6, -0.9, 0.7)
SPEEDS = (0.5, -0.4, 0.5, 0.4, -0.5, 0.5, -0.4, 0.4, -0.5, 0.5, -0.4, 0.5)
TURNED = (-0.6, 0.5, -0.7, -0.8, 0.6, -0.5, 0.7, -0.6, 0.5, -0.8, 0.6, -0.5)
STANDS, MOVES, STANDS_AGAIN, AFTER_RESTART = 46, 34, 44, 36  # messages
FIRST_STAMP_S = 40.0
NAN_AT: Mapping[int, tuple[int, ...]] = {
    # message: joints whose encoder gives NaN
    STANDS + MOVES + 24: (3,),
    STANDS + MOVES + 30: (0, 7),
    STANDS + MOVES + 31: (0, 7),
    STANDS + MOVES + 32: (7,),
    STANDS + MOVES + 36: tuple(range(len(JOINTS))),
}


@dataclass(frozen=True)
class Sample:
    """One message of the encoders: its stamp (s, ns), where the joints really are, and what is measured (rad)."""

    stamp: tuple[int, int]
    truth: tuple[float, ...]
    measured: tuple[float, ...]


def samples() -> tuple[Sample, ...]:
    """All messages, in order: the board is switched on, works, and is switched off and on again."""
    dice = random.Random(14)
    made = []
    for place in range(STANDS + MOVES + STANDS_AGAIN + AFTER_RESTART):
        moving_s = PERIOD_S * min(max(place - STANDS + 1, 0), MOVES)
        again = place - RESTART
        truth = tuple(
            start + speed * moving_s + (turned if again >= 0 else 0.0)
            for start, speed, turned in zip(FIRST_POSE, SPEEDS, TURNED, strict=True)
        )
        noise = [dice.gauss(0.0, NOISE_RAD) for _ in JOINTS]
        measured = [
            angle + min(max(one, -LARGEST_NOISE_RAD), LARGEST_NOISE_RAD)
            for angle, one in zip(truth, noise, strict=True)
        ]
        for joint in NAN_AT.get(place, ()):
            measured[joint] = math.nan
        ticks = again + 1 if again >= 0 else place + round(FIRST_STAMP_S / PERIOD_S)
        in_ns = ticks * round(PERIOD_S * 1e9)
        made.append(Sample((in_ns // 10**9, in_ns % 10**9), truth, tuple(measured)))
    return tuple(made)


RESTART = STANDS + MOVES + STANDS_AGAIN
SAMPLES = samples()
PLACE_OF = {sample.stamp: place for place, sample in enumerate(SAMPLES)}
STEADY = (*range(SETTLED, STANDS), *range(RESTART + SETTLED, len(SAMPLES)))
MOVING = tuple(range(STANDS + SETTLED, STANDS + MOVES))
WITH_NAN = range(min(NAN_AT), RESTART)

BEGIN_S = 0.5
SAID_AT = tuple(round(BEGIN_S + place * PERIOD_S, 2) for place in range(len(SAMPLES)))
WATCH_S = SAID_AT[-1] + 1.0
WATCH = watching(
    robot_seconds=WATCH_S,
    wall_seconds=WATCH_S,
    script=[
        see.says(
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


@criterion(points=1, title="It listens to /encoders/joint_states, type JointState", needs=[program_runs])
def listens(recording: Recording) -> Verdict:
    return see.listens(recording, RAW)


@criterion(points=1, title="/robot/joint_states carries JointState", needs=[program_runs])
def output_topic(recording: Recording) -> Verdict:
    verdict = see.publishes(recording, FILTERED)
    if not verdict.ok and recording.topic(RAW.name).publishers:
        return see.failed(
            "output-topic.publishes-where-it-listens",
            f"your node publishes {RAW.name}, and nothing on {FILTERED.name}",
            verdict.expected,
            "It publishes where it listens. So it hears itself, answers itself, and so on without end.",
            f"Write the name as {FILTERED.name!r}.",
        )
    return verdict


@criterion(points=0, title="It answers", needs=[listens, output_topic])
def answers_come(recording: Recording) -> Verdict:
    if recording.topic(FILTERED.name).arrivals:
        return see.passed("answers come")
    nothing = f"{len(SAMPLES)} messages were sent to {RAW.name}, and nothing came on {FILTERED.name}"
    return see.failed_by_error(recording, nothing, ONE_EACH, about_time=True) or see.failed(
        "answers-come.nothing",
        nothing,
        ONE_EACH,
        "Either nobody spins the node, so the callback never runs, or the callback does not publish.",
        "Spin the node with rclpy.spin(node), and publish inside the callback.",
        about_time=True,
    )


@criterion(
    points=1, title="Each answer has the stamp, the names and an angle for each joint", needs=[answers_come]
)
def labels_kept(recording: Recording) -> Verdict:
    given = answers(recording)
    strange = [answer for answer in given if answer.place is None]
    if strange:
        return why_strange_stamps(strange, len(given))
    others = [answer for answer in given if answer.names != JOINTS]
    if others:
        return why_other_names(others, len(given))
    lengths = sorted({len(answer.angles) for answer in given} - {len(JOINTS)})
    if lengths:
        return see.failed(
            "labels-kept.other-length",
            f"{lengths[0]} angles beside {len(JOINTS)} names",
            f"an angle for each of the {len(JOINTS)} names",
            "The angles go through an array of another shape, or only some joints are filtered and kept.",
            "Print filtered.shape; publish one angle for each joint: position = filtered.tolist().",
        )
    return see.passed(f"{see.count(len(given), 'answer')} with stamp, names and {len(JOINTS)} angles")


@criterion(points=2, title="Every message is answered once, at once, in order", needs=[labels_kept])
def every_one_answered(recording: Recording) -> Verdict:
    places = [answer.place for answer in answers(recording) if answer.place is not None]
    times = Counter(places)
    twice = [place for place, number in times.items() if number > 1]
    if twice:
        return see.failed(
            "every-one-answered.repeated",
            f"{see.count(len(twice), 'message')} answered more than once, {shown(twice[0])} {times[twice[0]]} times",
            ONE_EACH,
            "A timer or a loop sends an answer again, or two subscriptions hear the same topic.",
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
            "Messages are collected and answered in another order, or by several threads at once.",
            "Publish inside the callback: it is called in the right order.",
        )
    return at_once(recording)


@criterion(points=0, title="It filters", needs=[labels_kept])
def filters(recording: Recording) -> Verdict:
    if len(not_filtered(recording)) < len(JOINTS):
        return see.passed("what comes out is not what went in")
    return see.failed(
        "filters.passes-through",
        "the angles come out as they went in",
        LITTLE_LEFT,
        "The filter is not used; or its memory is made anew in each call, so that it begins again with each message; "
        "or it runs to and fro over the last messages (filtfilt), and at their end it has nothing to look ahead to.",
        "Keep the memory of the filter in an attribute of the node, and give it back to the filter in each call.",
    )


@criterion(points=1, title="At most 55 % of the noise is left", needs=[filters])
def noise_reduced(recording: Recording) -> Verdict:
    errors = errors_at(recording, STEADY)
    if errors is None:
        return too_few("noise-reduced.too-few-answers")
    left = [
        root_mean_square(errors[joint]) / root_mean_square(measured_noise(joint))
        for joint in range(len(JOINTS))
    ]
    if not all(math.isfinite(one) for one in left):
        return no_numbers("noise-reduced.no-number")
    whole = math.sqrt(
        sum(root_mean_square(row) ** 2 for row in errors)
        / sum(root_mean_square(measured_noise(joint)) ** 2 for joint in range(len(JOINTS)))
    )
    worst = max(range(len(JOINTS)), key=left.__getitem__)
    off = statistics.fmean(errors[worst])
    if abs(off) > LARGEST_NOISE_RAD:
        return see.failed(
            "noise-reduced.beside-the-joint",
            f"{JOINTS[worst]} stands still, and the answers say typically {abs(off):.2f} rad beside it",
            LITTLE_LEFT,
            "The filter does not keep what is constant: its weights do not add up to 1, it mixes joints, or it still "
            "remembers something old.",
            "Give it the same angle again and again: it must come out. Filter along time, each joint for itself.",
        )
    if whole > MOST_NOISE or left[worst] > MOST_NOISE_OF_ONE:
        return why_noisy(whole, left, not_filtered(recording))
    return see.passed(f"{whole:.0%} of the noise is left")


@criterion(points=1, title="The angles are at most 0.27 s behind", needs=[filters])
def delay_bounded(recording: Recording) -> Verdict:
    errors = errors_at(recording, MOVING)
    if errors is None:
        return too_few("delay-bounded.too-few-answers")
    behind_s = -sum(speed * statistics.fmean(row) for speed, row in zip(SPEEDS, errors, strict=True)) / sum(
        speed * speed for speed in SPEEDS
    )
    if not math.isfinite(behind_s):
        return no_numbers("delay-bounded.no-number")
    if behind_s > LONGEST_DELAY_S:
        return see.failed(
            "delay-bounded.too-late",
            f"while the joints move, the angles are {behind_s:.3f} s behind",
            f"at most {LONGEST_DELAY_S} s, where a message comes every {PERIOD_S} s",
            "The filter looks back too far: its window is too long, or its cutoff frequency too low.",
            "A moving average of N messages is (N - 1) / 2 messages behind. Let it look back less, and look at the "
            "noise again.",
        )
    return see.passed(f"{max(behind_s, 0.0):.2f} s behind")


@criterion(points=1, title="It begins where the joints are", needs=[filters])
def begins_near(recording: Recording) -> Verdict:
    return near(
        recording,
        range(STARTING),
        "begins-near.swings-in",
        "The filter begins with zeros in its memory, and needs a while to get away from there.",
        "Fill the memory with the first message: for sosfilt, zi = sosfilt_zi(sos) times the first angle.",
    )


@criterion(points=1, title="It notices the restart, and begins anew", needs=[filters])
def restart_noticed(recording: Recording) -> Verdict:
    return near(
        recording,
        range(RESTART, RESTART + STARTING),
        "restart-noticed.remembers",
        "The joints were turned while the board was off. The filter still remembers where they were before.",
        "When a stamp is before the last one, fill the memory of the filter anew, as at the start.",
    )


@criterion(points=1, title="A NaN does no harm", needs=[filters])
def survives_nan(recording: Recording) -> Verdict:
    by_place = first_answers(recording)
    bad = [
        place
        for place in WITH_NAN
        if place in by_place and not all(math.isfinite(angle) for angle in by_place[place].angles)
    ]
    if bad and bad[-1] > max(NAN_AT):
        return see.failed(
            "survives-nan.never-leaves",
            f"a NaN came in with {shown(min(NAN_AT))}; {see.count(len(bad), 'answer')} since then say NaN, the last "
            f"of them for {shown(bad[-1])}",
            FINITE,
            "NaN got into the memory of the filter. Whatever is computed from NaN is NaN, so there it stays.",
            "Before the filter, put the last good angle of that joint in the place of each NaN: np.isfinite(position).",
        )
    if bad:
        return see.failed(
            "survives-nan.passed-on",
            f"{see.count(len(bad), 'answer')} with NaN, the first of them for {shown(bad[0])}",
            FINITE,
            "NaN goes through to the answer.",
            "Before the filter, put the last good angle of that joint in the place of each NaN: np.isfinite(position).",
        )
    return near(
        recording,
        WITH_NAN,
        "survives-nan.other-angle",
        "In the place of NaN, the filter gets a number that has nothing to do with the joint, such as 0; or joints "
        "without NaN are changed as well.",
        "Put the last good angle of the same joint in its place, and leave the other joints alone.",
    )


# --- what came back -----------------------------------------------------------------------------------------

ONE_EACH = f"exactly one answer on {FILTERED.name} for each of the {len(SAMPLES)} messages, in their order"
LITTLE_LEFT = (
    f"at most {MOST_NOISE:.0%} of the noise where the joints stand still, and at most {MOST_NOISE_OF_ONE:.0%} of it "
    "at each joint"
)
FINITE = f"{len(JOINTS)} finite angles in each answer"
BOARD_STAMPS = "the stamp of the message that it answers, as it came"


@dataclass(frozen=True)
class Answered:
    """One answer: which message its stamp belongs to (None: to none), its stamp (s), its names and angles (rad)."""

    place: int | None
    stamp_s: float
    names: tuple[str, ...]
    angles: tuple[float, ...]
    t: float


def answers(recording: Recording) -> list[Answered]:
    """What arrived on the topic of the answers, in order."""
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


def measured_noise(joint: int) -> list[float]:
    """The noise (rad) of a joint where it is judged."""
    return [SAMPLES[place].measured[joint] - SAMPLES[place].truth[joint] for place in STEADY]


def root_mean_square(numbers: Sequence[float]) -> float:
    return math.sqrt(statistics.fmean(number * number for number in numbers))


def shown(place: int) -> str:
    """A message by its number and stamp."""
    sec, nanosec = SAMPLES[place].stamp
    return f"message {place + 1} (stamp {sec + nanosec / 1e9:.2f} s)"


def near(recording: Recording, places: Sequence[int], cause: str, because: str, try_this: str) -> Verdict:
    """Whether the answers to these messages are near the joints."""
    by_place = first_answers(recording)
    known = [place for place in places if place in by_place]
    if 2 * len(known) < len(places):
        return too_few("near.too-few-answers")
    for place in known:
        for joint, angle in enumerate(by_place[place].angles):
            off = abs(angle - SAMPLES[place].truth[joint])
            if not off <= NEAR_RAD:
                return see.failed(
                    cause,
                    f"{shown(place)}: {JOINTS[joint]} is at {SAMPLES[place].truth[joint]:.2f} rad, and the answer "
                    f"says {angle:.2f}",
                    f"an angle within {NEAR_RAD} rad of the joint, for each joint, from {shown(places[0])} on",
                    because,
                    try_this,
                )
    return see.passed(f"within {NEAR_RAD} rad at every joint")


def at_once(recording: Recording) -> Verdict:
    """All messages were answered, in order; whether at once."""
    said_at = [word.t for word in see.said(recording, RAW.name)]
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
        "Messages are collected and answered later, by a timer or in groups; or the callback sleeps or computes long.",
        "Publish each answer inside the callback, at once.",
        about_time=True,
    )


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
            "A new message is published, and its header was never filled in.",
            "Copy the header: answer.header = message.header.",
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
        "The node stamps its answers with its own clock. But the stamp says when an angle was measured, not when it "
        "was published.",
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
            "A new message is published, and its names were never filled in. Nobody knows which angle is whose.",
            "Copy them: answer.name = message.name.",
        )
    if sorted(names) == sorted(JOINTS):
        return see.failed(
            "labels-kept.other-order",
            f"{names[0]} in the first place, where {JOINTS[0]} was",
            expected,
            "The names are sorted, or come out of a set. Angles and names belong together by their places.",
            "Copy them as they came: answer.name = message.name.",
        )
    return see.failed(
        "labels-kept.other-names",
        f"{see.count(len(names), 'name')}, the first is {names[0]}",
        expected,
        "The names are the node's own, or only some of them.",
        "Copy them as they came: answer.name = message.name.",
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
    return missing_for_a_reason(saw, missing) or see.failed(
        "every-one-answered.missing",
        saw,
        ONE_EACH,
        "The node was busy or its queue too short while they came; a timer answers only the newest; or there are "
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
            "Put the last good angle in the place of the NaN, and answer.",
            about_time=True,
        )
    if (
        missing[-1] == len(SAMPLES) - 1
        and missing == [*range(missing[0], len(SAMPLES))]
        and missing[0] > RESTART
    ):
        return see.failed(
            "every-one-answered.held-back",
            f"{saw}, and with it all that came after it",
            ONE_EACH,
            "The filter looks ahead: it answers a message only when later ones have come, and after the last one none "
            "comes.",
            "Use only this message and those before it, and publish in each call of the callback.",
            about_time=True,
        )
    if missing == [*range(len(missing))]:
        return see.failed(
            "every-one-answered.first-left-out",
            f"{saw}; after {see.count(len(missing), 'message')}, the answers begin",
            ONE_EACH,
            "The filter waits until its memory is full, or the first messages only fill it.",
            "Fill the memory with the first message as often as it has room, and answer from the first one on.",
            about_time=True,
        )
    return None


def not_filtered(recording: Recording) -> list[int]:
    """The joints whose angles come out as they went in, where the joints stand still and no NaN comes."""
    by_place = first_answers(recording)
    known = [place for place in STEADY if place in by_place]
    return [
        joint
        for joint in range(len(JOINTS))
        if known
        and root_mean_square(
            [by_place[place].angles[joint] - SAMPLES[place].measured[joint] for place in known]
        )
        <= LEAST_CHANGE * NOISE_RAD
    ]


def why_noisy(whole: float, left: Sequence[float], raw: Sequence[int]) -> Verdict:
    """Why so much of the noise is left. `raw`: the joints that are not filtered."""
    worst = max(range(len(JOINTS)), key=left.__getitem__)
    saw = f"{whole:.1%} of the noise is left, at {JOINTS[worst]} {left[worst]:.1%}"
    if raw:
        return see.failed(
            "noise-reduced.some-joints",
            f"{saw}: {see.count(len(raw), 'joint')} of {len(JOINTS)} come out as they went in, {JOINTS[raw[0]]} first",
            LITTLE_LEFT,
            "Only some of the joints go through the filter.",
            "Filter the whole array, or make one filter for each name.",
        )
    if whole > 0.95:
        return see.failed(
            "noise-reduced.none",
            saw,
            LITTLE_LEFT,
            "The memory of the filter is not carried on from call to call, so each call begins with what it remembered "
            "at the start; or something behind the filter adds as much as it takes away, such as rounding.",
            "Give the filter in each call the memory that it handed back in the last one, and publish its result as it "
            "is.",
        )
    return see.failed(
        "noise-reduced.too-little",
        saw,
        LITTLE_LEFT,
        "The filter lets too much through: its window is too short, its cutoff frequency too high, or its weight for "
        "what is new too large.",
        "A moving average of N messages leaves 1/sqrt(N) of the noise. Let it look back farther, and look at the delay "
        "again.",
    )


def too_few(cause: str) -> Verdict:
    """Nothing can be said, because most answers are missing."""
    return see.failed(
        cause,
        "fewer than half of the messages that this is judged by were answered",
        "an answer to each",
        "Without answers, nothing can be seen of the filter.",
        "See first that every message is answered.",
        about_time=True,
    )


def no_numbers(cause: str) -> Verdict:
    """The answers hold NaN or infinity where nothing of the kind was sent."""
    return see.failed(
        cause,
        "NaN or infinity in answers to messages without any",
        FINITE,
        "The memory of the filter holds NaN, or the filter divides by zero.",
        "Look at the first answer that is not finite, and at what the filter remembers by then.",
    )
