"""`workbook report` includes what a helper needs and nothing personal. `workbook replay` trusts nothing in a report."""

import getpass
import json
import os
import platform
from collections.abc import Callable
from dataclasses import replace
from pathlib import Path
from typing import Any

import pytest

from tests.cli.conftest import ROOT, Type
from workbook.exercise.answers import read_answer
from workbook.exercise.definition import load_exercise
from workbook.exercise.judgement import judge_recording
from workbook.lab import health
from workbook.lab.health import HealthFinding
from workbook.lesson.best_answers import Check
from workbook.lesson.help_report import LARGEST_BYTES
from workbook.recording.recording import Recording

STEM = "09_joint_positions"
HOME, USER, HOST = "/home/adalove", "adalove", "turing-7.example.org"
LOG = f'File "{HOME}/course/.venv/lib/x.py", line 3\n/home/bob/x.py {USER}@turing-7: Permission denied\n'


@pytest.fixture(autouse=True)
def machine(monkeypatch: pytest.MonkeyPatch) -> None:
    """Simulate a machine with unique names, and a doctor that checks nothing."""
    monkeypatch.setenv("HOME", HOME)
    monkeypatch.setattr(getpass, "getuser", lambda: USER)
    monkeypatch.setattr(platform, "node", lambda: HOST)
    findings = [
        HealthFinding("ok", "Folders", f"{HOME}/course/work can be written by {USER} on {HOST}"),
        HealthFinding("fix", "ROS", "something is missing", f"Run make env in {HOME}."),
    ]
    monkeypatch.setattr(health, "examine", lambda: iter(findings))


def checked(course: Path, text: str = "robot = 1\n", recording: str = "eleven_values") -> Path:
    """Store an answer, and a check of it that gave a stored recording with names in its log."""
    file = course / "work" / "answers" / f"{STEM}.py"
    file.write_text(text)
    stored = Recording.load(ROOT / "tests" / "recordings" / STEM / f"{recording}.json")
    stored = replace(stored, process=replace(stored.process, log=LOG), notes=(f"seen on {HOST}",))
    os.environ["WORKBOOK_ANSWERS"] = str(file.parent)
    answer = read_answer(file, STEM)
    Check(STEM, answer.text).note(judge_recording(load_exercise(STEM), answer.sha256, stored))
    return file


def report_of(course: Path, typed: Type) -> Path:
    said = typed("report", "09")
    assert said.code == 0, said.err
    return course / f"{STEM}.report.json"


def test_a_report_is_replayed_with_the_card_the_messages_and_the_doctor(course: Path, typed: Type) -> None:
    checked(course, "robot = 'mine'\n")
    file = report_of(course, typed)
    said = typed("replay", str(file), "--html", "page.html")
    assert said.code == 0, said.err
    assert "9 of 10 points" in said.out
    assert "/joint_positions" in said.out and " messages, from " in said.out
    assert "robot = 'mine'" in said.out
    assert "something is missing" in said.out
    assert "earlier version" not in said.out
    page = (course / "page.html").read_text()
    assert "data:image/png;base64," in page and "robot = &#39;mine&#39;" in page
    assert "<script" not in page and "http://" not in page.replace("http://www.w3.org", "")


def test_a_report_holds_no_home_no_user_and_no_host(course: Path, typed: Type) -> None:
    checked(course, f"PATH = '{HOME}/x'\n")
    text = report_of(course, typed).read_text()
    for word in (HOME, USER, HOST, "turing-7", "/home/", str(Path.home())):
        assert word not in text, word
    assert "~/course/.venv/lib/x.py" in text and "USER@HOST" in text


def test_the_doctors_report_for_an_issue_holds_no_home_no_user_and_no_host(typed: Type) -> None:
    said = typed("doctor", "--report")
    assert said.code == 0, said.err
    for word in (HOME, USER, HOST, "turing-7", "/home/", str(Path.home())):
        assert word not in said.out, word
    first, *findings = said.out.splitlines()
    assert first.startswith("rclpy-workbook ") and "(clone)" in first
    assert findings == [
        "ok    Folders: ~/course/work can be written by USER on HOST",
        "fix   ROS: something is missing Run make env in ~",
    ]


def test_a_home_with_spaces_is_found_in_a_narrow_terminal(
    course: Path, typed: Type, monkeypatch: pytest.MonkeyPatch
) -> None:
    home = "/srv/people of the course/ada lovelace of the long name/at home"
    monkeypatch.setenv("HOME", home)
    monkeypatch.setattr(health, "examine", lambda: iter([HealthFinding("fix", "ROS", f"see {home}/x", home)]))
    checked(course)
    assert typed("report", "09", columns=40).code == 0
    text = (course / f"{STEM}.report.json").read_text()
    assert "see ~/x" in text and "lovelace" not in text


