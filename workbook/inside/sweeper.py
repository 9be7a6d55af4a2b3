"""Ends everything that runs under a user id: `python -I -S run.py sweeper ID OWN_ID`, as root.

It acts with the id of the programs, so that one call of `kill` reaches all of them at
once and none can fork away, and its own real id is another one, so that none of them may signal it.
"""

import os
import signal
import sys

from workbook.inside.proc import status

RANGES = ((1_900_000_000, 100_000), (60_600, 480))
"""First id and how many: where neither distributions nor container managers put accounts. The second is for containers
that know 65536 ids only."""


def is_ours(user: int) -> bool:
    """Whether an id is one of those that programs are run under."""
    return any(first <= user < first + count for first, count in RANGES)


def act_as(user: int, own: int) -> None:
    """Take both ids for good. Raises PermissionError unless the kernel confirms that nobody else can be reached."""
    if not is_ours(user) or not is_ours(own):
        raise PermissionError(f"{user} and {own} are not ids that programs are run under")
    os.setgroups([])
    os.setresgid(own, own, own)
    os.setresuid(own, user, own)
    told = status()
    ids = [int(number) for number in told["Uid"].split()[:3]]
    capabilities = int(told["CapEff"], 16) | int(told["CapPrm"], 16)
    if ids != [own, user, own] or capabilities:
        raise PermissionError(f"this process could reach others: ids {ids}, capabilities {capabilities:x}")


def end_all(user: int, own: int) -> None:
    """Kill every process of `user`. Changes the ids of this process for good. Raises PermissionError."""
    act_as(user, own)
    try:
        os.kill(-1, signal.SIGKILL)
    except ProcessLookupError:
        pass


def main(arguments: list[str]) -> None:
    """Kill every process of a user; arguments are the user id and our own id. Exits with a message when that fails."""
    try:
        end_all(int(arguments[0]), int(arguments[1]))
    except OSError as error:
        sys.exit(str(error))
