"""The node of lesson 10: planning stops the heartbeat unless it has a separate thread and callback group."""

import os
from collections.abc import Iterator
from itertools import pairwise

import pytest
from rclpy.executors import MultiThreadedExecutor, SingleThreadedExecutor

from lesson_nodes import thinking_robot
from tests.lesson_nodes.ending import ended_well
from workbook.criteria.vocabulary.known_errors import shutdown_overtaken
from workbook.lesson import arrivals, record, start, stop, values
from workbook.ros.domains import lease_domain
from workbook.ros.environment import prepare
from workbook.ros.kernel_node import close_kernel_node
from workbook.ros.session import fresh, init, shutdown

HEARTBEAT, THOUGHT, JOINTS = "/robot/heartbeat", "/robot/thought", "/robot/joint_positions"
PERIODS = {HEARTBEAT: 0.1, THOUGHT: 1.1}


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
            shutdown()
            close_kernel_node()


@pytest.mark.parametrize(
    ("parameters", "heart_stops"),
    [
        ({}, True),
        ({"threads": 4}, True),
        ({"own_group": True}, True),
        ({"threads": 4, "own_group": True}, False),
    ],
)
def test_only_threads_and_a_group_together_keep_the_heart_beating(
    parameters: dict[str, object], heart_stops: bool
) -> None:
    recording = record(
        thinking_robot,
        PERIODS,
        seconds=3.5,
        clock="wall",
        think_period_s=1.1,
        think_takes_s=1.0,
        **parameters,
    )
    beats = arrivals(recording, HEARTBEAT)
    silence = max(b - a for a, b in pairwise(beats))
    assert (silence > 0.9) == heart_stops
    assert set(values(recording, THOUGHT)) == {"done"}
    # If rclpy's own shutdown error reaches main while an executor's threads still wait, they keep the process alive.
    assert ended_well(recording) or shutdown_overtaken(recording.process.end_log), recording.process


def test_the_arm_waves_with_each_beat() -> None:
    recording = record(
        thinking_robot, {HEARTBEAT: 0.1, JOINTS: 0.1}, seconds=3.0, clock="wall", think_takes_s=0.0
    )
    poses = values(recording, JOINTS)
    assert abs(len(poses) - len(arrivals(recording, HEARTBEAT))) <= 1
    assert {len(pose) for pose in poses} == {thinking_robot.JOINT_COUNT}  # type: ignore[arg-type]
    assert len({pose[thinking_robot.RIGHT_ELBOW] for pose in poses}) > 10  # type: ignore[index]
    assert {pose[0] for pose in poses} == {0.0}  # type: ignore[index]


def test_one_thread_is_a_single_threaded_executor() -> None:
    init()
    robot = fresh(thinking_robot.ThinkingRobot)
    assert isinstance(thinking_robot.executor_for(robot), SingleThreadedExecutor)
    robot.threads = 3
    executor = thinking_robot.executor_for(robot)
    assert isinstance(executor, MultiThreadedExecutor)
    executor.shutdown()


@pytest.mark.parametrize(
    ("parameters", "words"),
    [
        ({"heartbeat_period_s": 0.0}, "not 0.0"),
        ({"think_period_s": -1.0}, "not -1.0"),
        ({"think_takes_s": -0.5}, "not -0.5"),
        ({"threads": 0}, "not 0"),
    ],
)
def test_impossible_settings_are_refused_in_words(parameters: dict[str, object], words: str) -> None:
    with pytest.raises(RuntimeError, match=words):
        start(thinking_robot, **parameters)
