"""Judge exercise 15: the judge publishes the camera's images and compares the program's directions with the ball's."""

import cmath
import math
import random
from collections import Counter
from collections.abc import Callable, Iterable, Sequence
from functools import lru_cache, partial
from itertools import product
from statistics import median
from typing import NamedTuple

from geometry_msgs.msg import Vector3Stamped
from sensor_msgs.msg import Image

import workbook.criteria as see
from workbook.criteria import CameraView, Recording, Verdict, criterion, program_runs, topic, watching

WORDS = see.Words(__file__)
IMAGE = topic("/camera/image", Image)
DIRECTION = topic("/robot/ball_direction", Vector3Stamped)

RATE_HZ, BEGIN_S, PICTURES = 30.0, 0.5, 195
FOCAL_PIXELS = 140.0
CENTER = complex(79.5, 59.5)  # the column and row of the direction straight ahead
BALL_RADIUS_M = 0.04
WITHIN_DEG, LENGTH_SLACK, LEAST_SHARE = 1.0, 0.02, 0.8
TYPICALLY_S, AT_ONCE_S, SHARE_AT_ONCE = 0.1, 0.4, 0.9
NEAR_DEG = 2.5  # a wrong direction this close to another object probably points to that object
MOST = 0.6  # the fraction of the wrong directions that must fit a cause
SURE = 0.9  # as MOST, for a cause that a single direction can't show
LEAST_KNOWN = 0.2  # of some images, for judging their directions; ten answers a second are more
SOME = 0.05  # of the balls: a program that finds fewer publishes (0, 0, 0) for every image
BRIGHT, PADDING = 0.7, 32  # good light; unused bytes after each row
KNOWN, REFUSED = ("rgb8", "bgr8"), ("rgba8", "mono16", "8UC3")
NOISE = 2715  # the seed of the images' noise

# The brick's position (m: forward, left) and its turn (rad). In the image, the brick is larger or smaller than the
# ball, and above or below the ball.
NEAR, FAR, IN_FRONT = (1.02, 0.5, 0.0), (1.5, 0.5, 0.0), (0.7, -0.35, -0.4)
# The ball rolls near the middle, crosses the image and comes nearer, or isn't there.
ROLLS, ACROSS, NO_BALL = "rolls", "across", ""
ROLLING = 2.2  # the angular frequency (rad/s) with which the ball rolls back and forth


Part = tuple[int, Sequence[str], int, str, float, tuple[float, float], tuple[float, float, float]]
"""Some images of one kind: their number, the encodings in turn, each row's padding (bytes), and the ball's motion.

The remaining items are the phase of that motion in the first image (rad), the light in the first and the last image,
and the brick.
"""


