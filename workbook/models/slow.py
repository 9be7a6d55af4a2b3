"""Simulate the detector on a robot: on a slow accelerator that rejects some images."""

import threading
import time

import numpy as np
import numpy.typing as npt

from workbook.models import DeskDetector, Detection

WHITE = 250
"""A pixel's channel counts as white from this value on."""


class SlowDetector:
    """`DeskDetector` on a slow accelerator: one second to load, then 0.2 s per image, one at a time.

    It waits for the accelerator without holding the GIL, so the program's other threads keep running. Calls from
    several threads wait for one another.
    """

    LOADING_S = 1.0
    SECONDS = 0.2
    GLARE = 0.5
    """The share of white pixels from which an image is rejected."""
    _accelerator = threading.Lock()

    def __init__(self) -> None:
        began = time.monotonic()
        self._detector = DeskDetector()
        _wait_until(began + self.LOADING_S)

    def __call__(self, image: npt.NDArray[np.uint8]) -> list[Detection]:
        """Return the detections on the desk, highest score first. `image`: RGB, uint8, shape (height, width, 3).

        Raises RuntimeError for an image with glare, and ValueError for another shape or number type.
        """
        with self._accelerator:
            began = time.monotonic()
            found = self._detector(image)
            glare = float(np.mean(image.min(axis=2) >= WHITE))
            _wait_until(began + self.SECONDS)
        if glare >= self.GLARE:
            raise RuntimeError(f"glare: {glare:.0%} of the picture is white")
        return found


def _wait_until(moment: float) -> None:
    time.sleep(max(0.0, moment - time.monotonic()))
