"""An inconclusive answer is tried once more: both tries are kept, told of, and nobody loses points by it."""

import csv
import json
from collections.abc import Iterator, Sequence
from dataclasses import replace
from pathlib import Path
from typing import Any

import pytest

from workbook.cli.main import main
from workbook.exercise.answers import Answer
from workbook.exercise.conclusiveness import END_OVERTAKEN, EXCUSED_ENDS
from workbook.exercise.definition import load_exercise
from workbook.exercise.judgement import Judgement, judge_recording, judgement_as_provisional
from workbook.exercise.serialization import judgement_from_json, judgement_to_json
from workbook.feedback.card import as_html
from workbook.feedback.text import as_text
from workbook.grading import local
from workbook.grading.judges import Job
from workbook.grading.regrade import regrade
from workbook.grading.results_file import last_results, read_results
from workbook.grading.retries import counting, judge_until_sure, until_sure
from workbook.recording.recording import Recording

ROOT = Path(__file__).resolve().parents[2]
STEM = "09_joint_positions"
EXERCISE = load_exercise(STEM, ROOT)
DOUBT = "this machine was so busy that the judge itself had to wait for 0.80 s"


def judgement(recording: str, doubt: str = "") -> Judgement:
    stored = Recording.load(ROOT / "tests" / "recordings" / STEM / f"{recording}.json")
    return replace(judge_recording(EXERCISE, "a" * 64, stored), doubt=doubt)


GOOD, POOR = judgement("solution"), judgement("period_for_frequency")
DOUBTFUL = judgement("period_for_frequency", DOUBT)
LOST = Judgement(STEM, "a" * 64, "infra_error", "the slot is gone", (), None)


@pytest.mark.parametrize(
    ("tries", "counts"),
    [
        ((DOUBTFUL, GOOD), 1),
        ((DOUBTFUL, POOR), 1),
        ((DOUBTFUL, replace(POOR, doubt="again")), 1),
        ((DOUBTFUL, judgement("wrong_name")), 0),
        ((DOUBTFUL, LOST), 0),
        ((GOOD,), 0),
    ],
    ids=["better", "same and sound", "same and doubtful", "worse", "not judged", "one try"],
)
def test_the_better_try_counts_and_of_equal_ones_the_sound_one(
    tries: tuple[Judgement, ...], counts: int
) -> None:
    assert counting(tries) is tries[counts]


def test_only_what_is_in_doubt_is_tried_again_and_after_all_others() -> None:
    rounds: list[list[str]] = []

    def judge(jobs: Sequence[Job[str]]) -> Iterator[tuple[Job[str], Judgement]]:
        rounds.append([job.key for job in jobs])
        for job in jobs:
            yield job, DOUBTFUL if job.key == "doubtful" else POOR

    jobs = [Job(name, STEM, Answer("x = 1\n")) for name in ("doubtful", "poor", "poor too")]
    found = {job.key: len(tries) for job, tries in judge_until_sure(jobs, judge)}
    assert rounds == [["doubtful", "poor", "poor too"], ["doubtful"]]
    assert found == {"poor": 1, "poor too": 1, "doubtful": 2}


def test_a_run_that_is_stopped_before_the_second_try_leaves_the_answer_to_the_next() -> None:
    rounds = 0

    def judge(jobs: Sequence[Job[str]]) -> Iterator[tuple[Job[str], Judgement]]:
        nonlocal rounds
        rounds += 1
        if rounds == 1:
            yield from ((job, DOUBTFUL) for job in jobs)

    assert list(judge_until_sure([Job("one", STEM, Answer("x = 1\n"))], judge)) == []
    assert rounds == 2


EXCUSED = replace(
    DOUBTFUL,
    criteria=(
        replace(DOUBTFUL.criteria[-1], status="failed", points=0.0, cause=END_OVERTAKEN),
        *DOUBTFUL.criteria[:-1],
    ),
)


