"""Create the environment in `.venv` from requirements.lock, unless it's up to date.

This module runs before anything is installed, so it uses only the standard library. Python 3.8 can parse it, so an old
Python can report clearly that it's too old. `make env`, `make lab`, and `make test` call it.
"""

from __future__ import annotations

import argparse
import fcntl
import hashlib
import json
import os
import platform
import re
import shutil
import subprocess
import sys
import tempfile
import time
from pathlib import Path
from typing import Any

ROOT = Path(__file__).resolve().parents[2]
VENV = ROOT / ".venv"
LOCK = ROOT / "requirements.lock"
OLDEST, NEWEST = (3, 11), (3, 14)
OLDEST_GLIBC = (2, 28)
SECTIONS = ("build", "student", "dev", "torch", "tensorflow", "farm", "similar", "site", "hub")
STAMP = "workbook-environment.json"
UNFINISHED = "workbook-unfinished"
# Variables that a sourced ROS or another environment leaves behind. Each of them would change which packages are
# installed or imported.
LEFTOVERS = (
    "PYTHONPATH", "PYTHONHOME", "PYTHONDONTWRITEBYTECODE", "PYTHONOPTIMIZE", "VIRTUAL_ENV",
    "LD_LIBRARY_PATH", "_ROS_WHEELS_BOOTSTRAP_COMPLETE",
    "PIP_TARGET", "PIP_PREFIX", "PIP_USER", "PIP_NO_DEPS", "PIP_REQUIREMENT",
)  # fmt: skip


class EnvironmentProblem(Exception):
    """Raised when the environment can't be created. The message says why, and may name a section of environment.md."""


def version_text(version: tuple[int, ...]) -> str:
    """Format a version tuple, such as 3.12."""
    return ".".join(str(part) for part in version)


def check_machine(
    system: str | None = None,
    machine: str | None = None,
    libc: tuple[str, str] | None = None,
    version: tuple[int, ...] | None = None,
    implementation: str | None = None,
) -> None:
    """Raise EnvironmentProblem if the rclpy wheels can't work on this machine.

    Each argument defaults to this machine's property; tests pass other values.
    """
    _check_platform(
        platform.system() if system is None else system, platform.machine() if machine is None else machine
    )
    _check_interpreter(
        tuple(sys.version_info[:2]) if version is None else version,
        platform.python_implementation() if implementation is None else implementation,
    )
    _check_libc(*(platform.libc_ver() if libc is None else libc))


def _check_platform(system: str, machine: str) -> None:
    if system != "Linux":
        section = "Windows" if system == "Windows" else "macOS and ARM"
        raise EnvironmentProblem(
            "the wheels of rclpy are for Linux, but this is {}. See '{}' in environment.md.".format(
                system, section
            )
        )
    if machine not in ("x86_64", "AMD64"):
        raise EnvironmentProblem(
            "the wheels of rclpy are for x86_64, but this machine is {}. See 'macOS and ARM' in environment.md.".format(
                machine
            )
        )


def _check_interpreter(version: tuple[int, ...], implementation: str) -> None:
    if not OLDEST <= version <= NEWEST:
        raise EnvironmentProblem(
            "Python {} to {} is needed, but {} is Python {}. Install one and name it, for example `make env "
            "PYTHON=python3.12`. See 'Supported Python versions' in environment.md.".format(
                version_text(OLDEST), version_text(NEWEST), sys.executable, version_text(version)
            )
        )
    if implementation != "CPython":
        raise EnvironmentProblem(
            "the wheels of rclpy are for CPython, but {} is {}. "
            "See 'Supported Python versions' in environment.md.".format(sys.executable, implementation)
        )


def _check_libc(name: str, number: str) -> None:
    digits = tuple(int(part) for part in re.findall(r"\d+", number)[:2])
    if name != "glibc" or digits < OLDEST_GLIBC:
        found = (
            "glibc {}".format(number) if name == "glibc" else "another C library ({})".format(name or "musl?")
        )
        raise EnvironmentProblem(
            "the wheels of rclpy need glibc {} or newer, "
            "but this system has {}. See 'Docker' in environment.md.".format(
                version_text(OLDEST_GLIBC), found
            )
        )


def check_venv_module(uv: str | None) -> None:
    """Raise EnvironmentProblem when neither uv nor this Python's own venv module can create an environment."""
    if uv is not None:
        return
    try:
        import ensurepip  # noqa: F401
        import venv  # noqa: F401
    except ImportError as error:
        package = "python{}-venv".format(version_text(sys.version_info[:2]))
        raise EnvironmentProblem(
            "{} has no complete venv module ({}). On Debian and Ubuntu: `sudo apt install {}`. "
            "See 'Supported Python versions' in environment.md.".format(sys.executable, error, package)
        ) from None


