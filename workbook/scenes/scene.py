"""What there is to see, as plain data: standard library only."""

from collections.abc import Sequence
from dataclasses import dataclass

Place = tuple[float, float, float]

DESK_M = -0.45
"""How high the desk is, seen from the camera."""
BALL_RADIUS_M = 0.04


@dataclass(frozen=True)
class Box:
    """A brick on the desk: the middle of its bottom (m, axes of the robot), its edges (m), turned by `turn` (rad)."""

    at: tuple[float, float]
    size: Place = (0.05, 0.14, 0.05)
    turn: float = 0.0


@dataclass(frozen=True)
class Cup:
    """A cup on the desk: the middle of its bottom (m, axes of the robot), its radius and height (m)."""

    at: tuple[float, float]
    radius: float = 0.035
    height: float = 0.09


@dataclass(frozen=True)
class Plate:
    """A flat round plate on the desk, as orange as the ball: its middle (m, axes of the robot), its radius (m)."""

    at: tuple[float, float]
    radius: float = 0.065


@dataclass(frozen=True)
class Scene:
    """What there is to see at one moment. Places in the robot's axes (m): x forward, y left, z up, from the camera.

    `joints`: the twelve angles of `/robot/joint_positions` (rad); None: no arms. `pan`: how far the head is turned to
    the left (rad). `light`: 1 is a bright day, 0.3 an evening. `warm`: above 1 reddish, below 1 bluish light.
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
    """The center of a ball that lies on the desk, `forward` and `left` of the camera (m)."""
    return forward, left, DESK_M + BALL_RADIUS_M
