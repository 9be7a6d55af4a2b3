"""Wrong answers name only causes that exist."""

from collections.abc import Iterator

import pytest

from tests.criteria.causes_in import ROOT, Source, exercises, vocabulary
from workbook.authoring.tree import Tree, entries
from workbook.authoring.wrong_answers import Header, read_header

STEMS = Tree(ROOT).exercise_stems()


def headers(stem: str) -> Iterator[tuple[str, Header]]:
    for path in entries(Tree(ROOT).wrong_answers / stem):
        yield path.name, read_header(path)


@pytest.mark.parametrize("stem", STEMS)
def test_every_wrong_answer_names_a_cause_that_exists(stem: str) -> None:
    paths = [path for path in (*exercises(), *vocabulary()) if path.stem not in STEMS or path.stem == stem]
    in_catalogs = {cause for path in paths for cause in Source(path).causes()}
    in_code = "\n".join(path.read_text(encoding="utf-8") for path in paths)
    causes = {name: header.causes for name, header in headers(stem)}
    assert not {name for name, some in causes.items() if not some}
    unknown = {
        name: cause
        for name, some in causes.items()
        for cause in some
        if cause not in in_catalogs and f'"{cause}"' not in in_code
    }
    assert not unknown
