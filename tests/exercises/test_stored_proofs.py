"""Judge the proofs' stored recordings again: the verdicts are the same, and no program runs."""

import json
from collections import defaultdict
from dataclasses import replace
from pathlib import Path

import pytest

from tests.exercises import stored_proofs
from tests.exercises.expected import differences, lost
from tests.exercises.proofs import SOLUTION, STARTER, STEMS, Key, answer_of, answers
from tests.exercises.stored_proofs import (
    COMMAND,
    hash_of_code,
    key_of,
    load,
    path_of,
    store,
    stored,
    stored_code,
)
from workbook.authoring.wrong_answers import read_header
from workbook.exercise.definition import load_exercise
from workbook.exercise.judgement import Judgement, judge_recording

PROOFS: dict[str, list[Path]] = defaultdict(list)
for _path in stored():
    PROOFS[key_of(_path)[0]].append(_path)
STEM = "09_joint_positions"


def problems(key: Key, judgement: Judgement, wrong: Path) -> list[str]:
    """Return what is wrong with the verdict on an answer. `wrong`: its file, if it is a wrong answer."""
    kind = key[1].partition("/")[0]
    if kind == "wrong":
        return differences(judgement, read_header(wrong))
    if kind == STARTER:
        return ["the starter gets full marks"] * judgement.full_marks
    return [] if judgement.full_marks else [f"it loses {', '.join(sorted(lost(judgement)))}"]


@pytest.mark.parametrize("stem", STEMS)
def test_each_stored_recording_gets_the_verdict_that_its_answer_must_get(stem: str) -> None:
    exercise = load_exercise(stem)
    files = {path.name: path for path in answers("wrong", stem)}
    codes = stored_code()
    found, old = [], []
    for path in PROOFS[stem]:
        key = key_of(path)
        name = key[1].rpartition("/")[2]
        sha256, recording = load(path)
        if codes.get(key) != hash_of_code(answer_of(key)[0].text):
            old.append(path.name)
        judgement = judge_recording(exercise, sha256, recording)
        found += [f"{key[1]}: {one}" for one in problems(key, judgement, files.get(name, path))]
    assert not old, f"Run `{COMMAND}`: it proves these again, and keeps their recordings: {', '.join(old)}"
    assert not found, "\n".join(found)


@pytest.mark.parametrize("stem", STEMS)
def test_the_solution_and_the_starter_are_stored(stem: str) -> None:
    assert {path_of((stem, SOLUTION)), path_of((stem, STARTER))} <= {*PROOFS[stem]}


def judged(name: str, stem: str = STEM) -> Judgement:
    sha256, recording = load(path_of((stem, name)))
    return judge_recording(load_exercise(stem), sha256, recording)


def test_what_is_stored_is_found_again(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    judgement = judged(SOLUTION)
    monkeypatch.setattr(stored_proofs, "FOLDER", tmp_path)
    for key in ((STEM, SOLUTION), (STEM, "wrong/two_words.py")):
        store(key, judgement)
        assert load(path_of(key)) == (judgement.answer_sha256, judgement.recording)
        assert key_of(path_of(key)) == key
    assert len(stored()) == 2


def test_a_verdict_that_needs_both_clocks_is_not_stored(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    judgement = judged(SOLUTION)
    monkeypatch.setattr(stored_proofs, "FOLDER", tmp_path)
    monkeypatch.setattr(stored_proofs, "NOT_STORED", tmp_path / "not_stored.txt")
    first, *others = judgement.criteria
    store((STEM, SOLUTION), replace(judgement, criteria=(replace(first, status="failed"), *others)))
    assert stored() == []
    assert (tmp_path / "not_stored.txt").read_text() == f"{STEM} {SOLUTION}\n"


def test_neither_the_checkout_nor_the_python_of_this_machine_is_named(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    judgement = judged(SOLUTION)
    recording = judgement.recording
    assert recording is not None
    log = f'File "{stored_proofs.ROOT}/workbook/ros.py", line 3\n'
    told = replace(recording, process=replace(recording.process, log=log))
    monkeypatch.setattr(stored_proofs, "FOLDER", tmp_path)
    store((STEM, SOLUTION), replace(judgement, recording=told))
    _, kept = load(path_of((STEM, SOLUTION)))
    assert str(stored_proofs.ROOT) not in json.dumps(kept.to_json())
    assert kept.process.log.endswith('rclpy-workbook/workbook/ros.py", line 3\n')


@pytest.mark.parametrize("first", [3, None])
def test_what_the_judge_said_is_kept_once(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, first: int | None
) -> None:
    """The order doesn't matter: a program may have received the whole script or only its beginning."""
    stem = "10_slow_callbacks"
    judgement = judged(SOLUTION, stem)
    recording = judgement.recording
    assert recording is not None and len(recording.published) > 5
    monkeypatch.setattr(stored_proofs, "FOLDER", tmp_path)
    other = replace(recording.published[1], value={"data": -7.0})
    for name, said in (
        ("a", recording.published[:first]),
        ("b", recording.published),
        ("c", (*recording.published[:1], other)),
    ):
        part = replace(recording, published=said)
        store((stem, name), judge_recording(load_exercise(stem), judgement.answer_sha256, part))
    assert load(path_of((stem, "a")))[1].published == recording.published[:first]
    assert load(path_of((stem, "b")))[1] == recording
    assert load(path_of((stem, "c")))[1].published == (recording.published[0], other)
    assert len([*tmp_path.glob("*/script_*.xz")]) == 1


def test_comments_and_docstrings_leave_a_recording_current() -> None:
    code = 'import rclpy\n\nclass Robot:\n    name = "a # robot"\n    def walk(self):\n        return 1\n'
    told = (
        '"""Walk."""\nimport rclpy  # ROS\n\nclass Robot:\n    """A robot.\n\n    It walks.\n    """\n'
        '    name = "a # robot"\n\n    # one step\n    def walk(self):\n        """Walk."""\n        return 1\n'
    )
    assert hash_of_code(told) == hash_of_code(code)
    assert hash_of_code(code.replace("return 1", "return 2")) != hash_of_code(code)
    assert hash_of_code(code.replace("a # robot", "a # cat")) != hash_of_code(code)
    assert hash_of_code("robot = (") != hash_of_code("robot = [")
