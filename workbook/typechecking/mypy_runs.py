"""Run mypy in a process that keeps it loaded. `inside/mypy_server.py` runs in that process."""

import atexit
import json
import os
import socket
import subprocess
import tempfile
import threading
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path

from workbook.inside.orphans import forget
from workbook.programs.helpers import start_helper

SERVER = "mypy_server"
STATUS_BYTES = 100


@dataclass(frozen=True)
class MypyRun:
    """A run of mypy: its arguments, folder, environment, and limits.

    `processor_s` limits the CPU time and `patience_s` the real time, in seconds. `memory` is in bytes.
    """

    arguments: Sequence[str]
    folder: Path
    environ: Mapping[str, str]
    processor_s: int
    memory: int
    patience_s: float

    def request(self) -> bytes:
        """Encode the request for `inside/mypy_server.py`."""
        request = {
            "arguments": [*self.arguments],
            "folder": str(self.folder),
            "environ": dict(self.environ),
            "processor_s": self.processor_s,
            "memory": self.memory,
        }
        return json.dumps(request).encode()


@dataclass(frozen=True)
class Outcome:
    """The result of a mypy run: its exit code, stdout, and stderr. A negative code is the signal that ended it."""

    code: int
    said: str
    complaint: str


class MypyServer:
    """A process that keeps mypy loaded. Loading accounts for two thirds of the time of a run over a short program.

    The process starts with the first run, and ends with the process that started it. Ctrl-C during a run ends it, too;
    the next run then starts another one.
    """

    def __init__(self) -> None:
        self._turn = threading.Lock()
        self._owner = 0
        self._process: subprocess.Popen[bytes] | None = None
        self._channel: socket.socket | None = None

    @property
    def pid(self) -> int | None:
        """The process ID; None if no process is running."""
        return None if self._process is None else self._process.pid

    def run(self, run: MypyRun) -> Outcome:
        """Run mypy. Raise TimeoutError after `patience_s` seconds, and OSError if the server process can't start."""
        with self._turn, tempfile.TemporaryFile() as said, tempfile.TemporaryFile() as complaint:
            descriptors = [said.fileno(), complaint.fileno()]
            told = self._ask(run, descriptors) or self._ask(
                run, descriptors
            )  # the server may have ended since the last run
            if not told:
                raise OSError("the process that runs mypy ends right away")
            texts = []
            for file in (said, complaint):
                file.seek(0)
                texts.append(file.read().decode(errors="replace"))
        return Outcome(os.waitstatus_to_exitcode(int(told)), *texts)

    def _ask(self, run: MypyRun, descriptors: Sequence[int]) -> bytes:
        """Send a request, and return the exit status that the server sends back; empty if the server has ended."""
        try:
            channel = self._open(run.environ)
            channel.settimeout(run.patience_s)
            socket.send_fds(channel, [run.request()], descriptors)
            told = channel.recv(STATUS_BYTES)
        except (BrokenPipeError, ConnectionResetError):
            told = b""
        except BaseException:
            self._close()
            raise
        if not told:
            self._close()
        return told

    def _open(self, environ: Mapping[str, str]) -> socket.socket:
        if self._channel is not None and self._owner == os.getpid():  # a forked child must not use it
            return self._channel
        self._process, ours = start_helper(SERVER, environ, quiet=True)
        if self._owner != os.getpid():
            atexit.register(self.close)
        self._owner, self._channel = os.getpid(), ours
        return ours

    def close(self) -> None:
        """End the process, if one is running. The next run starts another one."""
        with self._turn:
            if self._owner == os.getpid():
                self._close()

    def _close(self) -> None:
        if self._channel is not None:
            self._channel.close()  # this also ends a run in progress
            self._channel = None
        if self._process is not None:
            self._process.wait()
            forget(self._process.pid)
            self._process = None


mypy_server = MypyServer()
