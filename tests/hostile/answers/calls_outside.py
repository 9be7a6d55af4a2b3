# score: 10
"""Tries to reach a listener of the machine on its loopback."""
import socket

try:
    socket.create_connection(("127.0.0.1", @@PORT@@), timeout=1.0)
    raise SystemExit("the machine can be reached")
except OSError:
    pass
@@GOOD@@