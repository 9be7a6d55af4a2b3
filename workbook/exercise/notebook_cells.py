"""Reads the answer cells of a notebook, which may be made to fill the memory of whoever reads it.

A large one is read by a process of its own with little memory and time, which this file is the program of: it imports
the standard library only.

    python -I -S notebook_cells.py STEM < notebook.ipynb

prints `{"named": [stems], "text": the last answer to STEM, or null}`, or `{"problem": sentence}`.
"""

import json
import re
import resource
import signal
import subprocess
import sys
from pathlib import Path
from typing import Any

SMALL_BYTES = 1_000_000
"""Notebooks up to this size are read without a process of their own: that takes some 50 ms and 60 MB at most."""
LARGEST_NOTEBOOK_BYTES = 50_000_000
"""With the outputs of pictures in it, a notebook may well have some megabytes."""
MEMORY_BYTES = 500_000_000
CPU_S = 5
PATIENCE_S = 120.0
MOST_PARTS = 2_000_000
"""Objects and lists in a notebook's JSON. A file of brackets alone would take thirty times its size in memory."""
LONGEST_TEXT = 1_000_001
"""Characters that are kept of an answer: one more than may be handed in, so that it is refused."""
MOST_NAMES = 50
"""Exercises that are told of one notebook."""
_ADVICE = "Clear its outputs and save it again"
TOO_MUCH_MEMORY = f"reading the notebook takes more than {MEMORY_BYTES // 1_000_000} MB of memory. {_ADVICE}"
TOO_MUCH_TIME = f"reading the notebook takes more than {CPU_S} s of processor time. {_ADVICE}"
_MAGIC_LINE = re.compile(r"^%%answer\s+(?P<name>\w[\w-]{0,99})(?:\s+--check)?\s*$")


def named_exercise(line: str) -> str | None:
    """The exercise that a `%%answer` line names, as it is written there, or None for any other line."""
    found = _MAGIC_LINE.match(line.strip())
    return found["name"] if found else None


def means(name: str, stem: str) -> bool:
    """Whether a `%%answer` line that says `name` is about `stem`: 09_joint_positions, joint_positions, 09 or 9."""
    number, _, slug = stem.partition("_")
    return name in (stem, slug, number, number.lstrip("0") or "0")


def answer_cells(path: Path, stem: str = "") -> dict[str, Any]:
    """What this program prints for the notebook `path`. Raises OSError."""
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
    """What this program prints for the bytes of a notebook."""
    if raw.count(b"{") + raw.count(b"[") > MOST_PARTS:
        return {"problem": "this is not a notebook: it consists of millions of empty parts"}
    try:
        cells = json.loads(raw)["cells"]
        texts = [_text_of(cell) for cell in cells if cell.get("cell_type") == "code"]
    except (ValueError, KeyError, TypeError, AttributeError, RecursionError) as error:
        return {"problem": f"this is not a readable notebook: {repr(error)[:200]}"}
    answer: str | None = None
    named: dict[str, None] = {}
    for text in texts:
        first, _, rest = text.partition("\n")
        name = named_exercise(first[:1000])
        if name is not None and means(name, stem):
            answer = rest[:LONGEST_TEXT]
        if name is not None and len(named) < MOST_NAMES:
            named[name] = None
    return {"named": list(named), "text": answer}


def _text_of(cell: Any) -> str:
    source = cell.get("source")
    if isinstance(source, list):
        source = "".join(part for part in source if isinstance(part, str))
    return source.lstrip("\n \t") if isinstance(source, str) else ""


def main(stem: str) -> None:
    """Bound this process, then read the notebook from standard input."""
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
