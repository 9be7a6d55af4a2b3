"""Convert JSON data to frozen dataclasses, guided by their type hints. See `codec` for the rules."""

import math
import types
from collections.abc import Mapping
from dataclasses import MISSING, is_dataclass
from functools import cache
from typing import Any, Literal, NoReturn, TypeVar, Union, cast, get_args, get_origin

from workbook.recording.stored_fields import (
    Converter,
    Malformed,
    fields_not_stored,
    name_of_unknown,
    optional,
    quoted,
    stored_fields,
)

Decoded = TypeVar("Decoded")
FORMER_WORDS = {"bench": "judge"}
"""Maps literals that earlier versions wrote to the literals that replaced them."""
_NON_FINITE = {"nan": math.nan, "inf": math.inf, "-inf": -math.inf}


def decode(kind: type[Decoded], data: object) -> Decoded:
    """Convert data that `encode` returned back to an object of the class `kind`.

    Raise Malformed, which is a ValueError, if the data doesn't fit the class.
    """
    hint: Any = kind
    return cast(Decoded, _decoder(hint)(data))


@cache
def _decoder(hint: Any) -> Converter:
    if hint is Any:
        return _decode_any
    if hint in (str, int, float, bool, types.NoneType):
        return _DECODERS[hint]
    if get_origin(hint) is Literal:
        return _literal_decoder(get_args(hint))
    if get_origin(hint) in (Union, types.UnionType):
        inner = _decoder(optional(hint))
        return lambda data: None if data is None else inner(data)
    if get_origin(hint) is tuple:
        return _tuple_decoder(get_args(hint))
    if get_origin(hint) is Mapping:
        return _mapping_decoder(_decoder(get_args(hint)[1]))
    if is_dataclass(hint) and isinstance(hint, type):
        return _object_decoder(hint)
    raise TypeError(f"no conversion for {hint}")


def _refuse(data: object, wanted: str) -> NoReturn:
    raise Malformed(f"{quoted(data)} is not {wanted}")


def _decode_any(data: Any) -> Any:
    kind = type(data)
    if kind is list:
        if _CONTAINERS.isdisjoint(map(type, data)):  # a fast path for long arrays of numbers
            return data.copy()
        return [_decode_any(item) for item in data]
    if kind is dict:
        if len(data) == 1 and "float" in data:
            spelled = data["float"]
            if type(spelled) is str and spelled in _NON_FINITE:
                return _NON_FINITE[spelled]
        return {key: _decode_any(item) if type(item) in _CONTAINERS else item for key, item in data.items()}
    return data


_CONTAINERS = frozenset([dict, list])


def _decode_float(data: Any) -> float:
    if (type(data) is float and data - data == 0.0) or type(data) is int:  # infinity - infinity is NaN
        return cast(float, data)
    _refuse(data, "a finite number")


def _decode_str(data: Any) -> str:
    if type(data) is not str:
        _refuse(data, "text")
    if not data.isascii():
        try:
            data.encode()
        except UnicodeEncodeError:
            # JSON can contain half a character (a lone surrogate), but a string that contains one can't be written to a
            # file.
            raise Malformed(f"{quoted(data)} holds half a character") from None
    return data


def _exactly(kind: type, words: str) -> Converter:
    def checked(data: Any) -> Any:
        if type(data) is not kind:
            _refuse(data, words)
        return data

    return checked


_DECODERS: Mapping[Any, Converter] = {
    str: _decode_str,
    float: _decode_float,
    int: _exactly(int, "a whole number"),
    bool: _exactly(bool, "true or false"),
    types.NoneType: _exactly(types.NoneType, "null"),
}


def _literal_decoder(choices: tuple[Any, ...]) -> Converter:
    def checked(data: Any) -> Any:
        if type(data) is str and data not in choices:
            data = FORMER_WORDS.get(data, data)
        if not any(type(data) is type(one) and data == one for one in choices):
            _refuse(data, " or ".join(map(repr, choices)))
        return data

    return checked


def _tuple_decoder(hints: tuple[Any, ...]) -> Converter:
    repeated = len(hints) == 2 and hints[1] is Ellipsis
    converters = [_decoder(hint) for hint in (hints[:1] if repeated else hints)]

    def of_list(data: Any) -> tuple[Any, ...]:
        if type(data) is not list:
            _refuse(data, "a list")
        if not repeated and len(data) != len(converters):
            raise Malformed(f"it holds {len(data)} values and not {len(converters)}")
        items: list[Any] = []
        try:
            if repeated:
                convert = converters[0]
                for item in data:
                    items.append(convert(item))
            else:
                for convert, item in zip(converters, data, strict=True):
                    items.append(convert(item))
        except Malformed as error:
            raise error.below(f"[{len(items)}]") from None
        return tuple(items)

    return of_list


def _mapping_decoder(convert: Converter) -> Converter:
    def of_dict(data: Any) -> dict[str, Any]:
        if type(data) is not dict:
            _refuse(data, "an object")
        found = {}
        for key, item in data.items():
            try:
                found[_decode_str(key)] = convert(item)
            except Malformed as error:
                raise error.below(f"[{quoted(key)}]") from None
        return found

    return of_dict


def _object_decoder(kind: type) -> Converter:
    parts = stored_fields(kind, _decoder)
    known = frozenset(part.key for part in parts)
    unknown = name_of_unknown(kind)
    drops_unknown = getattr(kind, "ignores_unknown_fields", False)
    not_stored = fields_not_stored(kind)
    if hasattr(kind, "__post_init__") or hasattr(kind, "__slots__"):
        raise TypeError(f"no conversion for {kind}: it has slots, or a __post_init__")
    put = object.__setattr__  # the class is frozen

    def of_dict(data: Any) -> Any:
        if type(data) is not dict:
            _refuse(data, f"an object ({kind.__name__})")
        made: Any = object.__new__(kind)
        absent = 0
        key = ""
        try:
            for name, key, as_is, is_float, convert, default in parts:
                item = data.get(key, MISSING)
                given = type(item)
                if given in as_is or (is_float and given is float and item - item == 0.0):  # finite
                    put(made, name, item)
                elif item is not MISSING:
                    put(made, name, convert(item))
                elif default is not None:
                    put(made, name, default())
                    absent += 1
                else:
                    raise Malformed("it is missing")
        except Malformed as error:
            raise error.below(f".{key}") from None
        for name, default in not_stored:
            put(made, name, default())
        if len(parts) - absent != len(data) and not drops_unknown:
            more = {key: item for key, item in data.items() if key not in known}
            if unknown is None:
                raise Malformed(f"{kind.__name__} has no such field", str(next(iter(more))))
            put(made, unknown, more)
        return made

    return of_dict
