"""Measure a detector's accuracy on images that weren't used for training."""

from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

from workbook.models.detection import Detection
from workbook.models.networks import HEIGHT, WIDTH
from workbook.scenes.desk import DeskCamera
from workbook.scenes.painting import Picture
from workbook.scenes.pinhole import Pinhole
from workbook.scenes.tabletop import Thing, tabletop, things_in

SEED_HELD_BACK = 1616
"""A different seed than in training, so that no image is used for both training and testing."""
IMAGES_HELD_BACK = 400
CLEARLY_VISIBLE = 0.6
BARELY_VISIBLE = 0.25
PINHOLE = Pinhole(WIDTH, HEIGHT, 0.875 * WIDTH)
SAME_PLACE = 0.5
"""A detection matches an object if their centers are at most half a width and half a height apart."""


@dataclass(frozen=True)
class Accuracy:
    """A detector's accuracy on a set of images.

    `right`: the number of correct detections, divided by the sum of correct, missed, and false detections. `found`: the
    fraction of objects that were detected. `false`: the number of detections per image that don't match any object.
    """

    right: float
    found: float
    false: float

    def words(self) -> str:
        """Return the three numbers as a line of text."""
        return f"right {self.right:.1%}, found {self.found:.1%}, {self.false:.3f} false detections per image"


def held_back(number: int) -> Picture:
    """Return one of the RGB images on which `accuracy` tests a detector."""
    return DeskCamera(PINHOLE, SEED_HELD_BACK).picture(tabletop(SEED_HELD_BACK, number), number)


def accuracy(
    detector: Callable[[Picture], list[Detection]],
    images: int = IMAGES_HELD_BACK,
    change: Callable[[Picture], Any] = lambda picture: picture,
) -> Accuracy:
    """Return the detector's accuracy on this many held-back images. `change` converts each image first."""
    camera = DeskCamera(PINHOLE, SEED_HELD_BACK)
    things, hits, wrong = 0, 0, 0
    for number in range(images):
        scene = tabletop(SEED_HELD_BACK, number)
        there = things_in(scene, PINHOLE)
        found = detector(change(camera.picture(scene, number)))
        asked = [thing for thing in there if thing.visible >= CLEARLY_VISIBLE]
        shown = [thing for thing in there if thing.visible >= BARELY_VISIBLE]
        things += len(asked)
        hits += sum(any(matches(one, thing) for one in found) for thing in asked)
        wrong += sum(not any(matches(one, thing) for thing in shown) for one in found)
    return Accuracy(hits / (things + wrong), hits / things, wrong / images)


def matches(detection: Detection, thing: Thing) -> bool:
    """Return whether a detection has the same label as an object, and nearly the same center (see `SAME_PLACE`)."""
    return (
        detection.label == thing.label
        and abs(detection.u - thing.u) <= SAME_PLACE * thing.width
        and abs(detection.v - thing.v) <= SAME_PLACE * thing.height
    )
