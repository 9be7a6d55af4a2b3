# score: 10
"""Tries to take from figures of the whole machine or of its user, little of each: a refused call is proof enough."""
import ctypes
import fcntl
import os
import resource
import signal

libc = ctypes.CDLL(None, use_errno=True)
libc.syscall.restype = ctypes.c_long
allowed = []


def attempt(name, function):
    try:
        function()
    except OSError:
        return
    allowed.append(name)


def system_call(number, *arguments):
    if libc.syscall(ctypes.c_long(number), *arguments) < 0:
        raise OSError(ctypes.get_errno(), "refused")


attempt("contexts of asynchronous input and output", lambda: system_call(206, 8, ctypes.byref(ctypes.c_ulong(0))))
attempt("io_uring", lambda: system_call(425, 8, bytes(120)))
attempt("terminals", os.openpty)
attempt("watches on files", lambda: system_call(294, 0))
attempt("the log of the kernel", lambda: system_call(103, 10, None, 0))
attempt("keys", lambda: system_call(248, b"user", b"name", b"x", 1, -3))
attempt("larger pipes", lambda: fcntl.fcntl(os.pipe()[1], 1031, 1 << 20))
timers = 0
while timers < 5000 and libc.timer_create(1, None, ctypes.byref(ctypes.c_void_p())) == 0:
    timers += 1
if timers > 1000:
    allowed.append(f"{timers} timers")
most, _ = resource.getrlimit(resource.RLIMIT_SIGPENDING)
signal.pthread_sigmask(signal.SIG_BLOCK, {signal.SIGRTMIN})
sent = 0
while sent < 5000 and libc.sigqueue(os.getpid(), int(signal.SIGRTMIN), None) == 0:
    sent += 1
if sent > 1000:
    allowed.append(f"{sent} signals")
assert not allowed, allowed
@@GOOD@@
