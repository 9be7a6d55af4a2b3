"""Encode pixels as PNG bytes, read their size, and embed them in a page."""

import base64
import io
import struct

import numpy as np
import numpy.typing as npt
from PIL import Image

from workbook.templating import render

Pixels = npt.NDArray[np.uint8]

UNSEEN = 24
"""The largest change of a pixel's channel, out of 255, that is invisible at an edge."""

SIGNATURE = b"\x89PNG\r\n\x1a\n"


def encode(pixels: Pixels, *, dots_per_pixel: float = 1.0) -> bytes:
    """Encode RGBA pixels of shape (height, width, 4) as a PNG, and return its bytes.

    The colors are reduced to 256, which is invisible in drawings and cuts the file to a quarter of its size. Equal
    pixels give equal bytes. `dots_per_pixel` is stored in the file as its resolution: 2 for an image drawn at twice its
    size on screen.
    """
    return _bytes(_in_few_colors(pixels), dots_per_pixel, compress_level=4)


def encode_faithfully(pixels: Pixels, *, dots_per_pixel: float = 1.0) -> bytes:
    """Encode like `encode`, but keep all colors if the difference would be visible, as in a photo or a color map."""
    drawn = _in_few_colors(pixels)
    shown = np.asarray(drawn.convert("RGBA"))
    changed = (shown != pixels).any(axis=2)
    before, after = _over_grey(pixels[changed]), _over_grey(shown[changed])
    if np.abs(before - after).max(initial=0) <= UNSEEN:
        return _bytes(drawn, dots_per_pixel, compress_level=4)
    return _bytes(Image.fromarray(pixels), dots_per_pixel, compress_level=6)


def _in_few_colors(pixels: Pixels) -> Image.Image:
    if pixels.ndim != 3 or pixels.shape[2] != 4:
        raise ValueError(f"pixels must be RGBA, shape (height, width, 4); this is {pixels.shape}")
    image = Image.fromarray(np.ascontiguousarray(pixels))
    return image.quantize(256, method=Image.Quantize.FASTOCTREE, dither=Image.Dither.NONE)


def _bytes(image: Image.Image, dots_per_pixel: float, compress_level: int) -> bytes:
    file = io.BytesIO()
    dots_per_inch = 96 * dots_per_pixel
    image.save(file, "PNG", compress_level=compress_level, dpi=(dots_per_inch, dots_per_inch))
    return file.getvalue()


def _over_grey(pixels: Pixels) -> npt.NDArray[np.int16]:
    wide = pixels.astype(np.int16)
    opaque = wide[..., 3:]
    over: npt.NDArray[np.int16] = (wide[..., :3] - 128) * opaque // 255
    return over


def size(png: bytes) -> tuple[int, int]:
    """Return the width and height of a PNG in its own dots. Raises ValueError if the bytes aren't a PNG."""
    if png[:8] != SIGNATURE or png[12:16] != b"IHDR":
        raise ValueError("these bytes are not a PNG image")
    width, height = struct.unpack(">II", png[16:24])
    return int(width), int(height)


def size_on_screen(png: bytes) -> tuple[int, int]:
    """Return the width and height in page pixels: the size in dots divided by the resolution stored in the file."""
    width, height = size(png)
    at = png.find(b"pHYs", 8, 2048)
    if at < 0:
        return width, height
    per_meter, _, unit = struct.unpack(">IIB", png[at + 4 : at + 13])
    scale = per_meter * 0.0254 / 96 if unit == 1 and per_meter else 1.0
    return round(width / scale), round(height / scale)


def data_uri(png: bytes) -> str:
    """Return the image as text for `src="…"`. JupyterLab shows it even in untrusted notebooks."""
    return "data:image/png;base64," + base64.b64encode(png).decode("ascii")


def img_tag(png: bytes, alt: str) -> str:
    """Return an `<img>` tag that shows the image at its intended size, with alternative text."""
    width, height = size_on_screen(png)
    return render("pictures/img", alt=alt, width=width, height=height, src=data_uri(png))
