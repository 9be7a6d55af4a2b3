"""Imports point one way: down the floors of `workbook/`, and never from the bench into lessons or solutions."""

import ast
import subprocess
import sys
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[2]
FLOORS = (
    ("ros",),
    ("observing",),
    ("exercise", "criteria"),
    ("feedback", "pictures"),
    ("grading",),
    ("cli", "magics", "lesson", "lab", "authoring"),
)
FLOOR_OF = {package: number for number, floor in enumerate(FLOORS) for package in floor}
MESSAGES = {
    "std_msgs",
    "sensor_msgs",
    "geometry_msgs",
    "nav_msgs",
    "trajectory_msgs",
    "diagnostic_msgs",
    "std_srvs",
}
MODULES = sorted((ROOT / "workbook").rglob("*.py"))


def imported(path: Path) -> set[str]:
    """Full names of all modules that a file imports, wherever in the file."""
    names: set[str] = set()
    for node in ast.walk(ast.parse(path.read_text(encoding="utf-8"))):
        if isinstance(node, ast.Import):
            names |= {alias.name for alias in node.names}
        elif isinstance(node, ast.ImportFrom) and node.module:
            names.add(node.module)
            names |= {f"{node.module}.{alias.name}" for alias in node.names}
    return names


def label(path: Path) -> str:
    return str(path.relative_to(ROOT))


def test_every_package_stands_on_a_floor() -> None:
    packages = {path.parent.name for path in (ROOT / "workbook").glob("*/__init__.py")}
    assert packages == set(FLOOR_OF)


@pytest.mark.parametrize("path", MODULES, ids=label)
def test_imports_point_down(path: Path) -> None:
    parts = path.relative_to(ROOT / "workbook").parts
    names = imported(path)
    assert not {name for name in names if name.split(".")[0] in ("lesson_nodes", "solutions", "tests")}
    if len(parts) < 2:
        return
    own = FLOOR_OF[parts[0]]
    for name in names:
        pieces = name.split(".")
        if pieces[0] == "workbook" and len(pieces) > 1 and pieces[1] in FLOOR_OF:
            assert FLOOR_OF[pieces[1]] <= own, f"{label(path)} is on floor {own} and imports {name}"


@pytest.mark.parametrize("path", sorted((ROOT / "exercises" / "criteria").glob("*.py")), ids=label)
def test_criteria_import_the_vocabulary_and_messages_only(path: Path) -> None:
    for name in imported(path):
        top = name.split(".")[0]
        assert name.startswith("workbook.criteria") or top in MESSAGES | set(sys.stdlib_module_names), name


@pytest.mark.parametrize("path", sorted((ROOT / "lesson_nodes").glob("*.py")), ids=label)
def test_lesson_nodes_import_rclpy_and_messages_only(path: Path) -> None:
    for name in imported(path):
        top = name.split(".")[0]
        assert top in {"rclpy", "lesson_nodes"} | MESSAGES | set(sys.stdlib_module_names), name


def test_no_path_of_a_machine_and_no_registry_host_is_tracked() -> None:
    hosts = "|".join(("pypi", r"registry\.npmjs", r"deb\.debian")) + r"\.org"
    here = str(ROOT).replace(".", r"\.")
    pattern = rf"(python{'hosted'}|https?://({hosts})|{here}/|/{'root'}/[.])"
    found = subprocess.run(
        ["git", "grep", "-nIE", pattern, "--", ".", f":!{Path(__file__).relative_to(ROOT)}"],
        cwd=ROOT,
        capture_output=True,
        text=True,
    )
    if found.returncode not in (0, 1):
        pytest.skip(f"no git checkout: {found.stderr.strip()}")
    assert found.stdout == ""
