"""Run a student's JupyterLab: `workbook lab` with its own course folder and home. Find leftovers when it ends."""

import contextlib
import json
import os
import re
import select
import signal
import subprocess
import sys
import threading
import time
from collections.abc import Iterable, Mapping
from pathlib import Path
from types import MappingProxyType
from typing import Any

import psutil

ROOT = Path(__file__).resolve().parents[2]
START_LIMIT_S = 90.0
STOP_LIMIT_S = 20.0
COURSE = ("notebooks", "exercises", "solutions", "lesson_nodes")
_ADDRESS = re.compile(r"http://127\.0\.0\.1:\d+/\S*token=\w+")
_INHERITED = ("PATH", "LANG", "LC_ALL", "TMPDIR")
# A killed test run can't clean up, so JupyterLab ends with the process that started it.
_ENDS_WITH_ITS_PARENT = (
    "import ctypes, os, signal, sys; "
    "PR_SET_PDEATHSIG = 1; "
    "ctypes.CDLL(None).prctl(PR_SET_PDEATHSIG, signal.SIGTERM); "
    "os.execv(sys.argv[1], sys.argv[1:])"
)


def descendants(pid: int) -> set[psutil.Process]:
    """Return all processes below `pid`, in any session.

    Process objects are returned, because the ids are reused in the course of all tests.
    """
    try:
        return set(psutil.Process(pid).children(recursive=True))
    except psutil.NoSuchProcess:
        return set()


def running(processes: Iterable[psutil.Process]) -> dict[int, str]:
    """Return the processes that still run, with their command lines."""
    found = {}
    for process in processes:
        with contextlib.suppress(psutil.NoSuchProcess):
            if process.is_running() and process.status() != psutil.STATUS_ZOMBIE:
                found[process.pid] = " ".join(process.cmdline())
    return found


def await_end(processes: Iterable[psutil.Process], limit_s: float) -> dict[int, str]:
    """Wait until all have ended, for `limit_s` at most. Return those that have not, with their command lines."""
    deadline = time.monotonic() + limit_s
    processes = set(processes)
    for process in processes:
        try:
            handle = os.pidfd_open(process.pid)
        except (
            ProcessLookupError,
            FileNotFoundError,
        ):  # gone, or on its way out: the kernel may raise either error
            continue
        try:
            if process.is_running():  # and its id has not been reused
                select.select([handle], [], [], max(0.0, deadline - time.monotonic()))
        finally:
            os.close(handle)
    return running(processes)


class StudentLab:
    """A running JupyterLab on a fresh copy of the course. `url` is the address it prints, token included.

    `environ`: additional variables for it and its kernels.
    """

    def __init__(self, folder: Path, environ: Mapping[str, str] = MappingProxyType({})) -> None:
        course, home = folder / "course", folder / "home"
        course.mkdir(parents=True, exist_ok=True)  # at a later start, it exists already
        home.mkdir(exist_ok=True)
        # If a manual save meets an autosave, JupyterLab asks which version to keep.
        settings = home / ".jupyter" / "lab" / "user-settings" / "@jupyterlab" / "docmanager-extension"
        settings.mkdir(parents=True, exist_ok=True)
        (settings / "plugin.jupyterlab-settings").write_text('{"autosave": false}')
        for name in COURSE:
            if not (course / name).exists():
                (course / name).symlink_to(ROOT / name)
        self.work = course / "work"
        self.url = ""
        self.said: list[str] = []
        self._seen: set[psutil.Process] = set()
        inherited = {name: os.environ[name] for name in _INHERITED if name in os.environ}
        command = [Path(sys.executable).with_name("workbook"), "lab", "--no-browser", "--port=0"]
        self._process = subprocess.Popen(
            [sys.executable, "-c", _ENDS_WITH_ITS_PARENT, *command],
            env={
                **inherited,
                "HOME": str(home),
                "WORKBOOK_COURSE": str(course),
                "OPENBLAS_NUM_THREADS": "1",
                **environ,
            },
            stdout=subprocess.PIPE,
            stderr=subprocess.STDOUT,
            text=True,
            start_new_session=True,
        )
        self.itself = psutil.Process(self._process.pid)
        ready = threading.Event()
        self._reader = threading.Thread(target=self._read, args=(ready,), daemon=True)
        self._reader.start()
        ready.wait(START_LIMIT_S)
        if not self.url:
            self.close()
            raise AssertionError("JupyterLab did not start:\n" + "".join(self.said))

    def _read(self, ready: threading.Event) -> None:
        assert self._process.stdout is not None
        for line in self._process.stdout:
            self.said.append(line)
            if not self.url and (found := _ADDRESS.search(line)):
                self.url = found[0]
                ready.set()
        ready.set()

    @property
    def address(self) -> str:
        """The server's address, such as http://127.0.0.1:40117."""
        return "/".join(self.url.split("/")[:3])

    @property
    def token(self) -> str:
        return self.url.rpartition("token=")[2]

    def notebook(self, path: str) -> dict[str, Any]:
        """Read a notebook of the student's copy from disk."""
        content: dict[str, Any] = json.loads((self.work / path).read_text(encoding="utf-8"))
        return content

    def processes(self) -> set[psutil.Process]:
        """Return the processes below the server: kernels, slots, nodes."""
        below = descendants(self._process.pid)
        self._seen |= below
        return below

    def close(self) -> dict[int, str]:
        """Stop JupyterLab. End the processes that still run then, and return them with their command lines."""
        self.processes()
        everything = self._seen | {self.itself}
        self._process.send_signal(signal.SIGTERM)
        left = await_end(everything, STOP_LIMIT_S)
        for process in everything:
            if process.pid in left:
                with contextlib.suppress(psutil.NoSuchProcess):
                    process.kill()
        self._process.wait()
        self._reader.join(5.0)
        if self._process.stdout is not None:
            self._process.stdout.close()
        return left
