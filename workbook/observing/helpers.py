"""Processes of our own that serve this one over a pair of sockets, such as those that fork programs or run mypy."""

import socket
import subprocess
import sys
from collections.abc import Mapping
from pathlib import Path

from workbook.observing.orphans import spare


def start_helper(
    script: Path, environ: Mapping[str, str], *, quiet: bool = False
) -> tuple[subprocess.Popen[bytes], socket.socket]:
    """Start `script`, which finds the number of its socket in its only argument. Returns it, and our end.

    It does not hear Ctrl-C, which is for its owner, and no sweep of an answer's left-overs takes it along until
    `orphans.forget` is told its number. `quiet`: nobody sees what it writes to standard error.
    """
    ours, theirs = socket.socketpair(socket.AF_UNIX, socket.SOCK_SEQPACKET)
    with theirs:
        process = subprocess.Popen(
            [sys.executable, "-P", str(script), str(theirs.fileno())],
            stdin=subprocess.DEVNULL,
            stdout=subprocess.DEVNULL,
            stderr=subprocess.DEVNULL if quiet else None,
            env=dict(environ),
            cwd="/",
            pass_fds=[theirs.fileno()],
            start_new_session=True,
        )
    spare(process.pid)
    return process, ours
