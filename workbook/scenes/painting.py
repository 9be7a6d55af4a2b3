"""Paint shapes with smooth edges into an image: a partly covered pixel gets only a part of the shape's color."""

from collections.abc import Sequence

import numpy as np
import numpy.typing as npt

from workbook.scenes.pinhole import Pinhole, Vector

Picture = npt.NDArray[np.uint8]
Array = npt.NDArray[np.float64]
Color = tuple[float, float, float]
Point = tuple[float, float]


class Patch:
    """The rectangle of an image that contains a shape. `columns` and `rows` are its pixels' coordinates, as arrays."""

    def __init__(self, picture: Picture, corners: Sequence[Point], margin: float = 2.0) -> None:
        columns, rows = zip(*corners, strict=True)
        height, width = picture.shape[:2]
        left, right = (int(np.clip(x, 0, width)) for x in (min(columns) - margin, max(columns) + margin + 1))
        top, bottom = (int(np.clip(y, 0, height)) for y in (min(rows) - margin, max(rows) + margin + 1))
        self._pixels = picture[top:bottom, left:right]
        self.columns = np.arange(left, right, dtype=np.float64)[np.newaxis, :]
        self.rows = np.arange(top, bottom, dtype=np.float64)[:, np.newaxis]

    @property
    def empty(self) -> bool:
        """Whether the shape is outside the image."""
        return self._pixels.size == 0

    def blend(self, cover: Array, color: Array | Color) -> None:
        """Blend a color into each pixel by `cover`, from 0 (none) to 1 (only the color)."""
        part = np.clip(cover, 0.0, 1.0)[..., np.newaxis]
        mixed = self._pixels * (1.0 - part) + np.asarray(color) * part
        self._pixels[...] = np.rint(np.clip(mixed, 0.0, 255.0))

    def darken(self, by: Array) -> None:
        """Darken each pixel `by` a fraction from 0 to 1."""
        self._pixels[...] = np.rint(self._pixels * (1.0 - by[..., np.newaxis]))


def paint_sphere(picture: Picture, camera: Pinhole, center: Vector, radius: float, color: Color) -> None:
    """Paint a ball as a pinhole camera sees it. `center` is in the camera's frame (m). Light comes from above."""
    if center[2] <= radius:
        return
    column, row = camera.pixel(center)
    half = 1.2 * camera.focal * radius / (center[2] - radius)
    patch = Patch(picture, [(column - half, row - half), (column + half, row + half)])
    if patch.empty:
        return
    x = np.broadcast_to(
        (patch.columns - camera.center[0]) / camera.focal, (patch.rows.size, patch.columns.size)
    )
    y = np.broadcast_to((patch.rows - camera.center[1]) / camera.focal, x.shape)
    length = np.sqrt(x * x + y * y + 1.0)
    along = (x * center[0] + y * center[1] + center[2]) / length
    beside = np.sqrt(np.maximum(center @ center - along * along, 0.0))  # m, from the ray to the center
    pixel_m = along / (camera.focal * length)
    hit = along - np.sqrt(np.maximum(radius * radius - beside * beside, 0.0))
    up = (center[1] - y * hit / length) / radius  # the surface's height: 1 at the top, -1 at the bottom
    bright = 0.72 + 0.28 * np.clip(up, -1.0, 1.0)
    patch.blend((radius - beside) / pixel_m + 0.5, bright[..., np.newaxis] * np.asarray(color))


def paint_limb(picture: Picture, ends: tuple[Point, Point], radii: tuple[float, float], color: Color) -> None:
    """Paint a straight limb with round ends.

    `ends`: the centers of the ends, in pixels. `radii`: the radius at each end, in pixels.
    """
    (u, v), (u2, v2) = ends
    thick = max(radii)
    patch = Patch(
        picture,
        [(u - thick, v - thick), (u + thick, v + thick), (u2 - thick, v2 - thick), (u2 + thick, v2 + thick)],
    )
    if patch.empty:
        return
    du, dv = u2 - u, v2 - v
    along = ((patch.columns - u) * du + (patch.rows - v) * dv) / max(du * du + dv * dv, 1e-9)
    along = np.clip(along, 0.0, 1.0)
    beside = np.hypot(patch.columns - u - along * du, patch.rows - v - along * dv)
    radius = radii[0] + along * (radii[1] - radii[0])
    bright = 0.75 + 0.25 * np.sqrt(np.clip(1.0 - (beside / np.maximum(radius, 1e-9)) ** 2, 0.0, 1.0))
    patch.blend(radius - beside + 0.5, bright[..., np.newaxis] * np.asarray(color))


def paint_polygon(picture: Picture, corners: Sequence[Point], color: Color) -> None:
    """Paint a convex polygon. Its corners (pixels) are in clockwise order in the image."""
    patch = Patch(picture, corners)
    if patch.empty:
        return
    inside = np.full((patch.rows.size, patch.columns.size), np.inf)
    for (u, v), (u2, v2) in zip(corners, [*corners[1:], corners[0]], strict=True):
        du, dv = u2 - u, v2 - v
        length = max(float(np.hypot(du, dv)), 1e-9)
        inside = np.minimum(inside, ((patch.rows - v) * du - (patch.columns - u) * dv) / length)
    patch.blend(inside + 0.5, color)
