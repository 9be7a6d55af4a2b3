"""Simulate the detector as it runs on a robot, on a slow accelerator that rejects some images."""

import threading
import time

import numpy as np
import numpy.typing as npt

from workbook.models import DeskDetector, Detection

WHITE = 250
"""A pixel counts as white if each of its channels has at least this value."""


class SlowDetector:
    """`DeskDetector` on a slow accelerator that takes 1 s to load and then 0.2 s per image.

    A call waits for the accelerator without holding the GIL, so the program's other threads keep running. The
    accelerator processes one image at a time, so calls from several threads wait for one another.
    """

    LOADING_S = 1.0
    SECONDS = 0.2
    GLARE = 0.5
    """An image with at least this fraction of white pixels is rejected."""
    _accelerator = threading.Lock()

    def __init__(self) -> None:
        began = time.monotonic()
        self._detector = DeskDetector()
        _wait_until(began + self.LOADING_S)

    def __call__(self, image: npt.NDArray[np.uint8]) -> list[Detection]:
        """Return the detections in an image, highest score first. `image`: see `to_input`.

        Raises RuntimeError if the image has too much glare, and ValueError if it has the wrong shape or type.
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
