"""Read a notebook's answer cells safely, even if the notebook is crafted to exhaust memory.

A large notebook is read in a separate process with limited memory and time. That process runs this file, which
therefore imports only the standard library.

    python -I -S notebook_cells.py STEM < notebook.ipynb

prints `{"named": [stems], "text": the last answer to STEM, or null}`, or `{"problem": sentence}`. `"after"` is the
number of the code cell right after the answer, if that cell's code may be part of the answer.
"""

import json
import re
import resource
import signal
import subprocess
import sys
from difflib import SequenceMatcher
from pathlib import Path
from typing import Any

SMALL_BYTES = 1_000_000
"""Notebooks up to this size are read without a separate process, which takes at most about 50 ms and 60 MB."""
LARGEST_NOTEBOOK_BYTES = 50_000_000
"""Far more than a real notebook has: figures in its outputs can make it several megabytes large."""
MEMORY_BYTES = 500_000_000
CPU_S = 5
PATIENCE_S = 120.0
MOST_PARTS = 2_000_000
"""The most objects and lists in a notebook's JSON.

Reading a file that consists only of brackets takes thirty times its size in memory.
"""
LONGEST_TEXT = 1_000_001
"""The number of characters kept from an answer: one more than the limit, so that a longer answer is still refused."""
MOST_NAMES = 50
"""The most exercises that are reported for one notebook."""
MOST_NEAR, MOST_LINES, ALIKE = 3, 2_000, 0.7
"""The most cells reported as near misses, the lines searched in each, and the minimum similarity to `answer`."""
_NEAR_LINE = re.compile(
    r"""^\s*(?P<comment>[#>"'`\s]*)(?P<percent>[%\uff05\u066a!]*)\s*(?P<word>[^\W\d_]{4,10})(?=\W|\d|$)"""
)
_CODE = re.compile(
    r"^\s*(?:class|def|async|@|import|from|if|for|while|with|try|rclpy\.|self\.)", re.MULTILINE
)
_ADVICE = "Clear its outputs and save it again"
TOO_MUCH_MEMORY = f"reading the notebook takes more than {MEMORY_BYTES // 1_000_000} MB of memory. {_ADVICE}"
TOO_MUCH_TIME = f"reading the notebook takes more than {CPU_S} s of processor time. {_ADVICE}"
_MAGIC_LINE = re.compile(r"^%%answer\s+(?P<name>\w[\w-]{0,99})(?:\s+--check)?\s*$")


def named_exercise(line: str) -> str | None:
    """Return the exercise that a `%%answer` line names, exactly as written, or None for any other line."""
    found = _MAGIC_LINE.match(line.strip())
    return found["name"] if found else None


def means(name: str, stem: str) -> bool:
    """Return whether the name in a `%%answer` line refers to `stem`.

    The name may be 09_joint_positions, joint_positions, 09, or 9.
    """
    number, _, slug = stem.partition("_")
    return name in (stem, slug, number, number.lstrip("0") or "0")


def answer_cells(path: Path, stem: str = "") -> dict[str, Any]:
    """Return this program's output for the notebook at `path`. Raises OSError if the file is unreadable."""
    with path.open("rb") as file:
        if path.stat().st_size <= SMALL_BYTES:
            return cells_of(file.read(SMALL_BYTES), stem)
        command = [sys.executable, "-I", "-S", __file__, stem]
        try:
            done = subprocess.run(command, stdin=file, capture_output=True, timeout=PATIENCE_S)
        except subprocess.TimeoutExpired:
            return {"problem": TOO_MUCH_TIME}
    if done.returncode in (-signal.SIGXCPU, -signal.SIGKILL):
        return {"problem": TOO_MUCH_TIME}
    if done.returncode != 0:
        return {"problem": f"{TOO_MUCH_MEMORY} (the reader ended with code {done.returncode})"}
    found: dict[str, Any] = json.loads(done.stdout)
    return found


