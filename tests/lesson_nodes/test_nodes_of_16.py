"""The nodes of lesson 16: a camera above toys, a detector in a callback or a thread, and a scope."""

import threading
from collections.abc import Iterator
from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest
import rclpy
from rclpy.parameter import Parameter
from sensor_msgs.msg import Image
from std_msgs.msg import String

from lesson_nodes.toy_camera import ToyCamera, pinhole, scene_at
from lesson_nodes.toy_detector import ToyDetector
from lesson_nodes.toy_scope import ToyScope, to_detection
from workbook.models.accuracy import matches
from workbook.ros.domains import lease_domain
from workbook.ros.environment import prepare
from workbook.scenes.tabletop import things_in

TOYS = ["ball", "brick", "cup", "plate"]


@pytest.fixture(autouse=True)
def context() -> Iterator[None]:
    with lease_domain() as lease:
        prepare(domain_id=lease.domain_id)
        rclpy.init(domain_id=lease.domain_id, signal_handler_options=rclpy.signals.SignalHandlerOptions.NO)
        try:
            yield
        finally:
            rclpy.shutdown()


def overrides(settings: dict[str, Any]) -> list[Parameter]:
    return [Parameter(name, value=value) for name, value in settings.items()]


def pictures(number: int, **settings: Any) -> list[Image]:
    """Return what a camera publishes, in order."""
    node: Any = ToyCamera(parameter_overrides=overrides(settings))
    published: list[Image] = []
    node.timer.cancel()
    node.publisher = SimpleNamespace(publish=published.append)
    for _ in range(number):
        node.publish_picture()
    return published


def detector(**settings: Any) -> tuple[Any, list[Any]]:
    """Create a detector without delays, and collect what it publishes, in order."""
    node: Any = ToyDetector(parameter_overrides=overrides({"takes_s": 0.0, **settings}))
    published: list[Any] = []
    node.publisher = SimpleNamespace(publish=published.append)
    return node, published


def test_the_detector_finds_all_toys_and_keeps_the_header() -> None:
    node, published = detector()
    (image,) = pictures(1)
    node.look(image)
    markers = published[0].markers
    assert sorted(marker.ns for marker in markers) == TOYS
    assert all(marker.header == image.header for marker in markers)
    there = things_in(scene_at(0.0), pinhole(160))
    assert all(any(matches(to_detection(marker), thing) for thing in there) for marker in markers)


def test_the_ball_rolls_and_every_toy_is_found_on_its_way() -> None:
    node, published = detector()
    for image in pictures(160)[::8]:
        node.look(image)
    found = [sorted(marker.ns for marker in message.markers) for message in published]
    assert found == [TOYS] * 20
    columns = [
        marker.pose.position.x for message in published for marker in message.markers if marker.ns == "ball"
    ]
    assert max(columns) - min(columns) > 80


def test_a_callback_keeps_only_the_newest_picture_for_the_thread() -> None:
    node, _ = detector()
    first, second = pictures(2)
    node.keep_newest(first)
    node.keep_newest(second)
    assert node.waiting.get_nowait() is second
    assert node.waiting.empty()


def test_a_model_that_raises_does_not_end_the_thread() -> None:
    node, published = detector(where="thread")
    works, done = node.detector, threading.Event()
    node.publisher.publish = lambda message: (published.append(message), done.set())
    said: list[str] = []
    node.get_logger = lambda: SimpleNamespace(error=said.append)

    def fails_once(pixels: Any) -> Any:
        node.detector = works
        node.keep_newest(good)
        raise RuntimeError("out of memory")

    bad, good = pictures(2)
    node.detector = fails_once
    node.keep_newest(bad)
    assert done.wait(30.0)
    node.close()
    assert said == ["The model failed: out of memory"]
    assert [message.markers[0].header for message in published] == [good.header]
    assert not node.worker.is_alive()


def test_the_faults_of_the_lesson() -> None:
    (image,) = pictures(1)
    taken = image.header.stamp
    node, published = detector(stamps_now=True, loads_each_time=True)
    loaded = node.detector
    node.load_and_look(image)
    assert node.detector is not loaded
    assert published[0].markers[0].header.stamp != taken


@pytest.mark.parametrize("settings", [{"depth": 0}, {"where": "process"}])
def test_settings_of_a_detector_that_are_none_are_refused(settings: dict[str, Any]) -> None:
    with pytest.raises(ValueError, match="The depth is 1 or more"):
        detector(**settings)


@pytest.mark.parametrize(
    ("settings", "words"), [({"period_s": 0.0}, "time between"), ({"width": 200}, "width")]
)
def test_settings_of_a_camera_that_are_none_are_refused(settings: dict[str, Any], words: str) -> None:
    with pytest.raises(ValueError, match=words):
        pictures(1, **settings)


def test_the_scope_keeps_ages_beats_and_a_film() -> None:
    node, published = detector()
    scope = ToyScope()
    scope.on_beat(String(data="alive"))
    taken = pictures(7, width=320)
    for number, image in enumerate(taken):
        scope.on_image(image)
        if number == 1:
            node.look(image)
            scope.on_detections(published[-1])
    assert len(scope.beats) == len(scope.ages) == 1
    assert 0.0 <= scope.ages[0] < 60.0
    assert [len(found) for _, found in scope.film] == [4, 4]
    wanted = np.frombuffer(taken[2].data, np.uint8).reshape(240, 320, 3)
    assert (scope.film[0][0] == wanted).all()
