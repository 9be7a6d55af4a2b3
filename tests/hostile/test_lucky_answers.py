"""Answers that are right only sometimes, and that force repeated tries, get their lowest result.

One crashes at its end, as if by a bug in rclpy. Others wait for a CPU, as on a busy machine: they keep all CPUs busy
themselves, or yield to all other processes.
"""

import subprocess
import sys
from pathlib import Path

import pytest

from workbook.exercise.answers import Answer
from workbook.exercise.definition import load_exercise
from workbook.exercise.judgement import Judgement
from workbook.exercise.judging import Judge
from workbook.exercise.retries import until_sure, what_counts
from workbook.feedback.text import as_text
from workbook.watching.observer import Observer
from workbook.watching.wall_time import OwnLoad

pytestmark = [pytest.mark.slow, pytest.mark.whole]

ROOT = Path(__file__).resolve().parents[2]
PERIOD = "BATTERY_PERIOD_S = 2.0"
CRASHES = """\
import os, signal
_shutdown = rclpy.try_shutdown
rclpy.try_shutdown = lambda: os.kill(os.getpid(), signal.SIGSEGV)
"""
STARVES_ITSELF = """\
import os, time

BUSY_S = 25.0
for _ in range(3 * len(os.sched_getaffinity(0))):
    if os.fork() == 0:
        until = time.monotonic() + BUSY_S
        while time.monotonic() < until:
            pass
        os._exit(0)
"""
SPIN = "        rclpy.spin(HumanoidStatusPublisher())\n"
POLLS = """\
        node = HumanoidStatusPublisher()
        while rclpy.ok():
            rclpy.spin_once(node, timeout_sec=0.0)
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


def test_a_program_that_keeps_the_processors_busy_itself_casts_no_doubt_on_its_rate() -> None:
    """It has no parameter services, so it is judged on the wall clock. Its main thread waits for a CPU."""
    exercise = load_exercise("09_joint_positions", ROOT)
    text = exercise.source.solution_code
    for old, new in (
        (SPIN, POLLS),
        ("STATUS_PERIOD_S = 1.0", "STATUS_PERIOD_S = 3.0"),
        (
            'super().__init__("humanoid_status_publisher"',
            'super().__init__("humanoid_status_publisher", start_parameter_services=False',
        ),
    ):
        assert text.count(old) == 1
        text = text.replace(old, new)
    with Observer() as observer:
        judgement = Judge(observer).judge(exercise, Answer(STARVES_ITSELF + text))
    recording = judgement.recording
    assert recording is not None and recording.clock == "wall"
    assert {one.id for one in judgement.criteria if one.status in ("failed", "partial")} == {"status_kept"}, (
        as_text(judgement)
    )
    assert judgement.inconclusive_reason == "", judgement.inconclusive_reason
    assert recording.in_line_s == 0.0


@pytest.mark.parametrize(
    ("steps_back", "is_to_blame"),
    [
        ("", False),
        ("os.nice(5)", True),
        ("os.sched_setscheduler(0, os.SCHED_IDLE, os.sched_param(0))", True),
    ],
)
def test_who_lets_everyone_else_go_first_waits_by_its_own_doing(steps_back: str, is_to_blame: bool) -> None:
    program = f"import os; {steps_back}\nprint('ready', flush=True); input()"
    with subprocess.Popen(
        [sys.executable, "-c", program], stdin=subprocess.PIPE, stdout=subprocess.PIPE
    ) as process:
        assert process.stdout is not None and process.stdin is not None
        process.stdout.readline()
        load = OwnLoad(process.pid)
        load.note()
        process.stdin.write(b"\n")
        process.stdin.close()
    assert load.is_to_blame() is is_to_blame