@pytest.mark.parametrize(
    ("judged", "how_many", "counts"),
    [
        ((EXCUSED, GOOD), 2, 1),
        ((EXCUSED, EXCUSED, GOOD), 3, 2),
        ((EXCUSED, POOR), 2, 1),
        ((EXCUSED, DOUBTFUL), 2, 1),
        ((DOUBTFUL, EXCUSED), 2, 0),
        ((EXCUSED, EXCUSED, EXCUSED), 3, 2),
    ],
)
def test_an_end_that_rclpy_may_have_spoiled_is_watched_up_to_three_times(
    judged: tuple[Judgement, ...], how_many: int, counts: int
) -> None:
    """An answer can print what rclpy prints, so it is not forgiven; what it shows at every end is no doubt any more."""
    rounds = 0

    def judge(jobs: Sequence[Job[str]]) -> Iterator[tuple[Job[str], Judgement]]:
        nonlocal rounds
        rounds += 1
        for job in jobs:
            yield job, judged[rounds - 1]

    [(_, tries)] = judge_until_sure([Job("one", STEM, Answer("x = 1\n"))], judge)
    assert len(tries) == rounds == how_many
    assert counting(tries) is tries[counts]
    always = how_many == 3 and judged[-1] is EXCUSED
    assert tries[-1].doubt == ("" if always else judged[-1].doubt)
    assert tries[-1].score == judged[-1].score


@pytest.mark.parametrize("cause", sorted(EXCUSED_ENDS))
def test_a_student_who_checks_gets_three_tries_for_such_an_end(cause: str) -> None:
    excused = replace(EXCUSED, criteria=(replace(EXCUSED.criteria[0], cause=cause), *EXCUSED.criteria[1:]))
    tries, told = [excused, excused, excused, GOOD], list[Judgement]()
    assert until_sure(lambda: tries.pop(0), told.append) == replace(excused, doubt="")
    assert tries == [GOOD]
    assert told == 2 * [judgement_as_provisional(excused)]


# --- the books ------------------------------------------------------------------------------------------------------


class Judges:
    """Gives each student, by name, what stands in `tries`: the first round the first, the second round the second."""

    tries: dict[str, tuple[Judgement, ...]] = {  # noqa: RUF012
        "joint_positions_ada": (DOUBTFUL, GOOD),
        "joint_positions_bob": (DOUBTFUL, POOR),
        "joint_positions_eve": (POOR,),
        "joint_positions_mia": (DOUBTFUL, LOST),
    }

    def __init__(self) -> None:
        self.asked: list[str] = []

    def __call__(
        self, jobs: Sequence[Job[Any]], slots: int, **_: Any
    ) -> Iterator[tuple[Job[Any], Judgement]]:
        for job in jobs:
            before = self.asked.count(job.key.student)
            self.asked.append(job.key.student)
            yield job, replace(self.tries[job.key.student][before], answer_sha256=job.answer.sha256)


