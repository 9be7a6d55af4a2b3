"""Convert ROS messages to plain data, and type names to message classes."""

import hashlib
from collections.abc import Mapping
from typing import Any

from workbook.recording.plan import Feature
from workbook.ros.messages import message_class

LONGEST_ARRAY = 4096
LONGEST_TEXT = 4096
FIRST_OF_ARRAY = 64
"""The number of elements that are kept of a longer array. Of a longer string, `LONGEST_TEXT` characters are kept."""
BYTES_PER_VALUE = 8


def known_class(name: str) -> Any | None:
    """Return the class of a message type such as "std_msgs/msg/String", or None if it's invalid or not installed."""
    try:
        return message_class(name)
    except (ValueError, LookupError):
        return None


def plain(value: Any) -> Any:
    """Convert a message or a field to dicts, lists, numbers, and strings.

    Arrays and strings longer than 4096 elements are cut to `{"length": n, "sha256": "...", "first": [...]}`. An array's
    hash covers its bytes in memory, and a string's hash its UTF-8 bytes. An array of messages doesn't get a hash.
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
    if hasattr(value, "tobytes"):  # an array.array, or a NumPy array
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


def with_features(data: Any, message: Any, features: Mapping[str, Feature]) -> Any:
    """Add the features that the exercise computes from a message to the message's plain data, and return the data.

    A *feature* is a value that an exercise computes from a large field while the whole message is available. A field
    with features becomes `{"length": n, "first": [...], "features": ...}`, with a hash if the field is long. The
    features are None if they're too large, or if the exercise's function raises an exception, because messages are
    untrusted.
    """
    for name, feature in features.items():
        if name in data:
            field = data[name]
            whole = field if isinstance(field, dict) and "first" in field else _cut(len(field), field, None)
            data[name] = {**whole, "features": _features(message, feature)}
    return data


def _features(message: Any, feature: Feature) -> Any:
    try:
        told = _data_only(feature(message))
        return told if bytes_kept(told) <= BYTES_PER_VALUE * LONGEST_ARRAY else None
    except Exception:
        return None


def _data_only(told: Any) -> Any:
    """Convert a function's result to plain data. NumPy values are allowed; any other value raises TypeError."""
    if told is None or isinstance(told, (bool, int, float, str)):
        return told
    if isinstance(told, Mapping):
        return {str(name): _data_only(value) for name, value in told.items()}
    if isinstance(told, (list, tuple)):
        return [_data_only(value) for value in told]
    if hasattr(told, "tolist"):  # a NumPy value
        return _data_only(told.tolist())
    raise TypeError(f"{type(told).__name__} cannot be kept")


def bytes_kept(data: Any) -> int:
    """Estimate the number of bytes that plain data would take up in a message."""
    if isinstance(data, dict):
        return sum(map(bytes_kept, data.values()))
    if isinstance(data, list):
        if data and not isinstance(data[0], (dict, list, str)):
            return BYTES_PER_VALUE * len(data)
        return sum(map(bytes_kept, data))
    return len(data) if isinstance(data, str) else BYTES_PER_VALUE
