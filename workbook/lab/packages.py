"""Find packages of this environment that are missing or differ from requirements.lock."""

import shlex
import sys
from collections.abc import Callable
from dataclasses import dataclass
from importlib import metadata
from pathlib import Path

from workbook.exercise.course import course_folder, is_from_wheel
from workbook.lab import bootstrap
from workbook.lab.health import HealthFinding
from workbook.ros.environment import uses_wheels

ROS = "ros-"
"""Prefix of the ROS wheels' package names. The judge relies on their exact versions."""
_MOST = 6


@dataclass(frozen=True)
class Differing:
    """A package whose version isn't the locked one. `found` is None when the package is missing."""

    name: str
    found: str | None
    locked: str


def locked_versions(lock: str) -> dict[str, str]:
    """Parse the lock file's text, and return the versions of a student's packages for this Python, by name."""
    from packaging.requirements import Requirement

    versions = {}
    for line in bootstrap.read_sections(lock)["student"]:
        requirement = Requirement(line)
        if requirement.marker is None or requirement.marker.evaluate():
            [pin] = requirement.specifier
            versions[requirement.name] = pin.version
    return versions


def installed_version(name: str) -> str | None:
    """Return a package's version in this environment, or None if the package isn't installed."""
    try:
        return metadata.version(name)
    except metadata.PackageNotFoundError:
        return None


def differing(lock: str, version: Callable[[str], str | None] = installed_version) -> list[Differing]:
    """Compare an environment with the lock file's text, and return the differences, ROS packages first."""
    found = [
        Differing(name, there, wanted)
        for name, wanted in locked_versions(lock).items()
        if (there := version(name)) != wanted
    ]
    return sorted(found, key=lambda one: (not one.name.startswith(ROS), one.name))


def in_words(packages: list[Differing]) -> str:
    """Format the first six packages, each with its installed and its locked version, and count the remaining ones."""
    said = [f"{one.name} {one.found or 'missing'} (locked: {one.locked})" for one in packages[:_MOST]]
    more = len(packages) - _MOST
    return ", ".join(said) + (f", and {more} more" if more > 0 else "")


def check_packages() -> HealthFinding:
    """Report the main packages' versions, and whether the environment matches the lock file."""
    names = ["jupyterlab", "ipykernel", "matplotlib", "numpy"]
    if uses_wheels():
        names.insert(0, "ros-jazzy-rclpy")
    found = {name: installed_version(name) for name in names}
    saw = ", ".join(f"{name} {version}" for name, version in found.items() if version)
    if missing := [name for name, version in found.items() if not version]:
        return HealthFinding(
            "fix", "Packages", f"missing: {', '.join(missing)}; there: {saw or 'none'}", install_again()
        )
    if not uses_wheels():
        return HealthFinding(
            "note", "Packages", f"{saw}; rclpy comes from another ROS installation, not from the wheels"
        )
    stamp = bootstrap.read_stamp()
    if Path(sys.prefix).resolve() == bootstrap.VENV.resolve() and stamp.get("digest") != bootstrap.digest():
        return HealthFinding("fix", "Packages", f"{saw}; not what requirements.lock says", "Run `make env`.")
    return _compared_with_the_lock(saw)


def _compared_with_the_lock(saw: str) -> HealthFinding:
    lock = course_folder() / "requirements.lock"
    packages = differing(lock.read_text(encoding="utf-8")) if lock.is_file() else []
    if not packages:
        return HealthFinding("ok", "Packages", saw)
    todo = "Run `make clean`, then `make env`."
    if is_from_wheel():
        todo = f"Run `{shlex.quote(sys.executable)} -m pip install -r {shlex.quote(str(lock))}`."
    return HealthFinding(
        "fix" if packages[0].name.startswith(ROS) else "note",
        "Packages",
        in_words(packages),
        f"The course is tested with the locked versions. {todo}",
    )


def install_again() -> str:
    """Return a sentence that tells the user how to reinstall."""
    if is_from_wheel():
        return f"Run `{shlex.quote(sys.executable)} -m pip install --force-reinstall rclpy-workbook`."
    return "Run `make env`."
