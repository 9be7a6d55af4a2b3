"""mypy in a notebook: a readable report about a text, a file, a module, or an answer."""

import threading
from pathlib import Path

import pytest
from std_msgs.msg import Float32
from std_srvs.srv import Trigger

from lesson_nodes import battery_class
from workbook.lesson import check_types, stub_of, type_reports
from workbook.lesson.predictions import UNATTENDED

WRONG = "x: int = 'a'\ny = 1\nz: str = y; w: bytes = y\n"


def test_a_report_names_line_source_message_and_code() -> None:
    report = check_types(WRONG)
    assert report.lines == (1, 3)
    assert len(report) == 2
    assert repr(report).splitlines() == [
        "mypy: 2 lines with a mistake",
        "line 1: x: int = 'a'",
        '    Incompatible types in assignment (expression has type "str", variable has type "int") [assignment]',
        "line 3: z: str = y; w: bytes = y",
        '    Incompatible types in assignment (expression has type "int", variable has type "str") [assignment]',
        '    Incompatible types in assignment (expression has type "int", variable has type "bytes") [assignment]',
    ]


def test_notes_are_no_mistakes() -> None:
    report = check_types("reveal_type(1)\n", notes=True)
    assert len(report) == 0
    assert repr(report).splitlines()[0] == "mypy: nothing found"
    assert "Revealed type" in repr(report)


def test_what_the_stubs_and_strictness_add() -> None:
    program = "from std_msgs.msg import Float32\ndef f(x):\n    return Float32().dta\n"
    assert check_types(program).lines == (2, 3)
    assert check_types(program, stubs=False).lines == (1, 2)
    assert check_types(program, stubs=False, strict=False).lines == (1,)


def test_a_file_a_module_and_an_answer(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    file = tmp_path / "07_typed_nodes.py"
    file.write_text(WRONG)
    monkeypatch.setenv("WORKBOOK_ANSWERS", str(tmp_path))
    assert check_types(file).lines == check_types("07_typed_nodes").lines == (1, 3)
    assert check_types(battery_class).lines == ()


def test_the_stub_of_a_message_is_that_of_this_message_alone() -> None:
    text = stub_of(Float32)
    assert text.startswith("class Float32:\n    data: float\n")
    assert "MultiArray" not in text
    assert "class Trigger_Response:\n    success: bool\n" in stub_of(Trigger.Response)


def test_a_long_first_run_says_that_mypy_is_running(monkeypatch: pytest.MonkeyPatch) -> None:
    said = threading.Event()

    def slow(*_: object, **__: object) -> tuple[()]:
        assert said.wait(60.0), "mypy ran in silence"
        return ()

    monkeypatch.delenv(UNATTENDED, raising=False)
    monkeypatch.setattr(type_reports, "SILENT_AT_MOST_S", 0.0)
    monkeypatch.setattr(type_reports, "print", lambda words: said.set(), raising=False)
    monkeypatch.setattr(type_reports, "type_check", slow)
    check_types(WRONG)
    monkeypatch.setenv(UNATTENDED, "1")
    monkeypatch.setattr(type_reports.threading, "Timer", None)  # none starts
    monkeypatch.setattr(type_reports, "type_check", lambda *_, **__: ())
    check_types(WRONG)