def parts(dice: random.Random) -> tuple[list[Part], float]:
    """Draw the parts of one run, in order, and the side from which the ball rolls across (1: from the right).

    All kinds of images except those with padding come before the first encoding to refuse, so that a node that crashes
    there has answered the other kinds. Encodings to refuse come more than a second apart, because the node may throttle
    its log lines. They don't come at a whole second, because even a stamp without its nanoseconds would identify such
    an image. The ball jumps when dim light or bgr8 begins. Otherwise, the ball continues near its last position, so
    that a search near that position finds it.
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
    found: list[Part] = [
        (bright, ("rgb8",), 0, ROLLS, begin, (1.1, 0.93), NEAR),
        (15, ("rgb8",), 0, ROLLS, begin + ROLLING * bright / RATE_HZ, (0.92, 0.8), IN_FRONT),
        (30 + longer[1], ("rgb8",), 0, ROLLS, dim, (0.6, 0.4), NEAR),
        (20 + longer[2], ("rgb8",), 0, NO_BALL, some[0], (0.4, 1.0), NEAR),
        (25 - sum(longer), ("bgr8",), 0, ROLLS, bgr, (1.0, 0.5), NEAR),
        (4, refused[:1], 0, ROLLS, some[1], (0.8, 0.8), NEAR),
        (31, by_turns, PADDING, ROLLS, padded, (0.9, 0.45), NEAR),
        (4, refused[1:2], PADDING, ROLLS, some[2], (0.9, 0.9), NEAR),
        (32, KNOWN, 0, ACROSS, some[3], (0.45, 1.1), FAR),
        (4, refused[2:], 0, ROLLS, some[4], (0.9, 0.9), FAR),
        (10, ("bgr8",), PADDING, NO_BALL, some[5], (1.0, 0.4), FAR),
    ]
    return found, 1.0 if back and not mirrored else -1.0


def views(dice: random.Random) -> list[CameraView]:
    """Draw all images of one run. The balls roll, the hands move, and the brick next to them shifts a little."""
    chosen, side = parts(dice)
    first_s, nearer, aside = dice.randrange(300, 900), dice.uniform(-0.9, 0.1), dice.uniform(-0.04, 0.01)
    made: list[CameraView] = []
    for count, encodings, padding, what, phase, (first_light, last_light), (forward, left, turned) in chosen:
        turn = phase - ROLLING * len(made) / RATE_HZ
        forward, turned = forward + dice.uniform(-0.02, 0.02), turned + dice.uniform(0.0, 0.6)
        for place in range(count):
            seconds = len(made) / RATE_HZ
            swing, sway = math.sin(ROLLING * seconds + turn), math.cos(1.3 * seconds + nearer)
            ball = 0.82 + 0.06 * sway, 0.1 + aside + 0.16 * swing
            if what == ACROSS:
                half_turn = math.pi * (place / count)
                ball = 0.66 + 0.24 * math.cos(2 * half_turn - 2.24), -0.27 * side * math.cos(half_turn)
            scene = see.Scene(
                see.on_desk(*ball) if what else None,
                see.on_desk(1.02 - 0.05 * swing, -0.32 - 0.05 * sway),
                (see.Box((forward, left - 0.03 * sway), turn=turned),),
                joints=(0.0, 0.0, 0.72, 0.72 + 0.15 * swing, 0.7, 0.7 - 0.15 * swing, *[0.0] * 6),
                light=first_light + (last_light - first_light) * (place / (count - 1)),
                warm=1.0 + 0.05 * sway,
            )
            stamp = see.Stamp.at(first_s + seconds)
            encoding = encodings[place % len(encodings)]
            made.append(CameraView(scene, stamp, NOISE, len(made), encoding=encoding, padding=padding))
    return made


def script(dice: random.Random) -> list[see.Part]:
    """Return the script, which publishes the images of one run one after the other."""
    images = [(round(BEGIN_S + n / RATE_HZ, 4), see.camera_image(view)) for n, view in enumerate(views(dice))]
    return [see.publish(IMAGE.name, Image, images)]


WATCH = watching(wall_seconds=BEGIN_S + PICTURES / RATE_HZ + 1.0, script=script)


class Vector(NamedTuple):
    """A direction: x to the right, y down, z forward."""

    x: float
    y: float
    z: float

    def __str__(self) -> str:
        return f"({self.x:.2f}, {self.y:.2f}, {self.z:.2f})"

    @property
    def length(self) -> float:
        return math.sqrt(sum(one * one for one in self))

    @property
    def pixel(self) -> complex:
        """The pixel of this direction in the pinhole model: right of (real) and below (imaginary) the image's center.

        The pixel is NaN for a direction that doesn't point forward.
        """
        x, y, z = self
        return complex(FOCAL_PIXELS * x / z, FOCAL_PIXELS * y / z) if z > 0.0 else complex(math.nan, math.nan)

    def off_deg(self, other: "Vector") -> float:
        """Return the angle (°) to another direction, or infinity if one of the two isn't a direction."""
        (a, b, c), (x, y, z) = self, other
        dot, cross = a * x + b * y + c * z, (b * z - c * y, c * x - a * z, a * y - b * x)
        known = math.isfinite(dot) and self.length > 0.0 and other.length > 0.0
        return math.degrees(math.atan2(math.hypot(*cross), dot)) if known else math.inf


NOWHERE = Vector(0.0, 0.0, 0.0)


def apart(one: complex, other: complex) -> float:
    """Return the distance between two pixels. Unlike `abs`, it doesn't raise an exception for huge numbers."""
    return math.hypot((one - other).real, (one - other).imag)


