"""An inconclusive answer is tried again: both tries are stored and reported, and the new try costs no points."""

import csv
import json
import shutil
from collections.abc import Iterator, Sequence
from dataclasses import replace
from itertools import product
from pathlib import Path
from typing import Any

import pytest

from workbook.cli.main import main
from workbook.exercise.answers import Answer
from workbook.exercise.definition import load_exercise
from workbook.exercise.judgement import Judgement, judge_recording, judgement_as_provisional
from workbook.exercise.retries import counting, judge_until_sure, until_sure, what_counts
from workbook.exercise.serialization import judgement_from_json, judgement_to_json
from workbook.feedback.card import as_html
from workbook.feedback.text import as_text
from workbook.grading.judges import Job
from workbook.grading.regrade import regrade
from workbook.grading.results_file import last_results, read_results
from workbook.grading.slots import scheduler
from workbook.recording.recording import Recording

ROOT = Path(__file__).resolve().parents[2]
STEM = "09_joint_positions"
EXERCISE = load_exercise(STEM, ROOT)
REASON = "this machine was so busy that the judge itself had to wait for 0.80 s"


def judgement(recording: str, inconclusive_reason: str = "") -> Judgement:
    stored = Recording.load(ROOT / "tests" / "recordings" / STEM / f"{recording}.json")
    return replace(judge_recording(EXERCISE, "a" * 64, stored), inconclusive_reason=inconclusive_reason)


GOOD, POOR = judgement("solution"), judgement("period_for_frequency")
INCONCLUSIVE = judgement("period_for_frequency", REASON)
CRASHED = replace(judgement("period_for_frequency", "it crashed"), end_only=True)
LOST = Judgement(STEM, "a" * 64, "infra_error", "the slot is gone", (), None)


WALKS, ENDS = (
    replace(one, id=name, points=5.0, max_points=5.0, status="passed", about_end=name == "ends")
    for one, name in ((GOOD.criteria[-1], "walks"), (GOOD.criteria[-1], "ends"))
)


def made(
    walks: float = 5.0, ends: float = 5.0, *, inconclusive_reason: str = "", end_only: bool = False
) -> Judgement:
    """Make a judgment of two criteria, one of which is about the end."""
    criteria = tuple(
        replace(one, points=points, status="passed" if points == one.max_points else "failed")
        for one, points in ((WALKS, walks), (ENDS, ends))
    )
    return Judgement(
        STEM,
        "a" * 64,
        "graded",
        None,
        criteria,
        None,
        inconclusive_reason=inconclusive_reason,
        end_only=end_only,
    )


FULL, LOW = made(), made(walks=2.0)
END, LOW_END = (made(walks, 0.0, inconclusive_reason="it crashed", end_only=True) for walks in (5.0, 2.0))
BUSY, LOW_BUSY, ZERO_BUSY = (made(walks, inconclusive_reason=REASON) for walks in (4.0, 2.0, 0.0))
EVERY = (FULL, LOW, END, LOW_END, BUSY, LOW_BUSY, LOST)


@pytest.mark.parametrize(
    ("tries", "number", "why"),
    [
        ((FULL,), 0, ""),
        ((LOW,), 0, ""),
        ((LOST,), 0, ""),
        ((LOW_BUSY, FULL), 1, "disturbed the rest"),
        ((BUSY, LOW), 1, "disturbed the rest"),
        ((BUSY, LOW_BUSY, LOW), 2, "disturbed the rest"),
        ((BUSY, LOST, LOW), 2, "disturbed the rest"),
        ((END, FULL), 1, "the best: the tries differ only"),
        ((END, END, FULL), 2, "the best: the tries differ only"),
        ((END, END, END), 2, "They agree"),
        ((END, LOST, END), 2, "disturbed the rest"),
        ((LOW_END, FULL), 0, "the lowest"),
        ((END, LOW), 1, "the lowest"),
        ((END, LOW_END, END), 1, "the lowest"),
        ((END, LOW_END, FULL), 1, "the lowest"),
        ((LOW_END, END, LOW), 2, "the lowest"),
        ((BUSY, LOW_END, FULL), 1, "the lowest"),
        ((BUSY, END, FULL), 2, "the best: the tries differ only"),
        ((LOW_BUSY, LOW_BUSY, LOW_BUSY), 2, "all gave the same"),
        ((BUSY, LOW_BUSY, BUSY), None, "None of them counts"),
        ((ZERO_BUSY, BUSY, BUSY), None, "None of them counts"),
        ((BUSY, LOST, LOST), None, "None of them counts"),
        ((BUSY, LOST, BUSY), None, "None of them counts"),
    ],
)
def test_which_try_counts_and_why(tries: tuple[Judgement, ...], number: int | None, why: str) -> None:
    found = what_counts(tries)
    assert found.number == number
    assert why in found.why and bool(why) == bool(found.why)
    assert counting(tries) == found.judgement
    if number is None:
        assert found.judgement.status == "infra_error"
        assert found.judgement.score is None, "no fault of ours is a zero"
    else:
        assert found.judgement.score == tries[number].score


