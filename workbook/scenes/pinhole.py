"""The pinhole model: where a point in front of a camera is seen, and where a pixel looks."""

import math
from dataclasses import dataclass

import numpy as np
import numpy.typing as npt

Vector = npt.NDArray[np.float64]


@dataclass(frozen=True)
class Pinhole:
    """A camera in the head. Pixel (0, 0) is the middle of the pixel at the upper left.

    Its own axes are those of ROS for cameras: x to the right, y down, z forward. The robot's are x forward, y to the
    left, z up, and both begin in the camera. `focal`: the focal length in pixels. `pitch`: how far it looks down (rad).
    """

    width: int = 640
    height: int = 480
    focal: float = 560.0
    pitch: float = 0.5

    @property
    def center(self) -> tuple[float, float]:
        """The pixel that looks straight ahead: column, row."""
        return (self.width - 1) / 2, (self.height - 1) / 2

    def seen_from(self, point: tuple[float, float, float], pan: float = 0.0) -> Vector:
        """A point of the robot's axes (m) in those of the camera; the head is turned to the left by `pan` (rad)."""
        x, y, z = point
        ahead = x * math.cos(pan) + y * math.sin(pan)
        left = y * math.cos(pan) - x * math.sin(pan)
        down, level = math.sin(self.pitch), math.cos(self.pitch)
        return np.array([-left, -z * level - ahead * down, ahead * level - z * down])

    def pixel(self, point: Vector) -> tuple[float, float]:
        """Column and row where a point of the camera's axes is seen. Raises ValueError for one that is not in front."""
        if not point[2] > 0.0:
            raise ValueError(f"a camera sees what is in front of it (z > 0), not z = {point[2]}")
        column, row = self.center
        return float(column + self.focal * point[0] / point[2]), float(row + self.focal * point[1] / point[2])

    def direction(self, column: float, row: float) -> Vector:
        """Where a pixel looks: a vector of length 1 in the axes of the camera."""
        middle = self.center
        ray: Vector = np.array([(column - middle[0]) / self.focal, (row - middle[1]) / self.focal, 1.0])
        ray /= np.linalg.norm(ray)
        return ray

    def on_level(
        self, column: float, row: float, height: float, pan: float = 0.0
    ) -> tuple[float, float] | None:
        """Where the ray of a pixel meets a level plane: how far ahead and to the left (m, axes of the robot).

        `height`: that of the plane, seen from the camera (m). None if the ray does not meet it.
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
