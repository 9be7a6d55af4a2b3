"""Entering the name spaces of a sandbox that bubblewrap has made."""

import os

from workbook.inside.capabilities import bounding_set, drop_capabilities, hold_within, set_dumpable
from workbook.inside.libc import checked, libc

NEWNS, NEWCGROUP, NEWUTS = 0x00020000, 0x02000000, 0x04000000
NEWIPC, NEWUSER, NEWPID, NEWNET = 0x08000000, 0x10000000, 0x20000000, 0x40000000
OF_A_PROGRAM = NEWUSER | NEWNS | NEWPID | NEWIPC | NEWUTS | NEWCGROUP
"""Those of the inner sandbox. The network is that of the observer, as for any answer."""
OF_A_SLOT = NEWUSER | NEWNS | NEWIPC | NEWNET
"""Those of the outer sandbox."""


def join_namespaces(first: int, spaces: int) -> None:
    """Enter name spaces of the process `first`; a process space takes effect for children. Raises OSError.

    All at once: a process may enter name spaces that its own user has made, and has no rights outside afterwards. Only
    for a process with a single thread.
    """
    descriptor = os.pidfd_open(first)
    try:
        checked("setns", libc.setns(descriptor, spaces))
    finally:
        os.close(descriptor)


def settle_in_slot(first: int) -> None:
    """Enter the outer sandbox whose first process is `first`, with the rights of whoever bubblewrap starts in it.

    Those of root remain, within the sandbox: without them it could not make a sandbox in it. Raises OSError.
    """
    bounds = bounding_set()
    join_namespaces(first, OF_A_SLOT)
    if os.geteuid() == 0:
        hold_within(bounds)
    else:
        drop_capabilities()
    set_dumpable()
