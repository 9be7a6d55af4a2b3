"""Find message and service classes by name."""

import importlib
from typing import Any


def message_class(type_name: str) -> Any:
    """Return the class of a message type such as "std_msgs/msg/String".

    Raise ValueError if the name isn't of this form, and LookupError if the type isn't installed.
    """
    return _interface(type_name, "msg", "a message type; one looks like std_msgs/msg/String")


def service_class(type_name: str) -> Any:
    """Return the class of a service type such as "std_srvs/srv/Trigger". Raise the same errors as `message_class`."""
    return _interface(type_name, "srv", "a service type; one looks like std_srvs/srv/Trigger")


def _interface(type_name: str, kind: str, what: str) -> Any:
    parts = type_name.split("/")
    if len(parts) != 3 or not all(part.isidentifier() for part in parts) or parts[1] != kind:
        raise ValueError(f"{type_name!r} is not {what}")
    try:
        return getattr(importlib.import_module(f"{parts[0]}.{kind}"), parts[2])
    except (ImportError, AttributeError):
        words = {"msg": "message", "srv": "service"}[kind]
        raise LookupError(f"the {words} type {type_name} is not installed here") from None
