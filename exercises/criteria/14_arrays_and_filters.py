"""Judge exercise 14 by the filter's output for twelve noisy joints whose true angles are known.

An *answer* is a message that the student's filter publishes. A *start* is the first message after the board is switched
on.
"""

import math
import random
import statistics
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from functools import cached_property
from itertools import chain, pairwise

from sensor_msgs.msg import JointState

import workbook.criteria as see
from workbook.criteria import Arrival, Recording, Verdict, criterion, program_runs, topic, watching

WORDS = see.Words(__file__, globals())
RAW = topic("/encoders/joint_states", JointState)
FILTERED = topic("/robot/joint_states", JointState)
JOINTS = (
    "neck", "waist", "left_shoulder", "left_elbow", "right_shoulder", "right_elbow",
    "left_hip", "left_knee", "left_ankle", "right_hip", "right_knee", "right_ankle",
)  # fmt: skip

PERIOD_S = 0.05  # 20 messages a second
NOISE_RAD = 0.02
LARGEST_NOISE_RAD = 0.05
MOST_NOISE = 0.55  # the fraction of the noise that may be left, for all joints together
MOST_NOISE_OF_ONE = 0.8  # the same for a single joint
LONGEST_DELAY_S = 0.27
LONGEST_DELAY_OF_ONE_S = 0.32  # for a single joint, whose noise makes the measurement inexact
NEAR_RAD = 0.1  # the most that an angle may differ from the joint's at a start, and while NaNs arrive
AT_ONCE_S = 0.5
SHARE_AT_ONCE = 0.9  # of the messages, because a busy machine may delay the others
TYPICALLY_S = 0.15
LEAST_CHANGE_RAD = 0.005  # root mean square, between input and output: below that, nothing is filtered
SAME_RAD = 0.001  # root mean square: the same angle, except for rounding
NEARLY_ALL = 0.95  # of the noise: if more is left, the filter doesn't remove noise
WIDE_GAP = 1.4  # the ratio of the noise left at two joints that shows that they aren't filtered alike
RARELY = 0.6  # fraction of answers that equal the previous one: a filter changes each answer
MORE_THAN_ALL = 1.2  # of the noise: even a weak filter doesn't leave that much, so the program adds an error
FOLLOWS_RAD = 0.3  # the most that an angle may differ from that of a joint that has moved on after a NaN
FAR_BEHIND_S = 0.4  # a filter that lags by more would exceed `FOLLOWS_RAD` even without a NaN
STARTING = 8  # the number of messages after a start whose answers must be near
SETTLED = 20  # the number of messages after a start or a movement before noise and delay are measured

# The joints' first angles (rad), their speeds (rad/s), and their turns (rad) during the two times when the board is
# off. The first time, one joint turns only a little, and the second time, all joints do, because a program has to
# detect a restart by the stamp, not by a jump. Most joints stand between two multiples of 0.1 rad, because at a
# multiple, rounding would remove all the noise.
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
MESSAGES = RESTART_AGAIN + AFTER_SECOND  # a prime number, so that answers in groups leave a remainder
STARTS = (range(RESTART), range(RESTART, RESTART_AGAIN), range(RESTART_AGAIN, MESSAGES))
# After a restart, the first stamp's fraction is above that of the last stamp before the restart (47.65 s and 2.50 s).
START_STAMPS_MS = (40_000, 750, 560)
SECOND_IN_A_ROW = STANDS + MOVES + 31
NAN_AT: Mapping[int, tuple[int, ...]] = {
    # a message's place: the joints whose encoder returns NaN in that message
    STANDS + MOVES + 24: (3,),
    STANDS + MOVES + 30: (0, 7),
    SECOND_IN_A_ROW: (0, 7),
    STANDS + MOVES + 32: (7,),
    STANDS + MOVES + 36: tuple(range(len(JOINTS))),
}


@dataclass(frozen=True)
class Sample:
    """One message from the encoders: its place in the script, and the true and the measured angles (rad)."""

    place: int
    stamp: see.Stamp
    truth: tuple[float, ...]
    measured: tuple[float, ...]

    @property
    def number(self) -> int:
        """The message's place, counted from 1."""
        return self.place + 1


