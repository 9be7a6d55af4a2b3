"""The names of message and service types."""

from typing import Any


def type_name(message_class: Any) -> str:
    """The ROS name of a message class, e.g. "std_msgs/msg/String"."""
    package, kind = message_class.__module__.split(".")[:2]
    return f"{package}/{kind}/{message_class.__name__}"
