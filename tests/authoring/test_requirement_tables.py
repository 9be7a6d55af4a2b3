"""The check of the tables of requirements: it reports each fault with its line and what to do."""

from pathlib import Path

import pytest

from workbook.authoring import requirements
from workbook.authoring.checking import check
from workbook.authoring.demands import untied_demands
from workbook.authoring.requirements import WITHOUT_TABLE, stale_exceptions, table_violations
from workbook.authoring.skeleton import new_exercise
from workbook.authoring.task_text import folded, missing_words, nearest_sentence
from workbook.authoring.tree import Tree

STEM = "21_beeps"
NAME = f"tests/requirements/{STEM}.toml"
TASK = """\
# A heart

It beats, and never
stops. Nothing else matters here.

| topic | type |
|---|---|
| `/robot/heart` | `Float32` |

- one message comes for each beat
"""


@pytest.fixture
def course(tmp_path: Path) -> Tree:
    """Create a course with one exercise from the skeleton, not built."""
    tree = Tree(tmp_path)
    new_exercise(tree, STEM)
    return tree


def table(course: Tree) -> Path:
    return course.requirements / f"{STEM}.toml"


def problems(tree: Tree) -> list[str]:
    """Return what the check reports about tables and exceptions."""
    return [str(one) for one in check(tree) if one.where.startswith(("tests/requirements/", "workbook/"))]


def change(path: Path, old: str, new: str) -> None:
    text = path.read_text(encoding="utf-8")
    assert old in text
    path.write_text(text.replace(old, new, 1), encoding="utf-8")


TOPIC = 'criteria = ["temperature_topic"]'
WRONG = 'wrong = ["wrong_name", "wrong_type"]'


@pytest.mark.parametrize(
    ("old", "new", "says"),
    [
        ("[[requirement]]", "[[requirement]", "3: is not TOML: Expected ']]'"),
        (
            "[[requirement]]",
            "[title]\n[[requirement]]",
            "3: unknown key 'title': a table holds [[requirement]] only",
        ),
        (
            "criteria =",
            "criterion =",
            "6: requirement 'topic': unknown key 'criterion' (did you mean 'criteria'?)",
        ),
        ('id = "topic"\n', "", "3: requirement 1 has no id: give it one"),
        ('id = "topic"', 'id = "The topic"', "4: the id 'The topic' must be small letters"),
        ('id = "topic"', "id = 1", "4: the id 1 must be small letters"),
        (
            'id = "rate"',
            'id = "topic"',
            "10: the id 'topic' is the id of requirement 1 as well: give each its own",
        ),
        (
            'wrong = ["no_timer", ',
            'wrong = ["wrong_type", "no_timer", ',
            "13: requirement 'rate': the wrong answer 'wrong_type' loses temperature_topic, and none of its criteria",
        ),
        (
            'sentence = "real sensors."',
            "sentence = []",
            "38: requirement 'out-of-scope': sentence must be a text",
        ),
        (
            'sentence = "real sensors."',
            'sentence = " "',
            "38: requirement 'out-of-scope': sentence must be a text",
        ),
        (
            "two messages come each",
            "three messages come each",
            "11: requirement 'rate': the task does not say 'three messages come each second: 1.6 to 2.4 Hz, and no gap "
            "above 0.75 s'; the nearest is '| 3 | two messages come each second: 1.6 to 2.4 Hz, and no gap above "
            "0.75 s |'",
        ),
        (
            '    "each temperature is from 20',
            '    "Robots dance on tables",\n    "each temperature is from 20',
            "19: requirement 'range': the task does not say 'Robots dance on tables', nor anything like it: "
            "quote its own words",
        ),
        (
            f"{TOPIC}\n{WRONG}\n",
            "",
            "4: nothing judges requirement 'topic'. Name its criteria",
        ),
        (
            f"{WRONG}\n",
            "",
            "6: requirement 'topic' has criteria and no wrong: name the wrong answers that break it",
        ),
        (f"{TOPIC}\n", "", "6: requirement 'topic' has wrong answers and no criteria: name the criteria"),
        (WRONG, "wrong = []", "7: requirement 'topic': wrong must be a list of names, at least one"),
        (TOPIC, 'criteria = "temperature_topic"', "6: requirement 'topic': criteria must be a list of names"),
        (
            WRONG,
            f'{WRONG}\nnot_judged = "Why."',
            "8: requirement 'topic' has not_judged and criteria and wrong: it is judged or it is not",
        ),
        (
            'not_judged = "The task says so itself."',
            'not_judged = " "',
            "39: requirement 'out-of-scope': not_judged ",
        ),
        (
            TOPIC,
            'criteria = ["temperature_topics"]',
            "6: requirement 'topic': there is no criterion 'temperature_topics' (did you mean 'temperature_topic'?); "
            "there are program_runs, temperature_topic, ",
        ),
        (
            WRONG,
            'wrong = [\n    "wrong_name",\n    "wrong_types",\n]',
            "9: requirement 'topic': there is no wrong answer 'wrong_types' (did you mean 'wrong_type'?); "
            "tests/wrong_answers/21_beeps/wrong_types.py is missing",
        ),
        (
            '"wrong_name", ',
            "",
            " the wrong answer 'wrong_name' belongs to no requirement: name it under `wrong` of the one it breaks",
        ),
    ],
)
def test_a_fault_of_a_table_is_told_once(course: Tree, old: str, new: str, says: str) -> None:
    change(table(course), old, new)
    [problem] = problems(course)
    assert problem.startswith(f"{NAME}:{says}")