def test_two_that_lost_different_things_are_told_of_although_they_have_the_same_points() -> None:
    other = replace(LOW_END, criteria=(replace(WALKS, id="waves", points=2.0, status="failed"), ENDS))
    assert "the lowest" in what_counts((LOW_END, other, other)).why


@pytest.mark.parametrize("tries", [*product(EVERY, repeat=3)])
def test_no_luck_and_no_disturbance_earns_a_point(tries: tuple[Judgement, ...]) -> None:
    """This is checked for any three tries, and for the first two of them."""
    for some in (tries, tries[:2]):
        found = what_counts(some)
        sound = [one for one in some if one.status == "graded" and not one.is_inconclusive]
        if sound:
            assert found.number is not None and not found.judgement.is_inconclusive
            assert found.judgement.criteria[0].points == min(one.criteria[0].points for one in sound)
        elif found.number is not None:
            assert len(set(map(judgement_as_provisional, some))) == 1 and len(some) == 3
        else:
            assert found.judgement.score is None


def test_what_every_end_shows_leaves_no_doubt() -> None:
    assert counting((END, END, END)).inconclusive_reason == ""
    assert counting((END, LOST, END)).inconclusive_reason == "it crashed"
    assert counting((LOW_BUSY, LOW_BUSY, LOW_BUSY)).inconclusive_reason == REASON


def test_only_what_is_in_doubt_is_tried_again_and_after_all_others() -> None:
    rounds: list[list[str]] = []

    def judge(jobs: Sequence[Job[str]]) -> Iterator[tuple[Job[str], Judgement]]:
        rounds.append([job.key for job in jobs])
        for job in jobs:
            yield job, INCONCLUSIVE if job.key == "doubtful" else POOR

    jobs = [Job(name, STEM, Answer("x = 1\n")) for name in ("doubtful", "poor", "poor too")]
    found = {job.key: len(tries) for job, tries in judge_until_sure(jobs, judge)}
    assert rounds == [["doubtful", "poor", "poor too"], ["doubtful"], ["doubtful"]]
    assert found == {"poor": 1, "poor too": 1, "doubtful": 3}


def test_a_run_that_is_stopped_before_the_second_try_leaves_the_answer_to_the_next() -> None:
    rounds = 0

    def judge(jobs: Sequence[Job[str]]) -> Iterator[tuple[Job[str], Judgement]]:
        nonlocal rounds
        rounds += 1
        if rounds == 1:
            yield from ((job, INCONCLUSIVE) for job in jobs)

    assert list(judge_until_sure([Job("one", STEM, Answer("x = 1\n"))], judge)) == []
    assert rounds == 2


@pytest.mark.parametrize(
    ("given", "how_many"),
    [
        ((FULL,), 1),
        ((LOW,), 1),
        ((LOST,), 1),
        ((BUSY, LOW), 2),
        ((BUSY, BUSY, BUSY), 3),
        ((BUSY, LOST, LOW), 3),
        ((BUSY, LOST, LOST), 3),
        ((END, FULL), 2),
        ((END, BUSY, END), 3),
    ],
)
def test_there_are_three_tries_at_most_for_a_class_and_for_a_student(
    given: tuple[Judgement, ...], how_many: int
) -> None:
    more = iter((*given, FULL))

    def judge(jobs: Sequence[Job[str]]) -> Iterator[tuple[Job[str], Judgement]]:
        for job in jobs:
            yield job, next(more)

    [(_, tries)] = judge_until_sure([Job("one", STEM, Answer("x = 1\n"))], judge)
    assert tries == given and len(tries) == how_many
    told: list[Judgement] = []
    alone, found = iter((*given, FULL)), what_counts(given)
    seen = next((one for one in reversed(given) if one.status == "graded"), LOST)
    counts = seen if found.number is None else found.judgement
    assert until_sure(lambda: next(alone), told.append) == counts
    assert told == [judgement_as_provisional(one) for one in given[:-1]]