def share(fits: Iterable[bool]) -> float:
    """Return the fraction of true values, or 0 if there are no values."""
    known = list(fits)
    return sum(known) / max(len(known), 1)


class Images:
    """The images of one run. Each image is identified by its place, from 0."""

    def __init__(self, views: Sequence[CameraView]) -> None:
        self.views, scenes = views, [view.scene for view in views]
        self.kinds = [(view.encoding, view.padding) for view in views]
        self.readable = [place for place, (encoding, _) in enumerate(self.kinds) if encoding in KNOWN]
        self.others = [place for place, (encoding, _) in enumerate(self.kinds) if encoding not in KNOWN]
        self.places = {view.stamp: place for place, view in enumerate(views)}
        self.first_other = self.others[0]
        self.first_refused = (self.first_other + 1, views[self.first_other].encoding)
        balls = {place: ball for place in self.readable if (ball := scenes[place].ball)}
        self.balls = {place: Vector(*see.seen_direction(ball)) for place, ball in balls.items()}
        self.blue_balls = [Vector(*see.seen_direction(one.blue_ball)) for one in scenes if one.blue_ball]
        self.bricks = [Vector(*see.seen_direction(see.on_desk(*one.boxes[0].at))) for one in scenes]
        depths = {place: self.balls[place].z * math.hypot(*ball) for place, ball in balls.items()}  # m
        self.widths = {place: FOCAL_PIXELS * 2 * BALL_RADIUS_M / depth for place, depth in depths.items()}
        self.with_ball = list(balls)
        self.without_ball = [place for place in self.readable if place not in balls]
        plain, self.in_bgr, self.padded, self.padded_bgr = (
            [place for place in balls if self.kinds[place] == (encoding, padding)]
            for padding in (0, PADDING)
            for encoding in KNOWN
        )
        self.in_good_light = [place for place in plain if scenes[place].light >= BRIGHT]
        self.in_dim_light = [place for place in plain if scenes[place].light < BRIGHT]
        self.moving = {one for one in self.in_good_light if {one - 1, one + 1} <= balls.keys()}


@lru_cache(maxsize=4)
def drawn(seed: int) -> Images:
    """Return the images of the run with this seed."""
    return Images(views(random.Random(seed)))


