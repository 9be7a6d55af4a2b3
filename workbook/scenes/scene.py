"""Define a scene's objects as plain data, with the standard library only."""

from collections.abc import Sequence
from dataclasses import dataclass

Place = tuple[float, float, float]

DESK_M = -0.45
"""The desk's height relative to the camera."""
BALL_RADIUS_M = 0.04


@dataclass(frozen=True)
class Box:
    """A brick on the desk: the center of its bottom (m, robot's frame), its edges (m), and its angle `turn` (rad)."""

    at: tuple[float, float]
    size: Place = (0.05, 0.14, 0.05)
    turn: float = 0.0


@dataclass(frozen=True)
class Cup:
    """A cup on the desk: the center of its bottom (m, robot's frame), its radius, and its height (m)."""

    at: tuple[float, float]
    radius: float = 0.035
    height: float = 0.09


@dataclass(frozen=True)
class Plate:
    """A flat round plate on the desk, as orange as the ball: its center (m, robot's frame) and its radius (m)."""

    at: tuple[float, float]
    radius: float = 0.065


@dataclass(frozen=True)
class Scene:
    """A scene at one instant. Positions are relative to the camera in the robot's frame (m): x forward, y left, z up.

    `joints`: the twelve angles of `/robot/joint_positions` (rad), or None for a scene without arms. `pan`: the head's
    angle to the left (rad). `light`: 1 is a bright day, 0.3 an evening. `warm`: the light is reddish above 1, and
    bluish below 1.
    """

    ball: Place | None = None
    blue_ball: Place | None = None
    boxes: tuple[Box, ...] = ()
    joints: Sequence[float] | None = None
    pan: float = 0.0
    light: float = 1.0
    warm: float = 1.0
    cups: tuple[Cup, ...] = ()
    plates: tuple[Plate, ...] = ()


def on_desk(forward: float, left: float) -> Place:
    """Return the center of a ball that lies on the desk, `forward` and to the `left` of the camera (m)."""
    return forward, left, DESK_M + BALL_RADIUS_M
