# score: 0
# says: Too many open files
# limits: open_files
"""Sockets without end."""
import socket

held = []
while True:
    held.append(socket.socket())
