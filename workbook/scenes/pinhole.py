"""Implement the pinhole model: project points to pixels, and pixels to directions."""

import math
from dataclasses import dataclass

import numpy as np
import numpy.typing as npt

Vector = npt.NDArray[np.float64]


@dataclass(frozen=True)
class Pinhole:
    """A camera in the head. Pixel (0, 0) is the center of the upper left pixel.

    The camera's frame follows the ROS convention for cameras: x points right, y down, z forward. In the robot's frame,
    x points forward, y left, z up. The camera is the origin of both frames. `focal`: the focal length in pixels.
    `pitch`: the camera's downward angle (rad).
    """

    width: int = 640
    height: int = 480
    focal: float = 560.0
    pitch: float = 0.5

    @property
    def center(self) -> tuple[float, float]:
        """The column and row of the image's center, which lies straight ahead of the camera."""
        return (self.width - 1) / 2, (self.height - 1) / 2

    def seen_from(self, point: tuple[float, float, float], pan: float = 0.0) -> Vector:
        """Convert a point from the robot's frame (m) to the camera's. The head is turned to the left by `pan` (rad)."""
        x, y, z = point
        ahead = x * math.cos(pan) + y * math.sin(pan)
        left = y * math.cos(pan) - x * math.sin(pan)
        down, level = math.sin(self.pitch), math.cos(self.pitch)
        return np.array([-left, -z * level - ahead * down, ahead * level - z * down])

    def pixel(self, point: Vector) -> tuple[float, float]:
        """Project a point in the camera's frame (m) to a column and a row.

        Raise ValueError if the point isn't in front of the camera.
        """
        if not point[2] > 0.0:
            raise ValueError(f"a camera sees only points in front of it (z > 0), not z = {point[2]}")
        column, row = self.center
        return float(column + self.focal * point[0] / point[2]), float(row + self.focal * point[1] / point[2])

    def direction(self, column: float, row: float) -> Vector:
        """Return the direction of a pixel's ray as a unit vector in the camera's frame."""
        middle = self.center
        ray: Vector = np.array([(column - middle[0]) / self.focal, (row - middle[1]) / self.focal, 1.0])
        ray /= np.linalg.norm(ray)
        return ray

    def on_level(
        self, column: float, row: float, height: float, pan: float = 0.0
    ) -> tuple[float, float] | None:
        """Return the point where a pixel's ray meets a horizontal plane: forward and left (m, robot's frame).

        `height`: the plane's height above the camera (m). The result is None if the ray doesn't meet the plane.
        """
        right, low, forward = self.direction(column, row)
        down, level = math.sin(self.pitch), math.cos(self.pitch)
        rise = -low * level - forward * down
        if rise * height <= 0.0:
            return None
        reach = height / rise
        ahead, left = reach * (forward * level - low * down), -reach * right
        return (
            float(ahead * math.cos(pan) - left * math.sin(pan)),
            float(ahead * math.sin(pan) + left * math.cos(pan)),
        )
