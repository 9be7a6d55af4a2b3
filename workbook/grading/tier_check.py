"""Find out which isolation tiers work on this machine by testing each with a slot, which is kept if it works."""

import socket
from functools import cache

from workbook.grading.slots.client import Slot, SlotBroken
from workbook.grading.slots.pool import Kind, warm_slots
from workbook.isolation.tiers import BEST_FIRST, Isolation, known_problem

SELF_TEST_S = 60.0


@cache
def tier_problem(isolation: Isolation) -> str | None:
    """Return the reason that a tier doesn't work here, and how to fix it; None if it does work.

    The first call takes a second. If the tier works, the slot that tested it is kept for the first answer (see
    `warm_slots`).
    """
    return known_problem(isolation) or _try_out(isolation)


def best_below_sandbox() -> Isolation:
    """Return the best tier below "sandbox" that works here."""
    return next((name for name in BEST_FIRST[1:] if tier_problem(name) is None), "limits")


def _try_out(isolation: Isolation) -> str | None:
    """Have a slot run a program of ours in this tier. Return the problem, or None if the tier works.

    The slot tests the tier's isolation, and checks that we receive the program's messages.
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
