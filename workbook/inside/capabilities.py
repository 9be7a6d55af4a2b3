"""Give up this process's capabilities, permanently."""

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
    """Ensure that this process can't gain a capability by executing another program."""
    for capability in range(CAPABILITIES):
        libc.prctl(PR_CAPBSET_DROP, capability, 0, 0, 0)  # fails without root, but only root needs it


def drop_capabilities() -> None:
    """Drop all capabilities that this thread holds, and disable set-user-ID programs for it. Raises OSError."""
    libc.prctl(PR_CAP_AMBIENT, PR_CAP_AMBIENT_CLEAR_ALL, 0, 0, 0)
    _hold(0)
    forbid_new_rights()


def bounding_set() -> int:
    """Return the capabilities (one bit each) that a program executed by this process can gain at most."""
    within = (libc.prctl(PR_CAPBSET_READ, capability, 0, 0, 0) == 1 for capability in range(CAPABILITIES))
    return sum(1 << capability for capability, is_within in enumerate(within) if is_within)


def hold_within(bounds: int) -> None:
    """Set this process's capabilities and its bounding set to `bounds`, and give up all others permanently.

    Call this after entering a user namespace, which grants all capabilities. It also disables set-user-ID programs.
    Raises OSError.
    """
    for capability in range(CAPABILITIES):
        if not bounds & 1 << capability:
            libc.prctl(PR_CAPBSET_DROP, capability, 0, 0, 0)
    _hold(bounds)
    forbid_new_rights()


def _hold(capabilities: int) -> None:
    """Give this process exactly these capabilities (one bit each), none of them inheritable. Raises OSError."""
    header = (ctypes.c_uint32 * 2)(CAPABILITY_VERSION_3, 0)
    low, high = capabilities & 0xFFFFFFFF, capabilities >> 32
    checked("capset", libc.capset(header, (ctypes.c_uint32 * 6)(low, low, 0, high, high, 0)))


def forbid_new_rights() -> None:
    """Prevent this process from gaining rights through set-user-ID programs. Raises OSError."""
    checked("no_new_privs", libc.prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0))


def set_dumpable() -> None:
    """Let the same user's processes inspect this process again after a change of capabilities. Raises OSError."""
    checked("dumpable", libc.prctl(PR_SET_DUMPABLE, 1, 0, 0, 0))
