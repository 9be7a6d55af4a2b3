"""The vocabulary for type checks: clean, accepted, and rejected code; hiding code from mypy earns nothing."""

from collections.abc import Sequence
from dataclasses import replace
from types import ModuleType

import pytest

from tests.criteria.by_hand import recorded
from workbook.criteria import Recording, Verdict
from workbook.criteria.rules import Reason
from workbook.criteria.vocabulary.mypy_reasons import REASONS
from workbook.criteria.vocabulary.type_checks import (
    Probe,
    findings,
    mypy_accepts,
    mypy_clean,
    mypy_objects,
    probe,
    probes_in,
)
from workbook.recording.recording import Finding
from workbook.typechecking.typecheck import type_check

RIGHT = probe("right use", "from answer import send\nsend(1.5)\n")
WRONG = probe(
    "a text for a number", 'from answer import send\nsend(1.5)\nsend("full")  # wrong\nsend(None)  # wrong\n'
)
TYPED = "def send(level: float) -> None: ...\n"


def read(program: str, *probes: Probe) -> Recording:
    """Make a recording with mypy's real output for a program and for probes."""
    return replace(recorded(), findings=type_check(program, {one.name: one.code for one in probes}))


def said(*found: Finding) -> Recording:
    return replace(recorded(), findings=found)


def objects(recording: Recording, one: Probe = WRONG) -> Verdict:
    why_not = Reason("objects.any", {"because": "The hint is Any.", "try": "Write float."})
    return mypy_objects(recording, one, why_not)


def whole(verdict: Verdict) -> str:
    if not verdict.ok:
        assert verdict.saw and verdict.expected and verdict.because and verdict.try_this
    return " ".join((verdict.saw, verdict.expected, verdict.because, verdict.try_this))


def test_a_typed_function_is_clean_accepted_and_guarded() -> None:
    recording = read(TYPED, RIGHT, WRONG)
    assert mypy_clean(recording).ok
    assert mypy_accepts(recording, RIGHT).ok
    verdict = objects(recording)
    assert verdict.ok
    assert 'send("full")' in verdict.saw
    assert 'expected "float"' in verdict.saw


def test_without_hints_it_is_neither_clean_nor_guarded() -> None:
    recording = read("def send(level):\n    ...\n", RIGHT, WRONG)
    assert "line 1: " in whole(mypy_clean(recording))
    assert "mypy treats the arguments and the return value as Any" in whole(mypy_clean(recording))
    assert mypy_accepts(recording, RIGHT).ok
    verdict = objects(recording)
    assert not verdict.ok
    assert 'mypy accepts `send("full")`' in verdict.saw
    assert verdict.because == "The hint is Any."


@pytest.mark.parametrize(
    "program",
    [
        "from typing import Any\ndef send(level: Any) -> None: ...\n",
        "from typing import Any as Level\ndef send(level: Level) -> None: ...\n",
        "from typing import Any\nLevel = Any\ndef send(level: Level) -> None: ...\n",
    ],
)
def test_any_earns_neither_of_the_two(program: str) -> None:
    recording = read(program, RIGHT, WRONG)
    assert "type Any accepts any value" in whole(mypy_clean(recording))
    assert not objects(recording).ok


def test_a_wide_hint_is_clean_but_guards_nothing() -> None:
    recording = read("def send(level: object) -> None: ...\n", RIGHT, WRONG)
    assert mypy_clean(recording).ok
    assert not objects(recording).ok


def test_one_misuse_that_passes_is_one_too_many() -> None:
    recording = read("def send(level: float | None) -> None: ...\n", RIGHT, WRONG)
    assert "mypy accepts `send(None)`" in objects(recording).saw


def test_a_narrow_hint_forbids_right_use() -> None:
    recording = read("def send(level: int) -> None: ...\n", RIGHT, WRONG)
    assert "mypy objects to `send(1.5)`" in whole(mypy_accepts(recording, RIGHT))
    assert "too narrow" in whole(mypy_accepts(recording, RIGHT))
    assert "mypy objects to `send(1.5)`" in whole(objects(recording))


