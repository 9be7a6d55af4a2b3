"""Make short films from frames, for pages and notebooks. The films play without scripts."""

import io
from collections.abc import Sequence

from PIL import Image

EFFORT = 30
"""The effort of the WebP encoder, out of 100. A higher value hardly shrinks the file, but takes longer."""
COLORS = 128
"""The number of colors in an animated PNG: enough for drawings, which have few colors and smooth edges."""
LAST_MS = 2500
"""The time (ms) for which an animated PNG shows its last frame before it starts again."""
PHOTO_QUALITY = 55


def film(pictures: Sequence[bytes], *, per_second: float, exact: bool = True) -> bytes:
    """Return an animated WebP made from PNG frames of the same size. It plays once, and stops at its last frame.

    `exact`: keep every pixel unchanged, which suits drawings. Without it, camera images take much less space. Raises
    ValueError if there are no frames.
    """
    if not pictures:
        raise ValueError("a film needs at least one frame")
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
    """Return an animated PNG, which plays in a loop, even on code-hosting sites that show the notebook.

    All frames share 128 colors, and only changed pixels are stored. `durations_ms`: the time (ms) to show each frame;
    without it, `per_second` frames are shown per second. Raises ValueError if there are no frames.
    """
    if not pictures:
        raise ValueError("a film needs at least one frame")
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
