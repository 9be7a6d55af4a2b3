"""A student's JupyterLab: `workbook lab` in a course folder and a home of its own, and what is left when it ends."""

import json
import os
import re
import select
import signal
import subprocess
import sys
import threading
import time
from pathlib import Path
from typing import Any

ROOT = Path(__file__).resolve().parents[2]
START_LIMIT_S = 90.0
STOP_LIMIT_S = 20.0
COURSE = ("notebooks", "exercises", "solutions")
_ADDRESS = re.compile(r"http://127\.0\.0\.1:\d+/\S*token=\w+")
_INHERITED = ("PATH", "LANG", "LC_ALL", "TMPDIR")
# Whoever stops the tests does not let them tidy up: JupyterLab then ends with the process that started it.
_ENDS_WITH_ITS_PARENT = (
    "import ctypes, os, signal, sys; "
    "PR_SET_PDEATHSIG = 1; "
    "ctypes.CDLL(None).prctl(PR_SET_PDEATHSIG, signal.SIGTERM); "
    "os.execv(sys.argv[1], sys.argv[1:])"
)


def descendants(pid: int) -> set[int]:
    """All processes below `pid`, whatever session they moved to."""
    children: dict[int, list[int]] = {}
    for entry in Path("/proc").iterdir():
        if entry.name.isdigit():
            try:
                parent = int((entry / "stat").read_text().rpartition(")")[2].split()[1])
            except (OSError, ValueError):
                continue
            children.setdefault(parent, []).append(int(entry.name))
    found: list[int] = list(children.get(pid, []))
    for member in found:
        found += children.get(member, [])
    return set(found)


def running(pids: set[int]) -> dict[int, str]:
    """Those of `pids` that still run, with their command lines."""
    found = {}
    for pid in pids:
        entry = Path("/proc") / str(pid)
        try:
            if (entry / "stat").read_text().rpartition(")")[2].split()[0] != "Z":
                found[pid] = (entry / "cmdline").read_bytes().replace(b"\0", b" ").decode().strip()
        except OSError:
            continue
    return found


def await_end(pids: set[int], limit_s: float) -> dict[int, str]:
    """Wait until all `pids` have ended, `limit_s` at most. Returns those that have not, with their command lines."""
    deadline = time.monotonic() + limit_s
    for pid in pids:
        try:
            handle = os.pidfd_open(pid)
        except (ProcessLookupError, FileNotFoundError):  # gone, or going: the kernel says either
            continue
        try:
            select.select([handle], [], [], max(0.0, deadline - time.monotonic()))
        finally:
            os.close(handle)
    return running(pids)


class StudentLab:
    """A running JupyterLab on a fresh copy of the course. `url` is what it prints, token included."""

    def __init__(self, folder: Path) -> None:
        course, home = folder / "course", folder / "home"
        course.mkdir(parents=True)
        home.mkdir()
        # Saving by hand while JupyterLab saves by itself makes it ask which version to keep.
        settings = home / ".jupyter" / "lab" / "user-settings" / "@jupyterlab" / "docmanager-extension"
        settings.mkdir(parents=True)
        (settings / "plugin.jupyterlab-settings").write_text('{"autosave": false}')
        for name in COURSE:
            (course / name).symlink_to(ROOT / name)
        self.work = course / "work"
        self.url = ""
        self.said: list[str] = []
        self._seen: set[int] = set()
        environ = {name: os.environ[name] for name in _INHERITED if name in os.environ}
        command = [Path(sys.executable).with_name("workbook"), "lab", "--no-browser", "--port=0"]
        self._process = subprocess.Popen(
            [sys.executable, "-c", _ENDS_WITH_ITS_PARENT, *command],
            env={**environ, "HOME": str(home), "WORKBOOK_COURSE": str(course), "OPENBLAS_NUM_THREADS": "1"},
            stdout=subprocess.PIPE,
            stderr=subprocess.STDOUT,
            text=True,
            start_new_session=True,
        )
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
        """Where the server listens, such as http://127.0.0.1:40117."""
        return "/".join(self.url.split("/")[:3])

    @property
    def token(self) -> str:
        return self.url.rpartition("token=")[2]

    def notebook(self, path: str) -> dict[str, Any]:
        """A notebook of the student's copy, as it is on disk."""
        content: dict[str, Any] = json.loads((self.work / path).read_text(encoding="utf-8"))
        return content

    def processes(self) -> dict[int, str]:
        """What runs below the server: kernels, slots, nodes, with their command lines."""
        below = descendants(self._process.pid)
        self._seen |= below
        return running(below)

    def close(self) -> dict[int, str]:
        """Stop JupyterLab. Returns what of it still runs then, and ends that too."""
        self.processes()
        everything = self._seen | {self._process.pid}
        self._process.send_signal(signal.SIGTERM)
        left = await_end(everything, STOP_LIMIT_S)
        for pid in left:
            try:
                os.kill(pid, signal.SIGKILL)
            except ProcessLookupError:
                pass
        self._process.wait()
        self._reader.join(5.0)
        if self._process.stdout is not None:
            self._process.stdout.close()
        return left
