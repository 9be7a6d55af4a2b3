"""Our VS Code settings, checked against its documentation: our kernel, and tasks whose commands work.

VS Code itself isn't installed here. Its file formats are documented at
https://code.visualstudio.com/docs/reference/tasks-appendix and
https://code.visualstudio.com/docs/reference/variables-reference.
"""

import json
import os
import shlex
import signal
import subprocess
import sys
from pathlib import Path
from typing import Any

import pytest

from workbook.cli.main import build_parser
from workbook.exercise.definition import load_exercise

ROOT = Path(__file__).resolve().parents[2]
STEM = "09_joint_positions"
TOKENS = {"${workspaceFolder}": str(ROOT), "${fileBasenameNoExtension}": STEM}
TASK_KEYS = {
    "label": str,
    "type": str,
    "command": str,
    "args": list,
    "options": dict,
    "group": dict,
    "presentation": dict,
    "isBackground": bool,
    "problemMatcher": list,
}
"""The documented properties of a task that we use, with their types."""
ALLOWED: dict[tuple[str, ...], set[Any]] = {
    ("type",): {"shell", "process"},
    ("group", "kind"): {"build", "test"},
    ("group", "isDefault"): {True, False},
    ("presentation", "panel"): {"shared", "dedicated", "new"},
    ("presentation", "focus"): {True, False},
    ("options", "cwd"): {"${workspaceFolder}"},
}


def filled(text: str) -> str:
    for token, value in TOKENS.items():
        text = text.replace(token, value)
    assert "${" not in text, "an unknown token"
    return text


def read(name: str) -> Any:
    return json.loads((ROOT / ".vscode" / name).read_text(encoding="utf-8"))


TASKS = {str(task["label"]): task for task in read("tasks.json")["tasks"]}


def test_the_kernel_is_the_environment_s() -> None:
    settings = read("settings.json")
    assert filled(settings["python.defaultInterpreterPath"]) == str(ROOT / ".venv" / "bin" / "python")
    assert settings["terminal.integrated.env.linux"]["PATH"].startswith("${workspaceFolder}/.venv/bin:")


def test_a_search_finds_the_student_s_copy_and_not_what_it_was_made_from() -> None:
    """Git ignores `work/`, and VS Code's search excludes by default what Git ignores."""
    settings = read("settings.json")
    hidden = settings["search.exclude"]
    assert settings["search.useIgnoreFiles"] is False
    assert {"notebooks/*.ipynb", "exercises/*.ipynb", "solutions", ".venv"} <= hidden.keys()
    assert not any(pattern in ("work", "work/**", "**/*.ipynb") for pattern in hidden)


def test_the_extensions_for_notebooks_are_recommended() -> None:
    assert {"ms-python.python", "ms-toolsai.jupyter"} <= set(read("extensions.json")["recommendations"])


def test_the_file_of_tasks_is_of_the_documented_version() -> None:
    file = read("tasks.json")
    assert set(file) == {"version", "tasks"} and file["version"] == "2.0.0"
    assert len(TASKS) == len(file["tasks"]), "two tasks of one name"


@pytest.mark.parametrize("task", TASKS.values(), ids=TASKS)
def test_a_task_is_of_the_documented_shape(task: dict[str, Any]) -> None:
    for key, value in task.items():
        assert isinstance(value, TASK_KEYS[key]), key
        for inner, chosen in value.items() if isinstance(value, dict) else [(None, value)]:
            place = (key,) if inner is None else (key, str(inner))
            if inner is not None or place in ALLOWED:
                assert chosen in ALLOWED[place], place
    assert {"label", "type", "command", "problemMatcher"} <= set(task)


@pytest.mark.parametrize("task", TASKS.values(), ids=TASKS)
def test_each_task_is_a_command_that_there_is(task: dict[str, Any]) -> None:
    line = filled(" ".join([task["command"], *task.get("args", [])]))
    targets = (ROOT / "Makefile").read_text(encoding="utf-8")
    for part in line.split("&&"):
        program, *arguments = shlex.split(part)
        if program == "make":
            assert f"\n{arguments[0]}:" in targets
        else:
            assert program.endswith(".venv/bin/workbook")
            options, rest = build_parser().parse_known_args(arguments)
            assert callable(options.run) and not rest


@pytest.fixture
def copy(tmp_path: Path) -> Path:
    """Make the folder that a student opens, with `work/` and an answer that gets full marks."""
    for name in ("notebooks", "exercises", "lesson_nodes", "solutions"):
        (tmp_path / name).symlink_to(ROOT / name)
    run(tmp_path, "lab", "--only-copy")
    solution = load_exercise(STEM, ROOT).source.solution_code
    (tmp_path / "work" / "answers" / f"{STEM}.py").write_text(solution, encoding="utf-8")
    return tmp_path


def environment(course: Path) -> dict[str, str]:
    kept = {name: os.environ[name] for name in ("PATH", "HOME", "LANG", "TMPDIR") if name in os.environ}
    return {**kept, "WORKBOOK_COURSE": str(course), "COLUMNS": "80"}


def run(course: Path, *arguments: str) -> "subprocess.CompletedProcess[str]":
    """Run the tasks' program in the environment of these tests."""
    return subprocess.run(
        [Path(sys.executable).with_name("workbook"), *arguments],
        cwd=course,
        env=environment(course),
        capture_output=True,
        text=True,
        timeout=300,
        check=False,
    )


def arguments_of(words: str) -> list[str]:
    """Return the arguments that the task with these words passes to `workbook`."""
    task = next(task for label, task in TASKS.items() if label.endswith(words))
    assert task["type"] == "process" and task["options"] == {"cwd": "${workspaceFolder}"}
    assert filled(task["command"]) == str(ROOT / ".venv" / "bin" / "workbook")
    return [filled(argument) for argument in task["args"]]


@pytest.mark.whole
@pytest.mark.slow
def test_the_tasks_for_an_exercise_do_what_they_say(copy: Path) -> None:
    hinted = run(copy, *arguments_of("a hint to this exercise"))
    assert hinted.returncode == 0 and "Hint 1" in hinted.stdout, hinted
    checked = run(copy, *arguments_of("check this exercise"))
    assert checked.returncode == 0 and "10 of 10 points" in checked.stdout, checked


@pytest.mark.slow
@pytest.mark.whole
def test_the_task_that_watches_judges_and_waits_for_the_next_save(copy: Path) -> None:
    watching = subprocess.Popen(
        [Path(sys.executable).with_name("workbook"), *arguments_of("check this exercise at each save")],
        cwd=copy,
        env={**environment(copy), "PYTHONUNBUFFERED": "1"},
        stdout=subprocess.PIPE,
        stderr=subprocess.STDOUT,
        text=True,
    )
    try:
        assert watching.stdout is not None
        for line in watching.stdout:
            if "10 of 10 points" in line:
                break
        else:
            pytest.fail("it ended before it had judged")
        assert watching.poll() is None
        watching.send_signal(signal.SIGINT)
        watching.communicate(timeout=60)
    finally:
        watching.kill()
        watching.wait()
