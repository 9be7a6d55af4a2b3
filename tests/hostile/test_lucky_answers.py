"""An answer that is right now and then, and crashes at its end so that it is tried again, gets its lowest result."""

from pathlib import Path

import pytest

from workbook.exercise.answers import Answer
from workbook.exercise.definition import load_exercise
from workbook.exercise.judgement import Judgement
from workbook.exercise.judging import Judge
from workbook.feedback.text import as_text
from workbook.grading.retries import until_sure, what_counts
from workbook.watching.observer import Observer

ROOT = Path(__file__).resolve().parents[2]
PERIOD = "BATTERY_PERIOD_S = 2.0"
CRASHES = """\
import os, signal
_shutdown = rclpy.try_shutdown
rclpy.try_shutdown = lambda: os.kill(os.getpid(), signal.SIGSEGV)
"""


@pytest.mark.parametrize("luck", ["wrong, right, wrong", "right, wrong, right"])
def test_a_crash_at_ctrl_c_buys_no_second_chance_for_a_rate(luck: str, tmp_path: Path) -> None:
    exercise = load_exercise("08_humanoid_status_publisher", ROOT)
    solution, marker = exercise.source.solution_code, tmp_path / "luck"
    assert solution.count(PERIOD) == 1
    lucky = f"{PERIOD} if open({str(marker)!r}).read() == 'right' else 0.5"
    answer = Answer(solution.replace(PERIOD, f"{CRASHES}{lucky}"))
    turns, tries = iter(luck.split(", ")), list[Judgement]()
    with Observer() as observer:

        def once() -> Judgement:
            marker.write_text(next(turns))
            tries.append(Judge(observer).judge(exercise, answer))
            return tries[-1]

        counts = until_sure(once, lambda _: None)
    assert all(one.recording is not None and one.recording.process.signal == "SIGSEGV" for one in tries)
    told = "\n".join(map(as_text, tries))
    assert len(tries) == 3, told
    assert counts.score == min(one.score or 0.0 for one in tries) < max(one.score or 0.0 for one in tries)
    assert "the lowest" in what_counts(tries).why, told
