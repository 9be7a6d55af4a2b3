"""Find out which isolation tiers work on this machine, by starting a slot in the tier and running a test program.

A slot is a process that judges answers. If the tier works, the slot is kept for judging.
"""

import socket
from functools import cache

from workbook.grading.slots.client import Slot, SlotBroken
from workbook.grading.slots.pool import Kind, warm_slots
from workbook.isolation.tiers import BEST_FIRST, Isolation, known_problem

SELF_TEST_S = 60.0


@cache
def tier_problem(isolation: Isolation) -> str | None:
    """Return why a tier doesn't work on this machine and how to fix that, or None if it works.

    The first call for a tier takes a second. If the tier works, the slot that tested it is kept for the first answer
    (see `warm_slots`).
    """
    return known_problem(isolation) or _try_out(isolation)


def best_below_sandbox() -> Isolation:
    """Return the strongest tier below "sandbox" that works on this machine."""
    return next((name for name in BEST_FIRST[1:] if tier_problem(name) is None), "limits")


def _try_out(isolation: Isolation) -> str | None:
    """Have a slot run a test program in this tier. Return the problem, or None if the tier works.

    The slot tests the tier's isolation and checks that it receives the program's messages.
    """
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
        warm_slots.give(Kind(isolation), slot)
    else:
        slot.kill()
    return problem
