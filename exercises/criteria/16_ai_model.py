"""Judge exercise 16: the judge publishes the camera's images and the IMU's samples of a robot that falls.

So it knows the toys on the desk, and the time of the fall. A *glare* is a time at which the light is so bright that the
model raises an exception.
"""

import math
import random
import re
from collections import Counter
from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass, replace
from functools import cached_property, lru_cache, partial
from itertools import pairwise
from statistics import fmean, median
from typing import Any

from sensor_msgs.msg import Image, Imu
from std_msgs.msg import String
from visualization_msgs.msg import MarkerArray

import workbook.criteria as see
from workbook.criteria import Recording, Verdict, criterion, program_runs, topic, watching

WORDS = see.Words(__file__, globals())
IMAGE, IMU = topic("/camera/image", Image), topic("/robot/imu", Imu)
DETECTIONS = topic("/robot/detections", MarkerArray)
STATUS = topic("/robot/status", String, hz=10.0)

CAMERA_HZ, IMU_HZ, BEGIN_S, PICTURES = 30.0, 50.0, 0.5, 330
IMU_SECONDS = PICTURES / CAMERA_HZ
MODEL_S, SOONEST_S, TYPICALLY_S, MOSTLY_S, MOSTLY_SHARE, LEAST_HZ = 0.2, 0.19, 0.30, 0.35, 0.9, 3.0
PAUSE_S = 2.0  # if no answer comes for this long after a glare, the node pauses, because six answers are due
STOPPED_S = 1.5  # if no answer comes for this long at the end, the node has stopped
WITHIN_PIXELS, RIGHT_SHARE = 5.0, 0.8
WHOLE = 0.9  # a toy must be detected if this fraction of it is visible; otherwise, it may be
LEAST_BEATS, MOST_BEATS, LONGEST_SILENCE_S = 0.9, 1.1, 0.5
HARDLY_ANY = 3  # with this few heartbeats, we don't say that the heartbeat has stopped
STANDSTILL_S = 0.1  # the judge sends a sample every 0.02 s, so in a pause this long, it was held up itself
TILT_DEG, TILTED_SAMPLES, FALLEN_DEG, FALL_WITHIN_S = 60.0, 10, 65.0, 0.5
FOLLOWS_WITHIN_S = 0.4  # this soon after the robot is upright, a status that follows the tilt has changed
REACTS_S = 0.25  # an "error" this soon after a jolt is due to that jolt
LABELS = {"ball", "brick", "cup", "plate"}
OPERATIONAL, ERROR = "operational", "error"
WORDS_OF_THE_MODEL = re.compile(r"glare: \d+ ?% of the picture is white")
MOST = 0.6  # the fraction of the wrong messages that must fit a cause
MOST_BEHIND = 12  # images: a result with a stamp later than that waited for another call of the model
NOISE = 1616  # the seed of the noise in the images


@dataclass(frozen=True)
class Toy:
    """A toy on the desk, in an image or in a marker: its label, its center (pixels), and its visible fraction."""

    label: str
    u: float
    v: float
    visible: float = 1.0

    def pixels_to(self, other: "Toy") -> float:
        return math.hypot(self.u - other.u, self.v - other.v)

    def is_among(self, others: Iterable["Toy"], *, any_label: bool = False) -> bool:
        alike = [one for one in others if any_label or one.label == self.label]
        return any(self.pixels_to(one) <= WITHIN_PIXELS for one in alike)

    def is_corner_of(self, other: "Toy") -> bool:
        return self.label == other.label and 2 < other.u - self.u < 25 and 2 < other.v - self.v < 25

    def __str__(self) -> str:
        return f"{self.label} at ({self.u:.0f}, {self.v:.0f})"


@dataclass(frozen=True)
class Tilt:
    """IMU samples during which the robot is tilted by `deg` (°) `toward` a direction (°; 0: forward, 90: left)."""

    first: int
    count: int
    deg: float
    toward: float

    @property
    def end(self) -> int:
        """The first sample after the tilt."""
        return self.first + self.count


