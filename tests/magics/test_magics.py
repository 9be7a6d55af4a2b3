"""The magics as a student uses them, in a real kernel."""

import os
from pathlib import Path

import pytest

from tests.magics.conftest import Kernel
from tests.programs.support import is_gone, wait_until
from workbook.exercise.definition import load_exercise
from workbook.inside.proc import process_tree
from workbook.lesson.progress import TRIES_BEFORE_SOLUTION
from workbook.magics.screen import STARTED_PAYLOAD

ROOT = Path(__file__).resolve().parents[2]
STEM = "09_joint_positions"
SOURCE = load_exercise(STEM, ROOT).source
LIVES_ON = "Full marks: 10 of 10 points."


def answer(kernel: Kernel, text: str) -> str:
    return kernel.good(f"%%answer {STEM}\n{text}").text


def alone(kernel: Kernel) -> set[int]:
    """Return the processes below the kernel."""
    return set(process_tree(kernel.pid)) - {kernel.pid}


def slow_answer(marks: Path) -> str:
    return f"""\
import os, subprocess, sys, time
child = subprocess.Popen([sys.executable, "-c", "import time; time.sleep(600)"])
with open({str(marks)!r} + ".part", "w") as file:
    print(os.getpid(), child.pid, file=file)
os.rename({str(marks)!r} + ".part", {str(marks)!r})
time.sleep(600)
"""


def test_without_an_exercise_the_magics_ask_which(fresh_kernel: Kernel) -> None:
    for magic in ("%check", "%start", "%hint", "%review", "%solution", "%reset"):
        assert "Which exercise?" in fresh_kernel.good(magic).text
    assert "Name the exercise" in fresh_kernel.good("%%answer\nx = 1").text
    assert "77_levitation" in fresh_kernel.good("%check 77_levitation").text
    assert fresh_kernel.good("%stop").text == "Nothing was running.\n"
    assert "There is no answers/09_joint_positions.py yet" in fresh_kernel.good(f"%check {STEM}").text
    assert "There is no answers/09_joint_positions.py yet" in fresh_kernel.good("%start joint_positions").text


def test_a_call_is_never_a_magic(fresh_kernel: Kernel) -> None:
    """After a restart, the kernel doesn't have the lesson's functions yet."""
    for cell in ("stop()", "start(program)", "check ()"):
        error = fresh_kernel.run(cell).error
        assert error is not None and "NameError" in error
    assert fresh_kernel.good("stop").text == "Nothing was running.\n"


def test_a_review_judges_what_is_not_judged_yet_and_judges_nothing_twice(kernel: Kernel) -> None:
    answer(kernel, "speed = = 3\n")
    card, prompt = kernel.good(f"%review {STEM}").displays
    assert card.startswith("0 of 10 points.")
    assert "do not write the program" in prompt and "speed = = 3" in prompt
    assert kernel.good("%review").displays == [prompt]
    answer(kernel, "speed = = 4\n")
    kernel.good("%check")
    [prompt] = kernel.good("%review").displays
    assert "speed = = 4" in prompt


def test_a_check_in_a_new_session_and_another_at_once(fresh_kernel: Kernel) -> None:
    """The answer was saved yesterday, and no %%answer cell has run in this kernel."""
    (fresh_kernel.folder / "answers" / f"{STEM}.py").write_text("speed = = 3\n")
    for _ in range(3):
        assert fresh_kernel.good(f"%check {STEM}").displays[0].startswith("0 of 10 points.")
    below = alone(fresh_kernel)
    assert below
    fresh_kernel.shut_down()
    wait_until(lambda: all(map(is_gone, below)))


def test_from_the_starter_to_full_marks(kernel: Kernel) -> None:
    assert answer(kernel, SOURCE.starter_code) == "Saved as answers/09_joint_positions.py.\n"
    [starter] = kernel.good("%check").displays
    assert starter.startswith("3 of 10 points. Start with this criterion: /robot/joint_positions")
    assert answer(kernel, SOURCE.solution_code) == "Saved as answers/09_joint_positions.py.\n"
    first = kernel.good("%check")
    assert first.displays[0] == LIVES_ON
    assert "answers/09_joint_positions.py" in first.html[0].replace("<wbr>", "")
    assert kernel.good("%check").displays[0] == LIVES_ON, "the first check still lives on in the background"
    assert answer(kernel, SOURCE.solution_code) == "answers/09_joint_positions.py is unchanged.\n"
    said = answer(kernel, SOURCE.starter_code)
    assert said.startswith("Your answer stays in answers/09_joint_positions.py")
    assert (kernel.folder / "answers" / f"{STEM}.py").read_text() == SOURCE.solution_code
    assert SOURCE.solution_code.strip() in kernel.good("%solution").displays[0]


def test_a_reset_keeps_the_work(kernel: Kernel) -> None:
    answer(kernel, "robot = 1")
    said = kernel.good("%reset").text
    assert "answers/09_joint_positions.py contains the starter again." in said
    assert "Your answer is kept as answers/.previous/" in said
    assert (kernel.folder / "answers" / f"{STEM}.py").read_text() == SOURCE.starter_code
    [previous] = (kernel.folder / "answers" / ".previous").iterdir()
    assert previous.read_text() == "robot = 1\n"