def test_a_criterion_that_no_requirement_names_is_told(course: Tree) -> None:
    change(table(course), 'criteria = ["changes"]', 'criteria = ["in_range"]')
    assert problems(course) == [
        f"{NAME}:28: requirement 'changes': the wrong answer 'always_the_same' loses changes, and none of its "
        "criteria: it belongs to another requirement",
        f"{NAME}: the criterion 'changes' is worth 2 points, and no requirement names it: which sentence of the task "
        "does it judge?",
    ]


@pytest.mark.parametrize(
    ("text", "says"),
    [
        (b"", f"{NAME}: holds no [[requirement]]: write one for each demand of the task"),
        (b"requirement = 1\n", f"{NAME}:1: each requirement begins with the line [[requirement]]"),
        (b"\n[requirement]\nid = 'a'\n", f"{NAME}:2: each requirement begins with the line [[requirement]]"),
        (
            b"[[requirements]]\nid = 'a'\n",
            f"{NAME}:1: unknown key 'requirements': a table holds [[requirement]] only",
        ),
        (b"# \xff\n", f"{NAME}: is not UTF-8 (invalid start byte at byte 2): save it as UTF-8"),
    ],
)
def test_what_is_no_table_is_told(course: Tree, text: bytes, says: str) -> None:
    table(course).write_bytes(text)
    [problem] = problems(course)
    assert problem.startswith(says)


def test_a_missing_table_is_told(course: Tree) -> None:
    table(course).unlink()
    [problem] = problems(course)
    assert problem.startswith(f"{NAME}: is missing: write a [[requirement]] for each demand of the task")
    assert list(table_violations(course, STEM, None, without=frozenset({STEM}))) == []


def test_a_table_without_an_exercise_fits_nowhere(course: Tree) -> None:
    table(course).with_name("22_lights.toml").touch()
    assert problems(course) == [
        "tests/requirements/22_lights.toml: has no text: solutions/22_lights.py is missing"
    ]


def test_of_an_exercise_that_cannot_be_read_the_form_is_told(course: Tree) -> None:
    change(course.criteria / f"{STEM}.py", "import workbook", "import nothing")
    change(table(course), 'id = "rate"', 'id = "topic"')
    change(table(course), '"wrong_name", ', "")
    assert problems(course) == [
        f"{NAME}:10: the id 'topic' is the id of requirement 1 as well: give each its own"
    ]


def test_a_changed_task_asks_for_the_new_sentence(course: Tree) -> None:
    change(
        course.solutions / f"{STEM}.py",
        "# | 2 | the temperature changes |",
        "# | 2 | the temperature rises |",
    )
    assert problems(course) == [
        f"{NAME}:26: requirement 'changes': the task does not say 'the temperature changes'; "
        "the nearest is '| 2 | the temperature rises |'"
    ]


