"""Pictures with the boxes of a detector, for films and figures of lessons."""

import io
from collections.abc import Sequence

from matplotlib import font_manager
from PIL import Image, ImageDraw, ImageFont

from workbook.models import Detection
from workbook.pictures.png import Pixels

HEIGHT = 270
"""Pixels of the page. A picture is brought to this height before boxes are drawn into it."""
WHITE, INK = (255, 255, 255), (20, 20, 20)
MARGIN = 3


def boxed(picture: Pixels, detections: Sequence[Detection], scores: bool = False) -> bytes:
    """A picture, RGB, with a box and a label for each detection, and its score if asked for, as PNG bytes."""
    factor = HEIGHT / picture.shape[0]
    drawn = Image.fromarray(picture).resize((round(factor * picture.shape[1]), HEIGHT))
    pen = ImageDraw.Draw(drawn)
    font = ImageFont.truetype(font_manager.findfont("DejaVu Sans"), 13)
    for one in detections:
        left, top = factor * (one.u - one.width / 2) - MARGIN, factor * (one.v - one.height / 2) - MARGIN
        right, bottom = factor * (one.u + one.width / 2) + MARGIN, factor * (one.v + one.height / 2) + MARGIN
        pen.rectangle((left, top, right, bottom), outline=WHITE, width=2)
        words = f"{one.label} {one.score:.2f}" if scores else one.label
        place = max(left, 1.0), top - 4
        frame = pen.textbbox(place, words, font=font, anchor="ld")
        pen.rectangle((frame[0] - 1, frame[1] - 1, frame[2] + 1, frame[3] + 1), fill=INK)
        pen.text(place, words, fill=WHITE, font=font, anchor="ld")
    file = io.BytesIO()
    drawn.save(file, "PNG")
    return file.getvalue()