class Run:
    """The events of one run, and the program's input: images, identified by their places, and IMU samples.

    `glare_s`: the start and end (s since the first image) of each glare. All jolts and `leaning` end before the robot
    falls. The last two jolts have nine samples each, with six upright ones in between.
    """

    def __init__(self, dice: random.Random) -> None:
        # Times are in tenths of a second, with five samples each. After a glare, the robot neither leans nor falls for
        # a while. A program that pauses for three or five seconds after each exception works again before the end. At
        # least two more seconds follow the fall.
        falls, jolted = dice.randint(64, 87), dice.randint(6, 10)
        glare = dice.randint(jolted + 11, 24)
        again = dice.randint(glare + 26, min(glare + 46, falls - 14))
        leans = dice.randint(glare + 11, again - 14)
        toward = [dice.uniform(-180.0, 180.0) for _ in range(5)]
        self.glare_s = ((glare / 10, (glare + 7) / 10), (again / 10, (again + 5) / 10))
        self.jolts = (
            Tilt(0, 6, 70.0, toward[0]),  # from the very first sample on
            Tilt(5 * jolted, 7, 80.0, toward[1]),
            Tilt(5 * leans + 20, 6, 100.0, toward[2]),
            Tilt(5 * jolted + 20, 9, 75.0, toward[3]),
            Tilt(5 * jolted + 35, 9, 75.0, toward[3]),
        )
        self.leaning = Tilt(5 * leans, 50, 55.0, toward[4])
        # The robot falls forward and to the left, so that its tilt in each of these directions alone is less than 60°.
        self.fall = Tilt(5 * falls, 65, FALLEN_DEG, dice.uniform(43.0, 47.0))
        self.fall_sample = self.fall.first + TILTED_SAMPLES - 1  # from this sample on, the tilt is a fall
        self.views = views(dice, self.glare)
        self.samples = [self._sample(dice, number) for number in range(round(IMU_SECONDS * IMU_HZ))]
        self.place_of = {view.stamp: place for place, view in enumerate(self.views)}
        self.in_glare = [place for place in range(PICTURES) if self.glare(place / CAMERA_HZ)]

    def glare(self, seconds: float) -> bool:
        """Return whether the model raises an exception for an image taken `seconds` s after the first one."""
        return any(begin <= seconds < end for begin, end in self.glare_s)

    def _sample(self, dice: random.Random, number: int) -> tuple[float, dict[str, Any]]:
        """Return the time (s) at which an IMU sample is due, and its message's fields.

        If tilts overlap, the largest one counts.
        """
        tilts = [one for one in (*self.jolts, self.leaning, self.fall) if one.first <= number < one.end]
        deg, toward_deg = max(((one.deg, one.toward) for one in tilts), default=(3.0, 0.0))
        tilt, toward, seconds = math.radians(deg), math.radians(toward_deg), number / IMU_HZ
        level, z = 9.81 * math.sin(tilt), 9.81 * math.cos(tilt)
        up = {"x": level * math.cos(toward), "y": level * math.sin(toward), "z": z}
        stamp = see.Stamp.at(self.views[0].stamp[0] + seconds)
        return BEGIN_S + seconds, {
            "header": {"stamp": stamp._asdict(), "frame_id": "imu_link"},
            "linear_acceleration": {axis: value + dice.gauss(0.0, 0.15) for axis, value in up.items()},
        }

    @cached_property
    def toys(self) -> list[list[Toy]]:
        """The toys in each image."""
        seen = [see.things_seen(view.scene) for view in self.views]
        return [[Toy(one.label, one.u, one.v, one.visible) for one in things] for things in seen]


def views(dice: random.Random, glare: Callable[[float], bool]) -> list[see.CameraView]:
    """Draw all images of one run, in order.

    Toys lie on the desk, the head turns from side to side, and the ball rolls.
    """
    swung, swayed, turned = (dice.uniform(0.0, 2 * math.pi) for _ in range(3))
    side, first_stamp_s = dice.choice((-1.0, 1.0)), dice.randrange(300, 900)

    def at(forward: float, left: float) -> tuple[float, float]:
        return forward + dice.uniform(-0.02, 0.02), side * (left + dice.uniform(-0.02, 0.02))

    def brick(forward: float, left: float, turn: float) -> see.Box:
        return see.Box(at(forward, left), turn=side * (turn + dice.uniform(-0.2, 0.2)))

    blue_ball = see.on_desk(*at(1.16, -0.06))
    bricks = brick(1.12, 0.36, 0.6), brick(1.2, -0.35, -0.3)
    cup, plate = see.Cup(at(0.86, -0.3)), see.Plate(at(0.8, 0.3))

    def view(number: int) -> see.CameraView:
        seconds = number / CAMERA_HZ
        swing, sway = math.sin(2.2 * seconds + swung), math.cos(1.3 * seconds + swayed)
        ball = see.on_desk(0.84 + 0.05 * sway, side * (0.02 + 0.12 * swing))
        pan = 0.16 * math.sin(2.9 * seconds + turned)
        light, warm = 4.0 if glare(seconds) else 0.8 + 0.2 * math.sin(0.7 * seconds), 1.0 + 0.05 * sway
        toys = ball, blue_ball, bricks, None
        scene = see.Scene(*toys, pan=pan, light=light, warm=warm, cups=(cup,), plates=(plate,))
        return see.CameraView(scene, see.Stamp.at(first_stamp_s + seconds), NOISE, number, encoding="bgr8")

    return [view(number) for number in range(PICTURES)]


