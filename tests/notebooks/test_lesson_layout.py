"""Code lines fit into a notebook's column, and headings skip no level."""

from pathlib import Path

import pytest

from tests.notebooks.lesson_layout import CHECKS, COMMAND, SOURCES, cells_of, kept


@pytest.mark.parametrize("path", SOURCES, ids=lambda path: path.stem)
def test_a_lesson_has_no_more_exceptions_than_are_written_down(path: Path) -> None:
    cells = cells_of(path)
    for name, check in CHECKS.items():
        found = check(cells)
        assert len(found) <= kept().get(name, {}).get(path.stem, 0), f"{name}:\n" + "\n".join(found)


def test_exceptions_name_lessons_and_checks_that_there_are() -> None:
    stems = {path.stem for path in SOURCES}
    assert set(kept()) == set(CHECKS), f"run `{COMMAND}`"
    assert {stem for allowed in kept().values() for stem in allowed} <= stems


def test_what_is_wrong_would_be_found() -> None:
    cells = [
        ("markdown", "# One\n\n### Three\n\n```python\n# no heading\n" + "x" * 89 + "\n```"),
        ("code", "y" * 88 + "\n" + "z" * 89),
        ("markdown", "#### Four"),
    ]
    assert [line[0] for line in CHECKS["wide_lines"](cells)] == ["z", "x"]
    assert CHECKS["skipped_headings"](cells) == ["Three"]
