"""results.jsonl across versions: it is rewritten without changes, and unreadable parts are named."""

import json
from pathlib import Path
from typing import Any

import pytest
from hypothesis import given
from hypothesis import strategies as st

from workbook.cli.main import main
from workbook.exercise.serialization import judgement_from_json, judgement_to_json
from workbook.grading.results import CriterionLine, ProcessSummary, Result, Try, Versions
from workbook.grading.results_file import BrokenLine, last_results, line_of, read_results, result_of

STORED = Path(__file__).with_name("stored")
"""Written by the last version without classes for results."""
LINES = (STORED / "results.jsonl").read_text(encoding="utf-8").splitlines(keepends=True)

texts = st.text(st.characters(exclude_categories=["Cs"]), max_size=8)
numbers = st.floats(0, 100, allow_nan=False) | st.integers(0, 10)
json_values = st.recursive(
    st.none() | st.booleans() | st.integers() | st.floats(allow_nan=False, allow_infinity=False) | texts,
    lambda inner: st.lists(inner, max_size=3) | st.dictionaries(texts, inner, max_size=3),
    max_leaves=5,
)
unknown = st.dictionaries(texts.map("new {}".format), json_values, max_size=2)
criteria = st.builds(
    CriterionLine,
    texts, texts, st.sampled_from(["passed", "failed", "partial", "skipped"]), numbers, numbers, st.booleans(),
    texts, texts, texts, texts, unknown,
)  # fmt: skip
processes = st.builds(
    ProcessSummary,
    st.none() | st.integers(0, 255),
    st.none() | st.just("SIGKILL"),
    st.lists(texts, max_size=2).map(tuple),
    texts,
    unknown,
)
statuses = st.sampled_from(["graded", "ungradable", "infra_error"])
clocks = st.sampled_from([None, "simulated", "wall"])
many_criteria = st.lists(criteria, max_size=2).map(tuple)
tries = st.builds(
    Try, st.booleans(), texts, statuses, st.none() | texts, st.none() | numbers, many_criteria,
    st.none() | texts, clocks, st.none() | numbers, st.booleans(), unknown,
)  # fmt: skip
results = st.builds(
    Result,
    student=texts,
    answer=texts,
    answer_sha256=texts,
    submitted_at=st.none() | texts,
    exercise=texts,
    attempt=st.integers(1, 9),
    status=statuses,
    reason=st.none() | texts,
    score=st.none() | numbers,
    max_score=numbers,
    criteria=many_criteria,
    process=st.none() | processes,
    recording=st.none() | texts,
    clock=clocks,
    watched_s=st.none() | numbers,
    wall_s=st.none() | numbers,
    isolation=st.sampled_from(["sandbox", "uid", "limits"]),
    versions=st.builds(Versions, texts, texts, texts, texts, unknown),
    inconclusive_reason=texts,
    tries=st.lists(tries, max_size=2).map(tuple),
    why_this_try=texts,
    unknown=unknown,
)


@given(results)
def test_a_result_survives_its_line_with_all_unknown_fields(result: Result) -> None:
    line = line_of(result)
    assert line.count("\n") == 1
    assert result_of(line) == result
    assert line_of(result_of(line)) == line


@pytest.mark.parametrize("line", LINES, ids=["one try", "two tries", "ours", "ungradable"])
def test_lines_of_an_earlier_version_are_written_again_byte_for_byte(line: str) -> None:
    assert line_of(result_of(line)) == line


def test_the_line_between_slot_and_grader_is_written_again_byte_for_byte() -> None:
    line = (STORED / "judgement.json").read_text(encoding="utf-8")
    assert json.dumps(judgement_to_json(judgement_from_json(json.loads(line)))) + "\n" == line


@pytest.mark.parametrize("missing", ["doubt", "tries", "why_this_try"])
def test_a_line_from_before_second_tries_is_read(missing: str) -> None:
    data = json.loads(LINES[0])
    del data[missing]
    assert result_of(json.dumps(data)) == result_of(LINES[0])


def broken(text: str, path: Path) -> list[BrokenLine]:
    path.write_text(LINES[0] + text + LINES[3], encoding="utf-8")
    found: list[BrokenLine] = []
    assert [one.status for one in read_results(path, found.append)] == ["graded", "ungradable"]
    return found


def changed(**fields: Any) -> str:
    return json.dumps({**json.loads(LINES[0]), **fields}) + "\n"


@pytest.mark.parametrize(
    ("text", "problem"),
    [
        ("not json\n", "it is not JSON: Expecting value, column 1"),
        ("\n", "it is not JSON: Expecting value"),
        ("[]\n", "[] is not an object (Result)"),
        ("null\n", "None is not an object (Result)"),
        ("{}\n", "student: it is missing"),
        (changed(score="ten"), "score: 'ten' is not a finite number"),
        (changed(status="lost"), "status: 'lost' is not 'graded' or 'ungradable' or 'infra_error'"),
        (changed(criteria=[{"id": 1}]), "criteria[0].id: 1 is not text"),
        (changed(versions=None), "versions: None is not an object (Versions)"),
        (changed(score=float("nan")), "score: nan is not a finite number"),
        ("[" * 100_000 + "\n", "recursion"),
        ("\\ud83d\n", "it is not JSON"),
    ],
)
def test_a_broken_line_is_named_with_its_number_and_hides_nothing(
    text: str, problem: str, tmp_path: Path
) -> None:
    [one] = broken(text, tmp_path / "results.jsonl")
    assert one.number == 2
    assert problem in one.problem
    assert str(one).startswith(f"{tmp_path / 'results.jsonl'}, line 2, holds no result and does not count (")


def test_bytes_that_are_no_text_are_a_broken_line(tmp_path: Path) -> None:
    path = tmp_path / "results.jsonl"
    path.write_bytes(b'{"student": "\xff"}\n' + LINES[0].encode())
    found: list[BrokenLine] = []
    assert len(list(read_results(path, found.append))) == 1
    assert [one.number for one in found] == [1]


def test_a_torn_last_line_is_no_broken_line(tmp_path: Path) -> None:
    path = tmp_path / "results.jsonl"
    path.write_text(LINES[0] + LINES[1][:100], encoding="utf-8")
    found: list[BrokenLine] = []
    assert len(last_results(path, found.append)) == 1
    assert found == []


def test_the_instructor_is_warned_once_in_one_sentence(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    out = tmp_path / "out"
    out.mkdir()
    (out / "results.jsonl").write_text("oops\n" + LINES[3], encoding="utf-8")
    answer = tmp_path / "joint_positions_s1.py"
    answer.write_text("")
    assert main(["grade", str(answer), "--out", str(out), "--isolation", "limits"]) == 0
    told = [line for line in capsys.readouterr().err.splitlines() if "holds no result" in line]
    assert len(told) == 1
    assert f"{out / 'results.jsonl'}, line 1, holds no result and does not count" in told[0]
    assert main(["grade", "--regrade", "--exercise", "joint_positions", "--out", str(out)]) == 0
    assert capsys.readouterr().err.count("line 1, holds no result") == 1
