"""Query the graph for other programs' endpoints. Skip our own endpoints, and tolerate invalid names.

A program may put any bytes into the graph as the name of a topic, type, or node, so names are untrusted.
"""

import secrets
from collections.abc import Callable
from functools import lru_cache
from typing import TypeVar

from rclpy.exceptions import NameValidationException
from rclpy.node import Node
from rclpy.validate_full_topic_name import validate_full_topic_name
from std_msgs.msg import Empty

from workbook.watching.watched_topic import gid_of

NO_NAME = (ValueError, TypeError, NameValidationException)
"""The exceptions that rclpy raises for names that aren't UTF-8 or break the ROS naming rules."""
PREFIX_BYTES = 12
"""The length of a GID's first part, which is the same for all endpoints of one DDS participant."""
_NAMES_REMEMBERED = 10_000
Found = TypeVar("Found")


def own_prefix(node: Node) -> bytes:
    """Return the GID prefix of all endpoints in the context of `node`.

    Names don't identify our endpoints, because other programs may use the same names. So we subscribe to a topic with a
    secret name, and read the prefix from that subscription.
    """
    while True:
        topic = f"/{node.get_name()}_{secrets.token_hex(16)}"
        subscription = node.create_subscription(Empty, topic, _never_called, 1)
        found = {gid_of(info)[:PREFIX_BYTES] for info in node.get_subscriptions_info_by_topic(topic)}
        node.destroy_subscription(subscription)
        if len(found) == 1:
            return found.pop()


def or_default(ask: Callable[[], Found], otherwise: Found) -> Found:
    """Query the graph with `ask`, and return the result, or `otherwise` if the result contains an invalid name."""
    try:
        return ask()
    except NO_NAME:
        return otherwise


@lru_cache(_NAMES_REMEMBERED)
def is_name(full: str) -> bool:
    """Return whether `full` is a valid fully qualified name of a topic or a node."""
    try:
        validate_full_topic_name(full)
    except NO_NAME:
        return False
    return True


def _never_called(message: object) -> None:
    """Ignore a message. No program publishes on this topic."""
