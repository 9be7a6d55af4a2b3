"""The nodes of lesson 03:

the figures are closed, the images have the right content, and the desk distinguishes calls.
"""

import math

import pytest

from lesson_nodes import battery_levels, figure_driver, tiny_camera
from lesson_nodes.level_desk import LevelDesk
from tests.lesson_nodes.ending import ended_in_order, ended_well
from workbook.lesson import arrivals, record, run_program, start, values
from workbook.recording.recording import Recording

DRIVE, CAMERA = "/robot/cmd_vel", "/robot/camera"


EIGHT = round(2 * 2 * math.pi / (1.0 * figure_driver.PERIOD_S))  # commands for two circles at 1 rad/s


def end_of(recording: Recording) -> tuple[float, float]:
    """Return the position (m) of a robot that has followed each command of an eight for a tenth of a second."""
    x = y = heading = 0.0
    for arrival in recording.topic(DRIVE).arrivals[:EIGHT]:
        heading += 0.1 * arrival.value["angular"]["z"]
        x += 0.1 * arrival.value["linear"]["x"] * math.cos(heading)
        y += 0.1 * arrival.value["linear"]["x"] * math.sin(heading)
    return x, y


def test_an_eight_turns_left_and_then_right_and_comes_back() -> None:
    # A few seconds more than the eight takes, because on a busy machine timers skip ticks.
    recording = record(figure_driver, {DRIVE: 0.1}, seconds=16)
    turns = [arrival.value["angular"]["z"] for arrival in recording.topic(DRIVE).arrivals[:EIGHT]]
    assert len(turns) == EIGHT
    assert [turn for turn, other in zip(turns, [0.0, *turns], strict=False) if turn != other] == [1.0, -1.0]
    assert math.hypot(*end_of(recording)) < 0.1
    assert ended_well(recording), recording.process


def test_a_circle_goes_on_to_the_same_side() -> None:
    recording = record(figure_driver, {DRIVE: 0.1}, seconds=5, turn_radps=-2.0, eight=False)
    turns = {arrival.value["angular"]["z"] for arrival in recording.topic(DRIVE).arrivals}
    assert turns == {-2.0}


def test_a_speed_that_is_no_number_is_refused_in_words() -> None:
    with pytest.raises(RuntimeError, match="forward_mps must be a finite number, not nan"):
        start(figure_driver, forward_mps=".nan")


def test_the_camera_sends_whole_pictures_of_a_ball_that_rolls() -> None:
    recording = record(tiny_camera, {CAMERA: 0.5}, seconds=4)
    images = [arrival.value for arrival in recording.topic(CAMERA).arrivals]
    assert [round(t, 1) for t in arrivals(recording, CAMERA)] == [0.5 * n for n in range(1, 9)]
    columns = []
    for image in images[1:6]:
        assert len(image["data"]) == image["height"] * image["step"] == 3 * image["width"] * image["height"]
        row = image["data"][tiny_camera.BALL_ROW * image["step"] :][: image["step"]]
        pixels = [tuple(row[3 * place : 3 * place + 3]) for place in range(image["width"])]
        found = [place for place, pixel in enumerate(pixels) if pixel == tiny_camera.BALL]
        columns.append(sum(found) / len(found))
    assert columns == [2.0, 4.0, 6.0, 8.0, 10.0]
    assert ended_well(recording), recording.process


def desk_that_heard(*heard: tuple[int, str | float]) -> LevelDesk:
    """Make a desk without a node that seems to have received these values at these times."""
    desk = LevelDesk.__new__(LevelDesk)
    desk.heard = list(heard)
    desk.trouble = ""
    return desk


def test_the_desk_puts_a_level_down_to_the_call_before_it_whatever_came_first() -> None:
    desk = desk_that_heard(
        (2, 87.25),
        (1, "call 1: publish_level(87.25)"),
        (3, "call 1 returned"),
        (4, "call 2: publish_level(None)"),
        (5, "call 2 raised TypeError: no number"),
        (6, "call 3: publish_level('a\nb')"),
    )
    assert [(call.value, call.levels) for call in desk.calls()] == [
        ("87.25", [87.25]),
        ("None", []),
        ("'a\nb'", []),
    ]
    lines = desk.table().splitlines()
    assert lines[0].split() == ["given", "arrived", "the", "call"]
    assert lines[1].split() == ["87.25", "87.25", "returned"]
    assert "nothing   raised TypeError: no number" in lines[2]
    assert "never came back" in desk.table()


DESK_AND_DRIVER = """
import rclpy
from rclpy.executors import SingleThreadedExecutor
from rclpy.node import Node
from std_msgs.msg import Float32, String
from lesson_nodes.level_desk import LATCHED, LevelDesk

rclpy.init()
desk = LevelDesk(["64"])
driver = Node("driver")
report = driver.create_publisher(String, "/driver/report", 10)
battery = driver.create_publisher(Float32, "/robot/battery", 10)

def on_calls(message):
    report.publish(String(data=f"call 1: publish_level({message.data})"))
    battery.publish(Float32(data=64.0))
    for text in ("call 1 returned", "done"):
        report.publish(String(data=text))

executor = SingleThreadedExecutor()
executor.add_node(desk)
executor.add_node(driver)
while report.get_subscription_count() == 0 or battery.get_subscription_count() == 0:
    executor.spin_once(timeout_sec=0.05)
driver.create_subscription(String, "/driver/calls", on_calls, LATCHED)
while not desk.done or not desk.calls()[0].levels:
    executor.spin_once(timeout_sec=0.5)
print(desk.table())
rclpy.shutdown()
"""


def test_the_desk_reaches_a_driver_that_comes_later() -> None:
    outcome = run_program(DESK_AND_DRIVER, seconds=20)
    assert outcome.exit == 0, outcome.log
    assert "64      64.0      returned" in outcome.log


WAITING_DESK = """
from lesson_nodes import level_desk

class Loud(level_desk.LevelDesk):
    def __init__(self):
        super().__init__()
        self.create_timer(0.1, lambda: print("waiting", flush=True))

level_desk.LevelDesk = Loud
level_desk.main()
"""


def test_the_desk_ends_on_ctrl_c_without_a_word() -> None:
    outcome = run_program(WAITING_DESK, seconds=10, interrupt_at="waiting")
    assert ended_in_order(outcome.exit, outcome.log), outcome.log
    if outcome.exit == 0:
        assert set(outcome.log.split()) == {"waiting"}


def test_the_levels_are_published_as_they_are_named_and_once() -> None:
    recording = record(battery_levels, {"/robot/battery": 0.5}, seconds=4, levels=["80.0", "0.5", "80"])
    assert values(recording, "/robot/battery") == [80.0, 0.5, 0.0]
    assert ended_well(recording), recording.process
