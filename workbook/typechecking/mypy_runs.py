"""Running mypy in a process that has it ready: the other side of `inside/mypy_server.py`."""

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
    """One run of mypy: where, in which environment, and what it may use (s of processor time, bytes, s)."""

    arguments: Sequence[str]
    folder: Path
    environ: Mapping[str, str]
    processor_s: int
    memory: int
    patience_s: float

    def request(self) -> bytes:
        """As `inside/mypy_server.py` reads it."""
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
    """How a run of mypy has ended (negative: the signal that ended it), what it said, and what it complained of."""

    code: int
    said: str
    complaint: str


class MypyServer:
    """A process in which mypy is loaded. To load it is two thirds of what a run over a short program takes.

    It starts with the first run and ends with its owner. Ctrl-C in the middle of a run ends it, too; the next run
    starts another one.
    """

    def __init__(self) -> None:
        self._turn = threading.Lock()
        self._owner = 0
        self._process: subprocess.Popen[bytes] | None = None
        self._channel: socket.socket | None = None

    @property
    def pid(self) -> int | None:
        """Its process number; None while there is none."""
        return None if self._process is None else self._process.pid

    def run(self, run: MypyRun) -> Outcome:
        """Run mypy. Raises TimeoutError after its patience, OSError when there is no process for it."""
        with self._turn, tempfile.TemporaryFile() as said, tempfile.TemporaryFile() as complaint:
            descriptors = [said.fileno(), complaint.fileno()]
            told = self._ask(run, descriptors) or self._ask(
                run, descriptors
            )  # it may have ended since the last run
            if not told:
                raise OSError("the process that runs mypy ends at once")
            texts = []
            for file in (said, complaint):
                file.seek(0)
                texts.append(file.read().decode(errors="replace"))
        return Outcome(os.waitstatus_to_exitcode(int(told)), *texts)

    def _ask(self, run: MypyRun, descriptors: Sequence[int]) -> bytes:
        """Send one request; what is told of its end, nothing when the server has ended."""
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
        if self._channel is not None and self._owner == os.getpid():  # a fork of its owner has none
            return self._channel
        self._process, ours = start_helper(SERVER, environ, quiet=True)
        if self._owner != os.getpid():
            atexit.register(self.close)
        self._owner, self._channel = os.getpid(), ours
        return ours

    def close(self) -> None:
        """End the process, if there is one. The next run starts another."""
        with self._turn:
            if self._owner == os.getpid():
                self._close()

    def _close(self) -> None:
        if self._channel is not None:
            self._channel.close()  # which also ends a run that is under way
            self._channel = None
        if self._process is not None:
            self._process.wait()
            forget(self._process.pid)
            self._process = None


mypy_server = MypyServer()
