"""Films of lessons: pictures of a camera, alone or next to the robot's head, that play in the page and stay there."""

import base64
import io
from collections.abc import Sequence

from PIL import Image

from workbook.pictures import head_above
from workbook.pictures.film import film
from workbook.pictures.png import Pixels
from workbook.scenes.pinhole import Pinhole
from workbook.scenes.scene import BALL_RADIUS_M, DESK_M
from workbook.templating import render

HEIGHT = 240
"""Pixels of the page. A picture of a camera is brought to this height."""


def with_head(picture: Pixels, neck: float, ball: tuple[float, float] | None, camera: Pinhole) -> bytes:
    """A picture of the camera in the head, RGB, with its center line, and the head from above, as PNG bytes.

    `neck`: how far the head is turned to the left (rad). `ball`: its column and row in pixels of the `camera`, which
    may be larger than the picture; None if it is not there.
    """
    marked = picture.copy()
    marked[:, marked.shape[1] // 2] = 255
    place = None if ball is None else camera.on_level(*ball, DESK_M + BALL_RADIUS_M, neck)
    left = _of_height(Image.fromarray(marked))
    right = _of_height(Image.open(io.BytesIO(head_above.draw(neck, place))))
    both = Image.new("RGBA", (left.width + right.width + 10, HEIGHT))
    both.paste(left, (0, 0))
    both.paste(right, (left.width + 10, 0))
    return _png(both)


def alone(picture: Pixels) -> bytes:
    """A picture of a camera, RGB, as PNG bytes."""
    return _png(_of_height(Image.fromarray(picture)))


def show_film(pictures: Sequence[bytes], description: str, per_second: float = 10.0) -> None:
    """Show PNG pictures one after another, in the cell, with alternative text. Keep numbers out of it."""
    from IPython.display import display

    moving = film(pictures, per_second=per_second, exact=False)
    with Image.open(io.BytesIO(pictures[-1])) as last:
        width, height = last.size
    src = "data:image/webp;base64," + base64.b64encode(moving).decode("ascii")
    page = render("pictures/img", alt=description, width=width, height=height, src=src)
    display({"text/plain": f"Film: {description}", "text/html": page}, raw=True)


def _of_height(picture: Image.Image) -> Image.Image:
    return picture.resize((round(picture.width * HEIGHT / picture.height), HEIGHT)).convert("RGBA")


def _png(picture: Image.Image) -> bytes:
    file = io.BytesIO()
    picture.save(file, "PNG")
    return file.getvalue()
