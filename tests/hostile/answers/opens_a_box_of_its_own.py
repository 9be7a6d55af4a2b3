# score: 10
"""Tries to get capabilities in a user namespace of its own."""
import ctypes
import os

libc = ctypes.CDLL(None, use_errno=True)
CLONE_NEWUSER = 0x10000000
assert libc.unshare(CLONE_NEWUSER) != 0, "it may make user namespaces"
assert os.getppid() <= 1, "its parent is no part of its box"
assert libc.mount(b"none", b"/tmp", b"tmpfs", 0, None) != 0, "it may mount"
@@GOOD@@