"""HTML comes from templates, which escape automatically. No code writes tags or escapes by hand."""

import ast
import re
import tomllib
from pathlib import Path

import pytest

from workbook.templating import render

ROOT = Path(__file__).resolve().parents[2]
MODULES = sorted((ROOT / "workbook").rglob("*.py"))
TEMPLATES = sorted((ROOT / "workbook").rglob("*.j2"))
TAG = re.compile(
    r"</?(a|b|body|br|code|details|div|h[1-6]|head|html|i|img|li|ol|p|pre|progress|script|small|span|strong|style|sub|"
    r"summary|svg|table|tbody|td|th|thead|tr|ul)\b[^a-z]"
)
SAY_WHICH_TAGS_TO_WRITE = {"workbook/authoring/template.py"}
"""Messages to authors of lessons, whose Markdown contains tags."""


def label(path: Path) -> str:
    return str(path.relative_to(ROOT))


def html_by_hand(path: Path) -> list[int]:
    """Return the lines that have a tag in a formatted text, or that escape with the standard library."""
    found = []
    for node in ast.walk(ast.parse(path.read_text(encoding="utf-8"))):
        if isinstance(node, ast.JoinedStr):
            text = "".join(str(one.value) if isinstance(one, ast.Constant) else "{}" for one in node.values)
            if TAG.search(text):
                found.append(node.lineno)
        elif isinstance(node, ast.ImportFrom) and node.module in ("html", "xml.sax.saxutils"):
            found += [node.lineno for alias in node.names if alias.name == "escape"]
        elif isinstance(node, ast.Attribute) and node.attr == "escape":
            if isinstance(node.value, ast.Name) and node.value.id == "html":
                found.append(node.lineno)
    return found


@pytest.mark.parametrize("path", MODULES, ids=label)
def test_no_html_is_written_by_hand(path: Path) -> None:
    if label(path) not in SAY_WHICH_TAGS_TO_WRITE:
        assert html_by_hand(path) == []


def test_html_by_hand_would_be_found(tmp_path: Path) -> None:
    path = tmp_path / "page.py"
    path.write_text(
        'from html import escape\nimport html\nx = f"<td>{html.escape(y)}</td>"\nz = f"a < b {y}"\n'
    )
    assert sorted(html_by_hand(path)) == [1, 3, 3]


@pytest.mark.parametrize("path", TEMPLATES, ids=label)
def test_no_template_switches_escaping_off(path: Path) -> None:
    text = path.read_text(encoding="utf-8")
    assert not re.search(r"\|\s*safe\b|autoescape", text)
    assert path.parent.name == "templates", "where `render` looks for it, and the wheel takes it along"


def test_a_template_escapes_and_names_what_is_missing() -> None:
    from jinja2 import UndefinedError

    assert render("pictures/img", alt='<"&', width=1, height=2, src="x") == (
        '<img alt="&lt;&#34;&amp;" width="1" height="2" src="x">'
    )
    with pytest.raises(UndefinedError, match="alt"):
        render("pictures/img", width=1, height=2, src="x")


def test_the_wheel_takes_whole_packages_along() -> None:
    """flit includes every file of the package unless it is told to exclude some."""
    project = tomllib.loads((ROOT / "pyproject.toml").read_text(encoding="utf-8"))
    assert project["build-system"]["build-backend"] == "flit_core.buildapi"
    assert project["tool"]["flit"] == {"module": {"name": "workbook"}}
    assert any(one.startswith("jinja2") for one in project["project"]["dependencies"])
