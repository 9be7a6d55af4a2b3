"""Run mypy in a server process that keeps mypy loaded. The server's code is in `inside/mypy_server.py`."""

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

    `processor_s` is the limit on CPU time and `patience_s` the limit on real time, both in seconds. `memory` is in
    bytes.
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
    """The result of a mypy run: its exit code, stdout, and stderr. A code -n means that signal n killed mypy."""

    code: int
    said: str
    complaint: str


class MypyServer:
    """A process that keeps mypy loaded, because loading takes two thirds of the time for checking a short program.

    The process starts with the first run and exits when the process that started it does. Ctrl-C during a run stops the
    server process, too. The next run then starts a new one.
    """

    def __init__(self) -> None:
        self._turn = threading.Lock()
        self._owner = 0
        self._process: subprocess.Popen[bytes] | None = None
        self._channel: socket.socket | None = None

    @property
    def pid(self) -> int | None:
        """The server's process ID, or None if the server isn't running."""
        return None if self._process is None else self._process.pid

    def run(self, run: MypyRun) -> Outcome:
        """Run mypy. Raise TimeoutError after `patience_s` seconds, and OSError if the server process can't start."""
        with self._turn, tempfile.TemporaryFile() as said, tempfile.TemporaryFile() as complaint:
            descriptors = [said.fileno(), complaint.fileno()]
            told = self._ask(run, descriptors) or self._ask(
                run, descriptors
            )  # the server may have exited since the last run
            if not told:
                raise OSError("the process that runs mypy ends right away")
            texts = []
            for file in (said, complaint):
                file.seek(0)
                texts.append(file.read().decode(errors="replace"))
        return Outcome(os.waitstatus_to_exitcode(int(told)), *texts)

    def _ask(self, run: MypyRun, descriptors: Sequence[int]) -> bytes:
        """Send a request, and return the exit status that the server sends back, or b"" if the server has exited."""
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
        if self._channel is not None and self._owner == os.getpid():  # not in a forked child
            return self._channel
        self._process, ours = start_helper(SERVER, environ, quiet=True)
        if self._owner != os.getpid():
            atexit.register(self.close)
        self._owner, self._channel = os.getpid(), ours
        return ours

    def close(self) -> None:
        """Stop the server if it's running. The next run starts a new one."""
        with self._turn:
            if self._owner == os.getpid():
                self._close()

    def _close(self) -> None:
        if self._channel is not None:
            self._channel.close()  # the server then exits, and stops a run in progress
            self._channel = None
        if self._process is not None:
            self._process.wait()
            forget(self._process.pid)
            self._process = None


mypy_server = MypyServer()
