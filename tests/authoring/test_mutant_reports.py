"""Judge mutants and report on them. The report names what a weak criterion accepts, and no mutant is judged twice."""

from collections.abc import Iterator, Sequence
from pathlib import Path

import pytest

from tests.criteria.by_hand import every, on_topic, recorded
from workbook.authoring.mutants.judged import Cache, Marks
from workbook.authoring.mutants.report import Free, Report, Survivor, read_report, write_report
from workbook.authoring.mutants.running import report_mutants, report_path
from workbook.authoring.mutants.staleness import lost_mutants, outdated_reports
from workbook.authoring.tree import AuthoringError, Tree
from workbook.exercise.answers import Answer
from workbook.exercise.definition import load_exercise
from workbook.exercise.judgement import Judgement, judge_recording
from workbook.grading.judges import Job

ROOT = Path(__file__).resolve().parents[2]
STEM = "20_levels"
SOLUTION = """
# ---
# exercise: 20_levels
# title: Levels
# minutes: 5
# difficulty: 1
# kind: program
# clock: simulated
# objectives: [one]
# out_of_scope: [two]
# ---
# %% [markdown]
# # Levels
# %% [answer]
# [solution]
for level in READINGS:
    if 0.0 <= level <= 100.0:
        publish(level)
# [starter]
# | pass
# [end]
# %% [hint]
# One.
# %% [hint]
# Two.
# %% [hint]
# Three.
# %% [alternatives]
# Many.
""".lstrip()
RIGHT = """
ours = [level for level in READINGS if not (level < 0.0 or level > 100.0)]
for level in ours:
    publish(level)
"""
CRITERIA = """
from std_msgs.msg import Float32

import workbook.criteria as see
from workbook.criteria import Recording, Verdict, criterion, topic

LEVEL = topic("/level", Float32)


@criterion(points=10, title="Good levels only")
def good(recording: Recording) -> Verdict:
    if see.values(recording, LEVEL) != {wanted}:
        return see.failed("good.others", "others", "the good ones", "a reason", "a hint")
    return see.passed("all there")
"""
READINGS = [0.0, 50.0, 100.0, -3.0, 101.0, 50.0]
GOOD = [0.0, 50.0, 100.0, 50.0]
WEAK_READINGS = [50.0, -3.0]
"""Neither the limits nor any value above them, so the judge can't test half of the rule."""


class PlainJudge:
    """Runs a program in this process, with what its criteria need, and keeps a list of the judged programs."""

    def __init__(self, tree: Tree, readings: Sequence[float]) -> None:
        self.judged: list[str] = []
        self._tree, self._readings = tree, readings

    def __call__(self, jobs: Sequence[Job[str]]) -> Iterator[tuple[Job[str], Judgement]]:
        exercise = load_exercise(STEM, self._tree.root)
        for job in jobs:
            self.judged.append(job.key)
            said: list[float] = []
            try:
                exec(job.answer.text, {"READINGS": self._readings, "publish": said.append})
            except Exception:
                said = []
            recording = recorded(on_topic("/level", times=every(0.1, len(said)), values=said))
            yield job, judge_recording(exercise, job.answer.sha256, recording)


@pytest.fixture
def tree(tmp_path: Path) -> Tree:
    tree = Tree(tmp_path)
    for folder in (tree.solutions, tree.criteria, tree.right_answers / STEM):
        folder.mkdir(parents=True)
    (tree.solutions / f"{STEM}.py").write_text(SOLUTION, encoding="utf-8")
    (tree.right_answers / STEM / "lists.py").write_text(RIGHT, encoding="utf-8")
    demand(tree, GOOD)
    return tree


def demand(tree: Tree, wanted: Sequence[float]) -> None:
    """Write criteria that require these levels."""
    text = CRITERIA.replace("{wanted}", repr(list(wanted)))
    (tree.criteria / f"{STEM}.py").write_text(text, encoding="utf-8")


def run(
    tree: Tree, readings: Sequence[float] = READINGS, **options: int
) -> tuple[Report, PlainJudge, list[str]]:
    judge, said = PlainJudge(tree, readings), list[str]()
    [report] = report_mutants(tree, [STEM], judge, most=options.get("most", 500), say=said.append)
    return report, judge, said


def changes(report: Report) -> set[str]:
    return {one.after for one in report.survivors if one.base == "solution"}


def test_a_weak_judge_is_found_out(tree: Tree) -> None:
    strong, _, _ = run(tree)
    demand(tree, [50.0])
    weak, _, said = run(tree, WEAK_READINGS)
    border = {"if 0.0 <= level < 100.0:", "if 0.0 < level <= 100.0:", "if 0.0 <= level:"}
    assert not changes(strong) & border
    assert changes(weak) >= border
    assert "if level <= 100.0:" not in changes(weak), "it does say -3"
    assert any("if 0.0 <= level:" in line for line in said)
    assert "not looked at" in said[-1]
    assert strong.survived < weak.survived


def test_the_counts_add_up_and_the_file_holds_them(tree: Tree) -> None:
    report, judge, _ = run(tree)
    assert report.judged == report.killed + report.accepted + report.survived == report.made
    assert len(judge.judged) == report.made + 2  # the solution and the right answer themselves
    assert report.killed_by == {"good": report.killed}
    assert report.right == ("lists.py",)
    assert read_report(report_path(tree, STEM)) == report