@pytest.fixture
def graded(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> tuple[Path, str]:
    judges = Judges()
    monkeypatch.setattr(local, "judge_all", judges)
    folder = tmp_path / "class"
    folder.mkdir()
    for student in Judges.tries:
        (folder / f"{student}.py").write_text(f"# {student}\n")
    out = tmp_path / "out"
    command = ["grade", str(folder), "--out", str(out), "--format", "html", "--isolation", "limits"]
    assert main(command) == 0
    told = capsys.readouterr().out
    assert sorted(judges.asked) == sorted(student for student, tries in Judges.tries.items() for _ in tries)
    assert main(command) == 0
    assert len(judges.asked) == 7, "what is done is done, doubt or not"
    return out, told


def test_each_answer_has_one_line_with_both_tries_and_both_recordings(graded: tuple[Path, str]) -> None:
    out, _ = graded
    results = {one.student.rpartition("_")[2]: one for one in read_results(out / "results.jsonl")}
    assert len(list(read_results(out / "results.jsonl"))) == 4
    assert {name: one.score for name, one in results.items()} == {"ada": 10, "bob": 8, "eve": 8, "mia": 8}
    assert {name: len(one.tries) for name, one in results.items()} == {
        "ada": 2,
        "bob": 2,
        "eve": 0,
        "mia": 2,
    }
    ada = results["ada"]
    assert ada.doubt == ""
    assert [one.counts for one in ada.tries] == [False, True]
    assert [one.score for one in ada.tries] == [8, 10]
    assert ada.tries[0].doubt == DOUBT
    assert ada.tries[1].recording == ada.recording != ada.tries[0].recording
    for one in ada.tries:
        assert one.recording is not None
        assert json.loads((out / one.recording).read_text())["format"] == 1
        assert [each.id for each in one.criteria] == [each.id for each in ada.criteria]
    assert results["mia"].doubt == DOUBT
    assert [one.counts for one in results["mia"].tries] == [True, False]


def test_the_instructor_is_told_how_many_and_by_name_who_differs(graded: tuple[Path, str]) -> None:
    out, told = graded
    assert "3 answers were tried again, because the first try was inconclusive; 2 differ." in told
    assert "joint_positions_ada: Tried twice: 8 points, then 10 points. The better one counts." in told
    assert "joint_positions_mia: Tried twice: 8 points, then not judged." in told
    assert "joint_positions_bob: Tried" not in told
    with (out / "grades.csv").open(newline="") as file:
        rows = {row["student"].rpartition("_")[2]: row for row in csv.DictReader(file)}
    assert {name: row["tries"] for name, row in rows.items()} == {
        "ada": "2",
        "bob": "2",
        "eve": "1",
        "mia": "2",
    }
    assert DOUBT in rows["bob"]["remark"]
    assert rows["eve"]["remark"] == ""
    page = (out / "pages" / "class.html").read_text()
    section = page.split("<h2>Tried again</h2>")[1].split("</table>")[0]
    assert section.count("<b>differ</b>") == 2
    assert section.index("_ada") < section.index("_bob")


def test_a_student_reads_of_both_tries(graded: tuple[Path, str]) -> None:
    out, _ = graded
    pages = {path.name.split("-")[3]: path.read_text() for path in (out / "pages").glob(f"{STEM}-*.html")}
    assert "Tried twice: 8 points, then 10 points. The better one counts." in pages["ada"]
    assert "Inconclusive" not in pages["ada"]
    assert f"Inconclusive: {DOUBT}" in pages["mia"]
    assert "Tried twice" not in pages["eve"]


def test_regrading_judges_both_recordings_again(graded: tuple[Path, str]) -> None:
    out, _ = graded
    kinder = replace(
        EXERCISE,
        criteria=tuple(one for one in EXERCISE.criteria if one.id != "joint_rate"),
        criteria_sha256="b" * 64,
    )
    found = {one.student.rpartition("_")[2]: one for one in regrade(out, kinder)}
    assert {name: (one.before, one.after) for name, one in found.items()} == {
        "ada": (10, 8), "bob": (8, 8), "eve": (8, 8), "mia": (8, 8),
    }  # fmt: skip
    ada = last_results(out / "results.jsonl")["joint_positions_ada", STEM]
    assert [one.score for one in ada.tries] == [8, 8]
    assert [one.counts for one in ada.tries] == [False, True], "of equal tries the sound one"
    mia = last_results(out / "results.jsonl")["joint_positions_mia", STEM]
    assert mia.tries == (), "the second try left no recording"


# --- what one person sees -----------------------------------------------------------------------------------------


def test_a_card_and_a_terminal_tell_of_the_doubt() -> None:
    for text in (as_html(DOUBTFUL), as_text(DOUBTFUL)):
        assert f"Inconclusive: {DOUBT}. This may not be the program" in " ".join(text.split())
    for text in (as_html(POOR), as_text(POOR)):
        assert "Inconclusive" not in text


def test_a_card_and_a_terminal_tell_that_it_is_being_tried_again() -> None:
    for text in (as_html(judgement_as_provisional(DOUBTFUL)), as_text(judgement_as_provisional(DOUBTFUL))):
        assert f"Inconclusive: {DOUBT}. It is tried once more" in " ".join(text.split())
        assert "another try decides" not in text


@pytest.mark.parametrize(("second", "counts"), [(GOOD, GOOD), (POOR, POOR), (LOST, DOUBTFUL)])
def test_a_student_who_checks_gets_the_second_try_at_once(second: Judgement, counts: Judgement) -> None:
    tries, told = [DOUBTFUL, second], list[Judgement]()
    assert until_sure(lambda: tries.pop(0), told.append) == counts
    assert tries == []
    assert told == [judgement_as_provisional(DOUBTFUL)]


@pytest.mark.parametrize(("third", "counts"), [(GOOD, GOOD), (DOUBTFUL, DOUBTFUL)])
def test_a_student_who_checks_gets_a_third_try_and_no_fourth(third: Judgement, counts: Judgement) -> None:
    tries, told = [DOUBTFUL, DOUBTFUL, third, GOOD], list[Judgement]()
    assert until_sure(lambda: tries.pop(0), told.append) == counts
    assert tries == [GOOD]
    assert told == 2 * [judgement_as_provisional(DOUBTFUL)]


@pytest.mark.parametrize("sure", [GOOD, POOR, LOST])
def test_a_student_who_checks_waits_for_no_second_try_of_what_is_sure(sure: Judgement) -> None:
    tries, told = [sure, GOOD], list[Judgement]()
    assert until_sure(lambda: tries.pop(0), told.append) == sure
    assert tries == [GOOD]
    assert told == []


def test_a_doubt_survives_the_way_between_processes() -> None:
    assert judgement_from_json(json.loads(json.dumps(judgement_to_json(DOUBTFUL)))) == DOUBTFUL
