"""Explains a name that an object or a module lacks. `workbook/inside/missing_names.py` adds the line that says more."""

import re

from workbook.criteria.vocabulary.phrasing import listing

_LACKS = re.compile(
    r"^AttributeError: (?:type object '(?P<kind>\w+)'|'(?P<object>\w+)' object|module '(?P<module>[\w.]+)') "
    r"has no attribute '(?P<name>\w+)'"
)
_HINT = re.compile(r"Did you mean: '(?P<names>\w+)'\?")
_ALIKE = re.compile(r"^Similar names of (?P<owner>[\w.]+) are: (?P<names>.+)$", re.MULTILINE)
_LATER = re.compile(r"^Line (?P<line>\d+) sets '(?P<name>\w+)' of (?P<owner>\w+)$", re.MULTILINE)
_OVERWRITTEN = re.compile(r"^Line (?P<line>\d+) sets '(?P<name>\w+)', which Node needs itself$", re.MULTILINE)
_KEYWORDS = re.compile(r"^The keywords of (?P<function>\w+) are: (?P<names>.+)$", re.MULTILINE)
_OF_OTHERS = re.compile(r"^'(?P<name>\w+)' belongs to: (?P<others>.+)$", re.MULTILINE)
_FUNCTIONS = frozenset({"function", "method", "builtin_function_or_method"})
_VALUES = frozenset(
    {"int", "float", "str", "bytes", "bool", "list", "tuple", "dict", "set", "array", "ndarray"}
)
_HOW_OTHERS_ARE_CALLED = {
    "rclpy": "Call it as a function of rclpy: rclpy.{name}(...).",
    "Node": "Call it as a method of the node: self.{name}(...) in its class, node.{name}(...) elsewhere.",
    "Publisher": "Call it as a method of the publisher that create_publisher() returned.",
    "Clock": "Call it as a method of the clock: self.get_clock().{name}(...).",
    "RcutilsLogger": "Call it as a method of the logger: self.get_logger().{name}(...).",
}


def missing_name(error: str, told: str, *, own: bool) -> tuple[str, str, str] | None:
    """The cause id for a name that is not there, why, and what to try; None for other errors.

    `own`: the program itself asked for the name, and no library in its place.
    """
    noted = _kept_elsewhere(told) or _set_wrongly(told)
    alike, lacks = _ALIKE.search(told) or _HINT.search(error), _LACKS.search(error)
    if noted is not None:
        return noted
    if alike is not None:
        near = alike["names"].split(", ")
        return (
            "error.name-misspelled",
            f"No such name exists there. The most similar {'names are' if near[1:] else 'name is'} {listing(near)}.",
            f"Check the spelling: did you mean {near[0]}?",
        )
    if lacks is None or lacks["module"] or not own:
        return None
    return _of_value(lacks["kind"] or lacks["object"], lacks["name"])


def _kept_elsewhere(told: str) -> tuple[str, str, str] | None:
    """The same for a keyword or a method that is not here, but where the host's line says."""
    keywords, others = _KEYWORDS.search(told), _OF_OTHERS.search(told)
    if keywords is not None:
        return (
            "error.keyword-unknown",
            f"{keywords['function']}() has no keyword of this name. Its keywords are: {keywords['names']}.",
            "Use one of these names.",
        )
    if others is None:
        return None
    names = others["others"].split(", ")
    how = _HOW_OTHERS_ARE_CALLED.get(names[0], f"Call it as a method of a {names[0]}.")
    return (
        "error.method-of-another-class",
        f"{others['name']} belongs to {listing(names)}. The object in front of the dot doesn't have it.",
        how.format(name=others["name"]),
    )


def _set_wrongly(told: str) -> tuple[str, str, str] | None:
    """The same for an attribute that a line of the program sets too late, or may not set."""
    later, overwritten = _LATER.search(told), _OVERWRITTEN.search(told)
    if overwritten is not None:
        return (
            "error.private-name-taken",
            f"Line {overwritten['line']} sets {overwritten['name']}. Node keeps something of its own in an attribute "
            "of this name, and it is lost now.",
            "Give your attribute another name, without an underscore in front.",
        )
    if later is None:
        return None
    return (
        "error.attribute-set-later",
        f"The attribute {later['name']} doesn't exist yet. Line {later['line']} sets it, and that line has not run "
        "for this object.",
        f"Set self.{later['name']} in __init__, above the first line that uses it.",
    )


def _of_value(kind: str, name: str) -> tuple[str, str, str]:
    if kind == "NoneType":
        return (
            "error.value-is-none",
            f"The value in front of .{name} is None. A function without return gives None. So does an attribute that "
            "begins as None.",
            "Find the line that sets this value, and make sure that it runs first.",
        )
    if kind == "Future":
        return (
            "error.result-not-taken",
            f"A future has no {name}. Once it is done, it has a result, and the result may have one.",
            f"Write future.result().{name}.",
        )
    if kind in _FUNCTIONS:
        return (
            "error.function-not-called",
            f"A function stands in front of .{name}, not what it returns.",
            "Call the function: put parentheses after its name.",
        )
    if kind in _VALUES:
        return (
            "error.value-of-other-kind",
            f"The value in front of .{name} is of type {kind}, and such a value has no {name}.",
            f"Find the line that sets this value. Or leave out .{name}.",
        )
    return (
        "error.no-such-attribute",
        f"This {kind} has no {name}. The name is misspelled, or no line has set it yet.",
        "Check the spelling. Set an attribute of your own in __init__, above the first line that uses it.",
    )
