"""Read what students hand in: programs in any encoding, notebooks in any state, and files that are neither."""

import json
import os
import subprocess
import sys
from pathlib import Path
from typing import Any

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from workbook.exercise import answers
from workbook.exercise.answers import (
    Answer,
    Ungradable,
    domains_named,
    exercises_named,
    named_exercise,
    read_answer,
    read_program,
    syntax_mistake,
)

STEM = "09_joint_positions"


def code(source: Any, **more: Any) -> dict[str, Any]:
    return {
        "cell_type": "code",
        "metadata": {},
        "outputs": [],
        "execution_count": None,
        "source": source,
        **more,
    }


def text_of(path: Path) -> str:
    return read_answer(path, STEM).text


def refused(path: Path) -> str:
    with pytest.raises(Ungradable) as caught:
        read_answer(path, STEM)
    return str(caught.value)


@pytest.fixture
def program(tmp_path: Path) -> Path:
    return tmp_path / "s1042.py"


@pytest.fixture
def notebook(tmp_path: Path) -> Path:
    return tmp_path / "s1042.ipynb"


def store(notebook: Path, *cells: Any) -> Path:
    notebook.write_text(
        json.dumps({"cells": list(cells), "metadata": {}, "nbformat": 4, "nbformat_minor": 5})
    )
    return notebook


# --- programs -----------------------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("raw", "text"),
    [
        (b"print('fine')\n", "print('fine')\n"),
        (b"print('no newline')", "print('no newline')\n"),
        (b"\xef\xbb\xbfprint('mark')\n", "print('mark')\n"),
        (b"a = 1\r\nb = 2\r\n", "a = 1\nb = 2\n"),
        (b"a = 1\rb = 2\r", "a = 1\nb = 2\n"),
        ("print('grüß')\n".encode(), "print('grüß')\n"),
        (b"%%answer 09_joint_positions\nprint('cell')\n", "print('cell')\n"),
        (b"\n\n  %%answer 09_joint_positions\nprint('cell')\n", "print('cell')\n"),
    ],
)
def test_programs_are_read_as_python_reads_them(raw: bytes, text: str, program: Path) -> None:
    program.write_bytes(raw)
    assert text_of(program) == text


@pytest.mark.parametrize("coding", ["latin-1", "cp1252", "iso-8859-15", "utf-8"])
@pytest.mark.parametrize(
    "line", ["# -*- coding: {} -*-", "# coding={}", "#!/usr/bin/env python3\n# vim: fileencoding={}"]
)
def test_a_coding_line_is_honored_and_the_program_means_the_same(
    coding: str, line: str, program: Path
) -> None:
    program.write_bytes((line.format(coding) + "\nprint('Gelenk grüßt')\n").encode(coding))
    answer = program.with_name("as_judged.py")
    answer.write_text(text_of(program), encoding="utf-8")
    said = [
        subprocess.run([sys.executable, "-X", "utf8", str(path)], capture_output=True, check=True).stdout
        for path in (program, answer)
    ]
    assert said[0] == said[1] == "Gelenk grüßt\n".encode()


def test_line_numbers_survive_a_coding_line(program: Path) -> None:
    program.write_bytes(b"# coding: latin-1\n\nspeed = = 3\n")
    mistake = syntax_mistake(text_of(program))
    assert mistake is not None
    assert (mistake.line, mistake.text) == (3, "speed = = 3")


@pytest.mark.parametrize(
    ("raw", "words"),
    [
        (b"", "empty"),
        (b"  \n\t\n", "empty"),
        (b"%%answer 09_joint_positions\n\n", "empty"),
        ("print('grüß')".encode("utf-16"), "UTF-16"),
        ("print('grüß')".encode("utf-16-be"), "null bytes"),
        (b"print('zero \0')", "null bytes"),
        (b"print('gr\xfc\xdf')\n", "not readable as text"),
        (b"# coding: klingon\nprint(1)\n", "not readable as text"),
        (b"# coding: rot13\nprint(1)\n", "not readable as text"),
        (b"# coding: punycode\nprint('a-\xff')\n", "not readable as text"),
        (b"%%answer 05_timers\nprint(1)\n", "answers 05_timers, not 09_joint_positions"),
    ],
)
def test_what_is_no_program_is_refused_with_a_reason(raw: bytes, words: str, program: Path) -> None:
    program.write_bytes(raw)
    assert words in refused(program)


@given(st.binary(max_size=300))
@settings(deadline=None, derandomize=True)
def test_any_bytes_are_read_or_refused(raw: bytes) -> None:
    try:
        text = read_program(raw)
    except Ungradable:
        return
    assert "\r" not in text


