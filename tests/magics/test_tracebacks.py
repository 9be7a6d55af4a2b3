"""Tracebacks: the student's own frames are visible, and one click unfolds those of libraries."""

import sysconfig
from pathlib import Path

import pytest
from IPython.core.interactiveshell import InteractiveShell

import workbook
from workbook.lesson.predictions import UNATTENDED
from workbook.magics import tracebacks

SITE = sysconfig.get_path("purelib")
OWN = """
import json

def read():
    return json.loads("{")

read()
"""


@pytest.fixture
def shell(monkeypatch: pytest.MonkeyPatch) -> InteractiveShell:
    """Provide a shell that stores its tracebacks and displays as text."""
    monkeypatch.delenv(UNATTENDED, raising=False)
    made = InteractiveShell()
    made.sent, made.shown = [], []  # type: ignore[attr-defined]
    made._showtraceback = lambda kind, error, parts: made.sent.append(parts)  # type: ignore[method-assign]
    tracebacks.install(made)
    monkeypatch.setattr(tracebacks, "display", made.shown.append)  # type: ignore[attr-defined]
    return made


def test_frames_of_a_library_are_folded(shell: InteractiveShell) -> None:
    shell.run_cell(OWN)
    (parts,), (folded,) = shell.sent, shell.shown  # type: ignore[attr-defined]
    text = tracebacks._ANSI.sub("", "\n".join(parts))
    assert text.count("read()") >= 2 and "JSONDecodeError: Expecting" in text
    assert "decoder.py" not in text
    assert folded.title.endswith("inside json") and "decoder.py" in folded.frames[-1]
    page = folded._repr_html_()
    assert page.startswith("<details><summary>") and "\x1b" not in page


def test_an_error_of_ones_own_is_shown_as_it_is(shell: InteractiveShell) -> None:
    shell.run_cell("1 / 0")
    shell.run_cell("def (")
    assert "ZeroDivisionError" in "".join(shell.sent[0])  # type: ignore[attr-defined]
    assert not shell.shown  # type: ignore[attr-defined]


def test_nothing_is_folded_while_lessons_are_built(
    shell: InteractiveShell, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv(UNATTENDED, "1")
    shell.run_cell(OWN)
    assert "decoder.py" in "".join(shell.sent[0])  # type: ignore[attr-defined]
    assert not shell.shown  # type: ignore[attr-defined]


@pytest.mark.parametrize(
    ("frame", "library"),
    [
        (f"File {SITE}/rclpy/node.py:412, in Node.create_timer(self)\n  411 x", "rclpy"),
        (f"File {SITE}/typing_extensions.py:3, in f()", "typing_extensions"),
        (f"File {Path(workbook.__file__).parent}/ros/session.py:12, in run(node)", "workbook"),
        ("File /home/ada/course/lesson_nodes/two_arms.py:20, in TwoArms.__init__(self)", None),
        ("File /home/ada/course/work/scratch/battery.py:3", None),
        ("Cell In[3], line 2, in beep()", None),
        ("ValueError: File x.py:3 is broken", None),
    ],
)
def test_whose_frame_it_is(frame: str, library: str | None) -> None:
    assert tracebacks.library_of(frame) == library


def test_without_a_frame_of_ones_own_everything_stays_open() -> None:
    parts = ["ValueError  Traceback", f"File {SITE}/rclpy/node.py:4, in f()", "ValueError: x"]
    assert tracebacks.split(parts) == (parts, [], [])
