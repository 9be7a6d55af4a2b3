"""Programs next to a notebook: one that fails in its first lines is reported, and isn't left in the graph."""

import asyncio
import os
from collections import Counter
from collections.abc import Iterator
from pathlib import Path
from types import SimpleNamespace

import pytest
from rclpy.context import Context
from rclpy.node import Node

from lesson_nodes import callback_monitor
from tests.programs.support import wait_until
from workbook.lesson import processor_seconds, programs, run_program, start, stop, views
from workbook.lesson.startup import node_names
from workbook.ros.domains import lease_domain
from workbook.ros.environment import prepare
from workbook.ros.kernel_node import close_kernel_node
from workbook.ros.session import fresh, init, shutdown

HEAD = """
import time
import rclpy
from rclpy.node import Node

class Gripper(Node):
    def __init__(self):
        super().__init__("gripper", start_parameter_services=%s)
"""
WORKS = (
    HEAD
    + """
rclpy.init()
rclpy.spin(Gripper())
"""
)
FAILS_LATER = (
    HEAD
    + """
        time.sleep(0.7)  # a slow first line, long after the node is in the graph
        raise ValueError("the gripper is jammed")

rclpy.init()
rclpy.spin(Gripper())
"""
)


@pytest.fixture(autouse=True)
def domain(monkeypatch: pytest.MonkeyPatch) -> Iterator[None]:
    for name in list(os.environ):
        monkeypatch.setenv(name, os.environ[name])  # restores what `prepare` changes
    with lease_domain() as lease:
        prepare(domain_id=lease.domain_id)
        try:
            yield
        finally:
            stop()
            close_kernel_node()


def program(folder: Path, text: str, services: bool = True) -> Path:
    file = folder / "gripper.py"
    file.write_text(text % services)
    return file


def test_a_program_that_works_is_named_by_its_node(tmp_path: Path) -> None:
    assert start(program(tmp_path, WORKS)) == "/gripper"
    assert node_names()["/gripper"] == 1


def test_a_node_of_the_notebook_is_not_taken_for_one_of_the_program(tmp_path: Path) -> None:
    context = Context()
    context.init(domain_id=int(os.environ["ROS_DOMAIN_ID"]))
    voice = Node("voice", context=context)
    try:
        assert start(program(tmp_path, WORKS)) == "/gripper"
    finally:
        voice.destroy_node()
        context.try_shutdown()


def test_a_node_that_answers_no_questions_is_taken_as_it_is(tmp_path: Path) -> None:
    assert start(program(tmp_path, WORKS, services=False)) == "/gripper"


def test_an_error_after_the_node_has_appeared_is_told(tmp_path: Path) -> None:
    with pytest.raises(RuntimeError, match="the gripper is jammed"):
        start(program(tmp_path, FAILS_LATER))
    assert node_names()["/gripper"] == 0


def test_a_program_without_a_node_is_told(tmp_path: Path) -> None:
    file = tmp_path / "empty.py"
    file.write_text("print('nothing to do')\n")
    with pytest.raises(RuntimeError, match=r"(?s)empty\.py ended right away.*nothing to do"):
        start(file)


def test_a_kernel_that_has_moved_to_another_domain_still_sees_its_programs(tmp_path: Path) -> None:
    assert node_names()["/gripper"] == 0
    with lease_domain() as elsewhere:
        prepare(domain_id=elsewhere.domain_id)
        assert start(program(tmp_path, WORKS)) == "/gripper"
        stop()


def test_a_node_of_the_notebook_that_is_seen_late_is_not_taken_for_the_programs(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    init()
    try:
        guard = fresh(Node, "guard")
        graph = node_names  # as if the notebook's own node appeared in the graph only later
        monkeypatch.setattr(
            programs, "node_names", lambda: Counter(name for name in graph() if name != "/guard")
        )
        assert start(program(tmp_path, WORKS)) == "/gripper"
        assert guard.get_name() == "guard"
    finally:
        shutdown()


def test_a_program_that_falls_silent_is_ended_and_one_that_starts_slowly_is_not() -> None:
    begin = "import time\ntime.sleep(1.0)\nprint('here', flush=True)\n"
    silent = run_program(begin + "time.sleep(600)\n", silence=0.5)
    assert (silent.ended_by, silent.log) == ("judge", "here\n")
    talking = run_program(
        begin + "for n in range(6):\n    time.sleep(0.5)\n    print(n, flush=True)\n", silence=2.0
    )
    assert (talking.ended_by, talking.log.split()) == ("itself", ["here", *"012345"])


def test_ctrl_c_comes_when_the_words_are_there() -> None:
    end = run_program("import time\nprint('ready', flush=True)\ntime.sleep(600)\n", interrupt_at="ready")
    assert (end.ended_by, end.exit) == ("itself", 130)


def test_ctrl_c_comes_when_the_program_waits_and_not_in_the_middle_of_its_work(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    waits = tmp_path / "waits"

    class QuietWhenItSaysSo:
        def __init__(self, pid: int) -> None: ...

        def wait_until_quiet(self) -> None:
            wait_until(waits.exists)

        def close(self) -> None: ...

    monkeypatch.setattr(programs, "RestDetector", QuietWhenItSaysSo)
    code = """
import pathlib, time
where = "at work"
try:
    print("ready", flush=True)
    time.sleep(0.5)
    where = "waiting"
    pathlib.Path(%r).touch()
    time.sleep(600)
except KeyboardInterrupt:
    print(where)
"""
    assert run_program(code % str(waits), interrupt_at="ready").log.split() == ["ready", "waiting"]


def test_processor_time_counts_the_time_in_line_for_a_busy_processor(monkeypatch: pytest.MonkeyPatch) -> None:
    in_line = iter((1.0, 1.75))
    monkeypatch.setattr(programs, "run_queue_s", lambda pid: next(in_line))
    used = processor_seconds(callback_monitor, seconds=0.2, with_start=False)
    assert 0.75 <= used < 1.25


def test_who_stops_watching_learns_what_still_runs(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    async def interrupted(*_: object, **__: object) -> None:
        raise views.Stopped

    gone: list[str] = []
    view = SimpleNamespace(destroy_node=lambda: gone.append("view"))
    monkeypatch.setattr(views, "run", interrupted)
    monkeypatch.setattr(programs, "still_running", lambda: ["two_arms"])
    asyncio.run(views.watched(view, lambda: None))
    assert capsys.readouterr().out == "You stopped watching, but two_arms still runs: stop() ends it.\n"
    asyncio.run(views.watched(view, lambda: None, ends_program=True))
    monkeypatch.setattr(programs, "still_running", list)
    asyncio.run(views.watched(view, lambda: None))
    assert capsys.readouterr().out == ""
    assert gone == ["view"] * 3
