"""Kill every process of a user ID: `python -I -S run.py sweeper ID OWN_ID`, as root.

Programs run under the user ID. It becomes this process's effective user ID, so one call of `kill` reaches all of the
programs. Therefore, none of them can escape by forking. This process's real user ID is OWN_ID, so the programs may not
send it signals.
"""

import os
import signal
import sys

from workbook.inside.proc import status

RANGES = ((1_900_000_000, 100_000), (60_600, 480))
"""The first ID and the number of IDs of each range for running programs.

Neither distributions nor container managers create accounts in these ranges. The second range is for containers that
have only 65536 IDs.
"""


def is_ours(user: int) -> bool:
    """Return whether a user ID is in one of the ranges for running programs."""
    return any(first <= user < first + count for first, count in RANGES)


def act_as(user: int, own: int) -> None:
    """Switch to the effective user ID `user` and the real user ID `own` permanently.

    Raises PermissionError unless the kernel confirms that this process can't reach other users' processes.
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
    """Change this process's user IDs permanently, and then kill every process of `user`. Raises PermissionError."""
    act_as(user, own)
    try:
        os.kill(-1, signal.SIGKILL)
    except ProcessLookupError:
        pass


def main(arguments: list[str]) -> None:
    """Kill every process of a user.

    The arguments are that user's ID and our own ID. On failure, exit with a message.
    """
    try:
        end_all(int(arguments[0]), int(arguments[1]))
    except OSError as error:
        sys.exit(str(error))