@lru_cache(maxsize=4)
def drawn(seed: int) -> Run:
    return Run(random.Random(seed))


def script(dice: random.Random) -> list[see.Part]:
    """Return the script with the images and samples of one run."""
    run = Run(dice)
    times = [round(BEGIN_S + place / CAMERA_HZ, 4) for place in range(PICTURES)]
    images = list(zip(times, map(see.camera_image, run.views), strict=True))
    return [see.publish(IMAGE.name, Image, images), see.publish(IMU.name, Imu, run.samples)]


WATCH = watching(wall_seconds=BEGIN_S + IMU_SECONDS + 0.7, script=script)


@see.once
def in_judges_time(recording: Recording) -> Recording:
    return see.without_standstills(recording, 1.0 / IMU_HZ, STANDSTILL_S)


@dataclass(frozen=True)
class Answer:
    """One MarkerArray: its image's place (-1: none or several), stamps (s), detections, and publication time (s)."""

    place: int
    stamps: tuple[float, ...]
    things: tuple[Toy, ...]
    wall: float


class Watched:
    """The messages sent to the program, and the program's answers. Times are in s of wall time.

    Raises ValueError for a recording without a seed.
    """

    def __init__(self, recording: Recording) -> None:
        if recording.seed is None:
            raise ValueError("this recording is older than runs that are drawn: judge the answer again")
        self.recording, self.run, self.log = recording, drawn(recording.seed), recording.process.log
        self.ended = recording.process.ended_by == "itself"
        self.sent = [one.wall for one in see.published(recording, IMAGE.name)]
        self.felt = [one.wall for one in see.published(recording, IMU.name)]
        self.fallen_at = [*self.felt[self.run.fall_sample :], math.inf][0]
        heartbeats, arrivals = (recording.topic(one.name).arrivals for one in (STATUS, DETECTIONS))
        self.statuses = [(one.published, one.value.get("data")) for one in heartbeats]
        self.error_at = next((at for at, word in self.statuses if word == ERROR), math.inf)
        answers = [self._answer(one) for one in arrivals if isinstance(one.value.get("markers"), list)]
        self.answers = sorted(answers, key=lambda one: one.wall)
        self.full = [one for one in self.answers if one.things]
        spans = [[round(at * CAMERA_HZ) for at in glare] for glare in self.run.glare_s]
        last = len(self.sent) - 1  # the watch may have ended before all images were sent
        self.glares = [(self.sent[begin], self.sent[min(end, last)]) for begin, end in spans if begin <= last]

    def _answer(self, arrival: see.Arrival) -> Answer:
        markers = arrival.value["markers"]
        stamps = list(dict.fromkeys(map(see.Stamp.of, markers)))
        place = self.run.place_of.get(stamps[0], -1) if len(stamps) == 1 else -1
        points = [(marker["ns"], marker["pose"]["position"]) for marker in markers]
        things = tuple(Toy(label, float(point["x"]), float(point["y"])) for label, point in points)
        return Answer(place, tuple(stamp.seconds for stamp in stamps), things, arrival.published)

    def in_glare(self, at: float, late: float, early: float = 0.0) -> bool:
        """Return whether the time `at` (s) is in a glare, or at most `late` s after or `early` s before a glare."""
        return any(begin - early <= at <= end + late for begin, end in self.glares)

    def gave_up(self, last: Answer) -> bool:
        """Return whether a glare was so near that the model may have raised its exception after the last message."""
        return self.in_glare(last.wall, 2 * MODEL_S, early=MODEL_S)

    def waits_for_the_model(self) -> bool:
        """Return whether most heartbeats come right after the model has finished, because one thread does both jobs."""
        done = [one.wall for one in self.answers] or [math.inf]
        times = [at for at, _ in self.statuses if done[0] <= at <= done[-1] + MODEL_S]
        within = [at for at in times if not self.in_glare(at, 2 * MODEL_S)]
        soon = [at for at in within if any(0.0 <= at - end <= 0.03 for end in done)]
        return len(within) > 5 and len(soon) >= MOST * len(within)


