"""Run a hub with simulated students on this machine, for tests and measurements."""

import os
import signal
import socket
import subprocess
import sys
import time
from collections.abc import Callable, Iterator, Sequence
from concurrent.futures import ThreadPoolExecutor
from contextlib import contextmanager
from pathlib import Path
from typing import TypeVar

import psutil

from deploy.jupyterhub import disks
from deploy.jupyterhub.limits import PREFIX, remove_groups
from deploy.jupyterhub.places import STUDENTS
from tests.hub.simulated_student import SimulatedStudent
from workbook.inside.orphans import adopt_orphans
from workbook.inside.proc import OWN_MOUNTS, read_text, running_users

ROOT = Path(__file__).resolve().parents[2]
FIRST_ID = 700_000
PASSWORD = "for simulated students only"
INSTRUCTOR = "instructor"
PASSWORD_OF_INSTRUCTORS = "for a simulated instructor only, and long enough"
LONGEST_WAIT_S = 300.0
POLL_S = 0.2
Returned = TypeVar("Returned")


def wait_until(holds: Callable[[], bool], what: str) -> None:
    """Wait for a condition that has to be polled. Raises AssertionError if it doesn't become true in time."""
    deadline = time.monotonic() + LONGEST_WAIT_S
    while not holds():
        assert time.monotonic() < deadline, f"after {LONGEST_WAIT_S:g} s: {what}"
        time.sleep(POLL_S)


def at_once(
    work: Callable[[SimulatedStudent], Returned], students: Sequence[SimulatedStudent]
) -> list[Returned]:
    """Let all students do something at the same time."""
    with ThreadPoolExecutor(len(students)) as threads:
        return list(threads.map(work, students))


class ClassServer:
    """A hub whose files are all below one folder."""

    def __init__(self, folder: Path, *options: str, check_slots: int | None = None) -> None:
        self.folder = folder
        self.port = _three_ports()
        self.log = folder.with_name(f"{folder.name}.log")
        self._options = options
        self._check_slots = {} if check_slots is None else {"CLASS_CHECK_SLOTS": str(check_slots)}
        self._hub: subprocess.Popen[bytes] | None = None

    @property
    def address(self) -> str:
        """The hub's address for browsers."""
        return f"http://127.0.0.1:{self.port}"

    def start(self) -> None:
        """Start the hub, and wait until it responds."""
        command = [
            sys.executable,
            "-m",
            "jupyterhub",
            "-f",
            str(ROOT / "deploy/jupyterhub/jupyterhub_config.py"),
        ]
        environ = {
            "CLASS_FOLDER": str(self.folder),
            "CLASS_PASSWORD": PASSWORD,
            "CLASS_INSTRUCTORS_PASSWORD": PASSWORD_OF_INSTRUCTORS,
            "CLASS_PORT": str(self.port),
            **({"CLASS_DISK": "0"} if disks.missing() else {}),
            "PYTHONPATH": "",
        }
        with self.log.open("ab") as log:
            self._hub = subprocess.Popen(
                [*command, *self._options],
                cwd=ROOT,
                env=os.environ | environ | self._check_slots,
                stdout=log,
                stderr=log,
            )
        wait_until(self._answers, f"the hub does not answer; see {self.log}")

    def _answers(self) -> bool:
        assert self._hub is not None and self._hub.poll() is None, self.log.read_text(errors="replace")[
            -3000:
        ]
        try:
            return self.student("probe", log_in=False).get("/hub/health").ok
        except OSError:
            return False

    def stop(self) -> None:
        """End the hub as a service manager would. The students' servers keep running."""
        if self._hub is not None:
            self._hub.send_signal(signal.SIGTERM)
            self._hub.wait(LONGEST_WAIT_S)
            self._hub = None

    def student(self, name: str, *, log_in: bool = True) -> SimulatedStudent:
        """Log in as a student."""
        password = PASSWORD_OF_INSTRUCTORS if name == INSTRUCTOR else PASSWORD
        return SimulatedStudent(self.address, name, password if log_in else None)

    def user_id(self, name: str) -> int:
        """Return a student's user id."""
        return (self.folder / STUDENTS / name / "home").stat().st_uid

    def processes(self, name: str) -> list[int]:
        """Return the ids of all processes that run as this student."""
        return [pid for pid, user in running_users() if user == self.user_id(name)]

    def seen(self, path: Path) -> Path:
        """Return where this process sees a path of the class folder as the hub does, with the students' disks."""
        assert self._hub is not None
        return Path(f"/proc/{self._hub.pid}/root{path}")

    def loop_devices(self) -> list[str]:
        """Return the students' disks that are in use."""
        return [line for line in _output("losetup", "--output", "NAME,BACK-FILE") if str(self.folder) in line]

    def gates(self) -> list[psutil.Process]:
        """Return the gates: each holds a student's server, which ends with it."""
        return [one for one in psutil.process_iter() if f"--hub={self.port + 1}" in _command_line(one)]

    def groups(self) -> list[Path]:
        """Return the cgroups of the students' servers."""
        prefix = f"{PREFIX}{self.port + 1}-"
        # unlike rglob, os.walk ignores groups that are removed during the search
        below = os.walk("/sys/fs/cgroup")
        return [Path(top, name) for top, names, _ in below for name in names if name.startswith(prefix)]

    def left(self) -> list[object]:
        """Return the gates, processes, cgroups, disks, and mounts of students that are still there."""
        first, last = FIRST_ID, FIRST_ID + 1000
        users = [pid for pid, user in running_users() if first <= user < last]
        mounts = [line for line in read_text(OWN_MOUNTS).splitlines() if str(self.folder) in line]
        return [*self.gates(), *users, *self.groups(), *self.loop_devices(), *mounts]

    def end_everything(self) -> None:
        """End the hub and all servers, in any state."""
        self.stop()
        for gate in self.gates():
            gate.kill()
        remove_groups(self.groups())


def _output(*command: str) -> list[str]:
    return subprocess.run(command, capture_output=True, text=True, check=True).stdout.splitlines()


def _command_line(process: psutil.Process) -> list[str]:
    try:
        return list(process.cmdline())
    except psutil.Error:
        return []


def _three_ports() -> int:
    """Return the first of three consecutive ports on which no process listens."""
    while True:
        with socket.socket() as any_port:
            any_port.bind(("127.0.0.1", 0))
            first = int(any_port.getsockname()[1])
        try:
            for port in range(first, first + 3):
                socket.create_server(("127.0.0.1", port)).close()
        except OSError:
            continue
        return first


@contextmanager
def class_server(folder: Path, *options: str, check_slots: int | None = None) -> Iterator[ClassServer]:
    """Run a hub, and end all of it afterward. With `check_slots`, the hub judges answers on that many slots.

    The orphans of a stopped hub become our children, and we don't reap them. The same happens in a container whose
    first process isn't an init.
    """
    adopt_orphans()
    server = ClassServer(folder, *options, check_slots=check_slots)
    try:
        server.start()
        yield server
    finally:
        server.end_everything()
