"""Hostile answers at the best tier: none earns undeserved points, leaves anything behind, or harms another answer."""

import json
import os
import re
import socket
import threading
from collections.abc import Iterator, Sequence
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass
from pathlib import Path

import pytest

from tests.hostile.traces import Traces
from tests.programs.support import wait_until
from workbook.authoring.tree import Tree
from workbook.authoring.wrong_answers import read_wrong_answer
from workbook.exercise.answers import Answer
from workbook.exercise.definition import load_exercise
from workbook.exercise.judgement import Judgement
from workbook.exercise.retries import counting, judge_until_sure
from workbook.feedback.text import as_text
from workbook.grading.judges import Job
from workbook.grading.slots.scheduler import judge_all
from workbook.isolation.bubblewrap import sandbox_problem

pytestmark = [pytest.mark.sandbox, pytest.mark.slow]
ROOT = Path(__file__).resolve().parents[2]
STEM = "09_joint_positions"
FILES = sorted((Path(__file__).parent / "answers").glob("*.py"))
IN_EVERY_RUN = {
    "calls_outside",
    "fills_shared_memory",
    "floods_the_topic",
    "forges_results",
    "forks_without_end",
    "kills_everything",
    "leaves_code_for_the_next",
    "looks_at_the_judge",
    "meets_others_on_a_domain",
    "takes_all_memory",
}
"""One answer for each kind of target. `make test` runs only these; the whole run includes the others."""
SLOTS = 2 * (os.cpu_count() or 1)
SOAK_SLOTS = os.cpu_count() or 1
NEIGHBORS = 4
LOOK_EVERY_S = 0.3
FORGED = ("results.json", "results.jsonl", "grades.csv", "rclpy.py")
_HEADER = re.compile(r"^# (score|loses|says|limits|copies|soak): ?(.*)$")
_COMMAND = re.compile(r"[\x00-\x08\x0b-\x1f\x7f-\x9f\u202a-\u202e\u2066-\u2069]")


@dataclass(frozen=True)
class Expected:
    """The result that the first lines of a hostile answer demand, and how to run it.

    `copies`: how many run in parallel. `soak`: whether to run it for all of its real seconds, which takes time and
    often proves nothing.
    """

    score: float | None
    loses: frozenset[str]
    says: str
    limits: tuple[str, ...]
    copies: int
    soak: bool


def expected_of(path: Path) -> Expected:
    found: dict[str, str] = {}
    for line in path.read_text(encoding="utf-8").splitlines():
        header = _HEADER.match(line)
        if header is None:
            break
        found[header[1]] = header[2].strip()
    assert found.keys() & {"score", "loses"}, f"{path.name} says neither its score nor what it loses"
    return Expected(
        float(found["score"]) if "score" in found else None,
        frozenset(filter(None, found.get("loses", "").split(", "))),
        found.get("says", ""),
        tuple(filter(None, found.get("limits", "").split(", "))),
        int(found.get("copies", "1")),
        "soak" in found,
    )


@dataclass(frozen=True)
class Aftermath:
    """The result of all answers: the judgments, who called the listener, and the leftovers."""

    judgements: dict[str, list[Judgement]]
    callers: int
    traces: Traces
    forged: list[Path]


def forged_files() -> list[Path]:
    return [
        path for place in ("/tmp", "/dev/shm", "/") for name in FORGED if (path := Path(place, name)).exists()
    ]


