"""From ROS messages to plain data, and from type names to message classes."""

import array
from typing import Any

from workbook.ros.messages import message_class

LONGEST_ARRAY = 4096
LONGEST_TEXT = 4096


def known_class(name: str) -> Any | None:
    """The class of a message type such as "std_msgs/msg/String"; None if it is not installed here."""
    try:
        return message_class(name)
    except (ValueError, LookupError):
        return None


def plain(value: Any) -> Any:
    """A message (or a field) as dicts, lists, numbers and text.

    Arrays and texts longer than 4096 elements are cut and become `{"length": n, "first": [...]}`.
    """
    if isinstance(value, (bool, int, float)):
        return value
    if isinstance(value, str):
        return value if len(value) <= LONGEST_TEXT else {"length": len(value), "first": value[:LONGEST_TEXT]}
    if hasattr(value, "get_fields_and_field_types"):
        return {name: plain(getattr(value, name)) for name in value.get_fields_and_field_types()}
    if isinstance(value, array.array):
        return _cut(len(value), value[:LONGEST_ARRAY].tolist())
    if isinstance(value, (bytes, bytearray)):
        return _cut(len(value), list(value[:LONGEST_ARRAY]))
    if hasattr(value, "dtype"):
        flat = value.reshape(-1)
        return _cut(int(flat.size), flat[:LONGEST_ARRAY].tolist())
    return _cut(len(value), [plain(item) for item in value[:LONGEST_ARRAY]])


def _cut(length: int, first: list[Any]) -> Any:
    return first if length <= LONGEST_ARRAY else {"length": length, "first": first}
