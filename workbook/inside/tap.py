"""Report this process's messages and responses to the panel next to the notebook while the panel is open.

The panel must not subscribe to topics, because its subscriptions would disturb some lessons. These lessons count
subscriptions, wait for them, or show that earlier messages are lost. Instead, each of a notebook's processes reports
its own messages on an abstract Unix socket whose name contains the ROS domain. If no panel listens there, each message
costs only a check of the clock.
"""

import json
import socket
import time
from functools import wraps
from typing import Any

ADDRESS = "\0rclpy-workbook/panel/{}"
FORGOTTEN = ("/rosout", "/parameter_events")
OF_EACH_NODE = ("rcl_interfaces/", "type_description_interfaces/")
"""The beginnings of the type names of services that every node offers."""
LOOK_EVERY_S = 0.5
"""The time (s) between two checks whether a panel is listening."""
AT_ONCE, PER_SECOND = 50, 25
"""The maximum number of a publisher's messages to report, in a burst and then per second. All messages are counted."""
LONGEST = 100_000
"""The maximum size (bytes) of a message whose content is reported.

For a larger one, the report contains only the size.
"""


class _Publisher:
    """What the tap stores about one publisher or service."""

    def __init__(self, topic: str, type_name: str) -> None:
        self.topic = topic
        self.type_name = type_name
        self.unreported = 0
        self.allowance = float(AT_ONCE)
        self.counted_at = 0.0

    def may_report(self, now: float) -> bool:
        """Count a message sent at `now` (`time.monotonic`, s), and return whether it may be reported."""
        self.unreported += 1
        self.allowance = min(AT_ONCE, self.allowance + PER_SECOND * (now - self.counted_at))
        self.counted_at = now
        return self.allowance >= 1.0


class Tap:
    """Reports messages and responses from this process to the panel for a ROS domain."""

    def __init__(self, domain_id: int) -> None:
        self.address = ADDRESS.format(domain_id)
        self._socket: socket.socket | None = None
        self._looked = -LOOK_EVERY_S

    def published(self, publisher: Any, message: Any) -> None:
        """Report a published message.

        Suppress all exceptions, so that an error in the tap doesn't affect the program.
        """
        try:
            now = time.monotonic()
            kept = publisher.__dict__.get("_workbook_tap") or _known_publisher(publisher)
            # Check the topic first. Otherwise, a failed check for one of the node's own events would delay the next
            # check, and the next message wouldn't be reported.
            if kept.topic not in FORGOTTEN and self._listens(now):
                self._report(kept, message, now)
        except Exception:
            self._socket = None

    def responded(self, service: Any, response: Any) -> None:
        """Report a service's response as if it were a message on a topic with the service's name."""
        try:
            now = time.monotonic()
            kept = service.__dict__.get("_workbook_tap") or _known_service(service)
            if not kept.type_name.startswith(OF_EACH_NODE) and self._listens(now):
                self._report(kept, response, now)
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
        except BlockingIOError:  # the panel is busy, so the next report counts this message, too
            return
        kept.unreported = 0


def _known_publisher(publisher: Any) -> _Publisher:
    return _known(publisher, publisher.topic_name, publisher.msg_type, "msg")


def _known_service(service: Any) -> _Publisher:
    return _known(service, service.service_name, service.srv_type, "srv")


def _known(source: Any, name: str, kind: type, folder: str) -> _Publisher:
    type_name = f"{kind.__module__.split('.')[0]}/{folder}/{kind.__name__}"
    kept = source.__dict__["_workbook_tap"] = _Publisher(name, type_name)
    return kept


def _serialized(message: Any) -> bytes:
    from rclpy.serialization import serialize_message

    return bytes(serialize_message(message))


def install(domain_id: int) -> None:
    """Report this process's messages on `domain_id` from now on. A second call changes the domain."""
    from rclpy.publisher import Publisher
    from rclpy.service import Service

    tap = Tap(domain_id)
    original = getattr(Publisher.publish, "__wrapped__", Publisher.publish)
    original_response = getattr(Service.send_response, "__wrapped__", Service.send_response)

    @wraps(original)
    def publish(self: Any, msg: Any) -> None:
        __tracebackhide__ = True
        original(self, msg)
        tap.published(self, msg)

    @wraps(original_response)
    def send_response(self: Any, response: Any, header: Any) -> None:
        __tracebackhide__ = True
        original_response(self, response, header)
        tap.responded(self, response)

    Publisher.publish = publish  # type: ignore[method-assign]
    Service.send_response = send_response  # type: ignore[method-assign]