class Heartbeat(Watched):
    """The regularity of the heartbeats, from the first one to the end, or to the last one if the program exited."""

    def __init__(self, recording: Recording) -> None:
        super().__init__(recording)
        self.beats = see.beats(see.part_of(recording, STATUS, lambda data: True), STATUS)
        self.share_until_end = self.beats.share
        if self.ended:
            times = [arrival.t for arrival in recording.topic(STATUS.name).arrivals]
            self.beats = replace(self.beats, due=round((times[-1] - times[0]) / STATUS.period) + 1)
        silence, self.errors = self.beats.silence, [word for _, word in self.statuses].count(ERROR)
        self.has_gap = silence.seconds > LONGEST_SILENCE_S
        self.stopped = self.has_gap and silence.kind == "after" and self.beats.count > HARDLY_ANY
        continues = not self.ended and self.statuses[-1][1] == ERROR
        self.ends_with_the_fall = continues and self.errors <= HARDLY_ANY


class Detections(Watched):
    """The images to which the detections belong, and the images' ages (s) when the messages were published."""

    def __init__(self, recording: Recording) -> None:
        super().__init__(recording)
        full, known = self.full, {sec + nanosec / 1e9 for sec, nanosec in self.run.place_of}
        self.messages, self.pace = len(full), typical_step(full)
        self.strange = [one for one in full if not known.issuperset(one.stamps)]
        self.strange_stamp = next((s for one in self.strange for s in one.stamps if s not in known), 0.0)
        self.half_stamped = all(0.0 in one.stamps and len(one.stamps) == 2 for one in self.strange)
        self.mixed = [len(one.stamps) for one in full if len(one.stamps) > 1]
        self.repeated_image, self.repeated = Counter(one.place + 1 for one in full).most_common(1)[0]
        different = {(one.place, one.things) for one in full}
        single = all(len(one.things) == 1 for one in full)
        self.one_marker_each = single and len(different) >= MOST * len(full)
        self.back = [(a.place + 1, b.place + 1) for a, b in pairwise(full) if b.place < a.place]
        late = [one for one in full if one.place > MOST_BEHIND]
        self.behind = self._pictures_behind([one for one in late if one.place not in self.run.in_glare])
        self.off, self.off_before = (median(self._misfits(late, back)) for back in (0, self.behind))

        wrong = STAMPS.first(self)
        self.knows_stamps = wrong is None
        self.knows_images = wrong is None or wrong.cause == "stamps-kept.later-picture"
        shifted = [replace(one, place=max(one.place - self.behind, 0)) for one in full]
        self.fitting = shifted if self.knows_images else []  # with the images in which the toys were detected
        self.matched = [one for one in self.fitting if one.place < len(self.sent)]
        self.ages = [one.wall - self.sent[one.place] for one in self.matched]

        by_stamp = [one.wall - self.sent[one.place] for one in full if 0 <= one.place < len(self.sent)]
        is_fresh = bool(by_stamp) and median(by_stamp) <= MOSTLY_S
        rests = [self._next(over) - over for _, over in self.glares if is_fresh]
        self.rest = next((rest for rest in rests if rest > PAUSE_S), 0.0)  # without messages after a glare

    def _next(self, over: float) -> float:
        """Return the time (s) of the next answer after a glare, or of the last sent image if no answer came.

        `over`: the end of the glare (s).
        """
        return min((one.wall for one in self.full if one.wall > over + MODEL_S / 2), default=self.sent[-1])

    def _pictures_behind(self, known: Sequence[Answer]) -> int:
        """Return the number of images by which detections lag behind their stamps, or 0 if they don't or it's unclear.

        Only messages for which the toys have moved far enough in between are used.
        """
        toys = self.run.toys
        best = min(range(MOST_BEHIND + 1), key=lambda back: fmean(self._misfits(known, back)))
        moved = [one for one in known if misfit(toys[one.place], toys[one.place - best]) > WITHIN_PIXELS]
        here, there = median(self._misfits(moved, 0)), median(self._misfits(moved, best))
        tells = len(known) >= 8 and len(moved) >= 5
        return best if tells and here > WITHIN_PIXELS / 2 and there <= here / 2 else 0

    def _misfits(self, given: Iterable[Answer], back: int) -> list[float]:
        """Return each message's misfit (pixels) with the toys `back` images before the image with its stamp."""
        return [misfit(one.things, self.run.toys[one.place - back]) for one in given] or [0.0]