def test_too_large_files_are_not_even_read(program: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    with program.open("wb") as file:
        file.truncate(answers.LARGEST_ANSWER_BYTES + 1)
    monkeypatch.setattr(Path, "read_bytes", lambda self: pytest.fail("read"))
    assert "larger than 1 MB" in refused(program)


def test_links_pipes_and_folders_are_no_answers(tmp_path: Path, program: Path) -> None:
    real = tmp_path / "real.py"
    real.write_text("print('secret of the grader')\n")
    program.symlink_to(real)
    assert "not a regular file" in refused(program)
    pipe = tmp_path / "pipe.py"
    os.mkfifo(pipe)
    assert "not a regular file" in refused(pipe)
    assert exercises_named(pipe) == []
    folder = tmp_path / "folder.py"
    folder.mkdir()
    assert "not a regular file" in refused(folder)
    assert "there is no file" in refused(tmp_path / "missing.py")


@pytest.mark.parametrize("name", ["answer.txt", "answer", "answer.py.zip"])
def test_other_kinds_of_files_are_refused(name: str, tmp_path: Path) -> None:
    (tmp_path / name).write_text("print(1)")
    assert ".py or .ipynb" in refused(tmp_path / name)


# --- notebooks ----------------------------------------------------------------------------------------------------


def test_the_last_cell_that_names_the_exercise_counts(notebook: Path) -> None:
    store(
        notebook,
        code("%%answer 09_joint_positions\nfirst = 1\n"),
        code("%%answer 05_timers\nother = 1\n"),
        code(["\n", "%%answer 09_joint_positions\n", "second = 2\n", "third = 3"]),
        code("print('after')\n"),
        {"cell_type": "markdown", "metadata": {}, "source": "%%answer 09_joint_positions\nnot code"},
    )
    assert text_of(notebook) == "second = 2\nthird = 3\n"


def test_metadata_and_outputs_are_not_needed(notebook: Path) -> None:
    notebook.write_text(
        json.dumps({"cells": [{"cell_type": "code", "source": "%%answer 09_joint_positions\nx = 1\n"}]})
    )
    assert text_of(notebook) == "x = 1\n"


def test_another_exercise_is_named_in_the_refusal(notebook: Path) -> None:
    store(notebook, code("%%answer 05_timers\nx = 1"), code("%%answer 08_humanoid\nx = 2"))
    said = refused(notebook)
    assert "05_timers, 08_humanoid" in said
    assert "%%answer 09_joint_positions" in said


@pytest.mark.parametrize(
    "cells",
    [
        [],
        [code("x = 1\n")],
        [code("x = 1\n%%answer 09_joint_positions\n")],
        [code("%%answer\nx = 1")],
        [code("%%answer 09_joint_positions now\nx = 1")],
        [code(None), code(7), code({"a": 1})],
        [{"cell_type": "markdown", "source": "%%answer 09_joint_positions\nx = 1"}],
    ],
)
def test_a_notebook_without_a_naming_cell_is_told_which_line_to_write(
    cells: list[Any], notebook: Path
) -> None:
    store(notebook, *cells)
    assert "no cell that begins with `%%answer 09_joint_positions`" in refused(notebook)


@pytest.mark.parametrize(
    "text",
    [
        "",
        "{",
        "null",
        "[]",
        "7",
        '{"cells": 3}',
        '{"cells": [7]}',
        '{"nbformat": 4}',
        '{"worksheets": [{"cells": []}]}',
        "[" * 100_000,
    ],
    ids=lambda text: text[:20] or "empty",
)
def test_a_broken_notebook_is_refused(text: str, notebook: Path) -> None:
    notebook.write_text(text)
    assert "not a readable notebook" in refused(notebook)
    assert exercises_named(notebook) == []


def test_an_answer_cell_that_is_empty_or_huge_or_half_a_character(notebook: Path) -> None:
    assert "empty" in refused(store(notebook, code("%%answer 09_joint_positions\n\n")))
    assert "larger than 1 MB" in refused(
        store(notebook, code("%%answer 09_joint_positions\n" + "x" * 1_000_001))
    )
    assert "half of a character" in refused(
        store(notebook, code("%%answer 09_joint_positions\nx = '\ud83d'\n"))
    )


def test_the_same_program_has_the_same_sum_in_every_wrapping(program: Path, notebook: Path) -> None:
    program.write_bytes(b"x = 1\r\n")
    store(notebook, code(["%%answer 09_joint_positions\n", "x = 1"]))
    sums = {read_answer(path, STEM).sha256 for path in (program, notebook)}
    assert sums == {Answer("x = 1\n").sha256}


# --- what a file says about itself -------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("line", "stem"),
    [
        ("%%answer 09_joint_positions", STEM),
        ("  %%answer   09_joint_positions  ", STEM),
        ("%%answer 09_joint_positions --check", STEM),
        ("%%answer", None),
        ("%%answer --check", None),
        ("%answer 09_joint_positions", None),
        ("# %%answer 09_joint_positions", None),
        ("%%answer a b", None),
    ],
)
def test_the_naming_line(line: str, stem: str | None) -> None:
    assert named_exercise(line) == stem


