"""Draw a detector's boxes into images, for the lessons' films and figures."""

import io
from collections.abc import Mapping, Sequence

from matplotlib import font_manager
from PIL import Image, ImageDraw, ImageFont

from workbook.models import Detection
from workbook.pictures.figures import figure, still
from workbook.pictures.png import Pixels
from workbook.pictures.stills import Still

HEIGHT = 270
"""The height on the page, in pixels. Images are scaled to it before boxes are drawn."""
WHITE, INK = (255, 255, 255), (20, 20, 20)
MARGIN = 3
Frame = tuple[float, float, float, float]
"""Left, top, right, and bottom, in pixels."""


def boxed(picture: Pixels, detections: Sequence[Detection], scores: bool = False) -> bytes:
    """Draw a labeled box for each detection into an RGB image, and return PNG bytes.

    A label stands above its box, or below it if it would cover another label. With `scores`, it includes the score.
    """
    factor = HEIGHT / picture.shape[0]
    drawn = Image.fromarray(picture).resize((round(factor * picture.shape[1]), HEIGHT))
    pen = ImageDraw.Draw(drawn)
    font = ImageFont.truetype(font_manager.findfont("DejaVu Sans"), 13)
    taken: list[Frame] = []
    for one in detections:
        left, top = factor * (one.u - one.width / 2) - MARGIN, factor * (one.v - one.height / 2) - MARGIN
        right, bottom = factor * (one.u + one.width / 2) + MARGIN, factor * (one.v + one.height / 2) + MARGIN
        pen.rectangle((left, top, right, bottom), outline=WHITE, width=2)
        words = f"{one.label} {one.score:.2f}" if scores else one.label
        places = ((max(left, 1.0), top - 4, "ld"), (max(left, 1.0), bottom + 5, "la"))
        frames = [_around(pen.textbbox((x, y), words, font=font, anchor=anchor)) for x, y, anchor in places]
        at = next(
            (at for at, frame in enumerate(frames) if not any(_overlap(frame, one) for one in taken)), 0
        )
        x, y, anchor = places[at]
        taken.append(frames[at])
        pen.rectangle(frames[at], fill=INK)
        pen.text((x, y), words, fill=WHITE, font=font, anchor=anchor)
    file = io.BytesIO()
    drawn.save(file, "PNG")
    return file.getvalue()


def in_a_row(pictures: Mapping[str, bytes], description: str) -> Still:
    """Show PNG images next to each other, each below its title.

    `pictures`: PNG bytes by title. `description`: the alternative text.
    """
    fig, panels = figure(7.6, 3.1, columns=len(pictures))
    for axes, (title, png) in zip(panels, pictures.items(), strict=True):
        axes.imshow(Image.open(io.BytesIO(png)))
        axes.set_title(title)
        axes.set_axis_off()
    return still(fig, description)


def _around(frame: Frame) -> Frame:
    left, top, right, bottom = frame
    return left - 1, top - 1, right + 1, bottom + 1


def _overlap(one: Frame, other: Frame) -> bool:
    return one[0] < other[2] and other[0] < one[2] and one[1] < other[3] and other[1] < one[3]
