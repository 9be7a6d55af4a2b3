"""A newcomer's first minutes on an empty Debian: an ordinary user types only the README's first command.

The machine is a root file system of Debian's own packages. Each command has separate mounts and processes, which end
with it. The source of pip's packages is passed in, because this machine may use its own package index.
"""

import os
import re
import shutil
import subprocess
import sys
import time
import urllib.error
import urllib.request
from collections.abc import Iterator
from pathlib import Path
from typing import NamedTuple

import pytest

from tests.programs.support import is_gone, wait_until
from workbook.inside.proc import process_tree

ROOT = Path(__file__).resolve().parents[2]
README = (ROOT / "README.md").read_text(encoding="utf-8")
NEEDED = ("ca-certificates", "git", "make", "python3", "python3-venv")
"""The tools that the README requires. Without certificates, nothing can be downloaded."""
HOME = "/home/student"
COURSE = f"{HOME}/rclpy-workbook"
URL = re.compile(r"http://(?:127\.0\.0\.1|localhost):\d+/\S*token=\w+")
ENTER = """
set -e
cd "$1"; shift
mount --rbind /dev dev
mount -t tmpfs tmpfs dev/shm
mount -t proc proc proc
for place in $PLACES; do
    mkdir -p ".$(dirname "$place")"
    if [ -d "$place" ]; then mkdir -p ".$place"; else touch ".$place"; fi
    mount --bind -o ro "$place" ".$place"
done
cp /etc/resolv.conf etc/resolv.conf
chroot --userspec=student:student . env -i HOME=/home/student PATH=/usr/bin:/bin LANG=C.UTF-8 "$@"
exit $?
"""
"""The last line keeps the shell in place.

When `unshare` ends, the shell and all of the machine's processes end, too.
"""


class PipSettings(NamedTuple):
    """Where pip gets packages on this machine: variables, and the folders and files that they name."""

    variables: list[str]
    places: list[str]

    @classmethod
    def of_this_machine(cls) -> "PipSettings":
        said = subprocess.run(
            [sys.executable, "-m", "pip", "config", "list"], capture_output=True, text=True, check=True
        ).stdout
        found = re.findall(r"^(?:global|install|:env:)\.([\w-]+)='(.*)'$", said, re.MULTILINE)
        words = [word.removeprefix("file://") for _, value in found for word in value.split()]
        places = [word for word in words if word.startswith("/") and Path(word).exists()]
        variables = [f"PIP_{name.replace('-', '_').upper()}={value}" for name, value in found]
        return cls(variables, places)

    def mounts(self, root: Path) -> set[str]:
        """Return the places to mount. A local index links to neighboring files, so all of `/opt` is mounted."""
        tops = {place: Path(*Path(place).parts[:2]) for place in self.places}
        return {place if any((root / top.name).iterdir()) else str(top) for place, top in tops.items()}


class Machine:
    """An empty Debian with a clone of the course in an ordinary user's home folder."""

    def __init__(self, root: Path, release: str) -> None:
        self._root = root
        self._pip = PipSettings.of_this_machine()
        make = ["mmdebstrap", "--quiet", "--variant=minbase", f"--include={','.join(NEEDED)}", release, root]
        subprocess.run([*map(str, make), *map(str, _sources(release))], check=True)
        self._mounts = self._pip.mounts(root)
        subprocess.run(["chroot", root, "useradd", "--create-home", "student"], check=True)
        place = root / COURSE.removeprefix("/")
        subprocess.run(["git", "clone", "--quiet", "--no-hardlinks", ROOT, place], check=True)
        subprocess.run(["chroot", root, "chown", "-R", "student:student", HOME], check=True)

    def start(self, command: str) -> "subprocess.Popen[str]":
        """Start a command as the student, in the course's folder."""
        return subprocess.Popen(
            [
                "unshare", "--mount", "--pid", "--ipc", "--fork", "--kill-child", "sh", "-c", ENTER, "enter",
                str(self._root), *self._pip.variables, "sh", "-c", f"cd {COURSE} && {command}",
            ],
            env={"PATH": os.environ["PATH"], "PLACES": " ".join(self._mounts)},
            stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True,
        )  # fmt: skip

    def do(self, command: str) -> str:
        """Run a command as the student, and return its output."""
        with self.start(command) as running:
            said, _ = running.communicate()
        assert running.returncode == 0, said
        return said


def address_in(running: "subprocess.Popen[str]") -> str:
    """Return the address that JupyterLab prints. If it ends without one, fail with its output."""
    assert running.stdout is not None
    said: list[str] = []
    while not (found := URL.search("".join(said[-1:]))):
        said.append(running.stdout.readline())
        assert said[-1], "".join(said)
    return found[0]


def answers(url: str) -> bool:
    """Return whether the address delivers a page; `False` while no server listens there."""
    try:
        with urllib.request.urlopen(url, timeout=60) as page:
            return bool(page.status == 200)
    except urllib.error.URLError as problem:
        if isinstance(problem.reason, ConnectionRefusedError):
            return False
        raise


def _sources(release: str) -> list[Path]:
    """Return this machine's package sources if they are the release's; otherwise, mmdebstrap uses its own."""
    return [
        path
        for path in Path("/etc/apt/sources.list.d").glob("*.sources")
        if f"Suites: {release}" in path.read_text(encoding="utf-8")
    ]


def _problem() -> str | None:
    if os.geteuid() != 0:
        return "only root can make a machine"
    return None if shutil.which("mmdebstrap") else "there is no mmdebstrap to make a machine with"


@pytest.fixture(scope="module", params=["bookworm", "trixie"])
def machine(request: pytest.FixtureRequest, tmp_path_factory: pytest.TempPathFactory) -> Iterator[Machine]:
    if problem := _problem():
        pytest.skip(problem)
    root = tmp_path_factory.mktemp(request.param) / "root"
    yield Machine(root, request.param)
    subprocess.run(["rm", "-rf", "--one-file-system", root], check=True)


@pytest.mark.slow
@pytest.mark.whole
class TestOnAnEmptyMachine:
    """The steps of a newcomer in order, on one machine per release."""

    def test_the_first_command_opens_the_lessons(self, machine: Machine) -> None:
        [command] = re.findall(r"^\| Linux .*\| `(make lab)` \|$", README, re.MULTILINE)
        began = time.monotonic()
        with machine.start(command) as running:
            try:
                url = address_in(running)
                # Jupyter Server prints its address before it listens there, so the first attempts may be refused.
                wait_until(lambda: answers(url), "JupyterLab answers")
                print(f"JupyterLab answers {time.monotonic() - began:.0f} s after `{command}`.")
                started = process_tree(running.pid)
            finally:
                running.kill()  # all processes of the machine end with it
            running.wait()
            wait_until(lambda: all(map(is_gone, started)), "the server and its kernels end")

    def test_the_doctor_finds_the_machine_ready(self, machine: Machine) -> None:
        assert "`make lab` opens the lessons" in machine.do(".venv/bin/workbook doctor")

    def test_the_first_lesson_shows_what_is_committed(self, machine: Machine) -> None:
        machine.do("make env EXTRAS=dev && .venv/bin/python -m workbook.authoring compare 00_start_here")

    def test_an_answer_is_checked(self, machine: Machine) -> None:
        stem = "09_joint_positions"
        right = f"tests/right_answers/{stem}/class_alone.py"
        assert "10 of 10 points" in machine.do(f".venv/bin/workbook check {stem} {right}")
