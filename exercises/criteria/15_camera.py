"""How exercise 15 is judged: the judge is a camera that knows where the ball is, and compares the directions."""

import math
import random
import statistics
from collections import Counter
from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property, lru_cache, wraps
from typing import Any

from geometry_msgs.msg import Vector3Stamped
from sensor_msgs.msg import Image

import workbook.criteria as see
from workbook.criteria import (
    Box,
    CameraView,
    Recording,
    Scene,
    Verdict,
    criterion,
    program_runs,
    topic,
    watching,
)

IMAGE = topic("/camera/image", Image)
DIRECTION = topic("/robot/ball_direction", Vector3Stamped)

RATE_HZ = 30.0
FOCAL_PIXELS = 140.0
CENTER = (79.5, 59.5)  # column and row that look straight ahead
BALL_RADIUS_M = 0.04
WITHIN_DEG = 1.0
LENGTH_SLACK = 0.02
LEAST_SHARE = 0.8
TYPICALLY_S, AT_ONCE_S, SHARE_AT_ONCE = 0.1, 0.4, 0.9
NEAR_DEG = 2.5
"""A wrong direction that is so near to something else was probably taken from there."""
MOST = 0.6
"""Which share of what is wrong must look like a reason."""
PADDING = 32
LEAST_KNOWN = 0.2
"""Which share of some pictures must be answered to judge the directions. Ten answers a second are more than that."""
SOME = 0.05
"""Who finds fewer of the balls says (0, 0, 0) whatever there is."""
BRIGHT = 0.7
KNOWN, REFUSED = ("rgb8", "bgr8"), ("rgba8", "mono16", "8UC3")
NOISE = 2715
"""What the noise of the pictures is made from."""
PICTURES, REFUSED_PICTURES = 195, 12

NEAR, FAR, IN_FRONT = (1.02, 0.5, 0.0), (1.5, 0.5, 0.0), (0.7, -0.35, -0.4)
"""Where the brick lies (m: forward, left) and how it is turned (rad). It looks larger than the ball, or smaller, and
lies above the ball in the picture, or below it."""

ROLLS, ACROSS, NO_BALL = "rolls", "across", ""
"""What the ball does: it rolls near the middle, or from one edge of the picture to the other and nearer, or is not
there."""
ROLLING = 2.2
"""How fast the ball rolls back and forth (rad/s)."""


Vector = tuple[float, float, float]


@dataclass(frozen=True)
class Part:
    """Some pictures of one kind, one after the other.

    `encodings`: used by turns. `padding`: unused bytes behind each row. `ball`: what it does; `phase` (rad): where it
    rolls in the first of these pictures. `light`: in the first of them, and in the last one. `brick`: where it lies.
    """

    count: int
    encodings: Sequence[str]
    padding: int
    ball: str
    phase: float
    light: tuple[float, float]
    brick: tuple[float, float, float]


def parts(dice: random.Random) -> tuple[tuple[Part, ...], float]:
    """The parts of one run, in order, and from which side the ball comes when it rolls across (1: from the right).

    Before the first encoding that is refused come all kinds but padding: a node that dies of it has shown the rest.
    These encodings come more than a second apart, because a line in the log may be throttled. They come at no whole
    second: a stamp that has lost its nanoseconds would name them. Into dim light and into bgr8 the ball jumps.
    Otherwise it goes on near where it was, so that a search near the last ball finds it.
    """
    longer = dice.randint(-2, 2), dice.randint(-2, 2), dice.randint(-4, 0)
    refused, by_turns = dice.sample(REFUSED, len(REFUSED)), dice.sample(KNOWN, len(KNOWN))
    mirrored, back = dice.choice((0.0, math.pi)), dice.random() < 0.5
    bright, end = 20 + longer[0], mirrored + math.pi / 2 + dice.uniform(-0.9, 0.9)
    begin = end - ROLLING * (bright + 15) / RATE_HZ
    dim, bgr = (mirrored - math.pi / 2 + dice.uniform(0.3, most) for most in (0.9, 0.75))
    outward = dice.uniform(0.35, 1.2)
    padded = mirrored + (math.pi - outward if back else outward)
    some = [dice.uniform(0.0, 2 * math.pi) for _ in range(6)]
    found = (
        Part(bright, ("rgb8",), 0, ROLLS, begin, (1.1, 0.93), NEAR),
        Part(15, ("rgb8",), 0, ROLLS, begin + ROLLING * bright / RATE_HZ, (0.92, 0.8), IN_FRONT),
        Part(30 + longer[1], ("rgb8",), 0, ROLLS, dim, (0.6, 0.4), NEAR),
        Part(20 + longer[2], ("rgb8",), 0, NO_BALL, some[0], (0.4, 1.0), NEAR),
        Part(25 - sum(longer), ("bgr8",), 0, ROLLS, bgr, (1.0, 0.5), NEAR),
        Part(4, refused[:1], 0, ROLLS, some[1], (0.8, 0.8), NEAR),
        Part(31, by_turns, PADDING, ROLLS, padded, (0.9, 0.45), NEAR),
        Part(4, refused[1:2], PADDING, ROLLS, some[2], (0.9, 0.9), NEAR),
        Part(32, KNOWN, 0, ACROSS, some[3], (0.45, 1.1), FAR),
        Part(4, refused[2:], 0, ROLLS, some[4], (0.9, 0.9), FAR),
        Part(10, ("bgr8",), PADDING, NO_BALL, some[5], (1.0, 0.4), FAR),
    )
    return found, 1.0 if back and not mirrored else -1.0


