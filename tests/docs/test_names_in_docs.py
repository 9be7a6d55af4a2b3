"""The files and vocabulary names on authors' pages exist."""

import re
from pathlib import Path

import pytest

import workbook.criteria as see

ROOT = Path(__file__).resolve().parents[2]
PAGES = (ROOT / "CONTRIBUTING.md", *sorted((ROOT / "docs").glob("*.md")))
FOLDERS = ("workbook", "deploy", "tests", "exercises", "lesson_nodes", "solutions", "notebooks")
FILES = {path.name for folder in FOLDERS for path in (ROOT / folder).rglob("*.py")}
EXAMPLES = re.compile(r"(?:NN_|\d\d_|my_|s1001|answer\b|mine\b)")


@pytest.mark.parametrize("page", PAGES, ids=lambda page: page.name)
def test_files_and_words_of_a_page_exist(page: Path) -> None:
    text = page.read_text(encoding="utf-8")
    files = {name for name in re.findall(r"`(?:[\w.]+/)*(\w+\.py)`", text) if not EXAMPLES.match(name)}
    assert files <= FILES
    assert {word for word in re.findall(r"\bsee\.([A-Za-z_]+)", text) if not hasattr(see, word)} == set()