class Direction:
    """One published direction, and the image with the same stamp. `sent_at`: the times at which images were sent."""

    def __init__(self, images: Images, sent_at: Sequence[float], message: see.Arrival) -> None:
        stamp, vector = see.Stamp.of(message.value), message.value["vector"]
        place = images.places.get(stamp, -1)
        place = place if place < len(sent_at) else -1  # -1: no sent image has this stamp
        self.images, self.place, self.number = images, place, place + 1
        self.waited = message.published - sent_at[place] if place >= 0 else math.nan  # s
        self.stamp_s = stamp.seconds
        self.vector = vector = Vector(*(float(vector[axis]) for axis in "xyz"))
        self.encoding, self.padding = self.kind = images.kinds[place]
        scene = images.views[place].scene
        self.light, self.brick_m = scene.light, scene.boxes[0].at[0]  # the brick's distance forward
        self.ball, self.width = images.balls.get(place, NOWHERE), images.widths.get(place, 0.0)
        self.off, self.length = vector.off_deg(self.ball), vector.length
        self.away = f", {self.off:.2f}° away from it" if math.isfinite(self.off) else ""
        from_corner = CENTER + self.ball.pixel
        self.ball_from_the_corner = Vector(from_corner.real, from_corner.imag, FOCAL_PIXELS)
        self.is_zero, self.is_finite = self.length < LENGTH_SLACK, all(map(math.isfinite, vector))
        found = self.off <= WITHIN_DEG and abs(self.length - 1.0) <= LENGTH_SLACK
        self.is_right = self.length < 1e-6 if self.ball is NOWHERE else found

    def is_from_before(self, images: int) -> bool:
        """Return whether the direction points to the ball's position `images` images earlier."""
        return self.vector.off_deg(self.images.balls.get(self.place - images, NOWHERE)) <= 0.4

    def is_by_the_row_alone(self) -> bool:
        """Return whether the elevation is the arctangent of the row alone, and the azimuth that of the column alone."""
        yaw, pitch = math.atan(self.ball.x / self.ball.z), math.atan(self.ball.y / self.ball.z)
        lower = Vector(math.sin(yaw) * math.cos(pitch), math.sin(pitch), math.cos(yaw) * math.cos(pitch))
        return self.vector.off_deg(lower) <= 0.35

    def is_squeezed(self) -> bool:
        """Return whether the node interpreted the padding as more columns, and squeezed all columns into 160."""
        ball, factor = self.ball.pixel, 160 / ((3 * 160 + self.padding) // 3)
        column = (CENTER.real + ball.real + 0.5) * factor - 0.5
        return self.padding > 0 and apart(self.vector.pixel, column - CENTER.real + ball.imag * 1j) <= 1.0

    def lags(self) -> bool:
        """Return whether the direction is off toward the ball's earlier positions, but not beyond these positions."""
        ball, balls = self.ball.pixel, self.images.balls
        before = [balls[place].pixel for place in range(self.place - 12, self.place) if place in balls]
        back, off = sum(before) / max(len(before), 1) - ball, self.vector.pixel - ball
        along, distance = (off * back.conjugate()).real, apart(off, 0.0)
        farthest = max((apart(ball, one) for one in before), default=-math.inf)
        return along > 0.9 * distance * abs(back) and distance <= farthest + 2.0


class Tracking:
    """All directions that a program published. Raises ValueError for a recording without a seed."""

    def __init__(self, recording: Recording) -> None:
        if recording.seed is None:
            raise ValueError("this recording is older than images that are drawn: judge the answer again")
        self.recording, self.images = recording, drawn(recording.seed)
        images = self.images
        sent_at = [image.wall for image in see.published(recording, IMAGE.name)]
        messages = [one for one in recording.topic(DIRECTION.name).arrivals if isinstance(one.value, dict)]
        self.directions = [Direction(images, sent_at, message) for message in messages]
        # the first direction published for each answered image, by the image's place
        self.first = {one.place: one for one in reversed(self.directions) if one.place >= 0}
        self.to_balls = [one for one in self.first.values() if one.ball is not NOWHERE]
        times = Counter(one.number for one in self.directions)
        self.repeated = [(number, count) for number, count in times.most_common() if count > 1]
        places = {number - 1 for number, _ in self.repeated}
        self.repeats_without_ball = len(places) > 3 and places <= {*images.without_ball}

        # The directions whose stamp belongs to no image. Without its nanoseconds, a stamp can be right only by chance.
        whole = in_whole_seconds(self.directions)
        self.strange = [one for one in self.directions if whole or one.place < 0]
        moving = [one for one in self.directions if one.place in images.moving]
        # the directions' distances (°) from the ball's position one image earlier, in the same image, and one image
        # later
        before, here, after = (
            median(one.vector.off_deg(images.balls[one.place + later]) for one in moving)
            if len(moving) >= 10
            else 0.0
            for later in (-1, 0, 1)
        )
        self.off_before, self.off_here, self.off_after = before, here, after
        nearer_to_another = here > 0.3 and min(before, after) <= min(0.5 * here, 0.3)
        self.is_mixed_up = bool(self.strange) or nearer_to_another

        # the delay (s) of each answered image's direction, in order
        self.waits = see.Waits([self.first[place].waited for place in sorted(self.first)], AT_ONCE_S)
        self.answered = [place for place in images.readable if place in self.first]
        # the encoding without a single answered image, if nearly all images in the other encoding were answered
        answered = [(images.kinds[place][0], place in self.first) for place in images.readable]
        read = {name: share(known for encoding, known in answered if encoding == name) for name in KNOWN}
        least, other = sorted(KNOWN, key=read.__getitem__)
        self.unread = least if read[least] == 0.0 and read[other] >= SURE else ""
        self.unread_images = [view for view in images.views if view.encoding == self.unread]

        # the directions for images in encodings to refuse, and the encodings to refuse that the node has received
        self.guessed = [self.first[place] for place in images.others if place in self.first]
        self.guessed_encodings = sorted({one.encoding for one in self.guessed})
        come_to = [place for place in images.others if place < max(self.first, default=0)]
        met = sorted({images.kinds[place][0] for place in come_to or [images.first_other]})
        self.named = [name for name in met if name in recording.process.log]
        self.unnamed = [name for name in met if name not in recording.process.log]

    @property
    def finds_no_ball(self) -> bool:
        """Whether nearly all images with a ball were answered as if they had no ball, or too few were answered."""
        balls = Directions(self, self.images.with_ball)
        return balls.too_few or share(one.length > 0.5 for one in balls.known) <= SOME


facts = see.once(Tracking)


def in_whole_seconds(directions: list[Direction]) -> bool:
    """Return whether all of more than ten stamps are whole seconds. Only a few images have such a stamp."""
    return len(directions) > 10 and all(one.stamp_s == int(one.stamp_s) for one in directions)


class Directions:
    """The directions published for some of the images."""

    def __init__(self, run: Tracking, places: Sequence[int]) -> None:
        self.run, self.places, self.recording = run, places, run.recording
        self.known = [run.first[place] for place in places if place in run.first]
        # whether there are too few directions to judge; `keeps_up` judges their number
        self.too_few = len(self.known) < max(LEAST_KNOWN * len(places), 3)
        self.wrong = [one for one in self.known if not one.is_right]
        self.example = [*self.wrong, None][len(self.wrong) // 2]
        # the pixels of the ball and of each wrong direction, or [] if there are few, or if a direction isn't in view
        pixels = [(one.ball.pixel, one.vector.pixel) for one in self.wrong]
        can_tell = len(pixels) >= 4 and all(cmath.isfinite(at) for _, at in pixels)
        self.pixels = pixels if can_tell else []

    @property
    def finds_orange(self) -> bool:
        """Whether many orange balls are found in the example's encoding, so that red and blue can't be swapped."""
        alike = [one for one in self.run.to_balls if self.example and one.encoding == self.example.encoding]
        return share(one.is_right for one in alike) >= LEAST_KNOWN

    def misses_low(self, measure: Callable[[Direction], float]) -> bool:
        """Return whether most wrong directions miss a ball, and `measure` is smaller for these balls than for others.

        The missed balls are compared with all found balls, and with the balls found in images of the same kind.
        """
        missed = [measure(one) for one in self.wrong if one.is_zero]
        found = [one for one in self.run.to_balls if one.is_right]
        of_kind = [measure(one) for one in found if one.kind == self.wrong[0].kind]
        if len(missed) < MOST * len(self.wrong) or min(len(missed), len(of_kind)) < 3:
            return False
        lower = share(one < other for one, other in product(missed, of_kind))
        return lower >= SURE and min(map(measure, found)) >= median(missed)

    def at(self, expected: Iterable[complex], within: float = 1.0) -> float:
        """Return the fraction of wrong directions whose pixel is at most `within` pixels from the expected one."""
        pairs = zip(self.pixels, expected, strict=True)
        return share(apart(at, pixel) <= within for (_, at), pixel in pairs)

    @property
    def moved(self) -> float:
        """The fraction of wrong directions that are off by the same vector of pixels."""
        off = [at - ball for ball, at in self.pixels] or [0j]
        by = complex(median(one.real for one in off), median(one.imag for one in off))
        return self.at(ball + by for ball, _ in self.pixels)

    def scaled(self, *, together: bool) -> float:
        """Return the fraction of wrong directions whose distance from the center is scaled.

        `together`: whether both axes share one factor instead of having one each.
        """
        across = [(ball.real, at.real) for ball, at in self.pixels]
        along = [(ball.imag, at.imag) for ball, at in self.pixels]
        right, down = (slope(across + along),) * 2 if together else (slope(across), slope(along))
        scaled = (complex(right * ball.real, down * ball.imag) for ball, _ in self.pixels)
        return self.at(scaled) if min(right, down) > 0.2 and max(right, down) < 5.0 else 0.0

    @property
    def edge(self) -> str:
        """The edge or corner of the ball to which most wrong directions point, or "" if there is none."""
        seen = self.wrong if self.pixels else []
        for name, side in EDGES.items():
            if self.at((one.ball.pixel + side * one.width / 2 for one in seen), within=1.5) >= SURE:
                return name
        return ""

    @property
    def repeat_the_last_ball(self) -> bool:
        vectors = {one.vector for one in self.wrong}
        before = [one for one in self.run.to_balls if one.place < self.places[0]]
        last = max(before, key=lambda one: one.place).vector if before else None
        return last in vectors and len(vectors) <= 4


def slope(pairs: Sequence[tuple[float, float]]) -> float:
    return sum(one * other for one, other in pairs) / max(sum(one * one for one, _ in pairs), 1e-9)


SIDES = {"left": -1, "right": 1, "upper": -1j, "lower": 1j}
"""The direction from the ball's center to each edge, as in `Vector.pixel`: right (real) and down (imaginary)."""
CORNERS = [(down, right) for down in ("upper", "lower") for right in ("left", "right")]
EDGES = {f"{name} edge": side for name, side in SIDES.items()}
EDGES |= {f"{down} {right} corner": SIDES[down] + SIDES[right] for down, right in CORNERS}
Fits = Callable[[Directions], bool]


def most(fits: Callable[[Direction], bool]) -> Fits:
    """Return a test of whether most of some images' wrong directions satisfy `fits`."""
    return lambda some: share(map(fits, some.wrong)) >= MOST


def points_to(expected: Callable[[Direction], Vector]) -> Fits:
    """Return a test of whether most wrong directions are near the `expected` direction instead of the ball's."""
    return most(lambda one: one.vector.off_deg(expected(one)) <= NEAR_DEG < one.off)


def misses_all(has: Callable[[Direction], bool]) -> Fits:
    """Return a test of whether most wrong directions miss a ball of some kind, and no such ball was found."""
    missed = most(lambda one: one.is_zero and has(one))
    return lambda some: missed(some) and not any(one.is_right and has(one) for one in some.run.to_balls)


NOTHING = WORDS.cause("answers-come.nothing", (), about_time=True)
STAMPS = WORDS.rules(
    Tracking,
    "stamps-kept",
    ("no-stamp", lambda f: f.strange and all(one.stamp_s == 0.0 for one in f.strange)),
    ("whole-seconds", lambda f: in_whole_seconds(f.strange)),
    ("own-stamp", lambda f: f.strange),
    ("one-behind", lambda f: f.is_mixed_up and f.off_before < f.off_after),
    ("one-ahead", lambda f: f.is_mixed_up),
    ("no-ball-repeated", lambda f: f.repeats_without_ball),
    ("repeated", lambda f: f.repeated),
)
MIXED_UP = see.not_judged("the stamps don't show which image each direction is for")
KEEPS_UP = WORDS.seen("keeps-up.answered", Tracking)
LATE = WORDS.rules(
    Tracking,
    "keeps-up",
    ("queue-grows", lambda f: f.waits.last_s > f.waits.first_s + 0.5),
    ("late", see.otherwise),
    when=lambda f: f.waits.typical_s > TYPICALLY_S or f.waits.are_late(SHARE_AT_ONCE),
    about_time=True,
)
MISSING = WORDS.rules(
    Tracking,
    "keeps-up",
    ("answered", see.otherwise, see.failed_by_error),
    ("answered", lambda f: f.images.readable[-1] not in f.first, see.program_ended),
    ("silent-since", lambda f: f.first.keys() == set(range(f.images.first_other))),
    ("one-encoding", lambda f: f.unread),
    ("missing", see.otherwise),
    when=lambda f: len(f.answered) < LEAST_SHARE * len(f.images.readable),
    about_time=["missing"],
)
REFUSED_WELL = WORDS.seen("refuses-others.well", Tracking)
SILENT_SINCE = WORDS.cause("refuses-others.silent-since", (), about_time=True)
REFUSES = WORDS.rules(
    Tracking,
    "refuses-others",
    ("says-no-ball", lambda f: f.guessed and all(one.is_zero for one in f.guessed)),
    ("guesses", lambda f: f.guessed),
    ("named-once", lambda f: f.named and f.unnamed),
    ("no-line", lambda f: f.unnamed),
)
TOO_FEW = WORDS.rules(
    Directions, "direction", ("too-few-answers", lambda f: f.too_few, see.program_ended), about_time=True
)
AT_BLUE_BALL = points_to(lambda one: one.images.blue_balls[one.place])
AT_BRICK = points_to(lambda one: one.images.bricks[one.place])
WRONG = WORDS.rules(
    Directions,
    "direction",
    ("no-number", most(lambda one: not one.is_finite)),
    ("largest-left-out", misses_all(lambda one: one.brick_m > 0.5 * (NEAR[0] + FAR[0]))),
    ("topmost-left-out", misses_all(lambda one: one.brick_m < 0.5 * (NEAR[0] + IN_FRONT[0]))),
    ("too-dark", lambda f: f.misses_low(lambda one: one.light)),
    ("too-small", lambda f: f.misses_low(lambda one: one.width)),
    ("no-ball", most(lambda one: one.is_zero)),
    ("not-of-length-one", most(lambda one: one.off <= WITHIN_DEG)),
    ("a-pixel", most(lambda one: math.dist(one.vector[:2], one.ball_from_the_corner[:2]) < 8.0)),
    ("blue-too", lambda f: AT_BLUE_BALL(f) and f.finds_orange),
    ("blue-ball", AT_BLUE_BALL),
    ("brick", AT_BRICK),
    ("x-to-the-left", points_to(lambda one: Vector(-one.ball.x, one.ball.y, one.ball.z))),
    ("y-up", points_to(lambda one: Vector(one.ball.x, -one.ball.y, one.ball.z))),
    ("axes-of-the-robot", points_to(lambda one: Vector(one.ball.z, -one.ball.x, -one.ball.y))),
    ("from-the-corner", points_to(lambda one: one.ball_from_the_corner)),
    ("elevation", most(Direction.is_by_the_row_alone)),
    ("squeezed", most(Direction.is_squeezed)),
    *[("earlier-picture", most(partial(Direction.is_from_before, images=images))) for images in (1, 2, 3)],
    ("focal-length", lambda f: f.scaled(together=True) >= max(SURE, f.moved)),
    ("middle", lambda f: f.moved >= SURE),
    ("edge", lambda f: f.edge),
    ("one-axis", lambda f: f.scaled(together=False) >= SURE),
    ("behind", lambda f: bool(f.pixels) and share(one.lags() for one in f.wrong) >= 0.8),
    ("beside", see.otherwise),
)
UNCLEAR = ("direction.no-ball", "direction.too-dark", "direction.too-small", "direction.beside")
PADDING_AS_PIXELS = WORDS.cause("direction.padding-taken-for-pixels", Directions)
PADDING_OF_ONE_ENCODING = WORDS.cause("direction.padding-of-one-encoding", Directions)
GHOSTS = WORDS.rules(
    Directions,
    "no-ball-said",
    ("silent", lambda f: not f.known and max(f.run.first, default=0) >= f.places[10]),
    ("too-few-answers", lambda f: f.too_few, see.program_ended),
    ("repeated", lambda f: f.repeat_the_last_ball),
    ("no-number", lambda f: not all(one.is_finite for one in f.wrong)),
    ("constant", lambda f: len({one.vector for one in f.wrong}) == 1),
    ("brick", AT_BRICK),
    ("blue-ball", AT_BLUE_BALL),
    ("something-else", lambda f: f.wrong),
    ("always", lambda f: f.run.finds_no_ball),
    about_time=["too-few-answers"],
)


@criterion(
    points=1,
    title="It subscribes to /camera/image (Image), and /robot/ball_direction carries Vector3Stamped",
    needs=[program_runs],
)
def topics(recording: Recording) -> Verdict:
    return see.all_of(see.listens(recording, IMAGE), see.publishes(recording, DIRECTION))


@criterion(points=0, title="The node publishes answers", needs=[topics])
def answers_come(recording: Recording) -> Verdict:
    if recording.topic(DIRECTION.name).arrivals:
        return see.passed("directions arrive")
    nothing = NOTHING.verdict()
    return see.ended_or_error(recording, nothing.saw, nothing.expected) or nothing


@criterion(
    points=1,
    title="Each direction has its image's stamp, and there's only one direction per image",
    needs=[answers_come],
)
def stamps_kept(recording: Recording) -> Verdict:
    run = facts(recording)
    directions = see.count(len(run.directions), "direction")
    return STAMPS.first(run) or see.passed(f"{directions}, each with the stamp of an image")


@criterion(points=1, title="It keeps up with 30 images a second", needs=[answers_come])
def keeps_up(recording: Recording) -> Verdict:
    run = facts(recording)
    if run.is_mixed_up:
        return MIXED_UP
    return LATE.first(run) or MISSING.first(run) or see.passed(KEEPS_UP(run)[0])


@criterion(
    points=1,
    title="It rejects other encodings, logs a line that names each of them, and keeps running",
    needs=[answers_come],
)
def refuses_others(recording: Recording) -> Verdict:
    run = facts(recording)
    places, first_other = run.first.keys(), run.images.first_other
    if any(place > first_other for place in places) or not any(place < first_other for place in places):
        return REFUSES.first(run) or see.passed(REFUSED_WELL(run)[0])
    silent = SILENT_SINCE.verdict()
    seen = silent.saw, silent.expected
    return see.failed_by_error(recording, *seen) or see.program_ended(recording, *seen) or silent


@criterion(points=2, title="In good light, the direction for an rgb8 image is correct", needs=[answers_come])
def direction_right(recording: Recording) -> Verdict:
    run = facts(recording)
    return judged(Directions(run, run.images.in_good_light))


@criterion(points=1, title="The direction is correct in changing light", needs=[direction_right])
def light_changes(recording: Recording) -> Verdict:
    run = facts(recording)
    return judged(Directions(run, run.images.in_dim_light))


@criterion(points=1, title="The direction is correct for bgr8", needs=[answers_come])
def bgr_right(recording: Recording) -> Verdict:
    run = facts(recording)
    return judged(Directions(run, run.images.in_bgr))


@criterion(points=1, title="The direction is correct for rows with padding", needs=[direction_right])
def padding_right(recording: Recording) -> Verdict:
    run = facts(recording)
    padded, padded_bgr = Directions(run, run.images.padded), Directions(run, run.images.padded_bgr)
    unpadded_is_right = judged(Directions(run, run.images.in_dim_light)).ok
    bgr_is_right = judged(Directions(run, run.images.in_bgr)).ok
    one_is_right = judged(padded).ok or (bgr_is_right and judged(padded_bgr).ok)
    suspected = PADDING_OF_ONE_ENCODING if one_is_right else PADDING_AS_PIXELS
    verdict = judged(padded, suspected if unpadded_is_right else None)
    if not bgr_is_right:
        return verdict  # `bgr_right` judges faults that concern bgr8 alone
    return see.all_of(verdict, judged(padded_bgr, suspected))


@criterion(points=1, title="It reports when there is no ball", needs=[answers_come])
def no_ball_said(recording: Recording) -> Verdict:
    run = facts(recording)
    if run.is_mixed_up:
        return MIXED_UP
    ghosts = Directions(run, run.images.without_ball)
    well = see.passed(f"(0, 0, 0) for {len(ghosts.known)} images without a ball")
    return GHOSTS.first(ghosts) or well


def judged(some: Directions, suspected: see.Cause | None = None) -> Verdict:
    """Return the verdict on some directions. `suspected`: the cause if most are wrong and don't show why."""
    if some.run.is_mixed_up:
        return MIXED_UP
    if some.too_few:
        return TOO_FEW.verdict(some)
    if not some.wrong:
        farthest = max(0.05, *(one.off for one in some.known))
        return see.passed(f"{len(some.known)} directions, each within {farthest:.1f}° of the ball")
    verdict = WRONG.verdict(some)
    is_unclear = verdict.cause in UNCLEAR and len(some.wrong) >= MOST * len(some.known)
    return suspected.verdict(some) if suspected and is_unclear else verdict
