"""Help and errors: grouped, in sentences, and never wider than the terminal."""

import os
import re
import subprocess
import sys
from collections.abc import Iterator

import pytest

from tests.cli.conftest import Type
from workbook.cli.main import GROUPS, build_parser
from workbook.cli.parsing import CommandParser

WIDTHS = (80, 60)


def all_parsers(parser: CommandParser) -> Iterator[CommandParser]:
    yield parser
    for inner in parser.below.values():
        yield from all_parsers(inner)


def too_wide(text: str, columns: int) -> list[str]:
    """Return the lines that are too wide but could have been broken. A single word, such as an address, can't be."""
    return [line for line in text.splitlines() if len(line) > columns and " " in line.strip()]


NAMES = [parser.prog for parser in all_parsers(build_parser())]


def test_there_are_commands_below_commands() -> None:
    assert {"workbook", "workbook check", "workbook topic echo", "workbook package github"} <= set(NAMES)


@pytest.mark.parametrize("columns", WIDTHS)
@pytest.mark.parametrize("name", NAMES)
def test_each_help_page_fits(name: str, columns: int, typed: Type) -> None:
    said = typed(*name.split()[1:], "--help", columns=columns)
    assert said.code == 0
    assert not too_wide(said.out, columns)


def test_each_command_is_in_one_group() -> None:
    named = [name for _, names in GROUPS for name in names]
    assert sorted(named) == sorted(build_parser().below)


def test_a_student_s_commands_come_before_those_of_others() -> None:
    page = build_parser().format_help()
    places = [
        page.index(f"\n    {name} ") for name in ("check", "hint", "topic", "doctor", "grade", "autograde")
    ]
    assert places == sorted(places)


def test_workbook_alone_shows_what_there_is(typed: Type) -> None:
    said = typed()
    assert (said.code, said.err) == (0, "")
    assert said.out == build_parser().format_help()
    assert "{" not in said.out


@pytest.mark.parametrize("line", ["", "check", "topic echo"])
def test_help_may_be_a_word(line: str, typed: Type) -> None:
    assert typed("help", *line.split()) == typed(*line.split(), "--help")


@pytest.mark.parametrize("name", ["node", "topic", "package", "autograde"])
def test_half_a_command_says_what_is_missing(name: str, typed: Type) -> None:
    said = typed(name)
    assert (said.code, said.out) == (2, "")
    assert said.err.startswith(
        f"workbook {name}: the command is missing; try, for example, `workbook {name} "
    )
    for inner in build_parser().below[name].below:
        assert re.search(rf"^    {inner} ", said.err, re.MULTILINE)


@pytest.mark.parametrize(
    ("line", "words"),
    [
        ("chek", "workbook: there is no command chek. Did you mean check?"),
        ("topic ecko /robot/status", "workbook topic: there is no command ecko. Did you mean echo?"),
        ("zzz", "workbook: there is no command zzz."),
        ("check", "workbook check: EXERCISE is missing."),
        ("new exercise", "workbook new: SLUG is missing."),
        ("check 09 --wach", "workbook check: it does not take --wach. Did you mean --watch?"),
        ("doctor quickly please", "workbook doctor: it does not take quickly please."),
        ("completion bahs", "workbook completion: there is no SHELL bahs. Did you mean bash?"),
        ("topic echo x --count 0", "workbook topic echo: --count: 0 is not a whole number of 1 or more."),
        ("topic hz x --seconds soon", "workbook topic hz: --seconds: soon is not a number of seconds."),
        (
            "graph --domain 400",
            "workbook graph: --domain: 400 is not a ROS domain. Domains are numbers from 0 to 232.",
        ),
        ("check joint_position", "Did you mean joint_positions?"),
        ("hint joint_position", "Did you mean joint_positions?"),
    ],
)
@pytest.mark.parametrize("columns", WIDTHS)
def test_an_error_is_a_sentence_that_helps(line: str, words: str, columns: int, typed: Type) -> None:
    said = typed(*line.split(), columns=columns)
    assert said.code == 2
    assert words in " ".join(said.err.split())
    assert not too_wide(said.err, columns)
    for raw in (
        "invalid choice",
        "error:",
        "the following arguments",
        "Traceback",
        "_positive",
        "choose from",
    ):
        assert raw not in said.err


def test_a_command_in_backticks_stays_on_one_line(typed: Type) -> None:
    said = typed("check", "09", "nowhere.py", columns=60)
    assert said.code == 2
    for columns in range(40, 81):
        page = typed("--help", columns=columns).out
        assert page.count("`workbook COMMAND --help`") == 1


@pytest.mark.parametrize("words", [("--help",), ("check", "--help"), ("hint", "joint_positions")])
def test_a_reader_that_has_seen_enough_is_no_error(words: tuple[str, ...]) -> None:
    """As in `workbook --help | head -1`."""
    reading, writing = os.pipe()
    os.close(reading)
    done = subprocess.run(
        [sys.executable, "-m", "workbook.cli.main", *words],
        stdout=writing,
        stderr=subprocess.PIPE,
        text=True,
        timeout=120,
    )
    os.close(writing)
    assert (done.returncode, done.stderr) == (0, "")
