# score: 0
# says: Too many open files
"""Sockets without end."""
import socket

held = []
while True:
    held.append(socket.socket())
