"""The nodes of lesson 06 and its exercise: a robot that reports its actions, and a spin loop watched from outside."""

import textwrap
from pathlib import Path

import pytest
from std_msgs.msg import String

from lesson_nodes import attentive_robot, pump_watcher
from lesson_nodes.attentive_robot import AttentiveRobot
from lesson_nodes.pump_watcher import PumpWatcher
from tests.lesson_nodes.ending import ended_in_order, ended_well
from workbook.lesson import arrivals, record, run_program, spin_for, start, values
from workbook.ros.session import init, shutdown

DONE = "/robot/done"


def test_a_minute_of_the_attentive_robot() -> None:
    recording = record(attentive_robot, {DONE: 1.0}, seconds=60, look_period_s=3.0)
    deeds = values(recording, DONE)
    assert abs(deeds.count("beat") - 60) <= 1
    assert abs(deeds.count("look") - 20) <= 1
    assert len(arrivals(recording, DONE)) == len(deeds)
    assert ended_well(recording), recording.process


def test_it_hears_and_remembers_each_word() -> None:
    init()
    robot = AttentiveRobot()
    try:
        for word in ("stop", "wait"):
            robot.on_word(String(data=word))
        assert robot.done == ["heard stop", "heard wait"]
        spin_for(robot, seconds=5.0, until=lambda: "beat" in robot.done)
    finally:
        robot.destroy_node()
        shutdown()


def test_an_impossible_period_is_refused_in_words() -> None:
    with pytest.raises(RuntimeError, match=r"not 0\.0"):
        start(attentive_robot, beat_period_s=0.0)


def test_the_watcher_notes_a_call_and_forgets_what_is_said_again() -> None:
    init()
    watcher = PumpWatcher()
    try:
        watcher.note("heartbeats")
        assert watcher.rows["heartbeats"] == []  # nothing counts before the call has begun
        for text in ("begin 1", "begin 1", "end 1 2.001", "end 1 2.001"):
            watcher.on_pump(String(data=text))
        watcher.note("heartbeats")
        assert len(watcher.rows["begin and end"]) == 2
        assert len(watcher.rows["heartbeats"]) == 1
        assert watcher.took is not None and watcher.took >= 0.0
    finally:
        watcher.destroy_node()
        shutdown()


def test_the_watcher_orders_a_call_and_talks_to_the_robot() -> None:
    code = textwrap.dedent(
        f"""
        import sys
        import rclpy
        from rclpy.executors import SingleThreadedExecutor
        from rclpy.node import Node
        from std_msgs.msg import Int32, Int32MultiArray, String

        sys.path.insert(0, {str(Path(pump_watcher.__file__).parents[1])!r})
        from lesson_nodes.pump_watcher import WORDS, PumpWatcher

        rclpy.init()
        robot, watcher = Node("robot"), PumpWatcher()
        heard, orders = [], []
        pump = robot.create_publisher(String, "/driver/pump", 10)
        robot.create_subscription(Int32, "/robot/words", lambda m: heard.append(m.data), 100)

        def on_go(message):
            orders.append(message.data)
            pump.publish(String(data="begin 1"))

        robot.create_subscription(String, "/driver/go", on_go, 10)
        executor = SingleThreadedExecutor()
        executor.add_node(robot)
        executor.add_node(watcher)
        while len(heard) < WORDS:
            executor.spin_once(timeout_sec=1.0)
        print(orders[0], sorted(heard))
        rclpy.shutdown()
        """
    )
    report = run_program(code, seconds=20)
    assert report.exit == 0, report.log
    assert "1 robot 2.0 [1, 2, 3, 4, 5, 6, 7, 8, 9, 10]" in report.log


def test_the_watcher_ends_well() -> None:
    report = run_program(
        Path(pump_watcher.__file__)
        .read_text()
        .replace(
            "rclpy.spin(PumpWatcher())", "node = PumpWatcher(); print('spins', flush=True); rclpy.spin(node)"
        ),
        seconds=15,
        interrupt_at="spins",
    )
    assert ended_in_order(report.exit, report.log), report.log
