"""The tiers of isolation by name, from the best to the weakest: making one, what it covers, and what it leaves open.

"sandbox": bubblewrap, a network of its own. "uid": a user id of its own for each slot, where the grader is root and the
kernel grants no namespaces. "landlock": for an ordinary user; the kernel hides files. "limits": limits and a sweep.
"""

from collections.abc import Sequence
from pathlib import Path
from typing import Literal

from workbook.inside.landlock import ABI_OF_SIGNALS, ABI_OF_TCP, landlock_abi
from workbook.inside.syscall_filter import filter_problem, knows_this_machine
from workbook.isolation.bubblewrap import outer_command, sandbox_problem
from workbook.isolation.grouped import GroupedTier
from workbook.isolation.host_files import closed_folder
from workbook.isolation.landlock import LandlockTier
from workbook.isolation.limits import LimitsTier
from workbook.isolation.sandbox import SandboxTier
from workbook.isolation.uid import UidTier
from workbook.isolation.user_ids import Ids, NoIds, lease_ids
from workbook.programs.fork_client import ForkServer
from workbook.programs.tier import Tier

Isolation = Literal["sandbox", "uid", "landlock", "limits"]
BEST_FIRST: tuple[Isolation, ...] = ("sandbox", "uid", "landlock", "limits")
_NETWORK = "the network of this machine and, through it, all ROS domains on it"
_DISK = "the disk: more than 200 MB are noticed only after they were written"
_WHOLE_DISK = "the disk and shared memory, which an answer can fill outside the folder that it works in"
_ENDLESS = "an answer that keeps restarting itself without a pause, which may go on running"
_KERNEL = "holes in the Linux kernel"


def named_tier(name: str) -> Isolation:
    """A tier by its name. Raises KeyError."""
    tiers: dict[str, Isolation] = {tier: tier for tier in BEST_FIRST}
    return tiers[name]


def meets_others(isolation: Isolation) -> bool:
    """Whether answers of strangers would meet on the network of this machine, so that one is judged after another.

    In "limits" they meet as well, and more: it is for answers that one would run oneself.
    """
    return isolation in ("uid", "landlock")


def make_tier(
    isolation: Isolation,
    *,
    ids: Ids | None = None,
    server: ForkServer | None = None,
    alternate: ForkServer | None = None,
    groups: Path | None = None,
) -> Tier:
    """The tier of that name, for a process that adopts what programs leave behind (see `adopt_orphans`).

    `ids`: for "uid", leased by the caller. `server` and `alternate`: for "sandbox", where each program is forked from
    one of them. `groups`: the folder for memory cgroups, leased by the caller; None where there are none. Raises
    ValueError without ids for "uid".
    """
    tier = _bare_tier(isolation, ids, server, alternate)
    return tier if groups is None else GroupedTier(tier, groups)


def _bare_tier(
    isolation: Isolation, ids: Ids | None, server: ForkServer | None, alternate: ForkServer | None
) -> Tier:
    if isolation == "sandbox":
        return SandboxTier(server, alternate)
    if isolation == "uid":
        if ids is None:
            raise ValueError('the tier "uid" needs ids')
        return UidTier(ids)
    return LandlockTier() if isolation == "landlock" else LimitsTier()


def lease_for(isolation: Isolation) -> Ids | None:
    """What a slot needs to make the tier: user ids for "uid", nothing for the others. Raises NoIds."""
    return lease_ids() if isolation == "uid" else None


def slot_command(isolation: Isolation, command: Sequence[str], groups: Path | None = None) -> list[str]:
    """How a slot is started whose programs run in the tier. `groups`: see `make_tier`. Raises NoSandbox."""
    return outer_command(command, groups) if isolation == "sandbox" else [*command]


