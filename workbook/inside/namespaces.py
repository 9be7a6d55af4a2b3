"""Enter the namespaces of a sandbox that bubblewrap created."""

import os

from workbook.inside.capabilities import bounding_set, drop_capabilities, hold_within, set_dumpable
from workbook.inside.libc import checked, libc

NEWNS, NEWCGROUP, NEWUTS = 0x00020000, 0x02000000, 0x04000000
NEWIPC, NEWUSER, NEWPID, NEWNET = 0x08000000, 0x10000000, 0x20000000, 0x40000000
OF_A_PROGRAM = NEWUSER | NEWNS | NEWPID | NEWIPC | NEWUTS | NEWCGROUP
"""The namespaces of a program's (inner) sandbox.

It has no separate network namespace, so the program uses the network of the outer sandbox.
"""
OF_A_SLOT = NEWUSER | NEWNS | NEWIPC | NEWNET
"""The namespaces of a slot's (outer) sandbox. A slot is a process that judges answers."""


def join_namespaces(first: int, spaces: int) -> None:
    """Enter the namespaces of the process `first` that the flags in `spaces` select. Raises OSError on failure.

    This process must have only one thread. It may enter namespaces that its own user created, but must enter all of
    them in one call. Afterward, it has no rights outside of these namespaces. A PID namespace takes effect only for the
    children that this process starts later.
    """
    descriptor = os.pidfd_open(first)
    try:
        checked("setns", libc.setns(descriptor, spaces))
    finally:
        os.close(descriptor)


def settle_in_slot(first: int) -> None:
    """Enter the outer sandbox whose first process is `first`, with the rights that bubblewrap's processes have there.

    If this process runs as root, it keeps root's rights within the sandbox, because it needs them to create another
    sandbox inside. Raises OSError on failure.
    """
    bounds = bounding_set()
    join_namespaces(first, OF_A_SLOT)
    if os.geteuid() == 0:
        hold_within(bounds)
    else:
        drop_capabilities()
    set_dumpable()
