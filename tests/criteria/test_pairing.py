"""Inputs and outputs, paired in order:

the same pairs as from an exhaustive search, but in a limited number of steps.
"""

from collections.abc import Callable
from itertools import count, product
from typing import Any

import pytest
from hypothesis import given
from hypothesis import strategies as st

from workbook.criteria import pair_in_order
from workbook.criteria.budget import within_budget

Pairs = list[tuple[int, int]]
MANY = 1200
"""The number of inputs and outputs that a caller at 100 Hz produces in one watch."""


def tried(
    inputs: int,
    outputs: int,
    belongs: Callable[[int, int], bool],
    may_be_missing: Callable[[int], bool],
    may_be_extra: Callable[[int], bool],
    excusable: Callable[[int], bool],
) -> Pairs | None:
    """Search exhaustively, and return the first solution. Each input is paired if possible, otherwise left out."""

    def fit(i: int, j: int, excused: bool) -> Pairs | None:
        if i == inputs:
            return [] if all(may_be_extra(one) for one in range(j, outputs)) else None
        if j < outputs and belongs(i, j):
            others = fit(i + 1, j + 1, excused)
            if others is not None:
                return [(i, j), *others]
        if may_be_missing(i):
            return fit(i + 1, j, excused)
        if not excused and excusable(i):
            return fit(i + 1, j, True)
        return None

    return fit(0, 0, False)


@st.composite
def cases(draw: st.DrawFn) -> dict[str, Any]:
    inputs, outputs = draw(st.integers(0, 6)), draw(st.integers(0, 6))

    def some(most: int) -> Callable[[int], bool]:
        return draw(st.sets(st.integers(0, most))).__contains__

    together = draw(st.sets(st.sampled_from([*product(range(7), range(7))])))
    alike = draw(st.booleans())  # then most pairs fit, so it matters which are left out
    return {
        "inputs": inputs,
        "outputs": outputs,
        "belongs": lambda i, j: ((i, j) in together) != alike,
        "may_be_missing": some(6),
        "may_be_extra": some(6),
        "excusable": some(6),
    }


@given(cases())
def test_pairs_are_those_of_trying_everything(case: dict[str, Any]) -> None:
    wanted = tried(**case)
    case["inputs"], case["outputs"] = range(case["inputs"]), range(case["outputs"])
    assert pair_in_order(case.pop("inputs"), case.pop("outputs"), **case) == wanted


@pytest.mark.parametrize("missing", [False, True])
@pytest.mark.parametrize("more_outputs", [0, 1])
def test_each_pair_is_looked_at_once(missing: bool, more_outputs: int) -> None:
    """This holds for any number of ways to leave something out, and for any length of the inputs."""
    looks = count()

    def belongs(i: int, j: int) -> bool:
        next(looks)
        return True

    many = MANY
    found = within_budget(
        lambda: pair_in_order(
            range(many),
            range(many + more_outputs),
            belongs=belongs,
            may_be_missing=lambda _: missing,
            excusable=lambda _: True,
        )
    )
    assert found == (None if more_outputs else [(i, i) for i in range(many)])
    assert next(looks) <= many * (many + more_outputs)
