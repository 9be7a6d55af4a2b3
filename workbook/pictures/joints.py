"""Define the humanoid's twelve joints: names, order, ranges, poses, and each part's position for given angles.

The robot faces you, so its left side is on your right. Every joint turns in the plane of the figure, so an angle of
0.5 rad looks like 0.5 rad. With all angles at zero, the robot stands with its arms hanging down. For arms and legs, a
positive angle opens outward, so equal values left and right make a symmetrical pose. A positive knee angle folds the
shin back inward. For positive angles, neck and waist lean to the robot's left.
"""

import math
from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from types import MappingProxyType

Point = tuple[float, float]
Angles = tuple[float, ...]

JOINT_NAMES = (
    "neck",
    "waist",
    "left_shoulder",
    "left_elbow",
    "right_shoulder",
    "right_elbow",
    "left_hip",
    "left_knee",
    "left_ankle",
    "right_hip",
    "right_knee",
    "right_ankle",
)
"""The order of the angles in a message: index 0 is the neck, index 11 the right ankle."""

COMFORTABLE: Mapping[str, tuple[float, float]] = MappingProxyType(
    {
        "neck": (-0.6, 0.6),
        "waist": (-0.5, 0.5),
        "left_shoulder": (-0.3, 3.0),
        "left_elbow": (-2.4, 2.4),
        "right_shoulder": (-0.3, 3.0),
        "right_elbow": (-2.4, 2.4),
        "left_hip": (-0.3, 1.3),
        "left_knee": (-0.2, 2.2),
        "left_ankle": (-0.8, 0.8),
        "right_hip": (-0.3, 1.3),
        "right_knee": (-0.2, 2.2),
        "right_ankle": (-0.8, 0.8),
    }
)
"""The lowest and highest angle (rad) that a joint reaches comfortably. Any finite angle can be drawn."""

UPPER_ARM, FOREARM, HAND = 56.0, 50.0, 15.0
THIGH, SHIN, SOLE = 56.0, 54.0, 15.0
PELVIS_RADIUS, CHEST, NECK, HEAD = 26.0, 92.0, 16.0, 84.0
SHOULDER_OUT, SHOULDER_UP, HIP_OUT, WAIST_UP = 57.0, 74.0, 25.0, 12.0
FOOT_INNER, FOOT_OUTER = 20.0, 27.0
SWAY = -0.5 * (CHEST + NECK)
"""The hips shift sideways by this number times the sine of the angle at which the body leans."""


def pose(**angles: float) -> Angles:
    """Return twelve angles that are zero except for the named joints: `pose(left_shoulder=1.5)`.

    Raises ValueError for an unknown joint.
    """
    unknown = sorted(set(angles) - set(JOINT_NAMES))
    if unknown:
        raise ValueError(f"no joint is called {unknown[0]!r}; the joints are {', '.join(JOINT_NAMES)}")
    return tuple(float(angles.get(name, 0.0)) for name in JOINT_NAMES)


NEUTRAL = pose(left_shoulder=0.22, right_shoulder=0.22, left_elbow=-0.12, right_elbow=-0.12)
WAVE = pose(
    neck=0.16, left_shoulder=2.25, left_elbow=0.55, right_shoulder=0.25, right_elbow=-0.2,
    left_hip=0.05, right_hip=0.05, left_knee=0.05, right_knee=0.05,
)  # fmt: skip
SQUAT = pose(
    left_shoulder=1.35, left_elbow=-0.35, right_shoulder=1.35, right_elbow=-0.35,
    left_hip=1.0, left_knee=1.0, right_hip=1.0, right_knee=1.0,
)  # fmt: skip
STEP = pose(
    neck=-0.06, waist=-0.07, left_shoulder=0.3, left_elbow=-0.3, right_shoulder=0.75, right_elbow=0.35,
    left_hip=0.75, left_knee=1.15, left_ankle=0.3, right_hip=-0.02,
)  # fmt: skip
CHEER = pose(
    left_shoulder=2.45, left_elbow=0.25, right_shoulder=2.45, right_elbow=0.25,
    left_hip=0.2, left_knee=0.2, right_hip=0.2, right_knee=0.2,
)  # fmt: skip
FLINCH = pose(
    neck=-0.25, waist=-0.12, left_shoulder=1.0, left_elbow=1.5, right_shoulder=1.0, right_elbow=1.5,
    left_hip=0.25, left_knee=0.35, right_hip=0.25, right_knee=0.35,
)  # fmt: skip


