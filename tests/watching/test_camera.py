"""What a recording keeps of large fields (size, hash, and an exercise's features), and what a camera costs."""

import hashlib
import os
import time
from pathlib import Path
from typing import Any

import pytest
from rclpy.serialization import serialize_message
from sensor_msgs.msg import Image

from tests.programs.support import write
from workbook.criteria.criterion import plan_for, topic, watching
from workbook.inside.proc import resident_bytes
from workbook.programs.spec import ProgramSpec
from workbook.recording.plan import BYTES_PER_TOPIC
from workbook.recording.recording import Arrival, Recording
from workbook.watching.message_quota import MessageQuota
from workbook.watching.observer import Observer
from workbook.watching.watch import Watch
from workbook.watching.watched_topic import WatchedTopic, finished

WATCH_S = 10.0
CAMERA_HZ = 30.0
IMAGE_BYTES = 640 * 480 * 3
MOST_MORE_BYTES = 150_000_000
MOST_JUDGING_S = 5.0
CAMERA = """
import rclpy
from rclpy.node import Node
from sensor_msgs.msg import Image

rclpy.init()
node = Node("camera")
images = node.create_publisher(Image, "/camera/image_raw", 10)
number = 0
def tick():
    global number
    number += 1
    images.publish(Image(height=480, width=640, step=1920, encoding="bgr8", data=bytes([1 + number % 200]) * 921600))
node.create_timer(1 / 30, tick)
rclpy.spin(node)
"""


def brightness(image: Image) -> dict[str, Any]:
    """Return the mean of some of its values, and the position of the brightest one."""
    some = bytes(image.data[:: image.width])
    return {"mean": sum(some) / len(some), "brightest": [some.index(max(some)), max(some)]}


CAMERA_TOPIC = topic("/camera/image_raw", Image, hz=CAMERA_HZ, features={"data": brightness})


def image(data: bytes, width: int = 640) -> bytes:
    return serialize_message(Image(height=480, width=width, encoding="bgr8", data=data))


def kept(*messages: bytes) -> tuple[Arrival, ...]:
    watched = WatchedTopic("/camera/image_raw", MessageQuota(BYTES_PER_TOPIC, 1000), CAMERA_TOPIC.features)
    watched.subscribed_type = "sensor_msgs/msg/Image"
    for moment, raw in enumerate(messages):
        watched.keep(float(moment), float(moment), float(moment), raw)
    return finished(watched, 1000.0).arrivals


def test_a_large_field_is_kept_as_its_size_its_hash_and_what_the_exercise_declares() -> None:
    [arrival] = kept(image(b"\x07" * IMAGE_BYTES))
    field = arrival.value["data"]
    assert (field["length"], field["sha256"]) == (
        IMAGE_BYTES,
        hashlib.sha256(b"\x07" * IMAGE_BYTES).hexdigest(),
    )
    assert field["features"] == {"mean": 7.0, "brightest": [0, 7]}
    assert arrival.value["width"] == 640


def test_a_short_field_has_its_features_as_well() -> None:
    [arrival] = kept(image(b"\x01\x03", width=1))
    assert arrival.value["data"] == {
        "length": 2,
        "first": [1, 3],
        "features": {"mean": 2.0, "brightest": [1, 3]},
    }


def test_a_message_of_which_no_features_can_be_told_is_kept_without() -> None:
    [empty, no_width] = kept(image(b""), image(b"\x01" * IMAGE_BYTES, width=0))
    assert empty.value["data"] == {"length": 0, "first": [], "features": None}
    assert no_width.value["data"]["features"] is None


@pytest.mark.parametrize("told", [object(), [0.0] * 10_000], ids=["no data", "too much"])
def test_features_are_few_and_plain(told: object) -> None:
    watched = WatchedTopic("/camera/image_raw", MessageQuota(BYTES_PER_TOPIC, 10), {"data": lambda _: told})
    watched.subscribed_type = "sensor_msgs/msg/Image"
    watched.keep(0.0, 0.0, 0.0, image(b"\x01"))
    assert finished(watched, 1.0).arrivals[0].value["data"]["features"] is None


@pytest.mark.slow
@pytest.mark.whole
def test_a_camera_of_ten_seconds_fits(tmp_path: Path) -> None:
    """640 by 480 pixels at 30 Hz: 277 MB, within the usual quota."""
    plan = plan_for([CAMERA_TOPIC], watching(wall_seconds=WATCH_S))
    with (
        Observer() as observer,
        Watch(observer, ProgramSpec(write(tmp_path, CAMERA)), plan, "wall") as watch,
    ):
        before = resident_bytes(os.getpid())
        watch.observe()
        began = time.process_time()
        recording = watch.recording()
        images = recording.topic("/camera/image_raw")
        stored = Recording.from_json(recording.to_json()).topic("/camera/image_raw")
        took = time.process_time() - began
        more = resident_bytes(os.getpid()) - before
    print(f"{len(images.arrivals)} images, {more / 1e6:.0f} MB more, {took:.2f} s")
    assert (images.not_kept, images.full_at) == (0, None)
    assert len(images.arrivals) > WATCH_S * 2
    assert all(one.value["data"]["length"] == IMAGE_BYTES for one in images.arrivals)
    assert all(one.value["data"]["features"]["mean"] > 0 for one in images.arrivals)
    assert stored == images
    assert more < MOST_MORE_BYTES
    assert took < MOST_JUDGING_S
