"""Giving up the capabilities of this process for good."""

import ctypes

from workbook.inside.libc import checked, libc

PR_SET_DUMPABLE = 4
PR_CAPBSET_READ = 23
PR_CAPBSET_DROP = 24
PR_SET_NO_NEW_PRIVS = 38
PR_CAP_AMBIENT = 47
PR_CAP_AMBIENT_CLEAR_ALL = 4
CAPABILITY_VERSION_3 = 0x20080522
CAPABILITIES = 64


def clear_bounding_set() -> None:
    """No program that this one becomes can gain a capability."""
    for capability in range(CAPABILITIES):
        libc.prctl(PR_CAPBSET_DROP, capability, 0, 0, 0)  # only root may, and only root needs it


def drop_capabilities() -> None:
    """Drop what capabilities a thread still holds; set-user-id programs will not help it. Raises OSError."""
    libc.prctl(PR_CAP_AMBIENT, PR_CAP_AMBIENT_CLEAR_ALL, 0, 0, 0)
    _hold(0)
    forbid_new_rights()


def bounding_set() -> int:
    """The capabilities (a bit each) that a program can gain at most that this process becomes."""
    within = (libc.prctl(PR_CAPBSET_READ, capability, 0, 0, 0) == 1 for capability in range(CAPABILITIES))
    return sum(1 << capability for capability, is_within in enumerate(within) if is_within)


def hold_within(bounds: int) -> None:
    """Hold the capabilities of the bounding set `bounds`, which becomes ours; those beyond it are gone for good.

    A name space of users gives all of them to who enters it. Set-user-id programs will not help. Raises OSError.
    """
    for capability in range(CAPABILITIES):
        if not bounds & 1 << capability:
            libc.prctl(PR_CAPBSET_DROP, capability, 0, 0, 0)
    _hold(bounds)
    forbid_new_rights()


def _hold(capabilities: int) -> None:
    """Hold these capabilities (a bit each) and no others, none of them inheritable."""
    header = (ctypes.c_uint32 * 2)(CAPABILITY_VERSION_3, 0)
    low, high = capabilities & 0xFFFFFFFF, capabilities >> 32
    checked("capset", libc.capset(header, (ctypes.c_uint32 * 6)(low, low, 0, high, high, 0)))


def forbid_new_rights() -> None:
    """Set-user-id programs will not help this process. Raises OSError."""
    checked("no_new_privs", libc.prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0))


def set_dumpable() -> None:
    """Let other processes of the same user read this one, which a change of capabilities forbids. Raises OSError."""
    checked("dumpable", libc.prctl(PR_SET_DUMPABLE, 1, 0, 0, 0))
