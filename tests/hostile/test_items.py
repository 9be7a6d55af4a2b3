"""Every item on the list of possible attacks is covered, and the files that it names exist."""

import ast
import re
import tomllib
from pathlib import Path
from typing import Any

import pytest

ROOT = Path(__file__).resolve().parents[2]
ITEMS: list[dict[str, Any]] = tomllib.loads(
    (Path(__file__).parent / "items.toml").read_text(encoding="utf-8")
)["item"]
COUNT = 120
RUN_BY_THEMSELVES = re.compile(r"tests/(?:hostile/answers|(?:right|wrong)_answers/\d\d_\w+)/\w+\.py")


def test_no_item_is_missing() -> None:
    assert [item["number"] for item in ITEMS] == list(range(1, COUNT + 1))


@pytest.mark.parametrize("item", ITEMS, ids=lambda item: str(item["number"]))
def test_what_proves_an_item_is_there(item: dict[str, Any]) -> None:
    assert item["what"]
    assert ("proof" in item) != ("no_goal" in item)
    assert item.get("proof") or item.get("no_goal")
    for proof in item.get("proof", []):
        path, _, name = proof.partition("::")
        assert (ROOT / path).is_file(), f"{path} is not there"
        if name:
            tree = ast.parse((ROOT / path).read_text(encoding="utf-8"))
            assert name in {one.name for one in tree.body if isinstance(one, ast.FunctionDef)}, proof
        else:
            assert RUN_BY_THEMSELVES.fullmatch(path), f"nothing runs {path}"


def test_every_hostile_answer_proves_an_item() -> None:
    named = {proof for item in ITEMS for proof in item.get("proof", [])}
    there = {str(path.relative_to(ROOT)) for path in (Path(__file__).parent / "answers").iterdir()}
    assert there <= named


def test_what_is_no_goal_is_said_to_instructors() -> None:
    page = (ROOT / "exercises" / "README.md").read_text(encoding="utf-8")
    words = page.partition("### Limits of grading")[2].partition("\n## ")[0].lower()
    for what in ("kernel", "copied", "side channel"):
        assert what in words
