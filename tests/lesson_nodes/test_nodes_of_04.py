"""The nodes of lesson 04: what they receive, what they publish in response, and how they end."""

import math
from collections.abc import Iterator
from types import ModuleType

import pytest
import rclpy
from rclpy.node import Node
from std_msgs.msg import Float32

from lesson_nodes import battery_desk, black_box, careful_robot, distance_sensor
from tests.lesson_nodes.ending import ended_well
from workbook.lesson import record, start, values
from workbook.lesson.programs import program_file
from workbook.programs.spec import ProgramSpec
from workbook.recording.plan import Plan
from workbook.recording.recording import Recording
from workbook.recording.script import Script, publish
from workbook.ros.domains import lease_domain
from workbook.ros.environment import prepare
from workbook.watching.observer import Observer
from workbook.watching.watch import Watch

DISTANCE, JOINTS, KEPT = "/robot/distance", "/robot/joint_positions", "/black_box/kept"
PATIENCE_S = 20.0


def recording_of(program: ModuleType, distances: list[float], answer: str, **parameters: object) -> Recording:
    """Return what a lesson node publishes for distances that are 0.1 s of simulated time apart."""
    lines = [(0.3 + 0.1 * number, distance) for number, distance in enumerate(distances)]
    plan = Plan(
        (answer,), 0.1, 1.0, simulated_seconds=3.0, script=Script((publish(DISTANCE, Float32, lines),))
    )
    with Observer() as observer:
        with Watch(
            observer, ProgramSpec(program_file(program), parameters=parameters), plan, "simulated"
        ) as watch:
            return watch.finish(watch.observe(), 4.0)


def test_the_sensor_walks_to_the_wall_and_back() -> None:
    recording = record(distance_sensor, {DISTANCE: 0.5}, seconds=10, period_s=0.5)
    distances = [float(str(distance)) for distance in values(recording, DISTANCE)]
    assert len(distances) == 20
    assert min(distances) == pytest.approx(distance_sensor.NEAR_M, abs=0.01)
    assert max(distances) == pytest.approx(distance_sensor.FAR_M, abs=0.01)
    assert distances[4] < distances[0] > 1.0
    assert ended_well(recording), recording.process


def test_the_robot_takes_one_posture_for_each_distance() -> None:
    distances = [2.0, 1.2, 0.7, 0.2, 0.0, 2.0]
    recording = recording_of(careful_robot, distances, JOINTS)
    shoulders = [pose[careful_robot.LEFT_SHOULDER] for pose in values(recording, JOINTS)]  # type: ignore[index]
    down, up = careful_robot.ARMS_DOWN_RAD, careful_robot.ARMS_UP_RAD
    assert shoulders == pytest.approx([down, down, (down + up) / 2, up, up, down], abs=1e-5)
    assert ended_well(recording), recording.process


def test_the_black_box_counts_what_it_keeps() -> None:
    recording = recording_of(black_box, [1.0, 0.9, 0.8, 0.7, 0.6], KEPT)
    counts = values(recording, KEPT)
    assert counts[-1] == 5
    assert counts == sorted(counts, key=str)
    assert ended_well(recording), recording.process


@pytest.mark.parametrize("distance_m", [0.0, 0.2, 1.0, 2.0, 50.0])
def test_every_posture_has_twelve_finite_angles(distance_m: float) -> None:
    angles = careful_robot.posture(distance_m, close_m=1.5)
    assert len(angles) == careful_robot.JOINT_COUNT
    assert all(math.isfinite(angle) for angle in angles)


@pytest.mark.parametrize(
    ("program", "parameters", "words"),
    [
        (distance_sensor, {"period_s": 0.0}, "not 0.0"),
        (careful_robot, {"close_m": 0.2}, "not 0.2"),
        (careful_robot, {"close_m": -1.0}, "not -1.0"),
    ],
)
def test_impossible_settings_are_refused_in_words(
    program: object, parameters: dict[str, float], words: str
) -> None:
    with pytest.raises(RuntimeError, match=words):
        start(program, **parameters)  # type: ignore[arg-type]


@pytest.fixture
def context() -> Iterator[None]:
    with lease_domain() as lease:
        prepare(domain_id=lease.domain_id)
        rclpy.init(domain_id=lease.domain_id, signal_handler_options=rclpy.signals.SignalHandlerOptions.NO)
        try:
            yield
        finally:
            rclpy.shutdown()


class Echo(Node):
    """A monitor that trusts all publishers."""

    def __init__(self) -> None:
        super().__init__("echo")
        self.out = self.create_publisher(Float32, "/monitor/battery", 10)
        self.create_subscription(Float32, "/robot/battery", self.out.publish, 10)


def test_the_desk_writes_down_what_comes_back(context: None) -> None:
    executor = rclpy.executors.SingleThreadedExecutor()
    desk = battery_desk.BatteryDesk([64.0, math.nan])
    assert "Nobody listens" in desk.table()
    for node in (desk, Echo()):
        executor.add_node(node)
    while not desk.done:
        executor.spin_once(timeout_sec=PATIENCE_S)
    executor.shutdown()
    assert [(topic, said) for topic, _, said in desk.rows] == [
        ("/robot/battery", ["passed on 64"]),
        ("/robot/battery", ["passed on nan"]),
        ("/other_robot/battery", []),
        ("/other_robot/battery", []),
    ]
    assert desk.table().count("\n") == 4
