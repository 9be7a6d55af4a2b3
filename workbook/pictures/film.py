"""A short film from pictures, for a page: it plays once, needs no script, and stays on its last picture."""

import io
from collections.abc import Sequence

from PIL import Image

EFFORT = 30
"""Of 100. More makes the file hardly smaller, and takes longer."""
PHOTO_QUALITY = 55


def film(pictures: Sequence[bytes], *, per_second: float, exact: bool = True) -> bytes:
    """The film as an animated WebP, from PNG pictures of one size. Raises ValueError when there are none.

    `exact`: every pixel stays as it is, which suits drawings. Pictures of a camera are much smaller without that.
    """
    if not pictures:
        raise ValueError("a film needs at least one picture")
    frames = [Image.open(io.BytesIO(picture)).convert("RGBA") for picture in pictures]
    file = io.BytesIO()
    first, *later = frames
    first.save(
        file,
        "WEBP",
        save_all=True,
        append_images=later,
        duration=round(1000 / per_second),
        loop=1,
        lossless=exact,
        quality=EFFORT if exact else PHOTO_QUALITY,
        method=1,
    )
    return file.getvalue()