@pytest.fixture(scope="module")
def aftermath(request: pytest.FixtureRequest, tmp_path_factory: pytest.TempPathFactory) -> Aftermath:
    problem = sandbox_problem()
    if problem is not None:
        pytest.skip(f"programs cannot be sandboxed: {problem}")
    solution = load_exercise(STEM, ROOT).source.solution_code
    eleven_values = Tree(ROOT).wrong_answers / STEM / "eleven_values.py"
    eleven = read_wrong_answer(Tree(ROOT), eleven_values).answer.text
    listener = socket.create_server(("127.0.0.1", 0))
    callers: list[object] = []

    def listen() -> None:
        while True:
            try:
                connection, address = listener.accept()
            except OSError:
                return
            callers.append(address)
            connection.close()

    threading.Thread(target=listen, daemon=True).start()
    quick: list[Job[str]] = []
    soak: list[Job[str]] = []
    chosen = {item.callspec.params.get("path") for item in request.session.items if hasattr(item, "callspec")}
    for path in FILES:
        if path not in chosen:
            continue
        text = path.read_text(encoding="utf-8")
        for mark, code in (("@@GOOD@@", solution), ("@@ELEVEN@@", eleven), ("@@ROOT@@", str(ROOT))):
            text = text.replace(mark, code)
        text = text.replace("@@PORT@@", str(listener.getsockname()[1]))
        expected = expected_of(path)
        jobs = soak if expected.soak else quick
        jobs += [Job(path.stem, STEM, Answer(text))] * expected.copies
    for number in range(NEIGHBORS):
        soak.insert(3 * number, Job(f"neighbor {number}", STEM, Answer(solution)))
    home = tmp_path_factory.mktemp("home")
    traces = Traces(home)
    over = threading.Event()

    def follow() -> None:
        while not over.wait(LOOK_EVERY_S):
            traces.look()

    follower = threading.Thread(target=follow)
    forged = set(forged_files())
    judgements: dict[str, list[Judgement]] = {}

    def judge(jobs: list[Job[str]], slots: int, soak: bool) -> None:
        def judge_some(some: Sequence[Job[str]]) -> Iterator[tuple[Job[str], Judgement]]:
            return judge_all(some, slots, soak=soak, isolation="sandbox")

        for job, tries in judge_until_sure(jobs, judge_some):
            judgements.setdefault(job.key, []).append(counting(tries))

    with pytest.MonkeyPatch.context() as patch:
        patch.setenv("HOME", str(home))
        patch.setenv("SECRET_OF_THE_GRADER", "1")
        follower.start()
        try:
            with ThreadPoolExecutor(2) as both:
                under_way = [
                    both.submit(judge, quick, SLOTS, False),
                    both.submit(judge, soak, SOAK_SLOTS, True),
                ]
            for one in under_way:
                one.result()
        finally:
            over.set()
            follower.join()
            listener.close()
    return Aftermath(
        judgements, len(callers), traces, [path for path in forged_files() if path not in forged]
    )


def explained(judgement: Judgement) -> str:
    log = judgement.recording.process.log if judgement.recording is not None else ""
    return f"{judgement.reason}\n{as_text(judgement)}\n{log[-1500:]}"


@pytest.mark.parametrize(
    "path",
    [
        pytest.param(path, marks=() if path.stem in IN_EVERY_RUN else pytest.mark.whole, id=path.stem)
        for path in FILES
    ],
)
def test_a_hostile_answer_gets_what_it_earned(path: Path, aftermath: Aftermath) -> None:
    expected = expected_of(path)
    judgements = aftermath.judgements[path.stem]
    assert len(judgements) == expected.copies
    for judgement in judgements:
        assert judgement.status == "graded", explained(judgement)
        if expected.score is not None:
            assert judgement.score == expected.score, explained(judgement)
        lost = {one.id for one in judgement.criteria if one.status in ("failed", "partial")}
        assert expected.loses <= lost, explained(judgement)
        if expected.says:
            told = " ".join(f"{one.saw} {one.because} {one.try_this}" for one in judgement.criteria)
            assert expected.says in told, explained(judgement)
        assert judgement.recording is not None
        assert set(expected.limits) <= set(judgement.recording.process.limits_hit), explained(judgement)


@pytest.mark.parametrize("number", range(NEIGHBORS))
def test_a_good_answer_among_them_keeps_its_marks(number: int, aftermath: Aftermath) -> None:
    [judgement] = aftermath.judgements[f"neighbor {number}"]
    assert judgement.full_marks, explained(judgement)


def test_nobody_got_out(aftermath: Aftermath) -> None:
    assert aftermath.callers == 0


def test_nothing_is_left(aftermath: Aftermath) -> None:
    look = aftermath.traces.look
    wait_until(lambda: not look(), "the last processes end", instead=look)
    assert aftermath.traces.files() == []
    assert aftermath.forged == []


def test_no_word_about_them_holds_a_command(aftermath: Aftermath) -> None:
    for judgements in aftermath.judgements.values():
        for judgement in judgements:
            assert judgement.recording is not None
            assert not _COMMAND.search(judgement.recording.process.log)
            told = [
                text
                for one in judgement.criteria
                for text in (one.saw, one.expected, one.because, one.try_this)
            ]
            assert not _COMMAND.search(as_text(judgement))
            assert not any(map(_COMMAND.search, told)), json.dumps(told)