def samples() -> tuple[Sample, ...]:
    """Return all messages, in order. The board is switched on, works, and is switched off and on again twice."""
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
        noise = [min(max(dice.gauss(0.0, NOISE_RAD), -LARGEST_NOISE_RAD), LARGEST_NOISE_RAD) for _ in JOINTS]
        measured = [angle + one for angle, one in zip(truth, noise, strict=True)]
        for joint in NAN_AT.get(place, ()):
            measured[joint] = math.nan
        in_ms = START_STAMPS_MS[since] + (place - STARTS[since][0]) * round(PERIOD_S * 1e3)
        made.append(Sample(place, see.Stamp.at(in_ms / 1e3), truth, tuple(measured)))
    return tuple(made)


SAMPLES = samples()
PLACE_OF = {sample.stamp: sample.place for sample in SAMPLES}
STEADY_FIRST, STEADY_LAST = range(SETTLED, STANDS), range(RESTART + SETTLED, RESTART_AGAIN - 4)
STEADY = (*STEADY_FIRST, *STEADY_LAST)
WITH_NAN = range(min(NAN_AT), STILL_UNTIL)
MOVED_ON = RESTART - 5  # the answers just before the restart may be mixed with later messages
MOVING, MOVING_BACK = range(STANDS + SETTLED, STANDS + MOVES), range(STILL_UNTIL + SETTLED, MOVED_ON + 1)

BEGIN_S = 0.5
SENT_AT = [round(BEGIN_S + place * PERIOD_S, 2) for place in range(MESSAGES)]
SCRIPT = [
    (at, {"header": {"stamp": one.stamp._asdict()}, "name": list(JOINTS), "position": list(one.measured)})
    for at, one in zip(SENT_AT, SAMPLES, strict=True)
]
WATCH_S = SENT_AT[-1] + 1.0
WATCH = watching(
    simulated_seconds=WATCH_S, wall_seconds=WATCH_S, script=[see.publish(RAW.name, JointState, SCRIPT)]
)


class Answer:
    """One answer, with angles in rad. `place`: the place of the answered message; by default, we look up the stamp.

    The attribute `place` is None if no message has that stamp.
    """

    def __init__(self, arrival: Arrival, place: int | None = None) -> None:
        self.t, self.stamp_s = arrival.t, see.Stamp.of(arrival.value).seconds
        self.place = PLACE_OF.get(see.Stamp.of(arrival.value)) if place is None else place
        self.names, self.angles = (tuple(see.elements(arrival.value[name])) for name in ("name", "position"))


@dataclass(frozen=True)
class Far:
    """An angle that is far from the true one (rad), with its message and all angles in its answer."""

    sample: Sample
    angles: tuple[float, ...]
    joint: str
    truth: float
    angle: float


