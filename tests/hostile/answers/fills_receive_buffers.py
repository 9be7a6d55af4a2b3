# score: 0
# limits: sockets
"""Sends to sockets that nobody reads: what waits in them counts against one figure of the whole machine. Ends at 100 MB."""
import socket
import time

held = []
sender = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
for _ in range(100):
    receiver = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
    receiver.setsockopt(socket.SOL_SOCKET, socket.SO_RCVBUF, 1_000_000)
    receiver.bind(("127.0.0.1", 0))
    held.append(receiver)
    for _ in range(16):
        sender.sendto(bytes(60_000), receiver.getsockname())
    time.sleep(0.01)
time.sleep(60)