def cells_of(raw: bytes, stem: str) -> dict[str, Any]:
    """Return this program's output for a notebook's bytes."""
    if raw.count(b"{") + raw.count(b"[") > MOST_PARTS:
        return {"problem": "this is not a notebook: it consists of millions of empty parts"}
    try:
        notebook = json.loads(raw)
    except (ValueError, RecursionError):
        return {"problem": f"this is not a readable notebook: {_why_no_json(raw)}"}
    problem = _why_no_notebook(notebook)
    if problem is not None:
        return {"problem": f"this is not a readable notebook: {problem}"}
    answer: str | None = None
    answers: list[int] = []
    near: list[str] = []
    named: dict[str, None] = {}
    after: int | None = None
    is_next = False
    for number, cell in enumerate(notebook["cells"], start=1):
        text, kind = _text_of(cell), str(cell.get("cell_type"))
        first, _, rest = text.partition("\n")
        name = named_exercise(first[:1000]) if kind == "code" else None
        if name is None and len(near) < MOST_NEAR:
            near += [f"cell {number} {miss}" for miss in [_near_miss(text, kind)] if miss]
        if is_next and kind == "code" and text.strip():
            is_next, after = False, number if _looks_like_code(text) and name is None else None
        if name is not None and means(name, stem):
            answer = rest[:LONGEST_TEXT]
            answers.append(number)
            is_next, after = True, None
        if name is not None and len(named) < MOST_NAMES:
            named[name] = None
    return {
        "named": list(named),
        "text": answer,
        "answers": answers[-MOST_NAMES:],
        "near": near,
        "after": after,
    }


def _looks_like_code(text: str) -> bool:
    """Return whether a cell may be part of a program: it isn't a magic, and it does more than display a value."""
    return not text.lstrip().startswith(("%", "!")) and bool(_CODE.search(text[:LONGEST_TEXT]))


def _why_no_json(raw: bytes) -> str:
    """Return the problem with a file that should be a notebook but isn't JSON."""
    start = raw.lstrip(b"\xef\xbb\xbf \t\r\n")[:200]
    conflict = next((n for n, line in enumerate(raw.split(b"\n"), 1) if line.startswith(b"<<<<<<< ")), None)
    if not start:
        return "the file is empty"
    if conflict is not None:
        return f"Git left a conflict in line {conflict}. Choose one version, and save it again"
    if not start.startswith((b"{", b"[")):
        return "it contains something other than a notebook. Open it in JupyterLab, or hand in the right file"
    try:
        raw.decode()
    except UnicodeDecodeError:
        return "its text is not UTF-8. Open it in JupyterLab and save it again"
    return "the file is cut off or damaged. Save it again in JupyterLab, and hand it in again"


def _why_no_notebook(found: Any) -> str | None:
    """Return the problem with JSON that should be a notebook, or None if there is none."""
    if not isinstance(found, dict):
        return "the file contains other data, not a notebook"
    if "worksheets" in found:
        return "its format is from 2014 or older (nbformat 3). Open it in JupyterLab and save it again"
    cells = found.get("cells")
    if not isinstance(cells, list):
        return "the file has no list of cells"
    broken = next((n for n, cell in enumerate(cells, 1) if not isinstance(cell, dict)), None)
    return None if broken is None else f"cell {broken} is damaged. Save the notebook again in JupyterLab"


def _near_miss(text: str, kind: str) -> str | None:
    """Describe the first line in a cell that resembles a `%%answer` line, or None if there is no such line."""
    for place, line in enumerate(text[:LONGEST_TEXT].split("\n")[:MOST_LINES], start=1):
        found = _NEAR_LINE.match(line[:200])
        word = found["word"].casefold() if found else ""
        marked = found is not None and (found["percent"] or found["comment"])
        if not marked or SequenceMatcher(None, word, "answer").ratio() < ALIKE:
            continue
        shown = " ".join(line.split())[:60].replace("`", "'")
        if kind != "code":
            return f"begins with `{shown}`, but it is a {kind} cell, not a code cell"
        if place > 1 and named_exercise(line):
            return f"has `{shown}` in line {place}, not in its first line"
        return f"has the line `{shown}`"
    return None


def _text_of(cell: Any) -> str:
    source = cell.get("source")
    if isinstance(source, list):
        source = "".join(part for part in source if isinstance(part, str))
    return source.lstrip("\n \t") if isinstance(source, str) else ""


def main(stem: str) -> None:
    """Limit this process's resources, and then read the notebook from standard input."""
    resource.setrlimit(resource.RLIMIT_CORE, (0, 0))
    resource.setrlimit(resource.RLIMIT_CPU, (CPU_S, CPU_S + 1))
    resource.setrlimit(resource.RLIMIT_AS, (MEMORY_BYTES, MEMORY_BYTES))
    try:
        found = cells_of(sys.stdin.buffer.read(LARGEST_NOTEBOOK_BYTES), stem)
    except MemoryError:
        found = {"problem": TOO_MUCH_MEMORY}
    print(json.dumps(found))


if __name__ == "__main__":
    main(sys.argv[1])
