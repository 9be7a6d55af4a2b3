"""How many answers were judged more than once, as a run of the tests says it at its end."""

from collections.abc import Iterable
from typing import Any

PROPERTY = "tried again"
"""The property of a test's report that holds a line of it."""


def lines_of(reports: Iterable[Any]) -> list[str]:
    """The lines that tests have left in their reports, sorted. What is no report of a test has none."""
    return sorted(
        str(value)
        for report in reports
        if getattr(report, "when", "") == "call"
        for name, value in report.user_properties
        if name == PROPERTY
    )
