"""The nodes of lesson 14: noisy encoders, and a scope that records one joint."""

import statistics
from collections.abc import Iterator

import pytest
import rclpy
from builtin_interfaces.msg import Time
from sensor_msgs.msg import JointState
from std_msgs.msg import Header

from lesson_nodes import noisy_joints
from lesson_nodes.joint_position_publisher import JOINTS, waving
from lesson_nodes.joint_scope import JointScope
from lesson_nodes.noisy_joints import NoisyJoints
from workbook.lesson import record, values
from workbook.ros.domains import lease_domain
from workbook.ros.environment import prepare

ENCODERS = "/encoders/joint_states"
PERIOD_S = 0.1


@pytest.fixture
def context() -> Iterator[None]:
    with lease_domain() as lease:
        prepare(domain_id=lease.domain_id)
        rclpy.init(domain_id=lease.domain_id, signal_handler_options=rclpy.signals.SignalHandlerOptions.NO)
        try:
            yield
        finally:
            rclpy.shutdown()


def recorded(**parameters: object) -> dict[float, list[float]]:
    """Return the published angles of the encoders, by their stamps (s)."""
    seen = record(noisy_joints, {ENCODERS: PERIOD_S}, seconds=6.0, period_s=PERIOD_S, **parameters)
    assert all(names == list(JOINTS) for names in values(seen, ENCODERS, "name"))
    stamps = [header["stamp"] for header in values(seen, ENCODERS, "header")]  # type: ignore[index]
    seconds = [round(stamp["sec"] + stamp["nanosec"] / 1e9, 6) for stamp in stamps]
    return dict(zip(seconds, values(seen, ENCODERS, "position"), strict=True))  # type: ignore[arg-type]


@pytest.mark.whole
def test_the_same_seed_brings_the_same_noise_and_another_seed_another() -> None:
    one, again, other = recorded(), recorded(), recorded(seed=15)
    common = sorted(one.keys() & again.keys() & other.keys())
    assert len(common) > 20
    assert [one[stamp] for stamp in common] == [again[stamp] for stamp in common]
    assert all(one[stamp] != other[stamp] for stamp in common)


@pytest.mark.whole
def test_the_noise_is_as_large_as_it_is_told() -> None:
    noise = [
        angle - true
        for stamp, angles in recorded(noise_rad=0.2).items()
        for angle, true in zip(angles, waving(stamp, noisy_joints.WAVES_PER_SECOND), strict=True)
    ]
    assert 0.15 < statistics.pstdev(noise) < 0.25
    for stamp, angles in recorded(noise_rad=0.0).items():
        assert angles == pytest.approx(waving(stamp, noisy_joints.WAVES_PER_SECOND))


@pytest.mark.usefixtures("context")
@pytest.mark.parametrize("period_s", [0.0, -1.0])
def test_encoders_need_a_period(period_s: float) -> None:
    with pytest.raises(ValueError, match="time between two messages"):
        NoisyJoints(period_s=period_s)


@pytest.mark.usefixtures("context")
def test_noise_is_not_negative() -> None:
    with pytest.raises(ValueError, match=r"0\.0 rad or more"):
        NoisyJoints(noise_rad=-0.1)


@pytest.mark.usefixtures("context")
def test_the_scope_reads_its_joint_by_name_and_its_stamp() -> None:
    scope = JointScope("waist")
    message = JointState(header=Header(stamp=Time(sec=3, nanosec=250_000_000)))
    message.name, message.position = ["neck", "waist"], [0.1, 0.2]
    scope.on_measured(message)
    scope.on_filtered(message)
    assert scope.measured == scope.filtered == [(3.25, 0.2)]
