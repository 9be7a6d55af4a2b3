"""The error museum: a lesson shows each known beginners' mistake, and the museum's pages match the lessons."""

from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

import pytest

from workbook.authoring.lesson_lists import note_run_times, run_times
from workbook.authoring.museum_pages import GLOSSARY, MUSEUM, museum_violations
from workbook.authoring.pages import LIST, pages
from workbook.authoring.tree import Tree
from workbook.exercise.museum import BrokenMuseum, Exhibit, Museum, Term, load_museum

ROOT = Path(__file__).resolve().parents[2]
TREE = Tree(ROOT)
MISTAKES = range(1, 49)
"""The numbers of the beginners' mistakes on which the course is built."""
IN_WORDS = {44: "13_qos_and_discovery_deeper"}
"""Mistakes that can't be provoked on one machine, so their lesson only describes them."""
LATER = {9: "15", 46: "16"}
"""Mistakes whose lesson isn't written yet."""


@pytest.fixture(scope="module")
def museum() -> Museum:
    return load_museum(ROOT)


def test_every_mistake_hangs_in_a_lesson(museum: Museum) -> None:
    covered: dict[int, set[str]] = {number: set() for number in MISTAKES}
    for exhibit in museum.exhibits:
        for number in exhibit.numbers:
            covered[number].add(exhibit.lesson)
    missing = [n for n, lessons in covered.items() if not lessons and n not in LATER and n not in IN_WORDS]
    assert not missing, f"no lesson shows the mistakes {missing}"
    shown_after_all = [number for number in LATER if covered[number]]
    assert not shown_after_all, "take them out of LATER"


def test_what_cannot_be_provoked_is_told(museum: Museum) -> None:
    text = (TREE.sources / f"{IN_WORDS[44]}.py").read_text(encoding="utf-8")
    assert "/dev/shm" in text and "container" in text and "workbook doctor" in text


def test_what_an_exhibit_shows_is_what_its_cell_shows(museum: Museum) -> None:
    assert list(museum_violations(TREE, museum)) == []


def test_a_cell_that_shows_something_else_is_found(museum: Museum) -> None:
    good = museum.exhibits[0]
    other = Exhibit(good.lesson, (1,), "x", "a text that no cell prints", good.cell, "x", "x")
    lost = Exhibit(good.lesson, (1,), "x", good.shows, "no-such-cell", "x", "x")
    twice = (Term("05_timers", "Timer", "x"), Term("06_spinning", "timer", "x"))
    found = [words for _, words in museum_violations(TREE, Museum((other, lost), twice))]
    assert len(found) == 3
    assert "does not show" in found[0]
    assert "no code cell 'no-such-cell'" in found[1]
    assert "explained in 05_timers already" in found[2]


def test_an_error_leads_to_its_exhibit(museum: Museum) -> None:
    exhibit = museum.exhibit_for(
        "line 3: RCLError: failed to shutdown: rcl_shutdown already called on the given context"
    )
    assert exhibit is not None
    assert 24 in exhibit.numbers
    assert museum.exhibit_for("0.6 Hz on /robot/status") is None


def test_the_longest_sign_wins() -> None:
    general = Exhibit("01_a", (), "general", "TypeError: something", "c", "", "")
    special = Exhibit("02_b", (), "special", "TypeError: something else", "c", "", "")
    short = Exhibit("03_c", (), "short", "error", "c", "", "")
    found = Museum((general, special, short), ()).exhibit_for("TypeError: something else happened")
    assert found is special


@pytest.mark.parametrize("text", ["[[mistake]", '[[mistake]]\nsymptom = "no more"\n', "mistake = 7\n"])
def test_a_damaged_file_is_named(tmp_path: Path, text: str) -> None:
    folder = tmp_path / "notebooks" / "sources" / "museum"
    folder.mkdir(parents=True)
    (folder / "05_timers.toml").write_text(text)
    with pytest.raises(BrokenMuseum, match=r"05_timers\.toml"):
        load_museum(tmp_path)


def test_the_pages_hold_every_exhibit_term_and_lesson(museum: Museum) -> None:
    made = {path.name: text for path, text in pages(TREE).items() if path.parent == TREE.notebooks}
    for exhibit in museum.exhibits:
        assert exhibit.symptom in made[MUSEUM]
        assert exhibit.fix in made[MUSEUM]
    for term in museum.terms:
        assert f"**{term.name}**" in made[GLOSSARY]
    for stem in TREE.lesson_stems():
        assert f"({stem}.ipynb)" in made[LIST]
    for stem in TREE.exercise_stems():
        assert f"(../exercises/{stem}.ipynb)" in made[LIST]


def test_run_times_are_rounded_and_old_lessons_forgotten(tmp_path: Path) -> None:
    tree = Tree(tmp_path)
    tree.sources.mkdir(parents=True)
    for stem in ("05_timers", "06_spinning"):
        (tree.sources / f"{stem}.py").write_text("")
    note_run_times(tree, {"05_timers": 31.4, "06_spinning": 1.0, "07_gone": 9.0})
    assert run_times(tree) == {"05_timers": 30, "06_spinning": 5}
    note_run_times(tree, {"06_spinning": 12.6})
    assert run_times(tree) == {"05_timers": 30, "06_spinning": 15}


def test_lessons_that_end_together_all_keep_their_times(tmp_path: Path) -> None:
    tree = Tree(tmp_path)
    tree.sources.mkdir(parents=True)
    stems = [f"{number:02}_lesson" for number in range(40)]
    for stem in stems:
        (tree.sources / f"{stem}.py").write_text("")
    with ThreadPoolExecutor(len(stems)) as pool:
        list(pool.map(lambda stem: note_run_times(tree, {stem: 5.0}), stems))
    assert run_times(tree) == dict.fromkeys(stems, 5)
