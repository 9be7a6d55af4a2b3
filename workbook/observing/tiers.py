"""The ways to keep a stranger's program in, from the best to the weakest, and what each of them does not do.

"sandbox": bubblewrap, a network of its own. "uid": a user id of its own for each slot, where the grader is root and the
kernel grants no namespaces. "landlock": for an ordinary user; the kernel hides files. "limits": limits and a sweep.
"""

import stat
import sys
from pathlib import Path
from typing import Literal

from workbook.observing.confine import ABI_OF_SIGNALS, ABI_OF_TCP, landlock_abi
from workbook.observing.confinement import Confinement
from workbook.observing.powers import filters_calls
from workbook.observing.sandbox import Cage, interpreter_folders
from workbook.observing.uids import Ids

Isolation = Literal["sandbox", "uid", "landlock", "limits"]
BEST_FIRST: tuple[Isolation, ...] = ("sandbox", "uid", "landlock", "limits")
_NETWORK = "the network of this machine and, through it, the ROS domains of other answers"
_DISK = "the disk, which an answer can fill"
_ENDLESS = "an answer that starts itself anew without a pause, which may go on running"
_KERNEL = "holes in the Linux kernel"


def named_tier(name: str) -> Isolation:
    """A tier by its name. Raises KeyError."""
    tiers: dict[str, Isolation] = {tier: tier for tier in BEST_FIRST}
    return tiers[name]


def walls(
    isolation: Isolation, ids: Ids | None = None, *, adopts: bool = False
) -> tuple[Cage | None, Confinement | None]:
    """What keeps a program in: a cage or a confinement. `adopts`: see `Confinement`."""
    if isolation == "sandbox":
        return Cage(), None
    hides_files = isolation == "landlock" or (isolation == "uid" and landlock_abi() > 0)
    return None, Confinement(ids=ids, landlock=hides_files, adopts=adopts)


def covers(isolation: Isolation) -> str:
    """What keeps a program in, as a part of a sentence."""
    if isolation == "sandbox":
        return "a network, a process table and a few files of its own, by bubblewrap"
    if isolation == "uid":
        return "a user id of its own for each slot" + (", and Landlock hides files" if landlock_abi() else "")
    if isolation == "landlock":
        signals = ", and lets no signal out" if landlock_abi() >= ABI_OF_SIGNALS else ""
        return f"Landlock hides all files but Python and the answer{signals}"
    return "resource limits, a ROS domain of its own, and an end to all that an answer has started"


def leaves_open(isolation: Isolation) -> str:
    """What a tier does not protect, as a sentence."""
    if isolation == "sandbox":
        return f"Not protected: {_KERNEL}."
    abi = landlock_abi()
    network = _NETWORK + ("" if isolation == "limits" or abi < ABI_OF_TCP else " (TCP is closed)")
    open_to = [network, _DISK, *(() if isolation == "uid" else (_ENDLESS,)), _KERNEL]
    if isolation == "uid" and not abi:
        open_to.insert(0, "files that every user of this machine may read (`chmod o= FOLDER` helps)")
    if isolation == "landlock" and not filters_calls():
        open_to.insert(
            0, "the permissions of your files, which an answer can change where it guesses the name"
        )
    if isolation == "limits" or (isolation == "landlock" and abi < ABI_OF_SIGNALS):
        open_to.insert(0, "your processes, this grader among them, which an answer can end")
    if isolation == "limits":
        open_to.insert(0, "your files, other answers among them, which an answer can read and change")
        open_to.insert(-1, "the folders for temporary files, in which something may stay behind")
    *most, last = open_to
    return f"Not protected: {'; '.join(most)}; and {last}."


def closed_folder() -> Path | None:
    """A folder on the way to Python and its packages that other users may not enter."""
    for place in (*interpreter_folders(), Path(sys.executable), Path(sys.executable).resolve()):
        for folder in reversed(place.parents):
            if not folder.stat().st_mode & stat.S_IXOTH:
                return folder
    return None
