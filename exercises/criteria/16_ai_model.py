"""How exercise 16 is judged: the judge is camera and IMU, and knows what is on the desk and when the robot falls."""

import math
import random
import re
import statistics
from collections import Counter
from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass, replace
from functools import lru_cache
from itertools import pairwise
from typing import Any

from sensor_msgs.msg import Image, Imu
from std_msgs.msg import String
from visualization_msgs.msg import MarkerArray

import workbook.criteria as see
from workbook.criteria import (
    Box,
    CameraView,
    Cup,
    Plate,
    Recording,
    Scene,
    Verdict,
    criterion,
    program_runs,
    topic,
    watching,
)

IMAGE = topic("/camera/image", Image)
IMU = topic("/robot/imu", Imu)
DETECTIONS = topic("/robot/detections", MarkerArray)
STATUS = topic("/robot/status", String, hz=10.0)

CAMERA_HZ = 30.0
IMU_HZ = 50.0
MODEL_S = 0.2
SOONEST_S = 0.19
TYPICALLY_S, MOSTLY_S, MOSTLY_SHARE = 0.30, 0.35, 0.9
LEAST_HZ = 3.0
PAUSE_S = 2.0
"""When nothing is answered for so long after the glare is over, the node does not just go on: six pictures are due."""
STOPPED_S = 1.5
"""Without an answer for so long at the end, the node has stopped looking."""
WITHIN_PIXELS = 5.0
RIGHT_SHARE = 0.8
WHOLE, HARDLY = 0.9, 0.6
"""What is seen to this part must be found; what is seen less than that need not be, and may be."""
LEAST_BEATS, MOST_BEATS = 0.9, 1.1
HARDLY_ANY = 3
"""Beats: so few are no heartbeat that has stopped."""
LONGEST_SILENCE_S = 0.5
STANDSTILL_S = 0.1
"""When the judge itself sent nothing for so long (s), it was held up: a sample of the IMU is due every 0.02 s."""
TILT_DEG, TILTED_SAMPLES = 60.0, 10
FALL_WITHIN_S = 0.5
FOLLOWS_WITHIN_S = 0.4
"""So soon after the robot is upright again, a status that follows the current tilt has changed."""
LABELS = ("ball", "brick", "cup", "plate")
OPERATIONAL, ERROR = "operational", "error"
WORDS_OF_THE_MODEL = re.compile(r"glare: \d+ ?% of the picture is white")
MOST = 0.6
"""Which share of what is wrong must look like a reason."""
NOISE = 1616
"""What the noise of the pictures is made from."""

BEGIN_S = 0.5
PICTURES = 330
IMU_SECONDS = PICTURES / CAMERA_HZ
FALLEN_DEG = 65.0


@dataclass(frozen=True)
class Toy:
    """Something on the desk, in a picture or in a marker: its label, and its middle (pixels)."""

    label: str
    u: float
    v: float


@dataclass(frozen=True)
class Tilt:
    """Samples of the IMU in which the robot is tilted: how far, and where to (°): 0 is forward, 90 is to the left."""

    first: int
    count: int
    deg: float
    toward: float

    @property
    def end(self) -> int:
        """The first sample after them."""
        return self.first + self.count


@dataclass(frozen=True)
class Events:
    """What happens in one run. All jolts and `leaning` are over when the robot falls.

    `glare_s`: when (s since the first picture) the light is so bright that the model gives up. `jolts`: the last two
    are nine samples each, with six upright ones between them.
    """

    glare_s: tuple[tuple[float, float], tuple[float, float]]
    jolts: tuple[Tilt, ...]
    leaning: Tilt
    fall: Tilt

    @property
    def fall_sample(self) -> int:
        """The sample with which the fall is a fall: the tenth tilted one in a row."""
        return self.fall.first + TILTED_SAMPLES - 1

    def tilt_at(self, sample: int) -> tuple[float, float]:
        """How far the robot is tilted, and where to (°): the most of what there is at that moment."""
        tilts = (*self.jolts, self.leaning, self.fall)
        now = [(one.deg, one.toward) for one in tilts if one.first <= sample < one.end]
        return max(now, default=(3.0, 0.0))


def events(dice: random.Random) -> Events:
    """Draw when everything happens, in tenths of a second.

    After a glare, the robot neither leans nor falls for a while. One who rests for three seconds after each exception,
    or for five, works again before the end. After the fall, two more seconds come at least.
    """
    falls = dice.randint(64, 87)
    jolted = dice.randint(6, 10)
    glare = dice.randint(jolted + 11, 24)
    again = dice.randint(glare + 26, min(glare + 46, falls - 14))
    leans = dice.randint(glare + 11, again - 14)
    first = 5 * jolted  # samples in a tenth of a second: five
    toward = [dice.uniform(-180.0, 180.0) for _ in range(5)]
    return Events(
        ((glare / 10, (glare + 7) / 10), (again / 10, (again + 5) / 10)),
        (
            Tilt(0, 6, 70.0, toward[0]),  # also the very first samples
            Tilt(first, 7, 80.0, toward[1]),
            Tilt(5 * leans + 20, 6, 100.0, toward[2]),
            Tilt(first + 20, 9, 75.0, toward[3]),
            Tilt(first + 35, 9, 75.0, toward[3]),
        ),
        Tilt(5 * leans, 50, 55.0, toward[4]),
        # Forward and to the left: in each of these directions alone, it is tilted by less than 60°.
        Tilt(5 * falls, 65, FALLEN_DEG, dice.uniform(43.0, 47.0)),
    )


def views(dice: random.Random, glare: Callable[[float], bool]) -> tuple[CameraView, ...]:
    """All pictures of one run, in order: toys lie on the desk, the head turns from side to side, and the ball rolls."""
    swung, swayed, turned = (dice.uniform(0.0, 2 * math.pi) for _ in range(3))
    side, first_stamp_s = dice.choice((-1.0, 1.0)), dice.randrange(300, 900)

    def at(forward: float, left: float) -> tuple[float, float]:
        return forward + dice.uniform(-0.02, 0.02), side * (left + dice.uniform(-0.02, 0.02))

    blue_ball = see.on_desk(*at(1.16, -0.06))
    bricks = tuple(
        Box(at(*place), turn=side * (turn + dice.uniform(-0.2, 0.2)))
        for place, turn in (((1.12, 0.36), 0.6), ((1.2, -0.35), -0.3))
    )
    cup, plate = Cup(at(0.86, -0.3)), Plate(at(0.8, 0.3))
    made = []
    for number in range(PICTURES):
        seconds = number / CAMERA_HZ
        swing, sway = math.sin(2.2 * seconds + swung), math.cos(1.3 * seconds + swayed)
        scene = Scene(
            see.on_desk(0.84 + 0.05 * sway, side * (0.02 + 0.12 * swing)),
            blue_ball,
            bricks,
            None,
            pan=0.16 * math.sin(2.9 * seconds + turned),
            light=4.0 if glare(seconds) else 0.8 + 0.2 * math.sin(0.7 * seconds),
            warm=1.0 + 0.05 * sway,
            cups=(cup,),
            plates=(plate,),
        )
        in_ns = round((first_stamp_s + seconds) * 1e9)
        stamp = in_ns // 10**9, in_ns % 10**9
        made.append(CameraView(scene, stamp, NOISE, number, encoding="bgr8"))
    return tuple(made)


