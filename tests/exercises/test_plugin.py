"""The pytest plugin: the criteria as tests, on a stored recording or on an answer that the plugin runs."""

import os
import re
import subprocess
import sys
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[2]
CRITERIA = ROOT / "exercises" / "criteria" / "09_joint_positions.py"
RECORDINGS = ROOT / "tests" / "recordings" / "09_joint_positions"


def pytest_run(*arguments: str, folder: Path = ROOT) -> "subprocess.CompletedProcess[str]":
    environ = {name: value for name, value in os.environ.items() if not name.startswith("PYTEST")}
    command = [
        sys.executable,
        "-m",
        "pytest",
        "-p",
        "workbook.exercise.pytest_plugin",
        "-p",
        "no:cacheprovider",
    ]
    return subprocess.run(
        [*command, "-v", "-ra", "--color=no", "-W", "ignore", *arguments],
        cwd=folder,
        env=environ,
        capture_output=True,
        text=True,
    )


def outcomes(text: str) -> dict[str, str]:
    return {
        found[1]: found[2]
        for found in re.finditer(
            r"::(\w+) (PASSED|FAILED|SKIPPED|ERROR)", text.split("short test summary")[0]
        )
    }


ALL = (
    "program_runs joint_topic twelve_values finite_in_range joints_move joint_rate status_kept battery_kept "
    "alive_at_end"
).split()


@pytest.mark.parametrize(
    ("recording", "failed", "skipped", "words"),
    [
        ("solution", set(), set(), ()),
        (
            "eleven_values",
            {"twelve_values"},
            set(),
            ("saw: every message has 11 values", "expected: exactly 12"),
        ),
        (
            "wrong_name",
            {"joint_topic"},
            {"twelve_values", "finite_in_range", "joints_move", "joint_rate"},
            (
                "cause: publishes.other-name",
                "saw: your node publishes on /robot/joint_angles",
                "because: ",
                "try: ",
                "not judged",
            ),
        ),
    ],
)
def test_one_test_per_criterion_of_a_stored_recording(
    recording: str, failed: set[str], skipped: set[str], words: tuple[str, ...]
) -> None:
    done = pytest_run(str(CRITERIA), "--recording", str(RECORDINGS / f"{recording}.json"))
    expected = {
        name: "FAILED" if name in failed else "SKIPPED" if name in skipped else "PASSED" for name in ALL
    }
    assert outcomes(done.stdout) == expected, done.stdout
    assert list(outcomes(done.stdout)) == ALL
    assert done.returncode == (1 if failed else 0)
    for word in words:
        assert word in done.stdout
    assert "in runtest" not in done.stdout, "a criterion that fails shows its words and no traceback"


def test_an_answer_is_run_once_and_judged(tmp_path: Path) -> None:
    answer = tmp_path / "answer.py"
    answer.write_text("print('no robot here')\n")
    done = pytest_run(str(CRITERIA), "--answer", str(answer))
    found = outcomes(done.stdout)
    assert found.pop("program_runs") == "FAILED"
    assert set(found.values()) == {"SKIPPED"}
    assert "the program ended after" in done.stdout


def test_a_recording_that_is_none_is_an_error_and_no_verdict(tmp_path: Path) -> None:
    broken = tmp_path / "broken.json"
    broken.write_text("[]")
    done = pytest_run(str(CRITERIA), "--recording", str(broken))
    assert done.returncode == 1
    assert "this is not a recording" in done.stdout


def test_without_its_options_the_plugin_collects_nothing() -> None:
    done = pytest_run("--collect-only", "-q", str(CRITERIA.parent))
    assert "no tests collected" in done.stdout


def test_without_the_plugin_a_criteria_file_is_no_test_file() -> None:
    done = subprocess.run(
        [
            sys.executable,
            "-m",
            "pytest",
            "-q",
            "--collect-only",
            "-p",
            "no:cacheprovider",
            str(CRITERIA.parent),
        ],
        cwd=ROOT,
        capture_output=True,
        text=True,
    )
    assert done.returncode == pytest.ExitCode.NO_TESTS_COLLECTED
