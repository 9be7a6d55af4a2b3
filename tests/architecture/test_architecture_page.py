"""docs/architecture.md names only modules that exist, and its table has exactly the layers that are enforced."""

import re
from pathlib import Path

from tests.architecture.test_layers import LAYERS

ROOT = Path(__file__).resolve().parents[2]
PAGE = (ROOT / "docs" / "architecture.md").read_text(encoding="utf-8")


def test_every_module_that_the_page_names_exists() -> None:
    named = set(re.findall(r"\b[a-z_]+(?:/[a-z_]+)+\.py\b", PAGE))
    assert len(named) > 10
    missing = {
        path for path in named if not (ROOT / path).is_file() and not (ROOT / "workbook" / path).is_file()
    }
    assert missing == set()


def test_the_table_of_layers_is_the_one_that_is_enforced() -> None:
    section = PAGE.partition("## Layers of `workbook/`\n")[2].partition("\n## ")[0]
    rows = re.findall(r"^\| (`[^|]+`) \|", section, flags=re.MULTILINE)
    assert tuple(tuple(re.findall(r"`(\w+)`", row)) for row in rows) == LAYERS