class Run:
    """What a program is shown in one run: pictures, and samples of the IMU. A picture is named by its place."""

    def __init__(self, dice: random.Random) -> None:
        self.events = events(dice)
        self.views = views(dice, self.glare)
        self.samples = self._samples(dice)
        self.place_of = {view.stamp: place for place, view in enumerate(self.views)}
        self.in_glare = [place for place in range(PICTURES) if self.glare(place / CAMERA_HZ)]
        self._toys: dict[int, tuple[tuple[Toy, float], ...]] = {}

    def glare(self, seconds: float) -> bool:
        """Whether the model gives up on a picture that is taken so long after the first one."""
        return any(begin <= seconds < end for begin, end in self.events.glare_s)

    def _samples(self, dice: random.Random) -> list[tuple[float, dict[str, Any]]]:
        """What the IMU says: when (s), and the fields of an Imu."""
        first_stamp_s = self.views[0].stamp[0]
        made = []
        for number in range(round(IMU_SECONDS * IMU_HZ)):
            seconds = number / IMU_HZ
            tilt, toward = map(math.radians, self.events.tilt_at(number))
            level, z = 9.81 * math.sin(tilt), 9.81 * math.cos(tilt)
            x, y = level * math.cos(toward), level * math.sin(toward)
            in_ns = round((first_stamp_s + seconds) * 1e9)
            made.append(
                (
                    BEGIN_S + seconds,
                    {
                        "header": {
                            "stamp": {"sec": in_ns // 10**9, "nanosec": in_ns % 10**9},
                            "frame_id": "imu_link",
                        },
                        "linear_acceleration": {
                            "x": x + dice.gauss(0.0, 0.15),
                            "y": y + dice.gauss(0.0, 0.15),
                            "z": z + dice.gauss(0.0, 0.15),
                        },
                    },
                )
            )
        return made

    def toys(self, place: int) -> tuple[tuple[Toy, float], ...]:
        """What can be seen in a picture, and which part of it is visible."""
        if place not in self._toys:
            found = see.things_seen(self.views[place].scene)
            self._toys[place] = tuple((Toy(one.label, one.u, one.v), one.visible) for one in found)
        return self._toys[place]

    def all_toys(self, place: int) -> list[Toy]:
        """What may be found in a picture."""
        return [toy for toy, _ in self.toys(place)]

    def whole(self, place: int) -> list[Toy]:
        """What must be found in a picture."""
        return [toy for toy, visible in self.toys(place) if visible >= WHOLE]

    def decoy(self, place: int) -> Toy:
        """The blue ball of a picture: nothing that is to be found."""
        one = self.views[place].scene
        assert one.blue_ball is not None
        return Toy("ball", *see.seen_pixel(one.blue_ball, pan=one.pan))


@lru_cache(maxsize=4)
def drawn(seed: int) -> Run:
    """The run with this seed."""
    return Run(random.Random(seed))


def run_of(recording: Recording) -> Run:
    """What a program was shown. Raises ValueError where a recording does not tell: an old one."""
    if recording.seed is None:
        raise ValueError("this recording is older than runs that are drawn: judge the answer again")
    return drawn(recording.seed)


def script(dice: random.Random) -> list[see.Part]:
    """The pictures and samples of one run."""
    run = Run(dice)
    return [
        see.publish(
            IMAGE.name,
            Image,
            [
                (round(BEGIN_S + place / CAMERA_HZ, 4), see.camera_image(view))
                for place, view in enumerate(run.views)
            ],
        ),
        see.publish(IMU.name, Imu, run.samples),
    ]


WATCH = watching(wall_seconds=BEGIN_S + IMU_SECONDS + 0.7, script=script)


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
    title="The heartbeat continues: /robot/status comes at 10 Hz, even while the model runs",
    needs=[status_topics],
)
@see.needs_messages(STATUS)
def heartbeat_kept(recording: Recording) -> Verdict:
    words = see.one_of(recording, STATUS, (OPERATIONAL, ERROR))
    if not words.ok:
        return words
    raw = see.beats(see.part_of(recording, STATUS, lambda data: True), STATUS)  # from the first heartbeat on
    recording = in_judges_time(recording)
    part = see.part_of(recording, STATUS, lambda data: True)
    beats = see.beats(part, STATUS)
    if (
        recording.process.ended_by == "itself"
    ):  # judged by what came until then; that it ended is judged elsewhere
        times = [arrival.t for arrival in recording.topic(STATUS.name).arrivals]
        beats = replace(beats, due=round((times[-1] - times[0]) / STATUS.period) + 1)
    saw = (
        f"{beats.count} of {beats.due} heartbeats ({beats.share:.0%}), the longest silence "
        f"{beats.silence.seconds:.2f} s"
    )
    if raw.share > MOST_BEATS and beats.share > MOST_BEATS:
        return see.failed(
            "heartbeat-kept.too-many",
            saw,
            HEARTBEAT_EXPECTED,
            "More than one place publishes the status, or its timer's period is shorter than 0.1 s.",
            "Publish the status only from one 0.1 s timer.",
        )
    if round(beats.share, 2) < LEAST_BEATS or round(beats.silence.seconds, 2) > LONGEST_SILENCE_S:
        return why_no_heartbeat(recording, beats, saw)
    return see.passed(saw)


@criterion(points=0, title="Detections come", needs=[camera_topics])
def detections_come(recording: Recording) -> Verdict:
    given = answers(recording)
    if any(answer.things for answer in given):
        return see.passed("detections come")
    expected = f"the toys on the desk, on {DETECTIONS.name}"
    if given:
        return see.failed(
            "detections-come.empty",
            f"{see.count(len(given), 'message')} on {DETECTIONS.name}, but none contains a marker",
            expected,
            "The model found nothing in any image, or its result isn't put into the message.",
            "Check that the image has the color order that the model expects, and print the model's result for one "
            "image.",
        )
    nothing = f"{PICTURES} images were published on {IMAGE.name}, but nothing arrived on {DETECTIONS.name}"
    return see.ended_or_error(recording, nothing, expected) or see.failed(
        "detections-come.nothing",
        nothing,
        expected,
        "Your code doesn't pass images to the model or doesn't publish its result, or an exception was lost in a "
        "thread. Or your code rejects all images as old, because their stamps come from a different clock than "
        "your program's.",
        "Log a line before and after the model call: which one is missing?",
        about_time=True,
    )


@criterion(
    points=1,
    title="One message per image, each detection with its image's stamp, in order",
    needs=[detections_come],
)
def stamps_kept(recording: Recording) -> Verdict:
    given = full_answers(recording)
    return wrong_stamps(run_of(recording), given) or see.passed(
        f"{see.count(len(given), 'message')}, each with its image's stamp"
    )


@criterion(
    points=2,
    title=f"Detections are fresh: typically at most {TYPICALLY_S:g} s old, nine of ten {MOSTLY_S:g} s",
    needs=[detections_come],
)
def fresh(recording: Recording) -> Verdict:
    matched = with_their_pictures(recording)
    if matched is None:
        return see.not_judged(NO_PICTURE)
    raw_ages = [one.age for one in timed(recording, matched)]
    recording = in_judges_time(recording)
    matched = with_their_pictures(recording) or []
    seen = timed(recording, matched)
    ages = [one.age for one in seen]
    if len(ages) < 3:
        return few_answers(recording, len(ages))
    typical = statistics.median(ages)
    in_time = sum(round(age, 2) <= MOSTLY_S for age in ages) / len(ages)
    hertz = answered_hz(recording, seen)
    saw = (
        f"typically {typical:.2f} s old, {in_time:.0%} at most {MOSTLY_S:g} s; {hertz:.1f} images answered per "
        "second"
    )
    too_old = round(typical, 2) > TYPICALLY_S or in_time < MOSTLY_SHARE
    if matched != full_answers(recording):  # the pictures are known to a few hundredths of a second
        if too_old:
            return see.not_judged(NO_PICTURE)
    elif (soon := too_soon(raw_ages, saw)) is not None:
        return soon
    if too_old:
        return why_old(recording, seen, saw)
    stopped = stops_early(recording, seen, saw)
    if stopped is not None:
        return stopped
    if pauses(recording, saw, [one for one in answers(recording) if one.things]) is not None:
        return see.passed(saw)  # a rest after glare is judged by `survives`
    if hertz < LEAST_HZ:
        return why_few(recording, saw)
    return rarely_after_the_fall(recording, seen, saw) or see.passed(saw)


