"""What a process beside the node runs: functions that a pool of processes finds by name.

A process that is started afresh (`spawn`) imports the functions it is given. It cannot import what a cell defines.
"""

import ctypes
import time

import numpy as np
import numpy.typing as npt

from workbook.models import DeskDetector, Detection

_loaded: list[DeskDetector] = []


def load(takes_s: float = 0.0) -> None:
    """Load the detector of this process, and take as long as a large one does (s)."""
    done = time.monotonic() + takes_s
    _loaded[:] = [DeskDetector()]
    time.sleep(max(0.0, done - time.monotonic()))


def look(image: npt.NDArray[np.uint8]) -> list[Detection]:
    """What is in an image. The detector is loaded first where `load` was not called."""
    if not _loaded:
        load()
    return _loaded[0](image)


def size(image: npt.NDArray[np.uint8]) -> int:
    """How many bytes arrived: a model that takes no time."""
    return image.nbytes


def hold_the_lock(seconds: float = 2.0) -> None:
    """Wait in C code that does not release the GIL, as some drivers of accelerators do; at least so many seconds."""
    ctypes.PyDLL(None).usleep(round(1e6 * seconds))
