"""Convert frozen dataclasses to JSON data, guided by their type hints. See `codec` for the rules."""

import math
import types
from collections.abc import Mapping
from dataclasses import is_dataclass
from functools import cache
from typing import Any, Literal, Union, get_args, get_origin

from workbook.recording.stored_fields import (
    Converter,
    Malformed,
    keys_stored_if_set,
    name_of_unknown,
    optional,
    quoted,
    stored_fields,
)


def encode(value: Any) -> Any:
    """Convert a dataclass object to data for `json`. Raise Malformed if JSON can't represent a value in it."""
    kind: Any = type(value)
    return _encoder(kind)(value)


@cache
def _encoder(hint: Any) -> Converter:
    if hint is Any:
        return _encode_any
    if hint is float:
        return _finite
    if hint in (str, int, bool, types.NoneType) or get_origin(hint) is Literal:
        return _unchanged
    if get_origin(hint) in (Union, types.UnionType):
        inner = _encoder(optional(hint))
        return lambda value: None if value is None else inner(value)
    if get_origin(hint) is tuple:
        return _tuple_encoder(get_args(hint))
    if get_origin(hint) is Mapping:
        of_item = _encoder(get_args(hint)[1])
        return lambda value: {str(key): of_item(item) for key, item in value.items()}
    if is_dataclass(hint) and isinstance(hint, type):
        return _object_encoder(hint)
    raise TypeError(f"no conversion for {hint}")


def _unchanged(value: Any) -> Any:
    return value


def _finite(value: Any) -> Any:
    if not math.isfinite(value):
        raise Malformed(f"{value} is not a finite number")
    return value


def _encode_any(value: Any) -> Any:
    kind = type(value)
    if kind is float:
        return value if math.isfinite(value) else {"float": str(value)}
    if kind is str or kind is int or kind is bool or value is None:
        return value
    if kind is dict:
        return {str(key): _encode_any(item) for key, item in value.items()}
    if kind is list or kind is tuple:
        return [_encode_any(item) for item in value]
    return _encode_rare(value)


def _encode_rare(value: Any) -> Any:
    """Encode a value whose exact type `_encode_any` doesn't handle, such as an enum member or a dataclass."""
    if isinstance(value, float):
        return value if math.isfinite(value) else {"float": str(value)}
    if isinstance(value, (str, int)):
        return value
    if isinstance(value, Mapping):
        return {str(key): _encode_any(item) for key, item in value.items()}
    if isinstance(value, (list, tuple)):
        return [_encode_any(item) for item in value]
    if is_dataclass(value):
        return encode(value)
    raise Malformed(f"{quoted(value)} cannot be stored")


def _tuple_encoder(hints: tuple[Any, ...]) -> Converter:
    if len(hints) == 2 and hints[1] is Ellipsis:
        of_item = _encoder(hints[0])
        return lambda value: [of_item(item) for item in value]
    of_items = [_encoder(hint) for hint in hints]
    return lambda value: [convert(item) for convert, item in zip(of_items, value, strict=True)]


def _object_encoder(kind: type) -> Converter:
    parts = stored_fields(kind, _encoder)
    unknown, if_set = name_of_unknown(kind), keys_stored_if_set(kind)

    def of_object(value: Any) -> dict[str, Any]:
        values = value.__dict__
        data: dict[str, Any] = {}
        key = ""
        try:
            for name, key, as_is, is_float, convert, _ in parts:
                item = values[name]
                given = type(item)
                if given in as_is or (is_float and given is float and item - item == 0.0):  # finite
                    data[key] = item
                else:
                    data[key] = convert(item)
        except Malformed as error:
            raise error.below(f".{key}") from None
        for key in if_set:
            if not data[key]:
                del data[key]
        if unknown is not None:
            data.update(values[unknown])
        return data

    return of_object
