"""The nodes of lesson 01:

a guard that parks its arms at the end, and robots that receive only from their own domain.
"""

import time
from collections.abc import Iterator

import pytest
import rclpy
from rclpy.context import Context
from rclpy.executors import SingleThreadedExecutor
from rclpy.signals import SignalHandlerOptions

from lesson_nodes import ends_of_spin, interrupted_sleep, last_words, night_guard, radio_robot, three_mains
from lesson_nodes.radio_robot import RadioRobot
from tests.lesson_nodes.ending import ended_in_order, ended_well
from workbook.lesson import arrivals, record, run_program, start, stop
from workbook.lesson.programs import program_file
from workbook.ros.domains import lease_domain
from workbook.ros.environment import prepare

HELLO = "/building/hello"


@pytest.fixture(autouse=True)
def domain() -> Iterator[None]:
    prepare()
    yield
    stop()


def test_the_guard_walks_parks_its_arms_and_leaves_with_zero() -> None:
    code = program_file(night_guard).read_text()
    end = run_program(code, interrupt_at="round 2")
    assert ended_in_order(end.exit, end.log), end.log
    assert end.log.strip().endswith("arms parked")
    assert end.log.index("round 1") < end.log.index("round 2") < end.log.index("arms parked")


def test_a_round_that_takes_no_time_is_refused_in_words() -> None:
    with pytest.raises(RuntimeError, match=r"not 0\.0"):
        start(night_guard, round_s=0.0)


def test_the_guard_is_on_the_graph_by_its_name() -> None:
    assert start(night_guard) == "/night_guard"
    stop(night_guard)


def test_the_radio_speaks_four_times_a_second() -> None:
    recording = record(radio_robot, {HELLO: radio_robot.PERIOD_S}, seconds=10)
    assert ended_well(recording), recording.process
    assert 38 <= len(arrivals(recording, HELLO)) <= 41


def test_robots_hear_their_own_domain_only() -> None:
    contexts, robots, executors = [], {}, []
    with lease_domain() as inside, lease_domain() as outside:
        for name, lease in (("kitchen", inside), ("hall", inside), ("garden", outside)):
            context = Context()
            rclpy.init(
                context=context,
                domain_id=lease.domain_id,
                signal_handler_options=SignalHandlerOptions.NO,
            )
            robot = RadioRobot(name, context=context)
            executor = SingleThreadedExecutor(context=context)
            executor.add_node(robot)
            contexts.append(context)
            executors.append(executor)
            robots[name] = robot

        def all_hear() -> bool:
            return bool(robots["kitchen"].others() and robots["hall"].others() and robots["garden"].heard)

        deadline = time.monotonic() + 60.0
        while time.monotonic() < deadline and not all_hear():
            for executor in executors:
                executor.spin_once(timeout_sec=0.01)
        for robot, executor, context in zip(robots.values(), executors, contexts, strict=True):
            executor.shutdown()
            robot.destroy_node()
            rclpy.shutdown(context=context)
    assert robots["kitchen"].others() == ["hall"]
    assert robots["hall"].others() == ["kitchen"]
    assert robots["garden"].others() == []
    assert robots["garden"].moments("garden")


@pytest.mark.parametrize(
    ("name", "parks", "code"), [("first_main", False, 130), ("second_main", True, 1), ("third_main", True, 0)]
)
def test_three_mains_end_as_the_lesson_says(name: str, parks: bool, code: int) -> None:
    end = run_program(three_mains, arguments=[name], interrupt_at="round 1")
    assert ("arms parked" in end.log) == parks
    assert end.exit == code or ended_in_order(end.exit, end.log), end.log


def test_a_spin_ends_with_the_exception_of_its_cause() -> None:
    log = run_program(ends_of_spin, arguments=["Ctrl-C (SIGINT)", "rclpy.spin"]).log
    assert log.strip().splitlines()[-2:] == ["ok: False", "KeyboardInterrupt"]


def test_last_words_get_out_only_where_python_alone_handles_the_signal() -> None:
    assert "said good night" in run_program(last_words, arguments=["NO"], interrupt_at="round 1").log
    assert "said good night" not in run_program(last_words, arguments=["ALL"], interrupt_at="round 1").log


def test_an_interrupted_program_has_no_context() -> None:
    assert "in a program, the context is shut down" in run_program(interrupted_sleep).log
