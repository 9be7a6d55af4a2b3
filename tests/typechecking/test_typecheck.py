"""mypy as the judge runs it: what it finds, and that no program can keep it from finding it."""

import os
import sys
import textwrap
from pathlib import Path

import pytest
from hypothesis import given
from hypothesis import strategies as st

from workbook.recording.recording import SILENCED, UNCHECKED, UNFINISHED, Finding
from workbook.typechecking import typecheck
from workbook.typechecking.silencers import evasions, without_silencers
from workbook.typechecking.typecheck import (
    BARE,
    MypyOptions,
    TypeCheckFailed,
    kept_folder,
    type_check,
)


def codes(program: str) -> list[tuple[int, str]]:
    return [(finding.line, finding.code) for finding in type_check(textwrap.dedent(program))]


NODE = """\
from rclpy.node import Node
from std_msgs.msg import Float32, String


class Robot(Node):
    def __init__(self) -> None:
        super().__init__("robot")
        self.level = self.create_publisher(Float32, "/robot/battery", 10)
        self.create_timer({period}, self.send)

    def send(self) -> None:
        self.level.publish(Float32(data={value}))
        self.get_logger().info("sent")
"""


HUNGRY = "".join(
    f"def f{n}(x: list[int]) -> list[list[int]]:\n    return [x, x, [1, 2]]\n" for n in range(3000)
)


def test_a_good_node_is_clean() -> None:
    assert type_check(NODE.format(period="2.0", value="99.5")) == ()


def test_mistakes_are_found_by_line_and_code() -> None:
    assert codes(NODE.format(period='"2 s"', value='"full"')) == [(9, "arg-type"), (12, "arg-type")]


def test_programs_of_one_length_are_not_taken_for_each_other() -> None:
    """mypy compares sizes and whole seconds, but several programs may be checked within one second."""
    wrong, right = "level: int = 'a'\n", "level: int = 123\n"
    assert len(wrong) == len(right)
    for _ in range(6):
        assert codes(wrong) == [(1, "assignment")]
        assert codes(right) == []


def test_without_stubs_a_message_is_anything() -> None:
    program = NODE.format(period="2.0", value='"full"')
    assert (
        type_check(program, options=MypyOptions((*BARE, "--strict", "--allow-untyped-calls"), stubs=False))
        == ()
    )
    assert [finding.line for finding in type_check(program)] == [12]


def test_probes_are_read_together_with_the_program() -> None:
    program = NODE.format(period="2.0", value="99.5")
    probes = {
        "right use": "from answer import Robot\nrobot = Robot()\nrobot.send()\n",
        "wrong use": "from answer import Robot\nrobot = Robot()\nrobot.send(1)\n",
        "wrong name": "from answer import Robbot\n",
    }
    found = type_check(program, probes)
    assert [(one.probe, one.line, one.code) for one in found] == [
        ("wrong use", 3, "call-arg"),
        ("wrong name", 1, "attr-defined"),
    ]


def test_notes_come_only_when_asked_for() -> None:
    program = "x = 1\nreveal_type(x)\n"
    assert type_check(program) == ()
    (note,) = type_check(program, options=MypyOptions(notes=True))
    assert note == Finding("", 2, "note", 'Revealed type is "int"')


@pytest.mark.parametrize("program", ["def f(:\n", "x = (\n", "\0", "é = = 1", "if True:\npass"])
def test_what_python_cannot_read_is_a_finding(program: str) -> None:
    found = type_check(program)
    assert found
    assert {finding.code for finding in found} == {"syntax"}


def test_nothing_is_found_in_nothing() -> None:
    assert type_check("") == ()


# --- a program can't keep mypy from checking ----------------------------------------------------------------------


@pytest.mark.parametrize(
    "comment",
    [
        "# type: ignore",
        "# type: ignore[assignment]",
        "#type:ignore",
        "#  type:  ignore  # why",
        "# type: ignore, so",
    ],
)
def test_a_silenced_mistake_is_found_and_so_is_the_silencer(comment: str) -> None:
    assert codes(f"x: int = 'a'  {comment}\n") == [(1, SILENCED), (1, "assignment")]


@pytest.mark.parametrize(
    "comment",
    [
        "# never write type: ignore",
        "# noqa  # type: ignore",
        "# type: ignored",
        "# TYPE: ignore",
        "# mypy: ignore",
    ],
)
def test_a_comment_that_silences_nothing_is_no_silencer(comment: str) -> None:
    assert codes(f"x: int = 'a'  {comment}\n") == [(1, "assignment")]


