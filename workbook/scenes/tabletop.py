"""Generate training data for a detector: random desks with toys, and the toys' boxes in the images."""

import math
from dataclasses import dataclass
from itertools import product

import numpy as np

from workbook.scenes.desk import paint_arms
from workbook.scenes.painting import Picture
from workbook.scenes.pinhole import Pinhole
from workbook.scenes.scene import BALL_RADIUS_M, DESK_M, Box, Cup, Place, Plate, Scene, on_desk

LABELS = ("ball", "brick", "cup", "plate")
"""The labels of the objects to detect. All are orange. A blue ball is a decoy and has no label."""
APART_M = 0.17
"""The smallest distance between toys that `tabletop` puts on the desk."""
ARMS_AT_REST = (0.0, 0.0, 0.8, 0.8, 0.8, 0.8, 0.06, 0.06, 0.0, 0.06, 0.06, 0.0)


@dataclass(frozen=True)
class Thing:
    """An orange object in an image: the center and size of its upright bounding box, in pixels.

    `visible`: the fraction of the box that is inside the image and not behind an arm, from 0 to 1.
    """

    label: str
    u: float
    v: float
    width: float
    height: float
    visible: float


Spot = tuple[float, float]


def tabletop(seed: int, number: int) -> Scene:
    """Generate a random desk with up to eight objects, with or without arms, in random light.

    The same seed and number give the same desk.
    """
    dice = np.random.default_rng((seed, number))
    spots: dict[str, list[Spot]] = {kind: [] for kind in (*LABELS, "decoy")}
    for kind, spot in zip(_kinds(dice), _spots(dice), strict=False):
        spots[kind].append(spot)
    boxes = tuple(Box(spot, turn=float(dice.uniform(-math.pi / 2, math.pi / 2))) for spot in spots["brick"])
    return Scene(
        ball=on_desk(*spots["ball"][0]) if spots["ball"] else None,
        blue_ball=on_desk(*spots["decoy"][0]) if spots["decoy"] else None,
        boxes=boxes,
        joints=_arms(dice),
        light=float(dice.uniform(0.35, 1.1)),
        warm=float(dice.uniform(0.85, 1.15)),
        cups=tuple(Cup(spot) for spot in sorted(spots["cup"], reverse=True)),
        plates=tuple(Plate(spot) for spot in spots["plate"]),
    )


def _kinds(dice: np.random.Generator) -> list[str]:
    """Choose the toys at random: at most one ball and one decoy, and at most two of each other kind."""
    chosen = [kind for kind in ("ball", "decoy") if dice.random() < 0.6]
    for kind in LABELS[1:]:
        chosen += [kind] * int(dice.integers(3))
    dice.shuffle(chosen)
    return chosen


def _spots(dice: np.random.Generator, number: int = 8) -> list[Spot]:
    """Choose random spots (forward and left, m) on the desk in the camera's view, apart from each other.

    If `number` spots don't fit, return fewer.
    """
    found: list[Spot] = []
    for forward, share in dice.uniform((0.55, -0.5), (1.4, 0.5), (60, 2)):
        left = share * (forward + 0.2)
        if len(found) < number and all(math.dist((forward, left), other) >= APART_M for other in found):
            found.append((float(forward), float(left)))
    return found


def _arms(dice: np.random.Generator) -> tuple[float, ...] | None:
    if dice.random() < 0.3:
        return None
    joints = list(ARMS_AT_REST)
    joints[2:6] = (float(angle) for angle in dice.uniform(0.2, 1.1, 4))
    return tuple(joints)


def things_in(scene: Scene, pinhole: Pinhole) -> list[Thing]:
    """Return the orange objects in a scene's image, including those that are only partly visible."""
    outlines = [("brick", _corners(box)) for box in scene.boxes]
    outlines += [("cup", _rim(cup.at, cup.radius, (0.0, cup.height))) for cup in scene.cups]
    outlines += [("plate", _rim(plate.at, plate.radius, (0.0,))) for plate in scene.plates]
    found = []
    arms = _arms_mask(scene, pinhole)
    for label, points in outlines:
        pixels = [pinhole.pixel(pinhole.seen_from(point, scene.pan)) for point in points]
        found.append(_thing(label, pixels, arms))
    if scene.ball is not None:
        center = pinhole.seen_from(scene.ball, scene.pan)
        (u, v), radius = pinhole.pixel(center), pinhole.focal * BALL_RADIUS_M / float(center[2])
        found.append(_thing("ball", [(u - radius, v - radius), (u + radius, v + radius)], arms))
    return [thing for thing in found if thing.visible > 0.0]


def _corners(box: Box) -> list[Place]:
    cos, sin = math.cos(box.turn), math.sin(box.turn)
    points = []
    for one, other, up in product((-0.5, 0.5), (-0.5, 0.5), (0.0, 1.0)):
        along, across = one * box.size[0], other * box.size[1]
        x, y = box.at[0] + cos * along - sin * across, box.at[1] + sin * along + cos * across
        points.append((x, y, DESK_M + up * box.size[2]))
    return points


def _rim(at: Spot, radius: float, heights: tuple[float, ...]) -> list[Place]:
    return [
        (at[0] + radius * math.cos(turn), at[1] + radius * math.sin(turn), DESK_M + height)
        for turn in np.linspace(0.0, 2 * math.pi, 24, endpoint=False)
        for height in heights
    ]


def _arms_mask(scene: Scene, pinhole: Pinhole) -> Picture:
    """Return a mask of the image: 1 where an arm is visible, 0 elsewhere."""
    mask = np.zeros((pinhole.height, pinhole.width, 3), dtype=np.uint8)
    if scene.joints is not None:
        paint_arms(mask, pinhole, scene.joints, scene.pan)
    return (mask[..., 0] > 40).astype(np.uint8)


def _thing(label: str, pixels: list[tuple[float, float]], arms: Picture) -> Thing:
    (left, right), (top, bottom) = ((min(axis), max(axis)) for axis in zip(*pixels, strict=True))
    inside = arms[
        max(round(top), 0) : max(round(bottom) + 1, 0), max(round(left), 0) : max(round(right) + 1, 0)
    ]
    whole = (round(bottom) + 1 - round(top)) * (round(right) + 1 - round(left))
    visible = float(inside.size - inside.sum()) / whole
    return Thing(label, (left + right) / 2, (top + bottom) / 2, right - left, bottom - top, visible)
