# score: 0
"""Random packets to all ports on which DDS might listen."""
import os
import socket
import time

out = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
until = time.monotonic() + 20.0
while time.monotonic() < until:
    for port in range(7400, 7700):
        try:
            out.sendto(b"RTPS" + os.urandom(200), ("127.0.0.1", port))
        except OSError:
            pass
