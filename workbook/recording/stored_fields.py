"""Define how a frozen dataclass is stored: field names, conversions, and the error for data that doesn't fit."""

import types
from collections.abc import Callable, Mapping
from dataclasses import MISSING, Field, fields
from typing import Any, NamedTuple, Union, get_args, get_origin, get_type_hints

Converter = Callable[[Any], Any]

ALWAYS_STORED: Mapping[str, Any] = {"always stored": True}
"""Metadata of a field that has a default for constructor calls, but that stored data must contain."""
NOT_STORED: Mapping[str, Any] = {"not stored": True}
STORED_IF_SET: Mapping[str, Any] = {"stored if set": True}
"""Metadata of a field that is left out of the data if it's empty. It's for fields that nearly always are."""
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


class StoredField(NamedTuple):
    """The rules for storing a dataclass field.

    `key`: its name in JSON. `as_is`: types whose values don't need a conversion. `convert`: a function that converts
    all other values. `is_float`: whether the field is a float. `default`: a function that creates the value if the
    field is missing, or None if the field is required.
    """

    name: str
    key: str
    as_is: frozenset[type]
    is_float: bool
    convert: Converter
    default: Callable[[], Any] | None


def stored_fields(kind: type, convert: Callable[[Any], Converter]) -> tuple[StoredField, ...]:
    """Return a dataclass's stored fields, in order. `convert` returns the converter for a type hint."""
    hints = get_type_hints(kind)
    parts = []
    for one in fields(kind):
        if one.metadata.keys() & {"not stored", "unknown fields"}:
            continue
        hint = hints[one.name]
        as_is = _as_is(hint)
        if get_origin(hint) in (Union, types.UnionType):
            hint = optional(hint)  # `as_is` covers None
        key = one.metadata.get("stored as", one.name)
        parts.append(StoredField(one.name, key, as_is, hint is float, convert(hint), _default_of(one)))
    return tuple(parts)


def _default_of(one: Field[Any]) -> Callable[[], Any] | None:
    if "always stored" in one.metadata:
        return None
    if one.default_factory is not MISSING:
        return one.default_factory
    return None if one.default is MISSING else lambda: one.default


def fields_not_stored(kind: type) -> list[tuple[str, Callable[[], Any]]]:
    """Return the fields that aren't stored, each with a function that creates its default.

    The field for unknown fields is one of them.

    Raise TypeError if such a field has no default.
    """
    found: list[tuple[str, Callable[[], Any]]] = []
    for one in fields(kind):
        if one.metadata.keys() & {"not stored", "unknown fields"}:
            default = _default_of(one)
            if default is None:
                raise TypeError(f"{kind.__name__}.{one.name} needs a default: it is not stored")
            found.append((one.name, default))
    return found


def keys_stored_if_set(kind: type) -> list[str]:
    """Return the JSON names of the fields that are left out if they're empty."""
    return [
        one.metadata.get("stored as", one.name) for one in fields(kind) if "stored if set" in one.metadata
    ]


def name_of_unknown(kind: type) -> str | None:
    """Return the name of the field that collects unknown fields, or None if the class has no such field."""
    return next((one.name for one in fields(kind) if "unknown fields" in one.metadata), None)


def _as_is(hint: Any) -> frozenset[type]:
    """Return the types allowed by a hint whose values don't need a conversion."""
    if hint in (int, bool, types.NoneType):
        return frozenset([hint])
    if get_origin(hint) in (Union, types.UnionType):
        return frozenset().union(*map(_as_is, get_args(hint)))
    return frozenset()


def optional(hint: Any) -> Any:
    """Return X from `X | None`. Raise TypeError for other unions."""
    others = [one for one in get_args(hint) if one is not types.NoneType]
    if len(others) != 1:
        raise TypeError(f"no conversion for {hint}")
    return others[0]