def test_a_file_cannot_be_silenced() -> None:
    assert codes("# type: ignore\nx: int = 'a'\n") == [(1, SILENCED), (2, "assignment")]
    assert codes("# mypy: ignore-errors\nx: int = 'a'\n") == [(1, SILENCED), (2, "assignment")]
    assert codes('"""\n# mypy: ignore-errors\n"""\nx: int = "a"\n') == [(2, SILENCED), (4, "assignment")]


@pytest.mark.parametrize(
    "program",
    [
        "from typing import no_type_check\n@no_type_check\ndef f(x: int) -> int:\n    return 'a'\n",
        "import typing\n@typing.no_type_check\nclass A:\n    x: int = 'a'\n",
        "from typing import TYPE_CHECKING\nif not TYPE_CHECKING:\n    x: int = 'a'\n",
        "import typing as t\nif t.TYPE_CHECKING:\n    x = 1\nelse:\n    x: int = 'a'\n",
        "MYPY = False\nif not MYPY:\n    def f(x: int) -> int:\n        return 'a'\n",
        "PY2 = True\nif PY2:\n    x: int = 'a'\n",
        "PY3 = False\nif PY3:\n    pass\nelse:\n    x: int = 'a'\n",
        "from typing import TYPE_CHECKING\nassert not TYPE_CHECKING\nx: int = 'a'\n",
        "from typing import TYPE_CHECKING\nif not TYPE_CHECKING and len('a'):\n    x: int = 'a'\n",
        "from typing import TYPE_CHECKING\ny = not TYPE_CHECKING and len(3)\n",
        "from typing import TYPE_CHECKING\ny = 1 if TYPE_CHECKING else len(3)\n",
        "from typing import TYPE_CHECKING\n"
        "def f() -> None:\n    if TYPE_CHECKING:\n        return\n    x: int = 'a'\n",
        "import sys\nsys.platform = 'win32'\nif sys.platform == 'win32':\n    x: int = 'a'\n",
        "import sys as s\ns.platform = 'win32'\nif s.platform == 'win32':\n    x: int = 'a'\n",
        "class sys:\n    platform = 'win32'\nif sys.platform == 'win32':\n    x: int = 'a'\n",
        "import sys\nif sys.version_info > (3, 11):\n    x: int = 'a'\n",
    ],
)
def test_code_that_mypy_would_skip_is_reported(program: str) -> None:
    assert UNCHECKED in {code for _, code in codes(program)}


def test_what_is_for_hints_alone_is_no_evasion() -> None:
    program = """\
        import sys
        from typing import TYPE_CHECKING

        if TYPE_CHECKING:
            from std_msgs.msg import Float32
            Number = float
        else:
            from std_msgs.msg import String

        if sys.platform == "win32":
            print("who would have thought")

        class Robot:
            def __init__(self) -> None:
                self.platform = "wheels"

        print(Robot().platform)
        """
    assert UNCHECKED not in {code for _, code in codes(program)}


def test_imports_for_hints_alone_are_no_evasion() -> None:
    program = """\
        from typing import TYPE_CHECKING

        if TYPE_CHECKING:
            from std_msgs.msg import Float32

        def level(message: "Float32") -> float:
            return message.data
        """
    assert codes(program) == []


def test_any_may_not_be_written() -> None:
    assert codes("from typing import Any\nx: Any = 1\n") == [(2, "explicit-any")]
    assert codes("from typing import Any, cast\nx: int = cast(Any, 'a')\n") == [(2, "explicit-any")]
    assert codes("def f(x):\n    return x\n") == [(1, "no-untyped-def")]


def test_a_text_that_speaks_of_silence_is_left_alone() -> None:
    program = 'x = "# type: ignore"\n"""\n    # mypy: strict\n"""\n'
    assert without_silencers(program) == program
    assert list(evasions(program)) == []


@given(st.text(alphabet=" #\n\t:='\"(\\xtypeignormy", max_size=60))
def test_lines_keep_their_numbers(program: str) -> None:
    assert len(without_silencers(program).split("\n")) == len(program.split("\n"))
    list(evasions(program))