class Answers:
    """All answers. Statistics on a section of the messages, or on one aspect, are computed on demand."""

    steady = cached_property(lambda answers: Section(answers, STEADY))
    first = cached_property(lambda answers: Section(answers, STEADY_FIRST))
    last = cached_property(lambda answers: Section(answers, STEADY_LAST))
    forth = cached_property(lambda answers: Section(answers, MOVING))
    back = cached_property(lambda answers: Section(answers, MOVING_BACK))
    labels = cached_property(lambda answers: Labels(answers.came))
    order = cached_property(lambda answers: Order(answers))
    nan = cached_property(lambda answers: AfterNan(answers))

    def __init__(self, recording: Recording) -> None:
        arrivals = [one for one in recording.topic(FILTERED.name).arrivals if isinstance(one.value, dict)]
        self.has_ended = recording.process.ended_by == "itself"
        self.recording, self.came = recording, [Answer(arrival) for arrival in arrivals]
        # If the stamps don't show which message an answer is for, the answers' order does. This requires one answer per
        # message, at least until the program exited.
        places, sent = {answer.place for answer in self.came}, len(see.published(recording, RAW.name))
        ended_early = self.has_ended and len(self.came) < sent
        stamps_tell = None not in places and len(places) > 1
        by_order = not stamps_tell and (len(self.came) == sent or ended_early)
        in_order = [Answer(arrival, place) for place, arrival in enumerate(arrivals)]
        self.placed = in_order if by_order else self.came
        # the first answer to each message that was answered, by the message's place
        self.by_place = {one.place: one for one in reversed(self.placed) if one.place is not None}

    def changed_at(self, place: int) -> list[str]:
        """Return the joints whose angle in the answer to this message isn't the measured one."""
        found = zip(JOINTS, self.by_place[place].angles, SAMPLES[place].measured, strict=True)
        return [name for name, angle, measured in found if not abs(angle - measured) <= SAME_RAD]

    def far_at(self, place: int, limit_rad: float) -> list[Far]:
        """Return the angles in the answer to this message that differ from the true ones by more than `limit_rad`."""
        sample, angles = SAMPLES[place], self.by_place[place].angles
        found = [Far(sample, angles, *one) for one in zip(JOINTS, sample.truth, angles, strict=True)]
        return [far for far in found if not abs(far.angle - far.truth) <= limit_rad]

    @cached_property
    def begins_again_each_second(self) -> bool:
        """Whether the filter is reset whenever `nanosec` restarts at 0, and at no other judged message."""
        known = [place for place in range(1, STILL_UNTIL) if place in self.by_place and place not in NAN_AT]
        unfiltered = [place for place in known if not self.changed_at(place)]
        return bool(unfiltered) and unfiltered == [place for place in known if SAMPLES[place].stamp[1] == 0]

    @property
    def unfiltered_after_restart(self) -> bool:
        noise = self.last.noise if self.first.enough and self.last.enough else math.nan
        return self.first.noise <= MOST_NOISE and NEARLY_ALL <= noise <= MORE_THAN_ALL


ANSWERS = see.once(Answers)


class Labels:
    """The answers' stamps, joint names, and numbers of angles."""

    def __init__(self, came: list[Answer]) -> None:
        self.strange = [answer for answer in came if answer.place is None]
        stamps = {answer.stamp_s for answer in self.strange}
        has_seconds = {int(one) for one in stamps} <= {sec for sec, _ in PLACE_OF}
        self.lost_a_part = bool(stamps) and has_seconds and len(stamps) < len(came)
        self.renamed = [answer for answer in came if answer.names != JOINTS]
        self.names = list(self.renamed[0].names if self.renamed else JOINTS)
        self.other_lengths = sorted({len(answer.angles) for answer in came} - {len(JOINTS)})


class Order:
    """The messages that were answered, the order of the answers, and their delays (s)."""

    def __init__(self, answers: Answers) -> None:
        by_place, sent = answers.by_place, see.published(answers.recording, RAW.name)
        places = [answer.place for answer in answers.placed if answer.place is not None]
        relay = see.Relay(SAMPLES, [SAMPLES[place] for place in places])
        self.repeated, self.missing, self.misplaced = relay.repeated, relay.missing, relay.misplaced
        self.rest_is_missing, self.answered = relay.rest_is_missing, len(by_place)
        repeated = {sample.place for sample, _ in self.repeated}
        self.repeated_at_restart = bool(repeated) and repeated <= {RESTART, RESTART_AGAIN}
        unanswered_nan = {place - 1 for place in NAN_AT if place not in by_place}
        self.repeated_for_nan = bool(repeated) and repeated <= unanswered_nan
        since_starts = [[place in by_place for place in start] for start in STARTS]
        self.only_first_missing = all(start == sorted(start) and start[-1] for start in since_starts)
        waited = [by_place[at].t - one.t for at, one in enumerate(sent) if at in by_place]
        self.waits = see.Waits(waited, AT_ONCE_S)
        self.is_late = self.waits.typical_s > TYPICALLY_S or self.waits.are_late(SHARE_AT_ONCE)
        # Simulated time waits for a callback that sleeps or computes, so only real time shows the delay.
        arrivals = answers.recording.topic(FILTERED.name).arrivals
        self.took_s = mean([answer.published - one.wall for one, answer in zip(sent, arrivals, strict=False)])


