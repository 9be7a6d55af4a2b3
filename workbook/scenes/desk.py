"""Render the head camera's images of a desk with toys and the robot's own arms, in changing light."""

import math
from collections.abc import Sequence
from itertools import product

import numpy as np

from workbook.scenes.painting import Color, Patch, Picture, paint_limb, paint_polygon, paint_sphere
from workbook.scenes.pinhole import Pinhole, Vector
from workbook.scenes.scene import BALL_RADIUS_M, DESK_M, Box, Cup, Plate, Scene

DESK_EDGE_M = 1.6
ORANGE: Color = (235.0, 120.0, 25.0)
BLUE: Color = (25.0, 120.0, 235.0)
BRICK: Color = (225.0, 105.0, 25.0)
WALL: Color = (168.0, 178.0, 190.0)
DESK: Color = (146.0, 138.0, 126.0)
ARM: Color = (205.0, 208.0, 212.0)
HAND: Color = (90.0, 94.0, 100.0)
SHOULDER_M, UPPER_ARM_M, FOREARM_M, FINGER_M = (0.0, 0.2, -0.3), 0.3, 0.26, 0.07
INWARD = 0.3  # rad; the angle by which the arms are turned inward
LEFT_SHOULDER, LEFT_ELBOW, RIGHT_SHOULDER, RIGHT_ELBOW = 2, 3, 4, 5
"""The indices of these angles among the twelve of `/robot/joint_positions`."""
Corner = tuple[int, int, int]
FACES: tuple[tuple[tuple[Corner, ...], float], ...] = (
    (((1, -1, -1), (1, 1, -1), (1, 1, 1), (1, -1, 1)), 0.8),
    (((-1, -1, -1), (-1, 1, -1), (-1, 1, 1), (-1, -1, 1)), 0.8),
    (((-1, 1, -1), (1, 1, -1), (1, 1, 1), (-1, 1, 1)), 0.65),
    (((-1, -1, -1), (1, -1, -1), (1, -1, 1), (-1, -1, 1)), 0.65),
    (((-1, -1, 1), (1, -1, 1), (1, 1, 1), (-1, 1, 1)), 1.0),
)
"""The faces of a brick that can be seen from above: their corners (-1 or 1 along each axis) and brightness."""
NEAREST_M = 0.1
"""Surfaces nearer to the camera than this aren't drawn."""
RIM_CORNERS = 24
NOISE_SPARE = 65_536
"""The number of places in the table of noise at which an image's noise may begin. With this many places, two images
rarely have equal noise."""


class DeskCamera:
    """Renders images of scenes: RGB, uint8, shape (height, width, 3). The same seed and number give the same bytes.

    `noise` is the standard deviation of each pixel's noise, on the scale from 0 to 255.
    """

    def __init__(self, pinhole: Pinhole, seed: int, noise: float = 4.0) -> None:
        self.pinhole = pinhole
        self._seed = seed
        self._empty = _empty_desk(pinhole)
        dice = np.random.default_rng(seed)
        table = dice.standard_normal(self._empty.size + NOISE_SPARE, dtype=np.float32)
        self._noise = np.rint(noise * table).astype(np.int16)

    def picture(self, scene: Scene, number: int) -> Picture:
        """Render the scene as an image. `number` selects the noise."""
        picture = self._empty.copy()
        for place in (scene.ball, scene.blue_ball):
            if place is not None:
                _paint_shadow(picture, self.pinhole, self.pinhole.seen_from((*place[:2], DESK_M), scene.pan))
        for plate in scene.plates:
            _paint_plate(picture, self.pinhole, plate, scene.pan)
        for box in scene.boxes:
            _paint_box(picture, self.pinhole, box, scene.pan)
        for cup in scene.cups:
            _paint_cup(picture, self.pinhole, cup, scene.pan)
        for place, color in ((scene.blue_ball, BLUE), (scene.ball, ORANGE)):
            if place is not None:
                center = self.pinhole.seen_from(place, scene.pan)
                paint_sphere(picture, self.pinhole, center, BALL_RADIUS_M, color)
        if scene.joints is not None:
            paint_arms(picture, self.pinhole, scene.joints, scene.pan)
        return self._measured(picture, scene, number)

    def _measured(self, picture: Picture, scene: Scene, number: int) -> Picture:
        """Apply the scene's light and the sensor's noise to an image."""
        gains = np.array([scene.warm, 1.0, 1.0 / scene.warm]) * scene.light
        steps = np.rint(np.arange(256)[:, np.newaxis] * gains).astype(np.int16)
        lit = np.empty(picture.shape, dtype=np.int16)
        for channel in range(3):
            np.take(steps[:, channel], picture[..., channel], out=lit[..., channel])
        start = int(np.random.default_rng((self._seed, number)).integers(NOISE_SPARE))
        lit += self._noise[start : start + lit.size].reshape(lit.shape)
        np.clip(lit, 0, 255, out=lit)
        return lit.astype(np.uint8)


