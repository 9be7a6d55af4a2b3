"""Confine this process, and then execute another program.

Start this file with `python -I -S run.py confine OPTION... -- COMMAND...` and these options:

    [--user ID] [--processes N] [--read PATH]... [--write PATH]...

In every case, the process gives up its capabilities and all ways to regain them. `--user` takes a user ID, which is
also used as the group ID and doesn't need an account. With `--read` or `--write`, the kernel's Landlock hides all files
except the given ones. If the kernel supports that (`landlock_abi`), Landlock also blocks signals and TCP connections to
other processes. With any of these three options, a system call filter refuses calls that use memory that no limit
counts. Without `--user`, the filter also keeps the program from changing the permissions of the user's files, which
Landlock would allow.
"""

import os
import resource
import sys

from workbook.inside import capabilities, landlock, syscall_filter

FAILED = 126


def become(user: int) -> None:
    """Switch permanently to a user ID and to the group ID with the same number. Leave all other groups."""
    os.setgroups([])
    os.setresgid(user, user, user)
    os.setresuid(user, user, user)


def limit_processes(most: int) -> None:
    """Limit the total number of threads and processes of this process's user to `most`."""
    _, hard = resource.getrlimit(resource.RLIMIT_NPROC)
    wanted = most if hard == resource.RLIM_INFINITY else min(most, hard)
    resource.setrlimit(resource.RLIMIT_NPROC, (wanted, wanted))


def main(arguments: list[str]) -> None:
    """Confine this process and execute the command, as the module's docstring says.

    On failure, print the reason and exit with code 126.
    """
    asked: dict[str, list[str]] = {"--user": [], "--processes": [], "--read": [], "--write": []}
    while arguments[0] != "--":
        asked[arguments[0]].append(arguments[1])
        arguments = arguments[2:]
    try:
        os.umask(0o077)
        resource.setrlimit(resource.RLIMIT_MSGQUEUE, (0, 0))
        for most in asked["--processes"]:
            limit_processes(int(most))
        capabilities.clear_bounding_set()
        for user in asked["--user"]:
            become(int(user))
        capabilities.drop_capabilities()
        if asked["--read"] or asked["--write"]:
            landlock.restrict_to(asked["--read"], asked["--write"])
        if asked["--user"]:
            syscall_filter.filter_uncounted_memory()
        elif (asked["--read"] or asked["--write"]) and syscall_filter.knows_this_machine():
            syscall_filter.filter_permission_changes()
        os.execv(arguments[1], arguments[1:])
    except OSError as error:
        print(f"the program could not be confined: {error}", file=sys.stderr, flush=True)
        os._exit(FAILED)
