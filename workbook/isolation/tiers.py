"""Create isolation tiers by name, and describe their protection and its gaps.

An isolation tier is one way to protect the machine, the judge, and other answers from an untrusted program.

From the strongest to the weakest, the tiers are "sandbox", "uid", "landlock", and "limits". The "sandbox" tier uses
bubblewrap, with a separate network. The "uid" tier runs each slot's programs under a separate user ID; it's for root on
a kernel that doesn't grant namespaces. (A slot is a process that judges answers.) In the "landlock" tier, which doesn't
require root, the kernel hides files. The "limits" tier only limits resources and kills leftover processes.
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
    """Return the tier with this name. Raises KeyError if there is none."""
    tiers: dict[str, Isolation] = {tier: tier for tier in BEST_FIRST}
    return tiers[name]


def meets_others(isolation: Isolation) -> bool:
    """Return whether only one answer may run at a time, because answers could interact on this machine's network.

    In the "limits" tier, answers could interact, too, but that tier is for trusted answers, which don't need isolation.
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
    """Create the tier with this name, for a process that adopts orphaned processes (see `adopt_orphans`).

    `ids`: the user IDs for the "uid" tier, leased by the caller. `server` and `alternate`: the fork servers for the
    "sandbox" tier (see `SandboxTier`). `groups`: the folder for memory cgroups, leased by the caller, or None if there
    are none. Raises ValueError for the "uid" tier without `ids`.
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
    """Lease the user IDs that a slot needs for the "uid" tier. Return None for other tiers. Raises NoIds."""
    return lease_ids() if isolation == "uid" else None


def slot_command(isolation: Isolation, command: Sequence[str], groups: Path | None = None) -> list[str]:
    """Return `command`, which starts a slot, extended as this tier requires. `groups`: see `make_tier`.

    Raises NoSandbox if bubblewrap isn't installed.
    """
    return outer_command(command, groups) if isolation == "sandbox" else [*command]


def known_problem(isolation: Isolation) -> str | None:
    """Return why a tier doesn't work on this machine and how to fix that, or None if no reason is known.

    This function finds only reasons that show up without running an answer in the tier.
    """
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
    """Return the actions that must fail in a tier, as named in `inside/tier_probe.py`."""
    if isolation == "limits":
        return set()
    refused = {
        "reads a file of the judge",
        "changes its own file",
        "has capabilities",
        "can gain capabilities",
    }
    abi = landlock_abi()
    if isolation != "sandbox":  # a sandbox's writable folders are in memory and disappear with it
        refused.add("writes next to its own file")
    if isolation == "uid" or (isolation == "landlock" and abi >= ABI_OF_SIGNALS):
        refused.add("signals the judge")  # in a sandbox, the process ID belongs to another process
    if isolation == "sandbox" or abi >= ABI_OF_TCP:
        refused.add("connects to this machine")
    return refused


IN_SHORT: dict[str, str] = {
    "sandbox": "in a bubblewrap sandbox, with its own network",
    "uid": "under its own user id",
    "landlock": "kept by the kernel from files that are not its own",
    "limits": "with limits on time, memory and processes, and with nothing else between it and this machine",
}
"""Describes in a few words how each tier protects the machine from an answer. People read this next to a result."""


def covers(isolation: Isolation) -> str:
    """Describe how a tier isolates a program, as part of a sentence."""
    if isolation == "sandbox":
        return "its own network, process table, and a few files, by bubblewrap"
    if isolation == "uid":
        return "a separate user id for each slot" + (", and Landlock hides files" if landlock_abi() else "")
    if isolation == "landlock":
        signals = ", and lets no signal out" if landlock_abi() >= ABI_OF_SIGNALS else ""
        return f"Landlock hides all files but Python and the answer{signals}"
    return "resource limits and its own ROS domain; everything that an answer has started is ended with it"


def unfiltered(isolation: Isolation) -> str:
    """Return a warning if a tier can't filter system calls on this machine.

    The warning is a sentence. It's an empty string if the tier can filter the calls or doesn't need to.
    """
    problem = "" if isolation == "limits" else filter_problem()
    return f"System calls of answers are not filtered: {problem}." if problem else ""


def leaves_open(isolation: Isolation) -> str:
    """Return a sentence that lists a tier's gaps, and a second sentence if the tier can't filter system calls."""
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
        open_to.insert(0, "your processes, including the judge, which an answer can end")
    if isolation == "limits":
        open_to.insert(0, "your files, other answers among them, which an answer can read and change")
        open_to.insert(-1, "the folders for temporary files, in which something may stay behind")
    *most, last = open_to
    return f"Not protected: {'; '.join(most)}; and {last}.{calls}"
