# score: 10
"""Fills pairs of sockets that nobody reads: none takes more than the machine gives to every one."""
import socket

one, other = socket.socketpair()
one.setblocking(False)
one.setsockopt(socket.SOL_SOCKET, socket.SO_SNDBUF, 100_000_000)
sent = 0
try:
    while sent < 50_000_000:
        sent += one.send(bytes(10_000))
except BlockingIOError:
    pass
with open("/proc/sys/net/core/wmem_default") as file:
    usual = int(file.read())
assert sent <= usual, f"a pair of sockets holds {sent} bytes"
@@GOOD@@