def known_problem(isolation: Isolation) -> str | None:
    """Why a tier does not work here, and what to do, as far as it can be told without running a program in it."""
    if isolation == "sandbox":
        return sandbox_problem()
    if isolation == "landlock" and landlock_abi() == 0:
        return "this kernel has no Landlock, or it is switched off (Linux 5.13 or newer, lsm=landlock)"
    if isolation == "uid":
        try:
            lease_ids().release()
        except NoIds as error:
            return str(error)
        closed = closed_folder()
        if closed is not None:
            return f"other users may not enter {closed}, on the way to this Python: chmod o+x {closed}"
    return None


def refuses(isolation: Isolation) -> set[str]:
    """What a program must not be able to do in a tier, in the words of `inside/tier_probe.py`."""
    if isolation == "limits":
        return set()
    refused = {
        "reads a file of the grader",
        "changes its own file",
        "has capabilities",
        "can gain capabilities",
    }
    abi = landlock_abi()
    if isolation != "sandbox":  # there, what lies beside it is in memory and goes with it
        refused.add("writes beside its own file")
    if isolation == "uid" or (isolation == "landlock" and abi >= ABI_OF_SIGNALS):
        refused.add("signals the grader")  # in a sandbox the number means another process
    if isolation == "sandbox" or abi >= ABI_OF_TCP:
        refused.add("connects to this machine")
    return refused


IN_SHORT: dict[str, str] = {
    "sandbox": "in a sandbox of bubblewrap, with a network of its own",
    "uid": "as a user of its own",
    "landlock": "kept by the kernel from files that are not its own",
    "limits": "with limits on time, memory and processes, and with nothing else between it and this machine",
}
"""How an answer is kept from doing harm, in words for whoever reads a result."""


def covers(isolation: Isolation) -> str:
    """What isolates a program in a tier, as a part of a sentence."""
    if isolation == "sandbox":
        return "a network, a process table and a few files of its own, by bubblewrap"
    if isolation == "uid":
        return "a user id of its own for each slot" + (", and Landlock hides files" if landlock_abi() else "")
    if isolation == "landlock":
        signals = ", and lets no signal out" if landlock_abi() >= ABI_OF_SIGNALS else ""
        return f"Landlock hides all files but Python and the answer{signals}"
    return (
        "resource limits and a ROS domain of its own; everything that an answer has started is ended with it"
    )


def unfiltered(isolation: Isolation) -> str:
    """What is missing where a tier cannot filter system calls on this machine, as a sentence; else empty."""
    problem = "" if isolation == "limits" else filter_problem()
    return f"System calls of answers are not filtered: {problem}." if problem else ""


def leaves_open(isolation: Isolation) -> str:
    """What a tier does not protect, in one sentence, or in two where it cannot filter system calls."""
    calls = f" {problem}" if (problem := unfiltered(isolation)) else ""
    if isolation == "sandbox":
        return f"Not protected: {_KERNEL}.{calls}"
    abi = landlock_abi()
    network = _NETWORK + ("" if isolation == "limits" or abi < ABI_OF_TCP else " (TCP is closed)")
    disk = _WHOLE_DISK if isolation == "limits" else _DISK
    open_to = [network, disk, *(() if isolation == "uid" else (_ENDLESS,)), _KERNEL]
    if isolation == "uid" and not abi:
        open_to.insert(0, "files that every user of this machine may read (`chmod o= FOLDER` helps)")
    if isolation == "landlock" and not knows_this_machine():
        open_to.insert(0, "the limits of your processes, with which an answer can end them")
        open_to.insert(0, "the permissions of your files, which an answer can change if it guesses the name")
    if isolation == "limits" or (isolation == "landlock" and abi < ABI_OF_SIGNALS):
        open_to.insert(0, "your processes, this grader among them, which an answer can end")
    if isolation == "limits":
        open_to.insert(0, "your files, other answers among them, which an answer can read and change")
        open_to.insert(-1, "the folders for temporary files, in which something may stay behind")
    *most, last = open_to
    return f"Not protected: {'; '.join(most)}; and {last}.{calls}"
