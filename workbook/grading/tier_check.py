"""Which ways to keep a stranger's program in work on this machine: the slot for the first answer tries it."""

import socket
from functools import cache

from workbook.grading.pool import Slot, SlotBroken, spare
from workbook.observing.confine import landlock_abi
from workbook.observing.sandbox import sandbox_problem
from workbook.observing.tiers import BEST_FIRST, Isolation, closed_folder
from workbook.observing.uids import NoIds, lease_ids

SELF_TEST_S = 60.0


@cache
def tier_problem(isolation: Isolation) -> str | None:
    """Why a tier does not work here, and what to do; None when it does. Tries it, once: it takes a second.

    The slot that has tried a tier that works is kept for the first answer (see `workbook.grading.pool.spare`).
    """
    return _known_problem(isolation) or _try_out(isolation)


def best_below_sandbox() -> Isolation:
    """The best of the weaker tiers that works here."""
    return next((name for name in BEST_FIRST[1:] if tier_problem(name) is None), "limits")


def _known_problem(isolation: Isolation) -> str | None:
    """What can be told without running a program."""
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


def _try_out(isolation: Isolation) -> str | None:
    """Let a slot run a program of our own in this tier: what can it do, and is it heard?"""
    with socket.create_server(("127.0.0.1", 0)) as listener:
        try:
            slot = Slot(isolation, port=listener.getsockname()[1])
        except SlotBroken as error:
            return str(error)
        try:
            problem = slot.problem(SELF_TEST_S)
        except SlotBroken as error:
            problem = f"the self-test broke: {error}"
        except BaseException:
            slot.kill()
            raise
    if problem is None:
        spare.keep(isolation, slot)
    else:
        slot.kill()
    return problem
