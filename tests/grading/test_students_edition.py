"""`workbook package students`: the students' edition contains no solution, and it works."""

import hashlib
import json
import os
import re
import subprocess
import sys
import zipfile
from pathlib import Path

import pytest

from workbook.cli.main import main
from workbook.exercise.source import load
from workbook.exercise.source import stems as stems_in
from workbook.grading.packaging import CannotPackage
from workbook.grading.students_edition import for_students, students_edition

ROOT = Path(__file__).resolve().parents[2]
STEMS = stems_in(ROOT / "solutions")
IN_A_ROW = 4
_CODE = re.compile(r"^ *```.*?^ *```|`[^`\n]*`", re.DOTALL | re.MULTILINE)
_LINK = re.compile(r"\]\((?P<target>[^)\s]+)\)")


@pytest.fixture(scope="module")
def edition(tmp_path_factory: pytest.TempPathFactory) -> Path:
    folder = tmp_path_factory.mktemp("edition") / "course"
    students_edition(ROOT, folder)
    return folder


def texts(edition: Path) -> dict[str, str]:
    return {
        path.relative_to(edition).as_posix(): path.read_text(encoding="utf-8")
        for path in edition.rglob("*")
        if path.suffix in (".py", ".md", ".ipynb", ".toml", ".json", ".txt", "") and path.is_file()
    }


@pytest.mark.parametrize("stem", STEMS)
def test_an_exercise_is_all_there_but_its_solution(stem: str, edition: Path) -> None:
    whole = load(ROOT / "solutions" / f"{stem}.py")
    given = load(edition / "solutions" / f"{stem}.py")
    assert whole.has_solution and not given.has_solution
    assert given.solution_code == given.starter_code == whole.starter_code
    for name in ("title", "kind", "clock", "story", "afterword", "live", "hints", "objectives"):
        assert getattr(given, name) == getattr(whole, name), name
    assert given.alternatives == "None."


def test_every_catalog_of_words_is_there(edition: Path) -> None:
    for folder in ("exercises/criteria", "workbook/criteria/vocabulary"):
        catalogs = {path.name: path.read_bytes() for path in (ROOT / folder).glob("*.toml")}
        assert catalogs
        assert {path.name: path.read_bytes() for path in (edition / folder).glob("*.toml")} == catalogs


def stripped(text: str) -> str:
    return "\n".join(line.strip() for line in text.splitlines() if line.strip())


def test_no_file_holds_a_solution(edition: Path) -> None:
    """A file may not contain four consecutive lines that a student has to write, unless a lesson shows them."""
    shown = [
        stripped(path.read_text(encoding="utf-8"))
        for folder in ("lesson_nodes", "notebooks/sources")
        for path in (ROOT / folder).glob("*.py")
    ]
    everything = {name: stripped(text) for name, text in texts(edition).items()}
    searched = set()
    for stem in STEMS:
        source = load(ROOT / "solutions" / f"{stem}.py")
        known = [*shown, stripped(source.starter_code)]
        lines = stripped(source.solution_code).splitlines()
        for at in range(len(lines) - IN_A_ROW + 1):
            run = "\n".join(lines[at : at + IN_A_ROW])
            if not any(run in text for text in known):
                searched.add(stem)
                assert not [name for name, text in everything.items() if run in text], run
    assert searched == set(STEMS)


def test_what_only_instructors_and_authors_need_stays_at_home(edition: Path) -> None:
    names = set(texts(edition))
    assert [name for name in names if name.startswith("tests/")] == ["tests/test_course.py"]
    assert not [name for name in names if name.startswith(("notebooks/sources/", ".github/", ".ci/"))]
    assert not {"CONTRIBUTING.md", "exercises/README.md"} & names
    assert not [
        name for name, text in texts(edition).items() if name.endswith(".md") and "for instructors" in text
    ]


