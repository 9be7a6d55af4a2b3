"""The nodes of lesson 07: three implementations of one battery report that no subscriber can tell apart."""

from types import ModuleType

import pytest
import rclpy

from lesson_nodes import battery_class, battery_closure, battery_script
from tests.lesson_nodes.ending import ended_in_order
from workbook.lesson import arrivals, check_types, record, values

BATTERY = "/robot/battery"
SHAPES = (battery_script, battery_closure, battery_class)


def name(module: ModuleType) -> str:
    return module.__name__.rsplit(".", 1)[1]


@pytest.mark.parametrize("shape", SHAPES, ids=name)
def test_each_shape_reports_thirty_times_a_minute_and_ends_well_on_ctrl_c(shape: ModuleType) -> None:
    recording = record(shape, {BATTERY: 2.0}, seconds=60)
    assert [node.name for node in recording.nodes] == [f"/{name(shape)}"]
    assert len(arrivals(recording, BATTERY)) == 30
    assert values(recording, BATTERY) == [99.5 - 0.5 * number for number in range(30)]
    assert recording.process.ended_by == "judge"
    assert ended_in_order(recording.process.exit, recording.process.log + recording.process.end_log)


@pytest.mark.parametrize("shape", SHAPES, ids=name)
def test_each_shape_is_typed(shape: ModuleType) -> None:
    assert len(check_types(shape)) == 0


def test_importing_them_starts_nothing() -> None:
    assert not rclpy.ok()
