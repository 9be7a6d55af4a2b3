"""Code lines fit into a notebook's column, and headings skip no level."""

from pathlib import Path

import pytest

from tests.notebooks.lesson_layout import CHECKS, SOURCES, cells_of


@pytest.mark.parametrize("path", SOURCES, ids=lambda path: path.stem)
def test_lines_fit_and_headings_skip_no_level(path: Path) -> None:
    cells = cells_of(path)
    for name, check in CHECKS.items():
        assert not (found := check(cells)), f"{name}:\n" + "\n".join(found)


def test_what_is_wrong_would_be_found() -> None:
    cells = [
        ("markdown", "# One\n\n### Three\n\n```python\n# no heading\n" + "x" * 89 + "\n```"),
        ("code", "y" * 88 + "\n" + "z" * 89),
        ("markdown", "#### Four"),
    ]
    assert [line[0] for line in CHECKS["wide_lines"](cells)] == ["z", "x"]
    assert CHECKS["skipped_headings"](cells) == ["Three"]
