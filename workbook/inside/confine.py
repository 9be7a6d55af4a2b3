"""Confines this process and becomes another program: `python -I -S run.py confine OPTION... -- COMMAND...`

    [--user ID] [--processes N] [--read PATH]... [--write PATH]...

Whatever is asked for, capabilities and ways to new ones are given up. `--user` takes an id (and the group of the same
number) that no account needs to have. With any `--read` or `--write` Landlock hides all other files, and keeps signals
and TCP connections inside, as far as this kernel knows how (`landlock_abi`). A filter of system calls
refuses memory that no limit counts; without `--user`, it also does what Landlock does not: it keeps the permissions of
the user's files as they are.
"""

import os
import resource
import sys

from workbook.inside import capabilities, landlock, syscall_filter

FAILED = 126


def become(user: int) -> None:
    """Take a user id and the group of the same number, and no other group, for good."""
    os.setgroups([])
    os.setresgid(user, user, user)
    os.setresuid(user, user, user)


def limit_processes(most: int) -> None:
    """Limit threads and processes of this process's user to `most` in all."""
    _, hard = resource.getrlimit(resource.RLIMIT_NPROC)
    wanted = most if hard == resource.RLIM_INFINITY else min(most, hard)
    resource.setrlimit(resource.RLIMIT_NPROC, (wanted, wanted))


def main(arguments: list[str]) -> None:
    """Do as the command line says. Ends with code 126 and a sentence when that is not possible."""
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
