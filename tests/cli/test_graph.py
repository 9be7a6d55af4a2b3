"""What a command prints about a topic without publishers. `tests/ros/test_ros_tools.py` tests the other cases."""

import argparse

import pytest

from workbook.cli import graph


@pytest.mark.parametrize(
    ("topic", "meant"),
    [
        ("/robot/statu", "Did you mean /robot/status? "),
        ("status", "Did you mean /robot/status? "),
        ("/robot/battery", ""),
        ("/xyz", ""),
    ],
)
def test_a_topic_that_nobody_publishes_is_told_with_what_is_near(
    topic: str, meant: str, capsys: pytest.CaptureFixture[str]
) -> None:
    graph._say_who_is_there(argparse.Namespace(topic=topic))(["/robot/joints", "/robot/status"])
    said = " ".join(capsys.readouterr().err.split())
    assert said == (
        f"No node publishes /{topic.strip('/')}. {meant}Topics with a publisher: /robot/joints, /robot/status. "
        "Waiting for a publisher. Press Ctrl-C to stop."
    )


def test_where_nothing_is_published_it_asks_for_a_node(capsys: pytest.CaptureFixture[str]) -> None:
    graph._say_who_is_there(argparse.Namespace(topic="/robot/status"))([])
    said = " ".join(capsys.readouterr().err.split())
    assert "No topic has a publisher. Is a node running?" in said