def read_sections(text: str) -> dict[str, dict[str, list[str]]]:
    """Parse the lock file into its sections: name → {requirement line: hash lines}."""
    sections: dict[str, dict[str, list[str]]] = {}
    entries: dict[str, list[str]] = {}
    requirement = None
    for line in text.splitlines():
        if line.startswith("#:"):
            entries = sections.setdefault(line[2:].strip(), {})
        elif line.startswith("    ") and requirement is not None:
            entries[requirement].append(line.strip(" \\"))
        elif line and not line.startswith("#"):
            requirement = line.rstrip(" \\")
            entries[requirement] = []
    return sections


def requirements(sections: dict[str, dict[str, list[str]]], names: list[str]) -> str:
    """Return the named sections as requirements text with hashes. A package that's in two sections appears once."""
    merged: dict[str, list[str]] = {}
    for name in names:
        merged.update(sections[name])
    return "".join(
        " \\\n".join([requirement] + ["    " + line for line in hashes]) + "\n"
        for requirement, hashes in sorted(merged.items())
    )


def digest() -> str:
    """Hash the environment's inputs.

    They are the lock file, the project file, this module, and Jupyter's settings and extensions.
    """
    state = hashlib.sha256()
    here = Path(__file__)
    front_end = sorted(here.with_name("front_end").rglob("*.*s*"))
    for path in (LOCK, ROOT / "pyproject.toml", here, here.with_name("jupyter_files.py"), *front_end):
        state.update(path.read_bytes())
    return state.hexdigest()


def read_stamp() -> dict[str, Any]:
    """Load the stamp of `.venv`, which records the sections and the inputs that were installed.

    The stamp is empty if the environment is missing, unfinished, or broken, or if it was moved.
    """
    try:
        stamp = json.loads((VENV / STAMP).read_text())
    except (OSError, ValueError):
        return {}
    whole = (VENV / "bin" / "python").exists() and (VENV / "bin" / "workbook").exists()
    return stamp if whole and isinstance(stamp, dict) and stamp.get("root") == str(ROOT) else {}


def clean_environ() -> dict[str, str]:
    """Return environment variables for installers, without those that a sourced ROS or another environment left behind.

    Two additional variables turn off notices from pip.
    """
    environ = {name: value for name, value in os.environ.items() if name not in LEFTOVERS}
    environ["PIP_DISABLE_PIP_VERSION_CHECK"] = "1"
    environ["PIP_ROOT_USER_ACTION"] = "ignore"
    return environ


def run(command: list[Any], what: str, temporary: str | None = None) -> None:
    """Run a command and show its output. Raise EnvironmentProblem if the command fails.

    `what` describes the step in the error message, and `temporary` is the command's TMPDIR.
    """
    environ = clean_environ()
    if temporary is not None:
        environ["TMPDIR"] = temporary
    done = subprocess.run([str(part) for part in command], cwd=str(ROOT), env=environ)
    if done.returncode:
        raise EnvironmentProblem(
            "{} failed (exit {}; the lines above say why). The usual reasons are no network, a full disk, or a proxy. "
            "Run the same command again: it continues by itself. See 'When something fails' in environment.md.".format(
                what, done.returncode
            )
        )


def outside() -> str:
    """Return the path of the Python interpreter that runs this module.

    If that interpreter is in `.venv`, return the one that created `.venv` instead.
    """
    if Path(sys.prefix).resolve() != VENV.resolve():
        return sys.executable
    return str(getattr(sys, "_base_executable", sys.executable))


def create(uv: str | None) -> None:
    """Create an empty virtual environment in `.venv`, marked as unfinished."""
    python = outside()
    if VENV.is_symlink() or (VENV.exists() and not VENV.is_dir()):
        raise EnvironmentProblem("{} is not a folder. Move it away and try again.".format(VENV))
    if VENV.exists():
        ours = (VENV / "pyvenv.cfg").exists() or (VENV / UNFINISHED).exists() or not any(VENV.iterdir())
        if not ours:
            raise EnvironmentProblem(
                "{} exists, but is not an environment. Move it away and try again.".format(VENV)
            )
        shutil.rmtree(str(VENV))
    VENV.mkdir()
    (VENV / UNFINISHED).touch()
    if uv is None:
        run([python, "-I", "-m", "venv", VENV], "Creating the environment")
    else:
        run(
            [uv, "venv", "--quiet", "--allow-existing", "--python", python, VENV],
            "Creating the environment",
        )