def test_a_syntax_error_is_shown_at_once(kernel: Kernel) -> None:
    said = answer(kernel, "import rclpy\nspeed = = 3\n")
    assert "Saved as" in said
    assert "line 2 of the answer" in said
    assert "    speed = = 3\n            ^" in said
    assert "line 2: speed = = 3" in kernel.good("%start").text
    [card] = kernel.good("%check").displays
    assert card.startswith("0 of 10 points.")


def test_a_program_that_waits_for_a_clock_is_told_so_when_it_starts(kernel: Kernel) -> None:
    name = 'super().__init__("humanoid_status_publisher"'
    assert SOURCE.solution_code.count(name) == 1
    own = ", parameter_overrides=[rclpy.parameter.Parameter('use_sim_time', value=True)]"
    answer(kernel, SOURCE.solution_code.replace(name, name + own))
    try:
        said = kernel.good("%start").text
    finally:
        kernel.good("%stop")
    assert "waits for /clock, which nothing publishes" in said
    answer(kernel, SOURCE.solution_code)


def test_a_program_runs_beside_the_notebook(kernel: Kernel) -> None:
    answer(kernel, SOURCE.solution_code)
    before = alone(kernel)
    started = kernel.good("%start")
    assert "node /humanoid_status_publisher is in the graph" in started.text
    assert started.displays == ["Picture: a humanoid robot with twelve joints"]
    assert started.payloads == [{"source": STARTED_PAYLOAD}]
    [program] = alone(kernel) - before
    assert "Running: node /humanoid_status_publisher" in kernel.good("%start").text, (
        "a second start replaces it"
    )
    wait_until(lambda: is_gone(program))
    assert len(alone(kernel) - before) == 1
    assert kernel.good("%stop").text == f"Stopped {STEM}.\n"
    assert alone(kernel) == before
    assert kernel.good("%stop").text == "Nothing was running.\n"


def test_a_program_that_ends_at_once_says_why(kernel: Kernel) -> None:
    answer(kernel, "import rclpy\nrclpy.init()\nraise ValueError('joint 7 is loose')\n")
    shown = kernel.good("%start")
    assert "Your program ended with line 3: ValueError: joint 7 is loose" in shown.text
    assert (shown.displays, shown.payloads) == ([], []), "a robot without a program"
    answer(kernel, "print('done')\n")
    said = kernel.good("%start").text
    assert "ended right away (exit code 0). Does it spin?" in said
    assert "done" in said


def test_hints_come_one_by_one_and_the_earlier_ones_stay(kernel: Kernel) -> None:
    answer(kernel, SOURCE.starter_code)
    told = [f"**Hint {number} of 3.**\n\n{hint}" for number, hint in enumerate(SOURCE.hints, start=1)]
    for number in range(1, 4):
        assert kernel.good("%hint").displays == ["\n\n".join(told[:number])]
    assert kernel.good("%hint").displays == ["\n\n".join([*told, "There are no more hints."])]
    assert kernel.good(f"%hint {STEM} 1").displays == told[:1]
    assert "There are 3 hints" in kernel.good("%hint 4").text


def test_the_solution_waits_for_honest_tries(kernel: Kernel) -> None:
    answer(kernel, "speed = = 3\n")
    for left in range(TRIES_BEFORE_SOLUTION, 0, -1):
        assert f"after {left} more {'try' if left == 1 else 'tries'}" in kernel.good("%solution").text
        kernel.good("%check")
    assert SOURCE.solution_code.strip() in kernel.good("%solution").displays[0]


def test_an_interrupted_check_leaves_nothing_behind(kernel: Kernel, tmp_path: Path) -> None:
    answer(kernel, slow_answer(tmp_path / "marks"))
    request = kernel.start("%check")
    wait_until((tmp_path / "marks").exists)
    pids = [int(word) for word in (tmp_path / "marks").read_text().split()]
    kernel.manager.interrupt_kernel()
    stopped = kernel.finish(request)
    assert stopped.text == "Check stopped.\n"
    assert not stopped.displays
    wait_until(lambda: all(map(is_gone, pids)))
    wait_until(lambda: not alone(kernel))
    answer(kernel, "speed = = 3\n")
    assert kernel.good("%check").displays[0].startswith("0 of 10 points.")


@pytest.mark.parametrize("hard", [False, True], ids=["shut down", "killed"])
def test_the_end_of_the_kernel_ends_everything(fresh_kernel: Kernel, tmp_path: Path, hard: bool) -> None:
    """The kernel ends while a check and a program are running."""
    answer(fresh_kernel, SOURCE.solution_code)
    fresh_kernel.good("%start")
    fresh_kernel.good("%check")
    below = alone(fresh_kernel)
    assert len(below) >= 2
    if hard:
        os.kill(fresh_kernel.pid, 9)
    else:
        fresh_kernel.shut_down()
    wait_until(lambda: all(map(is_gone, below)))
