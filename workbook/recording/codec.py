"""Convert frozen dataclasses, such as recordings, judgments, and results, to JSON data and back.

The type hints of a class determine how its fields are converted.

The supported hints are `str`, `int`, `float`, `bool`, `None`, `Any`, `Literal`, `X | None`, `tuple`, `Mapping[str, X]`,
and dataclasses. Every field is stored under its own name unless its metadata say otherwise (`stored_as`, `NOT_STORED`,
`STORED_IF_SET`). A field with a default may be missing from data that an older version wrote, unless its metadata are
`ALWAYS_STORED`. Decoding raises Malformed if the data contains unknown fields. A class can instead keep such fields in
a mapping (`UNKNOWN_FIELDS`), or drop them with `ignores_unknown_fields: ClassVar[bool] = True`.

Only fields declared as `Any` may contain infinite numbers or NaN. They're stored in the form `{"float": "nan"}`.
"""

import math
import types
from collections.abc import Callable, Mapping
from dataclasses import MISSING, Field, fields, is_dataclass
from functools import cache
from typing import Any, Literal, NoReturn, TypeVar, Union, cast, get_args, get_origin, get_type_hints

Decoded = TypeVar("Decoded")
Converter = Callable[[Any], Any]

ALWAYS_STORED: Mapping[str, Any] = {"always stored": True}
"""Metadata of a field that has a default for constructor calls, but that stored data must contain."""
NOT_STORED: Mapping[str, Any] = {"not stored": True}
STORED_IF_SET: Mapping[str, Any] = {"stored if set": True}
"""Metadata of a field that is left out of the data if it's empty. Use it for fields that usually are."""
UNKNOWN_FIELDS: Mapping[str, Any] = {"unknown fields": True}
"""Metadata of a mapping that keeps unknown fields.

So when data from a newer version is read and written again, those fields aren't lost.
"""

_LONGEST_QUOTATION = 60


def stored_as(name: str) -> Mapping[str, Any]:
    """Return metadata for a field that has another name in JSON."""
    return {"stored as": name}


class Malformed(ValueError):
    """Raised when data doesn't fit its type.

    `path`: the place of the error, such as `criteria[2].points`. `problem`: a description of the error.
    """

    def __init__(self, problem: str, path: str = "") -> None:
        self.problem = problem
        self.path = path.removeprefix(".")
        super().__init__(f"{self.path}: {problem}" if self.path else problem)

    def below(self, step: str) -> "Malformed":
        """Return a copy of this error with `step` in front of its path."""
        path = self.path if not self.path or self.path.startswith("[") else f".{self.path}"
        return Malformed(self.problem, f"{step}{path}")


def quoted(data: object) -> str:
    """Format data as an ASCII string for an error message. A long string is cut."""
    text = ascii(data)
    return text if len(text) <= _LONGEST_QUOTATION else f"{text[: _LONGEST_QUOTATION - 4]} ..."


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
        inner = _decoder(_optional(hint))
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
        inner = _encoder(_optional(hint))
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


def _key(one: Field[Any]) -> str:
    return str(one.metadata.get("stored as", one.name))


def _parts(kind: type, convert: Callable[[Any], Converter]) -> list[tuple[Field[Any], str, Converter]]:
    """Return a dataclass's stored fields, each with its JSON name and its converter."""
    hints = get_type_hints(kind)
    left_out = {"not stored", "unknown fields"}
    return [
        (one, _key(one), convert(hints[one.name]))
        for one in fields(kind)
        if not one.metadata.keys() & left_out
    ]


def _name_of_unknown(kind: type) -> str | None:
    """Return the name of the field that collects unknown fields, or None if the class has no such field."""
    return next((one.name for one in fields(kind) if "unknown fields" in one.metadata), None)


def _object_decoder(kind: type) -> Converter:
    parts, unknown = _parts(kind, _decoder), _name_of_unknown(kind)
    known = frozenset(key for _, key, _ in parts)
    required = frozenset(
        one.name
        for one in fields(kind)
        if "always stored" in one.metadata or (one.default is MISSING and one.default_factory is MISSING)
    )

    def of_dict(data: Any) -> Any:
        if type(data) is not dict:
            _refuse(data, f"an object ({kind.__name__})")
        values = {}
        for one, key, convert in parts:
            if key in data:
                try:
                    values[one.name] = convert(data[key])
                except Malformed as error:
                    raise error.below(f".{key}") from None
            elif one.name in required:
                raise Malformed("it is missing", key)
        if not data.keys() <= known and not getattr(kind, "ignores_unknown_fields", False):
            more = {key: item for key, item in data.items() if key not in known}
            if unknown is None:
                raise Malformed(f"{kind.__name__} has no such field", str(next(iter(more))))
            values[unknown] = more
        return kind(**values)

    return of_dict


def _object_encoder(kind: type) -> Converter:
    parts, unknown = _parts(kind, _encoder), _name_of_unknown(kind)

    def of_object(value: Any) -> dict[str, Any]:
        data: dict[str, Any] = {}
        for one, key, convert in parts:
            item = getattr(value, one.name)
            if "stored if set" not in one.metadata or item:
                try:
                    data[key] = convert(item)
                except Malformed as error:
                    raise error.below(f".{key}") from None
        return data if unknown is None else data | getattr(value, unknown)

    return of_object


def _optional(hint: Any) -> Any:
    """Return X from `X | None`. Raise TypeError for other unions."""
    others = [one for one in get_args(hint) if one is not types.NoneType]
    if len(others) != 1:
        raise TypeError(f"no conversion for {hint}")
    return others[0]