def mean(numbers: Sequence[float]) -> float:
    """Return the mean, or NaN if there are no numbers."""
    return sum(numbers) / len(numbers) if numbers else math.nan


def root_mean_square(numbers: Sequence[float]) -> float:
    return math.sqrt(mean([number * number for number in numbers]))


class Joint:
    """Statistics on one joint's answers in a section (rad). `sent`: all of the section's messages."""

    def __init__(self, at: int, sent: list[Sample], answered: list[Sample], angles: list[float]) -> None:
        errors = [angle - sample.truth[at] for sample, angle in zip(answered, angles, strict=True)]
        changes = [angle - sample.measured[at] for sample, angle in zip(answered, angles, strict=True)]
        self.name, self.truth, self.angle = JOINTS[at], sent[0].truth[at], mean(angles)
        self.error, self.off = mean(errors), abs(mean(errors))
        self.change = root_mean_square(changes)  # the change that the filter makes
        self.noise_in = root_mean_square([sample.measured[at] - sample.truth[at] for sample in sent])
        self.noise_out = root_mean_square(errors)
        self.noise = self.noise_out / self.noise_in  # the fraction that's left
        self.is_held = bool(angles) and max(angles) - min(angles) <= SAME_RAD
        self.speed = (sent[-1].truth[at] - self.truth) / (PERIOD_S * (len(sent) - 1))  # rad/s
        self.delay = -self.error / self.speed if self.speed else 0.0  # s


class Section:
    """The answers to some of the messages, compared with the true angles (rad)."""

    def __init__(self, answers: Answers, places: Sequence[int]) -> None:
        self.known = [place for place in places if place in answers.by_place]
        self.enough = 2 * len(self.known) >= len(places)
        self.rows = [answers.by_place[place].angles for place in self.known]
        sent, answered = [SAMPLES[place] for place in places], [SAMPLES[place] for place in self.known]
        self.joints = [Joint(at, sent, answered, [row[at] for row in self.rows]) for at in range(len(JOINTS))]
        self.begin, self.recording = sent[0], answers.recording
        self.all_far = [far for place in self.known for far in answers.far_at(place, NEAR_RAD)]

        # the answers' average distances from the joints' true angles
        joints, errors = self.joints, [joint.error for joint in self.joints]
        self.finite = all(map(math.isfinite, errors))
        self.latest = max(joints, key=lambda joint: joint.delay)
        self.worst = max(joints, key=lambda joint: joint.off)
        self.is_off = self.enough and self.worst.off > LARGEST_NOISE_RAD  # noise alone can't explain that
        self.shift = mean(errors)
        self.is_shifted = max(errors) - min(errors) <= NOISE_RAD
        self.side = statistics.median(errors)
        one_sign = min(errors) * max(errors) >= 0.0
        self.is_on_one_side = self.enough and one_sign and abs(self.side) >= NOISE_RAD / 4
        self.gain = sum(one.angle * one.truth for one in joints) / sum(one.truth**2 for one in joints)
        allowed = LARGEST_NOISE_RAD * max(1.0, abs(self.gain))
        self.is_scaled = max(abs(one.angle - self.gain * one.truth) for one in joints) <= allowed
        # The answers' delay (s), over all joints. A fast joint counts more, because it shows the delay better than a
        # slow one.
        weight = sum(one.speed**2 for one in joints)
        self.delay = sum(-one.error * one.speed for one in joints) / (weight or math.inf)
        is_late = self.delay > LONGEST_DELAY_S or self.latest.delay > LONGEST_DELAY_OF_ONE_S
        # the values that occur in the answers
        angles = [*chain.from_iterable(self.rows)]
        self.is_whole = all(float(angle).is_integer() for angle in angles)
        self.is_rounded = all(abs(angle - round(angle, 1)) < SAME_RAD for angle in angles)
        self.held = [joint.name for joint in joints if joint.is_held]
        same = [one == other for pair in pairwise(self.rows) for one, other in zip(*pair, strict=True)]
        self.stands_still = sum(same) > RARELY * len(same) or 2 * len(self.held) > len(JOINTS)
        # `survives_nan` judges a joint that stands still after a NaN.
        self.is_late = is_late and self.enough and self.finite and not self.held
        # the fraction of the noise that's left
        noise_out, noise_in = [one.noise_out for one in joints], [one.noise_in for one in joints]
        self.noise = root_mean_square(noise_out) / root_mean_square(noise_in)
        self.noisiest = max(joints, key=lambda joint: joint.noise)
        is_low = self.noise <= MOST_NOISE and self.noisiest.noise <= MOST_NOISE_OF_ONE
        self.is_calm = self.enough and is_low
        self.raw = [one.name for one in joints if one.change <= SAME_RAD and one.noise >= NEARLY_ALL]
        self.is_unfiltered = all(joint.change <= LEAST_CHANGE_RAD for joint in joints)
        changes_little = any(joint.change > SAME_RAD for joint in joints) and self.noise < NEARLY_ALL
        self.is_weakly_filtered = self.enough and self.is_unfiltered and changes_little

    @property
    def gap(self) -> tuple[int, float, float] | None:
        """The widest gap in the joints' remaining noise, or None if it doesn't separate filtered joints from others.

        The result is the number of joints below the gap, and the fractions of noise at the gap's two ends.
        """
        order = sorted(joint.noise for joint in self.joints)
        count = max(range(1, len(order)), key=lambda place: order[place] / order[place - 1])
        below, above = order[count - 1], order[count]
        is_uneven = above >= WIDE_GAP * below and below <= MOST_NOISE_OF_ONE and above > MOST_NOISE
        return (count, below, above) if is_uneven else None


