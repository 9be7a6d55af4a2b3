"""Small notebooks for the tests of the panel next to the notebook."""

import json
from pathlib import Path

WAVES = """\
from lesson_nodes import joint_position_publisher
from workbook.lesson import start, stop
print("started", start(joint_position_publisher, period_s=0.05))"""
QUIET = """\
from std_msgs.msg import String
from workbook.lesson import fresh, init, spin_for
from workbook.ros import node_list
from rclpy.node import Node
init()
lonely = fresh(Node, "lonely")
words = lonely.create_publisher(String, "/words", 10)"""
TURNS = """\
from workbook.lesson.knobs import Knob
Knob("loudness", 1, (0, 3)).show()"""
SAYS = """\
for word in ("one", "two", "three"):
    words.publish(String(data=word))
print("subscriptions:", words.get_subscription_count(), "nodes:", *node_list())"""


def write_notebook(folder: Path, name: str, *cells: str) -> str:
    """Write a notebook with these code cells. Return its path in the student's copy."""
    code = [
        {
            "cell_type": "code",
            "id": f"c{n}",
            "metadata": {},
            "source": text,
            "outputs": [],
            "execution_count": None,
        }
        for n, text in enumerate(cells)
    ]
    kernel = {"name": "python3", "display_name": "rclpy workbook", "language": "python"}
    content = {"cells": code, "metadata": {"kernelspec": kernel}, "nbformat": 4, "nbformat_minor": 5}
    (folder / name).write_text(json.dumps(content), encoding="utf-8")
    return name
