"""A small farm on this machine's loopback: a scheduler and workers as processes of their own."""

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
    """What was started, and where its scheduler is. Everything stays below `folder`."""

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
        """Start a worker that takes three answers at once. `changes`: of its environment.

        With a `nanny` it is started anew when it dies, and takes twice as long to start.
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
        """What a process of the farm has printed."""
        [path] = self.folder.glob(f"{self.started.index(process)}-*.log")
        return path.read_text(errors="replace")

    def processes(self) -> set[int]:
        """All processes of the farm, slots and answers too, that are there or were when this was asked before."""
        for process in self.started:
            self._seen |= set(process_tree(process.pid))
        return self._seen

    def _shared_memory(self) -> set[Path]:
        """Shared memory that processes of the farm use now."""
        found = set()
        for pid in self.processes():
            try:
                maps = Path(f"/proc/{pid}/maps").read_text()
            except OSError:
                continue
            found |= {Path(line.split()[5]) for line in maps.splitlines() if " /dev/shm/sem.mp-" in line}
        return found

    def end_workers(self) -> None:
        """End the workers with Ctrl-C, kill what does not go, and wait until the scheduler has forgotten them.

        Whoever kills all at once kills those as well who would remove the shared memory of the dead.
        """
        self._end([process for process in self.started if process is not self.scheduler])
        if self.scheduler.poll() is None:
            wait_until(lambda: self._said("Remove worker") == self._said("Register worker"))

    def _said(self, words: str) -> int:
        return self.log(self.scheduler).count(words)

    def end(self) -> None:
        """End what was started, workers first."""
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
        """`workbook grade ... --farm` of this farm."""
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
    """A scheduler without workers; whatever is started on it is ended."""
    folder.mkdir()
    farm = LittleFarm(folder)
    try:
        yield farm
    finally:
        farm.end()


def parent_of(pid: int) -> int:
    """The process that started `pid`; 0 when there is none."""
    try:
        return int(Path(f"/proc/{pid}/stat").read_text().rsplit(")", 1)[1].split()[1])
    except OSError:
        return 0


def ancestors_of(pid: int) -> list[int]:
    """From the parent of `pid` upwards."""
    found: list[int] = []
    while pid := parent_of(pid):
        found.append(pid)
    return found
