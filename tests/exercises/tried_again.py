"""Count the answers that were judged more than once, for the summary at the end of a test run."""

from collections.abc import Iterable
from typing import Any

PROPERTY = "tried again"
"""The property of a test's report that holds one line of the summary."""


def lines_of(reports: Iterable[Any]) -> list[str]:
    """Return the lines that tests left in their reports, sorted. Objects other than test reports have none."""
    return sorted(
        str(value)
        for report in reports
        if getattr(report, "when", "") == "call"
        for name, value in report.user_properties
        if name == PROPERTY
    )
