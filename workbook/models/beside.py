"""Define functions that a node runs in a process pool.

A process that is started with `spawn` imports its functions by name. They're in a module, because a process can't
import them from a notebook cell.
"""

import ctypes
import time

import numpy as np
import numpy.typing as npt

from workbook.models import DeskDetector, Detection

_loaded: list[DeskDetector] = []


def load(takes_s: float = 0.0) -> None:
    """Load this process's detector, and take at least `takes_s` seconds for it, as if the model were large."""
    done = time.monotonic() + takes_s
    _loaded[:] = [DeskDetector()]
    time.sleep(max(0.0, done - time.monotonic()))


def look(image: npt.NDArray[np.uint8]) -> list[Detection]:
    """Return the detections in an image. If `load` hasn't been called in this process, load the detector first."""
    if not _loaded:
        load()
    return _loaded[0](image)


def size(image: npt.NDArray[np.uint8]) -> int:
    """Return the number of bytes in an image. This function stands in for a detector that takes no time."""
    return image.nbytes


def hold_the_lock(seconds: float = 2.0) -> None:
    """Wait for at least this many seconds in C code that doesn't release the GIL, like some accelerators' drivers."""
    ctypes.PyDLL(None).usleep(round(1e6 * seconds))
