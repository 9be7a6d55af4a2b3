"""Explain errors about a name that an object or module lacks.

For many of these errors, `workbook/inside/missing_names.py` adds a line with details to the traceback.
"""

import re

from workbook.criteria.rules import Reason, Words

WORDS = Words(__file__)

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
_MISSPELLED = WORDS.reason("error.name-misspelled", ("near",))
_KEYWORD = WORDS.reason("error.keyword-unknown", ("function", "names"))
_OF_ANOTHER = WORDS.reason("error.method-of-another-class", ("name", "others"))
_OF_OWNERS = {
    owner: WORDS.reason(f"owner.{owner}", ("name", "others"))
    for owner in ("rclpy", "Node", "Publisher", "Clock", "RcutilsLogger")
}
_PRIVATE = WORDS.reason("error.private-name-taken", ("name", "line"))
_SET_LATER = WORDS.reason("error.attribute-set-later", ("name", "line"))
_IN_FRONT = {
    kind: WORDS.reason(f"error.{reason}", ("name", "kind"))
    for reason, kinds in {
        "value-is-none": "NoneType",
        "result-not-taken": "Future",
        "function-not-called": "function method builtin_function_or_method",
        "value-of-other-kind": "int float str bytes bool list tuple dict set array ndarray",
    }.items()
    for kind in kinds.split()
}
_NO_ATTRIBUTE = WORDS.reason("error.no-such-attribute", ("name", "kind"))


def missing_name(error: str, excerpt: str, *, own: bool) -> tuple[str, str, str] | None:
    """Return the cause id for a missing name, and the strings `because` and `try`, or None for other errors.

    `excerpt`: the error with the lines around it (see `Raised.excerpt`). `own`: whether the program itself, rather
    than a library, looked the name up.
    """
    noted = _noted(excerpt)
    if noted is not None:
        return noted
    alike, lacks = _ALIKE.search(excerpt) or _HINT.search(error), _LACKS.search(error)
    if alike is not None:
        return _explained(_MISSPELLED, near=alike["names"].split(", "))
    if lacks is None or lacks["module"] or not own:
        return None
    kind = lacks["kind"] or lacks["object"]
    return _explained(_IN_FRONT.get(kind, _NO_ATTRIBUTE), name=lacks["name"], kind=kind)


def _noted(excerpt: str) -> tuple[str, str, str] | None:
    """Return the cause id and strings for the line that the program's host added, or None if it didn't add one.

    Such a line is about a keyword or method that belongs elsewhere, or an attribute that's set late or overwritten.
    """
    if keywords := _KEYWORDS.search(excerpt):
        return _explained(_KEYWORD, function=keywords["function"], names=keywords["names"])
    if of_others := _OF_OTHERS.search(excerpt):
        others = of_others["others"].split(", ")
        reason = _OF_OWNERS.get(others[0], _OF_ANOTHER)
        return _OF_ANOTHER.id, *reason(name=of_others["name"], others=others)
    for pattern, reason in ((_OVERWRITTEN, _PRIVATE), (_LATER, _SET_LATER)):
        if found := pattern.search(excerpt):
            return _explained(reason, name=found["name"], line=found["line"])
    return None


def _explained(reason: Reason, **given: object) -> tuple[str, str, str]:
    return reason.id, *reason(**given)
