"""The proofs' recordings: stored, so that they can be judged again without running the answers.

`python -m tests.exercises.stored_proofs` proves every answer that has no recording, or whose text has changed since. It
stores the recordings, and passes options such as `-k 05_timers` to pytest.

A recording is out of date if its program's code has changed. Comments and docstrings don't count: `CODE` has a hash of
each program without them.

Times are rounded to a microsecond, and the machine's paths are replaced. All answers with the same seed get the same
values from the judge, so these are stored once.
"""

import ast
import hashlib
import io
import json
import lzma
import os
import re
import subprocess
import sys
import tokenize
from pathlib import Path
from typing import Any

from workbook.exercise.course import course_folder
from workbook.exercise.definition import load_exercise
from workbook.exercise.judgement import Judgement, judge_recording
from workbook.recording.recording import Recording

ROOT = course_folder()
FOLDER = Path(__file__).parent / "recordings"
CODE = "code.json"
COMMAND = "python -m tests.exercises.stored_proofs"
WANTED = "WORKBOOK_STORE_PROOFS"
NOT_STORED = ROOT / "artifacts" / "proofs_not_stored.txt"
"""Lists the answers without a stored recording.

Either their verdict needs both clocks, so that one recording alone would change it, or the recording is too large.
"""
LARGEST = 100_000
"""Bytes of a file. Only recordings of programs that flood a topic are larger."""
DIGITS = 6  # digits of a second
SAID_BY_PROGRAMS = ("value", "request", "response")
Key = tuple[str, str]


def hash_of_code(text: str) -> str:
    """Return a hash of a program without its comments, docstrings, and empty lines. It's the same for any Python."""
    lines = text.splitlines()
    try:
        tree = ast.parse(text)
        tokens = [*tokenize.generate_tokens(io.StringIO(text).readline)]
    except (SyntaxError, tokenize.TokenError):
        return _hash(text)
    for token in tokens:
        if token.type == tokenize.COMMENT:
            row, column = token.start
            lines[row - 1] = lines[row - 1][:column]
    for node in ast.walk(tree):
        if isinstance(node, (ast.Module, ast.ClassDef, ast.FunctionDef, ast.AsyncFunctionDef)):
            first = node.body[0] if node.body else None
            if isinstance(first, ast.Expr) and isinstance(first.value, ast.Constant):
                assert first.end_lineno is not None
                for row in range(first.lineno, first.end_lineno + 1):
                    lines[row - 1] = ""
    return _hash("\n".join(line.rstrip() for line in lines if line.strip()))


def _hash(text: str) -> str:
    return hashlib.sha256(text.encode()).hexdigest()[:16]


def stored_code() -> dict[Key, str]:
    """Return the hash of the code of each answer that has a recording."""
    path = FOLDER / CODE
    stored = json.loads(path.read_text(encoding="utf-8")) if path.is_file() else {}
    return {(stem, name): code for stem, names in stored.items() for name, code in names.items()}


def keep_code(codes: dict[Key, str]) -> None:
    """Store the hashes."""
    by_stem: dict[str, dict[str, str]] = {}
    for stem, name in sorted(codes):
        by_stem.setdefault(stem, {})[name] = codes[stem, name]
    (FOLDER / CODE).write_text(json.dumps(by_stem, indent=1) + "\n", encoding="utf-8")


def is_wanted() -> bool:
    """Return whether this run stores recordings."""
    return bool(os.environ.get(WANTED))


def path_of(key: Key) -> Path:
    """Return the path of an answer's recording."""
    stem, name = key
    return FOLDER / stem / f"{name.removesuffix('.py').replace('/', '-')}.json.xz"


def key_of(path: Path) -> Key:
    """Return the answer whose recording is in this file."""
    name = path.name.removesuffix(".json.xz")
    kind, _, rest = name.partition("-")
    return path.parent.name, f"{kind}/{rest}.py" if rest else name


def stored() -> list[Path]:
    """Return all stored files."""
    return sorted(FOLDER.glob("*/*.json.xz"))


def load(path: Path) -> tuple[str, Recording]:
    """Return a stored recording, and the hash of the answer that it belongs to."""
    data = _read(path)
    recording = data["recording"]
    said = _script_in(recording)
    if any("value" not in one for one in said):
        for one, value in zip(said, _read(_script_of(path.parent.name, recording)), strict=False):
            one.setdefault("value", value)
    return data["answer"], Recording.from_json(recording)


