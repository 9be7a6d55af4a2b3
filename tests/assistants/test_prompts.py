"""*Talk it through*: a prompt to copy, and two wrong claims, each of which has a test."""

import re
from pathlib import Path

import jupytext
import pytest

ROOT = Path(__file__).resolve().parents[2]
CLAIMS = Path(__file__).with_name("test_wrong_claims.py")
LESSONS = [
    path for path in sorted((ROOT / "notebooks" / "sources").glob("[0-9]*.py")) if "deeper" not in path.name
]
_LINES = re.MULTILINE | re.DOTALL
_CLAIM = re.compile(r"^- \*\*(.+?):\*\* \S", _LINES)
_FOLD = "<details><summary>What to check in the reply</summary>"


def section(path: Path) -> str:
    cells = jupytext.read(path, fmt="py:percent").cells
    [found] = [cell.source for cell in cells if cell.source.startswith("## Talk it through")]
    return str(found)


def claims(path: Path) -> list[str]:
    _, _, fold = section(path).partition(_FOLD)
    return [re.sub(r"\s+", " ", found[1]) for found in _CLAIM.finditer(fold.partition("</details>")[0])]


def tried() -> list[str]:
    """Return the claims that have a test, from the tests' docstrings."""
    tests = re.findall(
        r'^def test_\w+\([^)]*\) -> None:\n    """(.+?)"""$', CLAIMS.read_text(encoding="utf-8"), _LINES
    )
    return [re.sub(r"\s+", " ", text) for text in tests]


@pytest.mark.parametrize("path", LESSONS, ids=lambda path: path.stem)
def test_a_prompt_says_what_it_is_about_and_each_claim_was_tried(path: Path) -> None:
    [prompt] = re.findall(r"^```text\n(.+?)\n```$", section(path), _LINES)
    assert "Jazzy" in prompt and "rclpy" in prompt
    assert claims(path)
    untried = set(claims(path)) - set(tried())
    assert not untried, f"{CLAIMS.name} needs a test with this docstring, word for word: {untried}"


def test_what_was_tried_is_said_in_a_lesson() -> None:
    assert set(tried()) == {claim for path in LESSONS for claim in claims(path)}
