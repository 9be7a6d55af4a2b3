"""What the robot on the panel does with the messages of a topic: one table for all topics of the course."""

import math
from collections.abc import Callable
from typing import Any, NamedTuple

from workbook.pictures.joints import JOINT_NAMES, NEUTRAL, checked

WORKING, BROKEN = ("operational", "ok"), ("error", "faulty", "no answer")
"""Words of a status that the robot has a face for."""


class Reaction(NamedTuple):
    """What messages do that are published under a name (the last part of it) and with a type, if that matters.

    `effect` is a word that rig.js knows; `value` takes its value from a message, and raises ValueError, in words for
    the sender, where the message has none.
    """

    name: str
    type_name: str | None
    effect: str
    value: Callable[[Any], object]


def _angles(message: Any) -> list[float]:
    return list(checked(message.data))


def _named_angles(message: Any) -> list[float]:
    """The angles of a JointState; joints that it doesn't name hang down as they do at rest."""
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
    """How far (rad) something is to the left in the camera's frame: x right, y down, z forward."""
    vector = message.vector
    return _finite(math.atan2(-vector.x, vector.z), "direction") if vector.x or vector.z else 0.0


def _once(message: Any) -> bool:
    return True


REACTIONS = (
    Reaction("joint_positions", "std_msgs/msg/Float32MultiArray", "pose", _angles),
    Reaction("joint_states", "sensor_msgs/msg/JointState", "pose", _named_angles),
    Reaction("heartbeat", None, "beat", _once),
    Reaction("beat", None, "beat", _once),
    Reaction("battery", "std_msgs/msg/Float32", "battery", _charge),
    Reaction("status", "std_msgs/msg/String", "face", _face),
    Reaction("health", "std_msgs/msg/String", "face", _face),
    Reaction("tilt", "std_msgs/msg/Float32", "tilt", _angle),
    Reaction("cmd_vel", "geometry_msgs/msg/Twist", "walk", _speed),
    Reaction("touch", None, "touch", _once),
    Reaction("seen", "std_msgs/msg/Int32", "touch", _once),
    Reaction("head_angle", "std_msgs/msg/Float32", "look", _angle),
    Reaction("ball_direction", "geometry_msgs/msg/Vector3Stamped", "look", _direction),
    Reaction("alarm", "std_msgs/msg/Bool", "alarm", lambda message: bool(message.data)),
    Reaction("alarm", "std_msgs/msg/String", "alert", _once),
)
"""From the first that fits. Messages of any other topic wake the robot, and stand in words under it."""
MOMENTS = ("beat", "touch", "alert")
"""Effects that happen once for each message; the others last."""


def reaction_to(topic: str, type_name: str) -> Reaction | None:
    """What the messages of a topic do; None where the table has nothing for it."""
    name = topic.rpartition("/")[2]
    return next((one for one in REACTIONS if one.name == name and one.type_name in (None, type_name)), None)
