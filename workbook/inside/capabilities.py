"""Give up this process's Linux capabilities permanently."""

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
        libc.prctl(PR_CAPBSET_DROP, capability, 0, 0, 0)  # fails unless we're root, but then it isn't needed


def drop_capabilities() -> None:
    """Drop all of this thread's capabilities, and make set-user-ID programs useless for it.

    Raises OSError on failure.
    """
    libc.prctl(PR_CAP_AMBIENT, PR_CAP_AMBIENT_CLEAR_ALL, 0, 0, 0)
    _hold(0)
    forbid_new_rights()


def bounding_set() -> int:
    """Return the capabilities (one bit each) that this process can gain at most by executing a program."""
    within = (libc.prctl(PR_CAPBSET_READ, capability, 0, 0, 0) == 1 for capability in range(CAPABILITIES))
    return sum(1 << capability for capability, is_within in enumerate(within) if is_within)


def hold_within(bounds: int) -> None:
    """Set this process's capabilities and its bounding set to `bounds`, and give up all other capabilities permanently.

    Call this function after entering a user namespace, because that grants all capabilities. Afterward, set-user-ID
    programs are useless for this process, too. Raises OSError on failure.
    """
    for capability in range(CAPABILITIES):
        if not bounds & 1 << capability:
            libc.prctl(PR_CAPBSET_DROP, capability, 0, 0, 0)
    _hold(bounds)
    forbid_new_rights()


def _hold(capabilities: int) -> None:
    """Give this process exactly these capabilities (one bit each), without making them inheritable. Raises OSError."""
    header = (ctypes.c_uint32 * 2)(CAPABILITY_VERSION_3, 0)
    low, high = capabilities & 0xFFFFFFFF, capabilities >> 32
    checked("capset", libc.capset(header, (ctypes.c_uint32 * 6)(low, low, 0, high, high, 0)))


def forbid_new_rights() -> None:
    """Prevent this process from gaining rights through set-user-ID programs. Raises OSError on failure."""
    checked("no_new_privs", libc.prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0))


def set_dumpable() -> None:
    """Let the same user's processes inspect this process again.

    The kernel forbids that after a change of capabilities. Raises OSError on failure.
    """
    checked("dumpable", libc.prctl(PR_SET_DUMPABLE, 1, 0, 0, 0))