class AfterNan:
    """The answers to the messages from the first NaN on."""

    def __init__(self, answers: Answers) -> None:
        by_place, forth = answers.by_place, answers.forth
        self.section = Section(answers, WITH_NAN)
        since = [place for place in range(WITH_NAN[0], RESTART) if place in by_place]
        # the messages whose answers contain NaN or infinity
        bad = [place for place in since if not all(map(math.isfinite, by_place[place].angles))]
        self.bad = [SAMPLES[place] for place in bad]
        self.last_bad = self.bad[-1] if bad else None
        self.never_leaves = bool(bad) and bad[-1] == since[-1]
        # the joint whose answer is farthest off after the joint has moved on, unless the filter was slow even before
        # the NaN
        follows = MOVED_ON in by_place and forth.enough and forth.delay <= FAR_BEHIND_S
        far = answers.far_at(MOVED_ON, FOLLOWS_RAD) if follows else []
        self.lost = max(far, key=lambda one: abs(one.angle - one.truth), default=None)


class Start:
    """The answers to the first messages after a start. A few of these messages may have no answer."""

    def __init__(self, recording: Recording, number: int) -> None:
        self.answers, self.number = ANSWERS(recording), number  # the restart's number, or 0 at the start
        first = STARTS[number][0]
        known = [at for at in range(first, first + SETTLED) if at in self.answers.by_place][:STARTING]
        enough = 2 * len(known) >= STARTING
        self.section = Section(self.answers, known if enough else range(first, first + STARTING))
        changed = self.answers.changed_at(first) if first in known else []
        # the joints whose filters aren't reset although other joints' filters are
        self.old = changed if len(changed) < len(JOINTS) else []
        far_places = {far.sample.place for far in self.section.all_far}
        self.only_first_far = known == [*STARTS[number][:STARTING]] and far_places == {first}

    @cached_property
    def on_the_way_from(self) -> str:
        """The name of the pose from which the first far answer is moving toward the joints.

        The name is "zeros", "before" (the pose before a restart), or "elsewhere" if neither pose fits.
        """
        poses = {"zeros": (0.0,) * len(JOINTS)}
        if self.number > 0:
            poses["before"] = SAMPLES[STARTS[self.number][0] - 1].truth
        misfit, name = min((misfit_of(self.section.all_far[0], pose), name) for name, pose in poses.items())
        return name if misfit <= NEAR_RAD else "elsewhere"


