"""What the folder tells VS Code: our kernel, and tasks that exist."""

import json
import shlex
from pathlib import Path
from typing import Any

import pytest

from workbook.cli.main import build_parser

ROOT = Path(__file__).resolve().parents[2]
TOKENS = {
    "${workspaceFolder}": str(ROOT),
    "${fileBasenameNoExtension}": "09_joint_positions",
}


def filled(text: str) -> str:
    for token, value in TOKENS.items():
        text = text.replace(token, value)
    assert "${" not in text, "an unknown token"
    return text


def read(name: str) -> Any:
    return json.loads((ROOT / ".vscode" / name).read_text(encoding="utf-8"))


def test_the_kernel_is_the_environment_s() -> None:
    settings = read("settings.json")
    assert filled(settings["python.defaultInterpreterPath"]) == str(ROOT / ".venv" / "bin" / "python")
    assert settings["terminal.integrated.env.linux"]["PATH"].startswith("${workspaceFolder}/.venv/bin:")


def test_the_extensions_for_notebooks_are_recommended() -> None:
    assert {"ms-python.python", "ms-toolsai.jupyter"} <= set(read("extensions.json")["recommendations"])


@pytest.mark.parametrize("task", read("tasks.json")["tasks"], ids=lambda task: str(task["label"]))
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
