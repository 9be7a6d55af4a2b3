"""A small farm on this machine's loopback: a scheduler and workers as separate processes."""

import json
import os
import signal
import subprocess
import sys
from collections.abc import Iterator, Mapping
from contextlib import contextmanager
from pathlib import Path

from tests.programs.support import is_gone, wait_until
from workbook.inside.proc import process_tree

ROOT = Path(__file__).resolve().parents[2]
LOOPBACK = ("--host", "127.0.0.1", "--dashboard-address", "127.0.0.1:0", "--no-dashboard")
GOES_WITHIN_S = 30.0
DASK = str(Path(sys.executable).with_name("dask"))


class LittleFarm:
    """The farm's processes and its scheduler's address. All files stay below `folder`."""

    def __init__(self, folder: Path) -> None:
        self.folder = folder
        self.started: list[subprocess.Popen[bytes]] = []
        self._seen: set[int] = set()
        file = folder / "scheduler.json"
        self.scheduler = self._start("scheduler", "--port", "0", "--scheduler-file", file, *LOOPBACK)
        wait_until(lambda: self._has_address(file))
        self.address: str = json.loads(file.read_text())["address"]

    @staticmethod
    def _has_address(file: Path) -> bool:
        return file.exists() and file.read_text().rstrip().endswith("}")

    def environment(self, changes: Mapping[str, str]) -> dict[str, str]:
        temporary = self.folder / "tmp"
        temporary.mkdir(exist_ok=True)
        own = {"DASK_CONFIG": str(self.folder / "no_config"), "TMPDIR": str(temporary)}
        return {**os.environ, **own, **changes}

    def _start(
        self, *arguments: object, changes: Mapping[str, str] | None = None
    ) -> "subprocess.Popen[bytes]":
        log = (self.folder / f"{len(self.started)}-{arguments[0]}.log").open("wb")
        with log:
            process = subprocess.Popen(
                [DASK, *map(str, arguments)],
                cwd=ROOT,
                env=self.environment(changes or {}),
                stdin=subprocess.DEVNULL,
                stdout=log,
                stderr=subprocess.STDOUT,
                start_new_session=True,
            )
        self.started.append(process)
        return process

    def worker(self, *options: object, nanny: bool = False, **changes: str) -> "subprocess.Popen[bytes]":
        """Start a worker that judges three answers at a time. `changes`: changes to its environment.

        A `nanny` restarts the worker when it dies, but doubles the start time.
        """
        place = self.folder / f"worker{len(self.started)}"
        process = self._start(
            *("worker", self.address, *LOOPBACK, "--nthreads", 3, "--local-directory", place, *options),
            "--nanny" if nanny else "--no-nanny",
            changes=changes,
        )
        wait_until(lambda: "Registered to" in self.log(process) or process.poll() is not None)
        assert process.poll() is None, self.log(process)
        return process

    def log(self, process: "subprocess.Popen[bytes]") -> str:
        """Return what a process of the farm has printed."""
        [path] = self.folder.glob(f"{self.started.index(process)}-*.log")
        return path.read_text(errors="replace")

    def processes(self) -> set[int]:
        """Return the farm's processes, slots and answers included:

        those that run now, and those seen by earlier calls.
        """
        for process in self.started:
            self._seen |= set(process_tree(process.pid))
        return self._seen

    def _shared_memory(self) -> set[Path]:
        """Return the shared memory that the farm's processes use now."""
        found = set()
        for pid in self.processes():
            try:
                maps = Path(f"/proc/{pid}/maps").read_text()
            except OSError:
                continue
            found |= {Path(line.split()[5]) for line in maps.splitlines() if " /dev/shm/sem.mp-" in line}
        return found

    def end_workers(self) -> None:
        """End the workers with Ctrl-C, kill those that remain, and wait until the scheduler has forgotten them.

        If all were killed at the same time, no process would be left to remove the shared memory of the dead ones.
        """
        self._end([process for process in self.started if process is not self.scheduler])
        if self.scheduler.poll() is None:
            wait_until(lambda: self._said("Remove worker") == self._said("Register worker"))

    def _said(self, words: str) -> int:
        return self.log(self.scheduler).count(words)

    def end(self) -> None:
        """End all started processes, workers first."""
        self.end_workers()
        self._end([self.scheduler])
        wait_until(lambda: all(map(is_gone, self._seen)))

    def _end(self, started: list["subprocess.Popen[bytes]"]) -> None:
        running = [process for process in started if process.poll() is None]
        shared = self._shared_memory() if running else set()
        for process in reversed(running):
            process.send_signal(signal.SIGINT)
            try:
                process.wait(GOES_WITHIN_S)
            except subprocess.TimeoutExpired:
                process.kill()
                process.wait()
        below = self._seen - {self.scheduler.pid}
        wait_until(lambda: all(map(is_gone, below)) or not any(map(Path.exists, shared)))
        for process in started:
            try:
                os.killpg(process.pid, signal.SIGKILL)
            except ProcessLookupError:
                pass
        wait_until(lambda: all(map(is_gone, below)))
        assert not [path for path in shared if path.exists()], "shared memory is left behind"

    def grade(self, *arguments: object, **changes: str) -> "subprocess.Popen[str]":
        """Run `workbook grade ... --farm` on this farm."""
        command = ("grade", *arguments, "--exercise", "joint_positions", "--farm", self.address)
        return subprocess.Popen(
            [sys.executable, "-m", "workbook.cli.main", *map(str, command)],
            cwd=ROOT,
            env=self.environment(changes),
            stdout=subprocess.PIPE,
            stderr=subprocess.PIPE,
            text=True,
        )


@contextmanager
def little_farm(folder: Path) -> Iterator[LittleFarm]:
    """Start a scheduler without workers. At the end, stop it and everything that was started on it."""
    folder.mkdir()
    farm = LittleFarm(folder)
    try:
        yield farm
    finally:
        farm.end()


def parent_of(pid: int) -> int:
    """Return the parent of `pid`, or 0 if there is none."""
    try:
        return int(Path(f"/proc/{pid}/stat").read_text().rsplit(")", 1)[1].split()[1])
    except OSError:
        return 0


def ancestors_of(pid: int) -> list[int]:
    """Return the ancestors of `pid`, beginning with its parent."""
    found: list[int] = []
    while pid := parent_of(pid):
        found.append(pid)
    return found
