"""Message classes by name."""

import importlib
from typing import Any


def message_class(type_name: str) -> Any:
    """The class of a message type such as "std_msgs/msg/String".

    Raises ValueError for a name of another form, LookupError when the type is not installed.
    """
    parts = type_name.split("/")
    if len(parts) != 3 or not all(part.isidentifier() for part in parts) or parts[1] != "msg":
        raise ValueError(f"{type_name!r} is not a message type; one looks like std_msgs/msg/String")
    try:
        return getattr(importlib.import_module(f"{parts[0]}.msg"), parts[2])
    except (ImportError, AttributeError):
        raise LookupError(f"the message type {type_name} is not installed here") from None
