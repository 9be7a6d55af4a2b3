"""*Talk it through*: a prompt to copy, and two wrong claims, each of which a test has tried."""

import re
from pathlib import Path

import jupytext
import pytest

ROOT = Path(__file__).resolve().parents[2]
CLAIMS = Path(__file__).with_name("test_wrong_claims.py")
LESSONS = [
    path for path in sorted((ROOT / "notebooks" / "sources").glob("[0-9]*.py")) if "deeper" not in path.name
]
_CLAIM = re.compile(r"^- \*\*(.+?):\*\* +(\S)", re.MULTILINE | re.DOTALL)
_FOLD = "<details><summary>What to check in the reply</summary>"


def section(path: Path) -> str:
    cells = jupytext.read(path, fmt="py:percent").cells
    [found] = [cell.source for cell in cells if cell.source.startswith("## Talk it through")]
    return str(found)


def claims(path: Path) -> list[str]:
    _, _, fold = section(path).partition(_FOLD)
    return [re.sub(r"\s+", " ", found[1]) for found in _CLAIM.finditer(fold.partition("</details>")[0])]


def tried() -> dict[str, list[str]]:
    """The claims by lesson, as the tests name them: a comment with the number, and the claim as a docstring."""
    found: dict[str, list[str]] = {}
    for part in re.split(r"^# (?=\d\d$)", CLAIMS.read_text(encoding="utf-8"), flags=re.MULTILINE)[1:]:
        docstrings = re.findall(r'^def test_.*?:\n    r?"""(.+?)"""$', part, re.MULTILINE | re.DOTALL)
        found[part[:2]] = [re.sub(r"\s+", " ", text) for text in docstrings]
    return found


@pytest.mark.parametrize("path", LESSONS, ids=lambda path: path.stem)
def test_a_prompt_to_copy_and_two_claims_that_were_tried(path: Path) -> None:
    [prompt] = re.findall(r"^```text\n(.+?)\n```$", section(path), re.MULTILINE | re.DOTALL)
    assert "Jazzy" in prompt and "rclpy" in prompt
    assert len(claims(path)) == 2
    assert claims(path) == tried()[path.stem[:2]]


def test_no_claim_is_tried_for_a_lesson_that_does_not_say_it() -> None:
    assert sorted(tried()) == [path.stem[:2] for path in LESSONS]