def test_the_messages_of_a_recording_stay_as_they_are(
    course: Path, typed: Type, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(getpass, "getuser", lambda: "joint_positions")
    checked(course)
    assert "9 of 10 points" in typed("replay", str(report_of(course, typed))).out


def test_a_recording_of_an_earlier_version_is_told(course: Path, typed: Type) -> None:
    file = checked(course)
    file.write_text("robot = 2\n")
    said = typed("report", "09")
    assert "Its recording shows an earlier version." in said.out
    assert "The recording shows an earlier version" in typed("replay", f"{STEM}.report.json").out


@pytest.mark.parametrize("text", ["robot = 1\n", "robot = = 1\n", ""])
def test_an_answer_that_was_never_checked_or_cannot_be_judged_is_reported(
    course: Path, typed: Type, text: str
) -> None:
    (course / "work" / "answers" / f"{STEM}.py").write_text(text)
    assert "It contains no recording." in typed("report", "09").out
    said = typed("replay", f"{STEM}.report.json")
    assert said.code == 0
    assert "There is no recording" in said.out


def test_without_an_answer_there_is_nothing_to_report(course: Path, typed: Type) -> None:
    said = typed("report", "09")
    assert said.code == 2
    assert "nothing to report on" in said.err
    assert not list(course.glob("*.json"))


def change(file: Path, how: Callable[[dict[str, Any]], object]) -> None:
    data = json.loads(file.read_text())
    how(data)
    file.write_text(json.dumps(data))


def test_what_a_student_sends_is_text_and_no_command(course: Path, typed: Type) -> None:
    checked(course)
    file = report_of(course, typed)
    evil = "\x1b[2J\x1b]0;x\x07<script>alert(1)</script>\u202e"

    def make_evil(data: dict[str, Any]) -> None:
        data["answer"] = evil
        data["doctor"] = [evil]
        data["made_by"]["rclpy"] = evil
        data["recording"]["process"]["log"] = evil
        topics = data["recording"]["topics"]
        topics[f"/{evil}"] = next(iter(topics.values()))

    change(file, make_evil)
    said = typed("replay", str(file), "--html", "page.html")
    assert said.code == 0, said.err
    page = (course / "page.html").read_text()
    assert "<script" not in page and "&lt;script&gt;" in page
    for sign in ("\x1b", "\x07", "\u202e"):
        assert sign not in said.out and sign not in page


def stems_that_are_paths(data: dict[str, Any]) -> None:
    data["exercise"] = "../../../../tmp/evil"


def other_format(data: dict[str, Any]) -> None:
    data["recording"]["format"] = 2


def half_a_character(data: dict[str, Any]) -> None:
    data["answer"] = "\ud800"


def no_recording(data: dict[str, Any]) -> None:
    data["recording"] = {"format": 1, "clock": "sundial"}


@pytest.mark.parametrize("how", [stems_that_are_paths, other_format, half_a_character, no_recording])
def test_a_changed_report_is_refused(
    course: Path, typed: Type, how: Callable[[dict[str, Any]], object]
) -> None:
    checked(course)
    file = report_of(course, typed)
    change(file, how)
    said = typed("replay", str(file))
    assert said.code == 2
    assert said.err.startswith("workbook replay:") and "Traceback" not in said.err


@pytest.mark.parametrize(
    "raw",
    [
        b"",
        b"[]",
        b"{",
        b"\xff\xfe",
        b"[" * 100_000,
        b'{"kind": NaN}',
        b"PK\x03\x04",
        b" " * (LARGEST_BYTES + 1),
    ],
    ids=["empty", "list", "torn", "no text", "deep", "nan", "zip", "large"],
)
def test_a_damaged_file_is_refused_with_a_sentence(course: Path, typed: Type, raw: bytes) -> None:
    (course / "x.json").write_bytes(raw)
    said = typed("replay", "x.json")
    assert said.code == 2
    told = " ".join(said.err.split())
    assert "is damaged, or wasn't written by" in told or "is larger than" in told


def test_a_pipe_is_not_read(course: Path, typed: Type) -> None:
    os.mkfifo(course / "x.json")
    assert "there is no file x.json" in typed("replay", "x.json").err


@pytest.mark.parametrize("number", [1e300, -1e300, 1e9])
def test_impossible_times_end_in_a_sentence(course: Path, typed: Type, number: float) -> None:
    checked(course)
    file = report_of(course, typed)

    def far_away(data: dict[str, Any]) -> None:
        data["recording"]["robot_s"] = number
        for topic in data["recording"]["topics"].values():
            topic["window"] = [0.0, number]
            for arrival in topic["arrivals"][1:]:
                arrival["t"] = number

    change(file, far_away)
    assert typed("replay", str(file), "--html", "page.html").code == 0