def test_every_link_leads_somewhere(edition: Path) -> None:
    dead = []
    for name, text in texts(edition).items():
        if name.endswith(".ipynb"):
            cells = json.loads(text)["cells"]
            text = "\n".join("".join(one["source"]) for one in cells if one["cell_type"] == "markdown")
        elif not name.endswith(".md"):
            continue
        for link in _LINK.finditer(_CODE.sub("", text)):
            target = link["target"].partition("#")[0]
            if "." in target and ":" not in target and not (edition / name).parent.joinpath(target).exists():
                dead.append((name, link["target"]))
    assert not dead


@pytest.mark.whole
def test_its_own_tests_pass(edition: Path) -> None:
    """Run the tests of two exercises and of this machine. `make test` in the edition runs all, and every lesson."""
    environment = {k: v for k, v in os.environ.items() if not k.startswith(("PYTEST_", "WORKBOOK_"))}
    done = subprocess.run(
        [sys.executable, "-m", "pytest", "-q", "-k", "ready or 09_ or 07_", "tests"],
        cwd=edition,
        env=environment | {"PYTHONPATH": str(edition)},
        capture_output=True,
        text=True,
        check=False,
    )
    assert done.returncode == 0, done.stdout[-2000:]
    assert "3 passed" in done.stdout


def test_the_makefile_offers_what_is_there(edition: Path) -> None:
    done = subprocess.run(["make", "help"], cwd=edition, capture_output=True, text=True, check=True)
    assert re.findall(r"make (\S+)", done.stdout) == ["help", "env", "lab", "progress", "test", "clean"]
    said = subprocess.run(["make", "-n", "test"], cwd=edition, capture_output=True, text=True, check=True)
    assert "-m pytest --nbval tests notebooks" in said.stdout
    assert re.search(r"--extras dev$", said.stdout, re.MULTILINE), "the tools of authors and instructors"
    assert "check that everything works here" in done.stdout


@pytest.mark.whole
def test_a_zip_holds_the_same_and_the_same_course_gives_the_same_bytes(edition: Path, tmp_path: Path) -> None:
    first, second = tmp_path / "one" / "course.zip", tmp_path / "two" / "course.zip"
    students_edition(ROOT, first)
    students_edition(ROOT, second)
    assert first.read_bytes() == second.read_bytes()
    with zipfile.ZipFile(first) as archive:
        assert archive.read("course/README.md") == (edition / "README.md").read_bytes()
        packed = {name.removeprefix("course/") for name in archive.namelist()}
    assert packed == set(json.loads((edition / ".edition.json").read_text(encoding="utf-8")))


def test_an_earlier_edition_is_brought_up_to_date_and_nothing_else_is_touched(tmp_path: Path) -> None:
    folder = tmp_path / "course"
    students_edition(ROOT, folder)
    (folder / ".git").mkdir()
    (folder / "notes.txt").write_text("ours")
    manifest = folder / ".edition.json"
    files = json.loads(manifest.read_text())
    (folder / "old.md").write_text("gone")
    files["old.md"] = hashlib.sha256(b"gone").hexdigest()
    files["../outside.md"] = files["old.md"]
    (tmp_path / "outside.md").write_text("gone")
    manifest.write_text(json.dumps(files))
    assert students_edition(ROOT, folder).removed == ("old.md",)
    assert (folder / "notes.txt").read_text() == "ours" and (tmp_path / "outside.md").is_file()
    (folder / "README.md").write_text("changed by hand")
    with pytest.raises(CannotPackage, match=r"README\.md"):
        students_edition(ROOT, folder)
    assert (folder / "README.md").read_text() == "changed by hand"


def test_a_folder_with_other_things_is_refused(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    (tmp_path / "thesis.txt").write_text("mine")
    assert main(["package", "students", "--out", str(tmp_path)]) == 2
    assert "not part of a students' edition" in capsys.readouterr().err
    assert [one.name for one in tmp_path.iterdir()] == ["thesis.txt"]


def test_what_stands_between_the_marks_goes() -> None:
    begin, end = "<!-- for instructors -->", "<!-- end of for instructors -->"
    page = f"a\n{begin}\nsecret\n{end}\n\nb\n| row | {begin} |\nc\n"
    assert for_students(page) == "a\nb\nc\n"
