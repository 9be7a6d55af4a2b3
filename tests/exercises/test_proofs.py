"""Every exercise proves itself: starter, solution, right answers, and wrong answers go through the real judge.

Exercises on the wall clock go first, then those on simulated time. Other tests wait until then (see
`tests/conftest.py`). `make test` skips the right answers and most of the wrong ones, which only the whole run judges.
"""

from collections.abc import Callable
from pathlib import Path

import pytest

from tests.exercises.expected import differences, explained, silent
from tests.exercises.proofs import CASES, FEW_WRONG, SOLUTION, STARTER, STEMS, Key, Proofs
from tests.exercises.tried_again import PROPERTY
from workbook.authoring.wrong_answers import read_header

ENOUGH = 50
"""With fewer answers than this in an exercise, a share of them means little."""
MOST_TRIED_AGAIN = 0.1
"""The largest accepted share of an exercise's answers. The aim is 2%."""
KINDS = {
    "test_solution_gets_full_marks": SOLUTION,
    "test_starter_does_not_pass_and_says_what_is_missing": STARTER,
    "test_right_answer_gets_full_marks": "right",
    "test_wrong_answer_loses_what_it_must": "wrong",
}
"""The kind of answer that each test of this file judges."""


def tests_of_answers() -> list[tuple[str, Key]]:
    """Return each test of this file that judges an answer, by its pytest name, with the answer."""
    file = Path(__file__).relative_to(Path(__file__).parents[2])
    found = []
    for test, kind in KINDS.items():
        if kind in CASES:
            cases = [(f"{stem}-{path.stem}", (stem, f"{kind}/{path.name}")) for stem, path in CASES[kind]]
        else:
            cases = [(stem, (stem, kind)) for stem in STEMS]
        found += [(f"{file}::{test}[{name}]", key) for name, key in cases]
    return found


@pytest.fixture(scope="session")
def proofs(request: pytest.FixtureRequest) -> Proofs:
    keys = dict(tests_of_answers())
    return Proofs({keys[item.nodeid] for item in request.session.items if item.nodeid in keys})


@pytest.mark.parametrize("stem", STEMS)
def test_solution_gets_full_marks(stem: str, proofs: Proofs) -> None:
    judgement = proofs.judgement((stem, SOLUTION), lambda one: one.full_marks)
    assert judgement.full_marks, explained(judgement)


@pytest.mark.parametrize("stem", STEMS)
def test_starter_does_not_pass_and_says_what_is_missing(stem: str, proofs: Proofs) -> None:
    judgement = proofs.judgement((stem, STARTER), lambda one: one.status == "graded")
    assert judgement.status == "graded", judgement.reason
    assert not judgement.full_marks
    assert not silent(judgement)


@pytest.mark.whole
@pytest.mark.parametrize(
    ("stem", "path"), [pytest.param(stem, path, id=f"{stem}-{path.stem}") for stem, path in CASES["right"]]
)
def test_right_answer_gets_full_marks(stem: str, path: Path, proofs: Proofs) -> None:
    judgement = proofs.judgement((stem, f"right/{path.name}"), lambda one: one.full_marks)
    assert judgement.full_marks, explained(judgement)


@pytest.mark.parametrize(
    ("stem", "path"),
    [
        pytest.param(
            stem, path, marks=() if path in FEW_WRONG else pytest.mark.whole, id=f"{stem}-{path.stem}"
        )
        for stem, path in CASES["wrong"]
    ],
)
def test_wrong_answer_loses_what_it_must(stem: str, path: Path, proofs: Proofs) -> None:
    expected = read_header(path)
    judgement = proofs.judgement((stem, f"wrong/{path.name}"), lambda one: not differences(one, expected))
    found = differences(judgement, expected)
    assert not found, "\n".join([*found, explained(judgement)])


@pytest.mark.parametrize("stem", STEMS)
def test_few_answers_need_more_than_one_try(
    stem: str, proofs: Proofs, record_property: Callable[[str, object], None]
) -> None:
    judged, again = proofs.again(stem)
    record_property(PROPERTY, f"{stem}: {len(again)} of {judged} {' '.join(again)}".rstrip())
    assert judged < ENOUGH or len(again) <= MOST_TRIED_AGAIN * judged, ", ".join(again)
