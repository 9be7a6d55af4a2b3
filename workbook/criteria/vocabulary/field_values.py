"""Explains a value that does not fit its field. `workbook/inside/field_values.py` adds the line that says it."""

import re
from dataclasses import dataclass

_NOTE = re.compile(
    r"The field '(?P<field>[^']+)' of (?P<message>\w+) takes (?P<kind>.+?), and got (?P<given>[\w.]+): (?P<value>.*)$",
    re.MULTILINE,
)
_FIELDS = re.compile(r"^The fields of (?P<message>\w+) are: (?P<names>.+)$", re.MULTILINE)
_LIST = re.compile(r"^sequence<|\]$")
_ONE_IN_A_TUPLE = re.compile(r"^\((?:'[^']*'|\"[^\"]*\"|[^,]+),\)$")


@dataclass(frozen=True)
class Misfit:
    """Why a value does not fit its field, and what to try."""

    because: str
    try_this: str


def unknown_field(told: str) -> Misfit | None:
    """What an error says about the fields of a message that lacks one; None if it says nothing."""
    found = _FIELDS.search(told)
    if found is None:
        return None
    return Misfit(
        f"{found['message']} has no field of that name. Its fields are: {found['names']}.",
        "Use one of these names.",
    )


def value_that_misfits(told: str) -> Misfit | None:
    """What an error says about a field and its value; None if it says nothing."""
    found = _NOTE.search(told)
    if found is None:
        return None
    kind, given = found["kind"], found["given"]
    takes = f"The field '{found['field']}' of {found['message']} takes {kind}."
    because = f"{takes} It was given {given}: {found['value']}."
    if given == "tuple" and _ONE_IN_A_TUPLE.match(found["value"]) and not _LIST.search(kind):
        return Misfit(
            f"{because} A comma at the end of a line makes a tuple with one item.",
            "Remove the comma after the value.",
        )
    return Misfit(because, _advice(kind, given))


def _advice(kind: str, given: str) -> str:
    if _LIST.search(kind):
        return "Give the field a flat list, and each element the type that the field takes."
    if kind == "builtin_interfaces/Time":
        return "Give the field a Time message: self.get_clock().now().to_msg()."
    if kind == "builtin_interfaces/Duration":
        return "Give the field a Duration message: Duration(seconds=1.0).to_msg()."
    if "/" in kind:
        return f"Give the field a {kind.rpartition('/')[2]} message, or fill its fields one by one."
    if kind in ("float", "double"):
        return "Give the field a float: float(level), or 100.0 instead of 100."
    if kind.startswith(("string", "wstring")):
        return "Give the field a string: 'a word', str(value), or text.decode() for bytes."
    if kind == "boolean":
        return "Give the field True or False."
    if given == "int":
        return f"Give the field a whole number that fits into {kind}."
    return "Give the field a whole number: int(value), or round(value)."
