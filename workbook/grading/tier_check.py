"""Which tiers of isolation work on this machine: the slot for the first answer tries it."""

import socket
from functools import cache

from workbook.grading.slots.client import Slot, SlotBroken
from workbook.grading.slots.pool import Kind, warm_slots
from workbook.isolation.tiers import BEST_FIRST, Isolation, known_problem

SELF_TEST_S = 60.0


@cache
def tier_problem(isolation: Isolation) -> str | None:
    """Why a tier does not work here, and what to do; None when it does. Tries it, once: it takes a second.

    The slot that has tried a tier that works is kept for the first answer (see `warm_slots`).
    """
    return known_problem(isolation) or _try_out(isolation)


def best_below_sandbox() -> Isolation:
    """The best of the weaker tiers that works here."""
    return next((name for name in BEST_FIRST[1:] if tier_problem(name) is None), "limits")


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
        warm_slots.give(Kind(isolation), slot)
    else:
        slot.kill()
    return problem
