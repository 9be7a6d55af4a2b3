"""The course's tables of requirements are correct.

tests/authoring/test_requirement_tables.py tests the check itself.
"""

from pathlib import Path

import pytest

from workbook.authoring.exercise import read_exercise
from workbook.authoring.requirements import WITHOUT_TABLE, stale_exceptions, table_violations
from workbook.authoring.tree import Tree

COURSE = Tree(Path(__file__).resolve().parents[2])
MOST_WITHOUT_TABLE = 0
"""The number may only shrink."""


@pytest.mark.parametrize("stem", COURSE.exercise_stems())
def test_the_table_of_an_exercise_holds(stem: str) -> None:
    exercise = read_exercise(COURSE, stem)
    assert [str(one) for one in table_violations(COURSE, stem, exercise)] == []


def test_exercises_without_a_table_become_fewer() -> None:
    assert [str(one) for one in stale_exceptions(COURSE)] == []
    assert len(WITHOUT_TABLE) <= MOST_WITHOUT_TABLE
