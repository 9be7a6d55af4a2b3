"""The `workbook` command and the Makefile, as a person uses them."""

import os
import re
import subprocess
import sys
from pathlib import Path

import pytest

from workbook.cli.main import main

ROOT = Path(__file__).resolve().parents[2]
HEAVY = ("rclpy", "numpy", "matplotlib", "IPython", "jupyter_client", "asyncio", "std_msgs")


def test_help_lists_the_commands(capsys: pytest.CaptureFixture[str]) -> None:
    with pytest.raises(SystemExit) as ended:
        main(["--help"])
    assert ended.value.code == 0
    said = capsys.readouterr().out
    for command in ("lab", "reset", "doctor", "check", "grade"):
        assert re.search(rf"^\s+{command}\s", said, re.MULTILINE), command


def test_building_the_command_line_imports_nothing_heavy() -> None:
    code = "import sys; from workbook.cli.main import build_parser; build_parser(); print(*sys.modules)"
    done = subprocess.run(
        [sys.executable, "-c", code], capture_output=True, text=True, check=True, timeout=60
    )
    assert not set(HEAVY) & set(done.stdout.split())


@pytest.fixture
def other_ros(tmp_path: Path) -> dict[str, str]:
    """Return the environment of a shell that sourced another ROS, whose rclpy doesn't work here."""
    (tmp_path / "rclpy").mkdir()
    (tmp_path / "rclpy" / "__init__.py").write_text("raise ImportError('built for another Python')\n")
    return os.environ | {"PYTHONPATH": str(tmp_path), "RMW_IMPLEMENTATION": "rmw_cyclonedds_cpp"}


def test_a_sourced_ros_does_not_reach_the_command(other_ros: dict[str, str]) -> None:
    command = [sys.executable, "-m", "workbook.cli.main", "doctor"]
    done = subprocess.run(command, env=other_ros, capture_output=True, text=True, timeout=120)
    lines = {line[7:].split("  ")[0].strip(): line for line in done.stdout.splitlines() if line[:1] in "✓!✗"}
    assert "note" in lines["Shell"]
    assert "RMW_IMPLEMENTATION" in done.stdout
    assert "ok" in lines["rclpy"][:6]
    assert "ok" in lines["Two processes"][:6]


def test_unknown_arguments_are_refused_where_nobody_takes_them(capsys: pytest.CaptureFixture[str]) -> None:
    with pytest.raises(SystemExit) as ended:
        main(["doctor", "--quick"])
    assert ended.value.code == 2
    assert "--quick" in capsys.readouterr().err


def test_reset_of_an_unknown_exercise(capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["reset", "flying"]) == 2
    assert "no exercise 'flying'" in capsys.readouterr().err


def test_the_copy_may_be_made_without_opening_anything(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    for name in ("exercises", "notebooks"):
        (tmp_path / name).symlink_to(ROOT / name)
    monkeypatch.setenv("WORKBOOK_COURSE", str(tmp_path))
    assert main(["lab", "--only-copy"]) == 0
    assert "notebooks to work/." in capsys.readouterr().out
    assert (tmp_path / "work" / "exercises" / "09_joint_positions.ipynb").is_file()
    assert main(["lab", "--only-copy"]) == 0
    assert capsys.readouterr().out == "Your copy in work/ is up to date.\n"


def test_make_help_has_a_line_for_every_target() -> None:
    text = (ROOT / "Makefile").read_text(encoding="utf-8")
    (phony,) = re.findall(r"^\.PHONY: (.+)$", text, re.MULTILINE)
    said = subprocess.run(
        ["make", "help"], cwd=ROOT, capture_output=True, text=True, check=True, timeout=60
    ).stdout
    targets = re.findall(r"^([a-z-]+):", text, re.MULTILINE)
    assert re.findall(r"^  make (\S+)\s+\S", said, re.MULTILINE) == targets
    assert sorted(targets) == sorted(phony.split())
