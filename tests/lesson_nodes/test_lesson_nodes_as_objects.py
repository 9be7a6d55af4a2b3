"""The lesson nodes as objects: the limits of their ranges, and their state."""

import time
from collections.abc import Callable, Iterator

import pytest
import rclpy
from rclpy.node import Node
from std_msgs.msg import Float32, String

from lesson_nodes.humanoid_status_publisher import HumanoidStatusPublisher
from lesson_nodes.joint_position_publisher import JointPositionPublisher
from lesson_nodes.status_monitor import StatusMonitor
from workbook.ros.domains import lease_domain
from workbook.ros.environment import prepare

PATIENCE_S = 20.0


@pytest.fixture(autouse=True)
def context() -> Iterator[None]:
    with lease_domain() as lease:
        prepare(domain_id=lease.domain_id)
        rclpy.init(domain_id=lease.domain_id, signal_handler_options=rclpy.signals.SignalHandlerOptions.NO)
        try:
            yield
        finally:
            rclpy.shutdown()


def spin_until(nodes: list[Node], done: Callable[[], bool]) -> None:
    """Spin the nodes until `done()` is true. Fail after PATIENCE_S seconds."""
    executor = rclpy.executors.SingleThreadedExecutor()
    for node in nodes:
        executor.add_node(node)
    deadline = time.monotonic() + PATIENCE_S
    while not done():
        assert time.monotonic() < deadline, "the nodes did not get there in time"
        executor.spin_once(timeout_sec=0.05)
    for node in nodes:
        executor.remove_node(node)
    executor.shutdown()


def test_the_battery_stops_at_zero_and_the_status_turns_to_error() -> None:
    robot, monitor = HumanoidStatusPublisher(battery_level=0.3), StatusMonitor()
    spin_until(
        [robot, monitor],
        lambda: (
            robot.status_publisher.get_subscription_count() > 0
            and robot.battery_publisher.get_subscription_count() > 0
        ),
    )
    robot.publish_status()
    spin_until([monitor], lambda: monitor.last_status == "operational")
    for _ in range(4):
        robot.publish_battery()
    robot.publish_status()
    spin_until([monitor], lambda: monitor.last_battery == 0.0 and monitor.last_status == "error")
    assert robot.battery_level == 0.0
    assert monitor.battery_is_low


@pytest.mark.parametrize("level", [-0.1, 100.1, float("nan")])
def test_a_battery_holds_zero_to_hundred_percent(level: float) -> None:
    with pytest.raises(ValueError, match="0 to 100 percent"):
        HumanoidStatusPublisher(battery_level=level)


@pytest.mark.parametrize("period_s", [0.0, -1.0, float("inf"), float("nan")])
def test_a_period_is_a_positive_number_of_seconds(period_s: float) -> None:
    with pytest.raises(ValueError, match="seconds"):
        JointPositionPublisher(period_s)


@pytest.mark.parametrize("waves_per_second", [-0.8, float("inf"), float("nan")])
def test_a_hand_waves_so_many_times_a_second(waves_per_second: float) -> None:
    with pytest.raises(ValueError, match="times a second"):
        JointPositionPublisher(waves_per_second=waves_per_second)


def test_the_monitor_warns_once_for_each_time_the_battery_runs_low(capfd: pytest.CaptureFixture[str]) -> None:
    monitor = StatusMonitor()
    for level in (20.0, 19.9, 12.0, 55.0, 8.0):
        monitor.on_battery(Float32(data=level))
    assert monitor.last_battery == 8.0
    for word in ("operational", "operational", "error"):
        monitor.on_status(String(data=word))
    assert monitor.last_status == "error"
    log = capfd.readouterr().err
    assert [line.split("Battery low: ")[1] for line in log.splitlines() if "Battery low" in line] == [
        "19.9 %",
        "8.0 %",
    ]
    assert log.count("The robot is operational") == 1
