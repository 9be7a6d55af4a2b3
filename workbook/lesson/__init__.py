"""Provide the functions that lesson cells import: for predictions, programs, live views, and figures of recordings.

Lessons import from the package itself (`from workbook.lesson import run`). Other packages import the modules that
lessons and exercises share, such as `startup` and `progress`. Each name is imported on first use.
"""

from importlib import import_module
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from workbook.lesson.doctor_report import doctor
    from workbook.lesson.graphs import graph_picture
    from workbook.lesson.knobs import knob, slide
    from workbook.lesson.machine import record_machine, show_machine, watch_machine
    from workbook.lesson.measured import about, yours
    from workbook.lesson.older_predictions import predicted, recall
    from workbook.lesson.predictions import predict, reveal
    from workbook.lesson.programs import arrivals, processor_seconds, record, run_program, start, stop, values
    from workbook.lesson.type_reports import check_types, stub_of
    from workbook.lesson.views import robot, watch_robot, watch_status
    from workbook.ros.fresh_nodes import fresh
    from workbook.ros.session import init, run, spin_for

_HOME = {
    "about": "workbook.lesson.measured",
    "arrivals": "workbook.lesson.programs",
    "check_types": "workbook.lesson.type_reports",
    "doctor": "workbook.lesson.doctor_report",
    "fresh": "workbook.ros.fresh_nodes",
    "graph_picture": "workbook.lesson.graphs",
    "init": "workbook.ros.session",
    "knob": "workbook.lesson.knobs",
    "predict": "workbook.lesson.predictions",
    "processor_seconds": "workbook.lesson.programs",
    "predicted": "workbook.lesson.older_predictions",
    "recall": "workbook.lesson.older_predictions",
    "record": "workbook.lesson.programs",
    "record_machine": "workbook.lesson.machine",
    "reveal": "workbook.lesson.predictions",
    "robot": "workbook.lesson.views",
    "run": "workbook.ros.session",
    "run_program": "workbook.lesson.programs",
    "show_machine": "workbook.lesson.machine",
    "slide": "workbook.lesson.knobs",
    "spin_for": "workbook.ros.session",
    "start": "workbook.lesson.programs",
    "stop": "workbook.lesson.programs",
    "stub_of": "workbook.lesson.type_reports",
    "values": "workbook.lesson.programs",
    "watch_machine": "workbook.lesson.machine",
    "watch_robot": "workbook.lesson.views",
    "watch_status": "workbook.lesson.views",
    "yours": "workbook.lesson.measured",
}

__all__ = [
    "about",
    "arrivals",
    "check_types",
    "doctor",
    "fresh",
    "graph_picture",
    "init",
    "knob",
    "predict",
    "predicted",
    "processor_seconds",
    "recall",
    "record",
    "record_machine",
    "reveal",
    "robot",
    "run",
    "run_program",
    "show_machine",
    "slide",
    "spin_for",
    "start",
    "stop",
    "stub_of",
    "values",
    "watch_machine",
    "watch_robot",
    "watch_status",
    "yours",
]


def __getattr__(name: str) -> Any:
    if name in _HOME:
        return getattr(import_module(_HOME[name]), name)
    raise AttributeError(f"module {__name__!r} has no attribute {name!r}")


def __dir__() -> list[str]:
    return sorted([*globals(), *__all__])