def test_settings_of_the_user_and_of_the_folder_do_not_count(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    for name in ("mypy.ini", ".mypy.ini", "setup.cfg", ".config/mypy/config"):
        path = tmp_path / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text("[mypy]\nignore_errors = True\n")
    monkeypatch.setenv("HOME", str(tmp_path))
    monkeypatch.setenv("XDG_CONFIG_HOME", str(tmp_path / ".config"))
    monkeypatch.setenv("MYPYPATH", str(tmp_path))
    monkeypatch.chdir(tmp_path)
    assert codes("x: int = 'a'\n") == [(1, "assignment")]
    assert type_check("x: int = 'a'\n", options=MypyOptions(BARE, stubs=False)) != ()


# --- the watchdog -------------------------------------------------------------------------------------------------


def test_it_is_ended_when_it_takes_too_much_processor_time(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(typecheck, "_cache", None)  # the environment stores nothing about these packages
    (finding,) = type_check("import numpy, matplotlib.pyplot\n" + HUNGRY, options=MypyOptions(processor_s=1))
    assert (finding.probe, finding.line, finding.code) == ("", 0, UNFINISHED)
    assert "1 s of processor time" in finding.message


@pytest.fixture
def environment(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """Provide an environment in which mypy has not read anything yet, and a process that has not checked anything."""
    monkeypatch.setattr(sys, "prefix", str(tmp_path))
    monkeypatch.setattr(typecheck, "_cache", None)
    return tmp_path


def contents(folder: Path) -> dict[Path, bytes]:
    return {path: path.read_bytes() for path in folder.rglob("*") if path.is_file()}


def test_the_environment_keeps_what_mypy_knows_and_no_program_changes_it(
    environment: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    outdated = environment / "share" / "rclpy-workbook" / "mypy" / "of_another_rclpy"
    outdated.mkdir(parents=True)
    good = NODE.format(period="2.0", value="99.5")
    assert type_check(good) == ()
    [kept] = outdated.parent.iterdir()
    assert kept == kept_folder()
    before = contents(kept)
    assert sum(map(len, before.values())) > 1_000_000

    monkeypatch.setattr(typecheck, "_cache", None)  # as in the next process
    made = kept.stat().st_ino, kept.stat().st_ctime_ns
    assert type_check("from rclpy.node import Node\n\nNode.publish = 1\n")[0].code == "attr-defined"
    assert type_check(good) == ()
    assert contents(kept) == before
    assert (kept.stat().st_ino, kept.stat().st_ctime_ns) == made, "it is not made again"


def test_where_the_environment_is_read_only_mypy_begins_from_nothing(
    environment: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(os, "access", lambda *_: False)
    assert codes(NODE.format(period='"2 s"', value="1.0")) == [(9, "arg-type")]
    assert list(environment.iterdir()) == []


def test_without_mypy_there_is_nothing_to_learn_and_that_is_said(
    environment: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(typecheck, "find_spec", lambda name: None)
    with pytest.raises(TypeCheckFailed, match="make env"):
        typecheck.warm_cache()
    assert list(environment.iterdir()) == []


def test_it_is_ended_after_minutes_whatever_it_does(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(typecheck, "PATIENCE_S", 0.01)
    (finding,) = type_check("x = 1\n")
    assert finding.code == UNFINISHED


@pytest.mark.parametrize(
    "program",
    [
        "x = " + "-" * 100_000 + "1\n",
        "x = " + "(" * 5_000 + ")" * 5_000 + "\n",
        "x = " + "[" * 90 + "]" * 90 + "\n",
    ],
    ids=["minus", "parentheses", "lists"],
)
def test_a_monstrous_program_is_a_finding_or_nothing_and_never_an_error_of_ours(program: str) -> None:
    assert {finding.code for finding in type_check(program)} <= {UNFINISHED, "syntax", "var-annotated"}


def test_a_machine_without_mypy_is_told_so(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(typecheck, "find_spec", lambda name: None)
    with pytest.raises(TypeCheckFailed, match="make env"):
        type_check("x = 1\n")


def test_settings_that_mypy_refuses_are_an_error_of_ours() -> None:
    with pytest.raises(TypeCheckFailed, match="--no-such-setting"):
        type_check("x = 1\n", options=MypyOptions(("--no-such-setting",)))


def test_nothing_is_left_in_the_working_folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)
    type_check("x = 1\n")
    assert os.listdir(tmp_path) == []