def _empty_desk(camera: Pinhole) -> Picture:
    """Paint wall and desk. The desk is round with the robot in its center, so it looks the same at every pan angle."""
    x = (np.arange(camera.width) - camera.center[0])[np.newaxis, :] / camera.focal
    y = (np.arange(camera.height) - camera.center[1])[:, np.newaxis] / camera.focal
    down = y * math.cos(camera.pitch) + math.sin(camera.pitch) + 0.0 * x
    ahead = np.hypot(x, math.cos(camera.pitch) - y * math.sin(camera.pitch))
    away = np.where(down > 1e-6, -DESK_M * ahead / np.maximum(down, 1e-6), np.inf)
    cover = np.clip((DESK_EDGE_M - np.minimum(away, 99.0)) * camera.focal / 8 + 0.5, 0.0, 1.0)[
        ..., np.newaxis
    ]
    rings = 1.0 - 0.10 * np.clip(away / DESK_EDGE_M, 0.0, 1.0)[..., np.newaxis]
    fade = 0.92 + 0.08 * np.clip(-down / 0.3, 0.0, 1.0)[..., np.newaxis]
    drawn = np.asarray(WALL) * fade * (1.0 - cover) + np.asarray(DESK) * rings * cover
    return np.rint(drawn).astype(np.uint8)


def _paint_shadow(picture: Picture, camera: Pinhole, below: Vector) -> None:
    """Paint a ball's shadow on the desk."""
    if below[2] <= NEAREST_M:
        return
    column, row = camera.pixel(below)
    wide = camera.focal * 1.1 * BALL_RADIUS_M / below[2]
    patch = Patch(picture, [(column - 2 * wide, row - 1.5 * wide), (column + 2 * wide, row + 1.5 * wide)])
    if not patch.empty:
        away = ((patch.columns - column) / wide) ** 2 + ((patch.rows - row) / (0.65 * wide)) ** 2
        patch.darken(0.45 * np.exp(-away))


def _paint_box(picture: Picture, camera: Pinhole, box: Box, pan: float) -> None:
    """Paint the faces of a brick that are turned toward the camera."""
    length, width, height = box.size
    cos, sin = math.cos(box.turn), math.sin(box.turn)
    seen: dict[Corner, Vector] = {}
    for corner in product((-1, 1), (-1, 1), (-1, 1)):
        along, across = corner[0] * length / 2, corner[1] * width / 2
        place = box.at[0] + cos * along - sin * across, box.at[1] + sin * along + cos * across
        seen[corner] = camera.seen_from((*place, DESK_M + (corner[2] + 1) * height / 2), pan)
    if min(point[2] for point in seen.values()) <= NEAREST_M:
        return
    middle = np.mean(list(seen.values()), axis=0)
    for face, bright in FACES:
        outward = np.mean([seen[corner] for corner in face], axis=0) - middle
        if outward @ seen[face[0]] < 0:
            _paint_face(picture, [camera.pixel(seen[corner]) for corner in face], bright)


def _paint_face(picture: Picture, corners: list[tuple[float, float]], bright: float) -> None:
    around = sum(
        u * v2 - u2 * v for (u, v), (u2, v2) in zip(corners, [*corners[1:], corners[0]], strict=True)
    )
    red, green, blue = BRICK
    paint_polygon(
        picture, corners if around > 0 else corners[::-1], (red * bright, green * bright, blue * bright)
    )


def _rim(
    camera: Pinhole, at: tuple[float, float], height: float, radius: float, pan: float
) -> list[tuple[float, float]]:
    """Return points, in pixels, on a horizontal circle that lies `height` m above the desk.

    The list is empty if a part of the circle isn't in front of the camera.
    """
    around = [2 * math.pi * step / RIM_CORNERS for step in range(RIM_CORNERS)]
    seen = [
        camera.seen_from(
            (at[0] + radius * math.cos(one), at[1] + radius * math.sin(one), DESK_M + height), pan
        )
        for one in around
    ]
    return [] if min(one[2] for one in seen) <= NEAREST_M else [camera.pixel(one) for one in seen]