# --- the gradebook --------------------------------------------------------------------------------------------------


class ScriptedBackend:
    """Gives each student (by name) a judgment from `tries`: in the first round the first, in the second the second."""

    tries: dict[str, tuple[Judgement, ...]] = {  # noqa: RUF012
        "joint_positions_ada": (INCONCLUSIVE, GOOD),
        "joint_positions_bob": (INCONCLUSIVE, POOR),
        "joint_positions_eve": (POOR,),
        "joint_positions_mia": (INCONCLUSIVE, LOST, LOST, POOR),
        "joint_positions_zoe": (CRASHED, GOOD),
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
    judges = ScriptedBackend()
    monkeypatch.setattr(scheduler, "judge_all", judges)
    folder = tmp_path / "class"
    folder.mkdir()
    for student in ScriptedBackend.tries:
        (folder / f"{student}.py").write_text(f"# {student}\n")
    out = tmp_path / "out"
    command = ["grade", str(folder), "--out", str(out), "--format", "html", "--isolation", "limits"]
    assert main(command) == 1, "the answer of mia was not judged"
    told = capsys.readouterr().out
    once = sorted(student for student, tries in ScriptedBackend.tries.items() for _ in tries[:3])
    assert sorted(judges.asked) == once
    later = shutil.copytree(out, tmp_path / "later")
    assert main([str(later) if one == str(out) else one for one in command]) == 0
    assert sorted(judges.asked) == sorted([*once, "joint_positions_mia"]), "what is done is done"
    return out, told


def test_each_answer_has_one_line_with_all_tries_and_recordings(graded: tuple[Path, str]) -> None:
    out, _ = graded
    results = {one.student.rpartition("_")[2]: one for one in read_results(out / "results.jsonl")}
    assert len(list(read_results(out / "results.jsonl"))) == 5
    assert {name: (one.score, len(one.tries)) for name, one in results.items()} == {
        "ada": (10, 2), "bob": (8, 2), "eve": (8, 0), "mia": (None, 3), "zoe": (8, 2),
    }  # fmt: skip
    ada = results["ada"]
    assert ada.inconclusive_reason == ""
    assert [one.counts for one in ada.tries] == [False, True]
    assert [one.score for one in ada.tries] == [8, 10]
    assert ada.tries[0].inconclusive_reason == REASON
    assert ada.tries[1].recording == ada.recording != ada.tries[0].recording
    for one in ada.tries:
        assert one.recording is not None
        assert json.loads((out / one.recording).read_text())["format"] == 1
        assert [each.id for each in one.criteria] == [each.id for each in ada.criteria]
    assert results["mia"].status == "infra_error"
    assert [one.inconclusive_reason for one in results["mia"].tries] == [REASON, "", ""]
    assert not any(one.counts for one in results["mia"].tries)
    assert [one.counts for one in results["zoe"].tries] == [True, False]
    assert [one.end_only for one in results["zoe"].tries] == [True, False]
    assert "the lowest" in results["zoe"].why_this_try


def test_the_instructor_is_told_how_many_and_by_name_who_differs(graded: tuple[Path, str]) -> None:
    out, told = graded
    assert "4 answers were tried again, because the first try was inconclusive; 3 differ." in told
    assert "joint_positions_ada: Tried twice: 8 points, then 10 points. The second one counts:" in told
    assert "joint_positions_mia: Tried 3 times: 8 points, then not judged, then not judged. None of" in told
    assert (
        "joint_positions_zoe: Tried twice: 8 points, then 10 points. The first one counts, because it is the lowest:"
        in told
    )
    assert "joint_positions_bob: Tried" not in told
    with (out / "grades.csv").open(encoding="utf-8-sig", newline="") as file:
        rows = {row["student"].rpartition("_")[2]: row for row in csv.DictReader(file)}
    assert {name: row["tries"] for name, row in rows.items()} == {
        "ada": "2", "bob": "2", "eve": "1", "mia": "", "zoe": "2",
    }  # fmt: skip
    assert REASON in rows["bob"]["remark"]
    assert REASON in rows["mia"]["remark"]
    assert "The first one counts, because it is the lowest" in rows["zoe"]["remark"]
    assert rows["eve"]["remark"] == ""
    page = (out / "pages" / "class.html").read_text()
    section = page.split("<h2>Tried again</h2>")[1].split("</table>")[0]
    assert section.count("<b>differ</b>") == 3
    assert section.index("_ada") < section.index("_bob")


def test_a_student_reads_of_both_tries(graded: tuple[Path, str]) -> None:
    out, _ = graded
    pages = {path.name.split("-")[3]: path.read_text() for path in (out / "pages").glob(f"{STEM}-*.html")}
    assert "Tried twice: 8 points, then 10 points. The second one counts" in pages["ada"]
    assert "Inconclusive" not in pages["ada"]
    assert "Tried 3 times: 8 points, then not judged" in pages["mia"]
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
        "ada": (10, 8), "bob": (8, 8), "eve": (8, 8), "mia": (None, None), "zoe": (8, 8),
    }  # fmt: skip
    assert "Run `workbook grade`" in found["mia"].problem
    ada = last_results(out / "results.jsonl")["joint_positions_ada", STEM]
    assert [one.score for one in ada.tries] == [8, 8]
    assert [one.counts for one in ada.tries] == [False, True], "of equal tries the sound one"
    zoe = last_results(out / "results.jsonl")["joint_positions_zoe", STEM]
    assert [one.counts for one in zoe.tries] == [False, True], "none is lower now"


