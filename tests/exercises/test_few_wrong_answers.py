"""The wrong answers of `make test` are few, but they break every criterion of every exercise."""

from pathlib import Path

import pytest

from tests.exercises.few_wrong_answers import few_that_break_all
from tests.exercises.proofs import FEW_WRONG, ROOT, STEMS, answers
from workbook.authoring.wrong_answers import read_header
from workbook.exercise.definition import load_exercise

BY_STARTERS = {"program_runs", "answers_come"}
"""In 10 to 16, only a starter or a crash loses one of these. A crash is the same in all exercises."""


@pytest.mark.parametrize("stem", STEMS)
def test_every_criterion_is_broken_by_one_of_them(stem: str) -> None:
    chosen = [path for path in answers("wrong", stem) if path in FEW_WRONG]
    broken = frozenset[str]().union(*(read_header(path).loses for path in chosen))
    of_all = {one.id for one in load_exercise(stem, ROOT).criteria if not one.hidden}
    assert of_all - broken <= BY_STARTERS
    assert len(chosen) <= len(of_all)


def test_an_answer_that_adds_nothing_is_left_out() -> None:
    both, one, other = (Path(name) for name in ("both.py", "one.py", "other.py"))
    loses = {one: frozenset({"a"}), both: frozenset({"a", "b"}), other: frozenset({"c"})}
    assert few_that_break_all(loses) == {both, other}
