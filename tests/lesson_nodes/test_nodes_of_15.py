"""The nodes of lesson 15: a camera in the head, and a scope that stores its images."""

import math
from collections.abc import Iterator
from types import SimpleNamespace
from typing import Any

import cv2
import numpy as np
import pytest
import rclpy
from geometry_msgs.msg import Vector3Stamped
from rclpy.parameter import Parameter
from sensor_msgs.msg import CompressedImage, Image
from std_msgs.msg import Float32MultiArray

from lesson_nodes.ball_scope import BallScope
from lesson_nodes.head_camera import AT_REST, HeadCamera, ball_at, frame, pinhole
from workbook.ros.domains import lease_domain
from workbook.ros.environment import prepare


@pytest.fixture(autouse=True)
def context() -> Iterator[None]:
    with lease_domain() as lease:
        prepare(domain_id=lease.domain_id)
        rclpy.init(domain_id=lease.domain_id, signal_handler_options=rclpy.signals.SignalHandlerOptions.NO)
        try:
            yield
        finally:
            rclpy.shutdown()


def camera(**settings: Any) -> tuple[Any, list[Any]]:
    """Create a camera, and collect what it publishes, in order."""
    parameters = [Parameter(name, value=value) for name, value in {"width": 160, **settings}.items()]
    node: Any = HeadCamera(parameter_overrides=parameters)
    published: list[Any] = []
    node.timer.cancel()
    node.image_publisher = node.jpeg_publisher = SimpleNamespace(publish=published.append)
    return node, published


def pixels_of(image: Image) -> Any:
    rows = np.frombuffer(image.data, np.uint8).reshape(image.height, image.step)
    return rows[:, : 3 * image.width].reshape(image.height, image.width, 3)


def is_orange(image: Image, place: tuple[float, float]) -> bool:
    red, green, blue = (float(part) for part in pixels_of(image)[round(place[1]), round(place[0])])
    return red > 1.5 * green > 2.0 * blue


def test_the_same_seed_brings_the_same_pictures_and_another_seed_others() -> None:
    taken = []
    for seed in (15, 15, 16):
        node, published = camera(seed=seed)
        node.publish_picture()
        node.publish_picture()
        taken.append([image.data.tobytes() for image in published])
    assert taken[0] == taken[1]
    assert taken[0] != taken[2]
    assert taken[0][0] != taken[0][1]


def test_a_frozen_camera_publishes_one_frame_again_and_again() -> None:
    node, published = camera(frozen=20)
    for _ in range(3):
        node.publish_picture()
    rolling, others = camera()
    rolling.count = 20
    rolling.publish_picture()
    assert {image.data.tobytes() for image in published} == {others[0].data.tobytes()}
    assert (pixels_of(published[0]) == frame(20, 160)).all()


def test_a_camera_that_waits_takes_the_next_picture_after_joint_positions_or_half_a_second(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    now = [100.0]
    monkeypatch.setattr("lesson_nodes.head_camera.time.monotonic", lambda: now[0])
    node, published = camera(waits=True)
    node.take_picture()
    node.take_picture()
    assert len(published) == 1
    node.on_joints(Float32MultiArray(data=[0.2, *AT_REST[1:]]))
    node.take_picture()
    assert len(published) == 2
    now[0] += 0.49
    node.take_picture()
    assert len(published) == 2
    now[0] += 0.01
    node.take_picture()
    assert len(published) == 3


def test_a_camera_that_does_not_wait_takes_a_picture_at_each_tick() -> None:
    node, published = camera()
    for _ in range(3):
        node.take_picture()
    assert len(published) == 3


def test_an_image_says_what_its_bytes_mean() -> None:
    rgb, first = camera()
    bgr, second = camera(encoding="bgr8", padding=32)
    rgb.publish_picture()
    bgr.publish_picture()
    assert (first[0].encoding, first[0].step, first[0].height, first[0].width) == ("rgb8", 480, 120, 160)
    assert (second[0].encoding, second[0].step) == ("bgr8", 512)
    assert (pixels_of(second[0])[..., ::-1] == pixels_of(first[0])).all()


def test_the_neck_turns_the_camera() -> None:
    node, published = camera()
    node.publish_picture()
    node.count = 0
    node.on_joints(Float32MultiArray(data=[0.2, *AT_REST[1:]]))
    node.publish_picture()
    ahead, turned = (pinhole(160).pixel(pinhole(160).seen_from(ball_at(0.0), pan)) for pan in (0.0, 0.2))
    assert turned[0] > ahead[0] + 15
    assert [is_orange(image, ahead) for image in published] == [True, False]
    assert [is_orange(image, turned) for image in published] == [False, True]


@pytest.mark.parametrize("angles", [[], [0.0] * 11, [math.nan, *AT_REST[1:]]])
def test_a_pose_that_is_none_moves_nothing(angles: list[float]) -> None:
    node, _ = camera()
    node.on_joints(Float32MultiArray(data=angles))
    assert node.joints == AT_REST


def test_a_compressed_picture_is_smaller_and_shows_the_same() -> None:
    node, published = camera(jpeg_quality=80)
    node.publish_picture()
    raw, jpeg = published
    assert isinstance(jpeg, CompressedImage)
    assert jpeg.header.stamp == raw.header.stamp
    assert 4 * len(jpeg.data) < len(raw.data)
    shown = cv2.imdecode(np.frombuffer(jpeg.data, np.uint8), cv2.IMREAD_COLOR)
    assert shown is not None
    assert np.abs(shown[..., ::-1].astype(float) - pixels_of(raw)).mean() < 6


@pytest.mark.parametrize(
    ("settings", "words"),
    [
        ({"period_s": 0.0}, "time between two pictures"),
        ({"encoding": "mono16"}, "rgb8, bgr8 or mono8"),
    ],
)
def test_settings_that_are_none_are_refused(settings: dict[str, Any], words: str) -> None:
    with pytest.raises(ValueError, match=words):
        camera(**settings)


def test_the_ball_stays_on_the_desk_and_moves() -> None:
    places = [ball_at(seconds / 10) for seconds in range(200)]
    assert all(0.7 < forward < 0.95 and abs(left) < 0.45 for forward, left, _ in places)
    assert max(left for _, left, _ in places) - min(left for _, left, _ in places) > 0.6


def test_the_scope_keeps_pictures_without_padding_and_directions() -> None:
    node, published = camera(padding=32)
    node.publish_picture()
    scope = BallScope()
    scope.on_image(published[0])
    message = Vector3Stamped(header=published[0].header)
    message.vector.z = 1.0
    scope.on_direction(message)
    stamp, picture = scope.pictures[-1]
    assert (picture == pixels_of(published[0])).all()
    assert scope.directions == [(stamp, (0.0, 0.0, 1.0))]


def test_the_film_of_the_scope_holds_every_fifth_picture() -> None:
    node, published = camera()
    scope = BallScope()
    for _ in range(7):
        node.publish_picture()
        scope.on_image(published[-1])
    assert len(scope.film) == 2
    assert (scope.film[1] == pixels_of(published[5])).all()
