"""Images with the boxes of a detector."""

import io

import numpy as np
from PIL import Image

from workbook.lesson.toys import HEIGHT, boxed
from workbook.models import Detection


def test_a_box_is_drawn_around_a_detection_and_nothing_changes_without_one() -> None:
    picture = np.full((120, 160, 3), 100, np.uint8)
    one = Detection("cup", 0.9, 80.0, 60.0, 40.0, 20.0)
    with_box, without = (
        np.asarray(Image.open(io.BytesIO(boxed(picture, found, scores=True)))) for found in ([one], [])
    )
    assert with_box.shape == (HEIGHT, 360, 3)
    assert (without == 100).all()
    assert (with_box[135, 180] == 100).all()  # the middle of the box
    assert (with_box[135, 130:140] == 255).any()  # its left edge, at 2.25 * 60 - 3


def test_a_label_that_would_cover_another_one_stands_below_its_box() -> None:
    picture = np.full((120, 160, 3), 100, np.uint8)
    apart = [Detection("cup", 0.9, 40.0, 60.0, 12.0, 12.0), Detection("brick", 0.9, 110.0, 60.0, 12.0, 12.0)]
    close = [apart[0], Detection("brick", 0.9, 58.0, 60.0, 12.0, 12.0)]
    below = [
        np.asarray(Image.open(io.BytesIO(boxed(picture, found, scores=True))))[152:]
        for found in (apart, close)
    ]
    assert (below[0] == 100).all()
    assert (below[1] == 255).any()
