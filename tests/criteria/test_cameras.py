"""The judge as a camera: fields that are rendered late, and directions from the pinhole model."""

import hashlib
import math

import pytest
from sensor_msgs.msg import Image

import workbook.criteria as see
from workbook.recording.script import publish
from workbook.watching.script_player import fill

VIEW = see.CameraView(
    see.Scene(see.on_desk(0.8, 0.1)), (500, 40), seed=1, number=2, encoding="bgr8", padding=32
)


def test_the_fields_are_those_of_an_image() -> None:
    image = fill(Image(), see.camera_image(VIEW))
    assert (image.height, image.width, image.encoding, image.step) == (120, 160, "bgr8", 512)
    assert len(image.data) == 120 * 512
    assert (image.header.stamp.sec, image.header.stamp.nanosec) == (500, 40)


def test_the_same_view_gives_the_same_bytes_and_another_number_others() -> None:
    sums = {
        hashlib.sha256(see.camera_image(view)["data"]).hexdigest()
        for view in (VIEW, VIEW, see.CameraView(VIEW.scene, VIEW.stamp, 1, 3, encoding="bgr8", padding=32))
    }
    assert len(sums) == 2


def test_a_script_takes_them_as_they_are() -> None:
    fields = see.camera_image(VIEW)
    assert publish("/camera/image", Image, [(0.5, fields)]).lines[0].value is fields


def test_a_direction_has_length_one_and_points_to_the_place() -> None:
    x, y, z = see.seen_direction((math.cos(0.5), 0.0, -math.sin(0.5)))  # the camera looks down by 0.5 rad
    assert (x, y, z) == pytest.approx((0.0, 0.0, 1.0))
    x, y, z = see.seen_direction(see.on_desk(0.8, 0.3))
    assert math.hypot(x, y, z) == pytest.approx(1.0)
    assert x < 0  # to the left


def test_toys_are_where_the_camera_sees_them() -> None:
    scene = see.Scene(
        see.on_desk(0.8, 0.1),
        see.on_desk(0.9, -0.1),
        (see.Box((1.1, 0.3)),),
        pan=0.1,
        cups=(see.Cup((0.9, -0.3)),),
    )
    found = {one.label: one for one in see.things_seen(scene)}
    assert found.keys() == {"ball", "brick", "cup"}  # a blue ball doesn't count
    assert scene.ball is not None
    u, v = see.seen_pixel(scene.ball, pan=0.1)
    assert math.dist((found["ball"].u, found["ball"].v), (u, v)) < 1.0
    assert see.seen_pixel(scene.ball)[0] < u  # the head turns to the left, so everything moves to the right
