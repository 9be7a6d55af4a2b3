# score: 10
"""Tries to keep memory where no limit counts it: little of it, since a refused call is proof enough."""
import ctypes
import mmap
import os

libc = ctypes.CDLL(None, use_errno=True)
libc.syscall.restype = ctypes.c_long
CALLS = {
    "memfd_create": (319, b"hidden", 0),
    "memfd_secret": (447, 0),
    "shmget": (29, 0, 4096, 0o1600),
    "semget": (64, 0, 1, 0o1600),
    "msgget": (68, 0, 0o1600),
    "mq_open": (240, b"queue", os.O_CREAT | os.O_RDWR, 0o600, 0),
}
for name, (number, *arguments) in CALLS.items():
    assert libc.syscall(ctypes.c_long(number), *arguments) < 0, f"{name} is allowed"


def works(attempt):
    try:
        attempt()
    except OSError:
        return False
    return True


def whole_pages_in_a_pipe():
    reading, writing = os.pipe()
    source = ctypes.create_string_buffer(4096)
    part = (ctypes.c_size_t * 2)(ctypes.addressof(source), 4096)
    if libc.vmsplice(writing, part, 1, 0) < 0:
        raise OSError(ctypes.get_errno(), "vmsplice")


def shared_by_a_device():
    device = os.open("/dev/zero", os.O_RDWR)
    mmap.mmap(device, 4096, flags=mmap.MAP_SHARED)


assert not works(lambda: mmap.mmap(-1, 4096)), "shared memory without a file is allowed"
assert not works(shared_by_a_device), "a device gives shared memory"
assert not works(whole_pages_in_a_pipe), "a pipe holds pages of the program"
with open("/dev/zero", "rb") as zeros:
    assert zeros.read(10) == bytes(10), "there are no zeros to read"
@@GOOD@@