def test_of_another_course_nothing_is_said_about_exceptions(course: Tree) -> None:
    assert list(stale_exceptions(course, frozenset({"30_gone"}))) == []


def test_an_exception_that_is_none_is_told(course: Tree, monkeypatch: pytest.MonkeyPatch) -> None:
    module = course.root / "workbook" / "authoring" / "requirements.py"
    module.parent.mkdir(parents=True)
    module.write_text('WITHOUT_TABLE = {\n    "30_gone",\n    "21_beeps",\n}\n', encoding="utf-8")
    monkeypatch.setattr(requirements, "__file__", str(module))
    name = "workbook/authoring/requirements.py"
    assert [str(one) for one in stale_exceptions(course, frozenset({"30_gone", STEM}))] == [
        f"{name}:3: WITHOUT_TABLE names 21_beeps, which has a table now: delete it here",
        f"{name}:2: WITHOUT_TABLE names 30_gone, but there is no such exercise: delete it here",
    ]
    assert sum(words.startswith(f"{name}:") for words in problems(course)) == len(WITHOUT_TABLE)
    table(course).unlink()
    assert list(stale_exceptions(course, frozenset({STEM}))) == []


@pytest.mark.parametrize(
    ("quote", "says"),
    [
        (
            "It beats and never stops.",
            "'It beats and never stops.'; the nearest is 'It beats, and never stops.'",
        ),
        (
            "It beats, and never stops. Nobody waits.",
            "'Nobody waits.', nor anything like it: quote its own words",
        ),
        (
            "one message comes for every beat",
            "'one message comes for every beat'; the nearest is '- one message comes for each beat'",
        ),
        (
            "`/robot/heart` | `Float64`",
            "'`/robot/heart` | `Float64`'; the nearest is '| `/robot/heart` | `Float32` |'",
        ),
    ],
)
def test_the_nearest_sentence_is_named(quote: str, says: str) -> None:
    assert missing_words(quote, TASK) == f"the task does not say {says}"


def test_sentences_from_two_places_are_no_quotation() -> None:
    quote = "Nothing else matters here. It beats, and never stops."
    assert (
        missing_words(quote, TASK) == "the task has these sentences at different places: make a list of them"
    )


def test_a_sentence_may_run_over_lines() -> None:
    assert nearest_sentence("It never stops.", TASK) == "It beats, and never stops."
    assert "It beats, and never stops. Nothing else" in folded(TASK)


@pytest.mark.parametrize(
    ("sentence", "word"),
    [
        ("You may not edit the driver.", "may not"),
        ("The knee must cool down.", "must"),
        ("Do not poll.", "Do not"),
        ("Don't change the class.", "Don't"),
        ("Don’t change the class.", "Don't"),
        ("It can't wait.", "can't"),
        ("Change only `main`.", "only"),
        ("Write all of it in `main`.", "Write"),
    ],
)
def test_a_demand_that_no_requirement_quotes_is_told(course: Tree, sentence: str, word: str) -> None:
    story = "# somebody has to know in time."
    change(course.solutions / f"{STEM}.py", story, f"{story} {sentence}")
    [problem] = problems(course)
    assert problem.startswith(
        f"{NAME}: no requirement quotes the sentence {sentence!r}, which demands something"
    )
    assert f"({word!r})" in problem
    with table(course).open("a", encoding="utf-8") as file:
        file.write(f'\n[[requirement]]\nid = "told"\nsentence = "{sentence[:-1]}"\nnot_judged = "Why."\n')
    assert problems(course) == []


@pytest.mark.parametrize(
    "sentence", ["**Not judged:** you must not care.", "Mustard is yellow.", "Nothing else matters."]
)
def test_a_sentence_that_demands_nothing_needs_no_requirement(sentence: str) -> None:
    assert list(untied_demands(f"{TASK}\n{sentence}\n", [])) == []


def test_a_quotation_of_a_part_or_of_more_ties_a_sentence() -> None:
    task = "It beats. It must not stop, ever. It counts."
    for quote in ("must not\nstop", "It must not stop, ever.", "It beats. It must not stop, ever."):
        assert list(untied_demands(task, [quote])) == []
    assert list(untied_demands(task, ["It beats."])) == [("It must not stop, ever.", "must")]
