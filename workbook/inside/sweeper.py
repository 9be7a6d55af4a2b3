"""Kill every process of a user id: `python -I -S run.py sweeper ID OWN_ID`, as root.

It acts with the programs' user id, so one call of `kill` reaches all of them, and none can escape by forking. Its real
user id is a different one, so no program may signal it.
"""

import os
import signal
import sys

from workbook.inside.proc import status

RANGES = ((1_900_000_000, 100_000), (60_600, 480))
"""First id and count of each range. Neither distributions nor container managers create accounts there. The second
range is for containers that have only 65536 ids.
"""


def is_ours(user: int) -> bool:
    """Return whether an id is in the ranges for running programs."""
    return any(first <= user < first + count for first, count in RANGES)


def act_as(user: int, own: int) -> None:
    """Switch to both ids permanently.

    Raises PermissionError unless the kernel confirms that this process can't reach any other processes.
    """
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
    """Kill every process of `user`, after changing this process's ids permanently. Raises PermissionError."""
    act_as(user, own)
    try:
        os.kill(-1, signal.SIGKILL)
    except ProcessLookupError:
        pass


def main(arguments: list[str]) -> None:
    """Kill every process of a user. The arguments are the user id and our own id. On failure, exit with a message."""
    try:
        end_all(int(arguments[0]), int(arguments[1]))
    except OSError as error:
        sys.exit(str(error))
