"""Count the messages that a topic's publishers keep for late subscriptions (durability "transient local")."""

import time

from rclpy.node import Node
from rclpy.qos import DurabilityPolicy, QoSProfile

from workbook.watching.values import known_class
from workbook.watching.watched_topic import WatchedTopic

ARRIVES_WITHIN_S = 1.5
"""The longest wait (s) after the match. Kept messages arrive within milliseconds, except on a busy machine."""
MATCHED_WITHIN_S = 3.0
POLL_S = 0.01
DEPTH = 100


def is_to_be_kept(watched: WatchedTopic) -> bool:
    """Return whether messages arrived on a topic and one of its publishers offers to keep them."""
    promised = any(one.durability == "transient_local" for one in watched.publishers.values())
    return promised and bool(watched.came) and watched.subscribed_type is not None


def received_late(node: Node, watched: WatchedTopic) -> int | None:
    """Subscribe now, and count the arriving messages that were published earlier.

    Return None if only new messages arrive, or if the topic's type isn't installed.
    """
    message_type = known_class(watched.subscribed_type or "")
    if message_type is None:
        return None
    made = time.time()
    asked = QoSProfile(depth=DEPTH, durability=DurabilityPolicy.TRANSIENT_LOCAL)
    late = node.create_subscription(message_type, watched.name, lambda _: None, asked, raw=True)
    old = new = 0
    try:
        with late.handle:
            until, is_matched = time.monotonic() + MATCHED_WITHIN_S, False
            while not (old or new) and time.monotonic() < until:
                if not is_matched and late.get_publisher_count() > 0:
                    is_matched, until = True, time.monotonic() + ARRIVES_WITHIN_S
                time.sleep(POLL_S)
                while (taken := late.handle.take_message(message_type, True)) is not None:
                    published = taken[1]["source_timestamp"] / 1e9
                    old, new = old + (published <= made), new + (published > made)
    finally:
        node.destroy_subscription(late)
    return None if new and not old else old