@criterion(
    points=2,
    title="The detections are correct, in images that you haven't seen",
    needs=[detections_come],
)
def right(recording: Recording) -> Verdict:
    run, given = run_of(recording), with_their_pictures(recording)
    if given is None:
        return see.not_judged(NO_PICTURE)
    known = [(one.place, one) for one in given if one.place is not None and one.place not in run.in_glare]
    if not known:
        return few_answers(recording, 0)
    wrong = [(place, one) for place, one in known if not is_right(run, place, one)]
    saw = f"{len(known) - len(wrong)} of {len(known)} messages are correct"
    if len(known) - len(wrong) >= RIGHT_SHARE * len(known):
        return see.passed(saw)
    place, one = wrong[len(wrong) // 2]
    saw += f". Image {place + 1} shows {listed(run.whole(place))}; the message contains {listed(one.things)}"
    reason = first_that_fits(run, REASONS, wrong) or SOMETHING_ELSE
    return see.failed(reason.cause, saw, RIGHT_EXPECTED, reason.because, reason.try_this)


@criterion(
    points=1,
    title="It survives the model's exceptions: no message for such an image, a line in the log, and it continues",
    needs=[detections_come],
)
def survives(recording: Recording) -> Verdict:
    run, recording = run_of(recording), in_judges_time(recording)
    saw = f"for {len(run.in_glare)} images, the model raises RuntimeError (glare)"
    given = answers(recording)
    full = [one for one in given if one.things]
    return (
        silent_since_glare(recording, saw, full)
        or too_rarely(saw, full)
        or pauses(recording, saw, full)
        or answered_glare(run, saw, full)
        or said_nothing_there(recording, saw, given)
        or no_line(recording, saw)
        or see.passed(f"{saw}: logged, and later images were answered")
    )


@criterion(
    points=2,
    title=f"/robot/status becomes error on a fall: within {FALL_WITHIN_S:g} s, not before, and it stays",
    needs=[status_topics],
)
def fall_reported(recording: Recording) -> Verdict:
    nothing = see.no_message(recording, STATUS)
    if nothing is not None:
        return nothing
    recording = in_judges_time(recording)
    moments = [word.wall for word in see.published(recording, IMU.name)]
    what = run_of(recording).events
    if len(moments) <= what.fall_sample:
        return never_fell(recording)
    said = [(one.published, one.value["data"]) for one in recording.topic(STATUS.name).arrivals]
    errors = [at for at, word in said if word == ERROR]
    fallen, begins = moments[what.fall_sample], moments[what.fall.first]
    if errors and errors[0] < begins:
        return too_early(recording, errors[0], moments)
    if not errors:
        return no_error(recording)
    after = errors[0] - fallen
    saw = f'"{ERROR}" {max(after, 0.0):.2f} s after the fall'
    if round(after, 2) > FALL_WITHIN_S:
        return late_error(recording, saw)
    again = [at for at, word in said if at > errors[0] and word == OPERATIONAL]
    if again:
        return why_taken_back(
            f'{saw}, but "{OPERATIONAL}" again {again[0] - errors[0]:.1f} s later', again[0], moments, what
        )
    return see.passed(f"{saw}, and from then on")


HEARTBEAT_EXPECTED = (
    f"{LEAST_BEATS:.0%} to {MOST_BEATS:.0%} of ten heartbeats a second, never more than {LONGEST_SILENCE_S:g} s "
    "without one"
)
ONE_EACH = f"one message on {DETECTIONS.name} per image, with all of its detections"
PICTURE_STAMPS = "in each marker, the stamp of the image in which the toy was detected"
FRESH_EXPECTED = (
    f"typically at most {TYPICALLY_S:g} s old, nine of ten at most {MOSTLY_S:g} s; at least {LEAST_HZ:g} images "
    "answered per second"
)
RIGHT_EXPECTED = (
    f"in {RIGHT_SHARE:.0%} of the messages, each fully visible toy with its label, within {WITHIN_PIXELS:g} pixels, "
    "and nothing else"
)
SURVIVES_EXPECTED = (
    "no message for such an image, a line in the log with the exception's text, and answers to the images after "
    "that"
)
FALL_EXPECTED = (
    f'"{ERROR}" at most {FALL_WITHIN_S:g} s after {TILTED_SAMPLES} samples in a row are tilted by more than '
    f'{TILT_DEG:g}°, "{OPERATIONAL}" before that, and "{ERROR}" from then on'
)


# --- on a busy machine ---------------------------------------------------------------------------------------


def in_judges_time(recording: Recording) -> Recording:
    """The recording without the time in which the judge itself could not send what was due.

    Then the machine was held up, and most likely the program as well: what came late by so much was not late.
    """
    on_wall = without_standstills([word.wall for word in recording.published])
    on_simulated = without_standstills([word.t for word in recording.published])

    def moved(one: see.Arrival) -> see.Arrival:
        sent = None if one.sent is None else on_wall(one.sent)
        return replace(one, t=on_simulated(one.t), wall=on_wall(one.wall), sent=sent)

    topics = {
        name: replace(
            one,
            arrivals=tuple(map(moved, one.arrivals)),
            window=one.window and (on_simulated(one.window[0]), on_simulated(one.window[1])),
        )
        for name, one in recording.topics.items()
    }
    said = tuple(
        replace(word, t=on_simulated(word.t), wall=on_wall(word.wall)) for word in recording.published
    )
    return replace(recording, topics=topics, published=said)


def without_standstills(sent: Sequence[float]) -> Callable[[float], float]:
    """Which moment (s) of the judge's own time another moment is, by when the judge sent its messages."""
    pairs = pairwise(sorted(sent))
    still = [(a, b - a - 1.0 / IMU_HZ) for a, b in pairs if b - a > STANDSTILL_S]
    return lambda at: at - sum(min(max(at - begin, 0.0), lasted) for begin, lasted in still)


# --- what came back -----------------------------------------------------------------------------------------


@dataclass(frozen=True)
class Answered:
    """One MarkerArray: the place of its picture (None: none, or several), its stamps (s), when it was sent (s)."""

    place: int | None
    stamps: tuple[float, ...]
    things: tuple[Toy, ...]
    wall: float


def answers(recording: Recording) -> list[Answered]:
    """What arrived on the topic of the detections, in the order in which it was published."""
    found, place_of = [], run_of(recording).place_of
    for arrival in recording.topic(DETECTIONS.name).arrivals:
        markers = arrival.value["markers"]
        if not isinstance(markers, list):
            continue
        stamps = [one["header"]["stamp"] for one in markers]
        pairs = list(dict.fromkeys((stamp["sec"], stamp["nanosec"]) for stamp in stamps))
        things = [
            Toy(one["ns"], float(one["pose"]["position"]["x"]), float(one["pose"]["position"]["y"]))
            for one in markers
        ]
        found.append(
            Answered(
                place_of.get(pairs[0]) if len(pairs) == 1 else None,
                tuple(sec + nanosec / 1e9 for sec, nanosec in pairs),
                tuple(things),
                arrival.published,
            )
        )
    return sorted(found, key=lambda one: one.wall)


@dataclass(frozen=True)
class Timed:
    """An answer to a picture: its place, how old (s) the picture was when it was answered, and when that was (s)."""

    place: int
    age: float
    wall: float


def full_answers(recording: Recording) -> list[Answered]:
    """The answers with a marker in them."""
    return [one for one in answers(recording) if one.things]


NO_PICTURE = "the stamps don't tell which image each message is for"


def with_their_pictures(recording: Recording) -> list[Answered] | None:
    """Pair the answers with the images in which their toys were found; None if the recording can't tell.

    These are the pictures with their stamps, or the ones that came a fixed number of pictures earlier.
    """
    run, given = run_of(recording), full_answers(recording)
    wrong = wrong_stamps(run, given)
    if wrong is None:
        return given
    if wrong.cause != LATER_PICTURE:
        return None
    lag = pictures_behind(run, given)
    return [replace(one, place=None if one.place is None else max(one.place - lag, 0)) for one in given]


def timed(recording: Recording, given: Sequence[Answered] | None = None) -> list[Timed]:
    """All answers to pictures, with their age, in order. `given`: these answers alone."""
    sent = [word.wall for word in see.published(recording, IMAGE.name)]
    return [
        Timed(one.place, one.wall - sent[one.place], one.wall)
        for one in (answers(recording) if given is None else given)
        if one.place is not None and one.place < len(sent)
    ]


def answered_hz(recording: Recording, seen: Sequence[Timed]) -> float:
    """How many pictures were answered each second, without the time in which the model could not see anything.

    Of a node that a picture with glare has ended: until then. That is judged elsewhere.
    """
    run, sent = run_of(recording), [word.wall for word in see.published(recording, IMAGE.name)]
    last = max(one.place for one in seen)
    blind = sum(end - begin for begin, end in run.events.glare_s if begin * CAMERA_HZ < last)
    ended = seen[-1].wall if gave_up_in_glare(recording, seen) else sent[-1] + MODEL_S
    lasted = ended - seen[0].wall - blind
    return len([one for one in seen if one.place not in run.in_glare]) / max(lasted, 0.1)


def gave_up_in_glare(recording: Recording, given: Sequence[Timed] | Sequence[Answered]) -> bool:
    """Whether the last answer came when the first pictures with glare were handed to the model, or before the end."""
    sent = [word.wall for word in see.published(recording, IMAGE.name)]
    last = max(one.wall for one in given)
    glare_s = run_of(recording).events.glare_s
    spans = [(round(begin * CAMERA_HZ), round(end * CAMERA_HZ)) for begin, end in glare_s]
    return any(
        sent[begin] - MODEL_S <= last <= sent[min(end, len(sent) - 1)] + 2 * MODEL_S
        for begin, end in spans
        if begin < len(sent)
    )


# --- the heartbeat ------------------------------------------------------------------------------------------


def why_no_heartbeat(recording: Recording, beats: see.Beats, saw: str) -> Verdict:
    """Why too few heartbeats came, or none for a while."""
    if beats.count <= HARDLY_ANY:
        return see.failed(
            "heartbeat-kept.rarely",
            saw,
            HEARTBEAT_EXPECTED,
            "The status is published only once, or only when it changes. So a subscriber can't distinguish a "
            "healthy robot from one that has stopped.",
            "Publish the status in the callback of create_timer(0.1, ...), whether or not it has changed.",
            about_time=True,
        )
    if beats.silence.kind == "after" and beats.silence.seconds > LONGEST_SILENCE_S:
        saw = f"no heartbeat after {beats.silence.start:.1f} s"
        return (
            ends_with_the_fall(recording, saw)
            or see.program_ended(recording, saw, HEARTBEAT_EXPECTED)
            or see.ended_by_error(recording, saw, HEARTBEAT_EXPECTED)
            or see.failed(
                "heartbeat-kept.stops",
                saw,
                HEARTBEAT_EXPECTED,
                "The heartbeat has stopped: the program ended, or the executor no longer runs the heartbeat's "
                "timer.",
                "Read the log: what was the last thing that happened?",
                about_time=True,
            )
        )
    if waits_for_the_model(recording):
        return see.failed(
            "heartbeat-kept.waits-for-the-model",
            f"{saw}. Most heartbeats arrive right after a message with detections",
            HEARTBEAT_EXPECTED,
            f"The timer waits for the model, {MODEL_S:g} s each time. Either one thread runs both, or the heartbeat "
            "needs a lock that is held during the model call.",
            "Call the model in its own thread, or give its callback its own callback group in a "
            "MultiThreadedExecutor. Don't hold a lock during the call.",
            about_time=True,
        )
    return why_few_beats(beats, saw)


def ends_with_the_fall(recording: Recording, saw: str) -> Verdict | None:
    """Whether the last heartbeats are the first ones after the fall, from a program that goes on; None if not."""
    words = [one.value["data"] for one in recording.topic(STATUS.name).arrivals]
    times = words.count(ERROR)
    if ERROR not in words[-1:] or times > HARDLY_ANY or recording.process.ended_by == "itself":
        return None
    return see.failed(
        "heartbeat-kept.ends-with-the-fall",
        f'{saw}; by then, "{ERROR}" had arrived {see.count(times, "time")}',
        HEARTBEAT_EXPECTED,
        "The status is no longer published after the fall. So a subscriber can't distinguish a robot on the floor "
        "from one that has lost its connection.",
        f'After a fall, publish "{ERROR}" ten times per second.',
        about_time=True,
    )


def why_few_beats(beats: see.Beats, saw: str) -> Verdict:
    """Why beats are missing that the model does not hold up."""
    if beats.silence.seconds > LONGEST_SILENCE_S:
        return see.failed(
            "heartbeat-kept.held-up",
            f"{saw}, from {beats.silence.start:.1f} s on",
            HEARTBEAT_EXPECTED,
            "Something blocks the thread that runs the timer, or uses up the processor.",
            "Run the status timer in a thread that does no slow work.",
            about_time=True,
        )
    return see.failed(
        "heartbeat-kept.too-few",
        f"{saw}; typically {beats.typical_s:.2f} s apart",
        HEARTBEAT_EXPECTED,
        "The timer's period is too long, or the status is published in a callback that runs less often. Or a loop "
        "sleeps between calls to spin_once.",
        "Publish the status in the callback of create_timer(0.1, ...), and use rclpy.spin() or an executor without "
        "sleeping.",
        about_time=True,
    )


def waits_for_the_model(recording: Recording) -> bool:
    """Whether most heartbeats come just after the model has finished: one thread does both, by turns."""
    done = [one.wall for one in answers(recording)]
    beats = [one.published for one in recording.topic(STATUS.name).arrivals]
    within = [
        at for at in beats if done and done[0] <= at <= done[-1] + MODEL_S and not near_glare(recording, at)
    ]
    soon = [at for at in within if any(0.0 <= at - end <= 0.03 for end in done)]
    return len(within) > 5 and len(soon) >= MOST * len(within)


def near_glare(recording: Recording, at: float) -> bool:
    """Whether the model may be busy with a picture that it gives up on."""
    sent = [word.wall for word in see.published(recording, IMAGE.name)]
    return any(
        sent[round(begin * CAMERA_HZ)] <= at <= sent[round(end * CAMERA_HZ)] + 2 * MODEL_S
        for begin, end in run_of(recording).events.glare_s
        if round(end * CAMERA_HZ) < len(sent)
    )


# --- stamps -------------------------------------------------------------------------------------------------


def wrong_stamps(run: Run, given: Sequence[Answered]) -> Verdict | None:
    """What is wrong with the stamps; None if nothing is."""
    return (
        strange_stamps(run, given)
        or several_pictures(given)
        or later_stamps(run, given)
        or one_for_each(given)
        or answered_twice(given)
        or not_in_order(given)
    )


def strange_stamps(run: Run, given: Sequence[Answered]) -> Verdict | None:
    """Stamps that no picture had."""
    known = {sec + nanosec / 1e9 for sec, nanosec in run.place_of}
    strange = [one for one in given if not set(one.stamps) <= known]
    if not strange:
        return None
    stamp = next(one for one in strange[0].stamps if one not in known)
    if all(0.0 in one.stamps and len(one.stamps) == 2 for one in strange):
        return see.failed(
            "stamps-kept.some-without-stamp",
            f"{len(strange)} of {see.count(len(given), 'message')} with some markers stamped 0 s, and others with "
            "an image's stamp",
            PICTURE_STAMPS,
            "Only some of a message's markers have their image's header.",
            "Give each marker its image's header. The original to_markers does that, so don't change it.",
        )
    saw = (
        f"{len(strange)} of {see.count(len(given), 'message')} with a stamp that no image had, the first {{}}"
    )
    if all(one.stamps == (0.0,) for one in strange):
        return see.failed(
            "stamps-kept.no-stamp",
            saw.format("0 s"),
            PICTURE_STAMPS,
            "Your code publishes new markers without filling in their headers.",
            "Give each marker its image's header.",
        )
    return see.failed(
        "stamps-kept.own-stamp",
        saw.format(f"{stamp:.2f} s"),
        PICTURE_STAMPS,
        "The node stamps its detections with its own clock, or loses a part of the stamp. But the stamp must tell "
        "when the image was taken, not when the model processed it.",
        "Copy the image's whole header into each marker.",
    )


def several_pictures(given: Sequence[Answered]) -> Verdict | None:
    """Messages with markers of more than one picture."""
    mixed = [one for one in given if len(one.stamps) > 1]
    if not mixed:
        return None
    return see.failed(
        "stamps-kept.several-pictures",
        f"{see.count(len(mixed), 'message')} with markers from several images, the first from {len(mixed[0].stamps)}",
        ONE_EACH,
        "Markers from earlier images stay in the message, or your code collects several images' detections before "
        "publishing.",
        "Create a new MarkerArray for each image.",
    )


def one_for_each(given: Sequence[Answered]) -> Verdict | None:
    """Whether each detection came in a message of its own."""
    several = [number for number in Counter(one.place for one in given).values() if number > 1]
    things = {(one.place, toy) for one in given for toy in one.things}
    if not several or any(len(one.things) > 1 for one in given) or len(things) < MOST * len(given):
        return None
    return see.failed(
        "stamps-kept.one-for-each-detection",
        f"{see.count(len(given), 'message')} with one marker each, up to {max(several)} for the same image",
        ONE_EACH,
        "Each detection is published in its own message.",
        "Call to_markers once with all detections, and publish once.",
    )


def answered_twice(given: Sequence[Answered]) -> Verdict | None:
    """Pictures that were answered more than once."""
    place, most = Counter(one.place for one in given).most_common(1)[0]
    if most < 2 or place is None:
        return None
    return see.failed(
        "stamps-kept.repeated",
        f"{most} messages with the stamp of image {place + 1}",
        ONE_EACH,
        "A timer or a loop answers the same image again and again, because it doesn't check for a new one. Or two "
        "lines publish the same result.",
        "Clear the stored image when you pass it to the model, and publish the model's result once.",
    )


def not_in_order(given: Sequence[Answered]) -> Verdict | None:
    """Messages that go back to an earlier picture."""
    places = [one.place for one in given if one.place is not None]
    back = [(a, b) for a, b in pairwise(places) if b < a]
    if not back:
        return None
    return see.failed(
        "stamps-kept.goes-back",
        f"image {back[0][1] + 1} is answered after image {back[0][0] + 1}; {see.count(len(back), 'step')} back in "
        "all",
        "messages in the order of their images",
        "Several threads or processes publish at the same time, or your code takes images from the wrong end of a "
        "queue. Or it publishes an earlier result for a newer image while the model is still busy.",
        "Let a single thread call the model and publish, and pass it only the newest image.",
    )


LATER_PICTURE = "stamps-kept.later-picture"
MOST_BEHIND = 12
"""Pictures: a result whose header comes from so much later has waited for another call of the model."""


def fitting(run: Run, given: Iterable[Answered], back: int) -> list[float]:
    """How far (pixels) the detections of each message are from the toys of the picture so many before its stamp."""
    return [
        statistics.median(distances(run, one.things, one.place - back))
        for one in given
        if one.place is not None
    ]


def moved(run: Run, place: int, back: int) -> float:
    """How far (pixels) the toys of a picture typically are from where they were so many pictures before."""
    return statistics.median(distances(run, run.all_toys(place), place - back) or [0.0])


def pictures_behind(run: Run, given: Sequence[Answered]) -> int:
    """How many pictures before those with their stamps the detections fit; 0 if they fit these, or none.

    Only messages for which the toys have moved far enough in between can tell.
    """
    known = [
        one
        for one in given
        if one.place is not None and one.place > MOST_BEHIND and one.place not in run.in_glare
    ]
    if len(known) < 8:
        return 0
    best = min(range(MOST_BEHIND + 1), key=lambda back: statistics.fmean(fitting(run, known, back)))
    telling = [one for one in known if moved(run, one.place or 0, best) > WITHIN_PIXELS]
    if len(telling) < 5:
        return 0
    here, there = (statistics.median(fitting(run, telling, back)) for back in (0, best))
    return best if here > WITHIN_PIXELS / 2 and there <= here / 2 else 0


def later_stamps(run: Run, given: Sequence[Answered]) -> Verdict | None:
    """Whether detections bear the stamp of a picture that came after the one they were found in; None if not."""
    behind = pictures_behind(run, given)
    if not behind:
        return None
    known = [one for one in given if (one.place or 0) > MOST_BEHIND]
    here, there = (statistics.median(fitting(run, known, back)) for back in (0, behind))
    saw = (
        f"the detections are typically {here:.1f} pixels away from the toys, but only {there:.1f} pixels away from "
        f"where the toys were {see.count(behind, 'image')} earlier"
    )
    return last_result_again(given, saw) or see.failed(
        "stamps-kept.later-picture",
        saw,
        PICTURE_STAMPS,
        "A detection gets a later image's stamp. The header was read from an attribute that the next image "
        "overwrites, or one image's result is published for the next image.",
        "Keep an image's pixels and header together, and pass both to the thread that calls the model.",
    )


def last_result_again(given: Sequence[Answered], saw: str) -> Verdict | None:
    """Whether more pictures are answered than the model can look at; None if not."""
    pace = statistics.median(b.wall - a.wall for a, b in pairwise(given))
    if pace >= MODEL_S / 2:
        return None
    return see.failed(
        "stamps-kept.last-result-again",
        f"{saw}. A message arrived every {pace:.2f} s, but the model takes {MODEL_S:g} s",
        PICTURE_STAMPS,
        "Each image is answered right away, with the detections from an earlier image. So the robot reaches for "
        "places where the toys used to be.",
        "Publish only when the model returns, with the header of the image that it received.",
    )


# --- whether detections are right ---------------------------------------------------------------------------


def distances(run: Run, things: Iterable[Toy], place: int) -> list[float]:
    """How far (pixels) each detection is from the nearest toy with its label; a large number where there is none."""
    found = []
    for thing in things:
        alike = [toy for toy in run.all_toys(place) if toy.label == thing.label]
        found.append(min((apart(thing, toy) for toy in alike), default=99.0))
    return found


def apart(one: Toy, other: Toy) -> float:
    return math.hypot(one.u - other.u, one.v - other.v)


def is_right(run: Run, place: int, answer: Answered) -> bool:
    """Whether each toy that is seen whole is there once, and nothing else."""
    missing = unmatched(run.whole(place), answer.things)
    extra = unmatched(answer.things, run.all_toys(place))
    return not missing and not extra and len(answer.things) <= len(run.toys(place))


def unmatched(wanted: Iterable[Toy], found: Sequence[Toy]) -> list[Toy]:
    """Those of `wanted` that are not among the `found`."""
    return [
        one
        for one in wanted
        if not any(one.label == other.label and apart(one, other) <= WITHIN_PIXELS for other in found)
    ]


def listed(things: Iterable[Toy]) -> str:
    """Toys as one says them."""
    return see.listing([f"{toy.label} at ({toy.u:.0f}, {toy.v:.0f})" for toy in things]) or "nothing"


@dataclass(frozen=True)
class Reason:
    """Why messages are wrong, and whether one message looks like it."""

    cause: str
    because: str
    try_this: str
    fits: Callable[[Run, int, Answered], bool]


def first_that_fits(
    run: Run, reasons: Iterable[Reason], wrong: Sequence[tuple[int, Answered]]
) -> Reason | None:
    """The first reason that fits most of the messages that are wrong."""
    for reason in reasons:
        if sum(reason.fits(run, place, one) for place, one in wrong) >= MOST * len(wrong):
            return reason
    return None


def colors_swapped(run: Run, place: int, answer: Answered) -> bool:
    """Whether the blue ball was found, and the orange toys were not."""
    return any(apart(one, run.decoy(place)) <= WITHIN_PIXELS for one in answer.things) and bool(
        unmatched(run.whole(place), answer.things)
    )


def only_the_first(run: Run, place: int, answer: Answered) -> bool:
    """Whether one detection stands for all."""
    return len(answer.things) == 1 and not unmatched(answer.things, run.all_toys(place))


def rows_for_columns(run: Run, place: int, answer: Answered) -> bool:
    """Whether columns and rows are exchanged."""
    turned = [Toy(one.label, one.v, one.u) for one in answer.things]
    return not unmatched(run.whole(place), turned)


def at_a_corner(run: Run, place: int, answer: Answered) -> bool:
    """Whether each toy is there with its label, but up to the left of its middle."""
    return all(
        any(
            toy.label == one.label and 2 < toy.u - one.u < 25 and 2 < toy.v - one.v < 25
            for one in answer.things
        )
        for toy in run.whole(place)
    )


def wrong_labels(run: Run, place: int, answer: Answered) -> bool:
    """Whether there is a marker where each toy is, but some have another label."""
    unnamed = [Toy("", one.u, one.v) for one in answer.things]
    wanted = [Toy("", one.u, one.v) for one in run.whole(place)]
    return not unmatched(wanted, unnamed) and bool(unmatched(run.whole(place), answer.things))


def some_extra(run: Run, place: int, answer: Answered) -> bool:
    """Whether all toys are there, and more."""
    return not unmatched(run.whole(place), answer.things)


def other_labels(run: Run, place: int, answer: Answered) -> bool:
    """Whether all toys are there, and markers with other labels."""
    return some_extra(run, place, answer) and any(toy.label not in LABELS for toy in answer.things)


def some_missing(run: Run, place: int, answer: Answered) -> bool:
    """Whether what is there is right, and something is missing."""
    return not unmatched(answer.things, run.all_toys(place))


REASONS = (
    Reason(
        "right.colors-swapped",
        "The model detected the blue ball as a toy, but missed orange toys. Red and blue are swapped: the camera "
        "sends bgr8, but the model expects RGB.",
        "Reverse the color order before you call the model: pixels[:, :, ::-1], or cv2.cvtColor.",
        colors_swapped,
    ),
    Reason(
        "right.only-one",
        "Only one of the detections is published.",
        "Publish a marker for each detection that the model returns.",
        only_the_first,
    ),
    Reason(
        "right.rows-for-columns",
        "Columns and rows are swapped.",
        "position.x is the column (u), position.y the row (v).",
        rows_for_columns,
    ),
    Reason(
        "right.corner",
        "The labels are correct, but each position is above the toy's center and to its left: it's a corner of the "
        "box.",
        "A detection's u and v are the center of its box. Don't change to_markers.",
        at_a_corner,
    ),
    Reason(
        "right.labels",
        "The positions are correct, but some labels don't belong to the toys at these positions.",
        "Each detection has its own label: ns=one.label. Don't change to_markers.",
        wrong_labels,
    ),
    Reason(
        "right.no-toy",
        "All toys are there, but there's also a marker whose label isn't a toy. A marker with the action DELETEALL "
        "counts as a marker, too.",
        "Publish one marker for each detection that the model returned for this image, and no others.",
        other_labels,
    ),
    Reason(
        "right.some-extra",
        "All toys are there, but there are extra markers: detections from another image, or the same toy twice.",
        "Publish one marker for each detection that the model returned for this image, and no others.",
        some_extra,
    ),
    Reason(
        "right.some-missing",
        "The published markers are correct, but some fully visible toys are missing.",
        "Publish a marker for each detection that the model returns.",
        some_missing,
    ),
)
SOMETHING_ELSE = Reason(
    "right.something-else",
    "The model received different pixels than the camera sent, or your code changed the model's result. Wrong "
    "pixels don't raise an exception; they just lead to wrong detections.",
    "Plot the array that you pass to the model for one image: colors, rows, and columns must be as in the image.",
    lambda run, place, answer: True,
)


# --- how old they are ---------------------------------------------------------------------------------------


def few_answers(recording: Recording, answered: int) -> Verdict:
    """Nothing can be said, because hardly any picture was answered."""
    saw = f"{see.count(answered, 'image')} of {PICTURES} answered"
    return see.ended_or_error(recording, saw, FRESH_EXPECTED) or see.failed(
        "answers.too-few",
        saw,
        FRESH_EXPECTED,
        "The node stopped answering, or answers very rarely.",
        "Pass the newest image to the model as soon as it has finished the previous one.",
        about_time=True,
    )


def too_soon(ages: Sequence[float], saw: str) -> Verdict | None:
    """Why detections come sooner than the model can find them; None if they do not.

    One in twenty may seem to: on a busy machine, the moment at which a picture was sent is noted late.
    """
    expected = f"the result of SlowDetector, which takes {MODEL_S:g} s per image"
    if round(statistics.median(ages), 2) < SOONEST_S:
        return see.failed(
            "fresh.faster-than-the-model",
            saw,
            expected,
            "The detections arrive sooner than the given model can compute them, so something else computes them.",
            "Call SlowDetector, and don't change it.",
        )
    soon = [age for age in ages if round(age, 2) < SOONEST_S]
    if len(soon) <= len(ages) / 20:
        return None
    return see.failed(
        "fresh.some-guessed",
        f"{saw}; {len(soon)} of {see.count(len(ages), 'message')} arrived sooner than {SOONEST_S:g} s after their "
        "image",
        expected,
        "Some detections arrive sooner than the model can compute them: an earlier result is published again for a "
        "newer image.",
        "Publish only the model's result, with the header of the image that it received.",
    )


def rarely_after_the_fall(recording: Recording, seen: Sequence[Timed], saw: str) -> Verdict | None:
    """Why few pictures are answered from the fall on; None if enough are."""
    sent = [word.wall for word in see.published(recording, IMAGE.name)]
    felt = [word.wall for word in see.published(recording, IMU.name)]
    fall_sample = run_of(recording).events.fall_sample
    if len(felt) <= fall_sample or sent[-1] - felt[fall_sample] < 2.0 or gave_up_in_glare(recording, seen):
        return None
    lasted = sent[-1] + MODEL_S - felt[fall_sample]
    hertz = (sum(one.wall > felt[fall_sample] for one in seen) + 1) / lasted
    if hertz >= LEAST_HZ:
        return None
    return see.failed(
        "fresh.rarely-after-the-fall",
        f"{saw}. After the fall, only {hertz:.1f} per second",
        FRESH_EXPECTED,
        "After the fall, your code passes fewer images to the model. But a robot on the floor still has to see.",
        "Change only the status after a fall. Pass images to the model as often as before.",
        about_time=True,
    )


def why_old(recording: Recording, seen: Sequence[Timed], saw: str) -> Verdict:
    """Why detections are old: they waited in a queue, or the work for each takes long."""
    sent = [word.wall for word in see.published(recording, IMAGE.name)]
    pace = statistics.median(b.wall - a.wall for a, b in pairwise(seen))
    ages = [one.age for one in seen]
    tenth = max(len(ages) // 5, 1)
    first, last = statistics.median(ages[:tenth]), statistics.median(ages[-tenth:])
    waited = statistics.median(ages) - pace
    if last > first + 1.0:
        return see.failed(
            "fresh.queue-grows",
            f"{saw}. The first were {first:.1f} s old, the last {last:.1f} s",
            FRESH_EXPECTED,
            f"The camera sends {CAMERA_HZ:g} images per second, but the model can process only five. The others "
            "wait in a queue that keeps growing.",
            "Keep only the newest image: use a queue depth of 1, or an attribute that each image overwrites.",
            about_time=True,
        )
    if pace > 1.5 * MODEL_S:
        return see.failed(
            "fresh.slow",
            f"{saw}. The messages are {pace:.2f} s apart",
            FRESH_EXPECTED,
            f"The model takes {MODEL_S:g} s per image, but something takes additional time. Your code reloads the "
            "model for each image, calls it more than once, or waits before it publishes.",
            "Create SlowDetector once, at the start. Call it once per image, and publish right away.",
            about_time=True,
        )
    missed = [sum(1 for at in sent if sent[one.place] < at <= one.wall - MODEL_S) for one in seen]
    return see.failed(
        "fresh.old-pictures",
        f"{saw}. When the model started, typically {statistics.median(missed):.0f} newer images had already arrived",
        FRESH_EXPECTED,
        f"Images wait for about {max(waited, 0.0):.2f} s before the model receives them, although newer ones have "
        "arrived. They wait in the subscription's queue, or in your own.",
        "Keep only the newest image: use a queue depth of 1, or an attribute that each image overwrites.",
        about_time=True,
    )


def stops_early(recording: Recording, seen: Sequence[Timed], saw: str) -> Verdict | None:
    """Why the last pictures were not answered; None if they were, or if the model's exception ended it."""
    sent = [word.wall for word in see.published(recording, IMAGE.name)]
    if sent[-1] - seen[-1].wall <= STOPPED_S or gave_up_in_glare(recording, seen):
        return None
    errors = [one.published for one in recording.topic(STATUS.name).arrivals if one.value["data"] == ERROR]
    saw = f"{saw}. In the last {sent[-1] - seen[-1].wall:.1f} s, none was answered"
    if errors and abs(seen[-1].wall - errors[0]) <= STOPPED_S / 2:
        return see.failed(
            "fresh.stops-with-the-fall",
            saw,
            FRESH_EXPECTED,
            "The detections stop with the fall. But a robot on the floor still has to see.",
            "Change only the status after a fall. Process images until Ctrl-C.",
            about_time=True,
        )
    return see.ended_or_error(recording, saw, FRESH_EXPECTED) or see.failed(
        "fresh.stops",
        saw,
        FRESH_EXPECTED,
        "The node stopped answering: its thread ended, or waits for something that never happens.",
        "Process images until Ctrl-C. Log a line before and after the model is called: which is missing?",
        about_time=True,
    )


def why_few(recording: Recording, saw: str) -> Verdict:
    """Why too few pictures were answered, though these soon enough."""
    return see.ended_or_error(recording, saw, FRESH_EXPECTED) or see.failed(
        "fresh.too-few",
        saw,
        FRESH_EXPECTED,
        "The model is idle between images: a timer calls it too rarely, or the node stopped answering.",
        "Pass the newest image to the model as soon as it has finished the previous one.",
        about_time=True,
    )


# --- the model gives up -------------------------------------------------------------------------------------


def silent_since_glare(recording: Recording, saw: str, given: Sequence[Answered]) -> Verdict | None:
    """Why nothing was found any more since the model raised; None if something was."""
    run, sent = run_of(recording), [word.wall for word in see.published(recording, IMAGE.name)]
    first, last = run.in_glare[0], run.in_glare[-1]
    ended = recording.process.ended_by == "itself"
    over = len(sent) > last and given[-1].wall > sent[last] + 3 * MODEL_S
    behind = wrong_stamps(run, given) is None and max(one.place or 0 for one in given) < first
    if over and not ended and not behind:
        return None
    if not ended and (over or not gave_up_in_glare(recording, given)):
        return see.failed(
            "survives.not-seen",
            f"{saw}, and no later image was answered",
            SURVIVES_EXPECTED,
            "The node lags far behind the camera, or it stopped answering for another reason.",
            "First, make sure that fresh images are answered until the end.",
            about_time=True,
        )
    if ended:
        saw = f"{saw}, and the program ended"
        if not WORDS_OF_THE_MODEL.search(recording.process.log) and see.last_error(recording) is None:
            return left_by_itself(recording)
    else:
        saw = f"{saw}, and then no image was answered any more"
    lines = len(WORDS_OF_THE_MODEL.findall(recording.process.log))
    if not ended and lines > 2 * sum(end - begin for begin, end in run.events.glare_s) / MODEL_S:
        return see.failed(
            "survives.same-picture-again",
            f"{saw}. The log contains the exception's text {lines} times",
            SURVIVES_EXPECTED,
            "Your code passes the same image to the model again and again, and the model raises the exception each "
            "time.",
            "In the except branch, log the error, and continue with the next image.",
            about_time=True,
        )
    return why_ended(saw, bool(lines) and "Traceback" not in recording.process.log)


def left_by_itself(recording: Recording) -> Verdict:
    """The program ended, and not because the model gave up."""
    saw = "the judge can't see whether the node survives"
    ended = see.program_ended(recording, saw, SURVIVES_EXPECTED)
    assert ended is not None
    return ended


def why_ended(saw: str, caught: bool) -> Verdict:
    """Why nothing is answered after glare, where the exception was caught and logged, or where it was not."""
    if caught:
        return see.failed(
            "survives.gave-up",
            f"{saw}. The log contains the exception's text, but no traceback",
            SURVIVES_EXPECTED,
            "The exception was caught and logged. But then the node ended its thread or itself, or it no longer "
            "passes images to the model.",
            "In the except branch, log the error, and continue with the next image. However often the model "
            "raises, the next image may be fine.",
            about_time=True,
        )
    return see.failed(
        "survives.ended",
        saw,
        SURVIVES_EXPECTED,
        "The model's exception wasn't caught where the model is called. It ended the thread, the executor, or the "
        "program.",
        "try: found = model(pixels) / except RuntimeError as error: log the error, and continue with the next "
        "image.",
        about_time=True,
    )


def too_rarely(saw: str, given: Sequence[Answered]) -> Verdict | None:
    """Whether so few pictures were answered that the model may have been spared the glare."""
    pace = [b.wall - a.wall for a, b in pairwise(given)]
    if pace and statistics.median(pace) <= 3 * MODEL_S:
        return None
    return see.failed(
        "survives.too-rarely",
        f"{saw}, but so few images were answered that the model probably received none of these",
        SURVIVES_EXPECTED,
        "So the judge can't see whether the node survives.",
        "First, make sure that the model receives an image at least three times per second.",
        about_time=True,
    )


def pauses(recording: Recording, saw: str, given: Sequence[Answered]) -> Verdict | None:
    """Whether no detections come for a long time after glare, from a node that answers fresh pictures otherwise."""
    seen = timed(recording)
    sent = [word.wall for word in see.published(recording, IMAGE.name)]
    if not seen or statistics.median(one.age for one in seen) > MOSTLY_S:
        return None
    for _, end in run_of(recording).events.glare_s:
        over = sent[min(round(end * CAMERA_HZ), len(sent) - 1)]
        waited = min((one.wall for one in given if one.wall > over + MODEL_S / 2), default=sent[-1]) - over
        if waited > PAUSE_S:
            return see.failed(
                "survives.pauses",
                f"{saw}, and after the glare, no image was answered for {waited:.1f} s",
                SURVIVES_EXPECTED,
                "The program waits before it continues, or it re-creates the model. But the next image may be fine.",
                "In the except branch, log the error, and take the next image right away.",
                about_time=True,
            )
    return None


def answered_glare(run: Run, saw: str, given: Sequence[Answered]) -> Verdict | None:
    """Detections for pictures on which the model gave up, where stamps tell which picture they are for."""
    guessed = [one for one in given if one.place in run.in_glare]
    if not guessed or wrong_stamps(run, given) is not None:
        return None
    if not any(toy.label in LABELS for one in guessed for toy in one.things):
        return see.failed(
            "survives.marker-without-a-toy",
            f"{saw}, but for {len(guessed)} of them, your node published a marker whose label isn't a toy",
            SURVIVES_EXPECTED,
            "A marker for no toy, such as DELETEALL, is still a statement about the desk. But the model couldn't "
            "see the desk.",
            "In the except branch, log the error and return without publishing.",
        )
    return see.failed(
        "survives.answered",
        f"{saw}, but {len(guessed)} of them were answered with detections",
        SURVIVES_EXPECTED,
        "The model returned nothing for these images. The published detections are left over from an earlier image.",
        "In the except branch, log the error and return without publishing.",
    )


def said_nothing_there(recording: Recording, saw: str, given: Sequence[Answered]) -> Verdict | None:
    """Messages without any marker, soon after a picture with glare: at other times the model may have found nothing."""
    sent = [word.wall for word in see.published(recording, IMAGE.name)]
    glaring = [sent[place] for place in run_of(recording).in_glare if place < len(sent)]
    empty = [
        one
        for one in given
        if not one.things and any(0.9 * MODEL_S <= one.wall - at <= 3 * MODEL_S for at in glaring)
    ]
    if not empty:
        return None
    return see.failed(
        "survives.empty",
        f"{saw}, but {see.count(len(empty), 'message')} arrived without a marker",
        SURVIVES_EXPECTED,
        "An empty message means that the desk is empty. But the model couldn't see the desk.",
        "In the except branch, log the error and return without publishing.",
    )


def no_line(recording: Recording, saw: str) -> Verdict | None:
    """No line of the log tells what the model said."""
    if WORDS_OF_THE_MODEL.search(recording.process.log):
        return None
    own_words = "glare" in recording.process.log
    return see.failed(
        "survives.no-line",
        f'{saw}, but no line of the log contains "glare: ...% of the picture is white"',
        SURVIVES_EXPECTED,
        "The program logs its own text, not the exception's. So the log doesn't show how bright the image was."
        if own_words
        else "The exception is swallowed, or its text isn't in the logged line. So an engineer can't find out "
        "why the robot was blind.",
        'self.get_logger().error(f"the model gave up: {error}")',
    )


# --- the fall -----------------------------------------------------------------------------------------------


def never_fell(recording: Recording) -> Verdict:
    """The watch ended before the fall."""
    if recording.process.ended_by != "itself":
        return see.failed(
            "fall-reported.not-seen",
            "the watch ended before the robot fell",
            FALL_EXPECTED,
            "The machine was too busy to send all IMU samples in time.",
            "Check it again.",
            about_time=True,
        )
    saw = "the program ended before the robot fell"
    return see.failed_by_error(recording, saw, FALL_EXPECTED, about_time=True) or see.failed(
        "fall-reported.ended-before",
        saw,
        FALL_EXPECTED,
        "The program must run until Ctrl-C.",
        "Spin the node until Ctrl-C.",
        about_time=True,
    )


def too_early(recording: Recording, at: float, moments: Sequence[float]) -> Verdict:
    """Why "error" was said before the fall."""
    what = run_of(recording).events
    second = counted_on(at, moments, what)
    if second is not None:
        return second
    for jolt in what.jolts:
        if moments[jolt.first] <= at <= moments[jolt.end] + 0.25:
            return see.failed(
                "fall-reported.on-a-jolt",
                f'"{ERROR}" after a jolt of {jolt.count} samples',
                FALL_EXPECTED,
                "Your node interprets a jolt as a fall. Fewer than ten samples are enough for it, or an upright "
                "sample doesn't reset its count of tilted samples.",
                "Count the tilted samples in a row, and reset the count to 0 at each upright sample. Ten tilted "
                "samples are a fall.",
            )
    return why_calm_but_early(recording, at, moments)


def why_calm_but_early(recording: Recording, at: float, moments: Sequence[float]) -> Verdict:
    """Why "error" was said before the fall, and not after a jolt."""
    sent = [word.wall for word in see.published(recording, IMAGE.name)]
    what = run_of(recording).events
    if moments[what.leaning.first] <= at <= moments[what.leaning.end] + 0.25:
        return see.failed(
            "fall-reported.on-leaning",
            f'"{ERROR}" while the robot is tilted by {what.leaning.deg:g}°',
            FALL_EXPECTED,
            "The angle above which the robot counts as tilted is too small, or degrees and radians are mixed up.",
            f"A sample counts as tilted if its angle is more than {TILT_DEG:g}°.",
        )
    for begin, end in what.glare_s:
        if sent[round(begin * CAMERA_HZ)] <= at <= sent[round(end * CAMERA_HZ)] + 5 * MODEL_S:
            return see.failed(
                "fall-reported.on-glare",
                f'"{ERROR}" while the model raises exceptions',
                FALL_EXPECTED,
                "The model's exception changes the status, or your code handles it like a fall.",
                "Log the exception. Only a fall may change the status.",
            )
    return see.failed(
        "fall-reported.before",
        f'"{ERROR}" {moments[what.fall_sample] - at:.1f} s before the fall',
        FALL_EXPECTED,
        "Nothing had happened to the robot yet.",
        "Find the condition that sets the status, and log the tilt when it's met.",
    )


def counted_on(at: float, moments: Sequence[float], what: Events) -> Verdict | None:
    """Whether "error" came with a second jolt, soon after one of the same length that was no fall; None if not."""
    first, second = what.jolts[-2:]
    if not moments[second.first + 3] <= at <= moments[second.end] + 0.25:
        return None
    return see.failed(
        "fall-reported.counts-on",
        f'"{ERROR}" at the second of two {second.count}-sample jolts, with {second.first - first.end} upright '
        "samples between them",
        FALL_EXPECTED,
        "Your node didn't interpret the first jolt alone as a fall. So the upright samples reduce the count only "
        "partly, or your node counts tilted samples within a time window.",
        "Count the tilted samples in a row: reset the count to 0 at each upright sample. Ten tilted samples are a "
        "fall.",
    )


def why_taken_back(saw: str, at: float, moments: Sequence[float], what: Events) -> Verdict:
    """Why "operational" came again after the fall, at such a moment (s)."""
    upright = moments[min(what.fall.end, len(moments) - 1)]
    if 0.0 <= at - upright <= FOLLOWS_WITHIN_S:
        return see.failed(
            "fall-reported.taken-back",
            saw,
            FALL_EXPECTED,
            "The status follows the current tilt. But a robot that has fallen and was set upright again may be "
            "damaged.",
            "Store the fall in an attribute, and never reset it.",
        )
    how = (
        "while the robot was still on the floor"
        if at < upright
        else f"{at - upright:.1f} s after it was set upright"
    )
    return see.failed(
        "fall-reported.forgiven",
        f"{saw}, {how}",
        FALL_EXPECTED,
        "The fall is forgotten after a while: by a counter, a timer, or a time limit. But a robot that has fallen may "
        "be damaged, however long ago that was.",
        "Store the fall in an attribute, and never reset it.",
    )


def no_error(recording: Recording) -> Verdict:
    """Why "error" never came."""
    saw = f'the robot fell and lay at {FALLEN_DEG:g}°, but "{ERROR}" never arrived on {STATUS.name}'
    return see.program_ended(recording, saw, FALL_EXPECTED) or see.failed(
        "fall-reported.never",
        saw,
        FALL_EXPECTED,
        f"Your threshold angle is larger than {TILT_DEG:g}°. Or you check only one axis, but the robot fell forward "
        "and to the left at the same time. Or the /robot/imu callback doesn't run for all samples or doesn't "
        "change the status.",
        f"In the /robot/imu callback, count the samples for which tilt() returns more than {TILT_DEG:g}°.",
        about_time=True,
    )


def late_error(recording: Recording, saw: str) -> Verdict:
    """Why "error" came late."""
    if waits_for_the_model(recording):
        return see.failed(
            "fall-reported.waits-for-the-model",
            saw,
            FALL_EXPECTED,
            "The IMU samples wait for the model: one thread runs both, or both need the same lock.",
            "Call the model in its own thread, and don't hold a lock during the call. Then the /robot/imu callback "
            "runs right away.",
            about_time=True,
        )
    return see.failed(
        "fall-reported.late",
        saw,
        FALL_EXPECTED,
        "The samples wait in a queue, the node waits for more than ten of them, or it publishes the status rarely. "
        "Or it counts once per heartbeat, not per sample: ten heartbeats take a second, ten samples only 0.2 s.",
        f"Count in the /robot/imu callback: {TILTED_SAMPLES} tilted samples in a row are a fall. Publish the status "
        "ten times per second.",
        about_time=True,
    )