def test_a_missing_name_is_no_objection() -> None:
    recording = read("def sent(level: float) -> None: ...\n", RIGHT, WRONG)
    assert not mypy_accepts(recording, RIGHT).ok
    assert not objects(recording).ok
    assert "Keep the names" in whole(objects(recording))


def test_a_silencer_is_named_with_what_it_hides() -> None:
    verdict = mypy_clean(read("level: float = 'full'  # type: ignore[assignment]\n"))
    assert "line 1: `# type: ignore[assignment]` hides this: Incompatible types" in verdict.saw
    assert "only hides the mistake" in verdict.because
    assert "silences the type checker" in whole(mypy_clean(read("level = 1.5  # type: ignore\n")))


def test_code_out_of_sight_is_named() -> None:
    program = "from typing import no_type_check\n@no_type_check\ndef send(level):\n    ...\n"
    assert "line 2: @no_type_check" in whole(mypy_clean(read(program)))


@pytest.mark.parametrize(
    ("program", "words"),
    [
        ("from rclpy.publisher import Publisher\nx: Publisher[int]\n", "Publisher isn't generic"),
        (
            "from rclpy.node import Node\nclass A(Node):\n"
            "    def __init__(self) -> None:\n        self.publishers = 1\n",
            "Node already has a read-only property",
        ),
        ("x: list = []\n", "contains Any"),
        ("x = []\n", "an empty list or dict"),
        ("import rclpie\n", "no module with this name"),
        ("def f() -> int:\n    return 'a'\n", "a different type than its hint"),
        ("x: int | None = None\nx.real\n", "None"),
        ("class A: ...\nA().levle\n", "misspelled"),
        (
            "def f(x: int) -> int:\n    return x\nf('a')\n",
            "a different type than the function expects",
        ),
        ("x = = 1\n", "can parse the file"),
        (
            "class A:\n    def f(self) -> int:\n        return 1\n"
            "class B(A):\n    def f(self) -> str:\n        return ''\n",
            "contradicts a type hint",
        ),
    ],
)
def test_each_kind_of_finding_has_its_reason(program: str, words: str) -> None:
    assert words in whole(mypy_clean(read(program)))


def test_every_reason_and_every_advice_is_a_sentence() -> None:
    for reason, _, _ in REASONS:
        assert all(text.endswith(".") for text in reason())


def test_an_unfinished_check_is_no_proof_of_anything() -> None:
    recording = said(Finding("", 0, "unfinished", "mypy had not finished after 30 s"))
    for verdict in (mypy_clean(recording), mypy_accepts(recording, RIGHT), objects(recording)):
        assert not verdict.ok
        assert "had not finished" in whole(verdict)


def test_a_recording_without_findings_is_an_error_of_the_author() -> None:
    for judged in (mypy_clean, findings):
        with pytest.raises(ValueError, match="kind: static"):
            judged(recorded())


def test_more_than_one_finding_is_counted() -> None:
    many = [Finding("", line, "assignment", "Incompatible types") for line in (3, 5, 8)]
    assert mypy_clean(said(*many)).saw == "line 3: Incompatible types [assignment] (and 2 more findings)"
    assert "(and 1 more finding)" in mypy_clean(said(*many[:2])).saw


def module_with(*probes: Probe) -> ModuleType:
    module = ModuleType("criteria")
    for number, one in enumerate(probes):
        setattr(module, f"PROBE_{number}", one)
    return module


def test_probes_are_found_by_name() -> None:
    assert probes_in(module_with(RIGHT, WRONG)) == {RIGHT.name: RIGHT.code, WRONG.name: WRONG.code}
    assert probes_in(module_with()) == {}
    with pytest.raises(ValueError, match="same name"):
        probes_in(module_with(RIGHT, probe("right use", "x = 1\n")))


def test_a_probe_is_dedented_and_must_be_python() -> None:
    one = probe("indented", "\n    x = 1\n    x = 'a'  # wrong\n    ")
    assert one.code == "x = 1\nx = 'a'  # wrong\n"
    lines: Sequence[tuple[int, str, bool]] = list(one.lines())
    assert lines == [(1, "x = 1", False), (2, "x = 'a'", True)]
    with pytest.raises(ValueError, match="not valid Python"):
        probe("broken", "x = = 1")