# --- what authors and students see ----------------------------------------------------------------------------------


def test_a_card_and_a_terminal_tell_of_the_doubt() -> None:
    for text in (as_html(INCONCLUSIVE), as_text(INCONCLUSIVE)):
        assert f"Inconclusive: {REASON}. This may not be the program" in " ".join(text.split())
    for text in (as_html(POOR), as_text(POOR)):
        assert "Inconclusive" not in text


def test_a_card_and_a_terminal_tell_that_it_is_being_tried_again() -> None:
    for text in (
        as_html(judgement_as_provisional(INCONCLUSIVE)),
        as_text(judgement_as_provisional(INCONCLUSIVE)),
    ):
        assert f"Inconclusive: {REASON}. Your program is judged once more" in " ".join(text.split())
        assert "another try decides" not in text


@pytest.mark.parametrize(("second", "counts"), [(GOOD, GOOD), (POOR, POOR)])
def test_a_student_who_checks_gets_the_second_try_at_once(second: Judgement, counts: Judgement) -> None:
    tries, told = [INCONCLUSIVE, second], list[Judgement]()
    assert until_sure(lambda: tries.pop(0), told.append) == counts
    assert tries == []
    assert told == [judgement_as_provisional(INCONCLUSIVE)]


@pytest.mark.parametrize(("third", "counts"), [(GOOD, GOOD), (INCONCLUSIVE, INCONCLUSIVE)])
def test_a_student_who_checks_gets_a_third_try_and_no_fourth(third: Judgement, counts: Judgement) -> None:
    tries, told = [INCONCLUSIVE, INCONCLUSIVE, third, GOOD], list[Judgement]()
    assert until_sure(lambda: tries.pop(0), told.append) == counts
    assert tries == [GOOD]
    assert told == 2 * [judgement_as_provisional(INCONCLUSIVE)]


def test_a_check_that_a_newer_one_waits_for_has_no_further_try() -> None:
    tries, told = [INCONCLUSIVE, GOOD], list[Judgement]()
    assert until_sure(lambda: tries.pop(0), told.append, stop=lambda: True) == INCONCLUSIVE
    assert tries == [GOOD]
    assert told == []


@pytest.mark.parametrize("sure", [GOOD, POOR, LOST])
def test_a_student_who_checks_waits_for_no_second_try_of_what_is_sure(sure: Judgement) -> None:
    tries, told = [sure, GOOD], list[Judgement]()
    assert until_sure(lambda: tries.pop(0), told.append) == sure
    assert tries == [GOOD]
    assert told == []


def test_a_doubt_survives_the_way_between_processes() -> None:
    assert judgement_from_json(json.loads(json.dumps(judgement_to_json(INCONCLUSIVE)))) == INCONCLUSIVE
