"""Show films of camera images, alone or next to a drawing of the robot's head. The notebook stores the films."""

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
"""The height on the page, in pixels, to which camera images are scaled."""


def with_head(picture: Pixels, neck: float, ball: tuple[float, float] | None, camera: Pinhole) -> bytes:
    """Draw the head camera's RGB image with its center line, next to a view of the head from above. Return PNG bytes.

    `neck`: the head's angle to the left (rad). `ball`: the ball's column and row, in pixels of the `camera`, whose
    resolution may be higher than the image's, or None if there's no ball.
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
    """Convert an RGB camera image to PNG bytes, scaled to `HEIGHT`."""
    return _png(_of_height(Image.fromarray(picture)))


def show_film(pictures: Sequence[bytes], description: str, per_second: float = 10.0) -> None:
    """Show PNG images as a film in the cell, with `per_second` images per second.

    `description` is the alternative text. Keep measured numbers out of it, because they vary from run to run.
    """
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
