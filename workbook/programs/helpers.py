"""Start helper processes that fork programs or run mypy for this process, on requests through a socket pair."""

import socket
import subprocess
import sys
from collections.abc import Mapping

from workbook.inside import RUN
from workbook.inside.orphans import exempt


def start_helper(
    name: str, environ: Mapping[str, str], *, quiet: bool = False
) -> tuple[subprocess.Popen[bytes], socket.socket]:
    """Run a file of `workbook.inside`, and pass it one end of a socket pair. Return its process and the other end.

    The helper runs in its own session, because Ctrl-C in the terminal is meant for the helper's owner only.
    `orphans.sweep_orphans` spares the helper until its process ID is passed to `orphans.forget`. `quiet`: whether to
    discard the helper's standard error.
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
