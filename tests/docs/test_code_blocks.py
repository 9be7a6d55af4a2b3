"""Every code block of the manuals works: criteria judge recordings, commands can be parsed, and tables can be read."""

import ast
import csv
import random
import re
import runpy
import shlex
import textwrap
import tomllib
from collections.abc import Iterator
from dataclasses import replace
from pathlib import Path
from typing import Any

import pytest
import rclpy.logging  # noqa: F401  (message packages need it loaded)
from sensor_msgs.msg import Image
from std_msgs.msg import Float32, Float32MultiArray
from std_srvs.srv import Trigger

import workbook.criteria as see
from tests.docs.test_readme import ALL_PAGES, ROOT
from workbook.cli.main import build_parser
from workbook.criteria import Recording, criterion, program_runs, topic, watching
from workbook.criteria.vocabulary.type_checks import probe
from workbook.exercise.definition import OWN_CRITERIA, load_exercise
from workbook.exercise.judgement import judge_recording
from workbook.grading.appeals import COLUMNS, read_lines

STEM = "09_joint_positions"
QUOTED = "02_nodes"
"""The exercise whose criteria and feedback docs/judge.md quotes."""
JOINTS = "/robot/joint_positions"
RECORDINGS = ROOT / "tests" / "recordings" / STEM
_FENCE = re.compile(r"^```(\w*)\n(.*?)^```$", re.MULTILINE | re.DOTALL)
_INDENTED = re.compile(r"(?:^ {4}.*\n)+", re.MULTILINE)
SOURCES = ("# %%", "# ---", "# **1.", "# [solution]", "# loses:")
"""A block with such a line is part of a lesson, an exercise, or a wrong answer, which have their own checks."""


def blocks(name: str) -> list[tuple[str, str]]:
    """Return the fenced blocks of a page: language and text."""
    return _FENCE.findall((ROOT / name).read_text(encoding="utf-8"))


def pieces(language: str) -> list[Any]:
    return [
        pytest.param(name, text, id=f"{name}-{number}")
        for name in ALL_PAGES
        for number, (told, text) in enumerate(blocks(name))
        if told == language
    ]


def command_lines(name: str) -> Iterator[str]:
    """Return the `workbook` commands in fenced and indented blocks, as one types them."""
    text = (ROOT / name).read_text(encoding="utf-8")
    shown = [*(block for told, block in blocks(name) if not told), *_INDENTED.findall(_FENCE.sub("", text))]
    for block in shown:
        for line in block.replace("\\\n", " ").splitlines():
            typed = line.strip().removeprefix("$ ").removeprefix(".venv/bin/").partition("  # ")[0]
            if typed.startswith("workbook "):
                yield typed


COMMANDS = [(name, line) for name in ALL_PAGES for line in command_lines(name)]


def test_there_are_blocks_of_each_kind() -> None:
    assert len(pieces("python")) > 10
    assert len(pieces("toml")) > 1
    assert len(COMMANDS) > 10


@pytest.mark.parametrize("name", ALL_PAGES)
def test_the_kind_of_each_block_is_known(name: str) -> None:
    assert {told for told, _ in blocks(name)} <= {"", "python", "toml", "mermaid", "text", "json"}


@pytest.mark.parametrize(("name", "line"), COMMANDS)
def test_a_command_has_only_options_that_exist(name: str, line: str) -> None:
    words = [word for word in shlex.split(line)[1:] if word != "..."]
    parser = build_parser()
    try:
        parser.parse_known_args(words) if words[:1] == ["lab"] else parser.parse_args(words)
    except SystemExit as ended:
        code = ended.code
    else:
        code = 0
    assert code == 0, f"{name}: {line}"


@pytest.mark.parametrize(("name", "text"), pieces("toml"))
def test_a_table_of_settings_can_be_read(name: str, text: str) -> None:
    assert tomllib.loads(text)


@pytest.mark.parametrize(("name", "text"), pieces("python"))
def test_python_is_python_and_what_it_calls_takes_it(name: str, text: str) -> None:
    """Parts of lessons are only parsed. All other blocks run; those with a return statement are put into a function."""
    code = textwrap.dedent(text)
    if any(mark in text for mark in SOURCES):
        ast.parse(code)
        return
    if re.search(r"^return ", code, re.MULTILINE):
        code = f"def block():\n{textwrap.indent(code, '    ')}\nfound = block()\n"
    known = {
        **runpy.run_path(str(ROOT / "exercises" / "criteria" / f"{QUOTED}.py"), run_name="quoted"),
        "Float32": Float32, "Float32MultiArray": Float32MultiArray, "Image": Image, "Recording": Recording,
        "Trigger": Trigger, "Verdict": see.Verdict, "criterion": criterion, "probe": probe,
        "program_runs": program_runs, "recording": Recording.load(next(RECORDINGS.glob("*.json"))), "see": see,
        "random": random, "topic": topic, "watching": watching,
    }  # fmt: skip
    exec(compile(code, name, "exec"), known)


@pytest.mark.parametrize(("language", "suffix"), [("python", ".py"), ("toml", ".toml")])
def test_the_parts_of_an_exercise_are_quoted_as_they_are(language: str, suffix: str) -> None:
    lines = (ROOT / "exercises" / "criteria" / f"{QUOTED}{suffix}").read_text(encoding="utf-8").splitlines()
    quoted = [
        text
        for told, text in blocks("docs/judge.md")
        if told == language and ("nobody" in text or "class Graph" in text)
    ]
    assert quoted
    assert not [line for text in quoted for line in text.splitlines() if line and line not in lines]


def test_the_criterion_of_the_manual_passes_one_answer_and_fails_another(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    [text] = [text for told, text in blocks("exercises/README.md") if told == "python"]
    (tmp_path / f"{STEM}.py").write_text(text, encoding="utf-8")
    monkeypatch.setenv(OWN_CRITERIA, str(tmp_path))
    exercise = load_exercise(STEM, ROOT)
    recording = Recording.load(RECORDINGS / "solution.json")
    joints = recording.topic(JOINTS)

    def verdict(neck: float) -> Any:
        """Judge the same answer with a neck that reaches this angle (rad)."""
        arrivals = tuple(
            replace(one, value={**one.value, "data": [neck, *one.value["data"][1:]]})
            for one in joints.arrivals
        )
        topics = {**recording.topics, JOINTS: replace(joints, arrivals=arrivals)}
        seen = replace(recording, topics=topics)
        judgement = judge_recording(exercise, "", seen)
        return next(one for one in judgement.criteria if one.id == "careful_neck")

    assert verdict(0.4).status == "passed"
    lost = verdict(0.9)
    assert (lost.status, lost.cause, lost.saw) == (
        "failed", "careful-neck.too-wide", "the neck turns by 0.90 rad",
    )  # fmt: skip


def test_the_table_of_appeals_is_one(tmp_path: Path) -> None:
    [text] = [text for _, text in blocks("exercises/README.md") if text.startswith(",".join(COLUMNS))]
    (tmp_path / "appeals.csv").write_text(text, encoding="utf-8")
    assert len(read_lines(tmp_path / "appeals.csv")) == len(list(csv.reader(text.splitlines()))) - 1
