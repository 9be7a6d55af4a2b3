"""Encode images as the bytes of `sensor_msgs/Image`."""

from collections.abc import Callable

import numpy as np
import numpy.typing as npt

from workbook.scenes.painting import Picture

Rows = npt.NDArray[np.uint8]
"""The bytes of an image, as an array of shape (height, bytes per row without padding)."""


def encoded(picture: Picture, encoding: str, padding: int = 0) -> tuple[bytes, int]:
    """Return the bytes of `Image.data`, and `step`, which is the length of a row in bytes.

    Each row ends with `padding` unused bytes. 16-bit numbers are little-endian. Raise ValueError if the encoding isn't
    in `ENCODINGS`.
    """
    if encoding not in _ROWS:
        raise ValueError(f"one of {', '.join(ENCODINGS)}, not {encoding!r}")
    rows = _ROWS[encoding](picture)
    height, length = rows.shape
    padded: Rows = np.full((height, length + padding), 0xAA, dtype=np.uint8)
    padded[:, :length] = rows
    return padded.tobytes(), length + padding


def _gray(picture: Picture) -> npt.NDArray[np.float64]:
    weighted: npt.NDArray[np.float64] = picture @ np.array([0.299, 0.587, 0.114])
    return weighted


def _in_rgb(picture: Picture) -> Rows:
    return picture.reshape(picture.shape[0], -1)


def _in_bgr(picture: Picture) -> Rows:
    return picture[..., ::-1].reshape(picture.shape[0], -1)


def _in_rgba(picture: Picture) -> Rows:
    """Encode each pixel's red, green, and blue, and an alpha byte that means opaque."""
    opaque: Rows = np.dstack([picture, np.full(picture.shape[:2], 255, np.uint8)])
    return opaque.reshape(picture.shape[0], -1)


def _in_8_bits(picture: Picture) -> Rows:
    return np.rint(_gray(picture)).astype(np.uint8)


def _in_16_bits(picture: Picture) -> Rows:
    return np.rint(257 * _gray(picture)).astype("<u2").view(np.uint8)


def _in_yuv(picture: Picture) -> Rows:
    """Encode each pixel's brightness (Y), and one blue (U) and one red (V) difference per pair of pixels: Y U Y V."""
    bright = _gray(picture)
    pairs = np.empty((*bright.shape, 2))
    pairs[..., 0] = bright
    pairs[:, 0::2, 1] = 0.564 * (picture[:, 0::2, 2] - bright[:, 0::2]) + 128
    pairs[:, 1::2, 1] = 0.713 * (picture[:, 0::2, 0] - bright[:, 0::2]) + 128
    rows: Rows = np.rint(np.clip(pairs, 0, 255)).astype(np.uint8).reshape(bright.shape[0], -1)
    return rows


_ROWS: dict[str, Callable[[Picture], Rows]] = {
    "rgb8": _in_rgb,
    "bgr8": _in_bgr,
    "8UC3": _in_bgr,  # OpenCV's name for three bytes per pixel; it doesn't specify the colors
    "rgba8": _in_rgba,
    "mono8": _in_8_bits,
    "mono16": _in_16_bits,
    "yuv422_yuy2": _in_yuv,
}
ENCODINGS = tuple(_ROWS)
