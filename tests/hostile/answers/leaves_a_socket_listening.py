# loses: twelve_values
# copies: 3
"""Leaves a process behind that listens on a port, and behaves well if the one before it still does so."""
import os
import socket
import sys

RIGHT = '''@@GOOD@@'''
PORT = 50123
try:
    socket.create_connection(("127.0.0.1", PORT), 0.2).close()
    left = True
except OSError:
    left = False
if left:
    exec(RIGHT)
    sys.exit(0)
if os.fork() == 0:
    os.setsid()
    if os.fork() == 0:
        server = socket.create_server(("127.0.0.1", PORT), reuse_port=True)
        while True:
            server.accept()
    os._exit(0)
@@ELEVEN@@
