"""The nodes of lesson 02: a roll call of the graph, and a camera that gets its name from outside."""

from collections.abc import Iterator

import pytest
import rclpy
from rclpy.node import Node

from lesson_nodes import camera_driver, roll_call
from lesson_nodes.camera_driver import CameraDriver
from lesson_nodes.roll_call import RollReader
from tests.lesson_nodes.ending import ended_well
from workbook.lesson import arrivals, fresh, init, record, run_program, spin_for, start, stop, values
from workbook.lesson.programs import program_file
from workbook.ros.environment import prepare
from workbook.ros.session import shutdown

FRAME, FAULTS = "/camera/frame", "/faults"


@pytest.fixture(autouse=True)
def domain() -> Iterator[None]:
    prepare()
    yield
    stop()
    shutdown()


@pytest.fixture
def reader() -> RollReader:
    init()
    assert start(roll_call) == "/roll_call"
    return fresh(RollReader)


def until_called(reader: RollReader, *names: str) -> None:
    spin_for(reader, seconds=20, until=lambda: bool(reader.calls) and reader.latest() == sorted(names))


def test_another_process_sees_who_comes_and_goes(reader: RollReader) -> None:
    until_called(reader)
    head = fresh(Node, "head", namespace="/robot")
    twin = rclpy.create_node("head", namespace="/robot")
    until_called(reader, "/robot/head", "/robot/head")
    assert reader.moments("/robot/head")
    assert not reader.moments("/robot/arm")
    head.destroy_node()
    until_called(reader, "/robot/head")
    twin.destroy_node()
    until_called(reader)


def test_a_roll_call_without_a_pause_is_refused_in_words() -> None:
    with pytest.raises(RuntimeError, match=r"not 0\.0"):
        start(roll_call, period_s=0.0)


def test_the_camera_takes_two_pictures_a_second_and_says_who_it_is() -> None:
    recording = record(camera_driver, {FRAME: 0.5, FAULTS: 1.0}, seconds=10)
    assert ended_well(recording), recording.process
    assert 19 <= len(arrivals(recording, FRAME)) <= 21
    assert set(values(recording, FAULTS)) == {"camera: none"}
    pictures = values(recording, FRAME)
    assert len(set(pictures)) == len(pictures)


def test_the_names_of_a_camera_follow_its_remapping() -> None:
    init()
    rear = fresh(CameraDriver, namespace="/robot", cli_args=["--ros-args", "-r", "__node:=rear_camera"])
    assert rear.get_fully_qualified_name() == "/robot/rear_camera"
    assert rear.frame_publisher.topic_name == "/robot/rear_camera/frame"
    assert rear.fault_publisher.topic_name == "/robot/faults"


def test_the_roll_is_called_five_times_a_second_until_control_c() -> None:
    recording = record(roll_call, {roll_call.TOPIC: roll_call.PERIOD_S}, seconds=10)
    assert ended_well(recording), recording.process
    assert 48 <= len(arrivals(recording, roll_call.TOPIC)) <= 51


def test_both_names_of_a_camera_come_from_the_command_line() -> None:
    arguments = ["--ros-args", "-r", "__ns:=/robot", "-r", "__node:=left_camera"]
    code = program_file(camera_driver).read_text()
    end = run_program(code, arguments=arguments, interrupt_at="Camera started", seconds=20)
    assert "[robot.left_camera]: Camera started" in end.log
