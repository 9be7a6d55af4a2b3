"""Giving up the capabilities of this process for good."""

import ctypes

from workbook.inside.libc import checked, libc

PR_SET_DUMPABLE = 4
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
    header = (ctypes.c_uint32 * 2)(CAPABILITY_VERSION_3, 0)
    checked("capset", libc.capset(header, (ctypes.c_uint32 * 6)()))
    forbid_new_rights()


def forbid_new_rights() -> None:
    """Set-user-id programs will not help this process. Raises OSError."""
    checked("no_new_privs", libc.prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0))


def set_dumpable() -> None:
    """Let other processes of the same user read this one, which a change of capabilities forbids. Raises OSError."""
    checked("dumpable", libc.prctl(PR_SET_DUMPABLE, 1, 0, 0, 0))