def misfit(things: Iterable[Toy], toys: Sequence[Toy]) -> float:
    """Return the typical distance (pixels) from detections to the nearest toy with the same label.

    A detection without such a toy counts as far away.
    """
    off = [[one.pixels_to(toy) for toy in toys if toy.label == one.label] for one in things]
    return median([min(pixels, default=99.0) for pixels in off] or [0.0])


def typical_step(given: Iterable[Answer]) -> float:
    """Return the typical time (s) between two messages, or infinity if there are fewer than two."""
    return median([b.wall - a.wall for a, b in pairwise(given)] or [math.inf])


class Freshness(Detections):
    """The detections' ages (s), and the number of images answered per second. This needs at least three messages."""

    def __init__(self, recording: Recording, raw_ages: Sequence[float]) -> None:
        super().__init__(recording)
        sent, ages, in_glare = self.sent, self.ages, self.run.in_glare
        self.typical, self.raw_typical = median(ages), median(raw_ages)
        self.in_time = sum(round(age, 2) <= MOSTLY_S for age in ages) / len(ages)
        self.too_old = round(self.typical, 2) > TYPICALLY_S or self.in_time < MOSTLY_SHARE
        self.too_soon = sum(round(age, 2) < SOONEST_S for age in raw_ages)
        fifth = max(len(ages) // 5, 1)
        self.first, self.last = median(ages[:fifth]), median(ages[-fifth:])
        self.apart = typical_step(self.matched)
        self.waited = max(self.typical - self.apart, 0.0)  # the time (s) that an image waited for the model
        spans = [(sent[one.place], one.wall - MODEL_S) for one in self.matched]  # until the model started
        self.missed = median(sum(begin < at <= end for at in sent) for begin, end in spans)

        last, gave_up = self.matched[-1].wall, self.gave_up(self.matched[-1])
        self.silent = 0.0 if gave_up else sent[-1] - last
        self.stopped = self.silent > STOPPED_S
        self.stops_with_the_fall = abs(last - self.error_at) <= STOPPED_S / 2
        place = max(one.place for one in self.matched)
        blind = sum(end - begin for begin, end in self.run.glare_s if begin * CAMERA_HZ < place)
        lasted = (last if gave_up else sent[-1] + MODEL_S) - self.matched[0].wall - blind
        self.hertz = len([one for one in self.matched if one.place not in in_glare]) / max(lasted, 0.1)
        self.too_few = not self.rest and self.hertz < LEAST_HZ  # `survives` judges a pause after a glare
        since_fall = sent[-1] - self.fallen_at  # at least two seconds after the fall are needed to judge
        count = len([one for one in self.matched if one.wall > self.fallen_at]) + 1
        self.hertz_fallen = math.inf if since_fall < 2.0 or gave_up else count / (since_fall + MODEL_S)


class Message:
    """The detections in one message, and the toys in its image. The program must detect the toys in `whole`."""

    def __init__(self, run: Run, place: int, found: Sequence[Toy]) -> None:
        toys, scene, self.number, self.found = run.toys[place], run.views[place].scene, place + 1, found
        self.whole = [toy for toy in toys if toy.visible >= WHOLE]
        self.missing = not all(toy.is_among(found) for toy in self.whole)
        self.extra = not all(one.is_among(toys) for one in found)
        self.is_right = not self.missing and not self.extra and len(found) <= len(toys)
        assert scene.blue_ball is not None  # it isn't a toy to detect
        decoy = Toy("", *see.seen_pixel(scene.blue_ball, pan=scene.pan))
        self.has_decoy = decoy.is_among(found, any_label=True)
        self.misnamed = self.missing and all(toy.is_among(found, any_label=True) for toy in self.whole)
        turned = [Toy(one.label, one.v, one.u) for one in found]
        self.rows_for_columns = all(toy.is_among(turned) for toy in self.whole)
        self.at_corners = all(any(one.is_corner_of(toy) for one in found) for toy in self.whole)
        self.other_labels = not {one.label for one in found} <= LABELS


class Correctness:
    """The number of correct messages, and the wrong messages."""

    def __init__(self, messages: Sequence[Message]) -> None:
        self.wrong = [one for one in messages if not one.is_right]
        self.count, self.right = len(messages), len(messages) - len(self.wrong)
        self.example = [*self.wrong, None][len(self.wrong) // 2]

    def mostly(self, fits: Callable[[Message], bool]) -> bool:
        """Return whether most of the wrong messages satisfy `fits`."""
        return sum(map(fits, self.wrong)) >= MOST * len(self.wrong)


class Survival(Detections):
    """The program's behavior after the model raises its exception."""

    def __init__(self, recording: Recording) -> None:
        super().__init__(recording)
        images, last = self.run.in_glare, self.full[-1]
        sent = [self.sent[place] for place in images if place < len(self.sent)]
        self.glaring = len(images)
        self.over = len(sent) == len(images) and last.wall > sent[-1] + 3 * MODEL_S
        reached = not self.knows_stamps or max(one.place for one in self.full) >= images[0]
        self.silent = not self.over or self.ended or not reached  # since the model raised its exception
        self.unseen = self.silent and not self.ended and (self.over or not self.gave_up(last))
        self.lines, self.own_text = len(WORDS_OF_THE_MODEL.findall(self.log)), "glare" in self.log
        self.most_lines = 2 * sum(end - begin for begin, end in self.run.glare_s) / MODEL_S
        self.ended_without_a_word = self.ended and not self.lines and see.last_error(recording) is None
        self.guessed = [one for one in self.full if one.place in images and self.knows_stamps]
        self.guessed_toys = any(toy.label in LABELS for one in self.guessed for toy in one.things)
        empty = [one.wall for one in self.answers if not one.things]  # outside of a glare, they may be right
        self.empty = sum(any(0.9 * MODEL_S <= at - one <= 3 * MODEL_S for one in sent) for at in empty)


class Fall(Watched):
    """The changes of the status, compared with the robot's jolts and its fall."""

    def __init__(self, recording: Recording) -> None:
        super().__init__(recording)
        self.early, self.delay = self.fallen_at - self.error_at, max(self.error_at - self.fallen_at, 0.0)
        self.is_early = self.error_at < self.felt[self.run.fall.first]
        self.is_late = round(self.delay, 2) > FALL_WITHIN_S
        self.jolt = next((one for one in self.run.jolts if self.error_during(one)), None)
        again = [at for at, word in self.statuses if at > self.error_at and word == OPERATIONAL]
        self.again_at = [*again, math.inf][0]
        self.again_after = self.again_at - self.error_at
        self.upright_for = self.again_at - self.felt[min(self.run.fall.end, len(self.felt) - 1)]
        upright = f"{self.upright_for:.1f} s after the robot was set upright"
        self.when_forgiven = "while the robot was still on the floor" if self.upright_for < 0.0 else upright

    def error_during(self, tilt: Tilt, skipped: int = 0) -> bool:
        """Return whether "error" came during or soon after a tilt, not counting the tilt's first `skipped` samples."""
        return self.felt[tilt.first + skipped] <= self.error_at <= self.felt[tilt.end] + REACTS_S


BEATS = WORDS.seen("heartbeat-kept.measured", Heartbeat)
TOO_MANY = WORDS.cause("heartbeat-kept.too-many", Heartbeat)
MISSING_BEATS = WORDS.rules(
    Heartbeat,
    "heartbeat-kept",
    ("no-more", lambda f: f.stopped, see.program_ended),
    ("rarely", lambda f: f.beats.count <= HARDLY_ANY),
    ("ends-with-the-fall", lambda f: f.stopped and f.ends_with_the_fall),
    ("stops", lambda f: f.stopped),
    ("waits-for-the-model", lambda f: f.waits_for_the_model()),
    ("held-up", lambda f: f.has_gap),
    ("too-few", see.otherwise),
    when=lambda f: (
        round(f.beats.share, 2) < LEAST_BEATS or round(f.beats.silence.seconds, 2) > LONGEST_SILENCE_S
    ),
    about_time=True,
)
NO_DETECTIONS = WORDS.rules(
    Watched,
    "detections-come",
    ("empty", lambda f: f.answers),
    ("nothing", see.otherwise, see.ended_or_error),
    about_time=["nothing"],
)
STAMPS: see.Rules[Detections] = WORDS.rules(
    Detections,
    "stamps-kept",
    ("some-without-stamp", lambda f: f.strange and f.half_stamped),
    ("no-stamp", lambda f: f.strange and all(one.stamps == (0.0,) for one in f.strange)),
    ("own-stamp", lambda f: f.strange),
    ("several-pictures", lambda f: f.mixed),
    ("last-result-again", lambda f: f.behind and f.pace < MODEL_S / 2),
    ("later-picture", lambda f: f.behind),
    ("one-for-each-detection", lambda f: f.repeated > 1 and f.one_marker_each),
    ("repeated", lambda f: f.repeated > 1),
    ("goes-back", lambda f: f.back),
)
FEW_ANSWERS = WORDS.cause("answers.too-few", ["answered"], about_time=True)
FRESH = WORDS.seen("fresh.measured", Freshness)
NOT_ENOUGH = ["stops-with-the-fall", "stops", "too-few", "rarely-after-the-fall"]
NOT_FRESH = WORDS.rules(
    Freshness,
    "fresh",
    ("faster-than-the-model", lambda f: f.knows_stamps and round(f.raw_typical, 2) < SOONEST_S),
    # On a busy machine, the time at which an image was sent is sometimes recorded late.
    ("some-guessed", lambda f: f.knows_stamps and f.too_soon > f.messages / 20),
    ("queue-grows", lambda f: f.too_old and f.last > f.first + 1.0),
    ("slow", lambda f: f.too_old and f.apart > 1.5 * MODEL_S),
    ("old-pictures", lambda f: f.too_old),
    ("stops-with-the-fall", lambda f: f.stopped and f.stops_with_the_fall),
    ("stops", lambda f: f.stopped, see.ended_or_error),
    ("too-few", lambda f: f.too_few, see.ended_or_error),
    ("rarely-after-the-fall", lambda f: not f.rest and f.hertz_fallen < LEAST_HZ),
    about_time=["queue-grows", "slow", "old-pictures", *NOT_ENOUGH],
)
WRONG = WORDS.rules(
    Correctness,
    "right",
    ("colors-swapped", lambda f: f.mostly(lambda one: one.missing and one.has_decoy)),
    ("only-one", lambda f: f.mostly(lambda one: len(one.found) == 1 and not one.extra)),
    ("rows-for-columns", lambda f: f.mostly(lambda one: one.rows_for_columns)),
    ("corner", lambda f: f.mostly(lambda one: one.at_corners)),
    ("labels", lambda f: f.mostly(lambda one: one.misnamed)),
    ("no-toy", lambda f: f.mostly(lambda one: not one.missing and one.other_labels)),
    ("some-extra", lambda f: f.mostly(lambda one: not one.missing)),
    ("some-missing", lambda f: f.mostly(lambda one: not one.extra)),
    ("something-else", see.otherwise),
    when=lambda f: f.right < RIGHT_SHARE * f.count,
)
RAISES = WORDS.seen("survives.glare", Survival)
AFTER_GLARE = WORDS.rules(
    Survival,
    "survives",
    ("left", lambda f: f.ended_without_a_word, see.program_ended),
    ("not-seen", lambda f: f.unseen),
    ("same-picture-again", lambda f: f.silent and not f.ended and f.lines > f.most_lines),
    ("gave-up", lambda f: f.silent and f.lines and "Traceback" not in f.log),
    ("ended", lambda f: f.silent),
    ("too-rarely", lambda f: f.pace > 3 * MODEL_S),
    ("pauses", lambda f: f.rest),
    ("marker-without-a-toy", lambda f: f.guessed and not f.guessed_toys),
    ("answered", lambda f: f.guessed),
    ("empty", lambda f: f.empty),
    ("no-line", lambda f: not f.lines),
    about_time=["not-seen", "same-picture-again", "gave-up", "ended", "too-rarely", "pauses"],
)
NO_FALL = WORDS.rules(
    Watched,
    "fall-reported",
    ("not-seen", lambda f: not f.ended),
    ("ended-before", see.otherwise, partial(see.failed_by_error, about_time=True)),
    when=lambda f: f.fallen_at == math.inf,
    about_time=True,
)
WRONG_FALL = WORDS.rules(
    Fall,
    "fall-reported",
    ("counts-on", lambda f: f.is_early and f.error_during(f.run.jolts[-1], skipped=3)),
    ("on-a-jolt", lambda f: f.is_early and f.jolt),
    ("on-leaning", lambda f: f.is_early and f.error_during(f.run.leaning)),
    ("on-glare", lambda f: f.is_early and f.in_glare(f.error_at, 5 * MODEL_S)),
    ("before", lambda f: f.is_early),
    ("never", lambda f: f.error_at == math.inf, see.program_ended),
    ("waits-for-the-model", lambda f: f.is_late and f.waits_for_the_model()),
    ("late", lambda f: f.is_late),
    ("taken-back", lambda f: 0.0 <= f.upright_for <= FOLLOWS_WITHIN_S),
    ("forgiven", lambda f: f.again_at < math.inf),
    about_time=["never", "waits-for-the-model", "late"],
)
NO_IMAGE = see.not_judged("the stamps don't show which image each message is for")


@criterion(
    points=1,
    title="It subscribes to /camera/image (Image), and /robot/detections carries MarkerArray",
    needs=[program_runs],
)
def camera_topics(recording: Recording) -> Verdict:
    return see.all_of(see.listens(recording, IMAGE), see.publishes(recording, DETECTIONS))


@criterion(
    points=0,
    title="It subscribes to /robot/imu (Imu), and /robot/status carries String",
    needs=[program_runs],
)
def status_topics(recording: Recording) -> Verdict:
    return see.all_of(see.listens(recording, IMU), see.publishes(recording, STATUS))


@criterion(
    points=1,
    title="The heartbeat continues: /robot/status is published at 10 Hz, even while the model runs",
    needs=[status_topics],
)
@see.needs_messages(STATUS)
def heartbeat_kept(recording: Recording) -> Verdict:
    words = see.one_of(recording, STATUS, (OPERATIONAL, ERROR))
    if not words.ok:
        return words
    facts = Heartbeat(in_judges_time(recording))
    if facts.beats.share > MOST_BEATS and Heartbeat(recording).share_until_end > MOST_BEATS:
        return TOO_MANY.verdict(facts)
    return MISSING_BEATS.first(facts) or see.passed(BEATS(facts)[0])


@criterion(points=0, title="Detections are published", needs=[camera_topics])
def detections_come(recording: Recording) -> Verdict:
    facts = Watched(recording)
    return see.passed("detections arrive") if facts.full else NO_DETECTIONS.verdict(facts)


@criterion(
    points=1,
    title="Each detection has its image's stamp, and there's only one message per image, in order",
    needs=[detections_come],
)
def stamps_kept(recording: Recording) -> Verdict:
    facts = Detections(recording)
    passed = see.passed(f"{see.count(facts.messages, 'message')}, each with its image's stamp")
    return STAMPS.first(facts) or passed


@criterion(
    points=2,
    title=f"Detections are fresh: typically at most {TYPICALLY_S:g} s old, nine out of ten at most {MOSTLY_S:g} s",
    needs=[detections_come],
)
def fresh(recording: Recording) -> Verdict:
    raw, calm = Detections(recording), in_judges_time(recording)
    answered = len(Detections(calm).ages)
    if not raw.knows_images:
        return NO_IMAGE
    if answered < 3:
        return few_answers(recording, answered)
    facts = Freshness(calm, raw.ages)
    if facts.too_old and not facts.knows_stamps:  # the ages are uncertain by some hundredths of a second
        return NO_IMAGE
    return NOT_FRESH.first(facts) or see.passed(FRESH(facts)[0])


@criterion(
    points=2, title="The detections are correct, in images that you haven't seen", needs=[detections_come]
)
def right(recording: Recording) -> Verdict:
    seen = Detections(recording)
    if not seen.knows_images:
        return NO_IMAGE
    known = [one for one in seen.fitting if one.place not in seen.run.in_glare]
    facts = Correctness([Message(seen.run, one.place, one.things) for one in known])
    if not known:
        return few_answers(recording, 0)
    return WRONG.first(facts) or see.passed(f"{facts.right} of {facts.count} messages are correct")


@criterion(
    points=1,
    title="When the model raises, it publishes nothing for the image, logs the exception, and continues",
    needs=[detections_come],
)
def survives(recording: Recording) -> Verdict:
    facts = Survival(in_judges_time(recording))
    survived = see.passed(f"{RAISES(facts)[0]}; the exception was logged, and later images were answered")
    return AFTER_GLARE.first(facts) or survived


@criterion(
    points=2,
    title=f"/robot/status reports error within {FALL_WITHIN_S:g} s of a fall, not before, and keeps reporting it",
    needs=[status_topics],
)
def fall_reported(recording: Recording) -> Verdict:
    nothing = see.no_message(recording, STATUS) or NO_FALL.first(Watched(in_judges_time(recording)))
    if nothing is not None:
        return nothing
    facts = Fall(in_judges_time(recording))
    return WRONG_FALL.first(facts) or see.passed(
        f'"{ERROR}" {facts.delay:.2f} s after the fall, and from then on'
    )


def few_answers(recording: Recording, answered: int) -> Verdict:
    """Return the verdict if hardly any image was answered, so that nothing else can be judged."""
    few = FEW_ANSWERS.verdict(answered=answered)
    return see.ended_or_error(recording, few.saw, few.expected) or few
