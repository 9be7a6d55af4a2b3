"""The protocol between a slot and its owner: lines of limited length, progress, and the final message."""

import json
import os
import threading
from collections.abc import Iterator
from functools import partial

import pytest

from workbook.exercise.answers import Answer
from workbook.exercise.definition import load_exercise
from workbook.grading.slots import client
from workbook.grading.slots.client import Slot, SlotBroken
from workbook.grading.slots.protocol import (
    JudgingOrder,
    LineReader,
    LineTooLong,
    Progress,
    line_of,
    progress_message,
)

STEM = "09_joint_positions"
ENDLESS = "import os\nwhile True: os.write(1, b'x' * 1000)\n"
NO_JSON = "import sys\nprint('ready', flush=True)\nsys.stdin.read()\n"


@pytest.fixture
def pipe() -> Iterator[tuple[int, int]]:
    reading, writing = os.pipe()
    yield reading, writing
    os.close(reading)


def test_a_message_may_come_in_parts_and_two_at_once(pipe: tuple[int, int]) -> None:
    reading, writing = pipe
    reader = LineReader(reading)
    assert reader.next(0.0) is None
    os.write(writing, b'{"one": ')
    assert reader.next(0.0) is None
    os.write(writing, b'1}\n{"two": 2}\n')
    assert reader.next(0.0) == {"one": 1}
    assert reader.next(0.0) == {"two": 2}
    assert reader.next(0.0) is None
    os.close(writing)
    with pytest.raises(EOFError):
        reader.next(0.0)


@pytest.mark.parametrize("text", [b"[1]\n", b"ready\n"])
def test_what_is_no_message_is_an_error(pipe: tuple[int, int], text: bytes) -> None:
    os.write(pipe[1], text)
    os.close(pipe[1])
    with pytest.raises(ValueError, match=r"no message|Expecting value"):
        LineReader(pipe[0]).next(0.0)


@pytest.mark.parametrize("end", [b"", b'"}\n'], ids=["endless", "with an end"])
def test_a_line_that_is_too_long_is_not_kept(pipe: tuple[int, int], end: bytes) -> None:
    reading, writing = pipe
    reader = LineReader(reading, longest=100)
    os.write(writing, b'{"text": "' + b"x" * 60)
    assert reader.next(0.0) is None
    os.write(writing, b"x" * 60 + end)
    os.close(writing)
    with pytest.raises(LineTooLong, match="longer than 100 bytes"):
        reader.next(0.0)


def test_of_an_endless_line_only_a_bounded_part_is_read(pipe: tuple[int, int]) -> None:
    reading, writing = pipe
    reader = LineReader(reading, longest=100_000)
    for _ in range(10):
        os.write(writing, b"x" * 10_000)
        assert reader.next(0.0) is None
    os.write(writing, b"x")
    os.close(writing)
    with pytest.raises(LineTooLong):
        reader.next(0.0)


@pytest.mark.parametrize(
    ("program", "problem"), [(ENDLESS, "a line is longer than 5000 bytes"), (NO_JSON, "Expecting value")]
)
def test_a_slot_that_keeps_to_no_line_is_broken(
    program: str, problem: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(client, "SLOT_MODULE", ("-c", program))
    monkeypatch.setattr(client, "LineReader", partial(LineReader, longest=5_000))
    slot = Slot()
    with pytest.raises(SlotBroken, match=f"sent an invalid message: {problem}"):
        slot.judge(STEM, Answer("x = 1\n"), soak=False)
    slot.kill()
    assert not slot.is_running
    slot.close()


def test_an_order_and_progress_survive_the_journey() -> None:
    order = JudgingOrder(STEM, "x = 'ä\\n'\n", True, 7)
    assert JudgingOrder(**json.loads(line_of(order))) == order
    kind = {"/robot/speed": "std_msgs/msg/Float32"}
    progress = Progress(0, 1.5, {"/robot/speed": 3}, {"/robot/speed": {"data": 0.5}}, kind)
    assert Progress(**json.loads(line_of(progress_message(progress)))["progress"]) == progress


def test_progress_with_a_number_that_json_does_not_know_goes_without_values() -> None:
    progress = Progress(0, 1.5, {"/robot/speed": 3}, {"/robot/speed": {"data": float("nan")}})
    told = json.loads(line_of(progress_message(progress)))["progress"]
    assert (told["messages"], told["latest"]) == ({"/robot/speed": 3}, {})


def test_progress_tells_of_the_program_and_not_of_its_driver() -> None:
    progress = Progress(0, 1.5, {"/driver/report": 9, "/robot/speed": 3})
    assert progress.counters() == ["3 on /robot/speed"]
    assert str(progress) == "1.5 s, 3 on /robot/speed"


@pytest.mark.slow
def test_a_slot_tells_how_far_it_is_to_whoever_asks() -> None:
    topic = "/robot/joint_positions"
    seen: list[Progress] = []
    came = threading.Event()
    with Slot() as slot:

        def note(progress: Progress) -> None:
            seen.append(progress)
            if topic in progress.messages and not came.is_set():
                came.set()
                slot.cancel_soak()

        right = Answer(load_exercise(STEM).source.solution_code)
        assert slot.judge(STEM, right, soak=True, progress=note).full_marks
    assert came.is_set()
    last = [one for one in seen if topic in one.messages][-1]
    assert last.place == 0 and last.watched_s > 0.0
    assert last.messages[topic] >= 1
    assert len(last.latest[topic]["data"]) > 0
    assert last.types[topic] == "std_msgs/msg/Float32MultiArray"