def _shaded(color: Color, bright: float) -> Color:
    return color[0] * bright, color[1] * bright, color[2] * bright


def _paint_plate(picture: Picture, camera: Pinhole, plate: Plate, pan: float) -> None:
    """Paint a plate: a rim, and a slightly darker bottom."""
    for part, bright in ((1.0, 1.0), (0.7, 0.9)):
        corners = _rim(camera, plate.at, 0.0, part * plate.radius, pan)
        if corners:
            paint_polygon(picture, corners[::-1], _shaded(ORANGE, bright))


def _paint_cup(picture: Picture, camera: Pinhole, cup: Cup, pan: float) -> None:
    """Paint a cup: its side, as the hull of its two rims, and its dark inside."""
    low, high = (_rim(camera, cup.at, height, cup.radius, pan) for height in (0.0, cup.height))
    if low and high:
        paint_polygon(picture, _hull([*low, *high]), _shaded(ORANGE, 0.8))
        paint_polygon(picture, high[::-1], ORANGE)
        inside = _rim(camera, cup.at, cup.height, 0.85 * cup.radius, pan)
        paint_polygon(picture, inside[::-1], _shaded(ORANGE, 0.45))


def _hull(points: list[tuple[float, float]]) -> list[tuple[float, float]]:
    """Return the convex hull of some pixels, clockwise in the image."""
    ordered = sorted(points)

    def half(along: list[tuple[float, float]]) -> list[tuple[float, float]]:
        kept: list[tuple[float, float]] = []
        for u, v in along:
            while len(kept) > 1:
                (u0, v0), (u1, v1) = kept[-2:]
                if (u1 - u0) * (v - v0) - (v1 - v0) * (u - u0) > 0:
                    break
                kept.pop()
            kept.append((u, v))
        return kept[:-1]

    return half(ordered) + half(ordered[::-1])


def paint_arms(picture: Picture, camera: Pinhole, joints: Sequence[float], pan: float) -> None:
    """Paint both arms in the pose `joints` (rad). At 0, an arm hangs down; positive angles reach forward."""
    for side, shoulder, elbow in (
        (1.0, joints[LEFT_SHOULDER], joints[LEFT_ELBOW]),
        (-1.0, joints[RIGHT_SHOULDER], joints[RIGHT_ELBOW]),
    ):
        at = np.array([SHOULDER_M[0], side * SHOULDER_M[1], SHOULDER_M[2]])
        bend = at + UPPER_ARM_M * _reach(side, shoulder)
        wrist = bend + FOREARM_M * _reach(side, shoulder + elbow)
        _paint_part(picture, camera, (bend, wrist), (0.032, 0.024), ARM, pan)
        palm = wrist + 0.5 * FINGER_M * _reach(side, shoulder + elbow)
        _paint_part(picture, camera, (wrist, palm), (0.03, 0.03), HAND, pan)
        for spread in (-0.35, 0.0, 0.35):
            tip = palm + FINGER_M * _reach(side, shoulder + elbow + 0.25, spread)
            _paint_part(picture, camera, (palm, tip), (0.011, 0.008), HAND, pan)


def _reach(side: float, angle: float, spread: float = 0.0) -> Vector:
    """Return the direction of a segment of the left (1) or right (-1) arm when it's lifted by `angle` (rad).

    The result is a unit vector in the robot's frame.
    """
    inward = INWARD + spread
    return np.array(
        [math.sin(angle) * math.cos(inward), -side * math.sin(angle) * math.sin(inward), -math.cos(angle)]
    )


def _paint_part(
    picture: Picture,
    camera: Pinhole,
    ends: tuple[Vector, Vector],
    radii: tuple[float, float],
    color: Color,
    pan: float,
) -> None:
    """Paint a limb between two points in the robot's frame (m), if both are in front of the camera."""
    near, far = (camera.seen_from((end[0], end[1], end[2]), pan) for end in ends)
    if min(near[2], far[2]) <= NEAREST_M:
        return
    thick = (camera.focal * radii[0] / near[2], camera.focal * radii[1] / far[2])
    paint_limb(picture, (camera.pixel(near), camera.pixel(far)), thick, color)
