"""Whether a message contains texts and numbers at all, and whether its arrays change from message to message."""

from dataclasses import replace

import pytest
from std_msgs.msg import Float32, String

import workbook.criteria as see
from tests.criteria.by_hand import every, on_topic, recorded
from tests.criteria.test_vocabulary import JOINTS, accepts, joints, refuses
from workbook.criteria import topic
from workbook.recording.recording import Recording

HEART = topic("/robot/heartbeat", String, hz=1.0)
TILT = topic("/robot/tilt", Float32, hz=5.0)


def tilts(*values: float, notes: tuple[str, ...] = ()) -> Recording:
    return replace(recorded(on_topic(TILT.name, TILT.type, every(0.2, len(values)), values)), notes=notes)


def test_floats_are_given() -> None:
    accepts(see.given_floats(tilts(0.0, 0.1), TILT))
    accepts(see.given_floats(tilts(0.0, 0.0, notes=("with field checks on: no complaint",)), TILT))


def test_zeros_alone_are_looked_at_with_field_checks() -> None:
    unsure = see.given_floats(tilts(0.0, 0.0), TILT)
    assert unsure.recheck_fields
    said = "with field checks on: line 7: AssertionError: The 'data' field must be of type 'float'"
    refuses(see.given_floats(tilts(0.0, 0.0, notes=(said,)), TILT), "2 messages", "line 7: AssertionError")


@pytest.mark.parametrize("values", [(0.0, 99.5, 99.0, 98.5, 98.0), (0.84, 0.83, 0.0, 0.0, 0.84, 0.85)])
def test_a_zero_that_stands_out_is_looked_at_with_field_checks(values: tuple[float, ...]) -> None:
    refuses(see.given_floats(tilts(*values), TILT), "although other messages contain")
    assert see.given_floats(tilts(*values), TILT).recheck_fields
    accepts(see.given_floats(tilts(*values, notes=("with field checks on: no complaint",)), TILT))


def test_a_zero_among_its_like_is_not() -> None:
    accepts(see.given_floats(tilts(0.0, 0.06, 0.1, 0.1, 0.06, 0.0, -0.06), TILT))
    accepts(see.given_floats(tilts(0.6, 0.4, 0.2, 0.1, 0.0), TILT))


@pytest.mark.parametrize("values", [(0.6, 0.4, 0.2, 0.1, 0.0, 0.0), (0.8, 0.6, 0.4, 0.2, 0.0, 0.8, 0.6)])
def test_zeros_that_an_int_may_have_become_are_looked_at(values: tuple[float, ...]) -> None:
    refuses(see.given_floats(tilts(*values), TILT), "in message", "although other messages contain")
    assert see.given_floats(tilts(*values), TILT).recheck_fields
    accepts(see.given_floats(tilts(*values, notes=("with field checks on: no complaint",)), TILT))


def test_arrays_of_different_lengths_are_not_compared() -> None:
    verdict = see.varies(joints([0.1], [0.1, 0.2], [0.1, 0.2, 0.3]), JOINTS, 2, 1e-6, "joint")
    refuses(verdict, "3 messages of different lengths")


def test_a_text_is_not_empty() -> None:
    accepts(see.has_text(recorded(on_topic(HEART.name, HEART.type, [1.0], ["alive"])), HEART))
    empty = recorded(on_topic(HEART.name, HEART.type, [1.0, 2.0], ["alive", ""]))
    refuses(see.has_text(empty, HEART), "1 of 2 messages")


@pytest.mark.parametrize(
    ("rows", "cause"),
    [
        ([[0.1, 0.1], [0.2, 0.2], [0.3, 0.3], [0.3, 0.3], [0.3, 0.3]], "varies.stands-still"),
        ([[0.1, 0.0], [0.1, 0.1], [0.2, 0.1], [0.2, 0.2], [0.3, 0.2]], "varies.one-at-a-time"),
        ([[0.0, 0.0], [0.1, 0.1], [0.1, 0.2], [0.4, 0.6], [0.4, 0.6]], "varies.two-kinds"),
    ],
)
def test_arrays_that_do_not_move_from_message_to_message(rows: list[list[float]], cause: str) -> None:
    verdict = see.varies(joints(*rows), JOINTS, 2, 1e-6, "joint")
    refuses(verdict, "4 messages")
    assert verdict.cause == cause


def test_a_movement_may_turn_around() -> None:
    turning = [[0.1, 0.2], [0.2, 0.3], [0.2, 0.3], [0.1, 0.2], [0.0, 0.1]]
    accepts(see.varies(joints(*turning), JOINTS, 2, 1e-6, "joint"), "2 of 2")
