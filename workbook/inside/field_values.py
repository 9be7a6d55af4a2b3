"""After an exception, find the message field that had a wrong value.

If a message's C code raises an exception, it doesn't name the field or the value. But both can be found in the local
variables of the traceback's frames.
"""

import re
import sys
from collections.abc import Iterator
from difflib import get_close_matches
from operator import index
from types import FrameType
from typing import Any

LONGEST_VALUE = 60
"""The maximum length of a quoted value, in characters. A longer one is cut."""
MOST_ELEMENTS = 2_000
RAISED_FOR_A_VALUE = (TypeError, ValueError, AttributeError, AssertionError, OverflowError, SystemError)
"""The types of exceptions that messages raise for a wrong value.

A wrong value in a float field doesn't raise an exception, so we report the other fields first.
"""
_MESSAGE_FILE = re.compile(r"/(?:msg|srv)/_\w+\.py$")
_MESSAGE_MODULE = re.compile(r"^\w+\.(?:msg|srv)\._\w+$")
_NO_FIELD = re.compile(r"^'(?P<message>\w+)' object has no attribute '(?P<name>\w+)'")
_RCLPY_FILE = re.compile(r"/rclpy/(?:publisher|client|service)\.py$")
_LIST = re.compile(r"^(?:sequence<(?P<inner>.+?)(?:, \d+)?>|(?P<of>.+)\[\d+\])$")
_INTEGER = re.compile(r"^(?P<unsigned>u?)int(?P<bits>\d+)$")
_TEXT = re.compile(r"^w?string(?:<\d+>)?$")


def note_of(error: BaseException) -> str:
    """Return a line that names the wrong value and the field to which it was assigned.

    Return an empty string if no field is the cause or if the field can't be found.
    """
    if not isinstance(error, RAISED_FOR_A_VALUE):
        return ""
    try:
        return _fields_there_are(error) or next(_misfits_of(error), "")
    except Exception:
        return ""


def _fields_there_are(error: BaseException) -> str:
    """Return a line that lists a message's fields if the program used a field that the message doesn't have.

    The most similar names come first. If the exception has a different cause, return an empty string.
    """
    asked = _NO_FIELD.match(str(error)) if isinstance(error, AttributeError) else None
    kinds = [] if asked is None else _kinds(asked["message"], getattr(error, "obj", None))
    if asked is None or len(kinds) != 1:
        return ""
    fields = kinds[0].get_fields_and_field_types()
    if asked["name"] in fields:
        return ""
    near = get_close_matches(asked["name"], fields, n=3, cutoff=0.5)
    names = ", ".join(dict.fromkeys([*near, *fields]))
    return f"The fields of {asked['message']} are: {names}"


def _kinds(name: str, owner: Any) -> list[Any]:
    """Return `owner`'s class if it's a message class.

    If `owner` is None, return all loaded message classes named `name`. Python's AttributeError contains the owner if
    the program read an attribute, but not if it set one. The name alone may be ambiguous, because rclpy also has a
    class Time, for example.
    """
    if owner is not None:
        return [type(owner)] if _fields(owner) else []
    modules = [module for path, module in list(sys.modules.items()) if _MESSAGE_MODULE.match(path)]
    return [
        kind for module in modules if hasattr(kind := vars(module).get(name), "get_fields_and_field_types")
    ]


def _misfits_of(error: BaseException) -> Iterator[str]:
    step = error.__traceback__
    while step is not None and step.tb_next is not None:
        file = step.tb_frame.f_code.co_filename
        if _MESSAGE_FILE.search(file) or _RCLPY_FILE.search(file):
            break
        step = step.tb_next
    if step is None:
        return
    frame = step.tb_frame
    if _RCLPY_FILE.search(frame.f_code.co_filename):
        sent = (frame.f_locals.get(name) for name in ("msg", "request", "response"))
        found = [line for message in sent for line in misfits(message)]
        yield from sorted(found, key=lambda line: " takes float," in line or " takes double," in line)
    elif _MESSAGE_FILE.search(frame.f_code.co_filename):
        yield from _given_to_a_message(frame)


def _given_to_a_message(frame: FrameType) -> Iterator[str]:
    """Yield a line for each wrong value that was passed to a message's constructor or to a field's setter."""
    local = frame.f_locals
    message = local.get("self")
    kinds = _fields(message)
    given = dict(local["kwargs"]) if "kwargs" in local else {}
    if "value" in local:
        given = {frame.f_code.co_name: local["value"]}
    for name, value in given.items():
        if name in kinds:
            yield from _misfit(type(message).__name__, name, kinds[name], value)


def misfits(message: Any, path: str = "") -> Iterator[str]:
    """Yield a line for each field of a message, and of the messages inside it, whose value has a wrong type."""
    for name, kind in _fields(message).items():
        yield from _misfit(type(message).__name__, f"{path}{name}", kind, getattr(message, name))


def _fields(message: Any) -> dict[str, str]:
    ask = getattr(type(message), "get_fields_and_field_types", None)
    return dict(ask()) if ask is not None else {}


def _misfit(message: str, name: str, kind: str, value: Any) -> Iterator[str]:
    inner = _LIST.match(kind)
    if inner is not None:
        yield from _misfit_of_list(message, name, kind, inner["inner"] or inner["of"], value)
    elif not _takes(kind, value):
        yield _line(message, name, kind, value)
    elif "/" in kind:
        yield from misfits(value, f"{name}.")


def _line(message: str, name: str, kind: str, value: Any) -> str:
    given = type(value)
    type_name = (
        given.__name__ if given.__module__ == "builtins" else f"{given.__module__}.{given.__qualname__}"
    )
    quoted = repr(value).replace("\n", " ")
    if len(quoted) > LONGEST_VALUE:
        quoted = f"{quoted[: LONGEST_VALUE - 1]}…"
    return f"The field '{name}' of {message} takes {kind}, and got {type_name}: {quoted}"


def _misfit_of_list(message: str, name: str, kind: str, inner: str, value: Any) -> Iterator[str]:
    try:
        elements = list(value)[:MOST_ELEMENTS]
    except TypeError:
        elements = None
    if elements is None or isinstance(value, (str, dict)):
        yield _line(message, name, kind, value)
        return
    for place, element in enumerate(elements):
        for line in _misfit(message, f"{name}[{place}]", inner, element):
            yield line
            return


def _takes(kind: str, value: Any) -> bool:
    integer = _INTEGER.match(kind)
    if integer is not None or kind in ("octet", "byte", "char"):
        bits, unsigned = (int(integer["bits"]), bool(integer["unsigned"])) if integer else (8, True)
        if kind in ("octet", "byte") and isinstance(value, bytes):
            return len(value) == 1
        low, high = (0, 1 << bits) if unsigned else (-(1 << bits - 1), 1 << bits - 1)
        try:
            return low <= index(value) < high
        except TypeError:
            return False
    if kind in ("float", "double"):
        return isinstance(value, float)
    if kind == "boolean":
        return isinstance(value, int)
    if _TEXT.match(kind):
        return isinstance(value, str)
    return type(value).__name__ == kind.rpartition("/")[2] and bool(_fields(value))
