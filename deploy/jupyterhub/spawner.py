"""Spawn a server for each student, with a separate network, processes, files, and limits."""

import asyncio
import subprocess
import sys
from pathlib import Path
from typing import Any

from jupyterhub.spawner import LocalProcessSpawner, SpawnException
from jupyterhub.traitlets import ByteSpecification
from jupyterhub.utils import random_port
from traitlets import Integer, Unicode

from deploy.jupyterhub.confine import confined, home_of
from deploy.jupyterhub.disks import GATE, NoDisk, attach, students_with_image
from deploy.jupyterhub.limits import Limits, join_files, make_groups, remove_groups
from deploy.jupyterhub.places import Place, place_of
from workbook.exercise.course import course_folder
from workbook.grading.slots.service import ADDRESS, SOCKET
from workbook.inside.proc import status
from workbook.isolation.host_files import PATH_OF_PROGRAMS

NO_DISK = "Your disk can't be opened. Your files are still there. Please tell your instructor: the hub's log says why."
RUNTIME = {"JUPYTER_RUNTIME_DIR": "/tmp/jupyter"}
"""Connection files are kept in memory, so that a student whose disk is full can start a kernel."""


class ClassSpawner(LocalProcessSpawner):
    """Starts `workbook lab` for one student behind a gate. The hub must run as root."""

    folder = Unicode("/srv/class", config=True, help="Where the class keeps its files.")
    first_id = Integer(700_000, config=True, help="The group of all instructors. Students' user ids follow.")
    processes = Integer(1000, config=True, help="How many processes and threads a student may have.")
    memory_folders = Integer(
        256 << 20, config=True, help="Bytes that /tmp and /dev/shm of a student hold each."
    )
    disk_limit = ByteSpecification(0, config=True, help="Bytes of a student's disk; 0: unlimited.")
    check_folder = Unicode(config=True, help="Where the class's check service listens; empty: there is none.")
    port: int
    groups: list[Path]

    def __init__(self, **options: Any) -> None:
        super().__init__(**options)
        self.groups = []

    def user_env(self, env: dict[str, str]) -> dict[str, str]:
        """Add the environment variables that an account would provide, because students have none on this machine."""
        name = self.user.name
        account = {"USER": name, "LOGNAME": name, "HOME": home_of(name), "SHELL": "/bin/bash"}
        check = {ADDRESS: f"{self.check_folder}/{SOCKET}"} if self.check_folder else {}
        return env | account | check | RUNTIME | {"PATH": PATH_OF_PROGRAMS}

    async def start(self) -> tuple[str, int]:
        """Start the server. Return its IP address and port."""
        self.port = self.port or random_port()
        place = place_of(self.user.name, Path(self.folder), self.first_id)
        await self.attach_disks(place)
        self.groups = make_groups(
            f"{self.hub.port}-{self.user.name}", Limits(self.mem_limit, self.cpu_limit, self.processes)
        )
        server = confined(
            [*self.cmd, *self.get_args()],
            place,
            course=course_folder(),
            memory_folders=self.memory_folders,
            is_instructor=self.user.admin,
            services=[Path(self.check_folder)] if self.check_folder else [],
        )
        gate = [sys.executable, "-I", "-S", str(GATE), f"--server={self.port}", f"--hub={self.hub.port}"]
        gate += [f"--processes={self.processes}", *(f"--join={file}" for file in join_files(self.groups))]
        self.log.info(
            "Limits of %s: %s", self.user.name, [str(group) for group in self.groups] or "no cgroups"
        )
        self.proc = subprocess.Popen(
            [*gate, "--", *server],
            stdin=subprocess.DEVNULL,
            env=self.get_env(),
            cwd="/",
            umask=0o022,
            start_new_session=True,
        )
        self.pid = self.proc.pid
        return ("127.0.0.1", self.port)

    async def attach_disks(self, place: Place) -> None:
        """Mount the student's image. For an instructor, who reads all hand-ins, mount all other images, too."""
        try:
            await asyncio.to_thread(attach, place, self.disk_limit)
        except NoDisk as problem:
            raise SpawnException(
                NO_DISK, reason="disk", log_message=str(problem), status_code=500
            ) from problem
        for name in students_with_image(place.top) if self.user.admin else []:
            try:
                await asyncio.to_thread(attach, place_of(name, place.top, self.first_id), self.disk_limit)
            except NoDisk as problem:
                self.log.error("The hand-ins of %s can't be read. %s", name, problem)

    async def poll(self) -> int | None:
        """Return None while the server runs. Afterward, return its exit code, or 0 if the exit code isn't known.

        After a restart of the hub, the gate is another process's child. When the gate ends, it stays a zombie until
        that process reaps it, and JupyterHub would assume that the server is still running.
        """
        if self.proc is None and self.pid and _is_zombie(self.pid):
            self.clear_state()
            return 0
        exit_code: int | None = await super().poll()
        return exit_code

    def get_state(self) -> dict[str, Any]:
        """Return the state to save: the process and its cgroups, so that a restarted hub can end both."""
        state: dict[str, Any] = super().get_state()
        return state | {"groups": [str(group) for group in self.groups]}

    def load_state(self, state: dict[str, Any]) -> None:
        """Take over a server that an earlier hub process started."""
        super().load_state(state)
        self.groups = [Path(group) for group in state.get("groups", [])]

    def clear_state(self) -> None:
        """Clear the state of a server that has ended, and remove its cgroups."""
        super().clear_state()
        remove_groups(self.groups)
        self.groups = []


def _is_zombie(pid: int) -> bool:
    try:
        return status(pid)["State"].startswith("Z")
    except OSError:
        return False