def waving(t: float) -> Angles:
    """Return the pose of a friendly wave, `t` seconds after its start."""
    swing = math.sin(2 * math.pi * 1.1 * t)
    return _changed(
        WAVE, left_elbow=0.45 + 0.5 * swing, neck=0.14 + 0.05 * swing, waist=0.04 * swing,
        right_shoulder=0.25 + 0.03 * swing,
    )  # fmt: skip


def walking(t: float) -> Angles:
    """Return the pose of marching on the spot, one step per second, `t` seconds after its start."""
    swing = math.sin(math.pi * t)
    left, right = max(0.0, swing), max(0.0, -swing)
    return pose(
        neck=-0.06 * swing, waist=-0.08 * swing,
        left_shoulder=0.3 + 0.45 * right, left_elbow=-0.25 + 0.6 * right,
        right_shoulder=0.3 + 0.45 * left, right_elbow=-0.25 + 0.6 * left,
        left_hip=0.75 * left, left_knee=1.15 * left, left_ankle=0.3 * left,
        right_hip=0.75 * right, right_knee=1.15 * right, right_ankle=0.3 * right,
    )  # fmt: skip


def checked(angles: Iterable[float]) -> Angles:
    """Return the twelve angles as floats.

    Raises ValueError, with a message for the angles' sender, unless there are twelve angles and all are finite numbers.
    """
    try:
        values = list(angles)
    except TypeError:
        raise ValueError(
            f"twelve joint angles are needed; this is not a list of numbers: {angles!r}"
        ) from None
    if len(values) != len(JOINT_NAMES):
        raise ValueError(
            f"the humanoid has {len(JOINT_NAMES)} joints, so it needs {len(JOINT_NAMES)} angles, not {len(values)}"
        )
    result: list[float] = []
    for name, value in zip(JOINT_NAMES, values, strict=True):
        try:
            angle = math.nan if isinstance(value, str) else float(value)
        except (TypeError, ValueError):
            angle = math.nan
        if not math.isfinite(angle):
            raise ValueError(
                f"the angle of joint {len(result)} ({name}) must be a finite number in rad, not {value!r}"
            )
        result.append(angle)
    return tuple(result)


@dataclass(frozen=True)
class Limb:
    """An arm or a leg: the points of its joints from the body outward, and the outward angles (rad) of its parts.

    `side` is +1 for the robot's left (on the right of the figure) and -1 for its right. `tip` is the outward angle of
    the hand or foot.
    """

    side: int
    root: Point
    bend: Point
    end: Point
    upper: float
    lower: float
    tip: float

    @property
    def word(self) -> str:
        """The side of the robot that the limb is on: "left" or "right"."""
        return "left" if self.side > 0 else "right"


@dataclass(frozen=True)
class Skeleton:
    """The position of every part, in figure units from the middle of the ground line: x to your right, y up."""

    pelvis: Point
    waist: Point
    neck: Point
    lean: float
    tilt: float
    arms: tuple[Limb, Limb]
    legs: tuple[Limb, Limb]

    def on_torso(self, x: float, y: float) -> Point:
        """Convert a point from the torso's frame.

        The frame's origin is the waist. The x axis points to the viewer's right, and the y axis points toward the neck.
        """
        return _turned(self.waist, self.lean, x, y)

    def on_head(self, x: float, y: float) -> Point:
        """Convert a point from the head's frame: the origin is the neck, and y points toward the crown."""
        return _turned(self.neck, self.lean + self.tilt, x, y)


def skeleton(angles: Sequence[float]) -> Skeleton:
    """Compute the figure for twelve checked angles (forward kinematics), with its lowest point on the ground."""
    joint = dict(zip(JOINT_NAMES, angles, strict=True))
    lean, tilt = joint["waist"], joint["neck"]
    # A leaning body shifts its hips the other way, which keeps its balance (and keeps it inside the figure).
    pelvis = (SWAY * math.sin(lean), 0.0)
    waist = (pelvis[0], WAIST_UP)
    neck = _turned(waist, lean, 0.0, CHEST)
    arms, legs = [], []
    for side, word in ((1, "left"), (-1, "right")):
        shoulder = _turned(waist, lean, side * SHOULDER_OUT, SHOULDER_UP)
        upper = joint[f"{word}_shoulder"] - side * lean
        lower = upper + joint[f"{word}_elbow"]
        elbow = _outward(shoulder, side, upper, UPPER_ARM)
        arms.append(Limb(side, shoulder, elbow, _outward(elbow, side, lower, FOREARM), upper, lower, lower))
        hip = (pelvis[0] + side * HIP_OUT, -6.0)
        upper = joint[f"{word}_hip"]
        lower = upper - joint[f"{word}_knee"]
        knee = _outward(hip, side, upper, THIGH)
        ankle = _outward(knee, side, lower, SHIN)
        legs.append(Limb(side, hip, knee, ankle, upper, lower, lower + joint[f"{word}_ankle"]))
    figure = Skeleton(pelvis, waist, neck, lean, tilt, (arms[0], arms[1]), (legs[0], legs[1]))
    return _lifted(figure, -_lowest(figure))


