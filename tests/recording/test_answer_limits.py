"""The documented limits of an answer are the enforced ones."""

import re
from dataclasses import replace
from pathlib import Path

import pytest

from workbook.criteria.vocabulary import stops
from workbook.isolation.uid import EXTRA_PROCESSES
from workbook.programs.tier import limit_options
from workbook.recording.limits import ANSWER_LIMITS, ENDED_PROCESSES, MB, NO_LIMITS

ROOT = Path(__file__).resolve().parents[2]


@pytest.mark.parametrize(
    ("limit", "value"),
    [("processes", "64 processes"), ("memory", "2.5 GB"), ("files", "20,000 files"), ("output", "50 MB")],
)
def test_what_a_student_reads_is_what_is_enforced(limit: str, value: str) -> None:
    told = stops._STOPS[limit].verdict(begin="", end="", expected="", **stops._LIMITS)
    assert value in told.saw
    enforced = getattr(ANSWER_LIMITS, limit)
    number = float(value.rpartition(" ")[0].replace(",", "")) * {"GB": 1000 * MB, "MB": MB}.get(value[-2:], 1)
    assert number == enforced


def test_the_manual_names_what_the_kernel_allows_a_user() -> None:
    manual = (ROOT / "exercises" / "README.md").read_text(encoding="utf-8")
    [most] = re.findall(r"(\d+) processes and threads \(including ended ones\), plus four", manual)
    assert ANSWER_LIMITS.processes is not None
    assert int(most) == ANSWER_LIMITS.processes + EXTRA_PROCESSES + ENDED_PROCESSES


def test_only_limits_that_are_set_reach_the_host() -> None:
    assert limit_options(NO_LIMITS, ("memory", "cpu")) == []
    assert limit_options(replace(NO_LIMITS, cpu=60), ("memory", "cpu")) == ["--limit", "cpu=60"]