def store(key: Key, judgement: Judgement) -> None:
    """Store the recording if it gives the same verdicts without the other clock's recording."""
    assert judgement.recording is not None
    path = path_of(key)
    data = _without_paths(_rounded(judgement.recording.to_json()))
    again = judge_recording(load_exercise(key[0], ROOT), judgement.answer_sha256, Recording.from_json(data))
    is_same = _verdicts(again) == _verdicts(judgement)
    if is_same:
        _leave_out_the_script(key[0], data)
        _write(path, {"answer": judgement.answer_sha256, "recording": data})
    if not is_same or path.stat().st_size > LARGEST:
        path.unlink(missing_ok=True)
        with NOT_STORED.open("a", encoding="utf-8") as file:
            print(*key, file=file)


def _script_of(stem: str, recording: dict[str, Any]) -> Path:
    """Return the path of the values that the judge publishes for a recording's seed, in their order."""
    seed = recording.get("seed")
    return FOLDER / stem / ("script.xz" if seed is None else f"script_{seed}.xz")


def _script_in(recording: dict[str, Any]) -> list[dict[str, Any]]:
    """Return what the judge published, and what it would still have published when the watch ended."""
    return [*recording.get("said", []), *recording.get("unsaid", [])]


def _leave_out_the_script(stem: str, recording: dict[str, Any]) -> None:
    """Remove the judge's values from a recording if they match those stored for its seed."""
    said = _script_in(recording)
    path = _script_of(stem, recording)
    kept = _read(path) if path.is_file() else []
    values = [one["value"] for one in said]
    if values[: len(kept)] == kept and len(values) > len(kept):
        _write(path, kept := values)
    for one, value in zip(said, kept, strict=False):
        if one["value"] == value:
            del one["value"]


def _read(path: Path) -> Any:
    return json.loads(lzma.decompress(path.read_bytes()))


def _write(path: Path, data: Any) -> None:
    path.parent.mkdir(parents=True, exist_ok=True)
    text = json.dumps(data, allow_nan=False, separators=(",", ":"))
    path.write_bytes(lzma.compress(text.encode(), preset=9 | lzma.PRESET_EXTREME))


def _verdicts(judgement: Judgement) -> list[tuple[str, str, str | None]]:
    return [(one.id, one.status, one.cause) for one in judgement.criteria]


def _rounded(value: Any) -> Any:
    """Return the recording with rounded times. The programs' messages stay unchanged."""
    if isinstance(value, float):
        return round(value, DIGITS)
    if isinstance(value, list):
        return [_rounded(one) for one in value]
    if isinstance(value, dict):
        return {name: one if name in SAID_BY_PROGRAMS else _rounded(one) for name, one in value.items()}
    return value


def _without_paths(data: Any) -> Any:
    """Return the recording with this machine's paths replaced by those of a student's machine."""
    text = json.dumps(data)
    for mine, theirs in ((str(ROOT), "/home/student/rclpy-workbook"), (sys.base_prefix, "/usr")):
        text = re.sub(rf"(?<![\w/.-]){re.escape(mine)}(?![\w.-])", theirs, text)
    return json.loads(text)


def stale(tests: list[tuple[str, Key]]) -> list[tuple[str, Key]]:
    """Return the tests of answers that have no recording, or only one of older code."""
    from tests.exercises.proofs import answer_of

    codes = stored_code()
    return [
        (test, key)
        for test, key in tests
        if not path_of(key).is_file() or codes.get(key) != hash_of_code(answer_of(key)[0].text)
    ]


def main() -> int:
    """Prove the answers without a current recording, and store their recordings. Return pytest's exit code."""
    from tests.exercises.proofs import answer_of
    from tests.exercises.test_proofs import tests_of_answers

    for path in stored():
        if key_of(path) not in {key for _, key in tests_of_answers()}:
            path.unlink()
    NOT_STORED.parent.mkdir(exist_ok=True)
    NOT_STORED.unlink(missing_ok=True)
    wanted = stale(tests_of_answers())
    if not wanted:
        print("Every answer has its recording.")
        return 0
    listed = NOT_STORED.with_name("proofs_to_record.txt")
    listed.write_text("".join(f"{test}\n" for test, _ in wanted), encoding="utf-8")
    command = [sys.executable, "-m", "pytest", "-q", f"@{listed}", *sys.argv[1:]]
    done = subprocess.run(command, cwd=ROOT, env={**os.environ, WANTED: "1"}, check=False)
    codes = {key: code for key, code in stored_code().items() if path_of(key).is_file()}
    for _, key in wanted:
        answer, _ = answer_of(key)
        if path_of(key).is_file() and load(path_of(key))[0] == answer.sha256:
            codes[key] = hash_of_code(answer.text)
    keep_code(codes)
    return done.returncode


if __name__ == "__main__":
    sys.exit(main())
