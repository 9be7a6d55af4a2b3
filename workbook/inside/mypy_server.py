"""Run mypy on request. This process imports mypy only once and forks for each run.

    python -P run.py mypy_server CHANNEL

CHANNEL is the file descriptor of an inherited socket. It carries one request after another (see `Run`), each with two
descriptors: one for mypy's findings, and one for its errors. The reply to each request is mypy's exit status (from
`os.waitpid`). When the other end of the channel is closed, this process kills mypy if it's running, and exits.
"""

import gc
import json
import os
import resource
import select
import signal
import socket
import sys
from collections.abc import Sequence
from dataclasses import dataclass
from typing import NoReturn

import mypy.__main__

from workbook.inside.libc import set_parent_death_signal

REQUEST_BYTES = 100_000
FAILED = 3


@dataclass(frozen=True)
class Run:
    """One run of mypy: its arguments, working directory, environment, and limits on CPU time (s) and memory (bytes)."""

    arguments: list[str]
    folder: str
    environ: dict[str, str]
    processor_s: int
    memory: int


def become_mypy(run: Run, parent: int, outputs: Sequence[int]) -> NoReturn:
    """Run mypy in this forked process, and exit with its code.

    `outputs`: the descriptors for mypy's findings and errors.
    """
    code = FAILED
    try:
        set_parent_death_signal()
        if os.getppid() != parent:
            os._exit(FAILED)
        os.dup2(outputs[0], 1)
        os.dup2(outputs[1], 2)
        os.closerange(3, os.sysconf("SC_OPEN_MAX"))
        os.chdir(run.folder)
        os.environ.clear()
        os.environ.update(run.environ)
        resource.setrlimit(resource.RLIMIT_AS, (run.memory, run.memory))
        resource.setrlimit(resource.RLIMIT_CPU, (run.processor_s, run.processor_s + 1))
        sys.argv = ["mypy", *run.arguments]
        mypy.__main__.console_entry()
        code = 0
    except SystemExit as end:
        code = end.code if isinstance(end.code, int) else FAILED
    except BaseException as error:
        os.write(2, f"{type(error).__name__}: {error}\n".encode())
    sys.stdout.flush()
    os._exit(code)


def ended(child: int, channel: socket.socket) -> int | None:
    """Wait until `child` exits, and return its exit status.

    If the channel is closed first, kill `child` and return None.
    """
    watched = select.poll()
    handle = os.pidfd_open(child)
    watched.register(handle, select.POLLIN)
    watched.register(channel, select.POLLIN)  # nothing is sent in the meantime, so it can only be closed
    ready = [descriptor for descriptor, _ in watched.poll()]
    os.close(handle)
    if handle not in ready:
        os.kill(child, signal.SIGKILL)
    status = os.waitpid(child, 0)[1]
    return status if handle in ready else None


def serve(channel: socket.socket) -> None:
    """Run mypy for each request until the channel is closed."""
    while True:
        data, outputs, _, _ = socket.recv_fds(channel, REQUEST_BYTES, 2)
        if not data:
            return
        parent = os.getpid()
        child = os.fork()
        if child == 0:
            become_mypy(Run(**json.loads(data)), parent, outputs)
        for descriptor in outputs:
            os.close(descriptor)
        status = ended(child, channel)
        if status is None:
            return
        channel.send(str(status).encode())


def main(arguments: Sequence[str]) -> None:
    """Run mypy for each request until the channel is closed."""
    gc.collect()
    gc.freeze()
    serve(socket.socket(fileno=int(arguments[0])))
