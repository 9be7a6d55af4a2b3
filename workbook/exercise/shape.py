"""Whether plain data has the shape that its class declares: for what comes back from another machine."""

import math
import types
from collections.abc import Mapping
from dataclasses import is_dataclass
from functools import cache
from typing import Any, Literal, Union, get_args, get_origin, get_type_hints


class Misshapen(ValueError):
    """A value is not what its class declares. The message says which one and what it is."""


@cache
def _fields(kind: type) -> dict[str, Any]:
    return get_type_hints(kind)


def check_shape(value: object, kind: Any, where: str) -> None:
    """Compare `value` with the type `kind`, and all that is in it. Numbers must be finite, text must be writable.

    What is declared as `Any` is not looked at. Raises Misshapen; `where` is what it calls the value.
    """
    if is_dataclass(kind):
        if type(value) is not kind:
            raise _misshapen(value, kind, where)
        for name, part in _fields(kind).items():
            check_shape(getattr(value, name), part, f"{where}.{name}")
    elif kind in (str, int, float, bool, types.NoneType):
        _check_plain(value, kind, where)
    elif get_origin(kind) is Literal:
        if not (isinstance(value, str) and value in get_args(kind)):
            raise _misshapen(value, kind, where)
    elif get_origin(kind) in (Union, types.UnionType):
        [other] = (one for one in get_args(kind) if one is not types.NoneType)
        if value is not None:
            check_shape(value, other, where)
    elif get_origin(kind) is tuple:
        _check_tuple(value, get_args(kind), where)
    elif get_origin(kind) is Mapping:
        if not isinstance(value, dict):
            raise _misshapen(value, kind, where)
        for key, item in value.items():
            check_shape(key, get_args(kind)[0], f"a key of {where}")
            check_shape(item, get_args(kind)[1], f"{where}[{key!r:.40}]")
    elif kind is not Any:
        raise TypeError(f"{where}: no check for {kind}")


def _check_plain(value: object, kind: type, where: str) -> None:
    if kind is float:
        fits = isinstance(value, (int, float)) and not isinstance(value, bool) and math.isfinite(value)
    elif kind is int:
        fits = isinstance(value, int) and not isinstance(value, bool)
    elif kind is str:
        fits = isinstance(value, str) and _is_writable(value)
    else:
        fits = isinstance(value, kind)
    if not fits:
        raise _misshapen(value, kind, where)


def _is_writable(text: str) -> bool:
    """Half a character (a lone surrogate) can come through JSON, and no file can hold it."""
    try:
        text.encode()
    except UnicodeEncodeError:
        return False
    return True


def _check_tuple(value: object, kinds: tuple[Any, ...], where: str) -> None:
    if not isinstance(value, tuple):
        raise _misshapen(value, "a sequence", where)
    if len(kinds) == 2 and kinds[1] is Ellipsis:
        kinds = (kinds[0],) * len(value)
    if len(value) != len(kinds):
        raise Misshapen(f"{where} holds {len(value)} values and not {len(kinds)}")
    for number, (item, kind) in enumerate(zip(value, kinds, strict=True)):
        check_shape(item, kind, f"{where}[{number}]")


def _misshapen(value: object, kind: object, where: str) -> Misshapen:
    wanted = kind.__name__ if isinstance(kind, type) else str(kind)
    return Misshapen(f"{where} is {value!r:.60} and not {wanted}")
