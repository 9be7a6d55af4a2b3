"""Explain errors about a value that doesn't fit its field.

We recognize these errors by a line that `workbook/inside/field_values.py` adds to the traceback.
"""

import re
from dataclasses import dataclass

from workbook.criteria.rules import Words, otherwise

WORDS = Words(__file__)

_NOTE = re.compile(
    r"The field '(?P<field>[^']+)' of (?P<message>\w+) takes (?P<kind>.+?), and got (?P<given>[\w.]+): (?P<value>.*)$",
    re.MULTILINE,
)
_FIELDS = re.compile(r"^The fields of (?P<message>\w+) are: (?P<names>.+)$", re.MULTILINE)
_LIST = re.compile(r"^sequence<|\]$")
_ONE_IN_A_TUPLE = re.compile(r"^\((?:'[^']*'|\"[^\"]*\"|[^,]+),\)$")
_UNKNOWN = WORDS.reason("error.unknown-field", ("message", "names"))


@dataclass(frozen=True)
class Misfit:
    """A message field and a value that doesn't fit it.

    `message`: the message class. `kind`: the field's ROS type. `given`: the value's Python type.
    """

    field: str
    message: str
    kind: str
    given: str
    value: str

    @property
    def takes_list(self) -> bool:
        """Whether the field is an array."""
        return _LIST.search(self.kind) is not None

    @property
    def short_kind(self) -> str:
        """The field's type without its package."""
        return self.kind.rpartition("/")[2]


_MISFITS = [
    (WORDS.reason(f"misfit.{reason}", Misfit), fits)
    for reason, fits in (
        (
            "tuple",
            lambda one: one.given == "tuple" and _ONE_IN_A_TUPLE.match(one.value) and not one.takes_list,
        ),
        ("list", lambda one: one.takes_list),
        ("time", lambda one: one.kind == "builtin_interfaces/Time"),
        ("duration", lambda one: one.kind == "builtin_interfaces/Duration"),
        ("message", lambda one: "/" in one.kind),
        ("float", lambda one: one.kind in ("float", "double")),
        ("text", lambda one: one.kind.startswith(("string", "wstring"))),
        ("boolean", lambda one: one.kind == "boolean"),
        ("too-large", lambda one: one.given == "int"),
        ("whole-number", otherwise),
    )
]


def unknown_field(excerpt: str) -> tuple[str, str] | None:
    """Return the strings `because` and `try` for a field that a message doesn't have, or None for other errors.

    `excerpt`: the error with the lines around it (see `Raised.excerpt`).
    """
    found = _FIELDS.search(excerpt)
    return found and _UNKNOWN(message=found["message"], names=found["names"].split(", "))


def value_that_misfits(excerpt: str) -> tuple[str, str] | None:
    """Return the strings `because` and `try` for a value that doesn't fit its field, or None for other errors.

    `excerpt`: the error with the lines around it (see `Raised.excerpt`).
    """
    found = _NOTE.search(excerpt)
    if found is None:
        return None
    misfit = Misfit(**found.groupdict())
    return next(reason(misfit) for reason, fits in _MISFITS if fits(misfit))
