"""Who goes first on a busy machine, and that whatever they start goes as they do."""

import json
import subprocess
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
PROGRAM = """
import json, os, subprocess, sys
from tests.priority import at_full_priority, give_way
def child():
    done = subprocess.run([sys.executable, "-c", "import os; print(os.nice(0))"], capture_output=True, text=True)
    return int(done.stdout)
before = os.nice(0)
give_way()
print(json.dumps([before, child(), at_full_priority(child)]))
"""


def test_what_a_worker_starts_gives_way_and_what_goes_first_does_not() -> None:
    done = subprocess.run(
        [sys.executable, "-c", PROGRAM], cwd=ROOT, capture_output=True, text=True, check=False
    )
    assert done.returncode == 0, done.stderr
    before, of_worker, goes_first = json.loads(done.stdout)
    assert goes_first == before
    assert of_worker == min(19, before + 10)