def test_fewer_are_judged_when_told_so(tree: Tree) -> None:
    report, _, _ = run(tree, most=10)
    assert report.judged == 10 < report.made


def test_nothing_is_judged_twice_until_program_or_criteria_change(tree: Tree) -> None:
    first, judge, _ = run(tree)
    again, idle, _ = run(tree)
    assert again == first
    assert judge.judged and not idle.judged
    path = tree.right_answers / STEM / "lists.py"
    path.write_text(RIGHT.replace("ours", "mine"), encoding="utf-8")
    changed, some, _ = run(tree)
    assert 0 < len(some.judged) < len(judge.judged)
    assert all(one == "right/lists.py" or one not in {s.id for s in first.survivors} for one in some.judged)
    (tree.criteria / f"{STEM}.py").open("a").write("# other\n")
    _, all_again, _ = run(tree)
    assert len(all_again.judged) == changed.judged + 2


def test_a_torn_line_of_the_cache_is_judged_again(tmp_path: Path) -> None:
    path = tmp_path / "cache.jsonl"
    one, other = Answer("a = 1\n"), Answer("a = 2\n")
    cache = Cache(path, "judge")
    cache.put(one, Marks(("rate",), "rate.slow"))
    cache.put(other, Marks(()))
    path.write_text(path.read_text(encoding="utf-8")[:-20], encoding="utf-8")
    assert Cache(path, "judge").get(one) == Marks(("rate",), "rate.slow")
    assert Cache(path, "judge").get(other) is None
    assert Cache(path, "another judge").get(one) is None


def test_reasons_are_kept_and_count(tree: Tree) -> None:
    demand(tree, [50.0])
    report, _, _ = run(tree, WEAK_READINGS)
    path = report_path(tree, STEM)
    first, second = report.survivors[:2]
    text = path.read_text(encoding="utf-8")
    for one, reason in ((first, "accepted: as good"), (second, "hole: never said")):
        before = text[text.index(one.id) :]
        text = text.replace(before, before.replace('reason = ""', f'reason = "{reason}"', 1))
    path.write_text(text, encoding="utf-8")
    after, _, said = run(tree, WEAK_READINGS)
    assert {one.id: one.reason for one in after.survivors if one.reason} == {
        first.id: "accepted: as good",
        second.id: "hole: never said",
    }
    assert (after.accepted, after.survived) == (report.accepted + 1, report.survived - 1)
    assert "1 holes" in said[-1]


def test_a_free_place_accepts_what_survives_there(tree: Tree) -> None:
    demand(tree, [50.0])
    report, _, _ = run(tree, WEAK_READINGS)
    free = Free("any border", code="if 0.0 <= level*", operators=("compare",), base="solution")
    write_report(Report(STEM, free=(free,)), report_path(tree, STEM))
    after, _, _ = run(tree, WEAK_READINGS)
    assert after.free == (free,)
    gone = {one.id for one in report.survivors} - {one.id for one in after.survivors}
    assert len(gone) == after.accepted_as["any border"] > 0
    assert all(one.operator == "compare" for one in report.survivors if one.id in gone)


def test_a_right_program_that_is_not_right_here_proves_nothing(tree: Tree) -> None:
    demand(tree, [1.0])
    with pytest.raises(AuthoringError, match="solution loses good"):
        run(tree)
    assert not report_path(tree, STEM).exists()


def test_a_report_is_out_of_date_when_its_inputs_change(tree: Tree) -> None:
    run(tree)
    assert not list(outdated_reports(tree)) and not list(lost_mutants(tree))
    demand(tree, [50.0])
    [note] = outdated_reports(tree)
    assert "criteria" in note.words and "--only 20" in note.words
    assert not list(lost_mutants(tree))


def test_a_report_that_names_mutants_of_another_program_is_a_failure(tree: Tree) -> None:
    demand(tree, [50.0])
    report, _, _ = run(tree, WEAK_READINGS)
    assert any(one.base == "solution" for one in report.survivors)
    path = tree.solutions / f"{STEM}.py"
    path.write_text(SOLUTION.replace("100.0", "HIGHEST"), encoding="utf-8")
    found = list(lost_mutants(tree))
    assert found and all("cannot be made any more" in one.words for one in found)
    lost = {one.id for one in report.survivors if any(one.id in violation.words for violation in found)}
    assert all(one.base == "solution" and "100.0" in one.before for one in report.survivors if one.id in lost)


@pytest.mark.slow
@pytest.mark.whole
def test_the_reports_of_this_course_name_only_mutants_that_can_be_made() -> None:
    assert not list(lost_mutants(Tree(ROOT)))


def test_what_is_no_report_is_said(tree: Tree) -> None:
    path = report_path(tree, STEM)
    path.parent.mkdir(parents=True)
    path.write_text("exercise = \n", encoding="utf-8")
    [violation] = lost_mutants(tree)
    assert violation.where == f"tests/mutants/{STEM}.toml"
    assert not list(outdated_reports(tree))


def test_a_survivor_with_quotes_and_breaks_comes_back(tmp_path: Path) -> None:
    one = Survivor("ab", "solution", "text", "Robot.tick", 'say("a\\n")', 'say("") ⏎ x', "")
    report = Report(STEM, survivors=(one,), inputs={"right/a.py": "1"}, free=(Free("why", code='say("*'),))
    write_report(report, tmp_path / "one.toml")
    assert read_report(tmp_path / "one.toml") == report
