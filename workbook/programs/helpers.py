"""Processes of our own that serve this one over a pair of sockets, such as those that fork programs or run mypy."""

import socket
import subprocess
import sys
from collections.abc import Mapping

from workbook.inside import RUN
from workbook.inside.orphans import exempt


def start_helper(
    name: str, environ: Mapping[str, str], *, quiet: bool = False
) -> tuple[subprocess.Popen[bytes], socket.socket]:
    """Start a file of `workbook.inside` with its end of a socket pair as argument. Returns the process and our end.

    Ctrl-C does not reach the helper, because it is for its owner. No sweep of left-over processes kills it until
    `orphans.forget` gets its number. `quiet`: its standard error is discarded.
    """
    ours, theirs = socket.socketpair(socket.AF_UNIX, socket.SOCK_SEQPACKET)
    with theirs:
        process = subprocess.Popen(
            [sys.executable, "-P", str(RUN), name, str(theirs.fileno())],
            stdin=subprocess.DEVNULL,
            stdout=subprocess.DEVNULL,
            stderr=subprocess.DEVNULL if quiet else None,
            env=dict(environ),
            cwd="/",
            pass_fds=[theirs.fileno()],
            start_new_session=True,
        )
    exempt(process.pid)
    return process, ours
