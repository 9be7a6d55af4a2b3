"""Convert message and service classes to their ROS type names."""

from typing import Any


def type_name(message_class: Any) -> str:
    """Return the ROS type name of a message or service class, e.g. "std_msgs/msg/String"."""
    package, kind = message_class.__module__.split(".")[:2]
    return f"{package}/{kind}/{message_class.__name__}"