def views(dice: random.Random) -> tuple[CameraView, ...]:
    """All pictures of one run, in order."""
    chosen, side = parts(dice)
    first_stamp_s, nearer, aside = (
        dice.randrange(300, 900),
        dice.uniform(-0.9, 0.1),
        dice.uniform(-0.04, 0.01),
    )
    made: list[CameraView] = []
    for part in chosen:
        turn = part.phase - ROLLING * len(made) / RATE_HZ
        forward, left, turned = part.brick
        brick = forward + dice.uniform(-0.02, 0.02), left, turned + dice.uniform(0.0, 0.6)
        for place in range(part.count):
            number = len(made)
            seconds, share_of_part = number / RATE_HZ, place / (part.count - 1)
            in_ns = round((first_stamp_s + seconds) * 1e9)
            swing, sway = math.sin(ROLLING * seconds + turn), math.cos(1.3 * seconds + nearer)
            made.append(
                CameraView(
                    scene(
                        swing,
                        sway,
                        part.light[0] + (part.light[1] - part.light[0]) * share_of_part,
                        where_to(part.ball, swing, sway, aside, side, place / part.count),
                        brick,
                    ),
                    (in_ns // 10**9, in_ns % 10**9),
                    NOISE,
                    number,
                    encoding=part.encodings[place % len(part.encodings)],
                    padding=part.padding,
                )
            )
    return tuple(made)


def where_to(
    ball: str, swing: float, sway: float, aside: float, side: float, part: float
) -> tuple[float, float] | None:
    """Where the ball lies at a moment (m: forward, left); None where none is. `part`: 0 to 1, from edge to edge."""
    if ball == ACROSS:
        return 0.66 + 0.24 * math.cos(2 * math.pi * part - 2.24), -0.27 * side * math.cos(math.pi * part)
    return (0.82 + 0.06 * sway, 0.1 + aside + 0.16 * swing) if ball else None


def scene(
    swing: float,
    sway: float,
    light: float,
    ball: tuple[float, float] | None,
    brick: tuple[float, float, float],
) -> Scene:
    """The desk at a moment: the balls roll, the hands move, and the brick lies next to them."""
    forward, left, turned = brick
    hands = (0.0, 0.0, 0.72, 0.72 + 0.15 * swing, 0.7, 0.7 - 0.15 * swing, *[0.0] * 6)
    return Scene(
        see.on_desk(*ball) if ball else None,
        see.on_desk(1.02 - 0.05 * swing, -0.32 - 0.05 * sway),
        (Box((forward, left - 0.03 * sway), turn=turned),),
        hands,
        light=light,
        warm=1.0 + 0.05 * sway,
    )


class Pictures:
    """The pictures of one run, and what is known of them. A picture is named by its place: 0 is the first one."""

    def __init__(self, views: Sequence[CameraView]) -> None:
        self.views = tuple(views)
        self.place_of = {view.stamp: place for place, view in enumerate(self.views)}
        self.readable = [place for place, view in enumerate(self.views) if view.encoding in KNOWN]
        self.others = [place for place, view in enumerate(self.views) if view.encoding not in KNOWN]
        self.with_ball = [place for place in self.readable if self.views[place].scene.ball is not None]
        self.without_ball = [place for place in self.readable if self.views[place].scene.ball is None]
        self.first_other = self.others[0]
        self.in_good_light = self.kind("rgb8", 0, True)
        self.in_dim_light = self.kind("rgb8", 0, False)
        self.in_bgr = self.kind("bgr8", 0, None)
        self.padded, self.padded_bgr = self.kind("rgb8", PADDING, None), self.kind("bgr8", PADDING, None)

    def kind(self, encoding: str, padding: int, bright: bool | None) -> list[int]:
        """The places of pictures with a ball, of this encoding and padding, in bright light, dim light, or any."""
        return [
            place
            for place in self.with_ball
            for view in [self.views[place]]
            if (view.encoding, view.padding) == (encoding, padding)
            and (bright is None or (view.scene.light >= BRIGHT) is bright)
        ]

    @cached_property
    def balls(self) -> Mapping[int, Vector]:
        """By place, in which direction the orange ball lies."""
        return {place: direction_of(self.views[place].scene.ball) for place in self.with_ball}

    @cached_property
    def blue_balls(self) -> Sequence[Vector]:
        """In which direction the blue ball of each picture lies."""
        return [direction_of(view.scene.blue_ball) for view in self.views]

    @cached_property
    def bricks(self) -> Sequence[Vector]:
        """In which direction the brick of each picture lies."""
        return [direction_of(see.on_desk(*view.scene.boxes[0].at)) for view in self.views]

    def light(self, place: int) -> float:
        """How bright it is: 1 is a bright day."""
        return self.views[place].scene.light

    def width(self, place: int) -> float:
        """How wide the ball is (pixels)."""
        ball = self.views[place].scene.ball
        assert ball is not None
        beside = ball[0], ball[1] + BALL_RADIUS_M, ball[2]
        return 2 * abs(see.seen_pixel(ball)[0] - see.seen_pixel(beside)[0])


def direction_of(place: tuple[float, float, float] | None) -> Vector:
    assert place is not None
    return see.seen_direction(place)


@lru_cache(maxsize=4)
def drawn(seed: int) -> Pictures:
    """The pictures of the run with this seed."""
    return Pictures(views(random.Random(seed)))


def shown_to(recording: Recording) -> Pictures:
    """The pictures that a program was shown. Raises ValueError where a recording does not tell: an old one."""
    if recording.seed is None:
        raise ValueError("this recording is older than images that are drawn for each run: judge it again")
    return drawn(recording.seed)


def script(dice: random.Random) -> list[see.Part]:
    """The pictures of one run, one after the other."""
    return [
        see.publish(
            IMAGE.name,
            Image,
            [
                (round(BEGIN_S + place / RATE_HZ, 4), see.camera_image(view))
                for place, view in enumerate(views(dice))
            ],
        )
    ]


BEGIN_S = 0.5
WATCH = watching(wall_seconds=BEGIN_S + PICTURES / RATE_HZ + 1.0, script=script)


@criterion(
    points=1,
    title="It subscribes to /camera/image (Image), and /robot/ball_direction carries Vector3Stamped",
    needs=[program_runs],
)
def topics(recording: Recording) -> Verdict:
    return see.all_of(see.listens(recording, IMAGE), see.publishes(recording, DIRECTION))


@criterion(points=0, title="It answers", needs=[topics])
def answers_come(recording: Recording) -> Verdict:
    if recording.topic(DIRECTION.name).arrivals:
        return see.passed("directions come")
    nothing = f"{PICTURES} images were sent to {IMAGE.name}, but nothing arrived on {DIRECTION.name}"
    return see.ended_or_error(recording, nothing, ONE_EACH) or see.failed(
        "answers-come.nothing",
        nothing,
        ONE_EACH,
        "No code spins the node, its callback doesn't publish, or the callback is still working on its first "
        "image.",
        "Spin the node with rclpy.spin(node), and publish inside the callback.",
        about_time=True,
    )


@criterion(
    points=1,
    title="Each direction has its image's stamp, and each image gets one direction",
    needs=[answers_come],
)
def stamps_kept(recording: Recording) -> Verdict:
    given = answers(recording)
    strange = [answer for answer in given if answer.place is None or only_whole_seconds(given)]
    if strange:
        return why_strange_stamps(strange, len(given))
    pictures = shown_to(recording)
    wrong = shifted(pictures, given) or why_repeated(pictures, given)
    if wrong is not None:
        return wrong
    return see.passed(f"{see.count(len(given), 'direction')}, each with the stamp of an image")


Judges = Callable[[Recording], Verdict]


def needs_pictures(judge: Judges) -> Judges:
    """Judge only where the stamps tell which picture each direction is for. Whether any picture was answered twice
    does not matter."""

    @wraps(judge)
    def judge_if_known(recording: Recording) -> Verdict:
        given = answers(recording)
        strange = any(answer.place is None for answer in given) or only_whole_seconds(given)
        if strange or shifted(shown_to(recording), given) is not None:
            return see.not_judged("the stamps do not tell which image each direction is for")
        return judge(recording)

    return judge_if_known


@criterion(points=1, title="It keeps up with 30 images a second", needs=[answers_come])
@needs_pictures
def keeps_up(recording: Recording) -> Verdict:
    pictures, said_at = shown_to(recording), [word.wall for word in see.published(recording, IMAGE.name)]
    by_place = first_answers(recording)
    waited = [by_place[place].wall - said_at[place] for place in by_place]
    answered = [place for place in pictures.readable if place in by_place]
    share, typical = len(answered) / len(pictures.readable), statistics.median(waited)
    late = sum(one > AT_ONCE_S for one in waited)
    saw = (
        f"{len(answered)} of {len(pictures.readable)} images were answered, typically {typical:.2f} s after they "
        f"were sent, {late} of them more than {AT_ONCE_S} s after"
    )
    if typical > TYPICALLY_S or late > (1.0 - SHARE_AT_ONCE) * len(waited):
        return why_late(saw, [by_place[place].wall - said_at[place] for place in sorted(by_place)])
    if share < LEAST_SHARE:
        return why_missing(recording, saw)
    return see.passed(saw)


@criterion(
    points=1,
    title="It refuses other encodings with a line in the log, and keeps running",
    needs=[answers_come],
)
def refuses_others(recording: Recording) -> Verdict:
    pictures = shown_to(recording)
    names = sorted({pictures.views[place].encoding for place in pictures.others})
    saw = f"{len(pictures.others)} images came as {see.listing(names)}"
    expected = "no direction for them, a line in the log with the name of the encoding, and a node that keeps running"
    silent = silent_since(recording, saw, expected)
    if silent is not None:
        return silent
    by_place = first_answers(recording)
    guessed = [place for place in pictures.others if place in by_place]
    if guessed and all(by_place[place].length < LENGTH_SLACK for place in guessed):
        return see.failed(
            "refuses-others.says-no-ball",
            f"{saw}, and {len(guessed)} of them were answered with (0, 0, 0): {came_as(pictures, guessed)}",
            expected,
            "The node reports \"no ball\" for an image that it couldn't decode. A subscriber can't tell that from a "
            "desk without a ball.",
            RETURN_EARLY,
        )
    if guessed:
        return see.failed(
            "refuses-others.guesses",
            f"{saw}, and {len(guessed)} of them were answered: {came_as(pictures, guessed)}",
            expected,
            "The node reads bytes of another encoding as if they were red, green, and blue.",
            RETURN_EARLY,
        )
    not_named = why_not_named(recording, names, saw, expected)
    if not_named is not None:
        return not_named
    return see.passed(f"{saw}: refused, and logged")


@criterion(
    points=2, title="In good light, an rgb8 image leads to the correct direction", needs=[answers_come]
)
@needs_pictures
def direction_right(recording: Recording) -> Verdict:
    return directions(recording, shown_to(recording).in_good_light)


@criterion(points=1, title="The direction is correct in changing light", needs=[direction_right])
def light_changes(recording: Recording) -> Verdict:
    return directions(recording, shown_to(recording).in_dim_light)


@criterion(points=1, title="The direction is correct for bgr8", needs=[answers_come])
@needs_pictures
def bgr_right(recording: Recording) -> Verdict:
    return directions(recording, shown_to(recording).in_bgr)


@criterion(points=1, title="The direction is correct for rows with padding", needs=[direction_right])
def padding_right(recording: Recording) -> Verdict:
    pictures = shown_to(recording)
    unpadded_are_right = directions(recording, pictures.in_dim_light).ok
    rgb = directions(recording, pictures.padded, PADDING_TAKEN_FOR_PIXELS if unpadded_are_right else None)
    if not directions(recording, pictures.in_bgr).ok:
        return rgb  # what is wrong with bgr8 alone, `bgr_right` judges
    bgr = directions(
        recording, pictures.padded_bgr, PADDING_OF_ONE_ENCODING if rgb.ok else PADDING_TAKEN_FOR_PIXELS
    )
    if bgr.ok and not rgb.ok and unpadded_are_right:
        rgb = directions(recording, pictures.padded, PADDING_OF_ONE_ENCODING)
    return see.all_of(rgb, bgr)


@criterion(points=1, title="It reports when there is no ball", needs=[answers_come])
@needs_pictures
def no_ball_said(recording: Recording) -> Verdict:
    pictures = shown_to(recording)
    known = known_answers(recording, pictures.without_ball)
    expected = "(0, 0, 0) for each image without an orange ball"
    if known is None:
        return why_silent(recording, expected)
    wrong = [(place, answer) for place, answer in known if not answer.length < 1e-6]
    if not wrong:
        balls = known_answers(recording, pictures.with_ball) or []
        if sum(answer.length > 0.5 for _, answer in balls) > SOME * len(balls):
            return see.passed(f"(0, 0, 0) for {len(known)} images without a ball")
        return see.failed(
            "no-ball-said.always",
            "(0, 0, 0) for nearly every image, with a ball or without",
            expected + ", and a direction for the others",
            "The vector is never filled in, or the ball is never found.",
            "Plot the mask of orange pixels for one image. Is the ball in it?",
        )
    place, answer = wrong[0]
    saw = (
        f"image {place + 1} shows no orange ball, but the answer is {shown(answer.vector)}. The answer is wrong "
        f"for {len(wrong)} of {see.count(len(known), 'such image')}"
    )
    reason = why_a_ball(pictures, wrong, first_answers(recording))
    return see.failed(reason.cause, saw, expected, reason.because, reason.try_this)


RETURN_EARLY = "At the beginning of the callback, log a line and return if you can't read the encoding."


def silent_since(recording: Recording, saw: str, expected: str) -> Verdict | None:
    """Why nothing came since the first picture in another encoding; None if something came."""
    by_place, first_other = first_answers(recording), shown_to(recording).first_other
    if any(place > first_other for place in by_place) or not any(place < first_other for place in by_place):
        return None
    saw = f"{saw}, and nothing came after the first of them"
    without_error = recording.process.ended_by == "itself" and see.last_error(recording) is None
    ended = see.program_ended(recording, saw, expected) if without_error else None
    return (
        ended
        or see.failed_by_error(recording, saw, expected)
        or see.failed(
            "refuses-others.silent-since",
            saw,
            expected,
            "The node exits, or stops publishing, when it receives an encoding that it can't read.",
            "Log a line and return from the callback. Your node may be able to read the next image.",
            about_time=True,
        )
    )


def came_as(pictures: Pictures, places: Iterable[int]) -> str:
    """The encodings of these pictures."""
    return see.listing(sorted({pictures.views[place].encoding for place in places}))


def why_not_named(recording: Recording, names: list[str], saw: str, expected: str) -> Verdict | None:
    """Why an encoding that was refused is not in the log; None if each is that the node has come to."""
    pictures, last = shown_to(recording), max(first_answers(recording), default=0)
    met = {pictures.views[place].encoding for place in pictures.others if place < last}
    met = met or {pictures.views[pictures.first_other].encoding}
    unnamed = [name for name in names if name in met and name not in recording.process.log]
    if not unnamed:
        return None
    if len(unnamed) < len(met):
        named = see.listing([name for name in names if name in met and name not in unnamed])
        return see.failed(
            "refuses-others.named-once",
            f"{saw}. The log names {named}, but not {unnamed[0]}",
            expected,
            "Your node logs only the first refused image, because of once=True, a flag, or a throttle of several "
            "seconds. Or one branch has no line that logs.",
            "Log a line for each encoding that you refuse, not only for the first one.",
        )
    return see.failed(
        "refuses-others.no-line",
        f"{saw}, and no line in the log names {unnamed[0]}",
        expected,
        "The node drops these images silently. A person who looks for the fault can't find out which encoding "
        "arrived.",
        'self.get_logger().error(f"... {image.encoding}"), with the encoding in the text.',
    )


# --- what came back -----------------------------------------------------------------------------------------

READABLE = PICTURES - REFUSED_PICTURES
ONE_EACH = f"one direction on {DIRECTION.name} for each of the {READABLE} readable images"
PICTURE_STAMPS = "the unchanged stamp of the image that it answers"


@dataclass(frozen=True)
class Answered:
    """One direction: the place of its picture by its stamp (None: of none), its stamp (s), and when it was sent (s)."""

    place: int | None
    stamp_s: float
    vector: Vector
    wall: float

    @property
    def length(self) -> float:
        return math.sqrt(sum(one * one for one in self.vector))


def answers(recording: Recording) -> list[Answered]:
    """What arrived on the topic of the directions, in order. A picture that was not sent has no place."""
    sent = len(see.published(recording, IMAGE.name))
    places = {stamp: place for stamp, place in shown_to(recording).place_of.items() if place < sent}
    found = []
    for arrival in recording.topic(DIRECTION.name).arrivals:
        if not isinstance(arrival.value, dict):
            continue
        stamp, vector = arrival.value["header"]["stamp"], arrival.value["vector"]
        found.append(
            Answered(
                places.get((stamp["sec"], stamp["nanosec"])),
                stamp["sec"] + stamp["nanosec"] / 1e9,
                (as_number(vector["x"]), as_number(vector["y"]), as_number(vector["z"])),
                arrival.published,
            )
        )
    return found


def as_number(value: Any) -> float:
    return float(value)


def first_answers(recording: Recording) -> dict[int, Answered]:
    """For each picture that was answered, by its place: its first direction."""
    found: dict[int, Answered] = {}
    for answer in answers(recording):
        if answer.place is not None:
            found.setdefault(answer.place, answer)
    return found


def known_answers(recording: Recording, places: Iterable[int]) -> list[tuple[int, Answered]] | None:
    """The answers to these pictures; None if too few of them were answered. `keeps_up` judges how many were."""
    asked, by_place = list(places), first_answers(recording)
    known = [(place, by_place[place]) for place in asked if place in by_place]
    return known if len(known) >= max(LEAST_KNOWN * len(asked), 3) else None


def off_deg(one: Vector, other: Vector) -> float:
    """The angle between two directions (°); infinite where one of them is none."""
    scale = math.sqrt(sum(a * a for a in one) * sum(b * b for b in other))
    dot = sum(a * b for a, b in zip(one, other, strict=True))
    if not (scale > 0.0 and math.isfinite(dot)):
        return math.inf
    cross = (
        one[1] * other[2] - one[2] * other[1],
        one[2] * other[0] - one[0] * other[2],
        one[0] * other[1] - one[1] * other[0],
    )
    return math.degrees(math.atan2(math.sqrt(sum(c * c for c in cross)), dot))


def shown(vector: Vector) -> str:
    return "(" + ", ".join(f"{one:.2f}" for one in vector) + ")"


# --- whether directions are right ---------------------------------------------------------------------------


def directions(recording: Recording, places: Iterable[int], suspected: "Reason | None" = None) -> Verdict:
    """Whether the directions for these pictures are those of the ball.

    `suspected` is the reason where most of them are wrong and the directions themselves do not tell why.
    """
    pictures, known = shown_to(recording), known_answers(recording, places)
    if known is None:
        return too_few("direction.too-few-answers", recording)
    wrong = [(place, answer) for place, answer in known if not is_right(pictures, place, answer)]
    if not wrong:
        worst = max(off_deg(answer.vector, pictures.balls[place]) for place, answer in known)
        return see.passed(f"{len(known)} directions, each within {max(worst, 0.05):.1f}°")
    place, answer = wrong[len(wrong) // 2]
    ball, view = pictures.balls[place], pictures.views[place]
    off = off_deg(answer.vector, ball)
    saw = (
        f"{len(wrong)} of {len(known)} directions are wrong. Image {place + 1} ({view.encoding}, light "
        f"{view.scene.light:.0%}): the ball is at {shown(ball)}, but the answer is {shown(answer.vector)}"
    )
    if math.isfinite(off):
        saw += f", {off:.1f}° away from it"
    reason = why_wrong(pictures, wrong, first_answers(recording))
    if reason.cause == "direction.blue-ball" and finds_orange(recording, view.encoding):
        reason = BLUE_TOO
    if suspected is not None and reason.cause in UNCLEAR and len(wrong) >= MOST * len(known):
        reason = suspected
    expected = f"a vector of length 1, within {WITHIN_DEG}° of the center of the orange ball"
    return see.failed(reason.cause, saw, expected, reason.because, reason.try_this)


def finds_orange(recording: Recording, encoding: str) -> bool:
    """Whether the orange ball is found in many pictures of this encoding: then red and blue are not exchanged."""
    pictures, by_place = shown_to(recording), first_answers(recording)
    of_it = [
        one for one in pictures.with_ball if pictures.views[one].encoding == encoding and one in by_place
    ]
    return share(is_right(pictures, place, by_place[place]) for place in of_it) >= LEAST_KNOWN


def is_right(pictures: Pictures, place: int, answer: Answered) -> bool:
    """Whether it is the direction of the ball, and of length 1."""
    off = off_deg(answer.vector, pictures.balls[place])
    return off <= WITHIN_DEG and abs(answer.length - 1.0) <= LENGTH_SLACK


Wrong = list[tuple[int, Answered]]
Fits = Callable[[Pictures, int, Answered], bool]
Pixels = tuple[float, float]
Pairs = list[tuple[int, Pixels, Pixels]]
"""For each picture, by its place: where the ball is seen, and where a direction says that it is."""


@dataclass(frozen=True)
class Reason:
    """Why directions are wrong, and whether one direction looks like it."""

    cause: str
    because: str
    try_this: str
    fits: Fits


UNCLEAR = ("direction.no-ball", "direction.too-dark", "direction.too-small", "direction.beside")
PADDING_TAKEN_FOR_PIXELS = Reason(
    "direction.padding-taken-for-pixels",
    "The ball is found where rows have no padding. Here your code interprets the padding at the end of each row "
    "as pixels, so later pixels end up in the wrong place.",
    "Reshape to (image.height, image.step) first, then keep the first 3 * image.width bytes of each row.",
    lambda pictures, place, answer: True,
)


PADDING_OF_ONE_ENCODING = Reason(
    "direction.padding-of-one-encoding",
    "Images in this encoding without padding lead to the ball, and so do images in the other encoding with "
    "padding. So the code for this encoding interprets the padding at the end of each row as pixels.",
    "Cut off the padding in one place, before you handle the encodings: keep the first 3 * image.width bytes of "
    "each row.",
    lambda pictures, place, answer: True,
)


def why_wrong(pictures: Pictures, wrong: Wrong, by_place: dict[int, Answered]) -> Reason:
    """The first reason that fits most of the directions that are wrong. `by_place`: all directions."""
    right = [
        (place, one)
        for place, one in by_place.items()
        if place in pictures.balls and is_right(pictures, place, one)
    ]
    reason = first_that_fits(
        pictures, [one for one in REASONS if not found_there(pictures, one, right)], wrong
    )
    if reason is None:
        return why_beside(pictures, wrong)
    return (
        (why_not_found(pictures, wrong, by_place) or reason)
        if reason.cause == "direction.no-ball"
        else reason
    )


def found_there(pictures: Pictures, reason: Reason, right: Wrong) -> bool:
    """Whether a ball was found where this reason says that none can be."""
    where = {
        "direction.largest-left-out": beside_a_smaller_brick,
        "direction.topmost-left-out": above_the_brick,
    }
    return any(where[reason.cause](pictures, place) for place, _ in right) if reason.cause in where else False


def why_not_found(pictures: Pictures, wrong: Wrong, by_place: dict[int, Answered]) -> Reason | None:
    """Why balls were not found, if brighter or larger ones in pictures of the same kind were; None if unknown."""
    view = pictures.views[wrong[0][0]]
    lost = [place for place, answer in wrong if answer.length < LENGTH_SLACK]
    found = [
        place
        for place in pictures.kind(view.encoding, view.padding, None)
        if place in by_place and is_right(pictures, place, by_place[place])
    ]
    if min(len(lost), len(found)) < 3:
        return None
    everywhere = [
        place
        for place in pictures.with_ball
        if place in by_place and is_right(pictures, place, by_place[place])
    ]
    for measure, reason in ((pictures.light, TOO_DARK), (pictures.width, TOO_SMALL)):
        smaller = sum(measure(one) < measure(other) for one in lost for other in found)
        middle = statistics.median(map(measure, lost))
        if smaller >= SURE * len(lost) * len(found) and min(map(measure, everywhere)) >= middle:
            return reason
    return None


def why_beside(pictures: Pictures, wrong: Wrong) -> Reason:
    """Why directions are near the ball, but not near enough."""
    pairs = [(place, seen_at(pictures.balls[place]), seen_at(answer.vector)) for place, answer in wrong]
    if len(pairs) < 4 or not all(map(math.isfinite, (one for _, _, at in pairs for one in at))):
        return BESIDE
    square = sum(x * x + y * y for _, (x, y), _ in pairs)
    factor = sum(x * a + y * b for _, (x, y), (a, b) in pairs) / square
    right = statistics.median(a - x for _, (x, _), (a, _) in pairs)
    down = statistics.median(b - y for _, (_, y), (_, b) in pairs)
    scaled = share(math.dist(at, (factor * ball[0], factor * ball[1])) <= 1.0 for _, ball, at in pairs)
    moved = share(math.dist(at, (ball[0] + right, ball[1] + down)) <= 1.0 for _, ball, at in pairs)
    if scaled >= SURE and scaled >= moved and 0.2 < factor < 5.0:
        return FOCAL_LENGTH
    if moved >= SURE:
        return MIDDLE
    edge = at_an_edge(pictures, pairs)
    if edge is not None:
        return edge
    across, along = factor_of(pairs, 0), factor_of(pairs, 1)
    if min(across, along) > 0.2 and max(across, along) < 5.0:
        if share(math.dist(at, (across * ball[0], along * ball[1])) <= 1.0 for _, ball, at in pairs) >= SURE:
            return ONE_AXIS
    if share(lags(pictures, place, at) for place, _, at in pairs) >= 0.8:
        return BEHIND
    return BESIDE


def factor_of(pairs: Pairs, axis: int) -> float:
    """By which factor directions are too far from the middle: to the side (axis 0), or up and down (axis 1)."""
    squares = sum(ball[axis] ** 2 for _, ball, _ in pairs)
    return sum(ball[axis] * at[axis] for _, ball, at in pairs) / max(squares, 1e-9)


def at_an_edge(pictures: Pictures, pairs: Pairs) -> Reason | None:
    """Whether they are at the same edge of the ball, however large it is; None if not."""
    for side, name in EDGES.items():
        beside = share(
            math.dist(at, (ball[0] + side[0] * radius, ball[1] + side[1] * radius)) <= 1.5
            for place, ball, at in pairs
            for radius in [pictures.width(place) / 2]
        )
        if beside >= SURE:
            return Reason(
                "direction.edge",
                f"All of these directions point to the {name} of the ball or of its bounding box, not to the "
                "ball's center.",
                "Use the mean position of the ball's pixels, or the center of the box.",
                always,
            )
    return None


def seen_at(vector: Vector) -> tuple[float, float]:
    """Where the pinhole model sees a direction: pixels to the right of the middle and below it."""
    x, y, z = vector
    return (FOCAL_PIXELS * x / z, FOCAL_PIXELS * y / z) if z > 0.0 else (math.nan, math.nan)


def lags(pictures: Pictures, place: int, at: tuple[float, float]) -> bool:
    """Whether a pixel is beside the ball toward where the ball was in the pictures before, and no farther than that."""
    ball = seen_at(pictures.balls[place])
    there = [
        seen_at(pictures.balls[one]) for one in range(max(place - 12, 0), place) if one in pictures.balls
    ]
    if not there:
        return False
    back = statistics.mean(x for x, _ in there) - ball[0], statistics.mean(y for _, y in there) - ball[1]
    off = at[0] - ball[0], at[1] - ball[1]
    along = off[0] * back[0] + off[1] * back[1]
    farthest = max(math.dist(ball, one) for one in there)
    return along > 0.9 * math.hypot(*off) * math.hypot(*back) and math.hypot(*off) <= farthest + 2.0


def share(fits: Iterable[bool]) -> float:
    """Which part of them is true."""
    known = list(fits)
    return sum(known) / len(known)


def first_that_fits(pictures: Pictures, reasons: Iterable[Reason], wrong: Wrong) -> Reason | None:
    for reason in reasons:
        if sum(reason.fits(pictures, place, answer) for place, answer in wrong) >= MOST * len(wrong):
            return reason
    return None


def flipped(x: float, y: float) -> Fits:
    """Whether a direction would be right with other signs."""

    def fits(pictures: Pictures, place: int, answer: Answered) -> bool:
        (a, b, c), ball = answer.vector, pictures.balls[place]
        return off_deg((x * a, y * b, c), ball) <= NEAR_DEG < off_deg(answer.vector, ball)

    return fits


def beside_a_smaller_brick(pictures: Pictures, place: int) -> bool:
    """Whether the ball is the largest orange thing."""
    return pictures.views[place].scene.boxes[0].at[0] > 0.5 * (NEAR[0] + FAR[0])


def above_the_brick(pictures: Pictures, place: int) -> bool:
    """Whether the ball is the topmost orange thing."""
    return pictures.views[place].scene.boxes[0].at[0] < 0.5 * (NEAR[0] + IN_FRONT[0])


def in_axes_of_the_robot(pictures: Pictures, place: int, answer: Answered) -> bool:
    """Whether x points forward, y to the left, z up."""
    a, b, c = answer.vector
    return off_deg((-b, -c, a), pictures.balls[place]) <= NEAR_DEG


def is_a_pixel(pictures: Pictures, place: int, answer: Answered) -> bool:
    """Whether the vector holds column and row of the ball in the place of a direction."""
    right, down = seen_at(pictures.balls[place])
    return math.dist(answer.vector[:2], (CENTER[0] + right, CENTER[1] + down)) < 8.0


def from_the_corner(pictures: Pictures, place: int, answer: Answered) -> bool:
    """Whether columns and rows are counted from the corner, not from the middle."""
    right, down = seen_at(pictures.balls[place])
    ray = (CENTER[0] + right, CENTER[1] + down, FOCAL_PIXELS)
    return off_deg(answer.vector, ray) <= NEAR_DEG


def of_an_earlier_picture(back: int) -> Fits:
    """Whether it is just where the ball was so many pictures before."""
    return lambda pictures, place, answer: (
        place - back in pictures.balls and off_deg(answer.vector, pictures.balls[place - back]) <= 0.4
    )


def by_the_row_alone(pictures: Pictures, place: int, answer: Answered) -> bool:
    """Whether the elevation is the arc tangent of the row, and the side that of the column."""
    x, y = (one / FOCAL_PIXELS for one in seen_at(pictures.balls[place]))
    yaw, pitch = math.atan(x), math.atan(y)
    lower = (math.sin(yaw) * math.cos(pitch), math.sin(pitch), math.cos(yaw) * math.cos(pitch))
    return off_deg(answer.vector, lower) <= 0.35


def in_a_squeezed_row(pictures: Pictures, place: int, answer: Answered) -> bool:
    """Whether it is where the ball is if the padding is taken for more columns, and these are squeezed to 160."""
    view = pictures.views[place]
    right, down = seen_at(pictures.balls[place])
    squeezed = view.width / ((3 * view.width + view.padding) // 3)
    column = (CENTER[0] + right + 0.5) * squeezed - 0.5
    return view.padding > 0 and math.dist(seen_at(answer.vector), (column - CENTER[0], down)) <= 1.0


SURE = 0.9
"""Which share of the pictures, or of pairs of them, must look like a reason that a single one does not show."""


def always(pictures: Pictures, place: int, answer: Answered) -> bool:
    return True


TOO_DARK = Reason(
    "direction.too-dark",
    "The ball wasn't found here, but it was found in brighter images of the same kind. A limit on brightness "
    "excludes it in dim light.",
    "Check the value (HSV) of the ball's pixels in such an image, and accept darker pixels. Keep your limits for "
    "hue and saturation.",
    always,
)
TOO_SMALL = Reason(
    "direction.too-small",
    "The ball wasn't found here, but it was found in images of the same kind where it's larger. Here, your code "
    "rejects it as too small.",
    "A ball may be 11 pixels wide: its radius is then 5.5 pixels, its area about 95. Accept that.",
    always,
)
FOCAL_LENGTH = Reason(
    "direction.focal-length",
    "All of these directions are too far from the center, or too close to it, by the same factor. Your code found "
    "the ball, but it computed the direction with a different focal length than the task's.",
    "The focal length is 140 pixels: x = (column - 79.5) / 140, y = (row - 59.5) / 140.",
    always,
)
MIDDLE = Reason(
    "direction.middle",
    "All of these directions miss the ball by the same number of pixels, to the same side. Your code subtracts a "
    "different image center than the task's, or it uses a corner of the ball instead of its center.",
    "Straight ahead is column 79.5, row 59.5. Subtract these from the ball's center.",
    always,
)
ONE_AXIS = Reason(
    "direction.one-axis",
    "All of these directions are too far from the center, or too close to it, and vertically by a different "
    "factor than horizontally. Your code found the ball, but it computes the two axes in different ways.",
    "Both axes have the focal length of 140 pixels: x = (column - 79.5) / 140, y = (row - 59.5) / 140.",
    always,
)
EDGES = {
    (-1, 0): "left edge",
    (1, 0): "right edge",
    (0, -1): "upper edge",
    (0, 1): "lower edge",
    (-1, -1): "upper left corner",
    (1, -1): "upper right corner",
    (-1, 1): "lower left corner",
    (1, 1): "lower right corner",
}
"""Where a part of the outline lies, seen from the middle of the ball: to the right, and down."""
BEHIND = Reason(
    "direction.behind",
    "The directions point to where the ball was in earlier images. Your code averages them over several images, "
    "or it limits how fast they change.",
    "Compute each direction from its own image only.",
    always,
)
BESIDE = Reason(
    "direction.beside",
    "Your code found something other than the ball, found only a part of it, or is off by a few pixels. Or it "
    "doesn't use the pinhole model to turn the pixel into a direction.",
    "Plot the mask of orange pixels for one such image, and mark the pixel that you found.",
    always,
)

REASONS = (
    Reason(
        "direction.no-number",
        "NaN or infinity: something was divided by zero, such as the sum of an empty mask.",
        "First check whether there is a ball, because a vector of length 0 has no direction.",
        lambda pictures, place, answer: not all(map(math.isfinite, answer.vector)),
    ),
    Reason(
        "direction.largest-left-out",
        "Your code didn't find the ball in images where it's the largest orange object. In these images, the "
        "brick is farther away and looks smaller.",
        "Don't choose by size. Check all orange outlines, and keep the round one.",
        lambda pictures, place, answer: (
            answer.length < LENGTH_SLACK and beside_a_smaller_brick(pictures, place)
        ),
    ),
    Reason(
        "direction.topmost-left-out",
        "Your code didn't find the ball in images where it's the topmost orange object. In these images, the "
        "brick is closer, so it's lower in the image.",
        "Don't choose by position or order. Check all orange outlines, and keep the round one.",
        lambda pictures, place, answer: answer.length < LENGTH_SLACK and above_the_brick(pictures, place),
    ),
    Reason(
        "direction.no-ball",
        "The ball wasn't found. Your color range may not fit this light, or your code reads rows or colors in the "
        "wrong order. Or it rejects the ball as too small or not round, or searches only a part of the image.",
        "Check the ball's pixels in such an image, in the color space that you use. Which limits exclude them?",
        lambda pictures, place, answer: answer.length < LENGTH_SLACK,
    ),
    Reason(
        "direction.not-of-length-one",
        "The direction is correct, but the vector's length isn't 1.",
        "Divide the vector by its length: ray / np.linalg.norm(ray).",
        lambda pictures, place, answer: off_deg(answer.vector, pictures.balls[place]) <= WITHIN_DEG,
    ),
    Reason(
        "direction.a-pixel",
        "The vector holds the column and the row of the ball. That's a position in the image, not a direction.",
        "Pinhole model: x = (column - 79.5) / 140, y = (row - 59.5) / 140, z = 1, and then divide by the length.",
        is_a_pixel,
    ),
    Reason(
        "direction.blue-ball",
        "The direction points to the blue ball. Red and blue are swapped, because your code reads the image in "
        "the wrong color order.",
        "Check image.encoding for each image: rgb8 begins with red, bgr8 with blue. OpenCV's own functions expect "
        "BGR.",
        lambda pictures, place, answer: off_deg(answer.vector, pictures.blue_balls[place]) <= NEAR_DEG,
    ),
    Reason(
        "direction.brick",
        "The direction points to the brick. It has the ball's color, but its outline isn't round.",
        "Keep only round outlines: compare an outline's area with the area of the smallest circle around it.",
        lambda pictures, place, answer: off_deg(answer.vector, pictures.bricks[place]) <= NEAR_DEG,
    ),
    Reason(
        "direction.x-to-the-left",
        "Left and right are swapped.",
        "x points to the right, as columns do: x = (column - 79.5) / 140.",
        flipped(-1.0, 1.0),
    ),
    Reason(
        "direction.y-up",
        "Up and down are swapped.",
        "y points down, as rows do: y = (row - 59.5) / 140.",
        flipped(1.0, -1.0),
    ),
    Reason(
        "direction.axes-of-the-robot",
        "The vector is correct in a robot's axes: x forward, y to the left, z up. The task asks for the camera's "
        "axes.",
        "Publish x to the right, y down, z forward.",
        in_axes_of_the_robot,
    ),
    Reason(
        "direction.from-the-corner",
        "Your code counts column and row from the image's corner, but straight ahead is its center.",
        "Subtract the middle first: x = (column - 79.5) / 140, y = (row - 59.5) / 140.",
        from_the_corner,
    ),
    Reason(
        "direction.elevation",
        "The angle up or down was computed from the row alone: atan(y). That's correct in the middle column only. "
        "Elsewhere, the ball is farther away than its z.",
        "Divide (x, y, 1) by its length. If you need the elevation: atan2(y, hypot(x, 1)).",
        by_the_row_alone,
    ),
    Reason(
        "direction.squeezed",
        "Your code interprets the padding at the end of each row as more columns, and squeezes them to 160. So it "
        "finds the ball too far to the left.",
        "Keep the first 3 * image.width bytes of each row, and don't change the image's size.",
        in_a_squeezed_row,
    ),
    *(
        Reason(
            "direction.earlier-picture",
            "The direction belongs to an earlier image: the ball was there a moment before.",
            "Compute the direction from the image that the callback receives, and publish it with that image's "
            "header.",
            of_an_earlier_picture(back),
        )
        for back in (1, 2, 3)
    ),
)


BLUE_TOO = Reason(
    "direction.blue-too",
    "Your code finds the orange ball in other images of this encoding, so red and blue aren't swapped. In these "
    "images, it chose the blue ball.",
    "Keep only orange pixels before you look for round shapes, and check the mask: the blue ball must not be in it.",
    lambda pictures, place, answer: off_deg(answer.vector, pictures.blue_balls[place]) <= NEAR_DEG,
)


def why_silent(recording: Recording, expected: str) -> Verdict:
    """Why most pictures without a ball were not answered."""
    by_place, without_ball = first_answers(recording), shown_to(recording).without_ball
    if any(place in by_place for place in without_ball) or max(by_place, default=0) < without_ball[10]:
        return too_few("no-ball-said.too-few-answers", recording)
    return see.failed(
        "no-ball-said.silent",
        "other images were answered, but none of those without a ball",
        expected,
        'The node publishes nothing when it finds no ball. So a subscriber can\'t distinguish "no ball" from "no '
        'camera".',
        "Publish (0, 0, 0) with the image's header. A new Vector3Stamped already contains these zeros.",
    )


def why_a_ball(pictures: Pictures, wrong: Wrong, by_place: dict[int, Answered]) -> Reason:
    """Why a ball was said to be where none is."""
    before = [place for place in by_place if place < pictures.without_ball[0] and place in pictures.balls]
    several = {answer.vector for _, answer in wrong}
    if before and by_place[max(before)].vector in several and len(several) <= 4:
        return REPEATED
    if not all(math.isfinite(one) for vector in several for one in vector):
        return NO_NUMBER
    return CONSTANT if len(several) == 1 else first_that_fits(pictures, GHOSTS, wrong) or SOMETHING_ELSE


NEW_MESSAGE = "Publish (0, 0, 0): a new Vector3Stamped with this image's header."
REPEATED = Reason(
    "no-ball-said.repeated",
    "When your node finds no ball, it publishes the last direction again. But by then, the ball may be anywhere.",
    NEW_MESSAGE,
    always,
)
NO_NUMBER = Reason(
    "no-ball-said.no-number",
    "NaN or infinity instead of (0, 0, 0): your code divides by zero.",
    "First check whether there is a ball. If not, leave the vector at (0, 0, 0).",
    always,
)
CONSTANT = Reason(
    "no-ball-said.constant",
    "The same direction is published for every image without a ball.",
    NEW_MESSAGE,
    always,
)
SOMETHING_ELSE = Reason(
    "no-ball-said.something-else",
    "Your code mistook something else for the ball: the image's biggest or brightest object, a hand, or noise.",
    "Check color, size, and outline, and publish (0, 0, 0) if nothing fits.",
    always,
)
GHOSTS = (
    Reason(
        "no-ball-said.brick",
        "Your code mistook the brick for the ball. It has the ball's color, but its outline isn't round.",
        "Keep only round outlines: compare an outline's area with the area of the smallest circle around it.",
        lambda pictures, place, answer: off_deg(answer.vector, pictures.bricks[place]) <= NEAR_DEG,
    ),
    Reason(
        "no-ball-said.blue-ball",
        "Your code mistook the blue ball for the orange one.",
        "Check the color order in image.encoding, and keep only orange pixels.",
        lambda pictures, place, answer: off_deg(answer.vector, pictures.blue_balls[place]) <= NEAR_DEG,
    ),
)


# --- why stamps and times are not as they should be ---------------------------------------------------------


def only_whole_seconds(given: list[Answered]) -> bool:
    """Whether the stamps are those of pictures without their nanoseconds. Some pictures are taken at a whole second."""
    return len(given) > 10 and all(answer.stamp_s == int(answer.stamp_s) for answer in given)


def why_strange_stamps(strange: list[Answered], given: int) -> Verdict:
    """Why stamps are not those of pictures."""
    saw = f"{len(strange)} of {see.count(given, 'direction')} with a stamp that no image had, the first {{}}"
    if all(answer.stamp_s == 0.0 for answer in strange):
        return see.failed(
            "stamps-kept.no-stamp",
            saw.format("0 s"),
            PICTURE_STAMPS,
            "Your code publishes a new message without filling in its header.",
            "Copy the header: answer.header = image.header.",
        )
    if only_whole_seconds(strange):
        return see.failed(
            "stamps-kept.whole-seconds",
            f"the stamps of all {see.count(given, 'direction')} are whole seconds, such as {strange[0].stamp_s:.0f} s",
            PICTURE_STAMPS,
            "Your code copies the field sec, but not nanosec.",
            "Copy the whole header: answer.header = image.header.",
        )
    return see.failed(
        "stamps-kept.own-stamp",
        saw.format(f"{strange[0].stamp_s:.2f} s"),
        PICTURE_STAMPS,
        "The node stamps its directions with its own clock, or loses a part of the stamp. But the stamp must tell "
        "when the image was taken, not when the node processed it.",
        "Copy the whole header: answer.header = image.header.",
    )


def why_repeated(pictures: Pictures, given: list[Answered]) -> Verdict | None:
    """Why pictures were answered more than once; None if none was."""
    times = Counter(answer.place for answer in given)
    place, most = times.most_common(1)[0]
    if most < 2 or place is None:
        return None
    saw = f"{most} directions with the stamp of image {place + 1}"
    several = [one for one, number in times.items() if number > 1]
    if set(several) <= set(pictures.without_ball) and len(several) > 3:
        return see.failed(
            "stamps-kept.no-ball-repeated",
            f"{saw}. It shows no orange ball. Each image with one has a single direction",
            ONE_EACH,
            "If there's no ball, two lines publish. One publishes (0, 0, 0), and then the callback continues to "
            "the line that publishes every direction.",
            "Return after the first one, or let a single line publish, with a ball or without.",
        )
    return see.failed(
        "stamps-kept.repeated",
        saw,
        ONE_EACH,
        "Your node answers one image several times: in a timer, in a loop over all orange blobs, or through two "
        "subscriptions.",
        "Publish once for each call of the callback.",
    )


def shifted(pictures: Pictures, given: list[Answered]) -> Verdict | None:
    """Whether stamps and directions belong to different pictures; None if not."""
    pairs = [(answer.place, answer) for answer in given if answer.place in pictures.in_good_light]
    moving = [
        (place, answer)
        for place, answer in pairs
        if place and {place - 1, place + 1} <= pictures.balls.keys()
    ]
    if len(moving) < 10:
        return None

    def apart(later: int) -> float:
        return statistics.median(
            off_deg(answer.vector, pictures.balls[place + later]) for place, answer in moving
        )

    here, before, after = apart(0), apart(-1), apart(1)
    if here <= 0.3 or min(before, after) > min(0.5 * here, 0.3):
        return None
    saw = f"the directions are typically {here:.1f}° away from the ball, but only {{:.1f}}° away from where the ball "
    if before < after:
        return see.failed(
            "stamps-kept.one-behind",
            saw.format(before) + "was one image earlier",
            PICTURE_STAMPS,
            "A direction gets the next image's stamp. Your code stores the previous image and answers that one, "
            "or it puts a new header on an old result.",
            "Use the pixels and the header of the same message.",
        )
    return see.failed(
        "stamps-kept.one-ahead",
        saw.format(after) + "is one image later",
        PICTURE_STAMPS,
        "A direction gets the previous image's stamp. Your code stores the header in an attribute, but uses it "
        "before storing the new one.",
        "Use the pixels and the header of the same message: Vector3Stamped(header=image.header).",
    )


def why_late(saw: str, waited: list[float]) -> Verdict:
    """Why answers come late. `waited` (s) in the order of the pictures."""
    expected = (
        f"at least {LEAST_SHARE:.0%} of the images, typically within {TYPICALLY_S} s, and {SHARE_AT_ONCE:.0%} of "
        f"these within {AT_ONCE_S} s"
    )
    tenth = max(len(waited) // 10, 1)
    first, last = statistics.median(waited[:tenth]), statistics.median(waited[-tenth:])
    if last > first + 0.5:
        return see.failed(
            "keeps-up.queue-grows",
            f"{saw}. The first waited {first:.2f} s, the last {last:.2f} s",
            expected,
            "Processing an image takes longer than 1/30 s, and old images wait in the queue. So the node falls "
            "further and further behind.",
            "Use OpenCV or NumPy functions that work on the whole image, not loops over pixels. And keep the "
            "queue short: qos_profile_sensor_data has a depth of 5.",
            about_time=True,
        )
    return see.failed(
        "keeps-up.late",
        saw,
        expected,
        "Images wait in a queue or for a timer, or the callback sleeps or computes for a long time.",
        "Process each image in its callback, publish right away, and keep the queue short.",
        about_time=True,
    )


def why_missing(recording: Recording, saw: str) -> Verdict:
    """Why too many pictures were not answered."""
    expected = f"at least {LEAST_SHARE:.0%} of the images"
    error = see.last_error(recording)
    if error is not None:
        return see.failed(
            error.cause, f"{saw}. {error.where}{error.error}", expected, error.because, error.try_this
        )
    ended = see.program_ended(recording, saw, expected)
    if ended is not None and max(shown_to(recording).readable) not in first_answers(recording):
        return ended
    pattern = why_not_answered(shown_to(recording), first_answers(recording), saw, expected)
    if pattern is not None:
        return pattern
    return see.failed(
        "keeps-up.missing",
        saw,
        expected,
        "The node was busy while images arrived, answers only some of them, or stopped.",
        "Publish in every call of the callback, and keep it short: use OpenCV or NumPy functions, not loops over "
        "pixels.",
        about_time=True,
    )


def why_not_answered(
    pictures: Pictures, by_place: dict[int, Answered], saw: str, expected: str
) -> Verdict | None:
    """What the pictures that were not answered have in common; None if nothing."""
    last, first_other = max(by_place), pictures.first_other
    if last < first_other and not set(pictures.readable) & set(range(first_other)) - set(by_place):
        return see.failed(
            "keeps-up.silent-since",
            f"{saw}. Nothing arrived after image {first_other + 1}, the first one in another encoding: "
            f"{pictures.views[first_other].encoding}",
            expected,
            "After the node received an encoding that it can't read, it stopped answering.",
            "Return from the callback for that image only. Your node may be able to read the next one.",
        )
    for encoding in KNOWN:
        of_it = [place for place in pictures.readable if pictures.views[place].encoding == encoding]
        others = [place for place in pictures.readable if pictures.views[place].encoding != encoding]
        if not set(of_it) & set(by_place) and share(place in by_place for place in others) >= SURE:
            return see.failed(
                "keeps-up.one-encoding",
                f"{saw}. Not one of the {len(of_it)} images in {encoding} was answered",
                expected,
                f"The node answers only images in the other encoding, and treats {encoding} as one that it can't "
                "read.",
                f"Both rgb8 and bgr8 can be read: convert {encoding}, too, and answer it.",
            )
    return None


def too_few(cause: str, recording: Recording) -> Verdict:
    """Nothing can be said, because most answers are missing."""
    saw = f"fewer than {LEAST_KNOWN:.0%} of the images that count for this criterion were answered"
    return see.program_ended(recording, saw, "an answer to each") or see.failed(
        cause,
        saw,
        "an answer to each",
        "Without answers, the tracker cannot be judged.",
        "First make sure that every image is answered.",
        about_time=True,
    )
