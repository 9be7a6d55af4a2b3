"""The detector as a robot has it: on an accelerator that takes its time, and that gives up on some pictures."""

import threading
import time

import numpy as np
import numpy.typing as npt

from workbook.models import DeskDetector, Detection

WHITE = 250
"""From this value on, a channel of a pixel counts as white."""


class SlowDetector:
    """`DeskDetector` on a slow accelerator: one second to load, then 0.2 s for each picture, one at a time.

    It waits for the accelerator without holding the GIL: other threads of the program run meanwhile. Whoever calls it
    while it is busy waits for its turn.
    """

    LOADING_S = 1.0
    SECONDS = 0.2
    GLARE = 0.5
    """It gives up on a picture of which so much is white."""
    _accelerator = threading.Lock()

    def __init__(self) -> None:
        began = time.monotonic()
        self._detector = DeskDetector()
        _wait_until(began + self.LOADING_S)

    def __call__(self, image: npt.NDArray[np.uint8]) -> list[Detection]:
        """What is on the desk, the surest first. `image`: RGB, uint8, shape (height, width, 3).

        Raises RuntimeError for a picture with glare, and ValueError for another shape or another type of number.
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