def misfit_of(far: Far, pose: Sequence[float]) -> float:
    """Return an answer's distance (rad, root mean square) from the straight line from the joints to a pose.

    The result is infinity if the answer isn't on the pose's side of the joints.
    """
    ways = [(angle - at, end - at) for angle, at, end in zip(far.angles, far.sample.truth, pose, strict=True)]
    part = sum(off * way for off, way in ways) / sum(way * way for _, way in ways)
    return root_mean_square([off - part * way for off, way in ways]) if 0.0 < part < math.inf else math.inf


IS_NEAR = see.passed(f"within {NEAR_RAD} rad at every joint")
WHERE_IT_LISTENS = WORDS.cause("output-topic.publishes-where-it-listens", ["expected"])
SILENT = WORDS.rules(Answers, "answers-come", ("nothing", see.otherwise, see.ended_or_error), about_time=True)
LABELS = WORDS.rules(
    Answers,
    "labels-kept",
    ("no-stamp", lambda f: {answer.stamp_s for answer in f.came} == {0.0}),
    ("extra-message", lambda f: 0 < len(f.labels.strange) <= 3 and len(f.came) > MESSAGES // 2),
    ("rounded-stamp", lambda f: f.labels.lost_a_part),
    ("own-stamp", lambda f: f.labels.strange),
    ("one-stamp", lambda f: len(f.came) > STARTING and len({answer.stamp_s for answer in f.came}) == 1),
    ("no-names", lambda f: not f.labels.names),
    ("other-order", lambda f: f.labels.renamed and sorted(f.labels.names) == sorted(JOINTS)),
    ("other-names", lambda f: f.labels.renamed),
    ("other-length", lambda f: f.labels.other_lengths),
)
ABOUT_TIME = (
    *("falls-behind", "nan-left-out", "held-back", "none-after-restart", "first-left-out", "missing"),
    *("too-slow", "late"),
)
EACH_ONCE = WORDS.rules(
    Answers,
    "every-one-answered",
    ("repeated-at-restart", lambda f: f.order.repeated_at_restart),
    ("repeated-for-nan", lambda f: f.order.repeated_for_nan),
    ("repeated", lambda f: f.order.repeated),
    ("had-ended", lambda f: f.order.missing and f.has_ended, see.failed_by_error),
    ("some-missing", lambda f: f.order.missing[-1:] == [SAMPLES[-1]], see.program_ended),
    ("falls-behind", lambda f: f.order.missing and f.order.waits.typical_s > AT_ONCE_S),
    ("nan-left-out", lambda f: f.order.missing and all(one.place in NAN_AT for one in f.order.missing)),
    ("held-back", lambda f: f.order.rest_is_missing and RESTART < f.order.answered < MESSAGES),
    ("none-after-restart", lambda f: f.order.rest_is_missing and f.order.answered == RESTART),
    ("first-left-out", lambda f: f.order.missing and f.order.only_first_missing),
    ("missing", lambda f: f.order.missing),
    ("other-order", lambda f: f.order.misplaced),
    ("too-slow", lambda f: f.recording.clock == "simulated" and f.order.took_s > PERIOD_S),
    ("late", lambda f: f.order.is_late),
    about_time=ABOUT_TIME,
)
OFF_AND_ROUNDED = WORDS.seen("filters.rounded", Answers)
FILTERS = WORDS.rules(
    Answers,
    "filters",
    ("whole-numbers", lambda f: f.first.is_off and f.first.is_whole),
    ("offset", lambda f: f.first.is_off and f.first.is_shifted),
    ("nothing-left", lambda f: f.first.is_off and f.first.is_scaled and abs(f.first.gain) < NEAR_RAD),
    ("gain", lambda f: f.first.is_off and f.first.is_scaled),
    ("mixes-joints", lambda f: f.first.is_off),
    ("too-weak", lambda f: f.steady.is_weakly_filtered),
    ("passes-through", lambda f: f.steady.is_unfiltered),
)
ROUNDED = WORDS.cause("noise-reduced.rounded", Answers)
NOISY = WORDS.rules(
    Answers,
    "noise-reduced",
    ("no-number", lambda f: not all(math.isfinite(joint.noise) for joint in f.steady.joints)),
    ("beside-after-restart", lambda f: f.last.is_off),
    ("some-joints", lambda f: f.steady.raw),
    ("held-after-restart", lambda f: f.last.held and not f.first.held),
    ("not-after-restart", lambda f: f.unfiltered_after_restart),
    ("begins-anew", lambda f: f.begins_again_each_second),
    ("rounded", lambda f: f.steady.is_rounded),
    ("stands-still", lambda f: f.first.stands_still),
    ("to-one-side", lambda f: f.first.is_on_one_side),
    ("none", lambda f: f.steady.noise > NEARLY_ALL or f.steady.noisiest.noise > MORE_THAN_ALL),
    ("unlike-joints", lambda f: f.steady.gap),
    ("too-little", see.otherwise),
)
DELAY = WORDS.rules(
    Answers,
    "delay-bounded",
    ("no-number", lambda f: not f.forth.finite),
    ("too-late", lambda f: f.forth.delay > LONGEST_DELAY_S),
    ("one-joint", lambda f: f.forth.latest.delay > LONGEST_DELAY_OF_ONE_S),
    ("later-on", lambda f: f.back.is_late),
)
TOO_FEW = {
    word: WORDS.rules(
        Section,
        word,
        ("too-few-answers", lambda section: not section.enough, see.program_ended),
        about_time=True,
    )
    for word in ("noise-reduced", "delay-bounded", "near")
}
BEGIN = WORDS.rules(
    Start,
    "begins-near",
    ("swings-in", lambda f: f.on_the_way_from == "zeros"),
    ("elsewhere", see.otherwise),
    when=lambda start: start.section.all_far,
)
BEGIN_AGAIN = WORDS.rules(
    Start,
    "restart-noticed",
    ("some-joints", lambda f: f.old),
    ("one-late", lambda f: f.number == 1 and f.on_the_way_from == "before" and f.only_first_far),
    ("first-only", lambda f: f.number == 2 and f.on_the_way_from == "before"),
    ("nanosec-alone", lambda f: f.answers.begins_again_each_second),
    ("elsewhere", lambda f: f.on_the_way_from == "elsewhere"),
    ("remembers", lambda f: f.on_the_way_from == "before"),
    ("zeros", see.otherwise),
    when=lambda start: start.section.all_far,
)
AFTER_NAN = WORDS.rules(
    Answers,
    "survives-nan",
    ("second-in-a-row", lambda f: f.nan.bad and f.nan.bad[0].place == SECOND_IN_A_ROW),
    ("never-leaves", lambda f: f.nan.bad and f.nan.never_leaves),
    ("in-the-window", lambda f: any(one.place not in NAN_AT for one in f.nan.bad)),
    ("passed-on", lambda f: f.nan.bad),
    ("follows-slowly", lambda f: f.nan.lost and not f.back.held),
    ("not-followed", lambda f: f.nan.lost),
    ("other-angle", lambda f: f.nan.section.enough and f.nan.section.all_far),
)


@criterion(points=1, title="It subscribes to /encoders/joint_states, type JointState", needs=[program_runs])
def listens(recording: Recording) -> Verdict:
    return see.listens(recording, RAW)


@criterion(points=1, title="/robot/joint_states carries JointState", needs=[program_runs])
def output_topic(recording: Recording) -> Verdict:
    verdict = see.publishes(recording, FILTERED)
    if not verdict.ok and recording.topic(RAW.name).publishers:
        return WHERE_IT_LISTENS.verdict(expected=verdict.expected)
    return verdict


@criterion(points=0, title="The node publishes answers", needs=[listens, output_topic])
def answers_come(recording: Recording) -> Verdict:
    if recording.topic(FILTERED.name).arrivals:
        return see.passed("answers arrive")
    return SILENT.verdict(ANSWERS(recording))


@criterion(
    points=1,
    title="Each answer has the stamp and names of the message it answers, and an angle for each joint",
    needs=[answers_come],
)
def labels_kept(recording: Recording) -> Verdict:
    answers = ANSWERS(recording)
    told = f"{see.count(len(answers.came), 'answer')} with stamp, names, and {len(JOINTS)} angles"
    return LABELS.first(answers) or see.passed(told)


@criterion(
    points=2, title="Every message is answered exactly once, right away, and in order", needs=[answers_come]
)
def every_one_answered(recording: Recording) -> Verdict:
    answers = ANSWERS(recording)
    verdict = unclear(answers) or EACH_ONCE.first(answers)
    return verdict or see.passed(f"{MESSAGES} messages, {MESSAGES} answers")


@criterion(points=0, title="The filter reduces the noise", needs=[answers_come])
def filters(recording: Recording) -> Verdict:
    answers = ANSWERS(recording)
    verdict = unclear(answers) or off_and_rounded(answers) or FILTERS.first(answers)
    return verdict or see.passed("the output differs from the input")


@criterion(points=1, title="At most 55 % of the noise is left", needs=[filters])
def noise_reduced(recording: Recording) -> Verdict:
    answers = ANSWERS(recording)
    if answers.steady.is_calm and not answers.last.is_off:
        return see.passed(f"{answers.steady.noise:.0%} of the noise is left")
    return TOO_FEW["noise-reduced"].first(answers.steady) or NOISY.verdict(answers)


@criterion(points=1, title="The published angles lag at most 0.27 s behind the joints", needs=[filters])
def delay_bounded(recording: Recording) -> Verdict:
    answers = ANSWERS(recording)
    verdict = TOO_FEW["delay-bounded"].first(answers.forth) or DELAY.first(answers)
    return verdict or see.passed(f"{max(answers.forth.delay, 0.0):.2f} s behind")


@criterion(
    points=1, title="The first published angles are close to the joints' actual angles", needs=[filters]
)
def begins_near(recording: Recording) -> Verdict:
    return begins(Start(recording, 0), BEGIN)


@criterion(points=1, title="It notices each restart and resets the filter's state", needs=[filters])
def restart_noticed(recording: Recording) -> Verdict:
    verdict = begins(Start(recording, 1), BEGIN_AGAIN)
    return begins(Start(recording, 2), BEGIN_AGAIN) if verdict.ok else verdict


@criterion(points=1, title="NaNs don't corrupt the published angles", needs=[filters])
def survives_nan(recording: Recording) -> Verdict:
    answers = ANSWERS(recording)
    return AFTER_NAN.first(answers) or TOO_FEW["near"].first(answers.nan.section) or IS_NEAR


def unclear(answers: Answers) -> Verdict | None:
    """Return a verdict that says why the answers can't be judged, or None if they can be.

    Each answer must have an angle for each joint, and we must know the message that it answers.
    """
    if any(len(answer.angles) != len(JOINTS) for answer in answers.placed):
        return see.not_judged("some answers don't have an angle for each joint")
    if any(answer.place is None for answer in answers.placed):
        return see.not_judged("the stamps don't show which message each answer is for")
    return None


def off_and_rounded(answers: Answers) -> Verdict | None:
    first = answers.first
    if not first.is_off or first.is_whole or not first.is_rounded:
        return None
    saw, expected = OFF_AND_ROUNDED(answers)
    return replace(ROUNDED.verdict(answers), saw=saw, expected=expected)


def begins(start: Start, rules: see.Rules[Start]) -> Verdict:
    """Check that the angles are near the joints' after a start. `rules`: the causes if they aren't."""
    return TOO_FEW["near"].first(start.section) or rules.first(start) or IS_NEAR
