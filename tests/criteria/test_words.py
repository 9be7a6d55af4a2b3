"""Every verdict that isn't passed has its own cause."""

import ast
import importlib
import subprocess
import sys
from collections import Counter
from pathlib import Path

import pytest

import workbook.criteria as see
from tests.criteria.causes_in import ROOT, Source, exercises, is_cause, vocabulary
from workbook.criteria.rules import CatalogError
from workbook.criteria.vocabulary import stops

VOCABULARY = ROOT / "workbook" / "criteria" / "vocabulary"
FILES = (*vocabulary(), *exercises())


@pytest.mark.parametrize("path", FILES, ids=lambda path: path.stem)
def test_every_verdict_that_is_not_passed_names_its_cause_first(path: Path) -> None:
    """The cause is a literal, or it is passed on from the place of the literal."""
    for line, cause in Source(path).verdicts():
        handed_on = isinstance(cause, (ast.Name, ast.Attribute))
        literal = isinstance(cause, ast.Constant) and is_cause(cause.value)
        assert handed_on or literal, f'{path}:{line}: the first argument is no cause such as "rate.too-fast"'


@pytest.mark.parametrize("path", exercises(), ids=lambda path: path.stem)
def test_a_cause_stands_in_one_place(path: Path) -> None:
    """Each cause occurs once in an exercise and the vocabulary together, so each verdict can be identified."""
    named = [cause for one in (path, *vocabulary()) for cause in Source(one).causes()]
    assert not [cause for cause, times in Counter(named).items() if times > 1]


@pytest.mark.parametrize("path", exercises(), ids=lambda path: path.stem)
def test_exercises_use_the_face_of_the_vocabulary(path: Path) -> None:
    imported = {
        name
        for node in ast.walk(ast.parse(path.read_text(encoding="utf-8")))
        for name in (
            [alias.name for alias in node.names]
            if isinstance(node, ast.Import)
            else [node.module]
            if isinstance(node, ast.ImportFrom)
            else []
        )
    }
    assert {name for name in imported if name and name.startswith("workbook")} == {"workbook.criteria"}


@pytest.mark.parametrize("name", see.__all__)
def test_a_public_word_says_in_one_line_what_it_is(name: str) -> None:
    word = getattr(see, name)
    if not isinstance(word, float):  # a constant
        assert (word.__doc__ or "").splitlines()[0].endswith("."), name


@pytest.mark.parametrize(
    "cause", ["", "rate", "rate.", "Rate.fast", "rate.too_fast", "rate.too.fast", "-a.b"]
)
def test_what_is_no_cause_is_refused(cause: str) -> None:
    with pytest.raises(ValueError, match="a cause is named like"):
        see.failed(cause, "saw", "expected", "because", "try")


def test_a_passed_verdict_has_no_cause() -> None:
    assert see.passed("all is well").cause == ""


@pytest.mark.parametrize("catalog", sorted(VOCABULARY.glob("*.toml")), ids=lambda path: path.stem)
def test_each_catalog_of_the_vocabulary_is_opened_by_its_module(catalog: Path) -> None:
    module = importlib.import_module(f"workbook.criteria.vocabulary.{catalog.stem}")
    assert isinstance(module.WORDS, see.Words)
    assert module.WORDS.path == catalog


def test_importing_the_criteria_refuses_words_of_the_vocabulary_that_no_cause_uses(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    monkeypatch.setitem(stops.WORDS.entries, "signal.odd", {})
    with pytest.raises(CatalogError, match=r"stops\.toml.*signal\.odd"):
        importlib.reload(see)


NO_ROS = """
import sys

class NoRos:
    def find_spec(self, name, path=None, target=None):
        if name.split(".")[0] in ("rclpy", "rpyutils"):
            raise ModuleNotFoundError(f"{name} is kept away", name=name)

sys.meta_path.insert(0, NoRos())
from pathlib import Path
import workbook.criteria
from workbook.criteria.runner import run_criteria
from workbook.exercise.definition import load_exercise
from workbook.exercise.inconclusive import find_inconclusive_reason
from workbook.exercise.source import stems
from workbook.recording.recording import Recording

root = Path(sys.argv[1])
for stem in stems(root / "solutions"):
    exercise = load_exercise(stem, root)
    for path in sorted((root / "tests" / "recordings" / stem).glob("*.json")):
        recording = Recording.load(path)
        judged = run_criteria(exercise.criteria, recording)
        find_inconclusive_reason(judged, recording, exercise.plan, exercise.periods)
        print(stem, path.stem, sum(one.points for one in judged))
assert not {"rclpy", "rpyutils"} & sys.modules.keys()
"""


def test_a_stored_recording_is_judged_without_rclpy() -> None:
    done = subprocess.run(
        [sys.executable, "-c", NO_ROS, str(ROOT)], cwd=ROOT, capture_output=True, text=True, timeout=60
    )
    assert done.returncode == 0, done.stderr
    assert "09_joint_positions solution 10.0" in done.stdout