def foot(leg: Limb, x: float, y: float) -> Point:
    """Convert a point from a foot's frame: the origin is the ankle, x points outward along the sole, y away from it."""
    cos, sin = math.cos(leg.tip), math.sin(leg.tip)
    return (leg.end[0] + leg.side * (x * cos - y * sin), leg.end[1] + x * sin + y * cos)


def touching(figure: Skeleton) -> Iterator[tuple[tuple[str, ...], Point, float]]:
    """Yield candidates for the figure's lowest point.

    Each candidate has three parts: the joints that turn the point, from the body outward; the point; and the figure's
    extent below it.
    """
    for leg in figure.legs:
        hip, knee, ankle = (f"{leg.word}_{joint}" for joint in ("hip", "knee", "ankle"))
        for x in (-FOOT_INNER, FOOT_OUTER):
            yield (hip, knee, ankle), foot(leg, x, -SOLE), 0.0
        yield (hip,), leg.bend, 14.0
        yield (hip, knee), leg.end, 14.0
    for arm in figure.arms:
        shoulder, elbow = f"{arm.word}_shoulder", f"{arm.word}_elbow"
        yield ("waist", shoulder, elbow), arm.end, HAND + 8
        yield ("waist", shoulder), arm.bend, 13.0
    for x in (-48, 48):
        for y in (NECK, NECK + HEAD):
            yield ("waist", "neck"), figure.on_head(x, y), 0.0
    for x in (-50, 50):
        yield ("waist",), figure.on_torso(x, CHEST), 0.0
    yield (), figure.pelvis, PELVIS_RADIUS


def blend(start: Sequence[float], end: Sequence[float], part: float) -> Angles:
    """Return the pose that is a `part` (0 to 1) of the way from `start` to `end`."""
    return tuple(a + (b - a) * part for a, b in zip(start, end, strict=True))


class Follower:
    """Glides from each pose to the next, like a servo, so that even poses that arrive every 2 s lead to smooth motion.

    Call `aim(angles, now)` when a message arrives, and `angles(now)` for each frame. `now` is the time in seconds on
    any steady clock. The follower reaches a new aim after `ease` seconds.
    """

    def __init__(self, ease: float = 0.8, start: Iterable[float] = NEUTRAL) -> None:
        self.ease = ease
        self._from = self._to = checked(start)
        self._since = -math.inf

    def aim(self, angles: Iterable[float], now: float) -> None:
        """Start to move toward these angles (rad). If they aren't valid, raise ValueError and keep the previous aim."""
        aim = checked(angles)
        self._from, self._to, self._since = self.angles(now), aim, now

    @property
    def aimed(self) -> Angles:
        """The angles of the current aim (rad)."""
        return self._to

    def angles(self, now: float) -> Angles:
        """Return the angles at the time `now` (rad)."""
        part = 1.0 if self.ease <= 0 else min(1.0, max(0.0, (now - self._since) / self.ease))
        return self._to if part >= 1.0 else blend(self._from, self._to, part * part * (3 - 2 * part))


def _changed(base: Sequence[float], **angles: float) -> Angles:
    return tuple(angles.get(name, value) for name, value in zip(JOINT_NAMES, base, strict=True))


def _turned(origin: Point, lean: float, x: float, y: float) -> Point:
    cos, sin = math.cos(lean), math.sin(lean)
    return (origin[0] + x * cos + y * sin, origin[1] - x * sin + y * cos)


def _outward(start: Point, side: int, angle: float, length: float) -> Point:
    return (start[0] + side * length * math.sin(angle), start[1] - length * math.cos(angle))


def _lowest(figure: Skeleton) -> float:
    return min(point[1] - radius for _, point, radius in touching(figure))


def _lifted(figure: Skeleton, up: float) -> Skeleton:
    def lift(point: Point) -> Point:
        return (point[0], point[1] + up)

    def limb(part: Limb) -> Limb:
        return Limb(
            part.side, lift(part.root), lift(part.bend), lift(part.end), part.upper, part.lower, part.tip
        )

    return Skeleton(
        lift(figure.pelvis), lift(figure.waist), lift(figure.neck), figure.lean, figure.tilt,
        (limb(figure.arms[0]), limb(figure.arms[1])), (limb(figure.legs[0]), limb(figure.legs[1])),
    )  # fmt: skip