def test_a_file_tells_the_exercises_it_answers(program: Path, notebook: Path) -> None:
    store(notebook, code("%%answer 05_timers\n"), code("x = 1"), code("%%answer 09_joint_positions\n"))
    assert exercises_named(notebook) == ["05_timers", STEM]
    program.write_text("%%answer 09_joint_positions\n%%answer 05_timers\n")
    assert exercises_named(program) == [STEM]
    program.write_bytes(b"\xff\xfe\x00")
    assert exercises_named(program) == []
    assert exercises_named(program.with_name("nowhere.py")) == []


@pytest.mark.parametrize(
    ("text", "line"),
    [("x = (\n1 +\n", 2), ("if True:\nx = 1\n", 2), ("x = 'open\n", 1), ("x = '\0'\n", 1), ("(" * 5000, 1)],
    ids=["never closed", "indentation", "open text", "zero byte", "too deep"],
)
def test_a_mistake_is_placed(text: str, line: int) -> None:
    mistake = syntax_mistake(text)
    assert mistake is not None
    assert mistake.message
    assert mistake.line >= 1
    assert mistake.line <= line


def test_a_program_without_mistake() -> None:
    assert syntax_mistake("import rclpy\n") is None


def test_the_domains_that_a_program_may_stand_on_are_found() -> None:
    text = "DOMAIN = 30\nrclpy.init(domain_id=31, args=['a'])\nos.environ['ROS_DOMAIN_ID'] = '42'\nPERIOD_S = 2.0\n"
    assert domains_named(text) == {30, 31, 42}
    assert domains_named("rclpy.init()\nself.create_timer(2, self.tick)\n") == frozenset()


# --- other kinds of files, and cells that are almost answers -----------------------------------------------------


@pytest.mark.parametrize(
    ("raw", "words"),
    [
        (b"x = 1\n<<<<<<< HEAD\ny = 1\n=======\ny = 2\n>>>>>>> theirs\n", "conflict in line 2"),
        (b"version https://git-lfs.github.com/spec/v1\noid sha256:12\nsize 3\n", "Git LFS"),
        (b"<!DOCTYPE html><html></html>", "web page"),
        (b"{\\rtf1\\ansi print(1)}", "RTF"),
        (b"%PDF-1.7\n", "PDF"),
        (b"PK\x03\x04\x14\x00", "ZIP"),
        (b"\x89PNG\r\n\x1a\n\0", "picture"),
        (b"Traceback (most recent call last):\n  File 'a.py'\n", "error message"),
        (b"$ python answer.py\nhello\n", "terminal"),
        (b"me@robot:~/ws$ python3 a.py\n", "terminal"),
        (b">>> import rclpy\n>>> rclpy.init()\n", "interactive session"),
        (b"From: me\nTo: you\nSubject: my answer\n\nHello\n", "e-mail"),
        (b"!pip install rclpy\nimport rclpy\n", "line 1 is a notebook command"),
        (b"import rclpy\n%matplotlib inline\n", "line 2 is a notebook command"),
    ],
)
def test_other_kinds_of_files_under_the_name_of_a_program(raw: bytes, words: str, program: Path) -> None:
    program.write_bytes(raw)
    assert words in refused(program)


@pytest.mark.parametrize(
    "text",
    [
        'notes = """\n<<<<<<< HEAD\n>>>>>>> theirs\n!pip\n"""\n',
        '"""\nFrom: me\nTo: you\n"""\n',
        "speed = = 3\n!pip\n",
        "def f(:\n    x = 5\n% 3\n",
    ],
)
def test_programs_are_not_taken_for_something_else(text: str, program: Path) -> None:
    program.write_text(text)
    assert text_of(program) == text


def test_a_notebook_under_the_name_of_a_program_is_read(program: Path) -> None:
    store(program, code("%%answer 09\nx = 1"))
    assert text_of(program) == "x = 1\n"
    store(program, code("x = 1"))
    assert "no cell that begins with" in refused(program)


