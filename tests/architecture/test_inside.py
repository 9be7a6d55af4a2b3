"""The files of `workbook/inside` need only the standard library, each other, and the exceptions listed here."""

import re
import subprocess
import sys
from pathlib import Path

import pytest

from tests.architecture.test_layers import ROOT, imported, label
from workbook.inside import RUN
from workbook.isolation.host_files import HOST_FILES

INSIDE = ROOT / "workbook" / "inside"
FILES = sorted(path for path in INSIDE.glob("*.py") if path.name != "__init__.py")
MAY_IMPORT = {
    "host.py": {"rclpy"},
    "tier_probe.py": {"rclpy", "std_msgs"},
    "mypy_server.py": {"mypy"},
    "tap.py": {"rclpy"},
    "machine_tap.py": {"rclpy"},
}
"""What each file may import in addition to the standard library.

`import_cache.py` imports by name what answers need.
"""
STARTED_BY_RUN = ("confine", "fork_server", "group_keeper", "host", "mypy_server", "subreaper", "sweeper")
PROC = re.compile(r"[\"']/proc/")
MENTIONS_PROC = {
    "workbook/inside/proc.py",
    "workbook/inside/descriptors.py",
    "workbook/inside/landlock.py",
    "workbook/inside/tier_probe.py",
}
"""The module that reads /proc with its part about open files, Landlock's rule that allows it, and a helper program."""


@pytest.mark.parametrize("path", FILES, ids=label)
def test_it_imports_the_standard_library_and_its_siblings_only(path: Path) -> None:
    siblings = {"workbook.inside", *(f"workbook.inside.{one.stem}" for one in FILES)}
    for name in imported(path):
        top = name.split(".")[0]
        allowed = sys.stdlib_module_names | MAY_IMPORT.get(path.name, set())
        if top == "workbook":
            assert name in siblings or name.rpartition(".")[0] in siblings, name
        else:
            assert top in allowed, name


@pytest.mark.parametrize("name", STARTED_BY_RUN)
def test_it_is_loaded_without_the_workbook(name: str) -> None:
    """Only this folder can be imported, and none of its modules stay loaded."""
    program = (
        "import runpy, sys\n"
        "space = runpy.run_path(sys.argv[1])\n"
        "import importlib\n"
        "original = importlib.import_module\n"
        "def load(name):\n"
        "    module = original(name)\n"
        "    module.main = lambda arguments: print(arguments, [one for one in sys.modules if 'workbook' in one])\n"
        "    return module\n"
        "importlib.import_module = load\n"
        "space['main'](sys.argv[2], ['one'])\n"
    )
    isolated = [] if name in ("host", "fork_server", "mypy_server") else ["-I", "-S"]
    done = subprocess.run(
        [sys.executable, *isolated, "-c", program, str(RUN), name], capture_output=True, text=True, cwd="/"
    )
    assert done.stdout == "['one'] []\n", done.stderr


def test_the_files_that_a_sandbox_holds_are_those_that_the_host_needs() -> None:
    needed, waiting = set(), {"host"}
    while waiting:
        name = waiting.pop()
        needed.add(f"{name}.py")
        found = imported(INSIDE / f"{name}.py")
        below = {one.split(".")[2] for one in found if one.startswith("workbook.inside.")}
        waiting |= {one for one in below if f"{one}.py" not in needed and (INSIDE / f"{one}.py").is_file()}
    assert {*needed, RUN.name} == set(HOST_FILES)


def test_one_module_reads_proc() -> None:
    readers = {
        label(path) for path in (ROOT / "workbook").rglob("*.py") if PROC.search(path.read_text("utf-8"))
    }
    assert readers <= MENTIONS_PROC
