"""Map messages to effects on the panel's robot: one table for all topics of the course."""

import math
from collections.abc import Callable, Mapping
from functools import lru_cache, partial
from typing import Any, NamedTuple

from workbook.lab.panel.images import Thumbnail
from workbook.pictures.joints import JOINT_NAMES, NEUTRAL, checked

UPRIGHT_RAD = 0.06
"""The smallest lean angle (rad) to show. Smaller angles are the acceleration sensor's noise."""
GLANCE_RAD, REAR_GLANCE_RAD = 0.2, 0.6
WORKING, BROKEN = ("operational", "ok"), ("error", "faulty", "no answer")
"""Status words for which the robot has a face."""


class Reaction(NamedTuple):
    """The effect of messages on topics that end in `name` and have a type (None: any type).

    `effect` is defined in rig.js. `value` reads the effect's value from a message. It raises ValueError, with a message
    for the sender, if there is no valid value.
    """

    name: str
    type_name: str | None
    effect: str
    value: Callable[[Any], object]


def _angles(message: Any) -> list[float]:
    return list(checked(message.data))


def _named_angles(message: Any) -> list[float]:
    """Return the angles (rad) of a JointState. Joints that it doesn't name get their neutral angle."""
    pose = dict(zip(JOINT_NAMES, NEUTRAL, strict=True))
    pose |= {name: angle for name, angle in zip(message.name, message.position, strict=False) if name in pose}
    return list(checked(pose.values()))


def _finite(value: float, what: str) -> float:
    if not math.isfinite(value):
        raise ValueError(f"the {what} is {value}, which isn't a number to show")
    return float(value)


def _face(message: Any) -> str:
    word = message.data
    return "operational" if word in WORKING else "error" if word in BROKEN else "awake"


def _charge(message: Any) -> float:
    return _finite(message.data, "battery")


def _angle(message: Any) -> float:
    return _finite(message.data, "angle")


def _speed(message: Any) -> list[float]:
    return [_finite(message.linear.x, "speed"), _finite(message.angular.z, "turn rate")]


def _direction(message: Any) -> float:
    """Return the angle (rad) to the left of a vector in the camera's frame: x right, y down, z forward."""
    vector = message.vector
    return _finite(math.atan2(-vector.x, vector.z), "direction") if vector.x or vector.z else 0.0


def _lean(message: Any) -> float:
    """Return a body's lean angle (rad, positive to its left) from its acceleration at rest."""
    up = message.linear_acceleration
    angle = math.atan2(math.hypot(up.x, up.y), up.z)
    return 0.0 if _finite(angle, "acceleration") < UPRIGHT_RAD else round(math.copysign(angle, -up.y), 2)


def _glance(rad: float, message: Any) -> float:
    """Return `rad` for two numbers in a row, and `-rad` for the next two. The number is the message's last word."""
    words = message.data.split() if isinstance(message.data, str) else list(message.data)
    number = str(words[-1]) if words else ""
    return rad if number.isdecimal() and int(number) % 4 < 2 else -rad


def _boxes(message: Any) -> list[list[object]]:
    """Return each detection's label, center and size (pixels), and score."""
    return [
        [
            marker.ns,
            *(round(_finite(value, "box"), 1) for value in (marker.pose.position.x, marker.pose.position.y)),
            *(round(_finite(value, "box"), 1) for value in (marker.scale.x, marker.scale.y)),
            round(_finite(marker.color.a, "score"), 2),
        ]
        for marker in message.markers
    ]


def _once(message: Any) -> bool:
    return True


_JOINT_STATE, _FLOAT, _STRING = "sensor_msgs/msg/JointState", "std_msgs/msg/Float32", "std_msgs/msg/String"
_NUMBERS = "std_msgs/msg/Int32MultiArray"
REACTIONS = (
    Reaction("encoders/joint_states", _JOINT_STATE, "raw", _named_angles),
    Reaction("joint_states", _JOINT_STATE, "pose", _named_angles),
    Reaction("joint_positions", "std_msgs/msg/Float32MultiArray", "pose", _angles),
    Reaction("heartbeat", None, "beat", _once),
    Reaction("beat", None, "beat", _once),
    Reaction("monitor/battery", _FLOAT, "battery", _charge),
    Reaction("battery", _FLOAT, "battery", _charge),
    Reaction("status", _STRING, "face", _face),
    Reaction("health", _STRING, "face", _face),
    Reaction("tilt", _FLOAT, "tilt", _angle),
    Reaction("imu", "sensor_msgs/msg/Imu", "tilt", _lean),
    Reaction("cmd_vel", "geometry_msgs/msg/Twist", "walk", _speed),
    Reaction("seen", "std_msgs/msg/Int32", "touch", _once),
    Reaction("touch", None, "touch", _once),
    Reaction("ball_direction", "geometry_msgs/msg/Vector3Stamped", "look", _direction),
    Reaction("head_angle", _FLOAT, "look", _angle),
    Reaction("robot/rear_camera/frame", _STRING, "look", partial(_glance, REAR_GLANCE_RAD)),
    Reaction("robot/camera/frame", _STRING, "look", partial(_glance, GLANCE_RAD)),
    Reaction("look", _NUMBERS, "look", partial(_glance, GLANCE_RAD)),
    Reaction("alarm", "std_msgs/msg/Bool", "alarm", lambda message: bool(message.data)),
    Reaction("alarm", _STRING, "alert", _once),
    Reaction("plan", _FLOAT, "thought", _once),
    Reaction("detections", "visualization_msgs/msg/MarkerArray", "boxes", _boxes),
    Reaction("image", "sensor_msgs/msg/Image", "image", Thumbnail),
)
"""The table of reactions. The first row that matches a message applies.

While a topic is published, it suppresses the same effect of lower rows: `/monitor/battery` outranks `/robot/battery`.
Messages on any other topic wake the robot, and the panel shows them as text below it.
"""
NOD, SHAKE = Reaction("", None, "nod", _once), Reaction("", None, "shake", _once)
"""The effect of a service's response, depending on its field `success`."""
MOMENTS = ("beat", "touch", "alert", "thought", "nod", "shake")
"""Effects that happen once for each message; the others last."""


@lru_cache(maxsize=256)
def row_of(topic: str, type_name: str) -> int | None:
    """Return the number of the table row for a topic's messages; None if there is none."""
    fits = (
        number
        for number, one in enumerate(REACTIONS)
        if f"/{topic}".endswith(f"/{one.name}") and one.type_name in (None, type_name)
    )
    return next(fits, None)


def is_outranked(topic: str, type_name: str, published: Mapping[str, str]) -> bool:
    """Return whether a topic in `published` (name: type) has the same effect and a higher row in the table."""
    own = row_of(topic, type_name)
    rows = (row_of(name, kind) for name, kind in published.items())
    return own is not None and any(
        row is not None and row < own and REACTIONS[row].effect == REACTIONS[own].effect for row in rows
    )


def reaction_to(topic: str, type_name: str, message: Any = None) -> Reaction | None:
    """Return the effect of a topic's message or a service's response; None if the table has none."""
    if "/srv/" in type_name:
        return NOD if getattr(message, "success", True) else SHAKE
    row = row_of(topic, type_name)
    return None if row is None else REACTIONS[row]
