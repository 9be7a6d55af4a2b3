"""Tells the panel beside the notebook what this process publishes, while such a panel is open.

The panel must not subscribe: lessons count subscriptions, wait for them, and lose messages that are published before.
So each process of a notebook reports its own messages on an abstract Unix socket that is named after the ROS domain.
Without a panel nobody listens there, and a message costs a look at the clock.
"""

import json
import socket
import time
from functools import wraps
from typing import Any

ADDRESS = "\0rclpy-workbook/panel/{}"
FORGOTTEN = ("/rosout", "/parameter_events")
LOOK_EVERY_S = 0.5
"""Whether a panel listens."""
AT_ONCE, PER_SECOND = 50, 25
"""Messages of a publisher that are reported whole: so many in a row, then so many a second. All are counted."""
LONGEST = 100_000
"""Bytes of a message that is reported whole; of a longer one only the fact."""


class _Publisher:
    """What is kept of a publisher."""

    def __init__(self, topic: str, type_name: str) -> None:
        self.topic = topic
        self.type_name = type_name
        self.unreported = 0
        self.allowance = float(AT_ONCE)
        self.counted_at = 0.0

    def may_report(self, now: float) -> bool:
        """Whether this message is reported, or only counted."""
        self.unreported += 1
        self.allowance = min(AT_ONCE, self.allowance + PER_SECOND * (now - self.counted_at))
        self.counted_at = now
        return self.allowance >= 1.0


class Tap:
    """Reports the messages of this process to the panel of a ROS domain."""

    def __init__(self, domain_id: int) -> None:
        self.address = ADDRESS.format(domain_id)
        self._socket: socket.socket | None = None
        self._looked = -LOOK_EVERY_S

    def published(self, publisher: Any, message: Any) -> None:
        """Report a message. Whatever goes wrong here is no concern of the program."""
        try:
            now = time.monotonic()
            kept = publisher.__dict__.get("_workbook_tap") or _known(publisher)
            # A node's own events come first: after a look for them in vain, the next message would wait for a panel.
            if kept.topic not in FORGOTTEN and self._listens(now):
                self._report(kept, message, now)
        except Exception:
            self._socket = None

    def _listens(self, now: float) -> bool:
        if self._socket is None and now - self._looked >= LOOK_EVERY_S:
            self._looked = now
            wire = socket.socket(socket.AF_UNIX, socket.SOCK_DGRAM | socket.SOCK_NONBLOCK)
            try:
                wire.connect(self.address)
            except OSError:
                wire.close()
            else:
                self._socket = wire
        return self._socket is not None

    def _report(self, kept: _Publisher, message: Any, now: float) -> None:
        if not kept.may_report(now):
            return
        kept.allowance -= 1.0
        data = message if isinstance(message, bytes) else _serialized(message)
        head = json.dumps([kept.topic, kept.type_name, kept.unreported, now, len(data)]).encode()
        try:
            assert self._socket is not None
            self._socket.send(head + b"\n" + (data if len(data) <= LONGEST else b""))
        except BlockingIOError:  # the panel is busy: it hears of this one with the next
            return
        kept.unreported = 0


def _known(publisher: Any) -> _Publisher:
    kind = publisher.msg_type
    type_name = f"{kind.__module__.split('.')[0]}/msg/{kind.__name__}"
    kept = publisher.__dict__["_workbook_tap"] = _Publisher(publisher.topic_name, type_name)
    return kept


def _serialized(message: Any) -> bytes:
    from rclpy.serialization import serialize_message

    return bytes(serialize_message(message))


def install(domain_id: int) -> None:
    """From now on, report what this process publishes on `domain_id`. A second call changes the domain."""
    from rclpy.publisher import Publisher

    tap = Tap(domain_id)
    original = getattr(Publisher.publish, "__wrapped__", Publisher.publish)

    @wraps(original)
    def publish(self: Any, msg: Any) -> None:
        __tracebackhide__ = True
        original(self, msg)
        tap.published(self, msg)

    Publisher.publish = publish  # type: ignore[method-assign]
