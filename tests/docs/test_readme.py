"""The README mentions only commands, links, lessons, and images that exist."""

import json
import re
import struct
import subprocess
import sys
import tomllib
from pathlib import Path

import pytest

from workbook.cli.main import build_parser

ROOT = Path(__file__).resolve().parents[2]
PAGES = ("README.md", "environment.md", "CONTRIBUTING.md", "exercises/README.md", "exercises/teaching.md")
ALL_PAGES = (
    *PAGES,
    "SECURITY.md",
    "CHANGELOG.md",
    *(f"docs/{path.name}" for path in sorted((ROOT / "docs").glob("*.md"))),
)
LARGEST_PICTURE = 300_000
MOST_LINES = 90
_LINK = re.compile(r"(?P<picture>!?)\[(?P<text>[^\]]*)\]\((?P<target>[^)\s]+)\)")
_ROW = re.compile(r"^\| (?P<number>\d\d) \| (?P<lesson>.+?) \| (?P<exercise>.*?) ?\|$", re.MULTILINE)


def page(name: str) -> str:
    return (ROOT / name).read_text(encoding="utf-8")


def targets(text: str) -> set[str]:
    return set(re.findall(r"^([a-z-]+):", text, re.MULTILINE))


def commands(text: str) -> str:
    """Return all code on a page: spans, fences, and indented lines."""
    prose = re.sub(
        r"^```.*?^```", lambda fence: f"`{fence[0].strip('`')}`", text, flags=re.MULTILINE | re.DOTALL
    )
    return "\n".join(re.findall(r"`([^`]+)`", prose) + re.findall(r"^ {4}(.*)$", prose, re.MULTILINE))


def anchors(text: str) -> set[str]:
    """Return the anchors that a code-hosting site generates from the headings."""
    found = re.findall(r"^#+ (.*)$", text, re.MULTILINE)
    return {re.sub(r"[^\w\- ]", "", heading.lower()).replace(" ", "-") for heading in found}


def title(notebook: Path) -> str:
    first = json.loads(notebook.read_text(encoding="utf-8"))["cells"][0]["source"]
    heading = ("".join(first) if isinstance(first, list) else first).split("\n")[0]
    return heading.partition(" · ")[2]


def rows() -> list[re.Match[str]]:
    return list(_ROW.finditer(page("README.md")))


@pytest.mark.parametrize("name", PAGES)
def test_each_make_command_is_in_the_makefile(name: str) -> None:
    named = set(re.findall(r"(?:^|&& *)make ([a-z][a-z-]*)", commands(page(name)), re.MULTILINE))
    assert named, "the page names no command: is the pattern still right?"
    assert named <= targets(page("Makefile"))


@pytest.mark.parametrize("name", [*PAGES, "docs/commands.md"])
def test_each_workbook_command_is_one(name: str) -> None:
    named = set(re.findall(r"(?:^|/|pixi run )workbook ([a-z]+)", commands(page(name)), re.MULTILINE))
    assert named, "the page names no command: is the pattern still right?"
    usage = build_parser().format_help()
    assert not {word for word in named if not re.search(rf"^    {word}\b", usage, re.MULTILINE)}


@pytest.mark.parametrize("name", ALL_PAGES)
def test_each_link_leads_somewhere(name: str) -> None:
    links = list(_LINK.finditer(re.sub(r"`[^`]*`", "", page(name))))
    assert links or name not in PAGES
    for link in links:
        target, _, anchor = link["target"].partition("#")
        if target.startswith(("http://", "https://")):
            continue
        here = ROOT / name
        path = here.parent / target if target else here
        assert path.exists(), f"{link[0]} leads nowhere"
        if anchor:
            assert anchor in anchors(path.read_text(encoding="utf-8")), f"{link[0]}: no such heading"


def test_the_table_has_every_lesson_once() -> None:
    numbers = [int(row["number"]) for row in rows()]
    assert numbers
    assert numbers == list(range(len(numbers)))


@pytest.mark.parametrize("folder", ["notebooks", "exercises"])
def test_the_table_links_every_notebook_that_is_there(folder: str) -> None:
    there = {path.name for path in (ROOT / folder).glob("[0-9]*.ipynb")}
    promised = set(re.findall(rf"\({folder}/([^)]+\.ipynb)\)", page("README.md")))
    assert promised == there


def test_a_row_links_the_lesson_and_the_exercise_of_its_number_and_title() -> None:
    for row in rows():
        link = _LINK.match(row["lesson"])
        assert link, row[0]
        assert link["target"].startswith(f"notebooks/{row['number']}_")
        assert link["text"] == title(ROOT / link["target"])
        exercise = _LINK.fullmatch(row["exercise"])
        if exercise:
            assert exercise["target"].startswith(f"exercises/{row['number']}_")
            assert exercise["text"] == title(ROOT / exercise["target"])


def test_the_readme_is_read_in_two_screens() -> None:
    assert len(page("README.md").splitlines()) <= MOST_LINES


def pictures() -> dict[Path, str]:
    """Return the images on pages, and their alt texts."""
    links = [(ROOT / name, link) for name in ALL_PAGES for link in _LINK.finditer(page(name))]
    return {(path.parent / link["target"]).resolve(): link["text"] for path, link in links if link["picture"]}


def test_pictures_are_small_and_described() -> None:
    shown = pictures()
    assert ROOT / "docs" / "robot.png" in shown
    for path, words in shown.items():
        content = path.read_bytes()
        assert content.startswith(b"\x89PNG\r\n\x1a\n")
        assert len(content) < LARGEST_PICTURE
        width, height = struct.unpack(">II", content[16:24])
        moves = b"acTL" in content[:2000]
        assert (width >= 300 and height >= 300) if moves else (width >= 1000 and height >= 500)
        assert len(words.split()) > 5, "a picture needs words for those who cannot see it"
    files = [path for path in (ROOT / "docs").rglob("*") if path.is_file() and path.suffix != ".md"]
    assert set(files) == set(shown), "docs/ holds what no page shows"


def test_nothing_is_left_open() -> None:
    text = page("README.md")
    assert not re.search(r"TODO|ADDRESS-OF|<[a-z-]+>|\bXXX\b|@@|example\.com", text)
    assert not re.search(r"(?<![\w.])/(?:home|root|work|tmp|Users)/", text)
    assert not re.search(r"https?://", text), "the README needs no address of a server"


def test_it_names_the_versions_of_python_that_the_project_takes() -> None:
    project = tomllib.loads(page("pyproject.toml"))["project"]
    assert project["readme"] == "README.md"
    named = {int(minor) for minor in re.findall(r"\b3\.(\d\d)\b", page("README.md"))}
    lowest, highest = map(int, re.fullmatch(r">=3\.(\d+),<3\.(\d+)", project["requires-python"]).groups())  # type: ignore[union-attr]
    assert named == set(range(lowest, highest))


def test_the_options_that_instructors_are_told_of_exist() -> None:
    page = (ROOT / "exercises" / "README.md").read_text(encoding="utf-8")
    workbook = str(Path(sys.executable).with_name("workbook"))
    told = {
        command: subprocess.run(
            [workbook, *command.split(), "--help"], capture_output=True, text=True, check=True
        ).stdout
        for command in ("grade", "package gradescope", "package github", "replay", "student erase")
    }
    for option in set(re.findall(r"`(--[a-z-]+)", page)):
        assert any(option in text for text in told.values()), option
    for command, options in re.findall(r"^workbook (grade|package \w+) (.*)$", page, re.MULTILINE):
        for option in re.findall(r"--[a-z-]+", options):
            assert option in told[command], f"{command} {option}"
