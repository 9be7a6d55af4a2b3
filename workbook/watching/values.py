"""From ROS messages to plain data, and from type names to message classes."""

import hashlib
from typing import Any

from workbook.ros.messages import message_class

LONGEST_ARRAY = 4096
LONGEST_TEXT = 4096
FIRST_OF_ARRAY = 64
"""How much is kept of a longer array. Of a longer text, it is `LONGEST_TEXT`: people read it."""
BYTES_PER_VALUE = 8


def known_class(name: str) -> Any | None:
    """The class of a message type such as "std_msgs/msg/String"; None if it is not installed here."""
    try:
        return message_class(name)
    except (ValueError, LookupError):
        return None


def plain(value: Any) -> Any:
    """A message (or a field) as dicts, lists, numbers and text.

    Arrays and texts longer than 4096 elements are cut and become `{"length": n, "sha256": "...", "first": [...]}`. The
    hash is that of the bytes in memory, of a text in UTF-8. An array of messages has none.
    """
    if isinstance(value, (bool, int, float)):
        return value
    if isinstance(value, str):
        return (
            value
            if len(value) <= LONGEST_TEXT
            else _cut(len(value), value[:LONGEST_TEXT], value.encode(errors="surrogatepass"))
        )
    if hasattr(value, "get_fields_and_field_types"):
        return {name: plain(getattr(value, name)) for name in value.get_fields_and_field_types()}
    if hasattr(value, "dtype"):
        value = value.reshape(-1)
    kept = value[: LONGEST_ARRAY if len(value) <= LONGEST_ARRAY else FIRST_OF_ARRAY]
    if hasattr(value, "tobytes"):  # of the module array, or of NumPy
        first, whole = kept.tolist(), value.tobytes
    elif isinstance(value, (bytes, bytearray)):
        first, whole = list(kept), lambda: value
    else:
        first, whole = [plain(item) for item in kept], None
    return (
        first if len(value) <= LONGEST_ARRAY else _cut(len(value), first, None if whole is None else whole())
    )


def _cut(length: int, first: Any, whole: bytes | None) -> dict[str, Any]:
    sha256 = {} if whole is None else {"sha256": hashlib.sha256(whole).hexdigest()}
    return {"length": length, **sha256, "first": first}


def bytes_kept(data: Any) -> int:
    """About how many bytes plain data take, as a program would send them."""
    if isinstance(data, dict):
        return sum(map(bytes_kept, data.values()))
    if isinstance(data, list):
        if data and not isinstance(data[0], (dict, list, str)):
            return BYTES_PER_VALUE * len(data)
        return sum(map(bytes_kept, data))
    return len(data) if isinstance(data, str) else BYTES_PER_VALUE