def test_the_answer_in_an_exported_notebook_is_read(program: Path) -> None:
    lines = [
        "#!/usr/bin/env python",
        "get_ipython().run_line_magic('pip', 'list')",
        "get_ipython().run_cell_magic('answer', '05_timers', 'x = 0')",
        "get_ipython().run_cell_magic('answer', '09 --check', 'x = \"a\"\\n')",
        "x = 2",
    ]
    program.write_text("\n".join(lines))
    assert text_of(program) == 'x = "a"\n'


@pytest.mark.parametrize(
    ("cells", "words"),
    [
        ([code(line + "\nx = 1")], f"cell 1 has the line `{' '.join(line.split())}`")
        for line in (
            "%answer 09",
            "%%Answer 09",
            "%%ANSWER 09",
            "%%anwser 09",
            "%%answr 09",
            "%%answers 09",
            "%% answer 09",
            "# %%answer 09",
            "#%%answer 09",
            "%%answer",
            "%%answer: 09",
            "%%answer '09'",
            '%%answer "09"',
            "%%answer 09.py",
            "%%answer 09 # final",
            "%%answer = 09",
            "\uff05\uff05answer 09",
            "%%%answer 09",
            "!!answer 09",
            "%%answer09",
            "> %%answer 09",
        )
    ]
    + [
        ([code("x = 1"), code("%%time\n%%answer 09\nx = 1")], "cell 2 has `%%answer 09` in line 2"),
        ([{"cell_type": "markdown", "source": "%%answer 09\nx"}], "it is a markdown cell"),
        ([{"cell_type": "raw", "source": "%%answer 09\nx"}], "it is a raw cell"),
        ([code("%%answer 09_joint_postions\nx = 1")], "the notebook answers 09_joint_postions, not"),
    ],
)
def test_a_cell_that_is_nearly_an_answer_is_told(cells: list[Any], words: str, notebook: Path) -> None:
    assert words in refused(store(notebook, *cells))


def test_an_empty_last_answer_tells_of_the_one_above(notebook: Path) -> None:
    store(notebook, code("%%answer 09\nx = 1"), code("y"), code("%%answer 09\n"))
    said = refused(notebook)
    assert "cell 3, is empty" in said
    assert "cell 1" in said


@pytest.mark.parametrize(
    ("raw", "words"),
    [
        (b"", "empty"),
        (b"null", "other data"),
        (b"[]", "other data"),
        (b"{}", "no list of cells"),
        (b'{"cells": [null]}', "cell 1 is damaged"),
        (b'{"cells": [', "cut off"),
        (b"import rclpy\n", "something other"),
        (b'{"worksheets": []}', "nbformat 3"),
        (b'{"cells": [{"source": "gr\xfc\xdf"}]}', "not UTF-8"),
        (b'{"cells": [\n<<<<<<< HEAD\n', "conflict in line 2"),
    ],
)
def test_a_notebook_that_is_none_is_refused_in_a_sentence(raw: bytes, words: str, notebook: Path) -> None:
    notebook.write_bytes(raw)
    said = refused(notebook)
    assert words in said
    assert "Error" not in said


@pytest.mark.parametrize(
    ("cells", "words"),
    [
        (["%%answer 09\nrobot = 1", "%%answer 09\nrobot = 2"], "Cells 1 and 2 begin with"),
        (
            ["%%answer 09\nimport rclpy", "class Body:\n    pass"],
            "Cell 2, right after the answer, contains code",
        ),
        (["%%answer 09\nimport rclpy", "", "    def tick(self):\n        pass"], "Cell 3, right after"),
        (["%%answer 09\nimport rclpy", "%check 09", "import math"], ""),
        (["%%answer 09\nimport rclpy", "%%answer 05\nimport math"], ""),
        (["import math", "%%answer 09\nimport rclpy"], ""),
    ],
)
def test_what_else_the_notebook_holds_is_noted(tmp_path: Path, cells: list[str], words: str) -> None:
    path = tmp_path / "answer.ipynb"
    notebook = {
        "nbformat": 4,
        "nbformat_minor": 5,
        "metadata": {},
        "cells": [
            {"cell_type": "code", "source": text, "metadata": {}, "outputs": [], "execution_count": None}
            for text in cells
        ],
    }
    path.write_text(json.dumps(notebook))
    answer = read_answer(path, "09_joint_positions")
    assert words in answer.note and bool(answer.note) == bool(words)
