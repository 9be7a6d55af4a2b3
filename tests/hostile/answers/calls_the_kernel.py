# score: 10
"""Tries the calls by which programs have got out of boxes, or into other programs. None of them is needed by a node."""
import ctypes
import os

libc = ctypes.CDLL(None, use_errno=True)
libc.syscall.restype = ctypes.c_long
CALLS = {
    "ptrace": (101, 16, 1, 0, 0),  # attach to the first process
    "process_vm_readv": (310, 1, 0, 0, 0, 0, 0),
    "add_key": (248, b"user", b"name", b"x", 1, -3),
    "keyctl": (250, 0, -3, 0),
    "request_key": (249, b"user", b"name", 0, -3),
    "bpf": (321, 0, 0, 0),
    "userfaultfd": (323, 1),
    "perf_event_open": (298, 0, 0, -1, -1, 0),
    "io_uring_setup": (425, 1, b"\0" * 120),
    "unshare": (272, 0x10000000),
    "setns": (308, os.open("/proc/self/ns/net", os.O_RDONLY), 0),
    "mount": (165, b"none", b"/tmp", b"tmpfs", 0, 0),
    "open_by_handle_at": (304, 0, b"\0" * 16, 0),
    "init_module": (175, b"", 0, b""),
    "by way of the 32-bit calls": (0x40000000 + 39,),
}
for name, (number, *arguments) in CALLS.items():
    assert libc.syscall(ctypes.c_long(number), *arguments) < 0, f"{name} is allowed"
child = libc.syscall(ctypes.c_long(56), 0x10000000 | 17, 0, 0, 0, 0)  # clone with a new user namespace
if child == 0:
    os._exit(0)
assert child < 0, "it may make user namespaces"
assert libc.setuid(12345) < 0, "it may become another user"
assert libc.setgroups(1, (ctypes.c_uint * 1)(12345)) < 0, "it may join another group"
status = dict(line.split(":\t", 1) for line in open("/proc/self/status").read().splitlines() if ":\t" in line)
assert int(status["CapEff"], 16) == 0, "it has capabilities"
assert status["NoNewPrivs"] == "1", "a set-uid program would help it"
@@GOOD@@
