# score: 0
# limits: sockets
"""Opens sockets without end, in as many processes as it takes."""
import os
import socket
import time

held = []
for number in range(6):
    if os.fork() == 0:
        held += [socket.socket(socket.AF_INET, socket.SOCK_DGRAM) for _ in range(100)]
        time.sleep(60)
time.sleep(60)
