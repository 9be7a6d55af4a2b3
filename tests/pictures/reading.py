"""Read images back: what tests can find in them."""

import io

import numpy as np
import numpy.typing as npt
from PIL import Image

Pixels = npt.NDArray[np.int16]


def pixels(png: bytes) -> Pixels:
    """Return RGBA, shape (height, width, 4), signed so that differences can't overflow."""
    return np.asarray(Image.open(io.BytesIO(png)).convert("RGBA")).astype(np.int16)


def drawn(png: bytes) -> npt.NDArray[np.bool_]:
    """Return where the image is not transparent."""
    return pixels(png)[..., 3] > 60


def changed(one: bytes, other: bytes) -> npt.NDArray[np.bool_]:
    """Return where two images of the same size differ visibly."""
    found: npt.NDArray[np.bool_] = np.abs(pixels(one) - pixels(other)).max(axis=2) > 40
    return found


def colored(png: bytes, color: str, tolerance: int = 14) -> npt.NDArray[np.bool_]:
    """Return where the image is opaque and has this color (`#rrggbb`)."""
    rgb = np.array([int(color[at : at + 2], 16) for at in (1, 3, 5)])
    image = pixels(png)
    found: npt.NDArray[np.bool_] = (np.abs(image[..., :3] - rgb).max(axis=2) <= tolerance) & (
        image[..., 3] > 200
    )
    return found


def reddish(png: bytes, alpha: int = 30) -> npt.NDArray[np.bool_]:
    """Return where the image is red, even if only slightly."""
    image = pixels(png)
    return (
        (image[..., 0] - image[..., 1] > 80) & (image[..., 0] - image[..., 2] > 80) & (image[..., 3] >= alpha)
    )
