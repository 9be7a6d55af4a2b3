"""A short film from pictures, for a page: it plays once, needs no script, and stays on its last picture."""

import io
from collections.abc import Sequence

from PIL import Image

EFFORT = 30
"""Of 100. More makes the file hardly smaller, and takes longer."""
COLORS = 128
"""In an animated PNG: enough for drawings, which have few colors and smooth edges."""
LAST_MS = 2500
"""How long the last picture of an animated PNG stands before the film begins again."""
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


def moving_png(
    pictures: Sequence[bytes],
    *,
    dots_per_pixel: float,
    per_second: float = 8.0,
    durations_ms: Sequence[int] | None = None,
) -> bytes:
    """The film as an animated PNG, which also moves where a page of code shows a notebook. It plays again and again.

    All pictures share 128 colors, and only what changes is stored. `durations_ms`: how long each of them stands;
    without it, `per_second` of them are shown. Raises ValueError when there are none.
    """
    if not pictures:
        raise ValueError("a film needs at least one picture")
    frames = [Image.open(io.BytesIO(picture)).convert("RGBA") for picture in pictures]
    width, height = frames[0].size
    sheet = Image.new("RGBA", (width, height * len(frames)))
    for place, frame in enumerate(frames):
        sheet.paste(frame, (0, place * height))
    sheet = sheet.quantize(COLORS, method=Image.Quantize.FASTOCTREE, dither=Image.Dither.NONE)
    tops = range(0, sheet.height, height)
    first, *later = (sheet.crop((0, top, width, top + height)) for top in tops)
    file = io.BytesIO()
    durations = list(durations_ms or [round(1000 / per_second)] * len(later) + [LAST_MS])
    first.save(
        file,
        "PNG",
        save_all=True,
        append_images=later,
        duration=durations,
        loop=0,
        blend=0,
        dpi=(96 * dots_per_pixel,) * 2,
    )
    return file.getvalue()
