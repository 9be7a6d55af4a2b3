"""What the graph says of others: told apart from our own, and safe against names that are none.

A program may put any bytes on the graph as the name of a topic, a type or a node.
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
"""What rclpy raises for names that are no UTF-8 or break the rules of ROS."""
PREFIX_BYTES = 12
"""The part of a GID that all endpoints of one participant have in common."""
_NAMES_REMEMBERED = 10_000
Told = TypeVar("Told")


def own_prefix(node: Node) -> bytes:
    """How the GIDs of all endpoints begin that belong to the context of `node`.

    A name says nothing: others may take it. This is told from a subscription to a topic that nobody else can know.
    """
    while True:
        topic = f"/{node.get_name()}_{secrets.token_hex(16)}"
        subscription = node.create_subscription(Empty, topic, _never_called, 1)
        found = {gid_of(info)[:PREFIX_BYTES] for info in node.get_subscriptions_info_by_topic(topic)}
        node.destroy_subscription(subscription)
        if len(found) == 1:
            return found.pop()


def or_default(ask: Callable[[], Told], otherwise: Told) -> Told:
    """What the graph answers; `otherwise` where a name in the answer is none."""
    try:
        return ask()
    except NO_NAME:
        return otherwise


@lru_cache(_NAMES_REMEMBERED)
def is_name(full: str) -> bool:
    """Whether this can be the full name of a topic or a node."""
    try:
        validate_full_topic_name(full)
    except NO_NAME:
        return False
    return True


def _never_called(message: object) -> None:
    """Nobody sends to this topic."""