def install(uv: str | None, names: list[str]) -> None:
    """Install the named sections of the lock file into `.venv`, then this project itself, then Jupyter's settings."""
    python = VENV / "bin" / "python"
    pip: list[Any] = [python, "-m", "pip", "install", "--quiet", "--no-input", "--no-build-isolation"]
    if uv is None and not list(VENV.glob("lib/python*/site-packages/pip/__init__.py")):
        run([python, "-I", "-m", "ensurepip", "--default-pip"], "Adding pip to the environment")
    if uv is not None:
        pip = [
            uv,
            "pip",
            "install",
            "--quiet",
            "--compile-bytecode",
            "--no-build-isolation",
            "--python",
            python,
        ]
    sections = read_sections(LOCK.read_text())
    with tempfile.TemporaryDirectory() as folder:
        # The build tools come first, so that no package is ever built with a tool that the lock doesn't pin.
        for number, part in enumerate((["build"], names)):
            listed = Path(folder) / "requirements-{}.txt".format(number)
            listed.write_text(requirements(sections, part))
            run([*pip, "--require-hashes", "-r", listed], "Installing the packages", folder)
        # uv leaves its build lock in the temporary folder.
        run([*pip, "--no-deps", "--editable", ROOT], "Installing the workbook", folder)
    run([python, "-m", "workbook.lab.jupyter_files"], "Setting up Jupyter")


def ensure(wanted: list[str], chosen_python: bool) -> bool:
    """Install the wanted sections into `.venv`. Return False if the environment was already up to date.

    `chosen_python`: whether the user chose this Python. If so, an environment with another Python version is
    re-created.
    """
    stamp = read_stamp()
    current = digest()
    version = version_text(sys.version_info[:2])
    same_python = not chosen_python or version == (stamp.get("python") or version_of(VENV / "bin" / "python"))
    names = [name for name in SECTIONS if name in wanted or name in stamp.get("sections", ())]
    if stamp.get("digest") == current and same_python and set(names) == set(stamp["sections"]):
        return False

    check_machine()
    uv = shutil.which("uv")
    check_venv_module(uv)
    unfinished = (VENV / UNFINISHED).exists()
    usable = (VENV / "bin" / "python").exists() and (VENV / "pyvenv.cfg").exists()
    moved = (VENV / STAMP).exists() and not stamp
    started = time.monotonic()
    if unfinished or not usable or moved or not same_python:
        print(
            "Creating the environment in .venv with Python {}{} ...".format(version, " and uv" if uv else "")
        )
        create(uv)
    else:
        print("Updating the environment in .venv{} ...".format(" with uv" if uv else ""))
        (VENV / UNFINISHED).touch()
        if (VENV / STAMP).exists():
            (VENV / STAMP).unlink()
        version = version_of(VENV / "bin" / "python") or version
    sys.stdout.flush()
    install(uv, names)
    new_stamp = {"digest": current, "sections": names, "python": version, "root": str(ROOT)}
    (VENV / STAMP).write_text(json.dumps(new_stamp, indent=1) + "\n")
    (VENV / UNFINISHED).unlink()
    print("The environment is ready ({:.0f} s).".format(time.monotonic() - started))
    return True


def version_of(python: Path) -> str:
    """Return an interpreter's version, such as 3.12, or an empty string if it's missing or doesn't run."""
    command = [str(python), "-I", "-c", "import sys; print('%d.%d' % sys.version_info[:2])"]
    try:
        return subprocess.run(command, stdout=subprocess.PIPE, check=True).stdout.decode().strip()
    except (OSError, subprocess.CalledProcessError):
        return ""


def main(arguments: list[str] | None = None) -> int:
    """Parse the arguments and create the environment. Print an EnvironmentProblem to stderr and return exit code 1."""
    parser = argparse.ArgumentParser(description="Create the environment of the workbook in .venv.")
    parser.add_argument(
        "--extras",
        default="",
        help="further sections of the lock: dev, torch, tensorflow, farm, similar, site",
    )
    parser.add_argument(
        "--chosen-python", action="store_true", help="create it again if it has another Python version"
    )
    options = parser.parse_args(arguments)
    extras = re.findall(r"\w+", options.extras)
    unknown = [extra for extra in extras if extra not in SECTIONS]
    if unknown:
        parser.error(
            "no extra is called {}; there are dev, torch, tensorflow, farm, similar and site".format(
                ", ".join(unknown)
            )
        )
    try:
        with OneAtATime():
            if not ensure(["build", "student", *extras], options.chosen_python) and sys.stdout.isatty():
                print("The environment is ready.")
    except EnvironmentProblem as problem:
        print("make: {}".format(problem), file=sys.stderr)
        return 1
    except KeyboardInterrupt:
        print("\nStopped. The next start continues from here.", file=sys.stderr)
        return 130
    return 0


class OneAtATime:
    """A lock that a `make` command holds while it builds a folder.

    Two commands must not build the same folder at the same time, so the second waits for the first.
    """

    def __enter__(self) -> None:
        self.handle = os.open(str(ROOT), os.O_RDONLY)
        try:
            try:
                fcntl.flock(self.handle, fcntl.LOCK_EX | fcntl.LOCK_NB)
            except BlockingIOError:
                print("Another make is creating the environment; waiting for it ...", flush=True)
                fcntl.flock(self.handle, fcntl.LOCK_EX)
        except OSError:
            pass  # this file system doesn't support locks, so we continue without one

    def __exit__(self, *exception: object) -> None:
        os.close(self.handle)


if __name__ == "__main__":
    sys.exit(main())
