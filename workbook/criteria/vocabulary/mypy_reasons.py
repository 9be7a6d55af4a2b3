"""Explain why mypy rejects code in an answer, and suggest a fix. The first matching reason is used."""

from workbook.criteria.rules import Reason, Words
from workbook.recording.recording import Finding

WORDS = Words(__file__)

REASONS = tuple(
    (WORDS.reason(cause), code, part)
    for cause, code, part in (
        ("mypy.untyped-def", "no-untyped-def", ""),
        ("mypy.explicit-any", "explicit-any", ""),
        ("mypy.unimported-any", "no-any-unimported", ""),
        ("mypy.generic-publisher", "type-arg", '"Publisher" expects no type arguments'),
        ("mypy.no-type-argument", "type-arg", "Missing type"),
        ("mypy.read-only-name", "misc", "is read-only"),
        ("mypy.name-of-supertype", "assignment", "is incompatible with supertype"),
        ("mypy.other-type", "assignment", ""),
        ("mypy.wrong-argument", "arg-type", ""),
        ("mypy.no-attribute", "attr-defined", ""),
        ("mypy.maybe-none", "union-attr", ""),
        ("mypy.other-return", "return-value", ""),
        ("mypy.unknown-elements", "var-annotated", "(hint:"),
        ("mypy.unknown-type", "var-annotated", ""),
        ("mypy.import-not-found", "import-not-found", ""),
        ("mypy.unused-ignore", "unused-ignore", ""),
        ("mypy.syntax", "syntax", ""),
    )
)
"""Rows of a reason, a code, and a string. A reason applies to findings with this code and this string in them."""
OTHER = WORDS.reason("mypy.other")


def reason_for(finding: Finding) -> Reason:
    """Return the likely reason for a mypy finding, which includes one next step."""
    fitting = (reason for reason, code, part in REASONS if finding.code == code and part in finding.message)
    return next(fitting, OTHER)
